"""What the benchmark asks: a scene, the same in plain mathematics for the peers, and who can answer it."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

State = Sequence[Any]  # of floats, of mpf, or of expressions: whatever the mathematics at hand calculates with
Rates = Callable[[Any, State], list[Any]]


class Mathematics(NamedTuple):
    """What a peer calculates with: `number` makes an exact decimal one of its numbers."""

    number: Callable[[str], Any]
    sin: Callable[[Any], Any]
    cos: Callable[[Any], Any]
    asin: Callable[[Any], Any]
    pi: Any


FLOATS = Mathematics(float, math.sin, math.cos, math.asin, math.pi)


class Motion(NamedTuple):
    """Equations of motion y′ = rates(t, y), y(0) = start, with the quantities that are asked of y = (places, speeds)."""

    start: Callable[[Mathematics], list[Any]]
    rates: Callable[[Mathematics], Rates]
    read: Callable[[State, Any], list[Any]]  # (y, π) → the asked quantities, as the scene counts them
    lagrangian: Callable[[Any, Any, Any], Any] | None = None  # (sympy, places, speeds) → L, for sympy.physics.mechanics
    mujoco: MujocoModel | None = None
    pymunk: PymunkModel | None = None
    sticking: Sticking | None = None
    kane: Callable[[Any, Any], Kane] | None = None  # (sympy, its physics.mechanics) → bodies for Kane's method
    turned: TurnedModel | None = None  # of MuJoCo, for what turns about any axis


class Sticking(NamedTuple):
    """What friction makes of a motion with one speed: it slips one way or the other, or sticks."""

    slipping: Callable[[Mathematics, Any], Rates]  # slipping in the sense 1 or −1
    leaving: Callable[[Mathematics, Any], int]  # the sense in which it slips on from rest at a time, 0 if it sticks
    breakaway: Callable[
        [Mathematics, Any], tuple[Any, int]
    ]  # when it slips again that sticks at a time, and in which sense
    couple: Callable[
        [Any, Any, Any, Any], Any
    ]  # (sympy, t, ω, sense) → what acts besides the Lagrangian, for sympy.physics.mechanics


class MujocoModel(NamedTuple):
    """A model of MuJoCo, whose `{step}` is the time step, and its joints in terms of y."""

    xml: str
    enter: Callable[[State], list[float]]  # y → joint coordinates, or joint velocities: both go the same way
    leave: Callable[[State], list[float]]  # the way back
    control: Callable[[float], float] | None = None  # what the only actuator exerts, as a function of time


class Kane(NamedTuple):
    """What `KanesMethod` of sympy.physics.mechanics asks for, where it starts, and what is asked of it."""

    frame: Any
    places: list[Any]
    speeds: list[Any]
    kinematics: list[Any]  # what is nothing: a rate of each place with the speeds
    bodies: list[Any]
    loads: list[Any]
    start: list[float]  # places, then speeds
    asked: list[Any]  # expressions in both


class TurnedModel(NamedTuple):
    """A model of MuJoCo whose first body goes by a unit quaternion, which is the last of its places."""

    xml: str
    places: tuple[float, ...]
    speeds: tuple[float, ...]  # the last three are the angular velocity along the axes of the body
    read: Callable[[list[list[float]], list[float]], list[float]]  # (rotation, angular velocity) → the asked quantities


class PymunkModel(NamedTuple):
    """A space of pymunk: `build` puts the bodies in it at y, `leave` reads y off them."""

    build: Callable[[Any, Any, State], list[Any]]  # (pymunk, space, y) → bodies
    leave: Callable[[list[Any]], list[float]]
    push: Callable[[list[Any], float], None] | None = None  # what acts on them at a time, besides their weight


class Way(NamedTuple):
    """How a peer answers: with which packages, at which settings, by which function."""

    packages: tuple[str, ...]  # what must be importable
    setting: str  # what the settings are: `rtol = atol`, `digits`, `step`
    settings: tuple[str, ...]
    solve: Callable[[Problem, str], list[Any]]  # the asked quantities, as text or as floats; imports its package itself


class Problem(NamedTuple):
    """One question, put to all who can answer it."""

    name: str
    title: str
    scene: str  # from the root of the project
    asks: tuple[str, ...]  # the names of our answers, in the order of the references
    unit: str
    peers: dict[str, Way]
    sets: tuple[str, ...] = ()  # `--set` on the command line
    motion: Motion | None = None
    until: str = ""  # the time in seconds at which a motion is asked
    simulated: bool = (
        False  # by `rotsolve simulate`, else by `rotsolve solve`, whose answers are compared by their relative error
    )
    left_out: str = ""  # why peers have no row
    energy: Callable[[State], float] | None = None  # of the asked quantities, where it is conserved, in units of M g L
