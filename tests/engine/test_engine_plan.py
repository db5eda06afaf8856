"""The planner on small pools without physics: the cheapest block, what is short, what says nothing new."""

from __future__ import annotations

import random

import pytest

from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.exact.normal import equal
from rotsolve.algebra.formula import ONE, ZERO, Formula, Integral, Symbol
from rotsolve.algebra.notation.parse import parse
from rotsolve.core.equation import RULE, Equation
from rotsolve.matching import Plan
from rotsolve.plan import Planner, Shortage
from rotsolve.solver import Solver
from rotsolve.solver.steps import Contradiction, PickedRoot, Redundant


def pool(*lines: str, costs: tuple[int, ...] = ()) -> list[Equation]:
    found = []
    for index, line in enumerate(lines):
        left, right = (parse(side.strip()) for side in line.split("="))
        found.append(RULE.equation(left, right, "", cost=costs[index] if costs else 2, words=f"law {index}"))
    return found


def planned(asked: str, known: str, *lines: str, costs: tuple[int, ...] = ()) -> tuple[int, ...]:
    plan = Planner(pool(*lines, costs=costs)).plan(asked, set(known.split()))
    assert isinstance(plan, Plan), plan
    return plan.equations


def test_only_the_block_behind_the_question() -> None:
    lines = ("p = q", "q = 2 r", "s = p + q", "v = s^2")
    assert planned("p", "r", *lines) == (0, 1)


def test_coupled_equations_come_together() -> None:
    assert planned("a", "m g", "m g - T = m a", "T = k a", "k = 3 m", "z = a") == (0, 1, 2)


def test_the_cheaper_way_is_taken() -> None:
    lines = ("x = y + z", "y = 2 k", "z = 3 k", "x = 5 k")
    assert planned("x", "k", *lines, costs=(2, 2, 2, 5)) == (3,)
    assert planned("x", "k", *lines, costs=(1, 1, 1, 5)) == (0, 1, 2)


def test_a_known_letter_needs_no_equation() -> None:
    assert planned("a", "m F", "F = m a", "m = 2 n") == (0,)


def test_an_integral_tells_a_constant_within_it() -> None:
    equations = [
        RULE.equation(Symbol("T"), Integral(ONE / Symbol("a"), "w", ZERO, Symbol("u")), "", words=""),
        *pool("-c w = a"),
    ]
    known = {"T", "u", "w"}
    assert isinstance(Planner(equations).plan("c", known), Shortage)
    plan = Planner(equations, ["c"]).plan("c", known)
    assert isinstance(plan, Plan) and plan.equations == (0, 1)


def test_a_question_that_nothing_holds() -> None:
    plan = Planner(pool("x = y")).plan("w", {"y"})
    assert isinstance(plan, Shortage)
    assert plan.equations == () and plan.unknowns == ("w",)


def test_a_shortage_names_the_block() -> None:
    plan = Planner(pool("T1 - m g = m a", "T1 R = k c", "e = f")).plan("a", {"m", "g", "R", "k", "f"})
    assert isinstance(plan, Shortage)
    assert plan.equations == (0, 1)
    assert plan.unknowns == ("T1", "a", "c")


def test_only_allowed_equations_are_used() -> None:
    planner = Planner(pool("x = 1 k", "x = 2 k", "y = x"))
    plan = planner.plan("y", {"k"}, [1, 2])
    assert isinstance(plan, Plan) and plan.equations == (1, 2)


def test_equations_found_on_the_way_serve_later() -> None:
    planner = Planner(pool("x = y + z", "y = z"))
    index = planner.extend(pool("z = 3 k", costs=(1,))[0])
    plan = planner.plan("x", {"k"})
    assert isinstance(plan, Plan) and plan.equations == (0, 1, index)


@pytest.mark.parametrize("seed", range(30))
def test_random_triangular_pools_need_just_what_is_reached(seed: int) -> None:
    """x_k = f(earlier x): the plan of x_n is the set of equations that a walk backwards from it meets."""
    chance = random.Random(seed)
    size = chance.randint(2, 12)
    needs = [sorted(chance.sample(range(index), min(index, chance.randint(0, 2)))) for index in range(size)]
    lines = [f"x{index} = k" + "".join(f" + x{other}" for other in needs[index]) for index in range(size)]
    order = list(range(size))
    chance.shuffle(order)
    reached, pending = set(), [size - 1]
    while pending:
        index = pending.pop()
        reached.add(index)
        pending.extend(other for other in needs[index] if other not in reached)
    equations = planned(f"x{size - 1}", "k", *(lines[index] for index in order))
    assert {order[index] for index in equations} == reached


def solver(equations: list[Equation], choose: object = None) -> Solver:
    def first(name: str, roots: object, period: object) -> PickedRoot:
        return PickedRoot(0)

    positive = frozenset({"k", "m", "g", "R"})
    return Solver(pool=equations, order=(), signs=SignOracle({}, frozenset(positive)), choose=choose or first)  # type: ignore[arg-type]


def answered(asked: str, known: str, *lines: str) -> Formula:
    equations = pool(*lines)
    plan = Planner(equations).plan(asked, set(known.split()))
    assert isinstance(plan, Plan)
    found = solver(equations).solve(plan).formula
    assert found is not None
    return found


def test_a_coupled_block_is_solved() -> None:
    formula = answered("a", "m g R I", "m g - T = m a", "T R = I c", "a = R c")
    assert equal(formula, parse("m g/(m + I/R^2)"))


def test_a_square_is_solved_by_the_choice_of_root() -> None:
    equations = pool("m g h = m v^2/2", "h = 2 R")
    plan = Planner(equations).plan("v", {"m", "g", "R"})
    assert isinstance(plan, Plan)
    asked_of = []

    def second(name: str, roots: list[Formula], period: object) -> PickedRoot:
        asked_of.append((name, len(roots)))
        return PickedRoot(1, ("it falls",))

    work = solver(equations, second)
    found = work.solve(plan)
    assert found.formula is not None and equal(found.formula, parse("-2 sqrt(g R)"), {"g", "R"})
    assert asked_of == [("v", 2)] and len(found.others) == 1
    assert work.steps[-1].reason == ("it falls",)


def test_an_angle_is_solved() -> None:
    formula = answered("theta", "m g k", "m g sin(theta) = k")
    assert "asin" in repr(formula) or "atan" in repr(formula)


@pytest.mark.parametrize("left", ["y", "2 y"])
def test_what_says_nothing_new_is_told(left: str) -> None:
    equations = pool("x = y", f"{left} = {left.replace('y', 'x')}")
    plan = Planner(equations).plan("x", set())
    assert isinstance(plan, Plan)
    with pytest.raises(Redundant):
        solver(equations).solve(plan)


def test_what_contradicts_is_told() -> None:
    equations = pool("x = y", "x = y + k")
    plan = Planner(equations).plan("x", {"k"})
    assert isinstance(plan, Plan)
    with pytest.raises(Contradiction):
        solver(equations).solve(plan)


def test_a_failed_plan_leaves_no_steps() -> None:
    equations = pool("x = y", "y = x")
    work = solver(equations)
    plan = Planner(equations).plan("x", set())
    assert isinstance(plan, Plan)
    with pytest.raises(Redundant):
        work.solve(plan)
    assert not work.steps and not work.solved and not work.derived
