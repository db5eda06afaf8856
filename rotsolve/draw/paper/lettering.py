"""Lettering: what a label says, in text and in LaTeX, how wide it is, and which of its letters stand below the line or lean."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from msgspec import Struct

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.notation.letters import SUBSCRIPTS, name_to_latex, name_to_text
from rotsolve.algebra.notation.text import degrees_of, to_text
from rotsolve.algebra.notation.typeset import to_latex

SIZE = 10.5  # of letters, in points
NARROW, WIDE = frozenset("iljtf.,:;|!'()[]/ I·"), frozenset("mwMWΩ—@")
RAISED = {sub: plain for plain, sub in SUBSCRIPTS.items()}
RUN = re.compile(rf"((?:_[A-Za-z0-9]+)+|[{''.join(RAISED)}]+)")
WORD = re.compile(r"[A-Za-z]{2,}|[^A-Za-zα-ωΑ-Ω]+|[A-Za-zα-ωΑ-Ω]")


class Words(Struct, frozen=True):
    """What a label says: its text, and the same for LaTeX."""

    text: str
    latex: str
    prose: bool = False


class LetterRun(Struct, frozen=True):
    """A piece of a label: it leans where it is a letter, and may stand below the line."""

    text: str
    leans: bool
    below: bool


def letter(name: str) -> Words:
    """A letter such as `m1`."""
    return Words(name_to_text(name), f"${name_to_latex(name)}$")


def formula_words(value: Formula) -> Words:
    """A formula; a multiple of π is an angle, and told in degrees."""
    if isinstance(value, Symbol):
        return letter(value.name)
    if (degrees := degrees_of(value)) is not None:
        return prose(f"{float(degrees):.4g}°".replace("-", "−"))
    return Words(to_text(value), f"${to_latex(value)}$")


def words_with_letters(value: Formula, letters: Mapping[str, Formula]) -> Words:
    """A formula of quantities, with the letters that are printed for them."""
    return formula_words(value.substitute(letters))


def prose(text: str) -> Words:
    """Plain words."""
    escaped = "".join({"&": r"\&", "%": r"\%", "#": r"\#", "_": r"\_", "$": r"\$"}.get(c, c) for c in text)
    escaped = escaped.replace("°", r"$^\circ$")
    return Words(text, escaped, True)


def letter_runs(text: str, plain: bool = False) -> Iterator[LetterRun]:
    """The pieces of a text: single letters lean, words and figures stand; what follows `_` or is a small figure stands below."""
    for piece in RUN.split(text):
        if not piece:
            continue
        below = piece[0] == "_" or piece[0] in RAISED
        said = "".join(RAISED.get(char, char) for char in piece.removeprefix("_").replace("_", ",")) if below else piece
        if below and not plain:
            yield LetterRun(said, len(said) == 1 and said.isalpha(), True)
        elif plain:
            yield LetterRun(piece, False, False)
        else:
            for word in WORD.findall(said):
                yield LetterRun(word, len(word) == 1 and word.isalpha(), False)


def width_of(text: str, size: float = SIZE, plain: bool = False) -> float:
    """About how wide a text is, rather more than less."""
    return sum(
        size * (0.72 if run.below else 1.0) * sum(0.36 if c in NARROW else 0.92 if c in WIDE else 0.6 for c in run.text)
        for run in letter_runs(text, plain)
    )
