"""Whether the motion comes to a later state: said so whatever is asked there, in letters as a condition of the case."""

from __future__ import annotations

import math

import pytest

from rotsolve import Unsolvable, solve
from rotsolve.core.faults import NeverReached

GATE = """
up: z
given: {M: kg, b: m, h: m, beta: rad, phi: rad, g: m/s^2}
bodies: {gate: {shape: rectangle, mass: M, sides: [b, h], turned: {about: x, by: 90 deg - beta}, points: {A: [-b/2, 0, 0]}}}
connections: {post: {hinge: gate.A, along: y}}
states: {start: {gate.angle: FIRST, gate.angular_velocity: 0 rad/s}, low: {gate.angle: LAST}}
find: {w: ASKED gate.angular_velocity at low}
"""
ROD = """
up: z
given: {M: 2 kg, l: 0.5 m, g: 9.8 m/s^2, w: RATE}
bodies: {rod: {shape: rod, mass: M, length: l}}
connections: {pin: {hinge: rod.start, along: y}}
states: {start: {rod.angle: 90 deg, rod.angular_velocity: w}, top: {rod.angle: 270 deg}}
find: {ASKED}
"""
TOP = """
up: z
given: {M: 0.2 kg, l: 5 cm, I1: 6e-4 kg m^2, I3: 8e-5 kg m^2, w3: 400 rad/s, theta: 20 deg, g: 9.81 m/s^2}
bodies: {top: {mass: M, inertia: {about: tip, principal: [I1, I1, I3]}, axis: z, points: {tip: [0, 0, -l]}}}
connections: {foot: {ball: top.tip}}
states: {start: {top.tilt: theta, top.axial_rate: w3, top.precession: 0 rad/s, top.nutation: 0 rad/s}, low: {top.tilt: TILT}}
find: {K: top.kinetic_energy at low}
"""


@pytest.mark.sampled(3)
@pytest.mark.parametrize("asked", ["", "size of"])
@pytest.mark.parametrize(("first", "last"), [("phi", "0 deg"), ("phi", "-90 deg"), ("90 deg", "0 deg")])
def test_a_gate_does_not_rise_from_rest(first: str, last: str, asked: str) -> None:
    with pytest.raises(Unsolvable, match="`low` is never reached from `start`"):
        solve(GATE.replace("FIRST", first).replace("LAST", last).replace("ASKED", asked))


@pytest.mark.parametrize(
    "asked",
    ["K: rod.kinetic_energy at top", "F: pin.force at top", "s: size of pin.force at top", "E: rod.energy at top"],
)
def test_what_has_a_number_where_nothing_comes_is_not_told(asked: str) -> None:
    with pytest.raises(NeverReached, match="`top` is never reached from `start`"):
        solve(ROD.replace("RATE", "1 rad/s").replace("ASKED", asked))
    assert solve(ROD.replace("RATE", "12 rad/s").replace("ASKED", asked)).answers


def test_an_energy_in_letters_tells_for_what_it_is_reached() -> None:
    """½ I w² > M g l: l w² > 6 g."""
    solution = solve(
        ROD.replace("2 kg", "kg")
        .replace("0.5 m,", "m,")
        .replace("RATE", "rad/s")
        .replace("ASKED", "K: rod.kinetic_energy at top")
    )
    assert str(solution.answers["K"]) == "K = M l (⅙ l w² − g) (if l > 6 g/w²)"
    assert all(item.holds for item in solution.derivation.confirmed)


def test_a_top_does_not_fall_below_where_it_turns_back() -> None:
    """cos θ of the lower turning point: 2 M g l (u₀ − u)(1 − u²) I₁ = (I₃ ω₃)² (u₀ − u)²."""
    spin, lift = (8e-5 * 400) ** 2, 2 * 6e-4 * 0.2 * 9.81 * 0.05
    start = math.cos(math.radians(20))
    low = (spin - math.sqrt(spin**2 - 4 * lift * (spin * start - lift))) / (2 * lift)
    lowest = math.degrees(math.acos(low))
    with pytest.raises(NeverReached):
        solve(TOP.replace("TILT", f"{lowest + 0.5:.2f} deg"))
    assert solve(TOP.replace("TILT", f"{lowest - 0.5:.2f} deg")).answers


OVER = """
up: z
given: {M: 2 kg, l: 1 m, g: 9.8 m/s^2, w: RATE}
bodies: {rod: {shape: rod, mass: M, length: l}}
connections: {pin: {hinge: rod.start, along: AXIS}}
states: {start: {rod.angle: FIRST deg, rod.angular_velocity: w}, there: {rod.angle: LAST deg}}
find: {K: rod.kinetic_energy at there}
"""


