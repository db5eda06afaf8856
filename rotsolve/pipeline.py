"""Pipeline: the arrows in order: scene text → problem → scene (facts, equations) → search (plan, solve) → derivation with checks."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from contextlib import suppress
from fractions import Fraction
from functools import cache, partial
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.certified.ball import refuse_digits, witnessed
from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.effort import Exhausted, at_most, rarely_collecting
from rotsolve.algebra.formula import Formula, Number
from rotsolve.algebra.units.dimension import base_unit_text
from rotsolve.algebra.units.quantities import parse_quantity
from rotsolve.apart import each_where_answered, those_in_time
from rotsolve.core.derivation import Check, Derivation
from rotsolve.core.equation import FAMILIES
from rotsolve.core.faults import (
    CONTRADICTORY,
    INCOMPLETE,
    UNREACHED,
    UNSOLVED,
    Contradicted,
    Fault,
    NeverReached,
    SceneError,
    Unsolvable,
)
from rotsolve.language.block import asked_block
from rotsolve.language.problem import Find, Problem, before
from rotsolve.motion.complete import configured
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.hereafter import changes_at_last, with_hereafter
from rotsolve.profile import stage
from rotsolve.scene.read import Source, read_source, read_text
from rotsolve.search.answering import Unanswered
from rotsolve.search.answers import unsolvable
from rotsolve.solution import Resolved, Solution
from rotsolve.solving import solved

if TYPE_CHECKING:
    from rotsolve.algebra.formula import Formula
    from rotsolve.core.derivation import AnswerConfirmation
    from rotsolve.core.limits import Limit
    from rotsolve.search.acting import ActingWays
    from rotsolve.search.complete import FollowedCourses

DIGITS = 4
FEW_LETTERS = 4  # that a message names
STEPS = 20_000  # of work for a scene
TRIAL_STEPS = STEPS // 10  # of work for one that is only tried, for a word of help


def solve(
    source: Source,
    *,
    law: str | None = None,
    settings: Mapping[str, object] | None = None,
    digits: int = DIGITS,
    at: str | None = None,
    confirm: bool = True,
) -> Solution:
    """Solve a scene: a path, YAML text (text with a line break), or a dict of its sections.

    `settings` replace values of givens, `{"m": "2 kg"}`; numbers are understood where the scene declares a unit of SI. Functions of time
    are evaluated `at` a time such as "2 s".
    A question without an answer takes no other with it: its reason is in `refused` of the solution. With `confirm` an assembly of all
    bodies' equations is held against the answers, and what it contradicts is refused. Raises SceneError for a scene that can't be read,
    Unsolvable for one in which nothing has an answer.
    """
    with stage("read"):
        problem = read_source(source, settings)
    return solve_problem(problem, law=law, digits=digits, at=at, confirm=confirm)


def solve_problem(
    problem: Problem, *, law: str | None = None, digits: int = DIGITS, at: str | None = None, confirm: bool = True
) -> Solution:
    """Solve a problem that has been read, by one law where `law` names it, else by the shortest way."""
    refuse_digits(digits)
    if law is not None and law not in FAMILIES:
        raise ValueError(f"unknown law {law!r}; one of {', '.join(FAMILIES)}")
    with rarely_collecting():
        solution = refused_fairly(problem, law, digits, at)
        again = partial(solve_problem, problem, law=law, digits=digits, at=at, confirm=confirm)
        trace = replace(solution.trace, again=again, anew=partial(solved_anew, problem, law, digits, at))
        solution = replace(solution, trace=trace)
        return held_against_assembly(solution, problem) if confirm else solution


def solved_anew(
    problem: Problem, law: str | None, digits: int, at: str | None, settings: Mapping[str, str], moment: str | None
) -> Resolved:
    """A problem solved with other values of its givens, and at another moment where one is told."""
    with witnessed() as witness:
        try:
            own = with_other_values(problem, settings)
            found, why = refused_fairly(own, law, digits, moment or at), ""
        except (SceneError, Unsolvable) as error:
            found, why = None, error.message
        except ArithmeticError as error:
            found, why = None, f"it can't be worked out with these numbers: {error}"
    try:
        found = None if found is None else held_against_assembly(found, own)
    except Unsolvable as error:
        found, why = None, error.message
    return Resolved(found, why, tuple(witness.asked), witness.by_size)


def with_other_values(problem: Problem, settings: Mapping[str, str]) -> Problem:
    """The problem read once more with values of its givens, and with those of letters that the reader made put in."""
    made = {given.name for given in problem.givens if given.automatic}
    told = {name: text for name, text in settings.items() if name not in made}
    own = read_text("\n".join(problem.lines), problem.file, {**dict(problem.settings), **told})
    values = {name: parse_quantity(text).value for name, text in settings.items() if name in made}
    givens = [replace(item, value=values[item.name]) if item.name in values else item for item in own.givens]
    return replace(own, givens=tuple(givens)) if values else own


def held_against_assembly(solution: Solution, problem: Problem) -> Solution:
    """The solution without what an assembly of all bodies' equations contradicts; Unsolvable where nothing is left."""
    with stage("confirm", whole=True):
        told = {answer.name for answer in solution.derivation.answers}  # some may have been left out since
        found = () if solution.trace.confirmation is None else solution.trace.confirmation()
        verdicts = tuple(item for item in found if item.name in told)
        return replace(solution, derivation=as_confirmed(replace(solution.derivation, confirmed=verdicts), problem))


