"""Rigid bodies as heavy points, and Newton's second law for each of them: no tensor, no Euler equation, no axes that turn.

A body is stood for by a few heavy points that have its mass, its centre and all its second moments: Gauss's nodes carry out
integrals of polynomials exactly. Where points are is told as a function of time, and velocities and accelerations are taken from
that by Cauchy's integral.
"""

from __future__ import annotations

from collections.abc import Callable
from math import pi
from typing import Any, NamedTuple

import numpy as np

Array = Any  # of NumPy, which mypy does not read here
X, Y, Z = np.eye(3)
NODES = 32  # on the circle of Cauchy's integral: of sin(t) the first power that is missed is 1/32!


class Cloud(NamedTuple):
    """Heavy points: masses, and places as rows."""

    masses: Array
    places: Array

    def moved(self, by: Array) -> Cloud:
        return Cloud(self.masses, self.places + by)

    def turned(self, rotation: Array) -> Cloud:
        return Cloud(self.masses, self.places @ rotation.T)

    @property
    def mass(self) -> float:
        return float(sum(self.masses))


def together(*clouds: Cloud) -> Cloud:
    return Cloud(np.concatenate([one.masses for one in clouds]), np.concatenate([one.places for one in clouds]))


def points(*items: tuple[float, Array]) -> Cloud:
    """Particles, each with its mass and its place."""
    return Cloud(np.array([mass for mass, _ in items]), np.array([place for _, place in items], dtype=float))


def spread(mass: float, *axes: tuple[Array, Array]) -> Cloud:
    """A product of nodes along x, y and z: of each axis the places and their shares."""
    places = np.array(np.meshgrid(*(axis[0] for axis in axes), indexing="ij")).reshape(3, -1).T
    shares = np.prod(np.meshgrid(*(axis[1] for axis in axes), indexing="ij"), axis=0).ravel()
    return Cloud(mass * shares, places)


def evenly(length: float) -> tuple[Array, Array]:
    """Gauss's nodes of a length whose middle is at 0, and their shares."""
    nodes, weights = np.polynomial.legendre.leggauss(3)
    return nodes * length / 2, weights / 2


ONLY = (np.zeros(1), np.ones(1))


def rod(mass: float, length: float) -> Cloud:
    """Along x."""
    return spread(mass, evenly(length), ONLY, ONLY)


def rectangle(mass: float, a: float, b: float) -> Cloud:
    return spread(mass, evenly(a), evenly(b), ONLY)


def cuboid(mass: float, a: float, b: float, c: float) -> Cloud:
    return spread(mass, evenly(a), evenly(b), evenly(c))


def ring(mass: float, radius: float) -> Cloud:
    """About z: eight points."""
    angles = np.arange(8) * pi / 4
    return Cloud(np.full(8, mass / 8), radius * np.array([np.cos(angles), np.sin(angles), 0 * angles]).T)


def disc(mass: float, radius: float) -> Cloud:
    """Rings, of which each has the share 2 r dr/R² of the mass."""
    nodes, weights = np.polynomial.legendre.leggauss(3)
    radii = (1 + nodes) / 2
    return together(*(ring(mass * w * r, radius * r) for r, w in zip(radii, weights, strict=True)))


def cylinder(mass: float, radius: float, length: float) -> Cloud:
    places, shares = evenly(length)
    return together(*(disc(mass * share, radius).moved(z * Z) for z, share in zip(places, shares, strict=True)))


def cone(mass: float, radius: float, height: float) -> Cloud:
    """About z, its tip at the origin, its base below: discs, of which each has the share 3 z² dz/h³ of the mass."""
    nodes, weights = np.polynomial.legendre.leggauss(4)
    depths = (1 + nodes) / 2
    slices = zip(depths, weights, strict=True)
    return together(*(disc(mass * 1.5 * w * d * d, radius * d).moved(-height * d * Z) for d, w in slices))


def tube(mass: float, radius: float, length: float) -> Cloud:
    places, shares = evenly(length)
    return together(*(ring(mass * share, radius).moved(z * Z) for z, share in zip(places, shares, strict=True)))


def sphere(mass: float, radius: float) -> Cloud:
    """A thin one: rings, of which each has the share dz/(2 R) of the mass."""
    heights, shares = evenly(2 * radius)
    rings = zip(heights, shares, strict=True)
    return together(*(ring(mass * share, np.sqrt(radius**2 - z * z)).moved(z * Z) for z, share in rings))


def ball(mass: float, radius: float) -> Cloud:
    """A solid sphere: thin ones, of which each has the share 3 r² dr/R³ of the mass."""
    nodes, weights = np.polynomial.legendre.leggauss(3)
    radii = (1 + nodes) / 2
    return together(*(sphere(mass * 1.5 * w * r * r, radius * r) for r, w in zip(radii, weights, strict=True)))


