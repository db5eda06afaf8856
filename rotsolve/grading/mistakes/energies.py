"""Mistakes with energy and momentum: a half left out, energy or momentum kept where it is not, work left out."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from fractions import Fraction
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula, Negative, Number, Product, negate, total
from rotsolve.core.equation import ANGULAR_MOMENTUM, DERIVATIVE, ENERGY, NEWTON, POWER, SECOND_CHOICE, Equation, Law
from rotsolve.core.facts import Force
from rotsolve.core.passage import Alteration, Encounter, Meeting
from rotsolve.core.symbols import of_kinds
from rotsolve.core.writing import flat, moved, spoken
from rotsolve.grading.mistakes.mistake import Change, Made, both_sides
from rotsolve.laws import momentum
from rotsolve.laws.table import EVENT, ThroughEvent, equations_for

if TYPE_CHECKING:
    from rotsolve.grading.mistakes.scene import Scene

HALF = Number(Fraction(1, 2))
KEPT = Law("kinetic energy kept", "conservation of kinetic energy", ANGULAR_MOMENTUM, 3, kinetic=True)

Laws = Callable[[Encounter, str], Iterator[Equation]]  # of an event, for the section in which they are written


# halves


def halves(scene: Scene) -> Made:
    """m v² and I ω² for their halves, both or either; k x² for its half."""
    facts = scene.moments
    inertias = frozenset(
        name
        for moment in facts
        for body in moment.bodies
        if body.inertia is not None
        for name in body.inertia.letter.symbols()
    )
    stored = frozenset(term for moment in facts for item in moment.potentials for term in flat([item.energy]))
    kinds: tuple[tuple[str, Callable[[Formula], bool]], ...] = (
        ("in the kinetic energy", lambda term: term not in stored),
        ("in ½ I ω²", lambda term: term not in stored and not inertias.isdisjoint(term.symbols())),
        ("in ½ m v²", lambda term: term not in stored and inertias.isdisjoint(term.symbols())),
        ("in the energy of the spring", lambda term: term in stored),
    )
    for where, fits in kinds if stored else kinds[:-1]:
        altered = Alteration(equation=without_halves(speaks_of_energy, fits))
        yield f"the half was left out {where}", Change(altered=altered, aside=(NEWTON,))


def speaks_of_energy(equation: Equation) -> bool:
    """Whether an equation is a law of energy, whose halves are its own, not of a power, or says what a kinetic energy is."""
    return (equation.family == ENERGY and equation.law not in (POWER, DERIVATIVE)) or equation.law.kinetic


def half_of_way(scene: Scene) -> Made:
    """a t² for ½ a t², and (v₁ + v₂) t for its half."""
    if scene.equations.passages:
        for words, mean in (("½ a t²", False), ("½ (v₁ + v₂) t", True)):
            altered = Alteration(equation=in_time(mean))
            yield f"the half was left out in {words}", Change(altered=altered, aside=(ANGULAR_MOMENTUM,))


def in_time(mean: bool) -> Callable[[Equation], Equation]:
    """The equations of constant acceleration without the half of one, which is the first choice; the others are the second.

    Of those, v₂ = v₁ + a t comes first, since most would take it next.
    """

    def timed(equation: Equation) -> bool:
        return equation.law.steady != ""

    twice = without_halves(timed, lambda term: True)

    def changed(equation: Equation) -> Equation:
        if not timed(equation):
            return equation
        whole = twice(equation)
        if whole != equation and equation.law.mean == mean:
            return replace(whole, cost=1)
        return replace(equation, cost=SECOND_CHOICE + equation.cost)

    return changed


def without_halves(
    concerns: Callable[[Equation], bool], fits: Callable[[Formula], bool]
) -> Callable[[Equation], Equation]:
    """Some equations without the halves in front of some terms."""

    def whole(term: Formula) -> Formula:
        if isinstance(term, Negative):
            return negate(whole(term.operand))
        halved = isinstance(term, Product) and term.factors[0] == HALF
        return 2 * term if halved and fits(term) else term

    def changed(equation: Equation) -> Equation:
        if not concerns(equation):
            return equation
        return both_sides(equation, lambda side: total([whole(term) for term in flat([side])]))

    return changed


# work


def no_work(scene: Scene) -> Made:
    """Mechanical energy kept though friction, or what acts inside, takes some of it."""
    works = {work.owner for passage in scene.equations.passages.values() for work in passage.works}
    if works:
        altered = Alteration(equation=workless)
        words = "energy was taken as conserved though work is done"
        yield words, Change(altered=altered, aside=(NEWTON, ANGULAR_MOMENTUM))


def workless(equation: Equation) -> Equation:
    """An energy equation without the works that have a letter."""
    works = dict.fromkeys(of_kinds(equation.symbols(), ("work",)), ZERO)
    if equation.family != ENERGY or not works:
        return equation
    return both_sides(equation, lambda side: side.substitute(works))


# events


def energy_kept(scene: Scene) -> Made:
    """K₁ = K₂ through an event in place of its momenta; e = 1 where bodies bounce."""
    for encounter in (one for one in scene.equations.encounters.values() if not blows_from_outside(one)):
        words = f"kinetic energy was taken as conserved in the {spoken(encounter.name)}"
        yield words, Change(altered=Alteration(event=in_event(encounter.name, elastic_laws)))


def elastic_laws(encounter: Encounter, section: str) -> Iterator[Equation]:
    """The laws of an event in which no kinetic energy is lost."""
    if encounter.bounces:
        elastic = replace(encounter, bounces=tuple((ONE, *speeds) for _, *speeds in encounter.bounces))
        yield from equations_for(EVENT, ThroughEvent(elastic, section))
        return
    before, after = (
        [term for meeting in encounter.meetings for term in kinetic_terms(meeting, after=later)]
        for later in (False, True)
    )
    names = tuple(sorted(meeting.body.name for meeting in encounter.meetings))
    yield KEPT.equation(*moved(before, after), section, names)


def kinetic_terms(meeting: Meeting, *, after: bool) -> list[Formula]:
    """½ m v² + ½ I ω² of a body just before an event, or just after it."""
    velocity, spin = (meeting.after, meeting.spin_after) if after else (meeting.before, meeting.spin_before)
    if after and meeting.held is not None:
        return [HALF * meeting.held * spin**2]
    terms = [HALF * meeting.inertia * spin**2]
    if meeting.body.motion.kind != "axis":
        terms.append(HALF * meeting.body.mass * simplify(velocity.dot(velocity)))
    return terms


def momentum_through_support(scene: Scene) -> Made:
    """Σ m v₁ = Σ m v₂ though a support pushes as well."""
    for encounter in scene.equations.encounters.values():
        if encounter.about:
            words = f"momentum was taken as conserved in the {spoken(encounter.name)}, though the support pushes too"
            yield words, Change(altered=Alteration(event=in_event(encounter.name, unsupported_momenta)))


def unsupported_momenta(encounter: Encounter, section: str) -> Iterator[Equation]:
    """The momenta of an event without the impulse of the support."""
    free = [replace(item, blows=blows_of_event(item, encounter)) for item in encounter.meetings]
    names = tuple(sorted(item.body.name for item in free))
    momenta = momentum.linear_momentum(replace(encounter, meetings=tuple(free)), section, names)
    yield from (momentum for momentum in momenta if ZERO not in (momentum.left, momentum.right))
    yield from momentum.restitution(ThroughEvent(encounter, section))


def blows_of_event(item: Meeting, encounter: Encounter) -> tuple[Force, ...]:
    """The blows on a body that an event gives from outside: its own impulses, and those of what it strikes that is fixed."""
    fixed = {len(closing.pair) for closing in encounter.closings} == {1}
    own = (blow for blow in item.blows if encounter.gives(blow) or (fixed and blow.owner in encounter.givers))
    return tuple(replace(blow, internal=False) for blow in own)


def blows_from_outside(encounter: Encounter) -> list[Force]:
    """The blows that are no part of the meeting itself, nor of a support."""
    return [blow for meeting in encounter.meetings for blow in meeting.blows if encounter.gives(blow)]


def in_event(name: str, laws: Laws) -> Laws:
    """Other laws for one event of a scene."""

    def changed(encounter: Encounter, section: str) -> Iterator[Equation]:
        return laws(encounter, section) if section == name else equations_for(EVENT, ThroughEvent(encounter, section))

    return changed
