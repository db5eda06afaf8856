"""Every scene that comes with the project is followed, with energy and momentum in balance, or refused by name."""

from __future__ import annotations

from pathlib import Path

import pytest

from rotsolve import Unsolvable, simulate

ROOT = Path(__file__).resolve().parents[2]
SCENES = sorted([*(ROOT / "problems").rglob("*.yaml"), *(ROOT / "tests" / "engine" / "scenes").glob("*.yaml")])
FOLLOWED = 200  # scenes at least


UNSTABLE = {"cube-tips-on-a-smooth-floor": 1e-6}  # starts from a balance in which what is rounded grows


def attempt(path: Path) -> bool:
    """Whether a scene can be followed; its balances hold then."""
    try:
        run = simulate(path, 1)
    except Unsolvable as error:
        assert error.fault.message and "internal" not in error.fault.message
        return False
    found = run.at(run.end)
    assert all(bound >= 0 for _, bound in found.values())
    most = UNSTABLE.get(path.stem, 1e-8)
    assert (run.drift.energy or 0.0) < 1e-8 and (run.drift.momentum or 0.0) < most
    return True


@pytest.mark.sampled(4)
@pytest.mark.parametrize("folder", sorted({path.parent for path in SCENES}), ids=lambda folder: folder.name)
def test_energy_and_momentum_balance(folder: Path) -> None:
    for path in SCENES:
        if path.parent == folder:
            attempt(path)


@pytest.mark.exhaustive
def test_most_scenes_are_followed() -> None:
    assert sum(map(attempt, SCENES)) >= FOLLOWED
