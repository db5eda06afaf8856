"""Each line of algebra holds wherever the laws hold: numbers put into every equality of every solved scene."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterable
from pathlib import Path

import pytest

from rotsolve.algebra.formula import Formula, Integral, Sum, Symbol
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.symbols import GENERIC, POSITION, VIRTUAL
from rotsolve.language.problem import Problem
from rotsolve.search.search import Search

Number = Callable[[Formula, dict[str, float]], float]
Nearby = Callable[[Problem, random.Random], dict[str, float]]
Sides = tuple[Formula, Formula]
MOMENT = 0.7  # of the running time, where an equality holds at any
POINTS = 3
DISPLACED = 1e-8  # from an equilibrium: small swings hold to first order


class Place:
    """All letters of a solved search at one choice of the givens."""

    def __init__(self, search: Search, values: dict[str, float], number: Number) -> None:
        self.values, self.number = {"time": MOMENT, **values}, number
        self.values |= {swing.coordinate.name: DISPLACED for swing in search.scene.swings.values()}
        for name, found in search.solver.solved.items():
            if found.formula is not None:
                self.values[name] = number(found.formula, self.values)
            elif found.number is not None:
                self.values[name] = found.number.float
        for letter, ends in running(search).items():
            known = [number(end, self.values) for end in ends if end.symbols() <= set(self.values)]
            self.values[letter] = sum(known) / len(known) if known else MOMENT
        pool = [law for index, law in enumerate(search.planner.pool) if index not in search.retired]
        steps = [(step.chain[-1].left, step.chain[-1].right) for step in search.solver.steps]
        self.spread([*steps, *((law.left, law.right) for law in pool if not hides(law.left) and not hides(law.right))])

    def spread(self, equalities: Iterable[Sides]) -> None:
        """Letters that stand alone in an equality with known ones, and so on; those that only a square tells at the end."""
        pending, squares = list(equalities), False
        while pending:
            rest = [sides for sides in pending if not self.settle(*sides, squares=squares)]
            if len(rest) == len(pending) and squares:
                return
            squares = len(rest) == len(pending)
            pending = rest

    def settle(self, left: Formula, right: Formula, *, squares: bool) -> bool:
        """Find the one unknown letter of an equality that is linear in it or in its square (of which the root that is not negative
        will do, since nothing else speaks of such a letter); False where that is not yet possible."""
        open_ = sorted((left.symbols() | right.symbols()) - set(self.values))
        if len(open_) != 1:
            return not open_
        name = open_[0]
        try:
            gaps = [self.gap(left, right, {**self.values, name: trial}) for trial in (0.0, 1.0, 2.0, -1.0)]
        except (ValueError, ZeroDivisionError):
            return False
        slope, bend = gaps[1] - gaps[0], gaps[2] - 2 * gaps[1] + gaps[0]
        if abs(slope) > 1e-9 * (1 + abs(gaps[0])) and abs(bend) < 1e-9 * abs(slope):
            self.values[name] = -gaps[0] / slope
        elif (
            squares
            and slope
            and abs(gaps[3] - gaps[1]) < 1e-9 * abs(slope)
            and abs(bend - 2 * slope) < 1e-9 * abs(slope)
        ):
            self.values[name] = max(0.0, -gaps[0] / slope) ** 0.5
        return name in self.values

    def gap(self, left: Formula, right: Formula, values: dict[str, float]) -> float:
        return self.number(left, values) - self.number(right, values)

    def known(self, sides: Sides) -> bool:
        return (sides[0].symbols() | sides[1].symbols()) <= set(self.values)

    def holds(self, left: Formula, right: Formula) -> bool:
        parts = [part for side in (left, right) for part in (side.terms if isinstance(side, Sum) else (side,))]
        scale = max(1e-3, *(abs(self.number(part, self.values)) for part in parts))
        return abs(self.gap(left, right, self.values)) < 1e-8 * scale


def running(search: Search) -> dict[str, Sides]:
    """The places and speeds that run through a phase, with their values at its ends."""
    found: dict[str, Sides] = {}
    for passage in search.scene.passages.values():
        led = any(travel.leads for travel in passage.travels)
        for travel in passage.travels:
            runs = travel.leads or (not led and travel.pace == POSITION)
            if runs and isinstance(travel.coordinate, Symbol):
                assert travel.start is not None and travel.end is not None
                found.setdefault(travel.coordinate.name, (travel.start, travel.end))
            elif travel.leads and isinstance(travel.moving, Symbol):
                found[travel.moving.name] = (travel.before, travel.after)
    return found


def places(search: Search, number: Number, nearby: Nearby) -> list[Place]:
    """Some choices of the givens; those of the scene alone where an answer has a number only."""
    problem = search.scene.configuration.problem
    if any(found.formula is None for found in search.solver.solved.values()):
        return [Place(search, nearby(problem, Unchanged()), number)]
    chance, found = random.Random(problem.title), []
    for _ in range(POINTS):
        try:
            found.append(Place(search, nearby(problem, chance), number))
        except ValueError:  # an answer that exists in a narrow range only
            found.append(Place(search, nearby(problem, Unchanged()), number))
    return found


class Unchanged(random.Random):
    """Leaves every value as the scene has it."""

    def uniform(self, a: float, b: float) -> float:
        return (a + b) / 2


def told(sides: Sides) -> str:
    return f"{to_text(sides[0])} = {to_text(sides[1])}"


def check(place: Place, sides: Sides, label: str) -> None:
    holds = place.holds(*sides)
    assert holds, f"{label} does not hold at the answers: {told(sides)}"


@pytest.mark.sampled(2)
def test_every_step_holds(file: Path, search_of: Callable[..., Search], number: Number, nearby: Nearby) -> None:
    search = search_of(file)
    for place in places(search, number, nearby):
        for step in search.solver.steps:
            for equality in step.chain:
                if equality.relation == "=":
                    sides = equality.left, equality.right
                    assert place.known(sides), f"a letter of step {step.number} is never found: {told(sides)}"
                    check(place, sides, f"step {step.number}")


def test_every_law_used_holds(file: Path, search_of: Callable[..., Search], number: Number, nearby: Nearby) -> None:
    search = search_of(file)
    used = {index for answered in search.answered for index in answered.used}
    laws = [search.planner.pool[index] for index in sorted(used)]
    for place in places(search, number, nearby):
        place.spread([(law.left, law.right) for law in laws])
        for law in laws:
            if not hides(law.left) and not hides(law.right):
                sides = law.left, law.right
                assert place.known(sides), f"a letter of the law is never found: {told(sides)}"
                check(place, sides, law.label)


def hides(side: Formula) -> bool:
    """Whether an integral holds a letter that itself runs with what is summed over."""
    inside = [node.integrand.symbols() - {node.variable} for node in side.walk() if isinstance(node, Integral)]
    return any(GENERIC in name for names in inside for name in names)


def test_all_that_the_laws_write_holds_at_the_answers(
    file: Path, search_of: Callable[..., Search], number: Number, nearby: Nearby
) -> None:
    """Also the equations that no plan used: a second law that disagrees is a fault in one of the two."""
    search = search_of(file)
    laws = [law for law in search.scene.equations if not hides(law.left) and not hides(law.right)]
    laws = [law for law in laws if VIRTUAL not in " ".join(law.symbols())]
    for place in places(search, number, nearby):
        place.spread([(law.left, law.right) for law in laws])
        checked = [law for law in laws if place.known((law.left, law.right))]
        used = {index for answered in search.answered for index in answered.used}
        if (
            laws and not checked and any(search.planner.pool[index].family for index in used)
        ):  # else of modes, of no moment
            pytest.fail("no law of this scene can be checked")
        for law in checked:
            check(place, (law.left, law.right), law.label)
