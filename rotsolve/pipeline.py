"""Pipeline: the arrows in order: scene text → problem → scene (facts, equations) → search (plan, solve) → derivation with checks."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from contextlib import suppress
from fractions import Fraction
from functools import partial
from typing import TYPE_CHECKING, Any

from msgspec.structs import replace

from rotsolve.algebra.certified.ball import witnessed
from rotsolve.algebra.formula import Formula, Number, Symbol
from rotsolve.algebra.units.dimension import base_unit_text
from rotsolve.core.derivation import Check, Derivation, Refusal, Section
from rotsolve.core.equation import FAMILIES
from rotsolve.core.faults import CONTRADICTORY, INCOMPLETE, Contradicted, Fault, NeverReached, SceneError, Unsolvable
from rotsolve.core.symbols import POSITION
from rotsolve.derivation.checks import checks
from rotsolve.derivation.compose import DerivationComposer
from rotsolve.derivation.results import with_missing_told
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Problem, TimeValue, before
from rotsolve.motion.block import asked_block, left_out
from rotsolve.motion.complete import configured
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.hereafter import changes_at_last, with_hereafter
from rotsolve.motion.rubs import rubs
from rotsolve.paths.meaning import NotYet
from rotsolve.profile import counted, skipped, stage
from rotsolve.scene.idle import idle_words, noted
from rotsolve.scene.read import read_source, read_text
from rotsolve.search.answering import Unanswered, answered, needed_for
from rotsolve.search.answers import NoAnswer, unsolvable
from rotsolve.search.consistency import KnownBalls, contradiction, turned_back, untimely
from rotsolve.search.planning import families_for
from rotsolve.search.search import Search, asked_letter
from rotsolve.solution import Solution, Trace

if TYPE_CHECKING:
    from rotsolve.algebra.formula import Formula
    from rotsolve.core.derivation import AnswerConfirmation
    from rotsolve.derivation.meanings import Meanings
    from rotsolve.derivation.requirements import Validity
    from rotsolve.search.friction import Decision

DIGITS, MOST_DIGITS = 4, 1000


def solve(
    source: str | os.PathLike[str],
    *,
    law: str | None = None,
    settings: Mapping[str, str] | None = None,
    digits: int = DIGITS,
    at: str | None = None,
    confirm: bool = True,
) -> Solution:
    """Solve a scene: a path, or YAML text (text with a line break); functions of time are evaluated `at` a time such as "2 s".

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
    if not 1 <= digits <= MOST_DIGITS:
        raise ValueError(f"from 1 to {MOST_DIGITS} digits can be asked for, not {digits}")
    if law is not None and law not in FAMILIES:
        raise ValueError(f"unknown law {law!r}; one of {', '.join(FAMILIES)}")
    solution = refused_fairly(problem, law, digits, at)
    if not confirm:
        return solution
    from rotsolve.confirm.course.verdict import confirmed

    with stage("confirm", whole=True):
        verdicts = () if solution.trace.confirmation is None else solution.trace.confirmation()
        return replace(solution, derivation=confirmed(replace(solution.derivation, confirmed=verdicts), problem))


def refused_fairly(problem: Problem, law: str | None, digits: int, at: str | None) -> Solution:
    """The solution; what is refused as incomplete or contradictory is so to an assembly of all bodies' equations too."""
    try:
        solution = solved_in_parts(problem, law, digits, at)
    except Unsolvable as error:
        fault = fair_refusal(error.fault, problem, [find.name for find in problem.finds], law)
        raise error if fault is error.fault else unsolvable(problem, fault.message, fault.span, fault.help) from None
    if not solution.derivation.refused:
        return solution
    refused = [
        replace(item, fault=fair_refusal(item.fault, problem, [item.name], law)) for item in solution.derivation.refused
    ]
    return replace(solution, derivation=replace(solution.derivation, refused=tuple(refused)))


def fair_refusal(fault: Fault, problem: Problem, names: Sequence[str], law: str | None) -> Fault:
    """A refusal of some questions as it is, or, where it falsely blames the scene's data, what is not solved."""
    if fault.kind not in (INCOMPLETE, CONTRADICTORY):
        return fault
    from rotsolve.search.complete import unsolved

    with stage("confirm", whole=True):
        return unsolved(problem, names, law, whole=fault.kind == CONTRADICTORY) or fault


