"""Unknowns that a state tells and the data leave without a value: what is asked of that state has no answer either."""

from __future__ import annotations

from math import acos, degrees, radians, sin

import numpy as np
import pytest

from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

HOOP = """title: A hoop with a lead at its rim at rest on a slope
given: {{m: {m}, M: {M}, R: {R}, beta: {beta}, phi: unknown, g: {g}}}
surfaces: {{ramp: {{slope: beta, down: {down}}}}}
bodies:
  hoop: {{shape: ring, mass: M, radius: R, moves: up, points: {{P: [0, R]}}}}
  lead: {{mass: m}}
{beside}connections: {{touch: {{rolls: [hoop, ramp]}}, glue: {{weld: [hoop.P, lead]}}}}
states: {{rest: {{hoop.angle: phi, balance: true}}}}
find: {{{find}}}
"""
LETTERS = {"m": "kg", "M": "kg", "R": "m", "beta": "deg", "g": "m/s^2"}
ASKED = ["phi: phi, f: touch.friction_force at rest", "f: touch.friction_force at rest, phi: phi"]


def hoop(beta: float | None, down: str, find: str) -> str:
    told = LETTERS if beta is None else {"m": "3 kg", "M": "1 kg", "R": "0.2 m", "beta": f"{beta} deg", "g": "10 m/s^2"}
    return HOOP.format(**told, down=down, find=find, beside="")


@pytest.mark.parametrize("find", ASKED)
@pytest.mark.parametrize("down", ["left", "right"])
@pytest.mark.parametrize("beta", [20, 45, 50, 60])
def test_a_place_that_the_data_leave_no_room_for_has_no_forces(beta: float, down: str, find: str) -> None:
    """The lead has to hang over the point of contact: at rest for (m + M) sin β ≤ m."""
    if 4 * sin(radians(beta)) > 3:
        with pytest.raises(Unsolvable, match="contradict"):
            solve(hoop(beta, down, find))
        return
    solution = solve(hoop(beta, down, find))
    assert solution.answers["f"].float == pytest.approx(-40 * sin(radians(beta)), rel=1e-3) and not solution.refused
    way = degrees(acos(4 * sin(radians(beta)) / 3))
    places = [sign * way if down == "left" else 180 - sign * way for sign in (1, -1)]
    found = degrees(solution.answers["phi"].float)
    assert any((found - place + 180) % 360 == pytest.approx(180, abs=0.1) for place in places)


@pytest.mark.parametrize("find", ASKED)
def test_in_letters_it_has_forces_where_it_has_a_place(find: str) -> None:
    """Each case of the forces is one of the place, with the same conditions."""
    solution = solve(hoop(None, "left", find))
    sets = ((3, 20, True), (3, 50, False), (0.5, 10, True), (0.5, 30, False))
    masses, slopes, possible = zip(*sets, strict=True)
    found = solution.evaluate_many({"m": masses, "M": 1.0, "R": 0.2, "beta": np.radians(slopes), "g": 10.0})
    for name in ("phi", "f"):
        assert list(np.isfinite(found[name])) == list(possible)


BEAM = """
title: A load on a beam that a force holds up
given: {M: 1 kg, m: 1 kg, L: 1 m, F: FORCE, x: unknown}
bodies: {beam: {shape: rod, mass: M, length: L}, load: {mass: m}}
connections: {pin: {hinge: beam.start}, place: {weld: [beam.at(x), load]}}
actions: {hold: {force: F, on: beam.end, direction: 120 deg}}
states: {rest: {beam.angle: 0, balance: true}}
find: {x: x, R: pin.force.y at rest}
"""


def test_what_hangs_on_a_place_that_there_is_none_of_has_no_answer_either() -> None:
    """F sin 60° L = ½ M g L + m g x: with 40 N x would be beyond the beam, and no support holds what is not."""
    found = solve(BEAM.replace("FORCE", "12 N"))
    assert found.answers["R"].float == pytest.approx(2 * 9.8 - 12 * sin(radians(60)))
    with pytest.raises(Unsolvable, match="no `x` that it can be"):
        solve(BEAM.replace("FORCE", "40 N"))
