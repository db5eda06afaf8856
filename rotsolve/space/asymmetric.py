"""Asymmetric bodies on which no torque acts: ω in their own principal axes by Jacobi's elliptic functions of time.

Of the axes b is that of the middle moment; d is the extreme one, of the largest or the smallest, round which ω goes: the largest where
L² > 2 E I_b, the smallest where L² < 2 E I_b; c is the other one. With u = p t + u₀ and the parameter m = k²

    ω_b = a_b sn(u, m),  ω_c = a_c cn(u, m),  ω_d = a_d dn(u, m),
    a_c² = ω_c² + I_b (I_d − I_b)/(I_c (I_d − I_c)) ω_b²,   a_d² = ω_d² + I_b (I_b − I_c)/(I_d (I_d − I_c)) ω_b²,
    p² = (I_d − I_b)(I_d − I_c)/(I_b I_c) a_d²,             m = I_c (I_b − I_c) a_c²/(I_d (I_d − I_b) a_d²),

(Landau & Lifshitz, Mechanics, §37, with 2 E I_d − L² = I_c (I_d − I_c) a_c² and L² − 2 E I_c = I_d (I_d − I_c) a_d²). Euler's equation of b
tells the sign of a_b: a_b p = (I_j − I_k)/I_b a_c a_d. Where L² = 2 E I_b, m is 1: sn, cn and dn are tanh, 1/cosh and 1/cosh.
"""

from __future__ import annotations

from rotsolve.algebra.formula import ONE, ZERO, Formula, add, call, multiply, negate, sqrt, total
from rotsolve.algebra.units.dimension import ANGULAR_VELOCITY, NONE, Dimension
from rotsolve.core.equation import PART_IN_TIME, Equation
from rotsolve.core.faults import Unsolvable
from rotsolve.core.registry import SceneQuantity
from rotsolve.core.vectors.triple import AXES, Triple, square
from rotsolve.paths.meaning import NotYet
from rotsolve.space.laws import SpaceLaws


