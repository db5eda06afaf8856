"""Blocks: what stands on a page, as data. A format prints them; what a document says is decided here and in its page, once for all.

Four kinds are plain, and every format prints them: `Title`, `Paragraph`, `Bullets`, `Table`. All others can be said in simpler ones,
so that a format prints by itself only what it sets in a way of its own. A new kind needs its class, and `simpler`, to stand in all.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

from msgspec import Struct

from rotsolve.core.derivation import SHOWN, Check, Equality

if TYPE_CHECKING:
    from rotsolve.algebra.formula import Formula
    from rotsolve.algebra.units.unit_table import Unit
    from rotsolve.draw.paper.figure import Figure
    from rotsolve.language.problem import Problem

NAME, LABEL, STRONG, FAULT, CODE = "name", "label", "strong", "fault", "code"  # styles of words
BOLD, ITALIC, BOTH = "bold", "italic", "bold italic"  # styles of words of an author
AUTHORED = "authored"  # the style of words that are those of a scene's author: plain, and the same in all languages
GOOD, BAD, OPEN = "good", "bad", "open"  # what is thought of a text
LONGEST = 500  # characters of a student's text that are shown
ARROW = "→"
WITH = "with"  # what is said of the line that tells the meaning of a letter


class Amount(Struct, frozen=True):
    """A number with its unit: decimal text, as `2`, `−0.5` or `1e-3`, or a formula."""

    number: str | Formula
    unit: Unit | None = None


class Matrix(Struct, frozen=True):
    """Rows of formulas or numbers between brackets, with their unit behind."""

    rows: tuple[tuple[Formula | Amount, ...], ...]
    unit: Unit | None = None


class Math(Struct, frozen=True):
    """Mathematics within words: formulas, amounts and matrices with the signs between them: m = 2 kg."""

    parts: tuple[str | Formula | Amount | Matrix, ...]


class Styled(Struct, frozen=True):
    """Words that stand out, in one of the styles."""

    style: str
    text: str


Phrase = tuple["str | Formula | Math | Styled", ...]  # a line of words


def authored(text: str) -> Styled:
    """Words of the author of a scene."""
    return Styled(AUTHORED, text)


def equation(equality: Equality) -> Math:
    """An equality as mathematics."""
    return Math((equality.left, equality.relation, equality.right))


def unindented(phrase: Phrase) -> Phrase:
    """A line of its own within a sentence without the sign before it."""
    first = phrase[0] if phrase else ""
    return (first.removeprefix(SHOWN), *phrase[1:]) if isinstance(first, str) and first.startswith(SHOWN) else phrase


def joined_phrases(phrases: Iterable[Phrase], *between: str | Math) -> Phrase:
    """Phrases one behind the other, with something between two."""
    found: list[str | Formula | Math | Styled] = []
    for phrase in phrases:
        found += [*between, *phrase] if found else phrase
    return tuple(found)


def in_brackets(phrase: Phrase) -> Phrase:
    """The phrase in brackets behind a blank; nothing where it is empty."""
    return (" (", *phrase, ")") if phrase else ()


class PageBlock(Struct, frozen=True):
    """One kind of block."""

    def simpler(self) -> Iterator[PageBlock]:
        """The same in simpler blocks, for formats that have no way of their own for it."""
        raise NotImplementedError(f"{type(self).__name__} is as simple as it can be: every format has to print it")


class Title(PageBlock, frozen=True):
    """A heading: that of the page at level 1, of a section at 2; a `minor` one stands above a single block."""

    level: int
    words: Phrase
    minor: bool = False


class Paragraph(PageBlock, frozen=True):
    """A sentence or two."""

    words: Phrase


class Bullet(Struct, frozen=True):
    """One item of a list, with items of its own, numbered from `start` on where there is one, and lines of which every letter keeps
    its place."""

    words: Phrase
    inner: tuple[Bullet, ...] = ()
    code: tuple[str, ...] = ()
    start: int | None = None

    @property
    def list(self) -> Bullets:
        """Its own items."""
        return Bullets(self.inner, self.start)


class Bullets(PageBlock, frozen=True):
    """A list; the number of its first item where it is numbered."""

    items: tuple[Bullet, ...]
    start: int | None = None

    @property
    def marks(self) -> list[str]:
        """What stands before each item where it is numbered: 1., 2., …; '' where it is not."""
        return ["" if self.start is None else f"{self.start + place}." for place in range(len(self.items))]


class Table(PageBlock, frozen=True):
    """Rows of cells below the names of the columns; `targets` are the files that the first cells lead to."""

    columns: tuple[str, ...]
    rows: tuple[tuple[Phrase, ...], ...]
    targets: tuple[str, ...] = ()


class Picture(PageBlock, frozen=True):
    """The picture of a scene; formats of letters alone leave it out. It is drawn where it is printed."""

    scene: Problem

    def figure(self) -> Figure | None:
        """What is drawn; None where that can't be."""
        from rotsolve.draw.pictures import picture_of

        return picture_of(self.scene)

    def simpler(self) -> Iterator[PageBlock]:
        return iter(())


