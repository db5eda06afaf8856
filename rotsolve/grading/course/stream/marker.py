"""Marker: what marks a batch in one process, here or on another machine, which solves the problem itself when it is first asked."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from rotsolve import __version__
from rotsolve.algebra.certified.alone import ALONE
from rotsolve.grading.course.examiner import Judges, mark_papers
from rotsolve.grading.course.report.folder import marks_row
from rotsolve.grading.course.report.summary import result_of_row, tally_of
from rotsolve.grading.course.stream.assignment import Assignment, MarkedRows, OtherVersion
from rotsolve.grading.course.table import Entry
from rotsolve.grading.verdict import Marked, Paper

JUDGES = 64  # variants whose judges are kept from batch to batch
FORGETTING = 5000  # papers after which judges are made anew: they remember all that they have judged


class Marker:
    """Marks papers of one problem; of different papers without end it remembers those of late."""

    def __init__(self, judges: Judges) -> None:
        self.judge = lru_cache(JUDGES)(judges.judge)
        self.papers = 0

    def marked(self, papers: Sequence[Paper | None]) -> list[Marked | str]:
        """The marks of each paper, or why it has none; '' where there is no paper."""
        self.papers += len(papers)
        if self.papers > FORGETTING:
            self.judge.cache_clear()
            self.papers = len(papers)
        found: list[Marked | str] = [""] * len(papers)
        for place, marks in mark_papers(papers, self.judge):
            found[place] = marks
        return found

    def rows(self, entries: Sequence[Entry], names: tuple[str, ...]) -> MarkedRows:
        """The rows of a batch; `names` are those of what is asked."""
        marks = self.marked([entry.paper for entry in entries])
        results = [result_of_row(*pair) for pair in zip(entries, marks, strict=True)]
        return MarkedRows([marks_row(result, names) for result in results], tally_of(results))


def assignment_of(judges: Judges) -> Assignment:
    """The assignment for workers that are to mark as judges here do."""
    problem = "\n".join(judges.problem.lines) + "\n"
    return Assignment(problem, tuple(judges.task.letters), judges.seed, judges.count)


@lru_cache(1)  # a worker may be asked for several runs, one after the other
def marker_for(assignment: Assignment) -> Marker:
    return Marker(Judges(assignment.problem, assignment.seed, assignment.variants))


def papers_of_worker(assignment: Assignment, papers: Sequence[Paper | None]) -> list[Marked | str]:
    """What a worker is asked for a report."""
    refuse_version(assignment)
    with ALONE:
        return marker_for(assignment).marked(papers)


def rows_of_worker(assignment: Assignment, entries: Sequence[Entry]) -> MarkedRows:
    """What a worker is asked for the marks alone."""
    refuse_version(assignment)
    with ALONE:
        return marker_for(assignment).rows(entries, assignment.names)


def refuse_version(assignment: Assignment) -> None:
    if assignment.version != __version__:
        raise OtherVersion(__version__)
