"""Case: a scene with the answers that it must have, worked out without rotsolve."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from fractions import Fraction

from mpmath import matrix, mp, mpf

from trials.draw import Value, decimal
from trials.scene import Scene

G = mpf("9.8")
DIGITS = (4, 6, 15, 50)  # at which a family is solved


@dataclass
class Case:
    """A scene as it is put together, and the numbers expected under its questions (signed, in SI units)."""

    scene: Scene
    expected: dict[str, mpf] = field(default_factory=dict)
    kind: str = ""

    def ask(self, name: str, phrase: str, value: mpf | None = None) -> None:
        """One more question; without a value nothing is known of its answer."""
        self.scene.setdefault("find", {})[name] = phrase
        if value is not None:
            self.expected[name] = value


@dataclass(frozen=True)
class Family:
    """A problem with the parameters at which it is solved."""

    name: str
    parameters: str
    cases: Callable[[], Iterable[Case]]
    digits: tuple[int, ...] = DIGITS


def scene(title: str, **sections: object) -> Scene:
    """A scene with its sections in their order; empty ones are left out."""
    return {"title": title, **{name: part for name, part in sections.items() if part}}


@dataclass
class Train:
    """Bodies that move together, by Lagrange's equations with constant coefficients: M q″ = Q.

    Every body adds an inertia (a mass, or a moment of inertia) with its rate as a row over the free coordinates, and every force the
    rate of its point of application: M = Σ m c cᵀ, Q = Σ F c.
    """

    degrees: int = 1
    inertias: list[tuple[mpf, tuple[mpf, ...]]] = field(default_factory=list)
    forces: list[tuple[mpf, tuple[mpf, ...]]] = field(default_factory=list)

    def body(self, inertia: mpf, *row: mpf, force: mpf | int = 0) -> None:
        self.inertias.append((inertia, row))
        self.forces.append((mpf(force), row))

    def push(self, force: mpf, *row: mpf) -> None:
        self.forces.append((force, row))

    def total(self) -> tuple[matrix, matrix]:
        masses, pushes = matrix(self.degrees), matrix(self.degrees, 1)
        for inertia, row in self.inertias:
            for i in range(self.degrees):
                for j in range(self.degrees):
                    masses[i, j] += inertia * row[i] * row[j]
        for force, row in self.forces:
            for i in range(self.degrees):
                pushes[i] += force * row[i]
        return masses, pushes

    def accelerations(self, resisting: mpf | int = 0) -> list[mpf]:
        """q″; with one coordinate the resistance acts against the motion, and holds it where it is strong enough."""
        masses, pushes = self.total()
        if self.degrees == 1:
            push = pushes[0]
            if abs(push) <= resisting:
                return [mpf(0)]
            return [(push - mp.sign(push) * resisting) / masses[0]]
        return list(mp.lu_solve(masses, pushes))


def letters(**values: Value) -> dict[str, str]:
    """Values as the givens of a scene."""
    return {name: value.text for name, value in values.items()}


def given(number: Fraction, unit: str) -> Value:
    return Value(f"{decimal(number)} {unit}".strip(), number)


def tenth(power: int) -> Fraction:
    return Fraction(1, 10**power)
