"""Energy: K₁ + U₁ + W = K₂ + U₂ over a phase, and the power of all forces = rate of the kinetic energy at an instant."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction

from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.exact.solving.linear import NotLinear, Singular, solve_all
from rotsolve.algebra.formula import ZERO, Formula, Negative, Number, Product, Quotient, Symbol, negate, total
from rotsolve.core.derivation import Words
from rotsolve.core.equation import ENERGY, Equation
from rotsolve.core.facts import BodyFacts, Facts, Rule, square
from rotsolve.core.passage import Passage
from rotsolve.core.vectors.heading import UP
from rotsolve.core.writing import flat, is_negative, moved, positive_first

HALF = Number(Fraction(1, 2))


def conservation(passage: Passage, section: str) -> Iterator[Equation]:
    """K₁ + U₁ + W = K₂ + U₂ for every group of connected bodies whose heights are known."""
    for group in passage.groups:
        if any(passage.heights.get(name) is None for name in group):
            continue
        first = [body for body in passage.start.bodies if body.name in group]
        last = [body for body in passage.end.bodies if body.name in group]
        if any(body.sweep is not None for body in first):
            continue  # the shaft gives energy too
        works = [work for work in passage.works if group & set(work.bodies)]
        left = [*kinetic(first), *potential(passage, group, 0), *(work.amount for work in works)]
        right = [*kinetic(last), *potential(passage, group, 1)]
        if not flat(left) and not flat(right):
            continue
        sides = arranged(left, right)
        label = "work and energy, K₁ + U₁ + W = K₂ + U₂" if works else "conservation of energy, K₁ + U₁ = K₂ + U₂"
        yield Equation(
            *sides, label, section, ENERGY, 4, reason(passage, group, bool(works)), bodies=tuple(sorted(group))
        )


def works(passage: Passage, section: str) -> Iterator[Equation]:
    """W = F s, W = τ θ or ∫ of them, for each work that has a letter of its own."""
    for work in passage.works:
        if work.spelled is not None and work.spelled != work.amount:
            label = f"work of {work.owner.replace('_', ' ')}"
            yield Equation(work.amount, work.spelled, label, section, "", 3, bodies=work.bodies)


def arranged(left: list[Formula], right: list[Formula]) -> tuple[Formula, Formula]:
    """K₁ + U₁ = K₂ + U₂ with what is only on one side and negative moved across, so that a fall reads m g h = ½ m v²."""
    if not flat(left) or all(is_negative(term) for term in flat(left)):
        return moved(left, right)
    return positive_first(left), positive_first(right)


def reason(passage: Passage, group: frozenset[str], works: bool) -> Words:
    """Why energy balances: what does no work."""
    inner = [work for work in passage.works if work.inner and group & set(work.bodies)]
    if inner:
        return (inner[0].amount, " is the work of the inner forces: kinetic energy alone is not conserved.")
    idle = [words for words in passage.idle if words]
    if works or not idle:
        return ()
    return (idle[0],)


def kinetic(bodies: list[BodyFacts]) -> list[Formula]:
    """½ m v² + ½ I ω² of each body, about a fixed axis ½ I ω² alone; and ½ m v² of riders along it."""
    terms: list[Formula] = []
    for body in bodies:
        if body.motion.kind != "axis":
            terms.extend(HALF * body.mass * square(size) for size, _ in body.motion.velocity.parts)
        if body.inertia is not None:
            terms.append(HALF * body.inertia.letter * square(body.motion.spin))
        terms.extend(HALF * mass * square(speed) for mass, speed in body.sliding)
    return [term for term in terms if term != ZERO]


def potential(passage: Passage, group: frozenset[str], end: int) -> list[Formula]:
    """m g h of each body, and the energy of the springs."""
    facts = (passage.start, passage.end)[end]
    terms: list[Formula] = []
    for body in facts.bodies:
        heights = passage.heights.get(body.name)
        if body.name in group and heights is not None:
            weights = [force for force in body.forces if force.role == "weight"]
            terms.extend(force.size * (heights[end] + force.arm.along(UP)) for force in weights)
    terms.extend(item.energy for item in facts.potentials if group & set(item.bodies))
    return terms


def power(facts: Facts, group: frozenset[str], section: str) -> Iterator[Equation]:
    """Rate of K = power of the forces, for one group that can move in one way only, divided by its one free rate.

    `facts` are of a virtual moment: positions and accelerations as they are, velocities of any motion that the rules allow. Ideal
    connections give no power, so their forces do not occur.
    """
    bodies = [body for body in facts.bodies if body.name in group]
    if any(body.changing or body.sweep is not None for body in bodies):
        return  # inner forces, or the shaft, give energy too
    balance = drive(facts, group)
    if balance is not None and balance != (ZERO, ZERO):
        words: Words = (
            "Power of all forces = rate of change of the kinetic energy, divided by the rate of the motion.",
        )
        label = "power and kinetic energy"
        yield Equation(
            positive_first([balance[0]]), balance[1], label, section, ENERGY, 5, words, bodies=tuple(sorted(group))
        )


def drive(facts: Facts, group: frozenset[str]) -> tuple[Formula, Formula] | None:
    """Σ F·v and Σ m a·v of a group, divided by its one free rate: what drives its motion; None where it moves in several ways."""
    bodies = [body for body in facts.bodies if body.name in group]
    gains, supplies = (
        [term for body in bodies for term in gain(body)],
        [term for body in bodies for term in supply(body)],
    )
    rates, allowed = freedom(facts, group, [*gains, *supplies])
    if allowed is None:
        return None
    gained, given = [term.substitute(allowed) for term in gains], [term.substitute(allowed) for term in supplies]
    free = next(name for name in rates if allowed.get(name) is None)
    left, right = (total([per_rate(term, free) for term in flat(side)]) for side in (given, gained))
    return left, right


def freedom(facts: Facts, group: frozenset[str], terms: list[Formula]) -> tuple[list[str], dict[str, Formula] | None]:
    """The velocity letters of a group that the rules or `terms` speak of, and all of them by one; None where it moves in several ways."""
    rules = [rule for rule in facts.rules if group & set(rule.bodies)]
    spoken_of = {
        name for term in (*terms, *(rule.velocity[0] - rule.velocity[1] for rule in rules)) for name in term.symbols()
    }
    rates = sorted({name for body in facts.bodies if body.name in group for name in rates_of(body)} & spoken_of)
    return rates, one_motion(rates, rules)


def rates_of(body: BodyFacts) -> set[str]:
    """The velocity letters of a body."""
    names = body.motion.spin.symbols()
    for size, _ in body.motion.velocity.parts:
        names |= size.symbols()
    return set(names)


def one_motion(rates: list[str], rules: list[Rule]) -> dict[str, Formula] | None:
    """All rates in terms of one, or None where the group can move in several ways."""
    if not rates:
        return None
    equations = [rule.velocity[0] - rule.velocity[1] for rule in rules]
    equations = [equation for equation in equations if equation.symbols() & set(rates)]
    free = next((name for name in rates if "angular_velocity" in name), rates[0])
    others = [name for name in rates if name != free]
    try:
        solved = solve_all(equations, others)
    except (Singular, NotLinear):
        return None
    if any(set(value.symbols()) & set(others) for value in solved.values()):
        return None
    return solved if all(is_zero(equation.substitute(solved)) for equation in equations) else None


def gain(body: BodyFacts) -> list[Formula]:
    """m a·v + I α ω; of a body that is carried round an axis also what its pieces' m a do in the plane."""
    terms = []
    if body.motion.kind != "axis":
        terms.append(body.mass * body.motion.acceleration.dot(body.motion.velocity))
    if body.inertia is not None:
        terms.append(body.inertia.letter * unsigned_product(body.motion.spin_rate, body.motion.spin))
    if body.sweep is not None:
        terms.append(body.sweep.moment * body.motion.spin)
    return [term for term in terms if term != ZERO]


