"""Aftermath: faults that only follow from another one are left out: what nobody could read can't be named, used or judged."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Sequence

from msgspec.structs import replace

from rotsolve.core.faults import Fault, Related, Span
from rotsolve.language.words import Hint, joined
from rotsolve.scene.scope import UNKNOWN, Scope
from rotsolve.scene.tree import List, Map, Node, Text

UNTOLD = re.compile(r"^(?:title|source|text):.*|(?:^|\s)#.*")  # of a line: what names nothing
ROOTS = ("name", "duplicate", "yaml", "key")  # kinds of faults that stand at what is not read themselves
PATHS = ("path", "point")  # kinds of faults of what is said with a name of what has faults
SIDES = re.compile(r"[^\s,\[\]{}()]")  # what belongs to a word in the file, with its points


def first_causes(scope: Scope, lines: Sequence[str]) -> list[Fault]:
    """The faults of a file without those that follow from others."""
    lost, half = names_in_words(scope.lost), names_in_words(scope.half_read)
    guessed = [stretch_of(node) for node in scope.guessed]
    kept = [
        fault
        for fault in scope.faults
        if fault.kind in ROOTS or not (names_lost(fault.span, lines, lost) or stands_in(fault.span, guessed))
        if fault.kind not in PATHS or not names_lost(fault.span, lines, half)
    ]
    return [used_nowhere(fault, scope, lines) for fault in without_doubled(kept, scope)]


def names_in_words(names: Iterable[str]) -> re.Pattern[str] | None:
    """A pattern of any of some names as whole words."""
    words = "|".join(re.escape(name) for name in sorted(names, key=len, reverse=True) if name)
    return re.compile(rf"(?<!\w)(?:{words})(?!\w)") if words else None


def names_lost(span: Span | None, lines: Sequence[str], lost: re.Pattern[str] | None) -> bool:
    """Whether a place holds a name that could not be read, or stands within a word with it."""
    if span is None or lost is None or not 1 <= span.line <= len(lines):
        return False
    line, start = lines[span.line - 1], span.column - 1
    end = start + span.length
    while start > 0 and SIDES.match(line[start - 1]):
        start -= 1
    return any(found.start() < end and start < found.end() for found in lost.finditer(line))


def stretch_of(node: Node) -> tuple[tuple[int, int], tuple[int, int]]:
    """From where to where a node stands in the file: lines and columns."""
    spans = list(spans_in(node))
    first, last = (
        min(spans, key=lambda span: (span.line, span.column)),
        max(spans, key=lambda span: (span.line, span.column)),
    )
    return (first.line, first.column), (last.line, last.column + last.length)


def spans_in(node: Node) -> Iterator[Span]:
    """The places of a node and of all that it holds."""
    yield node.span
    for part in node.items if isinstance(node, List) else ():
        yield from spans_in(part)
    for key, part in node.entries if isinstance(node, Map) else ():
        yield key.span
        yield from spans_in(part)


def stands_in(span: Span | None, extents: Iterable[tuple[tuple[int, int], tuple[int, int]]]) -> bool:
    """Whether a place lies in one of some stretches of the file."""
    return span is not None and any(start <= (span.line, span.column) < end for start, end in extents)


def without_doubled(faults: list[Fault], scope: Scope) -> list[Fault]:
    """A name that stands twice was to be another one: that which is used and stands nowhere, if there are no more of these."""
    doubled = [key for key in scope.doubled if isinstance(key, Text)]
    missing = list(dict.fromkeys(fault.cause for fault in faults if fault.cause.startswith(UNKNOWN)))
    if not doubled or not missing or len(missing) > len(doubled):
        return faults
    meant = missing[0].removeprefix(UNKNOWN) if len(missing) == 1 else None
    names = joined((f"`{cause.removeprefix(UNKNOWN)}`" for cause in missing), " or ")
    spans = {key.span for key in doubled}
    kept = [fault for fault in faults if fault.cause not in missing]
    return [
        replace(fault, help=Hint(f"did you mean {names}, which nothing gives?", meant))
        if fault.span in spans
        else fault
        for fault in kept
    ]


def used_nowhere(fault: Fault, scope: Scope, lines: Sequence[str]) -> Fault:
    """An unknown name with the place of the one that it may mean, where nothing else names that: which of both is wrong is not known."""
    meant = re.match(r"did you mean `(\w+)`\?", fault.help) if fault.cause.startswith(UNKNOWN) else None
    place = scope.places.get(meant[1]) if meant is not None else None
    if meant is None or place is None or place.line > len(lines):
        return fault
    word = re.compile(rf"(?<!\w){meant[1]}(?!\w)")
    if sum(len(word.findall(UNTOLD.sub("", line))) for line in lines) > 1:
        return fault
    return replace(fault, related=(*fault.related, Related(place, f"`{meant[1]}` is here, and named nowhere else")))
