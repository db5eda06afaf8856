"""Filming: the pictures of a scene in the plane at all moments of its motion, with labels that go along."""

from __future__ import annotations

import math

from rotsolve.draw.paper.figure import THIN, Figure, Label, Line, Point, ray, shifted_by
from rotsolve.draw.paper.reel import Reel, largest_of, moving_marks
from rotsolve.draw.plane.moving import MovingStage, Places, motion_scale
from rotsolve.draw.plane.places.bodies import Figured
from rotsolve.draw.plane.places.outlines import spun
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.draw.plane.scene import spans
from rotsolve.draw.plane.signs.ground import draw_surfaces
from rotsolve.draw.plane.signs.names import name_body
from rotsolve.draw.plane.signs.sheet import ScenePaper
from rotsolve.draw.plane.signs.ties import draw_connections

STAYS = 1.0  # points that something goes, at most, that stays where it is
AVOIDED = 12  # moments at which labels of what stays are kept clear of what comes by
VISIBLE = 1e-6  # radians of a turn that is one
SPOKE = 0.55  # from the middle of a round body to the mark that shows its turn, in its radius


def motion_pictures(stage: MovingStage, title: str, description: str) -> Reel:
    """The pictures of all moments of a motion."""
    scale, first = motion_scale(stage), stage.places()
    stage.decided |= {
        ("shrunk", item.name): 1.0 for item in stage.kinds.ropes
    }  # else what hangs from it would not keep pace
    base = ScenePaper(scale, title, description)
    draw_surfaces(stage, base)
    ground = list(base.figure.marks)
    turning = {name for ways in stage.motion.ways for name, way in ways.items() if abs(way.turn) > VISIBLE}
    sizes = [max(spans(body.bound())) for body in stage.bodies.values()]
    reel = Reel(title, description, [], [], [], largest_of(scale * size for size in sizes))
    for number in range(len(stage.motion.ways)):
        stage.set(number, first)
        figure = picture_now(number, stage, scale, turning)
        figure.marks = [*ground, *moving_marks(figure)]
        reel.pictures.append(figure.in_layers())
        stage.shown.append(stage.places())
    stage.restore(stage.shown[0])
    place_labels(reel, stage, base, stage.shown[0])
    for places in stage.shown:
        reel.shifts.append([label_shift(label, places, stage.shown[0], stage, scale) for label in reel.labels])
    return reel


def picture_now(number: int, stage: MovingStage, scale: float, turning: set[str]) -> Figure:
    """What moves, or is tied to what does, as it is now: without letters."""
    sheet = ScenePaper(scale)
    stage.braced.clear()
    stage.hanging, stage.holding = stage.motion.hanging[number], stage.motion.holding[number]
    draw_connections(stage, sheet)
    for body in stage.bodies.values():
        for outline in body.shown() if body.seen else ():
            sheet.outline(outline)
        if body.name in turning and body.seen:
            draw_spoke(body, sheet)
    return sheet.figure


def draw_spoke(body: Figured, sheet: ScenePaper) -> None:
    """A mark on a round body, by which its turn is seen."""
    whole = body.outlines[0]
    cuts = [outline.radius or 0.0 for outline in body.outlines if outline.cut]
    if not whole.radius or whole.cut:
        return
    middle, way = body.spot(whole.points[0]), ray(body.turn)
    inner = max(SPOKE * whole.radius, *cuts, 0.0)
    sheet.figure.line([sheet.at(shifted_by(middle, way, size)) for size in (inner, whole.radius)], THIN)


def place_labels(reel: Reel, stage: MovingStage, base: ScenePaper, first: Places) -> None:
    """The names of bodies that move, where the first picture has room; then those of what stays, and the letters of surfaces, clear
    of all that comes by."""
    going = {name for places in stage.shown for name in places if goes(stage.bodies[name], places, first, base.scale)}
    names = ScenePaper(base.scale)
    names.figure = Figure(marks=reel.pictures[0])
    for body in stage.bodies.values():
        name_body(body, stage, names if body.name in going else base)
    reel.labels += names.finished().labels
    number = len(reel.pictures)
    samples = sorted({round(k * (number - 1) / AVOIDED) for k in range(AVOIDED + 1)})
    passing = Figure(marks=[mark for k in samples for mark in reel.pictures[k]], labels=reel.labels)
    for k in samples:
        for label in reel.labels:
            passing.marks.append(framed(label, label_shift(label, stage.shown[k], first, stage, base.scale)))
    base.figure = passing
    base.finished()


def framed(label: Label, by: Point) -> Line:
    """The edge of the room of a label that has gone some way."""
    left, low, right, high = label.box
    corners = ((left, low), (right, low), (right, high), (left, high))
    return Line(tuple(shifted_by(corner, by) for corner in corners), THIN, closed=True)


def label_shift(label: Label, now: Places, first: Places, stage: PlaneStage, scale: float) -> Point:
    """How far a label has gone with its body: round that with a rod, beside which it stays so."""
    if label.tag not in now:
        return 0.0, 0.0
    body = stage.bodies[label.tag]
    x, y = middle_at(body, now)
    x0, y0 = middle_at(body, first)
    arm = (label.at[0] - scale * x0, label.at[1] - scale * y0)
    moved = arm if looks_round(body) else spun(arm, now[body.name][1] - first[body.name][1])
    return scale * (x - x0) + moved[0] - arm[0], scale * (y - y0) + moved[1] - arm[1]


def looks_round(body: Figured) -> bool:
    """Whether a body looks the same as it turns: a circle or a dot."""
    return bool(body.outlines) and body.outlines[0].radius is not None


def middle_at(body: Figured, places: Places) -> Point:
    """The middle of a round body where it stands, which may go round with it; the origin of others."""
    place, turn = places[body.name]
    return shifted_by(place, spun(body.outlines[0].points[0], turn)) if looks_round(body) else place


def goes(body: Figured, now: Places, first: Places, scale: float) -> bool:
    """Whether a body, and so its name, has gone from where it was at first."""
    turned = not looks_round(body) and abs(now[body.name][1] - first[body.name][1]) > VISIBLE
    return turned or math.dist(middle_at(body, now), middle_at(body, first)) * scale > STAYS
