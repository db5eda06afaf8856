"""Newton's laws at one moment: Σ F = m a and Σ τ = I α of every body, and of every piece that is cut free; what defines I."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import ZERO, Formula, Integral, Sum, Symbol, add, multiply, negate, sqrt, total
from rotsolve.core.derivation import Words, in_a_row
from rotsolve.core.equation import CARRIED, CUT_TORQUES, FACE_FRICTION, INERTIA, ROTATION, SECOND_LAW, TORQUES, Equation
from rotsolve.core.facts import BodyFacts, Cut, Force, Inertia, Role, signed, square
from rotsolve.core.vectors.heading import Heading, Vector
from rotsolve.core.writing import flat, is_negative, law, multiplied_out, positive_first, spoken
from rotsolve.laws.table import AtMoment
from rotsolve.motion.rigid import tidy


def second_law(at: AtMoment) -> Iterator[Equation]:
    """Σ F = m a of the centre of mass, component by component; equilibrium where it does not accelerate."""
    for body in at.facts.bodies:
        for axis in body.axes if not body.changing else ():  # what moves within it has an acceleration of its own
            equation = component_equation(body, axis, at.section)
            if equation is not None:
                yield equation


def frictions_of_faces(at: AtMoment) -> Iterator[Equation]:
    """τ = ∫ μ r dN of what rubs over a whole face."""
    for item in at.facts.sums:
        yield FACE_FRICTION.equation(
            item.letter, item.integral, at.section, item.bodies, item.words, defines="", words=item.label
        )


def frictions_summed_up(at: AtMoment) -> Iterator[Equation]:
    """The same with its integral carried out, where nobody reads it."""
    for equation in frictions_of_faces(at):
        if equation.right.holds(Integral):
            from rotsolve.algebra.calculus.integral import carried_out

            equation = replace(equation, right=carried_out(equation.right, equation.right.symbols()))
        yield equation


def component_equation(body: BodyFacts, axis: Heading, section: str) -> Equation | None:
    """The component along one axis; None where nothing acts along it."""
    if body.motion.kind == "line" and axis != body.motion.heading and not body.supported:
        return None  # whatever holds it on its line takes what acts across
    forces = [force.vector.along(axis) for force in from_outside(body)]
    acceleration = body.centre_acceleration.along(axis)
    response = multiply(body.mass, acceleration) if body.mass != ZERO else ZERO
    if isinstance(body.mass, Sum):
        response = simplify(response)  # of joined bodies the common mass cancels in the place of the centre of mass
    if all(force == ZERO for force in forces) and response == ZERO:
        return None
    left, right = law(forces, response)
    remark = centre_words(body, acceleration)
    return SECOND_LAW.equation(left, right, section, (body.name,), remark, component=axis_words(body, axis))


def centre_words(body: BodyFacts, acceleration: Formula) -> Words:
    """The acceleration of the centre of mass along an axis, of a body that turns about another point."""
    if body.motion.kind != "axis" or isinstance(acceleration, Symbol) or not acceleration.symbols():
        return ()
    return ("centre of mass: ", acceleration)


def from_outside(body: BodyFacts) -> Sequence[Force]:
    """The forces on a body without those by which parts of it that are joined press and rub on each other."""
    between: dict[tuple[str, Role], list[Force]] = {}
    for force in body.forces if body.footings else ():
        between.setdefault((force.owner, force.role), []).append(force)
    inner = [pair for pair in between.values() if len(pair) == 2 and not tidy(pair[0].vector + pair[1].vector).parts]
    return [force for force in body.forces if not any(force in pair for pair in inner)] if inner else body.forces


def carried_apart(at: AtMoment) -> Iterator[Equation]:
    """Σ F = 0 across the way of each of several joined bodies that lie on surfaces of their own, with all that it bears."""
    for body in at.facts.bodies:
        for group in body.footings if not body.changing else ():
            axis = next(axis for axis in body.axes if axis != body.motion.heading)
            forces = [force.vector.along(axis) for force in body.forces if force.part in group]
            left, right = law(forces, ZERO)
            if (left, right) != (ZERO, ZERO):
                whole, component = " with ".join(map(spoken, group)), axis_words(body, axis)
                yield CARRIED.equation(left, right, at.section, group, whole=whole, component=component)


def axis_words(body: BodyFacts, axis: Heading) -> str:
    """Which component is meant, where the law has more than one."""
    if body.along:
        return f", {body.along[body.axes.index(axis)]}"
    if body.motion.bend is not None:
        return ", along the circle" if axis == body.motion.heading else ", towards the centre"
    names = {0: ", horizontally", 90: ", vertically"}
    upright = names.get(int(axis.degrees % 360), "") if not axis.terms else ""
    if body.motion.kind == "line" and not (upright and in_a_corner(body)):
        path = "slope" if body.slanted else "surface"
        if axis == body.motion.heading:
            across = [force for force in body.forces if force.role.presses]
            return f", along the {path}" if across else ""
        return f", across the {path}"
    return upright


def in_a_corner(body: BodyFacts) -> bool:
    """Whether a body touches surfaces that face different ways, so that no one of them is the surface."""
    normals = [force.vector for force in body.forces if force.role.presses]
    return any(not is_zero(normals[0].cross(other)) for other in normals[1:])


def law_of_rotation(at: AtMoment) -> Iterator[Equation]:
    """Σ τ = I α about the reference point of every body that turns and keeps its moment of inertia."""
    for body in at.facts.bodies:
        if body.motion.turns and not body.changing:
            yield from rotation_of(body, at.section)


def where_things_slide(at: AtMoment) -> Iterator[Equation]:
    """Newton's laws of bodies along which something slides freely."""
    if any(body.sliding for body in at.facts.bodies):
        from rotsolve.laws.sliding import across_what_turns

        yield from across_what_turns(at)


