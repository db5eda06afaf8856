"""Mistakes with forces: of the wrong sign, left out, without the radius in their torque, at another point, or of another size."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING

from msgspec.structs import replace

from rotsolve.algebra.formula import ONE, ZERO, Formula, Symbol, negate, total
from rotsolve.core.alteration import Alteration
from rotsolve.core.equation import ENERGY, Equation
from rotsolve.core.facts import BodyFacts, Couple, Facts, Force
from rotsolve.core.registry import SEPARATOR
from rotsolve.core.vectors.heading import Vector
from rotsolve.core.writing import spoken
from rotsolve.elements.rims import shape_of
from rotsolve.grading.mistakes.mistake import Change
from rotsolve.grading.mistakes.places import Made, each_and_all, listed, of_bodies, of_forces, of_owners

if TYPE_CHECKING:
    from rotsolve.grading.mistakes.scene import Scene


def pulled(scene: Scene, role: str) -> Iterator[str]:
    """The bodies on which a force of some role acts."""
    return (body.name for body in scene.bodies() if any(force.role == role for force in body.forces))


def backwards(role: str) -> Callable[[Force, BodyFacts], Force]:
    """A force of some role the other way."""
    return lambda force, body: replace(force, size=negate(force.size)) if force.role == role else force


def gravity_sign(scene: Scene) -> Made:
    """−m g for m g."""
    for name in pulled(scene, "weight"):
        words = f"the weight of the {spoken(name)} was given the wrong sign"
        yield words, Change(altered=of_forces((name,), backwards("weight")))


def tension_sign(scene: Scene) -> Made:
    """−T for T in the law of what hangs from a string."""
    hanging = (body.name for body in scene.bodies() if body.motion.kind == "line" and not body.motion.turns)
    for name in (name for name in pulled(scene, "tension") if name in set(hanging)):
        words = f"the tension on the {spoken(name)} was given the wrong sign"
        yield words, Change(altered=of_forces((name,), backwards("tension")), aside=ENERGY)


def no_weight(scene: Scene) -> Made:
    """m for m g."""
    if any(pulled(scene, "weight")):
        yield (
            "mass was put for weight, without g",
            Change(problem=lambda problem: replace(problem, gravity=ONE), modes_kept=True),
        )


def weight_at_end(scene: Scene) -> Made:
    """The arm L for ½ L of a rod that is hinged at its end."""
    for body in scene.bodies():
        first = scene.moments[0].state
        held = scene.arrangement.pivot(body.name, first)
        if (
            held is not None
            and held.point in ("start", "end")
            and shape_of(scene.arrangement.body(body.name, first)).word == "rod"
        ):
            words = f"the weight of the {spoken(body.name)} was taken to act at its end"
            yield words, Change(altered=of_forces((body.name,), farther))


def farther(force: Force, body: BodyFacts) -> Force:
    return replace(force, arm=force.arm + force.arm) if force.role == "weight" else force


# friction


def rubbing(scene: Scene) -> Iterator[tuple[tuple[str, ...], str]]:
    """What rubs, by the names of the connections or actions, with the words for the bodies."""
    bodies: dict[str, list[str]] = {}
    for body in scene.bodies():
        for item in body.acting:
            if item.role == "friction":
                bodies.setdefault(item.owner, []).append(f"the {spoken(body.name)}")
    for owner, names in bodies.items():
        yield (owner,), listed(names)
    if len(bodies) > 1:
        yield tuple(bodies), listed(list(dict.fromkeys(name for names in bodies.values() for name in names)))


def friction_sign(scene: Scene) -> Made:
    """μ N the other way; of friction that no one knows, its torque the other way."""
    for owners, who in rubbing(scene):
        words = f"the friction on {who} was given the wrong sign"
        yield words, Change(altered=of_owners(owners, other_way), modes_kept=True)
        turned = Change(altered=of_owners(owners, turned_round), aside=ENERGY, modes_kept=True)
        yield f"the torque of the friction on {who} was given the wrong sign", turned


def other_way(item: Force | Couple) -> Force | Couple:
    if isinstance(item, Couple):
        return replace(item, torque=negate(item.torque))
    return replace(item, size=negate(item.size))


def turned_round(item: Force | Couple) -> Force | Couple:
    return replace(item, arm=-item.arm) if isinstance(item, Force) else item


def no_friction(scene: Scene) -> Made:
    """0 for μ N."""
    for owners, who in rubbing(scene):
        words = f"the friction on {who} was left out"
        yield words, Change(altered=of_owners(owners, none), modes_kept=True)


def none(item: Force | Couple) -> Force | Couple:
    return replace(item, torque=ZERO) if isinstance(item, Couple) else replace(item, size=ZERO)


def normal_as_weight(scene: Scene) -> Made:
    """N = m g, whatever the slope."""
    for names, who in each_and_all(pulled(scene, "friction")):
        words = f"the normal force on {who} was taken as its weight"
        yield words, Change(altered=of_forces(names, rubbed_by_weight), modes_kept=True)


def rubbed_by_weight(force: Force, body: BodyFacts) -> Force:
    """Friction by the weight of a body where it goes by its normal force."""
    if force.role != "friction":
        return force
    weight = total([other.size for other in body.forces if other.role == "weight"])
    normals = {name: weight for name in force.size.symbols() if name.startswith(f"normal_force{SEPARATOR}")}
    return replace(force, size=force.size.substitute(normals))


# torques


def no_radius(scene: Scene) -> Made:
    """T for T R."""
    turning = (
        body.name for body in scene.bodies() if body.motion.turns and any(force.arm.parts for force in body.forces)
    )
    for names, who in each_and_all(turning):
        words = f"the radius was left out of the torque on {who}"
        yield words, Change(altered=of_forces(names, armless), aside=ENERGY)


def armless(force: Force, body: BodyFacts) -> Force:
    """A force whose arm has no length but one."""
    return replace(force, arm=Vector(tuple((ONE, heading) for _, heading in force.arm.parts)))


def equal_tensions(scene: Scene) -> Made:
    """T₁ = T₂ in place of the law of rotation of the pulley between them."""
    for body in scene.bodies():
        pairs = tensions_on(body)
        if body.motion.kind == "axis" and pairs:
            words = f"the tensions on both sides of the {spoken(body.name)} were taken as equal"
            yield words, Change(altered=Alteration(equation=levelled(body.name, pairs[0])), aside=ENERGY)


def tensions_on(body: BodyFacts) -> list[tuple[Formula, Formula]]:
    """The two tensions of each string that runs over a wheel."""
    pulls = [force for force in body.forces if force.role == "tension" and isinstance(force.size, Symbol)]
    return [
        (one.size, other.size)
        for place, one in enumerate(pulls)
        for other in pulls[place + 1 :]
        if one.owner == other.owner and one.size != other.size
    ]


def levelled(name: str, pair: tuple[Formula, Formula]) -> Callable[[Equation], Equation]:
    """T₁ = T₂ wherever the law of rotation of a wheel stands."""

    def changed(equation: Equation) -> Equation:
        if not turns(equation, name):
            return equation
        return replace(equation, left=pair[0], right=pair[1])

    return changed


def turns(equation: Equation, name: str) -> bool:
    """Whether an equation is the law of rotation of a body."""
    return equation.bodies == (name,) and equation.label.startswith("Newton's law for rotation")


# supports


def no_reaction(scene: Scene) -> Made:
    """Σ F = m a of a hinged body without the force of its hinge, in place of the torques about it."""
    for body in scene.bodies():
        if body.motion.kind == "axis" and body.cm.parts:
            altered = replace(of_bodies((body.name,), unsupported), equation=without_rotation(body.name))
            words = f"the force of the support on the {spoken(body.name)} was left out"
            yield words, Change(altered=altered, aside=ENERGY)


def without_rotation(name: str) -> Callable[[Equation], Equation | None]:
    """All equations but the law of rotation of a body."""
    return lambda equation: None if turns(equation, name) else equation


def unsupported(body: BodyFacts, facts: Facts) -> BodyFacts:
    return replace(body, forces=tuple(force for force in body.forces if force.role != "reaction"))
