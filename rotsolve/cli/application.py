"""Application: the command `rotsolve` itself, with what it says of all its commands."""

from __future__ import annotations

from typing import Annotated

import typer

from rotsolve import __version__

app = typer.Typer(
    rich_markup_mode=None,
    add_completion=False,
    pretty_exceptions_enable=False,
    no_args_is_help=True,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100},
)


def print_version(wanted: bool) -> None:
    if wanted:
        print(f"rotsolve {__version__}")
        raise typer.Exit


@app.callback()
def rotsolve(
    version: Annotated[
        bool, typer.Option("--version", callback=print_version, is_eager=True, help="Print the version and exit.")
    ] = False,
) -> None:
    """Solve textbook problems of turning bodies: exact answers, certified digits, and the derivation.

    \b
    Examples:
      rotsolve solve problems/pulleys/block-on-disc.yaml
      rotsolve solve problems/pulleys/block-on-disc.yaml --law energy --set m=3kg
      rotsolve key problems/pulleys/atwood.yaml --variants 30 -o sheets
      rotsolve check problems/pulleys/atwood.yaml class.csv -o report
      rotsolve elements string

    \b
    Exit codes:
      0  solved
      1  well formed, but not solvable
      2  a bad scene, or wrong usage
    """
