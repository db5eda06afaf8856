"""A letter that a question seeks runs over all that it can be: keys and what stands under them limit it, and roots need no closed form."""

from __future__ import annotations

import math

import pytest

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import Symbol, call, sqrt
from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

PLATE = """
given: {{a: {a}, b: 20 cm, M: 2 kg}}
bodies: {{plate: {{{shape}, mass: M}}}}
find: {{I: plate.inertia, a_0: a where I is {word}}}
"""
PULLEY = """
given: {m: kg, S: 3 kg, M: 1 kg, R: 10 cm}
bodies: {a: {mass: m, moves: down}, b: {mass: S - m, moves: up}, pulley: {shape: disc, mass: M, radius: R}}
connections: {axis: {axle: pulley}, string: {string: [a, pulley, b]}}
states: {start: at rest}
find: {ASKED}
"""
BUMP = """
plane: horizontal
given: {k: number, u: 3 m/s, m: 1 kg, M: 2 kg}
bodies: {a: {mass: m, moves: right}, b: {mass: M, moves: right}}
states: {s: {a.velocity: u, b.velocity: 0}, f: {}}
events: {h: {collides: [a, b], restitution: 1 - 2*k, from: s, to: f}}
find: {ASKED}
"""


def why(scene: str, name: str) -> str:
    """Why a question has no answer."""
    return solve(scene).refused[name].fault.message


@pytest.mark.parametrize(
    ("shape", "a", "word", "towards"),
    [
        ("shape: rectangle, sides: [a, b]", "m", "smallest", "0"),
        ("shape: cuboid, sides: [a, b, b]", "m", "smallest", "0"),
        ("shape: annulus, radii: {inner: a, outer: b}", "m", "smallest", "0"),
        ("shape: annulus, radii: {inner: a, outer: b}", "m", "largest", "b"),
        ("shape: rectangle, sides: [b - a, b]", "m", "smallest", "b"),
    ],
)
def test_a_size_of_a_body_is_never_nothing(shape: str, a: str, word: str, towards: str) -> None:
    told = why(PLATE.format(shape=shape, a=a, word=word), "a_0")
    assert told.startswith(f"it has no {word} value: ") and told.endswith(f" towards {towards}")


def test_what_is_left_of_a_whole_limits_a_letter() -> None:
    """F = g (8 m (S − m) + 3 S M + M²)/(2 S + M) has its largest value at m = S/2; beyond m = S no mass is left."""
    found = solve(PULLEY.replace("ASKED", "F: axis.force at start, m_0: m where F is largest"))
    assert found.answers["m_0"].float == pytest.approx(1.5)
    assert {item.name: item.holds for item in found.derivation.confirmed}["m_0"]
    asked = "a_1: a.acceleration at start, m_0: m where a_1 is largest"
    assert why(PULLEY.replace("ASKED", asked), "m_0").endswith("it grows all the way as `m` grows towards S")


def test_what_a_key_says_of_a_formula_limits_its_letters() -> None:
    """0 ≤ 1 − 2 k ≤ 1: what is largest at an end of that is so there, and the assembly confirms it."""
    asked = "v: b.velocity at f, k_1: k where v is largest, k_2: k where v is smallest, v_1: largest v, v_2: smallest v"
    found = solve(BUMP.replace("ASKED", asked))
    assert [found.answers[name].float for name in ("k_1", "k_2", "v_1", "v_2")] == pytest.approx([0, 0.5, 2, 1])
    assert all(item.holds for item in found.derivation.confirmed)


def test_a_value_without_a_closed_form_is_a_certified_number() -> None:
    """9 T − 2 T³ = 5 at two positive times."""
    scene = """
given: {c: 2 rad/s^3, w: 9 rad/s, T: s}
bodies: {wheel: {shape: disc, mass: 2 kg, radius: 0.3 m}}
connections: {axis: {axle: wheel, angle: w*time - c*time^3}}
states: {start: {}, end: {time: T}}
find: {th: wheel.rotation from start to end, ASKED}
"""
    found = solve(scene.replace("ASKED", "a: smallest T where th = 5 rad, b: largest T where th = 5 rad"))
    for name in ("a", "b"):
        time = found.answers[name].float
        assert 9 * time - 2 * time**3 == pytest.approx(5, rel=1e-12)
    assert found.answers["a"].float < found.answers["b"].float
    assert all(item.holds for item in found.derivation.confirmed)
    told = why(scene.replace("ASKED", "a: T where th = 5 rad"), "a")
    assert "several values of `T` fulfil the condition: 0.6047 and 1.753" in told


