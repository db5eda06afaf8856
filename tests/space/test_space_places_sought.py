"""Places and several letters that are sought in space: a place may be negative, a size may not, and what else fits is told.

By hand: a lump m at x on a bar that turns at n about a hinge at d has K = ½ n² (M L²/12 + M (L/2 − d)² + m (x − d)²), so x = d ± r.
"""

from __future__ import annotations

import math

import pytest

from rotsolve import Solution, Unsolvable, solve
from rotsolve.language.limited import letters_of_places
from rotsolve.scene.read import read_text

LUMP = """up: z
gravity: none
given: {m: 0.6 kg, M: 2 kg, L: 1 m, n: 10 rad/s, x: unknown, d: 0.3 m}
bodies:
  rod:
    points: {O: [d, 0, 0]}
    parts:
      bar: {shape: rod, mass: M, start: [0, 0, 0], end: [L, 0, 0]}
      lump: {shape: particle, mass: m, at: [x, 0, 0]}
connections: {pin: {hinge: rod.O, along: z, angular_velocity: n}}
states: {now: {rod.angle: 0 deg, rod.kinetic_energy: 25 J}}
find: {FIND}
"""
AWAY = math.sqrt((0.5 - 2 / 12 - 2 * 0.2**2) / 0.6)
BLOW = """up: z
gravity: none
given: {mb: 3 kg, a: 0.6 m, b: 0.4 m, c: 0.2 m, Jb: 2 N s, x: unknown}
bodies: {box: {shape: cuboid, mass: mb, sides: [a, b, c], points: {P: [x, b/4, 0], Q: [a/2, b/2, c/2]}}}
states: {before: at rest, after: {box.Q.speed: 1.5 m/s}}
events: {hit: {impulse: Jb, on: box.P, direction: [0, 0, -1], from: before, to: after}}
find: {FIND}
"""
TWO = """up: z
gravity: none
given: {n: 10 rad/s, s: 0.3 m, GIVEN}
bodies:
  r:
    points: {O: [0, 0, 0]}
    parts:
      c: {shape: particle, mass: 1 kg, at: [0.5 m, 0, 0]}
      w: {shape: particle, mass: m2, at: [PLACE, 0]}
connections: {pin: {hinge: r.O, along: z, angular_velocity: n}}
states: {now: {r.angle: 0 deg, TOLD}}
find: {FIND}
"""
TURNED = TWO.replace("GIVEN", "m2: unknown, q: unknown").replace("PLACE", "s*cos(q), s*sin(q)")
PLACED = TWO.replace("GIVEN", "m2: 0.6 kg, x: unknown, y: unknown").replace("PLACE", "x, y")


def said(solution: Solution) -> dict[str, tuple[bool | None, str]]:
    return {one.name: (one.holds, one.also) for one in solution.derivation.confirmed}


def test_coordinates_are_places_and_sizes_are_none() -> None:
    assert letters_of_places(read_text(LUMP.replace("FIND", "x: x"))) == {"d", "x"}
    both = LUMP.replace("bar: {shape: rod, mass: M, start", "bar: {shape: rod, mass: M, length: x, start")
    assert letters_of_places(read_text(both.replace("end: [L", "end: [x").replace("FIND", "x: x"))) == {"d"}


@pytest.mark.parametrize(("asked", "way"), [("x", 1), ("largest x", 1), ("smallest x", -1)])
def test_the_smallest_place_is_negative(asked: str, way: int) -> None:
    found = solve(LUMP.replace("FIND", f"x: {asked}"))
    assert found.answers["x"].float == pytest.approx(0.3 + way * AWAY)
    holds, also = said(found)["x"]
    assert holds
    assert (f"x = {0.3 - AWAY:g}" in f"x{also}") == (asked == "x")


@pytest.mark.parametrize("find", ["F: pin.force.x", "y: 2*x", "c: rod.cm.x"])
def test_a_place_of_the_other_sign_on_the_way_is_told(find: str) -> None:
    holds, also = said(solve(LUMP.replace("FIND", find)))[find[0]]
    assert holds
    assert also == f": x = {0.3 - AWAY:g} in SI units makes it so too"


def test_what_does_not_hang_on_the_place_is_as_it_was() -> None:
    assert said(solve(LUMP.replace("FIND", "I: rod.inertia about rod.O along z"))) == {"I": (True, "")}


@pytest.mark.parametrize("find", ["w: box.angular_velocity at after", "K: box.kinetic_energy at after", "x: x"])
def test_of_a_blow_all_places_are_looked_at(find: str) -> None:
    """|v_z + ½ w_x b − ½ w_y a| and the rest make 1.5 m/s at x = −0.0035 m and at −0.4365 m."""
    (verdict,) = solve(BLOW.replace("FIND", find)).derivation.confirmed
    assert verdict.holds is None
    assert "several" in verdict.why


@pytest.mark.parametrize(
    ("told", "find", "wanted"),
    [
        ("pin.force.x: -35 N, pin.force.y: -26 N", "m2: m2, q: q in deg", (True, True)),
        ("pin.force.x: -35 N, r.kinetic_energy: 17 J", "m2: m2", (True,)),  # 1 kg at ±120°
        ("pin.force.x: -35 N, r.kinetic_energy: 17 J", "q: q", (None,)),
        ("pin.force.x: -35 N, r.kinetic_energy: 17 J", "F: pin.force.y", (None,)),
    ],
)
def test_several_letters_are_looked_at_together(told: str, find: str, wanted: tuple[bool | None, ...]) -> None:
    """−n² (0.5 + m s cos q) = F_x, −n² m s sin q = F_y and ½ n² (0.25 + m s²) = K."""
    found = solve(TURNED.replace("TOLD", told).replace("FIND", find))
    assert tuple(one.holds for one in found.derivation.confirmed) == wanted
    if "m2" in found.answers:
        own = math.hypot(0.15, 0.26) / 0.3 if "y" in told.split("pin.force.")[-1][:1] else 1.0
        assert found.answers["m2"].float == pytest.approx(own)


