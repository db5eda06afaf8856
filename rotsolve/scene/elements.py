"""Elements: entries of `surfaces`, `connections`, `actions` and `events`, each by the word that it carries, read from its table of keys."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from rotsolve.algebra.certified.ball import note
from rotsolve.elements.tables import ACTIONS, CONNECTIONS, EVENTS, SURFACES
from rotsolve.language.friction import Friction
from rotsolve.language.keys import Element, Key, keys_of
from rotsolve.language.kinds import Kinds
from rotsolve.language.problem import PointRef
from rotsolve.language.words import hint, nearest_name, quoted
from rotsolve.scene import in_space
from rotsolve.scene.in_space import in_plane_only, in_space_only
from rotsolve.scene.literals import Want
from rotsolve.scene.paths import read_corner, read_place, read_point, read_spot, running_path
from rotsolve.scene.rough import size
from rotsolve.scene.scope import Scope
from rotsolve.scene.tree import List, Map, Node, Text
from rotsolve.scene.values import read_scalar

KeyReader = Callable[[Scope, Key, Node, str, str], Any]
PlaceReader = Callable[[Scope, Node, str, str], Any]
ANY = "any"  # a force or couple in space that is as large as it takes
FLAGS = {"true": True, "yes": True, "false": False, "no": False}


def read_keys(scope: Scope, cls: type[Element], name: str, entries: dict[str, tuple[Text, Node]]) -> dict[str, Any]:
    """The fields of an element from the entries of its map; a key that is faulty is left out."""
    result: dict[str, Any] = {}
    attributes = {entry.rstrip("_"): entry for entry in cls.declared}
    for word, declared in keys_of(cls):
        if word not in entries:
            continue
        key, node = entries[word]
        if declared.later:
            scope.later(key, word)
        if declared.space and not scope.space:
            in_space_only(scope, key, word)
        if declared.plane and scope.space:
            in_plane_only(scope, key, word, declared.instead)
        found = read_value(scope, declared, node, word, name)
        if found is not None:
            result[attributes[word]] = found
    return result


def read_value(scope: Scope, key: Key, node: Node, label: str, owner: str) -> Any:
    return READERS[key.kind](scope, key, node, label, owner)


def read_quantity(scope: Scope, key: Key, node: Node, label: str, owner: str) -> Any:
    want = Want(label, key.dimension, key.letter, owner, key.limits, key.varies)
    return read_scalar(scope, node, want, partial(running_path, scope) if key.varies else None)


def read_quantity_list(scope: Scope, key: Key, node: Node, label: str, owner: str) -> Any:
    letters = key.letter.split() or [""]

    def read(index: int, item: Node) -> Any:
        letter = letters[min(index, len(letters) - 1)]
        return read_scalar(scope, item, Want(label, key.dimension, letter, owner, key.limits))

    return each_item(scope, key, node, label, read)


def each_item(
    scope: Scope, key: Key, node: Node, label: str, read: Callable[[int, Node], Any]
) -> tuple[Any, ...] | None:
    """All items of a list, or nothing where one of them is faulty."""
    items = list_items(scope, key, node, label)
    if items is None:
        return None
    found = [read(index, item) for index, item in enumerate(items)]
    return None if None in found else tuple(found)


def list_items(scope: Scope, key: Key, node: Node, label: str) -> tuple[Node, ...] | None:
    """The items of a list with as many as the key takes; a single thing stands for a list of one."""
    low, high = key.count or (1, 50)
    items = node.items if isinstance(node, List) else (node,)
    if low <= len(items) <= high and (isinstance(node, List) or low == 1):
        return items
    wanted = str(low) if low == high else f"{low} to {high}" if high < 50 else f"at least {low}"
    example = f"write `{label}: {key.example}`" if key.example else ""
    return scope.fault(node, f"`{label}` wants a list of {wanted}, but this has {len(items)}", example, "count")


def read_radii(scope: Scope, key: Key, node: Node, label: str, owner: str) -> Any:
    """`{inner: r, outer: R}`; a drum's rims may have any names."""
    entries = scope.entries(node, f"`{label}`", key.choices or None)
    found = []
    for word, (name, written) in entries.items():
        if not key.choices and not word.isidentifier():
            scope.fault(name, f"{quoted(word)} can't be the name of a rim", "use letters, digits and `_`", "name")
            continue
        radius = read_scalar(scope, written, Want(label, "length", "R", f"{owner}_{word}", "positive"))
        if radius is None:
            scope.lost.add(word)
        else:
            found.append((word, radius))
    sizes = dict(found)
    thick = sizes["outer"] - sizes["inner"] if {"inner", "outer"} <= sizes.keys() else None
    if thick is not None and scope.side(thick) in (0, -1):
        scope.fault(node, f"`{label}`: `inner` must be smaller than `outer`", kind="limits")
    lacking = [word for word in key.choices if word not in entries]
    if lacking and entries:
        scope.fault(node, f"`{label}` needs `{lacking[0]}` too", "write `radii: {inner: r, outer: R}`", "missing")
    return tuple(found)


