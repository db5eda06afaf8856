"""Linkages: when the derivative of the energy takes the place of Newton's laws, and when it may not."""

from __future__ import annotations

import mpmath
import pytest

from rotsolve.pipeline import solve

LADDER = """
title: Rod in two guides
given: {{M: 20 kg, L: 4 m, b: 3 m, theta: 60 deg}}
surfaces: {{floor: level, side: {{wall: left}}}}
bodies: {{rod: {{shape: rod, mass: M, length: L, points: {{P: [b - L/2, 0]}}}}}}
connections:
  foot: {{contact: [rod.{foot}, floor]}}
  head: {{contact: [rod.start, side]}}
states:
  released: {{rod.angle: -theta, at rest: all}}
  off: {{head: leaves}}
find: {{{find}}}
"""
DERIVATIVE = "derivative of the energy"
ALPHA = "alpha: rod.angular_acceleration at released"


def text_of(find: str, foot: str = "end", law: str | None = None) -> str:
    return solve(LADDER.format(find=find, foot=foot), law=law).to("text")


def test_where_a_ladder_leaves_the_wall_the_floor_does_not_come_in() -> None:
    text = text_of("phi: rod.angle at off")
    assert DERIVATIVE in text
    assert "vertically" not in text
    assert "The kinetic energy is ½ (¼ M L² + I) times the square of the angular velocity" in text


def test_an_acceleration_alone_leaves_out_both_forces() -> None:
    text = text_of(ALPHA)
    assert DERIVATIVE in text
    checks = [" ".join(map(str, check.words)) for check in solve(LADDER.format(find=ALPHA, foot="end")).checks]
    assert any("Newton's laws give the same" in words for words in checks)


@pytest.mark.parametrize(("find", "law"), [(f"{ALPHA}, N: foot.normal_force at released", None), (ALPHA, "newton")])
def test_newtons_laws_serve_where_a_force_or_they_are_asked_for(find: str, law: str | None) -> None:
    text = text_of(find, law=law)
    assert DERIVATIVE not in text
    assert "Newton's second law" in text


def test_while_the_inertia_of_the_motion_changes_newtons_laws_serve() -> None:
    """K = ½ J(φ) ω² with J = M ((L/2)² sin² φ + (b − L/2)² cos² φ) + I: where a_x = 0 is told by E alone, found numerically."""
    assert DERIVATIVE not in text_of("phi: rod.angle at off", foot="P")
    found = solve(LADDER.format(find="phi: rod.angle at off", foot="P")).answers["phi"]
    assert found.float == pytest.approx(float(mpmath.findroot(sideways, (-1.0, -0.2), solver="anderson")), rel=1e-9)


def sideways(phi: float) -> float:
    """The acceleration of the centre away from the wall, but for a factor: by ω² = 2 ΔU/J and α = ½ d(ω²)/dφ."""

    def square(at: float) -> float:
        inertia = (2 * mpmath.sin(at)) ** 2 + mpmath.cos(at) ** 2 + 4**2 / 12
        return (mpmath.sin(mpmath.pi / 3) + mpmath.sin(at)) / inertia

    return mpmath.diff(square, phi) / 2 * mpmath.sin(phi) + square(phi) * mpmath.cos(phi)
