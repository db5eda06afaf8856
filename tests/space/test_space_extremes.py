"""Extremes over a letter in space: inside its range, at an end of it, by numbers where no closed form is known, or refused by name."""

from __future__ import annotations

import math

import pytest

from rotsolve import Unsolvable
from rotsolve.pipeline import solve
from rotsolve.solution import Solution

CUBOID = """
title: Cuboid on an oblique hinge
up: z
given: {y: unknown}
bodies: {d: {shape: cuboid, mass: 3 kg, sides: [0.6 m, 0.4 m, 0.2 m], points: {O: [y, 0, 0]}}}
connections: {h: {hinge: d.O, along: [0, 0.6, 0.8]}}
states: {a: {d.angle: 0 deg, d.angular_velocity: 0 rad/s}}
"""
STRUCK = """
title: Blow on a corner of a free cuboid, in a direction that is looked for
up: z
given: {q: unknown}
bodies: {d: {shape: cuboid, mass: 3 kg, sides: [0.6 m, 0.4 m, 0.2 m], points: {P: [0.3 m, 0.2 m, 0.1 m]}}}
states: {before: {d.velocity: [1 m/s, 0, 0], d.angular_velocity: [0, 0, 3 rad/s]}, after: {}}
events: {hit: {impulse: 2 N s, on: d.P, direction: [cos(q), 0, sin(q)], from: before, to: after}}
"""
GATE = """
title: Gate on a level post
up: z
given: {phi: unknown}
bodies:
  gate: {shape: rectangle, mass: 20 kg, sides: [1 m, 2 m], points: {A: [-0.5 m, 0.2 m, 0]}, turned: {about: x, by: 60 deg}}
connections: {post: {hinge: gate.A, along: [0, 1, 0]}}
states: {start: {gate.angle: phi, gate.angular_velocity: WRATE}}
"""
ROD = """
title: Moment of inertia about a place on a rod
up: z
given: {y: m}
bodies: {rod: {shape: rod, mass: 2 kg, length: 1 m}}
"""
BALL = """
title: Ball that rolls on a tilted turntable
up: z
given: {W: unknown}
bodies:
  table: {shape: disc, mass: 0, turned: {about: y, by: 10 deg}}
  ball: {shape: sphere, mass: 0.2 kg, radius: 3 cm}
connections:
  axis: {hinge: table.center, along: z, angular_velocity: W}
  grip: {rolls: [ball, table]}
states: {now: {"ball.position relative to table": [0.4 m, 0, 3 cm], ball.velocity: [0, 0.6 m/s, 0], ball.angular_velocity.z: 0 rad/s}}
"""


def answers(scene: str, *finds: str) -> Solution:
    return solve(scene.replace("WRATE", "2 rad/s") + "find: {" + ", ".join(finds) + "}\n")


def refusal(solution: Solution, name: str) -> str:
    return next(item.fault.message for item in solution.derivation.refused if item.name == name)


def confirmed(solution: Solution) -> bool:
    return bool(solution.derivation.confirmed) and all(item.holds for item in solution.derivation.confirmed)


def energy_struck(q: float) -> tuple[float, float]:
    """The kinetic energy and |ω| after the blow, by L = r × J and the moments of a cuboid."""
    moments = [3 / 12 * (0.4**2 + 0.2**2), 3 / 12 * (0.6**2 + 0.2**2), 3 / 12 * (0.6**2 + 0.4**2)]
    j = (2 * math.cos(q), 0.0, 2 * math.sin(q))
    r = (0.3, 0.2, 0.1)
    turn = (r[1] * j[2] - r[2] * j[1], r[2] * j[0] - r[0] * j[2], r[0] * j[1] - r[1] * j[0])
    omega = [turn[0] / moments[0], turn[1] / moments[1], 3 + turn[2] / moments[2]]
    v = (1 + j[0] / 3, j[1] / 3, j[2] / 3)
    energy = 1.5 * sum(part * part for part in v)
    energy += sum(i * w * w for i, w in zip(moments, omega, strict=True)) / 2
    return energy, math.hypot(*omega)


