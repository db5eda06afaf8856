"""Plot: a motion as a picture: a panel for each quantity, its curves named at their ends, what happens on the way as marks in all."""

from __future__ import annotations

import os
from collections.abc import Sequence
from functools import cache
from io import StringIO
from itertools import cycle
from typing import Any

from rotsolve.core.faults import missing_package
from rotsolve.simulation.report import quantity_unit, quantity_word
from rotsolve.simulation.run import Run
from rotsolve.simulation.senses import sense_words

POINTS = 1200  # moments of a curve
RATES = ("velocity", "angular_velocity")
MOST_MARKS = 12  # events that are named; of more only the lines are drawn
COLOURS = ("#0b6e99", "#d1495b", "#5b8c3a", "#8d5a97", "#e08e1b", "#4a4e69")
STYLES = {"x": "-", "y": "--", "z": ":"}
UNSAID = ("Creator", "Date", "Format", "Type")  # that an SVG would say of itself
INK, FAINT = "#2b2d33", "#d9dbe0"
WIDE, TALL = 10.0, 1.9  # inches of the picture, and of a panel of few curves
LETTERS, LINE = 8.5, 0.17  # points of a name, and inches from one to the next
PER_LETTER = 0.0085  # of the width of a panel, for a letter of the name of an event


@cache
def figure_kind() -> Any:
    """The figures of matplotlib, which show themselves in a notebook."""
    try:
        from matplotlib.figure import Figure
    except ImportError:
        raise missing_package("drawing takes", "matplotlib", "plot") from None

    class RunFigure(Figure):  # type: ignore[misc]
        """A motion as a picture."""

        def _repr_svg_(self) -> str:
            written = StringIO()
            write_figure(self, written, "svg")
            return written.getvalue()

    return RunFigure


def figure_of(run: Run, names: Sequence[str]) -> Any:
    """A motion as a figure, the same for the same motion."""
    panels = panels_of(names)
    heights = [max(TALL, LINE * (len(held) + 2)) for held in panels.values()]
    figure = figure_kind()(figsize=(WIDE, 1.0 + sum(heights)), layout="constrained")
    figure.suptitle(run.problem.title or run.problem.file, color=INK, fontsize=13, x=0.02, ha="left")
    grid: Any = figure.subplots(len(panels), 1, sharex=True, squeeze=False, gridspec_kw={"height_ratios": heights})
    axes = grid[:, 0]
    draw_curves(run, panels, axes, heights)
    rows = name_events(axes[0], run)
    for number, (axis, title) in enumerate(zip(axes, panels, strict=True)):
        dress(axis, title, rows if number == 0 else 0)
        for event in run.events:
            axis.axvline(event.time, color=INK, linewidth=0.7, linestyle=":", alpha=0.6)
    axes[-1].set_xlabel("t in s", color=INK)
    axes[-1].set_xlim(0, run.end or 1)
    return figure


def write_figure(figure: Any, target: str | os.PathLike[str] | StringIO, kind: str | None = None) -> None:
    """Write a figure into an .svg or .png file, without a date, and with the same names in it each time."""
    from matplotlib import rc_context

    plain = kind == "svg" or (kind is None and str(target).lower().endswith(".svg"))
    with rc_context({"svg.hashsalt": "rotsolve", "svg.fonttype": "none"}):
        figure.savefig(target, dpi=150, format=kind, metadata=dict.fromkeys(UNSAID) if plain else {})


def draw_curves(run: Run, panels: dict[str, list[str]], axes: Any, heights: Sequence[float]) -> None:
    """All curves, each with its name at its end."""
    names = tuple(name for held in panels.values() for name in held)
    times = [run.end * k / (POINTS - 1) for k in range(POINTS)]
    found = [run.at(time, names) for time in times]
    colours = dict(zip(dict.fromkeys(map(curve_owner, names)), cycle(COLOURS), strict=False))
    for axis, height, held in zip(axes, heights, panels.values(), strict=True):
        ends = []
        for name in held:
            style, colour = STYLES.get(axis_in_name(name), "-"), colours[curve_owner(name)]
            values = [row[name][0] if name in row else float("nan") for row in found]
            axis.plot(times, values, style, color=colour, linewidth=1.6)
            last = next((value for value in reversed(values) if value == value), 0.0)
            ends.append((last, curve_label(run, name), colour))
        name_ends(axis, ends, LINE / height)


