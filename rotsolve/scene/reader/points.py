"""Points: `rod.end`, `rod.at(x)`, `drum.inner`, `ground`, or a place `[x, y]`; which points a body has."""

from __future__ import annotations

import re

from rotsolve.algebra.formula import Formula
from rotsolve.core.faults import Span
from rotsolve.elements.shapes import WHEEL, Rod
from rotsolve.language.problem import Body, PointRef
from rotsolve.language.words import hint, quoted
from rotsolve.scene.tree.nodes import List, Map, Node, Text
from rotsolve.scene.values.literals import Want
from rotsolve.scene.values.scope import Scope
from rotsolve.scene.values.values import value

POINT = re.compile(r"\s*(?P<owner>[^\W\d]\w*)(?:\.(?P<point>[^\W\d]\w*)\s*(?P<call>\(.*\))?)?\s*", re.DOTALL)
KINDS = {"body": "bodies", "surface": "surfaces", "connection": "connections"}


def points_of(body: Body) -> tuple[str, ...]:
    """The names of a body's points."""
    shape = body.shape
    if shape is not None:
        own = tuple(getattr(shape, "points", ()))
        if not own:
            own = tuple(f"corner{number}" for number in range(1, len(getattr(shape, "corners", ())) + 1))
    else:
        round_ = any(item is not None for item in (body.inertia, body.gyration, body.radius)) or body.radii
        own = WHEEL if round_ else ("center",)
    named = (
        *(name for name, _ in body.radii),
        *(name for name, _ in body.points),
        *(part.body.name for part in body.parts),
    )
    return tuple(dict.fromkeys((*own, *named, "cm")))


def read_place(scope: Scope, node: Node, label: str, owner: str) -> tuple[Formula, Formula] | None:
    """A place `[x, y]` in the plane."""
    if not isinstance(node, List) or len(node.items) not in (2, 3):
        scope.fault(node, f"`{label}` wants a place `[x, y]`", kind="form")
        return None
    if len(node.items) == 3:
        scope.later(node, "a place in space")
    x, y = (
        value(scope, item, Want(label, "length", letter, owner))
        for item, letter in zip(node.items[:2], "xy", strict=True)
    )
    return None if x is None or y is None else (x, y)


def read_spot(scope: Scope, node: Node, label: str, owner: str) -> tuple[Formula, ...] | None:
    """A place `[x, y]` or `[x, y, z]` of a body, z its height above the picture."""
    if not isinstance(node, List) or len(node.items) not in (2, 3):
        scope.fault(node, f"`{label}` wants a place `[x, y]` or `[x, y, z]`", kind="form")
        return None
    found = [
        value(scope, item, Want(label, "length", letter, owner))
        for item, letter in zip(node.items, "xyz", strict=False)
    ]
    return tuple(item for item in found if item is not None) if None not in found else None


def read_point(
    scope: Scope, node: Node, label: str, owner: str, kinds: tuple[str, ...] = ("body", "surface")
) -> PointRef | None:
    """A point by name or place."""
    if isinstance(node, List):
        place = read_place(scope, node, label, owner)
        return None if place is None else PointRef("", None, None, place, node.span)
    if isinstance(node, Map):
        scope.fault(node, f"`{label}` wants a point such as `rod.end`, but this is a map", kind="form")
        return None
    match = POINT.fullmatch(node.value)
    if not match:
        scope.fault(
            node, f"{quoted(node.value)} is no point", "write `body`, `body.point`, `rod.at(x)` or `[x, y]`", "form"
        )
        return None
    name = match["owner"]
    place_of_name = node.part(match.start("owner"), match.end("owner"))
    if scope.kinds.get(name) not in kinds:
        wrong_owner(scope, place_of_name, name, label, kinds)
        return None
    if match["point"] is None:
        return PointRef(name, None, None, None, node.span)
    return point_of(scope, node, match, label)


def wrong_owner(scope: Scope, span: Span, name: str, label: str, kinds: tuple[str, ...]) -> None:
    """A name that is unknown, or names something without points."""
    plural = " and ".join(KINDS[kind] for kind in kinds)
    names = scope.names(*kinds)
    kind = scope.kinds.get(name)
    if name in scope.conflicts:
        return
    if kind:
        scope.fault(span, f"`{label}` wants a body, but `{name}` is a {kind}", f"{plural}: {', '.join(names)}", "kind")
    else:
        scope.unknown(span, name, " or ".join(kinds), names, plural, f" in `{label}`")


def point_of(scope: Scope, node: Text, match: re.Match[str], label: str) -> PointRef | None:
    """The named point of a body, checked against the points that the body has."""
    name, point = match["owner"], match["point"]
    span = node.part(match.start("point"), match.end("point"))
    if scope.kinds[name] != "body":
        scope.fault(span, f"`{name}` is a {scope.kinds[name]} and has no points", "write its name alone", "point")
        return None
    body = scope.bodies.get(name)
    if body is None:  # the body has a fault of its own
        return None
    rod = isinstance(body.shape, Rod)
    if point == "at" and match["call"]:
        if not rod:
            scope.fault(
                span,
                f"`at(…)` is a point of rods only, and `{name}` is none",
                f"points: {', '.join(scope.points[name])}",
                "point",
            )
            return None
        start, end = match.start("call") + 1, match.end("call") - 1
        inner = Text(node.value[start:end], node.part(start, end), True, node.exact)
        argument = value(scope, inner, Want("at(…)", "length", "x", name, "nonnegative"))
        return None if argument is None else PointRef(name, "at", argument, None, node.span)
    if match["call"] or point not in scope.points[name]:
        names = [*scope.points[name], *(["at(x)"] if rod else [])]
        scope.fault(span, f"`{name}` has no point {quoted(point)}", hint(point, names, "points"), "point")
        return None
    return PointRef(name, point, None, None, node.span)
