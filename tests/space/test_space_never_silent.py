"""What was once answered silently wrong in space: holes beyond their bodies, two blows in one instant, verges that nothing needs, angles of
what has no direction, and what hangs on one of several values. Each is refused by name, or said to be doubtful.
"""

from __future__ import annotations

import math

import pytest

from rotsolve import SceneError, Unsolvable, solve

HEAD = "title: t\nup: z\ngravity: none\ngiven: {M: 3 kg, a: 0.2 m, R: 0.3 m, L: 0.5 m, J: 2 N s}\n"
BOX = "bodies: {b: {shape: cuboid, mass: M, sides: [a, 2*a, 3*a], holes: {h: {HOLE}}}}\nfind: {I: b.inertia_tensor}\n"
ROUND = (
    "bodies: {b: {shape: cylinder, mass: M, radius: R, length: L, holes: {h: {HOLE}}}}\nfind: {I: b.inertia_tensor}\n"
)
BALL = "bodies: {b: {shape: sphere, mass: M, radius: R, holes: {h: {HOLE}}}}\nfind: {I: b.inertia_tensor}\n"


@pytest.mark.parametrize(
    ("body", "hole"),
    [
        (BOX, "shape: cylinder, radius: a/4, length: 5*a"),
        (BOX, "shape: cylinder, radius: a/4, length: a, at: [0, 0, 1.1*a]"),
        (BOX, "shape: cylinder, radius: a/4, length: a, at: [0.3*a, 0, 0]"),
        (BOX, "shape: cylinder, radius: a/4, length: 2.1*a, turned: {about: x, by: 90 deg}"),
        (BOX, "shape: cylinder, radius: a/4, length: 2*a, turned: {about: x, by: 80 deg}"),
        (BOX, "shape: sphere, radius: a/4, at: [0, 0, 1.3*a]"),
        (ROUND, "shape: cylinder, radius: R/4, length: 2*L"),
        (ROUND, "shape: sphere, radius: R/4, at: [0, 0, 0.4*L]"),
        (BALL, "shape: sphere, radius: R/4, at: [0, 0.5*R, 0.6*R]"),
    ],
)
def test_a_hole_that_sticks_out_is_refused(body: str, hole: str) -> None:
    with pytest.raises((SceneError, Unsolvable), match="the hole `h` sticks out of `b`"):
        solve(HEAD + body.replace("HOLE", hole))


@pytest.mark.parametrize(
    ("body", "hole"),
    [
        (ROUND, "shape: cylinder, radius: R/4, length: R, turned: {about: x, by: 90 deg}"),
        (BALL, "shape: cylinder, radius: R/4, length: R"),
        (
            "bodies: {b: {shape: cone, mass: M, radius: R, length: L, holes: {h: {HOLE}}}}\nfind: {I: b.inertia_tensor}\n",
            "shape: cylinder, radius: R/8, length: L/8",
        ),
    ],
)
def test_a_hole_of_which_nothing_tells_whether_it_fits_is_refused(body: str, hole: str) -> None:
    with pytest.raises(Unsolvable, match="whether the hole `h` lies within `b` is not solved in space"):
        solve(HEAD + body.replace("HOLE", hole))


@pytest.mark.parametrize(
    ("hole", "volume", "second"),
    [  # the volume of the hole, and its second moment ∫ x² dV across its axis or along it
        ("shape: cylinder, radius: a/4, length: 3*a", 3 * math.pi / 16, lambda v: v / 64),
        ("shape: cylinder, radius: a/4", 3 * math.pi / 16, lambda v: v / 64),
        (
            "shape: cylinder, radius: a/4, length: 2*a, turned: {about: x, by: 90 deg}",
            2 * math.pi / 16,
            lambda v: v / 64,
        ),
        ("shape: cylinder, radius: a/4, length: a, turned: {about: y, by: 90 deg}", math.pi / 16, lambda v: v / 12),
        ("shape: sphere, radius: a/4", math.pi / 48, lambda v: v / 80),
    ],
)
def test_a_hole_that_fits_is_cut_out(hole: str, volume: float, second: object) -> None:
    """∫ x² dm of what is left, from I_yy + I_zz − I_xx, in units of a."""
    answer = solve(HEAD + BOX.replace("HOLE", hole))
    tensor = {part.name: (part.value.float if part.value else 0.0) for part in answer.derivation.answers[0].components}
    along = (tensor["yy"] + tensor["zz"] - tensor["xx"]) / 2
    density = 3.0 / (6 - volume)
    assert along == pytest.approx(density * (6 / 12 - second(volume)) * 0.2**2, rel=1e-9)  # type: ignore[operator]
    assert [item.holds for item in answer.derivation.confirmed] == [True]


