"""Free symmetric bodies: the axis goes round the constant angular momentum: φ̇ = L/I₁, ψ̇ = ω₃ − φ̇ cos θ = (I₁ − I₃) ω₃/I₁.

Landau & Lifshitz, Mechanics, §33; Goldstein, Poole & Safko, Classical Mechanics, §5.6.
"""

from __future__ import annotations

from collections.abc import Callable

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, PI, ZERO, Call, Formula, add, call, multiply, negate, sqrt
from rotsolve.algebra.units.dimension import ANGULAR_MOMENTUM
from rotsolve.core.equation import SIZE_OF_MOMENTUM, Equation
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.registry import SceneQuantity
from rotsolve.core.symbols import MOMENTUM_SIZE
from rotsolve.core.vectors.tensor import AXES
from rotsolve.core.vectors.triple import (
    NOTHING,
    Triple,
    X,
    Y,
    Z,
    cross_product,
    dot_product,
    is_axis,
    length_of,
    rotated,
    square,
)
from rotsolve.core.writing import spoken
from rotsolve.language.bodies import PointRef
from rotsolve.language.problem import Path
from rotsolve.paths.meaning import Meaning, NotYet, path_text
from rotsolve.space.arrangement import JointedBodies
from rotsolve.space.attitude import IN_SPACE, permutation
from rotsolve.space.inertia import CM, entry_along, product
from rotsolve.space.laws import SpaceLaws
from rotsolve.space.moment import SpaceMoment
from rotsolve.space.passing import left_alone

NEEDS = "tell `{0}.tilt` and its rates in the state, or the angular velocity of a free body that is symmetric about its `axis`"


def about_own_momentum(laws: SpaceLaws, path: Path) -> Meaning:
    """Precession, spin, tilt and axial rate of a free symmetric body, about its angular momentum."""
    held, moment, name = laws.moment.held, laws.moment, path.owner
    axis = held.axis(name)
    own = moment.attitude(name)
    along = moment.symmetry_axis(name)
    if held.of_body(name) or axis is None or along is None or not held.symmetric(name, axis) or held.bodies[name].moved:
        raise NotYet(f"`{path_text(path)}` has no meaning here", path.span, NEEDS.format(name))
    if path.quantity == "axial_rate":
        return Meaning(dot_product(own.omega, along), QUANTITIES["axial_rate"].dimension)
    refuse_unfree(laws, path)
    tensor = laws.tensor(name, CM)
    across = (along[1], along[2], along[0])
    axial, other = entry_along(tensor, along), entry_along(tensor, across)
    letters, _ = laws.letters_of(name, tensor, own, CM)
    dimension = QUANTITIES[path.quantity].dimension
    refuse_about_axis(laws, path, own.omega, along)
    if path.quantity == "spin":  # ω₃ − φ̇ cos θ with cos θ = I₃ ω₃/L
        share = add(ONE, negate(axial / other))
        label = "ψ̇ = ω₃ − φ̇ cos θ, φ̇ cos θ = (L/I₁)(I₃ ω₃/L)"
        return Meaning(multiply(dot_product(own.omega, along), share), dimension, label=label)
    if path.quantity not in BY_SIZE:
        raise NotYet(f"`{path_text(path)}` of a free body is not solved yet", path.span)
    size, defined = size_as_letter(laws, name, letters)
    if path.quantity == "precession":
        return Meaning(
            size / other, dimension, label="its axis goes round its angular momentum, φ̇ = L/I₁", laws=defined
        )
    cosine = simplify(dot_product(letters, along) / size)
    label = "angle of its axis from its angular momentum"
    return Meaning(Call("acos", (cosine,)), dimension, label=label, laws=defined)


