"""Describe: the reference of the language as markdown, made from the tables that the reader reads."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Any

from rotsolve.core.quantity import QUANTITIES, QuantityKind
from rotsolve.elements.shapes import SHAPES
from rotsolve.language.keys import Key, keys_of
from rotsolve.language.sections import BODY, DEDUCT, MARKING, PART, PHASE, SECTIONS
from rotsolve.language.words import hint, quoted
from rotsolve.scene.phrase.clauses import CLAUSES
from rotsolve.scene.phrase.phrases import MODIFIERS
from rotsolve.scene.reader.elements import TABLES

BEGIN = "<!-- generated from the tables: begin -->"
END = "<!-- generated: end -->"
LATER = " *(not solved yet)*"


def describe_all() -> str:
    """The whole reference, plain enough for a terminal."""
    return "\n\n".join(text for _, text in chapters())


def describe(name: str) -> str:
    """What one word means, in every place where it can stand. Raises KeyError with a hint for an unknown word."""
    wanted = " ".join(name.split())
    found = [text for word, text in words() if word == wanted]
    if not found:
        known = dict.fromkeys(word for word, _ in words())
        raise KeyError(f"unknown word {quoted(name)}; {hint(wanted, known, 'words')}")
    return "\n\n".join(dict.fromkeys(found))


def generate() -> str:
    """The generated part of docs/language.md."""
    return f"{BEGIN}\n\n{describe_all()}\n\n{END}\n"


def words() -> Iterator[tuple[str, str]]:
    """Every word of the language with its text."""
    for word, key in SECTIONS.items():
        yield word, f"`{word}` (top level): {key.help}{later(key.later)}"
    for shape in SHAPES:
        yield shape.word, element(shape, "shape")
    for kind, table in TABLES.values():
        for cls in table:
            yield cls.word, element(cls, kind)
    for entry in QUANTITIES:
        yield (
            entry.word,
            f"`{entry.word}` (quantity): {entry.help}{later(entry.later)}{owned(entry)}{parts(entry)}",
        )
    for title, keys in (("body", BODY), ("part", PART), ("phase", PHASE), ("marking", MARKING), ("deduction", DEDUCT)):
        for word, key in keys.items():
            yield word, f"`{word}` (of a {title}): {meaning(key)}"
    for modifier in MODIFIERS:
        yield modifier, f"`{modifier}`: stands before an expression of `find` and belongs to the whole of it"
    for clause in CLAUSES:
        yield clause, f"`{clause}`: begins a clause of `find`, after the expression"


def chapters() -> Iterator[tuple[str, str]]:
    """The reference by chapter."""
    yield "sections", chapter("Top level", rows(SECTIONS.items()))
    yield "bodies", chapter("Keys of a body", rows(BODY.items()))
    yield "parts", chapter("Keys of a part or hole, beside those of a body", rows(PART.items()))
    yield "shapes", chapter("Shapes", [element(shape, "shape") for shape in SHAPES])
    for section, (kind, table) in TABLES.items():
        yield section, chapter(section.capitalize(), [element(cls, kind) for cls in table])
    yield "phases", chapter("Keys of a phase", rows(PHASE.items()))
    yield "marking", chapter("Keys of an answer's marking", rows(MARKING.items()))
    yield "deductions", chapter("Keys of `deduct`", rows(DEDUCT.items()))
    lines = ["| word | letter | of | components | meaning |", "| --- | --- | --- | --- | --- |"]
    lines += [quantity(entry) for entry in QUANTITIES]
    yield "quantities", "### Quantities\n\n" + "\n".join(lines)


def chapter(title: str, items: Iterable[str]) -> str:
    return f"### {title}\n\n" + "\n".join(f"- {item}" for item in items)


def rows(keys: Iterable[tuple[str, Key]]) -> list[str]:
    return [f"`{word}`: {meaning(key)}" for word, key in keys]


def meaning(key: Key) -> str:
    """The help of a key with its choices, limits and example."""
    text = key.help
    if key.choices and not any(choice in key.help for choice in key.choices[:1]):
        text += f": {', '.join(key.choices)}"
    details = [
        key.dimension or "",
        key.limits,
        "required" if key.required else "",
        "may vary" if key.varies else "",
    ]
    shown = ", ".join(detail for detail in details if detail)
    text += f" ({shown})" if shown else ""
    text += f", e.g. `{key.example}`" if key.example else ""
    return text + later(key.later)


def later(flag: bool) -> str:
    return LATER if flag else ""


def element(cls: Any, kind: str) -> str:
    """An element with its keys, points, quantities and words."""
    lines = [f"`{cls.word}` ({kind}): {cls.about}{later(cls.later)}"]
    lines += [f"  - `{word}`: {meaning(key)}" for word, key in keys_of(cls)]
    if kind == "shape":
        lines.append(f"  - points: {', '.join((*cls.points, 'cm'))}")
    if getattr(cls, "quantities", ()):
        lines.append(f"  - quantities: {', '.join(cls.quantities)}")
    if getattr(cls, "words", ()):
        lines.append(f"  - in a state it can be said to be: {', '.join(cls.words)}")
    return "\n".join(lines)


def owned(entry: QuantityKind) -> str:
    return f"; of: {', '.join(entry.owners)}" if entry.owners else ""


def parts(entry: QuantityKind) -> str:
    return f"; components: {', '.join(entry.components)}" if entry.components else ""


def quantity(entry: QuantityKind) -> str:
    cells = (
        f"`{entry.word}`",
        entry.letter,
        ", ".join(entry.owners),
        ", ".join(entry.components),
        entry.help + later(entry.later),
    )
    return f"| {' | '.join(cells)} |"


def renew(path: str) -> None:
    """Write the generated part of the page anew."""
    with open(path, encoding="utf-8") as stream:
        text = stream.read()
    with open(path, "w", encoding="utf-8") as stream:
        stream.write(text[: text.index(BEGIN)] + generate())
