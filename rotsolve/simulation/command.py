"""Command: `rotsolve simulate`: follow one scene, write its table, its numbers or its picture, and work out the exit code."""

from __future__ import annotations

import sys

from msgspec import Struct, field

from rotsolve.core.faults import MissingPackage, Unsolvable
from rotsolve.page.columns import page_text
from rotsolve.run import advancing, coloured
from rotsolve.run.attempt import BAD, SOLVED, failure_outcome, name_of, piped, scene_source
from rotsolve.run.delivery import write_file
from rotsolve.simulation.choosing import chosen_names
from rotsolve.simulation.report import csv_lines, run_lines, times_of
from rotsolve.simulation.run import Run
from rotsolve.simulation.simulating import simulate


class SimulationRequest(Struct, frozen=True):
    """What the command line asked for."""

    file: str
    until: float
    accuracy: float
    step: float | None = None
    csv: bool = False
    plot: str | None = None
    settings: dict[str, str] = field(default_factory=dict)
    width: int = 120
    certified: bool = False
    output: str | None = None  # a file for the numbers
    animate: str | None = None  # a file for the page that moves
    show: tuple[str, ...] = ()  # the quantities that are asked for


def run_simulation(request: SimulationRequest) -> int:
    """Follow a scene and write what was asked for."""
    try:
        with advancing(name_of(request.file)) as tell:
            scene, certified = scene_source(request.file, piped((request.file,))), request.certified
            found = simulate(scene, request.until, request.accuracy, request.settings, tell, certified=certified)
    except Exception as error:
        failed = failure_outcome(request.file, error)
        return fail(failed.message, failed.code)
    return write_run(found, request)


def drawn(found: Run) -> str:
    """What a file holds, since its table, which would say so, is not printed: how far it goes, why, and what it leaves out."""
    ended = f", where it ends: {found.ended}" if found.ended else ""
    states = f"; not reached: {', '.join(found.unreached)}" if found.unreached else ""
    return f"t = 0 to {found.end:g} s{ended}{states}"


def fail(message: str, code: int) -> int:
    print(message, file=sys.stderr)
    return code


def write_animation(found: Run, file: str, names: tuple[str, ...], request: SimulationRequest) -> int:
    """The page on which the scene moves, into its file."""
    from rotsolve.simulation.animation.page import animated

    try:
        with advancing("pictures"):
            page = animated(found, names, request.step)
    except Exception as error:
        failed = failure_outcome(request.file, error)
        return fail(failed.message, failed.code)
    code = write_file(file, page)
    return fail(f"wrote {file}: {drawn(found)}", SOLVED) if code == SOLVED else code


def write_run(found: Run, request: SimulationRequest) -> int:
    """The picture into its file, the numbers or the table to standard output."""
    try:
        names = chosen_names(found, request.show)
    except Unsolvable as error:
        failed = failure_outcome(request.file, error)
        return fail(failed.message, failed.code)
    if request.plot is not None:
        try:
            found.plot(names, request.plot)
        except MissingPackage as error:
            return fail(f"error: {error}", BAD)
        except OSError as error:
            return fail(f"error: cannot write {request.plot}: {error.strerror or error}", BAD)
        return fail(f"wrote {request.plot}: {drawn(found)}", SOLVED)
    if request.animate is not None:
        return write_animation(found, request.animate, names, request)
    if request.csv:
        numbers = csv_lines(found, times_of(found, request.step))
        if request.output is not None:
            code = write_file(request.output, "".join(f"{line}\n" for line in numbers))
            return fail(f"wrote {request.output}: {drawn(found)}", SOLVED) if code == SOLVED else code
        for line in numbers:
            print(line)
        return SOLVED
    written = list(run_lines(found, request.width, request.step, names))
    if coloured():
        from rotsolve.page.terminal import show

        show(written, sys.stdout)
    else:
        sys.stdout.write(page_text(written))
    return SOLVED
