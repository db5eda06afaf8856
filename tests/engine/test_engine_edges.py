"""Edges of cases in letters: what holds where a condition is only just met is told, as the same scene with the edge put in answers it."""

from __future__ import annotations

import re

import pytest

from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.formula import Symbol
from rotsolve.algebra.notation.parse import parse
from rotsolve.algebra.notation.text import to_text
from rotsolve.confirm.course.samples import holds, with_givens
from rotsolve.confirm.numbers import value_of
from rotsolve.core.derivation import Equality
from rotsolve.derivation.closing import answer_put
from rotsolve.page.text import plain_text
from rotsolve.pipeline import solve
from rotsolve.search.edges import Edge
from rotsolve.search.letterspace import LetterSpace
from rotsolve.solution.answer import AnswerView

BLOCKS = """
title: Two blocks
given: {m: kg, M: kg, u: m/s, e: number}
surfaces: {ice: level}
bodies: {a: {mass: m, moves: right}, b: {mass: M, moves: WAY}}
connections: {ba: {contact: [a, ice]}, bb: {contact: [b, ice]}}
states: {s0: {a.velocity: u, at rest: b}, s1: {}}
events: {hit: {collides: [NAMES], restitution: e, from: s0, to: s1}}
find: {va: a.velocity at s1, way: CHOICE}
"""
DISCS = """
title: Two discs on one axle, joined while they turn against each other
given: {I: kg m^2, J: kg m^2, w: rad/s, p: rad/s}
bodies: {a: {inertia: I}, b: {inertia: J}}
connections: {ax: {axle: [a, b]}}
states: {s0: {a.angular_velocity: w, b.angular_velocity: -p}, s1: {}}
events: {go: {joins: [NAMES], from: s0, to: s1}}
find: {w1: a.angular_velocity at s1, way: CHOICE}
"""
ROD = """
title: A rod struck by a ball
plane: horizontal
given: {M: kg, L: m, m: kg, u: m/s, x: m, e: number}
bodies: {rod: {shape: rod, mass: M, length: L}, ball: {mass: m, moves: up}}
states: {s0: {rod.angle: 0, at rest: rod, ball.velocity: u}, s1: {}}
events: {hit: {collides: [NAMES], restitution: e, from: s0, to: s1}}
find: {vs: rod.start.velocity.y at s1, way: CHOICE}
"""
LIFT = """
title: Two loads over a pulley
given: {m: kg, M: kg, R: m}
bodies: {a: {mass: m, moves: up}, b: {mass: M, moves: down}, p: {shape: disc, mass: 2 kg, radius: R}}
connections: {ax: {axle: p}, rope: {string: [NAMES]}}
states: {s: at rest}
find: {acc: a.acceleration at s, way: CHOICE}
"""
SIGNS = "{which of: {minus: X < 0, nil: X = 0, plus: X > 0}}"
KINDS = [
    (BLOCKS.replace("WAY", "right"), ("a, b", "b, a"), "va", "m = e M"),
    (BLOCKS.replace("WAY", "left"), ("a, b", "b, a"), "va", "m = e M"),
    (DISCS, ("a, b", "b, a"), "w1", "I = J p/w"),
    (ROD, ("ball, rod.at(x)", "rod.at(x), ball"), "vs", "x = ⅔ L"),
    (LIFT, ("a, p, b", "b, p, a"), "acc", "M = m"),
]
SCENES = [(scene.replace("NAMES", names), asked, edge) for scene, orders, asked, edge in KINDS for names in orders]


def told(answer: AnswerView) -> dict[tuple[str, ...], str]:
    return {case.conditions: case.word for case in answer.branches}


def relations(answer: AnswerView) -> dict[str, str]:
    """The option by how the letter of the edge is compared there."""
    found = {}
    for conditions, word in told(answer).items():
        assert len(conditions) == 1
        found[re.sub(r"^\S+ (\S) .*$", r"\1", conditions[0])] = word
    return found


