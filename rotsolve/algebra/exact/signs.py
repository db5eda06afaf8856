"""Signs: what is known of the sign of a polynomial when some symbols are positive."""

from __future__ import annotations

from collections.abc import Collection

from rotsolve.algebra.exact.field import Field, Poly
from rotsolve.algebra.formula import Call, Constant, Formula, Symbol


class PolynomialSigns:
    """What is known of the signs of a field's polynomials."""

    def __init__(self, ring: Field, positive: Collection[str], acute: Collection[str] = ()) -> None:
        self.field = ring
        self.kinds = [self._kind(atom, positive, acute) for atom in ring.atoms]

    @staticmethod
    def _kind(atom: Formula, positive: Collection[str], acute: Collection[str]) -> str:
        """plus: never negative; bounded: between −1 and 1; any."""
        if isinstance(atom, Constant) or (isinstance(atom, Symbol) and atom.name in positive):
            return "plus"
        if isinstance(atom, Call) and atom.function in ("sqrt", "abs", "exp"):
            return "plus"
        if isinstance(atom, Call) and atom.function in ("sin", "cos"):
            angle = atom.arguments[0]
            return "plus" if isinstance(angle, Symbol) and angle.name in acute else "bounded"
        return "any"

    def nonnegative(self, poly: Poly) -> bool:
        """Whether the polynomial is certainly never negative (a no means: not known)."""
        lows: dict[tuple[int, ...], int] = {}
        for exponents, coefficient in self.field.terms(poly).items():
            split = self._split(exponents)
            if split is None:
                return False
            key, varies, odd = split
            low = min(coefficient, 0) if varies and not odd else -abs(coefficient) if odd else coefficient
            lows[key] = lows.get(key, 0) + low
        return all(low >= 0 for low in lows.values())

    def _split(self, exponents: tuple[int, ...]) -> tuple[tuple[int, ...], bool, bool] | None:
        """The part of a monomial that is never negative, whether a bounded part varies, whether it changes sign."""
        key, varies, odd = list(exponents), False, False
        for i, e in enumerate(exponents):
            if e and self.kinds[i] == "bounded":
                key[i], varies, odd = 0, True, odd or e % 2 == 1
            elif e % 2 and self.kinds[i] == "any":
                return None
        return tuple(key), varies, odd
