"""Two hand-written derivations for the tests of printing: one instant with two bodies, and two instants with two laws."""

from __future__ import annotations

from dataclasses import dataclass
from types import SimpleNamespace
from typing import Any, ClassVar

import pytest
from msgspec.structs import replace

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.notation.parse import parse
from rotsolve.algebra.units.quantities import parse_quantity, parse_unit
from rotsolve.core.derivation import Answer, Check, Derivation, Equality, ForceLine, LawLine, Move, Section, Words
from rotsolve.language.problem import Given
from rotsolve.page.values import machine_number


@dataclass(frozen=True)
class Digits:
    """A certified number as far as printing knows one."""

    digits: str

    @property
    def float(self) -> float:
        return float(machine_number(self.digits))

    def figures(self, digits: int) -> tuple[str, int]:
        return self.digits, digits


@dataclass(frozen=True)
class Fuzzy:
    """A number of which only so many digits are settled."""

    certain: int

    sign: int | None = 1
    float: ClassVar[float] = 1.23456789

    def figures(self, digits: int) -> tuple[str, int]:
        sure = min(digits, self.certain)
        return "1.23456789"[: (sure or 3) + 1], sure


def words(*parts: str) -> Words:
    """Prose and, between dollar signs, formulas: `weight $m g$, down`."""
    result: list[str | Formula] = []
    for part in parts:
        pieces = part.split("$")
        result += [parse(piece) if number % 2 else piece for number, piece in enumerate(pieces) if piece]
    return tuple(result)


def equal(text: str) -> Equality:
    for relation in (" < ", " > ", " ≤ ", " = "):
        if relation in text:
            left, right = text.split(relation)
            return Equality(parse(left), parse(right), relation.strip())
    raise ValueError(text)


def given(name: str, value: str, unit: str = "", **more: Any) -> Given:
    text = f"{value} {unit}".strip()
    quantity = parse_quantity(text)
    return Given(name, quantity.value, quantity.dimension, quantity.unit, text, **more)


def answer(name: str, formula: str | None, digits: str | None, unit: str, direction: str = "", **more: Any) -> Answer:
    return Answer(
        name,
        Symbol(name),
        None if formula is None else parse(formula),
        None if digits is None else Digits(digits),  # type: ignore[arg-type]
        parse_unit(unit),
        None,
        direction,
        **more,
    )


def move(sources: str, *chain: str, number: int | None = None, reason: Words = ()) -> Move:
    return Move(sources, tuple(map(equal, chain)), number, reason)


@pytest.fixture
def block_on_disc() -> Derivation:
    section = Section(
        "",
        forces=(
            ForceLine("block", (words("weight $m g$, down"), words("tension $T$, up")), "down"),
            ForceLine(
                "disc",
                (words("tension $T$ at the rim, turning it clockwise"),),
                "clockwise",
                (words("weight and axle force act at the axle: no torque about it"),),
            ),
        ),
        laws=(
            LawLine(1, "Newton's second law, block", equal("m g - T = m a")),
            LawLine(2, "Newton's law for rotation, disc", equal("T R = I alpha")),
            LawLine(3, "moment of inertia, solid disc", equal("I = ½ M R²")),
            LawLine(4, "the string does not slip", equal("a = R alpha")),
        ),
        moves=(
            move("(3) and (4) in (2)", "T R = ½ M R² · (a/R)", "T = ½ M a", number=5),
            move("(5) in (1)", "m g - ½ M a = m a", "a = 2 m g/(2 m + M)"),
            move("a in (4)", "alpha = a/R", "alpha = 2 m g/(R (2 m + M))"),
            move("a in (5)", "T = ½ M a", "T = m M g/(2 m + M)"),
        ),
    )
    return Derivation(
        "Block hanging from a string wound on a solid disc",
        "",
        (given("m", "2", "kg"), given("M", "5", "kg"), given("R", "0.2", "m"), given("g", "9.8", "m/s²")),
        (words("$a$"), words("$alpha$"), words("$T$")),
        (),
        (),
        (section,),
        (
            answer("a", "2 m g/(2 m + M)", "4.356", "m/s²", "down"),
            answer("alpha", "2 m g/(R (2 m + M))", "21.78", "rad/s²", "clockwise"),
            answer("T", "m M g/(2 m + M)", "10.89", "N"),
        ),
        (
            Check(words("energy conservation gives the same $a$")),
            Check(words("dimensions agree")),
            Check(words("$M$ → 0 gives $a$ = $g$")),
            Check(words("$T$ > 0: the string stays taut")),
        ),
        equations_written=9,
        equations_used=4,
    )