def solved_in_parts(problem: Problem, law: str | None, digits: int, at: str | None) -> Solution:
    """Solve all questions that have an answer; why the others have none is told beside them."""
    try:
        return solved_as_far(problem, law, digits, at)
    except Unsolvable as error:
        if len(problem.finds) < 2 or (isinstance(error, Contradicted) and not isinstance(error, NeverReached)):
            raise
        if isinstance(error, NeverReached):
            early = before(error.state, problem)
            if early is None or not early.finds:
                raise
            solution = solved_as_far(replace(problem, finds=early.finds), law, digits, at)
            refused: Mapping[str, Unsolvable] = {find.name: error for find in problem.finds if find not in early.finds}
        else:
            solution, refused = solved_without(error, problem, law, digits, at)
    told = tuple(Refusal(name, error.fault) for name, error in refused.items())
    finds = tuple(dict.fromkeys((Symbol(find.group),) for find in problem.finds))
    return replace(solution, problem=problem, derivation=replace(solution.derivation, refused=told, finds=finds))


def solved_without(
    error: Unsolvable, problem: Problem, law: str | None, digits: int, at: str | None
) -> tuple[Solution, Mapping[str, Unsolvable]]:
    """The solution without the questions that have no answer, and these with their reasons: those that an error names, if it does."""
    known = error.refused if isinstance(error, Unanswered) else {}
    for refused in (known, None):
        refused = told_apart(problem, law, at) if refused is None else refused
        kept = tuple(find for find in problem.finds if find.name not in refused)
        if not kept or len(kept) == len(problem.finds):
            continue
        with suppress(Unsolvable):
            return solved_as_far(replace(problem, finds=kept), law, digits, at), refused
    raise error


def told_apart(problem: Problem, law: str | None, at: str | None) -> dict[str, Unsolvable]:
    """The questions of a scene that have no answer, by name, each with its reason: what is found with all it needs, and nothing else."""
    refused: dict[str, Unsolvable] = {}
    for find in problem.finds:
        for finds in needed_for(find, problem):
            try:
                solved_as_far(replace(problem, finds=finds), law, DIGITS, at)
            except Unsolvable as error:
                refused.setdefault(find.name, error)
            else:
                refused.pop(find.name, None)
                break
    return refused


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
            objection = Check((error.fault.message.replace("`", ""), f": {error.fault.help}"), holds=False)
            told = replace(solution.derivation, checks=(*solution.derivation.checks, objection))
            return replace(solution, problem=problem, derivation=told)
        raise


def solved_together(problem: Problem, law: str | None, digits: int, at: str | None) -> Solution:
    """Solve all questions of a problem in one derivation."""
    with stage("arrange", whole=True):
        whole = configured(problem)
        if changes_at_last(whole):
            whole = configured(with_hereafter(problem))
        configuration = block_of(whole)
    if any(given.value is None and not given.asked for given in configuration.problem.givens):
        solution = solved_by_cases(problem, configuration, law, digits, at)
    else:
        solution = solved(problem, configuration, law, digits, at)
        refuse_idle([solution], problem)

    def case(values: Mapping[str, Formula]) -> tuple[Solution, Mapping[Formula, int]]:
        return case_of(problem, values, law, digits, at)

    def confirmation() -> tuple[AnswerConfirmation, ...]:
        from rotsolve.confirm.course.verdict import confirmations

        trace = solution.trace
        return confirmations(
            solution.derivation.answers, whole.problem, trace.letter, partial(may_be, problem), trace.points
        )

    return replace(solution, trace=replace(solution.trace, case=case, confirmation=confirmation))


def case_of(
    problem: Problem, values: Mapping[str, Formula], law: str | None, digits: int, at: str | None
) -> tuple[Solution, Mapping[Formula, int]]:
    """The solution in letters for some givens in the case that their values are of, and the signs that it took."""
    from rotsolve.search.letterspace import any_point, at_point, numbers_of, open_letters

    freed = tuple([replace(item, value=None) if item.name in values else item for item in problem.givens])
    configuration = asked_part(replace(problem, givens=freed))
    own = configuration.problem
    point = {**numbers_of(any_point(open_letters(own))), **values}
    with witnessed() as witness:
        solution = solved(problem, Configuration(at_point(own, point)), law, digits, at)
    needed = {value: sign for value, (sign, _) in witness.needed.items()}
    return solution, {**witness.supposed, **needed}


