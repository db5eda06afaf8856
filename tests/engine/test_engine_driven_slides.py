"""What slides along a body that is driven steadily: energy in the frame that turns with it, against its equation along the body, stepped.

r̈ = ω² r − k (r − l)/m along the rod; the drive gives τ = 2 m r ṙ ω.
"""

from __future__ import annotations

from math import sqrt

import numpy as np
import pytest

import rotsolve
from rotsolve.core.faults import Unsolvable

SCENE = """title: x
plane: horizontal
given: {m: 500 g, M: 1.5 kg, w: 2 rad/s, u: 1 m/s, a: 20 cm, r: 50 cm, L: 2 m, k: 3 N/m, T: 1 s, O: 0 m}
bodies: {rod: {shape: rod, mass: M, length: L}, sleeve: {mass: m}}
connections:
  axis: {hinge: rod.start, angular_velocity: w}
  guide: {rides: [sleeve, rod], friction: none}
  MORE
states: {start: {sleeve.radius: a, sleeve.velocity.radial: u}, out: {sleeve.radius: r}}
find: {v: sleeve.velocity.radial at out, W: axis.work from start to out}
"""
COIL = "coil: {spring: [rod.start, sleeve], stiffness: k, rest_length: a}"
M, W, U, A, R, K = 0.5, 2.0, 1.0, 0.2, 0.5, 3.0


def stepped(
    stiffness: float, rest: float, first: float, last: float, speed: float, steps: int = 20000
) -> tuple[float, float]:
    """Speed along the rod at a place, and the work of the drive ∫ 2 m r ṙ ω² dt, by d(ṙ²)/dr = 2 r̈ in the middle of each step."""
    places = np.linspace(first, last, steps + 1)
    middle = (places[1:] + places[:-1]) / 2
    pushes = W**2 * middle - stiffness * (middle - rest) / M
    return speed**2 + 2 * float((pushes * np.diff(places)).sum()), 2 * M * W**2 * float(
        (middle * np.diff(places)).sum()
    )


@pytest.mark.parametrize(
    ("more", "stiffness", "rest"),
    [
        ("", 0.0, 0.0),
        (COIL, K, A),
        (COIL.replace("rod.start", "rod.end"), K, 1.8),  # of the same force as one from the axis, 2 m − 20 cm long
    ],
)
def test_a_sleeve_on_a_driven_rod_with_and_without_a_spring(more: str, stiffness: float, rest: float) -> None:
    square, work = stepped(stiffness, rest, A, R, U)
    solution = rotsolve.solve(SCENE.replace("MORE", more))
    assert solution.answers["v"].float == pytest.approx(sqrt(square), rel=1e-6)
    assert solution.answers["W"].float == pytest.approx(work, rel=1e-6)
    assert "confirmed with numbers" in " ".join(str(solution).split())


def test_inwards_it_is_slowed() -> None:
    inwards = SCENE.replace("radius: a, sleeve.velocity.radial: u", "radius: r, sleeve.velocity.radial: -u")
    solution = rotsolve.solve(inwards.replace("out: {sleeve.radius: r}", "out: {sleeve.radius: a}").replace("MORE", ""))
    square, work = stepped(0.0, 0.0, R, A, U)
    assert solution.answers["v"].float == pytest.approx(-sqrt(square), rel=1e-6)
    assert solution.answers["W"].float == pytest.approx(work, rel=1e-6)


def test_what_is_drawn_inwards_on_a_driven_table_takes_work() -> None:
    """The force that draws it does −½ m (r² − a²) ω² of work outwards, and the drive twice that on it."""
    drawn = SCENE.replace(", friction: none", "").replace(", sleeve.velocity.radial: u", "").replace("MORE", "")
    answers = rotsolve.solve(
        drawn.replace("v: sleeve.velocity.radial at out", "v: guide.work from start to out")
    ).answers
    assert answers["v"].float == pytest.approx(-M * (R**2 - A**2) * W**2 / 2)
    assert answers["W"].float == pytest.approx(M * (R**2 - A**2) * W**2)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("angular_velocity: w", "angular_velocity: w*(1 + time/T)", "`v` is not solved by these laws"),  # no constant rate
        ("plane: horizontal", "gravity: 9.8 m/s^2", "too little is known"),  # the weight is another one at each angle
        ("MORE", COIL.replace("rod.start", "[O, L]"), "too little is known"),  # nor does a spring from elsewhere keep it
        ("MORE", "coil: {spring: [rod.start, sleeve], stiffness: k}", "give its `rest_length`"),
    ],
)  # fmt: skip
def test_where_nothing_is_kept_it_is_refused(old: str, new: str, words: str) -> None:
    with pytest.raises(Unsolvable, match=words):
        rotsolve.solve(SCENE.replace(old, new).replace("MORE", ""))


def test_no_impulse_is_said_to_be_nothing_of_a_body_on_which_something_slides() -> None:
    """The time that it takes on a spring is not told by these laws: it is refused by that, and not as a place that is never reached."""
    with pytest.raises(Unsolvable, match="`t` is not solved by these laws"):
        asked = SCENE.replace("v: sleeve.velocity.radial at out, W: axis.work", "t: time").replace("MORE", COIL)
        rotsolve.solve(asked)
