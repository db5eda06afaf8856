"""Momentum and angular momentum, over a phase and through an event: their change by what acts from outside, or that they are conserved."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import ZERO, Formula, Integral, Sum, Symbol, negate, total
from rotsolve.core.derivation import Words
from rotsolve.core.equation import (
    ANGLES_TURNED,
    BLOWS,
    CENTRE_STAYS,
    COMMON_AXIS,
    MOMENTUM,
    RESTITUTION,
    TWISTS,
    UNPRESSED,
    Equation,
    Law,
)
from rotsolve.core.facts import BodyFacts, Couple, Facts, Force, signed
from rotsolve.core.passage import Encounter, Meeting, Passage, Travel
from rotsolve.core.symbols import TIME, at_any_time, has_quantities, is_key, is_quantity, key_of
from rotsolve.core.vectors.heading import NOWHERE, RIGHT, UP, Heading, unit
from rotsolve.core.writing import and_joined, flat, is_negative, law, moved, multiplied_out, positive_first, spoken
from rotsolve.laws.newton import about
from rotsolve.laws.table import OverPhase, ThroughEvent
from rotsolve.motion.rigid import tidy


def impulses_over(over: OverPhase) -> Iterator[Equation]:
    """I (ω₂ − ω₁) = τ t for each body on an axis while its torques are constant, ∫ τ dt where they vary in time; so for m v."""
    passage, section = over.passage, over.section
    for travel in passage.travels:
        first, body = passage.start.body(travel.body), passage.midst.body(travel.body)
        if first is None or body is None or travel.pace not in ("constant", TIME):
            continue
        if travel.kind == "turn" and body.motion.kind == "axis" and body.inertia is not None and not body.changing:
            sense, pairs = body.motion.sense, zip(first.acting, body.acting, strict=False)
            efforts = [(signed(one.torque, sense), signed(other.torque, sense)) for one, other in pairs]
            yield summed(TWISTS, efforts, body.inertia.letter, travel, passage, section, about(body))
        elif travel.kind == "line" and travel.pace == TIME and body.motion.heading is not None:
            way = body.motion.heading
            efforts = [
                (one.vector.along(way), other.vector.along(way))
                for one, other in zip(first.forces, body.forces, strict=False)
            ]
            yield summed(BLOWS, efforts, body.mass, travel, passage, section)


def summed(
    stated: Law,
    efforts: list[tuple[Formula, Formula]],
    inertia: Formula,
    travel: Travel,
    passage: Passage,
    section: str,
    about: str = "",
) -> Equation:
    """Σ effort summed over time = inertia · (after − before)."""
    pushes = [over_time(first, midway, passage) for first, midway in efforts]
    left, right = law(flat(pushes), inertia * travel.after - inertia * travel.before)
    cost = 4 if travel.pace != TIME else 5  # in time it restates what Newton's law and the velocity as an integral say
    return stated.equation(left, right, section, (travel.body,), cost=cost, about=about)


def over_time(first: Formula, midway: Formula, passage: Passage) -> Formula:
    """effort · t for what stays the same in a phase, ∫ effort dt for what varies: `first` at its start, `midway` in its midst."""
    letters = midway.symbols()
    lasting = all(key_of(letter).when in (passage.name, "") for letter in first.symbols() if is_key(letter))
    if TIME in letters or (at_any_time(letters) and not lasting):
        return Integral(midway, TIME, *passage.times)
    return (first if at_any_time(letters) else midway) * passage.duration


def momentum_without_force(over: OverPhase) -> Iterator[Equation]:
    """Σ p₁ = Σ p₂ along right or up of bodies that move together, one at least freely, on which no outside force acts in that direction."""
    passage = over.passage
    start, midst, end = (
        {body.name: body for body in facts.bodies} for facts in (passage.start, passage.midst, passage.end)
    )
    for group in passage.groups:
        bodies = [midst[name] for name in sorted(group) if name in midst]
        ends = [[known.get(body.name) for body in bodies] for known in (start, end)]
        free = any(body.motion.kind == "plane" for body in bodies)
        if not free or any(body.changing or body.sliding for body in bodies) or None in (*ends[0], *ends[1]):
            continue
        for axis, words in ((RIGHT, "horizontal"), (UP, "upward")):
            if any(led_across(body, axis) for body in bodies):
                continue  # whatever holds it on its line pushes
            if is_zero(total([force.vector.along(axis) for body in bodies for force in body.forces])):
                before, after = ([body.mass * body.centre_velocity.along(axis) for body in end if body] for end in ends)
                names, group_words = tuple(sorted(group)), named_together(group)
                label = f"no {words} force: momentum is conserved, {group_words}"
                yield MOMENTUM.equation(total(before), total(after), over.section, names, words=label)
                yield from way_of_centre(bodies, axis == UP, before, over)


def way_of_centre(bodies: list[BodyFacts], upwards: bool, before: list[Formula], over: OverPhase) -> Iterator[Equation]:
    """Σ m Δx = t Σ p₁ of bodies whose momentum is conserved: the common centre of mass stays where it is, or goes on evenly."""
    ways = [over.passage.ways.get(body.name, (None, None))[upwards] for body in bodies]
    gone = [body.mass * way for body, way in zip(bodies, ways, strict=True) if way is not None]
    if len(gone) < len(bodies):
        return
    names, whole = tuple(body.name for body in bodies), named_together(body.name for body in bodies)
    stays = f"no {'upward' if upwards else 'horizontal'} force: the centre of mass stays, {whole}"
    label = stays if total(before) == ZERO else f"momentum summed over the time, {whole}"
    right = [term * over.passage.duration for term in before]
    yield CENTRE_STAYS.equation(total(gone), total(right), over.section, names, words=label)


def led_across(body: BodyFacts, axis: Heading) -> bool:
    """Whether a body travels along a line to which its word alone holds it, and which is not that of the axis."""
    way = body.motion.heading if body.motion.kind == "line" else None
    return way is not None and (way - axis).sin() != ZERO and not body.supported


def named_together(names: Iterable[str]) -> str:
    """Names in a row: a, b and c."""
    *others, last = [spoken(name) for name in sorted(names)]
    return f"{', '.join(others)} and {last}" if others else last


def turning_without_torque(over: OverPhase) -> Iterator[Equation]:
    """I ω₁ = I ω₂ of a body that no axis holds, about whose centre of mass nothing turns it."""
    passage = over.passage
    for body in passage.midst.bodies:
        first, last = passage.start.body(body.name), passage.end.body(body.name)
        if first is None or last is None or body.inertia is None or not body.motion.turns or body.changing:
            continue
        if body.motion.kind != "axis" and all(is_zero(item.torque) for item in body.acting):
            before, after = (
                body.inertia.letter * signed(item.motion.spin, body.motion.sense) for item in (first, last)
            )
            label = f"nothing turns {spoken(body.name)} about its centre of mass"
            yield MOMENTUM.equation(before, after, over.section, (body.name,), words=label)


def about_common_axes(over: OverPhase) -> Iterator[Equation]:
    """L₁ + τ t = L₂ of all bodies on one axis: what they do to each other cancels, also what changes their moments of inertia."""
    passage, section = over.passage, over.section
    turning = [body for body in passage.midst.bodies if body.motion.turns]
    for axis in dict.fromkeys(body.axis or body.name for body in turning):
        members = [body for body in turning if (body.axis or body.name) == axis]
        outside = outside_torques(members, passage)
        if (len(members) == 1 and not members[0].changing) or outside is None:
            continue
        sense, names = members[0].motion.sense, tuple(body.name for body in members)
        before, after = (angular_momenta(facts, names, sense) for facts in (passage.start, passage.end))
        words: Words = () if outside else (undisturbed(passage, names),)
        changed = "angular impulse = change of angular momentum about the axis"
        label = changed if outside else "angular momentum about the axis is conserved"
        if flat(before) or flat(after):
            sides = positive_first([*before, *outside]), positive_first(after)
            yield COMMON_AXIS.equation(*sides, section, names, words, words=label)
        if len(members) > 1 and not outside and not any(body.changing for body in members):
            yield from angles_turned(passage, members, before, section)


def undisturbed(passage: Passage, names: tuple[str, ...]) -> str:
    """Why angular momentum is conserved, in a sentence."""
    masses = [[body.mass for body in facts.bodies if body.name in names] for facts in (passage.start, passage.end)]
    added = "" if masses[0] == masses[1] else "; what is added brings no angular momentum"
    return f"No outside torque acts about the axis: what the parts do to each other cancels{added}."


def angles_turned(
    passage: Passage, members: list[BodyFacts], momentum: list[Formula], section: str
) -> Iterator[Equation]:
    """Σ I θ = L t: the conserved angular momentum summed over the time."""
    sense, names = members[0].motion.sense, tuple(body.name for body in members)
    turned = [
        body.inertia.letter * signed(travel.change, travel.sense * sense)
        for body in members
        for travel in passage.travels
        if body.inertia is not None and (travel.body, travel.kind) == (body.name, "turn")
    ]
    right = [term * passage.duration for term in momentum]
    words: Words = ("Angular momentum is the same at every moment: its sum over the time tells the angles turned.",)
    yield ANGLES_TURNED.equation(*moved(turned, right), section, names, words)


def angular_momenta(facts: Facts, names: tuple[str, ...], sense: int) -> list[Formula]:
    """I ω of each body, along a sense."""
    bodies = [body for body in facts.bodies if body.name in names]
    return [body.inertia.letter * signed(body.motion.spin, sense) for body in bodies if body.inertia is not None]


def outside_torques(members: list[BodyFacts], passage: Passage) -> list[Formula] | None:
    """Angular impulses of what does not cancel between the bodies of one axis; None where it varies in a way that is not known."""
    by_owner: dict[str, list[Formula]] = {}
    for body in members:
        if any(force.role.weighs and body.torque_of(force) != ZERO for force in body.forces):
            return None  # it depends on how far the body has turned
        for item in body.acting:
            by_owner.setdefault(item.owner, []).append(signed(body.torque_of(item), members[0].motion.sense))
    outside = [torque for torques in by_owner.values() if not is_zero(total(torques)) for torque in flat(torques)]
    names = {body.name for body in members}
    constant = all(travel.pace == "constant" for travel in passage.travels if travel.body in names)
    if not constant and any(has_quantities(torque) for torque in outside):
        return None
    return [
        Integral(torque, TIME, *passage.times) if TIME in torque.symbols() else torque * passage.duration
        for torque in outside
    ]


def group_through_event(at: ThroughEvent) -> Iterator[Equation]:
    """What an event keeps or changes of the bodies as a whole: angular momentum about the common point, and momentum of free ones."""
    encounter, members = at.encounter, at.encounter.meetings
    names = tuple(sorted(meeting.body.name for meeting in members))
    alone = not encounter.about and len(members) == 1  # its own angular momentum is that about its centre of mass
    if all(meeting.place is not None for meeting in members) and not alone:
        yield from about_common_point(encounter, at.section, names)
    if not encounter.about:
        yield from linear_momentum(encounter, at.section, names)


def restitution(at: ThroughEvent) -> Iterator[Equation]:
    """Speed of separation = e · speed of approach, where the scene tells e."""
    for coefficient, approach, separation in at.encounter.bounces:
        yield RESTITUTION.equation(separation, coefficient * approach, at.section)


def about_common_point(encounter: Encounter, section: str, names: tuple[str, ...]) -> Iterator[Equation]:
    """L₁ + Σ r × J = L₂ about the common point, where no impulse of a support that nobody knows has an arm."""
    members = encounter.meetings
    sense = next((item.body.motion.sense for item in members if item.body.motion.turns or item.held), 1)
    arms = [
        (blow, tidy(item.place + blow.arm).cross(blow.vector))
        for item in members
        if item.place is not None
        for blow in item.blows
    ]
    turns: list[Effort] = [*arms, *((twist, twist.torque) for item in members for twist in item.twists)]
    outside = left_over(turns, encounter)
    if outside is None:
        return
    before = [term for item in members for term in spin_terms(item, sense, after=False)]
    after = spins_after(encounter, sense)
    torque = [signed(term, sense) for term in outside]
    point = f"about the {encounter.about}" if encounter.about else "about the meeting point"
    changed = f"angular impulse = change of angular momentum, {point}"
    label = changed if flat(torque) else f"angular momentum {point} is conserved"
    why: Words = (f"No outside torque acts {point}: {why_none(encounter)}.", *paths_past(encounter))
    words = why if encounter.about and not any(encounter.gives(impulse) for impulse, _ in turns) else ()
    if flat(before) or flat(after):
        yield COMMON_AXIS.equation(*moved([*before, *torque], after), section, names, words, words=label)


Effort = tuple[Force | Couple, Formula]  # an impulse, and its part along a direction or its moment about a point


def left_over(efforts: Sequence[Effort], encounter: Encounter) -> list[Formula] | None:
    """What acts from outside: what the event gives, and None where a support, a surface or a string from outside gives a part, too.

    What the parts of a group do to each other cancels, owner by owner.
    """
    given = [effort for impulse, effort in efforts if encounter.gives(impulse)]
    by_owner: dict[str, list[Formula]] = {}
    for impulse, effort in efforts:
        if not encounter.gives(impulse) and effort != ZERO:
            by_owner.setdefault(impulse.owner, []).append(effort)
    return given if all(is_zero(total(parts)) for parts in by_owner.values()) else None


def why_none(encounter: Encounter) -> str:
    """Why nothing from outside turns a group about its support: bodies that all turn on it already push it to no side."""
    members = encounter.meetings
    if len(members) < 2:
        return encounter.armless
    on_axis = all(item.body.motion.kind == "axis" for item in members)
    how = ", by friction too," if on_axis else ""
    cancels = f"what {and_joined([spoken(item.body.name) for item in members])} do to each other{how} cancels"
    return cancels if on_axis else f"{encounter.armless}, and {cancels}"


def paths_past(encounter: Encounter) -> Iterator[str | Formula]:
    """How far from the common point those pass it that travel along a line, the arm of m v, where that is no difference."""
    for item in encounter.meetings:
        heading = item.body.motion.heading
        if item.place is None or heading is None or item.before == NOWHERE or item.body.motion.kind != "line":
            continue
        arm = tidy(item.place + item.body.about).cross(unit(heading))
        distance = simplify(negate(arm) if is_negative(arm) else arm)
        if distance != ZERO and not distance.holds(Sum):
            yield from (f" The path of {spoken(item.body.name)} passes it at the distance ", distance, ".")


def linear_momentum(encounter: Encounter, section: str, names: tuple[str, ...]) -> Iterator[Equation]:
    """Σ m v of a free group, along the one line of travel or right and up, where nothing that nobody knows holds it."""
    members = encounter.meetings
    headings = {item.body.motion.heading for item in members}
    first = next(iter(headings))
    axes: tuple[Heading, ...] = (first,) if len(headings) == 1 and first is not None else (RIGHT, UP)
    for axis in axes:
        guides = [item.body.motion.heading for item in members if item.guided]
        outside = left_over([(blow, blow.vector.along(axis)) for item in members for blow in item.blows], encounter)
        if outside is None or any(guide is None or (guide - axis).sin() != ZERO for guide in guides):
            continue
        before = [item.body.mass * item.before.along(axis) for item in members]
        after = [item.body.mass * item.after.along(axis) for item in members]
        if flat(before) or flat(after) or flat(outside):
            label = "momentum is conserved" if not flat(outside) else "impulse = change of momentum"
            yield MOMENTUM.equation(*moved([*before, *outside], after), section, names, words=label)


def nothing_pressed(at: ThroughEvent) -> Iterator[Equation]:
    """Jₙ = 0 of each of several surfaces that push bodies one way through an event, where nothing else does along it: none can pull."""
    members = at.encounter.meetings
    for axis in dict.fromkeys(axis for item in members for axis in item.body.axes):
        if any(velocity.along(axis) != ZERO for item in members for velocity in (item.before, item.after)):
            continue
        by_owner: dict[str, list[Force]] = {}
        for blow in (blow for item in members for blow in item.blows if blow.vector.along(axis) != ZERO):
            by_owner.setdefault(blow.owner, []).append(blow)
        outside = [own for own in by_owner.values() if not is_zero(total([blow.vector.along(axis) for blow in own]))]
        pushes = [own[0].vector.along(axis) for own in outside if len(own) == 1 and own[0].role.presses]
        letters = [push if is_quantity(push) else negate(push) for push in pushes]
        one_way = pushes == letters or not any(map(is_quantity, pushes))
        if len(pushes) > 1 and len(pushes) == len(outside) and one_way and all(map(is_quantity, letters)):
            for letter, own in zip(letters, outside, strict=True):
                yield UNPRESSED.equation(letter, ZERO, at.section, owner=spoken(own[0].owner))


def spins_after(encounter: Encounter, sense: int) -> list[Formula]:
    """Angular momenta about the common point after an event: I ω with the moment of inertia of all that turns as one from then on."""
    own = {item.body.name: spin_terms(item, sense, after=True) for item in encounter.meetings}
    parts = [item.body.inertia for item in encounter.meetings if item.body.inertia is not None]
    told = {part.letter.name: part.formula for part in parts if isinstance(part.letter, Symbol)}
    terms: list[Formula] = []
    for members, whole in encounter.joined:
        if whole.inertia is None or not members <= own.keys():
            continue
        apart = total([term for name in members for term in own[name]]).substitute(told)
        spin = signed(whole.motion.spin, sense)
        if is_zero(apart - whole.inertia.formula * spin):  # nothing else is carried along
            terms.append(whole.inertia.letter * spin)
            own = {name: rest for name, rest in own.items() if name not in members}
    return [*terms, *(term for rest in own.values() for term in rest)]


def spin_terms(item: Meeting, sense: int, *, after: bool) -> list[Formula]:
    """r × m v + I ω of one body about the common point, r to what I is about; where the event holds it there, I about the point."""
    if after and item.held is not None:
        return [item.held * signed(item.spin_after, sense)]
    velocity, spin = (item.after, item.spin_after) if after else (item.before, item.spin_before)
    terms = [item.inertia * signed(spin, sense)]
    place = tidy(item.place + item.body.about) if item.place is not None else NOWHERE
    if place.parts:
        terms.append(signed(multiplied_out(place.cross(velocity.scaled(item.body.mass))), sense))
    return [term for term in terms if term != ZERO]


def bodies_through_event(at: ThroughEvent) -> Iterator[Equation]:
    """m Δv = ΣJ and I Δω = Σ r × J of each body."""
    for item in at.encounter.meetings:
        body, sense = item.body, item.body.motion.sense
        for axis in body.axes:
            if item.guided and axis != body.motion.heading:
                continue  # whatever holds it on its line takes what acts across
            pushes = [blow.vector.along(axis) for blow in item.blows]
            before, after = (body.mass * velocity.along(axis) for velocity in (item.before, item.after))
            if flat([*pushes, before, after]):
                yield BLOWS.equation(*moved([*pushes, before], [after]), at.section, (body.name,))
        if body.motion.turns or item.spin_after != ZERO:
            pushes = [signed(body.torque_of(blow), sense) for blow in item.blows]
            pushes += [signed(twist.torque, sense) for twist in item.twists]
            before, after = (item.inertia * signed(spin, sense) for spin in (item.spin_before, item.spin_after))
            if flat([*pushes, before, after]):
                about_centre = "" if body.motion.kind == "axis" else " about the centre of mass"
                sides = moved([*pushes, before], [after])
                yield TWISTS.equation(*sides, at.section, (body.name,), about=about_centre)
