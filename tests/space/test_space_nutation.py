"""Nutation: how long a top takes from tilt to tilt, and how far it goes round meanwhile; by steps in time, by the assembly, by hand."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

from rotsolve import Unsolvable, solve

M, LENGTH, I1, I3, G = 0.15, 0.04, 5e-4, 6e-5, 9.8
GIVEN = "{M: 0.15 kg, l: 4 cm, I1: 5e-4 kg m^2, I3: 6e-5 kg m^2, w3: 300 rad/s, theta: 25 deg, g: 9.8 m/s^2}"
TOP = f"""given: {GIVEN}
bodies: {{top: {{mass: M, inertia: {{about: tip, principal: [I1, I1, I3]}}, axis: z, points: {{tip: [0, 0, -l]}}}}}}
connections: {{floor: {{ball: top.tip}}}}
"""
BOB = """given: {m: 2 kg, L: 1 m, h: 120 deg, g: 9.8 m/s^2}
bodies: {bob: {parts: {b: {shape: particle, mass: m, at: [0, 0, 0]}}, points: {P: [0, 0, -L]}}}
connections: {pivot: {ball: bob.P}}
"""
DOWN = "low: {top.tilt: largest}"
BOTH = "T: top.period at start, t: time from start to low, d: change of top.precession_angle from start to low"


def let_go(rate: str, states: str, find: str, scene: str = TOP) -> str:
    first = f"start: {{top.tilt: theta, top.axial_rate: w3, top.precession: {rate}, top.nutation: 0 rad/s}}"
    return f"{scene}states: {{{', '.join(filter(None, (first, states)))}}}\nfind: {{{find}}}\n"


def swung(rate: str, states: str, find: str, scene: str = BOB) -> str:
    first = f"start: {{bob.tilt: h, bob.precession: {rate}, bob.nutation: 0 rad/s}}"
    return f"{scene}states: {{{', '.join(filter(None, (first, states)))}}}\nfind: {{{find}}}\n"


def answers(scene: str) -> dict[str, float]:
    """All answers of a scene, each of them confirmed."""
    derivation = solve(f"title: T\nup: z\n{scene}").complete().derivation
    assert [(item.name, item.holds, item.why) for item in derivation.confirmed if item.holds is not True] == []
    assert derivation.confirmed
    return {item.name: item.value.float for item in derivation.answers if item.value is not None}


def half_by_steps(spin: float, tilt: float, rate: float, lift: float, across: float) -> tuple[float, float]:
    """The time from a tilt without nutation to the next such one, and the angle gone round, by Runge and Kutta in Lagrange's equations."""
    vertical = rate * math.sin(tilt) ** 2 + spin * math.cos(tilt)

    def slope(now: list[float]) -> list[float]:
        turn = (vertical - spin * math.cos(now[0])) / math.sin(now[0]) ** 2
        return [now[1], math.sin(now[0]) * (turn * (turn * math.cos(now[0]) - spin) + lift / across), turn]

    step, now, time = 1e-4, [tilt, 0.0, 0.0], 0.0
    while True:
        a = slope(now)
        b = slope([x + step / 2 * k for x, k in zip(now, a, strict=True)])
        c = slope([x + step / 2 * k for x, k in zip(now, b, strict=True)])
        d = slope([x + step * k for x, k in zip(now, c, strict=True)])
        later = [x + step / 6 * (p + 2 * q + 2 * r + s) for x, p, q, r, s in zip(now, a, b, c, d, strict=True)]
        if time and now[1] * later[1] <= 0.0:
            share = now[1] / (now[1] - later[1])
            return time + share * step, now[2] + share * (later[2] - now[2])
        now, time = later, time + step


