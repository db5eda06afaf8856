"""Mistakes of space: with tensors, L and its rate in axes that turn, the precession of tops, and turns that do not commute."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, negate
from rotsolve.core.equation import RATES_OF_MOMENTUM, SECOND_LAW, Equation, Law
from rotsolve.core.passage import Alteration
from rotsolve.grading.mistakes.mistake import Change, Made, bodies_and_parts, each_and_all
from rotsolve.language.bodies import Turn
from rotsolve.language.problem import Body, Condition, Find, Problem, Term

if TYPE_CHECKING:
    from rotsolve.grading.mistakes.scene import Scene
    from rotsolve.grading.mistakes.space_laws import MistakenLaws

Turns = tuple[Turn, ...]
FAST = "fast spin"
ROOTS = {"smallest": "largest", "largest": "smallest"}
RATES_OF_SPIN = {"spin": "axial_rate", "axial_rate": "spin"}


def with_laws(scene: Scene, kind: str, words: str) -> Made:
    """Other laws for each body of a scene in space, then for all; `words` speak of {who}."""
    if not scene.problem.space:
        return
    from rotsolve.grading.mistakes import space_laws  # only a scene in space needs them

    laws: type[MistakenLaws] = getattr(space_laws, kind)
    for names, who in each_and_all(body.name for body in scene.problem.bodies):
        yield words.format(who=who), Change(altered=Alteration(in_space=laws.of(names)))


def opposite_products(scene: Scene) -> Made:
    """+Σ m x y for −Σ m x y."""
    return with_laws(scene, "OppositeProducts", "the products of inertia of {who} were given the wrong sign")


def unmoved_tensors(scene: Scene) -> Made:
    """I about the centre of mass, or as it is told, for I about another point."""
    words = "the inertia tensor of {who} was not moved to the point by the parallel-axes theorem"
    return with_laws(scene, "UnmovedTensor", words)


def moved_the_other_way(scene: Scene) -> Made:
    """I − M d² for I + M d²."""
    words = "M d² was taken away instead of added in the inertia tensor of {who}"
    return with_laws(scene, "MovedTheOtherWay", words)


def exchanged_moments(scene: Scene) -> Made:
    """I₁ for I₃ and I₃ for I₁."""
    words = "the moments of inertia of {who} about its axis and across it were exchanged"
    return with_laws(scene, "ExchangedMoments", words)


def momentum_along_rate(scene: Scene) -> Made:
    """L = I ω with one moment of inertia."""
    words = "the angular momentum of {who} was taken along its angular velocity"
    return with_laws(scene, "MomentumAlongRate", words)


def without_carrying(scene: Scene) -> Made:
    """dL/dt without Ω × L."""
    words = "Ω × L was left out for {who}, as if its inertia tensor and its axes stayed the same in space"
    return with_laws(scene, "WithoutCarrying", words)


def opposite_torque(scene: Scene) -> Made:
    """−Στ = dL/dt: what the body does to its bearings for what they do to it, or r × F the wrong way round."""
    if scene.problem.space:
        for names, who in each_and_all(body.name for body in scene.problem.bodies):
            altered = Alteration(equation=side_changed(RATES_OF_MOMENTUM, names, torque=True))
            yield f"the torque on {who} was given the wrong sense", Change(altered=altered)


def centre_kept(scene: Scene) -> Made:
    """Σ F = 0 for Σ F = m a."""
    if scene.problem.space:
        for names, who in each_and_all(body.name for body in scene.problem.bodies):
            altered = Alteration(equation=side_changed((SECOND_LAW,), names, torque=False))
            yield f"the acceleration of the centre of mass of {who} was left out", Change(altered=altered)


def side_changed(laws: Collection[Law], names: Collection[str], *, torque: bool) -> Callable[[Equation], Equation]:
    """A law of some bodies with its left side, the torque, the other way, or with nothing on its right side."""

    def changed(equation: Equation) -> Equation:
        if equation.law not in laws or not set(equation.bodies) <= set(names):
            return equation
        return replace(equation, left=negate(equation.left)) if torque else replace(equation, right=ZERO)

    return changed


# tops


def spin_for_axial_rate(scene: Scene) -> Made:
    """ψ̇ for ω₃ = ψ̇ + φ̇ cos θ, and the other way round."""
    if not scene.problem.space:
        return
    lines = [line for state in scene.problem.states for line in state.conditions if line.path is not None]
    told = {line.path.quantity for line in lines if line.path is not None}
    if "axial_rate" in told:
        yield "ω₃ was taken for the spin ψ̇", Change(problem=with_lines(exchanged_rates))
    elif "spin" in told:
        yield "the spin ψ̇ was taken for ω₃", Change(problem=with_lines(exchanged_rates))


def exchanged_rates(line: Condition) -> Condition:
    path = line.path
    if path is None or path.quantity not in RATES_OF_SPIN:
        return line
    return replace(line, path=replace(path, quantity=RATES_OF_SPIN[path.quantity]))


def with_lines(change: Callable[[Condition], Condition]) -> Callable[[Problem], Problem]:
    """The scene with other lines in its states."""

    def changed(problem: Problem) -> Problem:
        states = (replace(state, conditions=tuple(map(change, state.conditions))) for state in problem.states)
        return replace(problem, states=tuple(states))

    return changed


def fast_top(scene: Scene) -> Made:
    """M g l = I₃ ω₃ Ω for the slow precession, I₁ cos θ Ω = I₃ ω₃ for the fast one."""
    problem = scene.problem
    if not problem.space or FAST in problem.assume or not any(state.steady for state in problem.states):
        return
    words = "the formula of a fast top was used, which holds nearly where the spin is very fast"
    yield words, Change(problem=lambda read: replace(read, assume=(*read.assume, FAST)))
    if any(is_root(term) and term.modifier == "largest" for find in problem.finds for term in find.terms):
        words = "the weight was left out beside the spin, as in the fast precession of a very fast top"
        yield words, Change(problem=lambda read: replace(read, gravity=None))


def other_root(scene: Scene) -> Made:
    """The fast precession for the slow one."""
    if any(is_root(term) for find in scene.problem.finds for term in find.terms):
        yield "the other root was taken: slow and fast precession were exchanged", Change(problem=with_roots_exchanged)


def is_root(term: Term) -> bool:
    return term.modifier in ROOTS and term.path.quantity == "precession"


def with_roots_exchanged(problem: Problem) -> Problem:
    def changed(find: Find) -> Find:
        terms = (replace(term, modifier=ROOTS[term.modifier]) if is_root(term) else term for term in find.terms)
        return replace(find, terms=tuple(terms))

    return replace(problem, finds=tuple(map(changed, problem.finds)))


# turns


def order_of_turns(scene: Scene) -> Made:
    """R₁ R₂ for R₂ R₁."""
    if scene.problem.space:
        several = (name for name, turns in turned_bodies(scene.problem) if len(turns) > 1)
        for names, who in each_and_all(several):
            words = f"the turns of {who} were made in the other order"
            yield words, Change(problem=with_turns(names, lambda turns: turns[::-1]))


def sense_of_turns(scene: Scene) -> Made:
    """−φ for φ."""
    if scene.problem.space:
        for names, who in each_and_all(name for name, _ in turned_bodies(scene.problem)):
            yield (
                f"the turn of {who} was made the other way round",
                Change(problem=with_turns(names, the_other_way_round)),
            )


def turned_bodies(problem: Problem) -> Iterator[tuple[str, Turns]]:
    """The bodies that are turned from how they are drawn, and the parts that are turned in their bodies, with their turns."""
    for body in bodies_and_parts(problem.bodies):
        placed = ((part.body.name, part.turned) for part in body.parts)
        yield from ((name, turns) for name, turns in ((body.name, body.turned), *placed) if turns)


def the_other_way_round(turns: Turns) -> Turns:
    return tuple(replace(turn, by=negate(turn.by)) for turn in turns)


def with_turns(names: Collection[str], change: Callable[[Turns], Turns]) -> Callable[[Problem], Problem]:
    """The scene with some bodies, or parts of bodies, turned otherwise."""

    def own(name: str, turns: Turns) -> Turns:
        return change(turns) if name in names else turns

    def changed(body: Body) -> Body:
        parts = (replace(part, body=changed(part.body), turned=own(part.body.name, part.turned)) for part in body.parts)
        return replace(body, turned=own(body.name, body.turned), parts=tuple(parts))

    return lambda problem: replace(problem, bodies=tuple(map(changed, problem.bodies)))
