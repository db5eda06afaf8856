"""Sliding pairs: a body that slides along a direction of what carries it, with or without turning about it: slides, sleeves, screws.

With P the point of the carrier at which the body is, n the direction and u the rate of sliding, v = v_P + u n and
a = a_P + 2 Ω × u n + u̇ n (Goldstein, Poole & Safko, Classical Mechanics, §4.10). Nothing pushes along n; a screw goes u = s p/2π while it
turns at s, and gives no power: C·n + F·n p/2π = 0.
"""

from __future__ import annotations

from rotsolve.algebra.formula import ONE, PI, ZERO, Formula, add, multiply
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.triple import (
    NOTHING,
    Triple,
    cross_product,
    dot_product,
    is_axis,
    scaled_by,
    triple,
    unit_along,
    vector_sum,
    way_between,
)
from rotsolve.language.bodies import Joint, PointRef
from rotsolve.space.attitude import IN_SPACE, Axes, MovingBodies, TurnedBodies

TWO = 2 * ONE


def carrier_axes(joint: Joint, moment: TurnedBodies) -> Axes:
    """The axes of what carries a joint, as it is drawn."""
    carrier = joint.carrier.owner
    return moment.own_axes(carrier) if carrier in moment.held.bodies else IN_SPACE


def sliding_way(joint: Joint, moment: TurnedBodies) -> Triple:
    """The direction in which a joint lets its body slide, in the axes of the body."""
    way = unit_along(joint.sliding[0], moment.held.signs.positive)
    return carrier_axes(joint, moment).to(moment.axes(joint.body.owner), way)


def sliding_rate(joint: Joint, moment: MovingBodies, word: str) -> Formula:
    """How fast a body slides (`velocity`), or how fast that grows (`acceleration`): by its screw, as the state tells, else a letter."""
    name = joint.body.owner
    if joint.pitch is not None:
        return multiply(lead(joint.pitch), moment.driven(name, joint, "angular_velocity")[word == "acceleration"])
    if word == "velocity" and moment.rests(name):
        return ZERO
    told = moment.vector_told(name, word, joint.body.point) if joint.body.point else None
    if told is not None:
        return part_on_slide(joint, moment, word, told, NOTHING)
    told = None if joint.free else moment.vector_told(name, word)
    if told is not None:
        return part_on_slide(joint, moment, word, told, swung(joint, moment, word))
    if word == "acceleration" and moment.state.steady:
        return ZERO
    return moment.ask(word, joint.owner, "sliding", letter="u" if word == "velocity" else "udot")


def screwed(joint: Joint, moment: TurnedBodies, word: str) -> Formula | None:
    """How fast a screw turns (`velocity`), or how fast that grows (`acceleration`), where the state tells how the point that it holds goes
    along it: s = 2π u/p; None where it tells no such thing, or tells it otherwise than against what carries the screw."""
    name, carrier = joint.body.owner, joint.carrier.owner
    frame = carrier if carrier in moment.held.bodies else ""
    if joint.pitch is None or joint.body.point is None or not moment.told_against(name, word, joint.body.point, frame):
        return None
    told = moment.vector_told(name, word, joint.body.point)
    return None if told is None else part_on_slide(joint, moment, word, told, NOTHING) / lead(joint.pitch)


def swung(joint: Joint, moment: MovingBodies, word: str) -> Triple:
    """How the centre of mass of a body on a sleeve moves as it turns about the point that slides: s n × c, (ṡ n × + s n × s n ×) c."""
    name = joint.body.owner
    arm = way_between(moment.arm(joint.body), moment.arm(PointRef(name)))
    if not joint.turning or arm == NOTHING:
        return NOTHING
    way = unit_along(joint.sliding[0], moment.held.signs.positive)
    swinging = cross_product(way, moment.axes(name).to(carrier_axes(joint, moment), arm))
    rate, faster = moment.driven(name, joint, "angular_velocity")
    if word == "velocity":
        return scaled_by(rate, swinging)
    return vector_sum(scaled_by(faster, swinging), scaled_by(multiply(rate, rate), cross_product(way, swinging)))


def part_on_slide(
    joint: Joint, moment: TurnedBodies, word: str, told: tuple[Triple, str, str], turned: Triple
) -> Formula:
    """The part along its slide of a motion that a state tells of a body, which has the part `turned` across it; refused where it has
    another one.
    """
    name, carrier = joint.body.owner, joint.carrier.owner
    vector, _, relative = told
    line = moment.line(name, word, "x", joint.body.point) or moment.line(name, word, "x")
    span = None if line is None else line.span
    if relative != (carrier if carrier in moment.held.bodies else ""):
        raise Unsolvable(
            f"`{name}` slides along `{carrier}`: how fast is told relative to that",
            span=span,
            help=f"write `{f'{name}.{joint.body.point}' if joint.free else name}.{word} relative to {carrier}`",
        )
    way = unit_along(joint.sliding[0], moment.held.signs.positive)
    if not all(map(moment.held.vanishes, cross_product(way, way_between(turned, vector)))):
        whole = joint.body.point is None or moment.line(name, word, "x", joint.body.point) is None
        held = name if whole and turned == NOTHING else f"{name}.{joint.body.point}"
        help = "tell a vector along that"
        if whole and turned != NOTHING:
            help = f"tell how that point slides, `{held}.{word}: [x, y, z]`"
        raise Unsolvable(f"`{held}` can only slide along `{joint.owner}`", span=span, help=help)
    return dot_product(way, vector)


