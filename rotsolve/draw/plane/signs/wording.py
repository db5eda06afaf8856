"""Wording: what sizes and bodies are called in a picture: by the letters of the scene, else as it writes them."""

from __future__ import annotations

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.symbols import TIME
from rotsolve.core.writing import spoken
from rotsolve.draw.paper.lettering import Words, formula_words, letter, prose
from rotsolve.language.bodies import Body
from rotsolve.language.problem import Problem


def told_as(value: Formula | None, problem: Problem) -> Words | None:
    """A size in its letter, or as it is written where it is a number; nothing of what the scene leaves out."""
    if value is None:
        return None
    givens = {given.name: given for given in problem.givens}
    given = givens.get(value.name) if isinstance(value, Symbol) else None
    if given is not None and given.automatic and given.asked:
        return letter(given.name.partition("_")[0])
    if given is not None and given.automatic:
        return prose(given.text.replace(" deg", "°").replace("deg", "°")) if given.text else None
    if any(givens[name].automatic for name in value.symbols() if name in givens):
        return None
    return formula_words(in_letters(value))


def in_letters(value: Formula) -> Formula:
    """A value that varies, with t for the time and the letters of the quantities with which it varies."""
    names = value.symbols()
    found: dict[str, Formula] = {
        name: Symbol(QUANTITIES[name.rpartition(".")[2]].letter) for name in names if "." in name
    }
    return value.substitute({**found, TIME: Symbol("t")}) if found or TIME in names else value


def named_in(body: Body, problem: Problem) -> Words:
    """What a body is called: by the letter of its mass or moment of inertia where the scene has one, else by its name."""
    given = {item.name: item for item in problem.givens}
    for value in (body.mass, body.inertia):
        letters = value.symbols() if value is not None else ()
        if value is not None and letters and not any(given[name].automatic for name in letters if name in given):
            return formula_words(value)
    return prose(spoken(body.name).removeprefix("the "))
