"""Processes: batches marked by several processes of this machine."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, Future, wait
from typing import TypeVar

from msgspec import Struct
from pebble import ProcessExpired, ProcessPool

from rotsolve.grading.course.stream.assignment import Assignment
from rotsolve.run.processes import how_it_ended, interrupts_held, prepare_process, process_context

Given = TypeVar("Given")
Done = TypeVar("Done")
AHEAD = 2  # batches that are out at a time, for each process


class Ended(Struct, frozen=True):
    """In the place of what comes of a batch whose process ended: how it did."""

    how: str


def each_in_processes(
    work: Callable[[Assignment, Given], Done], assignment: Assignment, batches: Iterable[tuple[int, Given]], jobs: int
) -> Iterator[tuple[int, Done | Ended]]:
    """What comes of each batch, with its number, once, as soon as it is there; few are out at a time."""
    pool = ProcessPool(jobs, 0, prepare_process, context=process_context())
    out: dict[Future[Done | Ended], int] = {}
    try:
        for number, batch in batches:
            while len(out) >= AHEAD * jobs:
                yield next_done(out)
            with interrupts_held():  # the first batch starts the processes
                out[pool.schedule(work, (assignment, batch))] = number
        while out:
            yield next_done(out)
    finally:  # at the end, and where the user has had enough
        pool.stop()  # type: ignore[no-untyped-call]
        pool.join()


def next_done(out: dict[Future[Done | Ended], int]) -> tuple[int, Done | Ended]:
    """The first batch that is done, which is taken out of those that are not."""
    future = next(iter(wait(out, return_when=FIRST_COMPLETED).done))
    number = out.pop(future)
    try:
        return number, future.result()
    except ProcessExpired as error:
        return number, Ended(how_it_ended(error.exitcode))
