"""Mistakes with forces and accelerations: of a wrong sign, left out, without their radius, at another point, or of another size."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from itertools import combinations
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, ZERO, Formula, Power, Symbol, negate, total
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.equation import ANGULAR_MOMENTUM, ENERGY, ROTATION, SECOND_LAW, Equation, Law
from rotsolve.core.facts import FRICTION, TENSION, WEIGHT, BodyFacts, Couple, Facts, Force, Inertia, Role, Rule
from rotsolve.core.passage import Alteration
from rotsolve.core.symbols import of_kinds
from rotsolve.core.vectors.heading import Vector
from rotsolve.core.writing import and_joined, spoken
from rotsolve.elements.shapes import shape_of
from rotsolve.grading.mistakes.mistake import (
    Change,
    Made,
    both_sides,
    each,
    each_and_all,
    of_bodies,
    of_forces,
    of_owners,
)
from rotsolve.motion.rigid import direction_of

if TYPE_CHECKING:
    from rotsolve.grading.mistakes.scene import Scene


def pulled_bodies(scene: Scene, role: Role) -> Iterator[str]:
    """The bodies on which a force of some role acts."""
    return (body.name for body in scene.bodies.values() if any(force.role == role for force in body.forces))


def goes_straight(body: BodyFacts) -> bool:
    return body.motion.kind == "line" and not body.motion.turns


def reversed_force(role: Role) -> Callable[[Force, BodyFacts], Force]:
    """A force of some role the other way."""
    return lambda force, body: replace(force, size=negate(force.size)) if force.role == role else force


def gravity_sign(scene: Scene) -> Made:
    """−m g for m g."""
    for name in each(pulled_bodies(scene, WEIGHT)):
        words = f"the weight of the {spoken(name)} was given the wrong sign"
        yield words, Change(altered=of_forces((name,), reversed_force(WEIGHT)))


def tension_sign(scene: Scene) -> Made:
    """−T for T in the law of what hangs from a string."""
    for name in each(name for name in pulled_bodies(scene, TENSION) if goes_straight(scene.bodies[name])):
        words = f"the tension on the {spoken(name)} was given the wrong sign"
        yield words, Change(altered=of_forces((name,), reversed_force(TENSION)), aside=(ENERGY,))


def tension_as_weight(scene: Scene) -> Made:
    """T = m g in place of Newton's second law for what hangs from one string, as if it were at rest."""
    for name, body in scene.bodies.items():
        pulls = [force.size for force in body.forces if force.role.pulls]
        weights = [force.size for force in body.forces if force.role.weighs]
        if goes_straight(body) and len(pulls) == len(weights) == 1:
            words = f"the tension was taken as the weight of the {spoken(name)}"
            altered = in_place_of(SECOND_LAW, name, pulls[0], weights[0])
            yield words, Change(altered=altered, aside=(ENERGY,))


def in_place_of(law: Law, name: str, left: Formula, right: Formula) -> Alteration:
    """left = right wherever a law of a body stands."""

    def changed(equation: Equation) -> Equation:
        return replace(equation, left=left, right=right) if is_law_of(equation, law, name) else equation

    return Alteration(equation=changed)


def is_law_of(equation: Equation, law: Law, name: str) -> bool:
    return equation.bodies == (name,) and equation.law == law


def no_weight(scene: Scene) -> Made:
    """m for m g."""
    gravity = scene.problem.gravity
    if isinstance(gravity, Symbol):
        yield f"mass was put for weight, without {to_text(gravity)}", Change(letters={gravity.name: ONE})


def weight_at_end(scene: Scene) -> Made:
    """The arm L for ½ L of a rod that is hinged at its end."""
    weighing = frozenset(pulled_bodies(scene, WEIGHT))
    for name in each(name for name in hinged_at_end(scene) if name in weighing):
        words = f"the weight of the {spoken(name)} was taken to act at its end"
        yield words, Change(altered=of_forces((name,), farther))


