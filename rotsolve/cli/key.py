"""Key: `rotsolve key PROBLEMS… -o DIR`: problem sheets and their answer key."""

from __future__ import annotations

from fractions import Fraction
from typing import TYPE_CHECKING, Annotated

import typer

from rotsolve.cli.options import Digits, Seed, Spoken, one_of, ready_for_bytes
from rotsolve.language.sheet_keys import PAPERS
from rotsolve.page.formats import FORMATS
from rotsolve.process import orderly

if TYPE_CHECKING:
    from rotsolve.keys.command import Makers

MOST_VARIANTS = 100_000
PLATFORMS = ("moodle", "qti")
OTHERS = ("csv", *PLATFORMS)  # beside the formats of all pages

Problems = Annotated[
    list[str],
    typer.Argument(metavar="PROBLEMS...", help="A sheet file; or scenes, folders, patterns such as 'page/*.yaml'."),
]
Folder = Annotated[
    str, typer.Option("--output", "-o", metavar="DIR", help="The folder for the files; made if need be.")
]
Sheets = Annotated[
    list[str] | None,
    typer.Option(
        "--format",
        "-f",
        metavar="|".join((*FORMATS, *OTHERS)),
        callback=lambda names: [one_of((*FORMATS, *OTHERS), name) for name in names or ()],
        help="Output format; may be repeated. [default: html]",
    ),
]
Variants = Annotated[
    int | None,
    typer.Option(metavar="N", min=1, max=MOST_VARIANTS, help="Write N variants, as `vary` in the problems says."),
]
Heading = Annotated[str, typer.Option("--title", metavar="TEXT", help="The title of the sheet.")]
Paper = Annotated[
    str | None,
    typer.Option(
        "--paper",
        metavar="|".join(PAPERS),
        callback=lambda name: one_of(PAPERS, name),
        help="The paper. [default: the sheet file's, else a4]",
    ),
]
Pictures = Annotated[bool, typer.Option("--no-pictures", help="Leave out the pictures of the scenes.")]
Room = Annotated[
    str | None, typer.Option("--room", metavar="HEIGHT", help="Room for each answer: 3cm, or none. [default: 2cm]")
]
Ruled = Annotated[bool, typer.Option("--ruled", help="Lines to write on in that room.")]
Solutions = Annotated[bool, typer.Option("--solutions", help="Write the derivations too.")]


def key_command(
    problems: Problems,
    output: Folder,
    variants: Variants = None,
    seed: Seed = 1,
    solutions: Solutions = False,
    format: Sheets = None,
    digits: Digits = 4,
    language: Spoken = "en",
    title: Heading = "",
    paper: Paper = None,
    no_pictures: Pictures = False,
    room: Room = None,
    ruled: Ruled = False,
) -> None:
    """Write problem sheets and their answer key.

    \b
    Examples:
      rotsolve key problems/pulleys/atwood.yaml -o sheets
      rotsolve key problems/rolling -o sheets --solutions -f pdf
      rotsolve key problems/pulleys/atwood.yaml -o sheets --variants 30 -f html -f csv
      rotsolve key winch.yaml roll.yaml --title "Homework 4" --paper letter -o sheets -f pdf
      rotsolve key homework4.yaml -o sheets --solutions
      rotsolve key homework4.yaml -o platform --variants 30 -f moodle -f qti

    A sheet file lists problems with their order and points. sheet.html holds the statements, key.html the answers,
    solutions.html the derivations; with variants there are sheet-01.html and so on, and all of them in sheets.html.
    A problem that can't be solved is left out and said. For learning platforms moodle makes moodle.xml, and stack.xml for
    its plugin STACK; qti makes the packages qti21.zip and qti30.zip.
    """
    from rotsolve.keys.command import KeyRequest, run_key

    formats = tuple(dict.fromkeys(format or ("html",)))
    for name in formats:
        if name in FORMATS and FORMATS[name].binary:
            ready_for_bytes(name, output)
    height = room_of(room)
    chosen = (formats, variants or 0, seed, solutions, digits, language)
    with orderly():
        look = (title.strip(), paper or "", not no_pictures, height, ruled)
        code = run_key(KeyRequest(tuple(problems), output, *chosen, *look), platforms(formats))
    raise typer.Exit(code)


def platforms(formats: tuple[str, ...]) -> Makers:
    """What makes the files for learning platforms, where they are asked for."""
    if not set(formats) & {*PLATFORMS}:
        return {}
    from rotsolve.platforms.moodle_files import MoodleFiles
    from rotsolve.platforms.qti_files import QtiFiles

    return {
        "moodle": lambda asked: MoodleFiles(asked.digits, asked.language),
        "qti": lambda asked: QtiFiles(asked.digits, asked.language),
    }


def room_of(text: str | None) -> Fraction | None:
    """Millimetres of room for an answer; None where nothing is said."""
    if text is None:
        return None
    from rotsolve.keys.problem_set import room_in_mm

    found = room_in_mm(text)
    if found is None:
        raise typer.BadParameter(f"{text!r} is no height of a page; write 3cm, or none", param_hint="'--room'")
    return found
