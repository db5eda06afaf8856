"""Events: what happens in no time between two states."""

from __future__ import annotations

from typing import ClassVar

from rotsolve.algebra.formula import Formula
from rotsolve.elements.actions import DIRECTIONS, Direction
from rotsolve.language.keys import Element, key
from rotsolve.language.problem import PointRef


class Event(Element, frozen=True):
    """Base of all events: the state before and the state after."""

    word: ClassVar[str] = ""
    about: ClassVar[str] = ""
    quantities: ClassVar[tuple[str, ...]] = ()
    later: ClassVar[bool] = False
    name: str = ""
    from_: str | None = key("name", "the state before", default=None, refers=("state",), required=True)
    to: str | None = key("name", "the state after", default=None, refers=("state",), required=True)


class Joins(Event, frozen=True):
    word = "joins"
    about = "two bodies meet and stay together (inelastic)"
    quantities = ("impulse", "angular_impulse")
    joins: tuple[PointRef, ...] = key(
        "points", "the two bodies, or points of them", count=(2, 2), required=True, example="[putty, beam.end]"
    )


class Collides(Event, frozen=True):
    word = "collides"
    about = "two bodies bounce off each other"
    quantities = ("impulse", "angular_impulse")
    collides: tuple[PointRef, ...] = key(
        "points", "the two bodies, or points of them", count=(2, 2), required=True, example="[ball, rod.end]"
    )
    restitution: Formula | None = key(
        "quantity",
        "coefficient of restitution, 0 to 1",
        dimension="number",
        letter="e",
        limits="fraction",
        default=None,
    )
    friction: Formula | None = key(
        "quantity",
        "coefficient of friction in the collision",
        dimension="number",
        letter="mu",
        limits="nonnegative",
        default=None,
    )


class Impulse(Event, frozen=True):
    word = "impulse"
    about = "a blow: an impulse on a point of a body"
    quantities = ("impulse", "angular_impulse")
    impulse: Formula | None = key(
        "quantity", "size; `unknown` asks for it", dimension="impulse", letter="J", required=True
    )
    on: PointRef | None = key("point", "where it acts", required=True, example="rod.end")
    direction: Direction | None = key(
        "direction",
        "right, left, up, down, tangential, clockwise, counterclockwise, [x, y] or an angle",
        default=None,
        choices=DIRECTIONS,
    )


class Cuts(Event, frozen=True):
    word = "cuts"
    about = "a string or other connection is gone from then on"
    cuts: tuple[str, ...] = key(
        "names", "the connection", refers=("connection",), required=True, default=(), example="cord"
    )


class Removes(Event, frozen=True):
    word = "removes"
    about = "a support, action or body is taken away"
    removes: tuple[str, ...] = key(
        "names",
        "the connection, action or body",
        refers=("connection", "action", "body"),
        required=True,
        default=(),
        example="prop",
    )


class Fixes(Event, frozen=True):
    word = "fixes"
    about = "a point of a moving body is suddenly held; from then on the body turns about it"
    quantities = ("force", "impulse")
    fixes: PointRef | None = key("point", "the point", required=True, example="plate.corner1")


class Grips(Event, frozen=True):
    word = "grips"
    about = "a contact begins and does not slip: the touching point of the body is suddenly at rest"
    quantities = ("impulse",)
    grips: str | None = key("name", "the contact", refers=("connection",), required=True, default=None)


EVENTS: tuple[type[Event], ...] = (Joins, Collides, Impulse, Cuts, Removes, Fixes, Grips)
