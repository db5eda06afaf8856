"""Friction: whether each contact sticks or slips, whether each rubbing wheel turns, and which way, phase by phase."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from typing import Protocol

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.certified.ball import Witness, pass_on, witnessed_apart
from rotsolve.algebra.formula import ZERO, Formula, call
from rotsolve.core.derivation import Trial, Words
from rotsolve.core.equation import NEWTON
from rotsolve.core.facts import signed
from rotsolve.core.faults import UNSOLVED, Unsolvable
from rotsolve.core.letters import letters_of
from rotsolve.core.symbols import POSITION, has_quantities, rub_key, rub_of
from rotsolve.core.writing import spoken
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.elements import Connection
from rotsolve.language.limited import limits_of
from rotsolve.language.problem import Problem
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.hereafter import with_hereafter
from rotsolve.motion.rubs import AT_MOST, BACK, FORWARD, STICKS, Rub, against_most, rough_blows, rubs, rubs_at
from rotsolve.plan import PATIENCE
from rotsolve.search.answers import Answered, unsolvable
from rotsolve.search.gripping import greatest_friction, own_needs, smooth, sticking
from rotsolve.search.openings import tell_ends
from rotsolve.search.planning import families_for
from rotsolve.search.search import Search
from rotsolve.search.tied import Tied, Unit, ways_of

TRIALS = 27  # ways in which contacts may stick and slip that are tried
ROUNDS = 3  # in which the senses are found in which an event leaves several slipping


class Slippery(Protocol):
    """What may stick or slip: a contact, or a blow on a surface."""

    def lying(self) -> str: ...
    def static(self) -> Formula | None: ...


class SlippingContact(Struct, frozen=True):
    """A contact that can not stick, or what strikes a surface and can not: the search that supposes it does, with friction and normal force
    worked out, or their impulses."""

    contact: Slippery
    search: Search
    friction: Answered
    normal: Answered


class Decision(Struct, frozen=True):
    """How all that rubs behaves: by which trials, and which contacts are shown not to stick."""

    modes: dict[str, str]
    scene: SceneEquations | None = None  # with these modes, where trials have looked at it
    trials: tuple[Trial, ...] = ()
    slipping: tuple[SlippingContact, ...] = ()


def decide(configuration: Configuration, at_rest: Collection[str] = ()) -> Decision:
    """The modes of all contacts with a coefficient of friction and of all wheels on rubbing axles.

    `at_rest` are the names of those that are known not to slip at the start, where their speeds are numbers that have been rounded.
    """
    rubbing, blows = rubs(configuration), rough_blows(configuration)
    return Trials(configuration).decision(rubbing, at_rest) if rubbing or blows else Decision({})


class Trials:
    """Tries in which ways what rubs can move: all trials are of one scene, and differ in the facts of contacts alone."""

    def __init__(self, configuration: Configuration) -> None:
        self.configuration = configuration
        self.scene = SceneEquations(configuration)
        self.modes: dict[str, str] = {}
        self.made: list[Trial] = []
        self.slipping: list[SlippingContact] = []
        self.untold: set[str] = set()  # that may move where their phase starts: it hangs on a letter that is asked for
        self._searches: dict[tuple[object, tuple[str, ...]], Search] = {}

    def decision(self, rubbing: Sequence[Rub], at_rest: Collection[str]) -> Decision:
        """Phase by phase: what one leaves moving hangs on how it moved there."""
        blows = {blow.start: blow for blow in rough_blows(self.configuration)}
        for state in self.configuration.timeline.order:
            own = [rub for rub in rubbing if rub.state == state]
            if own:
                self.decide_from(state, own, at_rest)
            if state in blows:
                from rotsolve.search.struck import decide_blow

                decide_blow(blows[state], self)
        states = {
            rub.state for rub in rubbing
        }  # through an event that something sticks is said, else it moves as afterwards
        modes = {
            key: mode for key, mode in self.modes.items() if mode not in ("", STICKS) or rub_of(key)[1] not in states
        }
        return Decision(modes, self.scene.where(modes), tuple(self.made), tuple(self.slipping))

    def decide_from(self, state: str, rubbing: Sequence[Rub], at_rest: Collection[str]) -> None:
        """What moves at the start of a phase goes on; then groups at rest, each as a trial tells."""
        known = {**dict(self.configuration.timeline.state(state).senses), **dict.fromkeys(at_rest, 0)}
        senses = self.senses_at_start([rub for rub in rubbing if rub.name not in known])
        for rub in rubbing:
            moving = known[rub.name] if rub.name in known else senses[rub.key]
            if moving or smooth(rub, self.configuration.signs):
                self.modes[rub.key] = rub.mode(moving or 1)
        resting = [rub for rub in rubbing if rub.key not in self.modes and rub.key not in self.untold]
        self.modes.update({rub.key: rub.mode(0) for rub in resting if not self.lasts(rub)})
        for group in self.moving_together([rub for rub in resting if self.lasts(rub)]):
            contact = group[0].contact
            if len(group) > 1 and self.scene.instant(state).in_balance:
                self.modes.update({rub.key: rub.mode(0) for rub in group})  # what holds is asked of the balance
            elif len(group) > 1 or contact is None or not self.tried(group[0], contact):
                self.modes.update((self.by_trial if self.stacked(group) else self.by_motion)(group))

    def stacked(self, group: Sequence[Rub]) -> bool:
        """Whether one of several may slip while another sticks: one lies on another, rolls, or goes its own way."""
        if len(group) < 2:
            return False
        carried = any(rub.contact and rub.contact.carrier(self.configuration) for rub in group)
        rolls = any(rub.contact and self.scene.instant(rub.state).is_round(rub.body) for rub in group)
        return carried or rolls or not self.tied(group).in_one_motion()

    def tied(self, group: Sequence[Rub]) -> Tied:
        """A group as it moves where all of it slips."""
        slipping = self.scene.where({**self.modes, **{rub.key: rub.mode(1) for rub in group}})
        return Tied(group, slipping, self.configuration.signs)

    def ways(self, group: list[Rub]) -> Iterator[dict[Rub, int]]:
        """The senses in which a group may begin to slip, 0 for what goes on to stick: those in which the fewest slip first."""
        if len(group) > 1 and not self.stacked(group):
            for way in (1, -1):
                senses = self.tied(group).senses(way)
                yield {rub: senses[rub.key] for rub in group}
            return
        yield from (ways_of(self.tied(group).units()) or [])[1:]

    def lasts(self, rub: Rub) -> bool:
        """Whether what rests may begin to slip there: right before an event a finite force does nothing, save where it is asked."""
        after = self.configuration.timeline.after(rub.state)
        asked = (term for find in self.configuration.problem.finds for term in find.terms)
        return after is None or after.event is None or any(term.at == rub.state for term in asked)

    def search(self, modes: Mapping[str, str], families: tuple[str, ...] = (NEWTON,)) -> Search:
        """What the laws tell where what rubs moves as it is supposed to; the same supposition is looked into once."""
        key = (frozenset(modes.items()), families)
        if key not in self._searches:
            self._searches[key] = self.fresh(modes, families)
        return self._searches[key]

    def fresh(self, modes: Mapping[str, str], families: tuple[str, ...]) -> Search:
        """A search of its own, with little patience where it goes through all laws: what hangs on something open has no answer anyway."""
        search = Search(self.scene.where(modes), families, careful=True)
        search.known |= search.values.keys() | search.signs.trials.keys()  # what is asked too, in the case of its value
        if families != (NEWTON,):
            search.planner.patience[0] = PATIENCE // 20
        return search

    def note(self, modes: Mapping[str, str], found: Iterable[Words], holds: bool | None, why: str) -> None:
        """Remember a trial as data."""
        supposed = tuple((rub_of(key)[0], mode.removesuffix(AT_MOST) or "turns") for key, mode in modes.items())
        self.made.append(Trial(supposed, tuple(words for words in found if words), holds, why))

    def moving_together(self, open_: list[Rub]) -> list[list[Rub]]:
        """What rubs on bodies that move together in the same phase, group by group."""
        groups: dict[tuple[str, frozenset[str]], list[Rub]] = {}
        for rub in open_:
            groups.setdefault((rub.state, self.configuration.component(rub.body, rub.state)), []).append(rub)
        return list(groups.values())

    # what moves already

    def senses_at_start(self, open_: Sequence[Rub]) -> dict[str, int]:
        """The senses in which all slide or turn at the start of their phase, each with the others as they are found to; all are taken to
        slip at first, so that no rule of sticking settles how an event leaves them."""
        senses = {rub.key: self.sense_before(rub) for rub in open_ if rub.item is not None}
        for _ in range(ROUNDS):
            others = {rub.key: rub.mode(senses[rub.key] or 1) for rub in open_ if rub.key in senses}
            found = {rub.key: self.sense_at_start(rub, others) for rub in open_}
            if all(found[key] == sense for key, sense in senses.items()):
                break
            senses = {key: found[key] for key in senses}
        return found

    def sense_at_start(self, rub: Rub, others: Mapping[str, str]) -> int:
        """The sense in which it slides or turns at the start of its phase; 0 where it is not known to move."""
        speed = rub.rate(self.scene.instant(rub.state))
        if speed is None:
            return 0
        if not has_quantities(speed):
            return self.sense_of(rub, speed)
        first = rub.state == self.configuration.timeline.states[0].name
        return self.sense_tied(rub, speed) if rub.contact is not None and first else self.sense_left(rub, speed, others)

    def sense_tied(self, rub: Rub, speed: Formula) -> int:
        """The sense in which a contact slips at first where what the scene tells of the motion of others tells it, by strings and joints
        alone; all is taken to slip, so that no rule of sticking settles it."""
        freed = {item.key: item.mode(1) for item in rubs_at(self.configuration, rub.state) if item.item is not None}
        found = self.search({**self.modes, **freed}, ()).settled(speed)
        return 0 if found is None or has_quantities(found) else self.sense_of(rub, found)

    def sense_left(self, rub: Rub, speed: Formula, others: Mapping[str, str]) -> int:
        """The sense in which an event or an earlier phase leaves it moving, itself taken to slip one way or the other.

        What an event would leave moving against either sense of its friction sticks through it.
        """
        if self.comes_to_rest(rub):
            return 0
        told: list[int] = []
        first = self.sense_before(rub)
        for sense in (first, -first):
            found = self.search({**self.modes, **others, rub.key: rub.mode(sense)}, families_for(None)).settled(speed)
            if found is not None and not has_quantities(found):
                told.append(self.sense_of(rub, found))
                if told[-1] == sense:
                    return sense
        before = self.configuration.timeline.before(rub.state)
        if not told and rub.item is None and before is not None and before.event is not None:
            self.check_told([rub])  # a blow may set it going
        if not told and before is not None and self.seeking():
            self.untold.add(rub.key)
        if told == [-1, 1] and rub.contact is not None and before is not None and before.event is not None:
            self.modes[rub_key(rub.name, before.name)] = STICKS
        return 0

    def seeking(self) -> bool:
        """Whether a letter is asked for whose value is not known yet."""
        return any(given.asked and given.trial is None for given in self.configuration.problem.givens)

    def comes_to_rest(self, rub: Rub) -> bool:
        """Whether it surely does not move where a phase leads to its state: it stuck all the way, or is said to stick from there on."""
        timeline = self.configuration.timeline
        before, lines = timeline.before(rub.state), timeline.state(rub.state).conditions
        if before is None or before.event is not None:
            return False
        on_the_way = self.modes.get(rub_key(rub.name, self.configuration.phase_start(before.start)))
        said = any(line.path and line.path.owner == rub.name and line.word in ("sticks", "rolls") for line in lines)
        return said or on_the_way == rub.mode(0)

    def sense_before(self, rub: Rub) -> int:
        """The sense in which it slips on the way to a state, in which it does not turn back; the positive one where nothing leads there."""
        before = self.configuration.timeline.before(rub.state)
        if before is None or before.event is not None:
            return 1
        mode = self.modes.get(rub_key(rub.name, self.configuration.phase_start(before.start)))
        return -1 if mode == rub.mode(-1) else 1

    def sense_of(self, rub: Rub, speed: Formula) -> int:
        """The sign of a speed, 0 where no precision tells it from 0; letters without a number stand for positive sizes."""
        signs = self.configuration.signs
        sign = signs.of_sizes(speed)
        if sign is None and signs.lacking(speed):
            question = f"which way `{rub.body}` slips or turns against `{rub.name}` at first"
            raise self.configuration.undecided(speed, question, self.configuration.bodies[rub.body].span)
        return sign or 0

    # one contact at rest

    def tried(self, rub: Rub, contact: Connection) -> bool:
        """Take a contact to stick: whether the numbers tell if the friction that this takes is more than there can be."""
        search = self.fresh(self.modes, (NEWTON,))  # its steps may be shown
        self.tell_way(search, rub.state)
        found = sticking(search, rub, contact)
        if found is None and rub.state != self.configuration.timeline.states[0].name:
            search = self.fresh(self.modes, families_for(None))  # where it is hangs on the way
            self.tell_way(search, rub.state)
            found = sticking(search, rub, contact)
        if found is None:
            return False
        friction, normal = found
        needed, limit = friction.found.formula, greatest_friction(contact, normal)
        if needed is None or limit is None:
            return False
        side, beyond = search.numbers.side(needed), search.numbers.side(call("abs", needed) - limit)
        if side is None or beyond is None:
            return False
        words: list[Words] = [("friction needed: ", needed), ("friction at most: ", limit)]
        why = "less than the contact can give" if beyond <= 0 else "more than the contact can give"
        self.note({rub.key: STICKS}, words, beyond <= 0, why)
        self.modes[rub.key] = STICKS if beyond <= 0 else FORWARD if side > 0 else BACK
        if beyond > 0:
            self.slipping.append(SlippingContact(contact, search, friction, normal))
        return True

    def tell_way(self, search: Search, state: str) -> None:
        """Work out how fast all moves on the way to a state, where forces vary with the place: which way it has gone tells the place."""
        timeline = self.configuration.timeline
        for interval in timeline.between(timeline.states[0].name, state):
            passage = search.scene.passages.get(interval.name)
            if passage is not None and any(travel.pace == POSITION for travel in passage.travels):
                tell_ends(search, interval)

    # several that move together

    def by_motion(self, group: list[Rub]) -> dict[str, str]:
        """The modes of a group that moves together: the way round in which it speeds up, or rest; nothing where numbers do not tell."""
        told = True
        for way in (1, -1):
            senses = self.tied(group).senses(way)
            moving = {rub.key: rub.mode(senses[rub.key]) for rub in group}
            trial = {key: against_most(mode) for key, mode in moving.items()}
            gains = [self.speeding_up(rub, trial, senses[rub.key]) for rub in group if senses[rub.key]]
            numbers = [number for number, _ in gains]
            known = all(number is not None for number in numbers)
            holds = all(number is not None and number > 0 for number in numbers)
            why = "it speeds up that way" if holds else "it does not speed up that way"
            why = why if known else "the numbers do not tell"
            self.note(moving, [words for _, words in gains], holds if known else None, why)
            if holds:
                return moving
            told = told and known
        if told:
            return {rub.key: rub.mode(0) for rub in group}
        free = without_asked(group, self.configuration.problem)
        if free is None:
            self.check_told(group)
            return {}
        return Trials(Configuration(free)).by_motion(group)

    def check_told(self, group: Sequence[Rub]) -> None:
        """Unsolvable where nothing tells whether what rubs begins to move, and no question may tell it."""
        problem = self.configuration.problem
        named = [spoken(rub.body) for rub in group]
        sought = problem.sought or any(find.where is not None for find in problem.finds)
        if not sought:
            state = f" from `{group[0].state}` on" if group[0].state else ""
            raise unsolvable(
                problem,
                f"whether friction holds {named[0]}{state} is not told by the laws of motion in closed form",
                kind=UNSOLVED,
            )

    def by_trial(self, group: list[Rub]) -> dict[str, str]:
        """The modes of contacts of which one may slip while another sticks (a block on a block): as few slip as can be; nothing where
        numbers do not tell, as long as a question may tell them. Unsolvable where none of the ways can be.

        What a way that can not be hangs on is no condition of the one that can, but where two hold a wheel, neither of which would let it
        go alone: there motion is tried first.
        """
        units = self.tied(group).units()
        ways = ways_of(units) or []
        failed: list[Witness] = []
        together = any(rub.contact is None for rub in group)
        for way in reversed(ways) if together else ways:
            trial = {rub.key: rub.mode(sense) for rub, sense in way.items()}
            with witnessed_apart() as noted:
                can_be = self.can_be(trial, units, way)
            failed = [*failed, noted] if together or not can_be else [noted]
            if can_be:
                break
        for noted in failed:
            pass_on(noted)
        if ways and can_be:
            return trial
        problem = self.configuration.problem
        if problem.sought:
            return {}
        names = ", ".join(f"`{rub.name}`" for rub in group)
        raise unsolvable(problem, f"which of {names} slip is not told by the laws of motion", kind=UNSOLVED)

    def can_be(self, trial: Mapping[str, str], units: Sequence[Unit], way: Mapping[Rub, int]) -> bool:
        """Whether all that rubs does as it is supposed to; the first that does not is told."""
        found: list[Words] = []
        for unit in units:
            first = next(iter(unit))
            holds, words = self.holds(unit, trial, way[first])
            found.append(words)
            if not holds:
                why = "does not speed up that way" if way[first] else "lacks friction"
                self.note(trial, found, False, f"{spoken(first.name)} {why}")
                return False
        self.note(trial, found, True, "what sticks has friction enough, and what slips speeds up that way")
        return True

    def holds(self, unit: Unit, trial: Mapping[str, str], sense: int) -> tuple[bool, Words]:
        """Whether what slips together does as it is supposed to: sticks with no more friction than there can be, or speeds up as it
        slips."""
        first = next(iter(unit))
        if sense:
            number, words = self.speeding_up(first, trial, sense)
            return number is not None and number > 0, words
        if first.contact is None or len(unit) > 1:
            moving = [{rub.key: against_most(rub.mode(own * way)) for rub, own in unit.items()} for way in (1, -1)]
            gains = [
                self.speeding_up(first, {**trial, **modes}, way) for modes, way in zip(moving, (1, -1), strict=True)
            ]
            return all(number is not None and number <= 0 for number, _ in gains), ("it does not speed up either way",)
        search = self.search({**self.modes, **trial})
        room = [search.settled(need.left - need.right) for need in own_needs(first, search.scene)]
        numbers = [search.number(value) if value is not None else None for value in room]
        left = [value for value in room if value is not None]
        told: Words = (f"{spoken(first.name)} has friction to spare: ", left[0]) if left else ()
        return all(number is not None and number >= 0 for number in numbers), told

    def speeding_up(self, rub: Rub, trial: Mapping[str, str], sense: int) -> tuple[float | None, Words]:
        """Acceleration along the sense in which it is taken to move, also in words; None where the numbers do not tell."""
        rate = rub.rate(self.scene.instant(rub.state), acceleration=True)
        first = rub.state == self.configuration.timeline.states[0].name
        for families in (
            [(NEWTON,)] if first else [(NEWTON,), families_for(None)]
        ):  # when a later state is hangs on the way
            search = self.search({**self.modes, **trial}, families)
            value = search.settled(rate) if rate is not None else None
            number = search.number(value) if value is not None else None
            if number is not None:
                break
        words: Words = () if value is None else (f"{spoken(rub.name)} speeds up by ", signed(value, sense))
        return None if number is None else number * sense, words


def without_asked(group: Sequence[Rub], problem: Problem) -> Problem | None:
    """The problem without the friction of axles and brakes that is asked for, which is against the way they would go then; None where
    none is."""
    asked = {given.name for given in problem.givens if given.asked and given.trial is None}
    names = {rub.owner for rub in group if rub.contact is None}
    own = [item for item in (*problem.connections, *problem.actions) if item.name in names] if asked else []
    values = [value for item in own for value, limits in limits_of(item) if limits == "nonnegative"]
    letters = {name for value in values if isinstance(value, Formula) for name in value.symbols()} & asked
    if not letters:
        return None
    free = [replace(item, value=ZERO, asked=False) if item.name in letters else item for item in problem.givens]
    return replace(problem, givens=tuple(free))


def check_goes_on(configuration: Configuration) -> None:
    """NeverReached where what the last state says to stick or to roll would slip on from there: its slip only turns round."""
    *_, before, last = configuration.problem.states
    whole = Configuration(with_hereafter(configuration.problem), configuration.alteration)
    try:
        modes = decide(whole).modes
    except Unsolvable:
        return  # nothing tells what comes then
    for clash in said_otherwise(whole, modes):
        from rotsolve.search.explain import unreachable

        raise unreachable(whole.problem, before.name, last.name, clash.fault.span, clash.fault.message)


def said_otherwise(configuration: Configuration, modes: Mapping[str, str]) -> Iterator[Unsolvable]:
    """Contacts that a state says to stick where friction is too weak for it, or to slip where it is strong enough."""
    problem = configuration.problem
    numbered = problem.values.keys() | problem.trials.keys()
    for state in configuration.timeline.states:
        if state.opened:
            continue
        contacts = {item.name: item for item in configuration.connections(state.name)}
        for line in state.conditions if configuration.phase_start(state.name) == state.name else ():
            contact = contacts.get(line.path.owner) if line.path is not None else None
            if contact is None or not contact.rubs() or not set(letters_of(contact)) <= numbered:
                continue
            slips = modes.get(rub_key(contact.name, state.name), "sticks").startswith("slips")
            if line.word in ("sticks", "rolls") and slips:
                message = f"`{contact.name}` slips at `{state.name}`: friction is too weak to hold it"
                yield unsolvable(problem, message, line.span)
            elif line.word == "slips" and not slips:
                message = f"`{contact.name}` does not slip at `{state.name}`: friction is strong enough"
                yield unsolvable(problem, message, line.span)
