"""Insights: what an answer says beyond its number: what has cancelled, what it grows with, how it compares with free fall or a weight.

Each sentence comes from the closed form of an answer and from the equations behind it. What numbers do not certify is not said.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.certified.ball import Certified, multiple_of
from rotsolve.algebra.certified.sign import sign_within
from rotsolve.algebra.exact.linear import solve_linear
from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import ONE, ZERO, Call, Formula, Number, Product, Sum, Symbol, negate
from rotsolve.algebra.notation.text import unsigned
from rotsolve.algebra.units.dimension import ACCELERATION, ANGULAR_ACCELERATION, ENERGY, FORCE, INERTIA, LENGTH, MASS
from rotsolve.core.derivation import Words, in_a_row
from rotsolve.core.equation import ABOUT_CONTACT, RATE, SECOND_LAW, Equation
from rotsolve.core.facts import BodyFacts, Force
from rotsolve.core.faults import Unsolvable
from rotsolve.core.letters import system_told
from rotsolve.core.symbols import has_quantities, is_key
from rotsolve.core.writing import and_joined, spoken
from rotsolve.derivation.behind import behind
from rotsolve.derivation.second_ways import SecondWay, called
from rotsolve.language.problem import Path
from rotsolve.motion.unheld import unheld
from rotsolve.paths.meaning import NotYet
from rotsolve.search.answers import Answered
from rotsolve.search.search import Search

SIZES = (MASS, LENGTH, INERTIA)  # of which it is told what grows with them
LONG = 25  # nodes of one of which it is looked at: derivatives of longer ones cost more than the sentence is worth
PLAIN = frozenset(("sqrt", "sin", "cos", "tan"))
MOST = 2  # sentences about what cancels
TWO = 2  # forces of which one is a weight and the other compared with it
SIMPLE = 5  # nodes of a formula that shows at once what it grows with
DIGITS = 3
SHORT = 15  # nodes of a share of the energy that is told in letters
CLOSE = (95, 105)  # per cent of a weight within which a force is not compared with it


def told_in_letters(search: Search) -> list[Answered]:
    """The answers that have formulas and are no functions of time."""
    return [item for item in search.wholes() if item.found.formula is not None and not item.asked.find.runs]


def insights(search: Search, alone: Iterable[tuple[BodyFacts, Force]], way: SecondWay | None = None) -> Iterator[Words]:
    """Sentences about the answers, the most telling kinds first, each kind once or twice; `alone` are bodies with the one force that turns
    them. What has a second `way` needs none about the point of contact."""
    told = told_in_letters(search)
    lawful = [item for item in told if any(law.family for law in behind(item, search))]
    for name in unheld(search.scene.configuration) if lawful else ():
        yield (f"nothing holds {spoken(name)}: it is free to fall",)
    yield from cancelled(lawful, search)
    yield from growing(lawful, search)
    yield from beside_free_fall(lawful, search)
    yield from beside_weights(lawful, search)
    yield from energy_lost(search)
    yield from opposite_energies(told, search)
    yield from way_of_the_centre(told, search)
    yield from beside_a_ring(told, search)
    yield from about_contacts(told, search) if way is None else filter(None, (way.aside,))
    yield from by_friction_alone(alone, told, search)


def by_friction_alone(
    alone: Iterable[tuple[BodyFacts, Force]], told: Sequence[Answered], search: Search
) -> Iterator[Words]:
    """What the friction is for that alone turns a body, and how large it is where no law on the page says so."""
    said = set[str]()
    printed = {name for item in told for law in behind(item, search) for name in law.symbols()}
    for body, force in alone:
        if not force.role.rubs or body.name in said:
            continue
        said.add(body.name)
        keeps = f"{spoken(body.name)} would keep its angular velocity"
        size = None if force.size.symbols() & printed else friction_needed(body, force, search)
        least = coefficient_needed(body, force, search)
        if size is None and least is not None:
            yield (
                f"without friction {keeps}; not to slip it takes a coefficient of static friction of at least ",
                least,
            )
        elif size is None:
            yield (f"without friction {keeps}: no other force has a torque on it",)
        else:
            yield (
                "friction, ",
                size,
                f", alone turns {spoken(body.name)} about its centre of mass: without it {keeps}",
            )


def coefficient_needed(body: BodyFacts, force: Force, search: Search) -> Formula | None:
    """f/N of a contact of which the scene only says that it is rough enough, in givens; None where the pool does not tell N by itself."""
    touches = [one for one in search.scene.configuration.problem.connections if one.name == force.owner]
    rough = any(one.holds_whatever_it_takes() for one in touches)
    normal = [
        one.size for one in body.forces if one.owner == force.owner and one.role.presses and one.part == force.part
    ]
    if not rough or len(normal) != 1 or not isinstance(normal[0], Symbol):
        return None
    for law in search.planner.pool:
        keys = {name for name in law.symbols() if is_key(name)}
        if law.law == SECOND_LAW and keys == {normal[0].name} and body.name in law.bodies:
            press = solve_linear(
                law.left - law.right, normal[0].name, order=search.solver.order, positive=search.solver.positive
            )
            if press is None or is_zero(press):  # in a horizontal plane nothing presses on what lies beside it
                return None
            ratio = search.solver.simplify(search.solver.with_found(force.size) / press)
            known = not has_quantities(ratio) and length(ratio) <= SHORT
            return ratio if known and search.signs.sign(ratio) == 1 else None
    return None


def friction_needed(body: BodyFacts, force: Force, search: Search) -> Formula | None:
    """f = I α/R of the force that alone turns a body; None where α is not known in givens, or its sign."""
    if body.inertia is None or body.motion.kind == "axis":
        return None
    arm = body.torque_of(force) / force.size
    size = search.solver.simplify(
        search.solver.with_found(body.inertia.formula * body.motion.spin_rate) / search.solver.simplify(arm)
    )
    side = 0 if has_quantities(size) or size == ZERO else search.signs.sign(size)
    return size if side == 1 else search.solver.simplify(negate(size)) if side == -1 else None


def in_givens(item: Answered) -> Formula | None:
    """The formula of an answer in givens alone."""
    formula = item.found.formula
    return None if formula is None or has_quantities(formula) or not formula.symbols() else formula


def cancelled(told: Sequence[Answered], search: Search) -> Iterator[Words]:
    """ "M cancels: α and ω do not depend on it", of givens that the laws of answers hold and their formulas do not; masses first."""
    lost: dict[tuple[Formula, ...], list[str]] = {}
    for given in sorted(search.givens.values(), key=lambda given: given.dimension != MASS):
        without = [item for item in told if not given.asked and cancels(given.name, item, search)]
        letters = dict.fromkeys(Symbol(item.asked.find.group) for item in without if free_of(given.name, item, search))
        if letters:
            lost.setdefault(tuple(letters), []).append(given.name)
    for answers, names in list(lost.items())[:MOST]:
        verb, it = ("cancels", "it") if len(names) == 1 else ("cancel", "them")
        do = "does" if len(answers) == 1 else "do"
        yield (
            *listed_with_and(map(Symbol, names)),
            f" {verb}: ",
            *listed_with_and(answers),
            f" {do} not depend on {it}",
        )


def cancels(name: str, item: Answered, search: Search) -> bool:
    """Whether a given stands in the laws of an answer's own plan and not in its formula."""
    formula = in_givens(item)
    laws = (search.planner.pool[index] for index in item.used)
    return formula is not None and name not in formula.symbols() and any(name in law.symbols() for law in laws)


