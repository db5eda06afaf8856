"""Welded: what a weld does to the body that it names last: m a and I α of all on that side, less what else acts there."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from rotsolve.algebra.formula import Formula, negate, total
from rotsolve.core.facts import BodyFacts, Couple, Force, signed
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.vectors.heading import RIGHT, UP, Vector
from rotsolve.core.writing import spoken
from rotsolve.elements.shapes import shape_of
from rotsolve.language.elements import Connection
from rotsolve.language.problem import Path
from rotsolve.laws.newton import torque_about
from rotsolve.motion.instant import Instant
from rotsolve.motion.rigid import tidy
from rotsolve.paths.meaning import NATURAL, Meaning, Meant, NotYet, path_text, vector_size
from rotsolve.paths.shares import share_of


def weld_force(path: Path, item: Connection, body: BodyFacts, instant: Instant) -> Meant:
    """Σ m a − Σ F over all on the side of the last-named body: a component, or its size."""
    side = side_of(item, instant)
    pulls = [share_of(name, instant, body) for name in side]
    vectors = [pull.acceleration.scaled(pull.mass) for pull in pulls]
    vectors += [-force.vector for force in outside(side, body, instant) if isinstance(force, Force)]
    vector = tidy(Vector(tuple(part for vector in vectors for part in vector.parts)))
    dimension, label = (
        QUANTITIES["force"].dimension,
        f"force of {spoken(path.owner)}: m a less what else acts beyond it",
    )
    if path.component in ("x", "y"):
        return Meaning(vector.along(RIGHT if path.component == "x" else UP), dimension, label=label)
    if path.component in NATURAL:
        raise NotYet(f"`{path_text(path)}` has no meaning", help="ask for `x` or `y`")
    return Meaning(vector_size(vector), dimension, vector, label=label)


def weld_torque(path: Path, item: Connection, body: BodyFacts, instant: Instant) -> Formula:
    """Σ (I α + r × m a) − Σ (r × F + τ) about the weld, over all on the side of the last-named body: its couple, along that one's turn."""
    (*near, ref), side = item.joined(), side_of(item, instant)
    on_last = not lies_flat(side, body, instant)
    if not on_last:  # where a surface pushes on it nothing tells: by what it does to the others
        carried = instant.configuration.carried(body.name, instant.state)
        side = tuple(name for name in carried if name not in side)
        if not side or lies_flat(side, body, instant):
            said = f"where what carries `{ref.owner}` and `{near[0].owner}` pushes on them nothing tells"
            raise NotYet(said, help=f"ask for the force of `{item.name}`")
    point = instant.mark_of(ref)
    turned = [share_of(name, instant, body).torque(point) for name in side]
    turned += [
        negate(torque_about(point, part) if isinstance(part, Force) else part.torque)
        for part in outside(side, body, instant)
    ]
    return signed(total(turned), instant.sense(ref.owner) * (1 if on_last else -1))


def lies_flat(side: Sequence[str], body: BodyFacts, instant: Instant) -> bool:
    """Whether one of some bodies, which do not turn, is carried by all of a side of it: where that pushes is not told."""
    if body.motion.turns:
        return False
    items = (item for item in instant.configuration.connections(instant.state) if item.lying() in side)
    faces = (item.touches()[0] for item in items)
    return any(ref.point is None and not shape_of(instant.body(ref.owner)).pointlike for ref in faces)


def side_of(item: Connection, instant: Instant) -> tuple[str, ...]:
    """The last-named body of a weld, and all that is joined to it beyond the weld."""
    configuration, state = instant.configuration, instant.state
    others = [other.joined() for other in (*configuration.connections(state), *configuration.events(state))]
    pairs = [{ref.owner for ref in pair} for pair in others if pair and pair != item.joined()]
    found = [item.joined()[-1].owner]
    for name in found:
        found += [other for pair in pairs if name in pair for other in sorted(pair - {name, *found})]
    return tuple(found)


def outside(side: Sequence[str], body: BodyFacts, instant: Instant) -> Iterator[Force | Couple]:
    """What else acts on the bodies of one side."""
    for part in body.acting:
        told = part.part if isinstance(part, Force) else ""
        names = {told} if told else acted_on(part.owner, body.name, instant)
        if names & set(side):
            if names - set(side):
                raise NotYet(f"on which of the bodies that are joined `{part.owner}` acts is not told")
            yield part


def acted_on(owner: str, host: str, instant: Instant) -> set[str]:
    """The bodies, of those that one stands for, on which an element acts."""
    items = (item for item in instant.configuration.acting(instant.state) if item.name == owner)
    refs = [ref for item in items for ref in item.touches() if ref.owner in instant.configuration.bodies]
    return {ref.owner for ref in refs if instant.host(ref.owner) == host} or {host}
