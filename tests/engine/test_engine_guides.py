"""Guides: pins in slots, collars that a rod joins, and what slides in a tube, each held against its own geometry or equation of motion.

A linkage is differentiated in numbers: its places as a function of the crank's angle, and its kinetic energy for the torque.
"""

from __future__ import annotations

from collections.abc import Callable
from math import acosh, asin, atan2, cos, cosh, hypot, pi, radians, sin, sinh, sqrt

import pytest

import rotsolve
from rotsolve.core.faults import Unsolvable

SLOTTED = """title: x
gravity: none
given:
  r: 10 cm
  d: 25 cm
  L: 60 cm
  m: 2 kg
  w: 7 rad/s
  phi: PHI deg
  s: sqrt(r^2 + d^2 + 2*r*d*sin(phi))
  psi: "atan2(d + r*sin(phi), r*cos(phi))"
bodies: {crank: {shape: rod, mass: 0, length: r}, arm: {shape: rod, mass: m, length: L}}
connections: {main: {hinge: crank.start, angular_velocity: w}, foot: {hinge: arm.start}, pin: {slot: [crank.end, arm.at(s)]}}
states: {now: {crank.angle: phi, arm.angle: psi}}
find: {w2: arm.angular_velocity, al: arm.angular_acceleration, F: size of pin.force, M: main.torque}
"""
STEP = 1e-4


def rates(place: Callable[[float], float], at: float, rate: float) -> tuple[float, float]:
    """Speed and acceleration of a place that a crank leads at a steady rate."""
    low, middle, high = (place(at + k * STEP) for k in (-1, 0, 1))
    return (high - low) / (2 * STEP) * rate, (high - 2 * middle + low) / STEP**2 * rate**2


def confirmed(solution: rotsolve.Solution) -> bool:
    return "confirmed with numbers" in " ".join(str(solution).split())


@pytest.mark.parametrize("angle", [-60, 0, 30, 90, 155])
def test_the_arm_that_a_crank_rocks(angle: int) -> None:
    """tan ψ = (d + r sin φ)/(r cos φ); the torque of the drive is power over rate, M w = I α w₂."""
    r, d, length, m, w = 0.1, 0.25, 0.6, 2.0, 7.0
    speed, bend = rates(lambda phi: atan2(d + r * sin(phi), r * cos(phi)), radians(angle), w)
    solution = rotsolve.solve(SLOTTED.replace("PHI", str(angle)))
    inertia, s = m * length**2 / 3, hypot(r * cos(radians(angle)), d + r * sin(radians(angle)))
    found = [solution.answers[name].float for name in ("w2", "al", "F", "M")]
    assert found == pytest.approx(
        [speed, bend, abs(inertia * bend / s), inertia * bend * speed / w], rel=1e-5, abs=1e-5
    )
    assert confirmed(solution)


def test_a_yoke_from_state_to_state() -> None:
    """½ (⅓ m r² + M r² sin² φ) ω² = F r (cos φ₁ − cos φ₂): how far the yoke has come is told by the crank, and the other way round."""
    scene = """title: x
gravity: none
given: {m: 1 kg, M: 2 kg, r: 20 cm, F: 30 N}
bodies: {crank: {shape: rod, mass: m, length: r}, yoke: {mass: M, moves: right}}
connections: {ax: {hinge: crank.start}, pin: {slot: [crank.end, yoke], along: up}}
actions: {push: {force: F, on: yoke, direction: left}}
states: {now: {crank.angle: 40 deg, at rest: all}, then: {TOLD}}
find: {w: crank.angular_velocity at then, v: yoke.velocity at then}
"""
    first = radians(40)
    for told, last in (
        ("crank.angle: 120 deg", radians(120)),
        ("yoke.displacement: -r", pi / 2 + asin(1 - cos(first))),
    ):
        gained = 30 * 0.2 * (cos(first) - cos(last))
        w = sqrt(2 * gained / (0.04 / 3 + 0.08 * sin(last) ** 2))
        solution = rotsolve.solve(scene.replace("TOLD", told))
        assert solution.answers["w"].float == pytest.approx(w, rel=1e-6)
        assert solution.answers["v"].float == pytest.approx(-0.2 * w * sin(last), rel=1e-6)
        assert confirmed(solution)


