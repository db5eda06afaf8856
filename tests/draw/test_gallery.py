"""Every bundled problem is drawn: its lines are finite, its arrows have a length, its labels are free and on the paper, and it is the same
each time."""

from __future__ import annotations

import math
import re
import xml.etree.ElementTree as ElementTree
from itertools import combinations

import pytest
from gallery import DRAWN, NAMES, PLANE, diagrams, pictures, problem, scene, ways

from rotsolve.core.faults import Unsolvable
from rotsolve.draw.paper.figure import Circle, Figure, Line, boxes_apart
from rotsolve.draw.paper.labels import crosses, straight_pieces
from rotsolve.draw.paper.svg import svg
from rotsolve.draw.paper.tikz import tikz
from rotsolve.draw.pictures import free_body_pictures, scene_picture

SHORTEST = 4.0  # points of an arrow that is seen
LARGEST = 1000.0  # points of a picture
COVERED = 0.02  # of all labels lie on a line, where there is no room beside it


def points(figure: Figure) -> list[tuple[float, float]]:
    """All points of a picture."""
    found = [point for mark in figure.marks if isinstance(mark, Line) for point in mark.points]
    return found + [mark.centre for mark in figure.marks if isinstance(mark, Circle)]


def test_what_has_no_bodies_is_refused() -> None:
    for name in set(NAMES) - set(DRAWN):
        with pytest.raises(Unsolvable, match="no bodies"):
            scene_picture(problem(name))


@pytest.mark.parametrize("name", DRAWN)
def test_numbers_are_finite_and_arrows_are_seen(name: str) -> None:
    for figure in pictures(name):
        assert points(figure)
        assert all(map(math.isfinite, (part for point in points(figure) for part in point)))
        for mark in figure.marks:
            if isinstance(mark, Line) and mark.heads:
                long = sum(math.dist(one, other) for one, other in zip(mark.points, mark.points[1:], strict=False))
                assert long > SHORTEST, (mark.role.name, mark.points)
        left, low, right, high = figure.box()
        assert right - left < LARGEST and high - low < LARGEST


@pytest.mark.parametrize("name", DRAWN)
def test_labels_share_no_room_and_are_on_the_paper(name: str) -> None:
    for figure in pictures(name):
        left, low, right, high = figure.box()
        for label in figure.labels:
            a, b, c, d = label.box
            assert left <= a and low <= b and c <= right and d <= high
        for one, other in combinations(figure.labels, 2):
            assert boxes_apart(one.box, other.box), (one.text, other.text)


def test_labels_cover_nothing() -> None:
    """But for a few where there is no room at all."""
    covered, count = [], 0
    for name in DRAWN:
        for figure in pictures(name):
            ink = [mark for mark in figure.marks if mark.role.ink and mark.role.name != "hatch"]
            lines = [piece for mark in ink for piece in straight_pieces(mark)]
            for label in figure.labels:
                count += 1
                if any(crosses(piece, label.box) for piece in lines):
                    covered.append((name, label.text))
    assert len(covered) <= COVERED * count, covered


@pytest.mark.parametrize("name", DRAWN[::4])
def test_the_same_scene_gives_the_same_picture(name: str) -> None:
    again = scene_picture(problem(name))
    assert svg(again) == svg(scene(name))
    assert tikz(again) == tikz(scene(name))


@pytest.mark.parametrize("name", PLANE[::9])
def test_the_same_forces_give_the_same_diagrams(name: str) -> None:
    again = free_body_pictures(problem(name), "", ways(name)) if diagrams(name) else ()
    for (_, _, one), (_, _, other) in zip(again, diagrams(name), strict=True):
        assert svg(one) == svg(other)


@pytest.mark.parametrize("name", DRAWN)
def test_svg_is_xml_with_words_as_words(name: str) -> None:
    text = svg(scene(name))
    root = ElementTree.fromstring(text)
    space = "{http://www.w3.org/2000/svg}"
    assert root.find(f"{space}title").text == problem(name).title  # type: ignore[union-attr]
    assert root.find(f"{space}desc").text  # type: ignore[union-attr]
    said = ["".join(item.itertext()) for item in root.iter(f"{space}text")]
    assert len(said) == len(scene(name).labels)
    assert "prefers-color-scheme" in text
    assert "nan" not in re.sub(r"<(title|desc|text)[^>]*>.*?</\1>", "", text)


@pytest.mark.parametrize("name", DRAWN[::5])
def test_tikz_is_balanced(name: str) -> None:
    text = tikz(scene(name))
    assert text.count("{") == text.count("}")
    assert text.count(r"\begin{tikzpicture}") == text.count(r"\end{tikzpicture}") == 1
    body = [line for line in text.splitlines() if line.startswith("\\") and "tikzpicture" not in line]
    assert all(line.endswith(";") for line in body)
