"""Phase: a stretch of motion followed to the first instant at which all lines of a state hold; what changes on the way is found.

What slides may stop, what slips may begin to stick, what sticks may begin to slip: then the motion goes on in another way. What would
have to pull though it only pushes ends it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from itertools import pairwise

from msgspec.structs import replace

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.course.astray import TOUCHING, LetsGo, MeetAgain, spaces
from rotsolve.confirm.course.crossings import FAR, crossings, dips, first_zero, sign_change, touched
from rotsolve.confirm.course.gauges import HOLDS, Gauge, check_on_carriers, gauges
from rotsolve.confirm.course.laps import FollowedPhase, Lap
from rotsolve.confirm.course.node import Astray, Node, unpushed
from rotsolve.confirm.course.steps import PLACES, Law, TimeStep, adapted, is_constant
from rotsolve.confirm.instant import BACK, FORWARD, STICKS, Dynamics, Met, Placed, gathered, moment, slip_speed
from rotsolve.confirm.rows import Grip
from rotsolve.language.problem import COMES_TO, State

SOON = (1e-4, 1e-3, 1e-2, 0.05)  # parts of a step after which bodies that have bounced are seen to part
APART = "apart "  # margins of bodies that have met
MOST = 400  # steps of a phase
VERGE = 1e-9  # part of a step that is no step at all
LOOKS = 24  # parts of a step at which it is looked how what has hit a rod goes on beside it
AGAIN = 1e-6  # share of all rates and accelerations within which they are those of the start
STILL = 1e-8  # share of the rates below which slip is rounding
STOPPED = 1e-6  # the same of what has just been found to stop
STEADY = 1e-12  # share of the forces below which what they add up to is rounding
SLOW = 300.0  # by how much what is to vanish is less than its size at first where it is small
NEARLY, ROUNDS = 0.99, 3  # the place within a step beside its end, from which its end is set right, and how often
LONG, MUCH = 6, 1e3  # laps for which a gap grows, or closes more slowly, and how much longer it would have to go on so


def followed(first: Node, state: State) -> FollowedPhase:
    """The motion from a node to the next state; where it stops it only comes to a place, which rounding may pass by, and its rate passes
    through nothing."""
    try:
        return NextState(first, state).phase()
    except Astray:
        coming = NextState(first, state)
        stopping = [gauge for gauge in coming.gauges if gauge.rests and abs(gauge.value(first)) > HOLDS]
        if not stopping or len(coming.gauges) < 2:
            raise
        coming.gauges.sort(key=lambda gauge: gauge not in stopping)
        return coming.phase()


def stays(first: Node, state: State) -> bool:
    """Whether a state is one at which a quantity is largest or smallest that does not change at all, so that it is so from the first."""
    if len(state.conditions) != 1 or state.conditions[0].word not in COMES_TO:
        return False
    coming = NextState(first, state)
    now = first.moment
    if now.lifted or abs(coming.gauges[0].value(first)) > STEADY * max(map(abs, (*now.reactions.values(), 1.0))):
        return False
    at, push = first.placed, [*now.rates, *now.room.values()]
    return is_constant(coming.law(now.modes), at.time, at.q, at.speed, 1.0, push)


class NextState:
    """The search for the next instant at which all lines of a state hold."""

    def __init__(self, first: Node, state: State) -> None:
        if first.adrift:
            raise NotConfirmed(f"nothing tells how all bodies move at `{first.model.acting.state.name}`")
        self.first, self.state = first, state
        self.model = first.model
        self.gauges = finely(gauges(state, self.model, first), first)
        self.end_time = self.told_time()
        self.laps: list[Lap] = []
        self.node = first
        self.most = max(map(abs, first.placed.speed), default=0.0)  # of all rates so far
        if unpushed(first) and any(first.pushes):
            raise NotConfirmed(
                f"nothing moves what is at rest at `{first.model.acting.state.name}`: the least push decides"
            )
        if not self.gauges and self.end_time is None:
            raise NotConfirmed(f"nothing tells when `{state.name}` is")

    def told_time(self) -> float | None:
        told = self.state.time_told
        return None if told is None else self.first.time + self.model.value(told)

    def phase(self) -> FollowedPhase:
        """TimeStep by step, until the state is reached."""
        before: TimeStep | None = None
        width = 0.0
        for _ in range(MOST):
            modes = self.settled()
            step, width = self.stepped(modes, before, width)
            lap = Lap(self.first, step, modes)
            cut, way = self.changed(lap)
            cut = cut if cut > VERGE else 0.0
            before = step if cut == 1.0 else None
            lifts = way is not None and way[0] not in (FORWARD, BACK)
            if 0.0 < cut < 1.0 and not lifts:  # what lets go may be what the state says: it is looked for beyond it
                lap, cut = self.arrived(lap, cut, None if way is None else partial(margin_in_step, way))
                way = way if lap.step.width >= step.width * cut * (1.0 - 1e-9) else None  # else it is not there yet
            reached = self.reached(lap) if cut or lifts else None
            if cut and reached is None and way is not None and not lifts and self.holds_where(way[1], lap):
                return self.ended(lap, way[1])
            if reached is not None and not (lifts and reached > cut + STILL):
                last, reached = self.arrived(lap, reached, self.gauges[0].value if self.gauges else None)
                if last.step.width >= lap.step.width * reached * (1.0 - 1e-9):
                    return self.ended(last)
                lap, before, way = last, None, None  # a shorter step was as far as one could go at once
            if way is not None and lifts:
                raise self.astray(way)
            if cut:
                self.laps.append(lap)
                self.node = lap.at(1.0)
                self.most = max(self.most, *(abs(rate) for part in (0.5, 1.0) for rate in lap.step.at(part)[1]))
                if self.recurs(lap):
                    raise Astray(f"`{self.state.name}` is not reached: what moves comes back before it as it began")
                check_on_carriers(lap.at(0.5))
                check_on_carriers(self.node)
                self.check_coming()
            if way is not None:
                held = modes.get(way[1]) == STICKS
                self.node = giving_way(stilled(self.node, self.scale, way[1]), self.let_go(way) if held else {})
        raise NotConfirmed(f"`{self.state.name}` is not reached")

    @property
    def scale(self) -> float:
        """What slip is small against: 1, or the largest of all rates where they are smaller."""
        return min(self.most, 1.0) or 1.0

    def let_go(self, way: tuple[str, str]) -> dict[str, str]:
        """What gives way at once, and how: with it all that holds only as long as it does."""
        shared = self.node.moment.shared
        together = shared[way].together if way in shared else {way}
        return {name: mode for mode, name in together if mode in (FORWARD, BACK)}

    def recurs(self, lap: Lap) -> bool:
        """Whether all is as it was after the first lap: the first gauge, all rates and accelerations; then it goes on so for ever."""
        if not self.gauges or self.gauges[0].passing or self.end_time is not None or len(lap.step.pushes) == 1:
            return False
        before = self.laps[0].at(1.0)
        origin = self.gauges[0].value(before)

        def gone(at: Node) -> float:
            return self.gauges[0].value(at) - origin

        values = [gone(lap.at(part)) for part in (0.0, 1.0)]
        if values[0] * values[1] >= 0.0 or lap is self.laps[0]:
            return False
        again = lap.at(sign_change(gone, lap.at, 0.0, 1.0))
        begun = [(*at.placed.speed, *at.pushes) for at in (before, again)]
        size = max(map(abs, begun[0]))
        return all(abs(one - two) <= AGAIN * size for one, two in zip(*begun, strict=True))

    def check_coming(self) -> None:
        """Astray where the first line's gap has grown for long, or closes ever more slowly: a block that drag stops short of a place."""
        if not self.gauges or self.gauges[0].passing or self.end_time is not None or len(self.laps) <= LONG:
            return
        last = self.laps[-LONG:]
        gaps = [abs(self.gauges[0].value(lap.at(1.0))) for lap in self.laps[-LONG - 1 :]]
        begun = max(abs(self.gauges[0].value(self.first)), self.gauges[0].size)
        if len(self.laps) > 2 * LONG and max(abs(old - new) for old, new in pairwise(gaps)) <= VERGE * begun:
            raise NotConfirmed(f"nothing tells when `{self.state.name}` is")
        rates = [(old - new) / lap.step.width for old, new, lap in zip(gaps, gaps[1:], last, strict=False)]
        name, elapsed = self.state.name, self.node.time - self.first.time
        leaves = abs(self.gauges[0].value(self.first)) > VERGE * self.gauges[0].size  # else it is so at the start too
        if leaves and all(rate < 0.0 for rate in rates) and gaps[-1] > MUCH * begun:
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
        return LetsGo(*way, *names)

    def settled(self) -> dict[str, str]:
        """How what may slip behaves from here on."""
        found = self.node.moment
        if found.lifted:
            owner, kind = found.lifted[0]
            raise self.astray((f"push {kind}", owner))
        return found.modes

    def law(self, modes: dict[str, str]) -> Law:
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
        bare = Lap(self.first, TimeStep(at.time, 1.0, at.q, at.speed, [push]), modes)
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
        times = [time for gauge in self.gauges for time in [first_zero(gauge, bare)] if time is not None]
        return max(times) * (1.0 + 1e-9) if times else None

    def changed(self, lap: Lap) -> tuple[float, tuple[str, str] | None]:
        """The part of a step at which what slips sticks, what sticks slips, or a push would be a pull, and which; 1.0 where nothing does.

        It is looked for within the step too: what holds may give way in its midst, and hold again at its end.
        """
        start, end = (margins(lap.at(part), self.scale) for part in (0.0, 1.0))
        least: tuple[float, tuple[str, str] | None] = (1.0, None)
        for key, (value, size) in end.items():
            if key not in start:
                continue
            known = [(0.0, start[key][0]), *self.within(key, lap), (1.0, value)]
            begins = key[0] in (FORWARD, BACK) and abs(start[key][0]) <= STILL * abs(value)
            if begins or key[0].startswith(APART):  # from rest, or from nothing at the blow, it grows first
                known[1:1] = [(part, margin_in_step(key, lap.at(part))) for part in SOON]
            # what is all but zero tells no sign
            known[1:] = [one for one in known[1:] if one[1] > 0.0 or one[1] < -1e-7 * size]
            part = gives(partial(margin_in_step, key), lap, known, 1e-7 * size)
            least = min(least, (part, key), key=lambda one: one[0])
        return min((least, *self.hits(lap)), key=lambda one: one[0])

    def hits(self, lap: Lap) -> Iterator[tuple[float, tuple[str, str]]]:
        """The parts of a step at which what has bounced off a rod comes through it, between its ends."""
        for met in (met for met in self.first.placed.met if met.rod is not None):
            from rotsolve.confirm.course.meeting import beside_rod, gap_of

            def ahead(at: Node, met: Met = met) -> float:
                return gap_of(met, at.pose)[0] - met.apart + TOUCHING

            parts = (0.0, *SOON, *(number / LOOKS for number in range(1, LOOKS + 1)))
            known = [(part, ahead(lap.at(part))) for part in parts]
            found = [sign_change(ahead, lap.at, x, y) for (x, a), (y, b) in pairwise(known) if a * b < 0.0]
            for low, high in dips([(part, abs(gap)) for part, gap in known]):  # from either side
                found += touched(ahead, lap.at, low, high)
            for part in sorted(found):
                if beside_rod(met, lap.at(part).pose)[0] <= 0.0:
                    yield part, (f"{APART}{met.pair[0]}", met.pair[1])
                    break

    def within(self, key: tuple[str, str], lap: Lap) -> list[tuple[float, float]]:
        """How far something is from giving way, or from sticking, at the places of a step: as its law has told, or by how fast it slips."""
        names = list(self.node.moment.room)
        if len(lap.step.pushes) == 1:
            return [(0.5, margin_in_step(key, lap.at(0.5)))] if key[0].startswith(APART) else []
        if key not in names:
            return [(part, margin_in_step(key, lap.at(part))) for part in PLACES[1:]]
        number = len(lap.step.place) + names.index(key)
        return [(part, push[number]) for part, push in zip(PLACES[1:], lap.step.pushes[1:], strict=True)]

    def shortened(self, lap: Lap, part: float) -> Lap:
        """The lap up to a part of it."""
        step, width = lap.step, lap.step.width * part
        if part == 1.0:
            return lap
        if len(step.pushes) == 1:
            return replace(lap, step=replace(step, width=width))
        law = self.law(lap.modes)
        return replace(lap, step=adapted(law, step.time, step.place, step.speed, width, step.pushes[0], step)[0])

    def arrived(self, lap: Lap, part: float, gap: Callable[[Node], float] | None) -> tuple[Lap, float]:
        """The lap up to where a function vanishes, nearly at a part of it, and that part: a shorter step is nearer to the motion."""
        last = self.shortened(lap, part)
        if gap is None or len(last.step.pushes) == 1 or part == 1.0:
            return last, part
        for _ in range(ROUNDS):
            before, rest = gap(last.at(NEARLY)), gap(last.at(1.0))
            further = (1.0 - NEARLY) * rest / (before - rest) if before != rest else 0.0
            if abs(rest) <= 1e-10 * abs(before) or not abs(further) < 1.0 - NEARLY or part * (1.0 + further) > 1.0:
                break
            part *= 1.0 + further
            last = self.shortened(lap, part)
        return last, part

    def reached(self, lap: Lap) -> float | None:
        """The first part of a step at which all lines hold; None where they do not."""
        start, width = lap.step.time, lap.step.width
        if self.end_time is not None:
            left = self.end_time - start
            part = left / width if width else 1.0 + left
            if part > 1.0 + 1e-9:
                return None
            self.confirm_lines(lap.at(min(part, 1.0)))
            return min(part, 1.0)
        for part in crossings(self.gauges[0], lap):
            at = lap.at(part)
            if all(abs(gauge.value(at)) <= HOLDS * gauge.size for gauge in self.gauges[1:]):
                return part
        return None

    def confirm_lines(self, at: Node) -> None:
        """All lines hold at the instant that is told by its time."""
        for gauge in self.gauges:
            if abs(gauge.value(at)) > HOLDS * gauge.size:
                raise NotConfirmed(f"`{gauge.words}` does not hold at `{self.state.name}`")

    def holds_where(self, stopped: str, lap: Lap) -> bool:
        """Whether a state is that at which something has just ceased to slip, at the end of a lap: with that all its lines hold."""
        if self.end_time is not None or not self.gauges:
            return False
        at = stilled(lap.at(1.0), self.scale, stopped)
        first = self.gauges[0]
        before = first.value(lap.at(0.5))
        held = abs(first.value(at)) <= 1e-9 * first.size < abs(before) and before * first.way <= 0.0
        return held and all(abs(gauge.value(at)) <= HOLDS * gauge.size for gauge in self.gauges[1:])

    def ended(self, lap: Lap, stopped: str = "") -> FollowedPhase:
        """The phase up to where the state is reached."""
        self.laps.append(lap)
        end = at_rest(stilled(lap.at(1.0), self.scale, stopped), lap.at(0.5))
        return FollowedPhase(self.laps, end, lap.modes)


