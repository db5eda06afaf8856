"""Known: what a platform is told of a problem: its parts, and for each the right answer and known wrong ones with their marks.

A platform derives nothing: it compares what is typed with numbers and formulas that it knows. These are found here: the answer, that
with the other sign, with numbers rounded too early, with each mistake of docs/mistakes.md. What each is worth, and what is said
of it, is asked of the judge by whom `rotsolve check` marks, so that both say the same.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from fractions import Fraction
from functools import cached_property
from itertools import islice
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.certified.ball import Certified, multiple_of
from rotsolve.algebra.formula import Formula, Integral, Symbol
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.units.unit_table import Unit
from rotsolve.core.symbols import TIME
from rotsolve.grading.comparing.readings import nothing_beside
from rotsolve.grading.verdict import RIGHT, JudgedPart, Paper
from rotsolve.language import marks
from rotsolve.page.blocks import Amount, Math, Matrix, Phrase
from rotsolve.page.values import certified_digits, machine_number
from rotsolve.platforms.margins import decimal_of, shown_margin, tolerated_margin

if TYPE_CHECKING:
    from rotsolve.core.derivation import Answer
    from rotsolve.grading.comparing.scalars import Scalar
    from rotsolve.grading.marking.judge import Judge
    from rotsolve.grading.marking.target import Target
    from rotsolve.keys.parts import SheetPart
    from rotsolve.keys.sheets import SheetProblem
    from rotsolve.language.marks import Marking

FEW = 2  # figures of a number that is right as far as it goes
MOST_OPTIONS = 5  # of a multiple choice
MOST_KNOWN = 24  # wrong answers of a question: a teacher should be able to read them
WRITTEN = Fraction(1, 1_000_000)  # the share within which a number is the one that was written
BEYOND = Fraction(101, 100)  # margins within which a number lies on the edge
INSIDE = tuple(
    Fraction(part, 10) for part in (5, -5, 7, -7)
)  # of the way from what the answer may be off to what rounding makes it
BY_SIDE = ", "


class Box(Struct, frozen=True):
    """A field for one number: the component that it is of, '' for a number alone; its letter, its unit."""

    component: str
    symbol: Formula
    unit: Unit


class KnownNumbers(Struct, frozen=True):
    """Numbers that are known, one for each box, with how far off they may be; the share of the points, and what is said."""

    numbers: tuple[str, ...]
    margins: tuple[str, ...]
    share: Fraction
    said: tuple[Phrase, ...] = ()


class KnownOption(Struct, frozen=True):
    """An option of a multiple choice: how it reads, the share of the points, and what is said."""

    shown: Phrase
    share: Fraction
    said: tuple[Phrase, ...] = ()


class KnownFormula(Struct, frozen=True):
    """A formula in the letters of the givens, the share of the points, and what is said."""

    formula: Formula
    share: Fraction
    said: tuple[Phrase, ...] = ()


class PlatformPart(Struct, frozen=True):
    """One answer of a problem as platforms ask for it. In each list the right answer is the first; a list is empty where there is none."""

    part: SheetPart
    asked: Phrase
    answer: Answer
    marking: Marking
    boxes: tuple[Box, ...] = ()
    numbers: tuple[KnownNumbers, ...] = ()
    options: tuple[KnownOption, ...] = ()
    formulas: tuple[KnownFormula, ...] = ()
    in_words: bool = False  # whether an option is asked for, and no number or formula

    @property
    def order(self) -> tuple[int, ...]:
        """The places of the options as they stand one below the other, which tells none: by their labels, others by what they are."""
        places = range(len(self.options))
        if self.in_words:
            return tuple(sorted(places, key=lambda place: label_in_front(self.options[place])))
        return tuple(sorted(places, key=lambda place: repr(self.options[place].shown)))

    @property
    def unit_cost(self) -> Fraction:
        """The share of the points that a missing unit costs."""
        costs = dict(self.marking.deduct)
        points = self.marking.points
        return costs[marks.UNIT].of(points) / points if points else Fraction(0)


def parts_for_platforms(one: SheetProblem, judge: Judge, digits: int) -> tuple[PlatformPart, ...]:
    """The parts of a problem in the order of its sheet."""
    asked = {said.part.name: said.words for said in one.statement.parts}
    reader = KnownAnswers(one, judge, digits)
    return tuple(reader.part(part, answer, asked[part.name]) for part, answer in one.answers())


class KnownAnswers:
    """Finds what is known of the answers of one variant of a problem."""

    def __init__(self, one: SheetProblem, judge: Judge, digits: int) -> None:
        self.one, self.judge, self.digits = one, judge, digits

    def part(self, part: SheetPart, answer: Answer, asked: Phrase) -> PlatformPart:
        """All that is known of one answer."""
        target = self.judge.targets[answer.name]
        found = PlatformPart(part, asked, answer, target.marking)
        if target.word:
            return replace(found, options=tuple(self.words(target)), in_words=True)
        from rotsolve.grading.marking.target import entries_of_answer

        formulas = tuple(self.formulas(target))
        scalars = target.parts or ((target.whole,) if target.whole is not None else ())
        numbers = () if target.marking.form == marks.EXACT and formulas else tuple(self.numbers(target, scalars))
        boxes = tuple(map(self.box, target.labels or ("",), entries_of_answer(answer) or (answer,), scalars))
        options = tuple(self.options(target, numbers, formulas, boxes))
        return replace(found, boxes=boxes if numbers else (), numbers=numbers, options=options, formulas=formulas)

    def box(self, label: str, answer: Answer, scalar: Scalar) -> Box:
        return Box(label, answer.symbol, scalar.unit)

    # the judge

    def judged(self, name: str, text: str) -> JudgedPart:
        """What `check` says of a text."""
        marked = self.judge.mark(Paper("", {name: text}))
        return next(part for part in marked.parts if part.name == name)

    def worth(self, name: str, text: str) -> tuple[Fraction, tuple[Phrase, ...]]:
        """The share of the points, and what is said."""
        found = self.judged(name, text)
        share = found.marks / found.of if found.of else Fraction(found.verdict.outcome == RIGHT)
        return share, tuple(remark.words for remark in found.verdict.remarks)

    # numbers

    def numbers(self, target: Target, scalars: tuple[Scalar, ...]) -> Iterator[KnownNumbers]:
        """The right numbers, then wrong ones; nothing where there is no number, or the judge would not take it."""
        size = max((abs(one.value.float) for one in scalars if one.value is not None), default=0.0)
        scalars = tuple(nothing_beside(one, size) for one in scalars) if len(scalars) > 1 else scalars
        values = tuple(one.value for one in scalars if one.value is not None)
        if not values or len(values) < len(scalars) or any(value.figures(self.digits)[1] == 0 for value in values):
            return
        margins = tuple(tolerated_margin(value, one) for value, one in zip(values, scalars, strict=True))
        right = tuple(decimal_of(value, margin, self.digits) for value, margin in zip(values, margins, strict=True))
        share, said = self.worth(target.name, typed_text(right, target, scalars))
        if not share:
            return
        shown = tuple(map(shown_margin, margins))
        yield KnownNumbers(right, shown, share, said)
        yield from islice(self.wrong_numbers(target, scalars, right, margins), MOST_KNOWN)
        if len(scalars) == 1:
            yield from self.rough_numbers(target, scalars[0], right, margins[0])

    def wrong_numbers(
        self, target: Target, scalars: tuple[Scalar, ...], right: tuple[str, ...], margins: tuple[Fraction, ...]
    ) -> Iterable[KnownNumbers]:
        """What students write instead, and what it is worth; what is no farther off than the answer may be is left out. A platform
        sees no figures: of 1.7 and 1.70 the one that is worth more counts."""
        found: dict[tuple[float, ...], KnownNumbers] = {}
        beyond = tuple(margin * BEYOND for margin in margins)
        for numbers, spread in self.candidates(target, scalars, right):
            if within_margins(numbers, right, beyond):
                continue
            share, said = self.worth(target.name, typed_text(numbers, target, scalars))
            close = tuple(shown_margin(spread * abs(Fraction(number))) for number in numbers)
            values = tuple(map(float, numbers))
            if (share or said) and (values not in found or share > found[values].share):
                found[values] = KnownNumbers(numbers, close, share, said)
        return found.values()

    def candidates(
        self, target: Target, scalars: tuple[Scalar, ...], right: tuple[str, ...]
    ) -> Iterator[tuple[tuple[str, ...], Fraction]]:
        """Numbers to be asked about, and the share by which others may be off that `check` takes for the same: the other sign, few
        figures, other answers, early roundings, mistakes."""
        from rotsolve.grading.marking.explaining import ALIKE, EXACTLY

        yield tuple(map(other_sign, right)), scalars[0].marking.tolerance.share or WRITTEN
        if len(scalars) == 1 and scalars[0].value is not None:
            yield from (((self.decimal(scalars[0].value, figures),), WRITTEN) for figures in (FEW, FEW + 1))
            for value, _ in self.judge.explaining.roundings(scalars[0]):
                yield from self.in_figures((multiple_of(value, 1 / scalars[0].unit.factor),), EXACTLY)
            for other in self.judge.letters.solution.derivation.answers:
                if other.value is not None and other.unit == scalars[0].unit and not other.components:
                    yield from self.in_figures((other.value,), WRITTEN)
        alike = (
            ALIKE if len(scalars) == 1 else scalars[0].marking.tolerance.share or WRITTEN
        )  # of vectors as of right ones
        for _, answers in self.judge.explaining.wrong_answers:
            if target.name in answers:
                yield from self.in_figures(self.of_mistake(answers[target.name], scalars), alike)

    def in_figures(self, values: tuple[Certified, ...], spread: Fraction) -> Iterator[tuple[tuple[str, ...], Fraction]]:
        """Numbers as they are, and rounded to three figures where that takes them farther away."""
        if not values:
            return
        exact = tuple(map(self.decimal, values))
        rounded = tuple(self.decimal(value, FEW + 1) for value in values)
        yield exact, spread
        if not within_margins(rounded, exact, tuple(spread * abs(Fraction(number)) for number in exact)):
            yield rounded, WRITTEN

    def of_mistake(self, answer: Answer, scalars: tuple[Scalar, ...]) -> tuple[Certified, ...]:
        """The numbers of an answer with a mistake; nothing where they are not those of the boxes."""
        from rotsolve.grading.marking.target import entries_of_answer

        parts = entries_of_answer(answer) if len(scalars) > 1 else (answer,)
        units = [one.unit.text for one in scalars]
        if [part.unit.text if part.unit is not None else "" for part in parts] != units:
            return ()
        values = [part.value for part in parts if part.value is not None]
        if len(values) < len(scalars) or not all(value.figures(self.digits)[1] for value in values):
            return ()
        return tuple(values)

    def decimal(self, value: Certified, figures: int = 6) -> str:
        return machine_number(certified_digits(value, figures)[0])

    def rough_numbers(
        self, target: Target, scalar: Scalar, right: tuple[str, ...], margin: Fraction
    ) -> Iterator[KnownNumbers]:
        """All that is as far off as numbers rounded on the way make it, and farther than the answer may be."""
        number = Fraction(right[0])
        spread = self.judge.explaining.spread(scalar) * abs(number)
        if spread <= margin:
            return
        for inside in INSIDE:
            beyond = margin + abs(inside) * (spread - margin)
            off = f"{float(number + (beyond if inside > 0 else -beyond)):.6g}"
            found = self.judged(target.name, typed_text((off,), target, (scalar,)))
            if found.marks and [remark.kind for remark in found.verdict.remarks] == ["rounding"]:
                said = tuple(remark.words for remark in found.verdict.remarks)
                yield KnownNumbers(right, (shown_margin(spread),), found.marks / found.of, said)
                return

    # formulas

    @cached_property
    def time(self) -> dict[str, Formula]:
        """The running time as it is printed."""
        return {TIME: Symbol(self.judge.letters.meanings.time)}

    def written(self, closed: Formula | None) -> Formula | None:
        """A closed form in the letters of the page; None of what a platform can not read: integrals."""
        found = self.judge.letters.written(closed)
        return None if found is None or found.holds(Integral) else found.substitute(self.time)

    def formulas(self, target: Target) -> Iterator[KnownFormula]:
        """The answer in letters, then those of mistakes; nothing where it has none, or a number is wanted."""
        right = self.written(target.whole.closed) if target.whole is not None and not target.parts else None
        if right is None or not right.symbols() or target.marking.form == marks.NUMBER:
            return
        share, said = self.worth(target.name, to_text(right))
        if not share:
            return
        yield KnownFormula(right, share, said)
        seen = {right}
        for _, answers in self.judge.explaining.wrong_answers:
            wrong = self.written(answers[target.name].closed) if target.name in answers else None
            if wrong is None or wrong in seen or len(seen) > MOST_KNOWN:
                continue
            seen.add(wrong)
            found = self.judged(target.name, to_text(wrong))
            said = tuple(remark.words for remark in found.verdict.remarks if remark.kind == "mistake")
            if said and found.verdict.outcome != RIGHT:
                yield KnownFormula(wrong, found.marks / found.of if found.of else Fraction(0), said)

    # options

    def words(self, target: Target) -> Iterator[KnownOption]:
        """The options of a question for one of them, the right one first."""
        from rotsolve.keys.asked import AskedWords

        problem = self.one.worked.problem
        find = next(find for find in problem.finds if find.group == target.name)
        said = AskedWords(problem)
        options = find.choice.options if find.choice is not None else ()
        known = [KnownOption(said.option(option), *self.worth(target.name, option.label)) for option in options]
        yield from sorted(known, key=lambda option: -option.share)

    def options(
        self,
        target: Target,
        numbers: tuple[KnownNumbers, ...],
        formulas: tuple[KnownFormula, ...],
        boxes: tuple[Box, ...],
    ) -> Iterator[KnownOption]:
        """The right answer among those of mistakes; nothing where there is no wrong one that can be told from it."""
        found: list[KnownOption] = []
        if numbers:
            for one in numbers:
                shown = shown_numbers(tuple(self.rounded(number) for number in one.numbers), boxes, target.rows)
                if shown not in [other.shown for other in found] and (not found or not one.share):
                    found.append(KnownOption(shown, one.share, one.said))
        else:
            found = [KnownOption((Math((one.formula,)),), one.share, one.said) for one in formulas]
        if len(found) > 1:
            yield from found[:MOST_OPTIONS]

    def rounded(self, number: str) -> str:
        """A decimal number with the digits of the key."""
        return f"{float(number):#.{self.digits}g}".rstrip(".")


def label_in_front(option: KnownOption) -> str:
    """The label in front of an option, (a)."""
    return next((word for word in option.shown if isinstance(word, str)), "")


def typed_text(numbers: tuple[str, ...], target: Target, scalars: tuple[Scalar, ...]) -> str:
    """Numbers as a student writes them for `check`: 4.36 m/s², (3, 4) N, [[1, 0], [0, 2]] kg m²."""
    unit = scalars[0].unit
    if not target.parts:
        return unit.after(numbers[0])
    if target.rows == 1:
        return unit.after(f"({BY_SIDE.join(numbers)})")
    wide = len(numbers) // target.rows
    rows = (numbers[first : first + wide] for first in range(0, len(numbers), wide))
    return unit.after(f"[{BY_SIDE.join(f'[{BY_SIDE.join(row)}]' for row in rows)}]")


def shown_numbers(numbers: tuple[str, ...], boxes: tuple[Box, ...], rows: int) -> Phrase:
    """Numbers as an option of a choice has them."""
    if len(numbers) == 1:
        return (Math((Amount(numbers[0].replace("-", "−"), boxes[0].unit),)),)
    wide = len(numbers) // rows
    entries = [Amount(number.replace("-", "−")) for number in numbers]
    matrix = tuple(tuple(entries[first : first + wide]) for first in range(0, len(entries), wide))
    return (Math((Matrix(matrix, boxes[0].unit),)),)


def other_sign(number: str) -> str:
    """The decimal number with the other sign."""
    return number.removeprefix("-") if number.startswith("-") or not float(number) else f"-{number}"


def within_margins(numbers: tuple[str, ...], right: tuple[str, ...], margins: tuple[Fraction, ...]) -> bool:
    """Whether numbers are no farther from the right ones than they may be."""
    pairs = zip(numbers, right, margins, strict=True)
    return all(abs(Fraction(number) - Fraction(wanted)) <= margin for number, wanted, margin in pairs)
