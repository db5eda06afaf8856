"""Drafts: which laws and steps belong in which section, the sections in the order in which they are read, and their free-body diagrams."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping, Sequence, Set

from msgspec import Struct, field

from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import ZERO, Formula, Sum, Symbol
from rotsolve.algebra.notation.text import unsigned
from rotsolve.core.derivation import ForceLine, Words
from rotsolve.core.equation import (
    ABOUT_CONTACT,
    ANGULAR_MOMENTUM,
    CONSERVATION,
    ENERGY,
    NEWTON,
    ROTATION,
    SECOND_LAW,
    Equation,
    Law,
)
from rotsolve.core.facts import BodyFacts, Couple, Facts, Force
from rotsolve.core.symbols import is_key
from rotsolve.core.vectors.heading import TURNS
from rotsolve.core.writing import spoken
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.motion.freebody import free_bodies
from rotsolve.search.answers import Answered, Chosen
from rotsolve.search.search import Search
from rotsolve.solver.steps import Ref, Step

LONGEST_TORQUE = 25  # nodes of a torque that stands in the line of its force


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
    for draft in drafts.values():
        in_order_of_time(draft, search)
    for chosen in search.chosen:
        letters = {side.asked.letter for side in chosen.sides} & set(homes) or set(homes)
        last = latest(letters, homes, order)
        drafts.setdefault(last, Draft(last)).choices.append(chosen)
    return [draft for draft in drafts.values() if draft.laws or draft.steps or draft.choices]


def in_order_of_time(draft: Draft, search: Search) -> None:
    """K₁ before K₂, whichever is found first: kinetic energies stand in the order in which they were written."""
    places = [place for place, index in enumerate(draft.laws) if search.planner.pool[index].law.kinetic]
    for place, index in zip(places, sorted(draft.laws[place] for place in places), strict=True):
        draft.laws[place] = index


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
    # neither a result, nor a question that just names a quantity
    return [index for index in answered.used if search.refs.get(index, ("law", index))[0] == "law"]


def latest(letters: Collection[str], homes: Mapping[str, str], order: Mapping[str, int]) -> str:
    """The last of the sections in which letters are found: where something made of them belongs."""
    return max((homes[letter] for letter in sorted(letters)), key=lambda key: order.get(key, -1), default="")


def law_order(index: int, search: Search) -> tuple[int, bool, int]:
    """Laws and what approximates them first, a derivative behind what it is of, then definitions and rules, as they were written."""
    equation = search.planner.pool[index]
    return (0 if equation.family or equation.relation != "=" else 1, equation.law.condenses, index)


def home(answered: Answered, laws: list[int], search: Search) -> str:
    """The section of the definition of what is asked, else of the weightiest law of a plan, of what is no mere rule first."""
    if not laws:
        return answered.asked.section
    pool = search.planner.pool
    own = [pool[index].section for index in laws if pool[index].defines == answered.asked.letter]
    if own:
        return own[0]
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


WITH_FORCES = (NEWTON, ENERGY, ANGULAR_MOMENTUM)


class Diagrams(Struct, frozen=True):
    """The free-body diagrams of all sections; `pool` holds the laws that the drafts of sections point to."""

    scene: SceneEquations
    pool: list[Equation]

    def givens(self, draft: Draft) -> Iterator[str]:
        """Givens in the forces that the diagrams of a section name, supports left out."""
        for body in self._drawn(draft):
            pushed = self._pushed(body, draft)
            for item in body.acting:
                if not item.role.unseen and not at_the_axis(item, body, pushed):
                    letters = (item.size if isinstance(item, Force) else item.torque).symbols()
                    yield from sorted(name for name in letters if not is_key(name))

    def lines(self, draft: Draft, in_use: Set[str], words: Callable[[Words], Words]) -> tuple[ForceLine, ...]:
        """One line for each body; `in_use` are the letters that an equation speaks of, `words` writes them as they are printed."""
        return tuple(self._line(body, draft, in_use, words) for body in self._drawn(draft))

    def _drawn(self, draft: Draft) -> Iterator[BodyFacts]:
        """The bodies of which the laws of a section speak, with what acts on them."""
        equations = [self.pool[index] for index in draft.laws]
        if self._ends_a_phase(draft.key) and not any(equation.family == NEWTON for equation in equations):
            return iter(())  # laws of the way to a state: what acts on it has been told
        balanced = [equation for equation in equations if equation.family in WITH_FORCES]
        if all(equation.law == CONSERVATION for equation in balanced):
            return iter(())  # the sentence why energy is conserved speaks of what acts
        names = {name for equation in balanced for name in equation.bodies}
        facts = self._facts(draft)
        return (body for body in (facts.diagrams if facts is not None else ()) if body.name in names)

    def _ends_a_phase(self, key: str) -> bool:
        """Whether a section is about the state at the end of a phase."""
        timeline = self.scene.configuration.timeline
        before = timeline.before(key) if key in timeline.order else None
        return before is not None and before.event is None

    def _facts(self, draft: Draft) -> Facts | None:
        """The facts that a section is about: of its state, of its phase, or of swings; none of an event.

        Where the section of a phase writes Newton's laws at one state alone, they are those of that state.
        """
        timeline, key = self.scene.configuration.timeline, draft.key
        for swing in self.scene.swings.values():
            if key in (swing.section, swing.balanced):
                return free_bodies(swing.near if key == swing.section else swing.rest)
        moments = {self.pool[index].section for index in draft.laws if self.pool[index].family == NEWTON}
        if len(moments) == 1 and moments <= set(timeline.order):
            key = moments.pop()
        interval = timeline.interval(key)
        if interval is not None:
            if interval.event is not None:
                return None
            return self.scene.facts(interval.start, generic=self.scene.varies(interval))
        return self.scene.facts(key) if key in timeline.order else None

    def _line(self, body: BodyFacts, draft: Draft, in_use: Set[str], words: Callable[[Words], Words]) -> ForceLine:
        """Forces, with their letters where equations speak of them, and in brackets those that have no say in them."""
        if not body.acting:
            return ForceLine(spoken(body.name), (("no force",),), body.positive)
        pushed = self._pushed(body, draft)
        spoken_of, silent = list[Words](), list[Force | Couple]()
        for item in body.acting:
            size = item.size if isinstance(item, Force) else item.torque
            if at_the_axis(item, body, pushed):
                silent.append(item)
                continue
            if size == ZERO:
                spoken_of.append((f"no {item.noun} at {spoken(item.owner)}",))  # which a state tells to be nothing
                continue
            letters = {letter for letter in size.symbols() if is_key(letter)}
            if letters <= in_use:
                spoken_of.append(words((*item.words, *self._turning(item, body, draft, in_use))))
            elif not item.role.unseen:
                spoken_of.append(nameless(item, told=not (item.role.rubs and letters)))
        if silent and not spoken_of:
            alone = f"{joined_names(nouns(silent))}: no torque about the {support_of(silent)}"
            return ForceLine(spoken(body.name), ((alone,),), body.positive)
        remarks = (*without_torque(silent), *self._through_the_centre(body, draft))
        return ForceLine(spoken(body.name), tuple(spoken_of), body.positive, remarks, self._turned(body, draft, words))

    def _turning(self, item: Force | Couple, body: BodyFacts, draft: Draft, in_use: Set[str]) -> Words:
        """The torque of a force on a body of which a section writes the law for rotation: ": torque M g (L/2) cos θ, clockwise"."""
        if isinstance(item, Couple) or not self._rotates(body, draft, (ROTATION,)):
            return ()
        torque = body.torque_of(item)
        size, keys = unsigned(torque), {name for name in torque.symbols() if is_key(name)}
        if torque == ZERO or not keys <= in_use or isinstance(torque, Sum) or length(torque) > LONGEST_TORQUE:
            return ()
        size, sense = (torque if size is None else size), TURNS[size is not None]
        told = sense in item.way or (not keys and self.scene.configuration.signs.by_numbers(size) == -1)
        return (": torque ", size, "" if told else f", {sense}")

    def alone(self, draft: Draft, laws: Sequence[Law] = (ROTATION, ABOUT_CONTACT)) -> Iterator[tuple[BodyFacts, Force]]:
        """The bodies of which a section writes a law for rotation and that one force alone turns about their centre, with that force."""
        for body in self._drawn(draft):
            rotates = self._rotates(body, draft, laws)
            turning = [item for item in body.acting if body.torque_of(item) != ZERO] if rotates else []
            if len(turning) == 1 < len(body.acting) and isinstance(turning[0], Force):
                yield body, turning[0]

    def _turned(self, body: BodyFacts, draft: Draft, words: Callable[[Words], Words]) -> tuple[str, Formula] | None:
        """The only force that turns a body, where it is an unknown of the laws."""
        force = next((force for own, force in self.alone(draft, (ROTATION,)) if own is body), None)
        if force is None or not isinstance(force.size, Symbol) or not is_key(force.size.name):
            return None
        (letter,) = words((force.size,))
        return (force.role.noun or force.noun, letter) if isinstance(letter, Formula) else None

    def _rotates(self, body: BodyFacts, draft: Draft, laws: Sequence[Law]) -> bool:
        """Whether a law of a section is one of those for rotation of a body."""
        used = (self.pool[index] for index in draft.laws)
        return any(law.law in laws and body.name in law.bodies for law in used)

    def _through_the_centre(self, body: BodyFacts, draft: Draft) -> tuple[Words, ...]:
        """Which forces have no torque about the centre of mass, about which a body turns that nothing holds."""
        if body.motion.kind == "axis" or not self._rotates(body, draft, (ROTATION,)):
            return ()
        acting = [force for force in body.forces if not force.role.unseen and force.size != ZERO]
        central = [force for force in acting if body.torque_of(force) == ZERO]
        if not central or len(central) == len(acting):
            return ()
        there = nouns([force for force in central if not force.arm.parts])
        past = nouns([force for force in central if force.arm.parts])
        told = [f"{joined_names(there)} {'act' if len(there) > 1 else 'acts'} at the centre of mass"] if there else []
        line, goes = ("lines", "pass") if len(past) > 1 else ("line", "passes")
        through = "it" if there else "the centre of mass"
        told += [f"the {line} of {joined_names(past)} {goes} through {through}"] if past else []
        return ((f"{' and '.join(told)}: no torque about it",),)

    def _pushed(self, body: BodyFacts, draft: Draft) -> bool:
        """Whether a law of a section is Newton's second for a body."""
        laws = (self.pool[index] for index in draft.laws)
        return any(law.law == SECOND_LAW and body.name in law.bodies for law in laws)


