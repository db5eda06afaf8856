"""Windows: what gives way on the way between two states and would hold again at the next look is found, wherever the window lies."""

from __future__ import annotations

from math import cos, radians, sin

import pytest

from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

LOADED = """
given: {M: 2 kg, m: SIZE, L: 1 m, w0: RATE, beta: TIP}
surfaces: {floor: level}
bodies: {rod: {shape: rod, mass: M, length: L, turns: clockwise}, lump: {mass: m}}
connections: {foot: {contact: [rod.start, floor], friction: any}, joint: {weld: [rod.end, lump]}}
states: {high: {rod.angle: BEGIN, FAST}, tipped: {rod.angle: 90 deg - beta}}
find: {w: rod.angular_velocity at tipped, N: foot.normal_force at tippedMORE}
"""


def push(tip: float, load: float, square: float, begin: float) -> float:
    """N beside the weight of a loaded rod that tips about its foot from an angle of the vertical at a rate: M = 2, L = 1.

    I = M/3 + m, S = M/2 + m is the moment of mass, N = (M + m) g − S (α sin + ω² cos), I ω² = I ω₀² + 2 S g (cos β₀ − cos β).
    """
    inertia, moment, g = 2 / 3 + load, 1 + load, 9.8
    rates = square + 2 * moment * g * (cos(begin) - cos(tip)) / inertia
    return (2 + load) * g - moment * (moment * g * sin(tip) ** 2 / inertia + rates * cos(tip))


def scene(load: float, rate: float, begin: float, tip: float, more: str = "") -> str:
    fast = "rod.angular_velocity: w0" if rate else "at rest: all"
    text = LOADED.replace("SIZE", f"{load} kg").replace("TIP", f"{tip} deg").replace("FAST", fast).replace("MORE", more)
    text = text.replace("BEGIN", f"{90 - begin:g} deg")
    return text.replace("RATE", f"{rate} rad/s") if rate else text.replace("w0: RATE, ", "")


def test_the_window_lies_between_the_formulas_of_its_edges() -> None:
    """N g (M + 4 m − k c) (M − k c)/(4 (M + 3 m)) with k = 3 M + 6 m, c = cos β: from upright, negative between both roots."""
    for part in range(1, 90):
        c, k = cos(radians(part)), 7.8
        factors = 9.8 * (2 - k * c) * (3.2 - k * c) / (4 * 2.9)
        assert push(radians(part), 0.3, 0.0, 0.0) == pytest.approx(factors)


@pytest.mark.parametrize("tip", [76, 80.7, 86, 89])
@pytest.mark.parametrize(("rate", "begin"), [(0, 0), (0.2, 0), (0, 10)], ids=["least push", "in motion", "from a lean"])
def test_a_foot_that_lets_go_between_two_looks_is_seen(rate: float, begin: float, tip: float) -> None:
    pushes = [push(radians(begin + (tip - begin) * part / 2000), 0.3, rate**2, radians(begin)) for part in range(2001)]
    assert pushes[-1] > 0 > min(pushes)
    with pytest.raises(Unsolvable, match="`foot` lets go on the way from `high` to `tipped`"):
        solve(scene(0.3, rate, begin, tip))


@pytest.mark.parametrize("tip", [75.5, 78, 84, 86])
def test_a_light_lump_opens_a_narrow_window(tip: float) -> None:
    with pytest.raises(Unsolvable, match="`foot` lets go"):
        solve(scene(0.1, 0, 0, tip))


@pytest.mark.parametrize("tip", [68, 75, 86, 89])
@pytest.mark.parametrize("more", ["", ", t: time from high to tipped"], ids=["by energy", "in time"])
def test_it_is_seen_in_steps_of_time_too(tip: float, more: str) -> None:
    """A rod without a lump, N = g M (1 − 3 c)²/4 at its least from rest: in motion it would have to pull there, however slow."""
    with pytest.raises(Unsolvable, match="`foot` lets go"):
        solve(scene(0.01, 0.1, 0, tip + 8, more))


def test_what_only_just_holds_is_confirmed() -> None:
    """Let go 12° off upright, N of a rod with next to no lump sinks to a twentieth of what it is at the end, and stays above zero."""
    pushes = [push(radians(12 + 76 * part / 2000), 1e-3, 0.0, radians(12)) for part in range(2001)]
    assert 0 < min(pushes) < 0.06 * pushes[-1]
    found = solve(scene(1e-3, 0, 12, 88))
    assert {item.holds for item in found.derivation.confirmed} == {True}


ROUGH = """
given: {M: 1 kg, L: 1 m, mu: MU, beta: TIP}
surfaces: {floor: level}
bodies: {rod: {shape: rod, mass: M, length: L, turns: clockwise}}
connections: {foot: {contact: [rod.start, floor], friction: mu}}
states: {high: {rod.angle: 80 deg, at rest: all}, tipped: {rod.angle: 90 deg - beta}}
find: {w: rod.angular_velocity at tippedMORE}
"""


def needed(tip: float) -> float:
    """|f|/N of a rod let go at rest 10° off upright: ω² = 3 g (cos 10° − cos β)/L, α = 3 g sin β/(2 L)."""
    c, s, top = cos(tip), sin(tip), cos(radians(10))
    return abs(0.75 * s * c - 1.5 * (top - c) * s) / (1 - 0.75 * s * s - 1.5 * (top - c) * c)


@pytest.mark.parametrize("more", ["", ", t: time from high to tipped"], ids=["by energy", "in time"])
@pytest.mark.parametrize("tip", [46.5, 47.3])
def test_friction_that_gives_way_in_a_narrow_window_is_seen(tip: float, more: str) -> None:
    """Right above the largest |f|/N on the way all is confirmed; below it the foot slips for a moment, which leaves another speed."""
    most = max(needed(radians(10 + (tip - 10) * part / 20000)) for part in range(20001))
    assert most > 1.5 * needed(radians(tip))
    text = ROUGH.replace("TIP", f"{tip} deg").replace("MORE", more)
    enough = solve(text.replace("MU", f"{most * 1.001:.9f}"))
    assert {item.holds for item in enough.derivation.confirmed} == {True}
    with pytest.raises(Unsolvable, match="`foot` begins to slip on the way from `high` to `tipped`"):
        solve(text.replace("MU", f"{most * 0.99:.9f}"))
