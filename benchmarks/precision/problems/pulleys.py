"""Two pulleys on which floats lose digits: nearly equal masses, and masses of a ratio of 10¹²."""

from __future__ import annotations

from typing import Any

from ..peers.engines import MUJOCO
from ..peers.integrators import INTEGRATORS
from ..peers.linear import LINEAR
from ..problem import Mathematics, Motion, MujocoModel, Problem, Rates, State, Way

LIGHT, HEAVY = "1", "1.000000000001"  # kg, on a disc of 2 kg and 0.2 m
ATWOOD_MODEL = f"""
<mujoco>
  <option timestep="{{step}}" integrator="RK4" gravity="0 0 -9.8"><flag contact="disable"/></option>
  <default><equality solref="{{step}} 1" solimp="0.9999 0.9999 0.001 0.5 2"/></default>
  <worldbody>
    <body>
      <joint name="right" type="slide" axis="0 0 -1"/>
      <inertial pos="0 0 0" mass="{HEAVY}" diaginertia="1 1 1"/>
    </body>
    <body>
      <joint name="left" type="slide" axis="0 0 1"/>
      <inertial pos="0 0 0" mass="{LIGHT}" diaginertia="1 1 1"/>
    </body>
    <body>
      <joint name="pulley" type="hinge" axis="0 1 0"/>
      <inertial pos="0 0 0" mass="2" diaginertia="0.02 0.04 0.02"/>
    </body>
  </worldbody>
  <equality>
    <joint joint1="right" joint2="pulley" polycoef="0 0.2 0 0 0"/>
    <joint joint1="left" joint2="pulley" polycoef="0 0.2 0 0 0"/>
  </equality>
</mujoco>"""


def start(maths: Mathematics) -> list[Any]:
    """At rest."""
    return [maths.number("0"), maths.number("0")]


def atwood_rates(maths: Mathematics) -> Rates:
    """x′ = v, v′ = (m₂ − m₁) g/(m₁ + m₂ + M/2)."""
    light, heavy, gravity = maths.number(LIGHT), maths.number(HEAVY), maths.number("9.8")
    acceleration = (heavy - light) * gravity / (light + heavy + 1)
    return lambda time, state: [state[1], acceleration]


def read(state: State, pi: Any) -> list[Any]:
    """How far the heavier block fell."""
    return [state[0]]


def lagrangian(sympy: Any, places: Any, speeds: Any) -> Any:
    """½ (m₁ + m₂ + M/2) v² + (m₂ − m₁) g x."""
    light, heavy = sympy.Rational(LIGHT), sympy.Rational(HEAVY)
    return (light + heavy + 1) * speeds[0] ** 2 / 2 + (heavy - light) * sympy.Rational(98, 10) * places[0]


def fewer(way: Way) -> Way:
    """Every other setting of a way with many: here they say the same."""
    return way._replace(settings=way.settings[::2]) if len(way.settings) > 2 else way


NEARLY_EQUAL = Problem(
    name="nearly-equal-masses",
    title="An Atwood machine whose masses differ by a part in 10¹²: the way after 10 s",
    scene="benchmarks/scenes/nearly-equal-masses.yaml",
    asks=("x",),
    unit="m",
    peers={name: fewer(way) for name, way in (INTEGRATORS | MUJOCO).items()},
    motion=Motion(
        start,
        atwood_rates,
        read,
        lagrangian,
        MujocoModel(ATWOOD_MODEL, lambda y: [y[0], y[0], 5 * y[0]], lambda q: [q[0]]),
    ),
    until="10",
    left_out="pymunk has no string over a pulley",
)
MASS_RATIO = Problem(
    name="mass-ratio-1e12",
    title="A block that hangs from a disc of a 10¹²th of its mass: the tension",
    scene="benchmarks/scenes/heavy-block.yaml",
    asks=("T",),
    unit="N",
    peers=LINEAR,
    left_out="nothing to integrate is asked, and pymunk has no string",
)
