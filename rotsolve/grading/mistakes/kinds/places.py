"""Places of a scene at which a mistake can be made: one after the other, then all together; and what is changed there."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence

from msgspec.structs import replace

from rotsolve.core.alteration import Alteration
from rotsolve.core.facts import BodyFacts, Couple, Facts, Force
from rotsolve.core.writing import spoken
from rotsolve.grading.mistakes.mistake import Change

Made = Iterator[tuple[str, Change]]  # words that complete "It looks as if ", and the change that goes with them


MOST = 8  # places that are tried one by one; of more only all together


def each(names: Iterable[str]) -> tuple[str, ...]:
    """The names, each once; none where there are too many to try one by one."""
    known = tuple(dict.fromkeys(names))
    return known if len(known) <= MOST else ()


def each_and_all(names: Iterable[str]) -> Iterator[tuple[tuple[str, ...], str]]:
    """Each name with its words ("the pulley"), then all of them with theirs ("the wheel and the drum")."""
    known = tuple(dict.fromkeys(names))
    for name in each(known):
        yield (name,), f"the {spoken(name)}"
    if len(known) > 1:
        yield known, listed([f"the {spoken(name)}" for name in known])


def listed(words: Sequence[str]) -> str:
    """a, b and c."""
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} and {words[-1]}"


def of_bodies(names: Collection[str], change: Callable[[BodyFacts, Facts], BodyFacts]) -> Alteration:
    """Other facts of some bodies at every moment."""

    def changed(facts: Facts) -> Facts:
        bodies = tuple(change(body, facts) if body.name in names else body for body in facts.bodies)
        return replace(facts, bodies=bodies)

    return Alteration(facts=changed)


def of_forces(names: Collection[str], change: Callable[[Force, BodyFacts], Force]) -> Alteration:
    """Other forces on some bodies at every moment."""

    def changed(body: BodyFacts, facts: Facts) -> BodyFacts:
        return replace(body, forces=tuple(change(force, body) for force in body.forces))

    return of_bodies(names, changed)


def of_owners(owners: Collection[str], change: Callable[[Force | Couple], Force | Couple]) -> Alteration:
    """Other friction of some connections or actions, on whatever body, at every moment."""

    def changed(body: BodyFacts, facts: Facts) -> BodyFacts:
        acting = [change(item) if item.owner in owners and item.role == "friction" else item for item in body.acting]
        forces = tuple(item for item in acting if isinstance(item, Force))
        return replace(body, forces=forces, couples=tuple(item for item in acting if isinstance(item, Couple)))

    return Alteration(facts=lambda facts: replace(facts, bodies=tuple(changed(body, facts) for body in facts.bodies)))
