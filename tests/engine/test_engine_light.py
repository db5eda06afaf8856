"""Light pulleys: one turns whatever its mass, so that it passes on one tension, unless something else turns it too."""

from __future__ import annotations

from itertools import product

import pytest

from rotsolve.confirm.numbers import value_of
from rotsolve.pipeline import solve

m, M, k, n, F, g, R, r = 1.0, 3.0, 2.0, 1.5, 80.0, 10.0, 0.2, 0.1
NUMBERS = f"m: {m} kg, M: {M} kg, k: {k} kg, n: {n} kg, F: {F} N, g: {g} m/s^2, R: {R} m, r: {r} m"
LETTERS = "m: kg, M: kg, k: kg, n: kg, F: N, g: m/s^2, R: m, r: m"
LIGHT = {
    "radius alone": "mass: 0, radius: R",
    "turns": "mass: 0, radius: R, turns: clockwise",
    "disc": "shape: disc, mass: 0, radius: R",
    "no inertia": "mass: 0, inertia: 0 kg m^2, radius: R",
    "no size": "mass: 0",
}


@pytest.mark.parametrize(("light", "upright", "mirrored"), list(product(LIGHT, (True, False), (True, False))))
def test_a_light_pulley_that_is_pulled_has_one_tension(light: str, upright: bool, mirrored: bool) -> None:
    way = "up" if upright else "left" if mirrored else "right"
    names = ("two", "p", "one") if mirrored else ("one", "p", "two")
    pulls = "" if upright else f", pulls: {{one: {way}, two: {way}}}"
    flat = "" if upright else "surfaces: {floor: level}\n"
    lies = (
        "" if upright else ", c1: {contact: [one, floor], friction: none}, c2: {contact: [two, floor], friction: none}"
    )
    solution = solve(f"""title: A light pulley that is pulled
given: {{{NUMBERS}}}
{flat}bodies: {{one: {{mass: m, moves: {way}}}, two: {{mass: M, moves: {way}}}, p: {{{LIGHT[light]}, moves: {way}}}}}
connections: {{cord: {{string: [{", ".join(names)}]{pulls}}}{lies}}}
actions: {{pull: {{force: F, on: p.center, direction: {way}}}}}
states: {{start: {{at rest: all}}}}
find: {{a: one.acceleration at start, b: two.acceleration at start, c: p.acceleration at start, T: cord.tension at start}}
""")
    weight = g if upright else 0.0
    a, b = F / (2 * m) - weight, F / (2 * M) - weight
    found = [solution.answers[name].float for name in "abcT"]
    assert found == pytest.approx([a, b, (a + b) / 2, F / 2])
    assert all(item.holds for item in solution.derivation.confirmed) and solution.derivation.confirmed


HANGING = """title: What hangs from a light drum
given: {{{numbers}}}
bodies:
  one: {{mass: m, moves: up}}
  two: {{mass: M, moves: up}}
  three: {{mass: k, moves: up}}
  p: {{mass: 0, {drum}}}
connections: {{ax: {{axle: p{axle}}}, c1: {{string: [one, p{rim}, two]}}{more}}}
{actions}
states: {{start: {{at rest: all{said}}}}}
find: {{a: one.acceleration at start, al: p.angular_acceleration at start}}
"""
PLAIN = {"drum": "radius: R", "axle": "", "rim": "", "more": "", "actions": "", "said": ""}
STEPPED = {"drum": "radii: {big: R, small: r}", "rim": ".big", "more": ", c2: {string: [p.small, three]}"}
WEIGHT = m * g * R - M * g * R  # their torque, counterclockwise; the string goes with the rim at R
KINDS = {  # what else turns the drum: the scene, its torque and its inertia
    "nothing": ({}, 0.0, 0.0),
    "a second string that runs over it": (
        {"more": ", c2: {string: [three, p, four]}"},
        (k - n) * g * R,
        (k + n) * R * R,
    ),
    "a load on a smaller rim": (STEPPED, -k * g * r, k * r * r),
    "a lump at its rim": ({"more": ", w: {weld: [p.rim, three]}"}, -k * g * R, k * R * R),
    "lumps of which it is made": ({"drum": "radius: R, parts: {u: {mass: k, at: [r, 0]}}"}, -k * g * r, k * r * r),
    "a couple": ({"actions": "actions: {twist: {couple: F*r, on: p, direction: counterclockwise}}"}, F * r, 0.0),
    "a pull at its rim": ({"actions": "actions: {tug: {force: F/20, on: p.rim, direction: up}}"}, F / 20 * R, 0.0),
    "a pull at its middle": ({"actions": "actions: {tug: {force: F, on: p.center, direction: up}}"}, 0.0, 0.0),
    "a spring at its rim": (
        {"more": ", s: {spring: [ground, p.rim], stiffness: F/(20*r)}", "said": ", s.elongation: r"},
        -F / 20 * R,
        0.0,
    ),
    "a wire": ({"more": ", s: {torsion: p, stiffness: F*r}", "said": ", p.angle: 0.1 rad"}, -0.1 * F * r, 0.0),
}


