"""Examination: a scene or a sheet by which papers are marked: its problems solved, and the papers of many students judged."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction
from os import PathLike
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.grading.course.marked import UNMARKED, MarkedSheet, Right, RightAnswer
from rotsolve.grading.course.questions import SheetTask, Task
from rotsolve.grading.verdict import NOT_MARKED, JudgedPart, Marked, Paper, Remark, Verdict
from rotsolve.language.marks import marking_of
from rotsolve.page.text import plain_text

if TYPE_CHECKING:
    from rotsolve.core.derivation import Answer
    from rotsolve.grading.course.examiner import Judges
    from rotsolve.keys.problem_set import ProblemSet
    from rotsolve.scene.read import Source

SHEET = "sheet"  # the kind of the fault of a scene that is a sheet of problems
DIGITS = 4  # of a right answer


class Examination:
    """The problems of a scene or a sheet, each with its judges. Raises SceneError and Unsolvable where one can't be marked by."""

    def __init__(self, judges: Sequence[Judges], task: SheetTask) -> None:
        self.judges, self.task = tuple(judges), task
        self.shows_right = False  # whether marked papers come with the right answers
        for one in self.judges:
            hold_to_checks(one)

    @classmethod
    def of_file(cls, scene: str | PathLike[str], seed: int, count: int | None) -> Examination:
        """That of a scene, in a file or in a text, or of a sheet file."""
        try:
            return cls.of_scene(scene, seed, count)
        except SceneError as error:
            if not any(fault.kind == SHEET for fault in error.faults) or (isinstance(scene, str) and "\n" in scene):
                raise
        from rotsolve.grading.course.examiner import Judges
        from rotsolve.keys.problem_set import problem_as_set, read_problem_set

        sheet = read_problem_set(scene)
        judges = [Judges(problem_as_set(one), seed, count) for one in sheet.problems]
        return cls(judges, sheet_task(judges, sheet))

    @classmethod
    def of_scene(cls, scene: Source, seed: int, count: int | None) -> Examination:
        """That of a scene alone."""
        from rotsolve.grading.course.examiner import Judges

        judges = Judges(scene, seed, count)
        task = task_with_points(judges.task, judges)
        return cls([judges], SheetTask(task.title, (task,)))

    def label_answers(self) -> None:
        """Let the answers of a scene alone be known by their labels on its sheet too, as those of a sheet are."""
        tasks = zip(self.task.tasks, self.judges, strict=True)
        self.task = replace(self.task, tasks=tuple(replace(one, labels=labels_of_parts(own)) for one, own in tasks))

    @property
    def varies(self) -> bool:
        """Whether there are variants."""
        return any(one.problem.vary is not None for one in self.judges)

    @property
    def seed(self) -> int | None:
        """The seed of the variants, where there are such."""
        return self.judges[0].seed if self.varies else None

    def mark(
        self,
        papers: Sequence[Sequence[Paper] | None],
        tell: Callable[[float], None] | None = None,
        size: int | None = None,
        way: Way | None = None,
    ) -> list[MarkedSheet]:
        """The papers of all students, marked here, or in another way so many at a time, telling how much is done; of one without papers
        nothing is marked."""
        found: list[list[Marked]] = [[unmarked(task) for task in self.task.tasks] for _ in papers]
        right: list[list[tuple[RightAnswer, ...]]] = [[() for _ in self.task.tasks] for _ in papers]
        chunks = [
            chunk for place in range(len(self.judges)) for chunk in self.chunks(place, papers, size or len(papers))
        ]
        for done, (chunk, marked, answers) in enumerate((way or self.marked_chunks)(chunks), 1):
            task = self.task.tasks[chunk.place]
            for student, one, number in marked:
                marked_one = in_sheet_order(one, task) if isinstance(one, Marked) else unmarked(task, one)
                found[student][chunk.place] = marked_one
                right[student][chunk.place] = answers.get(number, ())
            if tell is not None:
                tell(done / len(chunks))
        return [MarkedSheet(tuple(one), tuple(own)) for one, own in zip(found, right, strict=True)]

    def mark_one(self, papers: Sequence[Paper]) -> MarkedSheet:
        """The papers of one student, marked. Raises NotMarked where there is no such variant."""
        from rotsolve.grading.course.examiner import variant_of

        found, right = [], []
        for judges, task, paper in zip(self.judges, self.task.tasks, papers, strict=True):
            number = 0 if self.stands_alone(judges) else variant_of(paper)
            found.append(in_sheet_order(judges.judge(number).mark(paper), task))
            right.append(right_answers(judges.right[number]) if self.shows_right else ())
        return MarkedSheet(tuple(found), tuple(right))

    def stands_alone(self, judges: Judges) -> bool:
        """Whether a problem has the same numbers for all, though others vary."""
        return self.varies and judges.problem.vary is None

    def chunks(self, place: int, papers: Sequence[Sequence[Paper] | None], size: int) -> Iterator[Chunk]:
        """The papers of one problem, so many at a time, each time of variants that follow each other."""
        judges = self.judges[place]
        alone = self.stands_alone(judges)
        own = [(student, own[place]) for student, own in enumerate(papers) if own is not None]
        own = [(student, replace(one, variant="") if alone else one) for student, one in own]
        own.sort(key=lambda item: told_variant(item[1]))
        for start in range(0, len(own), size):
            yield Chunk(place, tuple(own[start : start + size]), self.shows_right)

    def marked_chunks(self, chunks: Sequence[Chunk]) -> MarkedChunks:
        """Each chunk with what came of it."""
        return ((chunk, *marked_chunk(chunk, self.judges[chunk.place])) for chunk in chunks)


