"""Consistency: whether everything that the laws write holds at the answers, also what no plan used.

A scene that says too much (a state that is never reached, a block that sticks yet is said to fall) shows here.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.certified.ball import Precision, decided_by_size, evaluate, note, watched
from rotsolve.algebra.certified.balls import Ball, RealBalls, Undefined
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.flints import arb
from rotsolve.algebra.formula import ONE, ZERO, Formula, Integral, Power, Quotient, Sum, Symbol, call
from rotsolve.algebra.units.dimension import ANGLE
from rotsolve.core.equation import CONDITION, FOUND, SEPARATED_BY_PLACE, STEADY_TRAVEL, STEADY_TURN, Equation, Law
from rotsolve.core.symbols import CONSTANT, POSITION, RATE, TIME, at_any_time, has_quantities, is_key
from rotsolve.motion.timeline import Interval
from rotsolve.search.search import Search
from rotsolve.search.within import seeks

if TYPE_CHECKING:
    from rotsolve.core.passage import Passage, Travel

TOLERANCE = 1e-6  # data of a few figures may disagree in the last ones
DIGITS = 60  # of what has no closed form
BITS = 256  # working precision: what is lost where large numbers nearly cancel leaves enough of it
NOTHING = 2.0 ** (-BITS // 2)  # share of its terms below which a sum counts as 0
ABOUT = 1e-12  # share within which a root is known that has no closed form
LEFT_OVER = 1e-30  # below which a number is nothing
ROUNDS = 8
FORWARDS = Law("time runs forwards", "time runs forwards")


def contradiction(search: Search) -> tuple[Equation | None, KnownBalls]:
    """The first equation that can not hold with what is known and found, or that time would have to run backwards; or None.

    With it come the numbers that were found.
    """
    with Precision(BITS):
        numbers = KnownBalls.known(search)
        broken = impossible_in_time(search, numbers)
        if broken is None and (squares := squares_alone(search, numbers)):
            broken = impossible_square(squares, search, numbers) or impossible_in_time(search, numbers)
        return broken, numbers


def impossible_in_time(search: Search, numbers: KnownBalls) -> Equation | None:
    """The first equation that can not hold, or that time would have to run backwards, or a body to turn back before an end."""
    return first_broken(search, numbers) or backwards(search, numbers) or too_far(search, numbers)


def squares_alone(search: Search, numbers: KnownBalls) -> dict[str, Equation]:
    """The letters of which the answers needed the square alone, v² = 2 g h, which may be no square of a real number."""
    found = {}
    for equation in search.planner.pool:
        base = equation.left.base if isinstance(equation.left, Power) else None
        if equation.law == FOUND and isinstance(base, Symbol) and base.name not in numbers.found:
            found[base.name] = equation
    return found


def impossible_square(squares: Mapping[str, Equation], search: Search, numbers: KnownBalls) -> Equation | None:
    """The first square that is negative; the numbers of the others' letters are found with it."""
    for name, equation in squares.items():
        square = told_square(equation.right, search)
        side = None if square is None else search.numbers.side(square)
        if side == -1:
            return equation
        rate = rate_of_square(name, square, search) if square is not None and side == 1 else None
        size = arb(0) if side == 0 else None if rate is None else numbers.size(rate)
        numbers.found.update({} if size is None else {name: size})
    return None


def told_square(square: Formula, search: Search) -> Formula | None:
    """A square with the answers put in; None where it has no closed form, or none that could be printed as a condition."""
    try:
        value = search.solver.carried_out(search.solver.with_found(square))
    except (Undefined, ZeroDivisionError):
        return None
    if search.signs.trials:
        from rotsolve.search.letterspace import LONGEST

        if length(value) > LONGEST:
            return None
    return None if value.holds(Integral) or has_quantities(value) else value


def rate_of_square(name: str, square: Formula, search: Search) -> Formula | None:
    """The rate of a square that is positive, with the sign of the way in which the body goes there."""
    from rotsolve.search.roots import RootChoice

    roots = [call("sqrt", square), -call("sqrt", square)]
    choice = RootChoice(search.scene, search.givens, search.numbers, search.definitions.formula)
    picked = choice.choose(name, roots)
    return None if picked is None else roots[picked.root]