GUIDED = """title: x
given: {M: 3 kg, m: 1 kg, L: 1 m, phi: 60 deg}
bodies: {rod: {shape: rod, mass: M, length: L}COLLARS}
connections: {one: ONE, two: TWO}
states: {start: {rod.angle: phi, at rest: all}, past: {rod.angle: -20 deg}}
find: {alpha: rod.angular_acceleration at start, w: rod.angular_velocity at past}
"""
JOINTS = ", a: {mass: m, moves: right}, b: {mass: m, moves: up}", "{hinge: [a, rod.start]}", "{hinge: [b, rod.end]}"
SLOTS = "", "{slot: rod.start, along: right}", "{slot: rod.end, along: [0, 2]}"


@pytest.mark.parametrize(("words", "collar"), [(JOINTS, 1.0), (SLOTS, 0.0)])
def test_a_rod_whose_ends_are_led(words: tuple[str, str, str], collar: float) -> None:
    """½ (⅓ M L² + m L²) ω² = (½ M + m) g L (sin φ₁ − sin φ₂): m L² (sin² + cos²) of both collars together."""
    scene = GUIDED.replace("COLLARS", words[0]).replace("ONE", words[1]).replace("TWO", words[2])
    inertia, weight = 1.0 + collar, (1.5 + collar) * 9.8
    solution = rotsolve.solve(scene)
    assert solution.answers["alpha"].float == pytest.approx(-weight * cos(pi / 3) / inertia)
    w = -sqrt(2 * weight * (sin(pi / 3) + sin(radians(20))) / inertia)
    assert solution.answers["w"].float == pytest.approx(w)
    assert confirmed(solution)


def test_how_far_a_collar_is_taken() -> None:
    scene = GUIDED.replace("COLLARS", JOINTS[0]).replace("ONE", JOINTS[1]).replace("TWO", JOINTS[2])
    asked = "find: {s: b.displacement from start to past, x: a.displacement from start to past}\n"
    solution = rotsolve.solve(scene[: scene.index("find")] + asked)
    assert solution.answers["s"].float == pytest.approx(sin(radians(-20)) - sin(pi / 3))
    assert solution.answers["x"].float == pytest.approx(cos(pi / 3) - cos(radians(20)))


def test_a_bead_in_the_slot_of_a_rod_that_is_free() -> None:
    """Of a bead at b that goes along at u: N (1/m + 1/M + 12 b²/(M L²)) = 2 u w."""
    scene = """title: x
plane: horizontal
given: {M: 3 kg, m: 1 kg, L: 1 m, w: 4 rad/s, u: 2 m/s}
bodies: {rod: {shape: rod, mass: M, length: L}, bead: {mass: m}}
connections: {pin: {slot: [bead, rod.at(0.8*L)]}}
states: {now: {rod.angle: 0, rod.angular_velocity: w, rod.velocity: [0, 0], bead.velocity: [u, 0.3*L*w]}}
find: {N: size of pin.force}
"""
    assert rotsolve.solve(scene).answers["N"].float == pytest.approx(16 / (1 + 1 / 3 + 12 * 0.09 / 3))


TUBE = """title: x
PLANE
given: {m: 100 g, M: 1 kg, L: 1 m, b: 50 cm, w: WW rad/s, u: UU m/s, T: TT s, r: unknown}
bodies: {tube: {shape: rod, mass: M, length: L}, bead: {mass: m}}
connections: {axis: {hinge: tube.start DRIVE}, track: {rides: [bead, tube], friction: none}}
states: {start: {bead.radius: b, bead.velocity.radial: u MORE}, end: {LAST}}
find: {ASKED}
"""
STEADY = "plane: horizontal", ", angular_velocity: w", ""


def tube(said: tuple[str, str, str], u: float, last: str, asked: str, w: float = 2.0, time: float = 0.3) -> str:
    numbers = TUBE.replace("PLANE", said[0]).replace("DRIVE", said[1]).replace("MORE", said[2])
    numbers = numbers.replace("WW", str(w)).replace("UU", str(u)).replace("TT", str(time))
    return numbers.replace("LAST", last).replace("ASKED", asked)


