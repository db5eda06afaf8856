"""Complete: a problem in space made ready for the laws: letters for what the scene leaves out, and what can't be, refused."""

from __future__ import annotations

from msgspec.structs import replace

from rotsolve.core.faults import Fault, SceneError, Unsolvable
from rotsolve.language.problem import Problem
from rotsolve.motion.admissible import check_sequence
from rotsolve.motion.complete import MadeLetters, complete_body
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.limits import body_limits, seen_to_fit
from rotsolve.space.arrangement import JointedBodies


def configured_in_space(problem: Problem) -> Configuration:
    """The problem with letters for masses and sizes that it leaves out; its joints are checked."""
    try:
        letters = MadeLetters(problem)
        bodies = tuple(complete_body(body, letters) for body in problem.bodies)
        whole = replace(problem, bodies=bodies, givens=(*problem.givens, *letters.made))
        configuration = Configuration(whole)
        held = JointedBodies(whole, configuration.signs)
        _ = held.order
        check_sequence(whole)
        refuse_unseen_holes(whole)
    except Unsolvable as error:
        fault = error.fault
        raise Unsolvable(
            fault.message, span=fault.span, help=fault.help, lines=problem.lines, file=problem.file
        ) from None
    faults = [
        Fault(limit.words, body.span, limit.help, "limits")
        for body in whole.bodies
        for limit in body_limits(body)
        if configuration.signs.by_numbers(limit.gap) == -1
    ]
    if faults:
        raise SceneError(faults[:1], problem.lines, problem.file)
    return configuration


def refuse_unseen_holes(problem: Problem) -> None:
    """Refuse a hole of which nothing tells that it lies within its body: it would take away mass that is not there."""
    for body in problem.bodies:
        for whole in (body, *(part.body for part in body.parts)):
            for hole in whole.holes:
                if not seen_to_fit(hole, whole.shape):
                    message = f"whether the hole `{hole.body.name}` lies within `{whole.name}` is not solved in space"
                    help = "solved are cylinders in boxes, holes along z in cylinders, and balls in balls"
                    raise Unsolvable(message, span=body.span, help=help)
