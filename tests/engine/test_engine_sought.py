"""What a question seeks: its value has to be one with which the scene holds, and where several do, one alone is not confirmed."""

from __future__ import annotations

import pytest

import rotsolve
from rotsolve.confirm.course.samples import holding
from rotsolve.confirm.numbers import value_of

DRUM = """
title: Drum with a rubbing axle, a pull on its rim and a load
given: {I: kg m^2, x: m, m: kg, F: N, Q: N m, al: rad/s^2}
bodies:
  drum: {inertia: I, radius: x, turns: clockwise}
  load: {mass: m, moves: down}
connections: {axle: {axle: drum, friction_torque: Q}, rope: {string: [drum, load]}}
actions: {pull: {force: F, on: drum.rim, direction: clockwise}}
states: {start: at rest}
find: {s: SEEK where drum.angular_acceleration = al at start}
"""
TWO_BLOCKS = """
title: Two blocks over a wheel with a motor
given: {I: kg m^2, R: m, m: kg, M: kg, Q: N m, T0: N}
bodies:
  wheel: {inertia: I, radius: R, turns: clockwise}
  one: {mass: M, moves: up}
  two: {mass: m, moves: down}
connections: {axle: {axle: wheel}, rope: {string: [one, wheel, two]}}
actions: {motor: {couple: Q, on: wheel}}
states: {start: at rest}
find: {s: SEEK where rope.one.tension = T0 at start}
"""
TAUT_AT = 39.8 - (39.8**2 - 4 * 0.5 * 55) ** 0.5  # of 0.5 x² − 39.8 x + 55 = 0
LETTERS = {"I": 1.0, "M": 1.0, "R": 1.0, "m": 1.0, "g": 9.8}
# what is sought, the numbers of the letters, its value by hand, or None where the string would have to push
SOUGHT = {
    "a slack rope at the sought radius": (DRUM, "smallest x", {"I": 10.0, "F": 30.0, "Q": 150.0, "al": 2.0}, None),
    "a taut rope at the sought radius": (
        DRUM,
        "smallest x",
        {"I": 10.0, "F": 30.0, "Q": 50.0, "al": 0.5},
        (39.8 - (39.8**2 - 4 * 0.5 * 55) ** 0.5) / 1,
    ),
    "a second string that is slack": (TWO_BLOCKS, "m", {"Q": 50.0, "T0": 25.0}, None),
    "both strings taut": (TWO_BLOCKS, "m", {"Q": 5.0, "T0": 12.0}, (1 * (12 - 9.8) + 12 - 5) / (2 * 9.8 - 12)),
    "a mass that would be negative": (TWO_BLOCKS, "m", {"Q": 50.0, "T0": 15.0}, None),
}


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", SOUGHT)
def test_what_pulls_and_presses_does_so_at_the_value_that_is_sought(name: str) -> None:
    scene, sought, numbers, true = SOUGHT[name]
    answer = rotsolve.solve(scene.replace("SEEK", sought), confirm=False).answers["s"].answer
    known = {**LETTERS, **numbers}
    case = holding(answer, known)
    assert (case is None) == (true is None)
    if case is not None and case.closed is not None and true is not None:
        assert value_of(case.closed, known) == pytest.approx(true, rel=1e-6)


HUNG_DRUM = """
title: Rim at which a load gives a drum an angular acceleration
given: {I: 2 kg m^2, m: 3 kg, x: GIVEN, al: 4 rad/s^2}
bodies: {drum: {inertia: I, radius: x, turns: clockwise}, load: {mass: m, moves: down}}
connections: {axle: {axle: drum}, rope: {string: [drum, load]}}
states: {start: {at rest: all STATE}}
find: {x: ASK, T: rope.tension at start}
"""
# m g x = (I + m x²) al
SMALL, LARGE = ((3 * 9.8 + sign * ((3 * 9.8) ** 2 - 4 * 3 * 4 * 2 * 4) ** 0.5) / (2 * 3 * 4) for sign in (-1, 1))


