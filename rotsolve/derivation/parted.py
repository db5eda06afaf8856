"""Parted: two bodies that have bounced off each other on a line may not go through each other up to the next blow between them."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.facts import APART, Requirement
from rotsolve.core.writing import spoken
from rotsolve.motion.encounters import participants
from rotsolve.motion.timeline import Interval
from rotsolve.search.search import Search


def partings(search: Search) -> Iterator[tuple[str, tuple[Requirement, ...]]]:
    """By state after a blow: s₂ − s₁ ≥ 0 of the ways since then, where the second was ahead."""
    for name, encounter in search.scene.encounters.items():
        interval = search.scene.configuration.timeline.interval(name)
        if interval is None or encounter.closing is None:
            continue
        pair = meeting_bodies(interval, search)
        closing = search.apart().settled(encounter.closing[0]) if len(pair) == 2 else None
        ahead = search.numbers.side(closing) if closing is not None else None
        for state, space in ways_apart(pair, interval, search) if ahead else ():
            words = " and ".join(map(spoken, pair))
            left = space if ahead == 1 else -space
            yield state, (Requirement(name, APART, left, ZERO, f"{words} stay apart", f"{words} meet again before"),)


def meeting_bodies(interval: Interval | None, search: Search) -> tuple[str, ...]:
    """The bodies that take part in an event."""
    points = participants(interval, search.scene.configuration) if interval is not None else ()
    return tuple(ref.owner for ref in points)


def ways_apart(pair: tuple[str, ...], blow: Interval, search: Search) -> Iterator[tuple[str, Formula]]:
    """How far the second of two has gone beyond the first, along the first's line, by each state up to the next blow between them."""
    timeline = search.scene.configuration.timeline
    space: Formula = ZERO
    motions = [search.scene.instant(blow.end).motion(name) for name in pair]
    one, two = (motion.heading if motion.kind == "line" and motion.bend is None else None for motion in motions)
    if one is None or two is None or (two - one).sin() != ZERO:
        return
    for interval in timeline.intervals[timeline.order[blow.end] :]:
        again = set(meeting_bodies(timeline.after(interval.end), search)) == set(pair)
        if interval.event is None:
            ways = [way_in(name, interval, search) for name in pair]
            if ways[0] is None or ways[1] is None:
                return
            space = space + (two - one).cos() * ways[1] - ways[0]
            if not again:
                yield interval.end, space
        if again:
            return


def way_in(name: str, interval: Interval, search: Search) -> Formula | None:
    """How far a body goes along its line in a phase."""
    host = search.scene.instant(interval.start).host(name)
    travels = search.scene.passages[interval.name].travels
    return next((item.change for item in travels if (item.body, item.kind, item.axis) == (host, "line", "")), None)
