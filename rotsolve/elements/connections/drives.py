"""Drives: belts and gears carry rotation from wheel to wheel, a motor turns one body on another, a guide moves a body as is prescribed."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.drive import TRAVELLING, TURNING
from rotsolve.core.facts import COUPLING, DRIVE, INNER, Couple, Force, Rule, signed
from rotsolve.core.symbols import UNKNOWN, pace_of
from rotsolve.core.vectors.heading import RIGHT, UP, Heading, unit
from rotsolve.core.writing import balance
from rotsolve.elements.shapes import rim_radius
from rotsolve.language.bodies import Body, PointRef
from rotsolve.language.elements import Connection, Fact, Moment, Surroundings
from rotsolve.language.keys import amount, key


class Belt(Connection, frozen=True):
    word = "belt"
    about = "a belt or chain round two wheels: they turn the same way, or opposite ways when it is crossed"
    quantities = ("tension", "force", "power", "work")
    bodily = rimmed = True
    belt: tuple[PointRef, ...] = key(
        "points", "the wheels or rims", count=(2, 10), required=True, example="[motor, drum.big]"
    )
    crossed: bool = key("flag", "the belt crosses between the wheels", default=False)

    def facts(self, instant: Moment) -> Iterator[Fact]:
        """Between neighbours the belt's net pull F turns one wheel forward and holds the other back; rims run equally fast."""
        sense = -1 if self.crossed else 1
        words = ("the belt does not slip", "belt's pull")
        for number, pair in enumerate(pairwise(self.belt), 1):
            component = "" if len(self.belt) == 2 else str(number)
            yield from coupling(self.name, pair, sense, component, words, instant)


class Gear(Connection, frozen=True):
    word = "gear"
    about = "two toothed or rubbing wheels: they turn opposite ways without slip"
    quantities = ("force", "torque", "power", "work", "impulse")
    bodily = rimmed = True
    gear: tuple[PointRef, ...] = key(
        "points", "the two wheels or rims", count=(2, 2), required=True, example="[small, large]"
    )
    inside: bool = key("flag", "the first wheel runs inside the second: both turn the same way", default=False)

    def facts(self, instant: Moment) -> Iterator[Fact]:
        words = ("the wheels do not slip on each other", "tooth force")
        yield from coupling(self.name, self.gear, 1 if self.inside else -1, "", words, instant)


class MutualDrive(Connection, frozen=True):
    word = "drives"
    about = (
        "a motor, or someone's legs or hands: turns the last-named body on the first, with equal and opposite torques"
    )
    quantities = ("torque", "angular_velocity", "rotation", "work", "power", "angular_impulse")
    bodily = True
    drives: tuple[PointRef, ...] = key("points", "[carrier, body]", count=(2, 2), required=True, example="[table, man]")
    couple: Formula | None = amount("torque on the last-named", "torque", "tau", varies=True, default=None)

    def between(self) -> tuple[PointRef, ...]:
        return self.drives

    def pace(self, configuration: Surroundings, state: str) -> str:
        return UNKNOWN if self.couple is None else pace_of(self.couple)

    def facts(self, instant: Moment) -> Iterator[Fact]:
        """The torque on the body, along its positive turn, and its reaction on the carrier."""
        carrier, body = (instant.host(ref.owner) for ref in self.drives)
        sense = instant.sense(body)
        if self.couple is not None:
            size = instant.now(self.couple)
        else:
            size = instant.ask("torque", self.name, when=instant.span(body), words=instant.turn_words(body))
        for name, turn in ((carrier, -sense), (body, sense)):
            role, way = INNER if self.couple is None else DRIVE, "counterclockwise" if turn > 0 else "clockwise"
            yield Couple(self.name, role, name, signed(size, turn), "torque", size, way)


def coupling(
    owner: str, pair: tuple[PointRef, ...], sense: int, component: str, words: tuple[str, str], instant: Moment
) -> Iterator[Fact]:
    """Two rims run equally fast, R₁ ω₁ = ± R₂ ω₂; the force F between them turns the second with +R₂ F, the first with ∓R₁ F."""
    names = [instant.host(ref.owner) for ref in pair]
    radii = [rim_radius(instant.body(ref.owner), ref.point) or ZERO for ref in pair]
    force = instant.ask("force", owner, when=instant.span(names[1]), component=component)
    (label, noun), turn = words, instant.sense(names[1])
    for name, radius, way in ((names[1], radii[1], turn), (names[0], radii[0], -turn * sense)):
        torque = signed(force * radius, way)
        yield Couple(owner, COUPLING, name, torque, noun, force, place="at the rim", internal=True)
    sides = []
    for rate in ("spin", "spin_rate"):
        values = [radius * getattr(instant.motion(name), rate) for name, radius in zip(names, radii, strict=True)]
        sides.append(balance([(values[0], 1), (values[1], -sense)]))
    yield Rule(owner, label, tuple(names), sides[0], sides[1])


class Guide(Connection, frozen=True):
    """What a body's own keys `velocity`, `angle`, … stand for; no scene writes it as a connection."""

    word = "guide"
    quantities = ("force", "torque")
    pointed = ("guided",)

    guided: tuple[PointRef, ...] = ()
    motions: tuple[tuple[str, str, Formula], ...] = ()

    def prescribes(self) -> Iterator[tuple[str, str, str, Formula]]:
        for word, component, function in self.motions:
            yield self.guided[0].owner, word, component, function

    def pace(self, configuration: Surroundings, state: str) -> str:
        paces = [drive.pace for drive in configuration.drives(self.guided[0].owner, state)]
        return max(paces, key=("constant", "time").index)

    def facts(self, instant: Moment) -> Iterator[Fact]:
        """A couple where its turning is prescribed, a force at the centre of mass where its travel is."""
        name = instant.host(self.guided[0].owner)
        words = {word for word, _, _ in self.motions}
        if words & set(TURNING):
            size = instant.ask("torque", self.name, when=instant.span(name), words=instant.turn_words(name))
            yield Couple(self.name, DRIVE, name, signed(size, instant.sense(name)), "driving torque", size)
        if words & set(TRAVELLING):
            for component, direction, said in self._ways(name, instant):
                size = instant.ask("force", self.name, when=instant.span(name), component=component)
                arm = instant.centre_of_mass(name)
                yield Force(self.name, DRIVE, name, size, unit(direction), arm, "driving force", said)

    def _ways(self, name: str, instant: Moment) -> Iterator[tuple[str, Heading, str]]:
        """Along the body's line, or right and up."""
        line = instant.configuration.line(name, instant.state)
        if line is not None:
            yield "", line[0], line[1]
        else:
            yield from (("x", RIGHT, "right"), ("y", UP, "up"))


def guide(body: Body) -> Guide:
    """The guide of a body whose motion is prescribed."""
    return Guide(f"drive of {body.name}", (PointRef(body.name, span=body.span),), body.moved)
