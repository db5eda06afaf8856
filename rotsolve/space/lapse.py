"""Lapse: how a body on which nothing turns stands, turns and flies some time after a state, in closed form.

L is constant in space. What turns about L goes on so. A body that is symmetric about e₃ goes round L at L/I₁ and meanwhile turns about its
axis at ψ̇ = ω₃ (I₁ − I₃)/I₁ (Landau & Lifshitz, Mechanics, §33; Goldstein, Poole & Safko, Classical Mechanics, §5.6); of any other ω goes by
elliptic functions (`asymmetric`), by which it is told how it stands (`herpolhode`). A steady precession goes on as it is. About a fixed
axis a constant torque makes ω = ω₀ + α t, and a centre of mass that nothing holds falls, v = v₀ − g t ẑ.
"""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.calculus.integral import integrate
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import HALF, ONE, ZERO, Formula, Symbol, add, multiply, negate
from rotsolve.algebra.units.dimension import ANGULAR_MOMENTUM, ANGULAR_VELOCITY, Dimension
from rotsolve.core.equation import IN_TIME, PART_IN_TIME, Equation
from rotsolve.core.registry import SceneQuantity
from rotsolve.core.remembered import remembered
from rotsolve.core.symbols import MOMENTUM_SIZE, TIME, phase_midst
from rotsolve.core.vectors.triple import (
    AXES,
    NOTHING,
    Rows,
    Triple,
    Z,
    after,
    dot_product,
    is_axis,
    length_of,
    rotated,
    scaled_by,
    triple,
    turn_about,
    vector_sum,
    way_between,
)
from rotsolve.language.bodies import Joint
from rotsolve.space.arrangement import ANGLES, RATES
from rotsolve.space.attitude import AXIAL, BODY, IN_SPACE, NODE, Attitude, Axes, Onward
from rotsolve.space.free import along_momentum, symmetric_way, turns_freely
from rotsolve.space.inertia import entry_along
from rotsolve.space.laws import SpaceLaws
from rotsolve.space.moment import SpaceMoment
from rotsolve.space.passing import left_alone
from rotsolve.space.rolled_on import rolled_rates, rolled_way, rolls_evenly
from rotsolve.space.spun_up import even_drive, faster_evenly, goes_by_time


