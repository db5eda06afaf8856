"""Universal joints (Hooke's, Cardan's): a cross between the forks of two shafts that meet at an angle, each on a hinge of the ground.

With c the arm of the cross in the fork of the first shaft and n₁, n₂ along the shafts, all of length 1, the other arm lies along n₂ × c,
square to the second shaft and to c. That both arms stay square makes ω₂ (1 − (c · n₂)²) = ω₁ n₁ · n₂: of shafts at an angle β, with θ from
where c lies square to both, ω₂ = ω₁ cos β/(1 − sin²β sin²θ), as in books on the theory of machines. The couple is along the normal of the
cross, n₂ − c (c · n₂), so that it gives as much power as it takes; no force is passed on.
"""

from __future__ import annotations

from collections.abc import Iterator

from msgspec import Struct

from rotsolve.algebra.formula import ONE, Formula, add, call, multiply, negate
from rotsolve.core.equation import RULE, Equation
from rotsolve.core.faults import Unsolvable
from rotsolve.core.vectors.triple import (
    Rows,
    Triple,
    aligning,
    cross_product,
    dot_product,
    minus,
    rotated,
    scaled_by,
    square,
    square_of,
    triple,
    unit_along,
    vector_sum,
)
from rotsolve.core.writing import spoken
from rotsolve.language.bodies import Coupling, Joint
from rotsolve.space.attitude import IN_SPACE
from rotsolve.space.moment import SpaceMoment

ON_HINGE = "a universal joint ties shafts that each turn on a `hinge` of the ground, and `{}` is on none"
TWO = 2 * ONE


class Cross(Struct, frozen=True):
    """The cross of a universal joint at a moment."""

    moment: SpaceMoment
    coupling: Coupling

    def shaft(self, name: str) -> Joint:
        """The hinge of one of the shafts; refused is what is held otherwise."""
        joint, ref = self.moment.held.main(name), self.coupling.first
        ref = ref if ref.owner == name else self.coupling.second
        plain = joint is not None and joint.turning and not (joint.sliding or joint.free)
        if joint is None or not plain or joint.carrier.owner in self.moment.held.bodies:
            help = f"write `{name}_bearing: {{hinge: {name}.P, along: [x, y, z]}}`, with P one of its points"
            raise Unsolvable(ON_HINGE.format(name), span=ref.span, help=help)
        return joint

    def axis(self, name: str) -> Triple:
        """Along a shaft, in space."""
        joint = self.shaft(name)
        way = unit_along(joint.turning[0], self.moment.positive)
        return self.tidy(way if joint.aligned else rotated(self.moment.turned(name), way))

    def drawn(self, name: str) -> Rows:
        """How a shaft stands before it is turned about its hinge."""
        held, joint = self.moment.held, self.shaft(name)
        own = held.axis(name) if held.wheel(name) else None
        return self.moment.turned(name) if own is None else aligning(own, self.moment.direction(name, joint))

    def arm(self, *, drawn: bool = False) -> Triple:
        """c, the arm in the fork of the first shaft, in space: now, or as that is drawn."""
        name, way = self.coupling.first.owner, unit_along(self.coupling.arm, self.moment.positive)
        if drawn:
            return self.tidy(rotated(self.drawn(name), way))
        return self.tidy(self.moment.own_axes(name).to(IN_SPACE, way))

    def tidy(self, vector: Triple) -> Triple:
        return triple([self.moment.tidy(part) for part in vector])

    def lean(self) -> Formula:
        """c · n₂."""
        return self.moment.tidy(dot_product(self.arm(), self.axis(self.coupling.second.owner)))

    def leverage(self) -> Formula:
        """1 − (c · n₂)²."""
        return self.moment.tidy(add(ONE, negate(square(self.lean()))))

    def together(self) -> Formula:
        """n₁ · n₂."""
        first, second = self.coupling.first.owner, self.coupling.second.owner
        return self.moment.tidy(dot_product(self.axis(first), self.axis(second)))

    def angle(self) -> Formula:
        """How far the second shaft is turned from how it is drawn: its arm goes from n₂ × c as drawn to n₂ × c."""
        axis = self.axis(self.coupling.second.owner)
        start, now = (cross_product(axis, self.arm(drawn=drawn)) for drawn in (True, False))
        turned = dot_product(axis, cross_product(start, now)), dot_product(start, now)
        return call("atan2", *(self.moment.tidy(part) for part in turned))

    def couple(self) -> Triple:
        """The couple on the second shaft, in space: the letter is its part along that."""
        size = self.moment.ask("torque", self.coupling.owner)
        normal = vector_sum(self.axis(self.coupling.second.owner), minus(scaled_by(self.lean(), self.arm())))
        return scaled_by(size / self.leverage(), self.tidy(normal))

    def rules(self) -> Iterator[Equation]:
        """What ties the rates of both shafts, and how fast these change."""
        moment = self.moment
        names = self.coupling.first.owner, self.coupling.second.owner
        (first, faster), (second, quicker) = (
            moment.driven(name, joint, moment.rate_word(name, joint))
            for name, joint in zip(names, map(self.shaft, names), strict=True)
        )
        lean, leverage, together = self.lean(), self.leverage(), self.together()
        words = f"the arms of {spoken(self.coupling.owner)} stay square"
        left, right = multiply(leverage, second), multiply(together, first)
        if left != right:
            yield RULE.equation(left, right, moment.when, names, ("ω₂ (1 − (c · n₂)²) = ω₁ n₁ · n₂",), words=words)
        swept = moment.tidy(dot_product(cross_product(self.axis(names[0]), self.arm()), self.axis(names[1])))
        gained = multiply(TWO, multiply(multiply(lean, swept), multiply(first, second)))
        left, right = multiply(leverage, quicker), add(multiply(together, faster), gained)
        if left != right:
            yield RULE.equation(left, right, moment.when, names, words=f"{words} as they go on")


