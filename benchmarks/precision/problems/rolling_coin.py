"""A coin that rolls without slipping on a level table and nods: m = 10 g, R = 2 cm, from its Euler angles and their rates."""

from __future__ import annotations

import math
from typing import Any

from ..peers.engines import MUJOCO_IN_SPACE
from ..peers.integrators import INTEGRATORS
from ..peers.kane import KANE
from ..problem import Kane, Mathematics, Motion, Problem, Rates, State, TurnedModel

STIFFNESS = "490"  # g/R
PRECESSION, AXIAL = "5", "-27.5"  # rad/s at a tilt of 60°: ω₃ = ψ̇ + φ̇ cos θ, ψ̇ = −30 rad/s
MODEL = """
<mujoco>
  <option timestep="{step}" integrator="RK4" cone="elliptic" impratio="100" gravity="0 0 -9.8"/>
  <default><geom friction="1 0 0" condim="3" solref="{step} 1" solimp="0.9999 0.9999 0.001 0.5 2"/></default>
  <worldbody>
    <geom type="plane" size="1 1 0.1"/>
    <body>
      <freejoint/>
      <geom type="cylinder" size="0.02 1e-5" mass="0"/>
      <inertial pos="0 0 0" mass="0.01" diaginertia="1e-6 1e-6 2e-6"/>
    </body>
  </worldbody>
</mujoco>"""


def start(maths: Mathematics) -> list[Any]:
    """θ, θ̇, φ̇ and ω₃."""
    return [maths.pi / 3, *map(maths.number, ("0", PRECESSION, AXIAL))]


def rates(maths: Mathematics) -> Rates:
    """5/4 θ̈ = (¼ φ̇ cos θ − 3/2 ω₃) φ̇ sin θ − (g/R) cos θ, φ̈ sin θ = 2 θ̇ (ω₃ − φ̇ cos θ), 3/2 ω̇₃ = φ̇ θ̇ sin θ."""
    stiffness, sin, cos = maths.number(STIFFNESS), maths.sin, maths.cos

    def at(time: Any, state: State) -> list[Any]:
        theta, nodding, round_, axial = state
        sine, cosine = sin(theta), cos(theta)
        return [
            nodding,
            (round_ * sine * (round_ * cosine - 6 * axial) - 4 * stiffness * cosine) / 5,
            2 * nodding * (axial - round_ * cosine) / sine,
            2 * round_ * sine * nodding / 3,
        ]

    return at


def energy(state: State) -> float:
    """Energy in units of m g R: (5 θ̇² + φ̇² sin² θ + 6 ω₃²) R/(8 g) + sin θ."""
    theta, nodding, round_, axial = (float(value) for value in state)
    sine = math.sin(theta)
    motion = (5 * nodding**2 + (round_ * sine) ** 2 + 6 * axial**2) / 8
    return motion / float(STIFFNESS) + sine


def for_kane(sympy: Any, mechanics: Any) -> Kane:
    """As the rolling disc of sympy's documentation: θ̇, φ̇ and ω₃ for speeds, the lowest point at rest, no constraint."""
    phi, theta, psi = q = list(mechanics.dynamicsymbols("q:3"))
    nodding, round_, axial = u = list(mechanics.dynamicsymbols("u:3"))
    space, touched = mechanics.ReferenceFrame("N"), mechanics.Point("T")
    heading = space.orientnew("A", "Axis", [phi, space.z])
    nodes = heading.orientnew("B", "Axis", [theta, heading.x])
    body = nodes.orientnew("C", "Axis", [psi, nodes.z])
    nodes.set_ang_vel(space, nodding * nodes.x + round_ * heading.z)
    body.set_ang_vel(space, nodding * nodes.x + round_ * sympy.sin(theta) * nodes.y + axial * nodes.z)
    touched.set_vel(space, 0)
    centre = touched.locatenew("G", sympy.Rational(1, 50) * nodes.y)
    centre.v2pt_theory(touched, space, body)
    mass, across = sympy.Rational(1, 100), sympy.Rational(1, 10**6)
    inertia = (mechanics.inertia(nodes, across, across, 2 * across), centre)
    coin = mechanics.RigidBody("coin", centre, body, mass, inertia)
    kinematics = [phi.diff() - round_, theta.diff() - nodding, psi.diff() - axial + round_ * sympy.cos(theta)]
    loads = [(centre, -sympy.Rational(98, 10) * mass * space.z)]
    first = [0.0, math.pi / 3, 0.0, 0.0, float(PRECESSION), float(AXIAL)]
    return Kane(space, q, u, kinematics, [coin], loads, first, [theta, nodding, round_, axial])


def from_mujoco(rotation: list[list[float]], turning: list[float]) -> list[float]:
    """θ, θ̇, φ̇ and ω₃ from the axis (x, y, z), and from ω in space, whose level part along the line of nodes is θ̇."""
    x, y, z = (row[2] for row in rotation)
    level = math.hypot(x, y)
    wx, wy, wz = (sum(entry * part for entry, part in zip(row, turning, strict=True)) for row in rotation)
    axial = turning[2]
    return [math.atan2(level, z), (x * wy - y * wx) / level, (wz - axial * z) / level**2, axial]


COIN = Problem(
    name="rolling-coin",
    title="A coin that rolls on a table and nods, after 5 s",
    scene="benchmarks/scenes/rolling-coin.yaml",
    asks=("coin.tilt", "coin.nutation", "coin.precession", "coin.axial_rate"),
    unit="rad, rad/s",
    peers={name: way for name, way in INTEGRATORS.items() if not name.startswith("sympy")} | KANE | MUJOCO_IN_SPACE,
    motion=Motion(
        start,
        rates,
        lambda state, pi: list(state),
        kane=for_kane,
        turned=TurnedModel(
            MODEL,
            (0.0, 0.0, 0.02 * math.sin(math.pi / 3), math.cos(math.pi / 6), math.sin(math.pi / 6), 0.0, 0.0),
            # The centre moves by ω × R e₂, e₂ being up the coin; along its own axes it turns by (0, φ̇ sin θ, ω₃).
            (0.55, 0.0, 0.0, 0.0, float(PRECESSION) * math.sin(math.pi / 3), float(AXIAL)),
            from_mujoco,
        ),
    ),
    until="5",
    simulated=True,
    left_out="pymunk is planar; what MuJoCo has instead of a rolling contact is a soft one with friction, and a thin cylinder",
    energy=energy,
)
