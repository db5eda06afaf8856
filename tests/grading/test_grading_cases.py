"""Answers in letters that have cases: what is right in all of them, in the first, in another alone, and with the wrong sign in one."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path

import pytest
from typer.testing import CliRunner

from rotsolve.algebra.formula import ZERO
from rotsolve.algebra.notation.text import to_text
from rotsolve.cli import app
from rotsolve.core.derivation import Answer
from rotsolve.grading.marking.judge import Judge
from rotsolve.grading.verdict import PARTLY, RIGHT, WRONG, JudgedPart, Paper
from rotsolve.page.text import plain_text
from rotsolve.pipeline import solve

SCENES = {
    # speeds of either sign: both cases are ordinary
    "wheel": """
title: A wheel whose speed is the difference of two, brought to rest by a couple of friction
given: {I: kg m^2, q: N m, u: rad/s, w: rad/s}
gravity: none
bodies: {wheel: {inertia: I}}
connections: {axle: {axle: wheel, friction_torque: q}}
states: {start: {wheel.angular_velocity: u - w}, end: {wheel.angular_velocity: 0}}
find:
  phi: wheel.rotation from start to end
  t: time from start to end
  K: kinetic_energy at start
""",
    # a place on either side of a spring's rest, where t has an arcsin(±1) in it
    "spring": """
title: A cart on a spring that is let go from either side
given: {M: kg, c: N/m, p: m, q: m}
surfaces: {track: level}
bodies: {cart: {mass: M, moves: right}}
connections: {base: {contact: [cart, track], friction: none}, coil: {spring: [ground, cart], stiffness: c}}
states: {start: {coil.elongation: p - q, at rest: all}, far: {cart.velocity: 0}}
find: {x: coil.elongation at far, t: time from start to far}
""",
    # a hoop that rolls, or slips where the slope is steep
    "hoop": """
title: A hoop on a rough slope
given: {m: kg, R: m, beta: deg, mu: number, g: m/s^2}
gravity: g
surfaces: {hill: {slope: beta}}
bodies: {hoop: {shape: ring, mass: m, radius: R, moves: down}}
connections: {base: {contact: [hoop, hill], friction: mu}}
find: {a: hoop.acceleration, alpha: hoop.angular_acceleration, f: base.friction_force}
""",
    # what slips hangs on letters: no mistake is known before they are told
    "coupling": """
title: Two shafts that are coupled, either faster
gravity: none
given: {I: kg m^2, J: kg m^2, p: rad/s, q: rad/s, tau: N m}
bodies: {one: {inertia: I}, two: {inertia: J}}
connections: {shaft: {axle: [one, two]}, plate: {clutch: [one, two], friction_torque: tau}}
states: {start: {one.angular_velocity: p, two.angular_velocity: q}, same: {plate: sticks}}
find: {t: time from start to same, H: plate.angular_impulse from start to same}
""",
    # one case alone has an answer
    "toss": """
title: A ball that is thrown up past a ledge
given: {u: m/s, h: m, g: m/s^2, m: kg}
gravity: g
bodies: {ball: {mass: m, moves: up}}
states: {start: {ball.velocity: u}, ledge: {ball.displacement: h}}
find: {v: ball.velocity at ledge, K: kinetic_energy at ledge}
""",
    # a vector, and a word
    "crate": """
title: A crate that is pulled or pushed along a rough floor
given: {M: kg, P: N, mu: number, g: m/s^2}
gravity: g
surfaces: {floor: level}
bodies: {crate: {mass: M, moves: right}}
connections: {base: {contact: [crate, floor], friction: mu}}
actions: {pull: {force: P, on: crate, direction: right}}
find: {a: crate.acceleration, R: base.force, f: base.friction_force}
""",
    # no case: two inverse functions that are one angle
    "swing": """
