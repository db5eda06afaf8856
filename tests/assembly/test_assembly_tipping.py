"""What stands on something flat tips over where the push from below would have to act beside its base: no answer of it is confirmed."""

from __future__ import annotations

import math
from random import Random

import pytest

from rotsolve.confirm.course.samples import holding
from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve
from rotsolve.solution import Solution

CRATE = "{shape: rectangle, mass: 2 kg, sides: [1 m, 1 m], moves: right}"
BRICK = """
surfaces: {{ramp: {{slope: {slope} deg, down: {side}}}}}
bodies: {{brick: {{shape: {shape}, mass: 2 kg, {sides}, moves: down}}}}
connections: {{foot: {{contact: [brick, ramp], friction: 1}}}}
states: {{start: {{at rest: all}}}}
find: {{a: brick.acceleration at start}}
"""
BLOW = """
surfaces: {{floor: level}}
bodies: {{crate: {crate}{more}}}
connections: {{foot: {{contact: [crate, floor], friction: 0.1}}}}
states: {{start: {{at rest: crate{moving}}}, after: {{}}}}
events: {{blow: {{{blow}, from: start, to: after}}}}
find: {{v: crate.velocity at after}}
"""
STANDING = """
surfaces: {{floor: level}}
bodies: {{box: {box}}}
connections: {{foot: {{contact: [box, floor], friction: 0.8}}}}
actions: {{pull: {{force: {force} N, on: {point}, direction: {way} deg}}}}
states: {{start: {{at rest: all}}}}
find: {{N: foot.normal_force at start}}
"""


def brick(slope: int, side: str, shape: str, sides: str) -> str:
    return BRICK.format(slope=slope, side=side, shape=shape, sides=sides)


def blow(event: str, more: str = "", moving: str = "") -> str:
    return BLOW.format(crate=CRATE, blow=event, more=more, moving=moving)


def standing(box: str, force: float, point: str, way: int) -> str:
    return STANDING.format(box=box, force=force, point=point, way=way)


POLYGON = "{shape: polygon, mass: 2 kg, corners: [[0, 0], [1 m, 0], [TOP, 2 m], [LEFT, 2 m]], moves: right}"
PARTS = "{moves: right, parts: {crate: {shape: rectangle, mass: 1 kg, sides: [1 m, 1 m]}, load: {mass: 1 kg, at: [0, HIGH]}}}"
PLANK = "{shape: rod, mass: 2 kg, length: 1 m, moves: right}"
BALL = ", ball: {mass: 1 kg, moves: right}"
MOVING = ", ball.velocity: 2 m/s"
STACK = """
surfaces: {floor: level}
bodies: {box: {shape: rectangle, mass: 2 kg, sides: [0.6 m, HIGH], moves: right}, top: {mass: 1 kg, moves: right}}
connections: {base: {contact: [box, floor], friction: 0.9}, grip: {contact: [top, box], friction: 0.5}}
states: {start: {top.velocity: SPEED, box.velocity: 0}}
find: {A: top.acceleration at start}
"""
SWELLING = """
surfaces: {floor: level}
bodies: {box: {shape: rectangle, mass: 2 kg, sides: [0.6 m, HIGH], moves: right}}
connections: {base: {contact: [box, floor], friction: none}}
actions: {push: {force: 40 N/s^2 * time * (2 s - time), on: box.corner3, direction: right}}
states: {start: {at rest: all}, end: {time: 2 s}}
find: {v: box.velocity at end}
"""
SWUNG = """
surfaces: {floor: level}
bodies: {box: {shape: rectangle, mass: 2 kg, sides: [WIDE, 1 m], moves: right}, rod: {shape: rod, mass: 1 kg, length: 0.4 m}}
connections: {base: {contact: [box, floor], friction: none}, pin: {hinge: [box.corner3, rod.start]}}
states: {start: {rod.angle: 0, at rest: all}, low: {rod.angle: -90 deg}}
find: {V: box.velocity at low}
"""


def both(scene: str, word: str, stands: str, tips: str) -> tuple[str, str]:
    return scene.replace(word, stands), scene.replace(word, tips)


