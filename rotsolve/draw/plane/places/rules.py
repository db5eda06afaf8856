"""Rules: what must be of the places in a scene, and what is wished, for each kind of connection."""

from __future__ import annotations

from rotsolve.confirm.forces import spring_way
from rotsolve.confirm.pose import StringPart, turned
from rotsolve.confirm.seating import joints_of
from rotsolve.confirm.signs import pointing
from rotsolve.draw.paper.figure import Point
from rotsolve.draw.plane.places.contacts import lay, lay_later
from rotsolve.draw.plane.places.equations import WISH, Place, gap_between_places, part_along, place_off, told_place
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.elements.connections.slots import PinSlot
from rotsolve.elements.connections.springs import Spring
from rotsolve.language.bodies import PointRef

DROP, APART = 2.0, 1.5  # of a string below its wheel, in blocks; between the wheels of a belt, in their radii
STRETCH = 3.0  # of a spring, in blocks
COMING = 0.35  # from what meets in an event to where that is, in the measure of the scene


def arrange(stage: PlaneStage) -> None:
    """Works out all places anew."""
    stage.begin()
    for contact in stage.kinds.contacts:
        lay(contact, stage)
    for string, number, leg in stage.legs():
        run(f"{string.name} {number}", leg, stage)
    for spring in stage.kinds.springs:
        lay_spring(spring, stage)
    for gear in stage.kinds.gears:
        wheels_beside(gear.gear[0], gear.gear[1], stage, inside=gear.inside)
    for belt in stage.kinds.belts:
        for first, second in zip(belt.belt, belt.belt[1:], strict=False):
            wheels_beside(first, second, stage, gap=APART)
    for slot in stage.kinds.slots:
        lay_slot(slot, stage)
    for wheels in stage.wheels:
        wheels_beside(*wheels, stage)
    lay_later(stage)
    join(stage)
    stage.settle()


def run(name: str, leg: StringPart, stage: PlaneStage) -> None:
    """A leg of a string runs straight along its direction, as long as looks well."""
    if leg.along is None:
        return
    first, second = (
        stage.leg_end(ref, side, leg.along) for ref, side in ((leg.first, leg.sides[0]), (leg.second, leg.sides[1]))
    )
    if first is None or second is None:
        return
    gap = gap_between_places(first, second)
    stage.layout.equal(part_along(gap, turned(leg.along)))
    stage.layout.equal(part_along(gap, leg.along), leg_length(name, leg, stage), WISH)


def leg_length(name: str, leg: StringPart, stage: PlaneStage) -> float:
    """As long as the wheels at its ends and a block below them need."""
    ends = [(leg.first, leg.sides[0], 1.0), (leg.second, leg.sides[1], -1.0)]
    radii = [stage.rim(ref) or 0.0 for ref, side, _ in ends if side]
    largest = [stage.rim(PointRef(ref.owner)) or 0.0 for ref, _, _ in ends]
    rooms = []
    for ref, _, sign in ends:
        if ref.owner in stage.bodies and leg.along is not None:
            rooms.append(stage.bodies[ref.owner].reach((sign * leg.along[0], sign * leg.along[1])))
    wishes = (DROP * stage.sizes.block, 1.1 * sum(radii), 1.2 * max(largest), 1.35 * sum(rooms))
    return stage.longer.get(name, 0.0) + max(wishes)


def lay_spring(item: Spring, stage: PlaneStage) -> None:
    """A spring between two bodies lies along its direction."""
    first, second = (stage.tied(ref) for ref in item.spring)
    if first is None or second is None or any(ref.place is not None for ref in item.spring):
        return
    way, gap = spring_way(item, stage.model), gap_between_places(first, second)
    stage.layout.equal(part_along(gap, turned(way)))
    long = stage.longer.get(item.name, 0.0) + STRETCH * stage.sizes.block
    stage.layout.equal(part_along(gap, way), long, WISH)


def lay_slot(item: PinSlot, stage: PlaneStage) -> None:
    """A pin is in the slot of another body: at the place that is told there, else in line with the middle of that."""
    if item.within.owner not in stage.bodies:
        return
    pin, within = stage.tied(item.pin), stage.tied(item.within)
    if pin is None or within is None:
        return
    if item.along is None:
        stage.layout.meet(pin, within)
        return
    way, gap = pointing(item.along, stage.model), gap_between_places(pin, within)
    stage.layout.equal(part_along(gap, turned(way)))
    stage.layout.equal(part_along(gap, way), 0.0, WISH)


