"""Laws of a group of tied bodies at one moment, which restate Newton's: the rate of its angular momentum, and the power of all forces."""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct

from rotsolve.algebra.exact.linear import NotLinear, Singular, solve_all
from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import (
    HALF,
    ONE,
    ZERO,
    Formula,
    Negative,
    Product,
    Quotient,
    Sum,
    Symbol,
    add,
    multiply,
    negate,
    total,
)
from rotsolve.core.derivation import Words
from rotsolve.core.equation import ABOUT_CONTACT, DERIVATIVE, POWER, RATE, Equation
from rotsolve.core.facts import BodyFacts, Facts, Force, Rule, signed
from rotsolve.core.symbols import ACCELERATIONS, has_quantities, key_of, of_kinds
from rotsolve.core.vectors.heading import Vector
from rotsolve.core.writing import and_joined, flat, positive_first, spoken
from rotsolve.laws.energy import kinetic
from rotsolve.laws.newton import response
from rotsolve.laws.table import AtMoment, OfGroup
from rotsolve.motion.rigid import tidy

PLAINLY_ROLLING = 8  # above Newton's laws about the centre of mass; on a way shorter ones are wanted
SIMPLE = 2  # terms of I α + m a d: with two components of an acceleration the law about the centre of mass is shorter

FEW, SHORT = 3, 50  # rates of bodies, and nodes of two powers, that are written out


def rate_of_angular_momentum(at: OfGroup) -> Iterator[Equation]:
    """dL/dt = τ of a group: about the axis of its one wheel, or about the point where a rolling or unwinding body is held."""
    bodies = [body for body in at.facts.bodies if body.name in at.group]
    if any(body.changing for body in bodies):
        return
    turning = [body for body in bodies if body.motion.kind == "axis"]
    if len(turning) == 1:
        yield from about_axle(turning[0], [body for body in bodies if body is not turning[0]], at.section)
    elif len(bodies) == 1 and bodies[0].motion.kind == "line" and bodies[0].motion.turns:
        yield from about_contact(bodies[0], at.section)


def about_axle(wheel: BodyFacts, others: list[BodyFacts], section: str) -> Iterator[Equation]:
    """I α + Σ R m a = τ: a body on a string that runs off the wheel has the rim's radius for its arm."""
    sense, rates = wheel.motion.sense, [response(wheel)]
    pushes: list[Formula] = []
    between: set[tuple[str, Formula]] = set()  # tensions between the wheel and what hangs from it
    for body in others:
        held = string_between(body, wheel)
        if held is None or body.motion.kind != "line" or body.motion.turns or body.motion.heading is None:
            return
        between.add((held.owner, held.size))
        rates.append(signed(held.arm.cross(body.motion.acceleration.scaled(body.mass)), sense))
        for force in body.forces:
            if (force.owner, force.size) not in between:
                pull = Vector(((force.vector.along(body.motion.heading), body.motion.heading),))
                pushes.append(signed(held.arm.cross(pull), sense))
    pushes += [
        signed(wheel.torque_of(force), sense) for force in wheel.forces if (force.owner, force.size) not in between
    ]
    pushes += [signed(couple.torque, sense) for couple in wheel.couples]
    point = "the pivot" if wheel.cm.parts else "the axle"
    yield RATE.equation(positive_first(pushes), positive_first(rates), section, (wheel.name,), point=point)


def string_between(body: BodyFacts, wheel: BodyFacts) -> Force | None:
    """The pull on the wheel of the string that holds a body: the same tension the other way, at the rim's arm."""
    for force in body.forces:
        for other in wheel.forces:
            same = force.role.pulls and (force.owner, force.size) == (other.owner, other.size)
            if same and force.direction == -other.direction:
                return other
    return None


def rotation_about_contacts(at: AtMoment) -> Iterator[Equation]:
    """Σ τ = I α + r × m a of a body about the one point at which surfaces hold it: the forces there, often unknown, have no arm."""
    for body in at.facts.bodies:
        slips = any(force.role.rubs and not force.internal for force in body.forces)
        point = None if body.motion.kind == "axis" or body.changing or slips else one_contact(body)
        if point is not None and body.motion.turns:
            pushes, rates = newton_about(point, body)
            if pushes and rates and len(flat(rates)) <= SIMPLE:
                nouns = list(dict.fromkeys(force.noun for force in body.forces if force.arm == point))
                words: Words = (f"{and_joined(nouns)} {'have' if len(nouns) > 1 else 'has'} no arm there",)
                turned = by_parallel_axes(body, rates[-1], at.facts)
                if turned is not None:
                    words = (*words, "; ", turned.inertia, " by parallel axes", *turned.reason)
                    rates = [multiply(turned.inertia, turned.rate)]
                sides = positive_first(pushes), positive_first(rates)
                plainly = at.section == at.state and not moved_by_others(body)
                where, cost = "its point of contact", PLAINLY_ROLLING if plainly else None
                yield ABOUT_CONTACT.equation(*sides, at.section, (body.name,), words, cost=cost, point=where)


