"""Thin bodies in space: a rod, particles on one line, a principal moment of 0: their ω is across them, since nothing turns them about it.

Values by hand, and every answer by the assembly of all bodies' equations.
"""

from __future__ import annotations

import pytest

from rotsolve import Unsolvable, solve

ROD = "bodies: {b: {shape: rod, mass: M, length: L}}\n"
LIGHT = "gravity: none\ngiven: {M: 2 kg, L: 1 m, J: 3 N s, F: 3 N, w: 2 rad/s}\n"
HEAVY = "given: {M: 2 kg, L: 1 m, J: 3 N s, F: 3 N, w: 5 rad/s, t: 150 deg}\n"
HELD = "connections: {p: {ball: b.start}}\n"
HIT = (
    "states: {before: at rest, after: {}}\n"
    "events: {hit: {impulse: J, on: b.end, direction: [0, 3, 4], from: before, to: after}}\n"
)
PAIR = (
    "bodies: {b: {parts: {one: {shape: particle, mass: M, at: [2 m, 1 m, 2 m]}, two: {shape: particle, mass: M, at: [-2 m, -1 m, -2 m]}},\n"
    "  points: {q: [2 m, 1 m, 2 m]}}}\n"
)
THIN = "bodies: {b: {mass: M, inertia: {principal: [I, 0 kg m^2, I]}, points: {q: [0, L, 0]}}}\n"
CASES = {  # a scene, and what is known of it by hand
    "a free rod struck at its end: ω = 6 J/(M L) across": (
        LIGHT
        + ROD
        + HIT
        + "find: {w_1: b.angular_velocity at after, v: b.end.velocity at after, K: b.kinetic_energy at after}\n",
        {"w_1": (0, -7.2, 5.4), "v": (0, 3.6, 4.8), "K": (9,)},
    ),
    "a rod on a ball joint struck at its end: ω = 3 J/(M L)": (
        LIGHT + ROD + HELD + HIT + "find: {w_1: b.angular_velocity at after, P: p.impulse during hit}\n",
        {"w_1": (0, -3.6, 2.7), "P": (0, 0.9, 1.2)},
    ),
    "a rod on a ball joint let go, level": (
        HEAVY + ROD + HELD + "states: {now: {at rest: all}}\nfind: {al: b.angular_acceleration, N: p.force}\n",
        {"al": (0, 14.7, 0), "N": (0, 0, 4.9)},
    ),
    "a free rod pushed at its end": (
        HEAVY + ROD + "actions: {f: {force: F, on: b.end, direction: y}}\nstates: {now: {at rest: all}}\n"
        "find: {al: b.angular_acceleration, a: b.end.acceleration}\n",
        {"al": (0, 0, 9), "a": (0, 6, -9.8)},
    ),
    "a rod of which a state tells how it turns": (
        LIGHT
        + ROD
        + "states: {now: {b.angular_velocity: [0, w, w]}}\nfind: {L_1: b.angular_momentum, al: b.angular_acceleration}\n",
        {"L_1": (0, 1 / 3, 1 / 3), "al": (0, 0, 0)},
    ),
    "a moment of inertia that is told to be 0": (
        "gravity: none\ngiven: {M: 2 kg, L: 1 m, I: 1 kg m^2, F: 3 N}\n"
        + THIN
        + "actions: {f: {force: F, on: b.q, direction: x}}\n"
        "states: {now: {at rest: all}}\nfind: {al: b.angular_acceleration}\n",
        {"al": (0, 0, -3)},
    ),
    "two particles on an oblique line, one of them struck: it alone moves": (
        LIGHT
        + PAIR
        + HIT.replace("b.end", "b.q").replace("[0, 3, 4]", "[0, 2, -1]")
        + "find: {v: b.q.velocity at after, w_1: b.angular_velocity at after}\n",
        {},
    ),
    "a rod that goes round a cone": (
        HEAVY + ROD.replace("length: L", "length: L, axis: x") + HELD + "states: {now: {b.tilt: t, steady: true}}\n"
        "find: {W: largest b.precession, w_3: b.axial_rate}\n",
        {"W": (4.119963339,), "w_3": (0,)},
    ),
    "a rod on a ball joint that rises": (
        HEAVY
        + ROD.replace("length: L", "length: L, axis: x")
        + HELD
        + "states: {now: {b.tilt: t, b.precession: w, b.nutation: 0 rad/s}, later: {b.tilt: smallest}}\nfind: {th: b.tilt at later}\n",
        {},
    ),
    "a rod whose spin is told": (
        LIGHT
        + ROD
        + "states: {now: {b.angular_velocity: [w, w, 0]}}\nfind: {L_1: b.angular_momentum, K: b.kinetic_energy.rotational}\n",
        {"L_1": (0, 1 / 3, 0), "K": (1 / 3,)},
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_what_is_thin_turns_across_itself(name: str) -> None:
    scene, known = CASES[name]
    derivation = solve(f"title: T\nup: z\n{scene}").complete().derivation
    assert derivation.confirmed
    for item in derivation.confirmed:
        assert item.holds is True, (item.name, item.why)
    for answer in derivation.answers:
        if answer.name in known:
            parts = answer.components or (answer,)
            found = [part.value.float for part in parts if part.value is not None]
            assert found == pytest.approx(known[answer.name], rel=1e-9, abs=1e-9)


def test_what_would_spin_a_thin_body_is_refused() -> None:
    """A torque about the line of a rod, which has no inertia about it: no motion has it."""
    scene = ROD.replace("length: L", "length: L, points: {q: [0, L, 0]}").replace("{b:", "{b:")
    with pytest.raises(Unsolvable) as caught:
        solve(
            f"title: T\nup: z\n{LIGHT}{scene}actions: {{f: {{force: F, on: b.q, direction: z}}}}\n"
            "states: {now: {at rest: all}}\nfind: {al: b.angular_acceleration}\n"
        ).complete()
    assert "contradict" in str(caught.value)
