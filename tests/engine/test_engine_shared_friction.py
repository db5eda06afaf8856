"""Friction of several that hold a state in balance together, whose shares statics leaves open: against plain arithmetic."""

from __future__ import annotations

from collections.abc import Callable

import pytest

import rotsolve
from margins import G, Numbers, answered_just_where
from rotsolve.confirm.course.samples import holding
from rotsolve.confirm.numbers import value_of

DRUM = """
title: A load on a drum that its stiff axle and a brake block hold
given: {I: kg m^2, R: m, m: kg, F: N, mu: number, Q: N m}
bodies: {drum: {inertia: I, radius: R, turns: WAY}, load: {mass: m, moves: down}}
connections:
  axle: {axle: drum, friction_torque: Q}
  cord: {string: [drum, load]}
actions: {brake: {press: F, on: drum.rim, friction: mu}}
states: {start: {balance: true}}
find: {T: cord.tension at start}
"""
ROW = """
title: Two rough blocks in a row and a load that hangs over a pulley
given: {M: kg, n: kg, m: kg, mu: number, nu: number}
surfaces: {table: level}
bodies: {one: {mass: M, moves: WAY}, two: {mass: n, moves: WAY}, roll: {mass: 0}, load: {mass: m, moves: down}}
connections:
  b1: {contact: [one, table], friction: mu}
  b2: {contact: [two, table], friction: nu}
  pin: {axle: roll}
  link: {string: [one, two]}
  cord: {string: [two, roll, load], pulls: {two: WAY}}
states: {start: {balance: true}}
find: {T: cord.tension at start}
"""
CRATE = """
title: A crate on two rough corners
given: {M: kg, L: m, b: m, F: N, mu: number, nu: number}
surfaces: {floor: level}
bodies: {crate: {shape: rectangle, mass: M, sides: [L, b]}}
connections:
  c1: {contact: [crate.BACK, floor], friction: mu}
  c2: {contact: [crate.FRONT, floor], friction: nu}
actions: {push: {force: F, on: crate, direction: WAY}}
states: {start: {balance: true}}
find: {N: c1.normal_force at start}
"""
GEARS = """
title: A load on a drum that is geared to a wheel, each with a stiff axle
given: {I: kg m^2, J: kg m^2, R: m, r: m, m: kg, Q: N m, P: N m}
bodies:
  drum: {inertia: I, radius: R, turns: clockwise}
  cog: {inertia: J, radius: r, turns: counterclockwise}
  load: {mass: m, moves: down}
connections:
  a1: {axle: drum, friction_torque: Q}
  a2: {axle: cog, friction_torque: P}
  mesh: {gear: [drum, cog]}
  cord: {string: [drum, load]}
states: {start: {balance: true}}
find: {T: cord.tension at start}
"""
ONE_AXLE = """
title: Two drums on one stiff axle, each with a load
given: {I: kg m^2, J: kg m^2, R: m, r: m, m: kg, n: kg, Q: N m}
bodies:
  drum: {inertia: I, radius: R, turns: clockwise}
  disc: {inertia: J, radius: r, turns: clockwise}
  load: {mass: m, moves: down}
  other: {mass: n, moves: down}
connections:
  ax: {axle: [drum, disc], friction_torque: Q}
  cord: {string: [drum, load]}
  rope: {string: [disc, other]}
states: {start: {balance: true}}
find: {T: cord.tension at start}
"""
CLUTCH = """
title: A load on a drum that a clutch ties to a disc on the same stiff axle
given: {I: kg m^2, J: kg m^2, R: m, m: kg, P: N m, Q: N m}
bodies:
  drum: {inertia: I, radius: R, turns: clockwise}
  disc: {inertia: J, turns: clockwise}
  load: {mass: m, moves: down}
connections:
  ax: {axle: [disc, drum], friction_torque: Q}
  clutch: {clutch: [drum, disc], friction_torque: P}
  cord: {string: [drum, load]}
states: {start: {balance: true}}
find: {T: cord.tension at start}
"""


def on_one_axle(x: Numbers) -> float:
    """Each is held by a friction of its own."""
    return x["Q"] - max(x["m"] * x["R"], x["n"] * x["r"]) * G


def by_clutch(x: Numbers) -> float:
    """The disc gives as much as the clutch passes on, and as its own friction holds."""
    return x["Q"] + min(x["P"], x["Q"]) - x["m"] * G * x["R"]


