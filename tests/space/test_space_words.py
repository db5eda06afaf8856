"""Words, letters and forms of derivations in space: what a textbook prints beside and within the same equations."""

from __future__ import annotations

import pytest

from rotsolve import SceneError, Solution, Unsolvable, solve
from rotsolve.algebra.formula import Call, Formula, Power, Product, Symbol
from rotsolve.core.derivation import LawLine
from rotsolve.page.text import plain_text

HINGED = """
up: z
gravity: none
given: {{M: 2 kg, a: 0.4 m, b: 0.3 m, beta: 30 deg, w: 5 rad/s{more}}}
bodies: {{plate: {{shape: rectangle, mass: M, sides: [a, b]}}{bodies}}}
connections: {{shaft: {{hinge: plate.center, along: [sin(beta), 0, cos(beta)], angular_velocity: w}}}}
find: {{{find}}}
"""
BLOW = """
up: z
gravity: none
given: {m: 2 kg, R: 0.3 m, J: 1 N s}
bodies: {disc: {shape: disc, mass: m, radius: R, points: {P: [R, 0, 0]}}}
states: {before: at rest, after: {}}
events: {hit: {impulse: J, on: disc.P, direction: z, from: before, to: after}}
find: {w: disc.angular_velocity at after, v: disc.velocity at after}
"""
TOP = """
up: z
given: {M: 0.2 kg, l: 5 cm, I1: 6e-4 kg m^2, I3: 8e-5 kg m^2, w3: 400 rad/s, theta: 20 deg, g: 9.81 m/s^2}
bodies: {top: {mass: M, inertia: {about: tip, principal: [I1, I1, I3]}, axis: z, points: {tip: [0, 0, -l]}}}
connections: {foot: {ball: top.tip}}
states: {start: {top.tilt: theta, top.axial_rate: w3, top.precession: 0 rad/s, top.nutation: 0 rad/s}, lowest: {top.tilt: largest}}
find: {W: top.precession at lowest}
"""
TOP_AT_BOTH = TOP.replace("top.precession: 0 rad/s", "top.precession: 2 rad/s")
TURNTABLE = """
up: z
gravity: none
given: {m: 0.5 kg, r: 1.2 m, u: 0.8 m/s, w: 2 rad/s, alpha: 0.5 rad/s^2}
bodies: {table: {shape: disc, mass: 0}, bead: {shape: particle, mass: m}}
connections: {axis: {hinge: table.center, along: z, angular_velocity: w, angular_acceleration: alpha}}
actions: {hold: {force: any, on: bead}}
states:
  now:
    bead.position relative to table: [r, 0, 0]
    bead.velocity relative to table: [u, 0, 0]
    bead.acceleration relative to table: [0, 0, 0]
find: {F: size of bead.force.centrifugal, G: size of bead.force.euler, H: size of bead.force.coriolis}
"""
CUBE = """
up: z
given: {M: 3 kg, a: 0.2 m}
bodies: {cube: {shape: cuboid, mass: M, sides: [a, a, a], points: {O: [-a/2, -a/2, -a/2]}}, ball: {shape: sphere, mass: M, radius: a}}
find: {I: cube.inertia_tensor.xx about cube.O, J: (cube.inertia_tensor.xx about cube.O)^2, K: ball.inertia along x}
"""


def hinged(find: str, more: str = "", bodies: str = "") -> Solution:
    return solve(HINGED.format(find=find, more=more, bodies=bodies))


def laws(solution: Solution) -> list[LawLine]:
    return [line for section in solution.derivation.sections for line in section.laws]


def letters(solution: Solution) -> set[str]:
    """All letters of the laws."""
    sides = [side for line in laws(solution) for side in (line.equation.left, line.equation.right)]
    return {name for side in sides for name in side.symbols()}


def said(solution: Solution) -> list[str]:
    return [plain_text(line) for line in solution.derivation.conventions]


# letters of moments of inertia


def test_moments_about_one_point_tell_their_axis_alone() -> None:
    assert {"I_x", "I_z"} <= letters(hinged("L: plate.angular_momentum, T: shaft.torque"))


