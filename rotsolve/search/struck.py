"""Struck: whether what strikes a rough surface slips on it all through the blow, or leaves it without slip: |J_f| ≤ μ Jₙ."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rotsolve.algebra.formula import call
from rotsolve.core.derivation import Words
from rotsolve.core.faults import UNSOLVED
from rotsolve.core.symbols import rub_key
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
    found = gripped(event.name, blow, search)
    sizes = None if found is None else (found[0].found.formula, greatest_friction(event, found[1]))
    if found is None or sizes is None or sizes[0] is None or sizes[1] is None:
        return left_untold(blow, trials)
    needed, limit = sizes[0], sizes[1]
    way, beyond = search.numbers.side(needed), search.numbers.side(call("abs", needed) - limit)
    if way is None or beyond is None:
        return left_untold(blow, trials)
    holds = beyond != 1
    words: list[Words] = [("impulse of friction needed: ", needed), ("at most: ", limit)]
    trials.note({key: STICKS}, words, holds, "less than there can be" if holds else "more than there can be")
    trials.modes[key] = STICKS if holds else BACK if way == 1 else FORWARD
    if not holds:
        trials.slipping.append(SlippingContact(event, search, *found))


def left_untold(blow: Interval, trials: Trials) -> None:
    """Unsolvable where nothing tells whether it slips, and no question may tell it."""
    if not trials.seeking():
        problem, span = trials.configuration.problem, trials.configuration.timeline.state(blow.start).span
        message = f"whether what strikes in `{blow.name}` slips is not told by the laws in closed form"
        raise unsolvable(problem, message, span, kind=UNSOLVED)


def gripped(name: str, blow: Interval, search: Search) -> tuple[Answered, Answered] | None:
    """The impulses of friction and of the push where it leaves without slip; None where the laws do not tell them."""
    before = search.scene.instant(blow.start)
    sizes = [before.ask("impulse", name, component=part) for part in "fn"]
    try:
        friction, push = (
            search.answer(question(size, size_name)) for size, size_name in zip(sizes, ("J_f", "J_n"), strict=True)
        )
    except NoAnswer:
        return None
    return friction, push
