"""Paths and points: `rod.end.acceleration.x`, `string.block.tension`, `kinetic_energy`; `rod.end`, `drum.inner`, `[x, y]`, checked."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.faults import Span
from rotsolve.core.quantity import (
    BEARINGS,
    BODY,
    DIRECTED,
    FELT,
    OF_BEARINGS,
    POINT,
    QUANTITIES,
    SPACE,
    SYSTEM,
    QuantityKind,
)
from rotsolve.core.symbols import PLACES, RATES
from rotsolve.elements.shapes import WHEEL, rivals
from rotsolve.language.grammar import SWINGS
from rotsolve.language.problem import Body, Path, PointRef
from rotsolve.language.words import an, hint, nearest_name, quoted
from rotsolve.scene.in_space import in_space_only
from rotsolve.scene.literals import Lexeme, Want, closing
from rotsolve.scene.scope import Scope
from rotsolve.scene.tree import List, Map, Node, Text
from rotsolve.scene.values import read_scalar

DOTTED = re.compile(r"\s*(?P<owner>[^\W\d]\w*)(?:\.(?P<point>[^\W\d]\w*)\s*(?P<call>\(.*\))?)?\s*", re.DOTALL)
KINDS = {"body": "bodies", "surface": "surfaces", "connection": "connections"}
OWNERS = ("body", "connection", "action", "event")
PLURALS = "bodies, connections, actions and events"
# may name the force: `rod.torque.gravity`
ANY_FORCE = ("force", "torque", "work", "power", "impulse", "angular_impulse")
SEGMENT = re.compile(r"[^\W\d]\w*|(?<=\.)\d+")


def point_names(body: Body) -> tuple[str, ...]:
    """The names of a body's points."""
    shape = body.shape
    if shape is not None:
        own = tuple(getattr(shape, "points", ()))
        if not own:
            own = tuple(f"corner{number}" for number in range(1, len(getattr(shape, "corners", ())) + 1))
    else:
        round_ = any(item is not None for item in (body.inertia, body.gyration, body.radius)) or body.radii
        own = WHEEL if round_ else ("center",)
    named = (*(name for name, _ in (*body.radii, *body.points)), *(part.body.name for part in body.parts))
    return tuple(dict.fromkeys((*own, *named, "cm")))


def read_place(scope: Scope, node: Node, label: str, owner: str) -> tuple[Formula, ...] | None:
    """A place `[x, y]` in the plane, `[x, y, z]` in space."""
    wanted = "[x, y, z]" if scope.space else "[x, y]"
    if not isinstance(node, List) or len(node.items) != len(wanted.split()):
        return scope.fault(node, f"`{label}` wants a place `{wanted}`", kind="form")
    found = [
        read_scalar(scope, item, Want(label, "length", letter, owner))
        for item, letter in zip(node.items, "xyz", strict=False)
    ]
    return tuple(item for item in found if item is not None) if None not in found else None


def read_spot(scope: Scope, node: Node, label: str, owner: str) -> tuple[Formula, ...] | None:
    """A place `[x, y]` or `[x, y, z]` of a body, z its height above the picture."""
    if not isinstance(node, List) or len(node.items) not in (2, 3):
        return scope.fault(node, f"`{label}` wants a place `[x, y]` or `[x, y, z]`", kind="form")
    found = [
        read_scalar(scope, item, Want(label, "length", letter, owner))
        for item, letter in zip(node.items, "xyz", strict=False)
    ]
    return tuple(item for item in found if item is not None) if None not in found else None


def read_corner(scope: Scope, node: Node, label: str, owner: str) -> tuple[Formula, ...] | None:
    """A corner `[x, y]` in the plane of a flat body; in space it may be written as `[x, y, 0]`."""
    if not scope.space:
        return read_place(scope, node, label, owner)
    found = read_spot(scope, node, label, owner)
    if found is not None and len(found) > 2 and scope.side(found[2]) != 0:
        help = "draw its corners at z = 0, in its own axes, and turn the body by `turned`"
        return scope.fault(node, "the corners of a flat body lie in its own x-y plane", help, "form")
    return found and found[:2]


