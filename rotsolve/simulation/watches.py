"""Watches: what may happen on the way, each as a value that passes zero when it does: slipping ends or begins, a string goes slack,
a state of the scene is reached.

What slips is at rest again when its rate of slipping is zero. What sticks begins to slip when the friction that it takes is as large as
that with which it would slip, one way or the other."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from msgspec import Struct

from rotsolve.algebra.flints import fmpq
from rotsolve.algebra.formula import PI, Formula, Symbol, call
from rotsolve.algebra.tape import ONE, Exact, Unwritable
from rotsolve.core.facts import Couple, Facts, Force
from rotsolve.core.symbols import COURSE, TIME
from rotsolve.core.writing import spoken
from rotsolve.equations.states import RATE_OF
from rotsolve.language.problem import EXTREMES, Condition, Path, State
from rotsolve.motion.freebody import free_bodies
from rotsolve.motion.instant import Instant
from rotsolve.motion.rubs import AT_MOST, BACK, FORWARD, TURNS_BACK, Rub, rubs_at
from rotsolve.paths.meaning import NotYet
from rotsolve.paths.reader import PathReader
from rotsolve.simulation.system import PlanarSystem, System, refusal, unnumbered
from rotsolve.simulation.tape import Scalar
from rotsolve.simulation.taylor import TaylorStep, horner

PASSED = {"displacement": "position", "rotation": "angle", "turns": "angle"}  # what counts from the state before
ZERO_THERE = {"slack": "tension", "leaves": "normal_force"}
STOPS, SLIPS, BREAKS, REACHED, TURNS = "stops", "slips", "breaks", "reached", "turns"


class Watch(Struct, frozen=True):
    """A value on the tape of a system that passes zero when something happens.

    `kind`: STOPS of what slips, SLIPS of what sticks, BREAKS of what can only push or pull, REACHED of a state of the scene, TURNS of a
    value between bars. `rub` and `mode` tell what begins to slip, and how. What `falls` only counts where it passes zero downwards.
    """

    kind: str
    place: int
    what: str
    rub: Rub | None = None
    mode: str = ""
    falls: bool = False


def watches(
    system: PlanarSystem, modes: Mapping[str, str], ahead: State | None, since: Mapping[str, Exact]
) -> list[Watch]:
    """All that may happen in a system; `ahead` is the state of the scene that comes next, `since` what was told at the last one."""
    found: list[Watch] = []
    for rub in rubs_at(system.moment.configuration, system.moment.state):
        found += of_rub(rub, system, modes)
    for item in system.facts.requirements:
        if not item.kind.grips:
            value = item.left - item.right
            if is_told(system, value):
                found.append(Watch(BREAKS, place_on_tape(system, value), item.otherwise))
    return changing(system, found, list(of_state(ahead, system, since)) if ahead is not None else [])


def changing(system: System, found: Sequence[Watch], reached: Sequence[Watch]) -> list[Watch]:
    """Those of some watches whose values change, with all values between bars on which the motion hangs."""
    rates = system.tape.needed(item.rate for item in system.variables)
    sizes = [system.tape.operations[place] for place in rates if system.tape.operations[place].kind == "abs"]
    bars = [Watch(TURNS, operation.values[0], "") for operation in sizes]
    return [watch for watch in (*found, *bars, *reached) if system.tape.constant(watch.place) is None]


def is_told(system: PlanarSystem, value: Formula) -> bool:
    """Whether all letters of a value are told by the laws."""
    return all(name in system.letters for name in value.symbols())


def place_on_tape(system: PlanarSystem, value: Formula) -> int:
    try:
        return system.tape.formula(value, system.letters)
    except Unwritable as error:
        raise refusal(error, system.moment.registry) from None


def of_rub(rub: Rub, system: PlanarSystem, modes: Mapping[str, str]) -> Iterator[Watch]:
    """When what rubs comes to rest, or begins to slip."""
    mode, name = modes.get(rub.key, ""), rub.owner
    brake = rub.item is None
    if mode in (FORWARD, BACK, TURNS_BACK) or (brake and not mode):
        speed = rub.rate(system.moment)
        if speed is not None and is_told(system, speed):
            what = f"{spoken(rub.body)} comes to rest" if brake else f"{spoken(name)}: slipping ends"
            yield Watch(STOPS, place_on_tape(system, speed), what, rub)
        return
    held = grip(system.facts, rub)
    for sense in (1, -1):
        limit = grip(slipping(system.moment, rub, sense), rub)
        if held is None or limit is None:
            continue
        room = friction_along(limit, held) - friction_along(held, held)
        if not is_told(system, room):
            raise NotYet(f"the laws do not tell how much friction `{name}` takes, and so not whether it slips")
        what = f"{spoken(rub.body)} begins to turn" if brake else f"{spoken(name)} begins to slip"
        yield Watch(SLIPS, place_on_tape(system, room), what, rub, rub.mode(sense))


def slipping(moment: Instant, rub: Rub, sense: int) -> Facts:
    """The facts of a moment if it were just about to slip one way."""
    mode = rub.mode(sense) + (AT_MOST if rub.item is not None else "")
    modes = {**moment.modes, rub.key: mode}
    return free_bodies(Instant(moment.configuration, moment.registry, moment.state, True, modes, mark=COURSE))


def grip(facts: Facts, rub: Rub) -> Force | Couple | None:
    """The friction on the body that rubs."""
    body = facts.body(rub.body)
    acting = body.acting if body is not None else ()
    return next((item for item in acting if item.owner == rub.owner and item.role.rubs), None)


def friction_along(item: Force | Couple, reference: Force | Couple) -> Formula:
    """The friction along the direction of another; of couples the torque."""
    if isinstance(item, Force) and isinstance(reference, Force):
        return item.vector.dot(reference.direction)
    return item.torque


def of_state(state: State, system: PlanarSystem, since: Mapping[str, Exact]) -> Iterator[Watch]:
    """When a state is reached: where the first of its lines that tells a quantity holds."""
    for condition in state.conditions:
        path = condition.path
        if path is not None and path.quantity in PASSED and condition.value is not None:
            place = passed(path, condition.value, system, since)
        elif path is not None and path.quantity == "time" and condition.value is not None:
            place = time_gone(condition.value, system, since)
        else:
            value = state_gap(condition, system)
            place = place_on_tape(system, value) if value is not None and is_told(system, value) else None
        if place is not None:
            yield Watch(REACHED, place, state.name)
            return


def passed(path: Path, value: Formula, system: PlanarSystem, since: Mapping[str, Exact]) -> int | None:
    """A way or an angle gone since the state before, less what it is to be; `since` has what was told at that state."""
    name = f"{path.owner}.{PASSED[path.quantity]}" + (f".{path.component}" if path.component else "")
    if name not in system.outputs or name not in since or not is_told(system, value):
        return None
    sense = system.moment.sense(path.owner) if path.quantity != "displacement" else 1
    wanted = system.tape.formula(2 * PI * value if path.quantity == "turns" else value, system.letters)
    gone = system.tape.sum([(system.outputs[name], ONE), (system.tape.number(since[name]), -ONE)])
    return system.tape.sum([(gone, fmpq(sense)), (wanted, -ONE)])


def time_gone(value: Formula, system: System, since: Mapping[str, Exact]) -> int:
    """The time since the state before, less what it is to be."""
    for letter in sorted(value.symbols() - system.letters.keys()):
        raise unnumbered(letter)
    ahead = system.tape.formula(Symbol(TIME) - value, system.letters)
    return system.tape.sum([(ahead, ONE), (system.tape.number(since[TIME]), -ONE)])


def state_gap(condition: Condition, system: PlanarSystem) -> Formula | None:
    """What is zero where a line of a state holds."""
    path = condition.path
    if path is None:
        return None
    if condition.word in EXTREMES and path.quantity in RATE_OF:
        return formula_at(Path(path.owner, RATE_OF[path.quantity], path.point, path.argument, path.component), system)
    if condition.word in ZERO_THERE:
        return formula_at(Path(path.owner, ZERO_THERE[condition.word]), system)
    if condition.value is None:
        return None
    found = formula_at(path, system)
    if found is None:
        return None
    turned = path.quantity == "angle"  # one of the places on its circle
    return call("sin", (found - condition.value) / 2) if turned else found - condition.value


def formula_at(path: Path, system: PlanarSystem) -> Formula | None:
    """What a path stands for at any moment of a system; None where that is not told there."""
    try:
        return PathReader(system.moment, lambda: system.facts).meaning(path).formula
    except NotYet:
        return None


SAMPLES = 8  # moments of a step at which the watched values are looked at
HALVINGS = 200
CLEAR = 1e-9  # a value smaller than this part of what it comes to in the step has no sign of its own at the start


class Hit(Struct, frozen=True):
    """A watched value passes zero."""

    watch: Watch
    time: float
    also: tuple[Watch, ...] = ()  # states of the scene that are reached at once


class Lookout:
    """Looks at the watched values along the pieces of a motion; a piece is so short that they hardly bend in it."""

    def __init__(self, watched: Sequence[Watch], sides: Mapping[Watch, int]) -> None:
        self.watched = watched
        self.sides = [sides.get(watch, 0) for watch in watched]  # the last sign that each had

    def told(self) -> dict[Watch, int]:
        """The last signs, for what goes on from here with the same equations."""
        return dict(zip(self.watched, self.sides, strict=True))

    def first(self, piece: TaylorStep) -> Hit | None:
        """The first moment in a piece at which one of the values passes zero."""
        if not self.watched:
            return None
        times = [piece.length * k / SAMPLES for k in range(SAMPLES + 1)]
        found = (self._passage(number, times, polynomial) for number, polynomial in enumerate(piece.watched))
        hits = [
            Hit(watch, piece.start + time) for watch, time in zip(self.watched, found, strict=True) if time is not None
        ]
        if not hits:
            return None
        first = min(hits, key=lambda hit: hit.time)
        near = first.time + CLEAR * piece.length
        also = (hit.watch for hit in hits if hit.time <= near and hit.watch.kind == REACHED != first.watch.kind)
        return Hit(first.watch, first.time, tuple(also))

    def _passage(self, number: int, times: Sequence[float], polynomial: Sequence[Scalar]) -> float | None:
        """When one value passes zero, seen by its signs at some times since the start of the piece."""
        row = [horner(polynomial, time) for time in times]
        side, low = self.sides[number], times[0]
        if not side and abs(row[0]) > CLEAR * max(abs(item) for item in row):
            side = sign_of_float(row[0])
        for time, now in zip(times[1:], row[1:], strict=True):
            if side and sign_of_float(now) == -side and not (self.watched[number].falls and side < 0):
                return crossing_time(polynomial, low, time, side)
            side, low = sign_of_float(now) or side, time
        self.sides[number] = side
        return None


def crossing_time(polynomial: Sequence[Scalar], low: float, high: float, side: int) -> float:
    """Where a polynomial passes zero between two times: by chords, halving the weight of an end that stays (Illinois)."""
    below, above = horner(polynomial, low), horner(polynomial, high)
    if sign_of_float(below) != side:
        return low
    for _ in range(HALVINGS):
        middle = high - float(above * (high - low) / (above - below))
        if not low < middle < high:
            break
        found = horner(polynomial, middle)
        if sign_of_float(found) == side:
            low, below, above = middle, found, above / 2
        else:
            high, above, below = middle, found, below / 2
        if not found:
            break
    return min(low, high, key=lambda time: abs(horner(polynomial, time)))


def sign_of_float(number: Scalar) -> int:
    return 1 if number > 0 else -1 if number < 0 else 0
