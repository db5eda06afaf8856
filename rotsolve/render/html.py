"""HTML: a page that a browser shows without a network or a script, its formulas as MathML, its style sheet within, fit for printing."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

from rotsolve.core.derivation import Answer, Derivation, ForceLine, LawLine, Move, Section, Words
from rotsolve.render.matrix import mathml_matrix
from rotsolve.render.options import Options
from rotsolve.render.voice import HTML, exact, lettered, shown, shown_components

STYLE = """\
body { font: 11.5pt/1.5 Georgia, "Times New Roman", serif; color: #111; background: #fff; }
body { max-width: 50em; margin: 1.5em auto; padding: 0 1em; }
math { font-family: "STIX Two Math", "Latin Modern Math", "Cambria Math", math; }
h1, h2, h3 { line-height: 1.25; break-after: avoid; }
h1 { font-size: 1.5em; margin: 0 0 .6em; }
h2 { font-size: 1.15em; margin: 1.3em 0 .4em; border-bottom: 1px solid #bbb; }
h3 { font-size: 1em; margin: 1em 0 .3em; }
p, ul { margin: .4em 0; }
table { border-collapse: collapse; margin: .3em 0; }
td { padding: .25em .6em .25em 0; vertical-align: baseline; }
td.left { text-align: right; padding-right: .1em; white-space: nowrap; }
td.right { padding-right: 1.2em; white-space: nowrap; }
td.said { color: #333; min-width: 8em; }
td.then { text-align: right; }
td.left math, td.right math { math-style: normal; }
tr { break-inside: avoid; }
.wide { overflow-x: auto; }
.label { font-weight: bold; margin-right: .5em; }
.fault { font-weight: bold; color: #a00; }
article + article { break-before: page; border-top: 2px solid #888; margin-top: 3em; padding-top: 2em; }
@media print {
  body { margin: 0; max-width: none; font-size: 10.5pt; }
  .wide { overflow: visible; }
  article + article { border: 0; margin: 0; padding: 0; }
}
"""
HEADING = re.compile(r"<h1>(.*?)</h1>")


def body(derivation: Derivation, options: Options) -> str:
    """The derivation as an article for the inside of a page."""
    return article(lines(derivation, options))


def document(bodies: Sequence[str]) -> str:
    """A page of several articles, each printed on a sheet of its own; it has the title of the first."""
    found = HEADING.search(bodies[0]) if bodies else None
    return page(found[1] if found else "rotsolve", bodies)


def page(title: str, bodies: Iterable[str], style: str = "") -> str:
    """A complete page; the title has been made safe already. `style` goes behind the style sheet of all pages."""
    head = (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
    )
    styled = f"{head}<title>{title}</title>\n<style>\n{STYLE}{style}</style>\n</head>\n"
    return f"{styled}<body>\n{''.join(bodies)}</body>\n</html>\n"


def article(inner: Iterable[str]) -> str:
    """What belongs together, and is printed on a sheet of its own."""
    return "\n".join(("<article>", *inner, "</article>")) + "\n"


def lines(derivation: Derivation, options: Options) -> Iterator[str]:
    """The derivation line by line."""
    if derivation.title:
        yield f"<h1>{HTML.prose(derivation.title)}</h1>"
    yield from opening(derivation)
    for section in derivation.sections:
        if section.title:
            yield f"<h2>{HTML.prose(section.title)}</h2>"
        yield from section_lines(section, "h3" if section.title else "h2")
    if derivation.answers:
        yield "<h2>Answers</h2>"
        yield from answer_table(derivation.answers, options.digits)
    if derivation.checks:
        yield "<h2>Checks</h2>"
        yield from items(check_items(derivation))


def opening(derivation: Derivation) -> Iterator[str]:
    """Source, givens, conventions, what is asked and the states, a paragraph each."""
    if derivation.source:
        yield labelled("Source", [HTML.prose(derivation.source)], "")
    yield labelled("Given", [HTML.math(HTML.given(given)) for given in shown(derivation.givens)], ", ")
    yield labelled("Signs", map(HTML.words, derivation.conventions), "; ")
    yield labelled("Find", map(HTML.words, derivation.finds), ", " if lettered(derivation.finds) else "; ")
    yield labelled("States", map(HTML.words, derivation.states), "; ")


def labelled(label: str, said: Iterable[str], separator: str) -> str:
    """A paragraph with its label in front; nothing where there is nothing to say."""
    text = separator.join(said)
    return f'<p><span class="label">{label}</span>{text}</p>' if text else ""


def section_lines(section: Section, heading: str) -> Iterator[str]:
    """Forces, laws and algebra, each under a heading of the given level."""
    if section.forces:
        yield f"<{heading}>Forces</{heading}>"
        yield from items(map(force_item, section.forces))
    if section.remarks or section.laws:
        yield f"<{heading}>Laws</{heading}>"
        yield from (f"<p>{HTML.words(remark)}</p>" for remark in section.remarks)
        yield from table(map(law_row, section.laws))
    if section.moves:
        yield f"<{heading}>Solve</{heading}>"
        yield from table(row for move in section.moves for row in move_rows(move))


def items(said: Iterable[str]) -> Iterator[str]:
    """A list."""
    yield "<ul>"
    yield from (f"<li>{item}</li>" for item in said)
    yield "</ul>"


def table(rows: Iterable[str]) -> Iterator[str]:
    """Rows with their columns aligned; a wide table can be scrolled by itself."""
    found = list(rows)
    if found:
        yield '<div class="wide"><table>'
        yield from (f"<tr>{row}</tr>" for row in found)
        yield "</table></div>"


def equation_cells(left: str, right: str) -> str:
    """Both sides of an equation in two cells, so that the signs stand below each other."""
    return f'<td class="left">{HTML.math(left) if left else ""}</td>{number_cell(right)}'


def number_cell(inner: str) -> str:
    """Mathematics that begins with its sign."""
    return f'<td class="right">{HTML.math(inner) if inner else ""}</td>'


def said_cell(said: str, kind: str = "said") -> str:
    return f'<td class="{kind}">{said}</td>'


def force_item(line: ForceLine) -> str:
    said = "; ".join(map(HTML.words, line.forces))
    positive = f" — positive: {HTML.prose(line.positive)}" if line.positive else ""
    remarks = f" ({'; '.join(map(HTML.words, line.remarks))})" if line.remarks else ""
    return f"<b>{HTML.prose(line.body)}</b>: {said}{positive}{remarks}"


def law_row(law: LawLine) -> str:
    remark = f" ({HTML.words(law.remark)})" if law.remark else ""
    said = said_cell(HTML.prose(law.law) + remark)
    return f"<td>({law.number})</td>{said}{equation_cells(*HTML.sides(law.equation))}"


def move_rows(move: Move) -> Iterator[str]:
    """A row for each equality of the step: the first says where it comes from, the last has the number."""
    for number, equality in enumerate(move.chain):
        last = number == len(move.chain) - 1
        mark = f"({move.number})" if last and move.number is not None else ""
        said = said_cell("→", "then") if number else said_cell(source(move.sources, move.reason))
        yield f"{said}{equation_cells(*HTML.sides(equality))}<td>{mark}</td>"


def source(sources: str, reason: Words) -> str:
    """Where a step comes from and why, as words."""
    return ": ".join(filter(None, (HTML.prose(sources), HTML.words(reason))))


def answer_table(answers: Iterable[Answer], digits: int) -> Iterator[str]:
    """The answers with their exact forms and certified numbers, a row each, and the components of vectors below them."""
    yield from table(row for answer in answers for row in answer_rows(answer, digits))


def answer_rows(answer: Answer, digits: int) -> Iterator[str]:
    """An answer and its components; of a matrix the numbers stand below the exact entries."""
    equals = HTML.relation("=")
    symbol = HTML.formula(answer.symbol)
    said = said_cell(HTML.aside(answer, digits).removeprefix(", ").strip())
    if answer.rows:
        boxes = [equals + box for box in mathml_matrix(answer, HTML, digits)]
        for number, box in enumerate(boxes):
            cells = equation_cells(symbol if not number else "", box)
            yield f"{cells}<td></td>{said if number == len(boxes) - 1 else ''}"
        return
    formula, amount = exact(answer), HTML.amount(answer, digits)
    sides = [equals + HTML.formula(formula)] if formula is not None else []
    sides += [equals + amount] if amount else []
    first, second = (*sides, "", "")[:2]
    yield f"{equation_cells(symbol, first)}{number_cell(second)}{said}"
    for component in shown_components(answer):
        yield from answer_rows(component, digits)


def check_items(derivation: Derivation) -> Iterator[str]:
    """The checks as sentences; what does not hold is said in bold."""
    verdicts = {True: "", False: "does not hold", None: "not decided"}
    for check in derivation.checks:
        mark = verdicts[check.holds]
        yield (f'<span class="fault">{mark}:</span> ' if mark else "") + HTML.words(check.words)
