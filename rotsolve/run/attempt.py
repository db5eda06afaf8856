"""Attempt: solve one file and make its page; whatever goes wrong becomes a message."""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from rotsolve.profile import stage
from rotsolve.render.options import Options
from rotsolve.run.request import BAD, SOLVED, UNSOLVED, Outcome, Request
from rotsolve.run.scenes import PIPED

if TYPE_CHECKING:
    from rotsolve.render.layout import Line
    from rotsolve.solution import Solution


def attempt(file: str, request: Request, text: bytes = b"") -> Outcome:
    """Solve one file, or the text that was piped in."""
    from rotsolve.core.faults import SceneError, Unsolvable
    from rotsolve.pipeline import solve

    if Path(file).is_dir():
        return Outcome(file, BAD, None, f"error: there is no scene (*.yaml) in {file}", "file")
    try:
        source = (
            text.decode("utf-8") + "\n" if file == PIPED else Path(file)
        )  # a text has a line break, a path has none
        solution = solve(source, law=request.law, settings=request.settings, digits=request.digits, at=request.at)
        objects = any(check.holds is False for check in solution.derivation.checks)
        with stage("render", whole=True):
            return Outcome(file, UNSOLVED if objects else SOLVED, page(solution, request))
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


def page(solution: Solution, request: Request) -> str | tuple[Line, ...]:
    """The derivation, or the earlier stage that was asked for."""
    if request.show is not None:
        texts = {"facts": solution.facts_text, "equations": solution.equations_text, "plan": solution.plan_text}
        return texts[request.show]().rstrip("\n") + "\n"
    if request.coloured:
        from rotsolve.render.text import lines

        return tuple(lines(solution.derivation, Options(solution.digits, request.width)))
    return solution.body(request.format, width=request.width)


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
