"""Small swings of a body that is named: all that moves with it swings, bodies without a mass and those on the same spring too."""

from __future__ import annotations

from math import acos, hypot, isclose, pi, sqrt

import pytest

from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

SPRING = """
title: two bodies on one spring
plane: horizontal
given: {M: 5 kg, m: 2 kg, k: 100 N/m}
bodies: {a: {mass: m, moves: right}, b: {mass: M, moves: left}}
connections: {s: {spring: [a, b], stiffness: k}}
find: {w: angular_frequency of small swings of WHICH}
"""
BOB = """
title: a bob on a rod without a mass
given: {m: 2 kg, l: 0.7 m}
bodies: {string: {shape: rod, mass: 0, length: l}, bob: {mass: m}}
connections: {pin: {hinge: string.start}, knot: {weld: [string.end, bob]}}
find: {w: angular_frequency of small swings of WHICH}
"""
CART = """
title: the same on a cart
given: {M: 3 kg, m: 2 kg, l: 0.7 m}
bodies: {cart: {mass: M, moves: right}, string: {shape: rod, mass: 0, length: l}, bob: {mass: m}}
connections: {pin: {hinge: [cart, string.start]}, knot: {weld: [string.end, bob]}}
find: {w: angular_frequency of small swings of WHICH}
"""
SWINGS = {
    SPRING: (("a", "b"), sqrt(100 * 7 / 10)),
    BOB: (("string", "bob"), sqrt(9.8 / 0.7)),
    CART: (("string", "bob", "cart"), sqrt(9.8 / 0.7 * 5 / 3)),
}


@pytest.mark.parametrize(
    ("scene", "which", "rate"), [(scene, which, rate) for scene, (names, rate) in SWINGS.items() for which in names]
)
def test_all_that_moves_with_the_named_body_swings(scene: str, which: str, rate: float) -> None:
    found = solve(scene.replace("WHICH", which))
    assert isclose(found.answers["w"].float, rate, rel_tol=1e-9)
    assert [item.holds for item in found.derivation.confirmed] == [True]


CORNER = """
title: a cylinder in a corner under a couple
given: {m: 2 kg, R: 10 cm, k: 0.3, tau: unknown}
surfaces: {floor: level, side: {wall: left}}
bodies: {cyl: {shape: cylinder, mass: m, radius: R, turns: counterclockwise}}
connections: {base: {contact: [cyl, floor], friction: k}, flank: {contact: [cyl, side], friction: k}}
actions: {hand: {couple: tau, on: cyl}}
states: {rest: {balance: true}}
find: {tau: largest tau where base sticks}
"""
FRAME = """
title: two rods that lean on each other
given: {m: 2 kg, M: 6 kg, L: 0.7 m, th: 60 deg, mu: GIVEN}
surfaces: {floor: level}
bodies: {a: {shape: rod, mass: m, length: L}, b: {shape: rod, mass: M, length: L}}
connections:
  C: {hinge: [a.end, b.end]}
  A: {contact: [a.start, floor], friction: mu}
  B: {contact: [b.start, floor], friction: mu}
states: {rest: {a.angle: th, b.angle: 180 deg - th, balance: true}}
find: {FIND}
"""


def test_the_largest_couple_that_friction_holds_is_confirmed() -> None:
    found = solve(CORNER)
    assert isclose(found.answers["tau"].float, 0.3 * 2 * 9.8 * 0.1 * 1.3 / 1.09, rel_tol=1e-9)
    assert [item.holds for item in found.derivation.confirmed] == [True]


def test_where_friction_does_not_suffice_the_reason_says_so() -> None:
    found = solve(FRAME.replace("GIVEN", "0.3").replace("FIND", "N: A.normal_force at rest"))
    assert [item.why for item in found.derivation.confirmed] == ["`rest` is not in balance as it stands"]


HOOP = """
title: a bead on a hoop that turns slowly
given: {m: kg, R: 0.1 m, w: 3 rad/s, theta: unknown}
bodies: {bead: {mass: m}, radius: {shape: rod, mass: 0, length: R}}
connections: {knot: {weld: [radius.end, bead]}, hub: {shaft: radius.start, turning: w}}
states: {round: {radius.angle: theta - 90 deg, steady: true}}
find: {theta: theta}
"""


def test_a_letter_that_is_none_is_told_by_the_states_too() -> None:
    """Beside θ = 0, not beside a thousandth of it, nothing is steady."""
    found = solve(HOOP)
    assert found.answers["theta"].float == 0.0
    assert [item.holds for item in found.derivation.confirmed] == [True]


