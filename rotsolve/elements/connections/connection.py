"""Connection: base of all that joins bodies; the questions that the motion of bodies and the laws ask of it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, ClassVar

from msgspec import Struct

from rotsolve.algebra.formula import Formula
from rotsolve.core.facts import Couple, Force, Potential, Requirement, Rule, Turntable
from rotsolve.core.vectors.heading import Heading
from rotsolve.language.keys import Element
from rotsolve.language.problem import Body, PointRef

if TYPE_CHECKING:
    from rotsolve.motion.configuration import Configuration
    from rotsolve.motion.instant import Instant

Fact = Force | Couple | Rule | Requirement | Potential | Turntable


class Orbit(Struct, frozen=True):
    """The circle on which a connection makes a body's centre travel; the angle of `owner` tells where on it the body is.

    `radius` is None on a track of which only heights are known; `level` is the height of the circle's centre; `way` is +1 where the
    positive travel goes counterclockwise.
    """

    owner: str
    radius: Formula | None
    level: Formula
    way: int
    words: str


class Connection(Element, frozen=True):
    """Base of all connections. `quantities` can be asked of it; `words` can be said of it in a state.

    `independent` marks one that holds several bodies without making one move with the other, `bodily` one that joins bodies alone and
    nothing that is fixed, `rimmed` one that runs on the rims of wheels. `kept` are its quantities that an event leaves as they were.
    """

    word: ClassVar[str] = ""
    about: ClassVar[str] = ""
    quantities: ClassVar[tuple[str, ...]] = ()
    words: ClassVar[tuple[str, ...]] = ()
    later: ClassVar[bool] = False
    independent: ClassVar[bool] = False
    bodily: ClassVar[bool] = False
    rimmed: ClassVar[bool] = False
    kept: ClassVar[tuple[str, ...]] = ()
    name: str = ""

    def touches(self) -> tuple[PointRef, ...]:
        """All points that the connection names."""
        found: tuple[PointRef, ...] = ()
        for field in self.pointed:
            found += getattr(self, field)
        return found

    def between(self) -> tuple[PointRef, ...]:
        """The two bodies, if any, whose turning against each other its angles and angular velocities are."""
        return ()

    def brakes(self) -> tuple[PointRef, ...]:
        """Bodies against whose turn it rubs, whichever way that is."""
        return ()

    def fixed_points(self) -> tuple[PointRef, ...]:
        """Points of bodies that it holds to the ground, so that the body turns about them."""
        return ()

    def track(self, body: Body, configuration: Configuration, state: str) -> tuple[Heading, str] | None:
        """Line along which it makes a body travel, with the words for the positive sense."""
        return None

    def orbit(self, body: Body, configuration: Configuration, state: str) -> Orbit | None:
        """Circle along which it makes a body's centre travel."""
        return None

    def hangs(self, body: Body) -> bool:
        """Whether a body hangs from it, so that it travels up and down."""
        return False

    def lays(self, body: Body) -> bool:
        """Whether a body lays itself out along it, layer by layer, so that less and less of it is left to move."""
        return False

    def weighs(self, body: Body) -> bool:
        """Whether it states the weight of a body, part by part."""
        return False

    def natural_turn(self, body: Body, configuration: Configuration, state: str) -> int:
        """Positive turn of a body that goes with its positive travel: +1 counterclockwise, −1 clockwise, 0 no matter."""
        return 0

    def pace(self, configuration: Configuration, state: str) -> str:
        """How its forces and rules vary while bodies move (see core.varying)."""
        return "constant"

    def prescribes(self) -> Iterator[tuple[str, str, str, Formula]]:
        """Motions that it forces on bodies: (body, word, component, formula of `time`)."""
        return iter(())

    def facts(self, instant: Instant) -> Iterator[Fact]:
        """The forces, couples, rules and requirements that it adds at a moment."""
        return iter(())
