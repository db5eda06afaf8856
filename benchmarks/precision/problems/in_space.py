"""Bodies in space, in the variables that suit integrators best: no angles where vectors do, nothing that is not asked for."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from ..peers.engines import MUJOCO_IN_SPACE
from ..peers.integrators import INTEGRATORS
from ..peers.kane import KANE
from ..problem import Kane, Mathematics, Motion, Problem, Rates, State, TurnedModel

VECTORS = {name: way for name, way in INTEGRATORS.items() if not name.startswith("sympy")}
FAST = {name: way for name, way in VECTORS.items() if not name.startswith("mpmath")}
DERIVED = KANE | MUJOCO_IN_SPACE  # in coordinates of their own
WEIGHT = "0.098"  # M g l of the top, N m
ACROSS, ALONG, AXIAL = "6e-4", "8e-5", "400"  # its moments of inertia in kg m², its ω₃ in rad/s
PLANAR = "pymunk is planar"
BALL = """
<mujoco>
  <option timestep="{{step}}" integrator="RK4" gravity="0 0 -9.8"><flag contact="disable" gravity="{gravity}"/></option>
  <worldbody>
    <body>
      <joint type="ball"/>
      <inertial pos="0 0 {height}" mass="{mass}" diaginertia="{inertia}"/>
    </body>
  </worldbody>
</mujoco>"""


def book_rates(maths: Mathematics) -> Rates:
    """Euler's equations for I, 2 I, 3 I, and u̇ = u × ω of a direction that stays in space."""

    def at(time: Any, state: State) -> list[Any]:
        a, b, c, u, v, w = state
        return [-b * c, c * a, -a * b / 3, v * c - w * b, w * a - u * c, u * b - v * a]

    return at


def book_energy(state: State) -> float:
    """Σ n ωₙ²/2, in units of I."""
    a, b, c = (float(value) for value in state[:3])
    return (a * a + 2 * b * b + 3 * c * c) / 2


def book_for_kane(rates: tuple[str, str, str]) -> Callable[[Any, Any], Kane]:
    """By a quaternion; q̇ = ½ q ω is said of ω along the body's axes, which stand for the speeds."""

    def build(sympy: Any, mechanics: Any) -> Kane:
        w, x, y, z = q = list(mechanics.dynamicsymbols("q:4"))
        a, b, c = u = list(mechanics.dynamicsymbols("u:3"))
        space = mechanics.ReferenceFrame("N")
        body = space.orientnew("B", "Quaternion", q)
        body.set_ang_vel(space, a * body.x + b * body.y + c * body.z)
        doubled = (-x * a - y * b - z * c, w * a + y * c - z * b, w * b + z * a - x * c, w * c + x * b - y * a)
        kinematics = [place.diff() - rate / 2 for place, rate in zip(q, doubled, strict=True)]
        centre = mechanics.Point("C")
        centre.set_vel(space, 0)
        inertia = mechanics.inertia(body, 1, 2, 3)
        thrown = mechanics.RigidBody("book", centre, body, sympy.Integer(1), (inertia, centre))
        asked = [*u, *(space.x.dot(axis) for axis in (body.x, body.y, body.z))]
        return Kane(space, q, u, kinematics, [thrown], [], [1.0, 0.0, 0.0, 0.0, *map(float, rates)], asked)

    return build


def book_for_mujoco(rates: tuple[str, str, str]) -> TurnedModel:
    """On a ball joint in its middle: a free joint would follow a centre that rests."""
    xml = BALL.format(gravity="disable", height="0", mass="1", inertia="1e-3 2e-3 3e-3")
    wx, wy, wz = map(float, rates)
    return TurnedModel(xml, (1.0, 0.0, 0.0, 0.0), (wx, wy, wz), lambda rotation, turning: [*turning, *rotation[0]])


def book(name: str, title: str, rates: tuple[str, str, str], until: str) -> Problem:
    """A book spun so, asked for its angular velocity and for the direction of x as it sees it."""

    def start(maths: Mathematics) -> list[Any]:
        return [*map(maths.number, rates), *map(maths.number, ("1", "0", "0"))]

    return Problem(
        name=name,
        title=title,
        scene="benchmarks/scenes/thrown-book.yaml",
        asks=(
            *(f"book.angular_velocity.{axis} in body axes" for axis in "xyz"),
            *(f"book.{axis}_axis.x" for axis in "xyz"),
        ),
        unit="rad/s, 1",
        peers=VECTORS | DERIVED,
        sets=tuple(f"w{axis}={rate} rad/s" for axis, rate in zip("xyz", rates, strict=True)),
        motion=Motion(
            start,
            book_rates,
            lambda state, pi: list(state),
            kane=book_for_kane(rates),
            turned=book_for_mujoco(rates),
        ),
        until=until,
        simulated=True,
        left_out=PLANAR,
        energy=book_energy,
    )