def test_a_place_that_may_be_to_the_other_side_is_told_beside_one_that_may_not() -> None:
    """0.5 + 0.6 x = 0.8 and 0.25 + 0.6 (x² + y²) = 0.6: x = 0.5, y = ±0.5774."""
    told = "pin.force.x: -80 N, r.kinetic_energy: 30 J"
    found = said(solve(PLACED.replace("TOLD", told).replace("FIND", "x: x, y: y")))
    assert found == {"x": (True, ""), "y": (True, " = -0.57735 in SI units makes it so too")}


def test_a_root_with_which_another_letter_can_not_be_is_passed_over() -> None:
    """Balance: m₂ s (cos q, sin q) = −(0.5, 0) kg m holds at q = 180°, and at 0 with a negative mass."""
    told = "pin.force.x: 0 N, pin.force.y: -15 N"
    found = solve(TURNED.replace("TOLD", told).replace("FIND", "q: largest q in deg, m2: m2"))
    assert found.answers["q"].float == pytest.approx(math.degrees(math.atan2(0.15, -0.5)))
    assert found.answers["m2"].float == pytest.approx(math.hypot(0.15, 0.5) / 0.3)


def test_what_hangs_together_is_not_solved_and_nothing_is_missing() -> None:
    scene = TURNED.replace("m2: unknown, q: unknown", "m2: 1 kg, p: unknown, q: unknown")
    scene = scene.replace("at: [s*cos(q)", "at: [s*cos(q)/2 + s*cos(p)").replace("s*sin(q)", "s*sin(q)/2 + s*sin(p)")
    told = "pin.force.x: -35 N, pin.force.y: -26 N"
    with pytest.raises(Unsolvable, match="is not solved by these laws") as refused:
        solve(scene.replace("TOLD", told).replace("FIND", "p: p, q: q"))
    assert "tell all but one of `p`, `q`" in str(refused.value)


DOOR = """up: z
given: {M: 12 kg, a: 0.8 m, b: 0.6 m, T: unknown, g: 9.8 m/s^2}
bodies: {door: {shape: rectangle, mass: M, sides: [a, b], points: {H: [-a/2, 0, 0], C: [a/2, b/2, 0]}}}
connections: {pin: {hinge: door.H, along: y}}
actions: {cable: {force: T, on: door.C, direction: [WAY]}}
states: {now: {door.angle: 0 deg, balance: true}}
find: {T: T}
"""


@pytest.mark.parametrize(
    ("way", "parts"),
    [
        ("-a, -b/2, 1 m", (-0.8, -0.3, 1)),
        ("-a, 0, 60 cm", (-0.8, 0, 0.6)),
        ("-2*a, b, 1 m + a", (-1.6, 0.6, 1.8)),
        ("-0.8 m, -0.3 m, 1 m", (-0.8, -0.3, 1)),
        ("-a/b, 0, 1", (-0.8 / 0.6, 0, 1)),
    ],
)
def test_a_length_in_place_beside_letters_keeps_its_dimension(way: str, parts: tuple[float, ...]) -> None:
    """T z/|d| a = M g a/2."""
    found = solve(DOOR.replace("WAY", way))
    assert found.answers["T"].float == pytest.approx(12 * 9.8 / 2 * math.hypot(*parts) / parts[2])
    assert all(check.holds is not False for check in found.checks)


LOLLIPOP = """up: z
given: {m: 0.3 kg, r: 5 cm, R: 20 cm, W: 4 rad/s, N: unknown, g: 9.81 m/s^2, l: sqrt(R^2 + r^2)}
bodies: {pop: {shape: sphere, mass: m, radius: r, points: {O: [0, 0, -l], Q: [0, -r*R/l, -r*r/l]}}}
connections: {pivot: {ball: pop.O}}
actions: {floor: {force: N, on: pop.Q, direction: z}}
states: {now: {pop.tilt: acos(r/l), pop.precession: W, pop.spin: -W*l/r, steady: true}}
find: {N: N, w: pop.angular_velocity.y}
"""


def test_a_root_that_is_a_given_is_written_as_that() -> None:
    """Morin, problem 9.23: N = m g + (7/5) m r Ω², and ω = Ω R/r; with l = √(R² + r²) the root √(l² − r²) is R."""
    found = solve(LOLLIPOP)
    assert found.answers["N"].float == pytest.approx(0.3 * (9.81 + 7 / 5 * 0.05 * 16))
    assert (found.answers["N"].exact, found.answers["w"].exact) == ("m (g + 7 r W²/5)", "R W/r")


def test_other_numbers_of_that_given_are_another_case() -> None:
    many = solve(LOLLIPOP.replace(", w: pop.angular_velocity.y", "")).evaluate_many({"l": [0.25, 0.3]})["N"]
    alone = [solve(LOLLIPOP.replace("sqrt(R^2 + r^2)", f"{length} m")).answers["N"].float for length in (0.25, 0.3)]
    assert list(many) == pytest.approx(alone)
