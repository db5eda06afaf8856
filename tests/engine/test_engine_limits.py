"""What numbers are refused by, letters are held to: each limit of a scene is told with its answers in letters."""

from __future__ import annotations

import ast
import random
import re
from fractions import Fraction
from pathlib import Path

import pytest

import rotsolve
from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.formula import Formula, Number
from rotsolve.algebra.notation.parse import parse
from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.pipeline import solve

LEVEL = "surfaces: {floor: level, kerb: {corner: h, side: right}}"


def riding(base: str, pin: str, first: str) -> str:
    """A body that slides outwards on another, which turns."""
    return f"""plane: horizontal
bodies: {{base: {base}, rider: {{mass: m}}}}
connections: {{pin: {{{pin}}}, ride: {{rides: [rider, base]}}}}
states: {{near: {{rider.radius: {first}, base.angular_velocity: 2 rad/s}}, out: {{rider.radius: s}}}}
find: {{w: base.angular_velocity at out}}"""


def geared(ring: str, pinion: str, order: str) -> str:
    """A wheel that is turned inside another."""
    return f"""plane: horizontal
bodies: {{ring: {ring}, pinion: {pinion}}}
connections: {{first: {{axle: ring}}, second: {{axle: pinion}}, teeth: {{gear: [{order}], inside: true}}}}
actions: {{motor: {{couple: Q, on: pinion}}}}
states: {{now: at rest}}
find: {{a: ring.angular_acceleration at now}}"""


