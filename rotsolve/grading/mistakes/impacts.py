"""Mistakes with blows: angular momentum about a point that is pushed, a free body taken as held, restitution at the wrong points."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.equation import ANGULAR_MOMENTUM, Equation, Law
from rotsolve.core.passage import Alteration, Encounter, Meeting
from rotsolve.core.vectors.heading import NOWHERE, RIGHT, UP, Vector
from rotsolve.core.writing import spoken
from rotsolve.grading.mistakes.energies import Laws, blows_of_event, in_event
from rotsolve.grading.mistakes.mistake import Change, Made
from rotsolve.laws import momentum
from rotsolve.laws.rules import rules_through_event
from rotsolve.laws.table import EVENT, ThroughEvent, equations_for

if TYPE_CHECKING:
    from rotsolve.grading.mistakes.scene import Scene

HELD = Law("held at its centre", "the centre is taken as held", ANGULAR_MOMENTUM, 3)


def about_the_centre(scene: Scene) -> Made:
    """L about the centre of mass of a held body is taken as changed by the blow alone, though the support pushes with an arm there."""
    for encounter in scene.equations.encounters.values():
        held = [item for item in encounter.meetings if item.body.motion.kind == "axis" and item.body.cm.parts]
        for item in held if encounter.about else ():
            name = spoken(item.body.name)
            words = f"angular momentum was taken about the centre of mass of {name}, where the {encounter.about} pushes with an arm"
            yield words, Change(altered=Alteration(event=in_event(encounter.name, about_centre_of(item.body.name))))


def about_centre_of(name: str) -> Laws:
    """The laws of an event about the centre of mass of a body, without the impulses of supports."""

    def changed(encounter: Encounter, section: str) -> Iterator[Equation]:
        middle = next(item for item in encounter.meetings if item.body.name == name)
        if middle.place is None or any(item.place is None for item in encounter.meetings):
            return
        origin = middle.place + middle.body.cm
        members = tuple(about_point_of(item, origin, encounter, own=item is middle) for item in encounter.meetings)
        yield from about_that_point(replace(encounter, about=""), members, section)

    return changed


def about_that_point(encounter: Encounter, members: tuple[Meeting, ...], section: str) -> Iterator[Equation]:
    """Angular momentum with places from another point, beside all else that holds through the event."""
    moved = replace(encounter, meetings=members, joined=())
    yield from momentum.about_common_point(moved, section, tuple(sorted(item.body.name for item in members)))
    yield from momentum.restitution(ThroughEvent(encounter, section))
    yield from rules_through_event(ThroughEvent(encounter, section))


def about_point_of(item: Meeting, origin: Vector, encounter: Encounter, *, own: bool) -> Meeting:
    """A body with its place from a point, and the event's blows alone; of what has its centre of mass there, I about that."""
    assert item.place is not None
    arm = item.body.cm
    moved = replace(item, place=item.place - origin, blows=blows_of_event(item, encounter), twists=(), held=None)
    if not own:
        return moved
    inertia = simplify(item.inertia - item.body.mass * arm.dot(arm))
    return replace(moved, inertia=inertia, before=NOWHERE, after=NOWHERE)


def centre_held(scene: Scene) -> Made:
    """A free body that is struck turns about its centre of mass as if that stayed where it is."""
    for encounter in scene.equations.encounters.values():
        free = [item for item in encounter.meetings if item.body.motion.kind == "plane" and item.spin_after != ZERO]
        for item in free if not encounter.about and len(free) == len(encounter.givers) == 1 else ():
            words = f"the centre of mass of {spoken(item.body.name)} was taken as held in the {spoken(encounter.name)}"
            yield words, Change(altered=Alteration(event=in_event(encounter.name, held_at_centre(item.body.name))))


def held_at_centre(name: str) -> Laws:
    """The laws of an event with a body whose centre of mass does not move off."""

    def changed(encounter: Encounter, section: str) -> Iterator[Equation]:
        middle = next(item for item in encounter.meetings if item.body.name == name)
        if middle.place is None or any(item.place is None for item in encounter.meetings):
            return
        origin = middle.place + middle.body.cm
        members = tuple(
            replace(item, place=item.place - origin) for item in encounter.meetings if item.place is not None
        )
        yield from about_that_point(encounter, members, section)
        for axis in (RIGHT, UP):
            after = middle.after.along(axis)
            if after != ZERO:
                yield HELD.equation(after, middle.before.along(axis), section, (name,))

    return changed


def restitution_of_centres(scene: Scene) -> Made:
    """The speeds of the centres of mass are put into the restitution, for those of the points that meet."""
    for interval in scene.equations.configuration.timeline.intervals:
        for event in interval.event.each() if interval.event is not None else ():
            first, last = (scene.equations.instant(state) for state in (interval.start, interval.end))
            bounce = event.of_centres().bounce(first, last)
            if bounce is not None and any(ref.point is not None for ref in event.points(())):
                altered = Alteration(event=in_event(interval.name, with_bounce(event.name, bounce)))
                words = f"the restitution in the {spoken(event.name)} was taken between the centres of mass"
                yield words, Change(altered=altered)


def with_bounce(event: str, bounce: tuple[Formula, Formula, Formula]) -> Laws:
    """The laws of an event with another speed of approach and of separation."""

    def changed(encounter: Encounter, section: str) -> Iterator[Equation]:
        told = [closing.event for closing in encounter.closings if closing.told]
        bounces = tuple(bounce if name == event else one for name, one in zip(told, encounter.bounces, strict=True))
        return iter(equations_for(EVENT, ThroughEvent(replace(encounter, bounces=bounces), section)))

    return changed
