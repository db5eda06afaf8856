"""Limited: what the keys of a scene keep within limits: sizes that are positive, fractions, angles of slopes."""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct
from msgspec.structs import astuple

from rotsolve.algebra.formula import ZERO, Formula, Symbol
from rotsolve.language.bodies import PointRef
from rotsolve.language.keys import Element
from rotsolve.language.problem import Body, Problem, references

WAYS = ("direction", "axis in space")  # kinds of keys


def limited_letters(problem: Problem) -> dict[str, str]:
    """Letters that stand alone where the scene takes only values within limits, with these: the radius of a wheel, the angle of a slope."""
    return {value.name: limits for _, value, limits in limited_values(problem) if isinstance(value, Symbol)}


def letters_of_places(problem: Problem) -> frozenset[str]:
    """Letters in coordinates of points, parts or directions, which may be negative, and in nothing that has limits, as sizes or places on
    rods."""
    named = list(references((problem.bodies, problem.connections, problem.actions, problem.events, problem.finds)))
    sizes = {letter for _, value, _ in limited_values(problem) for letter in value.symbols()}
    sizes |= {letter for ref in named if ref.argument is not None for letter in ref.argument.symbols()}
    found = [ref.place for ref in named if isinstance(ref, PointRef) and ref.place is not None]
    for body in problem.bodies:
        found += [spot for _, spot in body.points]
        found += [part.at for part in (*body.parts, *body.holes) if part.at is not None]
        ends = [spot for part in body.parts for spot in (part.start, part.end) if spot is not None]
        sizes |= {
            letter for spot in ends for part in spot for letter in part.symbols()
        }  # they make the length of a rod
    found += [
        way for element in (*problem.connections, *problem.actions, *problem.events) for way in directions_told(element)
    ]
    return frozenset(letter for spot in found for part in spot for letter in part.symbols()) - sizes


def directions_told(element: Element) -> Iterator[tuple[Formula, ...]]:
    """The directions that an element tells by their components."""
    for field, declared in element.declared.items():
        value = getattr(element, field) if declared.kind in WAYS else None
        if isinstance(value, tuple):
            yield tuple(part for part in value if isinstance(part, Formula))


def limited_values(problem: Problem) -> Iterator[tuple[str, Formula, str]]:
    """What a scene takes only within limits: whose it is, its value, and the limits."""
    for body in problem.bodies:
        yield from ((body.name, value, limits) for value, limits in body_sizes(body) if isinstance(value, Formula))
    for element in (*problem.surfaces, *problem.connections, *problem.actions, *problem.events):
        yield from ((element.name, value, limits) for value, limits in limits_of(element) if isinstance(value, Formula))


def body_sizes(body: Body) -> Iterator[tuple[Formula | None, str]]:
    """What is positive of a body: its mass, unless it is light, its radii, the sizes of its shape, and these of its parts and holes."""
    sizes = (body.mass, body.inertia, body.density, body.gyration, body.radius)
    yield from ((size, "positive") for size in sizes if size != ZERO)
    yield from ((radius, "positive") for _, radius in body.radii)
    if body.shape is not None:
        yield from limits_of(body.shape)
    for part in (*body.parts, *body.holes):
        yield from body_sizes(part.body)


def limits_of(element: Element) -> Iterator[tuple[Formula | None, str]]:
    """The values of an element under keys that limit them; what nobody wrote is as its class has it."""
    own = dict(zip(reversed(element.__struct_fields__), reversed(element.__struct_defaults__), strict=False))
    for field, declared in element.declared.items():
        value = getattr(element, field) if declared.limits else None
        if value is own.get(field):
            continue
        yield from ((size, declared.limits) for size in formulas_in(value))


def formulas_in(value: object) -> Iterator[Formula]:
    """The formulas of a value: of one, of several as the sides of a box, of radii with their names, of a pair of coefficients."""
    if isinstance(value, Formula):
        yield value
    elif isinstance(value, (tuple, Struct)):
        for part in value if isinstance(value, tuple) else astuple(value):
            yield from formulas_in(part)
