"""What the reader makes of good scenes: letters, exact values, points, conditions and phrases."""

from fractions import Fraction

import pytest

from rotsolve.algebra.formula import PI, ZERO, Negative, Number, Quotient, Symbol
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.units.dimension import ANGLE, LENGTH, MASS, NONE
from rotsolve.core.faults import SceneError
from rotsolve.language.problem import Problem, Term
from rotsolve.pipeline import solve
from rotsolve.scene.read import read_text

TURNING = """
title: Turning
given: {{f: 4 Hz, w: 8*pi rad/s, m: 2 kg, L: 1 m}}
bodies: {{rod: {{shape: rod, mass: m, length: L}}, disc: {{shape: disc, mass: m, radius: L}}}}
connections: {{pin: {{hinge: rod.start}}, axle: {{axle: disc}}}}
states: {{s: {{disc.angular_velocity: w}}}}
find: {{x: {question}}}
"""
SCENE = (
    """title: Everything
given: {m: 2 kg, M: kg, R: 20 cm, mu: unknown, beta: unknown, u: 3 m/s, n: number}
surfaces: {ramp: {slope: beta, down: left}, hill: {slope: 25 deg}, floor: level}
bodies:
  block: {mass: 3 kg, moves: up}
  disc: {shape: disc, mass: M, radius: 30 cm, points: {P: [R, 0]}}
  drum: {inertia: 0.5 kg m^2, radii: {big: R, small: 5 cm}}
  rod: {shape: rod, mass: 0, length: 2*R}
  toy: {parts: {stick: {shape: rod, mass: m, length: R, start: [0, 0], end: [R, 0]}, bob: {mass: m, at: [R, 0]}}}
connections:
  base: {contact: [block, ramp], friction: mu}
  lane: {contact: [disc, floor], friction: 0.4}
  pin: {hinge: rod.at(R/2)}
  cord: {string: [block, drum.small, [0, R]], under: drum}
actions: {pull: {force: 12 N, on: disc.P, direction: [3, 4]}, twist: {couple: unknown, on: drum}}
states:
  start: at rest
  next: {at rest: [rod, block], disc.angular_velocity: 7 rad/s, rod.angle: -90 deg, disc.velocity: [u, 0]}
  end: {lane: rolls, rod.angle: largest, time: 3 s}
events: {hit: {collides: [block, rod.end], restitution: 0.5, from: next, to: end}}
find:
  T: cord.block.tension at start
  share: size of lane.friction_force/lane.normal_force at end
  lost: lost kinetic_energy during hit
  part: (lost kinetic_energy during hit)/(kinetic_energy at next)
  w: disc.angular_velocity at next + drum.angular_velocity
  t: time from start to end in min
  beta: largest beta where base sticks
  a: rod.at(R/2).acceleration.tangential at end
  L: disc.angular_momentum about rod.start at end
  gap: 90 deg - rod.angle at end
  twice: 2*T
answers: {T: m*g, t: 3 min, share: [1, 2], lost: {formula: m*u^2, value: 4 J, tolerance: 1 %}, w: up the slope}
marking: {T: 2}
""".replace("at next + drum.angular_velocity", "+ drum.angular_velocity at next")
    .replace("lost: lost", "loss: lost")
    .replace("lost: {", "loss: {")
)


@pytest.fixture(scope="module")
def problem() -> Problem:
    return read_text(SCENE)


def term(problem: Problem, name: str, index: int = 0) -> Term:
    return next(find for find in problem.finds if find.name == name).terms[index]


def test_numbers_in_place_become_letters(problem: Problem) -> None:
    automatic = {given.name: given.text for given in problem.givens if given.automatic}
    assert automatic == {
        "g": "9.8 m/s^2",
        "theta_hill": "25 deg",
        "m_block": "3 kg",
        "R_disc": "30 cm",
        "I_drum": "0.5 kg m^2",
        "R_drum_small": "5 cm",
        "mu_lane": "0.4",
        "F_pull": "12 N",
        "tau_twist": "unknown",
        "e_hit": "0.5",
        "omega_disc": "7 rad/s",
        "t_end": "3 s",
    }
    block, disc, *_ = problem.bodies
    assert block.mass == Symbol("m_block")
    assert disc.shape is not None and getattr(disc.shape, "radius") == Symbol("R_disc")  # noqa: B009


def test_values_are_exact_and_in_si(problem: Problem) -> None:
    givens = {given.name: given for given in problem.givens}
    assert givens["R"].value == Number(Fraction(1, 5)) and givens["R"].dimension == LENGTH
    assert givens["M"].value is None and givens["M"].dimension == MASS
    assert givens["n"].dimension == NONE
    assert problem.gravity == Symbol("g")


def test_the_dimension_of_an_unknown_comes_from_its_use(problem: Problem) -> None:
    givens = {given.name: given for given in problem.givens}
    assert givens["mu"].asked and givens["mu"].dimension == NONE
    assert givens["beta"].asked and givens["beta"].dimension == ANGLE
    other = read_text("given: {x: unknown}\nbodies: {b: {shape: disc, mass: 2*x}}\nfind: {x: x}")
    assert other.givens[0].dimension == MASS
    square = read_text("given: {x: unknown, k: kg/m^2}\nbodies: {b: {mass: k*x^2}}\nfind: {x: x}")
    assert square.givens[0].dimension == LENGTH


