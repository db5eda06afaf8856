"""Examiner: marks papers, each against the scene with the numbers of its variant."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from typing import Protocol, TypeVar

from rotsolve.grading.verdict import Marked, Paper
from rotsolve.run.attempt import internal_error

HIGHEST = 10_000  # number of a variant
NUMBER = re.compile(r"(?:variant|version|no\.?|#)?\s*(\d{1,5})(?:[.,]0+)?", re.IGNORECASE)
Given = TypeVar("Given")
Done = TypeVar("Done")


class Judge(Protocol):
    """What marks the papers of one variant."""

    def mark(self, paper: Paper) -> Marked: ...


class NotMarked(ValueError):
    """Why a paper can't be marked."""


def mark(papers: Sequence[Paper | None], judge: Callable[[int], Judge]) -> Iterator[tuple[int, Marked | str]]:
    """The place of each paper with its marks, or why it has none; variant by variant, so that one judge is held at a time.

    `judge` is asked for the numbers of the variants in rising order, 0 for the scene as it stands.
    """
    groups: dict[int, list[tuple[int, Paper]]] = {}
    for place, paper in enumerate(papers):
        if paper is not None:
            number = attempted(variant_of, paper)
            if isinstance(number, str):
                yield place, number
            else:
                groups.setdefault(number, []).append((place, paper))
    for variant in sorted(groups):
        chosen = attempted(judge, variant)
        for place, paper in groups[variant]:
            yield place, chosen if isinstance(chosen, str) else attempted(chosen.mark, paper)


def attempted(work: Callable[[Given], Done], given: Given) -> Done | str:
    """What comes of a work, or why nothing does: a failure of ours is that of one paper, or one variant, alone."""
    try:
        return work(given)
    except NotMarked as reason:
        return str(reason)
    except Exception as error:
        return internal_error("marking", error)


def variant_of(paper: Paper) -> int:
    """The number of the variant, 0 where the paper says none."""
    text = paper.variant.strip()
    if not text:
        return 0
    found = NUMBER.fullmatch(text)
    if found is None or not 1 <= int(found[1]) <= HIGHEST:
        raise NotMarked(f"`{text[:40]}` is no number of a variant")
    return int(found[1])
