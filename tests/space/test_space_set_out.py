"""In which sense a body in space sets out from a blow is told by where a later state has it, where it comes there in one sense alone; else
either is asked for by a letter. A rate that a state tells by a letter is none where the motion does not come there."""

from __future__ import annotations

import re

import pytest

from rotsolve import Unsolvable, solve

PELLET = """up: z
given: {M: 2 kg, l: 0.8 m, m: 0.1 kg, u: unknown}
bodies:
  rod: {shape: rod, mass: M, length: l, turned: {about: y, by: 90 deg}}
  pel: {shape: particle, mass: m}
connections: {h: {hinge: rod.start, along: y}}
states: {before: {rod.angle: 0 deg, at rest: rod, pel.velocity: [-u, 0, 0]}, after: {}, far: {FAR}}
events: {hit: {joins: [pel, rod.end], from: before, to: after}}
find: {u: u, w: rod.angular_velocity.y at after}
"""
IN_THE_PLANE = """given: {M: 2 kg, l: 0.8 m, m: 0.1 kg, u: unknown}
bodies: {rod: {shape: rod, mass: M, length: l}, pel: {shape: particle, mass: m}}
connections: {h: {hinge: rod.start}}
states: {before: {rod.angle: -90 deg, at rest: rod, pel.velocity: [u, 0]}, after: {}, far: {FAR}}
events: {hit: {joins: [pel, rod.end], from: before, to: after}}
find: {u: u, w: rod.angular_velocity at after}
"""
JUST_OVER, OVER = "rod.angle: ANGLE, rod.angular_velocity: 0 rad/s", "rod.angle: ANGLE, rod.angular_velocity: 1 rad/s"
BACK = "rod.angle: 90 deg, rod.angular_velocity: 1 rad/s"  # to which it comes in either sense


@pytest.mark.parametrize("far", [JUST_OVER, OVER])
@pytest.mark.parametrize("sense", [1, -1])
def test_only_one_sense_leads_over_the_top(far: str, sense: int) -> None:
    """The least speed by hand: ½ I ω² = (M + 2 m) g l, I = (M/3 + m) l², m u l = I ω."""
    far = far if sense > 0 else far.replace("velocity: ", "velocity: -")
    found = solve(PELLET.replace("FAR", far.replace("ANGLE", f"{180 * sense} deg")))
    plane = solve(IN_THE_PLANE.replace("FAR", far.replace("ANGLE", f"{90 if sense > 0 else -270} deg")))
    assert found.answers["u"].float == pytest.approx(plane.answers["u"].float, rel=1e-12)
    assert found.answers["w"].float == pytest.approx(plane.answers["w"].float, rel=1e-12)
    if "1 rad" not in far:
        inertia, energy = (2 / 3 + 0.1) * 0.8**2, 2.2 * 9.8 * 0.8
        assert found.answers["u"].float == pytest.approx(sense * (2 * energy * inertia) ** 0.5 / (0.1 * 0.8), rel=1e-12)


def test_a_speed_that_is_told_never_gets_it_to_its_balance() -> None:
    """What is sought is a limit; with just that speed it comes ever nearer."""
    text = PELLET.replace("FAR", JUST_OVER.replace("ANGLE", "180 deg")).replace(
        "pel.velocity: [-u", "pel.velocity: [-V"
    )
    text = text.replace("u: unknown", "g: 9.8 m/s^2, V: sqrt(2*g*l*(M + 2*m)*(M + 3*m)/3)/m").replace(
        "u: u, w: rod.angular_velocity.y at after", "F: h.force at far"
    )
    with pytest.raises(Unsolvable, match="`far` is never reached from `after`"):
        solve(text)


@pytest.mark.sampled(2)
@pytest.mark.parametrize(("word", "sense"), [("largest", 1), ("smallest", -1)])
def test_either_sense_is_asked_for_as_the_refusal_says(word: str, sense: int) -> None:
    text = PELLET.replace("FAR", BACK)
    with pytest.raises(Unsolvable, match="in which sense `rod` turns at `after` nothing tells") as refused:
        solve(text)
    line, given, find = re.findall(
        r"`(rod.angular_velocity: w_rod|w_rod: unknown|largest w_rod)`", refused.value.fault.help
    )
    text = text.replace("after: {}", f"after: {{{line}}}").replace("u: unknown", f"u: unknown, {given}")
    found = solve(text.replace("w: rod.angular_velocity.y at after", f"w_rod: {find.replace('largest', word)}"))
    rate = (1 + 3 * 9.8 * 2.2 / (0.8 * 2.3)) ** 0.5  # ½ I (ω² − 1) = ½ (M + 2 m) g l
    assert found.answers["w_rod"].float == pytest.approx(sense * rate, rel=1e-12)
    assert not any(item.holds is False for item in found.derivation.confirmed)