def read_limits(scope: Scope, key: Key, node: Node, label: str, owner: str) -> Any:
    """The limits of a lamina, or the profile of a solid of revolution."""
    from rotsolve.scene.coordinates import read_profile, read_region

    return {"region": read_region, "profile": read_profile}[key.kind](scope, node, label, owner)


def read_choice(scope: Scope, key: Key, node: Node, label: str, owner: str) -> Any:
    if isinstance(node, Text) and node.value.strip() in key.choices:
        return node.value.strip()
    shown = node.value if isinstance(node, Text) else node.shown
    return scope.fault(node, f"`{label}` can't be {quoted(shown)}", hint(shown, key.choices, "choices"), "choice")


def read_flag(scope: Scope, key: Key, node: Node, label: str, owner: str) -> Any:
    word = node.value.strip().lower() if isinstance(node, Text) else ""
    if word in FLAGS:
        return FLAGS[word]
    return scope.fault(node, f"`{label}` wants `true` or `false`", kind="choice")


def read_name(scope: Scope, key: Key, node: Node, label: str, owner: str) -> Any:
    """The name of a thing of one of the kinds that the key refers to."""
    what = " or ".join(key.refers)
    if not isinstance(node, Text):
        return scope.fault(node, f"`{label}` wants the name of a {what}", kind="form")
    word = node.value.strip()
    if scope.kinds.get(word) in key.refers:
        return word
    names = scope.names(*key.refers)
    kind = scope.kinds.get(word)
    if word in scope.conflicts:
        return None
    if kind:
        message = f"`{label}` wants a {what}, but `{word}` is a {kind}"
        return scope.fault(node, message, f"choose from: {', '.join(names)}", "kind")
    return scope.unknown(node, word, what, names, "choose from")


def read_names(scope: Scope, key: Key, node: Node, label: str, owner: str) -> Any:
    items = node.items if isinstance(node, List) else (node,)
    found = [read_name(scope, key, item, label, owner) for item in items]
    return tuple(item for item in found if item is not None)


def read_directions(scope: Scope, key: Key, node: Node, label: str, owner: str) -> Any:
    result = []
    for word, (body, written) in scope.entries(node, f"`{label}`").items():
        if scope.kinds.get(word) != "body":
            scope.unknown(body, word, "body", scope.names("body"), "bodies")
        elif (found := read_choice(scope, key, written, label, owner)) is not None:
            result.append((word, found))
    return tuple(result)


def read_direction(scope: Scope, key: Key, node: Node, label: str, owner: str) -> Any:
    """A word, `[x, y]` (only its direction counts) or an angle from the rightward horizontal; in space a word or `[x, y, z]`."""
    if scope.space:
        return in_space.read_way(scope, node, label, owner)
    if isinstance(node, List):
        return read_vector(scope, key, node, label, owner)
    if isinstance(node, Text) and node.value.strip() in key.choices:
        return node.value.strip()
    if isinstance(node, Text) and node.value.strip().isalpha() and node.value.strip() not in scope.givens:
        return read_choice(scope, key, node, label, owner)
    return read_scalar(scope, node, Want(label, "angle", "theta", owner))


def read_vector(scope: Scope, key: Key, node: Node, label: str, owner: str) -> Any:
    if isinstance(node, List) and len(node.items) == 3:
        return in_space_only(scope, node, f"{label}: [x, y, z]")
    if not isinstance(node, List) or len(node.items) != 2:
        return scope.fault(node, f"`{label}` wants `[x, y]`", kind="form")
    found = in_space.read_ratio(scope, node, label, owner)
    return None if None in found else tuple(found)


