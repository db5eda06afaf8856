"""Small swings in space: of tops about steady motions, of spherical pendulums, on hinges; by hand, by steps in time, by the assembly."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

from rotsolve import Unsolvable, solve

M, LENGTH, I1, I3, G = 0.15, 0.04, 5e-4, 6e-5, 9.8
LIFT = M * G * LENGTH
GIVEN = "{M: 0.15 kg, l: 4 cm, I1: 5e-4 kg m^2, I3: 6e-5 kg m^2, g: 9.8 m/s^2}"
TOP = f"""given: {GIVEN}
bodies: {{top: {{mass: M, inertia: {{about: tip, principal: [I1, I1, I3]}}, axis: z, points: {{tip: [0, 0, -l]}}}}}}
connections: {{floor: {{ball: top.tip}}}}
"""
LETTERS = TOP.replace(GIVEN, "{M: kg, l: m, I1: kg m^2, I3: kg m^2, w3: rad/s, W: rad/s, theta: rad}")
STEADY = "states: {{now: {{{}, steady: true}}}}\n"
FIND = "find: {w: angular_frequency of small swings}\n"
BOB = """given: {m: 2 kg, L: 1 m, h: 150 deg, g: 9.8 m/s^2}
bodies: {bob: {parts: {b: {shape: particle, mass: m, at: [0, 0, 0]}}, points: {P: [0, 0, -L]}}}
connections: {pivot: {ball: bob.P}}
"""
GATE = """given: {m: 2 kg, b: 1 m, a: 0.4 m, c: 0.1 m, g: 9.8 m/s^2}
bodies: {gate: {shape: cuboid, mass: m, sides: [b, a, c], points: {A: [-b/2, 0, 0]}}}
connections: {post: {hinge: gate.A, along: ALONG}}
"""
ON_HINGE = 9.8 * 0.5 / ((1 + 0.01) / 12 + 0.25)  # g d/(k² + d²)


def top_at(lines: str, find: str = FIND) -> str:
    return TOP + STEADY.format(lines) + find


def on_hinge(along: str, state: str = "") -> str:
    return GATE.replace("ALONG", along) + (f"states: {{now: {{{state}, steady: true}}}}\n" if state else "") + FIND


def precession(spin: float, tilt: float, sign: int) -> float:
    """A root of I₁ cos θ Ω² − I₃ ω₃ Ω + M g l = 0."""
    momentum, cosine = I3 * spin, math.cos(tilt)
    return (momentum + sign * math.sqrt(momentum**2 - 4 * I1 * LIFT * cosine)) / (2 * I1 * cosine)


def nutation(spin: float, tilt: float, sign: int) -> float:
    """By the other form, Ω² + (M g l/I₁ Ω)² − 2 (M g l/I₁) cos θ, which is the same for a precession that is steady."""
    rate = precession(spin, tilt, sign)
    return math.sqrt(rate**2 + (LIFT / (I1 * rate)) ** 2 - 2 * LIFT / I1 * math.cos(tilt))


LEANS = math.radians(25)
CASES = {  # a scene, and what is known of it by hand
    "a top that precesses slowly": (
        top_at("top.tilt: 25 deg, top.axial_rate: 300 rad/s, top.precession: smallest"),
        nutation(300, LEANS, -1),
    ),
    "one that precesses fast": (
        top_at("top.tilt: 25 deg, top.axial_rate: 300 rad/s, top.precession: largest"),
        nutation(300, LEANS, 1),
    ),
    "a level one": (
        top_at("top.tilt: 90 deg, top.spin: 300 rad/s"),
        math.hypot(I3 * 300 / I1, LIFT / (I3 * 300)),
    ),
    "one without weight": (
        "gravity: none\n"
        + top_at("top.tilt: 25 deg, top.axial_rate: 300 rad/s, top.precession: largest").replace(", g: 9.8 m/s^2", ""),
        I3 * 300 / (I1 * math.cos(LEANS)),
    ),
    "a sleeping top": (
        top_at("top.tilt: 0 deg, top.axial_rate: 300 rad/s"),
        math.sqrt((I3 * 300 / (2 * I1)) ** 2 - LIFT / I1),
    ),
    "one that hangs and spins": (
        top_at("top.tilt: 180 deg, top.axial_rate: 100 rad/s"),
        math.sqrt((I3 * 100 / (2 * I1)) ** 2 + LIFT / I1),
    ),
    "one that hangs at rest": (
        TOP + "states: {now: {top.tilt: 180 deg, at rest: all}}\n" + FIND,
        math.sqrt(LIFT / I1),
    ),
    "a spherical pendulum about its circle": (
        BOB + STEADY.format("bob.tilt: h, bob.precession: largest") + FIND,
        math.sqrt(9.8 / math.cos(math.radians(30)) * (1 + 3 * 0.75)),
    ),
    "a rod about its cone": (
        "given: {m: 2 kg, L: 1 m, g: 9.8 m/s^2}\nbodies: {rod: {shape: rod, mass: m, length: L}}\nconnections: {pivot: {ball: rod.start}}\n"
        + STEADY.format("rod.tilt: 150 deg, rod.precession: largest")
        + FIND,
        math.sqrt(1.5 * 9.8 / math.cos(math.radians(30)) * (1 + 3 * 0.75)),
    ),
    "a gate on a level axis": (on_hinge("y"), math.sqrt(ON_HINGE)),
    "one on an axis that leans": (
        on_hinge("[0, 4, 3]"),
        math.sqrt(0.8 * 9.8 * 0.5 / ((1 + 0.64 * 0.01 + 0.36 * 0.16) / 12 + 0.25)),
    ),
    "one that stands told as it hangs": (on_hinge("y", "gate.angle: 90 deg"), math.sqrt(ON_HINGE)),
    "a coin that rolls": (
        "given: {m: 10 g, R: 1 cm, v: 1 m/s, g: 9.8 m/s^2}\nbodies: {coin: {shape: disc, mass: m, radius: R}}\nsurfaces: {table: level}\n"
        "connections: {grip: {rolls: [coin, table]}}\n"
        + STEADY.format("coin.tilt: 90 deg, coin.spin: v/R, coin.precession: 0 rad/s")
        + FIND,
        math.sqrt((12 * 100**2 - 4 * 9.8 / 0.01) / 5),
    ),
}
CLOSED = {  # letters, and the formula
    "a top by its precession": (
        LETTERS + STEADY.format("top.tilt: theta, top.precession: W") + FIND,
        "√(M² g² l² + I₁² W⁴ − 2 M I₁ g l W² cos θ)/(I₁ W)",
    ),
    "a sleeping top, where it is stable": (
        LETTERS + STEADY.format("top.tilt: 0 deg, top.axial_rate: w3") + FIND,
        "√(I₃² w₃² − 4 M I₁ g l)/(2 I₁)",
    ),
    "its stability": (
        LETTERS + STEADY.format("top.tilt: 0 deg, top.axial_rate: w3") + "find: {s: top.stability}\n",
        "(4 M I₁ g l − I₃² w₃²)/(4 I₁²)",
    ),
}
REFUSED = {  # a scene, and what is said of it
    "a sleeping top that is too slow": (
        top_at("top.tilt: 0 deg, top.axial_rate: 100 rad/s"),
        "`top` has no small swings about `now`: the motion is unstable",
        "at least 180.7 rad/s",
    ),
    "a precession that is none": (
        top_at("top.tilt: 25 deg, top.axial_rate: 100 rad/s"),
        "`top` spins too slowly for a steady precession at `now`",
        "at least 172.1 rad/s",
    ),
    "rates that are not steady": (
        top_at("top.tilt: 25 deg, top.axial_rate: 300 rad/s, top.precession: 1 rad/s"),
        "contradict",
        "",
    ),
    "a spin that is no other rotation than the precession": (
        top_at("top.tilt: 180 deg, top.spin: 100 rad/s"),
        "its spin and its precession are one rotation there",
        "tell its `top.axial_rate`",
    ),
    "a motion that is not steady": (
        TOP + "states: {now: {top.tilt: 25 deg, top.axial_rate: 300 rad/s, top.precession: 0 rad/s}}\n"
        "find: {w: angular_frequency of small swings about now}\n",
        "`now` is not said to be a steady motion",
        "add `steady: true`",
    ),
    "no motion": (TOP + FIND, "about which steady motion `top` swings nothing tells", "tell a state with `top.tilt`"),
    "swings of any size": (
        TOP + "states: {now: {top.tilt: 25 deg, top.axial_rate: 300 rad/s, top.precession: 0 rad/s}}\n"
        "find: {T: period of swings from now}\n",
        "swings of `top` of any size are not solved in space",
        "`rotsolve simulate`",
    ),
    "an asymmetric body": (
        TOP.replace("[I1, I1, I3]", "[I1, 2*I1, 2*I1]") + "states: {now: {top.tilt: 180 deg, at rest: all}}\n" + FIND,
        "what a small disturbance does to `top` at `now` is not solved in space",
        "solved are a symmetric top",
    ),
    "a hinge with a push": (
        on_hinge("y").replace("find:", "actions: {push: {couple: [0, 1 N m, 0], on: gate}}\nfind:"),
        "more than its weight and its hinge acts on it",
        "",
    ),
    "a wheel": (
        "given: {m: 2 kg, R: 1 m}\nbodies: {wheel: {shape: disc, mass: m, radius: R}}\nconnections: {hub: {axle: wheel, along: x}}\n"
        + FIND,
        "nothing drives `wheel` back",
        "",
    ),
    "an upright hinge": (on_hinge("z"), "nothing drives `gate` back about its equilibrium", ""),
    "a hinge that is not in equilibrium": (
        on_hinge("y", "gate.angle: 0 deg"),
        "`gate` is not in equilibrium at `now`",
        "",
    ),
    "one that stands on end": (on_hinge("y", "gate.angle: -90 deg"), "the motion is unstable", ""),
}


@pytest.mark.parametrize("name", CASES)
def test_small_swings_are_those_by_hand_and_by_the_assembly(name: str) -> None:
    scene, known = CASES[name]
    derivation = solve(f"title: T\nup: z\n{scene}").complete().derivation
    assert derivation.confirmed[0].holds is True, derivation.confirmed[0].why
    value = derivation.answers[0].value
    assert value is not None
    assert value.float == pytest.approx(known, rel=1e-9)


@pytest.mark.parametrize("name", CLOSED)
def test_in_letters(name: str) -> None:
    scene, formula = CLOSED[name]
    solution = solve(f"title: T\nup: z\n{scene}").complete()
    assert formula in str(solution)
    assert [item.holds for item in solution.derivation.confirmed] == [True]


@pytest.mark.parametrize("name", REFUSED)
def test_what_does_not_swing_is_refused_by_name(name: str) -> None:
    scene, said, help = REFUSED[name]
    with pytest.raises(Unsolvable) as caught:
        solve(f"title: T\nup: z\n{scene}")
    assert said in str(caught.value)
    assert help in str(caught.value)


@pytest.mark.parametrize(("spin", "tilt"), [(300.0, LEANS), (200.0, 1.2), (-250.0, 2.2)])
def test_steps_in_time_nod_with_the_period_told(spin: float, tilt: float) -> None:
    """θ̈ = φ̇ sin θ (φ̇ cos θ − I₃ ω₃/I₁) + (M g l/I₁) sin θ by Runge and Kutta, let go 10⁻⁴ rad beside the steady precession."""
    scene = top_at(
        f"top.tilt: {tilt} rad, top.axial_rate: {spin} rad/s, top.precession: smallest",
        "find: {T: period of small swings}\n",
    )
    value = solve(f"title: T\nup: z\n{scene}").derivation.answers[0].value
    assert value is not None
    rates = sorted(precession(spin, tilt, sign) for sign in (-1, 1))
    about_vertical = I1 * rates[0] * math.sin(tilt) ** 2 + I3 * spin * math.cos(tilt)

    def slope(angle: float, rate: float) -> tuple[float, float]:
        turn = (about_vertical - I3 * spin * math.cos(angle)) / (I1 * math.sin(angle) ** 2)
        return rate, math.sin(angle) * (turn * (turn * math.cos(angle) - I3 * spin / I1) + LIFT / I1)

    step, now, passed = value.float / 400, (tilt + 1e-4, 0.0), []
    for number in range(1300):
        a = slope(*now)
        b = slope(now[0] + step / 2 * a[0], now[1] + step / 2 * a[1])
        c = slope(now[0] + step / 2 * b[0], now[1] + step / 2 * b[1])
        d = slope(now[0] + step * c[0], now[1] + step * c[1])
        later = tuple(x + step / 6 * (p + 2 * q + 2 * r + s) for x, p, q, r, s in zip(now, a, b, c, d, strict=True))
        if now[1] < 0.0 <= later[1]:  # a smallest tilt
            passed.append((number + now[1] / (now[1] - later[1])) * step)
        now = (later[0], later[1])
    assert len(passed) >= 3
    for one, two in pairwise(passed):
        assert two - one == pytest.approx(value.float, rel=1e-5)


@pytest.mark.parametrize(
    ("scene", "law"),
    [
        (on_hinge("y"), "newton"),
        (top_at("top.tilt: 20 deg, top.axial_rate: 300 rad/s, top.precession: smallest"), "energy"),
    ],
)
def test_small_swings_are_told_by_the_law_that_is_asked_for_or_refused(scene: str, law: str) -> None:
    """I δφ̈ = −M g … is Newton's law, a nutation goes in the effective potential of the energy; another law is refused by its name."""
    text = f"title: T\nup: z\n{scene}" if "up: z" not in scene else scene
    whole = solve(text).derivation.answers[0].value
    assert whole is not None
    for other in ("newton", "energy", "angular-momentum", "lagrange"):
        if other == law:
            found = solve(text, law=other).derivation.answers[0].value
            assert found is not None and found.float == pytest.approx(whole.float)
        else:
            with pytest.raises(Unsolvable, match=r"alone can not tell|do(es)? not settle anything|can not be found"):
                solve(text, law=other)


