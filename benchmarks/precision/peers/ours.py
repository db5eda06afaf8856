"""rotsolve: `solve` for numbers and `simulate` for motions, each number with the bound that it claims."""

from __future__ import annotations

import sys
from decimal import Decimal
from pathlib import Path

from ..problem import Problem, Way

ROOT = Path(__file__).resolve().parents[3]
FLOATS_SUFFICE = 1e-14  # accuracy from which on a float no longer holds what is asked
Claim = tuple[str, str]  # a value and its bound


def settings_of(problem: Problem) -> dict[str, str]:
    """The givens that a problem sets, as `--set` would."""
    return dict(text.split("=", 1) for text in problem.sets)


def command(problem: Problem, setting: str) -> list[str]:
    """The same on the command line, as anyone would type it."""
    scene, sets = str(ROOT / problem.scene), [part for text in problem.sets for part in ("--set", text)]
    if problem.simulated:
        until = f"{problem.until}s"
        asked = ["simulate", scene, "--until", until, "--step", until, "--accuracy", setting, "--csv"]
    else:
        asked = ["solve", scene, "--digits", setting, "--format", "json"]
    return [sys.executable, "-m", "rotsolve", *asked, *sets]


def solve(problem: Problem, setting: str) -> list[Claim]:
    """`rotsolve.solve`; all digits that it prints are certified, so it may be half a unit of the last one off."""
    import rotsolve

    solution = rotsolve.solve(ROOT / problem.scene, settings=settings_of(problem), digits=int(setting))
    values = [str(solution.answers[name].value) for name in problem.asks]
    return [(value, half_of_last_place(value)) for value in values]


def half_of_last_place(value: str) -> str:
    """Half a unit of the last digit that is written: 0.005 for 1.23."""
    exponent = Decimal(value).as_tuple().exponent
    assert isinstance(exponent, int), value
    return str(Decimal(5).scaleb(exponent - 1))


def simulate(problem: Problem, setting: str) -> list[Claim]:
    """`rotsolve.simulate` to an accuracy, read at the end."""
    from rotsolve.simulation import simulate

    accuracy, until = float(setting), float(problem.until)
    run = simulate(ROOT / problem.scene, until=f"{problem.until} s", accuracy=accuracy, settings=settings_of(problem))
    if accuracy > FLOATS_SUFFICE:
        told = run.at(until)
        return [(exact(told[name][0]), exact(told[name][1])) for name in problem.asks]
    balls = run.balls(until)
    return [(balls[name].mid().str(60, radius=False), str(float(balls[name].rad()))) for name in problem.asks]


def exact(number: float) -> str:
    """A float as the number that it is; its shortest decimal is another one."""
    return str(Decimal(number))


def ways(problem: Problem) -> dict[str, Way]:
    """All who answer a problem, ours first."""
    if problem.simulated:
        ours = Way(("rotsolve",), "accuracy", ("1e-6", "1e-9", "1e-12", "1e-15", "1e-20"), simulate)
    else:
        ours = Way(("rotsolve",), "digits", ("6", "10", "15", "30", "50"), solve)
    return {"rotsolve": ours, **problem.peers}
