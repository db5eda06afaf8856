"""Linear: equations that are linear in some letters, solved on the tape: first for what constants tell, the rest at every moment anew."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from functools import reduce

from msgspec import Struct

from rotsolve.algebra.exact.angles import coupled
from rotsolve.algebra.formula import Formula, Negative, Product, Quotient, Sum, Symbol
from rotsolve.algebra.tape import ONE, ZERO, Unwritable
from rotsolve.simulation.harmonics import fewer_products
from rotsolve.simulation.tape import Block, SeriesTape, vanishes

REST = ""  # stands for the part without unknowns
Row = dict[str, int]  # unknown -> place of its coefficient; REST -> place of the rest; they add up to zero


class Contradictory(ValueError):
    """The equations contradict each other; tells which of them."""

    def __init__(self, equation: int) -> None:
        super().__init__(str(equation))
        self.equation = equation


class Linear(Struct):
    """Equations on a tape; `letters` are the places of all that is known, `rough` tells about how large a value is at first."""

    tape: SeriesTape
    letters: Mapping[str, int]
    rough: Callable[[int], float]

    def row(self, formula: Formula, unknowns: Collection[str]) -> Row:
        """A formula as a row: Σ coefficient · unknown + rest."""
        if not formula.symbols() & set(unknowns):
            return self._tidied({REST: self.tape.formula(formula, self.letters)})
        match formula:
            case Symbol(name):
                return {name: self.tape.number(ONE)}
            case Sum(terms):
                return self.added([(self.row(term, unknowns), self.tape.number(ONE)) for term in terms])
            case Negative(operand):
                return self.added([(self.row(operand, unknowns), self.tape.number(-ONE))])
            case Quotient(above, below) if not below.symbols() & set(unknowns):
                under = self.tape.formula(below, self.letters)
                return {name: self.tape.over(value, under) for name, value in self.row(above, unknowns).items()}
            case Product(factors):
                holding = [factor for factor in factors if factor.symbols() & set(unknowns)]
                if len(holding) == 1:
                    front = (self.tape.formula(item, self.letters) for item in factors if item is not holding[0])
                    weight = reduce(self.tape.times, front, self.tape.number(ONE))
                    return self.added([(self.row(holding[0], unknowns), weight)])
        raise Unwritable("a law in which a force or acceleration does not stand by itself")

    def added(self, weighted: Sequence[tuple[Row, int]]) -> Row:
        """Σ weight · row."""
        collected: dict[str, list[int]] = {}
        for row, weight in weighted:
            for name, value in row.items():
                collected.setdefault(name, []).append(self.tape.times(value, weight))
        return self._tidied({name: self.tape.add(*values) for name, values in collected.items()})

    def _tidied(self, row: Row) -> Row:
        def zero(place: int) -> bool:
            number = self.tape.constant(place)
            return number is not None and vanishes(number)

        return {name: place for name, place in row.items() if not zero(place)}

    def solve(self, rows: Sequence[Row], late: Mapping[str, int]) -> dict[str, int]:
        """All unknowns that the equations tell; the late ones are left to the end, the latest of them last."""
        told, left = self.eliminated(rows, late)
        return self.put_in(told, self._together(left))

    def in_terms_of_free(
        self, rows: Sequence[Row], late: Mapping[str, int], free: Callable[[str], int]
    ) -> dict[str, int]:
        """All unknowns by those that the equations leave free, whose values `free` tells; the late ones rather stay free."""
        told, left = self.eliminated(rows, late)
        while left:
            _, row = left[0]
            name = max((name for name in row if name != REST), key=lambda name: abs(self.rough(row[name])))
            solved = self._for(row, name)
            told.append((name, solved))
            left = [(other, self._without(item, name, solved)) for other, item in left[1:]]
            left = [(number, row) for number, row in left if self._says(number, row)]
        names = {name for _, row in told for name in row if name != REST} - {name for name, _ in told}
        return self.put_in(told, {name: free(name) for name in sorted(names)})

    def eliminated(
        self, rows: Sequence[Row], late: Mapping[str, int]
    ) -> tuple[list[tuple[str, Row]], list[tuple[int, Row]]]:
        """Unknowns told by equations with a constant in front of them, one after the other, and the equations that are left."""
        told: list[tuple[str, Row]] = []
        left = [(number, dict(row)) for number, row in enumerate(rows)]
        while True:
            left = [(number, row) for number, row in left if self._says(number, row)]
            found = self._pivot(left, late)
            if found is None:
                return told, left
            index, name = found
            solved = self._for(left.pop(index)[1], name)
            told.append((name, solved))
            left = [(other, self._without(item, name, solved)) for other, item in left]

    def put_in(self, told: list[tuple[str, Row]], known: dict[str, int]) -> dict[str, int]:
        """The unknowns told one after the other, from the last one back, as far as what they depend on is known."""
        for name, row in reversed(told):
            if all(other in known for other in row if other != REST):
                parts = [self.tape.times(known[other], place) for other, place in row.items() if other != REST]
                known[name] = self.tape.add(*parts, row.get(REST, self.tape.number(ZERO)))
        return known

    def _says(self, number: int, row: Row) -> bool:
        """Whether a row still says something; a rest that is not zero contradicts."""
        if any(name != REST for name in row):
            return True
        if REST in row and abs(self.rough(row[REST])) > 1e-9:
            raise Contradictory(number)
        return False

    def _pivot(self, left: list[tuple[int, Row]], late: Mapping[str, int]) -> tuple[int, str] | None:
        """A row and an unknown with a constant coefficient, such that few other rows grow by it."""
        counts: dict[str, int] = {}
        for _, row in left:
            for name in row:
                counts[name] = counts.get(name, 0) + 1
        best: tuple[tuple[int, int, int], int, str] | None = None
        for index, (_, row) in enumerate(left):
            for name, place in row.items():
                if name != REST and self.tape.constant(place) is not None:
                    price = (late.get(name, 0), (len(row) - 1) * (counts[name] - 1), len(row))
                    if best is None or price < best[0]:
                        best = (price, index, name)
        return None if best is None else (best[1], best[2])

    def _for(self, row: Row, name: str) -> Row:
        """The row solved for an unknown: the others, with what stands in front of them."""
        pivot = row[name]
        return {
            other: self.tape.scaled(self.tape.over(place, pivot), -ONE) for other, place in row.items() if other != name
        }

    def _without(self, row: Row, name: str, solved: Row) -> Row:
        """A row with an unknown put in."""
        if name not in row:
            return row
        rest = {other: place for other, place in row.items() if other != name}
        return self.added([(rest, self.tape.number(ONE)), (solved, row[name])])

    def _together(self, left: list[tuple[int, Row]]) -> dict[str, int]:
        """The unknowns of equations with changing coefficients, block by block; none of a block that does not tell all its own."""
        known: dict[str, int] = {}
        for rows in coupled((row for _, row in left), lambda row: row.keys() - {REST}):
            names = sorted({name for row in rows for name in row if name != REST})
            if len(names) != len(rows):
                continue
            zero, size = self.tape.number(ZERO), len(rows) + 1
            entries = fewer_products(self.tape, [row.get(name, zero) for row in rows for name in (*names, REST)])
            table = [entries[k : k + size] for k in range(0, len(entries), size)]
            right = tuple(self.tape.scaled(row[-1], -ONE) for row in table)
            if len(names) == 1:
                known[names[0]] = self.tape.over(right[0], table[0][0])
                continue
            block = Block(tuple(tuple(row[:-1]) for row in table), right)
            known.update(zip(names, self.tape.unknowns(block), strict=True))
        return known
