"""Heads: what the comments before a scene say of it: its true values, or the refusal, and the numbers that its letters may have."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from functools import cached_property
from pathlib import Path
from random import Random

import sympy
from msgspec import Struct

NUMBER = re.compile(r"(?P<number>-?\d+(?:\.\d+)?)(?: (?P<unit>\S.*))?")
RANGE = re.compile(r"(\w+) ([\d.]+)\.\.([\d.]+)")
FACTORS = {"deg": math.pi / 180}  # of units that are not those of the SI
G = 9.8  # m/s², where a scene says nothing else
SETS = 4  # of numbers for each scene in letters
ORDINARY = (0.5, 2.5)  # between what a letter lies that the head does not speak of


class Head(Struct, frozen=True, dict=True):
    """The lines `# word: text` before a scene; `open` where it stands alone."""

    lines: dict[str, str]

    @property
    def open(self) -> bool:
        """Whether the scene is known to be wrong still."""
        return "open" in self.lines

    @cached_property
    def true(self) -> dict[str, str]:
        """The true value of each question, as it is written; none where the scene must be refused or flagged."""
        entries = (
            entry.partition(" = ") for entry in self.lines["true"].split("; ") if not entry.startswith(("or ", "must "))
        )
        return {name: value for name, _, value in entries}

    @property
    def refused(self) -> tuple[str, ...]:
        """What a refusal has to name; nothing where there must be an answer."""
        return tuple(name.strip() for name in self.lines.get("refused naming", "").split(",") if name.strip())

    @property
    def flagged(self) -> bool:
        """Whether the scene must be refused, or a check object to its answers."""
        return "flagged" in self.lines

    def value(self, name: str, numbers: Mapping[str, float]) -> float:
        """The true value of a question in SI units, with numbers in the place of letters."""
        text = self.true[name]
        if plain := NUMBER.fullmatch(text):
            return float(plain["number"]) * FACTORS.get(plain["unit"] or "", 1.0)
        values = {"g": G} | dict(numbers)
        letters = {letter: sympy.Symbol(letter) for letter in values}
        formula = sympy.sympify(text.replace("^", "**"), locals=letters)
        return float(formula.subs({letters[letter]: value for letter, value in values.items()}))

    def sets(self, letters: Mapping[str, object], seed: int = 14) -> list[dict[str, float]]:
        """Sets of numbers that make a scene in letters possible: `# between: u 1..3` says what a letter lies between."""
        between = {name: (float(low), float(high)) for name, low, high in RANGE.findall(self.lines.get("between", ""))}
        random = Random(seed)
        known = {"g": (G, G)} | between
        return [{name: round(random.uniform(*known.get(name, ORDINARY)), 3) for name in letters} for _ in range(SETS)]


def head_of(file: Path) -> Head:
    """The head of a scene: the comments at its top."""
    lines: dict[str, str] = {}
    for line in file.read_text(encoding="utf-8").splitlines():
        if not line.startswith("#"):
            break
        word, _, text = line.removeprefix("#").strip().partition(":")
        lines[word] = text.strip()
    return Head(lines)
