"""Actions: forces, couples and powers that act from outside."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.formula import ONE, ZERO, Formula, Negative, call, sqrt
from rotsolve.core import facts
from rotsolve.core.derivation import NEXT, Words
from rotsolve.core.faults import Unsolvable
from rotsolve.core.symbols import CONSTANT, POSITION, RATE, combined, pace_of
from rotsolve.core.vectors.heading import (
    DOWN,
    LEFT,
    RIGHT,
    UP,
    Direction,
    Heading,
    Vector,
    along_text,
    pointing,
    unit,
    vector,
)
from rotsolve.elements.connections.lying import check_wheel
from rotsolve.elements.shapes import rim_radius, rims, taken_round
from rotsolve.language.bodies import PointRef
from rotsolve.language.elements import Action, Fact, Moment, Surroundings
from rotsolve.language.keys import amount, key

DIRECTIONS = ("right", "left", "up", "down", "tangential", "clockwise", "counterclockwise")


def aimed() -> Direction | None:
    """The field of a direction, which may be that of a turn."""
    words = f"{', '.join(DIRECTIONS)}, [x, y] or an angle"
    declared: Direction | None = key("direction", words, default=None, choices=DIRECTIONS)
    return declared


SQUARE = (None, "tangential", "clockwise", "counterclockwise")  # directions square to the arm


class AppliedForce(Action, frozen=True):
    word = "force"
    at_points = True
    about = "a force on a point of a body; pulled off a wheel's rim with `over` or `under`"
    quantities = ("force", "torque", "work", "power", "impulse", "angular_impulse")
    spatial = True
    force: Formula | None = key(
        "amount",
        "size; `unknown` asks for it; in space also `[Fx, Fy, Fz]`, or `any`: whatever it takes",
        default=None,
        dimension="force",
        letter="F",
        varies=True,
        required=True,
        example="20 N",
    )
    on: PointRef | None = key("point", "where it acts", required=True, example="rod.end")
    direction: Direction | None = aimed()
    over: bool = key("flag", "the pull leaves the wheel at its top", default=False, plane=True)
    under: bool = key("flag", "the pull leaves the wheel at its bottom", default=False, plane=True)

    def pace(self, configuration: Surroundings, state: str) -> str:
        """Also by its arm: a force that keeps its direction pulls a turning body at an ever other angle."""
        return combined(
            (super().pace(configuration, state), POSITION if self.leans(configuration, state) else CONSTANT)
        )

    def leans(self, configuration: Surroundings, state: str) -> tuple[str, ...]:
        """Not of what follows the turn, nor on a rim, whose names are directions in space."""
        on = self.on
        if on is None or self.direction in SQUARE or self.over or self.under:
            return ()
        return taken_round((on,), configuration, state)

    def along_turns(self) -> Iterator[tuple[Formula | None, PointRef]]:
        """Square to an arm, with no way round said."""
        if self.on is not None and self.direction in (None, "tangential"):
            yield self.force, self.on

    def on_rims(self, scene: Surroundings) -> tuple[PointRef, ...]:
        """Where the pull leaves a rim, or goes square to the arm: of a body that turns, also without a direction."""
        square = self.direction in SQUARE[1:] or (self.direction is None and self.on and self.on.owner in scene.held)
        return self.touches() if self.over or self.under or square else ()

    def facts(self, instant: Moment) -> Iterator[Fact]:
        if self.on is None:
            return
        size = self.now(instant)
        push, arm = self.aim(instant, self.on)
        told = self.told(push, arm, instant)
        if isinstance(size, Negative) and len(push.parts) == 1:  # −k x to the right is k x to the left
            size, push = size.operand, -push
            told = along_text(push.parts[0][1]) or f"{told}, backwards"
        yield facts.Force(self.name, facts.APPLIED, instant.host(self.on.owner), size, push, arm, "force", told)

    def aim(self, instant: Moment, on: PointRef) -> tuple[Vector, Vector]:
        """Unit vector of the force, and where it acts from the body's reference."""
        motion = instant.motion(on.owner)
        radius = rim_radius(instant.body(on.owner), on.point)
        square = motion.kind == "axis" or (self.direction is not None and has_arm(on, instant.point(on), instant))
        if self.direction in SQUARE and square:
            return across(on, instant.point(on), turn_sense(self.direction, instant.sense(on.owner)), instant)
        if self.direction in SQUARE:
            return unit(self.onward(motion.heading, on)), instant.point(on)
        direction = pointing(self.direction)
        if radius is not None and (self.over or self.under):
            outward = direction.turned(90 if self.rightward(direction, instant, on) == self.over else -90)
            return direction, instant.hub(on) + outward.times(radius)
        return direction, instant.point(on)

    def onward(self, heading: Heading | None, on: PointRef) -> Heading:
        """The way in which a body travels, along which what is `tangential` at its centre acts, as what has no direction does."""
        if self.direction is None:
            return heading or RIGHT
        if heading is None or self.direction != "tangential":
            message = f"`{self.name}` acts at the centre of `{on.owner}`, where no direction is {self.direction}"
            raise Unsolvable(message, span=on.span, help="say its direction in another way, or name another point")
        return heading

    def rightward(self, direction: Vector, instant: Moment, on: PointRef) -> bool:
        """Whether it pulls to the right, so that it turns a wheel clockwise from its top; straight up or down it does neither."""
        question = f"whether `{self.name}` pulls to the right, and so on which side of `{on.owner}`,"
        sign = instant.configuration.certain_sign(direction.along(RIGHT), question, on.span)
        if not sign:
            message = f"`{self.name}` pulls straight up or down, and leaves `{on.owner}` at its side, neither over nor under it"
            help = f"leave that out, and name the point: `on: {on.owner}.right`, or `points: {{P: [r, 0]}}` and `on: {on.owner}.P`"
            raise Unsolvable(message, span=on.span, help=help)
        return sign > 0

    def told(self, push: Vector, arm: Vector, instant: Moment) -> str:
        """Direction in words."""
        if isinstance(self.direction, str):
            return self.direction
        if self.direction is None and self.on is not None and instant.motion(self.on.owner).kind == "axis":
            return "along the positive turn"
        text = along_text(push.parts[0][1]) if len(push.parts) == 1 else ""
        return text or "at its angle"


