"""Both sides of a condition after `where`: when each is meant, and what lines above answer; values by hand.

A couple τ acts for 4 s on a disc of I = 0.09 kg m² that turns at 10 rad/s: ω = 10 + τ·4/0.09, and the turn is the mean rate times 4 s.
"""

from __future__ import annotations

import pytest

from rotsolve import solve
from rotsolve.core.faults import SceneError, Unsolvable

WHEEL = """given: {{M: 2 kg, R: 0.3 m, w0: 10 rad/s, tau: unknown}}
bodies: {{wheel: {{shape: disc, mass: M, radius: R}}}}
connections: {{pin: {{hinge: wheel.center}}}}
actions: {{push: {{couple: tau, on: wheel, direction: counterclockwise}}}}
states: {{start: {{wheel.angular_velocity: w0}}, end: {{time: 4 s}}}}
find:
  L: wheel.angular_momentum at start
  tau: tau where {condition}
"""
FOUND = {
    "wheel.angular_momentum at end = 3*wheel.angular_momentum at start": 0.45,
    "(wheel.angular_momentum at end) = 3*(wheel.angular_momentum at start)": 0.45,
    "3*wheel.angular_momentum at start = wheel.angular_momentum at end": 0.45,
    "wheel.angular_momentum = 3*L at end": 0.45,
    "wheel.angular_momentum at end = 3*L": 0.45,
    "wheel.angular_momentum at end = 2.7 kg m^2/s": 0.45,
    "wheel.kinetic_energy at end = 4*wheel.kinetic_energy at start": 0.225,
    "wheel.rotation from start to end = (6 rad)*wheel.kinetic_energy/(1 J) at start": -0.14625,
    "change of wheel.angular_momentum from start to end = wheel.angular_momentum at start": 0.225,
}


@pytest.mark.parametrize("condition", FOUND)
def test_each_side_of_a_condition_says_when_it_is_meant(condition: str) -> None:
    derivation = solve(WHEEL.format(condition=condition)).complete().derivation
    (answer,) = (item for item in derivation.answers if item.name == "tau")
    assert answer.value is not None
    assert answer.value.float == pytest.approx(FOUND[condition], rel=1e-12)
    assert all(item.holds for item in derivation.confirmed), derivation.confirmed


REFUSED = {
    "wheel.kinetic_energy at end = wheel.angular_momentum at start": "don't agree",
    "wheel.angular_momentum at end at start = 2*L": "`at` stands twice",
    "wheel.angular_momentum at end = tau2*L": "tau2",
    "wheel.angular_momentum at end =": "is no condition",
    "= wheel.angular_momentum at end": "is no condition",
}


@pytest.mark.parametrize("condition", REFUSED)
def test_a_condition_that_can_not_be_is_refused(condition: str) -> None:
    with pytest.raises((SceneError, Unsolvable)) as fault:
        solve(WHEEL.format(condition=condition))
    assert REFUSED[condition] in str(fault.value)
