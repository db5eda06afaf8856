"""Readings: what a quantity of a question is in one world: vectors along the axes of space, then seen in the axes that are asked for."""

from __future__ import annotations

import math
from collections.abc import Callable

from msgspec.structs import replace

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.space.arrows import (
    ALONG,
    STILL,
    Arrow,
    Turned,
    arrow_length,
    crossed,
    inner_product,
    less,
    normed,
    rows_back,
    scaled,
    seen_from,
    sum_of,
    times_arrow,
)
from rotsolve.confirm.space.masses import about_point
from rotsolve.confirm.space.principal import moments_and_axes
from rotsolve.confirm.space.rig import AXES, NODAL
from rotsolve.confirm.space.ties import ROUND, SPEED, TURNING
from rotsolve.confirm.space.worlds import World
from rotsolve.core.quantity import DIRECTED, EITHER_WAY, INERTIAL
from rotsolve.language.bodies import PointRef
from rotsolve.language.grammar import ANGLE_OF
from rotsolve.language.problem import Path, Term

ENTRY = {axis: k for k, axis in enumerate(AXES)}
ENTRY_OF = {axis: k for k, axis in enumerate(ALONG)}
ROUNDING = 1e-9
STEADILY = 4e-15  # of ω²: what rounding alone makes of an angular acceleration


def angle_from(one: Arrow, other: Arrow) -> float:
    """The angle of an arrow from another one; NotConfirmed where one of them is nothing, which has no direction."""
    across, along = arrow_length(crossed(one, other)), inner_product(one, other)
    if across == along == 0.0:
        raise NotConfirmed("the direction of a vector that is nothing")
    return math.atan2(across, along)


