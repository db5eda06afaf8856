"""Solving: one choice of laws carried out on a configuration, state by state, to a derivation with its checks."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from msgspec.structs import replace

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.derivation import Section
from rotsolve.core.equation import FAMILIES
from rotsolve.core.faults import Contradicted, Impossible, NeverReached, Unsolvable
from rotsolve.core.symbols import CONSTANT, POSITION, TIME, has_quantities
from rotsolve.derivation.checks import checks
from rotsolve.derivation.compose import DerivationComposer
from rotsolve.derivation.results import with_missing_told
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.block import left_out
from rotsolve.language.problem import COMES_TO, Find, Path, Problem, State, Term, TimeValue, before
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.hereafter import sticks_at_last, with_hereafter
from rotsolve.motion.rubs import rough_blows, rubs
from rotsolve.motion.timeline import Interval
from rotsolve.paths.meaning import NotYet
from rotsolve.profile import counted, skipped, stage
from rotsolve.scene.idle import idle_words, noted
from rotsolve.search.answering import answered
from rotsolve.search.answers import NoAnswer, unsolvable
from rotsolve.search.consistency import KnownBalls, contradiction, just_stops, turned_back, untimely
from rotsolve.search.planning import families_for
from rotsolve.search.search import Search, asked_letter
from rotsolve.solution import Solution, Trace

if TYPE_CHECKING:
    from rotsolve.algebra.formula import Formula
    from rotsolve.derivation.meanings import Meanings
    from rotsolve.derivation.requirements import Validity
    from rotsolve.search.acting import ActingWays
    from rotsolve.search.friction import Decision


Found = tuple[Search, KnownBalls]  # a search that has answered all questions, and the numbers found


def solved(problem: Problem, configuration: Configuration, law: str | None, digits: int, at: str | None) -> Solution:
    """The solution of a scene by one choice of laws."""
    configuration = Configuration(noted(configuration.problem), configuration.alteration)
    try:
        decision, (search, balls) = searched(configuration, law)
    except NeverReached as error:
        raise really_missed(error, configuration, law) from None
    if at is not None and not search.scene.configuration.mentions.functions:
        raise unsolvable(problem, "nothing that is asked is a function of time", None, "ask for it `at any time`")
    search, balls = drawn_as_acting((search, balls), law)
    if law is not None:
        check_law(search, law)
    return composed(problem, search, balls, decision, digits, at)


def drawn_as_acting(found: Found, law: str | None) -> Found:
    """What is found with each friction drawn the way in which it is known to act; as it was where none acts otherwise."""
    search, scene = found[0], found[0].scene
    if not any(quantity.kind == "friction_force" for quantity in scene.registry.quantities.values()):
        return found
    from rotsolve.search.acting import acting_forward

    forward = acting_forward(search)
    if not forward:
        return found
    drawn = SceneEquations(replace(scene.configuration, forward=forward), scene.modes)
    again = answered_fully(Search(drawn, families_for(law), spare=law is not None, careful=search.careful))
    return found if isinstance(again, Unsolvable) else again


def searched(configuration: Configuration, law: str | None) -> tuple[Decision | None, Found]:
    """The answers to all questions; where a state is never reached with a root for a letter that is sought, or another letter can not be
    what it is with it, with the other roots."""
    passed: dict[str, list[Formula]] = {}
    first: Unsolvable | None = None
    while True:
        picked: dict[str, Formula] = {}
        try:
            return searched_beyond(configuration, law, passed, picked)
        except (NeverReached, Impossible) as error:
            first = first or error
            letter = next((name for name, root in picked.items() if root not in passed.get(name, ())), None)
            if letter is None:
                raise first from None
            passed.setdefault(letter, []).append(picked[letter])
        except Unsolvable as error:
            raise first or error from None


def searched_beyond(
    configuration: Configuration, law: str | None, passed: dict[str, list[Formula]], picked: dict[str, Formula]
) -> tuple[Decision | None, Found]:
    """The answers to all questions, with a state more wherever the laws of a phase end before it does.

    Roots that are `passed` over for a letter that is sought are not taken; those taken are noted in `picked`.
    """
    first: Unsolvable | None = None
    while True:
        decision, search = prepared(configuration, law)
        assert search.ground is not None
        search.ground.passed_over, search.ground.picked = passed, picked
        found = answered_fully(search)
        if search.ground and search.ground.chose and doubtful(found):  # perhaps by a root that is not meant
            again = answered_fully(Search(search.scene, search.families, search.spare, careful=True))
            found = likelier(found, again)
        if never_gets_there(found):
            break
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


def really_missed(error: NeverReached, configuration: Configuration, law: str | None) -> NeverReached:
    """A state that is never reached, or, where the scene that ends with that reaches it, the one after it."""
    problem = configuration.problem
    names = [state.name for state in problem.states]
    place = names.index(error.state) if error.state in names else len(names)
    if not 0 < place < len(names) - 1:
        return error
    state, later = names[place], problem.states[place + 1]
    clock = Find("", Symbol("#0"), (Term(Path("", "time"), start=names[0], end=state),))
    ended = before(later.name, problem) or before(later.name, replace(problem, finds=(clock,)))
    if ended is None or any(event.to == later.name for event in problem.events):
        return error
    try:
        searched(Configuration(ended), law)
    except Unsolvable:
        return error
    from rotsolve.search.explain import unreachable

    return unreachable(problem, state, later.name, later.span, f"it comes to `{state}`, and from there not so far")


def likelier(found: Found | Unsolvable, again: Found | Unsolvable) -> Found | Unsolvable:
    """Of what is found and what is found with more care the latter, where it says something that time can bring about."""
    if isinstance(again, Unsolvable):
        return again if never_gets_there(again) else found
    return found if isinstance(found, NeverReached) and untimely(*again) else again


def never_gets_there(found: Found | Unsolvable) -> bool:
    """Whether a state is surely never reached."""
    return isinstance(found, NeverReached) and found.sure


def turnable(search: Search) -> bool:
    """Whether a motion goes by its place, so that it may turn back on its way."""
    return any(travel.pace == POSITION for over in search.scene.passages.values() for travel in over.travels)


def steady_and_untimed(search: Search, balls: KnownBalls) -> list[Interval]:
    """The phases with steady accelerations of which nothing that is asked tells how long they last, up to a state that tells a rate."""
    timeline, found = search.scene.configuration.timeline, list[Interval]()
    for interval in timeline.intervals:
        over = search.scene.passages.get(interval.name)
        steady = over is not None and any(travel.pace == CONSTANT for travel in over.travels)
        if over is not None and steady and tells_rate(timeline.state(interval.end)):
            untold = has_quantities(over.times[1]) and balls.size(over.duration) is None
            found += [interval] if untold else []
    return found


def tells_rate(state: State) -> bool:
    """Whether a state tells how fast something moves, or that it does not slip."""
    paths = [line.path.quantity for line in state.conditions if line.path is not None and line.value is not None]
    said = any(line.word in ("rolls", "sticks") or line.rest for line in state.conditions)
    return said or not {"velocity", "angular_velocity"}.isdisjoint(paths)


def nears(search: Search) -> bool:
    """Whether a state may be one to which nothing comes: forces vary with the motion, a quantity is largest there, something decays."""
    if any(found.formula is not None and found.formula.holds("log") for found in search.solver.solved.values()):
        return True
    lines = (line for state in search.scene.configuration.problem.states for line in state.conditions)
    travels = (travel for over in search.scene.passages.values() for travel in over.travels)
    return any(line.word in COMES_TO for line in lines) or any(
        travel.pace not in (CONSTANT, TIME) for travel in travels
    )


def doubtful(found: Found | Unsolvable) -> bool:
    """Whether another root may be meant: there is no answer, or none that time brings about."""
    return isinstance(found, Unsolvable) or untimely(*found)


def prepared(configuration: Configuration, law: str | None) -> tuple[Decision | None, Search]:
    """The scene as friction lets it move, ready to be asked."""
    try:
        with stage("friction", whole=True):
            decision = None if configuration.problem.space else decided(configuration)
        with stage("laws"):
            scene = (decision and decision.scene) or scene_equations_of(configuration)
            return decision, Search(scene, families_for(law), spare=law is not None)
    except NotYet as error:
        raise unsolvable(configuration.problem, str(error), error.span, error.help) from None
    except Unsolvable as error:
        fault = error.fault
        told = unsolvable(configuration.problem, fault.message, fault.span, fault.help)
        raise error if error.lines else told from None


def scene_equations_of(configuration: Configuration) -> SceneEquations:
    """The scene with its equations: one in space by its own geometry, loaded when a scene is one."""
    if configuration.problem.space:
        from rotsolve.space.scene import SpaceEquations

        return SpaceEquations(configuration)
    return SceneEquations(configuration)


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
    from rotsolve.search.endings import Endings
    from rotsolve.search.openings import with_state_at

    with stage("solve"):
        endings, configuration = Endings(search, stuck), search.scene.configuration
        ending = endings.first()
        if ending is not None:
            return with_state_at(configuration.problem, ending)
        held = endings.held_at_last()
        if held:
            return with_hereafter(configuration.problem, held)
        if not rubs(configuration):
            return None
        if not any(given.asked for given in configuration.problem.givens):
            return None
        from rotsolve.search.ways import with_friction_found, with_way_found

        told = with_way_found(search, stuck=stuck)
        return told if told is not None or stuck else with_friction_found(search)


def solved_for(letter: str, search: Search) -> Formula | float | None:
    """What the answers make of a letter of the laws, if only aside: a formula of givens, else a number."""
    try:
        found = (
            search.solver.solved.get(letter) or search.beside_by(families_for(None)).answer(asked_letter(letter)).found
        )
    except NoAnswer:
        return None
    return found.formula or (None if found.number is None else found.number.float)


def ways_by(searches: tuple[Search, ...]) -> ActingWays:
    """What tells which way forces act; it is loaded when a picture asks."""
    from rotsolve.search.acting import ActingWays

    return ActingWays(searches)


def other_roots(letter: str, search: Search) -> tuple[Formula, ...]:
    """The roots beside that which the answers make of a letter of the scene, if only aside."""
    own = search if letter in search.solver.solved else search.beside_by(families_for(None))
    return tuple(own.solver.with_found(root) for root in own.rivals.get(letter, ()))


def decided(configuration: Configuration) -> Decision | None:
    """How all that rubs behaves; None where nothing does, and no state says how a contact moves."""
    spoken_of = any(line.word for state in configuration.timeline.states for line in state.conditions)
    if not (spoken_of or rubs(configuration) or rough_blows(configuration)):
        return None
    from rotsolve.search.friction import check_goes_on, decide, said_otherwise

    decision = decide(configuration)
    for clash in said_otherwise(configuration, decision.modes):
        raise clash
    if sticks_at_last(configuration.problem):
        check_goes_on(configuration)
    return decision


def composed(
    problem: Problem, search: Search, balls: KnownBalls, decision: Decision | None, digits: int, at: str | None
) -> Solution:
    """The answers of a search as a derivation with its checks."""
    with stage("compose", whole=True):
        slipped, first = sections_before(decision)
        moment = evaluation_time(at)
        composer = DerivationComposer(search, first, moment)
    with stage("verify", whole=True):
        held = checks(search, composer.letters, balls, moment)
        used = [search.planner.pool[index] for answered in search.answered for index in answered.used]
        idle = idle_words(search.scene, used)  # what is read from here on is none of the solution
    with stage("compose", whole=True):
        trials = () if decision is None else decision.trials
        derivation = with_missing_told(composer.derivation(held, slipped, trials), composer.problem)
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
        acting=lambda: ways_by((search,)),
        by_law=lambda law: solved(problem, search.scene.configuration, law, digits, at).derivation,
        letter=lambda letter: solved_for(letter, search),
        others=lambda letter: other_roots(letter, search),
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


def check_consistent(search: Search) -> KnownBalls:
    """The answers, and what follows from them, as numbers; they must agree with everything that the laws write about the scene."""
    back = turned_back(search)
    if back is not None:
        from rotsolve.search.explain import turns_back

        raise turns_back(back, search.scene.configuration.problem)
    broken, balls = contradiction(search)
    if broken is not None:
        from rotsolve.search.explain import contradicted, with_way

        raise with_way(contradicted(broken, search.scene), search)
    if search.scene.encounters:
        from rotsolve.derivation.requirements import let_go

        for refusal in let_go(search):
            raise refusal
    configuration = search.scene.configuration
    problem = configuration.problem
    stopped = any(just_stops(travel, search) for over in search.scene.passages.values() for travel in over.travels)
    if stopped or nears(search):
        from rotsolve.search.reached import not_reached

        for refusal in not_reached(search):
            raise refusal
    if untimed := steady_and_untimed(search, balls):
        from rotsolve.search.reached import led_away_from

        for refusal in led_away_from(untimed, search):
            raise refusal
    if any(search.scene.configuration.rides(state.name) for state in problem.states):
        from rotsolve.search.riding import barred_rides

        for gone in barred_rides(search):
            raise gone
    if problem.space and problem.states:
        from rotsolve.search.coming import not_come_to

        for missed in not_come_to(search):
            raise missed
    if any(given.asked for given in problem.givens) or any(find.where is not None for find in problem.finds):
        from rotsolve.search.within import out_of_bounds

        for refusal in out_of_bounds(search):
            raise refusal
    for value, (sign, question, span) in configuration.supposed.items():
        settled = settled_aside(value, search)
        told = configuration.signs.sign(settled)
        size = balls.size(settled) if told is None else None  # a letter without a closed form has its ball
        if told != sign and (size is None or not size * sign > 0):
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
        from rotsolve.search.uncovered import why_uncovered

        others = ", ".join(FAMILIES[name].words for name in FAMILIES if name in used)
        reason = why_uncovered(law, problem.finds[0], search.scene) if others else ""
        message = f"{FAMILIES[law].words} {FAMILIES[law].does} not settle anything that is asked here{reason}"
        why = "".join(f"; {reason}" for reason in search.scene.not_restated[:1])
        raise unsolvable(problem, message, None, f"it takes {others or 'none of the laws: leave `--law` out'}{why}")
