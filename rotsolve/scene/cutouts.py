"""Cutouts: holes that leave nothing of a body, stick out of it, or overlap, as far as the numbers tell."""

from __future__ import annotations

import math
from collections.abc import Mapping

from msgspec import Struct

from rotsolve.algebra.formula import ZERO
from rotsolve.core.faults import Unsolvable
from rotsolve.elements.shapes.material import amounts
from rotsolve.language.problem import Body, Part
from rotsolve.motion.limits import depth_margins
from rotsolve.scene.rough import rough
from rotsolve.scene.scope import Scope
from rotsolve.scene.tree import Map, Node, Text

TOLERANCE = 1e-9


class Outline(Struct, frozen=True):
    """A round or rectangular shape at its place: a radius, or half its width and height; how far round an inner rim is."""

    place: tuple[float, ...]
    radius: float | None = None
    inner: float = 0.0
    sides: tuple[float, float] = (0.0, 0.0)
    angle: float = 0.0

    def corners(self) -> list[tuple[float, ...]]:
        (width, height), (c, s) = self.sides, (math.cos(self.angle), math.sin(self.angle))
        around = [(width, height), (-width, height), (-width, -height), (width, -height)]
        return [(self.place[0] + x * c - y * s, self.place[1] + x * s + y * c) for x, y in around]

    def leaves(self, whole: Outline) -> bool:
        """Whether some of this outline lies outside of a whole that is centred at the origin."""
        points = [self.place] if self.radius is not None else self.corners()
        room = self.radius or 0.0
        if whole.radius is not None:
            bounds = [(math.hypot(*point) + room, whole.radius) for point in points]
            if self.radius is not None:
                bounds.append((whole.inner + room, math.hypot(*self.place) if whole.inner else room))
        else:
            bounds = [(abs(x) + room, side) for point in points for x, side in zip(point, whole.sides, strict=False)]
        return any(reach > limit * (1 + TOLERANCE) for reach, limit in bounds)

    def overlaps(self, other: Outline) -> bool:
        """Whether two outlines share more than their rims: not where a direction parts them, of their sides or between centres."""
        if len(self.place) != len(other.place):
            return False
        between = math.atan2(self.place[1] - other.place[1], self.place[0] - other.place[0])
        angles = [between, *(one.angle + turn for one in (self, other) for turn in (0.0, math.pi / 2))]
        angles += [
            math.atan2(y - one.place[1], x - one.place[0])
            for one, rim in ((self, other), (other, self))
            if one.radius is not None and rim.radius is None
            for x, y in rim.corners()
        ]
        return not any(self.parted(other, angle) for angle in angles)

    def parted(self, other: Outline, angle: float) -> bool:
        """Whether nothing of both is as far along a direction."""
        (low, high), (lower, higher) = self.reach(angle), other.reach(angle)
        return min(high, higher) - max(low, lower) <= TOLERANCE * max(high - low, higher - lower)

    def reach(self, angle: float) -> tuple[float, float]:
        """From where to where it goes along a direction."""
        points = [self.place] if self.radius is not None else self.corners()
        along = [x * math.cos(angle) + y * math.sin(angle) for x, y, *_ in points]
        return min(along) - (self.radius or 0.0), max(along) + (self.radius or 0.0)


def check_holes(scope: Scope, name: str, node: Node, body: Body) -> None:
    """Holes lie within a body, beside each other, and take away less than all of it."""
    written = scope.entries(node, f"the parts of `{name}`") if isinstance(node, Map) else {}
    if not all(check_hole(scope, body, hole, written) for hole in body.holes):
        return
    whole, *cut = rough_sizes(scope, body) or (None,)
    if whole is not None and sum(size or 0.0 for size in cut) >= whole:
        scope.fault(node, f"the holes leave nothing of `{name}`", kind="limits")
        return
    edge = outline(scope, Part(body, (ZERO, ZERO)))
    holes = [(hole.body.name, None if hole.turned else outline(scope, hole)) for hole in body.holes]
    for part in body.holes:
        gaps = [rough(gap, scope.numbers) for gap in depth_margins(part, body.shape)]
        if any(gap is not None and gap < -TOLERANCE for gap in gaps):
            place = written[part.body.name][1] if part.body.name in written else node
            help = "check its length, and where it is along the axis: a hole that goes through needs no length"
            scope.fault(place, f"the hole `{part.body.name}` sticks out of `{name}`", help, "limits")
    for index, (word, hole) in enumerate(holes):
        place = written[word][1] if word in written else node
        if hole is None:
            continue
        if edge is not None and hole.leaves(edge):
            help = "check its size, and `at`: where its centre is, from the centre of the body"
            scope.fault(place, f"the hole `{word}` sticks out of `{name}`", help, "limits")
        for before, other in holes[:index]:
            if other is not None and hole.overlaps(other):
                help = "holes lie beside each other; check their sizes and places"
                scope.fault(place, f"the holes `{before}` and `{word}` of `{name}` overlap", help, "limits")


def check_hole(scope: Scope, body: Body, hole: Part, written: Mapping[str, tuple[Text, Node]]) -> bool:
    """Whether a hole has a shape that is cut out of one, and no inertia of its own."""
    own, (key, node) = hole.body, written[hole.body.name]
    if body.shape is None or body.shape.pointlike:
        scope.fault(
            key, f"`{body.name}` has no shape out of which `{own.name}` could be cut", "tell its `shape`", "form"
        )
    elif own.shape is None or own.shape.pointlike:
        scope.fault(
            node, f"the hole `{own.name}` has no `shape` that has a size", "write `shape: disc` or the like", "missing"
        )
    elif own.inertia is not None or own.gyration is not None or own.tensor is not None:
        scope.fault(
            node,
            f"the hole `{own.name}` has an inertia of its own",
            "its shape and place tell what it takes away",
            "form",
        )
    else:
        return True
    return False


def outline(scope: Scope, part: Part) -> Outline | None:
    """Where a round or rectangular part lies; None where its shape is another, or a number is missing."""
    shape, numbers = part.body.shape, scope.numbers
    place = [rough(x, numbers) for x in (part.at or (ZERO, ZERO))]
    angle = 0.0 if part.angle is None else rough(part.angle, numbers)
    spot = tuple(x for x in place if x is not None)
    if shape is None or len(spot) < len(place) or angle is None:
        return None
    sides = [rough(side, numbers) for side in shape.box()]
    if len(sides) == 2 and sides[0] is not None and sides[1] is not None:
        return Outline(spot, sides=(sides[0] / 2, sides[1] / 2), angle=angle)
    if not shape.round:
        return None
    radii = dict(getattr(shape, "radii", ()))
    outer = radii.get("outer", getattr(shape, "radius", None))
    radius = None if outer is None else rough(outer, numbers)
    inner = rough(radii.get("inner", ZERO), numbers)
    return None if radius is None or inner is None else Outline(spot, radius, inner)


def rough_sizes(scope: Scope, body: Body) -> list[float | None]:
    """The length, area or volume of a body and of its holes as rough numbers; none where a size is left out."""
    shapes = [item.shape for item in (body, *(hole.body for hole in body.holes)) if item.shape is not None]
    if len(shapes) <= len(body.holes) or any("radius" in shape.left_out() for shape in shapes):
        return []
    try:
        return [rough(size, scope.numbers) for size in amounts(body)]
    except (NotImplementedError, TypeError, IndexError, Unsolvable):
        return []  # what can't be is refused when the scene is whole
