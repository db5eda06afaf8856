"""What a body has turned from one state to a later one counts: in forces of its joint by components, in the way in which gears turn on, and
where a carrier has an axle."""

from __future__ import annotations

from math import cos, pi, sin

import pytest

from rotsolve import solve

TABLE = """
plane: horizontal
given: {{M: 3 kg, m: 2 kg, b: 80 cm, Q: 4 N m, w: 2 rad/s, t: 1.2 s}}
bodies: {{one: {body}}}
connections: {{pin: {held}}}
actions: {{twist: {{couple: Q, on: one}}}}
states: {{start: {{one.angular_velocity: w}}, end: {{time: t}}}}
find: {{Fx: pin.force.x at end, Fy: pin.force.y at end, vx: one.cm.velocity.x at end, ay: one.cm.acceleration.y at end}}
"""
DISC, LUMP = "disc: {shape: disc, mass: M, radius: b}", "lump: {mass: m, at: [b/2, 0]}"
# body, what holds it, its mass, how far its centre of mass is from there, its inertia about it, and the direction of that as drawn
HELD = {
    "a rod": ("{shape: rod, mass: M, length: b}", "{hinge: one.start}", 3, 0.4, 3 * 0.64 / 3, 0.0),
    "a loaded wheel": (f"{{radius: b, parts: {{{DISC}, {LUMP}}}}}", "{axle: one}", 5, 0.16, 0.96 + 2 * 0.16, 0.0),
    "a plate at its corner": (
        "{shape: rectangle, mass: M, sides: [b, b]}",
        "{hinge: one.corner3}",
        3,
        0.8 / 2**0.5,
        3 * 0.64 / 6 + 3 * 0.32,
        -3 * pi / 4,
    ),
}


@pytest.mark.parametrize("case", HELD)
def test_components_are_those_of_a_body_that_has_turned(case: str) -> None:
    body, held, mass, arm, inertia, drawn = HELD[case]
    found = solve(TABLE.format(body=body, held=held))
    alpha = 4 / inertia
    omega, angle = 2 + alpha * 1.2, drawn + 2 * 1.2 + alpha * 1.2**2 / 2
    ax = arm * (-(omega**2) * cos(angle) - alpha * sin(angle))
    ay = arm * (-(omega**2) * sin(angle) + alpha * cos(angle))
    own = {"Fx": mass * ax, "Fy": mass * ay, "vx": -arm * omega * sin(angle), "ay": ay}
    assert {name: found.answers[name].float for name in own} == pytest.approx(own)
    assert all(item.holds for item in found.derivation.confirmed)


GEARED = """
plane: horizontal
given: {tau: 2 N m, c: 0.42 N m s, w: 2.2 rad/s, d: 16 deg}
bodies: {one: {shape: disc, mass: 3.7 kg, radius: 1.8 m}, two: {shape: ring, mass: 5.2 kg, radius: 0.78 m}}
connections: {axle: {axle: one, friction_torque: tau}, stub: {axle: two}, mesh: {gear: [one, two]}}
actions: {oil: {couple: -c*one.angular_velocity, on: one}}
states: {start: {one.angular_velocity: w}, end: {one.rotation: d}}
find: {W: two.angular_velocity at end, V: one.angular_velocity at end}
"""


def test_a_wheel_that_another_one_turns_goes_on_as_that_one_does() -> None:
    """ω dω/dθ = −(τ + c ω)/I: what slows it down tells not the way in which it goes, as its speed at the start does."""
    found = solve(GEARED)
    inertia, omega, steps = 3.7 * 1.8**2 / 2 + 5.2 * 1.8**2, 2.2, 20000
    for _ in range(steps):
        middle = omega - 16 * pi / 180 / steps / 2 * (2 + 0.42 * omega) / inertia / omega
        omega -= 16 * pi / 180 / steps * (2 + 0.42 * middle) / inertia / middle
    assert found.answers["V"].float == pytest.approx(omega, rel=1e-6)
    assert found.answers["W"].float == pytest.approx(-omega * 1.8 / 0.78, rel=1e-6)
    assert all(item.holds for item in found.derivation.confirmed)


def test_an_axle_on_a_half_ball_is_at_its_centre() -> None:
    """A wheel on the axle of a half ball that rolls: it stays at the height R. I = m R² + (7/5) M R² about the point of contact, as the
    half ball has 2 M R²/5 about its centre."""
    found = solve("""
    given: {M: 3.2 kg, m: 1.6 kg, R: 1.5 m}
    surfaces: {floor: level}
    bodies: {half: {shape: hemisphere, mass: M, radius: R}, wheel: {shape: disc, mass: m, radius: 1 m}}
    connections: {base: {rolls: [half, floor]}, spindle: {axle: [half, wheel]}}
    states: {now: {at rest: all, half.angle: 0}}
    find: {a: half.angular_acceleration, F: spindle.force.y}
    """)
    assert found.answers["a"].float == pytest.approx(3.2 * 9.8 * 3 * 1.5 / 8 / (1.5**2 * (1.6 + 1.4 * 3.2)))
    assert found.answers["F"].float == pytest.approx(1.6 * 9.8)
    assert all(item.holds for item in found.derivation.confirmed)


@pytest.mark.parametrize(
    ("shape", "point"),
    [("triangle, sides: [3 m, 4 m, 5 m]", "cm"), ("arc, radius: 1 m, opening: 120 deg", "center")],
)
def test_an_axle_on_a_body_named_alone_is_at_its_centre_else_at_its_centre_of_mass(shape: str, point: str) -> None:
    text = f"""
    given: {{w: 3 rad/s}}
    bodies:
      one: {{shape: {shape}, mass: 2 kg, points: {{P: [0.4 m, 0.7 m]}}}}
      two: {{shape: disc, mass: 1 kg, radius: 30 cm}}
    connections: {{pin: {{hinge: one.P}}, stud: {{axle: [one, two]}}}}
    states: {{now: {{one.angular_velocity: w, one.angle: 0, two.angular_velocity: 0}}}}
    find: {{v: two.velocity.y, u: one.{point}.velocity.y}}
    """
    found = solve(text)
    assert found.answers["v"].float == pytest.approx(found.answers["u"].float)
    assert all(item.holds for item in found.derivation.confirmed)


def test_the_force_of_a_weld_goes_round_with_what_it_holds() -> None:
    """A rod about its middle with a lump of equal mass at either end: the centre of mass stays, and each lump goes round."""
    found = solve("""
    plane: horizontal
    given: {M: 3 kg, m: 2 kg, b: 80 cm, Q: 4 N m, w: 2 rad/s, t: 1.2 s}
    bodies: {rod: {shape: rod, mass: M, length: b}, one: {mass: m}, two: {mass: m}}
    connections: {pin: {hinge: rod.center}, glue: {weld: [rod.end, one]}, stay: {weld: [rod.start, two]}}
    actions: {twist: {couple: Q, on: rod}}
    states: {start: {rod.angular_velocity: w}, end: {time: t}}
    find: {Fx: glue.force.x at end, Fy: glue.force.y at end}
    """)
    alpha = 4 / (3 * 0.64 / 12 + 2 * 2 * 0.16)
    omega, angle = 2 + alpha * 1.2, 2 * 1.2 + alpha * 1.2**2 / 2
    assert found.answers["Fx"].float == pytest.approx(2 * 0.4 * (-(omega**2) * cos(angle) - alpha * sin(angle)))
    assert found.answers["Fy"].float == pytest.approx(2 * 0.4 * (-(omega**2) * sin(angle) + alpha * cos(angle)))
    assert all(item.holds for item in found.derivation.confirmed)
