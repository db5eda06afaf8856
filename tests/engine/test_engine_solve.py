"""Whole scenes with a known end: roots and their reasons, forces in time, events against brute-force impulses, stick or slip."""

from __future__ import annotations

import math

import pytest

import rotsolve
from rotsolve.pipeline import solve
from rotsolve.solution import Solution

G = 9.8


def solved(text: str, law: str | None = None) -> Solution:
    return solve(text, law=law)


def test_the_public_name_is_the_function_whatever_was_imported_before() -> None:
    assert callable(rotsolve.solve), f"rotsolve.solve is {rotsolve.solve}"


def value(solution: Solution, name: str) -> float:
    number = solution.answers[name].float
    assert number is not None
    return number


def close(one: float, other: float) -> bool:
    return math.isclose(one, other, rel_tol=1e-9, abs_tol=1e-12)


def reasons(solution: Solution) -> str:
    moves = [move for section in solution.derivation.sections for move in section.moves]
    return " ".join(part if isinstance(part, str) else "□" for move in moves for part in move.reason)


def gauss(rows: list[list[float]]) -> list[float]:
    """Solve a small linear system, each row its coefficients and then its right side."""
    size = len(rows)
    rows = [row[:] for row in rows]
    for column in range(size):
        pivot = max(range(column, size), key=lambda index: abs(rows[index][column]))
        rows[column], rows[pivot] = rows[pivot], rows[column]
        for index in range(size):
            if index != column:
                share = rows[index][column] / rows[column][column]
                rows[index] = [one - share * other for one, other in zip(rows[index], rows[column], strict=True)]
    return [rows[index][size] / rows[index][index] for index in range(size)]


FALL = """
title: Rod let go
given: {{M: 2 kg, L: 1.5 m}}
bodies: {{rod: {{shape: rod, mass: M, length: L, turns: {turns}}}}}
connections: {{pivot: {{hinge: rod.start}}}}
states:
  high: {{rod.angle: {angle} deg, at rest: all}}
  low: {{rod.angle: -90 deg}}
find: {{w: rod.angular_velocity at low}}
"""


@pytest.mark.parametrize("angle", [80, 30, -20, -160, -250])
@pytest.mark.parametrize("turns", ["clockwise", "counterclockwise"])
def test_the_root_follows_the_way_the_rod_falls(angle: int, turns: str) -> None:
    solution = solved(FALL.format(angle=angle, turns=turns))
    size = math.sqrt(3 * G * (1 + math.sin(math.radians(angle))) / 1.5)
    positive = (1 if angle < -90 else -1) * (1 if turns == "counterclockwise" else -1)
    assert close(value(solution, "w"), positive * size)
    assert solution.answers["w"].direction == ("counterclockwise" if angle < -90 else "clockwise")
    assert "turns" in reasons(solution)


def test_time_is_the_positive_root() -> None:
    text = """
title: Wheel braked from a given speed through a given angle
given: {a: 2 rad/s^2, w: 10 rad/s, n: 16 rad}
bodies: {wheel: {inertia: 3 kg m^2}}
connections: {axle: {axle: wheel, angular_acceleration: -a}}
states: {start: {wheel.angular_velocity: w}, end: {wheel.rotation: n}}
find: {t: time from start to end, v: wheel.angular_velocity at end}
"""
    solution = solved(text)
    assert close(abs(value(solution, "v")), 6)
    assert value(solution, "t") > 0
    assert close(10 - 2 * value(solution, "t"), value(solution, "v"))


def test_an_angle_asked_for() -> None:
    text = """
title: Slope on which a block slides with a given acceleration
given: {m: 2 kg, a: 4.9 m/s^2, beta: unknown}
surfaces: {ramp: {slope: beta, down: right}}
bodies: {block: {mass: m, moves: down}}
connections: {base: {contact: [block, ramp]}}
states: {now: {block.acceleration: a}}
find: {beta: beta}
"""
    assert close(value(solved(text), "beta"), math.radians(30))