def rotation_of(body: BodyFacts, section: str) -> Iterator[Equation]:
    """Σ τ = I α of one body."""
    left, right = law(torques(body), response(body))
    if (left, right) != (ZERO, ZERO):
        yield ROTATION.equation(left, right, section, (body.name,), carried(body), about=about(body))


def balance_of_torques(at: AtMoment) -> Iterator[Equation]:
    """Σ τ = 0 of a free body in equilibrium about each point where a contact acts: its force then has no arm."""
    for body in at.facts.bodies:
        rates = [size for size, _ in body.centre_acceleration.parts]
        if (
            body.motion.kind == "axis"
            or not body.motion.turns
            or any(rate != ZERO for rate in (*rates, body.motion.spin_rate))
        ):
            continue
        points = dict.fromkeys((force.arm, force.owner) for force in body.forces if force.internal)
        if len({arm for arm, _ in points}) < 2:
            continue
        for point, owner in points:
            pushes = [torque_about(point, force) for force in body.forces]
            left, right = law([*pushes, *(couple.torque for couple in body.couples)], ZERO)
            geometry = next(filter(None, (by_triangle(point, force) for force in body.forces)), ())
            where = f"its point of contact at {spoken(owner)}"
            remark = geometry or without_arm(
                [force for force, torque in zip(body.forces, pushes, strict=True) if torque == ZERO]
            )
            yield TORQUES.equation(left, right, at.section, (body.name,), remark, point=where)


def without_arm(forces: Sequence[Force]) -> Words:
    """Which forces have no arm about a point: "N and f have no arm there"."""
    letters = [force.size for force in forces if isinstance(force.size, Symbol)]
    if not letters or len(letters) < len(forces):
        return ()
    *first, last = letters
    return (
        *in_a_row(first),
        *((" and ",) if first else ()),
        last,
        " have no arm there" if first else " has no arm there",
    )


def by_triangle(point: Vector, force: Force) -> Words:
    """Where the root in a lever comes from: it is a side of a right-angled triangle, √(R² − (R − h)²)."""
    arm = tidy(force.arm - point)
    if len(arm.parts) != 1:
        return ()
    size = arm.parts[0][0]
    lever, side = (
        simplify(part, positive=size.symbols()) for part in (arm.cross(force.direction), arm.dot(force.direction))
    )
    lever = negate(lever) if is_negative(lever) else lever
    if any(is_negative(term) and term.symbols() & size.symbols() for term in flat([side])):
        side = simplify(negate(side))
    if not lever.holds("sqrt") or side.holds("sqrt") or side == ZERO:
        return ()
    return ("arm ", sqrt(size**2 - side**2), " = ", lever)


