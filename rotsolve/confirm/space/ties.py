"""Ties: what joints, drives and the lines of a state say of velocities and accelerations, as linear equations.

The unknowns are the rates: for each body the velocity of its centre of mass and its angular velocity, for each joint how fast it turns and
slides, for each body that nods φ̇, θ̇ and ψ̇. An equation Σ c x = s on them holds for their own rates too: Σ c ẋ = g, with what changes c.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from msgspec import Struct

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.space.arrows import (
    ALONG,
    STILL,
    Arrow,
    Turned,
    crossed,
    inner_product,
    less,
    normed,
    scaled,
    sum_of,
    times_arrow,
)
from rotsolve.confirm.space.rig import AXES, RATES, Lines, Rig
from rotsolve.confirm.space.stance import Stance
from rotsolve.language.bodies import Coupling, Joint, PointRef

Key = tuple[str, str, int]  # what it is, of what, and its number or component
Term = tuple[float, Key]
SPEED, TURNING, SPINS, SLIDES, EULER = "speed", "turning", "spins", "slides", "euler"
ROUND = 6.283185307179586


class Tie(Struct, frozen=True):
    """Σ c x = speed, Σ c ẋ = gain; None where it says nothing of the one."""

    terms: tuple[Term, ...]
    speed: float | None = 0.0
    gain: float | None = 0.0


class Rates:
    """Numbers of all rates (or of their rates) by their keys; those of which nothing is known are 0."""

    def __init__(self, values: Mapping[Key, float]) -> None:
        self.values = values

    def arrow(self, kind: str, name: str) -> Arrow:
        x, y, z = (self.values.get((kind, name, k), 0.0) for k in range(3))
        return (x, y, z)

    def one(self, kind: str, name: str, number: int = 0) -> float:
        return self.values.get((kind, name, number), 0.0)


NONE = Rates({})


class Ties:
    """All ties of a stance; their gains are those that belong to rates `now`."""

    def __init__(self, stance: Stance, now: Rates = NONE) -> None:
        self.stance, self.now = stance, now
        self.rig: Rig = stance.rig
        self.lines: Lines = stance.lines

    def all(self) -> Iterator[Tie]:
        for joint in self.rig.joints.values():
            if joint.rolls:
                yield from self.rolling(joint)
            elif joint.flat:
                raise NotConfirmed(f"what lies flat, as by `{joint.owner}`")
            else:
                yield from self.held(joint)
                yield from self.aligned(joint)
                yield from self.driven(joint)
        for item in self.rig.couplings.values():
            yield self.squared(item)
        for name in self.rig.bodies:
            yield from self.of_body(name)

    # joints

    def held(self, joint: Joint) -> Iterator[Tie]:
        """The point held goes with the point of what carries it, but for what slides."""
        name, ref = joint.body.owner, joint.body
        terms = point_terms(name, self.stance.arm(ref))
        bias = self.centripetal(name, self.stance.arm(ref))
        carrier = joint.carrier.owner
        gain = scaled(-1.0, bias)
        if carrier in self.rig.bodies:
            arm = self.stance.carried_at(joint)
            terms = added_terms(terms, point_terms(carrier, arm), -1.0)
            gain = sum_of(gain, self.centripetal(carrier, arm))
        for number, way in enumerate(self.sliding(joint)):
            terms = added_terms(terms, way_terms((SLIDES, joint.owner, number), way), -1.0)
            speed = self.now.one(SLIDES, joint.owner, number)
            gain = sum_of(gain, scaled(2.0 * speed, crossed(self.omega(carrier), way)))
        yield from three_ties(terms, STILL, gain)

    def sliding(self, joint: Joint) -> list[Arrow]:
        """The directions in which a joint slides, in space."""
        base = self.stance.base(joint)
        return [times_arrow(base, normed(self.rig.arrow(way))) for way in joint.sliding]

    def aligned(self, joint: Joint) -> Iterator[Tie]:
        """A body turns against what carries it only about the joint's axis."""
        if joint.free:
            return
        if len(joint.turning) > 1:
            raise NotConfirmed(f"`{joint.owner}` turns about several axes")
        name, carrier = joint.body.owner, joint.carrier.owner
        terms, gain = of_turning(name), STILL
        if carrier in self.rig.bodies:
            terms = added_terms(terms, of_turning(carrier), -1.0)
        for number, _ in enumerate(joint.turning):
            way = self.stance.way(joint)
            terms = added_terms(terms, way_terms((SPINS, joint.owner, number), way), -1.0)
            gain = scaled(self.now.one(SPINS, joint.owner, number), crossed(self.omega(carrier), way))
        yield from three_ties(terms, STILL, gain)

    def driven(self, joint: Joint) -> Iterator[Tie]:
        """How fast a joint turns: as it is driven, as the state tells, as the pitch of a screw asks."""
        lines = self.lines.of(joint.body.owner)
        faster = any(
            line.path is not None and line.path.quantity == "acceleration" for line in lines
        )  # as a lift that starts
        for number, _ in enumerate(joint.sliding if self.lines.steady and not faster else ()):
            yield Tie(((1.0, (SLIDES, joint.owner, number)),), None, 0.0)
        key = (SPINS, joint.owner, 0)
        if joint.pitch is not None:
            lead = self.rig.value(joint.pitch) / ROUND
            yield Tie(((1.0, (SLIDES, joint.owner, 0)), (-lead, key)))
        if not joint.turning:
            return
        drive = {word: self.rig.over_time(part) for word, part in joint.drive}
        for word, back in (("angle", 0), ("angular_velocity", 1), ("angular_acceleration", 2)):
            if word in drive:
                value = drive[word]
                later = back < 2 and "angular_acceleration" in drive  # which is told besides, of a rate at one moment
                yield Tie(((1.0, key),), value[1 - back] if back < 2 else None, None if later else value[2 - back])
        owners = (joint.body.owner, joint.owner)
        words = ("spin", "angular_velocity") if joint.aligned else ("angular_velocity",)
        speeds = [self.lines.told(owner, word) for owner in owners for word in words]
        led = {"angle", "angular_velocity"} & drive.keys() or any(speed is not None for speed in speeds)
        for speed in speeds if led else [self.standing(joint)]:
            if speed is not None:
                yield Tie(((1.0, key),), speed, None)
        for gain in (self.lines.told(owner, "angular_acceleration") for owner in owners):
            if gain is not None:
                yield Tie(((1.0, key),), None, gain)
        if self.lines.steady and not drive:
            yield Tie(((1.0, key),), None, 0.0)

    def standing(self, joint: Joint) -> float | None:
        """0 where a steady state keeps a hinge as it is, on what carries it: its body's mass would lie otherwise once that has turned."""
        hinged = self.lines.steady and not joint.aligned and not joint.sliding
        return 0.0 if hinged and joint.carrier.owner in self.rig.bodies and self.rig.leans_round(joint) else None

    def rolling(self, joint: Joint) -> Iterator[Tie]:
        """The lowest point of a body goes with the surface under it: v + ω × r, and its rate with ṙ."""
        name, carrier = joint.body.owner, joint.carrier.owner
        arm = self.stance.lowest(joint)
        omega = self.omega(name)
        faster = self.stance.lowest_rate(joint, omega, self.omega(carrier))
        terms, gain = point_terms(name, arm), scaled(-1.0, crossed(omega, faster))
        if carrier in self.rig.bodies:
            place = sum_of(self.stance.place(name), arm)
            off = less(place, self.stance.place(carrier))
            terms = added_terms(terms, point_terms(carrier, off), -1.0)
            going = less(sum_of(self.now.arrow(SPEED, name), faster), self.now.arrow(SPEED, carrier))
            gain = sum_of(gain, crossed(self.omega(carrier), going))
        yield from three_ties(terms, STILL, gain)

    def squared(self, item: Coupling) -> Tie:
        """The arms of the cross of a universal joint, each of which goes with its shaft, stay square: (c × d) · (ω₁ − ω₂) = 0."""
        arm, other = self.stance.arms(item)
        one, two = item.first.owner, item.second.owner
        row = dotted(added_terms(of_turning(one), of_turning(two), -1.0), crossed(arm, other))
        faster = sum_of(crossed(crossed(self.omega(one), arm), other), crossed(arm, crossed(self.omega(two), other)))
        return Tie(row, 0.0, -inner_product(faster, less(self.omega(one), self.omega(two))))

    # what is told of bodies

    def of_body(self, name: str) -> Iterator[Tie]:
        if self.lines.rests(name):
            yield from three_ties(of_turning(name), STILL, STILL if self.lines.balance else None)
            yield from three_ties(point_terms(name, STILL), STILL, STILL if self.lines.balance else None)
        yield from self.prescribed(name)
        yield from self.vectors_told(name)
        yield from self.about_line(name)
        if self.rig.main(name) is None or self.rig.main(name).free:  # type: ignore[union-attr]
            nods = self.lines.nods(name)
            yield from self.nodding(name) if nods else ()
            if self.lines.steady and not nods and not self.rig.bodies[name].moved:
                yield from three_ties(of_turning(name), None, STILL)
        if self.lines.steady and not self.held_or_led(name) and not self.falling(name):
            yield from three_ties(point_terms(name, STILL), None, STILL)

    def about_line(self, name: str) -> Iterator[Tie]:
        """How fast a body that two balls hold turns about the line through both, as the state tells."""
        line, joint = self.rig.line(name), self.rig.main(name)
        if line is None or joint is None:
            return
        terms, carrier = of_turning(name), joint.carrier.owner
        if carrier in self.rig.bodies:
            terms = added_terms(terms, of_turning(carrier), -1.0)
        row = dotted(terms, times_arrow(self.stance.turned(name), line))
        for word, rate in (("angular_velocity", True), ("angular_acceleration", False)):
            told = self.lines.told(name, word)
            if told is not None:
                yield Tie(row, *((told, None) if rate else (None, told)))

    def held_or_led(self, name: str) -> bool:
        held = any(joint.body.owner == name for joint in self.rig.joints.values())
        return held or bool(self.rig.bodies[name].moved)

    def falling(self, name: str) -> bool:
        """Whether a body has its weight alone: in a steady state it turns as it did, and falls."""
        touched = [ref.owner for action in self.rig.problem.actions for ref in action.touches()]
        touched += [joint.carrier.owner for joint in self.rig.joints.values()]
        return bool(self.rig.gravity) and self.rig.solid(name).mass > 0.0 and name not in touched

    def prescribed(self, name: str) -> Iterator[Tie]:
        """What is prescribed of a body's motion; one that is led along and not round does not turn, and the other way round."""
        if not self.rig.bodies[name].moved:
            return
        turning = self.rig.led(name, ("angle", "angular_velocity", "angular_acceleration"))
        travel = self.rig.led(name, ("position", "velocity", "acceleration"))
        free = self.rig.main(name) is None
        if turning is not None:
            yield from three_ties(of_turning(name), *turning)
        elif free:
            yield from three_ties(of_turning(name), STILL, STILL)
        if travel is not None:
            yield from three_ties(point_terms(name, STILL), *travel)
        elif free:
            yield from three_ties(point_terms(name, STILL), STILL, STILL)

    def vectors_told(self, name: str) -> Iterator[Tie]:
        """Velocities and accelerations of points, and those of turning, by components."""
        for word, kind in (("angular_velocity", True), ("angular_acceleration", False)):
            for way, size, frame in self.parts_told(name, word):
                if frame:
                    raise NotConfirmed(f"`{word}` that is told relative to `{frame}`")
                yield Tie(dotted(of_turning(name), way), *((size, None) if kind else (None, size)))
        for point in sorted({line.path.point for line in self.lines.of(name) if line.path is not None}, key=str):
            arm = self.stance.arm(PointRef(name, point or "cm"))
            for word in ("velocity", "acceleration"):
                told = self.lines.arrow_told(name, word, point)
                if told is not None and told[2]:
                    yield from self.relative(name, arm, word, told[0], told[2])
                    continue
                for way, size, _ in self.parts_told(name, word, point):
                    gain = size - inner_product(way, self.centripetal(name, arm))
                    yield Tie(
                        dotted(point_terms(name, arm), way), *((size, None) if word == "velocity" else (None, gain))
                    )

    def parts_told(self, name: str, word: str, point: str | None = None) -> Iterator[tuple[Arrow, float, str]]:
        """The components of a vector that a state tells: the direction of each in space, its size, and what it is relative to."""
        for k, axis in enumerate(AXES):
            line = self.lines.line(name, word, axis, point)
            if line is not None and line.value is not None:
                rows = self.axes_named(name, line.axes)
                yield (rows[0][k], rows[1][k], rows[2][k]), self.rig.value(line.value), line.relative

    def axes_named(self, name: str, axes: str) -> Turned:
        """The rows that turn components along named axes into those of space."""
        if axes in ("", "space"):
            return ALONG
        return self.stance.node_axes(name) if axes == "node" else self.stance.turned(name if axes == "body" else axes)

    def relative(self, name: str, arm: Arrow, word: str, told: Arrow, frame: str) -> Iterator[Tie]:
        """A point that moves in a frame, as told along its axes: v = v_there + v_rel, a = a_there + 2 Ω × v_rel + a_rel."""
        off = less(sum_of(self.stance.place(name), arm), self.stance.place(frame))
        terms = added_terms(point_terms(name, arm), point_terms(frame, off), -1.0)
        vector = times_arrow(self.stance.turned(frame), told)
        if word == "velocity":
            yield from three_ties(terms, vector, None)
            return
        own, there = (
            sum_of(self.now.arrow(SPEED, item), crossed(self.omega(item), at))
            for item, at in ((name, arm), (frame, off))
        )
        swept = scaled(2.0, crossed(self.omega(frame), less(own, there)))
        gain = sum_of(vector, swept, self.centripetal(frame, off), scaled(-1.0, self.centripetal(name, arm)))
        yield from three_ties(terms, None, gain)

    def nodding(self, name: str) -> Iterator[Tie]:
        """ω = φ̇ ẑ + θ̇ e₁ + ψ̇ e₃, of which the state tells parts; ω₃ = ψ̇ + φ̇ cos θ."""
        nodes = self.stance.nodes(name)
        phi, theta, psi = (self.now.one(EULER, name, k) for k in range(3))
        terms = of_turning(name)
        for number, way in enumerate((nodes.up, nodes.first, nodes.third)):
            terms = added_terms(terms, way_terms((EULER, name, number), way), -1.0)
        gain = sum_of(
            scaled(phi * theta, crossed(nodes.up, nodes.first)),
            scaled(phi * psi, crossed(nodes.up, nodes.third)),
            scaled(theta * psi, crossed(nodes.first, nodes.third)),
        )
        yield from three_ties(terms, STILL, gain)
        steady = 0.0 if self.lines.steady else None
        for number, word in enumerate(RATES):
            speed = self.lines.told(name, word)
            if speed is None and word == "nutation" and (self.lines.steady or self.lines.rests(name)):
                speed = 0.0
            yield Tie(((1.0, (EULER, name, number)),), speed, steady)
        axial = self.lines.told(name, "axial_rate")
        if axial is not None:
            axis = tuple((part, (TURNING, name, k)) for k, part in enumerate(nodes.third))
            yield Tie(axis, axial, None)

    # parts of rates

    def omega(self, name: str) -> Arrow:
        return self.now.arrow(TURNING, name) if name in self.rig.bodies else STILL

    def centripetal(self, name: str, arm: Arrow) -> Arrow:
        """ω × (ω × r)."""
        omega = self.omega(name)
        return crossed(omega, crossed(omega, arm))


