"""The laws in space: Newton's second law in three components, and dL/dt = Στ in axes that turn: (rates of L's components) + Ω × L.

About a point that is held at rest, else about the centre of mass (Goldstein, Poole & Safko, Classical Mechanics, §5.1; Euler's equations
are these in the body's own principal axes, §5.5). The axes are such that the body's inertia is constant in them: its own, or of a
symmetric body those of its line of nodes or of what carries it.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import chain

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.normal import degree, is_zero
from rotsolve.algebra.formula import ONE, ZERO, Formula, Symbol, add, multiply, negate
from rotsolve.core.derivation import Words
from rotsolve.core.equation import (
    ANGULAR_MOMENTUM_IN_SPACE,
    COUPLE_OF_BEARINGS,
    RATE_IN_AXES,
    RATE_IN_STILL_AXES,
    RULE,
    SECOND_LAW,
    Equation,
)
from rotsolve.core.faults import Unsolvable
from rotsolve.core.symbols import has_quantities, is_key, key_of, of_kinds
from rotsolve.core.vectors.heading import heading
from rotsolve.core.vectors.tensor import InertiaTensor
from rotsolve.core.vectors.triple import (
    AXES,
    NOTHING,
    Triple,
    cross_product,
    dot_product,
    is_axis,
    scaled_by,
    vector_sum,
)
from rotsolve.core.writing import point_in_words, spoken
from rotsolve.language.bodies import Joint, PointRef
from rotsolve.space.arrangement import RATES
from rotsolve.space.attitude import AXIAL, IN_SPACE, NODE, Attitude, Axes
from rotsolve.space.inertia import CM, Tensors, in_axes, product
from rotsolve.space.moment import SpaceMoment
from rotsolve.space.pushes import ForceInSpace, Pushes
from rotsolve.space.thin import unspun
from rotsolve.space.two_balls import names_along

BY_ROLLING = "its acceleration by differentiating the condition of rolling"
ROUND = "its acceleration Ω × v, as it goes round steadily"
TURNS = (
    "angular_velocity",
    "angular_acceleration",
    "axial_rate",
    "precession",
    "spin",
)  # by which rolling tells velocities
NODE_NAMES = {"x": "e₁", "y": "e₂", "z": "e₃"}


class SpaceLaws:
    """What the laws say of each body at one moment."""

    def __init__(self, moment: SpaceMoment, pushes: Pushes, tensors: Tensors, *, fast: bool = False) -> None:
        self.moment, self.pushes, self.tensors = moment, pushes, tensors
        self.fast = fast  # whether the scene takes spins to be much faster than the precession
        self.fast_nutation = False  # whether that has told the nutation
        self.unwritten: dict[str, Unsolvable] = {}  # the bodies of which no law can be written, each with the reason
        self.untravelled: dict[str, Unsolvable] = {}  # those of which that is so of Newton's second law alone

    def equations(self) -> Iterator[Equation]:
        """All laws at this moment, with what defines the letters in them; a body of which none can be written is left out."""
        for name in self.moment.held.order:
            if self.moment.held.bodies[name].moved:
                continue
            try:
                yield from list(self.of_body(name))
            except Unsolvable as error:
                self.unwritten[name] = error
            if name not in self.moment.held.links:
                yield from unspun(self.moment, name)
        yield from self.couples_of_bearings()
        yield from self.grips()
        if self.moment.held.links:
            from rotsolve.space.links import link_rules

            yield from link_rules(self.moment)
        if self.moment.held.couplings:
            from rotsolve.space.universal import crosses_at

            yield from chain.from_iterable(cross.rules() for cross in crosses_at(self.moment))
        for words, part in self.pushes.conditions:
            yield RULE.equation(part, ZERO, self.moment.when, words=words)

    def grips(self) -> Iterator[Equation]:
        """The touching point of what rolls goes with the surface; of what nothing holds that tells how it moves, or how it turns."""
        moment, held = self.moment, self.moment.held
        for joint in held.joints:
            name = joint.body.owner
            if not joint.rolls or held.bodies[name].moved:
                continue
            try:
                slipping, goes_on = self.slip(joint), self.slip_rate(joint)
            except Unsolvable as error:
                self.unwritten[name] = error
                continue
            goes = (
                "is at rest" if joint.carrier.owner not in held.bodies else f"goes with {spoken(joint.carrier.owner)}"
            )
            for part in slipping:
                if part != ZERO:
                    words = f"{spoken(name)} rolls: the touching point {goes}"
                    yield RULE.equation(part, ZERO, moment.when, (name,), words=words)
            for part in goes_on:
                if part != ZERO:
                    words = f"{spoken(name)} goes on rolling: the touching point stays at rest"
                    yield RULE.equation(part, ZERO, moment.when, (name,), words=words)

    def slip_rate(self, joint: Joint) -> Triple:
        """How fast that changes, a + α × r + ω × ṙ, of what another joint holds besides; nothing where the state is steady.

        r goes with the lowest point of a wheel, Ω × r or with a level axis as that tips, and with the centre h of a ball, ω × h.
        """
        moment, name = self.moment, joint.body.owner
        held = moment.held.main(name)
        if held is None or moment.state.steady or joint.carrier.owner in moment.held.bodies:
            return NOTHING
        own, arm = moment.attitude(name), self.pushes.place(joint)
        going = self.touching_rate(joint, held)
        if going is None:
            return NOTHING
        carried = vector_sum(cross_product(own.alpha, arm), cross_product(own.omega, going))
        return vector_sum(moment.reference_acceleration(name), carried)

    def touching_rate(self, joint: Joint, held: Joint) -> Triple | None:
        """ṙ of the touching point of what is held besides, in the axes of its body; None where that is not known."""
        from rotsolve.space.rolling import shape_that_rolls, wheel_touching_rate

        moment, name = self.moment, joint.body.owner
        own = moment.attitude(name)
        if held.free and self.fixed(name):
            if shape_that_rolls(joint, moment).spherical:
                return cross_product(own.omega, moment.arm(joint.body))
            return cross_product(own.axes.rate, self.pushes.place(joint)) if own.axes.name == NODE else None
        if not moment.held.wheel(name) or shape_that_rolls(joint, moment).spherical:
            return None
        return IN_SPACE.to(own.axes, wheel_touching_rate(joint, moment))

    def slip(self, joint: Joint) -> Triple:
        """The velocity of the touching point of what rolls against the surface, as far as it is not told by how the body turns."""
        moment, name = self.moment, joint.body.owner
        if moment.held.rolling(name) is not None or joint.carrier.owner in moment.held.bodies:
            from rotsolve.space.rolling import Rolling

            return Rolling(joint, moment).slip()
        turning = cross_product(moment.attitude(name).omega, self.pushes.place(joint))
        return vector_sum(moment.reference_velocity(name), turning)

    def of_body(self, name: str) -> Iterator[Equation]:
        """Newton's second law and the rate of the angular momentum of a body."""
        pushes = list(self.pushes.on(name))
        if self.pushes.two_forces(name):
            return  # which are opposite along it
        if self.moment.state.steady:
            from rotsolve.space.lasting import going_along, refuse_passing

            refuse_passing(name, self.moment, self.pushes, pushes)
            yield from going_along(name, self.moment)
        self.refuse_loaded(name)
        yield from self.travelling(name, pushes)
        if not self.moment.held.pointlike(name):
            yield from self.rotation(name, pushes)
            yield from self.about_line(name, pushes)

    def refuse_loaded(self, name: str) -> None:
        """Refuse the approximation of a fast spin for a top that carries something: Ω² would stay in the forces of that."""
        held = self.moment.held
        carried = [
            joint for joint in held.joints if joint.carrier.owner == name and held.mass(joint.body.owner) != ZERO
        ]
        if self.fast and self.moment.nods(name) and carried:
            message = f"`{name}` carries `{carried[0].body.owner}`, and the spin is taken to be fast of a body alone"
            help = "make what moves as one the `parts` of one body, or leave `assume: [fast spin]` out"
            raise Unsolvable(message, span=carried[0].body.span, help=help)

    # points and words

    def fixed(self, name: str) -> bool:
        """Whether the point about which a body turns is at rest."""
        joint = self.moment.held.main(name)
        return joint is not None and joint.carrier.owner not in self.moment.held.bodies and not joint.sliding

    def about(self, name: str) -> tuple[Triple, str]:
        """The point about which the law of rotation is written, from the reference, and its name."""
        joint = self.moment.held.main(name)
        if joint is not None and self.fixed(name):
            return NOTHING, joint.body.point or "center"
        return self.moment.arm(PointRef(name, CM)), CM

    def pivot(self, name: str) -> tuple[Triple, str, Triple]:
        """The point about which the law of rotation is written, from the reference, its name, and its acceleration.

        A ball joint that is led along is one too: in axes that go with it −M a acts at the centre of mass, as the weight does.
        """
        moment, joint = self.moment, self.moment.held.main(name)
        carrier = None if joint is None else moment.held.bodies.get(joint.carrier.owner)
        if joint is not None and joint.free and carrier is not None and carrier.moved:
            return NOTHING, joint.body.point or "center", moment.reference_acceleration(name)
        return *self.about(name), NOTHING

    def own_tensor(self, ref: PointRef) -> InertiaTensor:
        """The tensor of a body about one of its points, in its own axes."""
        return self.tensors.about(ref.owner, self.moment.held.spot(ref), ref.point or "center")

    def tensor(self, name: str, point: str) -> InertiaTensor:
        """The tensor of a body about one of its points, in the axes of its attitude."""
        held, own = self.moment.held, self.moment.attitude(name)
        if name in held.links:
            from rotsolve.space.links import Link, link_tensor

            one, other = held.link(name)
            return link_tensor(Link(self.moment, name, (one, other)), self.own_tensor(held.named_point(name, point)))
        if self.moment.seen_from_space(name):
            about_any = self.own_tensor(held.named_point(name, point)).xx
            return InertiaTensor(about_any, about_any, about_any)
        axis = held.axis(name) if own.about is not None else None
        return in_axes(self.own_tensor(held.named_point(name, point)), own.own, own.about, axis)

    def carried_round(self, name: str, vector: Triple) -> Triple:
        """Ω × v: how a vector changes in space that stays the same in the axes of a body, because these turn."""
        return cross_product(self.moment.axes(name).rate, vector)

    def sought(self, value: Formula) -> bool:
        """Whether a component of L holds a rate that nothing tells, so that a letter for it would only stand in the way."""
        return bool(of_kinds(value.symbols(), (*RATES, "axial_rate", "angular_velocity")))

    def along(self, name: str, axis: str) -> str:
        """What an axis of a body's axes is called."""
        return NODE_NAMES[axis] if self.moment.axes(name).name == NODE else axis

    # the laws

    def travelling(self, name: str, pushes: list[ForceInSpace]) -> Iterator[Equation]:
        """Newton's second law; none of what holds others, or is held, and of which nothing tells how it stands in space."""
        try:
            yield from list(self.second_law(name, pushes))
        except Unsolvable as error:
            if not self.moment.axes(name).lost:
                raise
            self.untravelled[name] = error

    def rolls_round(self, joint: Joint | None) -> bool:
        """Whether what a joint holds rolls round a circle."""
        if joint is None:
            return False
        from rotsolve.space.rolling import Rolling

        return Rolling(joint, self.moment).goes_round() is not None

    def second_law(self, name: str, pushes: list[ForceInSpace]) -> Iterator[Equation]:
        """Σ F = m a, along the axes in which the force of the body's joint is written."""
        held, moment = self.moment.held, self.moment
        mass = held.mass(name)
        axes = self.newton_axes(name)
        forces = NOTHING
        for push in pushes:
            forces = vector_sum(forces, push.along(axes))
        wanted = [moment.tidy(part) for part in moment.acceleration_along(axes, PointRef(name, CM))]
        rolls = held.rolling(name)
        round_ = self.rolls_round(rolls)
        ground: Words = () if rolls is None else (ROUND if round_ else BY_ROLLING,)  # said once
        for axis, left, right in zip(self.names_of(axes), forces, wanted, strict=True):
            if left != ZERO or right != ZERO:
                words = f", along {axis}"
                told = of_kinds(right.symbols(), TURNS) or (round_ and right != ZERO)
                said, ground = (ground, ()) if told else ((), ground)
                yield SECOND_LAW.equation(left, multiply(mass, right), moment.when, (name,), said, component=words)

    def newton_axes(self, name: str) -> Axes:
        """The axes in which Newton's second law is written."""
        joints = self.moment.held.of_body(name)
        return self.pushes.reaction_axes(joints[0]) if joints else self.moment.named_axes("space", name)

    def names_of(self, axes: Axes) -> tuple[str, ...]:
        """What the three axes along which forces are written are called."""
        return tuple(NODE_NAMES.values()) if axes.name == NODE else names_along(axes)

    def momentum(self, name: str, point: str) -> Triple:
        """L = I ω about a point, in the axes of the body, as formulas of the letters of its tensor."""
        return product(self.tensor(name, point), self.moment.attitude(name).omega)

    def rotation(self, name: str, pushes: list[ForceInSpace]) -> Iterator[Equation]:
        """dL/dt = Στ: the components of L as letters, then the law along each axis."""
        own, (place, point, led) = self.moment.attitude(name), self.pivot(name)
        tensor, other = self.tensor(name, point), self.about(name)[1]
        letters, defined = self.letters_of(name, tensor, own, point)
        yield from defined
        if other != point:
            yield from self.letters_of(name, self.tensor(name, other), own, other)[1]
        if own.axes.name == AXIAL:
            return  # no torque acts: that is how it is told how it turns
        changes = product(tensor, own.rates)
        turning = self.carried_round(name, letters)
        torque = self.torque_about(name, pushes, place)
        felt = scaled_by(negate(self.moment.held.mass(name)), led)
        torque = vector_sum(torque, cross_product(self.moment.arm(PointRef(name, CM)), felt))
        plain = own.axes.name == NODE and self.goes_round_fast(name)
        where = f" about {point_in_words(point)}{'' if led == NOTHING else ', which is led along'}"
        for axis, left, change, across in zip(AXES, torque, changes, turning, strict=True):
            if (left, change, across) == (ZERO, ZERO, ZERO) or self.goes_on(name):
                continue
            if axis == "y" and own.axes.name == NODE and self.leans_upright(name, left):
                continue
            # what does not change in its axes turns with them
            rate = "Ω × L" if change == ZERO else "(dL/dt in the axes) + Ω × L"
            law = RATE_IN_STILL_AXES if plain or own.axes.rate == NOTHING else RATE_IN_AXES
            left, right, remark, common = self.divided(name, axis, left, add(change, across), own)
            right, small = self.of_fast_spin(name, right) if self.fast and own.axes.name == NODE else (right, ())
            yield law.equation(
                left,
                right,
                self.moment.when,
                (name,),
                (*small, *(("; ",) if small and remark else ()), *remark),
                relation="≈" if small else "=",
                common=common,
                rate=rate,
                about=where,
                # e₁ of a fast top is not spoken of
                along="" if plain and axis == "x" else f", along {self.along(name, axis)}",
            )

    def leans_upright(self, name: str, torque: Formula) -> bool:
        """Whether a torque along e₂ that is sought acts on what stands upright; one that is known is refused.

        It turns the axis off, which φ̈ sin θ does not tell where sin θ = 0: by that there would be none.
        """
        tilt = self.moment.told(name, "tilt")
        if tilt is None or torque == ZERO or self.moment.state.steady:
            return False
        if not self.moment.held.vanishes(heading(tilt).sin()):
            return False
        if has_quantities(torque) or torque.symbols() & self.moment.held.problem.sought:
            return True
        if not self.moment.held.vanishes(torque):
            words = f"`{name}` stands upright at {self.moment.spoken_of()}"
            message = f"{words}, where its tilt and precession don't tell which way its axis goes"
            help = f"tell `{name}.angular_velocity: [0, 0, w]` in place of its tilt and rates"
            raise Unsolvable(message, span=self.moment.held.bodies[name].span, help=help)
        return False

    def torque_about(self, name: str, pushes: list[ForceInSpace], place: Triple) -> Triple:
        """Στ about a place: of two bearings by letters of their own where it is asked, so that the law tells it at once."""
        joint = self.moment.held.main(name)
        couple = None
        if joint is not None and place == self.moment.arm(joint.body):
            couple = self.pushes.couple_of_bearings(joint)
        torque = NOTHING if couple is None else couple[0]
        for push in pushes:
            if couple is None or joint is None or push.owner != joint.owner:
                torque = vector_sum(torque, push.torque(place))
        return torque

    def couples_of_bearings(self) -> Iterator[Equation]:
        """The torque of two bearings, where it is asked, is that of their forces."""
        for joint in self.moment.held.joints:
            couple = self.pushes.couple_of_bearings(joint)
            for axis, letter, made in zip(AXES, *couple, strict=True) if couple is not None else ():
                if letter != made:
                    along = self.along(joint.body.owner, axis)
                    yield COUPLE_OF_BEARINGS.equation(
                        made, letter, self.moment.when, (joint.body.owner,), owner=spoken(joint.owner), axis=along
                    )

    def about_line(self, name: str, pushes: list[ForceInSpace]) -> Iterator[Equation]:
        """n · dL/dt = n · Στ of a body on two balls, n along the oblique line through both, about which their forces have no torque; of a
        shaft at a universal joint about its oblique axis, about which its hinge has none."""
        held, moment = self.moment.held, self.moment
        joint, balls = held.main(name), {item.owner for item in held.hinge_balls(name)}
        if joint is not None and not joint.powered and held.tied(name):
            balls = {joint.owner}
        if joint is None or not balls:
            return
        words = ", along the line through both balls" if held.hinge_balls(name) else ", along its axis"
        way, own = moment.direction(name, joint), moment.attitude(name)
        if is_axis(way) or self.goes_on(name):
            return
        place, point, _ = self.pivot(name)
        tensor = self.tensor(name, point)
        changed = vector_sum(product(tensor, own.rates), cross_product(own.axes.rate, self.momentum(name, point)))
        torque = vector_sum(NOTHING, *(push.torque(place) for push in pushes if push.owner not in balls))
        left, right = (moment.tidy(dot_product(way, vector)) for vector in (torque, changed))
        where = f" about {point_in_words(point)}"
        yield RATE_IN_STILL_AXES.equation(left, right, moment.when, (name,), about=where, along=words)

    def goes_on(self, name: str) -> bool:
        """Whether a fast top precesses as at a state before, where the law has been written: what was left out there was made of the spin,
        or of ω₃, so that it would not hold to the letter of the other here."""
        rate = self.moment.ask("precession", name) if self.fast else ZERO
        return isinstance(rate, Symbol) and is_key(rate.name) and key_of(rate.name).when != self.moment.when

    def of_fast_spin(self, name: str, right: Formula) -> tuple[Formula, Words]:
        """The rate of L without what is small where the spin is much faster than the precession: Ω² beside ω₃ Ω."""
        rate = self.moment.ask("precession", name)
        if not isinstance(rate, Symbol):
            return right, ()
        if (degree(right, rate.name) or 0) < 2:
            return right, ()
        none = {rate.name: ZERO}
        still, slope = (self.moment.tidy(part.substitute(none)) for part in (right, differentiate(right, rate.name)))
        return add(still, multiply(slope, rate)), ("the spin is fast: ", rate**2, " left out")

    def small_in(self, name: str, value: Formula, own: Attitude) -> bool:
        """Whether a fast spin leaves out what comes of a component of L beside another: the precession stands in it."""
        rate = self.moment.ask("precession", name) if self.fast and own.axes.name == NODE else ZERO
        return bool(rate.symbols() & value.symbols())

    def goes_round_fast(self, name: str) -> bool:
        """Whether the laws of a top are told as those of L along its axis, the level part of which goes round: M g r sin θ = L Ω sin θ,
        of a fast spin and steady precession. A step divides by sin θ: where θ is sought, the law without it is."""
        if not self.fast or not self.moment.state.steady:
            return False
        tilt = self.moment.nodding(name).angles[1]
        return not has_quantities(tilt) and not tilt.symbols() & self.moment.held.problem.sought

    def divided(
        self, name: str, axis: str, left: Formula, right: Formula, own: Attitude
    ) -> tuple[Formula, Formula, Words, Formula]:
        """A law along e₁ without sin θ, with its remark; of a fast top as it is, with sin θ for a step to divide by."""
        if axis != "x" or own.axes.name != NODE:
            return left, right, (), ONE
        without = self.without_sine(name, left, right)
        if without[2] and self.goes_round_fast(name):
            return left, right, (), heading(self.moment.nodding(name).angles[1]).sin()
        return *without, ONE

    def without_sine(self, name: str, left: Formula, right: Formula) -> tuple[Formula, Formula, Words]:
        """Both sides divided by sin θ, where each is a multiple of it and θ is not 0."""
        tilt = self.moment.nodding(name).angles[1]
        sine = heading(tilt).sin()
        if not isinstance(tilt, Symbol) or ZERO in (left, right) or sine == ZERO:
            return left, right, ()
        upright = {tilt.name: ZERO}
        try:
            multiples = all(is_zero(side.substitute(upright)) for side in (left, right))
        except ZeroDivisionError:  # a told rate has no value at θ = 0
            multiples = False
        if not multiples:
            return left, right, ()
        tidy = self.moment.tidy
        return tidy(left / sine), tidy(right / sine), (sine, " ≠ 0 divided out")

    def letters_of(self, name: str, tensor: InertiaTensor, own: Attitude, point: str) -> tuple[Triple, list[Equation]]:
        """The components of L as letters with what defines them; one that is a mere multiple of a given stays as it is."""
        found, defined = [], []
        where = f" about {point_in_words(point)}"
        moved = self.moment.held.bodies[name].moved  # of what is led no law is written
        plain = moved or (own.axes.name == NODE and self.goes_round_fast(name))
        for axis, value in zip(AXES, product(tensor, own.omega), strict=True):
            if value == ZERO or plain or self.sought(value) or self.small_in(name, value, own):
                found.append(value)
                continue
            index = {"x": "1", "y": "2", "z": "3"}[axis] if own.axes.name == NODE else axis
            letter = self.moment.ask("angular_momentum", name, f"{index}", kind=f"angular_momentum about {point}")
            found.append(letter)
            defined.append(
                ANGULAR_MOMENTUM_IN_SPACE.equation(
                    letter, value, self.moment.when, (name,), about=where, axis=self.along(name, axis)
                )
            )
        return (found[0], found[1], found[2]), defined