@pytest.mark.parametrize(
    ("couple", "speed", "turn"),
    [
        ("c*time", lambda c, t: c * t**2 / 2, lambda c, t: c * t**3 / 6),
        ("c*time^2", lambda c, t: c * t**3 / 3, lambda c, t: c * t**4 / 12),
        ("c*(1 - time/(4 s))", lambda c, t: c * (t - t**2 / 8), lambda c, t: c * (t**2 / 2 - t**3 / 24)),
    ],
)
def test_a_couple_in_time(couple: str, speed: object, turn: object) -> None:
    unit = {"c*time": "N m/s", "c*time^2": "N m/s^2"}.get(couple, "N m")
    text = f"""
title: Flywheel
given: {{I: 3 kg m^2, c: 6 {unit}, t1: 2 s, w: 5 rad/s}}
bodies: {{wheel: {{inertia: I}}}}
connections: {{axle: {{axle: wheel}}}}
actions: {{motor: {{couple: {couple}, on: wheel}}}}
states: {{start: {{wheel.angular_velocity: w}}, end: {{time: t1}}}}
find: {{v: wheel.angular_velocity at end, n: wheel.rotation from start to end, E: change of wheel.kinetic_energy from start to end}}
"""
    solution = solved(text)
    gained = speed(6, 2) / 3  # type: ignore[operator]
    assert close(value(solution, "v"), 5 + gained)
    assert close(value(solution, "n"), 5 * 2 + turn(6, 2) / 3)  # type: ignore[operator]
    assert close(value(solution, "E"), 1.5 * ((5 + gained) ** 2 - 25))


HIT = """
title: Ball against a hanging rod
given: {{M: 3 kg, L: 1.8 m, m: 500 g, u: 4 m/s, d: {d} m, e: {e}}}
bodies: {{rod: {{shape: rod, mass: M, length: L}}, ball: {{mass: m, moves: {moves}}}}}
connections: {{pin: {{hinge: rod.start}}}}
states: {{before: {{rod.angle: -90 deg, rod.angular_velocity: 0, ball.velocity: u}}, after: {{}}}}
events: {{hit: {event}}}
find:
  w: rod.angular_velocity at after
  H: pin.impulse.x during hit
  Q: lost kinetic_energy during hit
"""


def rod_hit(d: float, e: float, u: float) -> tuple[float, float, float]:
    """ω, the pin's impulse and the energy lost, from impulses on each body: unknowns J (on the rod), H, ω, v."""
    mass, length, ball = 3.0, 1.8, 0.5
    inertia = mass * length**2 / 3
    rows = [
        [d, 0, -inertia, 0, 0],  # J d = I ω
        [1, 1, -mass * length / 2, 0, 0],  # J + H = M v_cm
        [1, 0, 0, ball, ball * u],  # m u − J = m v
        [0, 0, d, -1, e * u],  # ω d − v = e u
    ]
    _, held, spin, speed = gauss(rows)
    return spin, held, ball * u**2 / 2 - ball * speed**2 / 2 - inertia * spin**2 / 2


@pytest.mark.parametrize("d", [0.5, 1.2, 1.8])
@pytest.mark.parametrize("e", [0, 0.6, 1])
@pytest.mark.parametrize("moves", ["right", "left"])
def test_a_bounce_is_what_impulses_make_of_it(d: float, e: float, moves: str) -> None:
    event = "{collides: [ball, rod.at(d)], restitution: e, from: before, to: after}"
    solution = solved(HIT.format(d=d, e=e, moves=moves, event=event))
    sign = 1 if moves == "right" else -1
    spin, held, lost = rod_hit(d, e, 4)
    assert close(value(solution, "w"), sign * spin)
    assert close(value(solution, "H"), sign * held)
    assert math.isclose(value(solution, "Q"), lost, rel_tol=1e-9, abs_tol=1e-9)