def free_of(name: str, item: Answered, search: Search) -> bool:
    """Whether a given stands in no component of the answer to which one belongs."""
    own = (other for other in search.wholes() if other.asked.find.group == item.asked.find.group)
    formulas = [other.found.formula for other in own]
    return all(one is not None and not has_quantities(one) and name not in one.symbols() for one in formulas)


def listed_with_and(letters: Iterable[Formula]) -> Words:
    """a, T and N."""
    *first, last = letters
    return (*in_a_row(first), " and ", last) if first else (last,)


def growing(told: Sequence[Answered], search: Search) -> Iterator[Words]:
    """ "a grows with m and falls with M", of the first answer whose formula does not show it at once."""
    for item in told:
        formula = in_givens(item)
        calls = set() if formula is None else {node.function for node in formula.walk(Call) if isinstance(node, Call)}
        if formula is None or not SIMPLE < length(formula) < LONG or not formula.holds(Sum) or calls - PLAIN:
            continue
        yield from grows_with(item, formula, search)
        return


def grows_with(item: Answered, formula: Formula, search: Search) -> Iterator[Words]:
    """What a positive answer grows with whatever the numbers are, by the signs of its derivatives."""
    positive = search.signs.positive
    ways: dict[int, list[Formula]] = {1: [], -1: []}
    for given in search.givens.values() if search.signs.sign(formula) == 1 else ():
        if given.name in formula.symbols() and given.dimension in SIZES:
            side = sign_within(differentiate(formula, given.name), positive)
            if side:
                ways[side].append(Symbol(given.name))
    if ways[1] and ways[-1]:
        yield (called(item), " grows with ", *listed_with_and(ways[1]), " and falls with ", *listed_with_and(ways[-1]))