CHOICES: list[tuple[str, str, set[str]]] = [
    (SIGNS, "nil", {"minus", "plus"}),
    ("{which of: {plus: X > 0, minus: X < 0}}", "none", {"minus", "plus"}),
    ("{which of: {plus: X >= 0, minus: X < 0}}", "plus", {"minus", "plus"}),
    ("{which of: {plus: X >= 0, minus: X <= 0}}", "plus, minus", {"minus", "plus"}),
    ("{which of: {one: X, other: -X}, is: largest}", "one, other", {"one", "other"}),
    ("{which of: {one: X, other: -X}, is: above 0}", "none", {"one", "other"}),
    ("{which of: {nil: X = 0, huge: X > 10*X and}}", "nil", {"none"}),
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    ("written", "asked", "edge", "choice", "nil", "others"),
    [  # each kind of scene with each choice in one of its two orders
        (*scene, *choice)
        for place, scene in enumerate(SCENES)
        for number, choice in enumerate(CHOICES)
        if place % 2 == number % 2
    ],
)
def test_each_option_holds_where_it_does(
    written: str, asked: str, edge: str, choice: str, nil: str, others: set[str]
) -> None:
    """On both sides of an edge strictly, and on it what holds there, unless that is what holds on one of the sides."""
    choice = choice.replace("X > 10*X and", "X*X < 0").replace("X", asked)
    answer = solve(written.replace("CHOICE", choice), confirm=False).answers["way"]
    found = told(answer)
    by_sign = relations(answer)
    if nil in others:
        assert set(by_sign) in ({">", "≤"}, {"<", "≥"})
        assert by_sign["≥" if "≥" in by_sign else "≤"] == nil
    else:
        assert set(by_sign) == {"<", ">", "="} and by_sign["="] == nil
        assert found[(edge,)] == nil
    assert {word for sign, word in by_sign.items() if sign != "="} == others


@pytest.mark.parametrize(("written", "asked", "edge"), SCENES)
def test_with_numbers_on_the_edge_it_is_the_same(written: str, asked: str, edge: str) -> None:
    sizes = {"m": "1 kg", "M": "2 kg", "e": "0.5", "I": "2 kg m^2", "J": "3 kg m^2", "w": "3 rad/s", "p": "2 rad/s"}
    sizes |= {"L": "3 m", "x": "2 m", "u": "1 m/s", "R": "1 m"}
    if "2 kg, radius" in written:
        sizes["M"] = "1 kg"
    text = written.replace("CHOICE", SIGNS.replace("X", asked))
    given = re.search(r"given: \{(.*)\}", text)
    assert given is not None
    names = [item.split(":")[0].strip() for item in given[1].split(",")]
    assert solve(text, settings={name: sizes[name] for name in names}).answers["way"].word == "nil"
    assert told(solve(text).answers["way"])[(edge,)] == "nil"


KICK = """
title: A ball kicked above its centre
given: {M: kg, R: m, h: m, J: N s, mu: number}
surfaces: {cloth: level}
bodies: {ball: {shape: sphere, mass: M, radius: R, moves: right, turns: clockwise, points: {P: [-sqrt(R^2-h^2), h]}}}
connections: {base: {contact: [ball, cloth], friction: mu}}
states: {still: {at rest: all}, go: {}, roll: {base: rolls}}
events: {kick: {impulse: J, on: ball.P, direction: right, from: still, to: go}}
find:
  {v: ball.velocity at go, w: ball.angular_velocity at go, vr: ball.velocity at roll, t: time from go to roll, f: base.friction_force at go}
"""
PENDULUM = """
title: A rod upright on a torsion wire
given: {M: kg, L: m, kappa: N m/rad, m: kg}
bodies: {rod: {shape: rod, mass: M, length: L}, knob: {mass: m}}
connections: {pin: {hinge: rod.start}, top: {weld: [rod.end, knob]}, wire: {torsion: rod, stiffness: kappa, rest_angle: 90 deg}}
states: {up: {rod.angle: 90 deg, balance: true}}
find: {T: period of small swings of rod about up}
"""
STATIC = """
title: A sledge with two coefficients
given: {m: kg, P: N, mu: number, s: number}
surfaces: {snow: level}
bodies: {sledge: {mass: m, moves: right}}
connections: {runners: {contact: [sledge, snow], friction: {static: s, kinetic: 0.1}}}
actions: {rope: {force: P, on: sledge, direction: right}}
states: {start: at rest}
find: {a: sledge.acceleration at start}
"""


