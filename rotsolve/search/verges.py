"""Verges: `largest F where touch sticks`: the value of a letter at which a contact is on the point of slipping, beyond which it slips.

Where more contacts hold a body in balance than the laws tell apart, all that can give way are on the point of slipping with it.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import islice, product

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.derivation import Equality
from rotsolve.core.equation import POINT_OF_SLIPPING, Equation
from rotsolve.core.symbols import asked_symbol, rub_key
from rotsolve.core.writing import spoken
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.limited import limited_letters
from rotsolve.language.problem import Find
from rotsolve.motion.rubs import STICKS, Rub, rubs
from rotsolve.paths.meaning import NotYet
from rotsolve.questions.find import Asked, question_for
from rotsolve.search.answers import Answered, NoAnswer
from rotsolve.search.extrema import add_step, remember_answer
from rotsolve.search.gripping import limiting
from rotsolve.search.roots import RootChoice
from rotsolve.search.search import TURN, Search, whole_turns
from rotsolve.solver.steps import Found

Limit = tuple[Equation, Formula]  # |f| = μ N one way, and the normal force


class Verge(Struct, frozen=True):
    """A value at which a contact is on the point of slipping one way, by the limits that are reached; `side` is +1 where it slips beyond
    it, −1 below it, 0 where nothing tells; `turned` are the senses of wheels on rubbing axles that are on the point of turning with it;
    `meant` is whether the search takes this root of the limits for the one that is meant."""

    value: Formula
    limits: tuple[Equation, ...]
    side: int
    turned: Mapping[Rub, int] = {}
    meant: bool = True
    modes: Mapping[str, str] = {}  # of others that slip there


def on_the_point_of_slipping(search: Search, find: Find) -> None:
    """`largest F where touch sticks`: the value at which the contact is on the point of slipping, beyond which it slips."""
    question, contact, state = verge_asked(find, search)
    verge = verge_meant(find, search)
    modes = {**{rub.key: rub.mode(sense) for rub, sense in verge.turned.items()}, **verge.modes}
    own_scene = open_at(contact, state, search.scene) is search.scene and modes.items() <= search.scene.modes.items()
    if question.letter not in search.solver.solved and own_scene and verge.meant:
        search.answer(question, *verge.limits)
        return
    own = asked_symbol(find.name)  # the letter has the value of another verge
    question = replace(question, letter=own, formula=Symbol(own))
    chain = [Equality(limit.left, limit.right) for limit in verge.limits] + [Equality(Symbol(own), verge.value)]
    steps = add_step(search, question, ("words", POINT_OF_SLIPPING.name), (), chain, ())
    remember_answer(search, Answered(question, Found(own, verge.value), (), steps))


def verge_asked(find: Find, search: Search) -> tuple[Asked, str, str]:
    """Whose value is asked for at a verge, of which contact, and at which state."""
    condition, configuration = find.where, search.scene.configuration
    assert condition is not None and condition.path is not None
    if condition.word not in ("sticks", "rolls"):
        raise NotYet(f"`where {condition.path.owner} is {condition.word}` is not solved yet")
    question = question_for(without_condition(find), search.scene, search.letters())
    state = find.terms[0].at if find.terms and find.terms[0].at else configuration.timeline.states[-1].name
    return question, condition.path.owner, state


def verge_meant(find: Find, search: Search) -> Verge:
    """The largest or smallest value at which a contact sticks, of those at which it is on the point of slipping."""
    configuration, word = search.scene.configuration, modifier_of(find)
    question, contact, state = verge_asked(find, search)
    verges = verges_of(contact, state, question, search)
    item = configuration.connection(contact, state)
    if not verges and item is not None and "torque" in item.quantities and not limiting(search.scene, contact, state):
        raise NotYet(
            f"with what value `{contact}` is on the point of slipping is not solved yet: it is solved of what presses on a surface",
            help=f"ask for `{contact}.torque`, which says up to what it sticks",
        )
    if not verges and item is not None and item.static() is None and not limiting(search.scene, contact, state):
        message = f"how much friction `{contact}` can give, nothing tells: it has no point of slipping"
        raise NotYet(message, help="tell its coefficient: `friction: mu`")
    if not verges:
        alone = not configuration.timeline.state(state).balance and len(rubs(configuration)) > 1
        raise NotYet(
            f"no value in closed form is found at which `{spoken(contact)}` is on the point of slipping"
            + (" by itself" if alone else ""),
            help=f"with `balance: true` at `{state}` all that can give way is at it together"
            if alone and state
            else "",
        )
    ends = [verge for verge in verges if verge.side in (0, 1 if word == "largest" else -1)]
    if not ends:
        bound = "large" if word == "largest" else "small"
        quantity = find.text.split(" where ")[0].removeprefix(word).strip()
        raise NotYet(f"`{contact}` sticks however {bound} `{quantity}` is")
    verge = ends[0]
    for other in ends[1:]:
        ahead = search.numbers.side(other.value - verge.value)
        verge = other if ahead == (1 if word == "largest" else -1) else verge
    way = 1 if word == "largest" else -1
    if any(other.side == -way and search.numbers.side(other.value - verge.value) == way for other in verges):
        side = "larger" if word == "largest" else "smaller"
        raise NotYet(f"`{contact}` slips beyond a value, and sticks again where the quantity is {side} still")
    return verge


def without_condition(find: Find) -> Find:
    """The quantity of a question alone."""
    terms = tuple(replace(term, modifier="") for term in find.terms)
    return replace(find, where=None, modifier="", terms=terms)


def modifier_of(find: Find) -> str:
    """`largest` or `smallest` in front of a question, or of its quantity."""
    return find.modifier or (find.terms[0].modifier if find.terms else "")


def open_at(contact: str, state: str, scene: SceneEquations) -> SceneEquations:
    """The scene in which a contact that slips from a state on, by the value of another verge, may stick."""
    key = rub_key(contact, scene.configuration.phase_start(state))
    if scene.modes.get(key, STICKS) == STICKS:
        return scene
    return scene.where({name: mode for name, mode in scene.modes.items() if name != key})


def verges_of(contact: str, state: str, question: Asked, search: Search) -> list[Verge]:
    """The values at which a contact is on the point of slipping, along its slip and back; in balance together with others, if not alone."""
    scene = open_at(contact, state, search.scene)
    ground = search if scene is search.scene else Search(scene, search.families, search.spare)
    verges = [verge for way in (1, -1) for verge in verges_slipping(way, contact, state, question, ground)]
    if not ground.scene.configuration.timeline.state(state).balance:
        from rotsolve.search.slipping_beside import where_others_hold

        return where_others_hold(verges, contact, state, question, ground)
    if verges:
        return verges
    from rotsolve.search.friction import TRIALS

    own = limiting(ground.scene, contact, state)
    others = [limiting(ground.scene, rub.owner, state) for rub in rubs(ground.scene.configuration) if rub.contact]
    return [
        verge
        for limits in islice(at_once(own, [item for item in others if item and item != own]), TRIALS)
        for verge in verges_at(ground, question, limits)
    ]


def verges_slipping(way: int, contact: str, state: str, question: Asked, search: Search) -> Iterator[Verge]:
    """The values at which a contact is on the point of slipping in one sense, and wheels that it would turn are on the point of turning."""
    turned = wheels_turned(contact, state, way, search.scene)
    modes = {rub.key: rub.mode(sense) for rub, sense in turned.items()}
    if modes:
        search = Search(search.scene.where({**search.scene.modes, **modes}), search.families, search.spare)
    limits = limiting(search.scene, contact, state)  # friction against the slip, then along it
    for verge in verges_at(search, question, (limits[0 if way > 0 else 1],)) if limits else ():
        yield replace(verge, turned=turned)


def wheels_turned(contact: str, state: str, way: int, scene: SceneEquations) -> dict[Rub, int]:
    """The senses in which wheels on rubbing axles would turn if a contact slipped; none where what it slips on moves too, or where it is
    known how they turn."""
    start = scene.configuration.phase_start(state)
    own = next((rub for rub in rubs(scene.configuration) if rub.owner == contact and rub.state == start), None)
    if own is None or own.contact is None or own.contact.carrier(scene.configuration):
        return {}
    tied = scene.configuration.component(own.body, start)
    wheels = [rub for rub in rubs(scene.configuration) if rub.item is None and rub.state == start and rub.body in tied]
    told = dict(scene.configuration.timeline.state(start).senses)
    balanced = scene.instant(start).in_balance
    wheels = [rub for rub in wheels if balanced or rub.name in told or rub.key not in scene.modes]
    if not wheels:
        return {}
    from rotsolve.search.friction import Trials

    senses = Trials(scene.configuration).tied([own, *wheels]).senses(way)
    return {rub: senses[rub.key] for rub in wheels}


def at_once(own: list[Limit], others: list[list[Limit]]) -> Iterator[tuple[Limit, ...]]:
    """The limits that several contacts may reach at once, each one way or the other."""
    return product(own, *others) if others else iter(())


def verges_at(search: Search, question: Asked, limits: tuple[Limit, ...]) -> Iterator[Verge]:
    """The values at which friction has its limits, one for each root of these: none at which a surface would have to pull, nor one that the
    letter can not be, as an angle at which the body lies in what it touches."""
    trial = search.another(search.families, spare=search.spare)
    try:
        value = trial.answer(question, *(limit for limit, _ in limits)).found.formula
        pushes = [trial.value_of(next(iter(normal.symbols()))) for _, normal in limits]
    except NoAnswer:
        return
    if value is None:
        return
    choice = RootChoice(search.scene, search.givens, trial.numbers, search.definitions.formula)
    rivals = [trial.solver.with_found(root) for root in trial.rivals.get(question.letter, ())]
    angle = goes_both_ways(question.letter, search) and search.may_be_angle(question.letter)
    for root in dict.fromkeys((value, *rivals)):
        root = root + whole_turns(root, trial) * TURN if angle else root
        if not goes_both_ways(question.letter, search) and trial.numbers.side(root) in (0, -1):
            continue
        if not choice.in_front(question.letter, root):
            continue
        pressed = pushes if root == value else pushes_at(search, question, root, limits)
        if any(push is not None and trial.numbers.side(push) == -1 for push in pressed):
            continue
        equations = tuple(limit for limit, _ in limits)
        side = side_together(search, question, equations, root)
        if side is not None:
            yield Verge(root, equations, side, meant=root == value)


def pushes_at(search: Search, question: Asked, value: Formula, limits: tuple[Limit, ...]) -> list[Formula | None]:
    """How hard surfaces press where the letter has a value."""
    other = search.another(search.families, spare=search.spare)
    other.known.add(question.letter)
    found = [other.settled(normal) for _, normal in limits]
    return [None if push is None else push.substitute({question.letter: value}) for push in found]


def goes_both_ways(letter: str, search: Search) -> bool:
    """Whether a letter may be negative: the angle of what no key keeps within limits, or where something is at a state."""
    problem, states = search.scene.configuration.problem, search.scene.configuration.timeline.states
    if search.may_be_angle(letter) and letter not in limited_letters(problem):
        return True
    return any(line.path is not None and line.value == Symbol(letter) for state in states for line in state.conditions)


def side_together(search: Search, question: Asked, limits: tuple[Equation, ...], value: Formula) -> int | None:
    """On which side of a verge at which frictions have their limits they can not hold, +1 where it slips beyond it; None where one of them
    has friction left on one side and another on the other, so that they hold on both, as what is jammed does; 0 where nothing tells."""
    sides = {slipping_side(search, question, limits, number, value) for number in range(len(limits))}
    return None if {1, -1} <= sides else next((side for side in sides if side), 0)


def slipping_side(search: Search, question: Asked, limits: tuple[Equation, ...], number: int, value: Formula) -> int:
    """On which side of a verge one of several frictions would have to be larger than its limit while the others keep theirs, by the rate at
    which μ N − |f| grows with the quantity there; 0 where nothing tells."""
    other = search.another(search.families, spare=search.spare)
    letter, limit = question.letter, limits[number]
    for held in (*limits[:number], *limits[number + 1 :]):
        other.planner.extend(held)
    try:
        if len(limits) == 1:
            other.planned(question, set())
        other.known.add(letter)
        friction, most = other.settled(limit.left), other.settled(limit.right)
    except NoAnswer:
        return 0
    if friction is None or most is None:
        return 0
    # f = ±μ N at the verge: friction is left where ±μ N ± f grows
    room = differentiate(most - friction, letter).substitute({letter: value})
    way, grows = (search.numbers.side(side.substitute({letter: value})) for side in (most, room))
    return -(grows or 0) * (way or 0)