def read_point(
    scope: Scope, node: Node, label: str, owner: str, kinds: tuple[str, ...] = ("body", "surface")
) -> PointRef | None:
    """A point by name or place."""
    if isinstance(node, List):
        place = read_place(scope, node, label, owner)
        return None if place is None else PointRef("", None, None, place, node.span)
    if isinstance(node, Map):
        return scope.fault(node, f"`{label}` wants a point such as `rod.end`, but this is a map", kind="form")
    match = DOTTED.fullmatch(node.value)
    if not match:
        help = "write `body`, `body.point`, `rod.at(x)` or `[x, y]`"
        return scope.fault(node, f"{quoted(node.value)} is no point", help, "form")
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
    if kind and name not in scope.conflicts:
        scope.fault(span, f"`{label}` wants a body, but `{name}` is a {kind}", f"{plural}: {', '.join(names)}", "kind")
    elif name not in scope.conflicts:
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
    rod = body.shape is not None and body.shape.slender
    if point == "at" and match["call"]:
        argument = place_along(scope, span, name, node.cut(match.start("call") + 1, match.end("call") - 1))
        return None if argument is None else PointRef(name, "at", argument, None, node.span)
    if match["call"] or point not in scope.points[name]:
        names = [*scope.points[name], *(["at(x)"] if rod else [])]
        return scope.fault(span, f"`{name}` has no point {quoted(point)}", hint(point, names, "points"), "point")
    if rivals(body, point):
        return scope.fault(span, *which_rim(body, point), "point")
    return PointRef(name, point, None, None, node.span)


def which_rim(body: Body, point: str) -> tuple[str, str]:
    """What is wrong with a point of a body of several rims, and the help."""
    names = rivals(body, point)
    listed = ", ".join(f"`{name}`" for name in names)
    return (
        f"`{body.name}` has the rims {listed}: of which one is this the `{point}`?",
        f"name it: `{body.name}.{names[0]}`",
    )


def place_along(scope: Scope, span: Span, name: str, written: Text) -> Formula | None:
    """The x of `rod.at(x)`; a fault at `span` where the body is no rod."""
    shape = scope.bodies[name].shape
    if shape is None or not shape.slender:
        help = f"points: {', '.join(scope.points[name])}"
        return scope.fault(span, f"`at(…)` is a point of rods only, and `{name}` is none", help, "point")
    return read_scalar(scope, written, Want("at(…)", "length", "x", name, "nonnegative"))


class Segment(str):
    """A word of a path with its place in the text, and the text within the brackets of `at(…)`."""

    start: int
    inner: tuple[int, int] | None


def segments(text: str, offset: int = 0) -> Iterator[Segment]:
    position = 0
    while match := SEGMENT.match(text, position):
        segment = Segment(match[0])
        segment.start, segment.inner = offset + match.start(), None
        position = match.end()
        if segment == "at" and text[position : position + 1] == "(":
            close = closing(text, position)
            segment.inner = (offset + position + 1, offset + close)
            position = close + 1
        yield segment
        position += 1


def read_path(scope: Scope, node: Text, start: int, end: int) -> Path | None:
    """The path that node.value[start:end] writes; None after a fault."""
    words = list(segments(node.value[start:end], start))
    span = node.part(start, end)
    if not words or "".join(node.value[start:end].split()) != node.value[start:end]:
        help = "write `body.quantity` or `body.point.quantity`"
        if ".at(" in node.value[start:end]:
            help = "give the place a letter: `x: 2 m` among the givens, then `body.at(x)`"
        return scope.fault(span, f"{quoted(node.value[start:end])} is no path", help, "path")
    first = words[0]
    if len(words) == 1:
        return system_path(scope, node, first, span)
    kind = scope.kinds.get(first)
    if not kind and first in (SUMMED_IN_SPACE if scope.space else SUMMED):
        return finish(scope, node, "", None, None, words, span, [*SUMMED_IN_SPACE], [])
    if kind not in OWNERS:
        if first in scope.conflicts:
            return None
        place, names = word_place(node, first), scope.names(*OWNERS)
        if not kind:
            return scope.unknown(place, first, "name", names, "names")
        help = f"{PLURALS} have quantities: {', '.join(names)}"
        return scope.fault(place, f"`{first}` is {an(kind)} and has no quantities", help, "kind")
    reader = body_path if kind == "body" else element_path
    return reader(scope, node, words, span)