class AppliedCouple(Action, frozen=True):
    word = "couple"
    about = "a torque without a force, along the body's positive sense unless `direction` says otherwise"
    quantities = ("torque", "work", "power", "angular_impulse")
    spatial = True
    couple: Formula | None = key(
        "amount",
        "torque; `unknown` asks for it; in space also `[Mx, My, Mz]`, or `any`: whatever it takes",
        default=None,
        dimension="torque",
        letter="tau",
        varies=True,
        required=True,
    )
    on: PointRef | None = key("point", "the body that it turns", required=True, example="wheel")
    direction: Direction | None = key(
        "direction", "clockwise or counterclockwise", default=None, choices=("clockwise", "counterclockwise")
    )

    def twists(self) -> bool:
        return True

    def along_turns(self) -> Iterator[tuple[Formula | None, PointRef]]:
        if self.on is not None and self.direction is None:
            yield self.couple, self.on

    def facts(self, instant: Moment) -> Iterator[Fact]:
        if self.on is None:
            return
        name, size = instant.host(self.on.owner), self.now(instant)
        turn = turn_sense(self.direction, instant.sense(self.on.owner))
        if isinstance(size, Negative):  # a drag −c ω is a torque c ω the other way
            size, turn = size.operand, -turn
        way = "clockwise" if turn < 0 else "counterclockwise"
        yield facts.Couple(self.name, facts.APPLIED, name, facts.signed(size, turn), "torque", size, way)


