"""What points out of the picture, or is carried round: turning shafts, components square to the plane; and swings that are not free."""

from __future__ import annotations

from math import cos, radians, sin, sqrt

import numpy as np
import pytest

from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.pipeline import solve

M, L, D, W, ANGLE = 2.0, 0.9, 0.15, 5.0, radians(-35)
SHAFT = """title: x
given: {M: 2 kg, L: 90 cm, d: 15 cm, w: 5 rad/s}
bodies: {hanger: BODY}
connections: {hook: {shaft: hanger.POINT, turning: w, distance: d}}
states: {round: {hanger.angle: -35 deg, STEADY}}
find: {v: hanger.END.speed, a: hanger.END.acceleration.x, K: hanger.kinetic_energy}
"""
RODS = np.linspace(0, L, 20001)[:-1] + L / 40000


@pytest.mark.parametrize("spin", [0.0, 2.0])
def test_points_of_a_rod_go_round_the_shaft(spin: float) -> None:
    """Of every piece v² = (s ω)² + (Ω x)², and in the picture a = −Ω² x − s ω² along the rod; at an angular velocity of its own, too."""
    text = SHAFT.replace("BODY", "{shape: rod, mass: M, length: L}").replace("POINT", "start").replace("END", "end")
    answers = solve(text.replace("STEADY", f"hanger.angular_velocity: {spin:.0f} rad/s")).answers
    away = D + L * cos(ANGLE)
    pieces = (D + RODS * cos(ANGLE)) ** 2 * W**2 + RODS**2 * spin**2
    assert answers["v"].float == pytest.approx(sqrt((W * away) ** 2 + (L * spin) ** 2), rel=1e-9)
    assert answers["K"].float == pytest.approx(M / 2 * pieces.mean(), rel=1e-6)
    torque = M * (W**2 * ((D + RODS * cos(ANGLE)) * RODS * -sin(ANGLE)).mean() - 9.8 * L / 2 * cos(ANGLE))
    alpha = torque / (M * L**2 / 3)
    true = -(W**2) * away - L * spin**2 * cos(ANGLE) - L * alpha * sin(ANGLE)
    assert answers["a"].float == pytest.approx(true, rel=1e-6)


@pytest.mark.parametrize(
    ("body", "about"),
    [
        ("{shape: sphere, mass: M, radius: L/4, points: {P: [-L/2, 0]}}", 0.4 * M * (L / 4) ** 2),
        ("{shape: rectangle, mass: M, sides: [L, L/2], points: {P: [-L/2, 0]}}", None),
        ("{shape: cuboid, mass: M, sides: [L, L/2, L/3], points: {P: [-L/2, 0]}}", None),
    ],
)
def test_energy_of_bodies_on_a_shaft_is_that_of_all_pieces(body: str, about: float | None) -> None:
    """½ Ω² (I + M x²), I of the body about the upright through its centre, by its own axes."""
    text = SHAFT.replace("BODY", body).replace("POINT", "P").replace("END", "cm")
    answers = solve(text.replace("STEADY", "hanger.angular_velocity: 0")).answers
    if about is None:
        deep = L / 3 if "cuboid" in body else 0
        along, across = M * ((L / 2) ** 2 + deep**2) / 12, M * (L**2 + deep**2) / 12
        about = along * sin(ANGLE) ** 2 + across * cos(ANGLE) ** 2
    away = D + L / 2 * cos(ANGLE)
    assert answers["K"].float == pytest.approx(W**2 / 2 * (about + M * away**2), rel=1e-9)
    assert answers["v"].float == pytest.approx(W * away, rel=1e-9)


@pytest.mark.parametrize(
    "asked",
    [
        "hanger.end.velocity",
        "hanger.end.acceleration.normal",
        "hanger.end.velocity.tangential",
        "hanger.momentum",
        "hanger.angular_momentum",
        "hanger.kinetic_energy.rotational",
        "momentum",
        "angular_momentum",
    ],
)
def test_what_points_out_of_the_picture_is_refused(asked: str) -> None:
    text = (
        SHAFT.replace("BODY", "{shape: rod, mass: M, length: L}")
        .replace("POINT", "start")
        .replace("STEADY", "steady: true")
    )
    with pytest.raises(Unsolvable, match="shaft"):
        solve(text[: text.index("find:")] + f"find: {{q: {asked}}}\n")


