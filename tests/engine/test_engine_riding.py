"""What slides freely along a rod that turns, or a disc: where it comes to, with what speed, and where it runs off before."""

from __future__ import annotations

from math import cos, hypot, radians, sin, sqrt

import pytest

from rotsolve.core.faults import NeverReached, Unsolvable
from rotsolve.pipeline import solve
from rotsolve.solution import Solution

CARRIERS = {"start": "axis: {hinge: rod.start", "center": "axis: {hinge: rod.center", "disc": "axis: {axle: rod"}
L, W, K, C, M = 0.8, 2.0, 50.0, 0.1, 0.5  # SI units


def scene(
    at: str, first: str, last: str, *, spring: bool, given: str = "", asked: str = "v: bead.velocity.radial at b"
) -> str:
    """A bead on a carrier that is driven, from one state to another, drawn in by a spring or not."""
    drawn = f"  drawn: {{spring: [{'rod.start' if at == 'start' else 'rod.center'}, bead], stiffness: 50 N/m, rest_length: 10 cm}}\n"
    shape = "shape: disc, mass: 3 kg, radius: L" if at == "disc" else "shape: rod, mass: 3 kg, length: L"
    return (
        f"title: A bead\nplane: horizontal\ngiven: {{L: {'40 cm' if at == 'disc' else '80 cm'}, w: 2 rad/s{given}}}\n"
        f"bodies: {{rod: {{{shape}}}, bead: {{mass: 0.5 kg}}}}\n"
        f"connections:\n  {CARRIERS[at]}, angular_velocity: w}}\n  guide: {{rides: [bead, rod], friction: none}}\n"
        f"{drawn if spring else ''}"
        f"states: {{a: {{{first}}}, b: {{{last}}}}}\nfind: {{{asked}}}\n"
    )


def at(place: str, speed: str) -> str:
    return f"bead.radius: {place}, bead.velocity.radial: {speed}"


def speed(solution: Solution) -> float:
    return solution.answers["v"].float


def left(place: float, start: float, rate: float, *, spring: bool) -> float:
    """v² = v₀² + ω² (r² − r₀²) − k ((r − c)² − (r₀ − c)²)/m."""
    drawn = K / M * ((place - C) ** 2 - (start - C) ** 2) if spring else 0.0
    return rate**2 + W**2 * (place**2 - start**2) - drawn


@pytest.mark.parametrize(
    ("carrier", "start", "rate", "end", "spring"),
    [
        ("start", 0.3, -0.7, 0.5, False),  # to the axis, where the rod begins
        ("start", 0.3, -0.7, 0.3, False),
        ("start", 0.3, -5.0, 0.4, True),
        ("start", 0.3, 1.0, 0.2, False),  # to the other end
        ("start", 0.3, 8.0, 0.2, True),
        ("center", 0.3, 1.0, 0.2, False),
        ("center", 0.3, 8.0, 0.2, True),
        ("disc", 0.3, 8.0, 0.2, True),  # to the rim
    ],
)
def test_a_bead_that_runs_off_does_not_come_back(
    carrier: str, start: float, rate: float, end: float, spring: bool
) -> None:
    rim = 0.0 if rate < 0 else L if carrier == "start" else L / 2
    assert left(rim, start, rate, spring=spring) > 0
    with pytest.raises(NeverReached, match="`b` is never reached from `a`") as refused:
        solve(scene(carrier, at(f"{start} m", f"{rate} m/s"), f"bead.radius: {end} m", spring=spring))
    assert "before it turns back" in refused.value.fault.help


