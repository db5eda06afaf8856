"""Statements: what students read, made of the text, the givens and what is asked."""

from __future__ import annotations

import pytest

from rotsolve.keys.statement import Statement, statement
from rotsolve.keys.variants import worked_variants
from rotsolve.page.blocks import Paragraph
from rotsolve.page.formats import format_named
from rotsolve.page.text import plain_text
from rotsolve.scene.read import read_text
from rotsolve.scene.statement import paragraphs

SCENE = """\
title: T
text: {text}
given: {{m: 2 kg, M: 5.0 kg, R: 20 cm, d: 2*R, theta0: 30 deg, k: kg, waste: 3 m}}
bodies: {{block: {{mass: m, moves: down}}, disc: {{shape: disc, mass: M, radius: R, turns: clockwise}}}}
connections: {{axle: {{axle: disc}}, string: {{string: [disc, block]}}}}
find: {{a: block.acceleration, omega1: disc.angular_acceleration}}
"""


def told(text: str) -> Statement:
    ((_, worked),) = worked_variants(read_text(SCENE.format(text=text)), 1, 1)
    return statement(worked)


def phrases(said: Statement) -> list[tuple[object, ...]]:
    """The paragraphs of a text."""
    return [block.words for block in said.text if isinstance(block, Paragraph)]


@pytest.mark.parametrize(
    ("text", "seen"),
    [
        ("'A block {m}, {value of m}.'", "A block m = 2 kg, 2 kg."),
        ("'{M} is {value of M}'", "M = 5.0 kg is 5.0 kg"),
        ("'at {theta0}'", "at θ₀ = 30°"),
        ("'{d} and {value of d}'", "d = 2 R and 2 R"),
        ("'{k}, {value of k}'", "k, k"),
        ("'{{m}} and {  value   of m }'", "{m} and 2 kg"),
        ("masses m and M at theta0", "masses m and M at θ₀"),
        ("'it falls 3 m in 4 s, at 2 m/s'", "it falls 3 m in 4 s, at 2 m/s"),
        ("'omega1, is a fast turn: a mm, m2'", "ω₁, is a fast turn: a mm, m2"),
        ("waste of d", "waste of d"),
    ],
)
def test_texts(text: str, seen: str) -> None:
    assert [*map(plain_text, phrases(told(text)))] == [seen]


def test_letters_are_set_as_such_and_units_are_not() -> None:
    html = format_named("html").printer
    assert [*map(html.words, phrases(told("'m falls 3 m'")))] == ["<math><mi>m</mi></math> falls 3 m"]
    assert html.words(phrases(told("'{value of m} <b>'"))[0]).endswith("</math> &lt;b&gt;")


def test_givens_that_the_text_does_not_name_are_listed() -> None:
    said = [plain_text(item) for item in told("'{m}, {M}, {d} and {waste}'").givens]
    assert said == ["R = 20 cm", "θ₀ = 30°", "k", "g = 9.8 m/s²"]


def test_what_is_asked_is_told_in_words() -> None:
    said = [plain_text(part.words) for part in told("x").parts]
    assert said == ["a, the acceleration of the block", "ω₁, the angular acceleration of the disc"]


def test_choices_list_their_options() -> None:
    scene = SCENE.format(text="x").replace(
        "omega1: disc.angular_acceleration}",
        "w: {which of: {one: block.acceleration, other: g/2}, is: largest}, s: {which of: {slow: a < g/2, fast: a > g/2}}}",
    )
    ((_, worked),) = worked_variants(read_text(scene), 1, 1)
    assert [plain_text(part.words) for part in statement(worked).parts[1:]] == [
        "w, which is largest: (one) the acceleration of the block; (other) g/2",
        "s, which holds: (slow) a < g/2; (fast) a > g/2",
    ]


def test_paragraphs() -> None:
    assert paragraphs("one two\nthree\n") == ["one two", "three"]
    assert paragraphs("one\ntwo\n\nthree") == ["one two", "three"]
    assert paragraphs("  ") == []