def refuse_about_axis(laws: SpaceLaws, path: Path, omega: Triple, axis: Triple) -> None:
    """Refuse the precession and the spin of a body that turns about its own axis alone, and all of one that does not turn: its axis goes
    round nothing, and only their sum is told."""
    still = all(map(laws.moment.held.vanishes, omega))
    if still or (path.quantity != "tilt" and all(map(laws.moment.held.vanishes, cross_product(omega, axis)))):
        how = "does not turn" if still else "turns about its own axis alone"
        message = (
            f"`{path.owner}` {how} at {laws.moment.spoken_of()}: it has no `{path.quantity}` about its angular momentum"
        )
        raise NotYet(
            message, path.span, "" if still else f"ask for its `angular_velocity` or `{path.owner}.axial_rate`"
        )


def refuse_unfree(laws: SpaceLaws, path: Path) -> None:
    """Refuse what is told about the angular momentum of a body that others are part of or push, or that a couple or force may turn."""
    held, name = laws.moment.held, path.owner
    carried = [joint.body.owner for joint in held.joints if joint.carrier.owner == name]
    if carried:
        message = f"`{path_text(path)}` is told of a free body alone, and `{name}` carries `{carried[0]}`"
        raise NotYet(message, path.span, "make what moves as one the `parts` of one body")
    centre = laws.moment.arm(PointRef(name, CM))
    turns = (push.couple != NOTHING or not laws.tensors.same_place(push.arm, centre) for push in laws.pushes.on(name))
    if any(turns):  # also what has no torque about it at this moment alone
        message = (
            f"`{path_text(path)}` is told about an angular momentum that stays, and what acts on `{name}` may turn it"
        )
        raise NotYet(message, path.span, NEEDS.format(name))


BY_SIZE = ("precession", "tilt")  # what is told by the size of the angular momentum


def size_as_letter(laws: SpaceLaws, name: str, momentum: Triple) -> tuple[Formula, tuple[Equation, ...]]:
    """The size of an angular momentum as a letter, with what defines it; of one along an axis the size of its only part."""
    if is_axis(momentum) or momentum == NOTHING:
        return length_of(momentum), ()
    when = laws.moment.when
    quantity = SceneQuantity(MOMENTUM_SIZE, name, when, "", "L", ANGULAR_MOMENTUM)
    symbol = laws.moment.registry.ask(quantity)
    return symbol, (SIZE_OF_MOMENTUM.equation(symbol, length_of(momentum), when, (name,)),)


def in_euler_angles_of(moment: SpaceMoment, path: Path) -> Meaning:
    """An Euler angle of a symmetric body that goes round its angular momentum, or the rate of one, by its axis e₃ and ω in space axes:
    cos θ = ẑ · e₃, φ̇ = (ω · ẑ − ω₃ cos θ)/sin² θ, ψ̇ = ω₃ − φ̇ cos θ, θ̇ = −ẑ · (ω × e₃)/sin θ."""
    name, word = path.owner, path.quantity
    axis = moment.held.axis(name)
    if axis is None:
        raise NotYet(f"`{path_text(path)}` has no meaning here", path.span, NEEDS.format(name))
    own = moment.own_axes(name)
    one, two, third = (own.to(IN_SPACE, way) for way in permutation(axis))
    attitude = moment.attitude(name)
    omega = attitude.axes.to(IN_SPACE, attitude.omega)
    along, cosine = dot_product(attitude.omega, own.to(attitude.axes, axis)), third[2]
    rate = add(omega[2], negate(multiply(along, cosine))) / add(ONE, negate(square(cosine)))
    found: dict[str, Callable[[], Formula]] = {
        "tilt": lambda: call("acos", cosine),
        "precession_angle": lambda: call("atan2", third[0], negate(third[1])),
        "spin_angle": lambda: call("atan2", one[2], two[2]),
        "precession": lambda: rate,
        "spin": lambda: add(along, negate(multiply(rate, cosine))),
        "nutation": lambda: negate(cross_product(omega, third)[2]) / sqrt(add(ONE, negate(square(cosine)))),
        "axial_rate": lambda: along,
    }
    return Meaning(
        found[word](), QUANTITIES[word].dimension, label=f"{spoken(word)} of {spoken(name)}, by its axis in space"
    )


