"""Closed linkages in space: bars with a ball or a collar at each end, and universal joints, against numbers by hand."""

from __future__ import annotations

import math
import re

import numpy as np
import pytest

from rotsolve import Solution, Unsolvable, solve
from rotsolve.arrays import single_answers

SKEW = "ga: {collar: [[0, 0.3 m, 0.6 m], bar.start], along: y}, gb: {collar: [[0.2 m, 0, 0], bar.end], along: x}"
LIGHT = "bar: {shape: rod, mass: 0, length: 0.7 m}"
TOLD = "bar.start.velocity: [0, 0.2 m/s, 0]"


def scene(bodies: str, joints: str, told: str, asked: str, more: str = "gravity: none") -> str:
    return f"up: z\n{more}\nbodies: {{{bodies}}}\nconnections: {{{joints}}}\nstates: {{now: {{{told}}}}}\nfind: {{{asked}}}\n"


def numbers(solution: Solution, name: str) -> list[float]:
    """An answer, or the components of a vector."""
    found = single_answers(solution.derivation.answers)
    return [one.value.float for part, one in found if part.split(".")[0] == name and one.value is not None]


def confirmed(solution: Solution) -> bool:
    return all(item.holds for item in solution.derivation.confirmed)


def test_bar_between_crank_and_lever() -> None:
    """θ₂(θ₁) by the distance of both ends, its derivatives by differences of a root that is polished."""
    joints = """h1: {hinge: [[0, 0, 0], one.O], along: z, angular_velocity: 6 rad/s},
      h2: {hinge: [[0.6 m, 0.5 m, -0.2 m], two.O], along: x}, p: {ball: [one.P, bar.start]}, q: {ball: [two.Q, bar.end]}"""
    cranks = ("one", "P: [0, 0.2 m, 0]"), ("two", "Q: [0, 0, 0.4 m]")
    bodies = "".join(f"{name}: {{mass: 0, points: {{O: [0, 0, 0], {end}}}}}, " for name, end in cranks) + LIGHT
    found = solve(scene(bodies, joints, "one.angle: 0 deg", "W: two.angular_velocity.x, A: two.angular_acceleration.x"))

    def lever(theta: float) -> float:
        """The angle of the second crank: a sin + b cos = c."""
        x, y = -0.2 * math.sin(theta), 0.2 * math.cos(theta)
        across, up = 0.5 - y, -0.2  # |(0.6 − x, across − 0.4 sin φ, up + 0.4 cos φ)|² = 0.49
        c = (0.49 - (0.6 - x) ** 2 - across**2 - up**2 - 0.16) / 0.8
        return math.asin(-c / math.hypot(across, up)) - math.atan2(-up, across)

    branch = lever if abs(lever(0.0)) < 1e-12 else lambda theta: math.pi - lever(theta) - 2 * math.atan2(0.2, 0.3)
    step = 1e-4
    low, mid, high = branch(-step), branch(0.0), branch(step)
    assert abs(mid) < 1e-12
    assert numbers(found, "W") == pytest.approx([6 * (high - low) / (2 * step)], rel=1e-6)
    assert numbers(found, "A") == pytest.approx([36 * (high - 2 * mid + low) / step**2], rel=1e-5)
    assert confirmed(found)


def test_points_along_a_bar_and_what_hangs_on_it() -> None:
    """A second bar on the middle of the first: v = ½ (v_A + v_B), and what its own length asks."""
    joints = (
        f"{SKEW}, c: {{ball: [bar.center, more.start]}}, d: {{collar: [[0.1 m, 0.15 m, 1.3 m], more.end], along: z}}"
    )
    bodies = f"{LIGHT}, more: {{shape: rod, mass: 0, length: 1 m}}"
    found = solve(scene(bodies, joints, TOLD, "v: bar.velocity, u: more.end.velocity, w: more.angular_velocity"))
    assert numbers(found, "v") == pytest.approx([-0.15, 0.1, 0])
    assert numbers(found, "u") == pytest.approx([0, 0, 0])
    assert numbers(found, "w") == pytest.approx([0.1, 0.15, 0])
    assert confirmed(found)


