"""Composites against places alone: rigid bodies on all supports, of parts, welded in any order, cut in two, by Lagrange's equation.

What each of the joined bodies has is held against the places of its own mass; nothing here uses a line of the engine but `solve`.
"""

from __future__ import annotations

import math
import random
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import pytest

from rotsolve import Unsolvable, solve

G = 9.8
STEP = 1e-5
Masses = list[tuple[float, float, float]]  # mass, x, y


@dataclass
class Moving:
    """One degree of freedom: α from Lagrange's equation, and velocities and accelerations of all masses, from their places alone."""

    places: Callable[[float], Masses]
    spin_inertia: float  # of what has a moment of inertia of its own
    angle: float
    rate: float

    def __post_init__(self) -> None:
        before, now, after = (self.places(self.angle + step) for step in (-STEP, 0, STEP))
        triples = list(zip(before, now, after, strict=True))
        slope = [((c[1] - a[1]) / (2 * STEP), (c[2] - a[2]) / (2 * STEP)) for a, _, c in triples]
        bend = [((a[1] - 2 * b[1] + c[1]) / STEP**2, (a[2] - 2 * b[2] + c[2]) / STEP**2) for a, b, c in triples]
        masses = [mass for mass, _, _ in now]
        self.now = now
        self.inertia = self.spin_inertia + sum(m * (x * x + y * y) for m, (x, y) in zip(masses, slope, strict=True))
        growth = 2 * sum(m * (x * u + y * w) for m, (x, y), (u, w) in zip(masses, slope, bend, strict=True))
        weight = sum(m * G * y for m, (_, y) in zip(masses, slope, strict=True))
        self.alpha = -(growth * self.rate**2 / 2 + weight) / self.inertia
        self.velocity = [(x * self.rate, y * self.rate) for x, y in slope]
        self.acceleration = [
            (x * self.alpha + u * self.rate**2, y * self.alpha + w * self.rate**2)
            for (x, y), (u, w) in zip(slope, bend, strict=True)
        ]

    def height(self, angle: float) -> float:
        """Σ m g y."""
        return sum(m * G * y for m, _, y in self.places(angle))


def turned(x: float, y: float, angle: float) -> tuple[float, float]:
    return x * math.cos(angle) - y * math.sin(angle), x * math.sin(angle) + y * math.cos(angle)


R, M, N_, Q = 0.3, 2.0, 0.5, 0.4
FORMS = {  # a disc with two lumps: as parts; welded; in another order; cut in two halves, each with a lump
    "parts": (
        "wheel: {MOVES radius: R, parts: {disc: {shape: disc, mass: M, radius: R}, p: {mass: n, at: [x1, y1]}, "
        "q: {mass: k, at: [x2, y2]}}}",
        "",
    ),
    "weld": (
        "wheel: {MOVES shape: disc, mass: M, radius: R, points: {P: [x1, y1], K: [x2, y2]}}\n  p: {mass: n}\n  q: {mass: k}",
        "  one: {weld: [wheel.P, p]}\n  two: {weld: [wheel.K, q]}",
    ),
    "order": (
        "q: {mass: k}\n  p: {mass: n}\n  wheel: {MOVES shape: disc, mass: M, radius: R, points: {P: [x1, y1], K: [x2, y2]}}",
        "  two: {weld: [q, wheel.K]}\n  one: {weld: [p, wheel.P]}",
    ),
    "halves": (
        "wheel: {MOVES shape: disc, mass: M/2, radius: R, points: {P: [x1, y1]}}\n  p: {mass: n}\n  q: {mass: k}\n"
        "  half: {shape: disc, mass: M/2, radius: R, points: {K: [x2, y2]}}\n  nothing: {mass: 0}",
        "  one: {weld: [p, wheel.P]}\n  two: {weld: [half.K, q]}\n  cut: {weld: [half, wheel]}\n  light: {weld: [nothing, half.rim]}",
    ),
}
SUPPORTS = {
    "axle": ("hold: {axle: wheel}", "", ""),
    "hinge": ("hold: {hinge: wheel.P}", "", ""),
    "level": ("hold: {rolls: [wheel, road]}", "moves: right, turns: counterclockwise,", "road: level"),
    "slope": (
        "hold: {rolls: [wheel, road]}",
        "moves: down, turns: counterclockwise,",
        "road: {slope: 20 deg, down: right}",
    ),
}


def placed(support: str, lumps: Sequence[tuple[float, float, float]]) -> Callable[[float], Masses]:
    """Where the masses are when the composite has turned by an angle."""
    masses = [(M, 0.0, 0.0), *lumps]
    if support in ("axle", "hinge"):
        x, y = (0.0, 0.0) if support == "axle" else lumps[0][1:]
        return lambda angle: [(m, *turned(a - x, b - y, angle)) for m, a, b in masses]
    way = 0.0 if support == "level" else -math.radians(20)

    def rolling(angle: float) -> Masses:
        along, places = -R * angle, [(m, *turned(a, b, angle)) for m, a, b in masses]
        return [(m, along * math.cos(way) + a, along * math.sin(way) + b) for m, a, b in places]

    return rolling


