"""Explain: why there is no answer, in the scene's words: what is missing or contradictory, where, and what may help."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.formula import ZERO, Formula, Symbol
from rotsolve.core.derivation import Answer, Derivation
from rotsolve.core.equation import NEWTON, Equation
from rotsolve.core.faults import Fault, Span, Unsolvable
from rotsolve.core.quantity import DIMENSIONS, INSIDE
from rotsolve.core.registry import GENERIC, SEPARATOR, VIRTUAL, Quantity
from rotsolve.core.writing import spoken
from rotsolve.elements.connections.contacts.touch import Touch
from rotsolve.inquiry.answering import Inquiry, NoAnswer
from rotsolve.inquiry.history import History
from rotsolve.inquiry.questions import path_text
from rotsolve.inquiry.verify import SAID
from rotsolve.motion.arrangement import Arrangement
from rotsolve.scene.model import Body, Find, Given, Problem
from rotsolve.solver import ENTANGLED

MANY = 6  # unknowns that a message names one by one
FORCES = ("force", "tension", "normal_force", "friction_force", "impulse", "torque")
STATED = {  # what a state can say, with an example
    "angle": "30 deg",
    "velocity": "2 m/s",
    "angular_velocity": "3 rad/s",
    "elongation": "10 cm",
    "displacement": "1 m",
    "rotation": "2 rev",
}
RATES = ("velocity", "angular_velocity")
CHECK_DATA = "check the givens and what the states say"


def unsolvable(problem: Problem, message: str, span: Span | None = None, help: str = "") -> Unsolvable:
    """A message with its place in the file."""
    return Unsolvable(message, span=span, help=help, lines=problem.lines, file=problem.file)


def no_answer(error: NoAnswer, inquiry: Inquiry, find: Find) -> Unsolvable:
    """What is missing or contradictory for one question."""
    problem = inquiry.history.arrangement.problem
    if error.equation is not None:
        return contradicted(inquiry.planner.pool[error.equation], inquiry.history, find.span)
    alone = "" if NEWTON in inquiry.families else f" by {SAID[inquiry.families[0]]} alone"
    missing = [] if error.shortage is None else open_quantities(error.shortage.unknowns, inquiry.history)
    if error.open_form and str(error) != ENTANGLED:
        return unsolvable(problem, f"`{find.name}` can not be found{alone}: {error}", find.span, CHECK_DATA)
    if error.shortage is None or not missing:
        help = suggestion((), inquiry.history)
        return unsolvable(problem, f"too little is known to find `{find.name}`{alone}", find.span, help)
    laws = [index for index in error.shortage.equations if is_law(inquiry.planner.pool[index])]
    counted = f"{plural(len(laws), 'equation')} for {plural(len(missing), 'unknown')}"
    counted = counted if len(laws) < len(missing) else "nothing settles"
    message = f"too little is known to find `{find.name}`{alone}: {counted}: {listed(missing, inquiry.history)}"
    return unsolvable(problem, message, find.span, suggestion(missing, inquiry.history, error.shortage.asked))


def is_law(equation: Equation) -> bool:
    """Whether an equation is of the scene, and not what a question means."""
    return bool(equation.label) and not any(name.startswith("asked" + SEPARATOR) for name in equation.symbols())


def open_quantities(names: Iterable[str], history: History) -> list[Quantity | str]:
    """The unknowns that the scene has words for: quantities of the laws, and letters that it asks for."""
    quantities = history.registry.quantities
    asked = {given.name for given in history.arrangement.problem.givens if given.asked}
    found: dict[Quantity | str, None] = {}
    for name in names:
        if name in quantities:
            found[quantities[name]] = None
        elif name in asked:
            found[name] = None
    return list(found)


def listed(missing: Sequence[Quantity | str], history: History) -> str:
    """What the unknowns are; of many only the first few."""
    told = [told_quantity(item, history) if isinstance(item, Quantity) else f"`{item}`" for item in missing]
    told = list(dict.fromkeys(told))
    more = f" and {len(told) - MANY} more" if len(told) > MANY else ""
    return ", ".join(told[:MANY]) + more


def told_quantity(quantity: Quantity, history: History) -> str:
    """A quantity of the laws in the scene's words: "tension of cord at held"."""
    at_cut = quantity.kind in INSIDE  # the index is that of the cut, no direction
    side = "" if at_cut else {"x": "horizontal ", "y": "vertical "}.get(quantity.component, "")
    owner = f" of {spoken(quantity.owner)}" if quantity.owner else ""
    return f"{side}{spoken(quantity.kind)}{owner}{moment(quantity.when, history)}"


