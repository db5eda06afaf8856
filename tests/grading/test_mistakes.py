"""Mistakes: each gives the wrong answer that a student would get by it, worked out by hand; none is ever the right one."""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path

import pytest

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.exact.normal import equal
from rotsolve.algebra.formula import Formula
from rotsolve.algebra.notation.parse import parse
from rotsolve.core.derivation import Answer
from rotsolve.grading.mistakes.attempt import Attempt, Route
from rotsolve.grading.mistakes.mistake import Mistake
from rotsolve.grading.mistakes.scene import Scene
from rotsolve.grading.mistakes.table import MISTAKES
from rotsolve.grading.mistakes.wrong_answers import WrongAnswers
from rotsolve.motion.positive import positive_letters
from rotsolve.scene.read import read_file, read_source

ROOT = Path(__file__).resolve().parents[2]
PROBLEMS = sorted((ROOT / "problems").rglob("*.yaml"))
ACCURACY = 1e-9

OWN = {  # scenes for what no bundled problem holds
    "spun-disc": """
        title: Disc spun at a frequency
        given: {M: 2 kg, R: 10 cm, f: 50 Hz}
        bodies: {disc: {shape: disc, mass: M, radius: R}}
        connections: {axle: {axle: disc}}
        states: {now: {disc.angular_velocity: 2*pi*f}}
        find: {K: disc.kinetic_energy, L: disc.angular_momentum}
    """,
    "rim-speed": """
        title: Rim of a wheel
        given: {R: 40 cm, f: 3 Hz}
        bodies: {wheel: {shape: ring, radius: R}}
        connections: {axle: {axle: wheel}}
        states: {now: {wheel.angular_velocity: 2*pi*f}}
        find: {v: wheel.rim.speed}
    """,
    "slowed-wheel": """
        title: Wheel brought to rest
        given: {f: 20 Hz, t: 5 s}
        bodies: {wheel: {shape: disc}}
        connections: {axle: {axle: wheel}}
        actions: {brake: {couple: unknown, on: wheel}}
        states: {start: {wheel.angular_velocity: 2*pi*f}, end: {wheel.angular_velocity: 0, time: t}}
        find: {alpha: wheel.angular_acceleration}
    """,
    "rod-let-go": """
        title: Rod let go at an angle that is written in place
        given: {M: 1 kg, L: 2 m}
        bodies: {rod: {shape: rod, mass: M, length: L}}
        connections: {pin: {hinge: rod.start}}
        states: {released: {rod.angle: 30 deg, at rest: all}}
        find: {alpha: rod.angular_acceleration}
    """,
    "wheels": """
        title: Two pulleys, one behind the other
        given: {m: 2 kg, M1: 1 kg, M2: 3 kg, R: 10 cm, F: 30 N}
        bodies:
          load: {mass: m, moves: up}
          first: {shape: disc, mass: M1, radius: R, turns: clockwise}
          second: {shape: ring, mass: M2, radius: R, turns: clockwise}
        connections:
          axle1: {axle: first}
          axle2: {axle: second}
          string: {string: [load, first, second]}
        actions: {pull: {couple: F*R, on: second}}
        find: {a: load.acceleration}
    """,
}

