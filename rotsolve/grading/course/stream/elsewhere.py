"""Elsewhere: the papers of a report, marked by several processes or by a cluster."""

from __future__ import annotations

from collections.abc import Sequence

from rotsolve.grading.course.examination import Chunk, Examination, MarkedChunks, Way
from rotsolve.grading.course.stream.assignment import BATCH, assignment_of
from rotsolve.grading.course.stream.cluster import Cluster
from rotsolve.grading.course.stream.marker import chunk_of_worker
from rotsolve.grading.course.stream.processes import Ended, each_in_processes


def size_and_way(
    examination: Examination, papers: int, jobs: int, cluster: Cluster | None
) -> tuple[int | None, Way | None]:
    """How many papers of a problem are sent at a time, and how; None where this process marks them all."""
    if cluster is not None:
        return BATCH, lambda chunks: by_cluster(examination, chunks, cluster)
    if jobs == 1 or papers <= 1:
        return None, None
    return min(BATCH, -(-papers // jobs)), lambda chunks: by_processes(examination, chunks, jobs)


def by_processes(examination: Examination, chunks: Sequence[Chunk], jobs: int) -> MarkedChunks:
    """Each chunk with what came of it; papers of a process that ended are not marked, and say why."""
    sent = chunk_of_worker, assignment_of(examination), enumerate(chunks)
    for number, found in each_in_processes(*sent, min(jobs, len(chunks))):
        chunk = chunks[number]
        if isinstance(found, Ended):
            why = f"the process that marked it {found.how}"
            found = [(student, why, -1) for student, _ in chunk.papers], {}
        yield chunk, *found


def by_cluster(examination: Examination, chunks: Sequence[Chunk], cluster: Cluster) -> MarkedChunks:
    """Each chunk with what came of it. Raises ClusterError where nobody marks it."""
    problems = [examination.task.tasks[chunk.place].number for chunk in chunks]
    sent = chunk_of_worker, assignment_of(examination), enumerate(chunks)
    for number, found in cluster.each(*sent, lambda number: f"some papers to problem {problems[number]}"):
        yield chunks[number], *found
