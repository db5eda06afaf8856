"""Pictures: the scene and the free-body diagrams of a problem, at one of its states."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TypeVar

from msgspec.structs import replace

from rotsolve.confirm import NotConfirmed
from rotsolve.core.faults import Unsolvable
from rotsolve.core.writing import spoken
from rotsolve.draw.paper.figure import Figure
from rotsolve.draw.plane.places.numbers import numbers_for
from rotsolve.draw.plane.places.overlaps import plane_stage
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.elements.shapes import shape_of
from rotsolve.language.problem import Problem
from rotsolve.motion.complete import configured
from rotsolve.motion.configuration import Configuration

Kind = TypeVar("Kind")


def scene_picture(problem: Problem, state: str = "") -> Figure:
    """The scene at a state, the first one unless another is named."""
    at = state_named(problem, state)
    if problem.space:
        from rotsolve.draw.space.scene import draw_space
        from rotsolve.draw.space.stage import SpaceStage
        from rotsolve.space.complete import configured_in_space

        spatial = configured_in_space(problem)
        return draw_space(standing_at(SpaceStage, spatial, at, problem), problem.title, picture_words(problem))
    from rotsolve.draw.plane.scene import draw_scene

    return draw_scene(stage_of(problem, at), problem.title, picture_words(problem))


def free_body_pictures(
    problem: Problem, state: str = "", forward: frozenset[str] = frozenset()
) -> list[tuple[str, Figure]]:
    """A diagram for each body on which something acts at a state, with the name of the body; the friction of those that are
    `forward` acts the way in which its body is counted."""
    if problem.space:
        help = "the picture of the scene shows its weights and what the actions exert; `solve --show facts` says all forces"
        raise undrawable("free-body diagrams are drawn of scenes in the plane, and this one is in space", problem, help)
    from rotsolve.draw.plane.facts import SceneFacts
    from rotsolve.draw.plane.freebody import free_body_figures

    found = free_body_figures(SceneFacts(stage_of(problem, state_named(problem, state), forward)))
    if not found:
        raise undrawable("nothing acts on any body, so there is no free-body diagram", problem)
    return found


def free_body_picture(problem: Problem, state: str = "", forward: frozenset[str] = frozenset()) -> Figure:
    """All free-body diagrams of a state in one picture."""
    from rotsolve.draw.plane.freebody import diagrams_in_rows

    found = free_body_pictures(problem, state, forward)
    said = "; ".join(f"{figure.title}: {figure.description}" for _, figure in found)
    return diagrams_in_rows([figure for _, figure in found], f"{problem.title}: free-body diagrams", said)


def picture_of(problem: Problem) -> Figure | None:
    """The picture of the scene for a page on which other things stand as well; None of a scene that can not be drawn."""
    try:
        return scene_picture(problem)
    except (Unsolvable, NotConfirmed, ArithmeticError, LookupError, ValueError, TypeError, AttributeError):
        return None


def stage_of(problem: Problem, state: str, forward: frozenset[str] = frozenset()) -> PlaneStage:
    """A scene in the plane with a place for everything."""
    return standing_at(plane_stage, replace(configured(problem), forward=forward), state, problem)


def standing_at(
    kind: Callable[[Configuration, dict[str, float], str], Kind],
    configuration: Configuration,
    state: str,
    problem: Problem,
) -> Kind:
    """A scene with a place for everything."""
    try:
        return kind(configuration, numbers_for(configuration), state)
    except (NotConfirmed, ArithmeticError) as error:
        raise undrawable(f"where the bodies are is not told well enough for a picture: {error}", problem) from None


def state_named(problem: Problem, state: str) -> str:
    """The name of the state that is asked for, if the scene has it."""
    if not problem.bodies:
        raise undrawable("the scene has no bodies to draw", problem)
    names = [item.name for item in problem.states]
    if not state:
        return names[0] if names else ""
    if state not in names:
        named = [name for name in names if name]
        help = f"its states are {', '.join(named)}" if named else "it has one state only, without a name"
        raise undrawable(f"the scene has no state `{state}`", problem, help)
    return state


def undrawable(message: str, problem: Problem, help: str = "") -> Unsolvable:
    return Unsolvable(message, help=help, lines=problem.lines, file=problem.file)


def picture_words(problem: Problem) -> str:
    """What is in the scene, for readers who do not see the picture."""
    return ". ".join(filter(None, (", ".join(bodies_told(problem)), "; ".join(ties_told(problem)))))


def bodies_told(problem: Problem) -> Iterator[str]:
    for body in problem.bodies:
        word = shape_of(body).word if body.shape is not None else ""
        yield f"{spoken(body.name)}{f' ({word})' if word and word not in body.name else ''}"


def ties_told(problem: Problem) -> Iterator[str]:
    for item in (*problem.connections, *problem.actions):
        owners = dict.fromkeys(spoken(ref.owner) if ref.owner else "a fixed place" for ref in item.touches())
        yield f"{item.word}: {', '.join(owners)}"
