"""Completion: what may be written where a text ends: keys, names, choices, quantities, units, whole shapes and elements."""

from __future__ import annotations

import re
from collections.abc import Iterator

from msgspec.structs import replace

from rotsolve.algebra.units.dimension import DIMENSIONS, Dimension
from rotsolve.core.quantity import QUANTITIES
from rotsolve.editor.levels import key_at, keys_at, names_as_keys
from rotsolve.editor.offers import Offer, offers, once, units_offered
from rotsolve.editor.outline import TextEnd
from rotsolve.editor.paths import after_number, in_phrase, names_of, owned, path_before, quantities
from rotsolve.editor.scene_text import SceneText, Steps
from rotsolve.elements.tables import SHAPES
from rotsolve.language.grammar import APPROXIMATIONS, SWINGS
from rotsolve.language.keys import Key
from rotsolve.language.problem import COMES_TO
from rotsolve.scene.elements import TABLES
from rotsolve.scene.examples import as_data, example_body, example_element, example_value, with_stops, within_a_line
from rotsolve.scene.reference import element_text, key_meaning
from rotsolve.scene.tree import Map

WORD = re.compile(r"[\w°%µμ]*$")  # what an editor puts an offer in the place of
KEPT = ("map", "map of directions", "parts", "points map", "text", "texts")  # kinds whose values are no snippet
ZERO_TO = {"states": ("at rest",)}  # what an entry of a section may be instead of a map


def offers_at(scene: SceneText, line: int, column: int) -> tuple[list[Offer], int]:
    """What may be written at a place, and how many characters before it that is in the place of; line and column count from 0."""
    place = scene.ending_before(line, column)
    if not place.role:
        return [], 0
    here = scene.at(line, column)
    own = here.text.value if here is not None and here.is_key else place.typed.strip()
    keys = list(keys_offered(scene, place, own, scene.line(line)[column:])) if place.role in ("key", "either") else []
    values = list(values_offered(scene, place)) if place.role in ("value", "either") else []
    typed = re.search(r"[^{\[,]*$", place.typed)
    word = WORD.search(place.typed)
    whole = place.role == "key" and "." not in place.typed and typed is not None
    return once([*keys, *values]), len((typed if whole else word)[0]) if typed and word else 0


def keys_offered(scene: SceneText, place: TextEnd, own: str, rest: str) -> Iterator[Offer]:
    """The keys that may stand here and do not yet, beside its `own`, which is being written; `rest` is what follows on the line."""
    scope, path = scene.scope, place.path
    node = scene.node(path)
    written = {key.value for key, _ in node.entries} - {own} if isinstance(node, Map) else set()
    colon = "" if re.match(r"\w*\s*:", rest) else ": "
    if path and path[0] == "states" and len(path) == 2:
        yield from in_state(scene, place.typed, colon)
    if "." in place.typed:
        return
    for word, key in keys_at(scene, path).items():
        if word in written or key.later or (key.space and not scope.space) or (key.plane and scope.space):
            continue
        text = stops_of(key) if colon else ""
        yield Offer(word, "key", key_meaning(key), f"{word}{colon}{text}", snippet=bool(text))
    yield from (Offer(name, "name", "", f"{name}{colon}") for name in names_as_keys(scene, path) if name not in written)


def stops_of(key: Key) -> str:
    """The value of a key as a snippet: its choices, or an example; nothing of what is a map of names, or a text."""
    if key.kind == "choice":
        return f"${{1|{','.join(key.choices)}|}}"
    value = "" if key.kind in KEPT else example_value(key)
    return within_a_line(with_stops(as_data(value))) if value else ""


def in_state(scene: SceneText, typed: str, colon: str) -> Iterator[Offer]:
    """A line of a state: a path, a connection with its word, a time, how small swings go."""
    scope, words = scene.scope, path_before(typed)
    if words is None:
        yield from names_of(scope, "body")
        swings = offers([f"{word} small swings" for word in SWINGS], "word", "what is observed of its swings")
        ended = [*names_of(scope, "connection"), *quantities(scope, ["time"]), *swings]
    else:
        ended = list(owned(scope, words))
    for offer in ended:
        yield offer if offer.sort == "point" else replace(offer, insert=f"{offer.word}{colon}")


def values_offered(scene: SceneText, place: TextEnd) -> Iterator[Offer]:
    """What the value that is being written may be."""
    path, typed = place.path, place.typed
    section = str(path[0]) if path else ""
    if section == "find" and len(path) > 1:
        yield from in_phrase(scene.scope, typed)
    elif section == "given":
        yield from of_given(scene, typed, str(path[-1]))
    elif section == "states" and len(path) > 2 and key_at(scene, path) is None:
        yield from of_state_line(scene, str(path[2]), typed)
    elif len(path) == 2 and section in (*TABLES, "bodies", "states"):
        yield from entries_offered(scene, section, place)
    elif (key := key_at(scene, path)) is not None:
        yield from of_key(scene, key, path, typed)
    elif section == "vary":
        yield from of_given(scene, typed, str(path[-1]))


