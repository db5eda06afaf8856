"""Check: `rotsolve check PROBLEM ANSWERS`: the answers of a student or of a class, marked."""

from __future__ import annotations

from typing import Annotated

import typer

from rotsolve.cli.options import Seed, Width, one_of, ready_for_bytes
from rotsolve.page.formats import FORMATS
from rotsolve.process import orderly, page_width

Problem = Annotated[
    str,
    typer.Argument(
        metavar="PROBLEM", help="The scene that was set, or a sheet file; - reads a scene from standard input."
    ),
]
Answers = Annotated[
    str | None,
    typer.Argument(
        metavar="[ANSWERS]", help="YAML or text of one student, or a class's .csv or .parquet; - is standard input."
    ),
]
Typed = Annotated[
    list[str] | None,
    typer.Option("--answer", "-a", metavar="TEXT", help="An answer, 'a = 2mg/(2m+M)'; may be repeated."),
]
Report = Annotated[
    str | None,
    typer.Option(
        "--output",
        "-o",
        metavar="PATH",
        help="The folder of a class's report, the table of its marks, or one page's file.",
    ),
]
Pages = Annotated[
    str | None,
    typer.Option(
        "--format",
        "-f",
        metavar="|".join(FORMATS),
        callback=lambda name: one_of(tuple(FORMATS), name),
        help="[default: text; of a report, html]",
    ),
]
Number = Annotated[
    int | None, typer.Option("--variant", metavar="K", min=1, help="The variant of papers that name none.")
]
Jobs = Annotated[int, typer.Option("--jobs", "-j", metavar="N", min=1, help="Mark a class by so many processes.")]
Shown = Annotated[bool, typer.Option("--answers", help="Show the right answers on the pages of students.")]
Anew = Annotated[
    bool, typer.Option("--anew", help="Forget what earlier runs have put into the report, or have marked.")
]
Scheduler = Annotated[
    str | None,
    typer.Option(metavar="ADDRESS", help="Have a class marked by the workers of a dask scheduler, tcp://HOST:8786."),
]
Count = Annotated[int | None, typer.Option("--variants", metavar="N", min=1, help="How many variants there are.")]


def check_command(
    problem: Problem,
    answers: Answers = None,
    typed: Typed = None,
    output: Report = None,
    format: Pages = None,
    variant: Number = None,
    variants: Count = None,
    seed: Seed = 1,
    width: Width = None,
    jobs: Jobs = 1,
    answers_shown: Shown = False,
    anew: Anew = False,
    cluster: Scheduler = None,
) -> None:
    """Mark the answers of a student or of a class.

    \b
    Examples:
      rotsolve check problems/pulleys/block-on-disc.yaml --answer "a = 2mg/(2m+M)"
      rotsolve check problems/pulleys/block-on-disc.yaml ada.txt --variant 7
      rotsolve check problems/pulleys/block-on-disc.yaml class.csv -o report
      rotsolve check homework4.yaml class.csv -o report --answers
      rotsolve check homework4.yaml late.csv -o report
      rotsolve check homework4.yaml papers.parquet -o marks.csv --cluster tcp://10.0.0.1:8786

    \b
    Exit codes:
      0  all right
      1  something wrong or undecided, or a row that could not be marked
      2  a bad problem, bad answers, or wrong usage
    """
    from rotsolve.grading.course.command import CheckRequest, run_check

    if (answers is None) == (not typed):
        raise typer.BadParameter("either a file of answers, or --answer", param_hint="'ANSWERS'")
    chosen = (output, format, variant, variants, seed, width or page_width(output), jobs, answers_shown, anew)
    request = CheckRequest(problem, answers or "", tuple(typed or ()), *chosen, cluster)
    if cluster is not None and not request.of_class:
        raise typer.BadParameter("a cluster marks a class's table, .csv or .parquet", param_hint="'--cluster'")
    if FORMATS[request.shown_as].binary:
        ready_for_bytes(request.shown_as, output)
    with orderly():
        code = run_check(request)
    raise typer.Exit(code)
