"""Motions in space against closed forms, the plane, and steps of another kind with 30 digits: every bound holds the true error."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import mpmath
import pytest
from mpmath import mpf

from rotors import RollingCoin, Rotor, cross, times, turn
from rotsolve import simulate
from rotsolve.simulation import Run
from scenes import PENDULUM
from scenes_in_space import BOOK, COIN, GATE, GYROSCOPE, LUMP, TOP, WOBBLE


@pytest.fixture(autouse=True)
def precise() -> Iterator[None]:
    with mpmath.workdps(30):
        yield


def held(run: Run, time: float, truth: Mapping[str, mpmath.mpf], off: float = 1e-20) -> float:
    """Every bound holds the error; the widest bound is returned."""
    found, widest = run.balls(time), 0.0
    for name, exact in truth.items():
        value, bound = mpf(found[name].mid().str(40, radius=False)), float(found[name].rad())
        assert abs(value - exact) <= bound + off, f"{name}: {float(value - exact):.1e} beyond {bound:.1e}"
        widest = max(widest, bound)
    return widest


def of_book() -> Rotor:
    tensor = mpmath.diag([mpf("1e-3"), mpf("2e-3"), mpf("2.6e-3")])
    return Rotor(tensor, turn("x", mpmath.pi / 6), [mpf("0.1"), mpf(4), mpf("-0.2")], lambda rotation, time: [0, 0, 0])


def of_lump() -> Rotor:
    a, b, c = mpf("0.04"), mpf("0.03"), mpf("0.02")
    tensor = mpmath.matrix([[mpf("0.5"), -a, b], [-a, mpf("0.6"), c], [b, c, mpf("0.4")]])
    centre, place = [mpf("-0.1"), mpf("0.2"), mpf("0.3")], [mpf("0.1"), mpf("0.3"), mpf("0.3")]

    def torque(rotation: mpmath.matrix, time: mpf) -> list[mpf]:
        weight = cross(times(rotation, centre), [0, 0, -2 * mpf("9.8")])
        push = cross(times(rotation, place), [1, -2, mpf("0.5")])
        return [w + p + t for w, p, t in zip(weight, push, [0, mpf("0.3"), mpf("0.7")], strict=True)]

    return Rotor(tensor, turn("y", 2 * mpmath.pi / 9), [1, 2, -1], torque)


def of_top() -> Rotor:
    def torque(rotation: mpmath.matrix, time: mpf) -> list[mpf]:
        return cross(times(rotation, [0, 0, mpf("0.05")]), [0, 0, -mpf("0.2") * mpf("9.8")])

    tilt = mpmath.pi / 9
    omega = [mpf("0.7"), 3 * mpmath.sin(tilt), mpf(20)]
    return Rotor(mpmath.diag([mpf("6e-4"), mpf("6e-4"), mpf("8e-5")]), turn("x", tilt), omega, torque)


SLOW_TOP = TOP.format(axial="20 rad/s", tilt="20 deg", precession="3 rad/s", nutation="0.7 rad/s", later="")
MOTIONS = {"book": (BOOK, of_book), "lump": (LUMP, of_lump), "top": (SLOW_TOP, of_top)}


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", MOTIONS)
def test_rotations_agree_with_matrices_that_are_followed_in_small_steps(name: str) -> None:
    scene, rotor = MOTIONS[name][0], MOTIONS[name][1]()
    runs = [simulate(scene, 0.4, accuracy) for accuracy in (1e-6, 1e-9, 1e-20)]
    for time in (0.0, 0.1, 0.3):
        rotor.go(mpf(time), 0.02 if name != "top" else 0.01)
        widest = [held(run, time, rotor.told(name)) for run in runs]
        assert widest[-1] < 1e-18 and widest[1] < 1e-8


def test_a_thrown_plate_wobbles_as_it_should() -> None:
    """ω₁ + i ω₂ turns at (C − A)/A ω₃ in the body, and the axis goes round L at L/A (Landau & Lifshitz, Mechanics, §33)."""
    run, time = simulate(WOBBLE, 5), mpf("4.5")
    momentum = [mpf("0.08"), 0, mpf("0.3")]
    size = mpmath.sqrt(sum(part**2 for part in momentum))
    way, angle = [part / size for part in momentum], size / mpf("0.02") * time
    start = [mpf(0), mpf(0), mpf(1)]
    along = sum(a * b for a, b in zip(way, start, strict=True))
    across = cross(way, start)
    axis = [
        s * mpmath.cos(angle) + c * mpmath.sin(angle) + along * w * (1 - mpmath.cos(angle))
        for s, c, w in zip(start, across, way, strict=True)
    ]
    turned = 5 * time
    truth = {f"plate.z_axis.{a}": part for a, part in zip("xyz", axis, strict=True)}
    truth |= {f"plate.angular_momentum.{a}": part for a, part in zip("xyz", momentum, strict=True)}
    truth["plate.angular_velocity.x in body axes"] = 4 * mpmath.cos(turned)
    truth["plate.angular_velocity.y in body axes"] = 4 * mpmath.sin(turned)
    truth["plate.kinetic_energy"] = mpf("0.01") * 16 + mpf("0.015") * 100
    assert held(run, float(time), truth) < 1e-8


def test_a_bar_on_a_slanted_axis_swings_as_a_pendulum_of_the_plane_with_less_weight() -> None:
    """Only g sin β acts across the axis; a turn down is positive here and negative there."""
    plane = PENDULUM.format(angle="0 deg").replace("9.81 m/s^2", "9.81*sin(50*deg) m/s^2")
    plane = plane.replace("g: 9.81*sin(50*deg) m/s^2", "g: (9.81 m/s^2)*sin(50 deg)")
    there, here = simulate(plane, 2), simulate(GATE, 2)
    for time in (0.4, 1.1, 2.0):
        for word in ("angle", "angular_velocity"):
            (value, bound), (other, wide) = here.at(time)[f"bar.{word}"], there.at(time)[f"rod.{word}"]
            assert abs(value + other) <= bound + wide + 1e-15
    assert here.drift.energy is not None and here.drift.energy < 1e-14


def test_a_rod_that_swings_through_its_lowest_place_has_no_special_tilt() -> None:
    """On a ball joint it goes on through a tilt of 180°, as the rod of the plane does through its lowest place."""
    scene = """title: Rod on a ball joint
