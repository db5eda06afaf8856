"""Mistakes with angles: the sine for the cosine of an angle of the scene, and the cosine for the sine."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from msgspec.structs import replace

from rotsolve.algebra.formula import PI, Formula, Symbol
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.vectors.heading import heading
from rotsolve.grading.mistakes.kinds.places import Made
from rotsolve.grading.mistakes.mistake import Change
from rotsolve.language.keys import Element
from rotsolve.language.problem import Condition, Problem

if TYPE_CHECKING:
    from rotsolve.grading.mistakes.scene import Scene

Turn = Callable[[Formula], Formula]


def sine_for_cosine(scene: Scene) -> Made:
    """90° − θ for θ, wherever it is a direction: then sine and cosine are exchanged, also in what is derived from them."""
    found = list(dict.fromkeys(directions(scene.problem)))
    for name in dict.fromkeys(name for value in found for name in sorted(value.symbols())):
        yield exchanged(Symbol(name)), Change(problem=turned(complement_of(name)))
    for value in found:
        direction = heading(value)
        if not direction.terms and direction.degrees % 90:
            yield exchanged(value), Change(problem=turned(complement_if(value)))


def exchanged(angle: Formula) -> str:
    return f"sine and cosine of {to_text(angle)} were exchanged"


def complement_if(angle: Formula) -> Turn:
    return lambda value: PI / 2 - value if value == angle else value


def complement_of(name: str) -> Turn:
    return lambda value: value.substitute({name: PI / 2 - Symbol(name)})


def directions(problem: Problem) -> Iterator[Formula]:
    """All angles of a scene that say how something stands."""
    for element in (*problem.surfaces, *problem.connections, *problem.actions):
        yield from angles_in(element).values()
    yield from (line.value for line in lines(problem) if line.value is not None)


def lines(problem: Problem) -> Iterator[Condition]:
    """The lines of the states that tell an angle."""
    return (line for state in problem.states for line in state.conditions if tells_angle(line))


def tells_angle(line: Condition) -> bool:
    return line.path is not None and line.path.quantity == "angle" and line.value is not None


def angles_in(element: Element) -> dict[str, Formula]:
    """The fields of an element that hold a direction."""
    fields = {}
    for name, key in element.declared.items():
        value = getattr(element, name)
        if isinstance(value, Formula) and not key.varies and (key.dimension == "angle" or key.kind == "direction"):
            fields[name] = value
    return fields


def turned(turn: Turn) -> Callable[[Problem], Problem]:
    """The scene with other directions."""

    def element(item: Any) -> Any:
        return replace(item, **{name: turn(value) for name, value in angles_in(item).items()})

    def line(item: Condition) -> Condition:
        return replace(item, value=turn(item.value)) if tells_angle(item) and item.value is not None else item

    def changed(problem: Problem) -> Problem:
        states = tuple(
            replace(state, conditions=tuple(line(item) for item in state.conditions)) for state in problem.states
        )
        return replace(
            problem,
            surfaces=tuple(element(item) for item in problem.surfaces),
            connections=tuple(element(item) for item in problem.connections),
            actions=tuple(element(item) for item in problem.actions),
            states=states,
        )

    return changed
