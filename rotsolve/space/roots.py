"""Roots in space: which of several steady motions is meant. Where nothing tells, the question is refused by name."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import ZERO, Formula, Symbol, add, multiply, negate, sqrt
from rotsolve.core.faults import NoSteadyMotion, Unsolvable
from rotsolve.core.symbols import SymbolKey, is_key, is_quantity, key_of
from rotsolve.core.vectors.heading import heading
from rotsolve.language.problem import EXTREMES, Problem
from rotsolve.solver.steps import PickedRoot
from rotsolve.space.sliding import slid_to

if TYPE_CHECKING:
    from rotsolve.equations.scene_equations import SceneEquations
    from rotsolve.search.numbers import Numbers
    from rotsolve.space.laws import SpaceLaws
    from rotsolve.space.moment import SpaceMoment

SMALL = 1e-12
PLACE = "place"  # of a body on a slide
TURNED = {"angular_velocity": "angle", "nutation": "tilt"}  # rates, each with how far the body is turned by it
SIGNED = ("angular_velocity", "velocity", "nutation", "spin", "axial_rate")  # rates that tell by their signs which way
COMES_BACK = {"largest": -1, "smallest": 1}  # the sense in which a body turns from where it has turned farthest
SEVERAL = "two steady motions are possible, and nothing tells which is meant"
HELP = "ask for the `smallest` or `largest` of it, one of them in a scene, or say it in the state: `{}.precession: smallest`"


def chosen(
    name: str, roots: Sequence[Formula], scene: SceneEquations, numbers: Numbers, period: Formula | None = None
) -> PickedRoot | None:
    """The root that the scene asks for by `smallest` or `largest`, or the only real one; None where the ordinary choice may go on.

    A `period` later the equation holds again.
    """
    from rotsolve.space.steady import of_steady, steady_letter

    key = key_of(name)
    sought = steady_letter(name, scene)
    if sought is not None:
        return of_steady(sought, roots, scene, numbers, period)
    if len(roots) > 1 and (told := rate_told_by(name, scene)) is not None:
        refuse_either_sense(told, roots, scene, numbers, f"write `smallest {name}` or `largest {name}` under `find`")
    if key.kind == "tilt":
        return tilted(name, roots, scene, numbers)
    if turned_through(key, scene) and len(roots) > 1:
        return first_there(name, roots, scene, numbers)
    if key.kind in SIGNED and len(roots) > 1:
        refuse_either_sense(name, roots, scene, numbers)
    if key.kind != "precession":
        return None
    real = [index for index, root in enumerate(roots) if numbers.of(root) is not None]
    if not real:
        refuse_too_slow(key.owner, key.when, scene, numbers)
        refuse_unnumbered(key.owner, key.when, roots, scene, numbers)
        return None
    if len(real) == 1 or all(numbers.side(roots[index] - roots[real[0]]) == 0 for index in real[1:]):
        return PickedRoot(real[0])
    place, least = extreme_of(name, [roots[k] for k in real], scene, numbers)
    return PickedRoot(real[place], (f"the {'smaller' if least else 'larger'} of both",))


def extreme_of(name: str, roots: Sequence[Formula], scene: SceneEquations, numbers: Numbers) -> tuple[int, bool]:
    """Which rate of precession is asked for, and whether it is the smallest: a letter may be so where the rate is the larger."""
    key, worth = key_of(name), Symbol(name)
    word = key.component if key.component in EXTREMES else word_told(key.owner, key.when, scene)
    found: tuple[str, Formula] = (word, worth) if word else extreme_asked(name, scene, numbers)
    if not found[0]:
        problem, span = scene.configuration.problem, scene.configuration.timeline.state(key.when).span
        raise Unsolvable(SEVERAL, span=span, help=HELP.format(key.owner), lines=problem.lines, file=problem.file)
    sign = -1 if found[0] == "largest" else 1
    place = numbers.least([sign * found[1].substitute({name: root}) for root in roots])
    return place, place == numbers.least(roots)


def extreme_asked(name: str, scene: SceneEquations, numbers: Numbers) -> tuple[str, Formula]:
    """`smallest` or `largest`, as a question has it for a letter of the scene that hangs on a rate, with what that is by it; '' where
    none, or more than one, is asked."""
    asked = {given.name for given in scene.configuration.problem.givens if given.asked}
    found: dict[tuple[str, Formula], None] = {}
    for find in scene.configuration.problem.finds:
        if find.modifier in EXTREMES and isinstance(find.formula, Symbol) and find.formula.name in asked:
            worth = numbers.with_answers(find.formula)
            if name in worth.symbols():
                found[find.modifier, worth] = None
    return next(iter(found)) if len(found) == 1 else ("", Symbol(name))


def refuse_unnumbered(
    owner: str, state: str, roots: Sequence[Formula], scene: SceneEquations, numbers: Numbers
) -> None:
    """Refuse one of two steady precessions while a letter runs over its range: which is the smaller one may change on the way."""
    lacking = sorted({name for root in roots for name in numbers.signs.lacking(root)} - numbers.signs.trials.keys())
    if len(roots) < 2 or not lacking:
        return
    problem, span = scene.configuration.problem, scene.configuration.timeline.state(state).span
    message = (
        f"which of two steady precessions of `{owner}` is meant hangs on `{lacking[0]}`, over which it is looked at"
    )
    help = f"give `{lacking[0]}` a number, and ask for `smallest {owner}.precession` or `largest {owner}.precession`"
    raise Unsolvable(message, span=span, help=help, lines=problem.lines, file=problem.file)


def refuse_too_slow(owner: str, state: str, scene: SceneEquations, numbers: Numbers) -> None:
    """Refuse a steady precession that is none, since the body spins too slowly, with the least spin that allows one."""
    limit = scene.steady_limit(owner, state)  # type: ignore[attr-defined]
    spelled = scene.tensors.spelled  # type: ignore[attr-defined]
    if limit is None:
        return
    own, least = (numbers.of(spelled(side)) for side in (limit.left, limit.right))
    if own is None or least is None or own >= least:
        return
    problem, laws = scene.configuration.problem, scene.dynamics[state]  # type: ignore[attr-defined]
    span = scene.configuration.timeline.state(state).span
    message, help = f"`{owner}` spins too slowly for a steady precession at `{state}`", ""
    if on_pivot(owner, laws):
        from rotsolve.space.swings import top_of

        axial, across, lift = map(spelled, top_of(laws, owner))
        spin = laws.moment.told(owner, "spin") is not None
        felt = multiply(
            multiply(add(across, negate(axial)) if spin else across, lift),
            heading(laws.moment.nodding(owner).angles[1]).cos(),
        )
        form = "I₃ ψ̇ ≥ 2 √((I₁ − I₃) M g l cos θ)" if spin else "I₃ ω₃ ≥ 2 √(I₁ M g l cos θ)"
        if laws.moment.held.vanishes(axial):
            message = f"`{owner}` has no steady precession at `{state}`: its weight turns it away from the vertical, and it is thin"
        else:
            rate = numbers.signs.number(
                2 * sqrt(felt) / axial
            )  # of letters none: it would be that of the case that is tried
            help = f"it needs {form}" + (f", at least {rate.float:.4g} rad/s" if rate is not None else "")
    raise NoSteadyMotion(message, span=span, help=help, lines=problem.lines, file=problem.file)


def on_pivot(owner: str, laws: SpaceLaws) -> bool:
    """Whether a body is held at a fixed point, where nothing but its weight acts on it."""
    from rotsolve.space.passing import left_alone

    joint = laws.moment.held.main(owner)
    return joint is not None and joint.free and laws.fixed(owner) and left_alone(laws, owner)


def refuse_level_unspun(owner: str, laws: SpaceLaws, problem: Problem) -> None:
    """Refuse a level body, if it is on a fixed point and does not spin: however it precesses, nothing keeps its axis from falling."""
    moment, held = laws.moment, laws.moment.held
    if not on_pivot(owner, laws) or held.axis(owner) is None:
        return
    from rotsolve.space.swings import top_of

    axial, _, lift = map(laws.tensors.spelled, top_of(laws, owner))
    told = next((rate for word in ("spin", "axial_rate") if (rate := moment.told(owner, word)) is not None), None)
    if not (held.vanishes(axial) or (told is not None and held.vanishes(told))) or held.vanishes(lift):
        return
    message = f"`{owner}` is level at `{moment.when}` and does not spin: it has no steady precession there"
    help = "" if held.vanishes(axial) else "with whatever spin it precesses at φ̇ = M g l/(I₃ ω₃): none is the least"
    raise NoSteadyMotion(message, span=moment.state.span, help=help, lines=problem.lines, file=problem.file)


def turned_through(key: SymbolKey, scene: SceneEquations) -> str:
    """How far a body is turned by a rate; the spin of a rotor on an axle turns it by its angle, as a hinge does; that of a slide has its
    place on that. '' of other quantities."""
    if key.component:
        return PLACE if (key.kind, key.component) == ("velocity", "sliding") else ""
    if key.kind != "spin":
        return TURNED.get(key.kind, "")
    joint = scene.held.main(key.owner)  # type: ignore[attr-defined]
    return "angle" if joint is not None and joint.aligned else ""


def first_there(name: str, roots: Sequence[Formula], scene: SceneEquations, numbers: Numbers) -> PickedRoot | None:
    """The rate with which a body comes to an angle or a tilt the first time: towards it from where it was, whatever it did between."""
    key = key_of(name)
    owner, state, word = key.owner, key.when, turned_through(key, scene)
    before = scene.configuration.timeline.before(state)
    if before is None or before.event is not None:
        refuse_either_sense(name, roots, scene, numbers)
        return None
    moments = [scene.dynamics[name].moment for name in (before.start, state)]  # type: ignore[attr-defined]
    first, last = stood_at(owner, word, moments)
    line = moments[0].line(owner, word)
    from_end = 0 if line is None else COMES_BACK.get(line.word or "", 0)
    if last is None or (first is None and not from_end):
        beside = told_beside(name, roots, scene, numbers)
        if beside is None:
            refuse_either_sense(name, roots, scene, numbers)
        return beside
    problem, span = scene.configuration.problem, scene.configuration.timeline.state(state).span
    side = from_end or (numbers.side(add(last, negate(first))) if first is not None else None)
    if not side:
        joint = scene.held.joint(owner)  # type: ignore[attr-defined]
        body, way = (joint.body.owner, "goes") if word == PLACE else (owner, "turns")
        words = "its letters do not tell" if side is None else f"nothing tells: its {word} is that from which it comes"
        message, help = (
            f"in which sense `{body}` {way} at `{state}` {words}",
            f"tell its `{owner}.{word}` at both states",
        )
        help = "ask for its `speed`" if word == PLACE else help
        raise Unsolvable(message, span=span, help=help, lines=problem.lines, file=problem.file)
    fitting = [index for index, root in enumerate(roots) if sense_of(root, numbers) == side]
    if not fitting and any(given.asked and given.name in roots[0].symbols() for given in problem.givens):
        refuse_either_sense(name, roots, scene, numbers)
        return None
    return (
        PickedRoot(fitting[0], (f"towards its {word}, to which it comes the first time",))
        if len(fitting) == 1
        else None
    )


def told_beside(name: str, roots: Sequence[Formula], scene: SceneEquations, numbers: Numbers) -> PickedRoot | None:
    """The root with which another body, whose rate hangs on it, comes the first time to where its state has it."""
    for other, quantity in list(scene.registry.quantities.items()):
        key = key_of(other)
        if other == name or quantity.when != key_of(name).when or not turned_through(key, scene):
            continue
        by_root = numbers.with_answers(Symbol(other))
        moment = scene.dynamics[quantity.when].moment  # type: ignore[attr-defined]
        if name in by_root.symbols() and moment.told(key.owner, turned_through(key, scene)) is not None:
            return first_there(other, [by_root.substitute({name: root}) for root in roots], scene, numbers)
    return None


def stood_at(owner: str, word: str, moments: Sequence[SpaceMoment]) -> tuple[Formula | None, Formula | None]:
    """How a body stands at the first and the last of two moments, as far as they tell; where it is on a slide."""
    if word != PLACE:
        return moments[0].stood(owner, word), moments[1].told(owner, word)
    joint = moments[0].held.joint(owner)
    assert joint is not None
    return (slid_to(joint, moments[0]) if moments[0].later else ZERO), slid_to(joint, moments[1])


def sense_of(root: Formula, numbers: Numbers) -> int | None:
    """The sign of a root, by numbers or, where what it hangs on has none yet, by its letters."""
    side = numbers.side(root)
    return numbers.signs.by_letters(root) if side is None and any(map(is_key, root.symbols())) else side


def refuse_either_sense(
    name: str, roots: Sequence[Formula], scene: SceneEquations, numbers: Numbers, help: str = ""
) -> None:
    """Refuse a rate that fits with either sign, as that with which a body leaves a blow of unknown size: what follows hangs on it."""
    sides = {numbers.side(root) for root in roots}
    opposite = any(is_zero(add(roots[0], root)) for root in roots[1:])
    if not ({1, -1} <= sides or (opposite and numbers.signs.lacking(roots[0]))) or numbers.unreal(roots[0]):
        return  # also where the motion does not come to that
    key, problem = key_of(name), scene.configuration.problem
    joints = scene.dynamics[key.when].moment.held.joints  # type: ignore[attr-defined]
    owner = next(
        (joint.body.owner for joint in joints if joint.owner == key.owner), key.owner
    )  # a slide has its own rate
    way = "goes" if key.kind == "velocity" else "turns"
    message = f"in which sense `{owner}` {way} at `{key.when}` nothing tells"
    help = help or f"tell `{owner}.{key.kind}` there, or what it hangs on{by_sought_rate(owner, key, problem)}"
    span = scene.configuration.timeline.state(key.when).span
    raise Unsolvable(message, span=span, help=help, lines=problem.lines, file=problem.file)


def by_sought_rate(owner: str, key: SymbolKey, problem: Problem) -> str:
    """How to ask for either sense of the rate of a body on a hinge: by a letter of the scene; '' of other rates."""
    letter = f"w_{owner}"
    taken = {given.name for given in problem.givens} | {find.name for find in problem.finds}
    if key.kind != "angular_velocity" or key.component or letter in taken:
        return ""
    line = f"`{owner}.{key.kind}: {letter}`, `{letter}: unknown` under `given`"
    return f"; or write {line}, and `smallest {letter}` or `largest {letter}` under `find`"


def rate_told_by(name: str, scene: SceneEquations, *, components: bool = False) -> str | None:
    """The rate, perhaps a component of one, that a state tells by a letter alone of which no largest or smallest value is asked; None of
    other letters."""
    problem, asked = scene.configuration.problem, Symbol(name)
    if any(find.modifier in EXTREMES for find in problem.finds if find.formula == asked):
        return None
    for state in problem.states:
        for line in state.conditions:
            if line.path is None or (line.path.component is not None and not components):
                continue
            if line.value == asked and line.path.quantity in SIGNED:
                return SymbolKey(line.path.quantity, line.path.owner, "", state.name).name
    return None


def way_on_hinge(name: str, scene: SceneEquations, numbers: Numbers) -> tuple[Formula, int] | None:
    """From where a letter by which a state tells the angle of a body on a hinge is come to, and which way; None of all else.

    To a later state that is from the one before; to one before, backwards in time, from that which follows.
    """
    timeline = scene.configuration.timeline
    phases = [interval for interval in timeline.intervals if interval.event is None]
    setting = partial(setting_out, scene=scene)
    ways = [(phase.start, phase.end, setting) for phase in phases]
    for origin, end, going in ways + [(phase.end, phase.start, going_back) for phase in phases]:
        for line in timeline.state(end).conditions:
            path, told = line.path, line.value
            if path is None or told is None or path.quantity != "angle" or name not in told.symbols():
                continue
            first, last = (scene.dynamics[state].moment for state in (origin, end))  # type: ignore[attr-defined]
            slope, start = differentiate(told, name), first.stood(path.owner, "angle")
            way = 0 if start is None or name in start.symbols() else going(path.owner, first, last, numbers)
            if way and start is not None and numbers.side(slope**2 - 1) == 0:
                return (start - told.substitute({name: ZERO})) / slope, way * (numbers.side(slope) or 0)
    return None


def going_back(owner: str, last: SpaceMoment, before: SpaceMoment, numbers: Numbers) -> int:
    """Which way a body on a hinge goes backwards in time from a state in which its rate is told; 0 where it may have turned back before."""
    rates = [moment.told(owner, "angular_velocity") for moment in (before, last)]
    begun, ended = (None if rate is None else numbers.side(rate) for rate in rates)
    return -ended if ended and begun in (0, ended) else 0


def setting_out(owner: str, before: SpaceMoment, after: SpaceMoment, numbers: Numbers, scene: SceneEquations) -> int:
    """Which way a body on a hinge sets out: as it turns at first, else as it is pushed; 0 where nothing tells, or it comes back."""
    joint = before.held.main(owner)
    if joint is None or not joint.turning:
        return 0
    rate, faster = before.driven(owner, joint, "angular_velocity")
    way = coming_to(owner, before, scene, numbers) if is_quantity(rate) else 0
    way = way or numbers.sign((rate, numbers.push(faster)))
    told = after.told(owner, "angular_velocity")
    return 0 if told is not None and numbers.side(told) == -way else way


def coming_to(owner: str, there: SpaceMoment, scene: SceneEquations, numbers: Numbers) -> int:
    """Which way a body on a hinge comes to the angle of a later state the first time: that in which it is; 0 where nothing tells."""
    phase = scene.configuration.timeline.before(there.when)
    if phase is None or phase.event is not None:
        return 0
    moments = [scene.dynamics[phase.start].moment, there]  # type: ignore[attr-defined]
    first, last = stood_at(owner, "angle", moments)
    return 0 if first is None or last is None else numbers.side(add(last, negate(first))) or 0


def tilted(name: str, roots: Sequence[Formula], scene: SceneEquations, numbers: Numbers) -> PickedRoot | None:
    """The tilt that lies from 0 to 180°: of several the one that the state says, `smallest` or `largest`."""
    key = key_of(name)
    values = {index: value for index, root in enumerate(roots) if (value := numbers.of(root)) is not None}
    within = [index for index, value in values.items() if -SMALL < value < math.pi + SMALL]
    others = [index for index in within[1:] if numbers.side(roots[index] - roots[within[0]]) != 0]
    if not values and len(roots) > 1 and any(map(is_key, roots[0].symbols())):
        problem, span = scene.configuration.problem, scene.configuration.timeline.state(key.when).span
        message = f"which of several tilts of `{key.owner}` is meant at `{key.when}` hangs on what is not known yet"
        help = "tell what comes before in a scene of its own"
        names = [state.name for state in problem.states]
        if key.when in names[2:] and not problem.events:
            help = f"ask for it in a scene of its own, in which `{key.when}` follows `{names[0]}` with no state between"
        raise Unsolvable(message, span=span, help=help, lines=problem.lines, file=problem.file)
    if not values or (len(within) < 2 and len(values) < len(roots)):
        return PickedRoot(within[0], ("a tilt lies from 0 to 180°",)) if len(within) == 1 else None
    word = word_told(key.owner, key.when, scene, "tilt")
    problem, span = scene.configuration.problem, scene.configuration.timeline.state(key.when).span
    if not within or (others and word not in EXTREMES):
        message = f"several tilts of `{key.owner}` are possible at `{key.when}`, and nothing tells which is meant"
        help = f"say `{key.owner}.tilt: smallest` or `largest` there"
        if not within:
            message, help = f"`{key.owner}` has no tilt from 0 to 180° at `{key.when}`", "check what the states say"
        raise Unsolvable(message, span=span, help=help, lines=problem.lines, file=problem.file)
    sign = -1 if word == "largest" else 1
    index = within[numbers.least([sign * roots[k] for k in within])] if others else within[0]
    if word in EXTREMES and math.sin(values[index]) < SMALL:
        message = f"the axis of `{key.owner}` passes through the vertical on its way to `{key.when}`, and nods on there"
        help = "that is solved for its times alone; `rotsolve simulate` follows it"
        raise Unsolvable(message, span=span, help=help, lines=problem.lines, file=problem.file)
    if not others:
        return PickedRoot(within[0], ("a tilt lies from 0 to 180°",) if len(values) > 1 else ())
    return PickedRoot(index, (f"the {word} tilt",))


def word_told(owner: str, state: str, scene: SceneEquations, quantity: str = "precession") -> str:
    """What a state says of a quantity of a body: `smallest` or `largest`; '' where it does not."""
    for line in scene.configuration.timeline.state(state).conditions:
        if line.path is not None and (line.path.owner, line.path.quantity) == (owner, quantity) and line.word:
            return line.word
    return ""
