"""In parts: times over several states of one swing, and extremes to which a motion comes only after the other one."""

from __future__ import annotations

from math import acos, asin, pi, sqrt

import pytest

from rotsolve.pipeline import solve
from rotsolve.solution import Solution

WIRE = """
plane: horizontal
given: {I: 2 kg m^2, D: 3 N m/rad, phi: 0.8 rad, w: 0.5 rad/s}
bodies: {disc: {inertia: I}}
connections: {axle: {axle: disc}, wire: {torsion: disc, stiffness: D}}
"""
RATE = sqrt(3 / 2)


def confirmed(text: str) -> Solution:
    solution = solve(text, digits=10)
    assert all(item.holds for item in solution.derivation.confirmed)
    return solution


@pytest.mark.parametrize("states", ["far, mid, back", "mid, back", "far, back", "far, mid"])
def test_times_add_up_whatever_states_lie_between(states: str) -> None:
    """φ cos ωt: to the other side in π/ω, to −φ/2 and back to the middle in a sixth and a quarter of a turn."""
    places = {"far": "smallest", "mid": "-phi/2", "back": "0"}
    lines = [f"{name}: {{wire.angle: {places[name]}}}" for name in states.split(", ")]
    given, last = WIRE.replace(", w: 0.5 rad/s", ""), states.split(", ")[-1]
    text = f"{given}states: {{start: {{wire.angle: phi, at rest: all}}, {', '.join(lines)}}}\nfind: {{t: time from start to {last}}}"
    phases = {
        "far, mid, back": 3 * pi / 2,
        "mid, back": 3 * pi / 2,
        "far, back": 3 * pi / 2,
        "far, mid": pi + acos(0.5),
    }
    assert float(confirmed(text).answers["t"].value or 0) == pytest.approx(phases[states] / RATE)


@pytest.mark.parametrize(("way", "extreme"), [(1, "largest"), (1, "smallest"), (-1, "largest"), (-1, "smallest")])
def test_what_sets_out_the_other_way_turns_back_first(way: int, extreme: str) -> None:
    """(w/ω) sin ωt: the first extreme is in the way of w, after a quarter, the other one half a turn later, as far on the other side."""
    start, far = f"wire.angle: 0, disc.angular_velocity: {'w' if way > 0 else '-w'}", f"far: {{wire.angle: {extreme}}}"
    text = f"{WIRE.replace(', phi: 0.8 rad', '')}states: {{start: {{{start}}}, {far}}}\n"
    found = confirmed(f"{text}find: {{A: wire.angle at far, t: time from start to far}}")
    side, late = 1 if extreme == "largest" else -1, (way > 0) != (extreme == "largest")
    assert float(found.answers["A"].value or 0) == pytest.approx(side * 0.5 / RATE)
    assert float(found.answers["t"].value or 0) == pytest.approx((1.5 if late else 0.5) * pi / RATE)


@pytest.mark.parametrize("way", [1, -1])
def test_a_pendulum_comes_to_its_highest_place_over_there(way: int) -> None:
    """½ (M L²/3) w² = M g (L/2) (1 + sin θ), on the right from either way."""
    rate = "w" if way > 0 else "-w"
    text = "given: {M: 2 kg, L: 1 m, w: 2 rad/s}\nbodies: {rod: {shape: rod, mass: M, length: L}}\nconnections: {pin: {hinge: rod.start}}\n"
    text += f"states: {{start: {{rod.angle: -90 deg, rod.angular_velocity: {rate}}}, high: {{rod.angle: largest}}}}\n"
    assert float(confirmed(f"{text}find: {{h: rod.angle at high}}").answers["h"].value or 0) == pytest.approx(
        asin(-1 + 4 / (3 * 9.8))
    )


@pytest.mark.parametrize("mu", ["0", "0.05"])
def test_a_block_that_rubs_turns_back_before_its_smallest_place(mu: str) -> None:
    """½ m v² = ½ k A² + μ m g A up to where it stops for a moment; on the other side it comes to A − 2 μ m g/k."""
    text = (
        f"given: {{m: 1 kg, k: 20 N/m, mu: {mu}, v: 2 m/s}}\nsurfaces: {{floor: level}}\nbodies: {{block: {{mass: m, moves: right}}}}\n"
        "connections: {s: {spring: [ground, block], stiffness: k}, c: {contact: [block, floor], friction: mu}}\n"
        "states: {start: {s.elongation: 0, block.velocity: v}, far: {block.displacement: smallest}}\n"
        "find: {x: block.displacement from start to far}"
    )
    drag = float(mu) * 9.8
    first = (-drag + sqrt(drag**2 + 20 * 4)) / 20
    assert float(confirmed(text).answers["x"].value or 0) == pytest.approx(2 * drag / 20 - first)