def composite(seed: int, form: str, support: str) -> tuple[str, dict[str, float]]:
    """A scene, and what it asks by another calculation."""
    chance = random.Random(seed)
    spots = [(round(chance.uniform(-0.2, 0.2), 2), round(chance.uniform(-0.2, 0.2), 2)) for _ in range(2)]
    places = placed(support, [(N_, *spots[0]), (Q, *spots[1])])
    rate = chance.choice([-3.0, -1.0, 2.0])
    first = Moving(places, M * R * R / 2, 0.0, rate)
    bodies, welds = FORMS[form]
    hold, moves, surface = SUPPORTS[support]
    given = f"R: {R} m, M: {M} kg, n: {N_} kg, k: {Q} kg, x1: {spots[0][0]} m, y1: {spots[0][1]} m"
    asked = {"al": "wheel.angular_acceleration at now", "K": "kinetic_energy at now"}
    true = {"al": first.alpha, "K": first.inertia * rate**2 / 2}
    if form != "parts":
        asked |= {
            "px": "p.momentum.x at now",
            "qy": "q.acceleration.y at now",
            "f": "p.force.x at now",
            "Kp": "p.kinetic_energy at now",
        }
        (vx, vy), (ax, _), (_, qy) = first.velocity[1], first.acceleration[1], first.acceleration[2]
        true |= {"px": N_ * vx, "qy": qy, "f": N_ * ax, "Kp": N_ * (vx**2 + vy**2) / 2}
    if support in ("level", "slope"):
        asked["N"] = "hold.normal_force at now"
        way = 0.0 if support == "level" else -math.radians(20)
        sides = [(ax * -math.sin(way) + (ay + G) * math.cos(way)) for ax, ay in first.acceleration]
        true["N"] = sum(m * side for (m, _, _), side in zip(first.now, sides, strict=True))
    else:
        asked["N"] = "hold.force.y at now"
        true["N"] = sum(m * (ay + G) for (m, _, _), (_, ay) in zip(first.now, first.acceleration, strict=True))
    states = f"now: {{wheel.angular_velocity: {rate} rad/s}}"
    turn = chance.choice([0.2, 0.5]) * math.copysign(1, rate)
    energies = [true["K"] + first.height(0) - first.height(turn * part / 20) for part in range(21)]
    if min(energies) > 0.02:
        last = Moving(places, M * R * R / 2, turn, 1.0)
        states += f", then: {{wheel.rotation: {turn} rad}}"
        asked["w"] = "wheel.angular_velocity at then"
        true["w"] = math.copysign(math.sqrt(2 * energies[-1] / last.inertia), turn)
    find = ", ".join(f"{name}: {path}" for name, path in asked.items())
    scene = (
        f"title: {seed}\ngiven: {{{given}, x2: {spots[1][0]} m, y2: {spots[1][1]} m}}\nsurfaces: {{{surface}}}\n"
        f"bodies:\n  {bodies.replace('MOVES', moves)}\nconnections:\n  {hold.replace('.P', '.p' if form == 'parts' else '.P')}\n"
        f"{welds}\nstates: {{{states}}}\nfind: {{{find}}}\n"
    )
    return scene, true


@pytest.mark.sampled(3)
@pytest.mark.parametrize("support", SUPPORTS)
@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("seed", range(2))
def test_a_composite_moves_as_its_places_say(seed: int, form: str, support: str) -> None:
    scene, true = composite(seed, form, support)
    answers = solve(scene, confirm=False).answers
    assert {name: answers[name].float for name in true} == pytest.approx(true, rel=1e-5, abs=1e-6), scene


@pytest.mark.parametrize("weld", ["load, crate.corner2", "crate.corner2, load"])
@pytest.mark.parametrize(("pulled", "couple"), [("crate.center", 0.0), ("load.top", 8.0)])
def test_the_torque_of_a_weld_to_what_lies_on_a_face(weld: str, pulled: str, couple: float) -> None:
    """Where the floor pushes on a crate nothing tells: the couple of the weld is what keeps the other, F R on its top, from turning."""
    found = solve(f"""
given: {{b: 0.4 m, M: 5 kg, m: 3 kg, R: 0.2 m, F: 40 N, mu: 0.3}}
surfaces: {{floor: level}}
bodies: {{crate: {{shape: rectangle, mass: M, sides: [b, b/2], moves: right}}, load: {{shape: disc, mass: m, radius: R}}}}
connections: {{base: {{contact: [crate, floor], friction: mu}}, bolt: {{weld: [{weld}]}}}}
actions: {{pull: {{force: F, on: {pulled}, direction: right}}}}
states: {{start: {{crate.velocity: 1 m/s}}}}
find: {{q: bolt.torque at start}}
""")
    way = "counterclockwise" if weld.endswith("load") else "clockwise"  # which is that of the last-named, too
    assert found.answers["q"].float == pytest.approx(couple, abs=1e-9)
    assert found.answers["q"].direction == (way if couple else "")
    assert all(item.holds for item in found.derivation.confirmed)


def test_the_torque_of_a_weld_between_two_that_lie_on_faces_is_refused() -> None:
    with pytest.raises(Unsolvable, match="where what carries `two` and `one` pushes on them nothing tells"):
        solve("""
given: {b: 0.4 m, M: 5 kg, F: 40 N}
surfaces: {floor: level}
bodies: {one: {shape: rectangle, mass: M, sides: [b, b], moves: right}, two: {shape: rectangle, mass: M, sides: [b, b]}}
connections:
  under: {contact: [one, floor]}
  base: {contact: [two, floor]}
  bolt: {weld: [one.corner2, two.corner1]}
actions: {pull: {force: F, on: one.corner3, direction: right}}
states: {start: {at rest: all}}
find: {q: bolt.torque at start}
""")
