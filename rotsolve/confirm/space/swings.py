"""Small swings in space, in numbers: by what small disturbances of a steady motion do, or by how the push on a hinge changes.

What stands on a hinge is turned a little on it and let go, while all that is driven goes on as it is driven: how fast it turns from there,
against what carries it, is solved from the equations of all bodies.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from fractions import Fraction

from rotsolve.algebra.formula import Number
from rotsolve.confirm import NotConfirmed, Unfit
from rotsolve.confirm.space.arrows import inner_product, less
from rotsolve.confirm.space.disturbed import growth_together, open_ways
from rotsolve.confirm.space.rig import Rig
from rotsolve.confirm.space.stability import growth_squared
from rotsolve.confirm.space.ties import TURNING
from rotsolve.confirm.space.worlds import RIGHT, World, manners_of
from rotsolve.language.bodies import Joint
from rotsolve.language.problem import Condition, Path, State, Term

STEP = 1e-3  # radians beside an equilibrium
PLACES = 16  # of a whole turn, between which equilibria are looked for
BALANCED = 1e-7  # of the largest push of a turn: none, beside what is left of a place that is found by steps
SAME = 1e-7  # of the same: what rounding makes of two pushes that are one
FURTHER = 1.1  # radians by which what is driven is turned on, to see whether that changes the push

Push = Callable[[float], float]


def rate_of_swings(world: World, name: str, term: Term, *, told: bool) -> float:
    """The angular frequency, frequency or period of small swings; `told`: about the motion of this world, not an equilibrium near it."""
    square = -growth_about(world, name, told=told)
    if square <= 0.0:
        raise Unfit("nothing drives it back")
    rate = math.sqrt(square)
    return {"angular_frequency": rate, "frequency": rate / (2 * math.pi)}.get(term.path.quantity, 2 * math.pi / rate)


def growth_about(world: World, name: str, *, told: bool = True) -> float:
    """λ² of a small disturbance of a steady motion."""
    rig, joint = world.stance.rig, world.stance.rig.main(name)
    hinged = joint is not None and bool(joint.turning)
    carries = any(item.carrier.owner == name for item in rig.joints.values())
    ways = open_ways(rig, name) if told and joint is not None and (hinged or carries) else []
    if len(ways) > 1:
        return growth_together(world, name, ways)
    if joint is not None and hinged:
        return growth_on_hinge(world, joint, told=told)
    return growth_squared(world, name)


def growth_on_hinge(world: World, joint: Joint, *, told: bool = True) -> float:
    """λ² of what stands on a hinge: how its angular acceleration from rest there changes with its angle, to the fourth order."""

    def push(angle: float) -> float:
        return faster_from(world, joint, angle)

    pushes = [push(2 * math.pi * place / PLACES) for place in range(PLACES + 1)]
    most = max(map(abs, pushes))
    if told and abs(pushes[0]) > BALANCED * most:
        raise NotConfirmed("swings about what is no equilibrium")
    rest = 0.0 if told else equilibrium(push, pushes)
    refuse_other_pushes(world, joint, rest, most)
    near, far = (push(rest + h) - push(rest - h) for h in (STEP, 2 * STEP))
    return (8 * near - far) / (12 * STEP)


def equilibrium(push: Push, pushes: list[float]) -> float:
    """The only angle to which a body is driven back."""
    found = [place for place in range(PLACES) if pushes[place] > 0.0 >= pushes[place + 1]]
    if len(found) != 1:
        raise NotConfirmed("the equilibrium of what swings")
    low, high = (2 * math.pi * (found[0] + part) / PLACES for part in (0, 1))
    for _ in range(60):
        rest = (low + high) / 2
        low, high = (rest, high) if push(rest) > 0.0 else (low, rest)
    return rest


def refuse_other_pushes(world: World, joint: Joint, rest: float, most: float) -> None:
    """Refuse what is pushed otherwise while it moves slowly, or once what is driven has turned on: λ² would not tell how it swings."""
    fast = max(math.sqrt(most), STEP)
    dragged = faster_from(world, joint, rest, rate=STEP * fast) - faster_from(world, joint, rest, rate=-STEP * fast)
    turned = faster_from(world, joint, rest + 0.1, further=FURTHER) - faster_from(world, joint, rest + 0.1)
    if abs(dragged) > SAME * most or abs(turned) > SAME * most:
        raise NotConfirmed("swings that change as what carries it goes round, or that are slowed down")


def faster_from(world: World, joint: Joint, off: float, *, rate: float = 0.0, further: float = 0.0) -> float:
    """The angular acceleration of a body about its hinge, against what carries it, turned `off` from where it stands."""
    stance, rig, name = world.stance, world.stance.rig, joint.body.owner
    if joint.powered or joint.sliding or stance.open:
        raise NotConfirmed("swings of what is driven, or slides")
    moved = {name: {"angle": stance.angle(joint) + off, "angular_velocity": rate}}
    moved |= {one.body.owner: {"angle": stance.angle(one) + further} for one in driven_below(rig, name) if further}
    lines = stance.lines
    kept = [
        line
        for line in lines.lines
        if line.path is not None and not (line.path.owner == name or told_anew(line, moved))
    ]
    told = [
        Condition(Path(owner, word), Number(Fraction(value)))
        for owner, words in moved.items()
        for word, value in words.items()
    ]
    (way,) = manners_of(rig, State(lines.name, (*kept, *told)), lines.put)
    if way.clash > RIGHT:
        raise NotConfirmed("what is let go beside its steady motion")
    found = [faster_about(other, joint) for other in way.worlds]
    if max(found) - min(found) > SAME * max(1.0, *map(abs, found)):
        raise NotConfirmed("swings of what is not the only thing that moves")
    return found[0]


def told_anew(line: Condition, moved: dict[str, dict[str, float]]) -> bool:
    """Whether a line tells an angle that is told otherwise now."""
    return line.path is not None and line.path.quantity in moved.get(line.path.owner, ())


def driven_below(rig: Rig, name: str) -> Iterator[Joint]:
    """The hinges and axles, driven at a rate, of all that carries a body."""
    carrier = rig.carrier(name)
    joint = rig.main(carrier) if carrier else None
    if joint is not None:
        if joint.turning and "angular_velocity" in dict(joint.drive):
            yield joint
        yield from driven_below(rig, carrier)


def faster_about(world: World, joint: Joint) -> float:
    """How fast a body turns faster about the axis of its joint than what carries it."""
    own = world.found.arrow(TURNING, joint.body.owner)
    carrier = joint.carrier.owner
    base = world.found.arrow(TURNING, carrier) if carrier in world.stance.rig.bodies else (0.0, 0.0, 0.0)
    return inner_product(world.stance.way(joint), less(own, base))
