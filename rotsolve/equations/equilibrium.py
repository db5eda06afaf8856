"""Equilibrium: where the forces on bodies balance and drive them back, and the bodies placed there and displaced from it."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from msgspec import Struct, field
from msgspec.structs import replace

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.exact.linear import solve_linear
from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.exact.roots import solve_trig
from rotsolve.algebra.formula import ZERO, Call, Formula, Number, Symbol, add
from rotsolve.core.facts import BodyFacts, Facts, signed
from rotsolve.core.quantity import DAMPINGS
from rotsolve.core.registry import Registry
from rotsolve.core.symbols import (
    MIXED,
    NEAR,
    RATE,
    RATES,
    REST,
    TIME,
    VIRTUAL,
    SymbolKey,
    is_quantity,
    key_of,
    of_kinds,
    paths_in,
)
from rotsolve.core.writing import spoken
from rotsolve.equations.states import rates_of_body
from rotsolve.equations.swing import Swing, displacements, displacements_of_body, moving
from rotsolve.language.keys import Element, varying_values
from rotsolve.language.problem import MODE, Term
from rotsolve.laws import groups
from rotsolve.motion.configuration import Configuration, groups_of
from rotsolve.motion.freebody import free_bodies
from rotsolve.motion.instant import Instant
from rotsolve.paths.meaning import NotYet

PLACES = ("elongation", "angle")  # what balance decides
SEVERAL_WAYS = (
    "can move in several ways: solved are the periods, frequencies and shapes of their small swings, each by its own"
)
STATE_IT = "give a state with its angle and `balance: true`, and say `about` it"


def in_several_ways(facts: Facts, group: frozenset[str], terms: list[Formula]) -> bool:
    """Whether the rules let a group move in several ways."""
    rates, allowed = groups.freedom(facts, group, terms)
    return bool(rates) and allowed is None


def balanced_places(rest: Instant, still: Facts, group: frozenset[str], signs: SignOracle) -> dict[str, Formula]:
    """The letters of angles that balance decides by itself, and their stable values; none where springs have a say in them."""
    supplies = [term for body in still.bodies if body.name in group for term in groups.supply(body)]
    balance = groups.drive(still, group)
    if balance is None or in_several_ways(still, group, supplies):
        from rotsolve.equations.standing_modes import stable_angles

        return stable_angles(rest, still, group, signs)
    if balance == (ZERO, ZERO):
        raise NotYet("nothing drives these bodies back to an equilibrium: there are no swings")
    drive = where_it_rests(balance[0] - balance[1])
    letters = of_kinds(drive.symbols(), PLACES)
    calls = [node for node in drive.walk(Call) if isinstance(node, Call)]
    if not any(letter in node.symbols() for letter in letters for node in calls):  # in a sine or cosine
        root = solve_linear(drive, letters[0]) if len(letters) == 1 else None
        return {letters[0]: root} if isinstance(root, (Number, Symbol)) else {}
    if len(letters) > 1:
        raise NotYet("where these bodies are in equilibrium is not told", help=STATE_IT)
    slope = differentiate(drive, letters[0]) * turning_rate(letters[0], still, group)
    roots = solve_trig(drive, letters[0])
    if not roots:
        raise NotYet("the equilibrium has no closed form", help=STATE_IT)
    stable = [root for root in roots if signs.of_sizes(slope.substitute({letters[0]: root})) == -1]
    if len(stable) != 1:
        raise NotYet("the stable equilibrium is not told", help=STATE_IT)
    return {letters[0]: simplify(stable[0])}


def where_it_rests(drive: Formula) -> Formula:
    """What drives a group where it rests: the motion along which that works is only thought of, and as slow as one likes."""
    thought_of = [name for name in of_kinds(drive.symbols(), RATES) if VIRTUAL in key_of(name).when]
    return simplify(drive.substitute(dict.fromkeys(thought_of, ZERO))) if thought_of else drive


def turning_rate(angle: str, still: Facts, group: frozenset[str]) -> Formula:
    """How fast an angle grows, counterclockwise, when the group's one free rate is 1."""
    grown = growth_rate(angle, (body for body in still.bodies if body.name in group))
    rates, allowed = groups.freedom(still, group, [grown])
    assert allowed is not None
    free = next(name for name in rates if allowed.get(name) is None)
    return differentiate(grown.substitute(allowed), free)


