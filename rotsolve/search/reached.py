"""Reached: whether a state is one to which a motion comes at all, where its laws only tell what would hold there.

A speed to which the forces lead, as drag does, is only approached: what lies beyond it is not reached. A quantity that is largest
somewhere has grown on the way there. And what gets to a place has a real speed there, and a spring that is stretched a real length,
whether it is asked for or not. Of letters all these are conditions of the case.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.exact.roots import solve_polynomial
from rotsolve.algebra.formula import ZERO, Call, Formula, Symbol, total
from rotsolve.core.equation import NEWTON
from rotsolve.core.facts import Potential, signed, square
from rotsolve.core.faults import NeverReached
from rotsolve.core.passage import Passage, Travel
from rotsolve.core.symbols import CONSTANT, POSITION, RATE, RATES, TIME, has_quantities, is_key, key_of
from rotsolve.core.writing import spoken
from rotsolve.language.problem import COMES_TO, Path, State
from rotsolve.laws.energy import energy
from rotsolve.motion.timeline import Interval
from rotsolve.paths.meaning import NotYet
from rotsolve.search.answers import NoAnswer
from rotsolve.search.consistency import just_stops
from rotsolve.search.endings import GROWS, never_reached
from rotsolve.search.search import Search

CHANGES = ("displacement", "rotation", "turns")


def not_reached(search: Search) -> Iterator[NeverReached]:
    """The states to which the motion never comes, the first first; those that are `sure` not on its way back either."""
    configuration, aside = search.scene.configuration, search.apart(careful=True)
    for name, found in search.solver.solved.items():
        if found.formula is not None and has_no_number(found.formula, search):
            yield never_reached(
                interval_of(name, search), configuration, "it would take a time that is no real number", sure=True
            )
    slowest = ""
    for interval in configuration.timeline.intervals:
        passage = search.scene.passages.get(interval.name)
        if slowest:
            yield never_reached(
                interval, configuration, f"{slowest} comes to `{interval.start}` ever more slowly", sure=True
            )
        if passage is None:
            continue
        end, slowest = configuration.timeline.state(interval.end), creeping(passage, search, aside)
        why = only_approached(passage, aside) or unchanging(passage, aside)
        turned = "" if why else not_grown(interval, passage, end, aside)
        why = why or impossible(interval, passage, aside) or overdrawn(interval, passage, aside)
        why = why or only_neared(passage, search, aside)
        limit = end.balance or any(
            line.word in COMES_TO for line in end.conditions
        )  # an equilibrium, or a highest place
        if slowest and not limit:
            why = why or f"{slowest} comes there ever more slowly"
        if why or turned:
            # what turns back at the other extreme may come to it from there
            yield never_reached(interval, configuration, why or turned, sure=bool(why))


def instead_of_there(state: str, search: Search) -> str:
    """Where a motion goes with a steady acceleration that does not come to a state, of which nothing but one value is told; '' where that
    is not known."""
    timeline = search.scene.configuration.timeline
    ways = (one for one in timeline.intervals if one.event is None and not timeline.state(one.start).opened)
    interval = next((one for one in ways if one.end == state), None)
    told = [line for line in timeline.state(state).conditions if line.value is not None]
    passage = search.scene.passages.get(interval.name) if interval is not None and len(told) == 1 else None
    aside = search.apart(careful=True)
    for travel in passage.travels if passage is not None else ():
        found = [aside.settled(travel.acceleration), aside.settled(travel.before)]
        push, start = (None if value is None else search.numbers.side(value) for value in found)
        if travel.pace != CONSTANT or push is None or start is None:
            continue
        if push == start == 0:
            return f"{spoken(travel.body)} stays where it is"
        if push * start < 0:
            return f"{spoken(travel.body)} comes to rest before, and turns back"
        return f"{spoken(travel.body)} goes the other way, and nothing brings it back"
    return ""


def led_away_from(intervals: Iterable[Interval], search: Search) -> Iterator[NeverReached]:
    """The states that tell a rate to which a steady acceleration does not lead, Δv/a < 0, of phases whose time nothing else tells."""
    configuration, aside = search.scene.configuration, search.apart(careful=True)
    for interval in intervals:
        passage = search.scene.passages[interval.name]
        lasts = aside.settled(passage.duration)
        side = None if lasts is None or has_quantities(lasts) else search.numbers.side(lasts)
        if side == -1:
            yield never_reached(interval, configuration, "what moves goes away from it")
        for travel in passage.travels if side is None else ():
            push, gained = aside.settled(travel.acceleration), aside.settled(travel.after - travel.before)
            sides = [None if value is None else search.numbers.side(value) for value in (push, gained)]
            if travel.pace == CONSTANT and sides[0] == 0 and sides[1]:
                yield never_reached(interval, configuration, f"{spoken(travel.body)} goes on as fast as it does")


def only_neared(passage: Passage, search: Search, aside: Search) -> str:
    """Why a motion does not come to a place where it would come to rest with nothing that drives it there: it sets out from none, or
    comes to one ever more slowly, as a pendulum to its upper balance."""
    for travel in passage.travels if has_quantities(passage.times[1]) else ():
        if just_stops(travel, search) or just_stops(travel, aside):
            last, gone = push_at_end(travel, aside), aside.settled(travel.change)
            sides = [None if value is None else search.numbers.side(value) for value in (last, gone)]
            if sides[0] == 0 and sides[1]:
                return f"nothing drives {spoken(travel.body)} where it would come to rest"
    return ""


def unchanging(passage: Passage, search: Search) -> str:
    """Why a speed does not become what a state tells, though the forces beside it vary: nothing drives what has it, at any place."""
    for travel in passage.travels:
        if travel.pace in (CONSTANT, TIME) or search.settled(travel.acceleration) != ZERO:
            continue
        gained = search.settled(travel.after - travel.before)
        if gained is not None and search.numbers.side(gained):
            return f"{spoken(travel.body)} goes on as fast as it does"
    return ""


def creeping(passage: Passage, search: Search, aside: Search) -> str:
    """What comes to rest at the end of a phase where nothing drives it, at a place that no state tells, or tells by a letter that is
    sought: for ever on its way there, as a pendulum to its upper balance. Only with the very numbers that are looked at: at the edge of a
    case of letters."""
    problem = search.scene.configuration.problem
    sought = {name: search.solver.solved.get(name) for name in problem.sought}
    settled = {name: found.formula for name, found in sought.items() if found is not None and found.formula is not None}
    for travel in passage.travels:
        stops = travel.pace == POSITION and travel.after == ZERO and travel.end is not None
        last = push_at_end(travel, aside) if stops and open_place(travel, problem.sought) else None
        last = None if last is None else simplify(last.substitute(settled))
        number = None if last is None else search.signs.at_trial(search.signs.with_asked(last))
        gone = (aside.settled(travel.change) or ZERO).substitute(settled)
        if number is not None and not number.sign and search.numbers.side(gone):
            return spoken(travel.body)
    return ""


def open_place(travel: Travel, sought: Collection[str]) -> bool:
    """Whether no state tells by what is given where a phase ends."""
    return travel.end is not None and (has_quantities(travel.end) or not travel.end.symbols().isdisjoint(sought))


def push_at_end(travel: Travel, search: Search) -> Formula | None:
    """The acceleration with which a phase ends; None where the laws do not tell it."""
    rate = travel.acceleration
    push = search.beside_by((NEWTON,)).settled(rate) if isinstance(rate, Symbol) else search.settled(rate)
    place = None if travel.end is None else signed(travel.end, travel.sense)
    ends = ((travel.moving, travel.after), (travel.coordinate, place))
    put = {run.name: search.settled(end) for run, end in ends if isinstance(run, Symbol) and end is not None}
    last = None if push is None else push.substitute({name: end for name, end in put.items() if end is not None})
    return None if last is None or has_quantities(last) else last


def has_no_number(value: Formula, search: Search) -> bool:
    """Whether what a logarithm is taken of is not positive, as of a time that nothing takes."""
    insides = (node.arguments[0] for node in value.walk("log") if isinstance(node, Call) and node.function == "log")
    return value.holds("log") and any(search.numbers.side(inside) in (0, -1) for inside in insides)


def interval_of(letter: str, search: Search) -> Interval:
    """The phase of which a letter of the laws speaks, or that leads to its state; the last one where it tells none."""
    timeline = search.scene.configuration.timeline
    when = key_of(letter).when if is_key(letter) else ""
    before = timeline.before(when) if when in timeline.order else None
    return timeline.interval(when) or before or timeline.intervals[-1]


def only_approached(passage: Passage, search: Search) -> str:
    """Why a speed of a phase lies beyond the one to which the forces lead, where they vanish; at that it ends in the limit."""
    for travel in passage.travels:
        found = pushes_at_ends(travel, search) if travel.leads and travel.pace == RATE else None
        if found is None:
            continue
        (first, last), gained = found
        what = f"the {'velocity' if travel.kind == 'line' else 'angular velocity'} of {spoken(travel.body)}"
        way = search.numbers.side(first)
        onward = search.numbers.side(signed(last, way)) if way else None
        if onward == -1:
            return f"{what} would have to go beyond the one to which its forces lead"
        # up to a told time it goes on, whatever speed it has; where nothing drives it on it ends in the limit
        if onward in (0, 1) and way and has_quantities(passage.times[1]):
            if search.numbers.side(signed(gained, way)) == -1:
                return f"{what} would have to change against its forces"
            if any(search.numbers.side(signed(push, way)) in (0, -1) for push in pushes_between(travel, search)):
                return f"{what} comes to one on the way at which nothing drives it on"
        if way == 0 and search.numbers.side(gained):
            return f"{what} does not change: nothing drives it at `{passage.start.state}`"
    return ""


def pushes_at_ends(travel: Travel, search: Search) -> tuple[tuple[Formula, Formula], Formula] | None:
    """The acceleration at both ends of a phase, where the forces go by the speed alone, and by how much that grows; None where the laws
    do not tell it."""
    push, first, last = push_by_speed(travel, search)
    if push is None or first is None or last is None or not isinstance(travel.moving, Symbol):
        return None
    ends = push.substitute({travel.moving.name: first}), push.substitute({travel.moving.name: last})
    return None if any(map(has_quantities, ends)) else (ends, last - first)


def push_by_speed(travel: Travel, search: Search) -> tuple[Formula | None, Formula | None, Formula | None]:
    """The acceleration by the speed of a phase, and that speed at both ends; None each where the laws do not tell it."""
    rate = travel.acceleration
    push = search.beside_by((NEWTON,)).settled(rate) if isinstance(rate, Symbol) else rate
    return push, search.settled(travel.before), search.settled(travel.after)


def pushes_between(travel: Travel, search: Search) -> Iterator[Formula]:
    """The acceleration where it is largest or smallest between the speeds at both ends of a phase."""
    push, first, last = push_by_speed(travel, search)
    if push is None or first is None or last is None or not isinstance(travel.moving, Symbol):
        return
    name = travel.moving.name
    for at in solve_polynomial(simplify(differentiate(push, name)), name):
        gaps = simplify(at - first), simplify(last - at)
        if ZERO not in gaps and search.numbers.side(gaps[0] * gaps[1]) == 1:
            yield simplify(push.substitute({name: at}))


def impossible(interval: Interval, passage: Passage, search: Search) -> str:
    """Why nothing can be so at the end of a phase: a speed there, or the place where it turns back, has no real value."""
    if all(travel.pace in (CONSTANT, TIME) for travel in passage.travels) or not has_quantities(passage.times[1]):
        return ""  # up to a told time it goes on, wherever that leads
    for name in unsettled(interval, passage, search):
        try:
            search.value_of(name)
        except NoAnswer as error:
            if error.equation is not None:
                return f"with what it has at `{interval.start}`, {spoken(key_of(name).owner)} does not get so far"
    return ""


def overdrawn(interval: Interval, passage: Passage, search: Search) -> str:
    """Why a spring would have to give more energy than it has: of ½ k x² = K₁ + U₁ + W − K₂ − U₂, without it in U₂, no x is the root."""
    for item in passage.end.potentials:
        if not has_quantities(search.solver.with_found(item.elongation)):  # it may vanish there
            continue
        stiff = simplify(item.energy / square(item.elongation))
        if has_quantities(stiff):
            continue
        for group in passage.groups:
            left = left_for_a_spring(item, passage, group)
            value = None if left is None else search.settled(simplify(stiff * left))
            if value is not None and not has_quantities(value) and search.numbers.side(value) == -1:
                return f"what moves there would have more energy than it has at `{interval.start}`"
    return ""


def left_for_a_spring(item: Potential, passage: Passage, group: frozenset[str]) -> Formula | None:
    """What the law of energy leaves for a spring at the end of a phase; None where it does not go for the group."""
    shafts = any(body.sweep is not None for body in passage.start.bodies if body.name in group)
    if shafts or not group & set(item.bodies) or any(passage.heights.get(name) is None for name in group):
        return None
    works = [work.amount for work in passage.works if group & set(work.bodies)]
    return total([*energy(passage, group, 0), *works]) - total(energy(passage, group, 1)) + item.energy


def unsettled(interval: Interval, passage: Passage, search: Search) -> Iterator[str]:
    """The rates at the end of a phase, and the places along which its forces vary, of which nothing is known so far."""
    quantities = search.scene.registry.quantities
    names = [name for name, item in quantities.items() if item.kind in RATES and item.when == interval.end]
    names += [travel.end.name for travel in passage.travels if isinstance(travel.end, Symbol)]
    for name in names:
        if is_key(name) and name not in search.solver.solved and has_quantities(search.solver.with_found(Symbol(name))):
            yield name


def not_grown(interval: Interval, passage: Passage, end: State, search: Search) -> str:
    """Why a quantity is not largest (or smallest) at the end of a phase: it has not grown on the way."""
    for line in end.conditions:
        if line.word not in GROWS or line.path is None:
            continue
        gained = growth_of(line.path, interval, passage, search)
        if gained is not None and search.numbers.side(gained) == -GROWS[line.word]:
            there = "smallest" if line.word == "largest" else "largest"
            return f"the {spoken(line.path.quantity)} of {spoken(line.path.owner)} is {there} there, not {line.word}"
    return ""


def growth_of(path: Path, interval: Interval, passage: Passage, search: Search) -> Formula | None:
    """By how much a quantity grows in a phase, with the answers put in; None where that is not told."""
    if path.quantity in CHANGES:
        kind = "line" if path.quantity == "displacement" else "turn"
        ways = [travel.change for travel in passage.travels if travel.body == path.owner and travel.kind == kind]
        gained = ways[0] if len(ways) == 1 and not path.component else None
    else:
        readers = (search.scene.reader(state) for state in (interval.end, interval.start))
        try:
            last, first = (reader.meaning(path).formula for reader in readers)
        except NotYet:  # the questions are refused for that themselves
            return None
        gained = last - first
    value = None if gained is None else search.settled(gained)
    return None if value is None or has_quantities(value) else value
