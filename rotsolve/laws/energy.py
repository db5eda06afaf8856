"""Energy: K₁ + U₁ + W = K₂ + U₂ over a phase."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations
from typing import TYPE_CHECKING

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import HALF, ZERO, Formula, Number, Product, Symbol, negate
from rotsolve.core.derivation import NEXT, Words
from rotsolve.core.equation import CONSERVATION, FROM_REST, FROM_STATE_TO_STATE, WORK_AND_ENERGY, Equation
from rotsolve.core.facts import BodyFacts, square
from rotsolve.core.vectors.heading import UP, Vector
from rotsolve.core.writing import flat, is_negative, moved, positive_first, spoken
from rotsolve.laws.table import OverPhase

if TYPE_CHECKING:
    from rotsolve.core.passage import Passage


def conservation(over: OverPhase) -> Iterator[Equation]:
    """K₁ + U₁ + W = K₂ + U₂ for every group of connected bodies whose heights are known.

    Where the phases that lead to this one, with no event between, start at rest, that is state 1 as well.
    """
    passage, earlier = over.passage, over.earlier
    for group in passage.groups:
        if any(passage.heights.get(name) is None for name in group):
            continue
        if any(body.sweep is not None for body in passage.start.bodies if body.name in group):
            continue  # the shaft gives energy too
        works = [work for work in passage.works if group & set(work.bodies)]
        rest = None if works else at_rest_before(passage, group, earlier)
        starts = [rest, passage] if rest is not None else [passage]
        for start in starts:
            left = [*energy(start, group, 0), *(work.amount for work in works)]
            right = energy(passage, group, 1)
            if not flat(left) and not flat(right):
                continue
            since = "" if start is passage else f" since {spoken(start.start.state)}"
            names, remark = tuple(sorted(group)), reason(passage, group, bool(works))
            if works:
                yield WORK_AND_ENERGY.equation(*arranged(left, right), over.section, names, remark)
                continue
            lost = lost_by_weights(start, passage, group)
            sides, form = (arranged(left, right), FROM_STATE_TO_STATE) if lost is None else (lost, FROM_REST)
            yield CONSERVATION.equation(*sides, over.section, names, remark, since=since, form=form)


def lost_by_weights(start: Passage, passage: Passage, group: frozenset[str]) -> tuple[Formula, Formula] | None:
    """U₁ − U₂ = K₂ of what starts at rest, where some weights lose and others gain energy; None elsewhere."""
    before, after = weight_energies(start, group, 0), weight_energies(passage, group, 1)
    if energy(start, group, 0) != before or springs(passage, group, 1):
        return None
    lost = flat([*before, *map(negate, after)])
    motion = kinetic(body for body in passage.end.bodies if body.name in group)
    both = len({is_negative(term) for term in lost}) == 2
    return (positive_first(lost), positive_first(motion)) if both and motion else None


def in_turning_frames(over: OverPhase) -> Iterator[Equation]:
    """The energy in the frame of what is driven, of which something slides or is drawn along."""
    facts = over.passage.midst
    if facts.given and any(body.changing for body in facts.bodies):
        from rotsolve.laws.turning_frame import energy_in_turning_frame

        yield from energy_in_turning_frame(over)


def along_what_turns(over: OverPhase) -> Iterator[Equation]:
    """The way in time of what slides freely along a body that is driven steadily."""
    facts = over.passage.midst
    if facts.given and any(body.sliding for body in facts.bodies):
        from rotsolve.laws.sliding import along_what_is_driven

        yield from along_what_is_driven(over)


def at_rest_before(passage: Passage, group: frozenset[str], earlier: Sequence[Passage]) -> Passage | None:
    """The phase that a group starts at rest, where its energy stays the same from then on; None where it is this one, or none."""
    for before in reversed(earlier):
        if energy(passage, group, 0) == potential(passage, group, 0):
            return None  # it is at rest
        kept = group in before.groups and not any(group & set(work.bodies) for work in before.works)
        if not kept or energy(before, group, 1) != energy(passage, group, 0):
            return None
        if energy(before, group, 0) == potential(before, group, 0):
            return before
        passage = before
    return None


def energy(passage: Passage, group: frozenset[str], end: int) -> list[Formula]:
    """K + U of a group at an end of a phase, term by term."""
    bodies = (passage.start, passage.end)[end].bodies
    return [*kinetic(body for body in bodies if body.name in group), *potential(passage, group, end)]


def arranged(left: list[Formula], right: list[Formula]) -> tuple[Formula, Formula]:
    """K₁ + U₁ = K₂ + U₂ with what is only on one side and negative moved across, so that a fall reads m g h = ½ m v²."""
    if not flat(left) or all(is_negative(term) for term in flat(left)):
        return moved(left, right)
    return positive_first(left), positive_first(right)


def reason(passage: Passage, group: frozenset[str], works: bool) -> Words:
    """Why energy balances: what does no work."""
    inner = [work for work in passage.works if work.inner and group & set(work.bodies)]
    if inner:
        return (inner[0].amount, " is the work of the inner forces: kinetic energy alone is not conserved.")
    return () if works else (*passage.idle[:1], *up_and_down(passage, group))


def up_and_down(passage: Passage, group: frozenset[str]) -> Words:
    """By how much of two bodies one falls and the other rises, as a sentence of its own: what their weights take and give."""
    ways: list[tuple[bool, str, Formula]] = []
    for name in sorted(group):
        ends = passage.heights.get(name)
        change = ZERO if ends is None else simplify(ends[1] - ends[0])
        if change != ZERO:
            ways.append((not is_negative(change), name, negate(change) if is_negative(change) else change))
    if len(ways) != 2 or not passage.idle or not all(isinstance(change, Symbol) for _, _, change in ways):
        return ()
    words: list[str | Formula] = [NEXT]
    for rises, name, change in sorted(ways, key=lambda way: way[:2]):
        words += [f"{', ' if len(words) > 1 else ''}{spoken(name)} {'rises' if rises else 'falls'} by ", change]
    return tuple(words)


def kinetic(bodies: Iterable[BodyFacts]) -> list[Formula]:
    """½ m v² + ½ I ω² of each body, about a fixed axis ½ I ω² alone; and ½ m v² of riders along it, ½ I Ω² about a turning shaft."""
    terms: list[Formula] = []
    for body in bodies:
        if body.motion.kind != "axis":
            terms.extend(half_of(body.mass, item) for item in squares(body.centre_velocity))
        if body.inertia is not None:
            terms.append(HALF * body.inertia.letter * square(body.motion.spin))
        if body.sweep is not None:
            terms.append(HALF * body.sweep.inertia * square(body.sweep.rate))
        terms.extend(HALF * item.mass * square(item.speed) for item in body.sliding)
    return [term for term in terms if term != ZERO]


def half_of(mass: Formula, squared: Formula) -> Formula:
    """½ m v², of a multiple as it is written: ½ (2 m) v²."""
    multiple = isinstance(mass, Product) and isinstance(mass.factors[0], Number)
    return Product((HALF, mass, squared)) if multiple else HALF * mass * squared


def squares(velocity: Vector) -> list[Formula]:
    """v², part by part where the parts are at right angles."""
    if any((one - other).cos() != ZERO for (_, one), (_, other) in combinations(velocity.parts, 2)):
        return [simplify(velocity.dot(velocity))]
    return [square(size) for size, _ in velocity.parts]


def potential(passage: Passage, group: frozenset[str], end: int) -> list[Formula]:
    """m g h of each body, and the energy of the springs."""
    return [*weight_energies(passage, group, end), *springs(passage, group, end)]


def weight_energies(passage: Passage, group: frozenset[str], end: int) -> list[Formula]:
    """m g h of each body."""
    terms: list[Formula] = []
    for body in (passage.start, passage.end)[end].bodies:
        heights = passage.heights.get(body.name)
        if body.name in group and heights is not None:
            pulls = [force for force in body.forces if force.role.weighs]
            terms.extend(force.size * (heights[end] + force.arm.along(UP)) for force in pulls)
    return [term for term in terms if term != ZERO]


def springs(passage: Passage, group: frozenset[str], end: int) -> list[Formula]:
    """The energy of the springs."""
    facts = (passage.start, passage.end)[end]
    terms = [item.energy for item in facts.potentials if group & set(item.bodies)]
    return [term for term in terms if term != ZERO]
