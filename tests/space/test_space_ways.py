"""Whether what turns on a hinge, or goes along a slide, of what turns itself comes to where a later state has it: it may set out the other
way for ever, turn back before, or rest in balance; and which way it comes there."""

from __future__ import annotations

from math import cos, pi, radians, sin, sqrt

import pytest

from rotsolve import SceneError, solve
from rotsolve.core.faults import NeverReached

ARM = """
up: z
given: {R: 30 cm, w: TURN, m: 0.4 kg, l: 20 cm, g: 9.8 m/s^2}
bodies: {disc: {shape: disc, mass: 3 kg, radius: R, points: {P: [R, 0, 0]}}, rod: {shape: rod, mass: m, length: l}}
connections: {shaft: {hinge: disc.center, along: z, angular_velocity: w}, pin: {hinge: [disc.P, rod.start], along: AXIS}}
states: {first: {rod.angle: FROM, rod.angular_velocity: RATE}, last: {rod.angle: TO}}
find: {n: rod.angular_velocity.AXIS in rod axes at last}
"""
BEAD = """
up: z
gravity: none
given: {w: 6 rad/s, d: 20 cm, Z: 0 m}
bodies: {table: {shape: disc, mass: 2 kg, radius: 1 m, points: {P: [START, d, Z]}}, bead: {shape: particle, mass: 1 kg}}
connections: {axis: {hinge: table.center, along: z, angular_velocity: w}, guide: {slide: [table.P, bead], along: x}}
states: {first: {bead.velocity relative to table: [RATE, 0, 0]}, last: {bead.position relative to table: [END, d, Z]}}
find: {u: bead.velocity.x relative to table in table axes at last}
"""
TWO = """
up: z
given: {R: 30 cm, w: 8 rad/s, l: 20 cm}
bodies: {disc: {shape: disc, mass: 3 kg, radius: R, points: {P: [R, 0, 0]}}, rod: {shape: rod, mass: 0.4 kg, length: l}}
connections: {shaft: {hinge: disc.center, along: z}, pin: {hinge: [disc.P, rod.start], along: z}}
states: {first: {disc.angular_velocity: w, rod.angle: 0 deg, rod.angular_velocity: RATE}, last: {rod.angle: TO}}
find: {n: rod.angular_velocity.z in rod axes at last, W: disc.angular_velocity.z at last}
"""
SOUGHT = """
up: z
given: {l: 20 cm, g: 9.8 m/s^2, q: unknown}
bodies: {rod: {shape: rod, mass: 0.4 kg, length: l}}
connections: {pin: {hinge: rod.start, along: y}}
states: {first: {rod.angle: q, rod.angular_velocity: RATE}, last: {rod.angle: 90 deg, rod.angular_velocity: LAST}}
find: {q: q}
"""
UPRIGHT = """
up: z
given: {L: 80 cm, g: 9.8 m/s^2}
bodies: {rod: {shape: rod, mass: 2 kg, length: L}}
connections: {foot: {ball: rod.start}}
states: {first: {rod.tilt: TILT, rod.precession: 0 rad/s, rod.nutation: 0 rad/s}, last: {rod.tilt: 90 deg}}
find: {n: rod.nutation at last}
"""


def put(text: str, **words: str) -> str:
    for word, said in words.items():
        text = text.replace(word, said)
    return "title: Ways" + text


@pytest.mark.sampled(4)
@pytest.mark.parametrize(
    ("turn", "axis", "start", "rate", "end", "why"),
    [
        ("8 rad/s", "y", "90 deg", "30 rad/s", "30 deg", "never turns back"),
        ("8 rad/s", "y", "90 deg", "-40 rad/s", "100 deg", "never turns back"),
        ("8 rad/s", "z", "0 deg", "40 rad/s", "-90 deg", "never turns back"),
        ("5 rad/s", "z", "180 deg", "1 rad/s", "90 deg", "never turns back"),
        ("5 rad/s", "z", "180 deg", "0 rad/s", "0 deg", "in balance"),
        ("8 rad/s", "z", "0 deg", "5 rad/s", "120 deg", "turns back before"),
    ],
)
def test_an_arm_of_a_carrier_that_does_not_come(
    turn: str, axis: str, start: str, rate: str, end: str, why: str
) -> None:
    with pytest.raises(NeverReached, match="`last` is never reached from `first`") as refused:
        solve(put(ARM, TURN=turn, AXIS=axis, FROM=start, RATE=rate, TO=end))
    assert why in refused.value.fault.help


@pytest.mark.parametrize(("rate", "end", "sense"), [(-40, -90, -1), (25, 120, 1), (10, -30, -1)])
def test_an_arm_that_comes(rate: int, end: int, sense: int) -> None:
    """In the frame of a disc that turns evenly ½ I q̇² − ½ m R l ω² cos q stays, with I = m l²/3; it turns back where that is 0."""
    found = solve(put(ARM, TURN="8 rad/s", AXIS="z", FROM="0 deg", RATE=f"{rate} rad/s", TO=f"{end} deg"))
    left = rate**2 - 3 * 0.3 / 0.2 * 8**2 * (1 - cos(radians(end)))
    assert found.answers["n"].float == pytest.approx(8 + sense * sqrt(left))