up: z
given: {M: 2 kg, L: 0.9 m, g: 9.81 m/s^2}
bodies: {rod: {shape: rod, mass: M, length: L, turned: {about: y, by: -30 deg}}}
connections: {pivot: {ball: rod.start}}
states: {released: at rest}
find: {K: rod.kinetic_energy}
"""
    here, there = simulate(scene, 3), simulate(PENDULUM.format(angle="30 deg"), 3)
    for time in (0.5, 0.9, 1.4, 3.0):
        angle, wide = there.at(time)["rod.angle"]
        for name, exact in (("x", mpmath.cos(angle)), ("z", mpmath.sin(angle)), ("y", mpf(0))):
            value, bound = here.at(time)[f"rod.x_axis.{name}"]
            assert abs(value - exact) <= bound + wide + 1e-15


def test_a_sleeping_top_that_is_struck_passes_the_vertical() -> None:
    """At a tilt of 0 it nods at a rate: its axis starts upright, and nothing stops there."""
    scene = TOP.format(axial="20 rad/s", tilt="0 deg", precession="0 rad/s", nutation="2 rad/s", later="")
    run = simulate(scene, 1)

    def torque(rotation: mpmath.matrix, time: mpf) -> list[mpf]:
        return cross(times(rotation, [0, 0, mpf("0.05")]), [0, 0, -mpf("0.2") * mpf("9.8")])

    rotor = Rotor(mpmath.diag([mpf("6e-4"), mpf("6e-4"), mpf("8e-5")]), mpmath.eye(3), [2, 0, 20], torque)
    rotor.go(mpf("0.3125"), 0.02)
    held(run, 0.3125, rotor.told("top"), off=1e-15)
    assert "top.precession" not in run.at(0.0) and "top.precession" in run.at(1.0)
    assert "–" in str(run)


def test_a_coin_rolls_as_steps_without_angles_say() -> None:
    tilt, radius = 7 * mpmath.pi / 18, mpf("0.01")
    omega = [1, 3 * mpmath.sin(tilt), 30 + 3 * mpmath.cos(tilt)]
    coin = RollingCoin(radius, radius, radius * mpf("9.8"), turn("x", tilt), omega)
    run = simulate(COIN, 0.1, 1e-18)
    coin.go(mpf("0.0625"), 0.01)
    assert held(run, 0.0625, coin.told("coin")) < 1e-15
    assert run.drift.energy is not None and run.drift.energy < 1e-15
    assert "coin.precession" in run.names and "grip.force.z" in run.names


def test_a_coin_leaves_the_table_when_it_is_lifted() -> None:
    """Steadily upright, N = m g − c t."""
    still = "{coin.tilt: 90 deg, coin.spin: 30 rad/s, coin.precession: 0 rad/s, coin.nutation: 0 rad/s}"
    scene = COIN.replace("states:", "actions: {lift: {force: (0.2 N/s)*time, on: coin, direction: up}}\nstates:")
    scene = scene.replace(
        "{coin.tilt: 70 deg, coin.spin: 30 rad/s, coin.precession: 3 rad/s, coin.nutation: 1 rad/s}", still
    )
    run = simulate(scene, 2)
    assert abs(run.end - 0.098 / 0.2) <= run.events[0].bound + 1e-15
    assert run.events[0].what == "coin leaves `table`" and "not followed" in run.ended


def test_a_ball_under_a_couple_rolls_faster_and_keeps_its_spin_about_the_vertical() -> None:
    """7/5 m R² ω̇ = τ, whichever way the ball is turned."""
    scene = """title: Ball
