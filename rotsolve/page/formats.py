"""Formats: the table of output formats. A new one is a file with a `PRINTER`, and its row here; commands, help and checks follow."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from importlib import import_module
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.page.languages import ENGLISH, language_named

if TYPE_CHECKING:
    from rotsolve.page.blocks import Page
    from rotsolve.page.printer import Printer

WIDTH = 120  # columns of a page of text, where nothing narrower is asked for
TERMINAL, PAGES, DATA = "terminal", "pages", "data"


class Format(Struct, frozen=True):
    """An output format: its name, how its files end (the first is for new ones), what it is for, and the module of its `PRINTER`.

    `use`: on a TERMINAL pages come one by one; PAGES are to be read or printed; DATA is for programs, a file for everything.
    Its pages are printed in a `language` of those there are.
    """

    name: str
    suffixes: tuple[str, ...]
    help: str
    module: str
    use: str = PAGES
    language: str = ENGLISH
    paper: str = ""  # that of sheets: a4 or letter
    binary: bool = False  # whether its files hold what Typst makes of the document, and no text

    @property
    def printer(self) -> Printer:
        """What prints it; imported when it is asked for."""
        printer: Printer = import_module(self.module).PRINTER
        language = language_named(self.language)
        printer = printer.on_paper(self.paper) if self.paper else printer
        return printer if language is None else printer.in_language(language)

    def spoken(self, page: Page) -> Page:
        """The page in the language of the format."""
        language = language_named(self.language)
        if language is None:
            return page
        from rotsolve.page.languages.pages import TranslatedPage

        return TranslatedPage(page, language)

    def body(self, page: Page, width: int = WIDTH) -> str:
        """One page, as it stands within a document; `width` is for formats with columns of letters."""
        return self.printer.body(self.spoken(page), width)

    def document(self, bodies: Sequence[str]) -> str:
        """A complete document of one or several pages, as text."""
        return self.printer.document(bodies)

    def file(self, bodies: Sequence[str], images: Mapping[str, bytes] | None = None) -> str | bytes:
        """What a file of it holds, one of bytes with the images to which its pages refer."""
        if not self.binary:
            return self.document(bodies)
        from rotsolve.page.press import printed_document

        return printed_document(self.document(bodies), images=images or {})


FORMATS = {
    item.name: item
    for item in (
        Format("text", (".txt",), "plain text in aligned columns", "rotsolve.page.text", TERMINAL),
        Format("markdown", (".md", ".markdown"), "Markdown with the formulas as LaTeX", "rotsolve.page.markdown"),
        Format("latex", (".tex",), "a complete LaTeX document", "rotsolve.page.latex"),
        Format("typst", (".typ",), "a complete Typst document", "rotsolve.page.typst"),
        Format("pdf", (".pdf",), "a PDF, made by Typst", "rotsolve.page.typst", binary=True),
        Format("html", (".html", ".htm"), "a page for a browser, with the formulas as MathML", "rotsolve.page.html"),
        Format("json", (".json",), "everything, for programs", "rotsolve.page.json", DATA),
    )
}


def format_named(name: str, language: str = ENGLISH) -> Format:
    """The format of that name, in a language; a KeyError names the ones there are."""
    if name not in FORMATS:
        raise KeyError(f"unknown format {name!r}: {', '.join(FORMATS)}")
    return FORMATS[name] if language == ENGLISH else replace(FORMATS[name], language=language)


def format_of_file(file: str) -> Format | None:
    """The format that goes by the file's name, if any."""
    lower = file.lower()
    return next((item for item in FORMATS.values() if lower.endswith(item.suffixes)), None)
