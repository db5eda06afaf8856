"""Attempt: solve one file and make its page; whatever goes wrong becomes a message."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING

from rotsolve.profile import stage
from rotsolve.render.options import Options
from rotsolve.run.request import BAD, SOLVED, UNSOLVED, Outcome, Request
from rotsolve.run.scenes import PIPED

if TYPE_CHECKING:
    from rotsolve.render.layout import Line
    from rotsolve.solution import Solution


def attempt(file: str, request: Request, text: bytes = b"") -> Outcome:
    """Solve one file, or the text that was piped in."""
    from rotsolve.pipeline import solve

    if os.path.isdir(file):
        return Outcome(file, BAD, None, f"error: there is no scene (*.yaml) in {file}", "file")
    try:
        scene = source(file, text)
        solution = solve(scene, law=request.law, settings=request.settings, digits=request.digits, at=request.at)
        objects = any(check.holds is False for check in solution.derivation.checks)
        with stage("render", whole=True):
            return Outcome(file, UNSOLVED if objects else SOLVED, page(solution, request))
    except Exception as error:
        return failure(file, error)


def source(file: str, text: bytes) -> str | os.PathLike[str]:
    """The path of a scene, or the text that was piped in: a string with a line break is a text, one without is a path."""
    if file == PIPED:
        return text.decode("utf-8") + "\n"
    if "\n" not in file:
        return file
    from pathlib import Path

    return Path(file)


def failure(file: str, error: Exception) -> Outcome:
    """What is said of a file that something kept from its answer, with the exit code and the kind of fault."""
    from rotsolve.core.faults import SceneError, Unsolvable

    name = name_of(file)
    match error:
        case SceneError():
            code, kind = (UNSOLVED, "not yet") if error.not_yet else (BAD, "scene")
            return Outcome(file, code, None, error.render(), kind)
        case Unsolvable():
            return Outcome(file, UNSOLVED, None, error.render(), "unsolvable")
        case UnicodeDecodeError():
            return Outcome(file, BAD, None, f"error: {name} is not UTF-8 text", "file")
        case OSError():
            return Outcome(file, BAD, None, f"error: cannot read {name}: {error.strerror or error}", "file")
    return Outcome(file, UNSOLVED, None, internal_error(name, error), "internal")


def page(solution: Solution, request: Request) -> str | tuple[Line, ...]:
    """The derivation, or the earlier stage that was asked for."""
    if request.show is not None:
        texts = {"facts": solution.facts_text, "equations": solution.equations_text, "plan": solution.plan_text}
        return texts[request.show]().rstrip("\n") + "\n"
    if request.coloured:
        from rotsolve.render.text import lines

        return tuple(lines(solution.derivation, Options(solution.digits, request.width)))
    return solution.body(request.format, width=request.width)


def piped(files: tuple[str, ...]) -> bytes:
    """What is on standard input, where one of the files is `-`."""
    return sys.stdin.buffer.read() if PIPED in files else b""


def name_of(file: str) -> str:
    return "standard input" if file == PIPED else file


def internal_error(where: str, error: Exception) -> str:
    """One line that asks for a report; the traceback with it where ROTSOLVE_DEBUG is set."""
    cause = " ".join(f"{type(error).__name__}: {error}".split())
    line = f"internal error in {where}: {cause[:300]} (please report it with the scene; ROTSOLVE_DEBUG=1 shows more)"
    if os.environ.get("ROTSOLVE_DEBUG", "") in ("", "0"):
        return line
    import traceback

    return "".join(traceback.format_exception(error)) + line