class Lapse:
    """What happens from the moment of `before` up to a later one, with no event between.

    `laws` are what defines the letters of all that has been asked so far. `whole` is the time that passes by way of states between.
    """

    def __init__(self, before: SpaceLaws, later: SpaceMoment, *, whole: Formula | None = None) -> None:
        self.before, self.later, self.held, self.whole = before, later, later.held, whole
        self.laws: dict[Equation, None] = {}

    def passed(self) -> Formula | None:
        """The time that has passed: as the later state tells it, t − t₀ in the midst of a phase; None where nothing tells it."""
        if self.whole is not None:
            return self.whole
        if not phase_midst(self.later.at):
            return self.later.state.time_told
        start = self.before.moment.clock()
        return None if start is None else simplify(add(Symbol(TIME), negate(start)))

    def letter(self, name: str, kind: str, letter: str, dimension: Dimension, value: Formula, words: str) -> Formula:
        """A letter of a body at the earlier moment, for what stays as it is from then on, with what it stands for."""
        when = self.before.moment.when
        symbol = self.before.moment.registry.ask(SceneQuantity(kind, name, when, "", letter, dimension))
        self.laws[PART_IN_TIME.equation(symbol, value, when, (name,), words=words)] = None
        return symbol

    def equations(self) -> Iterator[Equation]:
        """What defines the letters that have been asked for, and the motion of bodies on hinges."""
        for name in self.held.order:
            if self.hinged(name):
                yield from self.about_hinge(name)
            time = self.passed()
            if time is not None and self.rolls_evenly(name):
                self.later.hangs_on_time()
                yield from rolled_rates(name, self.before, self.later, time)
            yield from self.told_of_flight(name)
        yield from self.laws

    # which motions go on in closed form

    def alone(self, name: str) -> bool:
        """Whether nothing acts on a body but its weight and an ideal joint, for a time that is told."""
        return left_alone(self.before, name) and self.passed() is not None

    @remembered
    def turns_freely(self, name: str) -> bool:
        """Whether the angular momentum of a body stays, for a time that is told."""
        return self.passed() is not None and turns_freely(self.before, name)

    @remembered
    def keeps_vertical(self, name: str) -> bool:
        """Whether what turns about a fixed point keeps its angular momentum about the vertical: the weight has no torque about that."""
        joint = self.held.main(name)
        return joint is not None and joint.free and not self.held.pointlike(name) and self.alone(name)

    @remembered
    def steady(self, name: str) -> bool:
        """Whether a body of which Euler angles are told precesses steadily from the earlier moment on."""
        moment = self.before.moment
        earlier = moment.onward
        still = moment.state.steady or (earlier is not None and earlier.steady(name))
        return still and moment.nods(name) and not self.held.falls(name) and self.alone(name)

    @remembered
    def rolls_evenly(self, name: str) -> bool:
        """Whether a ball rolls on with a constant angular acceleration."""
        return rolls_evenly(self.before, name)

    def hinged(self, name: str) -> bool:
        """Whether a body turns about a fixed axis with a constant angular acceleration, or as it is driven by a formula of time."""
        return self.acceleration(name) is not None or self.driven_way(name) is not None

    # Euler angles of a steady precession

    def told(self, name: str, word: str) -> Formula | None:
        """An Euler angle of a body that precesses steadily, or the rate of one: φ = φ₀ + φ̇ t, ψ = ψ₀ + ψ̇ t."""
        time, turning = self.passed(), self.before.moment.nodding(name)
        if word not in (*ANGLES, *RATES) or time is None:
            return None
        if word in RATES:
            return turning.rates[RATES.index(word)]
        number = ANGLES.index(word)
        return add(turning.angles[number], multiply(turning.rates[number], time))

    # bodies that turn about no fixed axis

    @remembered
    def attitude(self, name: str) -> Attitude | None:
        """How a body stands and turns on which no torque acts; None of others, or where it is not told how it stood."""
        if not self.turns_freely(name) or self.steady(name):
            return None
        earlier = self.before.moment.onward
        if earlier is not None and earlier.turns_freely(name):
            whole = earlier.up_to(self)
            found = whole.attitude(name)
            self.laws.update(dict.fromkeys(whole.laws))
            return found
        time, start = self.passed(), self.before.moment.attitude(name)
        assert time is not None
        if start.omega == NOTHING or along_momentum(self.before, name):
            return self.uniform(name, start, time)
        way = symmetric_way(self.held, name)
        if way is not None:
            return self.cone(name, start, way, time)
        return self.elliptic(name, start, time)

    def up_to(self, further: Onward) -> Lapse:
        """From the same moment on, through what comes after it."""
        first, then = self.passed(), further.passed()
        assert first is not None and then is not None
        return Lapse(self.before, further.later, whole=simplify(add(first, then)))

    def momentum(self, name: str) -> Triple:
        """L at the earlier moment, in the axes of the body, as letters."""
        own, (_, point) = self.before.moment.attitude(name), self.before.about(name)
        return self.before.letters_of(name, self.before.tensor(name, point), own, point)[0]

    def size_of_momentum(self, name: str, size: Formula) -> Formula:
        """|L| as a letter."""
        words = "size of the angular momentum, which stays in space"
        return self.letter(name, MOMENTUM_SIZE, "L", ANGULAR_MOMENTUM, size, words)

    def own_rows(self, name: str, start: Attitude) -> Rows:
        """What turns a body's own components into those of its axes at the earlier moment, the spin angle of node axes too."""
        spun = start.axes.name == NODE and self.before.moment.nods(name)
        return after(turn_about(Z, self.before.moment.nodding(name).angles[2]), start.own) if spun else start.own

    def uniform(self, name: str, start: Attitude, time: Formula) -> Attitude:
        """A body that goes on turning with the same ω, its axes with it."""
        rows = start.axes.rows
        if start.omega != NOTHING:
            way, rate = along_and_size(start.omega)
            rows = after(rows, turn_about(way, multiply(rate, time)))
        axes = Axes(AXIAL, rows, start.omega, NOTHING, start.axes.lost, base=rows)
        return Attitude(axes, self.own_rows(name, start), start.omega, NOTHING, start.about)

    def cone(self, name: str, start: Attitude, way: Triple, time: Formula) -> Attitude:
        """A symmetric body in axes that go round L with its own axis, at L/I₁, in which L and ω stay; it turns in them by ψ̇."""
        own, momentum = self.own_rows(name, start), self.momentum(name)
        axis = rotated(own, way)
        tensor = self.before.tensor(name, self.before.about(name)[1])
        axial, other = (entry_along(tensor, direction) for direction in (axis, rotated(own, (way[1], way[2], way[0]))))
        direction, size = along_and_size(momentum)
        if not is_axis(momentum):
            size = self.size_of_momentum(name, size)
            direction = triple([part / size if part != ZERO else ZERO for part in momentum])
        words = "its axis goes round its angular momentum, φ̇ = L/I₁"
        rate = self.letter(name, "rate about the angular momentum", "Omega", ANGULAR_VELOCITY, size / other, words)
        words = "it turns about its axis meanwhile, ψ̇ = ω₃ (I₁ − I₃)/I₁"
        share = multiply(dot_product(start.omega, axis), add(other, negate(axial)) / other)
        spin = self.letter(name, "rate about its own axis", "s", ANGULAR_VELOCITY, share, words)
        rows = after(start.axes.rows, turn_about(direction, multiply(rate, time)))
        axes = Axes(AXIAL, rows, scaled_by(1 / other, momentum), NOTHING, start.axes.lost, base=rows)
        about = axis if way == self.held.axis(name) else None
        return Attitude(axes, after(turn_about(axis, multiply(spin, time)), own), start.omega, NOTHING, about)

    def elliptic(self, name: str, start: Attitude, time: Formula) -> Attitude:
        """An asymmetric body: its ω in its own axes, and these in space, as letters with what they are."""
        from rotsolve.space.asymmetric import Polhode
        from rotsolve.space.herpolhode import Herpolhode

        polhode, later = Polhode(self.before, name), self.later
        omega, rates = (
            triple([later.ask(word, name, axis) for axis in polhode.names])
            for word in ("angular_velocity", "angular_acceleration")
        )
        found = polhode.rates(time)
        self.laws.update(polhode.laws)
        for axis, letter, value in zip(polhode.names, omega, found, strict=True):
            words = f"ω along its own {axis} axis, by Euler's equations"
            self.laws[PART_IN_TIME.equation(letter, value, later.when, (name,), words=words)] = None
        momentum = self.momentum(name)
        about = Herpolhode(polhode, later, momentum, self.size_of_momentum(name, length_of(momentum)))
        rows = about.rows(start.axes.rows, omega, time)
        self.laws.update(about.laws)
        self.laws.update(polhode.laws)
        return Attitude(Axes(BODY, rows, omega, rates, start.axes.lost, base=rows), start.own, omega, rates)

    # about a fixed axis

    @remembered
    def acceleration(self, name: str) -> Formula | None:
        """α of a body on a hinge where it is constant: as it is driven, or, on the ground, where nothing that acts on it, or on what it
        carries, has a torque that changes; None of others."""
        joint = self.held.main(name)
        if joint is None or not joint.turning or joint.sliding or self.passed() is None:
            return None
        return even_drive(joint) if joint.drive else faster_evenly(self.before, name)

    def about_hinge(self, name: str) -> Iterator[Equation]:
        """ω = ω₀ + α t and φ = φ₀ + ω₀ t + ½ α t²; as it is driven by a formula of time, their integrals."""
        joint, time, faster = self.held.main(name), self.passed(), self.acceleration(name)
        assert joint is not None and time is not None
        if faster is None:
            yield from self.as_driven(name, joint)
            return
        first, when = self.before.moment, self.later.when
        rate = first.rate_on(name, joint)
        steady = "turns steadily" if faster == ZERO else "constant angular acceleration"
        later = self.later.rate_on(name, joint)
        if "angular_velocity" not in dict(joint.drive):
            right = add(rate, multiply(faster, time))
            yield IN_TIME.equation(later, right, when, (name,), words=f"{steady}, ω = ω₀ + α t")
        angle = first.stood(name, "angle")
        if angle is not None:
            way = add(multiply(rate, time), multiply(multiply(HALF, faster), multiply(time, time)))
            own = self.later.ask("angle", name)
            yield IN_TIME.equation(own, add(angle, way), when, (name,), words=f"{steady}, angle turned")

    @remembered
    def driven_way(self, name: str) -> tuple[Formula, Formula] | None:
        """How much faster a body turns that is driven by a formula of time, and how far it has turned: ∫ α dt, ∫ ω dt.

        None of others, or where the integrals have no closed form.
        """
        joint, time, start = self.held.main(name), self.passed(), self.before.moment.clock()
        drive = dict(joint.drive) if joint is not None and len(joint.drive) == 1 else {}
        if joint is None or time is None or start is None or not any(map(goes_by_time, drive.values())):
            return None
        end, positive = add(start, time), self.later.positive
        rate, gained = drive.get("angular_velocity"), None
        if "angular_acceleration" in drive:
            so_far = integrate(drive["angular_acceleration"], TIME, start, Symbol(TIME), positive=positive)
            gained = integrate(drive["angular_acceleration"], TIME, start, end, positive=positive)
            rate = None if so_far is None else add(self.before.moment.rate_on(name, joint), so_far)
        way = None if rate is None else integrate(rate, TIME, start, end, positive=positive)
        if way is None or ("angular_acceleration" in drive and gained is None):
            return None
        return (ZERO if gained is None else gained), way

    def as_driven(self, name: str, joint: Joint) -> Iterator[Equation]:
        """ω = ω₀ + ∫ α dt where that is driven, and φ = φ₀ + ∫ ω dt."""
        found, first, when = self.driven_way(name), self.before.moment, self.later.when
        assert found is not None
        gained, way = found
        if "angular_acceleration" in dict(joint.drive):
            own, rate = (moment.rate_on(name, joint) for moment in (self.later, first))
            yield IN_TIME.equation(own, add(rate, gained), when, (name,), words="as it is driven, ω = ω₀ + ∫ α dt")
        angle = first.stood(name, "angle")
        if angle is not None:
            own = self.later.ask("angle", name)
            yield IN_TIME.equation(own, add(angle, way), when, (name,), words="as it is driven, φ = φ₀ + ∫ ω dt")

    # flight

    def centre_velocity(self, name: str) -> Triple | None:
        """v₀ − g t ẑ of the centre of mass of a body that nothing holds, in space axes; None of others."""
        if self.held.of_body(name) or not self.alone(name):
            return None
        start, gravity = self.before.moment.of_centre(name, "velocity"), self.before.pushes.gravity
        return start if gravity is None else way_between(scaled_by(gravity, self.fallen()[0]), start)

    def centre_way(self, name: str) -> Triple | None:
        """v₀ t − ½ g t² ẑ, how far that has gone, or what rolls with a constant acceleration; None of others."""
        time, gravity = self.passed(), self.before.pushes.gravity
        if time is not None and self.rolls_evenly(name):
            return rolled_way(name, self.before, time)
        if self.held.of_body(name) or not self.alone(name):
            return None
        assert time is not None
        gone = scaled_by(time, self.before.moment.of_centre(name, "velocity"))
        return gone if gravity is None else way_between(scaled_by(gravity, self.fallen()[1]), gone)

    def told_of_flight(self, name: str) -> Iterator[Equation]:
        """What the later state tells of how a centre of mass that nothing holds goes, and where it is: as it has fallen by then."""
        later, before = self.later, self.before.moment
        if self.held.bodies[name].moved:
            return
        flown, gone = self.centre_velocity(name), self.centre_way(name)
        told = later.vector_told(name, "velocity") if flown is not None else None
        if flown is not None and told is not None and not told[2]:
            own = later.named_axes(told[1], name).to(IN_SPACE, told[0])
            yield from self.in_time(own, flown, name, "falls freely, v = v₀ − g t")
        told, first = (moment.vector_told(name, "position") if gone is not None else None for moment in (later, before))
        if gone is not None and told is not None and first is not None and not (told[2] or first[2]):
            rolls = self.rolls_evenly(name)
            words = "rolls, r = r₀ + v₀ t + ½ a t²" if rolls else "falls freely, r = r₀ + v₀ t − ½ g t²"
            yield from self.in_time(told[0], vector_sum(first[0], gone), name, words)

    def in_time(self, told: Triple, led: Triple, name: str, words: str) -> Iterator[Equation]:
        """What is told at the later moment as what the time that has passed leads to, by components."""
        self.later.hangs_on_time()
        for axis, one, other in zip(AXES, told, led, strict=True):
            if one != other:
                yield IN_TIME.equation(one, other, self.later.when, (name,), words=f"{words}, along {axis}")

    def fallen(self) -> tuple[Triple, Triple]:
        """How much faster downwards what nothing holds is, and how far it has fallen, for a unit of g: t ẑ and ½ t² ẑ, where that keeps
        its direction."""
        time = self.passed()
        assert time is not None
        if self.held.problem.gravity_in:
            from rotsolve.space.weight_in_frame import falling_from

            falling = falling_from(self.before.moment)
            return falling.speed(time), falling.way(time)
        return scaled_by(time, Z), scaled_by(multiply(HALF, multiply(time, time)), Z)


def along_and_size(vector: Triple) -> tuple[Triple, Formula]:
    """A unit vector and the size of a vector along it, which may be negative where it lies along an axis."""
    if is_axis(vector):
        size = next(part for part in vector if part != ZERO)
        return triple([ZERO if part == ZERO else ONE for part in vector]), size
    size = length_of(vector)
    return triple([part if part == ZERO else part / size for part in vector]), size
