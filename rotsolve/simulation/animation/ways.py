"""Ways: how the bodies of a scene in the plane have moved at each moment, by the numbers that its motion tells."""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct

from rotsolve.core.facts import Motion
from rotsolve.draw.paper.figure import Point, ray, shifted_by
from rotsolve.draw.plane.facts import SceneFacts
from rotsolve.draw.plane.moving import BodyWay, PlaneMotion
from rotsolve.draw.plane.places.stage import PlaneStage
from rotsolve.motion.instant import Instant
from rotsolve.simulation.animation.reading import MotionReading
from rotsolve.simulation.system import PlanarSystem

TURNED = ("angle", "rotation")


class Host(Struct, frozen=True):
    """A body that stands for itself and all that is one with it: what tells its turn and its way."""

    name: str
    motion: Motion
    sense: int
    orbit: str = ""  # the contact whose angle tells where on a circle it is
    radius: float = 0.0


class PlaneMoments:
    """Tells the moments of a motion to a stage, whose places are the first ones."""

    def __init__(self, reading: MotionReading) -> None:
        self.reading = reading

    def __call__(self, stage: PlaneStage) -> PlaneMotion:
        system = self.reading.run.regimes[0].system
        assert isinstance(system, PlanarSystem)
        known = SceneFacts(stage)
        there = {body.name for body in system.moment.configuration.problem.bodies}
        names = {name: system.moment.host(name) for name in stage.bodies if name in there}
        hosts = {host: host_of(host, system.moment, known) for host in dict.fromkeys(names.values())}
        about = {host: stage.bodies[host].spot(known.arrow(system.moment.frame(host).reference)) for host in hosts}
        ways = []
        for number in range(len(self.reading.times)):
            own = {host: self.gone(item, number, known) for host, item in hosts.items()}
            ways.append({name: BodyWay(about[host], *own[host]) for name, host in names.items()})
        return PlaneMotion(ways, list(self.hanging(stage)), list(self.holding()), self.event())

    def gone(self, host: Host, number: int, known: SceneFacts) -> tuple[Point, float]:
        """How far the point has gone of which a body's motion is told, and how far the body has turned."""
        turn = self.since(f"{host.name}.angle", number)
        if turn is None:
            turn = host.sense * (self.since(f"{host.name}.rotation", number) or 0.0)
        if host.orbit:
            first, now = (self.reading.value(f"{host.orbit}.angle", k) or 0.0 for k in (0, number))
            return shifted_by(ray(now, host.radius), ray(first, host.radius), -1.0), turn
        if host.motion.kind == "line" and host.motion.heading is not None:
            size = self.since(f"{host.name}.position", number) or 0.0
            return ray(known.number(host.motion.heading.formula()), size), turn
        x, y = (self.since(f"{host.name}.position.{axis}", number) or 0.0 for axis in "xy")
        return (x, y), turn

    def since(self, name: str, number: int) -> float | None:
        """How much a quantity has changed since the first moment; None of one that the motion does not tell."""
        first, now = self.reading.value(name, 0), self.reading.value(name, number)
        return None if first is None or now is None else now - first

    def hanging(self, stage: PlaneStage) -> Iterator[dict[str, float]]:
        """How much of each rope hangs in front."""
        for number in range(len(self.reading.times)):
            found = ((item.name, self.reading.value(f"{item.name}.length", number)) for item in stage.kinds.ropes)
            yield {name: size for name, size in found if size is not None}

    def holding(self) -> Iterator[frozenset[str]]:
        """The names of the connections that there are at each moment."""
        for time in self.reading.times:
            system = self.reading.regime(time).system
            assert isinstance(system, PlanarSystem)
            yield frozenset(item.name for item in system.moment.configuration.problem.connections)

    def event(self) -> str:
        """The event at which the motion ends, '' where it ends at none."""
        run = self.reading.run
        reached = run.events[-1].state if run.events else ""
        return next((event.name for event in run.problem.events if reached and event.from_ == reached), "")


def host_of(name: str, moment: Instant, known: SceneFacts) -> Host:
    """What tells the motion of a body."""
    motion, orbit = moment.motion(name), moment.orbit(name)
    if orbit is not None and motion.bend is not None:
        return Host(name, motion, moment.sense(name), orbit.owner, known.number(motion.bend.radius))
    return Host(name, motion, moment.sense(name))