def agreeing(name: str, roots: Sequence[Formula], search: Search) -> list[int]:
    """The roots for a letter with which everything else can hold, of these the ones that time can bring about; all where none is left."""
    with Precision(BITS):
        numbers = KnownBalls.known(search)
        holding, timely = list[int](), list[int]()
        for number, root in enumerate(roots):
            size = numbers.size(search.solver.with_found(root))
            if size is not None:
                trial = replace(numbers, found={**numbers.found, name: size})
                trial.found.update(on_the_way(name, search, trial))
                fits = first_broken(search, trial) is None and not negative_size(search, trial)
                holding += [number] if fits else []
                timely += [] if untimely(search, trial) else [number]
    both = [number for number in holding if number in timely]
    return both or holding or timely or list(range(len(roots)))


def negative_size(search: Search, numbers: KnownBalls) -> bool:
    """Whether an unknown of the scene would be what it can not be, such as a negative mass."""
    from rotsolve.motion.limits import limits_of_scene

    asked = search.scene.configuration.problem.sought
    limits = (limit for limit in limits_of_scene(search.scene.configuration) if limit.gap.symbols() & asked)
    return any(size is not None and size < 0 for size in (numbers.size(limit.gap) for limit in limits))


def roots_with_values(name: str, roots: Sequence[Formula], search: Search, *, plain: bool) -> list[int]:
    """The roots with which no size is negative, or where it is looked at with care those that all laws allow; of what a condition sets to
    a value those at which that has one."""
    fitting = (with_sizes if plain else agreeing)(name, roots, search)
    return fitting if search.seeking is None else without_void(name, roots, fitting, search)


def with_sizes(name: str, roots: Sequence[Formula], search: Search) -> list[int]:
    """The roots for an angle that is sought with which no size sought beside it, as that of a force, is negative; all where none is."""
    asked = {given.name: given.dimension for given in search.givens.values() if given.asked}
    sizes = [letter for letter, kind in asked.items() if kind is not None and not kind.matches(ANGLE)]
    if name not in asked or not sizes or not search.may_be_angle(name):
        return list(range(len(roots)))
    left = []
    with Precision(BITS):
        numbers = KnownBalls.known(search)
        for number, root in enumerate(roots):
            size = numbers.size(search.solver.with_found(root))
            trial = numbers if size is None else replace(numbers, found={**numbers.found, name: size})
            trial.found.update(on_the_way(name, search, trial))
            first_broken(search, trial)  # what the equations then tell of the sizes
            left += [] if any(one in trial.found and trial.found[one] < 0 for one in sizes) else [number]
    return left or list(range(len(roots)))


def without_void(name: str, roots: Sequence[Formula], fitting: Sequence[int], search: Search) -> list[int]:
    """The roots of those that fit at which what a question sets to a value, `x where f/N = c`, has one: with f = c N nothing over nothing
    would be it too."""
    numbers = KnownBalls.known(search)
    limits = [item for item in search.planner.pool if item.law == CONDITION]
    below = [search.solver.with_found(part) for limit in limits for part in divisors(limit.left)]
    below = [part for part in below if name in part.symbols() and not has_quantities(part)]
    if not below:
        return list(fitting)
    left = []
    for number in fitting:
        size = numbers.size(search.solver.with_found(roots[number]))
        near = None if size is None else size + arb(0, ABOUT * (1 + abs(size)))
        sizes = [None if near is None else numbers.size(part, **{name: near}) for part in below]
        left += [] if any(one is not None and one.contains(0) for one in sizes) else [number]
    return left


def divisors(value: Formula) -> Iterator[Formula]:
    """What a formula divides by."""
    if isinstance(value, Quotient):
        yield value.denominator
    for child in value.children():
        yield from divisors(child)


def on_the_way(name: str, search: Search, numbers: KnownBalls) -> dict[str, Ball]:
    """The letters that were eliminated on the way to a root, with it put in: ω = c v tells which way a body turns."""
    told = {
        letter: search.solver.with_found(Symbol(letter)) for letter in search.solver.told.keys() - numbers.found.keys()
    }
    sizes = {
        letter: numbers.size(value)
        for letter, value in told.items()
        if name in value.symbols() and not any(is_key(one) for one in value.symbols() - {name})
    }
    return {letter: size for letter, size in sizes.items() if size is not None}


