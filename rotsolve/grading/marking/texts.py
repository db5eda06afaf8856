"""Texts: what is found in one text by itself, whoever wrote it; equal texts are judged once."""

from __future__ import annotations

import re

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import Formula
from rotsolve.grading.comparing.finding import Finding, found
from rotsolve.grading.comparing.readings import judged
from rotsolve.grading.comparing.signs import cut_direction, is_direction, turned_round
from rotsolve.grading.comparing.vectors import vector_judged
from rotsolve.grading.marking.matrices import read_matrix
from rotsolve.grading.marking.target import Letters, Target
from rotsolve.grading.reading import AnswerError, Names, Reading, read_answer
from rotsolve.grading.reading.lines.chains import members
from rotsolve.grading.reading.lines.wording import bare
from rotsolve.grading.reading.records import NUMBER, WORD
from rotsolve.grading.verdict import RIGHT, UNDECIDED, WRONG, Remark
from rotsolve.language.marks import FORM

LONGEST_ECHO = 400  # characters of a line that is said back
CHAIN = "chain"  # the kind of a remark on the way to an answer
NOTHING = re.compile(r"[\s?.\-–—/]*|n\s*/\s*a|idk|no idea|(?:i )?do(?:n't| not) know|no answer", re.IGNORECASE)


class Judged(Struct, frozen=True):
    """One text, judged by itself: the reading that was used (None where there is none), and what was found."""

    reading: Reading | None
    finding: Finding
    read_as: str = ""


class Texts:
    """Judges the texts that answer the questions of one solved scene."""

    def __init__(self, letters: Letters) -> None:
        self.letters = letters
        self._names: dict[str, Names] = {}
        self._judged: dict[tuple[str, str], Judged] = {}

    def judged(self, target: Target, text: str) -> Judged:
        """What is found in a text."""
        known = self._judged.get((target.name, text))
        if known is None:
            known = self._judged[target.name, text] = self._judge(target, text)
        return known

    def _judge(self, target: Target, text: str) -> Judged:
        if NOTHING.fullmatch(text):
            return Judged(None, found(WRONG, "empty", "not answered"))
        if target.word:
            return Judged(None, word_judged(text, target))
        if is_direction(said(text)):
            return Judged(None, direction_judged(said(text), target))
        text = bare(text, self.names(target.name))
        chain = members(text, self.names(target.name)) if target.rows == 1 else ()
        if chain:
            return chained([self._value(target, member) for member in chain], chain)
        return self._value(target, text)

    def names(self, asked: str) -> Names:
        """The letters that an answer may hold."""
        known = self._names.get(asked)
        if known is None:
            known = self._names[asked] = Names(self.letters.givens, self.letters.told, asked)
        return known

    def _value(self, target: Target, text: str) -> Judged:
        """What is found in one value: by the letters of the scene, else with units in it, else with letters of the laws."""
        line, direction = cut_direction(text)
        try:
            read = read_answer if target.rows == 1 else read_matrix
            best = self._best(target, text, directed(read(line, self.names(target.name)), direction))
        except AnswerError as error:
            best = unread(error)
        plain = best.reading is not None and best.reading.figures is not None  # 4.36 m/s² can be read in one way only
        if best.finding.outcome == RIGHT or target.rows > 1 or plain:
            return best
        from rotsolve.grading.reading.quantities import read_quantities  # a right answer seldom needs it

        others = read_quantities(line, self.names(target.name), self.letters.dimensions, best.reading is not None)
        if best.reading is None:
            try:
                others = (*others, *self._with_laws(line, target.name))
            except AnswerError as error:  # knows more letters, so that it blames the right one
                best = unread(error)
        if not others:
            return best
        other = self._best(target, text, directed(others, direction))
        return other if best.reading is None or rank(other.finding) < rank(best.finding) else best

    def _with_laws(self, line: str, asked: str) -> tuple[Reading, ...]:
        """The readings of a line with letters that no motion has to be solved for, I for the moment of inertia, in terms of the givens."""
        names = Names(self.letters.givens | self.letters.constants, self.letters.told, asked)
        return tuple(
            replace(reading, written=reading.text, formula=formula)
            for reading in read_answer(line, names)
            if reading.formula is not None and (formula := self.letters.spelled_out(reading.formula)) is not None
        )

    def _best(self, target: Target, text: str, readings: tuple[Reading, ...]) -> Judged:
        """By the reading that makes the line right, else by the likeliest one."""
        tried: list[tuple[Reading, Finding]] = []
        for reading in readings:
            tried.append((reading, self._read(target, reading)))
            if rank(tried[-1][1]) == 0:
                break
        reading, finding = min(tried, key=lambda item: rank(item[1]))
        plain = reading is readings[0] and reading.kind == NUMBER  # a number with its unit, as it stands there
        echo = reading.text if len(readings) > 1 and len(text) <= LONGEST_ECHO and not plain else ""
        return Judged(reading, finding, "" if echo == said(text) else echo)

    def _read(self, target: Target, reading: Reading) -> Finding:
        """The finding for one reading."""
        if reading.kind == WORD:
            return found(WRONG, "form", "words are no answer here")
        reading = self.meant(reading)
        if reading.formula is not None and self.circular(target, reading.formula):
            return found(WRONG, "form", "the answer speaks of itself")
        if target.parts:
            return vector_judged(reading, target.parts, target.whole)
        assert target.whole is not None
        return judged(reading, target.whole)

    def meant(self, reading: Reading) -> Reading:
        """A reading with its formulas in the letters of closed forms."""
        if not self.letters.runs:
            return reading
        formula = None if reading.formula is None else self.letters.meant(reading.formula)
        return replace(reading, formula=formula, parts=tuple(self.meant(part) for part in reading.parts))

    def circular(self, target: Target, formula: Formula) -> bool:
        """Whether an answer holds its own letter, which is no letter of its closed form."""
        closed = self.letters.closed.get(target.name)
        return target.name in formula.symbols() and (closed is None or target.name not in closed.symbols())