def read_along(scope: Scope, key: Key, node: Node, label: str, owner: str) -> Any:
    """The direction of an axis in space; in the plane that of a surface."""
    return in_space.read_way(scope, node, label, owner)


def read_amounts(scope: Scope, key: Key, node: Node, label: str, owner: str) -> Any:
    """A size; in space also three components, or `any`: as large as it takes, in whatever direction."""
    if scope.space and isinstance(node, Text) and node.value.strip() == ANY:
        return ANY
    if isinstance(node, List) and scope.space:
        return in_space.read_three(scope, node, Want(label, key.dimension, key.letter, owner, varies=key.varies))
    return read_quantity(scope, key, node, label, owner)


def read_turned(scope: Scope, key: Key, node: Node, label: str, owner: str) -> Any:
    return in_space.read_rotations(scope, node, owner)


def read_friction(scope: Scope, key: Key, node: Node, label: str, owner: str) -> Any:
    """`none`, `any`, a coefficient, or `{static: , kinetic: }`."""
    if isinstance(node, Text) and node.value.strip() in ("none", "any"):
        return Friction(node.value.strip())
    want = Want(label, "number", "mu", owner, "nonnegative")
    if not isinstance(node, Map):
        found = read_scalar(scope, node, want)
        return None if found is None else Friction("coefficient", found, found)
    entries = scope.entries(node, f"`{label}`", ("static", "kinetic"))
    both = {
        word: read_scalar(scope, written, Want(word, "number", f"mu_{word[0]}", owner, "nonnegative"))
        for word, (_, written) in entries.items()
    }
    known = {word: found for word, found in both.items() if found is not None}
    numbers = {word: size(found, scope.numbers) for word, found in known.items()}
    if len(known) > 1:
        note(known["static"] - known["kinetic"])
    if smaller(numbers.get("static"), numbers.get("kinetic")):
        scope.fault(node, "kinetic friction can't be greater than static friction", kind="limits")
    return Friction("coefficient", both.get("static"), both.get("kinetic"))


def smaller(one: float | None, other: float | None) -> bool:
    """Whether one number is surely smaller than another."""
    return one is not None and other is not None and one < other


def without_key(read: PlaceReader) -> KeyReader:
    """A reader of places that are the same under all keys."""
    return lambda scope, key, node, label, owner: read(scope, node, label, owner)


def of_each(read: PlaceReader) -> KeyReader:
    """A reader of lists of places."""
    return lambda scope, key, node, label, owner: each_item(
        scope, key, node, label, lambda _, item: read(scope, item, label, owner)
    )


def read_point_of_body(scope: Scope, key: Key, node: Node, label: str, owner: str) -> PointRef | None:
    """A point at which something acts, which is one of a body, and no place of the scene."""
    if isinstance(node, List):
        help = f"name a point of a body, as `{label}: {example_here(scope, key)}`"
        return scope.fault(
            node, f"nothing acts on a place of the scene: `{label}` wants a point of a body", help, "form"
        )
    return read_point(scope, node, label, owner)


READERS: dict[str, KeyReader] = {
    "quantity": read_quantity,
    "quantities": read_quantity_list,
    "place": without_key(read_place),
    "spot": without_key(read_spot),
    "corners": of_each(read_corner),
    "radii": read_radii,
    "region": read_limits,
    "profile": read_limits,
    "choice": read_choice,
    "flag": read_flag,
    "name": read_name,
    "names": read_names,
    "point": read_point_of_body,
    "points": of_each(read_point),
    "map of directions": read_directions,
    "direction": read_direction,
    "vector": read_vector,
    "friction": read_friction,
    "axis in space": read_along,
    "amount": read_amounts,
    "turns": read_turned,
}


TABLES: dict[str, tuple[str, Kinds[Any]]] = {  # section -> kind, table
    "surfaces": ("surface", SURFACES),
    "connections": ("connection", CONNECTIONS),
    "actions": ("action", ACTIONS),
    "events": ("event", EVENTS),
}
PLURAL = {kind: section for section, (kind, _) in TABLES.items()}