def untimely(search: Search, numbers: KnownBalls) -> bool:
    """Whether the answers are not what time brings about next: a phase that takes none, a way that is not the way in which a body goes
    all along it, bodies that pass through each other where they meet."""
    if any(no_way(passage, numbers) for passage in search.scene.passages.values()):
        return True
    for closing in (closing for encounter in search.scene.encounters.values() for closing in encounter.closings):
        speeds = [numbers.size(speed) for speed in closing.speeds]
        sides = [side_of(speed) for speed in speeds if speed is not None]
        if len(sides) == 2 and sides[0] and sides[1] == -sides[0]:
            return True
    return False


def no_way(passage: Passage, numbers: KnownBalls) -> bool:
    """Whether a phase takes no time, or a way in it is not the one in which its body goes."""
    duration = numbers.size(passage.duration)
    if duration is not None and side_of(duration) in (0, -1):
        return True
    timed = not has_quantities(
        passage.times[1]
    )  # for so long it may go to and fro, as what moves with others may at all times
    fro = {one.body for one in passage.travels if one.pace == POSITION and (timed or one.body in passage.ways)}
    return any(against_its_way(one, numbers) for one in passage.travels if one.body not in fro)


def against_its_way(travel: Travel, numbers: KnownBalls) -> bool:
    """Whether a body has gone the other way, or nowhere, though it moves one way at both ends of a phase, or starts so from rest."""
    ends = [numbers.size(speed) for speed in (travel.before, travel.after)]
    sides = [side_of(speed) for speed in ends if speed is not None]
    change = numbers.size(travel.change)
    way = side_of(change) if change is not None else None
    if len(sides) < 2 or None in sides or way is None or (-1 in sides and 1 in sides):
        return False
    moving = sides[0] or sides[1]
    if not moving and travel.initial is not None:
        push = numbers.size(travel.initial)
        moving = side_of(push) if push is not None else None
    return bool(moving) and way != moving


def just_stops(travel: Travel, search: Search) -> bool:
    """Whether a speed at the end of a phase is zero with the numbers of the case that is looked at, though no state says so."""
    last = search.solver.with_found(travel.after)
    if travel.pace not in (CONSTANT, POSITION) or travel.after == ZERO or has_quantities(last):
        return False
    number = search.signs.at_trial(search.signs.with_asked(last))
    return number is not None and not number.sign


def side_of(number: Ball) -> int | None:
    """The sign of a number, 0 where it is nothing but what precision leaves; None where it is not told."""
    if bool(abs(number).upper() < LEFT_OVER):
        return 0
    return None if number.contains(0) else 1 if number > 0 else -1


def disagreement(search: Search) -> Equation | None:
    """The first equation that can not hold, whichever way time runs; or None."""
    with Precision(BITS):
        return first_broken(search, KnownBalls.known(search))


def first_broken(search: Search, numbers: KnownBalls) -> Equation | None:
    """The first equation that can not hold; what an equation tells of its one unknown serves the next ones."""
    if search.ground is not None:
        search.ground.tried.update(range(len(search.equations)))
    pending = [equation for equation in search.equations if not runs(equation, search)]
    pending += integrated_equations(search)
    pending.sort(key=lambda equation: bool(equation.family))  # a rule that is broken says more than a law
    for _ in range(ROUNDS):
        rest = []
        for equation in pending:
            if numbers.open_letters(equation):
                rest.append(equation)
            elif numbers.clash(equation):
                return equation
        pending, settled = [], len(numbers.found)
        for equation in rest:
            unknown = numbers.open_letters(equation)
            if len(unknown) == 1 and numbers.settle(equation, unknown[0]):
                return equation
            pending.append(equation)
        if len(numbers.found) == settled:
            break
    return None


def integrated_equations(search: Search) -> list[Equation]:
    """What sums an acceleration over a phase, carried out with the one that Newton's laws give at any speed or time, where it has a
    closed form."""
    found = []
    for name, passage in search.scene.passages.items():
        for travel in passage.travels:
            rate = travel.acceleration
            varies = travel.pace == TIME or (travel.leads and travel.pace == RATE)
            if not varies or not isinstance(rate, Symbol):
                continue
            value = search.aside(rate.name)
            for equation in search.scene.equations if value is not None else ():
                if equation.section == name and rate.name in equation.summed():
                    found += without_integrals(equation.renamed({rate.name: value}), search)  # type: ignore[dict-item]
    return found


