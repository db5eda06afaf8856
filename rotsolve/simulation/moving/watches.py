"""Watches: what may happen on the way, each as a value that passes zero when it does: slipping ends or begins, a string goes slack,
a state of the scene is reached.

What slips is at rest again when its rate of slipping is zero. What sticks begins to slip when the friction that it takes is as large as
that with which it would slip, one way or the other.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from msgspec import Struct

from rotsolve.algebra.flints import fmpq
from rotsolve.algebra.formula import PI, Formula, call
from rotsolve.core.facts import Couple, Facts, Force
from rotsolve.core.registry import COURSE
from rotsolve.core.writing import spoken
from rotsolve.inquiry.questions import NotYet, Reader
from rotsolve.inquiry.states.statements import EXTREMES, RATE_OF
from rotsolve.language.problem import Condition, Path, State
from rotsolve.motion.freebody import free_bodies
from rotsolve.motion.instant import Instant
from rotsolve.motion.rubs import AT_MOST, BACK, FORWARD, TURNS_BACK, Rub, rubs_at
from rotsolve.simulation.moving.course import Course
from rotsolve.simulation.moving.names import refusal
from rotsolve.simulation.tape.series import needed
from rotsolve.simulation.tape.tape import ONE, Exact, Unwritable

PASSED = {"displacement": "position", "rotation": "angle", "turns": "angle"}  # what counts from the state before
ZERO_THERE = {"slack": "tension", "leaves": "normal_force"}
STOPS, SLIPS, BREAKS, REACHED, TURNS = "stops", "slips", "breaks", "reached", "turns"


class Watch(Struct, frozen=True):
    """A value on the tape of a course that passes zero when something happens.

    `kind`: STOPS of what slips, SLIPS of what sticks, BREAKS of what can only push or pull, REACHED of a state of the scene, TURNS of a
    value between bars. `rub` and `mode` tell what begins to slip, and how.
    """

    kind: str
    place: int
    what: str
    rub: Rub | None = None
    mode: str = ""


def watches(course: Course, modes: Mapping[str, str], ahead: State | None, since: Mapping[str, Exact]) -> list[Watch]:
    """All that may happen in a course; `ahead` is the state of the scene that comes next, `since` what was told at the last one."""
    found: list[Watch] = []
    for rub in rubs_at(course.moment.configuration, course.moment.state):
        found += of_rub(rub, course, modes)
    for item in course.facts.requirements:
        if item.otherwise != "slips":
            value = item.left - item.right
            if told(course, value):
                found.append(Watch(BREAKS, place_of(course, value), item.otherwise))
    rates = needed(course.tape, [item.rate for item in course.variables])
    sizes = [course.tape.operations[place] for place in rates if course.tape.operations[place].kind == "abs"]
    found += [Watch(TURNS, operation.values[0], "") for operation in sizes]
    if ahead is not None:
        found += of_state(ahead, course, since)
    return [watch for watch in found if course.tape.constant(watch.place) is None]


def told(course: Course, value: Formula) -> bool:
    """Whether all letters of a value are told by the laws."""
    return all(name in course.letters for name in value.symbols())


def place_of(course: Course, value: Formula) -> int:
    try:
        return course.tape.formula(value, course.letters)
    except Unwritable as error:
        raise refusal(error, course.moment.registry) from None


def of_rub(rub: Rub, course: Course, modes: Mapping[str, str]) -> Iterator[Watch]:
    """When what rubs comes to rest, or begins to slip."""
    mode, name = modes.get(rub.key, ""), owner_of(rub)
    brake = rub.contact is None and rub.pair is None
    if mode in (FORWARD, BACK, TURNS_BACK) or (brake and not mode):
        speed = rub.rate(course.moment)
        if speed is not None and told(course, speed):
            what = f"{spoken(rub.body)} comes to rest" if brake else f"{spoken(name)}: slipping ends"
            yield Watch(STOPS, place_of(course, speed), what, rub)
        return
    held = grip(course.facts, rub)
    for sense in (1, -1):
        limit = grip(slipping(course.moment, rub, sense), rub)
        if held is None or limit is None:
            continue
        room = along(limit, held) - along(held, held)
        if not told(course, room):
            raise NotYet(f"the laws do not tell how much friction `{name}` takes, and so not whether it slips")
        what = f"{spoken(rub.body)} begins to turn" if brake else f"{spoken(name)} begins to slip"
        yield Watch(SLIPS, place_of(course, room), what, rub, rub.mode(sense))


def owner_of(rub: Rub) -> str:
    """The element whose friction it is."""
    return rub.key.partition("@")[0].partition(".")[0]


def slipping(moment: Instant, rub: Rub, sense: int) -> Facts:
    """The facts of a moment if it were just about to slip one way."""
    mode = rub.mode(sense) + (AT_MOST if rub.contact is not None or rub.pair is not None else "")
    modes = {**moment.modes, rub.key: mode}
    return free_bodies(Instant(moment.configuration, moment.registry, moment.state, True, modes, mark=COURSE))


def grip(facts: Facts, rub: Rub) -> Force | Couple | None:
    """The friction on the body that rubs."""
    body = facts.body(rub.body)
    acting = body.acting if body is not None else ()
    return next((item for item in acting if item.owner == owner_of(rub) and item.role == "friction"), None)


def along(item: Force | Couple, reference: Force | Couple) -> Formula:
    """The friction along the direction of another; of couples the torque."""
    if isinstance(item, Force) and isinstance(reference, Force):
        return item.vector.dot(reference.direction)
    return item.torque


def of_state(state: State, course: Course, since: Mapping[str, Exact]) -> Iterator[Watch]:
    """When a state is reached: where the first of its lines that tells a quantity holds."""
    for condition in state.conditions:
        path = condition.path
        if path is not None and path.quantity in PASSED and condition.value is not None:
            place = passed(path, condition.value, course, since)
        else:
            value = gap(condition, course)
            place = place_of(course, value) if value is not None and told(course, value) else None
        if place is not None:
            yield Watch(REACHED, place, state.name)
            return


def passed(path: Path, value: Formula, course: Course, since: Mapping[str, Exact]) -> int | None:
    """A way or an angle gone since the state before, less what it is to be; `since` has what was told at that state."""
    name = f"{path.owner}.{PASSED[path.quantity]}" + (f".{path.component}" if path.component else "")
    if name not in course.outputs or name not in since or not told(course, value):
        return None
    sense = course.moment.sense(path.owner) if path.quantity != "displacement" else 1
    wanted = course.tape.formula(2 * PI * value if path.quantity == "turns" else value, course.letters)
    gone = course.tape.sum([(course.outputs[name], ONE), (course.tape.number(since[name]), -ONE)])
    return course.tape.sum([(gone, fmpq(sense)), (wanted, -ONE)])


def gap(condition: Condition, course: Course) -> Formula | None:
    """What is zero where a line of a state holds."""
    path = condition.path
    if path is None:
        return None
    if condition.word in EXTREMES and path.quantity in RATE_OF:
        return meaning(Path(path.owner, RATE_OF[path.quantity], path.point, path.argument, path.component), course)
    if condition.word in ZERO_THERE:
        return meaning(Path(path.owner, ZERO_THERE[condition.word]), course)
    if condition.value is None:
        return None
    if path.quantity == "time":
        return course.moment.time() - condition.value
    found = meaning(path, course)
    if found is None:
        return None
    turned = path.quantity == "angle"  # one of the places on its circle
    return call("sin", (found - condition.value) / 2) if turned else found - condition.value


def meaning(path: Path, course: Course) -> Formula | None:
    """What a path stands for at any moment of a course; None where that is not told there."""
    try:
        return Reader(course.moment, lambda: course.facts).meaning(path).formula
    except NotYet:
        return None
