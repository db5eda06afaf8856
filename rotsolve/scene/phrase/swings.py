"""Swings in a `find` phrase: `period of small swings [of BODY] [about STATE]`, `period of swings [of BODY] from STATE`."""

from __future__ import annotations

from rotsolve.language.problem import Path, Term
from rotsolve.language.words import hint, quoted
from rotsolve.scene.tree.nodes import Text
from rotsolve.scene.values.pieces import Piece, pieces
from rotsolve.scene.values.scope import Scope

SWINGS = {"period of": "swing_period", "frequency of": "frequency", "angular_frequency of": "angular_frequency"}
SMALL, LARGE = "small swings", "swings"
FORM = "write `period of small swings`, with `of BODY` and `about STATE` where there are several, or `period of swings from STATE`"


def read_swings(scope: Scope, node: Text, words: list[Piece], modifier: str) -> tuple[Term, list[Piece]] | None:
    """What follows `period of`, and the words after that.

    The term's modifier says which swings, `at` about which state, `start` from which.
    """
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
    if (kind == SMALL and found["from"]) or (kind == LARGE and (found["about"] or not found["from"])):
        scope.fault(span, "small swings are `about` a state, other ones `from` one", FORM, "find")
        return None
    path = Path(found["of"], SWINGS[modifier], span=span)
    return Term(path, kind, at=found["about"] or None, start=found["from"] or None), rest


def trailing(scope: Scope, node: Text, rest: list[Piece]) -> None:
    """A fault for words that can't follow."""
    place = node.part(rest[0].start, rest[-1].end)
    what = quoted(node.value[rest[0].start : rest[-1].end])
    help = "to reckon with it put it in brackets: `(period of small swings)/2`"
    scope.fault(place, f"{what} can't follow here", help, "find")


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


def swings_said(text: str) -> bool:
    """Whether a line of a state speaks of swings: `period of small swings: 2 s`."""
    return any(text.startswith(f"{modifier} ") for modifier in SWINGS)


def swings_path(scope: Scope, line: Text) -> Path | None:
    """The period or frequency of small swings that a line of a state gives; None after a fault."""
    words = [piece for piece in pieces(line.value, scope.givens) if piece.kind != "space"]
    modifier = f"{words[0].text} {words[1].text}"
    found = read_swings(scope, line, words[2:], modifier)
    if found is None:
        return None
    term, rest = found
    if rest:
        trailing(scope, line, rest)
        return None
    if term.modifier == SMALL and term.at is None:
        return term.path
    scope.fault(
        line, "a state tells the period of small swings about itself", f"write `{modifier} small swings: …`", "find"
    )
    return None
