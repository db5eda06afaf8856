"""Coordinates: the numbers by which the motion of a scene in space is followed: letters, first values, and their rates.

q̇ = ½ q Ω of a unit quaternion, Ω in its own axes (Goldstein, Poole & Safko, Classical Mechanics, §4.5); angles have the rates about
their axes; rates change as the laws tell. What the first state tells is taken from its own moment; rates that it leaves open are nothing.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence

from msgspec import Struct

from rotsolve.algebra.flints import arb
from rotsolve.algebra.formula import ONE, ZERO, Formula, Symbol, add, multiply, negate
from rotsolve.algebra.tape import ZERO as NONE
from rotsolve.algebra.tape import Exact
from rotsolve.core.symbols import RATES as SPEEDS
from rotsolve.core.symbols import has_quantities, key_of
from rotsolve.core.vectors.heading import heading
from rotsolve.core.vectors.triple import AXES, Rows, Triple, after, rotated, transposed
from rotsolve.language.bodies import Joint
from rotsolve.paths.meaning import NotYet
from rotsolve.simulation.space.course import CourseMoment
from rotsolve.simulation.tape import vanishes
from rotsolve.space.arrangement import ANGLES, RATES
from rotsolve.space.attitude import Attitude
from rotsolve.space.moment import SpaceMoment
from rotsolve.space.rolling import Rolling
from rotsolve.space.thin import thin_axis

OPEN = (*RATES, *SPEEDS, "axial_rate")  # what is nothing at first where nothing tells it
Worth = Callable[[Formula], Exact]  # the number that a formula of givens is


class Coordinate(Struct, frozen=True):
    """One number of the state of motion: its letter, its first value, its rate, and the vector to which it belongs."""

    name: str
    letter: str
    start: Exact
    rate: Formula
    vector: str = ""


class Coordinates(Struct):
    """The numbers of a scene: `moment` is that of any time, `first` that of the first state, `worth` tells numbers."""

    moment: CourseMoment
    first: SpaceMoment
    worth: Worth

    def all(self) -> Iterator[Coordinate]:
        for name in self.moment.held.order:
            yield from self.of_turning(name)
            yield from self.of_travel(name)

    def at_first(self, value: Formula) -> Exact:
        """The number of a formula of the first state, in which rates that are left open are nothing."""
        keys = {name: key_of(name) for name in value.symbols()}
        idle = {name: ZERO for name, key in keys.items() if key.kind in OPEN}
        value = value.substitute(idle)
        if has_quantities(value):
            place = next(key for name, key in keys.items() if key.kind and name not in idle)
            line = f"{place.owner}.{place.kind}"
            raise NotYet(
                f"the {place.kind} of `{place.owner}` at first is not told", help=f"let the first state say `{line}`"
            )
        return self.worth(value)

    def of_turning(self, name: str) -> Iterator[Coordinate]:
        """What tells how a body stands and turns."""
        moment, joint = self.moment, self.moment.held.main(name)
        self.refuse_untold_spin(name)
        if moment.turns_anyhow(name):
            yield from self.of_quaternion(name)
        elif moment.nods(name):
            yield from self.of_euler_angles(name)
        elif joint is not None and joint.turning and not moment.held.bodies[name].moved:
            yield from self.of_hinge(name, joint)

    def refuse_untold_spin(self, name: str) -> None:
        """Refuse a body that precesses at first, while nothing tells whether it does so without spin, or without turning about its axis."""
        first = self.first
        if not first.nods(name) or not first.left_open(name)[0] or thin_axis(first.held, name) is not None:
            return
        rate = first.nodding(name).rates[0]
        if not has_quantities(rate) and not first.held.vanishes(rate):
            help = f"tell its `{name}.spin` or its `{name}.axial_rate`"
            raise NotYet(f"how fast `{name}` spins at first is not told", help=help)

    # about any axis

    def of_quaternion(self, name: str) -> Iterator[Coordinate]:
        """Four numbers for how its axes stand, three for its angular velocity, one for its own spin in them."""
        moment, own = self.moment, self.moment.attitude(name)
        q, rows = moment.quaternion(name), self.first_rows(name, own)
        parts = zip(q, unit_quaternion(rows, self.at_first), quaternion_rates(q, own.axes.rate), strict=True)
        for letter, start, rate in parts:
            yield Coordinate(f"{name}.{key_of(letter.name).component}", letter.name, start, rate, f"{name}.turn")
        rates, starts = zip(own.omega, own.rates, strict=True), self.first_rates(name, rows)
        if moment.led_round(name):
            rates, starts = zip(*moment.led_rates(name), strict=True), self.first_led(name)
        for axis, (speed, rate), start in zip(AXES, rates, starts, strict=True):
            if isinstance(speed, Symbol):
                yield self.coordinate(f"{name}.rate.{axis}", speed, start, rate, f"{name}.rate")
        if moment.unspun(name) is not None:
            yield self.coordinate(f"{name}.turned", moment.spun(name), ZERO, own.omega[2])

    def first_rows(self, name: str, own: Attitude) -> Rows:
        """How the axes of a body stand at first: those of the body, its own axis along e₃."""
        return after(self.first.own_axes(name).rows, transposed(own.own))

    def first_rates(self, name: str, rows: Rows) -> Triple:
        """The angular velocity at first in these axes."""
        found = self.first.attitude(name)
        joint = self.first.held.rolling(name)
        if joint is not None and self.first.seen_from_space(name):
            return rotated(transposed(rows), Rolling(joint, self.first).turning())
        if found.axes.rows == rows:
            return found.omega
        return rotated(transposed(rows), rotated(found.axes.rows, found.omega))

    def first_led(self, name: str) -> Triple:
        """The angular velocity with which a body is led at first, in space."""
        told = {(word, axis): value for word, axis, value in self.moment.held.bodies[name].moved}
        x, y, z = (self.first.now(told.get(("angular_velocity", axis), ZERO)) for axis in AXES)
        return (x, y, z)

    # by angles

    def of_euler_angles(self, name: str) -> Iterator[Coordinate]:
        """φ, θ, ψ; φ̇ and θ̇; ω₃ of a symmetric body, from which ψ̇ = ω₃ − φ̇ cos θ follows, else ψ̇."""
        now, first, own = self.moment.nodding(name), self.first.nodding(name), self.moment.attitude(name)
        if self.at_first(heading(first.angles[1]).sin()) == 0:
            raise NotYet(f"`{name}` lies flat at first: so it does not roll")
        along, axial = self.first.attitude(name).omega[2], own.omega[2]
        if not isinstance(axial, Symbol):
            raise NotYet(f"how `{name}`, which is not symmetric about its axis, rolls on is not followed")
        spin = add(axial, negate(multiply(now.rates[0], heading(now.angles[1]).cos())))
        rates = (now.rates[0], now.rates[1], spin)
        for word, letter, start, rate in zip(ANGLES, now.angles, first.angles, rates, strict=True):
            yield self.coordinate(f"{name}.{word}", letter, start, rate)
        for word, letter, start, rate in zip(RATES[:2], now.rates, first.rates, now.seconds, strict=False):
            yield self.coordinate(f"{name}.{word}", letter, start, rate)
        yield self.coordinate(f"{name}.axial_rate", axial, along, own.rates[2])

    def of_hinge(self, name: str, joint: Joint) -> Iterator[Coordinate]:
        """The angle about a hinge or axle and its rate, as far as nothing drives them."""
        angle = self.moment.hinge_angle(name, joint)
        word, rate, faster = self.moment.about_hinge(name, joint)
        if isinstance(angle, Symbol):
            told = self.first.stood(name, "angle")
            yield self.coordinate(f"{name}.angle", angle, ZERO if told is None else told, rate)
        if isinstance(rate, Symbol):
            yield self.coordinate(f"{name}.{word}", rate, self.first.driven(name, joint, word)[0], faster)

    def coordinate(self, name: str, letter: Formula, start: Formula, rate: Formula, vector: str = "") -> Coordinate:
        assert isinstance(letter, Symbol)
        return Coordinate(name, letter.name, self.at_first(start), rate, vector)

    def rotations(self) -> Iterator[tuple[str, Formula]]:
        """The letters of the entries of rotations, each with what it is by its quaternion."""
        for name in self.moment.held.order:
            if self.moment.turns_anyhow(name):
                ways = ((one, other) for one in AXES for other in AXES)
                for (one, other), value in zip(ways, rotation_entries(self.moment.quaternion(name)), strict=True):
                    yield self.moment.entry_letter(name, one, other).name, value

    # places

    def of_travel(self, name: str) -> Iterator[Coordinate]:
        """The way of the centre of mass of a body that nothing holds, since the first state, and its velocity, along the axes of space."""
        moment = self.moment
        if moment.held.main(name) is not None:
            return
        velocity, faster = (moment.of_centre(name, word) for word in ("velocity", "acceleration"))
        starts = self.first.of_centre(name, "velocity")
        parts = zip(AXES, moment.way_gone(name), velocity, faster, starts, strict=True)
        for axis, letter, speed, rate, start in parts:
            yield self.coordinate(f"{name}.position.{axis}", letter, ZERO, speed, f"{name}.position")
            if isinstance(speed, Symbol) and key_of(speed.name).kind == "velocity":
                yield self.coordinate(f"{name}.velocity.{axis}", speed, start, rate, f"{name}.velocity")


def quaternion_rates(q: Sequence[Symbol], omega: Triple) -> list[Formula]:
    """½ q Ω, Ω in the axes that q turns into space."""
    w, x, y, z = q
    a, b, c = omega
    signed = (
        ((x, a, -1), (y, b, -1), (z, c, -1)),
        ((w, a, 1), (y, c, 1), (z, b, -1)),
        ((w, b, 1), (z, a, 1), (x, c, -1)),
        ((w, c, 1), (x, b, 1), (y, a, -1)),
    )
    found = []
    for terms in signed:
        total: Formula = ZERO
        for part, rate, sign in terms:
            term = multiply(part, rate)
            total = add(total, term if sign > 0 else negate(term))
        found.append(multiply(ONE / 2, total))
    return found


def rotation_entries(q: Sequence[Symbol]) -> list[Formula]:
    """The nine entries of the rotation of a unit quaternion, row by row."""
    w, x, y, z = q

    def entry(one: Formula, other: Formula) -> Formula:
        return 2 * ONE * add(one, other)

    return [
        add(ONE, negate(entry(y * y, z * z))),
        entry(x * y, negate(w * z)),
        entry(x * z, w * y),
        entry(x * y, w * z),
        add(ONE, negate(entry(x * x, z * z))),
        entry(y * z, negate(w * x)),
        entry(x * z, negate(w * y)),
        entry(y * z, w * x),
        add(ONE, negate(entry(x * x, y * y))),
    ]


def unit_quaternion(rows: Rows, worth: Worth) -> list[Exact]:
    """The unit quaternion of a rotation: the 4 qᵢ qⱼ are sums of entries, each row of them qᵢ times q."""
    (a, b, c), (d, e, f), (g, h, i) = rows
    table = (
        (ONE + a + e + i, h - f, c - g, d - b),
        (h - f, ONE + a - e - i, b + d, c + g),
        (c - g, b + d, ONE - a + e - i, f + h),
        (d - b, c + g, f + h, ONE - a - e + i),
    )
    squares = [arb(worth(row[k])) for k, row in enumerate(table)]
    most = max(range(4), key=lambda k: float(squares[k].mid()))
    parts = [worth(part) / (2 * squares[most].sqrt()) for part in table[most]]
    return [NONE if vanishes(part) else part for part in parts]
