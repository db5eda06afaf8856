"""Slots: a pin slides without friction in a straight slot, which holds it on both sides: across the slot (v_pin − v_slot) · n = 0."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.formula import ZERO, Formula, call
from rotsolve.core.facts import GUIDE, Force, Rule
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.heading import DOWN, LEFT, Direction, Heading, along_text, heading, opposite, pointing, unit
from rotsolve.core.writing import spoken
from rotsolve.elements.shapes import rims, shape_of, taken_round
from rotsolve.language.bodies import PointRef
from rotsolve.language.elements import Connection, Fact, Moment, PlaceOf, Surroundings
from rotsolve.language.keys import key

FIXED = PointRef("ground")
STRAIGHT = ("right", "left", "up", "down")


class PinSlot(Connection, frozen=True):
    word = "slot"
    about = "a pin of one body slides without friction in a straight slot of the ground or of another body, which holds it on both sides"
    instead = "`collar: [[x, y, z], BODY.P], along: x` holds a point on a line"
    quantities = ("force",)
    guiding = True
    slot: tuple[PointRef, ...] = key(
        "points",
        "the pin, or the pin and where it is in the body that has the slot, `arm.at(s)`",
        count=(1, 2),
        required=True,
        example="[crank.end, arm.at(s)]",
    )
    along: Direction | None = key(
        "direction",
        f"how the slot runs: {', '.join(STRAIGHT)}, [x, y] or an angle; that of a rod runs along it",
        default=None,
        choices=STRAIGHT,
    )

    @property
    def pin(self) -> PointRef:
        return self.slot[0]

    @property
    def within(self) -> PointRef:
        """The place in the body that has the slot; the ground where none has."""
        return self.slot[1] if len(self.slot) > 1 else FIXED

    def check(self, scene: Surroundings) -> None:
        """It runs along a rod, or in a direction that stays; where the pin is in a slot that turns is told of one moment."""
        pin, within, carrier = self.pin, self.within, scene.bodies.get(self.within.owner)
        if pin.owner not in scene.bodies:
            raise Unsolvable(f"`{pin.owner}` is no body with a pin", span=pin.span, help="name the pin first")
        if carrier is not None and carrier.name == pin.owner:
            raise Unsolvable(f"`{pin.owner}` has both the pin and its slot", span=within.span, help="name two bodies")
        for ref in self.slot:
            if ref.owner in scene.bodies and ref.point in {*rims(scene.bodies[ref.owner]), "rim", "top", "bottom"}:
                help = f"a point that turns with it: `points: {{P: [R, 0]}}` of `{ref.owner}`, and `{ref.owner}.P`"
                message = f"`{ref.owner}.{ref.point}` is a direction in space and no place of a pin"
                raise Unsolvable(message, span=ref.span, help=help)
        if carrier is None or not self.carrier_turns(scene):
            if self.along is None:
                help = "say `along: right`, `along: up` or an angle"
                raise Unsolvable(
                    f"nothing tells how the slot of `{self.name}` runs", span=within.span or pin.span, help=help
                )
            return
        self.check_turning(scene)

    def check_turning(self, scene: Surroundings) -> None:
        """Of a slot in a body that turns: a rod, a point on it, and one state."""
        within, carrier = self.within, scene.bodies[self.within.owner]
        if not shape_of(carrier).slender or self.along is not None:
            message = f"the slot of `{self.name}`, in a body that turns, has to run along a rod"
            help = "leave `along` out; a plate with a slot is a `weld` of a light rod to it"
            raise Unsolvable(message, span=within.span, help=help)
        if within.point is None:
            help = f"`{carrier.name}.at(x)` is x from its start"
            raise Unsolvable(f"nothing tells where along `{carrier.name}` the pin is", span=within.span, help=help)
        if len(scene.problem.states) > 1:
            message = f"how the pin of `{self.name}` goes along `{carrier.name}` from state to state is not solved yet"
            raise Unsolvable(message, span=within.span, help="ask for one moment, with the place of the pin there")

    def carrier_turns(self, scene: Surroundings) -> bool:
        """Whether the body that has the slot turns, and the slot with it."""
        name, states = self.within.owner, scene.throughout(self.name)
        return name in scene.held or any(scene.can_turn(scene.host(name, state), state) for state in states)

    def heading(self, instant: Moment) -> Heading:
        """The direction in which the slot runs at a moment."""
        if self.along is None:
            return heading(instant.angle_of(self.within.owner))
        if isinstance(self.along, tuple):
            x, y = self.along
            return heading(call("atan2", y, x))
        return pointing(self.along).parts[0][1]

    def across(self, instant: Moment) -> Heading:
        """The direction across it in which its push counts: of a slot that does not turn to the right or up where it can."""
        out = self.heading(instant).turned(90)
        return out.turned(180) if self.along is not None and out in (LEFT, DOWN) else out

    def pace(self, configuration: Surroundings, state: str) -> str:
        return "position"

    def leans(self, configuration: Surroundings, state: str) -> tuple[str, ...]:
        return taken_round(self.slot, configuration, state)

    def place(self, name: str, way: Heading, instant: Moment, place_of: PlaceOf) -> Formula | None:
        """Across a slot that does not turn, of the body with the pin or with the slot: that of the other's point."""
        if self.along is None or (self.heading(instant) - way).cos() != ZERO:
            return None
        for own, other in ((self.pin, self.within), (self.within, self.pin)):
            if own.owner in instant.configuration.bodies and instant.host(own.owner) == name:
                base = place_of(other) if other.owner in instant.configuration.bodies else ZERO
                return None if base is None else base - instant.point(own).along(way)
        return None

    def facts(self, instant: Moment) -> Iterator[Fact]:
        """One force across the slot, on the pin and back on the body that has the slot; the pin does not leave it."""
        pin, within, across = self.pin, self.within, self.across(instant)
        name = instant.host(pin.owner)
        moving = within.owner in instant.configuration.bodies
        words = along_text(across) or "across the slot"
        ways = (words, opposite(words))
        size = instant.ask("force", self.name, when=instant.span(name), words=ways)
        push = Force(
            self.name,
            GUIDE,
            name,
            size,
            unit(across),
            instant.point(pin),
            "push of the slot",
            words,
            works=False,
            internal=True,
        )
        yield push
        if moving:
            back, host = unit(across.turned(180)), instant.host(within.owner)
            yield Force(
                self.name,
                GUIDE,
                host,
                size,
                back,
                instant.point(within),
                "push of the pin",
                ways[1],
                works=False,
                internal=True,
            )
        yield self.keeps(across, instant)

    def keeps(self, across: Heading, instant: Moment) -> Rule:
        """Across the slot the pin moves as the slot does: v · n = v_s · n, a · n = a_s · n + 2 ω v_along (Coriolis)."""
        pin, within = self.pin, self.within
        velocity, base = instant.velocity(pin), instant.velocity(within)
        sliding = (velocity - base).along(across.turned(-90))
        moving = within.owner in instant.configuration.bodies
        turning = instant.motion(within.owner).spin if moving else ZERO
        acceleration = instant.acceleration(within).along(across) + 2 * turning * sliding
        bodies = tuple(ref.owner for ref in (pin, within) if ref.owner in instant.configuration.bodies)
        rates = (velocity.along(across), base.along(across))
        bends = (instant.acceleration(pin).along(across), acceleration)
        several = sum(isinstance(item, PinSlot) for item in instant.configuration.problem.connections) > 1
        label = f"the pin stays in its slot{f', {spoken(self.name)}' if several else ''}"
        coriolis = ("with 2 ω v across the slot, v along it",) if ZERO not in (turning, sliding) else ()
        return Rule(self.name, label, bodies, rates, bends, linear=False, bent=coriolis)