def test_zero_and_multiples_of_15_degrees_stay_numbers(problem: Problem) -> None:
    rod = next(body for body in problem.bodies if body.name == "rod")
    assert rod.mass == ZERO
    following = problem.states[1].conditions
    assert [condition.value for condition in following if condition.path and condition.path.quantity == "angle"] == [
        Negative(Quotient(PI, Number(Fraction(2))))
    ]


def test_conditions(problem: Problem) -> None:
    start, following, end = problem.states
    assert [(c.rest, c.owner) for c in start.conditions] == [(True, "all")]
    assert [c.owner for c in following.conditions if c.rest] == ["rod", "block"]
    components = [(c.path.component, c.value) for c in following.conditions if c.path and c.path.quantity == "velocity"]
    assert components == [("x", Symbol("u")), ("y", ZERO)]
    words = [(c.path.owner, c.path.quantity, c.word) for c in end.conditions if c.path and c.word]
    assert words == [("lane", "", "rolls"), ("rod", "angle", "largest")]
    times = [c.value for c in end.conditions if c.path and c.path.quantity == "time"]
    assert times == [Symbol("t_end")]


def test_phrases(problem: Problem) -> None:
    finds = {find.name: find for find in problem.finds}
    assert (term(problem, "T").path.point, term(problem, "T").at) == ("block", "start")
    assert finds["share"].modifier == "size of"
    assert [(t.modifier, t.at) for t in finds["share"].terms] == [("", "end"), ("", "end")]
    assert (finds["loss"].modifier, term(problem, "loss").modifier, term(problem, "loss").during) == ("", "lost", "hit")
    assert [(t.modifier, t.during, t.at) for t in finds["part"].terms] == [("lost", "hit", None), ("", None, "next")]
    assert finds["part"].formula == Symbol("#0") / Symbol("#1")
    assert [t.at for t in finds["w"].terms] == ["next", "next"]
    time = term(problem, "t")
    assert (time.path.quantity, time.start, time.end) == ("time", "start", "end")
    unit = finds["t"].unit
    assert unit is not None and unit.text == "min"
    where = finds["beta"].where
    assert where is not None and where.path is not None
    assert (finds["beta"].formula, finds["beta"].modifier, where.path.owner, where.word) == (
        Symbol("beta"),
        "largest",
        "base",
        "sticks",
    )
    path = term(problem, "a").path
    assert (path.point, path.argument, path.component) == ("at", Symbol("R") / 2, "tangential")
    about = term(problem, "L").about
    assert about is not None and (about.owner, about.point) == ("rod", "start")
    assert to_text(finds["gap"].formula).startswith("π/2 − ") or to_text(finds["gap"].formula).startswith("½ π − ")
    assert finds["twice"].formula == 2 * Symbol("T") and not finds["twice"].terms


def test_answers(problem: Problem) -> None:
    answers = {answer.name: answer for answer in problem.answers}
    assert answers["T"].formula == Symbol("m") * Symbol("g")
    assert answers["t"].value == Number(Fraction(180))
    assert answers["share"].values == (Number(Fraction(1)), Number(Fraction(2)))
    assert answers["loss"].value == Number(Fraction(4)) and answers["loss"].tolerance == Number(Fraction(1, 100))
    assert answers["w"].text == "up the slope" and answers["w"].formula is None
    assert [(item.name, item.points) for item in problem.marking] == [("T", 2), ("all", 1)]


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("2 pi rad/s", "2 π"),
        ("2*pi rad/s", "2 π"),
        ("120 rev/min", "4 π"),
        ("3/4 m", "¾"),
        ("½ m", "½"),
        ("2×10^3 N", "2000"),
        ("1e-3 kg", "0.001"),
        ("+5 m", "5"),
        ("12 %", "3/25"),
        ("5 N*m", "5"),
        ("2*R", "2 R"),
        ("2 R", "2 R"),
        ("R + 3 cm", "R + q_x"),
    ],
)
def test_forms_of_values(text: str, value: str) -> None:
    found = read_text(f"given: {{R: 2 m, x: {text}}}\nbodies: {{b: {{mass: 1 kg}}}}\nfind: {{a: b.acceleration}}")
    formula = found.givens[1].value
    assert formula is not None
    assert to_text(formula).replace("qₓ", "q_x") == value


def test_in_given_a_number_and_a_unit_is_a_quantity() -> None:
    found = read_text("given: {m: 2 kg, L: 3 m, d: m}\nbodies: {b: {mass: m}}\nfind: {a: b.acceleration}")
    assert found.givens[1].dimension == LENGTH and found.givens[2].dimension == LENGTH


def test_settings_replace_givens() -> None:
    found = read_text(
        "given: {m: 2 kg, M: 3*m}\nbodies: {b: {mass: M}}\nfind: {a: b.acceleration}", settings={"m": "5kg"}
    )
    assert found.givens[0].value == Number(Fraction(5))