def mass_at_end(scene: Scene) -> Made:
    """I = m L² and the weight at L, of a rod that is hinged at its end."""
    for name in each(hinged_at_end(scene)):
        words = f"the {spoken(name)} was taken as a point mass at its end"
        yield words, Change(altered=of_bodies((name,), gathered_at_end))


def hinged_at_end(scene: Scene) -> Iterator[str]:
    """The rods that turn about one of their ends."""
    for name, body in scene.configuration.bodies.items():
        held = scene.configuration.pivot(name, scene.moments[0].state)
        if name in scene.bodies and shape_of(body).slender and held is not None and held.point in ("start", "end"):
            yield name


def gathered_at_end(body: BodyFacts, facts: Facts) -> BodyFacts:
    """The body with its mass twice as far from its axis as its centre of mass is."""
    far = body.cm + body.cm
    formula = simplify(body.mass * far.dot(far))
    forces = tuple(farther(force, body) for force in body.forces)
    return replace(body, cm=far, inertia=Inertia(formula, formula, ""), forces=forces)


def farther(force: Force, body: BodyFacts) -> Force:
    return replace(force, arm=force.arm + force.arm) if force.role.weighs else force


# friction


def rubbing(scene: Scene) -> Iterator[tuple[tuple[str, ...], str]]:
    """What rubs, by the names of the connections or actions, with the words for the bodies: each alone, then all."""
    bodies: dict[str, list[str]] = {}
    for body in scene.bodies.values():
        for item in body.acting:
            if item.role.rubs:
                bodies.setdefault(item.owner, []).append(f"the {spoken(body.name)}")
    for owner in each(bodies):
        yield (owner,), and_joined(bodies[owner])
    if len(bodies) > 1:
        yield tuple(bodies), and_joined(list(dict.fromkeys(name for names in bodies.values() for name in names)))


def friction_sign(scene: Scene) -> Made:
    """μ N the other way; of friction that no one knows, its torque the other way."""
    for owners, who in rubbing(scene):
        words = f"the friction on {who} was given the wrong sign"
        yield words, Change(altered=of_owners(owners, resized(negate)))
        turned = of_owners(owners, lambda item: replace(item, arm=-item.arm) if isinstance(item, Force) else item)
        words = f"the torque of the friction on {who} was given the wrong sign"
        yield words, Change(altered=turned, aside=(ENERGY,))


def resized(change: Callable[[Formula], Formula]) -> Callable[[Force | Couple], Force | Couple]:
    """A force or couple of another size."""

    def changed(item: Force | Couple) -> Force | Couple:
        if isinstance(item, Couple):
            return replace(item, torque=change(item.torque))
        return replace(item, size=change(item.size))

    return changed


def no_friction(scene: Scene) -> Made:
    """0 for μ N; of what rolls also 0 in Newton's second law alone, as if it need not turn."""
    for owners, who in rubbing(scene):
        words, smooth = f"the friction on {who} was left out", of_owners(owners, resized(lambda size: ZERO))
        yield words, Change(altered=smooth)
        rubbed = (body for body in scene.bodies.values() if any(item.owner in owners for item in body.acting))
        rolling = frozenset(body.name for body in rubbed if body.motion.turns and body.motion.kind != "axis")
        if rolling:
            sliding = replace(smooth, equation=without_rotation(rolling))
            yield words, Change(altered=sliding, aside=(ENERGY,))


def normal_as_weight(scene: Scene) -> Made:
    """N = m g, whatever the slope."""
    for names, who in each_and_all(pulled_bodies(scene, FRICTION)):
        words = f"the normal force on {who} was taken as its weight"
        yield words, Change(altered=of_forces(names, rubbed_by_weight))