def moved_by_others(body: BodyFacts) -> bool:
    """Whether more than its weight has a say about the point of contact of what rolls: else friction is what a reader asks for first."""
    apart = [force for force in body.forces if not (force.role.weighs or force.role.presses or force.role.rubs)]
    return body.motion.kind != "line" or bool(apart or body.couples)


class TurnAboutPoint(Struct, frozen=True):
    """How a body turns about a point that does not move as about an axle: I + m d², α, and the rule by which it does."""

    inertia: Formula
    rate: Formula
    reason: Words


def by_parallel_axes(body: BodyFacts, orbital: Formula, facts: Facts) -> TurnAboutPoint | None:
    """I + m d² for I α + m a d, where a = d α by one rule of the body alone: what it touches does not move.

    α is a/d where the body goes along a line, so that one law tells a.
    """
    turning = signed(body.motion.spin_rate, body.motion.sense)
    if body.inertia is None or body.sweep is not None or turning == ZERO:
        return None
    names = of_kinds(orbital.symbols() | turning.symbols(), ACCELERATIONS)
    for rule in facts.rules:
        if rule.bodies != (body.name,) or rule.acceleration is None:
            continue
        tied = by_one(names, [rule.acceleration[0] - rule.acceleration[1]])
        if tied is None or len(tied) != 1:
            continue
        ((name, travel),) = tied.items()
        share = simplify(orbital.substitute(tied) / (turning.substitute(tied) * body.mass))
        if not has_quantities(share):
            along = body.motion.kind == "line" and travel.symbols() >= turning.symbols()
            ratio = simplify(travel / turning) if along else ONE
            straight = along and not has_quantities(ratio)
            rate = Symbol(name) / ratio if straight else turning
            reason: Words = (f", as {spoken(body.name)} turns about that point",)
            if straight:
                reason = (", and ", turning, " = ", rate, f", as {rule.label}")
            inertia = add(body.inertia.letter, multiply(body.mass, share))
            return TurnAboutPoint(inertia, rate, reason)
    return None


def one_contact(body: BodyFacts) -> Vector | None:
    """The one point, from the reference, at which surfaces press a body; None where there are several, or none."""
    points = {force.arm for force in body.forces if force.role.presses and force.internal}
    return points.pop() if len(points) == 1 else None


def newton_about(point: Vector, body: BodyFacts) -> tuple[list[Formula], list[Formula]]:
    """Torques about a point of what acts elsewhere, and I α + r × m a, the rate of the angular momentum about it."""
    sense = body.motion.sense
    apart = [force for force in body.forces if force.arm != point]
    pushes = [force.size * lever_arm(tidy(force.arm - point), force, sense) for force in apart]
    pushes += [signed(couple.torque, sense) for couple in body.couples]
    orbital = signed((body.cm - point).cross(body.centre_acceleration.scaled(body.mass)), sense)
    return flat(pushes), [term for term in (response(body), orbital) if term != ZERO]


def lever_arm(arm: Vector, force: Force, sense: int) -> Formula:
    """The lever of a force that turns in a sense, its positive terms first."""
    size = signed(arm.cross(force.direction), sense)
    if isinstance(size, Negative) and isinstance(size.operand, Sum):
        return positive_first([negate(term) for term in size.operand.terms])
    return positive_first([size])


def about_contact(body: BodyFacts, section: str) -> Iterator[Equation]:
    """Rolling or unwinding: about the point held by the surface or string, whose forces then have no arm."""
    held = {force.arm for force in body.forces if force.internal}
    if len(held) == 1:
        pushes, rates = newton_about(held.pop(), body)
        where = f"the point of contact of {spoken(body.name)}"
        yield RATE.equation(positive_first(pushes), positive_first(rates), section, (body.name,), point=where)


def rate_of_energy(at: OfGroup) -> Iterator[Equation]:
    """The derivative of the energy where it tells the one acceleration of a linkage, else the power of all forces."""
    yield from list(differentiated(at.virtual, at.group, at.section)) or power_of_forces(at)


