"""Touch: a body on a surface or on another body: where they touch, the push of the one on the other, and friction between them."""

from __future__ import annotations

from collections.abc import Container, Iterator
from typing import Any, ClassVar

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula, add, negate
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.facts import FRICTION, LIES, LOAD, NORMAL, ROCKS, TOUCHES, Force, Requirement, Rule, enough, square
from rotsolve.core.faults import Unsolvable
from rotsolve.core.limits import Limit
from rotsolve.core.symbols import has_quantities
from rotsolve.core.vectors.heading import (
    NOWHERE,
    RIGHT,
    TURNS,
    UP,
    Heading,
    Vector,
    along_text,
    heading,
    opposite,
    unit,
    vector,
)
from rotsolve.core.writing import spoken
from rotsolve.elements.connections.lying import (
    check_laid_on,
    check_led_along,
    check_on_one_track,
    check_side_by_side,
    supporting,
)
from rotsolve.elements.connections.sides import check_carrier, check_side_of, goes_aside, place_on_side, round_rules
from rotsolve.elements.shapes import bow_of, rim_radius, rims, rolling_part, shape_of, touching_radius
from rotsolve.elements.surfaces import Curved, Level
from rotsolve.language.bodies import Body, Orbit, PointRef, Surface
from rotsolve.language.elements import Connection, Fact, Moment, PlaceOf, SceneElements, Surroundings
from rotsolve.language.friction import Friction


