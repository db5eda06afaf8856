"""Lagrangian of bodies in space: Euler angles of what nods, angles on hinges and axles, ways on slides, places of what is free.

T and the powers come from a moment at which all angles, ways and rates are letters, those of what is led along among them; what the
scene says of a moment is put in behind the derivatives (Goldstein, Poole & Safko, Classical Mechanics, §5.7).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from functools import cached_property

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import HALF, ONE, ZERO, Formula, Symbol, add, multiply, negate, total
from rotsolve.core.derivation import NEXT
from rotsolve.core.equation import DIVIDED_TILTS, TURNING_TILTS, Equation
from rotsolve.core.faults import Unsolvable
from rotsolve.core.lagrangian import GeneralizedCoordinate, Lagrangian, PageLetters, order_on_page
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.registry import Registry, SceneQuantity
from rotsolve.core.remembered import remembered
from rotsolve.core.symbols import COURSE, TIME
from rotsolve.core.vectors.heading import heading
from rotsolve.core.vectors.triple import (
    AXES,
    Triple,
    cross_product,
    dot_product,
    minus,
    square,
    triple,
    vector_sum,
)
from rotsolve.core.writing import flat, spoken
from rotsolve.language.bodies import Joint
from rotsolve.language.problem import State
from rotsolve.laws.lagrange import lagrangian_words
from rotsolve.laws.table import KEPT, MOTION, BetweenMoments, OfMotion, equations_for
from rotsolve.space.arrangement import ANGLES, RATES, JointedBodies
from rotsolve.space.attitude import NODE, Attitude, Nodding, as_drawn, in_euler_angles, nodding, permutation
from rotsolve.space.energies import kinetic_energies
from rotsolve.space.laws import SpaceLaws
from rotsolve.space.moment import SpaceMoment
from rotsolve.space.passing import left_alone, turning_tilts
from rotsolve.space.pushes import Pushes
from rotsolve.space.scene import SpaceEquations
from rotsolve.space.sliding import lead, slid_to, sliding_rate

MOVING = ("velocity", "acceleration")
CHANGE = "change of "  # in front of the word of a rate of what is led along


class LetteredMoment(SpaceMoment):
    """A moment of which nothing is told: all places and rates are letters, by which T is differentiated."""

    def letter(self, word: str, owner: str, component: str = "", *, like: str = "", printed: str = "") -> Symbol:
        """The letter of a place or rate, with the dimension of a word of the language."""
        entry = QUANTITIES[like or word]
        quantity = SceneQuantity(word, owner, self.when, component, printed or entry.letter, entry.dimension)
        self.registry.ask(quantity)
        return quantity.symbol

    def letters(self, word: str, owner: str, like: str) -> Triple:
        """Three of them, one along each axis."""
        return triple([self.letter(word, owner, axis, like=like) for axis in AXES])

    @remembered
    def nodding(self, name: str) -> Nodding:
        angles, rates = (triple([self.letter(word, name) for word in words]) for words in (ANGLES, RATES))
        return Nodding(angles, rates, triple([self.rate_of(word, name) for word in RATES]))

    def _nods(self, name: str) -> Attitude:
        """By its Euler angles, with ψ̇ itself."""
        axis = self.held.axis(name)
        if axis is None:
            raise Unsolvable(f"`{name}` has no axis")
        found = nodding if self.held.turns_round(name, axis) else in_euler_angles
        return found(self.nodding(name), permutation(axis))

    def _anyhow(self, name: str) -> Attitude:
        """Of a body that is told by ω along its own axes no coordinates have these rates."""
        if self.held.rolling(name) is not None:
            raise nonholonomic(name)
        if not self.held.pointlike(name):
            help = f"tell how it stands and turns by `{name}.tilt` and its rates"
            raise Unsolvable(
                f"`{name}` is told by its angular velocity, whose parts are no rates of coordinates", help=help
            )
        return super()._anyhow(name)

    def hinge_angle(self, name: str, joint: Joint) -> Formula | None:
        return self.letter("angle", name)

    def driven(self, name: str, joint: Joint, word: str) -> tuple[Formula, Formula]:
        return self.letter(word, name), self.rate_of(word, name)

    def _led(self, name: str, led: Sequence[tuple[str, str, Formula]]) -> Attitude:
        """What is led along, by the parts of ω along its own axes."""
        omega, alpha = (self.letters(f"{kind}angular_velocity", name, "angular_velocity") for kind in ("", CHANGE))
        return as_drawn(self.turned(name), omega, alpha)

    @remembered
    def _of_reference(self, name: str, word: str) -> Triple:
        """Of what is led along by its parts along its own axes."""
        joint = self.held.main(name)
        if joint is None and self.held.bodies[name].moved:
            return self.letters("velocity", name, "velocity")
        return super()._of_reference(name, word)

    def slid_by(self, joint: Joint) -> Formula:
        """How far a body has slid."""
        if joint.pitch is not None:
            return multiply(lead(joint.pitch), self.letter("angle", joint.body.owner))
        return self.letter("displacement", joint.owner, printed="x")

    def place(self, name: str, axis: str) -> Symbol:
        """A coordinate of the centre of mass of a free body."""
        return self.letter(f"place {axis}", name, like="displacement", printed=axis)


def by_lagrange_in_space(scene: SpaceEquations) -> Iterator[Equation]:
    """Lagrange's equations at each state, and what is conserved over phases."""
    known = {state: list(motions_in_space(scene, laws)) for state, laws in scene.dynamics.items()}
    for state, laws in scene.dynamics.items():
        for motions in known[state]:
            now = motions.putting_in(laws)
            for equation in equations_for(MOTION, OfMotion(motions.motion, now, state, motions.names)):
                yield of_what_nods(equation, motions.names, laws)
    for interval in scene.configuration.timeline.intervals:
        before, after = scene.dynamics[interval.start], scene.dynamics[interval.end]
        for motions in known[interval.start] if interval.event is None else ():
            ends = motions.putting_in(before), motions.putting_in(after)
            yield from equations_for(KEPT, BetweenMoments(motions.motion, *ends, interval.name, motions.names))
            for name in (name for name in motions.names if left_alone(before, name)):
                tilts = map(scene.put_in_order, turning_tilts(name, interval, before, after))
                for law, found in zip((TURNING_TILTS, DIVIDED_TILTS), tilts, strict=False):
                    words = (*lagrangian_words(motions.motion), NEXT, *found.remark)
                    yield law.equation(found.left, found.right, interval.name, (name,), words)


