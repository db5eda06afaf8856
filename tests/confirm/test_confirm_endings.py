"""What rubs stops, begins to roll, turns back: the state at a later time, against steps in time that know friction as an impulse alone.

The stepper below is told masses, drives and what rubs as numbers; nothing tells it when a motion changes.
"""

from __future__ import annotations

from collections.abc import Sequence
from math import cos, radians, sin
from random import Random

import pytest
from msgspec import Struct

from rotsolve import Unsolvable
from rotsolve.core.equation import FAMILIES
from rotsolve.pipeline import solve
from stepping import G, numbers

STEPS = 1500
SWEEPS = 12  # rounds in which several rubs find their impulses
CLOSE = 8e-3  # what so many steps leave of the largest value on the way


class Moving(Struct):
    """Bodies with coordinates of their own: inertias, drives, speeds; `rubs` are (how the speeds make the slip, greatest friction)."""

    masses: Sequence[float]
    drives: Sequence[float]
    speeds: list[float]
    rubs: Sequence[tuple[Sequence[float], float]]

    def after(self, time: float) -> tuple[list[float], list[float], float]:
        """Speeds and ways after a time, and the energy that friction has taken."""
        step, ways, taken = time / STEPS, [0.0] * len(self.speeds), 0.0
        held = [0.0] * len(self.rubs)
        for _ in range(STEPS):
            before = list(self.speeds)
            for k, drive in enumerate(self.drives):
                self.speeds[k] += drive * step / self.masses[k]
            held = [0.0] * len(self.rubs)
            for _ in range(SWEEPS if len(self.rubs) > 1 else 1):
                for number, (row, most) in enumerate(self.rubs):
                    slip = sum(share * speed for share, speed in zip(row, self.speeds, strict=True))
                    ease = sum(share**2 / mass for share, mass in zip(row, self.masses, strict=True))
                    wanted = min(max(held[number] - slip / ease, -most * step), most * step)
                    for k, share in enumerate(row):
                        self.speeds[k] += (wanted - held[number]) * share / self.masses[k]
                    held[number] = wanted
            mean = [(one + other) / 2 for one, other in zip(before, self.speeds, strict=True)]
            ways = [way + speed * step for way, speed in zip(ways, mean, strict=True)]
            for impulse, (row, _) in zip(held, self.rubs, strict=True):
                taken -= impulse * sum(share * speed for share, speed in zip(row, mean, strict=True))
        return self.speeds, ways, taken


def compare(scene: str, expected: dict[str, float], seed: int, laws: Sequence[str] = tuple(FAMILIES)) -> None:
    """By the shortest way, and by one of the laws where that gives an answer; the others take long to find that they give none."""
    scale = max(1.0, *map(abs, expected.values()))
    for law in (None, laws[seed % len(laws)]):
        try:
            found = numbers(solve(scene, law=law))
        except Unsolvable:
            assert law is not None
            continue
        for name, value in expected.items():
            if law is not None and name not in found:
                continue  # that law does not tell it
            assert abs(found[name] - value) < CLOSE * max(scale, abs(value)), (law, name, found[name], value, scene)


def givens(**letters: tuple[float, str]) -> str:
    """Letters with their numbers and units, as a scene tells them."""
    return "{" + ", ".join(f"{name}: {number:.12f} {unit}".rstrip() for name, (number, unit) in letters.items()) + "}"


TIMES = [(0.1, 0.6), (0.6, 2.0), (2.0, 6.0)]


def draws(seed: int) -> tuple[Random, float]:
    """Numbers by chance, and a time that is short, middling or long."""
    chance = Random(seed)
    return chance, chance.uniform(*TIMES[seed % len(TIMES)])


