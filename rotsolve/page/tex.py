"""TeX: how LaTeX, also within Markdown, sets mathematics, and what it writes for letters that it lacks or that mean something to it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, ClassVar

from rotsolve.algebra.notation.typeset import to_latex
from rotsolve.page.printer import Printer

if TYPE_CHECKING:
    from rotsolve.algebra.formula import Formula
    from rotsolve.algebra.units.unit_table import Unit

WORDS = 40  # letters on one line, beside a formula or in a table
LATEX_PREAMBLE = r"""\documentclass{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{textcomp}
\usepackage{amsmath,amssymb}
\usepackage[margin=25mm]{geometry}
\setlength{\parindent}{0pt}
\setlength{\parskip}{6pt}
\allowdisplaybreaks
"""
LATEX_SPECIAL = {
    "\\": r"\textbackslash{}",
    "{": r"\{",
    "}": r"\}",
    "$": r"\$",
    "&": r"\&",
    "#": r"\#",
    "%": r"\%",
    "_": r"\_",
    "^": r"\textasciicircum{}",
    "~": r"\textasciitilde{}",
    "<": r"\textless{}",
    ">": r"\textgreater{}",
    "|": r"\textbar{}",
    "°": r"\textdegree{}",
    "–": "--",
    "—": "---",
    "…": r"\dots{}",
    "‘": "`",
    "’": "'",
    "“": "``",
    "”": "''",
    "█": r"\rule{1ex}{1.5ex}",
}
GREEK = (
    *("alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa", "lambda", "mu"),
    *("nu", "xi", "omicron", "pi", "rho", "varsigma", "sigma", "tau", "upsilon", "phi", "chi", "psi", "omega"),
)
MATHEMATICS = {
    **{chr(0x3B1 + number): rf"\{name}" for number, name in enumerate(GREEK)},
    **{chr(0x391 + number): rf"\{name.capitalize()}" for number, name in enumerate(GREEK) if name in {
        "gamma", "delta", "theta", "lambda", "xi", "pi", "sigma", "upsilon", "phi", "psi", "omega"
    }},
    **{subscript: f"_{number}" for number, subscript in enumerate("₀₁₂₃₄₅₆₇₈₉")},
    **{superscript: f"^{number}" for number, superscript in enumerate("⁰¹²³⁴⁵⁶⁷⁸⁹")},
    "−": "-",
    "·": r"\cdot",
    "×": r"\times",
    "→": r"\to",
    "√": r"\surd",
    "∫": r"\int",
    "∂": r"\partial",
    "≤": r"\le",
    "≥": r"\ge",
    "≈": r"\approx",
    "≠": r"\ne",
    "∞": r"\infty",
    "½": r"\tfrac12",
    "⅓": r"\tfrac13",
    "¼": r"\tfrac14",
    "∥": r"\parallel",
    "⊥": r"\perp",
    "≪": r"\ll",
    "≫": r"\gg",
    "ο": "o",
}  # fmt: skip


def latex_preamble(babel: str) -> str:
    """What stands before the pages: with a language of babel, whose quotes are as in English, where they are not English."""
    return (
        LATEX_PREAMBLE
        + (rf"\usepackage[{babel},shorthands=off]{{babel}}" + "\n" if babel else "")
        + "\\begin{document}\n"
    )


def latex_prose(text: str) -> str:
    """Prose as LaTeX; a letter that no font of plain LaTeX has becomes a question mark rather than an error."""
    return "".join(map(_latex_letter, text))


def _latex_letter(letter: str) -> str:
    if letter in LATEX_SPECIAL:
        return LATEX_SPECIAL[letter]
    if letter in MATHEMATICS:
        return rf"\ensuremath{{{MATHEMATICS[letter]}}}"
    if letter.isspace():
        return " "
    # Latin letters with accents are in every LaTeX
    return letter if letter.isprintable() and ord(letter) < 0x180 else "?"


def aligned(rows: Sequence[str]) -> Iterator[str]:
    """Equations aligned at their signs, with the words behind them."""
    if rows:
        yield from (r"\begin{align*}", " \\\\\n".join(f"  {row}" for row in rows), r"\end{align*}")


def words_cell(text: str) -> str:
    """Words behind an equation, wrapped where they are long."""
    if len(text) > WORDS:
        return rf" && \parbox[t]{{0.4\linewidth}}{{\raggedright {text}}}"
    return rf" && \text{{{text}}}" if text else ""


class TexPrinter(Printer):
    """What Markdown and LaTeX set alike: mathematics, as LaTeX between dollar signs."""

    blank = r"\,"
    comma = "{,}"  # a bare one has a blank behind it
    relations: ClassVar = {"≤": r"\le", "≥": r"\ge", "≈": r"\approx", "≠": r"\ne", "→": r"\;\to\;"} | {
        "≪": r"\ll",
        "≫": r"\gg",
        "±": r"\pm",
    }

    def formula(self, formula: Formula) -> str:
        return self.numerals(to_latex(formula))

    def unit(self, unit: Unit) -> str:
        return unit.latex

    def number(self, mantissa: str, exponent: str) -> str:
        mantissa = self.numerals(mantissa.replace("−", "-"))
        return rf"{mantissa} \times 10^{{{exponent}}}" if exponent else mantissa

    def math(self, inner: str) -> str:
        return f"${inner}$"

    def bracketed(self, rows: Sequence[Sequence[str]]) -> str:
        body = r" \\ ".join(" & ".join(row) for row in rows)
        return rf"\begin{{pmatrix}} {body} \end{{pmatrix}}"
