"""Evenly: where a motion leads in a time that is too long to be followed, if all its bodies turn about fixed directions and gain evenly.

φ = ω₀ t + ½ α t² and ω = ω₀ + α t of each body are the motion where the equations of all bodies give that α all the way: at moments
that no period has in common they are held against it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from rotsolve.confirm.space.arrows import (
    STILL,
    Arrow,
    Turned,
    arrow_length,
    crossed,
    inner_product,
    less,
    product_of,
    rotation_about,
    scaled,
    sum_of,
    times_arrow,
)

if TYPE_CHECKING:
    from rotsolve.confirm.space.flight import Flight

Numbers = list[float]
Turning = tuple[Turned, Arrow, Arrow]  # of a body its rotation, ω and α at the start
MOMENTS = (0.0713, 0.1931, 0.3179, 0.4547, 0.5923, 0.7411, 0.8837, 1.0)  # shares of the time
SAME = 1e-9  # of the largest: by how much two that are one may differ
ROUNDING = 1e-12  # of ω², in which equations of what turns fast are rounded


def gained_evenly(flight: Flight, time: float) -> Numbers | None:
    """The numbers of all bodies some time later; None where they do not turn about fixed directions, or do not gain evenly."""
    if flight.free or flight.guided:
        return None
    start = {name: (rows, omega, alpha) for name, (rows, omega, _, alpha, _) in flight.motions(flight.first())}
    if not all(along_one_line(omega, alpha) for _, omega, alpha in start.values()):
        return None
    numbers: Numbers = []
    largest = max(1 / time**2, *(arrow_length(alpha) for _, _, alpha in start.values()))
    for share in MOMENTS:
        numbers = [part for name in start for part in turned_for(flight, name, start, share * time)]
        for name, (_, omega, _, alpha, _) in flight.motions(numbers):
            room = SAME * largest + ROUNDING * inner_product(omega, omega)
            if arrow_length(less(alpha, start[name][2])) > room:
                return None
    return numbers


def along_one_line(omega: Arrow, alpha: Arrow) -> bool:
    """Whether an angular acceleration changes the size of an angular velocity alone."""
    return arrow_length(crossed(omega, alpha)) <= SAME * arrow_length(omega) * arrow_length(alpha)


def turned_for(flight: Flight, name: str, start: Mapping[str, Turning], time: float) -> Iterator[float]:
    """The numbers of a body that has gained evenly for a time: with what carries it, and against that."""
    from rotsolve.confirm.space.flight import quaternion_of

    rows, omega, alpha = start[name]
    carrier = flight.rig.carrier(name)
    swings = flight.swings(name)
    led = gone_evenly(start[carrier], time) if swings and carrier in start else STILL
    gone = gone_evenly(start[name], time)
    own = inner_product(less(gone, led), times_arrow(rows, flight.axes[name])) if swings else 0.0
    round_ = led if swings else gone
    way, size = unit_and_length(round_)
    yield from quaternion_of(product_of(rotation_about(way, size), rows))
    yield own
    yield from STILL
    yield from sum_of(omega, scaled(time, alpha))
    yield from STILL


def gone_evenly(turning: Turning, time: float) -> Arrow:
    """φ of a body, along its axis."""
    _, omega, alpha = turning
    return sum_of(scaled(time, omega), scaled(time**2 / 2, alpha))


def unit_and_length(arrow: Arrow) -> tuple[Arrow, float]:
    """An arrow as a direction and a length."""
    size = arrow_length(arrow)
    return (scaled(1 / size, arrow), size) if size else ((0.0, 0.0, 1.0), 0.0)