def as_confirmed(derivation: Derivation, problem: Problem) -> Derivation:
    """The derivation as it stands after its confirmation; what objects to answers goes on doing so where others are withheld."""
    from rotsolve.confirm.verdicts import confirmed

    left = confirmed(derivation, problem)
    objections = (check for check in derivation.checks if check.holds is not True and check not in left.checks)
    return replace(left, checks=(*left.checks, *objections))


def refused_fairly(problem: Problem, law: str | None, digits: int, at: str | None) -> Solution:
    """The solution; what is refused as incomplete or contradictory is so to an assembly of all bodies' equations too."""
    try:
        solution = those_in_time(problem, lambda own: solved_with_effort(own, law, digits, at))
    except Exhausted:
        raise too_long(problem) from None
    except Unsolvable as error:
        raise refused_with_others(error, problem, law) from None
    if not solution.derivation.refused:
        return solution
    judge = fairly(problem, law)
    refused = [replace(item, fault=judge(item.fault, [item.name])) for item in solution.derivation.refused]
    return replace(solution, derivation=replace(solution.derivation, refused=tuple(refused)))


def solved_with_effort(problem: Problem, law: str | None, digits: int, at: str | None) -> Solution:
    """The solution with no more work than a scene may take."""
    with at_most(STEPS):
        return solved_in_parts(problem, law, digits, at)


def refused_with_others(error: Unsolvable, problem: Problem, law: str | None) -> Unsolvable:
    """Why nothing has an answer, told of each question where each has its reason, with what is fair to say of it."""
    every = [find.name for find in problem.finds]
    names = list(error.refused) if isinstance(error, Unanswered) else []
    told = [error.fault, *error.others]
    judge = fairly(problem, law)
    first, *others = (judge(fault, [names[k]] if k < len(names) > 1 else every) for k, fault in enumerate(told))
    if [first, *others] == told:
        return error
    if isinstance(error, Contradicted) and first.kind == error.fault.kind:
        error.retold(first)
        return error
    return unsolvable(problem, first.message, first.span, first.help, kind=first.kind, others=others)


def too_long(problem: Problem) -> Unsolvable:
    """That a scene takes more work than is done for one."""
    wanted = numbers_wanted(problem)
    if not wanted:
        return unsolvable(problem, "it takes too long to work out", None, "ask for less, or follow it by `simulate`")
    return unsolvable(problem, "it takes too long to work out in letters", None, wanted)


def numbers_wanted(problem: Problem) -> str:
    """The help that letters want numbers; "" where none is open."""
    open_ = [given.name for given in problem.givens if given.value is None and not (given.asked or given.automatic)]
    return f"give numbers to {', '.join(f'`{name}`' for name in open_[:FEW_LETTERS])}" if open_ else ""


def as_tried(error: Exception, problem: Problem) -> Exception:
    """Why there is no verge, which was seen at some numbers for the letters alone."""
    if not isinstance(error, Unsolvable) or error.fault.help or not any(find.verge for find in problem.finds):
        return error
    fault = error.fault
    wanted = numbers_wanted(problem)
    if not wanted:
        return error
    help = f"it may be otherwise for other letters: {wanted}"
    return unsolvable(problem, fault.message, fault.span, help, kind=fault.kind)