def at_the_axis(item: Force | Couple, body: BodyFacts, pushed: bool) -> bool:
    """Whether a force has no say in the laws: it acts at the axis of a body, whose second law nobody writes."""
    return isinstance(item, Force) and body.motion.kind == "axis" and not pushed and not item.arm.parts


def nameless(item: Force | Couple, *, told: bool) -> Words:
    """The words of a force whose letter no equation has: "normal force, up"; of friction that holds nothing tells which way it acts."""
    return (f"{item.noun}{' ' if item.place else ''}{item.place}{f', {item.way}' if item.way and told else ''}",)


def without_torque(silent: list[Force | Couple]) -> tuple[Words, ...]:
    """Which forces on a body on an axis act at that axis."""
    if not silent:
        return ()
    names = nouns(silent)
    verb = "act" if len(names) > 1 else "acts"
    return ((f"{joined_names(names)} {verb} at the {support_of(silent)}: no torque about it",),)


def joined_names(names: list[str]) -> str:
    """Weight, axle force and press of the rope."""
    return " and ".join(filter(None, (", ".join(names[:-1]), names[-1])))


def nouns(silent: Sequence[Force | Couple]) -> list[str]:
    """What some forces are called, each noun once."""
    return list(dict.fromkeys(item.role.noun or item.noun for item in silent))


def support_of(silent: list[Force | Couple]) -> str:
    return "axle" if any(item.role.axle for item in silent) else "pivot"
