"""Certified motions: every bound is proved, so that it holds without exception."""

from __future__ import annotations

import mpmath
import pytest

from rotsolve import simulate
from scenes import DRAG, PENDULUM, SLIDING, SPRING
from test_simulation_closed_forms import Truth, compared, decay, oscillation, swing

CASES: dict[str, tuple[str, Truth]] = {
    "rod from 60°": (PENDULUM.format(angle="-30 deg"), swing(lambda: -mpmath.pi / 6)),
    "rod from 179.99°": (PENDULUM.format(angle="89.99 deg"), swing(lambda: mpmath.mpf("89.99") * mpmath.pi / 180)),
    "block on a spring": (SPRING, oscillation),
    "flywheel in oil": (DRAG, decay),
}


@pytest.mark.parametrize("name", CASES)
def test_proved_bounds_hold(name: str) -> None:
    scene, truth = CASES[name]
    with mpmath.workdps(60):
        run = simulate(scene, 5, 1e-12, certified=True)
        _, bounds, sizes = compared(run, truth, 5)
    assert run.regimes[0].proved and run.end == 5
    assert all(bounds[quantity] <= 1e-12 * sizes[quantity] for quantity in bounds)


def test_a_certified_motion_ends_before_something_may_happen() -> None:
    run = simulate(SLIDING, 5, certified=True)
    assert run.ended == "what happens then can not be certified"
    assert run.end < 4 / (0.25 * 9.8)