def without_integrals(equation: Equation, search: Search) -> list[Equation]:
    """An equation with its integrals carried out; nothing where that can not be done, or never comes to an end."""
    try:
        left, right = (search.solver.carried_out(side) for side in (equation.left, equation.right))
    except (Undefined, ZeroDivisionError):
        return []
    done = replace(equation, left=left, right=right)
    return [] if done.summed() else [done]


def backwards(search: Search, numbers: KnownBalls) -> Equation | None:
    """A phase that would take a negative time: its end lies before its start."""
    for name, passage in search.scene.passages.items():
        duration = numbers.size(passage.duration)
        if duration is not None and watched():
            note_duration(passage.duration, search)
        if duration is not None and duration < 0:
            return FORWARDS.equation(passage.duration, ZERO, name)
    return None


def too_far(search: Search, numbers: KnownBalls) -> Equation | None:
    """A way on which a constant acceleration would turn a body back before its end: v₀² + 2 a s < 0."""
    for name, passage in search.scene.passages.items():
        for travel in passage.travels:
            if travel.pace != CONSTANT or not isinstance(travel.after, Symbol) or travel.after.name in numbers.found:
                continue
            start, rate, way = (numbers.size(value) for value in (travel.before, travel.acceleration, travel.change))
            if start is not None and rate is not None and way is not None:
                square, gain = start * start, 2 * rate * way
                if square + gain < -TOLERANCE * (square + abs(gain)):
                    law = STEADY_TURN if travel.kind == "turn" else STEADY_TRAVEL
                    reached = travel.before**2 + 2 * travel.acceleration * travel.change
                    return law.equation(travel.after**2, reached, name, (travel.body,))
    return None


def values_sought_once(search: Search) -> dict[str, Formula]:
    """What the answers make of letters that stand for any value in the laws, of which one question seeks the value: `x where N = P`."""
    symbols = list(seeks(search))
    once = symbols[0] if len(symbols) == 1 else {}
    found = {letter: search.solver.solved.get(symbol) for letter, symbol in once.items() if letter != symbol}
    return {name: item.formula for name, item in found.items() if item is not None and item.formula is not None}


def note_duration(duration: Formula, search: Search) -> None:
    """Tell those who watch that the sign of a duration has decided something: as a formula of the givens, if it has one."""
    value: Formula | None = search.solver.with_found(duration)
    if value is not None and has_quantities(value):
        value = search.apart().settled(value)
    value = None if value is None else value.substitute(values_sought_once(search))
    if value is not None and search.signs.lacking(value):
        search.signs.supposed(value)
    elif value is None:
        decided_by_size()
    else:
        note(value)


def turned_back(search: Search) -> Interval | None:
    """A phase whose time is summed along the way although the motion turns back in it."""
    used = {index for answered in search.answered for index in answered.used}
    timed = {law.section for law in (search.planner.pool[index] for index in used) if law.law == SEPARATED_BY_PLACE}
    for name, passage in search.scene.passages.items():
        for travel in passage.travels if name in timed else ():
            if travel.leads and travel.pace == POSITION and not swings_on(travel, passage, search):
                aside = search.apart()
                speeds = [aside.settled(value) for value in (travel.before, travel.after)]
                sizes = [aside.number(speed) if speed is not None else None for speed in speeds]
                if sizes[0] is not None and sizes[1] is not None and sizes[0] * sizes[1] < 0:
                    return search.scene.configuration.timeline.interval(name)
    return None


def swings_on(travel: Travel, passage: Passage, search: Search) -> bool:
    """Whether a body is followed to and fro up to a told time: the push grows evenly with the place, so that sine and cosine go on."""
    rate = search.aside(travel.acceleration.name) if isinstance(travel.acceleration, Symbol) else None
    if rate is None or not isinstance(travel.coordinate, Symbol) or has_quantities(passage.times[1]):
        return False
    return travel.coordinate.name not in differentiate(rate, travel.coordinate.name).symbols()


def runs(equation: Equation, search: Search) -> bool:
    """Whether an equation is about any moment of a phase, or sums over one."""
    sides = (equation.left, equation.right)
    letters = equation.symbols()
    return bool(search.running & letters) or at_any_time(letters) or any(side.holds(Integral) for side in sides)


