"""Collision: momentum and angular momentum through an event that takes no time: what it leaves unchanged, and what its blows change."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.formula import ZERO, Formula, negate
from rotsolve.core.derivation import Words
from rotsolve.core.equation import ANGULAR_MOMENTUM, Equation
from rotsolve.core.facts import Force, signed
from rotsolve.core.passage import Encounter, Meeting
from rotsolve.core.vectors.heading import RIGHT, UP, Heading, Vector
from rotsolve.core.writing import flat, moved, multiplied_out, spoken
from rotsolve.motion.bodies.rigid import tidy


def through_event(encounter: Encounter, section: str) -> Iterator[Equation]:
    """All that an event keeps or changes: groups as wholes first, then each body with the blows on it."""
    for group in encounter.groups:
        members = [meeting for meeting in encounter.meetings if meeting.body.name in group]
        yield from whole(encounter, group, members, section)
    for meeting in encounter.meetings:
        yield from single(meeting, section)
    yield from rebound(encounter, section)


def rebound(encounter: Encounter, section: str) -> Iterator[Equation]:
    """Speed of separation = e · speed of approach, where the scene tells e."""
    if encounter.restitution is not None:
        coefficient, approach, separation = encounter.restitution
        yield Equation(separation, coefficient * approach, "coefficient of restitution", section, "", 2)


def whole(encounter: Encounter, group: frozenset[str], members: list[Meeting], section: str) -> Iterator[Equation]:
    """Angular momentum of a group about its support, or momentum and angular momentum of a free one."""
    names = tuple(sorted(group))
    pivot = next((encounter.pivot[name] for name in names if name in encounter.pivot), None)
    outside = [blow for meeting in members for blow in meeting.blows if not blow.internal]
    alone = pivot is None and len(members) == 1  # its own angular momentum is that about its centre of mass
    if all(meeting.place is not None for meeting in members) and not alone:
        sense = next((item.body.motion.sense for item in members if item.body.motion.turns or item.held), 1)
        before = [term for item in members for term in spin_terms(item, sense, after=False)]
        after = [term for item in members for term in spin_terms(item, sense, after=True)]
        torque = [
            signed(arm_from_point(item, blow).cross(blow.vector), sense)
            for item in members
            for blow in item.blows
            if not blow.internal
        ]
        point = f"about the {pivot}" if pivot else "about the meeting point"
        label = (
            f"angular momentum {point} is conserved"
            if not flat(torque)
            else f"angular impulse = change of angular momentum, {point}"
        )
        words: Words = (f"No outside torque acts {point}: {why_none(members)}.",) if pivot and not outside else ()
        if flat(before) or flat(after):
            yield Equation(*moved([*before, *torque], after), label, section, ANGULAR_MOMENTUM, 3, words, bodies=names)
    if pivot is None:
        yield from linear(members, outside, section, names)


def why_none(members: list[Meeting]) -> str:
    """Why nothing from outside turns a group about its support: bodies that all turn on it already push it to no side."""
    if len(members) > 1 and all(item.body.motion.kind == "axis" for item in members):
        names = [spoken(item.body.name) for item in members]
        return f"what {', '.join(names[:-1])} and {names[-1]} do to each other cancels"
    return "the blow at the support has no arm"


def linear(members: list[Meeting], outside: list[Force], section: str, names: tuple[str, ...]) -> Iterator[Equation]:
    """Σ m v of a free group, along the one line of travel or right and up."""
    headings = {item.body.motion.heading for item in members}
    first = next(iter(headings))
    axes: tuple[Heading, ...] = (first,) if len(headings) == 1 and first is not None else (RIGHT, UP)
    for axis in axes:
        before = [item.body.mass * item.before.along(axis) for item in members]
        after = [item.body.mass * item.after.along(axis) for item in members]
        blow = [force.vector.along(axis) for force in outside]
        if flat(before) or flat(after) or flat(blow):
            label = "momentum is conserved" if not flat(blow) else "impulse = change of momentum"
            yield Equation(*moved([*before, *blow], after), label, section, ANGULAR_MOMENTUM, 3, bodies=names)


def spin_terms(item: Meeting, sense: int, *, after: bool) -> list[Formula]:
    """r × m v + I ω of one body about the common point, along a sense; a body on the axis has I about it."""
    if after and item.held is not None:
        return [item.held * signed(item.spin_after, sense)]
    velocity, spin = (item.after, item.spin_after) if after else (item.before, item.spin_before)
    terms = [item.inertia * signed(spin, sense)]
    if item.body.motion.kind != "axis" and item.place is not None:
        terms.append(signed(multiplied_out(item.place.cross(velocity.scaled(item.body.mass))), sense))
    return [term for term in terms if term != ZERO]


def arm_from_point(item: Meeting, blow: Force) -> Vector:
    """Arm of a blow from the common point."""
    if item.body.motion.kind == "axis" or item.place is None:
        return blow.arm
    return tidy(item.place + blow.arm - item.body.cm)


def single(item: Meeting, section: str) -> Iterator[Equation]:
    """m Δv = ΣJ and I Δω = Σ r × J of one body."""
    body = item.body
    for axis in body.axes:
        pushes = [blow.vector.along(axis) for blow in item.blows]
        change = [body.mass * item.after.along(axis), negate(body.mass * item.before.along(axis))]
        if flat(pushes) or flat(change):
            left, right = moved([*pushes, body.mass * item.before.along(axis)], [change[0]])
            label = f"impulse = change of momentum, {spoken(body.name)}"
            yield Equation(left, right, label, section, ANGULAR_MOMENTUM, 4, bodies=(body.name,))
    if body.motion.turns:
        sense = body.motion.sense
        pushes = [signed(blow.arm.cross(blow.vector), sense) for blow in item.blows]
        pushes += [signed(twist, sense) for twist in item.twists]
        before, after = (item.inertia * signed(spin, sense) for spin in (item.spin_before, item.spin_after))
        if flat(pushes) or flat([before, after]):
            about_centre = "" if body.motion.kind == "axis" else " about the centre of mass"
            label = f"angular impulse = change of angular momentum, {spoken(body.name)}{about_centre}"
            yield Equation(*moved([*pushes, before], [after]), label, section, ANGULAR_MOMENTUM, 4, bodies=(body.name,))
