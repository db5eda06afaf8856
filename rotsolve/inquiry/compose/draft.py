"""Drafts: which laws and steps belong in which section, and the sections in the order in which they are read."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, field

from rotsolve.core.writing import spoken
from rotsolve.inquiry.answering import Inquiry
from rotsolve.inquiry.answers import Answered, Chosen
from rotsolve.inquiry.history import History
from rotsolve.solver import Ref, Step


@dataclass
class Draft:
    """One section in the making: the laws (pool indices), steps and choices that belong to it."""

    key: str
    laws: list[int] = field(default_factory=list)
    steps: list[Step] = field(default_factory=list)
    choices: list[Chosen] = field(default_factory=list)


def drafts_of(inquiry: Inquiry) -> list[Draft]:
    """Laws and steps by section, the sections in the order in which they are read."""
    drafts: dict[str, Draft] = {}
    time = {key: place for place, key in enumerate(moments(inquiry.history))}
    homes = homes_of(inquiry, time)
    order = {key: place for place, key in enumerate(reading_order(inquiry, homes, time))}
    placed: set[int] = set()
    for answered in sorted(inquiry.answered, key=lambda item: order[homes[item.asked.letter]]):
        laws, key = laws_of(answered, inquiry), homes[answered.asked.letter]
        draft = drafts.setdefault(key, Draft(key))
        draft.laws.extend(
            index for index in sorted(laws, key=lambda index: law_order(index, inquiry)) if index not in placed
        )
        placed.update(laws)
        draft.steps.extend(inquiry.solver.steps[slice(*answered.steps)])
    for chosen in inquiry.chosen:
        letters = {side.asked.letter for side in chosen.sides} & set(homes) or set(homes)
        last = latest(letters, homes, order)
        drafts.setdefault(last, Draft(last)).choices.append(chosen)
    filled = [draft for draft in drafts.values() if draft.laws or draft.steps or draft.choices]
    return sorted(filled, key=lambda draft: order.get(draft.key, len(order)))


def reading_order(inquiry: Inquiry, homes: Mapping[str, str], time: Mapping[str, int]) -> list[str]:
    """Each section after those whose results it puts to use, else in the order of time; of two that need each other the earlier first."""
    told: dict[Ref, str] = {("known", letter): key for letter, key in homes.items()}
    needed: dict[str, set[str]] = {
        key: set() for key in sorted(homes.values(), key=lambda key: time.get(key, len(time)))
    }
    for answered in inquiry.answered:
        key = homes[answered.asked.letter]
        for step in inquiry.solver.steps[slice(*answered.steps)]:
            needed[key] |= {told[ref] for ref in (step.target, *step.sources) if ref in told}
            told |= {("step", step.number): key, ("known", step.result): key}
    result: list[str] = []
    while left := [key for key in needed if key not in result]:
        result.append(next((key for key in left if needed[key] <= {key, *result}), left[0]))
    return result


def homes_of(inquiry: Inquiry, order: Mapping[str, int]) -> dict[str, str]:
    """The sections of all answers: where their weightiest law is; of what is made of earlier answers, that of the last of them."""
    homes: dict[str, str] = {}
    for answered in inquiry.answered:
        made_of = answered.asked.formula.symbols() & set(homes)
        own = "" if made_of and not answered.asked.find.terms else home(answered, laws_of(answered, inquiry), inquiry)
        homes.setdefault(answered.asked.letter, own or latest(made_of, homes, order))
    return homes


def laws_of(answered: Answered, inquiry: Inquiry) -> list[int]:
    """The equations behind an answer that are printed as laws."""
    return [index for index in answered.used if is_law(index, inquiry)]


def latest(letters: Collection[str], homes: Mapping[str, str], order: Mapping[str, int]) -> str:
    """The last of the sections in which letters are found: where something made of them belongs."""
    return max((homes[letter] for letter in sorted(letters)), key=lambda key: order.get(key, -1), default="")


def is_law(index: int, inquiry: Inquiry) -> bool:
    """Whether an equation of the pool is printed as a law: not a result, nor a question that just names a quantity."""
    return inquiry.refs.get(index, ("law", index))[0] == "law"


def law_order(index: int, inquiry: Inquiry) -> tuple[int, int]:
    """Laws and what approximates them first, then definitions and rules, as they were written."""
    equation = inquiry.planner.pool[index]
    return (0 if equation.family or equation.relation != "=" else 1, index)


def home(answered: Answered, laws: list[int], inquiry: Inquiry) -> str:
    """The section of the weightiest law of a plan."""
    if not laws:
        return answered.asked.section
    pool = inquiry.planner.pool
    order = {key: place for place, key in enumerate(moments(inquiry.history))}
    return max((pool[index].cost, order.get(pool[index].section, -1), pool[index].section) for index in laws)[2]


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
