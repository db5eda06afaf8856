"""Definitions: letters to which a student gives a meaning, `let h = L sin θ`, `…, with I = ½ M R²`, `… for M = 0`.

A letter that the scene has too means what the student says in the statement in which that stands.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence

from msgspec import Struct

from rotsolve.algebra.formula import Formula
from rotsolve.algebra.notation.letters import GREEK_LETTERS, spellings
from rotsolve.algebra.notation.tokens import FormulaError
from rotsolve.algebra.units.dimension import Dimension, DimensionError, dimension_of
from rotsolve.grading.reading.answers import read_line, si_formula
from rotsolve.grading.reading.prose import JOIN, JOINING
from rotsolve.grading.reading.records import FORMULA, NUMBER, AnswerError, LineReading, Names
from rotsolve.grading.reading.tokens import tokens_of
from rotsolve.grading.reading.vocabulary import run_meaning

_NAME = r"(?P<name>\\?[^\W\d_](?:\w|\{[^{}]*\})*)"
_OWN = re.compile(r"[^\W\d_](?:[0-9₀-₉]|_\w+)*")  # one letter, perhaps with an index: `mgh = …` is a product
_WORD = (
    r"(?:let|put|set|with|wherein|where|call|define|take|taking|for|using|use|if|when|since|because|as|and"
    r"|mit|wobei|für|falls|sei)(?![^\W_])"
)
_SAID = r"(?:\\(?:text|textrm|mathrm|mbox)\s*\{\s*)?"  # round a word in LaTeX
_TELLS = re.compile(rf"[\s$]*(?:{_SAID}{_WORD}[\s}}$]*)*{_NAME}[\s$]*:?=(?P<value>[^=]+)", re.IGNORECASE)
_BEHIND = re.compile(
    rf"(?P<lead>(?:[\s$]*(?:[,;(]|\\quad|(?<![^\W_\\]){_SAID}{_WORD}\s*\}}?))+)[\s$]*{_NAME}[\s$]*:?=(?P<value>[^=,;]+)$",
    re.IGNORECASE,
)
_BEFORE = re.compile(
    rf"^[\s$]*(?:{_SAID}{_WORD}[\s}}]*)*{_NAME}[\s$]*:?=(?P<value>[^=,;]+)(?:=[^=,;]+)*[,;](?=\s*\S)", re.IGNORECASE
)
_INTRODUCED = re.compile(rf"^[\s$]*{_WORD}", re.IGNORECASE)
_BETWEEN = re.compile(rf"(?:{JOIN}|(?<![\w\\])(?:{JOINING})(?!\w))")
MOST_DEFINED = 8  # letters in one statement

Dimensions = Mapping[str, Dimension]
NO_DIMENSIONS: Dimensions = {}
Defined = tuple[tuple[str, Formula], ...]  # letters that the student defined, with what they stand for


class Clause(Struct, frozen=True):
    """A letter that a text defines, as typed, and what it says that it is."""

    typed: str
    value: str


def definition(
    text: str, names: Names, own: frozenset[str] = frozenset(), dimensions: Dimensions = NO_DIMENSIONS
) -> tuple[str, Formula] | None:
    """The letter that a line of working defines, and what it stands for; None where it defines none.

    `own` are letters of the scene that may be defined too, `dimensions` what they measure.
    """
    match = _TELLS.match(text)
    told = () if match is None else defined_by([Clause(match["name"], match["value"])], names, own, dimensions)
    return told[0] if told else None


def is_introduced(text: str) -> bool:
    """Whether a word says that a line defines something: `let M = 0`."""
    return _INTRODUCED.match(text) is not None


def without_introduction(text: str) -> str:
    """The line with blanks for such a word."""
    return _INTRODUCED.sub(lambda match: " " * len(match[0]), text)


def cut_definitions(
    text: str, names: Names, laws: frozenset[str], dimensions: Dimensions = NO_DIMENSIONS
) -> tuple[str, Defined]:
    """An answer without the clauses in front of it and behind it that define letters, and these with what they stand for.

    `laws` are letters of the laws that the student may define beside those of the scene, `dimensions` what these measure.
    """
    line, own = text, names.letters | laws
    before, behind = list[Clause](), list[Clause]()
    while len(before) < MOST_DEFINED and (match := _BEFORE.search(line)) is not None:
        rest = line[match.end() :]
        if not can_be_defined(match["name"], names, own, rest):
            break
        before.append(Clause(match["name"], match["value"]))
        line = rest.rjust(len(line))
    end, open_ = len(line), 0
    while len(behind) < MOST_DEFINED and (match := _BEHIND.search(line[:end].rstrip(" .$"))) is not None:
        rest, (value, surplus) = line[: match.start()], _closed(match["value"])
        open_ += surplus - match["lead"].count("(")
        if open_ < 0 or not rest.strip(" ,;$") or not can_be_defined(match["name"], names, own, rest):
            break
        behind.insert(0, Clause(match["name"], value))
        end = len(rest.rstrip(" ,;"))
    if open_:
        behind, end = [], len(line)
    told = defined_by((*before, *behind), names, own, dimensions)
    return (line[:end], told) if told else (text, ())


def told_before(text: str, names: Names, laws: frozenset[str], dimensions: Dimensions = NO_DIMENSIONS) -> Defined:
    """The letters that the statements before the one that answers define: `I = M R²; …`."""
    own = names.letters | laws
    matches = (_TELLS.match(piece) for piece in _BETWEEN.split(text))
    clauses = (Clause(match["name"], match["value"]) for match in matches if match is not None)
    return defined_by([one for one in clauses if can_be_defined(one.typed, names, own)], names, own, dimensions)


def defined_by(
    clauses: Sequence[Clause], names: Names, own: frozenset[str], dimensions: Dimensions = NO_DIMENSIONS
) -> Defined:
    """The letters of clauses, each in letters that none of the others defines: k = I/(m R²), I = M R²; nothing where one can't be read."""
    called = [_letter_defined(one.typed, names, own) for one in clauses]
    known = Names(names.givens | own | set(called), names.answers)
    found: dict[str, Formula] = {}
    for name, one in zip(called, clauses, strict=True):
        form = _meaning_told(one.value, known, name, dimensions) if name else None
        if form is None:
            return ()
        found[name] = form
    for _ in range(len(found)):
        others = dict(found)
        for name, form in others.items():
            found[name] = form.substitute({other: value for other, value in others.items() if other != name})
    return tuple(found.items())


