"""Which way an answer in letters points hangs on one difference at most, and that is said; other letters never get a direction so."""

from __future__ import annotations

import pytest

import rotsolve
from rotsolve.algebra.formula import Formula
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.derivation import Answer, Words

REEL = """
given: {{g: m/s^2, M: kg, I: kg m^2, r: m, R: m, F: N}}
surfaces: {{table: level}}
bodies: {{reel: {{mass: M, inertia: I, radii: {{core: r, rims: R}}, moves: {way}}}}}
connections: {{touch: {{rolls: [reel.rims, table]}}}}
actions: {{pull: {{force: F, on: reel.core, direction: right, under: {under}}}}}
find: {{a: reel.acceleration}}
"""
ATWOOD = """
given: {g: m/s^2, m1: kg, m2: kg, M: kg, R: m}
bodies:
  one: {mass: m1, moves: up}
  two: {mass: m2, moves: down}
  pulley: {shape: ring, mass: M, radius: R, turns: clockwise}
connections: {axle: {axle: pulley}, string: {string: [one, pulley, two]}}
find: {a: two.acceleration, b: one.acceleration, P: two.acceleration * two.mass}
"""
BOTH = """
given: {m: kg, F: N, G: N}
surfaces: {floor: level}
bodies: {block: {mass: m, moves: right}}
connections: {contact: {contact: [block, floor]}}
actions: {pull: {force: F, on: block, direction: right}, push: {force: G, on: block, direction: left}}
find: {a: block.acceleration, c: block.acceleration * (F - G)}
"""


def plain(words: Words) -> str:
    return "".join(to_text(part) if isinstance(part, Formula) else str(part) for part in words)


def answers(text: str) -> dict[str, Answer]:
    return {answer.name: answer for answer in rotsolve.solve(text).derivation.answers}


@pytest.mark.parametrize("way", ["right", "left"])
def test_a_reel_goes_the_way_that_its_radii_say(way: str) -> None:
    """Whatever is counted positive, it is pulled to the right and goes there if R > r; the page says that F is meant to be positive."""
    text = REEL.format(way=way, under="true")
    assert plain(answers(text)["a"].pointing) == "right if R > r"
    assert "F > 0" in rotsolve.solve(text).to()
    assert '"pointing": "right if R > r"' in rotsolve.solve(text).to("json")


def test_what_letters_without_a_difference_leave_open_stays_so() -> None:
    answer = answers(REEL.format(way="right", under="false"))["a"]
    assert not answer.pointing and not answer.direction


def test_masses_say_which_way_an_atwood_machine_goes() -> None:
    found = answers(ATWOOD)
    assert plain(found["a"].pointing) == "down if m₂ > m₁"
    assert plain(found["b"].pointing) == "up if m₂ > m₁"


def test_what_has_no_two_ways_or_an_even_power_gets_no_condition() -> None:
    found = answers(BOTH)
    assert plain(found["a"].pointing) == "right if F > G"
    assert not found["c"].pointing
    assert not answers(ATWOOD)["P"].pointing


def test_with_numbers_the_way_is_known() -> None:
    found = answers(BOTH.replace("F: N, G: N", "F: 3 N, G: 5 N").replace("m: kg", "m: 2 kg"))["a"]
    assert found.direction == "left" and not found.pointing


def test_in_a_case_nothing_is_said_twice() -> None:
    """A crate on a rough floor goes where it is pulled if P > μ m g, which is the condition of its case."""
    page = rotsolve.solve("""
given: {g: m/s^2, m: kg, mu: number, P: N}
surfaces: {floor: level}
bodies: {crate: {mass: m, moves: left}}
connections: {base: {contact: [crate, floor], friction: mu}}
actions: {pull: {force: P, on: crate, direction: left}}
find: {a: crate.acceleration}
""").to()
    assert "(if P > μ m g)" in page and "left if" not in page


def test_what_is_nothing_or_has_no_value_points_nowhere() -> None:
    found = answers(BOTH.replace("c: block.acceleration * (F - G)", "c: block.acceleration - block.acceleration"))
    assert not found["c"].pointing
