"""The givens of a scene in SI units, as one types them off the page, and other sets of numbers near them."""

from __future__ import annotations

import random
import re
from math import pi
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import yaml

UNITS = {
    **dict.fromkeys(("kg", "m", "s", "N", "J", "rad"), 1.0),
    "lb": 0.45359237,
    "lbf": 4.4482216152605,
    "ft": 0.3048,
    "in": 0.0254,
    "g": 1e-3,
    "t": 1e3,
    "cm": 1e-2,
    "mm": 1e-3,
    "km": 1e3,
    "min": 60.0,
    "day": 86400.0,
    "deg": pi / 180,
    "rev": 2 * pi,
}
WITH_UNIT = re.compile(r"([-+.\de]+)\s*(.*)")
FACTOR = re.compile(r"([/ ]?)\s*([A-Za-z]+)(?:\^(\d+))?")
NEAR = 0.02  # tops stay bodies that can be, and every inequality between the givens what it is
STANDARD_GRAVITY = 9.8  # of scenes that say none


def unit_size(text: str) -> float:
    size = 1.0
    for mark, word, power in FACTOR.findall(text):
        size *= UNITS[word] ** ((-1 if mark == "/" else 1) * int(power or 1))
    return size


def givens(file: Path) -> dict[str, tuple[float, str]]:
    """Numbers and units; letters without a number, and unknowns, are left out."""
    found = {}
    for name, value in (yaml.safe_load(file.read_text(encoding="utf-8")).get("given") or {}).items():
        match = WITH_UNIT.fullmatch(str(value))
        if match:
            found[name] = (float(match[1]), match[2])
    return found


def letters(file: Path) -> list[str]:
    """Givens that have a unit alone."""
    whole = yaml.safe_load(file.read_text(encoding="utf-8")).get("given") or {}
    return [name for name in whole if name not in givens(file) and whole[name] != "unknown"]


def near(file: Path, seed: int) -> dict[str, tuple[float, str]]:
    """The givens by up to `NEAR` of their own numbers away from these."""
    chance = random.Random(f"{file.stem} {seed}")
    return {name: (number * chance.uniform(1 - NEAR, 1 + NEAR), unit) for name, (number, unit) in givens(file).items()}


def in_si(file: Path, numbers: dict[str, tuple[float, str]]) -> dict[str, float]:
    """With numbers for letters that have none."""
    chance = random.Random(file.stem)
    free = {name: chance.uniform(0.5, 2.0) for name in letters(file)}
    return free | {name: number * unit_size(unit) for name, (number, unit) in numbers.items()}


def named(numbers: dict[str, float]) -> Any:
    return SimpleNamespace(**({"g": STANDARD_GRAVITY} | numbers))
