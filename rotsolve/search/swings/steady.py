"""Steady: of the angles at which a body may stand in balance, or on a turning shaft, those to which it comes back when displaced."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.formula import Formula
from rotsolve.core.facts import BodyFacts, Facts, signed
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.equations.swings.equilibrium import sign
from rotsolve.laws import groups

Standing = tuple[BodyFacts, Formula, Facts]  # a body, its angle, and the facts at its state


def on_shaft(name: str, scene: SceneEquations) -> list[Standing]:
    """Bodies that stand steadily on a turning shaft at an angle that depends on a letter."""
    states = [state.name for state in scene.configuration.timeline.states if state.steady]
    return [item for item in standing(name, states, scene) if item[0].sweep is not None]


def balanced(name: str, scene: SceneEquations) -> list[Standing]:
    """Bodies on an axis whose angle at a state in balance depends on a letter."""
    states = [state.name for state in scene.configuration.timeline.states if state.balance]
    return [item for item in standing(name, states, scene) if item[0].motion.kind == "axis"]


def standing(name: str, states: Iterable[str], scene: SceneEquations) -> Iterator[Standing]:
    """Bodies whose angle at one of some states depends on a letter."""
    for state in states:
        facts = scene.facts(state, virtual=True)
        for body in facts.bodies:
            angle = scene.instant(state).angle(body.name)
            if angle is not None and name in angle.symbols():
                yield body, angle, facts


def stable_roots(
    name: str, roots: Sequence[Formula], scene: SceneEquations, values: Mapping[str, Formula]
) -> list[int]:
    """Places of the stable ones among values of a letter that the angle of a body in balance, or on a turning shaft, depends on."""
    for body, angle, facts in (*on_shaft(name, scene), *balanced(name, scene)):
        balance = groups.drive(facts, frozenset((body.name,)))
        if balance is not None:
            slope = differentiate(balance[0] - balance[1], name) * differentiate(angle, name)
            back = signed(slope, body.motion.sense)
            return [place for place, root in enumerate(roots) if sign(back.substitute({name: root}), values) == -1]
    return []
