"""The command line: arguments in, exit code out. It knows no physics, and imports what a command needs when it runs."""

from __future__ import annotations

import sys
from math import isnan
from typing import Annotated, NoReturn

import typer

from rotsolve import __version__
from rotsolve.process import USAGE, leave_after, orderly, page_width
from rotsolve.render import FORMATS, format_of_file

LAWS = ("newton", "energy", "angular-momentum")
STAGES = ("facts", "equations", "plan")
NAMES = tuple(item.name for item in FORMATS)
PAGES = ("text", "markdown", "html", "json")  # of marked answers
KEYS = ("html", "markdown", "latex", "json", "csv")
MOST_VARIANTS = 100_000
SHORTEST, LONGEST = 1e-9, 1e9  # seconds that a motion is followed
MOST_ROWS = 100_000

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


def one_of(choices: tuple[str, ...], value: str | None) -> str | None:
    """The value if it is one of the choices; a usage error that lists them otherwise."""
    if value is None or value in choices:
        return value
    raise typer.BadParameter(f"{value!r} is not one of {', '.join(choices)}")


def law_checked(value: str | None) -> str | None:
    return one_of(LAWS, value)


def format_checked(value: str | None) -> str | None:
    return one_of(NAMES, value)


def pages_checked(value: str | None) -> str | None:
    return one_of(PAGES, value)


def stage_checked(value: str | None) -> str | None:
    return one_of(STAGES, value)


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


def moment_checked(text: str | None) -> str | None:
    """The time as it is written, if it is one."""
    from rotsolve.scene.moment import read_moment

    try:
        return None if text is None else read_moment(text).text
    except ValueError as error:
        raise typer.BadParameter(str(error), param_hint="'--at'") from None


def limit_checked(text: str | None) -> float | None:
    """The time limit in seconds."""
    from rotsolve.scene.moment import read_seconds

    try:
        return None if text is None else read_seconds(text)
    except ValueError as error:
        raise typer.BadParameter(str(error), param_hint="'--time-limit'") from None


Files = Annotated[
    list[str],
    typer.Argument(
        metavar="FILES...", help="Scenes, folders, or patterns such as 'page/*.yaml'; - reads one from standard input."
    ),
]
Law = Annotated[
    str | None,
    typer.Option(metavar="|".join(LAWS), callback=law_checked, help="Solve by this law. [default: the shortest way]"),
]
Layout = Annotated[
    str | None,
    typer.Option(
        "--format",
        "-f",
        metavar="|".join(NAMES),
        callback=format_checked,
        help="Output format. [default: by the name of -o, or text]",
    ),
]
Output = Annotated[
    str | None, typer.Option("--output", "-o", metavar="FILE", help="Write to a file: all of it, or nothing.")
]
Digits = Annotated[int, typer.Option(metavar="N", min=1, max=50, help="Significant digits, each one certified.")]
Settings = Annotated[
    list[str] | None,
    typer.Option("--set", metavar="NAME=VALUE", help="Give a letter another value; may be repeated."),
]
At = Annotated[
    str | None, typer.Option(metavar="t=TIME", help="The value of functions of time at this moment, as t=2s.")
]
Show = Annotated[
    str | None,
    typer.Option(metavar="|".join(STAGES), callback=stage_checked, help="Print this stage instead of the derivation."),
]
Width = Annotated[
    int | None,
    typer.Option(metavar="N", min=50, max=400, help="Columns of text. [default: the terminal's, at most 120]"),
]
Timing = Annotated[
    bool, typer.Option("--profile", help="Say on standard error where the time went, and what was skipped.")
]
Jobs = Annotated[int, typer.Option("--jobs", "-j", metavar="N", min=1, help="Solve so many files at a time.")]
TimeLimit = Annotated[
    str | None, typer.Option(metavar="TIME", help="Give up a file that takes longer, as 10s. [default: none]")
]
Element = Annotated[
    list[str] | None, typer.Argument(metavar="[NAME]", help="An element, such as disc, string or hinge.")
]


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


