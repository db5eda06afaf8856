"""Energy: from place to place where bodies have one way to go and only weights, springs and wires work: ½ m q̇² = E − U, without steps.

That is cheap, and it is the only way away from a place where nothing pushes: a rod that falls from upright.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from functools import partial

from msgspec.structs import replace

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.constraints import held_by
from rotsolve.confirm.course.astray import GivesWay, LetsGo, MeetAgain, check_apart, spaces
from rotsolve.confirm.course.node import Astray, Node, unpushed
from rotsolve.confirm.instant import BACK, FORWARD, STICKS, split
from rotsolve.confirm.jet import Jet, Slope
from rotsolve.confirm.linear import solved
from rotsolve.confirm.lines import placed_value
from rotsolve.confirm.pose import Pose
from rotsolve.elements.asked import is_spring, is_torsion
from rotsolve.language.problem import Condition, State

NEWTON, EXACT, SAMPLES = 30, 1e-13, (0.35, 0.7, 1.0)
HALVINGS = 24  # of the way between two places on either side of the one at which it is slowest
MOST_LOOKS = 1000  # on one way between states: an angle told by mistake may be 10³⁰ degrees
LOOKS = 8  # places at which it is seen whether what only pushes would have to pull
MISSING = 1e-6  # share of the energy that is missing where a place is not reached


def by_energy(first: Node, state: State) -> Node | None:
    """The node at which a place is reached that a state tells; None where it takes steps in time to know."""
    line = only_place(state)
    if line is None or line.path is None or line.value is None or not conserves(first):
        return None
    target = placed_value(line.path, told_from(first), first.model)
    if target is None:
        return None
    start, goal = target.value, first.model.value(line.value)
    way = rates_along(first, first.placed.q, line)
    if way is None or goal == start or not heads_for(first, way, goal - start, target):
        return None
    whole = rate_energy(first, first.placed.speed) + stored(first)
    q, before, done, looks = list(first.placed.q), first, 0.0, list[tuple[float, Node]]()
    for part in parts_of_way(first, line, goal - start):
        found = placed_at(first, q, line, start + part * (goal - start))
        if found is None:
            return None
        q, earlier = found, q
        at = with_its_speed(first, q, line, whole, goal - start)
        if at is not None and gains(before) < 0.0 < gains(at):
            low = slowest(first, earlier, line, (start + done * (goal - start), start + part * (goal - start)), whole)
            check_reached(first, low, whole, state)
        if at is None and part < 1.0:
            check_reached(first, q, whole, state)
        if at is not None and part < 1.0:
            check_way(at, state)
        if at is not None:
            check_grips(first, at, state)
        if at is None or at.moment.lifted or slips_at(at):
            return None
        before, done = at, part
        looks.append((part, at))

    def at_part(near: Node, part: float) -> Node:
        found = placed_at(first, near.placed.q, line, start + part * (goal - start))
        return (with_its_speed(first, found, line, whole, goal - start) if found is not None else None) or near

    return before if holds_between([(0.0, first), *looks], at_part, state) else None


def holds_between(looks: Sequence[tuple[float, Node]], at_part: Callable[[Node, float], Node], state: State) -> bool:
    """Astray where something gives way between the looks on a way; False where steps in time tell how it then goes on."""
    first = looks[0][1]
    for key, start, end, near in tightest(looks):
        from rotsolve.confirm.course.crossings import touched

        if touched(partial(room_at, key), partial(at_part, near), start, end):
            if key[0] in (FORWARD, BACK) and not unpushed(first):
                return False
            raise given_way(key, first, state)
    return True


def given_way(key: tuple[str, str], first: Node, state: State) -> Astray:
    """What tells against a state where something gives way on the way to it."""
    names = first.model.acting.state.name, state.name
    if key in spaces(first, rods=True):
        return MeetAgain(key, *names)
    return GivesWay(key[1], *names) if key[0] in (FORWARD, BACK) else LetsGo(*key, *names)


def check_grips(first: Node, at: Node, state: State) -> None:
    """Astray where something begins to slip on the way from where no steps in time tell how it goes on."""
    if (slips := slips_at(at)) and unpushed(first):
        raise GivesWay(slips, first.model.acting.state.name, state.name)


def spares(at: Node) -> dict[tuple[str, str], float]:
    """How far all that holds is from giving way, and how far apart those are that have met."""
    open_ = {(f"push {kind}", owner) for owner, kind in at.moment.open_reactions}
    apart = {pair: gap + 1e-6 * size for pair, (gap, size) in spaces(at, rods=True).items()}
    return {key: room for key, room in at.moment.room.items() if key not in open_} | apart


def room_at(key: tuple[str, str], at: Node) -> float:
    """How far one of these is from giving way; what rounding takes off is nothing."""
    return spares(at).get(key, math.inf) + 1e-9 * max(map(abs, at.moment.reactions.values()), default=0.0)


def tightest(looks: Sequence[tuple[float, Node]]) -> Iterator[tuple[tuple[str, str], float, float, Node]]:
    """What may give way between looks and hold at each, from where to where, with a look between."""
    known = [(part, spares(node)) for part, node in looks]
    if any(rooms for _, rooms in known):
        from rotsolve.confirm.course.crossings import dips

        nodes = dict(looks)
        parts = [part for part, _ in looks]
        for key in known[-1][1]:
            told = [(part, rooms[key]) for part, rooms in known if rooms.get(key, math.inf) < math.inf]
            for low, high in dips(told):
                yield key, low, high, nodes[parts[parts.index(low) + 1]]


def parts_of_way(first: Node, line: Condition, gap: float) -> Sequence[float]:
    """Shares of the way at which it is looked how it goes: at eighths where something only pushes, of angles at each radian."""
    pushes = any(row.push for row in first.moment.rows.values())
    looks = max(LOOKS if pushes else 0, math.ceil(abs(gap)) if line.path and line.path.quantity == "angle" else 0)
    if looks > MOST_LOOKS:
        raise NotConfirmed("the way to its state is too long to be looked at")
    return [number / looks for number in range(1, looks + 1)] if looks > len(SAMPLES) else SAMPLES


def gains(at: Node) -> float:
    """The power of all forces: how fast kinetic energy grows."""
    return math.fsum(m * v * a for m, v, a in zip(at.model.masses, at.placed.speed, at.moment.rates, strict=True))


def slowest(first: Node, q: list[float], line: Condition, ends: tuple[float, float], whole: float) -> list[float]:
    """The places between two values of the line's place where the kinetic energy is least."""
    low, high = ends
    for _ in range(HALVINGS):
        found = placed_at(first, q, line, (low + high) / 2)
        if found is None:
            return q
        at = with_its_speed(first, found, line, whole, ends[1] - ends[0])
        q = found
        if at is None:
            return q
        low, high = ((low + high) / 2, high) if gains(at) < 0.0 else (low, (low + high) / 2)
    return q


