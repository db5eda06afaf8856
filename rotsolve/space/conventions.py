"""Conventions: along which axes components are told that are not those of space, where points are, what numbers make special."""

from __future__ import annotations

from collections.abc import Collection, Iterator
from typing import TYPE_CHECKING

from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import ONE, ZERO, Symbol
from rotsolve.core.derivation import Words, direction_in_words, in_a_row
from rotsolve.core.equation import BLOWS, RATES_OF_MOMENTUM, RULE, SECOND_LAW, TWISTS, Equation, Law
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.heading import heading
from rotsolve.core.vectors.triple import AS_DRAWN, NOTHING, Z, cross_product, triple, way_between
from rotsolve.core.writing import spoken
from rotsolve.language.bodies import Joint, PointRef
from rotsolve.language.problem import references
from rotsolve.space.attitude import IN_SPACE, NODE
from rotsolve.space.coincidences import coincidences
from rotsolve.space.laws import SpaceLaws
from rotsolve.space.two_balls import words_of_line

if TYPE_CHECKING:
    from rotsolve.algebra.formula import Formula
    from rotsolve.core.vectors.triple import Triple
    from rotsolve.space.moment import SpaceMoment
    from rotsolve.space.scene import SpaceEquations

IN_COMPONENTS = (*RATES_OF_MOMENTUM, SECOND_LAW, TWISTS, BLOWS)  # laws along the axes of a body
LONG = 40  # nodes of three directions in space beyond which they are not written out


def conventions(scene: SpaceEquations, used: Collection[Equation]) -> Iterator[Words]:
    """What the page says of signs: of each body the axes in which its laws are written."""
    for name in scene.held.order:
        yield from axes_of_body(scene, name, used)
        if turned_untold(scene, name):
            yield (f"ψ = 0 of {spoken(name)}, as nothing tells its spin angle",)
    for (name, _), gaps in scene.held.askew.items():
        yield (f"{spoken(name)} is not symmetric: ", *in_a_row([simplify(gap) for gap in gaps]), " ≠ 0")
    if scene.held.problem.gravity is None and any(one.law == SECOND_LAW for one in used):
        yield ("gravity is left out",)
    yield from way_of_weight(scene)
    yield from words_of_line(scene.held, used)
    yield from words_of_linkages(scene, used)
    yield from coincidences(scene.configuration.signs, scene.configuration.problem.givens)


def words_of_linkages(scene: SpaceEquations, used: Collection[Equation]) -> Iterator[Words]:
    """What the letters of the formulas stand for by which bars and universal joints tie motions together."""
    ruled = {one.bodies for one in used if one.law == RULE}
    for name in (name for name in scene.held.links if (name,) in ruled):
        first, last = (joint.body.point or "center" for joint in scene.held.link(name))
        yield (f"{spoken(name)}: r from {first} to {last}; v₁ and v₂ there; l is its length",)
    for item in scene.held.couplings:
        first, last = item.first.owner, item.second.owner
        if (first, last) in ruled:
            yield (
                f"{spoken(item.owner)}: c along its arm in {spoken(first)}; n₁ and n₂ along {spoken(first)} and {spoken(last)}",
            )


def way_of_weight(scene: SpaceEquations) -> Iterator[Words]:
    """With what the weight turns, or that it does not with a body about an axis that leans, of whose motion along that a scene speaks."""
    held, problem = scene.held, scene.held.problem
    if problem.gravity_in:
        yield (f"the weight goes along −z of {spoken(problem.gravity_in)}, and turns with it",)
        return
    terms = [(term.path, term.relative, term.axes) for find in problem.finds for term in find.terms]
    lines = [(line.path, line.relative, line.axes) for state in problem.states for line in state.conditions]
    spoken_of = dict[str, None]()
    for path, *frames in (*terms, *lines):
        free = path is not None and path.owner in held.bodies and not held.of_body(path.owner)
        if path is not None and free and problem.gravity is not None and held.mass(path.owner) != ZERO:
            spoken_of.update(dict.fromkeys(frame for frame in frames if frame))
    laws = next(iter(scene.dynamics.values()))
    for name in spoken_of:
        joint = held.main(name) if name in held.bodies else None
        if joint is not None and joint.drive and not upright_axis(laws.moment, name, joint):
            cure = f"gravity: {{in: {name}}} turns it"
            yield (f"the weight stays along z in space: it does not turn with {spoken(name)} ({cure})",)


