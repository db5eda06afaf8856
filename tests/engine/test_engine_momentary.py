"""Friction that holds for a moment only, or either way: a blow ends the one at once; |f| ≤ μ N is f ≤ μ N and −f ≤ μ N."""

from __future__ import annotations

import random
from fractions import Fraction

import pytest

from rotsolve import solve
from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.formula import Formula, Number
from rotsolve.solution import Solution

G = 9.8
SIGNS = {">": (1,), "≥": (0, 1), "<": (-1,), "≤": (-1, 0), "=": (0,)}


def at(solution: Solution, name: str, known: dict[str, float]) -> float | None:
    """The answer for some letters, by the case whose conditions hold; None where none of them does."""
    values: dict[str, Formula] = {letter: Number(Fraction(size)) for letter, size in known.items()}
    values["g"] = Number(Fraction(49, 5))
    answer = next(item for item in solution.derivation.answers if item.name == name)
    for case in (answer, *answer.otherwise):
        signs = [(evaluate(line.left - line.right, values).sign or 0, line.relation) for line in case.conditions]
        if all(sign in SIGNS[relation] for sign, relation in signs):
            assert case.formula is not None
            return float(evaluate(case.formula, values).float)
    return None


DYING = """
title: A push that dies away and becomes a pull
given: {{m: kg, mu: number, F: N, c: N/s, T: s}}
surfaces: {{floor: level}}
bodies: {{box: {{mass: m, moves: {way}}}}}
connections: {{base: {{contact: [box, floor], friction: mu}}}}
actions: {{push: {{force: F - c*time, on: box, direction: {way}}}}}
states: {{start: at rest, end: {{time: T}}}}
find: {{v: box.velocity at end}}
"""


def dying(m: float, mu: float, F: float, c: float, T: float) -> float:
    """m v of a push F − c t against friction of L at most, phase by phase."""
    most = mu * m * G
    stops = max(0.0, 2 * (F - most) / c)
    if stops >= T:
        return ((F - most) * T - c * T**2 / 2) / m
    back = max(stops, (F + most) / c)
    return 0.0 if back >= T else ((F + most) * (T - back) - c * (T**2 - back**2) / 2) / m


@pytest.mark.sampled(2)
@pytest.mark.parametrize("way", ["right", "left"])
def test_a_push_that_becomes_a_pull_is_told_for_all_letters(way: str) -> None:
    solution, chance = solve(DYING.format(way=way), confirm=False), random.Random(way)
    assert "no answer" not in solution.to("text")
    for _ in range(300):
        known = {name: chance.choice((0.25, 0.5, 1, 2, 3, 5)) for name in ("m", "F", "c", "T")}
        known["mu"] = chance.choice((0.0625, 0.125, 0.25, 0.5))
        assert at(solution, "v", known) == pytest.approx(dying(**known), abs=1e-12), known


KICKED = """
title: A sledge with a load over a pulley gets a kick away from it
given: {{m: kg, M: kg, J: N s, mu: number, T: s}}
surfaces: {{floor: level}}
bodies: {{sledge: {{mass: M, moves: {way}}}, load: {{mass: m, moves: down}}, wheel: {{mass: 0, radius: 10 cm}}}}
connections:
  base: {{contact: [sledge, floor], friction: mu}}
  pin: {{axle: wheel}}
  rope: {{string: [{row}]}}
states: {{still: {{at rest: all}}, hit: {{}}, end: {{time: T}}}}
events: {{kick: {{impulse: J, on: sledge, direction: {away}, from: still, to: hit}}}}
find: {{V: sledge.velocity at hit, v: sledge.velocity at end}}
"""


def kicked(m: float, M: float, J: float, mu: float, T: float) -> float:
    """It slows down at g (m + μ M)/(m + M); then the load draws it back, or friction holds both."""
    slows, speed = G * (m + mu * M) / (m + M), J / (m + M)
    if speed >= slows * T:
        return slows * T - speed
    return max(0.0, G * (m - mu * M) / (m + M)) * (T - speed / slows)


@pytest.mark.sampled(2)
@pytest.mark.parametrize(
    ("way", "away", "row"), [("right", "left", "sledge, wheel, load"), ("left", "right", "load, wheel, sledge")]
)
def test_what_is_kicked_need_not_have_stayed_at_rest(way: str, away: str, row: str) -> None:
    solution, chance = solve(KICKED.format(way=way, away=away, row=row), confirm=False), random.Random(row)
    for _ in range(200):
        known = {name: chance.choice((0.25, 0.5, 1, 2, 3, 5)) for name in ("m", "M", "J", "T")}
        known["mu"] = chance.choice((0.0625, 0.125, 0.25, 0.5, 2.0))
        found = [at(solution, name, known) for name in ("V", "v")]
        if known["mu"] < 1:  # with more the string goes slack
            expected = [-known["J"] / (known["m"] + known["M"]), kicked(**known)]
            assert found == pytest.approx(expected, abs=1e-12), known
        else:
            assert found == [None, None]


