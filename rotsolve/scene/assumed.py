"""Assumed: `m << M` among the approximations: two letters of one kind, of which the numbers, where they have any, are so."""

from __future__ import annotations

from rotsolve.algebra.formula import Symbol
from rotsolve.language.problem import SMALL_BESIDE
from rotsolve.language.words import hint
from rotsolve.scene.rough import rough
from rotsolve.scene.scope import Scope
from rotsolve.scene.tree import Node

SMALL = 0.1  # of the other one, at most, is what is small beside it


def small_beside(scope: Scope, node: Node, word: str) -> list[str]:
    """The approximation in its plain form; nothing after a fault."""
    letters = [part.strip() for part in word.split(SMALL_BESIDE)]
    form = f"write `m {SMALL_BESIDE} M` with two letters of `given`"
    if len(letters) != 2 or letters[0] == letters[1]:
        return faulted(scope, node, f"`{word}` does not say which letter is small beside which", form)
    for letter in letters:
        given = scope.givens.get(letter)
        if given is None:
            return faulted(scope, node, f"`{letter}` is no given", hint(letter, scope.names("given"), "givens"))
        if given.asked or (given.value is not None and given.value.symbols()):
            return faulted(scope, node, f"`{letter}` is made of others, or asked for", form)
    one, other = (scope.dimensions.get(letter) for letter in letters)
    if one is not None and other is not None and not one.matches(other):
        return faulted(scope, node, f"`{letters[0]}` and `{letters[1]}` are of different kinds", form)
    small, large = (rough(Symbol(letter), scope.numbers) for letter in letters)
    if small is not None and large is not None and not 0.0 < small <= SMALL * large:
        why = f"it is {small / large:.3g} of it" if large else f"`{letters[1]}` is 0"
        message = f"`{letters[0]}` is not small beside `{letters[1]}`: {why}"
        return faulted(scope, node, message, f"it may be {SMALL:g} of it at most; leave the approximation out")
    return [f"{letters[0]} {SMALL_BESIDE} {letters[1]}"]


def faulted(scope: Scope, node: Node, message: str, help: str) -> list[str]:
    """Nothing, with a fault at the place."""
    scope.fault(node, message, help, "form")
    return []
