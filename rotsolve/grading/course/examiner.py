"""Examiner: marks papers, each against the scene with the numbers of its variant."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from typing import Protocol

from rotsolve.grading.verdict import Marked, Paper
from rotsolve.run.attempt import internal_error

HIGHEST = 100_000  # number of a variant
NUMBER = re.compile(r"(?:variant|version|no\.?|#)?\s*(\d{1,6})(?:[.,]0+)?", re.IGNORECASE)


class Judge(Protocol):
    """What marks the papers of one variant."""

    def mark(self, paper: Paper) -> Marked: ...


class NotMarked(ValueError):
    """Why a paper can't be marked."""


def mark(papers: Sequence[Paper | None], judge: Callable[[int], Judge]) -> Iterator[tuple[int, Marked | str]]:
    """The place of each paper with its marks, or why it has none; variant by variant, so that one judge is held at a time.

    `judge` is asked for the numbers of the variants in rising order, 0 for the scene as it stands.
    """
    places: dict[int, list[int]] = {}
    for place, paper in enumerate(papers):
        if paper is not None:
            try:
                places.setdefault(variant_of(paper), []).append(place)
            except NotMarked as reason:
                yield place, str(reason)
    for number in sorted(places):
        try:
            chosen = judge(number)
        except NotMarked as reason:
            yield from ((place, str(reason)) for place in places[number])
        else:
            yield from ((place, marked(chosen, papers[place])) for place in places[number])


def marked(judge: Judge, paper: Paper | None) -> Marked | str:
    """The paper, marked; a failure of ours is that paper's alone."""
    assert paper is not None
    try:
        return judge.mark(paper)
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
