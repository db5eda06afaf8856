"""Simulated motions against closed forms: every bound holds the true error, and is not much wider than that."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from fractions import Fraction

import mpmath
import pytest

from rotsolve import simulate
from rotsolve.simulation import Run
from scenes import ATWOOD, DRAG, PENDULUM, SPRING, TWO_RODS

Truth = Callable[[mpmath.mpf], Mapping[str, mpmath.mpf]]
LOOKS = 40
WIDEST = 100  # times the true error is the most that a bound may be
BY_LUCK = 200  # where roundings make the error, which may happen to cancel
ROUNDING = 2.0**-52  # of its size, below which no number in floats is told apart
TRUTH = 1e-50  # how far the closed forms themselves may be off


def swing(angle: Callable[[], mpmath.mpf]) -> Truth:
    """A rod let go at an angle: sin(φ/2) = k sn(K − ω₀ t), φ from the lowest place, ω₀² = 3 g/(2 L)."""

    def truth(time: mpmath.mpf) -> Mapping[str, mpmath.mpf]:
        rate = mpmath.sqrt(3 * mpmath.mpf("9.81") / (2 * mpmath.mpf("0.9")))
        start = angle() + mpmath.pi / 2
        k = mpmath.sin(start / 2)
        u = mpmath.ellipk(k**2) - rate * time
        sn, cn, dn = (mpmath.ellipfun(name, u, m=k**2) for name in ("sn", "cn", "dn"))
        phi = 2 * mpmath.asin(k * sn)
        spin = -2 * k * rate * cn * dn / mpmath.sqrt(1 - (k * sn) ** 2)
        return {"rod.angle": phi - mpmath.pi / 2, "rod.angular_velocity": spin}

    return truth


def oscillation(time: mpmath.mpf) -> Mapping[str, mpmath.mpf]:
    """x = x₀ cos ω t + v₀/ω sin ω t, ω = 2 rad/s; the way counts from the start."""
    x0, v0, rate = mpmath.mpf("0.1"), mpmath.mpf("0.5"), 2
    way = x0 * mpmath.cos(rate * time) + v0 / rate * mpmath.sin(rate * time)
    speed = v0 * mpmath.cos(rate * time) - x0 * rate * mpmath.sin(rate * time)
    return {"coil.elongation": way, "block.position": way - x0, "block.velocity": speed}


def decay(time: mpmath.mpf) -> Mapping[str, mpmath.mpf]:
    """ω = ω₀ e^(−c t/J)."""
    rate = mpmath.mpf("0.35")
    spin = 30 * mpmath.exp(-rate * time)
    return {"wheel.angular_velocity": spin, "wheel.angle": (30 - spin) / rate}


def falling(m: Fraction, n: Fraction) -> Truth:
    """x = ½ a t², a = (m − n) g/(m + n + ½ M)."""
    exact = (m - n) * Fraction(98, 10) / (m + n + Fraction(3, 2))

    def truth(time: mpmath.mpf) -> Mapping[str, mpmath.mpf]:
        a = mpmath.mpf(exact.numerator) / exact.denominator
        return {"left.position": a * time**2 / 2, "left.velocity": a * time, "left.acceleration": a}

    return truth


NEAR = Fraction(1) + Fraction(1, 10**12)
CASES: dict[str, tuple[str, Truth, float]] = {
    "rod from 60°": (PENDULUM.format(angle="-30 deg"), swing(lambda: -mpmath.pi / 6), 10),
    "rod from 170°": (PENDULUM.format(angle="80 deg"), swing(lambda: 80 * mpmath.pi / 180), 10),
    "rod from 179.99°": (PENDULUM.format(angle="89.99 deg"), swing(lambda: mpmath.mpf("89.99") * mpmath.pi / 180), 10),
    "rod from 1e-8 rad off upright": (
        PENDULUM.format(angle="90 deg - 1e-8 rad"),
        swing(lambda: mpmath.pi / 2 - mpmath.mpf("1e-8")),
        10,
    ),
    "block on a spring": (SPRING, oscillation, 20),
    "flywheel in oil": (DRAG, decay, 10),
    "Atwood machine": (ATWOOD.format(m="2 kg", n="1 kg"), falling(Fraction(2), Fraction(1)), 5),
    "nearly equal masses": (ATWOOD.format(m="1.000000000001 kg", n="1 kg"), falling(NEAR, Fraction(1)), 5),
    "mass ratio 1e12": (ATWOOD.format(m="1e12 kg", n="1 kg"), falling(Fraction(10**12), Fraction(1)), 5),
}


@pytest.fixture(autouse=True)
def precise() -> Iterator[None]:
    with mpmath.workdps(60):
        yield


@pytest.mark.sampled(3)
@pytest.mark.parametrize("accuracy", [1e-4, 1e-6, 1e-9, 1e-12, 1e-15])
@pytest.mark.parametrize("name", CASES)
def test_bounds_hold_and_are_tight(name: str, accuracy: float) -> None:
    scene, truth, until = CASES[name]
    run = simulate(scene, until, accuracy)
    errors, bounds, sizes = compared(run, truth, until)
    for quantity, error in errors.items():
        widest = BY_LUCK if run.rounded else WIDEST
        room = widest * max(error, ROUNDING * sizes[quantity])
        assert bounds[quantity] <= room, f"{quantity}: {bounds[quantity]:.1e} for {error:.1e}"
        assert bounds[quantity] <= accuracy * sizes[quantity] * 1.01 or quantity.endswith("acceleration")


def compared(run: Run, truth: Truth, until: float) -> tuple[dict[str, float], dict[str, float], dict[str, float]]:
    """The largest errors, bounds and sizes of each quantity; no error at any moment is beyond its bound there."""
    errors: dict[str, float] = {}
    bounds: dict[str, float] = {}
    sizes: dict[str, float] = {}
    for k in range(LOOKS + 1):
        time = until * k / LOOKS
        found = run.at(time)
        for quantity, exact in truth(mpmath.mpf(time)).items():
            value, bound = found[quantity]
            error = float(abs(mpmath.mpf(value) - exact))
            assert error <= bound + TRUTH, f"{quantity} at {time}: {error:.2e} beyond {bound:.2e}"
            errors[quantity] = max(errors.get(quantity, 0.0), error)
            bounds[quantity] = max(bounds.get(quantity, 0.0), bound)
            sizes[quantity] = max(sizes.get(quantity, 0.0), float(abs(exact)))
    return errors, bounds, sizes


def test_an_accuracy_beyond_floats_is_reached() -> None:
    run = simulate(PENDULUM.format(angle="80 deg"), 10, 1e-30)
    exact = swing(lambda: 80 * mpmath.pi / 180)(mpmath.mpf(10))
    ball = run.balls(10.0, ("rod.angle",))["rod.angle"]
    assert float(ball.rad()) < 1e-29
    assert abs(mpmath.mpf(ball.mid().str(50, radius=False)) - exact["rod.angle"]) < 1e-29


def test_a_rod_that_stands_upright_stays_there() -> None:
    run = simulate(PENDULUM.format(angle="90 deg"), 100)
    assert run.at(100)["rod.angular_velocity"] == (0.0, 0.0)
    assert run.at(100)["rod.angle"][0] == math.pi / 2


def test_energy_drifts_little_over_two_hundred_swings() -> None:
    run = simulate(PENDULUM.format(angle="-30 deg"), 400, 1e-10)
    assert run.drift.energy is not None and run.drift.energy <= 5e-14


def test_places_that_others_tell_are_not_followed() -> None:
    """The centre of the lower rod is where the angles say, with a bound, and no number of the state by itself."""
    run = simulate(TWO_RODS, 2, 1e-9)
    assert {item.name.partition(".")[2] for item in run.regimes[0].system.variables} == {"angle", "angular_velocity"}
    first, found = run.at(0.0), run.at(2.0)

    def centre(at: Mapping[str, tuple[float, float]], of: Callable[[float], float]) -> float:
        return 1.5 * of(at["upper.angle"][0]) + 0.4 * of(at["lower.angle"][0])

    for axis, of in (("x", math.cos), ("y", math.sin)):
        gone, bound = found[f"lower.position.{axis}"]
        assert abs(gone - (centre(found, of) - centre(first, of))) <= bound + 2e-15
        assert 0 < bound < 1e-8
