"""Free-body diagrams: every force of the facts is in the diagram with its direction, every couple with its turn."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator

import pytest
from gallery import PLANE, diagrams, problem, solution, ways

from rotsolve.algebra.formula import Formula
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.numbers import value_of
from rotsolve.core.faults import Unsolvable
from rotsolve.core.symbols import is_key
from rotsolve.draw.paper.figure import UNSURE, Figure, Line
from rotsolve.draw.pictures import free_body_picture, free_body_pictures, known_at
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


def size_by(answers: Callable[[str], Formula | float | None], value: Formula, known: SceneFacts) -> float | None:
    """The number of a size by what the answers make of its letters one by one; None where one of them has none."""
    numbers: dict[str, float] = {}
    try:
        for name in value.symbols():
            if is_key(name) or known.stage.configuration.problem.values.get(name) is None:
                found = answers(name)
                if found is None:
                    return None
                numbers[name] = (
                    value_of(found, known.stage.configuration.problem.values) if isinstance(found, Formula) else found
                )
        return float(value_of(value, {**known.stage.configuration.problem.values, **numbers}))
    except (ArithmeticError, ValueError, LookupError, NotConfirmed):
        return None


def drawn_at(name: str) -> Iterator[tuple[SceneFacts, dict[str, Figure]]]:
    """The states of a problem at which its diagrams are drawn, with the diagram of each body that has one of its own there."""
    figures = diagrams(name)
    states = tuple(dict.fromkeys(state for state, _, _ in figures))
    for known in known_at(problem(name), states, ways(name)):
        yield known, {body: figure for state, body, figure in figures if state == known.stage.state}


@pytest.mark.parametrize("name", PLANE)
def test_every_force_and_couple_is_drawn_as_it_acts(name: str) -> None:
    """What is not nothing, where its body is, with its turn or direction: by the numbers that the answers give its letters, if any."""
    solved = solution(name)
    answers = solved.trace.letter if solved is not None else None
    for known, figures in drawn_at(name):
        weights_at_centres(known)
        for body in (body for body in known.facts.bodies if body.name in figures):
            arrows = tagged(figures[body.name])
            sizes = {f"{body.name} {number}": force.size for number, force in enumerate(body.forces)}
            sizes |= {f"{body.name} couple {number}": couple.torque for number, couple in enumerate(body.couples)}
            assert arrows.keys() == {tag for tag, size in sizes.items() if known.way_of(size) != 0}
            for number, force in enumerate(body.forces):
                tag = f"{body.name} {number}"
                size = size_by(answers, force.size, known) if answers is not None else None
                if tag not in arrows:
                    assert size is None or size == pytest.approx(0.0, abs=1e-9), (tag, force.noun)
                    continue
                (ax, ay), (bx, by) = arrows[tag].points
                x, y = known.arrow(force.direction)
                assert math.hypot(x, y) == pytest.approx(1.0, abs=NEAR)
                long = math.dist((ax, ay), (bx, by))
                along = ((bx - ax) * x + (by - ay) * y) / long
                assert abs(along) == pytest.approx(1.0, abs=NEAR)
                if size is not None:
                    assert along * size >= 0.0, (tag, force.noun, size)
            for number, couple in enumerate(body.couples):
                tag = f"{body.name} couple {number}"
                size = size_by(answers, couple.torque, known) if answers is not None else None
                if tag in arrows and size is not None:
                    assert turning(arrows[tag]) * size >= 0.0, (tag, couple.noun, size)


def weights_at_centres(known: SceneFacts) -> None:
    """The bodies stand where the laws have them: weights act at the centres of mass of the confirming geometry."""
    for force in (force for body in known.facts.bodies for force in body.forces if force.role.weighs):
        body = known.stage.bodies.get(force.part)
        if body is not None and body.outlines and not body.dot:
            there = body.spot(known.stage.model.seats[force.part].rigid.centre)
            assert known.applied(force) == pytest.approx(there, abs=2e-3 * known.stage.sizes.whole), force.part


def test_letters_are_those_of_the_derivation() -> None:
    """What is asked for has the name of its question."""
    labels = {label.text for _, _, figure in diagrams("pulleys/double-atwood") for label in figure.labels}
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
    [(_, name, figure)] = free_body_pictures(read_text(LADDER))
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


def arrows_of(name: str, body: str, state: str) -> dict[str, tuple[int, int]]:
    """The arrows of one diagram of a problem: where each points, by the letter at its tip."""
    [figure] = [figure for at, owner, figure in diagrams(name) if (at, owner) == (state, body)]
    found = {}
    for mark in tagged(figure).values():
        tip = mark.points[-1]
        words = min(
            (label for label in figure.labels if label.ink == "force"), key=lambda label: math.dist(label.at, tip)
        )
        found[words.text] = (round(tip[0] - mark.points[0][0]), round(tip[1] - mark.points[0][1]))
    return found


def test_a_plank_and_its_roller_rub_each_other_as_they_do() -> None:
    """Worked by hand: the plank is held back by the roller, which is pushed on above and below."""
    plank = arrows_of("rolling/plank-on-a-roller", "plank", "start")
    roller = arrows_of("rolling/plank-on-a-roller", "cylinder", "start")
    assert plank["F"] == (42, 0) and plank["f_above"] == (-42, 0)
    assert roller["f_above"] == roller["f_below"] == (42, 0)


def test_a_support_that_has_gone_is_not_drawn() -> None:
    """At the state of the question there is one, and the caption says which state that is."""
    assert arrows_of("hinged/rod-loses-a-support", "rod", "after") == {"F": (0, 42), "m g": (0, -42)}
    [(_, _, figure)] = diagrams("hinged/rod-loses-a-support")
    assert "rod, just after the removal" in {label.text for label in figure.labels}


def test_a_state_that_looks_like_another_one_is_drawn_once() -> None:
    assert {state for state, _, _ in diagrams("rolling/plank-on-a-roller")} == {"start"}
    assert {state for state, _, _ in diagrams("hinged/rod-30")} == {"released", "lowest"}


def test_what_nothing_tells_is_dashed_and_said_so() -> None:
    """The force of a hinge on a rod that is driven round by whatever it takes: no answer tells its parts."""
    name = "angular-momentum/bead-in-a-driven-tube"
    figure = free_body_picture(problem(name), "", ways(name))
    assert {mark.tag for mark in figure.marks if isinstance(mark, Line) and mark.role is UNSURE}
    assert any(label.text.startswith("dashed: nothing tells") for label in figure.labels)
    sure = free_body_picture(problem("hinged/rod-30"), "", ways("hinged/rod-30"))
    assert not any(label.text.startswith("dashed") for label in sure.labels)


def test_a_force_against_its_letter_has_bars() -> None:
    """A rod that is whirled round a shaft is pulled inwards, against the way in which Fx counts."""
    arrows = arrows_of("hinged/conical-pendulum", "string", "round")
    assert arrows["|Fₓ|"] == (-42, 0) and arrows["F_y"] == (0, 42)


def test_without_answers_only_what_the_scene_requires_has_a_sense() -> None:
    """Surfaces press; which way a friction acts is not told before the scene is solved."""
    [(_, _, figure)] = free_body_pictures(read_text(LADDER))
    roles = {mark.tag: mark.role for mark in tagged(figure).values()}
    assert sum(role is UNSURE for role in roles.values()) == 1


def test_where_nothing_acts_a_state_is_named_at_which_something_does() -> None:
    with pytest.raises(Unsolvable) as refused:
        free_body_pictures(problem("hinged/compass-needle"), "", ways("hinged/compass-needle"))
    state = refused.value.fault.help.rpartition(" ")[2].strip("`")
    assert free_body_pictures(problem("hinged/compass-needle"), state, ways("hinged/compass-needle"))
