"""Moving: a scene in the plane at many moments of its motion, by the drawing of still pictures: each body goes as its way says, strings,
springs and ropes follow, and what nothing moves stays where the first picture has it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from msgspec import Struct

from rotsolve.confirm.forces import spring_way
from rotsolve.confirm.pose import StringPart, Way
from rotsolve.confirm.routing import rim_arm
from rotsolve.draw.paper.figure import THIN, Figure, Label, Mark, Point, ray, shifted_by
from rotsolve.draw.paper.reel import Reel, moving_marks
from rotsolve.draw.plane.places.bodies import Figured
from rotsolve.draw.plane.places.outlines import spun
from rotsolve.draw.plane.places.overlaps import spread_out
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.draw.plane.scene import plane_scale, spans
from rotsolve.draw.plane.signs.ground import draw_surfaces
from rotsolve.draw.plane.signs.names import draw_name
from rotsolve.draw.plane.signs.sheet import ScenePaper
from rotsolve.draw.plane.signs.ties import draw_connections
from rotsolve.language.bodies import PointRef
from rotsolve.language.elements import Connection
from rotsolve.motion.configuration import Configuration

ROOM, HIGH = 640.0, 400.0  # points of paper for a whole motion
CLEAR = 1.1  # of a string beside how far the bodies at its ends reach towards each other
KEPT = 0.4  # of a string or spring, at least, that is left of its first length
SPRINGY = 40.0  # points of a spring to something fixed that may be pressed together
SAMPLES = 60  # moments by which the room for a motion is told
VISIBLE = 1e-6  # radians of a turn that is one
SPOKE = 0.55  # from the middle of a round body to the mark that shows its turn, in its radius


class BodyWay(Struct, frozen=True):
    """How a body has moved since the first picture: where the point is that its motion is told of, that point's way, and the turn."""

    about: Point
    by: Point
    turn: float


class Moments(Struct):
    """A motion as pictures need it: for each moment the way of each body that moves, how much of each rope hangs, what still connects."""

    ways: list[dict[str, BodyWay]]
    hanging: list[dict[str, float]]
    holding: list[frozenset[str]]  # the connections that are there


class MovingStage(PlaneStage):
    """A scene that is first arranged so that all of its motion has room, and then set to one moment after another."""

    def __init__(
        self,
        configuration: Configuration,
        numbers: dict[str, float],
        state: str,
        moments: Callable[[PlaneStage], Moments],
        longer: Mapping[str, float] | None = None,
    ) -> None:
        super().__init__(configuration, numbers, state, longer)
        self.moved = moments
        self.known: Moments | None = None
        self.holding: frozenset[str] | None = None

    @property
    def motion(self) -> Moments:
        """The motion, told in places as they are arranged."""
        if self.known is None:
            self.known = self.moved(self)
        return self.known

    def arranged(self) -> MovingStage:
        """The stage with all places, at the first moment."""
        spread_out(self)
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

    def places(self) -> dict[str, tuple[Point, float]]:
        """Where all bodies are, and how they are turned."""
        return {name: (body.place, body.turn) for name, body in self.bodies.items()}

    def restore(self, places: Mapping[str, tuple[Point, float]]) -> None:
        for name, (place, turn) in places.items():
            self.bodies[name].place, self.bodies[name].turn = place, turn

    def set(self, number: int, first: Mapping[str, tuple[Point, float]]) -> None:
        """Sets all bodies to a moment, from where they are at first."""
        self.restore(first)
        for name, way in self.motion.ways[number].items():
            body, (place, turn) = self.bodies[name], first[name]
            arm = spun((place[0] - way.about[0], place[1] - way.about[1]), way.turn)
            body.place = shifted_by(shifted_by(way.about, way.by), arm)
            body.turn = turn + way.turn

    def connections(self) -> tuple[Connection, ...]:
        """Those that are there at the moment."""
        known = super().connections()
        return known if self.holding is None else tuple(item for item in known if item.name in self.holding)


def moving_stage(
    configuration: Configuration, numbers: dict[str, float], state: str, moments: Callable[[PlaneStage], Moments]
) -> MovingStage:
    """A scene arranged for its motion, with strings and springs so long that no end comes to the other."""
    tried = MovingStage(configuration, numbers, state, moments).arranged()
    longer = lengthenings(tried)
    return MovingStage(configuration, numbers, state, moments, longer).arranged() if longer else tried


