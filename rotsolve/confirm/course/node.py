"""Node: one instant of the course of a scene, with all that the assembly knows of it, each worked out when someone asks."""

from __future__ import annotations

import math
from collections.abc import Container, Sequence
from functools import cached_property
from typing import TYPE_CHECKING

from rotsolve.confirm import NotConfirmed, OverBudget
from rotsolve.confirm.bodies import is_round
from rotsolve.confirm.instant import BACK, FORWARD, Dynamics, Placed, moment
from rotsolve.confirm.jet import Jet, Slope
from rotsolve.confirm.lines import bent, circle_of, left_from, on_curve, onward
from rotsolve.confirm.model import Model
from rotsolve.confirm.pose import Pair, Pose, Way
from rotsolve.confirm.sides import from_middle
from rotsolve.elements.asked import is_spring, is_torsion
from rotsolve.elements.connections.supports import Rides
from rotsolve.language.problem import Term

if TYPE_CHECKING:
    from rotsolve.elements.connections.springs import Torsion
    from rotsolve.elements.connections.touch import Touch

Load = tuple[str, str, Slope]
NUDGE = 1e-9  # m/s² of what is pushed by rounding alone, beside gravity


class Astray(NotConfirmed):
    """A state to which the motion does not come as the scene says, so that what is answered of it is wrong."""


class Budget:
    """How much a scene may cost: so many instants of one body, of which a larger scene costs more. Clocks would make answers differ.

    What is spent of a `portion` is spent of the whole too.
    """

    def __init__(self, instants: float, whole: Budget | None = None) -> None:
        self.left, self.whole = float(instants), whole

    def portion(self, most: int) -> Budget:
        return Budget(min(most, self.left), self)

    def spend(self, model: Model) -> None:
        self.left -= 0.5 + 0.5 * len(model.seats)
        if self.whole is not None:
            self.whole.left -= 0.5 + 0.5 * len(model.seats)
        if self.left < 0:
            raise OverBudget("its motion takes too long to follow")


def check_turns(model: Model, changes: Sequence[float], open_: Container[int]) -> None:
    """Raises NotConfirmed where something would turn a body that just goes along a line: nothing tells whether it may."""
    for name in model.guided:
        body, turn = model.body(name), model.seats[name].turn
        turns = body.turns is not None or is_round(body) or turn in open_
        if not turns and abs(changes[turn]) > 1e-9 * max(map(abs, changes)):
            raise NotConfirmed(f"what keeps `{name}` from turning the scene does not tell")


