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
LETTERS = {"m": "kg", "M": "kg", "R": "0.2 m", "beta": "deg", "g": "10 m/s^2"}
ASKED = ["phi: phi, f: touch.friction_force at rest", "f: touch.friction_force at rest, phi: phi"]


def hoop(beta: float | None, down: str, find: str) -> str:
    told = LETTERS if beta is None else {"m": "3 kg", "M": "1 kg", "R": "0.2 m", "beta": f"{beta} deg", "g": "10 m/s^2"}
    return HOOP.format(**told, down=down, find=find, beside="")


@pytest.mark.parametrize(
    ("beta", "down", "find"),
    [
        (beta, down, ASKED[(place + at) % 2])
        for place, beta in enumerate((20, 45, 50, 60))
        for at, down in enumerate(("left", "right"))
    ],
)
def test_a_place_that_the_data_leave_no_room_for_has_no_forces(beta: float, down: str, find: str) -> None:
    """The lead has to hang over the point of contact: at rest for (m + M) sin β ≤ m."""
    if 4 * sin(radians(beta)) > 3:
        with pytest.raises(Unsolvable, match="contradict"):
            solve(hoop(beta, down, find))
        return
    solution = solve(hoop(beta, down, find))
    assert solution.answers["f"].float == pytest.approx(40 * sin(radians(beta)), rel=1e-3) and not solution.refused
    way = degrees(acos(4 * sin(radians(beta)) / 3))
    places = [sign * way if down == "left" else 180 - sign * way for sign in (1, -1)]
    found = degrees(solution.answers["phi"].float)
    assert any((found - place + 180) % 360 == pytest.approx(180, abs=0.1) for place in places)


@pytest.mark.parametrize("find", ASKED)
def test_in_letters_it_has_forces_where_it_has_a_place(find: str) -> None:
    """Each case of the forces is one of the place, with the same conditions."""
    solution = solve(hoop(None, "left", find), confirm=False)
    sets = ((3, 20, True), (3, 50, False), (0.5, 10, True), (0.5, 30, False))
    masses, slopes, possible = zip(*sets, strict=True)
    found = solution.evaluate_many({"m": masses, "M": 1.0, "beta": np.radians(slopes)})
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


UNKNOWN = {  # an unknown letter that no question asks for, with numbers that it can have, and such that leave it none
    "mass": ("""
given: {m: 2 kg, M: unknown, a: VALUE}
bodies: {left: {mass: m, moves: up}, right: {mass: M, moves: down}, wheel: {shape: disc, mass: 1 kg, radius: 10 cm}}
connections: {ax: {axle: wheel}, rope: {string: [left, wheel, right]}}
states: {now: {left.acceleration: a}}
find: {T: rope.right.tension}
""", "3 m/s^2", ("15 m/s^2", "9.8 m/s^2")),
    "friction": ("""
given: {mu: unknown, u: VALUE}
surfaces: {ramp: {slope: 20 deg}}
bodies: {crate: {mass: 2 kg, moves: down}}
connections: {base: {contact: [crate, ramp], friction: mu}}
states: {start: {crate.velocity: u}, end: {crate.displacement: 2 m, crate.velocity: 2*u}}
find: {W: base.work from start to end}
""", "1 m/s", ("3 m/s",)),
    "stiffness": ("""
given: {k: unknown, u: VALUE}
bodies: {load: {mass: 2 kg, moves: down}}
connections: {coil: {spring: [ceiling, load], stiffness: k}}
states: {start: {coil.elongation: 0, at rest: all}, end: {coil.elongation: 0.5 m, load.velocity: u}}
find: {F: coil.force at end}
""", "2 m/s", ("4 m/s",)),
    "place": ("""
given: {d: unknown, T: VALUE}
bodies: {beam: {shape: rod, mass: 2 kg, length: 1 m}, man: {mass: 3 kg}}
connections: {pin: {hinge: beam.start}, cord: {string: [ceiling, beam.end]}, stand: {weld: [beam.at(d), man]}}
states: {now: {beam.angle: 0, balance: true, cord.tension: T}}
find: {F: pin.force.y at now}
""", "20 N", ("5 N", "50 N")),
    "angle": ("""
given: {beta: unknown, a: VALUE}
surfaces: {ramp: {slope: beta}}
bodies: {ball: {shape: sphere, mass: 2 kg, radius: 0.1 m, moves: down}}
connections: {base: {rolls: [ball, ramp]}}
states: {now: {ball.acceleration: a}}
find: {f: size of base.friction_force at now}
""", "3 m/s^2", ("8 m/s^2",)),
}  # fmt: skip


@pytest.mark.sampled(3)
@pytest.mark.parametrize("kind", UNKNOWN)
def test_an_unknown_that_no_question_asks_for_is_held_to_what_it_can_be(kind: str) -> None:
    scene, fits, others = UNKNOWN[kind]
    scene = f"title: An unknown {kind}{scene}"
    assert solve(scene.replace("VALUE", fits)).answers
    for value in others:
        with pytest.raises(Unsolvable, match=r"that it can be makes it so|contradict"):
            solve(scene.replace("VALUE", value))
    units = {"m/s^2": "m/s^2", "m/s": "m/s", "N": "N"}
    found = solve(scene.replace("VALUE", units[fits.split(" ")[1]]))
    assert any(answer.conditions for answer in found.derivation.answers)