def upright_axis(moment: SpaceMoment, name: str, joint: Joint) -> bool:
    """Whether the axis of a hinge is vertical, or nothing tells how it stands."""
    way = moment.axes(name).to(IN_SPACE, moment.direction(name, joint))
    return bool(moment.axes(name).lost) or all(map(moment.held.vanishes, way[:2]))


def axes_of_body(scene: SpaceEquations, name: str, used: Collection[Equation]) -> Iterator[Words]:
    """The axes in which the laws of a body are written."""
    if any(kind_of_axes(laws, name) == NODE for laws in scene.dynamics.values()):
        if fast := carried_round_by_precession(scene, name, used):
            yield fast
            return
        told = "e₃ along its axis, e₁ level along the line of nodes, e₂ = e₃ × e₁"
        turning = "turning at Ω = θ̇ e₁ + φ̇ sin θ e₂ + φ̇ cos θ e₃"
        rates = nodal_rates(scene, name, used)
        yield (f"axes of {spoken(name)}: {told}, {turning}", *rates, "; x lies along e₁ where φ is not told")
        return
    lies = standing_axes(scene, name) if law_is_used(IN_COMPONENTS, name, used) else ()
    turns = turning_axes(scene, name) if law_is_used(RATES_OF_MOMENTUM, name, used) else ()
    if lies or turns:
        yield (f"axes of {spoken(name)}: ", *lies, *((", ",) if lies and turns else ()), *turns)


def carried_round_by_precession(scene: SpaceEquations, name: str, used: Collection[Equation]) -> Words:
    """The argument for a top that spins fast and precesses steadily, in place of its axes; nothing of all others."""
    if not all(laws.goes_round_fast(name) for laws in scene.dynamics.values()):
        return ()
    turning = {laws.moment.nodding(name) for laws in scene.dynamics.values()}
    if len(turning) != 1:
        return ()
    (one,) = turning
    rate, sine = one.rates[0], heading(one.angles[1]).sin()
    told = (item for item in used if item.law in RATES_OF_MOMENTUM and item.bodies == (name,))
    sizes = {} if is_zero(sine) else {simplify(item.right / (rate * sine)): item.left for item in told}
    # the law along e₁ is the one that says Ω times a level part in which Ω is not
    size = next((size for size in sizes if size != ZERO and not size.symbols() & rate.symbols()), None)
    level = Symbol("L") * sine
    return (
        "the spin is fast, so L",
        *(() if size is None else (" = ", scene.in_order(size))),
        f" lies along the axis of {spoken(name)}; ",
        *(("it",) if sine == ONE else ("its level part ", level)),
        " goes round with the axis at ",
        rate,
        " and so changes by ",
        rate * level,
        " per second",
        *(() if size is None else (": that is the torque ", sizes[size])),
    )


def nodal_rates(scene: SpaceEquations, name: str, used: Collection[Equation]) -> Words:
    """What θ̇ and φ̇ are, where all states have the same: ", θ̇ = 0 and φ̇ = Ω"."""
    rates = {laws.moment.nodding(name).rates[:2] for laws in scene.dynamics.values() if laws.moment.nods(name)}
    if len(rates) != 1:
        return ()
    ((going_round, nutation),) = rates
    spoken_of = scene.given_dimensions.keys() | {letter for equation in used for letter in equation.symbols()}
    if not going_round.symbols() | nutation.symbols() <= spoken_of:
        return ()
    return (", θ̇ = ", nutation, " and φ̇ = ", going_round)


def kind_of_axes(laws: SpaceLaws, name: str) -> str:
    """The name of the axes of a body; '' where how it turns is not solved."""
    try:
        return laws.moment.axes(name).name
    except Unsolvable:
        return ""