def test_holes_that_may_cross_are_refused() -> None:
    bore, across = (
        "h: {shape: cylinder, radius: a/8}",
        "k: {shape: cylinder, radius: a/8, length: a, turned: {about: y, by: 90 deg}}",
    )
    with pytest.raises((SceneError, Unsolvable), match="overlap is not solved"):
        solve(HEAD + BOX.replace("h: {HOLE}", f"{bore}, {across}"))


@pytest.mark.parametrize(
    ("second", "apart"),
    [
        ("shape: rectangle, sides: [a/4, a/4], at: [0, 0]", False),
        ("shape: rectangle, sides: [a/4, a/4], at: [-a/8, 0]", True),
        ("shape: rectangle, sides: [a/4, a/4], at: [-a/8, 0], angle: 45 deg", False),
        ("shape: disc, radius: a/8, at: [-a/8, 0]", True),
        ("shape: disc, radius: a/8, at: [-a/16, 0]", False),
        ("shape: disc, radius: a/8, at: [-0.11*a, -0.2*a]", True),
    ],
)
def test_windows_of_a_plate_lie_beside_each_other(second: str, apart: bool) -> None:
    plate = "{shape: rectangle, mass: M, sides: [a, a], holes: {h: {shape: rectangle, sides: [a/4, a/4], at: [a/8, 0]}, k: {HOLE}}}"
    scene = (
        "title: t\ngiven: {M: 3 kg, a: 0.2 m}\nbodies: {b: "
        + plate.replace("HOLE", second)
        + "}\nfind: {I: b.inertia}\n"
    )
    if apart:
        assert [item.holds for item in solve(scene).derivation.confirmed] == [True]
    else:
        with pytest.raises(SceneError, match="overlap"):
            solve(scene)


def test_a_bore_in_the_plane_is_no_longer_than_its_cylinder() -> None:
    scene = HEAD.replace("up: z\n", "") + ROUND.replace("inertia_tensor", "inertia")
    with pytest.raises(SceneError, match="sticks out"):
        solve(scene.replace("HOLE", "shape: cylinder, radius: R/4, length: 2*L"))


def test_two_blows_in_one_instant_are_refused() -> None:
    bodies = "bodies: {b: {shape: cuboid, mass: M, sides: [a, a, a], points: {P: [a/2, 0, 0], Q: [-a/2, 0, 0]}}}\n"
    blows = "one: {impulse: J, on: b.P, direction: z, from: u, to: v}, two: {impulse: J, on: b.Q, direction: -z, from: u, to: v}"
    with pytest.raises(Unsolvable, match="happen between the same states"):
        solve(
            f"{HEAD}{bodies}states: {{u: at rest, v: {{}}}}\nevents: {{{blows}}}\nfind: {{w: b.angular_velocity at v}}\n"
        )


COIN = """title: t
up: z
given: {m: 20 g, R: 2 cm, s: 5 rad/s, W: unknown}
bodies: {coin: {shape: disc, mass: m, radius: R}}
surfaces: {table: level}
connections: {grip: {rolls: [coin, table]}}
states: {now: {coin.tilt: 90 deg, coin.spin: s, coin.precession: W, steady: true}}
"""


@pytest.mark.parametrize("find", ["smallest W where now is stable", "largest W where now is stable"])
def test_a_verge_that_nothing_needs_is_refused(find: str) -> None:
    """Steadiness alone makes W = 0, stable or not."""
    with pytest.raises(Unsolvable):
        solve(f"{COIN}find: {{W: {find}}}\n")


