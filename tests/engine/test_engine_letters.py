"""A letter with a value is that value: the same numbers and words whichever of both stands in a scene, and for many values at once.

Where a sign decides how a scene is meant (which side of a wheel a pull leaves, which way a string runs), it is that of the scene's
own numbers; where nothing tells it, the scene is refused by the name of the letter that lacks a value.
"""

from __future__ import annotations

import math
import re
from decimal import Decimal
from pathlib import Path

import pytest

from rotsolve import Solution, Unsolvable, solve
from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.formula import Symbol, call
from rotsolve.algebra.notation.parse import parse
from rotsolve.arrays import NotForMany
from rotsolve.core.derivation import Answer
from rotsolve.keys.working import VariantSolver
from rotsolve.scene.read import read_text

ROOT = Path(__file__).resolve().parents[2]
FILES = sorted((ROOT / "problems").rglob("*.yaml")) + sorted((ROOT / "tests" / "engine" / "scenes").glob("*.yaml"))
LITERAL = re.compile(r"(?<![\w.*/^+-])(?<![*/^+-] )(-?\d+(?:\.\d+)?) (deg|rad|mm|cm|m|km)\b(?!\s*[\^/*\w])")
GIVEN = re.compile(r"(\w+): *(-?\d+(?:\.\d+)? (?:deg|rad|mm|cm|m|km))(?=\s*[,}\n#])")
ASIDE = ("answers", "marking", "vary", "text", "source", "title")  # what does not tell what a scene is
TOLD_BY_NUMBERS = {
    "cone-that-tips"
}  # half a turn written as a letter leaves its equation too long: refused by that name
ONE_LETTER = {  # where a length has to be one letter, however often it stands there
    "plank-on-trestles",
    "rod-swings-fastest",
    "cut-beam-in-balance",
    "cut-rod-with-loads",
}

WHEEL = """\
given: {{M: 2 kg, R: 20 cm, F: 3 N{given}}}
bodies: {{wheel: {{shape: disc, mass: M, radius: R}}}}
connections: {{axle: {{axle: wheel}}}}
actions: {{pull: {{force: F, on: wheel.rim, direction: {value}, {side}: true}}}}
find: {{alpha: wheel.angular_acceleration}}
"""
SPOOL = """\
given: {{M: 2 kg, I: 0.05 kg m^2, r: 10 cm, R: 20 cm, F: 3 N{given}}}
surfaces: {{floor: level}}
bodies: {{spool: {{mass: M, inertia: I, radii: {{core: r, rims: R}}, moves: right}}}}
connections: {{touch: {{rolls: [spool.rims, floor]}}}}
actions: {{pull: {{force: F, on: spool.core, direction: {value}, {side}: true}}}}
find: {{a: spool.acceleration, f: touch.friction_force, N: touch.normal_force}}
"""
ROD = """\
given: {{M: 2 kg, L: 80 cm, F: 3 N{given}}}
bodies: {{rod: {{shape: rod, mass: M, length: L}}}}
connections: {{pin: {{hinge: rod.start}}}}
actions: {{push: {{force: F, on: {side}, direction: {value}}}}}
states: {{start: {{rod.angle: 40 deg, at rest: all}}}}
find: {{alpha: rod.angular_acceleration at start, P: pin.force at start}}
"""
TURNED = """\
given: {{M: 2 kg, L: 80 cm, F: 3 N{given}}}
bodies: {{rod: {{shape: rod, mass: M, length: L}}}}
connections: {{pin: {{hinge: rod.start}}}}
actions: {{push: {{force: F, on: rod.end, direction: {side}}}}}
states: {{start: {{rod.angle: {value}, at rest: all}}}}
find: {{alpha: rod.angular_acceleration at start, P: pin.force at start}}
"""
SPRING = """\
given: {{M: 2 kg, L: 80 cm, k: 40 N/m, l: 50 cm{given}}}
bodies: {{rod: {{shape: rod, mass: M, length: L}}}}
connections:
  pin: {{hinge: rod.start}}
  coil: {{spring: {side}, stiffness: k, rest_length: l}}
states: {{start: {{rod.angle: {value}, at rest: all}}}}
find: {{alpha: rod.angular_acceleration at start, S: coil.force at start}}
"""
CABLE = """\
given: {{M: 20 kg, L: 2 m{given}}}
bodies: {{boom: {{shape: rod, mass: M, length: L}}}}
connections:
  pin: {{hinge: boom.start}}
  stay: {{string: {side}}}
states: {{now: {{boom.angle: {value}, balance: true}}}}
find: {{T: stay.tension}}
"""
SLOPE = """\
given: {{m: 2 kg, n: 1 kg, M: 1 kg, R: 10 cm{given}}}
surfaces: {{ramp: {{slope: {value}, down: {side}}}}}
bodies: {{block: {{mass: m}}, load: {{mass: n}}, wheel: {{shape: disc, mass: M, radius: R}}}}
connections:
  glide: {{contact: [block, ramp], friction: none}}
  axle: {{axle: wheel}}
  cord: {{string: [block, wheel, load]}}
find: {{a: block.acceleration, T: cord.block.tension, alpha: wheel.angular_acceleration}}
"""
COIL = """\
given: {{m: 2 kg, k: 40 N/m, s: 20 cm{given}}}
surfaces: {{ramp: {{slope: {value}, down: {side}}}}}
bodies: {{block: {{mass: m}}}}
connections:
  glide: {{contact: [block, ramp], friction: none}}
  coil: {{spring: [ground, block], stiffness: k}}
states: {{now: {{coil.elongation: s, at rest: all}}}}
find: {{a: block.acceleration, F: coil.force}}
"""
ROUND = (20, 75, 90, 100, 120, 200, 270, 290, 350)
ASLANT = tuple(angle for angle in ROUND if angle % 180 != 90)  # straight up or down it leaves a wheel at its side
STEEP = (0, 10, 30, 65)
OWN = [  # a scene, what else it is made with, and angles for it
    *((WHEEL, side, ASLANT) for side in ("over", "under")),
    *((SPOOL, side, (20, 75, 120, 170)) for side in ("over", "under")),
    *((ROD, point, ROUND) for point in ("rod.end", "rod.at(L/4)")),
    *((TURNED, way, ROUND) for way in ("right", "tangential", "[1, -2]")),
    *((SPRING, ends, (20, 75, 120, 200, 290)) for ends in ("[rod.end, [0, 1.5 m]]", "[[1 m, -1 m], rod.center]")),
    *((CABLE, ends, (20, 75, 120)) for ends in ("[boom.end, [0, 3 m]]", "[[0, 2.5 m], boom.end]")),
    *((SLOPE, side, STEEP) for side in ("left", "right")),
    *((COIL, side, STEEP) for side in ("left", "right")),
]