@pytest.mark.parametrize(
    ("carrier", "start", "rate", "end", "spring", "sense"),
    [
        ("start", 0.3, -0.5, 0.5, False, 1),  # it turns back before the axis
        ("start", 0.3, -0.5, 0.2, False, -1),
        ("start", 0.3, 1.0, 0.2, True, -1),  # it turns back before the end
        ("center", 0.3, -2.0, 0.35, False, 1),  # through the axis, and out on the other side
        ("center", 0.3, 0.3, 0.2, True, -1),
        ("disc", 0.3, 0.3, 0.2, True, -1),
    ],
)
def test_what_turns_back_before_an_end_comes(
    carrier: str, start: float, rate: float, end: float, spring: bool, sense: int
) -> None:
    found = solve(scene(carrier, at(f"{start} m", f"{rate} m/s"), f"bead.radius: {end} m", spring=spring))
    assert speed(found) == pytest.approx(sense * sqrt(left(end, start, rate, spring=spring)))
    assert all(item.holds for item in found.derivation.confirmed)


@pytest.mark.parametrize(("first", "condition"), [("-V", "V < p w"), ("V", "p < q")])
def test_in_letters_it_is_a_condition(first: str, condition: str) -> None:
    letters = ", p: m, q: m, V: m/s"
    page = str(solve(scene("start", at("p", first), "bead.radius: q", spring=False, given=letters)))
    assert condition in page
    assert "never reached" in page


def test_where_a_bead_turns_back_may_be_sought() -> None:
    text = scene("start", at("60 cm", "-0.5 m/s"), at("r", "0"), spring=False, given=", r: unknown", asked="v: r")
    assert speed(solve(text)) == pytest.approx(sqrt(0.6**2 - 0.5**2 / W**2))
    text = scene("start", at("20 cm", "1 m/s"), at("r", "0"), spring=True, given=", r: unknown", asked="v: r")
    place = speed(solve(text))
    assert 0.2 < place < L
    assert left(place, 0.2, 1.0, spring=True) == pytest.approx(0.0, abs=1e-6)


def test_what_rides_has_its_angular_momentum_about_the_axis() -> None:
    text = scene(
        "start", at("0 m", "0.3 m/s"), "bead.radius: 30 cm", spring=False, asked="v: bead.angular_momentum at b"
    )
    found = solve(text)
    assert speed(found) == pytest.approx(M * 0.3**2 * W)
    assert all(item.holds for item in found.derivation.confirmed)


TUBE = """
title: a bead that slides in a tube which swings upright
given: {m: 1.6 kg, r: 0.2 m, w: 3 rad/s, th: 30 deg}
bodies: {rod: {shape: rod, mass: 0.9 kg, length: 1 m}, bead: {mass: m}}
connections: {pin: {hinge: rod.start}, track: {rides: [bead, rod], friction: none}}
states: {s: {rod.angle: th, bead.radius: r, bead.velocity.radial: 0.5 m/s, rod.angular_velocity: w}}
find: {a: bead.acceleration, x: bead.acceleration.x, y: bead.acceleration.y}
"""


def test_what_slides_is_accelerated_along_its_carrier_by_its_weight_alone() -> None:
    """a = −g sin θ along it, r α + 2 ω v across it, with (m r² + M L²/3) α = −(m r + M L/2) g cos θ − 2 m r v ω."""
    th, g = radians(30), 9.8
    turn = -((1.6 * 0.2 + 0.45) * g * cos(th) + 2 * 1.6 * 0.2 * 0.5 * 3) / (1.6 * 0.04 + 0.3)
    along, across = -g * sin(th), 0.2 * turn + 2 * 3 * 0.5
    told = {
        "a": hypot(along, across),
        "x": along * cos(th) - across * sin(th),
        "y": along * sin(th) + across * cos(th),
    }
    found = solve(TUBE)
    assert {name: found.answers[name].float for name in told} == pytest.approx(told)
    assert all(item.holds for item in found.derivation.confirmed)


def test_what_a_spring_does_to_what_slides_is_refused_by_name() -> None:
    spring = "coil: {spring: [rod.start, bead], stiffness: 50 N/m, rest_length: 10 cm}, track:"
    with pytest.raises(Unsolvable, match="which slides while a spring pulls"):
        solve(TUBE.replace("track:", spring))
