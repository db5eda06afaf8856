"""Drawing: `rotsolve draw`: pictures of scenes to standard output or into files, each file whole or not at all, and the exit code."""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Callable
from pathlib import Path

from msgspec import Struct, field

from rotsolve.core.faults import Unsolvable
from rotsolve.draw.paper.figure import Figure
from rotsolve.draw.pictures import free_body_picture, scene_picture
from rotsolve.language.problem import Problem
from rotsolve.pipeline import solve_problem
from rotsolve.run import advancing
from rotsolve.run.attempt import BAD, SOLVED, failure_outcome, piped, scene_source, scenes
from rotsolve.run.delivery import put_content, say, summary, write_file
from rotsolve.scene.read import read_source


class DrawRequest(Struct, frozen=True):
    """What the command line asked for; without `output` a picture goes to standard output."""

    files: tuple[str, ...]
    output: str | None = None
    format: str = "svg"
    free_bodies: bool = False
    state: str = ""
    settings: dict[str, str] = field(default_factory=dict)


def as_svg(figure: Figure) -> str:
    from rotsolve.draw.paper.svg import svg

    return svg(figure)


def as_tikz(figure: Figure) -> str:
    from rotsolve.draw.paper.tikz import document

    return document([figure])


def as_pdf(figure: Figure) -> bytes:
    from rotsolve.page.press import printed_picture

    return printed_picture(figure, "pdf")


def as_png(figure: Figure) -> bytes:
    from rotsolve.page.press import printed_picture

    return printed_picture(figure, "png")


WRITERS: dict[str, Callable[[Figure], str | bytes]] = {  # by how their files end
    "svg": as_svg,
    "tex": as_tikz,
    "pdf": as_pdf,
    "png": as_png,
}


def run_draw(request: DrawRequest) -> int:
    """Draw all scenes; one that can't be drawn is said, and stops no other."""
    files = scenes(request.files)
    text, code, failed = piped(files), SOLVED, list[str]()
    names = file_names(files, request)
    with advancing("pictures") as tell:
        for number, file in enumerate(files, 1):
            try:
                picture = WRITERS[request.format](
                    picture_asked(read_source(scene_source(file, text), request.settings), request)
                )
            except Exception as error:
                outcome = failure_outcome(file, error)
                say(outcome.message, follows=bool(failed))
                failed.append(outcome.file)
                code = max(code, outcome.code)
                continue
            code = max(code, put_picture(picture, names[file]))
            tell(number / len(files))
    if failed and len(files) > 1:
        say(summary(failed, len(files)).replace("not solved", "not drawn"), follows=True)
    return code


def picture_asked(problem: Problem, request: DrawRequest) -> Figure:
    """The picture of one scene that is asked for."""
    if not request.free_bodies:
        return scene_picture(problem, request.state)
    try:
        ways = solve_problem(problem, confirm=False).trace.acting()
    except Unsolvable:
        ways = None  # no answer tells which way forces act
    return free_body_picture(problem, request.state, ways)


def file_names(files: tuple[str, ...], request: DrawRequest) -> dict[str, str]:
    """Into which file each picture goes, '' for standard output: a folder has one for each scene, with the name of that."""
    if request.output is None:
        return dict.fromkeys(files, "")
    if request.output.lower().endswith(tuple(f".{end}" for end in WRITERS)):
        return dict.fromkeys(files, request.output)
    stems = Counter(Path(file).stem for file in files)
    return {
        file: str(
            Path(
                request.output,
                f"{Path(file).stem if stems[Path(file).stem] == 1 else folder_name(file)}.{request.format}",
            )
        )
        for file in files
    }


def folder_name(file: str) -> str:
    """The name of a file with that of its folder, where two files have one name."""
    path = Path(file)
    return f"{path.parent.name}-{path.stem}"


def put_picture(picture: str | bytes, name: str) -> int:
    """Write a picture into its file, whose folder is made if need be, or to standard output."""
    if not name:
        return put_content(None, picture)
    try:
        Path(name).parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        print(f"error: cannot make the folder {Path(name).parent}: {error.strerror or error}", file=sys.stderr)
        return BAD
    return write_file(name, picture)
