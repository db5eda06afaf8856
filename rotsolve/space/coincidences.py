"""Coincidences: what the numbers of a scene make special, so that laws take another form: letters of one value, a level axis."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.units.dimension import Dimension
from rotsolve.core.derivation import Words
from rotsolve.language.problem import Given


def coincidences(signs: SignOracle, givens: Sequence[Given]) -> Iterator[Words]:
    """The letters that had to have one value, then what else vanishes by the numbers alone, of all on which the laws of a scene hang."""
    kinds = {given.name: given.dimension for given in givens}
    special = [value for value, sign in signs.decided.items() if not sign]
    alike: dict[str, Formula] = {}
    for value in special:
        if not is_zero(value.substitute(alike)):
            alike |= like_letters(sorted(value.symbols() - alike.keys()), signs, kinds)
    for first in dict.fromkeys(alike.values()):
        told: list[str | Formula] = ["with the numbers of the scene ", first]
        told += [part for name, own in alike.items() if own == first for part in (" = ", Symbol(name))]
        yield tuple(told)
    others = dict.fromkeys(simplify(value.substitute(alike)) for value in special)
    for value in (value for value in others if not is_zero(value)):
        name, *more = value.symbols()
        level = simplify(Symbol(name) - value)
        alone = not more and not level.symbols()
        yield ("with the numbers of the scene ", *((Symbol(name), " = ", level) if alone else (value, " = 0")))


def like_letters(names: list[str], signs: SignOracle, kinds: Mapping[str, Dimension | None]) -> dict[str, Formula]:
    """Letters that have the value of one of their kind that stands before them, each with that."""
    found: dict[str, Formula] = {}
    for number, name in enumerate(names):
        before = (
            Symbol(other) for other in names[:number] if other not in found and kinds.get(other) == kinds.get(name)
        )
        same = next((own for own in before if signs.by_numbers(Symbol(name) - own) == 0), None)
        if same is not None:
            found[name] = same
    return found
