"""Borne on what is round: a plank on rollers. Where it touches, a roller's rim goes as v_roller + ω × r, and the plank with it."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.faults import Unsolvable
from rotsolve.elements.shapes import bow_of, rim_radius, rims, shape_of
from rotsolve.language.bodies import PointRef
from rotsolve.language.elements import Connection, Surroundings

if TYPE_CHECKING:
    from rotsolve.elements.connections.touch import Touch

MIDDLE = (None, "center", "cm")


def check_borne(item: Touch, scene: Surroundings) -> None:
    """A plank that stays parallel to what its rollers roll on, or level on rollers that turn on fixed axles."""
    ref, under = item.pair()[:2]
    plank, roller = scene.bodies[ref.owner], scene.bodies[under.owner]
    if scene.problem.plane == "horizontal" or len(item.pair()) > 2 or under.point not in (*MIDDLE, "rim", *rims(roller)):
        raise Unsolvable(f"`{ref.owner}` on `{under.owner}`, which turns, is not solved yet", span=under.span)
    if rim_radius(plank, ref.point) is not None or bow_of(plank, ref.point) is not None or plank.turns is not None:
        help = f"solved is a plank that does not turn on `{under.owner}`, as a rectangle"
        raise Unsolvable(f"`{ref.owner}`, which turns, on `{under.owner}` is not solved yet", span=ref.span, help=help)
    laid = laid_on(ref.owner, scene)
    told = plank.parts or (plank.shape is not None and shape_of(plank).backed and not shape_of(plank).pointlike)
    if ref.point is not None or not (told or len(laid) > 1):
        help = f"give a plank that lies flat on it `shape: rectangle` and its `sides`, and name it alone: `{ref.owner}`"
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
    for item in scene.problem.connections:
        for ref in item.fixed_points():
            if ref.owner == roller.owner and ref.point in MIDDLE:
                return ""
    beds = [item.places()[0] for item in laid_on(roller.owner, scene)]
    flat = [bed for bed in beds if bed.owner not in scene.surfaces or not (bent(bed.owner, scene))]
    if len(beds) != 1 or not flat:
        message = f"on what `{roller.owner}` rolls, on which something lies, has to be told by one contact with a floor, a slope or a plank"
        raise Unsolvable(message, span=roller.span, help=f"`rolls: [{roller.owner}, floor]`, or an `axle` of its own")
    return flat[0].owner


def bent(name: str, scene: Surroundings) -> bool:
    """Whether a surface is curved or upright, so that nothing lies level on what rolls there."""
    return scene.surfaces[name].curved or scene.surfaces[name].upright


def laid_on(name: str, scene: Surroundings) -> list[Connection]:
    """The contacts by which a body lies on something."""
    return [item for item in scene.problem.connections if item.lying() == name]
