"""Passing: from one state to the next through a blow, which changes velocities alone.

A blow J at r changes m v by J and I ω by r × J, with impulses of the joints as large as it takes.
"""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.confirm.space.arrows import STILL, TINY, Z, arrow_length, crossed, scaled, sum_of, times_arrow
from rotsolve.confirm.space.efforts import Efforts, lever
from rotsolve.confirm.space.rig import Lines, Rig, Told, way_along
from rotsolve.confirm.space.stance import Stance
from rotsolve.confirm.space.ties import SPEED, TURNING, Rates, Terms, Tie, added_terms, three_ties
from rotsolve.confirm.space.worlds import Manner, Moving, World, anyhow
from rotsolve.language.elements import Event
from rotsolve.language.problem import State


def after_blow(rig: Rig, event: Event, before: Manner, state: State | None, put: Told) -> Manner:
    """How all moves just after a blow, standing as before."""
    worlds: list[World] = []
    clash = before.clash
    for world in before.worlds:
        moving = moving_after(rig, event, world, state, put)
        count = len(moving.moving.free)
        found = moving.way([anyhow(count, number) for number in range(3 if count else 1)])
        worlds += found.worlds
        clash = max(clash, found.clash)
    return Manner(tuple(worlds), clash)


def moving_after(rig: Rig, event: Event, before: World, state: State | None, put: Told) -> Moving:
    """How all can move just after a blow."""
    stance = stance_kept(rig, before.stance, Lines(rig, state, put))
    return Moving(stance, struck_bodies(Efforts(stance), event, before.now))


def stance_kept(rig: Rig, before: Stance, lines: Lines) -> Stance:
    """All bodies as they stood, with what another state tells; what leans and was spoken of by its tilt has one still."""
    lines.nodding = {name for name in rig.bodies if before.lines.nods(name) and off_upright(before, name)}
    stance = Stance(rig, lines)
    met = [
        joint
        for joint in rig.joints.values()
        if joint.owner not in before.rig.joints and joint.carrier.owner in rig.bodies
    ]
    for name in rig.bodies:
        stance.put(
            name, before.turned(name), None if met else before.place(name)
        )  # where bodies meet one tells where the other is
        joint = rig.main(name)
        if joint is not None and (joint.turning or rig.line(name) is not None):
            stance.swung[name] = before.swung[name] if name in before.swung else before.angle(joint)
    return stance


def off_upright(stance: Stance, name: str) -> bool:
    """Whether the axis of a body is not upright, so that it has a line of nodes."""
    return arrow_length(crossed(Z, stance.nodes(name).third)) > TINY


def struck_bodies(efforts: Efforts, event: Event, before: Rates) -> Iterator[Tie]:
    """m v′ = m v + Σ J and I ω′ = I ω + Σ r × J of all bodies."""
    rig, stance = efforts.rig, efforts.stance
    found = event.blow_in_space()
    blow = STILL if found is None else scaled(rig.value(found[1]), way_along(rig, found[2]))
    for name in rig.bodies:
        own, tensor, omega = rig.solid(name), efforts.tensor(name), before.arrow(TURNING, name)
        travel: Terms = [((-own.mass, (SPEED, name, k)),) for k in range(3)]
        turning: Terms = [tuple((-tensor[k][n], (TURNING, name, n)) for n in range(3)) for k in range(3)]
        for item in efforts.on(name):
            travel = added_terms(travel, item.forced())
            turning = added_terms(added_terms(turning, lever(item)), item.twisted())
        struck = found is not None and found[0].owner == name
        push = blow if struck else STILL
        twist = crossed(stance.arm(found[0]), blow) if found is not None and struck else STILL
        momentum = scaled(own.mass, before.arrow(SPEED, name))
        yield from three_ties(travel, scaled(-1.0, sum_of(momentum, push)), None)
        yield from three_ties(turning, scaled(-1.0, sum_of(times_arrow(tensor, omega), twist)), None)
    for joint in rig.joints.values():
        for tie in efforts.unforced(joint):
            yield Tie(tie.terms, 0.0, None)
    for tie in efforts.unaimed():
        yield Tie(tie.terms, 0.0, None)
