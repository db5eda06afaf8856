"""Markdown: headings and lists, with the formulas as LaTeX between dollar signs, as notebooks and web pages show them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rotsolve.core.derivation import Answer, Derivation, ForceLine, LawLine, Move, Section
from rotsolve.render.matrix import latex_matrix
from rotsolve.render.options import Options
from rotsolve.render.prose import MARKDOWN
from rotsolve.render.voice import exact, lettered, shown, shown_components


def body(derivation: Derivation, options: Options) -> str:
    """The whole derivation as Markdown."""
    return "\n".join(lines(derivation, options)) + "\n"


def document(bodies: Sequence[str]) -> str:
    """Several derivations with a rule between two."""
    return "\n---\n\n".join(bodies)


def lines(derivation: Derivation, options: Options) -> Iterator[str]:
    """The derivation line by line."""
    if derivation.title:
        yield f"# {MARKDOWN.prose(derivation.title)}"
        yield ""
    yield from opening(derivation)
    for section in derivation.sections:
        if section.title:
            yield f"## {MARKDOWN.prose(section.title)}"
            yield ""
        yield from section_lines(section, "###" if section.title else "##")
    yield "## Answers"
    yield ""
    for answer in derivation.answers:
        yield from answer_lines(answer, options.digits)
    yield from check_lines(derivation)


def opening(derivation: Derivation) -> Iterator[str]:
    """Source, givens, conventions, what is asked and the states, a paragraph each."""
    givens = [MARKDOWN.math(MARKDOWN.given(given)) for given in shown(derivation.givens)]
    parts = (
        ("Source", [MARKDOWN.prose(derivation.source)] if derivation.source else [], ""),
        ("Given", givens, ", "),
        ("Signs", [MARKDOWN.words(words) for words in derivation.conventions], "; "),
        ("Find", [MARKDOWN.words(words) for words in derivation.finds], ", " if lettered(derivation.finds) else "; "),
        ("States", [MARKDOWN.words(words) for words in derivation.states], "; "),
    )
    for label, items, separator in parts:
        if items:
            yield f"**{label}:** {separator.join(items)}"
            yield ""


def section_lines(section: Section, level: str) -> Iterator[str]:
    """Forces, laws and algebra, each under a heading of the given level."""
    if section.forces:
        yield from (f"{level} Forces", "", *map(force_line, section.forces), "")
    if section.remarks or section.laws:
        yield from (f"{level} Laws", "")
        for remark in section.remarks:
            yield from (MARKDOWN.words(remark), "")
        if section.laws:
            yield from (*map(law_line, section.laws), "")
    if section.moves:
        yield from (f"{level} Solve", "", *map(move_line, section.moves), "")


def force_line(line: ForceLine) -> str:
    said = "; ".join(MARKDOWN.words(words) for words in line.forces)
    positive = f" — positive: {MARKDOWN.prose(line.positive)}" if line.positive else ""
    remarks = f" ({'; '.join(MARKDOWN.words(words) for words in line.remarks)})" if line.remarks else ""
    return f"- **{MARKDOWN.prose(line.body)}**: {said}{positive}{remarks}"


def law_line(law: LawLine) -> str:
    remark = f" ({MARKDOWN.words(law.remark)})" if law.remark else ""
    return f"- ({law.number}) {MARKDOWN.prose(law.law)}: {MARKDOWN.math(MARKDOWN.equality(law.equation))}{remark}"


def move_line(move: Move) -> str:
    """One step: where it comes from, its chain of equalities, its number."""
    reason = MARKDOWN.words(move.reason)
    start = MARKDOWN.prose(move.sources) or reason
    chain = r" $\;\to\;$ ".join(MARKDOWN.math(MARKDOWN.equality(equality)) for equality in move.chain)
    number = f" ({move.number})" if move.number is not None else ""
    behind = f" ({reason})" if reason and move.sources else ""
    return f"- {start}: {chain}{number}{behind}" if start else f"- {chain}{number}{behind}"


def answer_lines(answer: Answer, digits: int, inset: str = "") -> Iterator[str]:
    """An answer and, as a list within the list, its components."""
    if answer.rows:
        yield f"{inset}- {MARKDOWN.math(latex_matrix(answer, MARKDOWN, digits))}{MARKDOWN.aside(answer, digits)}"
        return
    formula, amount = exact(answer), MARKDOWN.amount(answer, digits)
    parts = [MARKDOWN.formula(answer.symbol), *([MARKDOWN.formula(formula)] if formula is not None else [])]
    parts += [amount] if amount else []
    yield f"{inset}- {MARKDOWN.math(' = '.join(parts))}{MARKDOWN.aside(answer, digits)}"
    for component in shown_components(answer):
        yield from answer_lines(component, digits, inset + "  ")


def check_lines(derivation: Derivation) -> Iterator[str]:
    """The checks as a list; what does not hold is said in bold."""
    if not derivation.checks:
        return
    yield from ("", "## Checks", "")
    verdicts = {True: "", False: "**does not hold:** ", None: "**not decided:** "}
    for check in derivation.checks:
        yield f"- {verdicts[check.holds]}{MARKDOWN.words(check.words)}"
