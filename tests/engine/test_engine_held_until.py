"""A state in balance, or that is said to stick, holds also where an event ends it at once: answers afterwards have its condition."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from margins import G, Numbers, answered_just_where

CRATE = """
title: A crate that a force holds against a load; the force ends
given: {M: kg, m: kg, mu: number, F: N, C: N m, r: m}
surfaces: {floor: level}
bodies: {crate: {mass: M, moves: WAY}, p: {mass: 0, radius: r}, load: {mass: m, moves: down}}
connections:
  base: {contact: [crate, floor], friction: mu}
  ax: {axle: pRUBS}
  cord: {string: [crate, p, load], pulls: {crate: WAY}}
actions: {hold: {force: F, on: crate, direction: BACK}}
states: {still: {balance: true}, go: {}}
events: {off: {removes: hold, from: still, to: go}}
find: {a: load.acceleration at go}
"""
CLUTCH = """
title: Two discs that stick together while a couple acts on one; the couple ends
gravity: none
given: {I: kg m^2, J: kg m^2, Q: N m, tau: N m, w: rad/s}
bodies: {a: {inertia: I}, b: {inertia: J}}
connections: {axle: {axle: [a, b]}, k: {clutch: [ORDER], friction_torque: tau}}
actions: {one: {couple: Q, on: a}}
states: {held: {a.angular_velocity: w, k: sticks}, off: {}, end: {time: 1 s}}
events: {stop: {removes: one, from: held, to: off}}
find: {z: b.angular_velocity at end}
"""
BLOCK = """
title: A block that sticks on a floor under a pull; the pull ends
given: {m: kg, F: N, mu: number}
surfaces: {floor: level}
bodies: {block: {mass: m, moves: right}}
connections: {base: {contact: [block, floor], friction: mu}}
actions: {pull: {force: F, on: block, direction: WAY}}
states: {still: {at rest: all, base: sticks}, go: {}}
events: {off: {removes: pull, from: still, to: go}}
find: {N: base.normal_force at go}
"""


def crate(x: Numbers) -> float:
    return x["mu"] * x["M"] * G - abs(x["m"] * G - x["F"])


def crate_and_axle(x: Numbers) -> float:
    return crate(x) + x["C"] / x["r"]


def clutch(x: Numbers) -> float:
    return x["tau"] - x["J"] * x["Q"] / (x["I"] + x["J"])


def block(x: Numbers) -> float:
    return x["mu"] * x["m"] * G - x["F"]


RIGHT, LEFT = ("right", "left"), ("left", "right")
RUBS = ", friction_torque: C"
SCENES: dict[str, tuple[str, Callable[[Numbers], float]]] = {
    f"{name} {way}": (CRATE.replace("WAY", way).replace("BACK", back).replace("RUBS", rubs), margin)
    for way, back in (RIGHT, LEFT)
    for name, rubs, margin in (("a crate", "", crate), ("a crate and an axle", RUBS, crate_and_axle))
}
SCENES |= {f"a clutch, {order}": (CLUTCH.replace("ORDER", order), clutch) for order in ("a, b", "b, a")}
SCENES |= {f"a block {way}": (BLOCK.replace("WAY", way), block) for way in RIGHT}


@pytest.mark.sampled(4)
@pytest.mark.parametrize("name", SCENES)
def test_what_comes_after_has_the_condition_of_the_balance(name: str) -> None:
    answered_just_where(*SCENES[name])
