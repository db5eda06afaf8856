"""Verges: where the numbers lie exactly on an edge, so that the least change of them decides what happens."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.formula import ZERO
from rotsolve.core.derivation import Check
from rotsolve.core.varying import POSITION
from rotsolve.core.writing import spoken
from rotsolve.inquiry.inquiry import Inquiry


def nudged(inquiry: Inquiry) -> Iterator[Check]:
    """Motions, driven by their place, that start from rest where nothing pushes: a nudge starts them, and decides which way they go."""
    history, pool = inquiry.history, inquiry.planner.pool
    used = {pool[index].section for answered in inquiry.answered for index in answered.used}
    for name, passage in history.passages.items():
        interval = history.configuration.timeline.interval(name)
        if name not in used or interval is None:
            continue
        for travel in passage.travels:
            if travel.before != ZERO or travel.pace != POSITION:
                continue
            push = inquiry.numbers.push(travel.initial)
            if push is not None and inquiry.numbers.side(push) == 0:
                state = spoken(interval.start) or "the start"
                words = f"nothing moves {spoken(travel.body)} from rest at {state}: the least push decides which way it goes"
                yield Check((words,), None)
                break
