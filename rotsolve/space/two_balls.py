"""Two balls that hold a body to the ground as a hinge along the line through both: the way between them, and axes along that line.

Forces along the line have no torque about it and may be moved along it, so that the laws tell only their sum (it is statically
indeterminate how they share it); what pushes across it they tell of each ball. Forces are therefore written along the line and across it.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from rotsolve.algebra.formula import ZERO
from rotsolve.core.derivation import Words
from rotsolve.core.equation import Equation
from rotsolve.core.faults import Unsolvable
from rotsolve.core.symbols import is_key, key_of
from rotsolve.core.vectors.triple import (
    AXES,
    NOTHING,
    Rows,
    Triple,
    X,
    Y,
    Z,
    after,
    cross_product,
    is_axis,
    length_of,
    rotated,
    tidied,
    transposed,
    triple,
    way_between,
)
from rotsolve.core.writing import spoken
from rotsolve.language.bodies import Joint
from rotsolve.space.arrangement import JointedBodies
from rotsolve.space.attitude import Axes

ON_LINE = "line"  # axes along the line and across it
LINE_NAMES = ("n", "u", "v")  # along the line, from the first ball to the second, and across it


def oblique_rows(way: Triple) -> Rows:
    """What turns components along a unit vector n, u and v into those along the axes in which n is told: v is one of these where n lies
    square to one, else u lies square to z."""
    square = next((axis for axis, part in zip((Z, Y, X), reversed(way), strict=True) if part == ZERO), None)
    if square is not None:
        return transposed((way, tidied(cross_product(square, way)), square))
    level = cross_product(Z, way)
    length = length_of(level)
    beside = triple([part if part == ZERO else part / length for part in level])
    return transposed((way, beside, tidied(cross_product(way, beside))))


def place_on_line(held: JointedBodies, joint: Joint) -> Triple | None:
    """Where one of two balls holds its body, from the first of them, in the axes of the body as it is drawn; None of other joints."""
    balls = held.hinge_balls(joint.body.owner)
    if not balls:
        return None
    return NOTHING if joint.owner == balls[0].owner else held.line_between(balls[0].body, balls[1].body)


def refuse_other_places(held: JointedBodies, name: str, drawn: Rows) -> None:
    """Refuse two balls that are told places which are not those of the points that they hold, as the body is drawn."""
    balls = held.hinge_balls(name)
    places = [triple(ball.carrier.place) for ball in balls if ball.carrier.place is not None]
    if len(places) < 2:
        return
    line = rotated(drawn, held.line_between(balls[0].body, balls[1].body))
    if not all(map(held.vanishes, way_between(line, way_between(*places)))):
        first, last = balls
        message = f"`{first.owner}` and `{last.owner}` are told places at which the points of `{name}` are not, as it is drawn"
        help = f"leave out the place of `{last.owner}`, or draw `{name}` so by `turned`"
        raise Unsolvable(message, span=last.body.span, help=help)


def axes_on_line(held: JointedBodies, name: str, own: Axes, way: Triple) -> Axes | None:
    """The axes along n, u and v of a body on two balls of which the line lies along none of its own axes; None of others."""
    if not held.hinge_balls(name) or is_axis(way):
        return None
    turned = oblique_rows(way)
    base = own.rows if own.base is None else own.base
    return Axes(ON_LINE, after(own.rows, turned), own.rate, own.change, own.lost, base, after(own.turned, turned))


def names_along(axes: Axes) -> tuple[str, str, str]:
    """The components of a force that is written along axes, as its letters have them."""
    return LINE_NAMES if axes.name == ON_LINE else AXES


def letter_along(axes: Axes, way: Triple) -> str:
    """Which component of such a force is that along the line."""
    if axes.name == ON_LINE:
        return LINE_NAMES[0]
    return next((name for name, part in zip(AXES, way, strict=True) if part != ZERO), "") if is_axis(way) else ""


def words_of_line(held: JointedBodies, used: Iterable[Equation]) -> Iterator[Words]:
    """Along which directions the forces of two balls are written, where their line lies along no axis of the body."""
    letters = {key_of(name) for law in used for name in law.symbols() if is_key(name)}
    for name in held.order:
        balls, main = held.hinge_balls(name), held.main(name)
        owners = {(ball.owner, component) for ball in balls for component in LINE_NAMES}
        if not balls or main is None or not any((key.owner, key.component) in owners for key in letters):
            continue
        first, last = (spoken(ball.owner) for ball in balls)
        along = next((axis for axis, part in zip("zyx", reversed(main.turning[0]), strict=True) if part == ZERO), "")
        beside = (
            f"v along {along} of {spoken(name)}, u = v × n"
            if along
            else f"u square to n and to z of {spoken(name)}, v = n × u"
        )
        yield (f"forces of {first} and {last}: n along the line from {first} to {last}, {beside}",)
