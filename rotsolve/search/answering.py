"""Answering: every question of a scene in turn, so that one without an answer takes no other with it.

One that waits for another is tried again; where a law asked for does not reach, Newton's laws help out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from typing import TypeVar

from msgspec.structs import replace

from rotsolve.algebra.effort import Exhausted, Purse
from rotsolve.algebra.exact.normal import is_zero, without_direction
from rotsolve.algebra.formula import Symbol
from rotsolve.core.equation import NEWTON
from rotsolve.core.faults import CONTRADICTORY, INCOMPLETE, UNREACHED, Unsolvable
from rotsolve.core.letters import letters_of
from rotsolve.core.symbols import is_key
from rotsolve.core.vectors.heading import RIGHT, UP, Vector
from rotsolve.language.problem import Find, Problem, Term, references
from rotsolve.motion.timeline import Timeline
from rotsolve.paths.meaning import NotYet, Unclear
from rotsolve.paths.points import resting
from rotsolve.questions.find import Asked, entries, question_for
from rotsolve.search.answers import Answered, NoAnswer, unsolvable
from rotsolve.search.planning import families_for
from rotsolve.search.search import Search, asked_letter, is_unreal, places_and_speeds

Got = TypeVar("Got")
Refused = list[tuple[Find, Unsolvable]]  # the questions without an answer, each with its reason


BEHIND = 0.5  # how far a size stands behind its components, between two moments


class Unanswered(Unsolvable):
    """Questions that have no answer even alone, by name, each with its reason."""

    def __init__(self, refused: dict[str, Unsolvable]) -> None:
        first, *others = refused.values()
        self.refused = refused
        fault = first.fault
        explained = fault.kind in (CONTRADICTORY, UNREACHED)  # then what is not known comes of that
        super().__init__(
            fault.message,
            span=fault.span,
            help=fault.help,
            lines=first.lines,
            file=first.file,
            kind=fault.kind,
            others=[other.fault for other in others if not (explained and other.fault.kind == INCOMPLETE)],
        )


def answered(search: Search, finds: Sequence[Find]) -> Search:
    """A search in which all questions are answered; raises `Unanswered` where some have no answer.

    A question that has an answer alone is asked before those that stood in its way.
    """
    search.thorough = len(finds) == 1
    finds = letters_first(finds, search.scene.configuration.problem)
    finds = in_sequence(finds, search.scene.configuration.timeline)
    failed = answer_all(search, finds)
    if not failed:
        return search
    alone = failed if search.thorough else [item for find, _ in failed for item in refused_alone(find, search)]
    if alone:
        raise Unanswered({find.name: error for find, error in alone})
    first = [find for find, _ in failed]
    search = afresh(search)
    again = answer_all(search, [*first, *(find for find in finds if find not in first)])
    if again and any(find.where is not None for find in (again[0][0], first[0])):
        raise Unanswered({find.name: not_beside(find, first[0], search) for find, _ in again})
    if again:
        raise again[0][1]
    return search


def not_beside(find: Find, other: Find, search: Search) -> Unsolvable:
    """That a question, which has an answer alone, has none beside another that has one alone: a condition settles what both hang on."""
    message = f"`{find.name}` is not solved beside `{other.name}`: a condition settles what both hang on"
    return unsolvable(search.scene.configuration.problem, message, find.span, "ask for it in a scene of its own")


def letters_first(finds: Sequence[Find], problem: Problem) -> list[Find]:
    """The questions, that for a letter of the scene before all that name it: which of several values it has is settled with it, not with
    what is made of it."""
    found = list(finds)
    for letter in problem.sought:
        own = next((find for find in found if find.formula == Symbol(letter) and not find.terms), None)
        naming = [k for k, find in enumerate(found) if find is not own and letter in letters_named(find)]
        if own is not None and naming and naming[0] < found.index(own):
            found.remove(own)
            found.insert(naming[0], own)
    return found


def in_sequence(finds: Sequence[Find], timeline: Timeline) -> list[Find]:
    """The questions in the order of time, however a scene lists them, each behind those that it names, sizes behind components; as they
    are where one seeks a letter, an extremum or a label."""
    if len(finds) < 2 or any(find.where is not None or find.extreme or find.choice is not None for find in finds):
        return list(finds)
    places: dict[str, float] = {}
    for find in finds:
        named = [places[name] for name in letters_named(find) if name in places]
        places[find.name] = max([place_in_time(find, timeline) + BEHIND * asks_size(find, finds), *named])
    return sorted(finds, key=lambda find: places[find.name])


def asks_size(find: Find, finds: Iterable[Find]) -> bool:
    """Whether a question is for the size of a vector of which a component is asked as well."""
    if "size of" not in (find.modifier, *(term.modifier for term in find.terms)):
        return False
    asked = [term.path for other in finds for term in other.terms if term.path.component]
    own = {(term.path.owner, term.path.point, term.path.quantity) for term in find.terms}
    return any((path.owner, path.point, path.quantity) in own for path in asked)


def letters_named(find: Find) -> set[str]:
    """The letters in the arithmetic of a question, and in the places that it names."""
    places = [ref.argument for ref in references(find.terms) if ref.argument is not None]
    return set(find.formula.symbols()).union(*(place.symbols() for place in places))


def place_in_time(find: Find, timeline: Timeline) -> int:
    """The place in time of the last state of which a question speaks."""
    moments = [timeline.order.get(name, 0) for term in find.terms for name in states_spoken_of(term, timeline)]
    return max(moments, default=0)


def states_spoken_of(term: Term, timeline: Timeline) -> list[str]:
    """The states of which a term speaks, the last one of a phase or an event for that."""
    spans = [
        one.end for one in timeline.intervals if term.during is not None and term.during in (*one.names, one.whole)
    ]
    return [name for name in (term.at, term.start, term.end, *spans) if name is not None]


def afresh(search: Search) -> Search:
    """A search by the same laws that knows no answer yet."""
    other = search.another(search.families, spare=search.spare)
    other.thorough = True
    return other


def refused_alone(find: Find, search: Search) -> Refused:
    """Why a question has no answer even with nothing else than the questions that it names; nothing where it has one."""
    named = with_named({find.name}, search.scene.configuration.problem)
    return [item for item in answer_all(afresh(search), named) if item[0].name == find.name]


def needed_for(find: Find, problem: Problem) -> Iterator[tuple[Find, ...]]:
    """What a question needs: with questions for the largest or smallest of letters that states tell, which say which of two is meant; those
    that it names alone; those too that settle an unknown letter by a condition."""
    settling = {
        item.name for item in problem.finds if item.where is not None and item.formula.symbols() & problem.sought
    }
    told = set(letters_of(tuple(state.conditions for state in problem.states)))
    choosing = {item.name for item in problem.finds if item.extreme_letter in told & problem.sought}
    alone = with_named({find.name}, problem)
    if choosing - {item.name for item in alone}:
        yield with_named({find.name, *choosing}, problem)
    yield alone
    if settling - {item.name for item in alone}:
        yield with_named({find.name, *settling}, problem)


def with_named(names: set[str], problem: Problem) -> tuple[Find, ...]:
    """Questions with those that they name."""
    finds = {item.name: item for item in problem.finds}
    while more := {name for own in names for name in letters_of(finds[own]) if name in finds} - names:
        names |= more
    return tuple(item for item in problem.finds if item.name in names)


def answer_all(search: Search, finds: Sequence[Find]) -> Refused:
    """Answer all questions; one that has to wait for another (an asked letter that a later line settles) is tried again."""
    pending, early, half = list(finds), list[str](), (Purse.left or 0) / 2
    while pending:
        waiting: Refused = []
        for find in pending:
            try:
                answer(search, find)
                early += [find.name] if (Purse.left or 0) >= half else []
            except Unsolvable as error:
                waiting.append((find, error))
            except Exhausted as error:
                error.done, error.stuck = tuple(early), find.name
                raise
        if len(waiting) == len(pending):
            return waiting
        pending = [find for find, _ in waiting]
    return []


def answer(search: Search, find: Find) -> None:
    """Answer one question, entry by entry where it asks for a matrix or vector."""
    for part in entries(find, search.scene):
        if part.name not in search.letters():
            answer_one(search, part)


def answer_one(search: Search, find: Find) -> None:
    """Answer one question for a single quantity, or say why there is no answer."""
    problem = search.scene.configuration.problem
    try:
        if find.choice is not None:
            from rotsolve.search.choices import choose

            search.chosen.append(choose(find, find.choice, search, lambda side: answer_by_law(search, side, find.name)))
        elif not answer_with_condition(search, find):
            answer_by_law(search, find)
    except (NotYet, Unclear) as error:
        raise unsolvable(problem, str(error), error.span or find.span, error.help) from None
    except NoAnswer as error:
        from rotsolve.search.explain import no_answer, refuse_unsolved

        if error.shortage is not None:
            refuse_unsolved(search, error.shortage, find)
        raise no_answer(error, search, find) from None
    try:
        for refuse in (refuse_unreal, refuse_open, refuse_by_place, refuse_undefined):
            refuse(search, find)
    except Unsolvable:  # asked again, it has no answer either
        for item in [item for item in search.answered if item.asked.find.name == find.name]:
            search.take_back(item)
        raise


def refuse_undefined(search: Search, find: Find) -> None:
    """Unsolvable where an angle has no value: between vectors of which one is nothing, atan2(0, 0), or with a cosine beyond 1."""
    for answered in search.answered if not find.runs else ():
        formula = answered.found.formula if answered.asked.find.name == find.name and not answered.aside else None
        if formula is None or not formula.holds("atan2", "acos", "asin"):
            continue
        lacking = search.signs.lacking(formula)
        if without_direction(formula.substitute(search.values)) if lacking else search.signs.number(formula) is None:
            message = f"`{find.name}` has no value: what it is the angle of has no direction there"
            raise unsolvable(search.scene.configuration.problem, message, find.span)


def refuse_unreal(search: Search, find: Find) -> None:
    """Unsolvable where the root of a negative number stands in an answer: the motion does not come to its state."""
    for answered in search.answered if not find.runs else ():
        formula = answered.found.formula if answered.asked.find.name == find.name and not answered.aside else None
        if formula is not None and is_unreal(formula, search):
            message = f"`{find.name}` has no real value with these numbers: the motion does not come to that"
            raise unsolvable(search.scene.configuration.problem, message, find.span)


def refuse_open(search: Search, find: Find) -> None:
    """Unsolvable where an answer still holds quantities of the laws: a letter that nothing tells is no answer."""
    for answered in search.answered if not find.runs else ():  # a function of time holds what runs with it
        formula = answered.found.formula if answered.asked.find.name == find.name and not answered.aside else None
        open_ = sorted(name for name in formula.symbols() if is_key(name)) if formula is not None else []
        if open_ and formula is not None and search.apart().certified(formula) is None:
            from rotsolve.search.explain import open_quantities, unknowns_listed

            scene = search.scene
            missing = unknowns_listed(open_quantities(open_, scene), scene) or "what moves on the way"
            raise unsolvable(
                scene.configuration.problem, f"`{find.name}` hangs on {missing}, which nothing tells", find.span
            )


def refuse_by_place(search: Search, find: Find) -> None:
    """Unsolvable where an answer at any time is one by the place or speed that runs with it: no function of time."""
    running = places_and_speeds(search.scene.passages.values()) if find.runs else set[str]()
    for answered in search.answered if running else ():
        formula = answered.found.formula if answered.asked.find.name == find.name and not answered.aside else None
        if formula is not None and formula.symbols() & running:
            from rotsolve.search.explain import by_time_in_letters

            raise by_time_in_letters(search.scene, find)


def answer_with_condition(search: Search, find: Find) -> bool:
    """Answer a question with a condition, or for an extremum over a letter; False where it is neither."""
    if find.where is None and not find.extreme:
        return False
    from rotsolve.search.conditions import answer_where
    from rotsolve.search.extrema import over_a_letter

    if find.where is None and not over_a_letter(find, search):
        return False
    try:
        answer_where(search, find)
    except (NotYet, NoAnswer) as error:
        if NEWTON in search.families:
            raise
        with_newton(search, find.name, lambda: answer_where(search, find), error)
    return True


def with_newton(search: Search, name: str, attempt: Callable[[], Got], error: Exception) -> Got:
    """What an attempt gives with Newton's laws beside the law asked for, which is noted; the first error where that fails too."""
    laws, dear = search.families, search.planner.dear
    search.families = (*laws, NEWTON)
    search.planner.dear = dear | {index for index, law in enumerate(search.planner.pool) if law.family == NEWTON}
    try:
        got = attempt()
    except (NotYet, NoAnswer):
        raise error from None
    finally:
        search.families, search.planner.dear = laws, dear
    search.helped += [name] if name not in search.helped else []
    return got


