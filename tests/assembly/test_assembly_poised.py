"""From upright, where the least push decides: friction has to suffice on the whole way, not only where something is asked."""

from __future__ import annotations

from collections.abc import Callable
from math import cos, radians, sin

import pytest

from rotsolve.core.faults import Unsolvable
from rotsolve.pipeline import solve

ROD = """
title: upright on a rough floor
given: {{{given}}}
surfaces: {{floor: level}}
bodies: {{rod: {{shape: rod, mass: M, length: L, turns: {turns}}}{bodies}}}
connections: {{foot: {{contact: [{foot}, floor], friction: mu}}{more}}}
states: {{upright: {{rod.angle: 90 deg, at rest: all}}, tipped: {{rod.angle: 90 deg {sign} {tip}}}}}
find: {{w: rod.angular_velocity at tipped, f: foot.friction_force at tipped}}
"""


def alone(tip: float) -> float:
    """|f|/N of a rod that has tipped by an angle about its foot: ω² = 3 g (1 − cos)/L, α = 3 g sin/(2 L)."""
    return abs(0.75 * sin(tip) * (3 * cos(tip) - 2)) / (0.25 * (1 - 3 * cos(tip)) ** 2)


def loaded(tip: float) -> float:
    """The same with a load of half its mass on its tip: I = M/3 + m, the moment of mass is M/2 + m, all with L = 1."""
    inertia, moment, whole = 1 / 3 + 1 / 2, 1 / 2 + 1 / 2, 1 + 1 / 2
    rate, square = moment * sin(tip) / inertia, 2 * moment * (1 - cos(tip)) / inertia
    push = whole - moment * (rate * sin(tip) + square * cos(tip))
    return abs(moment * (rate * cos(tip) - square * sin(tip))) / push


def carried(tip: float) -> float:
    """The same on a cart of a twentieth of its mass."""
    return abs(0.75 * sin(tip) * (3 * cos(tip) - 2)) / (1 / 20 + 0.25 * (1 - 3 * cos(tip)) ** 2)


CASES: dict[str, tuple[dict[str, str], Callable[[float], float], int]] = {
    "a rod": ({}, alone, 48),
    "a rod with a load": ({"bodies": ", load: {mass: m}", "more": ", glue: {weld: [rod.end, load]}"}, loaded, 45),
    "a rod on a cart": (
        {"bodies": ", cart: {mass: m, moves: right}", "foot": "cart", "more": ", pin: {hinge: [cart, rod.start]}"},
        carried,
        90,
    ),
}
LOADS = {"a rod": "1", "a rod with a load": "0.5", "a rod on a cart": "0.05"}


def scene(changes: dict[str, str], given: str, tip: str, way: str = "clockwise") -> str:
    words = {"bodies": "", "more": "", "foot": "rod.start"} | changes
    return ROD.format(given=given, tip=tip, turns=way, sign="-" if way == "clockwise" else "+", **words)


@pytest.mark.parametrize("way", ["clockwise", "counterclockwise"])
@pytest.mark.parametrize("name", CASES)
def test_friction_has_to_suffice_on_the_whole_way_from_upright(name: str, way: str) -> None:
    """With a coefficient right above the largest |f|/N on the way all is confirmed, right below it nothing is."""
    changes, needed, tip = CASES[name]
    ratios = [needed(radians(tip) * part / 20000) for part in range(1, 20001)]
    assert max(ratios) > 1.2 * ratios[-1]  # so that the state that is asked does not tell it
    mass = "" if name == "a rod" else f", m: {LOADS[name]} kg"

    def given(share: float) -> str:
        return scene(changes, f"M: 1 kg, L: 1 m, mu: {share * max(ratios):.9f}{mass}", f"{tip} deg", way)

    said = [check for check in solve(given(1.005)).checks if check.holds is None]
    assert not any("not confirmed" in str(check.label) for check in said)
    with pytest.raises(Unsolvable, match="`foot` begins to slip on the way from `upright` to `tipped`"):
        solve(given(0.995))


@pytest.mark.sampled(3)
@pytest.mark.parametrize("name", CASES)
def test_in_letters_it_is_said_with_which_numbers_friction_gives_way_before(name: str) -> None:
    changes, _, tip = CASES[name]
    letters = "M: kg, L: m, mu: number" + (", beta: rad" if name == "a rod" else ", m: kg")
    checks = solve(scene(changes, letters, "beta" if name == "a rod" else f"{tip} deg")).checks
    said = " ".join(str(part) for check in checks if check.holds is None for part in check.words)
    assert "`foot` begins to slip on the way from `upright` to `tipped`" in said
    assert not any("an assembly" in str(check.words) for check in checks)
