"""Herpolhode: how a body on which no torque acts stands, by the rates in its own principal axes that `asymmetric` tells.

L is constant in space. About it the body has the Euler angles z-x-z φ, θ, ψ: φ from the line of nodes N at first, θ from L to the axis 3
round which ω goes, ψ about this; 1 and 2 follow 3 in turn. L₁ = L sin θ sin ψ, L₂ = L sin θ cos ψ and L₃ = L cos θ tell θ and ψ, and ω
without ω₃ along L without L₃ tells φ̇ (Landau & Lifshitz, Mechanics, §37):

    cos θ = I₃ ω₃/L,   tan ψ = I₁ ω₁/(I₂ ω₂),   φ̇ = L (I₁ ω₁² + I₂ ω₂²)/(I₁² ω₁² + I₂² ω₂²).

With the axes b, c and d of `asymmetric`, d = 3, and u = p t + u₀ this is φ̇ = L/I_d + L (I_d − I_c)/(I_c I_d)/(1 − n sn² u), hence

    φ = L t/I_d + L (I_d − I_c)/(I_c I_d p) (Π(n, am u, m) − Π(n, am u₀, m)),   n = −I_d (I_b − I_c)/(I_c (I_d − I_b)) < 0.

Where L² = 2 E I_b, m is 1 and φ = L t/I_b + arctan(√−n tanh u) − arctan(√−n tanh u₀). In space the own axes are then those of L, turned by
φ about L, by θ about the line of nodes, and by ψ about the axis 3.
"""

from __future__ import annotations

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ZERO, Formula, add, call, multiply, negate, sqrt
from rotsolve.algebra.units.dimension import ANGLE, NONE, Dimension
from rotsolve.core.equation import PART_IN_TIME, Equation
from rotsolve.core.registry import SceneQuantity
from rotsolve.core.vectors.triple import (
    AS_DRAWN,
    AXES,
    Rows,
    Triple,
    X,
    Z,
    after,
    cross_product,
    length_of,
    rotated,
    scaled_by,
    transposed,
    triple,
    turn_about,
)
from rotsolve.space.asymmetric import Polhode
from rotsolve.space.moment import SpaceMoment

OWN_LETTERS = {"x": "i", "y": "j", "z": "k"}  # of the unit vectors along the own axes of a body


