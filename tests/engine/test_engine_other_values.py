"""Other values of a letter that is sought are found over its range, whatever tells it; smallest and largest are the ends of all."""

from __future__ import annotations

import math
from itertools import pairwise

import numpy
import pytest

import rotsolve
from rotsolve import Unsolvable, solve
from rotsolve.confirm.course.samples import holding
from rotsolve.confirm.course.scan import Scan, places_beside
from rotsolve.confirm.numbers import value_of

HOIST = """
title: Load on a drum with a motor
given: {I: 1 kg m^2, m: 1 kg, R: 1 m, t1: 1 s, h: 0.5 m, Q: unknown}
bodies: {drum: {inertia: I, radius: R}, load: {mass: m, moves: up}}
connections: {ax: {axle: drum}, rope: {string: [drum, load]}}
actions: {mot: {couple: Q, on: drum}}
states: {start: at rest, end: {time: t1LINES}}
find: {ASK}
"""
WIRE = """
title: Two couples on a disc on a wire
plane: horizontal
given: {I: 1 kg m^2, kappa: 2 N m/rad, Q0: 5 N m, Q: unknown}
bodies: {disc: {inertia: I}}
connections: {ax: {axle: disc}, wire: {torsion: disc, stiffness: kappa}}
actions: {a1: {couple: Q, on: disc}, a2: {couple: Q0, on: disc, direction: clockwise}}
states: {end: {balance: true}}
find: {ASK}
"""
BLOCK = """
title: Block on a table that a load pulls over a drum
given: {Q: unknown, M: 10 kg, I: 0.01 kg m^2, R: 0.5 m}
surfaces: {floor: level}
bodies: {block: {mass: M, moves: right}, drum: {inertia: I, radius: R, turns: clockwise}, load: {mass: Q, moves: down}}
connections: {base: {contact: [block, floor], friction: {static: 0.5, kinetic: 0.3}}, ax: {axle: drum}, rope: {string: [block, drum, load]}}
states: {end: at rest}
find: {ASK}
"""
BLOW = """
title: Blow on a rod that turns
given: {M: 3 kg, L: 1 m, w: 2 rad/s, Q: unknown}
plane: horizontal
bodies: {rod: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: rod.start}}
states: {still: {rod.angle: 0, rod.angular_velocity: w}, end: {}}
events: {blow: {impulse: Q, on: rod.end, direction: down, from: still, to: end}}
find: {ASK}
"""
# v = (Q − 9.8)/2, so that all that hangs on v² or |v| = 1 has 9.8 ± 2; of the power Q v = −10 the roots of Q² − 9.8 Q + 20
BY_SPEED = (7.8, 11.8)
BY_POWER = tuple((9.8 + sign * (9.8**2 - 80) ** 0.5) / 2 for sign in (-1, 1))
# it holds with m g = 46 N, and slides with 46 N = 0.3 M g + M a, a = 1.66 m/s² = (m − 3) g/(m + 10.04)
BY_TENSION = (46 / 9.8, (29.4 + 1.66 * 10.04) / (9.8 - 1.66))
CONDITIONS = {
    "kinetic_energy at end = 1 J": (HOIST, BY_SPEED),
    "load.kinetic_energy at end = 0.5 J": (HOIST, BY_SPEED),
    "load.speed at end = 1 m/s": (HOIST, BY_SPEED),
    "size of load.velocity at end = 1 m/s": (HOIST, BY_SPEED),
    "size of load.momentum at end = 1 N s": (HOIST, BY_SPEED),
    "size of drum.angular_momentum at end = 1 kg m^2/s": (HOIST, BY_SPEED),
    "size of load.displacement from start to end = h": (HOIST, BY_SPEED),
    "size of load.acceleration at start = 1 m/s^2": (HOIST, BY_SPEED),
    "drum.rim.acceleration.normal at end = 1 m/s^2": (HOIST, BY_SPEED),
    "mot.power at end = -10 W": (HOIST, BY_POWER),
    "wire.potential_energy at end = 1 J": (WIRE, (3.0, 7.0)),
    "rope.block.tension = 46 N at end": (BLOCK, BY_TENSION),
}


