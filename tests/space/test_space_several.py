"""Several motions that fit a state: what is asked says which is meant, upright is not one of them, and none is taken silently.

Values by hand, and the assembly of all bodies' equations sees the others too.
"""

from __future__ import annotations

import math
from fractions import Fraction

import pytest

from rotsolve import SceneError, Unsolvable, solve
from rotsolve.confirm.space.hearing import Hearing
from rotsolve.confirm.space.rivals import fits_as_asked
from rotsolve.scene.read import read_text
from rotsolve.space.complete import configured_in_space

G = 9.8
CONE = """given: {m: 1 kg, l: 0.5 m, W: 8 rad/s, theta: unknown}
bodies: {rod: {shape: rod, mass: m, length: l, axis: x}}
connections: {nail: {ball: rod.start}}
states: {now: {rod.tilt: TILT, rod.precession: W, steady: true}}
"""
TOP = """given: {M: 0.2 kg, l: 0.05 m, I1: 6e-4 kg m^2, I3: 8e-5 kg m^2, GIVEN}
bodies: {top: {mass: M, inertia: {about: tip, principal: [I1, I1, I3]}, axis: z, points: {tip: [0, 0, -l]}}}
connections: {floor: {ball: top.tip}}
states: {now: {STATE, steady: true}}
"""
COIN = """given: {m: 10 g, r: 1 cm, GIVEN}
bodies: {coin: {shape: disc, mass: m, radius: r}}
surfaces: {table: level}
connections: {grip: {rolls: [coin, table]}}
states: {now: {STATE, steady: true}}
"""
LEANING = math.acos(3 * G / (2 * 64 * 0.5))  # a rod that describes a cone: cos θ = 3 g/(2 W² l) from straight down


def top(given: str, state: str, find: str) -> str:
    return TOP.replace("GIVEN", given).replace("STATE", state) + f"find: {find}\n"


def coin(given: str, state: str, find: str) -> str:
    return COIN.replace("GIVEN", given).replace("STATE", state) + f"find: {find}\n"


def precessions(axial: float, tilt: float) -> tuple[float, float]:
    """I₁ cos θ Ω² − I₃ ω₃ Ω + M g l = 0."""
    a, b, c = 6e-4 * math.cos(tilt), 8e-5 * axial, 0.2 * G * 0.05
    root = math.sqrt(b * b - 4 * a * c)
    return tuple(sorted(((b - root) / (2 * a), (b + root) / (2 * a))))  # type: ignore[return-value]


def of_coin(spin: float, tilt: float) -> tuple[float, float]:
    """5/4 r Ω² sin θ cos θ + 3/2 r s Ω sin θ + g cos θ = 0 (a coin without slip, its forces put in)."""
    a, b, c = 1.25 * 0.01 * math.sin(tilt) * math.cos(tilt), 1.5 * 0.01 * spin * math.sin(tilt), G * math.cos(tilt)
    root = math.sqrt(b * b - 4 * a * c)
    return tuple(sorted(((-b - root) / (2 * a), (-b + root) / (2 * a))))  # type: ignore[return-value]


