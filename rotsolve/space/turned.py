"""Turned: how each body of a scene in space stands and turns at one state, by its joints, by what is told of it, or as it is drawn."""

from __future__ import annotations

from collections.abc import Sequence

from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.formula import ONE, ZERO, Formula
from rotsolve.core.drive import TURNING
from rotsolve.core.faults import Unsolvable
from rotsolve.core.remembered import remembered
from rotsolve.core.symbols import TIME, is_key
from rotsolve.core.vectors.triple import (
    AS_DRAWN,
    AXES,
    NOTHING,
    Rows,
    Triple,
    Z,
    after,
    aligning,
    in_turn,
    minus,
    rotated,
    scaled_by,
    square_of,
    transposed,
    triple,
    turn_about,
    unit_along,
    vector_sum,
)
from rotsolve.core.writing import spoken
from rotsolve.language.bodies import Joint
from rotsolve.paths.meaning import NotYet
from rotsolve.space.arrangement import NODAL
from rotsolve.space.attitude import (
    BODY,
    IN_SPACE,
    NODE,
    Attitude,
    Axes,
    HingeTurn,
    as_drawn,
    at_rest_in,
    hinged_on,
    in_own_axes,
    node_axes,
    on_axle,
)
from rotsolve.space.leaning import LeaningMoment
from rotsolve.space.sliding import screwed
from rotsolve.space.untold import UNTOLD


