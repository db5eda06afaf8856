"""Parted: two bodies that meet do not part faster than they came, and those that have bounced off each other on a line may not go
through each other up to the next blow between them; what is taken along off a surface does not go into that."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula, negate
from rotsolve.core.facts import APART, GAINS, IN_FRONT, LIFTS, Requirement, square
from rotsolve.core.passage import Approach
from rotsolve.core.symbols import CONSTANT
from rotsolve.core.vectors.heading import RIGHT, UP, Heading, heading
from rotsolve.core.writing import spoken
from rotsolve.elements.collisions import FIXED
from rotsolve.elements.shapes import shape_of
from rotsolve.language.bodies import PointRef
from rotsolve.motion.places import gone_along, place_of_point
from rotsolve.motion.timeline import Interval
from rotsolve.search.search import Search


def partings(search: Search) -> Iterator[tuple[str, tuple[Requirement, ...]]]:
    """What two bodies that meet obey, by event that they part as fast as it can be, by later state s₂ − s₁ ≥ 0 of the ways since then.

    Bodies that did not come towards each other may be driven apart: by a charge, or a spring that is let go.
    """
    for interval, closing in pairs_that_meet(search):
        came = search.apart().settled(closing.approach)
        ahead = search.numbers.side(search.numbers.with_answers(came)) if came is not None else None
        if not ahead:
            continue
        name, pair = interval.name, closing.pair
        if not closing.told:
            yield name, tuple(speeds_apart(name, pair, (closing.speeds, ahead), interval, search))
        for state, space in ways_apart(pair, interval, search):
            left = space * (ahead if keeps_order(pair, closing.speeds, ahead, interval, search) else -ahead)
            words = both_spoken(pair)
            yield state, (Requirement(name, APART, left, ZERO, f"{words} stay apart", f"{words} meet again before"),)


def pairs_that_meet(search: Search) -> Iterator[tuple[Interval, Approach]]:
    """Two bodies that come together in an event and part again, with the event."""
    for name, encounter in search.scene.encounters.items():
        interval = search.scene.configuration.timeline.interval(name)
        pairs = [closing for closing in encounter.closings if len(set(closing.pair)) == 2]
        yield from ((interval, closing) for closing in pairs if interval is not None)


def kept_in_front(search: Search) -> Iterator[tuple[str, tuple[Requirement, ...]]]:
    """What has bounced off something obeys up to its next blow on that, by state: Δr · n ≥ 0, and = 0 at that blow."""
    timeline = search.scene.configuration.timeline
    for blow, event, (ref, name, out) in barriers(timeline.intervals, search):
        way = out_of(name, blow, event, search) if out is not None else None
        gap: Formula = ZERO
        for interval in timeline.intervals[timeline.order[blow.end] :] if way else ():
            gone = way_towards(ref.owner, out, interval, search) if out and interval.event is None else ZERO
            if gone is None or way is None:
                break
            gap = gap + gone * way
            after = timeline.after(interval.end)
            again = any(found[:2] == (ref, name) for _, _, found in barriers((after,) if after else (), search))
            yield from needs_in_front(blow, interval, (spoken(ref.owner), spoken(name)), simplify(gap), again)
            if again:
                break


def needs_in_front(
    blow: Interval, interval: Interval, names: tuple[str, str], gap: Formula, again: bool
) -> Iterator[tuple[str, tuple[Requirement, ...]]]:
    """That a body is in front of what it has struck at the end of a phase, and at it where it strikes it `again`."""
    words = " and ".join(names)
    if interval.event is None:
        need = Requirement(blow.name, IN_FRONT, gap, ZERO, "", f"{words} meet again before")
        yield interval.end, (need,)
    if again:
        yield interval.end, (Requirement(blow.name, IN_FRONT, negate(gap), ZERO, "", f"{words} are apart at"),)


def out_of(name: str, blow: Interval, event: str, search: Search) -> int | None:
    """+1 where what strikes comes against the direction out of it, as it does of a surface; −1 where it comes along that."""
    closing = next(item for item in search.scene.encounters[blow.name].closings if item.event == event)
    ahead = search.apart().settled(closing.approach) if name in FIXED else ONE
    return None if ahead is None else search.numbers.side(search.numbers.with_answers(ahead))


def within_hollows(search: Search) -> Iterator[tuple[str, tuple[Requirement, ...]]]:
    """What has left the inside of a loop or bowl obeys by state: ρ² − r² ≥ 0 of its centre, ρ the radius of the circle that it left."""
    scene, timeline = search.scene, search.scene.configuration.timeline
    for leaving in timeline.intervals:
        contacts = () if leaving.event is None else leaving.event.left_behind(scene.configuration.problem.connections)
        for item in contacts:
            start, name = scene.instant(leaving.start), item.lying()
            orbit = start.orbit(name)
            if orbit is None or not orbit.hollow or orbit.radius is None:
                continue
            at = heading(start.place_on(orbit))
            places: list[Formula] = [orbit.radius * (at - axis).cos() for axis in (RIGHT, UP)]
            for interval in timeline.intervals[timeline.order[leaving.end] :]:
                if interval.event is not None:
                    break
                right, up = (way_towards(name, axis, interval, search) for axis in (RIGHT, UP))
                if right is None or up is None:
                    break
                places = [places[0] + right, places[1] + up]
                left = square(orbit.radius) - square(places[0]) - square(places[1])
                words = f"{spoken(name)} and {spoken(item.places()[-1].owner)} meet again before"
                yield interval.end, (Requirement(leaving.name, IN_FRONT, left, ZERO, "", words),)


def barriers(
    intervals: Sequence[Interval], search: Search
) -> Iterator[tuple[Interval, str, tuple[PointRef, str, Heading | None]]]:
    """By event: the body that stays in front of what it strikes, with what that is and the way out of it."""
    for interval in intervals:
        for event in interval.event.each() if interval.event is not None else ():
            found = event.barrier(search.scene.instant(interval.start))
            if found is not None:
                yield interval, event.name, found


def way_towards(name: str, out: Heading, interval: Interval, search: Search) -> Formula | None:
    """How far a body goes in a direction in a phase; None where that is not told."""
    first, last = (search.scene.instant(state) for state in (interval.start, interval.end))
    host = first.host(name)
    gone: Formula = ZERO
    for axis in (RIGHT, UP):
        share = (out - axis).cos()
        way = gone_along(host, axis, interval, first, last) if share != ZERO else ZERO
        if way is None:
            return None
        gone = gone + way * share
    return gone


def speeds_apart(
    name: str, pair: tuple[str, ...], closing: tuple[tuple[Formula, Formula], int], blow: Interval, search: Search
) -> Iterator[Requirement]:
    """Neither apart nor through each other faster than they came, since ½ μ (v² − u²) of that is the energy lost: |v| ≤ u."""
    (approach, parting), ahead = closing
    came, went = approach * ahead, parting * ahead
    words, kept = both_spoken(pair), "the blow gives no energy"
    yield Requirement(
        name, GAINS, came - went, ZERO, kept, f"{words} part faster than they met: no blow gives energy, in"
    )
    if solid(pair, blow, search):
        yield Requirement(name, GAINS, went, ZERO, f"{words} part", f"{words} go through each other in")
    else:
        faster = f"{words} go through each other faster than they met: no blow gives energy, in"
        yield Requirement(name, GAINS, came + went, ZERO, kept, faster)


def both_spoken(pair: tuple[str, ...]) -> str:
    return " and ".join(map(spoken, pair))


def solid(pair: tuple[str, ...], blow: Interval, search: Search) -> bool:
    """Whether two bodies can't go through each other: both lie on something."""
    lying = {item.lying() for item in search.scene.configuration.connections(blow.start)}
    return lying.issuperset(pair)


