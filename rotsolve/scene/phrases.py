"""Phrases: the small language of `find`.

[modifier] EXPRESSION [about …] [along …] [by integration] [at …] [during …] [from … to …] [where …] [in UNIT]
angle of VECTOR from VECTOR, VECTOR [relative to BODY] [in … axes], in space
period of small swings [of BODY] [about STATE], period of swings [of BODY] from STATE

A modifier and the clauses belong to the whole expression before them; a part in brackets may have its own:
`(lost kinetic_energy during hit)/(kinetic_energy at before)`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

from msgspec import Struct, field
from msgspec.structs import replace

from rotsolve.algebra.formula import Formula, Symbol, call
from rotsolve.algebra.units.dimension import ANGLE, Dimension, DimensionError, dimension_of
from rotsolve.algebra.units.unit_table import Unit
from rotsolve.core.quantity import DIRECTED, QUANTITIES
from rotsolve.language.grammar import ALONE, ANGLE_OF, CLAUSES, DAMPED, MODIFIERS, RATIO_OF, SWINGS, WHICH
from rotsolve.language.problem import EXTREMES, Condition, Find, Path, Term
from rotsolve.language.words import quoted
from rotsolve.scene.clauses import Clauses
from rotsolve.scene.in_space import in_space_only
from rotsolve.scene.literals import Lexeme, Want, dimension_in_words, lexemes, stand_in
from rotsolve.scene.paths import read_path, written_out
from rotsolve.scene.scope import Nothing, Scope
from rotsolve.scene.tree import Node, Text
from rotsolve.scene.values import expression

SIZE_OF_CHANGE = "size of change of"
WITH_OF = ("size", "change", *(word.removesuffix(" of") for word in SWINGS), "which", "angle", "ratio")
WHICH_HELP = "write `{which of: {a: PHRASE, b: PHRASE}, is: largest}`"
HELP = "write `body.quantity at STATE`; see `find` in docs/language.md"


class Phrase(Struct):
    """What has been read of one phrase so far."""

    terms: list[Term] = field(default_factory=list)
    where: Condition | None = None
    unit: Unit | None = None
    outer: str = ""


def read_find(scope: Scope, name: str, key: Text, node: Node, answers: dict[str, Any]) -> Find | None:
    """One entry of `find`."""
    if not isinstance(node, Text):
        return scope.fault(node, f"`{name}` asks for one phrase", HELP, "form")
    if len(node.value) > 1000:
        return scope.fault(node, f"the phrase of `{name}` is too long", "at most 1000 characters", "limit")
    found = read_phrase(scope, name, key, node, answers)
    if found is None:
        return None
    find, answers[name] = found
    return find


def read_phrase(scope: Scope, name: str, key: Text, node: Text, answers: dict[str, Any]) -> tuple[Find, Any] | None:
    """A phrase as a question, with its dimension where that is known."""
    phrase = Phrase()
    faults = len(scope.faults)
    if (single := unpaired(node.value)) is not None:
        message, help = f"`{node.value[single]}` has no other bracket", "each `(` has its `)`"
        return scope.fault(node.part(single, single + 1), message, help, "formula")
    formula = PhraseReader(scope, node, phrase, answers).read(0, len(node.value), True)
    if formula is None or len(scope.faults) > faults:
        return None
    dimension = dimension_found(scope, node, formula, phrase, answers)
    if dimension is None and len(scope.faults) > faults:
        return None
    unit = phrase.unit
    if unit is not None and dimension is not None:
        unit = unit_of_answer(scope, name, node, formula, phrase, dimension)
        if unit is None:
            return None
    text = node.value.strip()
    find = Find(name, formula, tuple(phrase.terms), phrase.outer, phrase.where, unit, text, key.span)
    return find, dimension


def unpaired(text: str) -> int | None:
    """The place of a round bracket that has no other; None where all have."""
    open_: list[int] = []
    for place, letter in enumerate(text):
        if letter == ")" and not open_:
            return place
        open_ = [*open_, place] if letter == "(" else open_[:-1] if letter == ")" else open_
    return open_[-1] if open_ else None


def unit_of_answer(
    scope: Scope, name: str, node: Text, formula: Formula, phrase: Phrase, dimension: Dimension
) -> Unit | None:
    """The unit in which an answer is asked: one that measures it, where Hz counts turns and rad/s measures an angle in a unit of time."""
    unit = phrase.unit
    assert unit is not None
    shown = quoted(unit.text)
    if not dimension.matches(unit.dimension):
        message = f"{shown} doesn't measure this: `{name}` is {dimension_in_words(dimension)}"
        return scope.fault(node, message, "", "dimension")
    if unit.is_hertz and dimension.angle:
        help = "ask for it in rad/s or rev/s; a frequency is ω/(2π)"
        return scope.fault(
            node, f"{shown} counts turns, and `{name}` is {dimension_in_words(dimension)}", help, "dimension"
        )
    if not (unit.dimension.angle and counts_turns(scope, formula, phrase)):
        return unit
    if isinstance(formula, Symbol) and unit.counts_turns:
        return unit.of_turns
    help = "ask for it in Hz or 1/s; ω = 2π f is the angular frequency"
    return scope.fault(
        node, f"{shown} measures an angle in a unit of time, and `{name}` counts turns", help, "dimension"
    )


def counts_turns(scope: Scope, formula: Formula, phrase: Phrase) -> bool:
    """Whether a frequency stands in a formula: that of swings, or a letter that is given in Hz."""
    letters = (scope.givens[name] for name in formula.symbols() if name in scope.givens)
    asked = any(term.path.quantity == "frequency" for term in phrase.terms)
    return asked or any(item.unit is not None and item.unit.is_hertz for item in letters)


def dimension_found(scope: Scope, node: Text, formula: Formula, phrase: Phrase, answers: dict[str, Any]) -> Any:
    """The dimension of the asked formula; None where a letter's is not known."""
    known: dict[str, Any] = {**answers, **scope.dimensions}
    known |= {f"#{index}": dimension_of_term(term) for index, term in enumerate(phrase.terms)}
    found = {name: known.get(name) for name in formula.symbols()}
    if None in found.values():
        return None
    try:
        return dimension_of(formula, found)  # type: ignore[arg-type]
    except DimensionError as error:
        message = error.message
        for index, term in enumerate(phrase.terms):
            message = message.replace(f"#{index}", term.path.quantity)
        return scope.fault(node, f"the dimensions in {quoted(node.value)} don't agree: {message}", kind="dimension")


