"""Unheld: wheels on no axle and rods on no hinge: bodies that nothing holds up, where nothing says that they are meant to fly."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.core.symbols import RATES
from rotsolve.elements.shapes import shape_of
from rotsolve.language.problem import Body, Problem
from rotsolve.motion.configuration import Configuration


def unheld(configuration: Configuration) -> tuple[str, ...]:
    """The bodies with an extent that nothing holds at the first state, in a plane in which things fall."""
    problem = configuration.problem
    if problem.space or not configuration.heavy:
        return ()
    state = configuration.timeline.states[0].name
    return tuple(
        body.name
        for body in configuration.present(state)
        if not is_particle(body)
        and configuration.host(body.name, state) == body.name
        and not (together := configuration.component(body.name, state)) & held_at(configuration, state)
        and not together & led(problem)
    )


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


def led(problem: Problem) -> set[str]:
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
