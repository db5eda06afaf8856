"""Mistakes with moments of inertia: left out, that of another shape, moved to no other axis, without that about the own centre."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator
from fractions import Fraction
from functools import reduce
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import ZERO, Formula, Number, Product, Sum, multiply, total
from rotsolve.core.equation import ABOUT_CONTACT, ENERGY, Equation
from rotsolve.core.facts import BodyFacts, Facts, Inertia
from rotsolve.core.passage import Alteration
from rotsolve.core.vectors.heading import Vector
from rotsolve.elements.shapes import shape_of
from rotsolve.grading.mistakes.mistake import Change, Made, bodies_and_parts, each_and_all, of_bodies
from rotsolve.language.problem import Body, Problem
from rotsolve.laws.groups import one_contact
from rotsolve.motion.rigid import RigidPiece, tidy

if TYPE_CHECKING:
    from rotsolve.grading.mistakes.scene import Scene

NONE = Inertia(ZERO, ZERO, "")
ROUND = (  # what the moment of inertia about the axis is of m R²
    (Fraction(1, 2), "½ m R², that of a solid disc or cylinder"),
    (Fraction(1), "m R², that of a ring"),
    (Fraction(2, 5), "⅖ m R², that of a solid sphere"),
    (Fraction(2, 3), "⅔ m R², that of a spherical shell"),
)
LONG = (  # of m L²
    (Fraction(1, 3), "⅓ m L², that of a rod about its end"),
    (Fraction(1, 12), "m L²/12, that of a rod about its centre"),
)
ASKED = ("inertia", "gyration", "inertia_tensor")  # questions whose steps move a moment of inertia to another axis


def has_inertia(body: BodyFacts) -> bool:
    return body.inertia is not None and body.inertia.letter != ZERO


def turning_bodies(scene: Scene) -> Iterator[BodyFacts]:
    """The bodies that turn, and are never joined to another, so that their moment of inertia is theirs alone."""
    states = [state.name for state in scene.configuration.timeline.states]
    joined = {
        name
        for state in states
        for seat in scene.configuration.seats(state).values()
        for name in (seat.name, seat.host)
    }
    return (body for body in scene.bodies.values() if has_inertia(body) and body.name not in joined)


def without_inertia(body: BodyFacts, facts: Facts) -> BodyFacts:
    """The body as if it took no torque to turn it."""
    return replace(body, inertia=NONE)


def is_pulley(body: BodyFacts) -> bool:
    """Whether a body turns about an axle through its centre of mass, or a string runs over it while it travels."""
    if body.motion.kind == "axis":
        return not body.cm.parts
    strings = [force.owner for force in body.forces if force.role.pulls]
    return len(set(strings)) < len(strings)


def pulleys(scene: Scene) -> Made:
    """I = 0 of a wheel or pulley."""
    for names, who in each_and_all(body.name for body in turning_bodies(scene) if is_pulley(body)):
        yield f"the moment of inertia of {who} was left out", Change(altered=of_bodies(names, without_inertia))


def rolling_bodies(scene: Scene) -> Iterator[BodyFacts]:
    """The bodies that travel and turn, and are no pulleys."""
    return (body for body in turning_bodies(scene) if body.motion.kind != "axis" and not is_pulley(body))


def rotational_energy(scene: Scene) -> Made:
    """½ I ω² = 0 of what travels and turns."""
    for names, who in each_and_all(body.name for body in rolling_bodies(scene)):
        yield f"the rotation of {who} was left out", Change(altered=of_bodies(names, without_inertia))


# the axis


def hinged_bodies(scene: Scene) -> Iterator[str]:
    """The bodies that turn about an axis which is not that through their centre of mass."""
    turning = (body for body in scene.bodies.values() if body.motion.kind == "axis" and has_inertia(body))
    return (body.name for body in turning if body.cm.parts)


def parallel_axes(scene: Scene) -> Made:
    """I_cm for I_cm + m d²: of a hinged body in the laws, of any in the steps of a question for it."""
    for names, who in each_and_all(hinged_bodies(scene)):
        about = of_bodies(names, with_axis_inertia(scene, lambda own, moved: own if own != ZERO else moved))
        words = f"the moment of inertia of {who} about the centre of mass was taken for that about the axis"
        yield words, Change(altered=replace(about, equation=without_steiner_term))
    for names, who in each_and_all(body.name for body in rolling_bodies(scene) if one_contact(body) is not None):
        words = f"the moment of inertia of {who} about the centre of mass was taken for that about the point of contact"
        altered = Alteration(equation=by_central_inertia(names, scene))
        yield words, Change(altered=altered, aside=(ENERGY,), about_contact=True)
    if any(term.path.quantity in ASKED for find in scene.problem.finds for term in find.terms):
        yield "the parallel-axes theorem was left out", Change(altered=Alteration(equation=without_steiner_term))


def by_central_inertia(names: Collection[str], scene: Scene) -> Callable[[Equation], Equation]:
    """I α for (I + m d²) α in the laws of bodies about their points of contact."""

    def changed(equation: Equation) -> Equation:
        if equation.law != ABOUT_CONTACT or equation.bodies[0] not in names:
            return equation
        inertia = scene.bodies[equation.bodies[0]].inertia
        letter = ZERO if inertia is None else inertia.letter
        factors = equation.right.factors if isinstance(equation.right, Product) else ()
        put = [letter if isinstance(factor, Sum) and factor.terms[0] == letter else factor for factor in factors]
        return replace(equation, right=reduce(multiply, put)) if put else equation

    return changed


def point_masses(scene: Scene) -> Made:
    """m d² for I_cm + m d², piece by piece."""
    for names, who in each_and_all(hinged_bodies(scene)):
        words = f"{who} was taken as a point mass at its centre of mass"
        yield words, Change(altered=of_bodies(names, with_axis_inertia(scene, lambda own, moved: moved)))


def twice_moving(scene: Scene) -> Made:
    """I + m d² for I: the energy of the centre of mass added to that about the axis, which holds it already."""
    for names, who in each_and_all(hinged_bodies(scene)):
        words = f"the motion of the centre of mass of {who} was counted twice"
        yield words, Change(altered=of_bodies(names, counted_twice))


def counted_twice(body: BodyFacts, facts: Facts) -> BodyFacts:
    """The body with m d² of its centre of mass added to its moment of inertia about the axis."""
    if body.inertia is None:
        return body
    formula = simplify(body.inertia.formula + body.mass * body.cm.dot(body.cm))
    return replace(body, inertia=Inertia(formula, formula, ""))


def with_axis_inertia(
    scene: Scene, share: Callable[[Formula, Formula], Formula]
) -> Callable[[BodyFacts, Facts], BodyFacts]:
    """The body with a moment of inertia that each piece adds to in its own way, by its own moment and its m d²."""

    def changed(body: BodyFacts, facts: Facts) -> BodyFacts:
        if not has_inertia(body):
            return body
        frame = scene.equations.instant(facts.state).frame(body.name)
        terms = [share(piece.moment, moved(piece, frame.reference)) for piece in frame.pieces]
        formula = simplify(total(terms), order=scene.configuration.order)
        return replace(body, inertia=Inertia(formula, formula, ""))

    def moved(piece: RigidPiece, reference: Vector) -> Formula:
        arm = tidy(piece.at - reference)
        return simplify(piece.mass * arm.dot(arm)) if arm.parts else ZERO

    return changed


def without_steiner_term(equation: Equation) -> Equation:
    """A step by the parallel-axes theorem without its m d², which stands last."""
    if not equation.law.shifts or not isinstance(equation.right, Sum):
        return equation
    return replace(equation, right=total(equation.right.terms[:-1]))


# the shape


def shape_factors(scene: Scene) -> Made:
    """Another factor of the table, m R² for ½ m R², and for an annulus ½ m (R² − r²)."""
    bodies = list(bodies_and_parts(scene.problem.bodies))
    right = {body.name: body.inertia.formula for body in scene.bodies.values() if body.inertia is not None}
    for among, size in ((ROUND, round_radius), (LONG, rod_length)):
        for factor, noun in among:
            wrong = with_factor(factor, size)
            sized = (body for body in bodies if size(body) is not None)
            fitting = (body.name for body in sized if not is_its_inertia(wrong(body), body, right.get(body.name, ZERO)))
            for names, who in each_and_all(fitting):
                yield f"the moment of inertia of {who} was taken as {noun}", Change(problem=with_inertia(names, wrong))
    for names, who in each_and_all(body.name for body in bodies if shape_of(body).walled):
        words = f"in the moment of inertia of {who} the square of the inner radius was taken away instead of added"
        yield words, Change(problem=with_inertia(names, with_difference))


def is_its_inertia(formula: Formula, body: Body, about_its_axis: Formula) -> bool:
    """Whether a formula is the moment of inertia of a body, about its centre of mass or about its axis."""
    return any(is_zero(formula - right) for right in (shape_of(body).moment(body.mass or ZERO), about_its_axis))


def round_radius(body: Body) -> Formula | None:
    """The radius of a round shape that has a factor in the table."""
    return shape_of(body).outer if tells_inertia(body) else None


def rod_length(body: Body) -> Formula | None:
    return shape_of(body).reach() if tells_inertia(body) else None


def tells_inertia(body: Body) -> bool:
    """Whether the moment of inertia of a body comes from its shape alone."""
    return body.mass is not None and body.inertia is None and body.gyration is None and not body.holes


def with_factor(factor: Fraction, size: Callable[[Body], Formula | None]) -> Callable[[Body], Formula]:
    """m R² times a factor."""
    return lambda body: Number(factor) * (body.mass or ZERO) * (size(body) or ZERO) ** 2


def with_difference(body: Body) -> Formula:
    """½ m (R² − r²) of an annulus."""
    sizes: dict[str, Formula] = dict(getattr(body.shape, "radii", ()))
    return (body.mass or ZERO) * (sizes["outer"] ** 2 - sizes["inner"] ** 2) / 2


def with_inertia(names: tuple[str, ...], wrong: Callable[[Body], Formula]) -> Callable[[Problem], Problem]:
    """The scene with given moments of inertia of some bodies about their centres of mass."""

    def changed(body: Body) -> Body:
        parts = tuple(replace(part, body=changed(part.body)) for part in body.parts)
        return replace(body, parts=parts, **({"inertia": wrong(body)} if body.name in names else {}))

    return lambda problem: replace(problem, bodies=tuple(changed(body) for body in problem.bodies))
