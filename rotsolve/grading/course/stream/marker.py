"""Marker: what marks a batch in one process, here or on another machine, which solves the problems itself when it is first asked."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from rotsolve.algebra.certified.alone import ALONE
from rotsolve.grading.course.examination import Chunk, Done, Examination, marked_chunk
from rotsolve.grading.course.marked import Right
from rotsolve.grading.course.report.folder import marks_row
from rotsolve.grading.course.report.results import Result, tally_of
from rotsolve.grading.course.stream.assignment import Assignment, MarkedRows
from rotsolve.grading.course.stream.names import NamedEntry

JUDGES = 64  # variants of a problem whose judges are kept from batch to batch
FORGETTING = 5000  # papers after which judges are made anew: they remember all that they have judged


class Marker:
    """Marks papers by an examination; of different papers without end its judges remember those of late."""

    def __init__(self, examination: Examination) -> None:
        self.examination = examination
        self.papers = FORGETTING

    def count(self, papers: int) -> None:
        """So many papers are to come."""
        self.papers += papers
        if self.papers > FORGETTING:
            for one in self.examination.judges:
                one.keep(JUDGES)
            self.papers = papers

    def rows(self, named: Sequence[NamedEntry]) -> MarkedRows:
        """The rows of a batch."""
        self.count(len(named))
        sheets = self.examination.mark([one.entry.papers for one in named])
        results = [Result(one.entry, one.name, sheet) for one, sheet in zip(named, sheets, strict=True)]
        return MarkedRows([marks_row(self.examination.task, result) for result in results], tally_of(results))

    def chunk(self, chunk: Chunk) -> tuple[list[Done], Right]:
        """Papers to one problem, marked, and the right answers to their variants."""
        self.count(len(chunk.papers))
        done, right = marked_chunk(chunk, self.examination.judges[chunk.place])
        told = {number for _, _, number in done}
        return done, {number: answers for number, answers in right.items() if number in told}


@lru_cache(1)  # a worker may be asked for several runs, one after the other
def marker_for(assignment: Assignment) -> Marker:
    from rotsolve.grading.course.examiner import Judges

    problems, task = assignment.opened()
    judges = [Judges(problem, assignment.seed, assignment.variants) for problem in problems]
    examination = Examination(judges, task)
    examination.shows_right = assignment.shows_right
    return Marker(examination)


def rows_of_worker(assignment: Assignment, named: Sequence[NamedEntry]) -> MarkedRows:
    """What a worker is asked for the marks alone."""
    with ALONE:
        return marker_for(assignment).rows(named)


def chunk_of_worker(assignment: Assignment, chunk: Chunk) -> tuple[list[Done], Right]:
    """What a worker is asked for a report."""
    with ALONE:
        return marker_for(assignment).chunk(chunk)