def rubbed_by_weight(force: Force, body: BodyFacts) -> Force:
    """Friction by the weight of a body where it goes by its normal force."""
    if not force.role.rubs:
        return force
    weight = total([other.size for other in body.forces if other.role.weighs])
    normals = dict.fromkeys(of_kinds(force.size.symbols(), ("normal_force",)), weight)
    return replace(force, size=force.size.substitute(normals))


# torques


def no_radius(scene: Scene) -> Made:
    """T for T R."""
    turning = (body for body in scene.bodies.values() if body.motion.turns)
    for names, who in each_and_all(body.name for body in turning if any(force.arm.parts for force in body.forces)):
        words = f"the radius was left out of the torque on {who}"
        yield words, Change(altered=of_forces(names, armless), aside=(ENERGY,))


def armless(force: Force, body: BodyFacts) -> Force:
    """A force whose arm has no length but one."""
    return replace(force, arm=Vector(tuple((ONE, heading) for _, heading in force.arm.parts)))


def equal_tensions(scene: Scene) -> Made:
    """T₁ = T₂ in place of the law of rotation of the pulley between them."""
    pairs = {name: tensions_on(body) for name, body in scene.bodies.items() if body.motion.kind == "axis"}
    for name in each(name for name, found in pairs.items() if found):
        words = f"the tensions on both sides of the {spoken(name)} were taken as equal"
        yield words, Change(altered=in_place_of(ROTATION, name, *pairs[name][0]), aside=(ENERGY,))


def tensions_on(body: BodyFacts) -> list[tuple[Formula, Formula]]:
    """The two tensions of each string that runs over a wheel."""
    pulls = [force for force in body.forces if force.role.pulls and isinstance(force.size, Symbol)]
    return [
        (one.size, other.size)
        for one, other in combinations(pulls, 2)
        if one.owner == other.owner and one.size != other.size
    ]


# supports


def no_reaction(scene: Scene) -> Made:
    """Σ F = m a of a hinged body, across the line to its hinge but without the force of that, in place of the torques about it."""
    for name in each(body.name for body in scene.bodies.values() if body.motion.kind == "axis" and body.cm.parts):
        altered = replace(of_bodies((name,), without_reaction), equation=without_rotation({name}))
        words = f"the force of the support on the {spoken(name)} was left out"
        yield words, Change(altered=altered, aside=(ENERGY,))


def without_rotation(names: Collection[str]) -> Callable[[Equation], Equation | None]:
    """All equations but the laws of rotation of some bodies."""
    return lambda equation: None if any(is_law_of(equation, ROTATION, name) for name in names) else equation


def without_reaction(body: BodyFacts, facts: Facts) -> BodyFacts:
    """The body as its weight and other pulls would move its centre of mass on its circle."""
    forces = tuple(force for force in body.forces if not force.role.holds)
    return replace(body, forces=forces, axes=(direction_of(body.cm).turned(90),))


# accelerations


def centre_at_rest(scene: Scene) -> Made:
    """0 for α r in Newton's second law of what turns about an axis, as if its centre of mass stood still."""
    rates = frozenset(
        Symbol(letter)
        for facts in scene.moments
        for body in facts.bodies
        if body.motion.kind == "axis" and body.cm.parts
        for letter in body.motion.spin_rate.symbols()
    )
    if rates:
        altered = second_law_without(lambda node: node in rates)
        yield "the acceleration of the centre of mass was left out", Change(altered=altered)


def second_law_without(left_out: Callable[[Formula], bool]) -> Alteration:
    """Newton's second law with 0 for what is left out of it."""

    def without(side: Formula) -> Formula:
        return side.transform(lambda node: ZERO if left_out(node) else node)

    return Alteration(equation=lambda law: both_sides(law, without) if law.law == SECOND_LAW else law)


def no_centripetal(scene: Scene) -> Made:
    """0 for m v²/r and m r ω² in Newton's second law."""
    speeds = frozenset(speed for facts in scene.moments for body in facts.bodies for speed in speed_letters(body))
    if speeds:
        altered = second_law_without(lambda node: isinstance(node, Power) and node.base in speeds)
        yield "the acceleration towards the centre of the circle was left out", Change(altered=altered)