@pytest.mark.parametrize("seed", range(3))
def test_block_thrown_along_a_rough_slope(seed: int) -> None:
    chance, time = draws(seed)
    slope, static = chance.uniform(5, 50), chance.uniform(0.1, 0.8)
    kinetic, speed, down = static * chance.uniform(0.6, 1), chance.uniform(-6, 6), chance.choice(["left", "right"])
    sense = chance.choice([1, -1])  # the positive sense is up or down the slope
    pull = -G * sin(radians(slope)) * sense
    if kinetic < static and abs(pull) > kinetic * G * cos(radians(slope)) * 0.98:
        kinetic = static  # the stepper has one coefficient
    motion = Moving([1.0], [pull], [speed], [([1.0], kinetic * G * cos(radians(slope)))])
    (v,), (x,), taken = motion.after(time)
    told = givens(m=(1, "kg"), u=(speed, "m/s"), mu=(static, ""), nu=(kinetic, ""), beta=(slope, "deg"), t1=(time, "s"))
    scene = f"""
title: Block on a slope
given: {told}
surfaces: {{ramp: {{slope: beta, down: {down}}}}}
bodies: {{block: {{mass: m, moves: {"up" if sense > 0 else "down"}}}}}
connections: {{base: {{contact: [block, ramp], friction: {{static: mu, kinetic: nu}}}}}}
states: {{start: {{block.velocity: u}}, end: {{time: t1}}}}
find:
  v: block.velocity at end
  x: block.displacement from start to end
  W: base.work from start to end
"""
    compare(scene, {"v": v, "x": x, "W": -taken}, seed)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("seed", range(3))
def test_round_bodies_thrown_with_a_spin(seed: int) -> None:
    chance, time = draws(seed)
    share, shape = chance.choice([(0.4, "sphere"), (0.5, "disc"), (1.0, "ring")])
    radius, slope, friction = chance.uniform(0.1, 0.5), chance.uniform(3, 40), chance.uniform(0.05, 0.6)
    speed, spin = chance.uniform(-6, 6), chance.uniform(-30, 30)
    push = friction * G * cos(radians(slope))
    motion = Moving([1.0, share * radius**2], [-G * sin(radians(slope)), 0.0], [speed, spin], [([1.0, -radius], push)])
    (v, w), (x, turned), taken = motion.after(time)
    down = chance.choice(["left", "right"])
    told = givens(
        m=(1, "kg"),
        R=(radius, "m"),
        u=(speed, "m/s"),
        w0=(spin, "rad/s"),
        mu=(friction, ""),
        beta=(slope, "deg"),
        t1=(time, "s"),
    )
    scene = f"""
title: Round body on a slope
given: {told}
surfaces: {{ramp: {{slope: beta, down: {down}}}}}
bodies: {{wheel: {{shape: {shape}, mass: m, radius: R, moves: up}}}}
connections: {{grip: {{contact: [wheel, ramp], friction: mu}}}}
states: {{start: {{wheel.velocity: u, wheel.angular_velocity: w0}}, end: {{time: t1}}}}
find:
  v: wheel.velocity at end
  w: wheel.angular_velocity at end
  x: wheel.displacement from start to end
  phi: wheel.rotation from start to end
  L: lost energy from start to end
"""
    compare(scene, {"v": v, "w": w, "x": x, "phi": turned, "L": taken}, seed, ("newton",))


@pytest.mark.sampled(3)
@pytest.mark.parametrize("seed", range(3))
def test_windlass_on_a_stiff_bearing_with_a_brake(seed: int) -> None:
    chance, time = draws(seed)
    radius, mass, inertia = chance.uniform(0.1, 0.4), chance.uniform(1, 6), chance.uniform(0.05, 1)
    bearing, press, mu, speed = (
        chance.uniform(0.2, 6),
        chance.uniform(1, 20),
        chance.uniform(0.1, 0.6),
        chance.uniform(-3, 3),
    )
    motion = Moving([mass + inertia / radius**2], [-mass * G], [speed], [([1.0], bearing / radius + mu * press)])
    (v,), (x,), taken = motion.after(time)
    told = givens(
        m=(mass, "kg"),
        I=(inertia, "kg m^2"),
        R=(radius, "m"),
        u=(speed, "m/s"),
        tau=(bearing, "N m"),
        F=(press, "N"),
        mu=(mu, ""),
        t1=(time, "s"),
    )
    scene = f"""
title: Windlass
given: {told}
bodies: {{drum: {{inertia: I, radius: R, turns: clockwise}}, load: {{mass: m, moves: up}}}}
connections: {{axle: {{axle: drum, friction_torque: tau}}, rope: {{string: [load, drum]}}}}
actions: {{brake: {{press: F, on: drum.rim, friction: mu}}}}
states: {{start: {{load.velocity: u}}, end: {{time: t1}}}}
find:
  v: load.velocity at end
  x: load.displacement from start to end
  L: lost energy from start to end
"""
    compare(scene, {"v": v, "x": x, "L": taken}, seed)


