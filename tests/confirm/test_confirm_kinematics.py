"""Kinematics by numbers alone: paths stepped through in time, geometry, and differences, without anything of the solver."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path

import pytest

from rotsolve.pipeline import solve

PROBLEMS = Path(__file__).resolve().parents[2] / "problems"
Rate = Callable[[float, float, float], float]


def answers(name: str, at: str | None = None) -> dict[str, float]:
    """The answers of a problem in the units in which they are printed, which are SI units in these problems."""
    found = {key: answer.float for key, answer in solve(PROBLEMS / f"{name}.yaml", at=at).answers.items()}
    return {key: value for key, value in found.items() if value is not None}


def stepped(
    alpha: Rate, angle: float, omega: float, until: Callable[[float, float, float], float]
) -> tuple[float, ...]:
    """Time, angle and angular velocity when `until` first vanishes, and the whole angle turned, by Runge-Kutta steps."""
    time, whole, step = 0.0, 0.0, 1e-3
    while step > 1e-13:
        new = runge_kutta(alpha, time, angle, omega, step)
        if until(time + step, *new) >= 0:
            step /= 2
            continue
        whole += abs(new[0] - angle)
        time, (angle, omega) = time + step, new
    return time, angle, omega, whole


def runge_kutta(alpha: Rate, time: float, angle: float, omega: float, step: float) -> tuple[float, float]:
    """One step of fourth order for angle and angular velocity."""
    k1, l1 = omega, alpha(time, angle, omega)
    k2, l2 = omega + step / 2 * l1, alpha(time + step / 2, angle + step / 2 * k1, omega + step / 2 * l1)
    k3, l3 = omega + step / 2 * l2, alpha(time + step / 2, angle + step / 2 * k2, omega + step / 2 * l2)
    k4, l4 = omega + step * l3, alpha(time + step, angle + step * k3, omega + step * l3)
    return angle + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4), omega + step / 6 * (l1 + 2 * l2 + 2 * l3 + l4)


def test_wheel_that_runs_back() -> None:
    found = answers("wheel-runs-back")
    _, angle, _, whole = stepped(lambda *_: -3.0, 0.0, 12.0, lambda time, *_: time - 10)
    assert found["net"] == pytest.approx(angle, rel=1e-6)
    assert found["whole"] == pytest.approx(whole, rel=1e-5)
    assert found["n"] == pytest.approx(whole / (2 * math.pi), rel=1e-5)
    assert found["s"] == pytest.approx(0.2 * whole, rel=1e-5)
    assert found["v"] == pytest.approx(0.02 * whole, rel=1e-5)
    _, top, _, _ = stepped(lambda *_: -3.0, 0.0, 12.0, lambda time, angle, omega: -omega)
    assert found["farthest"] == pytest.approx(top, rel=1e-6)


def test_wheel_slowed_by_its_speed() -> None:
    found = answers("wheel-slowed-by-its-speed")
    time, angle, _, _ = stepped(
        lambda time, angle, omega: -0.2 * omega, 0.0, 10.0, lambda time, angle, omega: 2 - omega
    )
    assert found["t"] == pytest.approx(time, rel=1e-8)
    assert found["phi"] == pytest.approx(angle, rel=1e-8)


def test_wheel_whose_acceleration_goes_by_its_angle() -> None:
    found = answers("wheel-acceleration-by-angle")
    _, angle, omega, _ = stepped(lambda time, angle, omega: 8 - angle, 0.0, 3.0, lambda time, angle, omega: angle - 4)
    assert found["omega"] == pytest.approx(omega, rel=1e-8)
    assert found["alpha"] == pytest.approx(8 - angle, rel=1e-8)


@pytest.mark.parametrize("moment", [0.5, 1.0, 7.0])
def test_wheel_whose_acceleration_falls(moment: float) -> None:
    found = answers("wheel-falling-acceleration", f"{moment} s")
    _, angle, omega, _ = stepped(lambda time, *_: 9 - 2 * time, 3.0, 2.0, lambda time, *_: time - moment)
    assert found["omega"] == pytest.approx(omega, rel=1e-7)
    assert found["theta"] == pytest.approx(angle, rel=1e-7)
    _, top, _, _ = stepped(lambda time, *_: 9 - 2 * time, 3.0, 2.0, lambda time, *_: time - 4.5)
    assert found["theta_at_max"] == pytest.approx(top, rel=1e-7)


def test_plate_moved_by_a_machine() -> None:
    """Velocities and accelerations as differences of places, the turn as a sum of small ones."""
    found, small, end = answers("plate-moved-by-machine", "1 s"), 1e-4, 2.0

    def place(time: float) -> tuple[float, float]:
        return 2 * time**2, 3 * time**3

    velocity = [
        (after - before) / (2 * small) for before, after in zip(place(1 - small), place(1 + small), strict=True)
    ]
    assert [found["v_x"], found["v_y"]] == pytest.approx(velocity, rel=1e-6)
    points = zip(place(end - small), place(end), place(end + small), strict=True)
    acceleration = [(before - 2 * now + after) / small**2 for before, now, after in points]
    assert [found["a_x"], found["a_y"]] == pytest.approx(acceleration, rel=1e-5)
    assert [found["F_x"], found["F_y"]] == pytest.approx([2 * part for part in acceleration], rel=1e-5)
    count = 20000
    turned = sum(4 * math.cos(4 * (k + 0.5) * end / count) for k in range(count)) * end / count
    assert found["phi"] == pytest.approx(turned, rel=1e-6)
    growth = 4 * (math.cos(4 * (end + small)) - math.cos(4 * (end - small))) / (2 * small)
    assert found["tau"] == pytest.approx(3 * growth, rel=1e-6)


def test_centre_of_the_ladder_is_where_the_normals_meet() -> None:
    """The foot moves along the floor, the head along the wall: the centre is above the foot and level with the head."""
    found, length, angle = answers("instantaneous-centre-of-ladder"), 5.0, math.radians(53)
    foot, head = (0.0, 0.0), (length * math.cos(angle), length * math.sin(angle))
    middle = (head[0] / 2, head[1] / 2)
    centre = (foot[0], head[1])
    assert (found["x"], found["y"]) == pytest.approx((centre[0] - middle[0], centre[1] - middle[1]), rel=1e-9)
    assert found["omega"] == pytest.approx(-2.0 / math.dist(centre, foot), rel=1e-9)
    assert found["v_top"] == pytest.approx(-2.0 / math.dist(centre, foot) * math.dist(centre, head), rel=1e-9)


def test_centre_of_a_wheel_is_where_its_points_rest() -> None:
    found = answers("instantaneous-centre-of-wheel")
    for height, omega in ((found["y"], 20.0), (found["y_spinner"], 30.0)):
        assert 6.0 + omega * height == pytest.approx(0, abs=1e-9)  # clockwise: what is below the centre runs back
