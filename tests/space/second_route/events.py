"""Events: what holds or joins bodies all at once, as the motion of heavy points nearest to the one before, by their masses.

Impulses that do no work on any motion that is allowed then leave √m v as its projection on these motions (Carnot's theorem).
"""

from __future__ import annotations

from types import SimpleNamespace as Numbers
from typing import Any

import numpy as np

from second_route.particles import Cloud, X, Y, Z, cuboid, points, rectangle, together, with_moments

Answers = dict[str, Any]


def nearest(body: Cloud, before: Any, allowed: list[Any]) -> Any:
    """The shares of the allowed motions, each the velocities of all points, with which Σ m (v′ − v)² is least."""
    weights = np.sqrt(body.masses)[:, None]
    columns = np.array([(weights * motion).ravel() for motion in allowed]).T
    return np.linalg.lstsq(columns, (weights * before).ravel(), rcond=None)[0]


def as_one(places: Any) -> list[Any]:
    """The six motions of what is rigid: along the axes, and about those through the origin."""
    return [np.tile(axis, (len(places), 1)) for axis in (X, Y, Z)] + [np.cross(axis, places) for axis in (X, Y, Z)]


def energy(body: Cloud, velocities: Any) -> float:
    return float(body.masses @ (velocities**2).sum(axis=1)) / 2


def cube_caught_at_an_edge(n: Numbers) -> Answers:
    """All turns about the edge alone."""
    cube = cuboid(n.M, n.a, n.a, n.a)
    before = np.cross(np.full(3, n.w / np.sqrt(3)), cube.places)
    about_edge = np.cross(Y, cube.places - n.a / 2 * (X - Z))
    (rate,) = nearest(cube, before, [about_edge])
    after = rate * about_edge
    lost = energy(cube, before) - energy(cube, after)
    return {"W": rate * Y, "J": cube.masses @ (after - before), "K": lost}


def meteorite_that_stays_in_a_probe(n: Numbers) -> Answers:
    """The probe as heavy points with these moments, and one more for the stone."""
    probe = with_moments(n.M, n.I1, n.I2, n.I3)
    whole = together(probe, points((n.m, n.d * X)))
    before = np.zeros_like(whole.places)
    before[-1] = [-n.u, n.v, n.w]
    motions = as_one(whole.places)
    shares = nearest(whole, before, motions)
    after = np.tensordot(shares, motions, 1)
    lost = energy(whole, before) - energy(whole, after)
    return {"omega": shares[3:], "J": whole.masses[:-1] @ after[:-1], "K": lost}


def hinged_plates_that_are_struck(n: Numbers) -> Answers:
    """Both go as one, and the second besides about the hinge; a blow is a heavy point's velocity of its own."""
    one, two = rectangle(n.m, n.a, n.b), rectangle(n.m, n.a, n.b).moved(n.a * X)
    corner, light = np.array([-n.a / 2, n.b / 2, 0]), 1e-11 * n.m
    whole = together(one, two, points((light, corner)))
    before = np.zeros_like(whole.places)
    before[-1] = n.J / light * Z
    count = len(one.masses)
    bent = np.cross(Y, whole.places - n.a / 2 * X)
    bent[:count], bent[-1] = 0, 0
    motions = [*as_one(whole.places), bent]
    shares = nearest(whole, before, motions)
    after = np.tensordot(shares, motions, 1)
    changes = two.masses[:, None] * after[count:-1]
    far = shares[:3] + np.cross(shares[3:6] + shares[6] * Y, np.array([3 * n.a / 2, -n.b / 2, 0]))
    far -= np.cross(shares[6] * Y, n.a / 2 * X)
    return {
        "w_1": shares[3:6],
        "w_2": shares[3:6] + shares[6] * Y,
        "P": changes.sum(axis=0),
        "H": np.cross(two.places - n.a / 2 * X, changes).sum(axis=0),
        "v": np.linalg.norm(after[-1] - far),
    }


CALCULATIONS = {
    "cube-caught-at-an-edge": cube_caught_at_an_edge,
    "hinged-plates-that-are-struck": hinged_plates_that_are_struck,
    "meteorite-that-stays-in-a-probe": meteorite_that_stays_in_a_probe,
}
