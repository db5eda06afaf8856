"""Swings by another way: the full equation of motion stepped in time (Runge-Kutta), and elliptic integrals by quadrature.

The moments of inertia, torques and springs are written out here by hand; nothing of the solver is used but its answers.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import mpmath
import pytest

from stepping import G, answer, bisect, motion, reach, run

Acceleration = Callable[[float], float]


def quarter(acceleration: Acceleration, amplitude: float) -> float:
    """The time from rest at the amplitude to the equilibrium."""
    time, *_ = reach(lambda _, place, rate: acceleration(place), amplitude, 0.0, lambda _, place, rate: place, TICK)
    return time


def period(acceleration: Acceleration, amplitude: float) -> float:
    """Twice the quarter swings from either side."""
    return 2 * (quarter(acceleration, amplitude) + quarter(lambda q: -acceleration(-q), amplitude))


TINY, TICK = 1e-4, 1e-3
ROD_WITH_NUT = 0.3 * 0.8**2 / 3 + 1.2 * 0.8**2 + 0.15 * 0.3**2
SMALL: dict[tuple[str, str], Acceleration] = {
    ("swinging-rod", "T"): lambda q: -1e5 * G * 0.745 * math.sin(q) / (1e5 * 1.49**2 / 3),
    ("disc-and-ring-on-nails", "T1"): lambda q: -0.8 * G * 0.25 * math.sin(q) / (1.5 * 0.8 * 0.25**2),
    ("disc-and-ring-on-nails", "T2"): lambda q: -0.3 * G * 0.25 * math.sin(q) / (2 * 0.3 * 0.25**2),
    ("clock-pendulum-nut", "T"): lambda q: -G * (0.3 * 0.4 + 1.2 * 0.8 + 0.15 * 0.3) * math.sin(q) / ROD_WITH_NUT,
    ("spring-pulley-swings", "T"): lambda q: (1.5 * G - 60 * (1.5 * G / 60 + q)) / (2 + 1.5 + 0.5),
    ("rolling-on-a-spring", "T"): lambda q: -200 * q / (3 + 1.5),
    ("slanting-boom-on-a-spring", "T"): lambda q: (
        (400 * (6 * G / 800 - 2 * (math.sin(math.pi / 6 + q) - 0.5)) * 2 - 6 * G)
        * math.cos(math.pi / 6 + q)
        / (6 * 2**2 / 3)
    ),
    # it turns about its touching point, (R − r)/r times as fast as its place goes round
    ("marble-swings-in-bowl", "T"): lambda q: -G * 0.02 * math.sin(q) / (1.4 * 0.02**2) * 0.02 / 0.38,
    # an upright spring keeps upright where it is long: its foot moves along with the rod
    ("rod-held-level-swings", "T"): lambda q: (
        (-2 * G * 0.6 - 300 * (-2 * G * 0.6 / (300 * 0.9) + 0.9 * math.sin(q)) * 0.9) * math.cos(q) / (2 * 1.2**2 / 3)
    ),
}


@pytest.mark.parametrize(("problem", "name"), SMALL)
def test_small_swings_take_as_long_as_the_full_motion(problem: str, name: str) -> None:
    assert period(SMALL[problem, name], TINY) == pytest.approx(answer(problem, name), rel=1e-7)


def test_measured_swings_take_the_time_that_was_measured() -> None:
    kappa, inertia = (answer("torsion-wire-measures-inertia", name) for name in ("kappa", "I"))
    assert period(lambda q: -kappa * q / (0.5 * 1.2 * 0.08**2), TINY) == pytest.approx(2.4, rel=1e-9)
    assert period(lambda q: -kappa * q / inertia, TINY) == pytest.approx(3.1, rel=1e-9)
    g = answer("rod-measures-gravity", "g")
    fall = period(lambda q: -g * 0.3 * math.sin(q) / (1 / 12 + 0.3**2), TINY)
    assert fall == pytest.approx(1.525, rel=1e-7)


LARGE: dict[tuple[str, str], tuple[Acceleration, float]] = {
    ("swing-from-60-degrees", "T"): (lambda q: -1.5 * G / 1.2 * math.sin(q), math.radians(60)),
    ("swing-from-170-degrees", "T"): (lambda q: -G / 0.75 * math.sin(q), math.radians(170)),
    ("torsion-pendulum-any-size", "T"): (lambda q: -4.73 * q / (4 * 0.3**2 / 12), math.radians(140)),
}


@pytest.mark.parametrize(("problem", "name"), LARGE)
def test_large_swings_take_as_long_as_the_full_motion(problem: str, name: str) -> None:
    acceleration, amplitude = LARGE[problem, name]
    assert period(acceleration, amplitude) == pytest.approx(answer(problem, name), rel=1e-9)


@pytest.mark.parametrize("degrees", [60, 170])
def test_ratio_of_large_to_small_swings_by_the_arithmetic_geometric_mean(degrees: int) -> None:
    ratio = 1 / mpmath.agm(1, mpmath.cos(mpmath.radians(degrees) / 2))
    assert answer(f"swing-from-{degrees}-degrees", "n") == pytest.approx(float(ratio), rel=1e-12)


RINGS = [((k + 0.5) / 4000, 2 * (k + 0.5) / 4000**2) for k in range(4000)]  # of a disc: radii and masses as shares


def test_torsion_pendulum_by_steps_from_rest() -> None:
    start = math.pi / 3
    inertia = sum(5 * share * (0.12 * radius) ** 2 for radius, share in RINGS)

    def rate(_: float, angle: float, spin: float) -> float:
        return -0.09 * angle / inertia

    *_, half = reach(rate, start, 0.0, lambda _, angle, spin: angle - start / 2)
    *_, middle = reach(rate, start, 0.0, lambda _, angle, spin: angle)
    assert answer("torsion-pendulum", "alpha") == pytest.approx(rate(0, start, 0), rel=1e-6)
    assert answer("torsion-pendulum", "omega1") == pytest.approx(half, rel=1e-6)
    assert answer("torsion-pendulum", "omega2") == pytest.approx(middle, rel=1e-6)


def test_clock_pendulum_by_steps_from_the_level() -> None:
    """The force of the hinge by the height of the centre of mass a moment before and after the lowest place."""
    (stick, bob), length, radius, moment = (1.0, 2.0), 0.6, 0.1, 1e-4
    inertia = sum(stick / 4000 * ((k + 0.5) / 4000 * length) ** 2 for k in range(4000))
    inertia += sum(bob * share * (length**2 + (radius * part) ** 2) for part, share in RINGS)
    lever = stick * length / 2 + bob * length

    def rate(_: float, angle: float, spin: float) -> float:
        return -G * lever * math.cos(angle) / inertia

    _, angle, spin = reach(rate, 0.0, 0.0, lambda _, angle, spin: angle + math.pi / 2)
    places = [run(motion(rate), (angle, spin), time, 1)[0] for time in (-moment, 0.0, moment)]
    before, now, after = (lever * math.sin(place) / (stick + bob) for place in places)
    force = (stick + bob) * (G + (before - 2 * now + after) / moment**2)
    expected = {"I": inertia, "alpha": rate(0, 0, 0), "omega": spin, "F": force}
    for name, value in expected.items():
        assert answer("clock-pendulum", name) == pytest.approx(value, rel=1e-6), name


def test_conical_pendulum_by_the_forces_in_the_turning_frame() -> None:
    """String, weight and centrifugal force hold the bob: F sin θ = m ω² L sin θ and F cos θ = m g, solved by halving."""
    mass, length, angle = 0.5, 1.2, math.radians(40)
    rate = bisect(lambda w: mass * w**2 * length * math.sin(angle) / math.tan(angle) - mass * G, 0.1, 50)
    assert rate == pytest.approx(answer("conical-pendulum", "omega"), rel=1e-10)
    assert math.hypot(mass * G, mass * rate**2 * length * math.sin(angle)) == pytest.approx(
        answer("conical-pendulum", "F"), rel=1e-10
    )


def test_swing_ride_by_the_forces_in_the_turning_frame() -> None:
    mass, arm = 60, 3 + 4 * math.sin(math.radians(30))
    rate = bisect(lambda w: w**2 * arm - G * math.tan(math.radians(30)), 0.1, 50)
    assert rate == pytest.approx(answer("swing-ride", "omega"), rel=1e-10)
    assert math.hypot(mass * G, mass * rate**2 * arm) == pytest.approx(answer("swing-ride", "F"), rel=1e-10)


def shaft_torque(angle: float, rate: float) -> float:
    """Torque about the hinge per mass of the rod of 1.2 m, outwards: centrifugal force and weight summed over its pieces."""
    length = 1.2
    outwards = mpmath.quad(lambda s: rate**2 * s * mpmath.sin(angle) * s * mpmath.cos(angle), [0, length]) / length
    return float(outwards - G * length / 2 * mpmath.sin(angle))


@pytest.mark.exhaustive
def test_rod_on_a_turning_shaft_by_the_pieces_of_the_rod() -> None:
    angle = bisect(lambda theta: -shaft_torque(theta, 6), 0.1, math.pi / 2)
    assert angle == pytest.approx(answer("rod-on-turning-shaft", "theta"), rel=1e-10)
    assert 2 * 36 * 0.6 * math.sin(angle) == pytest.approx(-answer("rod-on-turning-shaft", "Fx"), rel=1e-10)


def test_rod_hangs_straight_down_until_a_small_angle_grows() -> None:
    limit = bisect(lambda rate: shaft_torque(1e-6, rate), 0.1, 50)
    assert limit == pytest.approx(answer("rod-on-shaft-stands-out", "omega"), rel=1e-9)
    per_angle = shaft_torque(1e-6, 2) / 1e-6 / (1.2**2 / 3)
    assert math.sqrt(-per_angle) == pytest.approx(answer("rod-on-slow-shaft-swings", "omega0"), rel=1e-9)


def test_upright_rod_stays_up_while_its_energy_is_least_there() -> None:
    """U = M g (L/2) cos φ + κ φ²/2 curves upwards at φ = 0 from the limit on."""
    stiffness, small = answer("upright-rod-on-torsion-spring", "kappa"), 1e-3

    def rise(kappa: float) -> float:
        return 1.5 * G * 0.4 * (math.cos(small) - 1) + kappa * small**2 / 2

    assert rise(stiffness * 1.001) > 0 > rise(stiffness * 0.999)
