"""Phrases: the small language of `find`.

[modifier] EXPRESSION [on …] [about …] [along …] [by integration] [at …] [during …] [from … to …] [where …] [in UNIT]

A modifier and the clauses belong to the whole expression before them; a part in brackets may have its own:
`(lost kinetic_energy during hit)/(kinetic_energy at before)`.
"""

from __future__ import annotations

from typing import Any

from msgspec import Struct, field
from msgspec.structs import replace

from rotsolve.algebra.formula import Formula, Symbol, call
from rotsolve.algebra.units.dimension import DimensionError, dimension_of
from rotsolve.algebra.units.unit_table import Unit
from rotsolve.core.quantity import BY_WORD
from rotsolve.language.problem import Condition, Find, Term
from rotsolve.language.words import quoted
from rotsolve.scene.phrase.clauses import CLAUSES, Clauses
from rotsolve.scene.phrase.paths import read_path
from rotsolve.scene.phrase.swings import SWINGS, read_swings, trailing
from rotsolve.scene.tree.nodes import Node, Text
from rotsolve.scene.values.dims import fits, named
from rotsolve.scene.values.expressions import expression
from rotsolve.scene.values.literals import Want
from rotsolve.scene.values.pieces import Piece, pieces, stand_in
from rotsolve.scene.values.scope import Scope

WITH_OF = ("size", "change", "period", "frequency", "angular_frequency", "which", "angle")
ALONE = ("lost", "total", "mean", "largest", "smallest")
LATER = ("angle of",)
WHICH = "which of"
WHICH_HELP = "write `{which of: {a: PHRASE, b: PHRASE}, is: largest}`"
MODIFIERS = ("size of", "change of", *ALONE, *SWINGS, *LATER, WHICH)
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
        scope.fault(node, f"`{name}` asks for one phrase", HELP, "form")
        return None
    if len(node.value) > 1000:
        scope.fault(node, f"the phrase of `{name}` is too long", "at most 1000 characters", "limit")
        return None
    found = read_phrase(scope, name, key, node, answers)
    if found is None:
        return None
    find, answers[name] = found
    return find


def read_phrase(scope: Scope, name: str, key: Text, node: Text, answers: dict[str, Any]) -> tuple[Find, Any] | None:
    """A phrase as a question, with its dimension where that is known."""
    phrase = Phrase()
    faults = len(scope.faults)
    formula = Reader(scope, node, phrase, answers).read(0, len(node.value), True)
    if formula is None or len(scope.faults) > faults:
        return None
    dimension = dimension_found(scope, node, formula, phrase, answers)
    if dimension is None and len(scope.faults) > faults:
        return None
    if phrase.unit and dimension is not None and not fits(dimension, phrase.unit.dimension):
        message = f"{quoted(phrase.unit.text)} doesn't measure this: `{name}` is {named(dimension)}"
        scope.fault(node, message, "", "dimension")
        return None
    text = node.value.strip()
    find = Find(name, formula, tuple(phrase.terms), phrase.outer, phrase.where, phrase.unit, text, key.span)
    return find, dimension


def dimension_found(scope: Scope, node: Text, formula: Formula, phrase: Phrase, answers: dict[str, Any]) -> Any:
    """The dimension of the asked formula; None where a letter's is not known."""
    known: dict[str, Any] = {**answers, **scope.dimensions}
    known |= {f"#{index}": BY_WORD[term.path.quantity].dimension for index, term in enumerate(phrase.terms)}
    found = {name: known.get(name) for name in formula.symbols()}
    if None in found.values():
        return None
    try:
        return dimension_of(formula, found)  # type: ignore[arg-type]
    except DimensionError as error:
        message = error.message
        for index, term in enumerate(phrase.terms):
            message = message.replace(f"#{index}", term.path.quantity)
        scope.fault(node, f"the dimensions in {quoted(node.value)} don't agree: {message}", kind="dimension")
        return None


