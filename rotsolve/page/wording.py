"""Wording: what is said of the steps of a derivation, from what kind of step it is."""

from __future__ import annotations

from collections.abc import Sequence

from rotsolve.algebra.formula import Formula, Integral, Product
from rotsolve.core.derivation import Cited, Move
from rotsolve.page.blocks import Phrase, joined_phrases


def said_of_step(move: Move) -> Phrase:
    """What a step does: "From (3)", "Put T from (4) and I from (2) into (1)"."""
    if not move.into:
        return (move.sources,) if move.sources else ()
    if move.another:
        return (f"Another root of {move.into}",)
    if move.divisor:
        told = (", with ", *enumerated(cited_phrases(move.put))) if move.put else ()
        gone: Phrase = () if move.alone is None else (", so that ", move.alone, " cancels")
        return (f"Divide {move.into} by {move.divisor}", *gone, *told)
    if not move.put:
        return (f"From {move.into}",)
    front = ", constants in front of the integral" if integral_alone(move) else ""
    left: Phrase = () if move.alone is None else (", so that only ", move.alone, " is unknown")
    return ("Put ", *enumerated(cited_phrases(move.put)), f" into {move.into}{front}", *left)


def integral_alone(move: Move) -> bool:
    """Whether a step begins with factors and an integral that the next line carries out."""
    right = move.chain[0].right
    factors = right.factors if isinstance(right, Product) else ()
    return len(move.chain) > 1 and any(isinstance(factor, Integral) for factor in factors)


def cited_phrases(put: Sequence[Cited]) -> list[Phrase]:
    """What is put in, equation by equation: "T from (4)", "(5)", and an answer found before by its letter."""
    by_mark: dict[str, list[Formula]] = {}
    for one in put:
        letters = by_mark.setdefault(one.mark, [])
        letters += [one.letter] if one.letter is not None else []
    phrases: list[Phrase] = [(letter,) for letter in by_mark.pop("", ())]
    for mark in sorted(by_mark, key=mark_number):
        told = enumerated([(letter,) for letter in by_mark[mark]])
        phrases.append((*told, f" from {mark}") if told else (mark,))
    return phrases


def mark_number(mark: str) -> int:
    """The number of an equation: 12 of (12)."""
    return int(mark[1:-1])


def enumerated(phrases: Sequence[Phrase]) -> Phrase:
    """a, b and c."""
    if len(phrases) < 2:
        return phrases[0] if phrases else ()
    return (*joined_phrases(phrases[:-1], ", "), " and ", *phrases[-1])
