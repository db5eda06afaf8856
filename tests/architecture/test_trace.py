"""The trace of a tension in ARCHITECTURE.md: at most 25 hops, each a function that runs, one behind the other."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from types import FrameType

import pytest

import rotsolve

ROOT = Path(__file__).resolve().parents[2]
ROW = re.compile(r"^\| (\d+) \| `(rotsolve[\w.]*):([\w.]+)` \|", re.MULTILINE)
HOPS = [(module, name) for _, module, name in ROW.findall((ROOT / "ARCHITECTURE.md").read_text(encoding="utf-8"))]
SCENE = ROOT / "problems" / "pulleys" / "block-on-disc.yaml"


@pytest.fixture(scope="module")
def returned() -> list[tuple[str, str]]:
    """The hops' functions, in the order in which they return or yield while the scene is solved and printed."""
    found: list[tuple[str, str]] = []
    hops = set(HOPS)

    def watch(frame: FrameType, event: str, _: object) -> None:
        name = (frame.f_globals.get("__name__", ""), frame.f_code.co_qualname)
        if event == "return" and name in hops:
            found.append(name)

    sys.setprofile(watch)
    try:
        rotsolve.solve(SCENE).to("text")
    finally:
        sys.setprofile(None)
    return found


def test_it_is_short() -> None:
    assert 20 <= len(HOPS) <= 25


def test_the_hops_are_taken_in_order(returned: list[tuple[str, str]]) -> None:
    """Each hands on what it has after the one before it did."""
    rest = iter(returned)
    for hop in HOPS:
        assert hop in returned, hop
        assert any(other == hop for other in rest), f"{hop} does not follow the hop before it"
