"""Passing from state to state in space: what is conserved on the way.

A body on which nothing but its weight and an ideal joint acts keeps its energy. Its angular momentum keeps all components about
the centre of mass of a free body, and about a fixed point without gravity; with gravity that along the vertical, and, of a
symmetric body, that along its axis: I₃ ω₃ (Goldstein, Poole & Safko, Classical Mechanics, §5.7).
"""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.formula import HALF, ONE, ZERO, Formula, add, multiply, negate
from rotsolve.core.derivation import NEXT, Words
from rotsolve.core.equation import BY_PLACE, CONSERVATION, FROM_STATE_TO_STATE, MOMENTUM, Equation
from rotsolve.core.faults import Unsolvable
from rotsolve.core.symbols import TIME
from rotsolve.core.vectors.heading import heading
from rotsolve.core.vectors.tensor import AXES
from rotsolve.core.vectors.triple import (
    Triple,
    dot_product,
    square,
    square_of,
    triple,
)
from rotsolve.core.writing import is_negative, spoken
from rotsolve.language.bodies import PointRef
from rotsolve.motion.timeline import Interval
from rotsolve.paths.meaning import NotYet
from rotsolve.space.attitude import IN_SPACE, NODE
from rotsolve.space.energies import energy_of
from rotsolve.space.inertia import CM
from rotsolve.space.laws import SpaceLaws
from rotsolve.space.moment import SpaceMoment
from rotsolve.space.working import of_rotor, of_work

Pairing = tuple[Formula, Formula]


def left_alone(laws: SpaceLaws, name: str, *, pushed: bool = False) -> bool:
    """Whether nothing acts on a body but its weight, an ideal joint that holds it to the ground, and actions where it may be `pushed`."""
    held = laws.moment.held
    joints = [joint for joint in held.joints if name in (joint.body.owner, joint.carrier.owner)]
    ideal = all(
        not (joint.powered or joint.rolls or joint.flat or joint.sliding or joint.carrier.owner in held.bodies)
        for joint in joints
    )
    acted = any(ref.owner == name for action in laws.pushes.actions for ref in action.touches())
    alone = len(joints) < 2 or joints == list(held.supports(name))
    return ideal and alone and (pushed or not acted) and not held.bodies[name].moved


def conserved(interval: Interval, before: SpaceLaws, after: SpaceLaws) -> Iterator[Equation]:
    """What is conserved in a phase."""
    for name in before.moment.held.order:
        if after.moment.goes_on(name):
            continue
        yield from driven_on(name, interval, before, after)
        yield from of_rotor(name, interval, before, after)
        if not left_alone(before, name):
            yield from of_work(name, interval, before, after)
            yield from on_slide(name, interval, before, after)
            continue
        yield from of_energy(name, interval, before, after)
        if before.moment.held.pointlike(name):
            continue
        yield from turning_tilts(name, interval, before, after)
        for words, (first, last) in momenta(name, before, after):
            if first != last:
                yield MOMENTUM.equation(first, last, interval.name, (name,), words=f"{words}, {spoken(name)}")


def driven_on(name: str, interval: Interval, before: SpaceLaws, after: SpaceLaws) -> Iterator[Equation]:
    """ω² = ω₀² + 2 α (φ − φ₀) of a body that is driven with a constant angular acceleration from one angle to another."""
    first, last = before.moment, after.moment
    joint = first.held.main(name)
    faster = dict(joint.drive).get("angular_acceleration") if joint is not None and len(joint.drive) == 1 else None
    if joint is None or faster is None or TIME in faster.symbols():
        return
    angles = [moment.stood(name, "angle") for moment in (first, last)]
    if angles[0] is None or angles[1] is None:
        return
    rates = [square(moment.rate_on(name, joint)) for moment in (first, last)]
    gained = multiply(2 * faster, add(angles[1], negate(angles[0])))
    words = "constant angular acceleration, ω² = ω₀² + 2 α Δφ"
    yield BY_PLACE.equation(rates[1], add(rates[0], gained), interval.name, (name,), words=words)


