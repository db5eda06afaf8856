"""Plan: which equations of a pool settle an asked unknown, or why none do. Knows no physics.

The cheapest ones, as `matching` finds them. No equation tells what stands within an integral of it.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence
from collections.abc import Set as AbstractSet

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.effort import exert
from rotsolve.algebra.formula import Sum, Symbol
from rotsolve.core.equation import Equation
from rotsolve.matching import Candidate, Matching, Plan, cheapest_plan, needed, solvable_for

# what a definition costs more once it has been used: it leads from what an answer is made of to the answer
BACKWARDS = 6
PATIENCE = 2_000_000  # work for plans of a scene that are made only to avoid equations of constant acceleration: pairs of equations


def alike_to_plans(one: Equation, other: Equation, known: AbstractSet[str]) -> bool:
    """Whether all is the same of two equations of which a plan is made, so that it can't tell them apart where some letters are known."""
    if replace(one, left=other.left, right=other.right, common=other.common) != other:
        return False
    sides = ((one.left, other.left), (one.right, other.right))
    if (
        any(mine.symbols() - known != yours.symbols() - known for mine, yours in sides)
        or one.summed() != other.summed()
    ):
        return False
    return all(type(mine) is type(yours) and mine.holds(Sum) == yours.holds(Sum) for mine, yours in sides)


class Shortage(Struct, frozen=True):
    """Why there is no plan: the equations that bear on the asked unknown, and the unknowns that they leave open."""

    asked: str
    equations: tuple[int, ...]
    unknowns: tuple[str, ...]


