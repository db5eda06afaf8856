"""Contacts: a body that lies, slides or rolls on a surface with the friction that the scene gives; a roll that lays itself out."""

from __future__ import annotations

from collections.abc import Container, Iterator
from typing import Any

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.facts import FRICTION, REACHES, Couple, Requirement, Rule, enough, held_still, signed
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.heading import Vector
from rotsolve.core.writing import spoken
from rotsolve.elements.connections.lying import is_level
from rotsolve.elements.connections.supports import Rides
from rotsolve.elements.connections.touch import Touch
from rotsolve.elements.shapes import rim_radius, shape_of, touching_radius
from rotsolve.language.bodies import Body, Joint, PointRef, Surface
from rotsolve.language.elements import Connection, Fact, LetterMaker, Moment, SceneElements, Surroundings
from rotsolve.language.friction import Friction
from rotsolve.language.keys import amount, key


def inner_side() -> Any:
    """The key of the side of a round body on which something lies."""
    words = "of what lies on a round body: whether it is inside that, as in a drum, and not on it"
    return key("flag", words, default=None, plane=True)


class Contact(Touch, frozen=True):
    word = "contact"
    side_by_side = True
    about = "a body lies on, slides along, leans on or rolls on a surface or another body; or a wheel rubs on another, both on fixed axles"
    contact: tuple[PointRef, ...] = key(
        "points", "[body, surface, …]", count=(2, 10), required=True, example="[block, ramp]"
    )
    friction: Friction = key(
        "friction",
        "`none`, a coefficient, {static: , kinetic: }, or `any`",
        default=Friction(),
        letter="mu",
        limits="nonnegative",
    )
    press: Formula | None = amount(
        "force that presses two wheels together at their rims", "force", "F", "positive", default=None, plane=True
    )

    inside: bool | None = inner_side()

    spatial = True
    quantities = (*Touch.quantities, "freedoms")

    def joint_in_space(self) -> Joint:
        """Without friction, which is refused by name."""
        if self.friction != Friction():
            help = "leave out `friction`, or say `rolls`"
            raise Unsolvable(f"friction of `{self.name}` is not solved in space", span=self.contact[0].span, help=help)
        return Joint(self.name, self.contact[1], self.contact[0], flat=True)

    def grip(self) -> Friction:
        return self.friction

    def on_inside(self) -> bool | None:
        return self.inside

    @property
    def pressed(self) -> bool:
        return self.press is not None

    def check(self, scene: Surroundings) -> None:
        under = self.contact[1]
        if self.press is not None and under.owner not in scene.bodies:
            help = "a force that presses a body on a surface stands among the actions"
            raise Unsolvable(f"`press` of `{self.name}` is for two wheels", span=under.span, help=help)
        self.check_holds(scene)
        super().check(scene)

    def check_holds(self, scene: Surroundings) -> None:
        """Nothing is said to stick or to roll at a state by what has no friction."""
        for line in (line for state in scene.problem.states for line in state.conditions):
            own = line.path is not None and line.path.owner == self.name
            if own and line.word in ("sticks", "rolls") and self.friction.kind == "none":
                help = f"give it its `friction`, or tell the speed of `{self.contact[0].owner}` at that state"
                raise Unsolvable(f"`{self.name}` has no friction: nothing {line.word} there", span=line.span, help=help)

    def seen(self, scene: SceneElements, level: Container[str]) -> Connection:
        """From above what lies on a level table rubs over its whole face, and a particle on what turns goes round with it."""
        own, under = self.contact[0].owner, self.contact[1].owner
        if any(body.name == own and shape_of(body).slender for body in scene.bodies) and under not in level:
            from rotsolve.elements.connections.leaning import leaning

            leans = leaning(self, self.friction, scene) if self.press is None else None
            if leans is not None:
                return leans
        if scene.plane != "horizontal" or self.friction.kind == "none" or len(self.contact) > 2:
            return super().seen(scene, level)
        bodies = {body.name: body for body in scene.bodies}
        if own in bodies and under in bodies and shape_of(bodies[own]).pointlike and self.press is None:
            held = {ref.owner for item in scene.connections for ref in item.fixed_points()}
            return Rides(self.name, self.contact, self.friction) if under in held and own not in held else self
        if under not in level or self.friction.kind == "any":
            return self
        from rotsolve.elements.connections.flat import Laid

        others = (ref.owner for item in scene.connections if item is not self for ref in item.touches())
        return Laid(self.name, self.contact, self.friction, own not in others)

    def completed(self, letters: LetterMaker, held: Container[str]) -> Connection:
        """Between two wheels on fixed axles it is their rims that rub."""
        if self.contact[1].owner not in held or (self.contact[0].owner not in held and self.press is None):
            return self
        if len(self.contact) > 2:
            message = f"two wheels rub on each other in a contact, and `{self.name}` names {len(self.contact)} bodies"
            raise Unsolvable(message, span=self.contact[2].span, help="write a contact for each two that touch")
        from rotsolve.elements.connections.rubbing import Rims

        return Rims(self.name, self.contact, self.press or letters.make("F", self.name, "force"), self.friction)


