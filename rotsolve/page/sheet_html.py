"""Sheets in HTML: heads with fields, questions with room, images as data within the page, and the numbers of printed pages."""

from __future__ import annotations

from base64 import b64encode
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from rotsolve.page.blocks import PageBlock
from rotsolve.page.statement_blocks import LINE, HeadField, Image, PageBreak, Question, SheetHead

if TYPE_CHECKING:
    from rotsolve.page.printer import Lines, Printer

TYPES = {".png": "image/png", ".jpg": "image/jpeg", ".svg": "image/svg+xml"}
SIZES = {"a4": "A4", "letter": "letter"}
SHEET_STYLE = f"""\
@page {{ size: PAPER; margin: 20mm 20mm 22mm; @bottom-center {{ content: NUMBER; font: 9pt Georgia, serif; }} }}
p.course {{ margin: 0; color: #333; }}
p.fields {{ display: flex; gap: 1.5em; margin: .2em 0 1.6em; }}
.field {{ display: flex; flex: 1; gap: .5em; white-space: nowrap; }}
.field.wide {{ flex: 3; }}
.field i {{ flex: 1; border-bottom: .3mm solid #555; font-style: normal; }}
.question {{ break-inside: avoid; margin: .5em 0; }}
.question p {{ padding-left: 1.8em; text-indent: -1.8em; margin: 0; }}
.question p.alone {{ padding-left: 0; text-indent: 0; }}
.room i {{ display: block; height: {LINE}mm; border-bottom: .25mm solid #aaa; box-sizing: border-box; }}
.page-break {{ break-after: page; }}
figure img {{ max-width: 100%; }}
"""


def paper_style(paper: str, sheets: int) -> str:
    """The style of a sheet on paper: its size, and the number of each page, of how many where the pages are those of one sheet."""
    number = 'counter(page) " / " counter(pages)' if sheets == 1 else "counter(page)"
    return SHEET_STYLE.replace("PAPER", SIZES[paper]).replace("NUMBER", number)


class HtmlSheets:
    """Sets the blocks of a sheet."""

    def __init__(self, printer: Printer) -> None:
        self.words, self.prose = printer.words, printer.prose

    def own(self) -> dict[type[PageBlock], Callable[[Any], Lines]]:
        return {SheetHead: self.head, Question: self.question, PageBreak: self.page_break, Image: self.image}

    def head(self, block: SheetHead) -> Iterator[str]:
        yield "<header>"
        yield from (f'<p class="course">{self.prose(block.course)}</p>',) if block.course else ()
        yield f"<h1>{self.words(block.title)}</h1>"
        yield from (f'<p class="fields">{"".join(map(self.field, block.fields))}</p>',) if block.fields else ()
        yield "</header>"

    def field(self, field: HeadField) -> str:
        return f'<span class="field{" wide" * field.wide}">{self.prose(field.label)} <i>{self.prose(field.said)}</i></span>'

    def question(self, block: Question) -> Iterator[str]:
        yield '<div class="question">'
        kind = "" if block.label else ' class="alone"'
        yield from (f"<p{kind}>{self.words(block.said)}</p>",) if block.said else ()
        if block.lines:
            yield f'<div class="room">{"<i></i>" * block.lines}</div>'
        elif block.room:
            yield f'<div class="room" style="height: {float(block.room):g}mm"></div>'
        yield "</div>"

    def page_break(self, block: PageBreak) -> Iterator[str]:
        yield '<div class="page-break"></div>'

    def image(self, block: Image) -> Iterator[str]:
        data = b64encode(block.content() or b"").decode("ascii")
        yield f'<figure><img src="data:{TYPES[block.suffix]};base64,{data}" alt="{self.prose(block.alt)}"></figure>'
