"""Configuration: which bodies are joined into one, and how each can move at each state."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.drive import BY_INERTIA, TURNING, Drive, along_line
from rotsolve.core.facts import Facts, Whirl, signed
from rotsolve.core.faults import Unsolvable
from rotsolve.core.remembered import remembered
from rotsolve.core.symbols import MIXED, UNKNOWN, combined
from rotsolve.core.vectors.heading import RIGHT, UP, WORDS, Heading, Vector, heading
from rotsolve.elements.shapes import rim_radius, shape_of, touching_radius
from rotsolve.language.bodies import Body, Orbit, PointRef, Ride
from rotsolve.motion.arrangement import Arrangement
from rotsolve.motion.rigid import Frame, centre_of_mass, direction_of, locate, pieces, polar, rim_centre, rim_ways, tidy
from rotsolve.motion.welds import Member, seated

if TYPE_CHECKING:
    from rotsolve.language.problem import Condition

    pass


def ridden(item: Ride, axis: PointRef | None) -> tuple[PointRef, PointRef]:
    """Where a body that rides on another meets it: its distance is counted from the carrier's axis."""
    return axis or PointRef(item.carrier.owner, "center"), PointRef(item.rider.owner, "center")


WAYS = ("displacement", "rotation")


def stands(line: Condition, component: frozenset[str]) -> bool:
    """Whether a line of a state says that one of some bodies is at rest."""
    if line.rest:
        return line.owner in ("", "all") or line.owner in component
    speed = line.path is not None and line.path.quantity in ("velocity", "angular_velocity")
    return speed and line.path is not None and line.path.owner in component and line.value == ZERO


