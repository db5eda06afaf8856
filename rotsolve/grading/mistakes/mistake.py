"""Mistake: what a student did wrong in a scene, in words, and the change to the scene that does the same."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from msgspec import Struct, field

from rotsolve.algebra.formula import Formula
from rotsolve.core.alteration import Alteration
from rotsolve.scene.model import Problem


class Change(Struct, frozen=True):
    """What a mistake changes: what is read of the scene, what the laws say of it, or what is put in for a given at the end.

    problem: the scene as it is misread; altered: its facts and equations. `aside` is the law by which the answer is found
    without making the mistake, hence not used; `modes_kept` says that what slips, and which way, is taken over from the right scene.
    letters: what is written for a given in the answers (2 R for R); numbers: the value that is put in for it. Neither needs the laws.
    """

    problem: Callable[[Problem], Problem] | None = None
    altered: Alteration | None = None
    aside: str | None = None
    modes_kept: bool = False
    letters: Mapping[str, Formula] = field(default_factory=dict)
    numbers: Mapping[str, Formula] = field(default_factory=dict)


class Mistake(Struct, frozen=True):
    """One mistake at one place of a scene: its name in the table, words that complete "It looks as if ", and the change."""

    name: str
    words: str
    change: Change