def answer_by_law(search: Search, find: Find, whole: str = "") -> Answered:
    """Answer by the search's laws; where a law asked for does not reach (no energy tells a tension), Newton's laws help out.

    `whole` names the choice to which the question belongs.
    """
    refuse_other_value(search, find)
    if find.terms or not isinstance(find.formula, Symbol):
        settle(search, letters_named(find) & search.scene.configuration.problem.sought)
    question = question_for(find, search.scene, search.letters(), search.beside())
    if find.terms and not isinstance(question.formula, Symbol):  # what a state tells by a letter is what that is
        settle(search, question.formula.symbols() & search.scene.configuration.problem.sought)
    question = replace(question, whole=whole)
    if search.scene.configuration.problem.space:
        from rotsolve.space.entries import by_answers

        question = by_answers(question, [item.asked for item in search.answered if not item.aside])
    if question.moving.parts and stands_still(question.moving, search):
        raise NotYet(resting(find.terms[0].path))
    extreme = find.extreme_letter
    search.solver.once_round = extreme if extreme and search.may_be_angle(extreme) else ""
    try:
        return with_letters(search, question)
    except NoAnswer as error:
        if NEWTON in search.families:
            raise
        return with_newton(search, whole or find.name, lambda: with_letters(search, question), error)
    finally:
        search.solver.once_round = ""