@pytest.mark.parametrize(("u", "w", "time"), [(-0.8, 2, 0.3), (-0.8, 2, 1.2), (0, 2, 0.6), (0.3, -2, 0.4)])
def test_where_a_bead_in_a_driven_tube_is_after_a_time(u: float, w: float, time: float) -> None:
    """r = b cosh ωT + (u/ω) sinh ωT, also where it turns back on the way; and the time by the place."""
    r, v = 0.5 * cosh(w * time) + u / w * sinh(w * time), 0.5 * w * sinh(w * time) + u * cosh(w * time)
    asked = "r: r, v: bead.velocity.radial at end"
    solution = rotsolve.solve(tube(STEADY, u, "time: T, bead.radius: r", asked, w, time))
    assert [solution.answers[name].float for name in "rv"] == pytest.approx([r, v])
    assert confirmed(solution)
    back = rotsolve.solve(tube(STEADY, u, f"bead.radius: {r:.15f} m", "t: time from start to end", w, time))
    assert back.answers["t"].float == pytest.approx(time)


def test_a_bead_let_go_in_a_driven_tube() -> None:
    """N = 2 m ω v, and the drive gives 2 m r v ω."""
    asked = "t: time from start to end, N: track.normal_force at end, Q: axis.torque at end"
    solution = rotsolve.solve(tube(STEADY, 0, "bead.radius: 0.9 m", asked))
    time = acosh(1.8) / 2
    v = 0.5 * 2 * sinh(2 * time)
    assert [solution.answers[name].float for name in "tNQ"] == pytest.approx([time, 0.4 * v, 0.36 * v])
    assert confirmed(solution)


@pytest.mark.parametrize(("plane", "gravity"), [("plane: horizontal", 0.0), ("gravity: 9.8 m/s^2", 9.8)])
def test_a_tube_that_is_free_to_turn(plane: str, gravity: float) -> None:
    """(⅓ M L² + m b²) α + 2 m b u w = −(½ M L + m b) g cos θ, and N = m (b α + 2 u w + g cos θ)."""
    said = plane, "", ", tube.angular_velocity: w, tube.angle: 30 deg"
    scene = tube(said, 1.0, "", "al: tube.angular_acceleration, N: track.normal_force", 5.0)
    scene = scene.replace(", end: {}", "").replace(", T: 0.3 s, r: unknown", "")
    pull = gravity * cos(radians(30))
    alpha = (-(0.5 + 0.05) * pull - 2 * 0.1 * 0.5 * 1 * 5) / (1 / 3 + 0.025)
    solution = rotsolve.solve(scene)
    assert solution.answers["al"].float == pytest.approx(alpha)
    assert solution.answers["N"].float == pytest.approx(0.1 * (0.5 * alpha + 10 + pull))
    assert confirmed(solution)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("arm.at(s)]", "arm]", "nothing tells where along `arm` the pin is"),
        ("arm.at(s)]", "arm.at(s)], along: up", "has to run along a rod"),
        ("arm.angle: psi}}", "arm.angle: psi}, later: {crank.angle: 1 rad}}", "from state to state"),
        ("slot: [crank.end, arm.at(s)]", "slot: crank.end", "nothing tells how the slot of `pin` runs"),
        ("slot: [crank.end,", "slot: [[0, 0],", "no body with a pin"),
    ],
)  # fmt: skip
def test_what_no_slot_is(old: str, new: str, words: str) -> None:
    with pytest.raises(Unsolvable, match=words):
        rotsolve.solve(SLOTTED.replace("PHI", "30").replace(old, new).replace(", F: size of pin.force", ""))


def test_a_slot_that_blocks_what_is_driven() -> None:
    scene = SLOTTED.replace("PHI", "30").replace("[crank.end, arm.at(s)]", "crank.end, along: right")
    with pytest.raises(Unsolvable, match="contradict"):
        rotsolve.solve(scene[: scene.index("find")] + "find: {v: crank.end.velocity}\n")


