"""Small swings in space, in numbers: by what small disturbances of a steady motion do, or by how the push on a hinge changes."""

from __future__ import annotations

import math

from rotsolve.confirm import NotConfirmed, Unfit
from rotsolve.confirm.space.arrows import STILL, inner_product, product_of, rotation_about
from rotsolve.confirm.space.stability import growth_squared, motion_of
from rotsolve.confirm.space.worlds import World
from rotsolve.language.problem import Term

STEP = 1e-3  # radians beside an equilibrium
PLACES = 16  # of a whole turn, between which equilibria are looked for
BALANCED = 1e-9  # of the largest push of a turn: none


def rate_of_swings(world: World, name: str, term: Term, *, told: bool) -> float:
    """The angular frequency, frequency or period of small swings; `told`: about the motion of this world, not an equilibrium near it."""
    square = -(growth_on_hinge(world, name, told=told) if on_hinge(world, name) else growth_squared(world, name))
    if square <= 0.0:
        raise Unfit("nothing drives it back")
    rate = math.sqrt(square)
    return {"angular_frequency": rate, "frequency": rate / (2 * math.pi)}.get(term.path.quantity, 2 * math.pi / rate)


def on_hinge(world: World, name: str) -> bool:
    joint = world.stance.rig.on_ground(name)
    return joint is not None and bool(joint.turning)


def growth_on_hinge(world: World, name: str, *, told: bool) -> float:
    """λ² of what stands on a hinge: how its angular acceleration from rest changes with its angle, to the fourth order."""
    stance, motion = world.stance, motion_of(world.stance.rig, name)
    joint = stance.rig.on_ground(name)
    assert joint is not None
    way, turned = stance.way(joint), stance.turned(name)

    def push(angle: float) -> float:
        return inner_product(way, motion(product_of(rotation_about(way, angle), turned), STILL))

    pushes = [push(2 * math.pi * place / PLACES) for place in range(PLACES + 1)]
    most = max(map(abs, pushes))
    if told and abs(pushes[0]) > BALANCED * most:
        raise NotConfirmed("swings about what is no equilibrium")
    rest = 0.0
    if not told:
        found = [place for place in range(PLACES) if pushes[place] > 0.0 >= pushes[place + 1]]
        if len(found) != 1:
            raise NotConfirmed("the equilibrium of what swings")
        low, high = (2 * math.pi * (found[0] + part) / PLACES for part in (0, 1))
        for _ in range(60):
            rest = (low + high) / 2
            low, high = (rest, high) if push(rest) > 0.0 else (low, rest)
    near, far = (push(rest + h) - push(rest - h) for h in (STEP, 2 * STEP))
    return (8 * near - far) / (12 * STEP)
