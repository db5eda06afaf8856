"""The page on which a motion moves: its pictures against the numbers of the motion, its parts, and every bundled scene that is followed.

`pytest --exhaustive` animates all of them with as many pictures as a page has; otherwise each has a few, and not all are taken.
"""

from __future__ import annotations

import json
import math
from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import pytest

from rotsolve import Unsolvable, simulate
from rotsolve.draw.paper.figure import Circle, Line
from rotsolve.draw.paper.reel import Reel
from rotsolve.simulation.animation.clock import clock_for
from rotsolve.simulation.animation.filming import film
from rotsolve.simulation.animation.page import animated
from rotsolve.simulation.animation.reading import MotionReading
from rotsolve.simulation.report import columns_of
from rotsolve.simulation.run import Run

PROBLEMS = Path(__file__).resolve().parents[2] / "problems"
SCENES = sorted(PROBLEMS.glob("*/*.yaml"))
FEW = 6  # pictures of a motion
ANIMATED = 180  # bundled scenes at least
VOID = {"meta", "input", "path", "circle", "rect"}


class Parts(HTMLParser):
    """The elements of a page, each with its attributes, and the texts by the element in which they stand."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.elements: list[tuple[str, dict[str, str | None]]] = []
        self.open: list[str] = []
        self.texts: list[tuple[str, str]] = []
        self.feed(page)
        self.close()

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, dict(attrs)))
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.elements.append((tag, dict(attrs)))

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.texts.append((self.open[-1] if self.open else "", data))

    def all(self, tag: str) -> list[dict[str, str | None]]:
        return [attributes for name, attributes in self.elements if name == tag]

    @property
    def motion(self) -> dict[str, Any]:
        """The data of the script."""
        found: dict[str, Any] = json.loads(
            next(text for tag, text in self.texts if text.startswith("{") and tag == "script")
        )
        return found


@cache
def followed(name: str, until: float) -> Run:
    return simulate(PROBLEMS / f"{name}.yaml", until)


def page_of(name: str, until: float, step: float | None = None) -> str:
    run = followed(name, until)
    return animated(run, columns_of(run), step)


def filmed(name: str, until: float, pictures: int = FEW) -> tuple[Reel, MotionReading]:
    run = followed(name, until)
    reading = MotionReading(run, clock_for(run.end, run.end / pictures).times)
    return film(reading), reading


def test_the_page_stands_alone() -> None:
    page = page_of("rolling/bowling-ball", 3.0)
    parts = Parts(page)
    assert not parts.open
    assert "http:" not in page.replace("http://www.w3.org", "") and "https:" not in page and "src=" not in page
    assert ("title", "Bowling ball that slides until it rolls") in parts.texts
    assert "prefers-color-scheme:dark" in page and "prefers-reduced-motion" in page
    assert [item["aria-label"] for item in parts.all("input")] == ["Time"]
    svg = parts.all("svg")[0]
    assert svg["role"] == "img" and svg["aria-labelledby"] == "picture-title picture-words"


def test_a_page_is_the_same_each_time() -> None:
    run = simulate(PROBLEMS / "pulleys/atwood.yaml", 1.0)
    assert animated(run, columns_of(run)) == page_of("pulleys/atwood", 1.0)


def test_readouts_are_the_numbers_of_the_table() -> None:
    run, parts = followed("rolling/bowling-ball", 3.0), Parts(page_of("rolling/bowling-ball", 3.0))
    motion = parts.motion
    assert motion["names"] == list(columns_of(run)) and len(motion["times"]) == 76
    for number in (0, 17, 50, 75):
        told = run.at(float(motion["times"][number]))
        for name, column in zip(motion["names"], motion["values"], strict=True):
            assert float(column[number].replace("−", "-")) == pytest.approx(told[name][0], rel=1e-4, abs=1e-4)
    said = [text for tag, text in parts.texts if tag in ("th", "small", "td")]
    assert "ball.velocity " in said and "(right)" in said and "m/s" in said


def test_the_page_says_that_bodies_are_small() -> None:
    assert "drawn small" in page_of("pulleys/atwood", 10.0, 1.0) and "drawn small" not in page_of("pulleys/atwood", 1.0)


def test_events_are_marked_and_named() -> None:
    parts = Parts(page_of("rolling/bowling-ball", 3.0))
    tick = next(item for item in parts.all("i") if item.get("class") == "tick")
    assert tick["style"] == "--at:39.34" and tick["title"] == "grip: slipping ends, t = 1.1800638623 s"
    assert parts.motion["events"] == [{"at": pytest.approx(1.18006386), "what": "grip: slipping ends"}]


@pytest.mark.parametrize(
    ("until", "step", "pace"), [(0.2, 0.002, 0.05), (1.0, 0.04, 1.0), (10.0, 0.04, 1.0), (100.0, 0.2, 5.0)]
)
def test_brief_motions_are_slow_and_long_ones_fast(until: float, step: float, pace: float) -> None:
    clock = clock_for(until)
    assert (clock.step, clock.pace) == (pytest.approx(step), pytest.approx(pace))
    assert clock.times[0] == 0.0 and clock.times[-1] == until and clock.times[1] == pytest.approx(step)


def circles(picture: list[Any]) -> list[Circle]:
    return [mark for mark in picture if isinstance(mark, Circle) and mark.role.name == "body"]


def test_a_ball_goes_as_far_as_it_rolls() -> None:
    """Its middle, in its own radii."""
    reel, reading = filmed("rolling/bowling-ball", 3.0)
    first = circles(reel.pictures[0])[0]
    radius = 0.11  # of problems/rolling/bowling-ball.yaml
    for number, picture in enumerate(reel.pictures):
        ball = circles(picture)[0]
        gone = (ball.centre[0] - first.centre[0]) / first.radius * radius
        assert gone == pytest.approx(reading.value("ball.position", number), abs=1e-9)
        assert ball.centre[1] == pytest.approx(first.centre[1])


def test_a_rod_stands_as_it_swings() -> None:
    reel, reading = filmed("hinged/rod-30", 2.0)
    for number, picture in enumerate(reel.pictures):
        rod = next(mark for mark in picture if isinstance(mark, Line) and mark.role.name == "body")
        (ax, ay), (bx, by) = rod.points[0], rod.points[1]
        angle = reading.value("rod.angle", number)
        assert angle is not None
        assert math.remainder(math.atan2(by - ay, bx - ax) - angle, 2 * math.pi) == pytest.approx(0.0, abs=1e-9)


def test_strings_stay_as_long_as_they_are() -> None:
    """What one side of an Atwood machine loses, the other gains; no block comes to its wheel."""
    reel, _ = filmed("pulleys/atwood", 2.0)
    long = []
    for picture in reel.pictures:
        strings = [mark.points for mark in picture if isinstance(mark, Line) and mark.role.name == "string"]
        legs = [math.dist(*points) for points in strings if len(points) == 2]
        assert len(legs) == 2 and min(legs) > 5.0
        long.append(sum(legs))
    assert long == pytest.approx([long[0]] * len(long))


MEETING = """
title: Rod that swings down and strikes a ball
given: {M: 3 kg, m: 0.5 kg, L: 0.8 m, g: 9.81 m/s^2}
bodies: {rod: {shape: rod, mass: M, length: L}, ball: {mass: m, moves: right}}
connections: {pivot: {hinge: rod.start}}
states:
  released: {rod.angle: 0, rod.angular_velocity: 0, ball.velocity: 0}
  lowest: {rod.angle: -90 deg}
  after: {}