LEANING = """title: t
up: z
given: {m: 2 kg, b: 1 m, h: 1.4 m, beta: 60 deg, g: 9.8 m/s^2, q: unknown}
bodies: {gate: {shape: rectangle, mass: m, sides: [b, h], points: {A: [AX, AY, 0]}}}
connections: {post: {hinge: gate.A, along: [0, cos(beta), sin(beta)]}}
states: {rest: {gate.angle: q, HELD}}
find: {q: WORDq, p: angular_frequency of small swings of gate about rest}
"""


@pytest.mark.parametrize(("x", "y"), [(-0.5, 0.0), (-0.2, 0.1), (0.3, 0.2)])
def test_the_swings_about_a_place_of_balance_that_is_sought(x: float, y: float) -> None:
    """M g (n × ẑ) (n × r) sin of what drives it back, over M (n × r)² + k²."""
    text = (
        LEANING.replace("AX", f"{x} m")
        .replace("AY", f"{y} m")
        .replace("HELD", "balance: true")
        .replace("WORD", "smallest ")
    )
    solution = solve(text)
    beta, arm = math.radians(60), (-x, -y)
    across = math.hypot(arm[0], arm[1] * math.sin(beta))
    inertia = (1 + (1.4 * math.sin(beta)) ** 2) / 12 + across**2
    assert float(solution.answers["p"].value) == pytest.approx(
        math.sqrt(9.8 * math.cos(beta) * across / inertia), rel=5e-4
    )
    assert [item.holds for item in solution.derivation.confirmed] == [True, True]


def test_a_free_hinge_that_is_steady_asks_for_balance() -> None:
    text = LEANING.replace("AX", "-b/2").replace("AY", "0").replace("HELD", "steady: true").replace("WORD", "")
    with pytest.raises(Unsolvable) as caught:
        solve(text)
    assert "`balance: true`" in caught.value.fault.help
