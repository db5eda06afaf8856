"""LaTeX: a formula as LaTeX source."""

from __future__ import annotations

from rotsolve.algebra.formula import Formula
from rotsolve.algebra.notation.letters import name_to_latex
from rotsolve.algebra.notation.text import Signs
from rotsolve.algebra.notation.typeset import Marks, typeset

FUNCTIONS = {"atan2": r"\operatorname{atan2}", "K": "K"}

LATEX = Marks(
    number=str,
    letter=name_to_latex,
    function=lambda name: FUNCTIONS.get(name, rf"\{name}"),
    row=str,
    signs=Signs(" + ", " - ", "-", r"\left({}\right)".format),
    beside=" ",
    before=" ",
    dot=r" \cdot ",
    applied=" ",
    comma=", ",
    bars=r"\left|{}\right|".format,
    root=r"\sqrt{{{}}}".format,
    fraction=r"\frac{{{}}}{{{}}}".format,
    power="{}^{{{}}}".format,
    integral=r"\int_{{{}}}^{{{}}} {}\,\mathrm{{d}}{}".format,
)


def latex(formula: Formula) -> str:
    """The formula in LaTeX, without dollar signs."""
    return typeset(formula, LATEX)