def read_element(scope: Scope, section: str, name: str, key: Text, node: Node) -> object | None:
    """One element of a section."""
    kind, table = TABLES[section]
    if isinstance(node, Text):
        return plain_word(scope, kind, table, name, node)
    if not isinstance(node, Map):
        return scope.fault(node, f"{kind} `{name}` wants `{{{table.words[-1]}: …}}`, but this is a list", "", "form")
    cls = class_of(scope, kind, table, name, key, node)
    if cls is None:
        return None
    scope.elements[name] = cls
    entries = scope.entries(node, f"{kind} `{name}`", [word for word, _ in keys_of(cls)])
    check_world(scope, node.key(cls.word) or node, cls)
    required = {word: declared for word, declared in keys_of(cls) if declared.required}
    for word, declared in required.items():
        if node.key(word) is None and word not in entries:
            shown = example_here(scope, declared)
            example = f": `{word}: {shown}`" if shown else f": {declared.help}"
            scope.fault(key, f"`{name}` needs `{word}`", f"add it{example}", "missing")
    before = len(scope.faults)
    found = read_keys(scope, cls, name, entries)
    if len(scope.faults) > before:
        scope.half_read.add(name)
    if not all(word in found or f"{word}_" in found for word in required):
        return None
    element: Element = cls(name, **found)
    scope.touched[name] = tuple(point.owner for point in points_named(element) if point.owner)
    return element


def check_world(scope: Scope, place: Node, cls: Any) -> None:
    """An element is one of the plane, of space, or of both; one whose physics is not there yet is refused by name."""
    if cls.later:
        scope.later(place, cls.word)
    elif scope.space and not cls.spatial:
        word = getattr(cls, "spatial_word", "")
        help = f"write `{word}`: it says the same in space" if word else getattr(cls, "instead", "")
        in_plane_only(scope, place, cls.word, help)
    elif not scope.space and not cls.planar:
        in_space_only(scope, place, cls.word)


def example_here(scope: Scope, declared: Key) -> str:
    """The example of a key; of a point on a body one on a body of the scene, the same point where it has that."""
    owner, dot, point = declared.example.partition(".")
    if declared.kind != "point" or owner in scope.bodies or not scope.bodies:
        return declared.example
    alike = next((name for name in scope.bodies if point in scope.points.get(name, ())), None)
    return f"{alike}.{point}" if dot and alike is not None else next(iter(scope.bodies))


def plain_word(scope: Scope, kind: str, table: Kinds[Any], name: str, node: Text) -> object | None:
    """An element that is one word, such as `level`."""
    word = " ".join(node.value.split())
    cls = table.of(word)
    if cls is None:
        return scope.unknown(node, word, kind, table.words, PLURAL[kind], own=False)
    if any(declared.required for _, declared in keys_of(cls)):
        example = next((declared.example for _, declared in keys_of(cls) if declared.example), "…")
        return scope.fault(node, f"`{word}` wants a value", f"write `{name}: {{{word}: {example}}}`", "form")
    check_world(scope, node, cls)
    scope.elements[name] = cls
    return cls(name)  # type: ignore[no-any-return]


def class_of(scope: Scope, kind: str, table: Kinds[Any], name: str, key: Text, node: Map) -> type[Any] | None:
    """The class by the one word of the table that the map holds."""
    words = [entry.value for entry, _ in node.entries]
    known = table.words
    found = [word for word in known if word in words]
    if len(found) == 1:
        return table.of(found[0])
    if len(found) > 1:  # an axle with a `force`: the first of them in the file decides what is meant
        both = " and ".join(f"`{word}`" for word in found[:2])
        return scope.fault(key, f"`{name}` is both {both}", "give each a name of its own", "form")
    for entry, _ in node.entries:
        if nearest_name(entry.value, known):
            return scope.unknown(entry, entry.value, kind, known, PLURAL[kind], own=False)
    return scope.fault(key, f"`{name}` doesn't say what kind of {kind} it is", hint("", known, PLURAL[kind]), "missing")


def points_named(element: Element) -> list[PointRef]:
    """All points that an element names."""
    fields = (getattr(element, name) for name in element.__struct_fields__)
    items = (item for field in fields for item in (field if isinstance(field, tuple) else (field,)))
    return [item for item in items if isinstance(item, PointRef)]
