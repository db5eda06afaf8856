"""Flight: the motion of a rig followed in time, from a world to the moment at which a later state's lines are so for the first time.

Rotations go as quaternions, q̇ = ½ ω q, without the spin about a body's axis, which has an angle of its own; all of them go by Gragg's
midpoint rule, carried to the limit of ever finer steps (Bulirsch and Stoer).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial

from msgspec.structs import replace

from rotsolve.confirm import NotConfirmed, TooFar, Unfit, Unfollowed
from rotsolve.confirm.space.alone import gains_alone
from rotsolve.confirm.space.arrows import (
    ALONG,
    STILL,
    Arrow,
    Turned,
    Z,
    arrow_length,
    crossed,
    inner_product,
    less,
    normed,
    product_of,
    rotation_about,
    rows_back,
    scaled,
    sum_of,
    times_arrow,
)
from rotsolve.confirm.space.masses import about_point, total_rows, turned_together
from rotsolve.confirm.space.principal import moments_and_axes
from rotsolve.confirm.space.readings import Reading
from rotsolve.confirm.space.rig import AXES, NODAL, Lines, Rig, is_told_rate
from rotsolve.confirm.space.stance import Stance
from rotsolve.confirm.space.ties import ROUND, SLIDES, SPEED, TURNING, Tie, of_turning, point_terms, three_ties
from rotsolve.confirm.space.worlds import Moving, World
from rotsolve.core.symbols import TIME
from rotsolve.language.bodies import Joint, PointRef
from rotsolve.language.problem import EXTREMES, Condition, State, Term

STRIDE = 0.9  # radians that the fastest goes in a step
FINER = (2, 4, 6, 8, 10, 12, 14, 16)  # midpoint steps that are carried to the limit
EACH = 14  # numbers of a body
LOOKS = 900  # how often the equations are solved on a way
WRITTEN_OUT = 3  # times as many where they are written out: a look costs a seventh then
ROUGH, FINE, AGREES = 1e-9, 1e-12, 1e-4  # how exactly a way is followed for a time, and how nearly both have to agree
BOTH = 80  # looks that a step takes at least, both ways
TWICE = 6  # times as many looks where it is
EXACT = 1e-8  # up to which a finer step has to agree, before it is taken
SIGNS = 1e-5  # where nothing but signs is looked for
CLOSE = 1e-8  # of a place: how nearly it is what it was at the start
MET = 1e-13  # of a step: how nearly the moment is found
HOLDS = 1e-7
NEVER = "its motion never comes there"
TOO_FAR = "the way to its state is too long to be followed"

Numbers = list[float]
Gap = Callable[[World], float]
Passing = tuple[
    float, Numbers, float, float
]  # a time, the numbers then, and what changes its sign, then and a step later


class Flight:
    """A rig on its way from a world, for bodies that a later state calls by their tilt too."""

    def __init__(
        self, rig: Rig, start: World, state: State, passed: float | None = None, *, finely: bool = False
    ) -> None:
        self.rig, self.start, self.state = rig, start, state
        self.passed = passed  # the time up to the state, where it is told
        if any(TIME in part.symbols() for joint in rig.joints.values() for _, part in joint.drive):
            raise Unfollowed("a drive that changes on the way to its state")
        if any(joint.motor for joint in rig.joints.values()):
            raise NotConfirmed("a motor that gives what it takes on the way to its state")
        if any(body.moved and not rig.led_evenly(name) for name, body in rig.bodies.items()):
            raise NotConfirmed("a prescribed motion on the way to its state")
        lines = [line.path for line in (*state.conditions, *start.stance.lines.lines)]
        spoken = {path.owner for path in lines if path is not None and path.quantity in NODAL}
        self.nodding = spoken - rig.about_momentum
        self.free = [name for name in rig.bodies if all(joint.body.owner != name for joint in rig.joints.values())]
        self.free += [joint.body.owner for joint in rig.joints.values() if joint.flat]  # their places are followed too
        self.rolling = [
            joint.body.owner for joint in rig.joints.values() if joint.rolls and rig.main(joint.body.owner) is None
        ]
        self.guided = {joint.body.owner: joint for joint in rig.joints.values() if joint.sliding and not joint.flat}
        self.drawn = {name: self.drawn_on_slide(joint) for name, joint in self.guided.items()}
        self.axes = {name: self.axis_of(name) for name in rig.bodies}
        self.origins = {name: self.start_angle(name) for name in rig.bodies}
        self.turns = 0  # how often the motion went the other way
        self.alone = gains_alone(rig)
        self.limit = LOOKS if self.alone is None else WRITTEN_OUT * LOOKS
        self.clock = 0.0  # the time up to the arrival
        self.counted = ""  # a body whose axis is counted on its way round the vertical
        self.gone = 0.0  # how far that has gone
        self.missed = ""  # what did not hold where its state was looked for
        self.looks, self.most, self.exact = 0, self.limit, EXACT
        if finely:
            self.most, self.exact = TWICE * self.limit, FINE

    def drawn_on_slide(self, joint: Joint) -> Arrow:
        """Where the point that slides is at the start, from where it is held, in the axes of what carries it: its ways count from there."""
        stance = self.start.stance
        return times_arrow(rows_back(stance.base(joint)), less(stance.point(joint.body), stance.held_at(joint)))

    def on_slide(self, name: str, own: Numbers, stance: Stance) -> Iterator[Tie]:
        """Put a body where it has slid, and tell how fast it slides."""
        joint = self.guided[name]
        ways = [normed(self.rig.arrow(way)) for way in joint.sliding]
        gone = [scaled(part, way) for part, way in zip(own[5:8], ways, strict=False)]
        stance.slid[name] = sum_of(self.drawn[name], *gone)
        for number, rate in zip(range(len(ways)), own[11:14], strict=False):
            yield Tie(((1.0, (SLIDES, joint.owner, number)),), rate, None)

    def axis_of(self, name: str) -> Arrow:
        """The own direction of a body about which its spin is kept as an angle: that of its hinge, else its axis."""
        joint, line = self.rig.main(name), self.rig.line(name)
        if joint is not None and joint.turning and self.swings(name):
            return times_arrow(rows_back(self.start.stance.turned(name)), self.start.stance.way(joint))
        return line or self.rig.axis(name) or Z

    def swings(self, name: str) -> bool:
        """Whether a body turns about one axis alone, in the ground, in what is led along or in another body."""
        joint, unturned = self.rig.main(name), self.rig.on_unturned(name)
        if joint is None or joint.sliding:
            return False
        return bool(joint.turning) or (unturned is not None and self.rig.line(name) is not None)

    def start_angle(self, name: str) -> float:
        """How far a body is turned about its hinge at the start."""
        before, joint = self.start.stance.swung.get(name), self.rig.main(name)
        told = joint is not None and (self.swings(name) or joint == self.rig.on_unturned(name))
        return before if before is not None else self.start.stance.angle(joint) if joint is not None and told else 0.0

    # numbers of a moment

    def first(self) -> Numbers:
        """For each body a quaternion without its spin, the angle of that, a place, an angular velocity and a velocity."""
        found: Numbers = []
        for name in self.rig.bodies:
            found += quaternion_of(self.start.stance.turned(name))
            place, speed = self.start.stance.place(name), self.start.now.arrow(SPEED, name)
            if name in self.guided:
                place, speed = STILL, self.start.now.arrow(SLIDES, self.guided[name].owner)
            found += (0.0, *place, *self.start.now.arrow(TURNING, name), *speed)
        return found

    def look(self) -> None:
        """One more look at the equations; no more than a limit."""
        self.looks += 1
        if self.looks > self.most:
            raise TooFar(self.missed or TOO_FAR)

    def rows(self, number: int, name: str, numbers: Numbers) -> Turned:
        """How a body is turned."""
        own = numbers[EACH * number : EACH * number + 5]
        return product_of(rows_of_quaternion(own[:4]), rotation_about(self.axes[name], own[4]))

    def moving(self, numbers: Numbers) -> Moving:
        """All that can be said at a moment."""
        self.look()
        lines = Lines(self.rig, None, {})
        lines.nodding = self.nodding
        stance = Stance(self.rig, lines)
        ties: list[Tie] = []
        for number, name in enumerate(self.rig.bodies):
            own = numbers[EACH * number : EACH * number + EACH]
            stance.swung[name] = self.origins[name] + own[4]
            if name in self.guided:
                ties += self.on_slide(name, own, stance)
                if not self.guided[name].turning:
                    continue  # it stands as what carries it
            place = as_arrow(own[5:8]) if name in self.free or name in self.rolling else None
            stance.put(name, self.rows(number, name, numbers), place)
            ties += three_ties(of_turning(name), as_arrow(own[8:11]), None)
            if name in self.free:
                ties += three_ties(point_terms(name, STILL), as_arrow(own[11:14]), None)
        return Moving(stance, ties)

    def slope(self, numbers: Numbers) -> Numbers:
        """How fast all of them change."""
        result: Numbers = []
        motions = dict(self.motions(numbers))
        turning = {name: omega for name, (_, omega, *_) in motions.items()}
        for number, (name, (rows, omega, speed, alpha, gain)) in enumerate(motions.items()):
            third = times_arrow(rows, self.axes[name])
            spin = inner_product(less(omega, self.carried_round(name, turning)), third)
            result += turned_on(less(omega, scaled(spin, third)), numbers[EACH * number : EACH * number + 4])
            result += [spin, *speed, *alpha, *gain]
        return result

    def carried_round(self, name: str, turning: Mapping[str, Arrow]) -> Arrow:
        """The angular velocity of what carries a body on its hinge, from which its angle counts."""
        return turning[self.rig.carrier(name)] if self.swings(name) and self.rig.carrier(name) else STILL

    def motions(self, numbers: Numbers) -> Iterator[tuple[str, tuple[Turned, Arrow, Arrow, Arrow, Arrow]]]:
        """Of each body its rotation, ω, the velocity of its centre of mass, α and the acceleration."""
        if self.alone is not None:
            self.look()
            for number, name in enumerate(self.rig.bodies):
                own = numbers[EACH * number : EACH * number + EACH]
                rows, omega = self.rows(number, name, numbers), as_arrow(own[8:11])
                yield name, (rows, omega, as_arrow(own[11:14]), *self.alone(name, rows, omega))
            return
        moving = self.moving(numbers)
        now = moving.rates([0.0] * len(moving.moving.free))
        equations, solved = moving.forced(now, moving.idle)
        found = equations.named(solved.values)
        for name in self.rig.bodies:
            omega, speed = now.arrow(TURNING, name), now.arrow(SPEED, name)
            alpha, gain = found.arrow(TURNING, name), found.arrow(SPEED, name)
            if name in self.guided:
                speed, gain = (rates.arrow(SLIDES, self.guided[name].owner) for rates in (now, found))
            yield name, (moving.stance.turned(name), omega, speed, alpha, gain)

    def world(self, numbers: Numbers) -> World:
        moving = self.moving(numbers)
        return moving.way([[0.0] * len(moving.moving.free)]).worlds[0]

    # steps

    def step(self, numbers: Numbers, size: float) -> Numbers:
        """Some time later: midpoint steps, carried to the limit of ever finer ones by powers of their squares."""
        slope = self.slope(numbers)
        last: list[Numbers] = []
        for level, count in enumerate(FINER):
            row = [midpoint(self.slope, numbers, slope, size, count)]
            for back in range(level):
                ratio = (count / FINER[level - 1 - back]) ** 2 - 1.0
                row.append([a + (a - b) / ratio for a, b in zip(row[back], last[back], strict=True)])
            last = row
            if level and near_enough(row[-1], row[-2], self.exact):
                return row[-1]
        return self.step(self.step(numbers, size / 2), size / 2)

    def stride(self) -> float:
        """A step in which nothing goes far: the axis of no body turns far, nor nods by more than part of |L|/I, nor swings far."""
        slides = [joint.carrier.owner for joint in self.rig.joints.values() if joint.sliding]
        rates = [
            1e-6,
            *(arrow_length(self.start.now.arrow(TURNING, name)) for name in slides if name in self.rig.bodies),
        ]
        for name in self.rig.bodies:
            omega, third = (
                self.start.now.arrow(TURNING, name),
                times_arrow(self.start.stance.turned(name), self.axes[name]),
            )
            joint, own = self.rig.on_unturned(name), self.rig.solid(name)
            arm = STILL if joint is None else self.start.stance.arm(joint.body)
            tensor = total_rows(self.start.efforts.tensor(name), about_point(own.mass, arm))
            middle = moments_and_axes(tensor)[1][0]
            rates.append(arrow_length(crossed(omega, third)))
            rates.append(math.sqrt(arrow_length(self.start.found.arrow(TURNING, name))))
            if middle > 0.0:
                rates.append(arrow_length(times_arrow(tensor, omega)) / middle)
                rates.append(math.sqrt(own.mass * self.rig.gravity * arrow_length(arm) / middle))  # as it swings
        if self.guided:
            from rotsolve.confirm.space.far_out import rates_of_way

            rates += rates_of_way(self)
        return STRIDE / max(rates)

    # arrival

    def arrival(self, only: Condition | None = None, *, signs: bool = False) -> World:
        """The world in which the lines of the later state, or one of them, are so for the first time; the first of them, and of the others
        their `signs`."""
        if self.passed is not None:
            return self.after(self.passed)
        lines = [line for line in self.state.conditions if line.path is not None and only in (None, line)]
        if not lines:
            raise NotConfirmed("when its state is")
        numbers, size, clock = self.first(), self.stride(), 0.0
        lines.sort(key=lambda line: (self.off_already(line, numbers), is_told_rate(line)))
        gap, ways = self.gap_of(lines[0]), ways_through(lines[0])
        start = gap(self.world(numbers))
        before = start if abs(start) > CLOSE else 0.0
        while True:
            later = self.step(numbers, size)
            there = gap(self.world(later))
            self.refuse_elsewhere(lines[0], numbers, later)
            through = self.passage(lines[0], (numbers, later), size, (before, there))
            lasts, there, later = through or (size, there, later)
            if through is not None and (there > before) in ways:
                there_numbers, gone = self.crossing(numbers, lasts, before, there, gap)
                world, self.clock = self.world(there_numbers), clock + gone
                about = self.gone + self.round_vertical(numbers, there_numbers)
                fails = self.has_other_sign if signs else self.does_not_hold
                off = next((line for line in lines[1:] if fails(line, world)), None)
                if off is None:
                    self.gone = about
                    return world
                self.missed = (
                    self.missed or f"{line_in_words(off)} does not hold where {line_in_words(lines[0])} first does"
                )
            self.gone += self.round_vertical(numbers, later)
            numbers, before, clock = later, there, clock + lasts

    def does_not_hold(self, line: Condition, world: World) -> bool:
        return abs(self.gap_of(line)(world)) > HOLDS * self.size_of(line, world)

    def has_other_sign(self, line: Condition, world: World) -> bool:
        """Whether what a line tells is nearer to its opposite than to what is told."""
        gap, told = self.gap_of(line)(world), 0.0 if line.value is None else self.rig.value(line.value)
        return abs(gap) > abs(gap + 2 * told)

    def off_already(self, line: Condition, numbers: Numbers) -> bool:
        """Whether a component of a place is what it was at the start, which does not tell when its state is."""
        place = line.path is not None and line.path.quantity == "position"
        return place and abs(self.gap_of(line)(self.world(numbers))) <= CLOSE

    def round_vertical(self, one: Numbers, other: Numbers) -> float:
        """How far the axis of the body that is counted goes round the vertical in less than half a turn."""
        if not self.counted:
            return 0.0
        place = EACH * list(self.rig.bodies).index(self.counted)
        axis = self.axes[self.counted]
        thirds = [times_arrow(rows_of_quaternion(numbers[place : place + 4]), axis) for numbers in (one, other)]
        before, after = (math.atan2(third[1], third[0]) for third in thirds)
        return math.remainder(after - before, ROUND)

    def passage(
        self, line: Condition, ends: tuple[Numbers, Numbers], size: float, gaps: tuple[float, float]
    ) -> tuple[float, float, Numbers] | None:
        """The time within a step up to which a gap closes, with the gap and the numbers then: all of it, or up to where what is told turns
        back."""
        if gaps[0] * gaps[1] < 0 and not self.wraps(line, gaps):
            return size, gaps[1], ends[1]
        rate = self.rate_of(line)
        if rate is None or not gaps[0]:
            return None
        rates = [rate(self.world(numbers)) for numbers in ends]
        if rates[0] * rates[1] >= 0:
            return None
        turned, time = self.crossing(ends[0], size, rates[0], rates[1], rate)
        middle = self.gap_of(line)(self.world(turned))
        return (time, middle, turned) if gaps[0] * middle < 0 else None

    def wraps(self, line: Condition, gaps: tuple[float, float]) -> bool:
        """Whether an angle has only passed the place from which it counts the other way round."""
        angle = (
            line.path is not None and line.path.quantity == "angle" and self.carried_hinge(line.path.owner) is not None
        )
        return angle and abs(gaps[0] - gaps[1]) > ROUND / 2

    def rate_of(self, line: Condition) -> Gap | None:
        """How fast an angle, a tilt or a place on what turns changes that a line tells; None of all else."""
        path = line.path
        if path is None or line.word in EXTREMES:
            return None
        if path.quantity == "angle" and self.swings(path.owner):
            return partial(self.swung_rate, path.owner)
        if path.quantity == "position" and line.relative in self.rig.bodies:
            speed = Term(replace(path, quantity="velocity"), axes=line.relative, relative=line.relative)
            return lambda world: Reading(world).number(speed)
        return (lambda world: world.now.one("euler", path.owner, 1)) if path.quantity == "tilt" else None

    def swung_rate(self, name: str, world: World) -> float:
        """How fast a body turns about its hinge, in the sense of that."""
        turning = {body: world.now.arrow(TURNING, body) for body in self.rig.bodies}
        third = times_arrow(world.stance.turned(name), self.axes[name])
        return inner_product(less(turning[name], self.carried_round(name, turning)), third)

    def refuse_elsewhere(self, line: Condition, one: Numbers, other: Numbers) -> None:
        """Give up a body alone on a hinge that has been everywhere: between two turning points, or far off in one sense, from where its
        weight alone does not bring it back, as a couple may."""
        if line.path is not None and line.path.owner in self.guided:
            from rotsolve.confirm.space.far_out import gone_for_good

            if gone_for_good(self, line, one, other):
                raise Unfit(NEVER)
        if line.path is None or line.path.quantity != "angle" or len(self.rig.bodies) > 1:
            return
        third = times_arrow(self.moving(other).stance.turned(line.path.owner), self.axes[line.path.owner])
        rates = [inner_product(as_arrow(numbers[8:11]), third) for numbers in (one, other)]
        self.turns += rates[0] * rates[1] < 0
        told = 0.0 if line.value is None else abs(self.rig.value(line.value))
        far = abs(other[4]) > told + 2 * ROUND and not self.rig.problem.actions
        if self.turns > 2 or far:
            raise Unfit(NEVER)

    def after(self, time: float) -> World:
        """The world some time after the start."""
        if time < 0:
            raise Unfit("its time is before that of the state that leads to it")
        count = max(1, math.ceil(time / self.stride()))
        if count * BOTH > TWICE * self.limit:
            from rotsolve.confirm.space.evenly import gained_evenly

            evenly = gained_evenly(self, time)
            if evenly is None:
                raise TooFar(TOO_FAR)
            return self.world(evenly)

        def carried() -> Numbers:
            numbers = self.first()
            for _ in range(count):
                numbers = self.step(numbers, time / count)
            return numbers

        return self.world(self.agreed(carried))

    def agreed(self, followed: Callable[[], Numbers]) -> Numbers:
        """What comes of following the motion finely, where it is much the same roughly: near an unstable motion small errors grow."""
        self.most = TWICE * self.limit
        found: list[Numbers] = []
        for self.exact in (ROUGH, FINE):
            found.append(followed())
        if not near_enough(found[1], found[0], AGREES):
            raise NotConfirmed("small errors grow too much on the way to its state")
        return found[1]

    def comes_round(self, name: str, *, nods: bool = False) -> float:
        """The time in which ω comes round in a body's own axes; of one that is held and `nods` that in which its tilt does."""
        gaps: list[Gap] = [partial(self.own_component, name, axis) for axis in range(3)]
        if nods:
            self.nodding.add(name)
            gaps = [lambda world: world.now.one("euler", name, 1)]
        spins = 0.0 if nods else arrow_length(self.start.now.arrow(TURNING, name))
        size = min(self.stride(), STRIDE / spins) if spins else self.stride()
        return self.agreed(lambda: [self.round_once(gaps, size)])[0]

    def round_once(self, gaps: Sequence[Gap], size: float) -> float:
        """The time between two zeros in one sense of one of some numbers that change their signs, looked at so often."""
        numbers, clock = self.first(), 0.0
        world, passed = self.world(numbers), [list[Passing]() for _ in gaps]
        before = [gap(world) for gap in gaps]
        while True:
            later = self.step(numbers, size)
            world = self.world(later)
            there = [gap(world) for gap in gaps]
            for axis, gap in enumerate(gaps):
                if before[axis] < 0.0 <= there[axis]:
                    passed[axis].append((clock, numbers, before[axis], there[axis]))
                if len(passed[axis]) > 1:
                    ends = [start + self.crossing(at, size, low, high, gap)[1] for start, at, low, high in passed[axis]]
                    return ends[1] - ends[0]
            numbers, before, clock = later, there, clock + size

    def own_omega(self, name: str, world: World) -> Arrow:
        """ω of a body in its own axes."""
        return times_arrow(rows_back(world.stance.turned(name)), world.now.arrow(TURNING, name))

    def own_component(self, name: str, axis: int, world: World) -> float:
        return self.own_omega(name, world)[axis]

    def crossing(self, numbers: Numbers, size: float, low: float, high: float, gap: Gap) -> tuple[Numbers, float]:
        """The numbers at which a gap closes within a step, and the time to there, by the rule of Illinois."""
        start, end, most = 0.0, size, max(abs(low), abs(high))
        best, at, side = numbers, 0.0, 0
        for _ in range(40):
            middle = (start * high - end * low) / (high - low)
            best, at = self.step(best, middle - at), middle
            value = gap(self.world(best))
            if abs(end - start) <= MET * size or abs(value) <= MET * most:
                break
            if value * high > 0:
                end, high = middle, value
                low = low / 2 if side == 1 else low
                side = 1
            else:
                start, low = middle, value
                high = high / 2 if side == -1 else high
                side = -1
        return best, at

    def gap_of(self, line: Condition) -> Gap:
        """By how much a line is not so; of a largest tilt how fast it still changes."""
        path = line.path
        assert path is not None
        if line.word in EXTREMES:
            if path.quantity != "tilt":
                raise NotConfirmed(f"the {line.word} `{path.quantity}` on the way")
            return lambda world: world.now.one("euler", path.owner, 1)
        if line.value is not None and path.quantity == "position" and line.relative in self.rig.bodies:
            return partial(self.off_place, line)
        if line.value is None or (line.relative and path.quantity != "velocity"):
            raise NotConfirmed(f"a line about `{path.quantity}` on the way")
        frame = line.relative or None
        told, term = self.rig.value(line.value), Term(path, axes=line.axes or frame, relative=frame)
        if path.quantity == "angle" and self.swings(path.owner):
            return lambda world: world.stance.swung[path.owner] - told
        if path.quantity == "angle" and (joint := self.carried_hinge(path.owner)) is not None:
            if abs(told - self.start.stance.angle(joint)) > ROUND / 2:
                raise NotConfirmed("an angle of more than half a turn on what turns itself")
            return partial(self.off_angle, joint, told)
        if path.quantity == "angular_velocity" and path.component is None and self.swings(path.owner):
            return lambda world: self.swung_rate(path.owner, world) - told
        return lambda world: Reading(world).number(term) - told

    def carried_hinge(self, name: str) -> Joint | None:
        """The hinge of a body on another one that turns."""
        joint = self.rig.main(name)
        hinged = joint is not None and bool(joint.turning) and not (joint.sliding or joint.aligned or joint.free)
        return joint if hinged and joint is not None and joint.carrier.owner in self.rig.bodies else None

    def off_angle(self, joint: Joint, told: float, world: World) -> float:
        """By how much a body is turned otherwise than told against what carries it: as it is drawn there at 0, by less than half a turn."""
        stance, name = world.stance, joint.body.owner
        drawn = turned_together(self.rig.bodies[name].turned, self.rig.value)
        turned = product_of(rows_back(product_of(stance.base(joint), drawn)), stance.turned(name))
        way = normed(self.rig.arrow(joint.turning[0]))
        across = normed(crossed(way, min(ALONG, key=lambda axis: abs(inner_product(axis, way)))))
        now = times_arrow(turned, across)
        angle = math.atan2(inner_product(now, crossed(way, across)), inner_product(now, across))
        return math.remainder(angle - told, ROUND)

    def off_place(self, line: Condition, world: World) -> float:
        """By how much a component of a place in the axes of another body is not as told."""
        assert line.path is not None and line.value is not None
        stance = world.stance
        point = stance.point(PointRef(line.path.owner, line.path.point or "cm"))
        away = times_arrow(rows_back(stance.turned(line.relative)), less(point, stance.origin(line.relative)))
        return away[AXES.index(line.path.component or "x")] - self.rig.value(line.value)

    def size_of(self, line: Condition, world: World) -> float:
        told = 0.0 if line.value is None else abs(self.rig.value(line.value))
        return max(told, 1.0)