def dimension_of_term(term: Term) -> Dimension:
    """The dimension of what a term asks for: of two vectors that of an angle."""
    return ANGLE if term.modifier == ANGLE_OF else QUANTITIES[term.path.quantity].dimension


class PhraseReader:
    """Reads a phrase or a bracketed part of one; the terms of all parts are numbered through."""

    def __init__(self, scope: Scope, node: Text, phrase: Phrase, answers: dict[str, Any]) -> None:
        self.scope = scope
        self.node = node
        self.phrase = phrase
        self.answers = answers

    def read(self, start: int, end: int, outer: bool) -> Formula | None:
        """The formula of text[start:end], its clauses given to the terms of its own."""
        words = [piece for piece in self.pieces(start, end) if piece.kind != "space"]
        if not words:
            return self.scope.fault(self.node.part(start, end), "nothing is asked here", HELP, "find")
        return self.quantity(words, outer)

    def quantity(self, words: list[Lexeme], outer: bool) -> Formula | None:
        """[modifier] EXPRESSION [clauses], given in pieces."""
        given = words
        modifier, words = self.modifier(words)
        if modifier is None:
            return None
        if modifier in (*SWINGS, RATIO_OF):
            return self.swings(modifier, words, outer)
        if modifier == ANGLE_OF:
            return self.angle(words, outer)
        cut = next((index for index, piece in at_top(words) if piece.text in CLAUSES), len(words))
        if cut == 0:
            place = words[0] if words else given[-1]
            return self.scope.fault(self.node.part(place.start, place.end), "a quantity is missing here", HELP, "find")
        change = self.scope.space and modifier == "size of" and [piece.text for piece in words[:2]] == ["change", "of"]
        if change:  # the size of a change, which is a vector too
            modifier, words, cut = SIZE_OF_CHANGE, words[2:], cut - 2
        sized = outer and modifier in EXTREMES and [piece.text for piece in words[:2]] == ["size", "of"]
        if sized:  # the largest size of a vector
            words, cut = words[2:], cut - 2
        first = len(self.phrase.terms)
        clauses = Clauses(self.scope, self.node, outer, self.condition)
        if not clauses.read(words[cut:]):
            return None
        formula = self.formula(words[0].start, words[cut - 1].end)
        if formula is None:
            return None
        self.phrase.where = clauses.where or self.phrase.where
        self.phrase.unit = clauses.unit or self.phrase.unit
        clauses.check(self.phrase.terms[first:], modifier)
        self.phrase.terms[first:] = map(clauses.applied, self.phrase.terms[first:])
        if sized and (whole := self.modified(formula, "size of", first, False, words[0])) is not None:
            self.phrase.outer = modifier
            return whole
        return self.modified(formula, modifier, first, outer, words[0])

    def condition(self, part: Text) -> Condition | None:
        """What follows `where`; the phrase that it speaks of is read like any other."""
        phrase = Phrase()
        reader = PhraseReader(self.scope, part, phrase, self.answers)

        def quantity(words: list[Lexeme]) -> tuple[Find, Any] | None:
            formula = reader.quantity(words, False)
            if formula is None:
                return None
            text = part.value[words[0].start : words[-1].end]
            dimension = dimension_found(self.scope, part, formula, phrase, self.answers)
            return Find("", formula, tuple(phrase.terms), text=text, span=part.span), dimension

        from rotsolve.scene.conditions import read_condition

        return read_condition(self.scope, part, quantity, self.answers)

    def swings(self, modifier: str, words: list[Lexeme], outer: bool) -> Formula | None:
        """`small swings of BODY about STATE`, `swings from STATE`, as a term of its own."""
        if modifier in DAMPED and self.scope.space:
            place = self.node.part(words[0].start, words[-1].end)
            return self.scope.fault(place, "damped swings are solved in the plane only", "leave out `up: z`", "find")
        if modifier == RATIO_OF or (words and words[0].text == "mode"):
            from rotsolve.scene.modes import read_mode

            found = read_mode(self.scope, self.node, words, modifier)
        else:
            found = read_swings(self.scope, self.node, words, modifier)
        if found is None:
            return None
        term, rest = found
        clauses = Clauses(self.scope, self.node, outer, self.condition)
        if rest and not (outer and rest[0].text == "in" and clauses.read(rest)):
            return trailing(self.scope, self.node, rest)
        self.phrase.unit = clauses.unit or self.phrase.unit
        self.phrase.terms.append(term)
        return Symbol(f"#{len(self.phrase.terms) - 1}")

    def angle(self, words: list[Lexeme], outer: bool) -> Formula | None:
        """`angle of A from B`, two vectors, as one term; clauses after them are said of both."""
        place = next((index for index, piece in at_top(words) if piece.text == "from"), 0)
        if not 0 < place < len(words) - 1:
            span = self.node.part(words[0].start, words[-1].end)
            return self.scope.fault(span, "an angle is of one vector from another", "write `angle of A from B`", "find")
        end = next((k for k, piece in at_top(words) if k > place and piece.text in CLAUSES), len(words))
        clauses = Clauses(self.scope, self.node, outer, self.condition)
        if not clauses.read(words[end:]):
            return None
        terms: list[Term] = []
        for part in (words[:place], words[place + 1 : end]):
            reader = PhraseReader(self.scope, self.node, Phrase(), self.answers)
            found = reader.quantity(part, False)
            if found is None:
                return None
            if found != Symbol("#0") or reader.phrase.terms[0].path.quantity not in DIRECTED:
                span = self.node.part(part[0].start, part[-1].end)
                name = self.node.value[part[0].start : part[-1].end]
                message, help = "an angle is between vectors", "write `angle of A from B`, A and B paths of vectors"
                if name in self.answers:
                    help = f"write what `{name}` asks for in place of its name"
                return self.scope.fault(span, message, help, "find")
            terms += map(clauses.applied, reader.phrase.terms)
        self.phrase.unit = clauses.unit or self.phrase.unit
        self.phrase.terms.append(replace(terms[0], modifier=ANGLE_OF, other=terms[1]))
        return Symbol(f"#{len(self.phrase.terms) - 1}")

    def modifier(self, words: list[Lexeme]) -> tuple[str | None, list[Lexeme]]:
        """The modifier in front and the rest; None after a fault."""
        first = words[0].text
        if len(words) > 1 and words[1].text == "of":
            modifier, place = f"{first} of", self.node.part(words[0].start, words[1].end)
            if modifier == WHICH:
                self.scope.fault(place, f"`{WHICH}` stands before a map of options", WHICH_HELP, "find")
            elif modifier == ANGLE_OF and not self.scope.space:
                in_space_only(self.scope, place, modifier)
            elif first in WITH_OF:
                return modifier, words[2:]
            else:
                help = f"modifiers: {', '.join(MODIFIERS)}"
                if first in QUANTITIES:
                    help = written_out(self.scope, first, [piece.text for piece in words[2:]])
                self.scope.fault(place, f"unknown modifier `{first} of`", help, "unknown")
            return None, words
        if first in ALONE and len(words) > 1 and words[1].kind in ("name", "path", "mark", "quantity", "number"):
            return first, words[1:]
        return "", words

    def modified(self, formula: Formula, modifier: str, first: int, outer: bool, place: Lexeme) -> Formula | None:
        """The modifier goes to the only term, or to the whole."""
        if not modifier:
            return formula
        if modifier == "size of" and self.scope.space and len(self.phrase.terms) > first + 1:
            from rotsolve.space.entries import size_of_sum

            found = size_of_sum(formula, self.phrase.terms[first:], first)
            if found is not None:
                whole, self.phrase.terms[first:] = found
                return whole
        if formula == Symbol(f"#{first}") and len(self.phrase.terms) == first + 1:
            inner = self.phrase.terms[first].modifier
            if inner:  # one of a quantity that has one already: none is dropped
                span = self.node.part(place.start, place.end)
                message = f"`{modifier}` in front of `{inner}` is not solved"
                help = f"ask for `{inner}` in a line of its own, and speak of that by its name"
                return self.scope.fault(span, message, help, "find")
            self.phrase.terms[first] = replace(self.phrase.terms[first], modifier=modifier)
            return formula
        if outer:
            self.phrase.outer = modifier
            return formula
        if modifier == "size of":
            return call("abs", formula)
        span = self.node.part(place.start, place.end)
        message = f"`{modifier}` in brackets takes one quantity"
        return self.scope.fault(span, message, "ask for it in a line of its own", "find")

    def formula(self, start: int, end: int) -> Formula | None:
        """The expression text[start:end]: bracketed phrases first, then paths and givens."""
        text = self.node.value
        inner: dict[str, Formula] = {}
        built, position = "", start
        for opening, closing in self.groups(start, end):
            part = self.read(opening + 1, closing, False)
            if part is None:
                return None
            called = bool(
                re.search(r"\w\s*$", text[position:opening])
            )  # the brackets of a function stay: sin(touch.angle at off)
            first, last = (opening + 1, closing) if called else (opening, closing + 1)
            name = stand_in(90 + len(inner), last - first)
            inner[name] = part
            built += text[position:first] + name
            position = last
        built += text[position:end]
        node = Text(built, self.node.part(start, end), True, self.node.exact)
        earlier = {name: dimension for name, dimension in self.answers.items() if name not in self.scope.choices}
        names: dict[str, Any] = {**earlier, **dict.fromkeys(inner)}
        found = expression(self.scope, node, Want("find", letter="x", owner="", extra=names, words=CLAUSES), self.term)
        return None if found is None else found.substitute(inner)

    def groups(self, start: int, end: int) -> list[tuple[int, int]]:
        """The outermost brackets that hold a phrase: a modifier or a clause word."""
        result: list[tuple[int, int]] = []
        stack: list[int] = []
        speaks = -1
        for piece in self.pieces(start, end):
            if piece.text == "(":
                stack.append(piece.start)
            elif piece.text == ")" and stack:
                opening = stack.pop()
                if speaks >= 0 and opening < speaks:
                    result = [group for group in result if group[0] < opening] + [(opening, piece.start)]
                    speaks = -1 if not stack else speaks
            elif stack and piece.kind == "name" and piece.text in (*CLAUSES, *ALONE, "of"):
                speaks = piece.start
        return [group for group in result if not any(other[0] < group[0] and group[1] < other[1] for other in result)]

    def pieces(self, start: int, end: int) -> Iterator[Lexeme]:
        """The pieces of text[start:end] at their places in the whole."""
        for piece in lexemes(self.node.value[start:end], self.scope.givens):
            yield replace(piece, start=piece.start + start, end=piece.end + start)

    def term(self, node: Text, piece: Lexeme) -> Formula | None:
        path = read_path(self.scope, node, piece.start, piece.end)
        if path is None:
            return None
        self.phrase.terms.append(Term(path))
        return Symbol(f"#{len(self.phrase.terms) - 1}")