def differentiated(facts: Facts, group: frozenset[str], section: str) -> Iterator[Equation]:
    """dE/dt divided by the rate of the motion, for one group that moves in one way while its rates change their ratio: J α = Σ F·v/ω.

    Such a group is a linkage, as a ladder between floor and wall: its accelerations, too, come down to one, so that neither the others
    nor the forces of its guides, which do no work, are needed. Only where K = ½ J ω² with the same J in every position: else there
    would be ½ ω² dJ/dt, too, which no one sees at a glance. `facts` are of a virtual moment, as for the power.
    """
    rules = [rule for rule in facts.rules if group & set(rule.bodies)]
    bodies = [body for body in facts.bodies if body.name in group]
    if all(rule.linear for rule in rules) or any(body.changing or body.sweep is not None for body in bodies):
        return
    gains, supplies = ([pair for body in bodies for pair in of(body)] for of in (gained, supplied))
    rates, allowed = freedom(facts, group, [power for _, power in (*gains, *supplies)])
    names = of_kinds({name for _, power in gains for name in power.symbols()}, ACCELERATIONS)
    ties = [rule.acceleration[0] - rule.acceleration[1] for rule in rules if rule.acceleration is not None]
    bound = by_one(names, ties)
    if not allowed or not bound:
        return
    unit, still, moving = with_free(rates, allowed, ONE), with_free(names, bound, ZERO), with_free(names, bound, ONE)
    if not is_zero(total([size * power.substitute(still).substitute(unit) for size, power in gains])):
        return
    pushes = [size * simplify(power.substitute(unit)) for size, power in supplies]
    driven = [(size, (power - power.substitute(still)).substitute(moving)) for size, power in gains]
    inertia = total([size * simplify(power.substitute(unit)) for size, power in driven])
    free = next(name for name in names if name not in bound)
    pace = "angular velocity" if key_of(free).turns else "speed"
    words: Words = (
        "The kinetic energy is ",
        HALF * inertia,
        f" times the square of the {pace}; the derivative of the energy, divided by this {pace}, leaves out the forces that do no work.",
    )
    sides = positive_first(pushes), inertia * Symbol(free)
    yield DERIVATIVE.equation(*sides, section, tuple(sorted(group)), words)


def with_free(names: list[str], others: dict[str, Formula], value: Formula) -> dict[str, Formula]:
    """All letters, where the one by which the others are told has a value."""
    free = next(name for name in names if name not in others)
    return {free: value} | {name: told.substitute({free: value}) for name, told in others.items()}


def power_of_forces(at: OfGroup) -> Iterator[Equation]:
    """Rate of K = power of the forces, for one group that can move in one way only, divided by its one free rate.

    The moment is virtual: positions and accelerations as they are, velocities of any motion that the rules allow. Ideal connections
    give no power, so their forces do not occur.
    """
    bodies = [body for body in at.virtual.bodies if body.name in at.group]
    if any(body.changing or body.sweep is not None for body in bodies):
        return  # inner forces, or the shaft, give energy too
    balance = drive(at.virtual, at.group)
    if balance is not None and balance != (ZERO, ZERO):
        words = rates_of_energy(at.virtual, at.group)
        yield POWER.equation(positive_first([balance[0]]), balance[1], at.section, tuple(sorted(at.group)), words)


def rates_of_energy(facts: Facts, group: frozenset[str]) -> Words:
    """K and, where they are short, how fast it grows and the power of what acts, in the rates of all bodies, and what divides both."""
    bodies = [body for body in facts.bodies if body.name in group]
    energy, gains, supplies = (
        total(kinetic(bodies)),
        *([term for body in bodies for term in of(body)] for of in (gain, supply)),
    )
    rates, allowed = freedom(facts, group, [*gains, *supplies])
    growth, power = total(gains), positive_first(supplies)
    if allowed is None or len(allowed) > FEW or length(growth) + length(power) > SHORT:
        return (
            "The kinetic energy is ",
            energy,
            "; its rate is the power of all forces. Both are divided by the rate of the motion.",
        )
    free = next(Symbol(name) for name in rates if name not in allowed)
    ties = [
        part for name, rate in allowed.items() for part in (", ", Symbol(name), " = ", per_rate(rate, free.name) * free)
    ][1:]
    grows: Words = (
        "The kinetic energy ",
        energy,
        " grows at the rate ",
        growth,
        ". That is the power of what acts, ",
        power,
        ".",
    )
    return (*grows, " Both are divided by ", free, *((", with ", *ties) if ties else ()), ".")


