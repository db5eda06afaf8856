"""Options: what several commands take, and how their values are checked."""

from __future__ import annotations

import sys
from typing import Annotated

import typer

from rotsolve.page.languages import LANGUAGES

Output = Annotated[
    str | None, typer.Option("--output", "-o", metavar="FILE", help="Write to a file: all of it, or nothing.")
]
Digits = Annotated[int, typer.Option(metavar="N", min=1, max=50, help="Significant digits, each one certified.")]
Settings = Annotated[
    list[str] | None, typer.Option("--set", metavar="NAME=VALUE", help="Give a letter another value; may be repeated.")
]
Width = Annotated[
    int | None,
    typer.Option(metavar="N", min=50, max=400, help="Columns of text. [default: the terminal's, at most 120]"),
]
Spoken = Annotated[
    str,
    typer.Option(
        "--language",
        metavar="|".join(LANGUAGES),
        callback=lambda name: one_of(tuple(LANGUAGES), name),
        help="The language of the pages.",
    ),
]
Seed = Annotated[int, typer.Option(metavar="S", min=0, help="Other variants; the same number gives the same ones.")]


def one_of(choices: tuple[str, ...], value: str | None) -> str | None:
    """The value if it is one of the choices; a usage error that lists them otherwise."""
    if value is None or value in choices:
        return value
    raise typer.BadParameter(f"{value!r} is not one of {', '.join(choices)}")


def ready_for_bytes(kind: str, output: str | None) -> None:
    """A usage error where what is no text, such as a PDF, can not be made here, or would go to a terminal."""
    from rotsolve.page.press import MISSING, lacks_press

    if lacks_press():
        raise typer.BadParameter(MISSING.format(kind.upper()), param_hint="'--format'")
    if output is None and sys.stdout.isatty():
        message = f"a {kind.upper()} is no text for a terminal; name a file with -o, or lead it into a pipe"
        raise typer.BadParameter(message, param_hint="'--output'")


def seconds_of(text: str, option: str) -> float:
    """A length of time in seconds, above zero."""
    from rotsolve.scene.values import read_seconds

    try:
        return read_seconds(text)
    except ValueError as error:
        raise typer.BadParameter(str(error), param_hint=option) from None


def read_settings(pairs: list[str]) -> dict[str, str]:
    """`m=3kg` as {'m': '3kg'}; a name set twice or a pair without `=` is a usage error."""
    settings: dict[str, str] = {}
    for pair in pairs:
        name, equals, value = (part.strip() for part in pair.partition("="))
        if not (name and equals and value):
            raise typer.BadParameter(f"{pair!r} is not of the form NAME=VALUE, as in m=3kg", param_hint="'--set'")
        if name in settings:
            raise typer.BadParameter(f"{name!r} is set twice", param_hint="'--set'")
        settings[name] = value
    return settings
