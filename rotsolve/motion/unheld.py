"""Unheld: wheels on no axle and rods on no hinge: bodies that nothing holds up, where nothing says that they are meant to fly."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.core.symbols import RATES
from rotsolve.elements.shapes import shape_of
from rotsolve.language.problem import Body, Problem
from rotsolve.motion.configuration import Configuration


def unheld(configuration: Configuration) -> tuple[str, ...]:
    """The bodies with an extent that nothing holds at the first state, in a plane in which things fall, if the scene speaks of them."""
    problem = configuration.problem
    if problem.space or not configuration.heavy:
        return ()
    state = configuration.timeline.states[0].name
    spoken_of = bodies_spoken_of(problem)
    found = tuple(
        body.name
        for body in configuration.present(state)
        if not is_particle(body)
        and configuration.host(body.name, state) == body.name
        and not (together := configuration.component(body.name, state)) & held_at(configuration, state)
        and not together & told_to_move(problem)
        and (not spoken_of or together & spoken_of)
    )
    return found if spoken_of or len(found) == len(problem.bodies) else ()


def bodies_spoken_of(problem: Problem) -> set[str]:
    """The bodies of which states tell something, or after which is asked, by their own names or those of what ties them."""
    asked = {term.path.owner for find in problem.finds for term in find.terms}
    told = {line.path.owner for state in problem.states for line in state.conditions if line.path is not None}
    ties = {item.name: {ref.owner for ref in item.touches()} for item in (*problem.connections, *problem.actions)}
    return {name for owner in asked | told for name in ties.get(owner, {owner}) if name}


def is_particle(body: Body) -> bool:
    """Whether all of a body is in one point, which needs nothing to turn about."""
    return (
        shape_of(body).pointlike and not body.parts and body.inertia is None and body.radius is None and not body.radii
    )


def held_at(configuration: Configuration, state: str) -> set[str]:
    """The bodies that something holds that is none: the ground, a surface, an axle or a place that is fixed."""
    bodies = configuration.bodies
    held = {name for name in bodies if configuration.pivot(configuration.host(name, state), state) is not None}
    items = configuration.connections(state)
    for body in configuration.present(state):  # on rails of its own
        if configuration.line(body.name, state) is not None and not any(item.hangs(body) for item in items):
            held.add(configuration.host(body.name, state))
    for item in items:
        owners = {ref.owner for ref in item.touches()}
        if not owners <= bodies.keys() or len(item.touches()) == 1:
            held |= {configuration.host(name, state) for name in owners & bodies.keys()}
    return held


def told_to_move(problem: Problem) -> set[str]:
    """The bodies of which the scene tells how they move: thrown, struck or led along."""
    told = {
        line.path.owner
        for state in problem.states
        for line in state.conditions
        if line.path and line.path.quantity in RATES
    }
    struck = {ref.owner for event in problem.events for ref in event.points(problem.connections)}
    return told | struck | {body.name for body in problem.bodies if body.moved}


def what_would_hold(names: tuple[str, ...], problem: Problem) -> Iterator[str]:
    """A connection for each body that holds it: at its end what runs straight, else at its middle."""
    for body in (body for body in problem.bodies if body.name in names):
        shape = shape_of(body)
        yield f"pin: {{hinge: {body.name}.{shape.points[0]}}}" if shape.slender else f"axle: {{axle: {body.name}}}"
