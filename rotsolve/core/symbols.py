"""Symbols: what the name of a symbol says, and how values vary with what such symbols stand for. Names are written and read here alone.

A quantity of the laws is a symbol whose name is its key: kind, owner, component and when; a given is a symbol with the letter that the
scene gives it, `time` is the running time, and `wheel.rotation` within a given value stands for the path of a body.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import lru_cache
from typing import TypeGuard

from msgspec import Struct

from rotsolve.algebra.formula import Formula, Symbol

TIME = "time"  # the running time, a letter of its own
VIRTUAL = "^"  # marks the velocities of a small motion that is only thought of
GENERIC = "~"  # marks the moment in the midst of a phase, at which nothing is known
REST = "="  # marks the equilibrium about which a state's bodies swing
NEAR = "≈"  # marks a moment of their swings
COURSE = "…"  # marks a moment of a motion that is followed in time: all places and speeds are letters
SPOKEN = {VIRTUAL: "any_", GENERIC: "from_", REST: "rest ", NEAR: "swing "}  # the marks in a printed letter
COMPONENT = "component"  # the kind of a component of a size and an angle that are both sought
COORDINATE = "coordinate "  # in front of the kind of a place that a page writes as a coordinate
SECOND = "rate of "  # in front of the kind of a rate: how fast that changes
MARKED = "dot"  # behind the letter of such a rate, which is printed with a dot
DOTTED = "dotted "  # in front of the kind of a coordinate: its rate, printed as that letter with a dot
PHASE = " to "  # within the name of a phase

ACROSS_AXIS = "across"  # the component of a moment of inertia about a direction across the axis of a body
MOMENTUM_SIZE = "size of the angular momentum"  # the kind of a size that is a letter: it is never negative
ASKED = "asked"  # the kind of what a question stands for and no law speaks of
ACCELERATIONS = ("acceleration", "angular_acceleration")
RATES = ("angular_velocity", "velocity")
PLACES = ("angle", "rotation", "displacement")
CONSTANT, POSITION, RATE, MIXED = "constant", "position", "rate", "mixed"  # how a value may vary, beside with TIME
UNKNOWN = "unknown"  # of what nothing is said: it may vary as it likes

_BAR = "|"


class SymbolKey(Struct, frozen=True):
    """What a symbol stands for: the `acceleration` (kind) of `block` (owner) along `x` (component), `when`: a state, a phase or ''.

    `when` may carry marks in front: of a moment in the midst of a phase or of swings, and of a motion that is only thought of.
    """

    kind: str
    owner: str
    component: str = ""
    when: str = ""

    @property
    def name(self) -> str:
        return _BAR.join((self.kind, self.owner, self.component, self.when))

    @property
    def midst(self) -> bool:
        """Whether it is of any moment in the midst of a phase, so that it may run through it."""
        return self.when.startswith(GENERIC)

    @property
    def running(self) -> bool:
        """Whether it is of such a moment, if only in a motion that is thought of."""
        return GENERIC in self.when

    @property
    def marked(self) -> bool:
        """Whether it is of another moment than a state or a phase."""
        return any(mark in self.when for mark in SPOKEN)

    @property
    def turns(self) -> bool:
        """Whether it is a rate of turning or its change."""
        return self.kind in ("angular_velocity", "angular_acceleration")


@lru_cache(maxsize=8192)
def key_of(name: str) -> SymbolKey:
    """The key in the name of a symbol; that of a plain letter has no kind."""
    parts = name.split(_BAR)
    return SymbolKey(*parts[:4]) if len(parts) > 1 else SymbolKey("", name)


def is_key(name: str) -> bool:
    """Whether a name is that of a quantity, not the letter of a given."""
    return _BAR in name


def is_quantity(value: Formula | None) -> TypeGuard[Symbol]:
    """Whether a value is the symbol of a quantity."""
    return isinstance(value, Symbol) and _BAR in value.name


def has_quantities(value: Formula) -> bool:
    """Whether a value speaks of quantities, and not of givens alone."""
    return any(_BAR in name for name in value.symbols())


def of_kinds(names: Iterable[str], kinds: Iterable[str]) -> list[str]:
    """The names of quantities of some kinds, sorted."""
    wanted = frozenset(kinds)
    return sorted(name for name in names if key_of(name).kind in wanted)


def asked_symbol(name: str) -> str:
    """The symbol of a question by the name of its answer."""
    return f"{ASKED}{_BAR}{name}"


def component_symbol(name: str, axis: str) -> str:
    """The symbol of a component of what is asked."""
    return f"{name}{_BAR}{axis}"


def coordinate_name(name: str) -> str:
    """The symbol of a coordinate within a body, along which it is cut into thin elements."""
    return _BAR + name


def is_coordinate(name: str) -> bool:
    return name.startswith(_BAR)


def phase_midst(when: str) -> str:
    """The state at which the phase starts in whose midst a moment is; '' for other moments."""
    return when[len(GENERIC) :] if when.startswith(GENERIC) else ""


def real(when: str) -> str:
    """A moment without the mark of a motion that is only thought of."""
    return when.replace(VIRTUAL, "")


def rub_key(name: str, state: str) -> str:
    """What rubs, in the phase that starts at a state: the key of its mode."""
    return f"{name}@{state}"


def rub_of(key: str) -> tuple[str, str]:
    """Name and first state of what rubs, by its key."""
    name, _, state = key.rpartition("@")
    return name, state


def at_any_time(names: Iterable[str]) -> bool:
    """Whether one of the letters of quantities is of the midst of a phase."""
    return any(key_of(name).midst for name in names)


def running(names: Iterable[str], kinds: Iterable[str] = (*PLACES, *RATES)) -> list[str]:
    """Of the letters of quantities, those of places and rates in the midst of a phase."""
    return [name for name in of_kinds(names, kinds) if key_of(name).midst]


def paths_in(value: Formula) -> Iterator[tuple[str, str, str]]:
    """The paths of bodies in a value, as (letter, body, quantity): a letter named `wheel.rotation` stands for that path."""
    for name in sorted(value.symbols()):
        owner, dot, word = name.rpartition(".")
        if dot:
            yield name, owner, word


def pace_of(value: Formula) -> str:
    """How a value varies: 'constant', with the 'time', the 'position' or the 'rate' alone, or 'mixed'."""
    kinds = [POSITION if word in PLACES else RATE for _, _, word in paths_in(value)]
    return combined([*kinds, *([TIME] if TIME in value.symbols() else [])])


def combined(paces: Iterable[str]) -> str:
    """The pace of what depends on several things."""
    kinds = set(paces) - {CONSTANT}
    if UNKNOWN in kinds:
        return UNKNOWN
    return MIXED if len(kinds) > 1 else kinds.pop() if kinds else CONSTANT
