"""Sides: a surface `of` a body is a side of that body and goes with it: what lies there goes with the body as well as along the side."""

from __future__ import annotations

from collections.abc import Container
from typing import Any

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.heading import Heading
from rotsolve.elements.shapes import rim_radius, shape_of
from rotsolve.language.bodies import Body, PointRef, Surface
from rotsolve.language.elements import Connection, Moment, SceneElements, Surroundings


class Sided(Connection, frozen=True):
    """Base of what may lay a body on a side of another: `side` is the surface that the scene declares `of` the body named last."""

    side: Surface | None = None

    def pair(self) -> tuple[PointRef, ...]:
        """The body's point and what it lies on."""
        return self.touches()

    def rests(self, body: Body) -> bool:
        """Whether a body lies or rolls there."""
        raise NotImplementedError

    def seen(self, scene: SceneElements, level: Container[str]) -> Connection:
        """A surface `of` a body is that body, touched at a side of its own."""
        own, under = self.pair()[:2]
        side = next((one for one in scene.surfaces if one.name == under.owner and one.bearer()), None)
        if side is None or len(self.pair()) > 2:
            return self
        changes: dict[str, Any] = {self.word: (own, replace(under, owner=side.bearer())), "side": side}
        return replace(self, **changes)

    def taken_aside(self, configuration: Surroundings, state: str) -> bool:
        """Whether it lies on a side of a body that does not travel along that side, so that it goes along no line."""
        if self.side is None or self.side.curved:
            return False
        line = configuration.line(self.carrier(configuration), state)
        return line is None or (line[0] - self.side.normal).cos() != ZERO

    def keeps_flat(self, instant: Moment) -> bool:
        """Whether it lies all the way on a flat side of a body that goes another way: what holds of rates there holds of ways."""
        lies = self.side is not None and not self.side.curved
        return lies and self.rests(instant.body(self.lying())) and instant.motion(self.lying()).kind == "plane"

    def slides_down(self, instant: Moment) -> Heading | None:
        return self.side.travel("down")[0] if self.side is not None and self.keeps_flat(instant) else None


def check_side_of(item: Sided, side: Surface, scene: Surroundings) -> None:
    """What has a side of its own travels along a line, or is moved as told, and does not turn; on it lies a particle or what is round."""
    ref, under = item.pair()[:2]
    body, bearer = scene.bodies[ref.owner], scene.bodies[under.owner]
    states = scene.throughout(item.name)
    led = all(scene.line(bearer.name, state) is not None for state in states) or bool(bearer.moved)
    if bearer.turns is not None or bearer.name in scene.held or any(scene.can_turn(bearer.name, at) for at in states):
        message = f"`{side.name}` is a side of `{bearer.name}`, which turns: that is not solved yet"
        raise Unsolvable(message, span=under.span, help="solved is a body that travels along a line")
    if not led:
        message = f"nothing tells how `{bearer.name}`, of which `{side.name}` is a side, travels"
        help = f"say on what `{bearer.name}` lies, `contact: [{bearer.name}, floor]`, or how it `moves`"
        raise Unsolvable(message, span=under.span, help=help)
    if not (item.rests(body) and (shape_of(body).pointlike or rim_radius(body, ref.point) is not None)):
        message = f"`{ref.owner}` on `{side.name}`, a side of `{bearer.name}`, is not solved yet"
        raise Unsolvable(message, span=ref.span, help="solved are particles, blocks without a shape, and round bodies")
    tracked = (one for at in states for one in scene.connections(at) if one.lying() == body.name)
    led = any(one.track(body, scene, states[0]) is not None for one in tracked)
    if body.moves is not None and not led:
        message = f"`{ref.owner}` goes with `{bearer.name}` as well as along `{side.name}`, not just {body.moves}"
        help = "leave `moves` out: its velocity has the components `velocity.x` and `velocity.y`"
        raise Unsolvable(message, span=body.span, help=help)
