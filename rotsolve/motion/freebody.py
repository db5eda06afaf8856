"""Free bodies: all facts at an instant: every body with its inertia, its motion, and the forces and couples on it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TypeVar

from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, total
from rotsolve.core.facts import (
    WEIGHT,
    BodyFacts,
    Couple,
    Cut,
    Facts,
    Force,
    GivenMotion,
    Motion,
    Potential,
    Requirement,
    Rule,
    Slider,
    Summed,
)
from rotsolve.core.vectors.heading import DOWN, RIGHT, TURNS, UP, Heading, unit
from rotsolve.core.writing import spoken
from rotsolve.elements.connections.lying import supporting
from rotsolve.language.bodies import Ride
from rotsolve.language.problem import Body, PointRef
from rotsolve.motion.footing import footings, on_parts
from rotsolve.motion.instant import Instant
from rotsolve.motion.moments import moment_of_inertia
from rotsolve.motion.rigid import mass_of, sweep

Told = TypeVar("Told", Rule, Potential)


def free_bodies(instant: Instant) -> Facts:
    """The facts of all bodies that are present at an instant, as they are changed where that is done on purpose."""
    altered, stated = instant.configuration.alteration, facts_at(instant)
    return stated if altered is None else altered.restated(stated)


def facts_at(instant: Instant) -> Facts:
    """The facts that the elements of the scene state."""
    configuration = instant.configuration
    stated = [fact for item in configuration.connections(instant.state) for fact in item.facts(instant)]
    stated += [fact for item in configuration.actions(instant.state) for fact in item.facts(instant)]
    forces = on_parts([fact for fact in stated if isinstance(fact, Force)], instant)
    couples = [fact for fact in stated if isinstance(fact, Couple)]
    bodies = []
    for body in configuration.present(instant.state):
        own_forces = (*weight(body.name, instant), *(force for force in forces if force.body == body.name))
        own_couples = tuple(couple for couple in couples if couple.body == body.name)
        bodies.append(free_body(body, instant, own_forces, own_couples))
    cuts: tuple[Cut, ...] = ()
    if configuration.mentions.cuts and not (instant.generic or instant.virtual):
        from rotsolve.motion.cuts import cuts_at

        cuts = cuts_at(instant, tuple(bodies))
    return Facts(
        instant.state,
        instant.when,
        tuple(bodies),
        tuple(of_hosts(fact, instant) for fact in stated if isinstance(fact, Rule)),
        (*(fact for fact in stated if isinstance(fact, Requirement)), *bases_kept(bodies, instant)),
        tuple(of_hosts(fact, instant) for fact in stated if isinstance(fact, Potential)),
        given=tuple(given for body in bodies for given in given_motions(body.name, instant)),
        cuts=cuts,
        sums=tuple(fact for fact in stated if isinstance(fact, Summed)),
    )


def bases_kept(bodies: list[BodyFacts], instant: Instant) -> Iterator[Requirement]:
    """That what stands on corners does not tip over."""
    led = [body for body in bodies if body.motion.kind == "line" and body.pressed and not body.round]
    if led and not (instant.generic or instant.virtual):
        from rotsolve.motion.bases import standings

        for body in led:
            yield from standings(body, instant)


def of_hosts(fact: Told, instant: Instant) -> Told:
    """A rule or a stored energy told of the bodies that stand for those that an element names."""
    hosts = tuple(dict.fromkeys(map(instant.host, fact.bodies)))
    return fact if hosts == fact.bodies else replace(fact, bodies=hosts)


def given_motions(name: str, instant: Instant) -> Iterator[GivenMotion]:
    """What is given of a body's motion, with the letters of this moment for all that follows from it."""
    for drive in instant.configuration.drives(name, instant.state):
        letters = {word: instant.driven(drive, word) for word in drive.kinds[drive.order :]}
        yield GivenMotion(drive, letters, instant.time())


