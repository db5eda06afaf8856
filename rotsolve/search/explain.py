"""Explain: why there is no answer, in the scene's words: what is missing or contradictory, where, and what may help."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import islice

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO
from rotsolve.core.equation import FAMILIES, NEWTON, Equation
from rotsolve.core.faults import (
    CONTRADICTORY,
    INCOMPLETE,
    UNREACHED,
    UNSOLVED,
    Contradicted,
    NeverReached,
    Span,
    Unsolvable,
)
from rotsolve.core.quantity import INSIDE
from rotsolve.core.registry import SceneQuantity
from rotsolve.core.symbols import ACROSS_AXIS, ASKED, CONSTANT, MIXED, POSITION, TIME, key_of, phase_midst, real
from rotsolve.core.writing import in_direction, spoken
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Find, Problem, State
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.hereafter import HEREAFTER
from rotsolve.motion.timeline import Interval
from rotsolve.paths.meaning import path_text
from rotsolve.plan import Shortage
from rotsolve.search.answers import CHECK_DATA, NoAnswer, unsolvable
from rotsolve.search.planning import families_for
from rotsolve.search.search import Search
from rotsolve.search.uncovered import why_uncovered
from rotsolve.solver import ENTANGLED


def contradicted(equation: Equation, scene: SceneEquations, fallback: Span | None = None) -> Unsolvable:
    """Which law or line the data break; over a phase, that its end is never reached."""
    error = what_breaks(equation, scene, fallback)
    error.fault = replace(error.fault, broken=error.fault.kind in (CONTRADICTORY, UNREACHED))
    return error


def with_way(error: Unsolvable, search: Search) -> Unsolvable:
    """A state that is never reached with where the motion goes instead, where that is known."""
    from rotsolve.search.reached import instead_of_there

    why = instead_of_there(error.state, search) if isinstance(error, NeverReached) and error.fault.broken else ""
    if isinstance(error, NeverReached) and why:
        error.retold(replace(error.fault, help=why))
    return error


def what_breaks(equation: Equation, scene: SceneEquations, fallback: Span | None) -> Unsolvable:
    """The same as far as the equation tells."""
    problem, timeline = scene.configuration.problem, scene.configuration.timeline
    open_ = unreached(scene)
    if open_:  # what such a scene seems to contradict is only that no time passes
        span = timeline.state(open_).span or fallback
        return unsolvable(problem, f"nothing tells when `{open_}` is reached", span, LINE_OR_EVENT, kind=INCOMPLETE)
    line = next((condition for stated, condition in scene.stated if stated is equation), None)
    if (stopped := stopped_before(equation.section, scene)) is not None:
        start, why = stopped
        span = line.span if line is not None else timeline.state(equation.section).span
        return unreachable(problem, start, equation.section, span or fallback, why)
    if line is not None:
        path = path_text(line.path) if line.path is not None else line.owner
        message = f"the data contradict each other: what `{equation.section}` says of `{path}` can not be"
        if line.rest:
            message = f"the data contradict each other: `at rest: {line.owner}` can not hold at `{equation.section}`"
        return clash(problem, message, line.span or fallback, CHECK_DATA)
    broken = f"“{equation.label}” can not hold; {CHECK_DATA}" if equation.label else CHECK_DATA
    interval = timeline.interval(equation.section)
    if interval is None:
        state = next((state for state in timeline.states if state.name and state.name == equation.section), None)
        where = f" at `{state.name}`" if state is not None else ""
        span = state.span if state is not None and state.span is not None else fallback
        return clash(problem, f"the data contradict each other{where}", span, broken)
    if interval.event is not None:
        message = f"the data contradict each other: `{interval.end}` can not follow from `{interval.start}` by `{interval.name}`"
    else:
        start, end = timeline.told(interval)
        on_the_way = timeline.states[timeline.order[start] : timeline.order[end]]
        between = [state.opened for state in on_the_way if state.opened]
        twice = too_much_told(timeline.state(end), problem)
        broken = (
            f"{between[-1]} before" if between else f"“{equation.label}” can not hold: {twice}" if twice else broken
        )
        return unreachable(problem, start, end, timeline.state(end).span or fallback, broken)
    return clash(problem, message, timeline.state(interval.end).span or fallback, broken)


def stopped_before(state: str, scene: SceneEquations) -> tuple[str, str] | None:
    """From which state a motion comes to rest before another one, and which body that is; None where it does not, or a time tells when."""
    timeline = scene.configuration.timeline
    interval = next((one for one in timeline.intervals if one.end == state and one.event is None), None)
    if interval is None or not timeline.state(interval.start).opened or timeline.state(state).time_told is not None:
        return None
    return timeline.told(interval)[0], f"{timeline.state(interval.start).opened} before"


def too_much_told(state: State, problem: Problem) -> str:
    """What to leave out where a state that is not reached tells of a body both where it is and how fast it goes there; else ''."""
    told = {
        (line.path.owner, line.path.quantity): path_text(replace(line.path, component=None))
        for line in state.conditions
        if line.path is not None and line.value is not None and not line.value.symbols() & problem.sought
    }
    for (owner, word), place in told.items():
        rate = next((told[owner, rate] for rate in RATES_TOLD if (owner, rate) in told), "")
        if word in PLACES_TOLD and rate:
            return f"`{state.name}` tells `{place}` and `{rate}`, of which one follows from the other"
    return ""


def clash(problem: Problem, message: str, span: Span | None, help: str) -> Contradicted:
    """Data that contradict each other, with their place in the file."""
    return Contradicted(message, span=span, help=help, lines=problem.lines, file=problem.file)


def unreachable(problem: Problem, start: str, end: str, span: Span | None, help: str) -> NeverReached:
    """A state of the scene to which the motion does not get."""
    message = f"`{end}` is never reached from `{start}`"
    error = NeverReached(message, span=span, help=help, lines=problem.lines, file=problem.file)
    error.state = end
    return error


def turns_back(interval: Interval, problem: Problem) -> Unsolvable:
    """The time of a motion that comes back on its way, which is told for one way only."""
    span = next((state.span for state in problem.states if state.name == interval.end), None)
    message = f"the motion turns back from `{interval.start}` to `{interval.end}`: its time is not solved as a whole"
    return unsolvable(problem, message, span, "name the turning point as a state, such as `{block.velocity: 0}`")


PLACES_TOLD = ("angle", "position", "displacement", "tilt")
RATES_TOLD = ("angular_velocity", "velocity", "speed", "nutation")
ACROSS = "give it a `shape`, or all of its moments: `inertia: {principal: [Ix, Iy, Iz]}`"
LINE_OR_EVENT = "give it a line, or an event that leads to it"
FEW = 24  # unknowns of a question for which help is tried: of more, a line or two seldom is enough
MANY = 6  # unknowns that a message names one by one
FORCES = ("force", "tension", "normal_force", "friction_force", "impulse", "torque")
TIME_IN_LETTERS = "ask for it at a state whose time is a letter: `end: {time: t1}`"
APART = "the laws can not tell these forces apart: leave out a support, or give one of them"


def no_answer(error: NoAnswer, search: Search, find: Find) -> Unsolvable:
    """What is missing or contradictory for one question."""
    problem = search.scene.configuration.problem
    if error.equation is not None:
        return with_way(contradicted(search.planner.pool[error.equation], search.scene, find.span), search)
    alone = "" if NEWTON in search.families else f" by {FAMILIES[search.families[0]].words} alone"
    missing = [] if error.shortage is None else open_quantities(error.shortage.unknowns, search.scene)
    if other := law_that_gives(find, search) if search.thorough else "":
        reason = why_uncovered(search.families[0], find, search.scene)
        message = f"{FAMILIES[search.families[0]].words} alone can not tell `{find.name}`{reason}"
        return unsolvable(problem, message, find.span, other)
    if error.open_form and str(error) != ENTANGLED:
        return unsolvable(problem, f"`{find.name}` can not be found{alone}: {error}", find.span, CHECK_DATA)
    if (fault := search.scene.unwritten_law()) is not None:
        return unsolvable(problem, fault.message, fault.span or find.span, fault.help)
    if str(error) == ENTANGLED and (way := way_out(find, problem)):  # as many equations as unknowns: nothing is missing
        message = f"`{find.name}` is not solved by these laws: {ENTANGLED} in its equations"
        return unsolvable(problem, message, find.span, way, kind=UNSOLVED)
    if error.shortage is None or not missing:
        help = suggestion((), search, find)
        message = f"too little is known to find `{find.name}`{alone}"
        return unsolvable(problem, message, find.span, help, kind=INCOMPLETE)
    if (name := inertia_untold(error.shortage.unknowns, search)) is not None:
        message = f"too little is known to find `{find.name}`{alone}: nothing tells the moment of inertia of `{name}` across its axis"
        return unsolvable(problem, message, find.span, ACROSS, kind=INCOMPLETE)
    if find.runs and moved_by_place(search.scene) is not None:
        return by_time_in_letters(search.scene, find)
    pool = [search.planner.pool[index] for index in error.shortage.equations]
    laws = [law for law in pool if law.law.words and not any(key_of(name).kind == ASKED for name in law.symbols())]
    counted = f"{plural(len(laws), 'equation')} for {plural(len(missing), 'unknown')}"
    counted = counted if len(laws) < len(missing) else "nothing settles"
    message = f"too little is known to find `{find.name}`{alone}: {counted}: {unknowns_listed(missing, search.scene)}"
    help = suggestion(missing, search, find, error.shortage.asked)
    return unsolvable(problem, message, find.span, help, kind=INCOMPLETE)


def by_time_in_letters(scene: SceneEquations, find: Find) -> Unsolvable:
    """A motion whose acceleration goes by the place or the speed, of which something is asked at any time."""
    message = f"the motion of `{moved_by_place(scene)}` as a function of time is not solved yet"
    return unsolvable(scene.configuration.problem, message, find.span, TIME_IN_LETTERS, kind=UNSOLVED)


def moved_by_place(scene: SceneEquations) -> str | None:
    """A body whose acceleration goes by its place or speed."""
    travels = (travel for over in scene.passages.values() for travel in over.travels if travel.given not in (0, 1))
    return next((travel.body for travel in travels if travel.pace not in (CONSTANT, TIME)), None)


def inertia_untold(unknowns: Iterable[str], search: Search) -> str | None:
    """A body of which the scene tells the moment of inertia about its axis alone, where equations link the one across it to what lacks."""
    quantities = search.scene.registry.quantities
    across = {
        key: item.owner for key, item in quantities.items() if item.kind == "inertia" and item.component == ACROSS_AXIS
    }
    reached, linked = set[str](), set(unknowns) if across else set[str]()
    while linked - reached:
        reached |= linked
        laws = (law.symbols() for law in search.planner.pool)
        linked = {name for letters in laws if letters & reached for name in letters if name in quantities}
    return next((owner for key, owner in across.items() if key in reached), None)


def way_out(find: Find, problem: Problem) -> str:
    """What to do where equations of several letters that are sought, or of a quantity under a condition, are not solved; else ''."""
    sought = sorted(problem.sought | ({find.seeks} if find.seeks else set()))
    if len(sought) > 1:
        return f"tell all but one of {', '.join(f'`{name}`' for name in sought)}"
    return "say the condition as a line of a state" if find.where is not None and not find.seeks else ""


def law_that_gives(find: Find, search: Search) -> str:
    """Which law gives what the law asked for does not; nothing where none does, or all were tried."""
    from rotsolve.search.proposals import has_answer

    if search.families == families_for(None):
        return ""
    for law in families_for(None):
        if (
            law in FAMILIES
            and law not in search.families
            and has_answer(find, search.another(families_for(law), spare=True, confirming=True))
        ):
            return f"{FAMILIES[law].words} gives it: say `--law {law}`, or leave `--law` out"
    whole = has_answer(find, search.another(families_for(None), confirming=True))
    return "it takes more than one law: leave `--law` out" if whole else ""


def open_quantities(names: Iterable[str], scene: SceneEquations) -> list[SceneQuantity | str]:
    """The unknowns that the scene has words for: quantities of the laws, and letters that it asks for."""
    quantities = scene.registry.quantities
    asked = scene.configuration.problem.sought
    return list(dict.fromkeys(quantities.get(name, name) for name in names if name in quantities or name in asked))


def unknowns_listed(missing: Sequence[SceneQuantity | str], scene: SceneEquations) -> str:
    """What the unknowns are; of many only the first few."""
    told = [told_quantity(item, scene) if isinstance(item, SceneQuantity) else f"`{item}`" for item in missing]
    told = list(dict.fromkeys(told))
    more = f" and {len(told) - MANY} more" if len(told) > MANY else ""
    return ", ".join(told[:MANY]) + more


def told_quantity(quantity: SceneQuantity, scene: SceneEquations) -> str:
    """A quantity of the laws in the scene's words: "tension of cord at held"."""
    at_cut = quantity.kind in INSIDE  # the index is that of the cut, no direction
    owner = f" of {spoken(quantity.owner)}" if quantity.owner else ""
    component = "" if at_cut else quantity.component
    words = in_direction(f"{spoken(quantity.kind)}{owner}", component, scene.configuration.problem.space)
    return f"{words}{when_words(quantity.when, scene)}"


