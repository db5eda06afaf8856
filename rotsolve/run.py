"""run: solve the files of one command, collect what each gave, write it, and work out the exit code."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING

from msgspec import Struct, field

from rotsolve.render import format_named
from rotsolve.render.options import Options

if TYPE_CHECKING:
    from rotsolve.solution import Solution

SOLVED, UNSOLVED, BAD = 0, 1, 2
SCENES = (".yaml", ".yml")
PATIENCE = 1.0  # seconds before a progress bar is worth its place


class Request(Struct, frozen=True):
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


class Outcome(Struct, frozen=True):
    """What one file gave: a solution, or a message with its exit code."""

    file: str
    code: int
    solution: Solution | None = None
    message: str = ""
    kind: str = ""


def run(request: Request) -> int:
    """Solve every file, write all that was solved, then say what was not; the exit code is the worst one."""
    files = scenes(request.files)
    if request.output and any(same_file(request.output, file) for file in files):
        print(f"error: {request.output} is a scene to solve; it would be overwritten", file=sys.stderr)
        return BAD
    outcomes = [attempt(file, request) for file in with_progress(files)]
    code = max(outcome.code for outcome in outcomes)
    if any(outcome.solution for outcome in outcomes) or (request.format == "json" and len(outcomes) > 1):
        code = max(code, deliver(outcomes, request))
    messages = [outcome.message for outcome in outcomes if outcome.message]
    if messages:
        sys.stdout.flush()
        print("\n\n".join(messages), file=sys.stderr)
    return code


def scenes(files: tuple[str, ...]) -> tuple[str, ...]:
    """The files, and in the place of a folder the scenes within it, in the order of their paths."""
    found: list[str] = []
    for file in files:
        inside = [path for path in Path(file).rglob("*") if path.suffix in SCENES] if file != "-" else []
        found += sorted(map(str, inside)) or [file]
    return tuple(found)


def attempt(file: str, request: Request) -> Outcome:
    """Solve one file; whatever goes wrong becomes a message."""
    from rotsolve.core.faults import SceneError, Unsolvable
    from rotsolve.pipeline import solve

    if Path(file).is_dir():
        return Outcome(file, BAD, None, f"error: there is no scene (*.yaml) in {file}", "file")
    try:
        solution = solve(source(file), law=request.law, settings=request.settings, digits=request.digits, at=request.at)
    except SceneError as error:
        not_yet = bool(getattr(error, "not_yet", False))
        return Outcome(file, UNSOLVED if not_yet else BAD, None, error.render(), "not yet" if not_yet else "scene")
    except Unsolvable as error:
        return Outcome(file, UNSOLVED, None, error.render(), "unsolvable")
    except UnicodeDecodeError:
        return Outcome(file, BAD, None, f"error: {name_of(file)} is not UTF-8 text", "file")
    except OSError as error:
        return Outcome(file, BAD, None, f"error: cannot read {name_of(file)}: {error.strerror or error}", "file")
    except Exception as error:
        return Outcome(file, UNSOLVED, None, internal_error(name_of(file), error), "internal")
    objects = any(check.holds is False for check in solution.derivation.checks)
    return Outcome(file, UNSOLVED if objects else SOLVED, solution)


def source(file: str) -> Path | str:
    """The path of a scene file; for `-` the text on standard input."""
    if file != "-":
        return Path(file)
    return sys.stdin.buffer.read().decode("utf-8") + "\n"  # a text has a line break, a path has none


def name_of(file: str) -> str:
    return "standard input" if file == "-" else file


def internal_error(where: str, error: Exception) -> str:
    """One line that asks for a report; the traceback with it where ROTSOLVE_DEBUG is set."""
    cause = " ".join(f"{type(error).__name__}: {error}".split())
    line = f"internal error in {where}: {cause[:300]} (please report it with the scene; ROTSOLVE_DEBUG=1 shows more)"
    if os.environ.get("ROTSOLVE_DEBUG", "") in ("", "0"):
        return line
    import traceback

    return "".join(traceback.format_exception(error)) + line


def with_progress(files: tuple[str, ...]) -> Iterator[str]:
    """The files one by one; once it takes long, and on a terminal, with a progress bar."""
    start = monotonic()
    for number, file in enumerate(files):
        if monotonic() - start > PATIENCE and len(files) - number > 1 and sys.stderr.isatty():
            from rotsolve.render.terminal import progress

            with progress(files, number, sys.stderr) as rest:
                yield from rest
            return
        yield file


def deliver(outcomes: list[Outcome], request: Request) -> int:
    """Write what was solved to the file or to standard output."""
    solutions = [outcome.solution for outcome in outcomes if outcome.solution]
    if request.output:
        return write_file(request.output, document(outcomes, request))
    if request.format == "text" and not request.show and coloured():
        show_on_terminal(solutions, request.width)
    else:
        sys.stdout.write(document(outcomes, request))
    return SOLVED


def document(outcomes: list[Outcome], request: Request) -> str:
    """All that was solved as one document; among several in JSON, also what was not."""
    chosen = format_named(request.format)
    bodies = []
    for outcome in outcomes:
        if outcome.solution:
            bodies.append(stage(outcome.solution, request))
        elif request.format == "json":
            from rotsolve.render.json import failure

            bodies.append(failure(outcome.file, outcome.kind, outcome.message))
    return chosen.document(bodies)


def stage(solution: Solution, request: Request) -> str:
    """The derivation, or the earlier stage that was asked for."""
    if request.show is None:
        return solution.body(request.format, width=request.width)
    texts = {"facts": solution.facts_text, "equations": solution.equations_text, "plan": solution.plan_text}
    return texts[request.show]().rstrip("\n") + "\n"


def coloured() -> bool:
    """Whether standard output is a terminal that wants colours."""
    return sys.stdout.isatty() and not os.environ.get("NO_COLOR") and os.environ.get("TERM") != "dumb"


def show_on_terminal(solutions: list[Solution], width: int) -> None:
    """The text in colour."""
    from rotsolve.render.layout import Line
    from rotsolve.render.terminal import show
    from rotsolve.render.text import SEPARATOR, lines

    for number, solution in enumerate(solutions):
        if number:
            show([Line(""), Line(SEPARATOR, "rule"), Line("")], sys.stdout)
        show(lines(solution.derivation, Options(solution.digits, width)), sys.stdout)


def same_file(left: str, right: str) -> bool:
    try:
        return os.path.samefile(left, right)
    except OSError:
        return False


def write_file(name: str, text: str) -> int:
    """Write the whole text or nothing: into a new file beside the old one, which it then replaces."""
    path = Path(os.path.realpath(name))
    try:
        if path.exists() and not path.is_file():  # /dev/stdout, a named pipe
            path.write_text(text, encoding="utf-8")
            return SOLVED
        mode = path.stat().st_mode & 0o777 if path.exists() else None
        fresh = path.with_name(f".{path.name}.{os.getpid()}.new")
        try:
            fresh.write_text(text, encoding="utf-8")
            if mode is not None:
                fresh.chmod(mode)
            fresh.replace(path)
        except BaseException:
            with suppress(OSError):
                fresh.unlink()
            raise
    except OSError as error:
        print(f"error: cannot write {name}: {error.strerror or error}", file=sys.stderr)
        return BAD
    return SOLVED
