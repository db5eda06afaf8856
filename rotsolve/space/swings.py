"""Small swings in space: what a small disturbance of a steady motion does to a body that is held at a point, or on an axis.

A symmetric top nods in the effective potential (p_φ − p_ψ cos θ)²/(2 I₁ sin² θ) + M g l cos θ. Its second derivative at a steady precession
tells θ̈ = −((I₃ ω₃/I₁ − 2 φ̇ cos θ)² + φ̇² sin² θ) δθ; upright, with p_φ = p_ψ, it tells θ̈ = −((I₃ ω₃/(2 I₁))² − M g l/I₁) θ, in a plane
through the vertical that turns at I₃ ω₃/(2 I₁) (Landau & Lifshitz, Mechanics, §35; Goldstein, Poole & Safko, Classical Mechanics, §5.7).
About an axis n with the centre of mass at r, I δφ̈ = −M g (ẑ · n × (n × r)) δφ. Swings of what is free, or rolls, are those of `stability`.
"""

from __future__ import annotations

from collections.abc import Mapping

from msgspec.structs import replace

from rotsolve.algebra.formula import PI, ZERO, Formula, add, multiply, negate, sqrt
from rotsolve.core.equation import SMALL_DISTURBANCE, SMALL_NUTATION
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.vectors.heading import heading
from rotsolve.core.vectors.triple import Z, cross_product, dot_product, length_of, rotated, square, transposed
from rotsolve.language.bodies import PointRef
from rotsolve.language.problem import Path, Term
from rotsolve.paths.meaning import Meaning, NotYet
from rotsolve.space.inertia import CM, moment_along
from rotsolve.space.laws import SpaceLaws
from rotsolve.space.passing import left_alone
from rotsolve.space.stability import growth

SMALL = "small swings"
SOLVED = (
    "solved are a symmetric top on a fixed point about a steady precession or the vertical, what hangs on a hinge "
    "that is at rest or carried round, with rotors on it, "
    "a wheel that rolls upright, and a free body about one of its own axes"
)


def small_swings(dynamics: Mapping[str, SpaceLaws], term: Term) -> tuple[Meaning, str]:
    """ω = √(−λ²) of the small disturbance of a steady motion that goes as exp(λ t), the frequency ω/2π, or the period 2π/ω."""
    name = body_of(next(iter(dynamics.values())), term)
    if term.modifier != SMALL:
        help = "`period` of a top that nods is that of its nutation; `rotsolve simulate` follows all others"
        raise NotYet(f"swings of `{name}` of any size are not solved in space", term.path.span, help)
    state = steady_state_of(dynamics, name, term)
    laws, path = dynamics[state or next(iter(dynamics))], replace(term.path, owner=name, quantity="stability")
    found = growth(laws, path) if state else of_hinge(laws, path, told=False)
    back = negate(found.formula)
    side = laws.moment.signs.taken(laws.tensors.spelled(back))
    where = f"about `{state}`" if state else "about its equilibrium"
    if side == 0:
        raise NotYet(f"nothing drives `{name}` back {where}: there are no small swings", term.path.span)
    if side == -1:
        raise NotYet(
            f"`{name}` has no small swings {where}: the motion is unstable",
            term.path.span,
            least_spin_upright(laws, name),
        )
    rate, quantity = sqrt(back), term.path.quantity
    formula = {"angular_frequency": rate, "frequency": rate / (2 * PI)}.get(quantity, 2 * PI / rate)
    behind = laws.tensors.behind(formula)
    return replace(found, formula=formula, dimension=QUANTITIES[quantity].dimension, laws=behind), laws.moment.when


def body_of(laws: SpaceLaws, term: Term) -> str:
    """The body that swings: the one that is named, else the only one that is not led."""
    names = [name for name, body in laws.moment.held.bodies.items() if not body.moved]
    if term.path.owner or len(names) == 1:
        return term.path.owner or names[0]
    raise NotYet("of which body the small swings are nothing tells", term.path.span, "say `of` which body")


