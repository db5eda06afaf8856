"""What sheets ask, in words: of every bundled problem, without a word of the scene language, in English and German."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import pytest

from pages import ROOT
from rotsolve.algebra.formula import Symbol
from rotsolve.keys.asked import asked_in_words
from rotsolve.keys.names import names_told
from rotsolve.language.problem import Problem
from rotsolve.page.blocks import Math, Phrase, Styled
from rotsolve.page.languages import language_named
from rotsolve.page.languages.language import Translation
from rotsolve.page.languages.pages import Translator
from rotsolve.page.text import plain_text
from rotsolve.scene.read import read_file, read_text

FILES = sorted((ROOT / "problems").rglob("*.yaml"))
LANGUAGE = re.compile(
    r"\w\.\w"  # rod.end.speed
    r"|\b[a-z]+_[a-z]"  # kinetic_energy, let_go
    r"|\bwhere\b(?! )|#\d|[{}\[\]]"
    r"|\b(?:sticks|which of|any time|in deg|small swings of|during)\b"
)
WORDS = ("the ", "a ", "an ", "which ")


@cache
def problem_in(file: Path) -> Problem:
    return read_file(file)


def prose_of(phrase: Phrase) -> str:
    """The words of a phrase without its formulas, whose letters may have words below them."""
    return "".join(part if isinstance(part, str) else part.text if isinstance(part, Styled) else "·" for part in phrase)


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_no_problem_speaks_the_language(file: Path) -> None:
    problem = problem_in(file)
    for name, phrase in asked_in_words(problem).items():
        said = prose_of(phrase)
        assert not LANGUAGE.search(said), (name, plain_text(phrase))
        first = phrase[0]
        letter = first if isinstance(first, Symbol) else first.parts[0] if isinstance(first, Math) else None
        assert letter == Symbol(name), plain_text(phrase)
        if not isinstance(first, Math):
            assert said == "·" or said.removeprefix("·, ").startswith(WORDS), plain_text(phrase)
        for path in (term.path for find in problem.finds if find.group == name for term in find.terms):
            assert path.owner == "" or "." + path.quantity not in said


def test_some_problems_are_told_as_a_teacher_would() -> None:
    told = {
        "hinged/ladder-over-the-edge-of-a-wall": "μ, the smallest coefficient of friction between the ladder and the floor "
        "for which the ladder does not slip on the floor",
        "rolling/spool-largest-pull": "F, the largest force of the pull for which the spool does not slip on the floor",
        "pulleys/three-pulleys": "a, the acceleration of block 2",
        "rolling/race": "d = s − x, where x is the displacement of the ring from start to finish",
        "swings/upright-rod-on-torsion-spring": "κ, the smallest stiffness of the spiral for which the motion is stable when upright",
        "space/skew-rod": "gap, the angle between the angular momentum of the rod and the angular velocity of the rod, in °",
    }
    for name, words in told.items():
        file = ROOT / "problems" / f"{name}.yaml"
        assert words in [plain_text(phrase) for phrase in asked_in_words(problem_in(file)).values()], name


NAMES = """\
title: Names
given: {m: 2 kg, M: 4 kg, R: 0.2 m, mu: 0.4}
surfaces: {left_slope: {slope: 30 deg}}
bodies: {block1: {mass: m}, W: {shape: disc, mass: M, radius: R}, heavy_one: {mass: M, moves: down}}
connections: {c_ab: {contact: [block1, left_slope], friction: mu}, ax: {axle: W}, s2: {string: [block1, W, heavy_one]}}
states: {s0: at rest}
find: {T: s2.heavy_one.tension at s0, N: c_ab.normal_force at s0, F: ax.force at s0, a: block1.acceleration, v: W.rim.acceleration at s0}
"""


def test_names_that_are_no_words_stand_behind_what_they_name() -> None:
    assert [*map(plain_text, asked_in_words(read_text(NAMES)).values())] == [
        "T, the tension of the string s2 on the side of the heavy one",
        "N, the normal force between block 1 and the left slope",
        "F, the force of the axle ax",
        "a, the acceleration of block 1",
        "v, the acceleration of W's rim",
    ]


def test_all_is_told_in_german() -> None:
    language = language_named("de")
    assert language is not None
    lost: set[str] = set()
    for file in FILES:
        translation = Translation(language, names_told(problem_in(file)))
        translator = Translator(translation)
        for phrase in asked_in_words(problem_in(file)).values():
            translator.phrase(phrase)
        lost |= translation.lost
    assert lost == set()
