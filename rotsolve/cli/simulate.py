"""Simulate: `rotsolve simulate FILE`: a scene followed in time."""

from __future__ import annotations

from math import isnan
from typing import Annotated

import typer

from rotsolve.cli.options import Output, Settings, Width, read_settings, seconds_of
from rotsolve.process import orderly, page_width

SHORTEST, LONGEST = 1e-9, 1e9  # seconds that a motion is followed
MOST_ROWS = 100_000


def time_checked(text: str, option: str) -> float:
    """A length of time in seconds that a motion may be followed."""
    seconds = seconds_of(text, option)
    if not SHORTEST <= seconds <= LONGEST:
        raise typer.BadParameter(f"{text!r} is not from {SHORTEST:g} s to {LONGEST:g} s", param_hint=option)
    return seconds


def refuse_wrong_outputs(plot: str | None, animate: str | None, csv: bool, output: str | None, show: bool) -> None:
    """A usage error where what is to be written has no place to go, or the wrong one."""
    if animate is not None and not animate.lower().endswith((".html", ".htm")):
        raise typer.BadParameter(f"{animate!r} is no .html", param_hint="'--animate'")
    if animate is not None and (csv or plot is not None):
        other = "numbers; leave one out" if csv else "a plot; ask for one after the other"
        raise typer.BadParameter(f"either a page or {other}", param_hint="'--animate'")
    if plot is not None and not plot.lower().endswith((".svg", ".png")):
        raise typer.BadParameter(f"{plot!r} is no .svg or .png", param_hint="'--plot'")
    if plot is not None and csv:
        raise typer.BadParameter("either a picture or numbers; leave one out", param_hint="'--csv'")
    if show and csv:
        raise typer.BadParameter("--csv prints all quantities; leave one out", param_hint="'--show'")
    if output is not None and not csv:
        message = "it is for numbers: say --csv too, or --plot FILE or --animate FILE for a picture"
        raise typer.BadParameter(message, param_hint="'--output'")


Scene = Annotated[str, typer.Argument(metavar="FILE", help="A scene; - reads one from standard input.")]
Until = Annotated[str, typer.Option(metavar="TIME", help="Follow the motion so long.")]
Step = Annotated[
    str | None,
    typer.Option(metavar="TIME", help="Time between two rows, or pictures. [default: about ten rows]"),
]
Accuracy = Annotated[
    float, typer.Option(metavar="X", min=1e-60, max=1e-2, help="Bound of each number, as a part of its largest size.")
]
Proved = Annotated[bool, typer.Option("--certified", help="Prove the bounds; it ends where something may happen.")]
Csv = Annotated[bool, typer.Option("--csv", help="Print all quantities with their bounds, separated by commas.")]
Plot = Annotated[str | None, typer.Option(metavar="FILE", help="Plot the motion into a file, .svg or .png.")]
Show = Annotated[
    list[str] | None,
    typer.Option(metavar="NAMES", help="Show these: string.tension, forces, motion …; may be repeated."),
]
Animate = Annotated[str | None, typer.Option(metavar="FILE", help="Write a page, .html, on which the scene moves.")]


def simulate_command(
    file: Scene,
    until: Until = "10s",
    step: Step = None,
    accuracy: Accuracy = 1e-9,
    certified: Proved = False,
    csv: Csv = False,
    output: Output = None,
    plot: Plot = None,
    animate: Animate = None,
    show: Show = None,
    settings: Settings = None,
    width: Width = None,
) -> None:
    """Follow a scene in time, from its first state on.

    \b
    Examples:
      rotsolve simulate problems/hinged/rod-30.yaml --until 5s
      rotsolve simulate problems/hinged/rod-30.yaml --until 5s --step 0.1s --csv
      rotsolve simulate problems/rolling/bowling-ball.yaml --until 3s --plot ball.svg
      rotsolve simulate problems/rolling/bowling-ball.yaml --until 3s --animate ball.html

    The equations of motion are those of the scene's own laws. Every digit shown is settled by the bound of its number.
    """
    refuse_wrong_outputs(plot, animate, csv, output, bool(show))
    seconds = time_checked(until, "'--until'")
    between = time_checked(step, "'--step'") if step is not None else None
    if between is not None and seconds / between > MOST_ROWS:
        raise typer.BadParameter(f"that makes more than {MOST_ROWS} rows", param_hint="'--step'")
    if isnan(accuracy):
        raise typer.BadParameter("it is no number", param_hint="'--accuracy'")
    from rotsolve.simulation.command import SimulationRequest, run_simulation

    with orderly():
        chosen = read_settings(settings or [])
        columns = width or page_width(None)
        request = SimulationRequest(
            file, seconds, accuracy, between, csv, plot, chosen, columns, certified, output, animate, tuple(show or ())
        )
        code = run_simulation(request)
    raise typer.Exit(code)
