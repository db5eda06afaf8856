"""Complete: a problem in space made ready for the laws: letters for what the scene leaves out, and what can't be, refused."""

from __future__ import annotations

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, multiply
from rotsolve.core.facts import square
from rotsolve.core.faults import Fault, SceneError, Unsolvable
from rotsolve.core.vectors.tensor import InertiaTensor
from rotsolve.elements.shapes import shape_of
from rotsolve.language.problem import Body, Problem
from rotsolve.motion.admissible import check_sequence
from rotsolve.motion.complete import MadeLetters, complete_body
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.limits import body_limits, seen_to_fit
from rotsolve.space.arrangement import JointedBodies


def configured_in_space(problem: Problem) -> Configuration:
    """The problem with letters for masses and sizes that it leaves out; its joints are checked."""
    try:
        letters = MadeLetters(problem)
        bodies = tuple(complete_body(ball_alike(body, letters), letters) for body in problem.bodies)
        whole = replace(problem, bodies=bodies, givens=(*problem.givens, *letters.made))
        configuration = Configuration(whole)
        held = JointedBodies(whole, configuration.signs)
        _ = held.order
        held.refuse_led_twice()
        check_sequence(whole)
        refuse_rope(whole)
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


def ball_alike(body: Body, letters: MadeLetters) -> Body:
    """A ball of which the scene tells the moment of inertia about one axis: it is the same about all."""
    told = body.inertia is not None or body.gyration is not None
    if not told or body.shape is None or not body.shape.spherical or body.inertia_about not in (None, "cm", "center"):
        return body
    mass = letters.make("m", body.name, "mass") if body.mass is None else body.mass
    moment = body.inertia if body.inertia is not None else multiply(mass, square(body.gyration or ZERO))
    return replace(body, mass=mass, inertia=None, gyration=None, tensor=InertiaTensor(moment, moment, moment))


def refuse_rope(problem: Problem) -> None:
    """Refuse what is not rigid, of which nothing tells how it lies in space."""
    for body in problem.bodies:
        if not shape_of(body).rigid:
            raise Unsolvable(f"`{body.name}` is a {shape_of(body).word}, which is not solved in space", span=body.span)


def refuse_unseen_holes(problem: Problem) -> None:
    """Refuse a hole of which nothing tells that it lies within its body: it would take away mass that is not there."""
    for body in problem.bodies:
        for whole in (body, *(part.body for part in body.parts)):
            for hole in whole.holes:
                if not seen_to_fit(hole, whole.shape):
                    message = f"whether the hole `{hole.body.name}` lies within `{whole.name}` is not solved in space"
                    help = "solved are cylinders in boxes, holes along z in cylinders, and balls in balls"
                    raise Unsolvable(message, span=body.span, help=help)
