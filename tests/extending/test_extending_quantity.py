"""An asked quantity from outside: the speed of a body's rim, v = R |ω|, by a row of words and a row that says what it means."""

from __future__ import annotations

import pytest

from rotsolve.algebra.formula import Formula
from rotsolve.core.quantity import BODY, QUANTITIES, kind
from rotsolve.language.problem import Path, Term
from rotsolve.paths.bodies import OF_BODIES, OfBodies
from rotsolve.paths.meaning import Meant, absolute
from rotsolve.pipeline import solve
from rotsolve.scene.reference import describe_word, generate

SCENE = """
title: Rim of a flywheel
given: {m: 10 kg, R: 0.5 m, tau: 6 N m, t: 4 s}
bodies: {wheel: {shape: disc, mass: m, radius: R}}
connections: {axle: {axle: wheel}}
actions: {motor: {couple: tau, on: wheel}}
states: {start: at rest, later: {time: t}}
find: {v: wheel.rim_speed at later}
"""


def rim_speed(at: OfBodies, path: Path, term: Term | None) -> Meant:
    """R |ω|."""
    spin = OF_BODIES["angular_velocity"](at, Path(path.owner, "angular_velocity"), None)
    radius = OF_BODIES["radius"](at, path, None)
    assert isinstance(spin, Formula) and isinstance(radius, Formula)
    return absolute(radius * spin)


@pytest.fixture(autouse=True)
def declared(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(QUANTITIES, "rim_speed", kind("rim_speed", "velocity", "v", (BODY,), "speed of the rim"))
    monkeypatch.setitem(OF_BODIES, "rim_speed", rim_speed)


def test_it_is_solved() -> None:
    solution = solve(SCENE)
    answer = solution.answers["v"]
    assert str(answer.value) == "9.6" and answer.unit == "m/s"
    print(solution)


def test_it_is_described() -> None:
    assert "speed of the rim" in describe_word("rim_speed")
    assert "| `rim_speed` | v | body |" in generate()
