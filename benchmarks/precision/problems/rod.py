"""A rod on a hinge, let go from rest: φ̈ = 3 g/(2 L) sin φ, φ from upright, with L = 1 m and g = 9.8 m/s²."""

from __future__ import annotations

import math
from typing import Any

from ..peers.engines import ENGINES
from ..peers.integrators import INTEGRATORS
from ..problem import Mathematics, Motion, MujocoModel, Problem, PymunkModel, Rates, State

STIFFNESS = "14.7"  # 3 g/(2 L)
MODEL = """
<mujoco>
  <option timestep="{step}" integrator="RK4" gravity="0 0 -9.8"><flag contact="disable"/></option>
  <worldbody>
    <body>
      <joint type="hinge" axis="0 1 0"/>
      <inertial pos="0 0 0.5" mass="1" diaginertia="0.08333333333333333 0.08333333333333333 1e-9"/>
    </body>
  </worldbody>
</mujoco>"""


def falling(maths: Mathematics, stiffness: str) -> Rates:
    """φ′ = ω, ω′ = k sin φ."""
    k, sin = maths.number(stiffness), maths.sin
    return lambda time, state: [state[1], k * sin(state[0])]


def rates(maths: Mathematics) -> Rates:
    """φ̈ = 3 g/(2 L) sin φ."""
    return falling(maths, STIFFNESS)


def read(state: State, pi: Any) -> list[Any]:
    """The scene counts counterclockwise from the rightward horizontal, φ runs clockwise from upright."""
    return [pi / 2 - state[0], -state[1]]


def lagrangian(sympy: Any, places: Any, speeds: Any) -> Any:
    """½ (L²/3) φ̇² − g (L/2) cos φ, for 1 kg."""
    return speeds[0] ** 2 / 6 - sympy.Rational(49, 10) * sympy.cos(places[0])


def energy(state: State) -> float:
    """Energy in units of M g L: φ̇²/(6 g/L) + ½ sin(angle)."""
    angle, speed = (float(value) for value in state)
    return speed * speed / 58.8 + math.sin(angle) / 2


def build(pymunk: Any, space: Any, start: State) -> list[Any]:
    """The rod at φ; pymunk turns counterclockwise."""
    rod = pymunk.Body(1, 1 / 12)
    rod.angle, rod.position = -start[0], (math.sin(start[0]) / 2, math.cos(start[0]) / 2)
    space.add(rod, pymunk.PivotJoint(space.static_body, rod, (0, 0), (0, -0.5)))
    return [rod]


def leave(bodies: list[Any]) -> list[float]:
    """φ and φ̇ of the rod."""
    return [-bodies[0].angle, -bodies[0].angular_velocity]


def rod(name: str, title: str, delta: str, unit: str, until: str) -> Problem:
    """A rod let go at `delta` from upright, asked for at a time."""

    def start(maths: Mathematics) -> list[Any]:
        return [maths.number(delta) * (maths.pi / 180 if unit == "deg" else 1), maths.number("0")]

    return Problem(
        name=name,
        title=title,
        scene="benchmarks/scenes/rod-near-upright.yaml",
        asks=("rod.angle", "rod.angular_velocity"),
        unit="rad, rad/s",
        peers=INTEGRATORS | ENGINES,
        sets=(f"delta={delta} {unit}",),
        motion=Motion(start, rates, read, lagrangian, MujocoModel(MODEL, list, list), PymunkModel(build, leave)),
        until=until,
        simulated=True,
        energy=energy,
    )


ROD = rod("rod-from-179.99-degrees", "A rod let go at 179.99° from hanging, after 10 s", "0.01", "deg", "10")
UPRIGHT = rod("rod-1e-8-from-upright", "A rod let go 10⁻⁸ rad from upright, after 10 s", "0.00000001", "rad", "10")
LONG = rod("rod-for-2000-s", "A rod let go from the level, after 2000 s", "90", "deg", "2000")
# 200 times as long: without what would take minutes.
LONG = LONG._replace(
    peers={
        **{
            name: LONG.peers[name] for name in ("scipy RK45", "scipy DOP853", "scipy LSODA", "heyoka", "sympy + DOP853")
        },
        "scipy Radau": LONG.peers["scipy Radau"]._replace(settings=("1e-6",)),
        "MuJoCo RK4": LONG.peers["MuJoCo RK4"]._replace(settings=("1e-2", "1e-3")),
        "pymunk": LONG.peers["pymunk"]._replace(settings=("1e-2", "1e-3")),
    },
    left_out="mpmath's odefun would take minutes",
)
