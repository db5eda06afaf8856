"""Scope: everything that is known while a file is being read, and the faults found so far."""

from __future__ import annotations

import re
from collections.abc import Container, Iterable
from typing import Any, Never

from rotsolve.algebra.formula import FUNCTIONS, Formula, Symbol
from rotsolve.algebra.units.dimension import Dimension
from rotsolve.algebra.units.quantities import UnitValue
from rotsolve.core.faults import Fault, Related, Span
from rotsolve.core.quantity import QUANTITIES, SYSTEM
from rotsolve.language.grammar import RESERVED_WORDS
from rotsolve.language.problem import Body, Given
from rotsolve.language.words import an, hint, nearest_name, quoted
from rotsolve.scene.rough import remember
from rotsolve.scene.tree import Map, Node, Text

NAME = re.compile(r"[A-Za-z][A-Za-z0-9_]{0,39}")
AXES_NAMED = ("node", "space")  # axes in space that have no body's name
RESERVED = {
    **dict.fromkeys(RESERVED_WORDS, "a word of the language"),
    **dict.fromkeys(("all", "none", "any", "true", "false", "null"), "a word of the language"),
    **dict.fromkeys(("ground", "ceiling"), "a surface that always exists"),
    **dict.fromkeys(FUNCTIONS, "a function"),
    **{
        word: "a quantity of the whole scene"
        for word, entry in QUANTITIES.items()
        if SYSTEM in entry.owners and len(word) > 6
    },
    "ln": "a function",
    "pi": "the number π",
    "time": "running time",
}
ALWAYS = ("ground", "ceiling")
LATER_HELP = "the scene reads well, but the physics of this word comes in a later version"
MOST_FAULTS = 100
ASCII = {"ä": "ae", "ö": "oe", "ü": "ue", "ß": "ss", "Ä": "Ae", "Ö": "Oe", "Ü": "Ue", "ø": "oe", "æ": "ae"}
UNKNOWN = "unknown: "  # begins the cause of a fault that names what nothing gives
Nothing = Never | None  # noqa: RUF020  # None, which a reader may give back for what it did not find


def plainly_spelt(word: str, taken: Container[str]) -> str:
    """What to write for a name with Greek or other letters, blanks or hyphens; '' where that is no name either, or names something."""
    from unicodedata import normalize  # only a faulty scene pays for it

    from rotsolve.algebra.notation.letters import LETTER_NAMES

    told = "".join(LETTER_NAMES.get(letter, ASCII.get(letter, letter)) for letter in word)
    plain = re.sub(r"\W+", "_", re.sub(r"[^\x00-\x7f]", "", normalize("NFKD", told))).strip("_")
    return f"write `{plain}`: " if plain != word and NAME.fullmatch(plain) and plain not in taken else ""