def steady_state_of(dynamics: Mapping[str, SpaceLaws], name: str, term: Term) -> str:
    """The state about whose motion it swings: the one that is named, else the only steady one; '' where there is none."""
    steady = [state for state, laws in dynamics.items() if goes_on_steadily(laws, name)]
    if term.at and term.at not in steady:
        help = "add `steady: true` to the state"
        raise NotYet(f"`{term.at}` is not said to be a steady motion", term.path.span, help)
    if len(steady) > 1 and not term.at:
        raise NotYet(
            "about which steady motion the small swings are nothing tells", term.path.span, "say `about` which state"
        )
    return term.at or next(iter(steady), "")


def goes_on_steadily(laws: SpaceLaws, name: str) -> bool:
    """Whether the motion of a body at a state is said to be steady; at rest an axis stays that is upright, or hangs."""
    return laws.moment.state.steady or (stands_upright(laws, name) and laws.moment.rests(name))


def least_spin_upright(laws: SpaceLaws, name: str) -> str:
    """What an upright top would need to be stable: the least spin, as a number where there is one."""
    if not stands_upright(laws, name):
        return ""
    axial, across, lift = top_of(laws, name)
    least = laws.moment.signs.number(laws.tensors.spelled(2 * sqrt(multiply(across, lift)) / axial))
    return "it needs I₃ ω₃ ≥ 2 √(I₁ M g l)" + ("" if least is None else f", at least {float(least.ball):.4g} rad/s")


def of_held(laws: SpaceLaws, path: Path) -> Meaning:
    """λ² of a body that is held at one point, or on one axis: of a top about its steady motion, of what hangs at rest on a hinge."""
    name, moment = path.owner, laws.moment
    joint = moment.held.main(name)
    if joint is not None and joint.turning:
        return of_hinge(laws, path, told=True)
    free = joint is not None and joint.free and laws.fixed(name) and left_alone(laws, name)
    axis = moment.held.axis(name)
    if not (
        free
        and goes_on_steadily(laws, name)
        and axis is not None
        and moment.nods(name)
        and moment.held.turns_round(name, axis)
    ):
        message = f"what a small disturbance does to `{name}` at `{moment.when}` is not solved in space"
        raise NotYet(message, path.span, SOLVED)
    return of_upright(laws, name) if stands_upright(laws, name) else of_precession(laws, name)


def stands_upright(laws: SpaceLaws, name: str) -> bool:
    """Whether the axis of a body that nods stands upright, or hangs."""
    return laws.moment.nods(name) and laws.moment.nodding(name).angles[1] in (ZERO, PI)


def top_of(laws: SpaceLaws, name: str) -> tuple[Formula, Formula, Formula]:
    """I₃ and I₁ of a top about the point held, and M g l; l is the height of the centre of mass along its axis."""
    tensor = laws.tensor(name, laws.about(name)[1])
    height = laws.moment.arm(PointRef(name, CM))[2]
    weight = multiply(laws.moment.held.mass(name), laws.pushes.gravity or ZERO)
    return tensor.zz, tensor.xx, multiply(weight, height)


def of_precession(laws: SpaceLaws, name: str) -> Meaning:
    """λ² = −(I₃ ω₃/I₁ − 2 φ̇ cos θ)² − φ̇² sin² θ; where the spin is fast φ̇ is nothing beside it."""
    axial, across, _ = top_of(laws, name)
    turning, tilt = laws.moment.nodding(name), heading(laws.moment.nodding(name).angles[1])
    rate, fast = turning.rates[0], multiply(axial, laws.moment.attitude(name).omega[2]) / across
    words = f"{SMALL} about the steady precession, δθ̈ = λ² δθ"
    if laws.fast:
        laws.fast_nutation = True
        return Meaning(
            negate(square(fast)),
            QUANTITIES["stability"].dimension,
            label=f"{words}; the spin is fast: λ² = −(I₃ ω₃/I₁)²",
            law=SMALL_NUTATION,
        )
    along = add(fast, negate(multiply(2 * rate, tilt.cos())))
    back = add(square(along), multiply(square(rate), square(tilt.sin())))
    label = f"{words}, λ² = −(I₃ ω₃/I₁ − 2 φ̇ cos θ)² − φ̇² sin² θ"
    return Meaning(negate(back), QUANTITIES["stability"].dimension, label=label, law=SMALL_NUTATION)