class Reader:
    """Reads a phrase or a bracketed part of one; the terms of all parts are numbered through."""

    def __init__(self, scope: Scope, node: Text, phrase: Phrase, answers: dict[str, Any]) -> None:
        self.scope = scope
        self.node = node
        self.phrase = phrase
        self.answers = answers

    def read(self, start: int, end: int, outer: bool) -> Formula | None:
        """The formula of text[start:end], its clauses given to the terms of its own."""
        found = [shifted(piece, start) for piece in pieces(self.node.value[start:end], self.scope.givens)]
        words = [piece for piece in found if piece.kind != "space"]
        if not words:
            self.scope.fault(self.node.part(start, end), "nothing is asked here", HELP, "find")
            return None
        return self.quantity(words, outer)

    def quantity(self, words: list[Piece], outer: bool) -> Formula | None:
        """[modifier] EXPRESSION [clauses], given in pieces."""
        given = words
        modifier, words = self.modifier(words)
        if modifier is None:
            return None
        if modifier in SWINGS:
            return self.swings(modifier, words, outer)
        cut = next((index for index, piece in at_top(words) if piece.text in CLAUSES), len(words))
        if cut == 0:
            place = words[0] if words else given[-1]
            self.scope.fault(self.node.part(place.start, place.end), "a quantity is missing here", HELP, "find")
            return None
        first = len(self.phrase.terms)
        clauses = Clauses(self.scope, self.node, outer, self.condition)
        if not clauses.read(words[cut:]):
            return None
        formula = self.formula(words[0].start, words[cut - 1].end)
        if formula is None:
            return None
        self.phrase.where = clauses.where or self.phrase.where
        self.phrase.unit = clauses.unit or self.phrase.unit
        own = range(first, len(self.phrase.terms))
        for index in own:
            self.phrase.terms[index] = clauses.applied(self.phrase.terms[index])
        return self.modified(formula, modifier, first, outer, words[0])

    def condition(self, part: Text) -> Condition | None:
        """What follows `where`; the phrase that it speaks of is read like any other."""
        phrase = Phrase()
        reader = Reader(self.scope, part, phrase, self.answers)

        def quantity(words: list[Piece]) -> tuple[Find, Any] | None:
            formula = reader.quantity(words, False)
            if formula is None:
                return None
            text = part.value[words[0].start : words[-1].end]
            dimension = dimension_found(self.scope, part, formula, phrase, self.answers)
            return Find("", formula, tuple(phrase.terms), text=text, span=part.span), dimension

        from rotsolve.scene.phrase.conditions import read_condition

        return read_condition(self.scope, part, quantity)

    def swings(self, modifier: str, words: list[Piece], outer: bool) -> Formula | None:
        """`small swings of BODY about STATE`, `swings from STATE`, as a term of its own."""
        found = read_swings(self.scope, self.node, words, modifier)
        if found is None:
            return None
        term, rest = found
        clauses = Clauses(self.scope, self.node, outer, self.condition)
        if rest and not (outer and rest[0].text == "in" and clauses.read(rest)):
            trailing(self.scope, self.node, rest)
            return None
        self.phrase.unit = clauses.unit or self.phrase.unit
        self.phrase.terms.append(term)
        return Symbol(f"#{len(self.phrase.terms) - 1}")

    def modifier(self, words: list[Piece]) -> tuple[str | None, list[Piece]]:
        """The modifier in front and the rest; None after a fault."""
        first = words[0].text
        if len(words) > 1 and words[1].text == "of":
            if first in WITH_OF:
                modifier = f"{first} of"
                if modifier == WHICH:
                    place = self.node.part(words[0].start, words[1].end)
                    self.scope.fault(place, f"`{WHICH}` stands before a map of options", WHICH_HELP, "find")
                    return None, words
                if modifier in LATER:
                    self.scope.later(self.node.part(words[0].start, words[1].end), modifier)
                    return None, words
                return modifier, words[2:]
            span = self.node.part(words[0].start, words[1].end)
            help = f"modifiers: {', '.join(MODIFIERS)}"
            if first in BY_WORD and len(words) > 2:
                help = f"write `{words[2].text}.{first}`"
            self.scope.fault(span, f"unknown modifier `{first} of`", help, "unknown")
            return None, words
        if first in ALONE and len(words) > 1 and words[1].kind in ("name", "path", "mark", "quantity", "number"):
            return first, words[1:]
        return "", words

    def modified(self, formula: Formula, modifier: str, first: int, outer: bool, place: Piece) -> Formula | None:
        """The modifier goes to the only term, or to the whole."""
        if not modifier:
            return formula
        single = formula == Symbol(f"#{first}") and len(self.phrase.terms) == first + 1
        if single:
            self.phrase.terms[first] = replace(self.phrase.terms[first], modifier=modifier)
            return formula
        if outer:
            self.phrase.outer = modifier
            return formula
        if modifier == "size of":
            return call("abs", formula)
        span = self.node.part(place.start, place.end)
        self.scope.fault(
            span, f"`{modifier}` in brackets takes one quantity", "ask for it in a line of its own", "find"
        )
        return None

    def formula(self, start: int, end: int) -> Formula | None:
        """The expression text[start:end]: bracketed phrases first, then paths and givens."""
        text = self.node.value
        inner: dict[str, Formula] = {}
        built, position = "", start
        for opening, closing in self.groups(start, end):
            part = self.read(opening + 1, closing, False)
            if part is None:
                return None
            name = stand_in(90 + len(inner), closing + 1 - opening)
            inner[name] = part
            built += text[position:opening] + name
            position = closing + 1
        built += text[position:end]
        node = Text(built, self.node.part(start, end), True, self.node.exact)
        earlier = {name: dimension for name, dimension in self.answers.items() if name not in self.scope.choices}
        names: dict[str, Any] = {**earlier, **dict.fromkeys(inner)}
        found = expression(self.scope, node, Want("find", letter="x", owner="", extra=names, words=CLAUSES), self.term)
        return None if found is None else found.substitute(inner)

    def groups(self, start: int, end: int) -> list[tuple[int, int]]:
        """The outermost brackets that hold a phrase: a modifier or a clause word."""
        found = [shifted(piece, start) for piece in pieces(self.node.value[start:end], self.scope.givens)]
        result: list[tuple[int, int]] = []
        stack: list[int] = []
        speaks = -1
        for piece in found:
            if piece.text == "(":
                stack.append(piece.start)
            elif piece.text == ")" and stack:
                opening = stack.pop()
                if speaks >= 0 and opening < speaks:
                    result = [group for group in result if group[0] < opening] + [(opening, piece.start)]
                    speaks = -1 if not stack else speaks
            elif (
                stack and piece.kind == "name" and (piece.text in CLAUSES or piece.text in ALONE or piece.text == "of")
            ):
                speaks = piece.start
        return innermost(result)

    def term(self, node: Text, piece: Piece) -> Formula | None:
        path = read_path(self.scope, node, piece.start, piece.end)
        if path is None:
            return None
        self.phrase.terms.append(Term(path))
        return Symbol(f"#{len(self.phrase.terms) - 1}")


def innermost(groups: list[tuple[int, int]]) -> list[tuple[int, int]]:
    """Groups without those that lie in another one."""
    return [group for group in groups if not any(other[0] < group[0] and group[1] < other[1] for other in groups)]


def shifted(piece: Piece, by: int) -> Piece:
    return replace(piece, start=piece.start + by, end=piece.end + by)


def at_top(words: list[Piece]) -> list[tuple[int, Piece]]:
    """The pieces outside all brackets, with their index."""
    depth, result = 0, []
    for index, piece in enumerate(words):
        depth += {"(": 1, ")": -1}.get(piece.text, 0)
        if depth <= 0 and piece.kind == "name":
            result.append((index, piece))
    return result