def when_words(when: str, scene: SceneEquations) -> str:
    """When a quantity is, in words; nothing where the scene has one nameless instant."""
    name = real(when)
    timeline = scene.configuration.timeline
    if start := phase_midst(name):
        phase = timeline.phase_of(start)
        return f" on the way from {spoken(phase.start)} to {spoken(phase.end)}" if phase is not None else ""
    interval = timeline.interval(name)
    if interval is None:
        return f" at {spoken(name)}" if name else ""
    if interval.event is not None:
        return f" in {spoken(name)}"
    return f" from {spoken(interval.start)} to {spoken(interval.end)}"


def suggestion(missing: Sequence[SceneQuantity | str], search: Search, find: Find, asked: str = "") -> str:
    """What to add to the scene; never what is asked, and of states only what leads on."""
    scene = search.scene
    if scene.configuration.problem.space:
        return suggestion_in_space(missing, find, scene)
    lonely = unreached(scene)
    if lonely:
        return f"nothing tells when `{lonely}` is reached: {LINE_OR_EVENT}"
    unplaced = without_angle(scene)
    if unplaced:
        return f"nothing tells where `{unplaced[0]}` is at `{unplaced[1]}`: give `{unplaced[0]}.angle`"
    quantities = [item for item in missing if isinstance(item, SceneQuantity)]
    soft = {item.name for item in scene.configuration.problem.connections if getattr(item, "stiffness", ZERO) is None}
    spring = next((item.owner for item in quantities if item.kind == "force" and item.owner in soft), None)
    if spring is not None:
        return f"give the `stiffness` of `{spring}`, or its force"
    from rotsolve.search.proposals import TRIED, leads_on, proposals

    opened = any(
        state.opened for state in scene.configuration.timeline.states
    )  # then the scene has said enough to follow it
    worth = search.thorough and not opened and search.families == families_for(None) and len(quantities) <= FEW
    for proposal in islice(proposals(quantities, scene, asked), TRIED if worth else 0):
        if search.ground is None or search.ground.helps_left == 0:
            break
        search.ground.helps_left -= 1
        if leads_on(proposal, scene, find, search.families):
            return proposal.words
    if quantities and all(item.kind in FORCES for item in quantities):
        return APART
    return "say more: sizes and masses, where each body is at each state, how fast it moves"