def can_be_defined(typed: str, names: Names, own: frozenset[str], rest: str | None = None) -> bool:
    """Whether a clause defines a letter; one that is another answer does only where the rest holds it, else it is an answer of its own."""
    name = _letter_defined(typed, names, own)
    return bool(name) and (name not in names.answers or rest is None or name in _letters_in(rest, names))


def _letters_in(text: str, names: Names) -> Iterator[str]:
    """The letters of the scene in a text."""
    for run in re.findall(r"[^\W\d_]\w*", text):
        yield from (piece.text for piece in run_meaning(run, names.letters) or ())


def _closed(value: str) -> tuple[str, int]:
    """A value without the brackets at its end that close nothing in it, and how many these are."""
    value, count = value.rstrip(), 0
    while value.endswith(")") and value.count(")") > value.count("("):
        value, count = value[:-1].rstrip(), count + 1
    return value, count


def _letter_defined(typed: str, names: Names, own: frozenset[str]) -> str:
    """The name of a letter that can be defined: the student's, or one of those of the scene; '' where it can't."""
    try:
        token, *more = tokens_of(typed)
    except FormulaError:
        return ""
    name = token.text
    held = next((one for one in spellings(name) if one in own), "")
    strange = _OWN.fullmatch(name) or name in GREEK_LETTERS
    taken = not names.letters.isdisjoint(spellings(name)) or run_meaning(name, names.letters) is not None
    if len(more) != 1 or names.is_asked(name) or not (held or (strange and not taken)):
        return ""
    return held or spellings(name)[0]


def _meaning_told(text: str, names: Names, name: str, dimensions: Dimensions) -> Formula | None:
    """What a definition says, in SI units, by the reading that measures what the letter does: m = 5 g is five grams, M = 2 m twice m."""
    try:
        readings = [one for one in read_line(text, names) if one.kind in (FORMULA, NUMBER)]
    except AnswerError:
        return None
    wanted = dimensions.get(name)
    fitting = [one for one in readings if wanted is not None and _measures(one, wanted, dimensions)]
    return next((form for one in (*fitting, *readings) if (form := si_formula(one)) is not None), None)


def _measures(reading: LineReading, wanted: Dimension, dimensions: Dimensions) -> bool:
    """Whether a reading measures what is wanted, as far as that is known."""
    if reading.unit is not None:
        return reading.unit.dimension.matches(wanted)
    try:
        return reading.formula is not None and dimension_of(reading.formula, dimensions).matches(wanted)
    except (DimensionError, KeyError):
        return False
