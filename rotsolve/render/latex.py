"""LaTeX: a complete article that any LaTeX compiles, or the body alone for a document of one's own."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rotsolve.core.derivation import Answer, Derivation, Equality, ForceLine, LawLine, Move, Section
from rotsolve.render.matrix import latex_matrix
from rotsolve.render.options import Options
from rotsolve.render.prose import LATEX
from rotsolve.render.voice import exact, lettered, shown, shown_components

PREAMBLE = r"""\documentclass{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{textcomp}
\usepackage{amsmath,amssymb}
\usepackage[margin=25mm]{geometry}
\setlength{\parindent}{0pt}
\setlength{\parskip}{6pt}
\allowdisplaybreaks
\begin{document}
"""
END = "\\end{document}\n"


def body(derivation: Derivation, options: Options) -> str:
    """The derivation for the inside of a document that uses amsmath."""
    return "\n".join(lines(derivation, options)) + "\n"


def document(bodies: Sequence[str]) -> str:
    """A complete document, each derivation on a page of its own."""
    return PREAMBLE + "\\clearpage\n".join(bodies) + END


def lines(derivation: Derivation, options: Options) -> Iterator[str]:
    """The derivation line by line."""
    if derivation.title:
        yield rf"\section*{{{LATEX.prose(derivation.title)}}}"
    yield from opening(derivation)
    for section in derivation.sections:
        if section.title:
            yield rf"\subsection*{{{LATEX.prose(section.title)}}}"
        yield from section_lines(section)
    if derivation.answers:
        yield r"\subsection*{Answers}"
        rows = [row for answer in derivation.answers for row in answer_rows(answer, options.digits)]
        yield from align(rows)
    if derivation.checks:
        yield r"\subsection*{Checks}"
        yield from itemize(check_items(derivation))


def opening(derivation: Derivation) -> Iterator[str]:
    """Source, givens, conventions, what is asked and the states, a paragraph each."""
    parts = (
        ("Source", [LATEX.prose(derivation.source)] if derivation.source else [], ""),
        ("Given", [LATEX.math(LATEX.given(given)) for given in shown(derivation.givens)], ", "),
        ("Signs", [LATEX.words(words) for words in derivation.conventions], "; "),
        ("Find", [LATEX.words(words) for words in derivation.finds], ", " if lettered(derivation.finds) else "; "),
        ("States", [LATEX.words(words) for words in derivation.states], "; "),
    )
    for label, items, separator in parts:
        if items:
            yield rf"\textbf{{{label}}}\quad {separator.join(items)}"
            yield ""


def section_lines(section: Section) -> Iterator[str]:
    """Forces, laws and algebra."""
    if section.forces:
        yield r"\textbf{Forces}"
        yield from itemize([force_item(line) for line in section.forces])
    if section.remarks or section.laws:
        yield r"\textbf{Laws}"
        for remark in section.remarks:
            yield from ("", LATEX.words(remark))
        yield from align([law_row(law) for law in section.laws])
    if section.moves:
        yield r"\textbf{Solve}"
        yield from align([row for move in section.moves for row in move_rows(move)])


def itemize(items: Sequence[str]) -> Iterator[str]:
    """A list."""
    yield r"\begin{itemize}"
    yield from (rf"  \item {item}" for item in items)
    yield r"\end{itemize}"


def align(rows: Sequence[str]) -> Iterator[str]:
    """Equations aligned at their signs, with the words behind them."""
    if rows:
        yield r"\begin{align*}"
        yield " \\\\\n".join(f"  {row}" for row in rows)
        yield r"\end{align*}"


def force_item(line: ForceLine) -> str:
    said = "; ".join(LATEX.words(words) for words in line.forces)
    positive = f" --- positive: {LATEX.prose(line.positive)}" if line.positive else ""
    remarks = f" ({'; '.join(LATEX.words(words) for words in line.remarks)})" if line.remarks else ""
    return rf"\emph{{{LATEX.prose(line.body)}}}: {said}{positive}{remarks}"


def law_row(law: LawLine) -> str:
    remark = f" ({LATEX.words(law.remark)})" if law.remark else ""
    return rf"{sides(law.equation)}{words_cell(LATEX.prose(law.law) + remark)} \tag{{{law.number}}}"


def move_rows(move: Move) -> Iterator[str]:
    """One row for each equality of the step: the first says where it comes from, the last has the number."""
    said = join_words(move)
    for number, equality in enumerate(move.chain):
        arrow = r"\Longrightarrow\quad " if number else ""
        tag = rf" \tag{{{move.number}}}" if move.number is not None and number == len(move.chain) - 1 else ""
        yield arrow + sides(equality) + ("" if number or not said else words_cell(said)) + tag


def join_words(move: Move) -> str:
    """Where a step comes from and why, as words."""
    return ": ".join(filter(None, (LATEX.prose(move.sources), LATEX.words(move.reason))))


def sides(equality: Equality) -> str:
    left, right = LATEX.sides(equality)
    return f"{left} &{right}"


def words_cell(text: str) -> str:
    """Words behind an equation, wrapped where they are long."""
    return rf" && \parbox[t]{{0.4\linewidth}}{{\raggedright {text}}}" if len(text) > 40 else rf" && \text{{{text}}}"


def answer_rows(answer: Answer, digits: int) -> Iterator[str]:
    """An answer and its components, one row each."""
    if answer.rows:
        symbol, sides = latex_matrix(answer, LATEX, digits).split(" = ", 1)
        said = LATEX.words(answer.remark)
        yield f"{symbol} &= {sides}" + (words_cell(f"({said})") if said else "")
        return
    formula, amount = exact(answer), LATEX.amount(answer, digits)
    parts = [LATEX.formula(formula)] if formula is not None else []
    parts += [amount] if amount else []
    aside = LATEX.aside(answer, digits)
    symbol = LATEX.formula(answer.symbol)
    shown_sides = f"{symbol} &= {' = '.join(parts)}" if parts else f"{symbol} &"
    yield shown_sides + (words_cell(aside.removeprefix(", ").strip()) if aside else "")
    for component in shown_components(answer):
        yield from answer_rows(component, digits)


def check_items(derivation: Derivation) -> list[str]:
    """The checks as sentences; what does not hold is said in bold."""
    verdicts = {True: "", False: r"\textbf{does not hold:} ", None: r"\textbf{not decided:} "}
    return [verdicts[check.holds] + LATEX.words(check.words) for check in derivation.checks]