def test_what_is_nothing_is_at_no_angle() -> None:
    still = "states: {now: {b.angular_velocity: [1 rad/s, 0, 0], b.velocity: [0, 0, 0]}}\n"
    scene = f"{HEAD}bodies: {{b: {{shape: cuboid, mass: M, sides: [a, a, a]}}}}\n{still}"
    with pytest.raises(Unsolvable, match="is nothing, so that it is at no angle"):
        solve(f"{scene}find: {{g: angle of b.velocity from b.angular_velocity}}\n")


TOP = """title: t
up: z
given: {M: 0.2 kg, l: 0.05 m, A: 6e-4 kg m^2, C: 8e-5 kg m^2, s: 200 rad/s, w: unknown, t1: 100 deg, t2: 120 deg, W: 2 rad/s}
bodies: {top: {mass: M, inertia: {about: tip, principal: [A, A, C]}, axis: z, points: {tip: [0, 0, -l]}}}
connections: {floor: {ball: top.tip}}
states:
  start: {top.tilt: t1, top.axial_rate: w, top.precession: W, top.nutation: 0 rad/s}
  end: {top.tilt: t2, top.nutation: 0 rad/s}
"""


def test_the_smallest_and_the_largest_of_what_two_turning_points_tell() -> None:
    """A sin² θ φ̇ + C w cos θ stays, and so does the energy: a quadratic equation in w."""
    low, high = (solve(f"{TOP}find: {{w: {word} w}}\n").answers["w"].float or 0.0 for word in ("smallest", "largest"))
    assert low < high
    for w in (low, high):
        first, last = math.radians(100), math.radians(120)
        kept = 6e-4 * math.sin(first) ** 2 * 2 + 8e-5 * w * math.cos(first)
        rate = (kept - 8e-5 * w * math.cos(last)) / (6e-4 * math.sin(last) ** 2)
        energies = [
            0.5 * 6e-4 * math.sin(tilt) ** 2 * turn**2 + 0.2 * 9.8 * 0.05 * math.cos(tilt)
            for tilt, turn in ((first, 2), (last, rate))
        ]
        assert energies[0] == pytest.approx(energies[1], rel=1e-9)


PLATE = """title: t
up: z
gravity: none
given: {m: 2 kg, a: 0.3 m, b: 0.2 m, th: unknown, w: 40 rad/s, T: 2 N m}
bodies: {plate: {shape: rectangle, mass: m, sides: [a, b]}}
connections: {shaft: {hinge: plate.center, along: [cos(th), sin(th), 0], angular_velocity: w}}
states: {now: {shaft.torque.z: T}}
find: {t: th, K: plate.kinetic_energy}
"""


def test_what_hangs_on_one_of_several_values_is_not_confirmed() -> None:
    """m w² (b² − a²) sin θ cos θ/12 = T has two solutions, with two energies."""
    said = {item.name: item for item in solve(PLATE).derivation.confirmed}
    assert said["t"].holds is None and said["K"].holds is None
    assert "several values" in said["K"].why


def test_the_smallest_side_is_none_that_is_nothing() -> None:
    scene = (
        PLATE.replace("th: unknown", "th: deg")
        .replace("b: 0.2 m", "b: unknown")
        .replace("[cos(th), sin(th), 0]", "[a, b, 0]")
    )
    scene = scene[: scene.index("states")] + "find: {b: smallest b where shaft.torque.z = 0}\n"
    assert solve(scene.replace("th: deg, ", "")).answers["b"].float == pytest.approx(0.3)


def test_a_solid_of_revolution_as_a_part_is_refused_by_name() -> None:
    parts = "parts: {c: {shape: solid of revolution, mass: M, profile: {z: [0, L], r: R*z/L}}}"
    with pytest.raises(Unsolvable, match="no usual elements over which to integrate"):
        solve(f"{HEAD}bodies: {{b: {{axis: z, {parts}}}}}\nfind: {{I: b.inertia_tensor}}\n")
