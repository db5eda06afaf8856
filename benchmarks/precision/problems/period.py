"""The period of a pendulum, a bob of 1 kg on a light rod of 1 m: φ̈ = (g/L) sin φ, φ from upright, g = 9.8 m/s²."""

from __future__ import annotations

import math
from typing import Any

from ..peers.periods import PERIODS
from ..problem import Mathematics, Motion, MujocoModel, Problem, PymunkModel, Rates, State
from .rod import falling, leave

MODEL = """
<mujoco>
  <option timestep="{step}" integrator="RK4" gravity="0 0 -9.8"><flag contact="disable"/></option>
  <worldbody>
    <body>
      <joint type="hinge" axis="0 1 0"/>
      <inertial pos="0 0 1" mass="1" diaginertia="1e-12 1e-12 1e-12"/>
    </body>
  </worldbody>
</mujoco>"""


def rates(maths: Mathematics) -> Rates:
    """φ̈ = (g/L) sin φ."""
    return falling(maths, "9.8")


def read(state: State, pi: Any) -> list[Any]:
    """No state is asked: the period is found by its peers."""
    return list(state)


def lagrangian(sympy: Any, places: Any, speeds: Any) -> Any:
    """½ m L² φ̇² − m g L cos φ."""
    return speeds[0] ** 2 / 2 - sympy.Rational(98, 10) * sympy.cos(places[0])


def build(pymunk: Any, space: Any, state: State) -> list[Any]:
    """The bob at φ, with next to no size."""
    bob = pymunk.Body(1, 1e-12)
    bob.angle, bob.position = -state[0], (math.sin(state[0]), math.cos(state[0]))
    space.add(bob, pymunk.PivotJoint(space.static_body, bob, (0, 0), (0, -1)))
    return [bob]


def period(theta: str, from_upright: str) -> Problem:
    """The period from rest at θ degrees from hanging, 180° − θ from upright."""

    def start(maths: Mathematics) -> list[Any]:
        return [maths.number(from_upright) * maths.pi / 180, maths.number("0")]

    return Problem(
        name=f"period-from-{theta}-degrees",
        title=f"The period of a pendulum let go at {theta}°",
        scene="benchmarks/scenes/pendulum.yaml",
        asks=("T",),
        unit="s",
        peers=PERIODS,
        sets=(f"theta={theta} deg",),
        motion=Motion(start, rates, read, lagrangian, MujocoModel(MODEL, list, list), PymunkModel(build, leave)),
    )


PERIOD_60 = period("60", "120")
PERIOD_170 = period("170", "10")
PERIOD_179 = period("179.9999", "0.0001")