@pytest.mark.exhaustive
def test_a_step_is_strict_on_both_sides_and_what_goes_over_is_not() -> None:
    found = solve(KICK)
    assert {case.conditions for case in found.answers["f"].branches} == {("h > ⅖ R",), ("h < ⅖ R",)}
    assert {case.conditions for case in found.answers["t"].branches} in (
        {("h ≥ ⅖ R",), ("h < ⅖ R",)},
        {("h > ⅖ R",), ("h ≤ ⅖ R",)},
    )
    said = ["".join(map(str, check.words)) for check in found.checks if check.holds is None]
    assert any(line.startswith("if h = ⅖ R no answer is given for ") for line in said)


def test_where_an_answer_divides_by_zero_it_does_not_hold() -> None:
    found = solve(PENDULUM)
    assert [case.conditions for case in found.answers["T"].branches] == [("κ > g L (½ M + m)",)]
    said = ["".join(map(str, check.words)) for check in found.checks if check.holds is None]
    assert any("κ < g L (½ M + m) there is no answer" in line for line in said)
    assert any("κ = g L (½ M + m) no answer is given" in line for line in said)


def test_a_jump_of_friction_belongs_to_what_sticks() -> None:
    """At P = s m g exactly it still sticks: the edge is that of the side whose answer is found on it."""
    found = solve(STATIC).answers["a"]
    by_form = {case.exact: case.conditions for case in found.branches}
    assert by_form["0"] == ("P ≤ m s g",) or by_form["0"] == ("P ≤ s m g",)
    assert all("P > " in conditions[0] for form, conditions in by_form.items() if form != "0")


def test_what_is_not_reached_on_the_edge_is_not_told_there() -> None:
    """Two equal loads stay where they are: at M = m the lower state is never reached, though v = 0 solves the balance of energy."""
    scene = LIFT.replace("states: {s: at rest}", "states: {s: at rest, low: {b.displacement: R}}").replace(
        "NAMES", "a, p, b"
    )
    found = solve(re.sub("find: .*", "find: {v: b.velocity at low}", scene))
    assert [case.conditions for case in found.answers["v"].branches] == [("M > m",)]
    said = ["".join(map(str, check.words)) for check in found.checks if check.holds is None]
    assert any(line.startswith("if M ≤ m there is no answer") for line in said)


def test_on_an_edge_roots_of_squares_are_written_out() -> None:
    """Where both masses of an Atwood machine are the same, √(4 m² u²) is 2 m u: it takes d/u, and not 0/0."""
    found = solve("""title: When a thrown load is at a place
given: {m: kg, M: kg, u: m/s, d: m, T: unknown}
bodies: {left: {mass: m, moves: up}, right: {mass: M, moves: down}, wheel: {mass: 0, radius: 5 cm}}
connections: {ax: {axle: wheel}, rope: {string: [left, wheel, right]}}
states: {start: {left.velocity: u}, end: {time: T}}
find: {T: T where left.displacement = d at end}
""")
    (answer,) = found.derivation.answers
    (edge,) = [one for one in (answer, *answer.otherwise) if any(line.relation == "=" for line in one.conditions)]
    assert edge.formula == Symbol("d") / Symbol("u")


@pytest.mark.exhaustive
def test_an_edge_on_which_a_logarithm_has_no_value_is_no_fault() -> None:
    """Constant power against friction: t has ln((P - τ ω₀)/(P - τ ω₁)) in it, which is 0/0 where P = τ ω₀ = τ ω₁ is put in."""
    found = solve("""title: Constant power against friction
given: {I: kg m^2, P: W, tau: N m, w0: rad/s, w1: rad/s}
bodies: {fly: {inertia: I, turns: clockwise}}
connections: {axle: {axle: fly, friction_torque: tau}}
actions: {motor: {power: P, on: fly}}
states: {start: {fly.angular_velocity: w0}, end: {fly.angular_velocity: w1}}
find: {t: time from start to end, n: fly.rotation from start to end, a: fly.angular_acceleration at end}
""")
    assert all(item.holds for item in found.derivation.confirmed)