def growth_rate(angle: str, bodies: Iterable[BodyFacts]) -> Formula:
    """How fast an angle grows, by the rates of the one of some bodies that tells it."""
    found = next((rate for body in bodies for rate in angle_rates(angle, body)), None)
    if found is None:
        message = f"swings of what goes by `{key_of(angle).owner}` round a body that travels are not solved yet"
        raise NotYet(message, help="ask for the accelerations at a told place")
    return found


def angle_rates(angle: str, body: BodyFacts) -> Iterator[Formula]:
    """How fast an angle grows: a body's own by its spin, that of its place on a circle by v/ρ."""
    bend = body.motion.bend
    if key_of(angle).owner == body.name:
        yield body.motion.spin
    elif bend is not None and angle in bend.outward.formula().symbols():
        yield body.motion.velocity.along(bend.outward.turned(90)) / bend.radius


class Moments(Struct, frozen=True):
    """The equilibrium of all bodies, the same with any small motion, a moment of their swings; why a group has none."""

    rest: Instant
    still: Facts
    near: Instant
    troubles: Mapping[frozenset[str], NotYet]


class Placing(Struct, frozen=True):
    """Makes the moments of a swing."""

    configuration: Configuration
    registry: Registry
    modes: Mapping[str, str]
    made: dict[tuple[str, bool], Moments] = field(default_factory=dict)

    def swing(self, term: Term) -> Swing:
        """The swing that a question speaks of, one of the modes where it can go in several ways."""
        state, found = self.state_of(term)
        if (state, found) not in self.made:
            self.made[state, found] = self.found(state) if found else self.named(state)
        moments = self.made[state, found]
        group = self.group(moments, term.path.owner)
        damped = self.damped(group, moments.near)
        self.check_free(group, moments.near, damped=damped and term.modifier == "small swings")
        if group in moments.troubles:
            raise moments.troubles[group]
        body = self.leading(moments.near, group, term.path.owner)
        bodies = free_bodies(moving(moments.near))
        members = [body for body in bodies.bodies if body.name in group]
        terms = [term for body in members for term in (*groups.gain(body), *groups.supply(body))]
        swing = Swing(body, group, moments.rest, moments.still, moments.near, found, term.start or "")
        several = in_several_ways(bodies, group, terms)
        if not (several or damped or term.modifier.startswith(MODE) or term.path.quantity in DAMPINGS):
            return swing
        if not term.modifier or term.start:
            raise NotYet(f"`{body}` and what it is tied to {SEVERAL_WAYS}")
        from rotsolve.equations.normal_modes import mode_of

        return mode_of(swing, term)

    def damped(self, group: frozenset[str], near: Instant) -> bool:
        """Whether something acts on the bodies that swing by how fast they go."""
        acting = (item for item in self.configuration.acting(near.state) if self.touched(item, near) & group)
        return any(self.by_rate(item, near.state) for item in acting)

    def touched(self, item: Element, near: Instant) -> set[str]:
        """The bodies on which an element acts."""
        return {near.host(ref.owner) for ref in item.touches() if ref.owner in self.configuration.bodies}

    def by_rate(self, item: Element, state: str) -> bool:
        """Whether an element acts by how fast its body goes."""
        words = (word for value in varying_values(item) for _, _, word in paths_in(value))
        return any(word in RATES for word in words) or item.pace(self.configuration, state) in (RATE, MIXED)

    def check_free(self, group: frozenset[str], near: Instant, *, damped: bool) -> None:
        """But for what damps swings that are asked as such, nothing damps, rubs or drives the bodies that swing: it would be no harmonic
        motion about a place that stays."""
        for item in self.configuration.acting(near.state):
            if not self.touched(item, near) & group:
                continue
            values = tuple(varying_values(item))
            told = any(word in RATES for value in values for _, _, word in paths_in(value))  # a power is not
            if self.by_rate(item, near.state) and not (damped and told):
                help = f"leave out `{item.name}` for the swings without it"
                raise NotYet(f"`{item.name}` damps or drives the swings by how fast they go: not solved yet", help=help)
            if any(word in ("displacement", "rotation") for value in values for _, _, word in paths_in(value)):
                message = f"`{item.name}` goes by how far a body has gone since the first state: swings under it are not solved yet"
                raise NotYet(message, help="a `spring` or a `torsion` drives back as well, or a couple by the `angle`")
            if any(TIME in value.symbols() for value in values):
                raise NotYet(f"`{item.name}` changes in time while the bodies swing: not solved yet")
            if item.brakes():
                word = "friction_torque" if getattr(item, "friction_torque", None) is not None else "friction"
                help = "small swings stick: leave it out for those without it"
                raise NotYet(f"`{word}` of `{item.name}` stops the swings: not solved yet", help=help)

    def named(self, state: str) -> Moments:
        """The moments about an equilibrium that is a state of the scene."""
        return self.moments(Instant(self.configuration, self.registry, state, False, self.modes), {})

    def found(self, state: str) -> Moments:
        """The moments about an equilibrium that is worked out: the angles of hinged bodies here, the rest by the laws."""
        carried = self.carried(state)
        self.hold(self.moment(state, REST), ("velocity", "acceleration"), carried)
        self.hold(self.moment(state, REST), ("velocity",))
        rest = self.moment(state, REST)
        still = free_bodies(moving(rest))
        for key, quantity in self.registry.quantities.items():
            if quantity.kind in PLACES and quantity.when == rest.when:
                self.registry.quantities[key] = replace(quantity, letter=f"{quantity.letter}0")
        troubles: dict[frozenset[str], NotYet] = {}
        for group in groups_of(self.configuration, still, state):
            try:
                self.registry.known.update(balanced_places(rest, still, group, self.configuration.signs))
            except NotYet as trouble:
                troubles[group] = trouble
        return self.moments(self.moment(state, REST), troubles)

    def moments(self, rest: Instant, troubles: Mapping[frozenset[str], NotYet]) -> Moments:
        """All moments of the swings about an equilibrium, velocities left out: they are small of second order."""
        still = free_bodies(moving(rest))
        self.hold(self.moment(rest.state, NEAR), ("velocity",), self.going(rest.state))
        self.displace(rest, still, self.moment(rest.state, NEAR))
        return Moments(rest, still, self.moment(rest.state, NEAR), troubles)

    def moment(self, state: str, mark: str) -> Instant:
        """A moment of swings or of their equilibrium: contacts stick, since nothing moves far."""
        return Instant(self.configuration, self.registry, state, True, {}, mark=mark)

    def state_of(self, term: Term) -> tuple[str, bool]:
        """The state about which it swings, and whether its equilibrium has to be found: a state in balance is one."""
        states = self.configuration.timeline.states
        balanced = [state.name for state in states if state.balance or state.steady]
        if term.at is not None:
            if term.at not in balanced:
                raise NotYet(f"`{term.at}` is not said to be an equilibrium", help="add `balance: true` to the state")
            return term.at, False
        if len(balanced) == 1 and term.start is None:
            return balanced[0], False
        return term.start or states[0].name, True

    def group(self, moments: Moments, owner: str) -> frozenset[str]:
        """The bodies that swing together: those tied to the body named, else the only ones that a weight or spring drives back."""
        near = moments.near
        groups = groups_of(self.configuration, moments.still, near.state)
        self.refuse_round_sides(near.state)
        if owner:
            host = near.host(owner)
            return next(group for group in groups if host in group)
        sprung = {name for stored in moments.still.potentials for name in stored.bodies}
        driven = [group for group in groups if group & sprung or any(driven_back(name, near) for name in group)]
        if not driven:
            for trouble in moments.troubles.values():
                raise trouble
            raise NotYet("nothing is driven back to an equilibrium here: there are no swings")
        if len(driven) > 1:
            names = ", ".join(spoken(name) for group in driven for name in sorted(group))
            raise NotYet(f"several bodies swing each for itself: {names}", help="say `of` which body")
        return driven[0]

    def refuse_round_sides(self, state: str) -> None:
        """Nothing here displaces what lies on a round side of a body that moves too."""
        for item in self.configuration.connections(state):
            surface = item.surface(self.configuration, state) if item.carrier(self.configuration) else None
            if surface is not None and surface.curved and surface.bearer():
                message = f"swings of `{item.lying()}` on `{surface.name}`, a round side of a body that moves, are not solved yet"
                help = "a bob on a light rod that is hinged to the body swings as a particle in a hollow of that radius"
                raise NotYet(message, help=help)

    def leading(self, near: Instant, group: frozenset[str], owner: str) -> str:
        """The body whose coordinate tells the swing: the one named, else a hinged one, else one that travels, else the first."""
        if owner and near.held_still(near.host(owner)):
            raise NotYet(f"`{owner}` is held still, and does not swing")
        if owner:
            return near.host(owner)
        present = [body.name for body in self.configuration.present(near.state) if body.name in group]
        names = [name for name in present if not near.held_still(name)] or present
        turning = [name for name in names if angle_key(near, name) in self.registry.known]
        travelling = [name for name in names if near.motion(name).kind == "line"]
        return (turning or travelling or names)[0]

    def going(self, state: str) -> frozenset[str]:
        """The bodies whose speeds count: those that are tied to one on which something acts by how fast that goes."""
        acting = (item for item in self.configuration.acting(state) if self.by_rate(item, state))
        names = {ref.owner for item in acting for ref in item.touches() if ref.owner in self.configuration.bodies}
        hosts = (self.configuration.host(name, state) for name in names)
        return frozenset().union(*(self.configuration.component(host, state) for host in hosts))

    def carried(self, state: str) -> frozenset[str]:
        """The bodies that are tied to one that is given to move, with that."""
        present = [body.name for body in self.configuration.present(state)]
        drives = ((name, drive) for name in present for drive in self.configuration.drives(name, state))
        led = (name for name, drive in drives if not drive.holds_still)
        return frozenset().union(*(self.configuration.component(name, state) for name in led))

    def hold(self, instant: Instant, words: tuple[str, ...], without: frozenset[str] = frozenset()) -> None:
        """Put velocities, or velocities and accelerations, of all bodies but some to zero at a moment."""
        for body in self.configuration.present(instant.state):
            if body.name in without:
                continue
            for word in words:
                for rate in rates_of_body(word, instant, body.name):
                    self.put(rate, ZERO)

    def put(self, letter: Formula, value: Formula) -> None:
        if is_quantity(letter) and letter != value:
            self.registry.known[letter.name] = value

    def displace(self, rest: Instant, still: Facts, near: Instant) -> None:
        """Place the bodies near their equilibrium: angles by the angles turned or the ways gone, springs by what their ends move apart."""
        changes = displacements(rest, near)
        for body in self.configuration.present(near.state):
            angle = self.rest_angle(rest, body.name, near)
            circle = near.orbit(body.name)
            if circle is not None and circle.radius is not None:
                gone = signed(next(displacements_of_body(near, body.name)) / circle.radius, circle.way)
                self.put(near.place_on(circle), add(rest.place_on(circle), gone))
            if angle is not None:
                turned = signed(list(displacements_of_body(near, body.name))[-1], near.sense(body.name))
                self.put(near.ask("angle", body.name), add(angle, turned))
        for stored in still.potentials:
            if SymbolKey("elongation", stored.owner, "", rest.when).name in self.registry.quantities:
                stretched = add(stored.elongation, stored.rate.substitute(changes))
                self.put(near.ask("elongation", stored.owner), stretched)

    def rest_angle(self, rest: Instant, name: str, near: Instant) -> Formula | None:
        """The angle of a body at its equilibrium: what its facts speak of, else as it stands drawn; None where none matters."""
        key = angle_key(rest, name)
        if key in self.registry.quantities:
            return self.registry.known.get(key, Symbol(key))
        return rest.offset(name).formula() if near.weight_swings(name) else None


def driven_back(name: str, near: Instant) -> bool:
    """Whether the weight of a body can drive it back: of one that hangs from a hinge, or lies on a curved surface."""
    return near.weight_swings(name) or (near.configuration.heavy and near.orbit(name) is not None)


def angle_key(instant: Instant, name: str) -> str:
    return SymbolKey("angle", name, "", instant.when).name