def test_a_size_has_a_value_on_both_sides_of_zero() -> None:
    """|v| = u |m − e M|/(m + M)."""
    scene = BUMP.replace("1 - 2*k", "0.5").replace("k: number", "e: 0.5").replace("M: 2 kg", "M: kg")
    for word, mass in (("smallest", 0.8), ("largest", 8)):
        found = solve(scene.replace("ASKED", f"v: a.velocity at f, M_1: {word} M where size of v = 1 m/s"))
        assert found.answers["M_1"].float == pytest.approx(mass)


@pytest.mark.parametrize(
    ("find", "value"), [("F: largest size of pin.force at s", 5), ("F: smallest size of pin.force at s", 2.5)]
)
def test_the_assembly_looks_over_the_letter_of_an_extreme_in_the_plane(find: str, value: float) -> None:
    """A force across a level rod on a hinge is halved there, one along it is not."""
    found = solve(f"""
given: {{F_0: 5 N, M: 2 kg, L: 1 m, phi: rad}}
plane: horizontal
bodies: {{rod: {{shape: rod, mass: M, length: L}}}}
connections: {{pin: {{hinge: rod.start}}}}
actions: {{push: {{force: F_0, on: rod.end, direction: phi}}}}
states: {{s: {{rod.angle: 30 deg, at rest: all}}}}
find: {{{find}}}
""")
    assert found.answers["F"].float == pytest.approx(value)
    assert [item.holds for item in found.derivation.confirmed] == [True]


STANDING = """
given: {{M: 3 kg, m: {m}, L: 1 m, x: unknown}}
bodies: {{rod: {{shape: rod, mass: M, length: L}}, lump: {{mass: m}}}}
connections: {{pin: {{hinge: {pin}}}, screw: {{weld: [{at}, lump]}}}}
states: {{up: {{rod.angle: 90 deg, balance: true}}}}
find: {{x_0: {word} x where up is stable}}
"""


def test_where_an_equilibrium_is_only_just_stable_its_slope_tells_the_side() -> None:
    """M (L/2 − 0.6 L) + m (x − 0.6 L) < 0 below x = 0.9 L; with the pin at x, (M + m) x > M L/2 + m L beyond 0.7 L."""
    low = STANDING.format(m="1 kg", pin="rod.at(0.6*L)", at="rod.at(x)", word="largest")
    high = STANDING.format(m="2 kg", pin="rod.at(x)", at="rod.end", word="smallest")
    assert solve(low).answers["x_0"].float == pytest.approx(0.9)
    assert solve(high).answers["x_0"].float == pytest.approx(0.7)
    with pytest.raises(Unsolvable, match="stable below a value"):
        solve(low.replace("largest x", "smallest x"))
    with pytest.raises(Unsolvable, match=r"unstable whatever `x` is"):
        solve(low.replace("0.6*L", "0.1*L"))


@pytest.mark.parametrize("direction", ["up", "down", "90 deg"])
def test_a_pull_straight_up_leaves_a_wheel_neither_over_nor_under_it(direction: str) -> None:
    scene = f"""
given: {{M: 2 kg, F: 5 N, R: 20 cm, mu: 0.6}}
surfaces: {{floor: level}}
bodies: {{spool: {{shape: disc, mass: M, radius: R, moves: right}}}}
connections: {{touch: {{contact: [spool, floor], friction: mu}}}}
actions: {{pull: {{force: F, on: spool, direction: {direction}, over: true}}}}
states: {{s: at rest}}
find: {{a: spool.acceleration at s}}
"""
    with pytest.raises(Unsolvable, match="at its side, neither over nor under it"):
        solve(scene)


