"""Bodies: shape, mass, sizes, parts, holes, points, and the declared positive senses."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.drive import TURNING
from rotsolve.core.symbols import is_coordinate
from rotsolve.elements.shapes import Particle, Shape
from rotsolve.elements.tables import SHAPES
from rotsolve.language.grammar import BODY, PART
from rotsolve.language.keys import Key, keys_of
from rotsolve.language.problem import Body, Part
from rotsolve.language.words import an, hint, nearest_name, quoted
from rotsolve.scene.elements import read_keys, read_value
from rotsolve.scene.in_space import in_plane_only, in_space_only, read_axis, read_principal, read_rotations, read_tensor
from rotsolve.scene.literals import Want
from rotsolve.scene.paths import point_names, read_spot
from rotsolve.scene.rough import rough
from rotsolve.scene.scope import NAME, Scope
from rotsolve.scene.tree import List, Map, Node, Text
from rotsolve.scene.values import read_scalar

Entries = dict[str, tuple[Text, Node]]


def read_body(scope: Scope, name: str, key: Text, node: Node) -> Body | None:
    """One entry of `bodies`."""
    if isinstance(node, Text):
        body = short_body(scope, name, key, node)
    else:
        shape = named_shape(scope, node)
        entries = scope.entries(node, f"body `{name}`", keys_allowed(shape, ()))
        body = build_body(scope, name, key, entries, shape)
    if scope.space and name == "body" and len(scope.names("body")) > 1:
        scope.fault(
            key,
            "`body` can't name one of several bodies: `in body axes` means those of each",
            "choose another name",
            "name",
        )
    if body is not None:
        scope.bodies[name] = body
        scope.points[name] = point_names(body)
    return body


def short_body(scope: Scope, name: str, key: Text, node: Text) -> Body | None:
    """`ball: particle`: a shape alone."""
    shape = SHAPES.of(node.value.strip())
    if shape is None:
        message = f"body `{name}` wants a map, but this is {quoted(node.value)}"
        return scope.fault(node, message, "write `{shape: disc, mass: M}`", "form")
    if shape.later:
        scope.later(node, shape.word)
    return Body(name, shape(), span=key.span)


def named_shape(scope: Scope, node: Node) -> type[Shape] | None:
    """The shape that a body or part names."""
    written = (node.get("shape") or nearly_shape(node)) if isinstance(node, Map) else None
    if written is None or (isinstance(written, Text) and written.empty):
        return None
    if not isinstance(written, Text):
        return scope.fault(written, "`shape` wants one word", hint("", SHAPES.words, "shapes"), "form")
    word = " ".join(written.value.split())
    shape = SHAPES.of(word)
    if shape is None:
        scope.unknown(written, word, "shape", SHAPES.words, "shapes", own=False)
        near = nearest_name(word, SHAPES.words)
        shape = SHAPES.of(near) if near is not None else None
    elif shape.later:
        scope.later(written, word)
    return shape


def nearly_shape(node: Map) -> Node | None:
    """What stands under a key that is nearly `shape`, as its fault says of it."""
    written = [(key.value, value) for key, value in node.entries if key.value not in BODY and key.value not in PART]
    known = [word for cls in SHAPES for word, _ in keys_of(cls)] if written else []
    near = (
        value for word, value in written if word not in known and nearest_name(word, [*known, *BODY, *PART]) == "shape"
    )
    return next(near, None)


def keys_allowed(shape: type[Shape] | None, more: tuple[str, ...]) -> list[str]:
    """The keys of a body with this shape."""
    own = [word for word, _ in keys_of(shape)] if shape else ["radius"]
    return list(dict.fromkeys((*own, *(word for word in BODY if word != "radius"), *more)))


def build_body(
    scope: Scope, name: str, key: Text, entries: Entries, shape: type[Shape] | None, skip: tuple[str, ...] = ()
) -> Body:
    """The body from its entries."""
    fields: dict[str, Any] = {}
    own = {word for word, _ in keys_of(shape)} if shape else set()
    if shape is not None:
        fields["shape"] = shape(**read_keys(scope, shape, name, entries))
        for word, declared in keys_of(shape):
            if declared.required and word not in entries:
                scope.fault(key, f"`{name}` needs `{word}`", f"{an(shape.word)} has {declared.help}", "missing")
        check_flat(scope, name, entries, fields["shape"])
    for word, (place, node) in entries.items():
        if word in own or word not in BODY or word in skip or word == "shape":
            continue
        declared = BODY[word]
        if declared.later:
            scope.later(place, word)
        if declared.space and not scope.space:
            in_space_only(scope, place, word)
        if scope.space and word in PLANAR:
            in_plane_only(scope, place, word)
        reader = READERS.get(declared.kind)
        found: Any
        if declared.kind == "motion":
            found = {"moved": (*fields.get("moved", ()), *read_motion(scope, declared, node, word, name))}
        elif word == "density":
            from rotsolve.scene.coordinates import read_density

            found = read_density(scope, node, name, shape, fields)
        else:
            found = reader(scope, node, name) if reader else read_value(scope, declared, node, word, name)
        if isinstance(found, dict):
            fields.update(found)
        elif found is not None:
            fields[word] = found
    check_exclusive(scope, name, entries, fields, whole=not skip)
    known = {field: item for field, item in fields.items() if field in Body.__struct_fields__}
    body = Body(name, span=key.span, **known)
    if body.tensor is not None and body.shape is not None:
        help = "a body whose inertia is given needs no `shape`"
        scope.fault(entries["inertia"][0], f"`{name}` has both a shape and an inertia tensor", help, "form")
    if body.tensor is not None and body.parts:
        help = "leave out the parts, or give the tensor to a body that is clamped to this one"
        scope.fault(
            entries["parts"][0],
            f"`{name}` has parts beside an inertia tensor, which is that of all of it",
            help,
            "form",
        )
    if body.holes:
        from rotsolve.scene.cutouts import check_holes

        check_holes(scope, name, entries["holes"][1], body)
    check_inertia_point(scope, name, entries, body)
    check_points(scope, name, entries, body)
    return body


def check_points(scope: Scope, name: str, entries: Entries, body: Body) -> None:
    """Points and parts have names of their own, which no point of the shape has."""
    own = {"cm", "center", *(body.shape.points if body.shape is not None else ())}
    parts = {part.body.name for part in body.parts}
    for section, words in (("parts", parts), ("points", {word for word, _ in body.points})):
        for word in sorted(words):
            if word in own or (section == "points" and word in parts):
                what = "a part" if word in parts and section == "points" else "a point"
                message = f"`{word}` names {what} of `{name}` already"
                scope.fault(entries[section][0], message, "choose another name", "name")


def check_inertia_point(scope: Scope, name: str, entries: Entries, body: Body) -> None:
    """A moment of inertia is given about a point that the body has."""
    about = body.inertia_about
    if about is not None and about not in point_names(body):
        help = hint(about, point_names(body), "points")
        scope.fault(entries["inertia"][1], f"`{name}` has no point {quoted(about)}", help, "point")


def read_motion(scope: Scope, key: Key, node: Node, word: str, name: str) -> Iterator[tuple[str, str, Formula]]:
    """A prescribed motion: one value or formula of `time` for a turn, `[x, y]` for a travel."""
    if scope.space:
        from rotsolve.scene.in_space import read_three

        want = Want(word, key.dimension, key.letter, name, varies=key.varies)
        yield from ((word, axis, part) for axis, part in zip("xyz", read_three(scope, node, want) or (), strict=False))
        return
    if word in TURNING:
        parts = {"": node}
    elif isinstance(node, List) and len(node.items) == 2:
        parts = dict(zip("xy", node.items, strict=True))
    else:
        scope.fault(node, f"`{word}` of a body wants `[x, y]`", "write its two components", "form")
        return
    for component, item in parts.items():
        owner = f"{component}_{name}" if component else name
        found = read_scalar(scope, item, Want(word, key.dimension, key.letter, owner, varies=key.varies))
        if found is not None:
            yield word, component, found


def check_exclusive(scope: Scope, name: str, entries: Entries, fields: dict[str, Any], *, whole: bool) -> None:
    """What can't be said together; a `whole` body, which is no part, may have a mass and a density."""
    if "gyration" in entries and "inertia" in entries:
        scope.fault(entries["gyration"][0], f"`{name}` has both `inertia` and `gyration`", "give one of them", "form")
    varies = any(is_coordinate(name) for name in (fields.get("density") or ZERO).symbols())
    if varies and "holes" in entries:
        message = f"`{name}` has holes and a density that varies"
        scope.fault(entries["holes"][0], message, "give the limits of what is left as a `lamina`", "form")
    if varies and "count" in entries:
        message = f"`{name}` stands for several alike, and has a density that varies"
        scope.fault(entries["count"][0], message, "write a body for each", "form")
    both = "density" in entries and "mass" in entries
    if both and (scope.space or not whole or "holes" in entries or "count" in entries):
        scope.fault(entries["density"][0], f"`{name}` has both `mass` and `density`", "give one of them", "form")
    elif both:
        from rotsolve.scene.coordinates import told_by_both

        told_by_both(scope, name, entries, fields)
    if "parts" in entries and getattr(fields.get("shape"), "pointlike", False):
        scope.fault(entries["parts"][0], f"`{name}` is a particle and can't have parts", "leave out `shape`", "form")


