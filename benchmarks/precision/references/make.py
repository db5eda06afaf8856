"""The file of references: made anew by both routes, and read."""

from __future__ import annotations

import json
from collections.abc import Iterable
from fractions import Fraction
from pathlib import Path

FILE = Path(__file__).with_name("references.json")
KEPT, GUARD = 60, 30  # digits, and more of them to work with


def references() -> dict[str, tuple[Fraction, ...]]:
    """The references as exact numbers, by problem."""
    kept = json.loads(FILE.read_text(encoding="utf-8"))
    return {name: tuple(Fraction(value) for value in values) for name, values in kept.items()}


def agreeing(name: str, kept: int = KEPT) -> list[str]:
    """The reference of a problem to so many digits, on which both routes agree; else an error."""
    from mpmath import mp

    from ..problems import PROBLEMS
    from .routes import ROUTES

    with mp.workdps(kept + GUARD):
        one, other = (route(PROBLEMS[name]) for route in ROUTES[name])
        for ours, theirs in zip(one, other, strict=True):
            if abs(ours - theirs) > abs(ours) * mp.mpf(10) ** -kept:
                raise ArithmeticError(
                    f"{name}: {mp.nstr(ours, kept)} by one route, {mp.nstr(theirs, kept)} by the other"
                )
        return [mp.nstr(value, kept) for value in one]


def make(names: Iterable[str]) -> None:
    """Calculate the references of some problems anew, and keep those of the others."""
    made = json.loads(FILE.read_text(encoding="utf-8")) if FILE.exists() else {}
    for name in names:
        made[name] = agreeing(name)
        print(f"{name}: both routes agree to {KEPT} digits", flush=True)
        FILE.write_text(json.dumps(made, indent=2) + "\n", encoding="utf-8")