def numbers_of(solution: Solution) -> dict[str, list[object]]:
    """By answer: its numbers, its words and its direction."""
    return {answer.name: list(told_by(answer)) for answer in solution.derivation.answers}


def told_by(answer: Answer) -> list[object]:
    found: list[object] = [None if answer.value is None else answer.value.float, answer.direction, answer.word]
    found.append(None if answer.angle is None else answer.angle.float)
    return found + [item for part in answer.components for item in told_by(part)]


def alike(one: dict[str, list[object]], other: dict[str, list[object]]) -> bool:
    """Whether all numbers agree to nine figures, and all words."""
    return one.keys() == other.keys() and all(
        len(one[name]) == len(other[name]) and all(map(near, one[name], other[name])) for name in one
    )


def near(one: object, other: object) -> bool:
    if isinstance(one, float) and isinstance(other, float):
        return math.isclose(one, other, rel_tol=1e-9, abs_tol=1e-12)
    return one == other


def sections(text: str) -> list[tuple[str, str]]:
    """The entries of a scene with their names, those that do not tell what it is left out."""
    starts = [match.start() for match in re.finditer(r"^[a-z][a-z ]*:", text, re.MULTILINE)]
    parts = [text[start:end] for start, end in zip(starts, [*starts[1:], len(text)], strict=True)]
    named = [(part.partition(":")[0], part.rstrip() + "\n") for part in parts]
    return [(name, part) for name, part in named if name not in ASIDE]


def with_letters(parts: list[tuple[str, str]]) -> str:
    """The scene with a letter for each literal; empty where there is none."""
    entries: list[str] = []

    def letter(match: re.Match[str]) -> str:
        entries.append(f"qq{len(entries)}: {match[0]}")
        return f"qq{len(entries) - 1}"

    made = [(name, part if name in ("given", "unknown") else LITERAL.sub(letter, part)) for name, part in parts]
    if not entries:
        return ""
    own = next((part for name, part in made if name == "given"), "")
    block = re.match(r"given: *(?:#.*)?\n( +)", own)
    if block:
        given = own + "".join(f"{block[1]}{entry}\n" for entry in entries)
    else:
        given = own.replace("{", "{" + ", ".join(entries) + ", ", 1) or "given: {" + ", ".join(entries) + "}\n"
    return given + "".join(part for name, part in made if name != "given")