GRID = [math.tau * number / 20000 - math.pi for number in range(20000)]


def test_a_largest_size_lies_inside_the_range_though_that_has_no_end() -> None:
    solution = answers(CUBOID, "y: y where size of d.angular_acceleration is largest")
    moment = (0.6**2 * (0.6**2 + 0.2**2) + 0.8**2 * (0.6**2 + 0.4**2)) / 12
    assert solution.answers["y"].float == pytest.approx(math.sqrt(moment))  # g y/(moment + y²) times 0.6
    assert confirmed(solution)


def test_a_smallest_push_is_found_at_a_rate_of_either_sign() -> None:
    solution = answers(BALL, "W1: W where size of grip.force is smallest")
    assert solution.answers["W1"].float == pytest.approx(-9.8 * math.sin(math.radians(10)) / 0.6)
    assert confirmed(solution)


@pytest.mark.parametrize(("word", "best"), [("largest", max), ("smallest", min)])
def test_places_without_a_closed_form_are_certified_numbers(word: str, best: object) -> None:
    solution = answers(STRUCK, f"K: {word} d.kinetic_energy at after", f"w: {word} size of d.angular_velocity at after")
    assert solution.answers["K"].float == pytest.approx(best(energy_struck(q)[0] for q in GRID), rel=1e-6)  # type: ignore[operator]
    assert solution.answers["w"].float == pytest.approx(best(energy_struck(q)[1] for q in GRID), rel=1e-6)  # type: ignore[operator]
    assert confirmed(solution)


def test_questions_that_seek_one_letter_have_each_a_value_of_their_own() -> None:
    solution = answers(
        STRUCK,
        "q1: q where size of d.angular_velocity is largest at after",
        "K: largest d.kinetic_energy at after",
        "q2: q where d.kinetic_energy at after is smallest",
    )
    q1, q2 = (max(GRID, key=key) for key in (lambda q: energy_struck(q)[1], lambda q: -energy_struck(q)[0]))
    assert solution.answers["q1"].float == pytest.approx(q1, abs=1e-3)
    assert solution.answers["q2"].float == pytest.approx(q2, abs=1e-3)
    assert solution.answers["K"].float == pytest.approx(max(energy_struck(q)[0] for q in GRID), rel=1e-6)
    assert confirmed(solution)


def test_a_place_that_is_not_real_is_none() -> None:
    """The torque of a post has its derivative 0 also where sin φ would be beyond 1."""
    solution = answers(
        GATE, "t: largest post.torque.x", "F: largest size of post.force", "f: smallest size of post.force"
    )
    assert confirmed(solution) and len(solution.answers) == 3


def test_the_bars_of_a_size_hold_all_round() -> None:
    """|α| falls to 0 where α turns round, and is not −|α| beyond."""
    solution = answers(
        GATE, "al: smallest size of gate.angular_acceleration", "be: smallest gate.angular_acceleration.y"
    )
    assert solution.answers["al"].float == 0
    assert solution.answers["be"].float == pytest.approx(-9.8 * 0.5 * math.cos(math.radians(60)) ** 2 / (1 / 12 + 0.25))
    assert confirmed(solution)


def test_of_places_that_are_as_good_one_is_chosen_by_name() -> None:
    asked = "phi where size of gate.angular_acceleration is largest"
    assert "at more than one `phi`" in refusal_of(GATE, f"phi: {asked}")
    for word, value in (("smallest", 0.0), ("largest", math.pi)):
        assert answers(GATE, f"phi: {word} {asked}").answers["phi"].float == pytest.approx(value)


def refusal_of(scene: str, find: str) -> str:
    from rotsolve.core.faults import Unsolvable

    with pytest.raises(Unsolvable) as caught:
        answers(scene, find)
    return str(caught.value)