@app.command()
def solve(
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
    from rotsolve.run import Request, run

    if show and format not in (None, "text"):
        raise typer.BadParameter("a stage is printed as text; leave --format out", param_hint="'--show'")
    if profile and (jobs > 1 or time_limit):
        raise typer.BadParameter("it looks at one process; leave --jobs and --time-limit out", param_hint="'--profile'")
    by_name = format_of_file(output) if output and not show else None
    chosen = format or (by_name.name if by_name else "text")
    if width is None:
        width = page_width(output)
    request = Request(
        tuple(files),
        law=law,
        format=chosen,
        output=output,
        digits=digits,
        settings=read_settings(settings or []),
        show=show,
        width=width,
        at=moment_checked(at),
        jobs=jobs,
        time_limit=limit_checked(time_limit),
        profile=profile,
    )
    with orderly():
        code = run(request)
    raise typer.Exit(code)


def time_checked(text: str, option: str) -> float:
    """A length of time in seconds, above zero."""
    from rotsolve.scene.moment import read_seconds

    try:
        seconds = read_seconds(text)
    except ValueError as error:
        raise typer.BadParameter(str(error), param_hint=option) from None
    if not SHORTEST <= seconds <= LONGEST:
        raise typer.BadParameter(f"{text!r} is not from {SHORTEST:g} s to {LONGEST:g} s", param_hint=option)
    return seconds


Scene = Annotated[str, typer.Argument(metavar="FILE", help="A scene; - reads one from standard input.")]
Until = Annotated[str, typer.Option(metavar="TIME", help="Follow the motion so long.")]
Step = Annotated[str | None, typer.Option(metavar="TIME", help="Time between two rows. [default: about ten rows]")]
Accuracy = Annotated[
    float,
    typer.Option(metavar="X", min=1e-60, max=1e-2, help="Bound of each number, as a part of its largest size."),
]
Proved = Annotated[bool, typer.Option("--certified", help="Prove the bounds; it ends where something may happen.")]
Csv = Annotated[bool, typer.Option("--csv", help="Print all quantities with their bounds, separated by commas.")]
Plot = Annotated[str | None, typer.Option(metavar="FILE", help="Draw the motion into a file, .svg or .png.")]


@app.command()
def simulate(
    file: Scene,
    until: Until = "10s",
    step: Step = None,
    accuracy: Accuracy = 1e-9,
    certified: Proved = False,
    csv: Csv = False,
    plot: Plot = None,
    settings: Settings = None,
    width: Width = None,
) -> None:
    """Follow a scene in time, from its first state on.

    \b
    Examples:
      rotsolve simulate problems/hinged/rod-30.yaml --until 5s
      rotsolve simulate problems/hinged/rod-30.yaml --until 5s --step 0.1s --csv
      rotsolve simulate problems/rolling/bowling-ball.yaml --until 3s --plot ball.svg

    The equations of motion are those of the scene's own laws. Every digit shown is settled by the bound of its number.
    """
    if plot is not None and not plot.lower().endswith((".svg", ".png")):
        raise typer.BadParameter(f"{plot!r} is no .svg or .png", param_hint="'--plot'")
    if plot is not None and csv:
        raise typer.BadParameter("either a picture or numbers; leave one out", param_hint="'--csv'")
    seconds = time_checked(until, "'--until'")
    between = time_checked(step, "'--step'") if step is not None else None
    if between is not None and seconds / between > MOST_ROWS:
        raise typer.BadParameter(f"that makes more than {MOST_ROWS} rows", param_hint="'--step'")
    if isnan(accuracy):
        raise typer.BadParameter("it is no number", param_hint="'--accuracy'")
    from rotsolve.simulation.command import Request, run

    with orderly():
        chosen = read_settings(settings or [])
        columns = width or page_width(None)
        code = run(Request(file, seconds, accuracy, between, csv, plot, chosen, columns, certified))
    raise typer.Exit(code)


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
        metavar="|".join(KEYS),
        callback=lambda names: [one_of(KEYS, name) for name in names or ()],
        help="Output format; may be repeated. [default: html]",
    ),
]
Variants = Annotated[
    int | None,
    typer.Option(metavar="N", min=1, max=MOST_VARIANTS, help="Write N variants, as `vary` in the problems says."),
]
Seed = Annotated[int, typer.Option(metavar="S", min=0, help="Other variants; the same number gives the same ones.")]
Solutions = Annotated[bool, typer.Option("--solutions", help="Write the derivations too.")]