def check_reached(first: Node, q: list[float], whole: float, state: State) -> None:
    """Astray where the energy does not suffice for a place on the way."""
    there = stored(Node(first.model, replace(first.placed, q=q), first.budget, first.moment.modes))
    if there - whole > MISSING * max(abs(there - stored(first)), rate_energy(first, first.placed.speed)):
        raise Astray(f"`{state.name}` is not reached: what moves turns back before it")


def check_way(at: Node, state: State) -> None:
    """Astray where what only pushes would have to pull on the way, or bodies meet again."""
    for owner, kind in at.moment.lifted:
        raise LetsGo(kind, owner, at.model.acting.state.name, state.name)
    check_apart(at, state.name)


def only_place(state: State) -> Condition | None:
    """The line of a state that tells a place, where it is the only one."""
    if len(state.conditions) != 1 or state.balance or state.steady:
        return None
    line = state.conditions[0]
    places = ("angle", "rotation", "displacement", "height")
    return line if line.path is not None and line.word is None and line.path.quantity in places else None


def conserves(first: Node) -> bool:
    """Whether only weights, springs and wires do work, and nothing is driven or slips."""
    now = first.moment
    stores = {item.name for item in first.model.acting.connections if is_spring(item) or is_torsion(item)}
    if any(not name.startswith("weight of ") and name not in stores for name in now.loads):
        return False
    if any(mode != STICKS for mode in now.modes.values()):
        return False
    return not any(row.speed for row in now.rows.values()) and not now.lifted


def slips_at(at: Node) -> str:
    """What begins to slip there, since friction has nothing to spare; "" where all sticks."""
    now = at.moment
    least = -1e-9 * max(map(abs, now.reactions.values()), default=0.0)
    return next((name for (mode, name), room in now.room.items() if mode in (FORWARD, BACK) and room < least), "")


