"""Judge: verdicts and marks for what students hand in, with one scene solved once; equal texts are judged once."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO
from rotsolve.algebra.units.dimension import NONE
from rotsolve.algebra.units.unit_table import Unit
from rotsolve.core.remembered import remembered
from rotsolve.grading.comparing.equality import SampledRegion
from rotsolve.grading.comparing.formulas import NUMBERS_ALONE
from rotsolve.grading.comparing.numbers import measured_unit
from rotsolve.grading.comparing.readings import COMPONENT, typed_in
from rotsolve.grading.comparing.scalars import lacking_unit
from rotsolve.grading.comparing.uncertain import UNCERTAIN
from rotsolve.grading.marking.cases import Cases
from rotsolve.grading.marking.explaining import Explaining, Wrong
from rotsolve.grading.marking.following import Following, Own, own_number
from rotsolve.grading.marking.own_letters import DEFINED
from rotsolve.grading.marking.target import SceneLetters, Target
from rotsolve.grading.marking.texts import ASIDE, CHAIN, EMPTY, JudgedText, Texts
from rotsolve.grading.marking.working import WorkingJudge
from rotsolve.grading.reading.definitions import Defined
from rotsolve.grading.reading.records import FORMULA, NUMBER, VECTOR
from rotsolve.grading.verdict import (
    NO_ANSWER,
    PARTLY,
    RIGHT,
    WRONG,
    JudgedPart,
    Marked,
    Paper,
    Remark,
    Verdict,
    found,
    listed_letters,
)
from rotsolve.language import marks
from rotsolve.solution import Solution

BESIDE = frozenset(
    (ASIDE, CHAIN, COMPONENT, DEFINED, UNCERTAIN)
)  # kinds of remarks that do not say what a wrong answer comes of


class Judge:
    """Judges answers to the questions of one solved scene; `wrong` gives its answers with a mistake, where they are known already."""

    def __init__(self, solution: Solution, wrong: Wrong | None = None) -> None:
        self.letters = SceneLetters.of(solution)
        self.texts = Texts.of(self.letters, SampledRegion.of(solution))
        self.targets, same = self.texts.targets, self.texts.same
        self.cases = Cases(solution)
        self.following = Following(self.letters, same)
        self.explaining = Explaining(self.letters, wrong)
        self.working = WorkingJudge(self.letters, frozenset(self.targets), same, self.explaining)

    def mark(self, paper: Paper) -> Marked:
        """The paper, marked: every answer in the order in which the scene asks, then the working."""
        parts, wrong = [], dict[str, str]()
        brought, own = self.working.defined(paper.working)
        round_in = self._circles(paper.answers)
        for target in self.targets.values():
            text = paper.answers.get(target.name, "")
            one, followed = self._in_its_place(target, text, wrong, brought, own)
            if target.name in round_in:
                one, followed = unsolved_judged(one, round_in[target.name]), False
            if one.finding.outcome == WRONG:
                wrong[target.name] = text
            parts.append(judged_part(target, text, one, followed))
        total, of = (sum((getattr(one, word) for one in parts), Fraction(0)) for word in ("marks", "of"))
        return Marked(paper.student, tuple(parts), self.working.lines(paper.working), total, of)

    def _circles(self, answers: Mapping[str, str]) -> dict[str, frozenset[str]]:
        """The answers that are told by each other alone."""
        holds = {}
        for name, target in self.targets.items():
            reading = self._judged(target, answers.get(name, "")).reading
            if reading is not None and reading.kind == FORMULA and reading.formula is not None:
                holds[name] = (reading.formula.symbols() & self.targets.keys()) - self.letters.givens
        return circles(holds) if len(holds) > 1 else {}

    def _in_its_place(
        self, target: Target, text: str, wrong: Mapping[str, str], brought: Defined, own: Defined
    ) -> tuple[JudgedText, bool]:
        """A text judged by itself, then by the student's own earlier answers that are wrong, then for what it comes of.

        By itself it is read with the letters of the scene that the working defines, where it can't be read with others too.
        """
        defined = (*brought, *own) if own else ()
        one = self._judged(target, text, defined)
        if one.reading is None and brought and not own:
            defined, one = brought, self._judged(target, text, brought)
        if any(remark.kind == NUMBERS_ALONE for remark in one.finding.remarks):
            return self._right_by_numbers(target, text, defined), False
        if one.finding.outcome != WRONG or one.finding.flaws or one.reading is None:
            return one, False
        followed = self._follow(target, text, tuple(wrong.items()), defined) if wrong else None
        if followed is not None:
            return followed, True
        said = {remark.kind for remark in one.finding.remarks} - BESIDE
        if said - {"sign"} if target.parts else said:  # a sign says little of why a component is wrong
            return one, False
        return self._explain(target, text, defined), False

    def _judged(self, target: Target, text: str, defined: Defined = ()) -> JudgedText:
        """What is found in a text by itself, in all cases of its answer."""
        return self.cases.judged(target, text, defined) or self.texts.judged(target, text, defined)

    @remembered
    def _right_by_numbers(self, target: Target, text: str, defined: Defined) -> JudgedText:
        """A formula that is right for the scene's own numbers alone; wrong where a usual mistake makes it of the answer."""
        one = self._judged(target, text, defined)
        assert one.reading is not None
        formula, asked = one.reading.formula, target.whole
        if formula is None or asked is None:
            return one
        mistaken = self.explaining.mistake_in_letters(target.name, self.letters.meant(formula), asked)
        return one if mistaken is None else replace(one, finding=mistaken)

    @remembered
    def _follow(
        self, target: Target, text: str, wrong: tuple[tuple[str, str], ...], defined: Defined
    ) -> JudgedText | None:
        """The finding for an answer that is right given the student's own earlier ones; None where it is not."""
        one, given = self._judged(target, text, defined), self.own(target, text, defined)
        owned = {name: self.own(self.targets[name], typed) for name, typed in wrong}
        earlier = {name: value for name, value in owned.items() if value is not None}
        if given is None or not earlier:
            return None
        derivation = self.following.follows(target.name, given, earlier, target.marking.tolerance)
        if derivation is None:
            return None
        words = self.following.words(target.name, derivation)
        finding = found(WRONG, "followed", *words, flaws=(marks.FOLLOWED,))
        assert one.reading is not None and target.whole is not None
        if one.reading.kind == NUMBER and one.reading.unit is None and not target.whole.dimension.matches(NONE):
            finding = lacking_unit(finding, target.whole.unit, target.whole)
        return JudgedText(one.reading, finding, one.read_as)

    @remembered
    def _explain(self, target: Target, text: str, defined: Defined = ()) -> JudgedText:
        """A wrong answer with what it comes of, where that is found."""
        one = self._judged(target, text, defined)
        reading, asked = one.reading, target.whole
        finding = None
        if reading is not None and reading.kind == VECTOR:
            finding = self.explaining.vector(target, reading)
        elif reading is not None and reading.formula is not None and asked is not None:
            if reading.kind == NUMBER:
                typed, unit = typed_in(reading), reading.unit
                meant = unit and measured_unit(unit, asked.unit, asked.dimension, asked.turns)
                typed = replace(typed, unit=meant) if isinstance(meant, Unit) else typed
                finding = self.explaining.number(target.name, typed, asked)
            elif reading.kind == FORMULA:
                finding = self.explaining.formula(target.name, self.letters.meant(reading.formula), asked)
        if finding is None:
            return one
        more = [remark for remark in one.finding.remarks if remark.kind != COMPONENT]
        return JudgedText(reading, replace(finding, remarks=(*finding.remarks, *more)), one.read_as)

    @remembered
    def own(self, target: Target, text: str, defined: Defined = ()) -> Own | None:
        """What a student's answer is worth for later ones; None for zero, and for what measures something else."""
        one = self._judged(target, text, defined)
        reading, asked = one.reading, target.whole
        if reading is None or reading.formula is None or asked is None:
            return None
        if any(remark.kind in ("dimension", "form") for remark in one.finding.remarks):
            return None
        if reading.kind == NUMBER:
            unit: Unit | Remark = asked.unit
            if reading.unit is not None:
                unit = measured_unit(reading.unit, asked.unit, asked.dimension, asked.turns)
            typed = typed_in(reading)
            return None if not isinstance(unit, Unit) or typed.rational == 0 else own_number(typed, unit.factor)
        formula = self.letters.meant(reading.formula)
        return None if reading.kind != FORMULA or self.texts.same(formula, ZERO) is not False else Own(formula)


