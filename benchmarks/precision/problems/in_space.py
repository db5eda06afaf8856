"""Bodies in space, in the variables that suit integrators best: no angles where vectors do, nothing that is not asked for."""

from __future__ import annotations

from typing import Any

from ..peers.integrators import INTEGRATORS
from ..problem import Mathematics, Motion, Problem, Rates, State

VECTORS = {name: way for name, way in INTEGRATORS.items() if not name.startswith("sympy")}
FAST = {name: way for name, way in VECTORS.items() if not name.startswith("mpmath")}
WEIGHT = "0.098"  # M g l of the top, N m
ACROSS, ALONG, AXIAL = "6e-4", "8e-5", "400"  # its moments of inertia in kg m², its ω₃ in rad/s
NO_LAGRANGIAN = (
    "sympy and MuJoCo were not asked: their coordinates for a free rotation are others than those of this record"
)


def book_rates(maths: Mathematics) -> Rates:
    """Euler's equations for I, 2 I, 3 I, and u̇ = u × ω of a direction that stays in space."""

    def at(time: Any, state: State) -> list[Any]:
        a, b, c, u, v, w = state
        return [-b * c, c * a, -a * b / 3, v * c - w * b, w * a - u * c, u * b - v * a]

    return at


def book_energy(state: State) -> float:
    """Σ n ωₙ²/2, in units of I."""
    a, b, c = (float(value) for value in state[:3])
    return (a * a + 2 * b * b + 3 * c * c) / 2


def book(name: str, title: str, rates: tuple[str, str, str], until: str) -> Problem:
    """A book spun so, asked for its angular velocity and for the direction of x as it sees it."""

    def start(maths: Mathematics) -> list[Any]:
        return [*map(maths.number, rates), *map(maths.number, ("1", "0", "0"))]

    return Problem(
        name=name,
        title=title,
        scene="benchmarks/scenes/thrown-book.yaml",
        asks=(
            *(f"book.angular_velocity.{axis} in body axes" for axis in "xyz"),
            *(f"book.{axis}_axis.x" for axis in "xyz"),
        ),
        unit="rad/s, 1",
        peers=VECTORS,
        sets=tuple(f"w{axis}={rate} rad/s" for axis, rate in zip("xyz", rates, strict=True)),
        motion=Motion(start, book_rates, lambda state, pi: list(state)),
        until=until,
        simulated=True,
        left_out=NO_LAGRANGIAN,
        energy=book_energy,
    )


def top_start(maths: Mathematics) -> list[Any]:
    """The direction n of the axis, 20° from upright, and L = I₃ ω₃ n."""
    tilt = maths.pi / 9
    axis = [maths.number("0"), -maths.sin(tilt), maths.cos(tilt)]
    spin = maths.number(ALONG) * maths.number(AXIAL)
    return [*axis, *(spin * part for part in axis)]


def top_rates(maths: Mathematics) -> Rates:
    """ṅ = L × n/I₁, L̇ = M g l (−n_y, n_x, 0)."""
    across, weight = maths.number(ACROSS), maths.number(WEIGHT)

    def at(time: Any, state: State) -> list[Any]:
        x, y, z, a, b, c = state
        return [
            *((b * z - c * y) / across, (c * x - a * z) / across, (a * y - b * x) / across),
            *(-weight * y, weight * x, 0 * x),
        ]

    return at


BOOK = book("free-asymmetric-book", "A free asymmetric body, after 20 s", ("1", "2", "3"), "20")
MIDDLE = book(
    "book-1e-10-off-its-middle-axis",
    "A body spun 10⁻¹⁰ off its middle axis, after 20 s",
    ("0.0000000005", "5", "0"),
    "20",
)
HEAVY_TOP = Problem(
    name="heavy-top",
    title="A heavy top with nutation, after 10 s",
    scene="benchmarks/scenes/heavy-top.yaml",
    asks=(*(f"top.z_axis.{axis}" for axis in "xyz"), "top.angular_momentum.x", "top.angular_momentum.y"),
    unit="1, kg m²/s",
    peers=FAST,
    motion=Motion(top_start, top_rates, lambda state, pi: list(state[:5])),
    until="10",
    simulated=True,
    left_out=f"mpmath's odefun would take minutes; {NO_LAGRANGIAN}",
)
