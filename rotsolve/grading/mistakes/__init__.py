"""Mistakes: what a wrong answer may come from: the same scene solved with one mistake in it."""

from rotsolve.grading.mistakes.mistake import Change, Mistake
from rotsolve.grading.mistakes.scene import Scene
from rotsolve.grading.mistakes.table import MISTAKES, Kind, WrongAnswers, mistakes_in, with_mistake, wrong_answers

__all__ = [
    "MISTAKES",
    "Change",
    "Kind",
    "Mistake",
    "Scene",
    "WrongAnswers",
    "mistakes_in",
    "with_mistake",
    "wrong_answers",
]
