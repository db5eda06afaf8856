"""Solve: `rotsolve solve FILES…`: scenes and their derivations."""

from __future__ import annotations

from typing import Annotated

import typer
from msgspec.structs import replace

from rotsolve.cli.options import (
    Digits,
    Output,
    Settings,
    Spoken,
    Width,
    one_of,
    read_settings,
    ready_for_bytes,
    seconds_of,
)
from rotsolve.page.depth import DETAILS, NORMAL, NUMBERS, STEPS
from rotsolve.page.formats import FORMATS, format_of_file
from rotsolve.process import orderly, page_width

LAWS = ("newton", "energy", "angular-momentum", "lagrange")
STAGES = ("facts", "equations", "plan", "confirm")


def moment_checked(text: str | None) -> str | None:
    """The time as it is written, if it is one."""
    from rotsolve.scene.values import read_time

    try:
        return None if text is None else read_time(text).text
    except ValueError as error:
        raise typer.BadParameter(str(error), param_hint="'--at'") from None


def format_chosen(format: str | None, output: str | None, show: str | None) -> str:
    """The format that is asked for, by the name of the file where it is not said."""
    by_name = format_of_file(output) if output and not show else None
    chosen = FORMATS[format or (by_name.name if by_name else "text")]
    if chosen.binary:
        ready_for_bytes(chosen.name, output)
    return chosen.name


Files = Annotated[
    list[str],
    typer.Argument(
        metavar="FILES...", help="Scenes, folders, or patterns such as 'page/*.yaml'; - reads one from standard input."
    ),
]
Law = Annotated[
    str | None,
    typer.Option(
        metavar="|".join(LAWS),
        callback=lambda law: one_of(LAWS, law),
        help="Solve by this law. [default: the shortest way]",
    ),
]
Layout = Annotated[
    str | None,
    typer.Option(
        "--format",
        "-f",
        metavar="|".join(FORMATS),
        callback=lambda name: one_of(tuple(FORMATS), name),
        help="Output format. [default: by the name of -o, or text]",
    ),
]
At = Annotated[
    str | None, typer.Option(metavar="t=TIME", help="The value of functions of time at this moment, as t=2s.")
]
Show = Annotated[
    str | None,
    typer.Option(
        metavar="|".join(STAGES),
        callback=lambda stage: one_of(STAGES, stage),
        help="Print this stage instead of the derivation.",
    ),
]
Timing = Annotated[
    bool, typer.Option("--profile", help="Say on standard error where the time went, and what was skipped.")
]
Confirm = Annotated[
    bool,
    typer.Option("--confirm/--no-confirm", help="Hold an assembly of all bodies' equations against the answers."),
]
Pictures = Annotated[
    bool,
    typer.Option(
        "--pictures/--no-pictures", help="Draw the scene in HTML, LaTeX, Typst and PDF, above its derivation."
    ),
]
Detail = Annotated[
    str,
    typer.Option(
        metavar="|".join(DETAILS),
        callback=lambda name: one_of(DETAILS, name),
        help="Laws and answers; the plan, forces and steps too; the way of a second law as well.",
    ),
]
Numbers = Annotated[
    str,
    typer.Option(
        metavar="|".join(NUMBERS),
        callback=lambda name: one_of(NUMBERS, name),
        help="Letters alone wherever there are formulas; values of the answers; numbers put in at the end of a stage.",
    ),
]
Jobs = Annotated[int, typer.Option("--jobs", "-j", metavar="N", min=1, help="Solve so many files at a time.")]
TimeLimit = Annotated[
    str | None, typer.Option(metavar="TIME", help="Give up a file that takes longer, as 10s. [default: none]")
]


def solve_command(
    files: Files,
    law: Law = None,
    format: Layout = None,
    output: Output = None,
    digits: Digits = 4,
    settings: Settings = None,
    at: At = None,
    show: Show = None,
    width: Width = None,
    jobs: Jobs = 1,
    time_limit: TimeLimit = None,
    confirm: Confirm = True,
    pictures: Pictures = True,
    detail: Detail = NORMAL,
    numbers: Numbers = STEPS,
    language: Spoken = "en",
    profile: Timing = False,
) -> None:
    """Solve scenes, and print the derivation of each.

    \b
    Examples:
      rotsolve solve problems/pulleys/block-on-disc.yaml
      rotsolve solve problems/pulleys/block-on-disc.yaml --law energy
      rotsolve solve problems/pulleys/block-on-disc.yaml --set m=3kg --digits 10
      rotsolve solve problems/rolling -o answers.tex
      rotsolve solve problems --jobs 4 --time-limit 10s
      rotsolve solve problems/pulleys/block-on-disc.yaml --show equations

    A page is printed as soon as all before it are. A file that fails, takes too long or ends its process neither stops
    nor hides the others: its message goes to standard error, and the exit code is that of the worst file.
    """
    from rotsolve.run import SolveRequest, solve_files

    if show and format not in (None, "text"):
        raise typer.BadParameter("a stage is printed as text; leave --format out", param_hint="'--show'")
    if profile and (jobs > 1 or time_limit):
        raise typer.BadParameter("it looks at one process; leave --jobs and --time-limit out", param_hint="'--profile'")
    page = (format_chosen(format, output, show), output, digits)
    request = SolveRequest(tuple(files), law, *page, read_settings(settings or []), show, width or page_width(output))
    limit = None if time_limit is None else seconds_of(time_limit, "'--time-limit'")
    run = {"at": moment_checked(at), "jobs": jobs, "time_limit": limit, "profile": profile, "confirm": confirm}
    told = {"pictures": pictures, "detail": detail, "numbers": numbers, "language": language}
    request = replace(request, **run, **told)
    with orderly():
        code = solve_files(request)
    raise typer.Exit(code)
