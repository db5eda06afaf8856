"""A connection from outside: a spring that pulls with a constant force on the rim of a wheel, by one class and its place in CONNECTIONS."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest

from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.facts import APPLIED, Couple, signed
from rotsolve.elements.shapes import rim_radius
from rotsolve.elements.tables import CONNECTIONS
from rotsolve.language.bodies import PointRef
from rotsolve.language.elements import Connection, Fact, Moment
from rotsolve.language.keys import key
from rotsolve.pipeline import solve

SCENE = """
title: A wheel driven by a constant-force spring
given: {m: 4 kg, R: 0.3 m, F: 6 N, t: 2 s}
bodies: {wheel: {shape: disc, mass: m, radius: R}}
connections:
  axle: {axle: wheel}
  tape: {winder: wheel, force: F}
states: {start: at rest, later: {time: t}}
find: {alpha: wheel.angular_acceleration, omega: wheel.angular_velocity at later, tau: tape.torque}
"""


class Winder(Connection, frozen=True):
    word = "winder"
    about = "a steel tape that winds itself up, and so pulls on the rim of a wheel with a constant force"
    quantities = ("torque",)
    winder: tuple[PointRef, ...] = key("points", "the wheel", count=(1, 1), required=True, example="wheel")
    force: Formula | None = key("quantity", "its pull", dimension="force", letter="F", limits="positive", required=True)

    def turned(self) -> tuple[str, ...]:
        return tuple(ref.owner for ref in self.winder)

    def facts(self, instant: Moment) -> Iterator[Fact]:
        """F R along the wheel's positive turn."""
        for ref in self.winder:
            torque = (self.force or ZERO) * (rim_radius(instant.body(ref.owner), ref.point) or ZERO)
            turn, (way, _) = instant.sense(ref.owner), instant.turn_words(ref.owner)
            yield Couple(self.name, APPLIED, ref.owner, signed(torque, turn), "torque of the tape", torque, way)


@pytest.fixture(autouse=True)
def declared() -> Iterator[None]:
    CONNECTIONS.append(Winder)
    yield
    CONNECTIONS.remove(Winder)


def test_it_is_solved() -> None:
    solution = solve(SCENE)
    answers = {name: answer.exact for name, answer in solution.answers.items()}
    assert answers == {"alpha": "2 F/(m R)", "omega": "2 F t/(m R)", "tau": "F R"}  # F R = ½ m R² α
    assert "torque of the tape F R, counterclockwise" in str(solution)
    assert [check for check in solution.checks if check.holds is False] == []


def test_a_key_that_is_missing_is_named() -> None:
    with pytest.raises(Exception, match="force"):
        solve(SCENE.replace(", force: F", ""))


def test_it_is_in_the_language(in_language: Callable[[str, str, str], None]) -> None:
    in_language("winder", Winder.about, SCENE)
