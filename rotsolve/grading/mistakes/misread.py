"""Mistakes in reading the scene: a number without the factor of its unit, another letter, a diameter for a radius, sine for cosine."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from itertools import combinations
from typing import TYPE_CHECKING, Any

from msgspec.structs import replace

from rotsolve.algebra.formula import ONE, PI, ZERO, Formula, Number, Symbol
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.units.dimension import ANGLE
from rotsolve.algebra.units.unit_table import UNITS, Unit
from rotsolve.core.vectors.heading import heading
from rotsolve.core.writing import and_joined
from rotsolve.grading.mistakes.in_space import Turns, turned_bodies, with_turns
from rotsolve.grading.mistakes.mistake import MOST, Change, Made, bodies_and_parts, each
from rotsolve.language.keys import Element
from rotsolve.language.limited import WAYS
from rotsolve.language.problem import Body, Condition, Problem, Term

if TYPE_CHECKING:
    from rotsolve.grading.mistakes.scene import Scene

MINUTE = Number(UNITS["min"].scale)
Turn = Callable[[Formula], Formula]


def misread_givens(scene: Scene, fits: Callable[[Unit], bool], wrong: Callable[[Unit], Formula], words: str) -> Made:
    """Each given in a unit that is misread times its wrong factor, then all of them; `words` speak of its {name} and {unit}."""
    found = [
        (given.name, given.unit.text, wrong(given.unit))
        for given in scene.problem.givens
        if given.value is not None and given.unit is not None and fits(given.unit)
    ]
    alone = [[one] for one in found] if len(found) <= MOST else []
    for group in [*alone, *([found] if len(found) > 1 else [])]:
        names = and_joined([to_text(Symbol(name)) for name, _, _ in group])
        units = and_joined(list(dict.fromkeys(unit for _, unit, _ in group)))
        told = words.format(name=names, unit=units, are="was" if len(group) == 1 else "were")
        yield told, Change(factors={name: factor for name, _, factor in group})


def is_in_turns(unit: Unit) -> bool:
    """Revolutions, also by the minute."""
    return unit.pi_power == 1 and unit.counts_turns


def without_factor(unit: Unit) -> Formula:
    return ONE / unit.factor


def without_turn(unit: Unit) -> Formula:
    return ONE / (2 * PI)


def degrees_as_radians(scene: Scene) -> Made:
    """30 rad for 30°."""
    words = "{name} in degrees {are} taken as in radians"
    return misread_givens(scene, lambda unit: unit.pi_power == 1 and "°" in unit.text, lambda unit: 180 / PI, words)


def revolutions_as_radians(scene: Scene) -> Made:
    """300 rad/s for 300 rev/min; or only the 2π or only the 60 of its factor left out."""
    words = "{name} in {unit} {are} taken as in radians and seconds"
    yield from misread_givens(scene, is_in_turns, without_factor, words)
    words = "the 2π was left out when {name} {are} turned into radians"
    yield from misread_givens(scene, is_in_turns, without_turn, words)
    words = "the minutes of {name} were taken for seconds"
    yield from misread_givens(
        scene, lambda unit: is_in_turns(unit) and ("min" in unit.text or "rpm" in unit.text), lambda unit: MINUTE, words
    )


def hertz_as_radians(scene: Scene) -> Made:
    """50 rad/s for 50 Hz."""
    return misread_givens(scene, lambda unit: unit.is_hertz, without_turn, "{name} in {unit} {are} taken as in rad/s")


def units_not_converted(scene: Scene) -> Made:
    """20 m for 20 cm: a multiple of an SI unit."""
    words = "{name} in {unit} {are} not turned into SI units"
    return misread_givens(scene, lambda unit: not unit.pi_power and unit.scale != 1, without_factor, words)


# letters


def diameters(scene: Scene) -> Made:
    """2 R for R; ½ R where the radius was taken for a diameter."""
    found = radius_letters(scene.problem.bodies)
    for name in each(found):
        letter = Symbol(name)
        yield f"the diameter was put for {to_text(letter)}", Change(letters={name: 2 * letter})
        yield f"{to_text(letter)} was halved, as if it were a diameter", Change(letters={name: letter / 2})
    if len(found) > 1:
        names = and_joined([to_text(Symbol(name)) for name in found])
        yield f"diameters were put for {names}", Change(letters={name: 2 * Symbol(name) for name in found})


def letters_exchanged(scene: Scene) -> Made:
    """m₂ for m₁ and m₁ for m₂; so for two radii."""
    masses = [body.mass.name for body in scene.problem.bodies if isinstance(body.mass, Symbol)]
    for names in (masses, radius_letters(scene.problem.bodies)):
        for one, other in combinations(each(names), 2):
            words = f"{to_text(Symbol(one))} and {to_text(Symbol(other))} were exchanged"
            yield words, Change(letters={one: Symbol(other), other: Symbol(one)})


def from_rest(scene: Scene) -> Made:
    """0 for a velocity at the start."""
    lines = scene.problem.states[0].conditions if scene.problem.states else ()
    speeds = [
        line.value.name
        for line in lines
        if line.path is not None
        and isinstance(line.value, Symbol)
        and line.path.quantity in ("velocity", "angular_velocity")
    ]
    for name in each(speeds):
        yield f"{to_text(Symbol(name))} was left out, as if the motion began at rest", Change(letters={name: ZERO})


def radius_letters(bodies: Iterable[Body]) -> list[str]:
    """The letters of the radii of some bodies and their parts, each once."""
    found: list[str] = []
    for body in bodies_and_parts(bodies):
        named = (*body.radii, *getattr(body.shape, "radii", ()))
        sizes = (body.radius, getattr(body.shape, "radius", None), *(size for _, size in named))
        found += [size.name for size in sizes if isinstance(size, Symbol)]
    return list(dict.fromkeys(found))


# angles


def sine_for_cosine(scene: Scene) -> Made:
    """90° − θ for θ, wherever it is a direction: then sine and cosine are exchanged, also in what is derived from them."""
    found = list(dict.fromkeys(scene_angles(scene.problem)))
    for name in dict.fromkeys(name for value in found for name in sorted(value.symbols())):
        yield exchange_words(Symbol(name)), Change(problem=with_turned(complement_of(name)))
    for value in found:
        direction = heading(value)
        if not direction.terms and direction.degrees % 90:
            yield exchange_words(value), Change(problem=with_turned(complement_if(value)))


def exchange_words(angle: Formula) -> str:
    return f"sine and cosine of {to_text(angle)} were exchanged"


def complement_if(angle: Formula) -> Turn:
    return lambda value: PI / 2 - value if value == angle else value


def complement_of(name: str) -> Turn:
    return lambda value: value.substitute({name: PI / 2 - Symbol(name)})


def scene_angles(problem: Problem) -> Iterator[Formula]:
    """All angles of a scene that say how something stands."""
    for element in (*problem.surfaces, *problem.connections, *problem.actions):
        yield from angles_in(element).values()
    lines = (line for state in problem.states for line in state.conditions)
    yield from (line.value for line in lines if tells_angle(line) and line.value is not None)
    if problem.space:
        yield from (turn.by for _, turns in turned_bodies(problem) for turn in turns)
        known = {given.name for given in problem.givens if given.dimension == ANGLE}
        ways = (way for element in (*problem.connections, *problem.actions) for way in ways_in(element).values())
        yield from (Symbol(name) for way in ways for part in way for name in sorted(part.symbols() & known))


def tells_angle(line: Condition) -> bool:
    return line.path is not None and line.path.quantity in ("angle", "tilt") and line.value is not None


def ways_in(element: Element) -> dict[str, tuple[Formula, ...]]:
    """The fields of an element in space that hold a direction by its components."""
    values = {name: getattr(element, name) for name, key in element.declared.items() if key.kind in WAYS}
    return {name: value for name, value in values.items() if isinstance(value, tuple)}


def angles_in(element: Element) -> dict[str, Formula]:
    """The fields of an element that hold a direction."""
    fields = {}
    for name, key in element.declared.items():
        value = getattr(element, name)
        if isinstance(value, Formula) and not key.varies and (key.dimension == "angle" or key.kind == "direction"):
            fields[name] = value
    return fields


def with_turned(turn: Turn) -> Callable[[Problem], Problem]:
    """The scene with other directions."""

    def element(item: Any) -> Any:
        ways = {name: tuple(map(turn, way)) for name, way in ways_in(item).items()}
        return replace(item, **{name: turn(value) for name, value in angles_in(item).items()}, **ways)

    def turns(told: Turns) -> Turns:
        return tuple(replace(one, by=turn(one.by)) for one in told)

    def term(item: Term) -> Term:
        return replace(item, along=tuple(map(turn, item.along))) if isinstance(item.along, tuple) else item

    def line(item: Condition) -> Condition:
        return replace(item, value=turn(item.value)) if tells_angle(item) and item.value is not None else item

    def changed(problem: Problem) -> Problem:
        states = tuple(replace(state, conditions=tuple(map(line, state.conditions))) for state in problem.states)
        elements = {
            name: tuple(map(element, getattr(problem, name))) for name in ("surfaces", "connections", "actions")
        }
        turned = problem
        if problem.space:
            turned = with_turns([name for name, _ in turned_bodies(problem)], turns)(problem)
        finds = tuple(replace(find, terms=tuple(map(term, find.terms))) for find in problem.finds)
        return replace(turned, states=states, finds=finds, **elements)

    return changed
