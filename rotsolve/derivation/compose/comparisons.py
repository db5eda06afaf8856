"""Comparisons: why a choice falls as it does, one line for each option."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.notation.letters import name_to_text
from rotsolve.core.derivation import Equality, Move, Words
from rotsolve.derivation.compose.result import Results
from rotsolve.search.answers import Answered, Chosen


def comparisons(chosen: Chosen, results: Results) -> Iterator[Move]:
    """δ_c > π (4 rad > 3.142 rad), with the label in front."""
    alone = len(results.search.chosen) == 1
    for verdict in chosen.verdicts:
        name = verdict.label if alone else f"{verdict.label} ({name_to_text(chosen.find.name)})"
        for item in verdict.compared:
            numbers = (*results.amount(item.left), f" {item.relation} ", *results.amount(item.right))
            chain = (Equality(written(item.left, results), written(item.right, results), item.relation),)
            yield Move(name, chain, None, numbers if told(numbers) else ())


def written(answered: Answered, results: Results) -> Formula:
    """A compared quantity as the derivation writes it: by its letter, or the givens that it is made of."""
    asked = answered.asked
    return results.letters.printed(asked.formula if asked.of_givens else Symbol(asked.letter))


def told(numbers: Words) -> bool:
    return all(isinstance(word, str) for word in numbers)