def test_of_an_edge_on_which_a_form_has_no_value_nothing_is_told() -> None:
    """N = m g/(cos β − μ sin β) has none at μ = cot β, where no level push is large enough."""
    scene = """
title: Level push that holds a crate on a slope
given: {m: kg, beta: rad, mu: number, F: unknown}
surfaces: {ramp: {slope: beta, down: left}}
bodies: {crate: {mass: m}}
connections: {base: {contact: [crate, ramp], friction: mu}}
actions: {push: {force: F, on: crate, direction: right}}
states: {rest: {balance: true}}
find: {F: largest F where base sticks, N: base.normal_force at rest}
"""
    answers = solve(scene).answers
    assert answers["N"].exact == "m g/(cos β − μ sin β)"
    assert answers["N"].conditions == answers["F"].conditions == ("μ < cos β/sin β",)


def test_on_an_edge_on_which_it_never_gets_so_far_nothing_is_told() -> None:
    """A clutch that only just holds the load never brings both to one speed: what was supposed on the way divides by zero there."""
    found = solve("""
title: A flywheel is coupled to a drum with a hanging load
given: {I: kg m^2, J: kg m^2, m: kg, R: m, w: rad/s, tau: N m}
bodies: {fly: {inertia: I}, drum: {inertia: J, radius: R}, load: {mass: m, moves: up}}
connections: {ax: {axle: [fly, drum]}, cl: {clutch: [fly, drum], friction_torque: tau}, rope: {string: [drum, load]}}
states: {start: {fly.angular_velocity: w, drum.angular_velocity: 0}, one: {cl: sticks}}
find: {t: time from start to one, Q: size of cl.work from start to one}
""")
    assert found.answers["t"].conditions == found.answers["Q"].conditions == ("τ > m I g R/(I + J + m R²)",)
    said = ["".join(map(str, check.words)) for check in found.checks if check.holds is None]
    assert any(line.startswith("if τ = m I g R/(I + J + m R²) no answer is given") for line in said)


THROWN = """
title: A load thrown up or down against a stiff axle
given: {I: kg m^2, m: kg, R: m, p: m/s, q: m/s, tau: N m}
bodies: {drum: {inertia: I, radius: R}, load: {mass: m, moves: up}}
connections: {ax: {axle: drum, friction_torque: tau}, rope: {string: [drum, load]}}
states: {start: {load.velocity: p - q}}
find: {T: rope.tension at start, a: load.acceleration at start, f: ax.torque at start}
"""
BRAKED = """
title: A wheel that turns one way or the other, braked against a couple
plane: horizontal
given: {I: kg m^2, R: m, p: rad/s, q: rad/s, F: N, mu: number, Q: N m}
bodies: {wheel: {inertia: I, radius: R}}
connections: {ax: {axle: wheel}}
actions: {brake: {press: F, on: wheel.rim, friction: mu}, drive: {couple: Q, on: wheel}}
states: {start: {wheel.angular_velocity: p - q}}
find: {a: wheel.angular_acceleration at start, f: brake.torque at start}
"""
PUSHED = """
title: A crate that slides one way or the other, pushed
given: {m: kg, p: m/s, q: m/s, mu: number, P: N}
surfaces: {floor: level}
bodies: {crate: {mass: m, moves: right}}
connections: {base: {contact: [crate, floor], friction: mu}}
actions: {push: {force: P, on: crate, direction: right}}
states: {start: {crate.velocity: p - q}}
find: {a: crate.acceleration at start}
"""
SIZES = {"I": "1 kg m^2", "m": "1 kg", "R": "1 m", "F": "5 N", "mu": "0.5", "M": "2 kg"}
AT_REST = [
    (THROWN, {"tau": "20 N m"}),
    (THROWN, {"tau": "2 N m"}),
    (BRAKED, {"Q": "1 N m"}),
    (BRAKED, {"Q": "4 N m"}),
    (PUSHED, {"P": "1 N"}),
    (PUSHED, {"P": "9 N"}),
]