class Planner:
    """Plans over one pool of equations; what is known may grow between questions.

    `constants` are unknowns that never run: an integral tells them through what stands within it.
    """

    def __init__(self, pool: Sequence[Equation], constants: Collection[str] = ()) -> None:
        self.constants = frozenset(constants)
        self.pool: list[Equation] = []
        self.symbols: list[frozenset[str]] = []
        self.summed: list[frozenset[str]] = []
        self.alone: list[frozenset[str]] = []  # letters that are a whole side
        self.plain: set[int] = set()  # one term equals another: a = R α
        self.dear: set[int] = set()  # definitions of what has been answered: the last way to what they are made of
        self.patience = [PATIENCE]  # one for all that plan over the same pool
        self.found: dict[object, Plan | None] = {}  # by all that a plan depends on: many searches come to the same
        for equation in pool:
            self.extend(equation)

    def afresh(self) -> Planner:
        """A planner over the same pool, which others extend in other ways."""
        other = Planner((), self.constants)
        other.pool, other.symbols = list(self.pool), list(self.symbols)
        other.patience = self.patience
        other.summed, other.alone, other.plain = list(self.summed), list(self.alone), set(self.plain)
        return other

    def extend(self, equation: Equation) -> int:
        """Add an equation found on the way; its index."""
        self.pool.append(equation)
        self.symbols.append(equation.symbols())
        self.summed.append(equation.summed())
        sides = (equation.left, equation.right)
        self.alone.append(frozenset(side.name for side in sides if isinstance(side, Symbol)))
        index = len(self.pool) - 1
        if not any(side.holds(Sum) for side in sides):
            self.plain.add(index)
        return index

    def plan(self, asked: str, known: Collection[str], allowed: Collection[int] | None = None) -> Plan | Shortage:
        """The cheapest plan for `asked`, with the equations `allowed`; why there is none where there is none."""
        unknowns = self.unknowns(known, range(len(self.pool)) if allowed is None else allowed)
        return self.cheapest(asked, unknowns) or self._shortage(asked, self._relevant(asked, unknowns))

    def unknowns(self, known: Collection[str], indices: Iterable[int]) -> dict[int, tuple[str, ...]]:
        """What equations hold that is not known."""
        given, symbols = frozenset(known), self.symbols
        return {index: tuple(sorted(symbols[index] - given)) for index in indices}

    def cheapest(self, asked: str, unknowns: Mapping[int, tuple[str, ...]]) -> Plan | None:
        """The cheapest plan for `asked` with some equations, of which the unknowns are told; None where there is none."""
        key = (asked, tuple(unknowns.items()), len(self.dear))
        if key not in self.found:
            relevant = self._relevant(asked, unknowns)
            inner = (asked, tuple(relevant.items()), len(self.dear))
            if inner not in self.found:
                self.found[inner] = self._cheapest(asked, relevant)
            self.found[key] = self.found[inner]
        return self.found[key]

    def _cheapest(self, asked: str, relevant: Mapping[int, tuple[str, ...]]) -> Plan | None:
        """By what alone tells it: the equations as numbered among themselves, so that one plan does for all cases of a scene."""
        indices = sorted(relevant)
        number = {index: place for place, index in enumerate(indices)}
        rows = tuple(
            Candidate(number[index], names, self._cost(index), self.summed[index]) for index, names in relevant.items()
        )
        plan, work = cheapest_plan(asked, rows, self.constants if any(row.summed for row in rows) else frozenset())
        exert(work)
        return None if plan is None else replace(plan, equations=tuple(indices[place] for place in plan.equations))

    def _relevant(self, asked: str, unknowns: Mapping[int, tuple[str, ...]]) -> dict[int, tuple[str, ...]]:
        """The usable equations that share unknowns with the asked one, directly or through others; the best ones first."""
        holders: dict[str, list[int]] = {}
        for index, names in unknowns.items():
            for name in names:
                holders.setdefault(name, []).append(index)
        found: dict[int, tuple[str, ...]] = {}
        seen, pending = {asked}, [asked]
        while pending:
            for index in holders.get(pending.pop(), ()):
                if index not in found:
                    found[index] = unknowns[index]
                    fresh = [name for name in unknowns[index] if name not in seen]
                    seen.update(fresh)
                    pending.extend(fresh)
        return self._usable(dict(sorted(found.items(), key=lambda item: self._rank(*item))))

    def _rank(self, index: int, names: tuple[str, ...]) -> tuple[int, ...]:
        """The cheapest first, with the fewest unknowns; of those that tell one unknown those where one term equals another; then
        laws in which an unknown stands alone, as in N = m g."""
        alone = self.pool[index].cost == 0 or not self.alone[index].isdisjoint(names)
        plain = len(names) > 1 or index in self.plain
        return self._cost(index), len(names), not plain, not alone, index

    def _cost(self, index: int) -> int:
        return self.pool[index].cost + (BACKWARDS if index in self.dear else 0)

    def _usable(self, unknowns: dict[int, tuple[str, ...]]) -> dict[int, tuple[str, ...]]:
        """Without the equations that sum over something which none of the others tells."""
        while any(self.summed[index] for index in unknowns):
            told = {name for index, names in unknowns.items() for name in names if name not in self.summed[index]}
            kept = {index: names for index, names in unknowns.items() if self.summed[index] & set(names) <= told}
            if len(kept) == len(unknowns):
                return kept
            unknowns = kept
        return unknowns

    def _shortage(self, asked: str, unknowns: Mapping[int, tuple[str, ...]]) -> Shortage:
        """The block with fewer equations than unknowns: all that alternating paths reach from the unknowns that got no equation."""
        summed = {index: self.summed[index] for index in unknowns}
        owner = Matching(solvable_for(unknowns, summed, self.constants)).owner
        own = {index: name for name, index in owner.items()}
        pending = needed(asked, unknowns, owner)[1]
        names, equations = {asked, *pending}, set[int]()
        while pending:
            name = pending.pop()
            for index, held in unknowns.items():
                if name in held and index in own and index not in equations:
                    equations.add(index)
                    if own[index] not in names:
                        names.add(own[index])
                        pending.append(own[index])
        return Shortage(asked, tuple(sorted(equations)), tuple(sorted(names)))
