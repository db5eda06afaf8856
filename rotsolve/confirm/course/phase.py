"""Phase: a stretch of motion followed to the first instant at which all lines of a state hold; what changes on the way is found.

What slides may stop, what slips may begin to stick, what sticks may begin to slip: then the motion goes on in another way. What would
have to pull though it only pushes ends it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from itertools import pairwise

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.course.astray import LetsGo, MeetAgain, spaces
from rotsolve.confirm.course.gauges import HOLDS, Gauge, gauges
from rotsolve.confirm.course.node import Astray, Node
from rotsolve.confirm.course.steps import PLACES, TimeStep, adapted, is_constant
from rotsolve.confirm.instant import BACK, FORWARD, STICKS, Dynamics, Placed, gathered, moment, slip_speed
from rotsolve.confirm.rows import Grip
from rotsolve.language.problem import State

SOON = (1e-4, 1e-3, 1e-2, 0.05)  # parts of a step after which bodies that have bounced are seen to part
APART = "apart "  # margins of bodies that have met
MOST = 400  # steps of a phase
VERGE = 1e-9  # part of a step that is no step at all
AGAIN = 1e-6  # share of all rates and accelerations within which they are those of the start
STILL = 1e-8  # share of the rates below which slip is rounding
STOPPED = 1e-6  # the same of what has just been found to stop
NUDGE = 1e-9  # m/s² of what is pushed by rounding alone, beside gravity
LONG, MUCH = 6, 1e3  # laps for which a gap grows, or closes more slowly, and how much longer it would have to go on so
FAR = 1e6  # seconds after which nothing is waited for any more
SAMPLES = (0.03, 0.25, 0.5, 0.75, 0.97, 1.0)  # the outer ones tell that it turns near an end
GOLDEN, SECTIONS = (math.sqrt(5) - 1) / 2, 24
LOBATTO = (
    (0.0, 16 / 45),
    (math.sqrt(3 / 7), 49 / 90),
    (1.0, 1 / 10),
)  # offsets from the middle, with weights on either side


class Lap(Struct, frozen=True):
    """A step with the modes of what may slip."""

    step: TimeStep
    modes: dict[str, str]


class FollowedPhase(Struct, frozen=True):
    """The motion from one state to the next: its steps, and the instant at which it ends."""

    first: Node
    laps: list[Lap]
    end: Node
    modes: dict[str, str]

    def integral(self, rate: Callable[[Node], float]) -> tuple[float, float]:
        """∫ rate dt and ∫ |rate| dt, by Lobatto's rule, whose ends see a corner next to them, on halves where it takes more."""
        whole, size = 0.0, 0.0
        for lap in self.laps:
            value = panel(self.first, lap, rate, 0.0, 1.0)
            part, most = refined(self.first, lap, rate, 0.0, 1.0, value, 0)
            whole, size = whole + part, size + most
        return whole, size


def panel(first: Node, lap: Lap, rate: Callable[[Node], float], low: float, high: float) -> tuple[float, float]:
    total, size, half = 0.0, 0.0, (high - low) / 2.0
    for offset, weight in LOBATTO:
        for sign in (-1.0, 1.0):
            value = rate(instant(first, lap, low + half * (1.0 + sign * offset)))
            total += weight * value
            size += weight * abs(value)
    return total * half * lap.step.width, size * half * lap.step.width


def refined(
    first: Node,
    lap: Lap,
    rate: Callable[[Node], float],
    low: float,
    high: float,
    value: tuple[float, float],
    depth: int,
) -> tuple[float, float]:
    """The integral of a panel, halved until halves add up to the whole; what is small is held no closer than it is compared (`number`)."""
    middle = (low + high) / 2.0
    halves = [panel(first, lap, rate, low, middle), panel(first, lap, rate, middle, high)]
    total, size = (halves[0][k] + halves[1][k] for k in range(2))
    apart = max(abs(total - value[0]), abs(size - value[1]))  # what turns back has a corner in its size alone
    if apart <= 1e-9 * max(size, 1e-4) or depth > 20:
        return total, size
    ends = ((low, middle), (middle, high))
    parts = [refined(first, lap, rate, *end, half, depth + 1) for end, half in zip(ends, halves, strict=True)]
    return parts[0][0] + parts[1][0], parts[0][1] + parts[1][1]


