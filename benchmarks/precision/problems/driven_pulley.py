"""A pulley with two blocks, driven to and fro on an axle that rubs: I ω̇ = A sin(w t) + W − c ω ∓ τ while it slips."""

from __future__ import annotations

from typing import Any

from ..peers.engines import ENGINES
from ..peers.sticking import STICKING
from ..problem import FLOATS, Mathematics, Motion, MujocoModel, Problem, PymunkModel, Rates, State, Sticking

# Units of kg, m, s. The disc of 2 kg and 0.2 m, and blocks of 1.2 and 1 kg: I = 0.04 + 2.2 × 0.04, W = (1 − 1.2) × 9.8 × 0.2.
INERTIA, WEIGHT, DRIVE, PACE, DRAG, RUBBING = "0.128", "-0.392", "2", "3", "0.1", "1.2"
MODEL = """
<mujoco>
  <option timestep="{step}" integrator="RK4" gravity="0 0 -9.8"><flag contact="disable"/></option>
  <default><equality solref="{step} 1" solimp="0.9999 0.9999 0.001 0.5 2"/></default>
  <worldbody>
    <body>
      <joint name="pulley" type="hinge" axis="0 1 0" frictionloss="1.2" damping="0.1" solreffriction="{step} 1"/>
      <inertial pos="0 0 0" mass="2" diaginertia="0.02 0.04 0.02"/>
    </body>
    <body>
      <joint name="left" type="slide" axis="0 0 1"/>
      <inertial pos="0 0 0" mass="1.2" diaginertia="1 1 1"/>
    </body>
    <body>
      <joint name="right" type="slide" axis="0 0 -1"/>
      <inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>
    </body>
  </worldbody>
  <equality>
    <joint joint1="left" joint2="pulley" polycoef="0 0.2 0 0 0"/>
    <joint joint1="right" joint2="pulley" polycoef="0 0.2 0 0 0"/>
  </equality>
  <actuator><motor joint="pulley"/></actuator>
</mujoco>"""


def start(maths: Mathematics) -> list[Any]:
    """At rest."""
    return [maths.number("0"), maths.number("0")]


def turning(maths: Mathematics) -> Any:
    """A sin(w t) + W, what turns the pulley besides what rubs."""
    drive, pace, weight, sin = maths.number(DRIVE), maths.number(PACE), maths.number(WEIGHT), maths.sin
    return lambda time: drive * sin(pace * time) + weight


def slipping(maths: Mathematics, sense: Any) -> Rates:
    """ω̇ = (A sin(w t) + W − c ω − s τ)/I, slipping clockwise (s = 1) or counterclockwise (s = −1)."""
    torque, drag, inertia = turning(maths), maths.number(DRAG), maths.number(INERTIA)
    rubbing = sense * maths.number(RUBBING)
    return lambda time, state: [state[1], (torque(time) - drag * state[1] - rubbing) / inertia]


def slipping_clockwise(maths: Mathematics) -> Rates:
    """The motion while it slips clockwise."""
    return slipping(maths, 1)


def leaving(maths: Mathematics, time: Any) -> int:
    """The sense of A sin(w t) + W where it is more than τ."""
    torque = turning(maths)(time)
    return 0 if abs(torque) <= maths.number(RUBBING) else 1 if torque > 0 else -1


def breakaway(maths: Mathematics, stuck: Any) -> tuple[Any, int]:
    """When A sin(w t) + W first reaches ±τ after it stuck, and the sense in which it then slips."""
    drive, pace, weight, rubbing = (maths.number(text) for text in (DRIVE, PACE, WEIGHT, RUBBING))
    turn = 2 * maths.pi
    forwards = maths.asin((rubbing - weight) / drive)
    backwards = maths.pi + maths.asin((rubbing + weight) / drive)
    return min(
        ((stuck + (angle - pace * stuck) % turn / pace, sense) for angle, sense in ((forwards, 1), (backwards, -1)))
    )


def read(state: State, pi: Any) -> list[Any]:
    """The scene counts angles counterclockwise, and the speed of the pulley in its own sense: clockwise."""
    return [-state[0], state[1]]


def lagrangian(sympy: Any, places: Any, speeds: Any) -> Any:
    """½ I ω² + W θ: the energies of the pulley and the blocks."""
    disc, left, right = sympy.Rational(1, 25), sympy.Rational(6, 5), 1
    height = sympy.Rational(1, 5) * places[0]
    kinetic = disc * speeds[0] ** 2 / 2 + (left + right) * (speeds[0] / 5) ** 2 / 2
    return kinetic - (left - right) * sympy.Rational(98, 10) * height


def couple(sympy: Any, time: Any, speed: Any, sense: Any) -> Any:
    """A sin(w t) − c ω − s τ."""
    return 2 * sympy.sin(3 * time) - speed / 10 - sense * sympy.Rational(6, 5)


def build(pymunk: Any, space: Any, state: State) -> list[Any]:
    """A body of the whole inertia on an axle: pymunk has no strings over pulleys. A motor at rest, of limited torque, rubs."""
    pulley = pymunk.Body(1, float(INERTIA))
    axle = pymunk.PivotJoint(space.static_body, pulley, (0, 0), (0, 0))
    brake = pymunk.SimpleMotor(space.static_body, pulley, 0)
    brake.max_force = float(RUBBING)
    space.add(pulley, axle, brake)
    return [pulley]


def push(bodies: list[Any], time: float) -> None:
    """The drive, the weight of the blocks and the drag."""
    bodies[0].torque = turning(FLOATS)(time) - float(DRAG) * bodies[0].angular_velocity


def leave(bodies: list[Any]) -> list[float]:
    """θ and ω."""
    return [bodies[0].angle, bodies[0].angular_velocity]


def drive(time: float) -> float:
    """What the motor of MuJoCo exerts: there the blocks have their own weight."""
    return float(turning(FLOATS)(time)) - float(WEIGHT)


DRIVEN_PULLEY = Problem(
    name="driven-pulley",
    title="A driven pulley that sticks and slips on its axle, after 10 s",
    scene="benchmarks/scenes/driven-pulley.yaml",
    asks=("pulley.angle", "pulley.angular_velocity"),
    unit="rad, rad/s",
    peers=STICKING | ENGINES,
    motion=Motion(
        start,
        slipping_clockwise,
        read,
        lagrangian,
        # The joints of the blocks count their own way: 0.2 m for each radian.
        MujocoModel(MODEL, lambda y: [y[0], y[0] / 5, y[0] / 5], lambda q: [q[0]], drive),
        PymunkModel(build, leave, push),
        Sticking(slipping, leaving, breakaway, couple),
    ),
    until="10",
    simulated=True,
)