def top_start(maths: Mathematics) -> list[Any]:
    """The direction n of the axis, 20° from upright, and L = I₃ ω₃ n."""
    tilt = maths.pi / 9
    axis = [maths.number("0"), -maths.sin(tilt), maths.cos(tilt)]
    spin = maths.number(ALONG) * maths.number(AXIAL)
    return [*axis, *(spin * part for part in axis)]


def top_rates(maths: Mathematics) -> Rates:
    """ṅ = L × n/I₁, L̇ = M g l (−n_y, n_x, 0)."""
    across, weight = maths.number(ACROSS), maths.number(WEIGHT)

    def at(time: Any, state: State) -> list[Any]:
        x, y, z, a, b, c = state
        return [
            *((b * z - c * y) / across, (c * x - a * z) / across, (a * y - b * x) / across),
            *(-weight * y, weight * x, 0 * x),
        ]

    return at


def top_for_kane(sympy: Any, mechanics: Any) -> Kane:
    """By Euler angles φ, θ, ψ, their rates for speeds, and I seen from the node axes, which do not spin with the top."""
    phi, theta, psi = q = list(mechanics.dynamicsymbols("q:3"))
    u = list(mechanics.dynamicsymbols("u:3"))
    space, tip = mechanics.ReferenceFrame("N"), mechanics.Point("O")
    heading = space.orientnew("A", "Axis", [phi, space.z])
    nodes = heading.orientnew("B", "Axis", [theta, heading.x])
    nodes.set_ang_vel(space, u[1] * nodes.x + u[0] * heading.z)
    body = nodes.orientnew("C", "Axis", [psi, nodes.z])
    body.set_ang_vel(space, u[1] * nodes.x + u[0] * heading.z + u[2] * nodes.z)
    tip.set_vel(space, 0)
    centre = tip.locatenew("G", sympy.Rational(1, 20) * nodes.z)
    centre.v2pt_theory(tip, space, body)
    across, along = sympy.Rational(ACROSS) - sympy.Rational(1, 2000), sympy.Rational(ALONG)
    inertia = mechanics.inertia(nodes, across, across, along)
    top = mechanics.RigidBody("top", centre, body, sympy.Rational(1, 5), (inertia, centre))
    momentum = top.angular_momentum(tip, space)
    asked = [
        *(nodes.z.dot(axis) for axis in (space.x, space.y, space.z)),
        *(momentum.dot(axis) for axis in (space.x, space.y)),
    ]
    kinematics = [place.diff() - speed for place, speed in zip(q, u, strict=True)]
    loads = [(centre, -sympy.Rational(49, 25) * space.z)]
    return Kane(space, q, u, kinematics, [top], loads, [0.0, math.pi / 9, 0.0, 0.0, 0.0, float(AXIAL)], asked)


def top_from_mujoco(rotation: list[list[float]], turning: list[float]) -> list[float]:
    """Its axis, and L = R I ω of two axes."""
    moments = (float(ACROSS), float(ACROSS), float(ALONG))
    own = [moment * rate for moment, rate in zip(moments, turning, strict=True)]
    level = [sum(entry * part for entry, part in zip(row, own, strict=True)) for row in rotation[:2]]
    return [*(row[2] for row in rotation), *level]


TOP_FOR_MUJOCO = TurnedModel(
    BALL.format(gravity="enable", height="0.05", mass="0.2", inertia="1e-4 1e-4 8e-5"),
    (math.cos(math.pi / 18), math.sin(math.pi / 18), 0.0, 0.0),
    (0.0, 0.0, float(AXIAL)),
    top_from_mujoco,
)
BOOK = book("free-asymmetric-book", "A free asymmetric body, after 20 s", ("1", "2", "3"), "20")
MIDDLE = book(
    "book-1e-10-off-its-middle-axis",
    "A body spun 10⁻¹⁰ off its middle axis, after 20 s",
    ("0.0000000005", "5", "0"),
    "20",
)
HEAVY_TOP = Problem(
    name="heavy-top",
    title="A heavy top with nutation, after 10 s",
    scene="benchmarks/scenes/heavy-top.yaml",
    asks=(*(f"top.z_axis.{axis}" for axis in "xyz"), "top.angular_momentum.x", "top.angular_momentum.y"),
    unit="1, kg m²/s",
    peers=FAST | DERIVED,
    motion=Motion(top_start, top_rates, lambda state, pi: list(state[:5]), kane=top_for_kane, turned=TOP_FOR_MUJOCO),
    until="10",
    simulated=True,
    left_out=f"mpmath's odefun would take minutes; {PLANAR}",
)