OWN_IN_SPACE = {
    "plate-set-turning": """
        title: Plate on its diagonal, set turning
        up: z
        gravity: none
        given: {M: 2 kg, a: 0.4 m, b: 0.3 m, omega: 5 rad/s, alpha: 12 rad/s^2}
        bodies: {plate: {shape: rectangle, mass: M, sides: [a, b]}}
        connections: {shaft: {hinge: plate.center, along: [a, b, 0], angular_velocity: omega, angular_acceleration: alpha}}
        find: {tau: shaft.torque in body axes, size: size of shaft.torque}
    """,
    "spun-top": """
        title: Top with its spin told
        up: z
        given: {M: 0.3 kg, l: 4 cm, I1: 8e-4 kg m^2, I3: 9e-5 kg m^2, s: 350 rad/s, theta: 40 deg, g: 9.81 m/s^2}
        bodies: {top: {mass: M, inertia: {about: tip, principal: [I1, I1, I3]}, axis: z, points: {tip: [0, 0, -l]}}}
        connections: {floor: {ball: top.tip}}
        states: {now: {top.tilt: theta, top.spin: s, steady: true}}
        find: {slow: smallest top.precession at now}
    """,
    "leaning-wheel": """
        title: Wheel on a leaning axle
        up: z
        given: {M: 2 kg, R: 0.15 m, l: 0.1 m, w: 80 rad/s, theta: 60 deg, g: 9.8 m/s^2}
        bodies: {wheel: {shape: ring, mass: M, radius: R, points: {end: [0, 0, -l]}}}
        connections: {pivot: {ball: wheel.end}}
        states: {now: {wheel.tilt: theta, wheel.axial_rate: w, steady: true}}
        find: {slow: smallest wheel.precession at now}
    """,
    "turned-twice": """
        title: Body turned twice
        up: z
        given: {phi: 50 deg, psi: 20 deg}
        bodies: {body: {turned: [{about: x, by: phi}, {about: y, by: psi}]}}
        find: {e: body.z_axis}
    """,
}
OWN |= OWN_IN_SPACE
OWN["ball-on-a-drum"] = """
    title: Ball on a drum that is free to turn
    given: {M: 4 kg, R: 30 cm, m: 1 kg, r: 5 cm, phi: 60 deg}
    bodies: {drum: {shape: cylinder, mass: M, radius: R}, ball: {shape: sphere, mass: m, radius: r, moves: right}}
    connections: {axle: {axle: drum}, touch: {rolls: [ball, drum]}}
    states: {now: {touch.angle: phi, at rest: all}}
    find: {a: ball.acceleration}
"""

PAPER = (Path(__file__).parent / "mistakes.txt").read_text(encoding="utf-8").splitlines()
ROWS = [tuple(cell.strip() for cell in line.split("|")) for line in PAPER if line and not line.startswith("#")]


@cache
def scene_of(name: str) -> Scene:
    problem = read_source(OWN[name]) if name in OWN else read_file(ROOT / "problems" / f"{name}.yaml")
    return Scene(problem)


def all_mistakes(scene: Scene) -> Iterator[Mistake]:
    return (mistake for kind in MISTAKES for mistake in kind.mistakes(scene))


@cache
def made(name: str, kind: str) -> tuple[Mistake, ...]:
    """The mistakes of one kind in a scene."""
    entry = next(entry for entry in MISTAKES if entry.name == kind)
    return tuple(entry.mistakes(scene_of(name)))


@pytest.mark.parametrize("row", ROWS, ids=[" ".join(row[:3]) for row in ROWS])
def test_a_mistake_gives_the_answer_that_it_gives_on_paper(row: tuple[str, ...]) -> None:
    kind, name, place, asked, text = row
    scene = scene_of(name)
    given = [scene.with_mistake(one) for one in made(name, kind) if place in one.words]
    answers = [answer for one in given if one is not None for answer in asked_of(one, asked)]
    assert answers, [one.words for one in made(name, kind)]
    letters = {*scene.problem.values, *(given.name for given in scene.problem.givens)}
    expected = parse(text, letters)
    assert any(agrees(answer, expected, scene) for answer in answers), answers


def asked_of(answers: Mapping[str, Answer], asked: str) -> Iterator[Answer]:
    """The answer of a name, or a component of one: `L.x`."""
    name, _, part = asked.partition(".")
    if name in answers:
        yield from (one for one in answers[name].components if one.name == part) if part else (answers[name],)


def agrees(answer: Answer, expected: Formula, scene: Scene) -> bool:
    """Whether an answer is the expected one, in form and number as far as it has them."""
    positive = positive_letters(scene.problem.givens)
    form = answer.closed is None or equal(answer.closed, expected, positive)
    unit = 1.0 if answer.unit is None else evaluate(answer.unit.factor, {}).float
    number = evaluate(expected, scene.problem.values).float
    assert answer.value is not None
    return form and abs(answer.value.float * unit - number) <= ACCURACY * abs(number)


