"""Shared friction: what is said where several frictions hold bodies still, and statics does not tell how much each of them takes."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula, call, negate, total
from rotsolve.core.derivation import Check
from rotsolve.core.equation import NEWTON, STATED
from rotsolve.core.facts import STANDS, TAUT, TOUCHES, Requirement
from rotsolve.core.writing import spoken
from rotsolve.derivation.requirements import bodies_used, margin_of, sign_of, values_sought
from rotsolve.motion.rubs import STICKS, Rub, rubs_at
from rotsolve.search.planning import families_for

if TYPE_CHECKING:
    from rotsolve.derivation.letters import Letters
    from rotsolve.search.search import Search


def shares_told(place: str, needs: Sequence[Requirement], search: Search, letters: Letters) -> Iterator[Check]:
    """Whether frictions suffice together, in balance; and what else hangs on how large each of them is, at any state at rest."""
    if place in search.scene.encounters:
        return
    if search.scene.instant(place).in_balance:
        yield from sufficing(place, needs, search, letters)
    for words in dict.fromkeys(hanging_on_shares(place, needs, search)):
        yield Check((f"whether {words}: nothing tells how the frictions share what they hold",), None)


def sufficing(place: str, needs: Sequence[Requirement], search: Search, letters: Letters) -> Iterator[Check]:
    """Whether frictions hold a state in balance together, of which the laws do not tell how large each is."""
    grips = [need for need in needs if need.kind.grips and search.apart().settled(need.right) is None]
    untold = [need.owner for need in grips]
    if not untold or not verges_sought(search).isdisjoint(untold):  # there friction has its limit
        return
    from rotsolve.search.shared_friction import suffices_together

    holds = suffices_together(search.scene.configuration, place)
    together = shared_bound(place, grips, search) if holds is None else None
    if together is not None:
        sign = sign_of(together.left - together.right, together, place, search, letters)
        holds = None if sign is None else sign >= 0
    names = " and ".join(map(spoken, dict.fromkeys(untold)))
    words = {
        True: f"friction suffices: {names} hold together",
        False: f"the frictions of {names} together do not hold it at {spoken(place)}",
        None: f"whether the frictions of {names} suffice together: nothing tells their shares",
    }
    yield Check((words[holds],), holds)


def shared_bound(place: str, grips: Sequence[Requirement], search: Search) -> Requirement | None:
    """|Σ f| ≤ Σ μ N of contacts along one line, whatever their shares: told where it comes to the same with all of it in each of them.

    None where it does not, as of a ladder on a wall, where how hard each is pressed goes by the shares.
    """
    from rotsolve.search.gripping import contact_forces

    forces = [force for body in search.scene.facts(place).bodies for force in body.forces]
    rubbing = [contact_forces(need.owner, forces)[0] for need in grips]
    first = rubbing[0]
    found: list[tuple[Formula, Formula]] = []
    for one in rubbing:
        if one is None or first is None or one.body != first.body:
            return None
        along = simplify(one.direction.dot(first.direction))
        alone, others = search.apart(), [force for force in rubbing if force is not None and force is not one]
        section = search.scene.section(place)
        for other in others:
            alone.planner.extend(STATED.equation(other.size, ZERO, section, words=""))
        needed, most = alone.settled(one.size), alone.settled(total([need.left for need in grips]))
        if needed is None or most is None or along not in (ONE, negate(ONE)):
            return None
        sought = next(values_sought(search), {})
        found.append((simplify((along * needed).substitute(sought)), simplify(most.substitute(sought))))
    (needed, most), *rest = found
    if any(simplify(other - mine) != ZERO for pair in rest for other, mine in zip(pair, found[0], strict=True)):
        return None
    names = " and ".join(dict.fromkeys(need.owner for need in grips))
    return Requirement(names, grips[0].kind, most, call("abs", needed), "hold together", "together they slip")


def hanging_on_shares(place: str, needs: Sequence[Requirement], search: Search) -> Iterator[str]:
    """What may go slack, lift or tip over among what friction holds still, where the laws do not tell the force on which that hangs, in
    words: several frictions share it, or in balance one and what is taut or presses itself."""
    configuration = search.scene.configuration
    told = bodies_used(search)
    still = [group for group in held_together(place, search) if search.scene.instant(place).in_balance or group & told]
    for need in needs if still else ():
        item = configuration.connection(need.owner, place)
        bodies = {configuration.host(ref.owner, place) for ref in item.touches()} if item is not None else set()
        if need.kind not in (TAUT, TOUCHES, STANDS) or not any(bodies & group for group in still):
            continue
        gap = margin_of(need, search, families_for(NEWTON), {})[1]
        if gap is None and search.apart().certified(need.left - need.right) is None:
            yield need.otherwise + (f" {spoken(place)}" if need.kind.placed else f" ({spoken(need.owner)})")


def held_together(place: str, search: Search) -> list[frozenset[str]]:
    """The bodies that are tied to each other and of which friction holds some still at a state, as large as nothing tells: two or more; in
    balance one, which may share with a string or a surface."""
    configuration, modes = search.scene.configuration, search.scene.modes
    groups: dict[frozenset[str], list[Rub]] = {}
    for rub in rubs_at(configuration, configuration.phase_start(place)):
        if modes.get(rub.key, STICKS if rub.item is not None else "") == rub.mode(0):
            groups.setdefault(configuration.component(rub.body, place), []).append(rub)
    verges, least = verges_sought(search), 1 if search.scene.instant(place).in_balance else 2
    return [group for group, held in groups.items() if len(held) >= least and not all_at_limit(held, verges)]


def all_at_limit(held: Sequence[Rub], verges: set[str]) -> bool:
    """Whether what holds is a contact that is on the point of slipping, and wheels that are on the point of turning with it."""
    return all(rub.contact is None or rub.owner in verges for rub in held) and any(rub.owner in verges for rub in held)


def verges_sought(search: Search) -> set[str]:
    """The contacts of which a question seeks where they are on the point of slipping: `largest F where touch sticks`."""
    wheres = (find.where for find in search.scene.configuration.problem.finds if find.verge)
    return {where.path.owner for where in wheres if where is not None and where.path is not None}
