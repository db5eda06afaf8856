"""What the routes calculate with."""

from __future__ import annotations

from mpmath import mp

from ..problem import Mathematics, Motion, Problem


def maths() -> Mathematics:
    """mpmath at the precision of the moment."""
    return Mathematics(mp.mpf, mp.sin, mp.cos, mp.asin, +mp.pi)


def motion_of(problem: Problem) -> Motion:
    """The motion that a route follows."""
    assert problem.motion is not None, problem.name
    return problem.motion