def solved_by_cases(
    problem: Problem, configuration: Configuration, law: str | None, digits: int, at: str | None
) -> Solution:
    """The solution of a scene with letters that have no number: case by case, where signs hang on them."""
    from rotsolve.search.cases import cases_of
    from rotsolve.search.letterspace import LetterSpace, at_point, numbers_of

    rooms = [room for item in configuration.problem.connections for room in item.rooms(configuration)]
    space = LetterSpace(configuration.problem, configuration.signs, configuration.order, rooms)
    solutions: list[Solution] = []

    def solve(point: Mapping[str, Fraction]) -> tuple[Derivation, bool]:
        own = Configuration(at_point(configuration.problem, numbers_of(point)))
        solutions.append(solved(problem, own, law, digits, at))
        derivation = solutions[-1].derivation
        return derivation, any(check.holds is False for check in derivation.checks)

    cases, more = cases_of(space, solve)
    if not solutions:
        assert cases[0].fault is not None
        raise cases[0].fault
    refuse_idle(solutions, problem)
    if len(cases) == 1 and not (cases[0].conditions or cases[0].needs or space.assumed):
        return solutions[0]
    from rotsolve.derivation.cases import with_cases

    cases = [replace(case, fault=fairly_refused(case.fault, case.point, problem, law)) for case in cases]
    points = tuple(case.point for case in cases if case.found is not None and not case.objected)
    trace = replace(solutions[0].trace, points=points)
    return replace(solutions[0], derivation=with_cases(cases, space, more=more), trace=trace)


def fairly_refused(
    error: Exception | None, point: Mapping[str, Fraction], problem: Problem, law: str | None
) -> Exception | None:
    """Why a case of letters has no answer, as it is or by what the assembly says at its numbers."""
    if not isinstance(error, Unsolvable) or error.fault.kind != CONTRADICTORY:
        return error
    givens = [replace(item, value=Number(point[item.name])) if item.name in point else item for item in problem.givens]
    at_point = replace(problem, givens=tuple(givens))
    fault = fair_refusal(error.fault, at_point, [find.name for find in problem.finds], law)
    return error if fault is error.fault else unsolvable(problem, fault.message, fault.span, fault.help)


def solved(problem: Problem, configuration: Configuration, law: str | None, digits: int, at: str | None) -> Solution:
    """The solution of a scene by one choice of laws."""
    configuration = Configuration(noted(configuration.problem), configuration.alteration)
    decision, (search, balls) = searched(configuration, law)
    if at is not None and not search.scene.configuration.mentions.functions:
        raise unsolvable(problem, "nothing that is asked is a function of time", None, "ask for it `at any time`")
    if law is not None:
        check_law(search, law)
    return composed(problem, search, balls, decision, digits, at)


Found = tuple[Search, KnownBalls]  # a search that has answered all questions, and the numbers found


def searched(configuration: Configuration, law: str | None) -> tuple[Decision | None, Found]:
    """The answers to all questions, with a state more wherever the laws of a phase end before it does."""
    first: Unsolvable | None = None
    while True:
        decision, search = prepared(configuration, law)
        found = answered_fully(search)
        if search.ground and search.ground.chose and doubtful(found):  # perhaps by a root that is not meant
            again = answered_fully(Search(search.scene, search.families, search.spare, careful=True))
            found = found if isinstance(again, Unsolvable) else again
        stuck = isinstance(found, Unsolvable)
        reached = search if isinstance(found, Unsolvable) else found[0]
        further = following(reached, stuck=stuck) if decision is not None or turnable(reached) else None
        if further is None:
            break
        first, configuration = first or (found if isinstance(found, Unsolvable) else None), Configuration(further)
    if isinstance(found, Unsolvable):
        raise found if isinstance(found, Contradicted) else first or found
    if untimely(*found):
        from rotsolve.search.endings import not_in_time

        not_in_time(*found)
    return decision, found


