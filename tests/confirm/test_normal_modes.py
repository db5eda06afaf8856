"""Normal modes, swings on carriers and damped swings by another way: M and K by hand, eigenvalues by mpmath, and what is refused."""

from __future__ import annotations

import math

import mpmath
import pytest

import rotsolve
from rotsolve.core.faults import Unsolvable

G = 9.8
CHAIN = """title: Three blocks in a row
given: {{a: {0} kg, b: {1} kg, c: {2} kg, k: {3} N/m, p: {4} N/m, q: {5} N/m}}
surfaces: {{floor: level}}
bodies: {{one: {{mass: a, moves: right}}, two: {{mass: b, moves: left}}, three: {{mass: c, moves: right}}}}
connections:
  b1: {{contact: [one, floor]}}
  b2: {{contact: [two, floor]}}
  b3: {{contact: [three, floor]}}
  s1: {{spring: [ground, one], stiffness: k}}
  s2: {{spring: [one, two], stiffness: p}}
  s3: {{spring: [two, three], stiffness: q}}
find:
  w1: angular_frequency of mode 1
  w2: angular_frequency of mode 2
  w3: angular_frequency of mode 3
  r: ratio of two.displacement to one.displacement in mode 2
"""
RODS = """title: Two rods
given: {m: 1 kg, L: 50 cm}
bodies: {one: {shape: rod, mass: m, length: L}, two: {shape: rod, mass: m, length: L}}
connections: {nail: {hinge: one.start}, pin: {hinge: [one.end, two.start]}}
"""
BLOCK = """title: Block in oil
given: {m: 2 kg, k: 50 N/m, b: DAMPING}
surfaces: {floor: level}
bodies: {block: {mass: m, moves: right}}
connections: {base: {contact: [block, floor]}, coil: {spring: [ground, block], stiffness: k}}
actions: {oil: {force: FORCE, on: block, direction: right}}
"""
LIFT = """title: Rod in a lift
given: {L: 1 m, m: 500 g, a: 2 m/s^2}
bodies: {lift: {mass: 100 kg, CARRIED}, rod: {shape: rod, mass: m, length: L}}
connections: {hook: {hinge: [lift, rod.start]}}
find: {T: period of small swings}
"""


def number(solution: rotsolve.Solution, name: str) -> float:
    value = solution.answers[name].value
    assert value is not None
    return float(value)


@pytest.mark.parametrize("numbers", [(1, 2, 5, 10, 30, 10), (3, 1, 1, 7, 2, 11), (2, 2, 2, 5, 5, 5)])
def test_three_blocks_swing_as_their_matrices_tell(numbers: tuple[int, ...]) -> None:
    a, b, c, k, p, q = numbers
    stiffness = mpmath.matrix([[k + p, -p, 0], [-p, p + q, -q], [0, -q, q]])
    roots = mpmath.matrix([[mpmath.sqrt(m if i == j else 0) for j in range(3)] for i, m in enumerate((a, b, c))])
    squares, shapes = mpmath.eigsy(roots**-1 * stiffness * roots**-1)
    solution = rotsolve.solve(CHAIN.format(*numbers))
    for place in range(3):
        assert number(solution, f"w{place + 1}") == pytest.approx(float(mpmath.sqrt(squares[place])), rel=1e-3)
    shape = roots**-1 * shapes
    assert number(solution, "r") == pytest.approx(
        -float(shape[1, 1] / shape[0, 1]), rel=1e-3
    )  # `two` counts to the left


def test_a_rod_pendulum_of_two_has_the_ratios_of_its_rows() -> None:
    solution = rotsolve.solve(
        RODS + "find: {w: angular_frequency of mode 2, r: ratio of two.rotation to one.rotation in mode 2}"
    )
    square = 3 * G / (7 * 0.5) * (7 + 2 * math.sqrt(7))
    assert number(solution, "w") == pytest.approx(math.sqrt(square), rel=1e-3)
    assert number(solution, "r") == pytest.approx((1.5 * G - 4 / 3 * 0.5 * square) / (0.5 * 0.5 * square), rel=1e-3)


@pytest.mark.parametrize(
    ("carried", "pull"),
    [
        ("acceleration: [0, a]", G + 2),
        ("acceleration: [a, 0 m/s^2]", math.hypot(G, 2)),
        ("acceleration: [a, -a]", math.hypot(G - 2, 2)),
        ("velocity: [3 m/s, 0 m/s]", G),
    ],
)
def test_a_rod_on_a_carrier_swings_under_what_it_seems_to_weigh(carried: str, pull: float) -> None:
    solution = rotsolve.solve(LIFT.replace("CARRIED", carried))
    assert number(solution, "T") == pytest.approx(2 * math.pi * math.sqrt(2 / (3 * pull)), rel=1e-3)