@pytest.mark.parametrize("seed", range(3))
def test_clutch_between_two_wheels(seed: int) -> None:
    chance, time = draws(seed)
    inertias, speeds = [chance.uniform(0.2, 2) for _ in range(2)], [chance.uniform(-20, 20) for _ in range(2)]
    torque, motor = chance.uniform(1, 12), chance.uniform(-3, 3)
    motion = Moving(inertias, [motor, 0.0], list(speeds), [([1.0, -1.0], torque)])
    (w1, w2), (n1, n2), _ = motion.after(time)
    told = givens(
        I=(inertias[0], "kg m^2"),
        J=(inertias[1], "kg m^2"),
        a=(speeds[0], "rad/s"),
        b=(speeds[1], "rad/s"),
        tau=(torque, "N m"),
        M=(motor, "N m"),
        t1=(time, "s"),
    )
    scene = f"""
title: Clutch
given: {told}
bodies: {{plate: {{inertia: I}}, disc: {{inertia: J}}}}
connections: {{shaft: {{axle: [plate, disc]}}, clutch: {{clutch: [plate, disc], friction_torque: tau}}}}
actions: {{motor: {{couple: M, on: plate}}}}
states: {{start: {{plate.angular_velocity: a, disc.angular_velocity: b}}, end: {{time: t1}}}}
find:
  w1: plate.angular_velocity at end
  w2: disc.angular_velocity at end
  n1: plate.rotation from start to end
  n2: disc.rotation from start to end
"""
    compare(scene, {"w1": w1, "w2": w2, "n1": n1, "n2": n2}, seed)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("seed", range(3))
def test_block_on_a_plank_on_a_rough_floor(seed: int) -> None:
    chance, time = draws(seed)
    m, M = chance.uniform(1, 4), chance.uniform(1, 6)
    mu, nu = chance.uniform(0.1, 0.6), chance.uniform(0.02, 0.2)
    u, V = chance.uniform(-4, 4), chance.uniform(-4, 4)
    motion = Moving([m, M], [0.0, 0.0], [u, V], [([1.0, -1.0], mu * m * G), ([0.0, 1.0], nu * (m + M) * G)])
    (v, w), (x, y), taken = motion.after(time)
    told = givens(m=(m, "kg"), M=(M, "kg"), u=(u, "m/s"), V=(V, "m/s"), mu=(mu, ""), nu=(nu, ""), t1=(time, "s"))
    scene = f"""
title: Block on a plank
given: {told}
surfaces: {{floor: level}}
bodies: {{plank: {{mass: M, moves: right}}, block: {{mass: m, moves: right}}}}
connections:
  below: {{contact: [plank, floor], friction: nu}}
  grip: {{contact: [block, plank], friction: mu}}
states: {{start: {{block.velocity: u, plank.velocity: V}}, end: {{time: t1}}}}
find:
  v: block.velocity at end
  w: plank.velocity at end
  x: block.displacement from start to end
  y: plank.displacement from start to end
  L: lost kinetic_energy from start to end
"""
    compare(scene, {"v": v, "w": w, "x": x, "y": y, "L": taken}, seed, ("newton", "newton", "angular-momentum"))