def in_a_row(x: Numbers) -> float:
    return (x["mu"] * x["M"] + x["nu"] * x["n"] - x["m"]) * G


def on_drum(x: Numbers) -> float:
    return x["Q"] + x["mu"] * x["F"] * x["R"] - x["m"] * G * x["R"]


def on_corners(x: Numbers) -> float:
    """Pushed at its middle, half as high as it is: N = ½ M g ∓ F b/(2 L)."""
    back = x["M"] * G / 2 - x["F"] * x["b"] / (2 * x["L"])
    return min(back, x["mu"] * back + x["nu"] * (x["M"] * G - back) - x["F"])


def geared(x: Numbers) -> float:
    return x["Q"] + x["P"] * x["R"] / x["r"] - x["m"] * G * x["R"]


SCENES: dict[str, tuple[str, Callable[[Numbers], float]]] = {
    "axle and brake": (DRUM.replace("WAY", "clockwise"), on_drum),
    "axle and brake, the other way round": (DRUM.replace("WAY", "counterclockwise"), on_drum),
    "in a row": (ROW.replace("WAY", "right"), in_a_row),
    "in a row, to the left": (ROW.replace("WAY", "left"), in_a_row),
    "two corners": (
        CRATE.replace("WAY", "right").replace("BACK", "corner1").replace("FRONT", "corner2"),
        on_corners,
    ),
    "two corners, to the left": (
        CRATE.replace("WAY", "left").replace("BACK", "corner2").replace("FRONT", "corner1"),
        on_corners,
    ),
    "gears": (GEARS, geared),
    "one axle": (ONE_AXLE, on_one_axle),
    "a clutch and one axle": (CLUTCH, by_clutch),
}


@pytest.mark.sampled(4)
@pytest.mark.parametrize("name", SCENES)
def test_they_hold_as_far_as_their_greatest_frictions_suffice(name: str) -> None:
    """There is an answer just where the frictions suffice together, by the margin of the plain arithmetic."""
    answered_just_where(*SCENES[name])


@pytest.mark.parametrize(
    ("mass", "says"), [("0.3", "friction suffices: b1 and b2 hold together"), ("3", "do not hold")]
)
def test_numbers_are_told_whether_they_suffice(mass: str, says: str) -> None:
    numbers = f"M: 2 kg, n: 3 kg, m: {mass} kg, mu: 0.1, nu: 0.2"
    text = SCENES["in a row"][0].replace("M: kg, n: kg, m: kg, mu: number, nu: number", numbers)
    assert any(says in str(check.words) for check in rotsolve.solve(text).checks)


def test_what_only_a_slack_string_would_share_is_not_certified() -> None:
    """Pushed from behind, the one holds alone: the string between them does not push the other."""
    text = SCENES["in a row"][0].split("bodies:")[0].replace("m: kg", "F: N").replace(" and a load that hangs", "")
    scene = rotsolve.solve(
        text
        + """bodies: {one: {mass: M, moves: right}, two: {mass: n, moves: right}}
connections:
  b1: {contact: [one, table], friction: mu}
  b2: {contact: [two, table], friction: nu}
  link: {string: [one, two]}
actions: {push: {force: F, on: one, direction: right}}
states: {start: {balance: true}}
find: {N: b1.normal_force at start}
"""
    )
    assert [verdict.holds for verdict in scene.derivation.confirmed] == [None]


def test_each_wheel_on_one_axle_is_held_by_a_torque_of_its_own() -> None:
    text = ONE_AXLE.replace("balance: true", "at rest: all").replace(
        "T: cord.tension at start", "T: cord.tension at start, S: rope.tension at start"
    )
    cases = rotsolve.solve(text).answers
    held = {"I": 0.1, "J": 0.2, "R": 0.2, "r": 0.1, "m": 1.0, "n": 3.0, "Q": 10.0, "g": G}
    for name, weight in (("T", 9.8), ("S", 29.4)):
        case = holding(cases[name].answer, held)
        assert case is not None and value_of(case.closed or case.formula, held) == pytest.approx(weight)


