"""Stability of steady motions: what a small disturbance does, from the equations of motion made linear in it.

Free body about its own axis k: Euler's equations for the two other components, I_i ω̇_i = (I_j − I_k) ω_j ω and
I_j ω̇_j = (I_k − I_i) ω ω_i, give λ² = (I_j − I_k)(I_k − I_i) ω²/(I_i I_j) (Landau & Lifshitz, Mechanics, §37).
Upright top: p_φ = p_ψ = I₃ ω₃, and U(θ) = (I₃ ω₃)² tan²(θ/2)/(2 I₁) + M g l cos θ = M g l + ½ ((I₃ ω₃)²/(4 I₁) − M g l) θ² + …
is least at θ = 0 while (I₃ ω₃)² ≥ 4 I₁ M g l (Landau & Lifshitz, Mechanics, §35, problem 2; Kibble & Berkshire, Classical Mechanics,
eqs. 12.24 to 12.26).
"""

from __future__ import annotations

from rotsolve.algebra.formula import ONE, ZERO, Formula, Symbol, add, multiply, negate
from rotsolve.core.derivation import NEXT, Words
from rotsolve.core.equation import SMALL_DISTURBANCE, STABILITY, STEADY_LIMIT, Equation
from rotsolve.core.facts import square
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.vectors.heading import heading
from rotsolve.core.vectors.tensor import AXES
from rotsolve.language.bodies import Joint, PointRef
from rotsolve.language.problem import Path
from rotsolve.paths.meaning import Meaning, NotYet, path_text
from rotsolve.space.attitude import NODE
from rotsolve.space.free import own_axis_of, principal_letters
from rotsolve.space.inertia import CM, entry_along
from rotsolve.space.laws import SpaceLaws
from rotsolve.space.rolling import rolling_radius, shape_that_rolls

FLAT = "small tilts, p_φ = p_ψ = I₃ ω₃: U(θ) = U(0) + ½ ((I₃ ω₃)²/(4 I₁) − M g l) θ² has its least value at θ = 0 no longer"
TURNS_ASIDE = (
    "a change η of the tilt θ, η ∝ exp(λ t): p = φ̇ sin θ, q = φ̇ cos θ, I₁ δp = (I₃ ω₃ − I₁ q) η, (I₃ + M R²) δω₃ = M R² p η, "
    "(I₁ + M R²) θ̈ = I₁ p q − (I₃ + M R²) p ω₃ − M g R cos θ"
)
HANGS = "its centre of mass lies below the point that is held"


def growth(laws: SpaceLaws, path: Path) -> Meaning:
    """λ² of a free body that turns about one of its principal axes; of one that rolls or is held that of its own steady motion."""
    name, held = path.owner, laws.moment.held
    own = laws.moment.attitude(name)
    if laws.moment.nods(name) and any(joint.carrier.owner == name for joint in held.joints):
        from rotsolve.space.carried_swings import of_carried

        return of_carried(laws, path)
    if not laws.moment.hangs_on_hinge(name):
        refuse_pushed(laws, name)
    if rolls_round(laws, name):
        return of_rolling(laws, name)
    if held.of_body(name):
        from rotsolve.space.swings import of_held

        return of_held(laws, path)
    axis = own_axis_of(own.omega)
    if not axis:
        raise NotYet(
            f"`{path_text(path)}` is solved for a free body that turns about one of its own axes",
            path.span,
            "tell its angular velocity along one axis: `[w, 0, 0]`",
        )
    moments = principal_letters(laws, name)
    k = AXES.index(axis)
    i, j = (k + 1) % 3, (k + 2) % 3
    above = multiply(add(moments[j], negate(moments[k])), add(moments[k], negate(moments[i])))
    formula = multiply(square(own.omega[k]), above / multiply(moments[i], moments[j]))
    a, b = AXES[i], AXES[j]
    words = f"small disturbance, ω_{a}, ω_{b} ∝ exp(λ t): "
    words += f"I_{a} λ ω_{a} = (I_{b} − I_{axis}) ω ω_{b}, I_{b} λ ω_{b} = (I_{axis} − I_{a}) ω ω_{a}"
    return Meaning(formula, QUANTITIES["stability"].dimension, label=words, law=SMALL_DISTURBANCE)