@pytest.mark.parametrize("d", [0.5, 1.2, 1.8])
@pytest.mark.parametrize("moves", ["right", "left"])
def test_sticking_is_a_bounce_without_restitution(d: float, moves: str) -> None:
    event = "{joins: [ball, rod.at(d)], from: before, to: after}"
    solution = solved(HIT.format(d=d, e=0, moves=moves, event=event))
    sign = 1 if moves == "right" else -1
    spin, held, lost = rod_hit(d, 0, 4)
    assert close(value(solution, "w"), sign * spin)
    assert close(value(solution, "H"), sign * held)
    assert close(value(solution, "Q"), lost)


@pytest.mark.parametrize(("w", "u"), [(10, 4), (10, -4), (-3, 7)])
def test_discs_that_join_keep_angular_momentum(w: int, u: int) -> None:
    text = f"""
title: Two discs
given: {{I: 2 kg m^2, J: 3 kg m^2}}
bodies: {{lower: {{inertia: I}}, upper: {{inertia: J}}}}
connections: {{axle: {{axle: [lower, upper]}}}}
states: {{before: {{lower.angular_velocity: {w} rad/s, upper.angular_velocity: {u} rad/s}}, after: {{}}}}
events: {{clutch: {{joins: [lower, upper], from: before, to: after}}}}
find: {{W: upper.angular_velocity at after, Q: lost kinetic_energy during clutch}}
"""
    solution = solved(text)
    together = (2 * w + 3 * u) / 5
    assert close(value(solution, "W"), together)
    assert close(value(solution, "Q"), w**2 + 1.5 * u**2 - 2.5 * together**2)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("offset", [0.0, 0.3, 0.6])
def test_putty_on_a_free_rod(offset: float) -> None:
    """A rod that lies free on ice, hit square at some way from its centre: momentum and angular momentum of all."""
    text = f"""
title: Rod on ice
plane: horizontal
given: {{M: 2 kg, L: 1.2 m, m: 400 g, u: 5 m/s, d: {0.6 + offset} m}}
bodies: {{rod: {{shape: rod, mass: M, length: L}}, putty: {{mass: m, moves: up}}}}
states: {{before: {{rod.angle: 0, rod.angular_velocity: 0, rod.velocity.x: 0, rod.velocity.y: 0, putty.velocity: u}}, after: {{}}}}
events: {{hit: {{joins: [putty, rod.at(d)], from: before, to: after}}}}
find: {{w: rod.angular_velocity at after}}
"""
    rows = [  # velocities of the rod's centre and of the putty, and the spin, afterwards
        [2.0, 0.4, 0.0, 0.4 * 5],
        [0.0, 0.4 * offset, 2 * 1.2**2 / 12, 0.4 * 5 * offset],
        [1.0, -1.0, offset, 0.0],
    ]
    _, _, spin = gauss(rows)
    assert close(value(solved(text), "w"), spin)


SLOPE = """
title: Block on a rough slope tied over a pulley to a hanging block
given: {{m: 2 kg, n: {n} kg, M: 1 kg, R: 0.1 m, beta: 30 deg, mu: 0.2}}
surfaces: {{ramp: {{slope: beta, down: left}}}}
bodies:
  block: {{mass: m, moves: up}}
  load: {{mass: n, moves: down}}
  pulley: {{shape: disc, mass: M, radius: R, turns: clockwise}}
connections:
  base: {{contact: [block, ramp], friction: mu}}
  axle: {{axle: pulley}}
  cord: {{string: [block, pulley, load]}}
states: {{now: at rest}}
find: {{a: block.acceleration}}
"""


