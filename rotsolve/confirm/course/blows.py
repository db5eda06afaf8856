"""Blows: an event of the course, with the impulses that it took: on a body, and on the last-named one."""

from __future__ import annotations

import math

from msgspec.structs import replace

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.blow import Struck, struck
from rotsolve.confirm.course.meeting import met_through
from rotsolve.confirm.course.node import Node, check_turns
from rotsolve.confirm.instant import Placed
from rotsolve.confirm.lines import bent
from rotsolve.confirm.model import Model
from rotsolve.confirm.pose import Way
from rotsolve.confirm.seating import seated
from rotsolve.language.elements import Event


def brought(before: Node, model: Model) -> Placed:
    """The places before an event, with what it brings against a corner or a curved surface where that is."""
    q = list(before.placed.q)
    for name, seat in model.seats.items():
        if bent(name, model) is not None and bent(name, before.model) is None:
            q[seat.first : seat.turn] = seated(model)[seat.first : seat.turn]
    return replace(before.placed, q=q)


class Blow:
    """What an event did between the node before it and the one after it."""

    def __init__(self, before: Node, event: Event, model: Model) -> None:
        before.budget.spend(model)
        self.event, self.before = event, before
        self.own = (event.name, *event.begins())  # whose impulses are the event's
        self.struck: Struck = struck(model, brought(before, model), event)
        if self.struck.clash > 1e-7:
            raise NotConfirmed(f"what holds through `{event.name}` can not hold together")
        changes = [now - old for now, old in zip(self.struck.placed.speed, before.placed.speed, strict=True)]
        check_turns(model, changes, self.struck.placed.open)
        placed = self.struck.placed
        placed = replace(placed, met=met_through(before, event, model, placed.pose(model)))
        self.after = Node(model, placed, before.budget)

    @property
    def joining(self) -> Node:
        """The instant before it with what it joins where that meets: it was there, but nothing tells where it came from."""
        return Node(self.before.model, replace(self.before.placed, q=self.struck.placed.q), self.before.budget)

    def on_body(self, owner: str, body: str) -> tuple[Way, float]:
        """Impulse, and angular impulse about the centre of mass, that an element or the event gives a body."""
        if any(name == owner for name, _ in self.struck.open):
            raise NotConfirmed(f"the equations of rigid bodies leave the impulses of `{owner}` open")
        owners = self.own if owner == self.event.name else (owner,)
        first, found = self.after.model.seats[body].first, [0.0, 0.0, 0.0]
        known = [self.after.model.masses[first + k] * self.change(first + k) for k in range(3)]
        for (name, kind), size in self.struck.impulses.items():
            for k in range(3):
                part = size * self.struck.columns[name, kind].get(first + k, 0.0)
                known[k] -= part
                found[k] += part if name in owners else 0.0
        if owner in self.struck.loads:
            found = [part + self.struck.loads[owner].get(first + k, 0.0) for k, part in enumerate(found)]
        elif owner == self.event.name:  # what the event gives by itself is what no row gave
            found = [a + b for a, b in zip(found, known, strict=True)]
        return (found[0], found[1]), found[2]

    def work(self, owner: str) -> float:
        """Of the impulses of one event, by the mean of the rates before and after it."""
        if any(name == owner for name, _ in self.struck.open):
            raise NotConfirmed(f"the equations of rigid bodies leave the impulses of `{owner}` open")
        pushes = [
            (size, self.struck.columns[name, kind])
            for (name, kind), size in self.struck.impulses.items()
            if name == owner
        ]
        pushes += [(1.0, slope) for name, slope in self.struck.loads.items() if name == owner]
        speeds = list(zip(self.before.placed.speed, self.struck.placed.speed, strict=True))
        return math.fsum(
            size * part * sum(speeds[index]) / 2 for size, column in pushes for index, part in column.items()
        )

    def change(self, index: int) -> float:
        return self.struck.placed.speed[index] - self.before.placed.speed[index]

    def last(self, owner: str) -> str:
        """The body that the event, or an element, names last."""
        model = self.after.model
        items = (*model.acting.connections, *self.before.model.acting.connections)
        item = next((item for item in items if item.name == owner), None)
        event = next((event for event in self.event.each() if event.name == owner), None)
        refs = event.points(model.problem.connections) if event else item.touches() if item else ()
        named = [ref.owner for ref in refs if ref.owner in model.seats]
        if not named:
            raise NotConfirmed(f"`{owner}` gives no impulse")
        return named[-1]

    def on_last(self, owner: str) -> Way:
        """The impulse on the last-named body; of a body, all that it got."""
        model = self.after.model
        if owner in model.seats:
            first = model.seats[owner].first
            return model.masses[first] * self.change(first), model.masses[first] * self.change(first + 1)
        return self.on_body(owner, self.last(owner))[0]

    def twist_on_last(self, owner: str) -> float:
        """The angular impulse on the last-named body, about its axis or its centre of mass, along its positive turn."""
        body = self.last(owner)
        (x, y), twist = self.on_body(owner, body)
        middle = self.after.reference(body, None)
        centre = self.after.pose.place(body, self.after.model.seats[body].rigid.centre)
        arm = centre[0].value - middle[0], centre[1].value - middle[1]
        return math.fsum((twist, arm[0] * y, -arm[1] * x)) * self.after.model.sense(body)
