"""The voices of Markdown, LaTeX and HTML: what is special in prose is escaped there, and letters that LaTeX lacks become commands."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

from rotsolve.algebra.notation.text import to_latex
from rotsolve.render.voice import Voice

if TYPE_CHECKING:
    from rotsolve.algebra.formula import Formula
    from rotsolve.algebra.units.unit_table import Unit

MARKDOWN_SPECIAL = re.compile(r"([\\`*_\[\]<>$|#~])")
HTML_SPECIAL = str.maketrans({"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;", "'": "&#39;"})
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


def markdown_prose(text: str) -> str:
    """Prose in which Markdown sees no markup."""
    return MARKDOWN_SPECIAL.sub(r"\\\1", text)


def html_prose(text: str) -> str:
    """Prose in which a browser sees no markup, also within an attribute."""
    return text.translate(HTML_SPECIAL)


def latex_prose(text: str) -> str:
    """Prose as LaTeX; a letter that no font of plain LaTeX has becomes a question mark rather than an error."""
    return "".join(_latex_letter(letter) for letter in text)


def _latex_letter(letter: str) -> str:
    if letter in LATEX_SPECIAL:
        return LATEX_SPECIAL[letter]
    if letter in MATHEMATICS:
        return rf"\ensuremath{{{MATHEMATICS[letter]}}}"
    if letter.isspace():
        return " "
    return (
        letter if letter.isprintable() and ord(letter) < 0x180 else "?"
    )  # Latin letters with accents are in every LaTeX


def latex_number(mantissa: str, exponent: str) -> str:
    """A number as LaTeX sets it: 2 \\times 10^{3}."""
    mantissa = mantissa.replace("−", "-")
    return rf"{mantissa} \times 10^{{{exponent}}}" if exponent else mantissa


def mathml_number(mantissa: str, exponent: str) -> str:
    digits = mantissa.lstrip("-−")
    said = f"<mn>{digits}</mn>" if digits == mantissa else f"<mrow><mo>−</mo><mn>{digits}</mn></mrow>"
    if not exponent:
        return said
    power = f"<msup><mn>10</mn>{mathml_number(exponent, '')}</msup>"
    return f"<mrow>{said}<mo>×</mo>{power}</mrow>"


def to_mathml(formula: Formula) -> str:
    from rotsolve.algebra.notation.mathml import mathml  # few runs print MathML

    return mathml(formula)


def mathml_unit(unit: Unit) -> str:
    from rotsolve.algebra.notation import mathml

    return mathml.unit(unit.text)


RELATIONS = {"≤": r"\le", "≥": r"\ge", "≈": r"\approx", "≠": r"\ne"}
MARKDOWN = Voice(to_latex, lambda unit: unit.latex, latex_number, markdown_prose, "${}$".format, r"\,", RELATIONS)
LATEX = Voice(to_latex, lambda unit: unit.latex, latex_number, latex_prose, "${}$".format, r"\,", RELATIONS)
HTML = Voice(
    to_mathml,
    mathml_unit,
    mathml_number,
    html_prose,
    "<math>{}</math>".format,
    '<mspace width="0.22em"></mspace>',
    {sign: f"<mo>{html_prose(sign)}</mo>" for sign in "=≤≥<>≈≠"},
)
