"""Language: a table of phrases, and how a text is put together from it.

A text is a phrase of the table, or fits one of its patterns, whose slots are texts in their turn; words of the scene stay as they are.
Joints ("{one}; {other}") are patterns that are tried before all others, or behind them where they are loose ("{one} and {other}"). What no
table says stays in English: of a text with joints that part alone.
"""

from __future__ import annotations

import re
from functools import cached_property
from pathlib import Path

from msgspec import Struct, field

from rotsolve.page.languages.patterns import Pattern, kind, read_tables

FORMULAS = 0xE000  # letters from here on, which no language uses, stand for the formulas within a text
DECIMALS = re.compile(r"(?<=\d)\.(?=\d)")
WORD = re.compile(r"[^\W\d_]+(?:_\w+)?")
MATHEMATICS = frozenset(
    "sin cos tan arcsin arccos arctan ln exp det trace rad rev min kg mm cm km am sn cn dn "
    "dm dt dx dy dz dv dr dω dθ dφ dA dV dL dB dI xx yy zz xy yz zx sg".split()
)
ENGLISH = frozenset(  # words that no name of a scene has, but phrases do
    "a about all an and are as at back be beyond but by comes does for from gives has how if in into is it its less more moves "
    "no not of on or out say that the there they this to turns until was what when where which while whose with".split()
)
BETWEEN = re.compile(r", and |, | and ")
PARTS = frozenset(("one", "other"))  # slots of patterns that join two texts, of which one may be known alone
NAMED = re.compile(r"[^\W_](?:[\w.'’() -]*[\w)])?")


class Said(Struct, frozen=True):
    """A text in the language, and the words in it that were taken for names of the scene."""

    text: str
    names: tuple[str, ...] = ()


class Language(Struct, frozen=True, dict=True):
    """A language: its `code` as in HTML, its sign before decimals, its name in LaTeX's package babel, and the tables of its file.

    `lost` collects what no table says, `names` what was taken for words of the scene, for those who complete the tables.
    """

    code: str
    decimal: str
    babel: str
    words: dict[str, str]
    joints: tuple[Pattern, ...]
    patterns: tuple[Pattern, ...]
    lost: set[str] = field(default_factory=set)
    names: set[str] = field(default_factory=set)

    @cached_property
    def known(self) -> dict[str, Said | None]:
        """What was translated before."""
        return {}

    def translate(self, text: str) -> str:
        """A text in this language, what is not known of it in English."""
        inner = text.strip()
        if not inner:
            return text
        before, behind = text[: len(text) - len(text.lstrip())], text[len(text.rstrip()) :]
        return f"{before}{self._translated(inner)}{behind}"

    def _translated(self, text: str) -> str:
        said = self.said(text)
        if said is not None:
            self.names.update(said.names)
            return said.text
        for joint in self.joints:
            for found in joint.fits(text):
                return joint.filled({slot: self._translated(part.strip()) for slot, part in found.items()})
        self.lost.add(text)
        return text

    def said(self, text: str) -> Said | None:
        """A text in this language where all of it is known."""
        if text not in self.known:
            self.known[text] = self._by_words(text) or self._by_patterns(text) or self._begun_small(text)
        return self.known[text]

    def _by_words(self, text: str) -> Said | None:
        if text in self.words:
            return Said(self.words[text])
        return Said(self.numerals(text)) if is_mathematics(text) else None

    def _by_patterns(self, text: str) -> Said | None:
        for pattern in self.patterns:
            for found in pattern.fits(text):
                parts = {slot: self._slot(slot, part) for slot, part in found.items()}
                if all(part is not None for part in parts.values()):
                    filled = {slot: part for slot, part in parts.items() if part is not None}
                    names = tuple(name for part in filled.values() for name in part.names)
                    return Said(pattern.filled({slot: part.text for slot, part in filled.items()}), names)
        return None

    def _begun_small(self, text: str) -> Said | None:
        """A sentence by a phrase that begins with a small letter."""
        small = text[:1].lower() + text[1:]
        said = None if small == text or is_mathematics(text[:2].strip()) else self.said(small)
        return None if said is None else Said(said.text[:1].upper() + said.text[1:], said.names)

    def _slot(self, slot: str, text: str) -> Said | None:
        """What stands in a slot."""
        if text != text.strip():
            return None
        what = kind(slot)
        if f"{what}/{text}" in self.words:
            return Said(self.words[f"{what}/{text}"])
        match what:
            case "name" | "point":
                return as_name(text)
            case "formula":
                return Said(self.numerals(text)) if is_mathematics(text) else None
            case "value":
                return Said(self.numerals(text)) if is_mathematics(text) or " " not in text else None
            case "body":
                return as_name(text) or self.said(text)
            case "bodies":
                return self._bodies(text)
        return self.said(text)

    def _bodies(self, text: str) -> Said | None:
        """Bodies joined by commas and "and"."""
        bodies = [self._slot("body", part) for part in BETWEEN.split(text)]
        told = [body for body in bodies if body is not None]
        if len(told) < len(bodies):
            return None
        between = self.said("and")
        joined = ", ".join(body.text for body in told[:-1])
        last = f" {between.text if between else 'and'} " if joined else ""
        return Said(f"{joined}{last}{told[-1].text}", tuple(name for body in told for name in body.names))

    def numerals(self, text: str) -> str:
        """Numbers with the decimal sign of the language."""
        return DECIMALS.sub(self.decimal, text)


def read_language(code: str) -> Language:
    """The language of a file of this folder."""
    tables = read_tables(Path(__file__).with_name(f"{code}.txt").read_text(encoding="utf-8"))
    joints, phrases, loose = (tables[name] for name in ("joints", "phrases", "loose"))
    patterns = (*joints.patterns, *sorted(phrases.patterns, key=lambda one: -one.weight), *loose.patterns)
    parting = tuple(one for one in patterns if set(one.slots) <= PARTS)
    return Language(code, tables["language"].phrases["decimal"], tables["language"].phrases["babel"], phrases.phrases, parting, patterns)


def as_name(text: str) -> Said | None:
    """The text where it can be a name of the scene."""
    if not NAMED.fullmatch(text) or not ENGLISH.isdisjoint(text.lower().split()):
        return None
    return Said(text, (text,))


def is_mathematics(text: str) -> bool:
    """Whether nothing in a text is a word: letters of one sign, or with something below them, functions, differentials and units."""
    return all(len(word) == 1 or "_" in word or word in MATHEMATICS for word in WORD.findall(text))