def instant(first: Node, lap: Lap, part: float) -> Node:
    """An instant within a step."""
    q, speed = lap.step.at(part)
    placed = replace(first.placed, q=q, speed=speed, time=lap.step.time + part * lap.step.width)
    return Node(first.model, placed, first.budget, lap.modes)


def followed(first: Node, state: State) -> FollowedPhase:
    """The motion from a node to the next state."""
    return NextState(first, state).phase()


class NextState:
    """The search for the next instant at which all lines of a state hold."""

    def __init__(self, first: Node, state: State) -> None:
        if first.adrift:
            raise NotConfirmed(f"nothing tells how all bodies move at `{first.model.acting.state.name}`")
        self.first, self.state = first, state
        self.model = first.model
        self.gauges = gauges(state, self.model, first)
        self.end_time = self.told_time()
        self.laps: list[Lap] = []
        self.node = first
        push = max(map(abs, first.pushes), default=0.0)
        if not any(first.placed.speed) and 0.0 < push < NUDGE * max(self.model.gravity, 1.0):
            raise NotConfirmed(
                f"nothing moves what is at rest at `{first.model.acting.state.name}`: the least push decides"
            )
        if not self.gauges and self.end_time is None:
            raise NotConfirmed(f"nothing tells when `{state.name}` is")

    def told_time(self) -> float | None:
        for line in self.state.conditions:
            if line.path is not None and line.path.quantity == "time" and line.value is not None:
                return self.first.time + self.model.value(line.value)
        return None

    def phase(self) -> FollowedPhase:
        """TimeStep by step, until the state is reached."""
        before: TimeStep | None = None
        width = 0.0
        for _ in range(MOST):
            modes = self.settled()
            step, width = self.stepped(modes, before, width)
            cut, way = self.changed(Lap(step, modes))
            cut = cut if cut > VERGE else 0.0
            before = step if cut == 1.0 else None
            lifts = way is not None and way[0] not in (FORWARD, BACK)
            if 0.0 < cut < 1.0 and not lifts:  # what lets go may be what the state says: it is looked for beyond it
                whole, step = step, self.shortened(step, cut, modes)
                way = way if step.width >= whole.width * cut * (1.0 - 1e-9) else None  # else it is not there yet
            reached = self.reached(Lap(step, modes)) if cut or lifts else None
            if cut and reached is None and way is not None and not lifts and self.holds_where(way[1], Lap(step, modes)):
                return self.ended(Lap(step, modes), way[1])
            if reached is not None and not (lifts and reached > cut + STILL):
                last = self.shortened(step, reached, modes)
                if last.width >= step.width * reached * (1.0 - 1e-9):
                    return self.ended(Lap(last, modes))
                step, before, way = last, None, None  # a shorter step was as far as one could go at once
            if way is not None and lifts:
                raise self.astray(way)
            if cut:
                self.laps.append(Lap(step, modes))
                self.node = instant(self.first, self.laps[-1], 1.0)
                if self.recurs(self.laps[-1]):
                    raise Astray(f"`{self.state.name}` is not reached: what moves comes back before it as it began")
                self.check_coming()
            if way is not None:
                held = modes.get(way[1]) == STICKS
                self.node = giving_way(stilled(self.node, way[1]), self.let_go(way) if held else {})
        raise NotConfirmed(f"`{self.state.name}` is not reached")

    def let_go(self, way: tuple[str, str]) -> dict[str, str]:
        """What gives way at once, and how: with it all that holds only as long as it does."""
        shared = self.node.moment.shared
        together = shared[way].together if way in shared else {way}
        return {name: mode for mode, name in together if mode in (FORWARD, BACK)}

    def recurs(self, lap: Lap) -> bool:
        """Whether all is as it was after the first lap: the first gauge, all rates and accelerations; then it goes on so for ever."""
        if not self.gauges or self.gauges[0].passing or self.end_time is not None or len(lap.step.pushes) == 1:
            return False
        before = instant(self.first, self.laps[0], 1.0)
        origin = self.gauges[0].value(before)

        def gone(at: Node) -> float:
            return self.gauges[0].value(at) - origin

        values = [gone(instant(self.first, lap, part)) for part in (0.0, 1.0)]
        if values[0] * values[1] >= 0.0 or lap is self.laps[0]:
            return False
        again = instant(self.first, lap, self.zero(gone, lap, 0.0, 1.0))
        begun = [(*at.placed.speed, *at.pushes) for at in (before, again)]
        size = max(map(abs, begun[0]))
        return all(abs(one - two) <= AGAIN * size for one, two in zip(*begun, strict=True))

    def check_coming(self) -> None:
        """Astray where the first line's gap has grown for long, or closes ever more slowly: a block that drag stops short of a place."""
        if not self.gauges or self.gauges[0].passing or self.end_time is not None or len(self.laps) <= LONG:
            return
        last = self.laps[-LONG:]
        gaps = [abs(self.gauges[0].value(instant(self.first, lap, 1.0))) for lap in self.laps[-LONG - 1 :]]
        begun = max(abs(self.gauges[0].value(self.first)), self.gauges[0].size)
        if len(self.laps) > 2 * LONG and max(abs(old - new) for old, new in pairwise(gaps)) <= VERGE * begun:
            raise NotConfirmed(f"nothing tells when `{self.state.name}` is")
        rates = [(old - new) / lap.step.width for old, new, lap in zip(gaps, gaps[1:], last, strict=False)]
        name, elapsed = self.state.name, self.node.time - self.first.time
        if all(rate < 0.0 for rate in rates) and gaps[-1] > MUCH * begun:
            raise Astray(f"`{name}` is not reached: what moves goes away from it")
        slower = all(later < rate for rate, later in pairwise(rates))
        if slower and 0.0 <= rates[-1] * MUCH * elapsed < gaps[-1]:
            raise Astray(f"`{name}` is not reached: what moves comes ever less near to it")

    def astray(self, way: tuple[str, str]) -> NotConfirmed:
        """What tells against a state; not against one of several lines, at rest just at the top, which rounding passes by."""
        names = self.model.acting.state.name, self.state.name
        if len(self.gauges) > 1:
            return NotConfirmed(f"whether it comes to `{self.state.name}` or just passes it by")
        if way[0].startswith(APART):
            return MeetAgain((way[0].removeprefix(APART), way[1]), *names)
        return LetsGo(way[1], *names)

    def settled(self) -> dict[str, str]:
        """How what may slip behaves from here on."""
        found = self.node.moment
        if found.lifted:
            raise self.astray(("push", found.lifted[0][0]))
        return found.modes

    def law(self, modes: dict[str, str]) -> Callable[[float, list[float], list[float]], list[float]]:
        """Accelerations, and how far what holds is from giving way."""
        placed = self.first.placed

        def pushes(time: float, q: list[float], speed: list[float]) -> list[float]:
            self.first.budget.spend(self.model)
            now = moment(self.model, replace(placed, q=q, speed=speed, time=time), modes)
            return [*now.rates, *now.room.values()]

        return pushes

    def stepped(self, modes: dict[str, str], before: TimeStep | None, width: float) -> tuple[TimeStep, float]:
        """The next step: up to where the state would be if the accelerations stayed, where they do; else as long as it may be."""
        at, law = self.node.placed, self.law(modes)
        push = [*self.node.pushes, *self.node.moment.room.values()]
        bare = Lap(TimeStep(at.time, 1.0, at.q, at.speed, [push]), modes)
        if before is None:
            guess = self.foreseen(bare)
            if guess is not None and is_constant(law, at.time, at.q, at.speed, guess, push):
                return TimeStep(at.time, guess, at.q, at.speed, [push]), 0.0
            width = min(0.3 * (guess or pace(at, self.node.pushes)), width or FAR)
        if self.end_time is not None:
            width = min(width, self.end_time - at.time)
        return adapted(law, at.time, at.q, at.speed, width, push, before)

    def foreseen(self, bare: Lap) -> float | None:
        """How long it takes with constant accelerations until a gauge vanishes, or what slips sticks; a little more."""
        if self.end_time is not None:
            return self.end_time - bare.step.time
        times = [time for gauge in self.gauges for time in [first_zero(gauge, self.first, bare)] if time is not None]
        return max(times) * (1.0 + 1e-9) if times else None

    def changed(self, lap: Lap) -> tuple[float, tuple[str, str] | None]:
        """The part of a step at which what slips sticks, what sticks slips, or a push would be a pull, and which; 1.0 where nothing does.

        It is looked for within the step too: what holds may give way in its midst, and hold again at its end.
        """
        start, end = (margins(instant(self.first, lap, part)) for part in (0.0, 1.0))
        least: tuple[float, tuple[str, str] | None] = (1.0, None)
        for key, (value, size) in end.items():
            if key not in start:
                continue
            known = [(0.0, start[key][0]), *self.within(key, lap), (1.0, value)]
            begins = key[0] in (FORWARD, BACK) and abs(start[key][0]) <= STILL * abs(value)
            if begins or key[0].startswith(APART):  # from rest, or from nothing at the blow, it grows first
                known[1:1] = [(part, margin_in_step(key, instant(self.first, lap, part))) for part in SOON]
            for (low, before), (high, after) in pairwise(known):
                if low < least[0] and after < -1e-7 * size:
                    part = self.zero(partial(margin_in_step, key), lap, low, high) if before > 0.0 else low
                    least = min(least, (part, key), key=lambda one: one[0])
                    break
        return least

    def within(self, key: tuple[str, str], lap: Lap) -> list[tuple[float, float]]:
        """How far something is from giving way, or from sticking, at the places of a step: as its law has told, or by how fast it slips."""
        names = list(self.node.moment.room)
        if len(lap.step.pushes) == 1:
            return []
        if key not in names:
            return [(part, margin_in_step(key, instant(self.first, lap, part))) for part in PLACES[1:]]
        number = len(lap.step.place) + names.index(key)
        return [(part, push[number]) for part, push in zip(PLACES[1:], lap.step.pushes[1:], strict=True)]

    def zero(self, function: Callable[[Node], float], lap: Lap, low: float, high: float) -> float:
        """The part of a step at which a function changes its sign, by the rule of Illinois."""
        a, b = function(instant(self.first, lap, low)), function(instant(self.first, lap, high))
        kept = (
            0  # which end has stayed: one that stays twice counts half, else an end with a large value stays for ever
        )
        for _ in range(100):
            part = high - b * (high - low) / (b - a) if b != a else (low + high) / 2
            value = function(instant(self.first, lap, part))
            if abs(value) < 1e-14 * max(abs(a), abs(b), 1e-300) or abs(high - low) < 1e-13:
                break
            if (value > 0) == (b > 0):
                high, b, a = part, value, a / 2 if kept == -1 else a
                kept = -1
            else:
                low, a, b = part, value, b / 2 if kept == 1 else b
                kept = 1
        return part

    def shortened(self, step: TimeStep, part: float, modes: dict[str, str]) -> TimeStep:
        """The step up to a part of it."""
        if part == 1.0:
            return step
        width = step.width * part
        if len(step.pushes) == 1:
            return replace(step, width=width)
        return adapted(self.law(modes), step.time, step.place, step.speed, width, step.pushes[0], step)[0]

    def reached(self, lap: Lap) -> float | None:
        """The first part of a step at which all lines hold; None where they do not."""
        start, width = lap.step.time, lap.step.width
        if self.end_time is not None:
            left = self.end_time - start
            part = left / width if width else 1.0 + left
            if part > 1.0 + 1e-9:
                return None
            self.confirm_lines(instant(self.first, lap, min(part, 1.0)))
            return min(part, 1.0)
        for part in self.crossings(self.gauges[0], lap):
            at = instant(self.first, lap, part)
            if all(abs(gauge.value(at)) <= HOLDS * gauge.size for gauge in self.gauges[1:]):
                return part
        return None

    def crossings(self, gauge: Gauge, lap: Lap) -> list[float]:
        """Where a gauge changes its sign within a step; not where the phase begins."""
        parts = (0.0, *SAMPLES)
        values = [gauge.value(instant(self.first, lap, part)) for part in parts]
        small = 1e-9 * gauge.size
        found: list[float] = []
        for place in range(1, len(values) - 1) if not gauge.passing else ():  # it may come to it and go back between
            a, b, c = values[place - 1 : place + 2]
            if a * b > 0 < b * c and abs(b) < min(abs(a), abs(c)):
                found += self.touched(gauge, lap, parts[place - 1], parts[place + 1])
        for low, high, a, b in zip(parts, parts[1:], values, values[1:], strict=False):
            if abs(a) <= small and low == 0.0:
                continue
            if a * b < 0 and abs(b) > small:
                found.append(self.zero(gauge.value, lap, low, high))
            elif abs(b) <= small < abs(a):
                found.append(high)
        return sorted(found)

    def touched(self, gauge: Gauge, lap: Lap, low: float, high: float) -> list[float]:
        """Where a gauge first changes its sign between places between which it comes nearest to zero, by golden sections; else none."""
        begun = gauge.value(instant(self.first, lap, low))
        way, start = (1.0 if begun > 0 else -1.0), low
        for _ in range(SECTIONS):
            inner, outer = high - GOLDEN * (high - low), low + GOLDEN * (high - low)
            one, two = (way * gauge.value(instant(self.first, lap, part)) for part in (inner, outer))
            if min(one, two) < 0.0:
                return [self.zero(gauge.value, lap, start, inner if one < 0.0 else outer)]
            low, high = (low, outer) if one < two else (inner, high)
        return []

    def confirm_lines(self, at: Node) -> None:
        """All lines hold at the instant that is told by its time."""
        for gauge in self.gauges:
            if abs(gauge.value(at)) > HOLDS * gauge.size:
                raise NotConfirmed(f"`{gauge.words}` does not hold at `{self.state.name}`")

    def holds_where(self, stopped: str, lap: Lap) -> bool:
        """Whether a state is that at which something has just ceased to slip, at the end of a lap: with that all its lines hold."""
        if self.end_time is not None or not self.gauges:
            return False
        at = stilled(instant(self.first, lap, 1.0), stopped)
        first = self.gauges[0]
        held = abs(first.value(at)) <= 1e-9 * first.size < abs(first.value(instant(self.first, lap, 0.5)))
        return held and all(abs(gauge.value(at)) <= HOLDS * gauge.size for gauge in self.gauges[1:])

    def ended(self, lap: Lap, stopped: str = "") -> FollowedPhase:
        """The phase up to where the state is reached."""
        self.laps.append(lap)
        end = at_rest(stilled(instant(self.first, lap, 1.0), stopped), instant(self.first, lap, 0.5))
        return FollowedPhase(self.first, self.laps, end, lap.modes)


