"""Bodies on a plank that travels, by friction that goes against the slip, or by a stiff grip instead of no slip at all."""

from __future__ import annotations

import math

import pytest

from stepping import G, State, answers, run, until


def test_block_on_a_plank_by_steps_until_both_go_alike() -> None:
    block, plank, speed, mu = 2.0, 6.0, 4.0, 0.25

    def rate(time: float, state: State) -> State:
        """Velocities of block and plank, the way slipped and the heat."""
        slip = state[0] - state[1]
        return -mu * G, mu * block * G / plank, slip, mu * block * G * slip

    time, final = until(rate, (speed, 0.0, 0.0, 0.0), lambda _, state: state[0] - state[1])
    found = answers("block-slides-onto-a-plank")
    for key, value in {"v": final[1], "t": time, "s": final[2], "Q": final[3]}.items():
        assert found[key] == pytest.approx(value, rel=1e-9), key


@pytest.mark.parametrize(("share", "slips"), [(0.99, False), (1.01, True)])
def test_the_largest_pull_is_that_beyond_which_the_block_slips(share: float, slips: bool) -> None:
    block, plank, mu = 2.0, 6.0, 0.25
    together = share * answers("block-slides-onto-a-plank")["F"] / (block + plank)
    assert (together > mu * G) is slips  # what friction at its most can give the block


def test_cylinder_on_a_plank_by_a_grip_that_is_stiff_and_damped() -> None:
    """The friction is that of a stiff damper between rim and plank, so that the wheel creeps by next to nothing."""
    plank, wheel, radius, pull, stiff, duration = 6.0, 4.0, 0.1, 30.0, 4e4, 0.98

    def rate(time: float, state: State) -> State:
        """Velocities of plank and wheel, angular velocity (counterclockwise), ways of plank and wheel."""
        creep = state[0] - (state[1] + radius * state[2])  # the rim's lowest point goes with the plank
        grip = stiff * creep
        turning = grip * radius / (wheel * radius**2 / 2)
        return (pull - grip) / plank, grip / wheel, turning, state[0], state[1]

    final = run(rate, (0.0,) * 5, duration, steps=40_000)
    settled = rate(duration, final)
    found = answers("cylinder-on-a-plank")
    assert found["A"] == pytest.approx(settled[0], rel=1e-3)
    assert found["a"] == pytest.approx(settled[1], rel=1e-3)
    assert found["f"] == pytest.approx(wheel * settled[1], rel=1e-3)
    assert found["d"] / 2.0 == pytest.approx((final[3] - final[4]) / final[3], rel=1e-3)
    assert found["v"] / math.sqrt(2.0) == pytest.approx(final[0] / math.sqrt(final[3]), rel=1e-3)