SCENES = {  # letters with their units, the scene, and what is said where numbers can't be so
    "a wheel at a kerb": (
        {"R": "m", "h": "m", "M": "kg", "F": "N"},
        f"""{LEVEL}
bodies: {{drum: {{shape: cylinder, mass: M, radius: R, moves: right}}}}
connections: {{base: {{contact: [drum, floor]}}, edge: {{contact: [drum, kerb]}}}}
actions: {{push: {{force: unknown, on: drum.center, direction: right}}}}
states: {{now: {{base: leaves, balance: true}}}}
find: {{N: push.force at now}}""",
        "is too small to climb",
    ),
    "a ball in a bowl": (
        {"R": "m", "r": "m", "m": "kg"},
        """surfaces: {bowl: {hollow: R}}
bodies: {ball: {shape: sphere, mass: m, radius: r}}
connections: {roll: {rolls: [ball, bowl]}}
states: {high: {roll.angle: -30 deg, at rest: all}, low: {roll.angle: -90 deg}}
find: {v: ball.velocity at low}""",
        "does not fit into",
    ),
    "a hinge on a rod": (
        {"M": "kg", "L": "m", "x": "m"},
        """bodies: {bar: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: bar.at(x)}}
find: {I: bar.inertia about pin}""",
        "ends before this point",
    ),
    "a bead on a bar": (
        {"M": "kg", "m": "kg", "L": "m", "r": "m", "s": "m"},
        riding("{shape: rod, mass: M, length: L}", "hinge: base.start", "r"),
        "is beyond the end of",
    ),
    "a beetle on a disc": (
        {"M": "kg", "m": "kg", "R": "m", "s": "m"},
        riding("{shape: disc, mass: M, radius: R}", "axle: base", "0"),
        "is beyond the end of",
    ),
    "a wheel inside another": (
        {"I": "kg m^2", "Q": "N m", "R": "m", "r": "m"},
        geared("{inertia: I, radius: R}", "{inertia: 2*I, radius: r}", "pinion, ring"),
        "can not run inside",
    ),
    "a step of a wheel inside a rim of another": (
        {"M": "kg", "Q": "N m", "R": "m", "r": "m", "s": "m"},
        geared(
            "{inertia: 2 kg m^2, radii: {teeth: R - s, barrel: R}}",
            "{shape: disc, mass: M, radius: r}",
            "pinion.rim, ring.teeth",
        ),
        "can not run inside|must be positive",
    ),
    "two radii": (
        {"M": "kg", "R": "m", "r": "m"},
        """bodies: {tube: {shape: annulus, mass: M, radii: {inner: r, outer: R}}}
find: {I: tube.inertia}""",
        "must be smaller than",
    ),
    "two radii of a part": (
        {"M": "kg", "R": "m", "r": "m"},
        """bodies: {whole: {parts: {tube: {shape: spherical shell, mass: M, radii: {inner: r, outer: R}}, ball: {mass: M, at: [R, 0]}}}}
find: {I: whole.inertia}""",
        "must be smaller than",
    ),
    "three sides": (
        {"M": "kg", "a": "m", "b": "m", "c": "m"},
        "bodies: {plate: {shape: triangle, mass: M, sides: [a, b, c]}}\nfind: {I: plate.inertia}",
        "make no triangle",
    ),
    "a round hole in a disc": (
        {"M": "kg", "R": "m", "r": "m", "d": "m"},
        """bodies: {plate: {shape: disc, mass: M, radius: R, holes: {hole: {shape: disc, radius: r, at: [d, 0]}}}}
connections: {pin: {axle: plate}}
find: {I: plate.inertia about pin}""",
        "sticks out of|leave nothing of",
    ),
    "a hole in a plate": (
        {"M": "kg", "a": "m", "b": "m", "r": "m", "d": "m"},
        """bodies: {plate: {shape: rectangle, mass: M, sides: [a, b], holes: {hole: {shape: disc, radius: r, at: [d, -d]}}}}
find: {I: plate.inertia}""",
        "sticks out of|leave nothing of",
    ),
    "a square hole in a disc": (
        {"M": "kg", "R": "m", "a": "m", "d": "m"},
        """bodies: {plate: {shape: disc, mass: M, radius: R, holes: {hole: {shape: rectangle, sides: [a, a], at: [0, d]}}}}
find: {I: plate.inertia}""",
        "sticks out of|leave nothing of",
    ),
    "two holes": (
        {"M": "kg", "R": "m", "r": "m", "d": "m"},
        """bodies:
  plate: {shape: disc, mass: M, radius: R, holes: {one: {shape: disc, radius: r, at: [d, 0]}, two: {shape: disc, radius: r, at: [-d, 0]}}}
find: {I: plate.inertia}""",
        "sticks out of|leave nothing of|overlap",
    ),
    "limits of a plate": (
        {"M": "kg", "a": "m", "b": "m", "c": "m"},
        "bodies: {plate: {shape: lamina, mass: M, region: {x: [a, b], y: [0, c]}}}\nfind: {I: plate.inertia}",
        "enclose nothing",
    ),
    "limits of a solid": (
        {"M": "kg", "a": "m", "b": "m", "c": "m"},
        "bodies: {top: {shape: solid of revolution, mass: M, profile: {z: [a, b], r: c}}}\nfind: {I: top.inertia}",
        "enclose nothing",
    ),
    "two frictions": (
        {"m": "kg", "p": "number", "q": "number", "F": "N"},
        """surfaces: {floor: level}
bodies: {box: {mass: m, moves: right}}
connections: {base: {contact: [box, floor], friction: {static: p, kinetic: q}}}
actions: {push: {force: F, on: box, direction: right}}
states: {now: {box.velocity: 1 m/s}}
find: {a: box.acceleration at now}""",
        "can't be greater than static",
    ),
    "two frictions of rims": (
        {"F": "N", "p": "number", "q": "number"},
        """plane: horizontal
bodies: {one: {inertia: 2 kg m^2, radius: 1 m}, two: {inertia: 1 kg m^2, radius: 1 m}}
connections: {first: {axle: one}, second: {axle: two}, rims: {contact: [one.rim, two.rim], press: F, friction: {static: p, kinetic: q}}}
states: {now: {one.angular_velocity: 2 rad/s, two.angular_velocity: 0}}
find: {a: two.angular_acceleration at now}""",
        "can't be greater than static",
    ),
    "plates of a clutch": (
        {"F": "N", "R": "m", "r": "m"},
        """plane: horizontal
bodies: {one: {inertia: 2 kg m^2, radius: r}, two: {inertia: 1 kg m^2, radius: R}}
connections: {axle: {axle: [one, two]}, plates: {clutch: [one, two], press: F, friction: 0.3}}
states: {now: {one.angular_velocity: 2 rad/s, two.angular_velocity: 0}}
find: {a: two.angular_acceleration at now}""",
        "named first, is the smaller",
    ),
    "restitution": (
        {"m": "kg", "M": "kg", "u": "m/s", "q": "number"},
        """surfaces: {ice: level}
bodies: {a: {mass: m, moves: right}, b: {mass: M, moves: right}}
connections: {one: {contact: [a, ice]}, two: {contact: [b, ice]}}
states: {before: {a.velocity: u, b.velocity: 0}, after: {}}
events: {hit: {collides: [a, b], restitution: q, from: before, to: after}}
find: {v: b.velocity at after}""",
        "must lie from 0 to 1",
    ),
    "sizes that are differences": (
        {"m": "kg", "M": "kg", "R": "m", "r": "m"},
        """bodies: {wheel: {shape: disc, mass: M - m, radius: R - r}, load: {mass: m, moves: down}}
connections: {axle: {axle: wheel}, cord: {string: [wheel, load]}}
states: {start: {at rest: all}}
find: {a: load.acceleration at start}""",
        "must be positive|can't be negative",
    ),
    "an inertia about another point": (
        {"M": "kg", "d": "m", "I": "kg m^2"},
        """bodies: {plate: {mass: M, inertia: {value: I, about: P}, points: {P: [d, 0]}}}
find: {k: plate.inertia}""",
        "is smaller than m d",
    ),
    "a wagon that is filled": (
        {"m": "kg", "M": "kg", "R": "m"},
        """plane: horizontal
bodies: {disc: {shape: disc, mass: m, radius: R}}
connections: {pin: {axle: disc}}
states: {start: {disc.angular_velocity: 2 rad/s}, end: {disc.mass: M}}
find: {w: disc.angular_velocity at end}""",
        "what leaves",
    ),
}
SIGNS = {">": (1,), "≥": (0, 1), "<": (-1,), "≤": (-1, 0)}
CLOSE = 1e-9


