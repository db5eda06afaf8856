"""Assignment: what workers are told and what comes back: records alone, and how papers are parted into batches."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import islice
from typing import TypeVar

from msgspec import Struct

from rotsolve import __version__
from rotsolve.grading.course.report.tally import Tally

BATCH = 250  # papers that are marked at a time: a second's work or two, where no two are alike
Item = TypeVar("Item")


class Assignment(Struct, frozen=True):
    """What papers are marked by, as it is sent to workers: the problem's text, the variants, and which rotsolve is wanted."""

    problem: str
    names: tuple[str, ...]  # what is asked
    seed: int
    variants: int | None
    version: str = __version__


def numbered_batches(items: Iterable[Item]) -> Iterator[tuple[int, list[Item]]]:
    """So many at a time, numbered from 0 on."""
    left, number = iter(items), 0
    while batch := list(islice(left, BATCH)):
        yield number, batch
        number += 1


class MarkedRows(Struct):
    """What is kept of a batch: its rows of the marks, and what they add up to."""

    rows: list[list[str]]
    tally: Tally


class OtherVersion(Exception):
    """A worker has another rotsolve than was asked for."""
