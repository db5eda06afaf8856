"""Lagrange's equations in space: values by hand, with which coordinates, and what is refused since it ties rates alone.

The bundled problems by this law are in tests/problems; here are motions that are not steady, and what is carried round.
"""

from __future__ import annotations

import math

import pytest

from rotsolve import Unsolvable, solve
from rotsolve.solution import Solution

TOP = "bodies: {top: {mass: M, inertia: {about: tip, principal: [I1, I2, I3]}, axis: z, points: {tip: [0, 0, -l]}}}\n"
HELD = "connections: {floor: {ball: top.tip}}\n"
GIVEN = "given: {M: 0.2 kg, l: 0.05 m, I1: 6e-4 kg m^2, I2: 6e-4 kg m^2, I3: 8e-5 kg m^2, th: 25 deg, g: 9.8 m/s^2}\n"
MOVING = "states: {now: {top.tilt: th, top.precession: 3 rad/s, top.nutation: 2 rad/s, top.spin: 100 rad/s}}\n"
ARM = "arm: {shape: rod, mass: 0, length: 2*r, points: {P: [r, 0, 0]}}"
CARRIED = "given: {m: 2 kg, L: 0.6 m, r: 0.5 m, w: 3 rad/s, b: 2 rad/s^2, ph: 40 deg, g: 9.8 m/s^2}\n"
ROD = "rod: {shape: rod, mass: m, length: L}"
LEAN, SPIN = math.radians(25), 100 + 3 * math.cos(math.radians(25))
NODDING = (6e-4 * 9 * math.sin(LEAN) * math.cos(LEAN) + (0.2 * 9.8 * 0.05 - 8e-5 * SPIN * 3) * math.sin(LEAN)) / 6e-4
PHI = math.radians(40)

CASES = {  # a scene, what is known of it by hand, and what its page says
    "a top that nods: I₁ θ̈ = I₁ φ̇² sin θ cos θ − I₃ ω₃ φ̇ sin θ + M g l sin θ": (
        GIVEN + TOP + HELD + MOVING + "find: {al: top.angular_acceleration.x in node axes}\n",
        {"al": NODDING + 3 * 100 * math.sin(LEAN)},  # α₁ = θ̈ + φ̇ ψ̇ sin θ
        ("φ is cyclic", "ψ is cyclic", "V = M g l cos θ"),
    ),
    "a bead on an arm that speeds up: ẍ = w² x along it": (
        CARRIED + "gravity: none\nbodies: {" + ARM + ", bead: {shape: particle, mass: m}}\n"
        "connections: {hub: {hinge: arm.start, along: z, angular_velocity: w, angular_acceleration: b},\n"
        "  guide: {slide: [arm.P, bead], along: x}}\n"
        "states: {now: {bead.velocity relative to arm: [0, 0, 0]}}\nfind: {a: bead.acceleration.x relative to arm}\n",
        {"a": 2 * 0.5 * 9},
        ("way of bead along guide",),
    ),
    "a rod hinged to an arm that turns steadily: α = 3 g cos φ/(2 L) less what carries it round": (
        CARRIED + "bodies: {" + ARM + ", " + ROD + "}\n"
        "connections: {hub: {hinge: arm.start, along: z, angular_velocity: w},\n"
        "  pin: {hinge: [arm.P, rod.start], along: y}}\n"
        "states: {now: {rod.angle: ph, rod.angular_velocity: 0}}\nfind: {al: rod.angular_acceleration.y}\n",
        {"al": 3 * (9.8 * math.cos(PHI) - 2 * 0.5 * 9 * math.sin(PHI)) / (2 * 0.6) - 9 * math.sin(PHI) * math.cos(PHI)},
        ("angle of rod about pin",),
    ),
}


def by_lagrange(text: str) -> Solution:
    return solve("up: z\n" + text, law="lagrange")


@pytest.mark.parametrize("case", CASES)
def test_what_is_known_by_hand(case: str) -> None:
    text, known, said = CASES[case]
    found, plain = by_lagrange(text), solve("up: z\n" + text)
    page = found.to("text", width=200)
    assert "Lagrange's equation, " in page and "used as well" not in page
    assert all(words in page for words in said), page
    for name, answer in found.answers.items():
        assert answer.float == pytest.approx(known[name], rel=1e-12)
        assert plain.answers[name].float == pytest.approx(known[name], rel=1e-12)


def test_a_body_without_symmetry_has_psi_in_its_energy() -> None:
    """I₁ ≠ I₂: ψ is not cyclic, and the answer is that of Euler's equations."""
    text = GIVEN.replace("I2: 6e-4", "I2: 6.5e-4") + TOP + HELD + MOVING
    text += "find: {al: top.angular_acceleration.x in body axes, be: top.angular_acceleration.y in body axes}\n"
    found, plain = by_lagrange(text), solve("up: z\n" + text)
    page = str(found)
    assert "φ is cyclic" in page and "ψ is cyclic" not in page
    for name in ("al", "be"):
        assert found.answers[name].float == pytest.approx(plain.answers[name].float, rel=1e-12)


REFUSED = {  # a scene, and words of its refusal
    "what rolls": (
        GIVEN
        + "bodies: {w: {shape: disc, mass: M, radius: l}}\nsurfaces: {table: level}\nconnections: {t: {rolls: [w, table]}}\n"
        "states: {now: {w.tilt: 80 deg, w.precession: 1 rad/s, steady: true}}\nfind: {s: w.spin}\n",
        "nonholonomic",
    ),
    "what is told by ω along its own axes": (
        GIVEN + "gravity: none\nbodies: {b: {mass: M, inertia: {principal: [I1, 2*I1, 3*I1]}}}\n"
        "states: {now: {b.angular_velocity: [1 rad/s, 2 rad/s, 3 rad/s]}}\nfind: {al: b.angular_acceleration in body axes}\n",
        "no rates of coordinates",
    ),
}


@pytest.mark.parametrize("case", REFUSED)
def test_what_is_refused_says_why(case: str) -> None:
    text, words = REFUSED[case]
    with pytest.raises(Unsolvable) as refusal:
        by_lagrange(text)
    assert words in str(refusal.value) and "it takes Newton's laws" in str(refusal.value)


def test_a_couple_whose_work_nobody_tells_leaves_the_energy_open() -> None:
    """T + V grows by τ φ: it must not be taken to stay."""
    text = (
        "gravity: none\ngiven: {m: 2 kg, a: 0.5 m, tau: 3 N m, th: 90 deg}\n"
        "bodies: {gate: {shape: cuboid, mass: m, sides: [a, a, a]}}\n"
        "connections: {post: {hinge: gate.center, along: z}}\nactions: {push: {couple: tau, on: gate, direction: z}}\n"
        "states: {start: {at rest: all, gate.angle: 0}, later: {gate.angle: th}}\n"
        "find: {w: gate.angular_velocity.z at later, al: gate.angular_acceleration.z at start}\n"
    )
    found = by_lagrange(text)
    assert set(found.refused) == {"w"} and found.answers["al"].float == pytest.approx(36, rel=1e-12)
