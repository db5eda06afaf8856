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
from rotsolve.confirm.course.samples import Numbers, holds
from rotsolve.core.derivation import Answer, Equality, Words
from rotsolve.core.remembered import remembered
from rotsolve.grading.marking.target import SceneLetters, Target, entries_of_answer
from rotsolve.grading.marking.texts import JudgedText, Texts
from rotsolve.grading.reading.conditions import Claim, claims_in
from rotsolve.grading.reading.definitions import Defined
from rotsolve.grading.reading.tokens import MAX_LENGTH
from rotsolve.grading.verdict import UNDECIDED, WRONG, Finding, Remark, all_findings
from rotsolve.language.marks import CASE
from rotsolve.solution import Solution

MOST_TOLD = 3  # cases of which it is said what the answer is there
SIGNS = {"sign", "direction"}  # the kinds of remarks on an answer that points the other way


class CaseOfScene(Struct, frozen=True):
    """Where a combination of cases of the answers holds: its conditions, what judges texts there, these answers, and points of it."""

    conditions: tuple[Equality, ...]
    texts: Texts
    answers: dict[str, Answer]
    points: tuple[Numbers, ...]

    def claimed(self, claim: Claim) -> bool | None:
        """Whether the conditions of a student hold here; None where they do in a part of it."""
        found = {all(holds(one, point) for one in claim.conditions) for point in self.points}
        return found.pop() if len(found) == 1 else None

    def judged(self, target: Target, text: str, claims: Sequence[Claim], defined: Defined) -> JudgedCase:
        """What is found here in a text, or in the answer that is given for this case."""
        own: Claim | None = None
        holding: bool | None = True
        if claims:
            told = [(self.claimed(one), one) for one in claims if one.conditions]
            chosen = [(found, one) for wanted in (True, None) for found, one in told if found is wanted]
            rest = [(True, one) for one in claims if not one.conditions]
            holding, own = (*chosen, *rest, (False, claims[0]))[0]
        one = self.texts.judged(self.texts.targets[target.name], own.text if own is not None else text, defined)
        return JudgedCase(self.answers[target.name], self.conditions, one, holding, bool(claims))


class JudgedCase(Struct, frozen=True):
    """What is found in a text where an answer of the scene holds, or in the part of that which its conditions tell.

    `claimed` says whether the student gives it for that: None for a part of it, False where another is `told` by conditions.
    """

    answer: Answer
    conditions: tuple[Equality, ...]
    one: JudgedText
    claimed: bool | None = True
    told: bool = False

    @property
    def fits(self) -> bool:
        return self.one.finding.right or bool(self.one.finding.flaws)

    @property
    def good(self) -> bool:
        """Whether it is right, and given for this case."""
        return self.fits and self.claimed is not False

    @property
    def blamed(self) -> bool:
        """Whether it is given for this case and wrong: with conditions, or in a sign that goes with the letters."""
        return self.claimed is not False and not self.fits and (self.told or self.turned)

    @property
    def turned(self) -> bool:
        """Whether only the sign is wrong."""
        return not self.fits and any(remark.kind in SIGNS for remark in self.one.finding.remarks)