class Chunk(Struct, frozen=True):
    """Some papers to one problem, each with the place of its student."""

    place: int
    papers: tuple[tuple[int, Paper], ...]
    shows_right: bool = False


# the place of a student, the paper as it is marked or why it is not, and its variant
Done = tuple[int, "Marked | str", int]
MarkedChunks = Iterator[tuple[Chunk, list[Done], Right]]
Way = Callable[[Sequence[Chunk]], MarkedChunks]


def marked_chunk(chunk: Chunk, judges: Judges) -> tuple[list[Done], Right]:
    """The papers of a chunk, marked, and the right answers to its variants."""
    from rotsolve.grading.course.examiner import mark_papers

    papers = [paper for _, paper in chunk.papers]
    found = [
        (chunk.papers[index][0], marked, told_variant(papers[index]))
        for index, marked in mark_papers(papers, judges.judge)
    ]
    right = {number: right_answers(own) for number, own in judges.right.items()} if chunk.shows_right else {}
    return found, right


def right_answers(answers: Sequence[Answer]) -> tuple[RightAnswer, ...]:
    """Answers as they are shown."""
    from rotsolve.page.data import answer_data
    from rotsolve.page.values import answer_rows

    return tuple(RightAnswer(one.name, tuple(answer_rows(one, DIGITS)), answer_data(one, DIGITS)) for one in answers)


def told_variant(paper: Paper) -> int:
    """The number of a paper's variant, -1 where it tells one that is none."""
    from rotsolve.grading.course.examiner import attempted, variant_of

    number = attempted(variant_of, paper)
    return number if isinstance(number, int) else -1


def hold_to_checks(judges: Judges) -> None:
    """Nothing is marked by answers that a check contradicts."""
    for found in judges.solution.checks:
        if found.holds is False:
            raise Unsolvable(f"its answers do not hold: {plain_text(found.words)}", file=judges.problem.file)


def task_with_points(task: Task, judges: Judges) -> Task:
    """The task with the points of its answers."""
    marking = judges.problem.marking
    return replace(task, points={name: marking_of(marking, name).points for name in task.letters})


def labels_of_parts(judges: Judges) -> dict[str, str]:
    """What each answer is called on a sheet: a, b, …"""
    from rotsolve.keys.parts import parts_of

    return {part.name: part.label for part in parts_of(judges.problem)}


def sheet_task(judges: Sequence[Judges], sheet: ProblemSet) -> SheetTask:
    """What a sheet asks: each problem with its number and short name, and its answers with the labels and in the order of the paper."""
    tasks = []
    for one, own in zip(sheet.problems, judges, strict=True):
        labels, task = labels_of_parts(own), own.task
        task = replace(task, letters={name: task.letters[name] for name in labels if name in task.letters})
        tasks.append(replace(task_with_points(task, own), number=one.number, name=one.name, labels=labels))
    return SheetTask(sheet.title, tuple(tasks), is_sheet=True)


def in_sheet_order(marked: Marked, task: Task) -> Marked:
    """A paper with its answers in the order of the parts on the sheet."""
    parts = {part.name: part for part in marked.parts}
    return replace(marked, parts=tuple(parts[name] for name in task.letters))


def unmarked(task: Task, why: str = "") -> Marked:
    """A paper of which nothing could be marked, and why."""
    remarks = (Remark(UNMARKED, (why,)),) if why else ()
    verdict = Verdict(NOT_MARKED, "", remarks)
    parts = tuple(JudgedPart(name, "", verdict, Fraction(0), points) for name, points in task.points.items())
    return Marked("", parts, (), Fraction(0), sum(task.points.values(), Fraction(0)))
