"""An event from outside: a jerk that changes a body's angular momentum by H, by one class and its place in EVENTS."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

import pytest

from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.facts import BLOW, Couple, signed
from rotsolve.elements.tables import EVENTS
from rotsolve.language.bodies import PointRef
from rotsolve.language.elements import Connection, Event, Moment
from rotsolve.language.keys import key
from rotsolve.pipeline import solve

SCENE = """
title: A turntable that is jerked
given: {m: 3 kg, R: 0.2 m, w: 2 rad/s, H: 0.3 N m s}
bodies: {table: {shape: disc, mass: m, radius: R}}
connections: {axle: {axle: table}}
states:
  before: {table.angular_velocity: w}
  after: {}
events: {tug: {jerk: table, by: H, from: before, to: after}}
find: {omega: table.angular_velocity at after, G: tug.angular_impulse during tug}
"""


class Jerk(Event, frozen=True):
    word = "jerk"
    about = "a twist that is over at once: an angular impulse on a body, along its positive turn"
    quantities = ("angular_impulse",)
    jerk: PointRef | None = key("point", "the body", required=True, example="table")
    by: Formula | None = key("quantity", "angular impulse", dimension="angular impulse", letter="H", required=True)

    def points(self, connections: Sequence[Connection]) -> tuple[PointRef, ...]:
        return (self.jerk,) if self.jerk is not None else ()

    def axes(self, instant: Moment) -> tuple[()]:
        """It pushes nowhere."""
        return ()

    def twists(self, body: str, instant: Moment) -> tuple[Couple, ...]:
        if self.jerk is None or instant.host(self.jerk.owner) != body:
            return ()
        size = self.by or ZERO
        return (Couple(self.name, BLOW, body, signed(size, instant.sense(body)), "jerk", size),)


@pytest.fixture(autouse=True)
def declared() -> Iterator[None]:
    EVENTS.append(Jerk)
    yield
    EVENTS.remove(Jerk)


def test_it_is_solved() -> None:
    solution = solve(SCENE)
    assert solution.answers["omega"].exact == "w + 2 H/(m R²)"  # H = ½ m R² (ω − w)
    assert solution.answers["omega"].value is not None and str(solution.answers["omega"].value) == "7"
    assert solution.answers["G"].exact == "H"
    assert [check for check in solution.checks if check.holds is False] == []


def test_it_is_in_the_language(in_language: Callable[[str, str, str], None]) -> None:
    in_language("jerk", Jerk.about, SCENE)