def stilled(at: Node, stopped: str = "") -> Node:
    """The same instant where what has all but ceased to slip does not slip, as what has `stopped`: the rest is rounding."""
    speed = list(at.placed.speed)
    size = max(map(abs, speed), default=0.0)
    for grip in gathered(at.model, at.pose)[1]:
        slip, square = slip_speed(grip, speed), sum(part * part for part in grip.row.slope.values())
        small = STILL if grip.name != stopped else STOPPED
        if slip and abs(slip) <= small * max(size, 1.0) * math.sqrt(square):
            for index, part in grip.row.slope.items():
                speed[index] -= slip * part / square
    return Node(at.model, replace(at.placed, speed=speed), at.budget)


def at_rest(at: Node, before: Node) -> Node:
    """The same instant where nothing moves any more, beside how fast it has moved before: the rest is rounding, by which it would come to
    rest once more right after it."""
    fastest, most = (max(map(abs, node.placed.speed), default=0.0) for node in (at, before))
    if not 0.0 < fastest <= STOPPED * most:
        return at
    return Node(at.model, replace(at.placed, speed=[0.0] * len(at.placed.speed)), at.budget)


def giving_way(at: Node, letting: Mapping[str, str]) -> Node:
    """The same instant as it goes on from there, where something gives way that held so far; what the state says is of its start."""
    at.budget.spend(at.model)
    return Node(at.model, at.placed, at.budget, moment(at.model, at.placed, letting=letting).modes)