def of_upright(laws: SpaceLaws, name: str) -> Meaning:
    """λ² = ± M g l/I₁ − (I₃ ω₃/(2 I₁))², the lower sign of a top whose axis is upside down."""
    axial, across, lift = top_of(laws, name)
    if laws.moment.told(name, "spin") is not None and not laws.moment.rests(name):
        message = f"`{name}` is upright at `{laws.moment.when}`: its spin and its precession are one rotation there"
        raise NotYet(message, help=f"tell its `{name}.axial_rate`")
    turned = multiply(lift, heading(laws.moment.nodding(name).angles[1]).cos())
    slow = multiply(axial, laws.moment.attitude(name).omega[2]) / (2 * across)
    words = f"{SMALL} through the vertical, in a plane that turns at I₃ ω₃/(2 I₁): θ̈ = λ² θ"
    back = add(square(slow), negate(turned / across))
    return Meaning(negate(back), QUANTITIES["stability"].dimension, label=words, law=SMALL_NUTATION)


def of_hinge(laws: SpaceLaws, path: Path, *, told: bool) -> Meaning:
    """λ² = −M g (ẑ · n × (n × r))/I of what hangs on a hinge at rest, as it stands; −M g |n × ẑ| |n × r|/I about the equilibrium, where
    nothing has `told` how it stands."""
    name, moment, joint = path.owner, laws.moment, laws.moment.held.main(path.owner)
    if joint is None or not joint.turning:
        help = f"tell a state with `{name}.tilt` and `{name}.spin`, `steady: true`; {SOLVED}"
        raise NotYet(f"about which steady motion `{name}` swings nothing tells", path.span, help)
    dimension = QUANTITIES["stability"].dimension
    if not left_alone(laws, name):
        from rotsolve.space.carried_swings import of_carried

        return of_carried(laws, path)
    if moment.held.wheel(name):
        return Meaning(ZERO, dimension, label="its weight acts at its axle")
    way, arm = moment.direction(name, joint), moment.held.arm(PointRef(name, CM))
    inertia = moment_along(laws.own_tensor(joint.body), way)
    weight = multiply(moment.held.mass(name), laws.pushes.gravity or ZERO)
    if not told:
        lean = length_of(cross_product(way, rotated(transposed(moment.turned(name)), Z)))
        torque = multiply(multiply(weight, lean), length_of(cross_product(way, arm)))
        label = f"{SMALL} about the axis, I δφ̈ = −M g |n × ẑ| |n × r| δφ"
        return Meaning(negate(torque / inertia), dimension, label=label, law=SMALL_DISTURBANCE)
    up, beside = moment.up(name), cross_product(way, arm)
    rate = moment.told(name, "angular_velocity")
    pushed = laws.tensors.spelled(dot_product(up, beside))
    if not (moment.found_in_balance(pushed) or moment.held.vanishes(pushed)) or not (
        rate is None or moment.held.vanishes(rate)
    ):
        raise NotYet(
            f"`{name}` is not in equilibrium at `{moment.when}`",
            path.span,
            "leave out the state: its equilibrium is found",
        )
    torque = negate(multiply(weight, dot_product(up, cross_product(way, beside))))
    label = f"{SMALL} about the axis, I δφ̈ = −M g (ẑ · n × (n × r)) δφ"
    return Meaning(torque / inertia, dimension, label=label, law=SMALL_DISTURBANCE)
