"""Admissible: what a scene must fulfil to be solved, before anything is worked out; what does not is refused by name.

What an element asks of the bodies that it names it checks itself; here is what goes for all of them.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import pairwise

from rotsolve.core.faults import Unsolvable
from rotsolve.core.symbols import paths_in
from rotsolve.core.vectors.heading import NOWHERE, Vector
from rotsolve.elements.shapes import rim_radius, rivals, shape_of
from rotsolve.language.bodies import Body, PointRef
from rotsolve.language.elements import ActingElement, Action, Connection, Event
from rotsolve.language.problem import Problem
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.rigid import centre_of_mass, locate, pieces, rim_centre, tidy

TURNS = ("angular_velocity", "angular_acceleration", "angular_momentum", "rotation", "turns", "torque")


def check(problem: Problem) -> None:
    """Raises Unsolvable at the place of the first name that can't be meant so."""
    scene = Configuration(problem)
    check_sequence(problem)
    check_bodies_named(problem, scene.bodies)
    check_pairs(problem, scene.bodies)
    check_rims(problem, scene)
    check_ropes(problem, scene.bodies)
    check_stacks(problem, scene.bodies)
    for item in (*problem.connections, *problem.actions):
        item.check(scene)
        check_turning(item, scene)
    for connection in problem.connections:
        check_rooms(connection, scene)
    for event in problem.events:
        check_event(event, scene)


def check_event(event: Event, scene: Configuration) -> None:
    """An event with what it holds from then on."""
    from rotsolve.motion.corners import refuse_untold

    event.check(scene)
    for ref in (ref for item in event.adds() for ref in item.fixed_points()):
        refuse_untold(ref, event.from_ or "", scene)


def check_rooms(item: Connection, scene: Configuration) -> None:
    """Bodies that a connection brings together fit each other; letters without a number are left open."""
    for limit in item.rooms(scene):
        sign = scene.signs.sign(limit.gap)
        if sign == -1 or (sign == 0 and limit.strict):
            help = (limit.help if sign == -1 else "") or "check the lengths, radii and heights"
            raise Unsolvable(limit.words, span=item.touches()[0].span, help=help)


def check_turning(item: ActingElement, scene: Configuration) -> None:
    """A value that counts along a turn speaks of no angle that counts against it: −k θ would drive away what it seems to bring back."""
    state = scene.timeline.states[0].name
    for value, ref in item.along_turns():
        paths = paths_in(value) if value is not None else ()
        for name in (owner for _, owner, word in paths if word == "angle"):
            if name in scene.bodies and scene.sense(name, state) < 0:
                said = f"`{name}.angle` counts counterclockwise, but `{name}` turns clockwise: which way `{item.name}` acts is not clear"
                other = (
                    "say `direction: counterclockwise`" if isinstance(item, Action) else "leave its clockwise sense out"
                )
                help = f"{other}, or let it go by `{name}.rotation`, which counts along the turn"
                raise Unsolvable(said, span=ref.span, help=help)


def check_sequence(problem: Problem) -> None:
    """A fault for what joins no neighbouring states, for two events at once, and for an action that never acts."""
    states = {state.name: state for state in problem.states}
    order = {name: index for index, name in enumerate(states)}
    taken: dict[tuple[str, str], str] = {}
    for name, start, end in named_intervals(problem):
        if order[end] != order[start] + 1:
            pairs = "; ".join(f"from {first} to {second}" for first, second in pairwise(order))
            help = f"states follow each other as they are written: {pairs}"
            message = f"`{name}` does not lead from a state to the next one"
            raise Unsolvable(message, span=states[end].span, help=help)
        other = taken.setdefault((start, end), name)
        pair = [event for event in problem.events if event.name in (other, name)]
        at_once = all(event.blow and not event.rubs() for event in pair) and len(pair) == 2 and not problem.space
        if other != name and not at_once:
            message = f"`{other}` and `{name}` happen between the same states: that is not solved yet"
            ways = {event.at_once for event in pair} if problem.space else {""}
            help = "give each a state of its own to lead to, and let the second start where the first ends"
            help = (len(ways) == 1 and ways.pop()) or help
            raise Unsolvable(message, span=states[end].span, help=help)
    for action in problem.actions:
        begins = order.get(action.from_ or "", 0)
        if action.to is not None and order[action.to] <= begins:
            help = f"a force that acts at a state and then no longer: `removes: {action.name}` among the events"
            raise Unsolvable(f"`{action.name}` ends before it begins to act", span=states[action.to].span, help=help)


