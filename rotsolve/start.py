"""Start: where the command begins. Files alone, or a problem with one answer, go straight to work; `cli` reads any other command line.

Loading what reads options and prints help would take an eighth of the time of a cold run.
"""

from __future__ import annotations

import sys
from typing import NoReturn

from rotsolve.process import end_at_once, leave_after, orderly, page_width


def process() -> NoReturn:
    """Run the command that this process was started for, and end it."""
    try:
        main()
    except SystemExit as leaving:
        end_at_once(leaving)
        raise


def main() -> NoReturn:
    """Run the command of this process; SystemExit tells its exit code."""
    match sys.argv[1:]:
        case ["solve", *files] if files and plain(*files):
            leave_after(lambda: solve(files))
        case ["check", problem, answers] if plain(problem, answers):
            leave_after(lambda: check(problem, answers))
        case ["check", problem, "--answer" | "-a", typed] if plain(problem):
            leave_after(lambda: check(problem, "", typed))
    from rotsolve.cli import main

    main()


def plain(*words: str) -> bool:
    """Whether none of the words is an option."""
    return not any(word.startswith("-") for word in words)


def solve(files: list[str]) -> NoReturn:
    """`rotsolve solve FILES…`, all else by default."""
    with orderly():
        from rotsolve.run import Request, run

        code = run(Request(tuple(files), width=page_width(None)))
    sys.exit(code)


def check(problem: str, answers: str, *typed: str) -> NoReturn:
    """`rotsolve check PROBLEM ANSWERS` or `--answer TEXT`, all else by default."""
    with orderly():
        from rotsolve.grading.course.command import CheckRequest, run_check

        code = run_check(CheckRequest(problem, answers, typed, width=page_width(None)))
    sys.exit(code)
