"""Sides: a surface `of` a body is a side of that body and goes with it: what lies there goes with the body as well as along the side."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Protocol

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, Formula, add, negate
from rotsolve.core.facts import Rule, square
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.heading import RIGHT, TURNS, UP, Heading, Vector, heading, unit
from rotsolve.elements.shapes import rim_radius, shape_of
from rotsolve.elements.surfaces import Curved
from rotsolve.language.bodies import PointRef, Surface

if TYPE_CHECKING:
    from rotsolve.language.bodies import Body
    from rotsolve.language.elements import Moment, PlaceOf, Surroundings


class Laying(Protocol):
    """What lays a body on another one, as its side sees it."""

    @property
    def name(self) -> str: ...
    @property
    def side(self) -> Surface | None: ...
    def pair(self) -> tuple[PointRef, ...]: ...
    def lying(self) -> str: ...
    def carrier(self, configuration: Surroundings) -> str: ...
    def rests(self, body: Body) -> bool: ...
    def forward(self, instant: Moment) -> Heading: ...
    def check_curved(self, surface: Curved, scene: Surroundings) -> None: ...
    def ground(self, instant: Moment) -> tuple[Vector, Vector]: ...
    def touching_angle(self, instant: Moment) -> Formula: ...


OVER_THE_TOP = ("to the right over the top", "to the left over the top")


def goes_aside(item: Laying, configuration: Surroundings, state: str) -> bool:
    """Whether a body lies on a flat side of one that does not travel along that side, so that it goes along no line."""
    if item.side is None or item.side.curved:
        return False
    line = configuration.line(configuration.host(item.carrier(configuration), state), state)
    return line is None or (line[0] - item.side.normal).cos() != ZERO


def round_rules(item: Laying, stays: Rule, side: Curved, instant: Moment) -> Iterator[Rule]:
    """On a round side of a body v = V + u t, u the speed along it as seen from the body, and (a − A) · n = ∓ u²/ρ to its middle."""
    circle = circle_on(item, side, instant)
    words = OVER_THE_TOP if side.outside else TURNS
    along = instant.ask("velocity", item.name, when=instant.moving, words=words, letter="u")
    motion, sliding, (base, _) = instant.motion(item.lying()), unit(item.forward(instant)), item.ground(instant)
    right, up = (
        (motion.velocity.along(axis), add(base.along(axis), along * sliding.along(axis))) for axis in (RIGHT, UP)
    )
    yield Rule(item.name, f"{stays.label}, upwards", stays.bodies, up, None, linear=False)
    if circle is None or stays.acceleration is None or along == ZERO:
        yield replace(stays, velocity=right)
        return
    left, across = stays.acceleration
    inwards = square(along) / circle
    bends = left, add(across, negate(inwards) if side.outside else inwards)
    told = ("u²/ρ to the middle, u the speed along the side",)
    yield replace(stays, velocity=right, acceleration=bends, bent=told)


def place_on_side(item: Laying, side: Curved, way: Heading, instant: Moment, place_of: PlaceOf) -> Formula | None:
    """How far along a direction what goes round on a side of a body is, from where that is: ρ cos(φ − direction)."""
    base, circle = place_of(PointRef(item.pair()[1].owner, "cm")), circle_on(item, side, instant)
    if base is None or circle is None:
        return None
    level = side.base(circle) if way == UP else ZERO
    return base + level + circle * (heading(item.touching_angle(instant)) - way).cos()


def circle_on(item: Laying, side: Curved, instant: Moment) -> Formula | None:
    """The radius of the circle on which the middle of a body goes as seen from the body whose side it is on."""
    return side.circle(rim_radius(instant.body(item.lying()), item.pair()[0].point) or ZERO)


def check_carrier(item: Laying, scene: Surroundings) -> None:
    """What carries another body travels along a flat surface, or along the line that it `moves`, and does not turn."""
    ref, under = item.pair()[:2]
    carrier = scene.bodies[under.owner]
    flat = {name for name, surface in scene.surfaces.items() if not (surface.curved or surface.upright)}
    laid = (one for one in scene.problem.connections if one.lying() == carrier.name and one is not item)
    on_flat = any(one.places()[0].owner in (*flat, *scene.bodies) for one in laid)
    if carrier.turns is not None or rim_radius(carrier, None) is not None or len(item.pair()) > 2:
        raise Unsolvable(f"`{ref.owner}` on `{carrier.name}`, which turns, is not solved yet", span=under.span)
    if not carrier.parts and not shape_of(carrier).backed:
        message = (
            f"`{ref.owner}` on `{carrier.name}`, a {shape_of(carrier).word}: on which side it lies is not solved yet"
        )
        help = f"a side of it is a surface: `surfaces: {{side: {{slope: beta, of: {carrier.name}}}}}`; else solved is a level back"
        raise Unsolvable(message, span=under.span, help=help)
    level = [told == ZERO for _, component, told in carrier.moved if component == "y"]
    if not on_flat and carrier.moves not in ("left", "right") and not (level and all(level)):
        help = f"say on what `{carrier.name}` lies: `contact: [{carrier.name}, floor]`"
        message = f"nothing tells on what `{carrier.name}`, which carries `{ref.owner}`, travels"
        raise Unsolvable(message, span=under.span, help=help)


def check_side_of(item: Laying, side: Surface, scene: Surroundings) -> None:
    """What has a side of its own travels along a line, or is moved as told, and does not turn; on it lies a particle or what is round."""
    ref, under = item.pair()[:2]
    body, bearer = scene.bodies[ref.owner], scene.bodies[under.owner]
    states = scene.throughout(item.name)
    hosts = {state: scene.host(bearer.name, state) for state in states}
    lies = any(one.lying() == bearer.name for one in scene.problem.connections)
    led = lies or bool(bearer.moved) or all(scene.line(hosts[state], state) is not None for state in states)
    turns = any(scene.can_turn(hosts[at], at) or scene.pivot(hosts[at], at) is not None for at in states)
    if bearer.turns is not None or turns:
        message = f"`{side.name}` is a side of `{bearer.name}`, which turns: that is not solved yet"
        raise Unsolvable(message, span=under.span, help="solved is a body that travels along a line")
    if not led:
        message = f"nothing tells how `{bearer.name}`, of which `{side.name}` is a side, travels"
        help = f"say on what `{bearer.name}` lies, `contact: [{bearer.name}, floor]`, or how it `moves`"
        raise Unsolvable(message, span=under.span, help=help)
    if not (item.rests(body) and (shape_of(body).pointlike or rim_radius(body, ref.point) is not None)):
        message = f"`{ref.owner}` on `{side.name}`, a side of `{bearer.name}`, is not solved yet"
        raise Unsolvable(message, span=ref.span, help="solved are particles, blocks without a shape, and round bodies")
    if isinstance(side, Curved):
        item.check_curved(side, scene)
    tracked = (one for at in states for one in scene.connections(at) if one.lying() == body.name)
    if any(one.track(body, scene, states[0]) is not None for one in tracked):
        return
    check_untied(ref, side, scene)
    if body.moves is not None:
        message = f"`{ref.owner}` goes with `{bearer.name}` as well as along `{side.name}`, not just {body.moves}"
        help = "leave `moves` out: its velocity has the components `velocity.x` and `velocity.y`"
        raise Unsolvable(message, span=body.span, help=help)


def check_untied(ref: PointRef, side: Surface, scene: Surroundings) -> None:
    """Nothing ties what goes along a side as well as with its body to anything else: which way a string runs there is not told."""
    for other in scene.problem.connections:
        if not other.lying() and any(one.owner == ref.owner for one in other.touches()):
            message = f"`{other.name}` on `{ref.owner}`, which lies on `{side.name}`, a side of a body that moves, is not solved yet"
            raise Unsolvable(message, span=ref.span, help="solved are forces and couples on it, and what lies on it")