def lengthenings(stage: MovingStage) -> dict[str, float]:
    """How much longer strings and springs have to be at first than they would be drawn."""
    free = SPRINGY / motion_scale(stage)
    ends: dict[str, tuple[StringPart, float]] = {}
    for item, number, leg in stage.legs():
        if leg.along is not None:
            ends[f"{item.name} {number}"] = leg, 0.0
    for spring in stage.kinds.springs:
        leg = StringPart(*spring.spring, spring_way(spring, stage.model), (0, 0))
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
    """How far the second end of a leg is ahead of the first, along its direction; of one that is fixed anywhere as if that were the origin."""
    along = leg.along or (1.0, 0.0)
    (ax, ay), (bx, by) = (
        end_place(ref, side, along, stage)
        for ref, side in ((leg.first, leg.sides[0]), (leg.second, leg.sides[1]))
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


def motion_pictures(stage: MovingStage, title: str, description: str) -> Reel:
    """The pictures of all moments of a motion."""
    scale, first = motion_scale(stage), stage.places()
    stage.decided |= {("shrunk", item.name): 1.0 for item in stage.kinds.ropes}  # else what hangs from it would not keep pace
    shown = first
    base = ScenePaper(scale, title, description)
    draw_surfaces(stage, base)
    ground = list(base.figure.marks)
    turning = {name for ways in stage.motion.ways for name, way in ways.items() if abs(way.turn) > VISIBLE}
    reel = Reel(title, description, [], [], [])
    for number in range(len(stage.motion.ways)):
        stage.set(number, first)
        figure = picture_now(number, stage, scale, turning)
        figure.marks = [*ground, *moving_marks(figure)]
        reel.pictures.append(figure.in_layers())
        if number == 0:
            reel.labels += first_labels(figure, stage, base)
            shown = stage.places()
        reel.shifts.append([label_shift(label, stage, scale, shown) for label in reel.labels])
    return reel


def picture_now(number: int, stage: MovingStage, scale: float, turning: set[str]) -> Figure:
    """What moves, or is tied to what does, as it is now: without letters."""
    sheet = ScenePaper(scale)
    stage.braced.clear()
    stage.hanging, stage.holding = stage.motion.hanging[number], stage.motion.holding[number]
    draw_connections(stage, sheet)
    for body in stage.bodies.values():
        for outline in body.shown() if body.seen else ():
            sheet.outline(outline)
        if body.name in turning and body.seen:
            draw_spoke(body, sheet)
    return sheet.figure


def draw_spoke(body: Figured, sheet: ScenePaper) -> None:
    """A mark on a round body, by which its turn is seen."""
    whole = body.outlines[0]
    cuts = [outline.radius or 0.0 for outline in body.outlines if outline.cut]
    if not whole.radius or whole.cut:
        return
    middle, way = body.spot(whole.points[0]), ray(body.turn)
    inner = max(SPOKE * whole.radius, *cuts, 0.0)
    sheet.figure.line([sheet.at(shifted_by(middle, way, size)) for size in (inner, whole.radius)], THIN)


def first_labels(figure: Figure, stage: MovingStage, base: ScenePaper) -> list[Label]:
    """The names of bodies and the letters of surfaces, where the first picture has room for them."""
    base.figure = figure
    for body in stage.bodies.values():
        draw_name(body, stage, base)
    return list(base.finished().labels)


def label_shift(label: Label, stage: PlaneStage, scale: float, first: Mapping[str, tuple[Point, float]]) -> Point:
    """How far a label has gone with its body: round that with a rod, beside which it stays so."""
    if label.tag not in stage.bodies:
        return 0.0, 0.0
    body, (place, turn) = stage.bodies[label.tag], first[label.tag]
    arm = (label.at[0] - scale * place[0], label.at[1] - scale * place[1])
    round_ = bool(body.outlines) and body.outlines[0].radius is not None
    x, y = arm if round_ else spun(arm, body.turn - turn)
    return scale * (body.place[0] - place[0]) + x - arm[0], scale * (body.place[1] - place[1]) + y - arm[1]
