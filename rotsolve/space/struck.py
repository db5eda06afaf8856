"""Struck: what changes in no time: a blow J at r changes M v by J and L by r × J, those of joints as large as it takes.

An event that holds a point of a body, or makes two bodies one, brings a joint: its impulses are those of that, and all is told about the
point that is held from then on, where they have no arm (Goldstein, Poole & Safko, Classical Mechanics, §1.2).
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, Formula, Product, Symbol
from rotsolve.core.equation import BLOWS, MOMENTUM, RULE, TWISTS, UNTWISTED, Equation
from rotsolve.core.faults import Unsolvable
from rotsolve.core.symbols import is_key, key_of
from rotsolve.core.vectors.triple import (
    AXES,
    NOTHING,
    Triple,
    cross_product,
    dot_product,
    is_axis,
    minus,
    scaled_by,
    triple,
    unit_along,
    vector_sum,
    way_between,
)
from rotsolve.core.writing import point_in_words, spoken
from rotsolve.language.bodies import Joint, PointRef
from rotsolve.motion.timeline import Interval
from rotsolve.paths.meaning import NotYet
from rotsolve.space.attitude import IN_SPACE
from rotsolve.space.inertia import CM, product
from rotsolve.space.laws import SpaceLaws
from rotsolve.space.places import point_in_space
from rotsolve.space.sliding import free_of_force
from rotsolve.space.two_balls import names_along


class Shock(Struct, frozen=True):
    """An impulse on a body at an arm from its reference, and an angular impulse; `nothing` are sums of their parts that vanish, `across` is
    the part of the impulse that has a torque, where it is not the whole of it."""

    push: Triple
    arm: Triple
    twist: Triple = NOTHING
    nothing: tuple[Formula, ...] = ()
    across: Triple | None = None

    @property
    def torque_from(self) -> Triple:
        """The part of the impulse that has a torque."""
        return self.push if self.across is None else self.across


class Impact(Struct, frozen=True):
    """An event with what the laws speak of just before and just after it; all vectors are along the axes that a body has after it."""

    interval: Interval
    before: SpaceLaws
    after: SpaceLaws

    def outside(self, name: str) -> Shock | None:
        """What strikes a body from outside."""
        assert self.interval.event is not None
        found, moment = self.interval.event.blow_in_space(), self.after.moment
        if found is None or found[0].owner != name:
            return None
        ref, size, way = found
        return Shock(IN_SPACE.to(moment.axes(name), scaled_by(size, unit_along(way, moment.positive))), moment.arm(ref))

    @property
    def brought(self) -> Joint | None:
        """The joint that the event brings."""
        held = self.before.moment.held.joints
        return next((joint for joint in self.after.moment.held.joints if joint not in held), None)

    def seen_after(self, name: str, vector: Triple) -> Triple:
        """A vector along the axes that a body had before, along those that it has after: others where what holds it is another joint.

        Where nothing tells how it stands both are its own.
        """
        one, other = self.before.moment.axes(name), self.after.moment.axes(name)
        if one.rows == other.rows or (one.lost and other.lost):
            return vector
        return triple([self.after.moment.tidy(part) for part in one.to(other, vector)])

    def speeds(self, name: str) -> tuple[Triple, Triple]:
        """The velocity of the centre of mass, before and after."""
        centre = PointRef(name, CM)
        return self.seen_after(name, self.before.moment.velocity(centre)), self.after.moment.velocity(centre)

    def momentum_before(self, name: str) -> Triple:
        """L about the point about which it is told after: I ω, and r × M v of what was not held there."""
        place, point = self.after.about(name)
        if self.before.about(name)[1] == point:
            return self.seen_after(name, self.before.momentum(name, point))
        moment = self.after.moment
        spin = self.seen_after(name, product(self.before.tensor(name, CM), self.before.moment.attitude(name).omega))
        arm, (velocity, _) = way_between(place, moment.arm(PointRef(name, CM))), self.speeds(name)
        return vector_sum(spin, cross_product(arm, scaled_by(moment.held.mass(name), velocity)))


def through(interval: Interval, before: SpaceLaws, after: SpaceLaws) -> Iterator[Equation]:
    """What an event changes; a body that it does not touch moves on as it did."""
    from rotsolve.space.branches import struck_together

    blow, held = Impact(interval, before, after), after.moment.held
    refuse_distant(blow)
    refuse_still(blow)
    for name in held.order:
        if not held.bodies[name].moved:
            yield from laws_of_blow(name, blow)
    yield from struck_together(blow)


def laws_of_blow(name: str, blow: Impact) -> Iterator[Equation]:
    """M (v′ − v) = Σ J and L′ − L = Σ r × J of a body, about the point that its joint holds, else its centre of mass."""
    after, outside = blow.after, blow.outside(name)
    shocks = [*joint_shocks(name, after), *([outside] if outside is not None else [])]
    ways = [f", along {after.along(name, axis)}" for axis in AXES]
    yield from changes_of_travel(name, blow, shocks, ways)
    for part in (part for item in shocks for part in item.nothing):
        words = f"{spoken(name)} moves freely along or about its axis"
        yield RULE.equation(part, ZERO, blow.interval.name, (name,), words=words)
    if not after.moment.held.pointlike(name):
        yield from changes_of_turning(name, blow, shocks, ways)


def changes_of_travel(name: str, blow: Impact, shocks: Sequence[Shock], ways: list[str]) -> Iterator[Equation]:
    """M (v′ − v) = Σ J."""
    after = blow.after
    gained = scaled_by(after.moment.held.mass(name), way_between(*blow.speeds(name)))
    pushed, line = vector_sum(*(item.push for item in shocks)), after.pushes.line_axes(name)
    if line is not None:
        ways = [f", along {axis}" for axis in after.names_of(line)]
        pushed, gained = (
            triple([after.moment.tidy(part) for part in after.moment.axes(name).to(line, vector)])
            for vector in (pushed, gained)
        )
    for way, left, right in zip(ways, pushed, gained, strict=True):
        if left != right:
            law = BLOWS.equation(left, right, blow.interval.name, (name,))
            yield replace(law, label=law.label + way)


def changes_of_turning(name: str, blow: Impact, shocks: Sequence[Shock], ways: list[str]) -> Iterator[Equation]:
    """L′ − L = Σ r × J; L′ = L where no impulse has an arm about what is held from then on."""
    place, point = blow.after.about(name)
    first, last = blow.momentum_before(name), blow.after.momentum(name, point)
    turning = vector_sum(
        *(vector_sum(cross_product(way_between(place, item.arm), item.torque_from), item.twist) for item in shocks)
    )
    where, section = f" about {point_in_words(point)}", blow.interval.name
    brought = blow.brought is not None and blow.brought.body.owner == name
    for way, left, old, new in zip(ways, turning, first, last, strict=True):
        gained = vector_sum((new, ZERO, ZERO), minus((old, ZERO, ZERO)))[0]
        rate = lone_rate(gained) if left == ZERO else None
        if rate is not None:
            yield UNTWISTED.equation(rate, ZERO, section, (name,), about=where + way)
        elif left == ZERO and brought and old != new:
            words = f"angular momentum{where}{way}, {spoken(name)}: the impulse there has no arm"
            yield MOMENTUM.equation(old, new, section, (name,), words=words)
        elif left != gained:
            yield TWISTS.equation(left, gained, section, (name,), about=where + way)


def lone_rate(gained: Formula) -> Formula | None:
    """ω of what is a moment of inertia times ω: where no angular impulse acts, that is nothing, whatever the moment is."""
    if not isinstance(gained, Product) or len(gained.factors) != 2:
        return None
    kinds = {key_of(part.name).kind: part for part in gained.factors if isinstance(part, Symbol) and is_key(part.name)}
    return kinds.get("angular_velocity") if "inertia" in kinds else None


def joint_shocks(name: str, laws: SpaceLaws) -> Iterator[Shock]:
    """The impulse of the joint that holds a body, and those of what it carries, which push back."""
    moment, held = laws.moment, laws.moment.held
    for joint in (joint for other in held.order for joint in held.supports(other)):
        if joint.body.owner == name:
            yield from shocks_of_joint(joint, laws)
        elif joint.carrier.owner == name:
            axes, own, held_at = moment.axes(joint.body.owner), moment.axes(name), moment.arm(joint.body)
            for shock in shocks_of_joint(joint, laws):
                push, twist = (axes.to(own, minus(vector)) for vector in (shock.push, shock.twist))
                shift = axes.to(own, way_between(held_at, shock.arm))
                yield Shock(push, vector_sum(moment.carried_at(joint), shift), twist)


def shocks_of_joint(joint: Joint, laws: SpaceLaws) -> Iterator[Shock]:
    """The impulse of a joint on the body that it holds, or those of its two bearings: the first alone pushes along the axis too."""
    axis = laws.pushes.direction(joint)
    if not joint.bearings or axis is None:
        yield joint_shock(joint, laws)
        return
    held_at = laws.moment.arm(joint.body)
    for number, place in enumerate(joint.bearings, 1):
        push, nothing = laws.pushes.letters("impulse", joint, f"_{number}"), tuple[Formula, ...]()
        if number > 1 and is_axis(axis):
            push = triple([ZERO if way != ZERO else part for part, way in zip(push, axis, strict=True)])
        elif number > 1:
            nothing = (dot_product(axis, push),)
        driven = number == 1 and joint.powered
        twist = scaled_by(laws.moment.ask("angular_impulse", joint.owner, "drive"), axis) if driven else NOTHING
        yield Shock(push, vector_sum(held_at, scaled_by(place, axis)), twist, nothing)


def joint_shock(joint: Joint, laws: SpaceLaws) -> Shock:
    """The impulse of a joint on the body that it holds, at the point held, and its angular impulse across the axis."""
    moment = laws.moment
    line = laws.pushes.line_axes(joint.body.owner)
    push = laws.pushes.letters("impulse", joint, names=AXES if line is None else names_along(line))
    arm = laws.pushes.place(joint)
    if line is not None:
        own = moment.axes(joint.body.owner)
        return Shock(line.to(own, push), arm, across=line.to(own, (ZERO, *push[1:])))
    if joint.free or moment.held.pointlike(joint.body.owner):
        push, nothing = free_of_force(joint, moment, push, NOTHING)
        return Shock(push, arm, nothing=nothing)
    letters = triple([moment.ask("angular_impulse", joint.owner, axis) for axis in AXES])
    push, nothing = free_of_force(joint, moment, push, letters)
    way = laws.pushes.direction(joint) if joint.pitch is None else None
    if way is not None and not is_axis(way) and not joint.powered:
        nothing = (*nothing, dot_product(way, letters))
    elif way is not None and not joint.powered:
        letters = triple([ZERO if part != ZERO else letter for part, letter in zip(way, letters, strict=True)])
    return Shock(push, arm, letters, nothing)


# what an event can't mean


def refuse_distant(blow: Impact) -> None:
    """Refuse to join points that are known to be apart."""
    event = blow.interval.event
    pair = () if event is None else event.joined()
    try:
        places = [point_in_space(blow.before.moment, ref) for ref in pair]
    except (Unsolvable, NotYet):  # nothing tells where one of them is: then it is there
        return
    if pair and not all(map(blow.before.moment.held.vanishes, way_between(*places))):
        one, other = (f"{ref.owner}.{ref.point}" if ref.point else ref.owner for ref in pair)
        message = f"`{one}` and `{other}` are not at one place at `{blow.interval.start}`: they do not meet"
        raise Unsolvable(message, span=pair[0].span, help="check their places in that state, or leave one of them out")


def refuse_still(blow: Impact) -> None:
    """Refuse to hold a point that is at rest already: nothing happens to it."""
    joint, event = blow.brought, blow.interval.event
    if joint is None or event is None or event.joined():
        return
    ref, moment = joint.body, blow.before.moment
    velocity = moment.velocity(replace(ref, point=ref.point or "center"))
    if all(map(moment.held.vanishes, velocity)):
        name = f"{ref.owner}.{ref.point}" if ref.point else ref.owner
        message = f"`{name}` is at rest at `{blow.interval.start}`: that it is held changes nothing there"
        raise Unsolvable(message, span=ref.span, help="hold it by a `ball` or a `hinge` from the first state on")