@pytest.mark.parametrize(("kind", "letters"), list(product(KINDS, (False, True))))
def test_what_else_turns_a_light_drum_makes_its_tensions_differ(kind: str, letters: bool) -> None:
    told, torque, inertia = KINDS[kind]
    scene = HANGING.format(**{**PLAIN, "numbers": LETTERS if letters else NUMBERS, **told})
    if "four" in scene:
        scene = scene.replace("  p: {", "  four: {mass: n, moves: up}\n  p: {")
    elif "three" not in scene.split("connections")[1]:
        scene = scene.replace("  three: {mass: k, moves: up}\n", "")
    elif "weld" in scene:
        scene = scene.replace("three: {mass: k, moves: up}", "three: {mass: k}")
    solution = solve(scene)
    al = (WEIGHT + torque) / ((m + M) * R * R + inertia)
    given = {"m": m, "M": M, "k": k, "n": n, "F": F, "g": g, "R": R, "r": r, "theta_p": 0.1}
    for name, wanted in (("a", -R * al), ("al", al)):
        found = solution.answers[name]
        number = value_of(found.formula, given) if letters else found.float
        assert float(number) == pytest.approx(wanted), name
    assert any(item.holds for item in solution.derivation.confirmed) or letters


def test_a_motor_turns_a_light_pulley() -> None:
    scene = HANGING.format(**{**PLAIN, "numbers": NUMBERS, "axle": ", angular_acceleration: 20 rad/s^2"})
    solution = solve(
        scene.replace("  three: {mass: k, moves: up}\n", "").replace("find: {", "find: {Q: ax.torque at start, ")
    )
    assert solution.answers["a"].float == pytest.approx(-20 * R)
    assert solution.answers["Q"].float == pytest.approx((m + M) * R * R * 20 - WEIGHT)


def test_light_pulleys_one_on_another() -> None:
    solution = solve(f"""title: A light pulley pulled up, with another in its string
given: {{{NUMBERS}}}
bodies:
  one: {{mass: m, moves: up}}
  two: {{mass: M, moves: up}}
  base: {{mass: k, moves: up}}
  p: {{mass: 0, radius: R, moves: up}}
  q: {{mass: 0, radius: r, moves: up}}
connections: {{cord: {{string: [base, p, q.center], pulls: {{q: up}}}}, lower: {{string: [one, q, two]}}}}
actions: {{pull: {{force: F, on: p.center, direction: up}}}}
states: {{start: {{at rest: all}}}}
find: {{a: one.acceleration at start, b: two.acceleration at start, d: base.acceleration at start, om: q.angular_acceleration at start}}
""")
    a, b, d = F / (4 * m) - g, F / (4 * M) - g, F / (2 * k) - g
    found = [solution.answers[name].float for name in ("a", "b", "d", "om")]
    assert found == pytest.approx([a, b, d, (b - a) / (2 * r)])


@pytest.mark.parametrize(
    ("size", "backwards", "held"), list(product(("mass: 0", f"mass: {k} kg, inertia: 0 kg m^2"), *2 * ((False, True),)))
)
def test_a_wheel_slung_in_a_string_hangs_below_its_neighbours(size: str, backwards: bool, held: bool) -> None:
    """The ends are lifted by forces, or one of them is held; each end goes as far from the wheel as the other comes nearer."""
    names = ["one", "p", "ceiling" if held else "two"]
    solution = solve(f"""title: A wheel in the bight of a string
given: {{{NUMBERS}}}
bodies:
  one: {{mass: m, moves: up}}
  two: {{mass: M, moves: {"right" if held else "up"}}}
  p: {{{size}, radius: R, moves: up}}
  load: {{mass: n, moves: up}}
connections: {{cord: {{string: [{", ".join(names[::-1] if backwards else names)}], under: p}}, hook: {{string: [p.center, load]}}}}
actions: {{lift: {{force: F, on: one, direction: up}}, other: {{force: F/2, on: two, direction: {"right" if held else "up"}}}}}
states: {{start: {{at rest: all}}}}
find: {{a: one.acceleration at start, b: load.acceleration at start, T: cord.tension at start}}
""")
    hung = n + (0.0 if size == "mass: 0" else k)
    # 2 T − w g = w b, F − m g − T = m a, F/2 − M g − T = M c, b = (a + c)/2
    free = F / m - g + (0.0 if held else F / (2 * M) - g)
    T = (g + free / 2) / (2 / hung + 1 / (2 * m) + (0.0 if held else 1 / (2 * M)))
    found = [solution.answers[name].float for name in "abT"]
    assert found == pytest.approx([F / m - g - T / m, 2 * T / hung - g, T])
    assert all(item.holds for item in solution.derivation.confirmed) and solution.derivation.confirmed
