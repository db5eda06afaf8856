"""Swing: a group of bodies at its equilibrium, and displaced from it by a coordinate that the laws are written for."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import ZERO, Formula, Symbol, call
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.units.dimension import Dimension
from rotsolve.core.equation import Equation
from rotsolve.core.facts import Facts
from rotsolve.core.quantity import FREQUENCIES, QUANTITIES
from rotsolve.core.remembered import remembered
from rotsolve.core.symbols import SymbolKey, has_quantities, key_of, of_kinds
from rotsolve.core.vectors.heading import RIGHT, UP, heading, opposite
from rotsolve.core.writing import spoken
from rotsolve.equations.states import rates_of_body
from rotsolve.laws.rules import rule_equation
from rotsolve.laws.table import NEAR, REST, SWINGING, AtMoment, OfGroup, equations_for
from rotsolve.motion.freebody import free_bodies
from rotsolve.motion.instant import Instant
from rotsolve.paths.meaning import NotYet

STRETCHES = ("elongation", "angle", "displacement")  # places that a balance of forces tells
HARMONIC = " harmonic"  # ends the key of the section in which the harmonic motion is written


class Swing(Struct, frozen=True, dict=True):
    """Bodies of `group` near their equilibrium: `rest` and `near` are the two moments, `still` the same with any small motion.

    The coordinate is the angle turned or the way gone by `body` from the equilibrium, along its positive sense. `found` says that
    the equilibrium was worked out here and is no state of the scene; `start` names the state at rest from which a large swing starts.
    """

    body: str
    group: frozenset[str]
    rest: Instant
    still: Facts
    near: Instant
    found: bool
    start: str = ""  # the state at which a large swing starts
    number: int | None = None  # of several modes the one that is meant

    @property
    def section(self) -> str:
        """Key of the section of the displaced bodies."""
        return f"{self.near.when} {self.body}"

    @property
    def balanced(self) -> str:
        """Key of the section of an equilibrium that is no state of the scene."""
        return f"{self.rest.when} {self.body}" if self.found else self.rest.when

    @property
    def harmonic(self) -> str:
        """Key of the section of the period."""
        return self.section + (f" from {self.start}" if self.start else HARMONIC)

    @cached_property
    def turns(self) -> bool:
        """Whether the coordinate is an angle."""
        return self.near.motion(self.body).kind != "line"

    @cached_property
    def coordinate(self) -> Symbol:
        """Angle or way from the equilibrium."""
        return symbol_of(list(displacements_of_body(self.near, self.body))[-1 if self.turns else 0])

    @property
    def coordinates(self) -> tuple[Symbol, ...]:
        """All coordinates that count from the equilibrium."""
        return (self.coordinate,)

    @cached_property
    def acceleration(self) -> Symbol:
        """Second rate of the coordinate."""
        return symbol_of(list(rates_of_body("acceleration", self.near, self.body))[-1 if self.turns else 0])

    def title(self, key: str) -> str:
        """Heading of one of its sections; nothing for another one."""
        angle = self.rest.registry.known.get(SymbolKey("angle", self.body, "", self.rest.when).name)
        told = angle is not None and (self.weighs or angle != ZERO)  # what nothing pulls down may have any angle for 0
        found = (
            f"the equilibrium at {in_degrees(angle)}{self.hanging}" if told and angle is not None else "the equilibrium"
        )
        place = found if self.found else spoken(self.rest.state)
        headings = {
            self.balanced if self.found else "": "In equilibrium",
            self.section: f"Displaced from {place}",
            self.harmonic: f"Swings from {spoken(self.start)}" if self.start else f"Small swings about {place}",
        }
        return headings.get(key, "") if key else ""

    @property
    def weighs(self) -> bool:
        """Whether a weight acts on the body that swings."""
        body = next(body for body in self.still.bodies if body.name == self.body)
        return any(force.role.weighs for force in body.forces)

    @property
    def hanging(self) -> str:
        """In brackets how a hinged body stands in its equilibrium, where its weight acts straight below or above the hinge."""
        body = next(body for body in self.still.bodies if body.name == self.body)
        weight = next((force for force in body.forces if force.role.weighs), None)
        if weight is None or body.motion.kind != "axis" or not is_zero(weight.arm.along(RIGHT)):
            return ""
        side = self.rest.configuration.signs.of_sizes(simplify(weight.arm.along(UP)))
        return {-1: " (hanging straight down)", 1: " (straight up)"}.get(side or 0, "")

    @property
    def place(self) -> str:
        """The state whose equilibrium it is; nothing for that of the scene as it is at first."""
        first = self.near.configuration.timeline.states[0].name
        return "" if self.found and self.near.state == first else self.near.state

    @property
    def omega(self) -> Symbol:
        """ω₀ of the small swings."""
        return symbol_of(self.near.ask("angular_frequency", self.body, when=self.place))

    @property
    def letters(self) -> dict[str, Formula]:
        """The period, frequency and angular frequency, of small swings or of the large one from its start."""
        return {word: self.near.ask(word, self.body, when=self.start or self.place) for word in FREQUENCIES}

    @property
    def exact(self) -> bool:
        """Whether the laws near the equilibrium hold at any distance from it: no rule and no spring changes its direction."""
        facts = self.within(free_bodies(moving(self.near)))
        rates = [stored.rate for stored in facts.potentials if self.group & set(stored.bodies)]
        return all(rule.linear for rule in facts.rules) and not any(
            self.coordinate.name in rate.symbols() for rate in rates
        )

    @cached_property
    def long(self) -> tuple[str, ...]:
        """Springs whose ends also move across them, which the laws leave out: they have to be long."""
        placed = {stored.owner for stored in self.still.potentials if stored.placed}
        pulls = ((body, force) for body in self.within(self.still).bodies for force in body.forces)
        springs = ((body, force) for body, force in pulls if force.role.springs and force.owner not in placed)
        across = ((force, body.motion.velocity_of(force.arm).cross(force.direction)) for body, force in springs)
        return tuple(dict.fromkeys(force.owner for force, speed in across if not is_zero(speed)))

    def dimension(self, word: str) -> Dimension:
        """The dimension of what is asked of it."""
        return QUANTITIES[word].dimension

    def amplitude(self) -> Formula:
        """The angle from the equilibrium at which a large swing starts, at rest."""
        start = Instant(self.near.configuration, self.near.registry, self.start, False, self.near.modes)
        angle, rest = start.angle(self.body), self.rest.angle(self.body)
        if angle is None or rest is None or has_quantities(angle):
            raise NotYet(f"how far `{self.body}` swings is not told", help=f"say `{self.body}.angle` at `{self.start}`")
        if any(rate != ZERO for rate in rates_of_body("velocity", start, self.body)):
            raise NotYet(
                f"`{self.body}` is not at rest at `{self.start}`", help="a swing is asked from where it is let go"
            )
        amplitude = simplify(angle - rest)
        if is_zero(call("cos", amplitude) + 1):
            raise NotYet(f"`{self.body}` is let go straight above its equilibrium, and stays there")
        return amplitude

    @cached_property
    def unsettled(self) -> tuple[str, ...]:
        """Places of the equilibrium that the balance of forces has to tell: how far springs and wires are stretched."""
        names = of_kinds({name for equation in self.equations() for name in equation.symbols()}, STRETCHES)
        return tuple(name for name in names if key_of(name).when == self.rest.when)

    @remembered
    def equations(self) -> tuple[Equation, ...]:
        """The laws at the equilibrium and near it, the rules to first order, and what the period has to do with them."""
        return tuple(self._written())

    def _written(self) -> Iterator[Equation]:
        if self.found:  # Σ F = 0 and Σ τ = 0, where it is no state of the scene
            facts = self.within(free_bodies(self.rest))
            yield from equations_for(REST, AtMoment(facts, self.balanced, self.balanced))
            yield from equations_for(SWINGING, OfGroup(facts, self.still, self.group, self.balanced))
        facts, section = self.within(free_bodies(self.near)), self.section
        yield from equations_for(NEAR, AtMoment(facts, section, section))
        changes = displacements(self.rest, self.near)
        for rule in self.within(self.still).rules:
            left, right = (side.substitute(changes) for side in rule.velocity)
            yield rule_equation(rule, (left, right), section)
        yield from equations_for(SWINGING, OfGroup(facts, free_bodies(moving(self.near)), self.group, section))

    def within(self, facts: Facts) -> Facts:
        """The facts of the bodies that swing together."""
        bodies = tuple(body for body in facts.bodies if body.name in self.group)
        return replace(facts, bodies=bodies, rules=tuple(rule for rule in facts.rules if self.group & set(rule.bodies)))


def in_degrees(angle: Formula) -> str:
    """An angle as a heading says it: −90°."""
    turned = heading(angle)
    return to_text(angle) if turned.terms else f"{turned.degrees}°".replace("-", "−")


def moving(instant: Instant) -> Instant:
    """The same moment with any small motion that the rules allow."""
    return Instant(
        instant.configuration, instant.registry, instant.state, instant.generic, instant.modes, True, instant.mark
    )


def symbol_of(letter: Formula) -> Symbol:
    assert isinstance(letter, Symbol)
    return letter


def displacements_of_body(instant: Instant, name: str) -> Iterator[Formula]:
    """Displacements of a body from its equilibrium, in the order of its rates."""
    motion, line = instant.motion(name), instant.line(name)
    if motion.kind == "line":
        yield instant.ask("displacement", name, words=(line[1], opposite(line[1])) if line else ("", ""))
    elif motion.kind == "plane":
        yield from (instant.ask("displacement", name, component=axis) for axis in "xy")
    if motion.turns:
        yield instant.ask("rotation", name, words=instant.turn_words(name))


def displacements(rest: Instant, near: Instant) -> dict[str, Formula]:
    """Displacements by the names of the velocities that they come from, of any small motion from the equilibrium."""
    virtual, found = moving(rest), dict[str, Formula]()
    for body in near.configuration.present(near.state):
        rates, places = rates_of_body("velocity", virtual, body.name), displacements_of_body(near, body.name)
        found |= {rate.name: place for rate, place in zip(rates, places, strict=True) if isinstance(rate, Symbol)}
    return found
