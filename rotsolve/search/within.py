"""Within: a letter that is asked for lies where its key lets it be: no friction is negative, and no place beyond the end of its rod."""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.formula import Formula, Symbol, negate
from rotsolve.core.faults import Impossible, Unsolvable
from rotsolve.core.limits import Limit
from rotsolve.core.symbols import asked_symbol
from rotsolve.language.problem import Given
from rotsolve.motion.limits import limits_of_scene
from rotsolve.search.search import Search


class Bound(Struct, frozen=True):
    """A limit of what is asked for: with the answers in it, and a letter of it that they settle."""

    gap: Formula
    limit: Limit
    asked: Given


def seeks(search: Search) -> dict[str, str]:
    """The letters that questions settle, with the symbols of their answers: those that are asked for, and that of `x where …`."""
    problem = search.scene.configuration.problem
    asked = {item.name: item.name for item in problem.givens if item.asked}
    for find in problem.finds:
        if find.where is not None and isinstance(find.formula, Symbol) and find.formula.name in search.givens:
            asked.setdefault(find.formula.name, asked_symbol(find.name))
    return asked


def bounds_of_asked(search: Search) -> Iterator[Bound]:
    """Where the letters that questions settle have to lie."""
    sought = seeks(search)
    for limit in limits_of_scene(search.scene.configuration) if sought else ():
        names = sorted(limit.gap.symbols() & sought.keys())
        if names:
            gap = limit.gap.substitute({name: Symbol(sought[name]) for name in names})
            yield Bound(gap, limit, search.givens[names[0]])


def out_of_bounds(search: Search) -> Iterator[Unsolvable]:
    """Asked letters whose answer is none that they can be; of letters the case has the condition that they are."""
    problem = search.scene.configuration.problem
    for bound in bounds_of_asked(search):
        if beyond_its_bound(bound, search):
            message = f"no `{bound.asked.name}` that it can be makes it so: {bound.limit.words}"
            help = "check what the scene says of it"
            yield Impossible(message, span=bound.asked.span, help=help, lines=problem.lines, file=problem.file)


def beyond_its_bound(bound: Bound, search: Search) -> bool:
    """Whether the answers make negative what may not be, or zero."""
    value, roots = bound.gap, {}
    for name in bound.gap.symbols() & search.solver.solved.keys():
        found = search.solver.solved[name]
        if found.formula is not None:
            value = value.substitute({name: found.formula})
        elif found.number is not None:
            roots[name] = found.number
    if roots:
        try:
            return evaluate(value, search.values, roots=roots).sign == -1
        except Undefined:
            return False
    if bound.limit.strict:
        return search.numbers.side(value) in (0, -1)
    return search.numbers.side(negate(value)) == 1  # so that letters have the condition ≥ 0
