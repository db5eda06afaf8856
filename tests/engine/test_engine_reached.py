"""States to which a motion only comes near, or not at all: refused in numbers, in letters a condition; on both sides of each edge."""

from __future__ import annotations

import math
from collections.abc import Mapping
from functools import cache

import pytest

from rotsolve.confirm.course.samples import holds, with_givens
from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve
from rotsolve.solution import Solution

SCENE = """
title: up to a state
given: {{{given}}}
surfaces: {{ice: level}}
bodies: {{box: {{mass: 2 kg, moves: {way}}}}}
connections: {{base: {{contact: [box, ice]}}}}
actions: {{push: {{force: {force}, on: box, direction: {way}}}}}
states: {{start: {{box.velocity: {first}}}, end: {{{line}}}}}
find: {{{find}}}
"""
SPEED, TIME = "v: box.velocity at end", "t: time from start to end"
KINDS = {  # force on 2 kg, first velocity, the line of the state, what is asked, values on this side of the edge, those beyond it
    "place, drag": ("-c*box.velocity", "u", "box.displacement: d", SPEED, {"c": 1, "u": 3, "d": 5.9}, {"d": 6.1}),
    "speed, drag": ("F - c*box.velocity", "0", "box.velocity: d", TIME, {"F": 6, "c": 2, "d": 2.9}, {"d": 3.1}),
    "from above": ("F - c*box.velocity", "u", "box.velocity: d", TIME, {"F": 6, "c": 2, "u": 9, "d": 3.1}, {"d": 2.9}),
    "square": ("F - c*box.velocity^2", "u", "box.velocity: d", TIME, {"F": 8, "c": 2, "u": 1, "d": 1.9}, {"d": 2.1}),
    "wrong way": ("F - c*box.velocity", "u", "box.velocity: d", TIME, {"F": 6, "c": 2, "u": 1, "d": 2}, {"u": 2.5}),
    "dies out": ("F*exp(-time/T)", "0", "box.velocity: d", TIME, {"F": 6, "T": 2, "d": 5.9}, {"d": 6.1}),
    "turns round": ("F*(1 - time/T)", "0", "box.velocity: d", TIME, {"F": 6, "T": 2, "d": 2.9}, {"d": 3.1}),
    "grows": ("-F*time/T", "u", "box.velocity: d", TIME, {"F": 6, "T": 2, "u": 3, "d": 2.9}, {"d": 3.1}),
    "repelled": (
        "k*box.displacement",
        "u",
        "box.velocity: d",
        "x: box.displacement at end",
        {"k": 8, "u": 3, "d": 4},
        {"d": 2},
    ),
    "largest": ("F - c*box.velocity", "u", "box.velocity: largest", SPEED, {"F": 6, "c": 2, "u": 2.9}, {"u": 3.1}),
    "smallest": ("F - c*box.velocity", "u", "box.velocity: smallest", SPEED, {"F": 6, "c": 2, "u": 3.1}, {"u": 2.9}),
}
UNITS = {"c": "kg/s", "u": "m/s", "d": "m/s", "F": "N", "T": "s", "k": "N/m"}


def written(kind: str, way: str, values: Mapping[str, float] | None) -> str:
    force, first, line, find, known, _ = KINDS[kind]
    units = {**UNITS, **({"d": "m"} if "displacement: d" in line else {}), **({"c": "kg/m"} if "^2" in force else {})}
    given = ", ".join(f"{name}: {'' if values is None else values[name]} {units[name]}" for name in known)
    return SCENE.format(
        given=given,
        way=way,
        force=force,
        first=first,
        line=line,
        find=find.replace("at end", "from start to end") if find.startswith("x") else find,
    )


@cache
def lettered(text: str) -> Solution:
    """Solved once: some kinds differ by their numbers alone."""
    return solve(text)


def answer(solution: Solution) -> float | None:
    (only,) = solution.answers.values()
    return only.float


def sides(kind: str) -> tuple[Mapping[str, float], Mapping[str, float]]:
    known, beyond = KINDS[kind][4:]
    return known, {**known, **beyond}


@pytest.mark.sampled(3)
@pytest.mark.parametrize("way", ["right", "left"])
@pytest.mark.parametrize("kind", KINDS)
def test_numbers_on_both_sides_of_the_edge(kind: str, way: str) -> None:
    within, beyond = sides(kind)
    found = solve(written(kind, way, within))
    assert answer(found) is not None
    assert all(item.holds for item in found.derivation.confirmed)
    with pytest.raises(Unsolvable, match=r"never reached|only approached"):
        solve(written(kind, way, beyond))