class Touch(Connection, frozen=True):
    """Base of contacts: a normal force, friction that sticks or slips, and the rule that goes with it."""

    quantities: ClassVar[tuple[str, ...]] = (
        "displacement", "velocity", "acceleration", "force", "normal_force", "friction_force", "friction", "torque", "angle",
        "work", "power", "impulse",
    )  # fmt: skip
    words: ClassVar[tuple[str, ...]] = ("rolls", "slips", "leaves", "sticks")
    lays_first: ClassVar[bool] = True
    leaning: ClassVar[bool] = False  # whether a rod leans there with its side, which alone tells which way it is pushed
    side_by_side: ClassVar[bool] = False  # whether it may be that of two wheels on axles of their own

    side: Surface | None = None  # the surface that the scene declares `of` the body named last: a side of that

    def pair(self) -> tuple[PointRef, ...]:
        """The body's point and the surface, or the surfaces that join smoothly: what stands under the key of its word."""
        return self.touches()

    def seen(self, scene: SceneElements, level: Container[str]) -> Connection:
        """A surface `of` a body is that body, touched at a side of its own."""
        own, under = self.pair()[:2]
        side = next((one for one in scene.surfaces if one.name == under.owner and one.bearer()), None)
        if side is None or len(self.pair()) > 2:
            return self
        changes: dict[str, Any] = {self.word: (own, replace(under, owner=side.bearer())), "side": side}
        return replace(self, **changes)

    def on_rims(self, scene: Surroundings) -> tuple[PointRef, ...]:
        return self.pair()[:1]

    def grip(self) -> Friction:
        """Rough enough for whatever it takes, where nothing else is said."""
        return Friction("any")

    def holds_whatever_it_takes(self) -> bool:
        return self.grip().kind == "any"

    def lying(self) -> str:
        return self.pair()[0].owner

    def places(self) -> tuple[PointRef, ...]:
        return self.pair()[1:]

    def carrier(self, configuration: Surroundings) -> str:
        ref = self.places()[0]
        return ref.owner if ref.owner in configuration.bodies else ""

    def check(self, scene: Surroundings) -> None:
        """A body on a surface or on a body that travels, or two wheels side by side."""
        ref, under = self.pair()[:2]
        carrier = scene.bodies.get(under.owner)
        if self.side is not None:
            check_side_of(self, self.side, scene)
        elif carrier is not None and (ref.owner in scene.held or self.pressed):
            check_side_by_side(self, self.pressed, self.side_by_side, scene)
        elif carrier is not None:
            from rotsolve.elements.connections.borne import check_on_top

            if not check_on_top(self, scene):
                check_carrier(self, scene)
        self.check_side(scene)
        check_laid_on(self, scene)
        self.check_places(scene)
        check_led_along(self, self.rests, scene)

    def check_side(self, scene: Surroundings) -> None:
        """What touches is a rim, a point that is named, or a body with corners: what is bent otherwise would rock."""
        ref, body = self.pair()[0], scene.bodies.get(self.lying())
        bent = body is not None and body.shape is not None and not body.shape.pointlike and not body.shape.outline()
        if scene.problem.space or body is None or not bent or touching_radius(body, ref.point) is not None:
            return
        if ref.point in (None, "center", "cm") and "rim" not in shape_of(body).points:
            message = f"on which side `{body.name}` touches `{self.pair()[1].owner}` nothing tells: it is neither round nor has corners"
            raise Unsolvable(message, span=ref.span, help="such bodies, which rock, are not solved yet")

    @property
    def pressed(self) -> bool:
        """Whether a force of its own presses it together."""
        return False

    def check_places(self, scene: Surroundings) -> None:
        """Of surfaces that join, a track of unknown profile leads into a curved one; a curved one takes what fits it."""
        places = [scene.surfaces[ref.owner] for ref in self.places() if ref.owner in scene.surfaces]
        unknown = [isinstance(place, Curved) and place.radius() is None for place in places]
        curved = all(place.curved for place in places)
        carrier = next((ref for ref in self.places() if ref.owner in scene.bodies), None)
        if carrier is not None and len(self.places()) > 1 and carrier.owner not in scene.held:
            message = (
                f"`{self.name}` names a body, `{carrier.owner}`, beside other things on which `{self.lying()}` lies"
            )
            raise Unsolvable(message, span=carrier.span, help="write a contact for each two that touch")
        if len(places) > 1 and not (curved and len(places) == 2 and unknown == [True, False]):
            message = f"these surfaces of `{self.name}` together are not solved yet"
            help = "solved is a track of `profile unknown` that leads into a `hollow` or `dome`"
            raise Unsolvable(message, span=self.pair()[1].span, help=help)
        for place in places:
            if isinstance(place, Curved):
                self.check_curved(place, scene)
        if any(unknown):
            check_on_one_track(self, scene)

    def check_curved(self, surface: Curved, scene: Surroundings) -> None:
        """Round bodies and particles, rolling or without friction, that fit the surface and that nothing else holds."""
        ref = self.pair()[0]
        body = scene.bodies.get(ref.owner)
        if body is None:
            return
        if self.rubs():
            help = "write `friction: none`, or `any` where it is rough enough"
            message = "a coefficient of friction on a curved surface is not solved yet"
            raise Unsolvable(message, span=ref.span, help=help)
        if body.moved:
            message = f"a given motion of `{body.name}` on `{surface.name}` is not solved yet"
            raise Unsolvable(message, span=ref.span, help="solved are forces and couples on it")
        rim, edge = rim_radius(body, ref.point), surface.height() is not None
        fits = rim is not None or (shape_of(body).pointlike and not edge)
        if not fits or body.parts or body.holes:
            help = "solved are uniform round bodies" + ("" if edge else ", and particles")
            raise Unsolvable(f"`{body.name}` on `{surface.name}` is not solved yet", span=ref.span, help=help)
        if surface.two_sided:
            self.check_threaded(surface, scene)
        for other in self.held_besides(scene):
            message = f"`{other}` on a body that is on `{surface.name}` is not solved yet"
            raise Unsolvable(message, span=ref.span, help="solved are forces and couples on it")

    def check_threaded(self, surface: Curved, scene: Surroundings) -> None:
        """A wire goes through a particle, which does not come off it."""
        ref = self.pair()[0]
        if not shape_of(scene.bodies[ref.owner]).pointlike:
            help = "leave out its `shape`; what rolls lies in a `hollow` or on a `dome`"
            raise Unsolvable(
                f"`{ref.owner}` is threaded on `{surface.name}`, and is no particle", span=ref.span, help=help
            )
        for line in (line for state in scene.problem.states for line in state.conditions if line.word == "leaves"):
            if line.path is not None and line.path.owner == self.name:
                message = f"`{ref.owner}` is threaded on `{surface.name}`, and does not leave it"
                raise Unsolvable(message, span=line.span, help="ask for the place where `normal_force` is 0")

    def rooms(self, scene: Surroundings) -> Iterator[Limit]:
        """A wheel fits into the bowl and is larger than the step; and what its friction asks."""
        yield from self.grip().rooms(self.name)
        ref, body = self.pair()[0], scene.bodies.get(self.lying())
        rim = rim_radius(body, ref.point) if body is not None else None
        if self.pair()[1].owner in scene.bodies:
            from rotsolve.elements.connections.borne import room_at_rim

            yield from room_at_rim(self, rim or ZERO, scene)
        surfaces = [scene.surfaces[place.owner] for place in self.places() if place.owner in scene.surfaces]
        surfaces += [self.side] if self.side is not None else []
        for surface in surfaces if rim is not None else ():
            if isinstance(surface, Curved):
                yield from surface.rooms(self.lying(), rim or ZERO, self.on_flat(scene))

    def held_besides(self, scene: Surroundings) -> Iterator[str]:
        """Strings, springs and the like on the body, and events that join it to another; not while it is on the floor."""
        name, events = self.lying(), scene.problem.events
        if self.on_flat(scene) and not any(self.name in event.begins() for event in events):
            return
        for item in scene.problem.connections:
            if not item.lying() and any(ref.owner == name for ref in item.touches()):
                yield item.name
        for event in events:
            if any(ref.owner == name for ref in event.joined()):
                yield event.name

    def on_flat(self, scene: Surroundings) -> bool:
        """Whether the body touches a floor, slope or wall too."""
        curved = {name for name, surface in scene.surfaces.items() if surface.curved}
        touched = (item for item in scene.problem.connections if item.lying() == self.lying())
        return any(ref.owner not in curved for item in touched for ref in item.places())

    def surface(self, configuration: Surroundings, state: str) -> Surface | None:
        """The surface on which the body is: of several the curved one where the state speaks of the contact's angle; the back of
        another body lies as that on which it travels."""
        carrier = self.carrier(configuration)
        if self.side is not None:
            return self.side
        if carrier:
            from rotsolve.elements.connections.borne import rim_gone_round

            if (rim := rim_gone_round(self, configuration.bodies)) is not None:
                return rim
            below = supporting(carrier, configuration, state)
            return replace(below, name=carrier) if below is not None else Level(carrier)
        found = [surface for ref in self.places() if (surface := configuration.surfaces.get(ref.owner)) is not None]
        bent = [surface for surface in found if isinstance(surface, Curved) and surface.radius() is not None]
        if len(found) > 1 and bent and configuration.mentions.says(state, self.name, "angle", "leaves"):
            return bent[0]
        return found[0] if found else None

    def rests(self, body: Body) -> bool:
        """Whether a body lies or rolls on the surface; one that leans on it with an end does not."""
        ref = self.pair()[0]
        if ref.owner != body.name:
            return False
        return ref.point in (None, "bottom", "rim", "center", *rims(body)) or rolling_part(body, ref.point) is not None

    def track(self, body: Body, configuration: Surroundings, state: str) -> tuple[Heading, str] | None:
        """A body that lies or rolls on a flat surface travels along it, unless that is taken another way."""
        surface = self.surface(configuration, state) if self.rests(body) else None
        if surface is None or isinstance(surface, Curved) or goes_aside(self, configuration, state):
            return None
        return surface.travel(body.moves)

    def orbit(self, body: Body, configuration: Surroundings, state: str) -> Orbit | None:
        """On a curved surface the centre of a body moves on a circle; a particle is its own centre."""
        surface = self.surface(configuration, state)
        if not isinstance(surface, Curved) or not self.rests(body) or self.side is not None:
            return None
        if self.travels(configuration, state):
            return None
        radius = surface.circle(rim_radius(body, self.pair()[0].point) or ZERO)
        way, level = surface.way(body.moves), ZERO if radius is None else surface.base(radius)
        turn = "forward along" if radius is None else "counterclockwise round" if way > 0 else "clockwise round"
        hollow = not (surface.outside or surface.two_sided)
        return Orbit(self.name, radius, level, way, f"{turn} the {spoken(surface.name)}", hollow)

    def travels(self, configuration: Surroundings, state: str) -> bool:
        """Whether a round body on which something lies travels, and does not only turn on a fixed axle."""
        carrier = self.carrier(configuration)
        return bool(carrier) and not configuration.pinned(carrier, state)

    def on_inside(self) -> bool | None:
        """Whether it lies inside a round body; None where nothing tells."""
        return None

    def touching_angle(self, instant: Moment) -> Formula:
        """For a wheel on the floor the place of a corner settles it."""
        ref, surface = self.pair()[0], self.surface(instant.configuration, instant.state)
        rim = rim_radius(instant.body(ref.owner), ref.point)
        if isinstance(surface, Curved) and rim is not None and instant.orbit(ref.owner) is None:
            met = surface.met(rim)
            if met is not None:
                return met
        return instant.ask("angle", self.name, words=TURNS)

    def normal(self, surface: Surface, instant: Moment) -> Heading:
        """Direction out of the surface where the body touches it."""
        return surface.facing(heading(self.touching_angle(instant))) if isinstance(surface, Curved) else surface.normal

    def natural_turn(self, body: Body, configuration: Surroundings, state: str) -> int:
        """Rolling: v + ω × r = 0 at the contact, so travel with the surface on its right turns a wheel clockwise."""
        track, surface = self.track(body, configuration, state), self.surface(configuration, state)
        orbit = self.orbit(body, configuration, state)
        if isinstance(surface, Curved) and (orbit is not None or (self.side is not None and self.rests(body))):
            way = surface.way(None) if orbit is None else orbit.way
            return way if surface.outside else -way
        if self.side is not None and track is None and self.rests(body) and not self.side.curved:
            track = self.side.travel("down")
        if track is None or surface is None:
            return 0
        return -1 if (surface.normal - track[0]).degrees % 360 == 90 else 1

    def pace(self, configuration: Surroundings, state: str) -> str:
        body = configuration.bodies[self.lying()]
        lies = self.side is not None and not self.side.curved and self.rests(body)
        return "constant" if lies or self.track(body, configuration, state) else "position"

    def facts(self, instant: Moment) -> Iterator[Fact]:
        """The normal force, the rule that the body stays on the surface where its motion does not say so, and friction."""
        ref, surface = self.pair()[0], self.surface(instant.configuration, instant.state)
        name = instant.host(ref.owner)
        if surface is None:
            return
        facing = self.normal(surface, instant)
        self.check_abreast(surface, instant)
        arm, span = contact_arm(ref, facing, instant), instant.span(name)
        ways = (surface.away, surface.into) if surface.two_sided else ("", "")
        normal = instant.ask("normal_force", self.name, when=span, words=ways)
        if isinstance(surface, Curved) and surface.radius() is None:  # a push that no law tells
            yield from self.friction_facts(instant, name, arm, surface, normal)
            return
        push, way = unit(facing), surface.away or f"away from the {surface.word}"
        force = Force(self.name, NORMAL, name, normal, push, arm, "normal force", way, works=False, internal=True)
        yield from self.both(force, instant, "push", surface.into, ref.owner)
        lying = spoken(ref.owner)
        kept, otherwise = f"{lying} stays on the {spoken(surface.name)}", f"{lying} leaves the surface"
        if not surface.two_sided:
            yield Requirement(self.name, TOUCHES, normal, ZERO, kept, otherwise)
        if not surface.curved:
            yield from self.lies_in_front(facing, instant)
            yield from self.on_its_bow(facing, instant)
        if self.course(instant) is None:
            label = f"{spoken(name)} stays on the {spoken(surface.name)}{self.told_apart(instant)}"
            body = instant.body(ref.owner)
            point = arm if touching_radius(body, ref.point) is None else instant.hub(ref)
            stays = self.no_slip(label, point, facing, instant, linear=self.keeps_flat(instant))
            if isinstance(self.side, Curved):
                yield from round_rules(self, stays, self.side, instant)
            elif isinstance(surface, Curved):
                from rotsolve.elements.connections.borne import round_a_centre

                yield round_a_centre(stays, self, surface, instant)
            else:
                yield stays
        yield from self.friction_facts(instant, name, arm, surface, normal)

    def keeps_flat(self, instant: Moment) -> bool:
        """Whether it lies all the way on a flat side of a body that goes another way: what holds of rates there holds of ways."""
        lies = self.side is not None and not self.side.curved
        return lies and self.rests(instant.body(self.lying())) and instant.motion(self.lying()).kind == "plane"

    def slides_down(self, instant: Moment) -> Heading | None:
        return self.side.travel("down")[0] if self.side is not None and self.keeps_flat(instant) else None

    def told_apart(self, instant: Moment) -> str:
        """ " at left support" of one of several contacts that a body has, or had, with the same thing; '' of the only one."""
        own = self.lying(), self.pair()[1].owner
        alike = (one for one in instant.configuration.problem.connections if isinstance(one, Touch) and one is not self)
        return f" at {spoken(self.name)}" if any((one.lying(), one.pair()[1].owner) == own for one in alike) else ""

    def lies_in_front(self, facing: Heading, instant: Moment) -> Iterator[Requirement]:
        """The body's centre of mass lies on the free side of a flat surface: (r_cm − r_touch) · n ≥ 0, else all that touches with an end or
        a corner would lie in it; nothing of what is sure, as of a wheel on its rim."""
        own, place = self.pair()[:2]
        body = instant.body(own.owner)
        if instant.is_round(own.owner) or body.shape is None or bow_of(body, own.point) is not None:
            return
        ahead = simplify((instant.point(PointRef(own.owner, "cm")) - contact_arm(own, facing, instant)).along(facing))
        if instant.configuration.signs.sign(ahead) not in (0, 1):
            yield Requirement(self.name, LIES, ahead, ZERO, "", f"{spoken(own.owner)} lies in {spoken(place.owner)}")

    def on_its_bow(self, facing: Heading, instant: Moment) -> Iterator[Requirement]:
        """What is round on one side only touches with that: the way down is within half its opening of the middle of its bow."""
        ref = self.pair()[0]
        bow = bow_of(instant.body(ref.owner), ref.point)
        if bow is not None:
            middle = instant.pointing(ref.owner, heading(simplify((bow.first + bow.last) / 2)))
            ahead, least = middle.along(facing.turned(180)), heading(simplify((bow.last - bow.first) / 2)).cos()
            otherwise = f"{spoken(ref.owner)} touches with an end of its round side"
            yield Requirement(self.name, ROCKS, simplify(ahead), least, "", otherwise)

    def check_abreast(self, surface: Surface, instant: Moment) -> None:
        """All corners with which a body stands on a flat surface lie on it: a crate on a slope stands along that, not level."""
        ref, place = self.pair()[:2]
        if isinstance(surface, Curved) or instant.is_round(ref.owner):
            return
        for other in instant.configuration.connections(instant.state):
            if other.lying() != ref.owner or other is self or place.owner not in {at.owner for at in other.places()}:
                continue
            across = instant.point(other.touches()[0]) - instant.point(ref)
            gap = simplify(across.along(surface.normal))
            if gap != ZERO and not has_quantities(gap) and instant.configuration.signs.sign(gap) != 0:
                lean = to_text((surface.normal - UP).formula())
                message = (
                    f"as `{ref.owner}` stands, `{self.name}` and `{other.name}` do not both lie on `{surface.name}`"
                )
                help = f"tell how it stands in the state: `{ref.owner}.angle: {lean}`, if it stands along it"
                raise Unsolvable(message, span=ref.span, help=help)

    def away(self, instant: Moment) -> Heading | None:
        surface = self.surface(instant.configuration, instant.state)
        return None if surface is None else self.normal(surface, instant)

    def touching_arm(self, instant: Moment) -> Vector:
        surface = self.surface(instant.configuration, instant.state)
        return NOWHERE if surface is None else contact_arm(self.pair()[0], self.normal(surface, instant), instant)

    def course(self, instant: Moment) -> Heading | None:
        """The body's line of travel where that runs along this surface."""
        surface = self.surface(instant.configuration, instant.state)
        ahead = instant.motion(self.pair()[0].owner).heading
        along = surface is not None and ahead is not None and (ahead - self.normal(surface, instant)).cos() == ZERO
        return ahead if along else None

    def forward(self, instant: Moment) -> Heading:
        """The way along the surface that counts as positive: that of the body's travel, else with the surface on its right."""
        surface = self.surface(instant.configuration, instant.state)
        ahead = self.course(instant) or self.slides_down(instant)
        return ahead or (RIGHT if surface is None else self.normal(surface, instant).turned(-90))

    def ways_along(self, instant: Moment, name: str) -> tuple[str, str]:
        """Words for the way along the surface that counts as positive, and for the other way."""
        if self.side is not None and self.slides_down(instant) is not None:
            return self.side.travel("down")[1], self.side.travel("up")[1]
        return travel_words(self.forward(instant), self.course(instant), instant, name)

    def rubs(self) -> bool:
        return self.grip().kind == "coefficient"

    def grips(self) -> bool:
        return self.grip().kind != "none"

    def static(self) -> Formula | None:
        return self.grip().static

    def slider(self) -> PointRef:
        return self.pair()[0]

    def slip(self, instant: Moment, *, acceleration: bool = False) -> Formula | None:
        """Of the touching point on what the body lies on, where that travels along a line."""
        motion, ground, forward = instant.motion(self.lying()), self.ground(instant), self.forward(instant)
        arm = self.touching_arm(instant)
        if self.leans_freely(instant) or self.keeps_flat(instant):
            rate = motion.acceleration_of(arm) - ground[1] if acceleration else motion.velocity_of(arm) - ground[0]
            return rate.along(forward)
        if motion.heading is None:
            return None
        if acceleration:  # what turns it about its centre is across the surface
            turning = arm.turned(90).times(motion.spin_rate)
            return (motion.acceleration + turning - ground[1]).along(forward)
        return (motion.velocity_of(arm) - ground[0]).along(forward)

    def leans_freely(self, instant: Moment) -> bool:
        """Whether a body leans on the surface with an end, and is free to turn about that."""
        surface = self.surface(instant.configuration, instant.state)
        plane = instant.motion(self.lying()).kind == "plane" and surface is not None and not surface.curved
        return plane and not self.rests(instant.body(self.lying()))

    def drift(self, instant: Moment) -> Formula | None:
        motion = instant.motion(self.lying())
        if self.leans_freely(instant):
            return self.slip(instant)
        if (down := self.slides_down(instant)) is not None:
            return (motion.velocity - self.ground(instant)[0]).along(down)
        return None if motion.heading is None else (motion.velocity - self.ground(instant)[0]).along(motion.heading)

    def place(self, name: str, way: Heading, instant: Moment, place_of: PlaceOf) -> Formula | None:
        """Across a flat surface, of the body that touches it; on another body, from where that is."""
        surface = self.surface(instant.configuration, instant.state)
        if surface is None or instant.host(self.lying()) != name:
            return None
        if isinstance(self.side, Curved):
            return place_on_side(self, self.side, way, instant, place_of)
        if isinstance(surface, Curved):
            from rotsolve.elements.connections.borne import place_round

            return place_round(self, surface, way, instant, place_of)
        if (surface.normal - way).sin() != ZERO:
            return None
        carrier = self.carrier(instant.configuration)
        base = place_of(PointRef(carrier, "cm")) if carrier else ZERO
        return None if base is None else base - self.touching_arm(instant).along(way)

    def ground(self, instant: Moment) -> tuple[Vector, Vector]:
        """Velocity and acceleration of what it lies on, where they touch."""
        carrier = self.carrier(instant.configuration)
        if not carrier:
            return NOWHERE, NOWHERE
        motion, arm = instant.motion(carrier), self.underneath(instant)
        return motion.velocity_of(arm), motion.acceleration_of(arm)

    def underneath(self, instant: Moment) -> Vector:
        """From the reference of the body that carries it to where they touch: on the rim of a roller, else on a back that does not turn."""
        surface, under = self.surface(instant.configuration, instant.state), self.places()[0]
        if surface is None or self.side is not None:
            return NOWHERE
        facing = self.normal(surface, instant)
        if isinstance(surface, Curved):
            from rotsolve.elements.connections.borne import arm_of_rim

            return arm_of_rim(under, surface, facing, instant)
        return contact_arm(under, facing.turned(180), instant)

    def grip_rule(self, instant: Moment) -> Rule | None:
        """No slip at this moment, for a state that says `rolls` or `sticks`."""
        ref, surface = self.pair()[0], self.surface(instant.configuration, instant.state)
        if surface is None:
            return None
        name, arm = instant.host(ref.owner), self.touching_arm(instant)
        label = f"{spoken(name)} no longer slips"
        return self.no_slip(label, arm, self.forward(instant), instant, linear=False)

    def no_slip(self, label: str, arm: Vector, direction: Heading, instant: Moment, *, linear: bool) -> Rule:
        """The touching point does not move along a direction on what it touches: travel of the centre on the left."""
        name, carrier = instant.host(self.lying()), self.carrier(instant.configuration)
        motion = instant.motion(name)
        turned, inward = arm.turned(90), arm.turned(180).times(square(motion.spin))
        turning = turned.times(motion.spin), turned.times(motion.spin_rate) + inward
        left = motion.velocity.along(direction), motion.acceleration.along(direction)
        # the centripetal part of a rolling wheel's contact point is along the normal: a rule along the surface has none
        right = tuple(
            add(moving.along(direction), negate(part.along(direction)))
            for part, moving in zip(turning, self.ground(instant), strict=True)
        )
        bodies = (name, instant.host(carrier)) if carrier else (name,)
        still = motion.spin == ZERO and not linear and arm.parts
        remark = ("at rest: no centripetal part",) if still else ()
        return Rule(self.name, label, bodies, (left[0], right[0]), (left[1], right[1]), linear, remark)

    def friction_facts(
        self, instant: Moment, name: str, arm: Vector, surface: Surface, normal: Formula
    ) -> Iterator[Fact]:
        """Friction: none; sticking (a force as large as it takes, and no slip); or slipping (μ N against the slip)."""
        grip, mode, motion = self.grip(), instant.mode(self.name), instant.motion(name)
        if grip.kind == "none":
            return
        forward = self.forward(instant)
        ahead, back = self.ways_along(instant, name)
        span = instant.span(name)
        if mode.startswith("slips"):
            backward = mode.startswith("slips back")
            size = ((grip.static if mode.endswith("at most") else grip.kinetic) or ZERO) * normal
            way = forward if backward else forward.turned(180)
            ways = (ahead, back) if backward else (back, ahead)
            force = Force(self.name, FRICTION, name, size, unit(way), arm, "kinetic friction", ways[0])
            yield from self.both(force, instant, force.noun, ways[1], name)
            return
        size, sense = instant.held_by_friction(self.name, span, (back, ahead))
        acts, reacts = (back, ahead)[::sense]
        along = unit(forward.turned(90 + 90 * sense))
        force = Force(self.name, FRICTION, name, size, along, arm, "friction", acts, works=False, internal=True)
        yield from self.both(force, instant, force.noun, reacts, name)
        rolling = motion.turns and touching_radius(instant.body(self.lying()), self.pair()[0].point) is not None
        label = f"{spoken(name)} rolls without slipping" if rolling else f"{spoken(name)} does not slip"
        flat = motion.kind == "line" or self.keeps_flat(instant)
        yield self.no_slip(label, arm, forward, instant, linear=flat)
        if grip.static is not None:
            yield enough(self.name, size, grip.static * normal, "slip")

    def both(self, force: Force, instant: Moment, noun: str, way: str, of: str) -> Iterator[Force]:
        """A force on the body, and that by which it acts back on the body that carries it."""
        yield replace(force, part=self.lying())
        carrier = self.carrier(instant.configuration)
        if carrier:
            host, back, place = instant.host(carrier), -force.direction, f"of {spoken(of)}"
            back_on = replace(
                force, role=LOAD if force.role == NORMAL else force.role, body=host, direction=back, part=carrier
            )
            yield replace(back_on, arm=self.underneath(instant), noun=noun, way=way, place=place)


def travel_words(forward: Heading, path: Heading | None, instant: Moment, name: str) -> tuple[str, str]:
    """Words for the way along a surface that counts as positive, and for the other way; `path` is that of the body's travel."""
    if path is None or forward != path:
        words = along_text(forward) or "along the surface"
    else:
        line = instant.line(name)
        words = line[1] if line else along_text(forward)
    return words, opposite(words)


def contact_arm(ref: PointRef, facing: Heading, instant: Moment) -> Vector:
    """From the body's reference to where it touches: a wheel's rim towards the surface, a named point, or the body itself."""
    body = instant.body(ref.owner)
    radius = touching_radius(body, ref.point)
    if radius is not None:
        return instant.hub(ref) + vector(radius, facing.turned(180))
    if instant.motion(ref.owner).kind == "line" and not instant.motion(ref.owner).turns:
        return NOWHERE
    return instant.point(ref)
