"""Spans: what belongs to phases and events: time, way, angle turned, impulse, work, and the change or loss of a quantity."""

from __future__ import annotations

from msgspec.structs import replace

from rotsolve.algebra.formula import ONE, PI, ZERO, Formula, add, negate, sqrt, total
from rotsolve.algebra.units.dimension import ENERGY, LENGTH
from rotsolve.core.facts import BodyFacts, Force, signed
from rotsolve.core.passage import Meeting, Passage
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.symbols import of_kinds, running
from rotsolve.core.vectors.heading import RIGHT, UP, Heading, Vector, cartesian
from rotsolve.core.writing import is_negative
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import Path, PointRef, Term
from rotsolve.laws.energy import potential
from rotsolve.laws.momentum import over_time
from rotsolve.motion.instant import Instant
from rotsolve.motion.places import gone_along
from rotsolve.motion.rigid import rim_ways, tidy
from rotsolve.motion.timeline import Interval
from rotsolve.motion.travels import angle_turned
from rotsolve.paths.meaning import Meaning, NotYet, Unclear, label_of, spoken_point, vector_size, whole_vector
from rotsolve.paths.shares import joined, named_last

NET = "net"  # names all forces together


def impulse(path: Path, interval: str, scene: SceneEquations) -> Formula:
    """The impulse of a support or blow in an event, or of an action or connection over a phase."""
    encounter = scene.encounters.get(interval)
    if encounter is None and interval in scene.passages:
        return impulse_over(path, scene.passages[interval], scene)
    if encounter is None:
        raise NotYet("an impulse is asked of an event or a phase")
    if path.quantity == "angular_impulse":
        return twist_of(path.owner, interval, scene)
    hit = meeting_of_last(path.owner, interval, scene)
    if path.component is not None and hit is not None:
        heading = RIGHT if path.component == "x" else UP
        return Vector(tuple(part for item in own_blows(path, hit) for part in item.vector.parts)).along(heading)
    acting = hit.impulses if hit is not None else ()
    own = [item.size for item in acting if item.owner == path.owner and of_kinds(item.size.symbols(), ("impulse",))]
    sizes = list(dict.fromkeys(own or [item.size for item in own_blows(path, hit)]))
    if not sizes:
        raise NotYet(f"`{path.owner}` gives no impulse in `{interval}`")
    return sizes[0] if len(sizes) == 1 else sqrt(total([size**2 for size in sizes]))


def own_blows(path: Path, hit: Meeting | None) -> list[Force]:
    """The blows on a body of what a path names."""
    return [item for item in (hit.blows if hit is not None else ()) if item.owner == path.owner]


def blow(path: Path, interval: str, scene: SceneEquations) -> Vector | None:
    """The blow of an event or support on its last-named body, where it has two components; else none is needed."""
    parts = blows_on_last(path, interval, scene)
    return Vector(tuple(parts)) if len(parts) > 1 else None


def ways_of_blow(path: Path, interval: str, scene: SceneEquations) -> tuple[str, str]:
    """Words for a blow on its last-named body that has one component: along it, and against it."""
    parts = blows_on_last(path, interval, scene)
    if path.quantity != "impulse" or len(parts) != 1:
        return "", ""
    size, heading = parts[0]
    negative = is_negative(size)
    for direction, words in ((RIGHT, ("right", "left")), (UP, ("up", "down"))):
        if (heading - direction).cos() in (ONE, negate(ONE)):
            return words if ((heading - direction).cos() == ONE) != negative else (words[1], words[0])
    return "", ""


def blows_on_last(path: Path, interval: str, scene: SceneEquations) -> list[tuple[Formula, Heading]]:
    """The components of the blow of an event or support on its last-named body."""
    encounter = scene.encounters.get(interval)
    if encounter is None or path.component is not None:
        return []
    return [
        part for item in own_blows(path, meeting_of_last(path.owner, interval, scene)) for part in item.vector.parts
    ]


def meeting_of_last(owner: str, interval: str, scene: SceneEquations) -> Meeting | None:
    """What a blow does to its last-named body."""
    last = last_named(owner, interval, scene)
    hit = [item for item in scene.encounters[interval].meetings if any(found.owner == owner for found in item.impulses)]
    return next((item for item in hit if item.body.name == last), hit[-1] if hit else None)


