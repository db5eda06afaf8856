"""Words of messages: quoting what the user wrote, listing what is allowed, and guessing what was meant."""

from __future__ import annotations

from collections.abc import Iterable

from rotsolve.core.faults import printable

LONGEST = 60


def quoted(text: str) -> str:
    """`text` between backquotes, on one line and not too long."""
    line = printable(" ".join(text.split()) if text.strip() else text)
    return f"`{line[: LONGEST - 1]}…`" if len(line) > LONGEST else f"`{line}`"


def joined(names: Iterable[str], last: str = ", ") -> str:
    """The names separated by commas."""
    words = list(names)
    return last.join((", ".join(words[:-1]), words[-1])) if len(words) > 1 and last != ", " else ", ".join(words)


def an(word: str) -> str:
    """The word with its article."""
    return f"{'an' if word[:1] in 'aeiou' else 'a'} {word}"


MEANT = {  # other words for the same thing
    "hoop": "ring",
    "disk": "disc",
    "wheel": "disc",
    "ball": "sphere",
    "shell": "spherical shell",
    "tube": "cylindrical shell",
    "pipe": "cylindrical shell",
    "plate": "rectangle",
    "block": "cuboid",
    "box": "cuboid",
    "brick": "cuboid",
    "stick": "rod",
    "pole": "rod",
    "bar": "rod",
    "chain": "rope",
    "point": "particle",
    "pivot": "hinge",
    "pin": "hinge",
    "cord": "string",
    "cable": "string",
    "rope": "string",
    "prop": "contact",
    "slides": "contact",
    "wire": "torsion",
    "collision": "collides",
    "sticks": "joins",
    "cut": "cuts",
    "blow": "impulse",
    "torque": "couple",
    "moment": "couple",
    "body": "bodies",
    "objects": "bodies",
    "known": "given",
    "data": "given",
    "joints": "connections",
    "links": "connections",
    "forces": "actions",
    "asked": "find",
    "question": "find",
}


def nearest_name(word: str, names: Iterable[str], likeness: float = 0.6) -> str | None:
    """The name that `word` was most likely meant to be; of those that only look like it, one with so much in common at least."""
    if not word or len(word) > LONGEST:
        return None
    from difflib import get_close_matches  # only a faulty scene pays for it

    choices = list(names)
    lower = {name.lower(): name for name in reversed(choices)}
    if word.lower() in lower:
        return lower[word.lower()]
    if MEANT.get(word.lower()) in choices:
        return MEANT[word.lower()]
    found = get_close_matches(word, choices, n=1, cutoff=likeness)
    return found[0] if found else None


class Hint(str):
    """The help of a fault that knows the word which was most likely `meant`: an editor puts it in the place of the fault."""

    meant: str | None

    def __new__(cls, text: str, meant: str | None = None) -> Hint:
        made = super().__new__(cls, text)
        made.meant = meant
        return made


def did_you_mean(guess: str | None, otherwise: str = "") -> Hint:
    """The help line of a guess, or without one of something else."""
    return Hint(f"did you mean `{guess}`?" if guess else otherwise, guess)


def hint(word: str, names: Iterable[str], what: str) -> Hint:
    """The help line for an unknown word: `did you mean …? what: a, b, c`."""
    choices = list(dict.fromkeys(names))
    guess = nearest_name(word, choices)
    meant = f"{did_you_mean(guess)} " if guess else ""
    if not choices:
        name_one = ": name one, such as `states: {start: at rest}`" if what == "states" else ""
        return Hint(f"{meant}there are no {what}{name_one}".strip(), guess)
    return Hint(f"{meant}{what}: {', '.join(choices)}", guess)