def test_two_bodies_with_the_same_moments_are_told_apart() -> None:
    found = letters(
        hinged(
            'L: plate.angular_momentum, J: "other.inertia along [1, 0, 2]"',
            bodies=", other: {shape: rectangle, mass: M, sides: [a, b]}",
        )
    )
    assert {"I_x_plate", "I_z_plate", "I_x_other", "I_z_other"} <= found
    assert not {"I_x", "I_z"} & found


def test_a_letter_of_the_scene_is_not_taken() -> None:
    solution = hinged("L: plate.angular_momentum, E: I_z*w^2/2", more=", I_z: 3 kg m^2")
    assert {"I_x_cm", "I_z_cm"} <= letters(solution)


def test_where_parallel_axes_are_taken_each_moment_tells_its_point() -> None:
    found = letters(solve(CUBE))
    assert "I_x_cm" in found and "I_x" not in found


# words


def test_components_of_a_blow_tell_their_axis_and_nothing_speaks_of_angles_of_the_plane() -> None:
    solution = solve(BLOW)
    labels = [line.law for line in laws(solution)]
    about = "disc about its centre of mass"
    for what, axes in (
        ("impulse = change of momentum, disc", "xyz"),
        (f"angular impulse = change of angular momentum, {about}", "y"),
        (f"no angular impulse, {about}", "xz"),
    ):
        assert [label for label in labels if label.startswith(what)] == [f"{what}, along {axis}" for axis in axes]
    assert said(solution) == []


def test_inertial_forces_have_their_names() -> None:
    labels = [line.law for line in laws(solve(TURNTABLE))]
    for name in ("centrifugal", "Euler", "Coriolis"):
        assert sum(label.startswith(f"{name} force on bead") for label in labels) == 1


def test_it_is_said_how_the_axes_turn_where_the_law_of_rotation_is_written_in_them() -> None:
    told = "axes of plate: turning at Ω = (w sin β, 0, w cos β) in their own components"
    assert told in said(hinged("T: shaft.torque"))
    assert said(hinged("L: plate.angular_momentum")) == []


def test_the_law_of_rotation_says_that_it_tells_the_torque() -> None:
    labels = [line.law for line in laws(hinged("T: shaft.torque"))]
    assert any(label.startswith("τ = Ω × L, plate") for label in labels)


def test_only_what_is_round_has_diameters_and_squares_of_moments_have_no_angle_in_their_unit() -> None:
    solution = solve(CUBE)
    labels = [line.law for line in laws(solution)]
    assert "moment of inertia, cube about any axis through its centre" in labels
    assert any(label == "moment of inertia, solid sphere about a diameter" for label in labels)
    units = {
        answer.name: answer.unit.text if hasattr(answer.unit, "text") else str(answer.unit)
        for answer in solution.derivation.answers
    }
    assert "kg² m⁴" in units["J"] and "rad" not in units["J"]


# forms


@pytest.mark.parametrize("scene", [HINGED.format(find="T: shaft.torque", more="", bodies=""), TOP_AT_BOTH])
def test_functions_stand_behind_the_letters_of_a_product(scene: str) -> None:
    solution = solve(scene)
    rates = [line for line in laws(solution) if "dL/dt" in line.law or line.law.startswith("angular momentum")]
    nodes = [
        node for line in rates for side in (line.equation.left, line.equation.right) for node in side.walk(Product)
    ]
    products = [node for node in nodes if isinstance(node, Product)]
    assert products
    for node in products:
        kinds = [is_function(factor) for factor in node.factors]
        assert kinds == sorted(kinds)
        assert len(set(node.factors)) == len(node.factors)


def is_function(factor: Formula) -> bool:
    return isinstance(factor.base if isinstance(factor, Power) else factor, Call)


def test_the_size_of_a_multiple_of_a_root_is_itself() -> None:
    """½ √(…) of two bearings and of the drive, without bars."""
    scene = HINGED.replace("angular_velocity: w", "bearings: [-a, a], angular_velocity: w")
    torque = next(
        line
        for line in laws(solve(scene.format(find="T: size of shaft.torque", more="", bodies="")))
        if line.equation.left == Symbol("T")
    )
    assert not torque.equation.right.holds("abs")


