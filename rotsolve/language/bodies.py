"""Bodies, their points, what they touch and how they are led, as a scene declares them: the records that elements speak of."""

from __future__ import annotations

from typing import TYPE_CHECKING, ClassVar

from msgspec import Struct

from rotsolve.core.vectors.heading import LEFT, RIGHT, UP, Heading
from rotsolve.language.keys import Element
from rotsolve.language.noted import Noted

if TYPE_CHECKING:
    from rotsolve.algebra.formula import Formula
    from rotsolve.core.faults import Span
    from rotsolve.core.vectors.tensor import InertiaTensor
    from rotsolve.language.shape import Shape


class PointRef(Struct, frozen=True):
    """A point by name: `rod.end` (owner `rod`, point `end`), `rod.at(x)` (argument x), a body or surface alone (point None).

    `owner` is a body, a surface, `ground` or `ceiling`; or empty with `place` = (x, y), a fixed place in space.
    """

    owner: str
    point: str | None = None
    argument: Formula | None = None
    place: tuple[Formula, ...] | None = None
    span: Span | None = None


class Turn(Struct, frozen=True):
    """A rotation `by` an angle `about` a direction in space, counterclockwise as seen against it."""

    about: tuple[Formula, Formula, Formula]
    by: Formula


class Body(Noted, frozen=True):
    """A rigid body. `shape` is one of elements.shapes or None; sizes not given are None (an automatic letter later).

    In space a body may have a symmetry `axis` (one of its own), a whole `tensor` (about `inertia_about`), and be `turned` from how it is
    drawn, one turn after the other about axes that stay in space.
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
    axis: tuple[Formula, ...] = ()
    tensor: InertiaTensor | None = None
    turned: tuple[Turn, ...] = ()


class Part(Struct, frozen=True):
    """A part or hole of a composite body: a body placed at `at` (its centre), or a rod from `start` to `end`; `angle` turns it.

    A third coordinate of `at`, as of a body's `points`, is the height above the picture.
    """

    body: Body
    at: tuple[Formula, ...] | None = None
    start: tuple[Formula, Formula] | None = None
    end: tuple[Formula, Formula] | None = None
    angle: Formula | None = None
    turned: tuple[Turn, ...] = ()


class Joint(Struct, frozen=True):
    """How a connection holds a body in space: `body` is the point held, at `carrier`, a point of another body or of the ground.

    The body may turn about each of `turning` and slide along each of `sliding`, directions in the axes of what carries it, freely or, by
    one about which a `drive` (angle, angular_velocity, angular_acceleration) turns it, as it is driven; `free` lets it turn about all.
    `aligned` puts its symmetry axis along the axle, instead of leaving it as it is drawn. A screw goes `pitch` along its axis in one turn.
    `bearings` are the places of two bearings along the axis. `rolls` has the body touch a surface at its lowest point, without slip;
    `flat` has it lie on one with a face, so that it slides in two directions and turns about the third. A `motor` turns the body on what
    carries it, as hard as it takes. `through` is a second point of the body that is held: it turns about the line to that.
    What is asked of a joint acts on its body; on its carrier where that is `named_last`.
    """

    owner: str
    carrier: PointRef
    body: PointRef
    turning: tuple[tuple[Formula, Formula, Formula], ...] = ()
    sliding: tuple[tuple[Formula, Formula, Formula], ...] = ()
    free: bool = False
    drive: tuple[tuple[str, Formula], ...] = ()
    aligned: bool = False
    pitch: Formula | None = None
    bearings: tuple[Formula, ...] = ()
    rolls: bool = False
    flat: bool = False
    motor: bool = False
    through: PointRef | None = None
    named_last: bool = False

    @property
    def powered(self) -> bool:
        """Whether something turns the body about the axis, so that the joint gives a couple along it."""
        return bool(self.drive) or self.motor


class Coupling(Struct, frozen=True):
    """How a connection ties how two shafts turn, each on a hinge of its own: a cross between their forks, of which one `arm` lies in that
    of the first, a direction in its own axes; the other lies square to it and to the second shaft.
    """

    owner: str
    first: PointRef
    second: PointRef
    arm: tuple[Formula, Formula, Formula]


class Surface(Element, frozen=True):
    """Base of all surfaces."""

    about: ClassVar[str] = ""
    later: ClassVar[bool] = False
    planar: ClassVar[bool] = True
    spatial: ClassVar[bool] = False
    held_at: ClassVar[str] = "point of contact"  # what the place is called at which it holds a body
    level: ClassVar[bool] = False
    slanted: ClassVar[bool] = False
    upright: ClassVar[bool] = False
    curved: ClassVar[bool] = False
    two_sided: ClassVar[bool] = False  # which holds what is on it, instead of only pushing it away
    post: ClassVar[bool] = False  # round which a rope runs, and on which nothing lies
    away: ClassVar[str] = ""  # the direction of its push in words, if not away from what its word says
    into: ClassVar[str] = "into the slope"  # the direction in which something presses on it
    name: str = ""

    @property
    def normal(self) -> Heading:
        """Direction out of the surface."""
        return UP

    def tilt(self) -> Formula | None:
        """The angle of a slope to the level."""
        return None

    def bearer(self) -> str:
        """The body of which it is a side; '' of what does not move."""
        return ""

    def height(self) -> Formula | None:
        """Height above the floor of an edge."""
        return None

    def ways(self) -> tuple[str, ...]:
        """What a body that lies on the surface may be said to move."""
        return ("left", "right")

    def travel(self, moves: str | None) -> tuple[Heading, str]:
        """Direction in which a body moves along the surface for a declared word, and how to say it."""
        word = moves if moves in ("left", "right") else "right"
        return (RIGHT if word == "right" else LEFT), word


class Orbit(Struct, frozen=True):
    """The circle on which a connection makes a body's centre travel; the angle of `owner` tells where on it the body is.

    `radius` is None on a track of which only heights are known; `level` is the height of the circle's centre; `way` is +1 where the
    positive travel goes counterclockwise; `hollow` is one inside which the body lies, which only pushes it towards the centre.
    """

    owner: str
    radius: Formula | None
    level: Formula
    way: int
    words: str
    hollow: bool = False


class Ride(Struct, frozen=True):
    """A body that a connection makes slide along another, with which it turns; one that is not `free` is held where it is."""

    owner: str
    rider: PointRef
    carrier: PointRef
    free: bool