@pytest.mark.parametrize(
    ("start", "rate", "end", "why"),
    [
        (0.3, -1.0, -0.5, "turns back before"),
        (0.3, -3.0, 0.5, "never turns back"),
        (0.0, 0.0, 0.4, "in balance"),
    ],
)
def test_a_bead_on_a_chord_that_does_not_come(start: float, rate: float, end: float, why: str) -> None:
    with pytest.raises(NeverReached) as refused:
        solve(put(BEAD, START=f"{start} m", RATE=f"{rate} m/s", END=f"{end} m"))
    assert why in refused.value.fault.help


@pytest.mark.parametrize(
    ("start", "rate", "end", "sense"), [(0.3, -1.0, 0.5, 1), (0.3, -3.0, -0.5, -1), (0.1, 0.0, 0.6, 1)]
)
def test_a_bead_on_a_chord_that_comes(start: float, rate: float, end: float, sense: int) -> None:
    found = solve(put(BEAD, START=f"{start} m", RATE=f"{rate} m/s", END=f"{end} m"))
    assert found.answers["u"].float == pytest.approx(sense * sqrt(rate**2 + 36 * (end**2 - start**2)))
    assert all(item.holds for item in found.derivation.confirmed)


def test_in_letters_a_bead_has_to_get_over_the_middle() -> None:
    letters = "given: {w: rad/s, d: m, Z: 0 m, p: m, V: m/s, s: m}"
    text = put(BEAD, START="p", RATE="-V", END="-s").replace("given: {w: 6 rad/s, d: 20 cm, Z: 0 m}", letters)
    text = text.replace("radius: 1 m", "radius: 2*p")
    assert "if V > p w" in str(solve(text))


@pytest.mark.parametrize("rate", [-40.0, 40.0])
def test_which_rate_a_free_carrier_has_the_place_of_its_arm_tells(rate: float) -> None:
    """The arm comes to −90° turning clockwise on the disc, whichever way it sets out."""
    found = solve(put(TWO, RATE=f"{rate} rad/s", TO="-90 deg"))
    n, turn = found.answers["n"].float, found.answers["W"].float
    arm, rim, disc = 0.4 * 0.2**2 / 3, 0.4 * 0.3**2, 3 * 0.3**2 / 2

    def kept(own: float, carrier: float, angle: float) -> tuple[float, float]:
        mixed = 0.4 * 0.3 * 0.2 / 2 * cos(angle)
        momentum = (disc + rim) * carrier + arm * own + mixed * (own + carrier)
        return momentum, ((disc + rim) * carrier**2 + arm * own**2) / 2 + mixed * own * carrier

    assert n < turn
    assert kept(n, turn, pi / 2) == pytest.approx(kept(8 + rate, 8, 0.0))


@pytest.mark.parametrize(("rate", "last", "side"), [(0, -10, 1), (0, 10, -1), (-3, -10, 1), (3, 12, -1)])
def test_an_angle_sought_before_lies_where_the_rod_comes_from(rate: int, last: int, side: int) -> None:
    """ω² − ω₀² = 3 g (1 − sin q)/l, and it comes from beyond 90° where it turns clockwise there."""
    found = solve(put(SOUGHT, RATE=f"{rate} rad/s", LAST=f"{last} rad/s")).answers["q"].float
    assert (found > pi / 2) == (side > 0)
    assert sin(found) == pytest.approx(1 - 0.2 * (last**2 - rate**2) / (3 * 9.8))


def test_an_upright_rod_at_rest_stays() -> None:
    with pytest.raises(NeverReached) as refused:
        solve(put(UPRIGHT, TILT="0 deg"))
    assert "in equilibrium" in refused.value.fault.help
    fallen = solve(put(UPRIGHT, TILT="30 deg")).answers["n"].float
    assert fallen == pytest.approx(sqrt(3 * 9.8 / 0.8 * cos(radians(30))))


def test_an_angle_of_a_force_lies_within_a_turn() -> None:
    text = """
up: z
gravity: none
given: {F: unknown, q: unknown}
bodies: {b: {shape: cuboid, mass: 2 kg, sides: [1 m, 1 m, 1 m]}}
actions: {pull: {force: ["F*cos(q)", "F*sin(q)", 0 N], on: b}}
states: {now: {b.acceleration: [-3 m/s^2, -4 m/s^2, 0 m/s^2]}}
find: {F: F, q: q in deg}
"""
    assert solve(put(text)).answers["q"].float == pytest.approx(-126.8698976)


def test_a_given_g_beside_another_gravity_is_refused() -> None:
    text = (
        "\ngiven: {g: 5 m/s^2}\ngravity: 9 m/s^2\nbodies: {d: {mass: 2 kg, moves: down}}\nfind: {a: d.acceleration}\n"
    )
    with pytest.raises(SceneError, match="the given `g` is gravity already"):
        solve(put(text))
