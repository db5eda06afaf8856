"""Matching: the cheapest of some equations that settle an asked unknown. Knows no physics.

Equations are matched to unknowns in the order of their cost (a transversal matroid, so the greedy choice is the cheapest maximal one);
the block behind the asked unknown is what its matched equation needs (Dulmage-Mendelsohn). Then each equation of the block is tried
for omission, since a dearer one elsewhere may make several cheap ones needless.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from functools import lru_cache

from msgspec import Struct

BLOCKS_A_STEP = 12  # of equations that are left out, each in its turn
ROUNDS = 12  # improvements after which a plan is taken as it is
REMEMBERED = 2000  # plans: the cases of a scene in letters ask for the same few hundred


class Plan(Struct, frozen=True):
    """Equations (indices into the pool) that settle `asked`, and the unknowns that they settle with it."""

    asked: str
    equations: tuple[int, ...]
    unknowns: tuple[str, ...]
    cost: int


class Candidate(Struct, frozen=True):
    """An equation that a plan may use: its number, the unknowns in it, what it costs, and the unknowns that it sums over."""

    number: int
    unknowns: tuple[str, ...]
    cost: int
    summed: frozenset[str]


@lru_cache(REMEMBERED)
def cheapest_plan(asked: str, rows: tuple[Candidate, ...], constants: frozenset[str]) -> tuple[Plan | None, int]:
    """The cheapest plan for `asked` with some equations, the best first, and the steps of work that it took; None where there is none.

    `constants` are unknowns that never run: an integral tells them through what stands within it.
    """
    search = Cheapest(asked, rows, constants)
    best = search.block(search.unknowns, Matching(search.told(search.unknowns)).owner)
    if best is None:
        return None, 0
    chained = search.chain()
    plans = [search.improved(best), *([chained] if chained is not None else [])]
    return min(plans, key=lambda plan: plan.cost), search.work


class Cheapest:
    """The search for the cheapest plan: several ways to one, of which the cheapest is taken."""

    def __init__(self, asked: str, rows: tuple[Candidate, ...], constants: frozenset[str]) -> None:
        self.asked, self.constants = asked, constants
        self.unknowns = {row.number: row.unknowns for row in rows}
        self.costs = {row.number: row.cost for row in rows}
        self.summed = {row.number: row.summed for row in rows}
        self.work = 0  # in steps

    def told(self, unknowns: Mapping[int, tuple[str, ...]]) -> Mapping[int, tuple[str, ...]]:
        return solvable_for(unknowns, self.summed, self.constants)

    def block(self, unknowns: Mapping[int, tuple[str, ...]], owner: Mapping[str, int]) -> Plan | None:
        """Collect what the asked unknown's equation needs; None where one of that has no equation."""
        names, open_ = needed(self.asked, unknowns, owner)
        if open_:
            return None
        equations = sorted(owner[name] for name in names)
        return Plan(self.asked, tuple(equations), tuple(sorted(names)), sum(map(self.costs.__getitem__, equations)))

    def chain(self) -> Plan | None:
        """The cheapest plan that settles one unknown after the other, none together; None where there is no such plan.

        Costs spread from what one equation settles alone (as in Knuth's generalisation of Dijkstra's algorithm); equations that
        several unknowns need are counted once.
        """
        ways: dict[str, tuple[int, frozenset[int]]] = {}
        clock, changed, looked_at = 0, dict[str, int](), dict[int, int]()  # when a way was found, an equation looked at
        for _ in range(ROUNDS):
            before = clock
            for index, names in self.unknowns.items():
                missing = [name for name in names if name not in ways]
                if len(missing) > 1 or all(changed.get(name, 0) <= looked_at.get(index, -1) for name in names):
                    continue
                for name in (one for one in missing or names if one not in self.summed[index]):
                    used = frozenset((index,)).union(*(ways[other][1] for other in names if other != name))
                    cost = sum(map(self.costs.__getitem__, used))
                    if name not in ways or cost < ways[name][0]:
                        clock += 1
                        ways[name], changed[name] = (cost, used), clock
                looked_at[index] = clock
            if clock == before:
                break
        if self.asked not in ways:
            return None
        own = {index: self.unknowns[index] for index in sorted(ways[self.asked][1])}
        return self.block(own, Matching(self.told(own)).owner)

    def improved(self, best: Plan) -> Plan:
        """Leave out one equation at a time while that makes the plan cheaper."""
        pool = dict(self.unknowns)
        for _ in range(ROUNDS):
            self.work += len(best.equations) // BLOCKS_A_STEP
            matching = Matching(self.told(pool))
            trials = [(self.block(pool, matching.without(index)), index) for index in best.equations]
            better = [(trial, index) for trial, index in trials if trial is not None and trial.cost < best.cost]
            if not better:
                return best
            best, dropped = min(better, key=lambda item: item[0].cost)
            del pool[dropped]
        return best


def solvable_for(
    unknowns: Mapping[int, tuple[str, ...]], summed: Mapping[int, frozenset[str]], constants: Collection[str]
) -> Mapping[int, tuple[str, ...]]:
    """What each equation may be solved for: what it does not sum over; else a constant on which that depends."""
    if not any(summed[index] for index in unknowns):
        return unknowns
    told = dict(unknowns)
    for index in told:
        if summed[index]:
            told[index] = tuple(name for name in told[index] if name not in summed[index])
    for index, names in unknowns.items():
        if names and not told[index] and constants:
            told[index] = constants_behind(names, unknowns, constants)
    return told


def constants_behind(
    names: Sequence[str], unknowns: Mapping[int, tuple[str, ...]], constants: Collection[str]
) -> tuple[str, ...]:
    """The constants in the equations that tell some unknowns, or what these depend on."""
    seen, pending = set(names), list(names)
    while pending:
        name = pending.pop()
        fresh = {other for held in unknowns.values() if name in held for other in held} - seen
        seen |= fresh
        pending.extend(fresh - set(constants))
    return tuple(sorted(seen & set(constants)))


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