class KnownBalls(Struct, frozen=True):
    """Balls of all letters that have a number: the givens, and the letters of the laws as they are found."""

    found: dict[str, Ball]
    values: Mapping[str, Formula]
    free: frozenset[str] = frozenset()  # givens without a number, which have that of their case
    sought: frozenset[str] = frozenset()  # givens that are unknown

    @staticmethod
    def known(search: Search) -> KnownBalls:
        """What the search found, also on the way to the answers; givens without a number, and a sought one in the case of its value, have
        that of the case that is looked at."""
        solver = search.solver
        letters = {name: found.formula for name, found in solver.solved.items() if found.formula is not None}
        for name in solver.told.keys() - letters.keys():
            value = solver.with_found(Symbol(name))
            if not has_quantities(value):
                letters[name] = value
        open_ = [given for given in search.givens.values() if given.value is None and not given.asked]
        free = {given.name: ONE if given.trial is None else given.trial for given in open_}
        sought = frozenset(given.name for given in search.givens.values() if given.asked)
        settled = values_sought_once(search)
        letters = {name: value.substitute(settled) for name, value in letters.items()} | settled
        values = {name: value for name, value in {**free, **search.values}.items() if name not in settled}
        numbers = KnownBalls({}, values, frozenset(free), sought)
        supposed = {
            given.name: given.trial for given in search.givens.values() if given.asked and given.trial is not None
        }
        sizes = {name: numbers.size(value) for name, value in {**supposed, **letters}.items()}
        numbers.found.update((name, size) for name, size in sizes.items() if size is not None)
        together = [(name, found.number) for name, found in solver.solved.items() if found.number is not None]
        numbers.found.update((name, number.refine(DIGITS)) for name, number in together)
        return numbers

    def open_letters(self, equation: Equation) -> list[str]:
        """Letters of the laws, and unknown givens, in an equation that have no value yet."""
        names = (name for name in equation.symbols() if is_key(name) or name in self.sought)
        return sorted(name for name in names if name not in self.found)

    def size(self, value: Formula, **more: Ball) -> Ball | None:
        """A ball that holds the number; None where a letter has none, or it is not real."""
        return self._size(value, RealBalls(self.values, bound={**self.found, **more} if more else self.found))

    def _size(self, value: Formula, balls: RealBalls) -> Ball | None:
        try:
            ball = evaluate(value, self.values, digits=10).ball if value.holds(Integral) else balls(value)
        except (Undefined, ZeroDivisionError):
            return None
        return ball if ball.is_finite() else None

    def clash(self, equation: Equation, **more: Ball) -> bool:
        """Whether both sides are numbers that certainly differ."""
        gap = self.gap(equation, **more)
        return gap is not None and bool(gap[0] > TOLERANCE * gap[1])

    def gap(self, equation: Equation, **more: Ball) -> tuple[Ball, Ball] | None:
        """By how much both sides differ, and how large their terms are; None where one is no number."""
        balls, sides, scale = RealBalls(self.values, bound={**self.found, **more}), [], arb(0)
        for side in (equation.left, equation.right):
            terms: list[Ball] = [size for term in addends(side) if (size := self._size(term, balls)) is not None]
            if len(terms) < len(addends(side)):
                return None
            sides.append(sum(terms[1:], terms[0]))
            scale = max(scale, *(abs(size).upper() for size in (sides[-1], *terms)))
        return abs(sides[0] - sides[1]), scale

    def settle(self, equation: Equation, name: str) -> bool:
        """Find the one unknown of an equation that is linear in it; whether it drops out and leaves two numbers that differ: 2 = 0 t."""
        gap = equation.left - equation.right
        slope = differentiate(gap, name)
        rate, rest = self.size(slope), self.size(gap, **{name: arb(0)})
        if name in slope.symbols() or rate is None:
            return False
        if rate.contains(0):
            terms = [abs(size) for term in addends(slope) if (size := self.size(term)) is not None]
            vanishes = rate.is_zero() or abs(rate).upper() <= NOTHING * max(terms, default=arb(0)).upper()
            return vanishes and self.clash(equation, **{name: arb(1)})
        if rest is not None:
            self.found[name] = -rest / rate
        return False


def addends(value: Formula) -> tuple[Formula, ...]:
    """The terms of a sum, by whose size its roundings count; of a product nothing but itself: its factors have other units."""
    return value.terms if isinstance(value, Sum) else (value,)
