"""What the laws say of bodies hinged at points of rims, held against the assembly: such a point turns with its body."""

from __future__ import annotations

import pytest

from rotsolve.confirm.instant import moment, placed
from rotsolve.confirm.model import Model
from rotsolve.motion.complete import configured
from rotsolve.pipeline import solve
from rotsolve.scene.read import read_source

SCENE = """
title: joint at a rim
given: {{M: 3 kg, m: 2 kg, R: 50 cm, r: 30 cm}}
surfaces: {{ramp: {{slope: 30 deg, down: right}}}}
bodies:
  one: {{shape: disc, mass: M, radius: R{moves}}}
  two: {{shape: disc, mass: m, radius: r}}
connections: {{hold: {{{hold}}}, joint: {{hinge: [one.{one}, two.{two}]}}}}
states: {{start: {{{lines}}}}}
find: {{a: one.angular_acceleration at start, b: two.angular_acceleration at start, X: joint.force.x at start}}
"""
HOLDS = {
    "rolls": ("rolls: [one, ramp]", ", moves: down", "two.angle: 20 deg, at rest: all"),
    "axle": ("axle: one", "", "two.angle: 20 deg, one.angular_velocity: 2 rad/s, two.angular_velocity: -3 rad/s"),
    "hinge": (
        "hinge: one.top",
        "",
        "one.angle: -50 deg, two.angle: 20 deg, one.angular_velocity: 2 rad/s, two.angular_velocity: 4 rad/s",
    ),
}
PLACES = [("bottom", "top"), ("rim", "rim"), ("top", "bottom"), ("center", "rim")]


@pytest.mark.parametrize("held", HOLDS)
@pytest.mark.parametrize(("one", "two"), PLACES)
def test_joints_at_rims(held: str, one: str, two: str) -> None:
    hold, moves, lines = HOLDS[held]
    text = SCENE.format(hold=hold, moves=moves, lines=lines, one=one, two=two)
    answers = {answer.name: answer.value.float for answer in solve(text).derivation.answers if answer.value is not None}
    model = Model(configured(read_source(text)).problem, {}, "start")
    found = moment(model, placed(model))
    turning = {
        name: found.rates[model.seats[body].turn] * model.sense(body) for name, body in (("a", "one"), ("b", "two"))
    }
    for name, value in (*turning.items(), ("X", found.reactions["joint", "x"])):
        assert answers[name] == pytest.approx(value, rel=1e-9, abs=1e-9)