@app.command()
def key(
    problems: Problems,
    output: Folder,
    variants: Variants = None,
    seed: Seed = 1,
    solutions: Solutions = False,
    format: Sheets = None,
    digits: Digits = 4,
) -> None:
    """Write problem sheets and their answer key.

    \b
    Examples:
      rotsolve key problems/pulleys/atwood.yaml -o sheets
      rotsolve key problems/rolling -o sheets --solutions -f latex
      rotsolve key problems/pulleys/atwood.yaml -o sheets --variants 30 -f html -f csv

    sheet.html holds the statements, key.html the answers, solutions.html the derivations; with variants there are
    sheet-01.html and so on, and all of them in sheets.html. A problem that can't be solved is left out and said.
    """
    from rotsolve.keys.command import Request, run

    formats = tuple(dict.fromkeys(format or ("html",)))
    with orderly():
        code = run(Request(tuple(problems), output, formats, variants or 0, seed, solutions, digits))
    raise typer.Exit(code)


Problem = Annotated[
    str, typer.Argument(metavar="PROBLEM", help="The scene that was set; - reads one from standard input.")
]
Answers = Annotated[
    str | None,
    typer.Argument(metavar="[ANSWERS]", help="YAML or text of one student, or a class's .csv; - is standard input."),
]
Typed = Annotated[
    list[str] | None,
    typer.Option("--answer", "-a", metavar="TEXT", help="An answer, 'a = 2mg/(2m+M)'; may be repeated."),
]
Report = Annotated[
    str | None,
    typer.Option("--output", "-o", metavar="PATH", help="The folder of a class's report, or one page's file."),
]
Pages = Annotated[
    str | None,
    typer.Option(
        "--format", "-f", metavar="|".join(PAGES), callback=pages_checked, help="[default: text; of a report, html]"
    ),
]
Number = Annotated[
    int | None, typer.Option("--variant", metavar="K", min=1, help="The variant of papers that name none.")
]
Count = Annotated[int | None, typer.Option("--variants", metavar="N", min=1, help="How many variants there are.")]


@app.command()
def check(
    problem: Problem,
    answers: Answers = None,
    typed: Typed = None,
    output: Report = None,
    format: Pages = None,
    variant: Number = None,
    variants: Count = None,
    seed: Seed = 1,
    width: Width = None,
) -> None:
    """Mark the answers of a student or of a class.

    \b
    Examples:
      rotsolve check problems/pulleys/block-on-disc.yaml --answer "a = 2mg/(2m+M)"
      rotsolve check problems/pulleys/block-on-disc.yaml ada.txt --variant 7
      rotsolve check problems/pulleys/block-on-disc.yaml class.csv -o report

    \b
    Exit codes:
      0  all right
      1  something wrong or undecided, or a row that could not be marked
      2  a bad problem, bad answers, or wrong usage
    """
    from rotsolve.grading.course.command import Request, run

    if (answers is None) == (not typed):
        raise typer.BadParameter("either a file of answers, or --answer", param_hint="'ANSWERS'")
    chosen = (output, format, variant, variants, seed, width or page_width(output))
    with orderly():
        code = run(Request(problem, answers or "", tuple(typed or ()), *chosen))
    raise typer.Exit(code)


@app.command()
def elements(name: Element = None) -> None:
    """Describe the elements of the scene language.

    All of them in a line each, or the one that is named in full.

    \b
    Examples:
      rotsolve elements
      rotsolve elements string
      rotsolve elements spherical shell
    """
    from rotsolve.scene import describe

    try:
        text = describe.describe(" ".join(name)) if name else describe.describe_all()
    except KeyError as error:
        print(f"error: {error.args[0]}", file=sys.stderr)
        raise typer.Exit(USAGE) from None
    with orderly():
        print(text.rstrip("\n"))


@app.command()
def schema() -> None:
    """Print the JSON Schema of a scene file.

    Editors complete and check a scene with it as it is written.

    \b
    Example:
      rotsolve schema > scene.schema.json
    """
    import json

    from rotsolve.scene.schema import json_schema

    with orderly():
        print(json.dumps(json_schema(), indent=2, ensure_ascii=False))


def main(arguments: list[str] | None = None) -> NoReturn:
    """Run a command and leave with its exit code; nothing that happens shows a traceback."""
    leave_after(lambda: app(args=arguments, prog_name="rotsolve"))
