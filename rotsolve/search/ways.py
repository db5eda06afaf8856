"""Ways: how what rubs moves where that hangs on a letter that the scene asks for: the way in which the letter's value brings it about.

`F where box.acceleration = A` on a rough floor: with the box sliding forwards the condition tells F, and by that F it does slide so.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import islice, product

from msgspec.structs import replace

from rotsolve.algebra.certified.ball import pass_on, witnessed_apart
from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.faults import Unsolvable
from rotsolve.core.letters import letters_of
from rotsolve.core.symbols import has_quantities
from rotsolve.language.problem import EXTREMES, Find, Problem
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.rubs import STICKS, Rub, rubs
from rotsolve.paths.meaning import NotYet
from rotsolve.search.answering import answer
from rotsolve.search.answers import unsolvable
from rotsolve.search.consistency import contradiction, untimely
from rotsolve.search.friction import TRIALS, Trials, decide
from rotsolve.search.gripping import own_needs, smooth
from rotsolve.search.search import Search
from rotsolve.search.verges import modifier_of, verge_meant
from rotsolve.search.within import out_of_bounds


def with_way_found(search: Search, *, stuck: bool) -> Problem | None:
    """The problem in the case of the value that a letter has in the one way in which what rubs moves by that value as well; else None.

    Where the questions have answers too: what nothing has told was taken to stick, or to turn in the wheel's own sense. A letter of which
    they seek several values has no one way. At the verge of slipping a wheel is on the point of turning with what slips.
    """
    scene = search.scene
    problem = scene.configuration.problem
    asked = {given.name for given in problem.givens if given.asked and given.trial is None}
    if not asked:
        return None
    open_ = [rub for rub in rubs(scene.configuration) if is_open(rub, search)]
    letters = Counter(find.formula.name for find in problem.finds if isinstance(find.formula, Symbol))
    for find in problem.finds if open_ else ():
        letter = find.formula.name if isinstance(find.formula, Symbol) else ""
        if letters[letter] > 1 and not stuck:
            continue
        verge = find.where.path.owner if find.where is not None and find.where.path is not None else ""
        others = [rub for rub in open_ if rub.owner != verge]
        if letter in asked and others:
            found = at_the_verge(find, search) if verge and modifier_of(find) else None
            found = found or by_ways(find, letter, others, search)
            if found is not None:
                return found
    return None


def at_the_verge(find: Find, search: Search) -> Problem | None:
    """The problem with the senses in which wheels on rubbing axles would turn if a contact slipped beyond the value that is asked for."""
    problem = search.scene.configuration.problem
    try:
        turned = verge_meant(find, search).turned
    except (NotYet, Unsolvable):
        return None
    modes = search.scene.modes
    if all(modes.get(rub.key, "") == rub.mode(sense) for rub, sense in turned.items()):
        return None
    start = next(rub.state for rub in turned)
    senses = tuple((rub.name, sense) for rub, sense in turned.items())
    states = [replace(one, senses=senses) if one.name == start else one for one in problem.states]
    told = dict(search.scene.configuration.timeline.state(start).senses)  # by another question
    return None if told else replace(problem, states=tuple(states))


def is_open(rub: Rub, search: Search) -> bool:
    """Whether nothing has told how it moves, not a speed that the state tells by a letter either, and it matters."""
    configuration = search.scene.configuration
    speed = rub.rate(search.scene.instant(rub.state))
    told = speed is not None and not has_quantities(speed) and not is_zero(speed)
    return not told and rub.key not in search.scene.modes and not smooth(rub, configuration.signs)


def by_ways(find: Find, letter: str, open_: Sequence[Rub], search: Search) -> Problem | None:
    """The problem in the case of the value that one question gives its letter in one way, where by that value all goes that way.

    What the ways that fail hang on is no condition then: that this one holds is looked at again when the problem is solved in its case.
    Of the `largest` or `smallest` value it is one: another way, where it holds, may lead to one beyond.
    """
    extreme = find.modifier in EXTREMES and find.where is not None and find.where.phrase is not None
    with witnessed_apart() as noted:
        values = list(islice(values_by_ways(find, letter, open_, search), None if extreme else 1))
    if extreme or not values:
        pass_on(noted)
    if not values:
        return None
    sign = -1 if find.modifier == "largest" else 1
    value = values[search.numbers.least([sign * value for value in values])] if extreme else values[0]
    return in_case_of(letter, value, search.scene.configuration.problem)


def values_by_ways(find: Find, letter: str, open_: Sequence[Rub], search: Search) -> Iterator[Formula]:
    """The values of a letter each of which brings about the way in which a question gives it."""
    problem = search.scene.configuration.problem
    for senses in islice(ways_together(open_, search.scene.configuration), TRIALS):
        way = {rub.key: rub.mode(sense) for rub, sense in senses.items()}
        value = value_going(way, find, letter, search)
        if value is None:
            continue
        try:
            modes = decide(Configuration(in_case_of(letter, value, problem))).modes
        except (NotYet, Unsolvable):
            continue
        if all(modes.get(key, mode if mode in ("", STICKS) else "") == mode for key, mode in way.items()):
            yield value


def in_case_of(letter: str, value: Formula, problem: Problem) -> Problem:
    """The problem in the case of a value of a letter that it asks for."""
    return replace(
        problem, givens=tuple([replace(item, trial=value) if item.name == letter else item for item in problem.givens])
    )


def ways_together(open_: Sequence[Rub], configuration: Configuration) -> Iterator[Mapping[Rub, int]]:
    """The senses in which what rubs may move, 0 for what rests, group by group of what moves together; those at rest first."""
    trials = Trials(configuration)
    groups = trials.moving_together(list(open_))
    for chosen in product(*([dict.fromkeys(group, 0), *trials.ways(group)] for group in groups)):
        yield {rub: sense for senses in chosen for rub, sense in senses.items()}


def value_going(way: Mapping[str, str], find: Find, letter: str, search: Search) -> Formula | None:
    """What a question makes of its letter where what rubs moves in a way; None where it has no answer then, or none that it can be, that
    agrees with all laws, or that time can bring about."""
    trial = Search(search.scene.where({**search.scene.modes, **way}), search.families, search.spare)
    try:
        answer(trial, find)
        for refusal in out_of_bounds(trial):
            raise refusal
    except Unsolvable:
        return None
    broken, numbers = contradiction(trial)
    if broken is not None or untimely(trial, numbers):
        return None
    found = trial.solver.solved.get(letter)
    return found.formula if found is not None else None


def with_friction_found(search: Search) -> Problem | None:
    """The problem in the case of the coefficients that its answers give, where by these some contact can not stick; else None.

    A coefficient that the scene asks for is settled by what one contact needs; whether others stick shows afterwards.
    """
    problem, numbers = search.scene.configuration.problem, search.numbers
    found = {name: item.formula for name, item in search.solver.solved.items() if item.formula is not None}
    check_friction_settled(search, found.keys())
    asked = {given.name: given for given in problem.givens if given.asked and given.name in found}
    for name, given in asked.items():
        if given.trial is not None and numbers.side(found[name] - given.trial) != 0:
            message = (
                f"which contacts slip hangs on `{name}`, and `{name}` on which of them slip: that is not told apart"
            )
            raise unsolvable(problem, message, None, f"give a number to `{name}`")
    open_ = {name for name, given in asked.items() if given.trial is None}
    needs = [need for rub in rubs(search.scene.configuration) for need in own_needs(rub, search.scene)]
    needs = [need for need in needs if (need.left - need.right).symbols() & open_]
    aside = search.apart() if needs else search
    room = [aside.settled(need.left - need.right) for need in needs]
    if not any(value is not None and numbers.side(search.solver.with_found(value)) == -1 for value in room):
        return None
    givens = [replace(item, trial=found[item.name]) if item.name in open_ else item for item in problem.givens]
    return replace(problem, givens=tuple(givens))


def check_friction_settled(search: Search, found: Collection[str]) -> None:
    """Unsolvable where whether a contact sticks hangs on a coefficient that is asked for and not found; but for one on the verge of it."""
    configuration, problem = search.scene.configuration, search.scene.configuration.problem
    open_ = {given.name for given in problem.givens if given.asked and given.trial is None} - set(found)
    verges = {find.where.path.owner for find in problem.finds if find.where is not None and find.where.path is not None}
    for rub in rubs(configuration):
        lacking = sorted(open_ & set(letters_of(rub.contact))) if rub.contact is not None else []
        if lacking and rub.name not in verges and rub.key not in search.scene.modes:
            message = f"whether `{rub.body}` slips hangs on `{lacking[0]}`, which is not settled here"
            raise unsolvable(problem, message, None, f"give a number to `{lacking[0]}`")
