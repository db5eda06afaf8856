"""Near letters: θ for the only θ₀ of a scene, F for F_low, w1 for ω₁: what is no letter of it, where exactly one can be meant."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping

from msgspec.structs import replace

from rotsolve.algebra.formula import Symbol
from rotsolve.algebra.notation.letters import parts
from rotsolve.core.vectors.tensor import AXES
from rotsolve.grading.reading.records import LineReading
from rotsolve.grading.verdict import Remark

LOOKS_LIKE = {"omega": "w"}  # what is typed for a Greek letter that no keyboard has


def near_letters(letters: Collection[str], others: Iterable[str] = ()) -> dict[str, str]:
    """What may be typed for letters of a scene, each with the only one that it can mean; `others` have a meaning of their own."""
    whole, bare = dict[str, set[str]](), dict[str, set[str]]()
    for name in letters:
        for typed, indexed in near_spellings(name):
            (whole if indexed else bare).setdefault(typed, set()).add(name)
    known = {*letters, *others}
    meant = {**bare, **whole}  # w is ω, before it is ω₀
    return {typed: names.pop() for typed, names in meant.items() if typed not in known and len(names) == 1}


def near_spellings(name: str) -> Iterator[tuple[str, bool]]:
    """The index without its underline, a look-alike for the Greek letter, and the letter without its index; whether it still has that."""
    letter = parts(name)
    if letter is None or letter.change or letter.prime or letter.dots or letter.of:
        return
    behind = name.removeprefix(letter.head)
    if letter.word in AXES:  # of a component: F is not F_x
        yield name.replace("_", ""), True
        return
    heads = [letter.head, *([LOOKS_LIKE[letter.head]] if letter.head in LOOKS_LIKE else [])]
    for head in heads:
        yield from ((other, True) for other in {head + behind, head + behind.replace("_", "")} - {name})
        if behind:
            yield head, False


def with_near(reading: LineReading, near: Mapping[str, str]) -> LineReading:
    """A reading with the scene's letters for those that were typed, which is said of each."""
    pieces = tuple(with_near(part, near) for part in reading.parts)
    held = reading.formula.symbols() if reading.formula is not None else frozenset()
    held |= reading.right.symbols() if reading.right is not None else frozenset()
    used = {typed: Symbol(near[typed]) for typed in sorted(held) if typed in near}
    said = (Remark("letter", (Symbol(typed), " is taken as ", letter)) for typed, letter in used.items())
    inner = (remark for part in pieces for remark in part.remarks if remark.kind == "letter")
    return replace(
        reading,
        written=reading.text,
        formula=None if reading.formula is None else reading.formula.substitute(used),
        right=None if reading.right is None else reading.right.substitute(used),
        parts=pieces,
        remarks=(*dict.fromkeys((*reading.remarks, *said, *inner)),),
    )
