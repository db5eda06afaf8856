"""Help: what stands at a place, in Markdown, by the same texts as `rotsolve elements`; of a letter its value, in SI units too."""

from __future__ import annotations

import re
from collections.abc import Iterator

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.formula import Formula
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.units.dimension import Dimension, base_unit_text, describe, kind_of
from rotsolve.algebra.units.quantities import UnitError, parse_unit
from rotsolve.core.faults import Span
from rotsolve.core.letters import Given
from rotsolve.core.quantity import QUANTITIES
from rotsolve.editor.levels import class_at, key_at, shape_written
from rotsolve.editor.scene_text import ScalarAt, SceneText, Steps
from rotsolve.elements.tables import SHAPES
from rotsolve.language.words import an
from rotsolve.scene.elements import TABLES
from rotsolve.scene.paths import point_names
from rotsolve.scene.reference import PHRASE_WORDS, element_text, key_meaning, quantity_text
from rotsolve.scene.scope import Scope

WORD_AT = re.compile(r"[^\W\d]\w*|°|%")
UNIT_AFTER = re.compile(r"\d\s*$")
DIGITS_TOLD = 6


def help_at(scene: SceneText, line: int, column: int) -> tuple[str, Span] | None:
    """What is known of what stands at a place, and its span; line and column count from 0."""
    found = scene.at(line, column)
    if found is None:
        return None
    word = word_under(found)
    text = "\n\n".join(dict.fromkeys(filter(None, help_lines(scene, found, word))))
    if not text:
        return None
    exact = word is not None and found.text.exact and not whole_key(scene, found)
    return text, found.text.part(*word.span()) if exact and word else found.text.span


def word_under(found: ScalarAt) -> re.Match[str] | None:
    """The word of a scalar at the place."""
    offset = found.offset - (0 if found.text.plain else 1)
    return next((match for match in WORD_AT.finditer(found.text.value) if match.start() <= offset <= match.end()), None)


def whole_key(scene: SceneText, found: ScalarAt) -> bool:
    return found.is_key and key_at(scene, found.path) is not None


def help_lines(scene: SceneText, found: ScalarAt, word: re.Match[str] | None) -> Iterator[str]:
    """All that is told of a key, or of a word within a value, the nearest first."""
    path, key = found.path, key_at(scene, found.path)
    if found.is_key and key is not None:
        yield of_word_chosen(scene, path) or f"`{path[-1]}`: {key_meaning(key)}"
        return
    if found.is_key and len(path) == 2:
        yield of_name(scene, str(path[1]))
        return
    if word is not None:
        yield of_word(scene, found, word)
    if not found.is_key and key is not None:
        yield f"`{path[-1] if isinstance(path[-1], str) else path[-2]}`: {key_meaning(key)}"


def of_word_chosen(scene: SceneText, path: Steps) -> str:
    """The element whose word is the key at the end of a way."""
    cls = class_at(str(path[0]), scene.node(path[:2])) if len(path) == 3 else None
    return element_text(cls, TABLES[str(path[0])][0]) if cls is not None and cls.word == path[2] else ""


def of_word(scene: SceneText, found: ScalarAt, match: re.Match[str]) -> str:
    """A word of a value or of a line of a state."""
    text, word, scope = found.text.value, match[0], scene.scope
    after_dot = text[: match.start()].endswith(".")
    if after_dot and word in QUANTITIES:
        return quantity_text(QUANTITIES[word])
    if after_dot:
        owner = re.search(r"([^\W\d]\w*)\.$", text[: match.start()])
        return f"a point of `{owner[1]}`" if owner and owner[1] in scope.bodies else of_name(scene, word)
    if UNIT_AFTER.search(text[: match.start()]) and (unit := of_unit(word)):
        return unit
    alone = " ".join(text.split())
    shape = SHAPES.of(alone) if found.path[-1] == "shape" or found.path[:-1] == ("bodies",) else None
    if shape is not None:
        return element_text(shape, "shape")
    cls = class_at(str(found.path[0]), scene.node(found.path)) if len(found.path) == 2 else None
    if cls is not None:
        return element_text(cls, TABLES[str(found.path[0])][0])
    phrase = {entry.partition(" ")[0]: told for entry, told in PHRASE_WORDS.items()} if found.path[0] == "find" else {}
    return of_name(scene, word) or phrase.get(word) or of_unit(word)


def of_unit(word: str) -> str:
    """What a unit measures, and how much of the SI it is."""
    try:
        unit = parse_unit(word)
    except UnitError:
        return ""
    own = base_unit_text(unit.dimension)
    same = "" if own in (word, "") else f" = {in_figures(unit.factor, unit.dimension)}"
    return f"`{word}`: a unit of {describe(unit.dimension)}" + (f"; 1 {word}{same}" if same else "")


def of_name(scene: SceneText, name: str) -> str:
    """What a name of the scene stands for."""
    scope = scene.scope
    kind = scope.kinds.get(name)
    if kind is None:
        return ""
    if name in scope.givens and kind == "given":
        return of_letter(scope, scope.givens[name])
    if name in scope.bodies:
        shape = scope.bodies[name].shape or shape_written(scene.node(("bodies", name)))
        what = f": {shape.word}, {shape.about}" if shape is not None and hasattr(shape, "about") else ""
        return f"`{name}`, a body{what}; points: {', '.join(point_names(scope.bodies[name]))}"
    if name in scope.elements:
        return f"`{name}`, {an(kind)}: {element_text(scope.elements[name], kind)}"
    return f"`{name}`, {'what is asked' if kind == 'find' else an(kind)}"


def of_letter(scope: Scope, given: Given) -> str:
    """A given with its value as it is written, and in SI units."""
    measures = f", {describe(given.dimension, article=True)}" if given.dimension is not None else ""
    if given.asked:
        return f"`{given.name}` is asked for"
    if given.value is None:
        return f"`{given.name}`{measures}, without a number"
    numbers = {name: other.value for name, other in scope.givens.items() if other.value is not None}
    value = given.value
    for _ in numbers:  # a given may be made of others
        value = value.substitute({name: numbers[name] for name in value.symbols() & numbers.keys()})
    written = given.text if value == given.value else to_text(given.value)
    number = in_figures(value, given.dimension) if not value.symbols() else ""
    return f"`{given.name}` = {written}" + (f" = {number}" if number not in ("", written) else "") + measures


def in_figures(value: Formula, dimension: Dimension | None) -> str:
    """A number in SI units; of a kind that has one, in its own, N and not kg m/s²."""
    kind = kind_of(dimension) if dimension is not None else None
    unit = kind.unit if kind is not None else base_unit_text(dimension) if dimension is not None else ""
    return f"{evaluate(value, {}).text(DIGITS_TOLD)} {unit}".strip()
