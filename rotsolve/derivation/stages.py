"""Stages: what lies between a scene and its derivation, as text: facts, equations, plan."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.derivation import Words
from rotsolve.core.equation import Equation
from rotsolve.core.writing import spoken
from rotsolve.derivation.letters import Letters, in_printed_letters, own_indices
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.search.explain import plural
from rotsolve.search.search import Search


def facts_text(scene: SceneEquations, beside: Sequence[str] = ()) -> str:
    """All facts, state by state: bodies with their forces, rules, requirements; at the end the bodies that stand `beside` what is asked."""
    lines = []
    registry = scene.registry
    for state in scene.configuration.timeline.states:
        scene.facts(state.name)
    problem = scene.configuration.problem
    taken = frozenset(given.name for given in problem.givens)
    names = registry.letters(registry.quantities, taken, {}, own_indices(problem.bodies))
    letters = {key: Symbol(name) for key, name in names.items()}
    for state in scene.configuration.timeline.states:
        facts = scene.facts(state.name)
        lines.append(f"at {spoken(state.name)}" if state.name else "facts")
        lines += [f"  {words_to_text(words, letters)}" for words in scene.diagram_words(state.name)]
        for body in facts.bodies:
            lines.append(f"  {spoken(body.name)}: {body.motion.kind}; positive: {body.positive or 'none'}")
            lines += [f"    {words_to_text(item.words, letters)}" for item in body.acting]
        for rule in facts.rules:
            left, right = (to_text(side.substitute(letters)) for side in rule.acceleration or rule.velocity)
            lines.append(f"  {rule.label}: {left} = {right}")
    if beside:
        lines.append(f"left out, since nothing that is asked depends on it: {', '.join(map(spoken, beside))}")
    return "\n".join(lines)


def words_to_text(words: Words, letters: Mapping[str, Formula]) -> str:
    return "".join(to_text(part.substitute(letters)) if isinstance(part, Formula) else part for part in words)


def equations_text(search: Search, letters: Letters) -> str:
    """All equations written, one a line, those that the plan used marked."""
    used = {index for answered in search.answered for index in answered.used}
    names = all_names(search, letters)
    lines = []
    for index, equation in enumerate(search.equations):
        mark = "*" if index in used else " "
        place = f"[{spoken(equation.section)}] " if equation.section else ""
        lines.append(f"{mark} {place}{equation.label}: {in_text(equation, names)}")
    return "\n".join(lines)


def plan_text(search: Search, letters: Letters) -> str:
    """For each question the equations that settle it."""
    names = all_names(search, letters)
    lines = []
    for answered in search.answered:
        name = names.get(answered.asked.letter, answered.asked.find.name)
        lines.append(f"{name}: {plural(len(answered.used), 'equation')}")
        for index in answered.used:
            equation = search.planner.pool[index]
            lines.append(f"  {equation.label or 'found before'}: {in_text(equation, names)}")
    return "\n".join(lines)


def all_names(search: Search, letters: Letters) -> dict[str, str]:
    """Printed names of all quantities, in the derivation's letters where it has one."""
    registry = search.scene.registry
    taken = frozenset(search.givens) - set(letters.names.values())
    return registry.letters(registry.quantities, taken, letters.names, own_indices(letters.problem.bodies))


def in_text(equation: Equation, names: Mapping[str, str]) -> str:
    left, right = (to_text(in_printed_letters(side, names)) for side in (equation.left, equation.right))
    return f"{left} = {right}"
