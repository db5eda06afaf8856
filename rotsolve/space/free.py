"""Free symmetric bodies: the axis goes round the constant angular momentum: φ̇ = L/I₁, ψ̇ = ω₃ − φ̇ cos θ = (I₁ − I₃) ω₃/I₁.

Landau & Lifshitz, Mechanics, §33; Goldstein, Poole & Safko, Classical Mechanics, §5.6.
"""

from __future__ import annotations

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, PI, ZERO, Call, Formula, add, multiply, negate, sqrt
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.vectors.tensor import AXES
from rotsolve.core.vectors.triple import Triple, dot_product, length_of, square_of
from rotsolve.language.problem import Path
from rotsolve.paths.meaning import Meaning, NotYet, path_text
from rotsolve.space.inertia import CM, entry_along
from rotsolve.space.laws import SpaceLaws

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
    tensor = laws.tensor(name, CM)
    across = (along[1], along[2], along[0])
    axial, other = entry_along(tensor, along), entry_along(tensor, across)
    letters, _ = laws.letters_of(name, tensor, own, CM)
    found = RATES.get(path.quantity)
    if found is None:
        raise NotYet(f"`{path_text(path)}` of a free body is not solved yet", path.span)
    formula, label = found(axial, other, letters, dot_product(own.omega, along), along)
    return Meaning(formula, QUANTITIES[path.quantity].dimension, label=label)


def precession(
    axial: Formula, across: Formula, momentum: Triple, along_axis: Formula, axis: Triple
) -> tuple[Formula, str]:
    """L/I₁, about L."""
    return length_of(momentum) / across, "its axis goes round its angular momentum, φ̇ = L/I₁"


def spin(axial: Formula, across: Formula, momentum: Triple, along_axis: Formula, axis: Triple) -> tuple[Formula, str]:
    """ω₃ − φ̇ cos θ with cos θ = I₃ ω₃/L."""
    share = add(ONE, negate(axial / across))
    return multiply(along_axis, share), "ψ̇ = ω₃ − φ̇ cos θ, φ̇ cos θ = (L/I₁)(I₃ ω₃/L)"


def tilt(axial: Formula, across: Formula, momentum: Triple, along_axis: Formula, axis: Triple) -> tuple[Formula, str]:
    """The angle of its axis from L."""
    cosine = simplify(dot_product(momentum, axis) / sqrt(square_of(momentum)))
    return Call("acos", (cosine,)), "angle of its axis from its angular momentum"


RATES = {"precession": precession, "spin": spin, "tilt": tilt}


def steady_period(laws: SpaceLaws, path: Path) -> Meaning:
    """2π/|ω| of a body that turns steadily about a fixed axis."""
    own = laws.moment.attitude(path.owner)
    if own.alpha != (ZERO, ZERO, ZERO):
        raise NotYet(f"`{path_text(path)}`: it does not turn steadily", path.span)
    return Meaning(2 * PI / length_of(own.omega), QUANTITIES["period"].dimension, label="period, T = 2π/ω")


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
