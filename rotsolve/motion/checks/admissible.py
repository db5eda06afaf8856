"""Admissible: what connections and actions ask of the bodies that they name; what breaks it is refused by name."""

from __future__ import annotations

from collections.abc import Mapping

from rotsolve.core.faults import Unsolvable
from rotsolve.elements.actions import Action, Press
from rotsolve.elements.connections import Connection, Contact, Rides
from rotsolve.elements.connections.contacts.rolling import Unrolls
from rotsolve.elements.connections.contacts.touch import Touch
from rotsolve.elements.connections.ropes.drapes import Drapes
from rotsolve.elements.connections.springs import Spring
from rotsolve.elements.rims import rim_radius, shape_of
from rotsolve.elements.shapes import Particle
from rotsolve.elements.surfaces import Curved, Wall
from rotsolve.language.problem import Body, PointRef, Problem
from rotsolve.motion.checks.pairs import check_pairs, check_stacks


def check(problem: Problem) -> None:
    """Raises Unsolvable at the place of the first name that can't be meant so."""
    bodies = {body.name: body for body in problem.bodies}
    held = {ref.owner: item.name for item in problem.connections for ref in item.fixed_points()}
    check_pairs(problem, bodies)
    check_points(problem, bodies)
    check_ropes(problem, bodies)
    check_stacks(problem, bodies)
    for item in problem.connections:
        if isinstance(item, (Rides, Unrolls, Touch)):
            check_kind(item, problem, bodies, held)
        elif isinstance(item, Spring) and item.placed:
            check_spring(item, held)
        elif item.between():
            check_one_axis(item.between(), item.word, held)
    for action in problem.actions:
        if isinstance(action, Press) and action.on is not None:
            check_wheel(action.on, "a brake block is solved for a wheel on a fixed axle only", bodies, held)


def check_kind(
    item: Rides | Unrolls | Touch, problem: Problem, bodies: Mapping[str, Body], held: Mapping[str, str]
) -> None:
    """What rides, unrolls or lies on something."""
    if isinstance(item, Rides):
        check_ride(item, bodies, held)
        check_free(item, problem)
    elif isinstance(item, Unrolls):
        check_roll(item, problem, bodies)
    else:
        check_touch(item, problem, bodies, held)


def check_wheel(ref: PointRef, message: str, bodies: Mapping[str, Body], held: Mapping[str, str]) -> None:
    """A round body on an axle or hinge of its own."""
    if ref.owner not in held or rim_radius(bodies[ref.owner], ref.point) is None:
        lacks = "turns on no axle" if ref.owner not in held else "has no radius"
        raise Unsolvable(message, span=ref.span, help=f"`{ref.owner}` {lacks}")


def check_touch(item: Touch, problem: Problem, bodies: Mapping[str, Body], held: Mapping[str, str]) -> None:
    """A body on a surface or on a body that travels, or two wheels side by side."""
    ref, under = item.pair()[:2]
    press = item.press if isinstance(item, Contact) else None
    if under.owner in bodies and (ref.owner in held or under.owner in held or press is not None):
        for wheel in item.pair():
            check_wheel(wheel, "a contact with a wheel on an axle is solved for two of them only", bodies, held)
        if not isinstance(item, Contact):
            help = f"write `contact: [{ref.owner}, {under.owner}]`"
            raise Unsolvable("two wheels on fixed axles do not roll on each other", span=under.span, help=help)
    elif under.owner in bodies:
        check_carrier(item, problem, bodies)
    elif press is not None:
        help = "a force that presses a body on a surface stands among the actions"
        raise Unsolvable(f"`press` of `{item.name}` is for two wheels", span=under.span, help=help)


def check_carrier(item: Touch, problem: Problem, bodies: Mapping[str, Body]) -> None:
    """What carries another body travels along a flat surface, or along the line that it `moves`, and does not turn."""
    ref, under = item.pair()[:2]
    carrier = bodies[under.owner]
    flat = {surface.name for surface in problem.surfaces if not isinstance(surface, (Curved, Wall))} | set(bodies)
    touches = [other for other in problem.connections if isinstance(other, Touch)]
    laid = [other for other in touches if other.pair()[0].owner == carrier.name and other is not item]
    on_flat = any(other.places()[0].owner in flat for other in laid)
    if carrier.turns is not None or rim_radius(carrier, None) is not None or len(item.pair()) > 2:
        raise Unsolvable(f"`{ref.owner}` on `{carrier.name}`, which turns, is not solved yet", span=under.span)
    if not on_flat and carrier.moves not in ("left", "right"):
        help = f"say on what `{carrier.name}` lies: `contact: [{carrier.name}, floor]`"
        raise Unsolvable(
            f"nothing tells how `{carrier.name}`, which carries `{ref.owner}`, travels", span=under.span, help=help
        )


def on_axes(problem: Problem) -> frozenset[str]:
    """The bodies that an axle or hinge holds."""
    return frozenset(ref.owner for item in problem.connections for ref in item.fixed_points())


def check_spring(item: Spring, held: Mapping[str, str]) -> None:
    """A spring from a place ends at a hinged body, whose hinge is the origin, and its rest length tells how it is stretched."""
    for ref in item.spring:
        if ref.place is None and ref.owner not in held:
            help = "solved are springs from a place to a point of a hinged body; the hinge is at [0, 0]"
            raise Unsolvable(f"where `{ref.owner}` is in the scene is not told", span=ref.span, help=help)
    if item.rest_length is None:
        help = "a given that is `unknown` where a state tells how far it is stretched"
        raise Unsolvable(
            f"`{item.name}` runs from a place: give its `rest_length`", span=item.spring[0].span, help=help
        )


