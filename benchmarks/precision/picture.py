"""Run time against error as pictures: a log-log panel for each problem, a line for each peer."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

from .measure import Row
from .problem import Problem

LEAST_ERROR = 1e-32  # below, all is drawn on the lower edge
COLUMNS = 3
STYLES = {  # by the beginning of a peer's name: colour and marker
    "rotsolve": ("#c1121f", "o"),
    "scipy RK45": ("#8ecae6", "v"),
    "scipy DOP853": ("#219ebc", "^"),
    "scipy LSODA": ("#126782", "<"),
    "scipy Radau": ("#023047", ">"),
    "scipy": ("#5e8ca5", "d"),
    "numpy": ("#5e8ca5", "d"),
    "mpmath": ("#6a994e", "s"),
    "sympy": ("#7b2cbf", "P"),
    "heyoka": ("#e07a00", "D"),
    "MuJoCo": ("#555555", "X"),
    "pymunk": ("#b08968", "*"),
}


def style(peer: str) -> tuple[str, str]:
    """The colour and the marker of a peer."""
    return next(look for name, look in STYLES.items() if peer.startswith(name))


def panel(axes: Any, problem: Problem, rows: Sequence[Row], whole: bool) -> None:
    """One problem: time to the right, error upwards."""
    for peer in dict.fromkeys(row.peer for row in rows):
        points = [
            (row.cpu if whole else row.marginal, row.error) for row in rows if row.peer == peer and not row.failed
        ]
        if points:
            colour, marker = style(peer)
            times, errors = zip(*points, strict=True)
            shown = [min(max(error, LEAST_ERROR), 1e2) for error in errors]
            thick = 2.2 if peer == "rotsolve" else 1.0
            axes.plot(times, shown, color=colour, marker=marker, markersize=5, linewidth=thick, label=peer)
    axes.set(xscale="log", yscale="log", ylim=(LEAST_ERROR / 10, 1e3))
    axes.set_title(problem.title.replace(": ", ":\n", 1), fontsize=9)
    axes.grid(True, which="major", color="#dddddd", linewidth=0.6)
    axes.tick_params(labelsize=8)
    axes.spines[["top", "right"]].set_visible(False)


def draw(problems: Sequence[Problem], rows: Sequence[Row], file: Path, whole: bool) -> None:
    """Write a picture of all problems, of whole processes or of further solves in one."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    matplotlib.rcParams.update({"svg.hashsalt": "rotsolve", "font.family": "DejaVu Sans"})
    lines = -(-len(problems) // COLUMNS)
    figure, grid = pyplot.subplots(lines, COLUMNS, figsize=(4.2 * COLUMNS, 3.3 * lines + 1.2), squeeze=False)
    panels = list(grid.flat)
    for axes, problem in zip(panels, problems, strict=False):
        panel(axes, problem, [row for row in rows if row.problem == problem.name], whole)
    for axes in panels[len(problems) :]:
        axes.set_axis_off()
    for line in grid:
        line[0].set_ylabel("error", fontsize=9)
    entries: dict[str, Any] = {}
    for axes in panels:
        entries |= dict(zip(*reversed(axes.get_legend_handles_labels()), strict=True))
    figure.legend(entries.values(), entries.keys(), loc="lower center", ncols=6, fontsize=8, frameon=False)
    what = "a whole process, start-up included" if whole else "one more solve in the same process"
    figure.suptitle(f"Processor time of {what}, in seconds, against error: down and to the left is better", fontsize=11)
    figure.tight_layout(rect=(0, 0.9 / (3.3 * lines + 1.2), 1, 0.985))
    figure.savefig(file, metadata={"Date": None})
    pyplot.close(figure)