def drive(facts: Facts, group: frozenset[str]) -> tuple[Formula, Formula] | None:
    """Σ F·v and Σ m a·v of a group, divided by its one free rate: what drives its motion; None where it moves in several ways."""
    bodies = [body for body in facts.bodies if body.name in group]
    gains, supplies = ([term for body in bodies for term in of(body)] for of in (gain, supply))
    rates, allowed = freedom(facts, group, [*gains, *supplies])
    if allowed is None:
        return None
    gained, given = [term.substitute(allowed) for term in gains], [term.substitute(allowed) for term in supplies]
    free = next(name for name in rates if allowed.get(name) is None)
    return total([per_rate(term, free) for term in flat(given)]), total([per_rate(term, free) for term in flat(gained)])


def turned_per_rate(body: BodyFacts, facts: Facts, group: frozenset[str]) -> Formula | None:
    """How fast a body of a group turns counterclockwise for its one free rate; None where it moves in several ways."""
    bodies = [one for one in facts.bodies if one.name in group]
    rates, allowed = freedom(facts, group, [term for one in bodies for term in (*gain(one), *supply(one))])
    if allowed is None:
        return None
    free = next(name for name in rates if allowed.get(name) is None)
    return per_rate(body.motion.spin.substitute(allowed), free)


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
    return by_one(rates, [rule.velocity[0] - rule.velocity[1] for rule in rules])


def by_one(names: list[str], ties: list[Formula]) -> dict[str, Formula] | None:
    """Rates or accelerations in terms of one of them, that of a turn first, by equations that are zero; None where one does not do."""
    equations = [equation for equation in ties if equation.symbols() & set(names)]
    if len(equations) < len(names) - 1:  # of a long chain each rate would be tried in vain
        return None
    for free in sorted(names, key=lambda name: not key_of(name).turns):
        found = in_terms_of(free, [name for name in names if name != free], equations)
        if found is not None:
            return found
    return None


def in_terms_of(free: str, others: list[str], equations: list[Formula]) -> dict[str, Formula] | None:
    """Rates in terms of the free one; None where they do not hang on it alone, or equations hold it at rest: then another may be free."""
    try:
        solved = solve_all(equations, others)
    except (Singular, NotLinear):
        return None
    if any(set(value.symbols()) & set(others) for value in solved.values()):
        return None
    return solved if all(is_zero(equation.substitute(solved)) for equation in equations) else None


def gain(body: BodyFacts) -> list[Formula]:
    """m a·v + I α ω; of a body that is carried round an axis also what its pieces' m a do in the plane."""
    terms = [size * power for size, power in gained(body)]
    if body.sweep is not None:
        terms.append(body.sweep.moment * body.motion.spin)
    return [term for term in terms if term != ZERO]


def gained(body: BodyFacts) -> list[tuple[Formula, Formula]]:
    """m and a·v, I and α ω."""
    pairs = []
    if body.motion.kind != "axis":
        pairs.append((body.mass, body.centre_acceleration.dot(body.centre_velocity)))
    if body.inertia is not None:
        pairs.append((body.inertia.letter, unsigned_product(body.motion.spin_rate, body.motion.spin)))
    return pairs


def unsigned_product(first: Formula, second: Formula) -> Formula:
    """first · second; two minus signs cancel."""
    if isinstance(first, Negative) and isinstance(second, Negative):
        return first.operand * second.operand
    return first * second


def supply(body: BodyFacts) -> list[Formula]:
    """F·v at the point of every force that can work, and τ ω of every couple."""
    terms = [unsigned_product(size, power) for size, power in supplied(body)]
    return [term for term in terms if term != ZERO]


def supplied(body: BodyFacts) -> list[tuple[Formula, Formula]]:
    """The size of a force and the velocity of its point along it, τ and ω."""
    forces = [force for force in body.forces if not force.internal]
    couples = [couple for couple in body.couples if not couple.internal]
    pairs = [(force.size, force.direction.dot(body.motion.velocity_of(force.arm))) for force in forces]
    return [*pairs, *((couple.torque, body.motion.spin) for couple in couples)]


def per_rate(term: Formula, rate: str) -> Formula:
    """term / rate, where the rate is one of the factors."""
    letter = Symbol(rate)
    if isinstance(term, Negative):
        return negate(per_rate(term.operand, rate))
    if term == letter:
        return ONE
    if isinstance(term, Product) and letter in term.factors:
        index = term.factors.index(letter)
        rest = (*term.factors[:index], *term.factors[index + 1 :])
        return rest[0] if len(rest) == 1 else Product(rest)
    if isinstance(term, Quotient) and rate in term.numerator.symbols():
        return per_rate(term.numerator, rate) / term.denominator
    return simplify(term / letter)
