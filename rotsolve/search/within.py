"""Within: a letter that is asked for lies where its key lets it be: no friction is negative, and no place beyond the end of its rod."""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.certified.sign import real_where
from rotsolve.algebra.formula import Formula, Symbol, negate
from rotsolve.core.faults import Impossible
from rotsolve.core.limits import Limit
from rotsolve.core.symbols import asked_symbol
from rotsolve.language.problem import Given
from rotsolve.search.answers import NoAnswer
from rotsolve.search.search import Search, asked_letter
from rotsolve.solver.steps import Found


class Bound(Struct, frozen=True):
    """A limit of what is asked for: with the answers in it, and a letter of it that they settle."""

    gap: Formula
    limit: Limit
    asked: Given


def seeks(search: Search) -> Iterator[dict[str, str]]:
    """The letters that questions settle, with the symbols of their answers: those that are asked for, and that of `x where …`; where
    several questions seek one letter, once for each of these."""
    problem = search.scene.configuration.problem
    asked = {item.name: item.name for item in problem.givens if item.asked}
    sought: dict[str, list[str]] = {}
    for find in problem.finds:
        if find.seeks in search.givens and (find.seeks not in asked or find.name in search.separate):
            sought.setdefault(find.seeks, []).append(asked_symbol(find.name))
    first = asked | {letter: symbols[0] for letter, symbols in sought.items()}
    yield first
    yield from (first | {letter: symbol} for letter, symbols in sought.items() for symbol in symbols[1:])


def bounds_of_asked(search: Search) -> Iterator[Bound]:
    """Where the letters that questions settle have to lie."""
    limits: list[Limit] | None = None
    for sought in seeks(search):
        from rotsolve.motion.limits import limits_of_scene

        limits = list(limits_of_scene(search.scene.configuration)) if limits is None and sought else limits
        for limit in limits or ():
            names = sorted(limit.gap.symbols() & sought.keys())
            if names:
                gap = limit.gap.substitute({name: Symbol(sought[name]) for name in names})
                yield Bound(gap, limit, search.givens[names[0]])


def out_of_bounds(search: Search) -> Iterator[Impossible]:
    """Unknown letters, asked for or not, whose value is none that they can be; of letters the case has the condition that they are."""
    for bound in bounds_of_asked(search):
        if beyond_its_bound(bound, search):
            yield impossible_letter(bound.asked, f": {bound.limit.words}", search)
    for given in search.givens.values():
        if given.asked and given.name not in search.solver.solved and not has_real_value(given.name, search):
            yield impossible_letter(given, ", with real numbers", search)


def impossible_letter(given: Given, why: str, search: Search) -> Impossible:
    """A letter that nothing that it can be makes fit, with its place in the file."""
    problem, help = search.scene.configuration.problem, "check what the scene says of it"
    several = len(problem.sought) > 1  # then another value of another letter might
    message = f"no `{given.name}` {'is found that fits' if several else 'that it can be makes it so'}{why}"
    return Impossible(message, span=given.span, help=help, lines=problem.lines, file=problem.file)


def value_found(name: str, search: Search) -> Found | None:
    """What the answers make of a letter, or, of one that no question asks for, the laws aside; None where they do not tell it."""
    found = search.solver.solved.get(name)
    given = search.givens.get(name)
    if found is not None or given is None or not given.asked:
        return found
    try:
        return search.apart().answer(asked_letter(name)).found
    except NoAnswer:
        return None


def has_real_value(name: str, search: Search) -> bool:
    """Whether the laws have a real value for a letter that no question asks for, or do not tell it; of letters that is a condition."""
    try:
        value = search.apart().answer(asked_letter(name)).found.formula
    except NoAnswer as error:
        return error.equation is None  # else the data contradict each other, whatever it is
    return value is None or all(search.numbers.side(limit) != -1 for limit in real_where(value))


def beyond_its_bound(bound: Bound, search: Search) -> bool:
    """Whether the answers make negative what may not be, or zero."""
    value, roots = bound.gap, {}
    for name in bound.gap.symbols():
        found = value_found(name, search)
        if found is not None and found.formula is not None:
            value = value.substitute({name: found.formula})
    for name in value.symbols():  # those too on which an answer hangs
        found = value_found(name, search)
        if found is not None and found.number is not None:
            roots[name] = found.number
    if roots:
        try:
            return evaluate(value, search.values, roots=roots).sign == -1
        except Undefined:
            return False
    if bound.limit.strict:
        return search.numbers.side(value) in (0, -1)
    return search.numbers.side(negate(value)) == 1  # so that letters have the condition ≥ 0