class Configuration(Arrangement, frozen=True, dict=True):
    """A problem in time; answers what is connected to what at each state, as one body or tied, and how it can move."""

    def since(self, name: str, state: str) -> str:
        """The state from which a body and all that it carries have their data; empty where these never change."""
        since = (self._versions[state][item].since for item in self.carried(name, state))
        return max(since, key=lambda name: self.timeline.order.get(name, -1))

    def changing(self, name: str, state: str) -> bool:
        """Whether the data of a body, or of what it carries, change in the phase of a state; what slides freely always goes on."""
        phase = self.timeline.phase_of(state)
        if any(item.free and item.carrier.owner == name for item in self.rides(state)) or self.laid(name):
            return True
        return phase is not None and self.since(name, phase.start) != self.since(name, phase.end)

    def present(self, state: str) -> tuple[Body, ...]:
        """Bodies that are there at a state and stand for themselves (a joined body belongs to its host)."""
        away = self._absent[state] | self.seats(state).keys()
        return tuple(self.body(body.name, state) for body in self.problem.bodies if body.name not in away)

    @remembered
    def seats(self, state: str) -> dict[str, Member]:
        """Where the bodies sit that another stands for: by a weld, by an event up to this state, or since they ride on it."""
        pairs = self.junctions(state)
        if not pairs:
            return {}
        held = frozenset(ref.owner for item in self.connections(state) for ref in item.fixed_points())
        return seated(
            pairs,
            lambda name: (
                name in held,
                *self._carried_along(name, state),
                not shape_of(self.bodies[name]).pointlike,
                self._turn_tells(name, state),
                self._borne(name),
            ),
            lambda ref: self._met_at(ref, state),
            lambda first, second: self._bend(first, second, state),
        )

    @remembered
    def junctions(self, state: str) -> list[tuple[PointRef, PointRef]]:
        """The points at which bodies meet that are one: where one rides on the other, or is joined to it."""
        riding = [ridden(item, self.pivot(item.carrier.owner, state)) for item in self.rides(state)]
        return riding + self.joints(state)

    @remembered
    def pinned(self, name: str, state: str) -> bool:
        """Whether a hinge or axle holds a body to the ground, or one that is one with it. Which of them stands for all may hang on this."""
        one, owners = {name}, [{ref.owner for ref in pair} for pair in self.junctions(state)]
        while more := set().union(*(pair for pair in owners if pair & one)) - one:
            one |= more
        return any(self.pivot(member, state) is not None for member in one)

    @remembered
    def joints(self, state: str) -> list[tuple[PointRef, PointRef]]:
        """The points at which two bodies are joined: by a weld, or by an event up to this state."""
        joined = [item.joined() for item in (*self.connections(state), *self.events(state))]
        gone = self._absent[state]
        return [(pair[0], pair[1]) for pair in joined if pair and not gone & {ref.owner for ref in pair}]

    def _turn_tells(self, name: str, state: str) -> bool:
        """Whether something hangs on how a body is turned: a wire, what holds it at a mark, or who asks. What stands for it goes on from
        there, while the turn of what is joined to it may tell nothing."""
        items = self.connections(state)
        marked = any(ref.owner == name and ref.point is not None for item in items for ref in item.touches())
        wound = any(ref.owner == name for item in items for ref in item.winds())
        return wound or marked or self.mentions.asks(name, "angle")

    def _carried_along(self, name: str, state: str) -> tuple[bool, bool]:
        """Whether a body lies on a surface along which it travels, and whether it hangs from a string."""
        body, items = self.bodies[name], self.connections(state)
        on_surface = any(item.track(body, self, state) or item.orbit(body, self, state) for item in items)
        return on_surface, any(item.hangs(body) for item in items)

    def _borne(self, name: str) -> bool:
        """Whether the ground bears a body, which `moves` on the level: what falls on it goes on with it."""
        return self.heavy and self.problem.plane == "vertical" and self.bodies[name].moves in ("left", "right")

    def _met_at(self, ref: PointRef, state: str) -> Vector:
        """Where a body is joined, in its own axes: that of a rim by an event is the mark that is in this direction in space then."""
        body = self.body(ref.owner, state)
        place, event = locate(body, ref), next((item for item in self.events(state) if ref in item.joined()), None)
        if event is None or ref.point not in rim_ways(body) or (ref.owner, ref.point) in self.marks(state):
            return place
        return place.rotated(RIGHT - (self._heading_told(ref.owner, event.from_ or "") or RIGHT))

    def _bend(self, first: str, second: str, state: str) -> Heading:
        """How far the second of two bodies that meet is turned against the first: two rods that are welded as the first state says that
        tells both their angles, else in line; bodies that an event joins as they stand then."""
        event = next(
            (item for item in self.events(state) if {first, second} == {ref.owner for ref in item.joined()}), None
        )
        if event is None:
            slender = all(shape_of(self.bodies[name]).slender for name in (first, second))
            states = [item.name for item in self.timeline.states] if slender else []
        else:
            states = [event.from_ or ""]
        for moment in states:
            headings = [self._heading_told(name, moment) for name in (first, second)]
            if headings[0] is not None and headings[1] is not None:
                return headings[1] - headings[0]
        return RIGHT

    def _heading_told(self, name: str, state: str) -> Heading | None:
        """How a body stands, where a state, or one before it with nothing but events between, tells that; one that is no rod as drawn."""
        angle, moment = self._angle_told(name, state), state
        while angle is None and (before := self.timeline.before(moment)) is not None and before.event is not None:
            moment = before.start
            angle = self._angle_told(name, moment)
        if shape_of(self.bodies[name]).slender:
            return None if angle is None else heading(angle)
        own = self.frame(name, state)
        drawn = self.direction(own.cm, name) if own.cm.parts and self.pivot(name, state) is not None else RIGHT
        return RIGHT if angle is None else heading(angle) - drawn

    def _angle_told(self, name: str, state: str) -> Formula | None:
        """The angle that a state tells of a body, or of a wire that turns it back."""
        wires = [item.name for item in self.connections(state) if [ref.owner for ref in item.winds()] == [name]]
        told = (self.mentions.told(state, owner, "angle") for owner in (name, *wires))
        return next((angle for angle in told if angle is not None), None)

    def direction(self, arm: Vector, name: str) -> Heading:
        """The heading of the way to a body's centre of mass, whichever sign its size has."""
        way = direction_of(arm)
        if len(tidy(arm).parts) > 1 and way.terms:
            return way  # atan2 of the components
        question = f"on which side of its axis the centre of mass of `{name}` is"
        along = simplify(arm.along(way))
        return way.turned(180) if self.certain_sign(along, question, self.bodies[name].span) < 0 else way

    def host(self, name: str, state: str) -> str:
        """The body that stands for `name` at a state: itself, unless joined."""
        seat = self.seats(state).get(name)
        return name if seat is None else seat.host

    def seat(self, name: str, state: str) -> Member:
        """Where a body sits in the axes of the one that stands for it."""
        return self.seats(state).get(name) or Member(name, name)

    def cluster(self, host: str, state: str) -> tuple[Member, ...]:
        """The seats of all for which a body stands, nearest first."""
        return tuple(seat for seat in self.seats(state).values() if seat.host == host)

    def carried(self, host: str, state: str) -> tuple[str, ...]:
        """A body and all that it carries, nearest first."""
        return (host, *(member.name for member in self.cluster(host, state)))

    @remembered
    def marks(self, state: str) -> frozenset[tuple[str, str | None]]:
        """Points that hinges and axles hold, to the ground or to another body: a rim's `top` among them turns with its body."""
        items = self.connections(state)
        return frozenset((ref.owner, ref.point) for item in items for ref in (*item.fixed_points(), *item.joint()))

    @remembered
    def pivot(self, name: str, state: str) -> PointRef | None:
        """The point of a body that a hinge or axle holds to the ground."""
        held = (ref for item in self.connections(state) for ref in item.fixed_points() if ref.owner == name)
        return next(held, None)

    @remembered
    def hung(self, name: str, state: str) -> PointRef | None:
        """The point of a body at which a hinge or axle hangs it from another one, where no fixed one holds it."""
        if self.pivot(name, state) is not None:
            return None
        return next((ref for item in self.connections(state) for ref in item.joint()[1:] if ref.owner == name), None)

    @remembered
    def hub(self, name: str, state: str) -> Vector | None:
        """The centre of the rim with which a body lies on a surface along which it travels, in the body's own axes."""
        body = self.body(name, state)
        for item in self.connections(state):
            if item.lying() == name and (item.track(body, self, state) or item.orbit(body, self, state)):
                ref = item.slider()
                return None if touching_radius(body, ref.point) is None else rim_centre(body, ref.point)
        return None

    def eccentric(self, name: str, state: str) -> bool:
        """Whether a body turns about an axis, or rolls about a centre, that is not its centre of mass."""
        turns = self.pivot(name, state) is not None or self.hub(name, state) is not None
        hung = self.hung(name, state)
        return (turns and not self.balanced(name, state)) or (hung is not None and self.swings_round(hung, state))

    def whirl(self, name: str, state: str) -> Whirl | None:
        """How a turning shaft carries a body round."""
        items = (item for item in self.connections(state) if item.circling)
        return next((item.whirl() for item in items if self.host(item.touches()[0].owner, state) == name), None)

    def axis(self, name: str, state: str) -> str:
        """The support on whose axis a body turns."""
        held = (item for item in self.connections(state) for ref in item.fixed_points() if ref.owner == name)
        return next((item.name for item in held), "")

    def line(self, name: str, state: str) -> tuple[Heading, str] | None:
        """Direction of travel of a body that moves along a line, and the words for its positive sense."""
        body = self.bodies[name]
        if self.pivot(name, state) is not None:
            return None
        for item in self.connections(state):
            track = item.track(body, self, state)
            if track is not None:
                return track
        if self.orbit(name, state) is not None:
            return None
        if body.moves and all(item.lying() != name for item in self.let_off(state)):
            return WORDS[body.moves], body.moves
        if self.hung(name, state) is not None:
            return None  # it goes where its carrier takes it, whatever string leads to it
        hangs = any(item.hangs(body) for item in self.connections(state))
        return (UP, "up") if hangs and self.problem.gravity is not None and self.problem.plane == "vertical" else None

    def mover(self, name: str, state: str) -> str:
        """The body along whose line another one travels: what carries it, where that hangs it by a joint, else what stands for it."""
        seen = [self.host(name, state)]
        while seen[-1] in self.bodies and self.hung(seen[-1], state) is not None:
            joints = (item.joint() for item in self.connections(state))
            carrier = next(refs[0].owner for refs in joints if any(ref.owner == seen[-1] for ref in refs[1:]))
            if self.host(carrier, state) in seen:
                break
            seen.append(self.host(carrier, state))
        return seen[-1]

    def drives(self, name: str, state: str) -> tuple[Drive, ...]:
        """The motions of a body that are given from outside."""
        host = self.host(name, state)
        found = tuple(
            Drive(
                item.name, host, word, self._of_host(owner, word, function, state), component, self.sense(host, state)
            )
            for item in self.connections(state)
            for owner, word, component, function in item.prescribes()
            if self.host(owner, state) == host
        )
        if any(drive.word in (*BY_INERTIA, "momentum") for drive in found):
            from rotsolve.motion.moments import by_inertia

            told = (*BY_INERTIA, "momentum")
            found = tuple(by_inertia(drive, self, state) if drive.word in told else drive for drive in found)
        if not any(drive.component for drive in found):
            return found
        if self.cluster(host, state):
            raise Unsolvable(
                f"`{host}` is joined to another body: moving it so is not solved yet", span=self.bodies[host].span
            )
        if self.pivot(host, state) is not None:
            said = f"`{host}` is held by an axle or hinge: its centre of mass can not be moved as well"
            raise Unsolvable(said, span=self.bodies[host].span, help="give its angle, or its rates")
        line = self.line(host, state)
        return found if line is None else along_line(found, line[0], self.bodies[host].span)

    def _of_host(self, owner: str, word: str, function: Formula, state: str) -> Formula:
        """What is given of the turn of a body that another stands for, as that one counts it."""
        host = self.host(owner, state)
        if host == owner or word not in (*TURNING, "angular_momentum"):
            return function
        if word == "angle":
            span, help = self.bodies[owner].span, f"give the angle of `{host}`"
            raise Unsolvable(
                f"the angle of `{owner}`, which is part of `{host}`, can not be given so", span=span, help=help
            )
        return signed(function, self.sense(owner, state) * self.sense(host, state))

    def sense(self, name: str, state: str) -> int:
        """+1 where a body's positive turn is counterclockwise: as declared, else as its rolling asks, else counterclockwise."""
        turns = self.bodies[name].turns
        if turns:
            return 1 if turns == "counterclockwise" else -1
        left = [item for item in self.let_off(state) if item.lying() == name]
        items = (*self.connections(state), *self.begun, *left)
        naturals = (item.natural_turn(self.body(name, state), self, state) for item in items)
        return next((natural for natural in naturals if natural), 1)

    def orbit(self, name: str, state: str) -> Orbit | None:
        """The circle on which a body's centre travels: on a curved surface, where no flat one and no pivot holds it."""
        body, items = self.bodies[name], self.connections(state)
        if self.pivot(name, state) is not None or any(item.track(body, self, state) is not None for item in items):
            return None
        return next((orbit for item in items if (orbit := item.orbit(body, self, state)) is not None), None)

    @remembered
    def component(self, name: str, state: str) -> frozenset[str]:
        """All bodies connected to a body, over any number of connections, at a state."""
        host, neighbours = self.host(name, state), self._neighbours(state)
        found, pending = set(), [host]
        while pending:
            current = pending.pop()
            if current not in found:
                found.add(current)
                pending.extend(neighbours.get(current, ()))
        return frozenset(found)

    @remembered
    def _neighbours(self, state: str) -> dict[str, set[str]]:
        """By body: those to which a connection ties it."""
        found: dict[str, set[str]] = {}
        for item in self.connections(state):
            owners = {self.host(ref.owner, state) for ref in item.touches() if ref.owner in self.bodies}
            for owner in owners if not item.independent else ():
                found.setdefault(owner, set()).update(owners)
        return found

    @remembered
    def pace(self, name: str, state: str) -> str:
        """How the acceleration of a body's component varies in the phase of a state (see core.symbols)."""
        component = self.component(name, state)
        paces = [self._own_pace(member, state) for member in component]
        for item in self.acting(state):
            if any(self.host(ref.owner, state) in component for ref in item.touches() if ref.owner in self.bodies):
                paces.append(item.pace(self, state))
        if self.set_down(component, state):
            paces.append(UNKNOWN)
        return combined(paces)

    @remembered
    def turn_span(self, name: str, state: str) -> str:
        """Where the angular acceleration of a body at a state belongs: to its phase also where forces go round, but their torques stay."""
        phase = self.timeline.phase_of(state)
        return phase.name if phase is not None and self.carries_evenly(name, state) else self.span(name, state)

    @remembered
    def carries_evenly(self, name: str, state: str) -> bool:
        """Whether all that moves with a body turns about fixed axes, or about its own centre that such a body carries round: without
        weights and under constant torques that speeds up evenly, as its moment of inertia is the same in all places."""
        component = self.component(name, state)
        if self.heavy or self.set_down(component, state) or any(self.changing(member, state) for member in component):
            return False
        carriers = {member for member in component if self.pivot(member, state) is not None}
        joints = [
            item
            for item in self.connections(state)
            if {self.host(ref.owner, state) for ref in item.joint()} & carriers
            and any(ref.point in (None, "center") and ref.owner in component - carriers for ref in item.joint())
        ]
        carried = {ref.owner for item in joints for ref in item.joint()}
        acting = [item for item in self.acting(state) if {ref.owner for ref in item.touches()} & component]
        return (
            bool(joints)
            and not any(item in acting and item.rubs() for item in self.connections(state))
            and all(member in carried and self.balanced(member, state) for member in component - carriers)
            and all(item in joints or item.pace(self, state) == "constant" for item in acting)
        )

    def set_down(self, component: frozenset[str], state: str) -> bool:
        """Whether bodies go from rest to rest in the phase of a state by a force that is asked for: it can not stay the same."""
        asked = {given.name for given in self.problem.givens if given.asked}
        acting = [item.strength() for item in self.actions(state) if {ref.owner for ref in item.touches()} & component]
        phase = self.timeline.phase_of(state) if any(strength.symbols() & asked for strength in acting) else None
        if phase is None:
            return False
        ends = [self.timeline.state(end).conditions for end in (phase.start, phase.end)]
        moved = [line.path.owner for line in ends[1] if line.path is not None and line.path.quantity in WAYS]
        return bool(set(moved) & component) and all(any(stands(line, component) for line in lines) for lines in ends)

    def _own_pace(self, name: str, state: str) -> str:
        if self.changing(name, state):
            return UNKNOWN
        if self.balanced(name, state):
            return "constant"
        if self.pivot(name, state) is None:
            return MIXED  # the centre of mass of what rolls goes round its centre
        return "position" if self.heavy else "constant"

    def balanced(self, name: str, state: str) -> bool:
        """Whether a body that turns about an axis, or rolls, carries its centre of mass there."""
        return not self.frame(name, state).cm.parts

    @remembered
    def span(self, name: str, state: str) -> str:
        """Where forces and accelerations of a body at a state belong: its phase while they are constant, else the state."""
        phase = self.timeline.phase_of(state)
        if phase is None or self.pace(name, state) != "constant":
            return state
        return phase.name

    def can_turn(self, name: str, state: str) -> bool:
        """Whether a body that no axis holds turns: a particle never, a light rod does; a body on a line if it is round or said to turn,
        whatever its mass: a string turns a light pulley too."""
        body, own = self.body(name, state), self.frame(name, state)
        wheel = rim_radius(body, None) is not None or self.hub(name, state) is not None
        free = self.line(name, state) is None and self.orbit(name, state) is None
        if any(drive.kinds == TURNING for drive in self.drives(name, state)):
            return True
        if all(piece.moment == ZERO and not tidy(piece.at - own.reference - own.cm).parts for piece in own.pieces):
            shapes = [shape_of(self.bodies[item]) for item in self.carried(name, state)]
            light = free and any(not (shape.pointlike or shape.round) for shape in shapes)
            return light or wheel
        return free or body.turns is not None or wheel

    def swings_round(self, ref: PointRef, state: str) -> bool:
        """Whether a point goes round the reference of its body as that turns."""
        name = self.host(ref.owner, state)
        held = self.pivot(name, state) is not None
        return self._off(ref, name, state) and (held or self.can_turn(name, state))

    def _off(self, ref: PointRef, name: str, state: str) -> bool:
        """Whether a point is not the reference of the body that it is part of."""
        place = self.seat(ref.owner, state).place(locate(self.body(ref.owner, state), ref))
        return bool(tidy(place - self.frame(name, state).reference).parts)

    def driven(self, name: str, state: str, by: str) -> bool:
        """Whether anything but one string may turn a body: a motor, a couple, what pushes or pulls off the point about which it turns."""
        items = (*(item for item in self.connections(state) if not item.joined()), *self.actions(state))
        touched = [(item, ref) for item in items for ref in item.touches() if self.host(ref.owner, state) == name]
        if any(drive.kinds == TURNING for drive in self.drives(name, state)):
            return True
        if sum(item.name == by for item, _ in touched) > 1:  # it runs round two of its rims
            return True
        others = [(item, ref) for item, ref in touched if item.name != by]
        rims = (ref in item.on_rims(self) and ref.point not in ("center", "cm") for item, ref in others)
        return any(rims) or any(item.twists() or self._off(ref, name, state) for item, ref in others)

    @remembered
    def frame(self, name: str, state: str) -> Frame:
        """The rigid body `name` at a state; its reference is the fixed pivot, the centre of what rolls, else the centre of mass."""
        body, hub = self.body(name, state), self.hub(name, state)
        items, pivot, cluster = pieces(body), self.pivot(name, state), self.cluster(name, state)
        for seat in cluster:
            items += tuple(seat.piece(item) for item in pieces(self.body(seat.name, state)))
        centre = centre_of_mass(items)
        reference = locate(body, pivot) if pivot is not None else centre if hub is None else hub
        return Frame(items, reference, polar(tidy(centre - reference)))


def groups_of(configuration: Configuration, facts: Facts, state: str) -> tuple[frozenset[str], ...]:
    """Bodies that move together, group by group."""
    return tuple(dict.fromkeys(configuration.component(body.name, state) for body in facts.bodies))