def refuse_other_value(search: Search, find: Find) -> None:
    """Refuse the largest of a letter that the scene seeks where its smallest has been told: in one scene it has one value."""
    sought = search.scene.configuration.problem.sought
    if (
        find.terms
        or find.where is not None
        or not find.formula.symbols() <= sought
        or not isinstance(find.formula, Symbol)
    ):
        return
    for other in (item.asked.find for item in search.answered if not item.aside):
        same = other.formula == find.formula and not other.terms and other.where is None
        if same and other.modifier != find.modifier:
            name = find.formula.name
            message = f"`{name}` has one value in a scene, that of `{other.name}`, which asks for another"
            raise NotYet(message, find.span, "ask for it in a scene of its own")


def with_letters(search: Search, question: Asked) -> Answered:
    """The answer to a question; where it has none, once more with the letters settled that the scene seeks, of which a number may tell."""
    try:
        return search.answer(question)
    except NoAnswer:
        if not settle(search, search.scene.configuration.problem.sought - {question.letter}):
            raise
        return search.answer(question)


def settle(search: Search, letters: Iterable[str]) -> bool:
    """Answer aside what is sought of the letters of the scene; False where none of them is told that has not been before."""
    before = len(search.answered)
    for name in sorted(letters):
        if name not in search.solver.solved:
            with suppress(NoAnswer):
                search.answer(asked_letter(name), aside=True)
    return len(search.answered) > before


def stands_still(velocity: Vector, search: Search) -> bool:
    """Whether a velocity turns out to be nothing."""
    aside = search.beside_by(families_for(None))
    parts = [aside.settled(velocity.along(axis)) for axis in (RIGHT, UP)]
    return all(part is not None and is_zero(part, search.solver.positive) for part in parts)
