"""Where something acts on a body that is named without a point: at its centre, else at its centre of mass, for all that acts on bodies."""

from __future__ import annotations

import pytest

from rotsolve import solve

# a body, and the point for which it stands: no rim and parts, a rim and parts, no centre, a centre that is not its centre of mass
HAMMER = "{parts: {a: {shape: rod, mass: m, start: [0, 0], end: [L, 0]}, b: {mass: M, at: [L, 0]}}, points: {P: [0.2 m, 0.1 m]}}"
LOADED = "{radius: L, parts: {a: {shape: disc, mass: M, radius: L}, b: {mass: m, at: [L/2, 0]}}, points: {P: [0.2 m, 0.1 m]}}"
BODIES = {
    "a hammer": (HAMMER, "cm"),
    "a loaded wheel": (LOADED, "center"),
    "a triangle": ("{shape: triangle, mass: M, sides: [3 m, 4 m, 5 m], points: {P: [0.2 m, 0.1 m]}}", "cm"),
    "a half ball": ("{shape: hemisphere, mass: M, radius: L, points: {P: [0.2 m, 0.1 m]}}", "center"),
    "a rod": ("{shape: rod, mass: M, length: L, points: {P: [0.2 m, 0.1 m]}}", "center"),
}
GIVEN = "given: {L: 1.4 m, M: 5.5 kg, m: 2.5 kg, F: 4.8 N, J: 4.8 N s, u: 2 m/s, k: 40 N/m, x: 40 cm}"
RESTS = "states: {start: {one.angle: 0, at rest: all}}\nfind: {y: one.angular_acceleration}"
STRUCK = "states: {start: {one.angle: 0, at rest: [one], two.velocity: u}, after: {}}\nfind: {y: one.angular_velocity at after}"
PIN = "connections: {pin: {hinge: one.P}, coil: {spring: [two, ONE], stiffness: k}}"
STRETCHED = "states: {start: {one.angle: 0, at rest: all, coil.elongation: x}}\nfind: {y: one.angular_acceleration}"
ACTS = {
    "a force": ("gravity: none", "actions: {push: {force: F, on: ONE, direction: up}}\n" + RESTS),
    "a blow": (
        "gravity: none",
        "events: {hit: {impulse: J, on: ONE, direction: up, from: start, to: after}}\n" + STRUCK,
    ),
    "what sticks": ("gravity: none", "events: {hit: {joins: [two, ONE], from: start, to: after}}\n" + STRUCK),
    "a bounce": (
        "gravity: none",
        "events: {hit: {collides: [two, ONE], restitution: 0.5, from: start, to: after}}\n" + STRUCK,
    ),
    "a spring": ("gravity: none", f"{PIN}\n{STRETCHED}"),
    "a string": ("gravity: 9.8 m/s^2", PIN.replace("spring", "string").replace(", stiffness: k", "") + "\n" + RESTS),
    "an axle": (
        "gravity: 9.8 m/s^2",
        "connections: {pin: {hinge: one.P}, stud: {axle: [ONE, three]}}\n" + RESTS,
    ),
}


def answer(body: str, head: str, text: str, one: str) -> float:
    two = "two: {mass: m, moves: up}" if "two" in text else "three: {shape: disc, mass: m, radius: 20 cm}"
    scene = f"{head}\n{GIVEN}\nbodies: {{one: {body}, {two}}}\n{text.replace('ONE', one)}\n"
    solution = solve(scene if "two" in text or "three" in text else scene.replace(f", {two}", ""))
    assert all(item.holds for item in solution.derivation.confirmed)
    value = solution.answers["y"].float
    assert value is not None
    return value


PAIRS = [
    (kind, act) for kind in BODIES for act in ACTS if (kind, act) != ("a loaded wheel", "a string")
]  # round its rim


@pytest.mark.parametrize(("kind", "act"), PAIRS)
def test_a_body_named_alone_stands_for_its_centre_else_its_centre_of_mass(kind: str, act: str) -> None:
    body, point = BODIES[kind]
    alone, named = (answer(body, *ACTS[act], one) for one in ("one", f"one.{point}"))
    assert alone == pytest.approx(named, abs=1e-12)


def test_a_force_at_the_centre_of_mass_does_not_turn_a_free_body() -> None:
    assert answer(HAMMER, *ACTS["a force"], "one") == 0
