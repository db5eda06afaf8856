"""Rolling in space: a wheel or ball touches a level floor, a slope or the flat face of a body, and its touching point goes with that.

With p = c + r the touching place, c the centre of mass and V(p) the velocity that the surface has there,
v = V(p) − ω × r and a = dV(p)/dt − d(ω × r)/dt. Of a ball r = −R n below its centre, n square to the surface, which turns with it; in
node axes the lowest point of a rim about e₃ is −R e₂, or +R e₂ where the tilt is told beyond 0 to 180° (sin θ < 0). No component may be
integrated: the constraint is nonholonomic.
"""

from __future__ import annotations

from rotsolve.algebra.formula import ONE, ZERO, Formula, multiply, negate
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.triple import (
    AXES,
    NOTHING,
    Triple,
    Y,
    Z,
    cross_product,
    dot_product,
    minus,
    scaled_by,
    vector_sum,
    way_between,
)
from rotsolve.elements.shapes import Shape, rim_radius, rolling_shape
from rotsolve.language.bodies import Joint
from rotsolve.space.attitude import IN_SPACE, NODE, MovingBodies
from rotsolve.space.frames import Relative


def rolling_radius(joint: Joint, moment: MovingBodies) -> Formula:
    """The radius of what rolls."""
    radius = rim_radius(moment.held.bodies[joint.body.owner], joint.body.point)
    if radius is None:
        raise Unsolvable(f"`{joint.body.owner}` has no rim on which it could roll", span=joint.body.span)
    return radius


def out_of_surface(joint: Joint, moment: MovingBodies) -> Triple:
    """The direction out of the surface on which a body rolls, in space: of a body that of its own z axis."""
    carrier = joint.carrier.owner
    if carrier in moment.held.bodies:
        return moment.own_axes(carrier).to(IN_SPACE, Z)
    surface = moment.held.surface(carrier)
    if surface is None:
        return Z
    way = surface.normal
    return (way.cos(), ZERO, way.sin())


def shape_that_rolls(joint: Joint, moment: MovingBodies) -> Shape:
    """The shape with which a body rolls; refused where nothing tells whether it is a wheel or a ball."""
    name, body = joint.body.owner, moment.held.bodies[joint.body.owner]
    shape = rolling_shape(body, joint.body.point)
    if shape is None:
        part = next((part.body.name for part in body.parts if rim_radius(part.body, None) is not None), "")
        wheel = f"tell the `axis` of `{name}`, about which its rim goes"
        help = (
            f"name the part that rolls, `rolls: [{name}.{part}, …]`, or {wheel}"
            if part
            else f"give it a shape, or {wheel}"
        )
        message = f"whether `{name}` rolls as a wheel or as a ball nothing tells"
        raise Unsolvable(message, span=joint.body.span, help=help)
    return shape


def lowest(joint: Joint, moment: MovingBodies) -> Triple:
    """Where a body touches the surface, from its reference, in its axes: of a thin wheel its lowest point, however it leans."""
    name, radius, shape = joint.body.owner, rolling_radius(joint, moment), shape_that_rolls(joint, moment)
    own, hub = moment.attitude(name), moment.arm(joint.body)
    out = out_of_surface(joint, moment)
    if shape.spherical:
        return vector_sum(hub, IN_SPACE.to(own.axes, scaled_by(negate(radius), out)))
    if not all(map(moment.held.vanishes, cross_product(out, Z))):
        message = f"where `{name}` touches `{joint.carrier.owner}`, which is not level, is solved for balls alone"
        raise Unsolvable(message, span=joint.body.span, help="on a slope in the plane leave out `up: z`")
    up = IN_SPACE.to(own.axes, Z)
    about = moment.symmetry_axis(name)
    level = about is not None and moment.held.vanishes(dot_product(up, about))
    if own.axes.name == NODE and (shape.flat or level):
        return vector_sum(hub, scaled_by(multiply(negate(radius), moment.rim_side(name)), Y))
    if not level:
        told = shape.flat and not moment.nods(name)
        solved = "solved are thin wheels that are symmetric, balls, and wheels whose axis is level"
        message, help = f"where `{name}` touches the floor nothing tells", f"tell `{name}.tilt` in the state"
        if shape.flat and moment.nods(name):
            message = (
                f"`{name}` leans, and its mass is not the same all round its axis: how such a wheel rolls is not solved"
            )
        raise Unsolvable(message, span=joint.body.span, help=help if told else solved)
    return vector_sum(hub, scaled_by(negate(radius), up))


