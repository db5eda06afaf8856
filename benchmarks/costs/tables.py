"""Tables, targets and growth: what the parts of the benchmark have in common."""

from __future__ import annotations

from collections.abc import Sequence
from math import log
from statistics import linear_regression
from typing import NamedTuple


class Target(NamedTuple):
    """What was to be reached, what was, whether that is enough, and what keeps it from being so where it is not."""

    what: str
    wanted: str
    reached: str
    met: bool
    why: str = ""


class Part(NamedTuple):
    """One part of the benchmark: its heading, its text with tables, and its targets."""

    title: str
    text: str
    targets: tuple[Target, ...]


def table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    """A Markdown table, its first column left and the others right, in even columns."""
    widths = [max(len(row[index]) for row in (head, *rows)) for index in range(len(head))]
    rule = ["-" * widths[0], *("-" * (width - 1) + ":" for width in widths[1:])]
    lines = [head, rule, *rows]
    return "\n".join(
        f"| {' | '.join(fitted(cell, widths[at], at) for at, cell in enumerate(line))} |" for line in lines
    )


def fitted(cell: str, width: int, column: int) -> str:
    return cell.rjust(width) if column else cell.ljust(width)


def below(what: str, value: float, limit: float, form: str = "{:.2f}", why: str = "") -> Target:
    """A target that is met at or below a limit."""
    return Target(what, f"≤ {form.format(limit)}", form.format(value), value <= limit, why)


def above(what: str, value: float, limit: float, form: str = "{:.0f}", why: str = "") -> Target:
    """A target that is met at or above a limit."""
    return Target(what, f"≥ {form.format(limit)}", form.format(value), value >= limit, why)


def share(values: Sequence[float], part: float) -> float:
    """The value below which a part of all lies: 0.5 the median, 0.9 all but the slowest tenth."""
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(part * len(ordered)))]


def exponent(sizes: Sequence[float], values: Sequence[float]) -> float:
    """The power of the size with which values grow: the slope of the straight line through their logarithms."""
    return linear_regression([log(size) for size in sizes], [log(value) for value in values]).slope
