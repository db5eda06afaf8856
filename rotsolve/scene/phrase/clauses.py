"""Clauses: what follows an expression in a `find` phrase: `at`, `during`, `from … to`, `about`, `on`, `along`, `where`, `in`."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from rotsolve.algebra.formula import Formula
from rotsolve.algebra.units.quantities import Unit, UnitError, parse_unit
from rotsolve.scene.model import Condition, Path, PointRef, Term
from rotsolve.scene.phrase.paths import read_path
from rotsolve.scene.reader.points import read_point
from rotsolve.scene.reader.states import EXTREMES, dimension_word
from rotsolve.scene.tree.nodes import Text
from rotsolve.scene.values.literals import Want
from rotsolve.scene.values.pieces import Piece
from rotsolve.scene.values.scope import Scope
from rotsolve.scene.values.values import value
from rotsolve.scene.words import hint, quoted

CLAUSES = ("on", "about", "along", "across", "relative", "at", "during", "from", "to", "where", "in")
DIRECTIONS = ("right", "left", "up", "down", "x", "y", "tangential", "normal")


class Clauses:
    """The clauses of one phrase, checked; `applied` puts them into a term."""

    def __init__(self, scope: Scope, node: Text, outer: bool) -> None:
        self.scope = scope
        self.node = node
        self.outer = outer
        self.words: dict[str, Any] = {}
        self.where: Condition | None = None
        self.unit: Unit | None = None

    def read(self, words: list[Piece]) -> bool:
        """Read all clauses; False after a fault."""
        faults = len(self.scope.faults)
        index = 0
        while index < len(words):
            word = words[index]
            end = index + 1
            while (end < len(words) and not (words[end].text in CLAUSES and words[end].kind == "name")) or (
                word.text == "where" and end < len(words) and words[end].text != "in"
            ):
                end += 1
            self.clause(word, words[index + 1 : end])
            index = end
        if ("start" in self.words) != ("end" in self.words):
            self.scope.fault(self.node, "`from` and `to` belong together", "write `from A to B`", "find")
        return len(self.scope.faults) == faults

    def clause(self, word: Piece, rest: list[Piece]) -> None:
        span = self.node.part(word.start, word.end)
        if not rest:
            self.scope.fault(span, f"nothing follows `{word.text}`", "", "find")
            return
        if word.text in ("across", "relative"):
            self.scope.later(span, word.text)
            return
        if not self.outer and word.text in ("where", "in"):
            self.scope.fault(span, f"`{word.text}` can't stand in brackets", "put it at the end", "find")
            return
        key = {"from": "start", "to": "end"}.get(word.text, word.text)
        if key in self.words:
            self.scope.fault(span, f"`{word.text}` stands twice", "", "find")
            return
        part = Text(
            self.node.value[rest[0].start : rest[-1].end],
            self.node.part(rest[0].start, rest[-1].end),
            True,
            self.node.exact,
        )
        self.words[key] = getattr(self, f"read_{key.rstrip('_')}")(part)

    def state(self, part: Text) -> str | None:
        return self.named(part, ("state",), "state", "states")

    read_at = read_start = read_end = state

    def named(self, part: Text, kinds: tuple[str, ...], what: str, plural: str) -> str | None:
        word = part.value.strip()
        if self.scope.kinds.get(word) in kinds:
            return word
        kind = self.scope.kinds.get(word)
        names = self.scope.names(*kinds)
        if not word.isidentifier():
            help = f"clauses stand at the end, or in brackets with their quantity: `(path at {(names or ['A'])[0]})/2`"
            self.scope.fault(part, f"{quoted(word)} is no {what}", help, "find")
        elif kind:
            self.scope.fault(part, f"`{word}` is no {what} but a {kind}", hint("", names, plural), "kind")
        else:
            self.scope.unknown(part, word, what, names, plural)
        return None

    def read_during(self, part: Text) -> str | None:
        return self.named(part, ("phase", "event"), "phase or event", "phases and events")

    def read_on(self, part: Text) -> str | None:
        return self.named(part, ("body",), "body", "bodies")

    def read_about(self, part: Text) -> PointRef | None:
        return read_point(self.scope, part, "about", "about", ("body", "connection"))

    def read_along(self, part: Text) -> Formula | str | None:
        word = part.value.strip()
        if word in DIRECTIONS or self.scope.kinds.get(word) in ("surface", "body"):
            return word
        return value(self.scope, part, Want("along", "angle", "theta"))

    def read_where(self, part: Text) -> Condition | None:
        self.where = condition_phrase(self.scope, part)
        return self.where

    def read_in(self, part: Text) -> Unit | None:
        try:
            self.unit = parse_unit(part.value)
        except UnitError as error:
            help = (
                f"did you mean `{error.suggestion}`?"
                if error.suggestion
                else "`in` is for units; `during` for phases and events"
            )
            self.scope.fault(part, error.message, help, "unit")
        return self.unit

    def applied(self, term: Term) -> Term:
        """The term with the clauses that it has not got of its own."""
        names = ("at", "during", "start", "end", "on", "about", "along")
        changes = {
            name: self.words[name] for name in names if self.words.get(name) is not None and getattr(term, name) is None
        }
        if any((term.at, term.during, term.start)):
            for name in ("at", "during", "start", "end"):
                changes.pop(name, None)
        return replace(term, **changes)


def condition_phrase(scope: Scope, part: Text) -> Condition | None:
    """`base sticks`, `upright is stable`, `Q is smallest`, `rod.angle = 30 deg`."""
    text = part.value
    words = text.split()
    if len(words) in (2, 3) and scope.kinds.get(words[0]) == "connection" and (len(words) == 2 or words[1] == "is"):
        cls = scope.elements.get(words[0])
        allowed: tuple[str, ...] = getattr(cls, "words", ())
        if words[-1] in allowed:
            return Condition(Path(words[0], "", span=part.span), word=words[-1], owner=words[0], span=part.span)
        scope.fault(part, f"`{words[0]}` can't be {quoted(words[-1])}", hint(words[-1], allowed, "it can be"), "choice")
        return None
    if len(words) == 3 and words[1:] == ["is", "stable"] and scope.kinds.get(words[0]) == "state":
        return Condition(Path("", "period"), word="stable", owner=words[0], span=part.span)
    if len(words) == 3 and words[1] == "is" and words[2] in EXTREMES:
        path = read_path(scope, part, text.index(words[0]), text.index(words[0]) + len(words[0]))
        return None if path is None else Condition(path, word=words[2], span=part.span)
    left, sign, right = text.partition("=")
    if sign:
        name = left.strip()
        start = text.index(name) if name else 0
        path = read_path(scope, part, start, start + len(name))
        if path is None:
            return None
        shift = len(left) + 1 + len(right) - len(right.lstrip())
        written = Text(right.strip(), part.part(shift, len(text)), True, part.exact)
        found = value(scope, written, Want(name, dimension_word(path.quantity), "x", path.owner))
        return None if found is None else Condition(path, found, span=part.span)
    scope.fault(
        part,
        f"{quoted(text)} is no condition",
        "write `contact sticks`, `state is stable`, `path is smallest` or `path = value`",
        "find",
    )
    return None
