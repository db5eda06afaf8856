"""Moving: a scene in the plane at many moments of its motion, by the drawing of still pictures: each body goes as its way says, strings,
springs and ropes follow, and what nothing moves stays where the first picture has it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from msgspec import Struct

from rotsolve.confirm.forces import spring_way
from rotsolve.confirm.pose import StringPart, Way
from rotsolve.confirm.routing import rim_arm
from rotsolve.draw.paper.figure import Point, shifted_by
from rotsolve.draw.plane.places.bodies import Figured
from rotsolve.draw.plane.places.outlines import polygon, spun
from rotsolve.draw.plane.places.overlaps import set_apart
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.draw.plane.scene import plane_scale, spans
from rotsolve.language.bodies import PointRef
from rotsolve.language.elements import Connection
from rotsolve.motion.configuration import Configuration

ROOM, HIGH = 640.0, 400.0  # points of paper for a whole motion
CLEAR = 1.1  # of a string beside how far the bodies at its ends reach towards each other
KEPT = 0.4  # of a string or spring, at least, that is left of its first length
SPRINGY = 40.0  # points of a spring to something fixed that may be pressed together
SAMPLES = 60  # moments by which the room for a motion is told


Places = Mapping[str, tuple[Point, float]]
Meeting = tuple[PointRef, PointRef, Point]  # two points, and how much further the second goes until they meet


class BodyWay(Struct, frozen=True):
    """How a body has moved since the first picture: where the point is that its motion is told of, that point's way, and the turn."""

    about: Point
    by: Point
    turn: float


class PlaneMotion(Struct):
    """A motion as pictures need it: for each moment the way of each body that moves, how much of each rope hangs, what still connects."""

    ways: list[dict[str, BodyWay]]
    hanging: list[dict[str, float]]
    holding: list[frozenset[str]]  # the connections that are there
    event: str = ""  # that at which it ends


class MovingStage(PlaneStage):
    """A scene that is first arranged so that all of its motion has room, and then set to one moment after another."""

    def __init__(
        self,
        configuration: Configuration,
        numbers: dict[str, float],
        state: str,
        moments: Callable[[PlaneStage], PlaneMotion],
        longer: Mapping[str, float] | None = None,
        met: tuple[Meeting, ...] = (),
    ) -> None:
        super().__init__(configuration, numbers, state, longer)
        self.moved, self.met = moments, met
        self.known: PlaneMotion | None = None
        self.holding: frozenset[str] | None = None
        self.shown: list[Places] = []  # where all bodies are in each picture

    @property
    def motion(self) -> PlaneMotion:
        """The motion, told in places as they are arranged."""
        if self.known is None:
            self.known = self.moved(self)
        return self.known

    def arranged(self) -> MovingStage:
        """The stage with all places, at the first moment."""
        set_apart(self)
        self.known = None
        return self

    def settle(self) -> None:
        super().settle()
        self.known = None

    def moments(self) -> Iterator[None]:
        first = self.places()
        count = len(self.motion.ways)
        for number in sorted({round(k * (count - 1) / SAMPLES) for k in range(SAMPLES + 1)}):
            self.set(number, first)
            yield
        self.restore(first)

    def places(self) -> Places:
        """Where all bodies are, and how they are turned."""
        return {name: (body.place, body.turn) for name, body in self.bodies.items()}

    def restore(self, places: Places) -> None:
        for name, (place, turn) in places.items():
            self.bodies[name].place, self.bodies[name].turn = place, turn

    def set(self, number: int, first: Places) -> None:
        """Sets all bodies to a moment, from where they are at first."""
        self.restore(first)
        for name, way in self.motion.ways[number].items():
            body, (place, turn) = self.bodies[name], first[name]
            arm = spun((place[0] - way.about[0], place[1] - way.about[1]), way.turn)
            body.place = shifted_by(shifted_by(way.about, way.by), arm)
            body.turn = turn + way.turn

    def meetings(self) -> tuple[Meeting, ...]:
        return self.met

    def connections(self) -> tuple[Connection, ...]:
        """Those that are there at the moment."""
        known = super().connections()
        return known if self.holding is None else tuple(item for item in known if item.name in self.holding)


def moving_stage(
    configuration: Configuration, numbers: dict[str, float], state: str, moments: Callable[[PlaneStage], PlaneMotion]
) -> MovingStage:
    """A scene arranged for its motion: strings and springs so long that no end comes to the other, what meets at its end as far apart."""
    stage = MovingStage(configuration, numbers, state, moments).arranged()
    longer, met = lengthenings(stage), tuple(meetings_at_end(stage))
    if longer or met:
        stage = MovingStage(configuration, numbers, state, moments, longer, met).arranged()
    for item in stage.kinds.contacts:
        rider, carrier = (ref.owner for ref in item.pair()[:2])
        if rider in stage.bodies and carrier in stage.bodies and stage.bodies[carrier].block:
            widen_carrier(stage.bodies[carrier], stage.bodies[rider], stage)
    return stage