class Rolls(Touch, frozen=True):
    word = "rolls"
    about = "a wheel rolls without slipping on a surface, on several that join smoothly, or on another body"
    rolls: tuple[PointRef, ...] = key(
        "points", "[wheel, surface, …]", count=(2, 10), required=True, example="[ball, floor]"
    )
    rolling_friction: Formula | None = amount(
        "how far ahead of the middle the ground presses on what rolls: a couple of that times the normal force, against the turn",
        "length",
        "b",
        "nonnegative",
        default=None,
        plane=True,
    )
    inside: bool | None = inner_side()

    spatial = True

    def on_inside(self) -> bool | None:
        return self.inside

    def brakes(self) -> tuple[PointRef, ...]:
        return self.rolls[:1] if self.rolling_friction is not None else ()

    def facts(self, instant: Moment) -> Iterator[Fact]:
        yield from super().facts(instant)
        if self.rolling_friction is not None:
            yield from self.resistance(self.rolling_friction, instant)

    def resistance(self, ahead: Formula, instant: Moment) -> Iterator[Fact]:
        """The couple b N against the turn; as large as it takes while it holds the wheel still."""
        name = instant.host(self.rolls[0].owner)
        sense, mode, span = instant.sense(name), instant.mode(f"{self.name}.{name}"), instant.span(name)
        forward, back = instant.turn_words(name)
        most = ahead * instant.ask("normal_force", self.name, when=span)
        if mode == "holds":
            size = instant.ask("torque", self.name, when=span, words=(forward, back))
            yield Couple(self.name, FRICTION, name, signed(size, sense), "rolling resistance", size)
            yield held_still(self.name, name, instant.motion(name))
            if instant.in_balance:
                yield enough(self.name, size, most, "roll")
            return
        turn, against = (sense, forward) if mode == "turns back" else (-sense, back)
        yield Couple(self.name, FRICTION, name, signed(most, turn), "rolling resistance", most, against)

    def check(self, scene: Surroundings) -> None:
        """What rolls is round where it touches."""
        surface = scene.surfaces.get(self.rolls[1].owner)
        if self.rolling_friction is not None and (surface is None or surface.curved or len(self.rolls) > 2):
            message = f"`rolling_friction` of `{self.name}` is solved on one flat surface only"
            raise Unsolvable(message, span=self.rolls[1].span, help="leave it out")
        wheel, body = self.rolls[0], scene.bodies.get(self.rolls[0].owner)
        is_round = body is None or "rim" in shape_of(body).points or touching_radius(body, wheel.point) is not None
        if not (scene.problem.space or is_round):
            message = f"`{wheel.owner}` is not round where it touches, and does not roll"
            help = (
                "give it a round shape, a `radius` or `radii`, half a disc by its `r` and `phi`, half a ball as a `hemisphere`; "
                "what lies on a side or a corner has a `contact`"
            )
            raise Unsolvable(message, span=wheel.span, help=help)
        super().check(scene)

    def turned(self) -> tuple[str, ...]:
        return (self.rolls[0].owner,)

    def joint_in_space(self) -> Joint:
        return Joint(self.name, self.rolls[1], self.rolls[0], rolls=True)


class Unrolls(Touch, frozen=True):
    word = "unrolls"
    about = "a roll, of a carpet say, lays itself out on a level surface; a state says how large its `radius` is still"
    quantities = ("force", "normal_force", "friction_force", "torque")
    words = ()
    unrolls: tuple[PointRef, ...] = key(
        "points", "[roll, surface]", count=(2, 2), required=True, example="[carpet, floor]"
    )

    def check(self, scene: Surroundings) -> None:
        """A uniform roll on a level surface, that nothing else touches."""
        roll, floor = self.unrolls
        body = scene.bodies[roll.owner]
        if not shape_of(body).wound or body.parts or body.holes or body.inertia or body.gyration or body.count > 1:
            help = "give it `shape: cylinder`, a mass and a radius"
            raise Unsolvable(f"`{roll.owner}` is no roll of a thin sheet", span=roll.span, help=help)
        if not is_level(floor.owner, scene):
            message = "a carpet that unrolls down a slope is not solved yet"
            raise Unsolvable(message, span=floor.span, help="solved is a level floor")
        for other in (*scene.problem.connections, *scene.problem.actions):
            for ref in other.touches() if other is not self else ():
                if ref.owner == roll.owner:
                    raise Unsolvable(
                        f"what else acts on `{roll.owner}`, which unrolls, is not solved yet", span=ref.span
                    )

    def turned(self) -> tuple[str, ...]:
        return tuple(ref.owner for ref in self.unrolls)

    def lays(self, body: Body) -> bool:
        return self.unrolls[0].owner == body.name

    def pace(self, configuration: Surroundings, state: str) -> str:
        return "position"

    def friction_facts(
        self, instant: Moment, name: str, arm: Vector, surface: Surface, normal: Formula
    ) -> Iterator[Fact]:
        """As of a wheel that rolls, with v = r ω at any moment; for accelerations there is no such rule, since r changes."""
        for fact in super().friction_facts(instant, name, arm, surface, normal):
            yield replace(fact, acceleration=None, linear=False) if isinstance(fact, Rule) else fact
        radii = [rim_radius(body, None) for body in (instant.configuration.bodies[name], instant.body(name))]
        if radii[0] is not None and radii[1] is not None and radii[0] != radii[1]:
            otherwise = f"{spoken(name)} would have to roll itself up"
            yield Requirement(self.name, REACHES, radii[0] - radii[1], ZERO, f"{spoken(name)} unrolls", otherwise)
