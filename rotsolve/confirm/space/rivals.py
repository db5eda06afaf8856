"""Rivals: other numbers of what is put in with which a steady scene moves too, so that an answer that fits need not be the only one.

They are looked for along the whole range of the letter: of an angle once round, from −180° to 180°, of others over some powers of ten on
both sides of 0. A body that stands upright (sin θ = 0) does not precess: it counts only where no other number fits.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from functools import partial
from itertools import chain, pairwise

from msgspec.structs import replace

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.units.dimension import ANGLE, ANGULAR_VELOCITY, VELOCITY
from rotsolve.confirm import NotConfirmed, Unfit
from rotsolve.confirm.course.scan import Scan, places_beside
from rotsolve.confirm.numbers import value_of
from rotsolve.confirm.space.hearing import VERGES, Hearing
from rotsolve.confirm.space.inquiry import Inquiry
from rotsolve.language.limited import letters_of_places, limited_letters
from rotsolve.language.problem import EXTREMES, Find, Given, Problem

ROUND = 24  # places at which an angle is looked at
DECADES, EACH = 2, 4  # powers of ten to both sides of a number, and places in each
STEPS = 30  # of the search between two places
SAME = 1e-6
NOTHING = 1e-9  # of the answer
LESS = 1e-2  # of the gap a step away
FITS = 1e-8  # of what is left over between two places
UPRIGHT = 1e-7
BEYOND = {"largest": 1.0, "smallest": -1.0}  # the sense in which there is to be none
STEPPED = 0.01  # share of a number by which it is changed to see how much is then left over

Left = Callable[[float], "list[float]"]


def beside_under_condition(hearing: Hearing, find: Find, own: float, roots: tuple[Formula, ...]) -> tuple[str, str]:
    """What is said where another number of a letter fulfils its condition too, and where one against the sense of a size does; else ''."""
    if find.where is None or find.where.word in (*VERGES, *EXTREMES) or not isinstance(find.formula, Symbol):
        return "", ""
    from rotsolve.confirm.course.rivals import SoughtLetter
    from rotsolve.confirm.space.verge import gap_under, step_to

    given = next(given for given in hearing.problem.givens if given.name == find.formula.name)
    gap = gap_under(find.where, partial(hearing.with_letter, given.name))

    def reach(value: float) -> tuple[float, None] | None:
        with suppress(NotConfirmed, Unfit, ArithmeticError, ValueError):
            return gap(value), None
        return None

    def fulfils(value: float) -> bool:
        with suppress(NotConfirmed, Unfit, ArithmeticError, ValueError):
            near = abs(step_to(gap, value) - value) <= SAME * max(abs(value), abs(own))
            return near and abs(gap(value)) <= LESS * abs(
                gap(value + STEPPED * own)
            )  # no pole, where a step is short too
        return False

    if given.dimension is None and fulfils(own + math.tau):  # so it is an angle
        given = replace(given, dimension=ANGLE)
    rate = find.modifier in EXTREMES and is_rate(given)
    sought = SoughtLetter(find, given, hearing.known, own, find.group, roots, signed=rate)
    places = places_beside(own, 1.0, given.dimension, ROUND)
    places += [-place for place in places] if rate else []
    angle = given.dimension is not None and given.dimension.matches(ANGLE)
    mirrored = (-own,) if is_rate(given) else (math.pi - own,) if angle else ()  # as high on the other side of the top
    others = chain(sought.other_roots(), mirrored, Scan(reach, own).roots(places))
    sure = (0.0 if abs(value) <= NOTHING * abs(own) else value for value in chain((0.0,), others))
    none = given.name in limited_letters(hearing.problem)  # its key lets it be no 0
    beside = next((value for value in sure if sought.may_be(value) and (value or not none) and fulfils(value)), None)
    if beside is not None or not sought.sized:
        return ("" if beside is None else sought.said_beside(beside)), ""
    if none:
        return "", ""  # nor one of the other sense
    against = chain(sought.other_roots(), mirrored, Scan(reach, own).roots([-place for place in places]))
    found = next((value for value in against if sought.may_be(value, sized=False) and fulfils(value)), None)
    return "", "" if found is None else sought.equal_to(found)


def fits_as_asked(hearing: Hearing, find: Find, own: float, roots: tuple[Formula, ...]) -> bool | None:
    """Whether an answer that fits is the one that is asked for among all that do; None where nothing tells which is meant.

    Of what is not steady the other roots of its equation are looked at alone: to follow it at each place would take long.
    """
    if len(hearing.places) > 1 and not steady_somewhere(hearing):
        from rotsolve.confirm.space.together import as_good

        return None if as_good(hearing, find, own) else True
    if not steady_somewhere(hearing):
        untold = find.modifier in EXTREMES and not followed_nowhere(hearing.problem)
        if untold and not none_farther(hearing, find, own, roots):
            return None
        return None if another_root_fits(hearing, find, own, roots) else True
    if len(hearing.places) != 1:
        return True
    place = hearing.places[0]
    least = 1.0 if hearing.is_angle(place) else 0.0
    found = [own, *(root for root in others(hearing, own) if abs(root - own) > SAME * max(abs(own), abs(root), least))]
    if not (rate_or_angle(hearing, place) or by_value(hearing, find, place)) and own > 0:
        found = [root for root in found if root > 0]
    tilts = [tilt_with(hearing, place, root) for root in found]
    standing = [k for k, tilt in enumerate(tilts) if tilt is None or -UPRIGHT < tilt < math.pi + UPRIGHT]
    leaning = [k for k in standing if (tilt := tilts[k]) is None or abs(math.sin(tilt)) > UPRIGHT]
    left = [found[k] for k in leaning or standing]
    if own not in left or any(turns_between(hearing, root, own) for root in left):
        return False
    if len(left) == 1:
        return True
    on_hinge = hearing.is_angle(place) and all(
        tilt is None for tilt in tilts
    )  # a half turn off it hangs the other way round
    if len(left) == 2 and own > 0 and abs(sum(left)) <= SAME * own and find.modifier not in EXTREMES and not on_hinge:
        return True  # one motion, seen from both sides
    word = find.modifier or next((term.modifier for term in find.terms), "")
    if word not in EXTREMES:
        return None
    return own == (min if word == "smallest" else max)(left)


def beside_untested(hearing: Hearing, find: Find, own: float, roots: tuple[Formula, ...]) -> str:
    """What is said of a letter that no equation tests where another root of its own equation may be meant as well; else ''."""
    given = next((given for given in hearing.problem.givens if find.formula == Symbol(given.name)), None)
    if given is None or find.modifier in EXTREMES or len(hearing.letters) > 1:  # what else is sought may forbid it
        return ""
    from rotsolve.confirm.course.rivals import SoughtLetter

    sought = SoughtLetter(find, given, hearing.known, own, find.group, roots)
    value = next(
        (root for root in filter(sought.may_be, sought.other_roots()) if slants(hearing, given.name, root)), None
    )
    if value is None:
        return ""
    return f"{given.name}{sought.equal_to(value)}: ask for `smallest {given.name}` or `largest {given.name}`"


def against_as_well(hearing: Hearing, find: Find, own: float, roots: tuple[Formula, ...]) -> str:
    """What is said of an angle that no motion tells, with which to the other side all equations hold too, and of a size or a place with a
    value of the other sign; else ''."""
    letter = hearing.letter(find)
    if letter is None or find.modifier == "largest" or by_value(hearing, find, letter):
        return ""
    if steady_somewhere(hearing) and letter not in letters_of_places(hearing.problem):
        return ""
    from rotsolve.confirm.course.rivals import SoughtLetter

    given = next(given for given in hearing.problem.givens if given.name == letter)
    sought = SoughtLetter(find, given, hearing.known, own, find.group)
    if len(hearing.places) > 1:
        from rotsolve.confirm.space.together import against_its_sense

        other = against_its_sense(hearing, letter, own)
        return "" if other is None else sought.equal_to(other)
    if not hearing.is_angle(letter):
        values = other_values(hearing, letter, own, roots) if may_be_against(hearing, letter, own) else ()
        found = next((value for value in values if value < 0.0), None)
        return "" if found is None else sought.equal_to(found)
    if find.modifier in EXTREMES or not followed_nowhere(hearing.problem) or abs(math.sin(own)) <= UPRIGHT:
        return ""
    return sought.equal_to(-own) if leaves_nothing(hearing, letter, -own) else ""


def may_be_against(hearing: Hearing, letter: str, own: float) -> bool:
    """Whether a letter that is told as positive may be negative too: a place, a force; no rate, which goes by value, and no size that its
    key keeps positive."""
    return own >= 0.0 and not rate_or_angle(hearing, letter) and letter not in limited_letters(hearing.problem)


def steady_somewhere(hearing: Hearing) -> bool:
    """Whether a state is a steady motion, which is the same seen from behind where all rates have other signs; of balance, in which nothing
    moves, an angle alone is looked at as there."""
    angle = len(hearing.places) == 1 and hearing.is_angle(hearing.places[0])
    return any(state.steady and (angle or not state.balance) for state in hearing.problem.states)


def is_rate(given: Given) -> bool:
    """Whether a letter is an angular velocity: of a swing either sense is a motion of its own."""
    return given.dimension is not None and given.dimension.matches(ANGULAR_VELOCITY)


def by_value(hearing: Hearing, find: Find, place: tuple[str, str, str] | str) -> bool:
    """Whether the largest or the smallest of a place is asked, which may be negative."""
    return find.modifier in EXTREMES and place in letters_of_places(hearing.problem)


def another_root_fits(hearing: Hearing, find: Find, own: float, roots: tuple[Formula, ...]) -> bool:
    """Whether the equations of all bodies leave nothing over with another value of a letter, that is not beyond its range: another root of
    its equation, or any that is found over the range where nothing has to be followed."""
    (place, *more), givens = hearing.places, {given.name: given for given in hearing.problem.givens}
    if more or not isinstance(place, str):
        return False
    from rotsolve.confirm.course.rivals import SoughtLetter

    rate = is_rate(givens[place])
    signed = rate or by_value(hearing, find, place)
    sought = SoughtLetter(find, givens[place], hearing.known, own, find.group, roots, signed=signed)
    named = chain(sought.other_roots(), (-own,) if rate else ())
    if any(leaves_nothing(hearing, place, value) for value in filter(sought.may_be, named)):
        return True
    return followed_nowhere(hearing.problem) and any(map(sought.may_be, others(hearing, own)))


def none_farther(hearing: Hearing, find: Find, own: float, roots: tuple[Formula, ...]) -> bool:
    """Whether of a letter on which a motion hangs none is larger, or smaller, as is asked: of a time, and of a rate."""
    from rotsolve.confirm.space.first_times import farthest_time, tells_time

    (letter, *more) = hearing.places
    if more or not isinstance(letter, str) or not tells_time(hearing, letter):
        return farthest_rate(hearing, find, own, roots)
    return farthest_time(hearing, find, letter, own, roots)


def farthest_rate(hearing: Hearing, find: Find, own: float, roots: tuple[Formula, ...]) -> bool:
    """Whether a letter is a rate, and the motion comes with no other root for it, nor with the opposite, to what its state tells, that
    were a larger one, or a smaller, as is asked. Of a place other roots may lie farther on."""
    (place, *more), others = hearing.places, [-own]
    dimension = hearing.dimension(place)
    if more or dimension is None or not any(dimension.matches(kind) for kind in (VELOCITY, ANGULAR_VELOCITY)):
        return False
    for root in roots:
        with suppress(NotConfirmed, ArithmeticError, ValueError, TypeError):
            others.append(float(value_of(root, hearing.known)))
    size = hearing.size(place)
    try:
        most = max(map(abs, hearing.left({0: STEPPED * size})), default=0.0)
        beyond = [value for value in others if (value - own) * BEYOND[find.modifier] > SAME * size]
        return all(misses(hearing, value - own, SAME * most) for value in beyond)
    except (NotConfirmed, Unfit, ArithmeticError, ValueError):
        return False


def misses(hearing: Hearing, change: float, room: float) -> bool:
    """Whether with another value of the only letter that is put in the motion does not come to its state, or more than some room is left
    over."""
    try:
        return max(map(abs, hearing.left({0: change})), default=math.inf) > room
    except Unfit:
        return True


def letter_on_the_way(hearing: Hearing) -> str:
    """The only letter that is put in, where no question asks for it; else ''."""
    (place, *more) = hearing.places or ("",)
    asked = {find.formula for find in hearing.problem.finds if not find.terms}
    told = isinstance(place, str) and place in hearing.known and Symbol(place) not in asked
    return place if isinstance(place, str) and told and not more else ""


def fitting_roots(hearing: Hearing, letter: str, roots: tuple[Formula, ...]) -> Iterator[float]:
    """Other roots for a letter with which the equations of all bodies leave nothing over; of an angle once round."""
    for root in roots:
        with suppress(NotConfirmed, Unfit, ArithmeticError, ValueError, TypeError):
            value = float(value_of(root, hearing.known))
            value = math.remainder(value, math.tau) if hearing.is_angle(letter) else value
            if leaves_nothing(hearing, letter, value):
                yield value


def leaves_nothing(hearing: Hearing, letter: str, value: float) -> bool:
    """Whether the equations of all bodies leave nothing over with another value of the only letter that is put in."""
    with suppress(NotConfirmed, Unfit, ArithmeticError, ValueError):
        most = max(map(abs, hearing.left({0: STEPPED * hearing.size(letter)})), default=0.0)
        return max(map(abs, hearing.left({0: value - hearing.known[letter]})), default=math.inf) <= SAME * most
    return False


def others_on_the_way(
    hearing: Hearing, roots: Callable[[str], tuple[Formula, ...]]
) -> Iterator[tuple[str, dict[str, float], str]]:
    """Other values of letters that are put in where no question asks for them, with which a scene is as good.

    With a rate of the other sense and the same size, and with what is told as positive and is negative, goes what is said of it.
    """
    if len(hearing.places) > 1 and not steady_somewhere(hearing):  # what is steady is looked at in all its motions
        from rotsolve.confirm.space.together import sets_on_the_way

        yield from sets_on_the_way(hearing)
    place = letter_on_the_way(hearing)
    if not place:
        return
    own, free = hearing.known[place], rate_or_angle(hearing, place)
    for value in other_values(hearing, place, own, roots(place)):
        against = value < 0.0 <= own and not free
        if (against and not may_be_against(hearing, place, own)) or not slants(hearing, place, value):
            continue
        behind = against or (not hearing.is_angle(place) and abs(value + own) <= SAME * abs(own))
        yield place, {place: value}, f": {place} = {value:g} in SI units makes it so too" if behind else ""


def other_values(hearing: Hearing, letter: str, own: float, roots: tuple[Formula, ...]) -> Iterator[float]:
    """Other values of the only letter that is put in with which the equations of all bodies leave nothing over: where nothing has to be
    followed all that it may be are looked at, else other roots of its equation."""
    angle = hearing.is_angle(letter)
    for value in others(hearing, own) if followed_nowhere(hearing.problem) else fitting_roots(hearing, letter, roots):
        near = math.remainder(value - own, math.tau) if angle else value - own
        if abs(near) > SAME * max(abs(own), abs(value)):
            yield value


def followed_nowhere(problem: Problem) -> bool:
    """Whether nothing has to be followed in time: a scene of one moment, or of the moments around events."""
    joined = {(event.from_, event.to) for event in problem.events}
    names = [state.name for state in problem.states]
    return all(pair in joined for pair in pairwise(names))


def others(hearing: Hearing, own: float) -> Iterator[float]:
    """The numbers, beside one, with which the equations of all bodies leave nothing over."""
    angle, place = hearing.is_angle(hearing.places[0]), hearing.places[0]

    def left(value: float) -> list[float]:
        with suppress(NotConfirmed, Unfit, ArithmeticError, ValueError):
            return hearing.left({0: value - own})
        return []

    if angle:
        low = 0.0 if not isinstance(place, str) else -math.pi
        whole = ROUND + isinstance(place, str)  # of a letter once round, up to where it began
        places = [low + (math.pi - low) * (number + 0.37) / ROUND for number in range(whole)]
    else:
        sizes = sizes_around(abs(own), hearing.usual(hearing.dimension(place)))
        places = [-size * 1.003 for size in reversed(sizes)] + [size * 1.003 for size in sizes]
    yield from roots_between(left, places)


def sizes_around(own: float, usual: float) -> list[float]:
    """Sizes some powers of ten below and above a number and what is usual in a scene."""
    low, high = min(own or usual or 1.0, usual or own or 1.0), max(own, usual) or 1.0
    steps = math.ceil((math.log10(high / low) + 2 * DECADES) * EACH)
    return [low * 10 ** (number / EACH - DECADES) for number in range(steps + 1)]


def roots_between(left: Left, places: Sequence[float]) -> Iterator[float]:
    """Where all that is left over is nothing, between places at which the largest part of it has different signs."""
    columns = [left(place) for place in places]
    count = max(map(len, columns), default=0)
    sizes = [max((abs(c[n]) for c in columns if len(c) == count), default=0.0) for n in range(count)]
    if not sizes or not max(sizes):
        return
    part = max(range(count), key=sizes.__getitem__)
    for (a, low), (b, high) in pairwise(zip(places, columns, strict=True)):
        if len(low) != count or len(high) != count or low[part] * high[part] > 0:
            continue
        room = max(abs(x) for x in (*low, *high))
        f, g = low[part], high[part]
        for _ in range(STEPS):  # false position, by the Illinois rule
            middle = (a * g - b * f) / (g - f) if g != f else (a + b) / 2
            here = left(middle)
            if len(here) != count:
                break
            if max(map(abs, here)) <= FITS * room:
                yield middle
                break
            if here[part] * g < 0:
                a, f = b, g
            else:
                f /= 2
            b, g = middle, here[part]


def turns_between(hearing: Hearing, root: float, own: float) -> bool:
    """Whether an answer is an angle beyond ±180°, whole turns from another number that fits as well."""
    if not hearing.is_angle(hearing.places[0]) or abs(own) <= math.pi + UPRIGHT:
        return False
    turns = (own - root) / (2 * math.pi)
    return round(turns) != 0 and abs(turns - round(turns)) < SAME


def rate_or_angle(hearing: Hearing, place: tuple[str, str, str] | str) -> bool:
    """Whether what is put in may be negative: no mass, length or their like."""
    dimension = hearing.dimension(place)
    return dimension is None or any(dimension.matches(kind) for kind in (ANGLE, ANGULAR_VELOCITY))


def slants(hearing: Hearing, letter: str, value: float) -> bool:
    """Whether a steady state with a number for its tilt does not stand upright, nor upside down; so does one that tells none by that."""
    tilt = tilt_with(hearing, letter, value)
    return tilt is None or UPRIGHT < tilt < math.pi - UPRIGHT


def tilt_with(hearing: Hearing, place: tuple[str, str, str] | str, value: float) -> float | None:
    """The tilt that a steady state tells by what is put in; None where it tells none by that."""
    if not isinstance(place, str):
        return value
    rig = Inquiry(hearing.problem, {**hearing.known, place: value}, hearing.told).rig
    lines = [line for state in hearing.problem.states if state.steady for line in state.conditions]
    tilts = (line.value for line in lines if line.path is not None and line.path.quantity == "tilt")
    return next((rig.value(tilt) for tilt in tilts if tilt is not None and place in tilt.symbols()), None)