def gives(function: Callable[[Node], float], lap: Lap, known: Sequence[tuple[float, float]], small: float) -> float:
    """The first part of a lap at which a margin falls below zero, by what it is at some parts; 1.0 where it does not.

    Also between those: it may come below zero and back.
    """
    first = 1.0
    for (low, before), (high, after) in pairwise(known):
        if after < -small:
            first = sign_change(function, lap.at, low, high) if before > 0.0 else low
            break
    for low, high in dips(known):
        if low < first:
            first = min(first, *touched(lambda at: function(at) + small, lap.at, low, high), 1.0)
    return first


def finely(found: list[Gauge], first: Node) -> list[Gauge]:
    """What a state says alone with a size that is small where little is left of it at first: a slow speed that is to vanish."""
    if len(found) != 1 or found[0].passing:
        return found
    begun = abs(found[0].value(first))
    if begun <= VERGE * found[0].size:  # so at the start itself, but for rounding
        return found
    return [replace(found[0], size=min(found[0].size, SLOW * begun))]


def stilled(at: Node, scale: float, stopped: str = "") -> Node:
    """The same instant where what has all but ceased to slip does not slip, as what has `stopped`: the rest is rounding, beside a scale."""
    speed = list(at.placed.speed)
    size = max(map(abs, speed), default=0.0)
    for grip in gathered(at.model, at.pose)[1]:
        slip, square = slip_speed(grip, speed), sum(part * part for part in grip.row.slope.values())
        small = STILL if grip.name != stopped else STOPPED
        if slip and abs(slip) <= small * max(size, scale) * math.sqrt(square):
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