def hung(given: str, state: str, ask: str) -> str:
    return HUNG_DRUM.replace("GIVEN", given).replace("STATE", state).replace("ASK", ask)


@pytest.mark.parametrize(
    "text",
    [
        hung("unknown", ", drum.angular_acceleration: al", "x"),
        hung("unknown", "", "x where drum.angular_acceleration = al at start"),
    ],
)
def test_a_letter_with_two_values_is_not_answered_by_one_of_them(text: str) -> None:
    with pytest.raises(rotsolve.Unsolvable, match=f"x = {LARGE:g} in SI units makes it so too"):
        rotsolve.solve(text)


@pytest.mark.parametrize(("word", "value"), [("smallest", SMALL), ("largest", LARGE)])
def test_the_smallest_or_the_largest_value_is_told(word: str, value: float) -> None:
    ask = f"{word} x where drum.angular_acceleration = al at start"
    solution = rotsolve.solve(hung("unknown", "", ask))
    assert solution.answers["x"].float == pytest.approx(value)
    assert solution.answers["T"].float == pytest.approx(3 * (9.8 - 4 * value))
    assert "x" in " ".join(str(check.words) for check in solution.checks if "solved with numbers" in str(check.words))


def test_a_value_that_the_scene_does_not_let_be_is_no_rival() -> None:
    """Beyond 22 m the second place is beyond the end of the rod; below that it is as good as the first."""
    scene = """
title: Where a load makes the hinge of a rod carry a given force
given: {M: HEAVY kg, m: 1 kg, L: 1 m, x: m}
bodies: {rod: {shape: rod, mass: M, length: L}, load: {mass: m}}
connections: {pin: {hinge: rod.start}, place: {weld: [rod.at(x), load]}}
states: {start: {rod.angle: 0, at rest: all}}
find: {s: x where pin.force.y = 13*M*g/50 at start}
"""
    place = (150 - (6 * (37 * 30 + 50)) ** 0.5) / 222
    assert rotsolve.solve(scene.replace("HEAVY", "30")).answers["s"].float == pytest.approx(place)
    with pytest.raises(rotsolve.Unsolvable, match="makes it so too"):
        rotsolve.solve(scene.replace("HEAVY", "1"))


def test_questions_that_seek_letters_of_each_other_stand_alone() -> None:
    scene = TWO_BLOCKS.replace("find: {s: SEEK", "find: {t: Q where two.acceleration = 0 at start, s: SEEK").replace(
        "SEEK", "m"
    )
    solution = rotsolve.solve(scene)
    assert list(solution.answers) == ["t"]
    assert "of which this seeks one" in str(solution.refused["s"])


PLACED = """
title: Masses at a place of a rod with which it sets out as told
given: {M: kg, m: kg, L: m, x: m, a: rad/s^2, b: rad/s^2}
bodies: {rod: {shape: rod, mass: M, length: L}, load: {mass: m}}
connections: {pin: {hinge: rod.start}, place: {weld: [rod.at(x), load]}}
states: {start: {rod.angle: 0, at rest: all}}
find:
  m1: m where rod.angular_acceleration = -a at start
  m2: m where rod.angular_acceleration = -b at start
"""


@pytest.mark.exhaustive
def test_each_of_two_questions_that_seek_one_letter_has_its_own_bounds() -> None:
    """m = M L (2 L a − 3 g)/(6 x (g − x a)) is positive, for each of both."""
    answers = rotsolve.solve(PLACED, confirm=False).answers
    for a in (5.0, 16.0, 25.0):
        for b in (4.0, 17.0, 26.0):
            known = {"M": 1.0, "L": 1.0, "x": 0.5, "a": a, "b": b, "g": 9.8}
            for name, rate in (("m1", a), ("m2", b)):
                possible = (2 * rate - 3 * 9.8) / (6 * 0.5 * (9.8 - 0.5 * rate)) > 0
                assert possible or holding(answers[name].answer, known) is None