SCENES = {  # what stands, and the same as it tips
    "carries what slides": both(STACK.replace("SPEED", "3 m/s"), "HIGH", "0.4 m", "4 m"),
    "carries what slides back": both(STACK.replace("SPEED", "-3 m/s"), "HIGH", "0.4 m", "4 m"),
    "on the way": both(SWELLING, "HIGH", "0.1 m", "1 m"),
    "swung": both(SWUNG, "WIDE", "3 m", "0.1 m"),
    "slope right": (
        brick(40, "right", "rectangle", "sides: [1 m, 1 m]"),
        brick(40, "right", "rectangle", "sides: [1 m, 3 m]"),
    ),
    "slope left": (
        brick(40, "left", "rectangle", "sides: [1 m, 1 m]"),
        brick(40, "left", "rectangle", "sides: [1 m, 3 m]"),
    ),
    "cuboid": (
        brick(40, "left", "cuboid", "sides: [1 m, 1 m, 1 m]"),
        brick(40, "left", "cuboid", "sides: [1 m, 3 m, 1 m]"),
    ),
    "blow": (
        blow("impulse: 3 N s, on: crate.center, direction: right"),
        blow("impulse: 3 N s, on: crate.corner3, direction: right"),
    ),
    "blow from above": (
        blow("impulse: 3 N s, on: crate.corner4, direction: -60 deg"),
        blow("impulse: 3 N s, on: crate.corner4, direction: -20 deg"),
    ),
    "joins": (blow("joins: [ball, crate]", BALL, MOVING), blow("joins: [ball, crate.corner4]", BALL, MOVING)),
    "collides": (
        blow("collides: [ball, crate], restitution: 0.5", BALL, MOVING),
        blow("collides: [ball, crate.corner4], restitution: 0.5", BALL, MOVING),
    ),
    "polygon": (
        standing(POLYGON.replace("TOP", "1.2 m").replace("LEFT", "0"), 1, "box.cm", 0),
        standing(POLYGON.replace("TOP", "5 m").replace("LEFT", "4 m"), 1, "box.cm", 0),
    ),
    "parts": (
        standing(PARTS.replace("HIGH", "0"), 8, "box", 0),
        standing(PARTS.replace("HIGH", "2 m"), 8, "box", 0),
    ),
    "plank": (standing(PLANK, 5, "box.end", 90), standing(PLANK, 12, "box.end", 90)),
    "plank at its start": (standing(PLANK, 5, "box.start", 90), standing(PLANK, 12, "box.start", 90)),
}


@pytest.mark.parametrize("kind", SCENES)
def test_what_stands_is_confirmed_and_what_tips_over_is_withheld(kind: str) -> None:
    stands, tips = (f"title: What stands, or tips\n{scene}" for scene in SCENES[kind])
    found = solve(stands)
    assert found.answers
    assert all(item.holds for item in found.derivation.confirmed)
    with pytest.raises(Unsolvable, match="tips over"):
        solve(tips)


@pytest.mark.parametrize(
    ("width", "more", "link"),
    [
        ("2 m", "", "actions: {pull: {force: F, on: crate.center, direction: right}}"),
        ("1.5 m", "", "actions: {pull: {force: F, on: crate.corner3, direction: right}}"),
        ("3 m", ", load: {mass: P, moves: down}, wheel: {mass: 0, radius: 5 cm}", ""),
    ],
)
def test_letters_with_which_what_stands_tips_over_are_told(width: str, more: str, link: str) -> None:
    """Also where only what is very rough or drawn very hard does, since its sides are numbers."""
    tie = ", ax: {axle: wheel}, cord: {string: [crate.corner3, wheel, load]}" if more else ""
    found = solve(f"""
title: A crate of known size
given: {{M: kg, mu: number, {"P: kg" if more else "F: N"}}}
surfaces: {{floor: level}}
bodies: {{crate: {{shape: rectangle, mass: M, sides: [{width}, 1 m], moves: right}}{more}}}
connections: {{foot: {{contact: [crate, floor], friction: mu}}{tie}}}
{link}
states: {{start: {{at rest: all}}}}
find: {{a: crate.acceleration at start}}
""")
    assert any("tips over" in said for said in doubts(found))


