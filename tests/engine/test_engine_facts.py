"""Facts of every connection: an ideal one gives no power, a stored force is the slope of its energy, dimensions agree."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.linear import solve_linear
from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import ZERO, Formula, Negative, Sum, Symbol, total
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.units import dimension as dims
from rotsolve.algebra.units.dimension import TIME, Dimension, DimensionError, dimension_of
from rotsolve.core.facts import BodyFacts, Couple, Facts, Force
from rotsolve.core.symbols import has_quantities, key_of
from rotsolve.core.vectors.heading import UP
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Problem, State
from rotsolve.laws import energy
from rotsolve.motion.configuration import Configuration
from rotsolve.scene.elements import TABLES

Readings = Callable[[Path], tuple[SceneEquations, ...]]
RATES = ("velocity", "angular_velocity")
ACCELERATIONS = ("acceleration", "angular_acceleration")
STRETCHES = ("elongation", "length")
PLACES = ("angle", "displacement", *STRETCHES)


@pytest.mark.parametrize("section", TABLES)
def test_every_element_with_physics_has_a_scene(
    section: str, scenes: list[Path], problem_of: Callable[[Path], Problem]
) -> None:
    tested = {type(item) for path in scenes for item in getattr(problem_of(path), section)}
    missing = [item.word for item in TABLES[section][1] if item.planar and not item.later and item not in tested]
    assert not missing, f"add a scene to tests/engine/scenes with: {', '.join(missing)}"


def moments(scene: SceneEquations) -> Iterator[Facts]:
    """Facts of each state with velocities of any motion that the rules allow, and of the midst of each phase."""
    for state in scene.configuration.timeline.states:
        yield scene.facts(state.name, virtual=True)
        yield scene.facts(state.name, generic=True)


def is_rate(name: str) -> bool:
    return key_of(name).kind in RATES


def allowed(facts: Facts) -> dict[str, Formula]:
    """Rates in terms of independent ones, by the velocity rules."""
    solved: dict[str, Formula] = {}
    for rule in facts.rules:
        gap = (rule.velocity[0] - rule.velocity[1]).substitute(solved)
        for name in sorted(gap.symbols(), key=lambda name: (not is_rate(name), name)):
            value = solve_linear(gap, name) if is_rate(name) else None
            if value is not None:
                solved = {other: formula.substitute({name: value}) for other, formula in solved.items()}
                solved[name] = value
                break
        else:
            assert not any(map(is_rate, gap.symbols())) or is_zero(gap), f"can not be obeyed: {to_text(gap)} = 0"
    return solved


def power(body: BodyFacts, item: Force | Couple) -> Formula:
    """F·v at the point of a force, τ ω of a couple."""
    if isinstance(item, Couple):
        return item.torque * body.motion.spin
    return item.vector.dot(body.motion.velocity_of(item.arm))


def items(facts: Facts) -> Iterator[tuple[BodyFacts, Force | Couple]]:
    for body in facts.bodies:
        for item in (*body.forces, *body.couples):
            yield body, item


@pytest.mark.sampled(3)
def test_ideal_connections_give_no_power(file: Path, readings: Readings) -> None:
    for scene in readings(file):
        for facts in moments(scene):
            rates = allowed(facts)
            for owner in {item.owner for _, item in items(facts) if item.internal}:
                given = total(
                    [power(body, item) for body, item in items(facts) if item.owner == owner and item.internal]
                )
                power_left = simplify(given.substitute(rates))
                assert power_left == ZERO, f"{owner} gives the power {to_text(power_left)} at {facts.span}"


def test_each_force_of_a_connection_is_ideal_or_stores_or_loses(file: Path, readings: Readings) -> None:
    for scene in readings(file):
        names = {item.name for item in scene.configuration.problem.connections}
        for facts in moments(scene):
            for _, item in items(facts):
                if item.owner in names:
                    assert item.internal != (item.role.stores or item.role.loses) or item.role.rubs, item


def test_stored_energy_has_the_force_for_slope(file: Path, readings: Readings) -> None:
    for scene in readings(file):
        for facts in moments(scene):
            rates = allowed(facts)
            for stored in facts.potentials:
                if not has_quantities(stored.elongation):
                    continue  # fixed at this moment: the midst of the phase has a letter for it
                given = total([power(body, item) for body, item in items(facts) if item.owner == stored.owner])
                growth = slope(stored.energy, stored.elongation) * stored.rate
                balance = simplify((given + growth).substitute(rates))
                assert balance == ZERO, f"{stored.owner}: power and growth of energy leave {to_text(balance)}"


def slope(energy: Formula, elongation: Formula) -> Formula:
    """dU/dx, where x may be a letter or an angle less another."""
    free = sorted(elongation.symbols())
    inner = differentiate(elongation, free[0])
    return differentiate(energy, free[0]) / inner


def loosened(problem: Problem) -> Problem:
    """The same scene with a letter for every place that its states fix, and free velocities."""
    states = []
    for state in problem.states:
        placed = [line for line in state.conditions if line.path is not None and line.path.quantity in PLACES]
        lines = (
            replace(line, value=Symbol(f"{line.path.quantity}|{line.path.owner}|!")) for line in placed if line.path
        )
        states.append(State(state.name, tuple(lines)))
    return replace(problem, states=tuple(states))


def test_potential_energy_of_a_phase_has_the_forces_for_slope(
    file: Path, problem_of: Callable[[Path], Problem]
) -> None:
    """Along every way that the rules allow, what the energy law stores is what weights and springs take."""
    if any(getattr(item, "at", ()) for item in problem_of(file).connections):
        return  # told places, between which bodies close by their angles alone
    scene = SceneEquations(Configuration(loosened(problem_of(file))))
    for passage in scene.passages.values():
        facts = passage.end
        if any(given.drive.order == 0 for given in facts.given):
            continue  # a place that is given in time is no coordinate
        rates = allowed(facts)
        for group in passage.groups:
            if any(passage.heights.get(name) is None for name in group):
                continue
            stored = total(energy.potential(passage, group, 1))
            given = [power(body, item) for body, item in items(facts) if body.name in group and item.role.stores]
            left = simplify((total(given) + growth(stored, facts)).substitute(rates))
            assert left == ZERO, f"{passage.name}: forces and stored energy {to_text(stored)} leave {to_text(left)}"


def growth(stored: Formula, facts: Facts) -> Formula:
    """dU/dt through the angles, displacements and elongations that the energy is written in."""
    result: Formula = ZERO
    stretch = {item.owner: item.rate for item in facts.potentials}
    for name in sorted(stored.symbols()):
        kind, owner = key_of(name).kind, key_of(name).owner
        body = facts.body(owner)
        if kind in STRETCHES:
            result = result + differentiate(stored, name) * stretch[owner]
        elif kind == "height" and body is not None:  # on a track of which no more is told
            result = result + differentiate(stored, name) * body.motion.velocity.along(UP)
        elif kind in PLACES:
            if body is None:  # a place on a curved surface
                result = result + differentiate(stored, name) * turning(facts, name)
                continue
            pace = body.motion.spin if kind == "angle" else body.motion.velocity.along(body.motion.heading or UP)
            result = result + differentiate(stored, name) * pace
    return result


def turning(facts: Facts, angle: str) -> Formula:
    """Rate, counterclockwise, of the angle of the one body that is on a curved surface; on a round side of another body ∓ u/ρ.

    The rule across it tells ∓ u²/ρ, and is d/dt of that of velocities: u has a letter there, or is what that grows by with the angle.
    """
    owner = key_of(angle).owner
    across = next((rule for rule in facts.rules if rule.owner == owner and rule.acceleration is not None), None)
    if across is not None and across.acceleration is not None:
        letters = [name for name in across.velocity[1].symbols() if key_of(name).owner == owner and is_rate(name)]
        if letters:
            towards = across.acceleration[1] - across.acceleration[1].substitute({letters[0]: ZERO})
            return simplify(towards / Symbol(letters[0]))
        gap, bent = (side[0] - side[1] for side in (across.velocity, across.acceleration))
        still = {name: ZERO for name in bent.symbols() if key_of(name).kind in ACCELERATIONS}
        if angle in gap.symbols():
            return simplify(bent.substitute(still) / differentiate(gap, angle))
    (body,) = (body for body in facts.bodies if body.motion.bend is not None)
    bend = body.motion.bend
    assert bend is not None
    return body.motion.velocity.along(bend.outward.turned(90)) / bend.radius


def known_dimensions(scene: SceneEquations) -> dict[str, Dimension]:
    given = {item.name: item.dimension for item in scene.configuration.problem.givens if item.dimension is not None}
    made = {key: quantity.dimension for key, quantity in scene.registry.quantities.items()}
    return {"time": TIME, **given, **made}


def test_both_sides_of_an_equation_have_one_dimension(file: Path, readings: Readings) -> None:
    for scene in readings(file):
        equations, known = scene.equations, known_dimensions(scene)
        for equation in equations:
            try:
                dimension_of(Sum((equation.left, Negative(equation.right))), known)
            except DimensionError as error:
                shown = f"{to_text(equation.left)} = {to_text(equation.right)}"
                raise AssertionError(f"{equation.label}: {shown}: {error}") from None


def test_sizes_in_facts_have_their_dimensions(file: Path, readings: Readings) -> None:
    for scene in readings(file):
        for facts in moments(scene):
            sizes = [entry for body, item in items(facts) for entry in sizes_of(body, item)]
            sizes += [(stored.energy, dims.ENERGY) for stored in facts.potentials]
            known = known_dimensions(scene)
            for formula, wanted in sizes:
                found = dimension_of(formula, known)
                assert formula == ZERO or found.matches(wanted), f"{to_text(formula)}: {found} instead of {wanted}"


def sizes_of(body: BodyFacts, item: Force | Couple) -> Iterator[tuple[Formula, Dimension]]:
    yield body.mass, dims.MASS
    if body.inertia is not None:
        yield body.inertia.formula, dims.INERTIA
    if isinstance(item, Couple):
        yield item.torque, dims.TORQUE
    else:
        yield item.size, dims.FORCE
        yield from ((size, dims.LENGTH) for size, _ in item.arm.parts)
