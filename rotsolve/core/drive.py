"""Drive: a motion that is given and not caused: a coordinate of a body, its rate or its acceleration, as a formula of `time`."""

from __future__ import annotations

from functools import lru_cache

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate, in_powers
from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import Formula, negate
from rotsolve.core.faults import Span, Unsolvable
from rotsolve.core.symbols import TIME, pace_of
from rotsolve.core.vectors.heading import Heading

TURNING = ("angle", "angular_velocity", "angular_acceleration")
TRAVELLING = ("position", "velocity", "acceleration")
BY_INERTIA = ("angular_momentum", "kinetic_energy")  # of a turn, by which the moment of inertia tells its rate


class Drive(Struct, frozen=True):
    """What is given of a body: one of the words of TURNING, or of TRAVELLING with the component x or y.

    An angle counts counterclockwise; its rates, given or worked out, count along the body's positive turn `sense`. A rate may be `told`
    by what inertia makes of it: a momentum or a kinetic energy, with its formula of `time`.
    """

    owner: str
    body: str
    word: str
    function: Formula
    component: str = ""
    sense: int = 1
    told: tuple[str, Formula] | None = None

    @property
    def kinds(self) -> tuple[str, str, str]:
        """The coordinate, its rate and its acceleration."""
        return TURNING if self.word in TURNING else TRAVELLING

    @property
    def order(self) -> int:
        """0 where the coordinate is given, 1 for its rate, 2 for its acceleration."""
        return self.kinds.index(self.word)

    def rates(self) -> dict[str, Formula]:
        """What is given and all that differentiation makes of it: ω = dθ/dt, α = dω/dt."""
        found, current = {self.word: self.function}, self.function
        for word in self.kinds[self.order + 1 :]:
            current = derivative(current)
            if word == "angular_velocity" and self.sense < 0:
                current = negate(current)
            found[word] = current
        return found

    @property
    def holds_still(self) -> bool:
        """Whether what is given is that it does not move: an angle that stays, an angular velocity of nothing."""
        return self.order < 2 and is_zero(self.rates()[self.kinds[1]])

    @property
    def pace(self) -> str:
        """How the acceleration varies (see core.symbols)."""
        return pace_of(self.rates()[self.kinds[2]])


@lru_cache(256)  # each moment asks it of the same few functions
def derivative(function: Formula) -> Formula:
    """df/dt, a polynomial by its powers: 2 c t + 3 d t²."""
    return in_powers(simplify(differentiate(function, TIME)), TIME)


def along_line(drives: tuple[Drive, ...], way: Heading, span: Span | None) -> tuple[Drive, ...]:
    """Prescribed components as one motion along a body's line of travel."""
    parts = {(drive.word, drive.component): drive for drive in drives}
    result = [drive for drive in drives if not drive.component]
    for (word, component), drive in parts.items():
        if component == "x":
            x, y = drive.function, parts[word, "y"].function
            if not is_zero(y * way.cos() - x * way.sin()):
                said = f"the prescribed `{word}` of `{drive.body}` is not along the line on which it moves"
                raise Unsolvable(said, span=span, help="leave out `moves` for a body that moves freely in the plane")
            function = in_powers(simplify(x * way.cos() + y * way.sin()), TIME)
            result.append(replace(drive, function=function, component=""))
    return tuple(result)
