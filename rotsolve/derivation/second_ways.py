"""Second ways: an answer written out by a law that its plan did not use: torque about the contact, Newton's second law, an impulse."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import reduce

from msgspec import Struct

from rotsolve.algebra.exact.linear import solve_linear
from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import Formula, Negative, Number, Product, Sum, Symbol, multiply, negate
from rotsolve.algebra.notation.text import unsigned
from rotsolve.algebra.units.dimension import ACCELERATION, ANGULAR_ACCELERATION, FORCE
from rotsolve.core.derivation import Equality, Words
from rotsolve.core.equation import (
    ABOUT_CONTACT,
    ANGULAR_MOMENTUM,
    BLOWS,
    FAMILIES,
    ROTATION,
    SECOND_LAW,
    TWISTS,
    UNTWISTED,
    Equation,
)
from rotsolve.core.faults import Unsolvable
from rotsolve.core.symbols import ACCELERATIONS, has_quantities, is_key, key_of, of_kinds
from rotsolve.core.writing import spoken
from rotsolve.derivation.behind import behind
from rotsolve.language.problem import Path
from rotsolve.paths.meaning import NotYet
from rotsolve.search.answers import Answered
from rotsolve.search.planning import FORCES
from rotsolve.search.search import Search

BY_IMPULSES = (BLOWS, TWISTS, UNTWISTED)
ENDS = ("start", "end")
SHORT = 15  # nodes of what an acceleration comes to that is put into a law


class Written(Struct, frozen=True):
    """A law of the pool as a second way writes it, with what is said beside it."""

    law: Equation
    equality: Equality
    remark: Words = ()


class Putting(Struct, frozen=True):
    """A step: letters that equations tell are put into another one, each of the page or, by its place, of the way itself."""

    into: Equation | int
    put: tuple[tuple[Formula, Equation | int | None], ...]  # a letter that a step tells has no equation
    chain: tuple[Equality, ...]


class SecondWay(Struct, frozen=True):
    """An answer once more: what makes it another way, its laws, and the steps from those to the answer."""

    why: Words
    laws: tuple[Written, ...]
    steps: tuple[Putting, ...]
    aside: Words = ()  # what its accelerations say besides


def called(item: Answered) -> Formula:
    """What an answer is called."""
    return Symbol(item.asked.find.name)


def second_way(told: Sequence[Answered], search: Search) -> SecondWay | None:
    """The first answer of which there is one that is short."""
    ways = (find(item, search) for item in told for find in (rate_about_contact, by_another_law, by_impulse))
    return next((way for way in ways if way is not None), None)


def rate_about_contact(item: Answered, search: Search) -> SecondWay | None:
    """The same rate by Newton's law for rotation about the point of contact, where that took those about the centre of mass."""
    laws = list(behind(item, search))
    printed, sections = {name for law in laws for name in law.symbols()}, {law.section for law in laws}
    used, found = {law.law for law in laws}, item.found.formula
    if item.asked.dimension not in (ACCELERATION, ANGULAR_ACCELERATION) or ROTATION not in used or found is None:
        return None
    for law in search.planner.pool if ABOUT_CONTACT not in used else ():
        if law.law != ABOUT_CONTACT or law.section not in sections or not law.symbols() <= printed:
            continue
        alone = len(of_kinds(law.symbols(), (*ACCELERATIONS, *FORCES))) == 1
        steps = contact_steps(item, law, laws, search) if alone else ()
        if steps and is_zero(search.solver.with_found(law.left - law.right)):
            body = spoken(law.bodies[0])
            why = f"About the point of contact no unknown force turns {body}, so that one equation is enough: "
            return SecondWay((why, *law.remark, "."), (Written(law, Equality(law.left, law.right)),), steps)
    return None


def contact_steps(item: Answered, law: Equation, laws: Sequence[Equation], search: Search) -> tuple[Putting, ...]:
    """Moments of inertia, and the answer for the rate, put into the law about the point of contact; nothing where more is needed."""
    (rate,), letter = of_kinds(law.symbols(), ACCELERATIONS) or ("",), item.asked.letter
    put = [(Symbol(name), told) for name in of_kinds(law.symbols(), ("inertia",)) for told in tellings(name, laws)]
    if rate != letter:
        ties = [
            tie for tie in tellings(rate, laws) if {name for name in tie.right.symbols() if is_key(name)} == {letter}
        ]
        if not ties:
            return ()
        put.append((Symbol(rate), ties[0]))
    found, values = item.found.formula, {symbol.name: told.right for symbol, told in put}
    if (
        found is None
        or has_quantities(found)
        or any(has_quantities(values[name.name]) for name, _ in put if name.name != rate)
    ):
        return ()
    left, right = law.left, with_factors(law.right, values, letter, search)
    summed = with_sums_done(right, search)
    chain = dict.fromkeys((Equality(left, right), Equality(left, summed), Equality(Symbol(letter), found)))
    return (Putting(0, tuple(put), tuple(chain)),)


