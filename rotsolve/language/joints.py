"""Joints: all by which connections of a scene in space hold bodies, with the motors that turn some on their axes as hard as it takes,
and those that events bring."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from msgspec.structs import replace

from rotsolve.core.faults import Unsolvable
from rotsolve.language.bodies import Joint
from rotsolve.language.elements import Connection, Event
from rotsolve.language.problem import Problem

HOW_TURNED = (
    "angle",
    "rotation",
    "turns",
    "tilt",
    "precession_angle",
    "spin_angle",
    "vertical",
    "x_axis",
    "y_axis",
    "z_axis",
)
HOW_TURNING = ("angular_velocity", "angular_acceleration", "spin", "axial_rate", "precession", "nutation", "freedoms")


def joints_in_space(connections: Iterable[Connection]) -> tuple[Joint, ...]:
    """The joints, in the order of the file; refused is a motor between bodies that no hinge or axle joins."""
    connections = tuple(connections)
    found = [joint for item in connections if (joint := item.joint_in_space()) is not None]
    for item in connections:
        pair = item.motor_in_space()
        if pair is None:
            continue
        names = {ref.owner for ref in pair}
        driven = next(
            (joint for joint in found if joint.turning and {joint.carrier.owner, joint.body.owner} == names), None
        )
        if driven is None or driven.drive or driven.pitch is not None:
            carrier, body = (ref.owner for ref in pair)
            message = f"`{item.name}` turns `{body}` on `{carrier}`, and no hinge or axle is there about which it could"
            help = f"join them: `axle: [{carrier}, {body}]` with `along`, and without a motion of its own"
            raise Unsolvable(message, span=pair[1].span, help=help)
        found[found.index(driven)] = replace(driven, motor=True)
    return tuple(found)


def events_up_to(problem: Problem, state: str) -> Iterator[Event]:
    """The events that lead to a state or to one before it, in the order of time; none of what is no state."""
    names = [item.name for item in problem.states]
    for name in names[: names.index(state) + 1] if state in names else ():
        yield from (event for event in problem.events if event.to == name)


def joints_at(problem: Problem, state: str) -> tuple[Joint, ...]:
    """The joints of a scene in space at a state: those of its connections, then those that events up to it have brought."""
    found = joints_in_space(problem.connections)
    names = {body.name for body in problem.bodies}
    for held in (joint for joint in found if joint.body.owner not in names):
        help = "name the point that it holds last: `[[x, y, z], BODY.P]`"
        raise Unsolvable(f"`{held.owner}` holds no body", span=held.body.span, help=help)
    for event in events_up_to(problem, state):
        refuse_no_bodies(event, problem)
        joint = event.joint_in_space() or joint_of_joined(event, found, problem)
        if joint is not None:
            refuse_pair(joint)
            refuse_held(event, joint, found)
            found = (*found, joint)
    return tuple([replace(one, turning=()) if turns_a_point(one, found, problem) else one for one in found])


def turns_a_point(joint: Joint, joints: tuple[Joint, ...], problem: Problem) -> bool:
    """Whether a hinge lets nothing turn but a particle about itself, of whose own turning the scene does not speak: it holds it as
    firmly."""
    name = joint.body.owner
    led = joint.powered or joint.sliding or joint.pitch is not None or joint.bearings or joint.through is not None
    if not joint.turning or led or any(other.carrier.owner == name for other in joints):
        return False
    body = next((one for one in problem.bodies if one.name == name), None)
    whole = body is None or body.parts or any(told is not None for told in (body.inertia, body.gyration, body.tensor))
    if body is None or whole or body.points or body.shape is None or not body.shape.pointlike:
        return False
    if any(action.twists() and name in (ref.owner for ref in action.touches()) for action in problem.actions):
        return False
    return name not in set(turned_in_words(problem))


def turned_in_words(problem: Problem) -> Iterator[str]:
    """The bodies of which lines of states or questions say how they stand or turn, or along whose axes something is told."""
    lines = [line for state in problem.states for line in state.conditions]
    terms = [term for find in problem.finds for term in find.terms]
    said = [(line.path, line.axes, line.relative) for line in lines]
    for path, axes, relative in (*said, *((term.path, term.axes, term.relative) for term in terms)):
        yield from filter(None, (axes, relative))
        if path is not None and path.quantity in (*HOW_TURNED, *HOW_TURNING):
            yield path.owner


def joint_of_joined(event: Event, joints: tuple[Joint, ...], problem: Problem) -> Joint | None:
    """The clamp of two bodies that stay together: the first carries the second, unless that alone is held already or no particle."""
    pair = event.joined()
    if not pair:
        return None
    held = {joint.body.owner for joint in joints}
    points = {body.name for body in problem.bodies if body.shape is not None and body.shape.pointlike}
    one, other = pair
    firm = (one.owner in held, one.owner not in points) >= (other.owner in held, other.owner not in points)
    return Joint(event.name, one, other) if firm else Joint(event.name, other, one, named_last=True)


def refuse_no_bodies(event: Event, problem: Problem) -> None:
    """Refuse an event that holds or joins what is no body of the scene, or a body with itself."""
    refs = event.points(()) if event.joined() or event.joint_in_space() is not None else ()
    names = {body.name for body in problem.bodies}
    for ref in refs:
        if ref.owner not in names:
            message = f"`{event.word}` is about bodies, and `{ref.owner or 'a place'}` is none"
            raise Unsolvable(message, span=ref.span, help="`fixes: BODY.POINT` holds a point of a body in space")
    if event.joined() and refs[0].owner == refs[1].owner:
        raise Unsolvable(f"`{event.word}` names `{refs[0].owner}` twice", span=refs[1].span, help="name two bodies")


def refuse_pair(joint: Joint) -> None:
    """Refuse to hold points of two bodies at once, and two points with an axis besides."""
    last = joint.through
    if last is None:
        return
    if last.owner != joint.body.owner:
        message, help = f"`{joint.owner}` holds points of two bodies", "give each body an event of its own"
    elif joint.turning:
        message, help = (
            f"`{joint.owner}` has two points and an axis",
            "the line through both points is the axis: leave `along` out",
        )
    else:
        return
    raise Unsolvable(message, span=last.span, help=help)


def refuse_held(event: Event, joint: Joint, joints: tuple[Joint, ...]) -> None:
    """Refuse an event that holds what is held already, or what touches a surface, of which it would have to tell how that goes on."""
    name, carrier, span = joint.body.owner, joint.carrier.owner, event.points(())[-1].span
    carriers = {item.body.owner: item for item in joints if not touches(item)}
    if name in carriers:
        also = f", and `{carrier}` by `{carriers[carrier].owner}`" if carrier in carriers else ""
        message = f"`{name}` is held by `{carriers[name].owner}` already{also}"
        raise Unsolvable(message, span=span, help=f"`{event.word}` takes a body that moves freely")
    at = carrier
    while at in carriers:
        at = carriers[at].carrier.owner
        if at == name:
            message = (
                f"`{name}` and `{carrier}` hang together already: another joint between them is not solved in space"
            )
            raise Unsolvable(message, span=span, help=f"leave `{event.name}` out")
    for other in joints:
        if touches(other) and other.body.owner in (name, carrier):
            message = f"`{other.body.owner}` touches a surface by `{other.owner}`: `{event.word}` of that is not solved in space"
            raise Unsolvable(message, span=span, help=f"leave `{other.owner}` out")


def touches(joint: Joint) -> bool:
    """Whether a joint lets its body touch a surface without holding a point of it."""
    return joint.rolls or joint.flat