def beside_free_fall(told: Sequence[Answered], search: Search) -> Iterator[Words]:
    """ "a_end is 1.30 g, more than in free fall", of the first acceleration that is larger than g."""
    gravity = search.scene.configuration.problem.gravity
    for item in told:
        formula = in_givens(item)
        if formula is None or item.asked.dimension != ACCELERATION or not isinstance(gravity, Symbol):
            continue
        if gravity.name not in formula.symbols():
            continue
        whole = formula / gravity
        short = search.signs.lacking(formula) and length(formula) < SHORT  # letters may cancel
        ratio = Call("abs", (search.solver.simplify(whole) if short else whole,))
        size = search.signs.number(ratio)
        if size is not None and search.signs.by_numbers(ratio - ONE) == 1:
            said = called(item) if search.signs.sign(formula) == 1 else Call("abs", (called(item),))
            yield (said, f" is {size.text(DIGITS)} ", gravity, ", more than in free fall")
            return


def beside_weights(told: Sequence[Answered], search: Search) -> Iterator[Words]:
    """ "T is 0.556 m g, less than the weight of block", of the first force that stands in Newton's second law beside a weight."""
    for item in told:
        formula = in_givens(item)
        if formula is None or item.asked.dimension != FORCE:
            continue
        for law in behind(item, search):
            weight = weight_in(law, search)
            if weight is None or item.asked.letter not in law.symbols():
                continue
            ratio = search.signs.number(Call("abs", (formula / weight,)))
            if ratio is None or not ratio.sign or CLOSE[0] < 100 * ratio.float < CLOSE[1]:
                continue
            than = "more" if ratio.float > 1 else "less"
            yield (
                called(item),
                f" is {ratio.text(DIGITS)} ",
                weight,
                f", {than} than the weight of {spoken(law.bodies[0])}",
            )
            return


def weight_in(law: Equation, search: Search) -> Formula | None:
    """The term m g of Newton's second law of one body."""
    gravity = search.scene.configuration.problem.gravity
    if law.law != SECOND_LAW or len(law.bodies) != 1 or not isinstance(gravity, Symbol):
        return None
    if not isinstance(law.left, Sum) or len(law.left.terms) != TWO:
        return None
    for term in law.left.terms:
        size = unsigned(term) or term
        names = size.symbols()
        masses = [name for name in names if name in search.givens and search.givens[name].dimension == MASS]
        if isinstance(size, Product) and gravity.name in names and len(names) == 2 and len(masses) == 1:
            return size
    return None


def unit_of_energy(search: Search) -> tuple[str, Formula]:
    """The unit in which energies are told, J or that of the system of all givens, and how many joules it is."""
    system = system_told(search.scene.configuration.problem.givens)
    if system is None:
        return "J", ONE
    from rotsolve.algebra.units.systems import unit_in

    unit = unit_in(system, ENERGY)
    return ("J", ONE) if unit is None else (unit.text, unit.factor)


def digits_in(number: Certified | None, unit: Formula) -> str:
    """A certified number in a unit, in few digits."""
    assert number is not None
    return (number if unit == ONE else multiple_of(number, ONE / unit)).text(DIGITS)


def energy_lost(search: Search) -> Iterator[Words]:
    """ "in the hit the kinetic energy falls from 8.12 J to 3.04 J, by 62.5 %", of events; in letters the share that is lost, if short."""
    if search.scene.configuration.problem.space:
        return
    for interval in search.scene.configuration.timeline.intervals:
        if interval.event is None or not interval.event.told():
            continue
        first, last = (energy_at(state, search) for state in (interval.start, interval.end))
        if first is None or last is None or not search.signs.sign(first):
            continue
        share = search.solver.simplify((first - last) / first)
        numbers = [search.signs.number(value) for value in (first, last, 100 * share)]
        said, lost = f"in the {spoken(interval.name)} the kinetic energy ", search.signs.sign(share) == 1
        if search.signs.sign(share) == 0:
            yield (f"{said}stays the same",)
        elif all(number is not None and number.sign in (0, 1) for number in numbers):
            unit, scale = unit_of_energy(search)
            (one, two), percent = [digits_in(number, scale) for number in numbers[:2]], digits_in(numbers[2], ONE)
            yield (f"{said}falls from {one} {unit} to {two} {unit}, by {percent} %",)
        elif lost and length(share) <= SHORT and all(item.found.formula != share for item in search.wholes()):
            yield ("of the kinetic energy the share ", share, f" is lost in the {spoken(interval.name)}")
        if lost and interval.event.heats and not search.scene.facts(interval.start).given:
            yield (f"what is lost in the {spoken(interval.name)} becomes heat",)


