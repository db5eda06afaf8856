"""Readings: what students write, and how it is read: a table of lines, each with all its readings or with its fault."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest

from rotsolve.algebra.notation.tokens import FUNCTION_NAMES, SHORTEST
from rotsolve.grading.reading.answers import read_line
from rotsolve.grading.reading.records import AnswerError, LineReading, Names

TABLE = Path(__file__).parent / "readings.txt"
_LETTERS = "m m1 m2 M g R r L h k v theta theta0 beta omega omega0 t F I mu T b alpha tau"
GIVENS = _LETTERS.split()
SECTIONS = {
    "# answers": Names.of(GIVENS, ["a", "omega_f"], asked="a"),
    "# asked for omega_f": Names.of(GIVENS, ["a", "omega_f"], asked="omega_f"),
    "# working": Names.of(GIVENS, ["a", "omega_f"]),
    "# letters e, x and i": Names.of([*GIVENS, "e", "x", "i"], ["a"], asked="a"),
}


def shown(reading: LineReading) -> Iterator[str]:
    """A reading as lines: kind, echo, figures; components and remarks below."""
    figures = "" if reading.figures is None else f" [{reading.figures}]"
    yield f"  {reading.kind}: {reading.text}{figures}"
    for part in reading.parts:
        yield f"    part {part.kind}: {part.text}"
    for remark in reading.remarks:
        yield f"    remark {remark.kind} [{remark.start}:{remark.end}]: {''.join(map(str, remark.words))}"


def report(text: str, names: Names) -> str:
    """All readings of a line, or its fault with the columns and what stands there."""
    try:
        readings = read_line(text, names)
    except AnswerError as error:
        unknown = " (unknown)" if error.unknown else ""
        return f"  ! [{error.start}:{error.end}] `{text[error.start : error.end]}`{unknown}: {error}"
    return "\n".join(line for reading in readings for line in shown(reading))


def rows(text: str) -> Iterator[tuple[str, str, str]]:
    """Section, line and expected report of each block."""
    section = ""
    for block in text.strip().split("\n\n"):
        first, *rest = block.splitlines()
        if first.startswith("# "):
            section = first
        else:
            yield section, first.removeprefix("> "), "\n".join(rest)


ROWS = list(rows(TABLE.read_text(encoding="utf-8")))


def test_the_table_is_long() -> None:
    assert len(ROWS) >= 80


def test_table(regenerate: bool) -> None:
    """Read the table after `--regenerate`: it says what a student's line means."""
    found = [(section, text, report(text, SECTIONS[section])) for section, text, _ in ROWS]
    if regenerate:
        written, last = [], ""
        for section, text, result in found:
            written += [section] if section != last else []
            written.append(f"> {text}\n{result}")
            last = section
        TABLE.write_text("\n\n".join(written) + "\n", encoding="utf-8")
    wrong = [(row, result) for row, (_, _, result) in zip(ROWS, found, strict=True) if row[2] != result]
    assert not wrong or regenerate, "\n".join(f"> {row[1]}\n{row[2]}\nbut\n{result}" for row, result in wrong)


@pytest.mark.parametrize("function", sorted(name for name in FUNCTION_NAMES if len(name) < SHORTEST))
@pytest.mark.parametrize("form", ["{}", "2{}", "2 {}", "1/3{}^2", "-2.5 {}", "√2 {}"])
def test_a_run_of_letters_that_spells_a_function_is_letters(function: str, form: str) -> None:
    names = Names.of(function, ["a"], asked="a")
    formulas = [reading.formula for reading in read_line(form.format(function), names)]
    assert all(formula is not None and formula.symbols() == set(function) for formula in formulas)
