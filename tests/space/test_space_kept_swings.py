"""Small swings on a hinge beside which momenta are conserved: rotors, free turntables and carts, by Routh's function worked out in numbers.

With T = ½ A q̇² + N q̇ ẋ + ½ M ẋ² + b ẋ + c and p = b + M ẋ kept, U = V − c + (p − b)²/2 M and the inertia is A − N²/M.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import pytest

from rotsolve import Unsolvable, solve
from rotsolve.space.carried_swings import CarriedSwing

LATITUDE, W, A, C, S = math.radians(41), 2.0, 0.02, 0.03, 30.0
GYROCOMPASS = """gravity: none
given: {W: 2 rad/s, phi: 41 deg, A: 0.02 kg m^2, C: 0.03 kg m^2, s: 30 rad/s}
bodies:
  earth: {mass: 0, points: {P: [0, 0, 0]}}
  gimbal: {mass: 0}
  disc: {mass: 1 kg, inertia: {principal: [A, A, C]}, axis: z}
connections:
  pole: {hinge: earth.P, along: [0, cos(phi), sin(phi)], angular_velocity: W}
  post: {hinge: [earth.P, gimbal.center], along: z}
  axle: {axle: [gimbal, disc], along: ALONG}
states: {now: {gimbal.angle: ANGLE, LINE, steady: true}}
find: {w: angular_frequency of small swings of gimbal}
"""
CART = """given: {M: 3 kg, m: 2 kg, l: 0.7 m, g: 9.8 m/s^2}
bodies:
  cart: {shape: cuboid, mass: M, sides: [1 m, 0.5 m, 0.2 m]}
  bob: {parts: {p: {shape: particle, mass: m, at: [0, 0, 0]}}, points: {P: [0, 0, l]}}
connections: {rail: {slide: cart.center, along: x}, pin: {hinge: [cart.center, bob.P], along: y}}
states: {now: {bob.angle: 0 deg, LINE steady: true}}
find: {w: angular_frequency of small swings of bob}
"""
TABLE = """given: {J: 0.5 kg m^2, m: 2 kg, l: 0.7 m, d: 0.3 m, W: 4 rad/s, g: 9.8 m/s^2, q: unknown}
bodies: {table: {mass: 1 kg, inertia: {principal: [J, J, J]}, points: {E: [d, 0, 0]}}, rod: {shape: rod, mass: m, length: l}}
connections: {post: {hinge: table.center, along: z}, pin: {hinge: [table.E, rod.start], along: y}}
states: {now: {rod.angle: q, table.angular_velocity: W, steady: true}}
find: {w: angular_frequency of small swings of rod, q: largest q}
"""
WHEEL = """given: {M: 3 kg, R: 0.2 m, m: 2 kg, l: 0.7 m, s: 5 rad/s, g: 9.8 m/s^2}
bodies: {rod: {shape: rod, mass: m, length: l}, wheel: {shape: disc, mass: M, radius: R}}
connections: {post: {hinge: rod.start, along: y}, hub: {axle: [rod.end, wheel], along: ALONG}}
states: {now: {rod.angle: 90 deg, LINE steady: true}}
find: {w: angular_frequency of small swings of rod}
"""
INVERTED = """given: {J: 4 g m^2, C: 6 g m^2, M: 1 kg, h: 0.1 m, W: 3 rad/s, s: unknown, g: 9.8 m/s^2}
bodies:
  table: {mass: 0}
  frame: {mass: 0, points: {O: [0, 0, 0], G: [0, 0, h]}}
  disc: {mass: M, inertia: {principal: [J, J, C]}, axis: z}
connections:
  post: {hinge: table, along: z, angular_velocity: W}
  pin: {hinge: [table, frame.O], along: x}
  axle: {axle: [frame.G, disc], along: z}
states: {now: {frame.angle: 0 deg, disc.spin: s, steady: true}}
find: {s: smallest s where now is stable}
"""
SPUN, DRIVEN = "disc.spin: s", ", angular_velocity: s"
COUNTERWEIGHT = """given: {M: 1.5 kg, R: 8 cm, l: 12 cm, m: 0.6 kg, c: 15 cm, s: 250 rad/s, g: 9.8 m/s^2}
bodies:
  frame: {parts: {w: {mass: m, at: [0, 0, -c]}}, axis: z, points: {O: [0, 0, 0], P: [0, 0, l]}}
  rotor: {shape: disc, mass: M, radius: R}
