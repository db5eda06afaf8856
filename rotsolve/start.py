"""Start: where the command begins. Files alone go straight to work; any other command line is read by `cli`.

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
    command, *files = sys.argv[1:] or [""]
    if command == "solve" and files and not any(file.startswith("-") for file in files):
        leave_after(lambda: solve(files))
    from rotsolve.cli import main

    main()


def solve(files: list[str]) -> NoReturn:
    """`rotsolve solve FILES…`, all else by default."""
    with orderly():
        from rotsolve.run import Request, run

        code = run(Request(tuple(files), width=page_width(None)))
    sys.exit(code)
