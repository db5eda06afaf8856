"""What is round on one side only: its motion against the integral of its energy, its round side against its outline, and where it ends."""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

import rotsolve
from rotsolve.confirm.bodies import rocker
from rotsolve.confirm.numbers import value_of
from rotsolve.draw.plane.places.outlines import body_outlines
from rotsolve.language.bodies import Body
from rotsolve.scene.read import read_text

SCENE = """
title: Something that rocks
given: {M: 2 kg, R: 20 cm, r: 12 cm, U: 40 deg, W: 2 rad/s}
surfaces: {floor: level}
bodies: {it: {SHAPE, moves: right, turns: clockwise}}
connections: {base: {rolls: [it, floor]}}
states: {STATES}
find: {FIND}
"""
POINTS = 200  # of each coordinate by which mass is cut up
Spots = list[tuple[float, float, float]]


def polar(low: float, high: float, first: float, last: float) -> Spots:
    """Masses of a plate between two radii and two angles, with their places."""
    steps = [(k + 0.5) / POINTS for k in range(POINTS)]
    return [
        (d, d * math.cos(p), d * math.sin(p))
        for d in (low + (high - low) * step for step in steps)
        for p in (first + (last - first) * step for step in steps)
    ]


def ball(hollow: bool) -> Spots:
    """Discs, or rings, along the x axis; what each is spread to across that stands as two masses aside, at the mean square of y."""
    found: Spots = []
    for x in (0.2 * (k + 0.5) / POINTS for k in range(POINTS)):
        square = 0.04 - x * x
        aside = math.sqrt(square / 2 if hollow else square / 4)
        found += [((1.0 if hollow else square) / 2, x, side * aside) for side in (-1.0, 1.0)]
    return found


SHAPES: dict[str, tuple[str, Callable[[], Spots]]] = {
    "a half cylinder": (
        "shape: lamina, mass: M, region: {r: [0, R], phi: [-pi/2, pi/2]}",
        lambda: polar(0.0, 0.2, -math.pi / 2, math.pi / 2),
    ),
    "half a tube": (
        "shape: lamina, mass: M, region: {r: [r, R], phi: [-pi/2, pi/2]}",
        lambda: polar(0.12, 0.2, -math.pi / 2, math.pi / 2),
    ),
    "a slice": (
        "shape: lamina, mass: M, region: {r: [0, R], phi: [-U, U]}",
        lambda: polar(0.0, 0.2, -math.radians(40), math.radians(40)),
    ),
    "a wire": (
        "shape: arc, mass: M, radius: R, opening: 2*U",
        lambda: polar(0.2, 0.2, -math.radians(40), math.radians(40)),
    ),
    "a half ball": ("shape: hemisphere, mass: M, radius: R", lambda: ball(hollow=False)),
    "a hollow half ball": ("shape: hemispherical shell, mass: M, radius: R", lambda: ball(hollow=True)),
}


def solved(shape: str, states: str, find: str) -> rotsolve.Solution:
    return rotsolve.solve(SCENE.replace("SHAPE", shape).replace("STATES", states).replace("FIND", find))


def about_contact(spots: Spots, angle: float) -> tuple[float, float]:
    """Per mass: the moment of inertia about the point of contact, and the height of the centre of mass, of a body turned by an angle."""
    whole = sum(mass for mass, _, _ in spots)
    c, s = math.cos(angle), math.sin(angle)
    placed = [(mass / whole, c * x - s * y, s * x + c * y + 0.2) for mass, x, y in spots]
    return sum(m * (x * x + y * y) for m, x, y in placed), sum(m * y for m, _, y in placed)


@pytest.mark.parametrize("kind", SHAPES)
def test_it_rocks_as_its_energy_says(kind: str) -> None:
    """½ I(θ) ω² + g y(θ) stays as it is; small swings by y″ and I at the bottom."""
    shape, cut = SHAPES[kind]
    spots, high, low = cut(), math.radians(-60), math.radians(-90)
    states = "start: {it.angle: -60 deg, it.angular_velocity: W}, low: {it.angle: -90 deg}"
    answers = solved(shape, states, "w: it.angular_velocity at low, T: period of small swings").answers
    (first, above), (last, below) = about_contact(spots, high), about_contact(spots, low)
    rate = math.sqrt((first * 4.0 + 2 * 9.8 * (above - below)) / last)
    assert answers["w"].float == pytest.approx(rate, rel=1e-4)
    slope = 9.8 * (0.2 - below)  # y = R + c sin θ
    assert answers["T"].float == pytest.approx(2 * math.pi * math.sqrt(last / slope), rel=1e-4)


