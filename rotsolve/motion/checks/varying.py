"""Varying: whether what a value varies with is there: a body that moves as it is said to, tied to the one on which the value acts."""

from __future__ import annotations

from rotsolve.core.faults import Unsolvable
from rotsolve.core.registry import Registry
from rotsolve.core.varying import paths_in
from rotsolve.motion.arrangement import Arrangement
from rotsolve.motion.instant import Instant
from rotsolve.scene.keys import varying


def check_values(arrangement: Arrangement) -> None:
    """A value that varies speaks of a body that moves as it is said to, and that is tied to the body on which it acts."""
    for state in arrangement.timeline.states:
        instant = Instant(arrangement, Registry(), state.name)
        for body in arrangement.present(state.name):
            arrangement.drives(body.name, state.name)  # refuses what can not be driven so
        for item in arrangement.acting(state.name):
            held = [ref for ref in item.touches() if ref.owner in arrangement.bodies]
            for name, owner, word in (path for value in varying(item) for path in paths_in(value)):
                motion = instant.motion(owner)
                if motion.kind != "line" if word in ("displacement", "velocity") else not motion.turns:
                    how = "travel along a line" if word in ("displacement", "velocity") else "turn"
                    raise Unsolvable(f"there is no `{name}`: `{owner}` does not {how}", span=held[-1].span)
                if instant.host(owner) not in arrangement.component(held[-1].owner, state.name):
                    message = f"`{item.name}` varies with a body that is not tied to `{held[-1].owner}`: not solved yet"
                    raise Unsolvable(message, span=held[-1].span)
