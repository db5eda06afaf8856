"""Key: `rotsolve key PROBLEMS… -o DIR`: problem sheets and their answer key."""

from __future__ import annotations

from typing import Annotated

import typer

from rotsolve.cli.options import Digits, Seed, Spoken, one_of, ready_for_bytes
from rotsolve.page.formats import FORMATS
from rotsolve.process import orderly

MOST_VARIANTS = 100_000

Problems = Annotated[
    list[str], typer.Argument(metavar="PROBLEMS...", help="Scenes, folders, or patterns such as 'page/*.yaml'.")
]
Folder = Annotated[
    str, typer.Option("--output", "-o", metavar="DIR", help="The folder for the files; made if need be.")
]
Sheets = Annotated[
    list[str] | None,
    typer.Option(
        "--format",
        "-f",
        metavar="|".join((*FORMATS, "csv")),
        callback=lambda names: [one_of((*FORMATS, "csv"), name) for name in names or ()],
        help="Output format; may be repeated. [default: html]",
    ),
]
Variants = Annotated[
    int | None,
    typer.Option(metavar="N", min=1, max=MOST_VARIANTS, help="Write N variants, as `vary` in the problems says."),
]
Solutions = Annotated[bool, typer.Option("--solutions", help="Write the derivations too.")]


def key_command(
    problems: Problems,
    output: Folder,
    variants: Variants = None,
    seed: Seed = 1,
    solutions: Solutions = False,
    format: Sheets = None,
    digits: Digits = 4,
    language: Spoken = "en",
) -> None:
    """Write problem sheets and their answer key.

    \b
    Examples:
      rotsolve key problems/pulleys/atwood.yaml -o sheets
      rotsolve key problems/rolling -o sheets --solutions -f pdf
      rotsolve key problems/pulleys/atwood.yaml -o sheets --variants 30 -f html -f csv

    sheet.html holds the statements, key.html the answers, solutions.html the derivations; with variants there are
    sheet-01.html and so on, and all of them in sheets.html. A problem that can't be solved is left out and said.
    """
    from rotsolve.keys.command import KeyRequest, run_key

    formats = tuple(dict.fromkeys(format or ("html",)))
    for name in formats:
        if name in FORMATS and FORMATS[name].binary:
            ready_for_bytes(name, output)
    with orderly():
        code = run_key(KeyRequest(tuple(problems), output, formats, variants or 0, seed, solutions, digits, language))
    raise typer.Exit(code)
