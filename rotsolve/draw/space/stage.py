"""Stage: where all bodies of a scene in space stand at a state, and which of them go side by side, since nothing tells their places."""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import cached_property

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.space.arrows import ALONG, STILL, Arrow, Turned, scaled, sum_of, times_arrow
from rotsolve.confirm.space.rig import Lines, Rig
from rotsolve.confirm.space.stance import Stance
from rotsolve.draw.plane.places.outlines import Value
from rotsolve.draw.space.solids import Piece, body_pieces, plain_solid
from rotsolve.draw.space.view import RIGHT, seen
from rotsolve.language.bodies import Body, Joint, PointRef
from rotsolve.language.problem import State
from rotsolve.motion.configuration import Configuration

GUESS = 0.5  # radians: the tilt of what nothing tells
BESIDE = 0.45  # between two groups, in the width of the larger one
FAULTS = (NotConfirmed, ArithmeticError, ValueError, LookupError)


class DrawnSolid(Struct):
    """A body as it is drawn: its pieces where it stands, how it is turned, and its centre of mass."""

    name: str
    body: Body
    pieces: tuple[Piece, ...]
    rows: Turned
    place: Arrow

    def moved(self, by: Arrow) -> None:
        self.place = sum_of(self.place, by)
        self.pieces = tuple(
            replace(piece, points=tuple(sum_of(point, by) for point in piece.points)) for piece in self.pieces
        )

    @property
    def size(self) -> float:
        """How far its points are from its centre of mass, at most."""
        return max((math.dist(point, self.place) for piece in self.pieces for point in piece.points), default=0.0)


class SpaceStage:
    """A scene in space at one of its states."""

    def __init__(self, configuration: Configuration, numbers: dict[str, float], state: str) -> None:
        self.configuration, self.problem = configuration, configuration.problem
        self.rig = Rig(self.problem, numbers)
        self.value: Value = self.rig.value
        found = next((item for item in self.problem.states if item.name == state), None)
        self.state: State | None = found
        self.lines = Lines(self.rig, found, {})
        self.stance = Stance(self.rig, self.lines, GUESS)
        self.solids = {body.name: self._solid(body) for body in self.problem.bodies}
        self.shifts: dict[str, Arrow] = dict.fromkeys(self.solids, STILL)
        self._side_by_side()

    @cached_property
    def whole(self) -> float:
        """The measure of the scene: the largest body, or arm of a point of one, that is told."""
        sizes = [
            math.dist(point, STILL)
            for body in self.problem.bodies
            for piece in body_pieces(body, self.value)
            for point in piece.points
        ]
        sizes += [
            math.hypot(*(self.value(part) for part in at)) for body in self.problem.bodies for _, at in body.points
        ]
        return max((size for size in sizes if size > 0.0), default=1.0)

    def rows(self, name: str) -> Turned:
        """How a body is turned; as it is drawn where nothing tells."""
        try:
            return self.stance.turned(name)
        except FAULTS:
            return ALONG

    def _solid(self, body: Body) -> DrawnSolid:
        rows = self.rows(body.name)
        try:
            centre, place = self.rig.solid(body.name).centre, self.stance.place(body.name)
        except FAULTS:
            centre, place = STILL, STILL
        origin = sum_of(place, scaled(-1.0, turned_out(rows, centre)))
        pieces = list(body_pieces(body, self.value)) or list(self._stand_in(body))
        return DrawnSolid(body.name, body, tuple(piece.turned(rows, origin) for piece in pieces), rows, place)

    def _stand_in(self, body: Body) -> list[Piece]:
        massless = body.mass is not None and body.tensor is None and body.inertia is None and not self._weighs(body)
        if massless:
            return []
        if body.tensor is None and body.inertia is None and body.gyration is None:
            return [Piece("dot", (STILL,))]
        try:
            axis = self.rig.axis(body.name)
        except FAULTS:
            axis = None
        return list(plain_solid(body, self.value, self.whole, axis))

    def _weighs(self, body: Body) -> bool:
        try:
            return body.mass is not None and self.value(body.mass) > 0.0
        except FAULTS:
            return True

    # places

    def moments(self) -> Iterator[None]:
        """Sets the bodies as they stand at each moment that a picture is to have room for: where they are, and nowhere else."""
        yield

    def joints(self, name: str) -> list[Joint]:
        """The joints that hold a body."""
        return [joint for joint in self.rig.joints.values() if joint.body.owner == name]

    def point(self, ref: PointRef) -> Arrow:
        """Where a point of a body is."""
        try:
            return sum_of(self.stance.point(ref), self.shifts[ref.owner])
        except FAULTS:
            return self.solids[ref.owner].place

    def held_at(self, joint: Joint) -> Arrow:
        """Where a joint is: at the point of the body that it holds."""
        return self.point(joint.body)

    def way(self, joint: Joint) -> Arrow | None:
        """The direction of a joint's axis."""
        if not (joint.turning or joint.sliding):
            return None
        try:
            return self.stance.way(joint)
        except FAULTS:
            return None

    def axis(self, name: str) -> Arrow | None:
        """The axis of a body, in space."""
        try:
            own = self.rig.axis(name)
        except FAULTS:
            return None
        return None if own is None else turned_out(self.solids[name].rows, own)

    # side by side

    def groups(self) -> list[list[str]]:
        """Bodies that joints tie together, or whose places are told."""
        groups: list[list[str]] = []
        for name in self.solids:
            carrier = next(
                (joint.carrier.owner for joint in self.joints(name) if joint.carrier.owner in self.solids), ""
            )
            placed = any(line.path is not None and line.path.quantity == "position" for line in self.lines.of(name))
            home = next((group for group in groups if carrier in group or (placed and group is groups[0])), None)
            if home is None:
                groups.append([name])
            else:
                home.append(name)
        return groups

    def _side_by_side(self) -> None:
        """Groups from left to right as the reader sees them, unless they are apart already."""
        edge: float | None = None
        for group in self.groups():
            points = [seen(point) for name in group for piece in self.solids[name].pieces for point in piece.points]
            if not points:
                continue
            left, right = min(x for x, _ in points), max(x for x, _ in points)
            if edge is not None:
                gap = max(BESIDE * (right - left), 0.25 * self.whole)
                by = scaled(edge + gap - left, RIGHT)
                for name in group:
                    self.solids[name].moved(by)
                    self.shifts[name] = sum_of(self.shifts[name], by)
                right += edge + gap - left
            edge = right


def turned_out(rows: Turned, arrow: Arrow) -> Arrow:
    """An arrow of a body's own axes, in space."""
    return times_arrow(rows, arrow)