@pytest.mark.parametrize(
    ("axis", "first", "last", "sense"),
    [("y", -60, -120, -1), ("y", -120, -60, 1), ("y", 300, 240, -1), ("[0, -1, 0]", 60, 120, 1)],
)
def test_what_has_to_pass_its_highest_place_needs_the_energy_for_that(
    axis: str, first: int, last: int, sense: int
) -> None:
    """From 30° beside the highest place over it: ⅓ M l² w²/2 > ½ M g l (1 − cos 30°), else it turns back before."""
    scene = OVER.replace("AXIS", axis).replace("FIRST", str(first)).replace("LAST", str(last))
    least = math.sqrt(3 * 9.8 * (1 - math.cos(math.radians(30))))
    with pytest.raises(NeverReached, match="`there` is never reached"):
        solve(scene.replace("RATE", f"{sense * (least - 0.02):.3f} rad/s"))
    found = solve(scene.replace("RATE", f"{sense * (least + 0.02):.3f} rad/s"))
    assert [item.holds for item in found.derivation.confirmed] == [True]


def test_in_letters_it_is_a_condition() -> None:
    scene = (
        OVER.replace("AXIS", "y").replace("FIRST", "-60").replace("LAST", "-120").replace("2 kg, l: 1 m", "kg, l: m")
    )
    found = solve(scene.replace("RATE", "rad/s").replace("rod.angular_velocity: w", "rod.angular_velocity: -w"))
    assert "if" in str(found.answers["K"])
    assert [item.holds for item in found.derivation.confirmed] == [True]


LIFT = """
up: z
given: {M: 1 kg, l: 0.1 m, I1: 0.02 kg m^2, I3: 0.001 kg m^2, w3: RATE, theta: 30 deg, a: 1 m/s^2, g: 9.8 m/s^2}
bodies:
  lift: {mass: 0, acceleration: [0, 0, a]}
  top: {mass: M, inertia: {about: tip, principal: [I1, I1, I3]}, axis: z, points: {tip: [0, 0, -l]}}
connections: {pin: {ball: [lift, top.tip]}}
states: {now: {top.tilt: theta, top.axial_rate: w3, top.precession: smallest, steady: true}}
find: {N: pin.force.z at now}
"""


def test_a_force_is_not_told_of_a_steady_motion_that_is_none() -> None:
    """I₃ ω₃ ≥ 2 √(I₁ M (g + a) l cos θ), whatever is asked."""
    least = 2 * math.sqrt(0.02 * 10.8 * 0.1 * math.cos(math.radians(30))) / 0.001
    with pytest.raises(Unsolvable, match="`top` spins too slowly for a steady precession"):
        solve(LIFT.replace("RATE", f"{least - 1:.1f} rad/s"))
    assert str(solve(LIFT.replace("RATE", f"{least + 1:.1f} rad/s")).answers["N"]).startswith("N = M (a + g)")
    given = "M: kg, l: m, I1: kg m^2, I3: kg m^2, w3: rad/s, theta: rad, a: m/s^2, g: m/s^2"
    numbers = LIFT[LIFT.index("M: 1 kg") : LIFT.index("}\nbodies")]
    solution = solve(LIFT.replace(numbers, given))
    assert str(solution.answers["N"]) == "N = M (a + g) (if I₁ ≤ I₃² w₃²/(4 M l (a + g) cos θ))"
    assert all(item.holds for item in solution.derivation.confirmed)


BEYOND = """
up: z
given: {M: 0.2 kg, l: 5 cm, I1: 6e-4 kg m^2, I3: 8e-5 kg m^2}
bodies: {top: {mass: M, inertia: {about: tip, principal: [I1, I1, I3]}, axis: z, points: {tip: [0, 0, -l]}}}
connections: {floor: {ball: top.tip}}
states:
  start: {top.tilt: 23 deg, top.axial_rate: -400 rad/s, top.precession: 0 rad/s, top.nutation: -1 rad/s}
  ext: {top.tilt: smallest}
  back: {top.tilt: TILT}
find: {ASKED}
"""


@pytest.mark.parametrize(
    "asked",
    [
        "K: top.kinetic_energy at back",
        "w: top.angular_velocity at back in node axes",
        "F: size of floor.force at back",
        "n: top.nutation at back",
        "th: top.tilt at ext, O: top.precession at back",
        "th: top.tilt at ext, n: top.nutation at back",
    ],
)
def test_a_tilt_beyond_the_extreme_one_is_not_come_to(asked: str) -> None:
    """Its smallest tilt is 22.6°: at 22° K would be what the energy leaves, and ν the root of a negative number."""
    solved = BEYOND.replace("ASKED", asked)
    last = asked.split(", ")[-1].split(":")[0]
    try:
        solution = solve(solved.replace("TILT", "22 deg"))
    except Unsolvable as error:
        reason = str(error)
    else:
        assert last not in solution.answers
        reason = str(solution.refused[last])
    assert "is never reached from" in reason or "the motion does not come to that" in reason
    assert last in solve(solved.replace("TILT", "22.8 deg")).answers


def test_it_nods_no_more_at_an_extreme() -> None:
    solution = solve(BEYOND.replace("ASKED", "n: top.nutation at ext").replace("TILT", "22.8 deg"))
    assert solution.answers["n"].float == 0 and all(item.holds for item in solution.derivation.confirmed)
