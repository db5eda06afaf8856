"""Samples: sets of numbers for letters that have none: small ones and large ones, and such as are right inside the edges of cases."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import islice, zip_longest
from operator import is_

from rotsolve.algebra.formula import Formula, Integral, Sum, Symbol
from rotsolve.algebra.units import dimension as kinds
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.course.sizes import LIMITS, letters_open, sizes_of_letters
from rotsolve.confirm.numbers import related, value_of
from rotsolve.core.derivation import Answer, Equality
from rotsolve.core.limits import Limit
from rotsolve.elements.asked import is_collides, is_touch
from rotsolve.elements.shapes import shape_of
from rotsolve.language.problem import Given, Problem

SETS, FEW = 5, 2  # sets of numbers for letters, and for those only that stand for what nothing is told of
DRAWS = 15  # how often a set is drawn for them
DIGITS = 3  # significant ones of a number that is drawn
EDGE, ROOM = 0.01, 0.05  # by how much of what it compares a condition holds right inside its edge, and well inside
CLOSED = ("=", "≥", "≤")  # conditions that hold on their edge
EDGES = 8  # sets right inside the edges of cases
STEPS = 8  # how often a letter is doubled or halved on the way to an edge
CLOSER = 7  # and how often its way there is halved
WIDE = 10.0  # how far those of the pool do, of which APART are tried that are far from each other
POOL, APART = 256, 6
LIGHT = 500.0  # by how much one of several masses is less than usual, where all is tried with it light
GRAVITY = 9.8
TALL = 100.0  # by how much longer than all others one of several lengths is, where something may tip over
STRONG = 20.0  # by how much more than usual what drives is, where it is strong
DRIVING = (kinds.FORCE, kinds.TORQUE, kinds.VELOCITY)
MEASURES = (
    kinds.MASS,
    kinds.INERTIA,
    kinds.LENGTH,
    kinds.TIME,
    kinds.ANGLE,
    kinds.NONE,
)  # all else in an action drives
HEAVY, SLOW = (
    50.0,
    20.0,
)  # how many times as much as others has what is heavy beside them, or a fast one the speed of a slow one
DULL = 0.05  # a coefficient of restitution of what hardly bounces
ROUGH = 3.0  # a coefficient of friction there
ROUGH_SETS, SLIPPERY = (
    12,
    tuple(0.05 * 2.0**step for step in range(9)),
)  # sets whose friction only just suffices; where that is sought

Numbers = Mapping[str, float]
Fits = Callable[[Numbers], bool]  # whether a scene may have some numbers, by its limits


def sets_wanted(problem: Problem) -> int:
    """How many sets speak for all: several where a letter of the scene is open, two where it is only a mass that plays no part."""
    open_ = letters_open(problem)
    return SETS if any(not given.automatic for given in open_) else FEW if open_ else 1


def sets_of_numbers(problem: Problem) -> Iterator[Numbers]:
    """The numbers of the givens; where some have none, several sets drawn for those."""
    sizes = sizes_of_letters(problem)
    for number in range(DRAWS if sizes.letters else 1):
        yield with_givens(problem, {name: in_few_digits(size) for name, size in sizes.drawn(number).items()})


def fits_of(limits: Sequence[Limit]) -> Fits:
    """Whether a scene may have some numbers for its letters, as far as its limits tell: no place beyond the end of its rod."""

    def fits(numbers: Numbers) -> bool:
        for limit in limits:
            try:
                gap = float(value_of(limit.gap, numbers))
            except (NotConfirmed, ArithmeticError, ValueError):
                continue
            if gap < 0.0 or (limit.strict and not gap):
                return False
        return True

    return fits


def fitting_first(sets: Iterable[Numbers], fits: Fits) -> Iterator[Numbers]:
    """The sets that a scene may have, then the others: an answer is an identity of its letters mostly, and they speak for it too."""
    others = []
    for numbers in sets:
        if fits(numbers):
            yield numbers
        else:
            others.append(numbers)
    yield from others


def far_apart(problem: Problem, answers: Sequence[Answer], fits: Fits) -> list[Numbers]:
    """Of a pool of sets that goes far beyond the limits some of each case: one next to an edge, others far from each other.

    What is next to nothing beside another, or goes wrong only on the way, is not seen with ordinary numbers.
    """
    drawn = sizes_of_letters(problem)
    regions: dict[tuple[int, ...], list[Numbers]] = {}
    for number in range(1, POOL if any(several.conditions or several.otherwise for several in answers) else 4 * APART):
        numbers = with_givens(problem, {name: in_few_digits(size) for name, size in drawn.drawn(number, WIDE).items()})
        if not fits(numbers):
            continue
        cases = [case for case in cases_at(answers, numbers) if case is not None]
        regions.setdefault(tuple(map(id, cases)), []).append(numbers)
    chosen = [far_from_each_other(problem, answers, sets) for key, sets in regions.items() if key]
    return list(islice((numbers for row in zip_longest(*chosen) for numbers in row if numbers is not None), APART))


def usual_sizes(problem: Problem, fits: Fits) -> dict[str, float]:
    """Ordinary numbers for the letters, such as a scene may have where any that are drawn are."""
    sizes = sizes_of_letters(problem)
    drawn = [sizes.drawn(number) for number in range(1, DRAWS)]
    return next((one for one in drawn if fits(with_givens(problem, one))), drawn[0])


def meeting_sets(problem: Problem, fits: Fits) -> Iterator[Numbers]:
    """Where bodies hardly bounce off each other, sets with each mass in turn much larger than the others, and slow, for long, or from far.

    With these they may meet again: what is heavy goes on behind what is light, which weights or springs turn back, or that turns round.
    """
    bounces = [event for event in problem.events if is_collides(event)]
    if not bounces:
        return
    open_, usual = letters_open(problem), usual_sizes(problem, fits)
    dull = {name for event in bounces if event.restitution is not None for name in event.restitution.symbols()}
    usual.update((name, DULL) for name in dull & usual.keys())
    masses = [given.name for given in open_ if given.dimension in (kinds.MASS, kinds.INERTIA)]
    slow = {given.name: usual[given.name] / SLOW for given in open_ if given.dimension == kinds.VELOCITY}
    long = {given.name: usual[given.name] * SLOW for given in open_ if given.dimension == kinds.TIME}
    wide = {given.name: LIMITS[kinds.ANGLE][1] for given in open_ if given.dimension == kinds.ANGLE}
    for heavy in masses if len(masses) > 1 else [""]:
        light = {name: usual[name] / HEAVY for name in masses if name != heavy}
        for change in [one for one in (slow, long, wide) if one] or [{}]:
            yield with_givens(
                problem, {name: in_few_digits(size) for name, size in {**usual, **light, **change}.items()}
            )


def extreme_sets(problem: Problem, admitted: Callable[[Numbers], bool], fits: Fits) -> Iterator[Numbers]:
    """Sets with one of several masses or moments of inertia next to nothing, one of several lengths of what stands on a base very long, or
    all that drives very strong; and such as are rough besides.

    What is light may be lifted, or turned round; what is tall, or rough, tips over before it slips.
    """
    open_, usual = letters_open(problem), usual_sizes(problem, fits)
    heavy = [given.name for given in open_ if given.dimension in (kinds.MASS, kinds.INERTIA)]
    acting = {name for action in problem.actions for name in action.strength().symbols()}
    driven = {
        given.name: usual[given.name] * STRONG * swelling(given)
        for given in open_
        if given.dimension in DRIVING or (given.name in acting and not measures(given))
    }
    long = [given.name for given in open_ if given.dimension == kinds.LENGTH] if has_base(problem) else []
    changes = [{name: usual[name] / LIGHT} for name in heavy if len(heavy) > 1] + ([driven] if driven else [])
    changes += [{name: TALL * max(usual[one] for one in long)} for name in long if len(long) > 1]
    coefficients = [given.name for given in open_ if given.dimension == kinds.NONE]
    rough = {name: ROUGH for name in coefficients if admitted(with_givens(problem, {**usual, name: ROUGH}))}
    for change in (*changes, *({**change, **rough} for change in changes if rough)):
        sizes = {**usual, **change}
        yield with_givens(problem, {letter: in_few_digits(size) for letter, size in sizes.items()})


def has_base(problem: Problem) -> bool:
    """Whether a body with corners lies on something."""
    lying = {item.lying() for item in problem.connections if is_touch(item)}
    bodies = (body for body in problem.bodies if body.name in lying)
    return any(shape_of(one).outline() for body in bodies for one in (body, *(part.body for part in body.parts)))


def measures(given: Given) -> bool:
    """Whether a letter is a mass, a length, a time, an angle or a number, which drives nothing by itself."""
    return any(given.dimension is None or given.dimension.matches(kind) for kind in MEASURES)


def swelling(given: Given) -> float:
    """By how much more still what makes a force grow with the time has to be: it falls √(L/g) long, and that is short beside seconds."""
    return 1.0 if given.dimension is None else GRAVITY ** max(0.0, -float(given.dimension.time) / 2 - 1.0)


def far_from_each_other(problem: Problem, answers: Sequence[Answer], sets: Sequence[Numbers]) -> Iterator[Numbers]:
    """The sets of a case, the one that is next to an edge first, then each time the one that is farthest from those before."""
    names = [given.name for given in letters_open(problem)]

    def room(numbers: Numbers) -> float:
        held = [case for case in cases_at(answers, numbers) if case is not None]
        conditions = [one for case in held for one in case.conditions if not takes_integral(one)]
        spares = [spare(condition, numbers) for condition in conditions]
        return min((one for one in spares if one > EDGE), default=1.0)

    places = [tuple(math.log(numbers[name]) for name in names) for numbers in sets]
    near = [math.inf] * len(sets)
    now = min(range(len(sets)), key=lambda index: room(sets[index]))
    while near[now] > 0.0:
        yield sets[now]
        near = [min(one, math.dist(place, places[now])) for one, place in zip(near, places, strict=True)]
        now = max(range(len(sets)), key=near.__getitem__)


def near_edges(
    problem: Problem, answers: Sequence[Answer], points: Sequence[Mapping[str, Fraction | float]]
) -> Iterator[Numbers]:
    """The numbers of cases, with one letter so much larger or smaller that a condition only just holds."""
    letters = {given.name for given in letters_open(problem) if given.dimension != kinds.ANGLE}  # those stay acute
    done: list[Equality] = []
    for point in points:
        numbers = within_case(problem, answers, point)
        known = with_givens(problem, numbers)
        cases = [case for answer in answers if (case := holding(answer, known)) is not None]
        for condition in (one for case in cases for one in case.conditions):
            if condition not in done and len(done) < EDGES:
                done.append(condition)
                names = sorted((condition.left.symbols() | condition.right.symbols()) & letters)
                ways = ((name, factor) for name in names for factor in (2.0, 0.5))
                near = (near_edge(problem, condition, numbers, name, factor) for name, factor in ways)
                yield from islice(filter(None, near), 1)


def rough_enough(problem: Problem, answers: Sequence[Answer]) -> Iterator[Numbers]:
    """Numbers far beyond the limits with a coefficient of friction only just so large that all answers hold: of what is asked at a state
    it tells nothing that friction needs more on the way there."""
    drawn = sizes_of_letters(problem)
    told = [size for item in problem.connections if is_touch(item) and (size := item.grip().static) is not None]
    rough = {name for size in told for name in size.symbols()} & {given.name for given in drawn.letters}
    for name in sorted(rough) if any(several.conditions for several in answers) else ():
        for number in range(1, ROUGH_SETS + 1):
            sizes = drawn.drawn(number, WIDE)

            def holds_with(size: float, sizes: Numbers = sizes, name: str = name) -> bool:
                return None not in cases_at(answers, with_givens(problem, {**sizes, name: size}))

            low, high = 0.0, next((size for size in SLIPPERY if holds_with(size)), 0.0)
            for _ in range(CLOSER if high else 0):
                middle = (low + high) / 2
                low, high = (low, middle) if holds_with(middle) else (middle, high)
            if high:
                sizes = {letter: in_few_digits(size) for letter, size in {**sizes, name: high * (1.0 + EDGE)}.items()}
                yield with_givens(problem, sizes)


def on_edges(
    problem: Problem, answers: Sequence[Answer], points: Sequence[Mapping[str, Fraction]]
) -> Iterator[Numbers]:
    """Numbers with which a condition that holds on its edge too holds only there: the letter that it tells is what it is compared with."""
    open_ = {given.name for given in letters_open(problem)}
    starts = [*sets_of_numbers(problem), *(within_case(problem, answers, point) for point in points)]
    done: list[object] = []
    for case in (case for answer in answers for case in (answer, *answer.otherwise)):
        for one in case.conditions:
            letter, limit = one.left, one.right
            edge = (
                (one, case.conditions) if one.relation == "=" else limit
            )  # what holds only there is seen nowhere else
            if one.relation not in CLOSED or not isinstance(letter, Symbol) or letter.name not in open_ or edge in done:
                continue
            for start in starts:
                size = size_of_limit(limit, start)
                numbers = with_givens(problem, {**start, letter.name: size})
                if size > 0 and all(holds(condition, numbers) for condition in case.conditions) and len(done) < EDGES:
                    done.append(edge)
                    yield numbers
                    break


def size_of_limit(value: Formula, numbers: Numbers) -> float:
    """The number of a formula; 0 where it has none."""
    try:
        return float(value_of(value, numbers))
    except (NotConfirmed, ArithmeticError, ValueError):
        return 0.0


def near_edge(problem: Problem, condition: Equality, numbers: Numbers, name: str, factor: float) -> Numbers | None:
    """Numbers with which a condition holds just enough, and with one letter a hundredth further does not; None without an edge that way."""

    def at(size: float) -> Numbers:
        return with_givens(problem, {**numbers, name: size})

    inside = numbers[name]
    further = (inside * factor**step for step in range(1, STEPS))
    outside = next((size for size in further if spare(condition, at(size)) < EDGE), None)
    if outside is None:
        return None
    for _ in range(CLOSER):
        middle = in_few_digits((inside + outside) / 2)
        inside, outside = (inside, middle) if spare(condition, at(middle)) < EDGE else (middle, outside)
    return at(inside)


def with_givens(problem: Problem, drawn: Numbers) -> Numbers:
    """Numbers of letters with those of the givens."""
    numbers = dict(drawn)
    for given in problem.givens:
        if given.value is not None:
            try:
                numbers[given.name] = float(value_of(given.value, {**problem.values, **numbers}))
            except (NotConfirmed, ZeroDivisionError, OverflowError):
                continue
    return numbers


def in_few_digits(number: float) -> float:
    """A number as a page tells it: what it says of numbers has been tried with these."""
    return float(f"{number:.{DIGITS}g}")


def within_case(problem: Problem, answers: Sequence[Answer], point: Mapping[str, Fraction | float]) -> Numbers:
    """The numbers of a point, or, where they are next to an edge, of one beside it that is further inside its case."""
    exact = {name: float(size) for name, size in point.items()}
    own = cases_at(answers, with_givens(problem, exact))

    def room(numbers: Numbers) -> float:
        known = with_givens(problem, numbers)
        conditions = [condition for case in own if case is not None for condition in case.conditions]
        inside = all(map(is_, cases_at(answers, known), own))
        return min((spare(condition, known) for condition in conditions), default=1.0) if inside else 0.0

    letters = [given.name for given in letters_open(problem) if given.dimension != kinds.ANGLE and given.name in exact]
    beside = [exact, *({**exact, name: exact[name] * factor} for name in letters for factor in (2.0, 0.5))]
    sets = [{name: in_few_digits(size) for name, size in numbers.items()} for numbers in beside]
    best = sets[0] if room(sets[0]) >= ROOM else max(sets, key=room)
    return best if room(best) else exact


def cases_at(answers: Sequence[Answer], numbers: Numbers) -> list[Answer | None]:
    """Of each answer the case that the numbers are of."""
    return [holding(answer, numbers) for answer in answers]


def holding(answer: Answer, numbers: Numbers) -> Answer | None:
    """The answer of the case that the numbers are of."""
    for one in (answer, *answer.otherwise):
        if all(holds(condition, numbers) for condition in sorted(one.conditions, key=takes_integral)):
            return one
    return None


def takes_integral(condition: Equality) -> bool:
    """Whether a condition holds an integral, which takes long to work out."""
    return condition.left.holds(Integral) or condition.right.holds(Integral)


def holds(condition: Equality, numbers: Numbers) -> bool:
    """Whether a condition holds by a margin at the numbers; not where it speaks of what has none."""
    try:
        left, right = (float(value_of(side, numbers)) for side in (condition.left, condition.right))
    except (NotConfirmed, ArithmeticError, ValueError):
        return False
    return related(left, condition.relation, right)


def spare(condition: Equality, numbers: Numbers) -> float:
    """By how much of the largest of the terms that it compares a condition holds; 0 where it does not."""
    sides = [side.terms if isinstance(side, Sum) else (side,) for side in (condition.left, condition.right)]
    try:  # each term once: one that is an integral takes long
        left, right = ([float(value_of(term, numbers)) for term in terms] for terms in sides)
    except (NotConfirmed, ArithmeticError, ValueError):
        return 0.0
    if not related(math.fsum(left), condition.relation, math.fsum(right)):
        return 0.0
    return abs(math.fsum(left) - math.fsum(right)) / (max(map(abs, (*left, *right))) or 1.0)
