"""Cases: an answer in letters that is printed with conditions is held against what a student gives in each of its cases.

What is right in all of them is right. What is right in some only is so there, and told what the answer is in the others: right in the
first case, the one that a textbook has in mind, it keeps its marks, unless it has the wrong sign in another.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import Formula
from rotsolve.core.derivation import Answer, Equality, Words
from rotsolve.core.remembered import remembered
from rotsolve.grading.marking.target import SceneLetters, Target, entries_of_answer
from rotsolve.grading.marking.texts import Defined, JudgedText, Texts
from rotsolve.grading.verdict import UNDECIDED, Finding, Remark, all_findings
from rotsolve.language.marks import CASE
from rotsolve.solution import Solution

MOST_TOLD = 3  # cases of which it is said what the answer is there
SIGNS = {"sign", "direction"}  # the kinds of remarks on an answer that points the other way


class JudgedCase(Struct, frozen=True):
    """What is found in a text where an answer of the scene holds, or in the part of that which its conditions tell."""

    answer: Answer
    conditions: tuple[Equality, ...]
    one: JudgedText

    @property
    def good(self) -> bool:
        return self.one.finding.right or bool(self.one.finding.flaws)

    @property
    def turned(self) -> bool:
        """Whether only the sign is wrong."""
        return not self.good and any(remark.kind in SIGNS for remark in self.one.finding.remarks)


class Cases:
    """The cases of a scene whose letters decide between them, each with what judges texts in it."""

    def __init__(self, solution: Solution) -> None:
        self.solution = solution
        self.told = solution.by_cases and bool(solution.trace.points)

    @cached_property
    def regions(self) -> list[tuple[tuple[Equality, ...], Texts, dict[str, Answer]]]:
        """Where each combination of cases of the answers holds, the texts that are judged there, and these answers."""
        from rotsolve.grading.comparing.regions import case_regions, sampled  # few scenes have cases

        found = []
        for case in case_regions(self.solution):
            derivation = replace(self.solution.derivation, answers=case.answers)
            letters = SceneLetters.of(replace(self.solution, derivation=derivation))
            texts = Texts.of(letters, sampled(case, self.solution))
            found.append((case.conditions, texts, {answer.name: answer for answer in case.answers}))
        return found

    @remembered
    def judged(self, target: Target, text: str, defined: Defined) -> JudgedText | None:
        """What is found in a text over all cases of an answer; None where there are none."""
        order = [id(answer) for answer in self.branches(target.name)] if self.told else []
        parts = [
            JudgedCase(held[target.name], conditions, texts.judged(texts.targets[target.name], text, defined))
            for conditions, texts, held in (self.regions if self.told else ())
            if target.name in held
        ]
        parts.sort(key=lambda part: order.index(id(part.answer)))
        return over_all(merged(parts), first=order[0]) if parts else None

    def branches(self, name: str) -> tuple[Answer, ...]:
        """An answer in all its cases, as they are printed."""
        answer = next(one for one in self.solution.derivation.answers if one.name == name)
        return answer, *answer.otherwise


def merged(parts: Sequence[JudgedCase]) -> list[JudgedCase]:
    """One for each case of the answer, with its conditions, where one thing is found in all of it."""
    found: list[JudgedCase] = []
    for answer in dict.fromkeys(id(part.answer) for part in parts):
        own = [part for part in parts if id(part.answer) == answer]
        if len({(part.good, part.one.finding.outcome) for part in own}) == 1:
            one = replace(own[0].one, finding=all_findings(part.one.finding for part in own))
            own = [JudgedCase(own[0].answer, own[0].answer.conditions, one)]
        found += own
    return found


def over_all(parts: Sequence[JudgedCase], first: int) -> JudgedText:
    """What is found over all cases; `first` is the one that is printed first."""
    good, other = ([part for part in parts if part.good is wanted] for wanted in (True, False))
    if not good:
        return next((part.one for part in parts if part.one.finding.outcome == UNDECIDED), parts[0].one)
    finding = all_findings(part.one.finding for part in good)
    if not other:
        return replace(good[0].one, finding=finding)
    said = Remark("case", tuple(words_of(good, other)))
    remarks = tuple(dict.fromkeys((said, *finding.remarks)))
    if any(part.one.finding.outcome == UNDECIDED for part in other):
        return replace(good[0].one, finding=Finding(UNDECIDED, remarks))
    ordinary = all(part.good for part in parts if id(part.answer) == first) and id(good[0].answer) == first
    flaws = finding.flaws if ordinary and not any(part.turned for part in other) else (*finding.flaws, CASE)
    return replace(good[0].one, finding=Finding(finding.outcome, remarks, flaws))


def words_of(good: Sequence[JudgedCase], other: Sequence[JudgedCase]) -> Iterator[str | Formula]:
    """right if u > v; if u ≤ v it is −(u − v)²/(2 μ g)."""
    yield "right if "
    for place, part in enumerate(good):
        yield from (*((", or if ",) if place else ()), *in_words(part.conditions))
    for part in other[:MOST_TOLD]:
        yield from ("; if ", *in_words(part.conditions))
        if part.one.finding.outcome == UNDECIDED:
            yield " that can't be told"
        else:
            value = value_in_words(part.answer)
            sign = " it has the wrong sign" if part.turned else "" if value else " it is another"
            yield from (sign, *((": " if sign else " it is ", *value) if value else ()))
    if len(other) > MOST_TOLD:
        yield "; and not in other cases"


def in_words(conditions: Iterable[Equality]) -> Words:
    """u > v and M < m: conditions as they are printed."""
    words: list[str | Formula] = []
    for one in conditions:
        words += [*((" and ",) if words else ()), one.left, f" {one.relation} ", one.right]
    return tuple(words)


def value_in_words(answer: Answer) -> Words:
    """What an answer is: its formula, its word, or its components; nothing where it has none."""
    parts = [part.formula for part in entries_of_answer(answer)]
    if answer.word or not parts:
        return (answer.word,) if answer.word else () if answer.formula is None else (answer.formula,)
    shown = [part for part in parts if part is not None]
    listed = tuple(word for part in shown for word in (", ", part))[1:]
    return ("(", *listed, ")") if len(shown) == len(parts) else ()