def text_of(scene: str, given: dict[str, str]) -> str:
    pairs = ", ".join(f"{name}: {said}" for name, said in given.items())
    return f"title: Limits\ngiven: {{{pairs}}}\n{scene}\n"


def told(scene: str, units: dict[str, str]) -> list[tuple[Formula, str]]:
    """What a page in letters says of them: left − right, and how it compares with 0."""
    found = []
    for words, *_ in solve(text_of(scene, units), confirm=False).derivation.conventions:
        parts = re.fullmatch(r"(.+) ([<>≤≥]) (.+)", words) if isinstance(words, str) else None
        if parts and "," not in words and not words.startswith("0 <"):
            found.append((parse(parts[1], units) - parse(parts[3], units), parts[2]))
    return found


def refused(scene: str, given: dict[str, str], said: str) -> bool:
    """Whether numbers are refused, and for what is said."""
    try:
        solve(text_of(scene, given), confirm=False)
    except (SceneError, Unsolvable) as error:
        assert re.search(said, str(error)), error
        return True
    return False


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", SCENES)
def test_letters_are_held_to_what_numbers_are_refused_by(name: str) -> None:
    units, scene, said = SCENES[name]
    limits = told(scene, units)
    assert limits
    chance, seen = random.Random(name), set[bool]()
    for _ in range(40):
        sizes = {letter: Fraction(chance.randint(4, 7) * 2 ** chance.randint(0, 5), 64) for letter in units}
        values = {letter: Number(size) for letter, size in sizes.items()}
        gaps = [(evaluate(gap, values), SIGNS[relation]) for gap, relation in limits]
        if any(abs(gap.float) < CLOSE for gap, _ in gaps):
            continue  # whether the edge itself can be is told by each
        given = {
            letter: f"{float(size)} {units[letter].replace('number', '')}".strip() for letter, size in sizes.items()
        }
        out = any((gap.sign or 0) not in signs for gap, signs in gaps)
        assert refused(scene, given, said) == out, (given, limits)
        seen.add(out)
    assert seen == {True, False}


@pytest.mark.parametrize("sizes", ["R: 10 cm, r: 40 cm", "R: 10 cm, r: 4*R"])
def test_what_is_said_of_the_order_of_wheels_mends_it(sizes: str) -> None:
    scene, given = SCENES["a wheel inside another"][1], f"given: {{I: 1 kg m^2, Q: 1 N m, {sizes}}}"
    text = f"title: Wheels\n{given}\n{scene}\n"
    with pytest.raises(Unsolvable, match="`pinion` can not run inside `ring`") as caught:
        solve(text)
    order = re.search(r"`(gear: .*)`", caught.value.fault.help)
    assert order is not None and caught.value.fault.span is not None
    found = solve(text.replace("gear: [pinion, ring]", order[1])).answers["a"].float
    assert found == pytest.approx(
        4 / (2 + 4**2)
    )  # Q = (J + I (r/R)²) α of the larger, which the smaller turns past by r/R


ELSEWHERE = {  # limits of numbers that are no letters of a scene, or that letters break at single values only
    "the step of a range must be positive": "numbers of `vary`",
    "ends before it begins": "numbers of `vary`",
    "of the range": "numbers of `vary`",
    "the corners of": "at single values only",
    "is a direction of length 0": "at single values only",
    "begins where it ends": "at single values only",
    "no body has these moments of inertia": "in space, see tests/space/test_space_refusals",
    "no body has this inertia tensor": "in space, see tests/space/test_space_refusals",
    "an inertia tensor is symmetric": "in space, see tests/space/test_space_refusals",
}


def says_limits(node: ast.AST) -> bool:
    """Whether a call reports a value beyond its limits."""
    if not isinstance(node, ast.Call):
        return False
    return any(
        isinstance(arg, ast.Constant) and arg.value == "limits"
        for arg in (*node.args, *(key.value for key in node.keywords))
    )


def test_each_limit_of_the_reader_is_among_them() -> None:
    """What the reader refuses as beyond a limit is in the table, or no matter of letters."""
    known = [part for _, _, said in SCENES.values() for part in said.split("|")] + list(ELSEWHERE)
    seen = 0
    for path in Path(rotsolve.__file__).parent.glob("scene/*.py"):
        for function in ast.walk(ast.parse(path.read_text())):
            if not isinstance(function, ast.FunctionDef) or not any(map(says_limits, ast.walk(function))):
                continue
            texts = [
                node.value
                for node in ast.walk(function)
                if isinstance(node, ast.Constant) and isinstance(node.value, str)
            ]
            assert any(part in text for part in known for text in texts), function.name
            seen += 1
    assert seen > 8
