"""Run: papers without end, marked batch by batch into a table of marks, by this process or by a cluster."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator
from contextlib import nullcontext
from pathlib import Path

from rotsolve.grading.course.command import ALL_RIGHT, NOT_ALL_RIGHT, CheckRequest, refuse_check
from rotsolve.grading.course.examiner import Judges
from rotsolve.grading.course.report.summary import head_of_class
from rotsolve.grading.course.report.tally import Tally
from rotsolve.grading.course.sheet import file_error
from rotsolve.grading.course.stream.assignment import BATCH, Assignment, MarkedRows, numbered_batches
from rotsolve.grading.course.stream.cluster import Cluster
from rotsolve.grading.course.stream.kept import KeptBatches, told_run
from rotsolve.grading.course.stream.marker import Marker, assignment_of, rows_of_worker
from rotsolve.grading.course.stream.names import NamedLines
from rotsolve.grading.course.stream.papers import PaperFile, open_papers
from rotsolve.grading.course.stream.table_of_marks import write_marks
from rotsolve.grading.course.table import Entry, name_remarked, varied_entry
from rotsolve.run import advancing


def mark_stream(request: CheckRequest, judges: Judges) -> int:
    """Mark all papers of a table into the file that is asked for; the exit code says whether all is right."""
    fault = marks_objection(request)
    if fault:
        return refuse_check(f"error: {fault}")
    with Cluster(request.cluster) if request.cluster else nullcontext() as cluster:
        papers, kept = marked_into_parts(request, judges, cluster)
    tally = Tally()
    names = tuple(judges.task.letters)
    write_marks(request.output or "", counted_rows(kept.in_order(), tally), names, papers)
    kept.remove()
    seed = judges.seed if judges.problem.vary is not None else None
    print("\n".join(head_of_class(judges.task, papers.columns, tally, seed)))
    print(f"The marks are in {request.output}.")
    return ALL_RIGHT if tally.faultless == tally.papers else NOT_ALL_RIGHT


def marked_into_parts(request: CheckRequest, judges: Judges, cluster: Cluster | None) -> tuple[PaperFile, KeptBatches]:
    """All batches, marked, those that an earlier run has kept among them.

    The papers are read twice: first to see which names stand twice and that all can be read, then to mark them.
    """
    assignment, parts = assignment_of(judges), judges.task.parts
    named = NamedLines(open_papers(request.answers, assignment.names, parts).entries)
    told = (assignment, request.answers, request.variant, BATCH)
    kept = KeptBatches(request.output or "", told_run(*told))
    papers = open_papers(request.answers, assignment.names, parts)
    total = -(-named.papers // BATCH)
    if kept.numbers:
        print(f"note: {len(kept.numbers)} of {total} batches were marked before", file=sys.stderr)
    entries = (name_remarked(varied_entry(entry, request.variant), named.first(entry)) for entry in papers.entries)
    left = ((number, batch) for number, batch in numbered_batches(entries) if number not in kept.numbers)
    try:
        with advancing("marking") as tell:
            for number, rows in marked_batches(left, judges, assignment, cluster):
                kept.store(number, rows)
                tell(len(kept.numbers) / total)
    except BaseException:
        if kept.numbers:
            said = f"{len(kept.numbers)} of {total} batches are kept in {kept.folder}"
            print(f"{said}: the same command goes on from there", file=sys.stderr)
        else:
            kept.remove()
        raise
    finally:
        named.table.close()
    if told_run(*told) != kept.told:
        kept.remove()
        raise file_error("it has changed while it was read", "begin once more", request.answers)
    return papers, kept


def marked_batches(
    batches: Iterable[tuple[int, list[Entry]]], judges: Judges, assignment: Assignment, cluster: Cluster | None
) -> Iterator[tuple[int, MarkedRows]]:
    """The rows of each batch, with its number, as they come."""
    if cluster is not None:
        return cluster.each(rows_of_worker, assignment, batches)
    marker = Marker(judges)
    return ((number, marker.rows(batch, assignment.names)) for number, batch in batches)


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