@pytest.mark.parametrize(
    ("spin", "rate", "word"),
    [(300, 0, "largest"), (300, -5, "largest"), (300, 16, "smallest"), (20, 0, "largest"), (-200, 1, "largest")],
)
def test_a_top_takes_as_long_as_by_steps_in_time(spin: int, rate: int, word: str) -> None:
    scene = let_go(f"{rate} rad/s", DOWN.replace("largest", word), BOTH).replace("300 rad/s", f"{spin} rad/s")
    found = answers(scene)
    time, angle = half_by_steps(I3 * spin / I1, math.radians(25), rate, M * G * LENGTH, I1)
    assert found["t"] == pytest.approx(time, rel=1e-7)
    assert found["d"] == pytest.approx(angle, rel=1e-6)
    assert found["T"] == pytest.approx(2 * found["t"], rel=1e-12)


@pytest.mark.parametrize(("rate", "word"), [(2, "largest"), (6, "smallest")])
def test_so_does_a_spherical_pendulum(rate: int, word: str) -> None:
    """Its axis points from the pivot to the bob: beyond 90° it hangs."""
    asked = "T: bob.period at start, t: time from start to end, d: change of bob.precession_angle from start to end"
    found = answers(swung(f"{rate} rad/s", f"end: {{bob.tilt: {word}}}", asked))
    time, angle = half_by_steps(0.0, math.radians(120), rate, G, 1.0)
    assert found["t"] == pytest.approx(time, rel=1e-7)
    assert found["d"] == pytest.approx(angle, rel=1e-6)
    assert found["T"] == pytest.approx(2 * time, rel=1e-7)


def test_a_plane_pendulum_is_the_case_without_precession() -> None:
    """√(L/g) K(sin² 30°) from 60° beside the vertical down to it; 30° before that by F(arcsin(sin 15°/sin 30°), …) less."""
    mpmath = pytest.importorskip("mpmath")
    found = answers(swung("0 rad/s", "mid: {bob.tilt: 150 deg}", "t: time from start to mid"))
    m, k = 0.25, math.sin(math.radians(15)) / 0.5
    assert found["t"] == pytest.approx(
        float(mpmath.ellipk(m) - mpmath.ellipf(math.asin(k), m)) / math.sqrt(G), rel=1e-12
    )


def test_times_add_up_over_the_states_of_a_nutation() -> None:
    """Out and back between the same tilts, each the first time after the one before."""
    states = (
        "a: {top.tilt: 26 deg}, b: {top.tilt: 27 deg}, c: {top.tilt: largest}, d: {top.tilt: 27 deg}, e: {top.tilt: 26 deg}, "
        "f: {top.tilt: smallest}"
    )
    names = ["start", *"abcdef"]
    pairs = {f"t_{one}_{two}": (one, two) for one, two in pairwise(names)}
    asked = ", ".join(f"{key}: time from {one} to {two}" for key, (one, two) in pairs.items())
    found = list(answers(let_go("0 rad/s", states, f"{asked}, T: time from start to f")).values())
    assert found[:3] == pytest.approx(found[5:2:-1], rel=1e-9)
    assert sum(found[:-1]) == pytest.approx(found[-1], rel=1e-12)


def test_times_that_states_tell_are_added() -> None:
    assert answers(let_go("0 rad/s", "one: {time: 2 s}, two: {time: 3 s}", "t: time from start to two"))["t"] == 5


def test_letters_keep_their_elliptic_integrals() -> None:
    letters = "{M: kg, l: m, I1: kg m^2, I3: kg m^2, w3: rad/s, theta: rad}"
    text = str(
        solve(f"title: T\nup: z\n{let_go('0 rad/s', DOWN, BOTH).replace(GIVEN, letters)}", confirm=False).complete()
    )
    assert "T = 2 K(m)/p" in text
    assert "t = K(m)/p" in text
    assert "Π(n₁, m)" in text


