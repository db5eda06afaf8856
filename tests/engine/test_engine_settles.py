"""Settles: the speed to which a motion leads after a long time, and what is largest or smallest in the limit."""

from __future__ import annotations

import math

import pytest

from rotsolve import solve
from rotsolve.core.faults import SceneError, Unsolvable

WHEEL = (
    "title: t\ngravity: none\ngiven: {I: 2 kg m^2, M: 3 N m, c: 0.5 N m s, b: 0.02 N m s^2, s: 1 rad/s}\n"
    "bodies: {wheel: {inertia: I}}\nconnections: {axle: {axle: wheel}}\nactions: {drive: {couple: DRIVE, on: wheel}}\n"
    "states: {A: {wheel.angular_velocity: FIRST}, B: {wheel.angular_velocity: WORD}}\n"
)
OIL = "M - c*wheel.angular_velocity"
CUBIC = "-M*(wheel.angular_velocity/s - 1)*(wheel.angular_velocity/s - 3)*(wheel.angular_velocity/s - 5)"


def scene(drive: str, first: str, word: str = "settles") -> str:
    return (
        WHEEL.replace("DRIVE", drive).replace("FIRST", first).replace("WORD", word)
        + "find: {x: wheel.angular_velocity at B}\n"
    )


@pytest.mark.parametrize(
    ("drive", "first", "number"),
    [
        (OIL, "0 rad/s", 6.0),
        (OIL, "6 rad/s", 6.0),
        (OIL, "20 rad/s", 6.0),
        (OIL, "-4 rad/s", 6.0),
        ("-c*wheel.angular_velocity", "20 rad/s", 0.0),
        ("M - b*wheel.angular_velocity^2", "20 rad/s", math.sqrt(150)),
        (CUBIC, "0.5 rad/s", 1.0),
        (CUBIC, "2.5 rad/s", 1.0),
    ],
)
def test_it_is_what_the_forces_lead_to(drive: str, first: str, number: float) -> None:
    solution = solve(scene(drive, first))
    assert float(solution.answers["x"].value) == pytest.approx(number, rel=1e-3, abs=1e-9)
    assert "confirmed with numbers" in solution.to("text")


@pytest.mark.parametrize("word", ["settles", "smallest"])
@pytest.mark.parametrize(
    ("drive", "first", "why"),
    [
        ("c*wheel.angular_velocity - M", "9 rad/s", "against its forces"),
        (CUBIC, "3.5 rad/s", "against its forces"),
        (CUBIC, "9 rad/s", "nothing drives it on"),
    ],
)
def test_what_lies_behind_or_beyond_another_one_is_not_reached(word: str, drive: str, first: str, why: str) -> None:
    with pytest.raises(Unsolvable) as error:
        solve(scene(drive, first, word))
    assert "never reached" in error.value.fault.message
    assert why in error.value.fault.help


@pytest.mark.parametrize("drive", ["M*exp(-s*time)", "-M*sin(wheel.angle)", "M"])
def test_what_goes_by_time_or_place_does_not_settle(drive: str) -> None:
    with pytest.raises(Unsolvable, match=r"settles at `B` only where|never reached"):
        solve(scene(drive, "1 rad/s"))


def test_no_time_is_infinite() -> None:
    with pytest.raises(SceneError) as error:
        solve(scene(OIL, "0").replace("wheel.angular_velocity: settles", "time: infinity"))
    assert "settles" in error.value.faults[0].help
