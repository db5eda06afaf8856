"""Diagrams: the free-body diagrams in words of the bodies whose dynamics a section uses."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Set

from msgspec import Struct

from rotsolve.algebra.formula import ZERO
from rotsolve.core.derivation import ForceLine, Words
from rotsolve.core.equation import ANGULAR_MOMENTUM, ENERGY, NEWTON, SECOND_LAW, Equation
from rotsolve.core.facts import BodyFacts, Couple, Facts, Force
from rotsolve.core.symbols import is_key
from rotsolve.core.writing import spoken
from rotsolve.derivation.drafts import Draft
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.motion.freebody import free_bodies

WITH_FORCES = (NEWTON, ENERGY, ANGULAR_MOMENTUM)


class Diagrams(Struct, frozen=True):
    """The free-body diagrams of all sections; `pool` holds the laws that the drafts of sections point to."""

    scene: SceneEquations
    pool: list[Equation]

    def givens(self, draft: Draft) -> Iterator[str]:
        """Givens in the forces that the diagrams of a section name, supports left out."""
        for body in self._drawn(draft):
            pushed = self._pushed(body, draft)
            for item in body.acting:
                if not item.role.unseen and not at_the_axis(item, body, pushed):
                    letters = (item.size if isinstance(item, Force) else item.torque).symbols()
                    yield from sorted(name for name in letters if not is_key(name))

    def lines(self, draft: Draft, in_use: Set[str], words: Callable[[Words], Words]) -> tuple[ForceLine, ...]:
        """One line for each body; `in_use` are the letters that an equation speaks of, `words` writes them as they are printed."""
        return tuple(self._line(body, draft, in_use, words) for body in self._drawn(draft))

    def _drawn(self, draft: Draft) -> Iterator[BodyFacts]:
        """The bodies of which the laws of a section speak, with what acts on them."""
        equations = [self.pool[index] for index in draft.laws]
        names = {name for equation in equations if equation.family in WITH_FORCES for name in equation.bodies}
        facts = self._facts(draft)
        return (body for body in (facts.diagrams if facts is not None else ()) if body.name in names)

    def _facts(self, draft: Draft) -> Facts | None:
        """The facts that a section is about: of its state, of its phase, or of swings; none of an event.

        Where the section of a phase writes Newton's laws at one state alone, they are those of that state.
        """
        timeline, key = self.scene.configuration.timeline, draft.key
        for swing in self.scene.swings.values():
            if key in (swing.section, swing.balanced):
                return free_bodies(swing.near if key == swing.section else swing.rest)
        moments = {self.pool[index].section for index in draft.laws if self.pool[index].family == NEWTON}
        if len(moments) == 1 and moments <= set(timeline.order):
            key = moments.pop()
        interval = timeline.interval(key)
        if interval is not None:
            if interval.event is not None:
                return None
            return self.scene.facts(interval.start, generic=self.scene.varies(interval))
        return self.scene.facts(key) if key in timeline.order else None

    def _line(self, body: BodyFacts, draft: Draft, in_use: Set[str], words: Callable[[Words], Words]) -> ForceLine:
        """Forces, with their letters where equations speak of them, and in brackets those that have no say in them."""
        if not body.acting:
            return ForceLine(spoken(body.name), (("no force",),), body.positive)
        pushed = self._pushed(body, draft)
        spoken_of, silent = list[Words](), list[Force | Couple]()
        for item in body.acting:
            size = item.size if isinstance(item, Force) else item.torque
            if at_the_axis(item, body, pushed):
                silent.append(item)
                continue
            if size == ZERO:
                spoken_of.append(absent_force(item))
                continue
            letters = {letter for letter in size.symbols() if is_key(letter)}
            if letters <= in_use:
                spoken_of.append(words(item.words))
            elif not item.role.unseen:
                spoken_of.append(nameless(item))
        if silent and not spoken_of:
            return ForceLine(spoken(body.name), (only_at_support(silent),), body.positive)
        return ForceLine(spoken(body.name), tuple(spoken_of), body.positive, without_torque(silent))

    def _pushed(self, body: BodyFacts, draft: Draft) -> bool:
        """Whether a law of a section is Newton's second for a body."""
        laws = (self.pool[index] for index in draft.laws)
        return any(law.law == SECOND_LAW and body.name in law.bodies for law in laws)


def at_the_axis(item: Force | Couple, body: BodyFacts, pushed: bool) -> bool:
    """Whether a force has no say in the laws: it acts at the axis of a body, whose second law nobody writes."""
    return isinstance(item, Force) and body.motion.kind == "axis" and not pushed and not item.arm.parts


def nameless(item: Force | Couple) -> Words:
    """The words of a force whose letter no equation has: "normal force, up"."""
    return (f"{item.noun}{' ' if item.place else ''}{item.place}{', ' if item.way else ''}{item.way}",)


def absent_force(item: Force | Couple) -> Words:
    """What is said of a force that a state tells to be nothing: "no normal force at base"."""
    return (f"no {item.noun} at {spoken(item.owner)}",)


def without_torque(silent: list[Force | Couple]) -> tuple[Words, ...]:
    """Which forces on a body on an axis act at that axis."""
    if not silent:
        return ()
    names = nouns(silent)
    verb = "act" if len(names) > 1 else "acts"
    return ((f"{joined_names(names)} {verb} at the {support_of(silent)}: no torque about it",),)


def only_at_support(silent: list[Force | Couple]) -> Words:
    """What is said of a body on an axis on which nothing else acts."""
    return (f"{joined_names(nouns(silent))}: no torque about the {support_of(silent)}",)


def joined_names(names: list[str]) -> str:
    """Weight, axle force and press of the rope."""
    return " and ".join(filter(None, (", ".join(names[:-1]), names[-1])))


def nouns(silent: list[Force | Couple]) -> list[str]:
    """What some forces are called, each noun once."""
    return list(dict.fromkeys(item.role.noun or item.noun for item in silent))


def support_of(silent: list[Force | Couple]) -> str:
    return "axle" if any(item.role.axle for item in silent) else "pivot"