TRAIN = """
title: Two crates on a string on a slope, drawn up by a load
given: {m: kg, M: kg, mu: number, nu: number, p: kg, beta: rad}
surfaces: {hill: {slope: beta, down: left}}
bodies: {hare: {mass: m, moves: up}, fox: {mass: M, moves: up}, load: {mass: p, moves: down}, roll: {mass: 0}}
connections:
  b1: {contact: [hare, hill], friction: mu}
  b2: {contact: [fox, hill], friction: nu}
  ax: {axle: roll}
  rope: {string: [hare, fox]}
  lead: {string: [fox, roll, load]}
states: {start: at rest}
find: {a: load.acceleration}
"""
TALL = """
title: A tall crate tied by its top over a stiff drum to a load
given: {m: 2 kg, M: 10 kg, mu: 0.5, tau: 0.1 N m, R: 50 cm, I: 1 kg m^2, a: 10 cm, b: 100 cm}
surfaces: {floor: level}
bodies:
  crate: {shape: rectangle, mass: M, sides: [a, b], moves: WAY}
  drum: {inertia: I, radius: R, turns: clockwise}
  bob: {mass: m, moves: down}
connections:
  base: {contact: [crate, floor], friction: mu}
  ax: {axle: drum, friction_torque: tau}
  cord: {string: [crate.CORNER, drum, bob], pulls: {crate: WAY}}
states: {start: STATE}
find: {acc: crate.acceleration}
"""
UNTOLD = [
    (TRAIN, "the string goes slack (rope)"),
    (TRAIN.replace("at rest", "{balance: true}"), "the string goes slack (rope)"),
    *(
        (TALL.replace("WAY", way).replace("CORNER", corner).replace("STATE", state), "crate tips over at start")
        for way, corner in (("right", "corner3"), ("left", "corner4"))
        for state in ("at rest", "{balance: true}")
    ),
]


@pytest.mark.parametrize(("text", "words"), UNTOLD)
def test_what_hangs_on_the_shares_is_said_not_to_be_told(text: str, words: str) -> None:
    """A lower crate that holds itself lets the rope go slack; a tall one tips over by a pull that friction elsewhere may take."""
    checks = rotsolve.solve(text).derivation.checks
    assert [check.holds for check in checks if words in str(check.words)] == [None]


CRATE = """
title: Crate that a push is about to tip over
given: {{{sizes}, c: 1 m, mu: {mu}, F: unknown}}
surfaces: {{floor: level}}
bodies: {{crate: {{shape: rectangle, mass: m, sides: [a, c], points: {{P: [-a/2, y - c/2]}}}}}}
connections:
  left: {{contact: [crate.corner1, floor], friction: {left}}}
  right: {{contact: [crate.corner2, floor], friction: mu}}
actions: {{push: {{force: F, on: crate.P, direction: right}}}}
states: {{rest: {{balance: true}}}}
find: {{F: F where left.normal_force = {least}}}
"""
SIZES = "m: 20 kg, a: 0.5 m, y: 0.8 m"


@pytest.mark.parametrize(
    ("mu", "left", "least", "holds"),
    [
        ("0.2", "mu", "0", False),
        ("0.3", "mu", "0", False),
        ("0.32", "mu", "0", True),
        ("0.35", "0.1", "0", True),  # all of the weight is on the right
        ("0.3", "0.9", "0", False),
        ("0.3", "mu", "20 N", True),  # F = (m g/2 − N) a/y = 48.75 N, less than 58.8 N
        ("0.2", "mu", "20 N", False),
        ("0.2", "0.9", "60 N", True),  # 23.75 N of 0.9·60 N + 0.2·136 N
    ],
)
def test_frictions_suffice_together_for_a_force_that_is_sought(mu: str, left: str, least: str, holds: bool) -> None:
    """|F| ≤ μ₁ N₁ + μ₂ N₂, however they share it."""
    found = rotsolve.solve(CRATE.format(sizes=SIZES, mu=mu, left=left, least=least))
    told = [check for check in found.derivation.checks if "together" in str(check.words)]
    assert [check.holds for check in told] == [holds]


def test_in_letters_their_sum_is_a_condition() -> None:
    found = rotsolve.solve(CRATE.format(sizes="m: kg, a: m, y: m", mu="1", left="mu", least="0"))
    (answer,) = found.derivation.answers
    from rotsolve.confirm.course.samples import holds

    for a, fits in ((0.9, True), (1.7, True), (2.1, False)):  # a ≤ 2 μ y
        assert all(holds(line, {"a": a, "y": 1.0, "m": 1.0, "mu": 1.0, "g": 9.8}) for line in answer.conditions) == fits
