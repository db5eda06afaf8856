"""What lies on something and sticks to a body on a hinge or an axle goes round with that: the floor neither holds nor turns it back."""

from __future__ import annotations

from math import cos, radians, sin

import numpy
import pytest

from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

M, m, n, L, R, u, w, r = 3.0, 2.0, 4.0, 1.0, 0.5, 3.0, 2.0, 0.1
GIVEN = "title: x\ngiven: {M: 3 kg, m: 2 kg, n: 4 kg, L: 1 m, R: 50 cm, r: 10 cm, u: 3 m/s, w: 2 rad/s, b: 30 deg}\n"
SCENE = GIVEN + "surfaces: {ice: SURFACE}\nbodies: {puck: PUCK, BODIES}\nconnections: {BASE, MORE}\n"
SCENE += "states: {before: {BEFORE}, after: {}}\nevents: {hit: {joins: [ENDS], from: before, to: after}}\n"
SCENE += "find: {W: ONE.angular_velocity at after, Q: lost kinetic_energy during hit}\n"
ROD = {
    "BASE": "base: {contact: [puck, ice]}", "SURFACE": "level", "PUCK": "{mass: m, moves: right}",
    "BODIES": "rod: {shape: rod, mass: M, length: L}",
    "MORE": "pin: {hinge: rod.start}", "BEFORE": "rod.angle: -90 deg, at rest: rod, puck.velocity: u",
    "ENDS": "puck, rod.end", "ONE": "rod",
}  # fmt: skip


def scene(**changes: str) -> str:
    text = SCENE
    for word, value in (ROD | changes).items():
        text = text.replace(word, value)
    return text


def held(inertia: float, gained: float, momentum: float, energy: float) -> tuple[float, float]:
    """Angular velocity and loss of a body about a fixed axis that gets a moment of inertia, with all angular momentum before."""
    rate = momentum / (inertia + gained)
    return rate, energy - momentum * rate / 2


def on_a_cart() -> tuple[float, float]:
    """Cart v, rod ω: the puck at the end of the rod has v + L ω."""
    masses = numpy.array([[n + M + m, (M / 2 + m) * L], [(M / 2 + m) * L, (M / 3 + m) * L**2]])
    rates = numpy.linalg.solve(masses, [m * u, m * u * L])
    return float(rates[1]), m * u**2 / 2 - float(rates @ masses @ rates) / 2


CART = "cart: {mass: n, moves: right}, rod: {shape: rod, mass: M, length: L}"
STANDS = "rod.angle: -90 deg, at rest: [rod, cart], puck.velocity: u"
STILL = {"BEFORE": "rod.angle: -60 deg, rod.angular_velocity: w, at rest: puck"}
ROLLING = m * u * L - 0.4 * m * r * u  # it rolls clockwise
CASES = {
    "a rod that hangs": ({}, held(M / 3, m, m * u * L, m * u**2 / 2)),
    "named the other way": ({"ENDS": "rod.end, puck"}, held(M / 3, m, m * u * L, m * u**2 / 2)),
    "from the right": ({"PUCK": "{mass: m, moves: left}"}, held(M / 3, m, -m * u * L, m * u**2 / 2)),
    "a rod that slants": (STILL, held(M / 3, m, M / 3 * w, M / 6 * w**2)),
    "a puck at a rod that slants": (
        {"BEFORE": "rod.angle: -60 deg, at rest: rod, puck.velocity: u"},
        held(M / 3, m, m * u * sin(radians(60)), m * u**2 / 2),
    ),
    "a rough floor": (
        {"BASE": "base: {contact: [puck, ice], friction: 0.4}", **STILL},
        held(M / 3, m, M / 3 * w, M / 6 * w**2),
    ),
    "on a slope": (
        {"SURFACE": "{slope: b, down: right}", "PUCK": "{mass: m, moves: down}",
         "BEFORE": "rod.angle: -90 deg - b, at rest: rod, puck.velocity: u"},
        held(M / 3, m, m * u * L, m * u**2 / 2),
    ),
    "on the axle of a wheel": (
        {"BODIES": "disc: {shape: disc, mass: M, radius: R}", "MORE": "pin: {axle: disc}", "ENDS": "puck, disc.bottom", "ONE": "disc",
         "BEFORE": "disc.angular_velocity: w, at rest: puck"},
        held(M * R**2 / 2, m * R**2, M * R**2 / 2 * w, M * R**2 / 4 * w**2),
    ),
    "with a bob on the rod": (
        {"BODIES": "rod: {shape: rod, mass: 0, length: L}, bob: {shape: disc, mass: M, radius: R}",
         "MORE": "pin: {hinge: rod.start}, glue: {weld: [rod.end, bob.center]}"},
        held(M * (L**2 + R**2 / 2), m, m * u * L, m * u**2 / 2),
    ),
    "off a cart": (
        {"BODIES": f"under: {{mass: n, moves: right}}, {ROD['BODIES']}",
         "BEFORE": "rod.angle: -90 deg, at rest: [rod, under], puck.velocity: u",
         "BASE": "low: {contact: [under, ice]}, base: {contact: [puck, under], friction: none}"},
        held(M / 3, m, m * u * L, m * u**2 / 2),
    ),
    "hung from a cart": (
        {"BODIES": CART, "MORE": "under: {contact: [cart, ice]}, pin: {hinge: [cart, rod.start]}", "BEFORE": STANDS}, on_a_cart(),
    ),
    "hung from a cart that is named last": (
        {"BODIES": CART, "MORE": "under: {contact: [cart, ice]}, pin: {hinge: [rod.start, cart]}", "BEFORE": STANDS}, on_a_cart(),
    ),
}  # fmt: skip