class Reading:
    """Reads paths in one world."""

    def __init__(self, world: World) -> None:
        self.world = world
        self.stance, self.rig = world.stance, world.stance.rig
        self.now, self.found = world.now, world.found

    def number(self, term: Term) -> float:
        """A component, a size or a scalar."""
        path = term.path
        if term.modifier == ANGLE_OF and term.other is not None:
            one, two = self.vector(path, term), self.vector(term.other.path, term.other)
            angle = angle_from(one, two)
            free = {path.quantity, term.other.path.quantity}.intersection(EITHER_WAY)
            return min(angle, math.pi - angle) if free else angle
        if path.quantity in DIRECTED:
            vector = self.seen(term)
            last = (path.component or "").split()[-1:]
            return vector[ENTRY[last[0]]] if last and last[0] in ENTRY else arrow_length(vector)
        return self.scalar(term)

    def size(self, term: Term) -> float:
        """What rounding of a number is beside: of a component its whole vector."""
        directed = term.path.quantity in DIRECTED and term.modifier != ANGLE_OF
        return max(arrow_length(self.vector(term.path, term)) if directed else abs(self.number(term)), ROUNDING)

    def seen(self, term: Term) -> Arrow:
        """A vector in the axes that a question names, those of space where it names none."""
        vector = self.vector(term.path, term)
        if not term.path.owner:
            return vector
        rows = self.axes(term.axes or "", self.body_of(term.path))
        return times_arrow(rows_back(rows), vector)

    def axes(self, word: str, name: str) -> Turned:
        if word in ("", "space"):
            return ALONG
        if word == "node":
            return self.node_axes(name)
        return self.stance.turned(name if word == "body" else word)

    def node_axes(self, name: str) -> Turned:
        if not self.stance.lines.nods(name):
            raise NotConfirmed(f"`{name}` has no line of nodes that the state tells")
        return self.stance.node_axes(name)

    def body_of(self, path: Path) -> str:
        """The body of a path, of a connection or action that on which it acts."""
        if path.owner in self.rig.bodies:
            return path.owner
        if path.owner in self.rig.joints:
            return self.rig.joints[path.owner].body.owner
        if path.owner in self.rig.couplings:
            return self.rig.couplings[path.owner].second.owner
        for action in self.rig.problem.actions:
            if action.name == path.owner:
                return action.touches()[0].owner
        raise NotConfirmed(f"`{path.quantity}` of the whole scene")

    def vector(self, path: Path, term: Term) -> Arrow:
        """A vector along the axes of space."""
        if term.relative is not None and path.quantity not in ("force", "velocity", "acceleration"):
            raise NotConfirmed(f"`{path.quantity}` relative to a body")
        of_all = not path.owner and path.quantity in ("momentum", "angular_momentum")
        table = VECTORS_OF_BODIES if of_all or path.owner in self.rig.bodies else VECTORS_OF_ELEMENTS
        reading = table.get(path.quantity)
        if reading is None:
            raise NotConfirmed(f"`{path.quantity}` in space")
        return reading(self, path, term)

    # motion

    def omega(self, name: str) -> Arrow:
        return self.now.arrow(TURNING, name)

    def angular_velocity(self, path: Path, term: Term) -> Arrow:
        return self.omega(path.owner)

    def angular_acceleration(self, path: Path, term: Term) -> Arrow:
        return self.found.arrow(TURNING, path.owner)

    def arm(self, path: Path) -> Arrow:
        return self.stance.arm(PointRef(path.owner, path.point or "cm", path.argument))

    def velocity_at(self, name: str, arm: Arrow) -> Arrow:
        return sum_of(self.now.arrow(SPEED, name), crossed(self.omega(name), arm))

    def acceleration_at(self, name: str, arm: Arrow) -> Arrow:
        omega = self.omega(name)
        turning = crossed(self.found.arrow(TURNING, name), arm)
        return sum_of(self.found.arrow(SPEED, name), turning, crossed(omega, crossed(omega, arm)))

    def velocity(self, path: Path, term: Term) -> Arrow:
        absolute = self.velocity_at(path.owner, self.arm(path))
        if term.relative is None:
            return absolute
        return less(absolute, self.velocity_at(term.relative, self.from_frame(path, term.relative)))

    def acceleration(self, path: Path, term: Term) -> Arrow:
        """Relative to a frame: a − a_frame − 2 Ω × v_rel, a_frame that of the point of the frame that is there."""
        absolute = self.acceleration_at(path.owner, self.arm(path))
        if term.relative is None:
            return absolute
        carried = self.acceleration_at(term.relative, self.from_frame(path, term.relative))
        coriolis = scaled(2.0, crossed(self.omega(term.relative), self.velocity(path, term)))
        return less(less(absolute, carried), coriolis)

    def from_frame(self, path: Path, frame: str) -> Arrow:
        """A point from the centre of mass of a frame."""
        place = sum_of(self.stance.place(path.owner), self.arm(path))
        return less(place, self.stance.place(frame))

    def position(self, path: Path, term: Term) -> Arrow:
        return sum_of(self.stance.place(path.owner), self.arm(path))

    def momentum(self, path: Path, term: Term) -> Arrow:
        """M v of the centre of mass; without a body the sum over all."""
        names = [path.owner] if path.owner else list(self.rig.bodies)
        return sum_of(*(scaled(self.rig.solid(name).mass, self.now.arrow(SPEED, name)) for name in names))

    # about points

    def about(self, name: str, term: Term) -> Arrow:
        """The point about which something is asked, from the centre of mass: that held at rest where none is named, else that centre."""
        if term.about is None:
            joint = self.rig.on_ground(name)
            return STILL if joint is None else self.stance.arm(joint.body)
        joint = self.rig.joints.get(term.about.owner)
        ref = joint.body if joint is not None else term.about
        if ref.owner in self.rig.bodies:
            place = sum_of(self.stance.place(ref.owner), self.stance.arm(ref))
        else:
            place = STILL if ref.place is None else self.rig.arrow(ref.place)
        return less(place, self.stance.place(name))

    def angular_momentum(self, path: Path, term: Term) -> Arrow:
        """I ω + r × m v of the centre of mass; without a body the sum over all."""
        if not path.owner:
            return sum_of(*(self.angular_momentum(replace(path, owner=name), term) for name in self.rig.bodies))
        name = path.owner
        if path.point is not None:
            raise NotConfirmed("the angular momentum of a part")
        about = self.about(name, term)
        spin = times_arrow(self.world.efforts.tensor(name), self.omega(name))
        momentum = scaled(self.rig.solid(name).mass, self.now.arrow(SPEED, name))
        return sum_of(spin, crossed(scaled(-1.0, about), momentum))

    def torque(self, path: Path, term: Term) -> Arrow:
        which, about, total = self.which(path), self.about(path.owner, term), STILL
        for item in self.world.efforts.on(path.owner):
            if which in ("net", item.owner):
                total = sum_of(total, item.torque_at(self.found, about))
        return total

    def which(self, path: Path) -> str:
        """Whose force or torque is asked: `net`, or a name."""
        first = (path.component or "net").split()[0]
        return "net" if first in AXES else first

    def force(self, path: Path, term: Term) -> Arrow:
        which, total = self.which(path), STILL
        if which in INERTIAL:
            return self.inertial(path, term, which)
        for item in self.world.efforts.on(path.owner):
            if which in ("net", item.owner):
                total = sum_of(total, item.force_at(self.found))
        return total

    def inertial(self, path: Path, term: Term, which: str) -> Arrow:
        """−m Ω × (Ω × r), −m Ω̇ × r, −2 m Ω × v, of the centre of mass; r from where the frame is held, or its centre of mass."""
        frame = term.relative or next(
            (line.relative for line in self.stance.lines.of(path.owner) if line.relative), None
        )
        guide = self.rig.main(path.owner)
        if frame is None and guide is not None and guide.sliding and guide.carrier.owner in self.rig.bodies:
            frame = guide.carrier.owner
        if frame is None:
            raise NotConfirmed(f"the {which} force in which frame")
        held = self.rig.main(frame)
        arm = less(self.from_frame(path, frame), STILL if held is None else self.stance.arm(held.body))
        term = replace(term, relative=frame)
        turning, mass = self.omega(frame), self.rig.solid(path.owner).mass
        if which == "centrifugal":
            return scaled(-mass, crossed(turning, crossed(turning, arm)))
        if which == "euler":
            return scaled(-mass, crossed(self.found.arrow(TURNING, frame), arm))
        return scaled(-2.0 * mass, crossed(turning, self.velocity(path, term)))

    # of joints and actions

    def joint_force(self, path: Path, term: Term) -> Arrow:
        """On the body that it holds; of one of its bearings."""
        total, name = STILL, self.body_of(path)
        for item in self.world.efforts.on(name):
            if item.owner == path.owner and not item.back and path.point in (None, item.bearing):
                total = sum_of(total, item.force_at(self.found))
        return total

    def joint_torque(self, path: Path, term: Term) -> Arrow:
        total, name, joint = STILL, self.body_of(path), self.rig.joints.get(path.owner)
        about = self.about(name, term)
        if term.about is None and joint is not None and not joint.rolls:
            about = self.stance.arm(joint.body)
        for item in self.world.efforts.on(name):
            if item.owner == path.owner and not item.back:
                total = sum_of(total, item.torque_at(self.found, about))
        return total

    def joint_impulse(self, path: Path, term: Term) -> Arrow:
        """In the blow that leads to the state, on the body that it holds, or joins as the last."""
        total = STILL
        for item in self.world.efforts.on(self.body_of(path)):
            if item.owner == path.owner and not item.back and path.point in (None, item.bearing):
                total = sum_of(total, item.force_at(self.now))
        return scaled(self.sense_of(path), total)

    def joint_angular_impulse(self, path: Path, term: Term) -> Arrow:
        """In the same blow, about the point held."""
        total, held = STILL, self.stance.arm(self.rig.joints[path.owner].body)
        for item in self.world.efforts.on(self.body_of(path)):
            if item.owner == path.owner and not item.back:
                total = sum_of(total, item.torque_at(self.now, held))
        return scaled(self.sense_of(path), total)

    def sense_of(self, path: Path) -> float:
        """−1 of a joint of which the carrier is named last, so that it is asked what acts on that."""
        joint = self.rig.joints.get(path.owner)
        return -1.0 if joint is not None and joint.named_last else 1.0

    # directions

    def own_axis(self, path: Path, term: Term) -> Arrow:
        return times_arrow(self.stance.turned(path.owner), ALONG[ENTRY[path.quantity[0]]])

    def vertical(self, path: Path, term: Term) -> Arrow:
        return ALONG[2]

    def rotation_axis(self, path: Path, term: Term) -> Arrow:
        (_, b, c), (d, _, f), (g, h, _) = self.stance.turned(path.owner)
        return normed((h - f, c - g, d - b))

    # scalars

    def scalar(self, term: Term) -> float:
        path = term.path
        if path.quantity in NODAL:
            return self.nodal(path)
        reading = SCALARS.get(path.quantity)
        if reading is None or (path.owner and path.owner not in self.rig.bodies and path.quantity != "power"):
            raise NotConfirmed(f"`{path.quantity}` in space")
        return reading(self, path, term)

    def nodal(self, path: Path) -> float:
        """An Euler angle or rate; the spin of what another body carries is that about its axle."""
        name, word = path.owner, path.quantity
        joint = self.rig.main(name)
        if joint is not None and not joint.free and word == "spin" and joint.turning:
            return self.now.one("spins", joint.owner)
        if not self.stance.lines.nods(name):
            return self.about_own_momentum(name, word)
        if word == "axial_rate":
            return inner_product(self.omega(name), self.stance.nodes(name).third)
        if word in NODAL[:3]:
            return self.stance.euler(name)[NODAL.index(word)]
        return self.now.one("euler", name, NODAL.index(word) - 3)

    def about_own_momentum(self, name: str, word: str) -> float:
        """Of a free symmetric body whose axis goes round its angular momentum L: ω = φ̇ L/|L| + ψ̇ e, e its axis."""
        axis = self.rig.axis(name)
        way = -1 if axis is None else ENTRY_OF.get(axis, -1)
        if (
            way < 0
            or not self.rig.symmetric(name, way)
            or self.rig.main(name) is not None
            or self.rig.bodies[name].moved
        ):
            raise NotConfirmed(f"`{word}` of what the state does not describe by its tilt")
        third, omega = times_arrow(self.stance.turned(name), axis or STILL), self.omega(name)
        if word == "axial_rate":
            return inner_product(omega, third)
        whole, tensor = times_arrow(self.world.efforts.tensor(name), omega), self.world.efforts.tensor(name)
        changes = sum_of(times_arrow(tensor, self.found.arrow(TURNING, name)), crossed(omega, whole))
        if arrow_length(changes) > ROUNDING * arrow_length(whole) * arrow_length(omega):
            raise NotConfirmed(f"`{word}` about an angular momentum that does not stay")
        if not any(whole):
            raise NotConfirmed(f"`{word}` about an angular momentum that is nothing")
        momentum = normed(whole)
        level = crossed(momentum, third)
        if word == "tilt":
            return math.atan2(arrow_length(level), inner_product(momentum, third))
        cosine, sine = inner_product(momentum, third), inner_product(level, level)
        if sine <= ROUNDING**2:
            raise NotConfirmed(f"`{word}` of what turns about its own axis alone")
        up, along = inner_product(momentum, omega), inner_product(third, omega)
        if word == "precession":
            return (up - cosine * along) / sine
        if word == "spin":
            return (along - cosine * up) / sine
        raise NotConfirmed(f"`{word}` of a free body")

    def kinetic_energy(self, path: Path, term: Term) -> float:
        names = [path.owner] if path.owner else list(self.rig.bodies)
        return sum(self.kinetic(name, path.component or "") for name in names)

    def kinetic(self, name: str, which: str) -> float:
        """½ ω · I ω + ½ m v²; of what turns about a point at rest all of it is rotation."""
        own, omega, speed = self.rig.solid(name), self.omega(name), self.now.arrow(SPEED, name)
        turning = inner_product(omega, times_arrow(self.world.efforts.tensor(name), omega)) / 2
        travel = own.mass * inner_product(speed, speed) / 2
        if self.rig.on_ground(name) is not None and any(map(any, own.tensor)):
            turning, travel = turning + travel, 0.0
        return {"translational": travel, "rotational": turning}.get(which, turning + travel)

    def energy(self, path: Path, term: Term) -> float:
        """K + m g h."""
        return self.kinetic_energy(path, term) + self.potential_energy(path, term)

    def potential_energy(self, path: Path, term: Term) -> float:
        """m g h, h the height in space, from the point at which a body is held to the ground where no place of that is told."""
        names = [path.owner] if path.owner else list(self.rig.bodies)
        heavy = [name for name in names if self.rig.gravity and self.rig.solid(name).mass]
        return sum(self.rig.solid(name).mass * self.rig.gravity * self.height(name) for name in heavy)

    def height(self, name: str) -> float:
        joint = self.rig.on_ground(name)
        if joint is not None:
            return self.stance.place(name)[2]
        told = self.stance.lines.arrow_told(name, "position") is not None or not self.stance.lines.later
        if self.rig.main(name) is None and not (told or name in self.stance.put_so):
            raise NotConfirmed(f"how high `{name}` is")
        return self.stance.place(name)[2]

    def power(self, path: Path, term: Term) -> float:
        """F · v + C · ω of what acts on a body."""
        name = self.body_of(path)
        which = (path.component or "net") if path.owner in self.rig.bodies else path.owner
        own = [item for item in self.world.efforts.on(name) if which in ("net", item.owner)]
        travels = (inner_product(item.force_at(self.found), self.velocity_at(name, item.arm)) for item in own)
        turns = (inner_product(item.torque_at(self.found, item.arm), self.omega(name)) for item in own)
        return sum(travels) + sum(turns)

    def gyration(self, path: Path, term: Term) -> float:
        return math.sqrt(max(0.0, self.inertia(path, term)) / self.rig.solid(path.owner).mass)

    def tensor_about(self, path: Path, term: Term) -> Turned:
        """The tensor of a body along the axes of space, about its centre of mass or the point that is asked."""
        own = self.rig.solid(path.owner)
        if not own.whole:
            raise NotConfirmed("a tensor of which the scene tells one moment only")
        off = STILL if term.about is None else self.about(path.owner, term)
        central, more = self.world.efforts.tensor(path.owner), about_point(own.mass, off)
        return (sum_of(central[0], more[0]), sum_of(central[1], more[1]), sum_of(central[2], more[2]))

    def inertia(self, path: Path, term: Term) -> float:
        """nᵀ I n about a direction in the body's own axes."""
        name, joint = path.owner, self.rig.main(path.owner)
        if isinstance(term.along, tuple):
            own = normed(self.rig.arrow(term.along))
        elif self.rig.bodies[name].axis or joint is None or not joint.turning:
            axis = self.rig.axis(name)
            if axis is None:
                raise NotConfirmed("a moment of inertia about which axis")
            own = axis
        else:
            own = self.rig.axis(name) or normed(self.rig.arrow(joint.turning[0]))
        way = times_arrow(self.stance.turned(name), own)
        if not self.rig.solid(name).whole and own == self.rig.axis(name) and term.about is None:
            return inner_product(way, times_arrow(self.world.efforts.tensor(name), way))
        return inner_product(way, times_arrow(self.tensor_about(path, term), way))

    def inertia_tensor(self, path: Path, term: Term) -> float:
        tensor = self.tensor_about(path, term)
        rows = self.axes(term.axes or "body", path.owner)
        seen = seen_from(rows_back(rows), tensor)
        entry = (path.component or "zz").split()[-1]
        return seen[ENTRY[entry[0]]][ENTRY[entry[1]]]

    def principal_moments(self, path: Path, term: Term) -> float:
        found = moments_and_axes(self.tensor_about(path, term))
        return found[int((path.component or "1").split()[-1]) - 1][0]

    def principal_axis(self, path: Path, term: Term) -> Arrow:
        """The axis of the moment that is numbered, or that no other equals, beside two that are equal."""
        (low, first), (middle, second), (high, last) = moments_and_axes(self.tensor_about(path, term))
        alike = 1e-9 * max(abs(high), 1e-300)
        number = (path.component or "").split(" ")[0]
        if number.isdecimal():
            near = {"1": middle - low, "2": min(middle - low, high - middle), "3": high - middle}[number]
            if near <= alike:
                raise NotConfirmed("two principal moments are equal")
            return {"1": first, "2": second, "3": last}[number]
        if (middle - low <= alike) == (high - middle <= alike):
            raise NotConfirmed("no principal moment stands alone")
        return last if middle - low <= alike else first

    def rotation_angle(self, path: Path, term: Term) -> float:
        (a, b, c), (d, e, f), (g, h, i) = self.stance.turned(path.owner)
        return math.atan2(arrow_length((h - f, c - g, d - b)), a + e + i - 1.0)

    def stability(self, path: Path, term: Term) -> float:
        from rotsolve.confirm.space.swings import growth_about

        return growth_about(self.world, path.owner)

    def period(self, path: Path, term: Term) -> float:
        """2π/|ω| of what turns steadily about an axis that stays; a body that turns nearly so may come round in quite another time."""
        rate = arrow_length(self.omega(path.owner))
        if arrow_length(self.found.arrow(TURNING, path.owner)) > STEADILY * rate * rate:
            raise NotConfirmed("the period of what does not turn steadily")
        return ROUND / rate

    def angle(self, path: Path, term: Term) -> float:
        """How far a body is turned about its hinge."""
        joint = self.rig.main(path.owner)
        if joint is None or not (joint.turning or self.rig.line(path.owner) is not None):
            raise NotConfirmed("the angle of what no hinge holds")
        swung = self.stance.swung.get(path.owner)
        return swung if swung is not None else self.stance.angle(joint)

    def cm(self, path: Path, term: Term) -> float:
        """A component of the place of the centre of mass in the body's own axes."""
        axis = (path.component or "").split()[-1:] or [""]
        if axis[0] not in ENTRY:
            raise NotConfirmed("where the centre of mass is")
        start = STILL if term.about is None else self.rig.spot(term.about)
        return less(self.rig.solid(path.owner).centre, start)[ENTRY[axis[0]]]

    def mass(self, path: Path, term: Term) -> float:
        return sum(self.rig.solid(name).mass for name in ([path.owner] if path.owner else self.rig.bodies))

    def speed(self, path: Path, term: Term) -> float:
        return arrow_length(self.velocity(path, term))


