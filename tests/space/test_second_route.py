"""Every answer of problems/space by a second route, with the file's numbers and two other sets; and that every file has two routes."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import second_route
from rotsolve.arrays import single_answers
from rotsolve.pipeline import solve
from rotsolve.solution import Solution
from second_route.numbers import givens, in_si, named, others
from solutions import solved

FILES = sorted((Path(__file__).resolve().parents[2] / "problems" / "space").glob("*.yaml"))
ALIKE = 1e-9


def singles(found: dict[str, Any]) -> dict[str, Any]:
    """Vectors and tensors component by component, as `single_answers` has them."""
    parts: dict[str, Any] = {}
    for name, value in found.items():
        if isinstance(value, str) or np.ndim(value) == 0:
            parts[name] = value
        elif isinstance(value, list):
            parts |= {f"{name}.{k + 1}": item for k, item in enumerate(value)}
        elif np.ndim(value) == 1:
            parts |= dict(zip((f"{name}.{axis}" for axis in "xyz"), value, strict=True))
        else:
            parts |= {f"{name}.{'xyz'[i]}{'xyz'[j]}": value[i, j] for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0))}
    return parts


def own(solution: Solution) -> dict[str, Any]:
    return {name: one.word or one.value.float for name, one in single_answers(solution.derivation.answers)}


@pytest.mark.parametrize("file", FILES, ids=lambda file: file.stem)
def test_own(file):
    found = singles(second_route.CALCULATIONS[file.stem](named(in_si(file, givens(file)))))
    print(file.stem)
    printed = own(solved(file))
    assert found.keys() == printed.keys()
    for name, v in printed.items():
        w = found[name]
        if isinstance(v, str):
            assert v == w
        else:
            print(name, v, w, (w - v) / v if v else w)
            assert abs(w - v) <= ALIKE * abs(v) if v else abs(w) <= 1e-9, name
