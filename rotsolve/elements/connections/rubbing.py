"""Rubbing: two turning bodies pressed together, which slip on each other until they turn as one or their rims run equally fast."""

from __future__ import annotations

from collections.abc import Container, Iterator

from msgspec import field
from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, Formula, negate
from rotsolve.core.facts import FRICTION, NORMAL, Couple, Force, Rule, Summed, enough
from rotsolve.core.faults import Unsolvable
from rotsolve.core.limits import Limit
from rotsolve.core.vectors.heading import LEFT, RIGHT, UP, Heading, Vector, unit, vector
from rotsolve.core.writing import balance
from rotsolve.elements.connections.faces import (
    WEAR,
    Face,
    Radii,
    check_pressed,
    face_between,
    face_cone,
    face_radii,
    face_radius,
    face_uniform,
)
from rotsolve.elements.shapes import rim_radius, round_part, shape_of
from rotsolve.language.bodies import Body, PointRef
from rotsolve.language.elements import Connection, Fact, LetterMaker, Moment, Surroundings
from rotsolve.language.friction import Friction
from rotsolve.language.keys import amount, key


class Rubbing(Connection, frozen=True):
    """Base of what lets two bodies slip on each other, by friction that opposes their slip, or holds them together."""

    def rubs(self) -> bool:
        return True

    def jolts(self) -> bool:
        """Friction of a size that is known gives no impulse: they slip."""
        return not self.rubs()

    def slider(self) -> PointRef:
        return self.touches()[1]

    def names(self, instant: Moment) -> tuple[str, str]:
        first, second = self.touches()
        return instant.host(first.owner), instant.host(second.owner)

    def slip(self, instant: Moment, *, acceleration: bool = False) -> Formula:
        """How fast the second body slips on the first, or the rate of that."""
        first, second = self.sides(instant, acceleration=acceleration)
        return second - first

    def sides(self, instant: Moment, *, acceleration: bool) -> tuple[Formula, Formula]:
        """The rates of the two bodies that become equal."""
        raise NotImplementedError

    def grip_rule(self, instant: Moment) -> Rule:
        """Also while it sticks."""
        rates = [self.sides(instant, acceleration=later) for later in (False, True)]
        velocity, acceleration = (balance([(first, 1), (second, -1)]) for first, second in rates)
        return Rule(self.name, self.held(), self.names(instant), velocity, acceleration)

    def held(self) -> str:
        """What it is called that they no longer slip."""
        raise NotImplementedError


class Clutch(Rubbing, frozen=True):
    word = "clutch"
    about = "two bodies on one axis pressed together: friction brings them to one angular velocity"
    quantities = ("torque", "angular_velocity", "rotation", "work", "power", "angular_impulse")
    bodily = True
    words = ("slips", "sticks")
    clutch: tuple[PointRef, ...] = key("points", "the two bodies", count=(2, 2), required=True, example="[plate, disc]")
    friction_torque: Formula | None = amount("friction torque between them", "torque", "tau", "positive", default=None)
    press: Formula | None = amount(
        "force that presses plates together, with `friction`: torque ⅔ μ F R of discs, R that of the smaller one, named first",
        "force",
        "F",
        "positive",
        default=None,
    )
    friction: Formula | None = amount("coefficient of friction", "number", "mu", "positive", default=None)
    radius: Formula | None = face_radius()
    radii: Radii = face_radii()
    cone: Formula | None = face_cone()
    uniform: str = face_uniform()

    def completed(self, letters: LetterMaker, held: Container[str]) -> Connection:
        if self.friction_torque is not None or (self.press is not None and self.friction is not None):
            return self
        return replace(self, friction_torque=letters.make("tau", self.name, "torque"))

    def on_rims(self, scene: Surroundings) -> tuple[PointRef, ...]:
        """Plates rub on each other as far out as the smaller one reaches."""
        return self.clutch[:1] if self.friction_torque is None and face_between(self) is None else ()

    def rooms(self, scene: Surroundings) -> Iterator[Limit]:
        """Of two plates the first is not the larger, which else would rub beyond the other's rim, and lies on it, not in a hole of it."""
        refs = self.clutch if self.on_rims(scene) else ()
        faces = [face_of(scene.bodies[ref.owner], ref) for ref in refs]
        if faces and all(outer != ZERO for _, outer in faces):
            first, second = (f"{ref.owner}.{ref.point}" if ref.point else ref.owner for ref in refs)
            help = f"the smaller plate is named first: `clutch: [{second}, {first}]`"
            (_, outer), (inner, other) = faces  # of one without a radius nothing is known
            yield Limit(other - outer, f"of two plates `{first}`, named first, is the smaller one", help=help)
            if inner != ZERO:
                yield Limit(outer - inner, f"`{first}` lies in the hole of `{second}`", help="", strict=True)

    def between(self) -> tuple[PointRef, ...]:
        return self.clutch

    def check(self, scene: Surroundings) -> None:
        super().check(scene)
        check_pressed(self, self.clutch[0])

    def face(self, instant: Moment) -> Face:
        """The face with which plates rub: told, or where both of them are: out to the smaller one's rim, in to the larger hole."""
        if (told := face_between(self)) is not None:
            return told
        (inner, outer), (hole, _) = (face_of(instant.body(ref.owner), ref) for ref in self.clutch)
        if hole != inner and instant.configuration.signs.sign(hole - inner) != -1:
            if inner != ZERO and instant.configuration.signs.sign(hole - inner) is None:
                message = f"which of the holes of `{self.clutch[0].owner}` and `{self.clutch[1].owner}` is the larger one nothing tells"
                raise Unsolvable(message, span=self.clutch[0].span, help="give numbers to their radii")
            inner = hole
        return Face(inner, outer, self.uniform == WEAR, self.cone)

    def most(self, instant: Moment) -> tuple[Formula, tuple[Summed, ...]]:
        """The torque given, or that of the face, τ = ∫ r μ dN, with what defines it."""
        if self.friction_torque is not None:
            return self.friction_torque, ()
        friction, press = self.friction or ZERO, self.press or ZERO
        summed = self.face(instant).torque(self.name, friction, press, self.names(instant), instant)
        return summed.letter, (summed,)

    def sides(self, instant: Moment, *, acceleration: bool) -> tuple[Formula, Formula]:
        motions = [instant.motion(name) for name in self.names(instant)]
        first, second = ((motion.spin_rate if acceleration else motion.spin) for motion in motions)
        return first, second

    def held(self) -> str:
        return "the clutch no longer slips"

    def facts(self, instant: Moment) -> Iterator[Fact]:
        """The friction torque against the slip of each body on the other; while they stick, as large as it takes."""
        first, second = self.names(instant)
        mode = instant.mode(self.name)
        sticks = not mode.startswith("slips")
        most, defined = self.most(instant)
        yield from defined
        size = instant.ask("torque", self.name, when=instant.span(second)) if sticks else most
        turn = 1 if sticks or mode.startswith("slips back") else -1
        for name, way in ((first, -turn), (second, turn)):
            torque, sense = (size, "counterclockwise") if way > 0 else (negate(size), "clockwise")
            yield Couple(self.name, FRICTION, name, torque, "friction torque", size, sense, internal=sticks)
        if sticks:
            yield self.grip_rule(instant)
        if sticks and instant.says_to_stick(self.name):
            yield enough(self.name, size, most, "slip")


