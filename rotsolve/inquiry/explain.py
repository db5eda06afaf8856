"""Explain: why there is no answer, in the scene's words: what is missing or contradictory, where, and what may help."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.notation.letters import name_to_text
from rotsolve.core.derivation import Check, Words
from rotsolve.core.equation import NEWTON, Equation
from rotsolve.core.faults import Span, Unsolvable
from rotsolve.core.quantity import DIMENSIONS
from rotsolve.core.registry import SEPARATOR, Quantity
from rotsolve.inquiry.answering import NoAnswer, Session
from rotsolve.inquiry.compose import spoken
from rotsolve.inquiry.history import History
from rotsolve.inquiry.verify import SAID
from rotsolve.motion.instant import GENERIC, VIRTUAL
from rotsolve.scene.model import Body, Condition, Find, Problem

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
ENDS = ("displacement", "rotation", "time")  # quantities of a phase: something must tell when it is over
CHECK_DATA = "check the givens and what the states say"


def unsolvable(problem: Problem, message: str, span: Span | None = None, help: str = "") -> Unsolvable:
    """A message with its place in the file."""
    return Unsolvable(message, span=span, help=help, lines=problem.lines, file=problem.file)


def no_answer(error: NoAnswer, session: Session, find: Find) -> Unsolvable:
    """What is missing or contradictory for one question."""
    problem = session.history.arrangement.problem
    if error.equation is not None:
        return contradicted(session.planner.pool[error.equation], session.history, find.span)
    alone = "" if NEWTON in session.families else f" by {SAID[session.families[0]]} alone"
    missing = [] if error.shortage is None else open_quantities(error.shortage.unknowns, session.history)
    if not missing:
        reason = str(error) if error.open_form else "too little is known"
        return unsolvable(
            problem, f"`{find.name}` can not be found{alone}: {reason}", find.span, suggestion((), session.history)
        )
    assert error.shortage is not None
    laws = [index for index in error.shortage.equations if is_law(session.planner.pool[index])]
    counted = f"{plural(len(laws), 'equation')} for {plural(len(missing), 'unknown')}"
    counted = counted if len(laws) < len(missing) else "nothing settles"
    message = f"too little is known to find `{find.name}`{alone}: {counted}: {listed(missing, session.history)}"
    return unsolvable(problem, message, find.span, suggestion(missing, session.history))


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
    """Letters with what they stand for; of many only the first few."""
    keys = [item.key for item in missing if isinstance(item, Quantity)]
    letters = history.registry.letters(keys, frozenset(), {})
    told = [
        f"{name_to_text(letters[item.key])} ({told_quantity(item, history)})"
        if isinstance(item, Quantity)
        else f"`{item}`"
        for item in missing
    ]
    more = f" and {len(told) - MANY} more" if len(told) > MANY else ""
    return ", ".join(told[:MANY]) + more


def told_quantity(quantity: Quantity, history: History) -> str:
    """A quantity of the laws in the scene's words: "tension of cord at held"."""
    owner = f" of {spoken(quantity.owner)}" if quantity.owner else ""
    return f"{spoken(quantity.kind)}{owner}{moment(quantity.when, history)}"


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


def suggestion(missing: Sequence[Quantity | str], history: History) -> str:
    """What to add to the scene."""
    lonely = unreached(history)
    if lonely:
        return f"nothing tells when `{lonely}` is reached: give it a line, or an event that leads to it"
    quantities = [item for item in missing if isinstance(item, Quantity)]
    stated = next((item for kind in STATED for item in quantities if item.kind == kind and item.owner), None)
    if stated is not None:
        states = history.arrangement.timeline.order
        name = stated.when if stated.when in states and stated.when else next(iter(states)) or "now"
        name = (
            history.arrangement.timeline.interval(stated.when).end
            if history.arrangement.timeline.interval(stated.when)
            else name
        )  # type: ignore[union-attr]
        return f"say more about the state, as in `states: {{{name}: {{{stated.owner}.{stated.kind}: {STATED[stated.kind]}}}}}`"
    if quantities and all(item.kind in FORCES for item in quantities):
        return "the laws can not tell these forces apart: leave out a support, or give one of them"
    return "give one of them, or say more about the states" if missing else "say more about the states"


def unreached(history: History) -> str:
    """A state after the first of which nothing is said and to which no event leads."""
    timeline = history.arrangement.timeline
    for interval in timeline.intervals:
        end = timeline.state(interval.end)
        if interval.event is None and not end.conditions and not end.balance:
            return end.name
    return ""


def contradicted(equation: Equation, history: History, fallback: Span | None = None) -> Unsolvable:
    """Which law or line the data break; over a phase, that its end is never reached."""
    problem, timeline = history.arrangement.problem, history.arrangement.timeline
    line = next((condition for stated, condition in history.stated if stated is equation), None)
    if line is not None:
        message = f"the data contradict each other: what `{equation.section}` says of `{path_text(line)}` can not be"
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


def path_text(line: Condition) -> str:
    """What a line of a state speaks of, as it is written."""
    if line.path is None:
        return line.owner
    parts = (line.path.owner, line.path.point, line.path.quantity, line.path.component)
    return ".".join(part for part in parts if part)


def plural(number: int, noun: str) -> str:
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def without_number(session: Session) -> Iterator[Check]:
    """Which answers are left without a number since the scene leaves a mass or a size out."""
    problem = session.history.arrangement.problem
    for given in problem.givens:
        if not given.automatic or given.value is not None:
            continue
        names = [
            item.asked.find.name
            for item in session.answered
            if item.found.formula is not None and given.name in item.found.formula.symbols()
        ]
        if names:
            kind = next((word for word, dimension in DIMENSIONS.items() if dimension == given.dimension), "value")
            body = next(
                (body for body in every_body(problem.bodies) if given.name.rstrip("_").endswith("_" + body.name)), None
            )
            owner = f" of {spoken(body.name)}" if body is not None else ""
            line = f" (line {body.span.line})" if body is not None and body.span is not None else ""
            words: list[str | Formula] = [
                f"the {kind}{owner} is not given{line}: ",
                Symbol(given.name),
                " has no number, so neither has ",
            ]
            for name in names:
                words += [Symbol(name)] if name == names[0] else [", ", Symbol(name)]
            yield Check(tuple(words), None)


def every_body(bodies: Iterable[Body]) -> Iterator[Body]:
    """Bodies with the parts that they are made of."""
    for body in bodies:
        yield body
        yield from every_body(part.body for part in body.parts)


__all__ = ["Words", "contradicted", "no_answer", "unsolvable", "without_number"]