@pytest.mark.sampled(3)
@pytest.mark.parametrize("seed", range(3))
def test_block_on_a_table_drawn_over_a_pulley(seed: int) -> None:
    chance, time = draws(seed)
    m, M, mu, tau = chance.uniform(1, 6), chance.uniform(1, 4), chance.uniform(0.1, 0.6), chance.uniform(0, 2)
    speed, radius = chance.uniform(-5, 5), 0.2
    motion = Moving([m + M], [M * G], [speed], [([1.0], mu * m * G + tau / radius)])
    (v,), (x,), taken = motion.after(time)
    told = givens(
        m=(m, "kg"), M=(M, "kg"), R=(radius, "m"), u=(speed, "m/s"), mu=(mu, ""), tau=(tau, "N m"), t1=(time, "s")
    )
    scene = f"""
title: Block on a table
given: {told}
surfaces: {{table: level}}
bodies:
  block: {{mass: m, moves: right}}
  load: {{mass: M, moves: down}}
  pulley: {{mass: 0, radius: R, turns: clockwise}}
connections:
  base: {{contact: [block, table], friction: mu}}
  axle: {{axle: pulley, friction_torque: tau}}
  rope: {{string: [block, pulley, load]}}
states: {{start: {{block.velocity: u}}, end: {{time: t1}}}}
find:
  v: block.velocity at end
  x: load.displacement from start to end
  L: lost energy from start to end
"""
    compare(scene, {"v": v, "x": x, "L": taken}, seed, ("newton", "lagrange", "angular-momentum"))


@pytest.mark.exhaustive
def test_a_phase_begins_as_the_one_before_leaves_it() -> None:
    """A pull that ends: what it has set sliding, or spinning, goes on until friction has had its way."""
    told = givens(m=(4, "kg"), F=(20, "N"), R=(0.3, "m"), M=(8, "N m"), mu=(0.3, ""))
    scene = f"""
title: A pull and a motor that end
given: {told}
surfaces: {{road: level}}
bodies: {{block: {{mass: m, moves: right}}, wheel: {{shape: disc, mass: m, radius: R, moves: right}}}}
connections: {{base: {{contact: [block, road], friction: mu}}, grip: {{contact: [wheel, road], friction: mu}}}}
actions:
  pull: {{force: F, on: block, direction: right, from: start, to: off}}
  motor: {{couple: M, on: wheel, from: start, to: off}}
states: {{start: at rest, off: {{time: 2 s}}, late: {{time: 20 s}}}}
find:
  v: block.velocity at late
  x: block.displacement from start to late
  w: wheel.angular_velocity at late
"""
    pulled, spun = (
        Moving([4], [20], [0], [([1], 0.3 * 4 * G)]),
        Moving([4, 0.18], [0, 8], [0, 0], [([1, -0.3], 0.3 * 4 * G)]),
    )
    (speed,), (way,), _ = pulled.after(2)
    speeds, _, _ = spun.after(2)
    (v,), (further,), _ = Moving([4], [0], [speed], pulled.rubs).after(20)
    (_, w), _, _ = Moving([4, 0.18], [0, 0], list(speeds), spun.rubs).after(20)
    compare(scene, {"v": v, "x": way + further, "w": w}, 0)


@pytest.mark.parametrize("friction", [0.05, 0.4])
def test_a_wheel_drawn_over_a_rough_pulley_rolls_or_slips(friction: float) -> None:
    told = givens(m=(3, "kg"), R=(0.1, "m"), M=(2, "kg"), mu=(friction, ""), tau=(0.1, "N m"), r=(0.05, "m"))
    scene = f"""
title: Cylinder drawn by a weight
given: {told}
surfaces: {{table: level}}
bodies:
  wheel: {{shape: cylinder, mass: m, radius: R, moves: right}}
  pulley: {{mass: 0, radius: r, turns: clockwise}}
  load: {{mass: M, moves: down}}
connections:
  grip: {{contact: [wheel, table], friction: mu}}
  axle: {{axle: pulley, friction_torque: tau}}
  rope: {{string: [wheel.center, pulley, load]}}
states: {{start: at rest, end: {{time: 2 s}}}}
find: {{v: wheel.velocity at end, w: wheel.angular_velocity at end}}
"""
    rubs = [([1, -0.1], friction * 3 * G), ([1, 0], 0.1 / 0.05)]
    (v, w), _, _ = Moving([5, 0.015], [2 * G, 0], [0, 0], rubs).after(2)
    compare(scene, {"v": v, "w": w}, 0)
