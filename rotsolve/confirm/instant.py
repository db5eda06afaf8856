"""Instant: places and rates that fulfil what is held and what a state says; the accelerations and reactions that follow there."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Mapping, Sequence
from functools import cached_property
from itertools import product
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.bodies import Spot
from rotsolve.confirm.constraints import held_by, plain_rows
from rotsolve.confirm.jet import Slope
from rotsolve.confirm.linear import Solved, solved
from rotsolve.confirm.lines import Stated, told
from rotsolve.confirm.pose import Pose, Way
from rotsolve.confirm.rows import EDGE, Grip, Row, unknown
from rotsolve.confirm.seating import seated
from rotsolve.elements.asked import is_drapes, is_spring
from rotsolve.elements.shapes import shape_of

if TYPE_CHECKING:
    from rotsolve.confirm.known import Known
    from rotsolve.confirm.sharing import Line, Shared

CLOSE, TRIES, STILL = 1e-12, 50, 1e-9
ROUNDING = 1e-13  # share of the forces on a body below which what is left of them is rounding: what rests stays at rest
STICKS, FORWARD, BACK, OPEN = "sticks", "slips forward", "slips back", "open"
MODES = (STICKS, FORWARD, BACK)
PUSHES = "push "  # before the kind of a reaction that only pushes or pulls: the limit at which it lets go


class NoWay(NotConfirmed):
    """What may slip can do so in none of its ways; where a state says that it sticks, it does not."""


class Met(Struct, frozen=True):
    """Two bodies that have bounced off each other: from then on the second stays ahead of the first along `way`, if it is a `rod` across
    that, between its ends in its own axes, which turn with it."""

    pair: tuple[str, str]
    way: Way
    apart: float  # how far it was ahead as they met, counted from where both are drawn
    rod: tuple[Spot, Spot] | None = None
    shift: Way = (
        0.0,
        0.0,
    )  # from where the first was drawn to where it has hit the rod: what is told of neither may tell of both
    hollow: float | None = (
        None  # of what has left the inside of a bowl or loop: the radius of the circle that its centre left
    )


class Placed(Struct, frozen=True):
    """Coordinates and rates at an instant; `open` are the rates that nothing tells, `clash` how far what is told contradicts."""

    q: list[float]
    speed: list[float]
    time: float
    offsets: Mapping[str, float]
    origin: Sequence[float]
    open: frozenset[int] = frozenset()
    clash: float = 0.0
    met: tuple[Met, ...] = ()

    def pose(self, model: Known) -> Pose:
        return Pose(model.seats, self.q, self.speed, self.time, self.offsets, self.origin)


class Dynamics(Struct, frozen=True, dict=True):
    """Accelerations and reactions at an instant; those that the equations leave open are named."""

    placed: Placed
    rates: list[float]
    reactions: dict[tuple[str, str], float]
    rows: dict[tuple[str, str], Row]
    columns: dict[tuple[str, str], Slope]  # along which each reaction acts, the kinetic friction that goes with it too
    loads: dict[str, Slope]
    modes: dict[str, str]
    open_rates: frozenset[int]
    open_reactions: frozenset[tuple[str, str]]
    clash: float
    grips: Sequence[Grip] = ()
    laws: Sequence[Mapping[int, float]] = ()  # the left sides of the equations in the reactions, and what has no mass

    @cached_property
    def shared(self) -> dict[tuple[str, str], Shared]:
        """Of several that stick where nothing tells how they share what that takes: how far all of them are from giving way."""
        names = list(self.reactions)
        place = {key: number for number, key in enumerate(names)}
        lines: dict[tuple[str, str], Line] = {}
        for grip in self.grips:
            own = {grip.row.key, grip.normal} & self.open_reactions
            if own and grip.static is not None and self.modes.get(grip.name, STICKS) == STICKS:
                push = {place[grip.normal]: grip.static} if grip.normal in place else {}
                limit = 0.0 if grip.normal is not None else grip.static
                for way, sign in ((FORWARD, 1.0), (BACK, -1.0)):
                    lines[way, grip.name] = limit, {**push, place[grip.row.key]: sign}
        if not lines:
            return {}
        pushing = [key for key in self.open_reactions if self.rows[key].push]
        lines |= {(f"{PUSHES}{kind}", owner): (0.0, {place[owner, kind]: 1.0}) for owner, kind in pushing}
        from rotsolve.confirm.sharing import rooms

        return rooms(lines, list(self.reactions.values()), self.laws, {place[key] for key in self.open_reactions})

    @property
    def room(self) -> dict[tuple[str, str], float]:
        """How far what holds is from giving way: μₛ N ± f of what sticks, by how it would slip then; what pushes only by its push, and
        a brake by the most that it can hold: pressed on by less than nothing it would pull."""
        found = {(f"{PUSHES}{kind}", owner): value for (owner, kind), value in self.pressing.items()}
        for grip in self.grips:
            if grip.static is None or self.modes.get(grip.name, STICKS) != STICKS:
                continue
            push = self.reactions.get(grip.normal, 0.0) if grip.normal is not None else 1.0
            limit, friction = grip.static * abs(push), self.reactions[grip.row.key]
            found[FORWARD, grip.name], found[BACK, grip.name] = limit + friction, limit - friction
            for key in ((FORWARD, grip.name), (BACK, grip.name)):
                found[key] = self.shared[key].room if key in self.shared else found[key]
        pushes = [(key, value) for key, value in self.reactions.items() if self.rows[key].push]
        found |= {(f"{PUSHES}slip", owner): room for owner, room in self.clasped.items()}
        return found | {(f"{PUSHES}{kind}", owner): value for (owner, kind), value in pushes}

    @property
    def clasped(self) -> dict[str, float]:
        """How far what lies on a turning body is from slipping on it: μ m g less all that holds it."""
        holding: dict[str, list[float]] = {}
        for key, row in self.rows.items():
            if row.most is not None:
                holding.setdefault(row.owner, [row.most]).append(self.reactions[key])
        return {owner: most - math.hypot(*parts) for owner, (most, *parts) in holding.items()}

    @property
    def lifted(self) -> list[tuple[str, str]]:
        """What pushes or pulls only, and would have to do the opposite."""
        loads = (value for load in self.loads.values() for value in load.values())
        size = max(map(abs, (*self.reactions.values(), *loads)), default=0.0)  # a push just ends where it alone holds
        pushes = {key: value for key, value in self.reactions.items() if self.rows[key].push} | self.pressing
        return [key for key, value in pushes.items() if value < -1e-9 * size]

    @property
    def unheld(self) -> list[str]:
        """By its element what pushes or pulls only, and would have to do the opposite however all that nothing tells is shared out."""
        size = max([abs(value) for value in self.reactions.values()], default=0.0)
        shared = [
            owner for (way, owner), item in self.shared.items() if way.startswith(PUSHES) and item.room < -1e-9 * size
        ]
        return [owner for owner, kind in self.lifted if (owner, kind) not in self.open_reactions] + shared

    @property
    def pressing(self) -> dict[tuple[str, str], float]:
        """The limits of friction that has a size of its own, by brake or axle; how far what rocks is from an end of its round side, times
        the largest reaction."""
        limits = ((grip, grip.kinetic) for grip in self.grips if grip.normal is None)
        found = {(grip.name.split(".")[0], "press"): limit for grip, limit in limits if limit is not None}
        size = max([abs(value) for value in self.reactions.values()], default=0.0)
        return found | {(row.owner, EDGE): row.edge * size for row in self.rows.values() if row.edge is not None}


def gathered(model: Known, pose: Pose, without: Collection[str] = ()) -> tuple[list[Row], list[Grip], dict[str, Slope]]:
    """All rows, all that may slip, and all known forces by their owner."""
    loads: dict[str, Slope] = {}
    rows, grips = split(held_by(model, pose))
    for name, seat in model.seats.items():
        if model.gravity and seat.rigid.mass and name not in model.hung:
            loads[f"weight of {name}"] = {seat.first + 1: -seat.rigid.mass * model.gravity}
    if not model.acting.actions and all(plain_rows(type(item)) for item in model.acting.connections):
        return rows, grips, loads
    from rotsolve.confirm.forces import forces

    for push in forces(model, pose, without):
        if isinstance(push, Grip):
            grips.append(push)
        else:
            loads[push[0]] = push[1]
    return rows, grips, loads


def placed(
    model: Known,
    start: Placed | None = None,
    *,
    time: float = 0.0,
    lines: bool = True,
    stir: float = 0.0,
    kept: Mapping[tuple[str, str], float] = {},
) -> Placed:
    """Places and rates that fulfil all that is held and what the state says; from `start` on as little is changed as need be.

    What nothing tells stays as it is drawn and at rest, or, where `stir` is not 0, does something else; what holds from where it is drawn,
    as a hinge at the ground does, misses that by as much as is `kept`.
    """
    q = list(start.q) if start is not None else stirred(model, stir)
    origin = start.origin if start is not None else q
    offsets = dict(start.offsets) if start is not None else {}
    time = start.time if start is not None else time
    still = list(start.speed) if start is not None else [0.0] * model.size
    for _ in range(TRIES):
        pose = Pose(model.seats, q, still, time, offsets, origin)
        rows, grips = split(held_by(model, pose))
        said = list(told(model, pose, {grip.name: grip for grip in grips})) if lines else []
        places = [(row.slope, row.gap - kept.get(row.key, 0.0)) for row in rows if row.hard or row.key in kept]
        places += [(line.slope, line.gap) for line in said if line.gap is not None]
        worst = max((abs(gap) for _, gap in places), default=0.0)
        if worst < CLOSE:
            break
        step = solved([slope for slope, _ in places], [-gap for _, gap in places], model.size)
        size = max(map(abs, step.values), default=0.0)
        limit = min(1.0, 1.0 / size) if size else 1.0
        q = [old + limit * change for old, change in zip(q, step.values, strict=True)]
        if size < 1e-14:
            break
    if start is None:
        origin = q
    clash = worst if worst > 1e-9 else 0.0
    if any((is_spring(item) or is_drapes(item)) for item in model.acting.connections):
        from rotsolve.confirm.forces import stretched

        offsets |= stretched(model, Pose(model.seats, q, still, time, offsets, origin), offsets)
    found = moving(model, Placed(q, still, time, offsets, origin, clash=clash), rows, grips, said, stir)
    return at_balance(model, found) if model.acting.state.balance else found


def stirred(model: Known, stir: float) -> list[float]:
    """Coordinates to begin with; rods, with what is welded to them, turned by something, since they do not stand as drawn: what tells
    their angles turns them back."""
    q = seated(model)
    if not stir:
        return q
    turned = {name: number for number, name in enumerate(model.seats) if shape_of(model.body(name)).slender}
    for _ in model.unions:
        for first, second in model.unions:
            for one, other in ((first, second), (second, first)):
                if one in turned:
                    turned[other] = min(turned[one], turned.get(other, turned[one]))
    for name, number in turned.items():
        q[model.seats[name].turn] += stir * (1.0 + 0.3 * number)
    return q


def at_balance(model: Known, at: Placed) -> Placed:
    """How far springs are stretched where they hold bodies at rest: by the forces that this takes."""
    pose = at.pose(model)
    springs = [item for item in model.acting.connections if is_spring(item) and item.stiffness is not None]
    springs = [item for item in springs if item.name not in at.offsets]
    if not springs:
        return at
    from rotsolve.confirm.forces import spring_length

    rows, grips, loads = gathered(model, pose, [item.name for item in springs])
    lengths = {item.name: spring_length(item, pose, model) for item in springs}
    rows += [unknown(name, "force", length.slope) for name, length in lengths.items()]
    rows += [Row("rest", str(index), {index: 1.0}, 0.0, 0.0, {}) for index in range(model.size)]
    found = balanced(model, at, [row for row in rows if not row.loose], grips, loads, {})
    offsets = dict(at.offsets)
    for item in springs:
        if (item.name, "force") not in found.open_reactions and item.stiffness is not None:
            pull = -found.reactions[item.name, "force"] / model.value(item.stiffness)
            offsets[item.name] = lengths[item.name].value - pull
    return replace(at, offsets=offsets, clash=max(at.clash, found.clash))


def split(items: Iterator[Row | Grip]) -> tuple[list[Row], list[Grip]]:
    rows: list[Row] = []
    grips: list[Grip] = []
    for item in items:
        (grips if isinstance(item, Grip) else rows).append(item)  # type: ignore[arg-type]
    return rows, grips


def moving(
    model: Known, at: Placed, rows: Sequence[Row], grips: Sequence[Grip], said: Sequence[Stated], stir: float
) -> Placed:
    """The rates: of all that is held, of all that the state says, of what rolls; what grips does not slip where nothing tells more."""
    free = [stir * (1.0 + 0.3 * index) for index in range(model.size)]
    slips = {name for name, word in model.acting.words().items() if word == "slips"}
    firm = [row for row in rows if not row.loose]
    firm += [grip.row for grip in grips if grip.static is None and grip.name not in slips]
    equations = [(row.slope, row.speed) for row in firm if row.slope and row.speed is not None]
    equations += [(line.slope, line.speed) for line in said if line.speed is not None and not line.sized]
    found = nearest(equations, free)
    sized = [(line.slope, line.speed) for line in said if line.speed is not None and line.sized]
    if sized:
        equations += [(slope, in_sense_of(found, slope, speed)) for slope, speed in sized]
        found = nearest(equations, free)
    for grip in grips:
        if grip.static is None or grip.name in slips or not found.open & grip.row.slope.keys():
            continue
        equations.append((grip.row.slope, grip.row.speed or 0.0))
        found = nearest(equations, free)
    return replace(
        at, speed=found.values, open=found.open, clash=max(at.clash, found.clash if found.clash > 1e-9 else 0.0)
    )


def in_sense_of(found: Solved, slope: Slope, speed: float) -> float:
    """A speed, which has no sense, in that of the rates where these are told without it."""
    if found.open & slope.keys():
        return speed
    return math.copysign(speed, sum([part * found.values[index] for index, part in slope.items()]))


def nearest(equations: Sequence[tuple[Slope, float]], free: Sequence[float]) -> Solved:
    """The rates that fulfil slope · q̇ = speed; what they leave open is `free`."""
    rights = [speed - sum([part * free[index] for index, part in slope.items()]) for slope, speed in equations]
    found = solved([slope for slope, _ in equations], rights, len(free))
    return replace(found, values=[own + value for own, value in zip(free, found.values, strict=True)])


def moment(
    model: Known, at: Placed, modes: Mapping[str, str] | None = None, letting: Mapping[str, str] | None = None
) -> Dynamics:
    """Accelerations and reactions, in the given modes of what may slip; the modes that are consistent where none are given.

    On the way `letting` tells how some of it gives way, whose friction has just reached its limit; what the state says is of its start.
    """
    pose = at.pose(model)
    rows, grips, loads = gathered(model, pose)
    rows = [row for row in rows if not row.loose and row.bend is not None]
    if modes is not None:
        return balanced(model, at, rows, grips, loads, dict(modes))
    said = model.acting.words() if letting is None else {}
    letting = letting or {}
    choices = [
        (letting[grip.name],) if grip.name in letting else choice(grip, pose, said.get(grip.name, "")) for grip in grips
    ]
    first = None
    for trial in product(*choices):
        found = balanced(
            model, at, rows, grips, loads, {grip.name: mode for grip, mode in zip(grips, trial, strict=True)}
        )
        first = first or found
        if all(grip.name in letting or fits(grip, found) for grip in grips):
            check_settled(model, found)
            return found
    raise NoWay("no way to stick and slip fits")


def check_settled(model: Known, found: Dynamics) -> None:
    """NotConfirmed where nothing tells with what push something slips that slows all down: another push would leave other accelerations."""
    slipping = [grip for grip in found.grips if found.modes.get(grip.name) in (FORWARD, BACK)]
    for key in {grip.normal for grip in slipping if grip.normal in found.open_reactions}:
        if key is None:
            continue
        size = found.reactions[key] + max(map(abs, found.reactions.values())) + 1.0
        push = {index: size * part for index, part in found.columns[key].items()}
        rows = [row for row in found.rows.values() if row.key != key]
        columns = [found.columns[row.key] for row in rows]
        other = assembled(model, found.placed, rows, columns, {**found.loads, "another push": push}, found.modes)
        scale = max(map(abs, (*found.rates, *other.rates)), default=0.0)
        if any(abs(one - two) > 1e-9 * scale for one, two in zip(found.rates, other.rates, strict=True)):
            raise NotConfirmed(f"the equations of rigid bodies leave open how hard `{key[0]}` pushes what slips")


def slip_speed(grip: Grip, speed: Sequence[float]) -> float:
    return sum([part * speed[index] for index, part in grip.row.slope.items()]) - (grip.row.speed or 0.0)


def choice(grip: Grip, pose: Pose, said: str) -> tuple[str, ...]:
    """What it can do: as the state says; slip as it does, or, where it does not slip just now, stick, or begin to slip either way."""
    if grip.static is None and said != "slips":
        return (STICKS,)
    slip = slip_speed(grip, pose.speed)
    size = max([abs(part * pose.speed[index]) for index, part in grip.row.slope.items()], default=0.0)
    if abs(slip) > STILL * max(size, 1e-6):
        return (FORWARD if slip > 0 else BACK,)
    return {"slips": (FORWARD, BACK), "sticks": (STICKS,), "rolls": (STICKS,)}.get(said, MODES)


def fits(grip: Grip, found: Dynamics) -> bool:
    """Whether friction that sticks is not too large, and what begins to slip does so against it."""
    mode, slack = found.modes[grip.name], 1e-9
    if mode == OPEN or grip.static is None:
        return True
    if mode == STICKS and (FORWARD, grip.name) in found.shared:
        rooms = [found.shared[way, grip.name].room for way in (FORWARD, BACK)]
        rounding = 1e-13 * max(map(abs, found.reactions.values()), default=0.0)
        return min(rooms) >= -slack * sum(map(abs, rooms)) - rounding
    if mode == STICKS:
        push = found.reactions.get(grip.normal, 0.0) if grip.normal is not None else 1.0
        limit = grip.static * abs(push)
        return abs(found.reactions[grip.row.key]) <= limit * (1 + slack) + 1e-12
    if abs(slip_speed(grip, found.placed.speed)) > STILL:
        return True
    rate = sum([part * found.rates[index] for index, part in grip.row.slope.items()]) - (grip.row.bend or 0.0)
    scale = max([abs(part * found.rates[index]) for index, part in grip.row.slope.items()], default=0.0)
    return rate >= -slack * scale if mode == FORWARD else rate <= slack * scale


def balanced(
    model: Known,
    at: Placed,
    rows: Sequence[Row],
    grips: Sequence[Grip],
    loads: Mapping[str, Slope],
    modes: dict[str, str],
) -> Dynamics:
    """M q̈ = Q + Σ λ column, slope · q̈ = bend of all rows: solved for q̈ of what has no mass and for λ, q̈ of the rest put in."""
    active = [row for row in rows if modes.get(row.owner) != OPEN]
    rubbing: dict[tuple[str, str], Slope] = {}
    applied = dict(loads)
    for grip in grips:
        mode = modes.get(grip.name, STICKS)
        if mode == STICKS:
            active.append(grip.row)
        elif mode != OPEN:
            size = -(grip.kinetic or 0.0) if mode == FORWARD else grip.kinetic or 0.0
            drag = {index: size * part for index, part in grip.row.column.items()}
            if grip.normal is None:
                applied[grip.name] = drag
            else:
                rubbing[grip.normal] = drag
    columns = [plus(row.column, rubbing.get(row.key)) for row in active]
    return replace(assembled(model, at, active, columns, applied, modes), grips=grips)


def plus(one: Slope, other: Slope | None) -> Slope:
    if other is None:
        return one
    return {index: one.get(index, 0.0) + other.get(index, 0.0) for index in {**one, **other}}


def assembled(
    model: Known,
    at: Placed,
    rows: Sequence[Row],
    columns: Sequence[Slope],
    loads: Mapping[str, Slope],
    modes: dict[str, str],
) -> Dynamics:
    """The linear system in the reactions and the accelerations of what has no mass, solved."""
    masses = model.masses
    light = {
        index: len(rows) + number for number, index in enumerate(i for i, mass in enumerate(masses) if mass == 0.0)
    }
    by_index: dict[int, list[tuple[int, float]]] = {}
    for number, column in enumerate(columns):
        for index, part in column.items():
            by_index.setdefault(index, []).append((number, part))
    pushes: list[list[float]] = [[] for _ in masses]
    for load in loads.values():
        for index, part in load.items():
            pushes[index].append(part)
    force = list(map(sum, pushes))
    equations = [equation_of(row, masses, light, by_index, force) for row in rows]
    equations += [(dict(by_index.get(index, ())), -force[index]) for index in light]
    answer = solved([left for left, _ in equations], [right for _, right in equations], len(equations))
    rates = []
    for index, mass in enumerate(masses):
        held = [part * answer.values[number] for number, part in by_index.get(index, ())]
        rates.append(answer.values[light[index]] if index in light else rate_by([*pushes[index], *held], mass))
    keys = [row.key for row in rows]
    return Dynamics(
        placed=at,
        rates=rates,
        reactions=dict(zip(keys, answer.values, strict=False)),
        rows=dict(zip(keys, rows, strict=True)),
        columns=dict(zip(keys, columns, strict=True)),
        loads=dict(loads),
        modes=modes,
        open_rates=frozenset(index for index, place in light.items() if place in answer.open),
        open_reactions=frozenset(key for number, key in enumerate(keys) if number in answer.open),
        clash=answer.clash if answer.clash > 1e-9 and math.isfinite(answer.clash) else 0.0,
        laws=[left for left, _ in equations],
    )


def equation_of(
    row: Row,
    masses: Sequence[float],
    light: Mapping[int, int],
    by_index: Mapping[int, Sequence[tuple[int, float]]],
    force: Sequence[float],
) -> tuple[dict[int, float], float]:
    """slope · q̈ + bend = 0 with the q̈ of what has mass put in: what reactions and light coordinates add, and what is left for them."""
    equation: dict[int, float] = {}
    rest = row.bend or 0.0
    for index, part in row.slope.items():
        if index in light:
            equation[light[index]] = equation.get(light[index], 0.0) + part
            continue
        share = part / masses[index]
        rest -= share * force[index]
        for number, other in by_index.get(index, ()):
            equation[number] = equation.get(number, 0.0) + share * other
    return equation, rest


def rate_by(pushes: Sequence[float], mass: float) -> float:
    """ΣF/m; 0 where the pushes cancel but for rounding."""
    whole = sum(pushes)
    return whole / mass if abs(whole) > ROUNDING * sum(map(abs, pushes)) else 0.0