def meetings_at_end(stage: MovingStage) -> Iterator[Meeting]:
    """The points that meet in the event at which a motion ends."""
    first = stage.places()
    for event in stage.model.problem.events:
        points = event.points(stage.model.problem.connections)
        if event.name != stage.motion.event or len(points) != 2 or any(ref.owner not in stage.bodies for ref in points):
            continue
        gaps = []
        for number in (0, -1):
            stage.set(number, first)
            (ax, ay), (bx, by) = (stage.bodies[ref.owner].spot(stage.model.drawn(ref)) for ref in points)
            gaps.append((bx - ax, by - ay))
        stage.restore(first)
        yield points[0], points[1], shifted_by(gaps[1], gaps[0], -1.0)


def widen_carrier(carrier: Figured, rider: Figured, stage: MovingStage) -> None:
    """A block of no told size is drawn so long that what slides on it stays on it, as far as no string is tied to its ends."""
    tied = {ref.owner for item in (*stage.kinds.strings, *stage.kinds.springs) for ref in item.touches()}
    outline = carrier.outlines[0]
    xs, ys = [x for x, _ in outline.points], [y for _, y in outline.points]
    for _ in stage.moments():
        xs += [spun((x - carrier.place[0], y - carrier.place[1]), -carrier.turn)[0] for x, y in rider.bound()]
    if carrier.name not in tied:
        corners = ((min(xs), min(ys)), (max(xs), min(ys)), (max(xs), max(ys)), (min(xs), max(ys)))
        carrier.outlines = (polygon(corners), *carrier.outlines[1:])


def lengthenings(stage: MovingStage) -> dict[str, float]:
    """How much longer strings and springs have to be at first than they would be drawn."""
    free = SPRINGY / motion_scale(stage)
    ends: dict[str, tuple[StringPart, float]] = {}
    for item, number, leg in stage.legs():
        if leg.along is not None:
            ends[f"{item.name} {number}"] = leg, 0.0
    for spring in stage.kinds.springs:
        leg = StringPart(spring.spring[0], spring.spring[1], spring_way(spring, stage.model), (0, 0))
        ends[spring.name] = leg, free
    clear = {name: leg_clearance(leg, stage) for name, (leg, _) in ends.items()}
    first = {name: leg_run(leg, stage) for name, (leg, _) in ends.items()}
    least = dict(first)
    for _ in stage.moments():
        for name, (leg, _) in ends.items():
            least[name] = min(least[name], leg_run(leg, stage))
    found = dict(stage.longer)
    for name, (leg, spare) in ends.items():
        tied = all(ref.owner in stage.bodies for ref in (leg.first, leg.second))
        room = min((1.0 - KEPT) * abs(first[name]), first[name] - clear[name]) if tied else spare
        short = first[name] - least[name] - room
        if short > 0.0:
            found[name] = found.get(name, 0.0) + short
    return found if found != stage.longer else {}


def leg_clearance(leg: StringPart, stage: PlaneStage) -> float:
    """How long a leg has to be, at least, so that what is at its ends does not meet."""
    way = leg.along or (1.0, 0.0)
    ends = ((leg.first, way), (leg.second, (-way[0], -way[1])))
    return CLEAR * sum(stage.bodies[ref.owner].reach(out) for ref, out in ends if ref.owner in stage.bodies)


def leg_run(leg: StringPart, stage: PlaneStage) -> float:
    """How far the second end of a leg is ahead of the first, along its direction; the origin stands for what is fixed anywhere."""
    along = leg.along or (1.0, 0.0)
    (ax, ay), (bx, by) = (
        end_place(ref, side, along, stage) for ref, side in ((leg.first, leg.sides[0]), (leg.second, leg.sides[1]))
    )
    return (bx - ax) * along[0] + (by - ay) * along[1]


def end_place(ref: PointRef, side: int, along: Way, stage: PlaneStage) -> Point:
    """Where a leg ends, in metres."""
    if ref.owner not in stage.bodies or ref.place is not None:
        return stage.point(ref) or (0.0, 0.0)
    body = stage.bodies[ref.owner]
    if side:
        return shifted_by(body.spot(stage.model.spot(ref)), rim_arm(ref, along, side, stage.model))
    return body.spot(stage.model.tied(ref))


def motion_scale(stage: MovingStage) -> float:
    """Points of paper for a metre: as in a still picture, or less, so that all of the motion has room."""
    points = [point for _ in stage.moments() for body in stage.bodies.values() for point in body.bound()]
    wide, tall = spans(points)
    tall = max([tall, *(size for hanging in stage.motion.hanging for size in hanging.values())])
    limits = [plane_scale(stage), *(room / size for room, size in ((ROOM, wide), (HIGH, tall)) if size > 0.0)]
    return min(limits)