def test_what_something_exerts_alone_is_asked_of_itself() -> None:
    """The help names the question that works: r × F of the rope, about the foot."""
    scene = """
up: z
given: {M: 12 kg, h: 4 m, T: 260 N}
bodies: {mast: {shape: rod, mass: M, length: h, turned: {about: y, by: -90 deg}}}
connections: {foot: {clamp: mast.start}}
actions: {stay: {force: T, on: mast.end, direction: [3, 0, -4]}}
find: {tau: "WORDS about [0, 0, 0]"}
"""
    with pytest.raises(Unsolvable) as refused:
        solve(scene.replace("WORDS", "mast.torque.stay"))
    assert "`stay.torque`" in str(refused.value)
    assert "confirmed with numbers" in solve(scene.replace("WORDS", "stay.torque")).to()


BODIES = "up: z\nbodies: {bar: {shape: rod, mass: 1 kg, length: 1 m}, bead: {shape: particle, mass: 1 kg}}\n"


@pytest.mark.parametrize(
    ("written", "cure"),
    [
        (
            "connections: {c: {string: [ceiling, bar.start]}}",
            "`actions: {pull: {force: T, on: BODY.P, direction: [x, y, z]}}`",
        ),
        (
            "connections: {c: {spring: [ceiling, bar.start]}}",
            "`actions: {pull: {force: k*x, on: BODY.P, direction: [x, y, z]}}`",
        ),
        ("connections: {c: {torsion: bar}}", "`actions: {wire: {couple: [-K*theta, 0, 0], on: BODY}}`"),
        ("connections: {c: {rides: [bead, bar]}}", "`slide: [BAR.P, BEAD], along: x`"),
        ("connections: {c: {shaft: bar.start}}", "`hinge: shaft.O, along: z, angular_velocity: w`"),
        ("actions: {a: {press: 3 N, on: bar}}", "`actions: {brake: {couple: -mu*F*R, on: BODY}}`"),
        ("actions: {a: {couple: [0, 0, 1 N m], on: bar, from: one}}", "begin another scene where it begins or ends"),
        ("events: {e: {removes: bar, from: one, to: two}}", "begin a scene of its own"),
        ("events: {e: {collides: [bead, bar], from: one, to: two}}", "`impulse: J, on: BODY.P, direction: z`"),
    ],
)
def test_a_word_of_the_plane_is_refused_with_what_says_the_same(written: str, cure: str) -> None:
    with pytest.raises(SceneError) as caught:
        solve(f"{BODIES}{written}\nstates: {{one: at rest, two: {{}}}}\nfind: {{v: bar.cm.velocity at two}}\n")
    helps = [fault.help for fault in caught.value.faults if "is for scenes in the plane" in fault.message]
    assert helps and all(cure in help for help in helps)


def test_a_length_beside_a_letter_that_is_sought_is_one_fault() -> None:
    bodies = "{bar: {shape: rod, mass: m, length: 2 m}, other: {shape: rod, mass: 1 kg, length: 3 m}}"
    text = f"given: {{m: unknown}}\nbodies: {bodies}\nfind: {{m: m}}\n"
    with pytest.raises(SceneError, match="`2 m` can be read in two ways") as caught:
        solve(text)
    assert [fault.help for fault in caught.value.faults] == [
        "choose another letter for what is sought, as `m_1`; `2*m` is the product"
    ]


def test_an_angle_has_a_number_where_the_letters_cancel() -> None:
    """A tossed coin, L₃/L₂ with I₃ = 2 I₁ and P = −2 s/cos γ: tan δ = sin γ cos γ/(1 + sin² γ), 13.19°."""
    scene = """up: z
gravity: none
given: {m: kg, r: m, s: 600 rpm, gamma: 15 deg, P: unknown}
bodies: {coin: {shape: disc, mass: m, radius: r}}
states: {now: {coin.tilt: gamma, coin.spin: s, coin.precession: P, steady: true}}
find: {P: smallest P in rpm, delta: angle of coin.angular_velocity from coin.angular_momentum at now in deg}
"""
    answer = solve(scene).answers["delta"]
    assert answer.float == pytest.approx(13.19, abs=5e-3)
    assert answer.answer.formula is not None and answer.answer.formula.symbols() == {"gamma"}