NODDING = """up: z
given: {m: 0.4 kg, l: 0.8 m, n: unknown}
bodies: {p: {shape: rod, mass: m, length: l}}
connections: {b: {ball: p.start}}
states:
  start: {p.tilt: 140 deg, p.precession: 5 rad/s, p.nutation: -1 rad/s}
  top: {p.tilt: smallest}
  back: {p.tilt: TILT, p.nutation: n}
find: {q: p.tilt at top in deg, n: WORDn, K: p.kinetic_energy at back}
"""


@pytest.mark.parametrize("word", ["", "largest "])
def test_a_letter_for_a_rate_where_the_motion_does_not_come_is_no_open_sense(word: str) -> None:
    found = solve(NODDING.replace("TILT", "130 deg").replace("WORD", word))
    assert found.answers["q"].float == pytest.approx(131.8, abs=0.05)
    assert "K" not in found.answers
    said = " ".join(f"{item.fault.message} {item.fault.help}" for item in found.derivation.refused)
    assert "`back` is never reached from `top`" in said
    assert "smallest n" not in said


def test_a_letter_for_a_rate_to_which_the_motion_comes() -> None:
    found = solve(NODDING.replace("TILT", "135 deg").replace("WORD", "largest "))
    assert found.answers["K"].float is not None
    assert found.answers["n"].float is not None
    assert found.answers["n"].float > 0


HANGING = """up: z
given: {M: 2 kg, L: 1 m, u: unknown}
bodies: {rod: {shape: rod, mass: M, length: L}}
connections: {pin: {hinge: rod.start, along: y}}
states: {down: {rod.angle: 90 deg, RATE}, struck: {}, up: {rod.angle: TOP deg, STANDS}}
events: {hit: {impulse: u, on: rod.end, direction: -x, from: down, to: struck}}
find: {u: u, w: rod.angular_velocity.y at struck}
"""


@pytest.mark.parametrize("stands", ["balance: true", "rod.angular_velocity: 0 rad/s"])
@pytest.mark.parametrize("sense", [1, -1])
def test_the_blow_that_is_sought_is_that_with_which_it_just_gets_to_its_balance(stands: str, sense: int) -> None:
    """By hand: ⅙ M L² ω² = M g L, u L = ⅓ M L² ω."""
    text = HANGING.replace("RATE", "at rest: rod").replace("TOP", f"{90 + 180 * sense}").replace("STANDS", stands)
    found = solve(text)
    assert found.answers["u"].float == pytest.approx(sense * 2 * (2 * 9.8 / 3) ** 0.5, rel=1e-12)
    assert found.answers["w"].float == pytest.approx(sense * (6 * 9.8) ** 0.5, rel=1e-12)
    told = text.replace("u: unknown", f"g: 9.8 m/s^2, u: {sense}*sqrt(2/3*g*L)*M")  # with that it comes ever nearer
    with pytest.raises(Unsolvable, match="`up` is never reached from `struck`"):
        solve(told[: told.index("find")] + "find: {F: pin.force at up}\n")


@pytest.mark.parametrize("asked", ["u", "largest u"])
def test_the_rate_that_is_sought_is_that_with_which_it_just_gets_to_its_balance(asked: str) -> None:
    """By hand: ⅙ M L² w² = ½ M g L from the level."""
    text = HANGING[: HANGING.index("events")].replace("angle: 90 deg, RATE", "angle: 180 deg, rod.angular_velocity: u")
    text = text.replace("struck: {}, ", "").replace("TOP", "270").replace("STANDS", "balance: true")
    found = solve(text + f"find: {{u: {asked}, F: pin.force.x at down}}\n")
    assert found.answers["u"].float == pytest.approx((3 * 9.8) ** 0.5, rel=1e-12)
    assert found.answers["F"].float == pytest.approx(29.4, rel=1e-12)  # ½ M L w², towards the hinge at +x
    with pytest.raises(Unsolvable, match="`up` is never reached from `down`"):
        told = text.replace("u: unknown", "g: 9.8 m/s^2, u: sqrt(3*g/L)")
        solve(told + "find: {F: pin.force at up}\n")


def test_two_balls_hold_a_body_as_a_hinge_does() -> None:
    text = HANGING.replace(
        "{shape: rod, mass: M, length: L}", "{shape: rectangle, mass: M, sides: [L, 2*L], points: PLACES}"
    )
    text = text.replace("PLACES", "{A: [-L/2, -L, 0], B: [-L/2, L, 0], end: [L/2, 0, 0]}").replace(
        "STANDS", "balance: true"
    )
    text = text.replace("{pin: {hinge: rod.start, along: y}}", "{p: {ball: rod.A}, q: {ball: rod.B}}").replace(
        "TOP", "270"
    )
    found = solve(text.replace("RATE", "at rest: rod"))
    assert found.answers["u"].float == pytest.approx(2 * (2 * 9.8 / 3) ** 0.5, rel=1e-12)
    assert found.answers["w"].float == pytest.approx((6 * 9.8) ** 0.5, rel=1e-12)
