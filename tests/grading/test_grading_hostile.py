"""Hostile and random lines: an answer or a fault at its columns, in milliseconds, and never anything else."""

from __future__ import annotations

import time
from pathlib import Path

import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from rotsolve.algebra.exact.normal import equal
from rotsolve.algebra.formula import Formula
from rotsolve.algebra.notation.text import to_text
from rotsolve.grading.marking.judge import Judge
from rotsolve.grading.reading.answers import read_line
from rotsolve.grading.reading.records import AnswerError, LineReading, Names
from rotsolve.grading.verdict import RIGHT, UNDECIDED, WRONG, Paper
from rotsolve.pipeline import solve

PROBLEM = Path(__file__).resolve().parents[2] / "problems" / "pulleys" / "block-on-disc.yaml"

GIVENS = ["m", "m1", "M", "g", "R", "r", "L", "h", "k", "v", "theta", "omega", "omega0", "t", "F", "I"]
NAMES = Names.of(GIVENS, ["a"], asked="a")
WORKING = Names.of(GIVENS, ["a"])

_PIECES = r"""
m M g R θ ω₀ \omega_0 omega_0 m_1 m1 2 1/2 ½ 3.5 1e3 π \pi + - − * · / ^ ^2 ² ( ) [ ] { } | √ sin cos tan ln e exp sqrt
\frac \frac12 \sqrt \sqrt[3] \sin \theta \cdot \left( \right) \, \text{m} \mathrm ^\circ ° , ; . = ≈ < i j N m/s² rpm kg Nm
at above horizontal left down slips x _ a \begin{pmatrix} \end{pmatrix} \\ $ → ∫ 4,36 12,000 \
"""
PIECES = _PIECES.split()
LINES = st.lists(st.sampled_from([*PIECES, " ", "  "]), max_size=14).map("".join)
ATOMS = st.sampled_from(["m", "g", "R", "θ", "ω₀", "2", "3.5", "1/2", "½", "π", "(m + M)", "√2", "sin θ", "k²"])

HOSTILE = (
    "9**9**9**9",
    "9^(9^(9^9))",
    "m^(10^9)",
    "m^99999999999999",
    "(((m^64)^64)^64)",
    "1e999999999 N",
    "10^(10^10)",
    "(" * 10_000,
    "(" * 300 + "m" + ")" * 300,
    "{" * 500,
    "\\frac{" * 100,
    "\\sqrt{" * 90 + "m" + "}" * 90,
    "-" * 500 + "m",
    "m/" * 290 + "m",
    "√" * 500 + "m",
    "sin " * 140 + "θ",
    "m^" * 200 + "m",
    "1/2m" * 140,
    "sin θ/" * 90 + "2",
    "√2g/" * 140 + "2",
    "°" * 500,
    "5" + "°" * 500,
    "m" * 600,
    "mx" * 300,
    "x" * 10_000,
    "9" * 599,
    "1," * 299,
    "3i + " * 110 + "3i",
    "(3, " * 140,
    "5 N at " * 80 + "°",
    "5 N, " + "above " * 90 + "x °",
    "a = " * 140,
    "__import__('os').system('rm -rf /')",
    "lambda: 0",
    "eval(open('x').read())",
    "{{7*7}}",
    "=cmd|' /C calc'!A0",
    "\x00\x01\x02",
    "\u202em g",
    "m\n\n\ng",
    "🙂",
    "ﬁ" * 500,
    "\\" * 600,
    "_" * 600,
    "Ω" * 600,
    "𝑚𝑔",
    "m" + "\u0301" * 300,
)


def outcome(text: str, names: Names) -> tuple[LineReading, ...] | AnswerError:
    try:
        readings = read_line(text, names)
    except AnswerError as error:
        assert 0 <= error.start <= error.end <= max(len(text), error.start), (error.start, error.end)
        assert error.message
        return error
    assert readings
    return readings


