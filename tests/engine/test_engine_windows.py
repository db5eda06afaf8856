"""Windows: of a scene with one letter every case is told with all its conditions, however narrow the range in which it holds.

Each scene is answered with the letter, and with many numbers for it: where a condition holds its answer is that of the numbers.
"""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.pipeline import solve_problem
from rotsolve.scene.read import read_text

ROOT = Path(__file__).resolve().parents[2]
sys.path.append(str(ROOT / "benchmarks"))

from compositions import freed  # noqa: E402

LOAD_AND_SLOPE = """
given: {m: 4 kg, M: LETTER, beta: 35 deg, mu: 0.15}
surfaces: {ramp: {slope: beta, down: left}}
bodies: {block: {mass: m, moves: up}, pulley: {mass: 0, radius: 10 cm}, load: {mass: M, moves: down}}
connections: {touch: {contact: [block, ramp], friction: mu}, axle: {axle: pulley}, rope: {string: [block, pulley, load]}}
find: {a: load.acceleration, f: touch.friction_force}
"""
WALL = """
given: {m: 2 kg, F: LETTER, mu: 0.3}
surfaces: {side: {wall: right}}
bodies: {block: {mass: m, moves: up}}
connections: {touch: {contact: [block, side], friction: mu}}
actions: {push: {force: F, on: block, direction: 40 deg}}
find: {a: block.acceleration, f: touch.friction_force}
"""
RUBBING_AXLE = """
given: {m: 5 kg, M: LETTER, R: 20 cm, J: 0.1 kg m^2, tau: 0.4 N m}
bodies: {wheel: {inertia: J, radius: R, turns: clockwise}, left: {mass: m, moves: up}, load: {mass: M, moves: down}}
connections: {axle: {axle: wheel, friction_torque: tau}, rope: {string: [left, wheel, load]}}
find: {a: load.acceleration, T: rope.load.tension}
"""
ROUGH_HINGE = """
given: {M: 3 kg, m: 2 kg, L: 2 m, p: 1.2 m, x: LETTER, tau: 3 N m}
bodies: {rod: {shape: rod, mass: M, length: L}, load: {mass: m}}
connections: {pin: {hinge: rod.at(p), friction_torque: tau}, clip: {weld: [rod.at(x), load]}}
states: {now: {rod.angle: 0, at rest: all}}
find: {al: rod.angular_acceleration at now}
"""
ROLLER = """
given: {m: 2 kg, R: 10 cm, Q: 12 N m, F: LETTER, mu: 0.2}
surfaces: {floor: level}
bodies: {roller: {shape: cylinder, mass: m, radius: R, moves: right, turns: clockwise}}
connections: {touch: {contact: [roller, floor], friction: mu}}
actions: {motor: {couple: Q, on: roller, direction: clockwise}, pull: {force: F, on: roller.center, direction: right}}
find: {a: roller.acceleration, al: roller.angular_acceleration, f: touch.friction_force}
"""
SPRING = """
given: {m: 1 kg, k: 100 N/m, x: LETTER, mu: 0.3, F: 8 N}
surfaces: {floor: level}
bodies: {block: {mass: m, moves: right}}
connections: {base: {contact: [block, floor], friction: mu}, coil: {spring: [ground, block], stiffness: k}}
actions: {pull: {force: F, on: block, direction: right}}
states: {now: {coil.elongation: x, at rest: all}}
find: {a: block.acceleration at now}
"""
SCENES = {
    "load and slope": (LOAD_AND_SLOPE, "kg", (0.5, 6.0)),
    "wall": (WALL, "N", (2.0, 80.0)),
    "rubbing axle": (RUBBING_AXLE, "kg", (4.0, 6.0)),
    "rough hinge": (ROUGH_HINGE, "m", (0.1, 1.95)),
    "roller": (ROLLER, "N", (90.0, 300.0)),
    "spring": (SPRING, "m", (0.01, 0.2)),
}
STEPS = 24


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("text", "unit", "ends"), SCENES.values(), ids=SCENES)
def test_no_case_is_missing_and_none_says_too_much(
    text: str, unit: str, ends: tuple[float, float], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(
        "rotsolve.search.acting.acting_forward", lambda _: frozenset()
    )  # friction in one sense in all cases
    lettered = solve_problem(read_text(text.replace("LETTER", unit)), confirm=False).derivation
    told = {answer.name: answer for answer in lettered.answers}
    assert all(len(answer.otherwise) > 1 for answer in told.values())
    for step in range(STEPS):
        size = ends[0] + (ends[1] - ends[0]) * (step + 0.37) / STEPS
        problem = read_text(text.replace("LETTER", f"{size:.6g} {unit}"))
        try:
            numbered = solve_problem(problem, confirm=False).derivation
        except (Unsolvable, SceneError) as error:
            pytest.fail(f"{size} {unit}: {error}")
        for answer in numbered.answers:
            assert list(freed.apart(answer, told[answer.name], problem.values)) == [], size


def test_a_vector_of_the_same_size_in_two_cases_points_another_way_in_each() -> None:
    text = LOAD_AND_SLOPE.replace("a: load.acceleration, f: touch.friction_force", "F: touch.force")
    told = solve_problem(read_text(text.replace("LETTER", "kg"))).derivation.answers[0]
    for size in ("0.9 kg", "2.2 kg", "5 kg"):
        problem = read_text(text.replace("LETTER", size))
        assert list(freed.apart(solve_problem(problem).derivation.answers[0], told, problem.values)) == []


@pytest.mark.parametrize(("size", "way"), [("0.9 kg", "up the slope"), ("5 kg", "down the slope")])
def test_each_case_says_its_own_direction(size: str, way: str) -> None:
    """Friction that is the same in size in two cases points another way in each."""
    told = solve_problem(read_text(LOAD_AND_SLOPE.replace("LETTER", "kg"))).derivation.answers[1]
    problem = read_text(LOAD_AND_SLOPE.replace("LETTER", size))
    fitting = [
        case for case in (told, *told.otherwise) if all(freed.holds(one, problem.values) for one in case.conditions)
    ]
    assert [case.direction for case in fitting] == [way]
    assert solve_problem(problem).derivation.answers[1].direction == way
