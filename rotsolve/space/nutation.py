"""Nutation: how long a symmetric top, or a spherical pendulum, takes from one tilt to another, by elliptic integrals.

From a tilt θ₀ at which it does not nod, with u = cos θ, v = u₀ − u, a = I₃ ω₃/I₁ and b = 2 M g l/I₁, its energy and its angular momentum
about the vertical leave u̇² = v (sin² θ₀ q − 2 h v − b v²) (Whittaker, Analytical Dynamics, §71; Goldstein, Poole & Safko, §5.7), where

    q = b + 2 φ̇₀² u₀ − 2 φ̇₀ a,   h = (a² + φ̇₀² sin² θ₀)/2 − b u₀,   R² = h² + b sin² θ₀ q.

The tilt goes to v₁ = sin² θ₀ q/(h + R), and back. Where b q ≥ 0, p² = R/2 and m = (R − h)/2 R; else p² = (h + R)/4 and m = (h − R)/(h + R).
Half a nutation takes K(m)/p, the way to a tilt before that F(arcsin x, m)/p with x² = v/v₁, where b q ≥ 0 times 2 R/(h + R + b v).
Where it comes ever nearer to the vertical, R = 0, m = 1 and F(arcsin x, 1) = artanh x = arcosh y, y = sin ½θ₀/sin ½θ, below cosines.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

from msgspec import Struct

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import ONE, PI, ZERO, Formula, add, call, formula, multiply, negate, sqrt, total
from rotsolve.algebra.notation.derived import acosh
from rotsolve.algebra.units.dimension import ANGULAR_VELOCITY, NONE, Dimension
from rotsolve.core.equation import PART_IN_TIME, Equation
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.registry import SceneQuantity
from rotsolve.core.vectors.heading import heading
from rotsolve.core.vectors.triple import square
from rotsolve.language.problem import EXTREMES, Term
from rotsolve.motion.timeline import Timeline
from rotsolve.paths.meaning import Meaning, NotYet
from rotsolve.space.laws import SpaceLaws
from rotsolve.space.moment import SpaceMoment
from rotsolve.space.passing import left_alone
from rotsolve.space.swings import top_of

VERTICAL = (ONE, negate(ONE))  # cos θ of an axis that is upright, or upside down


class Nutation:
    """How a top nods from a moment on at which it does not; `laws` are what defines the letters in it."""

    def __init__(self, laws: SpaceLaws, name: str) -> None:
        self.before, self.name = laws, name
        self.laws: dict[Equation, None] = {}
        self.check()
        moment = laws.moment
        turning = moment.nodding(name)
        self.tilt = turning.angles[1]
        tilt = heading(self.tilt)
        axial, across, lift = top_of(laws, name)
        self.cosine, self.sine, self.rate = tilt.cos(), square(tilt.sin()), turning.rates[0]
        self.spin, self.pull = multiply(axial, moment.attitude(name).omega[2]) / across, 2 * lift / across
        self.start = add(  # (b + 2 φ̇₀² u₀ − 2 φ̇₀ a): towards larger tilts where it is positive
            self.pull,
            add(multiply(2 * square(self.rate), self.cosine), negate(multiply(2 * self.rate, self.spin))),
        )
        if self.side(self.start, "whether it begins to sink or to rise") == 0:
            message = f"`{name}` precesses steadily from `{moment.when}` on: it does not nod"
            raise NotYet(
                message, help="`period of small swings` about a state with `steady: true` is that of a small nutation"
            )

    def check(self) -> None:
        """Refuse what does not nod so: what is not symmetric, not held at a point at rest, acted on, or nods at first."""
        laws, name = self.before, self.name
        moment, held = laws.moment, laws.moment.held
        joint, axis = held.main(name), held.axis(name)
        free = joint is not None and joint.free and laws.fixed(name) and left_alone(laws, name)
        if not (free and axis is not None and moment.nods(name) and held.turns_round(name, axis)):
            message = f"how long `{name}` takes is not solved in space"
            raise NotYet(
                message,
                help="solved is a symmetric top, or a spherical pendulum, on a fixed point; `rotsolve simulate`",
            )
        turning = moment.nodding(name)
        if turning.angles[1] in (ZERO, PI):
            raise NotYet(
                f"`{name}` is upright at `{moment.when}`: its nutation from there is not solved",
                help="`rotsolve simulate`",
            )
        if not held.vanishes(turning.rates[1]):
            message = f"`{name}` nods at `{moment.when}`: how long its nutation takes is solved from a tilt at which it does not"
            rates = f"`{name}.precession`, `{name}.nutation: 0 rad/s`"
            help = f"ask for its largest `tilt` and its rates there, and begin with them, {rates}; `rotsolve simulate`"
            raise NotYet(message, help=help)

    def side(self, value: Formula, what: str) -> int:
        """The sign on which it hangs how it nods; refused by name where letters leave it open."""
        value = self.before.tensors.spelled(value)
        if self.before.moment.held.vanishes(value):
            return 0
        sign = self.before.moment.held.signs.taken(value)
        if sign is None:
            help = f"tell its rates at `{self.before.moment.when}` by numbers"
            raise NotYet(f"{what} hangs on letters: how `{self.name}` nods is not told", help=help)
        return sign

    def letter(
        self, kind: str, letter: str, dimension: Dimension, value: Formula, words: str, state: str = ""
    ) -> Formula:
        when = state or self.before.moment.when
        symbol = self.before.moment.registry.ask(SceneQuantity(kind, self.name, when, "", letter, dimension))
        self.laws[PART_IN_TIME.equation(symbol, value, when, (self.name,), words=words)] = None
        return symbol

    # the cubic, in units of b

    @cached_property
    def middle(self) -> Formula:
        """h."""
        value = add(
            add(square(self.spin), multiply(square(self.rate), self.sine)) / 2, negate(multiply(self.pull, self.cosine))
        )
        words = "b u₀ + h ± R are roots of u̇² = 0, u = cos θ, b = 2 M g l/I₁: h = ((I₃ ω₃/I₁)² + φ̇₀² sin² θ₀)/2 − b u₀"
        return self.letter("middle of two roots", "h", ANGULAR_VELOCITY**2, value, words)

    @cached_property
    def root(self) -> Formula:
        """R."""
        value = sqrt(add(square(self.middle), multiply(multiply(self.pull, self.sine), self.start)))
        words = "R² = h² + b sin² θ₀ (b + 2 φ̇₀² u₀ − 2 φ̇₀ I₃ ω₃/I₁)"
        return self.letter("half of their difference", "R", ANGULAR_VELOCITY**2, value, words)

    @cached_property
    def sinks(self) -> bool:
        """Whether the tilt grows from that of the start on."""
        return self.side(self.start, "whether it begins to sink or to rise") > 0

    @cached_property
    def nearer(self) -> bool:
        """Whether u₀ is the middle one of the three roots, R > |h|."""
        return self.side(multiply(self.pull, self.start), "whether it begins to sink or to rise") >= 0

    @cached_property
    def pace(self) -> Formula:
        """p."""
        if self.never is not None:  # h + R = b (± 1 − u₀), with no root of what is nothing
            value = multiply(self.from_end(self.tilt), sqrt(multiply(self.pull, self.never) / 2))
        else:
            value = sqrt(self.root / 2) if self.nearer else sqrt(add(self.middle, self.root)) / 2
        words = "rate of the argument of the elliptic functions"
        if self.never is not None:
            words = "rate at which its angle to the vertical dies away"
        return self.letter("pace", "p", ANGULAR_VELOCITY, value, words)

    @cached_property
    def parameter(self) -> Formula:
        """m."""
        if self.never is not None:
            message = f"`{self.name}` comes ever nearer to the vertical, and never back: it has no nutation that ends"
            raise NotYet(message, help="`time` to a state with a `tilt` on the way; `rotsolve simulate`")
        h, root = self.middle, self.root
        gap = add(root, negate(h))
        value = gap / (2 * root) if self.nearer else negate(gap) / add(h, root)
        return self.letter("parameter", "m", NONE, value, "parameter m = k²")

    def told(self, value: Formula) -> Formula:
        """A formula with what the letters in it stand for."""
        known = {law.left.name: law.right for law in self.laws}  # type: ignore[attr-defined]
        while known.keys() & value.symbols():
            value = value.substitute(known)
        return value

    @cached_property
    def depth(self) -> Formula:
        """v₁ = sin² θ₀ q/(h + R), by how much cos θ grows less up to the other end."""
        if self.never is not None:
            return add(self.cosine, negate(self.never))
        return multiply(self.sine, self.start) / add(self.middle, self.root)

    @cached_property
    def vertical(self) -> Formula:
        """P = φ̇₀ sin² θ₀ + a u₀, the angular momentum about the vertical over I₁."""
        return add(multiply(self.rate, self.sine), multiply(self.spin, self.cosine))

    def beside_vertical(self, end: Formula) -> int | None:
        """Whether it passes through the vertical at u = ± 1, comes ever nearer to it, or turns before: the sign of b u₀ + φ̇₀² sin² θ₀ ∓ b,
        where P = ± a; None where it is kept off, as u̇² = −(P ∓ a)² there."""
        if not self.before.moment.held.vanishes(
            self.before.tensors.spelled(add(self.vertical, negate(multiply(end, self.spin))))
        ):
            return None
        gap = multiply(self.pull, add(self.cosine, negate(end)))
        return self.side(add(gap, multiply(square(self.rate), self.sine)), "whether it passes through the vertical")

    @cached_property
    def never(self) -> Formula | None:
        """The end u = ± 1 to which it comes ever nearer; None where it comes back."""
        return next((end for end in VERTICAL if self.beside_vertical(end) == 0), None)

    def from_end(self, tilt: Formula) -> Formula:
        """√(½ (1 ∓ u)), the sine of half the angle from the end to which it comes ever nearer."""
        half = heading(tilt / 2)
        return half.sin() if self.never == ONE else half.cos()

    def refuse_through_vertical(self, what: str) -> None:
        """Refuse what has no meaning where the axis passes through the vertical."""
        if any(self.beside_vertical(end) == 1 for end in VERTICAL):
            raise NotYet(
                f"the axis of `{self.name}` passes through the vertical: {what}",
                help="`time` to a state with its `tilt`",
            )

    # times

    def half(self) -> Formula:
        """Half a nutation, K(m)/p."""
        return call("ellipk", self.parameter) / self.pace

    def share(self, tilt: Formula) -> Formula:
        """x² of a tilt: 0 at the start, 1 at the other end."""
        gone = add(self.cosine, negate(heading(tilt).cos()))
        share = gone / self.depth
        if self.nearer:
            share = multiply(share, 2 * self.root) / add(add(self.middle, self.root), multiply(self.pull, gone))
        return share

    def end_at(self, tilt: Formula) -> int | None:
        """0 of the tilt of the start, 1 of the other end, None of a tilt between; others are refused, since it does not come there."""
        share = self.told(self.share(tilt))
        if self.side(share, "on which side the tilt lies") == 0:
            return 0
        beyond = self.side(add(share, negate(ONE)), "how far it nods")
        if beyond > 0 or self.side(share, "") < 0:
            where = f"between its tilt at `{self.before.moment.when}` and another end"
            raise NotYet(f"`{self.name}` does not come to that tilt: it nods {where}")
        return None if beyond else 1

    def up_to(self, tilt: Formula, state: str) -> Formula:
        """The time from the start to a tilt on the way to the other end, F(arcsin x, m)/p, or arcosh y/p where it never comes there."""
        if self.never is not None:
            words = "ratio of the sines of half its angles to the vertical, cosh p t"
            near = self.from_end(self.tilt) / self.from_end(tilt)
            return acosh(self.letter("cosh of the argument", "y", NONE, near, words, state)) / self.pace
        words = "sine of the amplitude, by how far it has nodded"
        sine = self.letter("sine of the amplitude", "x", NONE, sqrt(self.share(tilt)), words, state)
        return call("ellipf", call("asin", sine), self.parameter) / self.pace

    # angles

    def gained(self) -> Formula:
        """How far the axis goes round the vertical in half a nutation: φ̇ = (P − a u)/(1 − u²), P = φ̇₀ sin² θ₀ + a u₀, over time, is
        ½ p⁻¹ ((P − a)/(1 − u) Π(n₁, m) + (P + a)/(1 + u) Π(n₂, m)), n₁ = δ/(1 − u), n₂ = −δ/(1 + u), with u that of one end and u + δ
        that of the other; where b q ≥ 0 u is that of the other end than the start."""
        self.refuse_through_vertical("how far it goes round has no meaning")
        far = add(self.cosine, negate(self.depth))
        words = "cosine of the tilt at the other end"
        u = self.letter("cosine at the other end", "u_1", NONE, far, words) if self.nearer else self.cosine
        step = self.depth if self.nearer else negate(self.depth)
        found: Formula = ZERO
        for sign, letter in zip(VERTICAL, ("n_1", "n_2"), strict=True):
            above, below = add(self.vertical, negate(multiply(sign, self.spin))), add(ONE, negate(multiply(sign, u)))
            if self.before.moment.held.vanishes(self.before.tensors.spelled(above)):
                continue
            share = self.letter(
                f"characteristic {letter}", letter, NONE, multiply(sign, step) / below, "characteristic of Π"
            )
            found = add(found, multiply(above / below, call("ellippi", share, self.parameter)))
        return found / (2 * self.pace)


class Place(Struct, frozen=True):
    """Where in its nutation a top is: at the tilt on its way from an end to the other one, after so many such ways; at the end itself."""

    state: str
    ways: int = 0
    tilt: Formula | None = None


def time_up_to(nutation: Nutation, place: Place) -> Formula:
    """The time up to a place from the tilt from which the nutation is told."""
    back = place.ways % 2
    ends = place.ways + (back if place.tilt is not None else 0)
    whole = multiply(formula(ends), nutation.half()) if ends else ZERO
    if place.tilt is None:
        return whole
    own = nutation.up_to(place.tilt, place.state)
    return add(whole, negate(own) if back else own)


def next_place(nutation: Nutation, place: Place, moment: SpaceMoment) -> Place:
    """Where a top is at a later state, to which it comes the first time after that before: at an end, or at a tilt."""
    name, line = nutation.name, moment.line(nutation.name, "tilt")
    tilt = moment.told(name, "tilt")
    if line is not None and line.word in EXTREMES:
        end: int | None = (line.word == "largest") == nutation.sinks
    elif tilt is None:
        raise NotYet(f"when `{name}` comes to `{moment.when}` nothing tells", help=f"tell its `{name}.tilt` there")
    else:
        end = nutation.end_at(tilt)
    if tilt is not None and end == 0:
        message = f"`{name}` is at the tilt from which it nods at `{moment.when}`"
        raise NotYet(message, help=f"say `{name}.tilt: {'smallest' if nutation.sinks else 'largest'}` there")
    if tilt is None or end is not None:
        later = place.ways + 1
        return Place(moment.when, later if later % 2 == end else later + 1)
    if place.tilt is None:
        return Place(moment.when, place.ways, tilt)
    further = multiply(add(heading(place.tilt).cos(), negate(heading(tilt).cos())), nutation.start)
    side = nutation.side(further, f"from which side it comes to `{moment.when}`")
    if not side:
        raise NotYet(
            f"`{name}` comes to `{moment.when}` from the same tilt: when is not told", help="name what is between"
        )
    return Place(moment.when, place.ways + ((side > 0) == bool(place.ways % 2)), tilt)


def chain_to(timeline: Timeline, end: str) -> list[str]:
    """The states that lead to one with no event between, that included."""
    chain = [end]
    while (before := timeline.before(chain[-1])) is not None and before.event is None:
        chain.append(before.start)
    return chain[::-1]


def places_of(dynamics: Mapping[str, SpaceLaws], chain: list[str], name: str) -> tuple[Nutation, dict[str, Place]]:
    """The nutation of a top from the first of some states on, and where it is in it at each."""
    nutation, place = Nutation(dynamics[chain[0]], name), Place(chain[0])
    places = {chain[0]: place}
    for state in chain[1:]:
        places[state] = place = next_place(nutation, place, dynamics[state].moment)
    return nutation, places


def angle_between(dynamics: Mapping[str, SpaceLaws], timeline: Timeline, term: Term) -> tuple[Meaning, str] | None:
    """How far the axis of a top that nods goes round the vertical from one end of its nutation to another; None where that is told."""
    start, end, name = term.start or "", term.end or "", term.path.owner
    moment, chain = dynamics[end].moment, chain_to(timeline, end)
    told = moment.told(name, "precession_angle") is not None or moment.goes_on(name) or moment.keeps_momentum(name)
    if told or start not in chain or not moment.nods(name):
        return None
    nutation, places = places_of(dynamics, chain, name)
    if any(places[state].tilt is not None for state in (start, end)):
        message = f"how far `{name}` goes round the vertical from `{start}` to `{end}` is solved from end to end of its nutation"
        raise NotYet(message, term.path.span, "name states with `tilt: largest` or `smallest`; `rotsolve simulate`")
    gone = multiply(formula(places[end].ways - places[start].ways), nutation.gained())
    laws = (*nutation.laws, *nutation.before.tensors.behind(nutation.told(gone)))
    label = "precession in the course of the nutation, ∫ φ̇ dt"
    return Meaning(gone, QUANTITIES["precession_angle"].dimension, label=label, laws=laws), end


def time_between(dynamics: Mapping[str, SpaceLaws], timeline: Timeline, term: Term) -> tuple[Meaning, str]:
    """The time from one state to a later one of a top that nods, without an event between."""
    start, end = term.start or "", term.end or ""
    chain = chain_to(timeline, end)
    if start not in chain:
        message = f"how long it takes from `{start}` to `{end}` is not solved in space"
        raise NotYet(
            message, term.path.span, "solved is the nutation of a top from state to state, with no event between"
        )
    later = chain[chain.index(start) + 1 :]
    told = [time for state in later if (time := dynamics[state].moment.state.time_told) is not None]
    if len(told) == len(later):
        return Meaning(total(told), QUANTITIES["time"].dimension, label="times that the states tell"), end
    moment = dynamics[end].moment
    names = [name for name in moment.held.order if moment.nods(name)]
    if len(names) != 1:
        message = f"how long it takes from `{start}` to `{end}` is not solved in space"
        raise NotYet(message, term.path.span, "solved is the nutation of one top that states call by its `tilt`")
    nutation, places = places_of(dynamics, chain, names[0])
    gone = simplify(add(time_up_to(nutation, places[end]), negate(time_up_to(nutation, places[start]))))
    label = "time of the nutation, K(m)/p from end to end"
    if nutation.never is not None:
        label = "time on the way to the vertical, which it never reaches, arcosh y/p"
    laws = (*nutation.laws, *nutation.before.tensors.behind(nutation.told(gone)))
    return Meaning(gone, QUANTITIES["time"].dimension, label=label, laws=laws), end


def nutation_period(laws: SpaceLaws, name: str) -> Meaning:
    """2 K(m)/p, in which the tilt of a top comes back."""
    nutation = Nutation(laws, name)
    nutation.refuse_through_vertical("its tilt comes back before its swing does, and its period is not told")
    whole = 2 * nutation.half()
    told = (*nutation.laws, *laws.tensors.behind(nutation.told(whole)))
    return Meaning(whole, QUANTITIES["period"].dimension, label="period of the nutation, T = 2 K(m)/p", laws=told)