def tellings(name: str, laws: Sequence[Equation]) -> Iterator[Equation]:
    """The first equation that tells a letter by itself, as I = ½ m R²."""
    yield from [law for law in laws if not law.family and law.left == Symbol(name)][:1]


def with_factors(product: Formula, values: dict[str, Formula], letter: str, search: Search) -> Formula:
    """A product with values put in; of factors that hold the letter, as R α/R, what they come to."""
    factors = product.factors if isinstance(product, Product) else (product,)
    put = (factor.substitute(values) for factor in factors)
    return reduce(multiply, (search.solver.simplify(one) if letter in one.symbols() else one for one in put))


def with_sums_done(product: Formula, search: Search) -> Formula:
    """A product whose sums of like terms are worked out, as ½ m R² + m R²; the same where they have none."""
    factors = product.factors if isinstance(product, Product) else (product,)
    done = (search.solver.simplify(one) if isinstance(one, Sum) else one for one in factors)
    found = reduce(multiply, done)
    return (
        product if any(isinstance(one, Sum) for one in (found.factors if isinstance(found, Product) else ())) else found
    )


def by_another_law(item: Answered, search: Search) -> SecondWay | None:
    """The same force by Newton's second law, where one relation of what moves is all that it takes besides."""
    laws = list(behind(item, search))
    sections, letter = {law.section for law in laws if law.family}, item.asked.letter
    moved = {name for law in laws for name in law.symbols() if is_key(name)}
    newton = all(law.law == SECOND_LAW for law in laws if law.family)
    if item.asked.dimension != FORCE or len(sections) > 1 or newton:
        return None
    for law in search.planner.pool:
        if law.law != SECOND_LAW or law in laws or law.section not in sections or letter not in law.symbols():
            continue
        more = [name for name in law.symbols() - moved - {letter} if is_key(name)]
        tied = told_by_relation(more[0], moved, law.section, search) if len(more) == 1 else None
        if tied is not None and is_zero(search.solver.with_found((law.left - law.right).substitute({more[0]: tied}))):
            return with_tie(item, law, {more[0]: tied}, laws, search)
    return None


def with_tie(
    item: Answered, law: Equation, tie: dict[str, Formula], laws: Sequence[Equation], search: Search
) -> SecondWay | None:
    """Newton's second law with what a relation tells its acceleration to be."""
    (tied,), (left, right) = tie.values(), (side.substitute(tie) for side in (law.left, law.right))
    if isinstance(right, Negative):
        left, right = search.solver.simplify(negate(left)), right.operand
    steps = second_law_steps(item, Equality(left, right), laws, search)
    told: Words = (unsigned(tied) or tied, " is the acceleration of its centre of mass")
    why = ("Newton's second law gives ", called(item), " too, once the acceleration is known.")
    aside = beyond_free_fall(law, tie, search)
    return SecondWay(why, (Written(law, Equality(left, right), told),), steps, aside) if steps else None


def beyond_free_fall(law: Equation, tie: dict[str, Formula], search: Search) -> Words:
    """That an end of a slender body falls faster than what falls freely."""
    problem, (body,), component = search.scene.configuration.problem, law.bodies[:1], key_of(next(iter(tie))).component
    gravity = None if problem.space or component != "y" else problem.gravity
    for point in ENDS if gravity is not None else ():
        try:
            path = Path(body, "acceleration", point=point, component=component)
            meant = search.scene.reader(law.section).meaning(path).formula.substitute(tie)
        except (NotYet, Unsolvable):
            return ()
        down = unsigned(search.solver.simplify(search.solver.with_found(meant)))
        ratio = None if down is None or gravity is None else search.solver.simplify(down / gravity)
        if down is not None and isinstance(ratio, Number) and ratio.value > 1:
            return (
                f"the {point} of {spoken(body)} falls with the acceleration ",
                down,
                ", faster than what falls freely",
            )
    return ()