def named_intervals(problem: Problem) -> Iterator[tuple[str, str, str]]:
    """The events with the states that they join, and the phases in which a connection does not act."""
    for event in problem.events:
        if event.from_ is not None and event.to is not None:
            yield event.name, event.from_, event.to
    for phase in problem.phases:
        if phase.without:
            yield phase.name, phase.start, phase.end


def check_bodies_named(problem: Problem, bodies: Mapping[str, Body]) -> None:
    """Every connection names a body; one that lays a body on something, or unwinds it, names that first."""
    for item in problem.connections:
        refs = item.touches()
        held = [ref.owner for ref in refs if ref.owner in bodies]
        if refs and not held:
            raise Unsolvable(
                f"`{item.name}` touches no body", span=refs[0].span, help="name one, as in `hinge: rod.start`"
            )
        if refs and item.lays_first and refs[0].owner not in bodies:
            others = ", ".join([held[0], *(ref.owner for ref in refs if ref.owner != held[0])])
            message = f"`{item.word}` names the body first, and `{refs[0].owner}` is none"
            raise Unsolvable(message, span=refs[0].span, help=f"write `{item.word}: [{others}]`")


def check_pairs(problem: Problem, bodies: Mapping[str, Body]) -> None:
    """Different bodies where bodies are named, with a rim where one is needed; what is joined already is not joined again."""
    pairs: list[tuple[PointRef, ...]] = []
    for item in problem.connections:
        for ref in item.touches() if item.bodily else ():
            if ref.owner not in bodies:
                help = (
                    "hold what does not turn by an `axle` with `angular_velocity: 0`" if ref.owner == "ground" else ""
                )
                raise Unsolvable(f"`{item.word}` joins bodies, and `{ref.owner}` is none", span=ref.span, help=help)
            body = bodies[ref.owner]
            if item.rimmed and rim_radius(body, ref.point) is None and "rim" not in shape_of(body).points:
                raise Unsolvable(f"`{ref.owner}` has no radius on which a {item.word} could run", span=ref.span)
        if not item.repeats:
            check_distinct(item.touches(), bodies)
        pairs += [item.joined()] if item.joined() else []
    for event in problem.events:
        met = event.points(problem.connections) if event.bodily else ()
        for ref in met:
            if ref.owner not in bodies:
                raise Unsolvable(f"`{event.word}` is about two bodies, and `{ref.owner}` is none", span=ref.span)
        check_distinct(met, bodies)
        pairs += [event.joined()] if event.joined() else []
    whole: dict[str, frozenset[str]] = {}
    for first, second in pairs:
        one, other = (whole.get(ref.owner, frozenset((ref.owner,))) for ref in (first, second))
        if one & other & bodies.keys():
            raise Unsolvable(f"`{first.owner}` and `{second.owner}` are joined already", span=second.span)
        whole.update(dict.fromkeys(one | other, one | other))


def check_rims(problem: Problem, scene: Configuration) -> None:
    """What touches a rim tells which, of a body that has several."""
    for item in (*problem.connections, *problem.actions):
        for ref in item.on_rims(scene):
            names = rivals(scene.bodies[ref.owner], ref.point) if ref.owner in scene.bodies else ()
            if names:
                whole = ref.owner if ref.point is None else f"{ref.owner}.{ref.point}"
                help = f"name it: `{whole}.{names[0]}`" if ref.point is None else f"give `{ref.point}` one `radius`"
                listed = ", ".join(f"`{name}`" for name in names)
                message = f"`{whole}` has the rims {listed}: on which one is `{item.name}`?"
                raise Unsolvable(message, span=ref.span, help=help)


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


