"""A torsion spring, and a couple that speaks of an angle, twist by the `angle` of their body: of what hangs that of its centre of mass."""

from __future__ import annotations

import math

import pytest

from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

PLATE = "{shape: rectangle, mass: M, sides: [b, b/2]}"
HAMMER = "{parts: {stick: {shape: rod, mass: M, start: [0, 0], end: [b, 0]}, head: {mass: M, at: [b, b/2]}}, points: {grip: [0, 0]}}"
ROD = "{shape: rod, mass: M, length: b}"
BODIES = {  # with where it hangs, the distance of its centre of mass from there over b, its moment of inertia over M b², its mass over M
    "plate at a corner": (PLATE, "corner1", math.hypot(1 / 2, 1 / 4), 5 / 12, 1),
    "plate at another": (PLATE, "corner3", math.hypot(1 / 2, 1 / 4), 5 / 12, 1),
    "hammer": (HAMMER, "grip", math.hypot(3 / 4, 1 / 4), 1 / 3 + 5 / 4, 2),
    "rod": (ROD, "start", 1 / 2, 1 / 3, 1),
}
TWISTS = {
    "wire": "connections: {{pin: {{hinge: body.{at}}}, wire: {{torsion: body, stiffness: k}}}}",
    "couple": "connections: {{pin: {{hinge: body.{at}}}}}\nactions: {{wire: {{couple: -k*body.angle, on: body}}}}",
}


@pytest.mark.parametrize("angle", [30, -100])
@pytest.mark.parametrize("twist", TWISTS)
@pytest.mark.parametrize("name", BODIES)
def test_twist_is_the_angle_of_the_body(name: str, twist: str, angle: int) -> None:
    """κ θ and the weight of the centre of mass, which lies at θ, turn it."""
    body, at, arm, inertia, mass = BODIES[name]
    scene = f"""
given: {{M: 3 kg, b: 0.4 m, k: 20 N m/rad, g: 9.8 m/s^2}}
bodies: {{body: {body}}}
{TWISTS[twist].format(at=at)}
states: {{start: {{body.angle: {angle} deg, at rest: all}}}}
find: {{alpha: body.angular_acceleration}}
"""
    solution = solve(scene, digits=10)
    M, b, k, g, theta = 3, 0.4, 20, 9.8, math.radians(angle)
    expected = (-k * theta - mass * M * g * arm * b * math.cos(theta)) / (inertia * M * b**2)
    assert solution.answers["alpha"].float == pytest.approx(expected, rel=1e-8)


BETWEEN = """
given: {I: 2 kg m^2, J: 5 kg m^2, k: 3 N m/rad}
plane: horizontal
bodies: {BODIES}
connections: {shaft: {axle: [one, two]}, wire: {torsion: [FIRST, LAST], stiffness: k, rest_angle: REST rad}}
states: {start: {TOLD, at rest: all}, mid: {wire.angle: 0.1 rad}}
find:
  p: wire.angle at start
  q: wire.angle at mid
  a: FIRST.angular_acceleration at start
  v: FIRST.angular_velocity at mid
  w: LAST.angular_velocity at mid
"""
TOLD = {  # how the two stand at first, by which twist
    "both": ("one.angle: 0.3 rad, two.angle: 1 rad", 0.7),
    "the wire": ("wire.angle: SIGN0.7 rad", 0.7),
    "the wire and the first": ("one.angle: 1 rad, wire.angle: SIGN0.7 rad", 0.7),
    "the wire before the last": ("wire.angle: SIGN0.7 rad, two.angle: -2 rad", 0.7),
    "the last alone": ("two.angle: 0.7 rad", 0.7),
}


ORDERS = ("one, two", "two, one")
TWISTED = [  # of each kind half of all: each two values of different axes together
    (kind, order, bodies, (0.0, -0.2)[(one + other) % 2])
    for kind in TOLD
    for one, order in enumerate(ORDERS)
    for other, bodies in enumerate(ORDERS)
]


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("kind", "order", "bodies", "rest"), TWISTED)
def test_the_angle_of_a_wire_between_two_is_how_far_it_is_twisted(
    kind: str, order: str, bodies: str, rest: float
) -> None:
    """With the inertia I J/(I + J) it swings about its rest angle; each takes the share of the other's inertia, `two` clockwise."""
    told, twist = TOLD[kind]
    first, last = order.split(", ")
    sign = 1 if last == "two" else -1
    inertia, senses = {"one": 2.0, "two": 5.0}, {"one": 1, "two": -1}
    made = {"one": "one: {inertia: I}", "two": "two: {inertia: J, turns: clockwise}"}
    text = BETWEEN.replace("{BODIES}", "{" + ", ".join(made[name] for name in bodies.split(", ")) + "}")
    text = text.replace("TOLD", told).replace("SIGN", "" if sign > 0 else "-").replace("REST", str(rest))
    solution = solve(text.replace("FIRST", first).replace("LAST", last))
    found = {name: answer.float for name, answer in solution.answers.items()}
    began, whole = sign * twist, inertia["one"] + inertia["two"]
    way = math.copysign(1, 0.1 - began)
    rate = way * math.sqrt(3 * ((began - rest) ** 2 - (0.1 - rest) ** 2) * whole / (inertia["one"] * inertia["two"]))
    expected = {
        "p": began,
        "q": 0.1,
        "a": senses[first] * 3 * (began - rest) / inertia[first],
        "v": -senses[first] * rate * inertia[last] / whole,
        "w": senses[last] * rate * inertia[first] / whole,
    }
    assert found == pytest.approx(expected)
    assert all(item.holds for item in solution.derivation.confirmed)