def test_an_end_of_the_range_is_an_extreme_too() -> None:
    solution = answers(ROD, "I: rod.inertia along z about rod.at(y)", "lo: smallest I", "hi: largest I")
    assert solution.answers["lo"].float == pytest.approx(2 / 12)
    assert solution.answers["hi"].float == pytest.approx(2 / 3)
    assert confirmed(solution)


@pytest.mark.parametrize(
    ("scene", "find", "said"),
    [
        (CUBOID, "y: y where d.kinetic_energy is largest", "does not depend on `y`"),
        (GATE.replace("unknown", "unknown, k: unknown").replace("WRATE", "k"), "F: largest size of post.force", "over several letters"),
        (BALL, "W1: W where size of grip.force is largest", "grows all the way as `W`"),
        (BALL.replace("unknown", "2 rad/s"), "W1: W where size of grip.force is largest", "that has no value"),
        (GATE.replace("unknown", "30 deg"), "F: largest size of post.force", "over its open letter"),
        (GATE.replace("unknown", "30 deg"), "F: largest post.torque.x", "no letter of the scene is open"),
    ],
)  # fmt: skip
def test_what_has_no_extreme_says_why(scene: str, find: str, said: str) -> None:
    assert said in refusal_of(scene, find)


def test_a_letter_that_the_laws_tell_is_not_looked_at_as_open() -> None:
    scene = """
title: Mass that falls at a told rate
given: {m: unknown}
bodies: {disc: {shape: disc, mass: 2 kg, radius: 10 cm}, block: {mass: m}}
connections: {axle: {hinge: disc.center}, string: {string: [disc, block]}}
states: {now: {block.acceleration: -2 m/s^2}}
"""
    for find in ("T: largest string.tension", "m1: m where string.tension is largest"):
        assert "is settled by the laws" in refusal_of(scene, find)


# all round, within limits, at an open end

EGG = """
title: Egg struck on its rim
up: z
gravity: none
given: {M: 3 kg, a: 0.6 m, b: 0.4 m, c: 0.2 m, ph: unknown, J: 2 N s}
bodies: {e: {shape: ellipsoid, mass: M, sides: [a, b, c], points: {P: [a*cos(ph), b*sin(ph), 0*a]}}}
states: {before: at rest, after: {}}
events: {hit: {impulse: J, on: e.P, direction: [1/2, 1/2, sqrt(1/2)], from: before, to: after}}
"""
OBLIQUE = """
title: Cylinder on an oblique shaft
up: z
gravity: none
given: {M: 4 kg, R: 0.1 m, h: 0.4 m, b: unknown, w: 50 rad/s}
bodies: {d: {shape: cylinder, mass: M, radius: R, length: h}}
connections: {s: {hinge: d, along: [sin(b), 0, cos(b)], angular_velocity: w}}
"""
IN_A_WIND = """
title: Ball on a slope in a wind
up: z
given: {m: 0.2 kg, R: 3 cm, u: 0.6 m/s, be: unknown}
bodies: {b: {shape: sphere, mass: m, radius: R}}
surfaces: {ramp: {slope: be}}
connections: {grip: {rolls: [b, ramp]}}
actions: {wind: {force: [0.3 N, 0.2 N, 1.1 N], on: b}}
states: {now: {b.velocity: [0, u, 0]}}
"""
SWINGING = """
title: Cylinder that swings about a point beside it
up: z
given: {M: 2 kg, R: 0.1 m, h: m, d: 0.3 m}
bodies: {c: {shape: cylinder, mass: M, radius: R, length: h, points: {P: [d, 0, h/2]}}}
connections: {s: {hinge: c.P, along: [0, 1, 0]}}
"""
ON_A_BALL = """
title: Rod on a ball joint that is struck
up: z
given: {M: 2 kg, L: 0.8 m, J: 3 N s, x: unknown}
bodies: {r: {shape: rod, mass: M, length: L}}
connections: {b: {ball: r.start}}
states: {pre: at rest, post: {}}
events: {hit: {impulse: J, on: r.at(x), direction: z, from: pre, to: post}}
"""


