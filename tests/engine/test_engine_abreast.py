"""Two bodies on one slope, and two that hang: a string or spring between them is drawn from left to right, or from above down."""

from itertools import product
from math import cos, radians, sin

import pytest

from rotsolve.pipeline import solve

G, M, N, MU, NU, SLOPE = 9.8, 3.0, 1.4, 0.1, 0.4, radians(35)


def tension(first_is_upper: bool, rolls: bool) -> tuple[float, float]:
    """How both slide down together, and the pull of the string on the body named `one`, which lies above or below."""
    drag, inertia = (0.0, 1.4 * N) if rolls else (NU * N * G * cos(SLOPE), N)
    down = ((M + N) * G * sin(SLOPE) - MU * M * G * cos(SLOPE) - drag) / (M + inertia)
    held = M * down - M * G * sin(SLOPE) + MU * M * G * cos(SLOPE)  # down the slope, on `one`
    return down, held if first_is_upper else -held


@pytest.mark.sampled(3)
@pytest.mark.parametrize(("falls", "rolls", "along"), list(product(("left", "right"), (False, True), (False, True))))
@pytest.mark.parametrize("moves", [("up", "up"), ("down", "down"), ("up", "down")])
@pytest.mark.parametrize("backwards", [False, True])
def test_the_earlier_named_of_two_on_a_slope_stands_on_the_left(falls, rolls, along, moves, backwards):
    """The string is slack just where the lower body lags behind."""
    other = "shape: sphere, radius: 0.1 m, " if rolls else ""
    names = ["one", "two.center" if rolls else "two"][:: -1 if backwards else 1]
    solution = solve(f"""title: Two bodies on a slope
surfaces: {{ramp: {{slope: 35 deg, down: {falls}}}}}
bodies: {{one: {{mass: {M} kg, moves: {moves[0]}}}, two: {{{other}mass: {N} kg, moves: {moves[1]}}}}}
connections:
  below: {{contact: [one, ramp], friction: {MU}}}
  touch: {{{"rolls: [two, ramp]" if rolls else f"contact: [two, ramp], friction: {NU}"}}}
  tie: {{string: [{", ".join(names)}]{", along: ramp" if along else ""}}}
states: {{start: {{at rest: all}}}}
find: {{a: one.acceleration at start, T: tie.tension at start}}
""")
    upper = backwards != (falls == "right")
    down, pull = tension(upper, rolls)
    assert solution.answers["T"].float == pytest.approx(pull)
    assert all(item.holds for item in solution.derivation.checks) == (pull > 0)
    assert ("a" in solution.answers) == (
        pull > 0
    )  # a string that would push lets go: no acceleration is answered with it
    if pull > 0:
        assert solution.answers["a"].float == pytest.approx(down if moves[0] == "down" else -down)
        assert all(item.holds for item in solution.derivation.confirmed)


@pytest.mark.parametrize(("falls", "backwards"), list(product(("left", "right"), (False, True))))
def test_pulls_says_otherwise(falls, backwards):
    """`pulls` names the way in which one of them is pulled, in whatever order they stand."""
    names = ["one", "two"][:: -1 if backwards else 1]
    for way, sign in (("down", 1), ("up", -1)):
        solution = solve(f"""title: Two bodies on a slope
surfaces: {{ramp: {{slope: 35 deg, down: {falls}}}}}
bodies: {{one: {{mass: {M} kg, moves: up}}, two: {{mass: {N} kg, moves: up}}}}
connections:
  below: {{contact: [one, ramp], friction: {MU}}}
  touch: {{contact: [two, ramp], friction: {NU}}}
  tie: {{string: [{", ".join(names)}], pulls: {{one: {way}}}}}
states: {{start: {{at rest: all}}}}
find: {{T: tie.tension at start}}
""")
        assert solution.answers["T"].float == pytest.approx(sign * tension(True, False)[1])
        assert all(item.holds for item in solution.derivation.confirmed)


SPRINGS = [  # surface, contacts, moves, ends of the spring, which way a stretched one pulls `one` (along its positive way) and `two`
    ("ramp: {slope: 35 deg, down: right}", ("one", "two"), "down", "[one, two]", (1, -1)),
    ("ramp: {slope: 35 deg, down: right}", ("one", "two"), "down", "[two, one]", (-1, 1)),
    ("ramp: {slope: 35 deg, down: left}", ("one", "two"), "down", "[one, two]", (-1, 1)),
    ("ramp: {slope: 35 deg, down: left}", ("one", "two"), "up", "[one, two]", (1, -1)),
    ("ramp: level", ("one", "two"), "right", "[one, two]", (1, -1)),
    ("ramp: level, side: {wall: right}", ("one", "two"), "right", "[side, one]", (1, 0)),
    ("ramp: level, side: {wall: right}", ("one", "two"), "right", "[one, side]", (1, 0)),
    ("ramp: level, side: {wall: left}", ("one", "two"), "right", "[one, side]", (-1, 0)),
    ("ramp: {slope: 35 deg, down: left}, side: {wall: right}", ("one", "two"), "down", "[side, one]", (-1, 0)),
    ("ramp: level", (), "down", "[one, two]", (1, -1)),
    ("ramp: level", (), "down", "[two, one]", (-1, 1)),
    ("ramp: level", (), "up", "[one, two]", (-1, 1)),
    ("ramp: level", (), "up", "[ceiling, two]", (0, 1)),
    ("ramp: level", (), "up", "[two, ground]", (0, -1)),
]


@pytest.mark.parametrize(("surfaces", "lying", "moves", "ends", "pulled"), SPRINGS)
def test_a_spring_is_drawn_from_left_to_right_or_down(surfaces, lying, moves, ends, pulled):
    """A stretched spring draws its ends together."""
    contacts = "".join(f"  on_{name}: {{contact: [{name}, ramp]}}\n" for name in lying)
    solution = solve(f"""title: A spring between two bodies
surfaces: {{{surfaces}}}
bodies: {{one: {{mass: {M} kg, moves: {moves}}}, two: {{mass: {N} kg, moves: {moves}}}}}
connections:
{contacts}  coil: {{spring: {ends}, stiffness: 50 N/m}}
states: {{start: {{at rest: all, coil.elongation: 0.1 m}}}}
find: {{p: one.acceleration at start, q: two.acceleration at start}}
""")
    fall = (G * sin(SLOPE) if "slope" in surfaces else 0.0 if lying else G) * (-1 if moves == "up" else 1)
    assert solution.answers["p"].float == pytest.approx(fall + pulled[0] * 5 / M)
    assert solution.answers["q"].float == pytest.approx(fall + pulled[1] * 5 / N)
    assert all(item.holds for item in solution.derivation.confirmed)