def last_named(owner: str, interval: str, scene: SceneEquations) -> str:
    """The body that an event or connection names last."""
    found = scene.configuration.timeline.interval(interval)
    assert found is not None and found.event is not None
    instant = scene.instant(found.start)
    item = scene.configuration.connection(owner, found.start)
    refs = item.touches() if item is not None else ()
    own = next((event for event in found.event.each() if event.name == owner), None)
    if own is not None:
        refs = own.points(scene.configuration.problem.connections)
    bodies = [ref.owner for ref in refs if ref.owner in scene.configuration.bodies]
    return instant.host(bodies[-1]) if bodies else ""


def impulse_over(path: Path, passage: Passage, scene: SceneEquations) -> Formula:
    """F t or τ t of what stays the same in a phase, ∫ F dt or ∫ τ dt of what varies in time, on the body that is named last."""
    pairs: list[tuple[Formula, Formula]] = []
    instant = scene.instant(passage.start.state)
    acted = [body.name for body in passage.start.bodies if any(item.owner == path.owner for item in body.acting)]
    if not acted:
        raise NotYet(f"`{path.owner}` gives no impulse in this phase")
    last = named_last(path.owner, acted, instant)
    for first, body in zip(passage.start.bodies, passage.midst.bodies, strict=True):
        if body.name == last:
            sense = sense_on(path.owner, body, instant)
            pairs += zip(efforts(path, first, sense), efforts(path, body, sense), strict=True)
    if not pairs:
        help = f"ask for its force, or for the change of the angular momentum of `{last}`"
        raise NotYet(f"the impulse of `{path.owner}`, which turns `{last}` alone, is not solved yet", help=help)
    if any(running(effort.symbols()) for _, effort in pairs):
        word = path.quantity.replace("_", " ")
        raise NotYet(f"the {word} of `{path.owner}`, which varies with the motion, is not solved yet")
    return total([over_time(one, effort, passage) for one, effort in pairs])


def sense_on(owner: str, body: BodyFacts, instant: Instant) -> int:
    """The positive turn of the body that an action or connection names, of several that are joined into one the last."""
    items = (item for item in instant.configuration.acting(instant.state) if item.name == owner)
    named = [ref.owner for item in items for ref in item.touches() if ref.owner in instant.configuration.bodies]
    return next((instant.sense(name) for name in reversed(named) if instant.host(name) == body.name), body.motion.sense)


def efforts(path: Path, body: BodyFacts, sense: int) -> list[Formula]:
    """What an action or connection does to a body: its torques along a sense, or the sizes of its forces."""
    if path.quantity == "angular_impulse":
        return [signed(body.torque_of(item), sense) for item in body.acting if item.owner == path.owner]
    forces = [force for force in body.forces if force.owner == path.owner]
    if path.component is not None:
        return [force.vector.along(RIGHT if path.component == "x" else UP) for force in forces]
    if len({force.direction for force in forces}) > 1:
        help = f"ask for `{path.owner}.impulse.x` and `{path.owner}.impulse.y`"
        raise NotYet(f"`{path.owner}` pushes `{body.name}` in several directions", help=help)
    return [force.size for force in forces]


def twist_of(owner: str, interval: str, scene: SceneEquations) -> Formula:
    """Angular impulse of a blow on its last-named body, about that body's axis or centre of mass, along its positive turn."""
    hit = meeting_of_last(owner, interval, scene)
    if hit is None:
        raise NotYet(f"`{owner}` gives no angular impulse there")
    torques = [hit.body.torque_of(item) for item in hit.impulses if item.owner == owner]
    return total([signed(torque, hit.body.motion.sense) for torque in torques])


def work_of_weight(name: str, passage: Passage, scene: SceneEquations) -> Formula:
    """m g times the height lost, of one of several that are joined of its own weight."""
    host = scene.instant(passage.start.state).host(name)
    heights = passage.heights.get(host)
    if heights is None:
        raise NotYet(f"how far `{name}` sinks is not told by the scene")
    levels: list[Formula] = []
    for facts, height, sign in ((passage.start, heights[0], 1), (passage.end, heights[1], -1)):
        body = facts.body(host)
        weighing = (force for force in body.forces if force.role.weighs) if body is not None else ()
        weights = [force for force in weighing if force.part in ("", name)]
        levels += [signed(force.size * (height + force.arm.along(UP)), sign) for force in weights]
    return total(levels)


