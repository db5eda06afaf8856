"""A shape from outside: a dumbbell, two particles of ½ m at the ends of a light rod, by one class and its place in SHAPES."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest

from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.vectors.tensor import InertiaTensor
from rotsolve.elements.tables import SHAPES
from rotsolve.language.shape import Place, Shape, extent
from rotsolve.pipeline import solve

SCENE = """
title: A dumbbell let go on a hinge at its end
given: {m: 2 kg, L: 0.5 m}
bodies: {bell: {shape: dumbbell, mass: m, length: L, turns: clockwise}}
connections: {pin: {hinge: bell.start}}
states: {level: {bell.angle: 0, bell.angular_velocity: 0}}
find:
  I: bell.inertia about bell.start
  alpha: bell.angular_acceleration at level
"""


class Dumbbell(Shape, frozen=True):
    word = "dumbbell"
    about = "two equal particles at the ends of a light rod"
    points = ("start", "center", "end")
    slender = True
    length: Formula | None = extent("distance of the particles", "L")

    def reach(self) -> Formula | None:
        return self.length

    def moment(self, mass: Formula) -> Formula:
        """2 · ½ m (L/2)² = ¼ m L²."""
        return mass * (self.length or ZERO) ** 2 / 4

    def tensor(self, mass: Formula) -> InertiaTensor:
        """Nothing about its own line."""
        return InertiaTensor(yy=self.moment(mass), zz=self.moment(mass))

    def locate(self, point: str, argument: Formula | None = None) -> Place:
        half = (self.length or ZERO) / 2
        return {"start": (-half, ZERO), "end": (half, ZERO)}.get(point, (ZERO, ZERO))


@pytest.fixture(autouse=True)
def declared() -> Iterator[None]:
    SHAPES.append(Dumbbell)
    yield
    SHAPES.remove(Dumbbell)


def test_it_is_solved() -> None:
    solution = solve(SCENE)
    assert solution.answers["I"].exact == "½ m L²"  # ¼ m L² + m (L/2)²
    assert solution.answers["alpha"].exact == "g/L"  # (m g ½ L)/(½ m L²)
    assert "moment of inertia, dumbbell" in str(solution)


def test_it_is_in_the_language(in_language: Callable[[str, str, str], None]) -> None:
    in_language("dumbbell", Dumbbell.about, SCENE)