def test_which_of_two_precessions_is_meant_is_not_guessed_over_a_letter() -> None:
    scene = """
up: z
given: {M: 0.2 kg, l: 0.05 m, I1: 6e-4 kg m^2, I3: 8e-5 kg m^2, w3: 400 rad/s, th: rad}
bodies: {top: {mass: M, inertia: {about: tip, principal: [I1, I1, I3]}, axis: z, points: {tip: [0, 0, -l]}}}
connections: {floor: {ball: top.tip}}
states: {now: {top.tilt: th, top.axial_rate: w3, top.precession: smallest, steady: true}}
find: {W: top.precession at now, t: th where W is largest}
"""
    assert why(scene, "t").startswith("which of two steady precessions of `top` is meant hangs on `th`")
    root = sqrt(
        (Symbol("I3") * Symbol("w3")) ** 2
        - 4 * Symbol("M") * Symbol("I1") * Symbol("g") * Symbol("l") * call("cos", Symbol("th"))
    )
    smaller = (Symbol("I3") * Symbol("w3") - root) / (2 * Symbol("I1") * call("cos", Symbol("th")))
    closed = solve(scene).answers["W"].answer.closed
    assert closed is not None and is_zero(closed - smaller)


def test_a_question_is_never_dropped_without_a_word() -> None:
    scene = """
given: {I: 0.05 kg m^2, r: 10 cm, R: 20 cm, mu: 0.3, phi: unknown, F: 15 N}
surfaces: {floor: level}
bodies: {spool: {mass: 2 kg, inertia: I, radii: {core: r, rims: R}, moves: right}}
connections: {touch: {contact: [spool.rims, floor], friction: mu}}
actions: {pull: {force: F, on: spool.core, direction: phi, under: true}}
states: {start: at rest}
find: {p: smallest phi where touch sticks, q: largest phi where touch sticks}
"""
    with pytest.raises(Unsolvable) as refused:
        solve(scene)
    lines = {fault.span.column for fault in (refused.value.fault, *refused.value.others)}
    assert len(lines) == 2


def test_another_value_near_the_end_of_a_range_is_found() -> None:
    """On a rough slope m slides up, with m = 3.30 kg, or down, with 4.93 kg; at 6 kg nothing is left of the other body."""
    scene = """
given: {m: unknown, S: 6 kg, b: 30 deg, R: 0.1 m, mu: 0.25}
surfaces: {ramp: {slope: b, down: left}}
bodies: {A: {mass: m, moves: up}, B: {mass: S - m, moves: down}, p: {shape: disc, mass: 1 kg, radius: R, turns: clockwise}}
connections: {c1: {contact: [A, ramp], friction: mu}, ax: {axle: p}, s: {string: [A, p, B]}}
states: {start: at rest}
find: {q: WORD m where size of A.acceleration = 0.5 m/s^2}
"""
    pulled, rubbed = 0.5 * 9.8, 0.25 * 3**0.5 / 2 * 9.8
    up = (6 * 9.8 - 0.5 * 6.5) / (9.8 + pulled + rubbed)
    down = (6 * 9.8 + 0.5 * 6.5) / (9.8 + pulled - rubbed)
    assert solve(scene.replace("WORD", "smallest")).answers["q"].float == pytest.approx(up)
    assert solve(scene.replace("WORD", "largest")).answers["q"].float == pytest.approx(down)
    with pytest.raises(Unsolvable, match=f"m = {down:.6g} in SI units makes it so too"):
        solve(scene.replace("WORD ", ""))


def test_another_value_beyond_rest_on_the_other_side_is_found() -> None:
    """An axle that rubs holds two masses between the two with which they move apart as fast: m ± d of 6 kg."""
    scene = """
given: {m: unknown, S: 6 kg, tau: 0.4 N m}
bodies: {A: {mass: m, moves: up}, B: {mass: S - m, moves: down}, p: {shape: disc, mass: 1 kg, radius: 10 cm, turns: clockwise}}
connections: {ax: {axle: p, friction_torque: tau}, s: {string: [A, p, B]}}
states: {start: at rest}
find: {q: m where size of A.acceleration = 1 m/s^2}
"""
    apart = (1 * 6.5 + 4) / (2 * 9.8)
    with pytest.raises(Unsolvable, match=f"m = {3 + apart:.6g} in SI units makes it so too"):
        solve(scene)


