"""Signs: directions in words, and answers that are right but for the direction that is counted as positive."""

from __future__ import annotations

import re

from rotsolve.grading.verdict import RIGHT, WRONG, Finding, found
from rotsolve.language.marks import LENIENT, Marking

OPPOSITE = {
    "up": "down",
    "left": "right",
    "clockwise": "counterclockwise",
    "inwards": "outwards",
}
OPPOSITE |= {other: one for one, other in OPPOSITE.items()}
SYNONYMS = {  # other words for a direction
    "anticlockwise": "counterclockwise",
    "anti-clockwise": "counterclockwise",
    "counter-clockwise": "counterclockwise",
    "ccw": "counterclockwise",
    "cw": "clockwise",
    "upward": "up",
    "upwards": "up",
    "downward": "down",
    "downwards": "down",
    "leftward": "left",
    "leftwards": "left",
    "rightward": "right",
    "rightwards": "right",
    "inward": "inwards",
    "outward": "outwards",
    "uphill": "up",
    "downhill": "down",
}
SPOKEN = re.compile("|".join(sorted({*OPPOSITE, *SYNONYMS}, key=len)), re.IGNORECASE)
BESIDE = re.compile(
    r"\b(?:i\.e\.|to the|towards the|straight|vertically|horizontally|directed|pointing|turning it|turning|and|along)(?=\W|$)|,"
)
WHERE = re.compile(r"\b(?:(?:round|around|on|in|of|about)\s+)?(?:the|a|an)\s+\w+")

Directions = frozenset[str]


def plain_directions(words: str) -> Directions:
    """A direction in words as a set of plain ones: "up and to the left" is up, left; where it is ("the slope") goes unsaid."""
    plain = WHERE.sub(" ", BESIDE.sub(" ", words.lower()))
    return frozenset(SYNONYMS.get(word, word) for word in plain.split())


def is_direction(words: str) -> bool:
    """Whether every word says a direction."""
    if SPOKEN.search(words) is None:
        return False
    parts = plain_directions(words)
    return bool(parts) and parts <= OPPOSITE.keys()


def cut_direction(text: str) -> tuple[str, str]:
    """A line without the direction in words behind its last commas, and these words: `5 N, up and to the left`."""
    if SPOKEN.search(text) is None:
        return text, ""
    for match in re.finditer(",", text):
        tail = text[match.end() :]
        if is_direction(tail):
            return text[: match.start()], tail.strip()
    return text, ""


def points_other_way(typed: str, sought: str) -> bool | None:
    """Whether a direction is the other way round, None where it is neither this nor the same."""
    own, wanted = plain_directions(typed), plain_directions(sought)
    return False if own == wanted else True if own == frozenset(OPPOSITE.get(word, word) for word in wanted) else None


def right_but_for_sign(directed: bool, direction: str, positive: str, sign: int | None, marking: Marking) -> Finding:
    """What is said of an answer with the other sign: it is marked as the teacher chose. `direction` is that of the answer, `positive`
    that of a positive value, '' where the answer is a size."""
    if not directed:
        return found(WRONG, "sign", "right but for the sign")
    said = "right but for the sign: the other direction is declared positive"
    if direction and positive:
        way = "" if direction == positive else f", and it is {direction}"
        said = f"right but for the sign: {positive} is declared positive{way}"
    elif direction and sign == 1:
        said = f"right but for the sign: its size is asked for; it points {direction}"
    return found(RIGHT if marking.sign == LENIENT else WRONG, "sign", said)
