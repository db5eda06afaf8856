"""The assembly at one instant, held against what is found by hand for systems of one to three bodies."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

from rotsolve.confirm.instant import Dynamics, moment, placed
from rotsolve.confirm.model import Model
from rotsolve.motion.complete import configured
from rotsolve.scene.read import read_source

G = 9.8


def at_start(text: str, state: str = "") -> tuple[Model, Dynamics]:
    """The assembly of a scene at a state, its first where none is named."""
    problem = configured(read_source("title: by hand\n" + text + "\nfind: {t: 1 s}\n")).problem
    model = Model(problem, {}, state or (problem.states[0].name if problem.states else ""))
    at = placed(model)
    assert at.clash == 0.0
    found = moment(model, at)
    assert found.clash == 0.0
    return model, found


Wanted = Callable[[Model, Dynamics], list[tuple[float, float]]]


def rate(model: Model, found: Dynamics, name: str, axis: int) -> float:
    index = model.seats[name].first + axis
    assert index not in found.open_rates
    return found.rates[index]


def test_atwood_with_a_heavy_pulley() -> None:
    """a = (M − m) g/(M + m + ½ K), a tension on either side, the axle carries all."""
    model, found = at_start(
        """
given: {m: 2 kg, M: 3 kg, K: 4 kg, R: 10 cm}
bodies: {left: {mass: m, moves: up}, right: {mass: M, moves: down}, pulley: {shape: disc, mass: K, radius: R}}
connections: {pin: {axle: pulley}, cord: {string: [left, pulley, right]}}"""
    )
    a = G / 7
    assert rate(model, found, "left", 1) == pytest.approx(a)
    assert rate(model, found, "right", 1) == pytest.approx(-a)
    assert rate(model, found, "pulley", 2) == pytest.approx(-a / 0.1)
    assert found.reactions["cord", "tension0"] == pytest.approx(2 * (G + a))
    assert found.reactions["cord", "tension1"] == pytest.approx(3 * (G - a))
    assert found.reactions["pin", "y"] == pytest.approx(4 * G + 2 * (G + a) + 3 * (G - a))


def test_a_rod_let_go_from_a_slant() -> None:
    """α = −3 g cos θ/(2 L); the hinge holds what the centre of mass does not fall."""
    model, found = at_start(
        """
given: {M: 2 kg, L: 1.5 m}
bodies: {rod: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: rod.start}}
states: {start: {rod.angle: 30 deg, at rest: all}}"""
    )
    alpha = -1.5 * G * math.cos(math.radians(30)) / 1.5
    assert rate(model, found, "rod", 2) == pytest.approx(alpha)
    across = alpha * 0.75
    assert found.reactions["pin", "x"] == pytest.approx(2 * -across * math.sin(math.radians(30)))
    assert found.reactions["pin", "y"] == pytest.approx(2 * (across * math.cos(math.radians(30)) + G))


@pytest.mark.parametrize(("share", "friction", "slips"), [(0.5, 0.3, False), (0.5, 0.1, True), (1.0, 0.2, True)])
def test_rolling_and_slipping_down_an_incline(share: float, friction: float, slips: bool) -> None:
    """a = g sin β/(1 + I/(m R²)), or g (sin β − μ cos β) where friction is not enough."""
    beta = math.radians(35)
    model, found = at_start(
        f"""
given: {{m: 2 kg, R: 20 cm}}
surfaces: {{ramp: {{slope: 35 deg, down: left}}}}
bodies: {{wheel: {{inertia: {share}*m*R^2, mass: m, radius: R}}}}
connections: {{touch: {{contact: [wheel, ramp], friction: {friction}}}}}
states: {{start: at rest}}"""
    )
    a = G * (math.sin(beta) - friction * math.cos(beta)) if slips else G * math.sin(beta) / (1 + share)
    assert rate(model, found, "wheel", 0) == pytest.approx(-a * math.cos(beta))
    assert found.reactions["touch", "normal"] == pytest.approx(2 * G * math.cos(beta))
    assert (found.modes["touch"] != "sticks") == slips


def test_a_ladder_that_slides_between_floor_and_wall() -> None:
    """θ̈ = −(3 g/2 L) cos θ from rest, without friction."""
    model, found = at_start(
        """
given: {M: 3 kg, L: 2 m}
surfaces: {floor: level, side: {wall: left}}
bodies: {ladder: {shape: rod, mass: M, length: L}}
connections: {foot: {contact: [ladder.start, floor]}, head: {contact: [ladder.end, side]}}
states: {start: {ladder.angle: 120 deg, at rest: all}}"""
    )
    alpha = -1.5 * G / 2 * math.cos(math.radians(120))
    assert rate(model, found, "ladder", 2) == pytest.approx(alpha)
    assert found.reactions["foot", "normal"] == pytest.approx(3 * (G + alpha * math.cos(math.radians(120))))
    assert found.reactions["head", "normal"] == pytest.approx(3 * alpha * math.sin(math.radians(120)))
