"""Struck: whether what strikes a rough surface slips on it all through the blow, or leaves it without slip: |J_f| ≤ μ Jₙ."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rotsolve.algebra.formula import ZERO, Formula, call
from rotsolve.core.derivation import Words
from rotsolve.core.faults import UNSOLVED
from rotsolve.core.symbols import rub_key
from rotsolve.language.elements import Event
from rotsolve.motion.rubs import BACK, FORWARD, STICKS
from rotsolve.motion.timeline import Interval
from rotsolve.search.answers import Answered, NoAnswer, unsolvable
from rotsolve.search.gripping import greatest_friction, question
from rotsolve.search.planning import families_for
from rotsolve.search.search import Search

if TYPE_CHECKING:
    from rotsolve.search.friction import Trials


def decide_blow(blow: Interval, trials: Trials) -> None:
    """Take it to leave without slip: whether the friction that this takes is more than there can be; then it slips as it came."""
    from rotsolve.search.friction import SlippingContact

    event, configuration = blow.event, trials.configuration
    if event is None:
        return
    key = rub_key(event.name, configuration.phase_start(blow.start))
    search = trials.fresh(trials.modes, families_for(None))
    found = gripped(event, blow, search)
    sizes = None if found is None else (found[0].found.formula, greatest_friction(event, found[1]))
    coupled = event.coupled(search.scene.instant(blow.start))
    if coupled and (sizes is None or None in sizes):
        return decide_by_numbers(event, blow, key, trials, search)
    if found is None or sizes is None or sizes[0] is None or sizes[1] is None:
        return left_untold(blow, trials)
    needed, limit = sizes[0], sizes[1]
    way, beyond = search.numbers.side(needed), search.numbers.side(call("abs", needed) - limit)
    if way is None or beyond is None:
        return left_untold(blow, trials)
    holds = beyond != 1
    words: list[Words] = [("impulse of friction needed: ", needed), ("at most: ", limit)]
    trials.note({key: STICKS}, words, holds, "less than there can be" if holds else "more than there can be")
    if not holds:
        trials.slipping.append(SlippingContact(event, search, *found))
    mode = STICKS if holds else BACK if way == 1 else FORWARD
    if coupled:
        return decide_coupled(event, blow, key, trials, mode)
    trials.modes[key] = mode


def decide_by_numbers(event: Event, blow: Interval, key: str, trials: Trials, search: Search) -> None:
    """Where sticking has no closed form, or none at all since a joint lets the touching point move along one line only."""
    before = search.scene.instant(blow.start)
    needed = before.ask("impulse", event.name, component="f")
    way, beyond = (
        sense_by_laws(value, search)
        for value in (needed, call("abs", needed) - (event.static() or ZERO) * event.push(before))
    )
    if way is None or beyond is None:
        return slip_on(event, blow, key, trials)
    return decide_coupled(event, blow, key, trials, STICKS if beyond != 1 else BACK if way == 1 else FORWARD)


def decide_coupled(event: Event, blow: Interval, key: str, trials: Trials, mode: str) -> None:
    """Where the push itself moves the touching point along the surface: what has stopped slipping sticks only where as much friction as
    there can be is enough to turn its slip either way; what does not stick slips on as it came, and begins to where it did not slip."""
    if mode == STICKS:
        turned = [slip_gained(event, blow, key, trials, way) for way in (FORWARD, BACK)]
        if None in turned:
            return left_untold(blow, trials)
        if turned[0] != 1 and turned[1] != -1:
            trials.modes[key] = STICKS
            return
        mode = FORWARD if turned[0] == 1 else BACK
    slip_on(event, blow, key, trials, mode)


def slip_on(event: Event, blow: Interval, key: str, trials: Trials, begins: str = "") -> None:
    """It slips all through the blow in the sense in which it came; where it did not, in the one in which it begins to."""
    search = trials.fresh(trials.modes, families_for(None))
    way = sense_by_laws(event.slip(search.scene.instant(blow.start)), search)
    if way is None or (way == 0 and not begins):
        return left_untold(blow, trials)
    trials.modes[key] = begins if way == 0 else FORWARD if way == 1 else BACK


def slip_gained(event: Event, blow: Interval, key: str, trials: Trials, mode: str) -> int | None:
    """The sense in which the slip changes as the push grows, with as much friction as there can be against a slip of that `mode`."""
    search = trials.fresh({**trials.modes, key: mode}, families_for(None))
    first, last = (search.scene.instant(state) for state in (blow.start, blow.end))
    return sense_by_laws((event.slip(last) - event.slip(first)) * event.push(first), search)


def sense_by_laws(value: Formula, search: Search) -> int | None:
    """The sign of a value of the laws, in the case that is looked at; of what has no closed form that of its number."""
    settled = search.settled(value)
    if settled is not None:
        return search.numbers.side(settled)
    number = search.certified(value)
    return None if number is None else number.sign or 0


def left_untold(blow: Interval, trials: Trials) -> None:
    """Unsolvable where nothing tells whether it slips, and no question may tell it."""
    if not trials.seeking():
        problem, span = trials.configuration.problem, trials.configuration.timeline.state(blow.start).span
        message = f"whether what strikes in `{blow.name}` slips is not told by the laws in closed form"
        raise unsolvable(problem, message, span, kind=UNSOLVED)


def gripped(event: Event, blow: Interval, search: Search) -> tuple[Answered, Answered] | None:
    """The impulses of friction and of the push where it leaves without slip; None where the laws do not tell them."""
    before = search.scene.instant(blow.start)
    sizes = [before.ask("impulse", event.name, component=part) for part in "fn"]
    try:
        friction, push = (
            search.answer(question(size, size_name)) for size, size_name in zip(sizes, ("J_f", "J_n"), strict=True)
        )
    except NoAnswer:
        return None
    return friction, push
