"""Language: a table of phrases, and how a text is put together from it.

A text is a phrase of the table, or fits one of its patterns, whose slots are texts in their turn; words of the scene stay as they are.
Joints ("{one}; {other}") are patterns that are tried before all others, or behind them where they are loose ("{one} and {other}"). What no
table says stays in English: of a text with joints that part alone.
"""

from __future__ import annotations

import re
from pathlib import Path

from msgspec import Struct

from rotsolve.page.languages.patterns import Pattern, read_tables, slot_kind

FORMULAS = 0xE000  # letters from here on, which no language uses, stand for the formulas within a text
DECIMALS = re.compile(r"(?<=\d)\.(?=\d)")
WORD = re.compile(r"[A-Za-zÀ-ſΑ-ω]+(?:_\w+)?")
MATHEMATICS = frozenset(("sin", "cos", "tan", "arcsin", "arccos", "arctan", "exp", "det", "rad", "rev", "min"))
LETTERS = 2  # at most, of a name in a formula: dx, kg, wx
SHORT = frozenset(  # words of so many letters
    ("an", "as", "at", "be", "by", "do", "go", "he", "if", "in", "is", "it", "me", "no", "of", "on", "or", "so", "to", "up", "us", "we")
)  # fmt: skip
BETWEEN = re.compile(r", and |, | and ")
PARTS = frozenset(("one", "other"))  # slots of patterns that join two texts, of which one may be known alone


class Language(Struct, frozen=True, dict=True):
    """A language: its `code` as in HTML, its sign before decimals, its name in LaTeX's package babel, and the tables of its file."""

    code: str
    decimal: str
    babel: str
    words: dict[str, str]
    joints: tuple[Pattern, ...]
    patterns: tuple[Pattern, ...]


class Translation:
    """The texts of one page in a language; `names` are the words of its scene, which stay as they are.

    `lost` collects what no table says, for those who complete them.
    """

    def __init__(self, language: Language, names: frozenset[str] = frozenset()) -> None:
        self.language, self.names = language, names
        self.words, self.patterns = language.words, language.patterns
        self.known = dict[str, str | None]()
        self.lost = set[str]()

    def translate(self, text: str) -> str:
        """A text in this language, what is not known of it in English."""
        inner = text.strip()
        if not inner:
            return text
        before, behind = text[: len(text) - len(text.lstrip())], text[len(text.rstrip()) :]
        return f"{before}{self._translated(inner)}{behind}"

    def _translated(self, text: str) -> str:
        said = self.said(text) or self._name(text)
        if said is not None:
            return said
        for joint in self.language.joints:
            for found in joint.fits(text):
                return joint.filled({slot: self._translated(part.strip()) for slot, part in found.items()})
        self.lost.add(text)
        return text

    def said(self, text: str) -> str | None:
        """A text in this language where all of it is known."""
        if text not in self.known:
            self.known[text] = self._by_words(text) or self._by_patterns(text) or self._begun_small(text)
        return self.known[text]

    def _by_words(self, text: str) -> str | None:
        return self.words.get(text) or self._formula(text)

    def _by_patterns(self, text: str) -> str | None:
        for pattern in self.patterns:
            for found in pattern.fits(text):
                parts = dict[str, str]()
                for slot in pattern.order:
                    said = self._slot(slot_kind(slot), found[slot])
                    if said is None:
                        break
                    parts[slot] = said
                else:
                    return pattern.filled(parts)
        return None

    def _begun_small(self, text: str) -> str | None:
        """A sentence by a phrase that begins with a small letter."""
        small = text[:1].lower() + text[1:]
        said = self.said(small) if small != text and text[1:2].islower() else None
        return None if said is None else said[:1].upper() + said[1:]

    def _slot(self, what: str, text: str) -> str | None:
        """What stands in a slot."""
        if text != text.strip():
            return None
        if f"{what}/{text}" in self.words:
            return self.words[f"{what}/{text}"]
        match what:
            case "name" | "point":
                return self._name(text)
            case "formula":
                return self._formula(text)
            case "value":
                return self._formula(text) or self._name(text)
            case "body":
                return self._name(text) or self.said(text)
            case "bodies":
                return self._bodies(text)
        return self.said(text)

    def _name(self, text: str) -> str | None:
        """A word of the scene, or several with points between them."""
        return text if text in self.names or self.names.issuperset(text.split(".")) else None

    def _formula(self, text: str) -> str | None:
        """Mathematics, with the decimal sign of the language."""
        return DECIMALS.sub(self.language.decimal, text) if is_mathematics(text) else None

    def _bodies(self, text: str) -> str | None:
        """Bodies joined by commas and "and"."""
        bodies = [self._slot("body", part) for part in BETWEEN.split(text)]
        told = [body for body in bodies if body is not None]
        if len(told) < len(bodies):
            return None
        return " ".join(filter(None, (", ".join(told[:-1]), self.words["and"] if told[1:] else "", told[-1])))


def read_language(code: str) -> Language:
    """The language of a file of this folder."""
    tables = read_tables(Path(__file__).with_name(f"{code}.txt").read_text(encoding="utf-8"))
    joints, phrases, loose = (tables[name] for name in ("joints", "phrases", "loose"))
    patterns = (*joints.patterns, *sorted(phrases.patterns, key=lambda one: -one.weight), *loose.patterns)
    parting = tuple(one for one in patterns if set(one.slots) <= PARTS)
    own = tables["language"].phrases
    return Language(code, own["decimal"], own["babel"], phrases.phrases, parting, patterns)


def is_mathematics(text: str) -> bool:
    """Whether nothing in a text is a word: letters of one or two signs, or with something below them, functions and units."""
    words = (word for word in WORD.findall(text) if "_" not in word)
    return all(
        len(word) == 1 or word in MATHEMATICS or (len(word) == LETTERS and word.lower() not in SHORT) for word in words
    )