connections: {pivot: {ball: frame.O}, axle: {axle: [frame.P, rotor], along: z, angular_velocity: s}}
states: {now: {frame.tilt: 60 deg, frame.spin: 5 rad/s, frame.precession: smallest, steady: true}}
find: {w: angular_frequency of small swings of frame}
"""
GIMBALS = """given: {A: 0.02 kg m^2, C: 0.03 kg m^2, M: 2 kg, h: 0.05 m, s: 100 rad/s, g: 9.8 m/s^2, W: unknown}
bodies: {outer: {mass: 0}, inner: {mass: 0, points: {Q: [0, h, 0]}}, disc: {mass: M, inertia: {principal: [A, A, C]}, axis: z}}
connections: {post: {hinge: outer, along: z}, pin: {hinge: [outer, inner.center], along: x}, axle: {axle: [inner.Q, disc], along: y}}
states: {now: {inner.angle: 30 deg, disc.spin: s, outer.angular_velocity: W, steady: true}}
find: {w: angular_frequency of small swings of inner, W: largest W}
"""
PULL = 9.8 * 0.7 * (2 / 2 + 3)  # of the rod with a wheel at its end
ROD, OUT = 2 * 0.7**2 / 3, 3 * 0.7**2


def nods_by_hand(across: float, axial: float, lift: float, spin: float, sign: int) -> float:
    """(I₃ ω₃/I₁ − 2 φ̇ cos θ)² + φ̇² sin² θ of a top at 60°, ω₃ = ψ̇ + φ̇ cos θ."""
    cos, sin = 0.5, math.sqrt(0.75)
    rate = (axial * spin + sign * math.sqrt((axial * spin) ** 2 - 4 * (across - axial) * cos * lift)) / (
        2 * (across - axial) * cos
    )
    return math.hypot(axial * (spin + rate * cos) / across - 2 * rate * cos, rate * sin)


def weighted_by_hand(sign: int) -> float:
    axial = 1.5 * 0.08**2 / 2
    return nods_by_hand(axial / 2 + 1.5 * 0.12**2 + 0.6 * 0.15**2, axial, 0.09 * 9.8, 255, sign)


def heavy_by_hand() -> float:
    """The same with I₃ ω₃ = I (ψ̇ + φ̇ cos θ) + C (s + ψ̇ + φ̇ cos θ) of frame and rotor, both of which keep their part."""
    wheel, frame, cos = 1.5 * 0.08**2 / 2, 0.002, 0.5
    across, lift = wheel / 2 + 1.5 * 0.12**2 + 0.006 + 0.6 * 0.15**2, 0.09 * 9.8
    fast, square = wheel * 250 + (wheel + frame) * 5, (across - wheel - frame) * cos
    rate = (fast - math.sqrt(fast**2 - 4 * square * lift)) / (2 * square)
    axial = fast + (wheel + frame) * rate * cos
    return math.hypot(axial / across - 2 * rate * cos, rate * math.sin(math.pi / 3))


def compass(along: str = "y", angle: str = "0 deg", line: str = SPUN, drive: str = "") -> str:
    scene = GYROCOMPASS.replace("ALONG", along + drive).replace("ANGLE", angle)
    return scene.replace("LINE, ", f"{line}, " if line else "")


def curvature(function: Callable[[float], float], at: float) -> float:
    h = 1e-3
    near, far = (function(at + k * h) + function(at - k * h) - 2 * function(at) for k in (1, 2))
    return (16 * near - far) / (12 * h * h)


def compass_by_hand(rise: float, *, driven: bool, at: float = 0.0, spin: float = S) -> float:
    """The axle at `rise` over the level: C (s + n · e)² and A for what is left of the earth's rate and q̇, across the axle."""
    level, upright = math.cos(rise), math.sin(rise)

    def along(q: float) -> float:
        return W * (math.cos(q) * math.cos(LATITUDE) * level + math.sin(LATITUDE) * upright)

    def across(q: float) -> float:
        return A * (W * W - along(q) ** 2) / 2

    kept = C * (spin + along(at))
    inertia = A * level**2 + (C * upright**2 if driven else 0.0)
    if driven:
        return math.sqrt(-curvature(lambda q: across(q) + C * (spin + along(q)) ** 2 / 2, at) / inertia)
    return math.sqrt(
        curvature(lambda q: (kept - C * along(q)) ** 2 / (2 * C) - C * along(q) ** 2 / 2 - across(q), at) / inertia
    )


def table_by_hand() -> float:
    def mass(q: float) -> float:
        return 0.5 + 2 * (0.09 + 0.21 * math.cos(q) + 0.49 * math.cos(q) ** 2 / 3)

    low, high = 0.0, math.pi / 2
    for _ in range(60):
        q = (low + high) / 2
        slope = (mass(q + 1e-5) - mass(q - 1e-5)) / 2e-5
        low, high = (q, high) if 6.86 * math.cos(q) + 8 * slope > 0 else (low, q)
    kept = 4 * mass(q)
    return math.sqrt(curvature(lambda a: -6.86 * math.sin(a) + kept**2 / (2 * mass(a)), q) / ROD)