@pytest.mark.parametrize(("word", "value"), [("smallest", 0), ("largest", 1)])
def test_both_ends_of_a_rod_are_places_on_it(word: str, value: float) -> None:
    scene = f"""
given: {{M: 3 kg, L: 1 m, x: m}}
bodies: {{rod: {{shape: rod, mass: M, length: L}}}}
connections: {{pin: {{hinge: rod.at(x)}}}}
find: {{q: {word} x where rod.inertia about pin = 1 kg m^2}}
"""
    assert solve(scene).answers["q"].float == pytest.approx(value)
    with pytest.raises(Unsolvable, match="x = 0 in SI units makes it so too"):
        solve(scene.replace(f"{word} x", "x"))


def test_one_question_with_several_values_takes_no_other_with_it() -> None:
    scene = """
given: {m: 1 kg, M: kg, u: 3 m/s}
plane: horizontal
bodies: {a: {mass: m, moves: right}, b: {mass: M, moves: right}}
states: {s: {a.velocity: u, b.velocity: 0}, f: {}}
events: {h: {collides: [a, b], restitution: 0.5, from: s, to: f}}
find: {v: a.velocity at f, q: M where size of v = 1 m/s, w: b.velocity at f, x: "b.velocity.y at f"}
"""
    found = solve(scene)
    assert list(found.refused) == ["q"]
    assert {"v", "w"} <= found.answers.keys()


@pytest.mark.parametrize("angle", ["0", "-40 deg", "20 deg"])
def test_what_is_no_equilibrium_has_no_limit_of_stability(angle: str) -> None:
    scene = f"""
given: {{M: 2 kg, L: 1 m, w: unknown}}
bodies: {{rod: {{shape: rod, mass: M, length: L}}}}
connections: {{pin: {{shaft: rod.start, turning: w}}, coil: {{torsion: rod, stiffness: 3 N m/rad, rest_angle: {angle}}}}}
states: {{out: {{rod.angle: {angle}, steady: true}}}}
find: {{q: smallest w where out is stable}}
"""
    with pytest.raises(Unsolvable, match="out is no equilibrium"):
        solve(scene)


@pytest.mark.parametrize(
    "sought", ["", ", q: k where va = 1 m/s", ", q: k where va is largest", ", q: k where va = 9 m/s"]
)
def test_what_a_letter_may_be_is_told_beside_what_seeks_it(sought: str) -> None:
    found = solve(BUMP.replace("ASKED", f"va: a.velocity at f{sought}"))
    assert any("k ≤ ½" in str(line) for line in found.derivation.conventions)
    assert ("q" in found.refused) == ("9 m/s" in sought)


@pytest.mark.parametrize("word", ["smallest", "largest"])
def test_of_the_first_place_on_the_way_there_is_no_largest(word: str) -> None:
    scene = """
title: Where a falling rod is as fast as that
given: {m: 2 kg, L: 1 m, q: unknown, w: 3 rad/s}
bodies: {rod: {shape: rod, mass: m, length: L}}
connections: {pin: {hinge: rod.start}}
states: {start: {rod.angle: 60 deg, at rest: all}, then: {rod.angle: q, rod.angular_velocity: -w}}
find: {q: q in deg}
"""
    height = math.sin(math.radians(60)) - 3**2 / (3 * 9.8)  # sin q, by the energy ⅙ M L² w² = ½ M g L (sin 60° − sin q)
    assert solve(scene).answers["q"].float == pytest.approx(math.degrees(math.asin(height)), rel=1e-12)
    with pytest.raises(Unsolvable, match=f"reached first: `{word}` chooses none"):
        solve(scene.replace("q: q in", f"q: {word} q in"))