def of_what_nods(equation: Equation, names: Sequence[str], laws: SpaceLaws) -> Equation:
    """An equation of what nods divided by sin θ, where that is a factor of it and not 0; of a fast spin without what is small then."""
    for name in (name for name in names if laws.moment.nods(name)):
        left, right, remark = laws.without_sine(name, equation.left, equation.right)
        said, relation = ((NEXT, *remark) if remark else ()), equation.relation
        if laws.fast:
            left, fast = laws.of_fast_spin(name, left)
            said, relation = (*said, *((NEXT, *fast) if fast else ())), "≈" if fast else relation
        equation = replace(equation, left=left, right=right, remark=(*equation.remark, *said), relation=relation)
    return equation


def motions_in_space(scene: SpaceEquations, laws: SpaceLaws) -> Iterator[MotionsInSpace]:
    """How bodies that carry each other can move, group by group; why none is written of others is noted."""
    course = course_of(laws)
    for group in carried_together(laws.moment.held):
        found = MotionsInSpace(course, group, laws.moment)
        try:
            if found.motion.coordinates and found.motion.closed:
                yield found
        except Unsolvable as error:
            scene.not_restated.append(error.fault.message)


def course_of(laws: SpaceLaws) -> SpaceLaws:
    """The laws at a moment at which all places and rates are letters."""
    moment = laws.moment
    lettered = LetteredMoment(moment.held, Registry(), State(COURSE + moment.when), moment.arrangement)
    return SpaceLaws(lettered, Pushes(lettered, laws.pushes.gravity, laws.pushes.actions), laws.tensors)


def carried_together(held: JointedBodies) -> list[tuple[str, ...]]:
    """The bodies by groups of those that carry each other, what carries others before these."""
    groups: list[tuple[str, ...]] = []
    for name in held.order:
        carrier = held.carrier(name)
        own = next((group for group in groups if carrier in group), None) if carrier else None
        if own is not None:
            groups.remove(own)
        groups.append((*(own or ()), name))
    return groups


