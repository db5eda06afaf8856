"""The sense of a rate that a later state tells is held against the motion: what never turns back does not come there the other way.

By hand: ½ M q̇² is what is left of the energy, and what turns back does so where that vanishes. The assembly follows the motion.
"""

from __future__ import annotations

import math

import pytest

from rotsolve import Solution, Unsolvable, solve
from rotsolve.core.faults import NeverReached

ROD = """
up: z
given: {m: 2 kg, L: 0.8 m, w: RATE, g: 9.8 m/s^2, x: unknown}
bodies: {rod: {shape: rod, mass: m, length: L}}
connections: {pin: {hinge: rod.start, along: -y}}
states: {one: {rod.angle: FIRST, rod.angular_velocity: w}, later: {rod.angle: LAST, rod.angular_velocity: TOLD}}
find: {ASKED}
"""
LOW = "sqrt(w^2 - 3*g/L*(1 - sin(80 deg)))"  # by energy, 10° above the lowest place
HEIGHTS = math.sin(math.radians(20)) + math.sin(math.radians(40))
HIGH = "sqrt(w^2 - 3*g/L*(sin(20 deg) + sin(40 deg)))"
BEAD = """
up: z
given: {m: 0.5 kg, w: 4 rad/s, beta: 30 deg, r0: 0.3 m, r1: PLACE, u: START, v: LAST, g: 9.8 m/s^2}
bodies:
  arm: {mass: 0, points: {O: [0, 0, 0], P0: [r0*cos(beta), 0, r0*sin(beta)]}}
  bead: {shape: particle, mass: m}
connections:
  hub: {hinge: arm.O, along: z, angular_velocity: w}
  guide: {slide: [arm.P0, bead], along: [cos(beta), 0, sin(beta)]}
states:
  start: {"bead.velocity relative to arm": [u*cos(beta), 0, u*sin(beta)]}
  later: {"bead.position relative to arm": [r1*cos(beta), 0, r1*sin(beta)], "bead.velocity relative to arm": [v*cos(beta), 0, v*sin(beta)]}
find: {ASKED}
"""
DOOR = """
up: z
given: {m: kg, b: m, tau: N m, w: rad/s, f: rad}
bodies: {door: {shape: rod, mass: m, length: b}}
connections: {post: {hinge: door.start, along: z}}
actions: {push: {couple: [0, 0, SENSE tau], on: door}}
states: {start: {door.angle: 0 deg, door.angular_velocity: w}, later: {door.angle: f, door.angular_velocity: TOLD}}
find: {L: door.angular_momentum at later}
"""
SHAFT = """
up: z
given: {m: 2 kg, L: 0.8 m, b: 0.3 m, w: 6 rad/s, g: 9.8 m/s^2, q: unknown}
bodies:
  shaft: {mass: 0, points: {O: [0, 0, 0], E: [b, 0, 0]}}
  rod: {shape: rod, mass: m, length: L}
connections:
  axis: {hinge: shaft.O, along: z, angular_velocity: w}
  pin: {hinge: [shaft.E, rod.start], along: -y}
states:
  up: {rod.angle: 60 deg, rod.angular_velocity: 0 rad/s}
  low: {rod.angle: -30 deg}
  turn: {rod.angle: q, rod.angular_velocity: 0 rad/s}
find: {F: pin.force.y at low in shaft axes, th: q}
"""


def rod(first: str, rate: str, last: str, told: str, asked: str = "W: rod.angular_velocity.y at later") -> Solution:
    scene = ROD if told == "x" else ROD.replace(", x: unknown", "")
    for word, value in (("FIRST", first), ("RATE", rate), ("LAST", last), ("TOLD", told), ("ASKED", asked)):
        scene = scene.replace(word, value)
    return solve(scene).complete()


def bead(place: str, start: str, last: str, asked: str) -> Solution:
    scene = BEAD.replace("PLACE", place).replace("START", start).replace("LAST", last)
    return solve(scene.replace("ASKED", asked)).complete()


def confirmed(solution: Solution) -> float:
    """The number of the only answer, which is confirmed."""
    assert [item.holds for item in solution.derivation.confirmed] == [True]
    (answer,) = solution.derivation.answers
    assert answer.value is not None
    return answer.value.float


@pytest.mark.parametrize(
    ("first", "rate", "last", "told"),
    [
        ("-40 deg", "12 rad/s", "20 deg", f"-{HIGH}"),  # it goes right round
        ("-90 deg", "12 rad/s", "-90 deg", "-w"),
        ("20 deg", "-12 rad/s", "-40 deg", "sqrt(w^2 + 3*g/L*(sin(20 deg) + sin(40 deg)))"),
    ],
)
def test_what_goes_right_round_never_comes_back(first: str, rate: str, last: str, told: str) -> None:
    with pytest.raises(NeverReached, match="`rod` passes there in the other sense, and never turns back"):
        rod(first, rate, last, told)


