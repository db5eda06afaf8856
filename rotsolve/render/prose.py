"""Prose made safe for Markdown, LaTeX and HTML: what is special there is escaped, and letters that LaTeX lacks become commands."""

from __future__ import annotations

import re

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
