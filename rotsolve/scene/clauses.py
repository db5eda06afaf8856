"""Clauses: what follows an expression in a `find` phrase: `at`, `during`, `from … to`, `about`, `along`, `by`, `where`, `in`;
in space `relative to` and `in … axes`."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from msgspec.structs import replace

from rotsolve.algebra.formula import Formula
from rotsolve.algebra.units.quantities import UnitError, parse_unit
from rotsolve.algebra.units.unit_table import Unit
from rotsolve.language.grammar import CLAUSES, NAMED_AXES, SAID_OF
from rotsolve.language.problem import ANY_TIME, Condition, Path, PointRef, Term
from rotsolve.language.words import an, did_you_mean, hint, quoted
from rotsolve.scene.in_space import WORDS, in_space_only, read_way
from rotsolve.scene.literals import Lexeme, Want
from rotsolve.scene.paths import read_path, read_point
from rotsolve.scene.scope import Scope
from rotsolve.scene.tree import List, Text
from rotsolve.scene.values import read_scalar

DIRECTIONS = ("right", "left", "up", "down", "x", "y", "z", "tangential", "normal")
METHODS = ("integration",)
MEANT_BY = ("rotation", "displacement")  # by what a mean may be taken, beside the time


class Clauses:
    """The clauses of one phrase, checked; `applied` puts them into a term. `condition` reads what follows `where`."""

    def __init__(self, scope: Scope, node: Text, outer: bool, condition: Callable[[Text], Condition | None]) -> None:
        self.scope = scope
        self.node = node
        self.outer = outer
        self.condition = condition
        self.words: dict[str, Any] = {}
        self.places: dict[str, Text] = {}
        self.where: Condition | None = None
        self.unit: Unit | None = None

    def read(self, words: list[Lexeme]) -> bool:
        """Read all clauses; False after a fault."""
        faults = len(self.scope.faults)
        index = 0
        while index < len(words):
            word = words[index]
            seen_from = word.text == "relative" and len(words) > index + 1 and words[index + 1].text == "to"
            end = index + 1 + seen_from
            while end < len(words) and not self.ends(words, end, index):
                end += 1
            self.clause(word, words[index + 1 + seen_from : end])
            index = end
        if ("start" in self.words) != ("end" in self.words):
            self.scope.fault(self.node, "`from` and `to` belong together", "write `from A to B`", "find")
        self.check_order()
        return len(self.scope.faults) == faults

    def ends(self, words: list[Lexeme], place: int, first: int) -> bool:
        """Whether the clause that begins at `first` ends before a word: all that follows `where` is of its condition, in which axes one
        with `=` looks too, but for the unit of the answer."""
        piece = words[place]
        if words[first].text != "where":
            return piece.text in CLAUSES and piece.kind == "name"
        equal = any(word.text == "=" for word in words[first:])
        in_axes = equal and [word.text for word in words[place + 2 : place + 3]] == ["axes"]
        return piece.text == "in" and not in_axes

    def check_order(self) -> None:
        """`from A to B` leads to a later state."""
        names, start, end = self.scope.names("state"), self.words.get("start"), self.words.get("end")
        if start in names and end in names and names.index(start) >= names.index(end):
            help = f"states follow each other as they are written: {', '.join(names)}"
            message, here = f"`{end}` is no later state than `{start}`", self.scope.given_at(end, start)
            self.scope.fault(self.places["start"], message, help, "find", related=here)

    def clause(self, word: Lexeme, rest: list[Lexeme]) -> None:
        span = self.node.part(word.start, word.end)
        key = {"from": "start", "to": "end"}.get(word.text, word.text)
        if not rest:
            self.scope.fault(span, f"nothing follows `{word.text}`", "", "find")
        elif (word.text == "relative" or rest[-1].text == "axes") and not self.scope.space:
            in_space_only(self.scope, span, "relative to" if word.text == "relative" else f"in {rest[0].text} axes")
        elif word.text == "in" and rest[-1].text == "axes":
            self.words["axes"] = self.read_axes(self.node.cut(rest[0].start, rest[0].end))
        elif not self.outer and word.text in ("where", "in"):
            self.scope.fault(span, f"`{word.text}` can't stand in brackets", "put it at the end", "find")
        elif key in self.words:
            self.scope.fault(span, f"`{word.text}` stands twice", "", "find")
        else:
            self.places[key] = self.node.cut(word.start, rest[-1].end)
            self.words[key] = getattr(self, f"read_{key}")(self.node.cut(rest[0].start, rest[-1].end))

    def state(self, part: Text) -> str | None:
        return self.named(part, "states", "state")

    read_start = read_end = state

    def read_axes(self, part: Text) -> str | None:
        word = part.value.strip()
        return word if word in NAMED_AXES else self.named(part, "bodies", "body")

    def read_relative(self, part: Text) -> str | None:
        return self.named(part, "bodies", "body")

    def read_at(self, part: Text) -> str | None:
        return ANY_TIME if part.value.split() == ANY_TIME.split() else self.state(part)

    def named(self, part: Text, plural: str, *kinds: str) -> str | None:
        word, what = part.value.strip(), " or ".join(kinds)
        kind, names = self.scope.kinds.get(word), self.scope.names(*kinds)
        if kind in kinds:
            return word
        if not word.isidentifier():
            help = f"clauses stand at the end, or in brackets with their quantity: `(path at {(names or ['A'])[0]})/2`"
            self.scope.fault(part, f"{quoted(word)} is no {what}", help, "find")
        elif kind:
            self.scope.fault(part, f"`{word}` is no {what} but {an(kind)}", hint("", names, plural), "kind")
        else:
            self.scope.unknown(part, word, what, names, plural)
        return None

    def read_during(self, part: Text) -> str | None:
        return self.named(part, "phases and events", "phase", "event")

    def read_about(self, part: Text) -> PointRef | None:
        if self.scope.space and part.value.strip().startswith("["):
            return read_point(self.scope, list_of_texts(part), "about", "about")
        return read_point(self.scope, part, "about", "about", ("body", "connection"))

    def read_along(self, part: Text) -> Formula | str | tuple[Formula, ...] | None:
        word = part.value.strip()
        if self.scope.space and word.startswith("["):
            return read_way(self.scope, list_of_texts(part), "along")
        if self.scope.space and word in WORDS:
            return WORDS[word]
        if word in DIRECTIONS or self.scope.kinds.get(word) in ("surface", "body"):
            return word
        return read_scalar(self.scope, part, Want("along", "angle", "theta"))

    def read_by(self, part: Text) -> str | Path | None:
        word = part.value.strip()
        if word in METHODS:
            return word
        if "." in word and not self.scope.space:
            path = read_path(self.scope, part, 0, len(part.value))
            if path is None or path.quantity in MEANT_BY:
                return path
            help = f"a mean is taken by a {' or a '.join(MEANT_BY)}"
            return self.scope.fault(part, f"no mean is taken by `{path.quantity}`", help, "choice")
        return self.scope.fault(part, f"{quoted(word)} is no way to an answer", hint(word, METHODS, "ways"), "choice")

    def read_where(self, part: Text) -> Condition | None:
        self.where = self.condition(part)
        return self.where

    def read_in(self, part: Text) -> Unit | None:
        try:
            self.unit = parse_unit(part.value)
        except UnitError as error:
            help = did_you_mean(error.suggestion, "`in` is for units; `during` for phases and events")
            place = part.part(error.start, error.end) if error.suggestion else part
            self.scope.fault(place, error.message, help, "unit")
        return self.unit

    def check(self, terms: Sequence[Term], modifier: str = "") -> None:
        """A clause says something of one of the quantities before it; `by` a path is of a mean."""
        for word, quantities in SAID_OF.items():
            if isinstance(self.words.get(word), Path):
                if modifier != "mean":
                    message = f"`{self.places[word].value}` is of a mean, and none is asked"
                    self.scope.fault(self.places[word], message, "write `mean` in front of the quantity", "idle")
                continue
            asked = list(dict.fromkeys(term.path.quantity for term in terms))
            if self.words.get(word) is not None and not set(asked) & set(quantities):
                said = " and ".join(f"`{quantity}`" for quantity in asked)
                message = f"`{self.places[word].value}` says nothing of {said or 'what is asked'}"
                self.scope.fault(self.places[word], message, f"`{word}` is for {', '.join(quantities)}", "idle")

    def applied(self, term: Term) -> Term:
        """The term with the clauses that it has not got of its own, and that say something of its quantity."""
        names = ("at", "during", "start", "end", "about", "along", "by", "axes", "relative")
        changes = {
            name: self.words[name]
            for name in names
            if self.words.get(name) is not None
            and getattr(term, name) is None
            and (isinstance(self.words[name], Path) or term.path.quantity in SAID_OF.get(name, (term.path.quantity,)))
        }
        if any((term.at, term.during, term.start)):
            for name in ("at", "during", "start", "end"):
                changes.pop(name, None)
        return replace(term, **changes)


def list_of_texts(part: Text) -> List:
    """`[a, b, c]` within a phrase as a list of texts in their places."""
    inner = part.value.removeprefix("[").removesuffix("]")
    items, start = [], 1
    for item in inner.split(","):
        items.append(part.cut(start, start + len(item)))
        start += len(item) + 1
    return List(tuple(items), part.span)
