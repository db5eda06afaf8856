"""Swings in a `find` phrase: `period of small swings [of BODY] [about STATE]`, `period of swings [of BODY] from STATE`."""

from __future__ import annotations

from rotsolve.scene.model import Path, Term
from rotsolve.scene.phrase.clauses import Clauses
from rotsolve.scene.tree.nodes import Text
from rotsolve.scene.values.pieces import Piece
from rotsolve.scene.values.scope import Scope
from rotsolve.scene.words import hint, quoted

SWINGS = {"period of": "period", "frequency of": "frequency", "angular_frequency of": "angular_frequency"}
SMALL, LARGE = "small swings", "swings"
FORM = "write `period of small swings`, with `of BODY` and `about STATE` where there are several, or `period of swings from STATE`"


def read_swings(scope: Scope, node: Text, words: list[Piece], modifier: str, clauses: Clauses) -> Term | None:
    """What follows `period of`, as a term: its modifier says which swings, `at` about which state, `start` from which."""
    kind = SMALL if words and words[0].text == "small" else LARGE
    rest = words[1:] if kind == SMALL else words
    if not rest or rest[0].text != "swings":
        place = node.part(words[0].start, words[-1].end) if words else node.span
        asked = node.value[words[0].start : words[-1].end] if words else ""
        scope.fault(place, f"{quoted(f'{modifier} {asked}'.strip())} is not known", FORM, "find")
        return None
    span, found, rest = node.part(words[0].start, rest[0].end), {"of": "", "about": "", "from": ""}, rest[1:]
    while rest and rest[0].text in found:
        if len(rest) < 2:
            scope.fault(node.part(rest[0].start, rest[0].end), f"nothing follows `{rest[0].text}`", FORM, "find")
            return None
        name = named(scope, node, rest[1], "body" if rest[0].text == "of" else "state")
        if name is None:
            return None
        found[rest[0].text], rest = name, rest[2:]
    if rest and not (clauses.outer and rest[0].text == "in" and clauses.read(rest)):
        place = node.part(rest[0].start, rest[-1].end)
        what = quoted(node.value[rest[0].start : rest[-1].end])
        scope.fault(
            place,
            f"{what} can't follow here",
            "to reckon with it put it in brackets: `(period of small swings)/2`",
            "find",
        )
        return None
    if (kind == SMALL and found["from"]) or (kind == LARGE and (found["about"] or not found["from"])):
        scope.fault(span, "small swings are `about` a state, other ones `from` one", FORM, "find")
        return None
    path = Path(found["of"], SWINGS[modifier], span=span)
    return Term(path, kind, at=found["about"] or None, start=found["from"] or None)


def named(scope: Scope, node: Text, word: Piece, kind: str) -> str | None:
    """The name of a body or state; None after a fault."""
    if scope.kinds.get(word.text) == kind:
        return word.text
    plural = "bodies" if kind == "body" else "states"
    scope.fault(
        node.part(word.start, word.end),
        f"unknown {kind} {quoted(word.text)}",
        hint(word.text, scope.names(kind), plural),
        "unknown",
    )
    return None