@pytest.mark.parametrize("text", HOSTILE, ids=lambda text: ascii(text[:24]))
@pytest.mark.parametrize("names", [NAMES, WORKING], ids=["answer", "working"])
def test_hostile_lines_take_milliseconds(text: str, names: Names) -> None:
    def spent() -> float:
        start = time.process_time()
        outcome(text, names)
        return time.process_time() - start

    assert min(spent() for _ in range(3)) < 0.5  # of processor time, on a machine that has other work too


@settings(max_examples=600, deadline=None)
@given(LINES)
@example("sin^")
@example("e^")
@example("\\sqrt[3]")
def test_random_lines(text: str) -> None:
    for names in (NAMES, WORKING):
        outcome(text, names)


@settings(max_examples=300, deadline=None)
@given(st.text(max_size=60))
def test_any_text(text: str) -> None:
    outcome(text, NAMES)


def formulas() -> st.SearchStrategy[str]:
    """Formulas in the notation of students, with all that can be read in two ways."""
    return st.recursive(
        ATOMS,
        lambda inner: st.one_of(
            st.tuples(inner, st.sampled_from(["", " ", "·", "/", " / ", " + ", " - "]), inner).map("".join),
            st.tuples(st.sampled_from(["sin ", "√", "cos", "ln ", "-"]), inner).map("".join),
            st.tuples(inner, st.sampled_from(["^2", "²", "^-1", "^1/2", "°"])).map("".join),
            inner.map("({})".format),
            st.tuples(inner, inner).map(lambda pair: f"\\frac{{{pair[0]}}}{{{pair[1]}}}"),
        ),
        max_leaves=8,
    )


@settings(max_examples=800, deadline=None)
@given(formulas())
def test_what_is_printed_is_read_again(text: str) -> None:
    """The echo of a formula has that formula as its likeliest reading."""
    found = outcome(text, NAMES)
    for reading in found if not isinstance(found, AnswerError) else ():
        if reading.kind == "formula" and reading.formula is not None:
            echo = to_text(reading.formula)
            again = next(item.formula for item in read_line(echo, NAMES) if item.kind == "formula")
            assert again is not None
            alike = agree(reading.formula, again)
            assert alike or (alike is None and to_text(again) == echo), echo


def agree(one: Formula, other: Formula) -> bool | None:
    """Whether two formulas are equal; None for 1/0 and what else is beyond the exact layer."""
    try:
        return equal(one, other)
    except (ZeroDivisionError, ValueError):
        return None


WORDY = (
    " (" * 290,
    ", " * 280 + "g = 9",
    "( , ; ( " * 70 + "g = 9",
    "with " * 110 + "g = 9",
    "2 m " * 140,
    "5 kg*" * 110 + "2 m",
    "1 + " * 140 + "9.81",
    "9.81 + " * 80 + "m",
    "10-3*" * 110 + "1",
    "a = " * 140,
    "a = " + "3 = " * 140 + "4.36 m/s²",
    "→ " * 290,
    "2g → " * 110 + "2 g",
    "about " * 90 + "3",
    "3 " + "± 1" * 190,
    "sin(30) + " * 55 + "g",
    "\n" * 500 + "3",
    "g (2 m) " * 70,
)


@pytest.mark.parametrize("text", [*HOSTILE, *WORDY], ids=range(len(HOSTILE) + len(WORDY)))
def test_no_line_keeps_the_judge(judge: Judge, text: str) -> None:
    """Every way to read and to explain a line ends soon, and in a verdict."""
    began = time.process_time()
    (part,) = (part for part in judge.mark(Paper("one", {"a": text})).parts if part.name == "a")
    assert part.verdict.outcome in (RIGHT, WRONG, UNDECIDED)
    assert time.process_time() - began < 1.5  # most take milliseconds


@pytest.fixture(scope="module")
def judge() -> Judge:
    found = Judge(solve(PROBLEM))
    found.mark(Paper("one", {"a": "2 g"}))  # its mistakes are solved once
    return found