class Press(Action, frozen=True):
    word = "press"
    about = "a brake block pressed on a rim"
    instead = (
        "while it turns one way, a couple against that does the same: `actions: {brake: {couple: -mu*F*R, on: BODY}}`"
    )
    quantities = ("force", "normal_force", "friction_force", "torque", "work", "power")
    press: Formula | None = amount("force that presses", "force", "F", "nonnegative", varies=True, required=True)
    on: PointRef | None = key("point", "the rim", required=True, example="wheel.rim")
    friction: Formula | None = amount("coefficient of friction", "number", "mu", "nonnegative", required=True)

    def on_rims(self, scene: Surroundings) -> tuple[PointRef, ...]:
        return self.touches()

    def check(self, scene: Surroundings) -> None:
        for ref in self.touches():
            check_wheel(ref, "a brake block is solved for a wheel on a fixed axle only", scene)

    def brakes(self) -> tuple[PointRef, ...]:
        return self.touches()

    def facts(self, instant: Moment) -> Iterator[Fact]:
        """The push towards the axle, and friction μ F against the turn; as large as it takes while it holds the wheel still."""
        if self.on is None:
            return
        name, push = instant.host(self.on.owner), self.now(instant)
        mode, sense = instant.mode(f"{self.name}.{name}"), instant.sense(name)
        forward, back = instant.turn_words(name)
        arm, inward = vector(rim_radius(instant.body(self.on.owner), self.on.point) or ZERO, RIGHT), "towards the axle"
        yield facts.Force(self.name, facts.NORMAL, name, push, unit(LEFT), arm, "push", inward, works=False)
        if pace_of(self.press or ZERO) != CONSTANT:
            kept, otherwise = "the block is pressed on", f"`{self.name}` would have to pull at"
            yield facts.Requirement(self.name, facts.PRESSES, push, ZERO, kept, otherwise)
        turn = sense if mode == "turns back" else -sense
        against = UP if turn > 0 else DOWN
        if mode != "holds":
            size, told = (self.friction or ZERO) * push, forward if mode == "turns back" else back
            way = f"turning it {told}"
            yield facts.Force(self.name, facts.FRICTION, name, size, unit(against), arm, "kinetic friction", way)
            return
        size, acts = instant.held_by_friction(self.name, instant.span(name), (back, forward))
        way, along = f"turning it {(back, forward)[::acts][0]}", unit(against.turned(90 - 90 * acts))
        yield facts.Force(self.name, facts.FRICTION, name, size, along, arm, "friction", way, works=False)
        yield facts.held_still(self.name, name, instant.motion(name))
        if instant.in_balance:
            yield facts.enough(self.name, size, (self.friction or ZERO) * push, "turn")


class Band(Action, frozen=True):
    word = "band"
    about = "a band brake: a band round a drum, pulled at one end and held at the other; T₁ = T₂ e^(μ φ) where the drum turns in it"
    instead = "while it turns one way, a couple against that does the same: `actions: {brake: {couple: -M, on: BODY}}`"
    quantities = ("tension", "torque", "work", "power")
    band: Formula | None = amount("force that pulls at its one end", "force", "F", "nonnegative", required=True)
    on: PointRef | None = key("point", "the rim of the drum", required=True, example="drum.rim")
    friction: Formula | None = amount("coefficient of friction", "number", "mu", "nonnegative", required=True)
    wrap: Formula | None = amount("angle through which it touches the drum", "angle", "phi", "positive", required=True)
    direction: str | None = key(
        "choice",
        "the way round in which that pull draws on the drum: clockwise or counterclockwise",
        choices=("clockwise", "counterclockwise"),
        required=True,
    )

    def on_rims(self, scene: Surroundings) -> tuple[PointRef, ...]:
        return self.touches()

    def check(self, scene: Surroundings) -> None:
        for ref in self.touches():
            check_wheel(ref, "a band brake is solved for a wheel on a fixed axle only", scene)

    def brakes(self) -> tuple[PointRef, ...]:
        return self.touches()

    def twists(self) -> bool:
        return True

    def facts(self, instant: Moment) -> Iterator[Fact]:
        """The torque of both tensions, that at the end which the drum runs towards the smaller: against the turn; as large as it takes
        while it holds the drum."""
        if self.on is None:
            return
        name, pull = instant.host(self.on.owner), self.now(instant)
        mode, sense = instant.mode(f"{self.name}.{name}"), instant.sense(name)
        forward, back = instant.turn_words(name)
        drawn, moving = turn_sense(self.direction, sense), -sense if mode == "turns back" else sense
        other = instant.ask("tension", self.name, when=instant.span(name))
        radius = rim_radius(instant.body(self.on.owner), self.on.point) or ZERO
        growth = call("exp", (self.friction or ZERO) * (self.wrap or ZERO))
        if mode != "holds":
            tight = moving == drawn
            size = (other - pull if tight else pull - other) * radius
            label = "band round the drum, T₁ = T₂ e^(μ φ)"
            yield facts.Summed(self.name, other, pull * growth if tight else pull / growth, label, (name,), EULER)
            way = forward if moving != sense else back
            yield facts.Couple(self.name, facts.BAND, name, facts.signed(size, -moving), "friction torque", size, way)
            return
        size = (pull - other) * radius
        yield facts.Couple(self.name, facts.BAND, name, facts.signed(size, drawn), "torque of the band", size)
        yield facts.held_still(self.name, name, instant.motion(name))
        if instant.in_balance:
            for more, less in ((other, pull), (pull, other)):
                kept, otherwise = "the drum does not turn in the band", "the drum turns in the band"
                yield facts.Requirement(self.name, facts.BINDS, less * growth - more, ZERO, kept, otherwise)