def at_top(words: list[Lexeme]) -> list[tuple[int, Lexeme]]:
    """The pieces outside all brackets, with their index."""
    depth, result = 0, []
    for index, piece in enumerate(words):
        depth += {"(": 1, ")": -1}.get(piece.text, 0)
        if depth <= 0 and piece.kind == "name":
            result.append((index, piece))
    return result


SMALL, LARGE = "small swings", "swings"
FORM = "write `period of small swings`, with `of BODY` and `about STATE` where there are several, or `period of swings from STATE`"


def read_swings(scope: Scope, node: Text, words: list[Lexeme], modifier: str) -> tuple[Term, list[Lexeme]] | None:
    """What follows `period of`, and the words after that.

    The term's modifier says which swings, `at` about which state, `start` from which.
    """
    kind = SMALL if words and words[0].text == "small" else LARGE
    rest = words[1:] if kind == SMALL else words
    if not rest or rest[0].text != "swings":
        place = node.part(words[0].start, words[-1].end) if words else node.span
        asked = node.value[words[0].start : words[-1].end] if words else ""
        return scope.fault(place, f"{quoted(f'{modifier} {asked}'.strip())} is not known", FORM, "find")
    span, found, rest = node.part(words[0].start, rest[0].end), {"of": "", "about": "", "from": ""}, rest[1:]
    left = clauses_of_swings(scope, node, rest, found, FORM)
    if left is None:
        return None
    rest = left
    if (kind == SMALL and found["from"]) or (kind == LARGE and (found["about"] or not found["from"])):
        return scope.fault(span, "small swings are `about` a state, other ones `from` one", FORM, "find")
    path = Path(found["of"], SWINGS[modifier], span=span)
    return Term(path, kind, at=found["about"] or None, start=found["from"] or None), rest