def check_roll(item: Unrolls, problem: Problem, bodies: Mapping[str, Body]) -> None:
    """A uniform roll on a level surface, that nothing else touches."""
    roll, floor = item.unrolls
    body = bodies[roll.owner]
    if not shape_of(body).wound or body.parts or body.holes or body.inertia or body.gyration or body.count > 1:
        help = "give it `shape: cylinder`, a mass and a radius"
        raise Unsolvable(f"`{roll.owner}` is no roll of a thin sheet", span=roll.span, help=help)
    if floor.owner not in level_surfaces(problem):
        raise Unsolvable(
            "a carpet that unrolls down a slope is not solved yet", span=floor.span, help="solved is a level floor"
        )
    others: tuple[Connection | Action, ...] = (*problem.connections, *problem.actions)
    for ref in (ref for other in others if other is not item for ref in other.touches() if ref.owner == roll.owner):
        raise Unsolvable(f"what else acts on `{roll.owner}`, which unrolls, is not solved yet", span=ref.span)


def level_surfaces(problem: Problem) -> set[str]:
    """The names of all that is level."""
    return {surface.name for surface in problem.surfaces if surface.word == "level"} | {"ground"}


def check_one_axis(pair: tuple[PointRef, ...], word: str, held: Mapping[str, str]) -> None:
    """Two bodies that share an axle."""
    first, second = pair
    if held.get(first.owner, first.owner) != held.get(second.owner):
        help = f"give `axle: [{first.owner}, {second.owner}]`"
        raise Unsolvable(f"`{word}` is solved for two bodies on one axle only", span=second.span, help=help)


def check_ride(item: Rides, bodies: Mapping[str, Body], held: Mapping[str, str]) -> None:
    """What rides is a particle, on a body that an axle or hinge holds."""
    rider, carrier = item.rides
    if not isinstance(shape_of(bodies[rider.owner]), Particle):
        help = "leave out its `shape`: its mass is at its `radius` from the axis"
        raise Unsolvable(f"`{rider.owner}` rides: it has to be a particle", span=rider.span, help=help)
    if carrier.owner not in held or rider.owner in held:
        help = f"give `axle: {carrier.owner}`"
        raise Unsolvable(f"`{carrier.owner}` has to turn on an axle or hinge", span=carrier.span, help=help)


def check_free(item: Rides, problem: Problem) -> None:
    """Of what slides freely each state says where it is, and no event happens meanwhile."""
    rider = item.rides[0]
    said = {
        state.name
        for state in problem.states
        for line in state.conditions
        if line.path is not None and (line.path.owner, line.path.quantity) == (rider.owner, "radius")
    }
    silent = next((state for state in problem.states[1:] if state.name not in said), None)
    if item.free and silent is not None:
        help = f"give `{rider.owner}.radius`"
        raise Unsolvable(f"nothing tells where `{rider.owner}` is at `{silent.name}`", span=silent.span, help=help)
    if item.free and problem.events:
        raise Unsolvable("events with what slides freely are not solved yet", span=rider.span)


def check_points(problem: Problem, bodies: Mapping[str, Body]) -> None:
    """A hinge says which point of a body it holds; a string leaves a wheel on a tangent of its rim."""
    for item in problem.connections:
        if item.word == "hinge":
            check_hinge(item, bodies)
        elif item.word == "string":
            for ref in item.touches():
                if ref.point in ("top", "bottom") and ref.owner in bodies:
                    help = f"write `{ref.owner}.rim`, with `under: {ref.owner}` where it passes below"
                    raise Unsolvable("a string leaves a wheel where it touches the rim", span=ref.span, help=help)


def check_hinge(item: Connection, bodies: Mapping[str, Body]) -> None:
    """A hinge of a rod or the like says which point it holds."""
    for ref in item.touches():
        points = shape_of(bodies[ref.owner]).points if ref.owner in bodies and ref.point is None else ()
        if "start" in points:
            help = f"write {', '.join(f'`{ref.owner}.{point}`' for point in points)} or `{ref.owner}.at(x)`"
            raise Unsolvable(f"`hinge: {ref.owner}` names no point", span=ref.span, help=help)


def check_ropes(problem: Problem, bodies: Mapping[str, Body]) -> None:
    """A rope is held by `drapes` alone, over a wheel on an axle, a peg or a level table."""
    ropes = {body.name for body in problem.bodies if not shape_of(body).rigid}
    held = [item.drapes for item in problem.connections if isinstance(item, Drapes)]
    if not ropes and not held:
        return
    level = level_surfaces(problem)
    turning = {ref.owner for item in problem.connections if item.word == "axle" for ref in item.touches()}
    holders: tuple[Connection | Action, ...] = (*problem.connections, *problem.actions)
    for item in holders:
        for index, ref in enumerate(item.touches()):
            if (ref.owner in ropes) != (isinstance(item, Drapes) and index == 0):
                help = "write `drapes: [rope, pulley]`, with a body of `shape: rope` first"
                raise Unsolvable(f"`{item.word}` can not hold `{ref.owner}`", span=ref.span, help=help)
    for rope, over, *_ in held:
        if over.owner not in (turning if over.owner in bodies else level):
            help = "it hangs over a wheel on an `axle`, a smooth peg (`ground`) or the edge of a level table"
            raise Unsolvable(f"`{rope.owner}` can not hang over `{over.owner}`", span=over.span, help=help)
    for name in sorted(ropes - {points[0].owner for points in held}):
        help = f"say what it hangs over, as in `drapes: [{name}, pulley]`"
        raise Unsolvable(f"`{name}` is a rope that nothing holds", span=bodies[name].span, help=help)
