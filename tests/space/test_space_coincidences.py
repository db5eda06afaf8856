"""What numbers make special in space: bodies that are symmetric, axes that are level. It is the same whether letters or numbers tell it.

Where letters alone leave it open, and what is asked hangs on it, the question is refused by name.
"""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

from rotsolve import Solution, Unsolvable, solve
from rotsolve.page.text import plain_text

AXLED = """up: z
gravity: none
given: {{M: 2 kg, w: 3 rad/s, {given}}}
bodies: {{plate: {{shape: rectangle, mass: M, sides: [{sides}]}}}}
connections: {{shaft: {{axle: plate, along: [1, 0, 1], angular_velocity: w}}}}
find: {{L: plate.angular_momentum, T: shaft.torque, K: plate.kinetic_energy}}
"""
CORNER = """up: z
given: {{M: 3 kg, {given}}}
bodies: {{box: {{shape: cuboid, mass: M, sides: [{sides}], points: {{O: [{corner}]}}}}}}
find: {{I: box.principal_moments about box.O, J: box.principal_moments}}
"""
GYROSCOPE = """up: z
given: {{M: 2 kg, R: 0.15 m, l: 0.1 m, {rate}: 80 rad/s{given}}}
bodies: {{wheel: {{shape: ring, mass: M, radius: R, points: {{end: [0, 0, -l]}}}}}}
connections: {{pivot: {{ball: wheel.end}}}}
states: {{now: {{wheel.tilt: {tilt}, wheel.{word}: {rate}, steady: true}}}}
find: {{Omega: wheel.precession, N: pivot.force.z}}
"""
LEANING = """up: z
given: {{M: 0.2 kg, l: 0.05 m, {given}, s: 400 rad/s, theta: 20 deg}}
bodies: {{top: {{mass: M, inertia: {{about: tip, principal: [A, B, C]}}, axis: z, points: {{tip: [0, 0, -l]}}}}}}
connections: {{floor: {{ball: top.tip}}}}
states: {{now: {{top.tilt: theta, top.axial_rate: s, steady: true}}}}
find: {{W: smallest top.precession}}
"""
TURNED = """up: z
gravity: none
given: {{M: 2 kg, R: 0.5 m, w: 3 rad/s{given}}}
bodies: {{disc: {{shape: disc, mass: M, radius: R, turned: {{about: x, by: {by}}}}}}}
find: {{n: disc.rotation_axis}}
"""
SAME = {  # scenes that mean the same: symmetric or not, whichever way it is told
    "a plate with sides of one length on an oblique axle, which stands with its axis along it": (
        AXLED.format(given="a: 1 m", sides="a, a"),
        AXLED.format(given="a: 1 m, b: 1 m", sides="a, b"),
        AXLED.format(given="a: 1 m, b: 50 cm", sides="a, 2*b"),
        AXLED.format(given="a: 1 m", sides="1 m, 1 m"),
        AXLED.format(given="a: 1 m", sides="a, 100 cm"),
    ),
    "one with sides of two lengths, which stands as it is drawn": (
        AXLED.format(given="a: 1 m", sides="a, 2*a"),
        AXLED.format(given="a: 1 m, b: 2 m", sides="a, b"),
        AXLED.format(given="a: 1 m", sides="1 m, 2 m"),
    ),
    "a cube about its corner": (
        CORNER.format(given="a: 0.2 m", sides="a, a, a", corner="-a/2, -a/2, -a/2"),
        CORNER.format(given="a: 0.2 m, b: 20 cm, c: 200 mm", sides="a, b, c", corner="-a/2, -b/2, -c/2"),
        CORNER.format(given="a: 0.2 m", sides="0.2 m, 0.2 m, 0.2 m", corner="-0.1 m, -0.1 m, -0.1 m"),
    ),
    "a top that leans": tuple(
        LEANING.format(given=given).replace("[A, B, C]", moments)
        for given, moments in (
            ("A: 6e-4 kg m^2, C: 8e-5 kg m^2", "[A, A, C]"),
            ("A: 6e-4 kg m^2, B: 6 kg cm^2, C: 8e-5 kg m^2", "[A, B, C]"),
        )
    ),
    "a level gyroscope": tuple(
        GYROSCOPE.format(given=given, tilt=tilt, rate="s", word=word)
        for given, tilt in (("", "90 deg"), (", theta: 90 deg", "theta"), (", theta: 45 deg", "2*theta"))
        for word in ("spin", "axial_rate")  # which are one where the tilt is 90°
    ),
}
OPEN = {  # letters alone, and the letters that are named
    "a vertical": (
        "up: z\ngiven: {I: kg m^2, w: rad/s, n1: number, n3: number, a: m, m: kg}\n"
        "bodies: {top: {mass: m, inertia: {principal: [I, I, I/2]}, points: {tip: [-a, 0, 0]}}}\n"
        "connections: {floor: {ball: top.tip}}\n"
        'states: {now: {"top.angular_velocity in body axes": [w, 0, 0], top.vertical: [n1, 0, n3]}}\n'
        "find: {E: top.energy}\n",
        "that the vertical of `top` is a direction of length 1 its letters do not tell",
    ),
    "a top that precesses steadily": (LEANING.format(given="A: kg m^2, B: kg m^2, C: kg m^2"), "hangs on `A` and `B`"),
    "a top that is not symmetric": (
        LEANING.format(given="A: 6e-4 kg m^2, B: 7e-4 kg m^2, C: 2e-4 kg m^2"),
        "not the same all round its axis",
    ),
    "half a turn": (TURNED.format(given=", phi: 180 deg", by="phi"), "has no one axis that this tells"),
}


