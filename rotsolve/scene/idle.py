"""Idle words: what a scene says and nothing has read: no fact, law, choice or check. It is refused, so that nobody relies on it.

Keys of elements and bodies note who reads them (`language/noted`). Of what lines of states fix, the registry knows whether anyone has
asked for it. What stands beside the asked part of a scene has been checked, and is not spoken of here.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from contextlib import suppress

from msgspec.structs import force_setattr, replace

from rotsolve.core.equation import Equation
from rotsolve.core.faults import Fault
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.bodies import Body
from rotsolve.language.noted import Noted, noting, read_all, unread
from rotsolve.language.problem import Path, Problem
from rotsolve.paths.meaning import NotYet, path_text
from rotsolve.scene.tree import Map, Node, compose

SECTIONS = ("surfaces", "bodies", "connections", "actions", "events")
HARMLESS = {  # fields of which nobody needs to read anything
    "over": "a string passes over its pulleys anyway",
    "radii": "names, of which a question may speak",
    "points": "names, of which a question may speak",
    "parts": "names, of which a question may speak",
    "holes": "names, of which a question may speak",
    "span": "where it stands",
    "density": "has become a mass",  # by `motion/complete`
    "inertia_about": "has become the moment of inertia about the centre of mass",
    "moved": "has become a connection that leads the body",
}
ASKED_ALONE = ("mass", "inertia", "cm", "radius")  # what a question may ask of a body that stands for itself
HELP = "nothing that is solved here depends on it: leave it out, or say what it goes with (`rotsolve elements {word}`)"


def noted(problem: Problem) -> Problem:
    """The problem with all that it declares noting who reads it."""
    return replace(
        problem,
        surfaces=tuple(map(noting, problem.surfaces)),
        bodies=tuple(map(noted_body, problem.bodies)),
        connections=tuple(noting(item, but=item.pointed) for item in problem.connections),
        actions=tuple(map(noting, problem.actions)),
        events=tuple(noting(item, but=item.pointed) for item in problem.events),
    )


def noted_body(body: Body) -> Body:
    """A body that notes who reads it, with a shape that does."""
    twin = noting(body, but=("shape", *HARMLESS))
    if body.shape is not None:
        force_setattr(twin, "shape", noting(body.shape))
    return twin


def idle_words(scene: SceneEquations, used: Collection[Equation]) -> tuple[Fault, ...]:
    """What the scene says and nothing has read, each with its place, what no equation that is `used` goes by; from here on nobody notes
    anything."""
    problem = scene.configuration.problem
    if any(True for _ in idle_keys(problem)):
        look_at_bodies(scene)
    faults = (*key_faults(problem), *line_faults(scene), *assumption_faults(scene, used))
    for section in SECTIONS:
        for item in getattr(problem, section):
            for record in records(item):
                read_all(record)
    return faults


def records(item: Noted) -> Iterator[Noted]:
    """An element; a body with its shape."""
    yield item
    if isinstance(item, Body) and item.shape is not None:
        yield item.shape


def look_at_bodies(scene: SceneEquations) -> None:
    """Ask of every body what a question might: what that reads is of use, whether or not the scene asks it."""
    reader = scene.reader(scene.configuration.timeline.states[0].name)
    for body in scene.configuration.problem.bodies:
        for word in ASKED_ALONE:
            with suppress(NotYet, ValueError, ArithmeticError):
                reader.meaning(Path(body.name, word, component="x" if word == "cm" else None))


def idle_keys(problem: Problem) -> Iterator[tuple[str, str, str]]:
    """The keys that nobody has read: the section, the name of the element or body, the key."""
    touched = {ref.owner for item in problem.connections for ref in item.touches()}
    for section in SECTIONS:
        for item in getattr(problem, section):
            if section == "surfaces" and item.name not in touched:
                continue  # a name of which nothing speaks, as that of a given that is only printed
            for record in records(item):
                yield from (
                    (section, item.name, field.rstrip("_")) for field in unread(record) if field not in HARMLESS
                )


def key_faults(problem: Problem) -> Iterator[Fault]:
    """A fault for each key that nobody has read, at its place in the file."""
    idle = list(idle_keys(problem))
    root: Node | None = compose("\n".join(problem.lines), problem.file)[0] if idle else None
    for section, name, key in idle:
        node: Node | None = root
        for step in (section, name):
            node = node.get(step) if isinstance(node, Map) else None
        place, value = (node.key(key), node.get(key)) if isinstance(node, Map) else (None, None)
        said = f"{key}: {value.shown.strip('`')}" if value is not None else key
        word = next((word.value for word, _ in node.entries), name) if isinstance(node, Map) else name
        help = HELP.format(word=word)
        yield Fault(f"`{said}` of `{name}` says nothing here", place.span if place is not None else None, help, "idle")


def line_faults(scene: SceneEquations) -> Iterator[Fault]:
    """A fault for each line of a state of which nothing has asked what it fixes."""
    for line in scene.unread_lines():
        if line.path is not None:
            message = f"what the state says of `{path_text(line.path)}` says nothing here"
            yield Fault(message, line.span, "nothing that is solved here depends on it: leave it out", "idle")


def assumption_faults(scene: SceneEquations, used: Collection[Equation]) -> Iterator[Fault]:
    """A fault for each assumption that leaves nothing out of what is solved."""
    problem = scene.configuration.problem
    for word in scene.idle_assumptions(used):
        root: Node | None = compose("\n".join(problem.lines), problem.file)[0]
        node = root.get("assume") if isinstance(root, Map) else None
        help = "nothing that is solved here leaves anything out by it: take it out"
        yield Fault(f"`assume: {word}` says nothing here", node.span if node is not None else None, help, "idle")