@pytest.mark.parametrize(("changes", "true"), CASES.values(), ids=CASES)
def test_what_sticks_to_a_body_on_a_hinge_leaves_what_it_lay_on(
    changes: dict[str, str], true: tuple[float, float]
) -> None:
    answers = solve(scene(**changes)).answers
    assert [answers[name].float for name in "WQ"] == pytest.approx(true)


def test_a_rolling_ball_takes_its_spin_along() -> None:
    answers = solve(
        scene(PUCK="{shape: sphere, mass: m, radius: r, moves: right}", BASE="base: {rolls: [puck, ice]}")
    ).answers
    true = held(M / 3, m * L**2 + 0.4 * m * r**2, ROLLING, 0.7 * m * u**2)
    assert [answers[name].float for name in "WQ"] == pytest.approx(true)


@pytest.mark.parametrize(("mass", "load", "length", "angle"), [(3, 1, 1, 60), (0.7, 2.3, 1.9, 25), (5, 0.4, 0.6, 80)])
def test_in_letters_the_loss_is_that_of_the_bodies_alone(mass: float, load: float, length: float, angle: float) -> None:
    text = scene(BEFORE="rod.angle: -90 deg, at rest: puck").replace("M: 3 kg, m: 2 kg", "M: kg, m: kg, theta: rad")
    text = text.replace("L: 1 m", "L: m").replace(
        "states: {", "states: {start: {rod.angle: -90 deg - theta, at rest: all}, "
    )
    true = 3 * mass * load * 9.8 * length * (1 - cos(radians(angle))) / (2 * (mass + 3 * load))
    formula = solve(text.replace("W: rod.angular_velocity at after, ", ""), confirm=False).answers["Q"].sympy
    values = {"M": mass, "m": load, "L": length, "theta": radians(angle), "g": 9.8}
    found = formula.subs({letter: values[letter.name] for letter in formula.free_symbols})
    assert float(found) == pytest.approx(true)


@pytest.mark.parametrize(
    ("changes", "named"),
    [
        ({"BEFORE": "rod.angle: 90 deg, at rest: rod, puck.velocity: u"}, "puck is pressed into what it lies on"),
        ({"BEFORE": "rod.angle: -60 deg, rod.angular_velocity: -w, at rest: puck"}, "puck is pressed into what it lies on"),
        ({"BEFORE": "rod.angle: -120 deg, at rest: rod, puck.velocity: u"}, "puck is pressed into what it lies on"),
    ],
)  # fmt: skip
def test_what_would_go_into_the_floor_is_refused(changes: dict[str, str], named: str) -> None:
    for asked in ("W: rod.angular_velocity at after, ", ""):
        with pytest.raises(Unsolvable, match=named):
            solve(scene(**changes).replace("W: rod.angular_velocity at after, ", asked))


def test_what_comes_back_to_the_floor_is_refused() -> None:
    text = scene(**STILL).replace("after: {}}", "after: {}, top: {rod.angle: largest}, back: {rod.angle: -70 deg}}")
    with pytest.raises(Unsolvable, match="puck comes back to what it lay on"):
        solve(text.replace("at after", "at back"))
    answers = solve(text.replace(", back: {rod.angle: -70 deg}", "")).answers
    assert answers["W"].float == pytest.approx(held(M / 3, m, M / 3 * w, 0)[0])
