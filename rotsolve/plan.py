"""Plan: the cheapest set of equations that settles an asked unknown. Knows no physics.

Equations are matched to unknowns in the order of their cost (a transversal matroid, so the greedy choice is the cheapest maximal one);
the block behind the asked unknown is what its matched equation needs (Dulmage-Mendelsohn). Then each equation of the block is tried
for omission, since a dearer one elsewhere may make several cheap ones needless. No equation tells what stands within an integral of it.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping, Sequence

from msgspec import Struct

from rotsolve.algebra.effort import exert
from rotsolve.algebra.formula import Sum, Symbol
from rotsolve.core.equation import Equation

# what a definition costs more once it has been used: it leads from what an answer is made of to the answer
BACKWARDS = 6
PATIENCE = 2_000_000  # work for plans of a scene that are made only to avoid equations of constant acceleration: pairs of equations
BLOCKS_A_STEP = 12  # of equations that are left out, each in its turn
ROUNDS = 12  # improvements after which a plan is taken as it is


class Plan(Struct, frozen=True):
    """Equations (indices into the pool) that settle `asked`, and the unknowns that they settle with it."""

    asked: str
    equations: tuple[int, ...]
    unknowns: tuple[str, ...]
    cost: int


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
        given = frozenset(known)
        return {index: tuple(sorted(self.symbols[index] - given)) for index in indices}

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
        best = self._block(asked, relevant, Matching(self._told(relevant)).owner)
        if best is None:
            return None
        chained = self._chain(asked, relevant)
        plans = [self._improved(best, relevant), *([chained] if chained is not None else [])]
        return min(plans, key=lambda plan: plan.cost)

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

    def _block(self, asked: str, unknowns: Mapping[int, tuple[str, ...]], owner: Mapping[str, int]) -> Plan | None:
        """Collect what the asked unknown's equation needs; None where one of that has no equation."""
        names, open_ = needed(asked, unknowns, owner)
        if open_:
            return None
        equations = sorted(owner[name] for name in names)
        return Plan(asked, tuple(equations), tuple(sorted(names)), sum(map(self._cost, equations)))

    def _told(self, unknowns: Mapping[int, tuple[str, ...]]) -> Mapping[int, tuple[str, ...]]:
        """What each equation may be solved for: what it does not sum over; else a constant on which that depends."""
        if not any(self.summed[index] for index in unknowns):
            return unknowns
        told = dict(unknowns)
        for index in told:
            if summed := self.summed[index]:
                told[index] = tuple(name for name in told[index] if name not in summed)
        for index, names in unknowns.items():
            if names and not told[index] and self.constants:
                told[index] = self._behind(names, unknowns)
        return told

    def _behind(self, names: Sequence[str], unknowns: Mapping[int, tuple[str, ...]]) -> tuple[str, ...]:
        """The constants in the equations that tell some unknowns, or what these depend on."""
        seen, pending = set(names), list(names)
        while pending:
            name = pending.pop()
            fresh = {other for held in unknowns.values() if name in held for other in held} - seen
            seen |= fresh
            pending.extend(fresh - self.constants)
        return tuple(sorted(seen & self.constants))

    def _chain(self, asked: str, unknowns: Mapping[int, tuple[str, ...]]) -> Plan | None:
        """The cheapest plan that settles one unknown after the other, none together; None where there is no such plan.

        Costs spread from what one equation settles alone (as in Knuth's generalisation of Dijkstra's algorithm); equations that
        several unknowns need are counted once.
        """
        ways: dict[str, tuple[int, frozenset[int]]] = {}
        costs = {index: self._cost(index) for index in unknowns}
        clock, changed, looked_at = 0, dict[str, int](), dict[int, int]()  # when a way was found, an equation looked at
        for _ in range(ROUNDS):
            before = clock
            for index, names in unknowns.items():
                missing = [name for name in names if name not in ways]
                if len(missing) > 1 or all(changed.get(name, 0) <= looked_at.get(index, -1) for name in names):
                    continue
                for name in (one for one in missing or names if one not in self.summed[index]):
                    used = frozenset((index,)).union(*(ways[other][1] for other in names if other != name))
                    cost = sum(map(costs.__getitem__, used))
                    if name not in ways or cost < ways[name][0]:
                        clock += 1
                        ways[name], changed[name] = (cost, used), clock
                looked_at[index] = clock
            if clock == before:
                break
        if asked not in ways:
            return None
        own = {index: unknowns[index] for index in sorted(ways[asked][1])}
        return self._block(asked, own, Matching(self._told(own)).owner)

    def _shortage(self, asked: str, unknowns: Mapping[int, tuple[str, ...]]) -> Shortage:
        """The block with fewer equations than unknowns: all that alternating paths reach from the unknowns that got no equation."""
        owner = Matching(self._told(unknowns)).owner
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

    def _improved(self, best: Plan, unknowns: Mapping[int, tuple[str, ...]]) -> Plan:
        """Leave out one equation at a time while that makes the plan cheaper."""
        pool = dict(unknowns)
        for _ in range(ROUNDS):
            exert(len(best.equations) // BLOCKS_A_STEP)
            matching = Matching(self._told(pool))
            trials = [(self._block(best.asked, pool, matching.without(index)), index) for index in best.equations]
            better = [(trial, index) for trial, index in trials if trial is not None and trial.cost < best.cost]
            if not better:
                return best
            best, dropped = min(better, key=lambda item: item[0].cost)
            del pool[dropped]
        return best


def needed(asked: str, unknowns: Mapping[int, tuple[str, ...]], owner: Mapping[str, int]) -> tuple[set[str], list[str]]:
    """All unknowns that the asked one needs, by the equations that own them, and those of them that no equation owns."""
    pending, seen, open_ = [asked], {asked}, list[str]()
    while pending:
        name = pending.pop()
        if name not in owner:
            open_.append(name)
            continue
        fresh = [other for other in unknowns[owner[name]] if other not in seen]
        seen.update(fresh)
        pending.extend(fresh)
    return seen, open_


class Matching:
    """As many unknowns as can be, each with an equation of its own (`owner`), the first equations first."""

    def __init__(self, told: Mapping[int, tuple[str, ...]]) -> None:
        self.told = told
        self.owner: dict[str, int] = {}
        self.place = {index: number for number, index in enumerate(told)}
        spent: set[str] = set()  # unknowns from which no path leads to a free one: none ever will
        self.spare = [index for index in told if not self._fits(index, self.owner, spent)]

    def _fits(self, index: int, owner: dict[str, int], spent: set[str]) -> bool:
        """Whether an equation gets an unknown of its own, which it is given."""
        if spent.issuperset(self.told[index]):
            return False
        visited: set[str] = set()
        if _augment(index, self.told, owner, visited, spent):
            return True
        spent |= visited
        return False

    def without(self, skipped: int) -> dict[str, int]:
        """The owners where the matching is made without one equation that owns.

        Matched equations are a basis of a transversal matroid: the first spare one after it that fits takes its place, all others stay.
        """
        owner = {name: index for name, index in self.owner.items() if index != skipped}
        spent, place = set[str](), self.place[skipped]
        any(self._fits(index, owner, spent) for index in self.spare if self.place[index] > place)
        return owner


def _augment(
    index: int, unknowns: Mapping[int, tuple[str, ...]], owner: dict[str, int], visited: set[str], spent: set[str]
) -> bool:
    """Give an equation an unknown of its own, moving others over where that frees one (Kuhn's augmenting path)."""
    for name in unknowns[index]:
        if name not in owner:
            owner[name] = index
            return True
    for name in unknowns[index]:
        if name not in visited and name not in spent:
            visited.add(name)
            if _augment(owner[name], unknowns, owner, visited, spent):
                owner[name] = index
                return True
    return False
