"""Varying: whether what a value varies with is there: a body that moves as it is said to, tied to the one on which the value acts."""

from __future__ import annotations

from rotsolve.core.faults import Unsolvable
from rotsolve.core.registry import Registry
from rotsolve.core.varying import paths_in
from rotsolve.elements.actions import Action
from rotsolve.elements.connections import Connection
from rotsolve.language.keys import varying
from rotsolve.motion.arrangement import Arrangement
from rotsolve.motion.instant import Instant


def check_values(arrangement: Arrangement) -> None:
    """A value that varies speaks of a body that moves as it is said to, and that is tied to the body on which it acts."""
    for state in arrangement.timeline.states:
        if state.conditions:
            arrangement.present(state.name)  # refuses own data of bodies that can not be so
        items = arrangement.connections(state.name)
        for host in {arrangement.host(owner, state.name): None for item in items for owner, *_ in item.prescribes()}:
            arrangement.drives(host, state.name)  # refuses what can not be driven so
        instant = Instant(arrangement, Registry(), state.name)
        for item in arrangement.acting(state.name):
            for value in varying(item):
                for path in paths_in(value):
                    check_path(item, path, instant)


def check_path(item: Connection | Action, path: tuple[str, str, str], instant: Instant) -> None:
    """The body that a path of an element's value speaks of moves so, and with the body on which the element acts."""
    name, owner, word = path
    arrangement = instant.arrangement
    held = [ref for ref in item.touches() if ref.owner in arrangement.bodies]
    motion = instant.motion(owner)
    if motion.kind != "line" if word in ("displacement", "velocity") else not motion.turns:
        how = "travel along a line" if word in ("displacement", "velocity") else "turn"
        raise Unsolvable(f"there is no `{name}`: `{owner}` does not {how}", span=held[-1].span)
    if instant.host(owner) not in arrangement.component(held[-1].owner, instant.state):
        message = f"`{item.name}` varies with a body that is not tied to `{held[-1].owner}`: not solved yet"
        raise Unsolvable(message, span=held[-1].span)