def asking(scene: str, ask: str, lines: str = "") -> str:
    return scene.replace("ASK", ask if ":" in ask else f"Q: {ask}").replace("LINES", lines)


@pytest.mark.parametrize("condition", CONDITIONS)
def test_one_of_two_values_is_not_answered(condition: str) -> None:
    scene, _ = CONDITIONS[condition]
    with pytest.raises(rotsolve.Unsolvable, match="makes it so too: ask for the `smallest` or the `largest` one"):
        rotsolve.solve(asking(scene, f"Q where {condition}"))


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("place", "word"), [(0, "smallest"), (1, "largest")])
@pytest.mark.parametrize("condition", CONDITIONS)
def test_the_smallest_and_the_largest_are_the_ends_of_all(condition: str, place: int, word: str) -> None:
    scene, values = CONDITIONS[condition]
    text = asking(scene, f"{word} Q where {condition}")
    assert rotsolve.solve(text).answers["Q"].float == pytest.approx(values[place])


@pytest.mark.parametrize(
    "line",
    [
        "kinetic_energy: 1 J",
        "load.kinetic_energy: 0.5 J",
        "load.speed: 1 m/s",
        "drum.rim.acceleration.normal: 1 m/s^2",
        "mot.power: -10 W",
    ],
)
@pytest.mark.parametrize(
    ("ask", "why"),
    [
        ("Q", "contradicts `Q`: Q = [0-9.]+ in SI units makes it so too: tell more of it"),
        ("v: load.velocity at end", "contradicts `v`"),
    ],
)
def test_an_unknown_that_a_state_tells_has_one_value_only(line: str, ask: str, why: str) -> None:
    """Also where no question asks for the letter itself, but for what hangs on it."""
    with pytest.raises(rotsolve.Unsolvable, match=why):
        rotsolve.solve(asking(HOIST, ask, f", {line}"))


def test_an_unknown_with_one_value_is_answered() -> None:
    solution = rotsolve.solve(asking(HOIST, "Q", ", load.velocity: -1 m/s"))
    assert solution.answers["Q"].float == pytest.approx(BY_SPEED[0])
    assert all(verdict.holds and not verdict.also for verdict in solution.derivation.confirmed)


LETTERS = HOIST.replace("{I: 1 kg m^2, m: 1 kg, R: 1 m, t1: 1 s, h: 0.5 m,", "{I: kg m^2, m: kg, R: m, t1: s, K: J,")


def test_of_letters_it_is_said_with_which_numbers_another_value_does() -> None:
    solution = rotsolve.solve(asking(LETTERS, "Q where kinetic_energy at end = K"))
    (verdict,) = solution.derivation.confirmed
    assert verdict.holds is None
    assert "makes it so too" in verdict.why


@pytest.mark.parametrize(("place", "word"), [(0, "smallest"), (1, "largest")])
def test_the_ends_of_all_values_in_letters(place: int, word: str) -> None:
    answer = rotsolve.solve(asking(LETTERS, f"{word} Q where kinetic_energy at end = K")).answers["Q"].answer
    known = {"I": 1.0, "m": 1.0, "R": 1.0, "t1": 1.0, "K": 1.0, "g": 9.8}
    case = holding(answer, known)
    assert case is not None
    assert case.closed is not None
    assert value_of(case.closed, known) == pytest.approx(BY_SPEED[place])