def face_of(body: Body, ref: PointRef) -> tuple[Formula, Formula]:
    """Inner and outer radius of the face with which a plate rubs; refused is what has none."""
    part = round_part(body, ref.point) if ref.point is not None else None
    if part is not None:
        return face_of(part.body, PointRef(ref.owner, None, span=ref.span))
    shape = shape_of(body)
    face = (
        shape.face() if body.shape is not None and not shape.pointlike else (ZERO, rim_radius(body, ref.point) or ZERO)
    )
    if face is None or body.holes or body.parts:
        message = f"over what face `{body.name}` rubs on another nothing tells"
        raise Unsolvable(
            message, span=ref.span, help="give the clutch its `friction_torque`, or it a disc, ring or tube"
        )
    return face


class Rims(Rubbing, frozen=True):
    """Two wheels on fixed axles side by side, the second on the right, whose rims are pressed together by a force."""

    word = "contact"
    quantities = ("force", "normal_force", "friction_force", "torque", "work", "power", "impulse", "angular_impulse")
    pointed = ("wheels",)

    wheels: tuple[PointRef, ...] = ()
    press: Formula = ZERO
    friction: Friction = field(default_factory=Friction)

    def on_rims(self, scene: Surroundings) -> tuple[PointRef, ...]:
        return self.wheels

    def rooms(self, scene: Surroundings) -> Iterator[Limit]:
        return self.friction.rooms(self.name)

    def rubs(self) -> bool:
        return self.friction.kind == "coefficient"

    def arms(self, instant: Moment) -> list[tuple[str, Vector, Heading]]:
        """Each wheel, where it touches the other from its axle, and the way in which it is pushed."""
        found = []
        for ref, side in zip(self.wheels, (RIGHT, LEFT), strict=True):
            radius = rim_radius(instant.body(ref.owner), ref.point) or ZERO
            found.append((instant.host(ref.owner), vector(radius, side), side.turned(180)))
        return found

    def sides(self, instant: Moment, *, acceleration: bool) -> tuple[Formula, Formula]:
        rates = []
        for name, arm, _ in self.arms(instant):
            motion = instant.motion(name)
            rate = motion.spin_rate if acceleration else motion.spin
            rates.append(arm.turned(90).times(rate).along(UP))
        return rates[0], rates[1]

    def held(self) -> str:
        return "the rims no longer slip on each other"

    def facts(self, instant: Moment) -> Iterator[Fact]:
        """The push on each wheel, and friction along the rims: against the slip, or as large as it takes."""
        mode, arms = instant.mode(self.name), self.arms(instant)
        for name, arm, push in arms:
            yield Force(self.name, NORMAL, name, self.press, unit(push), arm, "push", works=False, internal=True)
        if self.friction.kind == "none":
            return
        sticks = not mode.startswith("slips")
        if sticks:
            size, sense = instant.held_by_friction(self.name, instant.span(arms[1][0]), ("", ""))
        else:
            size = ((self.friction.static if mode.endswith("at most") else self.friction.kinetic) or ZERO) * self.press
            sense = 1 if mode.startswith("slips back") else -1
        up = sense > 0
        for (name, arm, _), upward in zip(arms, (not up, up), strict=True):
            along = unit(UP if upward else UP.turned(180))
            turn = "counterclockwise" if upward == (arm.parts[0][1] == RIGHT) else "clockwise"
            noun, way = "friction" if sticks else "kinetic friction", f"turning it {turn}"
            yield Force(self.name, FRICTION, name, size, along, arm, noun, way, works=not sticks, internal=sticks)
        if sticks:
            yield self.grip_rule(instant)
        if sticks and instant.says_to_stick(self.name) and self.friction.static is not None:
            yield enough(self.name, size, self.friction.static * self.press, "slip")
