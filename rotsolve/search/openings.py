"""Openings: states that the scene does not name, at which a phase ends before it does: what they say and are called, how long it takes to
them, and how fast all moves at both ends of a phase."""

from __future__ import annotations

from contextlib import suppress

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO
from rotsolve.core.passage import Travel
from rotsolve.core.symbols import is_quantity
from rotsolve.core.writing import spoken
from rotsolve.language.problem import Condition, Path, Problem, State
from rotsolve.motion.rubs import Rub
from rotsolve.motion.timeline import Interval
from rotsolve.search.answers import NoAnswer, unsolvable
from rotsolve.search.search import Search, asked_letter

MOST = 12  # states that are opened in one scene


class Ending(Struct, frozen=True):
    """What ends in a phase before it does: the lines that hold then, and the senses in which all that rubs goes on."""

    interval: Interval
    lines: tuple[Condition, ...]
    senses: tuple[tuple[str, int], ...]
    name: str
    words: str


def tell_openings(search: Search) -> None:
    """Work out how long it takes to the states that the scene does not name, and how fast all moves then: the next phase begins so."""
    for interval in search.scene.configuration.timeline.intervals:
        if interval.event is None and search.scene.configuration.timeline.state(interval.end).opened:
            tell_ends(search, interval)


def tell_ends(search: Search, interval: Interval) -> None:
    """The speeds at both ends of a phase, and how long it takes, as far as the laws of a search tell them."""
    passage = search.scene.passages[interval.name]
    speeds = [speed for travel in passage.travels for speed in (travel.before, travel.after)]
    for value in (*speeds[::2], passage.duration, *speeds[1::2]):
        if is_quantity(value) and value.name not in search.solver.solved:
            with suppress(NoAnswer):
                search.answer(asked_letter(value.name), aside=True)


def with_state_at(problem: Problem, ending: Ending) -> Problem:
    """The problem with a state of its own at which a phase ends before its time; what does so where it begins goes another way there."""
    states = problem.states or (State(""),)
    if not ending.lines:
        same = ending.interval.start
        senses = [replace(state, senses=ending.senses) if state.name == same else state for state in states]
        return replace(problem, states=tuple(senses))
    if sum(bool(state.opened) for state in states) == MOST:
        raise unsolvable(problem, f"what rubs starts and stops more than {MOST} times: that is not followed further")
    place = next(number for number, state in enumerate(states) if state.name == ending.interval.start) + 1
    state = State(free_name(ending.name, problem), ending.lines, opened=ending.words, senses=ending.senses)
    return replace(problem, states=(*states[:place], state, *states[place:]))


def resting_line(rub: Rub) -> Condition:
    """What a state says of what has come to rest."""
    if rub.item is None:
        return Condition(Path(rub.body, "angular_velocity"), ZERO)
    return Condition(Path(rub.owner, ""), word="sticks")


def turning_line(travel: Travel) -> Condition:
    """What a state says where a motion turns back."""
    return Condition(Path(travel.body, "velocity" if travel.kind == "line" else "angular_velocity"), ZERO)


def stops(rub: Rub, search: Search) -> bool:
    """Whether a body stands where it no longer slips: unless it rolls, or something carries it."""
    if rub.item is None:
        return True
    wheel = search.scene.instant(rub.state).is_round(rub.body)
    return rub.contact is not None and not (wheel or rub.contact.carrier(search.scene.configuration))


def words_for(rub: Rub, search: Search) -> str:
    """What happens, in words: "stone comes to rest", "ball no longer slips"."""
    return f"{spoken(rub.body)} comes to rest" if stops(rub, search) else f"{slider_of(rub)} no longer slips"


def slider_of(rub: Rub) -> str:
    """What slips, in words: a body on what it lies on, else what rubs."""
    return spoken(rub.body if rub.contact is not None else rub.name)


def moving_words(rub: Rub, search: Search) -> str:
    """What begins, in words: "wheel begins to turn", "block begins to slide", "roller begins to slip"."""
    if rub.item is None:
        return f"{spoken(rub.body)} begins to turn"
    return f"{slider_of(rub)} begins to {'slide' if stops(rub, search) else 'slip'}"


def free_name(word: str, problem: Problem) -> str:
    """A name for a state that nothing else has."""
    named = (problem.states, problem.events, problem.phases, problem.bodies, problem.connections, problem.actions)
    taken = {item.name for items in named for item in items}
    numbered = (f"{word}{number}" for number in range(2, len(taken) + 3))
    return next(name for name in (word, *numbered) if name not in taken)
