"""The command line: arguments in, exit code out. It knows no physics, and imports what a command needs when it runs."""

from __future__ import annotations

from typing import NoReturn

from rotsolve.cli.application import app
from rotsolve.cli.check import check
from rotsolve.cli.key import key
from rotsolve.cli.language import elements, schema
from rotsolve.cli.simulate import simulate
from rotsolve.cli.solve import solve
from rotsolve.process import leave_after

COMMANDS = (solve, simulate, key, check, elements, schema)  # in the order in which --help lists them

for command in COMMANDS:
    app.command()(command)


def main(arguments: list[str] | None = None) -> NoReturn:
    """Run a command and leave with its exit code; nothing that happens shows a traceback."""
    leave_after(lambda: app(args=arguments, prog_name="rotsolve"))
