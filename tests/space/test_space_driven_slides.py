"""What slides or swings on a body that is driven steadily: the energy in its frame, against what its equation along its way comes to."""

from __future__ import annotations

from math import cos, radians, sin, sqrt

import pytest

import rotsolve
from rotsolve.core.faults import NeverReached, Unsolvable

SLIDE = """title: x
up: z
given: {m: 500 g, M: 1 kg, w: 2 rad/s, u: 1 m/s, a: 20 cm, r: 50 cm, L: 2 m, T: 1 s}
bodies:
  rod: {shape: rod, mass: M, length: L, points: {P: [a - L/2, 0, 0]}}
  sleeve: {shape: particle, mass: m}
connections:
  axis: {hinge: rod.start, along: z, angular_velocity: w}
  guide: {slide: [rod.P, sleeve], along: x}
states:
  start: {sleeve.velocity relative to rod: [u, 0, 0]}
  out: {sleeve.position relative to rod: [r, 0 m, 0 m]}
find: {v: sleeve.velocity.x relative to rod in rod axes at out}
"""
ASKED = "v: sleeve.velocity.x relative to rod in rod axes at out"
ARM = """title: x
up: z
given: {m: 500 g, M: 1 kg, w: 3 rad/s, n: 9 rad/s, l: 60 cm, R: 40 cm}
bodies:
  disc: {shape: disc, mass: M, radius: R, points: {P: [R, 0, 0]}}
  rod: {shape: rod, mass: m, length: l}
connections:
  shaft: {hinge: disc.center, along: z, angular_velocity: w}
  pin: {hinge: [disc.P, rod.start], along: z}
states: {start: {rod.angle: 0 deg, rod.angular_velocity: n}, later: {rod.angle: 70 deg}}
find: {v: rod.angular_velocity.z in body axes at later}
"""
M, W, U, A, R = 0.5, 2.0, 1.0, 0.2, 0.5
SAME = "confirmed with numbers"


@pytest.mark.parametrize(
    ("asked", "value"),
    [
        (ASKED, sqrt(U**2 + W**2 * (R**2 - A**2))),
        ("v: sleeve.speed at out", sqrt(U**2 + W**2 * (2 * R**2 - A**2))),
        ("v: size of sleeve.force.coriolis at out", 2 * M * W * sqrt(U**2 + W**2 * (R**2 - A**2))),
        ("v: guide.force.y in rod axes at out", 2 * M * W * sqrt(U**2 + W**2 * (R**2 - A**2))),
    ],
)
def test_a_sleeve_on_a_turning_rod_under_its_weight(asked: str, value: float) -> None:
    """r̈ = ω² r, whatever weighs on a level rod."""
    solution = rotsolve.solve(SLIDE.replace(ASKED, asked))
    assert solution.answers["v"].float == pytest.approx(value, rel=1e-12)
    assert SAME in " ".join(str(solution).split())


@pytest.mark.parametrize(("start", "end", "sense"), [("u", "a/2", 0), ("-u", "a/2", -1), ("-u/10", "r", 1)])
def test_it_comes_to_a_place_the_first_time_from_the_side_on_which_it_is(start: str, end: str, sense: int) -> None:
    """Outwards it never comes to what is further in; inwards it is slowed, and comes out again where it is too slow."""
    text = SLIDE.replace("[u, 0, 0]", f"[{start}, 0, 0]").replace("[r, 0 m", f"[{end}, 0 m")
    speed, place = (U if start != "-u/10" else U / 10), (R if end == "r" else A / 2)
    square = speed**2 + W**2 * (place**2 - A**2)
    if not sense:
        with pytest.raises(NeverReached, match="`out` is never reached from `start`"):
            rotsolve.solve(text)
        return
    solution = rotsolve.solve(text)
    assert solution.answers["v"].float == pytest.approx(sense * sqrt(square), rel=1e-12)
    assert SAME in " ".join(str(solution).split())


def test_a_rod_hinged_on_the_rim_of_a_turntable() -> None:
    """θ̈ = −(3 R ω²/2 l) sin θ against the table."""
    solution = rotsolve.solve(ARM)
    square = 9.0**2 - 3 * 0.4 * 3.0**2 / 0.6 * (1 - cos(radians(70)))
    assert solution.answers["v"].float == pytest.approx(3.0 + sqrt(square), rel=1e-12)
    assert SAME in " ".join(str(solution).split())


