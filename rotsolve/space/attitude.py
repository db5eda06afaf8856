"""Attitude: the axes along which a body's vectors are written, how these stand and turn, and how the body turns in them.

Euler angles z-x-z: φ about the vertical, the tilt θ from the vertical to the body's axis e₃ about the line of nodes, ψ about e₃.
**Node axes**: e₁ along the line of nodes (level), e₂ = e₃ × e₁; they turn at Ω = θ̇ e₁ + φ̇ sin θ e₂ + φ̇ cos θ e₃, the body at Ω + ψ̇ e₃
(Landau & Lifshitz, Mechanics, §35). Space axes are at the moment those in which the line of nodes lies along x, unless φ is told.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any, Protocol

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.formula import ZERO, Formula, add, multiply, negate
from rotsolve.core.equation import Equation
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.heading import heading
from rotsolve.core.vectors.triple import (
    AS_DRAWN,
    NOTHING,
    Rows,
    Triple,
    X,
    Y,
    Z,
    after,
    cross_product,
    rotated,
    scaled_by,
    transposed,
    turn_about,
    vector_sum,
)
from rotsolve.language.bodies import Joint, PointRef
from rotsolve.language.problem import Condition, State
from rotsolve.space.arrangement import JointedBodies

SPACE, BODY, NODE = "space", "body", "node"
STANDING_HELP = "tell its `tilt` and its rates, or of a hinge its `angle`, in that state"
AXIAL = "axial"  # axes that go with a body's own axis, but do not spin with it


class Onward(Protocol):
    """What happens from an earlier moment on, in closed form (`lapse`)."""

    before: Any
    later: Any
    laws: dict[Equation, None]

    def up_to(self, further: Onward) -> Onward: ...
    def passed(self) -> Formula | None: ...
    def equations(self) -> Iterator[Equation]: ...
    def attitude(self, name: str) -> Attitude | None: ...
    def steady(self, name: str) -> bool: ...
    def told(self, name: str, word: str) -> Formula | None: ...
    def turns_freely(self, name: str) -> bool: ...
    def hinged(self, name: str) -> bool: ...
    def keeps_vertical(self, name: str) -> bool: ...
    def centre_velocity(self, name: str) -> Triple | None: ...
    def centre_way(self, name: str) -> Triple | None: ...


class TurnedBodies(Protocol):
    """A moment of a scene: how its bodies stand and turn, and what is told of them."""

    when: str
    state: State
    held: JointedBodies

    def attitude(self, name: str) -> Attitude: ...
    def axes(self, name: str) -> Axes: ...
    def own_axes(self, name: str) -> Axes: ...
    def nods(self, name: str) -> bool: ...
    def vector_told(self, owner: str, word: str, point: str | None = None) -> tuple[Triple, str, str] | None: ...
    def told_against(self, owner: str, word: str, point: str | None, frame: str) -> bool: ...
    def ask(self, word: str, owner: str, component: str = "", letter: str = "") -> Formula: ...
    def line(self, owner: str, word: str, component: str = "", point: str | None = None) -> Condition | None: ...
    def rests(self, owner: str) -> bool: ...
    def named_axes(self, axes: str, name: str) -> Axes: ...
    def driven(self, name: str, joint: Joint, word: str) -> tuple[Formula, Formula]: ...


class MovingBodies(TurnedBodies, Protocol):
    """A moment of a scene, as frames and rolling bodies see it."""

    def symmetry_axis(self, name: str) -> Triple | None: ...
    def arm(self, ref: PointRef) -> Triple: ...
    def slid_by(self, joint: Joint) -> Formula: ...
    def velocity(self, ref: PointRef) -> Triple: ...
    def acceleration(self, ref: PointRef) -> Triple: ...
    def of_centre(self, name: str, word: str) -> Triple: ...
    def rim_side(self, name: str) -> Formula: ...
    def place_in(self, name: str, frame: str) -> Triple | None: ...


class HeldBar(Protocol):
    """A bar that is held at both ends, as what asks for its points sees it."""

    def way(self) -> Triple: ...
    def share(self, spot: Triple) -> Formula: ...
    def part_way(self, spot: Triple, word: str) -> Triple: ...


class Axes(Struct, frozen=True):
    """A named set of axes at a moment: `rows` turn its components into those in space, `rate` is its angular velocity Ω in its own
    components, `change` are the rates of these; `lost` says that nothing tells how they stand.

    Of axes that are `turned` in others, `base` are the rows of those: between two in the same ones it does not matter how these stand.
    """

    name: str
    rows: Rows = AS_DRAWN
    rate: Triple = NOTHING
    change: Triple = NOTHING
    lost: str = ""
    base: Rows | None = None
    turned: Rows = AS_DRAWN

    def to(self, other: Axes, vector: Triple) -> Triple:
        """A vector of these axes in the components of others; refused where nothing tells how one of them stands."""
        if (self.rows, self.lost) == (other.rows, other.lost) or vector == NOTHING:
            return vector
        bases = [axes.rows if axes.base is None else axes.base for axes in (self, other)]
        if bases[0] == bases[1] and self.lost == other.lost:
            return rotated(transposed(other.turned), rotated(self.turned, vector))
        return rotated(transposed(other.standing), rotated(self.standing, vector))

    @property
    def standing(self) -> Rows:
        """The rows; refused where nothing tells how they stand."""
        if self.lost:
            raise Unsolvable(self.lost, help=STANDING_HELP)
        return self.rows


IN_SPACE = Axes(SPACE)


class Attitude(Struct, frozen=True):
    """How a body stands and turns: `own` turns its own components, as it is drawn, into those of `axes`, in which its inertia is constant.

    `omega` is its angular velocity ω in them, and `rates` are those of its components. `about` is the direction, in these axes, about
    which it is symmetric, where its inertia is the same about all directions across.
    """

    axes: Axes
    own: Rows
    omega: Triple
    rates: Triple
    about: Triple | None = None  # not where it is in its own axes, in which its inertia is constant anyhow

    @property
    def alpha(self) -> Triple:
        """The angular acceleration dω/dt = (rates of the components) + Ω × ω."""
        return vector_sum(self.rates, cross_product(self.axes.rate, self.omega))


class Nodding(Struct, frozen=True):
    """The Euler angles of a body, their rates, and the rates of these."""

    angles: Triple  # φ, θ, ψ
    rates: Triple
    seconds: Triple


def node_axes(turning: Nodding) -> Axes:
    """e₁ along the line of nodes, e₃ along the body's axis."""
    phi, theta, _ = turning.angles
    precession, nutation, _ = turning.rates
    further, faster, _ = turning.seconds
    cos, sin = heading(theta).cos(), heading(theta).sin()
    rate = (nutation, multiply(precession, sin), multiply(precession, cos))
    both = multiply(precession, nutation)
    change = (
        faster,
        add(multiply(further, sin), multiply(both, cos)),
        add(multiply(further, cos), negate(multiply(both, sin))),
    )
    return Axes(NODE, after(turn_about(Z, phi), turn_about(X, theta)), rate, change)


