"""Letters: the givens of a composition, each with a number of few figures."""

from __future__ import annotations

import random

RANGES = {  # unit: smallest and largest size, so that what is drawn is of one scale
    "kg": (0.5, 6.0),
    "m": (0.3, 2.0),
    "m/s": (0.5, 5.0),
    "rad/s": (0.5, 6.0),
    "rad/s^2": (0.5, 6.0),
    "kg m^2": (0.5, 0.95),  # of three any two are more than the third
    "N": (1.0, 40.0),
    "N m": (0.5, 12.0),
    "N s": (0.5, 8.0),
    "N/m": (20.0, 200.0),
    "N m/rad": (5.0, 50.0),
    "N m s": (0.05, 0.5),
    "N s/m": (0.2, 3.0),
    "s": (0.1, 1.5),
    "mm": (0.5, 5.0),
    "": (0.05, 0.9),
    "deg": (8.0, 82.0),
}


class Letters:
    """The givens as they come: one letter for each quantity, with its number."""

    def __init__(self, chance: random.Random) -> None:
        self.chance = chance
        self.given: dict[str, str] = {}

    def number(self, unit: str) -> str:
        """A number with its unit, of two figures."""
        low, high = RANGES[unit]
        return f"{float(f'{self.chance.uniform(low, high):.2g}'):g} {unit}".strip()

    def new(self, letter: str, unit: str) -> str:
        """A letter that no other quantity has, with a number."""
        name, count = letter, 1
        while name in self.given:
            count += 1
            name = f"{letter}{count}"
        self.given[name] = self.number(unit)
        return name
