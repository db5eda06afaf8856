"""Swings: from the laws of a displaced body to its harmonic motion: its acceleration, that to first order, the frequency."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Protocol

from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import ZERO, Formula, Symbol, call, negate
from rotsolve.core.derivation import Words
from rotsolve.core.equation import HARMONIC, NEWTON, Equation
from rotsolve.core.facts import BodyFacts, Facts
from rotsolve.core.symbols import RATES, of_kinds
from rotsolve.core.writing import spoken
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.equations.swing import Swing
from rotsolve.laws import groups
from rotsolve.laws.oscillation import (
    approximations,
    harmonic,
    holds_at_any_size,
    large,
    linearised,
    pendulum,
    periods,
    restoring,
)
from rotsolve.paths.meaning import NotYet
from rotsolve.search.answers import NoAnswer

if TYPE_CHECKING:
    from rotsolve.equations.normal_modes import Spectrum
    from rotsolve.language.problem import Given
    from rotsolve.plan import Planner
    from rotsolve.questions.find import Asked
    from rotsolve.solver import Solver
    from rotsolve.solver.steps import Found


class Stepping(Protocol):
    """What swings need of a search: it settles letters step by step, and remembers what it knows of which swings."""

    scene: SceneEquations
    givens: dict[str, Given]
    values: Mapping[str, Formula]
    signs: SignOracle
    planner: Planner
    solver: Solver
    known: set[str]
    swung: set[str]
    displaced: dict[str, Formula]
    spectra: dict[str, Spectrum]

    def step(self, letter: str) -> Found: ...


def settle_swings(asked: Asked, search: Stepping) -> list[int]:
    """All that is to be told of swings before a question; pool indices of the equations that hold for it alone."""
    for swing in search.scene.observed:
        observe(swing, search)
    return [index for swing, word in asked.swings for index in settle_swing(swing, word, search, asked.letter)]


def settle_swing(swing: Swing, word: str, search: Stepping, asked: str) -> list[int]:
    """Everything that comes before the `asked` letter: the equilibrium, the acceleration near it, ω₀, the period (`word`).

    Returns the pool indices of the equations that hold for this question alone.
    """
    if swing.number is not None:
        from rotsolve.equations.normal_modes import Mode
        from rotsolve.search.modes import settle_mode

        assert isinstance(swing, Mode)
        return settle_mode(swing, word, search, asked)
    passing: list[int] = []
    if swing.harmonic not in search.swung:
        search.swung.add(swing.harmonic)
        settle_angle(swing, search)
        exact = search.solver.with_answers(acceleration_of(swing, search))
        slope = search.solver.simplify(restoring(exact, swing.coordinate))
        check_stable(swing, exact, slope, search)
        motion = large_motion(swing, exact, slope, search) if swing.start else small_motion(swing, exact, slope, search)
        passing = [search.planner.extend(equation) for equation in motion]
    for letter in (swing.omega, swing.letters[word]):
        if isinstance(letter, Symbol) and letter.name != asked and letter.name not in search.solver.solved:
            search.step(letter.name)
    return passing


def settle_angle(swing: Swing, search: Stepping) -> None:
    """The letters of the angle at which it stands, where they are sought: the state about which it swings tells them."""
    angle = None if swing.found else swing.rest.angle(swing.body)
    sought = search.scene.configuration.problem.sought - search.known
    for name in sorted(angle.symbols() & sought) if angle is not None else ():
        search.step(name)


def small_motion(swing: Swing, exact: Formula, slope: Formula, search: Stepping) -> Iterator[Equation]:
    """Simple harmonic motion: of any size where the acceleration is proportional to the displacement, else of small swings."""
    words = "period"
    if not holds_at_any_size(exact, swing.coordinate):
        words = "period of small swings"
        first_order = negate(search.solver.simplify(negate(slope) * swing.coordinate))  # it drives back
        yield linearised(swing.acceleration, exact, first_order, swing.coordinate, swing.harmonic)
        search.solver.solved.pop(swing.acceleration.name, None)
        search.known.discard(swing.acceleration.name)
    motion = harmonic(swing.acceleration, swing.coordinate, swing.omega, swing.harmonic)
    undecided = sign_with_roots(slope, search) is None
    yield replace(motion, remark=("stable while ", swing.omega**2, " > 0")) if undecided else motion
    same = same_at_any_size(swing, search) if words == "period" else None
    for equation in periods(swing.omega, swing.letters, swing.harmonic, words):
        if same is not None and equation.left == swing.letters["swing_period"]:
            equation = replace(equation, right=same, label="period, the same for swings of any size")
        search.planner.extend(equation)


def same_at_any_size(swing: Swing, search: Stepping) -> Formula | None:
    """The period of a large swing of the same bodies, where it has been found."""
    swings = [other for other in search.scene.swings.values() if other.start and other.group == swing.group]
    found = [other.letters["swing_period"] for other in swings if other.omega == swing.omega]
    return next((letter for letter in found if letter.symbols() & set(search.solver.solved)), None)


def large_motion(swing: Swing, exact: Formula, slope: Formula, search: Stepping) -> Iterator[Equation]:
    """Swings of any size: harmonic ones, and those of a pendulum under its weight."""
    sine = call("sin", swing.coordinate)
    if swing.exact and holds_at_any_size(exact, swing.coordinate):
        yield harmonic(swing.acceleration, swing.coordinate, swing.omega, swing.harmonic)
        equations = periods(swing.omega, swing.letters, swing.harmonic, "period, the same for swings of any size")
    elif swing.exact and is_zero(exact - slope * sine, search.solver.positive):
        yield pendulum(swing.acceleration, swing.coordinate, swing.omega, swing.harmonic)
        equations = large(swing.coordinate, swing.amplitude(), swing.omega, swing.letters, swing.harmonic)
    else:
        raise NotYet(
            f"large swings of `{swing.body}` are not solved yet",
            help="solved are those of a pendulum under its weight, and harmonic ones",
        )
    for equation in equations:
        search.planner.extend(equation)


def acceleration_of(swing: Swing, search: Stepping) -> Formula:
    """The acceleration as a function of the displacement; found once."""
    if swing.acceleration.name not in search.displaced:
        for place in swing.unsettled:
            try:
                search.step(place)
            except NoAnswer:
                search.known.add(place)  # what balance does not tell stays a letter, which has to drop out
        search.known.add(swing.coordinate.name)
        found = search.step(swing.acceleration.name).formula
        if found is None:
            raise NotYet(f"how `{swing.body}` swings has no closed form")
        search.displaced[swing.acceleration.name] = search.solver.with_answers(found)
    return search.displaced[swing.acceleration.name]


def check_stable(swing: Swing, exact: Formula, slope: Formula, search: Stepping) -> None:
    """Small swings need an equilibrium, and one to which the bodies are driven back."""
    name, state = spoken(swing.body), spoken(swing.rest.state) if not swing.found else "the equilibrium"
    at_rest = exact.substitute({swing.coordinate.name: ZERO})
    if search.signs.decide(at_rest) != 0 and not balanced_by_law(at_rest, swing, search):
        raise NotYet(f"`{name}` is not in equilibrium at {state}: it speeds up there")
    found = {place for place in swing.unsettled if place in search.solver.solved}  # by numbers alone, else it is put in
    known = set(search.givens) | set(search.values) | found
    if slope.symbols() - known:
        raise NotYet(f"how `{name}` swings about {state} depends on how its springs are stretched there")
    way = sign_with_roots(slope, search)
    if way == 0:
        raise NotYet(f"nothing drives `{name}` back to {state}: there are no small swings")
    if way == 1:
        raise NotYet(f"`{name}` has no small swings about {state}: the equilibrium is unstable")


def balanced_by_law(push: Formula, swing: Swing, search: Stepping) -> bool:
    """Whether a law at the state says that nothing speeds up there, by which a letter without a closed form is told."""
    letters = search.scene.configuration.problem.sought | set(swing.unsettled)
    if not push.symbols() & letters:
        return False
    laws = [law for law in search.planner.pool if law.family == NEWTON and law.section == swing.balanced]
    gaps = (search.solver.with_answers(law.left - law.right) for law in laws)
    shares = (search.solver.simplify(push / gap) for gap in gaps if not is_zero(gap))
    return any(not share.symbols() & push.symbols() & letters for share in shares)


def sign_with_roots(value: Formula, search: Stepping) -> int | None:
    """The sign of what may hang on letters that are found as numbers alone."""
    roots = {name: found.number for name, found in search.solver.solved.items() if found.number is not None}
    if not value.symbols() & roots.keys() or set(search.signs.lacking(value)) - roots.keys():
        return search.signs.of_sizes(value)
    return evaluate(value, search.values, roots=roots, digits=8).sign


def slope_in(unknowns: frozenset[str], swing: Swing, search: Stepping) -> tuple[Formula, Words, Formula]:
    """The slope of the acceleration at the equilibrium while some letters are still unknown, how it is told, and the acceleration there."""
    search.known |= unknowns
    exact = acceleration_of(swing, search)
    search.known -= {*unknowns, swing.coordinate.name, swing.acceleration.name}
    search.solver.solved.pop(swing.acceleration.name, None)
    slope = search.solver.simplify(restoring(exact, swing.coordinate))
    first_order = search.solver.simplify(slope * swing.coordinate)
    there = search.solver.simplify(exact.substitute({swing.coordinate.name: ZERO}))
    if holds_at_any_size(exact, swing.coordinate):
        return slope, (swing.acceleration, " = ", first_order), there
    return slope, (swing.acceleration, " ≈ ", first_order, ", as ", *approximations(exact, swing.coordinate)), there


def observe(swing: Swing, search: Stepping) -> None:
    """Swings of which a state tells the period: what it says of the letters that are asked for."""
    if swing.harmonic in search.swung:
        return
    search.swung.add(swing.harmonic)
    slope, told, _ = slope_in(search.scene.configuration.problem.sought, swing, search)
    way: Words = (swing.acceleration, " = ", negate(swing.omega**2 * swing.coordinate), " and ", *told)
    search.planner.extend(HARMONIC.equation(swing.omega**2, negate(slope), swing.harmonic, (), way))
    for equation in periods(swing.omega, swing.letters, swing.harmonic, "period"):
        search.planner.extend(equation)


Standing = tuple[BodyFacts, Formula, Facts]  # a body, its angle, and the facts at its state


def on_shaft(name: str, scene: SceneEquations) -> list[Standing]:
    """Bodies that stand steadily on a turning shaft at an angle that depends on a letter."""
    states = [state.name for state in scene.configuration.timeline.states if state.steady]
    return [item for item in bodies_standing(name, states, scene) if item[0].sweep is not None]


def balanced(name: str, scene: SceneEquations) -> list[Standing]:
    """Bodies whose angle at a state in balance depends on a letter."""
    states = [state.name for state in scene.configuration.timeline.states if state.balance]
    return list(bodies_standing(name, states, scene))


def bodies_standing(name: str, states: Iterable[str], scene: SceneEquations) -> Iterator[Standing]:
    """Bodies whose angle at one of some states depends on a letter."""
    for state in states:
        facts = scene.facts(state, virtual=True)
        for body in facts.bodies:
            angle = scene.instant(state).angle(body.name)
            if angle is not None and name in angle.symbols():
                yield body, angle, facts


def stable_roots(name: str, roots: Sequence[Formula], scene: SceneEquations, signs: SignOracle) -> list[int]:
    """Places of the stable ones among values of a letter that the angle of a body in balance, or on a turning shaft, depends on."""
    for body, angle, facts in (*on_shaft(name, scene), *balanced(name, scene)):
        alone, all_linked = frozenset((body.name,)), scene.configuration.component(body.name, facts.state)
        for group in (alone, all_linked) if body.motion.kind == "axis" else (all_linked,):
            balance, turned = groups.drive(facts, group), groups.turned_per_rate(body, facts, group)
            if balance is None or turned is None:
                continue
            left = balance[0] - balance[1]
            if body.motion.kind != "axis" or group != alone:  # in balance nothing moves
                left = left.substitute(dict.fromkeys(of_kinds(left.symbols(), RATES), ZERO))
            back = differentiate(left, name) * differentiate(angle, name) * turned
            return [place for place, root in enumerate(roots) if signs.of_sizes(back.substitute({name: root})) == -1]
    return []
