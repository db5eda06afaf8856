"""Directions: the words behind a value that say which way it points: `5 N to the left`, `3 rad/s clockwise`."""

from __future__ import annotations

import re

_WORDS = {
    "left": r"left(?:wards?)?|←|\\leftarrow",
    "right": r"right(?:wards?)?|→|\\rightarrow",
    "up": r"up(?:wards?|hill)?|vertically up(?:wards?)?|↑|\\uparrow",
    "down": r"down(?:wards?|hill)?|vertically down(?:wards?)?|↓|\\downarrow",
    "counterclockwise": r"counter-?\s?clockwise|anti-?\s?clockwise|ccw|↺",
    "clockwise": r"clockwise|cw|↻",
    "forward": r"forwards?",
    "back": r"back(?:wards?)?",
}
_GROUPS = "|".join(f"(?P<{word}>{pattern})" for word, pattern in _WORDS.items())
_SLOPE = r"(?P<slope>\s+(?:along\s+)?the\s+(?:slope|incline|inclined plane|plane|ramp|hill))?"
_TAIL = (  # compiled when a line first needs it
    rf"(?<![A-Za-z_\\])[\s,;(\[]*(?:\\text\s*\{{\s*)?(?:(?:directed|pointing|acting|to|towards|on)\s+)*(?:the\s+)?(?:{_GROUPS}){_SLOPE}[\s).}}\]$]*$"
)
_ENDINGS = "ft ht rd ds up wn se cw ck ne pe mp ll ow"
ENDINGS = frozenset((*_ENDINGS.split(), *"←→↑↓↺↻"))  # the last letters of these words
LONGEST = 80  # columns of such words


def direction_behind(text: str, start: int) -> tuple[str, int]:
    """The direction that the last words of a line tell ('' if none), and where these words begin."""
    ending = text.rstrip(" .)}]$")[-2:].lower()
    if ending not in ENDINGS and ending[-1:] not in ENDINGS:
        return "", len(text)
    match = re.compile(_TAIL, re.IGNORECASE).search(text, max(start, len(text) - LONGEST))
    if match is None or not text[start : match.start()].strip():
        return "", len(text)
    word = next(name for name in _WORDS if match[name])
    return (f"{word} the slope" if match["slope"] else word), match.start()
