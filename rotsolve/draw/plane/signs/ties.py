"""Ties: the usual signs of hinges, axles, welds, slides, clutches, torsion wires, shafts and drives."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from rotsolve.confirm.bodies import radius_of
from rotsolve.confirm.signs import carrier_of, pointing
from rotsolve.draw.paper.figure import AXIS, STRING, SUPPORT, THIN, Point, arc_points, ray, shifted_by
from rotsolve.draw.plane.places.kinds import row_for
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.draw.plane.signs.ground import told_words
from rotsolve.draw.plane.signs.sheet import ScenePaper
from rotsolve.draw.plane.signs.strings import draw_belt, draw_rope, draw_spring, draw_string, widen
from rotsolve.elements.connections.drapes import Drapes
from rotsolve.elements.connections.drives import Belt, Gear, MutualDrive
from rotsolve.elements.connections.rubbing import Rubbing
from rotsolve.elements.connections.slots import PinSlot
from rotsolve.elements.connections.springs import Spring, Torsion
from rotsolve.elements.connections.strings import String
from rotsolve.elements.connections.supports import Axle, Hinge, Rides, Shaft, Weld
from rotsolve.elements.connections.touch import Touch
from rotsolve.language.elements import Connection

SPIRAL, TURNS = 13.0, 2.25  # radius and turns of a torsion spring
SLOT = 22.0  # half the length of a slot
TEETH = 5.0  # between the strokes of a rim with teeth


def draw_hinge(item: Hinge, stage: PlaneStage, sheet: ScenePaper) -> None:
    """A pin: on a support to the ground, away from the body; between two bodies alone."""
    ref = item.hinge[-1]
    if ref.owner not in stage.bodies:
        return
    body = stage.bodies[ref.owner]
    at = sheet.at(body.spot(stage.model.drawn(ref)))
    grounded = len(item.hinge) == 1 or item.hinge[0].owner not in stage.bodies
    light_arms(ref.owner, at, stage, sheet)
    upright = grounded and stage.model.problem.plane == "vertical"
    above = stage.kept(("above", item.name), lambda: sheet.at(group_middle(ref.owner, stage))[1] < at[1] - 1.0)
    stands = upright and stage.kept(("stands", item.name), lambda: at_edge(ref.owner, at, stage, sheet))
    sheet.pin(at, (0.0, 1.0) if above else (0.0, -1.0), stands)


def light_arms(name: str, at: Point, stage: PlaneStage, sheet: ScenePaper) -> None:
    """The light rods that hold a point on its way round a hinge or an axle."""
    if stage.bodies[name].dot:
        for place in stage.bodies[name].bound():
            sheet.figure.line([at, sheet.at(place)], STRING)


def at_edge(name: str, at: Point, stage: PlaneStage, sheet: ScenePaper) -> bool:
    """Whether a pin is near the edge of its body, so that its support covers little."""
    points = [sheet.at(point) for other in stage.model.joined_to(name) for point in stage.bodies[other].bound()]
    near = [point for point in points if abs(point[0] - at[0]) < 12.0]
    below = any(point[1] < at[1] - 6.0 for point in near)
    above = any(point[1] > at[1] + 6.0 for point in near)
    return not (below and above)


def group_middle(name: str, stage: PlaneStage) -> Point:
    """The middle of a body and all that is one with it."""
    points = [point for other in stage.model.joined_to(name) for point in stage.bodies[other].bound()]
    return sum(x for x, _ in points) / len(points), sum(y for _, y in points) / len(points)


def draw_axle(item: Axle, stage: PlaneStage, sheet: ScenePaper) -> None:
    """The hub of each wheel."""
    carrier = carrier_of(item, stage.model)
    for ref in item.axle:
        if ref is not carrier:
            light_arms(ref.owner, sheet.at(stage.bodies[ref.owner].spot(stage.model.drawn(ref))), stage, sheet)
            sheet.hub(sheet.at(stage.bodies[ref.owner].spot(stage.model.drawn(ref))))


def draw_weld(item: Weld, stage: PlaneStage, sheet: ScenePaper) -> None:
    """Nothing but the bodies themselves."""


def draw_ride(item: Rides, stage: PlaneStage, sheet: ScenePaper) -> None:
    """A sleeve round what it slides on."""
    rider, carrier = (stage.bodies[ref.owner] for ref in item.rides)
    turn, at = carrier.turn, sheet.at(rider.bound()[0])
    along = ray(turn)
    box = widen(shifted_by(at, along, -6.0), shifted_by(at, along, 6.0), 5.0)
    sheet.figure.line(box, SUPPORT, closed=True)


def draw_slot(item: PinSlot, stage: PlaneStage, sheet: ScenePaper) -> None:
    """A pin between the two sides of its slot."""
    place, carrier = stage.point(item.pin), stage.bodies.get(item.within.owner)
    if place is None:
        return
    at = sheet.at(place)
    way = (
        pointing(item.along, stage.model)
        if item.along is not None
        else ray(carrier.turn if carrier is not None else 0.0)
    )
    sheet.figure.line(widen(shifted_by(at, way, -SLOT), shifted_by(at, way, SLOT), 4.0), SUPPORT, closed=True)
    sheet.pin(at, stands=False)


def draw_gear(item: Gear, stage: PlaneStage, sheet: ScenePaper) -> None:
    """Teeth on both rims."""
    for ref in item.gear:
        centre = sheet.at(stage.bodies[ref.owner].spot(stage.model.spot(ref)))
        radius = (radius_of(stage.model.body(ref.owner), ref.point, stage.value) or 0.0) * sheet.scale
        count = max(12, round(2 * math.pi * radius / TEETH))
        for k in range(count):
            way = ray(stage.bodies[ref.owner].turn + 2 * math.pi * k / count)
            sheet.figure.line([shifted_by(centre, way, radius - 2.4), shifted_by(centre, way, radius)], THIN)
        sheet.hub(centre)


def draw_torsion(item: Torsion, stage: PlaneStage, sheet: ScenePaper) -> None:
    """A spiral spring at the axis, with its stiffness."""
    ref = item.torsion[-1]
    if ref.owner not in stage.bodies:
        return
    centre = sheet.at(stage.bodies[ref.owner].spot(stage.model.axis(ref.owner)))
    whole = 2 * math.pi * TURNS
    points = [shifted_by(centre, ray(whole * k / 60, 2.0 + SPIRAL * k / 60)) for k in range(61)]
    sheet.figure.line(points, STRING)
    words = told_words(stage, item.stiffness)
    if words is not None:
        sheet.letters.name(words, centre, (-0.8, -0.6), SPIRAL + 3.0)


def draw_shaft(item: Shaft, stage: PlaneStage, sheet: ScenePaper) -> None:
    """The upright axis, the arm out to the hinge with its length, and the turn."""
    ref = item.shaft[0]
    at = sheet.at(stage.bodies[ref.owner].spot(stage.model.drawn(ref)))
    out = stage.value(item.distance) * sheet.scale if item.distance is not None else 0.0
    x = at[0] - out
    low, high = shaft_ends(stage, sheet)
    sheet.figure.line([(x, low), (x, high)], AXIS)
    sheet.figure.line([(x, at[1] - 16.0), (x, at[1] + 16.0)], SUPPORT)
    if out > 1.0:
        sheet.figure.line(widen((x, at[1]), at), SUPPORT, closed=True)
        words = told_words(stage, item.distance)
        if words is not None:
            sheet.dimension((x, at[1]), at, words)
    sheet.pin(at, stands=False)
    ellipse = [
        (x + 9.0 * math.cos(a), high - 9.0 + 3.4 * math.sin(a))
        for a in (math.radians(-200 + 290 * k / 20) for k in range(21))
    ]
    from rotsolve.draw.paper.figure import SPIN

    sheet.figure.line(ellipse, SPIN, heads=">")
    spin = told_words(stage, item.turning)
    if spin is not None:
        sheet.letters.name(spin, (x, high - 9.0), (1.0, 0.0), 12.0, SPIN.ink)


def shaft_ends(stage: PlaneStage, sheet: ScenePaper) -> tuple[float, float]:
    """How far down and up an upright axis is drawn: beyond all bodies, wherever they go."""
    heights = [sheet.at(point)[1] for _ in stage.moments() for body in stage.bodies.values() for point in body.bound()]
    return min(heights) - 22.0, max(heights) + 26.0


def draw_rubbing(item: Rubbing, stage: PlaneStage, sheet: ScenePaper) -> None:
    """What holds wheels that rub: their hubs."""
    for ref in item.touches():
        if ref.owner in stage.model.held:
            sheet.hub(sheet.at(stage.bodies[ref.owner].spot(stage.model.axis(ref.owner))))


def draw_drive(item: MutualDrive, stage: PlaneStage, sheet: ScenePaper) -> None:
    """A motor on its carrier: a round arrow between them."""
    ref = item.drives[-1]
    body = stage.bodies[ref.owner]
    centre = sheet.at(body.place)
    sheet.figure.line(arc_points(centre, 7.0, -0.5, 4.2), THIN, heads=">")


def no_sign(item: Connection, stage: PlaneStage, sheet: ScenePaper) -> None:
    """What shows in the bodies themselves, or in the surface on which they lie."""


CONNECTIONS: dict[type[Connection], Callable[[Any, PlaneStage, ScenePaper], None]] = {
    String: draw_string,
    Spring: draw_spring,
    Belt: draw_belt,
    Drapes: draw_rope,
    Hinge: draw_hinge,
    Axle: draw_axle,
    Weld: draw_weld,
    Rides: draw_ride,
    PinSlot: draw_slot,
    Gear: draw_gear,
    Torsion: draw_torsion,
    Shaft: draw_shaft,
    Rubbing: draw_rubbing,
    MutualDrive: draw_drive,
    Touch: no_sign,
    Connection: no_sign,
}


def draw_connections(stage: PlaneStage, sheet: ScenePaper) -> None:
    """All connections, each by the nearest of its classes that has a row."""
    for item in stage.connections():
        draw = row_for(type(item), CONNECTIONS)
        if draw is not None:
            draw(item, stage, sheet)