def check_flat(scope: Scope, name: str, entries: Entries, shape: Shape) -> None:
    """A triangle closes, and corners enclose something."""
    if shape.closing and not any(getattr(shape, word) for word in shape.closing):
        either = " or ".join(f"its `{word}`" for word in shape.closing)
        scope.fault(entries["shape"][1], f"{shape.word} `{name}` needs {either}", kind="missing")
    sides = getattr(shape, "sides", ()) if shape.closing else ()
    if len(sides) == 3:
        check_triangle(scope, name, entries["sides"][1], sides)
    corners = [(rough(x, scope.numbers), rough(y, scope.numbers)) for x, y in getattr(shape, "corners", ())]
    places = [(x, y) for x, y in corners if x is not None and y is not None]
    if len(places) > 2 and len(places) == len(corners):
        area = sum(x * v - u * y for (x, y), (u, v) in zip(places, places[1:] + places[:1], strict=True))
        size = max(abs(number) for place in places for number in place)
        if abs(area) <= 1e-12 * size * size:
            scope.fault(entries["corners"][1], f"the corners of `{name}` enclose nothing", kind="limits")


def check_triangle(scope: Scope, name: str, node: Node, sides: tuple[Formula, ...]) -> None:
    """The longest side of a triangle is shorter than the other two together."""
    lengths = [number for side in sides if (number := rough(side, scope.numbers)) is not None]
    if len(lengths) == 3 and 2 * max(lengths) >= sum(lengths):
        help = "the longest must be shorter than the other two together"
        scope.fault(node, f"the sides of `{name}` make no triangle", help, "limits")


