"""Linked bodies in the plane from places alone: M x − Jᵀ Λ = given, J x = ties, for blows and for accelerations; no code of the engine."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


class Bodies:
    """Bodies by name with mass, moment about and place of the centre of mass; rows of J with the names of their impulses."""

    def __init__(self) -> None:
        self.names: list[str] = []
        self.masses: list[float] = []
        self.inertias: list[float] = []
        self.places: list[Array] = []
        self.rows: list[tuple[str, list[tuple[str, Array, Array]]]] = []

    def add(self, name: str, mass: float, inertia: float, place: Sequence[float]) -> None:
        self.names.append(name)
        self.masses.append(mass)
        self.inertias.append(inertia)
        self.places.append(np.array(place, dtype=float))

    def row(self, parts: Sequence[tuple[str, Array, Array]]) -> Array:
        """How fast points move along directions, added up, in terms of (x, y, θ) of all bodies."""
        result = np.zeros(3 * len(self.names))
        for name, point, way in parts:
            k = self.names.index(name)
            arm = point - self.places[k]
            result[3 * k : 3 * k + 3] += way[0], way[1], arm[0] * way[1] - arm[1] * way[0]
        return result

    def pin(self, joint: str, point: Array, last: str, first: str = "") -> None:
        """Two points, or one and the ground, move together; its impulse is that on the last body."""
        for axis, way in (("x", np.array([1.0, 0.0])), ("y", np.array([0.0, 1.0]))):
            other = [(first, point, -way)] if first else []
            self.rows.append((f"{joint}.{axis}", [(last, point, way), *other]))

    def struck(self, before: Array, pushes: Sequence[tuple[str, Array, Array]]) -> tuple[Array, dict[str, float]]:
        """Speeds after, and the impulses of the constraints: M v − Jᵀ Λ = M v₀ + P, J v = 0."""
        jacobian, mass = (
            np.array([self.row(parts) for _, parts in self.rows]).reshape(-1, 3 * len(self.names)),
            self.mass(),
        )
        given = mass @ before + sum((self.row([push]) for push in pushes), np.zeros(len(mass)))
        return self.solution(mass, jacobian, given, np.zeros(len(jacobian)))

    def bounced(
        self,
        before: Array,
        pushes: Sequence[tuple[str, Array, Array]],
        hits: Sequence[tuple[str, Sequence[tuple[str, Array, Array]], float]],
    ) -> tuple[Array, dict[str, float]]:
        """Speeds after, and the impulses of constraints and of hits at once: M v − Jᵀ Λ − Nᵀ P = M v₀ + P₀, J v = 0, N v = −e N v₀."""
        rows = [self.row(parts) for _, parts in self.rows]
        normals = [self.row(parts) for _, parts, _ in hits]
        jacobian = np.array([*rows, *normals]).reshape(-1, 3 * len(self.names))
        ties = [0.0] * len(rows) + [
            -bounce * float(row @ before) for row, (_, _, bounce) in zip(normals, hits, strict=True)
        ]
        given = self.mass() @ before + sum((self.row([push]) for push in pushes), np.zeros(len(before)))
        found, impulses = self.solution(self.mass(), jacobian, given, np.array(ties), [name for name, _, _ in hits])
        return found, impulses

    def energy(self, speeds: Array) -> float:
        return float(speeds @ self.mass() @ speeds) / 2

    def mass(self) -> Array:
        return np.diag([x for m, i in zip(self.masses, self.inertias, strict=True) for x in (m, m, i)])

    def solution(
        self, mass: Array, jacobian: Array, given: Array, ties: Array, more: Sequence[str] = ()
    ) -> tuple[Array, dict[str, float]]:
        """x and Λ of M x − Jᵀ Λ = given, J x = ties."""
        count = len(jacobian)
        matrix = np.block([[mass, -jacobian.T], [jacobian, np.zeros((count, count))]])
        found = np.linalg.solve(matrix, np.concatenate([given, ties]))
        names = [name for name, _ in self.rows] + list(more)
        return found[: len(mass)], dict(zip(names, found[len(mass) :], strict=True))

    def moving(self, speeds: Array, pushes: Sequence[tuple[str, Array, Array]]) -> tuple[Array, dict[str, float]]:
        """Accelerations and the forces of the constraints: M a − Jᵀ λ = Q, J a = −J̇ v, a point at r having −ω² r beside."""
        jacobian, mass = np.array([self.row(parts) for _, parts in self.rows]), self.mass()
        inward = [sum(self.inward(speeds, *part) for part in parts) for _, parts in self.rows]
        given = sum((self.row([push]) for push in pushes), np.zeros(len(mass)))
        return self.solution(mass, jacobian, given, np.array(inward))

    def inward(self, speeds: Array, name: str, point: Array, way: Array) -> float:
        """ω² r along a direction."""
        k = self.names.index(name)
        return float(speeds[3 * k + 2] ** 2 * (point - self.places[k]) @ way)


def direction(angle: float) -> Array:
    return np.array([np.cos(angle), np.sin(angle)])
