"""Machines: the scenes that all solvers are given, as a page of text and, for Kane's and Lagrange's methods, as what moves how."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

Places = Callable[[Any, Any], list[Any]]  # from coordinates q and letters s, as s["R"]


class Machine(NamedTuple):
    """A scene; the heights of its masses and the angles of its wheels, each by its letter, as functions of so many coordinates.

    The first coordinate is the way of the body that is called left or block. `along` are the ways of masses that do not move upright.
    """

    name: str
    scene: str
    coordinates: int
    masses: tuple[str, ...]
    heights: Places
    wheels: tuple[str, ...]
    angles: Places
    along: Places | None = None


ATWOOD = """\
given: {m1: 2 kg, m2: 3 kg, I1: 1 kg m^2, R: 10 cm}
bodies: {left: {mass: m1, moves: up}, wheel: {inertia: I1, radius: R}, right: {mass: m2, moves: down}}
connections: {axle: {axle: wheel}, rope: {string: [left, wheel, right]}}
find: {a: left.acceleration, b: right.acceleration, alpha: wheel.angular_acceleration, S: rope.left.tension, T: rope.right.tension}
"""
INCLINE = """\
given: {m1: 2 kg, m2: 3 kg, I1: 1 kg m^2, R: 10 cm, beta: 30 deg}
surfaces: {ramp: {slope: beta}}
bodies: {block: {mass: m1, moves: up}, wheel: {inertia: I1, radius: R}, load: {mass: m2, moves: down}}
connections: {lies: {contact: [block, ramp], friction: none}, axle: {axle: wheel}, rope: {string: [block, wheel, load]}}
find:
  a: block.acceleration
  b: load.acceleration
  alpha: wheel.angular_acceleration
  S: rope.block.tension
  T: rope.load.tension
  N: lies.normal_force
"""
DOUBLE = """\
given: {m1: 2 kg, m2: 3 kg, m3: 1 kg, M: 2 kg, I1: 1 kg m^2, I2: 1/2 kg m^2, R: 10 cm}
bodies:
  left: {mass: m1, moves: up}
  wheel: {inertia: I1, radius: R}
  hanging: {mass: M, inertia: I2, radius: R, moves: down}
  one: {mass: m2, moves: down}
  two: {mass: m3, moves: down}
connections: {axle: {axle: wheel}, rope: {string: [left, wheel, hanging.center]}, cord: {string: [one, hanging, two]}}
find:
  a: left.acceleration
  b: one.acceleration
  c: two.acceleration
  d: hanging.acceleration
  alpha: wheel.angular_acceleration
  gamma: hanging.angular_acceleration
  S: rope.left.tension
  T: rope.hanging.tension
  U: cord.one.tension
  V: cord.two.tension
"""
NESTED = """\
given: {m1: 2 kg, m2: 3 kg, m3: 1 kg, m4: 4 kg, M: 2 kg, I1: 1 kg m^2, I2: 1/2 kg m^2, R: 10 cm}
bodies:
  left: {mass: m1, moves: up}
  wheel: {inertia: I1, radius: R}
  second: {mass: M, inertia: I2, radius: R, moves: down}
  third: {mass: M, inertia: I2, radius: R, moves: down}
  one: {mass: m2, moves: down}
  two: {mass: m3, moves: down}
  three: {mass: m4, moves: down}
connections:
  axle: {axle: wheel}
  rope: {string: [left, wheel, second.center]}
  cord: {string: [one, second, third.center]}
  line: {string: [two, third, three]}
find:
  a: left.acceleration
  b: one.acceleration
  c: two.acceleration
  d: three.acceleration
  alpha: wheel.angular_acceleration
  gamma: second.angular_acceleration
  delta: third.angular_acceleration
  S: rope.left.tension
  T: rope.second.tension
  U: cord.one.tension
  V: cord.third.tension
  W: line.two.tension
  X: line.three.tension
