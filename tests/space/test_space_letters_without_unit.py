"""A letter `unknown` has the only unit with which its formulas go together, and in a direction that of the other components.

By hand: a door M at 0.5 m from its hinge, held at 1 m by 100 N along [-b, a, z], has 100 N z/√(a² + b² + z²) = M g/2.
"""

from __future__ import annotations

import math

import pytest

from rotsolve import solve
from rotsolve.language.limited import letters_of_places
from rotsolve.scene.read import read_text

LUMP = """up: z
given: {x: unknown, c: 1 m}
bodies:
  see:
    parts:
      a: {shape: particle, mass: 2 kg, at: [-0.5 m, 0, 0]}
      b: {shape: particle, mass: 4 kg, at: [PLACE, 0 m, -0.1 m]}
    points: {O: [0, 0, 0]}
connections: {h: {hinge: see.O, along: y}}
states: {rest: {see.angle: 0 deg, balance: true}}
find: {x: ASKED}
"""
DOOR = """up: z
given: {M: 12 kg, z: unknown, g: 9.8 m/s^2, a: 0.3 m, b: 0.7 m}
bodies: {door: {shape: rectangle, mass: M, sides: [1 m, 0.8 m], points: {H: [-0.5 m, 0, 0], C: [0.5 m, 0.4 m, 0]}}}
connections: {h: {hinge: door.H, along: y, bearings: [-0.3 m, 0.3 m]}}
actions: {rope: {force: 100 N, on: door.C, direction: WAY}}
states: {rest: {door.angle: 0 deg, balance: true}}
find: {z: ASKED}
"""


@pytest.mark.parametrize("place", ["(x*x - x*c/10)/c", "x*x/c - x/10"])
@pytest.mark.parametrize(("asked", "way"), [("smallest x", -1), ("largest x", 1)])
def test_a_letter_that_is_squared_has_its_unit(place: str, asked: str, way: int) -> None:
    (answer,) = solve(LUMP.replace("PLACE", place).replace("ASKED", asked)).derivation.answers
    assert answer.value is not None
    assert answer.value.float == pytest.approx((0.1 + way * math.sqrt(0.01 + 1)) / 2)
    assert answer.dimension is not None
    assert answer.dimension.length == 1


@pytest.mark.parametrize(
    ("way", "square"), [("[-b, a, z]", 0.3**2 + 0.7**2), ("[-1, 0, z/(1 m)]", 1.0), ("[-b, 0 m, z]", 0.7**2)]
)
def test_a_component_of_a_direction_has_the_unit_of_the_rest(way: str, square: float) -> None:
    (answer,) = solve(DOOR.replace("WAY", way).replace("ASKED", "z")).derivation.answers
    share = 12 * 9.8 / 2 / 100
    assert answer.value is not None
    assert answer.value.float == pytest.approx(share * math.sqrt(square / (1 - share**2)))
    assert answer.dimension is not None
    assert answer.dimension.length == 1


def test_a_component_of_a_direction_may_be_negative() -> None:
    text = DOOR.replace("WAY", "[-1, 0, (z*z - z*(0.5 m))/(1 m^2)]")
    assert letters_of_places(read_text(text.replace("ASKED", "z"))) >= {"z"}
    share = 12 * 9.8 / 2 / 100
    up = share / math.sqrt(1 - share**2)
    for word, way in (("smallest", -1), ("largest", 1)):
        found = solve(text.replace("ASKED", f"{word} z"))
        assert found.answers["z"].float == pytest.approx((0.5 + way * math.sqrt(0.25 + 4 * up)) / 2)
        assert [item.holds for item in found.derivation.confirmed] == [True]
