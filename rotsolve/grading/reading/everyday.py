"""Everyday: other marks and words than formulas have, put into theirs: `60 percent`, `2 : 7`, `\\SI{2}{N}`, `nach unten`.

Each takes as many columns as before, so that every other character keeps its own.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from rotsolve.grading.comparing.signs import SPOKEN

_DIGITS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹₀₁₂₃₄₅₆₇₈₉⁄", "01234567890123456789/")
_FRACTION = re.compile(r"(?<![\w)\]⁰-⁹])[⁰¹²³⁴-⁹]+[⁄/][₀-₉]+")
_GROUP = r"\{((?:[^{}]|\{[^{}]*\})*)\}"
_SIUNITX = re.compile(rf"\\(?:SI|qty)\s*(?:\[[^\]]*\]\s*)?{_GROUP}\s*{_GROUP}")
_UNIT_ALONE = re.compile(rf"\\(?:si|unit|num)\s*{_GROUP}")
_PREFIX = re.compile(r"\\(milli|centi|deci|kilo|mega|giga|micro|nano)\\(?=[a-z])")
_TO_POWER = re.compile(r"\\(square|cubic)\\([a-z]+)")
_MACRO = re.compile(r"\\(per|squared|cubed|percent|degree|[a-z]+)(?![a-z])")
_MACROS = {"per": "/", "squared": "^2", "cubed": "^3", "percent": "%", "degree": "°"}
_WORDS = (  # what is written, and the mark or word for it
    (r"(?<=\d)\s*(?:per\s?cent|percent|pct|Prozent)\b\.?", "%"),
    (r"(?<=[A-Za-z]{3})['’]s\b", "s"),
    (
        r"(?<=\s)(?:(?:is|are)\s+(?:about|approximately|approx\.?|roughly|nearly)?\s*equal\s+to|(?:is|are)\s+(?:approximately|approx\.?|roughly|about)"
        r"(?=\s*[-+−\d.√\\])|(?:approximately|approx\.?|roughly)\s+equals|ist\s+(?:ungefähr|etwa|rund|circa|ca\.)?\s*gleich|ist\s+(?:ungefähr|etwa|rund)"
        r"(?=\s*[-+−\d.,√\\]))",
        "=",
    ),
    (r"\b(?:gegen\s+den|entgegen\s+dem)\s+Uhrzeigersinn\b", "anticlockwise"),
    (r"\bim\s+Uhrzeigersinn\b", "clockwise"),
    (r"\b(?:nach\s+unten|hangabwärts|abwärts|hinunter)\b", "down"),
    (r"\b(?:nach\s+oben|hangaufwärts|aufwärts|hinauf)\b", "up"),
    (r"\bnach\s+links\b", "left"),
    (r"\bnach\s+rechts\b", "right"),
)
_READ = [(re.compile(pattern, re.IGNORECASE), word) for pattern, word in _WORDS]
_HINT = re.compile(
    r"[⁰-⁹₀-₉\\'’]|per ?cent|pct|prozent|equal|approx|rough|about|gleich|ist\s|nach|wärts|hinu|hina|uhrzeiger",
    re.IGNORECASE,
)
_NUMBER = r"(?:[√]?\s*\d+(?:[.,]\d+)?|√\(\d+\))"
_RATIO = re.compile(
    rf"(?P<before>^|.*=)(?P<left>\s*\$?\s*{_NUMBER}\s*)(?P<mark>:|zu)(?P<right>\s*{_NUMBER}\s*\$?\s*\.?)$"
)
_HEAD = re.compile(r"\s*(?P<words>[^\W\d_][^=:;→⇒<>]{2,60}):(?!=)(?=[^:]*=)")
_ASIDE = re.compile(
    r"(?<=\S)[\s,]+(?P<open>\()?(?P<words>(?:for|if|when|while|as|since|because|assuming|für|falls|wenn|während|da|weil)\s[A-Za-zäöüßÄÖÜ\s-]+)(?(open)\))[\s.]*$"
)
_BEHIND = re.compile(r"(?<=[^\s=≈:])[\s,]+(?P<word>[A-Za-zäöüßÄÖÜ]+)(?:[\s.]*$)?")
LINKS = frozenset(("of", "the", "from", "at", "in", "about", "to", "a", "an", "by", "von", "vom", "der", "des", "dem"))
_TURNS = """
    not no never nor or wrong minus negative times half twice double less more unless except only nicht kein keine oder falsch halb doppelt
    nur mal