Vectors = dict[str, Callable[[Reading, Path, Term], Arrow]]
VECTORS_OF_BODIES: Vectors = {
    "angular_velocity": Reading.angular_velocity,
    "angular_acceleration": Reading.angular_acceleration,
    "velocity": Reading.velocity,
    "acceleration": Reading.acceleration,
    "position": Reading.position,
    "momentum": Reading.momentum,
    "angular_momentum": Reading.angular_momentum,
    "torque": Reading.torque,
    "force": Reading.force,
    "x_axis": Reading.own_axis,
    "y_axis": Reading.own_axis,
    "z_axis": Reading.own_axis,
    "vertical": Reading.vertical,
    "rotation_axis": Reading.rotation_axis,
    "principal_axis": Reading.principal_axis,
}
VECTORS_OF_ELEMENTS: Vectors = {
    "force": Reading.joint_force,
    "torque": Reading.joint_torque,
    "impulse": Reading.joint_impulse,
    "angular_impulse": Reading.joint_angular_impulse,
}
SCALARS: dict[str, Callable[[Reading, Path, Term], float]] = {
    "kinetic_energy": Reading.kinetic_energy,
    "energy": Reading.energy,
    "inertia": Reading.inertia,
    "inertia_tensor": Reading.inertia_tensor,
    "principal_moments": Reading.principal_moments,
    "rotation_angle": Reading.rotation_angle,
    "mass": Reading.mass,
    "stability": Reading.stability,
    "period": Reading.period,
    "angle": Reading.angle,
    "cm": Reading.cm,
    "speed": Reading.speed,
    "gyration": Reading.gyration,
    "potential_energy": Reading.potential_energy,
    "power": Reading.power,
}
