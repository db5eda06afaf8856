"""Effort: how much work a scene may take, counted in steps that are the same on every machine, so that every scene ends.

A step is what takes about as long as solving one short equation. What runs out of them is caught by none that try one way after another.
"""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager
from threading import Lock

GARBAGE = 100_000  # new objects after which Python may look for cycles among them; solving makes few


class Exhausted(Exception):
    """The work that was allowed has been done, and there is no answer yet.

    `done` are the names of the questions that were answered with half of it, `stuck` is the one that was looked at then.
    """

    done: tuple[str, ...] = ()
    stuck: str = ""


class Purse:
    """The steps that are left; None where they are not counted."""

    left: int | None = None


def exert(steps: int) -> None:
    """Count some steps; Exhausted where no more are left."""
    if Purse.left is not None:
        Purse.left -= steps
        if Purse.left < 0:
            raise Exhausted


@contextmanager
def at_most(steps: int | None) -> Iterator[None]:
    """No more than some steps within, however many are left around; None: as many as it takes."""
    before, Purse.left = Purse.left, steps
    try:
        yield
    finally:
        Purse.left = before


class Collecting:
    """Who is at work, in any thread, and how often Python looked for cycles before."""

    lock = Lock()
    workers = 0
    before = (0, 0, 0)


@contextmanager
def rarely_collecting() -> Iterator[None]:
    """Python looks for cycles less often within: each time it looks through all that is remembered. After it as before.

    Where it is told to look less often, or not at all, that stays.
    """
    with Collecting.lock:
        Collecting.workers += 1
        if Collecting.workers == 1:
            first, *others = Collecting.before = gc.get_threshold()
            gc.set_threshold(max(first, GARBAGE) if first else 0, *others)
    try:
        yield
    finally:
        with Collecting.lock:
            Collecting.workers -= 1
            if not Collecting.workers:
                gc.set_threshold(*Collecting.before)


class Allowance:
    """Steps for several pieces of work together."""

    def __init__(self, steps: int) -> None:
        self.steps = steps

    @contextmanager
    def used(self, parts: int = 1) -> Iterator[None]:
        """No more than what is left of them within, or one of so many equal parts of it."""
        lent = self.steps // parts
        with at_most(lent):
            try:
                yield
            finally:
                self.steps -= lent - max(Purse.left or 0, 0)