def fairly(problem: Problem, law: str | None) -> Callable[[Fault, Sequence[str]], Fault]:
    """What is fair to say of refusals of some questions of a scene, which an assembly follows once for all of them."""

    @cache
    def followed() -> FollowedCourses:
        from rotsolve.search.complete import FollowedCourses

        return FollowedCourses()

    return partial(fair_refusal, problem=problem, law=law, followed=followed)


def fair_refusal(
    fault: Fault,
    names: Sequence[str],
    problem: Problem,
    law: str | None,
    followed: Callable[[], FollowedCourses] | None = None,
) -> Fault:
    """A refusal of some questions as it is, or, where it falsely blames the scene's data, what is not solved; with what nothing holds."""
    return beside_unheld(fairly_blamed(fault, names, problem, law, followed), problem)


def beside_unheld(fault: Fault, problem: Problem) -> Fault:
    """A refusal with the bodies that nothing holds, of which it may come; what is not solved is no fault of the scene."""
    from rotsolve.motion.unheld import unheld, what_would_hold

    if fault.help and fault.kind not in (INCOMPLETE, CONTRADICTORY, UNREACHED):
        return fault
    names: tuple[str, ...] = ()
    with suppress(Unsolvable):  # what can't be arranged has a fault of its own
        names = () if fault.kind == UNSOLVED or problem.space else unheld(configured(problem))
    if not names:
        return fault
    shown = ", ".join(f"`{name}`" for name in names)
    how = " and ".join(f"`{item}`" for item in what_would_hold(names, problem))
    it = "it is" if len(names) == 1 else "they are"
    return replace(fault, help=f"nothing holds {shown}: {it} free to fall; hold it by a connection, as {how}")


def fairly_blamed(
    fault: Fault,
    names: Sequence[str],
    problem: Problem,
    law: str | None,
    followed: Callable[[], FollowedCourses] | None,
) -> Fault:
    """A refusal as it is, or what is not solved where it blames the data falsely, or which of them do not go with the rest."""
    if fault.kind not in (INCOMPLETE, CONTRADICTORY, UNREACHED):
        return fault
    if not (problem.space and fault.kind == UNREACHED):  # its assembly looks at states, not at the way to them
        from rotsolve.search.complete import unsolved

        with stage("confirm", whole=True):
            if found := unsolved(problem, names, law, whole=fault.kind != INCOMPLETE, followed=followed and followed()):
                return found
    fault = not_found(fault, problem)
    return blamed_fairly(fault, problem) if fault.broken else fault


def blamed_fairly(fault: Fault, problem: Problem) -> Fault:
    """A contradiction with what of the data does not go with the rest, and what would; as it is where no trial tells."""
    from rotsolve.overtold import overtold
    from rotsolve.undriven import undriven

    def solve(trial: Problem) -> Solution:
        with at_most(TRIAL_STEPS):
            return solved_in_parts(trial, None, DIGITS, None)

    return undriven(fault, problem, solve) or overtold(fault, problem, solve) or fault


def not_found(fault: Fault, problem: Problem) -> Fault:
    """What contradicts, told of letters that are sought as what it is: no value is found, by the ways that have been tried."""
    sought = [given.name for given in problem.givens if given.asked]
    if fault.kind == INCOMPLETE or not sought:
        return fault
    return replace(
        fault, message=f"no {' and '.join(f'`{name}`' for name in sought)} is found that fits: {fault.message}"
    )


def solved_in_parts(problem: Problem, law: str | None, digits: int, at: str | None) -> Solution:
    """Solve all questions that have an answer; why the others have none is told beside them."""

    def solve(finds: tuple[Find, ...]) -> Solution:
        own = replace(problem, finds=finds)
        if any(find.seeks for find in finds):
            from rotsolve.seeking import with_sought_unknown

            own = with_sought_unknown(own)
        return solved_as_far(own, law, digits, at)

    if len(problem.finds) > 1 and any(find.where is not None or find.extreme for find in problem.finds):
        from rotsolve.seeking import held_alone, left_without_seeking, where_none_seeks, with_all_verges

        def some(finds: tuple[Find, ...]) -> Solution:
            return each_where_answered(replace(problem, finds=finds), solve)

        found = left_without_seeking(problem, some) or each_where_answered(problem, solve)
        return with_all_verges(problem, held_alone(problem, where_none_seeks(problem, found, some), solve), solve)
    return each_where_answered(problem, solve)


