"""Sequence: in which order questions are answered, whatever the order in which a scene asks them: in that of time."""

from __future__ import annotations

from collections.abc import Sequence

from rotsolve.core.letters import letters_of
from rotsolve.language.problem import Find, Term
from rotsolve.motion.timeline import Timeline


def in_sequence(finds: Sequence[Find], timeline: Timeline) -> list[Find]:
    """The questions in the order in which they are answered, each behind those that it names; as they are where one seeks a letter, an
    extremum or a label."""
    if len(finds) < 2 or any(find.where is not None or find.extreme or find.choice is not None for find in finds):
        return list(finds)
    places: dict[str, int] = {}
    for find in finds:
        named = [places[name] for name in letters_of(find) if name in places]
        places[find.name] = max([place_in_time(find, timeline), *named])
    return sorted(finds, key=lambda find: places[find.name])


def place_in_time(find: Find, timeline: Timeline) -> int:
    """The place in time of the last state of which a question speaks."""
    moments = [timeline.order.get(name, 0) for term in find.terms for name in states_spoken_of(term, timeline)]
    return max(moments, default=0)


def states_spoken_of(term: Term, timeline: Timeline) -> list[str]:
    """The states of which a term speaks, the last one of a phase or an event for that."""
    spans = [one.end for one in timeline.intervals if term.during is not None and term.during in (one.name, one.whole)]
    return [name for name in (term.at, term.start, term.end, *spans) if name is not None]
