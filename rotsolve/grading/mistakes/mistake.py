"""Mistake: what a student did wrong in a scene, in words, and the change to the scene that does the same."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from msgspec import Struct, field

from rotsolve.algebra.formula import Formula
from rotsolve.core.alteration import Alteration
from rotsolve.language.problem import Problem


class Change(Struct, frozen=True):
    """What a mistake changes: what is read of the scene, what the laws say of it, or what is put in for a given at the end.

    problem: the scene as it is misread, for which friction is decided anew; altered: its facts and equations, while what slips stays as
    it is. `aside` are the laws by which the answer is found without making the mistake, hence not used.
    letters: what is written for a given in the answers (2 R for R); factors: by what the number is wrong that is put in for it. Neither
    needs the laws.
    """

    problem: Callable[[Problem], Problem] | None = None
    altered: Alteration | None = None
    aside: tuple[str, ...] = ()
    letters: Mapping[str, Formula] = field(default_factory=dict)
    factors: Mapping[str, Formula] = field(default_factory=dict)

    @property
    def reread(self) -> bool:
        """Whether the laws are right, and only what is put in at the end is not."""
        return bool(self.letters or self.factors)

    @property
    def throughout(self) -> bool:
        """Whether all laws speak of the change alike, so that they must agree with each other."""
        one_sided = self.altered is not None and (self.altered.equation is not None or self.altered.event is not None)
        return not self.aside and not one_sided


class Mistake(Struct, frozen=True):
    """One mistake at one place of a scene: its name in the table, words that complete "It looks as if ", and the change."""

    name: str
    words: str
    change: Change
