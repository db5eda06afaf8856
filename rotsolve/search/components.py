"""Components: a size and a direction that are both sought stand in the laws as m cos q and m sin q, which the laws tell one by one.

As where a mass and its angle balance a rotor: m_x = m cos q and m_y = m sin q are letters of their own, in which the equations are linear;
then m = √(m_x² + m_y²), and q = atan2(m_y, m_x). A size that may be negative is left: with q half a turn on it would be the same.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import Call, Formula, Symbol, call, sqrt, total
from rotsolve.algebra.units.dimension import is_positive
from rotsolve.core.equation import COMPONENTS, Equation
from rotsolve.core.registry import SceneQuantity
from rotsolve.core.symbols import COMPONENT, TIME
from rotsolve.core.writing import flat
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Given
from rotsolve.matching import Plan
from rotsolve.motion.positive import is_angle
from rotsolve.plan import Planner


class Components(Struct, frozen=True):
    """Those of a `size` whose direction is an `angle`, each the letter of a quantity."""

    size: str
    angle: str
    along: Symbol
    across: Symbol

    def put_into(self, side: Formula, positive: frozenset[str]) -> Formula | None:
        """A side of an equation by the components alone; None where it holds the size or the angle in another way."""
        terms = [self._put_into_term(term, positive) for term in flat([side])]
        return None if None in terms else total([term for term in terms if term is not None])

    def _put_into_term(self, term: Formula, positive: frozenset[str]) -> Formula | None:
        """m cos q as m_x: with m = √(m_x² + m_y²) and q = atan2(m_y, m_x) no root is left, and no angle."""
        if term.symbols().isdisjoint((self.size, self.angle)):
            return term
        plain = simplify(term, positive=positive)  # M w² (Σ m x)/M, where M is a sum with the size
        told = simplify(plain.substitute({self.size: self._size(), self.angle: self._angle()}), positive=positive)
        left = (
            node for node in told.walk("sqrt", "atan2") if isinstance(node, Call) and node.function in ("sqrt", "atan2")
        )
        return None if any(self.along.name in node.symbols() for node in left) else told

    def _size(self) -> Formula:
        return sqrt(self.along**2 + self.across**2)

    def _angle(self) -> Formula:
        return call("atan2", self.across, self.along)

    def telling_laws(self, section: str) -> Iterator[Equation]:
        """The size and the angle by the components."""
        size, angle = Symbol(self.size), Symbol(self.angle)
        means = (
            "with ",
            self.along,
            " = ",
            size * call("cos", angle),
            ", ",
            self.across,
            " = ",
            size * call("sin", angle),
        )
        yield COMPONENTS.equation(size, self._size(), section, remark=means, words="size")
        yield COMPONENTS.equation(angle, self._angle(), section, remark=means, words="direction")


def by_components(equations: Sequence[Equation], scene: SceneEquations, positive: frozenset[str]) -> list[Equation]:
    """The equations of a scene, those that hold a size and an angle that are both sought by their components where two of them do so."""
    found = list(equations)
    sought = [given for given in scene.configuration.problem.givens if given.asked]
    sizes = [given for given in sought if is_positive(given.dimension)]
    for size, angle in product(sizes, filter(is_angle, sought)):
        letters = letters_of_components(size, angle)
        pair = Components(size.name, angle.name, *(letter.symbol for letter in letters))
        told = {number: law for number, own in enumerate(found) if (law := by_pair(own, pair, positive)) is not None}
        written = [told.get(number, law) for number, law in enumerate(found)]
        if len(told) > 1 and are_told(pair, written, scene):
            found = [*written, *pair.telling_laws(next(iter(told.values())).section)]
            for letter in letters:
                scene.registry.ask(letter)
    return found


def are_told(pair: Components, equations: Sequence[Equation], scene: SceneEquations) -> bool:
    """Whether both components can be planned without the size and the angle: else these are told in another way, as by an energy."""
    givens = scene.configuration.problem.givens
    planner = Planner(equations, [given.name for given in givens if given.asked])
    known = {TIME, *(given.name for given in givens if not given.asked)}
    plans = [planner.plan(letter.name, known) for letter in (pair.along, pair.across)]
    return all(isinstance(plan, Plan) and {pair.size, pair.angle}.isdisjoint(plan.unknowns) for plan in plans)


def by_pair(law: Equation, pair: Components, positive: frozenset[str]) -> Equation | None:
    """An equation by the components of a pair; None where it is not one of these."""
    if not {pair.size, pair.angle} <= law.symbols():
        return None
    left, right = (pair.put_into(side, positive) for side in (law.left, law.right))
    return None if left is None or right is None else replace(law, left=left, right=right)


def letters_of_components(size: Given, angle: Given) -> tuple[SceneQuantity, ...]:
    """The letters of both components, m_x and m_y; of several pairs with one size each its own."""
    assert size.dimension is not None
    owner = f"{size.name} at {angle.name}"
    return tuple(SceneQuantity(COMPONENT, owner, "", axis, size.name, size.dimension) for axis in "xy")