class Polhode:
    """How ω of a body goes on in its own principal axes from one moment on; `laws` are what defines the letters in it."""

    def __init__(self, laws: SpaceLaws, name: str) -> None:
        self.before, self.name, self.held = laws, name, laws.moment.held
        self.laws: dict[Equation, None] = {}
        tensor = laws.tensor(name, laws.about(name)[1])
        if any(not self.held.vanishes(laws.tensors.spelled(part)) for part in (tensor.xy, tensor.yz, tensor.zx)):
            raise self.refusal(f"the own axes of `{name}` are not its principal ones", "draw it along these")
        self.moments: Triple = (tensor.xx, tensor.yy, tensor.zz)
        attitude = laws.moment.attitude(name)
        self.omega, self.names = attitude.omega, [AXES[row.index(ONE)] for row in attitude.own]  # as the body is drawn
        self.middle, self.other, self.led = self.axes()
        self.separating = self.beyond == 0

    def refusal(self, message: str, help: str) -> Unsolvable:
        return Unsolvable(f"{message}: how it turns on in time is not solved", help=help)

    def side(self, value: Formula, what: str) -> int:
        """The sign on which it hangs which functions these are; refused by name where letters leave it open."""
        value = self.before.tensors.spelled(value)
        if self.held.vanishes(value):
            return 0
        sign = self.held.signs.taken(value)
        if sign is None:
            raise self.refusal(
                f"{what} of `{self.name}` is not told",
                f"tell its moments of inertia and its rates at `{self.before.moment.when}` by numbers",
            )
        return sign

    def axes(self) -> tuple[int, int, int]:
        """The axes of the middle moment, of the other extreme one, and the one round which ω goes."""
        smaller = [0, 0, 0]
        for one, two in ((0, 1), (1, 2), (2, 0)):
            gap = self.side(add(self.moments[one], negate(self.moments[two])), "which moment of inertia is larger")
            smaller[one], smaller[two] = smaller[one] + (gap > 0), smaller[two] + (gap < 0)
        least, middle, most = (smaller.index(count) for count in (0, 1, 2))
        terms = (
            multiply(multiply(inertia, add(inertia, negate(self.moments[middle]))), square(rate))
            for inertia, rate in zip(self.moments, self.omega, strict=True)
        )
        self.beyond = self.side(total(list(terms)), "whether L² is more or less than 2 E I of the middle axis")
        return (middle, most, least) if self.beyond < 0 else (middle, least, most)

    # letters

    def letter(self, kind: str, letter: str, axis: str, dimension: Dimension, value: Formula, words: str) -> Formula:
        when = self.before.moment.when
        quantity = SceneQuantity(kind, self.name, when, axis, letter, dimension)
        symbol = self.before.moment.registry.ask(quantity)
        self.laws[PART_IN_TIME.equation(symbol, value, when, (self.name,), words=words)] = None
        return symbol

    def gap(self, one: int, two: int) -> Formula:
        return add(self.moments[one], negate(self.moments[two]))

    def sign(self, axis: int) -> int:
        """The sign of ω along an axis at first; +1 where it is nothing."""
        return self.side(self.omega[axis], f"in which sense it turns about the {self.names[axis]} axis") or 1

    def amplitude(self, axis: int, share: Formula) -> Formula:
        """±√(ω² + share ω_b²), the largest ω along an axis, with the sign that it has at first."""
        rate, across = self.omega[axis], self.omega[self.middle]
        if across == ZERO:
            return rate
        size = sqrt(add(square(rate), multiply(share, square(across))))
        value = size if self.sign(axis) > 0 else negate(size)
        words = f"ω along {self.names[axis]} where that along {self.names[self.middle]} is nothing"
        return self.letter("largest rate", "a", self.names[axis], ANGULAR_VELOCITY, value, words)

    def largest(self) -> tuple[Formula, Formula]:
        """a_c and a_d."""
        b, c, d = self.middle, self.other, self.led
        shares = (
            self.moments[b] * self.gap(d, b) / (self.moments[c] * self.gap(d, c)),
            self.moments[b] * self.gap(b, c) / (self.moments[d] * self.gap(d, c)),
        )
        return self.amplitude(c, shares[0]), self.amplitude(d, shares[1])

    def pace(self) -> Formula:
        """p = |a_d| √((I_d − I_b)(I_d − I_c)/(I_b I_c)), the rate of u."""
        b, c, d = self.middle, self.other, self.led
        size = self.largest()[1]
        ratio = sqrt(self.gap(d, b) * self.gap(d, c) / (self.moments[b] * self.moments[c]))
        value = multiply(size if self.sign(d) > 0 else negate(size), ratio)
        return self.letter("pace", "p", "", ANGULAR_VELOCITY, value, "rate of the argument u = p t + u₀")

    def parameter(self) -> Formula:
        """m = I_c (I_b − I_c) a_c²/(I_d (I_d − I_b) a_d²), from 0 to 1."""
        b, c, d = self.middle, self.other, self.led
        sizes = self.largest()
        above = multiply(self.moments[c] * self.gap(b, c), square(sizes[0]))
        value = above / multiply(self.moments[d] * self.gap(d, b), square(sizes[1]))
        relation = ">" if self.beyond > 0 else "<"
        which = "largest" if (self.beyond > 0) else "smallest"
        words = f"parameter m = k²; as L² {relation} 2 E I of the middle axis, ω goes round that of the {which} moment"
        return self.letter("parameter", "m", "", NONE, value, words)

    def turning(self) -> int:
        """The sign of (I_j − I_k)/I_b a_d, by which Euler's equation tells how ω_b goes on: j and k follow b in turn."""
        j, k = (self.middle + 1) % 3, (self.middle + 2) % 3
        return self.side(self.gap(j, k), "") * self.sign(self.led)

    def tangent(self) -> Formula:
        """sn u₀/cn u₀ = ± √(I_b (I_d − I_b)/(I_c (I_d − I_c))) ω_b/ω_c."""
        b, c, d = self.middle, self.other, self.led
        ratio = sqrt(self.moments[b] * self.gap(d, b) / (self.moments[c] * self.gap(d, c)))
        value = multiply(ratio, self.omega[b] / self.omega[c])
        return value if self.turning() > 0 else negate(value)

    def phase(self, parameter: Formula) -> Formula:
        """u₀ = F(arctan(± √(I_b (I_d − I_b)/(I_c (I_d − I_c))) ω_b/ω_c), m); ± K(m) where ω_c is nothing."""
        b = self.middle
        if self.omega[b] == ZERO:
            return ZERO
        if self.side(self.omega[self.other], "whether it turns about its other axis") == 0:
            sign = self.turning() * self.sign(b)
            quarter = call(
                "ellipk", parameter
            )  # on the edge between both cases ω would lie along the middle axis, and stay
            value = quarter if sign > 0 else negate(quarter)
        else:
            value = call("ellipf", call("atan", self.tangent()), parameter)
        return self.letter("phase", "u_0", "", NONE, value, "argument at first")

    def begun(self) -> Formula:
        """e^u₀ where the parameter is 1: sinh u₀ = ± √(I_b (I_d − I_b)/(I_c (I_d − I_c))) ω_b/ω_c."""
        if self.omega[self.middle] == ZERO:
            return ONE
        sine = self.tangent()
        value = add(sine, sqrt(add(ONE, square(sine))))
        return self.letter("phase", "q", "", NONE, value, "e^u at first")

    # motion

    def rates(self, time: Formula) -> Triple:
        """ω some time later, along the three axes."""
        b, c, d = self.middle, self.other, self.led
        sizes, pace = self.largest(), self.pace()
        ratio = sqrt(self.moments[c] * self.gap(d, c) / (self.moments[b] * self.gap(d, b)))
        size = multiply(sizes[0] if self.turning() > 0 else negate(sizes[0]), ratio)  # a_b
        sn, cn, dn = self.functions(multiply(pace, time))
        found = {b: multiply(size, sn), c: multiply(sizes[0], cn), d: multiply(sizes[1], dn)}
        return (found[0], found[1], found[2])

    def functions(self, gone: Formula) -> Triple:
        """sn, cn and dn of u = p t + u₀; where the parameter is 1 tanh, 1/cosh and 1/cosh."""
        if not self.separating:
            parameter = self.parameter()
            u = add(gone, self.phase(parameter))
            return call("ellipsn", u, parameter), call("ellipcn", u, parameter), call("ellipdn", u, parameter)
        begun = self.begun()
        once, twice = multiply(begun, call("exp", gone)), multiply(square(begun), call("exp", 2 * gone))
        bell = 2 * once / add(twice, ONE)
        return add(twice, negate(ONE)) / add(twice, ONE), bell, bell

    def period(self) -> Formula:
        """T = 4 K(m)/p, in which ω comes round in the own axes; in half of it ω_b and ω_c change their signs."""
        if self.separating:
            message = f"`{self.name}` comes ever nearer to the rotation about its middle axis, and never back"
            raise NotYet(f"{message}: it has no period", help="ask for its `angular_velocity` at a `time`")
        return 4 * call("ellipk", self.parameter()) / self.pace()