@pytest.mark.parametrize("rate", ["4 rad/s", "-4 rad/s"])
@pytest.mark.parametrize("sense", [1, -1])
def test_what_swings_comes_by_in_either_sense(rate: str, sense: int) -> None:
    """The axis is −y: the sense on the hinge is the other one about y."""
    found = rod("-90 deg", rate, "-80 deg", LOW if sense == 1 else f"-{LOW}")
    assert confirmed(found) == pytest.approx(-sense * math.sqrt(16 - 36.75 * (1 - math.sin(math.radians(80)))))


def test_a_rate_that_can_have_one_sense_alone_is_found() -> None:
    assert confirmed(rod("-40 deg", "12 rad/s", "20 deg", "x", "x: x")) == pytest.approx(
        math.sqrt(144 - 36.75 * HEIGHTS)
    )
    with pytest.raises(Unsolvable, match="in which sense `rod` turns at `later` nothing tells"):
        rod("-90 deg", "4 rad/s", "-80 deg", "x", "x: x")


@pytest.mark.parametrize("start", ["0.5 m/s", "-0.2 m/s"])
def test_a_bead_that_slides_off_does_not_come_back(start: str) -> None:
    """W = m (g r sin β − ½ ω² r² cos² β) is largest at 0.408 m, 0.0704 J/kg above the start: ½ u² is more, or leads inwards."""
    with pytest.raises(NeverReached, match="`later` is never reached from `start`"):
        bead("r0", start, "-u", "N: guide.force.y at later in arm axes").complete()


def test_a_bead_that_turns_back_comes_by_again() -> None:
    """N = 2 m ω v cos β at the start, the other way round."""
    found = bead("r0", "0.2 m/s", "-u", "N: guide.force.y at later in arm axes")
    assert confirmed(found) == pytest.approx(-0.4 * 3**0.5)


def test_a_bead_turns_back_at_the_first_place_of_two() -> None:
    """6 r² − 4.9 r has what it has lost of ½ u² at 0.3167 m, and at 0.5 m, beyond the top between."""
    assert confirmed(bead("unknown", "0.2 m/s", "0 m/s", "r: r1")) == pytest.approx(0.95 / 3)


def test_a_rod_that_hangs_turns_back_on_its_way_the_first_time() -> None:
    """sin q = −1 + L w²/(3 g), 2.4° beyond the lowest place, and not as far before it."""
    scene = ROD.replace("RATE", "0.183 rad/s").replace("FIRST", "-90 deg").replace("LAST", "x")
    found = confirmed(solve(scene.replace("TOLD", "0 rad/s").replace("ASKED", "q: x")).complete())
    assert found == pytest.approx(-math.pi / 2 + math.acos(1 - 0.8 * 0.183**2 / 29.4))


@pytest.mark.parametrize("sense", ["", "-"])
def test_a_door_in_letters(sense: str) -> None:
    """A couple that drives it on never lets it back; one against it does."""
    told = f"-sqrt(w^2 {'-' if sense else '+'} 2*tau*f/(m*b^2/3))"
    scene = DOOR.replace("SENSE ", sense).replace("TOLD", told)
    if sense:
        assert [item.holds for item in solve(scene).complete().derivation.confirmed] == [True]
        return
    with pytest.raises(NeverReached, match="`later` is never reached from `start`"):
        solve(scene)


def test_a_turning_point_after_a_state_on_the_way() -> None:
    """From rest at 60° through −30° to where as much is left: not back at once to 60°. What lies before it is confirmed beside it."""
    solution = solve(SHAFT).complete()
    force, turn = solution.derivation.answers
    assert turn.value is not None and force.value is not None
    assert turn.value.float == pytest.approx(-3.08799, rel=1e-4)
    assert force.value.float == pytest.approx(-43.739, rel=1e-4)
    assert [item.holds for item in solution.derivation.confirmed] == [True, None]


LEVEL = """
up: z
gravity: none
given: {m: 0.1 kg, w: 4 rad/s, V: unknown}
bodies: {arm: {mass: 0, points: {O: [0, 0, 0], P: [-0.3 m, 0, 0]}}, bead: {shape: particle, mass: m}}
connections: {shaft: {hinge: arm.O, along: -z, angular_velocity: w}, guide: {slide: [arm.P, bead], along: ALONG}}
states:
  start: {bead.velocity relative to arm: [-2 m/s, 0, 0]}
  later: {bead.position relative to arm: [-0.9 m, 0, 0], bead.velocity relative to arm: [V, 0, 0]}
find: {V: V}
"""


@pytest.mark.parametrize("along", ["x", "-x"])
def test_a_component_told_by_a_letter_has_the_only_sense_in_which_the_motion_comes_there(along: str) -> None:
    """v² = u² + w² (r₁² − r₀²) outwards, however the slide is drawn; inwards it goes through the axis and on."""
    solution = solve(LEVEL.replace("ALONG", along))
    assert solution.answers["V"].float == pytest.approx(-math.sqrt(4 + 16 * 0.72))
    assert all(item.holds for item in solution.derivation.confirmed)
    with pytest.raises(NeverReached, match="never turns back"):
        solve(LEVEL.replace("ALONG", along).replace("[-2 m/s", "[2 m/s"))
