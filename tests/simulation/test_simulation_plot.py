"""The plot of a motion: what its curves are called, that no name lies on another, and that it is the same each time."""

from __future__ import annotations

from itertools import pairwise
from pathlib import Path
from xml.etree import ElementTree

import pytest

from rotsolve import simulate
from rotsolve.simulation.choosing import chosen_names
from rotsolve.simulation.plot import curve_label, curve_owner, ends_apart, panels_of
from rotsolve.simulation.senses import sense_words

PROBLEMS = Path(__file__).resolve().parents[2] / "problems"


def test_names_say_the_sense_and_the_unit() -> None:
    run = simulate(PROBLEMS / "pulleys/atwood.yaml", 1.0)
    said = [curve_label(run, name) for name in chosen_names(run, ("motion", "tension"))]
    assert said == [
        "light.position (up), m",
        "light.velocity (up), m/s",
        "heavy.position (down), m",
        "heavy.velocity (down), m/s",
        "pulley.angle (counterclockwise), rad",
        "pulley.angular_velocity (clockwise), rad/s",
        "string.heavy.tension, N",
        "string.light.tension, N",
    ]


@pytest.mark.parametrize(
    ("scene", "name", "sense"),
    [
        ("hinged/ladder", "ladder.position.x", "right"),
        ("hinged/ladder", "ladder.velocity.y", "up"),
        ("hinged/rod-30", "rod.angular_velocity", "counterclockwise"),
        ("hinged/rod-30", "pivot.force.y", "up"),
        ("pulleys/spring-and-pulley", "coil.elongation", ""),
        ("space/top-let-go", "top.spin", ""),
    ],
)
def test_senses_are_the_declared_ones(scene: str, name: str, sense: str) -> None:
    assert sense_words(simulate(PROBLEMS / f"{scene}.yaml", 0.1), name) == sense


def test_a_curve_has_the_colour_of_its_owner() -> None:
    assert curve_owner("string.block.tension") == "string.block"
    assert curve_owner("top.angular_velocity.x in body axes") == "top"
    assert curve_owner("pivot.force.y") == "pivot"


def test_a_panel_holds_one_quantity() -> None:
    names = ("a.velocity", "a.position", "s.tension", "b.position")
    assert panels_of(names) == {
        "position": ["a.position", "b.position"],
        "tension": ["s.tension"],
        "velocity": ["a.velocity"],
    }


@pytest.mark.parametrize("wished", [(0.5,), (0.2, 0.2, 0.2), (0.97, 0.98, 1.0), (-0.2, 0.0, 0.5, 0.52, 1.1)])
def test_names_at_the_ends_keep_apart(wished: tuple[float, ...]) -> None:
    found = ends_apart(wished, 0.1)
    assert all(above - below >= 0.1 - 1e-12 for below, above in pairwise(found))
    assert found[0] >= 0.0 and found[-1] <= 1.0


def test_a_plot_is_the_same_each_time(tmp_path: Path) -> None:
    pytest.importorskip("matplotlib")
    run = simulate(PROBLEMS / "rolling/bowling-ball.yaml", 3.0)
    files = [tmp_path / "one.svg", tmp_path / "other.svg"]
    for file in files:
        run.plot(("motion", "normal_force"), str(file))
    first, second = (file.read_text(encoding="utf-8") for file in files)
    assert first == second
    said = {item.text for item in ElementTree.fromstring(first).iter("{http://www.w3.org/2000/svg}text")}
    assert {"ball.velocity (right), m/s", "ball.angular_velocity (clockwise), rad/s", "grip.normal_force, N"} <= said
    assert "grip: slipping ends" in said
