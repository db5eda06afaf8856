"""Trains of wheels on fixed axles and on bodies that carry them, against Lagrange's equations in the independent turns."""

from __future__ import annotations

from math import cos, radians

import numpy as np
import pytest

from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.pipeline import solve

G, A, B, M, Q = 9.8, 0.12, 0.04, 1.5, 0.6
SUN, PLANET, CARRIER, RING = 0.02, 0.003, 0.05, 0.09
ANGLE = radians(25)
GIVEN = "title: x\ngiven: {a: 12 cm, b: 4 cm, m: 1.5 kg, Q: 0.6 N m, W: 6 rad/s, w: 2 rad/s,\n"
GIVEN += "  Is: 0.02 kg m^2, Ip: 0.003 kg m^2, Ic: 0.05 kg m^2, Ir: 0.09 kg m^2}\n"
BODIES = """bodies:
  sun: {inertia: Is, radius: a}
  ring: {inertia: Ir, radius: a + 2*b}
  planet: {mass: m, inertia: Ip, radius: b}
  carrier: {inertia: Ic, mass: 0, points: {P: [LENGTH, 0]}}
"""
AXLES = "  s: {axle: sun}\n  r: {axle: ring}\n  c: {axle: carrier}\n  p: {hinge: [carrier.P, planet.center]}\n"
TURN = "actions: {turn: {couple: Q, on: carrier}}\n"


def scene(
    links: str, actions: str, state: str, find: str, gravity: str = "gravity: none\n", length: str = "a + b"
) -> str:
    bodies = BODIES.replace("LENGTH", length)
    return (
        f"{GIVEN}{gravity}{bodies}connections:\n{AXLES}{links}{actions}states: {{now: {{{state}}}}}\nfind: {{{find}}}\n"
    )


def accelerations(rows: list[list[float]], inertias: list[float], torques: list[float]) -> np.ndarray:
    """Of the independent turns: bodies turn by `rows` times these; (Σ I rᵀ r) α = Σ rᵀ τ."""
    turns = np.array(rows)
    return np.linalg.solve(turns.T @ np.diag(inertias) @ turns, turns.T @ np.array(torques))


# independent turns: sun, carrier; planet Ω − (a/b)(ω_s − Ω); ring Ω + (b/(a + 2 b)) (ω_p − Ω)
PLANET_ROW = [-A / B, 1 + A / B]
RING_ROW = [-A / (A + 2 * B), 1 + A / (A + 2 * B)]
ORBIT = CARRIER + M * (A + B) ** 2
ALL = "alpha: sun.angular_acceleration, beta: carrier.angular_acceleration, gamma: planet.angular_acceleration"
REST = "at rest: all"


@pytest.mark.parametrize("order", ["sun, planet", "planet, sun"])
def test_a_planet_round_a_free_sun(order: str) -> None:
    answers = solve(scene(f"  g: {{gear: [{order}]}}\n", TURN, REST, ALL)).answers
    true = accelerations([[1, 0], [0, 1], PLANET_ROW], [SUN, ORBIT, PLANET], [0, Q, 0])
    assert answers["alpha"].float == pytest.approx(true[0], rel=1e-9)
    assert answers["beta"].float == pytest.approx(true[1], rel=1e-9)
    assert answers["gamma"].float == pytest.approx(np.dot(PLANET_ROW, true), rel=1e-9)


def test_a_planet_between_sun_and_ring() -> None:
    links = "  g: {gear: [sun, planet]}\n  h: {gear: [planet, ring], inside: true}\n"
    answers = solve(scene(links, TURN, REST, ALL + ", delta: ring.angular_acceleration")).answers
    true = accelerations([[1, 0], [0, 1], PLANET_ROW, RING_ROW], [SUN, ORBIT, PLANET, RING], [0, Q, 0, 0])
    assert answers["alpha"].float == pytest.approx(true[0], rel=1e-9)
    assert answers["delta"].float == pytest.approx(np.dot(RING_ROW, true), rel=1e-9)


def test_the_weight_of_a_planet_turns_the_train() -> None:
    links, state = "  g: {gear: [sun, planet]}\n", "at rest: all, carrier.angle: 25 deg"
    answers = solve(scene(links, "", state, ALL, gravity="")).answers
    weight = -M * G * (A + B) * cos(ANGLE)
    true = accelerations([[1, 0], [0, 1], PLANET_ROW], [SUN, ORBIT, PLANET], [0, weight, 0])
    assert answers["alpha"].float == pytest.approx(true[0], rel=1e-9)
    assert answers["beta"].float == pytest.approx(true[1], rel=1e-9)


@pytest.mark.parametrize(("crossed", "way"), [("", 1), (", crossed: true", -1)])
def test_a_belt_to_a_wheel_on_a_moving_arm(crossed: str, way: int) -> None:
    """a (ω_s − Ω) = ± b (ω_p − Ω), at any distance of the centres."""
    links = f"  g: {{belt: [sun, planet]{crossed}}}\n"
    row = [way * A / B, 1 - way * A / B]
    answers = solve(scene(links, TURN, REST, ALL, length="2*a")).answers
    orbit = CARRIER + M * (2 * A) ** 2
    true = accelerations([[1, 0], [0, 1], row], [SUN, orbit, PLANET], [0, Q, 0])
    assert answers["alpha"].float == pytest.approx(true[0], rel=1e-9)
    assert answers["gamma"].float == pytest.approx(np.dot(row, true), rel=1e-9)