def crosses_at(moment: SpaceMoment) -> Iterator[Cross]:
    """The crosses of all universal joints; refused by name where one can not be followed."""
    for coupling in moment.held.couplings:
        cross = Cross(moment, coupling)
        refuse_cross(cross)
        yield cross


def refuse_cross(cross: Cross) -> None:
    """Refuse an arm that is not square to its shaft, a cross that locks, and a second shaft that is tied twice or told otherwise."""
    moment, coupling = cross.moment, cross.coupling
    first, second = coupling.first, coupling.second
    if first.owner == second.owner:
        raise Unsolvable(f"`{coupling.owner}` names `{first.owner}` twice", span=second.span, help="name two shafts")
    refuse_ring(cross)
    along = dot_product(cross.arm(drawn=True), cross.axis(first.owner))
    if not moment.held.vanishes(moment.tidy(along)):
        message = f"the arm of `{coupling.owner}` is not square to `{first.owner}`"
        raise Unsolvable(message, span=first.span, help="`along` is a direction square to that shaft, in its own axes")
    lock = square_of(cross_product(cross.axis(second.owner), cross.arm(drawn=True)))
    drawn = moment.held.vanishes(moment.tidy(lock))
    if drawn or moment.held.vanishes(cross.leverage()):
        when = "as it is drawn" if drawn else f"at `{moment.when}`"
        message = f"`{coupling.owner}` is locked {when}: its arm in `{first.owner}` lies along `{second.owner}`"
        raise Unsolvable(message, span=second.span, help="turn the arm, or the shafts, another way")
    line = moment.line(second.owner, "angle")
    if line is not None or "angle" in dict(cross.shaft(second.owner).drive):
        message = f"how far `{second.owner}` is turned follows from how far `{first.owner}` is, by `{coupling.owner}`"
        help = f"tell the angle of `{first.owner}`, or name the shaft first of which it is told"
        raise Unsolvable(message, span=second.span if line is None else line.span, help=help)


def refuse_ring(cross: Cross) -> None:
    """Refuse shafts of which one is the second of two universal joints, or that come round in a ring."""
    before = {item.second.owner: item.first.owner for item in cross.moment.held.couplings}
    name, seen = cross.coupling.second.owner, set[str]()
    while name in before and name not in seen:
        seen.add(name)
        name = before[name]
    if name in seen or len(before) < len(cross.moment.held.couplings):
        message = f"`{cross.coupling.second.owner}` is tied to others by several universal joints in a ring"
        raise Unsolvable(
            message,
            span=cross.coupling.second.span,
            help="name shafts from the first to the last, each once as a second one",
        )


def coupled_angle(moment: SpaceMoment, name: str) -> Formula | None:
    """How far a shaft is turned that a universal joint ties to another one; None of others."""
    coupling = next((item for item in moment.held.couplings if item.second.owner == name), None)
    if coupling is None:
        return None
    cross = Cross(moment, coupling)
    refuse_cross(cross)
    return cross.angle()
