"""Statement blocks: what stands on a sheet of problems beside plain blocks: its head, questions with room for the answer, images."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from os.path import basename, splitext
from typing import ClassVar
from zlib import crc32

from msgspec import Struct

from rotsolve.page.blocks import LABEL, PageBlock, Paragraph, Phrase, Styled, Title, authored

BEGINS = {".png": b"\x89PNG\r\n", ".jpg": b"\xff\xd8\xff", ".svg": b""}  # an image, by the ending of its file
LONGEST_HEAD = 5000  # bytes before an SVG begins
BLANK = "_" * 16
LINE = 8  # millimetres from one line to write on to the next


class HeadField(Struct, frozen=True):
    """A field at the head of a sheet: its label, and what stands in it, or room to fill it in; a `wide` one is for a name."""

    label: str
    said: str = ""
    wide: bool = False


class SheetHead(PageBlock, frozen=True):
    """The head of a sheet: the course, the title, and fields."""

    title: Phrase
    course: str = ""
    fields: tuple[HeadField, ...] = ()

    def simpler(self) -> Iterator[PageBlock]:
        yield from (Paragraph((authored(self.course),)),) if self.course else ()
        yield Title(1, self.title)
        words = [(Styled(LABEL, field.label), authored(field.said or BLANK), "  ") for field in self.fields]
        yield from (Paragraph(tuple(part for one in words for part in one)[:-1]),) if words else ()


class Question(PageBlock, frozen=True):
    """What is asked: its label where there are several, `a`; its points; the millimetres of room for the answer, blank or with lines."""

    label: str
    words: Phrase
    points: str = ""
    room: Fraction = Fraction(0)
    ruled: bool = False

    @property
    def said(self) -> Phrase:
        """All that is said: (a) the acceleration [2 points]."""
        label = (f"({self.label}) ",) if self.label else ()
        return (*label, *self.words, *((f" [{self.points}]",) if self.points else ()))

    @property
    def lines(self) -> int:
        """How many lines to write on there are."""
        return int(self.room // LINE) if self.ruled else 0

    def simpler(self) -> Iterator[PageBlock]:
        yield from (Paragraph(self.said),) if self.said else ()


class PageBreak(PageBlock, frozen=True):
    """What follows begins a page; formats of letters alone have none."""

    def simpler(self) -> Iterator[PageBlock]:
        return iter(())


class Image(PageBlock, frozen=True):
    """An image of a file, with the words that say what it shows. Formats that can't hold it refer to a file of its `name` beside."""

    path: str
    alt: str
    most: ClassVar[int] = 5_000_000  # bytes

    def simpler(self) -> Iterator[PageBlock]:
        yield Paragraph(("[", authored(self.alt), "]"))

    @property
    def suffix(self) -> str:
        """The ending of its file in small letters; there is one for JPEG."""
        return splitext(self.path)[1].lower().replace("jpeg", "jpg")

    def content(self) -> bytes | None:
        """What its file holds, if that is an image of its kind and not too large."""
        try:
            with open(self.path, "rb") as stream:
                found = stream.read(self.most + 1)
        except OSError:
            return None
        begins = BEGINS[self.suffix]
        holds = found.startswith(begins) if begins else b"<svg" in found[:LONGEST_HEAD]
        return found if holds and len(found) <= self.most else None

    @property
    def name(self) -> str:
        """A name that no other image has, for a copy."""
        stem = "".join(
            letter if letter.isascii() and letter.isalnum() else "-" for letter in splitext(basename(self.path))[0]
        )
        return f"{stem[:40]}-{crc32(self.content() or b''):08x}{self.suffix}"
