"""Solution: what `rotsolve.solve` hands to Python and to notebooks."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.notation.parse import parse
from rotsolve.algebra.units.quantities import parse_unit
from rotsolve.core.derivation import Answer, Check, Derivation, Section
from rotsolve.solution import Solution, Trace


def forbidden() -> str:
    raise AssertionError("made though nobody asked")


@pytest.fixture
def solution() -> Solution:
    unit = parse_unit("m/s")
    half = evaluate(parse("-1/3"), {})
    part = Answer("v_x", parse("v_x"), None, half, unit, unit.dimension)
    answers = (
        Answer("v", parse("v"), parse("-sqrt(2 g h)"), half, unit, unit.dimension, "down", False, components=(part,)),
        Answer("k", parse("k"), None, None, None, None, word="slips"),
        Answer("n", parse("n"), parse("3/2"), None, None, None),
    )
    derivation = Derivation(
        "A fall", "", (), (), (), (), (Section("Falling"),), answers, (Check(("dimensions agree",)),)
    )
    problem: Any = SimpleNamespace(file="fall.yaml", givens=())
    return Solution(problem, derivation, Trace(lambda: "facts", forbidden, forbidden), 5)


def test_answers(solution: Solution) -> None:
    v = solution.answers["v"]
    assert list(solution.answers) == ["v", "k", "n"]
    assert (v.name, v.exact, v.value, v.unit, v.direction) == ("v", "−√(2 g h)", "-0.33333", "m/s", "down")
    assert v.float == pytest.approx(-1 / 3, rel=1e-15)
    assert v.formula == parse("-sqrt(2 g h)")
    assert v.components["v_x"].value == "-0.33333"
    assert str(v) == "v = −√(2 g h) = −0.33333 m/s (down)\n  vₓ = −0.33333 m/s"


def test_an_answer_without_number(solution: Solution) -> None:
    k = solution.answers["k"]
    assert (k.exact, k.value, k.float, k.unit, k.word, k.sympy) == (None, None, None, "", "slips", None)
    assert str(k) == "k: slips"


def test_sympy(solution: Solution) -> None:
    import sympy

    expression = solution.answers["v"].sympy
    g, h = sorted(expression.free_symbols, key=str)
    assert sympy.simplify(expression + sympy.sqrt(2 * g * h)) == 0


def test_steps_and_checks(solution: Solution) -> None:
    assert [section.title for section in solution.steps] == ["Falling"]
    assert [check.holds for check in solution.checks] == [True]


def test_stages_are_made_when_they_are_asked_for(solution: Solution) -> None:
    assert solution.facts_text() == "facts"


def test_printing(solution: Solution) -> None:
    assert str(solution).startswith("A fall\n")
    assert not str(solution).endswith("\n")
    assert solution._repr_markdown_().startswith("# A fall\n")
    assert solution._repr_latex_().startswith("\\section*{A fall}\n")
    assert solution.to("latex").startswith("\\documentclass{article}\n")
    assert '"file": "fall.yaml"' in solution.to("json")
    with pytest.raises(KeyError, match="unknown format 'docx'"):
        solution.to("docx")
    with pytest.raises(ValueError, match=r"`pdf\(\)` gives its bytes"):
        solution.to("pdf")


def test_it_can_not_be_changed(solution: Solution) -> None:
    with pytest.raises(AttributeError):
        solution.digits = 3  # type: ignore[misc]
    with pytest.raises(TypeError):
        solution.answers["v"] = None  # type: ignore[index]