CASES = {  # a scene, and what is known of it by hand
    "a level axle, free": (compass(), compass_by_hand(0.0, driven=False)),
    "a level axle, driven: the same about the meridian": (
        compass(line="", drive=DRIVEN),
        compass_by_hand(0.0, driven=True),
    ),
    "a rising axle, free": (compass("[0, 4/5, 3/5]"), compass_by_hand(math.asin(0.6), driven=False)),
    "a rising axle, driven": (
        compass("[0, 4/5, 3/5]", line="", drive=DRIVEN),
        compass_by_hand(math.asin(0.6), driven=True),
    ),
    "one that spins the other way about the south": (
        compass(angle="180 deg", line="disc.spin: -s"),
        compass_by_hand(0.0, driven=False, at=math.pi, spin=-S),
    ),
    "an earth that is led round": (
        "gravity: none\ngiven: {W: 2 rad/s, A: 0.02 kg m^2, C: 0.03 kg m^2, s: 30 rad/s}\n"
        "bodies: {earth: {mass: 0, angular_velocity: [0, 0, W]}, gimbal: {mass: 0}, "
        "disc: {mass: 1 kg, inertia: {principal: [A, A, C]}, axis: z}}\n"
        "connections: {post: {hinge: [earth, gimbal], along: x}, axle: {axle: [gimbal, disc], along: z}}\n"
        "states: {now: {gimbal.angle: 0 deg, disc.spin: s, steady: true}}\n"
        "find: {w: angular_frequency of small swings of gimbal}\n",
        math.sqrt(W * (C * S + (C - A) * W) / A),
    ),
    "a pendulum on a cart that stands": (
        CART.replace("LINE", "cart.velocity: [0 m/s, 0, 0],"),
        math.sqrt(9.8 * 5 / (3 * 0.7)),
    ),
    "on one that goes": (CART.replace("LINE", "cart.velocity: [2 m/s, 0, 0],"), math.sqrt(9.8 * 5 / (3 * 0.7))),
    "a rod on a free turntable": (TABLE, table_by_hand()),
    "a wheel on its axle at the end of a rod does not turn with that": (
        WHEEL.replace("ALONG", "y").replace("LINE", "wheel.spin: s,"),
        math.sqrt(PULL / (ROD + OUT)),
    ),
    "a driven one does": (
        WHEEL.replace("ALONG", "y" + DRIVEN).replace("LINE", ""),
        math.sqrt(PULL / (ROD + OUT + 3 * 0.04 / 2)),
    ),
    "one that stands across does": (
        WHEEL.replace("ALONG", "x").replace("LINE", "wheel.spin: s,"),
        math.sqrt(PULL / (ROD + OUT + 3 * 0.04 / 4)),
    ),
    "one askew partly": (
        WHEEL.replace("ALONG", "[3/5, 4/5, 0]").replace("LINE", "wheel.spin: s,"),
        math.sqrt(PULL / (ROD + OUT + 3 * 0.04 / 4 * 0.36)),
    ),
    "a gyroscope that leans in its gimbals": (GIMBALS, nods_by_hand(A + 2 * 0.05**2, C, 0.98, 100, -1)),
    "one that precesses fast": (
        GIMBALS.replace("largest W", "smallest W"),
        nods_by_hand(A + 2 * 0.05**2, C, 0.98, 100, 1),
    ),
    "a frame with a rotor and a counterweight nods": (COUNTERWEIGHT, weighted_by_hand(-1)),
    "one whose rotor is free, on a frame without inertia about its axis": (
        COUNTERWEIGHT.replace(", angular_velocity: s}", "}").replace("frame.tilt", "rotor.spin: s, frame.tilt"),
        weighted_by_hand(-1),
    ),
    "one whose rotor is free, and the frame heavy": (
        COUNTERWEIGHT.replace(", angular_velocity: s}", "}")
        .replace("frame.tilt", "rotor.spin: s, frame.tilt")
        .replace(
            "{parts: {w: {mass: m, at: [0, 0, -c]}}", "{mass: m, inertia: {principal: [6 g m^2, 6 g m^2, 2 g m^2]}"
        )
        .replace("O: [0, 0, 0], P: [0, 0, l]", "O: [0, 0, c], P: [0, 0, c + l]"),
        heavy_by_hand(),
    ),
    "one that goes round fast": (COUNTERWEIGHT.replace("smallest", "largest"), weighted_by_hand(1)),
    "the spin that holds an inverted rotor up": (INVERTED, (0.98 + 9 * (0.004 + 0.01)) / (0.006 * 3) - 3),
}
REFUSED = {  # a scene, and what is said of it
    "the axle about the south": (compass(angle="180 deg"), "the motion is unstable"),
    "an axle off the meridian": (compass(angle="30 deg"), "`gimbal` is not in equilibrium at `now`"),
    "a gimbal that turns": (compass(line=f"{SPUN}, gimbal.angular_velocity: 1 rad/s"), "is not in equilibrium"),
    "a spin that nothing tells": (compass().replace(f"{SPUN}, ", ""), "too little is known to find `w`"),
    "a couple on the rotor": (
        compass().replace("states:", "actions: {push: {couple: [0, 1 N m, 0], on: disc}}\nstates:"),
        "more than its weight and its hinge acts on it: `push`",
    ),
    "swings of the rotor itself": (
        compass().replace("swings of gimbal", "swings of disc"),
        "`gimbal` moves freely too",
    ),
    "a gyroscope whose axle is in line with its outer gimbal": (
        GIMBALS.replace("30 deg", "90 deg")
        .replace("velocity: W", "velocity: 0 rad/s")
        .replace(", W: unknown", "")
        .replace(", W: largest W", ""),
        "two ways in which what moves with `inner` turns are one there",
    ),
    "one that may go round in two ways": (
        GIMBALS.replace(", outer.angular_velocity: W", "").replace(", W: unknown", "").replace(", W: largest W", ""),
        "in which sense `outer` turns at `now` nothing tells",
    ),
    "a frame that stands upright": (
        COUNTERWEIGHT.replace("60 deg", "0 deg").replace("smallest", "0 rad/s"),
        "two ways in which what moves with `frame` turns are one there",
    ),
    "a cart on a slope": (
        CART.replace("LINE", "").replace("along: x", "along: [4/5, 0, -3/5]"),
        "`rail` moves freely too",
    ),
    "a second pendulum on the first": (
        WHEEL.replace("hub: {axle: [rod.end, wheel], along: ALONG}", "hub: {hinge: [rod.end, wheel.Q], along: y}")
        .replace("radius: R}", "radius: R, points: {Q: [R, 0, 0]}}")
        .replace("LINE", ""),
        "`wheel` moves freely too",
    ),
    "a ball that rolls on it": (
        WHEEL.replace("hub: {axle: [rod.end, wheel], along: ALONG}", "grip: {rolls: [wheel, rod]}")
        .replace("shape: disc", "shape: sphere")
        .replace("LINE", ""),
        "acts on it: `grip`",
    ),
    "a sleeve on it": (
        INVERTED.replace("axle: {axle: [frame.G", "axle: {sleeve: [frame.G")
        .replace("disc.spin: s, ", "disc.angular_velocity: 40 rad/s, ")
        .replace("s: unknown, ", "")
        .replace("s: smallest s where now is stable", "x: frame.stability"),
        "`axle` moves freely too",
    ),
}