def curve_owner(name: str) -> str:
    """Of what a quantity is: `block` of `block.velocity.x`, `string.block` of `string.block.tension`."""
    return name.partition(f".{quantity_word(name)}")[0]


def axis_in_name(name: str) -> str:
    """The axis of a component, `x` of `box.angular_velocity.x in body axes`; '' of what has none."""
    component = name.rpartition(".")[2].partition(" ")[0]
    return component if component in STYLES else ""


def curve_label(run: Run, name: str) -> str:
    """What a curve shows, which way it counts, and its unit: `block.velocity (down), m/s`."""
    sense = sense_words(run, name)
    return f"{name}{f' ({sense})' if sense else ''}, {quantity_unit(name)}"


def panels_of(names: Sequence[str]) -> dict[str, list[str]]:
    """The curves by their quantity: angles, ways, then their rates."""
    found: dict[str, list[str]] = {}
    for name in sorted(names, key=lambda name: quantity_word(name) in RATES):
        found.setdefault(quantity_word(name).replace("_", " "), []).append(name)
    return found


def name_ends(axis: Any, ends: Sequence[tuple[float, str, str]], line: float) -> None:
    """The names of curves on the right of their ends, so far apart that none lies on another; `line` is a part of the panel's height."""
    low, high = axis.get_ylim()
    ordered = sorted(ends)
    wished = [(last - low) / (high - low) for last, _, _ in ordered]
    for place, (_, words, colour) in zip(ends_apart(wished, line), ordered, strict=True):
        axis.annotate(
            words, (1.0, place), xycoords="axes fraction", xytext=(6, 0), textcoords="offset points", color=colour,
            fontsize=LETTERS, va="center", ha="left",
        )  # fmt: skip


def ends_apart(wished: Sequence[float], gap: float) -> list[float]:
    """Places in rising order near those that are wished, each a gap beyond the one before, from 0 to 1 as far as they have room."""
    found: list[float] = []
    for place in wished:
        found.append(max(place, found[-1] + gap) if found else max(place, 0.0))
    top = 1.0
    for number in reversed(range(len(found))):
        found[number] = min(found[number], top)
        top = found[number] - gap
    return found


def dress(axis: Any, title: str, rows: int) -> None:
    """The look of a panel: its title above the left end and above rows of names, no frame, faint lines across."""
    axis.set_title(title, loc="left", fontsize=9.5, color=INK, pad=5 + 72 * LINE * rows)
    axis.grid(axis="y", color=FAINT, linewidth=0.7)
    axis.tick_params(colors=INK, labelsize=9, length=0)
    for side in ("top", "right", "left"):
        axis.spines[side].set_visible(False)
    axis.spines["bottom"].set_color(FAINT)


def name_events(axis: Any, run: Run) -> int:
    """What happens on the way above its mark, in as many rows as it takes; how many these are."""
    ends: list[float] = []  # of the last name in each row, as a part of the width
    for event in run.events if len(run.events) <= MOST_MARKS else ():
        words, start = event.state or event.what, event.time / run.end
        long = PER_LETTER * (len(words) + 2)
        start = max(0.0, min(start, 1.0 - long))
        row = next((number for number, end in enumerate(ends) if end <= start), len(ends))
        ends[row : row + 1] = [start + long]
        axis.annotate(
            words, (start, 1.0), xycoords="axes fraction", xytext=(0, 3 + 72 * LINE * row), textcoords="offset points",
            fontsize=8, color=INK, va="bottom", ha="left",
        )  # fmt: skip
    return len(ends)