PLANE = """title: x
given: {M: 2 kg, R: 10 cm, Q: 3 N m, w0: 5 rad/s, F: 4 N}
surfaces: {floor: level}
bodies: {wheel: {shape: cylinder, mass: M, radius: R, length: R, turns: SENSE}, block: {mass: M, moves: left}}
connections: {hook: {axle: wheel}, base: {contact: [block, floor]}}
actions: {turn: {couple: Q, on: wheel}, push: {force: F, on: block, direction: left}}
states: {a: {STATE}}
find: {q: ASKED}
"""


@pytest.mark.parametrize(
    ("state", "asked"),
    [
        *(("wheel.angular_velocity: w0", f"{owner}.{word}") for owner, word in (
            ("wheel", "angular_velocity.x"), ("wheel", "angular_acceleration.y"), ("wheel", "torque.x"), ("turn", "torque.y"),
            ("turn", "torque.z"), ("hook", "force.z"), ("base", "force.z"), ("push", "force.z"), ("block", "velocity.z"),
            ("block", "acceleration.z"), ("block", "force.z"), ("turn", "torque.gravity"),

        )),
        ("wheel.angular_velocity.x: w0", "wheel.kinetic_energy"),
        ("wheel.angular_velocity.y: w0", "wheel.kinetic_energy"),
        ("block.velocity.z: 3 m/s", "block.kinetic_energy"),
    ],
)  # fmt: skip
def test_no_component_is_read_as_another(state: str, asked: str) -> None:
    text = PLANE.replace("SENSE", "clockwise").replace("STATE", state).replace("ASKED", asked)
    named = state.partition(":")[0] if state != "wheel.angular_velocity: w0" else asked
    with pytest.raises((Unsolvable, SceneError), match=named.replace(".", r"\.")):
        solve(text)


@pytest.mark.parametrize(("sense", "sign"), [("clockwise", -1), ("counterclockwise", 1)])
def test_z_counts_counterclockwise(sense: str, sign: int) -> None:
    """Whichever turn is declared positive; of what a state says as of what is asked."""
    text = PLANE.replace("SENSE", sense)
    said = text.replace("STATE", "wheel.angular_velocity: w0")
    for word, value in (("angular_velocity", 5), ("angular_acceleration", 300), ("torque", 3)):
        assert solve(said.replace("ASKED", f"wheel.{word}.z")).answers["q"].float == pytest.approx(sign * value)
    stated = text.replace("STATE", "wheel.angular_velocity.z: w0").replace("ASKED", "wheel.angular_velocity")
    assert solve(stated).answers["q"].float == pytest.approx(sign * 5)


SWINGS = """title: x
given: {M: 5 kg, I: 3 kg m^2, R: 20 cm, k: 200 N/m, kt: 24 N m/rad, c: 3 N s/m, h: 2 N m s, tau: 2 N m, F: 5 N}
surfaces: {floor: level}
bodies: {wheel: {inertia: I, radius: R}, block: {mass: M, moves: MOVES}}
"""
WIRE = "axle: {axle: wheel}, wire: {torsion: wheel, stiffness: kt}"
COIL = "base: {contact: [block, floor]}, coil: {spring: [ground, block], stiffness: k}"


@pytest.mark.parametrize(
    ("connections", "action", "named"),
    [
        (WIRE, "power: 3 W, on: wheel", "oil"),
        (WIRE, "couple: tau*sin(time/(1 s)), on: wheel", "oil"),
        (WIRE, "press: F, on: wheel.rim, friction: 0.4", "friction"),
        (WIRE.replace("axle: wheel", "axle: wheel, friction_torque: tau"), "couple: tau, on: wheel", "friction_torque"),
    ],
)
def test_swings_that_are_stuck_or_driven_are_refused(connections: str, action: str, named: str) -> None:
    moves = "right" if "base" in connections else "up"
    text = SWINGS.replace("MOVES", moves) + f"connections: {{{connections}}}\nactions: {{oil: {{{action}}}}}\n"
    owner = "block" if "base" in connections else "wheel"
    with pytest.raises(Unsolvable, match=named):
        solve(text + f"find: {{T: period of small swings of {owner}}}\n")


