"""Bodies that turn as one: each counts turns along its own sense."""

from __future__ import annotations

import pytest

from rotsolve import Unsolvable, solve

WELD = """
title: Two discs that are welded to each other
given: {{I: 2 kg m^2, J: 3 kg m^2, W: 4 rad/s}}
bodies: {{A: {{inertia: I{first}}}, B: {{inertia: J{second}}}}}
connections: {{axle: {{axle: [A, B]}}, pin: {{weld: [A, B]}}}}
actions: {{motor: {{couple: 5 N m, on: A}}}}
states: {{now: {{A.angular_velocity: W}}, later: {{time: 4 s}}}}
find:
  v: B.angular_velocity at now
  L: A.angular_momentum at now
  M: B.angular_momentum at now
  r: A.rotation from now to later
  s: B.rotation from now to later
  Q: B.torque at now
"""
JOIN = """
title: A disc at rest is joined to one that turns
given: {{I: 2 kg m^2, J: 3 kg m^2, w: 10 rad/s}}
bodies: {{A: {{inertia: I{first}}}, B: {{inertia: J{second}}}}}
connections: {{axle: {{axle: [A, B]}}}}
states: {{before: {{A.angular_velocity: w, B.angular_velocity: 0}}, after: {{}}}}
events: {{pin: {{joins: [{order}], from: before, to: after}}}}
find: {{W: {asked} at after}}
"""
SENSES = ("", ", turns: counterclockwise", ", turns: clockwise")


def along(sense: str) -> int:
    return -1 if "clockwise" in sense.replace(",", "").split() else 1


@pytest.mark.parametrize("first", SENSES)
@pytest.mark.parametrize("second", SENSES)
def test_welded_bodies_count_turns_each_along_its_own_sense(first: str, second: str) -> None:
    answers = solve(WELD.format(first=first, second=second)).answers
    way = along(first) * along(second)
    found = {name: answer.float for name, answer in answers.items()}
    # 4 rad/s and 1 rad/s² along A's sense, for 4 s
    assert found == pytest.approx({"v": 4 * way, "L": 8, "M": 12 * way, "r": 24, "s": 24 * way, "Q": 3 * way})


@pytest.mark.parametrize("order", ["A, B", "B, A"])
@pytest.mark.parametrize("asked", ["A.angular_velocity", "B.angular_velocity"])
@pytest.mark.parametrize("second", SENSES)
def test_the_order_of_names_decides_nothing(order: str, asked: str, second: str) -> None:
    """I w = (I + J) W; along B's own sense the other way round."""
    scene = JOIN.format(first="", second=second, order=order, asked=asked)
    found = solve(scene).answers["W"].float
    assert found == pytest.approx(-4 if second == SENSES[2] and asked.startswith("B") else 4)


ONTO_A_CART = """
given: {m: 4 kg, M: 5 kg, u: 2 m/s}
bodies: {cart: {mass: m, moves: right}, stone: {mass: M, MOVES}}
states: {start: {cart.velocity: u, stone.velocity: FALLS}, after: {}}
events: {hit: {joins: [PAIR], from: start, to: after}}
find: {v: cart.velocity at after, a: cart.acceleration at after}
"""


@pytest.mark.parametrize("pair", ["stone, cart", "cart, stone"])
@pytest.mark.parametrize(
    ("moves", "falls", "brings"), [("moves: down", "3 m/s", 0), ("shape: particle", "[-1 m/s, -3 m/s]", -1)]
)
def test_what_falls_on_a_cart_goes_on_with_it_whoever_is_named_first(
    pair: str, moves: str, falls: str, brings: float
) -> None:
    """The ground bears the cart: along it m u + M v_x is kept."""
    found = solve(ONTO_A_CART.replace("MOVES", moves).replace("FALLS", falls).replace("PAIR", pair))
    assert found.answers["v"].float == pytest.approx((4 * 2 + 5 * brings) / 9)
    assert found.answers["a"].float == 0
    assert all(item.holds for item in found.derivation.confirmed)


@pytest.mark.parametrize("pair", ["stone, cart", "cart, stone"])
@pytest.mark.parametrize(("moves", "falls"), [("moves: up", "3 m/s"), ("shape: particle", "[-1 m/s, 3 m/s]")])
def test_what_comes_from_below_would_lift_a_cart(pair: str, moves: str, falls: str) -> None:
    with pytest.raises(Unsolvable, match="`hit` pushes `cart` to the side of the line along which it `moves`"):
        solve(ONTO_A_CART.replace("MOVES", moves).replace("FALLS", falls).replace("PAIR", pair))
