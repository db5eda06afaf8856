"""Links: bars with a ball or a collar at each end, on different things, which close a linkage in space.

With r the way from the first end to the second, v₁ and v₂ their velocities as what holds them has them: the bar keeps its length,
r · (v₂ − v₁) = 0 and r · (a₂ − a₁) + |v₂ − v₁|² = 0. How it stands follows from where its ends are; it is thin and does not spin about r,
so that it turns at ω = r × (v₂ − v₁)/r², and α = r × (a₂ − a₁)/r² (Meriam & Kraige, Dynamics, chapter 7).
Across itself its moment of inertia is one and the same, so that L = I ω along the axes of space. A light one pushes along itself alone.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from msgspec import Struct

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula, add, negate
from rotsolve.core.equation import RULE, Equation
from rotsolve.core.faults import Unsolvable
from rotsolve.core.symbols import has_quantities
from rotsolve.core.vectors.tensor import InertiaTensor
from rotsolve.core.vectors.triple import (
    AS_DRAWN,
    AXES,
    NOTHING,
    Triple,
    X,
    Z,
    cross_product,
    dot_product,
    length_of,
    scaled_by,
    square_of,
    tidied,
    triple,
    unit_along,
    vector_sum,
    way_between,
)
from rotsolve.core.writing import spoken
from rotsolve.language.bodies import Joint, PointRef
from rotsolve.language.problem import State
from rotsolve.paths.meaning import NotYet
from rotsolve.space.arrangement import NODAL, JointedBodies
from rotsolve.space.attitude import IN_SPACE, Attitude
from rotsolve.space.inertia import entry_along, product
from rotsolve.space.moment import SpaceMoment
from rotsolve.space.places import apart_untold, point_in_space
from rotsolve.space.sliding import slid

TOLD_ELSEWHERE = (*NODAL, "vertical", "angle", "angular_velocity", "angular_acceleration")
PULL = "pull"  # along a light bar
SPUN = "how `{}` is turned about the line through its ends nothing tells"


class Link(Struct, frozen=True, dict=True):
    """A bar between two joints at a moment."""

    moment: SpaceMoment
    name: str
    ends: tuple[Joint, Joint]

    def drawn(self) -> Triple:
        """The way from its first end to its second in its own axes."""
        first, last = (self.moment.held.spot(joint.body) for joint in self.ends)
        return triple([simplify(part) for part in way_between(first, last)])

    def way(self) -> Triple:
        """The same in space, where its ends are held."""
        places = [self.place(joint) for joint in self.ends]
        return triple([self.moment.tidy(part) for part in way_between(*places)])

    def place(self, joint: Joint) -> Triple:
        """Where one of its ends is held, in space."""
        if joint.carrier.owner in self.moment.held.bodies:
            return point_in_space(self.moment, joint.carrier)
        return NOTHING if joint.carrier.place is None else triple(joint.carrier.place)

    def motion(self, joint: Joint, word: str) -> Triple:
        """The velocity or acceleration of one of its ends, as what holds it has it."""
        moment, carrier, moved = self.moment, joint.carrier.owner, NOTHING
        if carrier in moment.held.bodies:
            there = moment.velocity_there if word == "velocity" else moment.acceleration_there
            moved = moment.axes(carrier).to(IN_SPACE, there(carrier, moment.carried_at(joint)))
            moved = triple([moment.tidy(part) for part in moved])
        return vector_sum(moved, slid(joint, moment, word) if joint.sliding else NOTHING)

    def change(self, word: str) -> Triple:
        """v₂ − v₁, or a₂ − a₁."""
        return way_between(*(self.motion(joint, word) for joint in self.ends))

    def share(self, spot: Triple) -> Formula:
        """How far along the bar a point of it is, 0 at its first end and 1 at its second; refused is one beside the line."""
        drawn, off = self.drawn(), way_between(self.moment.held.spot(self.ends[0].body), spot)
        if not all(map(self.moment.held.vanishes, cross_product(drawn, off))):
            raise Unsolvable(SPUN.format(self.name), span=self.ends[1].body.span, help="speak of points on that line")
        return simplify(dot_product(drawn, off) / square_of(drawn))

    def part_way(self, spot: Triple, word: str) -> Triple:
        """The velocity or acceleration of a point of it: that of its first end, and its share of what the second has beside that."""
        share = self.share(spot)
        if share in (ZERO, ONE):
            return self.motion(self.ends[share == ONE], word)
        return vector_sum(self.motion(self.ends[0], word), scaled_by(share, self.change(word)))

    @property
    def light(self) -> bool:
        """Whether nothing but its ends acts on it, and it has no mass: then it pushes along itself alone."""
        held, name = self.moment.held, self.name
        acted = any(ref.owner == name for action in held.problem.actions for ref in action.touches())
        carries = any(joint.carrier.owner == name for joint in held.joints)
        return held.mass(name) == ZERO and held.without_inertia(name) and not (acted or carries)

    def pull(self) -> Triple:
        """The force of its second joint on a light bar: along the bar, as large as it takes, positive where that is pulled."""
        way, size = self.way(), self.moment.ask("force", self.name, letter="S", kind=PULL)
        return scaled_by(size / length_of(self.drawn()), way)


def link_at(moment: SpaceMoment, name: str) -> Link | None:
    """A bar that closes a linkage; None of other bodies."""
    ends = moment.held.link(name)
    return Link(moment, name, (ends[0], ends[1])) if ends else None


def link_attitude(link: Link) -> Attitude:
    """How a bar turns, along the axes of space, in which all that is told of it stays simple: ω is across it."""
    moment, name = link.moment, link.name
    refuse_link(link)
    still = moment.rests(name)
    omega = NOTHING if still else triple([moment.ask("angular_velocity", name, axis) for axis in AXES])
    rates = NOTHING
    if not (moment.state.steady or moment.state.balance):
        rates = triple([moment.ask("angular_acceleration", name, axis) for axis in AXES])
    return Attitude(IN_SPACE, AS_DRAWN, omega, rates)


def refuse_link(link: Link) -> None:
    """Refuse a bar that is told to stand or turn otherwise than by its ends, or that may spin about the line through them."""
    moment, name, body = link.moment, link.name, link.moment.held.bodies[link.name]
    lines = (line for line in moment.state.conditions if line.path is not None and line.path.owner == name)
    told = next((line for line in lines if line.path and line.path.quantity in TOLD_ELSEWHERE), None)
    if told is not None or body.turned:
        message = f"how `{name}` stands and turns follows from where its two ends are held, and how these move"
        what = "its `turned`" if told is None else "this line"
        raise Unsolvable(message, span=body.span if told is None else told.span, help=f"leave {what} out")
    refuse_apart_ends(link)
    drawn, tensor = link.drawn(), moment.held.whole_tensor(name)
    if drawn == NOTHING or tensor is None or not all(map(moment.held.vanishes, product(tensor, drawn))):
        help = "make it a thin `rod` held at both its ends, or leave its `mass` 0"
        raise Unsolvable(SPUN.format(name), span=link.ends[1].body.span, help=help)


def refuse_apart_ends(link: Link) -> None:
    """Refuse ends of which nothing tells how far they are apart: what is on the ground has to have places."""
    grounds = [moment_ground(link.moment.held, joint) for joint in link.ends]
    if grounds[0].owner == grounds[1].owner:
        return
    for joint in grounds:
        if joint.carrier.owner not in link.moment.held.bodies and joint.carrier.place is None:
            raise apart_untold(*grounds)


def moment_ground(held: JointedBodies, joint: Joint) -> Joint:
    """The joint by which what carries another one is held to the ground, or that by which what is free carries."""
    while (further := held.main(joint.carrier.owner) if joint.carrier.owner in held.bodies else None) is not None:
        joint = further
    return joint


def link_tensor(link: Link, own: InertiaTensor) -> InertiaTensor:
    """The moment of inertia of a bar across itself, about all axes: it does not turn about itself, so that L = I ω and dL/dt = I α."""
    across = cross_product(link.drawn(), Z)
    across = cross_product(link.drawn(), X) if across == NOTHING else across
    inertia = entry_along(own, tidied(unit_along(across, link.moment.positive)))
    return InertiaTensor(inertia, inertia, inertia)


def link_rules(moment: SpaceMoment) -> Iterator[Equation]:
    """What the ends of each bar ask of each other, and how it turns."""
    for name in moment.held.links:
        link = link_at(moment, name)
        assert link is not None
        yield from kept_length(link)
        own = moment.attitude(name)
        yield from turned_across(link, "velocity", own.omega, "ω = r × (v₂ − v₁)/l²")
        yield from turned_across(link, "acceleration", own.rates, "α = r × (a₂ − a₁)/l²")


def turned_across(link: Link, word: str, letters: Triple, said: str) -> Iterator[Equation]:
    """ω or α, by what its ends have against each other."""
    turned, size = cross_product(link.way(), link.change(word)), simplify(square_of(link.drawn()))
    for letter, part, axis in zip(letters, turned, AXES, strict=True):
        if letter != part:
            words = f"{spoken(link.name)} turns across itself, along {axis}"
            yield RULE.equation(letter, part / size, link.moment.when, (link.name,), (said,), words=words)


def kept_length(link: Link) -> Iterator[Equation]:
    """r² = l², and how that goes on; refused where the places of its ends are not so far apart."""
    moment, name, way = link.moment, link.name, link.way()
    sizes = simplify(square_of(way)), simplify(square_of(link.drawn()))
    if moment.held.problem.sought & (sizes[0].symbols() | sizes[1].symbols()):
        words = f"{spoken(name)} is as long as its ends are apart"
        yield RULE.equation(*sizes, moment.when, (name,), words=words)
    elif not moment.held.vanishes(gap := add(sizes[0], negate(sizes[1]))):
        raise ends_elsewhere(link, gap)
    speeds, faster = link.change("velocity"), link.change("acceleration")
    rates = dot_product(way, speeds), add(dot_product(way, faster), square_of(speeds))
    said = "r · (v₂ − v₁) = 0", "r · (a₂ − a₁) + |v₂ − v₁|² = 0"
    for along, formula, more in zip(rates, said, ("", " as it goes on"), strict=True):
        if has_quantities(along) or not moment.held.vanishes(along):
            words = f"{spoken(name)} keeps its length{more}"
            yield RULE.equation(along, ZERO, moment.when, (name,), (formula,), words=words)


def ends_elsewhere(link: Link, gap: Formula) -> Unsolvable:
    """That the places of its ends are not as far apart as a bar is long."""
    one, other = (joint.owner for joint in link.ends)
    message = f"`{one}` and `{other}` are not as far apart as `{link.name}` is long between them"
    if link.moment.signs.decide(gap) is None:
        message = f"whether `{one}` and `{other}` are as far apart as `{link.name}` is long hangs on letters"
    help = "write its `length` by their places, or one of these by the others; or leave one open, `x: unknown`"
    return Unsolvable(message, span=link.ends[1].body.span, help=help)


def refuse_in_course(held: JointedBodies, states: Sequence[State], *, functions: bool) -> None:
    """Refuse a closed linkage over several states, in a steady one and as time goes on: it is solved at one moment."""
    steady = next((state for state in states if state.steady and not state.balance), None)
    if len(states) > 1:
        raise beyond_one_moment(held, "moves from state to state")
    if functions or steady is not None:
        raise beyond_one_moment(held, "goes on in time" if functions else "moves steadily")


def beyond_one_moment(held: JointedBodies, what: str) -> NotYet:
    """That of a closed linkage only one moment is solved."""
    owner, span = held.closing or ("", None)
    message = f"`{owner}` closes a linkage in space: how that {what} is not solved yet"
    return NotYet(message, span, "ask for one moment, where its places and rates are told")


def point_of_link(moment: SpaceMoment, ref: PointRef) -> tuple[Link, Triple] | None:
    """A bar that closes a linkage, with the place of a point of it in its own axes; None of other bodies."""
    link = link_at(moment, ref.owner)
    return None if link is None else (link, moment.held.spot(ref))