DRAG = """
title: a bead on an upright wire against a drag along its way
given: {m: 2 kg, R: 0.3 m, c: 3 N s/m}
surfaces: {ring: {wire: R}}
bodies: {bead: {mass: m, moves: right}}
connections: {touch: {contact: [bead, ring]}}
actions: {drag: {force: -c*bead.velocity, on: bead, direction: tangential}}
find: {T: period of small swings, z: damping_ratio of small swings}
"""
PUSH = """
title: a bead pushed round a quarter of a wire
gravity: none
given: {m: 2 kg, R: 0.3 m, F: 3 N}
surfaces: {ring: {wire: R}}
bodies: {bead: {mass: m, moves: right}}
connections: {touch: {contact: [bead, ring]}}
actions: {push: {force: F, on: bead, direction: tangential}}
states: {s: {touch.angle: -90 deg, at rest: all}, e: {touch.angle: 0 deg}}
find: {v: bead.velocity at e}
"""


def test_what_is_tangential_at_the_centre_goes_along_the_way() -> None:
    """γ = c/(2 m) and ω₀² = g/R; over a quarter of the ring the push does the work F R π/2."""
    found, free, damping = solve(DRAG), 9.8 / 0.3, 3 / 4
    assert isclose(found.answers["T"].float, 2 * pi / sqrt(free - damping**2), rel_tol=1e-9)
    assert isclose(found.answers["z"].float, damping / sqrt(free), rel_tol=1e-9)
    pushed = solve(PUSH)
    assert isclose(pushed.answers["v"].float, sqrt(pi * 3 * 0.3 / 2), rel_tol=1e-9)
    assert [item.holds for one in (found, pushed) for item in one.derivation.confirmed] == [True] * 3


def test_at_the_centre_nothing_is_clockwise() -> None:
    with pytest.raises(Unsolvable, match="at the centre of `bead`, where no direction is clockwise"):
        solve(DRAG.replace("tangential", "clockwise"))


COLLAR = """
title: a collar on an upright guide, drawn by a spring from a place
given: {m: 2 kg, d: 0.3 m, k: 300 N/m, l: 0.25 m}
bodies: {collar: {mass: m, moves: down}}
connections: {coil: {spring: [[-d, 0], collar], stiffness: k, rest_length: l}}
find: {w: angular_frequency of small swings of collar}
"""


def test_a_spring_from_a_place_drives_a_collar_back() -> None:
    """k y (1 − l/√(d² + y²)) = m g tells where it rests, and m w² is how fast that grows with y; without a rest length k itself."""
    low, high = 0.0, 1.0
    for _ in range(100):
        middle = (low + high) / 2
        pull = 300 * middle * (1 - 0.25 / hypot(0.3, middle))
        low, high = (middle, high) if pull < 2 * 9.8 else (low, middle)
    slope = 300 * (1 - 0.25 * 0.3**2 / hypot(0.3, low) ** 3)
    found = solve(COLLAR)
    assert isclose(found.answers["w"].float, sqrt(slope / 2), rel_tol=1e-6)
    assert [item.holds for item in found.derivation.confirmed] == [True]
    letters = COLLAR.replace("m: 2 kg, d: 0.3 m, k: 300 N/m, l: 0.25 m", "m: kg, d: m, k: N/m")
    found = solve(letters.replace("rest_length: l", "rest_length: 0"))
    assert found.answers["w"].exact == "√(k/m)"
    assert [item.holds for item in found.derivation.confirmed] == [True]


def test_a_collar_beside_a_spring_in_balance_swings_by_its_stretch_alone() -> None:
    level = COLLAR.replace("moves: down", "moves: right").replace("[-d, 0]", "[0, d]")
    found = solve(level.replace("find:", "states: {rest: {collar.displacement: 0, balance: true}}\nfind:"))
    assert isclose(found.answers["w"].float, sqrt(300 * (1 - 0.25 / 0.3) / 2), rel_tol=1e-9)
    assert [item.holds for item in found.derivation.confirmed] == [True]


def test_of_several_equilibria_none_is_taken() -> None:
    """A spring that is longer than its place is away may hold the collar on either side, with another frequency on each."""
    with pytest.raises(Unsolvable, match="may be in equilibrium at 3 places"):
        solve(COLLAR.replace("m: 2 kg, d: 0.3 m", "m: 0.2 kg, d: 0.2 m"))


def test_a_place_that_is_not_stable_is_no_rival_of_one_that_is() -> None:
    """Where the hoop turns fast the bead stands steadily below as well, but does not stay there."""
    found = solve(HOOP.replace("w: 3 rad/s", "w: 20 rad/s"))
    assert isclose(found.answers["theta"].float, acos(9.8 / (0.1 * 20**2)), rel_tol=1e-9)
    assert [item.holds for item in found.derivation.confirmed] == [True]
