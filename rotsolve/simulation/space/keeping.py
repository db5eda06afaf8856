"""Keeping: what a motion in space has to keep: energy, less the work of what drives it, and components of angular momentum.

Energy is K + M g h, less the work of actions and of what leads or drives bodies; the forces of ideal joints do none together. What is
kept of the angular momentum of a body that nothing but its weight and an ideal joint with the ground acts on: `space/passing`.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

from rotsolve.algebra.formula import ZERO, Formula, add, multiply
from rotsolve.language.bodies import PointRef
from rotsolve.simulation.balance import Balance, Drift, balance_on_tape, largest_misfit
from rotsolve.simulation.bounded import Regime
from rotsolve.simulation.space.compiling import SpaceSystem
from rotsolve.simulation.space.outputs import place_in_space
from rotsolve.space.energies import kinetic_energies, power_of
from rotsolve.space.inertia import CM
from rotsolve.space.passing import left_alone, momenta, own_momentum


def drift_in_space(regimes: Sequence[Regime]) -> Drift:
    """The drift of energy and of all components of angular momentum that are kept."""
    system = regimes[0].system
    assert isinstance(system, SpaceSystem)
    labels = [label for label, *_ in kept_momenta(system)]
    kept = {label: largest_misfit(regimes, partial(kept_momentum, number)) for number, label in enumerate(labels)}
    told = {label: misfit for label, misfit in kept.items() if misfit is not None}
    return Drift(largest_misfit(regimes, energy_in_space), None, told)


def kept_momenta(system: SpaceSystem) -> Iterator[tuple[str, str, Formula]]:
    """The components of angular momentum that are kept: in words, of which body, the component."""
    held = system.moment.held
    for name in held.order:
        turned = held.problem.gravity_in and held.of_body(name)  # by weight that keeps to no vertical
        if left_alone(system.laws, name) and not held.pointlike(name) and not turned:
            for words, (value, _) in momenta(name, system.laws, system.laws):
                yield f"{words} of `{name}`", name, value


def kept_momentum(number: int, system: SpaceSystem) -> Iterator[Balance]:
    """One of these, beside which the whole angular momentum tells what is small."""
    _, name, value = list(kept_momenta(system))[number]
    yield from balance_on_tape(system, [value], [], list(own_momentum(system.laws, name)))


def energy_in_space(system: SpaceSystem) -> Iterator[Balance]:
    """K + M g h of all bodies that are not led, against the power of actions and of what leads or drives them; that of weight that turns
    with a body is such a power too."""
    moment, laws = system.moment, system.laws
    gravity = laws.pushes.gravity or ZERO
    bodies = [name for name in moment.held.order if not moment.held.bodies[name].moved]
    kinetic = [add(*kinetic_energies(laws, name)) for name in bodies]
    heights = [
        multiply(multiply(moment.held.mass(name), gravity), place_in_space(moment, PointRef(name, CM))[2])
        for name in (() if moment.held.problem.gravity_in else bodies)
    ]
    powers = [
        power_of(push, moment) for name in bodies for push in laws.pushes.on(name) if gives_power(push.owner, system)
    ]
    yield from balance_on_tape(system, [*kinetic, *heights], powers, kinetic)


def gives_power(owner: str, system: SpaceSystem) -> bool:
    """Whether something is no ideal joint: an action, a drive, what a body that is led carries."""
    held = system.moment.held
    if owner == "gravity" and held.problem.gravity_in:
        return True
    joint = held.joint(owner)
    if joint is None:
        return any(action.name == owner for action in system.laws.pushes.actions)
    carrier = held.bodies.get(joint.carrier.owner)
    return bool(joint.drive) or (carrier is not None and bool(carrier.moved))
