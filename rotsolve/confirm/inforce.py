"""InForce: what of a scene acts at one of its states, read from the order of its states and events."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from msgspec.structs import replace

from rotsolve.elements.asked import is_touch
from rotsolve.elements.connections.supports import Axle, Hinge
from rotsolve.elements.shapes import shape_of
from rotsolve.language.bodies import Body
from rotsolve.language.elements import Action, Connection, Event
from rotsolve.language.problem import Condition, Problem, State

OWN = ("mass", "inertia", "gyration", "radius", "length")


class InForce:
    """What acts at a state, and in the phase that it starts: bodies with their data, connections, actions, the events before it."""

    def __init__(self, problem: Problem, state: str) -> None:
        self.problem = problem
        self.states = problem.states or (State(""),)
        names = [item.name for item in self.states]
        self.order = {name: index for index, name in enumerate(names)}
        self.index = self.order.get(state, 0)
        self.state = self.states[self.index]
        self.past = [event for event in problem.events if self.order.get(event.to or "", 0) <= self.index]
        self.lifted: dict[
            str, list[Connection]
        ] = {}  # by event: the contacts of what goes round with another from then on
        self.gone = self._gone()
        self.connections = self._connections()
        self.actions = tuple(item for item in problem.actions if self._acts(item))
        self.bodies = {body.name: self._body(body) for body in problem.bodies}

    def _gone(self) -> frozenset[str]:
        """What events have taken away, or have yet to begin; what the phase does without that follows, else that which ends there."""
        gone = {name for event in self.problem.events for name in event.begins()}
        passed: list[Event] = []
        for event in sorted(self.past, key=lambda event: self.order.get(event.to or "", 0)):
            self.lifted[event.name] = taken_off(
                event, passed, [item for item in self.problem.connections if item.name not in gone]
            )
            gone |= {*event.ends(self.problem.connections), *(item.name for item in self.lifted[event.name])}
            gone -= set(event.begins())
            passed.append(event)
        struck = any(self.order.get(event.from_ or "") == self.index for event in self.problem.events)
        ends = struck or self.index == len(self.states) - 1
        phases = [phase for phase in self.problem.phases if self.state.name == (phase.end if ends else phase.start)]
        return frozenset(gone.union(*(phase.without for phase in phases)))

    def _connections(self) -> tuple[Connection, ...]:
        """Those that have not been taken away, nor a body with them; of several on one fixed axle the others stay."""
        added = [item for event in self.past for item in event.adds()]
        found: list[Connection] = []
        for item in (*(item for item in self.problem.connections if item.name not in self.gone), *added):
            if type(item) is Axle and any(ref.owner not in self.gone for ref in item.axle):
                item = replace(item, axle=tuple(ref for ref in item.axle if ref.owner not in self.gone))
            if not any(ref.owner in self.gone for ref in item.touches()):
                found.append(item)
        return tuple(found)

    def _acts(self, item: Action) -> bool:
        """From its first state until before its last, save where the scene ends there."""
        begins = self.order.get(item.from_ or "", 0)
        ends = self.order.get(item.to or "", len(self.states))
        last = self.index == len(self.states) - 1
        return item.name not in self.gone and (begins <= self.index < ends or (last and self.index == ends))

    def _body(self, body: Body) -> Body:
        """The body with the data that the states up to this one give it."""
        for line in (line for state in self.states[: self.index + 1] for line in state.conditions):
            path = line.path
            if path is None or path.owner != body.name or path.point is not None or line.value is None:
                continue
            if path.quantity in OWN:
                body = with_data(body, path.quantity, line)
        return body

    def words(self) -> dict[str, str]:
        """What the state says of connections: `rolls`, `slips`, `slack`, …"""
        lines = (line for line in self.state.conditions if line.word is not None)
        return {line.owner or (line.path.owner if line.path is not None else ""): line.word or "" for line in lines}

    def joined(self) -> list[Event]:
        """The events by which bodies have become one."""
        return [
            event for event in self.past if event.joined() and not self.gone & {ref.owner for ref in event.joined()}
        ]


def taken_off(event: Event, passed: Sequence[Event], present: Sequence[Connection]) -> list[Connection]:
    """The contacts of what an event joins to a body that turns on a hinge or an axle: it goes round with that, off what it lies on."""
    links = [[ref.owner for ref in item.joined()] for item in (*passed, *present) if item.joined()]
    contacts = [item for item in present if is_touch(item)]
    lying = {item.lying() for item in contacts}
    turning = set()
    for item in present:
        refs = item.hinge if isinstance(item, Hinge) else item.axle if isinstance(item, Axle) else ()
        owners = [ref.owner for ref in refs]
        onto = lying.intersection(owners) or isinstance(item, Axle) or len(owners) == 1
        turning |= set(owners if onto else owners[1:])
    groups = []
    for ref in event.joined():
        group, size = {ref.owner}, 0
        while size < len(group):
            size = len(group)
            group |= {name for link in links if group.intersection(link) for name in link}
        groups.append(group)
    for own, other in (groups, groups[::-1]) if groups else ():
        if other & turning and not other & lying:
            return [item for item in contacts if item.lying() in own]
    return []


def with_data(body: Body, word: str, line: Condition) -> Body:
    """The body with one of its data as a state gives it."""
    shape = shape_of(body)
    changes: Mapping[str, Any]
    if word in ("radius", "length") and getattr(shape, word, None) is not None:
        changes = {"shape": replace(shape, **{word: line.value})}
    elif word in ("inertia", "gyration"):
        changes = {"inertia": None, "gyration": None, "inertia_about": None, word: line.value}
    else:
        changes = {word: line.value}
    return replace(body, **changes)