def doubts(found: Solution) -> list[str]:
    """What is not confirmed, and the cases without an answer."""
    left = ["".join(map(str, check.words)) for check in found.checks if check.holds is None]
    return [*left, *(item.why for item in found.derivation.confirmed if item.holds is None)]


HOLED = "{shape: rectangle, mass: M, sides: [a, b], moves: right, holes: {h: {shape: disc, radius: r, at: [-d, 0]}}}"
LUMPED = "{moves: right, parts: {box: {shape: rectangle, mass: M, sides: [a, b]}, lump: {mass: m, at: [a/4, 0]}}}"
HOLLOW = "{shape: rectangle, mass: M, sides: [a, b], moves: right, holes: {h: {shape: rectangle, sides: [r, d], at: [r/4, 0]}}}"


CENTRES = {  # how far ahead of the middle of its base the centre of mass of each is
    HOLED: lambda of: of["d"] * math.pi * of["r"] ** 2 / (of["a"] * of["b"] - math.pi * of["r"] ** 2),
    LUMPED: lambda of: of["m"] * of["a"] / 4 / (of["M"] + of["m"]),
    HOLLOW: lambda of: -of["r"] / 4 * of["r"] * of["d"] / (of["a"] * of["b"] - of["r"] * of["d"]),
}


@pytest.mark.sampled(3)
@pytest.mark.parametrize("crate", CENTRES)
@pytest.mark.parametrize("friction", ["0.02", "0.4", "mu"])
def test_a_crate_in_letters_stands_while_its_weight_and_friction_meet_within_its_base(
    crate: str, friction: str
) -> None:
    """μ h ≤ ½ a − s for a centre of mass at the height h = ½ b, s ahead of the middle; also of sizes that no drawn set has."""
    found = solve(f"""
title: A crate of any size
given: {{M: kg, m: kg, a: m, b: m, r: m, d: m, u: m/s, mu: number}}
surfaces: {{floor: level}}
bodies: {{crate: {crate}}}
connections: {{foot: {{contact: [crate, floor], friction: {friction}}}}}
states: {{start: {{crate.velocity: u}}, end: {{crate.velocity: 0}}}}
find: {{t: time from start to end}}
""")
    random, (answer,), told = Random(3), found.derivation.answers, set()
    assert all(item.holds for item in found.derivation.confirmed)
    for _ in range(200):
        of = {name: random.uniform(0.1, 1.0) for name in ("M", "m", "a", "b", "u", "mu")}
        of |= {"r": of["a"] * random.uniform(0.02, 0.2), "d": of["b"] * random.uniform(0.02, 0.2), "g": 9.8}
        of["b"] *= random.choice([1.0, 1.0 / (of["mu"] if friction == "mu" else float(friction))])
        of["mu_foot"] = of["mu"] if friction == "mu" else float(friction)
        stands = of["mu_foot"] * of["b"] / 2 <= of["a"] / 2 - CENTRES[crate](of)
        told.add(stands)
        assert (holding(answer, of) is not None) == stands
    assert told == {True, False}


def test_a_tall_crate_with_something_on_its_back_is_told_by_numbers() -> None:
    """Where on its back it lies nobody says, so that no condition does."""
    found = solve("""
title: A block on a crate of any size that is braked
given: {M: kg, m: kg, a: m, b: m, r: m, u: m/s}
surfaces: {floor: level}
bodies:
  crate: {shape: rectangle, mass: M, sides: [a, b], moves: right, holes: {h: {shape: disc, radius: r, at: [-2*r, 0]}}}
  block: {mass: m, moves: right}
connections: {foot: {contact: [crate, floor], friction: 0.05}, grip: {contact: [block, crate], friction: 0.5}}
states: {start: {crate.velocity: u, block.velocity: u}, end: {crate.velocity: 0}}
find: {t: time from start to end}
""")
    assert any("not so with" in said and "tips over" in said for said in doubts(found))
