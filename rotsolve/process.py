"""Process: how a command meets its terminal, pipes and files, and how it leaves: with a word and an exit code, never a traceback."""

from __future__ import annotations

import atexit
import gc
import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import NoReturn

SOLVED, UNSOLVED, USAGE, BROKEN_PIPE, INTERRUPTED = 0, 1, 2, 141, 130


def leave_after(work: Callable[[], object]) -> NoReturn:
    """Do the work of a command, which may itself leave with an exit code; whatever goes wrong becomes one line."""
    prepare_streams()
    try:
        work()
    except Exception as error:
        from rotsolve.run.attempt import internal_error

        print(internal_error("rotsolve", error), file=sys.stderr)
        sys.exit(UNSOLVED)
    finally:
        gc.freeze()  # all that is left goes with the process: Python need not look through it for cycles once more
    sys.exit(SOLVED)


def end_at_once(leaving: SystemExit) -> None:
    """End a process that is leaving, without the twentieth of a cold run in which Python would take apart object by object.

    All that it owes others is done first. It returns, to be left in the ordinary way, where a debugger, a profiler or a thread
    counts on that, or where the output can't be written.
    """
    if not isinstance(leaving.code, int) or is_watched():
        return
    try:
        atexit._run_exitfuncs()
        sys.stdout.flush()
        sys.stderr.flush()
    except Exception:
        return
    os._exit(leaving.code)


def is_watched() -> bool:
    """Whether somebody follows what this process does, or a thread may still be at work."""
    tools = getattr(sys, "monitoring", None)  # from Python 3.12 on
    followed = tools is not None and any(tools.get_tool(number) is not None for number in range(6))
    threads = sys.modules.get("threading")
    at_work = threads is not None and threads.active_count() > 1
    return followed or at_work or sys.gettrace() is not None or sys.getprofile() is not None


def prepare_streams() -> None:
    """UTF-8 into pipes and files; on a terminal that lacks a letter, a question mark instead of a failure."""
    for stream in (sys.stdout, sys.stderr):
        reconfigure = getattr(stream, "reconfigure", None)
        if reconfigure is not None:
            reconfigure(errors="replace", encoding=None if stream.isatty() else "utf-8")


@contextmanager
def orderly() -> Iterator[None]:
    """A command that is interrupted, or whose output can't be written, leaves with a word and the usual exit code."""
    try:
        yield
        sys.stdout.flush()
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        sys.exit(INTERRUPTED)
    except OSError as error:  # what is still in the buffer has nowhere to go
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        if isinstance(error, BrokenPipeError):
            sys.exit(BROKEN_PIPE)
        print(f"error: cannot write the output: {error.strerror or error}", file=sys.stderr)
        sys.exit(USAGE)


def page_width(output: str | None) -> int:
    """The terminal's columns where the page goes to one, 120 elsewhere and at most."""
    if output or not sys.stdout.isatty():
        return 120
    import shutil

    return max(50, min(120, shutil.get_terminal_size((120, 24)).columns))
