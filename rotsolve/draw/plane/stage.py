"""Stage: where all bodies and surfaces of a scene are at a state, on paper but in metres.

What the scene tells is kept: joints, contacts, the sides on which strings run. What it leaves open goes by rules: strings hang straight,
weights below their wheels, what is not tied to anything stands side by side, and what would overlap goes further apart.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cached_property
from typing import Any

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.bodies import on_rim, part_of, radius_of
from rotsolve.confirm.forces import spring_way
from rotsolve.confirm.instant import placed
from rotsolve.confirm.model import Model
from rotsolve.confirm.pose import StringPart, Way, turned
from rotsolve.confirm.routing import rim_arm
from rotsolve.confirm.seating import joints_of, seated
from rotsolve.confirm.signs import normal, rests, surface_of
from rotsolve.draw.paper.figure import Point, moved
from rotsolve.draw.plane.bodies import Figured, Measures, figured, measures
from rotsolve.draw.plane.equations import WISH, Layout, Place, between, component, fixed, off
from rotsolve.draw.plane.outlines import Value, valued
from rotsolve.draw.plane.outlines import turned as spun
from rotsolve.draw.plane.overlaps import pushed_apart
from rotsolve.elements.connections.drives import Belt, Gear
from rotsolve.elements.connections.springs import Spring
from rotsolve.elements.connections.strings import String
from rotsolve.elements.connections.touch import Touch
from rotsolve.elements.surfaces import Corner, Curved, Level
from rotsolve.language.bodies import PointRef
from rotsolve.motion.configuration import Configuration

DROP, BETWEEN = 2.0, 1.5  # of a string below its wheel, in blocks; between wheels of a belt, in their radii
SIDE = 1.5  # from one thing to the next beside it, in their widths


class Stage:
    """A scene at one of its states, with a place for everything."""

    def __init__(self, configuration: Configuration, numbers: dict[str, float], state: str) -> None:
        self.configuration, self.state = configuration, state
        self.model = Model(configuration.problem, numbers, state)
        self.value: Value = valued({**numbers})
        self.sizes: Measures = measures(self.model, self.value)
        self.q = self._standing()
        self.bodies: dict[str, Figured] = figured(self.model, self.value, self.q, self.sizes)
        self.longer: dict[str, float] = {}  # by how much strings and springs hang lower than they are wished to
        self.shifts: dict[str, Point] = {}
        self.surfaces: dict[str, Any] = {}
        self.drawn_ground: list[Point] = []  # points of surfaces on paper, beside which other things go
        self.braced: set[str] = set()  # wheels whose support is drawn
        self.loop_foot: Point | None = None  # where a track leads into a bowl or loop
        self.layout = Layout(0)
        self.arrange()
        pushed_apart(self)

    def _standing(self) -> list[float]:
        """How bodies are turned, as the confirming assembly finds it; as they are drawn where it finds nothing."""
        try:
            return placed(self.model).q
        except (NotConfirmed, ArithmeticError, ValueError):
            return seated(self.model)

    def arrange(self) -> None:
        """Works out all places anew."""
        self.layout = Layout(0)
        self._foot_of: tuple[Place, float] | None = None
        wide = SIDE * self.sizes.whole
        self._unknown = {
            name: (self.layout.unknown(number * wide), self.layout.unknown())
            for number, name in enumerate(self.bodies)
        }
        self.surfaces = {}
        for item in self.model.acting.connections:
            self._tie(item)
        self._later()
        self._join()
        found = self.layout.solved()
        for name, (x, y) in self._unknown.items():
            self.bodies[name].place = moved((x.at(found), y.at(found)), self.shifts.get(name, (0.0, 0.0)))
        self.found = found
        if self._foot_of is not None:
            (x, y), radius = self._foot_of
            self.loop_foot = (x.at(found), y.at(found) - radius)

    # what is where, as far as it depends on unknowns

    def origin(self, name: str) -> Place:
        return self._unknown[name]

    def place_of(self, name: str, spot: Point) -> Place:
        """A point of a body's own axes."""
        return off(self.origin(name), spun(spot, self.bodies[name].turn))

    def tied(self, ref: PointRef) -> Place | None:
        """Where a string or spring meets a point; None for what is fixed anywhere."""
        if ref.place is not None:
            return fixed(self.value(ref.place[0]), self.value(ref.place[1]))
        return self.place_of(ref.owner, self.model.tied(ref)) if ref.owner in self.bodies else None

    # what must be, and what is wished

    def _tie(self, item: object) -> None:
        if isinstance(item, Touch):
            self._touch(item)
        elif isinstance(item, String):
            for number, leg in enumerate(self.model.legs(item)):
                self._leg(f"{item.name} {number}", leg)
        elif isinstance(item, Spring):
            self._spring(item)
        elif isinstance(item, Gear):
            self._beside(item.gear[0], item.gear[1], inside=item.inside)
        elif isinstance(item, Belt):
            for first, second in zip(item.belt, item.belt[1:], strict=False):
                self._beside(first, second, gap=BETWEEN)

    def _join(self) -> None:
        """Points of two bodies that are at one place; of a scene with places that are told the fixed axis is the origin."""
        meshing = [set((ref.owner for ref in item.touches())) for item in self.model.acting.connections if isinstance(item, (Gear, Belt))]
        past = {event.name for event in self.model.acting.joined()}
        coming = [
            {ref.owner for ref in event.points(self.model.problem.connections)}
            for event in self.model.problem.events
            if event.name not in past
        ]
        for one, two in joints_of(self.model):
            pair = {one.owner, two.owner}
            if pair in meshing or not pair <= set(self.bodies):
                continue
            first, second = (self.place_of(ref.owner, self.model.drawn(ref)) for ref in (one, two))
            if pair in coming and not self._tied_pair(pair):
                self._coming(one, two, first, second)
            elif self._rides(pair):
                (ax, ay), (bx, by) = (self._drawn_at(ref.owner) for ref in (one, two))
                self.layout.meet(off(self.origin(one.owner), (bx - ax, by - ay)), self.origin(two.owner))
            else:
                self.layout.meet(first, second)
        places = [ref.place for item in self.model.acting.connections for ref in item.touches() if ref.place is not None]
        for name, (_, ref) in self.model.held.items() if places else ():
            self.layout.meet(self.place_of(name, self.model.drawn(ref)), fixed(0.0, 0.0))

    def _drawn_at(self, name: str) -> Point:
        """Where the assembly has the origin of a body."""
        seat = self.model.seats[name]
        x, y = spun(seat.rigid.centre, self.q[seat.turn])
        return self.q[seat.first] - x, self.q[seat.first + 1] - y

    def _tied_pair(self, pair: set[str]) -> bool:
        return any(pair <= set(union) for union in map(set, self.model.unions))

    def _rides(self, pair: set[str]) -> bool:
        rides = (item.ride() for item in self.model.acting.connections)
        return any({ride.rider.owner, ride.carrier.owner} == pair for ride in rides if ride is not None)

    def _coming(self, one: PointRef, two: PointRef, first: Place, second: Place) -> None:
        """What will meet in an event stands a little before that, along its way."""
        mover = one.owner if self.model.line(one.owner) is not None or one.owner not in self.model.held else two.owner
        way = self.model.line(mover) or (0.0, -1.0)
        sign = 1.0 if mover == one.owner else -1.0
        room = self.bodies[one.owner].reach(way) + self.bodies[two.owner].reach((-way[0], -way[1]))
        room = (0.0 if self.bodies[mover].dot else room) + 0.35 * self.sizes.whole
        for part, along in zip(between(first, second), way, strict=True):
            self.layout.equal(part, sign * along * room, WISH)

    def _touch(self, item: Touch) -> None:
        ref, under = item.pair()[:2]
        surface = surface_of(item, self.model)
        wheel = self._rim(item)
        if under.owner in self.bodies and (ref.owner in self.model.held or under.owner in self.model.held):
            self._beside(ref, under)
            return
        if isinstance(surface, Curved):
            self._round(item, surface)
            return
        if surface is None:
            return
        out = normal(surface, self.model)
        radius, spot = wheel if wheel is not None else (0.0, self.model.tied(ref))
        low = self.place_of(ref.owner, spot)
        down = radius
        if wheel is None and rests(item, self.model):
            down, low = self.bodies[ref.owner].reach((-out[0], -out[1])), self.origin(ref.owner)
        if under.owner in self.bodies:
            back = self.bodies[under.owner].reach(out)
            self.layout.equal(component(between(self.origin(under.owner), low), out), back + down)
            self.layout.equal(component(between(self.origin(under.owner), low), turned(out)), 0.0, 0.1)
            return
        level = self.surfaces.get(surface.name)
        if level is None:
            level = self.surfaces[surface.name] = (surface, self.layout.unknown())
        self.layout.equal(component(low, out).plus(level[1], -1.0), down)

    def _rim(self, item: Touch) -> tuple[float, Point] | None:
        """The radius of what rolls, and its centre."""
        ref = item.pair()[0]
        body = self.model.body(ref.owner)
        radius = radius_of(body, ref.point, self.value)
        if not (on_rim(body, ref.point) or (ref.point in ("bottom", "center") and radius is not None)):
            return None
        part = ref.point if part_of(body, ref.point) else None
        return radius or 0.0, self.model.spot(PointRef(ref.owner, part))

    def _round(self, item: Touch, surface: Curved) -> None:
        """On a curved surface at the angle that the assembly tells; a track of no told form is drawn as one goes down into a bowl."""
        name = item.lying()
        size, seat = surface.radius(), self.model.seats[name]
        centre = self.surfaces.get(surface.name)
        if centre is None:
            made = (self.layout.unknown(), self.layout.unknown())
            centre = self.surfaces[surface.name] = (surface, made)
        if size is None:
            self.layout.meet(centre[1], self.origin(name))
            self._leads_into(item, name)
            return
        ref = item.pair()[0]
        rim = self._rim(item)
        radius = rim[0] if rim is not None else 0.0
        if rim is None and self.bodies[name].block:
            radius = self.bodies[name].reach((0.0, -1.0))
        x, y = self.q[seat.first] - seat.rigid.centre[0], self.q[seat.first + 1] - seat.rigid.centre[1]
        angle = math.atan2(y, x)
        circle = self.value(size) + (radius if surface.outside else -radius)
        arm = (circle * math.cos(angle), circle * math.sin(angle))
        self.layout.meet(off(centre[1], arm), self.origin(ref.owner))
        if rim is None and self.bodies[name].block:
            self.bodies[name].turn = angle - math.pi / 2 if surface.outside else angle + math.pi / 2
        height = surface.height()
        if height is not None:
            self._foot(name, surface, centre[1], self.value(height))

    def _leads_into(self, item: Touch, name: str) -> None:
        """A bowl or loop into which a track leads is further on and lower."""
        for ref in item.places():
            later = self.model.surfaces.get(ref.owner)
            size = later.radius() if isinstance(later, Curved) else None
            if later is None or size is None:
                continue
            radius = self.value(size)
            right = -1.0 if self.bodies[name].body.moves == "left" else 1.0
            at = (right * 2.6 * radius, -0.6 * radius)
            made = (self.layout.unknown(), self.layout.unknown())
            self.surfaces[later.name] = (later, made)
            self.layout.meet(off(self.origin(name), at), made)
            self._foot_of = (made, radius)

    def _later(self) -> None:
        """What a body will touch only later: an edge ahead on its way, a level a little below it."""
        for item in self.model.problem.connections:
            if not isinstance(item, Touch) or item in self.model.acting.connections or item.lying() not in self.bodies:
                continue
            for ref in item.places():
                surface = self.model.surfaces.get(ref.owner)
                if surface is None or surface.name in self.surfaces:
                    continue
                body, (x, y) = self.bodies[item.lying()], self.origin(item.lying())
                if isinstance(surface, Corner) and surface.corner is not None:
                    ahead = (1.0 if surface.side == "right" else -1.0) * 2.0 * body.reach((1.0, 0.0))
                    rise = self.value(surface.corner) - body.reach((0.0, -1.0))
                    made = (self.layout.unknown(), self.layout.unknown())
                    self.layout.meet(off((x, y), (ahead, rise)), made)
                    self.surfaces[surface.name] = (surface, made)
                elif isinstance(surface, Level):
                    level = self.layout.unknown()
                    self.layout.equal(level.plus(y, -1.0), -1.3 * body.reach((0.0, -1.0)))
                    self.surfaces[surface.name] = (surface, level)

    def _foot(self, name: str, surface: Curved, edge: Place, height: float) -> None:
        """The floor before an edge, where another contact of the body names it."""
        for other in self.model.acting.connections:
            level = surface_of(other, self.model) if isinstance(other, Touch) and other.lying() == name else None
            if level is None or isinstance(level, Curved):
                continue
            known = self.surfaces.get(level.name)
            if known is None:
                known = self.surfaces[level.name] = (level, self.layout.unknown())
            self.layout.equal(edge[1].plus(known[1], -1.0), height)

    def leg_end(self, ref: PointRef, side: int, way: Way) -> Place | None:
        """Where a leg of a string ends: on the rim of a wheel, at a point, or nowhere that is told."""
        if ref.owner not in self.bodies or ref.place is not None or not side:
            return self.tied(ref)
        return off(self.place_of(ref.owner, self.model.spot(ref)), rim_arm(ref, way, side, self.model))

    def _leg(self, name: str, leg: StringPart) -> None:
        if leg.along is None:
            return
        first, second = self.leg_end(leg.first, leg.sides[0], leg.along), self.leg_end(leg.second, leg.sides[1], leg.along)
        if first is None or second is None:
            return
        gap = between(first, second)
        self.layout.equal(component(gap, turned(leg.along)))
        self.layout.equal(component(gap, leg.along), self.leg_length(name, leg), WISH)

    def leg_length(self, name: str, leg: StringPart) -> float:
        """As long as the wheels at its ends and a block below them need."""
        radii = [radius_of(self.model.body(ref.owner), ref.point, self.value) or 0.0 for ref, side in zip((leg.first, leg.second), leg.sides, strict=True) if side]
        largest = [radius_of(self.model.body(ref.owner), None, self.value) or 0.0 for ref in (leg.first, leg.second) if ref.owner in self.bodies]
        rooms = [self.bodies[ref.owner].reach(way) for ref, way in ((leg.first, leg.along), (leg.second, (-leg.along[0], -leg.along[1]))) if ref.owner in self.bodies] if leg.along else []
        return self.longer.get(name, 0.0) + max(DROP * self.sizes.block, 1.1 * sum(radii), 1.2 * max(largest, default=0.0), 1.35 * sum(rooms))

    def _spring(self, item: Spring) -> None:
        first, second = (self.tied(ref) for ref in item.spring)
        if first is None or second is None or any(ref.place is not None for ref in item.spring):
            return
        way = spring_way(item, self.model)
        gap = between(first, second)
        self.layout.equal(component(gap, turned(way)))
        self.layout.equal(component(gap, way), self.longer.get(item.name, 0.0) + 3.0 * self.sizes.block, WISH)

    def _beside(self, first: PointRef, second: PointRef, *, gap: float = 1.0, inside: bool = False) -> None:
        """Two wheels side by side, the second on the right: touching, or so many radii apart."""
        radii = [radius_of(self.model.body(ref.owner), ref.point, self.value) or self.bodies[ref.owner].reach((1.0, 0.0)) for ref in (first, second)]
        apart = abs(radii[0] - radii[1]) if inside else gap * sum(radii)
        if gap > 1.0:
            apart = max(apart, gap * sum(self.bodies[ref.owner].reach((1.0, 0.0)) for ref in (first, second)))
        one, two = (self.place_of(ref.owner, self.model.spot(ref)) for ref in (first, second))
        x, y = between(one, two)
        self.layout.equal(x, apart)
        self.layout.equal(y, 0.0)

    # what the pictures ask

    def point(self, ref: PointRef) -> Point | None:
        """Where a point is, that of a rim on its side in space; None of what is fixed anywhere."""
        if ref.place is not None:
            return self.value(ref.place[0]), self.value(ref.place[1])
        if ref.owner not in self.bodies:
            return None
        from rotsolve.confirm.bodies import side_of

        body = self.bodies[ref.owner]
        side = side_of(body.body, ref.point)
        if side is not None:
            radius = radius_of(body.body, ref.point, self.value) or 0.0
            marked = (ref.owner, ref.point) in self.model.marks
            arm = spun(side, body.turn if marked else 0.0)
            return moved(body.place, arm, radius)
        return body.spot(self.model.spot(ref))

    def legs(self) -> Iterator[tuple[String, int, StringPart]]:
        """All legs of all strings."""
        for item in self.model.acting.connections:
            if isinstance(item, String):
                for number, leg in enumerate(self.model.legs(item)):
                    yield item, number, leg

    @cached_property
    def groups(self) -> dict[str, int]:
        """For each body the number of the group that is tied together."""
        group = self.layout.groups()
        return {name: min(group[index] for part in parts for index in part.slope) for name, parts in self._unknown.items()}