def ways_through(line: Condition) -> tuple[bool, ...]:
    """Whether a gap closes upwards or downwards at a line: at a largest tilt its rate falls to nothing."""
    return {"largest": (False,), "smallest": (True,)}.get(line.word or "", (False, True))


def line_in_words(line: Condition) -> str:
    """What a line of a state is of, in words."""
    return f"`{line.path.owner}.{line.path.quantity}`" if line.path is not None else f"`{line.owner}`"


def near_enough(one: Numbers, other: Numbers, exact: float) -> bool:
    """Whether a finer step tells no more."""
    return all(abs(a - b) <= exact * max(1.0, abs(a)) for a, b in zip(one, other, strict=True))


def midpoint(slope: Callable[[Numbers], Numbers], start: Numbers, first: Numbers, size: float, count: int) -> Numbers:
    """Gragg's rule: midpoint steps, the last smoothed."""
    h = size / count
    before, now = start, [a + h * b for a, b in zip(start, first, strict=True)]
    for _ in range(count - 1):
        before, now = now, [a + 2 * h * b for a, b in zip(before, slope(now), strict=True)]
    return [(a + b + h * c) / 2 for a, b, c in zip(now, before, slope(now), strict=True)]


def as_arrow(parts: Sequence[float]) -> Arrow:
    x, y, z = parts
    return (x, y, z)


def quaternion_of(rows: Turned) -> Iterator[float]:
    """The quaternion of a rotation, its largest part found first."""
    (a, b, c), (d, e, f), (g, h, i) = rows
    squares = (1 + a + e + i, 1 + a - e - i, 1 - a + e - i, 1 - a - e + i)
    most = max(range(4), key=squares.__getitem__)
    columns = (
        (squares[0], h - f, c - g, d - b),
        (h - f, squares[1], b + d, c + g),
        (c - g, b + d, squares[2], f + h),
        (d - b, c + g, f + h, squares[3]),
    )
    size = math.sqrt(sum(part * part for part in columns[most]))
    return (part / size for part in columns[most])


def rows_of_quaternion(q: Sequence[float]) -> Turned:
    """The rows of the rotation of a quaternion, of whatever length."""
    size = math.sqrt(sum(part * part for part in q))
    w, x, y, z = (part / size for part in q)
    return (
        (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    )


def turned_on(omega: Arrow, q: Sequence[float]) -> Iterator[float]:
    """½ ω q."""
    (a, b, c), (w, x, y, z) = omega, q
    return (
        part / 2
        for part in (-a * x - b * y - c * z, a * w + b * z - c * y, b * w + c * x - a * z, c * w + a * y - b * x)
    )
