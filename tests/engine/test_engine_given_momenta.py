"""Given momenta: L, K and p as functions of time, and as lines of states, against τ = dL/dt, τ ω = dK/dt and F = dp/dt by hand."""

from __future__ import annotations

import math

import pytest

from rotsolve import simulate, solve
from rotsolve.core.faults import Unsolvable

GIVEN = "given: {I: 2 kg m^2, M: 4 kg, R: 50 cm, a: 3 kg m^2/s, b: 2 kg m^2/s^2, c: 5 J/s^2, k: 7 J/s, p: 3 kg m/s^2, t: 1.5 s}\n"
WHEEL = (
    "title: t\nplane: horizontal\n" + GIVEN + "bodies: {wheel: {inertia: I}}\nconnections: {axle: {axle: wheel, LAW}}\n"
)
DISC = WHEEL.replace("{inertia: I}", "{shape: disc, mass: M, radius: R}")  # I = 0.5 kg m²
TURNED = WHEEL.replace("{inertia: I}", "{inertia: I, turns: clockwise}")
WELDED = DISC.replace("radius: R}", "radius: R}, lump: {mass: M}").replace(
    "LAW}", "LAW}, rivet: {weld: [wheel.rim, lump]}"
)
STATES = "states: {start: {}, now: {time: t}}\n"


@pytest.mark.parametrize(
    ("of", "law", "find", "number"),
    [
        (WHEEL, "angular_momentum: a + b*time", "axle.torque at now", 2.0),
        (WHEEL, "angular_momentum: a + b*time^2/t", "axle.torque at now", 4.0),
        (DISC, "angular_momentum: a + b*time", "wheel.angular_velocity at now", 12.0),
        (DISC, "angular_momentum: a - b*time", "wheel.rotation from start to now", (3 * 1.5 - 1.5**2) / 0.5),
        (DISC, "angular_momentum: a + b*time", "axle.work from start to now", (36 - 9) / 1.0),
        (TURNED, "angular_momentum: a + b*time", "wheel.angular_velocity at now", 3.0),
        (WELDED, "angular_momentum: a + b*time", "wheel.angular_velocity at now", 4.0),
        (WELDED, "angular_momentum: a + b*time", "lump.angular_momentum at now", 4.0),
        (DISC, "kinetic_energy: c*time^2", "axle.torque at now", 0.5 * math.sqrt(2 * 5 / 0.5)),
        (DISC, "kinetic_energy: c*time^2 + k*t", "axle.power at now", 15.0),
        (DISC, "kinetic_energy: c*time^2 + k*time + k*t", "wheel.angular_velocity at now", math.sqrt(2 * 32.25 / 0.5)),
    ],
)
def test_a_turn_by_its_momentum_or_energy(of: str, law: str, find: str, number: float) -> None:
    solution = solve(of.replace("LAW", law) + STATES + f"find: {{x: {find}}}\n")
    assert float(solution.answers["x"].value) == pytest.approx(number, rel=1e-3)
    assert "confirmed with numbers" in solution.to("text")


def test_it_is_simulated_with_a_moment_of_inertia_of_its_own() -> None:
    scene = DISC.replace("LAW", "angular_momentum: a - b*time") + STATES + "find: {x: axle.torque}\n"
    assert float(simulate(scene, until="2 s").at(2.0)["wheel.angle"][0]) == pytest.approx((6 - 4) / 0.5)


@pytest.mark.parametrize(
    ("law", "message"),
    [
        ("kinetic_energy: k*t - k*time", "which way it turns then is not told"),
        ("kinetic_energy: c*(time - t)^2", "which way it turns then is not told"),
        ("kinetic_energy: k*time", "changes beyond all bounds when the clock starts"),
        ("angular_momentum: a, angular_velocity: 2 rad/s", "is given beside another given motion"),
    ],
)
def test_what_does_not_tell_a_motion_is_refused(law: str, message: str) -> None:
    with pytest.raises(Unsolvable, match=message):
        solve(WHEEL.replace("LAW", law) + STATES + "find: {x: wheel.angular_velocity at now}\n")


@pytest.mark.parametrize(
    ("first", "find", "number"),
    [
        ("wheel.angular_momentum: a", "wheel.rotation from start to rest", 3**2 / (2 * 2 * 4)),
        ("wheel.kinetic_energy: k*t", "wheel.rotation from start to rest", 7 * 1.5 / 4),
    ],
)
def test_states_that_tell_them_are_confirmed(first: str, find: str, number: float) -> None:
    scene = WHEEL.replace("LAW", "friction_torque: 4 N m")
    solution = solve(
        f"{scene}states: {{start: {{{first}}}, rest: {{wheel.angular_velocity: 0}}}}\nfind: {{x: {find}}}\n"
    )
    assert float(solution.answers["x"].value) == pytest.approx(number, rel=1e-3)
    assert "confirmed with numbers" in solution.to("text")


def test_a_momentum_gives_a_velocity() -> None:
    scene = (
        f"title: t\nplane: horizontal\n{GIVEN}bodies: {{puck: {{mass: M, momentum: [p*time^2/t, p*time]}}}}\n{STATES}"
    )
    answers = solve(scene + "find: {F: puck.force at now, v: puck.velocity.x at now}\n").answers
    assert float(answers["F"].value) == pytest.approx(math.hypot(6, 3), rel=1e-3)
    assert float(answers["v"].value) == pytest.approx(3 * 1.5 / 4, rel=1e-3)
