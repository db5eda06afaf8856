"""The file of references: made anew by both routes, and read."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path

FILE = Path(__file__).with_name("references.json")
WORKING, KEPT = 90, 60  # digits


def references() -> dict[str, tuple[Fraction, ...]]:
    """The references as exact numbers, by problem."""
    kept = json.loads(FILE.read_text(encoding="utf-8"))
    return {name: tuple(Fraction(value) for value in values) for name, values in kept.items()}


def agreeing(name: str) -> list[str]:
    """The reference of a problem, on which both routes agree; else an error."""
    from mpmath import mp

    from ..problems import PROBLEMS
    from .routes import ROUTES

    with mp.workdps(WORKING):
        one, other = (route(PROBLEMS[name]) for route in ROUTES[name])
        for ours, theirs in zip(one, other, strict=True):
            if abs(ours - theirs) > abs(ours) * mp.mpf(10) ** -KEPT:
                raise ArithmeticError(f"{name}: {mp.nstr(ours, KEPT)} by one route, {mp.nstr(theirs, KEPT)} by the other")
        return [mp.nstr(value, KEPT) for value in one]


def make() -> None:
    """Calculate all references and write the file."""
    from ..problems import PROBLEMS

    made = {}
    for name in PROBLEMS:
        made[name] = agreeing(name)
        print(f"{name}: both routes agree to {KEPT} digits", flush=True)
    FILE.write_text(json.dumps(made, indent=2) + "\n", encoding="utf-8")