def clauses_of_swings(
    scope: Scope, node: Text, rest: list[Lexeme], found: dict[str, str], form: str
) -> list[Lexeme] | None:
    """The names behind `of`, `about` and `from`, put into those `found`, and the words after them; None after a fault."""
    while rest and rest[0].text in found:
        if len(rest) < 2:
            return scope.fault(node.part(rest[0].start, rest[0].end), f"nothing follows `{rest[0].text}`", form, "find")
        name = name_after(scope, node, rest[1], "body" if rest[0].text == "of" else "state")
        if name is None:
            return None
        found[rest[0].text], rest = name, rest[2:]
    return rest


def trailing(scope: Scope, node: Text, rest: list[Lexeme]) -> Nothing:
    """A fault for words that can't follow."""
    place = node.part(rest[0].start, rest[-1].end)
    what = quoted(node.value[rest[0].start : rest[-1].end])
    help = "to reckon with it put it in brackets: `(period of small swings)/2`"
    return scope.fault(place, f"{what} can't follow here", help, "find")


def name_after(scope: Scope, node: Text, word: Lexeme, kind: str) -> str | None:
    """The name of a body or state; None after a fault."""
    if scope.kinds.get(word.text) == kind:
        return word.text
    plural = "bodies" if kind == "body" else "states"
    return scope.unknown(node.part(word.start, word.end), word.text, kind, scope.names(kind), plural)


def swings_said(text: str) -> bool:
    """Whether a line of a state speaks of swings: `period of small swings: 2 s`."""
    return any(text.startswith(f"{modifier} ") for modifier in SWINGS)


def swings_path(scope: Scope, line: Text) -> Path | None:
    """The period or frequency of small swings that a line of a state gives; None after a fault."""
    words = [piece for piece in lexemes(line.value, scope.givens) if piece.kind != "space"]
    modifier = f"{words[0].text} {words[1].text}"
    found = read_swings(scope, line, words[2:], modifier)
    if found is None:
        return None
    term, rest = found
    if rest:
        return trailing(scope, line, rest)
    if term.modifier == SMALL and term.at is None:
        return term.path
    help = f"write `{modifier} small swings: …`"
    return scope.fault(line, "a state tells the period of small swings about itself", help, "find")
