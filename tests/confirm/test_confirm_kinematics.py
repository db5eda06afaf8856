"""Kinematics by numbers alone: paths stepped through in time, geometry, and differences, without anything of the solver."""

from __future__ import annotations

import math

import pytest

from stepping import answers, motion, reach, run


def test_wheel_that_runs_back() -> None:
    """The whole angle, forwards and back, grows by the size of the angular velocity."""
    found = answers("wheel-runs-back")
    angle, _, whole = run(lambda time, state: (state[1], -3.0, abs(state[1])), (0.0, 12.0, 0.0), 10, 10000)
    assert found["net"] == pytest.approx(angle, rel=1e-6)
    assert found["whole"] == pytest.approx(whole, rel=1e-6)
    assert found["n"] == pytest.approx(whole / (2 * math.pi), rel=1e-6)
    assert found["s"] == pytest.approx(0.2 * whole, rel=1e-6)
    assert found["v"] == pytest.approx(0.02 * whole, rel=1e-6)
    _, top, _ = reach(lambda *_: -3.0, 0.0, 12.0, lambda time, angle, omega: omega)
    assert found["farthest"] == pytest.approx(top, rel=1e-6)


def test_wheel_slowed_by_its_speed() -> None:
    found = answers("wheel-slowed-by-its-speed")
    time, angle, _ = reach(lambda time, angle, omega: -0.2 * omega, 0.0, 10.0, lambda time, angle, omega: 2 - omega)
    assert found["t"] == pytest.approx(time, rel=1e-8)
    assert found["phi"] == pytest.approx(angle, rel=1e-8)


def test_wheel_whose_acceleration_goes_by_its_angle() -> None:
    found = answers("wheel-acceleration-by-angle")
    _, angle, omega = reach(lambda time, angle, omega: 8 - angle, 0.0, 3.0, lambda time, angle, omega: angle - 4)
    assert found["omega"] == pytest.approx(omega, rel=1e-8)
    assert found["alpha"] == pytest.approx(8 - angle, rel=1e-8)


@pytest.mark.parametrize("moment", [0.5, 1.0, 7.0])
def test_wheel_whose_acceleration_falls(moment: float) -> None:
    found = answers("wheel-falling-acceleration", at=f"{moment} s")
    wheel = motion(lambda time, *_: 9 - 2 * time)
    angle, omega = run(wheel, (3.0, 2.0), moment)
    assert found["omega"] == pytest.approx(omega, rel=1e-7)
    assert found["theta"] == pytest.approx(angle, rel=1e-7)
    assert found["theta_at_max"] == pytest.approx(run(wheel, (3.0, 2.0), 4.5)[0], rel=1e-7)


def test_plate_moved_by_a_machine() -> None:
    """Velocities and accelerations as differences of places, the turn as a sum of small ones."""
    found, small, end = answers("plate-moved-by-machine", at="1 s"), 1e-4, 2.0

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
