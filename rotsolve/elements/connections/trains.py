"""Trains: two wheels whose rims run together, on fixed axles or on a body that carries both; how they turn is told as seen from there."""

from __future__ import annotations

from msgspec import Struct

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import ONE, ZERO, Formula
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.heading import RIGHT, Vector, unit
from rotsolve.elements.shapes import rim_radius
from rotsolve.language.bodies import PointRef
from rotsolve.language.elements import Moment


class Pair(Struct, frozen=True):
    """Two wheels, the radii of their rims, and the body that carries the axles of both, '' where these are fixed.

    `gap` leads from the centre of the first to that of the second; nothing where the axles are fixed: it is not told then.
    """

    wheels: tuple[PointRef, PointRef]
    names: tuple[str, str]
    radii: tuple[Formula, Formula]
    carrier: str
    gap: Vector

    def spins(self, instant: Moment, rate: str, sense: int) -> tuple[Formula, Formula]:
        """R ω of each rim as seen from the carrier, or R α; of equal rims that turn the same way it does not matter how that turns."""
        alike = sense > 0 and is_zero(self.radii[0] - self.radii[1])
        frame = getattr(instant.motion(self.carrier), rate) if self.carrier and not alike else ZERO
        first, second = (getattr(instant.motion(name), rate) for name in self.names)
        return self.radii[0] * (first - frame), self.radii[1] * (second - frame)

    def outward(self, inside: bool, instant: Moment) -> tuple[Vector, Vector]:
        """Unit vectors from both centres to where the rims meet: between them, or beyond the first, which runs `inside` the second.

        Of wheels on fixed axles the second stands on the right of the first.
        """
        if not self.carrier:
            ahead = unit(RIGHT)
            return ahead, ahead if inside else -ahead
        wide = self.radii[1] - self.radii[0] if inside else self.radii[0] + self.radii[1]
        self.check_width(wide, inside, instant)
        along = unit(self.gap.parts[0][1]) if len(self.gap.parts) == 1 else self.gap.times(ONE / wide)
        return (-along, -along) if inside else (along, -along)

    def check_width(self, wide: Formula, inside: bool, instant: Moment) -> None:
        """The carrier holds the centres just so far apart that the rims meet."""
        configuration, (first, second) = instant.configuration, self.wheels
        gap = self.gap.dot(self.gap) - wide**2
        if is_zero(gap) or configuration.signs.decide(gap) == 0:
            return
        sum_or_difference = "difference" if inside else "sum"
        help = f"the centres have to be as far apart as the {sum_or_difference} of the radii"
        message = f"nothing tells that the rims of `{first.owner}` and `{second.owner}` meet where `{self.carrier}` holds them"
        raise Unsolvable(message, span=second.span, help=help)


def pair_of(wheels: tuple[PointRef, ...], word: str, instant: Moment) -> Pair:
    """Two wheels as their axles are held; refused where they are neither fixed nor both carried by one body."""
    first, second = wheels
    names = (instant.host(first.owner), instant.host(second.owner))
    one, other = (rim_radius(instant.body(ref.owner), ref.point) or ZERO for ref in wheels)
    held = [mounts(ref, instant) for ref in wheels]
    common = next((name for name in held[0] if name in held[1]), None)
    if common is None:  # one turns on a fixed axle about which the carrier of the other turns, too
        for own, far in (held, held[::-1]):
            found = next((name for name in far if name and instant.configuration.pivot(name, instant.state)), None)
            if "" in own and found is not None:
                common, own[found] = found, Vector()
    if common is None:
        loose = next((ref for ref, places in zip(wheels, held, strict=True) if "" not in places), second)
        help = f"give both an `axle`, or one carrier: `hinge: [carrier.end, {loose.owner}.center]`"
        message = f"a {word} with `{loose.owner}`, whose centre moves on no carrier of both wheels, is not solved yet"
        raise Unsolvable(message, span=loose.span, help=help)
    gap = held[1][common] - held[0][common] if common else Vector()
    return Pair((first, second), names, (one, other), common, gap)


def mounts(ref: PointRef, instant: Moment) -> dict[str, Vector]:
    """The bodies on which a wheel turns about its centre, with where that is on them; '' where the axle is fixed."""
    name, configuration = instant.host(ref.owner), instant.configuration
    centre = instant.point(PointRef(ref.owner, "center"))
    if configuration.pivot(name, instant.state) is not None:
        return {} if off(centre) else {"": Vector()}
    found: dict[str, Vector] = {}
    for item in configuration.connections(instant.state):
        ends = item.joint()
        for own in ends:
            if instant.host(own.owner) == name and not off(instant.point(own) - centre):
                others = ends[:1] if own is not ends[0] else ends[1:2]
                found |= {instant.host(end.owner): instant.point(end) for end in others}
    return found


def off(arm: Vector) -> bool:
    """Whether an arm leads away from a point."""
    return not is_zero(arm.dot(arm))
