"""Followed: whether a scene follows how far a body is turned, so that its angle is a letter; else it stands as drawn, or looks the same."""

from __future__ import annotations

from typing import TYPE_CHECKING

from rotsolve.core.quantity import PLANE
from rotsolve.core.registry import COURSE, GENERIC
from rotsolve.core.varying import paths_in
from rotsolve.elements.rims import shape_of
from rotsolve.elements.shapes.shape import WHEEL
from rotsolve.language.keys import varying

if TYPE_CHECKING:
    from rotsolve.motion.instant import Instant

STILL = (None, "cm", *WHEEL)  # points that do not turn with a body
FOLLOWED = ("position", "velocity", "acceleration")


def followed(name: str, instant: Instant) -> bool:
    """Whether the angle of a body matters: of a rod that weighs always, else where the scene speaks of it or follows a mark; of all
    that turns where a motion is followed in time."""
    if instant.mark == COURSE:
        return instant.configuration.pivot(name, instant.state) is not None or instant.can_turn(
            name, slides(name, instant)
        )
    rod = shape_of(instant.body(name)).word == "rod"
    if swings(name, instant):
        return True
    if not (rod and instant.configuration.heavy) and not (spoken_of(name, instant) or marked(name, instant)):
        return False
    return rod or not stands(name, instant)


def swings(name: str, instant: Instant) -> bool:
    """Whether this is a moment of swings or their equilibrium, and the weight of a hinged body has an arm that turns with it."""
    configuration = instant.configuration
    hinged = instant.generic and instant.mark != GENERIC and configuration.pivot(name, instant.state) is not None
    return hinged and configuration.heavy and bool(instant.frame(name).cm.parts)


def spoken_of(name: str, instant: Instant) -> bool:
    """Whether the scene asks for a body's angle, states it, drives it, or lets something vary with it."""
    configuration = instant.configuration
    problem = configuration.problem
    if any(path.owner == name and path.quantity == "angle" and not path.point for path in configuration.mentions.paths):
        return True
    if any(drive.word == "angle" for drive in configuration.drives(name, instant.state)):
        return True
    values = (value for item in (*problem.connections, *problem.actions) for value in varying(item))
    return any((owner, word) == (name, "angle") for value in values for _, owner, word in paths_in(value))


def marked(name: str, instant: Instant) -> bool:
    """Whether the scene follows a mark on a body while it turns about its centre of mass: it stands as drawn at first."""
    configuration, body = instant.configuration, instant.body(name)
    slanted = instant.frame(name).cm.parts and shape_of(body).word != "rod"
    if len(configuration.timeline.states) < 2 or slanted:
        return False
    asked = (term.path for find in configuration.problem.finds for term in find.terms if term.path.owner == name)
    still = (*STILL, *dict(body.radii))
    return any(
        path.point not in still and path.quantity in FOLLOWED and path.component in (None, *PLANE) for path in asked
    )


def stands(name: str, instant: Instant) -> bool:
    """Whether a body slides along as it is drawn, with nothing said of its angle."""
    flat = slides(name, instant)
    said = instant.configuration.mentions.says
    return flat and not instant.can_turn(name, flat) and not said(instant.state, name, "angle")


def slides(name: str, instant: Instant) -> bool:
    """Whether a body travels along a line."""
    return instant.line(name) is not None