def speed_letters(body: BodyFacts) -> Iterator[Formula]:
    """The letters of its speeds, where its centre of mass goes round in a circle."""
    if body.cm.parts or body.motion.bend is not None:
        rates = [body.motion.spin, *(size for size, _ in body.motion.velocity.parts)]
        yield from (Symbol(name) for rate in rates for name in rate.symbols())


def rim_as_centre(scene: Scene) -> Made:
    """v for v + ω R of the rims of rollers or drums on which something lies."""
    lying = [item for item in scene.problem.connections if item.lying() and not scene.problem.space]
    carried = [(item.name, item.carrier(scene.configuration)) for item in lying]
    turning = {body.name: body.motion for facts in scene.moments for body in facts.bodies if body.motion.turns}
    for names, who in each_and_all(name for _, name in carried if name in turning):
        owners = {owner for owner, name in carried if name in names}
        altered = Alteration(facts=with_still_rims(owners, names))
        yield f"the rim of {who} was taken to be as fast as the centre", Change(altered=altered, aside=(ENERGY,))


def with_still_rims(owners: Collection[str], names: Collection[str]) -> Callable[[Facts], Facts]:
    """Facts in which the rules of some elements leave out how bodies turn, on their right."""

    def changed(facts: Facts) -> Facts:
        motions = [body.motion for body in facts.bodies if body.name in names]
        rates = [letter for own in motions for part in (own.spin, own.spin_rate) for letter in part.symbols()]
        return replace(facts, rules=tuple(still(rule, dict.fromkeys(rates, ZERO)) for rule in facts.rules))

    def still(rule: Rule, put: Mapping[str, Formula]) -> Rule:
        if rule.owner not in owners:
            return rule
        velocity, bent = (
            (sides[0], sides[1].substitute(put)) for sides in (rule.velocity, rule.acceleration or rule.velocity)
        )
        return replace(rule, velocity=velocity, acceleration=bent if rule.acceleration is not None else None)

    return changed


def carrier_at_rest(scene: Scene) -> Made:
    """v · n = 0 and a · n = 0 of what lies on a side of a body, as if that body did not move."""
    configuration, state = scene.configuration, scene.configuration.timeline.states[0].name
    for item in configuration.connections(state):
        surface = item.surface(configuration, state)
        if surface is None or not surface.bearer():
            continue
        words = f"the {spoken(surface.bearer())} was taken as at rest for the {spoken(item.lying())} on it"
        altered = Alteration(facts=as_if_at_rest(item.name, configuration.host(surface.bearer(), state)))
        yield words, Change(altered=altered, aside=(ENERGY, ANGULAR_MOMENTUM))


def as_if_at_rest(owner: str, carrier: str) -> Callable[[Facts], Facts]:
    """The rules of a contact without the rates of what carries it."""

    def changed(facts: Facts) -> Facts:
        motion = next((body.motion for body in facts.bodies if body.name == carrier), None)
        parts = () if motion is None else (*motion.velocity.parts, *motion.acceleration.parts)
        still = {name: ZERO for size, _ in parts for name in size.symbols()}
        return replace(
            facts, rules=tuple(at_rest_rule(rule, still) if rule.owner == owner else rule for rule in facts.rules)
        )

    return changed


def at_rest_rule(rule: Rule, still: Mapping[str, Formula]) -> Rule:
    """A rule with some rates put at zero."""
    velocity = rule.velocity[0].substitute(still), rule.velocity[1].substitute(still)
    if rule.acceleration is None:
        return replace(rule, velocity=velocity)
    acceleration = rule.acceleration[0].substitute(still), rule.acceleration[1].substitute(still)
    return replace(rule, velocity=velocity, acceleration=acceleration)
