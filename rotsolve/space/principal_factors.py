"""Ground of principal moments and axes: det(I − λ 1) = 0 in the factors of which the moments are roots, as a remark beside each."""

from __future__ import annotations

from functools import reduce

from rotsolve.algebra.formula import Formula, Symbol, add, multiply, negate
from rotsolve.core.derivation import Words
from rotsolve.core.facts import square
from rotsolve.core.vectors.tensor import ENTRIES, InertiaTensor
from rotsolve.core.writing import with_powers
from rotsolve.space.principal import (
    BESIDE,
    MOMENT,
    ToldTensor,
    all_alike,
    bare_axes,
    cubic_factors,
    told_rows,
)

ROOT = Symbol("lambda")
MOMENTS, PRODUCTS_OF = ENTRIES[:3], ENTRIES[3:]


def in_factors(told: ToldTensor) -> Words:
    """det(I − λ 1) = 0 in factors, with what makes it so; nothing where the tensor is diagonal as it stands, where its cubic has no
    factors, or where the scene has a λ of its own."""
    tensor, free = told.tensor, bare_axes(told)
    if len(free) == len(MOMENTS) or any(
        ROOT.name in told.tensors.put_in(tensor.entry(word)).symbols() for word in ENTRIES
    ):
        return ()
    if free:
        return across_axis(told, free[0]), " = 0"
    if all_alike(told):
        return of_alike(tensor)
    factors = cubic_factors(told_rows(told))
    each = [part.substitute({MOMENT: ROOT}) for part, e in factors for _ in range(e)]
    return (with_powers(reduce(multiply, each)), " = 0") if len(each) > 1 else ()


def across_axis(told: ToldTensor, axis: str) -> Formula:
    """(I_c − λ) ((I_a − λ) (I_b − λ) − I_ab²); of long entries in their letters."""
    entries = [told.tensor.entry(word) for word in BESIDE[axis]]
    one, other, product = entries if told.long else map(told.spelled, entries)
    pair = add(with_powers(multiply(less_root(one), less_root(other))), negate(square(product)))
    return multiply(less_root(told.tensor.entry(axis * 2)), pair)


def of_alike(tensor: InertiaTensor) -> Words:
    """(I_xx + 2 I_xy − λ) (I_xx − I_xy − λ)² = 0 of three moments that are alike, as their products are."""
    lone, other = add(tensor.xx, 2 * tensor.xy), add(tensor.xx, negate(tensor.xy))
    whole = multiply(less_root(lone), less_root(other) ** 2)
    alike = [dict.fromkeys(tensor.entry(word) for word in words) for words in (MOMENTS, PRODUCTS_OF)]
    said: list[str | Formula] = []
    for row in alike:
        equal = [part for entry in row for part in (" = ", entry)][1:]
        said += [", " if said else ", as ", *equal] if len(row) > 1 else []
    return (whole, " = 0", *said)


def less_root(moment: Formula) -> Formula:
    """I − λ."""
    return add(moment, negate(ROOT))
