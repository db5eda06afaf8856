"""Borne on what is round: a plank on rollers, a ball on a drum or in it. Where they touch, the rim goes as v_centre + ω × r."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import ZERO, Formula, negate
from rotsolve.core.facts import Rule, square
from rotsolve.core.faults import Unsolvable
from rotsolve.core.limits import Limit
from rotsolve.core.vectors.heading import Heading, Vector, heading, vector
from rotsolve.elements.shapes import bow_of, rim_radius, rims, shape_of
from rotsolve.elements.surfaces import Curved, Dome, Hollow
from rotsolve.language.bodies import Body, PointRef
from rotsolve.language.elements import Connection, Moment, PlaceOf, Surroundings

if TYPE_CHECKING:
    from rotsolve.elements.connections.touch import Touch

HOLLOW = ("ring", "cylindrical shell", "spherical shell", "annulus")  # on which or in which something may lie
MIDDLE = (None, "center", "cm")


def check_on_top(item: Touch, scene: Surroundings) -> bool:
    """Whether what carries a body is round, and may; refused is what lies on a floor and on another body that lies on nothing."""
    ref, under = item.pair()[:2]
    carrier = scene.bodies[under.owner]
    if rim_radius(carrier, under.point) is not None:
        check_borne(item, scene)
        return True
    stands = any(other.touches()[0].point in ("start", "end") for other in laid_on(carrier.name, scene))
    if shape_of(carrier).slender and (stands or carrier.name in scene.held):
        message = f"`{ref.owner}` on the side of `{carrier.name}`, a rod that does not lie flat, is not solved yet"
        help = "a rod that leans is named first: on an edge, on the corner of a box, on something round"
        raise Unsolvable(message, span=under.span, help=help)
    if carrier.name in scene.held:
        raise Unsolvable(f"`{ref.owner}` on `{carrier.name}`, which turns, is not solved yet", span=under.span)
    if not item.rests(scene.bodies[ref.owner]):
        return False
    beds = (other.places()[0] for other in laid_on(ref.owner, scene) if other is not item)
    bed = next((place for place in beds if place.owner in scene.surfaces and not lies_uneven(place.owner, scene)), None)
    if bed is not None:
        message = (
            f"`{ref.owner}` lies on `{bed.owner}` as well as on `{carrier.name}`: which of them is on top is not told"
        )
        help = f"`contact: [{carrier.name}, {ref.owner}], friction: any` is a plank that lies on a roller"
        raise Unsolvable(message, span=under.span, help=help)
    return False


def rim_gone_round(item: Touch, bodies: Mapping[str, Body]) -> Curved | None:
    """The round body that a ball or a particle goes round, as a dome or a hollow of its radius."""
    own, under = item.pair()[:2]
    body, carrier = bodies.get(own.owner), bodies.get(under.owner)
    if body is None or carrier is None or (rim := carrying_rim(item, carrier)) is None:
        return None
    particle = body.shape is not None and shape_of(body).pointlike
    if not particle and rim_radius(body, own.point) is None:
        return None
    return Hollow(under.owner, rim) if item.on_inside() else Dome(under.owner, rim)


def carrying_rim(item: Touch, carrier: Body) -> Formula | None:
    """The radius at which a round body carries something: of a thick-walled one its inner one where that lies inside."""
    point = item.pair()[1].point
    inner = "inner" if item.on_inside() and point is None and "inner" in rims(carrier) else point
    return rim_radius(carrier, inner)


def fixed_axle(name: str, scene: Surroundings) -> bool:
    """Whether a body turns on a fixed axle through its centre."""
    held = [ref for item in scene.problem.connections for ref in item.fixed_points() if ref.owner == name]
    return any(ref.point in MIDDLE for ref in held)


def check_on_rim(item: Touch, surface: Curved, scene: Surroundings) -> None:
    """What goes round a body that turns on a fixed axle, or that rolls on a flat surface."""
    ref, under = item.pair()[:2]
    carrier = scene.bodies[under.owner]
    if item.on_inside() is None and shape_of(carrier).word in HOLLOW:
        message = f"whether `{ref.owner}` lies in `{under.owner}` or on it is not told"
        raise Unsolvable(message, span=under.span, help=f"`inside: true`, or `inside: false`, at `{item.name}`")
    if item.on_inside() and shape_of(carrier).word not in HOLLOW and carrier.shape is not None:
        message = f"`{ref.owner}` can not lie in `{under.owner}`, a {shape_of(carrier).word}"
        raise Unsolvable(message, span=under.span, help="what is hollow is a `ring` or a `cylindrical shell`")
    if under.owner in scene.held and not fixed_axle(under.owner, scene):
        message = (
            f"`{ref.owner}` on `{under.owner}`, which turns about another point than its centre, is not solved yet"
        )
        raise Unsolvable(message, span=under.span, help="solved is an axle through its centre")
    if carrier.parts or carrier.holes:
        message = f"`{ref.owner}` on `{under.owner}`, which is put together of parts, is not solved yet"
        raise Unsolvable(message, span=under.span, help="solved are uniform round bodies")
    item.check_curved(surface, scene)


def check_borne(item: Touch, scene: Surroundings) -> None:
    """A plank that stays parallel to what its rollers roll on, or level on rollers that turn on fixed axles; or what goes round a body."""
    ref, under = item.pair()[:2]
    plank, roller = scene.bodies[ref.owner], scene.bodies[under.owner]
    surface = rim_gone_round(item, scene.bodies)
    if scene.problem.plane == "horizontal":
        message = (
            f"`{ref.owner}` on `{under.owner}`, which turns, in a scene that is seen from above, is not solved yet"
        )
        raise Unsolvable(message, span=under.span)
    if surface is not None and len(item.pair()) == 2:
        return check_on_rim(item, surface, scene)
    if item.on_inside():
        raise Unsolvable(
            f"nothing tells how `{ref.owner}` lies in `{under.owner}`",
            span=ref.span,
            help="what lies inside is round, or a particle",
        )
    if len(item.pair()) > 2 or under.point not in (*MIDDLE, "rim", *rims(roller)):
        raise Unsolvable(f"`{ref.owner}` on `{under.owner}`, which turns, is not solved yet", span=under.span)
    if rim_radius(plank, ref.point) is not None or bow_of(plank, ref.point) is not None or plank.turns is not None:
        help = f"solved is a plank that does not turn on `{under.owner}`, as a rectangle"
        raise Unsolvable(f"`{ref.owner}`, which turns, on `{under.owner}` is not solved yet", span=ref.span, help=help)
    laid = laid_on(ref.owner, scene)
    told = plank.parts or (plank.shape is not None and shape_of(plank).backed and not shape_of(plank).pointlike)
    if ref.point is not None or not (told or len(laid) > 1):
        help = "a plank on it has `shape: rectangle` and its `sides`, and is named alone; what goes round it has `shape: particle`"
        message = f"how `{ref.owner}` lies on `{under.owner}`, which is round, nothing tells"
        raise Unsolvable(message, span=ref.span, help=help)
    check_rollers(item, laid, scene)


def check_rollers(item: Touch, laid: list[Connection], scene: Surroundings) -> None:
    """All rollers of a plank carry it equally high: of one size, where they roll on one surface."""
    ref, under = item.pair()[:2]
    beds: dict[str, tuple[str, Formula]] = {}
    for other in laid:
        place = other.places()[0]
        radius = rim_radius(scene.bodies[place.owner], place.point) if place.owner in scene.bodies else None
        if radius is None:
            message = f"`{ref.owner}` lies on `{under.owner}`, which is round, and on `{place.owner}`: how it stands then is not solved yet"
            raise Unsolvable(message, span=ref.span, help="solved is a plank on rollers alone")
        bed = bed_of(place, scene)
        name, first = beds.setdefault(bed, (place.owner, radius)) if bed else (place.owner, radius)
        if not is_zero(radius - first) and scene.signs.decide(radius - first) != 0:
            message = f"`{ref.owner}` does not lie level on `{name}` and `{place.owner}`, which are not equally large"
            raise Unsolvable(message, span=place.span, help="give both rollers one radius")


def bed_of(roller: PointRef, scene: Surroundings) -> str:
    """The one flat surface, or body, on which a roller rolls; '' of one on a fixed axle through its centre."""
    if fixed_axle(roller.owner, scene):
        return ""
    beds = [item.places()[0] for item in laid_on(roller.owner, scene)]
    flat = [bed for bed in beds if bed.owner not in scene.surfaces or not (lies_uneven(bed.owner, scene))]
    if len(beds) != 1 or not flat:
        message = f"on what `{roller.owner}` rolls, on which something lies, has to be told by one contact with a floor, a slope or a plank"
        raise Unsolvable(message, span=roller.span, help=f"`rolls: [{roller.owner}, floor]`, or an `axle` of its own")
    return flat[0].owner


def lies_uneven(name: str, scene: Surroundings) -> bool:
    """Whether a surface is curved or upright, so that nothing lies level on what rolls there."""
    return scene.surfaces[name].curved or scene.surfaces[name].upright


def laid_on(name: str, scene: Surroundings) -> list[Connection]:
    """The contacts by which a body lies on something."""
    return [item for item in scene.problem.connections if item.lying() == name]


def round_a_centre(rule: Rule, item: Touch, surface: Curved, instant: Moment) -> Rule:
    """Of what goes round the centre of a body that travels: (a − a_O) · n = ∓ v²/r, v across n as seen from that centre."""
    if not item.carrier(instant.configuration):
        return rule
    name, circle = instant.host(item.lying()), centre_circle(item, surface, instant)
    own, below = instant.motion(name), instant.motion(item.pair()[1].owner)
    facing = item.normal(surface, instant)
    centre = instant.hub(PointRef(item.pair()[1].owner))
    passing = (own.velocity - below.velocity_of(centre)).along(facing.turned(-90))
    inward = square(passing) / circle
    left, _ = rule.acceleration or (ZERO, ZERO)
    right = below.acceleration_of(centre).along(facing) + (negate(inward) if surface.outside else inward)
    velocity = own.velocity.along(facing), below.velocity_of(centre).along(facing)
    return replace(rule, velocity=velocity, acceleration=(left, right))


def arm_of_rim(under: PointRef, surface: Curved, facing: Heading, instant: Moment) -> Vector:
    """From the reference of a round body to where its rim touches what lies on it, or in it."""
    out = facing if surface.outside else facing.turned(180)
    return instant.hub(PointRef(under.owner)) + vector(surface.radius() or ZERO, out)


def place_round(item: Touch, surface: Curved, way: Heading, instant: Moment, place_of: PlaceOf) -> Formula | None:
    """Of what goes round a body that travels: from where the centre of that is, r along the touching radius."""
    if not item.travels(instant.configuration, instant.state):
        return None
    base = place_of(PointRef(item.pair()[1].owner, "center"))
    out = heading(item.touching_angle(instant))
    return None if base is None else base + centre_circle(item, surface, instant) * (out - way).cos()


def centre_circle(item: Touch, surface: Curved, instant: Moment) -> Formula:
    """The radius of the circle on which the centre of what lies on a round body goes."""
    ref = item.pair()[0]
    return surface.circle(rim_radius(instant.body(ref.owner), ref.point) or ZERO) or ZERO


def room_at_rim(item: Touch, rim: Formula, scene: Surroundings) -> Iterator[Limit]:
    """What lies in a round body is smaller than that."""
    surface = rim_gone_round(item, scene.bodies)
    if surface is not None:
        yield from surface.rooms(item.lying(), rim, False)
