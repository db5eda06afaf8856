"""Rotors: rigid bodies followed with many digits by another route: the matrix of the rotation, L in space, extrapolated midpoint steps.

Ṙ = [ω]× R, ω = R I⁻¹ Rᵀ L, L̇ = τ about a fixed point or the centre of mass; no quaternion, no angle, no axes that turn.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import mpmath

Vector = list[mpmath.mpf]
Matrix = mpmath.matrix
Torque = Callable[[Matrix, mpmath.mpf], Sequence[mpmath.mpf]]  # from the rotation and the time
LEVELS = 14


def cross(a: Sequence[mpmath.mpf], b: Sequence[mpmath.mpf]) -> Vector:
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def times(matrix: Matrix, vector: Sequence[mpmath.mpf]) -> Vector:
    return [sum(matrix[i, j] * vector[j] for j in range(3)) for i in range(3)]


def turn(axis: str, angle: mpmath.mpf) -> Matrix:
    """The rotation about one of the axes of space."""
    c, s = mpmath.cos(angle), mpmath.sin(angle)
    i, j = {"x": (1, 2), "y": (2, 0), "z": (0, 1)}[axis]
    found = mpmath.eye(3)
    found[i, i], found[i, j], found[j, i], found[j, j] = c, -s, s, c
    return found


class Rotor:
    """A rigid body about a fixed point or its centre of mass."""

    def __init__(self, tensor: Matrix, start: Matrix, omega: Sequence[mpmath.mpf], torque: Torque) -> None:
        """`omega` in the body's axes at first; `torque` in space."""
        self.tensor, self.inverse, self.torque = tensor, mpmath.inverse(tensor), torque
        self.state = [*start, *times(start, times(tensor, omega))]
        self.time = mpmath.mpf(0)

    def omega(self, state: Vector) -> Vector:
        rotation = self.rotation(state)
        return times(rotation, times(self.inverse, times(rotation.T, state[9:])))

    @staticmethod
    def rotation(state: Vector) -> Matrix:
        return mpmath.matrix(3, 3) + mpmath.matrix([state[0:3], state[3:6], state[6:9]])

    def slope(self, time: mpmath.mpf, state: Vector) -> Vector:
        rotation, omega = self.rotation(state), self.omega(state)
        columns = [cross(omega, [rotation[i, k] for i in range(3)]) for k in range(3)]
        return [*(columns[k][i] for i in range(3) for k in range(3)), *self.torque(rotation, time)]

    def go(self, until: mpmath.mpf, step: float) -> None:
        """Goes on to a time."""
        count = max(1, int(mpmath.ceil((until - self.time) / step)))
        size = (until - self.time) / count
        for _ in range(count):
            self.state = self.extrapolated(size)
            self.time += size

    def extrapolated(self, size: mpmath.mpf) -> Vector:
        """One step by Gragg's rule with more and more midpoints, carried to the limit (Aitken, Neville)."""
        rows: list[list[Vector]] = []
        for level in range(LEVELS):
            n = 2 * (level + 1)
            row = [self.midpoints(size, n)]
            for k, before in enumerate(rows[-1] if rows else []):
                factor = (mpmath.mpf(n) / (2 * (level - k))) ** 2 - 1
                row.append([a + (a - b) / factor for a, b in zip(row[-1], before, strict=True)])
            rows.append(row)
        return rows[-1][-1]

    def midpoints(self, size: mpmath.mpf, count: int) -> Vector:
        h = size / count
        before = self.state
        now = [a + h * b for a, b in zip(before, self.slope(self.time, before), strict=True)]
        for k in range(1, count):
            slope = self.slope(self.time + k * h, now)
            before, now = now, [a + 2 * h * b for a, b in zip(before, slope, strict=True)]
        slope = self.slope(self.time + size, now)
        return [(a + b + h * c) / 2 for a, b, c in zip(now, before, slope, strict=True)]

    def told(self, name: str) -> dict[str, mpmath.mpf]:
        """What `simulate` tells of a body of this name."""
        rotation, omega = self.rotation(self.state), self.omega(self.state)
        own, momentum = times(rotation.T, omega), self.state[9:]
        found = {f"{name}.angular_velocity.{a} in body axes": part for a, part in zip("xyz", own, strict=True)}
        found |= {f"{name}.angular_momentum.{a}": part for a, part in zip("xyz", momentum, strict=True)}
        found |= {f"{name}.{a}_axis.{b}": rotation[i, k] for k, a in enumerate("xyz") for i, b in enumerate("xyz")}
        return found
