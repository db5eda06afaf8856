"""Two equal rods in a row, hinged, let go from the level: Lagrange's equations in the angles a, b from hanging, L = 1 m."""

from __future__ import annotations

import math
from typing import Any

from ..peers.engines import ENGINES
from ..peers.integrators import INTEGRATORS
from ..problem import Mathematics, Motion, MujocoModel, Problem, PymunkModel, Rates, State

MODEL = """
<mujoco>
  <option timestep="{step}" integrator="RK4" gravity="0 0 -9.8"><flag contact="disable"/></option>
  <worldbody>
    <body>
      <joint type="hinge" axis="0 -1 0"/>
      <inertial pos="0 0 -0.5" mass="1" diaginertia="0.08333333333333333 0.08333333333333333 1e-9"/>
      <body pos="0 0 -1">
        <joint type="hinge" axis="0 -1 0"/>
        <inertial pos="0 0 -0.5" mass="1" diaginertia="0.08333333333333333 0.08333333333333333 1e-9"/>
      </body>
    </body>
  </worldbody>
</mujoco>"""


def start(maths: Mathematics) -> list[Any]:
    """Both level, at rest."""
    return [maths.pi / 2, maths.pi / 2, maths.number("0"), maths.number("0")]


def rates(maths: Mathematics) -> Rates:
    """4/3 ä + ½ c b̈ = −½ s ḃ² − 3/2 g sin a,  ½ c ä + 1/3 b̈ = ½ s ȧ² − ½ g sin b;  c, s of a − b, solved for ä and b̈."""
    gravity, sin, cos = maths.number("9.8"), maths.sin, maths.cos

    def at(time: Any, state: State) -> list[Any]:
        upper, lower, fast, faster = state
        sine, cosine = sin(upper - lower), cos(upper - lower)
        on_upper = -(sine * faster * faster) / 2 - 3 * gravity * sin(upper) / 2
        on_lower = sine * fast * fast / 2 - gravity * sin(lower) / 2
        whole = 16 - 9 * cosine * cosine  # 36 × the determinant
        return [
            fast,
            faster,
            (12 * on_upper - 18 * cosine * on_lower) / whole,
            (48 * on_lower - 18 * cosine * on_upper) / whole,
        ]

    return at


def read(state: State, pi: Any) -> list[Any]:
    """The scene counts angles from the rightward horizontal, a and b are from hanging: both counterclockwise."""
    return [state[0] - pi / 2, state[1] - pi / 2, state[2], state[3]]


def lagrangian(sympy: Any, places: Any, speeds: Any) -> Any:
    """⅔ ȧ² + 1/6 ḃ² + ½ ȧ ḃ cos(a − b) + g (3/2 cos a + ½ cos b), for 1 kg each."""
    (upper, lower), (fast, faster) = places, speeds
    kinetic = 2 * fast**2 / 3 + faster**2 / 6 + fast * faster * sympy.cos(upper - lower) / 2
    return kinetic + sympy.Rational(98, 10) * (3 * sympy.cos(upper) + sympy.cos(lower)) / 2


def energy(state: State) -> float:
    """Energy in units of M g L, of the angles from the horizontal."""
    upper, lower, fast, faster = (float(value) for value in state)
    kinetic = 2 * fast**2 / 3 + faster**2 / 6 + fast * faster * math.cos(upper - lower) / 2
    return kinetic / 9.8 + (3 * math.sin(upper) + math.sin(lower)) / 2


def build(pymunk: Any, space: Any, state: State) -> list[Any]:
    """The rods at a and b, each hinged at its upper end."""
    bodies, joint, holder, hook = [], (0.0, 0.0), space.static_body, (0.0, 0.0)
    for angle in state[:2]:
        down = (math.sin(angle), -math.cos(angle))
        rod = pymunk.Body(1, 1 / 12)
        rod.angle, rod.position = angle, (joint[0] + down[0] / 2, joint[1] + down[1] / 2)
        space.add(rod, pymunk.PivotJoint(holder, rod, hook, (0, 0.5)))
        bodies.append(rod)
        joint, holder, hook = (joint[0] + down[0], joint[1] + down[1]), rod, (0.0, -0.5)
    return bodies


def leave(bodies: list[Any]) -> list[float]:
    """a, b, ȧ and ḃ."""
    return [*(body.angle for body in bodies), *(body.angular_velocity for body in bodies)]


TWO_RODS = Problem(
    name="two-hinged-rods",
    title="Two hinged rods let go from the level, after 10 s",
    scene="benchmarks/scenes/two-rods.yaml",
    asks=("upper.angle", "lower.angle", "upper.angular_velocity", "lower.angular_velocity"),
    unit="rad, rad/s",
    peers=INTEGRATORS | ENGINES,
    motion=Motion(
        start,
        rates,
        read,
        lagrangian,
        # The second joint of MuJoCo counts from the first rod.
        MujocoModel(MODEL, lambda y: [y[0], y[1] - y[0]], lambda q: [q[0], q[0] + q[1]]),
        PymunkModel(build, leave),
    ),
    until="10",
    simulated=True,
    energy=energy,
)
