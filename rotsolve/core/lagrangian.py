"""Lagrangian: how tied bodies can move, as energies: T of the rates of independent coordinates and of places, and the power of forces.

A place p that ties tell by the coordinates q grows at ṗ = Σ (∂p/∂q) q̇, so that ∂p/∂q is the derivative of that rate by q̇: no tie between
places has to be solved, and Q = ∂(power)/∂q̇ is the virtual work of the forces per q (Goldstein, Poole & Safko, Classical Mechanics, §1.4).
What is driven has no coordinate: its rate stands in T, and time itself where it is a function of that.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from functools import cached_property

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.calculus.integral import antiderivative
from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import ZERO, Formula, Number, Symbol, add, divide, multiply, negate, total
from rotsolve.algebra.units.dimension import FORCE, TORQUE
from rotsolve.core.letters import Given, letter_order
from rotsolve.core.registry import Registry, SceneQuantity
from rotsolve.core.symbols import COORDINATE, COURSE, DOTTED, TIME, key_of, real
from rotsolve.core.writing import flat

DOTS = ("", DOTTED, DOTTED + DOTTED)
EFFORTS = (FORCE, TORQUE)


class GeneralizedCoordinate(Struct, frozen=True):
    """An independent coordinate: its letter q, the letter of its rate in T, what it is and which way it grows in words.

    The rate may be another than q̇: a clockwise ω of an angle that grows counterclockwise, v of an angle on a circle.
    """

    letter: Symbol
    rate: str
    words: str
    positive: str = ""


def rate_letter(letter: Formula) -> Formula:
    """The letter of the rate of a coordinate."""
    assert isinstance(letter, Symbol)
    key = key_of(letter.name)
    return Symbol(replace(key, kind=DOTTED + key.kind).name)


def order_on_page(givens: Iterable[Given], registries: Sequence[Registry]) -> tuple[str, ...]:
    """All letters, dotted ones too, in the order in which a textbook writes them in a product."""
    quantities = {key: item for registry in registries for key, item in registry.quantities.items()}
    named = [(given.name, given.dimension) for given in givens]
    named += [(dots + key, item.dimension) for dots in DOTS for key, item in quantities.items()]
    return letter_order(named)


def pace_of_coordinate(q: GeneralizedCoordinate, growth: Mapping[str, Formula]) -> Formula:
    """A coordinate's rate per q̇, by how its letter grows."""
    return simplify(divide(Symbol(q.rate), growth[q.letter.name]))


class PageLetters(Struct, frozen=True):
    """The letters of the page on which a scene is written: those that are `known` at the moment of letters are of one kind each there; what
    `real` tells of forces are the scene's own."""

    known: Registry
    page: Registry
    real: Callable[[SceneQuantity], Formula]

    def letters(
        self,
        coordinates: Sequence[GeneralizedCoordinate],
        growth: Mapping[str, Formula],
        changes: Mapping[str, Formula],
    ) -> dict[str, Formula]:
        """What a page writes for places, for the rates of coordinates and the rates of these, and for what is driven."""
        found = {name: self._letter(item) for name, item in self.known.quantities.items() if COURSE in item.when}
        for q in coordinates:
            letter, pace = found[q.letter.name], pace_of_coordinate(q, growth)
            found[q.rate] = found[real(q.rate)] = multiply(pace, rate_letter(letter))
            found |= {name: multiply(pace, rate_letter(rate_letter(letter))) for name in changes[q.rate].symbols()}
        return found

    def _letter(self, quantity: SceneQuantity) -> Formula:
        if quantity.dimension in EFFORTS:
            return self.real(quantity)
        own = replace(quantity, kind=COORDINATE + quantity.kind, when=COURSE)
        return self.page.quantities.setdefault(own.key, own).symbol


