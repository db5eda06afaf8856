"""Wrong answers: those that the mistakes of the table give in one scene, worked out as far as a wrong line asks for them."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from functools import cached_property
from itertools import count, islice
from types import MappingProxyType
from typing import TypeVar

from rotsolve.algebra.certified.ball import Witness, pass_on, witnessed
from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.effort import Allowance, Exhausted
from rotsolve.algebra.formula import Formula
from rotsolve.core.derivation import Answer
from rotsolve.core.symbols import TIME
from rotsolve.grading.mistakes.attempt import Attempt
from rotsolve.grading.mistakes.mistake import Mistake
from rotsolve.grading.mistakes.scene import Rereading, Scene, same_answers
from rotsolve.grading.mistakes.table import MISTAKES
from rotsolve.language.problem import Problem
from rotsolve.search.letterspace import Point

STEPS = 20_000  # of the work for all mistakes of a scene, in equal parts; most scenes take a few hundred, a step about a millisecond
MOST_STEPS = 500  # for one mistake; those of the bundled scenes that come to an end take 320 at most
ROUNDS = 2  # times that a piece of work is begun
MOST_TRIED = 200  # mistakes of a scene
Wrong = tuple[Mistake, Mapping[str, Answer]]  # a mistake with the answers that it changes
Done = TypeVar("Done")


class Tried:
    """A mistake that is tried in a scene, as far as its answers are asked for, with so much work at most.

    `place` is that among those of its kind; `right` is what the right answers ask of numbers.
    """

    def __init__(self, mistake: Mistake, place: int, scene: Scene, steps: int, right: Witness) -> None:
        self.mistake, self.place, self.scene, self.steps = mistake, place, scene, steps
        self._allowance, self._noted = Allowance(steps), right

    def told(self, name: str) -> Answer | None:
        """What the mistake makes of one answer, as far as that tells: whether all can be as it says is seen in `answers` alone."""
        if "answers" in vars(self):
            return (self.answers or {}).get(name)
        return self._within(lambda: self.scene.told(self._attempt, name))

    @cached_property
    def answers(self) -> Mapping[str, Answer] | None:
        """The answers that it changes; None where it changes none, or the scene has no answer with it."""
        answers = self._within(lambda: self.scene.changed_by(self._attempt))
        vars(self).pop("_attempt", None)  # which holds all that was worked out
        return answers

    @cached_property
    def _attempt(self) -> Attempt | Rereading:
        return self.scene.attempt(self.mistake.change)

    def _within(self, work: Callable[[], Done]) -> Done | None:
        """What comes of a piece of work; None where it takes too much. What it asks of numbers is noted.

        What has run out of work is done once more: an attempt goes no further then, and tells what was answered before.
        """
        for _ in range(ROUNDS):
            with witnessed() as witness:
                pass_on(self._noted)
                self._noted = witness
                done = allowed(self._allowance, work)
            if self._allowance.steps >= 0:
                return done
            self._allowance = Allowance(self.steps)
        return None

    def holds_for(self, signs: VariantSigns) -> bool:
        """Whether other numbers lead the same way: all have the same signs, and no more than these decided."""
        if self.mistake.change.reread:
            return True
        _ = self.answers  # with all that they hang on
        return not self._noted.by_size and all(signs.of(item) == sign for item, sign in self._signs.items())

    @cached_property
    def _signs(self) -> Mapping[Formula, int]:
        """The numbers on which it hangs, with their signs."""
        oracle = SignOracle(self.scene.whole.values)
        return {item: oracle.by_numbers(item) or 0 for item in self._noted.asked}


class Untried(Tried):
    """A mistake that can't be made in a scene."""

    @cached_property
    def answers(self) -> Mapping[str, Answer] | None:
        return None


class Revalued(Tried):
    """A mistake in the scene with other numbers, by what it gives there by letters."""

    def __init__(self, like: Tried, values: Mapping[str, Formula]) -> None:
        self.mistake, self.like, self.values = like.mistake, like, values

    def told(self, name: str) -> Answer | None:
        return (self.answers or {}).get(name)

    @cached_property
    def answers(self) -> Mapping[str, Answer] | None:
        """The answers that it changes."""
        return self.like.scene.with_values(self.mistake, self.like.answers or {}, self.values)