def entries_offered(scene: SceneText, section: str, place: TextEnd) -> Iterator[Offer]:
    """A whole entry: a shape with its sizes, an element with what it must have, or one word."""
    node = scene.node(place.path)
    if isinstance(node, Map) and node.entries and place.role == "either":
        return
    space = scene.scope.space
    if section == "bodies":
        for shape in SHAPES:
            yield whole_map(shape.word, element_text(shape, "shape"), example_body(shape), shape.word)
    elif section in TABLES:
        kind, table = TABLES[section]
        for cls in table:
            if not cls.later and (cls.spatial if space else cls.planar):
                yield whole_map(cls.word, element_text(cls, kind), example_element(cls))
    yield from offers(ZERO_TO.get(section, ()), "word", "nothing moves")


def whole_map(word: str, help: str, example: str, kept: str = "") -> Offer:
    data = as_data(example)
    if isinstance(data, str):
        return Offer(word, "element", help)
    return Offer(word, "element", help, within_a_line(with_stops(data, kept)), snippet=True)


def of_given(scene: SceneText, typed: str, name: str) -> Iterator[Offer]:
    """A given: a number with its unit, a unit alone, `unknown`, or a formula of others."""
    words = path_before(typed)
    if words is not None:
        yield from owned(scene.scope, words)
        return
    if after_number(typed) or not typed.strip():
        yield from units_offered(None)
    if not after_number(typed):
        yield from offers(["unknown", "number"], "word", "asked for, or a letter without a unit")
        yield from (item for item in names_of(scene.scope, "given") if item.word != name)


def of_state_line(scene: SceneText, line: str, typed: str) -> Iterator[Offer]:
    """The value of a line of a state: what a connection does, a quantity, or that it is extreme."""
    scope = scene.scope
    if line in scope.elements:
        yield from offers(getattr(scope.elements[line], "words", ()), "word", f"what {line} does")
        return
    last = next((QUANTITIES[word] for word in reversed(re.findall(r"\w+", line)) if word in QUANTITIES), None)
    yield from amounts_offered(scene, last.dimension if last is not None else None, typed)
    yield from offers(() if after_number(typed) else COMES_TO, "word", "where it is so on the way")


def amounts_offered(
    scene: SceneText, dimension: Dimension | None, typed: str, *, varies: bool = False
) -> Iterator[Offer]:
    """A number with a unit that fits, or a formula of givens; of what varies also of the time and of paths."""
    scope, words = scene.scope, path_before(typed)
    if words is not None:
        yield from owned(scope, words)
    elif after_number(typed):
        yield from units_offered(dimension)
    else:
        fitting = [
            name for name, own in scope.dimensions.items() if own is None or not dimension or own.matches(dimension)
        ]
        given = scope.names("given")
        yield from offers([name for name in given if name in fitting], "name", "a given")
        yield from offers([name for name in given if name not in fitting], "name", "a given of another dimension")
        yield from offers(["unknown"], "word", "asked for")
        if varies:
            yield from offers(["time"], "word", "running time")
            yield from names_of(scope, "body")


def of_key(scene: SceneText, key: Key, path: Steps, typed: str) -> Iterator[Offer]:
    """What a key takes, by its kind."""
    scope, words = scene.scope, path_before(typed)
    if key.kind == "shape":
        yield from (Offer(shape.word, "element", element_text(shape, "shape")) for shape in SHAPES)
    elif key.kind in ("point", "points"):
        yield from owned(scope, words, points=True) if words else names_of(scope, "body", "surface")
    elif key.kind in ("name", "names"):
        yield from names_of(scope, *(key.refers or ("given",)))
    elif key.kind in ("flag", "true"):
        yield from offers(["true", "false"] if key.kind == "flag" else ["true"], "word")
    elif key.kind == "texts":
        yield from offers(APPROXIMATIONS, "word")
    else:
        yield from offers(key.choices, "word")
        yield from offers(OWN_WORDS.get(key.kind, ()), "word")
        if key.kind in AMOUNTS:
            dimension = DIMENSIONS.get(key.dimension or AMOUNTS[key.kind])
            yield from amounts_offered(scene, dimension, typed, varies=key.varies)


OWN_WORDS: dict[str, tuple[str, ...]] = {  # what values of a kind may be beside a number
    "friction": ("none", "any"),
    "gravity": ("none",),
    "axis": ("x", "y", "z"),
    "axis in space": ("x", "y", "z"),
}
AMOUNTS = {  # kinds of values that are numbers with units, and what they measure where the key does not say
    **dict.fromkeys(("quantity", "quantities", "amount", "motion", "density", "gravity", "inertia"), ""),
    **dict.fromkeys(("place", "spot", "corners", "points map", "radii"), "length"),
    "friction": "number",
    "direction": "angle",
}