def nodding(turning: Nodding, permuted: Rows) -> Attitude:
    """A symmetric body in node axes: ω = Ω + ψ̇ e₃. `permuted` puts its axis along e₃."""
    axes = node_axes(turning)
    spin, faster = turning.rates[2], turning.seconds[2]
    omega, rates = vector_sum(axes.rate, scaled_by(spin, Z)), vector_sum(axes.change, scaled_by(faster, Z))
    return Attitude(axes, permuted, omega, rates, Z)


def in_euler_angles(turning: Nodding, permuted: Rows) -> Attitude:
    """A body without symmetry in its own axes: ω₁ = φ̇ sin θ sin ψ + θ̇ cos ψ, ω₂ = φ̇ sin θ cos ψ − θ̇ sin ψ, ω₃ = φ̇ cos θ + ψ̇."""
    in_nodes, spin = nodding(turning, permuted), turning.rates[2]
    back = transposed(turn_about(Z, turning.angles[2]))
    omega = rotated(back, in_nodes.omega)
    rates = vector_sum(
        rotated(back, in_nodes.rates), cross_product(omega, scaled_by(spin, Z))
    )  # (d/dt) R⁻¹ v = R⁻¹ v̇ − ψ̇ e₃ × R⁻¹ v
    rows = after(in_nodes.axes.rows, turn_about(Z, turning.angles[2]))
    return Attitude(Axes(BODY, rows, omega, rates), permuted, omega, rates)