def turnable(search: Search) -> bool:
    """Whether a motion goes by its place, so that it may turn back on its way."""
    return any(travel.pace == POSITION for over in search.scene.passages.values() for travel in over.travels)


def doubtful(found: Found | Unsolvable) -> bool:
    """Whether another root may be meant: there is no answer, or none that time brings about."""
    return isinstance(found, Unsolvable) or untimely(*found)


def prepared(configuration: Configuration, law: str | None) -> tuple[Decision | None, Search]:
    """The scene as friction lets it move, ready to be asked."""
    try:
        with stage("friction", whole=True):
            decision = decided(configuration)
        with stage("laws"):
            scene = (decision and decision.scene) or SceneEquations(configuration)
            return decision, Search(scene, families_for(law), spare=law is not None)
    except NotYet as error:
        raise unsolvable(configuration.problem, str(error), error.span, error.help) from None
    except Unsolvable as error:
        fault = error.fault
        told = unsolvable(configuration.problem, fault.message, fault.span, fault.help)
        raise error if error.lines else told from None


def answered_fully(search: Search) -> Found | Unsolvable:
    """Answer all questions, and hold the answers against everything else; or why that fails."""
    problem = search.scene.configuration.problem
    try:
        with stage("solve"):
            if any(state.opened for state in problem.states):
                from rotsolve.search.openings import tell_openings

                tell_openings(search)
            search = answered(search, problem.finds)
        with stage("verify", whole=True):
            return search, check_consistent(search)
    except Unsolvable as error:
        return error


def following(search: Search, *, stuck: bool) -> Problem | None:
    """The problem with a state more, where the laws of a phase end before it does; or told what friction there is, where that matters."""
    from rotsolve.search.endings import Endings, with_state_at

    with stage("solve"):
        ending, configuration = Endings(search, stuck).first(), search.scene.configuration
        if ending is not None:
            return with_state_at(configuration.problem, ending)
        if not rubs(configuration):
            return None
        if any(given.asked for given in configuration.problem.givens):
            from rotsolve.search.ways import with_way_found

            told = with_way_found(search, stuck=stuck)
            if told is not None or stuck:
                return told
        from rotsolve.search.friction import with_friction_found

        return None if stuck else with_friction_found(search)


def may_be(problem: Problem, numbers: Mapping[str, float]) -> bool:
    """Whether the scene as written may have such numbers, in SI units, for its letters: what is cut out of a body lies within it."""
    open_ = [given for given in problem.givens if given.value is None and not (given.asked or given.automatic)]
    settings = {
        item.name: f"{numbers[item.name]!r} {base_unit_text(item.dimension) if item.dimension else ''}"
        for item in open_
    }
    try:
        read_text("\n".join(problem.lines), problem.file, settings)
    except SceneError:
        return False
    return True


def refuse_idle(solutions: Sequence[Solution], problem: Problem) -> None:
    """Refuse what the scene says and nothing has read in any of its cases, all at once."""
    idle = set.intersection(*(set(solution.trace.idle) for solution in solutions))
    if idle:
        raise SceneError(idle, problem.lines, problem.file)


def solved_for(letter: str, search: Search) -> Formula | float | None:
    """What the answers make of a letter of the laws, if only aside: a formula of givens, else a number."""
    try:
        found = (
            search.solver.solved.get(letter) or search.beside_by(families_for(None)).answer(asked_letter(letter)).found
        )
    except NoAnswer:
        return None
    return found.formula or (None if found.number is None else found.number.float)


def decided(configuration: Configuration) -> Decision | None:
    """How all that rubs behaves; None where nothing does, and no state says how a contact moves."""
    spoken_of = any(line.word for state in configuration.timeline.states for line in state.conditions)
    if not spoken_of and not rubs(configuration):
        return None
    from rotsolve.search.friction import decide, said_otherwise

    decision = decide(configuration)
    for clash in said_otherwise(configuration, decision.modes):
        raise clash
    return decision


