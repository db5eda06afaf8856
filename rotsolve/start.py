"""Start: where the command begins. Files alone, or a problem with one answer, go straight to work; `cli` reads any other command line.

Loading what reads options and prints help would take an eighth of the time of a cold run. Nothing is imported before `process` has
told Python to look for cyclic garbage seldom: what it finds while modules load is nothing, and looking takes a hundredth of a run.
"""

from __future__ import annotations

import gc
import sys

TYPE_CHECKING = False  # as in `rotsolve`
if TYPE_CHECKING:
    from typing import NoReturn

# new objects after which Python looks for cycles among them; a scene makes few, and most live to its end
GARBAGE = 100_000


def process() -> NoReturn:
    """Run the command that this process was started for, and end it."""
    gc.set_threshold(GARBAGE)
    from rotsolve.lean import leave_out
    from rotsolve.process import end_at_once

    leave_out()
    try:
        main()
    except SystemExit as leaving:
        end_at_once(leaving)
        raise


def main() -> NoReturn:
    """Run the command of this process; SystemExit tells its exit code."""
    from rotsolve.process import leave_after

    match sys.argv[1:]:
        case ["solve", *files] if files and no_options(*files):
            leave_after(lambda: solve_at_once(files))
        case ["solve", "--no-confirm", *files] if files and no_options(*files):
            leave_after(lambda: solve_at_once(files, confirm=False))
        case ["check", problem, answers] if no_options(problem, answers):
            leave_after(lambda: check_at_once(problem, answers))
        case ["check", problem, "--answer" | "-a", typed] if no_options(problem):
            leave_after(lambda: check_at_once(problem, "", typed))
    from rotsolve.cli import main

    main()


def no_options(*words: str) -> bool:
    """Whether none of the words is an option."""
    return not any(word.startswith("-") for word in words)


def solve_at_once(files: list[str], *, confirm: bool = True) -> NoReturn:
    """`rotsolve solve FILES…`, all else by default."""
    from rotsolve.lean import keep_together, take_together
    from rotsolve.process import SOLVED, orderly, page_width

    with orderly():
        take_together()
        from rotsolve.run import SolveRequest, solve_files

        code = solve_files(SolveRequest(tuple(files), width=page_width(None), confirm=confirm))
    if code == SOLVED and confirm:
        keep_together()
    sys.exit(code)


def check_at_once(problem: str, answers: str, *typed: str) -> NoReturn:
    """`rotsolve check PROBLEM ANSWERS` or `--answer TEXT`, all else by default."""
    from rotsolve.lean import take_together
    from rotsolve.process import orderly, page_width

    with orderly():
        take_together()
        from rotsolve.grading.course.command import CheckRequest, run_check

        code = run_check(CheckRequest(problem, answers, typed, width=page_width(None)))
    sys.exit(code)
