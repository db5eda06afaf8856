"""Rules of motion: how strings, contacts, joints and drives tie rates together, given motions, and steady rotation."""

from __future__ import annotations

from collections.abc import Iterator

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import PI, ZERO, Call, Formula, Symbol, negate
from rotsolve.core.derivation import Words
from rotsolve.core.drive import TURNING
from rotsolve.core.equation import GIVEN_MOTION, PERIOD, RULE, RULE_OF_WAYS, STEADY, STRETCH, Equation, Law
from rotsolve.core.facts import GivenMotion, Rule, signed
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.symbols import TIME, is_quantity
from rotsolve.core.writing import flat, is_negative, spoken
from rotsolve.laws.table import AtMoment, OverPhase, ThroughEvent


def rules_for_accelerations(at: AtMoment) -> Iterator[Equation]:
    """The rules for accelerations."""
    for rule in at.facts.rules:
        if rule.acceleration is not None:
            remark = (*rule.remark, *rule.bent)
            yield rule_equation(replace(rule, remark=remark) if rule.bent else rule, rule.acceleration, at.section)


def rules_for_velocities(at: AtMoment) -> Iterator[Equation]:
    """The rules for velocities."""
    for rule in at.facts.rules:
        yield rule_equation(rule, rule.velocity, at.state)


def rules_through_event(at: ThroughEvent) -> Iterator[Equation]:
    """The rules for velocities right after an event of what sticks through it."""
    for rule in at.encounter.rules:
        yield rule_equation(rule, rule.velocity, at.section)


def rules_for_displacements(over: OverPhase) -> Iterator[Equation]:
    """The rules for displacements and angles turned, put in for the rates; only where their coefficients never change."""
    for rule in over.thought.rules:
        if rule.linear:
            left, right = (side.substitute(dict(over.changes)) for side in rule.velocity)
            yield rule_equation(rule, (left, right), over.section, RULE_OF_WAYS)


def ways_by_links(over: OverPhase) -> Iterator[Equation]:
    """The way of a body along its line by the angles of what joints and slots join it to."""
    for name, way, gone in over.passage.linked:
        yield RULE_OF_WAYS.equation(way, gone, over.section, (name,), words=f"how far {spoken(name)} is taken")


def rules_to_the_end(over: OverPhase) -> Iterator[Equation]:
    """The rules for velocities of a phase at its end, where another phase with other rules begins: what friction has held is at rest."""
    later = {rule.velocity for rule in over.passage.end.rules}
    for rule in over.thought.rules:
        left, right = (side.substitute(dict(over.lasts)) for side in rule.velocity)
        if rule.linear and (left, right) not in later:
            yield rule_equation(rule, (left, right), over.section)


def elongations(over: OverPhase) -> Iterator[Equation]:
    """A spring's elongation grows by what its ends move apart."""
    start, end = over.passage.start.potentials, over.passage.end.potentials
    for first, last, midst in zip(start, end, over.thought.potentials, strict=False):
        grown, left = midst.rate.substitute(dict(over.changes)), last.elongation - first.elongation
        if left != grown and not midst.placed:
            yield STRETCH.equation(left, grown, over.section, midst.bodies, words=midst.label)


def rule_equation(rule: Rule, sides: tuple[Formula, Formula], section: str, law: Law = RULE) -> Equation:
    """A rule as an equation; two sides that are both negative are turned round."""
    if all(is_negative(term) for side in sides for term in flat([side])):
        sides = negate(sides[0]), negate(sides[1])
    return law.equation(*sides, section, rule.bodies, rule.remark, words=rule.label)


def rates_of_given_motion(at: AtMoment) -> Iterator[Equation]:
    """Rate and acceleration of every given motion, as derivatives in time."""
    told = {(given.drive.body, given.drive.component, given.drive.word) for given in at.facts.given}
    for given in at.facts.given:
        functions = given.drive.rates()
        for word, function in functions.items():
            if (given.drive.body, given.drive.component, word) in told:
                continue
            left, right = given.letters[word], function.substitute({TIME: given.time})
            if left != right and not is_zero(left - right):
                words, remark = rate_in_letters(given, word), chain(given, word, functions)
                bodies, quantity = (given.drive.body,), spoken(word)
                yield GIVEN_MOTION.equation(left, right, at.state, bodies, remark, quantity=quantity, letters=words)


def rate_in_letters(given: GivenMotion, word: str) -> str:
    """ω = dθ/dt, or v_x = dx/dt."""
    words, axis = given.drive.kinds, given.drive.component
    names = ("θ", "ω", "α") if words == TURNING else (axis, f"v_{axis}", f"a_{axis}") if axis else ("x", "v", "a")
    k = words.index(word)
    return f"{names[k]} = d{names[k - 1]}/dt"


MADE_OF = {"angular_momentum": "L = I ω", "kinetic_energy": "K = ½ I ω²", "momentum": "p = m v"}


def chain(given: GivenMotion, word: str, functions: dict[str, Formula]) -> Words:
    """θ = c t³, ω = 3 c t², α = 6 c t at t = t₁: the functions from the given one on, and when they are taken."""
    drive, now = given.drive, given.time
    upto = list(functions)[: list(functions).index(word) + 1]
    said = upto if now != Symbol(TIME) else upto[:-1]
    parts: list[str | Formula] = []
    if drive.told is not None:
        what, formula = drive.told
        axis = Symbol("_".join(filter(None, (QUANTITIES[what].letter, drive.component))))
        parts = [axis, " = ", formula, ", " + MADE_OF[what]]
    for name in said:
        letter = "x" if name == "position" else QUANTITIES[name].letter
        indexed = Symbol(
            "_".join(filter(None, (letter, drive.component))) if name != "position" else drive.component or letter
        )
        parts += [", " if parts else "", indexed, " = ", functions[name]]
    if now != Symbol(TIME) and TIME in functions[word].symbols():
        parts += [" at ", Symbol(TIME), " = ", now]
    return tuple(part for part in parts if part != "")


def steady_rotation(at: AtMoment) -> Iterator[Equation]:
    """T = 2π/ω of every body whose period is spoken of; where it is given, the body turns along its positive sense."""
    for body in at.facts.bodies:
        period, motion = body.period, body.motion
        if period is None:
            continue
        spin = signed(motion.spin, motion.sense)
        asked = is_quantity(period)
        rate: Formula = Call("abs", (spin,)) if asked else spin
        yield PERIOD.equation(period, 2 * PI / rate, at.state, (body.name,))
        yield STEADY.equation(motion.spin_rate, ZERO, at.state, (body.name,))
