"""Verge: letters under a condition: the value with which a quantity is as large as told, or from which on a motion is steady or stable."""

from __future__ import annotations

from collections.abc import Callable

from rotsolve.confirm import NotConfirmed, Unfit
from rotsolve.confirm.space.inquiry import Inquiry, only_one
from rotsolve.confirm.space.stability import is_stable
from rotsolve.confirm.space.swings import growth_about
from rotsolve.confirm.space.worlds import World
from rotsolve.language.problem import Condition, Find

STEP = 1e-5  # by how much a letter is changed, to see what that changes
TOUCHING = 1e-3  # of what a gap is beside it: 3 % of a step, less than answers are compared by
BESIDE = 1e-6  # how near a value has to be to that from which on a motion is what is asked, as a part of it
NEAR = (BESIDE, 1e-4)  # for roots, and for what grows or not, which rounding tells less closely
WithLetter = Callable[[float], Inquiry]


def gap_under(condition: Condition, with_letter: WithLetter) -> Callable[[float], float]:
    """How much more a quantity is than a condition tells, by the number of a letter."""
    if condition.phrase is None or condition.value is None or condition.word is not None:
        raise NotConfirmed("a condition of this kind in space")

    def gap(value: float) -> float:
        inquiry = with_letter(value)
        return only_one(inquiry.numbers(condition.phrase, "")) - inquiry.rig.value(condition.value)  # type: ignore[arg-type]

    return gap


def step_to(gap: Callable[[float], float], own: float) -> float:
    """The nearest number with which a gap is closed, by Newton's steps; the number itself where the gap is open on both sides of it and
    only closed there, as that of a size which is to be nothing."""
    step = STEP * (abs(own) or 1.0)
    up, down, here = gap(own + step), gap(own - step), gap(own)
    if up * down > 0 and abs(here) <= TOUCHING * min(abs(up), abs(down)):
        return own
    slope = (up - down) / 2
    if abs(slope) <= 1e-9 * STEP * max(abs(up), abs(down), abs(here)):
        raise NotConfirmed("its condition does not hang on it")
    return own - here / slope * step


def just_holds(find: Find, own: float, with_letter: WithLetter) -> float:
    """The answer itself where beyond it the motion of a state is steady or stable, and short of it not; else a number beside it."""
    condition = find.where
    assert condition is not None
    extreme = find.extreme or find.modifier or next((term.modifier for term in find.terms), "")
    way = {"smallest": 1.0, "largest": -1.0}.get(extreme)
    if way is None:
        raise NotConfirmed("whether the largest or the smallest is asked")
    test, near = (is_steady, NEAR[0]) if condition.word == "steady" else (holds_still, NEAR[1])
    size = abs(own) or 1.0
    inside, outside = (with_letter(own + size * part * way * near) for part in (1.0, -1.0))
    if test(inside, condition.owner) and not test(outside, condition.owner):
        return own
    return own + 0.1 * way * size  # the edge is somewhere else


def is_steady(inquiry: Inquiry, name: str) -> bool:
    """Whether a steady motion has what the state tells."""
    try:
        return bool(inquiry.ways(name))
    except Unfit:
        return False


def holds_still(inquiry: Inquiry, name: str) -> bool:
    """Whether a small disturbance of a state does not grow, of the one body that nods there."""
    found = inquiry.ways(name)
    world = found[0].worlds[0]
    nodding = [body for body in inquiry.rig.bodies if nods_there(world, body) or swings_there(world, body)]
    if len(nodding) != 1:
        raise NotConfirmed(
            f"of which of {' and '.join(f'`{body}`' for body in nodding)} the motion at `{name}` is stable"
        )
    if len(found) != 1:
        raise NotConfirmed(f"which of several motions at `{name}` is stable")
    return is_stable(world, nodding[0]) if nods_there(world, nodding[0]) else growth_about(world, nodding[0]) <= 0.0


def nods_there(world: World, name: str) -> bool:
    """Whether a state tells a tilt or its rates of a body; the spin of a rotor on the axle of another is none of these."""
    joint = world.stance.rig.main(name)
    return world.stance.lines.nods(name) and not (joint is not None and joint.turning)


def swings_there(world: World, name: str) -> bool:
    """Whether a state speaks of a body that stands on a hinge: that nothing drives, and that is not told to turn."""
    joint, lines = world.stance.rig.main(name), world.stance.lines
    if joint is None or not joint.turning or joint.powered or not lines.of(name):
        return False
    return not any(lines.told(name, word) for word in ("angular_velocity", "spin"))