@pytest.mark.sampled(4)
@pytest.mark.parametrize(("kind", "way"), [(kind, ("right", "left")[place % 2]) for place, kind in enumerate(KINDS)])
def test_letters_have_the_edge_as_condition(kind: str, way: str) -> None:
    """What is printed holds with the numbers on this side, no case of it with those beyond, and both give one number."""
    solution = lettered(written(kind, way, None))
    derivation = solution.derivation
    within, beyond = (with_givens(solution.problem, numbers) for numbers in sides(kind))
    (found,) = derivation.answers
    cases = (found, *found.otherwise)
    assert not [case for case in cases if all(holds(one, beyond) for one in case.conditions)]
    (own,) = [case for case in cases if all(holds(one, within) for one in case.conditions)]
    assert own.conditions
    assert not [item for item in derivation.confirmed if item.astray]


def test_each_question_of_letters_stands_alone() -> None:
    """Three places on the way of what drag slows down: each has its own condition, what is asked at the start none of theirs."""
    solution = solve("""
title: Wheel that drag slows down, at two places
given: {I: kg m^2, c: N m s, w: rad/s, p: rad, n: rad}
bodies: {wheel: {inertia: I}}
connections: {axle: {axle: wheel}}
actions: {air: {couple: -c*wheel.angular_velocity, on: wheel}}
states: {start: {wheel.angular_velocity: w}, near: {wheel.rotation: p}, far: {wheel.rotation: n}}
find: {a: wheel.angular_acceleration at start, v: wheel.angular_velocity at near, z: wheel.angular_velocity at far}
""")
    sizes = {"I": 1.0, "c": 1.0, "w": 3.0}
    conditions = {answer.name: answer.conditions for answer in solution.derivation.answers}
    assert not solution.refused
    for places, held in (({"p": 1, "n": 1}, {"v", "z"}), ({"p": 1, "n": 3}, {"v"}), ({"p": 4, "n": 1}, set())):
        numbers = {**sizes, **{name: float(size) for name, size in places.items()}}
        assert {name for name in "vz" if all(holds(one, numbers) for one in conditions[name])} == held
    said = ["".join(map(str, check.words)) for check in solution.checks if check.holds is None]
    assert any("no answer for" in words and "`far` is never reached" in words for words in said)
    assert math.isfinite(len(said))


WIRE = """
title: Two discs on a torsion wire
given: {{{given}}}
bodies: {{a: {{inertia: I}}, b: {{inertia: J{turns}}}}}
connections: {{axle: {{axle: {pair}}}, wire: {{torsion: {pair}, stiffness: k}}}}
states: {{start: {{a.angular_velocity: w, b.angular_velocity: {first}, wire.angle: 0}}, end: {{b.angular_velocity: {last}}}}}
find: {{v: a.angular_velocity at end}}
"""
WIRES = {  # turn, first and last speed of b, the speed of a by momentum, I, J, n on this side of the edge and beyond it
    "against": (", turns: clockwise", "w", "0", lambda i, j, n: 2 * (i - j) / i, (1, 2.9, 0), (1, 3.1, 0)),
    "from rest": ("", "0", "w", lambda i, j, n: 2 * (i - j) / i, (1.1, 1, 0), (0.9, 1, 0)),
    "as told": ("", "0", "n*w", lambda i, j, n: 2 * (i - n * j) / i, (1, 2, 0.6), (1, 2, 0.7)),
}


def wired(kind: str, pair: str, values: tuple[float, ...] | None) -> str:
    turns, first, last, *_ = WIRES[kind]
    units = {"I": "kg m^2", "J": "kg m^2", "k": "N m/rad", "w": "rad/s", "n": "number"}
    sizes = {} if values is None else {**dict(zip("IJn", values, strict=True)), "k": 3.0, "w": 2.0}
    names = [name for name in units if name != "n" or "n" in last]
    given = ", ".join(
        f"{name}: {sizes[name]} {units[name] if name != 'n' else ''}" if sizes else f"{name}: {units[name]}"
        for name in names
    )
    return WIRE.format(given=given, turns=turns, pair=pair, first=first, last=last)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("pair", ["[a, b]", "[b, a]"])
@pytest.mark.parametrize("kind", WIRES)
def test_a_wire_gives_no_more_energy_than_it_has(kind: str, pair: str) -> None:
    """The twist at the end that no question asks for has a real value: in numbers, and as a condition of letters."""
    momentum, within, beyond = WIRES[kind][3:]
    assert answer(solve(wired(kind, pair, within))) == pytest.approx(momentum(*within))
    with pytest.raises(Unsolvable, match=r"`end` is never reached"):
        solve(wired(kind, pair, beyond))
    solution = solve(wired(kind, pair, None), confirm=False)
    (found,) = solution.derivation.answers
    for sizes, count in ((within, 1), (beyond, 0)):
        numbers = with_givens(
            solution.problem, {**dict(zip("IJn", map(float, sizes), strict=True)), "k": 3.0, "w": 2.0}
        )
        assert (
            len([case for case in (found, *found.otherwise) if all(holds(one, numbers) for one in case.conditions)])
            == count
        )
