"""New: `rotsolve new KIND`: a scene to start from."""

from __future__ import annotations

import os
import sys
from typing import Annotated

import typer

from rotsolve.process import USAGE, orderly

Kind = Annotated[
    str | None, typer.Argument(metavar="[KIND]", help="What the scene is about; without it, all kinds are listed.")
]
Target = Annotated[
    str | None,
    typer.Option(
        "--output", "-o", metavar="FILE", help="Where to write it; - for standard output. [default: KIND.yaml]"
    ),
]
Force = Annotated[bool, typer.Option("--force", help="Write it even where a file is already.")]


def new_command(kind: Kind = None, output: Target = None, force: Force = False) -> None:
    """Write a scene to start from.

    It is a whole problem with comments, which can be solved as it is: change the numbers, the bodies, the questions.

    \b
    Examples:
      rotsolve new
      rotsolve new rolling
      rotsolve new rolling -o homework/3.yaml
      rotsolve new rolling -o -
    """
    from rotsolve.templates import template, template_kinds

    if kind is None:
        if output is not None or force:
            raise typer.BadParameter("say what the scene is about; `rotsolve new` lists the kinds", param_hint="'KIND'")
        kinds = template_kinds()
        with orderly():
            print("\n".join(f"{name:<{max(map(len, kinds))}}  {title}" for name, title in kinds.items()))
        return
    try:
        text = template(kind)
    except KeyError as error:
        print(f"error: {error.args[0]}", file=sys.stderr)
        raise typer.Exit(USAGE) from None
    if output == "-":
        with orderly():
            print(text, end="")
    else:
        write_new(output or f"{kind}.yaml", text, force)


def write_new(path: str, text: str, force: bool) -> None:
    """Write a file that is not there yet; one that is there only where that is wanted."""
    from rotsolve.run.delivery import write_file

    if os.path.lexists(path) and not force:
        print(f"error: {path} is there already", file=sys.stderr)
        print("help: name another file with -o, or write over it with --force", file=sys.stderr)
        raise typer.Exit(USAGE)
    code = write_file(path, text)
    if code:
        raise typer.Exit(code)
    print(f"{path} is written; solve it with: rotsolve solve {path}")
