"""Named alone: the point for which a body stands that is named without one, where something acts on it, strikes it or is carried by it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeVar

from msgspec.structs import replace

from rotsolve.elements.shapes import rim_radius, shape_of
from rotsolve.language.elements import Action, Connection, Event
from rotsolve.language.problem import Body, PointRef, Problem

Bodies = Mapping[str, Body]
Acting = TypeVar("Acting", Action, Connection, Event)


def with_all_points(problem: Problem) -> Problem:
    """The problem with a point of theirs for bodies that are named alone where something acts at a place."""
    bodies = {body.name: body for body in problem.bodies}
    return replace(
        problem,
        actions=tuple([at_its_points(item, bodies) if item.at_points else item for item in problem.actions]),
        connections=tuple([at_its_points(item, bodies) if item.at_points else item for item in problem.connections]),
        events=tuple(
            [
                at_its_points(item, bodies) if item.at_points and between_bodies(item, bodies) else item
                for item in problem.events
            ]
        ),
    )


def between_bodies(item: Event, bodies: Bodies) -> bool:
    """Whether an event is about bodies alone; what strikes a surface or the ground has to name its point."""
    return all(ref.owner in bodies for field in item.pointed for ref in getattr(item, field))


def at_its_points(item: Acting, bodies: Bodies) -> Acting:
    """What acts at places, with points for bodies that are named alone."""
    on: PointRef | None = getattr(item, "on", None)
    places = {field: tuple([middle(ref, bodies) for ref in getattr(item, field)]) for field in item.pointed}
    return replace(item, **places) if on is None else replace(item, **places, on=middle(on, bodies))


def middle(ref: PointRef, bodies: Bodies) -> PointRef:
    """The centre of mass for a body that is named alone and has parts or no centre, save a wheel: that has its centre."""
    body = bodies.get(ref.owner)
    if ref.point is not None or body is None or rim_radius(body, None) is not None:
        return ref
    return replace(ref, point="cm") if body.parts or body.holes or "center" not in shape_of(body).points else ref