def unsigned_product(first: Formula, second: Formula) -> Formula:
    """first · second; two minus signs cancel."""
    if isinstance(first, Negative) and isinstance(second, Negative):
        return first.operand * second.operand
    return first * second


def supply(body: BodyFacts) -> list[Formula]:
    """F·v at the point of every force that can work, and τ ω of every couple."""
    terms = []
    for force in body.forces:
        if not force.internal:
            terms.append(force.vector.dot(body.motion.velocity_of(force.arm)))
    for couple in body.couples:
        if not couple.internal:
            terms.append(unsigned_product(couple.torque, body.motion.spin))
    return [term for term in terms if term != ZERO]


def per_rate(term: Formula, rate: str) -> Formula:
    """term / rate, where the rate is one of the factors."""
    letter = Symbol(rate)
    if isinstance(term, Negative):
        return negate(per_rate(term.operand, rate))
    if term == letter:
        return Number(Fraction(1))
    if isinstance(term, Product) and letter in term.factors:
        index = term.factors.index(letter)
        rest = (*term.factors[:index], *term.factors[index + 1 :])
        return rest[0] if len(rest) == 1 else Product(rest)
    if isinstance(term, Quotient) and rate in term.numerator.symbols():
        return per_rate(term.numerator, rate) / term.denominator
    return simplify(term / letter)
