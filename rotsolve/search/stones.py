"""Stones: letters of the scene that are settled first, where a question has no answer by one plan.

The place at which a body is, or how fast it moves there, may have a root of its own, in closed form or by numbers alone. Each is tried on a
search beside, so that an answer does not hang on what else is asked.
"""

from __future__ import annotations

from collections.abc import Iterable

from rotsolve.core.faults import Unsolvable
from rotsolve.core.symbols import is_key, key_of
from rotsolve.questions.find import Asked
from rotsolve.search.answers import NoAnswer
from rotsolve.search.search import Search

RANKS = {
    kind: rank
    for rank, kind in enumerate(("angle", "velocity", "angular_velocity", "time", "displacement", "rotation"))
}


class Stones:
    """The letters on the way to one question, tried in turn; `clashes` are the laws by which one has no value, `asked_for` says whether the
    question is for such a letter itself."""

    def __init__(self, search: Search, asked: Asked) -> None:
        assert search.ground is not None
        self.search, self.asked, self.ground = search, asked, search.ground
        self.asked_for = is_key(asked.letter) and key_of(asked.letter).kind in RANKS
        self.clashes: list[int] = []
        self.numbered: list[str] = []  # those of which numbers may tell the root

    def in_closed_form(self, letters: Iterable[str]) -> str | None:
        """The first of some letters that has a closed form with which the question has an answer."""
        return next((name for name in letters if self._leads(name)), None)

    def by_number(self) -> str | None:
        """The first of those without a closed form that has a number with which the question has an answer."""
        return next((name for name in self.numbered if self._leads_by_number(name)), None)

    def _leads(self, stone: str) -> bool:
        """Whether the question has an answer once a letter is settled; leaves no trace but the law that lets the letter have no value."""
        if self.ground.stones_left == 0:
            return False
        self.ground.stones_left -= 1
        other = self._beside(confirming=True)
        try:
            other.step(stone)
        except NoAnswer as error:
            self.numbered += [stone] if error.open_form and key_of(stone).kind in RANKS else []
            self._note_clash(error, other)
            return False
        except ValueError:
            return False
        return self._answered(other)

    def _leads_by_number(self, stone: str) -> bool:
        """Whether the question has an answer once the number of a letter is known."""
        if self.ground.numbered_stones_left == 0:
            return False
        self.ground.numbered_stones_left -= 1
        other = self._beside(confirming=False)
        try:
            other.step(stone)
        except (ValueError, Unsolvable):  # of which either sense would do
            return False
        other.confirming = True
        return self._answered(other)

    def _answered(self, other: Search) -> bool:
        """Whether a search beside answers the question."""
        try:
            other.answer(self.asked)
        except NoAnswer as error:
            self._note_clash(error, other)
            return False
        except ValueError:
            return False
        return True

    def _beside(self, *, confirming: bool) -> Search:
        """A search that knows what this one knows."""
        search = self.search
        other = search.another(search.families, spare=search.spare, confirming=confirming)
        other.solver.solved.update(search.solver.solved)
        other.known |= search.known
        other.retired |= search.retired
        return other

    def _note_clash(self, error: NoAnswer, other: Search) -> None:
        clash = None if error.equation is None else other.planner.pool[error.equation]
        self.clashes += [index for index, law in enumerate(self.search.planner.pool) if law == clash]


def ranked(met: Iterable[str], asked: str) -> tuple[str, ...]:
    """The letters of plans by which an answer may be reached: where bodies are, how fast they move, and when, then all else."""
    named = sorted(name for name in met if is_key(name) and name != asked)
    return tuple(sorted(named, key=lambda name: RANKS.get(key_of(name).kind, len(RANKS))))
