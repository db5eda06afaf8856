"""Compiling: the equations of motion of a scene on a tape, compiled from the facts and laws that the solver uses.

The laws are written for a moment at which all places and speeds are letters. The rules tell all speeds by a few free ones, and the
laws, linear in forces and accelerations, how these few change.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from contextlib import suppress
from fractions import Fraction
from functools import partial

from msgspec import Struct

from rotsolve.algebra.certified.ball import Precision
from rotsolve.algebra.certified.balls import with_values
from rotsolve.algebra.flints import arb, fmpq
from rotsolve.algebra.formula import PI, Formula, Number, Symbol, add
from rotsolve.algebra.formula import ZERO as NOTHING
from rotsolve.algebra.tape import BITS, ONE, ZERO, Exact, Unwritable
from rotsolve.core.facts import Facts, signed
from rotsolve.core.registry import Registry
from rotsolve.core.symbols import COURSE, GENERIC, TIME, SymbolKey, is_key, is_quantity, key_of
from rotsolve.equations.states import Fixed, prescribe, rates_of_body
from rotsolve.laws.table import FOLLOWED, SPEEDS, AtMoment, equations_for
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.freebody import free_bodies
from rotsolve.motion.instant import Instant
from rotsolve.paths.meaning import NotYet
from rotsolve.simulation.beginning import Beginning, beginning
from rotsolve.simulation.linear import Contradictory, Linear, Row
from rotsolve.simulation.series import rough_value
from rotsolve.simulation.system import (
    PlanarSystem,
    System,
    Variable,
    check_rules,
    named_in_text,
    path_name,
    refusal,
    told_by_others,
)
from rotsolve.simulation.tape import SeriesTape, vanishes

RIGHT_ANGLE = PI / 2
PLACES = (
    "angle",
    "rotation",
    "displacement",
    "position",
    "elongation",
    "length",
    "height",
    "velocity",
    "angular_velocity",
)


class Compiler(Struct, dict=True):
    """Writes the equations of motion of a configuration in one choice of modes of its contacts.

    `before` is the system that this one goes on from, whose angles keep their origins.
    """

    configuration: Configuration
    modes: Mapping[str, str]
    before: System | None = None

    def __post_init__(self) -> None:
        self.values = {
            given.name: given.value for given in self.configuration.problem.givens if given.value is not None
        }
        self.start: Beginning = beginning(self.configuration, self.modes)
        self.registry, self.tape = Registry(), SeriesTape()
        self.letters: dict[str, int] = {TIME: self.tape.letter(TIME)}
        self.first: dict[str, Exact] = {TIME: ZERO}  # letters of the state -> their first values
        self.origins: dict[str, int] = {}
        self.unnumbered = ""  # a letter without a number that some law speaks of
        self.linear = Linear(self.tape, self.letters, lambda place: rough_value(self.tape, place, self.first))

    def compiled(self) -> PlanarSystem:
        """The system of the scene from its first state."""
        with Precision(BITS):
            bodies = [body.name for body in self.configuration.present(self.start.instant.state)]
            for name in self.values:
                with suppress(NotYet):  # of givens without a number
                    self.letters[name] = self.tape.number(self._exact(Symbol(name)))
            self._set_angles(bodies)
            fixed = Fixed(self.configuration, self.registry, self.modes)
            for by_motion in (False, True):
                prescribe(self._moment(), fixed, by_motion=by_motion)
            moment = self._moment()
            facts = free_bodies(moment)
            refuse_changing(facts)
            self._inertias_of_drives(facts)
            places = list(self._places(bodies, moment, facts))
            free = self._speeds(bodies, moment, facts)
            self._forces(moment, facts)
            pairs = (pair for name in bodies for pair in self._pairs(moment, name))
            rising = {speed.name: rate for speed, rate in pairs if isinstance(speed, Symbol)}
            lines = [*places, *((path_name(name), name, rising[name]) for name in free)]
            variables = tuple(self._variables(lines))
            moving = {item.letter for item in variables}
            variables = self._followed(variables)
            outputs = self._outputs([line for line in lines if line[1] in moving], variables)
            system = PlanarSystem(self.tape, variables, outputs, {**self.letters, **self.inertias}, facts, moment)
            check_rules(system)
            return system

    def _variables(self, lines: list[tuple[str, str, Formula]]) -> Iterator[Variable]:
        """The numbers of the state; those whose rates no law tells are left out, if nothing else depends on them."""
        idle: dict[str, Formula] = {}
        while True:
            told = [line for line in lines if line[1] not in idle]
            found = {letter: rate for _, letter, rate in told if self._untold(rate, idle)}
            if not found:
                break
            idle.update(found)
        moving = [
            Variable(
                name, letter, self.first[letter], self.tape.formula(rate, self.letters), self.origins.get(letter, 0)
            )
            for name, letter, rate in told
        ]
        ever = self.tape.letters_under(*(item.rate for item in moving))
        for letter, rate in idle.items():
            if letter in ever or not moving:
                if self.unnumbered:
                    raise refusal(Unwritable("", self.unnumbered), self.registry)
                untold = named_in_text(next(iter(rate.symbols()), letter), self.registry)
                raise NotYet(f"the laws do not tell the {untold}")
        yield from moving

    def _followed(self, variables: tuple[Variable, ...]) -> tuple[Variable, ...]:
        """The numbers that have to be followed; places that others tell, and nothing else rests on, become values of these.

        A system that goes on from another one starts from numbers that are known to each run alone: it follows all of them.
        """
        if self.before is not None:
            return variables
        own = {item.letter for item in variables}
        resting = [place for name, place in (*self.letters.items(), *self.inertias.items()) if name not in own]
        used = self.tape.letters_under(*resting, *(item.rate for item in variables))
        told = told_by_others(self.tape, variables, self.letters, used)
        self.letters.update(told)
        return tuple(item for item in variables if item.letter not in told)

    def _untold(self, rate: Formula, idle: Collection[str]) -> bool:
        """Whether a rate is made of what no law tells."""
        names = rate.symbols()
        if any(name not in self.letters for name in names):
            return True
        return bool(self.tape.letters_under(*(self.letters[name] for name in names)) & set(idle))

    def _moment(self) -> Instant:
        """The moment at which all places and speeds are letters."""
        state = self.start.instant.state
        return Instant(self.configuration, self.registry, state, True, self.modes, mark=COURSE)

    def _exact(self, value: Formula) -> Exact:
        """The number that a formula of givens is; refuses letters without a number."""
        formula = with_values(value, self.values)
        for name in sorted(formula.symbols()):
            raise NotYet(f"`{name}` has no number", help=f"give it one, or say --set {name}=…")
        try:
            number = self.tape.constant(self.tape.formula(formula, {}))
        except Unwritable as error:
            raise refusal(error, self.registry) from None
        return ZERO if vanishes(number) else number

    def _enter(self, letter: str, start: Formula) -> None:
        """A letter of the state, with its first value."""
        self.letters[letter] = self.tape.letter(letter)
        self.first[letter] = self._exact(start)

    def _at_first(self, told: Callable[[], Formula]) -> Formula:
        """The value of a place at first; nothing where this system goes on from another, which knows it."""
        return told() if self.before is None else NOTHING

    def _set_angles(self, bodies: list[str]) -> None:
        """Every angle as a number of right angles and a letter for what it is beyond."""
        moment = self._moment()
        for name in bodies:
            driven_ = any(drive.word == "angle" for drive in self.configuration.drives(name, moment.state))
            if not driven_ and moment.angle(name) is not None:
                self._set_angle(name, self._at_first(partial(self.start.angle, name)))
            orbit = moment.orbit(name)
            if orbit is not None and orbit.radius is not None:
                self._set_angle(orbit.owner, self._at_first(partial(self.start.place, "angle", orbit.owner)))

    def _set_angle(self, owner: str, value: Formula) -> None:
        letter = self._moment().ask("angle", owner)
        if isinstance(letter, Symbol):
            turns = self._turns(letter.name, value)
            self.origins[letter.name] = turns
            self.registry.known[letter.name] = add(letter, Number(Fraction(turns)) * RIGHT_ANGLE)
            self._enter(letter.name, value - Number(Fraction(turns)) * RIGHT_ANGLE)

    def _turns(self, letter: str, value: Formula) -> int:
        """The number of right angles from which an angle is counted."""
        if self.before is not None:
            return next((item.origin for item in self.before.variables if item.letter == letter), 0)
        return round(float(arb(self._exact(value / RIGHT_ANGLE)).mid()))

    def _places(self, bodies: list[str], moment: Instant, facts: Facts) -> Iterator[tuple[str, str, Formula]]:
        """The coordinates: their names, letters and rates."""
        for name in bodies:
            motion, orbit = moment.motion(name), moment.orbit(name)
            letter = SymbolKey("angle", name, "", moment.when).name
            if letter in self.origins:
                yield f"{name}.angle", letter, motion.spin
            if orbit is not None and motion.bend is not None:
                rate = motion.velocity.along(motion.bend.outward.turned(90)) / motion.bend.radius
                yield f"{orbit.owner}.angle", SymbolKey("angle", orbit.owner, "", moment.when).name, rate
            if motion.kind != "axis":
                yield from self._ways(name, moment)
            turned = SymbolKey("rotation", name, "", GENERIC + self.configuration.timeline.states[0].name).name
            if turned in self.registry.quantities:
                self._enter(turned, NOTHING)
                yield f"{name}.rotation", turned, signed(motion.spin, motion.sense)
        for stored in facts.potentials:
            letter = next(iter(stored.elongation.symbols()), "")
            if letter in self.letters or stored.elongation != Symbol(letter):
                continue
            if letter in self.registry.quantities:
                word = self.registry.quantities[letter].kind
                self._enter(letter, self._at_first(partial(self.start.place, word, stored.owner)))
                yield f"{stored.owner}.{word}", letter, stored.rate

    def _ways(self, name: str, moment: Instant) -> Iterator[tuple[str, str, Formula]]:
        """How far a body has travelled since the first state, along its line or to the right and up."""
        since = GENERIC + self.configuration.timeline.states[0].name
        if moment.motion(name).kind == "line":
            letter = SymbolKey("displacement", name, "", since).name
            self._enter(letter, NOTHING)
            yield f"{name}.position", letter, next(rates_of_body("velocity", moment, name))
            return
        for axis in "xy":
            letter = SymbolKey("displacement", name, axis, since).name
            self._enter(letter, NOTHING)
            yield f"{name}.position.{axis}", letter, moment.component("velocity", name, axis)

    def _pairs(self, moment: Instant, name: str) -> Iterator[tuple[Formula, Formula]]:
        """The speeds of a body with their accelerations."""
        return zip(rates_of_body("velocity", moment, name), rates_of_body("acceleration", moment, name), strict=True)

    def _speeds(self, bodies: list[str], moment: Instant, facts: Facts) -> list[str]:
        """Tells all speeds by a few that are free, enters these with their first values, and returns them."""
        letters = [speed for name in bodies for speed, _ in self._pairs(moment, name)]
        names = {letter.name for letter in letters if is_quantity(letter)}
        equations = list(equations_for(SPEEDS, AtMoment(facts, "", "")))
        rows = self._rows((item.left - item.right for item in equations), names)
        free: list[str] = []

        def left_free(name: str) -> int:
            free.append(name)
            return self.tape.letter(name)

        for name in names - {name for row in rows for name in row}:
            self.letters[name] = left_free(name)
        turning_ = {name: 1 for name in names if key_of(name).component == ""}
        told = self.linear.in_terms_of_free(rows, turning_, left_free)
        self.letters.update(told)
        first = self._first_speeds(bodies, moment) if self.before is None else {}
        self.first.update({name: first.get(name, ZERO) for name in free})
        return sorted(free)

    def _first_speeds(self, bodies: list[str], moment: Instant) -> dict[str, Exact]:
        """The first values of all speeds, by the letters of the moment."""
        start = self.start.instant
        letters: dict[str, Formula] = {}
        for name in bodies:
            both = zip(rates_of_body("velocity", moment, name), rates_of_body("velocity", start, name), strict=True)
            letters.update({now.name: then for now, then in both if isinstance(now, Symbol)})
        unknown = {name for then in letters.values() for name in then.symbols() if is_key(name)}
        rows = self._rows((item.left - item.right for item in self.start.speeds()), unknown)
        zero = self.tape.number(ZERO)
        found = self.linear.in_terms_of_free(rows, {}, lambda name: zero)
        values = {**self.letters, **dict.fromkeys(unknown, zero), **found}
        return {now: self.tape.constant(self.tape.formula(then, values)) for now, then in letters.items()}

    def _rows(self, formulas: Iterable[Formula], unknown: Collection[str]) -> list[Row]:
        """Formulas that are zero as rows; those that speak of something else than the unknown letters are left out."""
        rows = []
        for formula in formulas:
            names = formula.symbols()
            if names & set(unknown) and all(name in unknown or name in self.letters for name in names):
                rows.append(self.linear.row(formula, unknown))
        return rows

    def _inertias_of_drives(self, facts: Facts) -> None:
        """Enters the moments of inertia by which a given momentum or energy tells a rate."""
        spoken_of = {name for given in facts.given for name in given.drive.function.symbols() if is_key(name)}
        for body in facts.bodies if spoken_of else ():
            if body.inertia is not None and body.inertia.letter.symbols() & spoken_of:
                (name,) = body.inertia.letter.symbols()
                self.letters[name] = self.tape.formula(body.inertia.formula, self.letters)

    def _forces(self, moment: Instant, facts: Facts) -> None:
        """Enters all forces and accelerations that the laws tell; a law that speaks of a letter without a number tells nothing."""
        inertias = {
            name: body.inertia.formula
            for body in facts.bodies
            if body.inertia is not None
            for name in body.inertia.letter.symbols()
            if name not in self.letters
        }
        told = {name: formula for name, formula in inertias.items() if formula.symbols() <= set(self.letters)}
        self.inertias = {name: self.tape.formula(formula, self.letters) for name, formula in told.items()}
        laws = []
        for law in equations_for(FOLLOWED, AtMoment(facts, "", "")):
            formula = (law.left - law.right).substitute(inertias)
            open_ = formula.symbols() - set(self.letters)
            for name in sorted(open_):  # a place that the laws speak of is one that is followed
                if name in self.registry.quantities and self.registry.quantities[name].kind in PLACES:
                    raise refusal(Unwritable("", name), self.registry)
            missing = sorted(name for name in open_ if not is_key(name))
            self.unnumbered = self.unnumbered or next(iter(missing), "")
            if not missing and open_:
                laws.append((law, formula, open_))
        unknown = {name for _, _, names in laws for name in names}
        # Accelerations after forces, those of the free speeds last: what is left then is smallest.
        late: dict[str, int] = {}
        for speed, rate in (pair for body in facts.bodies for pair in self._pairs(moment, body.name)):
            own = 2 if speed.symbols() & set(self.first) else 1
            late.update({name: max(own, late.get(name, 0)) for name in rate.symbols() if name in unknown})
        try:
            rows = [self.linear.row(formula, unknown) for _, formula, _ in laws]
            self.letters.update(self.linear.solve(rows, late))
        except Contradictory as error:
            raise NotYet(f"the data contradict each other: “{laws[error.equation][0].label}” can not hold") from None

    def _outputs(self, lines: list[tuple[str, str, Formula]], variables: tuple[Variable, ...]) -> dict[str, int]:
        """All that can be told: coordinates with their origins, speeds, accelerations, forces."""
        quarter, found = self.tape.number(self._exact(RIGHT_ANGLE)), {}
        for name, letter, _ in lines:
            found[name] = self.tape.sum([(self.letters[letter], ONE), (quarter, fmpq(self.origins.get(letter, 0)))])
        for letter, place in self.letters.items():
            if letter in self.registry.quantities:
                found.setdefault(path_name(letter), place)
        followed = {item.letter for item in variables} | {TIME}
        return {name: place for name, place in found.items() if self.tape.letters_under(place) <= followed}


def refuse_changing(facts: Facts) -> None:
    """Bodies whose own data change, and what lays itself out, have laws of energy alone."""
    for body in facts.bodies:
        if body.changing:
            raise NotYet(f"the mass or the moment of inertia of `{body.name}` changes on the way: not simulated yet")
    for rule in facts.rules:
        if rule.acceleration is None:
            raise NotYet(f"`{rule.owner}` changes its sizes on the way: not simulated yet")


def compiled(configuration: Configuration, modes: Mapping[str, str], before: System | None = None) -> PlanarSystem:
    """The equations of motion of a configuration, from its first state, or as they go on from a system before."""
    compiler = Compiler(configuration, modes, before)
    try:
        return compiler.compiled()
    except Unwritable as error:
        raise refusal(error, compiler.registry) from None
