"""Admissible: what a scene must fulfil to be solved, before anything is worked out; what does not is refused by name."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import pairwise

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.faults import Unsolvable
from rotsolve.elements.actions import Action, Press
from rotsolve.elements.connections import Connection, Contact, Rides, String, Weld
from rotsolve.elements.connections.contact import Unrolls
from rotsolve.elements.connections.drapes import Drapes
from rotsolve.elements.connections.springs import Spring
from rotsolve.elements.connections.touch import Touch
from rotsolve.elements.events import Collides, Fixes, Grips, Joins
from rotsolve.elements.rims import rim_radius, shape_of
from rotsolve.elements.shapes import Particle
from rotsolve.elements.surfaces import Curved, Surface, Wall
from rotsolve.language.problem import Body, PointRef, Problem


def check_pairs(problem: Problem, bodies: Mapping[str, Body]) -> None:
    """Only a string touches one body twice, and what is joined already is not joined again."""
    joined: list[tuple[PointRef, ...]] = []
    for item in problem.connections:
        for ref in item.touches() if item.bodily else ():
            if ref.owner not in bodies:
                raise Unsolvable(f"`{item.word}` joins bodies, and `{ref.owner}` is none", span=ref.span)
            body = bodies[ref.owner]
            if item.rimmed and rim_radius(body, ref.point) is None and "rim" not in shape_of(body).points:
                raise Unsolvable(f"`{ref.owner}` has no radius on which a {item.word} could run", span=ref.span)
        if not isinstance(item, String):
            check_distinct(item.touches(), bodies)
        if isinstance(item, Weld):
            joined.append(item.weld)
    for event in problem.events:
        met = event.joins if isinstance(event, Joins) else event.collides if isinstance(event, Collides) else ()
        for ref in met:
            if ref.owner not in bodies:
                raise Unsolvable(f"`{event.word}` is about two bodies, and `{ref.owner}` is none", span=ref.span)
        check_distinct(met, bodies)
        if isinstance(event, Joins):
            joined.append(met)
    whole: dict[str, frozenset[str]] = {}
    for first, second in joined:
        one, other = (whole.get(ref.owner, frozenset((ref.owner,))) for ref in (first, second))
        if one & other & bodies.keys():
            raise Unsolvable(f"`{first.owner}` and `{second.owner}` are joined already", span=second.span)
        whole.update(dict.fromkeys(one | other, one | other))


def check_stacks(problem: Problem, bodies: Mapping[str, Body]) -> None:
    """What lies on a body does not carry it as well."""
    below: dict[str, str] = {}
    for item in problem.connections:
        if not isinstance(item, Touch):
            continue
        top, under = item.pair()[:2]
        if under.owner not in bodies:
            continue
        below.setdefault(top.owner, under.owner)
        name, passed = under.owner, {top.owner}
        while name in below and name not in passed:
            passed.add(name)
            name = below[name]
        if name in passed:
            raise Unsolvable(f"`{top.owner}` and `{under.owner}` lie on each other", span=under.span)


def check_distinct(points: tuple[PointRef, ...], bodies: Mapping[str, Body]) -> None:
    """Points of different bodies."""
    if len(points) < 2:
        return
    seen: set[str] = set()
    for ref in points:
        if ref.owner in seen and ref.owner in bodies:
            help = "name two bodies, or `ground`"
            raise Unsolvable(f"`{ref.owner}` is connected to itself", span=ref.span, help=help)
        seen.add(ref.owner)


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


def check_surfaces(problem: Problem) -> None:
    """A fault for the first contact with curved surfaces that is not worked out, or can not be."""
    surfaces = {surface.name: surface for surface in problem.surfaces}
    for item in problem.connections if surfaces else ():
        if isinstance(item, Touch):
            places = [surfaces[ref.owner] for ref in item.places() if ref.owner in surfaces]
            check_joined(item, places)
            for place in places:
                if isinstance(place, Curved):
                    check_curved(item, place, problem)


def check_holding(problem: Problem) -> None:
    """A fault for an event that grips what is no contact with a flat surface or corner, or fixes what is held already."""
    if not problem.events:
        return
    held = {ref.owner: item.name for item in problem.connections for ref in item.fixed_points()}
    for event in problem.events:
        if isinstance(event, Grips):
            check_grip(event, problem)
        elif isinstance(event, Fixes) and event.fixes is not None and event.fixes.owner in held:
            message = f"`{event.fixes.owner}` is held by `{held[event.fixes.owner]}` already"
            raise Unsolvable(message, span=event.fixes.span, help="fix a point of a body that moves freely")


def check_grip(event: Grips, problem: Problem) -> None:
    contacts = {item.name: item for item in problem.connections if isinstance(item, Touch)}
    item = contacts.get(event.grips or "")
    if item is None:
        help = f"contacts: {', '.join(sorted(contacts))}" if contacts else "the scene has no contact"
        raise Unsolvable(f"`{event.name}` can only grip a contact, and `{event.grips}` is none", help=help)
    bent = {surface.name for surface in problem.surfaces if isinstance(surface, Curved) and surface.height() is None}
    if bent & {ref.owner for ref in item.places()}:
        message = f"`{event.name}` on a curved surface is not solved yet"
        raise Unsolvable(message, span=item.pair()[1].span, help="solved are flat surfaces and corners")


def check_joined(item: Touch, places: list[Surface]) -> None:
    """Surfaces that join: a track of unknown profile that leads into a curved one."""
    unknown = [isinstance(place, Curved) and place.radius() is None for place in places]
    curved = all(isinstance(place, Curved) for place in places)
    if len(places) > 1 and not (curved and len(places) == 2 and unknown == [True, False]):
        message = f"these surfaces of `{item.name}` together are not solved yet"
        help = "solved is a track of `profile unknown` that leads into a `hollow` or `dome`"
        raise Unsolvable(message, span=item.pair()[1].span, help=help)


def check_curved(item: Touch, surface: Curved, problem: Problem) -> None:
    """Round bodies and particles, rolling or without friction, that fit the surface and that nothing else holds."""
    ref = item.pair()[0]
    body = next((body for body in problem.bodies if body.name == ref.owner), None)
    if body is None:
        return
    if item.grip().kind == "coefficient":
        help = "write `friction: none`, or `any` where it is rough enough"
        raise Unsolvable("a coefficient of friction on a curved surface is not solved yet", span=ref.span, help=help)
    if body.moved:
        help = "solved are forces and couples on it"
        raise Unsolvable(
            f"a given motion of `{body.name}` on `{surface.name}` is not solved yet", span=ref.span, help=help
        )
    rim = rim_radius(body, ref.point)
    edge = surface.height() is not None
    fits = rim is not None or (shape_of(body).word == "particle" and not edge)
    if not fits or body.parts or body.holes:
        help = "solved are uniform round bodies" + ("" if edge else ", and particles")
        raise Unsolvable(f"`{body.name}` on `{surface.name}` is not solved yet", span=ref.span, help=help)
    for other in held_besides(body.name, item, problem):
        message = f"`{other}` on a body that is on `{surface.name}` is not solved yet"
        raise Unsolvable(message, span=ref.span, help="solved are forces and couples on it")
    for room, words in too_large(surface, rim or ZERO, on_flat(body.name, problem)):
        if negative(room, problem):
            message = f"`{body.name}` {words} `{surface.name}`"
            raise Unsolvable(message, span=ref.span, help="check the radii and heights")


def held_besides(name: str, contact: Touch, problem: Problem) -> Iterator[str]:
    """Strings, springs and the like on a body on a curved surface, and bodies that join it there; not while it is on the floor."""
    gripped = any(isinstance(event, Grips) and event.grips == contact.name for event in problem.events)
    if on_flat(name, problem) and not gripped:
        return
    for item in problem.connections:
        if not isinstance(item, Touch) and any(ref.owner == name for ref in item.touches()):
            yield item.name
    for event in problem.events:
        if isinstance(event, Joins) and any(ref.owner == name for ref in event.joins):
            yield event.name


def on_flat(name: str, problem: Problem) -> bool:
    """Whether a body touches a floor, slope or wall too."""
    curved = {surface.name for surface in problem.surfaces if isinstance(surface, Curved)}
    touches = (item for item in problem.connections if isinstance(item, Touch) and item.pair()[0].owner == name)
    return any(ref.owner not in curved for item in touches for ref in item.places())


def too_large(surface: Curved, rim: Formula, flat: bool) -> Iterator[tuple[Formula, str]]:
    """Lengths that must be positive, and what is the matter where one is not; a corner is as high as it may be above no floor."""
    circle = surface.circle(rim)
    if circle is not None and not surface.outside:
        yield circle, "does not fit into"
    if flat and surface.height() is not None:
        yield rim - (surface.height() or ZERO), "is too small to climb"


def negative(room: Formula, problem: Problem) -> bool:
    """Whether a length is not positive with the numbers of the scene; letters without a number are left open."""
    values = {given.name: given.value for given in problem.givens if given.value is not None}
    try:
        return (evaluate(room, values, digits=6).sign or 0) <= 0
    except (Undefined, ValueError):
        return False


def check_sequence(problem: Problem) -> None:
    """A fault for what joins no neighbouring states, for two events at once, and for an action that never acts."""
    states = {state.name: state for state in problem.states}
    order = {name: index for index, name in enumerate(states)}
    taken: dict[tuple[str, str], str] = {}
    for name, start, end in joined(problem):
        if order[end] != order[start] + 1:
            pairs = "; ".join(f"from {first} to {second}" for first, second in pairwise(order))
            help = f"states follow each other as they are written: {pairs}"
            message = f"`{name}` does not lead from a state to the next one"
            raise Unsolvable(message, span=states[end].span, help=help)
        other = taken.setdefault((start, end), name)
        if other != name:
            message = f"`{other}` and `{name}` happen between the same states: that is not solved yet"
            help = "give each a state of its own to lead to, and let the second start where the first ends"
            raise Unsolvable(message, span=states[end].span, help=help)
    for action in problem.actions:
        begins = order.get(action.from_ or "", 0)
        if action.to is not None and order[action.to] <= begins:
            help = f"a force that acts at a state and then no longer: `removes: {action.name}` among the events"
            raise Unsolvable(f"`{action.name}` ends before it begins to act", span=states[action.to].span, help=help)


def joined(problem: Problem) -> Iterator[tuple[str, str, str]]:
    """The events with the states that they join, and the phases in which a connection does not act."""
    for event in problem.events:
        if event.from_ is not None and event.to is not None:
            yield event.name, event.from_, event.to
    for phase in problem.phases:
        if phase.without:
            yield phase.name, phase.start, phase.end
