"""Running off: whether what slides freely on a rod that begins at its axis comes to that, where the rod ends, before a later state.

What goes inwards and is asked for farther out has to turn back first: by what the laws tell of the axis its speed there, squared, must be
less than nothing. Of letters that is a condition of the case.
"""

from __future__ import annotations

from collections.abc import Iterator

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula, Symbol
from rotsolve.core.faults import UNSOLVED, Unsolvable
from rotsolve.core.symbols import has_quantities
from rotsolve.core.writing import spoken
from rotsolve.elements.shapes import ends_at
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.bodies import Ride
from rotsolve.language.problem import Condition, Path, State
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.timeline import Interval
from rotsolve.search.answers import NoAnswer, unsolvable
from rotsolve.search.endings import never_reached
from rotsolve.search.planning import families_for
from rotsolve.search.search import Search

AXIS = "#axis"  # the state at which a rider would be on the axis


def run_off(search: Search) -> Iterator[Unsolvable]:
    """The states before which a rider runs off its rod at the axis, or of which nothing tells whether it does."""
    configuration = search.scene.configuration
    for interval in configuration.timeline.intervals if interval_rides(configuration) else ():
        for ride in configuration.rides(interval.start):
            if ride.free and one_sided(ride, configuration, interval.start) and comes_back(ride, interval, search):
                yield from comes_to_axis(ride, interval, search)


def interval_rides(configuration: Configuration) -> bool:
    """Whether something slides freely on what turns."""
    return any(ride is not None and ride.free for ride in (item.ride() for item in configuration.problem.connections))


def one_sided(ride: Ride, configuration: Configuration, state: str) -> bool:
    """Whether what carries a rider begins at its axis."""
    axis = configuration.pivot(ride.carrier.owner, state)
    return axis is not None and ends_at(configuration.bodies[ride.carrier.owner], axis)


def comes_back(ride: Ride, interval: Interval, search: Search) -> bool:
    """Whether a rider sets out inwards, to a place that is not farther in."""
    speed = search.apart().settled(search.scene.instant(interval.start).outward(ride.rider.owner))
    places = [search.apart().settled(place_of(ride, state, search)) for state in (interval.start, interval.end)]
    if speed is None or places[0] is None or places[1] is None:
        return False
    return search.numbers.side(speed) == -1 and search.numbers.side(places[1] - places[0]) != -1


def place_of(ride: Ride, state: str, search: Search) -> Formula:
    """How far from the axis a rider is at a state."""
    return getattr(search.scene.configuration.body(ride.rider.owner, state).shape, "radius", None) or ZERO


def comes_to_axis(ride: Ride, interval: Interval, search: Search) -> Iterator[Unsolvable]:
    """The refusal of a state that a rider would come to only by way of the axis."""
    configuration, (bead, rod) = search.scene.configuration, (ride.rider.owner, ride.carrier.owner)
    try:
        left = left_at_axis(ride, interval, search)
    except NoAnswer as error:
        if error.equation is None:
            message = f"whether `{bead}`, which goes inwards, runs off `{rod}` at its axis is not solved"
            help = "ask from a state at which it goes outwards"
            yield unsolvable(configuration.problem, message, ride.rider.span, help, kind=UNSOLVED)
        return  # at the axis it would have less than no energy
    if search.numbers.side(left) != -1:
        why = f"{spoken(bead)} comes to the axis before it turns back, and there `{rod}` ends"
        yield never_reached(interval, configuration, why, sure=True)


def left_at_axis(ride: Ride, interval: Interval, search: Search) -> Formula:
    """v² of a rider on the axis, as the laws tell it of a scene of its own that ends there; NoAnswer where they do not."""
    configuration = search.scene.configuration
    problem, timeline = configuration.problem, configuration.timeline
    line = Condition(Path(ride.rider.owner, "radius"), ZERO)
    states = (*timeline.states[: timeline.order[interval.start] + 1], State(AXIS, (line,)))
    ended = Configuration(replace(problem, states=states, phases=(), finds=()))
    own = Search(SceneEquations(ended, search.scene.modes), families_for(None), careful=True)
    speed = own.scene.instant(AXIS).outward(ride.rider.owner)
    found = own.value_of(speed.name) if isinstance(speed, Symbol) else speed
    if found is None or has_quantities(found):
        raise NoAnswer("nothing tells it")
    return simplify(found**2)
