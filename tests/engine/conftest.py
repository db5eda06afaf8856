"""Scenes for the engine's tests: every file in scenes/, and the problems of the project, read and ready.

A new element is tested by adding a scene that holds it; which elements a scene tests is seen from the scene itself.
"""

from __future__ import annotations

import itertools
import math
import random
from collections.abc import Callable, Mapping
from fractions import Fraction
from functools import cache
from pathlib import Path

import pytest

from rotsolve.algebra.formula import (
    Call,
    Constant,
    Formula,
    Integral,
    Negative,
    Number,
    Power,
    Product,
    Quotient,
    Sum,
    Symbol,
)
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Problem
from rotsolve.motion.complete import completed
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.rubs import rubs
from rotsolve.scene.read import read_file
from rotsolve.search.answering import answer
from rotsolve.search.friction import decide
from rotsolve.search.planning import families_for
from rotsolve.search.search import Search

HERE = Path(__file__).resolve().parent
SCENES = sorted((HERE / "scenes").glob("*.yaml"))
BUNDLED = sorted((HERE.parent.parent / "problems").rglob("*.yaml"))
PROBLEMS = [path for path in BUNDLED if "\nup: z" not in path.read_text(encoding="utf-8")]  # of the plane
MODES = ("sticks", "slips", "slips back")
NODES, WEIGHTS = (  # Gauss-Legendre of ten points on −1 to 1, the positive half
    (0.1488743389816312, 0.4333953941292472, 0.6794095682990244, 0.8650633666889845, 0.9739065285171717),
    (0.2955242247147529, 0.2692667193099963, 0.2190863625159820, 0.1494513491505806, 0.0666713443086881),
)


def pytest_generate_tests(metafunc: pytest.Metafunc) -> None:
    """`scene` runs over the scenes of this folder, `file` over them and the project's problems in the plane.

    Those in space have other equations, which tests/assembly/test_in_space holds against bodies' own.
    """
    for name, paths in (("scene", SCENES), ("file", [*SCENES, *PROBLEMS])):
        if name in metafunc.fixturenames:
            metafunc.parametrize(name, paths, ids=[path.stem for path in paths])


@cache
def load(path: Path) -> Problem:
    return completed(read_file(path))


@cache
def read_all_ways(path: Path) -> tuple[SceneEquations, ...]:
    """A scene for every way in which the rough contacts of a scene may stick or slip."""
    configuration = Configuration(load(path))
    rough = [rub.key for rub in rubs(configuration) if rub.item is not None]
    ways = itertools.product(MODES, repeat=len(rough))
    return tuple(SceneEquations(configuration, dict(zip(rough, way, strict=True))) for way in ways)


@cache
def solved(path: Path, law: str | None = None) -> Search:
    """All questions of a scene answered, by one law or by the shortest way."""
    configuration = Configuration(load(path))
    scene = SceneEquations(configuration, decide(configuration).modes)
    search = Search(scene, families_for(law), spare=law is not None)
    for find in load(path).finds:
        answer(search, find)
    return search


@pytest.fixture(scope="session")
def problem_of() -> Callable[[Path], Problem]:
    return load


@pytest.fixture(scope="session")
def readings() -> Callable[[Path], tuple[SceneEquations, ...]]:
    return read_all_ways


@pytest.fixture(scope="session")
def search_of() -> Callable[..., Search]:
    return solved


@pytest.fixture(scope="session")
def scenes() -> list[Path]:
    return SCENES


def numeric(formula: Formula, values: Mapping[str, float]) -> float:
    """A formula as a float, by a walk of its own; KeyError for a letter without a value, ValueError where undefined."""
    match formula:
        case Number(value):
            return float(value)
        case Constant():
            return math.pi
        case Symbol(name):
            return values[name]
        case Sum(terms):
            return math.fsum(numeric(term, values) for term in terms)
        case Product(factors):
            return math.prod(numeric(factor, values) for factor in factors)
        case Quotient(numerator, denominator):
            return numeric(numerator, values) / numeric(denominator, values)
        case Negative(operand):
            return -numeric(operand, values)
        case Power(base, exponent):
            result = numeric(base, values) ** numeric(exponent, values)
            if isinstance(result, complex):
                raise ValueError("not real")
            return float(result)
        case Call("ellipk", (argument,)):
            return math.pi / 2 / mean(1.0, math.sqrt(1 - numeric(argument, values)))
        case Call(function, arguments):
            call = abs if function == "abs" else getattr(math, function)
            return float(call(*(numeric(argument, values) for argument in arguments)))
        case Integral():
            return quadrature(formula, values)
    raise TypeError(f"no value for {formula!r}")


def mean(one: float, other: float) -> float:
    """The arithmetic-geometric mean of Gauss."""
    for _ in range(40):
        one, other = (one + other) / 2, math.sqrt(one * other)
    return one


def quadrature(formula: Integral, values: Mapping[str, float], panels: int = 8) -> float:
    """A definite integral by Gauss-Legendre in s, with x = a + (b − a) s² (3 − 2 s), which takes 1/√ off both ends."""
    lower, upper = numeric(formula.lower, values), numeric(formula.upper, values)
    half = 1 / (2 * panels)
    result = 0.0
    for panel in range(panels):
        middle = (2 * panel + 1) * half
        for node, weight in zip(NODES, WEIGHTS, strict=True):
            for s in (middle - half * node, middle + half * node):
                place = lower + (upper - lower) * s * s * (3 - 2 * s)
                slope = (upper - lower) * 6 * s * (1 - s)
                result += weight * half * slope * numeric(formula.integrand, {**values, formula.variable: place})
    return result


def near(problem: Problem, chance: random.Random) -> dict[str, float]:
    """Values for all givens close to those of the scene, so that nothing goes another way; any for a letter without one."""
    values: dict[str, float] = {}
    pending = [given for given in problem.givens if not given.asked]
    for given in pending:
        if given.value is None:
            values[given.name] = chance.uniform(0.5, 1.5)
        elif not given.value.symbols():
            values[given.name] = numeric(given.value, {}) * (1 + chance.uniform(-0.03, 0.03))
    while any(given.name not in values for given in pending):
        for given in pending:
            if given.value is not None and given.value.symbols() <= set(values) and given.name not in values:
                values[given.name] = numeric(given.value, values)
    return values


@pytest.fixture(scope="session")
def number() -> Callable[[Formula, Mapping[str, float]], float]:
    return numeric


@pytest.fixture(scope="session")
def nearby() -> Callable[[Problem, random.Random], dict[str, float]]:
    return near


@pytest.fixture(scope="session")
def exactly() -> Callable[[Mapping[str, float]], dict[str, Formula]]:
    """Floats as the exact fractions that they are."""
    return lambda values: {name: Number(Fraction(value)) for name, value in values.items()}