def test_a_value_against_the_sense_of_a_size_is_told_beside_it() -> None:
    """½ (1 kg m²) ω² = 8 J: ω = ±4 = 2 − J, a push of 6 N s; the other is a pull of 2 N s, which is no push downwards."""
    solution = rotsolve.solve(asking(BLOW, "largest Q where kinetic_energy at end = 8 J"))
    assert solution.answers["Q"].float == pytest.approx(6)
    solution = rotsolve.solve(asking(BLOW.replace("down", "up"), "Q where kinetic_energy at end = 8 J"))
    assert solution.answers["Q"].float == pytest.approx(2)
    (verdict,) = solution.derivation.confirmed
    assert verdict.holds
    assert verdict.also == " = -6 in SI units makes it so too"


FUNCTIONS = {
    "two roots": (lambda x: (x - 2) * (x - 5), 2.0, [5.0]),
    "a root next to the known one": (lambda x: (x - 2) * (x - 2.05), 2.0, [2.05]),
    "one root": (lambda x: x**3 - 8, 2.0, []),
    "two roots between neighbouring places": (lambda x: (x - 2) * (x - 30) * (x - 31), 2.0, [30.0, 31.0]),
    "a root beyond a jump": (lambda x: x - 2 if x < 3 else x - 3.1, 2.0, [3.1]),
    "a root where it hardly has a value": (lambda x: (x - 2) * (x - 9) if x < 9.5 else None, 2.0, [9.0]),
}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_roots_beside_a_known_one(name: str) -> None:
    function, known, roots = FUNCTIONS[name]

    def reach(at: float) -> tuple[float, object] | None:
        value = function(at)
        return None if value is None else (value, at < 3 or name != "a root beyond a jump")

    found = sorted(Scan(reach, known).roots(places_beside(known, 1.0, None)))
    assert found == pytest.approx(roots)


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("start", "way"), [(-150, 1), (-30, -1), (150, 1), (30, -1)])
def test_a_place_to_which_the_motion_comes_later_is_no_other_value(start: int, way: int) -> None:
    """A rod let go has 1.5 rad/s on both sides of its lowest place; a state is the first of them."""
    solution = rotsolve.solve(f"""
given: {{m: 2 kg, L: 0.6 m, th: unknown, g: 9.8 m/s^2, w: 1.5 rad/s}}
bodies: {{rod: {{shape: rod, mass: m, length: L}}}}
connections: {{pin: {{hinge: rod.start}}}}
states: {{start: {{rod.angle: {start} deg, at rest: all}}, fast: {{rod.angle: th, rod.angular_velocity: {way}*w}}}}
find: {{th: th}}
""")
    fallen = math.asin(math.sin(math.radians(start)) - 1.5**2 * 0.6 / (3 * 9.8))
    (told,) = solution.answers.values()
    assert math.sin(told.float) == pytest.approx(math.sin(fallen))
    assert abs(told.float - math.radians(start)) < 0.3
    assert [verdict.holds for verdict in solution.derivation.confirmed] == [
        True if start < 0 else None
    ]  # not all looked for


SHAFT = """
given: {M: 1 kg, L: 60 cm, w: 8 rad/s, b: 10 cm, q: unknown, g: 9.8 m/s^2}
bodies: {rod: {shape: rod, mass: M, length: L}}
connections: {pin: {shaft: rod.start, turning: w, distance: b}}
states: {round: {rod.angle: q - 90 deg, steady: true}}
find: {FIND}
"""


def places_on_shaft() -> list[tuple[float, float]]:
    """Where a rod stands on its shaft, from hanging on, and the slope of what drives it there: below 0 it comes back."""

    def drive(q: float) -> float:
        return 64 * math.cos(q) * (0.1 * 0.3 + 0.36 / 3 * math.sin(q)) - 9.8 * 0.3 * math.sin(q)

    places = [-math.pi + k * math.tau / 1000 for k in range(1001)]
    found = []
    for low, high in pairwise(places):
        if drive(low) * drive(high) <= 0:
            place = low - drive(low) * (high - low) / (drive(high) - drive(low))  # 0.36° apart: good to 1e-5
            found.append((math.degrees(place), drive(place + 1e-6) - drive(place - 1e-6)))
    return found


