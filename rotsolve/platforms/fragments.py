"""Fragments: pieces of a page as HTML that other programs show: formulas as MathML, pictures and images as files beside it."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING, ClassVar
from zlib import crc32

from rotsolve.page import blocks
from rotsolve.page.blocks import LABEL, FixedPage, PageBlock, Paragraph, Phrase
from rotsolve.page.formats import WIDTH, Format
from rotsolve.page.html import Html
from rotsolve.page.languages import language_named
from rotsolve.page.printer import Lines, Printer
from rotsolve.page.statement_blocks import Image
from rotsolve.platforms.xml_text import writable

if TYPE_CHECKING:
    from rotsolve.keys.sheets import SheetProblem

READ_BY_PLATFORMS = re.compile(r"\\(?=[()\[\]])|\$(?=\$)|\[(?=\[)|\{(?=[@#:\d])|@(?=@)")
APART = "<span></span>"
WITHIN = "\\g<0>\N{WORD JOINER}"  # the same within an attribute


class FragmentHtml(Html):
    """Pages as HTML within that of a platform. Signs in prose that a platform would take for its own, as \\(, {1: or [[, are put apart."""

    styles: ClassVar = {**Html.styles, LABEL: "<b>{}</b> "}  # there is no style sheet

    def __init__(self, place: str = "") -> None:
        self.place = place  # in front of the name of a file
        self.files: dict[str, bytes] = {}

    def prose(self, text: str) -> str:
        return READ_BY_PLATFORMS.sub(rf"\g<0>{APART}", super().prose(writable(text)))

    def own(self) -> dict[type[PageBlock], Callable[..., Lines]]:
        return super().own() | {blocks.Picture: self.picture, Image: self.image}

    def picture(self, block: blocks.Picture) -> Iterator[str]:
        """The picture of the scene, as a file."""
        from rotsolve.draw.paper.svg import svg
        from rotsolve.draw.pictures import picture_of

        figure = picture_of(block.scene)
        if figure is not None:
            content = svg(figure, adapts=False).encode()
            yield self.shown_file(f"picture-{crc32(content):08x}.svg", content, block.scene.title)

    def image(self, block: Image) -> Iterator[str]:
        """An image of a text, as a file."""
        yield self.shown_file(block.name, block.content() or b"", block.alt)

    def shown_file(self, name: str, content: bytes, alt: str) -> str:
        self.files[name] = content
        return f'<p><img src="{self.place}{name}" alt="{READ_BY_PLATFORMS.sub(WITHIN, super().prose(writable(alt)))}" /></p>'

    def fragment(self, content: Iterable[PageBlock]) -> str:
        """Blocks one below the other."""
        page = Format("html", (), "", "", language=self.code).spoken(FixedPage(tuple(content)))
        return Printer.body(self, page, WIDTH).strip()

    def sentence(self, *phrases: Phrase) -> str:
        """Words in paragraphs."""
        return self.fragment(map(Paragraph, phrases))


def fragments_in(language: str, place: str = "") -> FragmentHtml:
    """What prints fragments in a language."""
    printer = FragmentHtml(place)
    found = language_named(language)
    return printer if found is None else printer.in_language(found)


def problem_blocks(one: SheetProblem) -> list[PageBlock]:
    """What a problem says, without what it asks: its text, picture, givens, and which way is positive."""
    from rotsolve.page.blocks import Labelled, Labels, Picture

    said = one.statement
    rows = (Labelled("Given", said.givens, ", "), Labelled("Positive", said.positive))
    picture = [Picture(one.worked.problem)] if one.listed.layout.picture else []
    return [*said.text, *picture, Labels(tuple(row for row in rows if row.items))]


def solution_blocks(one: SheetProblem, digits: int) -> list[PageBlock]:
    """The derivation of a problem, without its title."""
    from msgspec.structs import replace

    from rotsolve.page.derivation import DerivationPage

    derivation = replace(one.worked.derivation(), title="")
    return [*DerivationPage(derivation, digits, one.listed.name, scene=one.worked.problem).blocks()]
