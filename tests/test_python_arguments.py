"""What Python is given that it can't use: each is refused by an error of the right kind that says what is wanted."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import sympy

import rotsolve

PROBLEMS = Path(__file__).resolve().parents[1] / "problems"
DISC, ROD = PROBLEMS / "pulleys" / "block-on-disc.yaml", PROBLEMS / "hinged" / "rod-30.yaml"


@pytest.mark.parametrize(
    ("work", "kind", "said"),
    [
        (lambda: rotsolve.solve(DISC, digits="x"), TypeError, "digits are a whole number, not 'x'"),
        (lambda: rotsolve.solve(DISC, digits=0), ValueError, "from 1 to 1000 digits can be asked for, not 0"),
        (lambda: rotsolve.solve(DISC)["a"].certified(2.5), TypeError, "digits are a whole number, not 2.5"),
        (lambda: rotsolve.solve(DISC)["a"].certified(-2), ValueError, "from 1 to 1000 digits"),
        (lambda: rotsolve.solve(DISC)["a"].certified(10**6), ValueError, "from 1 to 1000 digits"),
        (lambda: rotsolve.solve(DISC)["a"].in_unit(5), TypeError, "a unit is a text, not 5"),
        (lambda: rotsolve.solve(DISC, settings={"m": float("inf")}), rotsolve.SceneError, "is no value"),
        (lambda: rotsolve.solve(DISC, settings={"m": 10**400}), rotsolve.SceneError, "too long for a quantity"),
        (lambda: rotsolve.check(DISC, None), TypeError, "answers are a dict, a text or a path, not None"),
        (lambda: rotsolve.simulate(ROD, until=None), TypeError, "until a time such as '2 s'"),
        (lambda: rotsolve.simulate(ROD, until="1 s", accuracy="x"), TypeError, "an accuracy such as 1e-8"),
        (lambda: rotsolve.simulate(ROD, until=0.1).to_frame(-2), ValueError, "a table has a row at least, not -2"),
        (
            lambda: rotsolve.simulate(ROD, until=0.1).at(0.1, "rod.angel"),
            rotsolve.Unsolvable,
            "did you mean `rod.angle`?",
        ),
    ],
)
def test_it_is_refused(work: Callable[[], Any], kind: type[Exception], said: str) -> None:
    with pytest.raises(kind) as error:
        work()
    assert said in str(error.value)


def test_answers_of_sympy_and_none() -> None:
    m, M, g = sympy.symbols("m M g")
    marked = rotsolve.check(DISC, {"a": 2 * m * g / (2 * m + M), "T": None})
    assert marked["a"].outcome == "right" and marked["T"].outcome == "no answer"