def unsolved_judged(one: JudgedText, others: frozenset[str]) -> JudgedText:
    """The finding for an answer that is told by others, and they by it."""
    finding = found(WRONG, "form", "the answer speaks of itself")
    if others:
        listed = listed_letters(sorted(others))
        finding = found(WRONG, "form", "nothing is solved: it is told by ", *listed, ", and that by this answer")
    return JudgedText(one.reading, finding, one.read_as)


def judged_part(target: Target, text: str, one: JudgedText, followed: bool) -> JudgedPart:
    """One answer with its marks."""
    finding, marking = one.finding, target.marking
    earned = finding.right or bool(finding.flaws)
    left = marking.left(finding.flaws) if earned else Fraction(0)
    read = () if one.reading is None else one.reading.remarks
    outcome = finding.outcome
    if earned and marking.points:  # one word for each state of the marks
        outcome = RIGHT if left == marking.points else PARTLY if left else WRONG
    verdict = Verdict(outcome, one.read_as, (*read, *finding.remarks))
    if not text or any(remark.kind == EMPTY for remark in finding.remarks):
        verdict = Verdict(NO_ANSWER)
    return JudgedPart(target.name, text, verdict, left, marking.points, followed)


def circles(holds: Mapping[str, frozenset[str]]) -> dict[str, frozenset[str]]:
    """The answers that lead back to themselves, each with those on its way; `holds` are the answers whose letters each one holds."""
    behind: dict[str, frozenset[str]] = {}
    for name in holds:
        reached, waiting = set[str](), list(holds[name])
        while waiting:
            other = waiting.pop()
            if other not in reached:
                reached.add(other)
                waiting.extend(holds.get(other, ()))
        behind[name] = frozenset(reached)
    return {name: reached - {name} for name, reached in behind.items() if name in reached}