def pace(at: Placed, push: Sequence[float]) -> float:
    """A time in which something happens: that in which what accelerates goes a unit."""
    most = max(max(map(abs, push), default=0.0), max((abs(v) for v in at.speed), default=0.0) ** 2)
    return min(1.0, 1.0 / math.sqrt(most)) if most else 1.0


def first_zero(gauge: Gauge, first: Node, bare: Lap) -> float | None:
    """When a gauge vanishes with constant accelerations: by the parabola through three instants, and once more near there."""
    scale = 1.0
    zero = None
    for _ in range(3):
        values = [gauge.value(instant(first, bare, part * scale)) for part in (0.0, 0.5, 1.0)]
        if abs(values[0]) <= 1e-12 * gauge.size:
            values[0] = 0.0
        bend = 2.0 * (values[2] - 2.0 * values[1] + values[0])
        slope = values[2] - values[0] - bend
        zero = least_positive(bend, slope, values[0])
        if zero is None:
            return None
        scale *= zero
    return scale if 0.0 < scale < FAR else None


def least_positive(a: float, b: float, c: float) -> float | None:
    """The smallest positive root of a x² + b x + c."""
    size = max(abs(a), abs(b), abs(c))
    if size == 0.0:
        return None
    if abs(a) < 1e-13 * size:
        return -c / b if b and -c / b > 1e-12 else None
    inside = b * b - 4.0 * a * c
    if inside < -1e-12 * size * size:
        return None
    root = math.sqrt(max(inside, 0.0))
    q = -0.5 * (b + math.copysign(root, b))
    roots = [q / a] + ([c / q] if q else [])
    positive = [value for value in roots if value > 1e-9]
    return min(positive, default=None)