def as_drawn(rows: Rows, omega: Triple, rates: Triple, *, lost: str = "") -> Attitude:
    """A body in its own axes, which turn with it: the rates of the components are those of ω itself."""
    return Attitude(Axes(BODY, rows, omega, rates, lost), AS_DRAWN, omega, rates)


def in_own_axes(found: Attitude, spun: Rows = AS_DRAWN) -> Attitude:
    """The same body in axes that go with it, as it is drawn, where it is `spun` on in those that it has."""
    own = after(spun, found.own)
    back, rows = transposed(own), after(found.axes.rows, own)
    return turned_in(found.axes, as_drawn(rows, rotated(back, found.omega), rotated(back, found.alpha)), own)


class HingeTurn(Struct, frozen=True):
    """How far a body is turned about its hinge, how fast, and the rate of that."""

    angle: Formula = ZERO
    rate: Formula = ZERO
    faster: Formula = ZERO


def on_axle(carrier: Attitude, direction: Triple, spin: Formula, faster: Formula, own: Rows) -> Attitude:
    """A body that is symmetric about the axle on which another carries it, in the axes of that: ω = Ω + s n."""
    seen = carrier.axes
    axes = Axes(seen.name, seen.rows, carrier.omega, carrier.alpha, seen.lost, seen.base, seen.turned)
    omega, rates = (
        vector_sum(carrier.omega, scaled_by(spin, direction)),
        vector_sum(carrier.alpha, scaled_by(faster, direction)),
    )
    return Attitude(axes, own, omega, rates, direction)


def hinged_on(carrier: Attitude, drawn: Rows, direction: Triple, turn: HingeTurn) -> Attitude:
    """A body on a hinge of another one, in its own axes: drawn so in those of that, turned on about the hinge, which lies along a
    direction in its own axes: ω = Ω + s n, α = dΩ/dt + ṡ n + Ω × s n."""
    inward = after(turn_about(direction, negate(turn.angle)), transposed(drawn))
    swept, relative = rotated(inward, carrier.omega), scaled_by(turn.rate, direction)
    alpha = vector_sum(
        rotated(inward, carrier.alpha), scaled_by(turn.faster, direction), cross_product(swept, relative)
    )
    rows = after(after(carrier.axes.rows, drawn), turn_about(direction, turn.angle))
    found = as_drawn(rows, vector_sum(swept, relative), alpha)
    return turned_in(carrier.axes, found, after(drawn, turn_about(direction, turn.angle)))


def turned_in(axes: Axes, found: Attitude, rows: Rows) -> Attitude:
    """What is turned so in axes of which nothing tells how they stand, which is not known of it either; other things as they are."""
    if not axes.lost:
        return found
    base = axes.rows if axes.base is None else axes.base
    return replace(found, axes=replace(found.axes, lost=axes.lost, base=base, turned=after(axes.turned, rows)))


def permutation(axis: Triple) -> Rows:
    """The even permutation of its own axes that puts a body's axis along e₃."""
    if axis == X:
        return (Y, Z, X)
    return (Z, X, Y) if axis == Y else AS_DRAWN


def at_rest_in(rows: Rows) -> Attitude:
    """What does not turn."""
    return Attitude(Axes(SPACE, rows), AS_DRAWN, NOTHING, NOTHING)