class Lagrangian(Struct, frozen=True, dict=True):
    """The terms of T; the powers of forces that have a potential, of `weights`, which are integrated, and of what is `sprung`, whose
    energies are told; and those of all others that are `given`.

    `growth` are the rates of places by their letters, those of the coordinates among them; `changes` those of rates. `page` has
    what a page writes for all these letters: q, q̇ and q̈.
    """

    coordinates: tuple[GeneralizedCoordinate, ...]
    kinetic: tuple[Formula, ...]
    weights: tuple[Formula, ...]
    given: tuple[Formula, ...]
    growth: Mapping[str, Formula]
    changes: Mapping[str, Formula]
    page: Mapping[str, Formula]
    sprung: tuple[Formula, ...] = ()
    energies: tuple[Formula, ...] = ()
    order: tuple[str, ...] = ()  # of letters, in which a page writes factors
    positive: frozenset[str] = frozenset()
    steady: frozenset[str] = frozenset()  # rates of what is driven evenly
    turned: frozenset[str] = frozenset()  # places of what is driven

    def tidy(self, value: Formula) -> Formula:
        """A formula in textbook form."""
        return simplify(value, order=self.order, positive=self.positive)

    def momentum(self, q: GeneralizedCoordinate) -> list[Formula]:
        """∂T/∂q̇ by the coordinate's rate, of each term of T."""
        return [differentiate(part, q.rate) for part in self.kinetic]

    def inertial(self, q: GeneralizedCoordinate) -> Iterator[Formula]:
        """d/dt(∂T/∂q̇) − ∂T/∂q by the coordinate's rate, of each term of T."""
        for part, momentum in zip(self.kinetic, self.momentum(q), strict=True):
            yield add(self.in_time(momentum), negate(self.slope(part, q)))

    def in_time(self, value: Formula) -> Formula:
        """d/dt of a function of places and rates, by the chain rule."""
        pace = {**self.changes, **self.growth}
        names = sorted(value.symbols() & pace.keys())
        return total([multiply(differentiate(value, name), pace[name]) for name in names])

    def slope(self, value: Formula, q: GeneralizedCoordinate) -> Formula:
        """∂/∂q of a function of places, by the coordinate's rate, through all of them that grow with q."""
        names = sorted(value.symbols() & self.growth.keys())
        along = ((name, simplify(differentiate(self.growth[name], q.rate))) for name in names)
        return total([multiply(differentiate(value, name), rate) for name, rate in along if rate != ZERO])

    def efforts(self, q: GeneralizedCoordinate) -> list[Formula]:
        """The generalized force by the coordinate's rate, force by force: −∂V/∂q too."""
        return [differentiate(power, q.rate) for power in (*self.weights, *self.sprung, *self.given)]

    def efforts_without_potential(self, q: GeneralizedCoordinate) -> list[Formula]:
        """The same of forces that have no potential."""
        return [differentiate(power, q.rate) for power in self.given]

    def pace(self, q: GeneralizedCoordinate) -> Formula:
        """The coordinate's rate per q̇, which is constant."""
        return pace_of_coordinate(q, self.growth)

    def cyclic(self, q: GeneralizedCoordinate) -> bool:
        """Whether ∂L/∂q and all else that pushes along q are nothing, wherever the bodies are."""
        slopes = (self.slope(part, q) for part in self.kinetic)
        return is_zero(total([*slopes, *self.efforts(q)]))

    def grows(self, value: Formula) -> bool:
        """Whether all that moves in a formula is a rate, or a place of which it is told how it grows."""
        moving = {name for name in value.symbols() if COURSE in key_of(name).when or key_of(name).running}
        return moving <= {*self.growth, *self.changes}

    @property
    def closed(self) -> bool:
        """Whether T can be differentiated: all that moves in it is known."""
        return all(map(self.grows, self.kinetic))

    @cached_property
    def natural(self) -> bool:
        """Whether T is a square form of the rates of coordinates: nothing is led, so that Σ q̇ ∂T/∂q̇ = 2 T and T + V is the energy."""
        doubled = (multiply(Symbol(q.rate), term) for q in self.coordinates for term in self.momentum(q))
        return is_zero(add(total(list(doubled)), multiply(Number(Fraction(-2)), total(self.kinetic))))

    @cached_property
    def energy(self) -> tuple[Formula, ...] | None:
        """The terms of Σ q̇ ∂T/∂q̇ − T + V, which is T + V where nothing is led; None where time occurs in it, or V is not found."""
        rates = {q.rate for q in self.coordinates}
        led = any((self.changes.keys() | {TIME}) & part.symbols() - rates - self.steady for part in self.kinetic)
        if led or self.potential is None:
            return None
        if self.steady:
            return self.seen_in_frame(self.potential)
        if self.natural:
            return (*self.kinetic, *self.potential)
        doubled = (multiply(Symbol(q.rate), term) for q in self.coordinates for term in self.momentum(q))
        return (*doubled, *map(negate, self.kinetic), *self.potential)

    def seen_in_frame(self, potential: tuple[Formula, ...]) -> tuple[Formula, ...] | None:
        """T₂ − T₀ + V, term by term and without what no coordinate changes: T₂ is the kinetic energy in the frame of what is driven evenly;
        None where it matters how far that has turned."""
        still, terms = {q.rate: ZERO for q in self.coordinates}, list[Formula]()
        for part in self.kinetic:
            doubled = total([multiply(Symbol(q.rate), differentiate(part, q.rate)) for q in self.coordinates])
            carried = part.substitute(still)
            terms += [self.tidy(doubled - part + carried), negate(self.tidy(carried))]
        own = {*still, *(q.letter.name for q in self.coordinates)}
        known = tuple(term for term in (*terms, *potential) if term.symbols() & own)
        return None if any(term.symbols() & (self.turned | {TIME}) for term in known) else known

    @cached_property
    def potential(self) -> tuple[Formula, ...] | None:
        """The terms of V by the places; None where that of a weight is not found."""
        found = [self.integrated(power) for power in self.weights]
        known = [energy for energy in found if energy is not None]
        return (*flat(known), *self.energies) if len(known) == len(found) else None

    def integrated(self, power: Formula) -> Formula | None:
        """V of a force whose power is −dV/dt: Σ ∫ (∂V/∂q) dq, coordinate after coordinate; None where it is not found so."""
        if not self.grows(power):
            return None
        energy: Formula = ZERO
        for q in self.coordinates:
            rest = simplify(negate(add(differentiate(power, q.rate), self.slope(energy, q))))
            if rest == ZERO:
                continue
            primitive = antiderivative(simplify(multiply(rest, self.pace(q))), q.letter.name)
            if primitive is None:
                return None
            energy = self.tidy(add(energy, primitive))
        gaps = (add(differentiate(power, q.rate), self.slope(energy, q)) for q in self.coordinates)
        return energy if all(map(is_zero, gaps)) else None