def margin_in_step(key: tuple[str, str], at: Node) -> float:
    """One of the margins at an instant; how fast something slips needs no forces."""
    if at.modes is not None and at.modes.get(key[1]) == key[0]:
        grips = gathered(at.model, at.pose)[1]
        return next(slip_by_mode(key[0], grip, at) for grip in grips if grip.name == key[1])
    return margins(at)[key][0]


def slip_by_mode(mode: str, grip: Grip, at: Node) -> float:
    """How fast something slips in the sense of its mode."""
    return slip_speed(grip, at.placed.speed) * (1.0 if mode == FORWARD else -1.0)


def margins(at: Node) -> dict[tuple[str, str], tuple[float, float]]:
    """How far what slips is from sticking, what sticks from slipping, what pushes from pulling; each with what it is small against."""
    now: Dynamics = at.moment
    size = max([abs(value) for value in now.reactions.values()], default=0.0)
    open_ = {(f"push {kind}", owner) for owner, kind in now.open_reactions}
    found = {key: (value, size) for key, value in now.room.items() if key not in open_}
    for grip in now.grips:
        mode = now.modes.get(grip.name, STICKS)
        if mode in (FORWARD, BACK):
            found[mode, grip.name] = (slip_by_mode(mode, grip, at), 1.0)
    for (one, other), space in spaces(at).items():
        found[f"{APART}{one}", other] = space
    return found
