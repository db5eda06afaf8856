"""Blows, cuts and ropes, from Newton's laws alone: a blow is a stiff damper stepped in time, a rod a row of small masses.

No conservation law is assumed: what is kept through a blow, and what heat it leaves, comes out of the steps.
"""

from __future__ import annotations

import math

import pytest

from stepping import G, State, answers, linear, motion, reach, run, until

PIECES = 4000
DAMPER = 1e8  # so stiff that the blow is over within 100 ns
APART = 1e-9  # a share of the speed of approach that is as good as none


def moments(mass: float, length: float) -> tuple[float, float]:
    """First and second moment of the masses of a rod about its end."""
    places = [(k + 0.5) / PIECES * length for k in range(PIECES)]
    return mass / PIECES * math.fsum(places), mass / PIECES * math.fsum(s**2 for s in places)


def test_bullet_in_a_hanging_rod_by_a_stiff_damper() -> None:
    """Weight acts all the while; then the rod with the bullet swings up step by step until it turns back."""
    rod, length, bullet, fast = 2.0, 0.8, 0.05, 40.0
    lever, inertia = moments(rod, length)

    def closing(state: State) -> float:
        return state[2] - length * state[1]

    def hit(_: float, state: State) -> State:
        force = DAMPER * closing(state)
        turned = (force * length - G * lever * math.sin(state[0])) / inertia
        return state[1], turned, -force / bullet, force * closing(state)

    time, (angle, spin, _, heat) = until(
        hit, (0.0, 0.0, fast, 0.0), lambda _, state: closing(state) - APART * fast, 1e-11
    )
    assert time < 1e-7 and angle < 1e-6
    both = inertia + bullet * length**2
    _, top, _ = reach(
        lambda _, angle, spin: -G * (lever + bullet * length) * math.sin(angle) / both,
        angle,
        spin,
        lambda _, angle, spin: spin,
    )
    found = answers("bullet-in-rod-swing")
    assert found["omega"] == pytest.approx(spin, rel=1e-7)
    assert found["share"] == pytest.approx(heat / (bullet * fast**2 / 2), rel=1e-7)
    assert found["phi"] == pytest.approx(top, rel=1e-7)


def test_puck_on_the_end_of_a_rod_on_ice_by_a_stiff_damper() -> None:
    rod, length, puck, fast = 1.5, 0.9, 0.25, 6.0
    inertia = 2 * moments(rod / 2, length / 2)[1]  # about the middle

    def closing(state: State) -> float:
        return state[2] - state[0] - length / 2 * state[1]

    def hit(_: float, state: State) -> State:
        force = DAMPER * closing(state)
        return force / rod, force * length / 2 / inertia, -force / puck, force * closing(state)

    time, (centre, spin, _, heat) = until(
        hit, (0.0, 0.0, fast, 0.0), lambda _, state: closing(state) - APART * fast, 2e-11
    )
    assert time < 1e-7
    found = answers("bullet-on-ice")
    assert found["omega"] == pytest.approx(spin, rel=1e-7)
    assert found["v_C"] == pytest.approx(centre, rel=1e-7)
    assert found["share"] == pytest.approx(heat / (puck * fast**2 / 2), rel=1e-7)


@pytest.mark.parametrize(
    ("name", "place", "pull"), [("rod-string-cut", 1.2, "T"), ("rod-spring-cut", 0.9, "x")], ids=["string", "spring"]
)
def test_level_rod_that_is_let_go(name: str, place: float, pull: str) -> None:
    """Held, pull and hinge balance the weights of the pieces; let go, the hinge gives them what they need beside their weight."""
    mass, length = 3.0, 1.2
    lever, inertia = moments(mass, length)
    holding, hinge = linear([(1.0, 1.0, mass * G), (place, 0.0, lever * G)])
    found = answers(name)
    assert found[pull] == pytest.approx(holding if pull == "T" else holding / 400, rel=1e-9)
    assert found["F_held"] == pytest.approx(hinge, rel=1e-9)

    fall = motion(lambda _, angle, spin: -G * lever * math.cos(angle) / inertia)
    short = 1e-4
    angle, spin = run(fall, (0.0, 0.0), short, 1)
    turned = spin / short
    assert found["alpha"] == pytest.approx(turned, rel=1e-6)
    assert found["F"] == pytest.approx(mass * G + lever * turned, rel=1e-6)
    if pull == "T":
        assert found["a_end"] == pytest.approx(-2 * length * math.sin(angle) / short**2, rel=1e-6)