def energy_at(state: str, search: Search) -> Formula | None:
    """The kinetic energy of all bodies at a state, in givens; None where what is asked does not tell it."""
    try:
        found = search.solver.with_found(search.scene.reader(state).meaning(Path("", "kinetic_energy")).formula)
    except (NotYet, Unsolvable):
        return None
    return None if has_quantities(found) else found


def opposite_energies(told: Sequence[Answered], search: Search) -> Iterator[Words]:
    """ "W = −ΔK", of two energies that are asked for."""
    energies = [
        (item, formula) for item in told if item.asked.dimension == ENERGY and (formula := in_givens(item)) is not None
    ]
    told_before = [
        (item, given)
        for item, formula in energies
        for given in search.givens.values()
        if given.dimension == ENERGY and given.value is not None and is_zero(formula + given.value)
    ]
    if told_before:
        item, given = told_before[0]
        yield (called(item), " = −", Symbol(given.name), ": the two agree")
        return
    for (one, first), (other, second) in combinations(energies, 2):
        if is_zero(first + second):
            asked = {(term.modifier, term.path.quantity) for item in (one, other) for term in item.asked.find.terms}
            same = asked == {("", "work"), ("lost", "kinetic_energy")}
            yield (called(other), " = −", called(one), *((": the work is what is lost",) if same else ()))
            return


def about_contacts(told: Sequence[Answered], search: Search) -> Iterator[Words]:
    """What turns a body about the point at which it rolls or unwinds, which tells at once the way in which it goes."""
    rates, states = (ACCELERATION, ANGULAR_ACCELERATION), search.scene.configuration.timeline.order
    laws = [law for item in told if item.asked.dimension in rates for law in behind(item, search)]
    used = any(law.law == ABOUT_CONTACT for law in laws)
    asked, printed = {law.section for law in laws} & states.keys(), {name for law in laws for name in law.symbols()}
    for law in search.planner.pool:
        left, right = ({name for name in side.symbols() if is_key(name)} for side in (law.left, law.right))
        if law.law != RATE or law.section not in asked or law.left == ZERO or not left <= printed:
            continue
        body = next(one for one in search.scene.facts(law.section).bodies if one.name == law.bodies[0])
        held = list(dict.fromkeys(force.noun for force in body.forces if force.internal))
        if body.motion.kind == "line" and body.motion.turns and held:
            act, back = "acts" if len(held) == 1 else "act", search.signs.by_numbers(law.left) == -1
            turns = search.scene.instant(law.section).turn_words(body.name)[back]
            where = f"about the point where {and_joined(held)} {act}"
            torque = search.solver.simplify(negate(law.left) if back else law.left)
            felt: Words = () if back or used or not right <= printed else (", which is ", law.right)
            yield (f"{where}, {spoken(body.name)} is turned {turns} by ", torque, *felt)
            return


def way_of_the_centre(told: Sequence[Answered], search: Search) -> Iterator[Words]:
    """The mistake to which the work of a force on a point that slides invites, where it is asked for."""
    if any(work.slide is not None for passage in search.scene.passages.values() for work in passage.works):
        from rotsolve.derivation.tempting import by_way_of_the_centre

        yield from by_way_of_the_centre(told, search)


def beside_a_ring(told: Sequence[Answered], search: Search) -> Iterator[Words]:
    """ "I is ½ of M R², that of the same mass all at the distance R", of a moment of inertia c M R²."""
    for item in told:
        formula = in_givens(item)
        paths = [term.path for term in item.asked.find.terms]
        if formula is None or item.asked.dimension != INERTIA or [path.quantity for path in paths] != ["inertia"]:
            continue
        shapes = (body.shape for body in search.scene.configuration.problem.bodies if body.name == paths[0].owner)
        if not any(shape is not None and (shape.round or shape.slender) for shape in shapes):
            continue
        names = {given.dimension: given.name for given in search.givens.values() if given.name in formula.symbols()}
        if len(formula.symbols()) != TWO or not {MASS, LENGTH} <= names.keys():
            continue
        whole = Symbol(names[MASS]) * Symbol(names[LENGTH]) ** 2
        share = search.solver.simplify(formula / whole)
        if isinstance(share, Number) and 0 < share.value < 1:
            distance = Symbol(names[LENGTH])
            yield (
                called(item),
                " is ",
                share,
                " of ",
                whole,
                ", which the same mass all at the distance ",
                distance,
                " would have: what lies nearer to the axis counts less, so that ",
                f"{spoken(paths[0].owner)} is easier to set turning",
            )
            return