NEVER = (
    TOP.replace("w3: 300 rad/s", "w3: sqrt(3*M*g*l*I1)/I3").replace("25 deg", "60 deg"),
    "I3*w3/(I1*(1 + cos(theta)))",
)
REFUSED = {  # a scene, and what is said of it
    "a tilt beyond the nutation": (
        let_go("0 rad/s", "low: {top.tilt: 40 deg}", "t: time from start to low"),
        "`top` does not come to that tilt",
    ),
    "one on the other side": (
        let_go("0 rad/s", "low: {top.tilt: 20 deg}", "t: time from start to low"),
        "`top` does not come to that tilt",
    ),
    "the tilt of the start": (
        let_go("0 rad/s", "low: {top.tilt: largest}, up: {top.tilt: theta}", "t: time from start to up"),
        "`top` is at the tilt from which it nods at `up`",
    ),
    "a start that nods": (
        let_go("0 rad/s", DOWN, "t: time from start to low").replace("nutation: 0 rad/s", "nutation: 1 rad/s"),
        "`top` nods at `start`",
    ),
    "a start that is upright": (
        let_go("0 rad/s", DOWN, "t: time from start to low").replace("25 deg", "0 deg"),
        "`top` is upright at `start`",
    ),
    "a precession that is steady": (
        let_go("M*g*l/(I3*w3)", DOWN, "T: top.period at start").replace("25 deg", "90 deg"),
        "`top` precesses steadily from `start` on",
    ),
    "what is not symmetric": (
        let_go("0 rad/s", DOWN, "t: time from start to low").replace("[I1, I1, I3]", "[I1, 1.05*I1, I1]"),
        "how long `top` takes is not solved in space",
    ),
    "a state that no tilt tells": (
        let_go("0 rad/s", "low: {top.nutation: 0 rad/s}", "t: time from start to low"),
        "when `top` comes to `low` nothing tells",
    ),
    "a blow between": (
        let_go("0 rad/s", f"{DOWN}, hit: {{}}", "t: time from start to hit")
        + "events: {tap: {impulse: 1 N s, on: top.tip, direction: [0, 0, -1], from: low, to: hit}}\n",
        "how long it takes from `start` to `hit` is not solved in space",
    ),
    "one that comes ever nearer to the upright": (
        let_go(NEVER[1], "", "T: top.period at start", NEVER[0]),
        "comes ever nearer to the vertical, and never back",
    ),
    "one that passes through it, where numbers are not special": (
        let_go(NEVER[1], "", "T: top.period at start"),
        "the axis of `top` passes through the vertical",
    ),
    "the period of a plane pendulum, which is twice that of its tilt": (
        swung("0 rad/s", "", "T: bob.period at start"),
        "the axis of `bob` passes through the vertical",
    ),
    "how far that goes round": (
        swung("0 rad/s", "end: {bob.tilt: largest}", "d: change of bob.precession_angle from start to end"),
        "how far it goes round has no meaning",
    ),
    "how far one goes round to a tilt between": (
        let_go("0 rad/s", "mid: {top.tilt: 26 deg}", "d: change of top.precession_angle from start to mid"),
        "is solved from end to end of its nutation",
    ),
}


@pytest.mark.parametrize(("first", "then"), [(60, 30), (60, 1), (37, 5), (90, 60), (150, 100)])
@pytest.mark.parametrize("hangs", [False, True])
def test_a_top_that_comes_ever_nearer_to_the_vertical_takes_a_time_up_to_a_tilt(
    first: int, then: int, hangs: bool
) -> None:
    """cosh p t = sin ½θ₀/sin ½θ, p = sin ½θ₀ √(M g l/I₁); upside down the same by cosines."""
    told = f"theta: {180 - first if hangs else first} deg, w3: {'-' if hangs else ''}sqrt(2*M*g*l*I1*(1 END cos(theta)))/I3"
    scene = TOP.replace("theta: 25 deg", told).replace("w3: 300 rad/s, ", "").replace(", w3: 300 rad/s", "")
    rate, state = "sqrt(2*M*g*l/(I1*(1 END cos(theta))))", f"low: {{top.tilt: {180 - then if hangs else then} deg}}"
    scene = let_go(
        rate, state, "t: time from start to low", scene.replace("[0, 0, -l]", "[0, 0, l]") if hangs else scene
    )
    half, sine = (math.sin(math.radians(angle) / 2) for angle in (first, then))
    time = math.acosh(half / sine) / (half * math.sqrt(M * G * LENGTH / I1))
    assert answers(scene.replace("END", "-" if hangs else "+"))["t"] == pytest.approx(time, rel=1e-9)


