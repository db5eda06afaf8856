"""Opening: the scene as it stands at one moment, without what comes later: at one of its states, or at any moment of its motion."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from msgspec.structs import replace

from rotsolve.algebra.formula import Formula, Number, Symbol
from rotsolve.core.registry import TIME
from rotsolve.core.varying import paths_in
from rotsolve.language.keys import keys_of
from rotsolve.language.problem import Condition, Path, State
from rotsolve.motion.configuration import Configuration

STATED = ("angle", "elongation", "length", "velocity", "angular_velocity")  # what a state may say of a moment
SINCE = ("rotation", "displacement")  # what counts from the first state


def opening(configuration: Configuration, state: str) -> Configuration:
    """The scene as it is arranged from a state on, under the name of its first one: what acts there, what is there."""
    problem, first = configuration.problem, configuration.timeline.states[0]
    there = {
        name
        for body in configuration.present(state)
        for name in (body.name, *(member.name for member in configuration.cluster(body.name, state)))
    }
    return Configuration(
        replace(
            problem,
            bodies=tuple(body for body in problem.bodies if body.name in there),
            connections=configuration.connections(state),
            actions=tuple(
                replace(item, from_=None, to=None) for item in configuration.actions(state) if item.to != state
            ),
            states=(first if state == first.name else State(first.name),),
            phases=(),
            events=(),
            finds=(),
            answers=(),
        )
    )


def standing(configuration: Configuration, time: float, numbers: Mapping[str, float]) -> Configuration:
    """The scene at a moment of its motion as a scene of its own, which starts with these places and speeds, by their names.

    What varies in it counts on from that moment.
    """
    problem, first = configuration.problem, configuration.timeline.states[0]
    conditions = tuple(
        Condition(path, Number(Fraction(number)))
        for path, number in ((path_of(name), number) for name, number in numbers.items())
        if path.quantity in STATED and (path.component or path.point) in (None, "x", "y")
    )
    state = State(first.name, conditions, span=first.span)
    return Configuration(
        replace(
            problem,
            states=(state,),
            connections=tuple(going_on(item, time, numbers) for item in problem.connections),
            actions=tuple(going_on(item, time, numbers) for item in problem.actions),
        )
    )


def path_of(name: str) -> Path:
    """`block.velocity.x` as a path."""
    owner, word, *component = name.split(".")
    return Path(owner, word, component=component[0] if component else None)


def going_on(item: Any, time: float, numbers: Mapping[str, float]) -> Any:
    """An element whose values that vary count time, rotations and displacements on from a moment."""
    changed = {}
    for word, declared in keys_of(item):
        value = getattr(item, word, None) if declared.varies else None
        if isinstance(value, Formula):
            since = {TIME: time} if TIME in value.symbols() else {}
            for letter, owner, quantity in paths_in(value):
                if quantity in SINCE:
                    since[letter] = numbers[f"{owner}.{'position' if quantity == 'displacement' else quantity}"]
            shifted = {name: Symbol(name) + Number(Fraction(number)) for name, number in since.items()}
            changed[word] = value.substitute(shifted)
    return replace(item, **changed) if changed else item