def test_a_pin_is_no_direction_in_space() -> None:
    scene = """title: x
gravity: none
given: {R: 30 cm, w: 3 rad/s}
bodies: {disc: {shape: disc, mass: 1 kg, radius: R}, yoke: {mass: 1 kg, moves: right}}
connections: {ax: {axle: disc, angular_velocity: w}, pin: {slot: [disc.rim, yoke], along: up}}
states: {now: {disc.angle: 20 deg}}
find: {v: yoke.velocity}
"""
    with pytest.raises(Unsolvable, match="direction in space"):
        rotsolve.solve(scene)


WIRE = """title: x
given: {m: 50 g, R: 20 cm, u: 0.5 m/s}
surfaces: {ring: {wire: R}}
bodies: {bead: {mass: m, moves: right BODY}}
connections: {touch: {contact: [bead, ring]}}
states: {top: {touch.angle: 90 deg, bead.velocity: SIGN u}, then: {touch.angle: LAST}}
find: {v: bead.velocity at then, N: touch.normal_force at then, N0: touch.normal_force at top}
"""


@pytest.mark.parametrize(("sign", "angle"), [("", 130), ("", 270), ("-", 40), ("-", -90)])
def test_a_bead_on_a_ring_is_held_on_both_sides(sign: str, angle: int) -> None:
    """½ v² = ½ u² + g R (1 − sin φ), and N = m v²/R − m g sin φ towards the centre, whichever its sign."""
    solution = rotsolve.solve(WIRE.replace(" BODY", "").replace("SIGN ", sign).replace("LAST", f"{angle} deg"))
    square = 0.25 + 2 * 9.8 * 0.2 * (1 - sin(radians(angle)))
    v, push = sqrt(square) * (-1 if sign else 1), 0.05 * (square / 0.2 - 9.8 * sin(radians(angle)))
    found = [solution.answers[name].float for name in ("v", "N", "N0")]
    assert found == pytest.approx([v, push, 0.05 * (1.25 - 9.8)])
    assert solution.answers["N0"].direction == "away from the centre"
    assert confirmed(solution)


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("touch.angle: LAST", "touch: leaves", "does not leave it"),
        (" BODY", ", shape: sphere, radius: 1 cm", "is no particle"),
    ],
)
def test_what_is_not_threaded(old: str, new: str, words: str) -> None:
    with pytest.raises(Unsolvable, match=words):
        rotsolve.solve(WIRE.replace(old, new).replace(" BODY", "").replace("SIGN ", "").replace("LAST", "1 rad"))


COLLAR = """title: x
given: {m: 2 kg, k: 300 N/m, d: 30 cm, l: 20 cm, u: 3 m/s, h: 20 cm}
bodies: {collar: {mass: m, moves: up}}
connections:
  c1: {spring: [[d, 0], collar], stiffness: k, rest_length: l}
  c2: {spring: [collar, [-d, h]], stiffness: 2*k, rest_length: l}
states: {start: {collar.velocity: u}, end: {collar.displacement: h}}
find: {v: collar.velocity at end, a: collar.acceleration at end}
"""


def test_a_collar_between_springs_from_places() -> None:
    """½ m v² + U(y) stays the same, and m a = −dU/dy; the places count from where the collar starts."""

    def stored(y: float) -> float:
        return 150 * (hypot(0.3, y) - 0.2) ** 2 + 300 * (hypot(0.3, 0.2 - y) - 0.2) ** 2 + 2 * 9.8 * y

    solution = rotsolve.solve(COLLAR)
    slope = (stored(0.2 + STEP) - stored(0.2 - STEP)) / (2 * STEP)
    assert solution.answers["v"].float == pytest.approx(sqrt(9 + stored(0) - stored(0.2)))
    assert solution.answers["a"].float == pytest.approx(-slope / 2)
    assert confirmed(solution)


def test_where_a_free_particle_is_nothing_tells() -> None:
    with pytest.raises(Unsolvable, match="where `collar` is in the scene is not told"):
        rotsolve.solve(COLLAR.replace(", moves: up", ""))
