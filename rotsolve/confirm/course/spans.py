"""Spans: what comes together from one state to a later one: time, way, angle, work and impulse, as integrals along the course."""

from __future__ import annotations

import math
from collections.abc import Callable

from msgspec import Struct

from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.course.elements import last_body, loads, on_body, power
from rotsolve.confirm.course.elements import torque as torque_of
from rotsolve.confirm.course.following import Course
from rotsolve.confirm.course.mechanics import power as power_on
from rotsolve.confirm.course.node import Node
from rotsolve.confirm.course.reading import Reckoned, component_of, motion, number, point_place, rates, scalar, values
from rotsolve.confirm.sides import gone_down, on_side
from rotsolve.language.problem import Path, Term


class Between(Struct, frozen=True):
    """What lies between two states."""

    course: Course
    start: str
    end: str

    @property
    def ends(self) -> tuple[Node, Node]:
        return self.course.node(self.start), self.course.node(self.end)

    def sum(self, rate: Callable[[Node], float]) -> Reckoned:
        """∫ rate dt along the course, with the size of what was added."""
        whole, size = self.course.integral(self.start, self.end, rate)
        return number(whole, size)


def time(span: Between, term: Term) -> Reckoned:
    return number(span.course.time(span.start, span.end))


def displaced(span: Between, term: Term) -> Reckoned:
    """How far a point has come: along the line of travel of its body, or as a vector."""
    path = term.path
    first, last = span.ends
    if path.owner not in first.model.seats and (item := on_side(path.owner, first.model)) is not None:
        return span.sum(lambda at: gone_down(item, at.pose, at.model).rate)
    if path.owner not in first.model.seats:
        raise NotConfirmed(f"the displacement of `{path.owner}`")
    pairs = [(first, last), *((met, before) for before, met in span.course.brought(span.start, span.end))]
    way = (0.0, 0.0)
    for pair in pairs:
        before, after = (values(point_place(at, path.owner, path.point, path.argument)) for at in pair)
        way = (way[0] + after[0] - before[0], way[1] + after[1] - before[1])
    line = first.line(path.owner) if path.point is None else None
    circle = first.orbit_centre(path.owner) if path.point is None else None
    led = line is not None and last.line(path.owner) not in (
        line,
        None,
    )  # along another line since something on the way
    if (circle is not None or led) and path.component is None:
        return span.sum(lambda at: scalar(rates(point_place(at, path.owner, "cm")), at.line(path.owner) or (0.0, 0.0)))
    if line is not None and path.component is None:
        return number(scalar(way, line), math.hypot(*way))
    return component_of(way, path.component)


def turned_angle(span: Between, term: Term) -> Reckoned:
    """The angle turned along the positive turn; of a connection, of its last body against its first."""
    name, first, last = term.path.owner, *span.ends
    if name in first.model.seats:
        return number((turn_of(last, name) - turn_of(first, name)) * first.model.sense(name), 1.0)
    from rotsolve.confirm.course.elements import element

    item = element(first, name)
    between = item.between() if hasattr(item, "between") else ()
    if between:
        gaps = [turn_of(at, between[1].owner) - turn_of(at, between[0].owner) for at in (first, last)]
        return number((gaps[1] - gaps[0]) * first.model.sense(between[1].owner), 1.0)
    body = last_body(first, name)
    return number((turn_of(last, body) - turn_of(first, body)) * first.model.sense(body), 1.0)


def turn_of(at: Node, name: str) -> float:
    return at.pose.turn(name).value


def turns(span: Between, term: Term) -> Reckoned:
    return number(turned_angle(span, term).number / (2 * math.pi), 1.0)


def total_rotation(span: Between, term: Term) -> Reckoned:
    return span.sum(lambda at: abs(at.pose.turn(term.path.owner).rate))


def total_turns(span: Between, term: Term) -> Reckoned:
    return number(total_rotation(span, term).number / (2 * math.pi), 1.0)


def way_covered(span: Between, term: Term) -> Reckoned:
    """The length of the way, both ways added."""
    path = Path(term.path.owner, "velocity", term.path.point, term.path.argument)
    return span.sum(lambda at: math.hypot(*motion(at, path)))


def work(span: Between, term: Term) -> Reckoned:
    """∫ of the power of all forces on a body, of its weight, or of what an element does to all that it touches."""
    path, blow = term.path, span.course.blow(span.start, span.end)
    if blow is not None and any(event.name == path.owner for event in blow.event.each()):
        return number(blow.work(path.owner))
    if path.owner in span.course.node(span.start).model.seats:
        return span.sum(lambda at: power_on(at, Path(path.owner, "power", component=path.component), None).number)
    return span.sum(lambda at: power(at, path, None).number if at.acts(path.owner) else 0.0)


def impulse_over_span(span: Between, term: Term) -> Reckoned:
    """In an event what the blow was on the last-named body; in a phase ∫ F dt."""
    path = term.path
    blow = span.course.blow(span.start, span.end)
    if blow is not None:
        return component_of(blow.on_last(path.owner), path.component)
    first, last = span.ends
    if path.owner in first.model.seats:
        masses = [at.model.seats[path.owner].rigid.mass for at in (first, last)]
        speeds = [rates(point_place(at, path.owner, "cm")) for at in (first, last)]
        way = (masses[1] * speeds[1][0] - masses[0] * speeds[0][0], masses[1] * speeds[1][1] - masses[0] * speeds[0][1])
        return component_of(way, path.component)
    body = last_body(first, path.owner)

    def part(axis: int) -> float:
        return span.sum(lambda at: on_body(at, body, loads(at, path.owner))[0][axis]).number

    return component_of((part(0), part(1)), path.component)


def angular_impulse(span: Between, term: Term) -> Reckoned:
    """About the axis or the centre of mass of the last-named body, along its positive turn."""
    path, blow = term.path, span.course.blow(span.start, span.end)
    if blow is not None:
        return number(blow.twist_on_last(path.owner))
    if path.owner in span.course.node(span.start).model.seats:
        raise NotConfirmed("the angular impulse on a body")
    return span.sum(lambda at: torque_of(at, path, None).number)


SPANS: dict[str, Callable[[Between, Term], Reckoned]] = {
    "time": time,
    "displacement": displaced,
    "rotation": turned_angle,
    "turns": turns,
    "total rotation": total_rotation,
    "total turns": total_turns,
    "distance": way_covered,
    "work": work,
    "impulse": impulse_over_span,
    "angular_impulse": angular_impulse,
}
