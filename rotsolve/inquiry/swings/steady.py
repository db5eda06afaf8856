"""Steady: of the angles at which a body may stand on a turning shaft, those to which it comes back when it is displaced."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from rotsolve.algebra.calculus import differentiate
from rotsolve.algebra.formula import Formula
from rotsolve.core.facts import signed
from rotsolve.inquiry.history import History
from rotsolve.inquiry.swings.equilibrium import sign
from rotsolve.principles import energy

STABLE = ("the stable one: a body displaced from it comes back",)


def stable_roots(name: str, roots: Sequence[Formula], history: History, values: Mapping[str, Formula]) -> list[int]:
    """Places of the stable ones among values of a letter that the angle of a body on a turning shaft depends on."""
    for state in history.arrangement.timeline.states:
        facts = history.facts(state.name, virtual=True)
        for body in facts.bodies:
            balance = energy.drive(facts, frozenset((body.name,))) if body.sweep is not None and state.steady else None
            angle = history.instant(state.name).angle(body.name)
            if balance is None or angle is None or name not in angle.symbols():
                continue
            slope = differentiate(balance[0] - balance[1], name) * differentiate(angle, name)
            back = signed(slope, body.motion.sense)
            return [place for place, root in enumerate(roots) if sign(back.substitute({name: root}), values) == -1]
    return []
