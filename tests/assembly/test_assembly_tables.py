"""What the assembly speaks of: every class of connection, action and event has a row, or is refused by name; nothing is forgotten."""

from __future__ import annotations

from importlib import import_module

import pytest

from rotsolve.confirm.blow import HITS
from rotsolve.confirm.constraints import ROWS
from rotsolve.confirm.couplings import COUPLINGS
from rotsolve.confirm.forces import FORCES
from rotsolve.confirm.strings import STRINGS
from rotsolve.confirm.touches import TOUCHES
from rotsolve.elements.asked import home_of_kind
from rotsolve.elements.tables import ACTIONS, CONNECTIONS, EVENTS

REFUSED = {"unrolls"}  # a roll of which less and less is left


def test_every_connection_has_a_row_or_is_refused() -> None:
    without = [item for item in CONNECTIONS if item.planar and item not in ROWS | TOUCHES | STRINGS]
    assert {item.word for item in without if home_of_kind(item) not in COUPLINGS} == REFUSED


def test_every_action_has_a_line_of_forces() -> None:
    assert {item for item in ACTIONS if home_of_kind(item) not in FORCES} == set()


def test_every_event_has_a_blow() -> None:
    assert {item for item in EVENTS if item not in HITS} == set()


@pytest.mark.parametrize("home", sorted(COUPLINGS.keys() | FORCES.keys()))
def test_every_row_is_of_a_kind_that_there_is(home: str) -> None:
    module, _, name = f"rotsolve.elements.{home}".rpartition(".")
    assert home_of_kind(getattr(import_module(module), name)) == home