def solved_as_far(problem: Problem, law: str | None, digits: int, at: str | None) -> Solution:
    """Solve all questions of a problem; where they are about states before one that is never reached, without that, and say so."""
    try:
        return solved_together(problem, law, digits, at)
    except NeverReached as error:
        early = before(error.state, problem)
        if early is None or len(early.finds) < len(problem.finds):
            raise
        with suppress(Unsolvable):
            solution = solved_as_far(early, law, digits, at)
            objection = Check((error.fault.message.replace("`", ""), f": {error.fault.help}"), holds=False, beyond=True)
            told = replace(solution.derivation, checks=(*solution.derivation.checks, objection))
            return replace(solution, problem=problem, derivation=told)
        raise


def solved_together(problem: Problem, law: str | None, digits: int, at: str | None) -> Solution:
    """Solve all questions of a problem in one derivation."""
    with stage("arrange", whole=True):
        whole, configuration = made_ready(problem)
    if any(given.value is None and not given.asked for given in configuration.problem.givens):
        solution = solved_by_cases(problem, whole.problem, configuration, law, digits, at)
    else:
        solution = solved(problem, configuration, law, digits, at)
        refuse_idle([solution], problem)

    def confirmation() -> tuple[AnswerConfirmation, ...]:
        from rotsolve.confirm.verdicts import confirmations

        trace, admitted = solution.trace, partial(may_be, problem, whole)
        return confirmations(
            solution.derivation.answers,
            whole.problem,
            trace.letter,
            admitted,
            trace.points,
            partial(limits_of, whole),
            trace.others,
        )

    return replace(solution, trace=replace(solution.trace, confirmation=confirmation))


def limits_of(configuration: Configuration) -> Iterator[Limit]:
    """What a scene asks of its letters; what tells it is loaded when it is asked for."""
    from rotsolve.motion.limits import limits_of_scene

    return limits_of_scene(configuration)


def made_ready(problem: Problem) -> tuple[Configuration, Configuration]:
    """The whole scene made ready for the laws, and the part of it that is asked for."""
    if problem.space:
        from rotsolve.space.complete import configured_in_space

        spatial = configured_in_space(problem)
        return spatial, spatial
    whole = configured(problem)
    if changes_at_last(whole):
        whole = configured(with_hereafter(problem))
    return whole, block_of(whole)


def solved_by_cases(
    problem: Problem, whole: Problem, configuration: Configuration, law: str | None, digits: int, at: str | None
) -> Solution:
    """The solution of a scene with letters that have no number: case by case, where signs hang on them."""
    from rotsolve.motion.limits import limits_of_scene
    from rotsolve.search.cases import cases_of
    from rotsolve.search.letterspace import LetterSpace, at_point

    limits = limits_of_scene(configuration)
    space = LetterSpace(configuration.problem, configuration.signs, configuration.order, limits)
    solutions: list[Solution] = []

    def solve(trial: Mapping[str, Formula]) -> tuple[Derivation, bool]:
        own = at_point(configuration.problem, trial)
        solution = each_where_answered(own, partial(solved_of_case, own, problem, law, digits, at))
        refuse_no_verge(solution, whole, trial)
        solutions.append(solution)
        return solution.derivation, any(check.holds is False for check in solution.derivation.checks)

    def confirming(found: Derivation, numbers: Mapping[str, float]) -> Collection[str]:
        from rotsolve.confirm.verdicts import confirmed_at

        return confirmed_at(found.answers, whole, solutions[-1].trace.letter, numbers)

    cases, more = cases_of(space, solve)
    if not cases:
        raise Exhausted
    if not solutions:
        assert cases[0].fault is not None
        raise as_tried(cases[0].fault, problem)
    refuse_idle(solutions, problem)
    if len(cases) == 1 and not (cases[0].conditions or cases[0].needs or space.assumed or space.limited):
        return replace(solutions[0], problem=problem)
    from rotsolve.derivation.cases import with_cases
    from rotsolve.search.edges import Edges

    cases = [replace(case, fault=fairly_refused(case.fault, case.point, problem, law)) for case in cases]
    points = tuple(case.point for case in cases if case.found is not None and not case.objected)
    told = [one for one in solutions if any(case.found is one.derivation for case in cases)] or solutions[:1]
    trace = replace(solutions[0].trace, points=points, acting=lambda: in_all_cases(told))
    with at_most(None):  # what has been found is told
        derivation = with_cases(cases, Edges(space, solve, confirming), more=more)
    return replace(solutions[0], problem=problem, derivation=derivation, trace=trace)