def work_done(path: Path, interval: str, scene: SceneEquations) -> Formula:
    """Work of an action or connection in a phase, or of all forces on a body, which is what it gains of kinetic energy."""
    passage = scene.passages.get(interval)
    if passage is None:
        return work_in_event(path.owner, interval, scene)
    if path.component == "gravity":
        return work_of_weight(path.owner, passage, scene)
    if path.component not in (None, NET):
        return work_of_one(path, passage, interval, scene)
    works = [work for work in passage.works if path.owner == work.owner]
    if path.owner in scene.configuration.bodies and not works:  # else its own, of a man who draws his arms in
        return net_work(path.owner, passage, scene)
    if not works and idle(path.owner, passage):
        return ZERO
    if not works and any(item.owner == path.owner for item in passage.midst.potentials):
        return negate(stored_change(path.owner, passage))
    if not works:
        raise NotYet(f"the work of `{path.owner}` alone can not be told in `{interval}`")
    return total([work.amount for work in works])


def work_of_one(path: Path, passage: Passage, interval: str, scene: SceneEquations) -> Formula:
    """Work on a body of what its path names, where that acts on no other body: then it is all that it does."""
    name = path.component
    assert name is not None
    acted = [body.name for body in passage.midst.bodies if any(item.owner == name for item in body.acting)]
    instant = scene.instant(passage.start.state)
    if acted != [instant.host(path.owner)] or joined(path.owner, instant):
        help = f"ask for `{name}.work`, which is that on all that it touches"
        raise NotYet(f"the work of `{name}` on `{path.owner}` alone is not solved yet", help=help)
    return work_done(Path(name, "work"), interval, scene)


def work_in_event(owner: str, interval: str, scene: SceneEquations) -> Formula:
    """J · (v₁ + v₂)/2 of the blows of an event at the points that they strike, minus the energy lost in it; of all else none."""
    encounter, found = scene.encounters.get(interval), scene.configuration.timeline.interval(interval)
    if encounter is not None and owner in scene.configuration.bodies and struck(owner, interval, scene):
        help = f"ask for `change of {owner}.kinetic_energy`, or for the work in a phase alone"
        raise NotYet(f"the work done on `{owner}` in a blow is not solved yet", help=help)
    if encounter is None or found is None or owner not in encounter.givers:
        return ZERO
    works: list[Formula] = []
    for item in encounter.meetings:
        motions = [scene.instant(state).motion(item.body.name) for state in (found.start, found.end)]
        for blow in (blow for blow in item.blows if blow.owner == owner):
            works += [blow.vector.dot(motion.velocity_of(blow.arm)) / 2 for motion in motions]
    return total(works)


def struck(name: str, interval: str, scene: SceneEquations) -> bool:
    """Whether a body is changed in its motion by the blows of an event."""
    found = scene.configuration.timeline.interval(interval)
    assert found is not None
    hosts = {scene.instant(state).host(name) for state in (found.start, found.end)}
    return any(item.body.name in hosts and item.blows for item in scene.encounters[interval].meetings)


def net_work(name: str, passage: Passage, scene: SceneEquations) -> Formula:
    """K₂ − K₁ of a body in a phase: the work of all that acts on it, its weight, strings and belts among that."""
    start, end = passage.start.state, passage.end.state
    facts = passage.midst.body(scene.instant(start).host(name))
    if joined(name, scene.instant(start)) or (facts is not None and facts.changing):
        what = "which is joined to another" if joined(name, scene.instant(start)) else "which loses or gains mass"
        help = f"ask for the change of its energy, `change of {name}.energy`, or the work of what acts on it"
        raise NotYet(f"the work done on `{name}` alone, {what}, is not solved yet", help=help)
    path = Path(name, "kinetic_energy")
    first, last = (scene.reader(state).meaning(path, Term(path, at=state)).formula for state in (start, end))
    return last - first