@pytest.mark.parametrize("value", ["9.81", "9.81 m/s", "3 kg", "number", "kg", "2*R", "-9.81 cm"])
def test_a_given_g_that_is_no_acceleration(value: str) -> None:
    """Who means gravity by it would get another one; with `gravity:` it is told what is meant."""
    rest = "bodies: {block: {mass: 2 kg, moves: down}}\nfind: {a: block.acceleration}\n"
    with pytest.raises(SceneError) as error:
        read_text(f"given: {{R: 1 m, g: {value}}}\n{rest}")
    (fault,) = error.value.faults
    assert fault.message.startswith("`g` is gravity, an acceleration, but") and fault.span is not None
    assert read_text(f"given: {{R: 1 m, g: {value}}}\ngravity: none\n{rest}").gravity is None


def test_gravity() -> None:
    rest = "bodies: {b: {mass: 1 kg}}\nfind: {a: b.acceleration}"
    assert read_text(f"gravity: none\n{rest}").gravity is None
    assert read_text(f"given: {{g: m/s^2}}\n{rest}").gravity == Symbol("g")
    assert read_text(f"given: {{gM: m/s^2}}\ngravity: gM\n{rest}").gravity == Symbol("gM")
    assert read_text(f"given: {{g: 3 kg}}\ngravity: 9.8 m/s^2\n{rest}").gravity == Symbol("g2")
    assert read_text(f"gravity: 1.6 m/s^2\n{rest}").gravity == Symbol("g")


@pytest.mark.parametrize(
    ("asked", "unit", "said"),
    [
        ("w", "Hz", "`Hz` counts turns, and `x` is an angular velocity"),
        ("disc.angular_velocity at s", "kHz", "`kHz` counts turns, and `x` is an angular velocity"),
        ("f", "rad/s", "`rad/s` measures an angle in a unit of time, and `x` counts turns"),
        ("frequency of small swings of rod", "rad/s", "`rad/s` measures an angle in a unit of time"),
        ("2*f", "rev/min", "`rev/min` measures an angle in a unit of time"),
    ],
)
def test_turns_are_no_radians(asked: str, unit: str, said: str) -> None:
    """A number of turns in a second is not one of radians: 4 rad/s is not 4 Hz."""
    with pytest.raises(SceneError, match=said):
        read_text(TURNING.format(question=f"{asked} in {unit}"))


@pytest.mark.parametrize(
    ("asked", "unit", "number"),
    [("f", "rev/min", 240), ("f", "rev/s", 4), ("f", "Hz", 4), ("w", "rev/s", 4), ("w/(2*pi)", "1/s", 4)],
)
def test_rates_of_turns(asked: str, unit: str, number: float) -> None:
    """4 Hz are 240 turns a minute, and 8π rad/s are 4 turns a second."""
    assert solve(TURNING.format(question=f"{asked} in {unit}")).answers["x"].float == pytest.approx(number)


@pytest.mark.parametrize(
    ("alone", "within"),
    [
        ("sin(x)", "sin(rod.angle at t)"),
        ("2*cos(x)^2", "2*cos (rod.angle at t)^2"),
        ("sqrt(abs(x))/2", "sqrt(abs(rod.angle at t))/2"),
        ("sin(x) + x", "sin(rod.angle at t) + (rod.angle at t)"),
        ("L*x", "L(rod.angle at t)"),
        ("(sin(x))^2", "(sin(rod.angle at t))^2"),
    ],
)
def test_the_brackets_of_a_function_may_hold_a_phrase(alone: str, within: str) -> None:
    """The same number as with that quantity asked before."""
    scene = """title: Swung
given: {{m: 2 kg, L: 3}}
bodies: {{rod: {{shape: rod, mass: m, length: 150 cm}}}}
connections: {{pin: {{hinge: rod.start}}}}
states: {{s: {{rod.angle: 10 deg, at rest: all}}, t: {{rod.angle: -50 deg}}}}
find: {{x: rod.angle at t, y: "{0}"}}
"""
    first, second = (solve(scene.format(text)).answers["y"].float for text in (alone, within))
    assert first is not None and first == pytest.approx(second)


@pytest.mark.parametrize(
    ("force", "letter"), [("12 N", "F_pull"), ("3*m*9.8 m/s^2", "a_pull"), ("m*R*(3 rad/s)^2", "omega_pull")]
)
def test_a_number_within_an_expression_has_the_letter_of_its_own_kind(force: str, letter: str) -> None:
    scene = f"""given: {{m: 2 kg, R: 30 cm}}
bodies: {{wheel: {{shape: disc, mass: m, radius: R}}}}
connections: {{ax: {{axle: wheel}}}}
actions: {{pull: {{force: {force}, on: wheel.top, direction: right}}}}
find: {{a: wheel.angular_acceleration}}
"""
    formula = solve(scene).answers["a"].formula
    assert formula is not None
    assert [name for name in formula.symbols() if name.endswith("_pull")] == [letter]