up: z
given: {R: 10 cm, g: 9.8 m/s^2}
bodies: {ball: {shape: sphere, mass: 1 kg, radius: R}}
surfaces: {table: level}
connections: {grip: {rolls: [ball, table]}}
actions: {twist: {couple: [0, 0.1 N m, 0], on: ball}}
states: {start: {ball.angular_velocity: [1 rad/s, 2 rad/s, 3 rad/s]}}
find: {K: ball.kinetic_energy}
"""
    run, time = simulate(scene, 2), mpf("1.5")
    rate = mpf("0.1") / (mpf(7) / 5 * mpf("0.01"))
    truth = {
        "ball.angular_momentum.x": mpf("0.004"),
        "ball.angular_momentum.y": mpf("0.004") * (2 + rate * time),
        "ball.angular_momentum.z": mpf("0.012"),
        "ball.position.x": (2 * time + rate * time**2 / 2) / 10,
        "ball.position.y": -time / 10,
    }
    held(run, 1.5, truth)


def test_a_mirror_image_moves_as_the_mirror_image() -> None:
    """In the plane x = 0: of a way x changes sign, of an angular velocity y and z; a product of inertia with one x too."""
    tensor = "[[50*I, -4*I, 3*I], [-4*I, 60*I, 2*I], [3*I, 2*I, 40*I]]"
    image = LUMP.replace(tensor, "[[50*I, 4*I, -3*I], [4*I, 60*I, 2*I], [-3*I, 2*I, 40*I]]")
    image = image.replace("P: [0.1 m,", "P: [-0.1 m,").replace("Q: [0.2 m,", "Q: [-0.2 m,")
    image = image.replace("{about: y, by: 40 deg}", "{about: y, by: -40 deg}").replace("[1 N,", "[-1 N,")
    image = image.replace("[0, 0.3 N m, 0.7 N m]", "[0, -0.3 N m, -0.7 N m]")
    image = image.replace("[1 rad/s, 2 rad/s, -1 rad/s]", "[1 rad/s, -2 rad/s, 1 rad/s]")
    one, other = simulate(LUMP, 2).at(2.0), simulate(image, 2).at(2.0)
    for name, (value, bound) in one.items():
        turns = "angular" in name or "torque" in name
        flips = (".x" in name) != turns if name[-2] == "." or "body axes" in name else False
        if "axis" in name:
            continue
        there, wide = other[name]
        assert abs(value - (-there if flips else there)) <= bound + wide + 1e-15, name


def test_all_along_z_is_the_plane() -> None:
    """A wheel under a couple that grows, about a hinge along z, has the numbers of the plane."""
    plane = """title: Wheel
gravity: none
given: {J: 2 kg m^2}
bodies: {wheel: {inertia: J, turns: counterclockwise}}
connections: {axle: {axle: wheel}}
actions: {drive: {couple: (0.7 N m/s)*time, on: wheel}}
states: {start: {wheel.angular_velocity: 3 rad/s}}
find: {alpha: wheel.angular_acceleration}
"""
    space = plane.replace("gravity: none", "up: z\ngravity: none").replace("axle: wheel}", "hinge: wheel, along: z}")
    space = space.replace(
        "{inertia: J, turns: counterclockwise}", "{mass: 1 kg, inertia: {principal: [J, J, J]}, axis: z}"
    )
    there, here = simulate(plane, 3), simulate(space, 3)
    for name in ("wheel.angle", "wheel.angular_velocity"):
        (value, bound), (other, wide) = here.at(2.7)[name], there.at(2.7)[name]
        assert abs(value - other) <= bound + wide


@pytest.mark.parametrize("scene", [BOOK, LUMP, SLOW_TOP, COIN, GYROSCOPE, GATE])
def test_energy_and_what_is_kept_of_angular_momenta(scene: str) -> None:
    drift = simulate(scene, 1).drift
    assert drift.energy is not None and drift.energy < 1e-13
    assert all(misfit < 1e-13 for misfit in drift.angular_momentum.values())


def test_what_is_kept_is_told() -> None:
    assert len(simulate(BOOK, 0.5).drift.angular_momentum) == 3
    assert [*simulate(SLOW_TOP, 0.5).drift.angular_momentum] == ["angular momentum about the vertical of `top`"]
    assert not simulate(LUMP, 0.5).drift.angular_momentum
