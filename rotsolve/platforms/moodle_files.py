"""Moodle files: a sheet and its variants as `moodle.xml`, which any Moodle imports, and `stack.xml` for one with the plugin STACK.

Without variants each part of a problem is a question, in a category for the problem. With variants each variant of a problem is one
question, so that a quiz that draws one at random from the category asks all its parts with the same numbers.
"""

from __future__ import annotations

from collections.abc import Iterator
from xml.etree.ElementTree import Element

from msgspec import Struct

from rotsolve.keys.files import NamedContent, SheetFiles
from rotsolve.keys.sheets import Sheet, SheetProblem
from rotsolve.page.blocks import Answers, Phrase
from rotsolve.page.values import answer_row
from rotsolve.platforms.cloze import box_count, cloze
from rotsolve.platforms.fragments import fragments_in, problem_blocks, solution_blocks
from rotsolve.platforms.judges import ProblemJudges
from rotsolve.platforms.known import PlatformPart, parts_for_platforms
from rotsolve.platforms.maxima import NoMaxima
from rotsolve.platforms.moodle import PLACE, QuestionFrame, category, quiz_xml
from rotsolve.platforms.stack import VariantOfProblem, formula_question, number_question

CHOICES, LETTERS = "multiple choice", "in letters"
Questions = list[Element]


class WorkedQuestion(Struct, frozen=True):
    """One variant of a problem with what is known of it, and the frame of its questions; its number is 0 without variants."""

    variant: int
    one: SheetProblem
    parts: tuple[PlatformPart, ...]
    frame: QuestionFrame

    @property
    def mark(self) -> str:
        return f" (variant {self.variant})" if self.variant else ""

    def name(self, part: PlatformPart | None = None, place: int | None = None) -> str:
        """The name of a question: its number on the sheet, its part, its title."""
        label = part.part.label if part is not None and len(self.parts) > 1 else ""
        component = (
            f" {part.boxes[place].component}" if part is not None and place is not None and len(part.boxes) > 1 else ""
        )
        return f"{self.one.listed.number}{label}{component} {self.one.marked.title}{self.mark}"

    def asked(self, part: PlatformPart, place: int | None = None) -> str:
        """What is asked, in a paragraph; of a vector which component."""
        box = part.boxes[place] if place is not None and len(part.boxes) > 1 else None
        component: Phrase = () if box is None else (": ", box.symbol)
        return self.frame.printer.sentence((*part.asked, *component))


class MoodleFiles(SheetFiles):
    """Makes the files for Moodle."""

    def __init__(self, digits: int, language: str) -> None:
        self.digits, self.language = digits, language
        self.judges = ProblemJudges()
        self.problems: dict[int, list[WorkedQuestion]] = {}
        self.title = ""

    def add(self, sheet: Sheet) -> Iterator[NamedContent]:
        self.title = sheet.set.title or "rotsolve"
        for one in sheet.problems:
            parts = parts_for_platforms(one, self.judges.judge(one), self.digits)
            printer = fragments_in(self.language, PLACE)
            frame = QuestionFrame(
                printer, printer.fragment(problem_blocks(one)), printer.fragment(solution_blocks(one, self.digits))
            )
            self.problems.setdefault(one.listed.number, []).append(WorkedQuestion(sheet.variant, one, parts, frame))
        yield from ()

    def close(self) -> Iterator[NamedContent]:
        plain = [question for worked in self.problems.values() for question in self.plain(worked)]
        yield "moodle.xml", quiz_xml(plain)
        letters = [question for worked in self.problems.values() for question in self.stack(worked)]
        if letters:
            yield "stack.xml", quiz_xml(letters)

    def path(self, worked: list[WorkedQuestion], *more: str) -> Element:
        one = worked[0].one
        return category(self.title, f"{one.listed.number}. {one.marked.title}", *more)

    def plain(self, worked: list[WorkedQuestion]) -> Iterator[Element]:
        """The categories of a problem with their questions; those that are empty are left out."""
        yield from self.filled(worked, [question for one in worked for question in main_questions(one, self.digits)])
        beside = (place for place, part in enumerate(worked[0].parts) if part.numbers)
        for place in beside:
            found = [choice_question(one, one.parts[place]) for one in worked if one.parts[place].options]
            label = (worked[0].parts[place].part.label,) if worked[0].variant else ()
            yield from self.filled(worked, found, CHOICES, *label)

    def filled(self, worked: list[WorkedQuestion], questions: Questions, *more: str) -> Iterator[Element]:
        if questions:
            yield self.path(worked, *more)
            yield from questions

    def stack(self, worked: list[WorkedQuestion]) -> Iterator[Element]:
        """The questions for formulas; with variants those for numbers too, of all variants at once."""
        found = []
        for place, part in enumerate(worked[0].parts):
            found += attempted_stack(worked, place) if part.formulas else []
        yield from self.filled(worked, found, LETTERS)


def main_questions(worked: WorkedQuestion, digits: int) -> Iterator[Element]:
    """The questions of a variant: one for each part and component, or a single one with boxes for all of them."""
    boxes = sum(box_count(part) for part in worked.parts if part.numbers or part.options)
    if worked.variant and boxes > 1:
        yield cloze(worked.frame, worked.name(), worked.parts)
    for part in worked.parts:
        share = part.part.points / max(1, len(part.boxes))
        if worked.variant and boxes > 1 and (part.numbers or part.options):
            continue
        if part.numbers:
            for place in range(len(part.boxes)):
                asked = worked.asked(part, place)
                yield worked.frame.numerical(worked.name(part, place), asked, part, place, share)
        elif part.options:
            yield choice_question(worked, part)
        else:
            yield worked.frame.essay(worked.name(part), worked.asked(part), shown_answer(worked, part, digits), share)


def choice_question(worked: WorkedQuestion, part: PlatformPart) -> Element:
    return worked.frame.choice(worked.name(part), worked.asked(part), part, part.part.points)


def shown_answer(worked: WorkedQuestion, part: PlatformPart, digits: int) -> str:
    """The answer for the teacher who marks."""
    return worked.frame.printer.fragment([Answers((answer_row(part.answer, digits),))])


def attempted_stack(worked: list[WorkedQuestion], place: int) -> Questions:
    """The questions of STACK for a part; none where Maxima has no words for its formula."""
    first = worked[0]
    part = first.parts[place]
    givens = [given.name for given in first.one.worked.shown()]
    name, asked = first.name(part).removesuffix(first.mark), first.asked(part)
    found: Questions = []
    try:
        if not first.variant or not part.numbers:
            found.append(formula_question(first.frame, name, asked, part, givens))
        elif len(part.boxes) == 1:
            number = number_question(first.frame, name, asked, [stack_variant(one, place) for one in worked])
            found += [number] if number is not None else []
    except NoMaxima:
        return []
    return found


def stack_variant(worked: WorkedQuestion, place: int) -> VariantOfProblem:
    """What STACK is told of a variant."""
    values = worked.one.worked.problem.values
    names = sorted(given.name for given in worked.one.worked.shown() if given.name in values)
    return VariantOfProblem(worked.frame.told, worked.parts[place], {name: values[name] for name in names})