def word_place(node: Text, word: Segment) -> Span:
    return node.part(word.start, word.start + len(word))


def written_out(scope: Scope, quantity: str, said: Iterable[str] = ()) -> str:
    """How a quantity is written: of what is said (`energy of the rod`), of the whole scene, or of one of the names."""
    owner = next((word for word in said if scope.kinds.get(word.partition(".")[0]) in OWNERS), None)
    if owner:
        return f"write `{owner}.{quantity}`"
    names = ", ".join(scope.names(*OWNERS))
    if SYSTEM in QUANTITIES[quantity].owners:
        return f"write `{quantity}` alone for the whole scene, or `name.{quantity}`; names: {names}"
    return f"write `name.{quantity}`; names: {names}"


def system_path(scope: Scope, node: Text, word: Segment, span: Span) -> Path | None:
    """A quantity of the whole scene."""
    entry = QUANTITIES.get(word)
    if entry is not None and SYSTEM in entry.owners:
        return Path("", word, span=span)
    kind = scope.kinds.get(word)
    if entry is not None:
        help = written_out(scope, word)
        if f"{word} of" in SWINGS:
            help = f"write `T: {word} of small swings`, and what is asked about it in a line of its own: `smallest T`"
        return scope.fault(span, f"`{word}` of what?", help, "path")
    if kind in OWNERS:
        example = {"body": "angular_velocity", "connection": "force", "action": "work"}.get(str(kind), "impulse")
        help = f"write `{word}.quantity`, for example `{word}.{example}`"
        return scope.fault(span, f"`{word}` is {an(str(kind))}, not a quantity", help, "path")
    known = [*scope.names("given", "find"), *(item.word for item in QUANTITIES.values() if SYSTEM in item.owners)]
    near = nearest_name(word, scope.names(*OWNERS))
    if near is not None and nearest_name(word, known) is None:
        return scope.unknown(span, word, "name", scope.names(*OWNERS), PLURALS)
    return scope.unknown(span, word, "name", known, "givens, answers and quantities")


def body_path(scope: Scope, node: Text, words: list[Segment], span: Span) -> Path | None:
    """body[.point].quantity[.component]"""
    owner, rest = words[0], words[1:]
    body = scope.bodies.get(owner)
    if body is None:  # it has a fault of its own
        return None
    point: str | None = None
    argument: Formula | None = None
    if rest[0] == "at" and rest[0].inner:
        argument = place_along(scope, word_place(node, rest[0]), owner, node.cut(*rest[0].inner))
        if argument is None:
            return None
        point, rest = "at", rest[1:]
    elif is_point(scope, owner, rest):
        point = str(rest[0])
        if rivals(body, point):
            return scope.fault(word_place(node, rest[0]), *which_rim(body, point), "point")
        rest = rest[1:]
    allowed = asked_of_body(point)
    if not rest:
        help = f"name a quantity: {', '.join(allowed)}"
        written = node.value[owner.start : owner.start + span.length]
        return scope.fault(span, f"{quoted(written)} is a point, not a quantity", help, "path")
    names = allowed if point else [*allowed, *scope.points[owner]]
    return finish(scope, node, owner, point, argument, rest, span, allowed, names)


def asked_of_body(point: str | None) -> list[str]:
    """The quantities of a body, or of one of its points."""
    return [entry.word for entry in QUANTITIES.values() if (POINT if point else BODY) in entry.owners]


def is_point(scope: Scope, owner: str, rest: list[Segment]) -> bool:
    """Whether the next word is a point: `cm.velocity`, but not `cm.x`."""
    if rest[0] not in scope.points[owner]:
        return False
    entry = QUANTITIES.get(rest[0])
    return entry is None or (len(rest) > 1 and rest[1] not in entry.components)


SUMMED = ("momentum",)  # what the whole scene has a component of: `momentum.y`
SUMMED_IN_SPACE = (*SUMMED, "angular_momentum")
OF_ENDS = (
    "tension",
)  # what is told of the part of a connection at one of its ends; all else is of the whole, or on the body named last


