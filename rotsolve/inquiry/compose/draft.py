"""Drafts: which laws and steps belong in which section, and the sections in the order of time."""

from __future__ import annotations

from dataclasses import dataclass, field

from rotsolve.core.writing import spoken
from rotsolve.inquiry.answering import Answered, Inquiry
from rotsolve.inquiry.history import History
from rotsolve.solver import Step


@dataclass
class Draft:
    """One section in the making: the laws (pool indices) and steps that belong to it."""

    key: str
    laws: list[int] = field(default_factory=list)
    steps: list[Step] = field(default_factory=list)


def drafts_of(inquiry: Inquiry) -> list[Draft]:
    """Laws and steps by section, the sections in the order of time."""
    drafts: dict[str, Draft] = {}
    placed: set[int] = set()
    order = {key: place for place, key in enumerate(moments(inquiry.history))}
    homes: list[tuple[str, Answered]] = []
    for answered in inquiry.answered:
        homes.append((home(answered, laws_of(answered, inquiry), inquiry), answered))
    for key, answered in sorted(homes, key=lambda item: order.get(item[0], len(order))):
        laws = laws_of(answered, inquiry)
        draft = drafts.setdefault(key, Draft(key))
        draft.laws.extend(
            index for index in sorted(laws, key=lambda index: law_order(index, inquiry)) if index not in placed
        )
        placed.update(laws)
        draft.steps.extend(inquiry.solver.steps[slice(*answered.steps)])
    return [
        draft
        for draft in sorted(drafts.values(), key=lambda d: order.get(d.key, len(order)))
        if draft.laws or draft.steps
    ]


def laws_of(answered: Answered, inquiry: Inquiry) -> list[int]:
    """The equations behind an answer that are printed as laws."""
    return [index for index in answered.used if is_law(index, inquiry)]


def is_law(index: int, inquiry: Inquiry) -> bool:
    """Whether an equation of the pool is printed as a law: not a result, nor a question that just names a quantity."""
    return inquiry.refs.get(index, ("law", index))[0] == "law"


def law_order(index: int, inquiry: Inquiry) -> tuple[int, int]:
    """Laws and what approximates them first, then definitions and rules, as they were written."""
    equation = inquiry.planner.pool[index]
    return (0 if equation.family or equation.relation != "=" else 1, index)


def home(answered: Answered, laws: list[int], inquiry: Inquiry) -> str:
    """The section of the weightiest law of a plan; of what is made of earlier answers, that of the last of them."""
    places = {key: place for place, key in enumerate(moments(inquiry.history))}
    made_of = [
        other
        for other in inquiry.answered
        if other is not answered and other.asked.letter in answered.asked.formula.symbols()
    ]
    if made_of and not answered.asked.find.terms:
        homes = [home(other, laws_of(other, inquiry), inquiry) for other in made_of]
        return max(homes, key=lambda key: places.get(key, -1))
    if not laws:
        return answered.asked.section
    pool = inquiry.planner.pool
    return max((pool[index].cost, places.get(pool[index].section, -1), pool[index].section) for index in laws)[2]


def moments(history: History) -> list[str]:
    """All states, phases and events in the order of time."""
    timeline = history.arrangement.timeline
    result = [timeline.states[0].name]
    for interval in timeline.intervals:
        result += [interval.name, interval.end]
    for swing in history.swings.values():
        result += [swing.balanced] * swing.found + [swing.section, swing.harmonic]
    return list(dict.fromkeys(result))


def title(key: str, history: History) -> str:
    """Heading of a section."""
    timeline = history.arrangement.timeline
    interval = timeline.interval(key)
    swings = history.swings.values()
    for swing in swings:
        if swing.title(key):
            several = len({other.body for other in swings}) > 1
            return swing.title(key) + (f", {spoken(swing.body)}" if several else "")
    if interval is None:
        return f"At {spoken(key)}" if key else ""
    if interval.event is not None:
        word = getattr(interval.event, "word", "")
        return f"Event {spoken(interval.name)}" + (f" ({word})" if word else "")
    return f"From {spoken(interval.start)} to {spoken(interval.end)}"