def weight(name: str, instant: Instant) -> tuple[Force, ...]:
    """The weight m g, down at the centre of mass; none where nothing weighs or the picture is seen from above."""
    gravity = instant.configuration.problem.gravity
    if gravity is None or not instant.configuration.heavy:
        return ()
    body, forces = instant.body(name), []
    if any(item.weighs(body) for item in instant.configuration.connections(instant.state)):
        return ()
    for owner in instant.configuration.carried(name, instant.state):
        mass = mass_of(instant.body(owner))
        if mass != ZERO:
            told = gravity.symbols() & mass.symbols()  # by its weight: (w/g) g is w
            size = simplify(mass * gravity) if told else mass * gravity
            arm = instant.point(PointRef(owner, "cm"))
            place = ", at the centre of mass" if arm.parts and owner == name else ""
            noun = "weight" if owner == name else f"weight of {spoken(owner)}"
            forces.append(Force("", WEIGHT, name, size, unit(DOWN), arm, noun, f"down{place}", part=owner))
    return tuple(forces)


def free_body(body: Body, instant: Instant, forces: tuple[Force, ...], couples: tuple[Couple, ...]) -> BodyFacts:
    """One body at an instant."""
    motion, own = instant.motion(body.name), instant.frame(body.name)
    carried = instant.configuration.carried(body.name, instant.state)
    inertia = moment_of_inertia(body, instant.configuration, instant.state, instant.registry) if motion.turns else None
    return BodyFacts(
        body.name,
        total([mass_of(instant.body(name)) for name in carried]),
        inertia,
        motion,
        own.cm.rotated(motion.orientation),
        axes_of(motion),
        positive_sense(body, instant),
        forces,
        couples,
        instant.is_round(body.name),
        period=instant.ask("period", body.name) if instant.configuration.mentions.asks(body.name, "period") else None,
        axis=instant.configuration.axis(body.name, instant.state),
        lays=instant.configuration.laid(body.name),
        changing=instant.configuration.changing(body.name, instant.state),
        slanted=slanted(body.name, instant),
        sliding=(slides := sliding(body.name, instant)),
        drawn=bool(slides) and data_drawn(body.name, instant),
        sweep=sweep(body, own.pieces, own.reference, motion.orientation, motion.whirl, instant.configuration.order),
        footings=footings(body.name, motion, forces, instant) if len(carried) > 1 else (),
    )


def slanted(name: str, instant: Instant) -> bool:
    """Whether a body travels along a slope."""
    surface = supporting(name, instant.configuration, instant.state)
    return surface is not None and surface.slanted


def sliding(name: str, instant: Instant) -> tuple[Slider, ...]:
    """All that slides freely along a body."""
    riders = [item for item in instant.configuration.rides(instant.state) if item.free]
    return tuple(slider(item, instant) for item in riders if instant.host(item.rider.owner) == name)


def slider(item: Ride, instant: Instant) -> Slider:
    """What slides freely, at a moment."""
    rider = item.rider.owner
    mass, place = mass_of(instant.body(rider)), getattr(instant.body(rider).shape, "radius", None) or ZERO
    push = instant.ask("normal_force", item.owner, words=TURNS) if instant.body(rider).count == 1 else None
    out = instant.orientation(instant.host(rider))
    return Slider(rider, mass, instant.outward(rider), place, out, push)


def data_drawn(name: str, instant: Instant) -> bool:
    """Whether data of a body, or of what it carries, change in a phase otherwise than by what slides freely."""
    configuration, phase = instant.configuration, instant.configuration.timeline.phase_of(instant.state)
    free = {item.rider.owner for item in configuration.rides(instant.state) if item.free}
    own = [item for item in configuration.carried(name, instant.state) if item not in free]
    changes = phase is not None and any(configuration.altered(item, phase.start, phase.end) for item in own)
    return changes or configuration.laid(name)


def axes_of(motion: Motion) -> tuple[Heading, ...]:
    """Directions along which Newton's second law is written: along and across a line of travel, else right and up.

    On a circle the second one points to its centre.
    """
    direction = motion.heading
    if direction is None:
        return (RIGHT, UP)
    if motion.bend is not None:
        return (direction, motion.bend.outward.turned(180))
    across = direction.turned(90)
    return (direction, across if across.degrees % 360 <= 180 else direction.turned(-90))


def positive_sense(body: Body, instant: Instant) -> str:
    """The positive sense in words: "down", "clockwise", "down the slope, clockwise"."""
    motion = instant.motion(body.name)
    line = instant.line(body.name) if motion.kind == "line" else None
    travel = line[1] if line else "right, up" if motion.kind == "plane" else ""
    return ", ".join(part for part in (travel, instant.turn_words(body.name)[0] if motion.turns else "") if part)