EULER: Words = (
    "Where the band goes on round the drum by dθ, it presses on that with dN = T dθ.",
    NEXT,
    "T grows by the friction μ dN: dT/T = μ dθ. Summed up that is T₁ = T₂ e^(μ φ), with the larger T₁ at the end from which the rim"
    " runs away.",
)


class AppliedPower(Action, frozen=True):
    word = "power"
    about = "a motor of given power turning a body"
    quantities = ("power", "torque", "work")
    power: Formula | None = amount("power; `unknown` asks for it", "power", "P", varies=True, required=True)
    on: PointRef | None = key("point", "the body that it drives", required=True, example="wheel")

    def twists(self) -> bool:
        return True

    def pace(self, configuration: Surroundings, state: str) -> str:
        return combined((pace_of(self.strength()), RATE))  # the couple P/ω depends on the speed

    def facts(self, instant: Moment) -> Iterator[Fact]:
        if self.on is None:
            return
        name, power = instant.host(self.on.owner), self.now(instant)
        sense, words = instant.sense(self.on.owner), instant.turn_words(self.on.owner)
        torque = instant.ask("torque", self.name, when=instant.span(name), words=words)
        yield facts.Couple(self.name, facts.POWERED, name, facts.signed(torque, sense), "torque", torque)
        spin = facts.signed(instant.motion(name).spin, sense)
        if spin != ZERO:  # from rest a constant power means an endless torque at first
            sides = (power, torque * spin)
            yield facts.Rule(self.name, "power of the torque", (name,), sides, sides, linear=False)


def has_arm(on: PointRef, arm: Vector, instant: Moment) -> bool:
    """Whether a point lies beside the centre of its body, or is a rim, so that something can be square to its arm."""
    return bool(arm.parts) or (rim_radius(instant.body(on.owner), on.point) is not None and is_rim(on, instant))


def is_rim(on: PointRef, instant: Moment) -> bool:
    """Whether it is the rim of a round body that a point means."""
    return on.point in (None, "rim") or on.point in rims(instant.body(on.owner))


def across(on: PointRef, arm: Vector, turn: int, instant: Moment) -> tuple[Vector, Vector]:
    """Unit vector square to an arm, along a turn, and where it acts: of a rim on its right."""
    radius = rim_radius(instant.body(on.owner), on.point)
    if is_rim(on, instant) and (radius is not None or not arm.parts):
        return unit(UP if turn > 0 else DOWN), instant.hub(on) + vector(radius or ZERO, RIGHT)
    if len(arm.parts) == 1:
        return unit(arm.parts[0][1]).turned(90 * turn), arm
    return arm.turned(90 * turn).times(ONE / sqrt(arm.dot(arm))), arm


def turn_sense(direction: Direction | None, natural: int) -> int:
    """+1 for a counterclockwise turn, −1 for a clockwise one; the natural one where the direction says neither."""
    return {"clockwise": -1, "counterclockwise": 1}.get(str(direction), natural)
