"""Sheets in Typst: heads with fields, questions with room, images of files beside, and the numbers of the pages of each sheet."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from rotsolve.algebra.notation.typst import typst_string
from rotsolve.page.blocks import PageBlock
from rotsolve.page.statement_blocks import LINE, HeadField, Image, PageBreak, Question, SheetHead

if TYPE_CHECKING:
    from rotsolve.page.printer import Lines, Printer

PAPERS = {"a4": "a4", "letter": "us-letter"}
A4_PAPER, NUMBERED = 'paper: "a4"', 'numbering: "1")'
FOOT = """\
footer: context {
  let ends = query(<end-of-sheet>).filter(end => end.location().page() >= here().page())
  align(center, counter(page).display() + [ \\/ ] + str(counter(page).at(ends.first().location()).first()))
})"""  # the number of a page, and of how many of its sheet
SHEET_LAYOUT = f"""\
// The head of a sheet, with fields: a label, and what stands in it or a line to fill in.
#let sheet-head(course, title, ..fields) = {{
  if course != [] {{ block(below: 0.8em, course) }}
  title
  let widths = fields.pos().map(field => if field.said != [] {{ auto }} else if field.wide {{ 3fr }} else {{ 1fr }})
  let blank = box(width: 1fr, line(length: 100%, stroke: 0.5pt))
  let cells = fields.pos().map(field => {{
    let label = field.label + h(0.5em)
    if field.said == [] {{ box(width: 100%, label + blank) }} else {{ label + field.said }}
  }})
  if cells.len() > 0 {{ block(below: 1.6em, grid(columns: widths, column-gutter: 1.5em, ..cells)) }}
}}

// What is asked, with its label before it, and room for the answer: a height, or a number of lines.
#let question(label, said, room: 0mm, lines: 0) = block(breakable: false, above: 0.9em, below: 0.9em, {{
  if said != [] {{ if label == [] {{ said }} else {{ grid(columns: (1.8em, 1fr), label, said) }} }}
  let rule = box(height: {LINE}mm, align(bottom, line(length: 100%, stroke: 0.4pt + luma(160))))
  if lines > 0 {{ stack(..range(lines).map(_ => rule)) }} else {{ v(room) }}
}})

"""


def on_typst_paper(layout: str, paper: str) -> str:
    """The layout of a document for a paper, with the functions that set a sheet, and the numbers of its pages."""
    sized = layout.replace(A4_PAPER, f'paper: "{PAPERS[paper]}"', 1)
    return sized.replace(NUMBERED, FOOT, 1) + SHEET_LAYOUT


def counted_sheet_in_typst(body: str) -> str:
    """The pages of one sheet, counted from 1 on."""
    return f"#counter(page).update(1)\n{body}\n#metadata(none) <end-of-sheet>\n"


class TypstSheets:
    """Sets the blocks of a sheet."""

    def __init__(self, printer: Printer) -> None:
        self.words, self.prose = printer.words, printer.prose

    def own(self) -> dict[type[PageBlock], Callable[[Any], Lines]]:
        return {SheetHead: self.head, Question: self.question, PageBreak: self.page_break, Image: self.image}

    def head(self, block: SheetHead) -> Iterator[str]:
        yield f"#sheet-head([{self.prose(block.course)}], ["
        yield f"= {self.words(block.title)}"
        yield f"]{''.join(map(self.field, block.fields))})"
        yield ""

    def field(self, field: HeadField) -> str:
        return (
            f", (label: [{self.prose(field.label)}], said: [{self.prose(field.said)}], wide: {str(field.wide).lower()})"
        )

    def question(self, block: Question) -> Iterator[str]:
        label = f"({block.label})" if block.label else ""
        said = self.words(block.said if not label else block.said[1:])
        yield f"#question([{label}], [{said}], room: {float(block.room):g}mm, lines: {block.lines})"
        yield ""

    def page_break(self, block: PageBreak) -> Iterator[str]:
        yield from ("#pagebreak(weak: true)", "")

    def image(self, block: Image) -> Iterator[str]:
        said = f"image({typst_string(block.name)}, alt: {typst_string(block.alt)})"
        yield from (f"#align(center, block(above: 0.8em, below: 1.2em, {said}))", "")
