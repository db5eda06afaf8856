"""Small disturbances of what moves together on hinges, axles and slides: its accelerations made linear in all places and rates, in numbers.

With x the angles and ways of the joints that nothing drives, δẍ = K δx + G δẋ by differences of what the equations of all bodies tell. That
a momentum is conserved is not used: of δx and δẋ that go with a coordinate that does not matter the eigenvalue is 0.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from fractions import Fraction

from msgspec import Struct

from rotsolve.algebra.formula import Number
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.linear import General
from rotsolve.confirm.space.arrows import Arrow, less, normed, rows_back, scaled, sum_of, times_arrow
from rotsolve.confirm.space.rig import ANGLES, Lines, Rig
from rotsolve.confirm.space.stability import Matrix, eigenvalues, only_square
from rotsolve.confirm.space.stance import Stance
from rotsolve.confirm.space.ties import EULER, SLIDES, SPINS, Tie
from rotsolve.confirm.space.worlds import RIGHT, Equations, Moving, World, anyhow, with_rates
from rotsolve.language.bodies import Joint
from rotsolve.language.problem import Condition, Path, State

STEP = 1e-3  # radians, or metres, by which a place is changed: differences are to the fourth order
STAYS = 1e-6  # how far from where all stays a steady motion may be, in the same
SAME = 1e-7  # of the largest acceleration: what rounding makes of two that are one
ROUNDED = 1e-12  # of the square of the largest rate: what rounding leaves of accelerations where no torque acts
FURTHER = 1.1  # radians by which what is driven is turned on, to see whether that changes anything
OTHERWISE = "swings of what is driven, slides round, or is held in several ways"
NO_PLACE = "swings about what is no equilibrium"
PASSES = "swings that change as what is driven goes round"
NOT_TOLD = "what is let go beside its steady motion"


class OpenWay(Struct, frozen=True):
    """One of the ways in which a joint lets its body move: it turns, by an Euler angle where it is a ball, or slides along a direction."""

    kind: str
    joint: Joint
    number: int = 0

    @property
    def body(self) -> str:
        return self.joint.body.owner

    @property
    def key(self) -> tuple[str, str, int]:
        return self.kind, self.body if self.kind == EULER else self.joint.owner, self.number

    @property
    def swings(self) -> bool:
        """Whether it is that of a hinge, or the tilt."""
        return self.kind == SPINS or (self.kind == EULER and ANGLES[self.number] == "tilt")


def carried_chain(rig: Rig, name: str) -> list[str]:
    """A body and what carries it, from the ground on."""
    carrier = rig.carrier(name)
    return [*(carried_chain(rig, carrier) if carrier else ()), name]


def moving_beside(rig: Rig, name: str) -> list[str]:
    """All bodies that move with one: what the first of its carriers that nothing drives carries."""
    joints = ((one, rig.main(one)) for one in carried_chain(rig, name))
    first = next((one for one, joint in joints if joint is not None and not joint.drive), name)
    return [one for one in rig.bodies if first in carried_chain(rig, one)]


def open_ways(rig: Rig, name: str) -> list[OpenWay]:
    """The ways in which all may move that moves with a body."""
    together = moving_beside(rig, name)
    return [way for joint in rig.joints.values() if joint.body.owner in together for way in open_ways_of(joint)]


def open_ways_of(joint: Joint) -> Iterator[OpenWay]:
    """Those of a joint: it turns as nothing drives it, and slides."""
    if joint.free:
        yield from (OpenWay(EULER, joint, number) for number, _ in enumerate(ANGLES))
        return
    if joint.rolls or joint.flat or joint.motor or joint.pitch is not None or len(joint.turning) > 1:
        raise NotConfirmed(OTHERWISE)
    if joint.turning and not joint.drive:
        yield OpenWay(SPINS, joint)
    yield from (OpenWay(SLIDES, joint, number) for number, _ in enumerate(joint.sliding))


def growth_together(world: World, name: str, ways: Sequence[OpenWay]) -> float:
    """λ² of the only disturbance that does not just stay as it is, of all that moves together while a body stands on its hinge."""
    count, here = len(ways), [0.0] * len(ways)
    stands = [way.swings and way.body == name for way in ways]
    rates = [0.0 if still else world.now.one(*way.key) for way, still in zip(ways, stands, strict=True)]
    size = max([1.0, *map(abs, rates)])

    def let_go(off: Sequence[float], now: Sequence[float], *, further: float = 0.0) -> list[float]:
        return accelerations_beside(stance_beside(world.stance, name, ways, off, further), ways, now)

    by_place = [fourth_order(lambda h, k=k: let_go(with_rates(here, [k], [h]), rates), STEP) for k in range(count)]  # type: ignore[misc]
    by_rate = [  # exact: the accelerations are quadratic in the rates
        first_order(lambda h, k=k: let_go(here, with_rates(rates, [k], [rates[k] + h])), size)  # type: ignore[misc]
        for k in range(count)
    ]
    most = max(abs(part) for column in by_place for part in column)
    if max(map(abs, let_go(here, rates))) > max(STAYS * most, ROUNDED * size**2):
        raise NotConfirmed(NO_PLACE)
    aside = [0.1] * count
    one, other = let_go(aside, rates), let_go(aside, rates, further=FURTHER)
    if any(
        abs(a - b) > max(SAME * max(most, *map(abs, one)), ROUNDED * size**2) for a, b in zip(one, other, strict=True)
    ):
        raise NotConfirmed(PASSES)
    matrix: Matrix = [[float(j == i + count) for j in range(2 * count)] for i in range(count)]
    matrix += [[column[i] for column in (*by_place, *by_rate)] for i in range(count)]
    return only_square(eigenvalues(matrix))


def first_order(function: Callable[[float], list[float]], h: float) -> list[float]:
    """(f(h) − f(−h))/2 h."""
    return [(a - b) / (2 * h) for a, b in zip(function(h), function(-h), strict=True)]


def fourth_order(function: Callable[[float], list[float]], h: float) -> list[float]:
    """The derivative at 0, by two steps."""
    near, far = first_order(function, h), first_order(function, 2 * h)
    return [(4 * a - b) / 3 for a, b in zip(near, far, strict=True)]


def accelerations_beside(stance: Stance, ways: Sequence[OpenWay], rates: Sequence[float]) -> list[float]:
    """How fast the rates of joints change, with all of them told, whatever else is open; of a thin frame and the rotor on its line, which
    only together have an inertia about that, the frame spins on as it does."""
    standing = Moving(stance, [Tie(((1.0, way.key),), rate, None) for way, rate in zip(ways, rates, strict=True)])
    count = len(standing.moving.free)
    idle = [Tie(((1.0, way.key),)) for way in ways if way.kind == EULER and ANGLES[way.number] == "spin_angle"]
    chosen = [standing.rates(anyhow(count, number)) for number in range(2 if count else 1)]
    found = [joint_accelerations(*standing.forced(now, idle), ways) for now in chosen]
    apart = [abs(a - b) > RIGHT * (1.0 + abs(a)) for a, b in zip(found[0], found[-1], strict=True)]
    if standing.broken > RIGHT or any(apart):
        raise NotConfirmed(NOT_TOLD)
    return found[0]


def joint_accelerations(equations: Equations, found: General, ways: Sequence[OpenWay]) -> list[float]:
    """The accelerations of joints, which the equations of all bodies have to tell."""
    places = [equations.places[way.key] for way in ways]
    open_too = any(abs(step[place]) > RIGHT for step in found.free for place in places)
    if open_too or max(map(abs, found.left), default=0.0) > RIGHT * found.size:
        raise NotConfirmed(NOT_TOLD)
    return [found.values[place] for place in places]


def stance_beside(stance: Stance, name: str, ways: Sequence[OpenWay], off: Sequence[float], further: float) -> Stance:
    """A stance with joints turned and slid so far from how they stand, and driven ones turned on; no line tells more of them."""
    rig, lines = stance.rig, stance.lines
    beside = {*carried_chain(rig, name), *moving_beside(rig, name)}
    own = {part for way in ways for part in (way.body, way.joint.owner)}
    driven = [
        joint for joint in rig.joints.values() if joint.body.owner in beside and "angular_velocity" in dict(joint.drive)
    ]
    angles = {(joint.body.owner, "angle"): stance.angle(joint) + further for joint in driven}
    slid: dict[str, Arrow] = {}
    for way, part in zip(ways, off, strict=True):
        if way.kind == SPINS:
            angles[way.body, "angle"] = stance.angle(way.joint) + part
        elif way.kind == EULER:
            angles[way.body, ANGLES[way.number]] = stance.euler(way.body)[way.number] + part
        else:
            along = scaled(part, normed(rig.arrow(way.joint.sliding[way.number])))
            slid[way.body] = sum_of(slid.get(way.body) or slid_as_drawn(stance, way.joint), along)
    anew = {body for body, _ in angles}
    kept = [line for line in lines.lines if line.path is not None and line.path.owner not in own | anew]
    told = [Condition(Path(*path), Number(Fraction(angle))) for path, angle in angles.items()]
    known = {key: value for key, value in lines.put.items() if key[1] not in own}
    found = Stance(rig, Lines(rig, State(lines.name, (*kept, *told)), known), stance.guess)
    found.slid.update(slid)
    return found


def slid_as_drawn(stance: Stance, joint: Joint) -> Arrow:
    """Where the point that slides is, from where it is held, in the axes of what carries it."""
    return times_arrow(rows_back(stance.base(joint)), less(stance.point(joint.body), stance.held_at(joint)))