TWENTY, SIXTY = math.radians(20), math.radians(60)
SLOW, FAST = precessions(400, TWENTY)
TOLD = "top.tilt: theta, top.axial_rate: w3, top.precession: W"
CASES = {
    "the tilt of a cone": (CONE.replace("TILT", "theta") + "find: {c: theta}\n", {"c": math.pi - LEANING}),
    "from straight down": (CONE.replace("TILT", "180 deg - theta") + "find: {c: theta}\n", {"c": LEANING}),
    "the largest, of the only one that leans": (
        CONE.replace("TILT", "180 deg - theta") + "find: {c: largest theta}\n",
        {"c": LEANING},
    ),
    "a tilt without a letter": (
        CONE.replace(", theta: unknown", "").replace("rod.tilt: TILT, ", "") + "find: {c: rod.tilt}\n",
        {"c": math.pi - LEANING},
    ),
    "too slow to lean: straight down": (
        CONE.replace("TILT", "180 deg - theta").replace("8 rad/s", "3 rad/s") + "find: {c: smallest theta}\n",
        {"c": 0.0},
    ),
    "the tilt of a top": (
        top(f"w3: 400 rad/s, W: {SLOW!r} rad/s, theta: unknown", TOLD, "{c: theta}"),
        {"c": TWENTY},
    ),
    "the smallest rate of a top as a letter": (
        top("w3: 400 rad/s, W: unknown, theta: 20 deg", TOLD, "{c: smallest W}"),
        {"c": SLOW},
    ),
    "the largest": (top("w3: 400 rad/s, W: unknown, theta: 20 deg", TOLD, "{c: largest W}"), {"c": FAST}),
    "the smallest of a spin the other way: the faster one": (
        top("w3: -400 rad/s, W: unknown, theta: 20 deg", TOLD, "{c: smallest W}"),
        {"c": -FAST},
    ),
    "the axial rate, of which there is one": (
        top(f"w3: unknown, W: {SLOW!r} rad/s, theta: 20 deg", TOLD, "{c: w3}"),
        {"c": 400},
    ),
    "a length, which is positive": (
        top(f"w3: 400 rad/s, W: {SLOW!r} rad/s, theta: 20 deg", TOLD, "{c: l}").replace("l: 0.05 m", "l: unknown"),
        {"c": 0.05},
    ),
    "a coin in a circle, both ways": (
        coin(
            "theta: 60 deg, s: 30 rad/s",
            "coin.tilt: theta, coin.spin: s",
            "{a: smallest coin.precession, b: largest coin.precession}",
        ),
        dict(zip("ab", of_coin(30, SIXTY), strict=True)),
    ),
    "one of them as a letter": (
        coin(
            "W: unknown, theta: 60 deg, s: 30 rad/s",
            "coin.tilt: theta, coin.spin: s, coin.precession: W",
            "{a: largest W}",
        ),
        {"a": of_coin(30, SIXTY)[1]},
    ),
    "its spin": (
        coin(
            f"W: {of_coin(30, SIXTY)[0]!r} rad/s, theta: 60 deg, s: unknown",
            "coin.tilt: theta, coin.spin: s, coin.precession: W",
            "{a: s}",
        ),
        {"a": 30},
    ),
    "the size of a precession, by its name": (
        top(
            "w3: -400 rad/s, theta: 20 deg",
            "top.tilt: theta, top.axial_rate: w3",
            "{a: smallest top.precession, b: size of a}",
        ),
        {"a": -FAST, "b": FAST},
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_what_is_meant_is_answered(name: str) -> None:
    scene, known = CASES[name]
    solution = solve(f"title: T\nup: z\n{scene}").complete()
    for key, value in known.items():
        assert solution.answers[key].float == pytest.approx(value, rel=1e-9, abs=1e-12), key
    assert {item.name for item in solution.derivation.confirmed if item.holds} >= known.keys()


def test_in_letters_it_holds_where_it_leans() -> None:
    """cos θ = 3 g/(2 W² l) where that is below 1; the rest is refused, not taken as upright."""
    text = (
        CONE.replace("TILT", "180 deg - theta").replace("1 kg", "kg").replace("0.5 m", "m").replace("8 rad/s", "rad/s")
    )
    solution = solve(
        "title: T\nup: z\n" + text.replace("theta: unknown", "theta: unknown, g: m/s^2") + "find: {c: theta}\n"
    )
    rows = solution.evaluate_many({"m": [1.0, 1.0], "l": [0.5, 0.5], "W": [8.0, 3.0], "g": [G, G]})
    assert rows["c"][0] == pytest.approx(LEANING, rel=1e-9)
    assert math.isnan(rows["c"][1])


ROLLING = "coin.tilt: theta, coin.spin: s, coin.precession: W"
REFUSED = {
    "a rate": (
        top("w3: 400 rad/s, W: unknown, theta: 20 deg", TOLD, "{c: W}"),
        "several motions are possible",
        "`smallest W`",
    ),
    "one of a coin": (
        coin("W: unknown, theta: 60 deg, s: 30 rad/s", ROLLING, "{c: W}"),
        "several motions are possible",
        "`largest W`",
    ),
    "both at once": (
        coin("W: unknown, theta: 60 deg, s: 30 rad/s", ROLLING, "{a: smallest W, b: largest W}"),
        "several motions are possible",
        "one of them in a scene",
    ),
    "what hangs on it": (
        coin("W: unknown, theta: 60 deg, s: 30 rad/s", ROLLING, "{a: coin.speed}"),
        "several motions are possible",
        "`smallest W`",
    ),
    "a rod that hangs or stands": (
        CONE.replace("TILT", "theta").replace("8 rad/s", "3 rad/s") + "find: {c: theta}\n",
        "no tilt but upright or upside down is steady with these rates",
        "a faster precession",
    ),
    "the largest of what has a modifier already": (
        top(
            "w3: 400 rad/s, theta: 20 deg",
            "top.tilt: theta, top.axial_rate: w3",
            "{c: largest (size of top.precession)}",
        ),
        "`largest` in front of `size of` is not solved",
        "by its name",
    ),
    "the smallest tilt as a quantity": (
        CONE.replace(", theta: unknown", "").replace("rod.tilt: TILT, ", "") + "find: {c: smallest rod.tilt}\n",
        "the smallest `tilt` is asked of a steady precession",
        "x: unknown",
    ),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_not_told_is_refused(name: str) -> None:
    scene, words, help = REFUSED[name]
    with pytest.raises((SceneError, Unsolvable)) as refusal:
        solve(f"title: T\nup: z\n{scene}").complete()
    assert words in str(refusal.value)
    assert help in str(refusal.value)


NOD = """given: {M: 0.2 kg, l: 0.05 m, I1: 6e-4 kg m^2, I3: 8e-5 kg m^2, w3: 400 rad/s, W: 12 rad/s}
bodies: {top: {mass: M, inertia: {about: tip, principal: [I1, I1, I3]}, axis: z, points: {tip: [0, 0, -l]}}}
connections: {floor: {ball: top.tip}}
states: {start: {top.tilt: 40 deg, top.axial_rate: w3, top.precession: W, top.nutation: -6 rad/s}, then: {top.tilt: WORD}}
find: {t: top.tilt at then}
"""


def turning_tilts() -> list[float]:
    """Where ½ I₁ θ̇² = E − ½ (L_z − I₃ ω₃ cos θ)²/(I₁ sin² θ) − M g l cos θ is nothing, by halving."""
    u, spin = math.cos(math.radians(40)), 8e-5 * 400
    about_up = 6e-4 * 12 * (1 - u * u) + spin * u
    energy = 0.5 * 6e-4 * (36 + 144 * (1 - u * u)) + 0.2 * G * 0.05 * u

    def left(t: float) -> float:
        return energy - 0.5 * (about_up - spin * math.cos(t)) ** 2 / (6e-4 * math.sin(t) ** 2) - 0.098 * math.cos(t)

    found = []
    for outside in (0.01, 3.0):
        inside = math.radians(40)
        for _ in range(200):
            middle = (inside + outside) / 2
            inside, outside = (middle, outside) if left(middle) > 0 else (inside, middle)
        found.append(inside)
    return found


@pytest.mark.parametrize("word", ["smallest", "largest"])
def test_a_tilt_without_a_closed_form_lies_from_0_to_180_degrees(word: str) -> None:
    """A top that nods at the start comes to the tilt that the state says, not to its mirror image."""
    solution = solve("title: T\nup: z\n" + NOD.replace("WORD", word)).complete()
    assert solution.answers["t"].float == pytest.approx(turning_tilts()[word == "largest"], rel=1e-9)
    assert all(item.holds for item in solution.derivation.confirmed)


SEEN = {  # numbers for a letter, and whether each is the one that is asked
    "upright beside one that leans": (
        CASES["from straight down"][0],
        "theta",
        {LEANING: True, 0.0: False, math.pi: False},
    ),
    "one of two rates": (REFUSED["a rate"][0], "W", {SLOW: None, FAST: None}),
    "the smallest of two": (CASES["the smallest rate of a top as a letter"][0], "W", {SLOW: True, FAST: False}),
    "the largest of two": (
        CASES["one of them as a letter"][0],
        "W",
        dict(zip(of_coin(30, SIXTY), (False, True), strict=True)),
    ),
}


@pytest.mark.parametrize("name", SEEN)
def test_the_assembly_sees_that_several_motions_fit(name: str) -> None:
    text, letter, wanted = SEEN[name]
    problem = configured_in_space(read_text(f"title: t\nup: z\n{text}")).problem
    known = {
        given.name: float(Fraction(given.value.value)) for given in problem.givens if hasattr(given.value, "value")
    }
    known["theta"] = known.get("theta", math.radians(60 if "coin" in text else 20))
    for value, meant in wanted.items():
        hearing = Hearing(problem, {"g": G, **known, letter: value}, {})
        find = next(find for find in problem.finds if letter in find.formula.symbols())
        assert fits_as_asked(hearing, find, value, ()) is meant, value


@pytest.mark.parametrize("later", ["", ", later: {time: T}", ", mid: {time: T}, later: {time: T}"])
def test_a_later_time_leaves_a_steady_tilt_as_sure(later: str) -> None:
    """cos θ = (I₃ ω₃ W − M g l)/(I₁ W²), and upright is no other answer."""
    text = top(
        "w3: 400 rad/s, W: 3.2 rad/s, q: unknown, T: 0.1 s",
        "top.tilt: q, top.axial_rate: w3, top.precession: W",
        "{q: q}",
    )
    text = text.replace("steady: true}", f"steady: true}}{later}") if later else text.replace(", T: 0.1 s", "")
    solution = solve(f"title: T\nup: z\n{text}").complete()
    assert solution.answers["q"].float == pytest.approx(
        math.acos((8e-5 * 400 * 3.2 - 0.2 * G * 0.05) / (6e-4 * 3.2**2))
    )
    assert [item.holds for item in solution.derivation.confirmed] == [True]


MILL = """title: t
up: z
given: {m: 2 kg, R: 0.3 m, L: 0.8 m, W: unknown, N: unknown}
bodies: {wheel: {parts: {disc: {shape: disc, mass: m, radius: R, at: [0, 0, L]}}, axis: z, points: {O: [0, 0, 0], Q: [0, -R, L]}}}
connections: {pivot: {ball: wheel.O}}
actions: {push: {force: N, on: wheel.Q, direction: z}}
states: {now: {wheel.tilt: 90 deg, wheel.precession: W, wheel.spin: -W*L/R, steady: true}}
"""


def test_a_question_that_another_condition_settles_is_said_to_stand_beside_it() -> None:
    """N = m (g + ½ R W²), W = s R/L: what one condition makes of W is not what the other does."""
    one, two = (
        "F: push.force.z where wheel.spin at now = -10 rad/s",
        "W: largest W where push.force.z at now = 3*m*9.8 m/s^2",
    )
    derivation = solve(MILL + f"find: {{{one}, {two}}}\n").derivation
    assert [item.name for item in derivation.answers] == ["W"]
    (refused,) = derivation.refused
    assert "`F` is not solved beside `W`" in refused.fault.message
    alone = solve(MILL + f"find: {{{one}}}\n").answers["F"]
    assert float(alone.value) == pytest.approx(2 * (9.8 + 0.15 * (10 * 0.3 / 0.8) ** 2), rel=5e-4)
