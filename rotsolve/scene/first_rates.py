"""First rates: a joint in space that is driven with a rate and, besides, with how fast that changes has that rate at the first state."""

from __future__ import annotations

from msgspec.structs import replace

from rotsolve.core.faults import Fault
from rotsolve.language.problem import Condition, Path, Problem
from rotsolve.scene.scope import Scope


def with_first_rates(problem: Problem, scope: Scope) -> Problem:
    """The problem with such rates as lines of its first state, from which on the acceleration changes them; the same where no time passes.

    That a blow comes between is a fault.
    """
    passes = len(problem.states) - len(problem.events) > 1 or any(find.runs for find in problem.finds)
    found = {item.name: told for item in problem.connections if (told := item.first_rate()) is not None}
    if not (problem.space and problem.states and passes and found):
        return problem
    if problem.events:
        name, (_, ref, _) = next(iter(found.items()))
        message = f"`{name}` is driven with a rate and an acceleration: at which state it has that rate nothing tells, as there is an event"
        help = "drive it with one of them: `angular_velocity` as a formula of `time`"
        scope.faults.append(Fault(message, ref.span, help, "given motion"))
        return problem
    lines = [Condition(Path(ref.owner, "angular_velocity"), rate, span=ref.span) for _, ref, rate in found.values()]
    first, *others = problem.states
    kept = tuple(found[item.name][0] if item.name in found else item for item in problem.connections)
    return replace(problem, connections=kept, states=(replace(first, conditions=(*first.conditions, *lines)), *others))