# vectors of terms


Terms = Sequence[tuple[Term, ...]]


def point_terms(name: str, arm: Arrow) -> Terms:
    """v + ω × r of a point at an arm from the centre of mass."""
    columns = [crossed(way, arm) for way in ALONG]
    return [
        ((1.0, (SPEED, name, k)), *((columns[n][k], (TURNING, name, n)) for n in range(3) if columns[n][k]))
        for k in range(3)
    ]


def of_turning(name: str) -> Terms:
    """ω."""
    return [((1.0, (TURNING, name, k)),) for k in range(3)]


def dotted(terms: Terms, way: Arrow) -> tuple[Term, ...]:
    """The component of a vector of terms along a direction."""
    return tuple((part * size, key) for part, row in zip(way, terms, strict=True) for size, key in row)


def way_terms(key: Key, way: Arrow) -> Terms:
    """A number times a direction."""
    return [((part, key),) for part in way]


def added_terms(one: Terms, other: Terms, factor: float = 1.0) -> Terms:
    """The sum of two vectors of terms."""
    return [(*a, *((factor * part, key) for part, key in b)) for a, b in zip(one, other, strict=True)]


def three_ties(terms: Terms, speed: Arrow | None, gain: Arrow | None) -> Iterator[Tie]:
    """A tie for each component."""
    for k, _ in enumerate(AXES):
        yield Tie(terms[k], None if speed is None else speed[k], None if gain is None else gain[k])
