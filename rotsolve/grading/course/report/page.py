"""Page: what a report says, as data; `showing` prints it in each format."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from functools import cache

from msgspec import Struct

from rotsolve.algebra.formula import Formula
from rotsolve.core.derivation import Words
from rotsolve.grading.verdict import Verdict


class Judged(Struct, frozen=True):
    """A text of the student with its verdict: what it is (`a`, or the number of a line), and what is said beside it."""

    label: Words
    text: str
    verdict: Verdict
    said: str
    marks: str = ""


class Judgements(Struct, frozen=True):
    """Texts of the student below each other."""

    items: tuple[Judged, ...]


class Paragraph(Struct, frozen=True):
    """A sentence or two."""

    words: Words


class Table(Struct, frozen=True):
    """Rows of cells below the names of the columns; `targets` are the files that the first cells lead to."""

    columns: tuple[str, ...]
    rows: tuple[tuple[Words, ...], ...]
    targets: tuple[str, ...] = ()


class Section(Struct, frozen=True):
    """What stands below one heading; the first section of a page has none."""

    heading: str
    blocks: tuple[Judgements | Paragraph | Table, ...]


class Page(Struct, frozen=True):
    """One page of a report."""

    title: str
    sections: tuple[Section, ...]


class Task(Struct, frozen=True):
    """The problem that is marked: its title, and what is asked by name with the letter that is printed for it."""

    title: str
    letters: Mapping[str, Formula]

    def letter(self, name: str) -> Words:
        return (self.letters[name],) if name in self.letters else (name,)


@cache
def amount(marks: Fraction) -> str:
    """Marks as a decimal number where that is exact, else to two places: `5`, `2.5`, `0.33`."""
    hundredths = round(marks * 100)
    text = f"{hundredths // 100}.{hundredths % 100:02d}" if hundredths >= 0 else f"-{amount(-marks)}"
    return text.rstrip("0").rstrip(".") if "." in text else text


def of(marks: Fraction, most: Fraction) -> str:
    return f"{amount(marks)} of {amount(most)}"
