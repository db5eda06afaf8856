"""What a state says to be in balance is held by friction there: no harder than that can hold, also where an event follows at once."""

from __future__ import annotations

import math
from contextlib import suppress

import pytest

from rotsolve.confirm.numbers import value_of
from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

LOAD = "load: {mass: m, moves: DOWN}"
SCENES = {  # the bodies, what holds them, and how large a friction has to be beside m g R or m g
    "a rubbing axle": (
        f"drum: {{inertia: I, radius: R, turns: WAY}}, {LOAD}",
        "axle: {axle: drum, friction_torque: tau}, rope: {string: [load, drum]}",
        "",
        "m g R ≤ τ",
    ),
    "a brake": (
        f"drum: {{inertia: I, radius: R, turns: WAY}}, {LOAD}",
        "axle: {axle: drum}, rope: {string: [load, drum]}",
        "actions: {brake: {press: F, on: drum, friction: mu}}",
        "m g ≤ μ F",
    ),
    "a slope": (
        "load: {mass: m}",
        "base: {contact: [load, ramp], friction: mu}",
        "surfaces: {ramp: {slope: b, down: SIDE}}",
        "tan b ≤ μ",
    ),
}
GIVEN = {"m": "kg", "R": "m", "I": "kg m^2", "tau": "N m", "F": "N", "mu": "number", "b": "deg"}
HIT = "events: {hit: {impulse: 2 N s, on: load, direction: DOWN, from: hold, to: after}}\n"
ENOUGH = {"m": 2, "R": 0.5, "I": 1, "tau": 12, "F": 50, "mu": 0.5, "b": 20}
TOO_LITTLE = ENOUGH | {"tau": 9, "F": 30, "b": 30}


def scene(name: str, way: str, question: str, numbers: dict[str, float] | None, *, struck: bool) -> str:
    bodies, held, more, _ = SCENES[name]
    given = {
        key: unit if numbers is None else f"{numbers[key]} {unit}".removesuffix(" number")
        for key, unit in GIVEN.items()
    }
    used = {
        key: value for key, value in given.items() if any(f"{key}{end}" in f"{bodies} {held} {more}" for end in ",}")
    }
    states = "{hold: {balance: true}, after: {}}" if struck else "{hold: {balance: true}}"
    text = f"""given: {{{", ".join(f"{key}: {value}" for key, value in used.items())}}}
bodies: {{{bodies}}}
{more}
connections: {{{held}}}
states: {states}
{HIT if struck else ""}find: {{{question}}}
"""
    down = "right" if way == "clockwise" else "left"
    return text.replace("WAY", way).replace("DOWN", "down").replace("SIDE", down)


QUESTIONS = {
    "a rubbing axle": "T: rope.tension at hold",
    "a brake": "T: rope.tension at hold",
    "a slope": "N: base.normal_force at hold",
}


@pytest.mark.parametrize("struck", [False, True])
@pytest.mark.parametrize("way", ["clockwise", "counterclockwise"])
@pytest.mark.parametrize("name", SCENES)
def test_a_balance_that_friction_can_not_hold_is_none(name: str, way: str, struck: bool) -> None:
    question = QUESTIONS[name]
    held = solve(scene(name, way, question, ENOUGH, struck=struck))
    assert all(check.holds is not False for check in held.derivation.checks)
    assert all(verdict.holds for verdict in held.derivation.confirmed)
    try:
        slips = solve(scene(name, way, question, TOO_LITTLE, struck=struck))
    except Unsolvable:
        pass
    else:
        assert any(check.holds is False for check in slips.derivation.checks)
    (answer,) = solve(scene(name, way, question, None, struck=struck), confirm=False).answers.values()
    assert answer.answer.conditions, "letters say up to where friction holds it"


@pytest.mark.parametrize("order", ["load, wheel.small", "wheel.small, load"])
@pytest.mark.parametrize("turns", ["clockwise", "counterclockwise"])
def test_a_wheel_with_a_lump_that_a_load_turns_stands_where_it_comes_back(order: str, turns: str) -> None:
    """w r = m R cos φ at two angles: the lump hangs below the axle at the one to which it comes back, on the side away from the load."""
    found = solve(f"""title: Wheel with a lump on its rim balanced by a load on a small drum
given: {{m: 2 kg, w: 1 kg, R: 50 cm, r: 30 cm, M: 3 kg, phi: unknown}}
bodies:
  wheel: {{mass: M, inertia: 0.4 kg m^2, radii: {{big: R, small: r}}, turns: {turns}}}
  lump: {{mass: m}}
  load: {{mass: w, moves: down}}
connections: {{pin: {{axle: wheel}}, glue: {{weld: [wheel.big, lump]}}, cord: {{string: [{order}]}}}}
states: {{rest: {{wheel.angle: phi, balance: true}}}}
find: {{phi: phi}}
""")
    angle = found.answers["phi"].float
    assert angle is not None
    side = 1 if order.startswith("load") else -1  # the load hangs on the left, or on the right
    assert math.sin(angle) == pytest.approx(-math.sqrt(1 - 0.3**2))
    assert math.cos(angle) == pytest.approx(side * 0.3)


