"""Varying: whether what a value varies with is there: a body that moves as it is said to, tied to the one on which the value acts."""

from __future__ import annotations

from rotsolve.core.faults import Unsolvable
from rotsolve.core.registry import Registry
from rotsolve.core.varying import paths_in
from rotsolve.elements.actions import Action
from rotsolve.elements.connections import Connection
from rotsolve.language.keys import varying
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.instant import Instant


def check_values(configuration: Configuration) -> None:
    """A value that varies speaks of a body that moves as it is said to, and that is tied to the body on which it acts."""
    for state in configuration.timeline.states:
        if state.conditions:
            configuration.present(state.name)  # refuses own data of bodies that can not be so
        items = configuration.connections(state.name)
        for host in {configuration.host(owner, state.name): None for item in items for owner, *_ in item.prescribes()}:
            configuration.drives(host, state.name)  # refuses what can not be driven so
        instant = Instant(configuration, Registry(), state.name)
        for item in configuration.acting(state.name):
            for value in varying(item):
                for path in paths_in(value):
                    check_path(item, path, instant)


def check_path(item: Connection | Action, path: tuple[str, str, str], instant: Instant) -> None:
    """The body that a path of an element's value speaks of moves so, and with the body on which the element acts."""
    name, owner, word = path
    configuration = instant.configuration
    held = [ref for ref in item.touches() if ref.owner in configuration.bodies]
    motion = instant.motion(owner)
    if motion.kind != "line" if word in ("displacement", "velocity") else not motion.turns:
        how = "travel along a line" if word in ("displacement", "velocity") else "turn"
        raise Unsolvable(f"there is no `{name}`: `{owner}` does not {how}", span=held[-1].span)
    if instant.host(owner) not in configuration.component(held[-1].owner, instant.state):
        message = f"`{item.name}` varies with a body that is not tied to `{held[-1].owner}`: not solved yet"
        raise Unsolvable(message, span=held[-1].span)