AXLE = "bodies: {{wheel: {{inertia: 2 kg m^2, radius: 1 m, turns: {turns}}}}}\nconnections: {{pin: {{axle: wheel}}}}\n"
LEVEL = (
    "surfaces: {{floor: level}}\nbodies: {{wheel: {{shape: disc, mass: 2 kg, radius: 1 m, moves: {moves}}}}}\n"
    "connections: {{touch: {{rolls: [wheel, floor]}}}}\n"
)
ALONG = {  # what goes by the angle along a turn, and the same with the way told
    "couple": ("actions: {{it: {{couple: -k*wheel.angle, on: wheel{way}}}}}", ", direction: counterclockwise"),
    "force": (
        "actions: {{it: {{force: -k*wheel.angle/(1 m), on: wheel.rim{way}}}}}",
        ", direction: counterclockwise",
    ),
}


def by_angle(scene: str) -> float | None:
    """The acceleration at 0.3 rad of a wheel that is brought back to 0."""
    told = "states: {start: {wheel.angle: 0.3 rad, at rest: all}}\nfind: {a: wheel.angular_acceleration}"
    return solve(f"title: by angle\ngiven: {{k: 3 N m}}\nplane: horizontal\n{scene}\n{told}").answers["a"].float


@pytest.mark.parametrize("kind", ALONG)
def test_what_goes_by_an_angle_against_the_turn_says_which_way(kind: str) -> None:
    """Of a body that counts clockwise −k θ would drive it away: refused; counterclockwise, as the angle, it brings back."""
    action, way = ALONG[kind]
    assert by_angle(AXLE.format(turns="counterclockwise") + action.format(way="")) == pytest.approx(-0.45)
    clockwise = AXLE.format(turns="clockwise")
    with pytest.raises(
        Unsolvable, match=r"`wheel.angle` counts counterclockwise, but `wheel` turns clockwise"
    ) as refused:
        by_angle(clockwise + action.format(way=", direction: tangential" if kind == "force" else ""))
    assert "`direction: counterclockwise`" in refused.value.fault.help
    assert by_angle(clockwise + action.format(way=way)) == pytest.approx(0.45)


@pytest.mark.parametrize("moves", ["right", "left"])
def test_so_does_what_rolls(moves: str) -> None:
    """To the right it turns clockwise, though the scene does not say so."""
    couple = "actions: {it: {couple: -k*wheel.angle, on: wheel}}"
    scene = LEVEL.format(moves=moves) + couple
    told = "states: {start: {wheel.angle: 0.3 rad, at rest: all}}\nfind: {a: wheel.angular_acceleration}"
    text = f"title: rolling\ngiven: {{k: 3 N m}}\n{scene}\n{told}"
    if moves == "right":
        with pytest.raises(Unsolvable, match="which way `it` acts is not clear"):
            solve(text)
    else:
        assert solve(text).answers["a"].float == pytest.approx(-0.3)


@pytest.mark.parametrize(
    ("element", "ask"),
    [
        ("pin: {axle: [carrier, wheel]}, legs: {drives: [carrier, wheel], couple: -k*wheel.angle}", "`legs`"),
        ("pin: {axle: wheel, angular_acceleration: -k*wheel.angle/(1 kg m^2)}", "`pin`"),
    ],
)
@pytest.mark.parametrize("turns", ["clockwise", "counterclockwise"])
def test_so_does_what_drives_along_the_turn(element: str, ask: str, turns: str) -> None:
    """Couples between two bodies and rates that are given have no direction of their own."""
    scene = f"bodies: {{wheel: {{inertia: 2 kg m^2, turns: {turns}}}, carrier: {{inertia: 1 kg m^2}}}}\nconnections: {{{element}}}"
    if turns == "clockwise":
        with pytest.raises(Unsolvable, match=f"which way {ask} acts is not clear") as refused:
            by_angle(scene)
        assert "leave its clockwise sense out" in refused.value.fault.help
    else:
        assert by_angle(scene) == pytest.approx(-0.45 if "legs" in element else -0.9)