def wheel_touching_rate(joint: Joint, moment: MovingBodies) -> Triple:
    """ṙ = ω × h + R (n · (ω × e)) e in space of the lowest point of a wheel with its axis e level, h its hub from the reference."""
    name = joint.body.owner
    own, about = moment.attitude(name), moment.symmetry_axis(name)
    assert about is not None  # `lowest` has asked for it
    swung = own.axes.to(IN_SPACE, cross_product(own.omega, moment.arm(joint.body)))
    tipping = dot_product(Z, own.axes.to(IN_SPACE, cross_product(own.omega, about)))
    gone = multiply(rolling_radius(joint, moment), tipping)
    return vector_sum(swung, own.axes.to(IN_SPACE, scaled_by(gone, about)))


class Rolling:
    """How the centre of mass moves of a body that rolls and that nothing else holds; all vectors in the axes of space."""

    def __init__(self, joint: Joint, moment: MovingBodies) -> None:
        self.joint, self.moment, self.name = joint, moment, joint.body.owner
        if moment.held.rolling(self.name) is None:
            message = (
                f"`{self.name}` rolls on `{joint.carrier.owner}` and is held besides: that is not solved in space yet"
            )
            raise Unsolvable(message, span=joint.body.span)
        shape = shape_that_rolls(joint, moment)
        self.own, self.ball = moment.attitude(self.name), shape.spherical
        if not (shape.spherical or shape.flat):
            message = f"`{self.name}` touches `{joint.carrier.owner}` along a line, and how that pushes along it nothing tells"
            help = "draw it as a `disc`: a thin wheel, which touches in a point; in the plane, without `up: z`, it is solved"
            raise Unsolvable(message, span=joint.body.span, help=help)
        self.arm = lowest(joint, moment)  # in the axes of the body
        carrier = joint.carrier.owner
        self.frame = Relative(moment, self.name, carrier) if carrier in moment.held.bodies else None
        if self.frame is not None:
            self.refuse_off_face(self.frame)

    def refuse_off_face(self, frame: Relative) -> None:
        """Refuse a place at which a body does not touch the face of another one: its lowest point lies on that."""
        face = self.moment.held.face(frame.frame)
        if face is None:
            help = f"draw `{frame.frame}` as a disc, a rectangle, a cuboid or a cylinder: its face is square to its own z axis"
            raise Unsolvable(
                f"`{frame.frame}` has no flat face on which `{self.name}` could roll",
                span=self.joint.body.span,
                help=help,
            )
        line = self.moment.line(self.name, "position", "z")  # at any other moment it has rolled there
        height = self.moment.held.reference(frame.frame)[2] + self.touched(frame)[2]
        if line is not None and not self.moment.held.vanishes(height - face):
            message = f"`{self.name}` does not touch `{frame.frame}` at that place"
            help = (
                f"its z is that of the face and how high the centre of mass of `{self.name}` stands above it, of what leans R sin θ, as"
                f" a formula and not rounded; places count from where `{frame.frame}` is held"
            )
            raise Unsolvable(message, span=line.span, help=help)

    def velocity_told(self) -> Triple | None:
        """The velocity of the centre of mass as the state tells it, in space or relative to the body on which it rolls."""
        told = self.moment.vector_told(self.name, "velocity")
        if told is not None and told[2]:
            if self.frame is None or told[2] != self.frame.frame:
                line = self.moment.line(self.name, "velocity", "x")
                message = f"`{self.name}` rolls on `{self.joint.carrier.owner}`: its velocity is told relative to that, or in space"
                raise Unsolvable(message, span=self.joint.body.span if line is None else line.span)
            return self.frame.axes.to(IN_SPACE, self.frame.velocity())
        if told is not None:
            return self.moment.named_axes(told[1], self.name).to(IN_SPACE, told[0])
        return NOTHING if self.moment.rests(self.name) else None

    def velocity(self) -> Triple:
        """v of the centre of mass: as told, else V(p) − ω × r."""
        told = self.velocity_told()
        return self.velocity_by_turning() if told is None else told

    def velocity_by_turning(self) -> Triple:
        """v = V(p) − ω × r."""
        return vector_sum(self.surface_velocity(), self.own.axes.to(IN_SPACE, self.swept(minus(self.own.omega))))

    def slip(self) -> Triple:
        """v + ω × r − V(p) where the state tells v: the velocity of the touching point against the surface, which is nothing."""
        told = self.velocity_told()
        return NOTHING if told is None else way_between(self.velocity_by_turning(), told)

    def turning(self) -> Triple:
        """ω of a ball, in space: as told, else by the velocity that the state tells, ω = ωₙ n + n × (v − V(p))/R, and one component.

        That tells ωₙ, about the direction out of the surface, which does nothing to the way; it is 0 where nothing tells it.
        """
        velocity, told = self.velocity_told(), self.own.omega
        lines = [self.moment.line(self.name, "angular_velocity", axis) for axis in AXES]
        known = [k for k, line in enumerate(lines) if line is not None]
        if velocity is None or len(known) == len(AXES) or self.moment.rests(self.name):
            return told
        out, radius = out_of_surface(self.joint, self.moment), rolling_radius(self.joint, self.moment)
        gone = way_between(self.surface_velocity(), velocity)
        rolled = scaled_by(ONE / radius, cross_product(out, gone))
        if not known:
            return rolled
        k = known[0]
        if len(known) > 1 or self.moment.held.vanishes(out[k]):
            line = lines[k]
            message = f"how `{self.name}` turns about the direction out of `{self.joint.carrier.owner}` is not told by this component"
            help = (
                f"tell all three components of `{self.name}.angular_velocity`, or that along which the surface pushes"
            )
            raise Unsolvable(message, span=None if line is None else line.span, help=help)
        return vector_sum(rolled, scaled_by((told[k] - rolled[k]) / out[k], out))

    def swept(self, turning: Triple) -> Triple:
        """turning × r."""
        return cross_product(turning, self.arm)

    def surface_velocity(self) -> Triple:
        """V(p): the velocity of what is touched."""
        frame = self.frame
        if frame is None:
            return NOTHING
        there = vector_sum(frame.origin("velocity"), cross_product(frame.omega, self.touched(frame)))
        return frame.axes.to(IN_SPACE, there)

    def touched(self, frame: Relative) -> Triple:
        """The touching place from the point at which the body that is touched is held, in its axes."""
        return vector_sum(frame.place, self.own.axes.to(frame.axes, self.arm))

    def touched_from_held(self) -> Triple:
        """The touching place on a body, from the point about which that turns, in the axes in which its vectors are written."""
        assert self.frame is not None
        return self.frame.axes.to(self.moment.axes(self.frame.frame), self.touched(self.frame))

    def arm_rate(self) -> Triple:
        """ṙ in space: of a ball ω × h − R Ω × n, with h its centre from the centre of mass and Ω of what is touched.

        Of a wheel Ω × r in axes that go along with its lowest point; else, with its axis e level, ω × h + R (n · (ω × e)) e.
        """
        own, hub = self.own, self.moment.arm(self.joint.body)
        if not self.ball and own.axes.name == NODE:
            return own.axes.to(IN_SPACE, cross_product(own.axes.rate, self.arm))
        swung = own.axes.to(IN_SPACE, cross_product(own.omega, hub))
        if self.ball:
            if self.frame is None:
                return swung
            below = own.axes.to(self.frame.axes, way_between(hub, self.arm))
            return vector_sum(swung, self.frame.axes.to(IN_SPACE, cross_product(self.frame.omega, below)))
        return wheel_touching_rate(self.joint, self.moment)

    def goes_round(self) -> Triple | None:
        """v where the state is steady and tells it along node axes: it keeps these components while the axes turn."""
        told, own = self.moment.vector_told(self.name, "velocity"), self.own
        kept = told is not None and told[1] == NODE and own.axes.name == NODE and self.frame is None
        return told[0] if told is not None and kept and self.moment.state.steady else None

    def acceleration(self) -> Triple:
        """a = dV(p)/dt − d(ω × r)/dt; Ω × v of what goes round steadily with a velocity that is told."""
        round_ = self.goes_round()
        if round_ is not None:
            return self.own.axes.to(IN_SPACE, cross_product(self.own.axes.rate, round_))
        return vector_sum(self.surface_acceleration(), minus(self.rate_of_swept()))

    def rate_of_swept(self) -> Triple:
        """d(ω × r)/dt: (rates of ω's components) × r + Ω × (ω × r) in axes that keep r, else α × r + ω × ṙ."""
        own = self.own
        if not self.ball and own.axes.name == NODE:
            kept = vector_sum(cross_product(own.rates, self.arm), cross_product(own.axes.rate, self.swept(own.omega)))
            return own.axes.to(IN_SPACE, kept)
        turned = own.axes.to(IN_SPACE, cross_product(own.alpha, self.arm))
        return vector_sum(turned, cross_product(own.axes.to(IN_SPACE, own.omega), self.arm_rate()))

    def surface_acceleration(self) -> Triple:
        """dV(p)/dt = A + Ω̇ × ρ + Ω × ρ̇ of the touching place ρ from the centre of what is touched, which goes along that."""
        frame = self.frame
        if frame is None:
            return NOTHING
        going = IN_SPACE.to(frame.axes, vector_sum(self.velocity(), self.arm_rate()))
        along = way_between(frame.origin("velocity"), going)
        return frame.axes.to(
            IN_SPACE,
            vector_sum(
                frame.origin("acceleration"),
                cross_product(frame.alpha, self.touched(frame)),
                cross_product(frame.omega, along),
            ),
        )
