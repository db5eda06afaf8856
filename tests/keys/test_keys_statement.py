"""Statements: what students read, made of the text, the givens and what is asked."""

from __future__ import annotations

import pytest

from rotsolve.keys.statement import Statement, paragraphs, phrase_in_words, statement
from rotsolve.keys.variants import worked_variants
from rotsolve.page.formats import format_named
from rotsolve.page.text import plain_text
from rotsolve.scene.read import read_text

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
    assert [plain_text(item) for item in told(text).text] == [seen]


def test_letters_are_set_as_such_and_units_are_not() -> None:
    html = format_named("html").printer
    assert [*map(html.words, told("'m falls 3 m'").text)] == ["<math><mi>m</mi></math> falls 3 m"]
    assert html.words(told("'{value of m} <b>'").text[0]).endswith("</math> &lt;b&gt;")


def test_givens_that_the_text_does_not_name_are_listed() -> None:
    said = [plain_text(item) for item in told("'{m}, {M}, {d} and {waste}'").givens]
    assert said == ["R = 20 cm", "θ₀ = 30°", "k", "g = 9.8 m/s²"]


def test_what_is_asked_is_told_in_words() -> None:
    assert [*map(plain_text, told("x").finds)] == ["a (acceleration of block)", "ω₁ (angular acceleration of disc)"]


@pytest.mark.parametrize(
    ("phrase", "said"),
    [
        ("rod.end.speed at lowest", "speed of rod end at lowest"),
        ("pivot.force.x", "x component of force of pivot"),
        ("rod.torque.gravity at start", "gravity torque of rod at start"),
        ("rod.at(L/3).acceleration.tangential", "tangential acceleration of rod at L/3"),
        (
            "(lost kinetic_energy during hit)/(kinetic_energy at before)",
            "(lost kinetic energy during hit)/(kinetic energy at before)",
        ),
        ("body.inertia_tensor.xx about body.cm", "xx component of inertia tensor of body about cm of body"),
        ("cable.tension/rope.tension", "tension of cable/tension of rope"),
        ("time from A to B", "time from A to B"),
        ("2.5*m", "2.5*m"),
    ],
)
def test_phrases(phrase: str, said: str) -> None:
    assert phrase_in_words(phrase) == said


def test_choices_list_their_options() -> None:
    scene = SCENE.format(text="x").replace(
        "omega1: disc.angular_acceleration}",
        "w: {which of: {one: block.acceleration, other: g/2}, is: largest}, s: {which of: {slow: a < g/2, fast: a > g/2}}}",
    )
    ((_, worked),) = worked_variants(read_text(scene), 1, 1)
    assert [*map(plain_text, statement(worked).finds[1:])] == [
        "w (which is largest: one: acceleration of block; other: g/2)",
        "s (which holds: slow: a < g/2; fast: a > g/2)",
    ]


def test_paragraphs() -> None:
    assert paragraphs("one two\nthree\n") == ["one two", "three"]
    assert paragraphs("one\ntwo\n\nthree") == ["one two", "three"]
    assert paragraphs("  ") == []