@pytest.mark.parametrize("damping", [4.0, 20.0, 30.0])
def test_damped_swings_have_three_cases(damping: float) -> None:
    scene = BLOCK.replace("DAMPING", f"{damping} kg/s").replace("FORCE", "-b*block.velocity")
    solution = rotsolve.solve(scene + "find: {z: damping_ratio of small swings, tau: time_constant of small swings}")
    gamma = damping / 4
    assert number(solution, "z") == pytest.approx(gamma / 5, rel=1e-3)
    slowest = gamma - math.sqrt(max(gamma**2 - 25, 0.0))
    assert number(solution, "tau") == pytest.approx(1 / slowest, rel=1e-3)
    period = scene + "find: {T: period of small swings, d: logarithmic_decrement of small swings}"
    if gamma < 5:
        found = 2 * math.pi / math.sqrt(25 - gamma**2)
        assert number(rotsolve.solve(period), "T") == pytest.approx(found, rel=1e-3)
        assert number(rotsolve.solve(period), "d") == pytest.approx(gamma * found, rel=1e-3)
    else:
        with pytest.raises(Unsolvable, match="has no period"):
            rotsolve.solve(period)


UP = "states: {up: {one.angle: 90 deg, two.angle: 90 deg, balance: true}}\n"
ASLANT = "states: {up: {one.angle: -60 deg, two.angle: -90 deg, balance: true}}\n"
REFUSED = {
    "unstable": (RODS + UP + "find: {w: period of mode 1 about up}", "the equilibrium is unstable"),
    "no equilibrium": (RODS + ASLANT + "find: {w: period of mode 1 about up}", "not in equilibrium"),
    "several": (RODS + "find: {w: period of small swings}", "swing in 2 ways"),
    "too many": (RODS + "find: {w: period of mode 3}", "have 2 modes"),
    "no amplitude": (RODS + "find: {r: ratio of one.velocity to two.rotation in mode 1}", "has no amplitude"),
    "growing": (
        BLOCK.replace("DAMPING", "4 kg/s").replace("FORCE", "b*block.velocity") + "find: {T: period of small swings}",
        "they grow",
    ),
    "square": (
        BLOCK.replace("DAMPING", "4 kg/m").replace("FORCE", "-b*block.velocity^2")
        + "find: {T: period of small swings}",
        "not proportional",
    ),
    "by the way gone": (
        BLOCK.replace("DAMPING", "4 N/m").replace("FORCE", "-b*block.displacement")
        + "find: {T: period of small swings}",
        "has gone since the first state",
    ),
    "undamped": (
        BLOCK.replace("DAMPING", "4 N").replace("FORCE", "b") + "find: {z: damping_ratio of small swings}",
        "nothing damps",
    ),
    "led in time": (LIFT.replace("CARRIED", "acceleration: [0, a*time/(1 s)]"), "constant acceleration"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_can_not_be_is_refused_by_name(name: str) -> None:
    scene, words = REFUSED[name]
    with pytest.raises((Unsolvable, rotsolve.SceneError), match=words):
        rotsolve.solve(scene)


def test_a_ratio_in_modes_of_one_frequency_is_not_told() -> None:
    scene = """title: Three discs in a ring
gravity: none
given: {I: 2 kg m^2, c: 120 N m/rad}
bodies: {one: {inertia: I}, two: {inertia: I}, three: {inertia: I}}
connections:
  axle: {axle: [one, two, three]}
  s1: {torsion: [one, two], stiffness: c}
  s2: {torsion: [two, three], stiffness: c}
  s3: {torsion: [one, three], stiffness: c}
find: {r: ratio of one.rotation to two.rotation in mode 1}
"""
    with pytest.raises(Unsolvable, match="the same frequency"):
        rotsolve.solve(scene)


@pytest.mark.parametrize(("ratio", "exact"), [("1", "2 √(I κ)"), ("0.5", "√(I κ)")])
def test_a_plain_number_of_a_condition_is_put_in(ratio: str, exact: str) -> None:
    scene = f"""
title: a disc on a wire in oil
gravity: none
given: {{I: kg m^2, kappa: N m/rad, b: N m s}}
bodies: {{disc: {{inertia: I}}}}
connections: {{axle: {{axle: disc}}, wire: {{torsion: disc, stiffness: kappa}}}}
actions: {{oil: {{couple: -b*disc.angular_velocity, on: disc}}}}
find: {{c: b where (damping_ratio of small swings) = {ratio}}}
"""
    assert rotsolve.solve(scene).answers["c"].exact == exact


def test_a_restitution_of_one_is_put_in() -> None:
    scene = """
title: a ball against another one
given: {m: kg, M: kg, u: m/s}
surfaces: {ice: level}
bodies: {one: {mass: m, moves: right}, two: {mass: M, moves: right}}
connections: {a: {contact: [one, ice]}, b: {contact: [two, ice]}}
states: {before: {one.velocity: u, at rest: two}, after: {}}
events: {hit: {collides: [one, two], restitution: 1, from: before, to: after}}
find: {v: one.velocity at after}
"""
    assert rotsolve.solve(scene).answers["v"].exact == "u (m − M)/(m + M)"


def test_where_an_answer_is_not_real_it_is_not_checked() -> None:
    """Without a lever, b → 0, the rod has no swings, and w no value."""
    scene = """
title: a rod with a spring and a dashpot
given: {m: kg, l: m, b: m, k: N/m, c: N s/m}
bodies: {rod: {shape: rod, mass: m, length: l}}
connections: {A: {hinge: rod.start}, B: {spring: [ground, rod.at(b)], stiffness: k}}
actions: {dash: {couple: -c*l^2*rod.angular_velocity, on: rod}}
states: {level: {rod.angle: 0, balance: true}}
find: {w: angular_frequency of small swings of rod about level}
"""
    assert "√(−" not in rotsolve.solve(scene).to("text")
