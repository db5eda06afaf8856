"""Attempt: what a command asks of its files, which files its words mean, and what one gives; what goes wrong becomes a message."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING

from msgspec import Struct, field

from rotsolve.page.depth import NORMAL, STEPS
from rotsolve.profile import stage

if TYPE_CHECKING:
    from rotsolve.page.columns import TextLine
    from rotsolve.solution import Solution

SOLVED, UNSOLVED, BAD = 0, 1, 2
SUFFIXES = (".yaml", ".yml")
PIPED = "-"


class SolveRequest(Struct, frozen=True):
    """What the command line asked for."""

    files: tuple[str, ...]
    law: str | None = None
    format: str = "text"
    output: str | None = None
    digits: int = 4
    settings: dict[str, str] = field(default_factory=dict)
    show: str | None = None
    width: int = 120
    at: str | None = None
    jobs: int = 1
    time_limit: float | None = None  # seconds a file
    profile: bool = False
    confirm: bool = True
    pictures: bool = True  # in formats that have them
    detail: str = NORMAL
    numbers: str = STEPS
    language: str = "en"
    coloured: bool = False  # whether pages are lines with their roles, for a terminal

    @property
    def streams(self) -> bool:
        """Whether a page may be written before the next one is there; other formats, and files, are written as a whole."""
        return self.output is None and self.format == "text"


class FileOutcome(Struct, frozen=True):
    """What one file gave: a page (text, or lines for a terminal that wants colours), or a message with its exit code."""

    file: str
    code: int
    page: str | tuple[TextLine, ...] | None = None
    message: str = ""
    kind: str = ""


def scenes(names: tuple[str, ...]) -> tuple[str, ...]:
    """Every file once, in the order of the names; in the place of a folder or pattern the scenes in it, in the order of their paths."""
    return tuple(dict.fromkeys(file for name in names for file in files_meant(name)))


def files_meant(name: str) -> list[str]:
    """What one name stands for; itself where it stands for nothing, so that the message can say so."""
    if name == PIPED or os.path.isfile(name):
        return [name]
    if os.path.isdir(name):
        return scenes_in(name) or [name]
    return scenes_fitting(name) or [name]


def scenes_fitting(pattern: str) -> list[str]:
    """The scenes that fit a pattern, and those of the folders that do; none where it is an ordinary name."""
    from glob import glob, has_magic
    from pathlib import Path

    found = sorted(map(Path, glob(pattern, recursive=True))) if has_magic(pattern) else []
    return [file for path in found for file in (scenes_in(str(path)) if path.is_dir() else [str(path)])]


def scenes_in(name: str) -> list[str]:
    """The scenes of a folder and of the folders in it."""
    from pathlib import Path

    folder = Path(name)
    return sorted(str(path) for path in folder.rglob("*") if path.suffix in SUFFIXES and path.is_file())


def attempt(file: str, request: SolveRequest, text: bytes = b"") -> FileOutcome:
    """Solve one file, or the text that was piped in."""
    from rotsolve.pipeline import solve

    if os.path.isdir(file):
        return FileOutcome(file, BAD, None, f"error: there is no scene (*.yaml) in {file}", "file")
    try:
        scene = scene_source(file, text)
        solution = solve(
            scene,
            law=request.law,
            settings=request.settings,
            digits=request.digits,
            at=request.at,
            confirm=request.confirm and request.show is None,
        )
        objects = any(check.holds is False for check in solution.derivation.checks)
        refused = "\n\n".join(dict.fromkeys(reason.render() for reason in solution.refused.values()))
        with stage("render", whole=True):
            page = page_of(solution, request)
            return FileOutcome(
                file, UNSOLVED if objects or refused else SOLVED, page, refused, "unsolvable" if refused else ""
            )
    except Exception as error:
        return failure_outcome(file, error)


def scene_source(file: str, text: bytes) -> str | os.PathLike[str]:
    """The path of a scene, or the text that was piped in: a string with a line break is a text, one without is a path."""
    if file == PIPED:
        from rotsolve.scene.encoding import decoded

        return decoded(text, name_of(file)) + "\n"
    if "\n" not in file:
        return file
    from pathlib import Path

    return Path(file)


def failure_outcome(file: str, error: Exception) -> FileOutcome:
    """What is said of a file that something kept from its answer, with the exit code and the kind of fault."""
    from rotsolve.core.faults import SceneError, Unsolvable

    name = name_of(file)
    match error:
        case SceneError():
            code, kind = (UNSOLVED, "not yet") if error.not_yet else (BAD, "scene")
            return FileOutcome(file, code, None, error.render(), kind)
        case Unsolvable():
            return FileOutcome(file, UNSOLVED, None, error.render(), "unsolvable")
        case OSError():
            return FileOutcome(file, BAD, None, f"error: cannot read {name}: {error.strerror or error}", "file")
    return FileOutcome(file, UNSOLVED, None, internal_error(name, error), "internal")


def page_of(solution: Solution, request: SolveRequest) -> str | tuple[TextLine, ...]:
    """The derivation, or the earlier stage that was asked for."""
    if request.show is not None:
        texts = {
            "facts": solution.facts_text,
            "equations": solution.equations_text,
            "plan": solution.plan_text,
            "confirm": solution.confirmation_text,
        }
        return texts[request.show]().rstrip("\n") + "\n"
    if request.coloured:
        from rotsolve.page.formats import format_named
        from rotsolve.page.text import PlainText

        text = format_named("text", request.language)
        printer = text.printer
        assert isinstance(printer, PlainText)
        page = solution.page_with(detail=request.detail, numbers=request.numbers)
        return tuple(printer.lines(text.spoken(page), request.width))
    told = {"detail": request.detail, "numbers": request.numbers, "language": request.language}
    return solution.body(request.format, width=request.width, pictures=request.pictures, **told)


def piped(files: tuple[str, ...]) -> bytes:
    """What is on standard input, where one of the files is `-`."""
    return sys.stdin.buffer.read() if PIPED in files else b""


def name_of(file: str) -> str:
    return "standard input" if file == PIPED else file


def internal_error(where: str, error: Exception) -> str:
    """One line that asks for a report; the traceback with it where ROTSOLVE_DEBUG is set."""
    cause = " ".join(f"{type(error).__name__}: {error}".split())
    line = f"internal error in {where}: {cause[:300]} (please report it with the scene; ROTSOLVE_DEBUG=1 shows more)"
    if os.environ.get("ROTSOLVE_DEBUG", "") in ("", "0"):
        return line
    import traceback

    return "".join(traceback.format_exception(error)) + line