def with_literals(parts: list[tuple[str, str]]) -> str:
    """The scene with the values of all given angles and lengths in place of their letters; empty where there is none."""
    told = (found for key, part in parts if key == "given" for found in GIVEN.findall(part))
    values = {name: value for name, value in told if name not in ("x", "y", "z")}  # which are directions, too
    if not values:
        return ""
    made = []
    for key, part in parts:
        if key == "given":
            gone = GIVEN.sub(lambda found: "\0" if found[1] in values else found[0], part)
            part = re.sub(r"\0 *, *|, *\0|\n *\0[^\n]*|\0", "", gone)
            part = "" if re.fullmatch(r"given: *(\{\s*\})?\s*", part) else part
        elif key != "unknown":
            head, _, body = part.partition(":")
            for name, value in values.items():
                body = re.sub(rf"(?<![\w.]){name}(?![\w.]*\s*:)(?!\w)", f"({in_cm(value)})", body)
            part = f"{head}:{body}"
        made.append(part)
    return "".join(made)


def in_cm(value: str) -> str:
    """A length in a unit that is no letter of a scene."""
    number, unit = value.split()
    return f"{(Decimal(number) * 100).normalize():f} cm" if unit == "m" else value


@pytest.mark.sampled(4)
@pytest.mark.parametrize("part", range(8))
def test_a_letter_with_a_value_is_that_value_in_all_scenes(part: int) -> None:
    for file in FILES[part::8]:
        parts = sections(file.read_text(encoding="utf-8"))
        lettered = "" if file.stem in TOLD_BY_NUMBERS else with_letters(parts)
        literal = "" if file.stem in ONE_LETTER else with_literals(parts)
        if lettered or literal:
            own = "".join(part for _, part in parts)
            found = [numbers_of(solve(text, confirm=False)) for text in (lettered or own, literal or own)]
            assert alike(*found), f"{file.stem}:\n{lettered}{literal}"


@pytest.mark.exhaustive
def test_many_values_are_those_of_solving_again_or_marked() -> None:
    """Each given angle of every fourth scene in the next quadrant: what evaluating says is what solving says, or nothing."""
    for file in FILES[::4]:
        text = "".join(part for _, part in sections(file.read_text(encoding="utf-8")))
        for name, number in re.findall(r"(\w+): *(\d+(?:\.\d+)?) deg(?=\s*[,}\n#])", text.partition("bodies:")[0]):
            other = 180 - Decimal(number)
            try:
                many = solve(text, confirm=False).evaluate_many({name: math.radians(other)})
            except NotForMany:
                continue
            told = {key: float(value) for key, value in many.items() if "." not in key and not math.isnan(value)}
            again = numbers_of(solve(text, settings={name: f"{other} deg"}, confirm=False)) if told else {}
            assert all(near(value, again[key][0]) for key, value in told.items()), (file.stem, told, again)


@pytest.mark.parametrize(("template", "side", "angles"), OWN)
def test_a_letter_is_its_value_in_all_quadrants(template: str, side: str, angles: tuple[int, ...]) -> None:
    lettered = {
        angle: solve(template.format(side=side, value="theta", given=f", theta: {angle} deg"), confirm=False)
        for angle in angles
    }
    for angle, solution in lettered.items():
        literal = solve(template.format(side=side, value=f"{angle} deg", given=""), confirm=False)
        assert alike(numbers_of(solution), numbers_of(literal)), angle
    first = lettered[angles[1]]
    try:
        many = first.evaluate_many({"theta": [math.radians(angle) for angle in angles]})
    except NotForMany:
        return
    assert not any(math.isnan(found[1]) for found in many.values())
    for index, angle in enumerate(angles):
        for name, (number, *_) in numbers_of(lettered[angle]).items():
            if not math.isnan(many[name][index]) and angle % 90:  # a right angle is no number of computers
                found = float(many[name][index])  # of friction in the sense that it has at the first angle
                assert near(found, number) or (name == "f" and near(-found, number)), (angle, name)


@pytest.mark.parametrize(("template", "side"), [(WHEEL, "under"), (SPOOL, "over"), (SPRING, "[rod.end, [0, 1.5 m]]")])
def test_variants_know_which_side_their_numbers_mean(template: str, side: str) -> None:
    """What is evaluated for other numbers is what a new solution says, in each quadrant."""
    working = VariantSolver(read_text(template.format(side=side, value="theta", given=", theta: 20 deg")))
    for angle in (30, 75, 110, 120, 165):
        worked = working.work({"theta": f"{angle} deg"})
        found = {answer.name: told_by(answer) for answer in worked.answers}
        literal = solve(template.format(side=side, value=f"{angle} deg", given=""))
        assert alike(found, numbers_of(literal)), angle


