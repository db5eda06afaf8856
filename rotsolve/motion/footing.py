"""Footing: of bodies that are one and led along a line, which lie on something of their own, and what each of these bears."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.core.facts import Force, Motion
from rotsolve.motion.instant import Instant

Borne = tuple[str, ...]


def on_parts(forces: Iterable[Force], instant: Instant) -> list[Force]:
    """The forces, each with that one of several joined bodies on which it acts, where what states it touches no other of them."""
    configuration, state = instant.configuration, instant.state
    if not configuration.seats(state):
        return list(forces)
    touched = {
        item.name: [ref.owner for ref in item.touches() if ref.owner in configuration.bodies]
        for item in configuration.acting(state)
    }
    told = []
    for force in forces:
        own = {name for name in touched.get(force.owner, ()) if instant.host(name) == force.body}
        told.append(replace(force, part=own.pop()) if len(own) == 1 and not force.part else force)
    return told


def footings(name: str, motion: Motion, forces: Sequence[Force], instant: Instant) -> tuple[Borne, ...]:
    """The bodies that are one, in groups that are carried apart from each other; none where these are not told.

    Each of several bodies that are joined and led along one line, none of which turns, is carried by the surface under it: what holds
    them together passes on only what acts along the way. What lies on nothing is borne by what it is joined to.
    """
    way = motion.heading
    if motion.kind != "line" or motion.turns or way is None or motion.bend is not None:
        return ()
    pushes = [force for force in forces if force.role.presses]
    lying = {item.name: item.lying() for item in instant.configuration.connections(instant.state)}
    footed = {force.part for force in pushes if lying.get(force.owner) == force.part}
    if len(footed) < 2 or not all(is_zero(force.vector.along(way)) for force in pushes):
        return ()
    across = way.turned(90)
    if not all(force.part or is_zero(force.vector.along(across)) for force in forces):
        return ()
    joints = [{ref.owner for ref in pair} for pair in instant.configuration.joints(instant.state)]
    bearing = [joint for joint in joints if not joint <= footed]
    groups: dict[str, Borne] = {}
    for member in instant.configuration.carried(name, instant.state):
        if member not in groups:
            group = [member]
            for own in group:
                group += [other for joint in bearing if own in joint for other in sorted(joint.difference(group))]
            groups |= dict.fromkeys(group, tuple(group))
    return tuple(dict.fromkeys(groups.values()))
