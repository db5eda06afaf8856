"""Typing mistakes in real scenes: each ends in a message about itself, at its place, and in nothing that only follows from it."""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from pathlib import Path

import pytest

from rotsolve.core.faults import Fault, SceneError
from rotsolve.scene.read import read_text

ROOT = Path(__file__).resolve().parents[2]
SCENES = sorted((ROOT / "problems").rglob("*.yaml"))
MOST_EVER = 6  # faults that one mistake brings: a line that is elsewhere may be missed in many places
OTHER_UNITS = ("kg", "m", "s", "N", "rad/s", "J")
Mistake = Callable[[random.Random, str], str]  # the text with one mistake, or as it was where there is no place for it


def at_one(chance: random.Random, text: str, pattern: str, put: Callable[[re.Match[str]], str]) -> str:
    """The text with one of the places that a pattern finds, below the statement of the problem, changed."""
    begin = text.index("given:") if "given:" in text else 0
    found = [match for match in re.finditer(pattern, text, re.M) if match.start() >= begin]
    if not found:
        return text
    match = chance.choice(found)
    return text[: match.start()] + put(match) + text[match.end() :]


def a_letter_less(chance: random.Random, word: str) -> str:
    place = chance.randrange(len(word))
    return word[:place] + word[place + 1 :]


def lines_changed(chance: random.Random, text: str, change: Callable[[list[str], int], None]) -> str:
    lines = text.split("\n")
    change(lines, chance.randrange(len(lines) - 1))
    return "\n".join(lines)


def swap(lines: list[str], place: int) -> None:
    lines[place : place + 2] = reversed(lines[place : place + 2])


def double(lines: list[str], place: int) -> None:
    lines.insert(place, lines[place])


MISTAKES: dict[str, Mistake] = {
    "colon": lambda chance, text: at_one(chance, text, r":(?= )", lambda _: ""),
    "blank after a colon": lambda chance, text: at_one(chance, text, r"(?<=:) (?=\w)", lambda _: ""),
    "bracket": lambda chance, text: at_one(chance, text, r"[{}\[\]]", lambda _: ""),
    "bracket of a formula": lambda chance, text: at_one(chance, text, r"[()]", lambda _: ""),
    "comma": lambda chance, text: at_one(chance, text, r",(?= )", lambda _: ""),
    "indent": lambda chance, text: at_one(chance, text, r"^  (?=\w)", lambda _: ""),
    "indent of one": lambda chance, text: at_one(chance, text, r"^ (?= \w)", lambda _: ""),
    "indent too far": lambda chance, text: at_one(chance, text, r"^  (?=\w)", lambda _: "   "),
    "letter of a key": lambda chance, text: at_one(
        chance, text, r"\b[a-z_]{4,}(?=:)", lambda match: a_letter_less(chance, match[0])
    ),
    "letter of a word": lambda chance, text: at_one(
        chance, text, r"(?<=[\s.\[])[a-z_]{4,}(?=[\s.,\]}])", lambda match: a_letter_less(chance, match[0])
    ),
    "unit": lambda chance, text: at_one(chance, text, r"(?<=\d) [a-zA-Z][a-zA-Z/^0-9 ]*(?=[,}\n])", lambda _: ""),
    "unit of another dimension": lambda chance, text: at_one(
        chance,
        text,
        r"(?<=\d )[a-zA-Z][a-zA-Z/^0-9 ]*(?=[,}\n])",
        lambda match: chance.choice([unit for unit in OTHER_UNITS if unit != match[0]]),
    ),
    "letter that is not given": lambda chance, text: at_one(
        chance, text, r"(?<=: )[a-zA-Z]\w?(?=[,}\n*/])", lambda _: "qz"
    ),
    "sign": lambda chance, text: at_one(chance, text, r"(?<=: )(?=\d)", lambda _: "-"),
    "decimal comma": lambda chance, text: at_one(chance, text, r"(?<=\d)\.(?=\d)", lambda _: ","),
    "lines swapped": lambda chance, text: lines_changed(chance, text, swap),
    "line twice": lambda chance, text: lines_changed(chance, text, double),
    "capital": lambda chance, text: at_one(chance, text, r"\b[a-z]+(?=: )", lambda match: match[0].capitalize()),
    "tab": lambda chance, text: at_one(chance, text, r"^  (?=\w)", lambda _: "\t"),
    "quotation mark": lambda chance, text: at_one(chance, text, r"(?<=: )(?=\w)", lambda _: '"'),
}


def faults_of(text: str) -> tuple[Fault, ...]:
    """The faults of a text; none where it reads."""
    try:
        read_text(text, "x.yaml")
    except SceneError as error:
        return error.faults
    return ()


def changed_lines(before: str, after: str) -> set[int]:
    """The lines, from 1, in which two texts differ, and those that follow at once."""
    old, new = before.split("\n"), after.split("\n")
    same = next(
        (k for k, (one, other) in enumerate(zip(old, new, strict=False)) if one != other), min(len(old), len(new))
    )
    return {same, same + 1, same + 2, same + 3}


def places(fault: Fault) -> set[int]:
    """The lines of which a fault speaks."""
    return {span.line for span in (fault.span, *(other.span for other in fault.related)) if span is not None}


def test_the_scenes_have_no_faults() -> None:
    assert len(SCENES) > 400
    assert [path.name for path in SCENES if faults_of(path.read_text(encoding="utf-8"))] == []


@pytest.mark.parametrize("mistake", MISTAKES)
def test_each_mistake_is_told_once_at_its_place(mistake: str, pytestconfig: pytest.Config) -> None:
    """In many scenes, drawn with a seed: few faults for one mistake, nearly always one, which speaks of the line that was changed."""
    chance = random.Random(f"{mistake} in a scene")
    drawn, faulty, alone, there = 0, 0, 0, 0
    while drawn < (400 if pytestconfig.getoption("exhaustive") else 40):
        text = chance.choice(SCENES).read_text(encoding="utf-8")
        wrong = MISTAKES[mistake](chance, text)
        drawn += 1
        found = faults_of(wrong) if wrong != text else ()
        if found:
            faulty += 1
            alone += len(found) == 1
            there += bool(changed_lines(text, wrong) & set().union(*(places(fault) for fault in found)))
            assert len(found) <= MOST_EVER, wrong
    assert faulty >= drawn // 4
    assert alone >= 0.9 * faulty
    assert there >= 0.9 * faulty
