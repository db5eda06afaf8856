"""Normal modes: bodies that swing in several ways about an equilibrium, and one of their modes as a swing that a question speaks of."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property

from msgspec import Struct

from rotsolve.algebra.calculus.derivative import differentiate
from rotsolve.algebra.exact.normal import is_zero, simplify
from rotsolve.algebra.formula import ZERO, Formula, Symbol
from rotsolve.algebra.units.dimension import Dimension
from rotsolve.core.derivation import Words
from rotsolve.core.equation import Equation
from rotsolve.core.quantity import DAMPINGS, FREQUENCIES, QUANTITIES
from rotsolve.core.registry import SceneQuantity
from rotsolve.core.symbols import SymbolKey, key_of
from rotsolve.core.writing import spoken
from rotsolve.equations.carriers import ONLY, carried_accelerations
from rotsolve.equations.states import rates_of_body
from rotsolve.equations.swing import HARMONIC, Swing, displacements_of_body, moving
from rotsolve.language.problem import MODE, Path, Term
from rotsolve.laws.modes import FreeWays, Matrix, generalized_forces, independent_ways, inertias
from rotsolve.motion.freebody import free_bodies
from rotsolve.paths.meaning import NotYet

SHAPE = "amplitude_ratio"
UNTOLD = "what ties these bodies is not told in a way in which their normal modes are solved"


def mode_of(swing: Swing, term: Term) -> Mode:
    """The mode of a group that a question speaks of, with the two displacements that it compares."""
    number = int(term.modifier.removeprefix(MODE)) if term.modifier.startswith(MODE) else 0
    paths = [term.path, term.other.path] if term.other is not None else []
    compared = tuple((path.owner, *way_in_words(path)) for path in paths)
    return Mode(swing.body, swing.group, swing.rest, swing.still, swing.near, swing.found, "", number, compared)


def way_in_words(path: Path) -> tuple[str, str]:
    """A displacement or rotation that is compared, and its component."""
    word, _, component = str(path.component).partition(" ")
    return word, component


class Rows(Struct, frozen=True):
    """M q̈ + K q = 0 of a group: its coordinates and their accelerations, M and K, what pushes along each coordinate at the equilibrium,
    and by how much all displacements grow with the coordinates."""

    coordinates: tuple[Symbol, ...]
    accelerations: tuple[Symbol, ...]
    inertia: Matrix
    stiffness: Matrix
    pushes: tuple[Formula, ...]
    displaced: Mapping[str, Formula]
    damping: Matrix = ()
    led: tuple[str, ...] = ()  # bodies whose motion is given
    along: tuple[Formula, ...] = ()  # the same at any displacement


class Spectrum(Struct, frozen=True):
    """The rows of a group, det(K − ω² M) by the letter of ω², and its roots that are not 0, the smallest first."""

    rows: Rows
    matrix: Matrix
    condition: Formula
    squares: tuple[Formula, ...]
    free: int = 0  # ways in which nothing drives it back
    held: Words = ()  # where the balance of the springs tells something


class Mode(Swing, frozen=True, dict=True):
    """One mode of a group that can swing in several ways: the `number` of it, slowest first; 0 of the only one.

    `compared` are two displacements whose ratio in this mode is asked, as owner and words of each.
    """

    number: int = 0
    compared: tuple[tuple[str, str, str], ...] = ()

    @property
    def harmonic(self) -> str:
        """Key of the section of all modes of the group."""
        return f"{self.near.when} {'+'.join(sorted(self.group))}" + HARMONIC

    @property
    def section(self) -> str:
        """No section of its own: the rows stand with the modes."""
        return self.harmonic

    @cached_property
    def letters_of_group(self) -> list[tuple[str, Symbol, Symbol, str]]:
        """Rate in any small motion, displacement, acceleration and owner of all ways of all bodies, the most wanted coordinates first."""
        any_motion, found = moving(self.near), list[tuple[str, Symbol, Symbol, str]]()
        for name in (body.name for body in self.still.bodies if body.name in self.group):
            rates = rates_of_body("velocity", any_motion, name)
            places = displacements_of_body(self.near, name)
            changes = rates_of_body("acceleration", self.near, name)
            for rate, place, change in zip(rates, places, changes, strict=True):
                if isinstance(rate, Symbol) and isinstance(place, Symbol) and isinstance(change, Symbol):
                    found.append((rate.name, place, change, name))
        return sorted(found, key=lambda item: self._rank(item[3], item[1]))

    def speeds(self) -> dict[str, Symbol]:
        """The letters of real rates by those of any small motion, where something acts by them."""
        found = dict[str, Symbol]()
        for body in self.still.bodies:
            if body.name in self.group:
                rates = (rates_of_body("velocity", at, body.name) for at in (moving(self.near), self.near))
                pairs = ((any_, real) for any_, real in zip(*rates, strict=True) if any_ != real)
                found |= {
                    any_.name: real for any_, real in pairs if isinstance(any_, Symbol) and isinstance(real, Symbol)
                }
        return found

    def _rank(self, name: str, place: Symbol) -> int:
        """Turns about an axis and ways along a line before turns of what moves freely, and those before its ways."""
        kind, turns = self.near.motion(name).kind, key_of(place.name).kind == "rotation"
        return 0 if kind == "axis" or (kind == "line" and not turns) else 1 if turns else 2

    def rows(self, tidy: Callable[[Formula], Formula], vanishes: Callable[[Formula], bool]) -> Rows:
        """M and K: how m a grows with the accelerations, and how the forces grow as all is displaced."""
        facts = self.within(free_bodies(moving(self.near)))
        if any(body.changing or body.sliding or body.sweep is not None for body in facts.bodies):
            raise NotYet(UNTOLD)
        names = [name for name, *_ in self.letters_of_group]
        at_rest = {place.name: ZERO for _, place, _, _ in self.letters_of_group}
        carried = carried_accelerations(self.near, facts, self.group)
        found = independent_ways(facts, self.group, names, lambda slope: vanishes(slope.substitute(at_rest)), carried)
        if found is None or not found.rates:
            raise NotYet(UNTOLD)
        resting = FreeWays(
            found.rates, {name: simplify(one.substitute(at_rest)) for name, one in found.tied.items()}, carried
        )
        places = {name: place for name, place, _, _ in self.letters_of_group}
        coordinates = tuple(places[name] for name in found.rates)
        grown: dict[str, Formula] = {name: places[name] for name in found.rates} | resting.virtual
        displaced = {places[name].name: grown[name].substitute({n: places[n] for n in found.rates}) for name in names}
        pushes = generalized_forces(facts.bodies, found)
        led = [places[name].name for name in carried.given]
        if any(not is_zero(differentiate(push, name)) for push in pushes for name in led):
            raise NotYet(f"what pushes the bodies that are carried along depends on how far they have gone: {ONLY}")
        pushes = [push.substitute(displaced).substitute(self.real_rates(resting)) for push in pushes]
        at_rest |= {speed.name: ZERO for speed in self.speeds().values()}

        def there(value: Formula) -> Formula:
            return tidy(value.substitute(at_rest))

        return Rows(
            coordinates,
            tuple(Symbol(carried.letters[name]) for name in found.rates),
            tuple(tuple(map(there, row)) for row in inertias(facts.bodies, resting)),
            tuple(tuple(there(-differentiate(push, place.name)) for place in coordinates) for push in pushes),
            tuple(map(there, pushes)),
            displaced,
            self.damping(pushes, found.rates, there),
            tuple(motion.drive.body for motion in facts.given if motion.drive.body in self.group),
            tuple(map(tidy, pushes)),
        )

    def real_rates(self, ways: FreeWays) -> dict[str, Formula]:
        """What acts by rates in terms of those of the coordinates, for the bodies of which something acts by them."""
        speeds = self.speeds()
        return {
            speeds[name].name: told.substitute({one: speeds[one] for one in ways.rates})
            for name, told in ways.virtual.items()
            if name in speeds
        }

    def damping(
        self, pushes: Sequence[Formula], rates: Sequence[str], there: Callable[[Formula], Formula]
    ) -> tuple[tuple[Formula, ...], ...]:
        """How the forces grow against the rates; NotYet where they are not in proportion."""
        going = [self.speeds()[name].name for name in rates if name in self.speeds()]
        if any(not_proportional(push, speed) for push in pushes for speed in going):
            names = ", ".join(f"`{name}`" for name in sorted(self.group))
            raise NotYet(f"what damps {names} is not proportional to how fast they go")
        return tuple(tuple(there(-differentiate(push, speed)) for speed in going) for push in pushes)

    def equations(self) -> tuple[Equation, ...]:
        """None: the rows are written once it is known where all stands."""
        return ()

    @property
    def unsettled(self) -> tuple[str, ...]:
        """None by laws of their own: where springs are in balance the rows tell."""
        return ()

    @property
    def coordinates(self) -> tuple[Symbol, ...]:
        """The displacements of all bodies."""
        return tuple(place for _, place, _, _ in self.letters_of_group)

    @cached_property
    def letters(self) -> dict[str, Formula]:
        """Period, frequency and angular frequency of the mode, and the ratio of two displacements."""
        found = {word: self._letter(word) for word in (*FREQUENCIES, *DAMPINGS, *([SHAPE] if self.compared else []))}
        return found

    def dimension(self, word: str) -> Dimension:
        """The dimension of what is asked of it: of a ratio that of the two displacements."""
        letter = self.letters[word]
        assert isinstance(letter, Symbol)
        return self.near.registry.quantities[letter.name].dimension

    def _letter(self, word: str) -> Formula:
        kind, whole = QUANTITIES[word], "+".join(sorted(self.group))
        letter, dimension = kind.letter.removesuffix("0"), kind.dimension
        if word == "angular_frequency" and self.speeds():
            letter = "omega_d"
        if word == SHAPE:
            first, second = (self.near.registry.quantities[self.way_of(*one).name] for one in self.compared)
            dimension = first.dimension / second.dimension
            whole = " ".join((whole, *(part for one in self.compared for part in one)))
        quantity = SceneQuantity(word, whole, self.when_asked, str(self.number or ""), letter, dimension)
        return self.near.registry.ask(quantity)

    def letter_of_damping(self, letter: str) -> Formula:
        """γ, or ω₀ without damping."""
        kind = QUANTITIES["angular_frequency"]
        whole = "+".join((*sorted(self.group), letter))
        return self.near.registry.ask(SceneQuantity(kind.word, whole, self.when_asked, "", letter, kind.dimension))

    def speed_letters(self, rows: Rows) -> tuple[Symbol, ...]:
        """The letters of the real rates of the coordinates."""
        real = self.speeds()
        rates = {place: rate for rate, place, _, _ in self.letters_of_group}
        return tuple(real[rates[place]] for place in rows.coordinates)

    @property
    def when_asked(self) -> str:
        return self.rest.when if self.found else self.near.state

    @property
    def common(self) -> Formula:
        """ω of whichever mode."""
        kind = QUANTITIES["angular_frequency"]
        whole = "+".join(sorted(self.group))
        quantity = SceneQuantity(kind.word, whole, self.when_asked, "", "omega", kind.dimension)
        return self.near.registry.ask(quantity)

    @property
    def omega(self) -> Symbol:
        """ω of the mode."""
        found = self.letters["angular_frequency"]
        assert isinstance(found, Symbol)
        return found

    def way_of(self, owner: str, word: str, component: str) -> Symbol:
        """The displacement of a body that is compared."""
        host = self.near.host(owner)
        for _, place, _, name in self.letters_of_group:
            key = key_of(place.name)
            if name == host and key.kind == word and key.component == component:
                return place
        asked = f"{owner}.{word}{'.' + component if component else ''}"
        raise NotYet(
            f"`{asked}` is no way in which `{host}` swings here", help="compare a `rotation` or `displacement`"
        )

    def angles_found(self) -> Iterator[tuple[str, Formula]]:
        """The angles of bodies in an equilibrium that is worked out."""
        for body in self.still.bodies:
            angle = self.rest.registry.known.get(SymbolKey("angle", body.name, "", self.rest.when).name)
            if self.found and body.name in self.group and angle is not None:
                yield body.name, angle

    def title(self, key: str) -> str:
        """Heading of the section of the modes."""
        place = "the equilibrium" if self.found else spoken(self.rest.state)
        return f"Small swings about {place}" if key == self.harmonic else ""


def not_proportional(push: Formula, speed: str) -> bool:
    """Whether a force is not proportional to a speed."""
    return speed in simplify(differentiate(push, speed)).symbols()