def held_back(mass: float, pull: float, inertia: float, radius: float, brake: float = 0.0) -> tuple[float, float]:
    """Acceleration and holding force of a mass that is pulled on while the force that holds it turns a wheel along."""
    rows = [(mass, 1.0, 0.0, pull), (0.0, -radius, inertia, -brake), (1.0, 0.0, -radius, 0.0)]
    acceleration, holding, _ = linear(rows)
    return acceleration, holding


def test_yoyo_on_its_axle_by_steps() -> None:
    mass, inertia, axle, way = 116.0, 116 * 0.32**2 / 2, 0.032, 20.0
    acceleration, tension = held_back(mass, mass * G, inertia, axle)

    def rate(_: float, state: State) -> State:
        return state[1], acceleration, state[3], tension * axle / inertia

    time, (_, speed, angle, spin) = until(rate, (0.0,) * 4, lambda _, state: state[0] - way)
    turning, moving = inertia * spin**2 / 2, mass * speed**2 / 2
    found = answers("yoyo-on-its-axle")
    expected = {"a": acceleration, "T": tension, "t": time, "v": speed, "n": angle / (2 * math.pi)}
    for key, value in {**expected, "share": turning / (turning + moving)}.items():
        assert found[key] == pytest.approx(value, rel=1e-9), key


def test_windlass_with_friction_by_steps() -> None:
    bucket, drum, radius, friction, way = 8.0, 20.0, 0.15, 4.5, 6.0
    inertia = math.fsum(drum * 2 * (k + 0.5) / PIECES**2 * ((k + 0.5) / PIECES * radius) ** 2 for k in range(PIECES))
    acceleration, tension = held_back(bucket, bucket * G, inertia, radius, friction)

    def rate(_: float, state: State) -> State:
        return state[1], acceleration, (tension * radius - friction) / inertia, -friction * state[2]

    _, (_, speed, _, work) = until(rate, (0.0,) * 4, lambda _, state: state[0] - way)
    found = answers("axle-friction")
    for key, value in {"a": acceleration, "T": tension, "v": speed, "W": work}.items():
        assert found[key] == pytest.approx(value, rel=1e-6), key


def test_ball_and_ring_race_by_steps() -> None:
    """Friction turns them; the ball is cut into thin discs, and the masses of the ring are all at its rim."""
    slope, way, (ball, small), (ring, large) = math.radians(20), 5.0, (2.0, 0.05), (3.0, 0.2)
    squares = [
        small**2 - ((2 * k + 1) / PIECES - 1) ** 2 * small**2 for k in range(PIECES)
    ]  # of the radii of the discs
    inertia = ball * math.fsum(square**2 / 2 for square in squares) / math.fsum(squares)
    first, _ = held_back(ball, ball * G * math.sin(slope), inertia, small)
    second, _ = held_back(ring, ring * G * math.sin(slope), ring * large**2, large)

    def rate(_: float, state: State) -> State:
        return state[1], first, state[3], second

    time, (_, fast, behind, slow) = until(rate, (0.0,) * 4, lambda _, state: state[0] - way)
    found = answers("race")
    for key, value in {"t": time, "v1": fast, "v2": slow, "d": way - behind}.items():
        assert found[key] == pytest.approx(value, rel=1e-6), key
