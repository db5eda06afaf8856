"""Drives: what they prescribe at a moment, and the rates of it that vanish."""

from __future__ import annotations

from rotsolve.algebra.formula import ZERO
from rotsolve.core.varying import paths_in
from rotsolve.core.writing import spoken
from rotsolve.equations.states.fixed import Fixed
from rotsolve.motion.instant import Instant
from rotsolve.paths import NotYet


def prescribe(instant: Instant, fixed: Fixed, *, by_motion: bool = False) -> None:
    """What a drive prescribes at a moment, and rates of it that vanish; what goes `by_motion` itself waits for what the states say."""
    bodies = fixed.configuration.present(instant.state)
    drives = [drive for body in bodies for drive in fixed.configuration.drives(body.name, instant.state)]
    drives = [drive for drive in drives if any(paths_in(drive.function)) == by_motion]
    for drive in drives:
        if by_motion and drive.order < 2:
            word = spoken(drive.word)
            raise NotYet(f"a given {word} is a formula of `time` alone", help="give the acceleration instead")
        fixed.fix(instant.driven(drive, drive.word), instant.now(drive.function))
    for drive in drives:
        for word, function in drive.rates().items():
            if function == ZERO:
                fixed.fix(instant.driven(drive, word), ZERO)
