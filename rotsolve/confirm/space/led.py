"""Led on: how far bodies that are driven round at told rates have turned, where all bodies of a rig move as they are told to.

Nothing has to be followed then: where a body stands on its hinge is ∫ ω dt from the first state on, summed by Simpson's rule.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from rotsolve.algebra.formula import Formula
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.numbers import value_of
from rotsolve.confirm.space.rig import Rig, Told
from rotsolve.confirm.space.stance import Stance
from rotsolve.confirm.space.worlds import Manner, manners_of
from rotsolve.core.symbols import TIME

if TYPE_CHECKING:
    from rotsolve.confirm.space.motions import WaysOfMoving
    from rotsolve.language.problem import State

PARTS = 1024  # of the time, over which a rate is summed
SUMMED = 1e-9  # of the angle, or of a radian, within which half as many have to agree


def manner_as_led(inquiry: WaysOfMoving, name: str, state: State, passed: float) -> Manner | None:
    """The way in which all moves some time after a state, as it is led; None where that does not tell how all stands."""
    problem = inquiry.problem
    first, before = (inquiry.clock(item) for item in (problem.states[0], inquiry.state(name)) if item is not None)
    lines = (line.path for item in problem.states[1:] for line in item.conditions)
    retold = any(path is None or path.quantity != "time" for path in lines)  # which the drive may contradict
    if first is None or before is None or retold or problem.events or any(body.moved for body in problem.bodies):
        return None
    rig = Rig(problem, {**inquiry.rig.numbers, TIME: before + passed}, state.name)
    start = inquiry.ways(problem.states[0].name)[0].worlds[0].stance
    found = manners_of(rig, state, {**inquiry.put, **angles_led(rig, state, start, (first, before + passed))})
    return found[0] if len(found) == 1 == len(found[0].worlds) else None


def angles_led(rig: Rig, state: State, start: Stance, span: tuple[float, float]) -> Told:
    """How far the bodies that are driven at a rate are turned on what carries them."""
    return {
        (state.name, joint.body.owner, "angle"): start.angle(joint) + angle_over(rig, part, *span)
        for joint in rig.joints.values()
        for word, part in joint.drive
        if word == "angular_velocity" and len(joint.drive) == 1
    }


def angle_over(rig: Rig, rate: Formula, start: float, end: float) -> float:
    """∫ ω dt."""
    step = (end - start) / PARTS
    rates = [float(value_of(rate, {**rig.numbers, TIME: start + step * place})) for place in range(PARTS + 1)]
    fine, rough = (simpson(rates[::every], step * every) for every in (1, 2))
    if abs(fine - rough) > SUMMED * max(1.0, abs(fine)):
        raise NotConfirmed("a rate that changes too fast to be summed")
    return fine


def simpson(values: list[float], step: float) -> float:
    """h/3 (y₀ + 4 y₁ + 2 y₂ + … + yₙ)."""
    return step / 3 * (values[0] + values[-1] + 4 * sum(values[1::2]) + 2 * sum(values[2:-1:2]))