def test_a_rod_on_a_turning_shaft_falls_under_its_weight() -> None:
    """½ I θ̇² = ½ m g l (sin θ − sin θ₀) − ½ I ω² (cos² θ₀ − cos² θ), θ down from the level."""
    text = ARM.replace("[disc.P, rod.start], along: z", "[disc.center, rod.start], along: y").replace(
        "90 deg", "30 deg"
    )
    text = text.replace("rod.angle: 0 deg, rod.angular_velocity: n", "rod.angle: 30 deg, rod.angular_velocity: 0 rad/s")
    solution = rotsolve.solve(text.replace("angular_velocity.z in body", "angular_velocity.y in body"))
    one, two = radians(30), radians(70)
    square = 3 * 9.8 / 0.6 * (sin(two) - sin(one)) - 3.0**2 * (cos(one) ** 2 - cos(two) ** 2)
    assert solution.answers["v"].float == pytest.approx(sqrt(square), rel=1e-12)


@pytest.mark.parametrize("law", ["energy", "lagrange"])
def test_by_a_law_that_is_named(law: str) -> None:
    assert rotsolve.solve(SLIDE, law=law).answers["v"].float == pytest.approx(sqrt(U**2 + W**2 * (R**2 - A**2)))


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("along: z, ang", "along: y, ang", "`v` is not solved by these laws"),  # its weight is no constant there
        ("angular_velocity: w}", "angular_velocity: w*(1 + time/T)}", "what drives it changes on the way"),
        ("angular_velocity: w}", "angular_velocity: w, angular_acceleration: w/T}", "`v` is not solved by these laws"),
        ("[r, 0 m, 0 m]", "[r, r, 0 m]", "can only be on `guide`"),
        ("position relative to rod: [r", "position: [r", "can only be on `guide`"),
        ("[r, 0 m, 0 m]", "[a, 0 m, 0 m]", "in which sense `sleeve` goes at `out` nothing tells"),
        ("start: {", "start: {sleeve.position relative to rod: [r, 0 m, 0 m], ", "is told by `guide`, not by a state"),
        (" in rod axes at out", " at out", "hangs on how `rod` stands at `out`, which nothing tells"),
        ("{slide: [rod.P, sleeve], along: x}", "{screw: [rod.P, sleeve], along: x, pitch: a}", "nothing tells"),
        ("out: {sleeve.position relative to rod: [r, 0 m, 0 m]}", "out: {time: T}", "where `sleeve` is on `guide`"),
    ],
)
def test_what_is_not_kept_or_not_told_is_refused(old: str, new: str, words: str) -> None:
    with pytest.raises(Unsolvable, match=words):
        rotsolve.solve(SLIDE.replace(old, new))


LIFT = """title: x
up: z
given: {M: 0.5 kg, l: 6 cm, I1: 2.5e-3 kg m^2, I3: 6e-4 kg m^2, s: 150 rad/s}
bodies:
  lift: {mass: 2 kg, points: {O: [0, 0, 0]}}
  top: {mass: M, inertia: {about: tip, principal: [I1, I1, I3]}, axis: z, points: {tip: [0, 0, -l]}}
connections: {rail: {slide: lift.O, along: WAY}, stand: {ball: [lift.O, top.tip]}}
actions: {p: {force: any, on: lift}}
states: {now: {lift.velocity: [0, 0, 0], lift.acceleration: FASTER, top.tilt: 50 deg, top.axial_rate: s, steady: true}}
find: {p1: smallest top.precession at now}
"""


@pytest.mark.parametrize("faster", [-4.0, 0.0, 4.0])
def test_a_top_precesses_steadily_in_a_lift_that_goes_faster(faster: float) -> None:
    """M (g + a) l = φ̇ (I₃ ω₃ − I₁ φ̇ cos θ), confirmed: what slides may go faster while all on it turns steadily."""
    scene = LIFT.replace("WAY", "z").replace("FASTER", f"[0, 0, {faster} m/s^2]")
    found = rotsolve.solve(scene)
    half, torque = 2.5e-3 * cos(radians(50)), 0.5 * 0.06 * (9.8 + faster)
    slow = (6e-4 * 150 - sqrt((6e-4 * 150) ** 2 - 4 * half * torque)) / (2 * half)
    assert found.answers["p1"].float == pytest.approx(slow)
    assert all(item.holds for item in found.derivation.confirmed)


def test_on_a_cart_that_goes_faster_sideways_it_does_not() -> None:
    scene = LIFT.replace("WAY", "x").replace("FASTER", "[4 m/s^2, 0, 0]")
    with pytest.raises(Unsolvable, match="precesses steadily at `now` only as"):
        rotsolve.solve(scene)
