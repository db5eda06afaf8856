"""A size and an angle that are both sought: told by their components, whatever the angle counts from."""

from __future__ import annotations

from cmath import exp, phase
from math import degrees, radians

import pytest

import rotsolve

ROTOR = """
title: A rotor in balance
up: z
gravity: none
given: {m1: 2 kg, m2: 3 kg, r1: 80 mm, r2: 70 mm, r: RADIUS, m: MASS, q: unknown, w: 10 rad/s}
bodies:
  rotor:
    parts:
      A: {mass: m1, at: [r1, 0, 0]}
      B: {mass: m2, at: [r2*cos(115 deg), r2*sin(115 deg), 0]}
      X: {mass: m, at: PLACE}
    points: {O: [0, 0, 0]}
connections: {axis: {hinge: rotor.O, along: z, angular_velocity: w}}
states: {now: {rotor.angle: STANDS, axis.force.x: 0 N, axis.force.y: 0 N}}
find: {q: q in deg, p: SIZE, turned: 90 deg - q in deg, I: rotor.inertia along z about rotor.O}
"""
LUMPS = 2 * 0.08 + 3 * 0.07 * exp(1j * radians(115))  # Σ m r of what is to be balanced, in kg m
# where the third lump is at the angle q, and the direction of that at q = 0
PLACES = {
    "from x": ("[r*cos(q), r*sin(q), 0]", 1),
    "from y": ("[-r*sin(q), r*cos(q), 0]", 1j),
    "from an oblique line": ("[r*cos(q + 30 deg), r*sin(q + 30 deg), 0]", exp(1j * radians(30))),
    "clockwise": ("[r*cos(q), -r*sin(q), 0]", 1),
}


@pytest.mark.parametrize("stands", ["0 deg", "20 deg"])
@pytest.mark.parametrize("place", PLACES)
def test_a_mass_and_its_angle(place: str, stands: str) -> None:
    words, start = PLACES[place]
    scene = ROTOR.replace("PLACE", words).replace("STANDS", stands).replace("RADIUS", "0.1 m")
    solution = rotsolve.solve(scene.replace("MASS", "unknown").replace("SIZE", "m"))
    answers = solution.answers
    needed = -LUMPS / start
    angle = phase(needed.conjugate() if place == "clockwise" else needed)
    assert answers["q"].float == pytest.approx(degrees(angle), rel=1e-12)
    assert answers["turned"].float == pytest.approx(90 - degrees(angle), rel=1e-12)
    assert answers["p"].float == pytest.approx(abs(LUMPS) / 0.1, rel=1e-12)
    assert answers["I"].float == pytest.approx(2 * 0.08**2 + 3 * 0.07**2 + abs(LUMPS) * 0.1, rel=1e-12)
    assert [item.holds for item in solution.derivation.confirmed] == [True] * 4


def test_a_place_by_its_distance_and_angle() -> None:
    scene = ROTOR.replace("PLACE", PLACES["from x"][0]).replace("STANDS", "0 deg").replace("RADIUS", "unknown")
    answers = rotsolve.solve(scene.replace("MASS", "1.5 kg").replace("SIZE", "r")).answers
    assert answers["p"].float == pytest.approx(abs(LUMPS) / 1.5, rel=1e-12)
    assert answers["q"].float == pytest.approx(degrees(phase(-LUMPS)), rel=1e-12)


def test_where_nothing_is_needed_no_angle_is_told() -> None:
    scene = ROTOR.replace("r1, 0, 0", "r2*cos(65 deg), -r2*sin(65 deg), 0").replace("m1: 2 kg", "m1: 3 kg")
    scene = scene.replace("PLACE", PLACES["from x"][0]).replace("STANDS", "0 deg").replace("RADIUS", "0.1 m")
    with pytest.raises(rotsolve.Unsolvable, match="`m` is found that fits"):
        rotsolve.solve(scene.replace("MASS", "unknown").replace("SIZE", "m"))