def margin_in_step(key: tuple[str, str], at: Node) -> float:
    """One of the margins at an instant; how fast something slips needs no forces."""
    if at.modes is not None and at.modes.get(key[1]) == key[0]:
        grips = gathered(at.model, at.pose)[1]
        return next(slip_by_mode(key[0], grip, at) for grip in grips if grip.name == key[1])
    return margins(at)[key][0]


def slip_by_mode(mode: str, grip: Grip, at: Node) -> float:
    """How fast something slips in the sense of its mode."""
    return slip_speed(grip, at.placed.speed) * (1.0 if mode == FORWARD else -1.0)


def margins(at: Node, scale: float = 1.0) -> dict[tuple[str, str], tuple[float, float]]:
    """How far what slips is from sticking, what sticks from slipping, what pushes from pulling; each with what it is small against, slip
    against a scale."""
    now: Dynamics = at.moment
    size = max([abs(value) for value in now.reactions.values()], default=0.0)
    open_ = {(f"push {kind}", owner) for owner, kind in now.open_reactions}
    found = {key: (value, size) for key, value in now.room.items() if key not in open_}
    for grip in now.grips:
        mode = now.modes.get(grip.name, STICKS)
        if mode in (FORWARD, BACK):
            found[mode, grip.name] = (slip_by_mode(mode, grip, at), scale)
    for (one, other), space in spaces(at).items():
        found[f"{APART}{one}", other] = space
    return found
