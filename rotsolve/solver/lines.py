"""Lines: what is written of an elimination: the equation with everything put in, then the unknown alone."""

from __future__ import annotations

from collections.abc import Sequence

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.derivation import Equality
from rotsolve.solver.item import Item, isolated


def line_of(item: Item, name: str, value: Formula, more: Sequence[Equality] = ()) -> list[Equality]:
    """The line of an elimination; `more` stands before its result."""
    chain = []
    if item.sources and isolated(item, name) is None:
        chain.append(Equality(item.left, item.right))
    elif item.sources and isolated(item, name) != value:
        chain.append(Equality(Symbol(name), isolated(item, name) or value))
    chain.extend(more)
    result = Equality(Symbol(name), value)
    if not chain or chain[-1] != result:
        chain.append(result)
    return chain


def line_in_letters(item: Item, name: str, first: Sequence[Equality], final: Formula) -> list[Equality]:
    """A line whose `first` equalities are in letters found before, and whose last has them put in."""
    chain = [equality for k, equality in enumerate(first) if k == 0 or equality != first[k - 1]]
    if isolated(item, name) is None and any(ref[0] != "known" for ref in item.sources):
        chain.insert(0, Equality(item.left, item.right))
    return [*chain, Equality(Symbol(name), final)]
