"""Scans: what has been found of extremes over a letter, which is the same for all numbers of that letter."""

from __future__ import annotations

from collections.abc import Callable

from msgspec import Struct, field

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.course.samples import Fits, Numbers
from rotsolve.language.problem import Find, Given


def any_fits(numbers: Numbers) -> bool:
    """What nothing limits."""
    return True


class Scans(Struct, frozen=True):
    """What has been scanned for the extremes of a scene, by the numbers of all other letters; a letter has those that `fits` admits."""

    fits: Fits = any_fits
    found: dict[object, float | NotConfirmed] = field(default_factory=dict)

    def once(self, find: Find, letter: Given, numbers: Numbers, said: float | None, scan: Callable[[], float]) -> float:
        """The result of a scan, which is made anew only for other numbers."""
        others = frozenset(item for item in numbers.items() if item[0] != letter.name)
        key = (find.name, said, others)
        if key not in self.found:
            try:
                self.found[key] = scan()
            except NotConfirmed as reason:
                self.found[key] = reason
        found = self.found[key]
        if isinstance(found, NotConfirmed):
            raise found
        return found