@pytest.mark.parametrize("word", ["largest", "smallest"])
def test_the_largest_place_on_a_shaft_is_one_to_which_it_comes_back(word: str) -> None:
    stable = [place for place, slope in places_on_shaft() if slope < 0]
    value = (max if word == "largest" else min)(stable)
    assert solve(SHAFT.replace("FIND", f"q: {word} q in deg")).answers["q"].float == pytest.approx(value, abs=1e-3)


LUMP = """
given: {m: 1 kg, M: 2 kg, L: 1 m, a: -15.2 rad/s^2, x: unknown, g: 9.8 m/s^2}
bodies: {rod: {shape: rod, mass: M, length: L}, lump: {mass: m}}
connections: {pin: {hinge: rod.start}, w1: {weld: [rod.at(x), lump]}}
states: {now: {rod.angle: 0, rod.angular_velocity: 0, rod.angular_acceleration: a}}
find: {x: FIND x}
"""


@pytest.mark.parametrize("word", ["largest", "smallest"])
def test_the_largest_root_is_not_the_one_that_is_taken_without_the_word(word: str) -> None:
    """(M L²/3 + m x²) a = −(½ M L + m x) g."""
    roots = sorted(numpy.roots([-15.2, 9.8, 9.8 - 15.2 * 2 / 3]).real)
    value = roots[-1] if word == "largest" else roots[0]
    assert solve(LUMP.replace("FIND", word)).answers["x"].float == pytest.approx(value)
    with pytest.raises(Unsolvable, match="makes it so too"):
        solve(LUMP.replace("FIND", ""))


SWUNG = """
given: {M: 2 kg, L: 1 m, w: W, q: Q, g: 9.8 m/s^2}
bodies: {rod: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: rod.start}}
states: {now: {rod.angle: q, rod.angular_velocity: w, TOLD}}
find: {FIND}
"""


@pytest.mark.parametrize("find", ["F: pin.force.y", "v: rod.end.velocity.x", "K: rod.kinetic_energy, F: pin.force.y"])
def test_an_angle_on_the_way_may_be_to_either_side(find: str) -> None:
    """With cos q told q may be ±114.09°, and the forces differ; what is the same on both sides stays."""
    scene = (
        SWUNG.replace("W,", "4 rad/s,").replace("Q,", "unknown,").replace("TOLD", "rod.angular_acceleration: 6 rad/s^2")
    )
    with pytest.raises(Unsolvable, match=r"q = −114\.09° makes it so too"):
        solve(scene.replace("FIND", find.rpartition(", ")[2]))
    if find.startswith("K"):
        found = solve(scene.replace("FIND", find))
        assert found.answers["K"].float == pytest.approx(2 / 6 * 16)
        assert "F" in found.refused


def test_a_rate_on_the_way_is_positive_and_that_is_said() -> None:
    scene = SWUNG.replace("W,", "unknown,").replace("Q,", "30 deg,").replace("TOLD", "pin.force.x: -20 N")
    found = solve(scene.replace("FIND", "v: rod.end.velocity.y, K: rod.kinetic_energy"))
    notes = {item.name: item.also for item in found.derivation.confirmed}
    assert "makes it so too" in notes["v"]
    assert not notes["K"]


@pytest.mark.parametrize("find", ["q: q", "a: rod.angular_acceleration at up"])
def test_what_hangs_on_a_start_that_is_sought_ends(find: str) -> None:
    """Which way a rod sets out hangs on the angle that is sought by how fast it comes to its lowest place: either side does."""
    scene = SWUNG.replace("w: W, ", "").replace("q: Q", "q: unknown").partition("states")[0]
    states = "states: {up: {rod.angle: q, at rest: all}, low: {rod.angle: -90 deg, rod.end.speed: 5 m/s}}\n"
    with pytest.raises(Unsolvable, match="makes it so too"):
        solve(f"{scene}{states}find: {{{find}}}\n")
