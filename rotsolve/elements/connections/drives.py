"""Drives: belts and gears carry rotation from wheel to wheel, a motor turns one body on another, a guide moves a body as is prescribed."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from rotsolve.algebra.formula import Formula
from rotsolve.core.drive import TRAVELLING, TURNING
from rotsolve.core.facts import COUPLING, DRIVE, INNER, PULL, Couple, Force, Rule, signed
from rotsolve.core.faults import Unsolvable
from rotsolve.core.limits import Limit
from rotsolve.core.symbols import UNKNOWN, pace_of
from rotsolve.core.vectors.heading import RIGHT, UP, Heading, unit
from rotsolve.core.writing import balance
from rotsolve.elements.connections.trains import Pair, pair_of
from rotsolve.elements.shapes import rim_radius
from rotsolve.language.bodies import Body, PointRef
from rotsolve.language.elements import Connection, Fact, Moment, Surroundings
from rotsolve.language.keys import amount, key


class Belt(Connection, frozen=True):
    word = "belt"
    about = "a belt or chain round two wheels: they turn the same way, or opposite ways when it is crossed"
    quantities = ("force", "power", "work", "impulse")
    bodily = rimmed = True
    belt: tuple[PointRef, ...] = key(
        "points", "the wheels or rims", count=(2, 10), required=True, example="[motor, drum.big]"
    )
    crossed: bool = key("flag", "the belt crosses between the wheels", default=False)

    def facts(self, instant: Moment) -> Iterator[Fact]:
        """Between neighbours the belt's net pull F turns one wheel forward and holds the other back; rims run equally fast.

        What it does to a carrier of both wheels is what keeps their angular momentum together as it is.
        """
        way = -1 if self.crossed else 1
        for number, wheels in enumerate(pairwise(self.belt), 1):
            pair = pair_of(wheels, self.word, instant)
            component = "" if len(self.belt) == 2 else str(number)
            size = instant.ask("force", self.name, when=instant.span(pair.names[1]), component=component)
            turn, (first, second) = instant.sense(pair.names[1]), pair.radii
            torques = [(pair.names[1], signed(size * second, turn)), (pair.names[0], signed(size * first, -turn * way))]
            if pair.carrier:
                torques.append((pair.carrier, signed(size * (signed(first, way) - second), turn)))
            for name, torque in torques:
                yield Couple(self.name, PULL, name, torque, "belt's pull", size, place="at the rim", internal=True)
            yield no_slip(self.name, pair, way, "the belt does not slip", instant)


class Gear(Connection, frozen=True):
    word = "gear"
    about = "two toothed or rubbing wheels: they turn opposite ways without slip"
    quantities = ("force", "torque", "power", "work", "impulse")
    bodily = rimmed = True
    gear: tuple[PointRef, ...] = key(
        "points", "the two wheels or rims", count=(2, 2), required=True, example="[small, large]"
    )
    inside: bool = key("flag", "the first wheel runs inside the second: both turn the same way", default=False)

    def rooms(self, scene: Surroundings) -> Iterator[Limit]:
        """What runs inside the other is the smaller."""
        radii = [rim_radius(scene.bodies[ref.owner], ref.point) for ref in self.gear] if self.inside else []
        if radii and radii[0] is not None and radii[1] is not None:
            first, second = (f"{ref.owner}.{ref.point}" if ref.point else ref.owner for ref in self.gear)
            help = f"the smaller wheel is named first: `gear: [{second}, {first}]`"
            yield Limit(radii[1] - radii[0], f"`{first}` can not run inside `{second}`", strict=True, help=help)

    def facts(self, instant: Moment) -> Iterator[Fact]:
        """The force F between the teeth turns the second wheel forward with R₂ F, the first with ∓R₁ F; the rims run equally fast."""
        pair = pair_of(self.gear, self.word, instant)
        size = instant.ask("force", self.name, when=instant.span(pair.names[1]))
        first, second = pair.outward(self.inside, instant)
        ahead = second.turned(90 * instant.sense(pair.names[1]))
        ends = ((pair.names[1], second, pair.radii[1], ahead), (pair.names[0], first, pair.radii[0], -ahead))
        for name, outward, radius, push in ends:
            arm = outward.times(radius)
            yield Force(self.name, COUPLING, name, size, push, arm, "tooth force", place="at the rim", internal=True)
        label = "the wheels do not slip on each other"
        yield no_slip(self.name, pair, 1 if self.inside else -1, label, instant)


class MutualDrive(Connection, frozen=True):
    word = "drives"
    about = (
        "a motor, or someone's legs or hands: turns the last-named body on the first, with equal and opposite torques"
    )
    quantities = ("torque", "angular_velocity", "rotation", "work", "power", "angular_impulse")
    bodily = True
    spatial = True
    drives: tuple[PointRef, ...] = key("points", "[carrier, body]", count=(2, 2), required=True, example="[table, man]")
    couple: Formula | None = amount("torque on the last-named", "torque", "tau", varies=True, default=None)

    def between(self) -> tuple[PointRef, ...]:
        return self.drives

    def along_turns(self) -> Iterator[tuple[Formula | None, PointRef]]:
        yield self.couple, self.drives[1]

    def motor_in_space(self) -> tuple[PointRef, PointRef]:
        carrier, body = self.drives
        if self.couple is not None:
            help = (
                f"tell two opposite `actions`, each a `couple` along the axle in space: [x, y, z] on `{body.owner}`, "
                f"[-x, -y, -z] on `{carrier.owner}`; where it is told how `{body.owner}` turns, leave `couple` out, and ask "
                "`axle.torque` what it gives"
            )
            raise Unsolvable(
                f"`{self.name}` drives with a `couple`, which is not solved in space", span=body.span, help=help
            )
        return carrier, body

    def pace(self, configuration: Surroundings, state: str) -> str:
        return UNKNOWN if self.couple is None else pace_of(self.couple)

    def facts(self, instant: Moment) -> Iterator[Fact]:
        """The torque on the body, along its positive turn, and its reaction on the carrier."""
        carrier, body = (instant.host(ref.owner) for ref in self.drives)
        sense = instant.sense(self.drives[1].owner)
        if self.couple is not None:
            size = instant.now(self.couple)
        else:
            size = instant.ask(
                "torque", self.name, when=instant.span(body), words=instant.turn_words(self.drives[1].owner)
            )
        for name, turn in ((carrier, -sense), (body, sense)):
            role, way = INNER if self.couple is None else DRIVE, "counterclockwise" if turn > 0 else "clockwise"
            yield Couple(self.name, role, name, signed(size, turn), "torque", size, way)


TURNS = ("spin", "spin_rate")


def no_slip(owner: str, pair: Pair, sense: int, label: str, instant: Moment) -> Rule:
    """The rims run equally fast as seen from what carries both: R₁ (ω₁ − Ω) = ± R₂ (ω₂ − Ω)."""
    rims = (pair.spins(instant, rate, sense) for rate in TURNS)
    first, second = (balance([(one, 1), (two, -sense)]) for one, two in rims)
    bodies = (*pair.names, pair.carrier) if pair.carrier else pair.names
    return Rule(owner, label, bodies, first, second)


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
        if words & {*TRAVELLING, "momentum"}:
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