def egg_rate(ph: float) -> float:
    """|ω| = |I⁻¹ (r × J)| of the egg, with I of an ellipsoid, M (b² + c²)/5."""
    x, y, push = 0.6 * math.cos(ph), 0.4 * math.sin(ph), (1.0, 1.0, math.sqrt(2))
    turned = (y * push[2], -x * push[2], x * push[1] - y * push[0])
    return math.hypot(*(part / size for part, size in zip(turned, (0.2, 0.4, 0.52), strict=True)))


def test_what_repeats_half_a_turn_on_is_as_good_there() -> None:
    asked = "ph where size of e.angular_velocity is largest at after"
    assert "at more than one `ph`" in refusal_of(EGG, f"p: {asked}")
    best = max((math.tau * number / 20000 - math.pi for number in range(20001)), key=egg_rate)
    low, high = sorted((best, best - math.copysign(math.pi, best)))
    for word, value in (("smallest", low), ("largest", high)):
        assert answers(EGG, f"p: {word} {asked}").answers["p"].float == pytest.approx(value, abs=4e-4)


def test_what_the_numbers_make_as_good_is_as_good() -> None:
    """With b = 2 z the blow has no part about x anywhere, which no letter tells."""
    scene = EGG.replace("0*a]", "0.2 m*sin(ph)]").replace("[1/2, 1/2, sqrt(1/2)]", "[-1, 2, 1]")
    assert "at more than one `ph`" in refusal_of(scene, "p: ph where e.angular_velocity.x is smallest at after")


def test_a_smallest_size_that_is_nothing_is_confirmed() -> None:
    found = answers(EGG, "q: smallest size of e.angular_velocity.z at after")
    assert found.answers["q"].float == 0.0
    assert confirmed(found)


@pytest.mark.parametrize(("word", "degrees"), [("smallest", -135), ("largest", 135)])
def test_of_all_places_of_one_turn_the_angles_lie_within_half_a_turn_of_0(word: str, degrees: float) -> None:
    """M w² (h² − 3 R²) |sin b cos b|/12 is largest at ±45° and ±135°."""
    found = answers(OBLIQUE, f"q: {word} b where size of s.torque is largest").answers["q"]
    assert found.float == pytest.approx(math.radians(degrees))


def test_a_slope_lies_between_level_and_upright() -> None:
    """The wind and the weight along the slope, F cos β + (m g − F_z) sin β, are largest at tan β = (m g − F_z)/F."""
    found = answers(IN_A_WIND, "q: be where size of b.acceleration is largest")
    assert found.answers["q"].float == pytest.approx(math.atan((0.2 * 9.8 - 1.1) / 0.3))
    assert confirmed(found)


def test_with_the_wind_from_below_the_steepest_slope_is_best() -> None:
    """−F cos β + (m g − F_z) sin β grows all the way to 90°, and the assembly does not look beyond."""
    found = answers(IN_A_WIND.replace("[0.3 N", "[-0.3 N"), "Q: largest size of b.acceleration")
    assert found.answers["Q"].float == pytest.approx(5 / 7 * math.hypot(0.86, 0.2) / 0.2)
    assert confirmed(found)


def test_no_size_of_a_body_is_nothing_where_an_extreme_would_be() -> None:
    found = answers(SWINGING, "T: period of small swings of c", "q: smallest T")
    assert "it has no smallest value" in refusal(found, "q")


def test_the_push_during_a_blow_is_asked_over_a_letter_like_any_other() -> None:
    """At the center of percussion, 2/3 of the rod, the joint feels nothing; at its own end the whole blow, at the far one half of it."""
    found = answers(ON_A_BALL, "q: smallest size of b.impulse during hit", "Q: largest size of b.impulse during hit")
    assert found.answers["q"].float == pytest.approx(0.0, abs=1e-12)
    assert found.answers["Q"].float == pytest.approx(3.0)
    assert confirmed(found)