class Node:
    """Places and rates at an instant, in what acts there; `modes` say how what may slip behaves, where that is known.

    `settled` is a place that nothing tells but the balance of forces.
    """

    settled = False

    def __init__(self, model: Model, placed: Placed, budget: Budget, modes: dict[str, str] | None = None) -> None:
        self.model, self.placed, self.modes, self.budget = model, placed, modes, budget

    @property
    def time(self) -> float:
        return self.placed.time

    @cached_property
    def pose(self) -> Pose:
        return self.placed.pose(self.model)

    @cached_property
    def moment(self) -> Dynamics:
        """Accelerations and reactions."""
        self.budget.spend(self.model)
        found = moment(self.model, self.placed, self.modes)
        if found.clash:
            raise NotConfirmed("what is held can not be held together")
        check_turns(self.model, found.rates, found.open_rates)
        return found

    @property
    def pushes(self) -> list[float]:
        """q̈."""
        return self.moment.rates

    def bend(self, jet: Jet) -> float:
        """The second rate in time of a function of the places, slope · q̈ + bend."""
        rates, open_ = self.moment.rates, self.moment.open_rates
        if open_ and any(abs(part) > 1e-12 for index, part in jet.slope.items() if index in open_):
            raise NotConfirmed("nothing tells how all bodies accelerate")
        return sum([part * rates[index] for index, part in jet.slope.items()]) + jet.bend

    @property
    def adrift(self) -> bool:
        """Whether nothing tells how some mass moves, so that it was taken to be at rest."""
        return any(self.model.masses[index] > 0.0 for index in self.placed.open)

    @cached_property
    def sizes(self) -> list[tuple[str, str, float]]:
        """Reactions by owner and kind, friction that slips with them."""
        rows, found = self.moment, []
        for (owner, kind), size in rows.reactions.items():
            if (owner, kind) not in rows.open_reactions:
                found.append((owner, kind, size))
        drags = [(owner, kind, size) for owner, kind, size, _ in self.drags]
        return found + [drag for drag in drags if drag[:2] not in rows.open_reactions]

    @cached_property
    def drags(self) -> list[tuple[str, str, float, Slope]]:
        """Friction of what slips: its size along its row, and what it does along each coordinate."""
        found: list[tuple[str, str, float, Slope]] = []
        if not {FORWARD, BACK}.intersection(self.moment.modes.values()):
            return found
        for grip in self.moment.grips:
            mode = self.moment.modes.get(grip.name)
            if mode not in (FORWARD, BACK):
                continue
            size = (grip.kinetic or 0.0) * (-1.0 if mode == FORWARD else 1.0)
            if grip.normal is not None:
                size *= self.moment.reactions.get(grip.normal, 0.0)
            load = {index: size * part for index, part in grip.row.column.items()}
            found.append((grip.row.owner, grip.row.kind, size, load))
        return found

    @cached_property
    def loads(self) -> list[Load]:
        """What every element does along each coordinate, row by row."""
        rows = self.moment.rows
        found = [
            (owner, kind, {index: size * part for index, part in rows[owner, kind].column.items()})
            for (owner, kind), size in self.moment.reactions.items()
        ]
        found += [(owner, kind, load) for owner, kind, _, load in self.drags]
        slipping = {name for name, mode in self.moment.modes.items() if mode in (FORWARD, BACK)}
        for name, load in self.moment.loads.items():
            owner, _, kind = name.partition("|")
            if name not in slipping:
                found.append((owner, kind, load))
        return found

    def told(self, owner: str, *kinds: str) -> None:
        """NotConfirmed where the equations leave a reaction of an element open, of some kinds where they are named."""
        if any(name == owner and (not kinds or kind in kinds) for name, kind in self.moment.open_reactions):
            raise NotConfirmed(f"the equations of rigid bodies leave the forces of `{owner}` open")

    def acts(self, owner: str) -> bool:
        acting = self.model.acting
        return any(item.name == owner for item in (*acting.connections, *acting.actions))

    # where things are

    def line(self, name: str) -> Way | None:
        """The positive direction of a body's travel just now: along its line, or along the circle on which it goes."""
        if bent(name, self.model) is None:
            way = self.model.way(name)
            if way is not None and self.off_centre(name):
                raise NotConfirmed(f"whether the velocity of `{name}` is that of its centre or of its centre of mass")
            return None if way is not None and self.turns_with(name) else way
        return onward(name, self.pose, self.model)

    def off_centre(self, name: str) -> bool:
        """Whether a body turns whose centre of mass is off its centre, so that both go differently."""
        rigid, turn = self.model.seats[name].rigid, self.model.seats[name].turn
        return max(map(abs, rigid.centre)) > 1e-9 and is_round(rigid.body) and self.placed.speed[turn] != 0.0

    def turns_with(self, name: str) -> bool:
        """Whether a body is one with what turns about an axis, so that no line leads it any more."""
        return name not in self.model.held and any(other in self.model.held for other in self.model.joined_to(name))

    def axis(self, name: str) -> Pair | None:
        """The place about which a body turns, with all that is joined to it; None where nothing holds it."""
        held = next((other for other in self.model.joined_to(name) if other in self.model.held), None)
        return None if held is None else self.pose.place(held, self.model.axis(held))

    def orbit_centre(self, name: str) -> Way | None:
        """The centre of the circle on which a body goes."""
        return (0.0, 0.0) if bent(name, self.model) is not None else None

    def reference(self, name: str, term: Term | None) -> Way:
        """The place about which a torque or an angular momentum counts: as named, else an axis, its or its carrier's, else its cm."""
        if term is not None and term.about is not None:
            about = term.about
            if about.owner in self.model.held and about.owner not in self.model.seats:
                raise NotConfirmed(f"about `{about.owner}`")
            item = next((item for item in self.model.acting.connections if item.name == about.owner), None)
            if item is not None:
                refs = [ref for ref in item.touches() if ref.owner == name] or list(item.touches())
                about = refs[0]
            if about.owner not in self.model.seats and about.place is None:
                raise NotConfirmed(f"about `{about.owner}`")
            x, y = self.model.place(about, self.pose)
            return x.value, y.value
        rides = (ride for item in self.model.acting.connections if (ride := item.ride()) and ride.rider.owner == name)
        held = self.axis(next((ride.carrier.owner for ride in rides), name))
        x, y = held if held is not None else self.pose.place(name, self.model.seats[name].rigid.centre)
        return x.value, y.value

    def angle(self, name: str) -> float:
        """As the language counts it: of a rod its direction, else that from its hinge to its centre of mass."""
        return self.pose.turn(name).value + self.model.lean(name)

    def touching_angle(self, item: Touch) -> float:
        x, y = (part.value for part in from_middle(item, self.pose, self.model))
        return math.atan2(y, x)

    def height(self, name: str) -> float:
        """Above the centre of a dome, above the lowest place in a bowl."""
        found = on_curve(name, self.model) or left_from(name, self.model)
        if found is None:
            raise NotConfirmed(f"no level from which the height of `{name}` counts")
        above = from_middle(found[0], self.pose, self.model)[1].value
        return above + (0.0 if found[1].outside else circle_of(found, self.model))

    def carrier(self, name: str) -> str | None:
        """The body on which another rides."""
        for item in self.model.acting.connections:
            if isinstance(item, Rides) and item.rides[0].owner == name:
                return item.rides[1].owner
        return None

    # springs

    def stretched(self, owner: str) -> float:
        """How far a spring is stretched."""
        item = next((item for item in self.model.acting.connections if item.name == owner), None)
        rest = self.placed.offsets.get(owner)
        if not is_spring(item) or rest is None:
            raise NotConfirmed(f"nothing tells how far `{owner}` is stretched")
        from rotsolve.confirm.forces import spring_length

        return spring_length(item, self.pose, self.model).value - rest

    def stored(self, owner: str = "") -> float:
        """½ k e² of a spring, ½ κ θ² of a wire; of all of them."""
        whole = 0.0
        for item in self.model.acting.connections:
            if owner not in ("", item.name):
                continue
            if is_spring(item) and item.stiffness is not None:
                whole += 0.5 * self.model.value(item.stiffness) * self.stretched(item.name) ** 2
            elif is_torsion(item) and item.stiffness is not None:
                whole += 0.5 * self.model.value(item.stiffness) * self.twist(item) ** 2
        return whole

    def twist(self, item: Torsion) -> float:
        names = [ref.owner for ref in item.torsion if ref.owner in self.model.seats]
        twist = self.angle(names[-1]) - (self.angle(names[0]) if len(names) == 2 else 0.0)
        return twist - (self.model.value(item.rest_angle) if item.rest_angle is not None else 0.0)


def unpushed(at: Node) -> bool:
    """Whether all is at rest, and pushed by rounding alone: then the least push decides."""
    push = max(map(abs, at.pushes), default=0.0)
    return not any(at.placed.speed) and push < NUDGE * max(at.model.gravity, 1.0)
