"""Run: a motion that has been followed, and what can be read from it at any moment, each number with its bound."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Sequence
from functools import cached_property
from math import inf, nan
from numbers import Real
from typing import Any, ClassVar, overload

from msgspec import Struct, field

from rotsolve.algebra.certified.ball import Precision
from rotsolve.algebra.flints import arb
from rotsolve.core.faults import missing_package
from rotsolve.language.problem import Problem
from rotsolve.page.columns import page_text
from rotsolve.simulation.balance import Drift, drift
from rotsolve.simulation.bounded import Regime
from rotsolve.simulation.following import READING_BITS, Occurrence
from rotsolve.simulation.system import Readout
from rotsolve.simulation.tape import Scalar

WIDTH = 120  # columns of a printed run


class Run(Struct, dict=True, eq=False):
    """A motion in time. `names` are what can be told at any moment; every number comes with a bound that holds the true one.

    Two are equal where they follow the same scene as far and as accurately, and come to the same events. It can be pickled.
    """

    signs: ClassVar[str] = (
        "Angles are counted counterclockwise; speeds and distances along the way in which each body is said to move or turn."
    )
    shown: ClassVar[tuple[str, ...]] = (  # in the table
        "angle",
        "position",
        "elongation",
        "length",
        "rotation",
        "angular_velocity",
        "velocity",
    )

    problem: Problem
    until: float
    accuracy: float
    regimes: list[Regime]
    events: tuple[Occurrence, ...] = ()
    ended: str = ""  # why it was not followed to the end asked for
    settled: float = inf  # the time to which its numbers are as accurate as asked
    sought: str = ""  # the last state of the scene that was looked for
    _readings: dict[tuple[int, tuple[str, ...]], Readout] = field(default_factory=dict)

    @property
    def end(self) -> float:
        """The time to which it was followed."""
        return min(self.settled, self.regimes[-1].ends[0])

    @property
    def rounded(self) -> bool:
        """Whether the roundings of floats matter as much as what the steps leave out."""
        return self.regimes[0].tolerances.rounded

    @property
    def unreached(self) -> tuple[str, ...]:
        """The states of the scene, from the last one that was looked for on, if the motion has not come to it.

        A state that says nothing of a place, a speed or a force (that something rolls) is not looked for; nothing is in proved motions.
        """
        names = [state.name for state in self.problem.states]
        if not self.sought or any(event.state == self.sought for event in self.events):
            return ()
        return tuple(names[names.index(self.sought) :])

    def __repr__(self) -> str:
        """`<Run of “Uniform rod …”: 0 to 5 s, 2 events; .names, .at(time), .plot(), .to_frame(), .events, .drift>`."""
        title = f" of “{self.problem.title}”" if self.problem.title else ""
        count = f"{len(self.events)} event{'' if len(self.events) == 1 else 's'}"
        return f"<Run{title}: 0 to {self.end:g} s, {count}; .names, .at(time), .plot(), .to_frame(), .events, .drift>"

    def __str__(self) -> str:
        """The table, what happened on the way, and how accurate it is: what the command prints."""
        from rotsolve.simulation.report import run_lines

        return page_text(list(run_lines(self, WIDTH))).rstrip()

    @cached_property
    def drift(self) -> Drift:
        """How far energy and momentum are from what the forces make of them, as parts of the largest that there was."""
        return drift(self.regimes)

    @property
    def names(self) -> tuple[str, ...]:
        """What can be told at any moment: `rod.angle`, `block.velocity`, `string.tension`, …"""
        return tuple(self.regimes[0].system.outputs)

    def balls(self, time: float, names: tuple[str, ...] | None = None) -> dict[str, Scalar]:
        """Quantities at a time as balls that hold the true values; those without a value then (a precession at tilt 0) are left out."""
        if not 0 <= time <= self.end:
            raise ValueError(f"the motion was followed from 0 to {self.end:g} s, not to {time:g} s")
        number = max(0, bisect_right([item.times[0] for item in self.regimes], time) - 1)
        part = self.regimes[number]
        wanted = tuple(name for name in (names or part.system.outputs) if name in part.system.outputs)
        with Precision(max(READING_BITS, 2 * part.bits)):
            if (number, wanted) not in self._readings:
                places = {name: part.system.outputs[name] for name in wanted}
                self._readings[number, wanted] = Readout(part.system, places)
            reading = self._readings[number, wanted]
            found = reading.read(time, part.state(time))
            direct = {item.name for item in part.system.variables}
            others = [name for name in wanted if name not in direct]
            if others and not part.proved:
                middles = reading.read(time, part.rounded(time))
                for name, bound in zip(others, part.derived(time, others), strict=True):
                    near = middles[name]
                    apart = arb(near.mid(), near.rad() + bound + part.rounding * abs(float(near)))
                    found[name] = min(found[name], apart, key=lambda ball: float(ball.rad()))
        return {name: ball for name, ball in found.items() if ball.is_finite()}

    @overload
    def at(self, time: float | str, names: str | Sequence[str] | None = None) -> dict[str, tuple[float, float]]: ...
    @overload
    def at(self, time: Any, names: str | Sequence[str] | None = None) -> dict[str, tuple[Any, Any]]: ...
    def at(self, time: Any, names: str | Sequence[str] | None = None) -> dict[str, Any]:
        """Values at a time, each with its bound, in SI units and radians; arrays of both for an array of times.

        A time is in seconds, or a text such as "2 s". `names` may be words, as for `plot`. What has no value then (a precession at tilt 0)
        is left out, and NaN in arrays. Raises ValueError for a time to which the motion was not followed, Unsolvable for what it does not
        tell.
        """
        wanted = None if names is None else self._wanted((names,) if isinstance(names, str) else names)
        if isinstance(time, str):
            from rotsolve.scene.values import read_time_of

            time = read_time_of(time)
        if not isinstance(time, Real):
            return self._at_times(time, wanted)
        found = {}
        for name, ball in self.balls(float(time), wanted).items():
            with Precision(READING_BITS):
                value = float(ball.mid())
                found[name] = (value, float(abs(ball - value).upper()))
        return found

    def _at_times(self, times: Any, names: tuple[str, ...] | None) -> dict[str, Any]:
        """Values and bounds as arrays of the shape of the times."""
        try:
            import numpy as np
        except ModuleNotFoundError:
            raise missing_package("arrays take", "NumPy", "arrays") from None
        moments = np.asarray(times, dtype=np.float64)
        told = self.told if names is None else names
        values = {name: (np.full(moments.shape, nan), np.full(moments.shape, inf)) for name in told}
        for place, moment in np.ndenumerate(moments):
            for name, (value, bound) in self.at(float(moment), names).items():
                values[name][0][place], values[name][1][place] = value, bound
        return values

    @cached_property
    def told(self) -> tuple[str, ...]:
        """What can be told at some moment, if not at all of them: after what happens on the way there may be other forces."""
        return tuple(dict.fromkeys(name for part in self.regimes for name in part.system.outputs))

    def _wanted(self, names: Sequence[str]) -> tuple[str, ...]:
        """The names of what is asked for, each once; a word may stand for several."""
        if set(names) <= set(self.told):
            return tuple(names)
        from rotsolve.simulation.choosing import chosen_names

        return chosen_names(self, names)

    def plot(self, names: str | Sequence[str] = (), path: str | None = None) -> Any:
        """The motion as a figure of matplotlib, which a notebook shows; written into an .svg or .png file where a `path` is told.

        `names` are as for `rotsolve simulate --show`: `"tension"`, `["rod.angle", "forces"]`; places and speeds where none are told.
        """
        from rotsolve.simulation.choosing import chosen_names
        from rotsolve.simulation.plot import figure_of, write_figure

        figure = figure_of(self, chosen_names(self, (names,) if isinstance(names, str) else tuple(names)))
        if path is not None:
            write_figure(figure, path)
        return figure

    def to_frame(self, times: Any = 101, names: str | Sequence[str] = (), *, bounds: bool = False) -> Any:
        """The motion as a table of pandas: a row for each time, in seconds, a column for each quantity, in SI units and radians.

        `times` are an array, or how many there are from start to end, evenly apart. `names` are as for `plot`; `bounds` adds
        `rod.angle bound` beside `rod.angle`.
        """
        from rotsolve.simulation.choosing import chosen_names
        from rotsolve.simulation.tables import frame_of_run

        chosen = chosen_names(self, (names,) if isinstance(names, str) else tuple(names))
        return frame_of_run(self, times, chosen, bounds)

    def _repr_html_(self) -> str:
        from rotsolve.page.formats import format_named
        from rotsolve.page.html_rows import notebook_piece
        from rotsolve.simulation.tables import run_page

        return notebook_piece(format_named("html").body(run_page(self), WIDTH))

    def __eq__(self, other: object) -> bool:
        return self._followed == other._followed if isinstance(other, Run) else NotImplemented

    def __hash__(self) -> int:
        return hash((self.problem.lines, self.problem.settings, self.until, self.accuracy))

    @property
    def _followed(self) -> tuple[Any, ...]:
        """What tells one motion from another."""
        proved = [part.proved for part in self.regimes]
        return self.problem, self.until, self.accuracy, proved, self.events, self.ended, self.end, self.told

    def __reduce__(self) -> tuple[Any, ...]:
        """What is kept is all but what reads from it, which is made again."""
        fields = (getattr(self, name) for name in self.__struct_fields__ if name != "_readings")
        return type(self), tuple(fields)