@pytest.mark.parametrize(
    "states", ["low: {top.tilt: 0 deg}", "low: {top.tilt: smallest}", "a: {top.tilt: 30 deg}, low: {top.tilt: 40 deg}"]
)
def test_it_takes_none_to_the_vertical_or_back(states: str) -> None:
    with pytest.raises(Unsolvable) as caught:
        solve(f"title: T\nup: z\n{let_go(NEVER[1], states, 't: time from start to low', NEVER[0])}")
    assert "comes ever nearer to the vertical, and never back" in str(caught.value)
    assert "`time` to a state with a `tilt` on the way" in str(caught.value)


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_no_nutation_from_end_to_end_is_refused_by_name(name: str) -> None:
    scene, said = REFUSED[name]
    with pytest.raises(Unsolvable) as caught:
        solve(f"title: T\nup: z\n{scene}")
    assert said in str(caught.value)


def test_both_ends_of_a_top_that_nods_at_first_have_scenes_of_their_own() -> None:
    """From its largest tilt, with the precession there, it rises as far as from the start: what the help says leads there."""
    low, high = "low: {top.tilt: largest}", "high: {top.tilt: smallest}"

    def nodding(states: str, find: str) -> str:
        return let_go("5 rad/s", states, find).replace("nutation: 0 rad/s", "nutation: 1 rad/s")

    for find, said in {
        "th: top.tilt at high": "in which `high` follows `start` with no state between",
        "t: time from low to high": "ask for its largest `tilt` and its rates there, and begin with them",
    }.items():
        with pytest.raises(Unsolvable) as caught:
            solve(f"title: T\nup: z\n{nodding(f'{low}, {high}', find)}")
        assert said in str(caught.value)
    lowest = answers(nodding(low, "th: top.tilt at low, W: top.precession at low"))
    highest = answers(nodding(high, "th: top.tilt at high"))
    begun = let_go(f"{lowest['W']} rad/s", high, "th: top.tilt at high, t: time from start to high")
    found = answers(begun.replace("top.tilt: theta", f"top.tilt: {lowest['th']} rad"))
    assert found["th"] == pytest.approx(highest["th"], rel=1e-7)
    assert found["t"] > 0


COMES_BACK = """
title: A top on its way back
up: z
given: {M: 0.3 kg, l: 6 cm, A: 1.5e-3 kg m^2, C: 3e-4 kg m^2, w: 250 rad/s}
bodies: {top: {mass: M, inertia: {about: tip, principal: [A, A, C]}, axis: z, points: {tip: [0, 0, -l]}}}
connections: {floor: {ball: top.tip}}
states:
  start: {top.tilt: 30 deg, top.axial_rate: w, top.precession: FIRST rad/s, top.nutation: 0 rad/s}
  end: {top.tilt: WORD}
  back: {top.tilt: THERE deg}
find: {n: top.nutation at back}
"""


@pytest.mark.parametrize(("first", "word", "there", "way"), [(0.0, "largest", 31.0, -1), (4.0, "smallest", 29.5, 1)])
def test_from_the_end_of_its_nutation_it_comes_back(first: float, word: str, there: float, way: int) -> None:
    """½ A (θ̇² + φ̇² sin² θ) + M g l cos θ and A φ̇ sin² θ + C w cos θ stay; θ̇ < 0 from the largest tilt on, > 0 from the smallest."""
    lift, across, own = 0.3 * 9.8 * 0.06, 1.5e-3, 3e-4 * 250
    u, v = math.radians(30), math.radians(there)
    momentum = across * first * math.sin(u) ** 2 + own * math.cos(u)
    rate = (momentum - own * math.cos(v)) / (across * math.sin(v) ** 2)
    square = first**2 * math.sin(u) ** 2 - rate**2 * math.sin(v) ** 2 + 2 * lift * (math.cos(u) - math.cos(v)) / across
    text = COMES_BACK.replace("FIRST", str(first)).replace("WORD", word).replace("THERE", str(there))
    solution = solve(text)
    assert solution.answers["n"].float == pytest.approx(way * math.sqrt(square))
    assert all(item.holds for item in solution.derivation.confirmed)
