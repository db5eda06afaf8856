"""Run: a motion that has been followed, and what can be read from it at any moment, each number with its bound."""

from __future__ import annotations

from bisect import bisect_right
from functools import cached_property
from math import inf
from typing import ClassVar

from msgspec import Struct, field

from rotsolve.algebra.certified.ball import Precision
from rotsolve.algebra.flints import arb
from rotsolve.language.problem import Problem
from rotsolve.page.columns import page_text
from rotsolve.simulation.balance import Drift, drift
from rotsolve.simulation.bounded import Regime
from rotsolve.simulation.following import READING_BITS, Occurrence
from rotsolve.simulation.system import Readout
from rotsolve.simulation.tape import Scalar

WIDTH = 120  # columns of a printed run


class Run(Struct, dict=True):
    """A motion in time. `names` are what can be told at any moment; every number comes with a bound that holds the true one."""

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
        """`<Run of “Uniform rod …”: 0 to 5 s, 2 events; .names, .at(time), .balls(time), .events, .drift>`."""
        title = f" of “{self.problem.title}”" if self.problem.title else ""
        count = f"{len(self.events)} event{'' if len(self.events) == 1 else 's'}"
        return f"<Run{title}: 0 to {self.end:g} s, {count}; .names, .at(time), .balls(time), .events, .drift>"

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

    def at(self, time: float, names: tuple[str, ...] | None = None) -> dict[str, tuple[float, float]]:
        """Values at a time, each with its bound, in SI units and radians."""
        found = {}
        for name, ball in self.balls(time, names).items():
            with Precision(READING_BITS):
                value = float(ball.mid())
                found[name] = (value, float(abs(ball - value).upper()))
        return found