def test_masses_on_skew_rods_that_a_light_bar_ties() -> None:
    """(m + M y²/x²) u̇ = −P − M y (y² + x²) u²/x⁴ by Lagrange, and the bar's force along it."""
    bodies = f"A: {{shape: particle, mass: 2 kg}}, B: {{shape: particle, mass: 3 kg}}, {LIGHT}"
    joints = """ga: {slide: [[0, 0.3 m, 0.6 m], A], along: y}, gb: {slide: [[0.2 m, 0, 0], B], along: x},
      ja: {ball: [A, bar.start]}, jb: {ball: [B, bar.end]}"""
    more = "actions: {push: {force: 40 N, on: A, direction: -y}}"
    told, asked = "A.velocity: [0, 0.2 m/s, 0]", "a: A.acceleration.y, b: B.acceleration.x, F: jb.force"
    found = solve(scene(bodies, joints, told, asked, more))
    x, y, u = 0.2, 0.3, 0.2
    a = -(40 + 3 * y * (y**2 + x**2) * u**2 / x**4) / (2 + 3 * y**2 / x**2)
    b = -(u**2 + (u * y / x) ** 2 + a * y) / x
    assert numbers(found, "a") == pytest.approx([a])
    assert numbers(found, "b") == pytest.approx([b])
    way = np.array([0.2, -0.3, -0.6])
    assert numbers(found, "F") == pytest.approx(list(-3 * b / way[0] * way))  # −F drives B along x
    assert confirmed(found)


@pytest.mark.parametrize(
    "bar",
    [
        "mass: 0, points: {start: [0, -0.35 m, 0], end: [0, 0.35 m, 0]}",
        "mass: 0, points: {start: [0, 0, 0], end: [0.2 m, 0.3 m, 0.6 m]}",
        "mass: 0, points: {start: [0.7 m, 0, 0], end: [0, 0, 0]}",
    ],
)
def test_however_a_light_bar_is_drawn(bar: str) -> None:
    found = solve(scene(f"bar: {{{bar}}}", SKEW, TOLD, "v: bar.end.velocity, w: bar.angular_velocity"))
    way, gap = np.array([0.2, -0.3, -0.6]), np.array([-0.3, -0.2, 0])
    assert numbers(found, "v") == pytest.approx([-0.3, 0, 0])
    assert numbers(found, "w") == pytest.approx(list(np.cross(way, gap) / 0.49))
    assert confirmed(found)


def test_collars_on_what_turns() -> None:
    """On a frame that turns at Ω a bar turns at what of its relative rate and Ω is across it."""
    frame = "arm: {mass: 0, points: {O: [0, 0, 0], P: [0, 0.3 m, 0.6 m], Q: [0.2 m, 0, 0]}}"
    joints = """h: {hinge: [[0, 0, 0], arm.O], along: z, angular_velocity: 2 rad/s},
      c: {collar: [arm.P, bar.start], along: y}, d: {collar: [arm.Q, bar.end], along: x}"""
    told = "bar.start.velocity relative to arm: [0, 0.2 m/s, 0]"
    found = solve(scene(f"{frame}, {LIGHT}", joints, told, "v: bar.end.velocity, w: bar.angular_velocity"))
    way, turning = np.array([0.2, -0.3, -0.6]) / 0.7, np.cross([0.2, -0.3, -0.6], [-0.3, -0.2, 0]) / 0.49 + [0, 0, 2]
    assert numbers(found, "v") == pytest.approx([-0.3, 0.4, 0])
    assert numbers(found, "w") == pytest.approx(list(turning - way * (way @ turning)))
    assert confirmed(found)


def test_two_masses_on_a_bar_that_flies() -> None:
    """The bar pulls with μ v²/l of the relative velocity."""
    bodies = f"A: {{shape: particle, mass: 1 kg}}, B: {{shape: particle, mass: 2 kg}}, {LIGHT}"
    joints = "p: {ball: [A, bar.start]}, q: {ball: [B, bar.end]}"
    told = "A.position: [0, 0, 0], B.position: [0.7 m, 0, 0], A.velocity: [0, 1 m/s, 0], B.velocity: [0, 0, 2 m/s]"
    found = solve(scene(bodies, joints, told, "w: bar.angular_velocity, a: A.acceleration, F: size of p.force"))
    assert numbers(found, "w") == pytest.approx([0, -2 / 0.7, -1 / 0.7])
    assert numbers(found, "a") == pytest.approx([2 / 3 * 5 / 0.7, 0, 0])
    assert numbers(found, "F") == pytest.approx([2 / 3 * 5 / 0.7])
    assert confirmed(found)


def test_a_strut_pushes() -> None:
    bodies = "arm: {shape: rod, mass: 10 kg, length: 2 m}, strut: {shape: rod, mass: 0, length: 1.25 m}"
    joints = """socket: {hinge: [[0, 0, 0], arm.start], along: y}, B: {ball: [arm.center, strut.start]},
      D: {ball: [[0.25 m, 0, -1 m], strut.end]}"""
    found = solve(scene(bodies, joints, "balance: true", "T: size of D.force, F: D.force", "gravity: 10 m/s^2"))
    assert numbers(found, "T") == pytest.approx([125])
    assert numbers(found, "F") == pytest.approx([75, 0, 100])
    assert confirmed(found)


