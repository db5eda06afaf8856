"""Posts: a rope that runs round a rough fixed post: it sticks to that, or slips, and then T₁ = T₂ e^(μ φ) (Euler's formula)."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from rotsolve.algebra.formula import ZERO, Formula, call
from rotsolve.core.derivation import NEXT, Words
from rotsolve.core.facts import BINDS, TAUT, Requirement, Summed
from rotsolve.core.faults import Unsolvable
from rotsolve.elements.connections.routing import Routing
from rotsolve.elements.connections.strings import String, is_post
from rotsolve.language.elements import Fact, Moment, Surroundings

if TYPE_CHECKING:
    from rotsolve.language.bodies import PointRef

EULER: Words = (
    "Where the rope goes on round the post by dθ, it presses on that with dN = T dθ.",
    NEXT,
    "Against the way in which it slips T grows by the friction μ dN: dT/T = μ dθ. Summed up that is T₁ = T₂ e^(μ φ).",
)


def check_round(item: String, scene: Surroundings) -> None:
    """A rope from one body round one post to another, with its friction and its angle."""
    posts = [ref for ref in item.string if is_post(ref, scene)]
    ends: tuple[PointRef, ...] = (item.string[0], item.string[-1])
    fits = len(item.string) == 3 and len(posts) == 1 and item.string[1] == posts[0]
    if not fits or any(ref.owner not in scene.bodies for ref in ends):
        message = f"`{item.name}` does not just run from one body round one post to another"
        help = "`string: [load, bollard, crate], friction: mu, wrap: 1/2 rev`, with `bollard: post` among the surfaces"
        raise Unsolvable(message, span=(posts or ends)[0].span, help=help)
    if scene.problem.events:
        message = f"events in a scene in which `{item.name}` runs round `{posts[0].owner}` are not solved"
        raise Unsolvable(message, span=posts[0].span, help="begin the scene behind them, with how all moves then")
    missing = [word for word in ("friction", "wrap") if getattr(item, word) is None]
    if missing:
        message = f"`{item.name}` runs round `{posts[0].owner}`, and has no `{missing[0]}`"
        raise Unsolvable(
            message, span=posts[0].span, help=f"give it `{missing[0]}`; a smooth peg is a pulley with `mass: 0`"
        )


def pace_past(course: Routing, *, acceleration: bool) -> Formula:
    """Speed of the rope towards its last end, that of the body there; or its acceleration."""
    leg = course.legs[-1]
    motion = course.instant.motion(leg.second.owner)
    rate = motion.acceleration_of(leg.arms[1]) if acceleration else motion.velocity_of(leg.arms[1])
    return rate.dot(leg.along)


def round_post(item: String, course: Routing, instant: Moment) -> Iterator[Fact]:
    """Two strands, each with a tension: tied to the post while the rope sticks, else one length, the tight side behind the slip."""
    first, last = course.strands()
    mode = instant.mode(item.name)
    tensions = [item.tension(strand, course) for strand in (first, last)]
    for strand, tension in zip((first, last), tensions, strict=True):
        yield Requirement(item.name, TAUT, tension, ZERO, "the string stays taut", "the string goes slack")
        for leg in strand:
            yield from item.pulls_of(leg, tension, instant, slips=mode.startswith("slips"))
    growth = growth_round(item)
    if mode.startswith("slips"):
        slack, tight = tensions[::-1] if mode.startswith("slips back") else tensions
        bodies = tuple(ref.owner for ref in (item.string[0], item.string[-1]))
        yield Summed(item.name, tight, slack * growth, "rope round the post, T₁ = T₂ e^(μ φ)", bodies, EULER)
        yield from item.rules(course.legs, instant)
        return
    for strand, tension, other in zip((first, last), tensions, tensions[::-1], strict=True):
        kept, otherwise = "the rope does not slip on the post", f"{item.name} slips"
        yield Requirement(item.name, BINDS, other * growth - tension, ZERO, kept, otherwise)
        yield from item.rules(strand, instant)


def growth_round(item: String) -> Formula:
    """By how much the tension is larger behind the post where the rope slips, e^(μ φ)."""
    return call("exp", (item.friction or ZERO) * (item.wrap or ZERO))


def verge_round(item: String, course: Routing) -> tuple[tuple[Formula, Formula, Formula], ...]:
    """T₁ = T₂ e^(μ φ), the one tension or the other the larger, with the smaller one."""
    one, two = (item.tension(strand, course) for strand in course.strands())
    return (two, one * growth_round(item), one), (one, two * growth_round(item), two)
