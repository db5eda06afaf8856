"""Tables: sheets and keys for programs: JSON, and CSV for spreadsheets, in which no cell can be a formula."""

from __future__ import annotations

import csv
import io
from collections.abc import Iterable, Iterator
from typing import Any

from rotsolve.core.derivation import Answer
from rotsolve.keys.sheets import Sheet
from rotsolve.keys.statement import Statement, statement
from rotsolve.keys.working import Worked
from rotsolve.render.json import answer_data, given_data
from rotsolve.render.layout import release
from rotsolve.render.voice import TEXT
from rotsolve.run.delivery import harmless

PROBLEM_COLUMNS = ("variant", "problem", "title", "text", "given", "find", "positive")
ANSWER_COLUMNS = ("variant", "problem", "given", "answer", "value", "unit", "direction", "word", "exact", "note")


def plain(worked: Worked) -> Statement:
    """What a problem says, as plain text."""
    said = statement(worked, TEXT)
    lists = (tuple(map(release, items)) for items in (said.text, said.givens, said.finds, said.positive))
    return Statement(release(said.title), *lists)


def problems_data(sheet: Sheet) -> dict[str, Any]:
    """The statements of one variant."""
    said = [(name, plain(worked)) for name, worked in sheet.problems]
    return marked(sheet, [{"problem": name, **statement_data(item)} for name, item in said])


def statement_data(said: Statement) -> dict[str, Any]:
    lists = {"given": said.givens, "find": said.finds, "positive": said.positive}
    return {"title": said.title, "text": "\n".join(said.text), **{key: list(items) for key, items in lists.items()}}


def key_data(sheet: Sheet, digits: int) -> dict[str, Any]:
    """The answers of one variant, as `rotsolve solve --format json` gives them."""
    return marked(
        sheet,
        [
            {
                "problem": name,
                "title": worked.problem.title,
                "given": [given_data(given) for given in worked.shown()],
                "answers": [answer_data(answer, digits) for answer in worked.answers],
            }
            for name, worked in sheet.problems
        ],
    )


def marked(sheet: Sheet, problems: list[dict[str, Any]]) -> dict[str, Any]:
    """The problems with the number of their variant."""
    return {**({"variant": sheet.variant, "seed": sheet.seed} if sheet.variant else {}), "problems": problems}


def problem_rows(sheet: Sheet) -> Iterator[tuple[str, ...]]:
    """The statements of one variant, a row each."""
    for name, worked in sheet.problems:
        said = plain(worked)
        lists = (" ".join(said.text), *("; ".join(items) for items in (said.givens, said.finds, said.positive)))
        yield (str(sheet.variant or ""), name, said.title, *lists)


def answer_rows(sheet: Sheet, digits: int) -> Iterator[tuple[str, ...]]:
    """The answers of one variant, a row each; the components of a vector have rows of their own behind it."""
    for name, worked in sheet.problems:
        givens = "; ".join(release(TEXT.given(given)) for given in worked.shown())
        for label, answer in named(worked.answers):
            data = answer_data(answer, digits)
            exact = data["exact"]["text"] if data["exact"] else ""
            cells = (label, data["value"] or "", data["unit"], data["direction"], data["word"], exact, data["note"])
            yield (str(sheet.variant or ""), name, givens, *cells)


def named(answers: Iterable[Answer], whole: str = "") -> Iterator[tuple[str, Answer]]:
    """The answers with their components, which take the name of their vector or matrix in front."""
    for answer in answers:
        label = f"{whole}.{answer.name.removeprefix(f'{whole}_')}" if whole else answer.name
        if not answer.rows:
            yield label, answer
        yield from named(answer.components, label)


def table(columns: tuple[str, ...], rows: Iterable[tuple[str, ...]]) -> str:
    """Comma-separated values with their heading."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows(tuple(map(harmless, row)) for row in rows)
    return stream.getvalue()