"""


def chain(wheels: int, *, apart: bool = False) -> str:
    """Two blocks on a string over a row of wheels: all alike, the acceleration asked; or each of its own size, and all asked (`apart`)."""
    numbers = range(1, wheels + 1)
    names = [f"w{number}" for number in numbers]
    sizes = [(f"I{number}", f"R{number}") if apart else ("I1", "R") for number in numbers]
    given = {"m1: 2 kg": None, "m2: 3 kg": None}
    given |= dict.fromkeys(
        f"{letter}: {number} kg m^2" for number, (letter, _) in zip(numbers, sizes, strict=True) if apart
    )
    given |= dict.fromkeys(
        f"{letter}: {number} cm" for number, (_, letter) in zip(numbers, sizes, strict=True) if apart
    )
    given |= {} if apart else {"I1: 1 kg m^2": None, "R: 10 cm": None}
    bodies = "".join(
        f"  {name}: {{inertia: {own[0]}, radius: {own[1]}}}\n" for name, own in zip(names, sizes, strict=True)
    )
    axles = "".join(f"  axle{name}: {{axle: {name}}}\n" for name in names)
    asked = {"a": "left.acceleration"}
    if apart:
        asked |= {"b": "right.acceleration"}
        asked |= {f"alpha_{name}": f"{name}.angular_acceleration" for name in names}
        asked |= {f"T_{name}": f"rope.{name}.tension" for name in ("left", *names)}
    return (
        f"given: {{{', '.join(given)}}}\n"
        f"bodies:\n  left: {{mass: m1, moves: up}}\n{bodies}  right: {{mass: m2, moves: down}}\n"
        f"connections:\n{axles}  rope: {{string: [left, {', '.join(names)}, right]}}\n"
        f"find: {{{', '.join(f'{name}: {path}' for name, path in asked.items())}}}\n"
    )


def page(scenes: int) -> str:
    """Independent scenes of a block on a wheel, of which the first is asked."""
    rows = range(1, scenes + 1)
    bodies = "".join(
        f"  block{row}: {{mass: m, moves: down}}\n  disc{row}: {{shape: disc, mass: M, radius: R}}\n" for row in rows
    )
    joints = "".join(
        f"  axle{row}: {{axle: disc{row}}}\n  string{row}: {{string: [disc{row}, block{row}]}}\n" for row in rows
    )
    given = "given: {m: 2 kg, M: 5 kg, R: 20 cm}\n"
    return f"{given}bodies:\n{bodies}connections:\n{joints}find: {{a: block1.acceleration}}\n"


CHAIN = 29  # wheels of the chain among the machines

MACHINES = (
    Machine("Atwood", ATWOOD, 1, ("m1", "m2"), lambda q, s: [q[0], -q[0]], ("I1",), lambda q, s: [q[0] / s["R"]]),
    Machine(
        "incline",
        INCLINE,
        1,
        ("m1", "m2"),
        lambda q, s: [q[0] * s["sin"](s["beta"]), -q[0]],
        ("I1",),
        lambda q, s: [q[0] / s["R"]],
        lambda q, s: [q[0], q[0]],
    ),
    Machine(
        "double Atwood",
        DOUBLE,
        2,
        ("m1", "M", "m2", "m3"),
        lambda q, s: [q[0], -q[0], -q[0] - q[1], -q[0] + q[1]],
        ("I1", "I2"),
        lambda q, s: [q[0] / s["R"], q[1] / s["R"]],
    ),
    Machine(
        "nested pulleys",
        NESTED,
        3,
        ("m1", "M", "M", "m2", "m3", "m4"),
        lambda q, s: [q[0], -q[0], -q[0] + q[1], -q[0] - q[1], -q[0] + q[1] - q[2], -q[0] + q[1] + q[2]],
        ("I1", "I2", "I2"),
        lambda q, s: [q[0] / s["R"], q[1] / s["R"], q[2] / s["R"]],
    ),
    Machine(
        "chain",
        chain(CHAIN, apart=True),
        1,
        ("m1", "m2"),
        lambda q, s: [q[0], -q[0]],
        tuple(f"I{number}" for number in range(1, CHAIN + 1)),
        lambda q, s: [q[0] / s[f"R{number}"] for number in range(1, CHAIN + 1)],
    ),
)


def rods(count: int) -> str:
    """A chain of hinged rods, all different and turning, of which all accelerations and both components of all joint forces are asked."""
    numbers = range(count)
    bodies = "".join(f"  r{k}: {{shape: rod, mass: {1 + k % 4} kg, length: {3 + k % 5}0 cm}}\n" for k in numbers)
    joints = "".join(f"  pin{k}: {{hinge: {f'[r{k - 1}.end, r{k}.start]' if k else 'r0.start'}}}\n" for k in numbers)
    state = ", ".join(f"r{k}.angle: {(50 * k) % 360} deg, r{k}.angular_velocity: {k % 7 - 3} rad/s" for k in numbers)
    asked = "".join(
        f"  a{k}: r{k}.angular_acceleration at now\n  x{k}: pin{k}.force.x at now\n  y{k}: pin{k}.force.y at now\n"
        for k in numbers
    )
    return f"bodies:\n{bodies}connections:\n{joints}states: {{now: {{{state}}}}}\nfind:\n{asked}"
