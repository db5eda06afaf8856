"""Closing: bodies that are hinged to the ground at told places, and to each other, have to reach from one place to the other."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any, Protocol

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import Formula
from rotsolve.core.symbols import has_quantities
from rotsolve.core.vectors.heading import RIGHT, UP, Vector, cartesian
from rotsolve.core.writing import and_joined
from rotsolve.language.bodies import PointRef
from rotsolve.language.elements import Connection
from rotsolve.language.noted import unread
from rotsolve.language.problem import State
from rotsolve.motion.instant import Instant
from rotsolve.motion.rigid import tidy
from rotsolve.paths.meaning import NotYet

CLOSED = 0.005  # of the longest way from a place to a joint, by which told angles may be rounded


class Holder(Protocol):
    """What holds bodies to the ground at a place."""

    @property
    def at(self) -> tuple[Formula, ...]: ...

    def fixed_points(self) -> tuple[PointRef, ...]: ...


def placed(items: Sequence[Connection]) -> list[Holder]:
    """What holds bodies to the ground at a place that the scene tells; to look is no use of it."""
    held: list[Any] = [item for item in items if item.guiding and item.fixed_points()]
    return [item for item in held if "at" in unread(item) or getattr(item, "at", None)]


def check_closed(state: State, instant: Instant) -> None:
    """Refused where linked bodies do not reach from a place to another one, with the angles that the state tells."""
    holders = placed(instant.configuration.connections(state.name))
    for gap, joint, names, longest in gaps_to_close(holders, instant) if len(holders) > 1 else ():
        linked = and_joined([f"`{name}`" for name in names])
        sides = [tidy(gap).along(axis) for axis in (RIGHT, UP)]
        if any(map(has_quantities, sides)):
            help = f"tell the `angle` of each of {linked}: of what closes there may be two ways"
            raise NotYet(
                f"how the bodies between two told places stand at `{state.name}` is not told", state.span, help
            )
        if all(map(is_zero, sides)):
            continue
        numbers = [instant.configuration.signs.number(side) for side in (*sides, *longest)]
        if None in numbers:
            message = f"whether {linked} reach from one told place to the other at `{state.name}` hangs on letters"
            raise NotYet(message, state.span, "give numbers to the letters, or leave the places out")
        x, y, *ways = (number.float for number in numbers if number is not None)
        if x * x + y * y > (CLOSED * max(map(abs, ways))) ** 2:
            apart = (x * x + y * y) ** 0.5
            message = (
                f"{linked} do not close at `{state.name}`: the points that `{joint}` joins would be {apart:.3g} m apart"
            )
            raise NotYet(message, state.span, "check the places, the lengths and the angles")


Gap = tuple[Vector, str, list[str], list[Formula]]


def gaps_to_close(holders: Sequence[Holder], instant: Instant) -> Iterator[Gap]:
    """For each joint that closes a loop between told places how far apart its points would be; with the joint, the bodies that have a
    place by then, and how far these reach."""
    bodies = instant.configuration.bodies
    joints = [item for item in instant.configuration.connections(instant.state) if len(item.joint()) == 2]
    waiting = [item for item in joints if all(ref.owner in bodies for ref in item.joint())]
    linked = [item for item in holders if others_linked(item, holders, waiting, instant)]
    where = {
        instant.host(ref.owner): cartesian(*item.at) - instant.point(ref)
        for item in linked
        for ref in item.fixed_points()
    }
    while known := next((one for one in waiting if any(instant.host(ref.owner) in where for ref in one.joint())), None):
        waiting = [item for item in waiting if item is not known]
        one, other = sorted(known.joint(), key=lambda ref: instant.host(ref.owner) not in where)
        there = where[instant.host(one.owner)] + instant.point(one)
        if instant.host(other.owner) in where:
            gap = there - where[instant.host(other.owner)] - instant.point(other)
            yield gap, known.name, list(where), [tidy(there).along(axis) for axis in (RIGHT, UP)]
        else:
            where[instant.host(other.owner)] = there - instant.point(other)


def others_linked(item: Holder, holders: Sequence[Holder], joints: Sequence[Connection], instant: Instant) -> bool:
    """Whether what an element holds is linked by joints to what another one holds at a told place."""
    group = {instant.host(ref.owner) for ref in item.fixed_points()}
    while more := {
        name
        for joint in joints
        for name in (instant.host(ref.owner) for ref in joint.joint())
        if name not in group and any(instant.host(ref.owner) in group for ref in joint.joint())
    }:
        group |= more
    held = {instant.host(ref.owner) for other in holders if other is not item for ref in other.fixed_points()}
    return bool(group & held)
