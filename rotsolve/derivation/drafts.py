"""Drafts: which laws and steps belong in which section, and the sections in the order in which they are read."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence

from msgspec import Struct, field

from rotsolve.core.writing import spoken
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.search.answers import Answered, Chosen
from rotsolve.search.search import Search
from rotsolve.solver.steps import Ref, Step


class Draft(Struct):
    """One section in the making: the laws (pool indices), steps and choices that belong to it."""

    key: str
    laws: list[int] = field(default_factory=list)
    steps: list[Step] = field(default_factory=list)
    choices: list[Chosen] = field(default_factory=list)


def drafts_of(search: Search) -> list[Draft]:
    """Laws and steps by section, the sections in the order of time as far as none uses what a later one finds."""
    order = {key: place for place, key in enumerate(moments(search.scene))}
    needs = needs_of(search)
    homes = homes_of(search, order, needs)
    drafts: dict[str, Draft] = {}
    placed: set[int] = set()
    for key, numbers in sections_in_order(search, homes, order, needs):
        draft = drafts.setdefault(key, Draft(key))
        for answered in (search.answered[number] for number in numbers):
            homes[answered.asked.letter] = key
            laws = sorted(laws_of(answered, search), key=lambda index: law_order(index, search))
            draft.laws.extend(index for index in laws if index not in placed)
            placed.update(laws)
            draft.steps.extend(search.solver.steps[slice(*answered.steps)])
    for chosen in search.chosen:
        letters = {side.asked.letter for side in chosen.sides} & set(homes) or set(homes)
        last = latest(letters, homes, order)
        drafts.setdefault(last, Draft(last)).choices.append(chosen)
    return [draft for draft in drafts.values() if draft.laws or draft.steps or draft.choices]


def sections_in_order(
    search: Search, homes: Mapping[str, str], order: Mapping[str, int], needs: Sequence[set[int]]
) -> Iterator[tuple[str, list[int]]]:
    """Sections with the numbers of their answers: the first in time next, of those that need nothing from the ones to come.

    Where each needs another, what stands in the way waits for the section from which it needs something.
    """
    place = {key: order.get(key, len(order)) for key in homes.values()}
    waiting: dict[str, list[int]] = {key: [] for key in sorted(place, key=place.__getitem__)}
    for number, answered in enumerate(search.answered):
        waiting[homes[answered.asked.letter]].append(number)
    done: set[int] = set()
    while waiting:
        ready = [key for key, own in waiting.items() if settled_by(own, done, needs) == own]
        key = ready[0] if ready else next(iter(waiting))
        own = settled_by(waiting[key], done, needs)
        for number in waiting.pop(key):
            if number not in own:
                later = [other for other, held in waiting.items() if needs[number] & set(held)]
                waiting[later[-1] if later else next(iter(waiting))].append(number)
        waiting = {other: sorted(held) for other, held in waiting.items()}
        done.update(own)
        yield key, own


def settled_by(numbers: Sequence[int], done: Collection[int], needs: Sequence[set[int]]) -> list[int]:
    """Those of some answers that need only what is done, or each other."""
    found: list[int] = []
    for number in numbers:
        if needs[number] <= {*done, *found}:
            found.append(number)
    return found


def needs_of(search: Search) -> list[set[int]]:
    """Which answers each answer uses, by number: an answer uses earlier ones only."""
    owner: dict[Ref, int] = {}
    needs: list[set[int]] = []
    for number, answered in enumerate(search.answered):
        steps = search.solver.steps[slice(*answered.steps)]
        used = {ref for step in steps for ref in (step.target, *step.sources)}
        used |= {search.refs[index] for index in answered.used if index in search.refs}
        needs.append({owner[ref] for ref in used if ref in owner})
        owner |= {("step", step.number): number for step in steps}
        found = number if steps or not needs[number] else max(needs[number])
        owner.setdefault(("known", answered.asked.letter), found)
    return needs


def homes_of(search: Search, order: Mapping[str, int], needs: Sequence[set[int]]) -> dict[str, str]:
    """The sections of all answers: where their weightiest law is, or where the last answer is that they are made of."""
    homes: dict[str, str] = {}
    for answered, needed in zip(search.answered, needs, strict=True):
        laws = laws_of(answered, search)
        made_of = answered.asked.formula.symbols() & set(homes)
        own = "" if made_of and not answered.asked.find.terms else home(answered, laws, search)
        if not laws and needed and answered.steps[0] < answered.steps[1]:
            own = latest({search.answered[number].asked.letter for number in needed}, homes, order)
        parts = latest(made_of, homes, order)
        homes.setdefault(answered.asked.letter, parts if order.get(own, -1) < order.get(parts, -1) else own or parts)
    return homes


def laws_of(answered: Answered, search: Search) -> list[int]:
    """The equations behind an answer that are printed as laws."""
    return [index for index in answered.used if is_printed_law(index, search)]


def latest(letters: Collection[str], homes: Mapping[str, str], order: Mapping[str, int]) -> str:
    """The last of the sections in which letters are found: where something made of them belongs."""
    return max((homes[letter] for letter in sorted(letters)), key=lambda key: order.get(key, -1), default="")


def is_printed_law(index: int, search: Search) -> bool:
    """Whether an equation of the pool is printed as a law: not a result, nor a question that just names a quantity."""
    return search.refs.get(index, ("law", index))[0] == "law"


def law_order(index: int, search: Search) -> tuple[int, bool, int]:
    """Laws and what approximates them first, a derivative behind what it is of, then definitions and rules, as they were written."""
    equation = search.planner.pool[index]
    return (0 if equation.family or equation.relation != "=" else 1, equation.law.condenses, index)


def home(answered: Answered, laws: list[int], search: Search) -> str:
    """The section of the weightiest law of a plan, of what is no mere rule first."""
    if not laws:
        return answered.asked.section
    pool = search.planner.pool
    order = {key: place for place, key in enumerate(moments(search.scene))}
    weights = ((pool[index].cost, bool(pool[index].family), pool[index].section) for index in laws)
    return max(weights, key=lambda weight: (*weight[:2], order.get(weight[2], -1), weight[2]))[2]


def moments(scene: SceneEquations) -> list[str]:
    """All states, phases and events in the order of time."""
    timeline = scene.configuration.timeline
    result = [timeline.states[0].name]
    for interval in timeline.intervals:
        result += [interval.name, interval.end]
    for swing in scene.swings.values():
        result += [swing.balanced] * swing.found + [swing.section, swing.harmonic]
    return list(dict.fromkeys(result))


def title(key: str, scene: SceneEquations) -> str:
    """Heading of a section."""
    timeline = scene.configuration.timeline
    interval = timeline.interval(key)
    swings = scene.swings.values()
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
