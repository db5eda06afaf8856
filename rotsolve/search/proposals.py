"""Proposals: what to add to a scene in which too little is known. Each is tried before it is printed: what it proposes leads on."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import PI, ZERO, Formula, formula
from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.core.registry import SceneQuantity
from rotsolve.core.symbols import is_quantity
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.noted import with_all_slots
from rotsolve.language.problem import Condition, Find, Path, Problem, State
from rotsolve.motion.configuration import Configuration
from rotsolve.paths.meaning import NotYet
from rotsolve.plan import PATIENCE
from rotsolve.search.answers import NoAnswer
from rotsolve.search.consistency import contradiction
from rotsolve.search.friction import decide
from rotsolve.search.search import Search

TRIED = 6  # proposals that are tried: each is a scene to be solved
REMEMBERED = 256
LED_ON: dict[object, bool] = {}  # which proposals for which questions of which scenes led on
STATED: dict[str, tuple[str, Formula]] = {  # what a state can say, with an example
    "angle": ("30 deg", PI / 6),
    "velocity": ("2 m/s", formula(2)),
    "angular_velocity": ("3 rad/s", formula(3)),
    "elongation": ("10 cm", formula(1) / 10),
    "displacement": ("1 m", formula(1)),
    "rotation": ("2 rev", 4 * PI),
}
RATES = ("velocity", "angular_velocity")


class Proposal(Struct, frozen=True):
    """What may be said of a state, in words, and the lines that say it."""

    words: str
    state: str
    lines: tuple[Condition, ...]


def proposals(missing: Sequence[SceneQuantity], scene: SceneEquations, asked: str) -> Iterator[Proposal]:
    """What might help: how the scene starts, what is missing, where bodies stand that turn about a pivot; never what is asked."""
    others = [
        item for item in missing if item.key != asked and item.owner and not item.component and item.kind in STATED
    ]
    ranked = sorted(others, key=lambda item: not at_start(item, scene))
    first = scene.configuration.timeline.states[0]
    if any(at_start(item, scene) and item.kind in RATES for item in ranked):
        words = f"say how it starts, as in `states: {{{first.name}: at rest}}`"
        yield Proposal(words, first.name, (Condition(None, rest=True, owner="all"),))
    for item in ranked:
        yield told(item.owner, item.kind, state_of(item.when, scene))
    for state in scene.configuration.timeline.states:
        for body in scene.configuration.present(state.name):
            pivoted = scene.configuration.pivot(body.name, state.name) is not None
            angle = scene.instant(state.name).angle(body.name) if pivoted else ZERO
            if angle is None or is_quantity(angle):
                yield told(body.name, "angle", state.name)


def told(owner: str, kind: str, state: str) -> Proposal:
    """A line of a state with an example."""
    written, value = STATED[kind]
    words = f"say more about the state, as in `states: {{{state or 'now'}: {{{owner}.{kind}: {written}}}}}`"
    return Proposal(words, state, (Condition(Path(owner, kind), value),))


def at_start(quantity: SceneQuantity, scene: SceneEquations) -> bool:
    """Whether a quantity belongs to the first of several states."""
    states = scene.configuration.timeline.states
    return len(states) > 1 and quantity.when == states[0].name


def state_of(when: str, scene: SceneEquations) -> str:
    """The state at which a quantity can be said: its own, or the end of its phase."""
    timeline = scene.configuration.timeline
    interval = timeline.interval(when)
    own = when if when in timeline.order else timeline.states[0].name
    return interval.end if interval is not None else own


def leads_on(proposal: Proposal, scene: SceneEquations, find: Find, families: tuple[str, ...]) -> bool:
    """Whether a question has an answer in the scene with the lines of a proposal, and nothing contradicts it; looked into once for all
    cases of its letters."""
    problem = scene.configuration.problem
    key = (
        tuple(problem.lines),
        tuple(map(with_all_slots, problem.bodies)),
        problem.states,
        find.name,
        proposal.words,
        families,
    )
    if key not in LED_ON:
        while len(LED_ON) >= REMEMBERED:
            del LED_ON[next(iter(LED_ON))]
        LED_ON[key] = answers_with(proposal, problem, find, families)
    return LED_ON[key]


def answers_with(proposal: Proposal, problem: Problem, find: Find, families: tuple[str, ...]) -> bool:
    """Whether a question has an answer in the problem with the lines of a proposal, and nothing contradicts it."""
    states = problem.states or (State("now"),)
    kept = [
        replace(state, conditions=(*state.conditions, *proposal.lines))
        if state.name == (proposal.state or "now")
        else state
        for state in states
    ]
    try:
        configuration = Configuration(replace(problem, states=tuple(kept)))
        scene = SceneEquations(configuration, decide(configuration).modes)
        search = Search(scene, families, confirming=True)
        return has_answer(find, search) and contradiction(search)[0] is None
    except (NotYet, Unsolvable, SceneError, ArithmeticError, ValueError):
        return False


def has_answer(find: Find, search: Search) -> bool:
    """Whether a search answers a question, with little patience: it is only for a word of help."""
    from rotsolve.search.answering import answer_by_law, answer_with_condition

    search.planner.patience[0] = PATIENCE // 20
    try:
        if not answer_with_condition(search, find):
            answer_by_law(search, find)
    except (NoAnswer, NotYet, Unsolvable, SceneError, ArithmeticError, ValueError):
        return False
    return True
