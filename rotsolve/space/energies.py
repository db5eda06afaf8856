"""Energies in space: K = ½ ω · I ω about a point at rest, else about the centre of mass with ½ M v²; the height of that,
and the power of what acts on a body."""

from __future__ import annotations

from rotsolve.algebra.formula import HALF, ZERO, Formula, add, multiply
from rotsolve.core.vectors.tensor import InertiaTensor
from rotsolve.core.vectors.triple import NOTHING, Triple, cross_product, dot_product, square, square_of, vector_sum
from rotsolve.core.writing import point_in_words
from rotsolve.language.bodies import PointRef
from rotsolve.paths.meaning import NotYet
from rotsolve.space.inertia import CM
from rotsolve.space.laws import SpaceLaws
from rotsolve.space.moment import SpaceMoment
from rotsolve.space.pushes import ForceInSpace


def kinetic_energies(laws: SpaceLaws, name: str, which: str = "") -> tuple[Formula, Formula]:
    """The energy of rotation and of travel of a body; about a point at rest all is rotation."""
    moment, held = laws.moment, laws.moment.held
    fixed = laws.fixed(name) and not held.pointlike(name)
    point = laws.about(name)[1] if fixed else CM
    velocity, _ = moment.of_mass(name, "velocity")
    travel = ZERO if fixed or which == "rotational" else multiply(HALF * held.mass(name), square_of(velocity))
    if which == "translational" or held.pointlike(name):
        return ZERO, travel
    if moment.keeps_momentum(name):  # and with it the energy of rotation
        assert moment.onward is not None
        return kinetic_energies(moment.onward.before, name, "rotational")[0], travel
    return half_quadratic(laws.tensor(name, point), moment.attitude(name).omega), travel


def energy_in_words(laws: SpaceLaws, name: str, terms: tuple[Formula, Formula], height: Formula = ZERO) -> str:
    """The terms that an energy has, behind the point at rest about which all of it is rotation: " about its tip, ½ ω · I ω"."""
    turning, travelling = terms
    told = {"½ ω · I ω": turning, "½ M v²": travelling, "M g h": height}
    said = " + ".join(words for words, value in told.items() if value != ZERO)
    about = laws.about(name)[0] != laws.moment.arm(PointRef(name, CM)) if name and turning != ZERO else False
    where = f" about {point_in_words(laws.about(name)[1])}" if about and laws.fixed(name) and height == ZERO else ""
    return f"{where}, {said}" if said else where


def power_of(push: ForceInSpace, moment: SpaceMoment) -> Formula:
    """F · v of the point at which it acts, and C · ω."""
    omega = moment.attitude(push.body).omega
    velocity = vector_sum(moment.reference_velocity(push.body), cross_product(omega, push.arm))
    couple = push.axes.to(push.own, push.couple)
    return add(dot_product(push.along(push.own), velocity), dot_product(couple, omega))


def height_above(laws: SpaceLaws, name: str) -> Formula:
    """Of the centre of mass in space, as joints and the state tell it: above the point at which a joint holds it, where no place of that is
    told."""
    moment, frame = laws.moment, laws.moment.held.problem.gravity_in
    if frame:
        message = f"weight that turns with `{frame}` has no potential energy of the place alone"
        raise NotYet(message, help="ask for its `kinetic_energy`")
    if not laws.fixed(name):
        from rotsolve.space.places import point_from_start

        return moment.tidy(point_from_start(moment, PointRef(name, CM))[2])
    joint, arm = moment.held.main(name), moment.arm(PointRef(name, CM))
    base = joint.carrier.place[2] if joint is not None and joint.carrier.place is not None else ZERO
    return base if arm == NOTHING else moment.tidy(add(base, dot_product(moment.up(name), arm)))


def energy_of(laws: SpaceLaws, name: str, which: str = "") -> Formula:
    """Kinetic energy and M g h."""
    turning, travelling = kinetic_energies(laws, name, which)
    gravity = laws.pushes.gravity
    weight = ZERO if gravity is None else multiply(laws.moment.held.mass(name), gravity)
    return add(add(turning, travelling), ZERO if weight == ZERO else multiply(weight, height_above(laws, name)))


def half_quadratic(tensor: InertiaTensor, omega: Triple) -> Formula:
    """½ Σ I_ij ω_i ω_j, the squares drawn together."""
    x, y, z = omega
    result: Formula = ZERO
    for entry, part in ((tensor.xx, x), (tensor.yy, y), (tensor.zz, z)):
        result = add(result, multiply(multiply(HALF, entry), square(part)))
    for entry, one, other in ((tensor.xy, x, y), (tensor.yz, y, z), (tensor.zx, z, x)):
        result = add(result, multiply(entry, multiply(one, other)))
    return result
