"""Leading order: `assume: [m << M]` tells beside an exact answer what it comes to in the limit."""

from __future__ import annotations

import pytest

from rotsolve import solve
from rotsolve.core.faults import SceneError

PULLEY = (
    "title: t\nassume: [m << M]\ngiven: {m: 10 g, M: 5 kg, R: 20 cm, h: 1 m, g: 9.8 m/s^2}\n"
    "bodies: {load: {mass: m, moves: down}, disc: {shape: disc, mass: M, radius: R, turns: clockwise}}\n"
    "connections: {axle: {axle: disc}, s: {string: [disc, load]}}\nstates: {A: at rest, B: {load.displacement: h}}\n"
)
HIT = (
    "title: t\nassume: [m << M]\nplane: horizontal\ngiven: {m: kg, M: kg, u: m/s, e: E}\n"
    "bodies: {one: {mass: m, moves: right}, two: {mass: M, moves: right}}\n"
    "states: {A: {one.velocity: u, two.velocity: 0}, B: {}}\n"
    "events: {hit: {collides: [one, two], restitution: e, from: A, to: B}}\n"
)


@pytest.mark.parametrize(
    ("of", "find", "said"),
    [
        (PULLEY, "load.acceleration at A", "≈ 2 m g/M = 0.0392 m/s² for m ≪ M"),
        (PULLEY, "s.tension at A", "≈ m g = 0.098 N for m ≪ M"),
        (PULLEY, "load.velocity at B", "≈ 2 √(m g h/M) = 0.28 m/s for m ≪ M"),
        (PULLEY, "m*g - s.tension at A", "≈ 2 m² g/M"),
        (PULLEY, "s.tension/disc.mass at A", "for m ≪ M"),
        (HIT.replace("E", "number"), "one.velocity at B", "≈ −e u for m ≪ M"),
        (HIT.replace("E", "number"), "two.kinetic_energy at B", "≈ m² u² (1 + e)²/(2 M) for m ≪ M"),
        (HIT.replace("E", "number"), "(two.kinetic_energy at B)/(one.kinetic_energy at A)", "≈ m (1 + e)²/M for m ≪ M"),
    ],
)
def test_the_leading_term_stands_beside_the_exact_answer(of: str, find: str, said: str) -> None:
    text = solve(f"{of}find: {{x: {find}}}\n").to("text", width=200)
    assert said in text.partition("\nAnswers\n")[2]


def test_both_orders_of_two_limits_have_to_agree() -> None:
    scene = (
        "title: t\nassume: [m << M, a << b]\ngiven: {m: kg, M: kg, a: m, b: m}\n"
        "bodies: {disc: {shape: disc, mass: M, radius: b}, lump: {mass: m}}\n"
        "connections: {axle: {axle: disc}, r: {rides: [lump, disc]}}\n"
        "states: {A: {lump.radius: a, disc.angular_velocity: 1 rad/s}}\nplane: horizontal\nfind: {x: FIND}\n"
    )
    whole = solve(scene.replace("FIND", "inertia about axle at A")).to("text")
    assert "≈ ½ M b² for m ≪ M and a ≪ b" in whole
    torn = solve(scene.replace("FIND", "m/M + a/b + 0*(lump.radius at A)/b")).to("text")
    assert "≈" not in torn.partition("\nAnswers\n")[2] or "no leading term" in torn


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("10 g", "1 kg", "is not small beside `M`: it is 0.2 of it"),
        ("5 kg", "0 kg", "is not small beside `M`: `M` is 0"),
        ("m << M", "m << R", "are of different kinds"),
        ("m << M", "q << M", "is no given"),
        ("m << M", "m << m", "does not say which letter"),
        ("m << M", "fast spin", "is for scenes in space"),
        ("m: 10 g", "m: M/500", "is made of others"),
    ],
)
def test_what_is_not_small_is_refused(old: str, new: str, message: str) -> None:
    with pytest.raises(SceneError, match=message):
        solve(PULLEY.replace(old, new) + "find: {x: load.acceleration at A}\n")


def test_what_leaves_nothing_out_is_refused() -> None:
    scene = (
        "title: t\nassume: [m << M]\ngiven: {m: 1 g, M: 2 kg}\nbodies: {disc: {shape: disc, mass: M, radius: 1 m}}\n"
    )
    with pytest.raises(SceneError, match="says nothing here"):
        solve(scene + "find: {x: disc.inertia}\n")


@pytest.mark.parametrize("numbers", ["m: kg, M: kg, u: m/s", "m: 1 g, M: 1 kg, u: 1 m/s"])
def test_a_number_that_makes_a_leading_term_vanish_is_put_in(numbers: str) -> None:
    """u (1 − e) of an elastic blow on what is heavy is nothing, and the next term 2 m u/M tells."""
    told = HIT.replace("E", "1").replace("m: kg, M: kg, u: m/s", numbers) + "find: {x: u + one.velocity at B}\n"
    assert "≈ 2 m u/M" in solve(told).to("text", width=200)


def test_a_leading_term_that_vanishes_with_the_numbers_is_not_told() -> None:
    """g (M − N)/(M + N) of two loads that are equal by their numbers."""
    text = """title: t
assume: [d << M]
given: {M: 2 kg, d: kg, N: 2 kg, R: 10 cm}
bodies: {A: {mass: M + d, moves: down}, B: {mass: N, moves: up}, wheel: {mass: 0, radius: R}}
connections: {stud: {axle: wheel}, cord: {string: [B, wheel, A]}}
find: {a: A.acceleration}
"""
    assert "no leading term in letters holds with these numbers" in solve(text).to("text", width=200)