def turns_freely(laws: SpaceLaws, name: str) -> bool:
    """Whether no torque acts about the point about which a body turns, so that its angular momentum stays."""
    held = laws.moment.held
    joint, arm = held.main(name), held.arm(PointRef(name, CM))
    weightless = laws.pushes.gravity is None or all(map(held.vanishes, arm))
    return (joint is None or (joint.free and weightless)) and left_alone(laws, name) and not held.pointlike(name)


def along_momentum(laws: SpaceLaws, name: str) -> bool:
    """Whether ω lies along L, so that both stay."""
    own, (_, point) = laws.moment.attitude(name), laws.about(name)
    across = cross_product(product(laws.tensor(name, point), own.omega), own.omega)
    return all(laws.moment.held.vanishes(laws.tensors.spelled(part)) for part in across)


def symmetric_way(held: JointedBodies, name: str) -> Triple | None:
    """An own axis, through the point about which a body turns, about which it is symmetric: that which it has told first."""
    ways = (way for way in (held.axis(name), Z, X, Y) if way is not None)
    return next((way for way in ways if held.turns_round(name, way)), None)


def period_of_turning(laws: SpaceLaws, path: Path) -> Meaning:
    """2π/|ω| of a body that turns steadily about a fixed axis; of a free one the time in which ω comes round in its own axes."""
    own, name, held = laws.moment.attitude(path.owner), path.owner, laws.moment.held
    dimension = QUANTITIES["period"].dimension
    free = turns_freely(laws, name)
    if all(map(held.vanishes, own.omega)):
        raise NotYet(f"`{name}` does not turn at {laws.moment.spoken_of()}: it has no `period`", path.span)
    if all(map(held.vanishes, own.alpha)) or (free and along_momentum(laws, name)):
        label = "period of the turn, since ω stays in the own axes, T = 2π/ω" if free else "period, T = 2π/ω"
        return Meaning(2 * PI / length_of(own.omega), dimension, label=label)
    if not free:
        if laws.moment.nods(name) and not laws.moment.state.steady:
            from rotsolve.space.nutation import nutation_period

            return nutation_period(laws, name)
        help = "small swings about a steady precession have a `period of small swings`"
        raise NotYet(
            f"`{path_text(path)}`: it does not turn steadily", path.span, help if laws.moment.nods(name) else ""
        )
    way = symmetric_way(held, name)
    if way is not None:
        axis = rotated(own.own, way)
        tensor = laws.tensor(name, laws.about(name)[1])
        axial, across = entry_along(tensor, axis), entry_along(tensor, rotated(own.own, (way[1], way[2], way[0])))
        rate = multiply(dot_product(own.omega, axis), add(across, negate(axial)) / across)
        label = "period of ω in the own axes, T = 2π/|ψ̇|"
        said = (across, " ≠ ", axial, ", else ω stays") if held.signs.lacking(add(across, negate(axial))) else ()
        return Meaning(2 * PI / length_of((rate, ZERO, ZERO)), dimension, label=label, said=said)
    from rotsolve.space.asymmetric import Polhode

    polhode = Polhode(laws, name)
    words = "period of ω in the own axes, T = 4 K(m)/p; it turns over twice in it"
    return Meaning(polhode.period(), dimension, label=words, laws=tuple(polhode.laws))


def principal_letters(laws: SpaceLaws, name: str) -> Triple:
    """The three moments along its own axes of a body without products of inertia; refused by name of others."""
    tensor = laws.tensor(name, CM)
    if any(product != ZERO for product in (tensor.xy, tensor.yz, tensor.zx)):
        raise NotYet(f"the own axes of `{name}` are not its principal ones")
    return (tensor.xx, tensor.yy, tensor.zz)


def own_axis_of(omega: Triple) -> str:
    """The axis along which an angular velocity lies; '' where it lies along none."""
    found = [axis for axis, part in zip(AXES, omega, strict=True) if part != ZERO]
    return found[0] if len(found) == 1 else ""
