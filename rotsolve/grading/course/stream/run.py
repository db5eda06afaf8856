"""Run: papers without end, marked batch by batch into a table of marks, by this process, by several, or by a cluster."""

from __future__ import annotations

import sys
from collections.abc import Iterable, Iterator

from rotsolve.core.faults import RotsolveError
from rotsolve.grading.course.command import ALL_RIGHT, NOT_ALL_RIGHT, CheckRequest, refuse_check
from rotsolve.grading.course.examination import Examination
from rotsolve.grading.course.handed_in import file_error
from rotsolve.grading.course.report.tally import Tally, head_of_class
from rotsolve.grading.course.stream.assignment import BATCH, MarkedRows, assignment_of, named_batch, numbered_batches
from rotsolve.grading.course.stream.cluster import Cluster, joined_cluster
from rotsolve.grading.course.stream.kept import KeptBatches, told_run
from rotsolve.grading.course.stream.marker import Marker, rows_of_worker
from rotsolve.grading.course.stream.names import NamedEntry, NamedLines
from rotsolve.grading.course.stream.papers import PaperFile, open_papers
from rotsolve.grading.course.stream.processes import Ended, each_in_processes
from rotsolve.grading.course.stream.table_of_marks import write_marks
from rotsolve.grading.course.table import varied_entry
from rotsolve.run import advancing, same_file


class ProcessError(RotsolveError):
    """Why processes can't mark."""


def mark_stream(request: CheckRequest, examination: Examination) -> int:
    """Mark all papers of a table into the file that is asked for; the exit code says whether all is right."""
    fault = marks_objection(request)
    if fault:
        return refuse_check(f"error: {fault}")
    with joined_cluster(request.cluster) as cluster:
        papers, kept = marked_into_parts(request, examination, cluster)
    tally, task = Tally(), examination.task
    write_marks(request.output or "", counted_rows(kept.in_order(), tally), task, papers)
    kept.remove()
    print("\n".join(head_of_class(task, papers.columns, papers.columns.held(task), tally, examination.seed)))
    print(f"The marks are in {request.output}.")
    return ALL_RIGHT if tally.all_faultless else NOT_ALL_RIGHT


def marked_into_parts(
    request: CheckRequest, examination: Examination, cluster: Cluster | None
) -> tuple[PaperFile, KeptBatches]:
    """All batches, marked, those that an earlier run has kept among them.

    The papers are read twice: first to see which names stand twice and that all can be read, then to mark them.
    """
    lines = NamedLines(open_papers(request.answers, examination.task).entries)
    told = (examination, request.answers, request.variant, BATCH)
    kept = KeptBatches(request.output or "", told_run(*told), request.anew)
    papers = open_papers(request.answers, examination.task)
    total = -(-lines.papers // BATCH)
    if kept.numbers:
        print(f"note: {len(kept.numbers)} of {total} batches were marked before", file=sys.stderr)
    named = (lines.named(varied_entry(entry, request.variant)) for entry in papers.entries)
    left = ((number, batch) for number, batch in numbered_batches(named) if number not in kept.numbers)
    try:
        with advancing("marking") as tell:
            for number, rows in marked_batches(left, examination, request.jobs, cluster):
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
        lines.table.close()
    if told_run(*told) != kept.told:
        kept.remove()
        raise file_error("it has changed while it was read", "begin once more", request.answers)
    return papers, kept


def marked_batches(
    batches: Iterable[tuple[int, list[NamedEntry]]], examination: Examination, jobs: int, cluster: Cluster | None
) -> Iterator[tuple[int, MarkedRows]]:
    """The rows of each batch, with its number, as they come."""
    if cluster is not None:
        yield from cluster.each(rows_of_worker, assignment_of(examination), batches, named_batch)
    elif jobs == 1:
        marker = Marker(examination)
        yield from ((number, marker.rows(batch)) for number, batch in batches)
    else:
        for number, found in each_in_processes(rows_of_worker, assignment_of(examination), batches, jobs):
            if isinstance(found, Ended):
                said = f"the process that marked {named_batch(number)} {found.how}"
                raise ProcessError(f"{said}: has it enough memory?")
            yield number, found


def counted_rows(batches: Iterable[MarkedRows], tally: Tally) -> Iterator[list[str]]:
    """The rows of all batches, which are counted as they pass."""
    for batch in batches:
        tally.add(batch.tally)
        yield from batch.rows


def marks_objection(request: CheckRequest) -> str:
    """Why the marks can't be where or as it is asked for, '' where they can."""
    output = request.output or ""
    if request.format is not None:
        return f"{output} is a table of marks, which has no format of pages; leave out -f {request.format}"
    if request.shows_right:
        return f"{output} is a table of marks, which has no pages of students; leave out --answers"
    for name in (request.answers, request.problem):
        if same_file(output, name):
            return f"{name} would be overwritten"
    return ""