def turning_tilts(name: str, interval: Interval, before: SpaceLaws, after: SpaceLaws) -> Iterator[Equation]:
    """Between two tilts at which a symmetric top nods no more: with u = cos θ, a = I₃ ω₃ and W = M g l,
    2 I₁ W (1 − u²) + I₁² φ̇₀² sin²θ₀ (u₀ + u) = a² (u₀ − u) + 2 I₁ φ̇₀ a sin²θ₀, the energy with φ̇ from the angular momentum about the
    vertical, divided by u₀ − u (Goldstein, Poole & Safko, Classical Mechanics, §5.7)."""
    first, last = before.moment, after.moment
    gravity, joint = before.pushes.gravity, first.held.main(name)
    nods = first.nods(name) and first.axes(name).name == NODE and joint is not None and joint.free
    if not nods or gravity is None or any(moment.nodding(name).rates[1] != ZERO for moment in (first, last)):
        return
    angles = [heading(moment.nodding(name).angles[1]) for moment in (first, last)]
    if angles[0] == angles[1] or first.held.vanishes(add(angles[0].formula(), negate(angles[1].formula()))):
        return
    start, end = (angle.cos() for angle in angles)
    square_of_sine, rate = square(angles[0].sin()), first.nodding(name).rates[0]
    tensor = before.tensor(name, before.about(name)[1])
    spin, weight = multiply(tensor.zz, first.attitude(name).omega[2]), multiply(first.held.mass(name), gravity)
    lift = multiply(weight, first.arm(PointRef(name, CM))[2])
    left = add(
        multiply(multiply(2 * tensor.xx, lift), add(ONE, negate(square(end)))),
        multiply(multiply(square(multiply(tensor.xx, rate)), square_of_sine), add(start, end)),
    )
    right = add(
        multiply(square(spin), add(start, negate(end))),
        multiply(multiply(2 * tensor.xx, rate), multiply(spin, square_of_sine)),
    )
    words = f"energy and angular momentum between two tilts without nutation, {spoken(name)}"
    data = triple([tensor.xx, spin, lift])
    ground = ground_of_tilts((first, last), name, data)
    yield MOMENTUM.equation(left, right, interval.name, (name,), ground, words=words)
    yield from energy_by_momentum((first, last), name, interval, data)


def energy_by_momentum(
    moments: tuple[SpaceMoment, SpaceMoment], name: str, interval: Interval, data: Triple
) -> Iterator[Equation]:
    """W = ½ a φ̇ where it does not precess at one of two tilts: W (u₀ − u) = ½ I₁ φ̇² sin²θ divided by a (u₀ − u) = I₁ φ̇ sin²θ."""
    rates = [moment.nodding(name).rates[0] for moment in moments]
    _, spin, lift = data
    if ZERO in rates and spin != ZERO:
        words = f"energy divided by angular momentum about the vertical, {spoken(name)}"
        ground = equations_of_tilts(moments, name, data)
        turning = multiply(HALF, multiply(spin, rates[rates[0] == ZERO]))
        yield MOMENTUM.equation(lift, turning, interval.name, (name,), ground, words=words)


def ground_of_tilts(moments: tuple[SpaceMoment, SpaceMoment], name: str, data: Triple) -> Words:
    """The energy and the angular momentum about the vertical at two tilts, from which the equation for these comes; `data` are I₁, I₃ ω₃
    and M g l."""
    cosines = [heading(moment.nodding(name).angles[1]).cos() for moment in moments]
    rate, gap = moments[1].nodding(name).rates[0], add(cosines[0], negate(cosines[1]))
    gap = negate(gap) if is_negative(gap) else gap
    eliminated: Words = (rate, " eliminated, and ") if rate.symbols() else ()
    return (*equations_of_tilts(moments, name, data), NEXT, *eliminated, gap, " ≠ 0 divided out")