class MotionsInSpace(Struct, frozen=True, dict=True):
    """Bodies that carry each other, at a moment at which places and rates are letters; `first` is that from which on they move so."""

    laws: SpaceLaws
    names: tuple[str, ...]
    first: SpaceMoment

    @property
    def moment(self) -> LetteredMoment:
        assert isinstance(self.laws.moment, LetteredMoment)
        return self.laws.moment

    @cached_property
    def free(self) -> tuple[Freedom, ...]:
        """The coordinates of all bodies, those that are driven too."""
        return tuple(item for name in self.names for item in self._of_body(name))

    def _of_body(self, name: str) -> Iterator[Freedom]:
        moment, held = self.moment, self.moment.held
        if any(joint.rolls or joint.flat for joint in held.of_body(name)):
            raise nonholonomic(name)
        joint, led = held.main(name), bool(held.bodies[name].moved)
        if joint is not None and joint.motor:
            raise Unsolvable(f"a motor turns `{name}`, whose work nothing tells", help="Newton's laws give it")
        if led:
            yield from self._of_led(name)
        elif joint is None:
            for axis in AXES:
                rate, change = (moment.ask(word, name, axis) for word in MOVING)
                yield Freedom(rate, change, moment.place(name, axis), f"place of {spoken(name)} along {axis}")
        if joint is None or joint.free:
            turning = moment.nodding(name) if moment.nods(name) else None
            parts = zip(ANGLES, turning.rates, turning.seconds, turning.angles, strict=True) if turning else ()
            for word, rate, change, place in parts:
                yield Freedom(rate, change, place, f"{spoken(word)} of {spoken(name)}", led)
            return
        if joint.turning:
            rate, change = moment.driven(name, joint, turning_word(name, joint, moment))
            words = f"angle of {spoken(name)} about {spoken(joint.owner)}"
            evenly = moment.held.driven_evenly(joint)
            yield Freedom(rate, change, moment.letter("angle", name), words, bool(joint.drive), evenly)
        if joint.sliding and joint.pitch is None:
            rate, change = (sliding_rate(joint, moment, word) for word in MOVING)
            yield Freedom(rate, change, moment.slid_by(joint), f"way of {spoken(name)} along {spoken(joint.owner)}")

    def _of_led(self, name: str) -> Iterator[Freedom]:
        """The parts of the rates of what is led along, along its own axes: of these there are no places."""
        for word in ("velocity", "angular_velocity"):
            pairs = (self.moment.letters(f"{kind}{word}", name, word) for kind in ("", CHANGE))
            yield from (Freedom(rate, change, None) for rate, change in zip(*pairs, strict=True))

    @cached_property
    def motion(self) -> Lagrangian:
        """T, the powers, and how places and rates grow."""
        kinetic = tuple(term for name in self.names for term in self._kinetic(name))
        spoken_of = {name for term in kinetic for name in term.symbols()}
        growth = {item.place.name: item.rate for item in self.free if isinstance(item.place, Symbol)}
        own = [item for item in self.free if not item.driven and item.rate.symbols() <= spoken_of]
        coordinates = [
            GeneralizedCoordinate(item.place, item.rate.name, item.words)
            for item in own
            if isinstance(item.rate, Symbol) and isinstance(item.place, Symbol)
        ]
        powers = [(owner, simplify(power)) for name in self.names for owner, power in self._powers(name)]
        upright = not any(self.moment.held.bodies[name].moved for name in self.names)
        changes = {rate: item.change for item in self.free for rate in item.rate.symbols()}
        page = PageLetters(self.moment.registry, self.first.registry, lambda item: self._same(item, self.first))
        return Lagrangian(
            tuple(coordinates),
            kinetic,
            tuple(power for weighs, power in powers if weighs and upright and power != ZERO),
            tuple(power for weighs, power in powers if not (weighs and upright) and power != ZERO),
            {**growth, TIME: ONE},
            changes,
            page.letters(coordinates, growth, changes),
            order=self.order,
            positive=frozenset(self.moment.positive),
            steady=frozenset(item.rate.name for item in self.free if item.evenly and isinstance(item.rate, Symbol)),
            turned=frozenset(item.place.name for item in self.free if item.driven and isinstance(item.place, Symbol)),
        )

    def _kinetic(self, name: str) -> Iterator[Formula]:
        """The terms of T of a body; of one that only travels in space by the rates of its places."""
        turning, travelling = kinetic_energies(self.laws, name)
        if self.moment.held.main(name) is None:
            parts = self.moment.of_centre(name, "velocity")
            mass = self.moment.held.mass(name)
            travelling = total([multiply(multiply(HALF, mass), square(part)) for part in parts])
        else:
            travelling = min((travelling, self.tidy(travelling)), key=length)
        yield from flat([turning, travelling])

    def _powers(self, name: str) -> Iterator[tuple[bool, Formula]]:
        """The powers of the weight, and of the forces and couples that act from outside, in any motion."""
        pushes, moment = self.laws.pushes, self.moment
        weight = pushes.weight(name)
        acting = [pushes.by_action(item) for item in pushes.actions if any(ref.owner == name for ref in item.touches())]
        own = moment.attitude(name)
        for push in [*([weight] if weight is not None else []), *acting]:
            velocity = vector_sum(moment.reference_velocity(name), cross_product(own.omega, push.arm))
            power = add(
                dot_product(push.along(own.axes), velocity), dot_product(push.axes.to(own.axes, push.couple), own.omega)
            )
            yield push is weight, power

    @property
    def order(self) -> tuple[str, ...]:
        """All letters in the order in which a textbook writes them in a product."""
        givens = self.moment.held.problem.givens
        return order_on_page(givens, (self.moment.registry, self.first.registry))

    def tidy(self, value: Formula) -> Formula:
        return simplify(value, order=self.order, positive=self.moment.positive)

    def putting_in(self, laws: SpaceLaws) -> Callable[[Formula], Formula]:
        """What puts in for the letters of places and rates what they are at a moment."""
        real, values = laws.moment, dict[str, Formula]()
        values[TIME] = real.now(Symbol(TIME))
        for name in self.names:
            found = tuple(self._of_body(name))
            for item, (rate, change, place) in zip(found, self._at(name, real), strict=True):
                pairs = (item.rate, rate), (item.change, change), (item.place, place)
                values |= {letter.name: value for letter, value in pairs if isinstance(letter, Symbol)}
        others = {key: item for key, item in self.moment.registry.quantities.items() if key not in values}
        values |= {key: self._same(item, real) for key, item in others.items()}
        return lambda value: simplify(value.substitute(values), order=self.order, positive=real.positive)

    def _same(self, quantity: SceneQuantity, real: SpaceMoment) -> Formula:
        """What another quantity of the letters' moment, such as a force, is at a moment."""
        same = replace(quantity, when=quantity.when.replace(self.moment.when, real.when))
        real.registry.quantities.setdefault(same.key, same)
        return real.registry.known.get(same.key, same.symbol)

    def _at(self, name: str, real: SpaceMoment) -> Iterator[tuple[Formula, Formula, Formula]]:
        """The rates of a body's coordinates at a moment, how these change, and the places, in their order."""
        held, joint = real.held, real.held.main(name)
        if held.bodies[name].moved:
            own, velocity = real.attitude(name), real.reference_velocity(name)
            swept = minus(cross_product(own.omega, velocity))
            yield from same_place(velocity, vector_sum(real.reference_acceleration(name), swept))
            yield from same_place(own.omega, own.rates)
        elif joint is None:
            unknown = [self.moment.place(name, axis) for axis in AXES]
            yield from zip(*(real.of_centre(name, word) for word in MOVING), unknown, strict=True)
        if joint is None or joint.free:
            yield from nodding_at(name, real) if real.nods(name) else ()
            return
        if joint.turning:
            rate, change = real.driven(name, joint, turning_word(name, joint, real))
            angle = real.hinge_angle(name, joint)
            yield rate, change, angle if angle is not None else real.ask("angle", name) if real.later else ZERO
        if joint.sliding and joint.pitch is None:
            rates = [sliding_rate(joint, real, word) for word in MOVING]
            gone = slid_to(joint, real) if real.later else real.slid_by(joint)
            yield rates[0], rates[1], real.ask("displacement", joint.owner) if gone is None else gone


