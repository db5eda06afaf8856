"""Signs: directions in words, and whether one points the other way."""

from __future__ import annotations

import re

OPPOSITE = {"up": "down", "left": "right", "clockwise": "counterclockwise", "inwards": "outwards", "forward": "back"}
OPPOSITE |= {other: one for one, other in OPPOSITE.items()}
_SYNONYMS = {  # other words for a direction
    "counterclockwise": "anticlockwise anti-clockwise counter-clockwise ccw",
    "clockwise": "cw",
    "up": "upward upwards uphill",
    "down": "downward downwards downhill",
    "left": "leftward leftwards",
    "right": "rightward rightwards",
    "inwards": "inward",
    "outwards": "outward",
    "forward": "forwards",
    "back": "backward backwards",
}
SYNONYMS = {word: direction for direction, words in _SYNONYMS.items() for word in words.split()}
SPOKEN = re.compile("|".join(sorted({*OPPOSITE, *SYNONYMS, "centre", "center"}, key=len)), re.IGNORECASE)
BESIDE = re.compile(
    r"\b(?:i\.e\.|to the|towards the|straight|vertically|horizontally|directed|pointing|turning it|turning|and|along)(?=\W|$)|,"
)
ALONG = {"forward": 1, "back": -1}  # words that are told by a motion
TURNING = frozenset(("clockwise", "counterclockwise"))
TO_CENTRE = re.compile(r"\b(?:(?P<to>towards?)|away from) the cent(?:re|er)\b")
WHERE = re.compile(r"\bum\s+\w+|\b(?:(?:round|around|on|in|of|about)\s+)?(?:the|a|an)\s+\w+")


def plain_directions(words: str) -> frozenset[str]:
    """A direction in words as a set of plain ones: "up and to the left" is up, left; where it is ("the slope") goes unsaid."""
    words = TO_CENTRE.sub(lambda match: "inwards" if match["to"] else "outwards", words.lower().strip(" ()."))
    plain = WHERE.sub(" ", BESIDE.sub(" ", words))
    return frozenset(SYNONYMS.get(word, word) for word in plain.split())


def is_direction(words: str) -> bool:
    """Whether every word says a direction."""
    if SPOKEN.search(words) is None:
        return False
    parts = plain_directions(words)
    return bool(parts) and parts <= OPPOSITE.keys()


def cut_direction(text: str) -> tuple[str, str]:
    """A line without the direction in words behind its last commas, and these words: `5 N, up and to the left`; of several words,
    `5 N up and to the left`, without a comma too."""
    if SPOKEN.search(text) is None:
        return text, ""
    for match in re.finditer(r",|(?<=\S)\s+", text):
        tail = text[match.end() :]
        if is_direction(tail) and (match[0] == "," or len(plain_directions(tail)) > 1):
            return text[: match.start()].rstrip(" ,"), tail.strip()
    return text, ""


def points_other_way(typed: str, sought: str, level: str = "") -> bool | None:
    """Whether a direction is the other way round, None where it is neither this nor the same; `level` is a word that may stand for the
    one sought or beside it, right for down a slope that falls to the right."""
    own, wanted = plain_directions(typed), plain_directions(sought)
    if own == wanted or (level and own and own <= wanted | {level}):
        return False
    turned = frozenset(OPPOSITE.get(word, word) for word in wanted)
    return True if own == turned or (level and own and own <= turned | {OPPOSITE.get(level, level)}) else None


def along_motion(typed: str, positive: str) -> str:
    """Words for a direction in which forwards is the declared positive one, and backwards the other; as they are where none is declared."""
    way = next((ALONG[word] for word in plain_directions(typed) if word in ALONG), 0)
    declared = plain_directions(positive)
    if not way or len(declared) != 1 or not declared <= OPPOSITE.keys() - ALONG:
        return typed
    (word,) = declared
    return word if way > 0 else OPPOSITE[word]


def is_unclear(typed: str, sought: str) -> bool:
    """Whether words may or may not say a direction that is told in others: forwards, left round a loop, right down a slope."""
    own, wanted = plain_directions(typed), plain_directions(sought)
    turning = own.isdisjoint(TURNING) != wanted.isdisjoint(TURNING)
    return turning or not own.isdisjoint(ALONG) or WHERE.search(sought) is not None
