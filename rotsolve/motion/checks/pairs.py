"""Pairs: what can be joined to what: different bodies, once, with a rim where one is needed."""

from __future__ import annotations

from collections.abc import Mapping

from rotsolve.core.faults import Unsolvable
from rotsolve.elements.connections import String, Weld
from rotsolve.elements.connections.contacts.touch import Touch
from rotsolve.elements.events import Collides, Joins
from rotsolve.elements.rims import rim_radius, shape_of
from rotsolve.language.problem import Body, PointRef, Problem


def check_pairs(problem: Problem, bodies: Mapping[str, Body]) -> None:
    """Only a string touches one body twice, and what is joined already is not joined again."""
    joined: list[tuple[PointRef, ...]] = []
    for item in problem.connections:
        for ref in item.touches() if item.bodily else ():
            if ref.owner not in bodies:
                raise Unsolvable(f"`{item.word}` joins bodies, and `{ref.owner}` is none", span=ref.span)
            body = bodies[ref.owner]
            if item.rimmed and rim_radius(body, ref.point) is None and "rim" not in shape_of(body).points:
                raise Unsolvable(f"`{ref.owner}` has no radius on which a {item.word} could run", span=ref.span)
        if not isinstance(item, String):
            check_distinct(item.touches(), bodies)
        if isinstance(item, Weld):
            joined.append(item.weld)
    for event in problem.events:
        met = event.joins if isinstance(event, Joins) else event.collides if isinstance(event, Collides) else ()
        for ref in met:
            if ref.owner not in bodies:
                raise Unsolvable(f"`{event.word}` is about two bodies, and `{ref.owner}` is none", span=ref.span)
        check_distinct(met, bodies)
        if isinstance(event, Joins):
            joined.append(met)
    whole: dict[str, frozenset[str]] = {}
    for first, second in joined:
        one, other = (whole.get(ref.owner, frozenset((ref.owner,))) for ref in (first, second))
        if one & other & bodies.keys():
            raise Unsolvable(f"`{first.owner}` and `{second.owner}` are joined already", span=second.span)
        whole.update(dict.fromkeys(one | other, one | other))


def check_stacks(problem: Problem, bodies: Mapping[str, Body]) -> None:
    """What lies on a body does not carry it as well."""
    below: dict[str, str] = {}
    for item in problem.connections:
        if not isinstance(item, Touch):
            continue
        top, under = item.pair()[:2]
        if under.owner not in bodies:
            continue
        below.setdefault(top.owner, under.owner)
        name, passed = under.owner, {top.owner}
        while name in below and name not in passed:
            passed.add(name)
            name = below[name]
        if name in passed:
            raise Unsolvable(f"`{top.owner}` and `{under.owner}` lie on each other", span=under.span)


def check_distinct(points: tuple[PointRef, ...], bodies: Mapping[str, Body]) -> None:
    """Points of different bodies."""
    if len(points) < 2:
        return
    seen: set[str] = set()
    for ref in points:
        if ref.owner in seen and ref.owner in bodies:
            help = "name two bodies, or `ground`"
            raise Unsolvable(f"`{ref.owner}` is connected to itself", span=ref.span, help=help)
        seen.add(ref.owner)
