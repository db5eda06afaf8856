"""Entries: a question for a matrix or a vector in space as questions for its entries."""

from __future__ import annotations

from msgspec.structs import replace

from rotsolve.algebra.formula import Symbol
from rotsolve.core.vectors.tensor import AXES, ENTRIES
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Find, Term


def entries(find: Find, scene: SceneEquations) -> tuple[Find, ...]:
    """A question for a matrix or a vector in space as questions for its entries; any other question alone."""
    if len(find.terms) != 1 or find.formula != Symbol("#0") or find.terms[0].path.component is not None:
        return (find,)
    term = find.terms[0]
    names = components(term, scene)
    return tuple(
        replace(
            find,
            name=f"{find.name}_{name}",
            terms=(replace(term, path=replace(term.path, component=name)),),
            whole=find.name,
        )
        for name in names
    ) or (find,)


def components(term: Term, scene: SceneEquations) -> tuple[str, ...]:
    """The entries that belong to a question for a whole: all of a tensor; the coordinates in which a body extends."""
    path = term.path
    if path.owner not in scene.configuration.bodies:
        return ()
    if path.quantity == "inertia_tensor":
        return ENTRIES
    if path.quantity not in ("cm", "angular_momentum") or term.modifier:
        return ()
    flat = scene.reader(scene.configuration.timeline.states[0].name).is_flat(path.owner, term)
    if path.quantity == "cm":
        return AXES[:2] if flat else AXES
    return AXES if term.about is not None and not flat else ()