class TurnedMoment(LeaningMoment):
    """One state, with how each body stands and turns."""

    before: TurnedMoment | None
    met: dict[str, TurnedMoment]  # type: ignore[assignment]

    @remembered
    def attitude(self, name: str) -> Attitude:
        """How a body stands and turns at this moment."""
        held, body, joint = self.held, self.held.bodies[name], self.held.main(name)
        led = [(word, axis, value) for word, axis, value in body.moved if word in TURNING]
        if held.link(name):
            return self._between_ends(name)
        if led:
            return self._led(name, led)
        carried = None if self.onward is None else self.onward.attitude(name)
        if carried is not None:
            self.refuse_told_anyhow(name)
            return carried
        if joint is None or joint.free:
            return self.freely(name)
        carrier = held.carrier(name)
        base = self.attitude(carrier) if carrier else at_rest_in(AS_DRAWN)
        if carrier in held.links:
            self.own_axes(carrier)  # which nothing tells
        if carrier:
            spins = base.axes.name == NODE and self.nods(carrier)
            spun = turn_about(Z, self.nodding(carrier).angles[2]) if spins else AS_DRAWN
            if spins or self.held.wheel(carrier) or base.own != AS_DRAWN:
                base = in_own_axes(base, spun)
        if not joint.turning:
            self.refuse_otherwise(name)
            found = hinged_on(base, self.seated(name, joint), Z, HingeTurn())
            if joint.owner not in self.met:
                return found
            return replace(found, axes=replace(found.axes, rows=self.tidied(found.axes.rows)))
        return self._about_axis(name, joint, base, bool(carrier))

    def _between_ends(self, name: str) -> Attitude:
        """A bar that closes a linkage, as its ends are held."""
        raise NotImplementedError

    def coupled_angle(self, name: str) -> Formula | None:
        """How far a shaft is turned that a universal joint ties to another one; None of others."""
        return None

    def freely(self, name: str) -> Attitude:
        """A body that no axis holds and nothing turns as it is told."""
        line = self.line(name, "angle")
        if line is not None:
            message = f"`{name}` is on no `hinge` and no `axle`: it has no `angle`"
            raise Unsolvable(message, span=line.span, help="tell how it stands by `turned`, or by its Euler angles")
        if self.nods(name):
            return self._nods(name)
        if self.later and self.held.pointlike(name) and not self.held.bodies[name].moved:
            return Attitude(IN_SPACE, AS_DRAWN, NOTHING, NOTHING)  # a point has no axes that turn away
        return self._led(name, ()) if self.held.bodies[name].moved else self._anyhow(name)

    def seated(self, name: str, joint: Joint) -> Rows:
        """How a body that is clamped to another one is turned in the axes of that: as it is drawn, or as both stood when they met."""
        met = self.met.get(joint.owner)
        if met is None or self.held.pointlike(name):
            return self.turned(name)
        seen = after(transposed(met.own_axes(joint.carrier.owner).standing), met.own_axes(name).standing)
        return self.tidied(seen)

    def tidied(self, rows: Rows) -> Rows:
        """The rows of a rotation in textbook form."""
        x, y, z = (triple([self.tidy(part) for part in row]) for row in rows)
        return (x, y, z)

    def turned(self, name: str) -> Rows:
        """How a body is turned from how it is drawn, as the scene says; on a hinge that an event has brought, as it stood then."""
        joint = self.held.main(name)
        met = self.met.get(joint.owner) if joint is not None and joint.turning else None
        if met is not None:
            return self.tidied(met.own_axes(name).standing)
        return in_turn(((item.about, item.by) for item in self.held.bodies[name].turned), self.positive)

    def _led(self, name: str, led: Sequence[tuple[str, str, Formula]]) -> Attitude:
        """A body whose angular velocity is prescribed, in space axes, with its rate; what is only led along does not turn."""
        parts = {(word, axis): value for word, axis, value in led}
        omega, alpha = (
            triple([parts.get((word, axis), ZERO) for axis in AXES])
            for word in ("angular_velocity", "angular_acceleration")
        )
        if alpha == NOTHING:
            alpha = triple([differentiate(part, TIME) for part in omega])
        if self.later and omega != NOTHING:
            help = "turn it by a `hinge` with its `angular_velocity`, or ask at the first state"
            message = f"how `{name}`, which is led, stands at {self.spoken_of()} is not solved: time has passed"
            raise NotYet(message, self.held.bodies[name].span, help)
        rows = self.turned(name)
        back = transposed(rows)
        omega, alpha = (triple([self.now(part) for part in vector]) for vector in (omega, alpha))
        return as_drawn(rows, rotated(back, omega), rotated(back, alpha))

    def _anyhow(self, name: str) -> Attitude:
        """A body that may turn about any axis, in its own axes."""
        for word in ("angular_velocity", "angular_acceleration"):
            line = self.line(name, word)
            if line is not None:
                help = f"write `{name}.{word}: [x, y, z]`"
                raise Unsolvable(
                    f"`{name}` may turn about any axis: its {spoken(word)} has three components",
                    span=line.span,
                    help=help,
                )
        stood = self.stood_before(name)
        rows, told = stood or self.turned(name), self.vector_told(name, "angular_velocity")
        if name in self.lines and told is None and not (self.rests(name) or self.state.steady):
            return self._on_line(name, rows, self.lines[name])
        askew = self.askew(name, rows) or ("" if stood or self.seen_from_space(name) else self.lost(name))
        for vector, word in (
            (told, "angular_velocity"),
            (self.vector_told(name, "angular_acceleration"), "angular_acceleration"),
        ):
            if askew and vector is not None and vector[0] != NOTHING and vector[1] not in (BODY, name):
                line = self.line(name, word, "x")
                help = f"tell `{name}.{word} in body axes`"
                raise Unsolvable(askew, span=None if line is None else line.span, help=help)
        if self.rests(name):
            omega = NOTHING
        elif told is None:
            omega = triple([self.ask("angular_velocity", name, axis) for axis in AXES])
        else:
            omega = self.in_own(rows, told, name)
        given = self.vector_told(name, "angular_acceleration")
        if self.state.steady:
            alpha = NOTHING
        elif given is not None:
            alpha = self.in_own(rows, given, name)
        else:
            alpha = triple([self.ask("angular_acceleration", name, axis) for axis in AXES])
        if self.seen_from_space(name):
            return Attitude(IN_SPACE, rows, rotated(rows, omega), rotated(rows, alpha))
        return as_drawn(rows, omega, alpha, lost=askew)

    def stood_before(self, name: str) -> Rows | None:
        """How a body stood before the event that leads to this moment, where time had passed and that is told; None of others."""
        if self.before is None or not self.later or self.vector_kept(name, "vertical") is not None:
            return None
        axes = self.before.own_axes(name)
        return None if axes.lost else axes.rows

    def _on_line(self, name: str, rows: Rows, way: Triple) -> Attitude:
        """A body that has turned about one of its own directions alone, by as much as nothing tells."""
        rate, faster = self.ask("angular_velocity", name), self.rate_of("angular_velocity", name)
        turned = after(rows, turn_about(way, self.untold_angle(name)))
        return as_drawn(turned, scaled_by(rate, way), scaled_by(faster, way))

    def askew(self, name: str, rows: Rows) -> str:
        """Why nothing tells how a body is turned about the vertical: its state tells the `vertical` in its own axes, another one than it is
        drawn with; '' of what stands as it is drawn. Refused where the scene says that it is drawn `turned`."""
        told = self.vector_kept(name, "vertical")
        drawn = rotated(transposed(rows), Z)
        if told is None or all(map(self.held.vanishes, vector_sum(self.up(name), minus(drawn)))):
            return ""
        if self.held.bodies[name].turned:
            line = self.line(name, "vertical", "x")
            message = f"`{name}` is drawn `turned`, and its `vertical` at {self.spoken_of()} is another one"
            raise Unsolvable(message, span=None if line is None else line.span, help="leave one of them out")
        return f"how `{name}` is turned about the vertical at {self.spoken_of()} its `vertical` does not tell"

    def seen_from_space(self, name: str) -> bool:
        """Whether the vectors of a body are written along the axes of space: of a ball that rolls, whose inertia is constant in them."""
        return self.held.rolling(name) is not None and self.held.even_ball(name)

    def left_open(self, name: str) -> tuple[bool, bool]:
        """Whether nothing tells how a body that no axis holds spins, and how fast that changes."""
        if self.nods(name):
            told = any(self.told(name, word) is not None for word in ("spin", "axial_rate"))
            return not (told or self.rests(name)), True
        turning, faster = (self.vector_told(name, word) for word in ("angular_velocity", "angular_acceleration"))
        return turning is None and not self.rests(name), faster is None

    def in_own(self, rows: Rows, told: tuple[Triple, str, str], name: str) -> Triple:
        """A vector that a state tells, in a body's own axes."""
        vector, axes, _ = told
        if axes in (BODY, name):
            return vector
        return rotated(transposed(rows), self.axes_told(name, axes).to(IN_SPACE, vector))

    def axes_told(self, name: str, axes: str) -> Axes:
        """The axes along which a state tells how a body turns; refused are those of what stands as that body does, or comes after it."""
        if axes == NODE:
            return self._node_axes(name)
        later = self.held.order[self.held.order.index(name) :]
        if axes in later:
            message = (
                f"how `{name}` turns is told along the axes of `{axes}`, of which it is not told yet how it stands"
            )
            line = self.line(name, "angular_velocity", "x") or self.line(name, "angular_acceleration", "x")
            help = "tell it along the axes of space, or `in body axes`"
            raise Unsolvable(message, span=None if line is None else line.span, help=help)
        return self.named_axes(axes, name)

    def _about_axis(self, name: str, joint: Joint, base: Attitude, on_body: bool) -> Attitude:
        """A body on a hinge or an axle."""
        self.refuse_otherwise(name, ("spin", "spin_angle") if on_body and joint.aligned else ())
        direction = self.direction(name, joint)
        if self.held.hinge_balls(name):
            from rotsolve.space.two_balls import refuse_other_places

            refuse_other_places(self.held, name, self.turned(name))
        axis = self.held.axis(name) if self.held.wheel(name) else None
        rate, faster = self.driven(name, joint, self.rate_word(name, joint))
        if axis is not None:
            if not self.held.symmetric(name, axis):
                help = "a wheel on an axle is symmetric about it; hold other bodies by a `hinge`"
                raise Unsolvable(f"`{name}` is not symmetric about its axle", span=joint.body.span, help=help)
            turned = self.hinge_angle(name, joint)
            rows = aligning(axis, direction)
            rows = rows if turned is None else after(turn_about(direction, turned), rows)
            return on_axle(base, direction, rate, faster, rows)
        angle = self.hinge_angle(name, joint)
        angle = self.untold_angle(name) if angle is None else angle
        if on_body:
            return hinged_on(base, self.turned(name), direction, HingeTurn(angle, rate, faster))
        rows = after(self.turned(name), turn_about(direction, angle))
        return as_drawn(rows, scaled_by(rate, direction), scaled_by(faster, direction))

    def refuse_otherwise(self, name: str, taken: tuple[str, ...] = ()) -> None:
        """Refuse what a state tells, by Euler angles, the vertical or a vector, of how a body stands or turns that a joint holds about one
        axis or about none."""
        words = [own for own in NODAL if own not in taken]
        found = [line for own in words if (line := self.line(name, own)) is not None]
        upright = self.line(name, "vertical", "x")
        joint, held = self.held.main(name), self.held.held_on(name)
        turns = joint is not None and bool(joint.turning)
        for line in found if upright is None else (*found, upright):
            assert line.path is not None
            told = "that tells how it stands and turns"
            told = "a state tells its `angle` and its `angular_velocity`" if turns else told
            message = f"`{name}` is on {held}: {told}, not its `{line.path.quantity}`"
            raise Unsolvable(message, span=line.span, help="leave it out")
        told_round = self.line(name, "angular_velocity", "x") if turns else None
        if told_round is not None:
            message = f"`{name}` is on {held}: its angular velocity is one number, about the axis"
            raise Unsolvable(message, span=told_round.span, help=f"write `{name}.angular_velocity: 3 rad/s`")

    def hinge_angle(self, name: str, joint: Joint) -> Formula | None:
        """How far a body is turned about its hinge or axle: as it is driven, or told, or by the letter for what the time that has passed
        tells; None where nothing does."""
        driven = dict(joint.drive).get("angle")
        return self.now(driven) if driven is not None else self.turned_on(name)

    def turned_on(self, name: str) -> Formula | None:
        """How far a body that nothing drives is turned, as the state tells, through a blow as before, or the letter for what the time that
        has passed tells."""
        coupled = self.coupled_angle(name)
        if coupled is not None:
            return coupled
        told = self.told(name, "angle")
        if told is None and self.before is not None:
            return self.before.turned_on(name)
        if told is not None or self.onward is None or not self.onward.hinged(name):
            return told
        self.hangs_on_time()
        return self.ask("angle", name)

    def untold_angle(self, name: str) -> Formula:
        """The letter for how far a body on a hinge is turned where nothing tells it, through a blow as before; 0 at first."""
        if self.before is not None:
            return self.before.untold_angle(name)
        return self.ask("angle", name, kind=UNTOLD) if self.later else ZERO

    def hangs_on_hinge(self, name: str) -> bool:
        """Whether a body turns about one axis in what holds it."""
        joint = self.held.main(name)
        return joint is not None and bool(joint.turning)

    def swings_on(self, name: str) -> bool:
        """Whether a body stands on a hinge as what acts on it has it: nothing drives it there, and it is not told to turn."""
        joint = self.held.main(name)
        rates = (self.told(name, word) for word in ("angular_velocity", "spin"))
        stands = all(rate is None or self.held.vanishes(rate) for rate in rates)
        return joint is not None and bool(joint.turning) and not joint.powered and stands

    def found_in_balance(self, pushed: Formula) -> bool:
        """Whether what drives a body holds a letter that the laws tell, since its state is said to stay: it is nothing there."""
        asked = {given.name for given in self.held.problem.givens if given.asked}
        stays = self.state.steady or self.state.balance
        return stays and any(is_key(letter) or letter in asked for letter in pushed.symbols())

    def spun_away(self, name: str) -> str:
        """Why nothing tells where the points of a wheel or ball are that go round in its axes: it has turned since the first state."""
        if self.seen_from_space(name):
            return self.lost(name)
        joint = self.held.main(name)
        spins = joint is not None and self.held.wheel(name)
        return self.lost(name) if spins and joint is not None and self.hinge_angle(name, joint) is None else ""

    def direction(self, name: str, joint: Joint) -> Triple:
        """The axis of a joint in the axes of its body as it is drawn: an axle is told in those of what carries it."""
        way = unit_along(joint.turning[0], self.positive)
        if joint.sliding or (joint.aligned and not self.held.wheel(name)):
            return rotated(transposed(self.turned(name)), way)
        return way

    def stood(self, name: str, word: str) -> Formula | None:
        """The tilt of a body or its angle on a hinge: as told, through a blow as before, an angle 0 at first; None where nothing tells."""
        joint = self.held.main(name) if word == "angle" else None
        told = self.told(name, word) if joint is None else self.hinge_angle(name, joint)
        if told is not None:
            return told
        if self.before is not None:
            return self.before.stood(name, word)
        return ZERO if self.first and word == "angle" else None

    def lost(self, name: str, hanging: str = "") -> str:
        """Why nothing tells how a body stands, or what is `hanging` on that: it has turned since the first state, where it stands as it is
        drawn."""
        if self.onward is not None and self.onward.passed() is not None:
            said = "is not solved: its motion in time has no closed form that is known here"
        elif self.later:
            said = "nothing tells"
        else:
            return ""
        how = f"how `{name}` stands at {self.spoken_of()}"
        return f"{hanging} hangs on {how}, which {said}" if hanging else f"{how} {said}"

    def axle_spin(self, name: str) -> Formula | None:
        """How fast a body spins on the axle on which another one carries it; None of others."""
        joint = self.held.main(name)
        carried = joint is not None and joint.aligned and self.held.carrier(name) != ""
        return self.rate_on(name, joint) if carried and joint is not None else None

    def driven(self, name: str, joint: Joint, word: str) -> tuple[Formula, Formula]:
        """The rate of a body about its hinge or axle and how fast that changes: as it is driven, as the state tells, else letters."""
        drive = dict(joint.drive)
        rate, faster = drive.get("angular_velocity"), drive.get("angular_acceleration")
        if "angle" in drive:
            rate = differentiate(drive["angle"], TIME)
        if rate is None:
            words = (word, "angular_velocity") if joint.aligned else (word,)
            told = (self.told(name, item) for item in words)
            rate = ZERO if self.rests(name) else next((item for item in told if item is not None), None)
            if rate is None:
                rate = ZERO if self.stands_on_carrier(name, joint) else screwed(joint, self, "velocity")
        elif faster is None:
            faster = differentiate(rate, TIME)
        if rate is None:
            rate = self.ask(word, name)
        if faster is None:
            given = self.told(name, "angular_acceleration")
            given = given if given is not None else screwed(joint, self, "acceleration")
            faster = given if given is not None else self.rate_of(word, name)
        if self.state.balance and not self.held.vanishes(self.now(rate)):
            message = f"`{name}` is driven round: nothing is in balance on a turning shaft"
            raise Unsolvable(message, span=joint.body.span, help="write `steady: true` in place of `balance: true`")
        if self.state.steady and not self.held.vanishes(faster):
            message = (
                f"`{name}` turns faster and faster by what is told of it, which is not `steady` at {self.spoken_of()}"
            )
            raise Unsolvable(
                message, span=joint.body.span, help="leave `steady: true` out, or its angular acceleration"
            )
        return self.now(rate), self.now(faster)

    def rate_on(self, name: str, joint: Joint) -> Formula:
        """How fast a body turns about its hinge or axle against what carries it."""
        return self.driven(name, joint, self.rate_word(name, joint))[0]

    def rate_word(self, name: str, joint: Joint) -> str:
        """What that rate is called: the spin of a rotor on the axle of another body."""
        return "spin" if joint.aligned and self.held.carrier(name) else "angular_velocity"

    def stands_on_carrier(self, name: str, joint: Joint) -> bool:
        """Whether a steady state tells that a body on a hinge does not turn against what carries it: its mass would lie otherwise."""
        hinged = bool(joint.turning) and not joint.aligned and not joint.sliding
        carried = self.state.steady and hinged and self.held.carrier(name) != ""
        return carried and self.held.leans_round(joint)

    def axes(self, name: str) -> Axes:
        """The axes in which the vectors of a body are written."""
        return self.attitude(name).axes

    def up(self, name: str) -> Triple:
        """The upward vertical in the axes of a body: as the state tells it in the body's own, else as the body stands."""
        told = self.vector_kept(name, "vertical")
        if told is None:
            return IN_SPACE.to(self.axes(name), Z)
        beyond = square_of(told[0]) - ONE
        if not self.held.vanishes(beyond):
            line = self.line(name, "vertical", "x")
            message, help = (
                f"the vertical of `{name}` is a direction of length 1",
                "the squares of its components add up to 1",
            )
            if self.signs.decide(beyond) is None:
                message = f"that {message} its letters do not tell"
                help = f"{help}: give them numbers, or write one by the others: `sqrt(1 - n1^2 - n2^2)`"
            raise Unsolvable(message, span=None if line is None else line.span, help=help)
        return told[0]

    def named_axes(self, axes: str, name: str) -> Axes:
        """The axes that a question or line names: of space, of a body, or the node axes of one."""
        if axes in ("", "space"):
            return IN_SPACE
        if axes == NODE and self.keeps_momentum(name):
            help = "ask `in space axes` or `in body axes`"
            raise Unsolvable(f"the node axes of `{name}` when time has passed are not solved in space yet", help=help)
        if axes == NODE and self.axes(name).name != NODE:
            return self._node_axes(name)
        if axes in (BODY, NODE):
            return self.own_axes(name) if axes == BODY else self.axes(name)
        return self.own_axes(axes)

    def _node_axes(self, name: str) -> Axes:
        """The node axes of a body whose vectors are written in its own, as it has no symmetry."""
        if not self.nods(name):
            raise Unsolvable(f"`{name}` has no line of nodes", help=f"tell `{name}.tilt` and its rates in that state")
        return node_axes(self.nodding(name))

    def own_axes(self, name: str) -> Axes:
        """The axes that go with a body, named as it is drawn: those of node axes turned on by ψ."""
        own = self.attitude(name)
        if name in self.held.links:
            help = f"ask `in space axes`; on `{name}` only balls hold others"
            message = f"how `{name}` is turned about the line through its ends nothing tells"
            raise Unsolvable(message, span=self.held.link(name)[1].body.span, help=help)
        if own.axes.name != NODE:
            rows, base, lost = after(own.axes.rows, own.own), own.axes.base, own.axes.lost or self.spun_away(name)
            turned = after(own.axes.turned, own.own) if base is not None else AS_DRAWN
            return Axes(BODY, rows, own.omega, own.rates, lost, base, turned)
        rows = after(after(own.axes.rows, turn_about(Z, self.nodding(name).angles[2])), own.own)
        return Axes(BODY, rows)