class Labelled(Struct, frozen=True):
    """What belongs to a label. In columns of text it may stand `beside` the row before, or with `wide` gaps between its items."""

    label: str
    items: tuple[Phrase, ...]
    separator: str = "; "
    beside: bool = False
    wide: bool = False


class Labels(PageBlock, frozen=True):
    """Labels with what belongs to them, below each other: Given, Find, …"""

    rows: tuple[Labelled, ...]

    def simpler(self) -> Iterator[PageBlock]:
        for row in self.rows:
            yield Paragraph((Styled(LABEL, row.label), *joined_phrases(row.items, row.separator)))


class Listed(Struct, frozen=True):
    """What is said of one name ("weight m g, down"), what stands beside it, and remarks in brackets."""

    name: str
    said: tuple[Phrase, ...]
    beside: str = ""
    remarks: tuple[Phrase, ...] = ()


class Listing(PageBlock, frozen=True):
    """A captioned list by names, as the forces on each body."""

    caption: str
    level: int
    rows: tuple[Listed, ...]

    def simpler(self) -> Iterator[PageBlock]:
        yield Title(self.level, (self.caption,), minor=True)
        yield Bullets(tuple(map(self.bullet, self.rows)))

    @staticmethod
    def bullet(row: Listed) -> Bullet:
        beside = f" — {row.beside}" if row.beside else ""
        remarks = in_brackets(joined_phrases(row.remarks, "; "))
        return Bullet((Styled(NAME, row.name), ": ", *joined_phrases(row.said, "; "), beside, *remarks))


class FormulaRow(Struct, frozen=True):
    """A line of formulas: what is said of it, equalities of which each follows from the one before, and its number.

    A law is `numbered` first and then named; of a step the number stands behind it. `values` are what the equality at `valued` comes to:
    with numbers put in, and the number itself. What is said `begins` a sentence that the equality ends: no colon stands between.
    """

    said: Phrase
    chain: tuple[Equality, ...]
    number: int | None = None
    remark: Phrase = ()
    numbered: bool = False
    begins: bool = False
    values: tuple[Amount, ...] = ()
    valued: int = -1

    @property
    def words(self) -> Phrase:
        """All that is said of it."""
        if self.numbered:
            return (*self.said, *in_brackets(self.remark))
        return joined_phrases(filter(None, (self.said, self.remark)), ": ")

    @property
    def says_much(self) -> bool:
        """Whether what is said of it stands above its equalities rather than beside them."""
        return not self.numbered and bool(self.said) and len(self.chain) > 1

    def line(self, place: int) -> Phrase:
        """One of its equalities, with what it comes to."""
        one, worth = self.chain[place], self.worth(place)
        return (Math((one.left, one.relation, one.right, *worth)),)

    def worth(self, place: int) -> tuple[str | Amount, ...]:
        """What one of its equalities comes to: = 2·9.8 N = 19.6 N."""
        here = place == self.valued % len(self.chain)
        return tuple(part for value in (self.values if here else ()) for part in ("=", value))

    @property
    def mark(self) -> str:
        """Its number in brackets."""
        return "" if self.number is None else f"({self.number})"


class Formulas(PageBlock, frozen=True):
    """Formulas below a caption and sentences, their signs below each other where a format can."""

    caption: str
    level: int
    remarks: tuple[Phrase, ...]
    rows: tuple[FormulaRow, ...]

    def continues(self, other: Formulas) -> bool:
        """Whether its rows may go on those of the formulas before it: both stand below the title of one section."""
        return self.level == other.level > 2 and not self.remarks

    def simpler(self) -> Iterator[PageBlock]:
        yield Title(self.level, (self.caption,), minor=True)
        yield from map(Paragraph, map(unindented, self.remarks))
        if self.rows:
            yield Bullets(tuple(map(self.bullet, self.rows)))

    @staticmethod
    def bullet(row: FormulaRow) -> Bullet:
        chain = joined_phrases(map(row.line, range(len(row.chain))), " ", Math((ARROW,)), " ")
        said = (*row.said, ": ") if row.said else ()
        if row.numbered:
            return Bullet((f"{row.mark} ", *said, *chain, *in_brackets(row.remark)))
        return Bullet((*said, *chain, f" {row.mark}" if row.mark else "", *in_brackets(row.remark)))


