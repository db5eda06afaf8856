"""Blow: how rates change through an event that takes no time: M Δq̇ = Σ Λ column, with all that is held still held afterwards."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from itertools import product
from typing import TYPE_CHECKING, Any

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.bodies import on_rim, part_of, radius_of
from rotsolve.confirm.constraints import held_by, rows_of
from rotsolve.confirm.forces import aimed
from rotsolve.confirm.instant import BACK, FORWARD, OPEN, STICKS, Dynamics, Placed, balanced, moment, slip_speed, split
from rotsolve.confirm.jet import Slope, merged
from rotsolve.confirm.lines import told
from rotsolve.confirm.pose import Pose, Way, load, turned
from rotsolve.confirm.rows import Grip, Row
from rotsolve.confirm.seating import put, where
from rotsolve.confirm.signs import GROUND, RIGHT, normal
from rotsolve.elements.at_once import AtOnce
from rotsolve.elements.collisions import Bounces, Collides
from rotsolve.elements.events import Cuts, Fixes, Grips, Impulse, Joins, Leaves, Removes
from rotsolve.language.bodies import PointRef
from rotsolve.language.elements import Event

if TYPE_CHECKING:
    from rotsolve.confirm.known import Known


ACROSS = ("impulse", "normal")  # kinds of the rows of what bounces, along the line on which it comes together
RESTS = 1e-9  # share of the largest rate below which nothing comes together


class Struck(Struct, frozen=True):
    """The instant after an event, and the impulses: of each row that holds, by its owner and kind; `open` are those not settled."""

    placed: Placed
    impulses: Mapping[tuple[str, str], float]
    columns: Mapping[tuple[str, str], Slope]
    open: frozenset[tuple[str, str]]
    clash: float
    loads: Mapping[str, Slope] = {}  # impulses of a size that was told, by owner


class Blowing(Struct, frozen=True):
    """What an event itself does: rows that hold through it, and impulses of known size, by their owner."""

    rows: tuple[Row, ...] = ()
    loads: Mapping[str, Slope] = {}
    grips: tuple[Grip, ...] = ()


def struck(model: Known, before: Placed, event: Event) -> Struck:
    """The rates after an event; `model` is that of the state after it."""
    at = met(model, before, event)
    pose = at.pose(model)
    hit = HITS.get(type(event), unheard)(event, pose, model)
    rows, grips = split(held_by(model, pose))
    grips = [*grips, *hit.grips]
    aims = [changed(row, at) for row in (*rows, *hit.rows) if not row.loose and row.speed is not None]
    gripped = [replace(grip, row=changed(grip.row, at)) for grip in grips]
    held = begun(event)
    for trial in product(*(blow_modes(grip, pose, held) for grip in grips)):
        modes = {grip.name: mode for grip, mode in zip(grips, trial, strict=True)}
        found, parted = without_pulls(model, at, aims, gripped, hit.loads, modes)
        fits = all(lasts(grip, found, at) for grip in grips if grip.name not in held) and not into(parted, found)
        if fits and all(goes_on(grip, (model, at, aims, gripped, hit.loads), found) for grip in hit.grips):
            rates = [old + change for old, change in zip(at.speed, found.rates, strict=True)]
            check_energy(model, hit, at.speed, rates)
            after = replace(at, speed=rates, open=found.open_rates | untouched(at, found), clash=0.0)
            check_lifted(model, after, event)
            return Struck(after, found.reactions, found.columns, found.open_reactions, found.clash, hit.loads)
    raise NotConfirmed(f"no way to stick and slip through `{event.name}` fits")


def check_energy(model: Known, hit: Blowing, before: Sequence[float], after: Sequence[float]) -> None:
    """NotConfirmed where a rough blow gives energy, as a restitution that is told may ask of it."""
    if hit.grips and not hit.loads:
        old, new = (
            sum([mass * rate * rate for mass, rate in zip(model.masses, rates, strict=True)])
            for rates in (before, after)
        )
        if new > old * (1 + 1e-9):
            raise NotConfirmed("the blow would give energy")


def check_lifted(model: Known, after: Placed, event: Event) -> None:
    """NotConfirmed where what goes round with another would go into what it lay on, at once or as it sets out along that."""
    pose, size = after.pose(model), max(map(abs, after.speed), default=0.0)
    for item in model.acting.lifted.get(event.name, ()):
        row = next(row for row in split(rows_of(type(item))(item, pose, model))[0] if row.kind == "normal")
        rise = sum([part * after.speed[index] for index, part in row.slope.items()])
        if abs(rise) <= 1e-9 * size:
            rates = moment(model, after).rates
            rise = sum([part * rates[index] for index, part in row.slope.items()]) - (row.bend or 0.0)
        if rise < -1e-9 * size:
            raise NotConfirmed(f"`{item.name}` is in the way of what `{event.name}` takes along")


def untouched(at: Placed, found: Dynamics) -> frozenset[int]:
    """The rates that nothing told before, and that nothing holds now."""
    return at.open - {index for row in found.rows.values() for index in row.slope}


def changed(row: Row, at: Placed) -> Row:
    """What a row asks of the change of the rates."""
    now = sum([part * at.speed[index] for index, part in row.slope.items()])
    return replace(row, bend=(row.speed or 0.0) - now)


def begun(event: Event) -> frozenset[str]:
    """The contacts that an event begins, which hold through it."""
    return frozenset(event.begins())


def blow_modes(grip: Grip, pose: Pose, held: frozenset[str]) -> tuple[str, ...]:
    """Friction of a size that is not infinite gives no impulse, save with the push that is one."""
    if grip.static is None or grip.name in held:
        return (STICKS,)
    if grip.normal is None:
        return (OPEN,)
    slip = slip_speed(grip, pose.speed)
    first = STICKS if abs(slip) < 1e-12 else FORWARD if slip > 0 else BACK
    return (first, *(mode for mode in (STICKS, FORWARD, BACK) if mode != first))


def lasts(grip: Grip, found: Dynamics, at: Placed) -> bool:
    """Whether friction is within its limit, and slip afterwards as its mode says."""
    mode = found.modes[grip.name]
    if grip.static is None or grip.normal is None or mode == OPEN:
        return True
    if mode == STICKS:
        told = grip.normal not in found.open_reactions  # of a push that nothing settles no friction is certain
        limit = grip.static * abs(found.reactions.get(grip.normal, 0.0)) if told else 0.0
        return abs(found.reactions.get(grip.row.key, 0.0)) <= limit * (1 + 1e-9) + 1e-12
    after = slip_speed(grip, [old + change for old, change in zip(at.speed, found.rates, strict=True)])
    return after >= -1e-12 if mode == FORWARD else after <= 1e-12


def goes_on(
    grip: Grip, struck_by: tuple[Known, Placed, list[Row], list[Grip], Mapping[str, Slope]], found: Dynamics
) -> bool:
    """Whether a rough blow ends as it goes on, the slip by ever more push (Routh): what slipped slips on or stops, and what has stopped
    sticks only where as much friction as there can be would drive it back from either side."""
    mode, at = found.modes[grip.name], struck_by[1]
    slip = slip_speed(grip, at.speed)
    if grip.static is None or grip.normal is None:
        return True
    if mode != STICKS:
        started = abs(slip) <= RESTS * max(map(abs, at.speed)) or (slip > 0.0) == (mode == FORWARD)
        return started and found.reactions.get(grip.normal, 0.0) > 0.0
    gains = []
    for way in (FORWARD, BACK):
        other, _ = without_pulls(*struck_by, {**found.modes, grip.name: way}, pulls=True)
        gains.append(slip_speed(grip, other.rates) * other.reactions[grip.normal])
    least = 1e-9 * max(map(abs, gains))
    return gains[0] <= least and gains[1] >= -least


def without_pulls(
    model: Known,
    at: Placed,
    rows: list[Row],
    grips: list[Grip],
    loads: Mapping[str, Slope],
    modes: dict[str, str],
    *,
    pulls: bool = False,
) -> tuple[Dynamics, list[Row]]:
    """The change of the rates, where what can only push or pull lets go rather than do the opposite, if it may not; and what lets go."""
    rows, parted = list(rows), list[Row]()
    while True:
        found = balanced(model, at, rows, grips, loads, modes)
        size = max([abs(value) for value in found.reactions.values()], default=0.0)
        wrong = [row for row in rows if row.push and found.reactions[row.key] < -1e-9 * size]
        if pulls or not wrong:
            return found, parted
        worst = min(wrong, key=lambda row: found.reactions[row.key])
        rows.remove(worst)
        parted.append(worst)
        grips = [grip for grip in grips if grip.normal != worst.key]


def into(parted: list[Row], found: Dynamics) -> bool:
    """Whether what let go would go into what it touched: with less friction, or more, it is pushed after all."""
    least = -1e-9 * max(map(abs, found.rates), default=0.0)
    for row in parted:
        opens = sum([part * found.rates[index] for index, part in row.slope.items()]) - (row.bend or 0.0)
        along = sum(
            [part * row.column.get(index, 0.0) for index, part in row.slope.items()]
        )  # less than 0 of what pulls
        if math.copysign(opens, opens * along) < least:
            return True
    return False


def met(model: Known, before: Placed, event: Event) -> Placed:
    """The places at an event: of two bodies that meet at a point, one that nothing holds is brought there."""
    pair = event.joined()
    if not pair:
        return before
    q = list(before.q)
    free = [ref for ref in pair if ref.owner not in model.held]
    if not free:
        return before
    mover = min(free, key=lambda ref: (ties(ref.owner, model), model.seats[ref.owner].rigid.inertia > 0.0))
    other = pair[1] if mover is pair[0] else pair[0]
    turns = {ref.owner: q[model.seats[ref.owner].turn] for ref in pair}
    here, there = (model.meeting(ref, turns[ref.owner]) for ref in (mover, other))
    put(mover.owner, here, where(other.owner, there, q, model), q, model)
    offsets = dict(before.offsets) | {f"{event.name}.{owner}": turn for owner, turn in turns.items()}
    return replace(before, q=q, offsets=offsets)


def ties(name: str, model: Known) -> int:
    """How many connections touch a body."""
    return sum(1 for item in model.acting.connections if any(ref.owner == name for ref in item.touches()))


def unheard(event: Event, pose: Pose, model: Known) -> Blowing:
    raise NotConfirmed(f"`{event.name}`: the assembly has no blow for `{event.word}`")


def nothing_but_holds(event: Event, pose: Pose, model: Known) -> Blowing:
    """What holds afterwards, and did not before, is among the rows of the state after."""
    return Blowing()


def impulse(event: Impulse, pose: Pose, model: Known) -> Blowing:
    """A blow of a size that is told."""
    if event.on is None or event.impulse is None:
        return Blowing()
    spot, way = aimed(event.on, event.direction, pose, model)
    size = model.value(event.impulse)
    return Blowing(loads={event.name: load(pose.place(event.on.owner, spot), (size * way[0], size * way[1]))})


def collides(event: Collides, pose: Pose, model: Known) -> Blowing:
    """Along the line of approach the points part e times as fast as they came; where no e is told, as the state after says."""
    way = approach(event, pose, model)
    first, second = (
        load(pose.place(ref.owner, model.meeting(ref, pose.q[model.seats[ref.owner].turn])), way)
        for ref in event.collides
    )
    slope = merged(second, 1.0, first, -1.0)
    if event.restitution is None:
        row = Row(event.name, "impulse", {}, 0.0, 0.0, slope)
        return Blowing((row, *after_lines(event, pose, model)))
    now = sum([part * pose.speed[index] for index, part in slope.items()])
    return Blowing((Row(event.name, "impulse", slope, -model.value(event.restitution) * now, 0.0, slope),))


def several_at_once(event: AtOnce, pose: Pose, model: Known) -> Blowing:
    """Several blows, each of which comes together and pushes."""
    parts = [HITS.get(type(item), unheard)(item, pose, model) for item in event.parts]
    rows = [
        replace(row, push=True) if row.kind in ACROSS else row for part in parts for row in coming_together(part, pose)
    ]
    loads = {owner: slope for part in parts for owner, slope in part.loads.items()}
    return Blowing(tuple(rows), loads, tuple(grip for part in parts for grip in part.grips))


def coming_together(part: Blowing, pose: Pose) -> Iterator[Row]:
    """The rows of one of several blows, those of a push in the sense in which it comes together."""
    for row in part.rows:
        now = sum([share * pose.speed[index] for index, share in row.column.items()])
        if row.kind in ACROSS and abs(now) <= RESTS * max(map(abs, pose.speed), default=0.0):
            raise NotConfirmed(f"what meets in `{row.owner}` rests against each other: no restitution tells its push")
        turn = -1.0 if row.kind in ACROSS and now > 0.0 else 1.0
        speed = None if row.speed is None else turn * row.speed
        slopes = [{index: turn * share for index, share in slope.items()} for slope in (row.slope, row.column)]
        yield replace(row, slope=slopes[0], speed=speed, column=slopes[1])


def bounces(event: Bounces, pose: Pose, model: Known) -> Blowing:
    """Off a flat surface, across it and along it; off something fixed along the line on which the point comes."""
    ref, name = event.struck, event.struck.owner
    x, y = approach(event, pose, model) if event.surface is None else normal(event.surface, model)
    out = (x, y) if event.surface is not None and event.against.owner not in GROUND else (-x, -y)
    spot = model.meeting(ref, pose.q[model.seats[name].turn])
    rim = radius_of(model.body(name), ref.point, model.value) if on_rim(model.body(name), ref.point) else None
    if event.surface is not None and rim is not None:
        middle = model.spot(PointRef(name, ref.point if part_of(model.body(name), ref.point) else None))
        spot = pose.spatial(name, middle, (-rim * out[0], -rim * out[1]))
    across, along_it = (load(pose.place(name, spot), way) for way in (out, turned(out, -1)))
    came, slid = (sum([part * pose.speed[index] for index, part in slope.items()]) for slope in (across, along_it))
    if event.restitution is None:
        rows = (Row(event.name, "normal", {}, 0.0, 0.0, across), *after_lines(event, pose, model))
    else:
        push = event.surface is not None
        rows = (Row(event.name, "normal", across, -model.value(event.restitution) * came, 0.0, across, push=push),)
    if not event.grips:
        return Blowing(rows)
    back = 0.0 if event.tangential is None else model.value(event.tangential)
    row = Row(event.name, "friction", along_it, -back * slid, 0.0, along_it)
    told = event.friction.static, event.friction.kinetic
    static, kinetic = (model.value(size) if size is not None else None for size in told)
    return Blowing(rows, grips=(Grip(event.name, row, static, kinetic, (event.name, "normal")),))


def after_lines(event: Event, pose: Pose, model: Known) -> Iterator[Row]:
    """What the state after tells of rates, as rows without a reaction."""
    for number, line in enumerate(told(model, pose, {})):
        if line.speed is not None:
            yield Row(event.name, f"told{number}", line.slope, line.speed, 0.0, {})


def approach(event: Collides, pose: Pose, model: Known) -> Way:
    """The line on which one of the bodies travels, else that of their relative velocity."""
    points = event.points(())
    for ref in points:
        way = model.line(ref.owner)
        if way is not None:
            return way
    places = [pose.place(ref.owner, model.meeting(ref, pose.q[model.seats[ref.owner].turn])) for ref in points]
    (x, y), *others = places
    u, w = (others[0][0].rate, others[0][1].rate) if others else (0.0, 0.0)
    gap = u - x.rate, w - y.rate
    size = math.hypot(*gap)
    return (gap[0] / size, gap[1] / size) if size else RIGHT


HITS: dict[type[Event], Callable[[Any, Pose, Known], Blowing]] = {
    Joins: nothing_but_holds,
    Fixes: nothing_but_holds,
    Grips: nothing_but_holds,
    Cuts: nothing_but_holds,
    Removes: nothing_but_holds,
    Leaves: nothing_but_holds,
    Impulse: impulse,
    Collides: collides,
    Bounces: bounces,
    AtOnce: several_at_once,
}
