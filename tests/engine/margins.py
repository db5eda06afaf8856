"""Margins: an answer in letters holds just where a plain calculation has something to spare."""

from __future__ import annotations

import random
from collections.abc import Callable, Mapping

import rotsolve
from rotsolve.confirm.course.samples import holding

G = 9.8
Numbers = Mapping[str, float]
SETS = 40


def answered_just_where(text: str, margin: Callable[[Numbers], float]) -> None:
    """The one answer of a scene has a case at just those random numbers at which a margin is not negative; both are met."""
    (answer,) = (view.answer for view in rotsolve.solve(text, confirm=False).answers.values())
    given = [part.split(":")[0].strip() for part in text.split("given: {")[1].split("}")[0].split(",")]
    rng, seen = random.Random(text), set()
    for _ in range(SETS):
        numbers = {letter: rng.uniform(0.05, 1.0) for letter in given}
        numbers |= {letter: rng.uniform(0.5, 5) for letter in given if letter in "FQ"}
        held = margin(numbers) >= 0
        assert (holding(answer, {**numbers, "g": G}) is not None) == held, numbers
        seen.add(held)
    assert seen == {True, False}
