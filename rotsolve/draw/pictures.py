"""Pictures: the scene and the free-body diagrams of a problem, at one of its states."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, TypeVar

from msgspec.structs import replace

from rotsolve.confirm import NotConfirmed
from rotsolve.core.faults import Unsolvable
from rotsolve.core.writing import spoken
from rotsolve.draw.paper.figure import Figure
from rotsolve.draw.plane.places.numbers import numbers_for
from rotsolve.draw.plane.places.overlaps import plane_stage
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.elements.shapes import shape_of
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Problem
from rotsolve.motion.complete import configured
from rotsolve.motion.configuration import Configuration

if TYPE_CHECKING:
    from rotsolve.draw.plane.facts import SceneFacts
    from rotsolve.search.acting import ActingWays

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
    problem: Problem, state: str = "", ways: ActingWays | None = None
) -> list[tuple[str, str, Figure]]:
    """A diagram for each body on which something acts, with its state and the name of the body: at a state that is named, else at those
    of which the scene asks. `ways` tells which way forces act; without it that is told as far as it is without solving the scene."""
    if problem.space:
        help = "the picture of the scene shows its weights and what the actions exert; `solve --show facts` says all forces"
        raise undrawable("free-body diagrams are drawn of scenes in the plane, and this one is in space", problem, help)
    from rotsolve.draw.states import states_asked

    named = state_named(problem, state)
    found = [] if state else diagrams_at(problem, states_asked(problem), ways)
    found = found or diagrams_at(problem, (named,), ways)
    if not found:
        others = (item.name for item in problem.states if item.name != named)
        other = next((name for name in others if diagrams_at(problem, (name,), ways)), "")
        help = f"what acts at another state is drawn with `--state {other}`" if other else ""
        raise undrawable("nothing acts on any body, so there is no free-body diagram", problem, help)
    return found


def diagrams_at(problem: Problem, states: Sequence[str], ways: ActingWays | None) -> list[tuple[str, str, Figure]]:
    """The diagrams at some states, each look of a body once."""
    from rotsolve.draw.plane.freebody import free_body_figures, look_of

    found: dict[object, tuple[str, str, Figure]] = {}
    for known in known_at(problem, states, ways):
        for body, figure in free_body_figures(known):
            found.setdefault((body, look_of(figure)), (known.stage.state, body, figure))
    return list(found.values())


def free_body_picture(problem: Problem, state: str = "", ways: ActingWays | None = None) -> Figure:
    """All free-body diagrams of a scene in one picture."""
    from rotsolve.draw.plane.freebody import diagrams_in_rows

    figures = [figure for _, _, figure in free_body_pictures(problem, state, ways)]
    said = "; ".join(f"{figure.title}: {figure.description}" for figure in figures)
    return diagrams_in_rows(figures, f"{problem.title}: free-body diagrams", said)


def known_at(problem: Problem, states: Sequence[str], ways: ActingWays | None) -> Iterator[SceneFacts]:
    """The facts at some states, with the bodies as they stand there by the answers."""
    from rotsolve.draw.plane.facts import SceneFacts
    from rotsolve.draw.plane.standing import as_found

    configuration = configured(problem)
    if ways is not None:
        configuration = replace(configuration, forward=ways.scene.configuration.forward)
    scene = SceneEquations(configuration, {} if ways is None else ways.scene.modes)
    for state in states:
        yield SceneFacts(stage_of(as_found(problem, state, scene, ways), state), scene, ways)


def picture_of(problem: Problem) -> Figure | None:
    """The picture of the scene for a page on which other things stand as well; None of a scene that can not be drawn."""
    try:
        return scene_picture(problem)
    except (Unsolvable, NotConfirmed, ArithmeticError, LookupError, ValueError, TypeError, AttributeError):
        return None


def stage_of(problem: Problem, state: str) -> PlaneStage:
    """A scene in the plane with a place for everything."""
    return standing_at(plane_stage, configured(problem), state, problem)


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
