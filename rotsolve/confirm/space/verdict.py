"""Verdict in space: the answers of a scene in space held against the assembly: the same, something else, or not confirmed and why."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from fractions import Fraction

from msgspec.structs import replace

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.confirm import NotConfirmed, TooFar, Unfit
from rotsolve.confirm.course.samples import Numbers, holding, sets_of_numbers, sets_wanted, with_givens
from rotsolve.confirm.course.scans import Scans
from rotsolve.confirm.course.sizes import letters_open
from rotsolve.confirm.numbers import options_that_hold, value_of
from rotsolve.confirm.space.hearing import Hearing, Put, answers_put_in
from rotsolve.confirm.space.motions import SEVERAL
from rotsolve.confirm.space.rig import NOW
from rotsolve.confirm.verdicts import (
    NO_CASE,
    NO_NUMBER,
    OTHERWISE,
    Solved,
    asked_letters,
    both_sets,
    closely_valued,
    not_so,
    numbers_told,
    said_of,
)
from rotsolve.core.derivation import Answer, AnswerConfirmation
from rotsolve.core.quantity import EITHER_WAY
from rotsolve.core.symbols import TIME
from rotsolve.language.block import asked_block, asked_parts
from rotsolve.language.problem import EXTREMES, Find, Problem

SAME = 2e-6  # of the size of what is compared
FAR = 0.5  # of its size, as far as an approximation may be from what it stands for
ROUGHLY = "the scene asks for an approximation"
NOTHING = 1e-9  # of the size that a quantity has in the scene, for what is nothing
NEARLY = 1e-4  # of the same, for squares that are compared again with the motion followed more finely
SQUARED = 1e-8  # of the square of that size, for the square of a rate at which a motion that is followed turns back
RATES = ("angular_velocity", "velocity", "speed", "precession", "nutation", "spin")
ROUNDED = 1e-14  # of the same, for a float that should be nothing
COUNTED = ("precession_angle", "spin_angle", "angle")  # angles that count whole turns

TOLD_BY_SIZE = f"{SEVERAL}: `smallest {{letter}}` or `largest {{letter}}` tells which"
OF_SEVERAL = "`{letter}`, on which it may hang, has several values that fit"

Others = Callable[[str], "tuple[Formula, ...]"]


def no_others(_: str) -> tuple[Formula, ...]:
    """No other roots."""
    return ()


Said = Mapping[str, "float | str"]


def confirmations_in_space(
    answers: Sequence[Answer],
    problem: Problem,
    solved: Solved,
    admitted: Callable[[Numbers], bool],
    points: Sequence[Mapping[str, Fraction]] = (),
    others: Others = no_others,
) -> tuple[AnswerConfirmation, ...]:
    """What the assembly says of each answer; `admitted` says whether a scene may have such numbers, and is asked before they object.

    `others` are other roots for a letter that is settled on the way.
    """
    verdicts: dict[str, AnswerConfirmation] = {}
    wanted, tried, scans = sets_wanted(problem), 0, Scans()
    for numbers in numbers_tried(problem, points):
        if tried >= wanted + len(points):
            break
        found = {item.name: item for item in heard_at(answers, problem, numbers, solved, scans, others)}
        objects = any(item.holds is False or item.astray for item in found.values())
        if objects and letters_open(problem) and not admitted(numbers):  # numbers of its own a scene may have
            found = {name: AnswerConfirmation(name, None, NO_CASE) for name in found}
        verdicts |= {name: both_sets(verdicts.get(name), verdict) for name, verdict in found.items()}
        tried += any(verdict.holds is not None or verdict.also for verdict in found.values())
    return tuple(verdicts.values())


def numbers_tried(problem: Problem, points: Sequence[Mapping[str, Fraction]]) -> Iterator[Numbers]:
    """The sets of numbers: those of the cases and those that are drawn; where all is a number, that one."""
    for point in points if letters_open(problem) else ():
        yield with_givens(problem, {name: float(size) for name, size in point.items()})
    yield from sets_of_numbers(problem)


def confirmed_in_space_at(
    answers: Sequence[Answer], problem: Problem, solved: Solved, numbers: Numbers
) -> tuple[str, ...]:
    """The answers that the assembly gives too at one set of numbers for the letters that have none."""
    found = heard_at(answers, problem, with_givens(problem, numbers), solved)
    return tuple(item.name for item in found if item.holds)


def heard_at(
    answers: Sequence[Answer],
    problem: Problem,
    numbers: Numbers,
    solved: Solved,
    scans: Scans | None = None,
    others: Others = no_others,
) -> Iterator[AnswerConfirmation]:
    """What the assembly says of each answer at one set of numbers."""
    known = {TIME: NOW, **numbers, **asked_letters(problem, numbers, solved)}
    running = {find.group for find in problem.finds if find.runs}  # these are looked at by their closed forms
    told = [unvalued(answer) if answer.name in running else answer for answer in answers]
    cases = [case for several in told if (case := holding(several, numbers)) is not None]
    said = {
        case.name: said_of(case, known, closely_valued) if case.name in running else said_of(case, known)
        for case in cases
    }
    known |= letters_by_cases(problem, answers, said)
    found = {item.name: item for item in judged_in_space(cases, problem, known, said, numbers, scans, others)}
    for several in answers:
        yield found.get(several.name, AnswerConfirmation(several.name, None, NO_CASE))


def unvalued(answer: Answer) -> Answer:
    """An answer without the numbers that it has at one time."""
    parts = tuple(map(unvalued, answer.components))
    return replace(answer, value=None, components=parts, otherwise=tuple(map(unvalued, answer.otherwise)))


def judged_in_space(
    answers: Sequence[Answer],
    problem: Problem,
    known: Numbers,
    said: Mapping[str, Said],
    numbers: Numbers,
    scans: Scans | None = None,
    others: Others = no_others,
) -> Iterator[AnswerConfirmation]:
    """What the assembly says of answers that come to some numbers."""
    put: Put = answers_put_in(problem)
    told = {key: size for key, name in put.items() if isinstance(size := said.get(name, {}).get(""), float)}
    hearing = Hearing(problem, known, told, scans)
    exact: dict[str, float] = {}
    verdicts: dict[str, AnswerConfirmation] = {}
    for answer in answers:
        finds = [find for find in problem.finds if find.group == answer.name]
        found = made_of_others(finds[0], said[answer.name], exact, hearing, numbers) if problem.assume else None
        found = found or heard(finds, answer, said[answer.name], hearing, numbers)
        exact |= {answer.name: found.found[0]} if len(found.found) == 1 else {}
        verdicts[answer.name] = found
    sure = [answer for answer in answers if verdicts[answer.name].holds]
    from rotsolve.confirm.space.rivals import others_on_the_way

    for letter, values, behind in others_on_the_way(hearing, others) if sure else ():
        other = Hearing(problem, {**known, **values}, told, scans)
        for answer in sure:
            finds = [find for find in problem.finds if find.group == answer.name]
            own = verdicts[answer.name]
            if not own.holds or heard(finds, answer, said[answer.name], other, numbers).holds:
                continue
            why = OF_SEVERAL.format(letter=letter)
            verdicts[answer.name] = replace(own, also=behind) if behind else AnswerConfirmation(answer.name, None, why)
    yield from hanging_on_doubtful(verdicts, hearing)


def hanging_on_doubtful(verdicts: Mapping[str, AnswerConfirmation], hearing: Hearing) -> Iterator[AnswerConfirmation]:
    """The verdicts; what hangs on a letter that may have several values is no more confirmed than that letter is."""
    finds = {find.group: find for find in hearing.problem.finds}
    several = [finds[item.name] for item in verdicts.values() if item.holds is None and item.why == SEVERAL]
    doubtful = [find for find in several if hearing.is_put_in(find)]
    doubtful += [finds[item.name] for item in verdicts.values() if item.holds is False and finds[item.name].seeks]
    for item in verdicts.values():
        own = finds[item.name]
        letter = next(
            (find for find in doubtful if item.holds and may_hang_on(own, find) and share_parts(find, own, hearing)),
            None,
        )
        why = "" if letter is None else OF_SEVERAL.format(letter=letter.name)
        if own in several and hearing.letter(own) is not None and own.modifier not in EXTREMES:
            why = TOLD_BY_SIZE.format(letter=hearing.letter(own))
        yield replace(item, holds=None, why=why) if why else item


def may_hang_on(own: Find, other: Find) -> bool:
    """Whether a question may hang on the letter of another: not where each seeks its own value of one by a condition of its own."""
    return own is not other and (own.where is None or other.where is None or other.name in letters_of_question(own))


def letters_of_question(find: Find) -> frozenset[str]:
    """The letters in the arithmetic of a question, and of its condition."""
    phrase = None if find.where is None else find.where.phrase
    return find.formula.symbols() | (frozenset() if phrase is None else phrase.formula.symbols())


def share_parts(one: Find, other: Find, hearing: Hearing) -> bool:
    """Whether some part of the scene has a say in two questions."""
    names = [asked_parts(replace(hearing.problem, finds=(find,))) for find in (one, other)]
    return bool(names[0] & names[1])


def made_of_others(
    find: Find, said: Said, exact: Mapping[str, float], hearing: Hearing, numbers: Numbers
) -> AnswerConfirmation | None:
    """An answer that is a formula of others, held against the same of these as they are without the approximation."""
    own = said.get("")
    if find.terms or not isinstance(own, float) or not find.formula.symbols() & exact.keys():
        return None
    try:
        value = value_of(find.formula, {**hearing.known, **exact})
    except (NotConfirmed, ArithmeticError):
        return None
    return verdict_of(find.name, abs(value - own) <= SAME * abs(value), (own,), (value,), hearing, numbers)


def letters_by_cases(problem: Problem, answers: Sequence[Answer], said: Mapping[str, Said]) -> dict[str, float]:
    """The letters that are asked for and whose answers have cases, by the one that holds."""
    asked = problem.sought
    told = {answer.name: said.get(answer.name, {}).get("") for answer in answers if answer.otherwise}
    return {
        find.formula.name: size
        for find in problem.finds
        if isinstance(find.formula, Symbol) and find.formula.name in asked and find.modifier in ("", *EXTREMES)
        if not find.terms and isinstance(size := told.get(find.group), float)
    }


def heard(finds: list[Find], answer: Answer, said: Said, hearing: Hearing, numbers: Numbers) -> AnswerConfirmation:
    """One answer held against what the assembly has; where the scene does not move with these numbers, against that of its asked part."""
    name = answer.name
    try:
        if finds[0].choice is not None:
            word = options_that_hold(finds[0].choice, hearing.inquiry.one)
            return AnswerConfirmation(name, word == said.get(""), "" if word == said.get("") else word)
        parts = {key: number for key, number in said.items() if isinstance(number, float)}
        if not parts:
            open_ = sorted(answer.formula.symbols() - hearing.known.keys()) if answer.formula is not None else []
            if open_:
                raise NotConfirmed(f"`{open_[0]}` has no number")
            return not_so(name, NO_NUMBER, hearing.problem, numbers)
        if finds[0].where is not None:
            own = parts[""]
            found = hearing.under_condition(finds[0], own)
            if abs(found - own) > SAME * max(abs(own), 1e-9):
                return verdict_of(name, False, (own,), (found,), hearing, numbers)
            from rotsolve.confirm.space.rivals import beside_under_condition

            beside, against = beside_under_condition(hearing, finds[0], own, answer.rivals)
            if beside:
                return replace(not_so(name, beside, hearing.problem, numbers), rivalled=True)
            letters = numbers_told(numbers, hearing.problem)
            against += f" with {letters}" if against and letters else ""
            return AnswerConfirmation(name, True, "", (own,), (found,), also=against)
        if hearing.is_put_in(finds[0]):
            return tested(answer, parts, hearing, finds[0], numbers)
        return compared_in_space(finds, answer, parts, hearing, numbers)
    except Unfit as reason:
        if finds[0].where is not None and hearing.letters:  # the others would have to change with it
            return AnswerConfirmation(name, None, "a condition beside other unknown letters")
        part = asked_block(replace(hearing.problem, finds=tuple(finds)))
        if len(part.bodies) == len(hearing.problem.bodies):
            if hearing.problem.assume and letters_open(hearing.problem):  # numbers for which it was not meant
                return AnswerConfirmation(name, None, ROUGHLY)
            return not_so(name, str(reason), hearing.problem, numbers)
        return heard(finds, answer, said, Hearing(part, hearing.known, hearing.told, hearing.scans), numbers)
    except NotConfirmed as reason:
        part = asked_block(replace(hearing.problem, finds=tuple(finds)))
        if len(part.bodies) < len(hearing.problem.bodies):  # what has no say in it may be what is not looked at
            return heard(finds, answer, said, Hearing(part, hearing.known, hearing.told, hearing.scans), numbers)
        return AnswerConfirmation(name, None, str(reason))
    except (ArithmeticError, ValueError) as error:
        return AnswerConfirmation(name, None, f"the assembly has no number ({error})")


def tested(
    answer: Answer, parts: Mapping[str, float], hearing: Hearing, find: Find, numbers: Numbers
) -> AnswerConfirmation:
    """An answer that was put in is right where the equations then leave nothing over."""
    own, size = parts[""], max(hearing.size(hearing.place_of(find)), 1e-9)
    letter = hearing.letter(find)
    try:
        off = hearing.correction(find)
    except TooFar:  # another root may be one to which the motion does not come
        raise
    except NotConfirmed:
        from rotsolve.confirm.space.rivals import beside_untested

        beside = beside_untested(hearing, find, own, answer.rivals)
        if not beside:
            raise
        return not_so(answer.name, beside, hearing.problem, numbers)  # what hangs on it is another with another value
    found = off + (own if letter is None else hearing.known[letter])
    holds = abs(found - own) <= SAME * size
    if holds:
        from rotsolve.confirm.space.rivals import against_as_well, fits_as_asked
        from rotsolve.confirm.space.standing import extreme_that_lasts, standing_by

        if find.modifier in EXTREMES and letter is not None and any(standing_by(letter, hearing.problem)):
            meant: bool | None = extreme_that_lasts(hearing, find, letter, own)
        else:
            meant = fits_as_asked(hearing, find, own, answer.rivals)
        if not meant:
            return AnswerConfirmation(answer.name, meant, SEVERAL, (own,), (found,))
        also = against_as_well(hearing, find, own, answer.rivals)
        return replace(verdict_of(answer.name, holds, (own,), (found,), hearing, numbers), also=also)
    return verdict_of(answer.name, holds, (own,), (found,), hearing, numbers)


def compared_in_space(
    finds: list[Find], answer: Answer, parts: Mapping[str, float], hearing: Hearing, numbers: Numbers
) -> AnswerConfirmation:
    """All parts of an answer beside those of the assembly, which has several of each where several motions are possible."""
    vector = any(part in parts for part in "xyz")
    keys = [key for key in parts if key or not vector or len(parts) == 1] or list(parts)
    answered = tuple(parts[key] for key in keys)
    columns = [hearing.numbers_of(finds, answer.name, key) for key in keys]
    count = max(map(len, columns))
    rows = [tuple(column[way if len(column) > 1 else 0] for column in columns) for way in range(count)]
    if not all(math.isfinite(part) for row in rows for part in row):
        raise NotConfirmed("its number is beyond those of the assembly")
    if finds[0].formula == Symbol("#0") and finds[0].terms[0].path.quantity in COUNTED:
        rows = [tuple(turned_to(own, part) for own, part in zip(row, answered, strict=True)) for row in rows]
    natural, close = hearing.natural(answer), same_in_each if hearing.problem.assume else same_beside_largest
    loose = bool(finds[0].terms) and finds[0].terms[0].path.quantity in EITHER_WAY
    fits = [
        row
        for row in rows
        if close(answered, row, natural)
        or (loose and close(answered, turned_round(row), natural))
        or (at_turning(finds[0], hearing) and by_squares(answered, row, natural, SQUARED))
    ]
    nearly = at_turning(finds[0], hearing) and any(by_squares(answered, row, natural, NEARLY) for row in rows)
    if not fits and nearly and not hearing.finely:
        return compared_in_space(finds, answer, parts, hearing.more_finely(), numbers)
    if fits and len(fits) < len(rows) and not hearing.problem.assume:
        return AnswerConfirmation(answer.name, None, SEVERAL, answered, fits[0])
    slow = hearing.inquiry.slowest(finds[0]) if hearing.problem.assume and len(rows) > 1 and not fits else None
    nearest = min(rows, key=lambda row: math.dist(row, answered)) if slow is None or slow >= count else rows[slow]
    return verdict_of(answer.name, bool(fits), answered, (fits or [nearest])[0], hearing, numbers)


def same_in_each(answered: Sequence[float], own: Sequence[float], natural: float) -> bool:
    """Whether the components of an approximation are each the same: beside a large one, or beside the size of such quantities in the
    scene, how good a small one is would not be seen."""
    least = max(SAME * SAME * math.hypot(*answered), ROUNDED * natural)  # what rounding makes of a component
    return all(
        abs(a - b) <= max(SAME * max(abs(a), abs(b)), least if a else NOTHING * natural)
        for a, b in zip(answered, own, strict=True)
    )


def same_beside_largest(answered: Sequence[float], own: Sequence[float], natural: float) -> bool:
    """Whether numbers are the same, beside the largest of them; what should be nothing, beside the size of such quantities in the scene."""
    size = max(map(abs, (*answered, *own)), default=0.0)
    rounded = ROUNDED * natural  # less than that is nothing, as the number at a place without a closed form is
    room = max(SAME * size, rounded if any(abs(part) > rounded for part in answered) else NOTHING * natural)
    return all(abs(a - b) <= room for a, b in zip(answered, own, strict=True))


def at_turning(find: Find, hearing: Hearing) -> bool:
    """Whether a rate is asked where the motion leads, which is known there by its square alone, as far as it is followed."""
    first = hearing.problem.states[0].name if hearing.problem.states else None
    rated = (term for term in find.terms if term.path.quantity in RATES)
    if not hearing.inquiry.follows:
        return False
    return len(find.terms) == 1 and any(term.at not in (None, first) for term in rated)


def by_squares(answered: Sequence[float], own: Sequence[float], natural: float, share: float) -> bool:
    """Whether the squares of numbers of one sense are the same beside that of the size of such quantities in the scene; of small ones the
    sense is not known.
    """
    room = share * natural**2
    pairs = list(zip(answered, own, strict=True))
    return all(abs(a * a - b * b) <= room and (a * b >= 0 or max(a * a, b * b) <= room) for a, b in pairs)


def turned_to(angle: float, answered: float) -> float:
    """An angle by as many whole turns further as the answer counts."""
    return angle + 2 * math.pi * round((answered - angle) / (2 * math.pi))


def turned_round(row: Sequence[float]) -> tuple[float, ...]:
    return tuple(-part for part in row)


def verdict_of(
    name: str, holds: bool, answered: tuple[float, ...], own: tuple[float, ...], hearing: Hearing, numbers: Numbers
) -> AnswerConfirmation:
    """What is contradicted is so, but for what is meant as an approximation, of which is said how near it comes, if it does."""
    if holds:
        return AnswerConfirmation(name, True, "", answered, own)
    if not hearing.problem.assume:
        return AnswerConfirmation(name, False, OTHERWISE, answered, own)
    near, letters = how_near(answered, own), numbers_told(numbers, hearing.problem)
    if math.dist(answered, own) > FAR * math.hypot(*answered) and not letters:
        return AnswerConfirmation(
            name, False, f"it is {near or 'not nothing'} without the approximation that the scene asks for"
        )
    also = f"{near} without it" if near else ""
    return AnswerConfirmation(
        name, None, ROUGHLY, answered, own, also=also + (f" (with {letters}, say)" if also and letters else "")
    )


def how_near(answered: Sequence[float], own: Sequence[float]) -> str:
    """By how much of an approximate answer the exact one is larger or smaller: "6.1 % larger", of a vector in the component in which that
    is most; nothing where none has a size."""
    least = SAME * SAME * math.hypot(*answered)
    ratios = [abs(b / a) - 1 for a, b in zip(answered, own, strict=True) if abs(a) > least]
    if not ratios:
        return ""
    percent = 100 * max(ratios, key=abs)
    where = "in one component " if len(answered) > 1 else ""
    return f"{where}{abs(percent):.2g} % {'larger' if percent > 0 else 'smaller'}"
