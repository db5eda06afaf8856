"""Over a letter: the value of a letter at which a quantity, found first as a function of it, has a given value.

Roots in closed form are looked for first, then, where all other letters have numbers, certified ones over the whole range of the letter.
"""

from __future__ import annotations

from rotsolve.algebra.exact.roots import solve_polynomial, solve_trig, solve_under_root
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.notation.letters import name_to_text
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.derivation import Equality, Words
from rotsolve.language.problem import EXTREMES, Find
from rotsolve.motion.positive import is_angle
from rotsolve.paths.meaning import NotYet
from rotsolve.questions.find import Asked
from rotsolve.search.extrema import Conclusion, as_function_of, by_condition, forget, own_letter
from rotsolve.search.extreme_curve import certified_roots, domain_of
from rotsolve.search.search import TURN, Search, whole_turns
from rotsolve.solver.steps import Found, PickedRoot

NUMERICALLY = "solved numerically, with certified digits"


def over_letter(search: Search, find: Find, letter: str, phrase: Find, value: Formula, *, closed: bool = False) -> None:
    """The value of a letter at which a quantity, found first as a function of it, has a given value; where it is to be in `closed` form,
    NotYet of one that is found numerically."""
    quantity, curve = as_function_of(search, phrase, letter)
    given = search.givens[letter]
    own = Symbol(own_letter(search, find, letter))
    said = f"{name_to_text(quantity.asked.find.name)} = {to_text(value)}"
    equation = Equality(curve.substitute({letter: own}), value)
    roots = closed_roots(curve, value, letter, search)
    if is_angle(given):
        roots = [root + whole_turns(root, search) * TURN for root in roots]
    if closed and not roots:
        raise NotYet(f"no value of `{letter}` in closed form fulfils the condition")
    found, words = picked(roots, own.name, find, search) if roots else numbered(curve - value, own.name, find, search)
    question = Asked(find, own, own.name, given.dimension, section=quantity.asked.section)
    by_condition(search, question, found, Conclusion(said, equation, words), quantity, aside=False)
    if given.asked:
        forget(quantity, search)


def closed_roots(curve: Formula, value: Formula, letter: str, search: Search) -> list[Formula]:
    """The roots of curve = value in closed form; of a size or of roots those of the squares that are none of the other sign."""
    order, positive, gap = search.solver.order, search.solver.positive - {letter}, curve - value
    roots = solve_polynomial(gap, letter, order=order, positive=positive)
    roots = roots or solve_trig(gap, letter, order=order, positive=positive)
    if roots:
        return roots
    squared = solve_under_root(gap, letter, order=order, positive=search.solver.positive)
    if not squared and curve.holds("abs", "sqrt"):
        square = search.solver.simplify(curve**2 - value**2)
        squared = solve_polynomial(square, letter, order=order, positive=positive)
    return [root for root in squared if search.signs.decide(curve.substitute({letter: root}) - value) in (0, None)]


def picked(roots: list[Formula], own: str, find: Find, search: Search) -> tuple[Found, Words]:
    """The root that is meant, and why."""
    letter = find.formula.name if isinstance(find.formula, Symbol) else ""
    choice = search.choose_root(letter, roots, asked=find) if len(roots) > 1 else PickedRoot(0)
    if choice is None:
        raise NotYet(f"no value of `{letter}` fulfils the condition")
    search.rivals[own] = search.rivals.pop(letter, ())
    return Found(own, search.solver.simplify(choice.of(roots))), choice.words


def numbered(gap: Formula, own: str, find: Find, search: Search) -> tuple[Found, Words]:
    """The certified number at which a gap vanishes, by choice the largest or smallest of several."""
    letter = find.formula.name if isinstance(find.formula, Symbol) else ""
    if set(search.signs.lacking(gap)) - {letter}:
        raise NotYet(
            f"no value of `{letter}` in closed form fulfils the condition", help="give all other letters numbers"
        )
    places = certified_roots(gap, letter, domain_of(letter, search), search)
    if not places:
        raise NotYet(f"no value of `{letter}` fulfils the condition")
    if len(places) > 1 and find.modifier not in EXTREMES:
        told = " and ".join(place.text(4) for place in places)
        help = f"ask for `smallest {letter} where …` or `largest {letter} where …`"
        raise NotYet(f"several values of `{letter}` fulfil the condition: {told} in SI units", help=help)
    place = places[-1] if find.modifier == "largest" else places[0]
    several: Words = (f"; the {find.modifier} of {len(places)}",) if len(places) > 1 else ()
    return Found(own, None, place), (NUMERICALLY, *several)