def turned_untold(scene: SpaceEquations, name: str) -> bool:
    """Whether nothing tells how far a body that stands by its Euler angles has turned about its axis at first, and that is seen: it is not
    the same all round, or a point beside its axis is spoken of."""
    moment = next((laws.moment for laws in scene.dynamics.values() if laws.moment.nods(name)), None)
    if moment is None or moment.told(name, "spin_angle") is not None:
        return False
    axis = scene.held.axis(name)
    if axis is None:
        return False
    beside = (part for _, place in spots_of(name, scene) for part in cross_product(axis, place))
    return not scene.held.turns_round(name, axis) or any(part != ZERO and simplify(part) != ZERO for part in beside)


def law_is_used(laws: tuple[Law, ...], name: str, used: Collection[Equation]) -> bool:
    """Whether some of these laws are used of a body."""
    return any(one.law in laws and one.bodies == (name,) for one in used)


def turning_axes(scene: SpaceEquations, name: str) -> Words:
    """How the axes turn in which the law of rotation of a body is written, where they do so in one way that the scene tells."""
    rates = {laws.moment.axes(name).rate for laws in scene.dynamics.values() if name not in laws.unwritten}
    rate = rates.pop() if len(rates) == 1 else NOTHING
    if rate == NOTHING or not all(part.symbols() <= scene.given_dimensions.keys() for part in rate):
        return ()
    return ("turning at Ω = (", *in_a_row(map(scene.in_order, rate)), ") in their own components")


def standing_axes(scene: SpaceEquations, name: str) -> Words:
    """Along which directions in space the axes of a body lie, where these are others than those of space; where they are too long to be
    written out or not the same at all states, that these are its own."""
    if not all(kind_of_axes(laws, name) for laws in scene.dynamics.values()):
        return ()
    axes = [laws.moment.axes(name) for laws in scene.dynamics.values()]
    if any(one.lost for one in axes) or (stands := {one.rows for one in axes}) == {AS_DRAWN}:
        return ()
    ways = [triple(column) for column in zip(*axes[0].rows, strict=True)]  # of its own x, y and z
    if len(stands) > 1 or sum(length(part) for way in ways for part in way) > LONG:
        return ("its own, not those of space",)
    told = [direction_in_words(way) for way in ways]
    return ("along ", *told[0], ", ", *told[1], " and ", *told[2], " in space")


def placed_points(scene: SpaceEquations) -> Iterator[Words]:
    """Where the points of bodies are of which a scene speaks, from the centre of mass along the axes of the body; and two bearings."""
    for name in scene.held.bodies:
        spots = {spoken(ref.point or ""): place for ref, place in spots_of(name, scene)}
        if not spots or sum(length(part) for place in spots.values() for part in place) > LONG:
            continue
        told: list[str | Formula] = []
        along = name in scene.held.nodding and scene.held.axis(name) == Z
        if along and all(place[:2] == (ZERO, ZERO) for place in spots.values()):
            for point, place in spots.items():
                told += [f"{', ' if told else ''}{point} at ", scene.in_order(place[2])]
            yield (f"on {spoken(name)}, from its centre of mass along its axis: ", *told)
            continue
        for point, place in spots.items():
            told += [f"{', ' if told else ''}{point} (", *in_a_row(map(scene.in_order, place)), ")"]
        yield (f"on {spoken(name)}, from its centre of mass along its own axes: ", *told)
    for joint in scene.held.joints:
        if joint.bearings:
            way = joint.turning[0] if joint.turning else NOTHING
            yield (
                f"bearings of {spoken(joint.owner)} at ",
                *in_a_row(joint.bearings),
                " along ",
                *direction_in_words(way),
            )


def spots_of(name: str, scene: SpaceEquations) -> Iterator[tuple[PointRef, Triple]]:
    """The points of a body of which a scene speaks, but its centres, with their places from its centre of mass."""
    held, problem = scene.held, scene.held.problem
    said = references((problem.connections, problem.actions, problem.events, problem.states, problem.finds))
    for item in said:
        ref = item if isinstance(item, PointRef) else PointRef(item.owner, item.point, item.argument)
        if ref.owner != name or ref.point in (None, "center", "cm") or ref.argument is not None:
            continue
        try:
            place = way_between(held.centre(name), held.spot(ref))
        except Unsolvable:
            continue
        yield ref, triple([simplify(part) for part in place])
