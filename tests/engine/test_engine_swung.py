"""A body on a spring goes to and fro: at a told time it moves as x₀ cos ω t + (v₀/ω) sin ω t says, whichever turn it is on."""

from __future__ import annotations

import math

import pytest

from rotsolve.pipeline import solve

BODIES = {  # with the mass that moves over m
    "block": ("{mass: m, moves: WAY}", "", "", 1.0),
    "wheel": (
        "{shape: disc, mass: m, radius: 30 cm, moves: WAY}",
        "surfaces: {floor: level}\n",
        "base: {rolls: [body, floor]}, ",
        1.5,
    ),
}
WAYS = [("block", way) for way in ("up", "down", "right", "left")] + [("wheel", way) for way in ("right", "left")]


@pytest.mark.sampled(3)
@pytest.mark.parametrize("anchor", ["ground", "ceiling"])
@pytest.mark.parametrize("time", [0.2, 0.7, 1.3, 2.9])
@pytest.mark.parametrize(("name", "way"), WAYS)
def test_velocity_and_momentum_at_a_time(name: str, way: str, time: float, anchor: str) -> None:
    body, surface, rolls, share = BODIES[name]
    scene = f"""
given: {{m: 2 kg, k: 57 N/m, x: 0.5 m, v: 2 m/s, g: 9.8 m/s^2}}
{surface}bodies: {{body: {body.replace("WAY", way)}}}
connections: {{{rolls}coil: {{spring: [{anchor}, body], stiffness: k}}}}
states: {{start: {{coil.elongation: x, body.velocity: v}}, end: {{time: {time} s}}}}
find: {{p: body.momentum.AXIS at end, e: coil.elongation at end}}
""".replace("AXIS", "y" if way in ("up", "down") else "x")
    upright, along = way in ("up", "down"), 1 if way in ("up", "right") else -1
    outward = (
        (1 if anchor == "ground" else -1) if upright else 1
    )  # the spring lies on the left of what travels sideways
    omega, weight = math.sqrt(57 / (2 * share)), -9.8 * 2 / 57 * outward if upright else 0.0
    x, v = 0.5 - weight, 2 * along * outward
    stretch = weight + x * math.cos(omega * time) + v / omega * math.sin(omega * time)
    speed = outward * (-x * omega * math.sin(omega * time) + v * math.cos(omega * time))
    solution = solve(scene, digits=9, confirm=False)
    found = {key: answer.float for key, answer in solution.answers.items()}
    assert found == pytest.approx({"p": 2 * speed, "e": stretch}, rel=1e-7)
