"""Command: `rotsolve check`: mark the answers of one student or of a class, show what came out, and work out the exit code."""

from __future__ import annotations

import sys

from rotsolve.core.faults import SceneError
from rotsolve.grading.course.judges import Judges
from rotsolve.grading.course.request import BAD, Request
from rotsolve.render.layout import release
from rotsolve.render.voice import TEXT
from rotsolve.run.attempt import failure, name_of, piped, source
from rotsolve.run.scenes import PIPED

__all__ = ["Request", "run"]


def run(request: Request) -> int:
    """Mark what is handed in, and write what was asked for."""
    if request.problem == request.answers == PIPED:
        return refuse("error: either the problem or the answers can come from standard input")
    try:
        scene = source(request.problem, piped((request.problem,)))
        judges = Judges(scene, request.seed, request.variants)
    except Exception as error:
        return refuse(failure(request.problem, error).message)
    for found in judges.solution.checks:
        if found.holds is False:
            said = release(TEXT.words(found.words))
            return refuse(f"error: the answers of {name_of(request.problem)} do not hold: {said}")
    try:
        if request.of_class:
            from rotsolve.grading.course.many import check

            return check(request, judges)
        from rotsolve.grading.course.single import check as check_one

        return check_one(request, judges)
    except SceneError as error:
        return refuse(error.render())
    except OSError as error:
        return refuse(f"error: cannot write {request.output or name_of('')}: {error.strerror or error}")


def refuse(message: str) -> int:
    print(message, file=sys.stderr)
    return BAD