@pytest.mark.parametrize(
    ("written", "own"), AT_REST, ids=lambda item: ", ".join(item.values()) if isinstance(item, dict) else ""
)
def test_each_case_that_holds_on_an_edge_is_what_holds_there(written: str, own: dict[str, str]) -> None:
    """At p = q all is at rest, and friction holds it or does not: no case that takes in that edge goes by one of these alone."""
    letters = solve(written)
    names = [given.name for given in letters.problem.givens if given.value is None]
    speed = "1 m/s" if "p: m/s" in written else "1 rad/s"
    sizes = {name: {**SIZES, **own, "p": speed, "q": speed}[name] for name in names}
    there = solve(written, settings=sizes)
    numbers = with_givens(there.problem, {})
    for name, view in letters.answers.items():
        cases = [
            one for one in (view.answer, *view.answer.otherwise) if all(holds(line, numbers) for line in one.conditions)
        ]
        said = [value_of(one.closed or one.formula, numbers) for one in cases]
        closed = there.answers[name].answer.closed
        assert said == pytest.approx([value_of(closed, numbers)] * len(said))
        assert said


@pytest.mark.exhaustive
def test_what_the_least_push_decides_is_not_told_on_the_edge() -> None:
    """Q = ½ m g L cos β balances the rod: it stays, and w is what it would have at the bottom; α = 0 holds there too."""
    answers = solve("""title: Rod let go above the level against a couple
given: {m: kg, L: m, Q: N m, beta: deg}
bodies: {rod: {shape: rod, mass: m, length: L}}
connections: {pin: {hinge: rod.start}}
actions: {hold: {couple: Q, on: rod}}
states: {start: {rod.angle: beta, at rest: all}, low: {rod.angle: -90 deg}}
find: {w: rod.angular_velocity at low, alpha: rod.angular_acceleration at start}
""").answers
    assert "Q < ½ m g L cos β" in answers["w"].conditions
    assert any("Q ≤ ½ m g L cos β" in case.conditions for case in answers["alpha"].branches)


def test_an_answer_that_is_a_number_on_an_edge_has_its_value() -> None:
    """a = R (τ − m g R)/(I + m R²) is 0 where τ = m g R."""
    found = solve(THROWN)
    cases = (found.answers["a"].answer, *found.answers["a"].answer.otherwise)
    answer = next(one for one in cases if one.closed and to_text(one.closed) == "R (τ − m g R)/(I + m R²)")
    space, limit = LetterSpace(found.problem, SignOracle(found.problem.values), ()), parse("m g R")
    edge = Edge(Symbol("tau") - limit, "tau", limit, Equality(Symbol("tau"), limit), {})
    put = answer_put(answer, edge, space)
    assert put.value is not None and put.value.float == 0


LUMP = """title: Where a lump has to stick so that the rod turns with a given angular velocity
plane: horizontal
given: {M: kg, L: m, m: kg, u: m/s, w: rad/s, x: unknown}
bodies: {rod: {shape: rod, mass: M, length: L}, lump: {mass: m, moves: right}}
connections: {pin: {hinge: rod.start}}
states: {before: {rod.angle: -90 deg, at rest: rod, lump.velocity: u}, after: {}}
events: {hit: {joins: [rod.at(x), lump], from: before, to: after}}
find: {x: WORD x where rod.angular_velocity = w at after}
"""


@pytest.mark.parametrize("word", ["largest", "smallest"])
def test_an_edge_that_tells_no_letter_belongs_to_no_case_and_that_is_said(word: str) -> None:
    """m u x = (⅓ M L² + m x²) w has two roots; with M = m = 1 kg, L = 1 m, u = 4 m/s and w = 3 rad/s they are ⅓ m and L itself."""
    found = solve(LUMP.replace("WORD", word))
    numbers = {"M": 1, "L": 1, "m": 1, "u": 4, "w": 3}
    answer = found.answers["x"].answer
    holding = [one for one in (answer, *answer.otherwise) if all(holds(line, numbers) for line in one.conditions)]
    told = [value_of(one.closed or one.formula, numbers) for one in holding]
    assert told == ([pytest.approx(1 / 3)] if word == "smallest" else [])
    said = [plain_text(check.words) for check in found.derivation.checks if check.holds is None]
    assert any(line.endswith("= 0 no answer is given for x") for line in said)
