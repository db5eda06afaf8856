"""Overlaps: what would lie on each other without touching in the scene goes apart: along its string, or as a group to the side."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from itertools import combinations
from typing import TypeVar

from rotsolve.confirm.seating import joints_of
from rotsolve.draw.paper.figure import Point, shifted_by
from rotsolve.draw.plane.places.bodies import Figured
from rotsolve.draw.plane.places.rules import arrange
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.motion.configuration import Configuration

Stage = TypeVar("Stage", bound=PlaneStage)

ROUNDS = 14  # of going apart
FREE = 0.25  # between two groups, in the width of the larger one
TOUCHING = 1e-3  # of its size, by which a body may overlap one that it touches


def plane_stage(configuration: Configuration, numbers: dict[str, float], state: str) -> PlaneStage:
    """A scene at a state with a place for everything."""
    return set_apart(PlaneStage(configuration, numbers, state))


def set_apart(stage: Stage) -> Stage:
    """Groups side by side, and the strings of what would overlap so long that it does not."""
    for _ in range(ROUNDS):
        stage.shifts.clear()
        arrange(stage)
        groups_beside(stage)
        pair = next(overlapping(stage), None)
        if pair is None or not lengthened(stage, pair):
            break
    return stage


def groups_beside(stage: PlaneStage) -> None:
    """Groups that nothing ties to each other stand from left to right, on one level with their middles."""
    names: dict[int, list[str]] = {}
    for name, group in stage.groups.items():
        if stage.bodies[name].seen:
            names.setdefault(group, []).append(name)
    edge: float | None = None
    for members in names.values():
        points = [point for _ in stage.moments() for name in members for point in stage.bodies[name].bound()]
        left, right = min(x for x, _ in points), max(x for x, _ in points)
        low, high = min(y for _, y in points), max(y for _, y in points)
        gap = max(FREE * (right - left), 0.6 * stage.sizes.block, 0.35 * stage.sizes.whole)
        if edge is not None and len(names) > 1:
            anchored = any(stage.bodies[name].name in stage.model.held for name in members) or not tied_down(
                stage, members
            )
            by = (edge + gap - left, -(low + high) / 2 if anchored else 0.0)
            for name in members:
                stage.shifts[name] = shifted_by(stage.shifts.get(name, (0.0, 0.0)), by)
                stage.bodies[name].place = shifted_by(stage.bodies[name].place, by)
            right += by[0]
        edge = right


def tied_down(stage: PlaneStage, members: Sequence[str]) -> bool:
    """Whether something lies on a surface."""
    return any(item.lying() in members for item in stage.model.acting.connections if item.lying())


def overlapping(stage: PlaneStage) -> Iterator[tuple[str, str]]:
    """Pairs of bodies that overlap although nothing in the scene has them at one place."""
    excused = excused_pairs(stage)
    hulls = {name: hull(body.bound()) for name, body in stage.bodies.items() if body.seen}
    for one, other in combinations(hulls, 2):
        if frozenset((one, other)) not in excused and meet(hulls[one], hulls[other]):
            yield one, other


def excused_pairs(stage: PlaneStage) -> set[frozenset[str]]:
    """Bodies that the scene itself has at one place: joined, on one axle, touching, one inside another, meeting in an event."""
    pairs = {frozenset((one.owner, two.owner)) for one, two in joints_of(stage.model)}
    distant = (*stage.kinds.strings, *stage.kinds.springs, *stage.kinds.belts)
    for item in stage.model.acting.connections:
        owners = [ref.owner for ref in item.touches() if ref.owner in stage.bodies]
        pairs |= set() if item in distant else {frozenset(pair) for pair in combinations(owners, 2)}
    for event in stage.model.problem.events:
        owners = [ref.owner for ref in event.points(stage.model.problem.connections)]
        pairs |= {frozenset(pair) for pair in combinations(owners, 2)}
    return pairs | {
        frozenset((one, other))
        for pair in list(pairs)
        for far in list(pairs)
        if len(pair & far) == 1
        for one in pair - far
        for other in far - pair
    }


def lengthened(stage: PlaneStage, pair: tuple[str, str]) -> bool:
    """Lets one of two bodies hang lower: the one that is lower already, by the string on which it hangs alone."""
    lower = sorted(pair, key=lambda name: stage.bodies[name].place[1])
    for name in lower:
        for item, number, leg in stage.legs():
            if name in (leg.first.owner, leg.second.owner) and leg.along is not None:
                key = f"{item.name} {number}"
                step = max(
                    0.8 * stage.sizes.block, 0.6 * tall(stage.bodies[pair[0]]), 0.6 * tall(stage.bodies[pair[1]])
                )
                stage.longer[key] = stage.longer.get(key, 0.0) + step
                return True
    return False


def tall(body: Figured) -> float:
    ys = [y for _, y in body.bound()]
    return max(ys) - min(ys) if ys else 0.0


def hull(points: Sequence[Point]) -> list[Point]:
    """The corners of the smallest polygon without dents round points, counterclockwise."""
    ordered = sorted(set(points))
    if len(ordered) < 3:
        return ordered
    halves: list[list[Point]] = []
    for run in (ordered, ordered[::-1]):
        side: list[Point] = []
        for point in run:
            while len(side) > 1 and turning_side(side[-2], side[-1], point) <= 0.0:
                side.pop()
            side.append(point)
        halves.append(side[:-1])
    return halves[0] + halves[1]


def turning_side(origin: Point, one: Point, other: Point) -> float:
    return (one[0] - origin[0]) * (other[1] - origin[1]) - (one[1] - origin[1]) * (other[0] - origin[0])


def meet(one: Sequence[Point], other: Sequence[Point]) -> bool:
    """Whether two polygons without dents overlap by more than they touch: no edge of either has all of the other on its far side."""
    room = TOUCHING * max(size_of(one), size_of(other))
    for first, second in ((one, other), (other, one)):
        for start, end in zip(first, [*first[1:], first[0]], strict=True):
            edge = (end[0] - start[0], end[1] - start[1])
            long = math.hypot(*edge)
            if long and all(edge[0] * (y - start[1]) - edge[1] * (x - start[0]) <= room * long for x, y in second):
                return False
            if (
                long
                and len(first) == 2
                and all(edge[0] * (y - start[1]) - edge[1] * (x - start[0]) >= -room * long for x, y in second)
            ):
                return False
    return math.hypot(one[0][0] - other[0][0], one[0][1] - other[0][1]) <= room if len(one) == len(other) == 1 else True


def size_of(points: Sequence[Point]) -> float:
    xs, ys = [x for x, _ in points], [y for _, y in points]
    return max(max(xs) - min(xs), max(ys) - min(ys))
