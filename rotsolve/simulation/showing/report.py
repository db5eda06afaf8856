"""Report: a motion as a table of the digits that its bounds settle, with what happened on the way, and how well its balances hold."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from math import ceil, floor, isfinite, log10

from rotsolve.algebra.certified.ball import decimal_text, ends
from rotsolve.algebra.flints import arb
from rotsolve.algebra.units.quantities import unit_for
from rotsolve.core.quantity import QUANTITIES
from rotsolve.render.layout import Line, paragraph
from rotsolve.simulation.run import Run
from rotsolve.simulation.tape import Scalar

SHOWN = (
    "angle",
    "position",
    "elongation",
    "length",
    "rotation",
    "angular_velocity",
    "velocity",
)  # quantities of the table
ROWS = 10  # rows of the table, where no step is asked for
DIGITS = 6
FLOAT_DIGITS, MOST_DIGITS = 17, 80  # of a number in CSV
ROUNDED_UP = 1.06  # so that a bound of two digits is not below what it stands for
GAP = 3
MOST_EVENTS = 30
UNSETTLED = "?"
SIGNS = "Angles are counted counterclockwise; speeds and distances along the way in which each body is said to move or turn."
STANDS = "Nothing moves: it starts at rest where nothing pushes it, and stays there, even where the least push would end that."


def lines(run: Run, width: int, step: float | None = None) -> Iterator[Line]:
    """The whole report."""
    if run.problem.title:
        yield Line(run.problem.title, "title")
        yield Line("")
    times = times_of(run, step)
    names = columns_of(run)
    yield from paragraph(SIGNS, 0, width)
    yield Line("")
    yield from tables(run, names, times, width)
    yield from happenings(run)
    if run.ended:
        yield from paragraph(f"It ends at t = {moment(run.end, 0.0)} s: {run.ended}.", 0, width)
        yield Line("")
    if run.unreached:
        states = ", ".join(f"`{state}`" for state in run.unreached)
        yield from paragraph(f"Not reached by t = {moment(run.end, 0.0)} s: {states}.", 0, width)
        yield Line("")
    yield Line("Accuracy", "heading", len("Accuracy"))
    yield from paragraph(bounds(run, names), 2, width)
    if not stands(run, names):
        yield from paragraph(balances(run), 2, width)


def times_of(run: Run, step: float | None) -> list[float]:
    """The times of the table: the step that is asked for, else one of 1, 2 or 5 that makes about ten rows."""
    if step is None:
        raw = run.until / ROWS
        unit = 10.0 ** floor(log10(raw))
        step = next(unit * factor for factor in (1, 2, 5, 10) if unit * factor >= raw * (1 - 1e-9))
    count = int(run.end / step * (1 + 1e-12))
    times = [step * k for k in range(count + 1)]
    return times if run.end - times[-1] < 1e-9 * run.end else [*times, run.end]


def columns_of(run: Run) -> tuple[str, ...]:
    """Places and speeds of bodies, body by body, as far as they are told all along."""
    told = set(run.names).intersection(*(part.system.outputs for part in run.regimes))
    owners = dict.fromkeys(name.partition(".")[0] for name in run.names)
    words = {word: number for number, word in enumerate(SHOWN)}
    return tuple(
        name
        for owner in owners
        for name in sorted(
            (n for n in told if n.partition(".")[0] == owner), key=lambda n: (words.get(word_of(n), 99), n)
        )
        if word_of(name) in words
    )


def word_of(name: str) -> str:
    """The quantity in a name: `velocity` of `block.velocity.x`."""
    return next((part for part in name.split(".")[1:] if part in QUANTITIES), "")


def unit_of(name: str) -> str:
    """The SI unit of a quantity."""
    return unit_for(QUANTITIES[word_of(name)].dimension).text


def tables(run: Run, names: Sequence[str], times: Sequence[float], width: int) -> Iterator[Line]:
    """The table, in as many parts below each other as the width takes."""
    rows = [run.balls(time, tuple(names)) for time in times]
    clock = column("t", "s", plain(times))
    columns = [column(name, unit_of(name), settled([row[name] for row in rows])) for name in names]
    while columns:
        part, used = [clock], len(clock[0])
        while columns and (len(part) == 1 or used + GAP + len(columns[0][0]) <= width):
            part.append(columns.pop(0))
            used += GAP + len(part[-1][0])
        for number, cells in enumerate(zip(*part, strict=True)):
            yield Line((" " * GAP).join(cells).rstrip(), "heading" if number < 2 else "")
        yield Line("")


def column(name: str, unit: str, cells: Sequence[str]) -> list[str]:
    """Cells of one width under a name and a unit, numbers to the right."""
    size = max(len(name), len(unit), *map(len, cells))
    return [name.rjust(size), unit.rjust(size), *(cell.rjust(size) for cell in cells)]


def plain(times: Sequence[float]) -> list[str]:
    """Times by their shortest decimals, all with as many places."""
    places = max(len(f"{time:.6g}".partition(".")[2]) for time in times)
    return [f"{time:.{places}f}" for time in times]


def settled(balls: Sequence[Scalar]) -> list[str]:
    """A column with as many decimals as make six digits of its largest number; fewer where a bound settles no more."""
    largest = max(abs(float(ball.mid())) for ball in balls)
    scale = floor(log10(largest)) if largest and isfinite(largest) else 0
    decimals = max(0, DIGITS - 1 - scale)
    return [digits_of(ball, decimals) for ball in balls]


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


def happenings(run: Run) -> Iterator[Line]:
    """What happened on the way, with its time."""
    if not run.events:
        return
    yield Line("On the way", "heading", len("On the way"))
    shown = run.events[:MOST_EVENTS]
    cells = [f"t = {moment(event.time, event.bound)} s" for event in shown]
    for cell, event in zip(cells, shown, strict=True):
        yield Line(f"  {cell.ljust(max(map(len, cells)))}   {event.state or event.what}")
    if len(run.events) > len(shown):
        yield Line(f"  and {len(run.events) - len(shown)} more")
    yield Line("")


def moment(time: float, bound: float) -> str:
    """A time as far as its bound settles it, to ten decimals at most."""
    text = digits_of(arb(time, bound), 10)
    return text if bound else text.rstrip("0").rstrip(".")


def bounds(run: Run, names: Sequence[str]) -> str:
    """How wide the bounds are at the end."""
    found = run.at(run.end, tuple(names))
    if not found or stands(run, names):
        return STANDS
    name = max(found, key=lambda name: found[name][1])
    wide = decimal_text(arb(found[name][1]).mid(), digits=2) if found[name][1] else "0"
    return f"Every digit shown is settled by the bound of its number; the widest is {wide} {unit_of(name)}, of {name} at the end."


def stands(run: Run, names: Sequence[str]) -> bool:
    """Whether nothing happens: all speeds are zero at both ends, and no event lies between."""
    speeds = tuple(name for name in names if word_of(name) in ("velocity", "angular_velocity"))
    ends_ = (run.at(0.0, speeds), run.at(run.end / 2, speeds), run.at(run.end, speeds))
    return not run.events and not any(value for found in ends_ for value, _ in found.values())


def balances(run: Run) -> str:
    """How well energy and momentum hold."""
    pairs = (("energy", run.drift.energy, "kinetic energy"), ("momentum", run.drift.momentum, "momentum"))
    told = [
        f"{name} agrees with the {'work' if name == 'energy' else 'impulse'} of the forces to {small(value)} of the largest {of}"
        for name, value, of in pairs
        if value is not None
    ]
    return f"The {'; '.join(told)}." if told else "Its forces do not tell an energy or a momentum that is kept."


def small(value: float) -> str:
    return decimal_text(arb(value).mid(), digits=1) if value else "0"


def csv(run: Run, times: Iterable[float]) -> Iterator[str]:
    """All quantities with their bounds, in SI units; empty where a quantity is not told."""
    names = list(dict.fromkeys(name for part in run.regimes for name in part.system.outputs))
    yield ",".join(["time", *(cell for name in names for cell in (name, f"{name} bound"))])
    for time in times:
        found = run.balls(time)
        cells = (cell for name in names for cell in (written(found[name]) if name in found else ("", "")))
        yield ",".join([repr(time), *cells])


def written(ball: Scalar) -> tuple[str, str]:
    """A number to so many digits that writing it adds little to its bound, and the bound, rounded up."""
    middle, radius = ball.mid(), float(ball.rad())
    size = abs(float(middle))
    digits = min(MOST_DIGITS, max(FLOAT_DIGITS, ceil(log10(size / radius)) + 2)) if radius and size else FLOAT_DIGITS
    text = middle.str(digits, radius=False) if size else "0"
    bound = (radius + size * 10.0 ** (1 - digits)) * ROUNDED_UP if radius or not middle.is_exact() else radius
    return text, f"{bound:.2g}"
