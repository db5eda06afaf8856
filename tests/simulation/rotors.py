"""Rotors: rigid bodies followed with many digits by another route: the matrix of the rotation, L in space, extrapolated midpoint steps.

Ṙ = [ω]× R, ω = R I⁻¹ Rᵀ L, L̇ = τ about a fixed point or the centre of mass; no quaternion, no angle, no axes that turn.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import mpmath

Vector = list[mpmath.mpf]
Matrix = mpmath.matrix
Torque = Callable[[Matrix, mpmath.mpf], Sequence[mpmath.mpf]]  # from the rotation and the time
LEVELS = 10


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


def turning(rotation: Matrix, omega: Sequence[mpmath.mpf]) -> Vector:
    """[ω]× R, row by row."""
    columns = [cross(omega, [rotation[i, k] for i in range(3)]) for k in range(3)]
    return [columns[k][i] for i in range(3) for k in range(3)]


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
        return [*turning(rotation, omega), *self.torque(rotation, time)]

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


class RollingCoin(Rotor):
    """A thin disc whose lowest point is at rest on a level floor; its state has R, ω in space and the way of its centre.

    With r from the centre to that point, v = −ω × r and (I + m (r² 1 − r rᵀ)) α = −ω × I ω − m r × (ω × ṙ) − m r × g.
    """

    def __init__(
        self, mass: mpmath.mpf, radius: mpmath.mpf, weight: mpmath.mpf, start: Matrix, omega: Sequence[mpmath.mpf]
    ) -> None:
        tensor = mass * radius**2 / 4 * mpmath.diag([1, 1, 2])
        super().__init__(tensor, start, omega, lambda rotation, time: [])
        self.mass, self.radius, self.gravity = mass, radius, weight / mass
        self.state = [*start, *times(start, omega), mpmath.mpf(0), mpmath.mpf(0), mpmath.mpf(0)]

    def omega(self, state: Vector) -> Vector:
        return state[9:12]

    def lowest(self, state: Vector) -> tuple[Vector, Vector]:
        """r and its rate: −R times the unit vector that points up along the disc."""
        n = [state[2], state[5], state[8]]
        faster = cross(self.omega(state), n)
        sine = mpmath.sqrt(1 - n[2] ** 2)
        rate = -n[2] * faster[2] / sine
        up = [-n[2] * n[0], -n[2] * n[1], 1 - n[2] ** 2]
        change = [-faster[2] * a - n[2] * b for a, b in zip(n, faster, strict=True)]
        place = [-self.radius * part / sine for part in up]
        return place, [-self.radius * (a / sine - b * rate / sine**2) for a, b in zip(change, up, strict=True)]

    def slope(self, time: mpmath.mpf, state: Vector) -> Vector:
        rotation, omega, (r, rate) = self.rotation(state), self.omega(state), self.lowest(state)
        tensor = rotation * self.tensor * rotation.T
        column = mpmath.matrix(r)
        whole = tensor + self.mass * ((column.T * column)[0] * mpmath.eye(3) - column * column.T)
        pulled = [a + b for a, b in zip(cross(omega, rate), [0, 0, -self.gravity], strict=True)]
        left = zip(cross(omega, times(tensor, omega)), cross(r, pulled), strict=True)
        alpha = mpmath.lu_solve(whole, mpmath.matrix([-a - self.mass * b for a, b in left]))
        return [*turning(rotation, omega), *alpha, *(-part for part in cross(omega, r))]

    def told(self, name: str) -> dict[str, mpmath.mpf]:
        rotation, omega = self.rotation(self.state), self.omega(self.state)
        momentum = times(rotation * self.tensor * rotation.T, omega)
        found = {f"{name}.position.{a}": part for a, part in zip("xyz", self.state[12:], strict=True)}
        found |= {f"{name}.angular_momentum.{a}": part for a, part in zip("xyz", momentum, strict=True)}
        return found | {
            f"{name}.{a}_axis.{b}": rotation[i, k] for k, a in enumerate("xyz") for i, b in enumerate("xyz")
        }