@pytest.mark.parametrize(
    ("link", "true"),
    [
        ("gear: [sun, planet]", 6 - A / B * (2 - 6)),
        ("gear: [planet, sun]", 6 - A / B * (2 - 6)),
        ("belt: [sun, planet]", 6 + A / B * (2 - 6)),
        ("belt: [planet, sun], crossed: true", 6 - A / B * (2 - 6)),
    ],
)
def test_turns_are_those_seen_from_the_carrier(link: str, true: float) -> None:
    state = "sun.angular_velocity: w, carrier.angular_velocity: W"
    answers = solve(scene(f"  g: {{{link}}}\n", "", state, "n: planet.angular_velocity")).answers
    assert answers["n"].float == pytest.approx(true, rel=1e-9)


def test_two_wheels_on_one_truck() -> None:
    """A truck that travels does not turn: the rims run as on fixed axles, and the truck goes on by itself."""
    text = (
        GIVEN
        + "surfaces: {road: level}\nbodies:\n  truck: {mass: 2*m, moves: right, points: {P: [0, 0], Q_: [a + b, 0]}}\n"
    )
    text += "  sun: {mass: m, inertia: Is, radius: a}\n  planet: {mass: m, inertia: Ip, radius: b}\n"
    text += (
        "connections:\n  on_: {contact: [truck, road]}\n  s: {axle: [truck.P, sun]}\n  p: {axle: [truck.Q_, planet]}\n"
    )
    text += "  g: {gear: [sun, planet]}\nactions: {turn: {couple: Q, on: sun}}\nstates: {now: at rest}\n"
    answers = solve(text + "find: {alpha: planet.angular_acceleration, a_: truck.acceleration}\n").answers
    assert answers["alpha"].float == pytest.approx(-(A / B) * Q / (SUN + PLANET * (A / B) ** 2), rel=1e-9)
    assert answers["a_"].float == 0


def test_the_force_of_the_teeth_presses_on_the_axles() -> None:
    """The second of two wheels on fixed axles stands on the right: the first, turned counterclockwise, lifts its left side."""
    text = GIVEN + "gravity: none\nbodies: {sun: {inertia: Is, radius: a}, planet: {inertia: Ip, radius: b}}\n"
    text += "connections: {s: {axle: sun}, p: {axle: planet}, g: {gear: [sun, planet]}}\nactions: {turn: {couple: Q, on: sun}}\n"
    answers = solve(text + "find: {F: g.force.y, S: s.force.y, P: p.force.y}\n").answers
    force = PLANET / B * (A / B) * Q / (SUN + PLANET * (A / B) ** 2)
    assert [answers[name].float for name in ("F", "S", "P")] == pytest.approx([force, force, -force], rel=1e-9)


@pytest.mark.parametrize(
    ("text", "named"),
    [
        (scene("  g: {gear: [sun, planet]}\n", TURN, REST, ALL, length="a + 3*b"), "carrier"),
        (
            scene(
                "  g: {gear: [planet, ring], inside: true}\n", TURN, REST, "n: planet.angular_acceleration", length="a"
            ),
            "carrier",
        ),
        (
            GIVEN
            + "gravity: none\nbodies: {sun: {inertia: Is, radius: a}, planet: {mass: m, inertia: Ip, radius: b}}\n"
            "connections: {s: {axle: sun}, g: {gear: [sun, planet]}}\nactions: {turn: {couple: Q, on: sun}}\n"
            "find: {alpha: planet.angular_acceleration}\n",
            "planet",
        ),
        (
            GIVEN
            + "gravity: none\nbodies: {sun: {inertia: Is, radius: a}, planet: {shape: disc, mass: m, radius: b}}\n"
            "connections: {s: {axle: sun}, p: {hinge: planet.rim}, g: {gear: [sun, planet]}}\nactions: {turn: {couple: Q, on: sun}}\n"
            "find: {alpha: planet.angular_acceleration}\n",
            "planet",
        ),
        (
            GIVEN + "bodies: {sun: {inertia: Is, radius: a}, planet: {mass: m, inertia: Ip, radius: b}}\n"
            "connections: {s: {axle: sun}, p: {axle: planet}, g: {belt: [sun, planet]}}\nactions: {turn: {couple: Q, on: sun}}\n"
            "find: {F: p.force}\n",
            "`g`",
        ),
    ],
    ids=["too far", "too near inside", "loose wheel", "wheel off its centre", "axle of a belt"],
)
def test_what_is_not_told_is_refused_by_name(text: str, named: str) -> None:
    with pytest.raises((Unsolvable, SceneError), match=named):
        solve(text)