class Herpolhode:
    """How a body stands at a later moment, a time after the one from which its ω goes on by a polhode; `momentum` is its L at that one
    in its own axes, with its size, and `laws` are what defines the letters in the answers."""

    def __init__(self, polhode: Polhode, later: SpaceMoment, momentum: Triple, size: Formula) -> None:
        self.polhode, self.later, self.momentum, self.size = polhode, later, momentum, size
        self.third = polhode.led
        self.one, self.two = (self.third + 1) % 3, (self.third + 2) % 3
        self.laws: dict[Equation, None] = {}

    def letter(
        self, moment: SpaceMoment, kind: str, letter: str, axis: str, dimension: Dimension, value: Formula, words: str
    ) -> Formula:
        """A letter of the body at a moment; numbers stay as they are."""
        if not value.symbols():
            return value
        name = self.polhode.name
        symbol = moment.registry.ask(SceneQuantity(kind, name, moment.at, axis, letter, dimension))
        self.laws[PART_IN_TIME.equation(symbol, value, moment.when, (name,), words=words)] = None
        return symbol

    # the axes of L

    def axes_of_momentum(self, rows: Rows) -> Rows:
        """The line of nodes N at first, l × N, and l along L, as columns in space; `rows` turn own components into those."""
        start = self.polhode.before.moment
        across = triple([ZERO if axis == self.third else part for axis, part in enumerate(self.momentum)])
        far = self.length_across(across)
        along = triple([part if part == ZERO else part / self.size for part in self.momentum])
        nodes = scaled_by(1 / far, cross_product(across, AS_DRAWN[self.third]))
        found = (nodes, cross_product(along, nodes), along)
        axis = self.polhode.names[self.third]
        names = (f"line of nodes at first, N along L × its {axis} axis", "l × N", "direction of L, l = L/|L|")
        columns = [
            self.in_letters(start, words, letter, triple([start.tidy(part) for part in rotated(rows, vector)]), words)
            for vector, letter, words in zip(found, ("N", "q", "l"), names, strict=True)
        ]
        return transposed((columns[0], columns[1], columns[2]))

    def in_letters(self, moment: SpaceMoment, kind: str, letter: str, vector: Triple, words: str) -> Triple:
        """A unit vector in space as letters."""
        return triple(
            [
                self.letter(moment, kind, letter, axis, NONE, part, words)
                for axis, part in zip(AXES, vector, strict=True)
            ]
        )

    def length_across(self, across: Triple) -> Formula:
        """√(L₁² + L₂²)."""
        alone = [axis for axis, part in enumerate(across) if part != ZERO]
        if len(alone) > 1:
            return length_of(across)
        part = across[alone[0]]
        return part if self.polhode.sign(alone[0]) > 0 else negate(part)

    # the angles about L

    def characteristic(self) -> Formula:
        """n = −I_d (I_b − I_c)/(I_c (I_d − I_b))."""
        polhode = self.polhode
        b, c, d = polhode.middle, polhode.other, polhode.led
        moments = polhode.moments
        value = negate(moments[d] * polhode.gap(b, c) / (moments[c] * polhode.gap(d, b)))
        words = "n of the arctangent" if polhode.separating else "characteristic of Π"
        return self.letter(polhode.before.moment, "characteristic", "n", "", NONE, value, words)

    def gone_round(self, time: Formula) -> Formula:
        """φ."""
        polhode = self.polhode
        b, c, d = polhode.middle, polhode.other, polhode.led
        moments, n = polhode.moments, self.characteristic()
        gone = multiply(polhode.pace(), time)
        if polhode.separating:
            ends = [polhode.functions(gone)[0], simplify(polhode.functions(ZERO)[0])]
            turns = [ZERO if end == ZERO else call("atan", multiply(sqrt(negate(n)), end)) for end in ends]
            return add(multiply(self.size, time) / moments[b], add(turns[0], negate(turns[1])))
        m, first = polhode.parameter(), polhode.phase(polhode.parameter())
        ends = [call("ellippiinc", n, call("ellipam", u, m), m) for u in (add(gone, first), first)]
        share = multiply(self.size, polhode.gap(d, c)) / multiply(multiply(moments[c], moments[d]), polhode.pace())
        return add(multiply(self.size, time) / moments[d], multiply(share, add(ends[0], negate(ends[1]))))

    def angles(self, omega: Triple, time: Formula) -> Triple:
        """φ, θ and ψ as letters, by ω in the own axes."""
        one, two, third = (
            multiply(self.polhode.moments[axis], omega[axis]) for axis in (self.one, self.two, self.third)
        )
        values = (self.gone_round(time), call("acos", third / self.size), call("atan2", one, two))
        x, y, z = (self.polhode.names[axis] for axis in (self.one, self.two, self.third))
        words = (
            f"how far it goes round L, ∫ φ̇ dt with φ̇ = L (I_{x} ω_{x}² + I_{y} ω_{y}²)/(I_{x}² ω_{x}² + I_{y}² ω_{y}²)",
            f"angle of its {z} axis from L, cos θ = I_{z} ω_{z}/L",
            f"turn about its {z} axis, tan ψ = I_{x} ω_{x}/(I_{y} ω_{y})",
        )
        return triple(
            [
                self.letter(self.later, f"{letter} about L", letter, "", ANGLE, value, label)
                for letter, value, label in zip(("phi", "theta", "psi"), values, words, strict=True)
            ]
        )

    # the own axes in space

    def rows(self, first: Rows, omega: Triple, time: Formula) -> Rows:
        """What turns own components into those in space, as letters: the unit vectors along the own axes are its columns."""
        phi, theta, psi = self.angles(omega, time)
        turned = after(after(turn_about(Z, phi), turn_about(X, theta)), turn_about(Z, psi))
        columns = transposed(after(self.axes_of_momentum(first), turned))
        found: dict[int, Triple] = {}
        for own, column in zip((self.one, self.two, self.third), columns, strict=True):
            axis = self.polhode.names[own]
            words = f"its {axis} axis, turned from N, l × N and l by φ, θ and ψ"
            found[own] = self.in_letters(self.later, f"{axis} axis in space", OWN_LETTERS[axis], column, words)
        return transposed((found[0], found[1], found[2]))
