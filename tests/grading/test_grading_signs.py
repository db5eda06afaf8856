"""Directions in words, and numbers with a direction behind them."""

from __future__ import annotations

import pytest

from rotsolve.grading.comparing.signs import cut_direction, is_direction, points_other_way


@pytest.mark.parametrize(
    ("words", "holds"),
    [
        ("down", True),
        ("to the left", True),
        ("up and to the right", True),
        ("Upwards", True),
        ("anti-clockwise", True),
        ("down the slope", True),
        ("counterclockwise round the kerb", True),
        ("turning it clockwise", True),
        ("straight up", True),
        ("m/s, up", False),
        ("updown", False),
        ("5 N", False),
        ("", False),
        ("the slope", False),
    ],
)
def test_what_is_a_direction(words: str, holds: bool) -> None:
    assert is_direction(words) is holds


@pytest.mark.parametrize(
    ("one", "other", "turned"),
    [
        ("down", "downwards", False),
        ("down", "up", True),
        ("clockwise", "ccw", True),
        ("to the left", "left", False),
        ("left and up", "up and to the left", False),
        ("right and down", "up and to the left", True),
        ("right and up", "up and to the left", None),
        ("up the incline", "down the slope", True),
        ("up", "left", None),
        ("clockwise", "clockwise round the dome", False),
    ],
)
def test_whether_one_is_the_other_turned_round(one: str, other: str, turned: bool | None) -> None:
    assert points_other_way(one, other) is turned


@pytest.mark.parametrize(
    ("line", "cut"),
    [
        ("5 N, up", ("5 N", "up")),
        ("5 N, up and to the left", ("5 N", "up and to the left")),
        ("5 N, up, to the left", ("5 N", "up, to the left")),
        ("(1, 2) N", ("(1, 2) N", "")),
        ("5 N", ("5 N", "")),
    ],
)
def test_a_direction_behind_a_comma(line: str, cut: tuple[str, str]) -> None:
    assert cut_direction(line) == cut