def element_path(scope: Scope, node: Text, words: list[Segment], span: Span) -> Path | None:
    """connection[.end].quantity[.component], action.quantity, event.quantity"""
    owner, rest = words[0], words[1:]
    if owner not in scope.elements:
        return None
    point = None
    ends = ends_of_element(scope, owner)
    if len(rest) > 1 and rest[0] in ends and rest[0] not in asked_of_element(scope, owner):
        point, rest = str(rest[0]), rest[1:]
    allowed = asked_of_element(scope, owner, point)
    return finish(scope, node, owner, point, None, rest, span, allowed, [*allowed, *(ends if not point else ())])


def ends_of_element(scope: Scope, owner: str) -> tuple[str, ...]:
    """What may stand between a connection and its quantity: what it touches, or a bearing."""
    bearings = BEARINGS if scope.space and "bearings" in scope.elements[owner].declared else ()
    return (*scope.touched.get(owner, ()), *bearings)


def asked_of_element(scope: Scope, owner: str, end: str | None = None) -> list[str]:
    """The quantities of a connection, action or event, or of one of its ends."""
    cls = scope.elements[owner]
    askable = (*cls.quantities, *(cls.quantities_in_space if scope.space else ()))
    return [word for word in askable if not end or word in (OF_BEARINGS if end in BEARINGS else OF_ENDS)]


def finish(
    scope: Scope,
    node: Text,
    owner: str,
    point: str | None,
    argument: Formula | None,
    rest: list[Segment],
    span: Span,
    allowed: list[str],
    names: list[str],
) -> Path | None:
    """The quantity and component at the end of a path."""
    word = rest[0]
    of = f"`{owner}.{point}`" if point else f"`{owner}`"
    if word not in allowed:
        message = f"{of} has no quantity {quoted(word)}"
        return scope.fault(word_place(node, word), message, hint(word, names, "it has"), "quantity")
    entry = QUANTITIES[word]
    component = read_component(scope, node, entry, rest[1]) if len(rest) > 1 else None
    if len(rest) > 1 and component is None:
        return None
    if len(rest) == 3 and scope.space and entry.word in DIRECTED and component not in SPACE and rest[2] in SPACE:
        component, rest = f"{component} {rest[2]}", rest[:2]  # of one of the forces on a body
    if len(rest) > 2:
        message = f"nothing can follow in {quoted(node.value)}: {quoted(rest[2])}"
        return scope.fault(word_place(node, rest[2]), message, "", "path")
    if entry.later:
        scope.later(span, word)
    if entry.space and not scope.space:
        return in_space_only(scope, word_place(node, word), word)
    return Path(owner, str(word), point, argument, component, span)


def read_component(scope: Scope, node: Text, entry: QuantityKind, word: Segment) -> str | None:
    allowed = component_words(scope, entry)
    if word in allowed:
        return str(word)
    message = f"`{entry.word}` has no component {quoted(word)}"
    return scope.fault(word_place(node, word), message, hint(word, allowed, "components"), "component")


def component_words(scope: Scope, entry: QuantityKind) -> list[str]:
    """What may follow a quantity: its components, and of forces on a body the names of what acts."""
    allowed = [*entry.components]
    if scope.space and entry.word in DIRECTED:
        allowed = [*dict.fromkeys((*allowed, *SPACE, *FELT.get(entry.word, ())))]
    return allowed + (scope.names("connection", "action") if entry.word in ANY_FORCE else [])


WORDS = (*PLACES, *RATES)


def running_path(scope: Scope, node: Text, piece: Lexeme) -> Formula | None:
    """The letter that stands for a path in a value that varies, named as the path is written; None after a fault."""
    path = read_path(scope, node, piece.start, piece.end)
    if path is None:
        return None
    if path.owner not in scope.bodies or path.point or path.component or path.quantity not in WORDS:
        help = f"write `body.quantity` with one of: {', '.join(WORDS)}"
        return scope.fault(path.span, f"a value can't vary with {quoted(piece.text)}", help, "formula")
    scope.dimensions[piece.text] = QUANTITIES[path.quantity].dimension
    return Symbol(piece.text)
