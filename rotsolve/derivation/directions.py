"""Which way an answer points, in words: by its number, by letters alone where they tell, else under which condition it does."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from rotsolve.algebra.certified.ball import Certified
from rotsolve.algebra.exact.normal import Fractions, is_zero, simplify
from rotsolve.algebra.formula import ZERO, Formula, Sum, Symbol, negate
from rotsolve.core.derivation import Answer, Words
from rotsolve.core.registry import SceneQuantity
from rotsolve.search.answers import Answered
from rotsolve.search.search import Search

OF_TURNING = ("angular_velocity", "angular_acceleration", "angular_momentum", "rotation")
SIZED = "friction_force"  # the kind of quantity of which only the size is asked


class Directions:
    """The ways in which one answer may point."""

    def __init__(self, search: Search, answered: Answered) -> None:
        self.search = search
        self.answered = answered

    def words(self, value: Certified | None, parts: tuple[Answer, ...]) -> str:
        """The direction; '' where its sign is no direction, or nothing tells it."""
        if self.answered.asked.vector is not None:
            return heading_words(parts)
        sign = self._sign if value is None else value.sign
        if sign == 1 and self._senseless:
            return ""
        return self._both[0 if sign > 0 else 1] if any(self._both) and sign else ""

    @property
    def positive(self) -> str:
        """What a positive value means, in words, where a negative one means something else; friction is told by its size."""
        sized = self._quantity is not None and self._quantity.kind == SIZED
        return self._both[0] if self._two_ways and not sized else ""

    def condition(self) -> Words:
        """Right if R > r: where one factor alone, a difference, decides the way; nothing where more do."""
        value = self.answered.found.formula
        if value is None or not self._two_ways or self._sign is not None:
            return ()
        try:
            unsure = [part for part in self._factors(value) if self._sure(part) is None]
        except ZeroDivisionError:  # it has no value
            return ()
        if len(unsure) != 1 or not isinstance(unsure[0], Sum) or len(unsure[0].terms) != 2:
            return ()
        sign = self._sure(simplify(value / unsure[0], positive=self.search.signs.positive))
        sides = {self._sure(term): term for term in unsure[0].terms}
        if not sign or sides.keys() != {1, -1}:
            return ()
        more, less = map(self.search.solver.simplify, (sides[1], negate(sides[-1])))
        return (f"{self._both[0 if sign > 0 else 1]} if ", more, " > ", less)

    def _sure(self, value: Formula) -> int | None:
        """The sign that letters tell, those without a direction of their own as they are meant."""
        sign = self.search.signs.by_letters(value)
        if sign is None and isinstance(value, Sum):
            return self._limited(value)
        return self.search.signs.as_meant(value) if sign is None else sign

    def _limited(self, value: Formula) -> int | None:
        """The sign of a difference of which the scene says that it is more than nothing, as that of an outer and an inner radius."""
        from rotsolve.motion.limits import limits_of_scene

        gaps = [limit.gap for limit in limits_of_scene(self.search.scene.configuration) if limit.strict]
        return next((sign for gap in gaps for sign in (1, -1) if is_zero(gap - sign * value)), None)

    def _factors(self, value: Formula) -> Iterator[Formula]:
        """What stands with an odd power above and below, as far as it is no mere product of letters."""
        problem = Fractions([value], positive=self.search.signs.positive)
        for poly in problem.field.cancel(problem.ratio()):
            yield from (problem.shaper.poly(part) for part, power in problem.field.factor(poly)[1] if power % 2)

    @cached_property
    def _sign(self) -> int | None:
        """The sign with the numbers that there are, as far as it is the same for all that letters may be; of friction, whose direction
        words alone tell, for all that are meant to be positive."""
        find, formula = self.answered.asked.find, self.answered.found.formula
        if formula is None:
            return None
        friction = [term.path.quantity for term in find.terms] == [SIZED] and find.formula == Symbol("#0")
        if friction:
            return self.search.signs.as_meant(formula)
        formula = formula.substitute(self.search.values)
        sign = self.search.signs.by_letters(formula)
        return self._by_limits(formula) if sign is None and self.search.signs.lacking(formula) else sign

    def _by_limits(self, formula: Formula) -> int | None:
        """The sign of what is in proportion to one difference that has a limit, of other letters as they are meant."""
        try:
            parts = [part for part in self._factors(formula) if isinstance(part, Sum)]
        except ZeroDivisionError:
            return None
        unsure = [part for part in parts if self.search.signs.by_letters(part) is None]
        side = self._limited(unsure[0]) if len(unsure) == 1 else None
        rest = self._sure(simplify(formula / unsure[0], positive=self.search.signs.positive)) if side else None
        return side * rest if side and rest else None

    @property
    def _two_ways(self) -> bool:
        """Whether a negative value means another direction than a positive one."""
        return all(self._both) and self.answered.asked.vector is None

    @cached_property
    def _both(self) -> tuple[str, str]:
        """What a positive and a negative value mean, in words; empty where its sign is no direction."""
        if self._quantity is not None and any((self._quantity.positive, self._quantity.negative)):
            return (self._quantity.positive, self._quantity.negative) if self._quantity.kind != "angle" else ("", "")
        return self.answered.asked.words

    @property
    def _senseless(self) -> bool:
        """Whether a turn counts in a sense that nothing tells: about one axis seen from above, where nothing moves in a named way."""
        problem = self.search.scene.configuration.problem
        turns = self._quantity is not None and self._quantity.kind in OF_TURNING
        ways = any(body.moves or body.turns for body in problem.bodies) or problem.actions
        axes = [item for item in problem.connections if any(item.fixed_points())]
        return turns and not problem.space and problem.plane == "horizontal" and not ways and len(axes) == 1

    @cached_property
    def _quantity(self) -> SceneQuantity | None:
        return self.search.scene.registry.quantities.get(self.answered.asked.letter)


def heading_words(parts: tuple[Answer, ...]) -> str:
    """Up and to the right: which way the components of a vector point, '' where nothing tells."""
    signs = [0 if part.formula == ZERO else part.value.sign if part.value is not None else None for part in parts]
    if not parts or None in signs:
        return ""
    side = {1: "to the right", -1: "to the left"}.get(signs[0] or 0, "")
    rise = {1: "up", -1: "down"}.get(signs[1] or 0, "")
    return " and ".join(part for part in (rise, side) if part)