title: A hanging rod that is driven aside by a level force as far as it goes
gravity: g
given: {M: kg, L: m, F: N, g: m/s^2}
bodies: {rod: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: rod.start}}
actions: {push: {force: F, on: rod.end, direction: right}}
states: {start: {rod.angle: -90 deg, at rest: all}, far: {rod.angle: largest}}
find: {phi: rod.angle + 90 deg at far}
""",
}


@cache
def judge(scene: str, marking: str = "") -> Judge:
    return Judge(solve(f"{SCENES[scene]}{f'marking: {marking}' if marking else ''}"))


def part(scene: str, name: str, text: str, marking: str = "") -> JudgedPart:
    marked = judge(scene, marking).mark(Paper("one", {name: text}))
    return next(item for item in marked.parts if item.name == name)


def said(part: JudgedPart) -> str:
    return " | ".join(
        [f"{part.verdict.outcome} {part.marks}", *(plain_text(one.words) for one in part.verdict.remarks)]
    )


ROWS = [
    ("wheel", "phi", "I (u - w)|u - w|/(2q)", "right 1"),
    (
        "wheel",
        "phi",
        "I (u - w)²/(2q)",
        "partly right 1/2 | right if u > w; if u ≤ w it has the wrong sign: −I (u − w)²/(2 q)",
    ),
    (
        "wheel",
        "phi",
        "-I (u - w)²/(2q)",
        "partly right 1/2 | right if u ≤ w; if u > w it has the wrong sign: I (u − w)²/(2 q)",
    ),
    (
        "wheel",
        "phi",
        "I (w - u)|u - w|/(2q)",
        "wrong 0 | right but for the sign: the other direction is declared positive",
    ),
    ("wheel", "phi", "I (u - w)²/q", "wrong 0 | it looks as if the half was left out in the kinetic energy"),
    ("wheel", "phi", "t (u - w)/2", "right 1"),
    (
        "wheel",
        "phi",
        "t |u - w|/2",
        "partly right 1/2 | right if u > w; if u ≤ w it has the wrong sign: −I (u − w)²/(2 q)",
    ),
    ("wheel", "t", "I |u - w|/q", "right 1"),
    ("wheel", "t", "I (u - w)/q", "partly right 1/2 | right if u > w; if u ≤ w it has the wrong sign: I (w − u)/q"),
    ("wheel", "t", "I (w - u)/q", "partly right 1/2 | right if u ≤ w; if u > w it has the wrong sign: I (u − w)/q"),
    ("wheel", "t", "sqrt(2 I K)/q", "right 1"),
    ("wheel", "t", "3 s", "wrong 0 | a formula is asked for: the scene has no number for it"),
    ("wheel", "t", "I (u - w)", "wrong 0 | it measures an angular momentum (kg m²/s), but a time (s) is asked for"),
    ("wheel", "K", "I (w - u)²/2", "right 1"),
    ("wheel", "K", "I (u² - w²)/2", "wrong 0"),
    (
        "wheel",
        "K",
        "I (u - w) |u - w|/2",
        "partly right 1/2 | right if u > w; if u ≤ w it has the wrong sign: ½ I (u − w)²",
    ),
    ("spring", "x", "q - p", "right 1"),
    ("spring", "x", "p - q", "wrong 0 | right but for the sign"),
    ("spring", "x", "-|p - q|", "partly right 1/2 | right if p > q; if p ≤ q it has the wrong sign: |p − q|"),
    ("spring", "t", "π √(M/c)", "right 1"),
    ("spring", "t", "2π √(M/c)", "wrong 0"),
    ("hoop", "a", "½ g sin β", "partly right 1/2 | right if μ ≥ ½ tan β; if μ < ½ tan β it is g (sin β − μ cos β)"),
    ("hoop", "a", "g (sin β - μ cos β)", "right 1 | right if μ < ½ tan β; if μ ≥ ½ tan β it is ½ g sin β"),
    ("hoop", "a", "g sin β", "wrong 0 | it looks as if the friction on the hoop was left out"),
    ("hoop", "alpha", "a/R", "partly right 1/2 | right if μ ≥ ½ tan β; if μ < ½ tan β it is μ g cos β/R"),
    ("hoop", "alpha", "g sin β/(2R)", "partly right 1/2 | right if μ ≥ ½ tan β; if μ < ½ tan β it is μ g cos β/R"),
    ("hoop", "alpha", "(2 g sin β - 2 a)/(2 R)", "right 1"),
    ("hoop", "f", "m R α", "right 1"),
    ("hoop", "f", "9.8 N", "wrong 0 | a formula is asked for: the scene has no number for it"),
    ("coupling", "t", "I J |q - p|/(τ (I + J))", "right 1"),
    (
        "coupling",
        "t",
        "I J (p - q)/(τ (I + J))",
        "partly right 1/2 | right if p ≥ q; if p < q it has the wrong sign: I J (q − p)/(τ (I + J))",
    ),
    ("coupling", "t", "|H|/τ", "right 1"),
    ("coupling", "t", "I J (p + q)/(τ I + τ J)", "wrong 0 | it would be right with the other sign of q"),
    ("coupling", "t", "I J |p - q|/(τ I)", "wrong 0"),  # right at p = q, where all is 0
    ("coupling", "t", "I |p - q|/τ", "wrong 0"),
    (
        "coupling",
        "H",
        "I J |p - q|/(I + J)",
        "partly right 1/2 | right if p ≥ q; if p < q it has the wrong sign: I J (p − q)/(I + J)",
    ),
    ("toss", "v", "√(u² - 2 g h)", "right 1"),
    ("toss", "v", "√|u² - 2 g h|", "right 1"),
    ("toss", "v", "u - g h/u", "wrong 0"),
    ("crate", "a", "P/M - μ g", "right 1 | right if P > μ M g; if P ≤ μ M g it is 0"),
    ("crate", "a", "0", "partly right 1/2 | right if P ≤ μ M g; if P > μ M g it is P/M − μ g"),
    ("crate", "a", "P/M", "wrong 0 | it looks as if the friction on the crate was left out"),
    ("crate", "a", "(P - f)/M", "right 1"),
    ("crate", "R", "(-μ M g, M g)", "right 1 | right if P > μ M g; if P ≤ μ M g it is (−P, M g)"),
    ("crate", "R", "(-P, M g)", "partly right 1/2 | right if P ≤ μ M g; if P > μ M g it is (−μ M g, M g)"),
    (
        "crate",
        "R",
        "(μ M g, M g)",
        "wrong 0 | it looks as if the friction on the crate was given the wrong sign | the x component has the wrong sign",
    ),
    ("crate", "R", "(-f, M g)", "right 1"),
    ("crate", "R", "M g √(1 + μ²)", "right 1 | right if P > μ M g; if P ≤ μ M g it is (−P, M g)"),
    ("crate", "f", "P left", "partly right 1/2 | right if P ≤ μ M g; if P > μ M g it is μ M g"),
    ("crate", "f", "M (P/M - a)", "right 1"),
    ("swing", "phi", "2 arctan(2F/(M g))", "right 1"),
    ("swing", "phi", "2 arccos(M g/√(4F² + M² g²))", "right 1"),
    ("swing", "phi", "π - 2 arctan(M g/(2F))", "right 1"),
    ("swing", "phi", "arctan(4F/(M g))", "wrong 0"),
    (
        "swing",
        "phi",
        "2 arctan(2F M g)",
        "wrong 0 | its parts do not fit together: atan takes a pure number, but 2 F M g is a quantity in kg² m²/s⁴",
    ),
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("scene", "name", "text", "expected"), ROWS, ids=[" ".join(row[:3]) for row in ROWS])
def test_an_answer_is_judged_in_all_cases(scene: str, name: str, text: str, expected: str) -> None:
    assert said(part(scene, name, text)) == expected


CLAIMS = [
    (
        "hoop",
        "a",
        "½ g sin β (if tan(beta) <= 2 mu)",
        "partly right 1/2 | right if μ ≥ ½ tan β; if μ < ½ tan β it is g (sin β − μ cos β)",
    ),
    ("hoop", "a", "½ g sin β, for μ < ½ tan β", "wrong 0 | right if μ ≥ ½ tan β"),
    (
        "hoop",
        "a",
        "g (sin β - μ cos β) if μ < ½ tan β",
        "right 1 | right if μ < ½ tan β; if μ ≥ ½ tan β it is ½ g sin β",
    ),
    (
        "hoop",
        "a",
        "g (sin β - μ cos β) if μ < tan β",
        "partly right 1/2 | right if μ < ½ tan β; if μ ≥ ½ tan β it is ½ g sin β",
    ),
    ("hoop", "a", "g (sin β - μ cos β) if μ < ½ tan β; ½ g sin β if μ ≥ ½ tan β", "right 1"),
    ("hoop", "a", "a = g (sin β - μ cos β) if μ < ½ tan β; a = ½ g sin β otherwise", "right 1"),
    ("hoop", "a", "½ g sin β if μ < ½ tan β; g (sin β - μ cos β) otherwise", "wrong 0"),
    (
        "hoop",
        "a",
        "½ g sin β if it rolls",
        "partly right 1/2 | right if μ ≥ ½ tan β; if μ < ½ tan β it is g (sin β − μ cos β) | `if it rolls` is passed over",
    ),
    ("wheel", "phi", "I (u - w)²/(2q) if 0 < w < u", "right 1 | right if u > w; if u ≤ w it is −I (u − w)²/(2 q)"),
    ("wheel", "phi", "I (u - w)²/(2q) if u < w", "wrong 0 | right if u > w"),
    ("wheel", "K", "I (u - w)²/2 if u > w", "right 1 | right, and without its condition too"),
    ("crate", "a", "P/M - μ g for P > μ M g; 0 else", "right 1"),
    ("toss", "v", "√(u² - 2 g h) if u² > 2 g h", "right 1"),
]


@pytest.mark.parametrize(("scene", "name", "text", "expected"), CLAIMS, ids=[" ".join(row[:3]) for row in CLAIMS])
def test_a_condition_is_held_against_the_cases(scene: str, name: str, text: str, expected: str) -> None:
    assert said(part(scene, name, text)) == expected


def printed() -> list[tuple[str, Answer, Answer]]:
    """Every answer of the scenes that has cases, with each of them."""
    answers = ((scene, answer) for scene in SCENES for answer in judge(scene).letters.solution.derivation.answers)
    return [
        (scene, answer, case) for scene, answer in answers if answer.otherwise for case in (answer, *answer.otherwise)
    ]


def text_of(answer: Answer) -> str:
    if answer.components:
        return f"({', '.join(to_text(part.formula) for part in answer.components if part.formula is not None)})"
    assert answer.formula is not None
    return to_text(answer.formula)


@pytest.mark.exhaustive
def test_each_case_as_it_is_printed_is_right_in_it() -> None:
    """It is never wrong; where it is not right everywhere, its own conditions are told, and what the answer is in another case."""
    for scene, answer, case in printed():
        found = part(scene, answer.name, text_of(case))
        conditions = " and ".join(f"{to_text(one.left)} {one.relation} {to_text(one.right)}" for one in case.conditions)
        outcome, *remarks = said(found).split(" | ")
        assert outcome in ("right 1", "partly right 1/2"), (scene, answer.name, text_of(case))
        assert not remarks or remarks[0].startswith(f"right if {conditions}; if "), remarks
        assert remarks or outcome == "right 1"
        assert case is answer or remarks == [] or outcome == "partly right 1/2"


def test_what_is_wrong_in_each_case_is_wrong() -> None:
    for scene, answer, case in printed():
        if case.formula != ZERO and not case.components:
            assert part(scene, answer.name, f"3 ({text_of(case)})").verdict.outcome == WRONG


def test_a_formula_that_takes_the_case_from_its_bars_is_right_in_all() -> None:
    """|x| y and x |y| for what has the sign of x, in every scene whose cases tell a sign."""
    signs = {"wheel": ("u - w", "phi"), "spring": ("q - p", "x")}
    for scene, (sign, name) in signs.items():
        case = judge(scene).letters.solution.derivation.answers[0]
        assert case.name == name
        whole = f"({sign}) |{text_of(case)}|/|{sign}|"
        assert said(part(scene, name, whole)) == "right 1"
        assert part(scene, name, f"-{whole}").verdict.outcome == WRONG


@pytest.mark.parametrize(
    ("marking", "expected"),
    [
        ("{a: {points: 4}}", "partly right 2"),
        ("{a: {points: 4, deduct: {case: 1}}}", "partly right 3"),
        ("{a: {points: 4, deduct: {case: 0}}}", "right 4"),
        ("{a: {points: 4, deduct: 25 %}}", "partly right 3"),
        ("{a: {points: 4, deduct: {case: 100 %}}}", "wrong 0"),
    ],
)
def test_a_teacher_says_what_a_later_case_costs(marking: str, expected: str) -> None:
    assert said(part("hoop", "a", "½ g sin β", marking)).startswith(f"{expected} | right if μ ≥ ½ tan β; if ")


def test_the_sign_of_one_case_goes_by_how_signs_are_marked() -> None:
    assert said(part("spring", "x", "-|p - q|", "{x: {sign: lenient}}")).startswith("partly right 1/2 | right if p > q")
    assert said(part("wheel", "phi", "I (u - w)²/(2q)", "{phi: {sign: lenient}}")).startswith("right 1 | right but for")


def test_with_numbers_there_are_no_cases() -> None:
    """The numbers say which case it is: what is right in another is wrong."""
    numbers = Judge(solve(SCENES["crate"], settings={"M": "2 kg", "P": "5 N", "mu": "0.5", "g": "9.8 m/s^2"}))
    for text, expected in (
        ("0", "right 1"),
        ("P/M - μ g", "wrong 0"),
        ("(P - f)/M", "right 1"),
        ("0.1 m/s²", "wrong 0"),
    ):
        assert said(numbers.mark(Paper("one", {"a": text})).parts[0]).split(" | ")[0] == expected


def test_what_follows_from_a_wrong_answer_is_followed_in_letters() -> None:
    marked = judge("coupling").mark(Paper("one", {"t": "2 H/tau", "H": "I J (p - q)/(I + J)"}))
    assert [item.verdict.outcome for item in marked.parts] == [WRONG, RIGHT]


def test_a_page_and_its_data_tell_the_case(tmp_path: Path) -> None:
    file = tmp_path / "hoop.yaml"
    file.write_text(SCENES["hoop"], "utf-8")
    command = ["check", str(file), "-a", "a = g sin β/2", "-f", "json"]
    result = CliRunner().invoke(app, command)
    assert result.exit_code == 1
    answer = json.loads(result.stdout)["answers"][0]
    assert answer["outcome"] == PARTLY and [one["kind"] for one in answer["remarks"]] == ["case"]
    whole = CliRunner().invoke(app, ["check", str(file), "-a", "a = g (sin β - μ cos β)"])
    assert whole.exit_code == 0 and "right if μ < ½ tan β" in whole.stdout
