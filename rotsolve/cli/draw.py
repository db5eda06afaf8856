"""Draw: `rotsolve draw FILES…`: pictures of scenes."""

from __future__ import annotations

from typing import Annotated

import typer

from rotsolve.cli.options import Settings, one_of, read_settings, ready_for_bytes
from rotsolve.process import orderly

ENDINGS = {"svg": ".svg", "tikz": ".tex", "pdf": ".pdf", "png": ".png"}  # of the files of each format
BINARY = ("pdf", "png")

Files = Annotated[
    list[str],
    typer.Argument(
        metavar="FILES...", help="Scenes, folders, or patterns such as 'page/*.yaml'; - reads one from standard input."
    ),
]
Place = Annotated[
    str | None,
    typer.Option(
        "--output",
        "-o",
        metavar="FILE|DIR",
        help="Write to a file, .svg, .tex, .pdf or .png, or into a folder: a picture for each scene. [default: standard output]",
    ),
]
Kind = Annotated[
    str | None,
    typer.Option(
        "--format",
        "-f",
        metavar="|".join(ENDINGS),
        callback=lambda name: one_of(tuple(ENDINGS), name),
        help="Kind of picture. [default: by the name of -o, or svg]",
    ),
]
FreeBodies = Annotated[bool, typer.Option("--free-bodies", help="Draw each body alone with all that acts on it.")]
At = Annotated[str, typer.Option("--state", metavar="NAME", help="Draw the scene at this state. [default: the first]")]


def ending_chosen(format: str | None, output: str | None) -> str:
    """How the files end that are asked for; a usage error where a name says something else."""
    by_name = next((end for end in ENDINGS.values() if (output or "").lower().endswith(end)), None)
    wanted = ENDINGS[format] if format else None
    if wanted and by_name and wanted != by_name:
        raise typer.BadParameter(
            f"{output!r} does not end in {wanted}, as {format} pictures do", param_hint="'--output'"
        )
    ending = (wanted or by_name or ".svg").removeprefix(".")
    if ending in BINARY:
        ready_for_bytes(ending, output)
    return ending


def draw_command(
    files: Files,
    output: Place = None,
    format: Kind = None,
    free_bodies: FreeBodies = False,
    state: At = "",
    settings: Settings = None,
) -> None:
    """Draw scenes, or their free-body diagrams.

    \b
    Examples:
      rotsolve draw problems/pulleys/double-atwood.yaml -o atwood.svg
      rotsolve draw problems/hinged/ladder.yaml --free-bodies -o ladder.pdf
      rotsolve draw problems/angular-momentum/projectile-into-rod.yaml --state top > top.svg
      rotsolve draw problems/rolling -o pictures

    The bodies stand as the state says, to scale where sizes are given; a later state that tells how they stand then is dashed.
    """
    ends = ending_chosen(format, output)
    from rotsolve.drawing import DrawRequest, run_draw
    from rotsolve.run.attempt import scenes

    named = output is not None and output.lower().endswith(tuple(ENDINGS.values()))
    if (output is None or named) and len(scenes(tuple(files))) > 1:
        message = "several scenes are several pictures: name a folder for them"
        raise typer.BadParameter(message, param_hint="'--output'")
    with orderly():
        code = run_draw(DrawRequest(tuple(files), output, ends, free_bodies, state, read_settings(settings or [])))
    raise typer.Exit(code)