@pytest.mark.parametrize("given", ["M: 10 kg, w: 3 kg", "M: kg, w: kg"])
@pytest.mark.parametrize(("wall", "angle"), [("right", "phi"), ("left", "180 deg - phi")])
def test_a_ladder_in_balance_stands_in_front_of_its_wall(given: str, wall: str, angle: str) -> None:
    """tan φ = M/(2 w) of a smooth ladder whose foot a load draws to the wall: π beyond it it would lie in the wall."""
    found = solve(f"""title: Ladder whose foot is tied to a load
given: {{{given}, L: 4 m, phi: unknown}}
surfaces: {{floor: level, side: {{wall: {wall}}}}}
bodies: {{ladder: {{shape: rod, mass: M, length: L}}, load: {{mass: w, moves: down}}, wheel: {{mass: 0, shape: disc}}}}
connections:
  top: {{contact: [ladder.end, side]}}
  foot: {{contact: [ladder.start, floor]}}
  pin: {{axle: wheel}}
  cord: {{string: [ladder.start, wheel, load], pulls: {{ladder: {wall}}}}}
states: {{rest: {{ladder.angle: {angle}, balance: true}}}}
find: {{phi: phi}}
""")
    closed = found.answers["phi"].answer.closed
    assert closed is not None
    assert value_of(closed, {"M": 10.0, "w": 3.0, "L": 4.0}) == pytest.approx(math.atan(10 / 6))
    assert all(item.holds for item in found.derivation.confirmed)


def test_a_rod_in_a_groove_lies_above_it() -> None:
    """tan φ = ½ (cot α − cot β) between smooth slopes of 60° and 45°."""
    found = solve("""title: Rod in a groove
given: {M: 2 kg, L: 1 m, a: 60 deg, b: 45 deg, phi: unknown}
surfaces: {left: {slope: a, down: right}, right: {slope: b, down: left}}
bodies: {rod: {shape: rod, mass: M, length: L}}
connections: {one: {contact: [rod.start, left]}, two: {contact: [rod.end, right]}}
states: {rest: {rod.angle: phi, balance: true}}
find: {phi: phi}
""")
    assert found.answers["phi"].float == pytest.approx(math.atan((1 / math.tan(math.pi / 3) - 1) / 2))


FLATTEST = """
title: Flattest ladder
given: {{M: kg, L: m, p: {p}, q: {q}, theta: unknown}}
surfaces: {{yard: level, side: {{wall: {wall}}}}}
bodies: {{ladder: {{shape: rod, mass: M, length: L}}}}
connections: {{foot: {{contact: [ladder.start, yard], friction: p}}, head: {{contact: [ladder.end, side], friction: q}}}}
states: {{now: {{ladder.angle: {angle}, balance: true}}}}
find: {{theta: smallest theta where head sticks}}
"""
SIDES = {"right": "theta", "left": "180 deg - theta"}


@pytest.mark.sampled(2)
@pytest.mark.parametrize("wall", SIDES)
def test_a_ladder_does_not_lie_in_the_floor(wall: str) -> None:
    """tan θ = (1 − p q)/(2 p): with p q > 1 it stands at every angle above the floor, and none is the smallest."""
    steep = solve(FLATTEST.format(p="0.4", q="0.5", wall=wall, angle=SIDES[wall]))
    assert steep.answers["theta"].float == pytest.approx(math.atan(1))
    assert all(check.holds is not False for check in steep.checks)
    with suppress(Unsolvable):  # or it is answered with the objection
        jammed = solve(FLATTEST.format(p="2", q="1", wall=wall, angle=SIDES[wall]))
        (against,) = [check for check in jammed.checks if check.holds is False]
        assert "ladder lies in yard" in "".join(map(str, against.words))
    letters = solve(FLATTEST.format(p="number", q="number", wall=wall, angle=SIDES[wall])).answers["theta"]
    assert {"p < 1/q", "p ≤ 1/q"} & set(letters.conditions)
    assert not letters.otherwise


@pytest.mark.parametrize(("end", "angle"), [("start", "-20 deg"), ("start", "200 deg"), ("end", "30 deg")])
def test_what_is_let_go_in_a_surface_is_told(end: str, angle: str) -> None:
    solution = solve(f"""
title: Rod let go with an end on a floor, and the rest below it
given: {{M: 2 kg, L: 1 m}}
surfaces: {{yard: level}}
bodies: {{rod: {{shape: rod, mass: M, length: L}}}}
connections: {{foot: {{contact: [rod.{end}, yard]}}}}
states: {{now: {{rod.angle: {angle}, at rest: all}}}}
find: {{N: foot.normal_force at now}}
""")
    assert any(
        "rod lies in yard" in "".join(map(str, check.words)) for check in solution.checks if check.holds is False
    )