def in_all_cases(solutions: Sequence[Solution]) -> ActingWays | None:
    """What tells which way forces act in all cases of letters; it is loaded when a picture asks."""
    from rotsolve.search.acting import all_cases

    return all_cases([solution.trace.acting() for solution in solutions])


def refuse_no_verge(solution: Solution, problem: Problem, trial: Mapping[str, Formula]) -> None:
    """Refuse a case of letters in which what is sought as a verge is none: it sticks beyond it too; not on edges, where rounding tells."""
    if problem.space or not any(find.verge for find in problem.finds):
        return
    numbers = {name: float(size.value) for name, size in trial.items() if isinstance(size, Number)}
    if len(numbers) == len(trial):
        from rotsolve.confirm.course.verdict import no_verge_at

        why = no_verge_at(solution.derivation.answers, problem, solution.trace.letter, numbers)
        if why:
            span = next(find.span for find in problem.finds if find.verge)
            raise unsolvable(problem, f"no such value is found: {why}", span, kind=UNSOLVED)


def solved_of_case(
    own: Problem, problem: Problem, law: str | None, digits: int, at: str | None, finds: tuple[Find, ...]
) -> Solution:
    """Some questions of a case of letters; those about states before one that is never reached in it without that, beside others."""
    asked = replace(own, finds=finds)
    while True:
        try:
            return solved(problem, Configuration(asked), law, digits, at)
        except NeverReached as error:
            early = before(error.state, asked) if finds != own.finds else None
            if early is None or early.finds != finds:
                raise
            asked = early


def fairly_refused(
    error: Exception | None, point: Mapping[str, Fraction], problem: Problem, law: str | None
) -> Exception | None:
    """Why a case of letters has no answer, as it is or by what the assembly says at its numbers."""
    if not isinstance(error, Unsolvable) or error.fault.kind not in (CONTRADICTORY, UNREACHED):
        return error
    givens = [replace(item, value=Number(point[item.name])) if item.name in point else item for item in problem.givens]
    at_point = replace(problem, givens=tuple(givens))
    fault = fair_refusal(error.fault, [find.name for find in problem.finds], at_point, law)
    return (
        error if fault is error.fault else unsolvable(problem, fault.message, fault.span, fault.help, kind=fault.kind)
    )


def may_be(problem: Problem, configuration: Configuration, numbers: Mapping[str, float]) -> bool:
    """Whether the scene as written may have such numbers, in SI units, for its letters: what is cut out of a body lies within it."""
    known = {name: Number(Fraction(size)) for name, size in numbers.items()}
    signs = SignOracle({**problem.values, **known})
    told = ((signs.by_numbers(limit.gap), limit.strict) for limit in limits_of(configuration))
    if any(sign == -1 or (sign == 0 and strict) for sign, strict in told):
        return False
    open_ = [given for given in problem.givens if given.value is None and not (given.asked or given.automatic)]
    settings = {
        item.name: f"{numbers[item.name]!r} {base_unit_text(item.dimension) if item.dimension else ''}"
        for item in open_
        if item.name in numbers  # that of a letter which a question seeks is its answer
    }
    try:
        read_text("\n".join(problem.lines), problem.file, {**dict(problem.settings), **settings})
    except SceneError:
        return False
    return True


def refuse_idle(solutions: Sequence[Solution], problem: Problem) -> None:
    """Refuse what the scene says and nothing has read in any of its cases, all at once."""
    idle = set.intersection(*(set(solution.trace.idle) for solution in solutions))
    if idle:
        raise SceneError(idle, problem.lines, problem.file)


def asked_part(problem: Problem) -> Configuration:
    """The part of the problem that is asked for, made ready for the laws, once all of it has been checked."""
    return made_ready(problem)[1] if problem.space else block_of(configured(problem))


def block_of(configuration: Configuration) -> Configuration:
    """The part of a scene that is asked for."""
    block = asked_block(configuration.problem)
    return configuration if block is configuration.problem else Configuration(block)
