"""Modes in `find`: period of mode 1 [of BODY] [about STATE], ratio of A to B in mode 1 [about STATE]."""

from __future__ import annotations

import re

from msgspec.structs import replace

from rotsolve.language.grammar import RATIO_OF, SWINGS
from rotsolve.language.problem import MODE, Path, Term
from rotsolve.scene.literals import Lexeme
from rotsolve.scene.paths import read_path
from rotsolve.scene.phrases import clauses_of_swings
from rotsolve.scene.scope import Scope
from rotsolve.scene.tree import Text

FORM = "write `period of mode 1`, or `ratio of A.rotation to B.rotation in mode 1`, the slowest mode first"
COMPARED = ("displacement", "rotation")  # what is compared in a mode


def read_mode(scope: Scope, node: Text, words: list[Lexeme], modifier: str) -> tuple[Term, list[Lexeme]] | None:
    """What follows `period of` or `ratio of`, and the words after that."""
    span = node.part(words[0].start, words[-1].end) if words else node.span
    if scope.space:
        return scope.fault(span, "normal modes are solved in the plane only", "leave out `up: z`", "find")
    pair: list[Path] = []
    if modifier == RATIO_OF:
        found = read_pair(scope, node, words)
        if found is None:
            return None
        pair, words = found
    words = with_number_apart(words)
    if len(words) < 2 or words[0].text != "mode" or not words[1].text.isdigit() or int(words[1].text) < 1:
        return scope.fault(span, "the number of a mode is missing", FORM, "find")
    clauses = {"about": ""} if pair else {"of": "", "about": ""}
    rest = clauses_of_swings(scope, node, words[2:], clauses, FORM)
    if rest is None:
        return None
    mode, at = f"{MODE}{words[1].text}", clauses["about"] or None
    if pair:
        first, second = (shaped(path) for path in pair)
        return Term(first, mode, at=at, other=Term(second, mode)), rest
    return Term(Path(clauses["of"], SWINGS[modifier], span=span), mode, at=at), rest


def with_number_apart(words: list[Lexeme]) -> list[Lexeme]:
    """`mode`, `1`, `in`, where what follows is a unit: `1 in` was read as an inch."""
    if len(words) < 2 or not re.fullmatch(r"\d+\s+in", words[1].text):
        return words
    whole = words[1]
    digits = len(whole.text.split()[0])
    number = replace(whole, kind="number", text=whole.text[:digits], end=whole.start + digits)
    clause = replace(whole, kind="name", text="in", start=whole.end - 2)
    return [words[0], number, clause, *words[2:]]


def read_pair(scope: Scope, node: Text, words: list[Lexeme]) -> tuple[list[Path], list[Lexeme]] | None:
    """A and B of `A to B in`, two ways of bodies, and the words after that."""
    texts = [word.text for word in words]
    if len(words) < 4 or texts[1] != "to" or texts[3] != "in":
        span = node.part(words[0].start, words[-1].end) if words else node.span
        return scope.fault(span, "a ratio is of two amplitudes in a mode", FORM, "find")
    pair = []
    for word in (words[0], words[2]):
        path = read_path(scope, node, word.start, word.end)
        if path is None:
            return None
        if path.quantity not in COMPARED or path.point or scope.kinds.get(path.owner) != "body":
            message = f"`{word.text}` has no amplitude"
            help = "compare the `rotation` or the `displacement` of bodies (`.x`, `.y` of what moves freely)"
            return scope.fault(node.part(word.start, word.end), message, help, "find")
        pair.append(path)
    return pair, words[4:]


def shaped(path: Path) -> Path:
    """A way of a body as one of two amplitudes that are compared."""
    return Path(
        path.owner, "amplitude_ratio", component=f"{path.quantity} {path.component or ''}".strip(), span=path.span
    )
