"""Forced swings: what drives bodies in time while springs or weights drive them back, q̈ + ω₀² q = F(t)/m, which no law here follows."""

from __future__ import annotations

from rotsolve.core.symbols import POSITION, TIME
from rotsolve.language.keys import varying_values
from rotsolve.language.problem import Find
from rotsolve.motion.configuration import Configuration
from rotsolve.paths.meaning import NotYet

HELP = "solved are swings that nothing drives; `rotsolve simulate` follows these in numbers"


def forced_swings(find: Find, configuration: Configuration) -> NotYet | None:
    """Why what is asked of bodies that swing as they are driven in time is not solved; None where they do not."""
    owners = [term.path.owner for term in find.terms if term.path.owner in configuration.bodies]
    for state in configuration.timeline.states:
        for owner in owners:
            driven = driven_in_time(owner, state.name, configuration)
            if driven:
                body = configuration.host(owner, state.name)
                return NotYet(f"`{driven}` forces swings on `{body}` in time: that is not solved yet", help=HELP)
    return None


def driven_in_time(name: str, state: str, configuration: Configuration) -> str:
    """What acts in time on the bodies that move with one, while something else drives them back by their place; '' where nothing does."""
    component = configuration.component(configuration.host(name, state), state)
    acting = [
        item
        for item in configuration.acting(state)
        if any(
            configuration.host(ref.owner, state) in component
            for ref in item.touches()
            if ref.owner in configuration.bodies
        )
    ]
    forces = [item.name for item in acting if any(TIME in value.symbols() for value in varying_values(item))]
    back = [item for item in acting if item.name not in forces and item.pace(configuration, state) == POSITION]
    return forces[0] if forces and back else ""
