"""Processes: several files at once, each with its time limit; what ends the process of one file is that file's error."""

from __future__ import annotations

import multiprocessing
import signal
from collections import deque
from collections.abc import Iterator
from concurrent.futures import TimeoutError
from contextlib import contextmanager
from itertools import islice
from multiprocessing import resource_tracker
from typing import Any

from pebble import ProcessExpired, ProcessFuture, ProcessPool

from rotsolve.run.attempt import UNSOLVED, FileOutcome, SolveRequest, attempt, name_of, piped

AHEAD = 32  # files a process that are worked on, or wait to be written, at a time: what bounds the memory
FILES = 500  # that a process solves before a fresh one takes its place


def attempts_in_processes(request: SolveRequest) -> Iterator[FileOutcome]:
    """What each file gave, in order; a file is handed out once there is room for its page among those that wait."""
    text = piped(request.files)
    pool = ProcessPool(min(request.jobs, len(request.files)), FILES, prepare_process, context=process_context())
    rest, waiting = iter(request.files), deque[tuple[str, ProcessFuture[FileOutcome]]]()

    def hand_out() -> None:
        for file in islice(rest, AHEAD * request.jobs - len(waiting)):
            waiting.append((file, pool.schedule(attempt, (file, request, text), timeout=request.time_limit)))

    try:
        with interrupts_held():  # the first file starts the processes
            hand_out()
        while waiting:
            yield outcome_from(*waiting.popleft(), request.time_limit)
            hand_out()
    finally:  # at the end, and where the user or the reader of the pages has had enough
        pool.stop()  # type: ignore[no-untyped-call]
        pool.join()


@contextmanager
def interrupts_held() -> Iterator[None]:
    """An interrupt is heard when this is done: no process is left half started, and those that start now never hear one."""
    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    resource_tracker.ensure_running()  # which would let interrupts through once it has started
    before = signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGINT])
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def process_context() -> Any:
    """Processes that are copies of one which has imported the engine, where the system has such; else fresh ones."""
    if "forkserver" not in multiprocessing.get_all_start_methods():
        return multiprocessing.get_context("spawn")
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload(["rotsolve.pipeline", __name__])
    return context


def prepare_process() -> None:
    """Leave an interrupt to the process that reads the outcomes, and import the engine before the time of a file runs."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    import rotsolve.pipeline  # noqa: F401


def outcome_from(file: str, future: ProcessFuture[FileOutcome], limit: float | None) -> FileOutcome:
    """What a process has found out about a file; a message where it did not come to that."""
    try:
        return future.result()
    except TimeoutError:
        message = f"error: {name_of(file)} takes longer than {limit:g} s, the time limit"
        return FileOutcome(file, UNSOLVED, None, message, "time limit")
    except ProcessExpired as error:
        message = f"error: the process that solved {name_of(file)} {how_it_ended(error.exitcode)}"
        return FileOutcome(file, UNSOLVED, None, message, "crash")


def how_it_ended(code: int | None) -> str:
    """How a process ended, in words."""
    if code is None or code >= 0:
        return f"ended with code {code}"
    try:
        return f"was ended by the signal {signal.Signals(-code).name}"
    except ValueError:
        return f"was ended by signal {-code}"