def keeps_order(
    pair: tuple[str, ...], closing: tuple[Formula, Formula], ahead: int, blow: Interval, search: Search
) -> bool:
    """Whether two bodies stand after a blow as before it; what goes through the other, as a bullet does, is ahead of it from then on."""
    if solid(pair, blow, search):
        return True
    parting = search.apart().settled(closing[1])
    return parting is None or search.numbers.side(search.numbers.with_answers(parting)) != -ahead


def met_by(interval: Interval | None, pair: tuple[str, ...], search: Search) -> bool:
    """Whether two bodies meet in an event."""
    events = interval.event.each() if interval is not None and interval.event is not None else ()
    connections = search.scene.configuration.problem.connections
    return any({ref.owner for ref in event.points(connections)} == set(pair) for event in events)


def ways_apart(pair: tuple[str, ...], blow: Interval, search: Search) -> Iterator[tuple[str, Formula]]:
    """How far the second of two has gone beyond the first, along the first's line, by each state up to the next blow between them."""
    timeline = search.scene.configuration.timeline
    space: Formula = ZERO
    motions = [search.scene.instant(blow.end).motion(name) for name in pair]
    one, two = (motion.heading if motion.kind == "line" and motion.bend is None else None for motion in motions)
    if one is None or two is None or (two - one).sin() != ZERO:
        return
    for interval in timeline.intervals[timeline.order[blow.end] :]:
        again = met_by(timeline.after(interval.end), pair, search)
        if interval.event is None:
            ways = [way_in(name, interval, search) for name in pair]
            if ways[0] is None or ways[1] is None:
                return
            space = space + (two - one).cos() * ways[1] - ways[0]
            if not again:
                yield interval.end, space
        if again:
            return


def untold_barriers(search: Search) -> Iterator[str]:
    """Whether what has bounced off something with an end or a corner meets it again before a state that is asked about."""
    timeline = search.scene.configuration.timeline
    for blow, _, (ref, name, out) in barriers(timeline.intervals, search):
        onward = timeline.intervals[timeline.order[blow.end] :]
        later = [interval.end for interval in onward if interval.event is None and asked_of(interval.end, search)]
        if out is None and later:
            yield f"whether {spoken(ref.owner)} and {spoken(name)} meet again before {spoken(later[-1])}"