def refuse_pushed(laws: SpaceLaws, name: str) -> None:
    """Refuse what a small disturbance does to a body on which more acts than its weight, or which carries another one."""
    held = laws.moment.held
    pushing = [action.name for action in laws.pushes.actions if any(ref.owner == name for ref in action.touches())]
    carrying = [joint.owner for joint in held.joints if joint.carrier.owner == name]
    for other in (*pushing, *carrying):
        message = f"what a small disturbance does to `{name}` is not solved: `{other}` acts on it beside its weight"
        raise NotYet(message, laws.moment.state.span)


def rolls_round(dynamics: SpaceLaws, name: str) -> bool:
    """Whether a wheel rolls, as it leans by its Euler angles."""
    moment = dynamics.moment
    return moment.nods(name) and any(joint.rolls for joint in moment.held.of_body(name))


def of_rolling(dynamics: SpaceLaws, name: str) -> Meaning:
    """λ² of a small disturbance η of the tilt θ of a thin wheel that rolls steadily, straight on or round a circle.

    With p = φ̇ sin θ, about the axis (I₃ + M R²) ω̇₃ = M R² p θ̇, about e₂ I₁ ṗ = (I₃ ω₃ − I₁ p cot θ) θ̇, and about the level line e₁
    through the point of contact (I₁ + M R²) θ̈ = I₁ p² cot θ − (I₃ + M R²) p ω₃ − M g R cos θ, of which the first two tell δω₃ and δp by η
    (Routh, Advanced Rigid Dynamics, §§241–244).
    """
    moment, held = dynamics.moment, dynamics.moment.held
    joint = next(joint for joint in held.of_body(name) if joint.rolls)
    refuse_rolling_otherwise(dynamics, joint)
    own, tensor = moment.attitude(name), dynamics.tensor(name, CM)
    assert own.about is not None
    axial, across = entry_along(tensor, own.about), entry_along(tensor, (own.about[1], own.about[2], own.about[0]))
    mass, radius = held.mass(name), rolling_radius(joint, moment)
    shift = multiply(mass, square(radius))
    weight = multiply(multiply(mass, dynamics.pushes.gravity or ZERO), radius)
    tilt, (_, around, spin) = heading(moment.nodding(name).angles[1]), own.omega
    both = add(axial, shift)
    righting = multiply(multiply(axial, both), square(spin)) / across
    if tilt.cos() == ZERO and around == ZERO:
        words = "a lean η ∝ exp(λ t): I₁ φ̇ = I₃ ω₃ η, (I₁ + M R²) η̈ = M g R η − (I₃ + M R²) ω₃ φ̇"
    elif tilt.cos() == ZERO and held.vanishes(spin):
        righting = multiply(add(across, shift), square(around))
        words = "a lean η ∝ exp(λ t): (I₃ + M R²) δω₃ = M R² φ̇ η, (I₁ + M R²) η̈ = M g R η − I₁ φ̇² η − (I₃ + M R²) φ̇ δω₃"
    else:
        rate = moment.nodding(name).rates[0]
        slope = multiply(rate, tilt.cos())
        crossing = multiply(multiply(add(both, 2 * axial), spin), slope)
        turning = add(multiply(across, add(square(rate), 2 * square(slope))), multiply(shift, square(around)))
        righting, weight = add(add(righting, negate(crossing)), turning), multiply(weight, tilt.sin())
        words = TURNS_ASIDE
    formula = add(weight, negate(righting)) / add(across, shift)
    label = f"small disturbance, {words}"
    return Meaning(formula, QUANTITIES["stability"].dimension, label=label, law=SMALL_DISTURBANCE)


def refuse_rolling_otherwise(dynamics: SpaceLaws, joint: Joint) -> None:
    """Refuse a wheel of which a small disturbance is another one: on a body, held besides, its mass off the middle of its rim."""
    moment, name = dynamics.moment, joint.body.owner
    refused, rims = "", dict(moment.held.bodies[name].radii)  # those of a stepped wheel go round its middle
    if joint.carrier.owner in moment.held.bodies:
        refused = f"it rolls on `{joint.carrier.owner}`"
    elif moment.held.rolling(name) is None:
        refused = "it is held besides"
    elif not shape_that_rolls(joint, moment).flat:
        refused = "it is no thin wheel"
    elif moment.axes(name).name != NODE or moment.rim_side(name) != ONE:
        refused = "it is not the same all round its axis, or leans beyond 180°"
    elif joint.body.point not in rims and not all(map(moment.held.vanishes, moment.arm(joint.body))):
        refused = "its centre of mass is not in the middle of its rim"
    elif not moment.state.steady:
        refused = "its state is not said to be `steady: true`"
    if refused:
        raise NotYet(f"what a small disturbance does to `{name}` is not solved: {refused}", moment.state.span)


