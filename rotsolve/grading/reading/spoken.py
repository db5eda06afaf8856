"""Spoken: directions in the languages of the pages, which a student may copy from there: `5,2 N, nach rechts oben`."""

from __future__ import annotations

import re
from functools import cache

ONE_WAY = (
    *("up", "down", "left", "right", "to the left", "to the right", "forward", "back", "inward", "outward", "inwards", "outwards"),
    *("clockwise", "counterclockwise", "up the slope", "down the slope", "towards the centre", "away from the centre"),
    *(f"{rise} and to the {side}" for rise in ("up", "down") for side in ("left", "right")),
)  # fmt: skip
ANGLE = "at {value} to the horizontal"
VALUE = "53"
_WORD = re.compile(r"[^\W\d_]{2,}")


@cache
def spoken_directions() -> tuple[tuple[re.Pattern[str], str], ...]:
    """What the pages say in other languages, the longest first, each with what it is in English."""
    from rotsolve.page.languages import LANGUAGES, language_named
    from rotsolve.page.languages.language import Translation

    said: dict[str, str] = {}
    for language in filter(None, map(language_named, LANGUAGES)):
        page = Translation(language)
        said |= {page.translate(way): way for way in ONE_WAY}
        angle = page.translate(ANGLE.format(value=VALUE))
        said[angle] = ANGLE.format(value=r"\g<value>")
    found = []
    for other, english in sorted(said.items(), key=lambda item: -len(item[0])):
        pattern = re.escape(other).replace(VALUE, r"(?P<value>[\d.,]+\s*°?)")
        found.append((re.compile(rf"(?<!\w){pattern}(?!\w)"), english))
    return tuple(found)


def in_english(text: str) -> str:
    """The line with directions that another language tells in English."""
    if _WORD.search(text) is None:
        return text
    for pattern, english in spoken_directions():
        text = pattern.sub(english, text)
    return text
