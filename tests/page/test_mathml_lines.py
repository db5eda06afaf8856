"""Long formulas of web pages in pieces: all of the formula is there, in its order, and no piece begins within a bracket."""

from __future__ import annotations

import re

import pytest

from rotsolve.algebra.notation.mathml import mathml
from rotsolve.algebra.notation.parse import parse
from rotsolve.page.mathml_lines import LONG, math_pieces

SUM = " + ".join(f"a_{k}*(b - c_{k})" for k in range(12))


def marks(text: str) -> list[str]:
    """The letters, numbers and signs in order."""
    return re.findall(r"<m[ion][^>]*>([^<]*)</m[ion]>", text)


@pytest.mark.parametrize("formula", [SUM, f"-({SUM})/d - e", f"m*({SUM})", "a + b"])
def test_all_of_a_formula_is_in_its_pieces(formula: str) -> None:
    inner = f"<mo>=</mo> {mathml(parse(formula))}"
    assert marks(math_pieces(inner)) == marks(inner)


def test_a_long_sum_ends_its_lines_before_signs() -> None:
    found = math_pieces(mathml(parse(SUM)))
    assert found.count("<math>") == 12 and found.count('<math><mo form="infix">+</mo>') == 11


def test_short_formulas_and_products_stay_whole() -> None:
    for formula in ("a + b", f"m*({SUM})"):
        assert math_pieces(mathml(parse(formula))).count("<math>") == 1
    assert math_pieces("") == ""
    assert len(mathml(parse(SUM))) > LONG