def chained(found_in: list[Judged], chain: tuple[str, ...]) -> Judged:
    """What is found in a chain of values: its last member is the answer; an earlier one that is another value is said to be so."""
    *earlier, last = found_in
    finding = last.finding
    if finding.outcome == WRONG and any(remark.kind == "dimension" for remark in finding.remarks):
        return Judged(
            None, found(UNDECIDED, CHAIN, "what stands between the signs of equality does not belong together")
        )
    if finding.right and any(one.finding.right and FORM not in one.finding.flaws for one in earlier):
        flaws = tuple(flaw for flaw in finding.flaws if flaw != FORM)
        remarks = tuple(remark for remark in finding.remarks if FORM in flaws or remark.kind != FORM)
        finding = Finding(finding.outcome, remarks, flaws)
    for one, member in zip(earlier, chain, strict=False):
        other = (
            one.finding.right if finding.outcome == WRONG else one.finding.outcome == WRONG and not one.finding.flaws
        )
        if other:
            start, end = len(member) - len(member.lstrip()), len(member.rstrip())
            words = f"`{member.strip()}` {'is right' if one.finding.right else 'is another value'}"
            return replace(
                last, finding=replace(finding, remarks=(*finding.remarks, Remark(CHAIN, (words,), start, end)))
            )
    return replace(last, finding=finding)


def directed(readings: tuple[Reading, ...], direction: str) -> tuple[Reading, ...]:
    """The readings with the direction that words behind the line tell."""
    return tuple(replace(one, direction=direction) for one in readings) if direction else readings


def unread(error: AnswerError) -> Judged:
    """What is found in a text that can't be read."""
    remark = Remark("reading", (str(error),), error.start, error.end)
    return Judged(None, Finding(UNDECIDED, (remark,)))


def rank(finding: Finding) -> int:
    """The order in which the readings of one line are preferred: none is called wrong while another may be right."""
    if finding.outcome == WRONG and finding.flaws:
        return 1
    return {RIGHT: 0, UNDECIDED: 2, WRONG: 3}[finding.outcome]


def said(text: str) -> str:
    """A text without the letter of the answer in front."""
    return text.rpartition("=")[2].strip()


def word_judged(text: str, target: Target) -> Finding:
    """The finding for a label, or several in any order."""
    typed, wanted = (frozenset(plain(part) for part in words.split(",")) for words in (said(text), target.word))
    if typed == wanted or plain(text) == plain(target.word):
        return Finding(RIGHT)
    known = {plain(label) for label in (*target.options, "none")}
    if typed <= known:
        return Finding(WRONG)
    return found(WRONG, "reading", f"choose from: {', '.join(target.options)}")


def direction_judged(text: str, target: Target) -> Finding:
    """The finding for a direction in words where a number could stand."""
    direction = "" if target.whole is None else target.whole.direction
    if not direction:
        return found(WRONG, "form", "words are no answer here")
    if turned_round(text, direction) is not False:
        return found(WRONG, "direction", f"it points another way: {direction}")
    if target.directional:
        return Finding(RIGHT)
    return found(WRONG, "form", "the direction is right; its size is asked for")


def plain(words: str) -> str:
    return " ".join(words.lower().split())
