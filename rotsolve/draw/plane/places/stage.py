"""Stage: where all bodies and surfaces of a scene in the plane are at a state, in metres.

What the scene tells is kept: joints, contacts, the sides on which strings run. What it leaves open goes by rules (`rules`): strings hang
straight, weights below their wheels, what is not tied to anything stands side by side, and what would overlap goes further apart
(`overlaps`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cached_property
from typing import Any, TypeVar, cast

from msgspec.structs import replace

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.bodies import radius_of, side_of
from rotsolve.confirm.instant import placed
from rotsolve.confirm.model import Model
from rotsolve.confirm.pose import StringPart, Way
from rotsolve.confirm.routing import rim_arm
from rotsolve.confirm.seating import seated
from rotsolve.draw.paper.figure import Point, shifted_by
from rotsolve.draw.plane.places.bodies import Figured, Measures, figured, scene_measures
from rotsolve.draw.plane.places.equations import Layout, Place, place_off, told_place
from rotsolve.draw.plane.places.kinds import by_kind
from rotsolve.draw.plane.places.outlines import Value, spun, value_function
from rotsolve.draw.plane.places.posts import STOUT, is_post_of, touched_at
from rotsolve.elements.connections.strings import String
from rotsolve.language.bodies import PointRef, Surface
from rotsolve.language.elements import Connection
from rotsolve.language.problem import Problem
from rotsolve.motion.configuration import Configuration

Decision = TypeVar("Decision")

SIDE = 1.5  # from one thing to the next beside it, in the measure of the scene


def without_spare_densities(problem: Problem) -> Problem:
    """The scene without the densities of bodies whose mass is told too: with numbers for a picture both need not agree."""
    bodies = tuple(body if body.mass is None else replace(body, density=None) for body in problem.bodies)
    return replace(problem, bodies=bodies)


class PlaneStage:
    """A scene at one of its states, with a place for everything once its rules have been written."""

    def __init__(
        self,
        configuration: Configuration,
        numbers: dict[str, float],
        state: str,
        longer: Mapping[str, float] | None = None,
    ) -> None:
        self.configuration, self.state = configuration, state
        self.model = Model(without_spare_densities(configuration.problem), numbers, state)
        self.kinds = by_kind(self.model.acting.connections)
        self.value: Value = value_function({**numbers})
        self.sizes: Measures = scene_measures(self.model, self.kinds, self.value)
        self.q = self._standing()
        self.bodies: dict[str, Figured] = figured(self.model, self.kinds, self.value, self.q, self.sizes)
        self.longer = dict(longer or {})  # by how much strings and springs are longer than they are wished to be
        self.hanging: dict[str, float] = {}  # how much of a rope hangs in front, where a motion tells it
        self.decided: dict[object, Any] = {}
        self.shifts: dict[str, Point] = {}
        self.drawn_ground: list[Point] = []  # points of surfaces on paper, beside which other things go
        self.braced: set[str] = set()  # wheels whose support is drawn
        self.begin()

    def _standing(self) -> list[float]:
        """How bodies are turned, as the confirming assembly finds it; as they are drawn where it finds nothing."""
        try:
            return placed(self.model).q
        except (NotConfirmed, ArithmeticError, ValueError):
            return seated(self.model)

    def begin(self) -> None:
        """Forgets all places, and has an unknown for each."""
        self.layout = Layout(0)
        self.found: list[float] = []
        self.surfaces: dict[
            str, tuple[Surface, Any]
        ] = {}  # with the unknown level, or the unknown middle of a curved one
        self.foot: tuple[Place, float] | None = None  # the middle and radius of the loop into which a track leads
        wide = SIDE * self.sizes.whole
        self.unknown: dict[str, Place] = {
            name: (self.layout.unknown(number * wide), self.layout.unknown()) for number, name in enumerate(self.bodies)
        }
        self.posts: dict[str, Place] = {}  # the middles of posts
        self.wheels: list[tuple[PointRef, PointRef]] = []  # that touch side by side
        self.__dict__.pop("groups", None)

    def settle(self) -> None:
        """Gives everything the place that the equations tell."""
        self.found = self.layout.solved()
        for name, (x, y) in self.unknown.items():
            self.bodies[name].place = shifted_by(
                (x.at(self.found), y.at(self.found)), self.shifts.get(name, (0.0, 0.0))
            )

    # a scene that moves

    def kept(self, key: object, decide: Callable[[], Decision]) -> Decision:
        """What a picture chooses where the scene leaves it open, such as how far off a ceiling is: once for all pictures of a motion."""
        if key not in self.decided:
            self.decided[key] = decide()
        return cast("Decision", self.decided[key])

    def moments(self) -> Iterator[None]:
        """Sets the bodies as they stand at each moment that a picture is to have room for: where they are, and nowhere else."""
        yield

    def meetings(self) -> tuple[tuple[PointRef, PointRef, Point], ...]:
        """Points that meet in an event, with how much further the second goes than the first until then, where a motion tells that."""
        return ()

    def connections(self) -> tuple[Connection, ...]:
        """What connects bodies in the picture."""
        return tuple(self.model.acting.connections)

    # what is where, as far as it depends on unknowns

    def origin(self, name: str) -> Place:
        return self.unknown[name]

    def place_of(self, name: str, spot: Point) -> Place:
        """A point of a body's own axes."""
        return place_off(self.origin(name), spun(spot, self.bodies[name].turn))

    def tied(self, ref: PointRef) -> Place | None:
        """Where a string or spring meets a point; None for what is fixed anywhere."""
        if ref.place is not None:
            return told_place(self.value(ref.place[0]), self.value(ref.place[1]))
        return self.place_of(ref.owner, self.model.tied(ref)) if ref.owner in self.bodies else None

    def leg_end(self, ref: PointRef, side: int, way: Way) -> Place | None:
        """Where a leg of a string ends: on the rim of a wheel, at a point, or nowhere that is told."""
        if is_post_of(ref, self.model):
            return place_off(self.post(ref.owner), self.on_post(ref, way))
        if ref.owner not in self.bodies or ref.place is not None or not side:
            return self.tied(ref)
        return place_off(self.place_of(ref.owner, self.model.spot(ref)), rim_arm(ref, way, side, self.model))

    def post(self, name: str) -> Place:
        """The middle of a post."""
        if name not in self.posts:
            self.posts[name] = (self.layout.unknown(), self.layout.unknown())
        return self.posts[name]

    @property
    def post_radius(self) -> float:
        return STOUT * self.sizes.block

    def on_post(self, ref: PointRef, way: Way) -> Point:
        """From the middle of a post to where a strand along a direction touches it."""
        return touched_at(ref, way, self.post_radius, self.kinds, self.model)

    def drawn_at(self, name: str) -> Point:
        """Where the assembly has the origin of a body."""
        seat = self.model.seats[name]
        x, y = spun(seat.rigid.centre, self.q[seat.turn])
        return self.q[seat.first] - x, self.q[seat.first + 1] - y

    def rim(self, ref: PointRef) -> float | None:
        """The radius of the rim that a point names."""
        return radius_of(self.model.body(ref.owner), ref.point, self.value) if ref.owner in self.bodies else None

    # what the pictures ask

    def middle(self, where: Place) -> Point:
        """A place that was unknown."""
        return where[0].at(self.found), where[1].at(self.found)

    @property
    def loop_foot(self) -> Point | None:
        """The lowest place of a loop into which a track leads."""
        if self.foot is None:
            return None
        x, y = self.middle(self.foot[0])
        return x, y - self.foot[1]

    def point(self, ref: PointRef) -> Point | None:
        """Where a point is, that of a rim on its side in space; None of what is fixed anywhere."""
        if ref.place is not None:
            return self.value(ref.place[0]), self.value(ref.place[1])
        if ref.owner not in self.bodies:
            return None
        body = self.bodies[ref.owner]
        side = side_of(body.body, ref.point)
        if side is None:
            return body.spot(self.model.spot(ref))
        marked = (ref.owner, ref.point) in self.model.marks
        return shifted_by(body.place, spun(side, body.turn if marked else 0.0), self.rim(ref) or 0.0)

    def legs(self) -> Iterator[tuple[String, int, StringPart]]:
        """All legs of all strings."""
        for item in self.kinds.strings:
            for number, leg in enumerate(self.model.legs(item)):
                yield item, number, leg

    @cached_property
    def groups(self) -> dict[str, int]:
        """For each body the number of the group that is tied together."""
        group = self.layout.groups()
        return {
            name: min(group[index] for part in parts for index in part.slope) for name, parts in self.unknown.items()
        }
