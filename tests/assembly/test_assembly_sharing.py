"""Several that stick and share what that takes in a way that nothing tells: they give way together, at the sum of their limits."""

from __future__ import annotations

from itertools import permutations

import pytest

from rotsolve import solve

G = 9.8
MASSES = {"one": 2.0, "two": 3.0, "three": 1.0}
LIMITS = {"one": (0.2, 0.1), "two": (0.4, 0.3), "three": (0.5, 0.2)}
MOST, LESS = (sum(MASSES[name] * G * LIMITS[name][k] for name in MASSES) for k in (0, 1))  # 20.58 N, 12.74 N
SCENE = """
title: A row of crates that are pulled
surfaces: {{floor: level}}
bodies: {{{bodies}}}
connections:
{lying}
  g: {{{link}: [{first}, {second}]}}
  h: {{{link}: [{second}, {third}]}}
actions: {{pull: {{force: {force}, on: {third}, direction: right}}}}
states: {{start: at rest, end: {{time: {time} s}}}}
find: {{v: two.velocity at end}}
"""


def row(order: tuple[str, ...], link: str, force: str, time: float) -> str:
    first, second, third = order
    bodies = ", ".join(f"{name}: {{mass: {mass} kg, moves: right}}" for name, mass in MASSES.items())
    lying = "\n".join(
        f"  c_{name}: {{contact: [{name}, floor], friction: {{static: {LIMITS[name][0]}, kinetic: {LIMITS[name][1]}}}}}"
        for name in MASSES
    )
    return SCENE.format(
        bodies=bodies, lying=lying, link=link, first=first, second=second, third=third, force=force, time=time
    )


@pytest.mark.parametrize("link", ["weld", "string"])
@pytest.mark.parametrize("order", list(permutations(MASSES))[::2])
@pytest.mark.parametrize("force", [13.0, 20.4, 20.8, 40.0])
def test_a_row_gives_way_at_the_sum_of_its_limits(link: str, order: tuple[str, ...], force: float) -> None:
    solution = solve(row(order, link, f"{force} N", 2.0))
    expected = 2.0 * (force - LESS) / 6 if force > MOST else 0.0
    assert solution.answers["v"].float == pytest.approx(expected)
    assert solution.derivation.confirmed[0].holds


@pytest.mark.parametrize("link", ["weld", "string"])
def test_a_force_that_grows_moves_a_row_when_it_reaches_that(link: str) -> None:
    """From t₀ = 20.58 N/(10 N/s) on 6 kg dv/dt = 10 N/s t − 12.74 N."""
    solution = solve(row(("one", "two", "three"), link, "10 N/s*time", 3.0))
    begins = MOST / 10
    expected = (5 * (9 - begins**2) - LESS * (3 - begins)) / 6
    assert solution.answers["v"].float == pytest.approx(expected)
    assert solution.derivation.confirmed[0].holds
