"""Language: `rotsolve elements` and `rotsolve schema`: what a scene may say."""

from __future__ import annotations

import sys
from typing import Annotated

import typer

from rotsolve.process import USAGE, orderly

Element = Annotated[
    list[str] | None, typer.Argument(metavar="[NAME]", help="An element, such as disc, string or hinge.")
]


def elements(name: Element = None) -> None:
    """Describe the elements of the scene language.

    All of them in a line each, or the one that is named in full.

    \b
    Examples:
      rotsolve elements
      rotsolve elements string
      rotsolve elements spherical shell
    """
    from rotsolve.scene import reference

    try:
        text = reference.describe(" ".join(name)) if name else reference.describe_all()
    except KeyError as error:
        print(f"error: {error.args[0]}", file=sys.stderr)
        raise typer.Exit(USAGE) from None
    with orderly():
        print(text.rstrip("\n"))


def schema() -> None:
    """Print the JSON Schema of a scene file.

    Editors complete and check a scene with it as it is written.

    \b
    Example:
      rotsolve schema > scene.schema.json
    """
    import json

    from rotsolve.scene.reference import json_schema

    with orderly():
        print(json.dumps(json_schema(), indent=2, ensure_ascii=False))
