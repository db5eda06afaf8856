"""What touches: faces of plates that rub, places of balance of what rolls, and what is refused since it would rock or lies elsewhere."""

from __future__ import annotations

import math

import pytest

import rotsolve

PLATES = """
title: Two plates pressed together
given: {M: 1 kg, a: 10 cm, b: 14 cm, R: 20 cm, S: 25 cm, F: 100 N, mu: 0.3, w: 30 rad/s}
bodies: {one: {mass: M, ONE}, two: {mass: M, TWO}}
connections: {axle: {axle: [one, two]}, c: {clutch: [one, two], press: F, friction: mu}}
states: {start: {one.angular_velocity: w, two.angular_velocity: 0}, end: {c: sticks}}
find: {tau: size of c.torque at start, t: time from start to end}
"""
DISC, WIDE = "shape: disc, radius: R", "shape: disc, radius: S"
FACES = {  # the words for both plates, and the edges between which they rub
    "discs": (DISC, WIDE, 0.0, 0.2),
    "an annulus": ("shape: annulus, radii: {inner: a, outer: R}", WIDE, 0.1, 0.2),
    "a disc on an annulus": (DISC, "shape: annulus, radii: {inner: a, outer: S}", 0.1, 0.2),
    "two annuli": (
        "shape: annulus, radii: {inner: a, outer: R}",
        "shape: annulus, radii: {inner: b, outer: S}",
        0.14,
        0.2,
    ),
    "a thick tube": ("shape: cylindrical shell, radii: {inner: b, outer: R}", WIDE, 0.14, 0.2),
    "a ring": ("shape: ring, radius: R", WIDE, 0.2, 0.2),
    "a thin tube": ("shape: cylindrical shell, radius: R", WIDE, 0.2, 0.2),
    "no shape": ("inertia: M*R^2, radius: R", WIDE, 0.0, 0.2),
}


def mean_distance(inner: float, outer: float, slices: int = 20000) -> float:
    """Where the mass of a ring between two radii is on the average, as a sum over thin rings."""
    if inner == outer:
        return outer
    width = (outer - inner) / slices
    middles = [inner + (k + 0.5) * width for k in range(slices)]
    return sum(r * r for r in middles) / sum(middles)


@pytest.mark.parametrize("kind", FACES)
def test_plates_rub_where_both_have_a_face(kind: str) -> None:
    one, two, inner, outer = FACES[kind]
    solution = rotsolve.solve(PLATES.replace("ONE", one).replace("TWO", two))
    assert solution.answers["tau"].float == pytest.approx(0.3 * 100 * mean_distance(inner, outer), rel=1e-6)
    assert [item.holds for item in solution.derivation.confirmed] == [True, True]


@pytest.mark.parametrize("shape", ["sphere, radius: R", "spherical shell, radius: R"])
def test_what_has_no_face_is_refused(shape: str) -> None:
    with pytest.raises(rotsolve.Unsolvable, match="over what face `one` rubs"):
        rotsolve.solve(PLATES.replace("ONE", f"shape: {shape}").replace("TWO", WIDE))


def test_a_plate_in_the_hole_of_another_is_refused() -> None:
    scene = PLATES.replace("ONE", "shape: disc, radius: a").replace(
        "TWO", "shape: annulus, radii: {inner: b, outer: S}"
    )
    with pytest.raises(rotsolve.Unsolvable, match="`one` lies in the hole of `two`"):
        rotsolve.solve(scene)


HOOP = """
title: A loaded hoop in balance
given: {M: 1 kg, m: 2 kg, R: 30 cm, beta: 15 deg, phi: unknown}
surfaces: {ramp: SURFACE}
bodies: BODIES
connections: {base: {rolls: [RIM, ramp]} GLUE}
states: {rest: {hoop.angle: phi, balance: true}}
find: {phi: phi in deg}
"""
LOADED = {  # a lump on the right of the rim at the angle 0
    "of parts": (
        "{hoop: {parts: {rim: {shape: ring, mass: M, radius: R, at: [0, 0]}, lump: {mass: m, at: [R, 0]}}, moves: WAY}}",
        "hoop.rim",
        "",
    ),
    "glued": (
        "{hoop: {shape: ring, mass: M, radius: R, moves: WAY}, lump: {mass: m}}",
        "hoop",
        ", glue: {weld: [hoop.rim, lump]}",
    ),
}


