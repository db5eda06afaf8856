"""What the assembly speaks of: every class of connection, action and event has a row, or is refused by name; nothing is forgotten."""

from __future__ import annotations

from rotsolve.confirm.blow import HITS
from rotsolve.confirm.constraints import ROWS
from rotsolve.confirm.couplings import COUPLINGS
from rotsolve.confirm.forces import FORCES
from rotsolve.confirm.touches import TOUCHES
from rotsolve.elements.tables import ACTIONS, CONNECTIONS, EVENTS

REFUSED = {"unrolls"}  # a roll of which less and less is left


def test_every_connection_has_a_row_or_is_refused() -> None:
    assert {item.word for item in CONNECTIONS if item.planar and item not in ROWS | TOUCHES | COUPLINGS} == REFUSED


def test_every_action_has_a_line_of_forces() -> None:
    assert {item for item in ACTIONS if item not in FORCES} == set()


def test_every_event_has_a_blow() -> None:
    assert {item for item in EVENTS if item not in HITS} == set()
