"""Balance: where nothing accelerates, and where a shaft carries steadily what accelerates towards it."""

from __future__ import annotations

from rotsolve.algebra.formula import ZERO
from rotsolve.equations.states.fixed import Fixed
from rotsolve.language.problem import State
from rotsolve.paths import NotYet


def check_shafts(state: State, fixed: Fixed) -> None:
    """A body on a turning shaft is alone there: how others that are tied to it are carried round is not told."""
    for item in fixed.configuration.connections(state.name):
        if item.word == "shaft":
            name = item.touches()[0].owner
            if len(fixed.configuration.component(name, state.name)) > 1:
                raise NotYet(f"`{name}` on a turning shaft is tied to other bodies: that is not solved yet", state.span)


def check_steady(state: State, fixed: Fixed) -> None:
    """On a turning shaft bodies are steady, since they are accelerated towards it; elsewhere they are in balance."""
    carried = any(item.word == "shaft" for item in fixed.configuration.connections(state.name))
    if state.balance and carried:
        raise NotYet("nothing is in balance on a turning shaft", state.span, "write `steady: true`")
    if state.steady and not carried:
        raise NotYet("`steady: true` is solved on a turning `shaft` only", state.span, "write `balance: true`")


def balance(state: str, fixed: Fixed) -> None:
    """In equilibrium nothing accelerates."""
    instant = fixed.instant(state)
    for body in fixed.configuration.present(state):
        motion = instant.motion(body.name)
        rates = [size for size, _ in motion.acceleration.parts]
        if motion.turns:
            rates.append(instant.rate("angular_acceleration", body.name))
        for rate in rates:
            fixed.fix(rate, ZERO)