@pytest.mark.parametrize("kind", SHAPES)
def test_its_round_side_is_that_of_its_outline(kind: str) -> None:
    """Where it says that it touches with it, no point of what is drawn is lower; just beyond, one is."""
    problem = read_text(
        SCENE.replace("SHAPE", SHAPES[kind][0]).replace("STATES", "now: at rest").replace("FIND", "m: it.mass")
    )
    body: Body = problem.bodies[0]
    numbers = {given.name: given.value for given in problem.givens if given.value is not None}
    value = lambda formula: value_of(formula, numbers)  # noqa: E731
    found = rocker(body, None, value)
    assert found is not None
    around = [point for outline in body_outlines(body, value) for point in outline.around()]
    for way in (found.first + part * (found.last - found.first) for part in (0.02, 0.3, 0.5, 0.98)):
        assert found.spare(way) > 0.0
        assert max(x * math.cos(way) + y * math.sin(way) for x, y in around) == pytest.approx(0.2, rel=5e-3)
    for way in (found.first - 0.3, found.last + 0.3):
        assert found.spare(way) < 0.0
        assert max(x * math.cos(way) + y * math.sin(way) for x, y in around) < 0.199


@pytest.mark.parametrize(
    ("shape", "states"),
    [
        ("a half ball", "start: {it.angle: 95 deg, it.angular_velocity: W}"),
        ("a half ball", "start: {it.angle: 5 deg, it.angular_velocity: W}"),
        ("a wire", "start: {it.angle: -45 deg, it.angular_velocity: W}"),
        ("a half cylinder", "first: {it.angle: -30 deg, it.angular_velocity: 6*W}, start: {it.rotation: 170 deg}"),
    ],
)
def test_beyond_its_round_side_nothing_is_answered(shape: str, states: str) -> None:
    with pytest.raises(rotsolve.Unsolvable, match="an end of its round side"):
        solved(SHAPES[shape][0], states, "w: it.angular_acceleration at start")


def test_a_gap_on_the_way_is_seen() -> None:
    """A tube with a narrow slit, which turns once, would fall into it."""
    tube = "shape: arc, mass: M, radius: R, opening: 350 deg"
    states = "start: {it.angle: -90 deg, it.angular_velocity: W}, once: {it.rotation: 360 deg}"
    with pytest.raises(rotsolve.Unsolvable, match="an end of its round side on the way"):
        solved(tube, states, "w: it.angular_velocity at once")
    before = "start: {it.angle: -90 deg, it.angular_velocity: W}, near: {it.rotation: 170 deg}"
    assert solved(tube, before, "w: it.angular_velocity at near").answers["w"].float == pytest.approx(1.03937, rel=1e-4)


def test_in_letters_it_stands_under_its_condition() -> None:
    scene = SCENE.replace("W: 2 rad/s", "theta: rad")
    wire = scene.replace("SHAPE", "shape: arc, mass: M, radius: R, opening: 60 deg")
    found = rotsolve.solve(
        wire.replace("STATES", "start: {it.angle: theta - pi/2, at rest: all}").replace(
            "FIND", "a: it.angular_acceleration at start"
        )
    )
    assert "2 cos θ − √3 ≥ 0" in str(found)


def test_of_which_line_the_angle_is_that_is_told() -> None:
    """With a lump welded aside of its axis it is that of the common centre of mass: cos q = 8 (M + k) sin b/√(9 M² + 64 k²)."""
    scene = """title: t
given: {M: 2 kg, k: 0.3 kg, R: 20 cm, b: 10 deg, q: unknown}
surfaces: {ramp: {slope: b, down: left}}
bodies: {dot: {mass: k}, half: {shape: hemisphere, mass: M, radius: R, moves: down, points: {E: [0, R]}}}
connections: {glue: {weld: [half.PLACE, dot]}, base: {rolls: [half, ramp]}}
states: {rest: {half.angle: q, balance: true}}
find: {q: q}
"""
    aside, along = (rotsolve.solve(scene.replace("PLACE", place)) for place in ("E", "center"))
    said = "the angle of half is that of the line from its axis to the common centre of mass"
    assert said in " ".join(str(aside).split())
    assert said not in " ".join(str(along).split())
    most = 8 * 2.3 * math.sin(math.radians(10)) / math.sqrt(9 * 4 + 64 * 0.09)
    assert aside.answers["q"].float == pytest.approx(-math.acos(most), rel=1e-12)
