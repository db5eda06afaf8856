"""In processes: chunks of papers marked by several processes; each of them solves the problem of a chunk once more."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from pebble import ProcessExpired, ProcessPool

from rotsolve.grading.course.examination import Chunk, Done, marked_chunk
from rotsolve.grading.course.examiner import Judges
from rotsolve.grading.course.marked import Right
from rotsolve.language.problem import Problem
from rotsolve.run.processes import how_it_ended, interrupts_held, prepare_process, process_context


def chunks_in_processes(
    chunks: Sequence[Chunk], judges: Sequence[Judges], jobs: int
) -> Iterator[tuple[Chunk, list[Done], Right]]:
    """Each chunk with what came of it, in their order; papers of a process that ended are not marked, and say why."""
    pool = ProcessPool(min(jobs, len(chunks)), 0, prepare_process, context=process_context())
    try:
        with interrupts_held():  # the first chunk starts the processes
            waiting = [pool.schedule(marked_here, (chunk, *needed_by_process(judges[chunk.place]))) for chunk in chunks]
        for chunk, future in zip(chunks, waiting, strict=True):
            try:
                yield chunk, *future.result()
            except ProcessExpired as error:
                why = f"the process that marked it {how_it_ended(error.exitcode)}"
                yield chunk, [(student, why, -1) for student, _ in chunk.papers], {}
    finally:  # at the end, and where the user has had enough
        pool.stop()  # type: ignore[no-untyped-call]
        pool.join()


def needed_by_process(judges: Judges) -> tuple[Problem, int, int | None]:
    """All that another process has to know to judge as these do."""
    return judges.problem, judges.seed, judges.count


def marked_here(chunk: Chunk, problem: Problem, seed: int, count: int | None) -> tuple[list[Done], Right]:
    """A chunk, marked by this process, which solves its problem for it."""
    return marked_chunk(chunk, Judges(problem, seed, count))
