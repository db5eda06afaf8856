"""Beginning: the places and speeds with which a motion starts: what the first state says, the rules, and rest where nothing is said."""

from __future__ import annotations

from collections.abc import Mapping

from msgspec import Struct

from rotsolve.algebra.formula import Formula
from rotsolve.core.equation import Equation
from rotsolve.core.registry import SEPARATOR, Registry
from rotsolve.elements.connections.contacts.rubbing import Rubbing
from rotsolve.elements.connections.contacts.touch import Touch
from rotsolve.inquiry.questions import NotYet
from rotsolve.inquiry.states import Fixed, Statements
from rotsolve.language.problem import Condition
from rotsolve.laws.rules import rule_equation
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.freebody import free_bodies
from rotsolve.motion.instant import Instant


class Beginning(Struct, frozen=True):
    """The first state: its moment, and what is stated there beside the values of letters."""

    instant: Instant
    stated: tuple[tuple[Equation, Condition], ...]

    def angle(self, name: str) -> Formula:
        """The angle at which a body stands: as stated, else as it is drawn."""
        angle = self.instant.angle(name)
        if angle is None:
            return self.instant.offset(name).formula()
        return self.told(angle, f"the angle of `{name}` at first is not told", f"{name}.angle")

    def place(self, word: str, owner: str) -> Formula:
        """A place that an element speaks of: the angle of a contact, how far a spring is stretched."""
        letter = self.instant.ask(word, owner)
        return self.told(letter, f"the {word} of `{owner}` at first is not told", f"{owner}.{word}")

    def told(self, letter: Formula, words: str, line: str) -> Formula:
        if any(SEPARATOR in name for name in letter.symbols()):
            raise NotYet(words, help=f"let the first state say `{line}`")
        return letter

    def speeds(self) -> tuple[Equation, ...]:
        """What ties the speeds at first: the rules, and what the state says of them."""
        facts = free_bodies(self.instant)
        said = {
            line.path.owner
            for line in self.instant.configuration.timeline.state(self.instant.state).conditions
            if line.path is not None and line.word in ("rolls", "sticks")
        }
        rules = list(facts.rules)
        for item in self.instant.configuration.connections(self.instant.state):
            rule = item.grip_rule(self.instant) if item.name in said and isinstance(item, (Touch, Rubbing)) else None
            rules += [rule] if rule is not None else []
        written = [rule_equation(rule, rule.velocity, self.instant.state) for rule in rules]
        stated = [equation for equation, _ in self.stated if equation.section == self.instant.state]
        return (*written, *stated)


def beginning(configuration: Configuration, modes: Mapping[str, str]) -> Beginning:
    """The first state of a scene."""
    registry = Registry()
    first = configuration.timeline.states[0].name
    stated = Statements(Fixed(configuration, registry, modes)).take()
    return Beginning(Instant(configuration, registry, first, False, modes), tuple(stated))
