"""Patterns: the lines of a table of phrases, `Put {what} into {place} => {what} in {place} einsetzen`, and how they fit a text.

What stands in a slot is said by its name, digits behind it left out:

- `name`, `point`: a word of the scene, which stays as it is; `formula`: mathematics; `value`: mathematics or one word
- `body`: a word of the scene, else a phrase; `bodies`: several, joined by commas and "and"
- anything else: a phrase, which is translated in its turn

A line `shape/rod => Stab` says what "rod" is in a slot `{shape}`, and nowhere else: in another it may be a word of the scene.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import cached_property

from msgspec import Struct

ARROW = " => "
COMMENT = "#"
PLAIN = ("name", "point", "formula", "value")  # slots whose texts are not translated
SECTION = re.compile(r"\[(\w+)\]")
SLOT = re.compile(r"\{(\w+)\}")


class Pattern(Struct, frozen=True, dict=True):
    """A phrase with slots, and what it is in the other language: `literals` stand before, between and behind the slots."""

    literals: tuple[str, ...]
    slots: tuple[str, ...]
    target: str

    @cached_property
    def weight(self) -> int:
        """How much of a text it takes itself: what says more is tried before."""
        return sum(map(len, self.literals))

    @cached_property
    def longest(self) -> str:
        """The literal that tells most texts apart."""
        return max(self.literals, key=len)

    @cached_property
    def order(self) -> tuple[str, ...]:
        """The slots in the order in which they are looked at: those first that are no phrases."""
        return tuple(sorted(self.slots, key=lambda slot: slot_kind(slot) not in PLAIN))

    def fits(self, text: str) -> Iterator[dict[str, str]]:
        """Each way in which the text can be read by it: what stands in its slots."""
        if self.longest in text and text.startswith(self.literals[0]):
            yield from self._from(text, len(self.literals[0]), 0)

    def _from(self, text: str, start: int, place: int) -> Iterator[dict[str, str]]:
        slot, literal = self.slots[place], self.literals[place + 1]
        if place == len(self.slots) - 1:
            end = len(text) - len(literal)
            if end > start and text.endswith(literal):
                yield {slot: text[start:end]}
            return
        end = text.find(literal, start + 1)
        while end > 0:
            for behind in self._from(text, end + len(literal), place + 1):
                yield {slot: text[start:end]} | behind
            end = text.find(literal, end + 1)

    def filled(self, found: dict[str, str]) -> str:
        """The target with its slots filled."""
        return SLOT.sub(lambda slot: found[slot[1]], self.target)


def slot_kind(slot: str) -> str:
    """What stands in a slot: `name` of `name2`."""
    return slot.rstrip("0123456789")


class PhraseTable(Struct, frozen=True):
    """One section of a file: phrases by what they are in English, and patterns in their order."""

    phrases: dict[str, str]
    patterns: tuple[Pattern, ...]


def read_tables(text: str) -> dict[str, PhraseTable]:
    """The sections of a file, each below its name in square brackets."""
    sections = dict[str, list[str]]()
    for line in filter(None, text.splitlines()):
        if match := SECTION.match(line):
            sections[match[1]] = lines = []
        elif not line.startswith(COMMENT):
            lines.append(line)
    return {name: phrase_table(lines) for name, lines in sections.items()}


def phrase_table(lines: Iterable[str]) -> PhraseTable:
    """The lines of a section."""
    phrases, patterns = dict[str, str](), list[Pattern]()
    for line in lines:
        source, arrow, target = line.partition(ARROW)
        if not arrow or source in phrases:
            raise ValueError(f"a line of a table of phrases that is none, or stands there twice: {line}")
        pieces = SLOT.split(source)
        if len(pieces) == 1:
            phrases[source] = target
        else:
            patterns.append(Pattern(tuple(pieces[::2]), tuple(pieces[1::2]), target))
    return PhraseTable(phrases, tuple(patterns))
