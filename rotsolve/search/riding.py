"""Riding: whether what slides freely along a body that turns comes to where a later state has it.

Its speed at any place is that of a scene of its own that ends there. A rod that begins at its axis ends there: what goes inwards has to
turn back before it comes to that, and what goes outwards before the other end, or the rim. Of letters these are conditions of the case.
"""

from __future__ import annotations

from collections.abc import Iterator

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula, Symbol
from rotsolve.algebra.units.dimension import LENGTH
from rotsolve.core.faults import UNSOLVED, Unsolvable
from rotsolve.core.letters import Given
from rotsolve.core.symbols import has_quantities
from rotsolve.core.ways import PLACE, WayEnd, WayOnJoint
from rotsolve.elements.shapes import ends_at, room_from
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.bodies import Ride
from rotsolve.language.problem import Condition, Path, State
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.timeline import Interval
from rotsolve.search.answers import NoAnswer, unsolvable
from rotsolve.search.planning import families_for
from rotsolve.search.search import Search
from rotsolve.search.ways_on_joints import barred_way

THERE = "#there"  # the state at which a rider would be at a place


def barred_rides(search: Search) -> Iterator[Unsolvable]:
    """The states to which what slides freely does not come, or of which nothing tells whether it does."""
    configuration = search.scene.configuration
    for interval in configuration.timeline.intervals:
        for ride in configuration.rides(interval.start) if interval.event is None else ():
            ends = ends_of_carrier(ride, configuration, interval.start) if ride.free else (None, None)
            if not leaves_by(ends, ride, interval, search):
                continue
            way = way_on_rod(ride, interval, search, ends)
            if way is not None:
                yield from barred_way(way, interval, search)
            elif goes_away(ride, interval, search):
                message = f"whether `{ride.rider.owner}` runs off `{ride.carrier.owner}` is not solved"
                yield unsolvable(configuration.problem, message, ride.rider.span, kind=UNSOLVED)


def ends_of_carrier(ride: Ride, configuration: Configuration, state: str) -> tuple[WayEnd | None, WayEnd | None]:
    """Where what a body rides on ends: at the axis, if it begins there, and farthest from that."""
    (bead, rod), axis = (ride.rider.owner, ride.carrier.owner), configuration.pivot(ride.carrier.owner, state)
    room = None if axis is None else room_from(configuration.bodies[rod], axis)
    if axis is None or room is None:
        return None, None
    inner = WayEnd(ZERO, f"`{bead}` comes to the axis before it turns back, and there `{rod}` ends")
    outer = WayEnd(room, f"`{bead}` comes to the end of `{rod}` before it turns back")
    return inner if ends_at(configuration.bodies[rod], axis) else None, outer


def leaves_by(ends: tuple[WayEnd | None, WayEnd | None], ride: Ride, interval: Interval, search: Search) -> bool:
    """Whether a rider may set out towards an end at which it would run off."""
    speed = search.apart().settled(search.scene.instant(interval.start).outward(ride.rider.owner))
    side = None if speed is None else search.numbers.side(speed)
    return ends[1] is not None and (ends[0] is not None or side == 1)


def goes_away(ride: Ride, interval: Interval, search: Search) -> bool:
    """Whether a rider sets out away from where a later state has it, or may do so."""
    start, end = radii_of(ride, interval, search)
    speed = search.apart().settled(search.scene.instant(interval.start).outward(ride.rider.owner))
    sides = [None if value is None else search.numbers.side(value) for value in (speed, end - start)]
    return None in sides or sides[0] != sides[1]


def radii_of(ride: Ride, interval: Interval, search: Search) -> tuple[Formula, Formula]:
    """How far from the axis a rider is at the start and the end of a phase."""
    shapes = [search.scene.configuration.body(ride.rider.owner, at).shape for at in (interval.start, interval.end)]
    start, end = (getattr(shape, "radius", None) or ZERO for shape in shapes)
    return start, end


def way_on_rod(
    ride: Ride, interval: Interval, search: Search, ends: tuple[WayEnd | None, WayEnd | None]
) -> WayOnJoint | None:
    """The way of a rider in a phase, by v² at each place; None where the laws do not tell that."""
    bead, places = ride.rider.owner, radii_of(ride, interval, search)
    try:
        left = square_of_speed(ride, interval, search)
    except (NoAnswer, Unsolvable):
        return None
    return WayOnJoint(bead, False, *places, search.scene.instant(interval.start).outward(bead), left, ZERO, ends)


def square_of_speed(ride: Ride, interval: Interval, search: Search) -> Formula:
    """v² of a rider by its place, as the laws tell it of a scene of its own that ends there."""
    configuration = search.scene.configuration
    problem, timeline = configuration.problem, configuration.timeline
    line = Condition(Path(ride.rider.owner, "radius"), Symbol(PLACE))
    states = (*timeline.states[: timeline.order[interval.start] + 1], State(THERE, (line,)))
    givens = (*problem.givens, Given(PLACE, None, LENGTH))
    ended = Configuration(replace(problem, givens=givens, states=states, phases=(), finds=()))
    own = Search(SceneEquations(ended, search.scene.modes), families_for(None), careful=True)
    speed = own.scene.instant(THERE).outward(ride.rider.owner)
    found = own.value_of(speed.name) if isinstance(speed, Symbol) else speed
    if found is None or has_quantities(found):
        raise NoAnswer("nothing tells it")
    return simplify(found**2)
