"""Choosing: which of several roots is meant: the first moment, the stable place, the first place reached, the expected sign."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction

from msgspec import Struct

from rotsolve.algebra.certified.witness import decided_by_size
from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.derivation import Words
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Given
from rotsolve.motion.positive import is_angle
from rotsolve.search.roots.expected import Expected
from rotsolve.search.roots.numbers import Numbers
from rotsolve.search.roots.reached import FirstReached
from rotsolve.solver import Choice

SAME = 1e-9  # relative difference up to which two places lie equally far to either side


class RootChoice(Struct, frozen=True):
    """Chooses between the roots of an equation; `definition` tells what an asked letter stands for."""

    scene: SceneEquations
    givens: Mapping[str, Given]
    numbers: Numbers
    definition: Callable[[str], Formula | None]

    def choose(self, name: str, roots: Sequence[Formula], period: Formula | None = None) -> Choice | None:
        """The root that is meant, with the reason; a `period` later the equation holds again."""
        outwards = [index for index, root in enumerate(roots) if self._lacks_numbers(root)]
        if outwards and len(roots) > 1 and self._on_shaft(name):
            return Choice(outwards[0], ("out from the axis, where the shaft turns fast enough for it",))
        real = [(index, number) for index, root in enumerate(roots) if (number := self.numbers.of(root)) is not None]
        if not real:
            return self._unnumbered(name, roots) if any(map(self._lacks_numbers, roots)) else None
        later = self._first_moment(name, [(index, roots[index]) for index, _ in real], period)
        if later is not None:
            return later
        moved = [entry for entry in real if entry[1]]
        dropped: Words = ()
        if len(moved) < len(real) and moved and self._is_change(name):
            real, dropped = moved, ("the root 0 is the start itself",)
        if len(real) == 1:
            return Choice(real[0][0], dropped)
        if all(self.numbers.side(roots[index] - roots[real[0][0]]) == 0 for index, _ in real[1:]):
            return Choice(real[0][0], ("the roots coincide: it is only just reached",))
        stable = self._stable(name, [roots[index] for index, _ in real])
        if stable:
            found = nearest([real[place] for place in stable])
            return Choice(found, ("the stable one: a body displaced from it comes back",))
        reached = FirstReached(self.scene, self.numbers, self.definition).choose(
            name, [(index, roots[index]) for index, _ in real]
        )
        if reached is not None:
            return reached
        sign, words = Expected(self.scene, self.givens, self.numbers).sign(name)
        if sign:
            fitting = [entry for entry in real if entry[1] * sign > 0]
            if fitting:
                return Choice(smallest(fitting), words)
        if self._is_angle(name):
            return Choice(smallest(real), ("the smallest angle",))
        positive = [entry for entry in real if entry[1] >= 0]
        return Choice(smallest(positive or real), ("the positive root",))

    def _on_shaft(self, name: str) -> bool:
        """Whether a letter tells the angle at which a body stands steadily on a turning shaft."""
        if not any(state.steady for state in self.scene.configuration.timeline.states):
            return False
        from rotsolve.search.swings.steady import on_shaft

        return bool(on_shaft(name, self.scene))

    def _stable(self, name: str, roots: Sequence[Formula]) -> list[int]:
        """Places of the roots at which a body that stands somewhere comes back when it is displaced."""
        if not any(state.balance or state.steady for state in self.scene.configuration.timeline.states):
            return []
        from rotsolve.search.swings.steady import stable_roots

        return stable_roots(name, roots, self.scene, self.numbers.values)

    def _first_moment(self, name: str, roots: Sequence[tuple[int, Formula]], period: Formula | None) -> Choice | None:
        """Of times that come again the first one after the state before."""
        quantity = self.scene.registry.quantities.get(name)
        side = self.numbers.side(period) if period is not None else None
        if quantity is None or quantity.kind != "time" or period is None or not side:
            return None
        period = period if side > 0 else -period
        begun = self._begun(quantity.when)
        counts = [] if begun is None else [(k, self.numbers.whole((begun - root) / period), root) for k, root in roots]
        moments = [(k, count + 1, root + (count + 1) * period) for k, count, root in counts if count is not None]
        if not moments:
            return None
        index, count, _ = min(moments, key=lambda entry: self.numbers.of(entry[2]) or 0.0)
        return Choice(index, ("the first moment at which this holds",), Fraction(count), period)

    def _begun(self, when: str) -> Formula | None:
        """The time at the state before a state; 0 for the duration of a phase."""
        timeline = self.scene.configuration.timeline
        if timeline.interval(when) is not None:
            return ZERO
        before = timeline.before(when) if when in timeline.order else None
        return self.numbers.with_answers(self.scene.instant(before.start).time()) if before else None

    def _is_change(self, name: str) -> bool:
        """Whether a quantity is a change since the state before, or the time that it took."""
        quantity = self.scene.registry.quantities.get(name)
        return quantity is not None and quantity.kind in ("displacement", "rotation", "time", "elongation")

    def _is_angle(self, name: str) -> bool:
        """Whether a letter is an angle."""
        given, quantity = self.givens.get(name), self.scene.registry.quantities.get(name)
        if quantity is not None:
            return quantity.kind == "angle"
        return given is not None and (given.dimension is None or is_angle(given))

    def _unnumbered(self, name: str, roots: Sequence[Formula]) -> Choice:
        """Without numbers a root is chosen by the sign that the scene suggests: not negative unless said."""
        sign, words = Expected(self.scene, self.givens, self.numbers).sign(name)
        if sign < 0 and len(roots) > 1:
            return Choice(1, words)
        return Choice(0, words or ("the root along the positive sense",))

    def _lacks_numbers(self, root: Formula) -> bool:
        """Whether a root holds a given without a number."""
        return bool(root.symbols() - set(self.numbers.values))


def smallest(entries: Sequence[tuple[int, float]]) -> int:
    """The root nearest to zero: its size is compared only where there are several."""
    if len(entries) > 1:
        decided_by_size()
    return min(entries, key=lambda entry: abs(entry[1]))[0]


def nearest(entries: Sequence[tuple[int, float]]) -> int:
    """The root nearest to zero, of two that are equally far the positive one."""
    least = abs(min(entries, key=lambda entry: abs(entry[1]))[1])
    near = [entry for entry in entries if abs(entry[1]) <= least * (1 + SAME)]
    if len(entries) > 1:
        decided_by_size()
    return min(near, key=lambda entry: entry[1] < 0)[0]