def suggestion_in_space(missing: Sequence[SceneQuantity | str], find: Find, scene: SceneEquations) -> str:
    """What to add to a scene in space: the velocity without which a kinetic energy is that of the rotation alone, where only that lacks;
    what a state says of a joint that should be said of a body."""
    unread = (line.path for line in scene.unread_lines() if line.path is not None)
    joints = {item.name: item for item in scene.configuration.problem.connections}
    for path in unread:
        if path.owner in joints:
            body = joints[path.owner].touches()[-1].owner
            return f"nothing uses what a state says of `{path_text(path)}`: say it of a body, `{body}.{path.quantity}`"
    lacking = {(item.kind, item.owner) for item in missing if isinstance(item, SceneQuantity)}
    asked = [term.path for term in find.terms if term.path.quantity == "kinetic_energy" and not term.path.component]
    if asked and lacking == {("velocity", asked[0].owner)}:
        name = asked[0].owner
        return f"say `{name}.velocity: [2 m/s, 0 m/s, 0 m/s]`, or ask for `{name}.kinetic_energy.rotational`"
    if lacking and all(kind in (*FORCES, "pull") for kind, _ in lacking):
        return APART
    return "say more: how each body stands and turns at each state, what holds it, what acts on it"


def unreached(scene: SceneEquations) -> str:
    """A state of the scene after the first of which nothing is said and to which no event leads."""
    timeline = scene.configuration.timeline
    for interval in timeline.intervals:
        end = timeline.state(interval.end)
        if interval.event is None and not end.conditions and not end.balance and end.name != HEREAFTER:
            return end.name
    return ""


