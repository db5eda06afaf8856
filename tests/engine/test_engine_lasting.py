"""Functions of any time hold while what pulls pulls and what presses presses: the page says until when, and objects to a later time."""

from __future__ import annotations

import pytest

import rotsolve
from rotsolve.algebra.formula import Formula
from rotsolve.algebra.notation.text import to_text

WINCH = """
title: Winch that a growing couple turns the way in which its sack falls
given: {J: kg m^2, r: m, m: kg, c: %s}
bodies: {winch: {inertia: J, radius: r, turns: clockwise}, sack: {mass: m, moves: down}}
connections: {axle: {axle: winch}, cord: {string: [winch, sack]}}
actions: {motor: {couple: %s, on: winch}}
states: {%s}
find: {S: cord.tension at any time, v: sack.velocity at any time}
"""
CRATE = """
title: Crate that is pulled up more and more
given: {m: kg, c: N/s}
surfaces: {floor: level}
bodies: {crate: {mass: m, moves: right}}
connections: {base: {contact: [crate, floor]}}
actions: {hook: {force: c*time, on: crate, direction: 60 deg}}
states: {start: at rest}
find: {v: crate.velocity at any time}
"""
SHAKEN = """
title: Sack that is shaken on its winch
given: {J: kg m^2, r: m, m: kg, F: N, w: s^-1}
bodies: {winch: {inertia: J, radius: r, turns: clockwise}, sack: {mass: m, moves: down}}
connections: {axle: {axle: winch}, cord: {string: [winch, sack]}}
actions: {hand: {force: F*cos(w*time), on: sack, direction: down}}
states: {start: at rest}
find: {S: cord.tension at any time}
"""
SIZES = {"J": "2 kg m^2", "r": "0.5 m", "m": "3 kg"}
LINEAR, SQUARE = WINCH % ("N m/s", "c*time", "start: at rest"), WINCH % ("N m/s^2", "c*time^2", "start: at rest")
ENDED = WINCH % ("N m/s", "c*time", "start: at rest, end: {time: 5 s}")


def said(text: str, **options: object) -> list[tuple[bool | None, str]]:
    """What the checks say, and whether it holds."""
    checks = rotsolve.solve(text, **options).derivation.checks  # type: ignore[arg-type]
    return [
        (check.holds, "".join(to_text(word) if isinstance(word, Formula) else word for word in check.words))
        for check in checks
    ]


@pytest.mark.parametrize(
    ("text", "until"),
    [
        (LINEAR, "the string goes slack at t = g J/(c r)"),  # S = m (g J − c t r)/(J + m r²)
        (SQUARE, "the string goes slack at t = √(g J/(c r))"),
        (CRATE, "crate leaves the surface at t = 2 √3 g m/(3 c)"),  # N = m g − c t sin 60°
    ],
)
def test_the_page_says_until_when_functions_hold(text: str, until: str) -> None:
    assert [words for holds, words in said(text) if holds is None and " at t = " in words] == [
        f"{until}: what is told of any time holds up to then"
    ]


@pytest.mark.parametrize("text", [LINEAR, ENDED])
@pytest.mark.parametrize(("time", "holds"), [("5 s", True), ("7.8 s", True), ("7.9 s", False), ("20 s", False)])
def test_a_time_after_the_string_is_slack_is_objected_to(text: str, time: str, holds: bool) -> None:
    """g J/(c r) = 7.84 s; what a state ends goes on as before after it."""
    told = said(text, settings={**SIZES, "c": "5 N m/s"}, at=time)
    assert any(found is False and "slack" in words for found, words in told) is not holds


def test_a_tension_that_swings_is_held_where_it_is_least() -> None:
    """S = J (m g + F cos w t)/(J + m r²)."""
    assert rotsolve.solve(SHAKEN).answers["S"].conditions == ("F ≤ m g",)
    for force, holds in (("29 N", True), ("30 N", False)):
        told = said(SHAKEN, settings={**SIZES, "F": force, "w": "2 s^-1"})
        assert any(found is False and "slack" in words for found, words in told) is not holds


def test_in_letters_the_moment_is_a_condition() -> None:
    """c t r ≤ g J at 4 s."""
    (limit,) = rotsolve.solve(LINEAR, at="4 s").answers["S"].conditions
    assert limit == "J ≥ 4 c r/g"