def idle(owner: str, passage: Passage) -> bool:
    """Whether all that an element exerts in a phase does no work: across the way, on points at rest, or in all on the bodies it ties.

    What is stored, or told elsewhere, is work.
    """
    own = [item for body in passage.midst.bodies for item in body.acting if item.owner == owner]
    return bool(own) and not any(item.role.stores or item.role.inner for item in own)


def potential_change(owner: str, passage: Passage, scene: SceneEquations) -> Formula:
    """U₂ − U₁ of a body's weight, of a spring, or of everything."""
    if owner in scene.configuration.bodies:
        return negate(work_of_weight(owner, passage, scene))
    if owner:
        return stored_change(owner, passage)
    if any(passage.heights.get(name) is None for group in passage.groups for name in group):
        raise NotYet("how high it is at both states is not told by the scene")
    ends = [(group, end, sign) for group in passage.groups for end, sign in ((1, 1), (0, -1))]
    return total([signed(term, sign) for group, end, sign in ends for term in potential(passage, group, end)])


def stored_change(owner: str, passage: Passage) -> Formula:
    """U₂ − U₁ of what a spring or wire stores: minus the work that it does."""
    ends = ((passage.end, 1), (passage.start, -1))
    return total(
        [signed(item.energy, sign) for facts, sign in ends for item in facts.potentials if item.owner == owner]
    )


STORED = ("potential_energy", "energy")


def change_or_loss(term: Term, start: str, end: str, scene: SceneEquations) -> tuple[Meaning, str]:
    """Change (later minus earlier) or loss (earlier minus later)."""
    if term.path.quantity in STORED:
        return stored_difference(term, start, end, scene)
    first = scene.reader(start).meaning(term.path, term)
    last = scene.reader(end).meaning(term.path, term)
    section = scene.configuration.timeline.between(start, end)[-1].name
    label = f"{term.modifier.replace('lost', 'loss of')} {first.label}"
    earlier, later = (last, first) if term.modifier == "lost" else (first, last)
    if earlier.vector is not None and later.vector is not None and whole_vector(term.path):
        gap = tidy(later.vector - earlier.vector)
        return Meaning(vector_size(gap), first.dimension, gap, label=label, law=first.law, plain=first.plain), section
    return Meaning(
        later.formula - earlier.formula, first.dimension, label=label, law=first.law, plain=first.plain
    ), section


def stored_difference(term: Term, start: str, end: str, scene: SceneEquations) -> tuple[Meaning, str]:
    """Change or loss of potential energy (of one body: its weight's alone), or of kinetic and potential energy together."""
    intervals = scene.configuration.timeline.between(start, end)
    passages = [scene.passages[interval.name] for interval in intervals if interval.name in scene.passages]
    result = total([potential_change(term.path.owner, passage, scene) for passage in passages])
    if term.path.quantity == "energy":
        kinetic = replace(term.path, quantity="kinetic_energy")
        gained = [scene.reader(state).meaning(kinetic, term).formula for state in (start, end)]
        result = add(result, gained[1] - gained[0])
    word = term.path.quantity.replace("_", " ")
    label = f"{term.modifier.replace('lost', 'loss of')} {word}"
    return Meaning(negate(result) if term.modifier == "lost" else result, ENERGY, label=label, plain=True), intervals[
        -1
    ].name


def spanned(term: Term, start: str | None, end: str | None, scene: SceneEquations) -> tuple[Meaning, str]:
    """A quantity of one or several phases: the sum over them."""
    timeline, path, kind = scene.configuration.timeline, term.path, QUANTITIES[term.path.quantity]
    start, end = span(term, start, end, scene)
    intervals = timeline.between(start, end)
    if path.quantity == "displacement" and goes_round(path, scene.instant(start)):
        return of_point(term, start, end, scene), intervals[-1].name
    if path.quantity == "time":
        duration = scene.instant(end).time() - scene.instant(start).time()
        lasting = [scene.passages[interval.name] for interval in intervals if interval.name in scene.passages]
        if len(lasting) == 1 and all(
            interval.event is not None for interval in intervals if interval.name not in scene.passages
        ):
            duration = lasting[0].duration
        return Meaning(duration, kind.dimension), intervals[-1].name
    result = total([over_interval(path, interval, scene) for interval in intervals])
    if path.quantity == "turns":
        result = result / (2 * PI)
    single = path.quantity == "impulse" and len(intervals) == 1
    vector = blow(path, intervals[0].name, scene) if single else None
    words = ways_of_blow(path, intervals[0].name, scene) if single and vector is None else ("", "")
    return Meaning(result, kind.dimension, vector, label=label_of(path, term), words=words, plain=True), intervals[
        -1
    ].name


