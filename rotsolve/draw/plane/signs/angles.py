"""Angles: those that a state tells, from the level or the upright from which their letters count."""

from __future__ import annotations

import math

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.vectors.heading import Heading, heading
from rotsolve.draw.paper.figure import AXIS, Point, ray, shifted_by
from rotsolve.draw.plane.places.kinds import curve_radius
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.draw.plane.signs.ground import told_words
from rotsolve.draw.plane.signs.sheet import ScenePaper
from rotsolve.elements.shapes import shape_of
from rotsolve.language.bodies import PointRef
from rotsolve.language.problem import Path

ARC, NEXT = 26.0, 9.0  # radius of the first arc of an angle, and how much larger the next one is


def straight_from(angle: Heading) -> tuple[int, Formula, int] | None:
    """The direction, in quarter turns, from which a letter alone measures an angle, the letter, and its sign."""
    if len(angle.terms) != 1 or angle.degrees % 90:
        return None
    value, factor = angle.terms[0]
    return (int(angle.degrees // 90), value, int(factor)) if factor in (1, -1) else None


def draw_angles(stage: PlaneStage, sheet: ScenePaper) -> None:
    """The angles that the state tells of bodies, from the level or the upright from which their letters count."""
    count: dict[str, int] = {}
    for line in stage.model.acting.state.conditions:
        path = line.path
        if path is None or path.quantity != "angle" or line.value is None:
            continue
        if path.owner in stage.bodies and path.point is None:
            body = stage.bodies[path.owner]
            vertex = sheet.at(body.spot(vertex_of(path.owner, stage)))
            rod = 2.4 * ARC if not shape_of(body.body).slender else 0.0
            draw_angle(line.value, vertex, ARC + NEXT * count.get(path.owner, 0), stage, sheet, long=rod)
        else:
            draw_contact_angle(path, line.value, stage, sheet)


def vertex_of(name: str, stage: PlaneStage) -> Point:
    """From where the angle of a body is seen: its hinge, the start of a rod, else its centre."""
    pivot = stage.model.pivot(name)
    if pivot is not None:
        return stage.model.drawn(pivot)
    body = stage.model.body(name)
    return stage.model.spot(PointRef(name, "start")) if shape_of(body).slender else (0.0, 0.0)


def draw_angle(
    value: Formula, vertex: Point, radius: float, stage: PlaneStage, sheet: ScenePaper, long: float = 0.0
) -> None:
    """An arc from the level or the upright to a direction; of a number from the level."""
    own = stage.value(value)
    found = straight_from(heading(value))
    if found is None:
        return
    quarters, part, _ = found
    words = told_words(stage, part)
    base = quarters * math.pi / 2
    if words is None and isinstance(part, Symbol):
        return
    if abs(own - base) < 0.02 or words is None:
        return
    sheet.figure.line([vertex, shifted_by(vertex, ray(base), radius + 14.0)], AXIS)
    if long:
        sheet.figure.line([vertex, shifted_by(vertex, ray(own), long)], AXIS)
    sheet.angle(vertex, radius, base, own, words)


def draw_contact_angle(path: Path, value: Formula, stage: PlaneStage, sheet: ScenePaper) -> None:
    """Where on a curved surface a body is: the angle at the centre of that."""
    for item in stage.kinds.contacts:
        if item.name != path.owner:
            continue
        if item.side is not None and item.side.bearer() in stage.bodies:
            under = stage.bodies.get(item.side.bearer())
        else:
            under = stage.bodies.get(item.pair()[1].owner)
        middles = [
            stage.middle(where) for surface, where in stage.surfaces.values() if curve_radius(surface) is not None
        ]
        for middle in middles if under is None else [under.place]:
            centre, body = sheet.at(middle), sheet.at(stage.bodies[item.lying()].place)
            sheet.figure.line([centre, body], AXIS)
            draw_angle(value, centre, ARC + 6.0, stage, sheet)
