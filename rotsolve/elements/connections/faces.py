"""Faces: friction of plates, cones and collars that a force presses together: τ = ∫ μ r dN over the rings of the face."""

from __future__ import annotations

from typing import Any, Protocol

from msgspec import Struct

from rotsolve.algebra.formula import ONE, ZERO, Formula, Integral, call
from rotsolve.core.derivation import NEXT, Words
from rotsolve.core.facts import Summed
from rotsolve.core.faults import Unsolvable
from rotsolve.language.bodies import PointRef
from rotsolve.language.elements import Moment
from rotsolve.language.keys import amount, key

WEAR, WALLS = "wear", ("inner", "outer")
Radii = tuple[tuple[str, Formula], ...]


def face_radii() -> Any:
    """The key of the face itself, where no body tells it."""
    words = "inner and outer radius of the face that rubs"
    return key("radii", words, limits="positive", default=(), choices=WALLS, plane=True)


def face_radius() -> Any:
    """The key of a face without a hole."""
    return amount("radius of a full face that rubs", "length", "R", "positive", default=None, plane=True)


def face_cone() -> Any:
    """The key of a face that is no flat one."""
    words = "half the angle of the cone that the face is part of, by whose sine the torque is divided"
    return amount(words, "angle", "beta", "acute", default=None, plane=True)


def face_uniform() -> Any:
    """The key of how a press is spread."""
    words = "what is the same all over the face: the `pressure`, or of faces that are worn in the `wear`, with a pressure as 1/r"
    return key("choice", words, choices=("pressure", WEAR), default="pressure", plane=True)


class Face(Struct, frozen=True):
    """A ring between two radii, flat or part of a cone of half angle `cone`, pressed evenly or, where it is `worn`, with p as 1/r."""

    inner: Formula
    outer: Formula
    worn: bool = False
    cone: Formula | None = None

    def share(self, force: Formula, r: Formula, sine: Formula = ONE) -> Formula:
        """What presses a ring of radius r, per its width: F 2 r/(R² − r₁²), F/(R − r₁) of a worn face; over the sine of a cone."""
        share = force if self.worn else force * (2 * r)
        width = self.outer - self.inner if self.worn else self.outer**2 - self.inner**2
        return share / (width if sine == ONE else width * sine)

    def torque(self, owner: str, friction: Formula, force: Formula, bodies: tuple[str, ...], instant: Moment) -> Summed:
        """∫ μ r dN over its rings, and what these are; of a thin ring μ F R."""
        letter = instant.ask("torque", owner, when="")
        sine = call("sin", self.cone) if self.cone is not None else ONE
        if self.inner == self.outer:
            return Summed(owner, letter, friction * force * self.outer / sine, "friction torque", bodies)
        r = instant.coordinate("rho")
        push = self.share(force, r, sine)
        why: Words = ("On worn faces, with a pressure as 1/", r, ",") if self.worn else ("Under a uniform pressure",)
        words: Words = (
            "Cut the face into rings of radius ",
            r,
            " and width d",
            r,
            ". ",
            *why,
            " each is pressed by dN = ",
        )
        words += (push, " d", r, "." if sine == ONE else " (square to the cone).", NEXT)
        words += ("Each rubs with μ dN at the distance ", r, " from the axis: torque μ ", r, " dN.")
        integral = friction * Integral(r * push, r.name, self.inner, self.outer)
        return Summed(owner, letter, integral, "friction torque, τ = ∫ r μ dN", bodies, words)


class Pressed(Protocol):
    """What a force presses together over a face."""

    @property
    def name(self) -> str: ...
    @property
    def press(self) -> Formula | None: ...
    @property
    def friction(self) -> Formula | None: ...
    @property
    def friction_torque(self) -> Formula | None: ...
    @property
    def radius(self) -> Formula | None: ...
    @property
    def radii(self) -> Radii: ...
    @property
    def cone(self) -> Formula | None: ...
    @property
    def uniform(self) -> str: ...


def face_between(item: Pressed) -> Face | None:
    """The face that an element tells itself, a full one by its `radius`."""
    if item.radius is None and not item.radii:
        return None
    inner, outer = (ZERO, item.radius) if item.radius is not None else (dict(item.radii)[word] for word in WALLS)
    return Face(inner, outer, item.uniform == WEAR, item.cone)


def check_pressed(item: Pressed, ref: PointRef) -> None:
    """What belongs to a face stands beside a press and a friction, and not beside a torque that is told already."""
    said = [word for word in ("press", "friction", "radius", "radii", "cone") if getattr(item, word)]
    said += ["uniform"] if item.uniform == WEAR else []
    if item.friction_torque is not None and said:
        message = f"`{item.name}` tells its `friction_torque` and, by `{said[0]}`, what that is made of"
        raise Unsolvable(message, span=ref.span, help="leave out one of them")
    missing = [word for word in ("press", "friction") if getattr(item, word) is None]
    if said and missing:
        message = f"`{item.name}` has a `{said[0]}` and no `{missing[0]}`, so that nothing tells its torque"
        raise Unsolvable(message, span=ref.span, help=f"give it `{missing[0]}`")
    if item.radius is not None and item.radii:
        message = f"`{item.name}` has a `radius`, as of a full face, and `radii`, as of a ring"
        raise Unsolvable(message, span=ref.span, help="leave out one of them")
