"""The table of laws: each row can be loaded, and writes the laws that it names; each law has an identity of its own."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from rotsolve.cli.solve import LAWS as NAMED
from rotsolve.core import equation as laws
from rotsolve.core.equation import FAMILIES, KINEMATICS, Equation, Law
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.laws import table

KNOWN = {name: value for name, value in vars(laws).items() if isinstance(value, Law)}


@pytest.mark.parametrize("row", table.LAWS, ids=lambda row: str(row.function))
def test_a_row_names_a_function_that_says_what_it_does(row: table.Principle) -> None:
    assert isinstance(row.function, str)
    assert table.loaded(row.function).__doc__
    assert row.laws
    assert row.scopes


def test_every_law_has_a_name_and_a_family() -> None:
    assert len({law.name for law in KNOWN.values()}) == len(KNOWN)
    assert all(law.family in ("", KINEMATICS, *FAMILIES) for law in KNOWN.values())
    assert tuple(FAMILIES) == NAMED


def test_rows_write_the_laws_that_they_name(
    scenes: list[Path], readings: Callable[[Path], tuple[SceneEquations, ...]], monkeypatch: pytest.MonkeyPatch
) -> None:
    told: list[tuple[table.Principle, Equation]] = []

    def watched(scope: str, at: table.AtMoment) -> list[Equation]:
        found = []
        for row in table.LAWS:
            if scope in row.scopes and isinstance(row.function, str):
                own = list(table.loaded(row.function)(at))
                told.extend((row, equation) for equation in own)
                found += own
        return found

    monkeypatch.setattr("rotsolve.equations.scene_equations.equations_for", watched)
    monkeypatch.setattr("rotsolve.equations.swing.equations_for", watched)
    for path in scenes:
        for reading in readings(path):
            list(reading._written())
    assert told
    assert not [(row.function, equation.law.name) for row, equation in told if equation.law not in row.laws]
