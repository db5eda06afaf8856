"""What a state tells of the precession and spin of a free symmetric body: they are about its angular momentum where no tilt is told.

φ̇ = L/I₁ and ψ̇ = (I₁ − I₃) ω₃/I₁ (Landau & Lifshitz, Mechanics, §33).
"""

from __future__ import annotations

import math

import pytest

from rotsolve import Unsolvable, solve

FREE = """up: z
given: {w: unknown}
bodies: {free: {mass: 1 kg, inertia: {principal: [4 kg m^2, 4 kg m^2, 2 kg m^2]}, axis: z}}
"""
STRUCK = """up: z
given: {m: 1000 kg, a: 0.8 m, J: unknown}
bodies:
  sat:
    axis: z
    parts: {top: {shape: disc, mass: m/2, radius: a, at: [0, 0, a]}, low: {shape: disc, mass: m/2, radius: a, at: [0, 0, -a]}}
    points: {C: [0, a, a]}
states: {before: {sat.angular_velocity: [0, 0, 6 rad/s], sat.velocity: [0, 0, 0]}, after: {sat.precession: 4 rad/s}}
events: {hit: {impulse: J, on: sat.C, direction: [0, 0, -1], from: before, to: after}}
find: {J: J, om: sat.angular_velocity at after}
"""


def answered(scene: str) -> list[float]:
    answers = solve(scene).complete().derivation.answers
    return [part.value.float for answer in answers for part in (answer.components or (answer,)) if part.value]


@pytest.mark.parametrize(
    ("told", "value"),
    {
        "free.angular_velocity: [w, 0, 3 rad/s], free.precession: 5 rad/s": math.sqrt(25 - (2 * 3 / 4) ** 2),
        "free.angular_velocity: [1 rad/s, 2 rad/s, w], free.spin: 5 rad/s": 5 * 4 / (4 - 2),
    }.items(),
)
def test_a_rate_about_the_angular_momentum_is_told(told: str, value: float) -> None:
    found = answered(f"{FREE}states: {{now: {{{told}}}}}\nfind: {{w0: w}}\n")
    assert found == pytest.approx([value])


def test_the_precession_after_a_blow_tells_how_strong_it_was() -> None:
    """I₁ = 5 m a²/4, I₃ = m a²/2, and L across the axis is J a."""
    mass, arm = 1000, 0.8
    across = math.sqrt((1.25 * 4) ** 2 - (0.5 * 6) ** 2) * mass * arm
    assert answered(STRUCK) == pytest.approx([across, -across / (1.25 * mass * arm), 0, 6], abs=1e-9)


def test_a_rate_that_no_angular_momentum_can_have_is_refused() -> None:
    with pytest.raises(Unsolvable):
        solve(
            f"{FREE}states: {{now: {{free.angular_velocity: [w, 0, 12 rad/s], free.precession: 5 rad/s}}}}\nfind: {{w0: w}}\n"
        ).complete()


def test_with_a_tilt_the_rates_are_those_about_the_vertical() -> None:
    """ω = θ̇ e₁ + φ̇ sin θ e₂ + (φ̇ cos θ + ψ̇) e₃ at φ = 0."""
    told = "free.tilt: 30 deg, free.precession: 5 rad/s, free.spin: 2 rad/s, free.nutation: 0 rad/s"
    sin, cos = 0.5, math.sqrt(0.75)
    found = answered(
        f"{FREE.replace('given: {w: unknown}', '')}states: {{now: {{{told}}}}}\nfind: {{om: free.angular_velocity}}\n"
    )
    e2, e3 = (0, cos, sin), (0, -sin, cos)
    assert found == pytest.approx([5 * sin * y + (5 * cos + 2) * z for y, z in zip(e2, e3, strict=True)], abs=1e-12)