def limit_of(dynamics: SpaceLaws, name: str) -> Equation:
    """Where the motion of a body at a state is just stable: an upright top, on the point at which it begins to sway; a rolling wheel."""
    moment, held = dynamics.moment, dynamics.moment.held
    if moment.hangs_on_hinge(name):
        from rotsolve.space.carried_swings import limit_on_hinge

        return limit_on_hinge(dynamics, name, moment.state.span)
    refuse_pushed(dynamics, name)
    if rolls_round(dynamics, name):
        if moment.axes(name).rows[2][2] != ZERO:
            message = f"up to where `{name}`, which leans, is stable at `{moment.when}` is not solved: it may be so between several limits"
            raise NotYet(message, moment.state.span, f"ask for `{name}.stability`, λ² of a small disturbance")
        lean = of_rolling(dynamics, name)
        return STABILITY.equation(ZERO, lean.formula, moment.when, (name,), (f"{lean.label}; λ² = 0",))
    own = moment.attitude(name)
    if not (
        dynamics.fixed(name) and own.about is not None and moment.nods(name) and moment.nodding(name).angles[1] == ZERO
    ):
        raise NotYet(
            f"the stability of `{name}` at `{moment.when}` is not solved yet",
            None,
            "solved are an upright top (`tilt: 0 deg`) on a fixed point, and `stability` of a free body about its own axes",
        )
    _, point = dynamics.about(name)
    tensor = dynamics.tensor(name, point)
    axial, across = entry_along(tensor, own.about), entry_along(tensor, (own.about[1], own.about[2], own.about[0]))
    gravity, mass = dynamics.pushes.gravity or ZERO, held.mass(name)
    height = moment.arm(PointRef(name, CM))[2]
    lift = multiply(multiply(mass, gravity), height)
    momentum = square(multiply(axial, own.omega[2]))
    if moment.signs.decide(dynamics.tensors.spelled(lift)) == -1:
        raise NotYet(f"`{name}` is stable at `{moment.when}` however it spins: no spin is the least", help=HANGS)
    return STABILITY.equation(momentum, 4 * multiply(across, lift), moment.when, (name,), (FLAT,))


def steady_limit(dynamics: SpaceLaws, name: str) -> Equation:
    """Where a steady precession is just possible: the roots of I₁ cos θ Ω² − I₃ ω₃ Ω + M g l = 0 coincide."""
    from rotsolve.algebra.exact.normal import coefficients
    from rotsolve.core.equation import ANGULAR_MOMENTUM_IN_SPACE, RATES_OF_MOMENTUM

    rate = dynamics.moment.ask("precession", name)
    laws = list(dynamics.equations())
    spelled = {
        law.left.name: law.right
        for law in laws
        if law.law == ANGULAR_MOMENTUM_IN_SPACE and isinstance(law.left, Symbol)
    }
    for law in laws:
        gap: Formula = (law.left - law.right).substitute(spelled)
        if law.law not in RATES_OF_MOMENTUM or not isinstance(rate, Symbol) or rate.name not in gap.symbols():
            continue
        found = coefficients(gap, rate.name)
        if found is not None and len(found) == 3:
            c, b, a = found
            if dynamics.moment.signs.decide(dynamics.tensors.spelled(multiply(a, c))) == -1:
                message = f"`{name}` has a steady precession at `{dynamics.moment.when}` however it spins: no spin is the least"
                raise NotYet(message, help=HANGS)
            own, other = square(b), 4 * multiply(a, c)
            right = law.right.substitute(spelled)
            ground: Words = (f"{law.label}: ", law.left.substitute(spelled), " = ", right)
            ground += (NEXT, *law.remark, NEXT) if law.remark else (NEXT,)
            ground += ("for ", rate, " this is quadratic, with real roots while ", own, " ≥ ", other)
            return STEADY_LIMIT.equation(own, other, dynamics.moment.when, (name,), ground)
    raise NotYet(f"`{name}` has no steady precession with two roots at `{dynamics.moment.when}`")
