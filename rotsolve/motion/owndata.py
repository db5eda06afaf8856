"""Own data: mass, size and moment of inertia of each body at each state, where the states say that they differ."""

from __future__ import annotations

from collections.abc import Container, Sequence
from typing import TYPE_CHECKING

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.core.faults import Unsolvable
from rotsolve.elements.shapes import rim_radius, shape_of
from rotsolve.language.noted import read_all

if TYPE_CHECKING:
    from rotsolve.algebra.formula import Formula
    from rotsolve.language.problem import Body, Condition, State

OWN = ("mass", "inertia", "gyration", "radius", "length")


class Version(Struct, frozen=True):
    """A body as it is from a state on; `since` is empty for one that never changes."""

    body: Body
    since: str = ""


def versions(
    bodies: Sequence[Body], states: Sequence[State], laid: Container[str] = ()
) -> dict[str, dict[str, Version]]:
    """By state and name: what a state says of a body's own data holds from there on; bodies `laid` out lose mass with their radius."""
    whole = {body.name: body for body in bodies}
    current = {body.name: Version(body) for body in bodies}
    result = {}
    for number, state in enumerate(states):
        for line in state.conditions:
            if is_own(line, current):
                assert line.path is not None and line.value is not None
                name = line.path.owner
                changed = with_data(current[name].body, line.path.quantity, line.value, line)
                if name in laid:
                    changed = wound_up(changed, whole[name], line)
                if changed != current[name].body:
                    current[name] = Version(changed, state.name if number else "")
        result[state.name] = dict(current)
    return result


def wound_up(roll: Body, whole: Body, line: Condition) -> Body:
    """The roll with the mass M (r/R)² that it still has at its radius r."""
    radius, first = rim_radius(roll, None), rim_radius(whole, None)
    if line.path is None or line.path.quantity != "radius" or radius is None or first is None or whole.mass is None:
        message = f"of `{whole.name}`, which unrolls, a state can only give the `radius`"
        raise Unsolvable(message, span=line.span, help="its mass is as the square of that")
    return replace(read_all(roll), mass=simplify(whole.mass * (radius / first) ** 2))


def is_own(line: Condition, bodies: Container[str]) -> bool:
    """Whether a line of a state gives own data of one of the bodies."""
    path = line.path
    if path is None or line.value is None or path.point is not None:
        return False
    return path.owner in bodies and path.quantity in OWN


def with_data(body: Body, word: str, value: Formula, line: Condition) -> Body:
    """The body with one of its data replaced."""
    shape = shape_of(body)
    if body.parts or body.holes:
        help = "give it as one body with its `inertia` at each state"
        raise Unsolvable(f"`{body.name}` has parts, whose data can't differ between states", span=line.span, help=help)
    if word == "mass" and body.mass is not None:
        return replace(read_all(body), mass=value)
    if word == "inertia":
        return replace(read_all(body), inertia=value, gyration=None, inertia_about=None)
    if word == "gyration":
        return replace(read_all(body), gyration=value, inertia=None, inertia_about=None)
    if word in ("radius", "length") and getattr(shape, word, None) is not None:
        return replace(read_all(body), shape=replace(read_all(shape), **{word: value}))
    if word == "radius" and body.radius is not None:
        return replace(read_all(body), radius=value)
    help = "say its `inertia` at each state"
    raise Unsolvable(f"`{body.name}` has no {word} that could differ between states", span=line.span, help=help)