def with_moments(mass: float, first: float, second: float, third: float) -> Cloud:
    """Six points on the axes x, y and z that have these principal moments."""
    half = (first + second + third) / 2
    reach = [np.sqrt((half - moment) * 3 / mass) for moment in (first, second, third)]
    return points(*((mass / 6, s * a * e) for a, e in zip(reach, (X, Y, Z), strict=True) for s in (1, -1)))


def top(mass: float, distance: float, across: float, axial: float) -> Cloud:
    """A symmetric top about z with its tip at the origin, and moments about the tip."""
    central = across - mass * distance**2
    return with_moments(mass, central, central, axial).moved(distance * Z)


def turn(axis: Array, angle: Any) -> Array:
    """The rotation by an angle, which may be complex, about an axis: Rodrigues' formula."""
    n = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    cross = np.array([[0, -n[2], n[1]], [n[2], 0, -n[0]], [-n[1], n[0], 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def derivatives(function: Callable[[Any], Array], scale: float) -> tuple[Array, Array, Array]:
    """Value, first and second derivative at 0 of a function that is entire, from its values on a circle of radius `scale`."""
    circle = np.exp(2j * pi * np.arange(NODES) / NODES)
    values = [np.asarray(function(scale * place)) for place in circle]
    sums = (
        sum(value * place**-k for value, place in zip(values, circle, strict=True)) / (NODES * scale**k)
        for k in range(3)
    )
    value, first, second = (np.real(item) for item in sums)
    return value, first, 2 * second


class Motion:
    """A cloud whose places are `at(t)`; all sums are at t = 0. `rate`: the size of its fastest angular velocity."""

    def __init__(self, cloud: Cloud, at: Callable[[Any], Array], rate: float) -> None:
        self.masses = cloud.masses
        self.places, self.velocities, self.accelerations = derivatives(at, 1 / abs(rate))

    @classmethod
    def about_origin(cls, cloud: Cloud, attitude: Callable[[Any], Array], rate: float) -> Motion:
        return cls(cloud, lambda t: cloud.places @ attitude(t).T, rate)

    def momentum(self) -> Array:
        return self.masses @ self.velocities

    def angular_momentum(self, about: Array = 0 * X) -> Array:
        return self.masses @ np.cross(self.places - about, self.velocities)

    def kinetic_energy(self) -> float:
        return float(self.masses @ (self.velocities**2).sum(axis=1)) / 2

    def force(self, field: Array = 0 * X) -> Array:
        """What has to act beside a field of gravity: Σ m (a − g)."""
        return self.masses @ (self.accelerations - field)

    def torque(self, field: Array = 0 * X, about: Array = 0 * X) -> Array:
        """What has to act beside a field of gravity: Σ r × m (a − g)."""
        return self.masses @ np.cross(self.places - about, self.accelerations - field)


def moment(cloud: Cloud, axis: Array) -> float:
    """Σ m |n × r|² about an axis through the origin."""
    n = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    return float(cloud.masses @ (np.cross(n, cloud.places) ** 2).sum(axis=1))


def momenta(cloud: Cloud) -> Array:
    """The matrix from velocity of the origin and angular velocity to momentum and angular momentum about the origin."""
    columns = []
    for k in range(6):
        velocities = (
            np.tile(np.eye(3)[k], (len(cloud.masses), 1)) if k < 3 else np.cross(np.eye(3)[k - 3], cloud.places)
        )
        columns.append([*(cloud.masses @ velocities), *(cloud.masses @ np.cross(cloud.places, velocities))])
    return np.array(columns).T


def tensor(cloud: Cloud) -> Array:
    """From angular velocity to angular momentum about the origin."""
    return momenta(cloud)[3:, 3:]


def two_bearings(force: Array, torque: Array, axis: Array, first: float, second: float) -> tuple[Array, Array]:
    """The forces across the axis of two bearings at places along it, which make up a force and a torque about the origin."""
    n = np.asarray(axis, dtype=float) / np.linalg.norm(axis)
    across = force - (force @ n) * n
    turned = np.cross(torque, n)  # of torque = Σ s n × F: across parts of Σ s F
    other = (turned - first * across) / (second - first)
    return across - other, other


def degrees_between(one: Array, other: Array) -> float:
    return float(np.degrees(np.arctan2(np.linalg.norm(np.cross(one, other)), one @ other)))


def root(function: Callable[[float], float], low: float, high: float) -> float:
    """Where a function changes its sign, to the last digits: chords, of which the end that stays counts half (Illinois)."""
    below, above = function(low), function(high)
    assert (below > 0) != (above > 0)
    last, found = low, high
    while abs(found - last) > 1e-15 * abs(found):
        last, found = found, (low * above - high * below) / (above - below)
        value = function(found)
        if (value > 0) == (above > 0):
            high, above, below = found, value, below / 2
        else:
            low, below, above = found, value, above / 2
    return found