def read_inertia(scope: Scope, node: Node, owner: str) -> dict[str, Any] | None:
    """A number, `{value: I, about: POINT}`; in space `{principal: …}` or `{tensor: …}` about a point."""
    want = Want("inertia", "moment of inertia", "I", owner, "nonnegative")
    if isinstance(node, List):
        return scope.fault(node, "`inertia` wants a value or a map", "write `{principal: [I1, I2, I3]}`", "form")
    if not isinstance(node, Map):
        found = read_scalar(scope, node, want)
        return None if found is None else {"inertia": found}
    entries = scope.entries(node, "`inertia`", ("value", "about", *WHOLE))
    whole = [word for word in WHOLE if word in entries]
    if len(whole) + ("value" in entries) != 1:
        help = "write `inertia: {value: I, about: start}`"
        return scope.fault(
            node, f"`inertia` needs one of `value`, {', '.join(f'`{word}`' for word in WHOLE)}", help, "missing"
        )
    result: dict[str, Any]
    if whole:
        if not scope.space:
            return in_space_only(scope, entries[whole[0]][0], whole[0])
        result = {"tensor": WHOLE[whole[0]](scope, entries[whole[0]][1], owner)}
    else:
        result = {"inertia": read_scalar(scope, entries["value"][1], want)}
    if "about" in entries:
        about = entries["about"][1]
        if isinstance(about, Text):
            result["inertia_about"] = about.value.strip().removeprefix(f"{owner}.")
        else:
            scope.fault(about, "`about` wants the name of a point", kind="form")
    return result


def read_parts(scope: Scope, node: Node, owner: str) -> tuple[Part, ...]:
    """Parts or holes by name."""
    return tuple(read_part(scope, *entry) for entry in named_entries(scope, node, f"the parts of `{owner}`"))


