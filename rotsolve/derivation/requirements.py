"""Requirements: whether strings stay taut, contacts touch and friction suffices at the answers; for which numbers closed forms hold."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING

from msgspec import Struct

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.ball import need as noted
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.certified.sign import ACUTE, SignOracle
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import PI, ZERO, Formula, Symbol, negate
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.derivation import Check, Words
from rotsolve.core.equation import NEWTON
from rotsolve.core.faults import UNSOLVED
from rotsolve.core.quantity import OSCILLATING
from rotsolve.core.symbols import CONSTANT, has_quantities, is_key, of_kinds
from rotsolve.core.writing import spoken
from rotsolve.motion.freebody import free_bodies
from rotsolve.motion.rubs import rubs
from rotsolve.search.answers import unsolvable
from rotsolve.search.planning import families_for
from rotsolve.search.within import seeks

if TYPE_CHECKING:
    from rotsolve.core.facts import Requirement
    from rotsolve.core.faults import Unsolvable
    from rotsolve.core.passage import Passage
    from rotsolve.derivation.letters import Letters
    from rotsolve.language.problem import State, TimeValue
    from rotsolve.motion.configuration import Configuration
    from rotsolve.search.search import Search

Settling = Callable[[Formula], Formula | None]  # puts in what is known for the letters of the laws


def requirements(search: Search, letters: Letters, moment: TimeValue | None = None) -> Iterator[Check]:
    """Strings pull, surfaces push, friction stays below its limit: at every state that the derivation speaks of, up to the `moment` at
    which functions of time are evaluated."""
    from rotsolve.derivation.shared_friction import shares_told

    told: set[tuple[str, str, str, Formula]] = set()
    spoken_of: list[str | Formula] = []
    for place, needs in requirements_by_state(search, moment):
        for need in needs:
            event = place in search.scene.encounters
            at = place if event or need.kind.placed else search.scene.section(place)
            # each part of a string has a tension of its own
            key = (need.owner, need.otherwise, at, need.left - need.right)
            stands = need.kind.grips and not event and search.scene.instant(place).in_balance  # all the rest by it
            if key in told or not (
                stands or concerns(need.owner, search) or (event and asked_after(need, place, search))
            ):
                continue
            for sought in values_sought(search):
                for holds, words in met_or_not(need, place, search, letters, sought):
                    told.add(key)
                    if words and holds and (words[-1] in spoken_of or len(spoken_of) == 3):
                        continue
                    spoken_of += words[-1:] if holds else ()
                    yield from [Check(words, holds)] if words else []
        yield from shares_told(place, needs, search, letters)
    yield from (Check(words, None) for owner, words in left_open(search, letters, moment) if concerns(owner, search))
    if search.scene.encounters:
        from rotsolve.derivation.parted import untold_barriers, untold_meetings

        yield from (Check((words,), None) for words in (*untold_meetings(search), *untold_barriers(search)))


def left_open(search: Search, letters: Letters, moment: TimeValue | None) -> Iterator[tuple[str, Words]]:
    """By its element what is not told of the way between two states, and when functions of time of no moment cease to hold."""
    if search.signs.trials and any(pushes_vary(passage) for passage in search.scene.passages.values()):
        from rotsolve.derivation.on_the_way import untold_pushes

        yield from untold_pushes(search)
    if search.signs.trials and any(surface.curved for surface in search.scene.configuration.surfaces.values()):
        from rotsolve.search.tops import untold_tops

        yield from untold_tops(search)
    if moment is None and search.scene.configuration.mentions.functions:
        from rotsolve.derivation.lasting import endings_told

        yield from endings_told(search, letters)


def met_or_not(
    need: Requirement, place: str, search: Search, letters: Letters, sought: Mapping[str, Formula]
) -> Iterator[tuple[bool | None, Words]]:
    """What is said of a requirement at a state or in an event; nothing where the laws do not tell its margin."""
    event = place in search.scene.encounters
    settled, gap = margin_of(need, search, families_for(NEWTON), sought)
    sign = sign_of(gap, need, place, search, letters)
    if sign is None:
        if need.kind.grips and not event and grips_by_what_nothing_tells(need, search):
            yield None, (f"whether {spoken(need.owner)} slips: nothing tells how hard it is pressed",)
    elif sign > 0:
        yield True, holding_words(need, search, letters, settled)
    elif sign < 0:
        yield False, objection(need, place, search, letters)
    elif not event and not need.kind.closed and not demanded(need, place, search):
        yield None, verge_words(need, place, search, letters)
    else:
        yield True, ()


def grips_by_what_nothing_tells(need: Requirement, search: Search) -> bool:
    """Whether friction is needed that is told, while what presses is not: a contact beside what carries its body as well."""
    aside = search.apart()
    most, needed = aside.settled(need.left), aside.settled(need.right)
    return needed is not None and most is None and search.signs.sign(needed) != 0


def sign_of(gap: Formula | None, need: Requirement, place: str, search: Search, letters: Letters) -> int | None:
    """Whether a requirement is met, by its margin; of letters in the case that is looked at, whose answers need it."""
    if gap is None:
        number = search.apart().certified(need.left - need.right)
        return None if number is None else number.sign
    sign = search.signs.sign(gap)
    number = search.signs.at_trial(gap) if sign is None else None
    if number is not None:
        sign = number.sign or 0
        # what is about places or speeds, and friction at rest, may only just hold: the condition is that −gap is not positive
        value, side = (negate(gap), -sign) if need.kind.placed or need.kind.grips else (gap, sign)
        noted(value, side, objection(need, place, search, letters))
    return sign


def just_drawn(state: State, search: Search) -> bool:
    """Whether bodies stand at a state as they are drawn and nothing is asked of that, since all that is asked is of swings."""
    terms = [term for answered in search.answered for term in answered.asked.find.terms]
    return not state.name and all(term.path.quantity in OSCILLATING for term in terms)


def margin_of(
    need: Requirement, search: Search, laws: tuple[str, ...], sought: Mapping[str, Formula]
) -> tuple[Settling, Formula | None]:
    """What tells the letters of a requirement, and by how much it is met: what was found on the way, else some laws, else all."""
    gap = need.left - need.right

    def told(value: Formula) -> Formula:
        return search.solver.with_found(value).substitute(sought)

    found = told(gap)
    if not has_quantities(found):
        return told, found
    for other in (search.beside_by(laws), search.apart()):
        settled = other.settled(gap)
        if settled is not None:
            break
    return other.settled, None if settled is None else told(settled)


def values_sought(search: Search) -> Iterator[dict[str, Formula]]:
    """What the answers make of letters that stand for any value in the laws, and for one in the question that seeks it: `x where N = P`;
    once for each of several questions that seek one letter."""
    for symbols in seeks(search):
        found = {letter: search.solver.solved.get(symbol) for letter, symbol in symbols.items() if symbol != letter}
        yield {name: item.formula for name, item in found.items() if item is not None and item.formula is not None}


def requirements_by_state(
    search: Search, moment: TimeValue | None = None
) -> Iterator[tuple[str, tuple[Requirement, ...]]]:
    """What strings and contacts have to obey, state by state, and in the equilibria that were worked out."""
    scene = search.scene
    for state in scene.configuration.timeline.states:
        yield state.name, tuple(needed_at(state, search))
    for name, encounter in scene.encounters.items():
        yield name, encounter.requirements
    for swing in scene.swings.values():
        if swing.found:
            yield swing.near.state, free_bodies(swing.rest).requirements
    if any(swing.start for swing in scene.swings.values()):
        from rotsolve.derivation.swung import far_ends

        yield from far_ends(search)
    if any(encounter.closings for encounter in scene.encounters.values()):
        from rotsolve.derivation.parted import kept_in_front, partings

        yield from partings(search)
        yield from kept_in_front(search)
    if any(scene.configuration.left.values()):
        from rotsolve.derivation.parted import liftings

        yield from liftings(search)
    if any(state.opened for state in scene.configuration.timeline.states):
        from rotsolve.derivation.parted import within_hollows

        yield from within_hollows(search)
    if any(pushes_vary(passage) for passage in scene.passages.values()):
        from rotsolve.derivation.on_the_way import least_pushes

        yield from least_pushes(search)
    if search.scene.configuration.mentions.functions:
        from rotsolve.derivation.lasting import lasting

        yield from lasting(search, moment)


def needed_at(state: State, search: Search) -> Iterator[Requirement]:
    """What has to be at a state: of friction where it lasts, of how bodies stand where that is told or asked."""
    fleeting, drawn = passing(state.name, search), just_drawn(state, search)
    for need in search.scene.facts(state.name).requirements:
        if not ((need.kind.grips and fleeting) or (need.kind.stands and drawn)) or said_to_hold(need, state):
            yield need


def pushes_vary(passage: Passage) -> bool:
    """Whether forces that may let go vary in a phase, with the time, a place or a speed."""
    varies = any(travel.pace != CONSTANT for travel in passage.travels)
    return varies and any(not need.kind.placed for need in passage.midst.requirements)


def said_to_hold(need: Requirement, state: State) -> bool:
    """Whether a state says itself that friction holds there: in balance, or by a word about the contact or clutch."""
    lines = [line for line in state.conditions if line.path is not None and line.path.owner == need.owner]
    return state.balance or any(line.word in ("sticks", "rolls") for line in lines)


def passing(state: str, search: Search) -> bool:
    """Whether a blow ends a state as soon as it is: what would not hold for long does not matter, where nothing is asked of it."""
    timeline = search.scene.configuration.timeline
    before, after = timeline.before(state), timeline.after(state)
    if after is None or after.event is None or (before is not None and before.event is None):
        return False
    terms = [term for answered in search.answered for term in answered.asked.find.terms]
    return not any(term.at == state or (term.at is None and term.start is None) for term in terms)


def let_go(search: Search) -> Iterator[Unsolvable]:
    """A surface that would have to pull in an event, or a string to push: it lets go, and what comes then is another scene; what would be
    pressed into what it lies on is held up by that."""
    configuration = search.scene.configuration
    if any(configuration.left.values()):
        from rotsolve.derivation.parted import liftings

        for state, needs in liftings(search):
            for need in needs:
                if negative_margin(need.left - need.right, search):
                    message = f"{need.otherwise} `{state}`, by `{need.owner}`: not solved yet"
                    span = configuration.timeline.state(state).span
                    yield unsolvable(configuration.problem, message, span, kind=UNSOLVED)
    for name, encounter in search.scene.encounters.items():
        for need in encounter.requirements:
            met = concerns(need.owner, search) or asked_after(need, name, search)
            if met and negative_margin(need.left - need.right, search, strict=need.kind.strict):
                interval = configuration.timeline.interval(name)
                span = configuration.timeline.state(interval.end).span if interval is not None else None
                if need.kind.placed and not need.kind.strict:  # there is no such blow
                    yield unsolvable(configuration.problem, f"{need.otherwise} `{name}`", span)
                else:
                    message = f"in `{name}` {need.otherwise}: what `{need.owner}` does then is not solved yet"
                    yield unsolvable(configuration.problem, message, span, kind=UNSOLVED)


def negative_margin(gap: Formula, search: Search, *, strict: bool = False) -> bool:
    """Whether a margin is negative, or nothing where it is `strict`: by the numbers of the scene or for all sizes of its letters, else in
    the case looked at."""
    refused = (-1, 0) if strict else (-1,)
    number = search.apart().certified(gap)
    if number is not None:
        return number.sign in refused
    settled = search.apart().settled(gap)
    return settled is not None and search.signs.taken(settled) in refused


def concerns(owner: str, search: Search) -> bool:
    """Whether the body that a requirement of an element is about takes part in the derivation, by itself or as one with another."""
    used, configuration = bodies_used(search), search.scene.configuration
    item = next((item for item in configuration.problem.connections if item.name == owner), None)
    return item is None or any(not used.isdisjoint(standing_for(ref.owner, configuration)) for ref in item.touches())


def standing_for(name: str, configuration: Configuration) -> set[str]:
    """A body, and those that stand for it at some state."""
    return {name, *(configuration.host(name, state.name) for state in configuration.timeline.states)}


def bodies_used(search: Search) -> set[str]:
    """The bodies of which the laws speak that lead to the answers."""
    laws = [search.planner.pool[index] for answered in search.answered for index in answered.used]
    return {name for law in laws for name in law.bodies}


def asked_after(need: Requirement, event: str, search: Search) -> bool:
    """Whether a question is about a time after an event, and about the scene, an element or a body that takes part in it with what is
    required; or about a letter, which what the states after it tell is to settle."""
    timeline = search.scene.configuration.timeline
    interval = timeline.interval(event)
    first = timeline.order[interval.end] if interval is not None else 0
    terms = [term for answered in search.answered for term in answered.asked.find.terms]
    owners = {term.path.owner for term in terms if timeline.order.get(term.at or term.end or "", -1) >= first}
    later = owners.union(*(standing_for(name, search.scene.configuration) for name in owners))
    taking_part = {meeting.body.name for meeting in search.scene.encounters[event].meetings}
    return bool(search.scene.configuration.problem.sought) or not later.isdisjoint({"", need.owner, *taking_part})


def objection(need: Requirement, state: str, search: Search, letters: Letters) -> Words:
    """A requirement that fails, in words: "T > 0 for cord at end: the string goes slack"."""
    names = symbols_in(need, search, letters)
    left, right = (side.substitute(names) for side in (need.left, need.right))
    moment = f" at {spoken(state)}" if state else ""
    if need.kind.placed:
        return (f"{need.otherwise}{moment}" if need.kind.stands else f"{need.otherwise} {spoken(state)}",)
    relation: Words = (right, " ≤ ", left) if need.kind.grips else (left, " > 0")
    return (*relation, f" for {spoken(need.owner)}{moment}: {need.otherwise}")


def demanded(need: Requirement, state: str, search: Search) -> bool:
    """Whether the scene itself asks for the verge: `touch: leaves` at that state, `x where touch.normal_force = 0`; of what sticks or rolls
    that of its friction."""
    configuration = search.scene.configuration
    lines = [line for line in configuration.timeline.state(state).conditions if line.word]
    lines += [find.where for find in configuration.problem.finds if find.where is not None]
    lines = [line for line in lines if need.kind.grips or line.word not in ("sticks", "rolls")]
    paths = [line.path for line in lines]
    paths += [term.path for line in lines if line.phrase is not None for term in line.phrase.terms]
    return need.left - need.right == ZERO or any(path is not None and path.owner == need.owner for path in paths)


def verge_words(need: Requirement, state: str, search: Search, letters: Letters) -> Words:
    """A requirement that only just holds: "N = 0 for touch at top: the least change decides whether ball leaves the loop"."""
    names = symbols_in(need, search, letters)
    left, right = (side.substitute(names) for side in (need.left, need.right))
    moment = f" at {spoken(state)}" if state else ""
    happens = f"{spoken(need.owner)} {need.otherwise}" if need.kind.grips else need.otherwise
    return (left, " = ", right, f" for {spoken(need.owner)}{moment}: the least change decides whether {happens}")


def symbols_in(need: Requirement, search: Search, letters: Letters) -> dict[str, Formula]:
    """Printed letters of what a requirement is about, the plain textbook letter where the derivation has none, with the name of its owner
    where the scene has that letter for something else."""
    names = [name for name in (need.left - need.right).symbols() if is_key(name)]
    asked = [(name, search.scene.registry.quantities[name]) for name in names]
    plain = {
        name: Symbol(one.letter if one.letter not in search.givens else f"{one.letter}_{one.owner}")
        for name, one in asked
    }
    return {**plain, **letters.symbols}


def holding_words(need: Requirement, search: Search, letters: Letters, settled: Settling) -> Words:
    """A requirement that holds, in words: "T > 0: the string stays taut"; without a letter that the derivation does not have."""
    if need.kind.grips:
        sides = [settled(side) for side in (need.right, need.left)]
        stays = f"{spoken(need.owner)} {need.kept}"
        if any(side is None or search.signs.lacking(side) for side in sides):
            return (f"friction suffices: {stays}",)
        size, limit_ = (decimal(side, search) for side in sides)
        if of_kinds(need.right.symbols(), ("impulse",)):
            return (f"impulse of friction needed {size} N s ≤ μ Jₙ = {limit_} N s: {stays}",)
        if of_kinds(need.right.symbols(), ("torque",)):
            return (f"friction torque needed {size} N m ≤ {limit_} N m: {stays}",)
        return (f"friction needed {size} N ≤ μₛ N = {limit_} N: {stays}",)
    names = {name for name in need.left.symbols() if is_key(name)}
    if need.kind.placed:
        return (need.kept,) if need.kept else ()
    return (letters.printed(need.left), " > 0: ", need.kept) if names <= set(letters.names) else (need.kept,)


def decimal(value: Formula | None, search: Search) -> str:
    if value is None:
        return "?"
    try:
        return evaluate(value, search.values).text(4)
    except (Undefined, ValueError):
        return "?"


SLIPS, ROOT = "what slips and which way", "which root of an equation is meant"


class Validity(Struct, frozen=True):
    """For which numbers the closed forms hold: where `positive` letters are so and none of the others is negative.

    `bounds` are what strings, contacts and friction have to obey, `sides` the signs that the scene's own numbers decided, and `limits` what
    the scene's keys ask of a letter. Numbers that would decide differently what else was `decided` are another case.
    """

    positive: frozenset[str]
    bounds: tuple[Formula, ...]
    decided: tuple[str, ...]
    sides: tuple[Formula, ...] = ()
    limits: tuple[Formula, ...] = ()


def validity(search: Search) -> Validity:
    """What strings, contacts and friction have to obey, as formulas of the givens; what else the numbers of the scene decided."""
    positive = search.solver.positive
    by_letters = SignOracle({}, positive)
    bounds: dict[Formula, None] = {}
    sides: dict[Formula, None] = {}
    decided: dict[str, None] = {}
    for _, needs in requirements_by_state(search):
        for need in needs:
            if concerns(need.owner, search):
                for sought in values_sought(search):
                    gap = margin_of(need, search, families_for(None), sought)[1]
                    if gap is None:
                        decided[f"whether {spoken(need.owner)} holds"] = None
                    elif by_letters.by_letters(gap) not in (0, 1):
                        bounds[gap] = None
    if rubs(search.scene.configuration):
        decided[SLIPS] = None
    if any(step.reason for step in search.solver.steps):
        decided[ROOT] = None
    for value, sign in (search.scene.configuration.signs.decided | search.signs.decided).items():
        if by_letters.by_letters(value) is not None:
            continue
        if sign:
            sides[simplify(value * sign, positive=positive)] = None
        else:
            decided[f"that {to_text(value)} vanishes"] = None
    acute = [Symbol(name) for name, limits in search.signs.limits().items() if limits == ACUTE]
    limits = [limit for angle in acute for limit in (angle, PI / 2 - angle)]
    return Validity(positive, tuple(bounds), tuple(decided), tuple(sides), tuple(limits))
