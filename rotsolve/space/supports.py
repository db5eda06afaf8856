"""Supports: the sum of the forces of all joints that hold a body, which the laws tell where they do not tell each of them.

Two balls on the ground push along the line through both as they like; what they come to there is M a less all else that acts on the body.
A question is told so where it stays the same when one of them pushes by as much more as another by less.
"""

from __future__ import annotations

from itertools import pairwise

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import ZERO, Symbol, add, negate
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Find, Path, Term
from rotsolve.space.arrangement import JointedBodies

HELD = "#held"  # the part of the force on a body that is of all joints that hold it
SHIFT = Symbol("#shift")


def with_supports_together(find: Find, scene: SceneEquations) -> list[Term | None] | None:
    """The terms of a question, of the forces of all joints that hold a body the first as their sum and no other; None where none are
    so."""
    held: JointedBodies = scene.held  # type: ignore[attr-defined]
    groups: dict[tuple[Path, Term], list[int]] = {}
    for number, term in enumerate(find.terms):
        joint = held.joint(term.path.owner)
        if joint is not None and term.path.quantity == "force" and term.path.point is None:
            body = replace(term.path, owner=joint.body.owner, span=None)
            groups.setdefault((body, replace(term, path=body)), []).append(number)
    terms: list[Term | None] = list(find.terms)
    for (path, whole), numbers in groups.items():
        owners = [find.terms[number].path.owner for number in numbers]
        supports = sorted(joint.owner for joint in held.of_body(path.owner))
        if sorted(owners) == supports and len(supports) > 1 and shared_evenly(find, numbers):
            first, *others = numbers
            component = " ".join(filter(None, (HELD, path.component)))
            terms[first] = replace(whole, path=replace(path, component=component, span=find.terms[first].path.span))
            for number in others:
                terms[number] = None
    return None if terms == list(find.terms) else terms


def shared_evenly(find: Find, numbers: list[int]) -> bool:
    """Whether a question stays the same however some of its terms share what they come to."""
    for one, other in pairwise(f"#{number}" for number in numbers):
        moved = {one: add(Symbol(one), SHIFT), other: add(Symbol(other), negate(SHIFT))}
        try:
            if not is_zero(find.formula.substitute(moved) - find.formula):
                return False
        except ZeroDivisionError:
            return False
    return find.formula != ZERO
