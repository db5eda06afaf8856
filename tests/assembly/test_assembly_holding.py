"""What holds at first and gives way later, by the assembly: friction at its limit slips, whatever grows on the way, and may hold again."""

from __future__ import annotations

import math

import pytest

from rotsolve.confirm.course.asked import Asker
from rotsolve.confirm.course.following import Course
from rotsolve.confirm.course.node import Budget
from rotsolve.confirm.course.samples import sets_of_numbers
from rotsolve.confirm.course.verdict import BUDGET
from rotsolve.motion.complete import configured
from rotsolve.scene.read import read_source

G = 9.8
CLOSE = 1e-7


def asked(text: str, instants: int = BUDGET) -> dict[str, float]:
    """What the assembly answers to the questions of a scene, within the budget that it has when it confirms answers."""
    problem = configured(read_source("title: by hand\n" + text)).problem
    asker = Asker(problem, Course(problem, dict(next(sets_of_numbers(problem))), Budget(instants)))
    return {find.name: asker.answer(find, {}).number for find in problem.finds}


WHEEL = """
bodies: {wheel: {inertia: 2 kg m^2, radius: 0.5 m}}
connections: {axle: {axle: wheel%s}}
actions: {motor: {couple: %s, on: wheel}%s}
states: {start: at rest, end: {time: %s s}}
find: {w: wheel.angular_velocity at end}
"""
ROUGH = ", friction_torque: 10 N m"


@pytest.mark.parametrize("sign", [1, -1])
def test_a_growing_couple_overcomes_the_axle(sign: int) -> None:
    """I ω̇ = c t − τ from τ/c = 2 s on."""
    found = asked(WHEEL % (ROUGH, f"{5 * sign} N m/s * time", "", 6))
    assert found["w"] == pytest.approx(sign * 5 * (6 - 2) ** 2 / (2 * 2), rel=CLOSE)


def test_a_growing_couple_overcomes_a_brake_and_a_brake_that_is_let_go_gives_way() -> None:
    """The block holds up to μ P R; with P = P₀ − k t it gives way where that has come down to the couple."""
    growing = WHEEL % ("", "5 N m/s * time", ", brake: {press: 50 N, on: wheel.rim, friction: 0.4}", 6)
    assert asked(growing)["w"] == pytest.approx(20.0, rel=CLOSE)
    fading = WHEEL % ("", "6 N m", ", brake: {press: 50 N - 4 N/s * time, on: wheel.rim, friction: 0.4}", 8)
    assert asked(fading)["w"] == pytest.approx(0.5 * 0.8 * (8 - 5) ** 2 / 2, rel=CLOSE)  # 0.2 (50 − 4 t) = 6 at 5 s


def test_what_gives_way_only_for_a_while_holds_again_at_the_end() -> None:
    """8 sin 2t passes 3 on the way, and is back below it where the phase ends."""
    found = asked(WHEEL % (", friction_torque: 3 N m", "8 N m * sin(2 rad/s * time)", "", 1.5))
    first = math.asin(3 / 8) / 2
    gained = (4 * (math.cos(2 * first) - math.cos(2 * 1.5)) - 3 * (1.5 - first)) / 2
    assert found["w"] == pytest.approx(gained, rel=CLOSE)


def test_a_block_is_pulled_harder_and_harder_up_a_slope() -> None:
    """It rests while c t ≤ m g (sin β + μₛ cos β)."""
    text = """
given: {m: 2 kg, beta: 20 deg, c: 3 N/s}
surfaces: {ramp: {slope: beta}}
bodies: {block: {mass: m, moves: up}}
connections: {base: {contact: [block, ramp], friction: {static: 0.5, kinetic: 0.4}}}
actions: {pull: {force: c*time, on: block}}
states: {start: at rest, end: {time: 8 s}}
find: {v: block.velocity at end}
"""
    sine, cosine = math.sin(math.radians(20)), math.cos(math.radians(20))
    start = 2 * G * (sine + 0.5 * cosine) / 3
    gained = 3 * (64 - start**2) / (2 * 2) - G * (sine + 0.4 * cosine) * (8 - start)
    assert asked(text)["v"] == pytest.approx(gained, rel=CLOSE)


def test_friction_reverses_where_what_swings_turns_back_and_holds_it_in_the_end() -> None:
    """Each half swing takes 2 τ/k off its width; it stays where k |θ| ≤ τ."""
    text = """
bodies: {wheel: {inertia: 0.2 kg m^2}}
connections: {axle: {axle: wheel, friction_torque: 0.8 N m}, wire: {torsion: wheel, stiffness: 3 N m/rad}}
states: {start: {wheel.angle: 2.2 rad, at rest: all}, end: {time: 10 s}}
find: {th: wheel.angle at end, w: wheel.angular_velocity at end}
"""
    place, rest = 2.2, 0.8 / 3
    while abs(place) > rest:
        place = math.copysign(2 * rest, place) - place
    found = asked(text)
    assert found["th"] == pytest.approx(place, abs=1e-7)
    assert found["w"] == pytest.approx(0.0, abs=1e-9)


def test_a_wheel_with_a_lump_slips_on_its_way_where_friction_is_weak() -> None:
    """Friction takes some of the energy that rolling would keep."""
    text = """
surfaces: {floor: level}
bodies: {hoop: {shape: ring, mass: 1 kg, radius: 50 cm, moves: right, turns: clockwise}, lump: {mass: 1 kg}}
connections: {glue: {weld: [hoop.rim, lump]}, touch: {contact: [hoop, floor], friction: %s}}
states: {start: {hoop.angle: 90 deg, hoop.velocity: 1 m/s, touch: rolls}, low: {hoop.angle: -90 deg}}
find: {v: hoop.velocity at low}
"""
    rolled = math.sqrt((0.5 * 6 * 1.0 + 1 * G * 1.0) / (0.5 * 2))  # ½ (2 + 4) v² above, ½ 2 v² below
    assert asked(text % 2)["v"] == pytest.approx(rolled, rel=1e-6)
    assert 0.9 * rolled < asked(text % 0.1)["v"] < rolled - 5e-3