class VariantSigns:
    """The signs of numbers in one variant of a problem, each worked out once."""

    def __init__(self, problem: Problem) -> None:
        self._oracle = SignOracle(problem.values)
        self._known: dict[Formula, int | None] = {}

    def of(self, item: Formula) -> int | None:
        """The sign; None where it goes with the time."""
        if item not in self._known:
            self._known[item] = None if TIME in item.symbols() else self._oracle.by_numbers(item) or 0
        return self._known[item]


class WrongAnswers:
    """The mistakes of a scene with the answers that they give, found one after the other as they are asked for, each once."""

    def __init__(self, rest: Iterator[Tried]) -> None:
        self._found: list[Tried] = []
        self._rest = rest
        self._anew: dict[tuple[str, int], list[Tried]] = {}  # those solved again for other numbers, by kind and place

    @classmethod
    def of(cls, problem: Problem, point: Point = MappingProxyType({})) -> WrongAnswers:
        """Those of a problem, which is solved with each mistake in it; of letters in the case that the numbers of a point are of."""
        return cls(tried_mistakes(Scene(problem, point)))

    def __iter__(self) -> Iterator[Wrong]:
        """The mistakes that change answers, with these; of those of one kind that give the same answers, only the first."""
        given: dict[str, list[Mapping[str, Answer]]] = {}
        for one in self.tried():
            alike = given.setdefault(one.mistake.name, [])
            if one.answers is not None and not any(same_answers(one.answers, other) for other in alike):
                alike.append(one.answers)
                yield one.mistake, one.answers

    def first(self, name: str, fits: Callable[[Answer], bool]) -> Mistake | None:
        """The first mistake that makes an answer of a name such as fits; no other answer is worked out with those that do not."""
        for one in self.tried():
            told = one.told(name)
            wrong = (one.answers or {}).get(name) if told is not None and fits(told) else None
            if wrong is not None and fits(wrong):
                return one.mistake
        return None

    def tried(self) -> Iterator[Tried]:
        """All mistakes that can be tried."""
        for place in count():
            if place == len(self._found):
                following = next(self._rest, None)
                if following is None:
                    return
                self._found.append(following)
            yield self._found[place]

    def with_values(self, problem: Problem) -> WrongAnswers:
        """The same for the scene with other numbers; solved again is only what hangs on a number that has another sign now."""
        return WrongAnswers(self._with_values(problem))

    def _with_values(self, problem: Problem) -> Iterator[Tried]:
        signs = VariantSigns(problem)
        for one in self.tried():
            others = self._anew.setdefault((one.mistake.name, one.place), [])
            like = next((other for other in (one, *others) if other.holds_for(signs)), None)
            if like is None:
                like = try_again(one, Scene(problem, one.scene.point))
                others.append(like)
            yield Revalued(like, problem.values)


def try_again(one: Tried, scene: Scene) -> Tried:
    """The same mistake in the scene with other numbers; without answers where it can't be made there."""
    kind, at = next(kind for kind in MISTAKES if kind.name == one.mistake.name), one.place
    with witnessed() as witness:
        twins = allowed(Allowance(STEPS), lambda: scene.settled and list(islice(kind.mistakes(scene), at, at + 1)))
    return Tried(twins[0], at, scene, one.steps, witness) if twins else Untried(one.mistake, at, scene, 0, witness)


def tried_mistakes(scene: Scene) -> Iterator[Tried]:
    """The mistakes of a scene, each with its part of the work that is allowed."""
    with witnessed() as right:
        settled = allowed(Allowance(STEPS), lambda: scene.settled and bool(scene.answers))
    if settled:
        made = ((place, mistake) for kind in MISTAKES for place, mistake in enumerate(kind.mistakes(scene)))
        tried = list(islice(made, MOST_TRIED))
        steps = min(MOST_STEPS, STEPS // max(len(tried), 1))
        yield from (Tried(mistake, place, scene, steps, right) for place, mistake in tried)


def allowed(allowance: Allowance, work: Callable[[], Done]) -> Done | None:
    """What comes of a piece of work; None where it takes more than what is left."""
    try:
        with allowance.used():
            return work()
    except Exhausted:
        allowance.steps = -1
        return None
