"""Functions of time in letters: each case tells up to which state they hold, as numbers on either side of its condition do."""

from __future__ import annotations

from collections.abc import Mapping

import pytest

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.core.derivation import Answer, Equality
from rotsolve.core.symbols import TIME
from rotsolve.pipeline import solve
from rotsolve.solution import Solution

PULLED = """
title: A block that a growing force pulls
given: {m: kg, c: N/s, mus: number, muk: number, T: s}
surfaces: {floor: level}
bodies: {b: {mass: m, moves: WAY}}
connections: {base: {contact: [b, floor], friction: {static: mus, kinetic: muk}}}
actions: {pull: {force: c*time, on: b, direction: WAY}}
states: {start: at rest, end: {time: T}}
find:
  v: b.velocity at any time
  a: b.acceleration at any time
  x: b.displacement at any time
  f: base.friction_force at any time
  E: b.kinetic_energy at any time
  P: pull.power at any time
"""
SLIDING = """
title: A block that slides up or along and comes to rest
given: {m: kg, u: m/s, mu: number, beta: rad, T: s}
surfaces: {ramp: {slope: beta}}
bodies: {b: {mass: m, moves: up}}
connections: {base: {contact: [b, ramp], friction: mu}}
states: {start: {b.velocity: u}, end: {time: T}}
find: {v: b.velocity at any time, x: b.displacement at any time, f: base.friction_force at any time}
"""
WHEEL = """
title: A wheel on an axle with friction
given: {J: kg m^2, c: N m/s, tau: N m, T: s}
bodies: {wheel: {inertia: J, radius: 0.5 m}}
connections: {axle: {axle: wheel, friction_torque: tau}}
actions: {motor: {couple: c*time, on: wheel}}
states: {start: at rest, end: {time: T}}
find: {w: wheel.angular_velocity at any time, turned: wheel.rotation at any time, E: wheel.kinetic_energy at any time}
"""
PAIR = """
title: Two blocks on a string, of which one is rough
given: {m: kg, M: kg, c: N/s, mu: number, T: s}
surfaces: {floor: level}
bodies: {a: {mass: m, moves: right}, b: {mass: M, moves: right}}
connections: {rough: {contact: [a, floor], friction: mu}, smooth: {contact: [b, floor]}, s: {string: [a, b]}}
actions: {pull: {force: c*time, on: b, direction: right}}
states: {start: at rest, end: {time: T}}
find: {v: b.velocity at any time, S: s.tension at any time}
"""
SLOPE = """
title: A force that grows up a slope
given: {m: kg, beta: rad, mu: number, c: N/s, T: s}
surfaces: {ramp: {slope: beta, down: left}}
bodies: {b: {mass: m, moves: up}}
connections: {base: {contact: [b, ramp], friction: mu}}
actions: {pull: {force: c*time, on: b, direction: beta}}
states: {start: at rest, end: {time: T}}
find: {v: b.velocity at any time}
"""
BLOCK = {"m": "2 kg", "c": "4.9 N/s", "muk": "0.3", "T": "2 s"}
THROWN = {"m": "2 kg", "u": "4 m/s", "mu": "0.5"}
TURNED = {"J": "2 kg m^2", "c": "5 N m/s", "tau": "10 N m"}
JOINED = {"m": "2 kg", "M": "3 kg", "c": "9.8 N/s", "mu": "0.5"}
SLOPES = (
    {"m": "2 kg", "c": "4 N/s", "beta": "20 deg", "mu": "0.5"},
    {"m": "2 kg", "c": "4 N/s", "beta": "30 deg", "mu": "0.4"},
)
KINDS = [
    (PULLED.replace("WAY", "right"), [BLOCK | {"mus": mus} for mus in ("0.4", "0.5", "0.6")], "slip"),
    (
        PULLED.replace("WAY", "left").replace("m: kg", "m: 2 kg"),
        [BLOCK | {"mus": mus} for mus in ("0.4", "0.5", "0.6")],
        "slip",
    ),
    (
        SLIDING,
        [THROWN | {"beta": beta, "T": time} for beta in ("10 deg", "40 deg") for time in ("0.2 s", "0.7 s")],
        "rest",
    ),
    (WHEEL, [TURNED | {"T": time} for time in ("1.9 s", "2 s", "6 s")], "go"),
    (PAIR, [JOINED | {"T": time} for time in ("0.9 s", "1 s", "3 s")], "slip"),
    (SLOPE, [slope | {"T": time} for slope in SLOPES for time in ("0.1 s", "2 s", "9 s")], "slip"),
]


def holds(condition: Equality, values: Mapping[str, object]) -> bool:
    gap = evaluate(condition.left - condition.right, values).float
    return {">": gap > 0, "<": gap < 0, "≥": gap >= 0, "≤": gap <= 0}[condition.relation]


def fitting(answer: Answer, values: Mapping[str, object]) -> list[Answer]:
    """The cases of an answer whose conditions hold."""
    return [one for one in (answer, *answer.otherwise) if all(holds(each, values) for each in one.conditions)]


