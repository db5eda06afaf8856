"""Every answer of problems in space by a second route: with the file's numbers, and with two other sets put into its closed forms.

The first route is the assembly (tests/assembly/test_in_space.py for scenes with `up: z`). That each file has both is held here, by name.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import second_route
from rotsolve.arrays import single_answers
from rotsolve.pipeline import solve
from rotsolve.solution import Solution
from second_route.by_hand import CLOSED_FORMS, UNCONFIRMED
from second_route.numbers import givens, in_si, named, near
from solutions import solved

ROOT = Path(__file__).resolve().parents[2]
IN_SPACE = re.compile(
    r"^up: z|inertia_tensor|angular_momentum\.z", re.MULTILINE
)  # the last two: asked of a scene in the plane
FILES = [
    path
    for path in sorted((ROOT / "problems").rglob("*.yaml"))
    if path.parent.name == "space" or IN_SPACE.search(path.read_text(encoding="utf-8"))
]
ALIKE, NOTHING = 1e-9, 1e-12  # by the number, and of what is zero or a float's remainder by the whole vector
OTHERS: dict[
    str, tuple[dict[str, float], ...]
] = {  # where numbers near those of the file make another question, or no body
    "gyrocompass-that-swings": ({"A": 0.03}, {"A": 0.025}),  # what is thinner than a disc is no body
    "between-both-cases": (
        {"I1": 5, "I2": 7, "I3": 10},
        {"I1": 10, "I2": 13, "I3": 18},
    ),  # 3 I₁ (I₂ − I₁) = I₃ (I₃ − I₂)
    "between-both-cases-in-space": ({"I1": 5, "I2": 7, "I3": 10}, {"I1": 10, "I2": 13, "I3": 18}),
    "kowalevskaya-top": ({"n1": 0.28, "n2": 0, "n3": 0.96}, {"n1": 0.48, "n2": 0.6, "n3": 0.64}),  # of the length 1
    "stability-of-three-axes": ({"I1": 1.1, "I2": 2.1, "I3": 2.9}, {"I1": 1.5, "I2": 1.9, "I3": 3}),  # I₃ ≤ I₁ + I₂
    "tennis-racket-in-the-hand": ({"I1": 1.3e-3, "I2": 0.016, "I3": 0.017}, {"I1": 1.2e-3, "I2": 0.0165, "I3": 0.0175}),
    "gyroscope-on-a-string": ({"I0": 1.9e-3, "I1": 1.1e-3}, {"I0": 2.1e-3, "I1": 1.2e-3}),
    "tennis-racket": ({"I1": 1.3e-3, "I2": 0.016, "I3": 0.017}, {"I1": 1.2e-3, "I2": 0.0165, "I3": 0.0175}),
}
SOLVED_ANEW = {  # why its closed forms are not evaluated for many sets
    **dict.fromkeys(("between-both-cases", "between-both-cases-in-space"), "a case that numbers decide"),
    **dict.fromkeys(
        ("how-long-a-top-nods", "tennis-racket", "tennis-racket-in-the-hand", "wing-nut"), "elliptic functions"
    ),
    "gyroscope-on-a-string": "an angle without a closed form",
    **dict.fromkeys(("shell-fired-east", "stone-from-a-tower"), "terms that are nearly each other"),
    "stability-of-three-axes": "a word is asked",
    "hookes-joint-fast-and-slow": "extremes over a letter",
}


def singles(found: dict[str, Any]) -> dict[str, Any]:
    """Vectors and tensors component by component, by the names of `single_answers`."""
    parts: dict[str, Any] = {}
    for name, value in found.items():
        if isinstance(value, str) or np.ndim(value) == 0:
            parts[name] = value
        elif isinstance(value, list):
            parts |= {f"{name}.{k + 1}": item for k, item in enumerate(value)}
        elif np.ndim(value) == 1:
            parts |= {f"{name}.{axis}": item for axis, item in zip("xyz", value, strict=True)}
        else:
            parts |= {f"{name}.{'xyz'[i]}{'xyz'[j]}": value[i, j] for i in range(3) for j in (i, (i + 1) % 3)}
    return parts


def alike(one: Any, other: Any, scale: float) -> bool:
    """A word, or a number; `scale` is the size of the vector of which it is a part."""
    if isinstance(other, str):
        return bool(one == other)
    return bool(abs(one - other) <= ALIKE * (abs(other) if abs(other) > NOTHING * scale else scale))


def differences(calculated: dict[str, Any], printed: dict[str, Any]) -> list[str]:
    """Where a second route comes to another answer, or to another set of answers."""
    wrong = sorted(calculated.keys() ^ printed.keys())
    for name in calculated.keys() & printed.keys():
        whole = name.split(".")[0]
        parts = [
            abs(value) for key, value in printed.items() if key.split(".")[0] == whole and not isinstance(value, str)
        ]
        if not alike(calculated[name], printed[name], max(parts, default=0) or 1.0):
            wrong.append(f"{name}: {calculated[name]!r}, not {printed[name]!r}")
    return wrong


def answered(solution: Solution) -> dict[str, Any]:
    return {
        name: one.word if one.value is None else one.value.float
        for name, one in single_answers(solution.derivation.answers)
    }


def with_numbers(file: Path, numbers: dict[str, tuple[float, str]]) -> dict[str, Any]:
    """What rotsolve answers with other numbers: by its closed forms where it evaluates these for many sets."""
    if file.stem in SOLVED_ANEW:
        settings = {name: f"{number!r} {unit}" for name, (number, unit) in numbers.items()}
        return answered(solve(file, settings=settings, confirm=False))
    found = solved(file).evaluate_many({name: np.array([value]) for name, value in in_si(file, numbers).items()})
    return {name: float(np.broadcast_to(value, 1)[0]) for name, value in found.items()}


def sets_of(file: Path) -> dict[str, dict[str, tuple[float, str]]]:
    """The file's own, and two others."""
    found = {"own": givens(file)}
    for k, other in enumerate(OTHERS.get(file.stem, ({}, {}))):
        numbers = near(file, seed=k)
        found[f"set {k + 1}"] = numbers | {name: (number, numbers[name][1]) for name, number in other.items()}
    return found