def test_each_mistake_is_shown_on_three_scenes() -> None:
    for entry in MISTAKES:
        assert len({row[1] for row in ROWS if row[0] == entry.name}) >= 3, entry.name


@pytest.mark.sampled(18)
@pytest.mark.parametrize("file", PROBLEMS, ids=lambda file: file.stem)
def test_no_mistake_gives_the_published_answer(file: Path) -> None:
    problem = read_file(file)
    positive = positive_letters(problem.givens)
    right = {entry.name: entry for entry in problem.answers}
    for mistake, answers in WrongAnswers.of(problem):
        for name, answer in answers.items():
            published = right[name]
            if published.formula is not None and answer.closed is not None:
                assert not equal(answer.closed, published.formula, positive), (mistake.words, name)
            if published.value is not None and answer.value is not None:
                unit = 1.0 if answer.unit is None else evaluate(answer.unit.factor, {}).float
                value = evaluate(published.value, {}).float
                assert abs(answer.value.float * unit - value) > ACCURACY * abs(value), (mistake.words, name)


def test_places_are_named_one_by_one_and_together() -> None:
    words = [mistake.words for mistake in made("wheels", "pulley without inertia")]
    assert words == [
        "the moment of inertia of the first was left out",
        "the moment of inertia of the second was left out",
        "the moment of inertia of the first and the second was left out",
    ]


def test_places_that_give_the_same_answers_are_named_once() -> None:
    """A rod on a hinge has ½ I ω² alone: its half and that of all kinetic energy are one."""
    found = [one.words for one, _ in WrongAnswers.of(scene_of("hinged/rod-30").whole) if one.name == "half left out"]
    assert found == ["the half was left out in the kinetic energy"]


def test_what_is_right_all_the_same_is_left_out() -> None:
    """The sine for the cosine changes the pull along a slope, and nothing at 45° but the form."""
    source = """
        title: Block on a slope
        given: {m: 2 kg, theta: 45 deg}
        surfaces: {ramp: {slope: theta, down: right}}
        bodies: {block: {mass: m, moves: down}}
        connections: {touch: {contact: [block, ramp]}}
        find: {a: block.acceleration, W: block.force.gravity}
    """
    scene = Scene(read_source(source))
    (mistake,) = (mistake for mistake in all_mistakes(scene) if mistake.name == "sine for cosine")
    answers = scene.with_mistake(mistake)
    assert answers is not None and set(answers) == {"a"}
    assert answers["a"].closed == parse("g*cos(theta)", {"g", "theta"}) and answers["a"].value is None


def test_a_misread_number_changes_no_form() -> None:
    (mistake,) = made("rolling/ball-on-incline", "degrees as radians")
    answers = scene_of("rolling/ball-on-incline").with_mistake(mistake)
    assert answers is not None and "share" not in answers
    assert all(answer.closed is None and answer.value is not None for answer in answers.values())


ANEW = ("pulleys/atwood", "rolling/ball-on-incline", "angular-momentum/bullet-in-rod-swing")


@pytest.mark.sampled(4)
@pytest.mark.parametrize("name", [*ANEW, "space/cube-edge", "space/plate-about-a-corner", "space/leaning-top"])
def test_other_numbers_need_no_other_solving(name: str) -> None:
    """The answers for other numbers are those of the scene with these numbers in it."""
    scene = scene_of(name)
    doubled = {"m2": "6 kg", "R": "23 cm", "theta": "31 deg", "v": "37 m/s", "a": "0.35 m"}
    settings = {given.name: doubled[given.name] for given in scene.problem.givens if given.name in doubled}
    other = Scene(read_file(ROOT / "problems" / f"{name}.yaml", settings))
    for mistake, same in zip(all_mistakes(scene), all_mistakes(other), strict=True):
        answers, anew = scene.with_mistake(mistake), other.with_mistake(same)
        quick = scene.with_values(mistake, answers or {}, other.problem.values)
        assert {key: numbers_of(one) for key, one in (quick or {}).items()} == {
            key: numbers_of(one) for key, one in (anew or {}).items()
        }, mistake.words


