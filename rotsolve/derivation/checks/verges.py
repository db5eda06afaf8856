"""Verges: where the numbers lie exactly on an edge, so that the least change of them decides what happens."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.formula import ZERO
from rotsolve.core.derivation import Check
from rotsolve.core.varying import POSITION
from rotsolve.core.writing import spoken
from rotsolve.search.search import Search


def nudged(search: Search) -> Iterator[Check]:
    """Motions, driven by their place, that start from rest where nothing pushes: a nudge starts them, and decides which way they go."""
    scene, pool = search.scene, search.planner.pool
    used = {pool[index].section for answered in search.answered for index in answered.used}
    for name, passage in scene.passages.items():
        interval = scene.configuration.timeline.interval(name)
        if name not in used or interval is None:
            continue
        for travel in passage.travels:
            if travel.before != ZERO or travel.pace != POSITION:
                continue
            push = search.numbers.push(travel.initial)
            if push is not None and search.numbers.side(push) == 0:
                state = spoken(interval.start) or "the start"
                words = f"nothing moves {spoken(travel.body)} from rest at {state}: the least push decides which way it goes"
                yield Check((words,), None)
                break
