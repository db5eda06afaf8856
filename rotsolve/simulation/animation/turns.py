"""Turns: how the bodies of a scene in space have gone and turned at each moment, by the numbers that its motion tells.

A symmetric body is told by axes that do not spin with it; how far it has spun in them is the integral of its rate about its axis.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from rotsolve.confirm.numbers import value_of
from rotsolve.confirm.space.arrows import ALONG, Arrow, Turned, inner_product, product_of, rotation_about, rows_back
from rotsolve.draw.space.moving import SolidWay
from rotsolve.simulation.animation.reading import MotionReading
from rotsolve.simulation.space.compiling import SpaceSystem
from rotsolve.simulation.space.outputs import IN_BODY, OWN_AXES


def solid_ways(reading: MotionReading) -> list[dict[str, SolidWay]]:
    """The way of each body at each moment."""
    names = [body.name for body in reading.run.problem.bodies]
    reading.read(tuple(told for name in names for told in pictured(name) if told in reading.run.names))
    ways: list[dict[str, SolidWay]] = [{} for _ in reading.times]
    for name in names:
        back, axis = rows_back(standing(name, 0, reading)), spin_axis(name, reading)
        for number, spun in enumerate(spins(name, axis, reading)):
            own = standing(name, number, reading)
            rows = own if axis is None else product_of(own, rotation_about(axis, spun))
            by = arrow_told(f"{name}.position", number, reading) or (0.0, 0.0, 0.0)
            ways[number][name] = SolidWay(by, product_of(rows, back))
    return ways


def pictured(name: str) -> Iterator[str]:
    """What is told of a body that a picture asks for."""
    for word in (*OWN_AXES, "position"):
        yield from (f"{name}.{word}.{axis}" for axis in "xyz")
    yield from (f"{name}.angular_velocity.{axis}{IN_BODY}" for axis in "xyz")


def arrow_told(name: str, number: int, reading: MotionReading, axes: str = "") -> Arrow | None:
    """A vector that is told; None where it is not."""
    parts = [reading.value(f"{name}.{axis}{axes}", number) for axis in "xyz"]
    x, y, z = (part or 0.0 for part in parts)
    return None if all(part is None for part in parts) else (x, y, z)


def standing(name: str, number: int, reading: MotionReading) -> Turned:
    """How the axes stand by which a body is told: as columns."""
    columns = [arrow_told(f"{name}.{word}", number, reading) for word in OWN_AXES]
    x, y, z = (told or own for told, own in zip(columns, ALONG, strict=True))
    return rows_back((x, y, z))


def spin_axis(name: str, reading: MotionReading) -> Arrow | None:
    """The axis of a body that is told by axes which do not turn about it."""
    system = reading.run.regimes[0].system
    assert isinstance(system, SpaceSystem)
    axis = system.moment.unspun(name)
    if axis is None:
        return None
    x, y, z = (float(value_of(part, {})) for part in axis)
    return x, y, z


def spins(name: str, axis: Arrow | None, reading: MotionReading) -> Iterator[float]:
    """How far a body has spun about its axis by each moment, by the trapezoidal rule."""
    total = 0.0
    yield total
    for number, (before, now) in enumerate(pairwise(reading.times)):
        if axis is not None:
            rates = (
                arrow_told(f"{name}.angular_velocity", k, reading, IN_BODY) or (0.0, 0.0, 0.0)
                for k in (number, number + 1)
            )
            total += (now - before) * sum(inner_product(axis, rate) for rate in rates) / 2
        yield total
