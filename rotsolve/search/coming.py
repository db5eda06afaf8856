"""Coming: whether the motion of a scene in space comes to a later state: the rates that it would have there are real.

A kinetic energy, or a force, may have a number at a place to which nothing gets: by the energy it would be less than nothing there.
"""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.core.faults import Unsolvable
from rotsolve.core.symbols import has_quantities
from rotsolve.search.answers import NoAnswer
from rotsolve.search.explain import contradicted
from rotsolve.search.search import Search

COMING = ("angular_velocity", "nutation")  # the rates with which a body comes to an angle or a tilt


def not_come_to(search: Search) -> Iterator[Unsolvable]:
    """Why the motion does not come to a later state, where what is asked there does not show it."""
    quantities, aside = search.scene.registry.quantities, search.apart()
    for interval in search.scene.configuration.timeline.intervals:
        if interval.event is not None:
            continue
        for name, item in list(quantities.items()):
            if item.kind not in COMING or item.component or item.when != interval.end:
                continue
            if has_quantities(search.solver.with_found(search.scene.registry.ask(item))):
                try:
                    aside.value_of(name)
                except NoAnswer as error:
                    if error.equation is not None:
                        yield contradicted(aside.planner.pool[error.equation], search.scene)