def moment(when: str, history: History) -> str:
    """When a quantity is, in words; nothing where the scene has one nameless instant."""
    name = when.replace(VIRTUAL, "")
    timeline = history.arrangement.timeline
    if name.startswith(GENERIC):
        phase = timeline.phase_of(name.removeprefix(GENERIC))
        return f" on the way from {spoken(phase.start)} to {spoken(phase.end)}" if phase is not None else ""
    interval = timeline.interval(name)
    if interval is None:
        return f" at {spoken(name)}" if name else ""
    return (
        f" in {spoken(name)}"
        if interval.event is not None
        else f" from {spoken(interval.start)} to {spoken(interval.end)}"
    )


def suggestion(missing: Sequence[Quantity | str], history: History, asked: str = "") -> str:
    """What to add to the scene; never what is asked."""
    lonely = unreached(history)
    if lonely:
        return f"nothing tells when `{lonely}` is reached: give it a line, or an event that leads to it"
    unplaced = without_angle(history)
    if unplaced:
        return f"nothing tells where `{unplaced[0]}` is at `{unplaced[1]}`: give `{unplaced[0]}.angle`"
    quantities = [item for item in missing if isinstance(item, Quantity)]
    soft = {item.name for item in history.arrangement.problem.connections if getattr(item, "stiffness", ZERO) is None}
    spring = next((item.owner for item in quantities if item.kind == "force" and item.owner in soft), None)
    if spring is not None:
        return f"give the `stiffness` of `{spring}`, or its force"
    others = [item for item in quantities if item.key != asked and item.owner and not item.component]
    ranked = sorted(others, key=lambda item: (item.kind not in STATED, not at_start(item, history)))
    if ranked and ranked[0].kind in STATED:
        item = ranked[0]
        if at_start(item, history) and item.kind in RATES:
            return f"say how it starts, as in `states: {{{state_of(item.when, history)}: at rest}}`"
        line = f"{state_of(item.when, history)}: {{{item.owner}.{item.kind}: {STATED[item.kind]}}}"
        return f"say more about the state, as in `states: {{{line}}}`"
    if quantities and all(item.kind in FORCES for item in quantities):
        return "the laws can not tell these forces apart: leave out a support, or give one of them"
    return "say more: sizes and masses, where each body is at each state, how fast it moves"


def at_start(quantity: Quantity, history: History) -> bool:
    """Whether a quantity belongs to the first of several states."""
    states = history.arrangement.timeline.states
    return len(states) > 1 and quantity.when == states[0].name


def state_of(when: str, history: History) -> str:
    """The state at which a quantity can be said: its own, or the end of its phase; "now" where the scene has no states."""
    timeline = history.arrangement.timeline
    interval = timeline.interval(when)
    return (
        interval.end if interval is not None else when if when in timeline.order else timeline.states[0].name
    ) or "now"


def unreached(history: History) -> str:
    """A state after the first of which nothing is said and to which no event leads."""
    timeline = history.arrangement.timeline
    for interval in timeline.intervals:
        end = timeline.state(interval.end)
        if interval.event is None and not end.conditions and not end.balance:
            return end.name
    return ""


def without_angle(history: History) -> tuple[str, str] | None:
    """A body whose angle some state gives, and the first state, where no other one says it."""
    timeline = history.arrangement.timeline
    said = {
        (state.name, line.path.owner)
        for state in timeline.states
        for line in state.conditions
        if line.path and line.path.quantity == "angle"
    }
    first, after = timeline.states[0], timeline.after(timeline.states[0].name)
    said |= {(first.name, owner) for owner in on_unknown_profile(history.arrangement, first.name)}
    for _, owner in sorted(said):
        if (first.name, owner) not in said and first.name and (after is None or after.event is None):
            return owner, first.name
    return None


def on_unknown_profile(arrangement: Arrangement, state: str) -> set[str]:
    """Contacts whose body is on a track of which only heights are known, where no angle is to be told."""
    orbits = (arrangement.orbit(body.name, state) for body in arrangement.present(state))
    return {orbit.owner for orbit in orbits if orbit is not None and orbit.radius is None}


