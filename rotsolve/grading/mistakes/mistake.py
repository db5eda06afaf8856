"""Mistake: what a student did wrong in a scene, in words, and the change to the scene that does the same, place by place."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping

from msgspec import Struct, field
from msgspec.structs import replace

from rotsolve.algebra.formula import Formula
from rotsolve.core.equation import Equation
from rotsolve.core.facts import BodyFacts, Couple, Facts, Force
from rotsolve.core.passage import Alteration
from rotsolve.core.writing import and_joined, spoken
from rotsolve.language.problem import Body, Problem

MOST = 8  # places that are tried one by one; of more only all together


class Change(Struct, frozen=True):
    """What a mistake changes: what is read of the scene, what the laws say of it, or what is put in for a given at the end.

    problem: the scene as it is misread, for which friction is decided anew; altered: its facts and equations, while what slips stays as
    it is. `aside` are the laws by which the answer is found without making the mistake, hence not used. With altered facts laws are taken
    about centres of mass, as the forces of a contact have no arm there that could be mistaken; `about_contact`: the mistake is made there.
    letters: what is written for a given in the answers (2 R for R); factors: by what the number is wrong that is put in for it. Neither
    needs the laws.
    """

    problem: Callable[[Problem], Problem] | None = None
    altered: Alteration | None = None
    aside: tuple[str, ...] = ()
    about_contact: bool = False
    letters: Mapping[str, Formula] = field(default_factory=dict)
    factors: Mapping[str, Formula] = field(default_factory=dict)

    @property
    def reread(self) -> bool:
        """Whether the laws are right, and only what is put in at the end is not."""
        return bool(self.letters or self.factors)

    @property
    def throughout(self) -> bool:
        """Whether all laws speak of the change alike, so that they must agree with each other."""
        one_sided = self.altered is not None and (self.altered.equation is not None or self.altered.event is not None)
        return not self.aside and not one_sided


class Mistake(Struct, frozen=True):
    """One mistake at one place of a scene: its name in the table, words that complete "It looks as if ", and the change."""

    name: str
    words: str
    change: Change


Made = Iterator[tuple[str, Change]]  # words that complete "It looks as if ", and the change that goes with them


# places


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
        yield known, and_joined([f"the {spoken(name)}" for name in known])


def bodies_and_parts(bodies: Iterable[Body]) -> Iterator[Body]:
    """All bodies, and the bodies that are parts of others, each behind the whole."""
    for body in bodies:
        yield body
        yield from bodies_and_parts(part.body for part in body.parts)


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
        acting = [change(item) if item.owner in owners and item.role.rubs else item for item in body.acting]
        forces = tuple(item for item in acting if isinstance(item, Force))
        return replace(body, forces=forces, couples=tuple(item for item in acting if isinstance(item, Couple)))

    return Alteration(facts=lambda facts: replace(facts, bodies=tuple(changed(body, facts) for body in facts.bodies)))


def both_sides(equation: Equation, change: Callable[[Formula], Formula]) -> Equation:
    """An equation of which both sides are changed."""
    return replace(equation, left=change(equation.left), right=change(equation.right))
