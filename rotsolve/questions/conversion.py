"""Conversion: the value of a given in another unit, by how much one unit is of the other: 1° = π/180 rad."""

from __future__ import annotations

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE
from rotsolve.algebra.units.quantities import in_unit
from rotsolve.core.derivation import Words
from rotsolve.language.problem import Find, Given


def conversion(find: Find, given: Given) -> Words:
    """1° = π/180 rad, so 15 · π/180 rad = π/12 rad; nothing where the unit stays."""
    old, new = given.unit, find.unit
    if given.value is None or given.value.symbols() or old is None or new is None or old.factor == new.factor:
        return ()
    number, factor = in_unit(given.value, old), simplify(in_unit(old.factor, new))
    unit = new.after("")
    known: Words = (f"{old.after('1')} = ", factor, unit)
    if number == ONE:
        return known
    return (*known, ": ", number, " · ", factor, unit, " = ", simplify(number * factor), unit)