@pytest.fixture
def rod_released() -> Derivation:
    start = Section(
        "At release",
        forces=(
            ForceLine(
                "rod",
                (
                    words("weight $M g$, down, at the centre, $L/2$ from the pivot"),
                    words("pivot force at the pivot (no torque about it)"),
                ),
            ),
        ),
        laws=(
            LawLine(1, "Newton's law for rotation about the pivot", equal("-M g · (L/2) cos(theta0) = I alpha")),
            LawLine(
                2,
                "moment of inertia, rod about its end",
                equal("I = ⅓ M L²"),
                words("parallel axes: $1/12 M L² + M (L/2)²$"),
            ),
            LawLine(3, "acceleration of the end", equal("a_end = L abs(alpha)"), words("at rest: no centripetal part")),
        ),
        moves=(
            move("(2) in (1)", "alpha = -3 g cos(theta0)/(2 L)"),
            move("in (3)", "a_end = 3 g cos(theta0)/2"),
        ),
    )
    fall = Section(
        "From release to the lowest position",
        remarks=(
            words("Energy is conserved: the pivot does no work (its point is at rest), gravity has a potential."),
        ),
        laws=(LawLine(4, "K₁ + U₁ = K₂ + U₂", equal("0 + M g (L/2) sin(theta0) = ½ I omega² - M g L/2")),),
        moves=(
            move("(2) in (4)", "omega² = 3 g (1 + sin(theta0))/L"),
            move(
                "",
                "omega = -sqrt(3 g (1 + sin(theta0))/L)",
                reason=words("the rod turns clockwise: $omega$ < 0"),
            ),
        ),
    )
    return Derivation(
        "Rod released from an angle",
        "",
        (given("M", "0.75", "kg"), given("L", "1", "m"), given("theta0", "30", "°"), given("g", "9.8", "m/s²")),
        (words("$alpha$ and $a_end$ at release"), words("$omega$ at the lowest position")),
        (words("released: $theta$ = $theta0$, $omega$ = 0"), words("lowest: $theta$ = −90°")),
        (words("angles from the horizontal, counterclockwise positive"),),
        (start, fall),
        (
            answer("alpha", "-3 g cos(theta0)/(2 L)", "−12.73", "rad/s²", "clockwise"),
            answer("a_end", "3 g cos(theta0)/2", "12.73", "m/s²", "down and to the right, across the rod"),
            answer("omega", "-sqrt(3 g (1 + sin(theta0))/L)", "−6.641", "rad/s", "clockwise"),
        ),
        (
            Check(words("∫ Newton's law dθ gives the same $omega$")),
            Check(words("dimensions agree")),
            Check(words("$theta0$ = −90°: $alpha$ = 0, $omega$ = 0")),
        ),
    )


@pytest.fixture
def made() -> SimpleNamespace:
    """The means to make single answers and givens."""
    return SimpleNamespace(answer=answer, given=given, Fuzzy=Fuzzy)


@pytest.fixture
def crowded(block_on_disc: Derivation) -> Derivation:
    """A derivation in which everything is too long."""
    long = (
        "m1 g sin(beta) - mu m1 g cos(beta) - T1 + k x + (I/R^2 + m1 + m2 + m3) a0"
        " = (m1 + m2 + m3 + I/R^2 + J/r^2) a + (m1 R^2 + m2 R^2 + I + J) alpha/R"
    )
    remark = words("a remark that tells at length how this was found, and $why$ it holds in this very case")
    section = block_on_disc.sections[0]
    section = replace(
        section,
        laws=(
            *section.laws,
            LawLine(6, "Newton's second law along the slope", equal(long), remark),
            LawLine(7, "the law of the long names, applied to the second pulley from the left", equal("a = b")),
        ),
        moves=(
            *section.moves,
            move("(6) in (7)", long, "a = (m1 g sin(beta) - mu m1 g cos(beta) - T1)/(m1 + m2)", "a = g/3", number=8),
            move("(8)", "a = g/3", reason=words("the other root, $a$ < 0, would mean that the block goes up")),
        ),
    )
    parts = (answer("F_x", "m g", "3.1", "N"), answer("F_y", "M g", None, "N"))
    return replace(
        block_on_disc,
        source="A book of problems, third edition, chapter 11, problem 45",
        conventions=(words("angles from the horizontal, counterclockwise positive"),),
        states=(words("released: $theta$ = $theta0$, $omega$ = 0"), words("lowest: $theta$ = −90°")),
        sections=(section, replace(section, title="From release to the lowest position", remarks=(remark,))),
        answers=(
            *block_on_disc.answers,
            answer("F", "sqrt(m^2 + M^2) g", "12.3", "N", "up and to the left, across the rod", components=parts),
            answer("w", None, None, "", word="slips"),
        ),
        checks=(
            *block_on_disc.checks,
            Check(words("$T$ < 0: the string would push"), False),
            Check(words("energy could not be used"), None),
        ),
    )
