"""Choices in questions: `which of` several quantities or conditions.

`{which of: {a: PHRASE, b: PHRASE}, is: largest | smallest | above X | below X}`, `{which of: {label: X < Y < Z, other: X = Y}}`.
"""

from __future__ import annotations

import re
from typing import Any

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO
from rotsolve.algebra.units.dimension import NONE, Dimension
from rotsolve.algebra.units.quantities import UnitError, parse_quantity
from rotsolve.core.quantity import QUANTITIES
from rotsolve.language.grammar import IS, WHICH
from rotsolve.language.problem import Find, Option, WhichOf
from rotsolve.language.words import hint, nearest_name, quoted
from rotsolve.scene.literals import dimension_in_words
from rotsolve.scene.phrases import read_phrase
from rotsolve.scene.scope import NAME, Scope
from rotsolve.scene.tree import Map, Node, Text

TESTS = ("largest", "smallest", "above", "below")
FORM = "write `{which of: {a: PHRASE, b: PHRASE}, is: largest}` or `{which of: {a: X < Y, b: X = Y}}`"
MOST = 20  # options; each is compared with each
SIGN = re.compile(r"<=|>=|==|[<>=≤≥]")
SIGNS = {"<=": "≤", ">=": "≥", "==": "="}


def read_which_of(scope: Scope, name: str, key: Text, node: Map, answers: dict[str, Any]) -> Find | None:
    """One entry of `find` that is a map: a choice with its options."""
    faults = len(scope.faults)
    if node.key(WHICH) is None and all(nearest_name(word.value, (WHICH,)) is None for word, _ in node.entries):
        return scope.fault(node, f"`{name}` asks for one phrase, or is a map with `{WHICH}`", FORM, "form")
    entries = scope.entries(node, f"`{name}`", (WHICH, IS))
    if WHICH not in entries:
        if len(scope.faults) == faults:
            scope.fault(node, f"`{name}` is a map without `{WHICH}`", FORM, "form")
        return None
    reader = OptionReader(scope, name, answers)
    test = bound = None
    if IS in entries:
        test, bound = reader.test(entries[IS][1])
        if test is None:
            return None
    options = reader.options(entries[WHICH][1], test)
    if len(scope.faults) > faults:
        return None
    if bound is not None:
        reader.same_dimension(entries[IS][1], [*(side for option in options for side in option.sides), bound])
    elif test is not None:
        reader.same_dimension(entries[WHICH][1], [side for option in options for side in option.sides])
    scope.choices.add(name)
    terms = tuple(term for side in reader.read for term in side.terms)
    return Find(name, ZERO, terms, span=key.span, choice=WhichOf(options, test or "", bound))


