"""Two routes to the driven pulley: its slips in closed form, and by extrapolation with every event found as a root."""

from __future__ import annotations

from typing import Any

from mpmath import mp

from ..peers.sticking import alternate
from ..problem import Problem
from ..problems.driven_pulley import DRAG, DRIVE, INERTIA, PACE, RUBBING, WEIGHT, slipping, turning
from . import extrapolation
from .maths import maths, motion_of

LOOK = "0.01"  # s: nothing starts and ends within so short a time


def root(function: Any, low: Any, high: Any) -> Any:
    """The root between two places where the signs differ, to all digits."""
    return mp.findroot(function, (low, high), solver="anderson", tol=mp.mpf(10) ** (20 - 2 * mp.dps), maxsteps=200)


def in_closed_form(problem: Problem) -> list[Any]:
    """ω = P + (A/I)(γ sin w t − w cos w t)/(γ² + w²) + C e^(−γ (t − t₀)), with γ = c/I and P = (W − s τ)/c, and its integral."""
    inertia, drag, drive, pace = (mp.mpf(text) for text in (INERTIA, DRAG, DRIVE, PACE))
    decay, until = drag / inertia, mp.mpf(problem.until)
    share = drive / inertia / (decay**2 + pace**2)

    def slip(start: Any, state: list[Any], sense: int) -> tuple[Any, list[Any], bool]:
        steady = (mp.mpf(WEIGHT) - sense * mp.mpf(RUBBING)) / drag

        def forced(time: Any) -> Any:
            return steady + share * (decay * mp.sin(pace * time) - pace * mp.cos(pace * time))

        def travelled(time: Any) -> Any:
            return steady * time - share * (decay * mp.cos(pace * time) / pace + mp.sin(pace * time))

        free = state[1] - forced(start)

        def speed(time: Any) -> Any:
            return forced(time) + free * mp.exp(-decay * (time - start))

        def place(time: Any) -> Any:
            return state[0] + travelled(time) - travelled(start) - free * mp.expm1(-decay * (time - start)) / decay

        late = start + mp.mpf(LOOK)
        while late < until and sense * speed(late) > 0:
            late += mp.mpf(LOOK)
        if sense * speed(min(late, until)) > 0:
            return until, [place(until), speed(until)], False
        rest = root(speed, late - mp.mpf(LOOK), late)
        return rest, [place(rest), mp.mpf(0)], True

    return alternate(problem, maths(), slip)


def by_extrapolation(problem: Problem) -> list[Any]:
    """The peers' own equations, a step at a time; the last step up to rest as long as makes the speed 0."""
    until, longest = mp.mpf(problem.until), 5 * mp.mpf(LOOK)
    tolerance = mp.mpf(10) ** (15 - mp.dps)

    def breakaway(maths: Any, stuck: Any) -> tuple[Any, int]:
        torque, late = turning(maths), stuck
        while abs(torque(late)) <= mp.mpf(RUBBING):
            late += mp.mpf(LOOK)
        sense = 1 if torque(late) > 0 else -1
        return root(lambda time: sense * torque(time) - mp.mpf(RUBBING), late - mp.mpf(LOOK), late), sense

    def slip(time: Any, state: list[Any], sense: int) -> tuple[Any, list[Any], bool]:
        rates = slipping(maths(), sense)
        while time < until:
            step = min(longest, until - time)
            after, _ = extrapolation.advance(rates, time, state, step, tolerance)
            if sense * after[1] <= 0:

                def speed(length: Any, time: Any = time, state: list[Any] = state) -> Any:
                    return extrapolation.advance(rates, time, state, length, tolerance)[0][1]

                step = root(speed, mp.mpf(LOOK) / 100, step)
                return time + step, extrapolation.advance(rates, time, state, step, tolerance)[0], True
            time, state = time + step, after
        return until, state, False

    motion = motion_of(problem)
    assert motion.sticking is not None
    own = motion._replace(sticking=motion.sticking._replace(breakaway=breakaway))
    return alternate(problem._replace(motion=own), maths(), slip)
