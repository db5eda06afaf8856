"""MotionReading: the numbers of a motion at the moments that are drawn, each read once."""

from __future__ import annotations

from bisect import bisect_right

from rotsolve.simulation.bounded import Regime
from rotsolve.simulation.run import Run
from rotsolve.simulation.tape import Scalar


class MotionReading:
    """A motion at some moments."""

    def __init__(self, run: Run, times: tuple[float, ...]) -> None:
        self.run, self.times = run, times
        self.rows: dict[str, list[Scalar | None]] = {}

    def balls(self, name: str) -> list[Scalar | None]:
        """A quantity at all moments; None where it has no value, or is not told."""
        if name not in self.rows:
            self.read((name,))
        return self.rows[name]

    def read(self, names: tuple[str, ...]) -> None:
        """Reads several quantities at once, which is cheaper."""
        found = [self.run.balls(time, names) for time in self.times]
        self.rows.update({name: [row.get(name) for row in found] for name in names})

    def value(self, name: str, number: int) -> float | None:
        """A quantity at one moment."""
        ball = self.balls(name)[number]
        return None if ball is None else float(ball.mid())

    def regime(self, time: float) -> Regime:
        """The part of the motion that a moment belongs to."""
        starts = [part.times[0] for part in self.run.regimes]
        return self.run.regimes[max(0, bisect_right(starts, time) - 1)]
