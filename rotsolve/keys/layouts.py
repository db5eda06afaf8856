"""Layouts: how Markdown, LaTeX and HTML set the parts of a sheet or key. What is said is the same in all of them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from msgspec import Struct

from rotsolve.core.derivation import Answer
from rotsolve.render import html, latex, markdown
from rotsolve.render.voice import HTML, LATEX, MARKDOWN, Voice

Answers = Sequence[Answer]


class Layout(Struct, frozen=True):
    """One format: headings by their level, paragraphs with a label, answers to so many digits, a sheet, and a document of sheets."""

    voice: Voice
    heading: Callable[[int, str], str]
    paragraph: Callable[[str, str], str]
    answers: Callable[[Answers, int], Iterable[str]]
    sheet: Callable[[Iterable[str]], str]
    document: Callable[[Sequence[str]], str]


def markdown_paragraph(label: str, said: str) -> str:
    return f"**{label}:** {said}\n" if label else f"{said}\n"


def markdown_answers(answers: Answers, digits: int) -> Iterable[str]:
    for answer in answers:
        yield from markdown.answer_lines(answer, digits)
    yield ""


def latex_heading(level: int, said: str) -> str:
    return rf"\{'sub' * (level - 1)}section*{{{said}}}"


def latex_paragraph(label: str, said: str) -> str:
    return rf"\textbf{{{label}}}\quad {said}" + "\n" if label else f"{said}\n"


def latex_answers(answers: Answers, digits: int) -> Iterable[str]:
    return latex.align([row for answer in answers for row in latex.answer_rows(answer, digits)])


def html_paragraph(label: str, said: str) -> str:
    return html.labelled(label, [said], "") if label else f"<p>{said}</p>"


def joined(lines: Iterable[str]) -> str:
    return "\n".join(lines) + "\n"


LAYOUTS = {
    "markdown": Layout(
        MARKDOWN,
        lambda level, said: f"{'#' * level} {said}\n",
        markdown_paragraph,
        markdown_answers,
        joined,
        markdown.document,
    ),
    "latex": Layout(LATEX, latex_heading, latex_paragraph, latex_answers, joined, latex.document),
    "html": Layout(
        HTML,
        lambda level, said: f"<h{level}>{said}</h{level}>",
        html_paragraph,
        html.answer_table,
        html.article,
        html.document,
    ),
}
