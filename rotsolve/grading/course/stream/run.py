"""Run: papers without end, marked batch by batch into a table of marks, by this process or by a cluster."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator
from pathlib import Path

from rotsolve.grading.course.command import ALL_RIGHT, NOT_ALL_RIGHT, CheckRequest, refuse_check
from rotsolve.grading.course.examiner import Judges
from rotsolve.grading.course.many import print_figures
from rotsolve.grading.course.report.tally import Tally
from rotsolve.grading.course.stream.cluster import Cluster
from rotsolve.grading.course.stream.kept import KeptBatches, told_run
from rotsolve.grading.course.stream.marker import (
    BATCH,
    Assignment,
    MarkedRows,
    Marker,
    assignment_of,
    numbered_batches,
    rows_of_worker,
)
from rotsolve.grading.course.stream.names import NamedLines
from rotsolve.grading.course.stream.papers import open_papers
from rotsolve.grading.course.stream.table_of_marks import write_marks
from rotsolve.grading.course.table import Entry, name_remarked, varied_entry
from rotsolve.run import advancing


def mark_stream(request: CheckRequest, judges: Judges) -> int:
    """Mark all papers of a table into the file that is asked for; the exit code says whether all is right.

    The papers are read twice: first to see which names stand twice and that all can be read, then to mark them.
    """
    fault = marks_objection(request)
    if fault:
        return refuse_check(f"error: {fault}")
    task, output = judges.task, request.output or ""
    names = tuple(task.letters)
    named = NamedLines(open_papers(request.answers, names, task.parts).entries)
    papers = open_papers(request.answers, names, task.parts)
    assignment = assignment_of(judges)
    kept = KeptBatches(output, told_run(assignment, request.answers, request.variant, BATCH))
    total = -(-named.papers // BATCH)
    if kept.numbers:
        print(f"note: {len(kept.numbers)} of {total} batches were marked before", file=sys.stderr)
    entries = (name_remarked(varied_entry(entry, request.variant), named.first(entry)) for entry in papers.entries)
    left = ((number, batch) for number, batch in numbered_batches(entries) if number not in kept.numbers)
    try:
        with advancing("marking") as tell:
            for number, rows in marked_batches(left, judges, assignment, request.cluster):
                kept.store(number, rows)
                tell(len(kept.numbers) / total)
    except BaseException:
        said = f"{len(kept.numbers)} of {total} batches are kept in {kept.folder}: the same command goes on from there"
        print(said, file=sys.stderr)
        raise
    tally = Tally()
    write_marks(output, counted_rows(kept.in_order(), tally), names, papers)
    kept.remove()
    print_figures(task, papers.columns, tally, judges.seed if judges.problem.vary is not None else None)
    print(f"The marks are in {output}.")
    return ALL_RIGHT if tally.faultless == tally.papers else NOT_ALL_RIGHT


def marked_batches(
    batches: Iterable[tuple[int, list[Entry]]], judges: Judges, assignment: Assignment, cluster: str | None
) -> Iterator[tuple[int, MarkedRows]]:
    """The rows of each batch, with its number, as they come."""
    if cluster is None:
        marker = Marker(judges)
        yield from ((number, marker.rows(batch, assignment.names)) for number, batch in batches)
    else:
        with Cluster(cluster) as workers:
            yield from workers.each(rows_of_worker, assignment, batches)


def counted_rows(batches: Iterable[MarkedRows], tally: Tally) -> Iterator[list[str]]:
    """The rows of all batches, which are counted as they pass."""
    for batch in batches:
        tally.add(batch.tally)
        yield from batch.rows


def marks_objection(request: CheckRequest) -> str:
    """Why the marks can't be where or as it is asked for, '' where they can."""
    output = Path(request.output or "")
    if request.format is not None:
        return f"{output} is a table of marks, which has no format of pages; leave out -f {request.format}"
    for name in (request.answers, request.problem):
        if output.resolve() == Path(name).resolve():
            return f"{name} would be overwritten"
    return ""
