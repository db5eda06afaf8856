"""Arrangement in space: what holds and carries each body, and where its points are in its own axes as it is drawn."""

from __future__ import annotations

from functools import cached_property
from itertools import chain

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula, add, multiply, negate, total
from rotsolve.core.faults import Span, Unsolvable
from rotsolve.core.remembered import remembered
from rotsolve.core.symbols import TIME
from rotsolve.core.vectors.tensor import InertiaTensor, displaced
from rotsolve.core.vectors.triple import (
    NOTHING,
    Triple,
    X,
    Y,
    Z,
    cross_product,
    is_axis,
    minus,
    tidied,
    triple,
    vector_sum,
    way_between,
)
from rotsolve.elements.shapes import rims, shape_of
from rotsolve.language.bodies import Body, Coupling, Joint, PointRef, Surface
from rotsolve.language.joints import joints_at
from rotsolve.language.problem import Problem
from rotsolve.language.shape import WHEEL
from rotsolve.motion.rigid import RigidPiece, part_spot, pieces

ANGLES = ("precession_angle", "tilt", "spin_angle")
RATES = ("precession", "nutation", "spin")
NODAL = (*ANGLES, *RATES, "axial_rate")
ABOUT_MOMENTUM = {"precession", "spin"}  # which a free body has about its angular momentum where no tilt is told
FASTER = {  # of what leads a body: what tells how fast it changes, and by how many derivatives by time
    "position": (("velocity", 1), ("acceleration", 2)),
    "velocity": (("acceleration", 1),),
    "angle": (("angular_velocity", 1), ("angular_acceleration", 2)),
    "angular_velocity": (("angular_acceleration", 1),),
}
SEVERAL_HELP = (
    "solved are two balls on the ground, a bar with a `ball` or a `collar` at each end, and a `universal` joint between two shafts; "
    "a hinge that two bearings hold has `bearings`"
)
ON_RIM = tuple(point for point in WHEEL if point != "center")  # places by the page, which a body turns under