@pytest.mark.parametrize("shape", ["triangle", "polygon", "cone"])
@pytest.mark.parametrize("link", ["contact", "rolls"])
def test_what_lies_on_a_sloping_side_is_refused_by_its_shape(shape: str, link: str) -> None:
    sides = "radius: R, length: R" if shape == "cone" else "corners: [[0, 0], [R, 0], [0, R]]"
    text = "title: x\ngiven: {M: 12 kg, m: 5 kg, R: 2 m, F: 30 N}\nsurfaces: {yard: level}\nbodies:\n"
    text += f"  wagon: {{shape: {shape}, mass: M, {sides}, moves: right}}\n  crate: {{shape: disc, mass: m, radius: R/9, moves: right}}\n"
    text += f"connections:\n  wheels: {{contact: [wagon, yard]}}\n  touch: {{{link}: [crate, wagon]}}\n"
    text += "actions: {push: {force: F, on: wagon, direction: right}}\nstates: {go: at rest}\nfind: {a: wagon.acceleration}\n"
    with pytest.raises((Unsolvable, SceneError), match="wagon" if shape == "cone" else shape):
        solve(text)


@pytest.mark.parametrize("spin", [0.0, 2.0])
@pytest.mark.parametrize("cut", [0.0, 0.2, 0.7])
@pytest.mark.parametrize("hinge", ["start", "end"])
def test_what_acts_inside_a_rod_on_a_shaft_is_what_its_pieces_take(hinge: str, cut: float, spin: float) -> None:
    """Beyond a cut: what acts there is Σ m (a − g) of all pieces, Ω² x towards the shaft in a, with its arm from the cut."""
    scene = SHAFT[: SHAFT.index("find:")].replace(
        "{hanger: BODY}", "{hanger: {shape: rod, mass: M, length: L}, lump: {mass: 1 kg}}"
    )
    scene = scene.replace("d: 15 cm", f"d: 15 cm, x: {cut * L} m").replace("POINT", hinge)
    scene = scene.replace(
        "connections: {",
        "connections: {glue: {weld: [hanger.OTHER, lump]}, ".replace("OTHER", "end" if hinge == "start" else "start"),
    )
    scene = scene.replace("STEADY", f"hanger.angular_velocity: {spin} rad/s")
    words = {"C": "compression", "V": "shear", "B": "bending_moment"}
    asked = ", ".join(f"{letter}: hanger.at(x).{word}" for letter, word in words.items())
    answers = solve(f"{scene}find: {{alpha: hanger.angular_acceleration, {asked}}}\n").answers
    alpha, along, across = answers["alpha"].float, *(np.array([cos(ANGLE + q), sin(ANGLE + q)]) for q in (0, np.pi / 2))
    origin = 0.0 if hinge == "start" else L
    places, masses = np.append(RODS, L - origin), np.append(np.full(len(RODS), M / len(RODS)), 1.0)
    arms = places - origin
    take = arms[:, None] * (alpha * across - spin**2 * along) + np.array([0, 9.8])
    take[:, 0] -= W**2 * (D + arms * along[0])
    take *= masses[:, None]
    free = places > cut * L if hinge == "start" else places <= cut * L  # what is just there belongs to the part before
    side = 1 if hinge == "start" else -1
    force, lever = side * take[free].sum(axis=0), (places - cut * L)[free]
    assert answers["C"].float == pytest.approx(force @ along, rel=1e-3, abs=1e-3)
    assert answers["V"].float == pytest.approx(force @ across, rel=1e-3, abs=1e-3)
    assert answers["B"].float == pytest.approx(-side * (take[free] @ across) @ lever, rel=1e-3, abs=1e-3)
