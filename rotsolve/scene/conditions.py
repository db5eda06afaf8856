"""Conditions after `where` in a question: `base sticks`, `upright is stable`, `Q is largest`, `pin.impulse.x = 0 during hit`."""

from __future__ import annotations

from collections.abc import Callable, Collection
from itertools import pairwise
from typing import Any

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO
from rotsolve.algebra.units.dimension import word_of
from rotsolve.core.quantity import QUANTITIES
from rotsolve.language.grammar import CLAUSES
from rotsolve.language.problem import EXTREMES, Condition, Find, Path
from rotsolve.language.words import hint, quoted
from rotsolve.scene.literals import Lexeme, Want, dimension_in_words, lexemes
from rotsolve.scene.phrases import at_top
from rotsolve.scene.scope import Scope
from rotsolve.scene.tree import Text
from rotsolve.scene.values import read_scalar

WHEN = ("at", "during", "from")
FORMS = "write `contact sticks`, `state is stable`, `path is smallest` or `path = value`"
Quantity = Callable[[list[Lexeme]], "tuple[Find, Any] | None"]  # reads a phrase: it, and its dimension


def read_condition(scope: Scope, part: Text, quantity: Quantity, answers: Collection[str]) -> Condition | None:
    """The condition that `part` writes; None after a fault."""
    words = [piece for piece in lexemes(part.value, scope.givens) if piece.kind != "space"]
    texts = [piece.text for piece in words]
    if len(words) in (2, 3) and scope.kinds.get(texts[0]) == "connection" and (len(words) == 2 or texts[1] == "is"):
        return contact_word(scope, part, texts)
    if scope.space and texts[1:2] == ["is"] and texts[2:] in (["stable"], ["steady"]):
        if scope.kinds.get(texts[0]) == "state":
            return Condition(Path("", "stability"), word=texts[2], owner=texts[0], span=part.span)
        return scope.unknown(part, texts[0], "state", scope.names("state"), "states")
    if texts[1:] == ["is", "stable"] and scope.kinds.get(texts[0]) == "state":
        return Condition(Path("", "swing_period"), word="stable", owner=texts[0], span=part.span)
    if "=" in texts:
        return equality(scope, part, words, texts.index("="), quantity, answers)
    place = next((k for k, text in enumerate(texts[:-1]) if text == "is" and texts[k + 1] in EXTREMES), 0)
    if place:
        found = quantity([*words[:place], *words[place + 2 :]])
        return None if found is None else Condition(None, word=texts[place + 1], span=part.span, phrase=found[0])
    return scope.fault(part, f"{quoted(part.value)} is no condition", FORMS, "find")


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
    return scope.fault(part, f"`{owner}` can't be {quoted(word)}", help, "choice")


def equality(
    scope: Scope, part: Text, words: list[Lexeme], sign: int, quantity: Quantity, answers: Collection[str]
) -> Condition | None:
    """`path = value [clauses]` or `path [clauses] = path [clauses]`: the clauses at the end belong to both, but for those of
    which the left has one of its own."""
    left, own = side_and_clauses(words[:sign])
    right, last = side_and_clauses(words[sign + 1 :])
    if not left or not right:
        return scope.fault(part, f"{quoted(part.value)} is no condition", FORMS, "find")
    named = {*answers} - scope.givens.keys()  # what lines above answer
    if any(piece.kind == "path" or piece.text in named for piece in right):
        told = {what_it_tells(clause) for clause in own}
        shared = [clause for clause in last if what_it_tells(clause) not in told]
        read = quantity(chain_of([left], own, shared))
        other = None if read is None else quantity(chain_of([right], last))
        if read is None or other is None or not same_kind(scope, part, read[1], other[1]):
            return None
        formula = read[0].formula - other[0].formula
        return Condition(
            None, ZERO, span=part.span, phrase=replace(read[0], formula=formula, terms=other[0].terms, text=part.value)
        )
    read = quantity(chain_of([left], own, last))
    if read is None:
        return None
    find, dimension = read
    word = word_of(dimension)
    first = find.terms[0].path if find.terms else None
    kind = QUANTITIES.get(first.quantity) if first is not None else None
    letter, owner = (kind.letter if kind is not None else "") or "x", first.owner if first is not None else ""
    letter = letter if word != "number" else ""  # what has no unit stands in the derivation as it is written
    want = Want(part.value[: words[sign - 1].end], word, letter, owner)
    found = read_scalar(scope, part.cut(right[0].start, right[-1].end), want)
    return None if found is None else Condition(None, found, span=part.span, phrase=find)


def side_and_clauses(words: list[Lexeme]) -> tuple[list[Lexeme], list[list[Lexeme]]]:
    """One side of an equality: its expression, and the clauses that follow it outside of all brackets."""
    starts = [k for k, piece in at_top(words) if piece.text in CLAUSES and piece.text != "to"]  # `from A to B` is one
    return words[: min(starts, default=len(words))], [words[k:end] for k, end in pairwise([*starts, len(words)])]


def what_it_tells(clause: list[Lexeme]) -> str:
    """What a clause tells: when, of whatever form, or what its word says."""
    word = clause[0].text
    return "when" if word in WHEN else word


def chain_of(*parts: list[list[Lexeme]]) -> list[Lexeme]:
    return [piece for part in parts for words in part for piece in words]


def same_kind(scope: Scope, part: Text, left: Any, right: Any) -> bool:
    """Whether both sides of an equality may be equal, as far as their dimensions are known."""
    if left is None or right is None or left.matches(right):
        return True
    both = f"{dimension_in_words(left)} and {dimension_in_words(right)}"
    scope.fault(part, f"the sides of {quoted(part.value)} don't agree: {both}", kind="dimension")
    return False
