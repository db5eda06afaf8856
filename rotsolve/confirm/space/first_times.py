"""First times: whether a time that is sought is the first, or the last, after which all is as a later state tells.

The motion is followed to some times before, or after, the one that is answered; between two at which what is left over of the state's lines
has different signs there is another one.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from contextlib import suppress

from rotsolve.algebra.formula import Formula
from rotsolve.algebra.units.dimension import TIME
from rotsolve.confirm import NotConfirmed, Unfit
from rotsolve.confirm.numbers import value_of
from rotsolve.confirm.space.hearing import Hearing
from rotsolve.confirm.space.rigs import time_after
from rotsolve.confirm.space.rivals import SAME, leaves_nothing, roots_between
from rotsolve.language.problem import Find

BEFORE = (0.01, 0.05, 0.12, 0.2, 0.29, 0.38, 0.47, 0.56, 0.65, 0.74, 0.83, 0.92, 0.99)  # of the time that is answered
AFTER = (1.01, 1.1, 1.25, 1.45, 1.7, 2.0, 2.4, 3.0)


def tells_time(hearing: Hearing, letter: str) -> bool:
    """Whether a letter is the time that passes until a state."""
    told = [time_after(state) for state in hearing.problem.states[1:]]
    dimension = hearing.dimension(letter)
    timed = dimension is not None and dimension.matches(TIME)
    return timed and any(time is not None and letter in time.symbols() for time in told)


def farthest_time(hearing: Hearing, find: Find, letter: str, own: float, roots: Sequence[Formula]) -> bool:
    """Whether no other time is smaller, or none larger, as is asked: no root of its equation, nor any at which the motion is looked at."""
    sign = 1.0 if find.modifier == "largest" else -1.0
    for root in roots:
        with suppress(NotConfirmed, ArithmeticError, ValueError, TypeError):
            value = float(value_of(root, hearing.known))
            beyond = value > 0.0 and (value - own) * sign > SAME * own
            if beyond and leaves_nothing(hearing, letter, value):
                return False
    places = [own * share for share in (AFTER if sign > 0.0 else BEFORE)]

    def left(value: float) -> list[float]:
        with suppress(Unfit):
            return hearing.left({0: value - own})
        return []

    try:
        found = list(roots_between(left, places))
    except (NotConfirmed, ArithmeticError, ValueError):
        return False
    return own > 0.0 and all(math.isclose(root, own, rel_tol=SAME) for root in found)
