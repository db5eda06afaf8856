"""The command line: arguments in, exit code out. It knows no physics, and imports what a command needs when it runs."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Annotated, NoReturn

import typer

from rotsolve import __version__
from rotsolve.cli.check import check_command
from rotsolve.cli.draw import draw_command
from rotsolve.cli.key import key_command
from rotsolve.cli.lsp import lsp_command
from rotsolve.cli.new import new_command
from rotsolve.cli.simulate import simulate_command
from rotsolve.cli.solve import solve_command
from rotsolve.process import USAGE, leave_after, orderly

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
      rotsolve new pulley
      rotsolve solve problems/pulleys/block-on-disc.yaml
      rotsolve solve problems/pulleys/block-on-disc.yaml --law energy --set m=3kg
      rotsolve draw problems/pulleys/block-on-disc.yaml -o picture.svg
      rotsolve key problems/pulleys/atwood.yaml --variants 30 -o sheets
      rotsolve check problems/pulleys/atwood.yaml class.csv -o report
      rotsolve elements string

    \b
    Exit codes:
      0  solved
      1  well formed, but not solvable
      2  a bad scene, or wrong usage
    """


Element = Annotated[
    list[str] | None, typer.Argument(metavar="[NAME]", help="An element, such as disc, string or hinge.")
]


def elements_command(name: Element = None) -> None:
    """Describe the elements of the scene language.

    All of them in a line each, or the one that is named in full.

    \b
    Examples:
      rotsolve elements
      rotsolve elements string
      rotsolve elements spherical shell
      rotsolve elements units
    """
    from rotsolve.scene import reference

    try:
        text = reference.describe_word(" ".join(name)) if name else reference.describe_all()
    except KeyError as error:
        print(f"error: {error.args[0]}", file=sys.stderr)
        raise typer.Exit(USAGE) from None
    with orderly():
        print(text.rstrip("\n"))


def schema_command(
    sheet: Annotated[bool, typer.Option("--sheet", help="That of a sheet file, which lists problems.")] = False,
) -> None:
    """Print the JSON Schema of a scene file.

    Editors complete and check a scene with it as it is written.

    \b
    Examples:
      rotsolve schema > scene.schema.json
      rotsolve schema --sheet > sheet.schema.json
    """
    import json

    if sheet:
        from rotsolve.scene.sheet_schema import sheet_schema as made
    else:
        from rotsolve.scene.schema import json_schema as made

    with orderly():
        print(json.dumps(made(), indent=2, ensure_ascii=False))


COMMANDS: dict[str, Callable[..., None]] = {  # in the order in which --help lists them
    "new": new_command,
    "solve": solve_command,
    "draw": draw_command,
    "simulate": simulate_command,
    "key": key_command,
    "check": check_command,
    "elements": elements_command,
    "schema": schema_command,
    "lsp": lsp_command,
}

for name, command in COMMANDS.items():
    app.command(name)(command)


def main(arguments: list[str] | None = None) -> NoReturn:
    """Run a command and leave with its exit code; nothing that happens shows a traceback."""
    leave_after(lambda: app(args=arguments, prog_name="rotsolve"))
