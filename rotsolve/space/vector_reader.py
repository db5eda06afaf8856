"""Vector reader: the vectors that a path of a question stands for at a moment, by components along the axes that the question names."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula, Sum, Symbol
from rotsolve.core.quantity import INERTIAL
from rotsolve.core.symbols import has_quantities
from rotsolve.core.vectors.tensor import InertiaTensor
from rotsolve.core.vectors.triple import (
    AS_DRAWN,
    AXES,
    NOTHING,
    Triple,
    cross_product,
    minus,
    scaled_by,
    triple,
    vector_sum,
    way_between,
)
from rotsolve.language.bodies import Joint, PointRef
from rotsolve.language.problem import Path, Problem, Term
from rotsolve.paths.meaning import NotYet, path_text
from rotsolve.space.attitude import IN_SPACE, Axes
from rotsolve.space.inertia import CM, product
from rotsolve.space.laws import SpaceLaws
from rotsolve.space.supports import HELD
from rotsolve.space.two_balls import letter_along

if TYPE_CHECKING:
    from rotsolve.space.principal import ToldTensor
    from rotsolve.space.struck import Shock

Seen = tuple[Triple, Axes]  # a vector and the axes along which its components are


class VectorReader:
    """Reads the vectors of bodies and elements at one moment; `moments` are those of all states."""

    def __init__(self, dynamics: SpaceLaws, moments: Mapping[str, SpaceLaws], problem: Problem) -> None:
        self.dynamics, self.moments, self.problem = dynamics, moments, problem
        self.moment, self.held = dynamics.moment, dynamics.moment.held
        self.bodies = self.held.bodies

    def asked_axes(self, path: Path, term: Term) -> Axes:
        """The axes that a question names, those of space where it names none."""
        if not path.owner:
            return IN_SPACE
        name = path.owner if path.owner in self.bodies else self.body_of(path)
        return self.moment.named_axes(term.axes or "", name)

    def body_of(self, path: Path) -> str:
        """The body on which a connection or action acts."""
        joint = self.held.joint(path.owner)
        if joint is not None:
            return joint.body.owner
        tied = next((item for item in self.held.couplings if item.owner == path.owner), None)
        if tied is not None:
            return tied.second.owner
        action = next((item for item in self.problem.actions if item.name == path.owner), None)
        if action is None:
            raise NotYet(f"`{path_text(path)}` has no meaning in space")
        return action.touches()[0].owner

    def vector(self, path: Path, term: Term) -> Seen:
        """A vector, and the axes along which its components are."""
        if not path.owner:
            return self.of_all(path, term)
        reading = (OF_BODIES if path.owner in self.bodies else OF_ELEMENTS).get(path.quantity)
        if reading is None:
            raise NotYet(f"`{path_text(path)}` is not solved in space yet", help=self.of_body_instead(path, OF_BODIES))
        if term.relative and (path.component or "").split()[:1] not in ([which] for which in INERTIAL):
            return self.relative(path, term)
        return reading(self, path, term)

    def of_body_instead(self, path: Path, known: Collection[str]) -> str:
        """The help that what is asked of a joint can be asked of the body that it holds."""
        joint = self.held.joint(path.owner)
        return f"ask for `{joint.body.owner}.{path.quantity}`" if joint is not None and path.quantity in known else ""

    def relative(self, path: Path, term: Term) -> Seen:
        """The velocity or acceleration of a body in a frame that turns, as the state tells its motion there."""
        from rotsolve.space.frames import Relative, frame_of

        if path.quantity not in ("velocity", "acceleration") or path.point not in (None, CM):
            raise NotYet(f"`{path_text(path)} relative to` a body is not solved in space yet", path.span)
        told = frame_of(self.moment, path.owner) == term.relative
        if not told and self.moment.place_in(path.owner, term.relative or "") is None:
            help = f"tell `{path.owner}.position relative to {term.relative}` in the state, and its velocity there"
            raise NotYet(f"how `{path.owner}` moves in `{term.relative}` nothing tells", path.span, help)
        found = Relative(self.moment, path.owner, term.relative or "")
        if found.axes.lost and path.component in AXES and term.axes is None:
            raise NotYet(found.axes.lost, path.span, f"ask for it `in {term.relative} axes`, along which it moves")
        return found.slip if path.quantity == "velocity" else found.faster, found.axes

    def point(self, path: Path) -> PointRef:
        """The point of a path, the centre of mass of a body that is named alone."""
        return PointRef(path.owner, path.point or CM, path.argument, span=path.span)

    def angular_velocity(self, path: Path, term: Term) -> Seen:
        own = self.moment.attitude(path.owner)
        return own.omega, own.axes

    def angular_acceleration(self, path: Path, term: Term) -> Seen:
        own = self.moment.attitude(path.owner)
        return vector_sum(own.rates, self.dynamics.carried_round(path.owner, own.omega)), own.axes

    def position(self, path: Path, term: Term) -> Seen:
        """The place of a point in space, from the point at which a joint holds its body to the ground, or as the state tells it."""
        from rotsolve.space.places import point_from_start

        return point_from_start(self.moment, self.point(path)), IN_SPACE

    def velocity(self, path: Path, term: Term) -> Seen:
        if path.point in (None, CM):
            return self.moment.of_mass(path.owner, "velocity")
        if self.goes_free(path.owner):
            return self.beside_centre(path, term, "velocity")
        return self.moment.velocity(self.point(path)), self.moment.axes(path.owner)

    def acceleration(self, path: Path, term: Term) -> Seen:
        if path.point in (None, CM):
            return self.moment.of_mass(path.owner, "acceleration")
        if self.goes_free(path.owner):
            return self.beside_centre(path, term, "acceleration")
        return self.moment.acceleration(self.point(path)), self.moment.axes(path.owner)

    def goes_free(self, name: str) -> bool:
        """Whether nothing holds a body and time has turned it on, so that its centre of mass goes by itself."""
        return not self.held.of_body(name) and self.moment.keeps_momentum(name)

    def beside_centre(self, path: Path, term: Term, word: str) -> Seen:
        """v + ω × r, or a + α × r + ω × (ω × r), with that of the centre of mass as it is in space, along the axes that are asked."""
        own, arm, asked = (
            self.moment.attitude(path.owner),
            self.moment.arm(self.point(path)),
            self.asked_axes(path, term),
        )
        swept = cross_product(own.omega, arm)
        if word == "acceleration":
            swept = vector_sum(cross_product(own.alpha, arm), cross_product(own.omega, swept))
        centre, axes = self.moment.of_mass(path.owner, word)
        return vector_sum(axes.to(asked, centre), own.axes.to(asked, swept)), asked

    def momentum(self, path: Path, term: Term) -> Seen:
        velocity, axes = self.velocity(replace(path, point=None), term)
        return scaled_by(self.held.mass(path.owner), velocity), axes

    def of_all(self, path: Path, term: Term) -> Seen:
        """Σ M v of all bodies, or the sum of their angular momenta about one point, along the axes of space."""
        reading = {"momentum": self.momentum, "angular_momentum": self.angular_momentum}.get(path.quantity)
        if reading is None:
            message = f"`{path_text(path)}` of all bodies together is not solved in space"
            raise NotYet(message, path.span, "name a body")
        if path.quantity == "angular_momentum" and term.about is None:
            message = "nothing tells about which point the angular momentum of all bodies together is asked"
            raise NotYet(message, path.span, "write `angular_momentum about [0, 0, 0]`, or about a point of a body")
        whole = NOTHING
        for name in self.held.order:
            own, axes = reading(replace(path, owner=name), term)
            whole = vector_sum(whole, axes.to(IN_SPACE, own))
        return whole, IN_SPACE

    def about(self, path: Path, term: Term) -> tuple[Triple, str]:
        """The point about which a torque or an angular momentum is asked, from the reference of its body, and its name."""
        if term.about is None:
            return self.dynamics.about(path.owner)
        joint = self.held.joint(term.about.owner)
        ref = joint.body if joint is not None else term.about
        if ref.owner != path.owner:
            from rotsolve.space.places import way_to

            return way_to(self.moment, path.owner, ref), ""
        return self.moment.arm(PointRef(ref.owner, ref.point or "center", ref.argument)), ref.point or "center"

    def angular_momentum(self, path: Path, term: Term) -> Seen:
        """L = I ω about a point at rest; about the centre of mass; about another point with r × m v of the centre of mass."""
        name, own = path.owner, self.moment.attitude(path.owner)
        if path.point is not None:
            message = f"the share of a part in the angular momentum of `{name}` is not solved in space"
            raise NotYet(message, path.span, f"ask for `{name}.angular_momentum`")
        place, _ = self.about(path, term)
        at_rest, own_point = self.dynamics.about(name)
        if place == at_rest:
            tensor = self.dynamics.tensor(name, own_point)
            letters, _ = self.dynamics.letters_of(name, tensor, own, own_point)
            return letters, own.axes
        spin = product(self.dynamics.tensor(name, CM), own.omega)
        arm = vector_sum(self.moment.arm(PointRef(name, CM)), minus(place))
        velocity = self.moment.velocity(PointRef(name, CM))
        return vector_sum(spin, cross_product(arm, scaled_by(self.held.mass(name), velocity))), own.axes

    def torque(self, path: Path, term: Term) -> Seen:
        """The torque on a body about a point: of all forces (`net`), of its weight, of one connection or action."""
        place, _ = self.about(path, term)
        which = (path.component or "net").split()[0]
        which = "net" if which in AXES else which
        torque = NOTHING
        for push in self.dynamics.pushes.on(path.owner):
            if which in ("net", push.owner):
                torque = vector_sum(torque, push.torque(place))
        if which == "net":
            return self.rate_of_momentum(path, place), self.moment.axes(path.owner)
        return torque, self.moment.axes(path.owner)

    def rate_of_momentum(self, path: Path, place: Triple) -> Triple:
        """What all torques together come to: their sum where it is told, else dL/dt about the point at rest or the centre of mass."""
        at_rest, point = self.dynamics.about(path.owner)
        torque = NOTHING
        for push in self.dynamics.pushes.on(path.owner):
            torque = vector_sum(torque, push.torque(place))
        if place != at_rest or not any(map(has_quantities, torque)):
            return torque
        own, tensor = self.moment.attitude(path.owner), self.dynamics.tensor(path.owner, point)
        letters, _ = self.dynamics.letters_of(path.owner, tensor, own, point)
        return vector_sum(product(tensor, own.rates), self.dynamics.carried_round(path.owner, letters))

    def force(self, path: Path, term: Term) -> Seen:
        """The force on a body: of all (`net`: m a), its weight, of one connection or action; in a frame that turns its inertial ones."""
        which = (path.component or "net").split()[0]
        which = "net" if which in AXES else which
        axes = self.moment.axes(path.owner)
        if which in INERTIAL:
            from rotsolve.space.frames import frame_of, inertial_force

            return inertial_force(self.moment, path, term.relative or frame_of(self.moment, path.owner), which)
        if which == "net":
            acceleration, axes = self.acceleration(replace(path, point=None), term)
            return scaled_by(self.held.mass(path.owner), acceleration), axes
        if which == HELD:
            return self.force_of_supports(path, term), axes
        return self.forces_of(path.owner, which), axes

    def force_of_supports(self, path: Path, term: Term) -> Triple:
        """M a less all that acts on a body but the joints that hold it."""
        whole, along = self.force(replace(path, component="net"), term)
        axes, joints = self.moment.axes(path.owner), {joint.owner for joint in self.held.of_body(path.owner)}
        others = [push.along(axes) for push in self.dynamics.pushes.on(path.owner) if push.owner not in joints]
        return vector_sum(along.to(axes, whole), *map(minus, others))

    def own_axis(self, path: Path, term: Term) -> Seen:
        """The direction of one of a body's own axes, along these."""
        return AS_DRAWN[AXES.index(path.quantity[0])], self.moment.own_axes(path.owner)

    def rotation_axis(self, path: Path, term: Term) -> Seen:
        """The axis of the rotation that all turns of a body come to: n ∝ the part of R that changes sign when it is transposed."""
        from rotsolve.space.rotations import axis_of

        return axis_of(self.moment.own_axes(path.owner).standing, path, self.held.vanishes), IN_SPACE

    def tensor_about(self, path: Path, term: Term) -> InertiaTensor:
        """The tensor of a body about the point that is asked, in its own axes."""
        ref = term.about
        point = PointRef(path.owner, CM) if ref is None else PointRef(path.owner, ref.point or "center", ref.argument)
        joint = None if ref is None else self.held.joint(ref.owner)
        point = point if joint is None else joint.body
        if point.owner != path.owner or (ref is not None and joint is None and ref.owner != path.owner):
            raise NotYet(f"`{path.quantity}` of `{path.owner}` is told about its own points", path.span)
        body = self.held.bodies[path.owner]
        if body.tensor is None and (body.inertia is not None or body.gyration is not None) and not body.parts:
            message = f"only the moment of inertia of `{path.owner}` about its axis is known"
            raise NotYet(message, path.span, "tell `inertia: {principal: [I1, I2, I3]}`, or a shape")
        return self.dynamics.own_tensor(point)

    def principal_axis(self, path: Path, term: Term) -> Seen:
        return self.principal_pair(path, term)[1], self.moment.own_axes(path.owner)

    def principal_pair(self, path: Path, term: Term) -> tuple[Formula, Triple]:
        """The principal moment that a question numbers, else the one that stands alone, and its axis."""
        from rotsolve.space.principal import lone_axis, numbered_axis

        told, number = self.of_roots(path, term), (path.component or "").split(" ")[0]
        if not number.isdecimal():
            return lone_axis(told, path)
        return numbered_axis(told, int(number), replace(path, component=number))

    def of_roots(self, path: Path, term: Term) -> ToldTensor:
        """The tensor about the point that is asked, with what tells its principal moments and axes."""
        from rotsolve.space.principal import ToldTensor

        spot = (term.about.point if term.about else "") or ""
        return ToldTensor(
            self.tensor_about(path, term), self.dynamics.tensors, self.moment.signs, self.held, path.owner, spot
        )

    def side(self, gap: Formula) -> int | None:
        """The sign of a difference, by its numbers or whatever its letters are."""
        sign = self.moment.signs.decide(gap)
        return self.moment.signs.whatever_way(gap) if sign is None else sign

    # of connections and actions

    def joint_force(self, path: Path, term: Term) -> Seen:
        """The force of a connection on the body that it holds, or of one of its bearings."""
        name = self.body_of(path)
        pushes = [push for push in self.dynamics.pushes.on(name) if push.owner == path.owner and push.force != NOTHING]
        if path.point is not None:
            pushes = [push for number, push in enumerate(pushes, 1) if path.point == f"bearing{number}"]
        if len(pushes) == 1:
            return self.told_apart(path, term, self.dynamics, pushes[0].force), pushes[0].axes
        return self.told_apart(path, term, self.dynamics, self.forces_of(name, path.owner)), self.moment.axes(name)

    def told_apart(self, path: Path, term: Term, laws: SpaceLaws, vector: Triple) -> Triple:
        """The force or impulse of one of two balls without its part along the line through both, of which the laws tell only the sum.

        Refused where that is asked for.
        """
        name = self.body_of(path)
        main, supports = self.held.main(name), self.held.hinge_balls(name)
        self.refuse_along_to_touching(path, term, laws)
        if not supports or main is None or path.owner not in [joint.owner for joint in supports]:
            return vector
        own, way = laws.moment.axes(name), laws.moment.direction(name, main)
        self.refuse_along(path, own.to(self.asked_axes(path, term), way), [joint.owner for joint in supports])
        letter = letter_along(laws.pushes.line_axes(name) or own, way)
        along = laws.moment.ask(path.quantity, path.owner, letter) if letter else ZERO
        return triple([part.substitute({along.name: ZERO}) if isinstance(along, Symbol) else part for part in vector])

    def refuse_along(self, path: Path, line: Triple, owners: Sequence[str]) -> None:
        """Refuse what is asked of one of two joints along the line through both, which is told along the axes that the question names."""
        component = (path.component or "").split()[-1:] or [""]
        if component[0] in AXES and self.held.vanishes(line[AXES.index(component[0])]):
            return
        both, word = " and ".join(f"`{owner}`" for owner in owners), path.quantity
        said = f"along the line through {both} only the sum of their {word}s is told"
        message = f"`{path_text(path)}` is statically indeterminate: {said}"
        help = "ask for a component across that line, `in body axes` where it turns"
        whole = f", or for their sum, `{' + '.join(f'{owner}.force' for owner in owners)}`" if word == "force" else ""
        raise NotYet(message, path.span, help + whole)

    def refuse_along_to_touching(self, path: Path, term: Term, laws: SpaceLaws) -> None:
        """Refuse the part of a force along the line from a ball on the ground to where its body rolls: the laws tell only the sum."""
        name, ground = self.body_of(path), self.held.bodies
        joints = [joint for joint in self.held.of_body(name) if joint.free or joint.rolls]
        if (
            len(joints) != 2
            or joints != list(self.held.of_body(name))
            or path.owner not in [item.owner for item in joints]
        ):
            return
        ball, contact = joints
        if not (ball.free and contact.rolls) or ball.carrier.owner in ground or contact.carrier.owner in ground:
            return
        away = laws.moment.axes(name).to(self.asked_axes(path, term), laws.pushes.place(contact))
        self.refuse_along(path, away, (ball.owner, contact.owner))

    def joint_impulse(self, path: Path, term: Term) -> Seen:
        """The impulse of a joint on the body that it holds, or joins as the last, or of one bearing, in the event that leads here."""
        joint, laws, shocks = self.shocks(path)
        if path.point is not None:
            shocks = [shock for number, shock in enumerate(shocks, 1) if path.point == f"bearing{number}"]
        push = vector_sum(*(shock.push for shock in shocks))
        push = minus(push) if joint.named_last else push
        return self.told_apart(path, term, laws, push), laws.moment.axes(joint.body.owner)

    def joint_angular_impulse(self, path: Path, term: Term) -> Seen:
        """Σ r × J and the couples of a joint on the body that it holds, about the point held, in that event."""
        joint, laws, shocks = self.shocks(path)
        place = laws.moment.arm(joint.body)
        own = (vector_sum(cross_product(way_between(place, item.arm), item.torque_from), item.twist) for item in shocks)
        twist = vector_sum(*own)
        return minus(twist) if joint.named_last else twist, laws.moment.axes(joint.body.owner)

    def shocks(self, path: Path) -> tuple[Joint, SpaceLaws, list[Shock]]:
        """A joint, the laws just after the event that leads to this moment, and its impulses in it."""
        joint = self.held.joint(path.owner)
        if self.moment.before is None:
            raise NotYet(f"`{path_text(path)}` is that of a blow: ask for it at the state after one", path.span)
        if joint is None:
            raise NotYet(f"`{path_text(path)}` is not solved in space yet", path.span)
        from rotsolve.space.struck import shocks_of_joint

        return joint, self.dynamics, list(shocks_of_joint(joint, self.dynamics))

    def forces_of(self, name: str, owner: str) -> Triple:
        """What one connection, action or gravity pushes a body with, in the axes of the body."""
        axes, force = self.moment.axes(name), NOTHING
        for push in self.dynamics.pushes.on(name):
            force = vector_sum(force, push.along(axes) if push.owner == owner else NOTHING)
        return force

    def joint_torque(self, path: Path, term: Term) -> Seen:
        """The torque of a connection or action about the point held, on the ground or on what carries it, or about another one."""
        name, joint = self.body_of(path), self.held.joint(path.owner)
        place, _ = self.about(replace(path, owner=name), term)
        if term.about is None and joint is not None and not joint.rolls:
            place = self.moment.arm(PointRef(name, joint.body.point or "center", joint.body.argument))
            if (couple := self.dynamics.pushes.couple_of_bearings(joint)) is not None:
                return couple[0], self.moment.axes(name)
        torque = NOTHING
        for push in self.dynamics.pushes.on(name):
            torque = vector_sum(torque, push.torque(place) if push.owner == path.owner else NOTHING)
        return torque, self.moment.axes(name)

    # angles between vectors


def tidied_part(value: Formula) -> Formula:
    """A component with what cancels left out, where it is a sum."""
    return simplify(value) if isinstance(value, Sum) or not has_quantities(value) else value


OF_BODIES: dict[str, Callable[[VectorReader, Path, Term], Seen]] = {
    "angular_velocity": VectorReader.angular_velocity,
    "angular_acceleration": VectorReader.angular_acceleration,
    "position": VectorReader.position,
    "velocity": VectorReader.velocity,
    "acceleration": VectorReader.acceleration,
    "momentum": VectorReader.momentum,
    "angular_momentum": VectorReader.angular_momentum,
    "torque": VectorReader.torque,
    "force": VectorReader.force,
    "x_axis": VectorReader.own_axis,
    "y_axis": VectorReader.own_axis,
    "z_axis": VectorReader.own_axis,
    "rotation_axis": VectorReader.rotation_axis,
    "principal_axis": VectorReader.principal_axis,
}
OF_ELEMENTS: dict[str, Callable[[VectorReader, Path, Term], Seen]] = {
    "force": VectorReader.joint_force,
    "torque": VectorReader.joint_torque,
    "impulse": VectorReader.joint_impulse,
    "angular_impulse": VectorReader.joint_angular_impulse,
}
