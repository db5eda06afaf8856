"""Variants: the same problem with other values of its givens, drawn by a seed, all different as long as there are such.

The order of a seed is the same with every Python and on every machine: of `random.Random` only `random()` is called, of which Python
promises that its numbers stay as they are for a seed. Its 53 bits become a number below n by exact arithmetic alone.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import cycle, islice
from math import prod
from random import Random

from msgspec import Struct, field

from rotsolve.algebra.units.quantities import parse_quantity
from rotsolve.core.faults import Unsolvable
from rotsolve.keys.working import Unsuited, VariantSolver, Worked, sign_at
from rotsolve.language.problem import Problem, Variation

PATIENCE = 1000  # sets of values one after the other that can not be used, before it is given up
BITS = 53  # of a number that `random()` gives
SPARE = 32  # bits beyond those that a number has, so that all are as likely as each other to one part in 2³²


class Variant(Struct, frozen=True):
    """One variant: its number from 1 on, and its values as for `rotsolve solve --set`; `repeats` where no new one was left."""

    number: int
    settings: Mapping[str, str] = field(default_factory=dict)
    repeats: int | None = None


def variants(problem: Problem, count: int, seed: int) -> Iterator[Variant]:
    """The first variants of a problem for a seed; Unsolvable where it has none."""
    return (variant for variant, _ in worked_variants(problem, count, seed))


def worked_variants(problem: Problem, count: int, seed: int) -> Iterator[tuple[Variant, Worked]]:
    """The variants with their answers; once there are no more different ones, they come again in the same order."""
    solver = VariantSolver(problem)
    found: list[Variant] = []
    for number, (settings, worked) in enumerate(islice(usable_settings(solver, seed), count), 1):
        found.append(Variant(number, settings))
        yield found[-1], worked
    for number, variant in zip(range(len(found) + 1, count + 1), cycle(found), strict=False):
        yield Variant(number, variant.settings, variant.number), solver.work(variant.settings)


def usable_settings(solver: VariantSolver, seed: int) -> Iterator[tuple[dict[str, str], Worked]]:
    """The different settings that can be used, with their answers."""
    problem = solver.problem
    if problem.vary is None:
        try:
            yield {}, solver.work({})
        except Unsuited as error:
            raise Unsolvable(str(error), file=problem.file) from None
        return
    failures, reason, none = 0, "", True
    for settings in all_settings(problem.vary, seed):
        try:
            check_conditions(problem, settings)
            worked = solver.work(settings)
        except Unsuited as error:
            failures, reason = failures + 1, str(error)
            if failures == PATIENCE:
                break
        else:
            failures, none = 0, False
            yield settings, worked
    if none:
        message = f"none of {failures} sets of values can be used; of the last: {reason}"
        raise Unsolvable(message, help="choose other ranges under `vary`, or other conditions", file=problem.file)


def all_settings(vary: Variation, seed: int) -> Iterator[dict[str, str]]:
    """All sets of values, each once, in the order of the seed; the first letter of the file changes slowest in their numbering."""
    for index in shuffled(prod(len(letter.values) for letter in vary.letters), seed):
        settings: dict[str, str] = {}
        for letter in reversed(vary.letters):
            index, place = divmod(index, len(letter.values))
            settings[letter.name] = letter.values[place]
        yield {letter.name: settings[letter.name] for letter in vary.letters}


def check_conditions(problem: Problem, settings: Mapping[str, str]) -> None:
    """Whether the conditions of `where` hold."""
    assert problem.vary is not None
    if problem.vary.conditions:
        values = problem.values | {name: parse_quantity(text).value for name, text in settings.items()}
        for condition in problem.vary.conditions:
            if sign_at(condition.gap, values) not in condition.signs:
                raise Unsuited(f"`{condition.text}` does not hold")


def shuffled(size: int, seed: int) -> Iterator[int]:
    """0, …, size − 1 in a random order (Fisher and Yates); what has not been exchanged yet takes no memory."""
    generator = Random(seed)
    moved: dict[int, int] = {}
    for first in range(size):
        drawn = first + random_below(size - first, generator)
        left = moved.pop(first, first)
        if drawn == first:
            yield left
        else:
            yield moved.get(drawn, drawn)
            moved[drawn] = left


def random_below(n: int, generator: Random) -> int:
    """A number from 0 to n − 1: ⌊n x⌋ where the binary digits of x come from `random()`."""
    words = (n.bit_length() + SPARE) // BITS + 1
    digits = 0
    for _ in range(words):
        digits = digits << BITS | int(generator.random() * 2**BITS)
    return digits * n >> words * BITS