events: {hit: {joins: [ball, rod.end], from: lowest, to: after}}
find: {w: rod.angular_velocity at after}
"""


def test_what_meets_at_the_end_is_together_there() -> None:
    run = simulate(MEETING, 2.0)
    reel = film(MotionReading(run, clock_for(run.end, run.end / FEW).times))
    gaps = []
    for picture in reel.pictures:
        ball = next(mark for mark in picture if isinstance(mark, Circle) and mark.role.name == "solid")
        rod = next(mark for mark in picture if isinstance(mark, Line) and mark.role.name == "body")
        end = [(x + u) / 2 for (x, u) in zip(rod.points[1], rod.points[2], strict=True)]
        gaps.append(math.dist(ball.centre, end))
    assert gaps[-1] < 0.5 and gaps == sorted(gaps, reverse=True) and gaps[0] > 100.0
    assert "<code>hit</code> happens at <code>lowest</code>" in animated(run, columns_of(run), 0.1)


def test_a_top_leans_as_its_axis_does() -> None:
    """The nodding of a top in space is that of its tilt: the seen axis of its picture turns with it."""
    from rotsolve.draw.space.view import seen

    reel, reading = filmed("space/top-let-go", 0.2)
    for number, picture in enumerate(reel.pictures):
        axis = next(mark for mark in picture if isinstance(mark, Line) and mark.role.name == "axis")
        (ax, ay), (bx, by) = axis.points
        x, y, z = (reading.value(f"top.z_axis.{part}", number) or 0.0 for part in "xyz")
        wx, wy = seen((x, y, z))
        assert abs((bx - ax) * wy - (by - ay) * wx) < 1e-6 * math.hypot(bx - ax, by - ay)


def test_the_script_shows_what_is_drawn() -> None:
    """Data to pictures and back, to the tenth of a point."""
    motion = Parts(page_of("hinged/rod-30", 2.0, 0.5)).motion
    reel, _ = filmed("hinged/rod-30", 2.0, 4)
    left, _, _, high = reel.box()
    for number, picture in enumerate(reel.pictures):
        lines = [mark.points[0] for mark in picture if isinstance(mark, Line) and mark.role.name == "body"]
        role = motion["roles"].index("body")
        told = [line for line in motion["lines"] if line["r"] == role]
        at = [tuple(item[key] if isinstance(item[key], int) else item[key][number] for key in "xy") for item in told]
        assert at == [(round(10 * (x - left)), round(10 * (high - y))) for x, y in lines]


def attempt(path: Path, *, whole: bool) -> bool:
    """Whether a scene is followed; then it can be animated, if there is anything to draw."""
    try:
        run = simulate(path, 1.0)
    except Unsolvable:
        return False
    if not run.problem.bodies:
        with pytest.raises(Unsolvable, match="no bodies"):
            animated(run, columns_of(run), run.end / FEW)
        return False
    page = animated(run, columns_of(run), None if whole else run.end / FEW)
    parts = Parts(page)
    assert not parts.open and "NaN" not in page and "nan" not in str(parts.motion["lines"])
    assert len(page) < 2_000_000
    wide, tall = map(float, str(parts.all("svg")[0]["viewbox"]).split()[2:])
    assert wide < 1100.0 and tall < 800.0
    return True


@pytest.mark.sampled(12)
@pytest.mark.parametrize("path", SCENES, ids=lambda path: f"{path.parent.name}/{path.stem}")
def test_every_scene_that_is_followed_moves(path: Path, pytestconfig: pytest.Config) -> None:
    attempt(path, whole=pytestconfig.getoption("--exhaustive"))


@pytest.mark.exhaustive
def test_most_scenes_move() -> None:
    assert sum(attempt(path, whole=False) for path in SCENES) >= ANIMATED
