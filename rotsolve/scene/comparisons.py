"""Comparisons in questions: conditions after `where`, and choices, `which of` several quantities or conditions.

`base sticks`, `upright is stable`, `Q is largest`, `pin.impulse.x = 0 during hit`;
`{which of: {a: PHRASE, b: PHRASE}, is: largest | smallest | above X | below X}`, `{which of: {label: X < Y < Z, other: X = Y}}`.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO
from rotsolve.algebra.units.dimension import word_of
from rotsolve.core.quantity import QUANTITIES
from rotsolve.language.grammar import CLAUSES, IS, WHICH
from rotsolve.language.problem import Condition, Find, Option, Path, WhichOf
from rotsolve.language.words import hint, quoted
from rotsolve.scene.literals import Lexeme, Want, dimension_in_words, lexemes
from rotsolve.scene.phrases import read_phrase
from rotsolve.scene.scope import NAME, Scope
from rotsolve.scene.states import EXTREMES
from rotsolve.scene.tree import Map, Node, Text
from rotsolve.scene.values import read_scalar

FORMS = "write `contact sticks`, `state is stable`, `path is smallest` or `path = value`"
Quantity = Callable[[list[Lexeme]], "tuple[Find, Any] | None"]  # reads a phrase: it, and its dimension


def read_condition(scope: Scope, part: Text, quantity: Quantity) -> Condition | None:
    """The condition that `part` writes; None after a fault."""
    words = [piece for piece in lexemes(part.value, scope.givens) if piece.kind != "space"]
    texts = [piece.text for piece in words]
    if len(words) in (2, 3) and scope.kinds.get(texts[0]) == "connection" and (len(words) == 2 or texts[1] == "is"):
        return contact_word(scope, part, texts)
    if texts[1:] == ["is", "stable"] and scope.kinds.get(texts[0]) == "state":
        return Condition(Path("", "swing_period"), word="stable", owner=texts[0], span=part.span)
    if "=" in texts:
        return equality(scope, part, words, texts.index("="), quantity)
    place = next((k for k, text in enumerate(texts[:-1]) if text == "is" and texts[k + 1] in EXTREMES), 0)
    if place:
        found = quantity([*words[:place], *words[place + 2 :]])
        return None if found is None else Condition(None, word=texts[place + 1], span=part.span, phrase=found[0])
    scope.fault(part, f"{quoted(part.value)} is no condition", FORMS, "find")
    return None


def contact_word(scope: Scope, part: Text, texts: list[str]) -> Condition | None:
    """`base sticks`, `rope is slack`."""
    owner, word = texts[0], texts[-1]
    allowed: tuple[str, ...] = getattr(scope.elements.get(owner), "words", ())
    if word in allowed:
        return Condition(Path(owner, "", span=part.span), word=word, owner=owner, span=part.span)
    able = [name for name, item in scope.elements.items() if getattr(item, "words", ())]
    help = hint(word, allowed, "it can be") if allowed else f"of what sticks, slips or goes slack: {', '.join(able)}"
    if not able:
        help = "only contacts, clutches and strings can: `contact: [block, floor]`"
    scope.fault(part, f"`{owner}` can't be {quoted(word)}", help, "choice")
    return None


def equality(scope: Scope, part: Text, words: list[Lexeme], sign: int, quantity: Quantity) -> Condition | None:
    """`path = value [clauses]` or `path = path [clauses]`; the clauses belong to the paths."""
    end = next((k for k in range(sign, len(words)) if words[k].kind == "name" and words[k].text in CLAUSES), len(words))
    if sign == 0 or end == sign + 1:
        scope.fault(part, f"{quoted(part.value)} is no condition", FORMS, "find")
        return None
    read = quantity([*words[:sign], *words[end:]])
    if read is None:
        return None
    find, dimension = read
    if any(piece.kind == "path" for piece in words[sign + 1 : end]):
        other = quantity([*words[sign + 1 : end], *words[end:]])
        if other is None or not same_kind(scope, part, dimension, other[1]):
            return None
        both = replace(find, formula=find.formula - other[0].formula, terms=other[0].terms)
        return Condition(None, ZERO, span=part.span, phrase=both)
    start, stop = words[sign + 1].start, words[end - 1].end
    right = part.cut(start, stop)
    word = word_of(dimension)
    owner = find.terms[0].path.owner if find.terms else ""
    found = read_scalar(scope, right, Want(part.value[: words[sign - 1].end], word, "x", owner))
    return None if found is None else Condition(None, found, span=part.span, phrase=find)


def same_kind(scope: Scope, part: Text, left: Any, right: Any) -> bool:
    """Whether both sides of an equality may be equal, as far as their dimensions are known."""
    if left is None or right is None or left.matches(right):
        return True
    scope.fault(
        part,
        f"the sides of {quoted(part.value)} don't agree: {dimension_in_words(left)} and {dimension_in_words(right)}",
        kind="dimension",
    )
    return False


TESTS = ("largest", "smallest", "above", "below")
FORM = "write `{which of: {a: PHRASE, b: PHRASE}, is: largest}` or `{which of: {a: X < Y, b: X = Y}}`"
MOST = 20  # options; each is compared with each
SIGN = re.compile(r"<=|>=|==|[<>=≤≥]")
SIGNS = {"<=": "≤", ">=": "≥", "==": "="}


def read_which_of(scope: Scope, name: str, key: Text, node: Map, answers: dict[str, Any]) -> Find | None:
    """One entry of `find` that is a map: a choice with its options."""
    faults = len(scope.faults)
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
        self.dimensions: dict[str, Any] = {}

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
        marks = [match for match in SIGN.finditer(node.value) if outside_brackets(node.value, match.start())]
        if test is not None and marks:
            place = node.part(marks[0].start(), marks[0].end())
            self.scope.fault(place, f"with `{IS}: {test}` an option is one quantity", f"leave out `{IS}`", "choice")
            return None
        if test is None and not marks:
            help = f"write `X < Y`, or say `{IS}:` one of {', '.join(TESTS)}"
            self.scope.fault(node, f"the option {quoted(label)} compares nothing", help, "choice")
            return None
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
            self.scope.fault(node, f"a quantity is missing in {quoted(node.value.strip())}", FORM, "find")
            return None
        part = node.cut(start, end)
        found = read_phrase(self.scope, self.name, part, part, self.answers)
        if found is None:
            return None
        find, dimension = found
        side = named_side(find, label, len(self.read) + 1)
        self.read.append(side)
        self.dimensions[side.name] = dimension
        return side

    def same_dimension(self, node: Node, sides: list[Find]) -> None:
        """What is compared must be of one kind."""
        known = [side for side in sides if self.dimensions[side.name] is not None]
        for side in known[1:]:
            first, second = (self.dimensions[item.name] for item in (known[0], side))
            if not first.matches(second):
                message = f"`{known[0].text}` is {dimension_in_words(first)}, but `{side.text}` is {dimension_in_words(second)}"
                self.scope.fault(node, message, "only quantities of one kind can be compared", "dimension")
                return


def named_side(find: Find, label: str, number: int) -> Find:
    """A side under the letter that the derivation may print: ω_b for the angular velocity of option b."""
    letter = QUANTITIES[find.terms[0].path.quantity].letter if len(find.terms) == 1 else find.name
    index = label if NAME.fullmatch(label) else str(number)
    return replace(find, name=f"{letter}_{index}")


def outside_brackets(text: str, position: int) -> bool:
    """Whether a place in a text is outside all brackets."""
    before = text[:position]
    return before.count("(") == before.count(")")