def numbers(solution: Solution) -> dict[str, list[float]]:
    """By answer, all certified; every one is confirmed by the assembly."""
    assert all(item.holds for item in solution.derivation.confirmed)
    found = {}
    for answer in solution.derivation.answers:
        parts = answer.components or (answer,)
        found[answer.name] = [part.value.float for part in parts if part.value is not None]
    return found


@pytest.mark.parametrize("name", SAME)
def test_what_numbers_make_special_is_so_however_it_is_told(name: str) -> None:
    found = [numbers(solve(scene)) for scene in SAME[name]]
    for one, other in pairwise(found):
        assert one.keys() == other.keys()
        for key, values in one.items():
            assert values == pytest.approx(other[key], rel=1e-12, abs=1e-12), key


def said(solution: Solution) -> list[str]:
    """What is said of the scene beside its givens."""
    return [plain_text(line) for line in solution.derivation.conventions]


def test_what_numbers_made_special_is_told_and_holds_only_with_them() -> None:
    """Of plates on an oblique axle, K = ½ (M a²/12) w² where they are squares, else ½ (M b²/24 + M (a² + b²)/24) w²."""
    solution = solve(AXLED.format(given="a: 1 m, b: 1 m", sides="a, b"))
    assert "with the numbers of the scene a = b" in said(solution)
    sets = solve(
        AXLED.format(given="a: 1 m, b: 1 m", sides="a, b").replace("L: plate.angular_momentum, T: shaft.torque, ", "")
    )
    found = sets.evaluate_many({"a": [1.0, 2.0, 2.0], "b": [1.0, 3.0, 2.0]})["K"]
    assert found == pytest.approx([9 * 2 / 12, 9 * (9 + 13) / 24, 9 * 8 / 12])


def test_a_body_that_letters_may_make_symmetric_is_not_and_that_is_told() -> None:
    for given in ("a: m, b: m", "a: m, b: 1 m"):
        solution = solve(AXLED.format(given=given, sides="a, b"))
        assert all(item.holds for item in solution.derivation.confirmed)
        assert any(line.startswith("plate is not symmetric: ") and line.endswith(" ≠ 0") for line in said(solution))


@pytest.mark.parametrize("name", OPEN)
def test_what_letters_leave_open_is_refused_by_name(name: str) -> None:
    scene, reason = OPEN[name]
    with pytest.raises(Unsolvable) as caught:
        solve(scene)
    assert reason in str(caught.value)


def test_a_period_that_letters_may_end_says_where_it_does_not() -> None:
    """2π A/(w |A − C|) is that of a body of which ω goes round; where A = C ω stays, and a period is that of the turning."""
    free = "up: z\ngravity: none\ngiven: {GIVEN, w: 3 rad/s, p: 1 rad/s}\n"
    free += "bodies: {top: {inertia: {principal: [A, A, C]}, axis: z}}\n"
    free += "states: {now: {top.angular_velocity: [p, 0, w]}}\nfind: {T: top.period}\n"
    letters = solve(free.replace("GIVEN", "A: kg m^2, C: kg m^2"))
    assert "A ≠ C" in str(letters)
    told = solve(free.replace("GIVEN", "A: 2 kg m^2, C: 3 kg m^2"))
    assert "≠" not in str(told)
    assert told.answers["T"].float == pytest.approx(2 * math.pi * 2 / 3)
    same = solve(free.replace("GIVEN", "A: 2 kg m^2, C: 2 kg m^2"))
    assert same.answers["T"].float == pytest.approx(2 * math.pi / math.sqrt(10))


@pytest.mark.parametrize("way", ["z", "[0, 3/5, 4/5]", "[1, 1, 1]", "[cos(q), 0, sin(q)]"])
def test_what_is_driven_steadily_has_a_period_about_any_axis(way: str) -> None:
    """Its angular acceleration is nothing, also where that is written as a sum that cancels."""
    scene = "title: T\nup: z\ngiven: {M: 0.5 kg, a: 8 cm, w: 3 rad/s, q: 20 deg}\n"
    scene += "bodies: {c: {shape: cuboid, mass: M, sides: [a, 2*a, 3*a]}}\n"
    scene += f"connections: {{h: {{hinge: c.center, along: {way}, angular_velocity: w}}}}\nfind: {{T: c.period}}\n"
    assert solve(scene).answers["T"].float == pytest.approx(2 * math.pi / 3)
