"""Assignment: what workers are told and what comes back: records alone, and how papers are parted into batches."""

from __future__ import annotations

import pickle
from collections.abc import Iterable, Iterator
from itertools import islice
from typing import TYPE_CHECKING, TypeVar

from msgspec import Struct

from rotsolve import __version__
from rotsolve.grading.course.examination import Examination
from rotsolve.grading.course.report.tally import Tally

if TYPE_CHECKING:
    from rotsolve.grading.course.questions import SheetTask
    from rotsolve.language.problem import Problem

BATCH = 250  # papers that are marked at a time: a second's work or two, where no two are alike
Item = TypeVar("Item")


class Assignment(Struct, frozen=True):
    """What papers are marked by, as it is sent to workers: problems and what is asked of them, the variants, and which rotsolve is wanted.

    The problems are pickled apart, so that a worker of another version sees that it is one before it reads what it does not know.
    """

    content: bytes  # the problems, and the task
    seed: int
    variants: int | None
    shows_right: bool = False
    version: str = __version__

    def opened(self) -> tuple[tuple[Problem, ...], SheetTask]:
        """The problems, and what is asked of them. Raises OtherVersion."""
        if self.version != __version__:
            raise OtherVersion(__version__)
        found: tuple[tuple[Problem, ...], SheetTask] = pickle.loads(self.content)
        return found


def assignment_of(examination: Examination) -> Assignment:
    """The assignment for workers that are to mark as the examination does here."""
    problems = tuple(one.problem for one in examination.judges)
    first = examination.judges[0]
    return Assignment(pickle.dumps((problems, examination.task)), first.seed, first.count, examination.shows_right)


def numbered_batches(items: Iterable[Item]) -> Iterator[tuple[int, list[Item]]]:
    """So many at a time, numbered from 0 on."""
    left, number = iter(items), 0
    while batch := list(islice(left, BATCH)):
        yield number, batch
        number += 1


def named_batch(number: int) -> str:
    """Which papers a batch has."""
    return f"papers {number * BATCH + 1} to {number * BATCH + BATCH}"


class MarkedRows(Struct):
    """What is kept of a batch: its rows of the marks, and what they add up to."""

    rows: list[list[str]]
    tally: Tally


class OtherVersion(Exception):
    """A worker has another rotsolve than was asked for."""
