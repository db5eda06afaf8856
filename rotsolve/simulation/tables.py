"""Tables: a motion as a table of pandas, and as what a notebook shows of it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from rotsolve.page.blocks import Bullet, Bullets, FixedPage, PageBlock, Paragraph, Table, Title
from rotsolve.simulation.report import (
    balances_sentence,
    bounds_sentence,
    columns_of,
    is_at_rest,
    quantity_unit,
    settled_cells,
    time_cells,
    time_text,
    times_of,
)
from rotsolve.simulation.run import Run
from rotsolve.solution.frames import pandas


def frame_of_run(run: Run, times: Any, names: Sequence[str], bounds: bool) -> Any:
    """A row for each time, a column for each quantity, with its bound beside it where `bounds` says so."""
    frame = pandas().DataFrame
    if isinstance(times, int) and times < 1:
        raise ValueError(f"a table has a row at least, not {times}")
    moments = [run.end * k / max(1, times - 1) for k in range(times)] if isinstance(times, int) else times
    found = run.at(moments, tuple(names))
    columns = {}
    for name, (values, errors) in found.items():
        columns[name] = values
        if bounds:
            columns[f"{name} bound"] = errors
    return frame(columns, index=pandas().Index(moments, name="t"))


def run_page(run: Run) -> FixedPage:
    """The table of a motion with what happened on the way, as the command prints them."""
    return FixedPage(tuple(run_blocks(run)))


def run_blocks(run: Run) -> Iterator[PageBlock]:
    if run.problem.title:
        yield Title(1, (run.problem.title,))
    yield Paragraph((run.signs,))
    names, times = columns_of(run), times_of(run, None)
    rows = [run.balls(time, names) for time in times]
    columns = [time_cells(times), *(settled_cells([row.get(name) for row in rows]) for name in names)]
    heads = ("t, s", *(f"{name}, {quantity_unit(name)}" for name in names))
    yield Table(heads, tuple(tuple((cell,) for cell in row) for row in zip(*columns, strict=True)))
    events = [f"t = {time_text(event.time, event.bound)} s: {event.state or event.what}" for event in run.events]
    if events:
        yield Bullets(tuple(Bullet((event,)) for event in events))
    if run.ended:
        yield Paragraph((f"It ends at t = {time_text(run.end, 0.0)} s: {run.ended}.",))
    yield Paragraph((bounds_sentence(run, names),))
    if not is_at_rest(run):
        yield Paragraph((balances_sentence(run),))