ON_HOOP = math.degrees(math.acos(9.8 / 36 / 0.5))  # cos q = g/(w² R)


@pytest.mark.parametrize(
    ("word", "rate", "angle"),
    [("largest", 6, ON_HOOP), ("smallest", 6, -ON_HOOP), ("largest", 2, 0.0), ("smallest", 2, 0.0)],
)
def test_of_places_on_a_turning_hinge_those_count_to_which_a_body_comes_back(
    word: str, rate: int, angle: float
) -> None:
    """cos q = g/(w² R) on both sides where w² > g/R, else the lowest place: on top a bead stays only if nothing touches it."""
    solution = solve(f"""
title: A bead on a hoop that goes round
up: z
given: {{m: 0.1 kg, R: 0.5 m, w: {rate} rad/s, q: unknown, g: 9.8 m/s^2}}
bodies:
  shaft: {{mass: 0, points: {{O: [0, 0, 0]}}}}
  bead: {{parts: {{b: {{shape: particle, mass: m, at: [0, 0, -R]}}}}, points: {{C: [0, 0, 0]}}}}
connections:
  post: {{hinge: shaft.O, along: z, angular_velocity: w}}
  ring: {{hinge: [shaft.O, bead.C], along: "-y"}}
states: {{now: {{bead.angle: q, steady: true}}}}
find: {{q: {word} q in deg}}
""")
    assert solution.answers["q"].float == pytest.approx(angle, rel=1e-6)
    assert confirmed(solution)


SWAYING = """
title: Disc on an axle that sways
up: z
gravity: none
given: {m: 15 kg, r: 5 cm, w: 330 rad/s, l: 15 cm, T: 1 s, phi: 0.3, t1: GIVEN}
bodies: {frame: {mass: 0, points: {O: [0, 0, 0]}}, disc: {shape: disc, mass: m, radius: r}}
connections:
  hang: {hinge: frame.O, along: x, angle: "phi*sin(2*pi*time/T + PHASE)"}
  axle: {axle: [frame, disc], along: y, bearings: [-l/2, l/2], angular_velocity: w}
states: {level: {time: 0 s}, end: {time: t1}}
"""
FORCE = math.pi * 15 * 0.05**2 * 330 * 0.3 / 0.15  # I w φ̇/l, I = ½ m r², φ̇ ≤ 2 π φ/T


@pytest.mark.parametrize("phase", ["0", "1", "-2"])
@pytest.mark.parametrize(("asked", "size"), [("largest", 1), ("smallest", -1), ("largest size of", 1)])
def test_the_largest_in_the_course_of_time_is_that_of_a_period(phase: str, asked: str, size: int) -> None:
    text = SWAYING.replace("PHASE", phase).replace("GIVEN", "s")
    solution = solve(text + f"find: {{F: {asked} axle.bearing1.force.x at end}}\n")
    assert float(solution.answers["F"].value) == pytest.approx(size * FORCE, rel=5e-4)
    assert [item.holds for item in solution.derivation.confirmed] == [True]


def test_when_it_is_largest_is_asked_for_the_first_time() -> None:
    text = SWAYING.replace("PHASE", "-1").replace("GIVEN", "unknown")
    asked = "t1 where axle.bearing1.force.x at end is largest"
    solution = solve(text + f"find: {{t1: smallest {asked}}}\n")
    assert float(solution.answers["t1"].value) == pytest.approx(1 / (2 * math.pi), rel=5e-4)
    for word in ("", "largest "):
        with pytest.raises(Unsolvable, match="it is largest over and over, each time T later"):
            solve(text + f"find: {{t1: {word}{asked}}}\n")


def test_a_function_of_time_says_how_its_largest_is_asked() -> None:
    text = SWAYING.replace("PHASE", "0").replace(", t1: GIVEN", "").replace(", end: {time: t1}", "")
    with pytest.raises(Unsolvable, match="`largest` of a function of time is not solved as such"):
        solve(text + "find: {F: largest size of axle.bearing1.force.x at any time}\n")
