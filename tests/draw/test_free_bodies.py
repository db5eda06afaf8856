"""Free-body diagrams: every force of the facts is in the diagram with its direction, every couple with its turn."""

from __future__ import annotations

import itertools
import math

import pytest
from gallery import PLANE, diagrams, problem

from rotsolve.algebra.formula import ZERO
from rotsolve.core.faults import Unsolvable
from rotsolve.draw.paper.figure import Figure, Line
from rotsolve.draw.pictures import free_body_pictures, stage_of
from rotsolve.draw.plane.facts import SceneFacts
from rotsolve.scene.read import read_text

NEAR = 1e-6


def tagged(figure: Figure) -> dict[str, Line]:
    """The arrows of a diagram by what they stand for."""
    return {mark.tag: mark for mark in figure.marks if isinstance(mark, Line) and mark.tag}


def turning(line: Line) -> float:
    """Twice the area that a line goes round its middle, positive counterclockwise."""
    xs, ys = [x for x, _ in line.points], [y for _, y in line.points]
    middle = (sum(xs) / len(xs), sum(ys) / len(ys))
    arms = [(x - middle[0], y - middle[1]) for x, y in line.points]
    return sum(a * d - b * c for (a, b), (c, d) in itertools.pairwise(arms))


@pytest.mark.parametrize("name", PLANE)
def test_every_force_and_couple_of_the_facts_is_drawn(name: str) -> None:
    states = problem(name).states
    known = SceneFacts(stage_of(problem(name), states[0].name if states else ""))
    found = dict(diagrams(name))
    for body in known.facts.bodies:
        forces = [force for force in body.forces if force.size != ZERO]
        couples = [couple for couple in body.couples if couple.torque != ZERO]
        assert (body.name in found) == bool(forces or couples)
        arrows = tagged(found[body.name]) if body.name in found else {}
        assert len(arrows) == len(forces) + len(couples)
        for number, force in enumerate(forces):
            (ax, ay), (bx, by) = arrows[f"{body.name} {number}"].points
            x, y = known.arrow(force.direction)
            assert math.hypot(x, y) == pytest.approx(1.0, abs=NEAR)
            long = math.dist((ax, ay), (bx, by))
            assert ((bx - ax) / long, (by - ay) / long) == pytest.approx((x, y), abs=1e-9)
        for number, couple in enumerate(couples):
            assert turning(arrows[f"{body.name} couple {number}"]) * known.number(couple.torque) >= 0.0


def test_letters_are_those_of_the_derivation() -> None:
    """What is asked for has the name of its question."""
    labels = {label.text for _, figure in diagrams("pulleys/double-atwood") for label in figure.labels}
    assert {"T₁", "T₂", "T₃", "T₄", "m₁ g", "m₂ g", "m₃ g", "M₁ g", "M₂ g"} <= labels


LADDER = """
title: Ladder
given: {M: 2 kg, L: 3 m}
surfaces: {floor: level, side: {wall: right}}
bodies: {ladder: {shape: rod, mass: M, length: L}}
connections:
  foot: {contact: [ladder.start, floor], friction: any}
  head: {contact: [ladder.end, side]}
states: {still: {ladder.angle: 60 deg, at rest: all, balance: true}}
find: {N: foot.normal_force, f: foot.friction_force}
"""


def test_a_ladder_is_pushed_where_it_stands() -> None:
    """Up at its foot, left at its head, down in its middle."""
    [(name, figure)] = free_body_pictures(read_text(LADDER))
    places = {label.text: label.at for label in figure.labels}
    arrows = sorted(
        (tuple(round(b - a) for a, b in zip(*mark.points, strict=True)), mark.points[0])
        for mark in tagged(figure).values()
    )
    assert name == "ladder"
    assert {"N", "f", "M g"} <= set(places)
    ways = {way for way, _ in arrows}
    assert {(0, 42), (0, -42), (-42, 0)} <= ways
    starts = dict(arrows)
    assert starts[0, 42][1] < starts[0, -42][1] < starts[-42, 0][1]


def test_where_nothing_acts_there_is_no_diagram() -> None:
    still = "title: Wheel\nplane: horizontal\ngiven: {w: 3 rad/s}\nbodies: {wheel: {radius: 1 m}}\n"
    still += "states: {now: {wheel.angular_velocity: w}}\nfind: {K: wheel.angular_velocity}\n"
    with pytest.raises(Unsolvable, match="nothing acts"):
        free_body_pictures(read_text(still))
