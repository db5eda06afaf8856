"""Standing: of all angles at which a body stands steadily on its hinge those to which it comes back when it is displaced."""

from __future__ import annotations

import math
from collections.abc import Iterator

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.space.hearing import Hearing
from rotsolve.confirm.space.rivals import SAME, others
from rotsolve.language.problem import Find, Problem

UNDISTURBED = "whether a body that is displaced from there comes back was not looked at"
MOVES_AWAY = "a body that is displaced from there does not come back"


def standing_by(letter: str, problem: Problem) -> Iterator[tuple[str, str]]:
    """The bodies of which a letter tells at which angle they stand on their hinge, at rest or while that goes round, with the state."""
    for state in (state for state in problem.states if state.steady or state.balance):
        for line in (line for line in state.conditions if line.path is not None and line.value is not None):
            if line.path.quantity == "angle" and letter in line.value.symbols():  # type: ignore[union-attr]
                yield line.path.owner, state.name  # type: ignore[union-attr]


def extreme_that_lasts(hearing: Hearing, find: Find, letter: str, own: float) -> bool:
    """Whether an angle is the largest, or the smallest, of those to which a body comes back; NotConfirmed where it
    does not come back there, or that can't be seen."""
    (standing, *more) = standing_by(letter, hearing.problem)
    if more or hearing.places != [letter]:
        raise NotConfirmed(UNDISTURBED)
    apart = (root for root in others(hearing, own) if abs(math.remainder(root - own, math.tau)) > SAME)
    places = [own, *apart]
    lasting = [place for place in places if comes_back(hearing, letter, place, *standing)]
    if own not in lasting:
        raise NotConfirmed(MOVES_AWAY)
    return own == (min if find.modifier == "smallest" else max)(lasting)


def comes_back(hearing: Hearing, letter: str, place: float, name: str, state: str) -> bool:
    """Whether a body that is displaced from an angle is driven back to it."""
    from rotsolve.confirm.space.swings import growth_about

    try:
        ways = hearing.with_letter(letter, place).ways(state)
        return all(growth_about(way.worlds[0], name) < 0.0 for way in ways)
    except NotConfirmed as reason:
        raise NotConfirmed(UNDISTURBED) from reason