def check_stacks(problem: Problem, bodies: Mapping[str, Body]) -> None:
    """What lies on a body does not carry it as well."""
    below: dict[str, str] = {}
    for item in problem.connections:
        top, under = item.lying(), next(iter(item.places()), None)
        if under is None or under.owner not in bodies:
            continue
        below.setdefault(top, under.owner)
        name, passed = under.owner, {top}
        while name in below and name not in passed:
            passed.add(name)
            name = below[name]
        if name in passed:
            raise Unsolvable(f"`{top}` and `{under.owner}` lie on each other", span=under.span)


def check_rigid(scene: Configuration, state: str) -> None:
    """What is joined into one body turns about one point, on which it is told what keeps it: of a problem with all its letters."""
    places: dict[str, tuple[PointRef, Vector]] = {}
    for item in scene.connections(state):
        for ref in item.fixed_points():
            host = scene.host(ref.owner, state)
            place = scene.seat(ref.owner, state).place(locate(scene.body(ref.owner, state), ref))
            other, first = places.setdefault(host, (ref, place))
            if tidy(place - first).parts:
                whole = f"`{ref.owner}` and `{other.owner}` are one body, which"
                holds = f"`{ref.owner}` is a body that" if other.owner == ref.owner else whole
                message = f"{holds} `{item.name}` and another support hold at two points"
                raise Unsolvable(f"{message}: not solved yet", span=ref.span)
        for ref in item.touches() if item.rimmed else ():
            check_hub(ref, item.word, scene, state)
    for body in scene.present(state):
        if rim_radius(body, None) is None or scene.line(body.name, state) is None:
            continue
        if scene.pivot(body.name, state) is not None or scene.hub(body.name, state) is not None:
            continue
        frame = scene.frame(body.name, state)
        middle = centre_of_mass(pieces(body)) if body.shape is not None else NOWHERE
        if tidy(frame.reference + frame.cm - middle).parts:
            message = f"nothing tells what keeps `{body.name}` on its line while its centre of mass goes round: not solved yet"
            raise Unsolvable(message, span=body.span, help="solved is what turns on an axle, or rolls along a surface")


def check_hub(ref: PointRef, word: str, scene: Configuration, state: str) -> None:
    """A belt or gear runs on a rim round the axis about which the wheel turns."""
    host, body = scene.host(ref.owner, state), scene.body(ref.owner, state)
    centre = scene.seat(ref.owner, state).place(rim_centre(body, ref.point))
    if scene.pivot(host, state) is not None and tidy(centre - scene.frame(host, state).reference).parts:
        message = f"a {word} on a rim of `{ref.owner}` that is not round its axis is not solved yet"
        raise Unsolvable(message, span=ref.span)


def check_ropes(problem: Problem, bodies: Mapping[str, Body]) -> None:
    """A rope is held only by what can hold one, and that holds nothing else."""
    ropes = {body.name for body in problem.bodies if not shape_of(body).rigid}
    held = {ref.owner for item in problem.connections for ref in item.ropes()}
    if not ropes and not held:
        return
    able = [(item, item.ropes()) for item in problem.connections]
    for item, own in (*able, *((action, ()) for action in problem.actions)):
        for ref in item.touches():
            if (ref.owner in ropes) != (ref in own):
                help = "write `drapes: [rope, pulley]`, with a body of `shape: rope` first"
                raise Unsolvable(f"`{item.word}` can not hold `{ref.owner}`", span=ref.span, help=help)
    for name in sorted(ropes - held):
        help = f"say what it hangs over, as in `drapes: [{name}, pulley]`"
        raise Unsolvable(f"`{name}` is a rope that nothing holds", span=bodies[name].span, help=help)