class OptionReader:
    """Reads the options of one choice; each side of a comparison is a phrase with a name of its own."""

    def __init__(self, scope: Scope, name: str, answers: dict[str, Any]) -> None:
        self.scope = scope
        self.name = name
        self.answers = answers
        self.read: list[Find] = []
        self.dimensions: dict[int, Any] = {}  # of what is read, by identity: sides of one option may share a letter

    def test(self, node: Node) -> tuple[str | None, Find | None]:
        """`largest`, `smallest`, `above X`, `below X`."""
        if not isinstance(node, Text):
            self.scope.fault(node, f"`{IS}` wants one of: {', '.join(TESTS)}", FORM, "form")
            return None, None
        text = node.value.strip()
        word, _, rest = text.partition(" ")
        if word not in TESTS:
            self.scope.fault(node, f"`{IS}: {text}` is no test", hint(word, TESTS, "tests"), "choice")
            return None, None
        bounded = word in ("above", "below")
        if bounded != bool(rest.strip()):
            told = f"`{word}` wants a bound" if bounded else f"nothing can follow `{word}`"
            self.scope.fault(node, told, "write `above 180 deg`" if bounded else "", "choice")
            return None, None
        if not bounded:
            return word, None
        bound = self.side(node, node.value.index(word) + len(word), len(node.value), "")
        return (word, bound) if bound is not None else (None, None)

    def options(self, node: Node, test: str | None) -> tuple[Option, ...]:
        """The options by their labels."""
        found = []
        entries = self.scope.entries(node, f"`{WHICH}`")
        if isinstance(node, Map) and not 2 <= len(node.entries) <= MOST:
            count = len(node.entries)
            self.scope.fault(node, f"a choice has 2 to {MOST} options, but `{self.name}` has {count}", FORM, "form")
        for label, (_, written) in entries.items():
            if not isinstance(written, Text):
                self.scope.fault(written, f"the option {quoted(label)} wants one phrase", FORM, "form")
                continue
            option = self.option(label, written, test)
            if option is not None:
                found.append(option)
        return tuple(found)

    def option(self, label: str, node: Text, test: str | None) -> Option | None:
        """One option: a quantity for a test, else a comparison."""
        before = ((match, node.value[: match.start()]) for match in SIGN.finditer(node.value))
        marks = [match for match, text in before if text.count("(") == text.count(")")]  # outside all brackets
        if test is not None and marks:
            place = node.part(marks[0].start(), marks[0].end())
            self.scope.fault(place, f"with `{IS}: {test}` an option is one quantity", f"leave out `{IS}`", "choice")
            return None
        if test is None and not marks:
            help = f"write `X < Y`, or say `{IS}:` one of {', '.join(TESTS)}"
            return self.scope.fault(node, f"the option {quoted(label)} compares nothing", help, "choice")
        starts = [0, *(match.end() for match in marks)]
        ends = [*(match.start() for match in marks), len(node.value)]
        sides = [self.side(node, start, end, label) for start, end in zip(starts, ends, strict=True)]
        whole = [side for side in sides if side is not None]
        if len(whole) < len(sides):
            return None
        self.same_dimension(node, whole)
        return Option(label, tuple(whole), tuple(SIGNS.get(match[0], match[0]) for match in marks))

    def side(self, node: Text, start: int, end: int, label: str) -> Find | None:
        """One phrase: a part of a text."""
        text = node.value[start:end]
        if not text.strip():
            return self.scope.fault(node, f"a quantity is missing in {quoted(node.value.strip())}", FORM, "find")
        part = node.cut(start, end)
        found = read_phrase(self.scope, self.name, part, part, self.answers)
        if found is None:
            return None
        find, dimension = found
        side = named_side(find, label, len(self.read) + 1)
        self.read.append(side)
        nothing = find.formula == ZERO and not find.terms
        self.dimensions[id(side)] = dimension_of_zero(text) if nothing else dimension
        return side

    def same_dimension(self, node: Node, sides: list[Find]) -> None:
        """What is compared must be of one kind."""
        known = [side for side in sides if self.dimensions[id(side)] is not None]
        for side in known[1:]:
            first, second = (self.dimensions[id(item)] for item in (known[0], side))
            if not first.matches(second):
                message = f"`{known[0].text}` is {dimension_in_words(first)}, but `{side.text}` is {dimension_in_words(second)}"
                self.scope.fault(node, message, "only quantities of one kind can be compared", "dimension")
                return


def dimension_of_zero(text: str) -> Dimension | None:
    """That of its unit, `0 m/s`; None for a bare 0, which is of every kind."""
    try:
        dimension = parse_quantity(text.strip()).dimension
    except UnitError:
        return None
    return None if dimension == NONE else dimension


def named_side(find: Find, label: str, number: int) -> Find:
    """A side under the letter that the derivation may print: ω_b for the angular velocity of option b."""
    letter = QUANTITIES[find.terms[0].path.quantity].letter if len(find.terms) == 1 else find.name
    index = label if NAME.fullmatch(label) else str(number)
    return replace(find, name=f"{letter}_{index}")
