"""What lets go is said beside every answer about it, also where other answers are withheld or refused for it."""

from __future__ import annotations

import pytest

from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.pipeline import solve

BOXES = """
title: A box pulled up so steeply that it lifts off, beside another
given: {m: 1 kg, F: 30 N}
surfaces: {floor: level}
bodies: {p: {mass: m, moves: right}, q: {mass: 2*m, moves: right}}
connections: {one: {contact: [p, floor], friction: 0.2}, two: {contact: [q, floor], friction: 0.1}}
actions: {f: {force: F, on: p, direction: 50 deg}, h: {force: 2*F, on: q, direction: 10 deg}}
states: {s: {p.velocity: 1 m/s, q.velocity: 1 m/s}, e: {time: 2 s}}
"""
BEAD = """
title: A bead that is too fast to stay on a dome
given: {m: 1 kg, R: 1 m}
surfaces: {hill: {dome: R}}
bodies: {p: {mass: m}}
connections: {one: {contact: [p, hill], friction: none}}
states: {s: {one.angle: 40 deg, p.velocity: 3 m/s}, e: {one.angle: 30 deg}}
"""
LIFT = """
title: Two loads on a string, one of which is lifted
given: {m: 1 kg, Q: 20 N}
bodies: {p: {mass: m, moves: down}, wheel: {shape: disc, mass: m, radius: 10 cm}, q: {mass: m, moves: up}}
connections: {pin: {axle: wheel}, one: {string: [p, wheel, q]}}
actions: {push: {force: Q, on: p, direction: down}, lift: {force: 3*Q, on: q, direction: up}}
states: {s: at rest, e: {time: 1 s}}
"""
AT = {  # the scene, with what is asked where something lets go, and what is asked of later
    "box": (
        BOXES,
        "a: p.acceleration at s, N: one.normal_force at s, r: one.friction_force at s",
        "v: p.velocity at e, E: kinetic_energy at e, W: f.work from s to e",
    ),
    "bead": (BEAD, "a: p.acceleration.x at s, N: one.normal_force at s", "v: p.speed at e, M: one.normal_force at e"),
    "load": (
        LIFT,
        "a: p.acceleration at s, T: one.p.tension at s",
        "v: p.velocity at e, K: kinetic_energy at e",
    ),
}
SAID = {"box": "p leaves the surface", "bead": "p leaves the surface", "load": "the string goes slack"}


@pytest.mark.parametrize("kind", AT)
@pytest.mark.parametrize("asked", [(0,), (0, 1), (1, 0)])
def test_what_lets_go_is_said_beside_what_is_answered(kind: str, asked: tuple[int, ...]) -> None:
    scene, *parts = AT[kind]
    finds = [line.strip() for part in asked for line in parts[part].split(",")]
    seen = 0
    for number in range(len(finds)):
        some = finds[number:] + finds[:number] if len(asked) > 1 else finds[number : number + 1]
        try:
            solution = solve(f"{scene}find: {{{', '.join(some)}}}\n")
        except (Unsolvable, SceneError):
            continue
        said = ["".join(map(str, check.words)) for check in solution.checks if check.holds is False]
        assert not solution.answers or any(SAID[kind] in words for words in said), (some, solution.answers)
        seen += bool(solution.answers)
    assert seen