def equations_of_tilts(moments: tuple[SpaceMoment, SpaceMoment], name: str, data: Triple) -> Words:
    """The equations themselves, as lines."""
    across, spin, lift = data
    energies, momenta = list[Formula](), list[Formula]()
    for moment in moments:
        tilt, rate = heading(moment.nodding(name).angles[1]), moment.nodding(name).rates[0]
        turning, sine = multiply(HALF, multiply(across, square(rate))), square(tilt.sin())
        energies.append(add(multiply(turning, sine), multiply(lift, tilt.cos())))
        momenta.append(add(multiply(multiply(across, rate), sine), multiply(spin, tilt.cos())))
    rate, state = moments[1].nodding(name).rates[0], spoken(moments[1].when)
    with_rate: Words = (", with the precession ", rate, f" at {state}") if rate.symbols() else ()
    return (
        *("energy", *with_rate, ": ", energies[0], " = ", energies[1], NEXT),
        *("angular momentum about the vertical: ", momenta[0], " = ", momenta[1], NEXT),
        "I₃ ω₃ stays",
    )


def of_energy(name: str, interval: Interval, before: SpaceLaws, after: SpaceLaws) -> Iterator[Equation]:
    """K₁ + M g h₁ = K₂ + M g h₂; of a free body without gravity its rotation alone."""
    gravity = before.pushes.gravity
    held = not before.fixed(name)
    if held and gravity is not None:
        return  # nothing tells how far it has fallen
    first, last = (energy_of(laws, name, "rotational" if held else "") for laws in (before, after))
    if first != last:
        yield CONSERVATION.equation(first, last, interval.name, (name,), since="", form=FROM_STATE_TO_STATE)


def on_slide(name: str, interval: Interval, before: SpaceLaws, after: SpaceLaws) -> Iterator[Equation]:
    """½ M v₁² + M g h₁ = ½ M v₂² + M g h₂ of a body that slides along a direction of space, with its weight alone on it."""
    held = before.moment.held
    joint = held.main(name)
    touching = [one for one in held.joints if name in (one.body.owner, one.carrier.owner)]
    acted = any(ref.owner == name for action in before.pushes.actions for ref in action.touches())
    if joint is None or touching != [joint] or acted or held.bodies[name].moved:
        return
    turns = joint.turning or joint.free or joint.pitch is not None or joint.flat
    if not joint.sliding or turns or joint.powered or joint.carrier.owner in held.bodies:
        return
    try:
        first, last = (energy_of(laws, name) for laws in (before, after))
    except (Unsolvable, NotYet):  # nothing tells where it is
        return
    if first != last:
        yield CONSERVATION.equation(first, last, interval.name, (name,), since="", form=FROM_STATE_TO_STATE)


def momenta(name: str, before: SpaceLaws, after: SpaceLaws) -> Iterator[tuple[str, Pairing]]:
    """The components of the angular momentum that stay, in words, before and after."""
    joint, gravity = before.moment.held.main(name), before.pushes.gravity
    vectors = [own_momentum(laws, name) for laws in (before, after)]
    if joint is not None and joint.turning:
        way = before.moment.direction(name, joint)
        upright = before.moment.axes(name).to(IN_SPACE, way)[:2] == (ZERO, ZERO)
        if gravity is None or upright:
            yield "angular momentum about the axis", (dot_product(way, vectors[0]), dot_product(way, vectors[1]))
        return
    if joint is not None and not joint.free:
        return
    if any(laws.moment.axes(name).lost for laws in (before, after)):
        if joint is None or gravity is None:  # L stays in space, of which its own axes know the size
            yield "size of the angular momentum", (square_of(vectors[0]), square_of(vectors[1]))
        return
    if joint is None or gravity is None:
        ends = [
            laws.moment.axes(name).to(IN_SPACE, vector) for laws, vector in zip((before, after), vectors, strict=True)
        ]
        yield from ((f"angular momentum along {axis}", (a, b)) for axis, a, b in zip(AXES, *ends, strict=True))
    else:
        ups = [laws.moment.up(name) for laws in (before, after)]
        yield "angular momentum about the vertical", (dot_product(ups[0], vectors[0]), dot_product(ups[1], vectors[1]))
    axes = before.moment.attitude(name)
    if axes.axes.name == NODE and axes.about is not None:
        yield "angular momentum along its axis, I₃ ω₃", (vectors[0][2], vectors[1][2])


def own_momentum(laws: SpaceLaws, name: str) -> Triple:
    """L about the point of the law of rotation, in the axes of the body."""
    return laws.momentum(name, laws.about(name)[1])
