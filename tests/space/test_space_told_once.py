"""How a body in space goes and turns is told in one way at a state: two ways that do not go together are refused by name, at the second
of them; those that the tilt ties together are held against each other."""

from __future__ import annotations

from itertools import combinations

import pytest

from rotsolve import Unsolvable, solve

BODY = """up: z
gravity: none
given: {A: 3 kg m^2, C: 1 kg m^2, a: 3 rad/s, b: -2 rad/s, c: 5 rad/s, th: 40 deg, ps: 25 deg, ph: 15 deg}
bodies: {one: {mass: 2 kg, inertia: {principal: [A, A, C]}, axis: z, points: {P: [0, 0, 0]}}}
HELD
states: {now: {TOLD}}
find: {L: size of one.angular_momentum at now}
"""
NODE = "[b, a*sin(th), a*cos(th) + c]"
OWN = "[b*cos(ps) + a*sin(th)*sin(ps), a*sin(th)*cos(ps) - b*sin(ps), a*cos(th) + c]"
SPACE = "[b*cos(ph) + c*sin(th)*sin(ph), b*sin(ph) - c*sin(th)*cos(ph), a + c*cos(th)]"
VECTORS = {"": SPACE, " in body axes": OWN, " in node axes": NODE}
RATES = {"axial_rate": "a*cos(th) + c", "spin": "c", "precession": "a", "nutation": "b"}
STANDS = "one.tilt: th, one.spin_angle: ps, one.precession_angle: ph"
HELD = ("", "connections: {j: {ball: one.P}}")
SIZE = 11.07835722919061  # |(A ω₁, A ω₂, C ω₃)|, by numpy


def vector(axes: str, factor: str = "") -> str:
    """The angular velocity as one line; a factor makes it another one."""
    told = (
        VECTORS[axes]
        if not factor
        else "[" + ", ".join(f"{factor}*({part})" for part in VECTORS[axes][1:-1].split(", ")) + "]"
    )
    return f"one.angular_velocity{axes}: {told}"


def size(*told: str, held: str = "") -> float:
    found = solve(BODY.replace("HELD", held).replace("TOLD", ", ".join(told)))
    assert all(item.holds for item in found.derivation.confirmed)
    answer = found.answers["L"].float
    assert answer is not None
    return answer


def refused(*told: str, held: str = "") -> str:
    with pytest.raises(Unsolvable) as error:
        solve(BODY.replace("HELD", held).replace("TOLD", ", ".join(told)))
    return str(error.value)


@pytest.mark.parametrize("held", HELD)
@pytest.mark.parametrize("axes", VECTORS)
@pytest.mark.parametrize("rate", RATES)
def test_rates_beside_a_vector_go_with_it_where_it_is_told_how_the_body_stands(held: str, axes: str, rate: str) -> None:
    line = f"one.{rate}: {RATES[rate]}"
    assert size(STANDS, vector(axes), line, held=held) == pytest.approx(SIZE, rel=1e-12)
    other = refused(STANDS, vector(axes), f"one.{rate}: 1.1*({RATES[rate]})", held=held)
    assert "the data contradict each other at `now`" in other
    assert f"by all else that is told `one.{rate}` would be" in other


@pytest.mark.parametrize("held", HELD)
@pytest.mark.parametrize("axes", ["", " in body axes"])
@pytest.mark.parametrize("rate", ["axial_rate", "nutation"])
def test_a_rate_beside_a_vector_is_refused_without_a_tilt(held: str, axes: str, rate: str) -> None:
    told = refused(vector(axes), f"one.{rate}: {RATES[rate]}", held=held)
    assert f"how `one` turns is told twice at `now`: by its `angular_velocity` and its `{rate}`" in told
    assert "leave one of them out, or tell `one.tilt`" in told


@pytest.mark.parametrize("factor", ["", "1.1"])
@pytest.mark.parametrize("stands", ["", STANDS])
@pytest.mark.parametrize("pair", list(combinations(VECTORS, 2)))
def test_two_vectors_are_refused(pair: tuple[str, str], stands: str, factor: str) -> None:
    told = refused(*filter(None, [stands]), vector(pair[0]), vector(pair[1], factor))
    assert "`one.angular_velocity` is told twice at `now`" in told


@pytest.mark.parametrize(
    ("told", "word"),
    [
        (("one.angular_velocity: [a, 0, b]", "one.angular_velocity.x: a"), "angular_velocity"),
        (
            ("one.angular_velocity.x: a", "one.angular_velocity.y in body axes: b", "one.angular_velocity.z: c"),
            "angular_velocity",
        ),
        (("one.velocity: [1 m/s, 0, 0]", "one.velocity in body axes: [1 m/s, 0, 0]"), "velocity"),
        (("one.P.velocity: [1 m/s, 0, 0]", "one.P.velocity in body axes: [1 m/s, 0, 0]"), "P.velocity"),
    ],
)
def test_components_are_told_once_along_one_set_of_axes(told: tuple[str, ...], word: str) -> None:
    assert f"`one.{word}` is told twice at `now`" in refused(*told)


@pytest.mark.parametrize(
    "line", ["one.angular_velocity: [a, 0, b]", "one.tilt: th, one.spin: c", "one.velocity: [1 m/s, 0, 0]"]
)
def test_what_is_at_rest_does_not_move(line: str) -> None:
    assert "`one` is at rest at `now`, and its `" in refused("at rest: one", line)


def test_spin_and_axial_rate_are_two_words_for_two_rates() -> None:
    told = refused(STANDS, "one.spin: c", "one.axial_rate: a*cos(th) + c", "one.precession: a", "one.nutation: b")
    assert "both a `spin` and an `axial_rate`" in told
