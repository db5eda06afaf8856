"""Verdict: the answers held against the assembly: the same, something else, or not confirmed and why.

Letters without a number get several sets of numbers, the same in every run; a letter that is asked for has the number of its answer, which
then has to make every line of the states hold.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from itertools import chain, repeat
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.course.asked import Asker
from rotsolve.confirm.course.following import Broken, Course
from rotsolve.confirm.course.node import Astray, Budget, unpushed
from rotsolve.confirm.course.reading import Reckoned
from rotsolve.confirm.course.samples import (
    SETS,
    Numbers,
    extreme_sets,
    far_apart,
    fits_of,
    fitting_first,
    holding,
    meeting_sets,
    near_edges,
    on_edges,
    rough_enough,
    sets_of_numbers,
    sets_wanted,
    with_givens,
    within_case,
)
from rotsolve.confirm.course.sizes import letters_open
from rotsolve.confirm.verdicts import (
    NO_CASE,
    NO_NUMBER,
    OTHERWISE,
    SAME,
    Solved,
    asked_letters,
    both_sets,
    closely_valued,
    not_so,
    number_of,
    numbers_told,
    pairs,
    said_of,
)
from rotsolve.core.derivation import Answer, AnswerConfirmation
from rotsolve.core.limits import Limit
from rotsolve.language.problem import EXTREMES, Find, Problem

if TYPE_CHECKING:
    from rotsolve.confirm.course.rivals import Rivals
    from rotsolve.confirm.course.scans import Scans

NEARLY = SAME**0.5  # of roots of what is zero but for rounding, as speeds are where something just comes to rest
ORDINARY = 1.0  # size beside which what should be 0 is rounding, where nothing else tells one: the assembly finds states by steps
POINTS = {"right": (1.0, 0.0), "left": (-1.0, 0.0), "up": (0.0, 1.0), "down": (0.0, -1.0)}  # by the word of an answer
OTHER_WAY = "an assembly of all bodies' equations has it point the other way"
UNTRIED = "no numbers were tried there"
DRAWN, OWN, EDGE, ON, MEETING, FAR = range(6)  # kinds of sets of numbers
BUDGET = 3000  # instants of one body that a scene may cost
FAR_BUDGET = 2000  # those of one set that is far from the others, which together may cost as much again


def confirmations_in_plane(
    answers: Sequence[Answer],
    problem: Problem,
    solved: Solved,
    admitted: Callable[[Numbers], bool],
    points: Sequence[Mapping[str, Fraction]] = (),
    limits: Callable[[], Iterable[Limit]] = tuple,
    others: Callable[[str], tuple[Formula, ...]] = lambda _: (),
) -> tuple[AnswerConfirmation, ...]:
    """What the assembly says of each answer; `admitted` says whether a scene may have such numbers, and is asked before they object; its
    `limits` tell most of that at once, and `others` are other roots for a letter that is settled on the way.

    Cases of letters to which no set belongs that was drawn are tried at the `points` at which they were found, and near their edges.
    """
    verdicts: dict[str, AnswerConfirmation] = {}
    seen = set[int]()  # the cases that have been tried
    heard = Heard(answers, problem, solved)
    tried, in_vain, wanted, budget, far_budget = 0, 0, sets_wanted(problem), Budget(BUDGET), Budget(BUDGET)
    meeting, own, scans = Budget(BUDGET), Budget(BUDGET), scans_of(problem, limits)
    rivals = rivals_of(answers, problem, limits, scans, others)
    for kind, numbers in sets_tried(answers, problem, admitted, points, limits):
        limit = {FAR: far_budget.portion(FAR_BUDGET), MEETING: meeting, OWN: own}.get(kind, budget)
        if limit.left < 0 or (kind == DRAWN and wanted in (tried, in_vain)):
            continue
        cases = {id(case) for answer in answers if (case := holding(answer, numbers)) is not None}
        if kind == OWN and cases <= seen:
            continue
        found = {item.name: item for item in at_numbers(answers, problem, numbers, solved, limit, scans)}
        if rivals is not None:
            found = rivals.tried(found, numbers_known(answers, problem, numbers, solved))
        if any(item.holds is False or item.astray for item in found.values()) and not admitted(numbers):
            continue
        if kind == ON:
            found = {name: on_edge(item, numbers, problem) for name, item in found.items() if item.holds is not None}
        heard.note(found, numbers)
        verdicts |= {name: both_sets(verdicts.get(name), verdict) for name, verdict in found.items()}
        if any(verdict.holds is not None for verdict in found.values()):
            tried, seen = tried + 1, seen | cases
        elif any(verdict.why != NO_CASE for verdict in found.values()):
            in_vain += 1
    against = rivals.against if rivals is not None else {}
    return tuple(replace(heard.of_all_cases(one), also=against.get(one.name, "")) for one in verdicts.values())


def scans_of(problem: Problem, limits: Callable[[], Iterable[Limit]]) -> Scans | None:
    """What remembers the scans for extremes over letters; None where nothing asks for one."""
    if not any(map(asks_extreme, problem.finds)):
        return None
    from rotsolve.confirm.course.scans import Scans

    return Scans(fits_of(tuple(limits())))


def asks_extreme(find: Find) -> bool:
    """Whether a question is for an extreme over a letter, or for its place."""
    return bool(find.extreme) or (find.where is not None and find.where.word in EXTREMES)


class Heard:
    """Which cases of the answers were confirmed with some numbers, and why others were not: one case does not speak for another."""

    def __init__(self, answers: Sequence[Answer], problem: Problem, solved: Solved) -> None:
        self.answers = {answer.name: answer for answer in answers if answer.otherwise}
        self.problem, self.solved = problem, solved
        self.confirmed: set[int] = set()
        self.doubts: dict[int, str] = {}

    def note(self, found: Mapping[str, AnswerConfirmation], numbers: Numbers) -> None:
        """What was found with a set of numbers, of the cases to which these belong."""
        several = [answer for name, answer in self.answers.items() if name in found]
        known = numbers_known(several, self.problem, numbers, self.solved) if several else {}
        for answer in several:
            case, verdict = holding(answer, known), found[answer.name]
            if case is not None and verdict.holds:
                self.confirmed.add(id(case))
            elif case is not None:
                self.doubts.setdefault(id(case), f"with {numbers_told(numbers, self.problem)} {verdict.why}")

    def of_all_cases(self, verdict: AnswerConfirmation) -> AnswerConfirmation:
        """A verdict about all cases of an answer: confirmed where each of them was."""
        answer = self.answers.get(verdict.name)
        if answer is None or not verdict.holds:
            return verdict
        left = [case for case in (answer, *answer.otherwise) if id(case) not in self.confirmed]
        whys = [self.doubts.get(id(case), UNTRIED) for case in left]
        return AnswerConfirmation(verdict.name, None, f"in one of its cases: {whys[0]}") if whys else verdict


def sets_tried(
    answers: Sequence[Answer],
    problem: Problem,
    admitted: Callable[[Numbers], bool],
    points: Sequence[Mapping[str, Fraction]],
    limits: Callable[[], Iterable[Limit]],
) -> Iterator[tuple[int, Numbers]]:
    """The sets of numbers at which answers are held against the assembly, each with its kind; where all is a number, that one."""
    if not letters_open(problem):
        yield from zip(repeat(DRAWN), sets_of_numbers(problem))
        return
    fits = fits_of(tuple(limits()))
    yield from zip(repeat(DRAWN), fitting_first(sets_of_numbers(problem), fits))
    yield from ((OWN, with_givens(problem, within_case(problem, answers, point))) for point in points)
    yield from zip(repeat(EDGE), near_edges(problem, answers, points))
    yield from zip(repeat(ON), on_edges(problem, answers, points))
    if sets_wanted(problem) < SETS:
        return
    yield from zip(repeat(MEETING), meeting_sets(problem, fits))
    far = far_apart(problem, answers, fits)
    yield from zip(repeat(FAR), chain(extreme_sets(problem, admitted, fits), far, near_edges(problem, answers, far)))
    if poised(problem):
        yield from zip(repeat(FAR), rough_enough(problem, answers))


def poised(problem: Problem) -> bool:
    """Whether all rests at first where nothing pushes: no steps then tell what gives way on the way, so that more is tried there."""
    try:
        course = Course(problem, next(sets_of_numbers(problem)), Budget(BUDGET))
        return len(course.names) > 1 and unpushed(course.node(course.names[0]))
    except (NotConfirmed, ArithmeticError, ValueError):
        return False


def confirmed_in_plane_at(
    answers: Sequence[Answer], problem: Problem, solved: Solved, numbers: Numbers
) -> tuple[str, ...]:
    """The answers that an assembly gives too at one set of numbers for the letters that have none."""
    known = with_givens(problem, numbers)
    return tuple(item.name for item in at_numbers(answers, problem, known, solved, Budget(BUDGET)) if item.holds)


def no_verge_at(answers: Sequence[Answer], problem: Problem, solved: Solved, numbers: Numbers) -> str:
    """Why what a question seeks as a verge, `largest F where touch sticks`, is none at one set of numbers; "" where it may be."""
    seeking = {find.group for find in problem.finds if find.verge}
    sought = [answer for answer in answers if answer.name in seeking]
    verdicts = at_numbers(sought, problem, with_givens(problem, numbers), solved, Budget(BUDGET)) if sought else ()
    return next((item.why for item in verdicts if item.holds is False), "")


def on_edge(verdict: AnswerConfirmation, numbers: Numbers, problem: Problem) -> AnswerConfirmation:
    """What is said of numbers on an edge, where rounding may put the assembly beside it: what it contradicts is not confirmed."""
    if verdict.holds:
        return verdict
    if verdict.found and all(abs(a - b) <= NEARLY * max(abs(a), abs(b), ORDINARY) for a, b in pairs(verdict)):
        return replace(verdict, holds=None)  # a root of what is nearly zero there
    why = f"not so on an edge of its conditions, with {numbers_told(numbers, problem)}"
    return AnswerConfirmation(verdict.name, None, why, astray=True)


def at_numbers(
    answers: Sequence[Answer],
    problem: Problem,
    numbers: Numbers,
    solved: Solved,
    budget: Budget,
    scans: Scans | None = None,
) -> Iterator[AnswerConfirmation]:
    """What the assembly says of each answer at one set of numbers; what is scanned for extremes is remembered in `scans`."""
    finds = {find.group: find for find in reversed(problem.finds)}
    known = numbers_known(answers, problem, numbers, solved)
    asker = Asker(problem, Course(problem, known, budget), scans)
    for several in answers:
        answer = holding(several, known)
        said = {} if answer is None else said_of(answer, known) or said_of(answer, known, closely_valued)
        if answer is None:
            yield AnswerConfirmation(several.name, None, NO_CASE)
            continue
        if not said:
            yield judged(finds[answer.name], said, asker, numbers)
            continue
        verdict = judged(finds[answer.name], said, asker, numbers, answer.direction)
        if (
            verdict.holds is False and (closer := said_of(answer, known, closely_valued)) != said
        ):  # arcsin next to 1 has few digits
            said = closer
            verdict = judged(finds[answer.name], said, asker, numbers, answer.direction)
        if (
            verdict.holds is False and (verdict.found or verdict.why == OTHER_WAY) and problem.states[1:]
        ):  # the forces of the last state may be those of the phase before it
            ended = Asker(problem, Course(problem, known, budget, ending=True), scans)
            other = judged(finds[answer.name], said, ended, numbers, answer.direction)
            verdict = other if other.holds and not asker.course.holds_at_last() else verdict
        if verdict.holds is False and verdict.why in (OTHERWISE, OTHER_WAY) and (slips := asker.course.slips()):
            told = not_so(verdict.name, slips, problem, numbers)  # letters may have others, with which nothing slips
            verdict = replace(verdict, holds=told.holds, why=told.why, astray=told.astray)
        yield verdict


def numbers_known(answers: Sequence[Answer], problem: Problem, numbers: Numbers, solved: Solved) -> Numbers:
    """The numbers of all letters, those that are asked for by the answers."""
    finds = {find.group: find for find in reversed(problem.finds)}
    known = {**numbers, **asked_letters(problem, numbers, solved)}
    for several in answers:  # an answer is that of the case to which the numbers belong
        own = holding(several, numbers) if finds[several.name].formula == Symbol(several.name) else None
        size = number_of(own, numbers) if own is not None else None
        known |= {several.name: size} if size is not None else {}
    return known


def rivals_of(
    answers: Sequence[Answer],
    problem: Problem,
    limits: Callable[[], Iterable[Limit]],
    scans: Scans | None,
    others: Callable[[str], tuple[Formula, ...]] = lambda _: (),
) -> Rivals | None:
    """What looks for other values of the letters that answers tell, or hang on; None where there are none."""
    letters = {Symbol(given.name) for given in problem.givens}
    if not problem.sought and not any(find.formula in letters for find in problem.finds):
        return None
    from rotsolve.confirm.course.rivals import Rivals

    def judge(find: Find, said: dict[str, float | str], numbers: Numbers) -> AnswerConfirmation:
        course = Course(problem, numbers, Budget(BUDGET))
        verdict = judged(find, said, Asker(problem, course, scans), numbers)
        return replace(verdict, holds=False) if verdict.holds and course.idle_event() else verdict

    return Rivals(answers, problem, fits_of(tuple(limits())), judge, others)


def judged_in_plane(
    answers: Sequence[Answer],
    problem: Problem,
    known: Numbers,
    sizes: Mapping[str, Mapping[str, float]],
    numbers: Numbers,
) -> Iterator[AnswerConfirmation]:
    """What the assembly says of answers that come to some numbers."""
    asker = Asker(problem, Course(problem, known, Budget(BUDGET)))
    for answer in answers:
        find = next(find for find in problem.finds if find.group == answer.name)
        yield judged(find, sizes[answer.name], asker, numbers)


def judged(
    find: Find, said: Mapping[str, float | str], asker: Asker, numbers: Numbers, direction: str = ""
) -> AnswerConfirmation:
    """One answer, with its direction in words, held against what the assembly has."""
    name = find.group
    try:
        found = asker.answer(find, said)
        if said and found.way is not None and not points(direction, found.way):
            return AnswerConfirmation(name, False, OTHER_WAY)
        if said:
            return compared(name, said, found)
        return not_so(name, NO_NUMBER, asker.problem, numbers)
    except Astray as reason:  # letters may have other numbers, with which it comes about
        return not_so(name, str(reason), asker.problem, numbers)
    except Broken as reason:
        return AnswerConfirmation(name, False if asks_for_letter(find) else None, str(reason))
    except NotConfirmed as reason:
        return AnswerConfirmation(name, None, str(reason))
    except (ArithmeticError, ValueError) as error:
        return AnswerConfirmation(name, None, f"the assembly has no number ({error})")


def asks_for_letter(find: Find) -> bool:
    """Whether the answer itself was put into the scene, so that a line that does not hold speaks against it."""
    return not find.terms and isinstance(find.formula, Symbol)


def compared(name: str, said: Mapping[str, float | str], found: Reckoned) -> AnswerConfirmation:
    """Whether all that is said of an answer is what the assembly has found."""
    if isinstance(said.get("", 0.0), str) or found.word:
        return AnswerConfirmation(name, said.get("") == found.word, "" if said.get("") == found.word else found.word)
    parts = [key for key in said if key in found.values]
    if not parts:
        return AnswerConfirmation(name, None, "its parts are not known to the assembly")
    answered = tuple(float(said[key]) for key in parts)
    own = tuple(found.values[key] for key in parts)
    if "x" in found.values:  # of a vector its size, which has no sign
        answered = tuple(abs(a) if key == "" else a for key, a in zip(parts, answered, strict=True))
    if not all(map(math.isfinite, own)):
        return AnswerConfirmation(name, None, "its number is beyond those of the assembly")
    if found.period:
        own = tuple(a - math.remainder(a - b, found.period) for a, b in zip(answered, own, strict=True))
    size = max(found.size, *map(abs, own), *map(abs, answered))
    if found.sized:
        answered, own = (tuple(map(abs, values)) for values in (answered, own))
    holds = all(abs(a - b) <= SAME * (size if a else max(size, ORDINARY)) for a, b in zip(answered, own, strict=True))
    return AnswerConfirmation(name, holds, "" if holds else OTHERWISE, answered, own)


def points(direction: str, way: tuple[float, float]) -> bool:
    """Whether a vector may point as a word says; of those at an angle to it, nothing is said."""
    told = POINTS.get(direction)
    along = None if told is None else told[0] * way[0] + told[1] * way[1]
    return along is None or along >= -SAME * max(math.hypot(*way), ORDINARY)
