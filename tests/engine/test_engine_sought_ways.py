"""A letter that is sought where something rubs: the value that, as a given, brings about what the scene tells, whichever way it moves.

A scene is solved in letters for the letter, and with numbers, the letter among them, for what was told: on all branches these are inverse.
"""

from __future__ import annotations

import math
import random
from collections.abc import Mapping

import pytest
from msgspec import Struct

import rotsolve
from rotsolve.confirm.course.samples import holding
from rotsolve.confirm.numbers import value_of

UNITS = {"m": "kg", "M": "kg", "mu": "", "F": "N", "R": "m", "r": "m", "I": "kg m^2", "J": "kg m^2", "P": "N s"}
UNITS |= {"tau": "N m", "Q": "N m", "T": "s", "s": "m", "v": "m/s", "w": "rad/s"}
FLOOR = "surfaces: {floor: level}\n"
PLANK = """surfaces: {ice: level}
bodies: {plank: {mass: M, moves: right}, block: {mass: m, moves: right}}
connections: {below: {contact: [plank, ice]}, grip: {contact: [block, plank], friction: mu}}
actions: {pull: {force: F, on: plank, direction: right}}"""
CLUTCH = """bodies: {plate: {inertia: I}, disc: {inertia: J}}
connections: {shaft: {axle: [plate, disc]}, clutch: {clutch: [plate, disc], friction_torque: tau}}
actions: {push: {couple: Q, on: plate}}"""
RIMS = """bodies: {plate: {inertia: I, radius: R}, disc: {inertia: J, radius: r}}
connections: {one: {axle: plate}, two: {axle: disc}, touch: {contact: [plate, disc], press: F, friction: mu}}
actions: {push: {couple: Q, on: plate}}"""
LOAD = """bodies: {plate: {inertia: I, radius: R, turns: clockwise}, disc: {inertia: J, turns: clockwise}, load: {mass: m, moves: down}}
connections: {shaft: {axle: [plate, disc]}, clutch: {clutch: [plate, disc], friction_torque: tau}, rope: {string: [plate, load]}}"""
WHEEL = """surfaces: {floor: level}
bodies: {wheel: {shape: disc, mass: m, radius: R, moves: right, turns: clockwise}}
connections: {grip: {contact: [wheel, floor], friction: mu}}
actions: {push: {couple: Q, on: wheel, direction: clockwise}}"""
DRUM = """bodies: {drum: {inertia: I, radius: R, turns: clockwise}, load: {mass: m, moves: down}}
connections: {shaft: {axle: drum, friction_torque: tau}, rope: {string: [drum, load]}}"""
KICK = """surfaces: {floor: level}
bodies: {block: {mass: m, moves: right}}
connections: {grip: {contact: [block, floor], friction: mu}}
events: {kick: {impulse: P, on: block, direction: right, from: start, to: after}}"""


class Course(Struct, frozen=True):
    """Bodies that are let go, up to a time or a place, and how fast one is there."""

    scene: str
    letters: str
    end: str
    fast: str
    sought: str
    first: str = "start: at rest"

    def text(self, sought: str = "", way: str = "", numbers: Mapping[str, float] = {}) -> str:
        """The scene with a letter that is sought, unknown or by an equation; or with numbers for what was told."""
        speed = "w" if self.fast.endswith("angular_velocity") else "v"
        names = [*self.letters.split(), *([speed] if sought else [])]
        values = {name: f"{numbers[name]!r} {UNITS[name]}" for name in numbers}
        values |= {sought: "unknown"} if way == "unknown" else {}
        givens = ", ".join(f"{name}: {values.get(name, UNITS[name] or 'number')}" for name in names)
        end = f"{self.end}, {self.fast}: {speed}" if way == "unknown" else self.end
        asked = (
            sought
            if way == "unknown"
            else f"{sought} where {self.fast} = {speed} at end"
            if sought
            else f"{self.fast} at end"
        )
        return f"title: t\ngiven: {{{givens}}}\n{self.scene}\nstates: {{{self.first}, end: {{{end}}}}}\nfind: {{x: {asked}}}\n"


COURSES = {
    "a block on a plank": Course(PLANK, "m M mu F s", "plank.displacement: s", "plank.velocity", "F m"),
    "a clutch, the driving plate": Course(CLUTCH, "I J tau Q T", "time: T", "plate.angular_velocity", "Q I"),
    "a clutch, the driven disc": Course(CLUTCH, "I J tau Q T", "time: T", "disc.angular_velocity", "J"),
    "pressed rims": Course(RIMS, "I J R r mu F Q T", "time: T", "plate.angular_velocity", "Q"),
    "a load on a clutch": Course(LOAD, "I J R tau m T", "time: T", "load.velocity", "m"),
    "a wheel with a motor": Course(WHEEL, "m R mu Q T", "time: T", "wheel.angular_velocity", "Q R"),
    "a load on a stiff axle": Course(DRUM, "I R tau m T", "time: T", "load.velocity", "tau"),
    "a blow and a rough floor": Course(
        KICK, "m mu P s", "block.displacement: s", "block.velocity", "P mu", "start: at rest, after: {}"
    ),
}
CASES = [(name, sought, "unknown") for name, course in COURSES.items() for sought in course.sought.split()]
CASES += [(name, course.sought.split()[0], "where") for name, course in COURSES.items()]
SETS = 5


def drawn(letters: str, rng: random.Random) -> dict[str, float]:
    numbers = {name: round(math.exp(rng.uniform(-0.7, 1.6)), 2) for name in letters.split()}
    numbers |= {name: round(math.exp(rng.uniform(0, 3.5)), 2) for name in numbers if name in ("Q", "F", "P")}
    return numbers | ({"mu": round(rng.uniform(0.02, 0.9), 2)} if "mu" in numbers else {})


def told_by(course: Course, numbers: Mapping[str, float]) -> float:
    """How fast it is there with a set of numbers, 0 where it does not get there."""
    try:
        return rotsolve.solve(course.text(numbers=numbers), confirm=False).answers["x"].float or 0.0
    except rotsolve.Unsolvable:
        return 0.0


@pytest.mark.parametrize(("name", "sought", "way"), CASES)
def test_the_sought_value_brings_about_what_is_told(name: str, sought: str, way: str) -> None:
    course, rng = COURSES[name], random.Random(f"{name} {sought}")
    answer = rotsolve.solve(course.text(sought, way)).answers["x"].answer
    held = 0
    for _ in range(SETS):
        numbers = drawn(course.letters, rng)
        fast = told_by(course, numbers)
        known = {**numbers, "g": 9.8, "v": fast, "w": fast}
        del known[sought]
        case = holding(answer, known) if fast > 0 else None
        if case is None:
            settled = told_by(course, {**numbers, sought: 1.01 * numbers[sought]})
            assert fast == 0 or settled == pytest.approx(fast), f"no case at {numbers}"  # it hangs not on the letter
            continue
        found = value_of(case.closed or case.formula, known)
        held += 1
        assert found == pytest.approx(numbers[sought]) or told_by(course, {**numbers, sought: found}) == pytest.approx(
            fast
        )
    assert held