class Cases:
    """The cases of a scene whose letters decide between them, each with what judges texts in it."""

    def __init__(self, solution: Solution) -> None:
        self.solution = solution
        self.told = solution.by_cases and bool(solution.trace.points)

    @cached_property
    def regions(self) -> list[CaseOfScene]:
        """Where each combination of cases of the answers holds."""
        from rotsolve.grading.comparing.regions import case_regions, floats, sampled  # few scenes have cases

        found = []
        for case in case_regions(self.solution):
            derivation = replace(self.solution.derivation, answers=case.answers)
            letters = SceneLetters.of(replace(self.solution, derivation=derivation))
            domain, answers = sampled(case, self.solution), {answer.name: answer for answer in case.answers}
            points = tuple(map(floats, domain.points))
            found.append(CaseOfScene(case.conditions, Texts.of(letters, domain), answers, points))
        return found

    @remembered
    def judged(self, target: Target, text: str, defined: Defined) -> JudgedText | None:
        """What is found in a text over all cases of an answer; None where there are none."""
        own = [region for region in (self.regions if self.told else ()) if target.name in region.answers]
        if not own or len(text) > MAX_LENGTH:
            return None
        order = [id(answer) for answer in self.branches(target.name)]
        claims = claims_in(text, own[0].texts.names(target))
        parts = [region.judged(target, text, claims, defined) for region in own]
        parts.sort(key=lambda part: order.index(id(part.answer)))
        return over_all(told_once(parts), first=order[0])

    def branches(self, name: str) -> tuple[Answer, ...]:
        """An answer in all its cases, as they are printed."""
        answer = next(one for one in self.solution.derivation.answers if one.name == name)
        return answer, *answer.otherwise


def told_once(parts: Sequence[JudgedCase]) -> list[JudgedCase]:
    """One for each case of the answer, with its conditions, where one thing is found in all of it."""
    found: list[JudgedCase] = []
    for answer in dict.fromkeys(id(part.answer) for part in parts):
        own = [part for part in parts if id(part.answer) == answer]
        if len({(part.fits, part.claimed, part.one.finding.outcome) for part in own}) == 1:
            one = replace(own[0].one, finding=all_findings(part.one.finding for part in own))
            own = [replace(own[0], conditions=own[0].answer.conditions, one=one)]
        found += own
    return found


def over_all(parts: Sequence[JudgedCase], first: int) -> JudgedText:
    """What is found over all cases; `first` is the one that is printed first."""
    good, other = ([part for part in parts if part.good is wanted] for wanted in (True, False))
    if not good:
        return right_nowhere(parts)
    finding = all_findings(part.one.finding for part in good)
    if not other:
        return replace(good[0].one, finding=finding)
    if all(part.fits for part in parts):
        remark = Remark("case", ("right, and without its condition too",))
        return replace(good[0].one, finding=replace(finding, remarks=(remark, *finding.remarks)))
    remarks = (Remark("case", tuple(words_of(good, other))), *finding.remarks)
    if any(part.one.finding.outcome == UNDECIDED for part in other):
        return replace(good[0].one, finding=Finding(UNDECIDED, remarks))
    ordinary = all(part.good and part.claimed for part in parts if id(part.answer) == first)
    kept = ordinary and not any(part.blamed for part in other)
    return replace(
        good[0].one, finding=Finding(finding.outcome, remarks, finding.flaws if kept else (*finding.flaws, CASE))
    )


def right_nowhere(parts: Sequence[JudgedCase]) -> JudgedText:
    """What is found where nothing is right: it is so under other conditions than the student's, or it is wrong in all cases."""
    fitting = [part for part in parts if part.fits]
    if fitting:
        return replace(parts[0].one, finding=Finding(WRONG, (Remark("case", tuple(words_of(fitting, ()))),)))
    return next((part.one for part in parts if part.one.finding.outcome == UNDECIDED), parts[0].one)


def words_of(good: Sequence[JudgedCase], other: Sequence[JudgedCase]) -> Iterator[str | Formula]:
    """right if u > v; if u ≤ v it is −(u − v)²/(2 μ g)."""
    for place, part in enumerate(good):
        yield ", or if " if place else "right if " if part.conditions else "right without its condition"
        yield from in_words(part.conditions)
    for part in other[:MOST_TOLD]:
        yield from ("; if ", *in_words(part.conditions))
        if part.one.finding.outcome == UNDECIDED:
            yield " that can't be told"
        else:
            value = value_in_words(part.answer)
            sign = (
                " it has the wrong sign"
                if part.turned and part.claimed is not False
                else ""
                if value
                else " it is another"
            )
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
