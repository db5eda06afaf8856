"""Directions in words: up, down, left, right, clockwise, counterclockwise, and their opposites."""

from __future__ import annotations

from rotsolve.core.vectors.heading import DOWN, LEFT, RIGHT, UP, Heading

TURNS = ("counterclockwise", "clockwise")
WORDS = {"right": RIGHT, "up": UP, "left": LEFT, "down": DOWN}
OPPOSITE = {
    "right": "left",
    "left": "right",
    "up": "down",
    "down": "up",
    "forward": "back",
    "back": "forward",
    "clockwise": "counterclockwise",
    "counterclockwise": "clockwise",
}


def opposite(words: str) -> str:
    """The words for the other way along a line: "down the slope" -> "up the slope"."""
    first, _, rest = words.partition(" ")
    return " ".join(part for part in (OPPOSITE.get(first, first), rest) if part)


def along_text(direction: Heading) -> str:
    """A heading in words: right, up, left, down, or at its angle."""
    names = {0: "right", 90: "up", 180: "left", 270: "down"}
    if not direction.terms and direction.degrees % 360 in names:
        return names[int(direction.degrees % 360)]
    return ""
