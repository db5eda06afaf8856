"""Places: how far apart and in which direction two points are, where the scene tells both: fixed places, points of hinged bodies."""

from __future__ import annotations

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import ZERO, Formula, sqrt
from rotsolve.core.vectors.heading import RIGHT, UP, Heading, Vector, unit, vector
from rotsolve.language.bodies import PointRef
from rotsolve.language.elements import Moment


def between(first: PointRef, second: PointRef, instant: Moment) -> Vector | None:
    """Unit vector from a point to another; None where the scene does not tell."""
    gap = gap_between(first, second, instant)
    if gap is None:
        return None
    x, y = gap
    for along, across, ahead in ((x, y, RIGHT), (y, x, UP)):
        if across == ZERO:
            question = f"on which side of `{first.owner or 'the place'}` `{second.owner or 'the other end'}` is"
            span = first.span or second.span
            return unit(ahead if instant.configuration.certain_sign(along, question, span) >= 0 else ahead.turned(180))
    whole = distance(gap, instant)
    right, up = (min((side / whole, simplify(side / whole)), key=length) for side in gap)
    return vector(right, RIGHT) + vector(up, UP)


def rightward(line: Heading, ref: PointRef, instant: Moment) -> Heading | None:
    """A line of travel as it runs towards the right; None where it is upright."""
    side = instant.configuration.certain_sign(line.cos(), f"whether `{ref.owner}` moves to the right", ref.span)
    return (line if side > 0 else line.turned(180)) if side else None


def distance(gap: tuple[Formula, Formula], instant: Moment) -> Formula:
    """Length of a gap; where its sign is known from the numbers, without bars."""
    positive = instant.configuration.positive
    barred = simplify(sqrt(gap[0] ** 2 + gap[1] ** 2), positive=positive)
    return simplify(instant.configuration.signs.unbarred(barred), positive=positive)


def gap_between(first: PointRef, second: PointRef, instant: Moment) -> tuple[Formula, Formula] | None:
    """How far a point is to the right of another, and above it."""
    if first.place or second.place:
        places = [where(ref, instant) for ref in (first, second)]
    elif (
        first.owner == second.owner and first.owner not in instant.configuration.bodies
    ):  # two pegs: nothing tells where they are
        return None
    elif instant.host(first.owner) == instant.host(second.owner):  # what rides and what carries it
        places = [instant.point(ref) for ref in (first, second)]
    else:
        joint = joint_of(first.owner, second.owner, instant)
        places = [instant.point(ref) - instant.point(pin) for ref, pin in zip((first, second), joint, strict=False)]
    if len(places) < 2 or places[0] is None or places[1] is None:
        return None
    gap = places[1] - places[0]
    return simplify(gap.along(RIGHT)), simplify(gap.along(UP))


def joint_of(first: str, second: str, instant: Moment) -> tuple[PointRef, ...]:
    """The points of two bodies at which a hinge joins them."""
    for item in instant.configuration.connections(instant.state):
        held = {ref.owner: ref for ref in item.joint()}
        if first != second and held.keys() == {first, second}:
            return held[first], held[second]
    return ()


def where(ref: PointRef, instant: Moment) -> Vector | None:
    """A point in the scene's coordinates: a fixed place, a point of a body whose fixed pivot is the origin, or what travels on a line,
    which is at the origin at the first state."""
    if ref.place is not None:
        return vector(ref.place[0], RIGHT) + vector(ref.place[1], UP)
    if ref.owner in instant.configuration.bodies and instant.motion(ref.owner).kind == "axis":
        return instant.point(ref)
    motion = instant.motion(ref.owner) if ref.owner in instant.configuration.bodies else None
    if motion is not None and motion.heading is not None and motion.bend is None:
        return vector(instant.since_first("displacement", instant.host(ref.owner)), motion.heading)
    return None
