"""Sheets in LaTeX: heads with fields, questions with room, images of files beside, and the numbers of the pages of each sheet."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from rotsolve.page.blocks import PageBlock
from rotsolve.page.statement_blocks import LINE, HeadField, Image, PageBreak, Question, SheetHead
from rotsolve.page.tex import latex_prose

if TYPE_CHECKING:
    from rotsolve.page.printer import Lines, Printer

ARTICLE = "\\documentclass{article}"
MARGINS = "[margin=25mm]{geometry}"
IMAGES = r"""\usepackage{graphicx}
\makeatletter
\@ifundefined{KV@Gin@alt}{\define@key{Gin}{alt}{}}{} % older versions have no words for those who do not see an image
\newcommand{\atmostline}{\ifdim\Gin@nat@width>\linewidth\linewidth\else\Gin@nat@width\fi}
\makeatother
"""
FOOT = r"""\newcounter{sheet}
\makeatletter
\renewcommand{\@oddfoot}{\hfil\thepage\ / \pageref{end of sheet \thesheet}\hfil}
\renewcommand{\@evenfoot}{\@oddfoot}
\makeatother
"""


def on_latex_paper(preamble: str, paper: str) -> str:
    """What stands before the pages, for a paper, with the number of each page and how many a sheet has."""
    begin = "\\begin{document}\n"
    sized = preamble.replace(ARTICLE, f"\\documentclass[{paper}paper]{{article}}").replace(
        begin, f"{IMAGES}{FOOT}{begin}"
    )
    return sized.replace(MARGINS, f"[{paper}paper,margin=25mm]{{geometry}}")


def counted_sheet(body: str, number: int) -> str:
    """The pages of one sheet, counted from 1 on."""
    return f"\\setcounter{{page}}{{1}}\\setcounter{{sheet}}{{{number}}}\n{body}\\label{{end of sheet {number}}}\n"


class LatexSheets:
    """Sets the blocks of a sheet."""

    def __init__(self, printer: Printer) -> None:
        self.words, self.prose = printer.words, printer.prose

    def own(self) -> dict[type[PageBlock], Callable[[Any], Lines]]:
        return {SheetHead: self.head, Question: self.question, PageBreak: self.page_break, Image: self.image}

    def head(self, block: SheetHead) -> Iterator[str]:
        yield from (f"{self.prose(block.course)}\\par",) if block.course else ()
        yield rf"\section*{{{self.words(block.title)}}}"
        fields = r"\quad ".join(map(self.field, block.fields))
        yield from (rf"\noindent {fields}\par\bigskip", "") if fields else ()

    def field(self, field: HeadField) -> str:
        room = "70mm" if field.wide else "25mm"
        return rf"{self.prose(field.label)}~" + (self.prose(field.said) or rf"\underline{{\hspace{{{room}}}}}")

    def question(self, block: Question) -> Iterator[str]:
        yield r"\begin{samepage}"
        yield from (rf"{self.words(block.said)}\par",) if block.said else ()
        line = rf"\nopagebreak\vspace*{{{LINE - 1}mm}}\hrule\vspace*{{1mm}}"
        yield from [line] * block.lines
        if block.room and not block.lines:
            yield rf"\nopagebreak\vspace*{{{float(block.room):g}mm}}"
        yield from (r"\end{samepage}\penalty0", "")  # behind room a page could not end by itself

    def page_break(self, block: PageBreak) -> Iterator[str]:
        yield from (r"\clearpage", "")

    def image(self, block: Image) -> Iterator[str]:
        name = block.name.replace(".svg", ".pdf")
        said = rf"\includegraphics[width=\atmostline,keepaspectratio,alt={{{latex_prose(block.alt)}}}]{{{name}}}"
        yield from (r"\begin{center}", said, r"\end{center}", "")