@pytest.mark.parametrize(("word", "place", "speed"), [("smallest", 0.8, 0.3), ("largest", 1.2, -0.3)])
def test_a_place_that_the_length_tells(word: str, place: float, speed: float) -> None:
    joints = "ga: {collar: [[1 m, 0.3 m, 0.6 m], bar.start], along: y}, gb: {collar: [[x, 0, 0], bar.end], along: x}"
    more = "gravity: none\ngiven: {x: unknown}"
    found = solve(scene(LIGHT, joints, TOLD, f"q: {word} x, v: bar.end.velocity.x", more))
    assert numbers(found, "q") == pytest.approx([place])
    assert numbers(found, "v") == pytest.approx([speed])
    assert confirmed(found)
    untold = solve(scene(LIGHT, joints, TOLD, "v: bar.end.velocity.x", more))
    assert not confirmed(untold)


SHAFTS = "one: {mass: 0, points: {O: [0, 0, 0]}}, mid: {mass: 0, points: {O: [0, 0, 0]}}, two: {mass: 0, points: {O: [0, 0, 0]}}"
HINGES = """s1: {hinge: one.O, along: x, angular_velocity: 10 rad/s}, s2: {hinge: mid.O, along: [cos(b), sin(b), 0]},
  s3: {hinge: two.O, along: x}, u: {universal: [one, mid], along: z}"""


@pytest.mark.parametrize("turned", [0, 25, 90, 125, 200, 300])
def test_two_universal_joints_in_a_row(turned: int) -> None:
    """With its forks in one plane the shaft between makes the last run as the first; a quarter turn off it makes it worse."""
    more = f"gravity: none\ngiven: {{b: 30 deg, q: {turned} deg}}"
    q, b = math.radians(turned), math.radians(30)
    for arm, ratio in (
        ("[-sin(b), cos(b), 0]", 1.0),
        ("z", math.cos(b) ** 2 / (math.cos(q) ** 2 + math.cos(b) ** 4 * math.sin(q) ** 2)),
    ):
        joints = f"{HINGES}, v: {{universal: [mid, two], along: {arm}}}"
        found = solve(scene(SHAFTS, joints, "one.angle: q", "W: two.angular_velocity.x, p: mid.angle", more))
        assert numbers(found, "W") == pytest.approx([10 * ratio])
        half = math.remainder(numbers(found, "p")[0] - math.atan2(math.cos(b) * math.sin(q), math.cos(q)), math.tau)
        assert half == pytest.approx(0, abs=1e-9)
        assert confirmed(found)


def test_a_couple_spins_up_two_shafts() -> None:
    """I₁ α₁ = C − ρ τ and I₂ α₂ = τ with ω₂ = ρ ω₁, α₂ = ρ α₁ + ρ′ ω₁²."""
    bodies = "".join(
        f"{name}: {{mass: 1 kg, inertia: {{principal: [{i} kg m^2, {i} kg m^2, {i} kg m^2]}}, points: {{O: [0, 0, 0]}}}}, "
        for name, i in (("one", 0.1), ("two", 0.3))
    )
    joints = "s1: {hinge: one.O, along: x}, s2: {hinge: two.O, along: [cos(b), sin(b), 0]}, u: {universal: [one, two], along: z}"
    more = "gravity: none\ngiven: {b: 30 deg, q: 25 deg}\nactions: {k: {couple: 10 N m, on: one}}"
    told = "one.angle: q, one.angular_velocity: 2 rad/s"
    found = solve(
        scene(
            bodies.rstrip(", "),
            joints,
            told,
            "a: size of one.angular_acceleration, c: size of two.angular_acceleration",
            more,
        )
    )
    b, q = math.radians(30), math.radians(25)
    held = 1 - math.sin(b) ** 2 * math.sin(q) ** 2
    ratio, bend = math.cos(b) / held, math.cos(b) * 2 * math.sin(b) ** 2 * math.sin(q) * math.cos(q) / held**2
    first = (10 - 0.3 * ratio * bend * 4) / (0.1 + 0.3 * ratio**2)
    assert numbers(found, "a") == pytest.approx([first])
    assert numbers(found, "c") == pytest.approx([ratio * first + bend * 4])
    assert confirmed(found)


ONE_MOMENT = "closes a linkage in space: how that"
HOOKE = """s1: {hinge: one.O, along: x, angular_velocity: 1 rad/s}, s2: {hinge: two.O, along: [1, 1, 0]},
  u: {universal: [one, two], along: z}"""
