"""Plot: a motion as a picture: places above, speeds below, what happens on the way as marks in both."""

from __future__ import annotations

from itertools import cycle
from typing import Any

from rotsolve.simulation.report import columns_of, quantity_unit, quantity_word
from rotsolve.simulation.run import Run

POINTS = 1200  # moments of a curve
RATES = ("velocity", "angular_velocity")
MOST_MARKS = 12  # events that are named; of more only the lines are drawn
COLOURS = ("#0b6e99", "#d1495b", "#5b8c3a", "#8d5a97", "#e08e1b", "#4a4e69")
STYLES = {"x": "-", "y": "--", "z": ":"}
INK, FAINT = "#2b2d33", "#d9dbe0"


class NoPlots(Exception):
    """The package that draws is not there."""


def plot_run(run: Run, path: str) -> None:
    """Draw a motion into an .svg or .png file."""
    try:
        from matplotlib.figure import Figure
    except ImportError:
        raise NoPlots("drawing takes matplotlib: pip install 'rotsolve[plot]'") from None
    names = columns_of(run)
    panels = panels_of(names)
    figure = Figure(figsize=(9, 1.2 + 2.1 * len(panels)), layout="constrained")
    figure.suptitle(run.problem.title or run.problem.file, color=INK, fontsize=13, x=0.02, ha="left")
    axes: Any = figure.subplots(len(panels), 1, sharex=True, squeeze=False)[:, 0]
    times = [run.end * k / (POINTS - 1) for k in range(POINTS)]
    found = [run.at(time, names) for time in times]
    colours = dict(zip(dict.fromkeys(name.partition(".")[0] for name in names), cycle(COLOURS), strict=False))
    for axis, (unit, held) in zip(axes, panels.items(), strict=True):
        for name in held:
            style = STYLES.get(axis_in_name(name), "-")
            values = [row[name][0] if name in row else float("nan") for row in found]
            colour = colours[name.partition(".")[0]]
            axis.plot(times, values, style, color=colour, linewidth=1.6, label=curve_label(name))
        dress(axis, unit, len(held))
    mark_events(axes, run)
    axes[-1].set_xlabel("t in s", color=INK)
    axes[-1].set_xlim(0, run.end or 1)
    figure.savefig(path, dpi=150)


def axis_in_name(name: str) -> str:
    """The axis of a component, `x` of `box.angular_velocity.x in body axes`; '' of what has none."""
    component = name.rpartition(".")[2].partition(" ")[0]
    return component if component in STYLES else ""


def curve_label(name: str) -> str:
    """Whose curve it is: `block`, `lower x`."""
    return " ".join(filter(None, (name.partition(".")[0], axis_in_name(name))))


def panels_of(names: tuple[str, ...]) -> dict[str, list[str]]:
    """The curves by what stands on the axis: angles, ways, then their rates."""
    found: dict[str, list[str]] = {}
    for name in sorted(names, key=lambda name: quantity_word(name) in RATES):
        found.setdefault(f"{quantity_word(name).replace('_', ' ')} in {quantity_unit(name)}", []).append(name)
    return found


def dress(axis: Any, title: str, curves: int) -> None:
    """The look of a panel: its title above the left end, no frame, faint lines across."""
    axis.set_title(title, loc="left", fontsize=9.5, color=INK)
    axis.grid(axis="y", color=FAINT, linewidth=0.7)
    axis.tick_params(colors=INK, labelsize=9, length=0)
    for side in ("top", "right", "left"):
        axis.spines[side].set_visible(False)
    axis.spines["bottom"].set_color(FAINT)
    axis.legend(frameon=False, fontsize=8.5, labelcolor=INK, loc="center left", bbox_to_anchor=(1.0, 0.5))


def mark_events(axes: Any, run: Run) -> None:
    """A line through all panels where something happens, named at the top."""
    for event in run.events:
        for axis in axes:
            axis.axvline(event.time, color=INK, linewidth=0.7, linestyle=":", alpha=0.6)
    place = {"xycoords": ("data", "axes fraction"), "xytext": (3, -3), "textcoords": "offset points"}
    look = {"fontsize": 8, "color": INK, "rotation": 90, "va": "top", "ha": "left"}
    for event in run.events if len(run.events) <= MOST_MARKS else ():
        axes[0].annotate(event.state or event.what, (event.time, 1.0), **place, **look)
