"""Lagrangian of bodies in the plane: the motions that their ties allow, told at a moment at which all places and speeds are letters.

T and the powers come from the facts of that moment, of which the rates of what is tied are put in by those of independent coordinates; what
the scene says of a moment is put in behind the derivatives.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import cached_property

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.linear import solve_linear
from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import ZERO, Formula, Symbol, divide, multiply, total
from rotsolve.core.equation import Equation
from rotsolve.core.facts import BodyFacts, Facts, Force, Role, signed
from rotsolve.core.lagrangian import GeneralizedCoordinate, Lagrangian, PageLetters, order_on_page
from rotsolve.core.passage import Passage
from rotsolve.core.quantity import QUANTITIES
from rotsolve.core.registry import Registry, SceneQuantity
from rotsolve.core.symbols import COURSE, GENERIC, TIME, SymbolKey, key_of
from rotsolve.core.vectors.heading import TURNS
from rotsolve.core.writing import spoken
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.equations.states import rates_of_body
from rotsolve.laws.energy import kinetic
from rotsolve.laws.table import KEPT, MOTION, BetweenMoments, OfMotion, equations_for
from rotsolve.motion.configuration import groups_of
from rotsolve.motion.freebody import free_bodies
from rotsolve.motion.instant import Instant

MOVING = ("velocity", "acceleration")
TURNING = ("angular_velocity", "angular_acceleration", "angle", "rotation")


def by_lagrange(scene: SceneEquations) -> Iterator[Equation]:
    """Lagrange's equations at each state, in the midst of phases in which forces vary, and of swings; and what is conserved over phases."""
    configuration = scene.configuration
    known = {state.name: list(motions_of(scene, state.name, scene.modes)) for state in configuration.timeline.states}
    for state in configuration.timeline.states:
        yield from at_moment(known[state.name], scene.instant(state.name), scene.section(state.name))
    for interval in configuration.timeline.intervals:
        if interval.name not in scene.passages or configuration.timeline.at_rest(interval):
            continue
        if configuration.mentions.runs or scene.varies(interval):
            yield from at_moment(known[interval.start], scene.instant(interval.start, generic=True), interval.name)
        for motions in (one for one in known[interval.start] if not one.drift):
            ends = motions.at_ends(scene.passages[interval.name])
            works = motions.works(scene.passages[interval.name])
            yield from equations_for(KEPT, BetweenMoments(motions.motion, *ends, interval.name, motions.names, works))
    for swing in scene.swings.values():
        near = [one for one in motions_of(scene, swing.near.state, {}) if set(one.names) & swing.group]
        if swing.found:
            yield from at_moment(near, swing.rest, swing.balanced)
        yield from at_moment(near, swing.near, swing.section)


def at_moment(moving: Iterable[Motions], instant: Instant, section: str) -> Iterator[Equation]:
    """Lagrange's equations of all that moves at a moment."""
    for motions in moving:
        now = motions.putting_in(instant)
        if not all(is_zero(now(gap)) for gap in motions.drift):
            named = ", ".join(f"`{name}`" for name in motions.names)
            motions.scene.not_restated.append(f"what ties {named} is told for one moment alone")
            continue
        yield from equations_for(MOTION, OfMotion(motions.motion, now, section, motions.names))


def motions_of(scene: SceneEquations, state: str, modes: Mapping[str, str]) -> Iterator[Motions]:
    """How each group of tied bodies can move from a state on; why nothing is written of others is noted."""
    course = Instant(scene.configuration, Registry(), state, True, modes, virtual=True, mark=COURSE)
    facts = free_bodies(course)
    for group in groups_of(scene.configuration, facts, state):
        bodies = [body for body in facts.bodies if body.name in group]
        found = Motions(scene, course, facts, tuple(bodies), scene.instant(state))
        named = ", ".join(f"`{name}`" for name in found.names)
        if any(body.changing or body.sliding for body in bodies):
            scene.not_restated.append(f"the inertia of {named} changes on the way, or something slides on it")
        elif found.ties is None or not found.motion.closed:
            scene.not_restated.append(f"what is said of the motion of {named} does not tie places")
        elif found.motion.coordinates:
            yield found


