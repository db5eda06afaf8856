"""run: solve the files of one command, write what each gave as soon as all before it are written, and work out the exit code."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Generator, Iterator
from contextlib import contextmanager
from time import monotonic
from typing import Any

from msgspec.structs import replace

from rotsolve.run.attempt import BAD, FileOutcome, SolveRequest, attempt, piped, scenes
from rotsolve.run.delivery import deliver

__all__ = ["SolveRequest", "solve_files"]

PATIENCE = 1.0  # seconds before a progress bar is worth its place


def solve_files(request: SolveRequest) -> int:
    """Solve every file, write what was solved and say what was not; the exit code is the worst one."""
    files = scenes(request.files)
    if request.output and any(same_file(request.output, file) for file in files):
        print(f"error: {request.output} is a scene to solve; it would be overwritten", file=sys.stderr)
        return BAD
    request = replace(request, files=files, coloured=request.streams and not request.show and coloured())
    if request.profile:
        from rotsolve.run.profiled import with_profile

        return with_profile(solve_and_deliver, request)
    return solve_and_deliver(request)


def solve_and_deliver(request: SolveRequest) -> int:
    """Solve the files and write what they gave, one after the other."""
    outcomes = with_progress(attempts(request), len(request.files))
    try:
        return deliver(outcomes, request)
    finally:
        outcomes.close()


def attempts(request: SolveRequest) -> Iterator[FileOutcome]:
    """What each file gave, in order: here, or by other processes where several are to work or none may take too long."""
    if request.jobs > 1 or request.time_limit is not None:
        from rotsolve.run.processes import attempts_in_processes

        yield from attempts_in_processes(request)
    else:
        text = piped(request.files)
        for file in request.files:
            yield attempt(file, request, text)


def with_progress(outcomes: Iterator[FileOutcome], total: int) -> Generator[FileOutcome]:
    """The outcomes one by one; once it takes long, and on a terminal, with a progress bar that makes room for what is written."""
    start, bar = monotonic(), None
    try:
        for done, outcome in enumerate(outcomes, 1):
            if bar is not None:
                bar.hide()
            yield outcome
            if done < total - (bar is None) and monotonic() - start > PATIENCE and sys.stderr.isatty():
                if bar is None:
                    from rotsolve.page.terminal import Bar

                    bar = Bar(total, sys.stderr)
                bar.show(done)
    finally:
        if bar is not None:
            bar.hide()


def coloured() -> bool:
    """Whether standard output is a terminal that wants colours."""
    return sys.stdout.isatty() and not os.environ.get("NO_COLOR") and os.environ.get("TERM") != "dumb"


def same_file(left: str, right: str) -> bool:
    try:
        return os.path.samefile(left, right)
    except OSError:
        return False


@contextmanager
def advancing(name: str) -> Iterator[Callable[[float], None]]:
    """What tells how much has been done: once it takes long, and on a terminal, by a bar."""
    if not sys.stderr.isatty():
        yield lambda part: None
        return
    start = monotonic()
    bars: list[Any] = []

    def tell(part: float) -> None:
        if not bars and monotonic() - start > PATIENCE:
            from rotsolve.page.terminal import Advance

            bars.append(Advance(name, sys.stderr))
        if bars:
            bars[0].to(part)

    try:
        yield tell
    finally:
        for bar in bars:
            bar.done()