def torque_about(point: Vector, force: Force) -> Formula:
    """F times its lever about a point, counterclockwise positive; the sizes of arms are positive."""
    arm = tidy(force.arm - point)
    lengths = {name for size, _ in arm.parts for name in size.symbols()}
    lever = arm.cross(force.direction)
    if all(is_negative(term) for term in flat([lever])):
        return negate(force.size * multiplied_out(negate(lever), lengths))
    return force.size * multiplied_out(positive_first([lever]), lengths)


def torques(body: BodyFacts) -> list[Formula]:
    """Torques about the reference, positive along the body's declared turn; weights that balance about it turn nothing."""
    sense = body.motion.sense
    weights = [body.torque_of(force) for force in body.forces if force.role.weighs]
    balanced = len(weights) > 1 and is_zero(total(weights))
    arms = [signed(body.torque_of(force), sense) for force in body.forces if not (balanced and force.role.weighs)]
    return [torque for torque in (*arms, *(signed(couple.torque, sense) for couple in body.couples)) if torque != ZERO]


def response(body: BodyFacts) -> Formula:
    """I α along the declared turn; of a body that is carried round an upright axis also Ω² ∫ x y dm."""
    swept = ZERO if body.sweep is None else signed(body.sweep.moment, body.motion.sense)
    if body.inertia is None or body.inertia.letter == ZERO:
        return swept
    return add(body.inertia.letter * signed(body.motion.spin_rate, body.motion.sense), swept)


def carried(body: BodyFacts) -> Words:
    """Why Ω² ∫ x y dm stands in the law of a body on a turning shaft."""
    if body.sweep is None:
        return ()
    square_of_rate = square(body.sweep.rate)
    return (
        "every piece at x from the axis has the acceleration ",
        square_of_rate,
        " x towards it, together ",
        square_of_rate,
        " ∫ x y dm about the ",
        "hinge" if body.motion.kind == "axis" else "centre of mass",
    )


def about(body: BodyFacts) -> str:
    """About which point, where it is not plainly the axle of a wheel."""
    if body.motion.kind == "axis":
        return " about the pivot" if body.cm.parts else ""
    return " about the centre of mass"


def moments_of_inertia(at: AtMoment) -> Iterator[Equation]:
    """I = …, for every body whose moment of inertia is not given as such."""
    for body in at.facts.bodies:
        yield from inertia_defined(body.inertia, body.name, at.section)


COST = 4  # above the laws for the whole rod, so that what is found at a cut stands where its diagram is


def laws_of_pieces(at: AtMoment) -> Iterator[Equation]:
    """m and I of every piece, Σ F = m a along and across the rod, and Σ τ = I α."""
    for cut in at.facts.cuts:
        body = cut.body
        for item in (cut.mass, body.inertia):
            yield from inertia_defined(item, body.name, at.section)
        for axis in body.axes:
            equation = component_equation(body, axis, at.section)
            if equation is not None:
                yield replace(equation, cost=COST)
        turning = about_cut(cut, at.section) if still(cut) else rotation_of(body, at.section)
        yield from (replace(equation, cost=COST) for equation in turning)


def inertia_defined(item: Inertia | None, name: str, section: str) -> Iterator[Equation]:
    """I = … or m = …, where it is not given as such."""
    if item is not None and item.letter not in (ZERO, item.formula):
        remark, defines = item.remark, next(iter(item.letter.symbols()), "")
        yield INERTIA.equation(item.letter, item.formula, section, (name,), remark, defines=defines, words=item.label)


def still(cut: Cut) -> bool:
    """Whether the rod does not accelerate."""
    motion = cut.body.motion
    return motion.spin_rate == ZERO and not any(size != ZERO for size, _ in motion.acceleration.parts)


def about_cut(cut: Cut, section: str) -> Iterator[Equation]:
    """Στ = 0 of a rod in equilibrium, about the cut, where compression and shear have no arm."""
    body, sense = cut.body, cut.body.motion.sense
    away = [force for force in body.forces if force.arm != cut.at]
    torques: list[Formula] = [signed(torque_about(cut.at, force), sense) for force in away]
    torques += [signed(couple.torque, sense) for couple in body.couples]
    yield CUT_TORQUES.equation(*law(torques, ZERO), section, (body.name,))