@pytest.mark.parametrize("way", ["right", "left", "down", "up"])
@pytest.mark.parametrize("made", LOADED)
def test_a_loaded_hoop_rests_with_its_load_below(made: str, way: str) -> None:
    bodies, rim, glue = LOADED[made]
    sloping = way in ("down", "up")
    scene = HOOP.replace("SURFACE", "{slope: beta}" if sloping else "level").replace(
        "BODIES", bodies.replace("WAY", way)
    )
    angle = rotsolve.solve(scene.replace("RIM", rim).replace("GLUE", glue)).answers["phi"].float
    assert angle is not None
    # about the point of contact: m R cos φ = (M + m) R sin β, the slope falling to the left of the picture or to its right
    arm = 3 * math.sin(math.radians(15)) / 2 if sloping else 0.0
    assert abs(math.cos(math.radians(angle))) == pytest.approx(arm, abs=1e-12)
    assert math.sin(math.radians(angle)) < 0


BENT = {
    "a half disc by x and y": "shape: lamina, region: {x: [-R, R], y: [-sqrt(R^2 - x^2), 0]}",
    "a half ball": "shape: solid of revolution, profile: {z: [-R, 0], r: sqrt(R^2 - z^2)}",
    "an ellipsoid": "shape: ellipsoid, sides: [R, 2*R, R]",
}
SLOPE = """
title: On a slope
given: {M: 2 kg, R: 20 cm, beta: 10 deg}
surfaces: {ramp: {slope: beta}}
bodies: {it: {mass: M, moves: down, SHAPE}}
connections: {base: {TOUCH}}
states: {start: at rest}
find: {a: it.acceleration}
"""


@pytest.mark.parametrize("shape", [*BENT.values(), "shape: rectangle, sides: [R, R]"])
def test_what_is_not_round_does_not_roll(shape: str) -> None:
    with pytest.raises(rotsolve.Unsolvable, match="`it` is not round where it touches, and does not roll"):
        rotsolve.solve(SLOPE.replace("SHAPE", shape).replace("TOUCH", "rolls: [it, ramp]"))


@pytest.mark.parametrize("friction", ["none", "any", "0.1"])
@pytest.mark.parametrize("shape", BENT.values())
def test_what_would_rock_is_refused(shape: str, friction: str) -> None:
    with pytest.raises(rotsolve.Unsolvable, match="on which side `it` touches `ramp` nothing tells"):
        rotsolve.solve(SLOPE.replace("SHAPE", shape).replace("TOUCH", f"contact: [it, ramp], friction: {friction}"))


@pytest.mark.parametrize("shape", ["shape: ring, radius: R", "shape: arc, radius: R, opening: 90 deg"])
def test_nothing_rides_on_a_bent_wire(shape: str) -> None:
    scene = f"""
title: A bead on a wire
plane: horizontal
given: {{R: 20 cm, w: 6 rad/s}}
bodies: {{wire: {{mass: 1 kg, {shape}}}, bead: {{mass: 1 kg}}}}
connections: {{pin: {{hinge: wire.center}}, track: {{rides: [bead, wire], friction: none}}}}
states: {{one: {{bead.radius: R/2, wire.angular_velocity: w, bead.velocity.radial: 0}}, two: {{bead.radius: R}}}}
find: {{v: wire.angular_velocity at two}}
"""
    with pytest.raises(rotsolve.Unsolvable, match="`bead` rides straight out from the axis"):
        rotsolve.solve(scene)


@pytest.mark.parametrize("touch", ["contact: [disc, table], friction: any", "rolls: [disc, table]"])
def test_friction_on_a_table_seen_from_above_is_refused(touch: str) -> None:
    scene = f"""
title: A disc on a table
plane: horizontal
surfaces: {{table: level}}
bodies: {{disc: {{shape: disc, mass: 2 kg, radius: 20 cm, moves: right}}}}
connections: {{face: {{{touch}}}}}
states: {{start: {{disc.velocity: 3 m/s}}, end: {{time: 1 s}}}}
find: {{v: disc.velocity at end}}
"""
    with pytest.raises(
        rotsolve.Unsolvable, match="friction on `table`, which lies below a scene that is seen from above"
    ):
        rotsolve.solve(scene)


def test_a_contact_names_one_body_that_carries() -> None:
    scene = """
title: A plank on a roller
surfaces: {floor: level}
bodies: {plank: {mass: 6 kg, moves: right}, one: {shape: cylinder, mass: 2 kg, radius: 10 cm, moves: right}}
connections: {both: {rolls: [one, floor, plank]}}
actions: {pull: {force: 12 N, on: plank, direction: right}}
states: {start: at rest}
find: {a: plank.acceleration}
"""
    with pytest.raises(rotsolve.Unsolvable, match="names a body, `plank`, beside other things"):
        rotsolve.solve(scene)