def wheels_beside(
    first: PointRef, second: PointRef, stage: PlaneStage, *, gap: float = 1.0, inside: bool = False
) -> None:
    """Two wheels side by side, the second on the right: touching, or so many radii apart; the first on the right within the second."""
    radii = [stage.rim(ref) or stage.bodies[ref.owner].reach((1.0, 0.0)) for ref in (first, second)]
    apart = -abs(radii[0] - radii[1]) if inside else gap * sum(radii)
    if gap > 1.0:
        apart = max(apart, gap * sum(stage.bodies[ref.owner].reach((1.0, 0.0)) for ref in (first, second)))
    one, two = (stage.place_of(ref.owner, stage.model.spot(ref)) for ref in (first, second))
    x, y = gap_between_places(one, two)
    stage.layout.equal(x, apart)
    stage.layout.equal(y, 0.0)


# joints


def join(stage: PlaneStage) -> None:
    """Points of two bodies that are at one place; of a scene with places that are told the fixed axis is the origin."""
    meshing = [{ref.owner for ref in item.touches()} for item in (*stage.kinds.gears, *stage.kinds.belts)]
    coming = meetings_to_come(stage)
    met = [{one.owner, two.owner} for one, two, _ in stage.meetings()]
    for one, two, gone in stage.meetings():
        first, second = (stage.place_of(ref.owner, stage.model.drawn(ref)) for ref in (one, two))
        meet_soon(one, two, first, second, stage, gone)
    for one, two in joints_of(stage.model):
        pair = {one.owner, two.owner}
        if pair in meshing or pair in met or not pair <= set(stage.bodies):
            continue
        first, second = (stage.place_of(ref.owner, stage.model.drawn(ref)) for ref in (one, two))
        if pair in coming and not any(pair <= set(union) for union in stage.model.unions):
            meet_soon(one, two, first, second, stage)
        elif riding_pair(pair, stage):
            (ax, ay), (bx, by) = (stage.drawn_at(ref.owner) for ref in (one, two))
            stage.layout.meet(place_off(stage.origin(one.owner), (bx - ax, by - ay)), stage.origin(two.owner))
        else:
            stage.layout.meet(first, second)
    share_axles(stage)
    place_collars(stage)
    told = any(ref.place is not None for item in stage.model.acting.connections for ref in item.touches())
    for name, (_, ref) in stage.model.held.items() if told else ():
        stage.layout.meet(stage.place_of(name, stage.model.drawn(ref)), told_place(0.0, 0.0))


def place_collars(stage: PlaneStage) -> None:
    """What a spring from a place holds on its line: at the origin."""
    for spring in stage.kinds.springs:
        ends = [ref for ref in spring.spring if ref.owner in stage.bodies and ref.owner not in stage.model.held]
        if len(ends) == 1 and len([ref for ref in spring.spring if ref.place is not None]) == 1:
            stage.layout.meet(stage.place_of(ends[0].owner, stage.model.tied(ends[0])), told_place(0.0, 0.0))


def share_axles(stage: PlaneStage) -> None:
    """A point that goes round on the axle of a wheel has its circle about the middle of that; wheels on one axle are drawn side by side."""
    for item in stage.model.acting.connections:
        refs = [ref for ref in item.touches() if ref.owner in stage.bodies] if item.axial else []
        for ref in refs[1:]:
            if stage.bodies[ref.owner].dot:
                wheel, own = (stage.place_of(one.owner, stage.model.drawn(one)) for one in (refs[0], ref))
                stage.layout.meet(wheel, own)


def meetings_to_come(stage: PlaneStage) -> list[set[str]]:
    """The bodies that meet in events from this state on."""
    past = {event.name for event in stage.model.acting.joined()}
    events = [event for event in stage.model.problem.events if event.name not in past]
    return [{ref.owner for ref in event.points(stage.model.problem.connections)} for event in events]


def riding_pair(pair: set[str], stage: PlaneStage) -> bool:
    """Whether one of two bodies slides along the other."""
    rides = (item.ride() for item in stage.model.acting.connections)
    return any({ride.rider.owner, ride.carrier.owner} == pair for ride in rides if ride is not None)


def meet_soon(
    one: PointRef, two: PointRef, first: Place, second: Place, stage: PlaneStage, gone: Point | None = None
) -> None:
    """What will meet in an event stands a little before that, along its way; as far as the second has `gone` more than the first."""
    model = stage.model
    mover = one.owner if model.line(one.owner) is not None or one.owner not in model.held else two.owner
    way = model.line(mover) or (0.0, -1.0)
    sign = 1.0 if mover == one.owner else -1.0
    back: Point = (-way[0], -way[1])
    room = stage.bodies[one.owner].reach(way) + stage.bodies[two.owner].reach(back)
    room = 0.0 if stage.bodies[mover].dot else room
    little = -sign * COMING * stage.sizes.whole
    gone = gone or (little * way[0], little * way[1])
    for part, along, own in zip(gap_between_places(first, second), way, gone, strict=True):
        stage.layout.equal(part, sign * along * room - own, WISH)
