"""Report: a motion as a table of the digits that its bounds settle, with what happened on the way, and how well its balances hold."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from math import ceil, floor, isfinite, log10

from rotsolve.algebra.certified.ball import decimal_text, ends
from rotsolve.algebra.flints import arb
from rotsolve.algebra.units.quantities import unit_for
from rotsolve.core.quantity import QUANTITIES
from rotsolve.page.columns import TextLine, paragraph_lines
from rotsolve.simulation.run import Run
from rotsolve.simulation.tape import Scalar

ROWS = 10  # rows of the table, where no step is asked for
DIGITS = 6
FLOAT_DIGITS, MOST_DIGITS = 17, 80  # of a number in CSV
ROUNDED_UP = 1.06  # so that a bound of two digits is not below what it stands for
GAP = 3
MOST_EVENTS = 30
UNSETTLED, NOWHERE = "?", "–"  # what is not settled, what has no value at that time
SPEEDS = ("velocity", "angular_velocity", "spin", "axial_rate", "precession", "nutation")
STANDS = "Nothing moves: it starts at rest where nothing pushes it, and stays there, even where the least push would end that."


def run_lines(
    run: Run, width: int, step: float | None = None, names: Sequence[str] | None = None
) -> Iterator[TextLine]:
    """The whole report, with these quantities; with places and speeds where none are named."""
    if run.problem.title:
        yield TextLine(run.problem.title, "title")
        yield TextLine("")
    times = times_of(run, step)
    names = columns_of(run) if names is None else names
    yield from paragraph_lines(run.signs, 0, width)
    yield TextLine("")
    yield from table_lines(run, names, times, width)
    yield from happenings(run)
    if run.ended:
        yield from paragraph_lines(f"It ends at t = {time_text(run.end, 0.0)} s: {run.ended}.", 0, width)
        yield TextLine("")
    if run.unreached:
        states = ", ".join(f"`{state}`" for state in run.unreached)
        yield from paragraph_lines(f"Not reached by t = {time_text(run.end, 0.0)} s: {states}.", 0, width)
        yield TextLine("")
    yield TextLine("Accuracy", "heading", len("Accuracy"))
    yield from paragraph_lines(bounds_sentence(run, names), 2, width)
    if not is_at_rest(run):
        yield from paragraph_lines(balances_sentence(run), 2, width)


def times_of(run: Run, step: float | None) -> list[float]:
    """The times of the table: the step that is asked for, else one of 1, 2 or 5 that makes about ten rows."""
    if step is None:
        raw = run.until / ROWS
        unit = 10.0 ** floor(log10(raw))
        step = next(unit * factor for factor in (1, 2, 5, 10) if unit * factor >= raw * (1 - 1e-9))
    count = int(run.end / step * (1 + 1e-12))
    times = [min(step * k, run.end) for k in range(count + 1)]
    return times if run.end - times[-1] < 1e-9 * run.end else [*times, run.end]


def columns_of(run: Run) -> tuple[str, ...]:
    """Places and speeds of bodies, body by body, as far as they are told all along."""
    told = set(run.names).intersection(*(part.system.outputs for part in run.regimes))
    owners = list(dict.fromkeys(name.partition(".")[0] for name in run.names))
    shown = [name for name in told if quantity_word(name) in run.shown]
    return tuple(sorted(shown, key=lambda n: (owners.index(n.partition(".")[0]), run.shown.index(quantity_word(n)), n)))


def quantity_word(name: str) -> str:
    """The quantity in a name: `velocity` of `block.velocity.x`."""
    return next((part for part in name.split(".")[1:] if part in QUANTITIES), "")


def quantity_unit(name: str) -> str:
    """The SI unit of a quantity."""
    return unit_for(QUANTITIES[quantity_word(name)].dimension).text


def table_lines(run: Run, names: Sequence[str], times: Sequence[float], width: int) -> Iterator[TextLine]:
    """The table, in as many parts below each other as the width takes."""
    rows = [run.balls(time, tuple(names)) for time in times]
    clock = column_cells("t", "s", time_cells(times))
    columns = [
        column_cells(name, quantity_unit(name), settled_cells([row.get(name) for row in rows])) for name in names
    ]
    while columns:
        part, used = [clock], len(clock[0])
        while columns and (len(part) == 1 or used + GAP + len(columns[0][0]) <= width):
            part.append(columns.pop(0))
            used += GAP + len(part[-1][0])
        for number, cells in enumerate(zip(*part, strict=True)):
            yield TextLine((" " * GAP).join(cells).rstrip(), "heading" if number < 2 else "")
        yield TextLine("")


def column_cells(name: str, unit: str, cells: Sequence[str]) -> list[str]:
    """Cells of one width under a name and a unit, numbers to the right."""
    size = max(len(name), len(unit), *map(len, cells))
    return [name.rjust(size), unit.rjust(size), *(cell.rjust(size) for cell in cells)]


def time_cells(times: Sequence[float]) -> list[str]:
    """Times by their shortest decimals, all with as many places."""
    places = max(len(f"{time:.6g}".partition(".")[2]) for time in times)
    return [f"{time:.{places}f}" for time in times]


def settled_cells(balls: Sequence[Scalar | None]) -> list[str]:
    """A column with as many decimals as make six digits of its largest number that is not nothing; fewer where a bound settles no more."""
    sizes = (abs(float(ball.mid())) for ball in balls if ball is not None and not ball.contains(0))
    largest = max(sizes, default=0.0)
    scale = floor(log10(largest)) if largest and isfinite(largest) else 0
    decimals = max(0, DIGITS - 1 - scale)
    return [NOWHERE if ball is None else digits_of(ball, decimals) for ball in balls]


def digits_of(ball: Scalar, decimals: int) -> str:
    """A number as far as both ends of its ball agree, to so many decimals at most."""
    low, high = ends(ball)
    for places in range(decimals, -1, -1):
        first, last = (round(end * 10**places) for end in (low, high))
        if first == last:
            return fixed(first, places)
    return UNSETTLED


def fixed(number: int, places: int) -> str:
    """number / 10^places as a decimal."""
    figures = str(abs(number)).rjust(places + 1, "0")
    point = len(figures) - places
    return ("−" if number < 0 else "") + figures[:point] + ("." + figures[point:] if places else "")


def happenings(run: Run) -> Iterator[TextLine]:
    """What happened on the way, with its time."""
    if not run.events:
        return
    yield TextLine("On the way", "heading", len("On the way"))
    shown = run.events[:MOST_EVENTS]
    cells = [f"t = {time_text(event.time, event.bound)} s" for event in shown]
    for cell, event in zip(cells, shown, strict=True):
        yield TextLine(f"  {cell.ljust(max(map(len, cells)))}   {event.state or event.what}")
    if len(run.events) > len(shown):
        yield TextLine(f"  and {len(run.events) - len(shown)} more")
    yield TextLine("")


def time_text(time: float, bound: float) -> str:
    """A time as far as its bound settles it, to ten decimals at most."""
    text = digits_of(arb(time, bound), 10)
    return text if bound else text.rstrip("0").rstrip(".")


def bounds_sentence(run: Run, names: Sequence[str]) -> str:
    """How wide the bounds are at the end."""
    found = run.at(run.end, tuple(names))
    if not found or is_at_rest(run):
        return STANDS
    name = max(found, key=lambda name: found[name][1])
    wide = f"{bound_text(found[name][1], 2)} {quantity_unit(name)}, of {name} at the end"
    return f"Every digit shown is settled by the bound of its number; the widest is {wide}."


def is_at_rest(run: Run) -> bool:
    """Whether nothing happens: all speeds are zero at both ends, and no event lies between."""
    speeds = tuple(name for name in run.names if quantity_word(name) in SPEEDS)
    ends_ = (run.at(0.0, speeds), run.at(run.end / 2, speeds), run.at(run.end, speeds))
    return not run.events and not any(value for found in ends_ for value, _ in found.values())


def balances_sentence(run: Run) -> str:
    """How well energy and momentum hold."""
    pairs = (("energy", run.drift.energy, "kinetic energy"), ("momentum", run.drift.momentum, "momentum"))
    told = [
        f"{name} agrees with the {'work' if name == 'energy' else 'impulse'} of the forces to {bound_text(value, 1)} of the largest {of}"
        for name, value, of in pairs
        if value is not None
    ]
    kept = run.drift.angular_momentum
    if kept:
        widest = max(kept.values())
        told.append(
            f"{', '.join(kept)} {'is' if len(kept) == 1 else 'are'} kept to {bound_text(widest, 1)} of its size"
        )
    return f"The {'; '.join(told)}." if told else "Its forces do not tell an energy or a momentum that is kept."


def bound_text(value: float, digits: int) -> str:
    return decimal_text(arb(value).mid(), digits=digits) if value else "0"


def csv_lines(run: Run, times: Iterable[float]) -> Iterator[str]:
    """All quantities with their bounds, in SI units; empty where a quantity is not told."""
    names = list(dict.fromkeys(name for part in run.regimes for name in part.system.outputs))
    yield ",".join(["time", *(cell for name in names for cell in (name, f"{name} bound"))])
    for time in times:
        found = run.balls(time)
        cells = (cell for name in names for cell in (number_and_bound(found[name]) if name in found else ("", "")))
        yield ",".join([repr(time), *cells])


def number_and_bound(ball: Scalar) -> tuple[str, str]:
    """A number to so many digits that writing it adds little to its bound, and the bound, rounded up."""
    middle, radius = ball.mid(), float(ball.rad())
    size = abs(float(middle))
    digits = min(MOST_DIGITS, max(FLOAT_DIGITS, ceil(log10(size / radius)) + 2)) if radius and size else FLOAT_DIGITS
    text = middle.str(digits, radius=False) if size else "0"
    bound = (radius + size * 10.0 ** (1 - digits)) * ROUNDED_UP if radius or not middle.is_exact() else radius
    return text, f"{bound:.2g}"
