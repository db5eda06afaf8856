"""Slipping beside: the verge of one contact where another one slips before it: of a block on a block that slides itself."""

from __future__ import annotations

from collections.abc import Iterator

from msgspec.structs import replace

from rotsolve.algebra.formula import Formula, call
from rotsolve.core.writing import spoken
from rotsolve.motion.rubs import STICKS, Rub, rubs_at
from rotsolve.paths.meaning import NotYet
from rotsolve.questions.find import Asked
from rotsolve.search.gripping import limiting
from rotsolve.search.search import Search
from rotsolve.search.verges import Verge, verges_slipping


def where_others_hold(verges: list[Verge], contact: str, state: str, question: Asked, search: Search) -> list[Verge]:
    """The verges at which all other contacts have friction enough; in place of the others those at which one that has not slips."""
    start = search.scene.configuration.phase_start(state)
    others = [
        rub for rub in rubs_at(search.scene.configuration, start) if rub.contact is not None and rub.owner != contact
    ]
    others = [rub for rub in others if search.scene.modes.get(rub.key, STICKS) == STICKS]
    lacking = [[rub for rub in others if lacks_friction(rub, state, one.value, question, search)] for one in verges]
    if not any(lacking):
        return verges
    slipping = dict.fromkeys(rub for rubs in lacking for rub in rubs)
    found = [verge for verge, rubs in zip(verges, lacking, strict=True) if not rubs]
    found += [verge for rub in slipping for verge in verges_beside(rub, contact, state, question, search)]
    if not found:
        names = " and ".join(spoken(rub.owner) for rub in slipping)
        raise NotYet(
            f"`{spoken(contact)}` is not on the point of slipping before {names} slips, nor is a value found after that"
        )
    return found


def lacks_friction(rub: Rub, state: str, value: Formula, question: Asked, search: Search) -> bool:
    """Whether a contact that is taken to stick would need more friction at a verge than it can give, |f| > μ N."""
    limits = limiting(search.scene, rub.owner, state)
    found = at_verge([(limit.left, limit.right) for limit, _ in limits[:1]], value, question, search)
    return any(search.numbers.side(call("abs", friction) - most) == 1 for friction, most in found)


def at_verge(
    pairs: list[tuple[Formula, Formula]], value: Formula, question: Asked, search: Search
) -> list[tuple[Formula, Formula]]:
    """Pairs of quantities of the laws where the letter that is sought has a value; none of what the laws do not tell."""
    other = search.another(search.families, spare=search.spare)
    other.known.add(question.letter)
    found = [(other.settled(one), other.settled(two)) for one, two in pairs]
    put = {question.letter: value}
    return [(one.substitute(put), two.substitute(put)) for one, two in found if one is not None and two is not None]


def verges_beside(rub: Rub, contact: str, state: str, question: Asked, search: Search) -> Iterator[Verge]:
    """The verges of a contact while another one slips, at which that speeds up the way it slips."""
    for sense in (1, -1):
        modes = {rub.key: rub.mode(sense)}
        other = Search(search.scene.where({**search.scene.modes, **modes}), search.families, search.spare)
        for way in (1, -1):
            for verge in verges_slipping(way, contact, state, question, other):
                if not verge.side:  # as upright, where nothing presses any more
                    continue
                rate = rub.rate(other.scene.instant(rub.state), acceleration=True)
                rates = [] if rate is None else at_verge([(rate, rate)], verge.value, question, other)
                if any(search.numbers.side(gain) == sense for gain, _ in rates):
                    yield replace(verge, modes=modes, meant=False)