@pytest.mark.sampled(6)
@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_every_answer_by_a_second_route(file: Path) -> None:
    for word, numbers in sets_of(file).items():
        printed = answered(solved(file)) if word == "own" else with_numbers(file, numbers)
        given = named(in_si(file, numbers))
        calculated = singles(second_route.CALCULATIONS[file.stem](given))
        assert differences(calculated, printed) == [], (word, numbers)
        by_hand = singles(CLOSED_FORMS[file.stem](given)) if file.stem in CLOSED_FORMS else {}
        assert differences(by_hand, {name: printed[name] for name in by_hand}) == [], (word, numbers)


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_what_the_assembly_does_not_confirm_is_listed(file: Path) -> None:
    """What is listed has a closed form by hand beside its second route."""
    said = solved(file).derivation.confirmed
    assert {item.name for item in said} == solved(file).answers.keys()
    assert {item.name: item.why for item in said if item.holds is not True} == UNCONFIRMED.get(file.stem, {})
    given = named(in_si(file, givens(file)))
    by_hand = CLOSED_FORMS[file.stem](given) if file.stem in CLOSED_FORMS else {}
    assert UNCONFIRMED.get(file.stem, {}).keys() <= by_hand.keys()


def without_second_route(names: Iterable[str]) -> set[str]:
    return set(names) - second_route.CALCULATIONS.keys()


def test_every_problem_has_a_second_route() -> None:
    """And each route a problem; that `--law lagrange` answers too is no second route, since definitions alone often do."""
    names = [file.stem for file in FILES]
    assert without_second_route(names) == set()
    assert second_route.CALCULATIONS.keys() | CLOSED_FORMS.keys() | OTHERS.keys() | SOLVED_ANEW.keys() <= set(names)
    assert sum(len(module.CALCULATIONS) for module in second_route.MODULES) == len(names)


def test_a_new_problem_without_a_second_route_is_found() -> None:
    assert without_second_route(["box-turned", "a-new-one"]) == {"a-new-one"}


@pytest.mark.parametrize("change", [1 + 1e-8, -1.0, 0.0])
def test_an_answer_that_is_not_so_is_found(change: float) -> None:
    file = next(file for file in FILES if file.stem == "skew-rod")
    calculated = singles(second_route.CALCULATIONS[file.stem](named(in_si(file, givens(file)))))
    for name, value in calculated.items():
        wrong = differences(calculated | {name: value * change if name != "L.y" else 1e-8}, answered(solved(file)))
        assert [line.split(":")[0] for line in wrong] == [name]


def test_the_second_routes_share_no_code_with_rotsolve() -> None:
    """Nor with tests that use it."""
    allowed = {
        "__future__",
        "collections",
        "math",
        "mpmath",
        "numpy",
        "pathlib",
        "random",
        "re",
        "second_route",
        "types",
        "typing",
        "yaml",
    }
    for path in sorted(Path(second_route.__file__).parent.glob("*.py")):
        nodes = list(ast.walk(ast.parse(path.read_text(encoding="utf-8"))))
        modules = [node.module or "" for node in nodes if isinstance(node, ast.ImportFrom)]
        modules += [alias.name for node in nodes if isinstance(node, ast.Import) for alias in node.names]
        assert {module.split(".")[0] for module in modules} <= allowed, path.name