def untold_meetings(search: Search) -> Iterator[str]:
    """Whether two that have bounced off each other meet again before a later state that is asked about, where nothing looks at that: along
    a line the laws do, off a rod the assembly, in numbers; what turns otherwise may come round to the other."""
    timeline = search.scene.configuration.timeline
    for blow, closing in pairs_that_meet(search):
        pair, onward = closing.pair, timeline.intervals[timeline.order[blow.end] :]
        again = any(met_by(interval, pair, search) for interval in onward)
        later = [interval.end for interval in onward if interval.event is None and asked_of(interval.end, search)]
        if not later or again:
            continue
        on_line = any(True for _ in ways_apart(pair, blow, search))
        if approaches_between(pair, onward, search) if on_line else comes_round(pair, blow, search):
            yield f"whether {both_spoken(pair)} meet again before {spoken(later[-1])}"


def approaches_between(pair: tuple[str, ...], onward: Sequence[Interval], search: Search) -> bool:
    """Whether two on a line, told in letters, may come nearer and part again within a phase, since what drives one of them varies: their
    gap is known to be open at its ends alone. Numbers are followed on the way."""
    passages = [search.scene.passages[interval.name] for interval in onward if interval.event is None]
    hosts = {search.scene.configuration.host(name, onward[0].start) for name in pair} if onward else set()
    paces = [travel.pace for passage in passages for travel in passage.travels if travel.body in hosts]
    return bool(search.signs.trials) and any(pace != CONSTANT for pace in paces)


def asked_of(state: str, search: Search) -> bool:
    """Whether a question is about a state, or about a letter that what the states tell is to settle."""
    if search.scene.configuration.problem.sought:
        return True
    last = search.scene.configuration.timeline.states[-1].name
    terms = [term for answered in search.answered for term in answered.asked.find.terms]
    named = {name for term in terms for name in (term.at, term.start, term.end, term.during)}
    return state in named or (state == last and None in {term.at or term.start or term.during for term in terms})


def comes_round(pair: tuple[str, ...], blow: Interval, search: Search) -> bool:
    """Whether of two bodies off any line one may come round to the other: not two small or round ones in flight, nor, in numbers, one off a
    rod with nothing at its sides, at which the assembly looks."""
    configuration = search.scene.configuration
    hosts = [configuration.host(name, blow.end) for name in pair]
    members = [[name for name in configuration.bodies if configuration.host(name, blow.end) == host] for host in hosts]
    shapes = [
        [shape_of(body) for name in group if (body := configuration.bodies[name]).shape or body.parts]
        for group in members
    ]
    held = {ref.owner for item in configuration.connections(blow.end) for ref in item.touches()}
    driven = {ref.owner for action in configuration.problem.actions for ref in action.touches()}
    if not (held | driven) & {*members[0], *members[1]}:
        return not all(shape.outer is not None for group in shapes for shape in group)
    rods = [group for group in shapes if any(shape.slender for shape in group)]
    return bool(search.signs.trials) or len(rods) != 1 or len(rods[0]) != 1


def way_in(name: str, interval: Interval, search: Search) -> Formula | None:
    """How far a body goes along its line in a phase."""
    host = search.scene.instant(interval.start).host(name)
    travels = search.scene.passages[interval.name].travels
    return next((item.change for item in travels if (item.body, item.kind, item.axis) == (host, "line", "")), None)


def liftings(search: Search) -> Iterator[tuple[str, tuple[Requirement, ...]]]:
    """What a body obeys that goes round with one to which it has been joined: away from what it lay on, v · n ≥ 0, or a · n ≥ 0 where it
    sets out along that; and not back into it by a later state, (r − r₁) · n ≥ 0."""
    scene, timeline = search.scene, search.scene.configuration.timeline
    for name, contacts in scene.configuration.left.items():
        interval = timeline.interval(name)
        if interval is None:
            continue
        for item in contacts:
            start, first, ref = scene.instant(interval.start), scene.instant(interval.end), item.slider()
            away = item.away(start)
            if away is None:
                continue
            rise = simplify(first.velocity(ref).along(away))
            rise = rise if rise != ZERO else simplify(first.acceleration(ref).along(away))
            lifts, falls = (
                f"{spoken(ref.owner)} leaves what it lay on",
                f"{spoken(ref.owner)} is pressed into what it lies on",
            )
            yield interval.end, (Requirement(name, LIFTS, rise, ZERO, lifts, f"{falls} at"),)
            before = place_of_point(ref, away, first)
            for state in timeline.states[timeline.order[interval.end] + 1 :]:
                now = place_of_point(ref, away, scene.instant(state.name))
                if before is not None and now is not None:
                    back = f"{spoken(ref.owner)} comes back to what it lay on before"
                    yield state.name, (Requirement(name, LIFTS, simplify(now - before), ZERO, lifts, back),)
