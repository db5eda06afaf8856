"""Limits: what becomes of answers when a letter is nothing, or a mass lies ever further out, and what that means for the motion."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from msgspec import Struct

from rotsolve.algebra.exact.normal import is_zero, without_direction
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import ONE, ZERO, Formula, Quotient, Symbol
from rotsolve.algebra.units.dimension import ACCELERATION, ANGLE, ENERGY, FORCE, MASS, NONE, Dimension
from rotsolve.core.derivation import Check
from rotsolve.core.equation import SECOND_LAW
from rotsolve.core.faults import Unsolvable
from rotsolve.core.letters import Given
from rotsolve.core.symbols import ACCELERATIONS, has_quantities, is_key, of_kinds
from rotsolve.core.writing import spoken
from rotsolve.derivation.insights import energy_at, weight_in
from rotsolve.language.problem import Body, Path, Term
from rotsolve.paths.meaning import NotYet
from rotsolve.search.answers import Answered
from rotsolve.search.search import Search, is_unreal

AT_CENTRE, FAR_OUT = "all mass at the centre", "all mass far out"
SHORT = 3  # a limit is told when its value is no longer than this many nodes
SHORT_SPREAD = 9  # and this one, ½ m v², of what says how far out a mass lies
FEW, LONGEST = 6, 120  # nodes of a formula of which limits are looked at: shorter ones show them, longer ones take long
MOST = 3  # answers of which the limits are told together


class Towards(Struct, frozen=True):
    """A letter that becomes nothing, or grows beyond all measure."""

    name: str
    search: Search
    grows: bool = False

    def limit(self, formula: Formula) -> Formula | None:
        """What a formula comes to, None where it has no value there, such as 0/0."""
        if self.grows:
            formula = self.search.solver.simplify(formula.substitute({self.name: ONE / Symbol(self.name)}))
        put = formula.substitute({self.name: ZERO})
        try:
            if any(is_zero(node.denominator) for node in put.walk() if isinstance(node, Quotient)):
                return None
            return None if without_direction(put) else self.search.solver.simplify(put)
        except (ZeroDivisionError, ValueError):
            return None


def limit_checks(search: Search) -> Iterator[Check]:
    """What becomes of an answer when a mass is left out, and when a pure number or an angle is nothing: of each the most telling one;
    and of all answers when a mass is at the centre, and far out."""
    plain = not search.scene.modes  # else a body that slides may stick when an angle is small
    for dimensions, least in ((MASS,), 1), ((NONE, ANGLE), 0):
        found = [item for item in vanishing_letters(search, dimensions) if item[0] >= least and (least or plain)]
        if found:
            _, towards, answered, value = min(found, key=lambda item: item[0])
            said = (Symbol(towards.name), " → 0 gives ", Symbol(answered.asked.find.name), " = ", value)
            meant = meaning(answered, value, towards)
            yield Check((*said, f": {meant}") if meant else said, vanishing=towards.name, limit=bool(meant))
    for given in search.givens.values():
        if given.dimension == NONE and spreads(given, search):
            yield from as_mass_spreads(given.name, search)


def vanishing_letters(
    search: Search, dimensions: Sequence[Dimension]
) -> Iterator[tuple[int, Towards, Answered, Formula]]:
    """What the first answers come to without a letter of some dimensions, by how long that is: 0 is nothing, 1 a letter."""
    for answered in search.wholes()[:2]:
        formula = answered.found.formula
        if formula is None or not is_looked_at(answered):
            continue
        letters = [given for given in search.givens.values() if given.name in formula.symbols()]
        for given in (given for given in letters if given.dimension in dimensions and not spreads(given, search)):
            towards = Towards(given.name, search)
            value = towards.limit(formula)
            if value is None or length(value) > SHORT or value == formula:
                continue
            if is_unreal(value, search):  # there is no such motion without it
                continue
            yield length(value) if value != ZERO else 0, towards, answered, value


def is_looked_at(answered: Answered) -> bool:
    """Whether limits of an answer are looked at."""
    formula = answered.found.formula
    if answered.asked.find.runs or formula is None or has_quantities(formula):
        return False
    return FEW <= length(formula) <= LONGEST


def as_mass_spreads(name: str, search: Search) -> Iterator[Check]:
    """What becomes of answers as a pure number of moments of inertia vanishes and grows, β in β m R²: the mass lies ever further out."""
    for grows, where in (False, f" → 0 ({AT_CENTRE}) gives "), (True, f" → ∞ ({FAR_OUT}) gives "):
        towards, told, meant = Towards(name, search, grows), list[str | Formula](), dict[str, None]()
        for item in search.wholes()[:MOST]:
            formula = item.found.formula
            looked_at = formula is not None and name in formula.symbols() and length(formula) <= LONGEST
            if formula is None or not looked_at or item.asked.find.runs or has_quantities(formula):
                continue
            value = towards.limit(formula)
            if value is None or length(value) > SHORT_SPREAD or is_unreal(value, search):
                continue
            told += [*([", "] if told else []), Symbol(item.asked.find.name), " = ", value]
            meant |= dict.fromkeys(filter(None, (meaning(item, value, towards),)))
        if not told:
            continue
        bodies = spread_bodies(name, search) if grows and not search.scene.configuration.problem.space else ()
        meant |= dict.fromkeys(filter(None, (slid_to_rest(body, towards) for body in bodies)))
        behind = (f": {'; '.join(meant)}",) if meant else ()
        yield Check(
            (Symbol(name), where, *told, *behind),
            vanishing="" if grows else name,
            growing=name if grows else "",
            limit=True,
        )


def meaning(item: Answered, value: Formula, towards: Towards) -> str:
    """What a limit says of the motion, where the laws prove it; '' where it goes without saying."""
    search, terms = towards.search, item.asked.find.terms
    if search.scene.configuration.problem.space:
        return ""
    if item.asked.dimension == ENERGY and len(terms) == 1 and terms[0].modifier == "lost":
        first = energy_at(began(terms[0], search), search)
        whole = first is not None and first != ZERO and is_zero(value - first)
        return "no energy is lost" if value == ZERO else "all the kinetic energy is lost" if whole else ""
    if item.asked.dimension not in (FORCE, ACCELERATION):
        return ""
    for law in search.planner.pool:
        weight = weight_in(law, search) if law.law == SECOND_LAW and item.asked.letter in law.symbols() else None
        if weight is None or towards.name in weight.symbols():
            continue
        body, gravity = spoken(law.bodies[0]), search.scene.configuration.problem.gravity
        if item.asked.dimension == FORCE:
            own = item.asked.letter in law.left.symbols() and bool(of_kinds(law.right.symbols(), ACCELERATIONS))
            held = f"the force bears the whole weight: {body} does not begin to fall"
            free = f"{body} falls freely"
            return "" if not own else free if value == ZERO else held if is_zero(value - weight) else ""
        alone = {name for name in law.right.symbols() if is_key(name)} == {item.asked.letter}
        if alone and gravity is not None and is_zero(value - gravity):
            return f"{body} falls freely"
    return ""


def began(term: Term, search: Search) -> str:
    """The state from which on something is lost."""
    timeline = search.scene.configuration.timeline
    interval = None if term.during is None else timeline.interval(term.during)
    return interval.start if interval is not None else term.start or timeline.states[0].name


def slid_to_rest(body: Body, towards: Towards) -> str:
    """Whether a body that moves without turning at first has come to rest at last, as it is not set turning."""
    states = [state.name for state in towards.search.scene.configuration.timeline.states]
    moving, turning = (rate_at(body, quantity, states[0], towards) for quantity in ("velocity", "angular_velocity"))
    last = rate_at(body, "velocity", states[-1], towards)
    if moving in (None, ZERO) or turning != ZERO or last is None or towards.name not in last.symbols():
        return ""
    rests = towards.limit(last) == ZERO
    return f"{spoken(body.name)} comes to rest, as a block would that can not be set turning" if rests else ""


def rate_at(body: Body, quantity: str, state: str, towards: Towards) -> Formula | None:
    """A rate of a body at a state in givens, where the answers tell it."""
    try:
        meant = towards.search.scene.reader(state).meaning(Path(body.name, quantity)).formula
    except (NotYet, Unsolvable):
        return None
    found = towards.search.solver.with_found(meant)
    return None if has_quantities(found) else found


def spread_bodies(name: str, search: Search) -> Iterator[Body]:
    """The bodies with a moment of inertia in which a letter stands."""
    bodies = search.scene.configuration.problem.bodies
    return (body for body in bodies if body.inertia is not None and name in body.inertia.symbols())


def spreads(given: Given, search: Search) -> bool:
    """Whether a letter is the pure number of a moment of inertia, which tells how far out the mass lies."""
    held = [body.inertia for body in spread_bodies(given.name, search) if body.inertia is not None]
    if not held or given.dimension != NONE:
        return False
    from rotsolve.derivation.ranges import in_proportion

    return all(in_proportion(inertia, given.name) for inertia in held)
