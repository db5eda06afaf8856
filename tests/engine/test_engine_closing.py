"""Closing: hinges at told places: what is linked between them has to reach; rates of a linkage that closes, against vectors by hand."""

from __future__ import annotations

import cmath
import math

import pytest

from rotsolve import solve
from rotsolve.core.faults import SceneError, Unsolvable

CRANK, COUPLER, BASE, RATE = 0.2, 0.5, 0.45, 10.0
SCENE = (
    "title: t\ngravity: none\ngiven: {a: 20 cm, b: 50 cm, c: CC m, d: 45 cm, w: 10 rad/s, q: QQ rad, p: PP rad, s: SS rad}\n"
    "bodies: {crank: {shape: rod, mass: 1 kg, length: a}, coupler: {shape: rod, mass: 1 kg, length: b}, "
    "rocker: {shape: rod, mass: 1 kg, length: c}}\n"
    "connections:\n  A: {hinge: crank.start, at: [1 m, 2 m], angular_velocity: w}\n  D: {hinge: rocker.start, at: [1 m + d, 2 m]}\n"
    "  B: {hinge: [crank.end, coupler.start]}\n  C: {hinge: [coupler.end, rocker.end]}\n"
    "states: {now: {crank.angle: q, coupler.angle: p, rocker.angle: s}}\n"
    "find: {w3: coupler.angular_velocity, w4: rocker.angular_velocity, a4: rocker.angular_acceleration}\n"
)


def linkage(crank: float, coupler: float) -> tuple[str, tuple[float, float, float]]:
    """A scene with angles of which the rocker's length and angle follow, and the rates by the derivatives of the closing of the vectors."""
    end = CRANK * cmath.exp(1j * crank) + COUPLER * cmath.exp(1j * coupler) - BASE
    length, rocker = abs(end), cmath.phase(end)
    scene = SCENE.replace("CC", f"{length:.12f}").replace("QQ", f"{crank:.12f}")
    one, two, three = (
        size * cmath.exp(1j * angle) for size, angle in ((CRANK, crank), (COUPLER, coupler), (length, rocker))
    )
    (w3, w4) = solved(two, three, -1j * RATE * one)
    (_, a4) = solved(two, three, RATE**2 * one + w3**2 * two - w4**2 * three)
    return scene.replace("PP", f"{coupler:.12f}").replace("SS", f"{rocker:.12f}"), (w3, w4, a4)


def solved(two: complex, three: complex, right: complex) -> tuple[float, float]:
    """x, y of i x two − i y three = right."""
    u, v = 1j * two, -1j * three
    whole = u.real * v.imag - u.imag * v.real
    return (
        (right.real * v.imag - right.imag * v.real) / whole,
        (u.real * right.imag - u.imag * right.real) / whole,
    )


@pytest.mark.parametrize(("crank", "coupler"), [(1.0, 0.5), (2.2, 0.3), (-0.8, 1.1), (math.pi / 2, 0.6)])
def test_rates_of_a_linkage_that_closes(crank: float, coupler: float) -> None:
    scene, rates = linkage(crank, coupler)
    solution = solve(scene)
    found = [float(solution.answers[name].value) for name in ("w3", "w4", "a4")]
    assert found == pytest.approx(list(rates), rel=2e-3)
    assert "confirmed with numbers" in solution.to("text")


def test_one_that_does_not_close_is_refused() -> None:
    scene, _ = linkage(1.0, 0.5)
    with pytest.raises(Unsolvable, match=r"do not close at `now`: the points that `C` joins would be 0\.03"):
        solve(scene.replace("d: 45 cm", "d: 48 cm"))


def test_a_place_of_what_is_linked_to_no_other_says_nothing() -> None:
    with pytest.raises(SceneError, match="says nothing here"):
        solve(
            "title: t\nbodies: {rod: {shape: rod, mass: 1 kg, length: 1 m}}\nconnections: {pin: {hinge: rod.start, at: [1 m, 0]}}\n"
            "states: {now: {rod.angle: 0, at rest: all}}\nfind: {x: rod.angular_acceleration}\n"
        )