"""
TURNS = frozenset(_TURNS.split())  # words that may change what is said


def in_as_many_columns(word: str) -> Callable[[re.Match[str]], str]:
    """What puts a word in the columns of a match."""
    return lambda match: word.ljust(len(match[0]))


def everyday(text: str) -> str:
    """The line with plain marks for what stands in others."""
    if _HINT.search(text) is None:
        return text
    text = _FRACTION.sub(lambda match: match[0].translate(_DIGITS), text)
    if "\\" in text:
        text = _SIUNITX.sub(_plain_quantity, text)
        text = _UNIT_ALONE.sub(lambda match: _plain_unit(match[1]).rjust(len(match[0])), text)
    for pattern, word in _READ:
        text = pattern.sub(in_as_many_columns(word), text)
    return text


def _plain_quantity(match: re.Match[str]) -> str:
    """`\\SI{2.96}{m/s^2}` as a number with its unit."""
    return f"{match[1]} {_plain_unit(match[2])}".rjust(len(match[0]))


def _plain_unit(macros: str) -> str:
    """A unit of siunitx in marks: \\metre\\per\\second\\squared is metre/second^2."""
    unit = _PREFIX.sub(r" \1", macros)
    unit = _TO_POWER.sub(lambda match: f" {match[2]}{'^2' if match[1] == 'square' else '^3'}", unit)
    return _MACRO.sub(lambda match: _MACROS.get(match[1], f" {match[1]}"), unit).strip()


def quotient_of_ratio(text: str) -> str:
    """`2 : 7` as 2/7, where nothing else stands in the line but a name in front."""
    found = _RATIO.match(text)
    return text if found is None else f"{text[: found.start('mark')]}{'/'.ljust(len(found['mark']))}{found['right']}"


def without_head(text: str, letters: frozenset[str]) -> str:
    """A line of working without the words in front that say what it is, `Sum of torques: …`."""
    head = _HEAD.match(text)
    if head is None or not any(
        len(word) > 2 and word not in letters for word in re.findall(r"[^\W\d_]+", head["words"])
    ):
        return text
    return " " * head.end() + text[head.end() :]


def cut_clause(text: str, names: frozenset[str]) -> tuple[str, str]:
    """The line without the words behind it that say when or of what it holds, `when it rolls`, and these; '' where there are none.

    With the name of a letter or of another body among them, or a word that turns what is said, they stay.
    """
    found = _ASIDE.search(text)
    words = () if found is None else tuple(found["words"].lower().split())
    if found is None or any(word in TURNS or word in names for word in words):
        return text, ""
    return text[: found.start()].ljust(len(text)), found["words"].strip()


def without_nouns(text: str, nouns: frozenset[str], letters: frozenset[str]) -> str:
    """The line without the words behind its value that name what is asked: `0.15 J lost`, `0.60 m from the pin`."""
    words = list(_BEHIND.finditer(text))
    known = 0
    while known < len(words) and words[-1 - known].end() == (words[-known].start() if known else len(text)):
        word = words[-1 - known]["word"].lower()
        if word in letters or SPOKEN.fullmatch(word) or not (word in LINKS or (word in nouns and len(word) > 2)):
            break
        known += 1
    cut = words[len(words) - known :]
    if not any(match["word"].lower() in nouns for match in cut) or not text[: cut[0].start()].strip():
        return text
    return text[: cut[0].start()].ljust(len(text))
