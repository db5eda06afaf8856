"""Openings: how long it takes to the states that the scene does not name, and how fast all moves at both ends of a phase."""

from __future__ import annotations

from contextlib import suppress

from rotsolve.core.symbols import is_quantity
from rotsolve.motion.timeline import Interval
from rotsolve.search.answers import NoAnswer
from rotsolve.search.search import Search, asked_letter


def tell_openings(search: Search) -> None:
    """Work out how long it takes to the states that the scene does not name, and how fast all moves then: the next phase begins so."""
    for interval in search.scene.configuration.timeline.intervals:
        if search.scene.configuration.timeline.state(interval.end).opened:
            tell_ends(search, interval)


def tell_ends(search: Search, interval: Interval) -> None:
    """The speeds at both ends of a phase, and how long it takes, as far as the laws of a search tell them."""
    passage = search.scene.passages[interval.name]
    speeds = [speed for travel in passage.travels for speed in (travel.before, travel.after)]
    for value in (*speeds[::2], passage.duration, *speeds[1::2]):
        if is_quantity(value) and value.name not in search.solver.solved:
            with suppress(NoAnswer):
                search.answer(asked_letter(value.name), aside=True)
