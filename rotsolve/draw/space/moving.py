"""Moving in space: a scene at many moments of its motion, seen obliquely: bodies go and turn as their ways say, joints go along."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.confirm.space.arrows import ALONG, Arrow, Turned, less, product_of, scaled, sum_of, times_arrow
from rotsolve.draw.paper.figure import Figure, Label, Point
from rotsolve.draw.paper.reel import Reel, largest_of
from rotsolve.draw.plane.signs.sheet import ScenePaper
from rotsolve.draw.space.marks import draw_name
from rotsolve.draw.space.scene import draw_axes, draw_bodies, draw_floors, space_scale
from rotsolve.draw.space.solids import Piece
from rotsolve.draw.space.stage import DrawnSolid, SpaceStage
from rotsolve.draw.space.view import seen, span_on_paper
from rotsolve.language.bodies import Joint, PointRef
from rotsolve.motion.configuration import Configuration

ROOM, HIGH = 520.0, 360.0  # points of paper for a whole motion
ROUND, SPOKE = 24, 0.55  # points of a side that is round; from its middle to the mark on it, in its radius
SAMPLES = 60  # moments by which the room for a motion is told


class SolidWay(Struct, frozen=True):
    """How a body has moved since the first picture: the way of its centre of mass, and the rotation."""

    by: Arrow
    turned: Turned


class MovingSpaceStage(SpaceStage):
    """A scene in space that can be set to the moments of its motion."""

    def __init__(
        self,
        configuration: Configuration,
        numbers: dict[str, float],
        state: str,
        ways: Sequence[dict[str, SolidWay]],
    ) -> None:
        self.number, self.ways = 0, ways
        super().__init__(configuration, numbers, state)
        turning = {name for moment in ways for name, way in moment.items() if way.turned != ALONG}
        self.first = {name: marked(solid) if name in turning else solid for name, solid in self.solids.items()}
        self.solids = dict(self.first)

    def set(self, number: int) -> None:
        """Sets all bodies to a moment."""
        self.number = number
        self.solids = {name: self.gone(solid) for name, solid in self.first.items()}

    def gone(self, solid: DrawnSolid) -> DrawnSolid:
        """A body as it stands at the moment."""
        way = self.ways[self.number].get(solid.name)
        if way is None:
            return solid
        pieces = tuple(
            replace(
                piece,
                points=tuple(self.carried(point, solid, way) for point in piece.points),
                way=None if piece.way is None else times_arrow(way.turned, piece.way),
            )
            for piece in solid.pieces
        )
        place = sum_of(solid.place, way.by)
        return DrawnSolid(solid.name, solid.body, pieces, product_of(way.turned, solid.rows), place)

    def carried(self, point: Arrow, solid: DrawnSolid, way: SolidWay) -> Arrow:
        """Where a point of a body has gone."""
        return sum_of(solid.place, way.by, times_arrow(way.turned, less(point, solid.place)))

    def moments(self) -> Iterator[None]:
        for number in sorted({round(k * (len(self.ways) - 1) / SAMPLES) for k in range(SAMPLES + 1)}):
            self.set(number)
            yield
        self.set(0)

    def point(self, ref: PointRef) -> Arrow:
        first, way = super().point(ref), self.ways[self.number].get(ref.owner)
        return first if way is None else self.carried(first, self.first[ref.owner], way)

    def way(self, joint: Joint) -> Arrow | None:
        first, way = super().way(joint), self.ways[self.number].get(joint.carrier.owner)
        return first if first is None or way is None else times_arrow(way.turned, first)


def marked(solid: DrawnSolid) -> DrawnSolid:
    """A body with a mark on each of its round sides, by which its turn is seen."""
    rounds = [piece for piece in solid.pieces if piece.kind == "face" and len(piece.points) >= ROUND]
    marks = []
    for piece in rounds:
        middle, rim = scaled(1.0 / len(piece.points), sum_of(*piece.points)), piece.points[0]
        inner = sum_of(scaled(1.0 - SPOKE, middle), scaled(SPOKE, rim))
        marks.append(Piece("mark", (inner, rim), piece.way))
    return DrawnSolid(solid.name, solid.body, (*solid.pieces, *marks), solid.rows, solid.place)


def moving_scale(stage: MovingSpaceStage) -> float:
    """Points of paper for a metre: as in a still picture, or less, so that all of the motion has room."""
    points = [
        seen(point)
        for _ in stage.moments()
        for solid in stage.solids.values()
        for piece in solid.pieces
        for point in piece.points
    ]
    wide, tall = span_on_paper(points)
    limits = [room / size for room, size in ((ROOM, wide), (HIGH, tall)) if size > 0.0]
    return min(space_scale(stage), *limits)


def space_pictures(stage: MovingSpaceStage, title: str, description: str) -> Reel:
    """The pictures of all moments of a motion."""
    scale = moving_scale(stage)
    reel = Reel(title, description, [], [], [], largest_of(2.0 * scale * solid.size for solid in stage.solids.values()))
    base = ScenePaper(scale)
    draw_floors(stage, base)
    draw_axes(stage, base)
    ground = list(base.figure.marks)
    for number in range(len(stage.ways)):
        stage.set(number)
        sheet = ScenePaper(scale)
        draw_bodies(stage, sheet)
        figure = Figure(marks=[*ground, *sheet.figure.marks])
        reel.pictures.append(figure.in_layers())
        if number == 0:
            reel.labels += first_names(figure, stage, base)
        reel.shifts.append([name_shift(label, stage, scale) for label in reel.labels])
    return reel


def first_names(figure: Figure, stage: MovingSpaceStage, base: ScenePaper) -> list[Label]:
    """The names of bodies and axes, where the first picture has room for them."""
    base.figure = figure
    for solid in stage.solids.values():
        draw_name(solid, stage, base)
    return list(base.finished().labels)


def name_shift(label: Label, stage: MovingSpaceStage, scale: float) -> Point:
    """How far the name of a body has gone with its centre of mass."""
    way = stage.ways[stage.number].get(label.tag)
    x, y = seen(way.by) if way is not None else (0.0, 0.0)
    return scale * x, scale * y