@pytest.mark.parametrize("name", CASES)
def test_the_swings_are_those_by_hand_and_by_the_assembly(name: str) -> None:
    scene, known = CASES[name]
    derivation = solve(f"title: T\nup: z\n{scene}").complete().derivation
    assert [item.holds for item in derivation.confirmed] == [True] * len(derivation.confirmed)
    value = derivation.answers[0].value
    assert value is not None
    assert value.float == pytest.approx(known, rel=1e-7)


@pytest.mark.parametrize("name", REFUSED)
def test_what_has_no_such_swings_is_refused_by_name(name: str) -> None:
    scene, said = REFUSED[name]
    with pytest.raises(Unsolvable) as caught:
        solve(f"title: T\nup: z\n{scene}")
    assert said in str(caught.value)


def test_in_letters_with_the_effective_potential() -> None:
    letters = "{W: rad/s, phi: rad, A: kg m^2, C: kg m^2, s: rad/s}"
    given = "{W: 2 rad/s, phi: 41 deg, A: 0.02 kg m^2, C: 0.03 kg m^2, s: 30 rad/s}"
    page = str(solve(f"title: T\nup: z\n{compass().replace(given, letters)}"))
    assert "√(W (C s − A W cos φ + C W cos φ) cos φ/A)" in page
    assert "p = ∂T/∂ẋ of the angle of disc about axle conserved" in page


def test_the_assembly_contradicts_swings_with_the_rate_kept_in_place_of_the_momentum(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(CarriedSwing, "beside_kept", lambda swing, rows: swing.motion.tidy(rows[-1][-1]))
    with pytest.raises(Unsolvable, match="contradict"):
        solve(f"title: T\nup: z\n{CASES['a rising axle, free'][0]}").complete()
