"""Letters of a scene: what is given, and the order in which a textbook writes letters in a product, by what they measure."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.algebra.formula import Formula
from rotsolve.algebra.units.dimension import Dimension, product_rank
from rotsolve.core.faults import Span

if TYPE_CHECKING:
    from rotsolve.algebra.units.systems import UnitSystem
    from rotsolve.algebra.units.unit_table import Unit


def letter_order(letters: Iterable[tuple[str, Dimension | None]]) -> tuple[str, ...]:
    """Names in the order of a printed product; equal ranks keep the order in which they come."""
    ranked = [(product_rank(dimension), index, name) for index, (name, dimension) in enumerate(letters)]
    return tuple(name for _, _, name in sorted(ranked))


def leaves_of(item: object) -> Iterator[str | Formula]:
    """All words and formulas in a part of a scene."""
    if isinstance(item, str | Formula):
        yield item
    elif isinstance(item, tuple):
        for part in item:
            yield from leaves_of(part)
    elif isinstance(item, Struct):
        for name in item.__struct_fields__:
            yield from leaves_of(getattr(item, name))


def letters_of(item: object) -> Iterator[str]:
    """All letters in the formulas of a part of a scene: of a question those in its condition and in its options too."""
    for leaf in leaves_of(item):
        yield from leaf.symbols() if isinstance(leaf, Formula) else ()


def system_told(givens: Iterable[Given]) -> UnitSystem | None:
    """The system of units, other than SI, of which all givens are; the standard gravity, which nobody has told, has no say."""
    units = [given.unit for given in givens if not (given.automatic and given.name == "g")]
    if not any(unit is not None and unit.is_foreign for unit in units):
        return None
    from rotsolve.algebra.units.systems import system_of

    return system_of(units)


class Given(Struct, frozen=True):
    """A letter of the scene. `value` is None for a letter without a number; `asked` for `unknown`.

    `value` may hold other givens (`L: 2*R`). `automatic` marks a letter that the reader made for a number written in place
    (`radius: 20 cm`) or for a quantity that the scene leaves out. `text` is the value as written.
    `trial` is the number of a letter without a value at which it is looked what its case is.
    """

    name: str
    value: Formula | None
    dimension: Dimension | None
    unit: Unit | None = None
    text: str = ""
    asked: bool = False
    automatic: bool = False
    span: Span | None = None
    trial: Formula | None = None