class Scope:
    """Names, dimensions and bodies read so far; the one mutable thing of a run."""

    def __init__(self) -> None:
        self.space = False  # whether the scene is one in space
        self.faults: list[Fault] = []
        self.kinds: dict[str, str] = dict.fromkeys(ALWAYS, "surface")
        self.places: dict[str, Span] = {}
        self.givens: dict[str, Given] = {}
        self.dimensions: dict[str, Dimension | None] = {}
        self.numbers: dict[str, float] = {}  # rough values, for limits only
        self.made: dict[str, Formula] = {}  # of givens that are made of letters without a number, in these
        self.bodies: dict[str, Body] = {}
        self.points: dict[str, tuple[str, ...]] = {}
        self.elements: dict[str, Any] = {}  # connections, actions and events by name
        self.touched: dict[str, tuple[str, ...]] = {}  # connection -> what it touches
        self.choices: set[str] = set()  # questions whose answer is a label
        self.of_no_kind: frozenset[str] = (
            frozenset()
        )  # letters that are sought and units as well, of which that has been said
        self.conflicts: set[str] = set()  # names used twice: what they name can't be told
        self.blamed: set[str] = set()  # givens whose dimension has been found wrong
        self.half_read: set[str] = (
            set()
        )  # names of connections, actions and events with faults: what they touch is not known
        self.lost: set[str] = set()  # names of what could not be read: that they are not known follows from that
        self.written: frozenset[str] = (
            frozenset()
        )  # all names that the sections give, also those that are entered later
        self.doubled: list[Text] = []  # names that can't be, since they stand twice or say something else
        self.guessed: list[Node] = []  # values that are read under another key than they have

    def fault(
        self,
        place: Node | Span | None,
        message: str,
        help: str = "",
        kind: str = "scene",
        *,
        related: tuple[Related, ...] = (),
        cause: str = "",
    ) -> Nothing:
        """Note a fault; nothing is read then, which is what the reader returns."""
        if len(self.faults) < MOST_FAULTS:
            span = place if isinstance(place, Span) or place is None else place.span
            if span is not None and span.line == 0:  # a setting of the command line
                span, message = None, f"--set: {message}"
            self.faults.append(Fault(message, span, help, kind, related=related, cause=cause))
        return None

    def later(self, place: Node | Span | None, word: str) -> Nothing:
        """A word that is read but whose physics is not there yet."""
        return self.fault(place, f"`{word}` is not solved yet", LATER_HELP, "not yet")

    def names(self, *kinds: str) -> list[str]:
        """The names of these kinds of things, in the order of the file."""
        own = [name for name, kind in self.kinds.items() if kind in kinds and name not in ALWAYS]
        return [*own, *(ALWAYS if "surface" in kinds else ())]

    def declare(self, name: Text, kind: str) -> bool:
        """Enter a name; it must be new in the whole file. One that it can't have is read as if it could, where that goes."""
        word = name.value
        if not NAME.fullmatch(word):
            self.doubled.append(name)
            self.lost.update((word, re.split(r"[\s:{\[]", word)[0]))
            if before := re.match(r"(\w+)\s*([{\[])", word):
                help = f"write `{before[1]}: {word[before.start(2) :]}`"
                self.fault(name, f"no colon behind `{before[1]}`", help, "yaml")
                return False
            help = "a name is letters, digits and `_`, begins with a letter and has at most 40 characters"
            self.fault(
                name,
                f"{quoted(word)} can't be a name",
                f"{plainly_spelt(word, {*self.kinds, *self.written, *RESERVED})}{help}",
                "name",
            )
            return False
        taken = f": it is {RESERVED[word]}" if word in RESERVED else ""
        if self.space and word in AXES_NAMED:
            taken = f" in space: `in {word} axes` means others"
        if taken:
            self.lost.add(word)
            self.doubled.append(name)
            help = f"choose another name, as `{word}_1`"
            self.fault(name, f"`{word}` can't be a name{taken}", help, "name")
        elif word in self.kinds:
            first = self.places.get(word)
            self.conflicts.add(word)
            self.lost.add(word)
            self.doubled.append(name)
            place = f" in line {first.line}" if first else ""
            message = f"`{word}` already names {an(self.kinds[word])}{place}"
            self.fault(name, message, "a name is used once in the whole file", "name", related=self.given_at(word))
            return False
        self.kinds[word] = kind
        self.places[word] = name.span
        return True

    def unknown(
        self,
        place: Node | Span,
        word: str,
        what: str,
        names: Iterable[str],
        plural: str,
        where: str = "",
        own: bool = True,
    ) -> Nothing:
        """An unknown name, the scene's `own` or a word of the language, with what was probably meant."""
        message = f"unknown {what} {quoted(word)}{where}"
        return self.fault(place, message, hint(word, names, plural), "unknown", cause=f"{UNKNOWN}{word}" * own)

    def given_at(self, *names: str) -> tuple[Related, ...]:
        """Where names are told in the file, of those that are."""
        set_ = {name for name, given in self.givens.items() if given.span is None}  # by the command line
        known = [(name, self.places[name]) for name in names if name in self.places and name not in set_]
        return tuple(Related(span, f"`{name}` is given here") for name, span in known)

    def entries(
        self, node: Node, what: str, allowed: Iterable[str] | None = None, *, own: bool = False
    ) -> dict[str, tuple[Text, Node]]:
        """The entries of a map by name, the scene's `own` or keys of the language; duplicates, unknown keys and missing values are faults
        and left out."""
        if not isinstance(node, Map):
            found = "nothing" if isinstance(node, Text) and node.empty else node.shown
            self.fault(node, f"{what} wants `name: value` lines, but this is {found}", "write `{name: value}`", "form")
            return {}
        names = None if allowed is None else list(allowed)
        result: dict[str, tuple[Text, Node]] = {}
        for key, value in node.entries:
            word = key.value
            if word in result:
                first = Related(result[word][0].span, "the first is here")
                help = "leave one of them out: YAML would keep only one"
                self.fault(key, f"{quoted(word)} stands twice in {what}", help, "duplicate", related=(first,))
                self.doubled += [key] if names is None else []
            elif isinstance(value, Text) and value.empty:
                self.missing_value(key, node)
            elif names is not None and word not in names:
                cause = f"{UNKNOWN}{word}" * own
                self.fault(key, f"unknown key {quoted(word)} in {what}", hint(word, names, "keys"), "key", cause=cause)
                self.lost.update(entry.value for entry, _ in (value.entries if isinstance(value, Map) else ()))
                guess = nearest_name(word, names)
                if guess is not None and node.key(guess) is None and guess not in result:
                    self.guessed.append(value)
                    result[guess] = (key, value)
            else:
                result[word] = (key, value)
        return result

    def missing_value(self, key: Text, node: Map) -> None:
        from rotsolve.scene.traps import null_fault

        position = [entry[0] for entry in node.entries].index(key)
        before = node.entries[position - 1][1] if position else None
        self.faults.append(null_fault(key.value, key.span, before.value if isinstance(before, Text) else ""))

    def automatic(self, letter: str, owner: str, quantity: UnitValue, span: Span | None, hint: str = "") -> Symbol:
        """The letter of a quantity that was written in place, so that derivations print letters; in questions one for each value.

        Of one body the same height, written twice, is one letter: what cancels by numbers then does in letters.
        """
        own, base = (quantity.value, quantity.dimension, quantity.text), f"{letter}_{owner}"
        for given in self.givens.values() if not (owner and hint) else ():
            named = not owner or given.name.rstrip("0123456789") == base
            if named and given.automatic and given.span and (given.value, given.dimension, given.text) == own:
                return Symbol(given.name)
        name = self.free(letter, owner, hint)
        self.givens[name] = Given(
            name, quantity.value, quantity.dimension, quantity.unit, quantity.text, automatic=True, span=span
        )
        self.dimensions[name] = quantity.dimension
        remember(self.numbers, name, quantity.value)
        return Symbol(name)

    def side(self, value: Formula) -> int | None:
        """The certified sign of a value, which rough numbers do not tell where it nearly vanishes; None where a letter has no number."""
        from rotsolve.algebra.certified.sign import SignOracle

        known = {given.name: given.value for given in self.givens.values() if given.value is not None}
        return SignOracle(known).by_numbers(value)

    def free(self, letter: str, owner: str, hint: str = "") -> str:
        """A name that nothing else has: letter_owner, letter_owner_hint, letter_owner2, …"""
        base = f"{letter}_{owner}" if owner else letter
        taken = {*self.kinds, *self.givens, *RESERVED}
        for name in (base, f"{base}_{hint}" if hint else base):
            if name not in taken:
                return name
        number = 2
        while f"{base}{number}" in taken:
            number += 1
        return f"{base}{number}"