class Freedom(Struct, frozen=True):
    """A rate with its own rate, the place of which it is the rate, in words; `driven` where it is given, `evenly` where it stays."""

    rate: Formula
    change: Formula
    place: Formula | None
    words: str = ""
    driven: bool = False
    evenly: bool = False


def turning_word(name: str, joint: Joint, moment: SpaceMoment) -> str:
    """The word for the rate of a body about its hinge or axle."""
    return "spin" if joint.aligned and moment.held.carrier(name) else "angular_velocity"


def same_place(rates: Triple, changes: Triple) -> Iterator[tuple[Formula, Formula, Formula]]:
    yield from ((rate, change, ZERO) for rate, change in zip(rates, changes, strict=True))


def nodding_at(name: str, real: SpaceMoment) -> Iterator[tuple[Formula, Formula, Formula]]:
    """φ, θ, ψ with their rates at a moment; ψ̇ = ω₃ − φ̇ cos θ where ω₃ is told instead."""
    turning, own = real.nodding(name), real.attitude(name)
    (precession, nutation, spin), (further, faster, spun) = turning.rates, turning.seconds
    if own.axes.name == NODE:
        cos, sin = heading(turning.angles[1]).cos(), heading(turning.angles[1]).sin()
        spin = add(own.omega[2], negate(multiply(precession, cos)))
        swept = add(multiply(further, cos), negate(multiply(multiply(precession, nutation), sin)))
        spun = add(own.rates[2], negate(swept))
    yield from zip((precession, nutation, spin), (further, faster, spun), turning.angles, strict=True)


def nonholonomic(name: str) -> Unsolvable:
    """That a body rolls, which its coordinates do not tell."""
    message = f"`{name}` rolls: in space that ties its rates, and not its coordinates (it is nonholonomic)"
    return Unsolvable(message, help="Newton's laws give it")