@pytest.mark.parametrize("n", ["0.1", "0.5", "0.7", "0.9", "1", "1.3", "1.4", "3"])
def test_friction_decides_whether_and_which_way(n: str) -> None:
    load, weight = float(n), 2 * G * math.sin(math.radians(30))
    limit = 0.2 * 2 * G * math.cos(math.radians(30))
    drive = load * G - weight
    push = 0.0 if abs(drive) <= limit else drive - math.copysign(limit, drive)
    assert close(value(solved(SLOPE.format(n=n)), "a"), push / (2 + load + 0.5))


TETHERED = """
title: Cylinder unwinding down a slope from a string that leaves it where it touches
given: {{M: 4 kg, R: 10 cm}}
surfaces: {{ramp: {{slope: 30 deg, down: {down}}}}}
bodies: {{cylinder: {{shape: cylinder, mass: M, radius: R, moves: down}}}}
connections:
  base: {{contact: [cylinder, ramp], friction: {mu}}}
  cord: {{string: [cylinder, ceiling], along: ramp, under: cylinder}}
find: {{a: cylinder.acceleration}}
"""


@pytest.mark.parametrize("law", [None, "energy"])
@pytest.mark.parametrize("mu", ["0.1", "0.9"])
@pytest.mark.parametrize("down", ["left", "right"])
def test_a_contact_that_a_string_keeps_at_rest_does_no_work(down: str, mu: str, law: str | None) -> None:
    """The lowest point rests, so M g R sin 30° = (I + M R²) a/R: a = g/3, and no friction is kinetic."""
    solution = solved(TETHERED.format(down=down, mu=mu), law)
    assert close(value(solution, "a"), G / 3)
    assert "kinetic friction" not in str(solution)


def test_a_smooth_contact_that_a_string_keeps_at_rest_leaves_all_to_the_string() -> None:
    """T R = I α with a = R α = g/3: T = M g/6."""
    text = TETHERED.format(down="left", mu="0").replace("find: {", "find: {T: cord.tension, ")
    solution = solved(text)
    assert close(value(solution, "T"), 4 * G / 6)
    assert close(value(solution, "a"), G / 3)


@pytest.mark.parametrize("law", ["newton", "energy", "angular-momentum"])
def test_block_on_a_disc_by_every_law(law: str) -> None:
    text = """
title: Block on a disc
given: {m: 2 kg, M: 5 kg, R: 0.2 m}
bodies: {disc: {shape: disc, mass: M, radius: R, turns: clockwise}, block: {mass: m, moves: down}}
connections: {axle: {axle: disc}, cord: {string: [disc, block]}}
find: {a: block.acceleration}
"""
    solution = solved(text, law)
    assert solution.answers["a"].exact == "2 m g/(2 m + M)"


@pytest.mark.parametrize("start", [75, 10, -30])
@pytest.mark.parametrize("end", [-45, -80, -90])
def test_the_force_at_the_pivot_of_a_falling_rod(start: int, end: int) -> None:
    """m a of the centre of mass, with its centripetal part, less the weight."""
    text = f"""
title: Rod let go
given: {{M: 2 kg, L: 1.5 m}}
bodies: {{rod: {{shape: rod, mass: M, length: L}}}}
connections: {{pivot: {{hinge: rod.start}}}}
states:
  high: {{rod.angle: {start} deg, at rest: all}}
  low: {{rod.angle: {end} deg}}
find: {{Fx: pivot.force.x at low, Fy: pivot.force.y at low}}
"""
    solution, angle = solved(text), math.radians(end)
    spin_squared = 3 * G * (math.sin(math.radians(start)) - math.sin(angle)) / 1.5
    rate = -1.5 * G * math.cos(angle) / 1.5
    sideways = 2 * 0.75 * (-rate * math.sin(angle) - spin_squared * math.cos(angle))
    upwards = 2 * 0.75 * (rate * math.cos(angle) - spin_squared * math.sin(angle)) + 2 * G
    assert math.isclose(value(solution, "Fx"), sideways, rel_tol=1e-9, abs_tol=1e-9)
    assert close(value(solution, "Fy"), upwards)