def named_entries(scope: Scope, node: Node, what: str) -> Iterator[tuple[str, Text, Node]]:
    """The entries of a map whose keys can be names."""
    for name, (key, written) in scope.entries(node, what).items():
        if NAME.fullmatch(name):
            yield name, key, written
        else:
            scope.fault(key, f"{quoted(name)} can't be a name", "use letters, digits and `_`", "name")


def read_part(scope: Scope, name: str, key: Text, node: Node) -> Part:
    shape = named_shape(scope, node)
    entries = scope.entries(node, f"part `{name}`", keys_allowed(shape, tuple(PART)))
    written = [word for word in PART if word in entries]
    for word in written:
        if PART[word].space and not scope.space:
            in_space_only(scope, entries[word][0], word)
    if scope.space and "angle" in entries:
        in_plane_only(scope, entries["angle"][0], "angle")
    fields = {word: read_value(scope, PART[word], entries[word][1], word, name) for word in written}
    solid = "inertia" in entries or "gyration" in entries  # else what has no shape is a particle
    body = build_body(scope, name, key, entries, shape or (None if solid else Particle), tuple(PART))
    part = Part(body, **fields)
    check_ends(scope, name, key, entries, part)
    check_one_place(scope, name, entries, part)
    return part


def check_one_place(scope: Scope, name: str, entries: Entries, part: Part) -> None:
    """A particle is so far from the middle as its `radius` tells, or where `at` puts it."""
    shape = part.body.shape
    if shape is not None and shape.pointlike and "radius" in entries and "at" in entries:
        message = f"`{name}` is a particle: its `radius` tells how far from the middle it is, as `at` does"
        scope.fault(entries["radius"][0], message, "leave out one of both, or tell a `shape`: disc, ring, …", "form")


def check_ends(scope: Scope, name: str, key: Text, entries: Entries, part: Part) -> None:
    """A rod that has `start` and `end` is placed, turned and as long as they tell; nothing else can have them."""
    ends = [word for word in ("start", "end") if word in entries]
    if not ends:
        return
    shape = part.body.shape
    if shape is None or not shape.slender:
        help = "place the centre of any other part by `at`"
        scope.fault(entries[ends[0]][0], f"`start` and `end` are those of a rod, and `{name}` is none", help, "form")
    elif len(ends) == 1:
        scope.fault(key, f"part `{name}` needs both `start` and `end`", "or place its centre by `at`", "missing")
    elif part.start is not None and part.end is not None:
        from rotsolve.motion.rigid import between_ends

        for word in (word for word in ("at", "angle", "turned") if word in entries):
            message = f"`start` and `end` place the rod `{name}` already"
            scope.fault(entries[word][0], message, f"leave out `{word}`", "form")
        gap = between_ends(part.start, part.end)
        if scope.side(gap) == 0:
            scope.fault(entries["end"][0], f"the rod `{name}` begins where it ends", kind="limits")
        length = shape.reach()
        if length is not None and not is_zero(length**2 - gap**2) and scope.side(length - gap) != 0:
            help = "leave out `length`: it is how far `start` and `end` are apart"
            scope.fault(entries["length"][0], f"the rod `{name}` is not as long as its ends are apart", help, "limits")


def read_points_map(scope: Scope, node: Node, owner: str) -> tuple[tuple[str, tuple[Formula, ...]], ...]:
    entries = named_entries(scope, node, f"the points of `{owner}`")
    found = [(name, read_spot(scope, written, name, owner)) for name, _, written in entries]
    scope.lost.update(name for name, place in found if place is None)
    return tuple((name, place) for name, place in found if place is not None)


def read_count(scope: Scope, node: Node, owner: str) -> int | None:
    text = node.value.strip() if isinstance(node, Text) else ""
    if text.isascii() and text.isdigit() and 0 < int(text[:6]) <= 1000:
        return int(text)
    return scope.fault(node, "`count` wants a whole number from 1 to 1000", kind="form")


WHOLE: dict[str, Callable[[Scope, Node, str], Any]] = {"principal": read_principal, "tensor": read_tensor}
PLANAR = ("moves", "turns", "angle", "count", "momentum")  # keys of a body that mean nothing in space
READERS: dict[str, Callable[[Scope, Node, str], Any]] = {
    "inertia": read_inertia,
    "parts": read_parts,
    "points map": read_points_map,
    "count": read_count,
    "axis": read_axis,
    "turns": read_rotations,
}