PLANK = """
title: A kick against a plank with a block riding on it
given: {{m: kg, M: kg, J: N s, u: m/s, mu: number, k: number}}
surfaces: {{floor: level}}
bodies: {{plank: {{mass: M, moves: {way}}}, block: {{mass: m, moves: {way}}}}}
connections:
  below: {{contact: [plank, floor], friction: k}}
  grip: {{contact: [block, plank], friction: mu}}
states: {{before: {{plank.velocity: u, block.velocity: u}}, after: {{}}}}
events: {{kick: {{impulse: J, on: plank, direction: {away}, from: before, to: after}}}}
find: {{V: plank.velocity at after, ap: plank.acceleration at after, ab: block.acceleration at after}}
"""


@pytest.mark.parametrize(("way", "away"), [("right", "left"), ("left", "right")])
def test_a_block_on_a_plank_that_is_kicked_slides_whatever_held_it_before(way: str, away: str) -> None:
    solution, chance = solve(PLANK.format(way=way, away=away)), random.Random(way)
    for _ in range(100):
        known = {name: chance.choice((0.25, 0.5, 1, 2, 3)) for name in ("m", "M", "J", "u", "mu", "k")}
        m, M, J, u, mu, k = (known[name] for name in ("m", "M", "J", "u", "mu", "k"))
        if M * u == J:
            continue  # it stands still at that moment
        floor = k * (m + M) * (1 if M * u < J else -1)
        expected = [u - J / M, G * (mu * m + floor) / M, -mu * G]
        assert [at(solution, name, known) for name in ("V", "ap", "ab")] == pytest.approx(expected), known


def test_what_is_asked_at_the_moment_itself_is_held_to_it() -> None:
    """Of the sledge at rest that its load would draw away no acceleration is told."""
    text = KICKED.format(way="right", away="left", row="sledge, wheel, load")
    text = text.replace("V: sledge.velocity at hit, v: sledge.velocity at end", "a: sledge.acceleration at still")
    assert "slips" in solve(text).to("text")


THROUGH = """
title: Past a place on a rough floor, against what counts as positive
given: {{m: 2 kg, M: 3 kg, k: 0.2, x: 1 m}}
surfaces: {{floor: level}}
bodies: {{one: {{mass: m, moves: {ways[0]}}}, two: {{mass: M, moves: {ways[1]}}}}}
connections:
  c1: {{contact: [one, floor], friction: k}}
  c2: {{contact: [two, floor], friction: k}}
  tie: {{{tie}}}
states: {{start: {{{told}.velocity: {speed} m/s}}, later: {{{told}.displacement: {sign}x}}, end: {{{told}.velocity: {least} m/s}}}}
find:
  v: one.velocity at later
  w: two.velocity at later
  d: one.displacement from start to end
  e: two.displacement from start to end
"""


SENSES = [("right", "right"), ("left", "left"), ("right", "left"), ("left", "right")]
TIES = [("weld: [one, two]", ways) for ways in SENSES] + [("weld: [two, one]", ways) for ways in SENSES]
TIES += [("string: [one, two]", ways) for ways in SENSES[:2]]  # neighbours on a string travel the same way


@pytest.mark.sampled(3)
@pytest.mark.parametrize(
    ("tie", "ways", "told", "sign"),
    [  # of each body one sign, the other one at the next tie
        (*tie, told, (-1) ** (place + place // 4 + at))
        for place, tie in enumerate(TIES)
        for at, told in enumerate(("one", "two"))
    ],
)
def test_what_slides_on_slides_the_same_way(tie: str, ways: tuple[str, str], told: str, sign: int) -> None:
    """v² = 9 − 2 k g x; the way to 1 m/s is 8/(2 k g); each along its own sense."""
    minus = "-" if sign < 0 else ""
    text = THROUGH.format(ways=ways, tie=tie, told=told, sign=minus, speed=3 * sign, least=sign)
    found = {name: answer.float for name, answer in solve(text, confirm=False).answers.items()}
    speed, way = sign * (9 - 2 * 0.2 * G) ** 0.5, sign * 8 / (0.4 * G)
    own = {
        name: 1 if word == ways[("one", "two").index(told)] else -1
        for name, word in zip(("one", "two"), ways, strict=True)
    }
    expected = {"v": own["one"] * speed, "w": own["two"] * speed, "d": own["one"] * way, "e": own["two"] * way}
    assert found == pytest.approx(expected)
