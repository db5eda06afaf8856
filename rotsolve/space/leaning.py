"""Leaning: how a body stands and turns by its Euler angles, as far as a state tells them; what is refused of that by name."""

from __future__ import annotations

from rotsolve.algebra.formula import PI, ZERO, Call, Formula, Quotient
from rotsolve.core.faults import Unsolvable
from rotsolve.core.remembered import remembered
from rotsolve.core.vectors.triple import Triple, triple
from rotsolve.language.problem import EXTREMES
from rotsolve.space.arrangement import ANGLES, RATES
from rotsolve.space.attitude import Attitude, Nodding, in_euler_angles, nodding, permutation
from rotsolve.space.telling import TellingMoment


class LeaningMoment(TellingMoment):
    """One state, with the Euler angles of its bodies."""

    before: LeaningMoment | None

    def nods(self, name: str) -> bool:
        """Whether the scene speaks of a body's tilt, precession or spin."""
        joint = self.held.main(name)
        return name in self.held.nodding and (joint is None or joint.free or self.held.carrier(name) == "")

    def _nods(self, name: str) -> Attitude:
        """A body by its Euler angles; with ω₃ for ψ̇ + φ̇ cos θ where the state does not tell the spin."""
        lines = self.line(name, "spin"), self.line(name, "axial_rate")
        if lines[0] is not None and lines[1] is not None:
            help = "`spin` is ψ̇, relative to the line of nodes; `axial_rate` is ω₃ = ψ̇ + φ̇ cos θ: give one of them"
            raise Unsolvable(f"`{name}` has both a `spin` and an `axial_rate`", span=lines[1].span, help=help)
        upright = self.line(name, "vertical", "x")
        if upright is not None:
            message = f"how `{name}` stands is told by its Euler angles and by its `vertical`"
            raise Unsolvable(message, span=upright.span, help="leave one of them out")
        axis = self.held.axis(name)
        if axis is None:
            raise Unsolvable(f"`{name}` has no axis: its tilt and spin have no meaning", help="give it `axis: z`")
        if self.rests(name):
            self.refuse_turning(name)
        if self.state.steady:
            self.refuse_shaken(name)
        turning, symmetric = self.nodding(name), self.held.turns_round(name, axis)
        if not symmetric and self.state.steady:
            self.refuse_unsteady(name, axis)
        found = (nodding if symmetric else in_euler_angles)(turning, permutation(axis))
        if not symmetric or self.told(name, "spin") is not None or self.rests(name):
            return found
        axial, faster = self.ask("axial_rate", name), self.rate_of("axial_rate", name)
        omega, rates = (found.omega[0], found.omega[1], axial), (found.rates[0], found.rates[1], faster)
        return Attitude(found.axes, found.own, omega, rates, found.about)

    def refuse_turning(self, name: str) -> None:
        """Refuse a rate that a state tells of a body which it says to be at rest."""
        for word in (*RATES, "axial_rate"):
            line = self.line(name, word)
            if line is not None and line.value is not None and not self.held.vanishes(line.value):
                message = f"`{name}` is at rest at {self.spoken_of()}, and its `{word}` is told"
                raise Unsolvable(message, span=line.span, help="leave one of them out")

    def refuse_shaken(self, name: str) -> None:
        """Refuse a steady precession about the vertical of what is held at a point that is accelerated sideways."""
        carrier, rate = self.held.bodies.get(self.held.carrier(name)), self.told(name, "precession")
        if rate is not None and self.held.vanishes(rate):
            return  # it leans, and stays so
        led = [(axis, value) for word, axis, value in (carrier.moved if carrier else ()) if word == "acceleration"]
        upright = self.nodding(name).angles[1] in (ZERO, PI)
        if carrier is None or upright or all(axis == "z" or self.held.vanishes(value) for axis, value in led):
            return
        joint = self.held.main(name)
        message = (
            f"`{name}` does not precess steadily about the vertical: `{carrier.name}` accelerates its point sideways"
        )
        help = "it does so about the weight that is felt there: draw z along g − a, and give `gravity` its size"
        raise Unsolvable(message, span=None if joint is None else joint.body.span, help=help)

    def refuse_unsteady(self, name: str, axis: Triple) -> None:
        """Refuse a steady precession of a body that spins and is not symmetric, or of which letters do not tell whether it is."""
        told = next((line for word in ("spin", "axial_rate") if (line := self.line(name, word)) is not None), None)
        if told is None or told.value is None or self.held.vanishes(told.value):
            return
        if self.nodding(name).angles[1] in (ZERO, PI):
            return
        letters = self.held.open_letters(name, axis)
        message = f"`{name}` spins, and is not the same all round its axis through the point that is held: it does not precess steadily"
        help = "leave out `steady: true`, and tell its rates"
        if letters:
            message, help = (
                f"whether `{name}` is symmetric, so that it may precess steadily, hangs on {letters}",
                "give them numbers",
            )
        raise Unsolvable(message, span=told.span, help=help)

    @remembered
    def nodding(self, name: str) -> Nodding:
        """The Euler angles of a body and their rates: what the state tells, see `angle_of`; where φ = 0, e₁ lies along x."""
        angles = triple([self.angle_of(name, number) for number in range(len(ANGLES))])
        rests, steady = self.rests(name), self.state.steady or self.extreme_tilt(name)
        still = {
            "precession": rests,
            "nutation": rests or steady,
            "spin": rests,
        }  # what is nothing unless the state tells it
        rates = triple(
            [ZERO if still[word] and self.told(name, word) is None else self.ask(word, name) for word in RATES]
        )
        return Nodding(angles, rates, triple([self.rate_of(word, name) for word in RATES]))

    def angle_of(self, name: str, number: int) -> Formula:
        """An Euler angle: as told, through an event as before; φ = ψ = 0 where nothing tells them at first or in a steady state."""
        told = self.told(name, ANGLES[number])
        if told is not None:
            self.refuse_timeless(name, ANGLES[number])
            return told.transform(self.by_sides, "atan")
        if self.before is not None:
            return self.before.nodding(name).angles[number]
        moved_on = self.later and not self.state.steady
        if ANGLES[number] == "precession_angle" and not moved_on:
            self.refuse_unplaced(name)
        return self.ask(ANGLES[number], name) if moved_on or ANGLES[number] == "tilt" else ZERO

    def refuse_timeless(self, name: str, word: str) -> None:
        """Refuse a state that tells of what precesses steadily how far that has gone round, and no time: its time is what is sought."""
        line = self.line(name, word)
        alone = self.steadily and not self.state.steady and self.state.time_told is None
        if not alone or line is None or word == "tilt" or self.line(name, "tilt") is not None:
            return
        message = f"`{name}` precesses steadily, and {self.spoken_of()} tells its `{word}` without a time"
        help = "write `time: T` there too, with `T: unknown` under `given`, and ask for `T`"
        raise Unsolvable(message, span=line.span, help=help)

    def refuse_unplaced(self, name: str) -> None:
        """Refuse a body that leans, and holds another one that leans or is held by one, where nothing tells to which side: how both move
        hangs on that."""
        linked = (
            one for one in self.held.order if name in (one, self.held.carrier(one)) or one == self.held.carrier(name)
        )
        leaning = [one for one in linked if self.nods(one) and self.told(one, "tilt") not in (ZERO, PI)]
        joint = self.held.main(name)
        if name not in leaning or len(leaning) < 2 or joint is None:
            return
        lower, upper = leaning[:2]
        message = f"to which side `{name}` leans at {self.spoken_of()} nothing tells"
        help = f"tell the `precession_angle` of both, as `{lower}.precession_angle: 180 deg` and `{upper}.precession_angle: 0 deg`"
        raise Unsolvable(message, span=joint.body.span, help=help)

    def by_sides(self, angle: Formula) -> Formula:
        """arctan(y/x) as the heading of (x, y), of which cos = x/√(x² + y²), where x > 0."""
        slope = angle.arguments[0] if isinstance(angle, Call) and angle.function == "atan" else None
        if not isinstance(slope, Quotient) or self.held.signs.decide(slope.denominator) != 1:
            return angle
        return Call("atan2", (slope.numerator, slope.denominator))

    def extreme_tilt(self, name: str) -> bool:
        """Whether the state says that the tilt of a body is largest or smallest there, so that it nods no more."""
        line = self.line(name, "tilt")
        return line is not None and line.word in EXTREMES

    def spoken_of(self) -> str:
        """When this moment is, in words."""
        return f"`{self.when}`" if self.at == self.when else "any time"
