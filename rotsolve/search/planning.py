"""Planning: which of the laws a question is planned with, as a textbook would choose.

Newton's laws alone for what belongs to one moment, where they do; no more equations of constant acceleration than are independent;
equations that restate others only where the rest does not do.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from functools import cached_property
from itertools import combinations

from msgspec import Struct

from rotsolve.algebra.formula import Call, Integral
from rotsolve.core.equation import ANGULAR_MOMENTUM, FAMILIES, KINEMATICS, NEWTON, SECOND_CHOICE, Equation
from rotsolve.core.symbols import has_quantities, of_kinds
from rotsolve.matching import Plan
from rotsolve.plan import Planner, Shortage

MOST_PLANS = 60  # that are looked through for one with few equations of constant acceleration
FORCES = ("tension", "force", "normal_force", "friction_force")
OF_ONE_MOMENT = ("acceleration", "angular_acceleration", *FORCES, "work")  # a work by its force, where the way is known


def families_for(law: str | None) -> tuple[str, ...]:
    """The equation families that a law may use; for none all but those that are written only where they are asked for."""
    laws = [law] if law is not None else [one.name for one in FAMILIES.values() if not one.only_asked]
    return (*laws, KINEMATICS)


def forces_in(plan: Plan) -> int:
    """How many unknowns of a plan are forces."""
    return len(of_kinds(plan.unknowns, FORCES))


def sums(plan: Plan, planner: Planner) -> bool:
    """Whether an equation of a plan sums over a phase."""
    laws = (planner.pool[index] for index in plan.equations)
    return any(law.left.holds(Integral) or law.right.holds(Integral) for law in laws)


def has_calls(equation: Equation) -> bool:
    """Whether a letter of the laws stands inside a function."""
    return any(has_quantities(node) for side in (equation.left, equation.right) for node in side.walk(Call))


class LawChoice(Struct, frozen=True, dict=True):
    """The search for a plan that settles `letter` from what is known; `momentary` where the laws of one moment may do."""

    planner: Planner
    letter: str
    momentary: bool
    known: Collection[str]
    families: tuple[str, ...]
    spare: bool  # whether second-choice equations may be used from the start
    allowed: list[int]  # pool indices of the equations that may be used
    forces_asked: bool = False  # whether the scene asks for forces, so that Newton's laws are needed anyway

    def best(self) -> Plan | Shortage:
        """The cheapest plan by the laws chosen; second-choice equations only where the first ones do not do."""
        if (
            self.momentary and self.families[0] == NEWTON and not self.spare
        ):  # behind a law asked for they only help out
            laws = self._of_families(self._first_choice(), ("", NEWTON)) + self._telling_angles()
            plan = self._from(laws)
            if plan is not None:
                return plan if self.forces_asked else self._leaner(plan, laws)
        first = self.allowed if self.spare else self._first_choice()
        settled = self._settled((*self._starts(first), *self._differentiated(first)))
        if settled:
            sound = [plan for plan in settled if not self._crowded(plan)] or self._with_few_times(first)
            return min(sound or settled, key=lambda plan: plan.cost)
        return self.planner.plan(self.letter, self.known, self.allowed)

    @cached_property
    def _unknowns(self) -> dict[int, tuple[str, ...]]:
        return self.planner.unknowns(self.known, self.allowed)

    def _from(self, indices: Iterable[int]) -> Plan | None:
        """The cheapest plan with some equations."""
        return self.planner.cheapest(self.letter, {index: self._unknowns[index] for index in indices})

    def _settled(self, pools: Iterable[Iterable[int]]) -> list[Plan]:
        """The plans with each of several pools of equations, of those that have one."""
        return [plan for pool in pools if (plan := self._from(pool)) is not None]

    def _of_families(self, indices: Iterable[int], families: Collection[str]) -> list[int]:
        return [index for index in indices if self.planner.pool[index].family in families]

    def _telling_angles(self) -> list[int]:
        """The equations between two states by which alone an angle is told: no forces are needed for it, whose roots may be others."""
        return [
            index
            for index in self._of_families(self._first_choice(), (KINEMATICS,))
            if len(self._unknowns[index]) == 1 and of_kinds(self._unknowns[index], ("angle",))
        ]

    def _first_choice(self) -> list[int]:
        return [index for index in self.allowed if self.planner.pool[index].cost < SECOND_CHOICE]

    def _starts(self, allowed: list[int]) -> list[list[int]]:
        """All laws together, then each alone: a search that starts from one law finds plans that leaving out step by step does not."""
        laws = [law for law in self.families if law in FAMILIES]
        if len(laws) <= 1:
            return [allowed]
        alone = [self._of_families(allowed, ("", KINEMATICS, law)) for law in laws]
        summed = self._of_families(allowed, ("", ANGULAR_MOMENTUM))  # impulses sum over a phase without kinematics
        return [allowed, *alone, summed]

    def _differentiated(self, allowed: list[int]) -> Iterator[list[int]]:
        """Some equations with the derivative of the energy of a linkage instead of one of Newton's laws, which together imply it."""
        pool = self.planner.pool
        for index in self.allowed:
            energy = pool[index]
            if energy.law.condenses and index not in allowed:
                laws = [law for law in self._of_families(allowed, (NEWTON,)) if pool[law].section == energy.section]
                for law in laws:
                    if set(pool[law].bodies) <= set(energy.bodies):
                        yield [*(other for other in allowed if other != law), index]

    def _leaner(self, plan: Plan, laws: list[int]) -> Plan:
        """A plan by Newton's laws, or one by the derivative of the energy where that leaves out two forces or more."""
        best = min(self._settled(self._differentiated(laws)), key=lambda other: other.cost, default=plan)
        return best if forces_in(plan) - forces_in(best) >= 2 else plan

    # equations of constant acceleration

    def _in_time(self, indices: Iterable[int]) -> dict[str, dict[object, list[int]]]:
        """The equations of constant acceleration among some, by phase and by coordinate."""
        phases: dict[str, dict[object, list[int]]] = {}
        for index in indices:
            equation = self.planner.pool[index]
            if equation.law.steady:
                coordinate = (equation.law.steady, equation.bodies)
                phases.setdefault(equation.section, {}).setdefault(coordinate, []).append(index)
        return phases

    def _crowded(self, plan: Plan, *, strict: bool = False) -> list[int]:
        """Three or more equations of constant acceleration of one phase: of the four only two are independent, and the rules tie
        the coordinates of a phase together; if `strict` also any of two coordinates."""
        for coordinates in self._in_time(plan.equations).values():
            together = [index for own in coordinates.values() for index in own]
            if len(together) > 2 or (strict and len(coordinates) > 1):
                return together
        return []

    def _with_few_times(self, allowed: list[int]) -> list[Plan]:
        """Plans with at most two equations of constant acceleration, of one coordinate; of one in each phase where there are several."""
        phases = self._in_time(allowed)
        coordinates = [own for phase in phases.values() for own in phase.values()]
        rest = [index for index in allowed if not any(index in own for own in coordinates)]
        chosen = [pair for own in coordinates for pair in (*combinations(own, 1), *combinations(own, 2))]
        found = self._settled([*rest, *pair] for pair in ((), *chosen) if self._patient())
        if len(phases) < 2 or self.spare:  # a confirmation is not worth so long a search
            return found
        return found + self._thinned(allowed)

    def _patient(self) -> bool:
        """Whether one more plan may be made that only avoids equations of constant acceleration; its work is counted."""
        self.planner.patience[0] -= len(self.allowed) ** 2
        return self.planner.patience[0] >= 0

    def _thinned(self, allowed: list[int]) -> list[Plan]:
        """Plans for several phases: of too many equations of constant acceleration in one each is left out in its turn."""
        found: list[Plan] = []
        pending, seen = [frozenset[int]()], set[frozenset[int]]()
        while pending and len(seen) < MOST_PLANS and self._patient():
            dropped = pending.pop(0)
            if dropped in seen:
                continue
            seen.add(dropped)
            plan = self._from([index for index in allowed if index not in dropped])
            crowded = self._crowded(plan, strict=True) if plan is not None else []
            found += [plan] if plan is not None and not crowded else []
            pending += [dropped | {index} for index in crowded]
        return found