class AnswerRow(Struct, frozen=True):
    """An answer: its letter, its exact form and its number, which way it points, and notes in brackets; its components follow.

    Of a `matrix` the components are its entries, where it is too wide for a page. On a key the `label` of its part stands before it, (a).
    """

    symbol: Formula
    forms: tuple[Formula | Amount | Matrix, ...]
    asides: tuple[str, ...] = ()
    notes: tuple[Phrase, ...] = ()
    components: tuple[AnswerRow, ...] = ()
    matrix: bool = False
    label: str = ""

    @property
    def head(self) -> str:
        """What stands before it."""
        return f"({self.label}) " if self.label else ""

    @property
    def behind(self) -> Phrase:
        """What is said behind the formulas."""
        asides = (f"{' ' if aside.startswith('(') else ', '}{aside}" for aside in self.asides)
        return (*asides, *(part for note in self.notes for part in in_brackets(note)))

    @property
    def bullet(self) -> Bullet:
        """The answer as an item of a list, its components as items of it."""
        sides = [part for form in self.forms for part in ("=", form)]
        inner = () if self.matrix else tuple(part.bullet for part in self.components)
        return Bullet((self.head, Math((self.symbol, *sides)), *self.behind), inner)


class Answers(PageBlock, frozen=True):
    """What was asked for."""

    rows: tuple[AnswerRow, ...]

    def simpler(self) -> Iterator[PageBlock]:
        yield Bullets(tuple(row.bullet for row in self.rows))


class Checks(PageBlock, frozen=True):
    """What confirms the answers; what does not hold, or could not be decided, stands out."""

    checks: tuple[Check, ...]

    def simpler(self) -> Iterator[PageBlock]:
        yield Bullets(tuple(Bullet((*self.verdict(check), *check.words)) for check in self.checks))

    @staticmethod
    def verdict(check: Check) -> Phrase:
        """What is said before a check that does not hold."""
        label = Checks.label(check)
        return (Styled(FAULT, label), " ") if label else ()

    @staticmethod
    def label(check: Check) -> str:
        """How a check failed; '' of one that holds."""
        if check.holds:
            return ""
        return check.label or ("not decided:" if check.holds is None else "does not hold:")


class Note(Struct, frozen=True):
    """What is said of a text, and the columns that it speaks of, the end behind the last."""

    words: Phrase
    start: int | None = None
    end: int | None = None

    @property
    def columns(self) -> tuple[int, int] | None:
        """The columns, one at least."""
        return None if self.start is None else (self.start, max(self.start + 1, self.end or 0))


class AssessedText(Struct, frozen=True):
    """A text that someone wrote, what is thought of it in a word and in marks, and notes; `read_as` where it was not clear."""

    label: Phrase
    text: str
    tone: str
    said: str
    marks: str = ""
    notes: tuple[Note, ...] = ()
    read_as: str = ""

    @property
    def divided(self) -> tuple[str, str, str]:
        """The text as far as it is shown: before, in and behind the columns of the first note that has any."""
        text = clipped(self.text)
        columns = (note.columns for note in self.notes)
        start, end = next((both for both in columns if both and both[0] < len(text)), (0, 0))
        return text[:start], text[start:end], text[end:]


class AssessedTexts(PageBlock, frozen=True):
    """Texts below each other, each with what is thought of it, and what is said of it below."""

    rows: tuple[AssessedText, ...]

    def simpler(self) -> Iterator[PageBlock]:
        yield Bullets(tuple(map(self.bullet, self.rows)))

    @staticmethod
    def bullet(row: AssessedText) -> Bullet:
        text: Phrase = (Styled(CODE, clipped(row.text)), " — ") if row.text else ()
        said = row.said if row.tone == GOOD else Styled(STRONG, row.said)
        inner = [Bullet(note.words, code=carets(row.text, note)) for note in row.notes]
        if row.read_as:
            inner.append(Bullet(("read as ", Styled(CODE, clipped(row.read_as)))))
        return Bullet((*row.label, ": ", *text, said, f", {row.marks}" if row.marks else ""), tuple(inner))


def clipped(text: str) -> str:
    """The text as far as it is shown."""
    return text if len(text) <= LONGEST else text[: LONGEST - 1] + "…"


def carets(text: str, note: Note) -> tuple[str, ...]:
    """The text with carets below the columns that a note speaks of."""
    if note.columns is None or not text or len(text) > LONGEST:
        return ()
    start, end = note.columns
    return (text, " " * start + "^" * (end - start))


class Page(Struct, frozen=True):
    """A page: its blocks for readers, and what it holds for programs."""

    @property
    def spaced(self) -> bool:
        """Whether plain text has blank lines between its sections."""
        return True

    def blocks(self) -> Iterator[PageBlock]:
        """What stands on it."""
        raise NotImplementedError

    def data(self) -> dict[str, Any]:
        """The same as plain values: dicts, lists and strings."""
        raise NotImplementedError

    def names(self) -> frozenset[str]:
        """Words on it that somebody gave to things of a scene, and that are the same in all languages."""
        return frozenset()


class FixedPage(Page, frozen=True):
    """A page whose blocks, or what it holds for programs, are there already."""

    content: tuple[PageBlock, ...] = ()
    values: dict[str, Any] = {}

    def blocks(self) -> Iterator[PageBlock]:
        yield from self.content

    def data(self) -> dict[str, Any]:
        return self.values