PAIR = "one: {mass: 0, points: {O: [0, 0, 0]}}, two: {mass: 0, points: {O: [0, 0, 0]}}"
REFUSED = {
    "two moments": (LIGHT, SKEW, f"{TOLD}}}, later: {{time: 1 s", "v: bar.end.velocity at later", ONE_MOMENT),
    "functions of time": (LIGHT, SKEW, TOLD, "v: bar.end.velocity at any time", ONE_MOMENT),
    "a steady state": (LIGHT, SKEW, f"{TOLD}, steady: true", "v: bar.end.velocity", ONE_MOMENT),
    "swings": (LIGHT.replace("mass: 0", "mass: 1 kg"), SKEW, TOLD, "T: period of small swings", ONE_MOMENT),
    "freedoms": (LIGHT, SKEW, TOLD, "f: bar.freedoms", ONE_MOMENT),
    "another length": (
        LIGHT.replace("0.7", "0.8"),
        SKEW,
        TOLD,
        "v: bar.end.velocity",
        "are not as far apart as `bar` is long",
    ),
    "no length": (LIGHT.replace(", length: 0.7 m", ""), SKEW, TOLD, "v: bar.end.velocity", "hangs on letters"),
    "no places": (
        LIGHT,
        re.sub(r"\[\[.*?\], (\S*)\]", r"\1", SKEW),
        TOLD,
        "v: bar.end.velocity",
        "are apart nothing tells",
    ),
    "a thick bar": (
        "bar: {shape: cylinder, mass: 1 kg, length: 0.7 m, radius: 5 cm, points: {start: [0, 0, -0.35 m], end: [0, 0, 0.35 m]}}",
        SKEW,
        TOLD,
        "v: bar.end.velocity",
        "is turned about the line through its ends nothing tells",
    ),
    "its own axes": (
        LIGHT,
        SKEW,
        TOLD,
        "w: bar.angular_velocity in bar axes",
        "is turned about the line through its ends nothing tells",
    ),
    "what is told twice": (
        LIGHT,
        SKEW,
        f"{TOLD}, bar.angular_velocity: [1 rad/s, 0, 0]",
        "v: bar.end.velocity",
        "follows from where its two ends",
    ),
    "what is told otherwise": (
        LIGHT,
        SKEW,
        f"{TOLD}, bar.end.velocity: [1 m/s, 0, 0]",
        "w: bar.angular_velocity",
        "contradict",
    ),
    "a rate that nothing tells": (LIGHT, SKEW, "", "v: bar.end.velocity", "too little is known"),
    "a bar that is named first": (
        f"one: {{mass: 0, points: {{O: [0, 0, 0], P: [0.2 m, 0, 0]}}}}, {LIGHT}",
        "h: {hinge: [[0, 0, 0], one.O], along: z}, p: {ball: [bar.start, one.P]}",
        "",
        "v: bar.end.velocity",
        "name a bar that ends there last: `[one.P, bar.start]`",
    ),
    "a place without a body": (
        LIGHT,
        "ga: {collar: [[0, 0, 0]], along: y}",
        "",
        "v: bar.end.velocity",
        "`ga` holds no body",
    ),
    "three joints": (
        LIGHT,
        f"{SKEW}, gc: {{ball: [[0.1 m, 0.15 m, 0.3 m], bar.center]}}",
        TOLD,
        "v: bar.end.velocity",
        "held by several joints",
    ),
    "the angle of the second shaft": (
        PAIR,
        HOOKE,
        "two.angle: 20 deg",
        "W: two.angular_velocity",
        "follows from how far `one` is",
    ),
    "an arm askew": (
        PAIR,
        HOOKE.replace("along: z", "along: [1, 0, 1]"),
        "one.angle: 0 deg",
        "W: two.angular_velocity",
        "is not square to `one`",
    ),
    "a cross that locks": (
        PAIR,
        HOOKE.replace("[1, 1, 0]", "z"),
        "one.angle: 0 deg",
        "W: two.angular_velocity",
        "is locked",
    ),
    "shafts in a ring": (
        PAIR,
        f"{HOOKE}, v: {{universal: [two, one], along: z}}",
        "one.angle: 0 deg",
        "W: two.angular_velocity",
        "in a ring",
    ),
    "a shaft on a ball": (
        PAIR,
        HOOKE.replace("hinge: two.O, along: [1, 1, 0]", "ball: two.O"),
        "one.angle: 0 deg",
        "W: two.angular_velocity",
        "`two` is on none",
    ),
}


@pytest.mark.parametrize("what", REFUSED)
def test_what_is_refused_by_name(what: str) -> None:
    *parts, said = REFUSED[what]
    with pytest.raises(Unsolvable) as refused:
        solve(scene(*parts))
    assert said in str(refused.value)
    assert "-->" in str(refused.value)
