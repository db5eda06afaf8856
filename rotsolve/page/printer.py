"""Printer: what every format does alike: it sets words with mathematics in them, and goes through the blocks of a page.

A format says how it sets prose, a formula, a unit, a number and the four plain blocks; it may print other blocks in a way of its own.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, ClassVar, Self

from rotsolve.algebra.formula import Formula
from rotsolve.core.derivation import Equality
from rotsolve.page.blocks import (
    LABEL,
    Amount,
    Bullets,
    Math,
    Matrix,
    Page,
    PageBlock,
    Paragraph,
    Phrase,
    Styled,
    Table,
    Title,
)
from rotsolve.page.languages import ENGLISH

if TYPE_CHECKING:
    from rotsolve.algebra.units.unit_table import Unit
    from rotsolve.page.languages.language import Language

POWER = r"(.*\d)(?:[eE]|\s*[·×]\s*10\^?)([-+−⁺⁻]?[\d⁰¹²³⁴⁵⁶⁷⁸⁹]+)"  # compiled where there is one
DECIMALS = r"(?<=\d)\.(?=\d)"
TIMES = frozenset("eE·×")  # before a power of ten
LOWERED = str.maketrans("⁺⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "+-0123456789")
CLOSE = ("°", "′", "″", "%")  # units that stand next to their number

Lines = Iterable[str]


class Printer:
    """Prints pages in one format."""

    blank = " "  # between a number and its unit
    between = "\n"  # two blocks
    decimal = "."  # the sign before decimals
    comma = ","  # the same where it is a comma
    code = ENGLISH  # the language of its pages
    babel = ""  # the same for LaTeX, where it is not English
    paper = ""  # that of a sheet, on which every page has its number and theirs: a4 or letter
    decimals = DECIMALS  # where a number has that sign
    relations: ClassVar[Mapping[str, str]] = {}  # signs that the format writes otherwise
    styles: ClassVar[Mapping[str, str]] = {LABEL: "{}: "}  # of words that stand out, with {} for them

    def in_language(self, language: Language) -> Self:
        """The same format for pages in another language."""
        from copy import copy

        found = copy(self)
        found.code, found.babel = language.code, language.babel
        found.decimal = self.comma if language.decimal == "," else language.decimal
        return found

    def on_paper(self, paper: str) -> Printer:
        """The same format for sheets on a paper."""
        from copy import copy

        found = copy(self)
        found.paper = paper
        return found

    def numerals(self, text: str) -> str:
        """Formulas and numbers with the decimal sign of the language."""
        return text if self.decimal == "." else re.sub(self.decimals, self.decimal, text)

    def prose(self, text: str) -> str:
        """Words, in which the format sees no markup."""
        raise NotImplementedError

    def formula(self, formula: Formula) -> str:
        raise NotImplementedError

    def unit(self, unit: Unit) -> str:
        raise NotImplementedError

    def number(self, mantissa: str, exponent: str) -> str:
        """A decimal number, times a power of ten where the exponent is not ''."""
        raise NotImplementedError

    def math(self, inner: str) -> str:
        """Mathematics that stands within prose."""
        raise NotImplementedError

    def bracketed(self, rows: Sequence[Sequence[str]]) -> str:
        """The rows of a matrix between brackets."""
        raise NotImplementedError

    def title(self, block: Title) -> Lines:
        raise NotImplementedError

    def paragraph(self, block: Paragraph) -> Lines:
        raise NotImplementedError

    def bullets(self, block: Bullets) -> Lines:
        raise NotImplementedError

    def table(self, block: Table) -> Lines:
        raise NotImplementedError

    def document(self, bodies: Sequence[str]) -> str:
        """A complete document of one or several pages."""
        raise NotImplementedError

    def own(self) -> dict[type[PageBlock], Callable[..., Lines]]:
        """The blocks that the format prints by itself: the four plain ones at least."""
        return {Title: self.title, Paragraph: self.paragraph, Bullets: self.bullets, Table: self.table}

    def body(self, page: Page, width: int) -> str:
        """One page, as it stands within a document; `width` is for formats with columns of letters."""
        own = self.own()
        blocks = simplified(page.blocks(), own.keys())
        return self.between.join("\n".join(own[type(block)](block)) for block in blocks) + "\n"

    def words(self, phrase: Phrase) -> str:
        """Prose with mathematics in it."""
        return "".join(map(self._inline, phrase))

    def _inline(self, item: str | Formula | Math | Styled) -> str:
        match item:
            case str():
                return self.prose(item)
            case Math():
                return self.math(" ".join(map(self.part, item.parts)))
            case Styled():
                return self.styled(item.style, item.text)
        return self.math(self.formula(item))

    def styled(self, style: str, text: str) -> str:
        """Words in one of the styles."""
        return self.styles.get(style, "{}").format(self.prose(text))

    def part(self, part: str | Formula | Amount | Matrix) -> str:
        """A part of mathematics: a sign, a formula, a number with its unit, a matrix."""
        match part:
            case str():
                return self.relations.get(part, part)
            case Amount():
                return self.with_unit(self._decimal(part.number), part.unit)
            case Matrix():
                return self.with_unit(self.bracketed([[*map(self.part, row)] for row in part.rows]), part.unit)
        return self.formula(part)

    def sides(self, equality: Equality) -> tuple[str, str]:
        """The left side of an equality; and its sign with the right side."""
        return self.formula(equality.left), f"{self.part(equality.relation)} {self.formula(equality.right)}"

    def _decimal(self, number: str | Formula) -> str:
        if not isinstance(number, str):
            return self.formula(number)
        mantissa, exponent = in_powers_of_ten(number.strip())
        return self.number(mantissa, exponent.translate(LOWERED).replace("−", "-").lstrip("+"))

    def with_unit(self, said: str, unit: Unit | None) -> str:
        """What has a unit, with its unit behind it."""
        if unit is None or unit.text in ("", "1"):
            return said
        return said + ("" if unit.text.startswith(CLOSE) else self.blank) + self.unit(unit)


def simplified(blocks: Iterable[PageBlock], known: Iterable[type[PageBlock]]) -> Iterator[PageBlock]:
    """The blocks of known kinds, and for each other one what says the same in those."""
    for block in blocks:
        if type(block) in known:
            yield block
        else:
            yield from simplified(block.simpler(), known)


def in_powers_of_ten(number: str) -> tuple[str, str]:
    """A number in front of its power of ten, and the exponent; '' without one."""
    match = None if TIMES.isdisjoint(number) else re.fullmatch(POWER, number)
    return (match[1], match[2]) if match else (number, "")