def drawn_place(joint: Joint, moment: MovingBodies) -> Triple:
    """Where the centre of mass of a body on a slide is as it is drawn, from where what carries it is held, in the axes of that."""
    held, name, carrier = moment.held, joint.body.owner, joint.carrier.owner
    off = way_between(held.spot(joint.body), held.centre(name))
    off = moment.own_axes(name).to(carrier_axes(joint, moment), off)
    if carrier not in held.bodies:
        return off if joint.carrier.place is None else vector_sum(triple(joint.carrier.place), off)
    return vector_sum(way_between(held.reference(carrier), held.spot(joint.carrier)), off)


def slid_to(joint: Joint, moment: MovingBodies) -> Formula | None:
    """How far a body has slid from where it is drawn, by where its state tells that it is on what carries it; None where it does not tell.

    Refused is a place off its slide.
    """
    name, carrier = joint.body.owner, joint.carrier.owner
    told = moment.vector_told(name, "position")
    if told is None or joint.pitch is not None:
        return None
    way = unit_along(joint.sliding[0], moment.held.signs.positive)
    off = way_between(drawn_place(joint, moment), told[0])
    against = told[2] == (carrier if carrier in moment.held.bodies else "")
    if not against or not all(map(moment.held.vanishes, cross_product(way, off))):
        line = moment.line(name, "position", "x")
        place = (
            f"`{name}.position relative to {carrier}: [x, y, z]`" if carrier in moment.held.bodies else "a place on it"
        )
        message = f"`{name}` can only be on `{joint.owner}`, and a state tells another place"
        raise Unsolvable(message, span=None if line is None else line.span, help=f"tell {place}")
    return dot_product(way, off)


def slid_since(joint: Joint, moment: MovingBodies) -> Formula:
    """The same, refused where nothing tells it."""
    found = slid_to(joint, moment)
    if found is not None:
        return found
    name, carrier = joint.body.owner, joint.carrier.owner
    told = f"{name}.position" + (f" relative to {carrier}" if carrier in moment.held.bodies else "")
    message = f"where `{name}` is on `{joint.owner}` at `{moment.when}` nothing tells"
    help = "ask at the first state, at which it is where it is drawn"
    help = help if joint.pitch is not None else f"tell `{told}: [x, y, z]` in that state"
    raise Unsolvable(message, span=joint.body.span, help=help)


def refuse_elsewhere(joint: Joint, moment: MovingBodies) -> None:
    """Refuse a place that the first state tells of a body on a slide and that is not the point of the carrier at which the slide has it."""
    name, carrier = joint.body.owner, joint.carrier.owner
    told = moment.vector_told(name, "position")
    if told is None or carrier not in moment.held.bodies:
        return
    there = moment.arm(joint.carrier)
    if told[2] != carrier or not all(map(moment.held.vanishes, way_between(there, told[0]))):
        line = moment.line(name, "position", "x")
        message = f"where `{name}` is on `{carrier}` is told by `{joint.owner}`, not by a state"
        help = f"give `{carrier}` a point there, `points: {{P: [x, y, z]}}`, and write `{joint.owner}: {{slide: [{carrier}.P, {name}]}}`"
        raise Unsolvable(message, span=None if line is None else line.span, help=help)


def slid(joint: Joint, moment: MovingBodies, word: str) -> Triple:
    """What sliding adds to the velocity or acceleration of the point of the carrier that is there, in the axes of the body."""
    name, carrier = joint.body.owner, joint.carrier.owner
    way, rate = sliding_way(joint, moment), sliding_rate(joint, moment, "velocity")
    if word == "velocity":
        return scaled_by(rate, way)
    along = scaled_by(sliding_rate(joint, moment, word), way)
    if carrier not in moment.held.bodies:
        return along
    turning = moment.attitude(carrier)
    swept = cross_product(turning.axes.to(moment.axes(name), turning.omega), scaled_by(rate, way))
    return vector_sum(along, scaled_by(TWO, swept))


def free_of_force(
    joint: Joint, moment: MovingBodies, force: Triple, couple: Triple
) -> tuple[Triple, tuple[Formula, ...]]:
    """The force of a sliding pair with no part along it, and what is nothing besides."""
    if not joint.sliding:
        return force, ()
    way = sliding_way(joint, moment)
    if joint.pitch is not None:
        return force, (add(dot_product(way, couple), multiply(lead(joint.pitch), dot_product(way, force))),)
    if not is_axis(way):
        return force, (dot_product(way, force),)
    x, y, z = (ZERO if own != ZERO else part for own, part in zip(way, force, strict=True))
    return (x, y, z), ()


def lead(pitch: Formula) -> Formula:
    """How far a screw goes in a turn by one radian."""
    return pitch / (2 * PI)


def moved_in(joint: Joint, moment: MovingBodies, word: str) -> Triple:
    """The velocity or acceleration of a body relative to what it slides along, in the axes of that."""
    way = unit_along(joint.sliding[0], moment.held.signs.positive)
    return scaled_by(sliding_rate(joint, moment, word), way)
