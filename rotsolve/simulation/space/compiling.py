"""Compiling in space: the equations of motion of a scene with `up: z` on a tape, from the laws that `rotsolve solve` writes there.

The laws are written for a moment at which all places and rates are letters (`course`); they are linear in accelerations and forces.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from contextlib import suppress

from msgspec import Struct

from rotsolve.algebra.certified.ball import Precision
from rotsolve.algebra.certified.balls import with_values
from rotsolve.algebra.formula import ZERO as NOTHING
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.tape import BITS, ZERO, Exact, Unwritable
from rotsolve.core.drive import TRAVELLING
from rotsolve.core.registry import Registry
from rotsolve.core.symbols import ACCELERATIONS, SECOND, TIME, is_key, key_of, paths_in
from rotsolve.language.noted import read_all
from rotsolve.motion.configuration import Configuration
from rotsolve.paths.meaning import NotYet, path_text
from rotsolve.scene.idle import idle_keys, key_faults, look_at_bodies
from rotsolve.simulation.linear import Contradictory, Linear
from rotsolve.simulation.series import rough_value
from rotsolve.simulation.space.coordinates import OPEN, Coordinate, Coordinates
from rotsolve.simulation.space.course import CourseMoment
from rotsolve.simulation.space.outputs import Outputs
from rotsolve.simulation.system import System, Variable, named_in_text, refusal
from rotsolve.simulation.tape import SeriesTape, vanishes
from rotsolve.space.laws import SpaceLaws
from rotsolve.space.pushes import Pushes
from rotsolve.space.scene import SpaceEquations


class SpaceSystem(System, frozen=True):
    """A scene in space as it moves, with what the laws say of any moment of it."""

    registry: Registry
    moment: CourseMoment
    laws: SpaceLaws


class SpaceCompiler(Struct, dict=True):
    """Writes the equations of motion of a configuration in space; `still` are letters of its state that never change."""

    configuration: Configuration
    still: frozenset[str] = frozenset()

    def __post_init__(self) -> None:
        problem, first = self.configuration.problem, self.configuration.timeline.states[0].name
        self.scene = SpaceEquations(self.configuration)
        self.registry = self.scene.registry
        self.beginning = self.scene.dynamics[first]
        self.values = {given.name: given.value for given in problem.givens if given.value is not None}
        self.moment = CourseMoment(self.beginning.moment, self.configuration)
        pushes = Pushes(self.moment, problem.gravity, problem.actions)
        self.laws = SpaceLaws(self.moment, pushes, self.scene.tensors)
        self.unnumbered = ""  # a letter without a number of which some law speaks
        self.tape = SeriesTape()
        self.letters: dict[str, int] = {TIME: self.tape.letter(TIME)}
        self.first: dict[str, Exact] = {TIME: ZERO}
        self.linear = Linear(self.tape, self.letters, lambda place: rough_value(self.tape, place, self.first))

    def compiled(self) -> SpaceSystem:
        """The system of the scene from its first state."""
        with Precision(BITS):
            for name in self.values:
                with suppress(NotYet):  # of givens without a number
                    self.letters[name] = self.tape.number(self.worth(Symbol(name)))
            coordinates = Coordinates(self.moment, self.beginning.moment, self.worth)
            numbers = list(coordinates.all())
            for item in numbers:
                stays = item.letter in self.still
                self.letters[item.letter] = self.tape.number(item.start) if stays else self.tape.letter(item.letter)
                self.first[item.letter] = item.start
            for letter, value in coordinates.rotations():
                self.letters[letter] = self.tape.formula(value, self.letters)
            self.letters.update(self._solved(self.laws, {}))
            variables = tuple(map(self._variable, self._followed(numbers)))
            self._agree_at_first()
            outputs = self._outputs()
            refuse_unread(self.scene)
        return SpaceSystem(self.tape, variables, outputs, self.letters, self.registry, self.moment, self.laws)

    def worth(self, value: Formula) -> Exact:
        """The number that a formula of givens is; refuses letters without a number."""
        formula = with_values(value, self.values)
        for name in sorted(formula.symbols()):
            raise NotYet(f"`{name}` has no number", help=f"give it one, or say --set {name}=…")
        number = self.tape.constant(self.tape.formula(formula, {}))
        return ZERO if vanishes(number) else number

    def _enter_inertias(self) -> None:
        """The entries of tensors that have letters, as far as the scene tells them; each after those by which it is told."""
        steps = {step.left.name: step.right for step in self.scene.tensors.steps if isinstance(step.left, Symbol)}
        while told := [name for name in steps if steps[name].symbols() <= self.letters.keys()]:
            for name in told:
                self.letters[name] = self.tape.formula(steps.pop(name), self.letters)

    def _refuse_untold(self, names: Collection[str]) -> None:
        """Refuse what the laws would have to tell: by a letter without a number, or by a moment of inertia that is not told."""
        name, key = self.unnumbered, key_of(self.unnumbered)
        if not name:
            raise NotYet(f"the laws do not tell the {named_in_text(min(names), self.registry)}")
        if key.kind != "inertia":
            raise refusal(Unwritable("", name), self.registry)
        help = f"give `{key.owner}` its `inertia: {{principal: [I1, I2, I3]}}`"
        raise NotYet(f"the moment of inertia of `{key.owner}` across its axis is not told", help=help)

    def _solved(self, laws: SpaceLaws, idle: Mapping[str, Formula]) -> dict[str, int]:
        """All forces and accelerations that the laws tell of a moment; what is `idle` there is put in."""
        equations = list(laws.equations())
        for refused in laws.unwritten.values():
            raise refused
        self._enter_inertias()
        written = [(law, (law.left - law.right).substitute(idle)) for law in equations]
        for _, formula in written:
            self._enter_paths(formula)
        told = [(law, formula) for law, formula in written if self._numbered(formula)]
        unknown = {name for _, formula in told for name in formula.symbols()} - self.letters.keys()
        try:
            rows = [self.linear.row(formula, unknown) for _, formula in told]
            late = {name: 1 for name in unknown if is_acceleration(name)}
            return self.linear.solve(rows, late)
        except Contradictory as error:
            label = told[error.equation][0].label
            raise NotYet(f"the data contradict each other: “{label}” can not hold") from None

    def _enter_paths(self, formula: Formula) -> None:
        """What a force or couple varies with: the angle and the rate of a body about its hinge."""
        for letter, owner, quantity in paths_in(formula):
            joint = self.moment.held.main(owner) if owner in self.moment.held.bodies else None
            told: dict[str, Formula] = {}
            if joint is not None and joint.turning:
                word, rate, _ = self.moment.about_hinge(owner, joint)
                told = {"angle": self.moment.hinge_angle(owner, joint), word: rate}
            if quantity not in told:
                raise NotYet(f"what varies with `{owner}.{quantity}` is not followed in space yet")
            self.letters[letter] = self.tape.formula(told[quantity], self.letters)

    def _numbered(self, formula: Formula) -> bool:
        """Whether a law speaks of nothing that is constant and has no number: such a law tells nothing."""
        names = sorted(formula.symbols() - self.letters.keys())
        lacking = next((name for name in names if key_of(name).kind == "inertia" or not is_key(name)), "")
        self.unnumbered = self.unnumbered or lacking
        return not lacking

    def _followed(self, numbers: Sequence[Coordinate]) -> list[Coordinate]:
        """The numbers that change; but for ways that no law tells for want of a mass, and on which nothing else rests."""
        idle = {item.letter for item in numbers if not item.rate.symbols() <= self.letters.keys()}
        idle |= {item.letter for item in numbers if item.rate.symbols() & idle}
        kept = [item for item in numbers if item.letter not in idle | self.still]
        rates = [self.tape.formula(item.rate, self.letters) for item in kept]
        ways = {letter for letter in idle if key_of(letter).kind in ("velocity", "displacement")}
        if not self.unnumbered or idle - ways or idle & self.tape.letters_under(*rates) or not kept:
            return [item for item in numbers if item.letter not in self.still]
        for letter in idle:
            del self.letters[letter]
        return kept

    def _variable(self, item: Coordinate) -> Variable:
        """A number of the state with its rate on the tape; refuses one that no law tells."""
        untold = item.rate.symbols() - self.letters.keys()
        if untold:
            self._refuse_untold(untold)
        return Variable(item.name, item.letter, item.start, self.tape.formula(item.rate, self.letters), 0, item.vector)

    def _agree_at_first(self) -> None:
        """Refuse a first state that is said to be steady, or to have an acceleration, where the laws do not allow that.

        So are lines of it that have no part in the motion.
        """
        moment = self.beginning.moment
        lines = moment.state.conditions
        speeding = any(line.path is not None and line.path.quantity in ACCELERATIONS for line in lines)
        if moment.state.steady or speeding:
            open_rates = self._open_rates()
            if moment.state.steady and open_rates:
                told = named_in_text(open_rates[0], self.registry)
                raise NotYet(
                    f"the laws have to tell the {told} of the steady state `{moment.when}`", help="tell it there"
                )
            self._solved(self.beginning, dict.fromkeys(open_rates, NOTHING))
        for number, line in enumerate(lines):
            if number not in moment.used and line.path is not None:
                message = f"what the first state says of `{path_text(line.path)}` is not followed in time"
                raise NotYet(message, line.span, "leave it out")

    def _outputs(self) -> dict[str, int]:
        """The places on the tape of all that can be told; a body that stays where it is has neither way nor velocity."""
        told = Outputs(self.moment, self.laws, self.beginning.moment, self.configuration.problem).all()
        places = {
            name: self.tape.formula(value, self.letters)
            for name, value in told
            if value.symbols() <= self.letters.keys()
        }
        numbers = {name: self.tape.constant(place) for name, place in places.items()}
        moving = {vector_in_name(name) for name, number in numbers.items() if number is None or not vanishes(number)}
        return {
            name: place
            for name, place in places.items()
            if vector_in_name(name) in moving or vector_in_name(name).rpartition(".")[2] not in TRAVELLING
        }

    def _open_rates(self) -> list[str]:
        """The letters of rates of which the laws speak and that the first state leaves open."""
        names = {name for law in self.beginning.equations() for name in law.symbols()}
        return [name for name in sorted(names) if key_of(name).kind in OPEN]


def vector_in_name(name: str) -> str:
    """The vector of which something is a component: `box.position` of `box.position.x`."""
    return name.rpartition(".")[0]


def is_acceleration(name: str) -> bool:
    """Whether a letter is that of an acceleration, or of how fast a rate changes."""
    kind = key_of(name).kind
    return kind in ACCELERATIONS or kind.startswith(SECOND)


def refuse_unread(scene: SpaceEquations) -> None:
    """Refuse what the scene says and nothing has read; of events, which end the motion, nothing need be."""
    problem = scene.configuration.problem
    for event in problem.events:
        read_all(event)
    if any(True for _ in idle_keys(problem)):
        look_at_bodies(scene)
    for fault in key_faults(problem):
        raise NotYet(fault.message, fault.span, fault.help)


def compiled_in_space(configuration: Configuration) -> SpaceSystem:
    """The equations of motion of a configuration in space, from its first state."""
    compiler = SpaceCompiler(configuration)
    try:
        found = compiler.compiled()
        rates = {item.letter: found.tape.constant(item.rate) for item in found.variables}
        still = frozenset(letter for letter, rate in rates.items() if rate is not None and vanishes(rate))
        if len(still) in (0, len(rates)):  # what is at rest altogether keeps its numbers
            return found
        compiler = SpaceCompiler(configuration, still)
        return compiler.compiled()
    except Unwritable as error:
        raise refusal(error, compiler.registry) from None
