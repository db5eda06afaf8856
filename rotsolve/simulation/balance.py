"""Balance: energy and momentum of a motion against the work and impulse of its forces: a measure of how well the steps keep them.

Energy is K + U, less the work W = ∫ P dt of all forces without a potential; momentum Σ m v, less the impulse ∫ Σ F dt. Neither tells
the error of a motion, which may drift along itself; the bounds do.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from math import fsum
from typing import Any

from msgspec import Struct

from rotsolve.algebra.certified.ball import Precision
from rotsolve.algebra.formula import ZERO, Formula, Symbol, total
from rotsolve.algebra.tape import BITS
from rotsolve.core.facts import BodyFacts, Force
from rotsolve.core.symbols import GENERIC, SymbolKey
from rotsolve.core.vectors.heading import RIGHT, UP
from rotsolve.laws import energy
from rotsolve.simulation.bounded import FLOAT_BITS, Regime
from rotsolve.simulation.series import BALLS, FLOATS
from rotsolve.simulation.system import PlanarSystem, Readout, System
from rotsolve.simulation.tape import Scalar

LOOKS = 400  # moments of a regime at which the balance is drawn; where it takes integrals, its first steps
BALANCE_BITS = 128
CLOSE = 1e-14  # how well two halves of an integral make the whole
OFF = 1e-9  # part of the forces by which they may miss the rate of momentum, where not all of them are told
NODES = (  # Gauss and Legendre's places and weights on −1 to 1, the positive half
    (0.1488743389816312, 0.2955242247147529),
    (0.4333953941292472, 0.2692667193099963),
    (0.6794095682990244, 0.2190863625159821),
    (0.8650633666889845, 0.1494513491505806),
    (0.9739065285171717, 0.0666713443086881),
)


class Drift(Struct, frozen=True):
    """The largest misfit of energy and of momentum, as a part of the largest that there was; None where not all is told.

    `angular_momentum` has, in space, those of each component that is kept.
    """

    energy: float | None
    momentum: float | None
    angular_momentum: Mapping[str, float] = {}


class Balance(Struct, frozen=True):
    """A quantity, the rate at which it is fed, and the parts that tell its size: places on a tape.

    `check` is what the rate must be at once, where it is known in another way.
    """

    value: int
    rate: int
    parts: tuple[int, ...]
    check: int | None = None


def drift(regimes: Sequence[Regime]) -> Drift:
    """The drift of energy and momentum over a whole motion."""
    return Drift(largest_misfit(regimes, energy_balance), largest_misfit(regimes, momentum_balance))


def largest_misfit(regimes: Sequence[Regime], balances: Callable[[Any], Iterator[Balance]]) -> float | None:
    """The largest misfit within a regime, as a part of the largest size in all; None where the forces do not tell it."""
    misfits, sizes = [0.0], [0.0]
    for part in regimes:
        with Precision(BITS):
            found = list(balances(part.system))
        for balance in found:
            pair = misfit(balance, part)
            if pair is None:
                return None
            misfits.append(pair[0])
            sizes.append(pair[1])
        if not found:
            return None
    return max(misfits) / max(sizes) if max(sizes) else max(misfits)


def misfit(balance: Balance, part: Regime) -> tuple[float, float] | None:
    """By how much value − ∫ rate dt changes in a regime, and the largest size; None where the rate is not what it must be."""
    system = part.system
    places = (balance.value, balance.rate, *balance.parts, *((balance.check,) if balance.check is not None else ()))
    reading = Values(part, places)
    fed = system.tape.constant(balance.rate) != 0
    pieces = part.runs[0].pieces
    pieces = pieces[:LOOKS] if fed else pieces[:: 1 + len(pieces) // LOOKS]
    first, spent = reading.at(part.times[0]), [0.0]
    own = slice(2, 2 + len(balance.parts))
    size, worst, strongest = sum(abs(float(part)) for part in first[own]), 0.0, 0.0
    with Precision(max(BALANCE_BITS, part.bits)):
        for piece in pieces:
            if fed:
                spent.append(reading.fed(piece.start, piece.length))
            now = reading.at(piece.start + piece.length)
            size = max(size, sum(abs(float(value)) for value in now[own]))
            worst = max(worst, abs(float(now[0] - first[0]) - fsum(spent)))
            strongest = max(strongest, abs(float(now[1])))
            if balance.check is not None and abs(float(now[-1] - now[1])) > OFF * max(strongest, size):
                return None
    return worst, size


class Values:
    """Reads some places on a tape at moments of a regime, by its main run, in its own numbers."""

    def __init__(self, part: Regime, places: Sequence[int]) -> None:
        self.part = part
        self.readout = Readout(part.system, dict(enumerate(places)), FLOATS if part.bits == FLOAT_BITS else BALLS)

    def fed(self, start: float, length: float, halvings: int = 6) -> float:
        """∫ rate dt over a time, halved until both halves make the whole."""
        half = length / 2
        whole, parts = self._gauss(start, length), (self._gauss(start, half), self._gauss(start + half, half))
        if not halvings or abs(whole - sum(parts)) <= CLOSE * max(abs(whole), *map(abs, parts)):
            return fsum(parts)
        return self.fed(start, half, halvings - 1) + self.fed(start + half, half, halvings - 1)

    def _gauss(self, start: float, length: float) -> float:
        """∫ rate dt by ten moments."""
        half = length / 2
        moments = ((weight, start + half * (1 + sign * place)) for place, weight in NODES for sign in (-1, 1))
        return half * fsum(weight * float(self.at(moment)[1]) for weight, moment in moments)

    def at(self, time: float) -> list[Scalar]:
        return list(self.readout.read(time, self.part.middle(time)).values())


def energy_balance(system: PlanarSystem) -> Iterator[Balance]:
    """K + U against the power of what has no potential; nothing where a turning shaft gives energy."""
    bodies = system.facts.bodies
    if any(body.sweep is not None for body in bodies):
        return
    kinetic = energy.kinetic(list(bodies))
    weights = ((body, force) for body in bodies for force in body.forces if force.role.weighs)
    heights = [force.size * (risen(body, system) + force.arm.along(UP)) for body, force in weights]
    stored = [item.energy for item in system.facts.potentials]
    holders = {item.owner for item in system.facts.potentials}
    powers: list[Formula] = []
    for body in bodies:
        for item in body.acting:
            if item.internal or item.role.weighs or item.owner in holders:
                continue
            if isinstance(item, Force):
                powers.append(item.vector.dot(body.motion.velocity_of(item.arm)))
            else:
                powers.append(item.torque * body.motion.spin)
    yield from balance_on_tape(system, [*kinetic, *heights, *stored], powers, kinetic)


def risen(body: BodyFacts, system: PlanarSystem) -> Formula:
    """How high the reference point of a body is above some level that stays."""
    motion, since = body.motion, GENERIC + system.moment.state
    if motion.kind == "axis":
        return ZERO
    if motion.bend is not None:
        return motion.bend.radius * motion.bend.outward.sin()
    axis = "" if motion.heading is not None else "y"
    gone = Symbol(SymbolKey("displacement", body.name, axis, since).name)
    return gone if motion.heading is None else gone * motion.heading.sin()


def momentum_balance(system: PlanarSystem) -> Iterator[Balance]:
    """Σ m v to the right and up against the sum of all forces, where these are all told and nothing is carried round."""
    if any(body.sweep is not None for body in system.facts.bodies):
        return
    for axis in (RIGHT, UP):
        parts = [body.mass * body.centre_velocity.along(axis) for body in system.facts.bodies]
        forces = [force.vector.along(axis) for body in system.facts.bodies for force in body.forces]
        rates = [body.mass * body.centre_acceleration.along(axis) for body in system.facts.bodies]
        yield from balance_on_tape(system, parts, forces, parts, rates)


def balance_on_tape(
    system: System, value: list[Formula], rate: list[Formula], parts: list[Formula], check: list[Formula] | None = None
) -> Iterator[Balance]:
    """A balance on the tape of a system, where all its letters are told."""
    formulas = [total(value), total(rate), *parts, *([total(check)] if check is not None else [])]
    if all(formula.symbols() <= set(system.letters) for formula in formulas):
        places = [system.tape.formula(formula, system.letters) for formula in formulas]
        last = places.pop() if check is not None else None
        yield Balance(places[0], places[1], tuple(places[2:]), last)
