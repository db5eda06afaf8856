"""One moment: bodies of which the scene tells the moment of inertia about their axis alone, and what hangs on that across it."""

from __future__ import annotations

from collections.abc import Collection

from msgspec.structs import replace

from rotsolve.algebra.formula import ONE, ZERO, formula, multiply
from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.language.problem import Body, Find, Problem
from rotsolve.motion.configuration import Configuration
from rotsolve.paths.meaning import NotYet
from rotsolve.search.proposals import has_answer
from rotsolve.search.search import Search
from rotsolve.space.arrangement import JointedBodies
from rotsolve.space.inertia import round_about_way
from rotsolve.space.scene import SpaceEquations

ACROSS = formula(7) / 11  # of the moment about the axis: any share of it does, to see whether something hangs on it
MOST = 4  # bodies of which each is looked at


def told_once(problem: Problem) -> list[str]:
    """The bodies of which one moment of inertia is told, and no shape or tensor tells the others."""
    known = (body for body in problem.bodies if body.tensor is None and not body.parts)
    return [body.name for body in known if body.inertia is not None or body.gyration is not None]


def hangs_across(find: Find, problem: Problem, families: tuple[str, ...]) -> list[str]:
    """The bodies whose moment of inertia across their axis alone is missing for a question: with numbers for them it has an answer."""
    names = told_once(problem)
    if not 0 < len(names) <= MOST or not answered_with(names, find, problem, families):
        return []
    needed = [name for name in names if not answered_with({*names} - {name}, find, problem, families)]
    return needed or names


def answered_with(names: Collection[str], find: Find, problem: Problem, families: tuple[str, ...]) -> bool:
    """Whether a question has an answer where some bodies have a moment of inertia across their axis as well."""
    held = JointedBodies(problem, Configuration(problem).signs)
    bodies = tuple(told_across(body, held) if body.name in names else body for body in problem.bodies)
    try:
        scene = SpaceEquations(Configuration(replace(problem, bodies=bodies)))
        return has_answer(find, Search(scene, families, confirming=True))
    except (NotYet, Unsolvable, SceneError, ArithmeticError, ValueError):
        return False


def told_across(body: Body, held: JointedBodies) -> Body:
    """A body with some moment of inertia across its axis."""
    axial = body.inertia if body.inertia is not None else multiply(held.mass(body.name), (body.gyration or ZERO) ** 2)
    axis = held.axis(body.name) or (ZERO, ZERO, ONE)
    tensor = round_about_way(axis, axial, multiply(ACROSS, axial))
    return replace(body, inertia=None, gyration=None, tensor=tensor)
