"""Reference: the language as markdown, made from the tables that the reader reads."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from rotsolve.algebra.units.dimension import describe
from rotsolve.algebra.units.unit_table import AMBIGUOUS, UNITS
from rotsolve.core.quantity import QUANTITIES, QuantityKind
from rotsolve.elements.tables import SHAPES
from rotsolve.language.grammar import BODY, CLAUSES, DEDUCT, MARKING, MODIFIERS, PART, PHASE, SECTIONS, STATE
from rotsolve.language.keys import Key, keys_of
from rotsolve.language.sheet_keys import LISTED, SHEET
from rotsolve.language.words import hint, quoted
from rotsolve.scene.elements import TABLES

BEGIN = "<!-- generated from the tables: begin -->"
END = "<!-- generated: end -->"
SHEETS = (("sheet file", SHEET), ("problem of a sheet", LISTED))
LATER = " *(not solved yet)*"
IN_SPACE = " *(in space)*"
IN_PLANE = " *(in the plane)*"

PHRASE_WORDS = {  # those of `find` by what they do
    **{word: f"`{word}`: stands before an expression of `find` and belongs to the whole of it" for word in MODIFIERS},
    **{word: f"`{word}`: begins a clause of `find`, after the expression" for word in CLAUSES},
}


def describe_all() -> str:
    """The whole reference, plain enough for a terminal."""
    return "\n\n".join(reference_chapters())


def describe_word(name: str) -> str:
    """What one word means, in every place where it can stand. Raises KeyError with a hint for an unknown word."""
    wanted = " ".join(name.split())
    entries = [*word_entries(), ("units", chapter_text("Units", unit_rows()))]
    found = [text for word, text in entries if word == wanted]
    if not found:
        known = dict.fromkeys(word for word, _ in entries)
        raise KeyError(f"unknown word {quoted(name)}; {hint(wanted, known, 'words')}")
    return "\n\n".join(dict.fromkeys(found))


def generate() -> str:
    """The generated part of docs/language.md."""
    return f"{BEGIN}\n\n{describe_all()}\n\n{END}\n"


def word_entries() -> Iterator[tuple[str, str]]:
    """Every word of the language with its text."""
    for word, key in SECTIONS.items():
        yield word, f"`{word}` (top level): {key.help}{later_mark(key.later)}"
    for shape in SHAPES:
        yield shape.word, element_text(shape, "shape")
    for kind, table in TABLES.values():
        for cls in table:
            yield cls.word, element_text(cls, kind)
    for entry in QUANTITIES.values():
        yield entry.word, quantity_text(entry)
    for title, keys in (
        ("body", BODY),
        ("part", PART),
        ("state", STATE),
        ("phase", PHASE),
        ("marking", MARKING),
        ("deduction", DEDUCT),
        *SHEETS,
    ):
        for word, key in keys.items():
            yield word, f"`{word}` (of a {title}): {key_meaning(key)}"
    yield from PHRASE_WORDS.items()


def reference_chapters() -> Iterator[str]:
    """The reference by chapter."""
    yield chapter_text("Top level", key_rows(SECTIONS.items()))
    yield chapter_text("Keys of a body", key_rows(BODY.items()))
    yield chapter_text("Keys of a part or hole, beside those of a body", key_rows(PART.items()))
    yield chapter_text("Shapes", [element_text(shape, "shape") for shape in SHAPES])
    for section, (kind, table) in TABLES.items():
        yield chapter_text(section.capitalize(), [element_text(cls, kind) for cls in table])
    yield chapter_text("Words of a state, beside quantities and connections", key_rows(STATE.items()))
    yield chapter_text("Keys of a phase", key_rows(PHASE.items()))
    yield chapter_text("Keys of an answer's marking", key_rows(MARKING.items()))
    yield chapter_text("Keys of `deduct`", key_rows(DEDUCT.items()))
    for title, keys in SHEETS:
        yield chapter_text(f"Keys of a {title}", key_rows(keys.items()))
    lines = ["| word | letter | of | components | meaning |", "| --- | --- | --- | --- | --- |"]
    lines += [quantity_row(entry) for entry in QUANTITIES.values()]
    yield "### Quantities\n\n" + "\n".join(lines)
    yield chapter_text("Units", unit_rows())


def unit_rows() -> Iterator[str]:
    """The units by what they measure, `length: m, cm, …`; those that have several meanings, with what to write."""
    kinds: dict[str, list[str]] = {}
    for name, unit in UNITS.items():
        if name in (unit.text, "deg"):  # not the other spellings of one
            kinds.setdefault(describe(unit.dimension), []).append(name)
    for measure, names in kinds.items():
        yield f"{measure}: " + ", ".join(f"`{name}`" for name in names)
    for name, help in AMBIGUOUS.items():
        yield f"`{name}` has several meanings: {help}"


def chapter_text(title: str, items: Iterable[str]) -> str:
    return f"### {title}\n\n" + "\n".join(f"- {item}" for item in items)


def key_rows(keys: Iterable[tuple[str, Key]]) -> list[str]:
    return [f"`{word}`: {key_meaning(key)}" for word, key in keys]


def key_meaning(key: Key) -> str:
    """The help of a key with its choices, limits and example."""
    text = key.help
    if key.choices and not any(choice in key.help for choice in key.choices[:1]):
        text += f": {', '.join(key.choices)}"
    details = [key.dimension or "", key.limits, "required" if key.required else "", "may vary" if key.varies else ""]
    shown = ", ".join(detail for detail in details if detail)
    text += f" ({shown})" if shown else ""
    text += f", e.g. `{key.example}`" if key.example else ""
    return text + later_mark(key.later) + (IN_SPACE if key.space else IN_PLANE if key.plane else "")


def later_mark(flag: bool) -> str:
    return LATER if flag else ""


def element_text(cls: Any, kind: str) -> str:
    """An element with its keys, points, quantities and words."""
    world = IN_SPACE if not getattr(cls, "planar", True) else "" if getattr(cls, "spatial", True) else IN_PLANE
    lines = [f"`{cls.word}` ({kind}): {cls.about}{later_mark(cls.later)}{world}"]
    lines += [f"  - `{word}`: {key_meaning(key)}" for word, key in keys_of(cls)]
    if kind == "shape":
        lines.append(f"  - points: {', '.join((*cls.points, 'cm'))}")
    if getattr(cls, "quantities", ()):
        beside = getattr(cls, "quantities_in_space", ())
        more = f"; in space also {', '.join(beside)}" if beside else ""
        lines.append(f"  - quantities: {', '.join(cls.quantities)}{more}")
    if getattr(cls, "words", ()):
        lines.append(f"  - in a state it can be said to be: {', '.join(cls.words)}")
    return "\n".join(lines)


def quantity_text(entry: QuantityKind) -> str:
    """A quantity with its owners and components."""
    about = f"`{entry.word}` (quantity): {entry.help}{later_mark(entry.later)}"
    about += f"; of: {', '.join(entry.owners)}" if entry.owners else ""
    return about + (f"; components: {', '.join(entry.components)}" if entry.components else "")


def quantity_row(entry: QuantityKind) -> str:
    lists = (", ".join(entry.owners), ", ".join(entry.components))
    meaning = entry.help + later_mark(entry.later) + (IN_SPACE if entry.space else "")
    return f"| {' | '.join((f'`{entry.word}`', entry.letter, *lists, meaning))} |"
