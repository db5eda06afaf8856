"""Differences: the change or loss of a quantity from one state to a later one."""

from __future__ import annotations

from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, Formula, add, negate
from rotsolve.core.quantity import DIMENSIONS
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Term
from rotsolve.motion.rigid import tidy
from rotsolve.paths import Meaning, size_of
from rotsolve.questions.question import whole_vector
from rotsolve.questions.transfers import potential_change

STORED = ("potential_energy", "energy")


def difference(term: Term, start: str, end: str, scene: SceneEquations) -> tuple[Meaning, str]:
    """Change (later minus earlier) or loss (earlier minus later)."""
    if term.path.quantity in STORED:
        return stored_difference(term, start, end, scene)
    first = scene.reader(start).meaning(term.path, term)
    last = scene.reader(end).meaning(term.path, term)
    section = scene.configuration.timeline.between(start, end)[-1].name
    label = f"{term.modifier.replace('lost', 'loss of')} {first.label}"
    earlier, later = (last, first) if term.modifier == "lost" else (first, last)
    if earlier.vector is not None and later.vector is not None and whole_vector(term.path):
        gap = tidy(later.vector - earlier.vector)
        return Meaning(size_of(gap), first.dimension, gap, label=label, law=first.law), section
    return Meaning(later.formula - earlier.formula, first.dimension, label=label, law=first.law), section


def stored_difference(term: Term, start: str, end: str, scene: SceneEquations) -> tuple[Meaning, str]:
    """Change or loss of potential energy (of one body: its weight's alone), or of kinetic and potential energy together."""
    result: Formula = ZERO
    intervals = scene.configuration.timeline.between(start, end)
    for interval in intervals:
        passage = scene.passages.get(interval.name)
        if passage is not None:
            result = add(result, potential_change(term.path.owner, passage))
    if term.path.quantity == "energy":
        kinetic = replace(term.path, quantity="kinetic_energy")
        gained = [scene.reader(state).meaning(kinetic, term).formula for state in (start, end)]
        result = add(result, gained[1] - gained[0])
    word = term.path.quantity.replace("_", " ")
    label = f"{term.modifier.replace('lost', 'loss of')} {word}"
    return Meaning(negate(result) if term.modifier == "lost" else result, DIMENSIONS["energy"], label=label), intervals[
        -1
    ].name