def over_interval(path: Path, interval: Interval, scene: SceneEquations) -> Formula:
    """What one phase or event adds to a quantity."""
    if path.quantity in ("impulse", "angular_impulse"):
        return impulse(path, interval.name, scene)
    if path.quantity not in ("displacement", "rotation", "turns"):
        return work_done(path, interval.name, scene)
    if interval.event is not None:
        return ZERO  # an event moves nothing
    if path.quantity != "displacement":
        return angle_turned(path.owner, interval, scene.instant(interval.start))
    from rotsolve.paths.displacements import displacement_over

    return displacement_over(path, interval, scene.instant(interval.start), scene.instant(interval.end))


def goes_round(path: Path, instant: Instant) -> bool:
    """Whether a displacement is that of a point that may go round another: a named one, or a body on an axis or joined to what turns."""
    if path.point is not None or path.owner not in instant.configuration.bodies:
        return path.point is not None
    motion = instant.motion(path.owner)
    free = motion.kind == "plane" and path.component is None
    return motion.kind == "axis" or free or (motion.turns and instant.host(path.owner) != path.owner)


def of_point(term: Term, start: str, end: str, scene: SceneEquations) -> Meaning:
    """Displacement of a point of a body: where it is at the end less where it was, Δr of the reference and of the point from there."""
    path, dimension = term.path, LENGTH
    ref = PointRef(path.owner, path.point or "cm", path.argument)
    instants = [scene.instant(state) for state in (start, end)]
    host, arms = instants[0].host(path.owner), [item.point(ref) for item in instants]
    followed = all(item.angle(host) is not None or not item.motion(host).turns for item in instants)
    moved = [way_of_reference(host, axis, start, end, scene) for axis in (RIGHT, UP)]
    still = ref.point in rim_ways(instants[0].body(path.owner)) or not arms[0].parts
    if None in moved or not (followed or still) or any(item.host(path.owner) != host for item in instants):
        raise NotYet(
            f"the displacement of `{path.owner}.{ref.point}` is not solved yet",
            help=f"solved is a point of a body whose place and angle the states tell: `{host}.angle`",
        )
    way = tidy(arms[1] - arms[0] + cartesian(*(part for part in moved if part is not None)))
    label = f"displacement of {spoken_point(path)}"
    if path.component in ("x", "y"):
        return Meaning(way.along(RIGHT if path.component == "x" else UP), dimension, label=label, plain=True)
    if path.component is not None:
        raise NotYet(f"the {path.component} part of a displacement has no meaning", help="ask for `x` or `y`")
    return Meaning(vector_size(way), dimension, way, label=label, plain=True)


def way_of_reference(host: str, axis: Heading, start: str, end: str, scene: SceneEquations) -> Formula | None:
    """How far the reference of a body goes along a direction from one state to another; None where places do not tell."""
    parts: list[Formula] = []
    for interval in scene.configuration.timeline.between(start, end):
        if interval.event is None:
            gone = gone_along(host, axis, interval, scene.instant(interval.start), scene.instant(interval.end))
            if gone is None:
                return None
            parts.append(gone)
    return total([part for part in parts if part != ZERO])


def span(term: Term, start: str | None, end: str | None, scene: SceneEquations) -> tuple[str, str]:
    """The states from and to which a quantity is asked; from the state before to one that is named, else over the whole scene."""
    names = list(scene.configuration.timeline.named)
    if term.at is not None and term.at in names:
        start, end = names[max(0, names.index(term.at) - 1)], term.at
    start, end = start or names[0], end or names[-1]
    if names.index(start) >= names.index(end):
        listed = f"say `from … to …` with two of: {', '.join(names)}"
        help = listed if len(names) > 1 else "give `states`, at least two of them"
        raise Unclear(f"`{term.path.quantity}` runs from one state to a later one", help=help)
    return start, end
