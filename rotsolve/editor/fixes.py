"""Fixes: what a fault proposes to write in its place, as edits of the text."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

from rotsolve.core.faults import Fault, Span
from rotsolve.language.words import Hint


class Fix(NamedTuple):
    """A word to write in the place of another, and the fault that is gone then."""

    span: Span
    word: str
    fault: Fault


def fixes(faults: Iterable[Fault]) -> Iterator[Fix]:
    """What was most likely meant, of the faults that know it and have a place."""
    for fault in faults:
        if fault.span is not None and isinstance(fault.help, Hint) and fault.help.meant:
            yield Fix(fault.span, fault.help.meant, fault)
