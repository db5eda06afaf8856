"""Trial: a scene solved in a process of its own while its author writes on: what refuses it, and what objects to its answers.

The engine is neither fast nor sure to end on a scene that is half done, and it keeps state of its own: it never runs in the server's
process.
"""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor

from pebble import ProcessFuture, ProcessPool

from rotsolve.algebra.notation.text import to_text
from rotsolve.core.faults import CONTRADICTORY, Fault, SceneError, Unsolvable
from rotsolve.run.processes import interrupts_held, prepare_process, process_context

SECONDS = 20.0  # after which nothing is said of a scene


def objections(text: str) -> tuple[Fault, ...]:
    """Why a scene has no answer, or some of its questions have none; nothing of one that is solved."""
    from rotsolve.pipeline import solve

    try:
        solution = solve(text if "\n" in text else text + "\n")
    except SceneError as error:
        return error.faults
    except Unsolvable as error:
        return (error.fault, *error.others)
    refused = tuple(reason.fault for reason in solution.refused.values())
    against = [check.words for check in solution.derivation.checks if check.holds is False]
    told = ["".join(part if isinstance(part, str) else to_text(part) for part in words) for words in against]
    return (*refused, *(Fault(text, None, "", CONTRADICTORY) for text in told))


class BackgroundTrial:
    """One trial at a time: a new one takes the place of the one that runs.

    All is done by a thread of its own, since a process takes its time to start, and the server answers meanwhile.
    """

    def __init__(self) -> None:
        self.thread = ThreadPoolExecutor(1)
        self.pool: ProcessPool | None = None
        self.running: ProcessFuture[tuple[Fault, ...]] | None = None

    def begin(self, text: str, then: Callable[[tuple[Fault, ...]], object]) -> None:
        """Try a text; `then` is called from another thread, unless the trial fails, takes too long or another one begins."""
        self.thread.submit(self.run, text, then)

    def run(self, text: str, then: Callable[[tuple[Fault, ...]], object]) -> None:
        self.break_off()
        if self.pool is None:
            self.pool = ProcessPool(1, initializer=prepare_process, context=process_context())

        def done(future: Future[tuple[Fault, ...]]) -> None:
            if not future.cancelled() and future.exception() is None:
                then(future.result())

        with interrupts_held():
            self.running = self.pool.schedule(objections, (text,), timeout=SECONDS)
        self.running.add_done_callback(done)

    def stop(self) -> None:
        """Break off the trial that runs, if one does."""
        self.thread.submit(self.break_off)

    def break_off(self) -> None:
        if self.running is not None and not self.running.done():
            self.running.cancel()  # type: ignore[no-untyped-call]

    def end(self) -> None:
        """End the process, with what it is at."""
        self.thread.shutdown(cancel_futures=True)
        if self.pool is not None:
            self.pool.stop()  # type: ignore[no-untyped-call]
            self.pool.join()