def without_angle(scene: SceneEquations) -> tuple[str, str] | None:
    """A body whose angle some state gives, and the first state, where no other one says it."""
    timeline = scene.configuration.timeline
    lines = [(state.name, line.path) for state in timeline.states for line in state.conditions]
    said = {(state, path.owner) for state, path in lines if path is not None and path.quantity == "angle"}
    first, after = timeline.states[0], timeline.after(timeline.states[0].name)
    said |= {(first.name, owner) for owner in on_unknown_profile(scene.configuration, first.name)}
    for _, owner in sorted(said):
        if (first.name, owner) not in said and first.name and (after is None or after.event is None):
            return owner, first.name
    return None


def on_unknown_profile(configuration: Configuration, state: str) -> set[str]:
    """Contacts whose body is on a track of which only heights are known, where no angle is to be told."""
    orbits = (configuration.orbit(body.name, state) for body in configuration.present(state))
    return {orbit.owner for orbit in orbits if orbit is not None and orbit.radius is None}


def plural(number: int, noun: str) -> str:
    return f"{number} {noun}" if number == 1 else f"{number} {noun}s"


def refuse_unsolved(search: Search, shortage: Shortage, find: Find) -> None:
    """Refuse by name what is no lack of data: motion that varies with several things, the time of one that varies with the place."""
    problem = search.scene.configuration.problem
    travels = [travel for passage in search.scene.passages.values() for travel in passage.travels]
    several = next((travel.body for travel in travels if travel.pace == MIXED), "")
    if several:
        from rotsolve.questions.forced import forced_swings

        if (forced := forced_swings(find, search.scene.configuration)) is not None:
            raise unsolvable(problem, str(forced), find.span, help=forced.help, kind=UNSOLVED)
        message = f"`{several}` is driven by what varies with more than one of time, place and speed: not solved yet"
        raise unsolvable(problem, message, find.span, kind=UNSOLVED)
    quantities = search.scene.registry.quantities
    open_ = {quantities[name].kind for name in shortage.unknowns if name in quantities}
    driven = next((travel.body for travel in travels if travel.pace == POSITION and not travel.leads), "")
    if driven and open_ == {"time"}:
        message = f"how long `{driven}` takes is not solved yet, since what drives it varies with its place"
        raise unsolvable(problem, message, find.span, kind=UNSOLVED)
