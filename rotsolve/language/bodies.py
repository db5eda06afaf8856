"""Bodies and their points, as a scene declares them: the records that elements speak of. No physics."""

from __future__ import annotations

from msgspec import Struct

from rotsolve.algebra.formula import Formula
from rotsolve.core.faults import Span
from rotsolve.language.shape import Shape


class PointRef(Struct, frozen=True):
    """A point by name: `rod.end` (owner `rod`, point `end`), `rod.at(x)` (argument x), a body or surface alone (point None).

    `owner` is a body, a surface, `ground` or `ceiling`; or empty with `place` = (x, y), a fixed place in space.
    """

    owner: str
    point: str | None = None
    argument: Formula | None = None
    place: tuple[Formula, Formula] | None = None
    span: Span | None = None


class Body(Struct, frozen=True):
    """A rigid body. `shape` is one of elements.shapes or None; sizes not given are None (an automatic letter later).

    `moved` is a motion that is prescribed: words such as `velocity`, their component ('' for a turn), formulas of `time`.
    """

    name: str
    shape: Shape | None = None
    mass: Formula | None = None
    density: Formula | None = None
    inertia: Formula | None = None
    inertia_about: str | None = None
    gyration: Formula | None = None
    radius: Formula | None = None
    radii: tuple[tuple[str, Formula], ...] = ()
    parts: tuple[Part, ...] = ()
    holes: tuple[Part, ...] = ()
    points: tuple[tuple[str, tuple[Formula, ...]], ...] = ()
    count: int = 1
    moves: str | None = None
    turns: str | None = None
    span: Span | None = None
    moved: tuple[tuple[str, str, Formula], ...] = ()


class Part(Struct, frozen=True):
    """A part or hole of a composite body: a body placed at `at` (its centre), or a rod from `start` to `end`; `angle` turns it.

    A third coordinate of `at`, as of a body's `points`, is the height above the picture.
    """

    body: Body
    at: tuple[Formula, ...] | None = None
    start: tuple[Formula, Formula] | None = None
    end: tuple[Formula, Formula] | None = None
    angle: Formula | None = None
