"""Lasting: what a steady state needs beyond its instant: what acts on a body that goes round goes round with it, and so does its place.

At one instant the laws allow rates that do not change under a force of fixed direction; at the next one that points another way in the axes
that go with the body. With Ω of these axes it takes Ω × F = 0, and of what rolls on a turning body v = Ω × r from the axis of that.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.formula import ZERO, Formula, add, negate
from rotsolve.core.drive import TRAVELLING, TURNING
from rotsolve.core.equation import RULE, Equation
from rotsolve.core.faults import Unsolvable
from rotsolve.core.letters import letters_of
from rotsolve.core.symbols import TIME, is_key
from rotsolve.core.vectors.triple import NOTHING, Triple, Z, cross_product, dot_product, rotated, scaled_by, way_between
from rotsolve.core.writing import spoken
from rotsolve.language.bodies import PointRef
from rotsolve.space.attitude import IN_SPACE
from rotsolve.space.inertia import CM
from rotsolve.space.moment import SpaceMoment
from rotsolve.space.pushes import ForceInSpace, Pushes

HELP = "leave `steady: true` out, or let it act along the axis about which that goes round"


def refuse_passing(name: str, moment: SpaceMoment, pushes: Pushes, acting: Sequence[ForceInSpace]) -> None:
    """Refuse a steady state of a body that lasts for an instant alone."""
    if not moment.state.steady or moment.held.bodies[name].moved:
        return
    refuse_ball(name, moment)
    if moment.nods(name):
        refuse_carried_round(name, moment)
    going = going_round(name, moment)
    if going == NOTHING:
        return
    refuse_growing(name, moment, pushes)
    told = {action.name: action for action in pushes.actions if not isinstance(action.strength(), str)}
    for push in (push for push in acting if push.owner in told and push.axes == IN_SPACE):
        for vector in (push.force, push.couple):
            if not all(map(moment.held.vanishes, cross_product(going, vector))):
                message = f"`{push.owner}` keeps its direction while `{name}` goes round: `{moment.when}` is not steady"
                raise Unsolvable(message, span=told[push.owner].touches()[0].span, help=HELP)
    weighs = pushes.gravity is not None and swings_about(name, moment)
    if weighs and not all(map(moment.held.vanishes, cross_product(going, Z))):
        message = f"the weight of `{name}` keeps its direction while that goes round: `{moment.when}` is not steady"
        help = "where it stays at rest write `balance: true` in place of `steady: true`"
        raise Unsolvable(message, span=moment.state.span, help=help)


def refuse_growing(name: str, moment: SpaceMoment, pushes: Pushes) -> None:
    """Refuse a steady state of what goes round while what acts on it, or the acceleration of what carries it, changes in time."""
    for action in pushes.actions:
        refs = action.touches()
        if TIME in letters_of(action) and any(ref.owner == name for ref in refs):
            message = f"`{action.name}` changes in time while `{name}` goes round: `{moment.when}` is not steady"
            raise Unsolvable(message, span=refs[0].span, help="leave `steady: true` out")
    for body in moment.held.bodies.values():
        for word, _, told in body.moved:
            rates = 3 - TRAVELLING.index(word) if word in TRAVELLING else 0
            if rates and not moment.held.vanishes(rate_of_change(told, rates)):
                message = f"the acceleration of `{body.name}` changes in time while `{name}` goes round: `{moment.when}` is not steady"
                raise Unsolvable(message, span=body.span, help="leave `steady: true` out")


def rate_of_change(told: Formula, times: int) -> Formula:
    """The derivative by time, so many times over."""
    return rate_of_change(differentiate(told, TIME), times - 1) if times else told


def refuse_left(first: SpaceMoment, last: SpaceMoment) -> None:
    """Refuse a steady state in which a body stands on its hinge, from which a later one has turned: nothing leads from one to the other."""
    for name in first.held.order:
        joint = first.held.main(name)
        if joint is None or not first.stands_on_carrier(name, joint):
            continue
        stood, line = first.told(name, "angle"), last.line(name, "angle")
        if stood is None or line is None or line.value is None or first.held.vanishes(add(line.value, negate(stood))):
            continue
        message = (
            f"`{name}` keeps its `angle` from `{first.when}` on, which is steady, and `{last.when}` tells another one"
        )
        help = "states follow one another in time: ask of each steady motion in a scene of its own"
        raise Unsolvable(message, span=line.span, help=help)


def refuse_ball(name: str, moment: SpaceMoment) -> None:
    """Refuse a steady state of a ball that rolls on a body that moves: its turning may stay while its centre is accelerated, or its
    velocity while it turns faster, and nothing tells which is meant."""
    joint = moment.held.rolling(name)
    if joint is not None and joint.carrier.owner in moment.held.bodies and moment.seen_from_space(name):
        message = f"what stays of `{name}`, which rolls on `{joint.carrier.owner}`, `steady: true` does not say"
        help = f"tell `{name}.angular_acceleration: [0, 0, 0]` or `{name}.acceleration: [0, 0, 0]`, or leave it out"
        raise Unsolvable(message, span=moment.state.span, help=help)


def refuse_carried_round(name: str, moment: SpaceMoment) -> None:
    """Refuse a steady precession at another rate than that at which what carries a body goes round, where its point is off the axis."""
    joint, carrier = moment.held.main(name), moment.held.carrier(name)
    led = [word in TURNING for word, _, _ in moment.held.bodies[carrier].moved] if carrier else []
    if joint is None or not carrier or moment.nods(carrier) or (led and not any(led)):
        return
    up, omega = moment.up(carrier), moment.attitude(carrier).omega
    if all(map(moment.held.vanishes, cross_product(up, moment.acceleration(joint.carrier)))):
        return
    rate, turning = moment.told(name, "precession"), dot_product(up, omega)
    along = all(map(moment.held.vanishes, cross_product(up, omega)))
    if rate is None or not along or not moment.held.vanishes(add(rate, negate(turning))):
        message = f"`{name}` precesses steadily at {moment.spoken_of()} only as `{carrier}` goes round, which carries its point along"
        raise Unsolvable(message, span=joint.body.span, help=f"tell `{name}.precession` as the rate of `{carrier}`")


def going_round(name: str, moment: SpaceMoment) -> Triple:
    """The angular velocity, in space, of the axes in which a steady body stays as it is: its node axes, those of what carries a wheel, or
    its own; a hinge that is driven turns on whatever acts."""
    if moment.nods(name):
        axes = moment.axes(name)
        return axes.to(IN_SPACE, axes.rate) if moment.nodding(name).rates[0] != ZERO else NOTHING
    joint = moment.held.main(name)
    if joint is None or joint.powered or joint.rolls:
        return NOTHING
    carried, round_ = joint.carrier.owner in moment.held.bodies, moment.held.wheel(name)
    if not carried and (not joint.turning or round_):
        return NOTHING
    if not carried:  # about an axis that stays, however the body stands
        axis = moment.direction(name, joint)
        rate = dot_product(axis, moment.attitude(name).omega)
        return scaled_by(rate, rotated(moment.turned(name), axis))
    own = moment.attitude(joint.carrier.owner if round_ or not joint.turning else name)
    return own.axes.to(IN_SPACE, own.omega)


def swings_about(name: str, moment: SpaceMoment) -> bool:
    """Whether its weight turns a body about its joint, or lets it slide."""
    joint = moment.held.main(name)
    return joint is not None and (bool(joint.sliding) or moment.arm(PointRef(name, CM)) != NOTHING)


def going_along(name: str, moment: SpaceMoment) -> Iterator[Equation]:
    """v = Ω × r of a wheel that rolls steadily on a turning body, from the axis of that; refused where what is told contradicts it."""
    joint = moment.held.rolling(name)
    if (
        not moment.state.steady
        or joint is None
        or joint.carrier.owner not in moment.held.bodies
        or not moment.nods(name)
    ):
        return
    from rotsolve.space.rolling import Rolling

    rolling = Rolling(joint, moment)
    if rolling.frame is None or rolling.frame.omega == NOTHING:
        return
    place = rolling.frame.axes.to(IN_SPACE, rolling.frame.place)
    asked = {given.name for given in moment.held.problem.givens if given.asked}
    for part in way_between(cross_product(going_round(name, moment), place), rolling.velocity()):
        words = f"{spoken(name)} goes round on {spoken(joint.carrier.owner)} as it precesses"
        if any(is_key(letter) or letter in asked for letter in part.symbols()):
            yield RULE.equation(part, ZERO, moment.when, (name,), words=words)
        elif not moment.held.vanishes(part):
            message = f"`{name}` goes round on `{joint.carrier.owner}` at another rate than it precesses: `{moment.when}` is not steady"
            raise Unsolvable(message, span=moment.state.span, help="leave `steady: true` out")