class JointedBodies(Struct, frozen=True, dict=True):
    """The bodies of a scene in space with their joints at a state, where events bring some; refuses by name what it can't follow."""

    problem: Problem
    signs: SignOracle
    state: str = ""

    def vanishes(self, value: Formula) -> bool:
        """Whether a formula is nothing: whatever its letters are, or with the numbers that they have, which is noted.

        Of letters without a number it is nothing in a case that has such numbers, on the condition that it is.
        """
        if value == ZERO:
            return True
        lacking = bool(self.signs.lacking(value))
        number = self.signs.at_trial(value) if lacking else self.signs.number(value)
        if number is not None and number.sign:  # which costs less than to see it of a long formula
            return False
        if is_zero(value):
            return True
        nothing = number is not None and number.sign == 0
        return nothing and (self.signs.side_at_trial(value) if lacking else self.signs.decide(value)) == 0

    def since(self, state: str) -> JointedBodies:
        """The bodies with the joints that they have from a state on."""
        later = JointedBodies(self.problem, self.signs, state)
        return later if later.joints != self.joints else self

    @cached_property
    def bodies(self) -> dict[str, Body]:
        return {body.name: body for body in self.problem.bodies}

    @cached_property
    def joints(self) -> tuple[Joint, ...]:
        """All joints, in the order of the file; those that events have brought at last."""
        joints = joints_at(self.problem, self.state)
        for joint in joints:
            self.refuse_led(joint)
        return tuple(self.about_line(joint) for joint in joints)

    def about_line(self, joint: Joint) -> Joint:
        """A joint that holds two points as a hinge along the line through both."""
        if joint.through is None:
            return joint
        line = self.line_between(joint.body, joint.through)
        if line == NOTHING:
            message = f"`{joint.owner}` holds the same point of `{joint.body.owner}` twice"
            raise Unsolvable(message, span=joint.through.span, help="name two points that are apart")
        return replace(joint, turning=(self.pointed(line),))

    def refuse_led(self, joint: Joint) -> None:
        """Refuse a joint by which a body that is led along is carried by one that is not: what is led carries."""
        body, carrier = (self.bodies.get(ref.owner) for ref in (joint.body, joint.carrier))
        if body is not None and carrier is not None and body.moved and not carrier.moved:
            help = f"name what is led along first: `[{body.name}, {carrier.name}]`"
            message = f"`{body.name}` is led along, so that `{carrier.name}` can't carry it by `{joint.owner}`"
            raise Unsolvable(message, span=joint.body.span, help=help)

    def refuse_led_twice(self) -> None:
        """Refuse a motion told by a place and a rate which is not how that changes; a rate at one moment goes with any change of it."""
        led = [
            (body.name, body.span, [(word, axis, value) for word, axis, value in body.moved])
            for body in self.problem.bodies
        ]
        led += [
            (joint.owner, joint.body.span, [(word, "", value) for word, value in joint.drive]) for joint in self.joints
        ]
        for name, span, parts in led:
            told = {(word, axis): value for word, axis, value in parts}
            for (word, axis), value in told.items():
                for faster, times in FASTER.get(word, ()):
                    rate = told.get((faster, axis))
                    changed = value
                    for _ in range(times):
                        changed = differentiate(changed, TIME)
                    lasting = word in ("position", "angle") or TIME in value.symbols()
                    if rate is not None and lasting and not is_zero(changed - rate):
                        message = f"the `{word}` and the `{faster}` of `{name}` contradict each other"
                        raise Unsolvable(message, span=span, help=f"tell its `{word}` alone")

    def joint(self, name: str) -> Joint | None:
        return next((joint for joint in self.joints if joint.owner == name), None)

    def driven_evenly(self, joint: Joint) -> bool:
        """Whether a joint is driven with one angular velocity that stays, or an angle that grows evenly."""
        drive = dict(joint.drive)
        rate = differentiate(drive["angle"], TIME) if "angle" in drive else drive.get("angular_velocity")
        return len(drive) == 1 and rate is not None and is_zero(differentiate(rate, TIME))

    def of_body(self, name: str) -> tuple[Joint, ...]:
        """The joints that hold a body, those by which another carries it first."""
        own = [joint for joint in self.joints if joint.body.owner == name]
        return tuple(sorted(own, key=lambda joint: joint.rolls))

    def supports(self, name: str) -> tuple[Joint, ...]:
        """The joints that hold a point of a body, not those on which it only rolls."""
        return tuple(joint for joint in self.of_body(name) if not (joint.rolls or joint.flat))

    def held_on(self, name: str) -> str:
        """What a body is on, in words: a `screw`, an `axle`, the joints `l` and `r`."""
        words = {item.name: item.word for item in self.problem.events}
        words |= {item.name: item.spatial_word or item.word for item in self.problem.connections}
        own = [joint.owner for joint in self.supports(name)]
        if len(own) > 1:
            return f"the joints {' and '.join(f'`{owner}`' for owner in own)}"
        word = words[own[0]] if own else ""
        return f"{'an' if word[:1] in 'aeiou' else 'a'} `{word}`"

    def hinge_balls(self, name: str) -> tuple[Joint, ...]:
        """The two balls that hold a body to one thing, as a hinge does; none of others."""
        own = self.supports(name)
        same = len({joint.carrier.owner if joint.carrier.owner in self.bodies else "" for joint in own}) == 1
        return own if len(own) == 2 and same and all(joint.free and not joint.sliding for joint in own) else ()

    def link(self, name: str) -> tuple[Joint, ...]:
        """The two balls or collars that hold the ends of a bar which closes a linkage; none of others."""
        own = self.supports(name)
        return own if len(own) == 2 and all(joint.free for joint in own) and not self.hinge_balls(name) else ()

    @cached_property
    def links(self) -> tuple[str, ...]:
        """The bars that close linkages."""
        return tuple(name for name in self.bodies if self.link(name))

    @cached_property
    def couplings(self) -> tuple[Coupling, ...]:
        """The universal joints between shafts."""
        found = (item.coupling_in_space() for item in self.problem.connections)
        return tuple(coupling for coupling in found if coupling is not None)

    def tied(self, name: str) -> bool:
        """Whether a universal joint ties how a body turns to how another one does."""
        return any(name in (item.first.owner, item.second.owner) for item in self.couplings)

    @cached_property
    def closing(self) -> tuple[str, Span | None] | None:
        """What closes a linkage, by its name and place; None where all joints are those of open chains."""
        ends = next(((joint.owner, joint.body.span) for name in self.links for joint in self.link(name)[1:]), None)
        return ends or next(((item.owner, item.second.span) for item in self.couplings), None)

    def rolling(self, name: str) -> Joint | None:
        """The contact on which a body rolls that nothing else holds."""
        own = self.of_body(name)
        return own[0] if own and own[0].rolls and not self.supports(name) else None

    @remembered
    def main(self, name: str) -> Joint | None:
        """The joint about which a body turns: the one that holds a point of it, or two balls as a hinge along the line through both."""
        own = self.supports(name)
        if len(own) < 2 or self.link(name):
            return own[0] if own else None
        one, other = own[:2]
        if not self.hinge_balls(name):
            message = f"`{name}` is held by several joints: that is not solved in space yet"
            loose = next((joint for joint in own if joint.free and joint.carrier.owner in self.bodies), None)
            ends = () if loose is None else (named_ref(loose.body), named_ref(loose.carrier))
            help = f"name a bar that ends there last: `[{', '.join(ends)}]`" if ends else SEVERAL_HELP
            raise Unsolvable(message, span=other.body.span, help=help)
        if one.carrier.owner in self.bodies:
            message = f"two balls on `{one.carrier.owner}`, a body of its own, are not solved as a hinge in space"
            help = f"write `{one.owner}: {{hinge: [{one.carrier.owner}, …], along: [x, y, z]}}` along the line through both"
            raise Unsolvable(message, span=other.body.span, help=help)
        line = self.line_between(one.body, other.body)
        if line == NOTHING:
            message = f"`{one.owner}` and `{other.owner}` hold the same point of `{name}`"
            raise Unsolvable(message, span=other.body.span, help="leave one of them out")
        return replace(one, free=False, turning=(self.pointed(line),))

    def line_between(self, one: PointRef, other: PointRef) -> Triple:
        """The way from one point of a body to another, in the axes of the body; what vanishes by the numbers is left out, so that the laws
        know what lies along an axis."""
        line = tidied(way_between(self.spot(one), self.spot(other)))
        return triple([ZERO if self.vanishes(part) else part for part in line])

    def pointed(self, way: Triple) -> Triple:
        """A direction along an axis as that axis, where its sense is told."""
        sides = [self.signs.decide(part) if part != ZERO and is_axis(way) else 0 for part in way]
        if not is_axis(way) or None in sides:
            return way
        return triple([ZERO if not side else ONE if side > 0 else negate(ONE) for side in sides])

    def carried_by(self, name: str) -> set[str]:
        """The bodies that tell where a body is: what carries it, of a bar that closes a linkage at both its ends."""
        return {joint.carrier.owner for joint in self.link(name)} & self.bodies.keys() or {self.carrier(name)} - {""}

    def carrier(self, name: str) -> str:
        """The body that carries another; '' for what the ground holds, or nothing."""
        joint = self.main(name)
        return joint.carrier.owner if joint is not None and joint.carrier.owner in self.bodies else ""

    @cached_property
    def order(self) -> tuple[str, ...]:
        """The bodies, what carries others before these; a ring of them is refused."""
        done: list[str] = []
        pending = list(self.bodies)
        while pending:
            ready = [name for name in pending if self.carried_by(name) <= {*done}]
            if not ready:
                joint = self.main(pending[0])
                span = joint.body.span if joint is not None else None
                help = (
                    "name what is on the ground first, as in `[BODY.P, bar.end]`, where a bar joins it to another"
                    * bool(self.links)
                )
                raise Unsolvable("bodies that carry each other in a ring are not solved yet", span=span, help=help)
            done += ready
            pending = [name for name in pending if name not in ready]
        return tuple(done)

    @cached_property
    def nodding(self) -> frozenset[str]:
        """The bodies of which some state tells a tilt, or a rate about the vertical or their axis.

        Not those that nothing holds and of which the states tell no more than the rates about their angular momentum.
        """
        words: dict[str, set[str]] = {}
        for path in (line.path for state in self.problem.states for line in state.conditions):
            if path is not None and path.quantity in NODAL:
                words.setdefault(path.owner, set()).add(path.quantity)
        steady = any(state.steady for state in self.problem.states)
        return frozenset(
            name for name, told in words.items() if steady or self.of_body(name) or not told <= ABOUT_MOMENTUM
        )

    def named_point(self, name: str, point: str) -> PointRef:
        """A point of a body by its name, that at which it is held with its place: `at` of `rod.at(x)`."""
        joint = self.main(name)
        held = joint is not None and (joint.body.point or "center") == point
        return joint.body if joint is not None and held else PointRef(name, point)

    # places in a body's own axes, from its centre

    def spot(self, ref: PointRef) -> Triple:
        """Where a point of a body is in its own axes, from the centre of its shape."""
        body = self.bodies[ref.owner]
        named = dict(body.points)
        if ref.point in named:
            x, y, *rest = named[ref.point]
            return (x, y, rest[0] if rest else ZERO)
        if ref.point in (None, "center"):
            return NOTHING
        if ref.point == "cm":
            return self.centre(ref.owner)
        part = next((part for part in body.parts if part.body.name == ref.point), None)
        if part is not None:
            return part_spot(part)
        shape = shape_of(body)
        if ref.point in ON_RIM or ref.point in rims(body):
            help = f"give `{ref.owner}` a point of its own: `points: {{NAME: [x, y, z]}}`, in its own axes"
            raise Unsolvable(f"`{ref.point}` of `{ref.owner}` is no place on it in space", span=ref.span, help=help)
        if ref.point in shape.points or ref.argument is not None:
            x, y = shape.locate(ref.point or "center", ref.argument)
            return (x, y, shape.rise(ref.point or "center"))
        raise Unsolvable(f"where `{ref.owner}.{ref.point}` is in space nothing tells", span=ref.span)

    def surface(self, name: str) -> Surface | None:
        """A surface of the scene by its name; None of the ground and of a body."""
        return next((surface for surface in self.problem.surfaces if surface.name == name), None)

    def face(self, name: str) -> Formula | None:
        """How high above its centre the flat face of a body is that is square to its own z axis; None where it has none."""
        shape = shape_of(self.bodies[name])
        if self.bodies[name].parts or shape.pointlike or shape.slender:
            return None
        depth = shape.depth()
        return ZERO if shape.flat else None if depth is None else depth / 2

    def ball(self, name: str) -> bool:
        """Whether a body is a sphere, which touches a surface right below its centre however it is turned."""
        body = self.bodies[name]
        return shape_of(body).spherical and not (body.parts or body.holes)

    def even_ball(self, name: str) -> bool:
        """Whether a body is a ball of which the inertia is the same about all directions, so that it is constant in any axes."""
        even = self.ball(name) and self.whole_tensor(name) is not None
        return even and self.symmetric(name, X) and self.symmetric(name, Z)

    def pieces(self, name: str) -> tuple[RigidPiece, ...]:
        return pieces(self.bodies[name])

    def mass(self, name: str) -> Formula:
        own = self.pieces(name)
        return own[0].mass if len(own) == 1 else simplify(total([piece.mass for piece in own]))

    def centre(self, name: str) -> Triple:
        """The centre of mass in a body's own axes: Σ m r/Σ m."""
        own = self.pieces(name)
        if len(own) == 1:
            return own[0].place()
        whole, result = self.mass(name), NOTHING
        for piece in own:
            x, y, z = piece.place()
            share = (multiply(piece.mass, x), multiply(piece.mass, y), multiply(piece.mass, z))
            result = (add(result[0], share[0]), add(result[1], share[1]), add(result[2], share[2]))
        x, y, z = (part if part == ZERO else simplify(part / whole) for part in result)
        return (x, y, z)

    def reference(self, name: str) -> Triple:
        """The point about which a body turns, in its own axes: where its joint holds it, else its centre of mass."""
        joint = self.main(name)
        return self.centre(name) if joint is None else self.spot(joint.body)

    def arm(self, ref: PointRef) -> Triple:
        """A point from the reference of its body, in the body's own axes."""
        return tidied(way_between(self.reference(ref.owner), self.spot(ref)))

    def falls(self, name: str) -> bool:
        """Whether nothing but its weight acts on a body: then its centre of mass falls, however steadily it turns."""
        pushed = any(ref.owner == name for action in self.problem.actions for ref in action.touches())
        held = any(name in (joint.body.owner, joint.carrier.owner) for joint in self.joints)
        return self.problem.gravity is not None and not (pushed or held)

    @remembered
    def pointlike(self, name: str) -> bool:
        """Whether a body is a mere particle: what carries others, or is touched anywhere but at its centre, or by a couple, is turned by
        that.
        """
        body = self.bodies[name]
        whole = body.inertia is not None or body.gyration is not None or body.tensor is not None or bool(body.parts)
        if whole or not shape_of(body).pointlike or any(joint.carrier.owner == name for joint in self.joints):
            return False
        if any(action.twists() and name in (ref.owner for ref in action.touches()) for action in self.problem.actions):
            return False
        if self.tied(name):
            return False
        touched = [joint.body for joint in self.joints if not (joint.rolls or joint.flat)]
        touched += [ref for action in self.problem.actions for ref in action.touches()]
        return all(self.spot(ref) == NOTHING for ref in touched if ref.owner == name)

    def axis(self, name: str) -> Triple | None:
        """The direction in its own axes about which a body spins, as its `axis` tells, else that about which its inertia is symmetric.

        What has no inertia is symmetric about all of them: of that it is the axis of its shape, as a light rod's is along it.
        """
        body = self.bodies[name]
        if body.axis:
            x, y, z = body.axis
            return (x, y, z)
        shaped = (way for way in (Z, X, Y) if self.without_inertia(name) and self.shaped_about(name, way))
        return next(chain(shaped, (way for way in (Z, X, Y) if self.symmetric(name, way))), None)

    @remembered
    def without_inertia(self, name: str) -> bool:
        """Whether a body has no inertia about any axis."""
        tensor = self.whole_tensor(name)
        return tensor is not None and all(self.vanishes(tensor.entry(word)) for word in ("xx", "yy", "zz"))

    def shaped_about(self, name: str, way: Triple) -> bool:
        """Whether the shape of a body is symmetric about one of its own axes, whatever mass it has."""
        return all(map(is_zero, beside_axis(shape_of(self.bodies[name]).tensor(ONE), way)))

    def refuse_drawn_otherwise(self, body: Body) -> None:
        """Refuse an `axis` that is not that about which a shape is drawn: it tells which axis is meant, and turns nothing."""
        for part in (*body.parts, *body.holes):
            if part.body.axis:
                message = (
                    f"`axis` says nothing of a part, as of `{part.body.name}`: it is drawn along the axes of its shape"
                )
                raise Unsolvable(message, span=part.body.span, help="turn it by `turned: {about: y, by: 90 deg}`")
        drawn = shape_of(body).symmetry_axis
        if not (body.axis and drawn) or body.parts or body.holes or body.axis == {"x": X, "y": Y, "z": Z}[drawn]:
            return
        message = f"a {shape_of(body).word} is drawn about its own {drawn}, and `axis` names another one"
        raise Unsolvable(message, span=body.span, help="leave `axis` out; `turned: {about: y, by: 90 deg}` turns it")

    def symmetric(self, name: str, way: Triple) -> bool:
        """Whether the inertia of a body is the same about all directions across one of its own axes.

        Of a body of which only one moment of inertia is told that is the one about its axis.
        """
        return all(self.vanishes(gap) for gap in self.asymmetries(name, way))

    def asymmetries(self, name: str, way: Triple) -> list[Formula]:
        """What is nothing where a body is symmetric about one of its own axes: products, how far its centre is off, …"""
        tensor = self.whole_tensor(name)
        if tensor is None:
            return []
        beside = [part for part, own in zip(self.centre(name), way, strict=True) if own == ZERO]
        return [*beside_axis(tensor, way), *beside]

    def turns_round(self, name: str, axis: Triple) -> bool:
        """Whether a body is symmetric about an axis through the point about which it turns, so that its inertia is the same as it spins."""
        beside = cross_product(way_between(self.centre(name), self.reference(name)), axis)
        return self.symmetric(name, axis) and all(self.vanishes(part) for part in beside)

    def leans_round(self, joint: Joint) -> bool:
        """Whether turning a body about its hinge changes how its mass lies, or what it carries: it is not the same all round."""
        name = joint.body.owner
        along = [axis for axis, part in zip((X, Y, Z), joint.turning[0], strict=True) if part != ZERO]
        carried = (item for item in self.joints if item.carrier.owner == name)
        return not all(self.turns_round(name, axis) for axis in along) or any(self.off_line(joint, x) for x in carried)

    def off_line(self, joint: Joint, carried: Joint) -> bool:
        """Whether what a body carries is anything but a wheel about the line on which the body itself is hinged."""
        way, off = joint.turning[0], way_between(self.spot(joint.body), self.spot(carried.carrier))
        across = (cross_product(part, way) for part in (carried.turning[0], off)) if carried.aligned else ()
        return not (
            carried.aligned and self.wheel(carried.body.owner) and all(self.vanishes(x) for way in across for x in way)
        )

    @remembered
    def wheel(self, name: str) -> bool:
        """Whether an axle carries a body that is symmetric, put along it with its axis; refused by name where letters leave that open."""
        joint = self.main(name)
        if joint is None or not joint.aligned:
            return False
        if self.axis(name) is not None:
            return True
        for way in (Z, X, Y):
            self.refuse_open(name, way, joint)
        return False

    def refuse_open(self, name: str, way: Triple, joint: Joint) -> None:
        """Refuse a body of which letters leave open whether it is symmetric; in a case that is looked at it is supposed that it is not."""
        gaps = [gap for gap in self.asymmetries(name, way) if not self.vanishes(gap)]
        if any(self.signs.decide(gap) for gap in gaps):
            return
        if any(self.signs.side_at_trial(gap) for gap in gaps):
            self.askew[name, way] = gaps
            return
        message = f"whether `{name}` is symmetric, so that its axis lies along its axle, hangs on {self.open_letters(name, way)}"
        help = "give them numbers, or hold it as it is drawn by a `hinge`"
        raise Unsolvable(message, span=joint.body.span, help=help)

    def open_letters(self, name: str, way: Triple) -> str:
        """The letters on which it hangs whether a body is symmetric about one of its own axes; '' where it is told."""
        gaps = [gap for gap in self.asymmetries(name, way) if not self.vanishes(gap)]
        if any(self.signs.decide(gap) for gap in gaps):
            return ""
        mass = self.mass(name)
        names = {letter for gap in gaps for letter in simplify(gap if mass == ZERO else gap / mass).symbols()}
        return " and ".join(f"`{letter}`" for letter in sorted(names))

    @cached_property
    def askew(self) -> dict[tuple[str, Triple], list[Formula]]:
        """Bodies that are supposed not to be symmetric about one of their own axes, with what is nothing where they are."""
        return {}

    def whole_tensor(self, name: str) -> InertiaTensor | None:
        """The inertia tensor about the centre of mass, in givens alone; None where the scene tells no more than one moment of it."""
        body, result = self.bodies[name], InertiaTensor()
        centre = self.centre(name)
        if body.tensor is not None:
            told = centre if body.inertia_about is None else self.spot(PointRef(name, body.inertia_about))
            return body.tensor.plus(displaced(self.mass(name), way_between(told, centre)).times(negate(ONE)))
        for piece in self.pieces(name):
            if piece.tensor is None:
                return None
            x, y, z = vector_sum(piece.place(), minus(centre))
            result = piece.tensor.plus(displaced(piece.mass, (x, y, z)).plus(result))
        return result


def named_ref(ref: PointRef) -> str:
    """A point of a body as a scene names it."""
    return f"{ref.owner}.{ref.point}" if ref.point else ref.owner


def beside_axis(tensor: InertiaTensor, way: Triple) -> list[Formula]:
    """What is nothing where a tensor is symmetric about x, y or z."""
    one, other = {X: ("yy", "zz"), Y: ("zz", "xx"), Z: ("xx", "yy")}[way]
    return [tensor.entry(one) - tensor.entry(other), tensor.xy, tensor.yz, tensor.zx]
