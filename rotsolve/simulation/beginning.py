"""Beginning: where a motion starts: the scene as it stands at a state or a moment, and the places and speeds that are stated there, that
the rules tell, and rest where nothing is said."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import Formula, Number, Symbol
from rotsolve.core.equation import Equation
from rotsolve.core.registry import Registry
from rotsolve.core.symbols import TIME, has_quantities, paths_in
from rotsolve.equations.states import Fixed, Statements
from rotsolve.language.keys import keys_of
from rotsolve.language.problem import Condition, Path, State
from rotsolve.laws.rules import rule_equation
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.freebody import free_bodies
from rotsolve.motion.instant import Instant
from rotsolve.paths.meaning import NotYet

STATED = ("angle", "elongation", "length", "velocity", "angular_velocity")  # what a state may say of a moment
SINCE = ("rotation", "displacement")  # what counts from the first state


def scene_from(configuration: Configuration, state: str) -> Configuration:
    """The scene as it is arranged from a state on, under the name of its first one: what acts there, what is there."""
    problem, first = configuration.problem, configuration.timeline.states[0]
    there = {
        name
        for body in configuration.present(state)
        for name in (body.name, *(member.name for member in configuration.cluster(body.name, state)))
    }
    return Configuration(
        replace(
            problem,
            bodies=tuple(body for body in problem.bodies if body.name in there),
            connections=configuration.connections(state),
            actions=tuple(
                replace(item, from_=None, to=None) for item in configuration.actions(state) if item.to != state
            ),
            states=(first if state == first.name else State(first.name),),
            phases=(),
            events=(),
            finds=(),
            answers=(),
        )
    )


def scene_at(configuration: Configuration, time: float, numbers: Mapping[str, float]) -> Configuration:
    """The scene at a moment of its motion as a scene of its own, which starts with these places and speeds, by their names.

    What varies in it counts on from that moment.
    """
    problem, first = configuration.problem, configuration.timeline.states[0]
    conditions = tuple(
        Condition(path, Number(Fraction(number)))
        for path, number in ((path_of(name), number) for name, number in numbers.items())
        if path.quantity in STATED and (path.component or path.point) in (None, "x", "y")
    )
    state = State(first.name, conditions, span=first.span)
    connections = tuple(going_on(item, time, numbers) for item in problem.connections)
    actions = tuple(going_on(item, time, numbers) for item in problem.actions)
    return Configuration(replace(problem, states=(state,), connections=connections, actions=actions))


def path_of(name: str) -> Path:
    """`block.velocity.x` as a path."""
    owner, word, *component = name.split(".")
    return Path(owner, word, component=component[0] if component else None)


def going_on(item: Any, time: float, numbers: Mapping[str, float]) -> Any:
    """An element whose values that vary count time, rotations and displacements on from a moment."""
    changed = {}
    for word, declared in keys_of(item):
        value = getattr(item, word, None) if declared.varies else None
        if isinstance(value, Formula):
            since = {TIME: time} if TIME in value.symbols() else {}
            for letter, owner, quantity in paths_in(value):
                if quantity in SINCE:
                    since[letter] = numbers[f"{owner}.{'position' if quantity == 'displacement' else quantity}"]
            shifted = {name: Symbol(name) + Number(Fraction(number)) for name, number in since.items()}
            changed[word] = value.substitute(shifted)
    return replace(item, **changed) if changed else item


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
        if has_quantities(letter):
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
            rule = item.grip_rule(self.instant) if item.name in said else None
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