def second_law_steps(
    item: Answered, written: Equality, laws: Sequence[Equation], search: Search
) -> tuple[Putting, ...]:
    """The acceleration from a law that holds it alone, and the force with that put in; nothing where it takes more."""
    rates, found = of_kinds(written.right.symbols(), ACCELERATIONS), item.found.formula
    if len(rates) != 1 or found is None or has_quantities(found):
        return ()
    value = found_for(rates[0], search)
    for law in laws:
        inertias = of_kinds(law.symbols(), ("inertia",))
        put = [(Symbol(name), told) for name in inertias for told in tellings(name, laws)]
        keys = {name for name in law.symbols() if is_key(name)} - set(inertias)
        if law.family and keys == {rates[0]} and not has_quantities(value) and length(value) <= SHORT:
            first = Putting(law, tuple(put), (Equality(Symbol(rates[0]), value),))
            right = written.right.substitute({rates[0]: value})
            chain = (
                Equality(written.left, right),
                Equality(written.left, search.solver.simplify(right)),
                Equality(Symbol(item.asked.letter), found),
            )
            return (first, Putting(0, ((Symbol(rates[0]), None),), tuple(dict.fromkeys(chain))))
    return ()


def by_impulse(item: Answered, search: Search) -> SecondWay | None:
    """A velocity behind an event by the one impulse on a body, where the plan had angular momentum conserved, in which that has no say."""
    laws = list(behind(item, search))
    kept = {law.section for law in laws if law.family == ANGULAR_MOMENTUM and law.law not in BY_IMPULSES}
    printed = {name for law in laws for name in law.symbols()}
    pool = [law for law in search.planner.pool if law.section in kept and law.law in BY_IMPULSES]
    for pushed in (law for law in pool if law.law == BLOWS):
        for twisted in (law for law in pool if law.law != BLOWS and law.bodies == pushed.bodies):
            more = [{name for name in law.symbols() - printed if is_key(name)} for law in (pushed, twisted)]
            if more[0] == more[1] and len(more[0]) == 1 and len(pushed.bodies) == 1:
                steps = impulse_steps(item, (pushed, twisted), next(iter(more[0])), laws, search)
                body, impulse = spoken(pushed.bodies[0]), Symbol(next(iter(more[0])))
                why = (
                    "Whatever the force is like, its impulse ",
                    impulse,
                    f" changes how {body} moves and how it turns.",
                )
                own = tuple(Written(law, Equality(law.left, law.right)) for law in (pushed, twisted))
                return SecondWay(why, own, steps) if steps else None
    return None


def impulse_steps(
    item: Answered, pair: tuple[Equation, Equation], impulse: str, laws: Sequence[Equation], search: Search
) -> tuple[Putting, ...]:
    """The impulse from the change of momentum, put into that of the angular momentum with what ties both motions together."""
    pushed, twisted = pair
    letter, found, values = item.asked.letter, item.found.formula, dict[str, Formula]()
    put: list[tuple[Formula, Equation | int | None]] = [(Symbol(impulse), None)]
    told = told_linearly(impulse, pushed, search)
    if told is None or found is None or has_quantities(found):
        return ()
    for name in sorted({name for law in pair for name in law.symbols() if is_key(name)} - {impulse, letter}):
        ties = [*tellings(name, laws)] if of_kinds([name], ("inertia",)) else [*ties_between(name, letter, laws)]
        value = told_linearly(name, ties[0], search) if ties else None
        if value is None:
            return ()
        values[name] = value
        put.append((Symbol(name), ties[0]))
    left, right = (side.substitute({impulse: told}).substitute(values) for side in (twisted.left, twisted.right))
    if not is_zero((left - right).substitute({letter: found})):
        return ()
    first = Putting(0, (), (Equality(Symbol(impulse), told),))
    return (first, Putting(1, tuple(put), (Equality(left, right), Equality(Symbol(letter), found))))


def ties_between(name: str, letter: str, laws: Sequence[Equation]) -> Iterator[Equation]:
    """The rules that hold two letters alone, as v = R ω."""
    for law in laws:
        if not law.family and {key for key in law.symbols() if is_key(key)} == {name, letter}:
            yield law


def told_linearly(name: str, law: Equation, search: Search) -> Formula | None:
    """What an equation tells a letter to be that it holds as a factor alone."""
    return solve_linear(law.left - law.right, name, order=search.solver.order, positive=search.solver.positive)


def found_for(name: str, search: Search) -> Formula:
    """What has been found for a letter, in givens; itself where nothing has."""
    return search.solver.simplify(search.solver.with_found(Symbol(name)))


def told_by_relation(name: str, known: set[str], section: str, search: Search) -> Formula | None:
    """What a relation of the motion tells an acceleration to be, in what the page speaks of already."""
    if not of_kinds([name], ACCELERATIONS):
        return None
    for law in search.planner.pool:
        if (
            law.section == section
            and law.family not in FAMILIES
            and law.left == Symbol(name)
            and {one for one in law.right.symbols() if is_key(one)} <= known
        ):
            return law.right
    return None