def contradicted(equation: Equation, history: History, fallback: Span | None = None) -> Unsolvable:
    """Which law or line the data break; over a phase, that its end is never reached."""
    problem, timeline = history.arrangement.problem, history.arrangement.timeline
    line = next((condition for stated, condition in history.stated if stated is equation), None)
    if line is not None:
        path = path_text(line.path) if line.path is not None else line.owner
        message = f"the data contradict each other: what `{equation.section}` says of `{path}` can not be"
        return unsolvable(problem, message, line.span or fallback, CHECK_DATA)
    broken = f"“{equation.label}” can not hold; {CHECK_DATA}"
    interval = timeline.interval(equation.section)
    if interval is None:
        state = next((state for state in timeline.states if state.name and state.name == equation.section), None)
        where = f" at `{state.name}`" if state is not None else ""
        span = state.span if state is not None and state.span is not None else fallback
        return unsolvable(problem, f"the data contradict each other{where}", span, broken)
    if interval.event is not None:
        message = f"the data contradict each other: `{interval.end}` can not follow from `{interval.start}` by `{interval.name}`"
    else:
        message = f"`{interval.end}` is never reached from `{interval.start}`"
    return unsolvable(problem, message, timeline.state(interval.end).span or fallback, broken)


def said_otherwise(arrangement: Arrangement, modes: Mapping[str, str]) -> Iterator[Unsolvable]:
    """Contacts that a state says to stick where friction is too weak for it, or to slip where it is strong enough."""
    problem = arrangement.problem
    numbered = {given.name for given in problem.givens if given.value is not None}
    for state in arrangement.timeline.states:
        contacts = {item.name: item for item in arrangement.connections(state.name) if isinstance(item, Touch)}
        for line in state.conditions if arrangement.phase_start(state.name) == state.name else ():
            contact = contacts.get(line.path.owner) if line.path is not None else None
            if contact is None or contact.grip().kind != "coefficient" or not known(contact.grip().static, numbered):
                continue
            slips = modes.get(f"{contact.name}@{state.name}", "sticks").startswith("slips")
            if line.word in ("sticks", "rolls") and slips:
                yield unsolvable(
                    problem, f"`{contact.name}` slips at `{state.name}`: friction is too weak to hold it", line.span
                )
            elif line.word == "slips" and not slips:
                yield unsolvable(
                    problem, f"`{contact.name}` does not slip at `{state.name}`: friction is strong enough", line.span
                )


def known(value: Formula | None, numbered: Collection[str]) -> bool:
    """Whether a value is there, with all its letters."""
    return value is not None and value.symbols() <= set(numbered)


def negative_inertia(problem: Problem) -> Iterator[Fault]:
    """Moments of inertia given about a point that are smaller than m d² alone."""
    values = {given.name: given.value for given in problem.givens if given.value is not None}
    for body in problem.bodies:
        if body.inertia is None or body.inertia_about is None or body.inertia.symbols() - set(values):
            continue
        sign = evaluate(body.inertia, values, digits=3).sign
        if sign is not None and sign < 0:
            message = f"the inertia of `{body.name}` about `{body.inertia_about}` is smaller than m d², its mass at its centre of mass"
            yield Fault(message, body.span, "", "limits")


def plural(number: int, noun: str) -> str:
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def with_missing_told(derivation: Derivation, problem: Problem) -> Derivation:
    """The derivation with a remark at each answer that has no number since the scene leaves a mass or a size out."""
    missing = {given.name: given for given in problem.givens if given.automatic and given.value is None}
    return replace(derivation, answers=tuple(told_missing(answer, missing, problem) for answer in derivation.answers))


def told_missing(answer: Answer, missing: Mapping[str, Given], problem: Problem) -> Answer:
    numbered = {given.name for given in problem.givens if given.value is not None}
    if (
        answer.formula is not None
        and answer.value is None
        and answer.formula.symbols() <= numbered
        and not answer.remark
    ):
        return replace(answer, remark=("no number: with these givens it is not defined",))
    names = [name for name in missing if answer.formula is not None and name in answer.formula.symbols()]
    if not names or answer.remark:
        return answer
    words: list[str | Formula] = ["no number: "]
    for name in names:
        words += [", " if name != names[0] else "", Symbol(name), f", the {meaning(missing[name], problem)},"]
    return replace(answer, remark=(*words, " is not given" if len(names) == 1 else " are not given"))


def meaning(given: Given, problem: Problem) -> str:
    """What an automatic letter stands for, and where it could be given: "mass of block in line 4"."""
    kind = next((word for word, dimension in DIMENSIONS.items() if dimension == given.dimension), "value")
    owner = given.name.partition("_")[2]
    body = next(
        (body for body in every_body(problem.bodies) if body.name == owner.rstrip("_") or body.name == owner), None
    )
    if body is None:
        return f"{kind} of {spoken(owner.rstrip('_'))}"
    line = f" in line {body.span.line}" if body.span is not None else ""
    size = "radius" if kind == "length" and given.name.startswith("R") else kind
    return f"{size} of {spoken(body.name)}{line}"


def every_body(bodies: Iterable[Body]) -> Iterator[Body]:
    """Bodies with the parts that they are made of."""
    for body in bodies:
        yield body
        yield from every_body(part.body for part in body.parts)
