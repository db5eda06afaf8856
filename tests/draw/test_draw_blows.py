"""The blow of an event is in the picture of the state at which it strikes: up to its point, along its direction, with its letter."""

from __future__ import annotations

import math

import pytest

from rotsolve.draw.paper.figure import FORCE, Figure, Line
from rotsolve.draw.pictures import scene_picture
from rotsolve.scene.read import read_text

STRUCK = """
plane: horizontal
given: {{M: 1.5 kg, L: 80 cm, J: 2.4 N s}}
bodies: {{rod: {{shape: rod, mass: M, length: L}}}}
states: {{still: {{at rest: all}}, struck: {{}}}}
events: {{blow: {{impulse: J, on: rod.at(60 cm), direction: {way}, from: still, to: struck}}}}
find: {{v: rod.velocity.y at struck}}
"""


def blows(figure: Figure) -> list[Line]:
    return [mark for mark in figure.marks if isinstance(mark, Line) and mark.role is FORCE]


@pytest.mark.parametrize(("way", "sense"), [("up", 1.0), ("down", -1.0)])
def test_a_blow_ends_where_it_strikes(way: str, sense: float) -> None:
    """Three quarters of the way along the rod, which lies level."""
    figure = scene_picture(read_text(STRUCK.format(way=way)))
    (arrow,) = blows(figure)
    (ax, ay), (bx, by) = arrow.points
    rod = next(mark for mark in figure.marks if isinstance(mark, Line) and mark.closed)
    left, right = (end(x for x, _ in rod.points) for end in (min, max))
    assert ax == pytest.approx(bx) and math.copysign(1.0, by - ay) == sense
    assert (bx - left) / (right - left) == pytest.approx(0.75, abs=0.02)
    assert "J" in {label.text for label in figure.labels}


def test_after_the_blow_it_is_gone() -> None:
    assert not blows(scene_picture(read_text(STRUCK.format(way="up")), "struck"))
