"""Crew: worker processes that run trials; one that takes too long is ended, and its trial is the one that hung."""

from __future__ import annotations

import multiprocessing as mp
import signal
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from multiprocessing.connection import Connection, wait
from multiprocessing.process import BaseProcess

from trials.trial import Result

CHUNK = 20  # trials handed out at a time
BUSY = 30  # times its limit of CPU that a trial may take by the clock, where a machine has other work
Run = Callable[[int, int], Result]


def work(pipe: Connection, run: Run, seed: int, limit: float) -> None:
    """Run the trials that come in, one answer each, until there are no more; the process ends at one that takes more CPU than its limit."""
    while (numbers := pipe.recv()) is not None:
        for number in numbers:
            signal.setitimer(signal.ITIMER_PROF, limit)
            pipe.send(run(seed, number))


@dataclass
class Worker:
    """A process with the trials that it has still to do, and since when it is at the first of them."""

    process: BaseProcess
    pipe: Connection
    open: list[int] = field(default_factory=list)
    since: float = 0.0

    @staticmethod
    def start(run: Run, seed: int, limit: float) -> Worker:
        ours, theirs = mp.Pipe()
        process = mp.get_context("fork").Process(target=work, args=(theirs, run, seed, limit), daemon=True)
        process.start()
        theirs.close()
        return Worker(process, ours)

    def give(self, numbers: list[int]) -> None:
        self.open, self.since = numbers, time.monotonic()
        self.pipe.send(numbers)

    def end(self) -> None:
        self.process.kill()
        self.process.join()
        self.pipe.close()


def run_all(run: Run, seed: int, numbers: range, jobs: int, limit: float) -> Iterator[Result]:
    """All trials over several processes, as they are done; `limit` is the seconds of CPU that one may take."""
    pending = [list(numbers[start : start + CHUNK]) for start in range(0, len(numbers), CHUNK)][::-1]
    crew = [Worker.start(run, seed, limit) for _ in range(jobs)]
    for worker in crew:
        if pending:
            worker.give(pending.pop())
    while any(worker.open for worker in crew):
        ready = wait([worker.pipe for worker in crew if worker.open], timeout=1.0)
        for place, worker in enumerate(crew):
            if worker.pipe in ready:
                yield received(worker, limit)
            elif worker.open and time.monotonic() - worker.since > BUSY * limit:
                yield hung(worker, f"no end after {BUSY * limit:.0f} s")
            if not worker.process.is_alive():
                rest, crew[place] = worker.open, Worker.start(run, seed, limit)
                pending += [rest] if rest else []
            if pending and not crew[place].open:
                crew[place].give(pending.pop())
    for worker in crew:
        worker.end()


def received(worker: Worker, limit: float) -> Result:
    try:
        result: Result = worker.pipe.recv()
    except EOFError:
        worker.process.join()
        long = worker.process.exitcode == -signal.SIGPROF
        return hung(worker, f"no end after {limit:.0f} s of CPU" if long else "the process died")
    worker.open.remove(result.number)
    worker.since = time.monotonic()
    return result


def hung(worker: Worker, why: str) -> Result:
    """The trial that a worker was at; the worker is ended."""
    number = worker.open.pop(0)
    worker.end()
    return Result(number, "", "hang", 0.0, (why,), "")