def on_the_verge(solution: Solution) -> bool:
    """Whether numbers say themselves that the least change decides what is so: letters may then give no answer on that edge."""
    return any(check.holds is None and "least change" in "".join(map(str, check.words)) for check in solution.checks)


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("text", "sets", "state"), KINDS)
def test_each_case_tells_the_part_that_numbers_do(text: str, sets: list[dict[str, str]], state: str) -> None:
    lettered = solve(text, confirm=False).derivation.answers
    parts = set()
    for settings in sets:
        numbered = solve(text, settings=settings, confirm=False)
        values = {**numbered.problem.values, TIME: numbered.problem.values["T"] / 7}
        assert [answer.name for answer in lettered] == [answer.name for answer in numbered.derivation.answers]
        for told, known in zip(lettered, numbered.derivation.answers, strict=True):
            cases = fitting(told, values)
            assert len(cases) == 1 or (not cases and on_the_verge(numbered))
            if not cases:
                continue
            (case,) = cases
            assert case.remark == known.remark
            forms = (case.closed, known.closed)
            found = [evaluate(form, values).float for form in forms if form is not None]
            assert len(found) == 2 and found[0] == pytest.approx(found[1])
            parts.add(case.remark)
    assert parts >= {(), (f"up to {state}",)}  # both sides are looked at


def test_the_page_says_when_that_state_is() -> None:
    text = solve(PULLED.replace("WAY", "right")).to("text", width=120)
    assert "v(t) = 0 m/s (up to slip) (if mus < c T/(m g))" in text
    assert text.count("slip: b begins to slide at t = mus m g/c") == 1


def test_a_moment_that_letters_do_not_compare_with_it_leaves_the_part() -> None:
    """Whether t = 1 s is before t = mus m g/c numbers alone tell; 5 s is beyond 9.8/4.9 s."""
    text = PULLED.replace("WAY", "right")
    branches = solve(text, at="t=1s").answers["v"].branches
    assert {case.answer.remark for case in branches} == {(), ("up to slip",)}
    known = solve(text, at="t=5s", settings=BLOCK | {"mus": "0.5", "T": "9 s"}).answers["v"]
    assert known.float is None and "is not in this phase" in str(known.answer.remark[-1])


PUSHED = """
title: A box that is pushed
surfaces: {floor: level}
bodies: {b: {mass: m, moves: WAY}}
connections: {base: {contact: [b, floor], friction: none}}
actions: {push: {force: m*a, on: b, direction: WAY}}
states: {start: at rest, far: {b.displacement: p}, more: {b.displacement: q}, end: {b.displacement: 9*p + q}}
phases: {one: {from: start, to: far}, two: {from: far, to: more}}
find: {v: b.velocity at any time during one, w: b.velocity at any time during two}
"""
SPUN = """
title: A wheel that a couple turns
bodies: {b: {inertia: m, turns: WAY}}
connections: {pin: {axle: b}}
actions: {push: {couple: m*a, on: b}}
states: {start: at rest, far: {b.rotation: p}, more: {b.rotation: q}, end: {b.rotation: 9*p + q}}
phases: {one: {from: start, to: far}, two: {from: far, to: more}}
find: {v: b.angular_velocity at any time during one, w: b.angular_velocity at any time during two}
"""
PARTED = {  # the known parts of the way, from far on the second; at t = 2 s it is 4: the remarks beside v and w
    ("", ""): ("up to far, at t = 2 s", "from far on, up to more, at t = 2 s"),
    ("5", ""): ("at t = 2 s", "t = 2 s is not in this phase"),
    ("3", ""): ("t = 2 s is not in this phase", "up to more, at t = 2 s"),
    ("3", "5"): ("t = 2 s is not in this phase", "at t = 2 s"),
    ("1", "2"): ("t = 2 s is not in this phase", "t = 2 s is not in this phase"),
    ("", "5"): ("up to far, at t = 2 s", "from far on, up to more, at t = 2 s"),
}


@pytest.mark.parametrize(("text", "unit", "ways"), [(PUSHED, "m", ("right", "left")), (SPUN, "rad", ("", "clockwise"))])
@pytest.mark.parametrize("known", PARTED)
def test_a_moment_says_between_which_states_of_unknown_time_it_has_to_lie(
    text: str, unit: str, ways: tuple[str, str], known: tuple[str, str]
) -> None:
    for way in ways:
        told = [f"{name}: {size} {unit}".replace("  ", " ") for name, size in zip("pq", known, strict=True)]
        dimension = "kg" if unit == "m" else "kg m^2"
        given = f"given: {{m: {dimension}, a: 2 {unit}/s^2, {', '.join(told)}}}\n"
        scene = text.replace("WAY", way or "counterclockwise")
        answers = solve(given + scene, at="t=2s", confirm=False).derivation.answers
        remarks = ["".join(map(to_text, answer.remark)) for answer in answers]
        assert tuple(remarks) == PARTED[known]


def to_text(part: object) -> str:
    return part if isinstance(part, str) else str(getattr(part, "name", part))