@pytest.mark.parametrize("side", ["over", "under"])
def test_a_side_that_a_letter_decides_is_that_of_the_angles_that_the_page_prints(side: str) -> None:
    """Whether a pull leaves the wheel on its upper or lower side hangs on the sign of cos θ: a pure letter is acute, and told to be."""
    solution = solve(WHEEL.format(side=side, value="theta", given=", theta: rad"))
    literal = solve(WHEEL.format(side=side, value="50 deg", given=""))
    assert solution.answers["alpha"].float == literal.answers["alpha"].float
    assert "0 < θ < 90°" in solution.to("text")


@pytest.mark.parametrize(("acceleration", "angle"), [("0", 60), ("0.2 m/s^2", 44.22), ("-0.7 m/s^2", None)])
def test_a_side_that_an_answer_tells_is_held_against_it(acceleration: str, angle: float | None) -> None:
    """An unknown angle is taken to be acute; where the answer is another one, the question is refused."""
    text = SPOOL.format(side="under", value="theta", given="").replace("find: {", "find: {theta: theta in deg, ")
    text += f"unknown: [theta]\nstates: {{now: {{spool.velocity: 0, spool.acceleration: {acceleration}}}}}\n"
    text = text.replace("a: spool.acceleration, ", "")
    if angle is None:
        with pytest.raises(Unsolvable, match="can not be told"):
            solve(text)
    else:
        assert solve(text).answers["theta"].float == pytest.approx(angle, rel=1e-3)


BOWLED = """\
given: {{M: kg, R: m, v: m/s, w: rad/s, mu: number}}
surfaces: {{floor: level}}
bodies: {{ball: {{shape: sphere, mass: M, radius: R, moves: right}}}}
connections: {{touch: {{contact: [ball, floor], friction: mu}}}}
states: {{start: {{ball.velocity: v, ball.angular_velocity: {turn}}}}}
find: {{a: ball.acceleration at start}}
"""


def test_the_way_in_which_a_body_slips_is_never_guessed() -> None:
    """Letters stand for positive sizes: v + R ω says that it slips forward, v − R ω leaves both ways, and rolling between them."""
    one = solve(BOWLED.format(turn="-w")).answers["a"]
    assert (one.exact, one.conditions, one.otherwise) == ("−μ g", (), ())
    forward, *back = solve(BOWLED.format(turn="w")).answers["a"].branches
    assert (forward.exact, forward.conditions) == ("−μ g", ("v > R w",))
    assert [(case.exact, case.conditions) for case in back] == [("μ g", ("v < R w",)), ("0", ("v = R w",))]


def test_letters_without_a_value_are_positive_beside_numbers_of_any_sign() -> None:
    """−2 ω cos 2θ has the sign of its coefficient, whatever size ω has; ω − cos 2θ has none."""
    omega, theta = Symbol("omega"), Symbol("theta")
    oracle = SignOracle({"theta": parse("-47*pi/9000")})
    assert oracle.of_sizes(-2 * omega * call("cos", 2 * theta)) == -1
    assert oracle.of_sizes(omega**2 / call("sin", theta)) == -1
    assert oracle.of_sizes(omega - call("cos", 2 * theta)) is None


OUT = """
title: A rod that stands out from a turning shaft
given: {{M: 2 kg, L: 6 m, omega: unknown}}
bodies: {{rod: {{shape: rod, mass: M, length: L}}}}
connections: {{pin: {{shaft: rod.start, turning: omega}}}}
states: {{out: {{rod.angle: {angle} deg, steady: true}}}}
find: {{omega: largest omega where out is stable}}
"""


@pytest.mark.parametrize("angle", [-0.94, -30, -44])
def test_what_is_steady_with_one_value_alone_has_no_limit_of_stability(angle: float) -> None:
    """A rod stands out from a shaft that turns with ω² = 3 g/(2 L sin |θ|) and no other."""
    with pytest.raises(Unsolvable, match="out is no equilibrium, or with some values of `omega` alone"):
        solve(OUT.format(angle=angle))


def test_a_letter_within_a_function_makes_no_polynomial() -> None:
    """β + arcsin(sin β + g (1 − sin β)/g) is straight in β, and yet has no slope that could be written."""
    from rotsolve.algebra.formula import ONE, Symbol, call
    from rotsolve.search.lettersigns import coefficients

    beta, g = Symbol("beta"), Symbol("g")
    sine = call("sin", beta)
    assert coefficients(beta + call("asin", sine + g * (ONE - sine) / g), "beta") == []
    assert len(coefficients(beta**2 - 3 * beta + 1, "beta")) == 3