def told_from(first: Node) -> Pose:
    """The pose at the start of the phase, from which ways count."""
    return replace(first.placed, origin=first.placed.q).pose(first.model)


def slope_of(first: Node, q: Sequence[float], line: Condition) -> Jet:
    pose = Pose(first.model.seats, q, [0.0] * len(q), first.time, first.placed.offsets, first.placed.q)
    assert line.path is not None
    found = placed_value(line.path, pose, first.model)
    if found is None:
        raise NotConfirmed("a place that is not told")
    return found


def kept_rows(first: Node, q: Sequence[float]) -> list[tuple[Slope, float]]:
    """What is held, as functions of the places with their values."""
    pose = Pose(first.model.seats, q, [0.0] * len(q), first.time, first.placed.offsets, first.placed.origin)
    rows, grips = split(held_by(first.model, pose))
    return [(row.slope, row.gap) for row in (*rows, *(grip.row for grip in grips))]


def placed_at(first: Node, q: Sequence[float], line: Condition, value: float) -> list[float] | None:
    """Places near q at which the line's place has a value, and all that is held is as it was."""
    before = [gap for _, gap in kept_rows(first, first.placed.q)]
    q = list(q)
    for _ in range(NEWTON):
        first.budget.spend(first.model)
        rows, place = kept_rows(first, q), slope_of(first, q, line)
        gaps = [old - gap for (_, gap), old in zip(rows, before, strict=True)] + [
            still_to_go(line, value - place.value)
        ]
        if max(map(abs, gaps)) < EXACT * 100:
            return q
        step = solved([*[slope for slope, _ in rows], place.slope], gaps, len(q))
        q = [old + change for old, change in zip(q, step.values, strict=True)]
    return None


def still_to_go(line: Condition, gap: float) -> float:
    """What is left up to a place; of an angle up to the nearest way that is the same, since a place round a circle tells no turns."""
    whole = line.path is not None and line.path.quantity == "angle"
    return math.remainder(gap, 2 * math.pi) if whole else gap


def rates_along(first: Node, q: Sequence[float], line: Condition, still: Sequence[int] = ()) -> list[float] | None:
    """The rates of all coordinates where the line's place grows by one, and some are `still`; None where there is more than one way to
    go."""
    rows = [*[slope for slope, _ in kept_rows(first, q)], *[{index: 1.0} for index in still]]
    slopes = [*rows, slope_of(first, q, line).slope]
    found = solved(slopes, [*[0.0 for _ in rows], 1.0], len(q))
    if found.clash > 1e-9 or any(first.model.masses[index] for index in found.open):
        return None
    return found.values


def heads_for(first: Node, way: Sequence[float], gap: float, target: Jet) -> bool:
    """Whether it moves, or is pushed, towards the place that is told; where nothing pushes, the least push may."""
    rate = sum([part * first.placed.speed[index] for index, part in target.slope.items()])
    if rate:
        return rate * gap > 0
    push = sum([part * first.moment.rates[index] for index, part in target.slope.items()])
    size = max(map(abs, first.moment.rates), default=0.0)
    return push * gap > 0 or abs(push) <= 1e-9 * max(size, first.model.gravity, 1.0)


def rate_energy(first: Node, speed: Sequence[float]) -> float:
    return 0.5 * math.fsum(mass * rate * rate for mass, rate in zip(first.model.masses, speed, strict=True))


def stored(at: Node) -> float:
    """Energy of weights, springs and wires."""
    loads = at.moment.loads
    weights = [
        -part * at.placed.q[index]
        for name, load in loads.items()
        if name.startswith("weight of ")
        for index, part in load.items()
    ]
    return math.fsum(weights) + at.stored()


def with_its_speed(first: Node, q: list[float], line: Condition, whole: float, gap: float) -> Node | None:
    """How fast it moves at some places, towards what is told; None where it does not come so far."""
    way = rates_along(first, q, line)
    if way is None:
        return None
    placed = replace(first.placed, q=q, speed=way)
    probe = Node(first.model, placed, first.budget, first.moment.modes)
    left, share = whole - stored(probe), rate_energy(first, way)
    if left <= 1e-12 * abs(whole) or share <= 0.0:
        return None
    rate = math.copysign(math.sqrt(left / share), gap)
    speed = [rate * part for part in way]
    return Node(first.model, replace(placed, speed=speed), first.budget, first.moment.modes)
