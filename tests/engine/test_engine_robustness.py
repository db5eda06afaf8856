"""Whatever a scene says, it is solved, refused with its faults, or said to have no answer: no other exception, and soon.

ROTSOLVE_MUTANTS=5000 tries more of them than an ordinary run does.
"""

from __future__ import annotations

import os
import random
import re
import time
from pathlib import Path

import pytest

import mutants
from rotsolve.core.derivation import Derivation
from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.core.quantity import QUANTITIES
from rotsolve.pipeline import solve
from rotsolve.solution import Solution
from solutions import solved

HERE = Path(__file__).resolve().parent
FILES = sorted([*(HERE / "scenes").glob("*.yaml"), *(HERE.parent.parent / "problems").rglob("*.yaml")])
MUTANTS, BATCHES = int(os.environ.get("ROTSOLVE_MUTANTS", "150")), 10
SECONDS = 5.0
INTERNAL = re.compile(
    rf"\b(?:{'|'.join(kind.word for kind in QUANTITIES.values())}|asked)\|[^ ]|~|\^[a-z]|[(\[]'|None\b"
)


def all_texts(solution: Solution) -> dict[str, str]:
    """All that a solution can print."""
    formats = {name: solution.to(name) for name in ("text", "markdown", "latex", "html", "json")}
    return formats | {
        "facts": solution.facts_text(),
        "equations": solution.equations_text(),
        "plan": solution.plan_text(),
    }


def assert_readable(texts: dict[str, str], where: str) -> None:
    for name, text in texts.items():
        for line in text.splitlines():
            assert not INTERNAL.search(line), f"{where}, {name}: {line}"


def assert_in_order(derivation: Derivation, where: str) -> None:
    """No step puts to use what is printed after it."""
    printed: set[str] = set()
    for section in derivation.sections:
        printed |= {str(law.number) for law in section.laws}
        for move in section.moves:
            assert set(re.findall(r"\((\d+)\)", move.sources)) <= printed, f"{where}: {move.sources}"
            printed.add(str(move.number))


@pytest.mark.sampled(3)
@pytest.mark.parametrize("path", FILES, ids=[path.stem for path in FILES])
def test_no_internal_name_is_printed_and_nothing_used_before_it_is_found(path: Path) -> None:
    solution = solved(path)
    assert_readable(all_texts(solution), path.name)
    assert_in_order(solution.derivation, path.name)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("batch", range(BATCHES))
def test_a_spoilt_scene_is_answered_or_refused(batch: int) -> None:
    for seed in range(batch, MUTANTS, BATCHES):
        chance = random.Random(seed)
        path = chance.choice(FILES)
        text = mutants.mutant(chance, path.read_text(encoding="utf-8"))
        start = time.process_time()
        try:
            assert_readable(all_texts(solve(text)), f"mutant {seed}")
        except SceneError as error:
            assert error.faults and str(error).startswith("error: ")
        except Unsolvable as error:
            assert_readable({"message": str(error).partition("\n")[0], "help": error.fault.help}, f"mutant {seed}")
        except Exception as error:
            raise AssertionError(f"mutant {seed}: {type(error).__name__}: {error}\n{text}") from error
        assert time.process_time() - start < SECONDS, f"mutant {seed} takes long:\n{text}"