class Motions(Struct, frozen=True, dict=True):
    """A group of tied bodies, whose places and speeds are letters; `first` is the moment at which its motion starts.

    The speeds are those of any motion that the rules allow: what forces go by are other letters, so that no derivative is taken by them.
    """

    scene: SceneEquations
    course: Instant
    facts: Facts
    bodies: tuple[BodyFacts, ...]
    first: Instant

    @property
    def names(self) -> tuple[str, ...]:
        return tuple(body.name for body in self.bodies)

    @cached_property
    def rates(self) -> list[str]:
        """The letters of all rates, those first that would be coordinates: what is asked, ways along lines, turns, ways in the plane."""
        found = [(body, rate.name) for body in self.bodies for rate in self._rates_of(body)]
        return [name for body, name in sorted(found, key=lambda item: self._rank(*item))]

    def _rates_of(self, body: BodyFacts) -> Iterator[Symbol]:
        yield from (rate for rate in rates_of_body("velocity", self.course, body.name) if isinstance(rate, Symbol))

    def _rank(self, body: BodyFacts, rate: str) -> tuple[bool, int]:
        turns, free = key_of(rate).turns, body.motion.kind == "plane"
        asked = {
            (self.course.host(term.path.owner), term.path.quantity in TURNING)
            for find in self.scene.configuration.problem.finds
            for term in find.terms
            if term.path.owner in self.scene.configuration.bodies and not term.path.point
        }
        wanted = (body.name, turns) in asked and (turns or not free)
        return not wanted, 1 if turns else 2 if free else 0

    @cached_property
    def driven(self) -> frozenset[str]:
        """The letters of rates that drives give."""
        given = (letter for item in self.facts.given for letter in item.letters.values())
        return frozenset(name for letter in given for name in letter.symbols()) & frozenset(self.rates)

    @cached_property
    def ties(self) -> dict[str, Formula] | None:
        """The rates that the rules tell by the others; None where a rule is for one moment alone, or does not tell one here."""
        found: dict[str, Formula] = {}
        now = self.putting_in(self.first)
        for rule in self.facts.rules:
            if not set(self.names) & set(rule.bodies):
                continue
            if rule.acceleration is None:
                return None
            gap = simplify((rule.velocity[0] - rule.velocity[1]).substitute(found))
            if is_zero(gap):
                continue
            name = next((name for name in self._leaving(gap) if not self._vanishes(now(differentiate(gap, name)))), "")
            value = solve_linear(gap, name) if name else None
            if value is None:
                return None
            found = {other: simplify(told.substitute({name: value})) for other, told in found.items()} | {name: value}
        return found

    @cached_property
    def drift(self) -> tuple[Formula, ...]:
        """What the rules for accelerations differ by from what those for rates become in time: nothing where they hold on the way too."""
        assert self.ties is not None
        whole, found = replace(self.motion, growth=dict(self._places())), []
        for rule in self.facts.rules:
            if set(self.names) & set(rule.bodies) and rule.acceleration is not None:
                grown = whole.in_time(simplify(rule.velocity[0] - rule.velocity[1]))
                gap = grown - (rule.acceleration[0] - rule.acceleration[1])
                found.append(simplify(gap.substitute(self.ties)))
        return tuple(gap for gap in found if gap != ZERO)

    def _leaving(self, gap: Formula) -> list[str]:
        """The rates of a tie that it may tell, the least wanted as a coordinate first."""
        return [name for name in reversed(self.rates) if name in gap.symbols() and name not in self.driven]

    def _vanishes(self, slope: Formula) -> bool:
        return is_zero(slope) or self.scene.configuration.signs.by_numbers(slope) == 0

    @cached_property
    def motion(self) -> Lagrangian:
        """T, the powers, and how places and rates grow, by the rates of the independent coordinates."""
        assert self.ties is not None
        potentials = [item for item in self.facts.potentials if set(self.names) & set(item.bodies)]
        growth = {name: simplify(rate.substitute(self.ties)) for name, rate in self._places()}
        letters = [self._letter(rate, growth) for rate in self.rates if rate not in (*self.ties, *self.driven)]
        growth |= {q.letter.name: Symbol(q.rate) for q in letters if q.letter.name not in growth}
        powers = [(role, simplify(power.substitute(self.ties))) for role, power in self._powers()]
        changes = {rate.name: change for body in self.bodies for rate, change in self._changes(body)}
        page = PageLetters(self.course.registry, self.scene.registry, lambda quantity: self._at(quantity, self.first))
        return Lagrangian(
            tuple(letters),
            tuple(term for body in self.bodies for term in self._kinetic(body)),
            tuple(power for role, power in powers if role.weighs and power != ZERO),
            tuple(power for role, power in powers if not role.stores and power != ZERO),
            growth,
            changes,
            page.letters(letters, growth, changes),
            tuple(power for role, power in powers if role.stores and not role.weighs and power != ZERO),
            tuple(item.energy for item in potentials),
            self.order,
            frozenset(self.scene.configuration.positive),
        )

    @property
    def order(self) -> tuple[str, ...]:
        """All letters in the order in which a textbook writes them in a product."""
        givens = self.scene.configuration.problem.givens
        return order_on_page(givens, (self.course.registry, self.scene.registry))

    def _powers(self) -> Iterator[tuple[Role, Formula]]:
        """The power of each force and couple that some motion could have, with what it is to its body."""
        for body in self.bodies:
            for item in body.acting:
                if item.internal:
                    continue
                if isinstance(item, Force):
                    yield item.role, multiply(item.size, item.direction.dot(body.motion.velocity_of(item.arm)))
                else:
                    yield item.role, multiply(item.torque, body.motion.spin)

    def _places(self) -> Iterator[tuple[str, Formula]]:
        """The letters of angles, and of places on circles, with the rates at which they grow."""
        for body in self.bodies:
            letters = body.motion.orientation.formula().symbols()
            yield from ((name, body.motion.spin) for name in letters if key_of(name).kind == "angle")
            if body.motion.bend is not None:
                tangent, radius = body.motion.bend.outward.turned(90), body.motion.bend.radius
                for name in body.motion.bend.outward.formula().symbols():
                    yield name, divide(body.motion.velocity.along(tangent), radius)

    def _changes(self, body: BodyFacts) -> Iterator[tuple[Symbol, Formula]]:
        """The rates of a body with the letters of their own rates."""
        pairs = zip(*(rates_of_body(word, self.course, body.name) for word in MOVING), strict=True)
        yield from ((rate, change) for rate, change in pairs if isinstance(rate, Symbol))

    def _kinetic(self, body: BodyFacts) -> Iterator[Formula]:
        """½ m v² in one, and the other terms of T."""
        assert self.ties is not None
        terms = [term.substitute(self.ties) for term in kinetic([body])]
        if body.motion.kind == "plane" and len(terms) > 1:
            first, second, *terms = terms
            both = total([first, second])
            yield min((both, simplify(both, order=self.order)), key=length)
        yield from terms

    def _letter(self, rate: str, growth: Mapping[str, Formula]) -> GeneralizedCoordinate:
        """The coordinate of a rate: the angle of the body where one grows with it alone, else a letter of its own."""
        key = key_of(rate)
        letter = next((name for name in growth if self._tells(name, key.owner, growth, rate)), None)
        if letter is not None:
            return GeneralizedCoordinate(Symbol(letter), rate, f"angle of {spoken(key_of(letter).owner)}", TURNS[0])
        kind = QUANTITIES["rotation" if key.turns else "displacement"]
        plain = "phi" if key.turns else key.component or "x"
        own = SceneQuantity(kind.word, key.owner, COURSE, key.component, plain, kind.dimension)
        self.course.registry.quantities.setdefault(own.key, own)
        words = f"{'angle turned by' if key.turns else 'way of'} {spoken(key.owner)}"
        return GeneralizedCoordinate(own.symbol, rate, words, self._positive(key))

    def _tells(self, place: str, owner: str, places: Mapping[str, Formula], rate: str) -> bool:
        """Whether a place grows in proportion to a rate of its body."""
        pace = places[place]
        own = key_of(place).owner
        body = next(body for body in self.bodies if body.name == owner)
        circle = body.motion.bend is not None and place in body.motion.bend.outward.formula().symbols()
        turns = key_of(rate).turns
        alone = pace.symbols() & set(self.rates) == {rate} and not simplify(pace / Symbol(rate)).symbols() & set(places)
        return (circle if not turns else own == owner) and alone

    def _positive(self, rate: SymbolKey) -> str:
        """Which way the coordinate of a rate grows, in words."""
        if rate.turns:
            return self.course.turn_words(rate.owner)[0]
        return {"x": "right", "y": "up"}.get(rate.component) or self.course.line_words(rate.owner)[0]

    def works(self, over: Passage) -> tuple[Formula, ...]:
        """The works of what has no potential over a phase."""
        return tuple(work.amount for work in over.works if set(self.names) & set(work.bodies))

    # the moment that is looked at

    def at_ends(self, over: Passage) -> tuple[Callable[[Formula], Formula], Callable[[Formula], Formula]]:
        """What puts in for the letters what they are at both ends of a phase: ways count from its start."""
        changes = {(travel.body, travel.kind, travel.axis): travel.change for travel in over.travels}
        turns = {travel.body: signed(travel.change, travel.sense) for travel in over.travels if travel.kind == "turn"}
        ways: dict[str, Formula] = {}
        for q in self.motion.coordinates:
            key = key_of(q.letter.name)
            if key.when == COURSE:
                kind = "turn" if key.kind == "rotation" else "line"
                ways[q.letter.name] = changes.get((key.owner, kind, key.component), q.letter)
        first, last = (self.scene.instant(facts.state) for facts in (over.start, over.end))
        for body in self.bodies:  # of an angle that no state follows counts what is turned
            angle = self.course.angle(body.name)
            if isinstance(angle, Symbol) and first.angle(body.name) is None and body.name in turns:
                ways[angle.name] = turns[body.name]
        return self.putting_in(first, dict.fromkeys(ways, ZERO)), self.putting_in(last, ways)

    def putting_in(self, instant: Instant, ways: Mapping[str, Formula] | None = None) -> Callable[[Formula], Formula]:
        """What puts in for the letters of places and speeds what they are at a moment."""
        configuration = self.scene.configuration
        values: dict[str, Formula] = {TIME: instant.time(), **(ways or {})}
        for body in configuration.present(self.course.state):
            for word in MOVING:
                pairs = zip(*(rates_of_body(word, moment, body.name) for moment in (self.course, instant)), strict=True)
                values |= {rate.name: value for rate, value in pairs if isinstance(rate, Symbol)}
            angle = self.course.angle(body.name)
            if isinstance(angle, Symbol):
                known = instant.angle(body.name)
                if known is not None or angle.name not in values:
                    values[angle.name] = instant.offset(body.name).formula() if known is None else known
        others = {key: item for key, item in self.course.registry.quantities.items() if key not in values}
        values |= {key: self._at(quantity, instant) for key, quantity in others.items()}
        return lambda value: simplify(value.substitute(values), order=self.order, positive=configuration.positive)

    def _at(self, quantity: SceneQuantity, instant: Instant) -> Formula:
        """What a quantity of the letters' moment is at another one."""
        if quantity.when.startswith(GENERIC):
            return instant.since_first(quantity.kind, quantity.owner)
        own = replace(quantity, when=quantity.when.replace(self.course.when, instant.when))
        instant.registry.quantities.setdefault(own.key, own)
        return instant.registry.known.get(own.key, own.symbol)
