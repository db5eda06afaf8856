"""Slope: the direction of a slanted vector, as the line tan φ = |v_y|/|v_x| behind its size."""

from __future__ import annotations

from rotsolve.algebra.exact.writing.length import length
from rotsolve.algebra.formula import Call, Formula, Symbol
from rotsolve.algebra.notation.letters import name_to_text
from rotsolve.core.derivation import Answer, Equality, Move
from rotsolve.derivation.compose.result import LONG, Results

LETTERS = ("phi", "delta", "psi")


def slope(vector: Answer, results: Results) -> Move | None:
    """The line that tells the angle to the horizontal; None where a component is nothing or has no number."""
    if vector.angle is None or vector.brief:
        return None
    x, y = vector.components
    assert x.formula is not None and y.formula is not None
    ratio = y.formula / x.formula
    letter = Symbol(free_letter(vector.name, results))
    tangent = Call("tan", (letter,))
    sides = Equality(tangent, Call("abs", (y.symbol,)) / Call("abs", (x.symbol,)))
    chain = (sides,) if length(ratio) > LONG else (sides, Equality(tangent, positive(ratio, results)))
    return Move(f"direction of {name_to_text(vector.name)}", chain, None, (letter, " to the horizontal"))


def positive(ratio: Formula, results: Results) -> Formula:
    """The size of a quotient whose sign the numbers tell."""
    value = results.value(ratio)
    return results.search.solver.simplify(-ratio if value is not None and (value.sign or 0) < 0 else ratio)


def free_letter(name: str, results: Results) -> str:
    """A letter for the angle that the scene does not use; each of several vectors has its own."""
    search = results.search
    taken = {*search.givens, *(item.asked.find.name for item in search.answered)}
    free = next((letter for letter in LETTERS if letter not in taken), f"angle_{LETTERS[0]}")
    alone = sum(bool(item.parts) for item in search.wholes()) == 1
    return free if alone else f"{free}_{name}"