def numbers_of(answer: Answer) -> list[str | None]:
    """The number of an answer, then those of its components."""
    own = None if answer.value is None else answer.value.text(6)
    return [own, *(number for part in answer.components for number in numbers_of(part))]


def test_a_scene_that_makes_no_sense_has_no_answers() -> None:
    """A block that falls up reaches no place below."""
    mistakes = made("pulleys/block-on-disc-falling", "sign of gravity")
    for mistake in mistakes:
        answers = scene_of("pulleys/block-on-disc-falling").with_mistake(mistake)
        assert answers is None or "v" not in answers


def test_the_page_lists_the_table() -> None:
    page = (ROOT / "docs" / "mistakes.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (?!mistake|---)([^|]+) \| ([^|]+) \|$", page, re.MULTILINE)
    assert rows == [(entry.name, entry.words) for entry in MISTAKES]


def test_solving_knows_nothing_of_mistakes() -> None:
    code = (
        "import sys, rotsolve; "
        f"rotsolve.solve({str(ROOT / 'problems/pulleys/atwood.yaml')!r}); "
        "print([name for name in sys.modules if 'alteration' in name or 'grading' in name])"
    )
    run = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True, cwd=ROOT)
    assert run.stdout.strip() == "[]"


# how far mistakes are tried


def test_a_line_asks_a_mistake_for_its_own_answer_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of five answers the first is asked about: no other one is worked out with a mistake that does not fit."""
    asked: list[str] = []
    own = Attempt._ask
    monkeypatch.setattr(Attempt, "_ask", lambda self, find: (asked.append(find.name), own(self, find))[1])
    problem = read_file(ROOT / "problems" / "hinged" / "rod-30.yaml")
    table = WrongAnswers.of(problem)
    first = next(find.name for find in problem.finds)
    assert table.first(first, lambda answer: False) is None
    right = [find.name for find in problem.finds]
    assert set(asked[len(right) :]) - set(right[1:]) == {first}
    last = problem.finds[-1].name
    wrong = {mistake.words: answers for mistake, answers in WrongAnswers.of(problem) if last in answers}
    words, answers = next(iter(wrong.items()))
    found = table.first(last, lambda answer: answer.closed == answers[last].closed)
    assert found is not None and found.words == words


@pytest.mark.sampled(60)
@pytest.mark.parametrize("file", PROBLEMS, ids=lambda file: file.stem)
def test_what_is_not_tried_changes_nothing(file: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Tried all the same, mistakes that no answer meets give the right answers."""
    scene = Scene(read_file(file))
    if not scene.settled:
        return
    left = [one for one in all_mistakes(scene) if not one.change.reread]
    left = [one for one in left if not isinstance(scene.attempt(one.change), Attempt)]
    monkeypatch.setattr(Route, "passes_by", lambda self, altered: False)
    assert [one.words for one in left if scene.with_mistake(one) is not None] == []


def test_a_mistake_that_never_ends_keeps_what_it_has() -> None:
    """With the half left out a compass needle comes to rest on top, after a time without an end."""
    problem = read_file(ROOT / "problems" / "hinged" / "compass-needle.yaml")
    found = {mistake.words: answers for mistake, answers in WrongAnswers.of(problem)}
    assert list(found["the half was left out in the kinetic energy"]) == ["phi"]


def test_the_half_of_a_height_is_no_half_of_an_energy() -> None:
    """In the derivative of the energy ½ (a + b) is where the arm's weight acts: no acceleration comes of the half left out."""
    problem = next(file for file in PROBLEMS if file.stem == "planet-wheel-falls-round-a-fixed-wheel")
    found = [answers for mistake, answers in WrongAnswers.of(read_file(problem)) if mistake.name == "half left out"]
    assert [set(answers) for answers in found] == [{"omega1", "omega2"}] * 3


def test_a_root_within_an_angle_is_no_part_of_a_turn() -> None:
    """The mistakes of this scene were an error."""
    problem = next(file for file in PROBLEMS if file.stem == "tennis-racket-in-the-hand")
    assert list(WrongAnswers.of(read_file(problem)))