def composed(
    problem: Problem, search: Search, balls: KnownBalls, decision: Decision | None, digits: int, at: str | None
) -> Solution:
    """The answers of a search as a derivation with its checks."""
    with stage("compose", whole=True):
        before, first = sections_before(decision)
        composer = DerivationComposer(search, first, evaluation_time(at))
    with stage("verify", whole=True):
        held = checks(search, composer.letters, balls)
        idle = idle_words(search.scene)  # what is read from here on is none of the solution
    with stage("compose", whole=True):
        trials = () if decision is None else decision.trials
        derivation = with_missing_told(composer.derivation(held, before, trials), composer.problem)
    beside = left_out(problem, composer.problem)
    skipped("bodies", beside)
    counted("equations written", derivation.equations_written)
    counted("equations used", derivation.equations_used)
    trace = Trace(
        lambda: stages_before().facts_text(search.scene, beside),
        lambda: stages_before().equations_text(search, composer.letters),
        lambda: stages_before().plan_text(search, composer.letters),
        lambda: validity_of(search),
        lambda: meanings_of(composer),
        idle=idle,
        letter=lambda letter: solved_for(letter, search),
    )
    return Solution(problem=problem, derivation=derivation, trace=trace, digits=digits)


def sections_before(decision: Decision | None) -> tuple[tuple[Section, ...], int]:
    """The sections that show what slips, and the number of the first equation after them."""
    if decision is None or not decision.slipping:
        return (), 1
    from rotsolve.derivation.friction import slipping_sections

    return slipping_sections(decision.slipping)


def evaluation_time(at: str | None) -> TimeValue | None:
    """The time at which functions of time are evaluated."""
    if at is None:
        return None
    from rotsolve.scene.values import read_time

    return read_time(at)


def stages_before() -> Any:
    """What prints the stages before the derivation; loaded when someone asks for one."""
    from rotsolve.derivation import stages

    return stages


def validity_of(search: Search) -> Validity:
    """For which numbers the closed forms hold; worked out when someone asks."""
    from rotsolve.derivation.requirements import validity

    return validity(search)


def meanings_of(composer: DerivationComposer) -> Meanings:
    """What the letters of the scene stand for; worked out when someone asks."""
    from rotsolve.derivation.meanings import Meanings

    return Meanings(composer)


def asked_part(problem: Problem) -> Configuration:
    """The part of the problem that is asked for, made ready for the laws, once all of it has been checked."""
    return block_of(configured(problem))


def block_of(configuration: Configuration) -> Configuration:
    """The part of a scene that is asked for."""
    block = asked_block(configuration.problem)
    return configuration if block is configuration.problem else Configuration(block)


def check_consistent(search: Search) -> KnownBalls:
    """The answers, and what follows from them, as numbers; they must agree with everything that the laws write about the scene."""
    back = turned_back(search)
    if back is not None:
        from rotsolve.search.explain import turns_back

        raise turns_back(back, search.scene.configuration.problem)
    broken, balls = contradiction(search)
    if broken is not None:
        from rotsolve.search.explain import contradicted

        raise contradicted(broken, search.scene)
    if search.scene.encounters:
        from rotsolve.derivation.requirements import let_go

        for refusal in let_go(search):
            raise refusal
    configuration = search.scene.configuration
    if any(given.asked for given in configuration.problem.givens):
        from rotsolve.search.within import out_of_bounds

        for refusal in out_of_bounds(search):
            raise refusal
    for value, (sign, question, span) in configuration.supposed.items():
        if configuration.signs.sign(settled_aside(value, search)) != sign:
            raise configuration.undecided(value, question, span)
    return balls


def settled_aside(value: Formula, search: Search) -> Formula:
    """A formula of letters that are asked for, with what they are put in; those that no question asks for are worked out aside."""
    value = search.solver.with_found(value)
    for name in sorted(value.symbols() - search.values.keys()):
        try:
            found = search.apart().value_of(name)
        except NoAnswer:
            continue
        value = value if found is None else value.substitute({name: found})
    return value


def check_law(search: Search, law: str) -> None:
    """A law asked for must have a part in the solution."""
    used = {search.planner.pool[index].family for answered in search.answered for index in answered.used}
    problem = search.scene.configuration.problem
    if used - {""} and law not in used:
        others = ", ".join(FAMILIES[name].words for name in FAMILIES if name in used)
        message = f"{FAMILIES[law].words} does not settle anything that is asked here"
        raise unsolvable(problem, message, None, f"it takes {others}")
