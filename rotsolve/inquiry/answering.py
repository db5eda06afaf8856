"""Answering: plan and solve one asked quantity after the other, by the laws allowed."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from itertools import combinations

from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.exact.normal import coefficients
from rotsolve.algebra.formula import ZERO, Call, Formula, Symbol
from rotsolve.algebra.units.dimension import Dimension
from rotsolve.core.derivation import Words
from rotsolve.core.equation import ANGULAR_MOMENTUM, KINEMATICS, LAWS, NEWTON, Equation
from rotsolve.core.letters import letter_order
from rotsolve.core.registry import GENERIC, SEPARATOR
from rotsolve.core.varying import POSITION, RATE
from rotsolve.inquiry.answers import Answered, Chosen
from rotsolve.inquiry.courses import Beside
from rotsolve.inquiry.history import History
from rotsolve.inquiry.questions import Asked
from rotsolve.inquiry.signs import Signs
from rotsolve.inquiry.stepwise import Stepwise
from rotsolve.inquiry.swings.settling import release, settled
from rotsolve.motion.positive import positive_letters
from rotsolve.plan import Plan, Planner, Shortage
from rotsolve.scene.model import Find
from rotsolve.solver import Contradiction, Found, NoClosedForm, Redundant, Ref, Solver

SECOND_CHOICE = 5  # equations of this cost serve only a law that is asked for, or a confirmation
BACKWARDS = 4  # cost of the way back from an answer to what it was defined by
TRIES = 30
MOST_PLANS = 60  # that are looked through for one with few equations of constant acceleration
OF_ONE_MOMENT = ("acceleration", "angular_acceleration", "tension", "force", "normal_force", "friction_force")


class NoAnswer(ValueError):
    """Nothing settles an asked quantity; `shortage` tells what is open where that is why."""

    def __init__(
        self, words: str, shortage: Shortage | None = None, equation: int | None = None, *, open_form: bool = False
    ) -> None:
        super().__init__(words)
        self.open_form = open_form  # whether only a closed form is missing
        self.shortage = shortage
        self.equation = equation


@dataclass
class Inquiry:
    """One run over the questions of a scene, with one choice of laws."""

    history: History
    families: tuple[str, ...]
    spare: bool = False  # whether second-choice equations may be used from the start
    extra: tuple[Equation, ...] = ()
    answered: list[Answered] = field(default_factory=list)
    swung: set[str] = field(default_factory=set)  # sections of the harmonic motions that have been written
    displaced: dict[str, Formula] = field(default_factory=dict)  # accelerations as functions of a displacement
    helped: list[str] = field(default_factory=list)  # questions for which the law asked for did not do alone
    defined: dict[str, int] = field(default_factory=dict)  # pool index of the definition of each question
    chosen: list[Chosen] = field(default_factory=list)  # answers that are labels
    retired: set[int] = field(default_factory=set)  # pool indices that no longer hold
    extrema: dict[tuple[Formula, str, str], Answered] = field(
        default_factory=dict
    )  # (quantity, letter, word): its place

    def __post_init__(self) -> None:
        problem = self.history.arrangement.problem
        self.givens = {given.name: given for given in problem.givens}
        self.values: dict[str, Formula] = {
            given.name: given.value for given in problem.givens if given.value is not None
        }
        self.pool = [*self.history.equations, *self.extra]
        self.planner = Planner(self.pool, [given.name for given in problem.givens if given.asked])
        self.stepwise = Stepwise(self.planner)
        self.refs: dict[int, Ref] = {}
        self.signs = Signs(
            self.history,
            self.givens,
            self.values,
            lambda value: self.solver.with_found(value),
            self.aside,
            self.definition,
        )
        self.running = {"time"} | {
            letter.name
            for passage in self.history.passages.values()
            for travel in passage.travels
            for letter in (
                travel.coordinate if travel.pace == POSITION else None,
                travel.moving if travel.leads and travel.pace == RATE else None,
            )
            if isinstance(letter, Symbol) and SEPARATOR in letter.name and GENERIC in letter.name
        }
        self.known = {given.name for given in problem.givens if not given.asked} | self.running
        self.running |= {swing.coordinate.name for swing in self.history.swings.values()}
        self.solver = Solver(
            self.planner.pool,
            self._order(),
            positive_letters(problem.givens),
            self.values,
            self.signs.choose,
            self.refs,
            frozenset(self.running),
        )

    def letters(self) -> dict[str, tuple[Formula, Dimension | None]]:
        """The answers so far by name: what later questions may use."""
        return {item.asked.find.name: (Symbol(item.asked.letter), item.asked.dimension) for item in self.wholes()}

    def beside(self) -> Beside:
        """What can be worked out without a trace in this inquiry."""
        other = Inquiry(self.history, families_for(None)) if self.history.arrangement.mentions.runs else self
        return Beside(other.settled, self.values)

    def in_order(self) -> list[Answered | Chosen]:
        """The answers in the order in which the scene asks for them."""
        finds = self.history.arrangement.problem.finds
        place = {find.name: number for number, find in enumerate(finds)}
        return sorted([*self.wholes(), *self.chosen], key=lambda item: place.get(item.find.group, len(place)))

    def wholes(self) -> list[Answered]:
        """The answers that are not parts of others (components, what a choice compares, steps on the way)."""
        return [item for item in self.answered if not item.asked.whole and not item.aside]

    def _order(self) -> tuple[str, ...]:
        """All letters, givens before the quantities of the laws where they rank alike."""
        quantities = self.history.registry.quantities.values()
        named = [(given.name, given.dimension) for given in self.givens.values()]
        return letter_order([*named, *((quantity.key, quantity.dimension) for quantity in quantities)])

    def answer(self, asked: Asked, limit: Equation | None = None, *, aside: bool = False) -> Answered:
        """Settle one question, and remember it for the next; `limit` holds for this question alone ("on the point of slipping")."""
        passing = [self.planner.extend(limit)] if limit is not None else []
        try:
            passing += settled(asked, self)
            return self._answer(asked, aside)
        finally:
            self.retired.update(passing)
            release(asked, self)

    def _answer(self, asked: Asked, aside: bool = False) -> Answered:
        """Settle one question, a vector after its components; what is not a letter of the laws is first given one by a definition."""
        self.stepwise.take(asked)
        parts = tuple(self._part(part) for part in asked.parts)
        for law in asked.laws:
            if law not in self.planner.pool:
                self.planner.extend(law)
        if not asked.direct and asked.letter not in self.defined:
            section = asked.section or self._section_of(asked.formula)
            label = asked.label or "definition"
            definition = Equation(Symbol(asked.letter), asked.formula, label, section, "", 1, remark_of(asked))
            self.defined[asked.letter] = self.planner.extend(definition)
        first = len(self.solver.steps)
        if asked.find.whole and asked.formula == ZERO:  # an entry that symmetry makes vanish takes no step
            self.solver.solved[asked.letter] = Found(asked.letter, ZERO)
        if asked.letter in self.solver.solved:
            answered = Answered(asked, self.solver.solved[asked.letter], (), parts=parts, aside=aside)
        else:
            found, used = self._settle(asked)
            answered = Answered(asked, found, used, (first, len(self.solver.steps)), parts, aside)
        self.known.add(asked.letter)
        self.answered.append(answered)
        meant = self.defined.get(asked.letter)
        if meant is not None and (
            asked.whole or not self._leads_back(asked.formula) or self._turned_round(meant, first)
        ):
            self.retired.add(meant)  # a size, a component or a loss does not lead back to what it is made of
        elif meant is not None:
            self.planner.dear.add(meant)
        return answered

    def _section_of(self, formula: Formula) -> str:
        """Where what is made of earlier answers is written: with the last of them."""
        earlier = [item.asked for item in self.answered if item.asked.letter in formula.symbols()]
        return earlier[-1].section if earlier else ""

    def _leads_back(self, meaning: Formula) -> bool:
        """Whether a definition may tell what it is made of: a single unknown, in proportion or with a sum, as in φ = θ + π/2."""
        names = {name for name in meaning.symbols() if name not in self.givens or self.givens[name].asked}
        parts = coefficients(meaning, names.pop()) if len(names) == 1 else None
        return parts is not None and len(parts) == 2

    def _turned_round(self, definition: int, first: int) -> bool:
        """Whether a step since the `first` one solved a definition for what it is made of, so that it need not be done again."""
        return any(step.target == ("law", definition) and step.sources == () for step in self.solver.steps[first:])

    def step(self, letter: str) -> Found:
        """Settle a letter on the way to an answer, with a derivation of its own."""
        first = len(self.solver.steps)
        asked = Asked(Find(letter, Symbol(letter), ()), Symbol(letter), letter, None)
        found, used = self._settle(asked)
        self.answered.append(Answered(asked, found, used, (first, len(self.solver.steps)), aside=True))
        self.known.add(letter)
        return found

    def _part(self, asked: Asked) -> Answered:
        """A component of a vector, which may have been asked before in its own right."""
        known = next((item for item in self.answered if item.asked.same_as(asked)), None)
        if known is None:
            return self._answer(asked)
        self.known.add(asked.letter)
        self.solver.solved.setdefault(asked.letter, known.found)
        return replace(known, asked=asked)

    def _settle(self, asked: Asked) -> tuple[Found, tuple[int, ...]]:
        """In closed form by some plan, else numerically."""
        try:
            return self._attempt(asked)
        except NoAnswer as error:
            if not error.open_form:
                raise
        self.solver.numeric = True
        try:
            return self._attempt(asked)
        finally:
            self.solver.numeric = False

    def _attempt(self, asked: Asked) -> tuple[Found, tuple[int, ...]]:
        """Plan and solve; an equation that says nothing new is left out and the plan made again."""
        banned: set[int] = set()
        problem: ValueError | None = None
        open_: Shortage | None = None
        for _ in range(TRIES):
            plan = self._plan(asked.letter, banned)
            if isinstance(plan, Shortage) or open_ is None:
                open_ = Shortage(plan.asked, plan.equations, plan.unknowns)
            if isinstance(plan, Shortage):
                if problem is not None:
                    break
                raise NoAnswer("too little is known", plan)
            try:
                found = self.solver.solve(plan)
            except (Redundant, Contradiction) as error:
                banned.add(error.index)
                problem = error if problem is None or isinstance(error, Contradiction) else problem
                continue
            except (NoClosedForm, Undefined) as error:
                banned.add(self._hardest(plan))
                problem = problem or error
                continue
            self.remember()
            return found, plan.equations
        if isinstance(problem, Contradiction):
            raise NoAnswer("the data contradict each other", None, problem.index)
        open_form = isinstance(problem, (NoClosedForm, Undefined))
        raise NoAnswer(str(problem) if open_form else "too little is known", open_, open_form=open_form)

    def _hardest(self, plan: Plan) -> int:
        """The equation of a plan to do without: one with roots or bars round unknowns first, else the dearest."""

        def hardness(index: int) -> tuple[bool, int]:
            equation = self.planner.pool[index]
            return has_calls(equation.left) or has_calls(equation.right), equation.cost

        return max(plan.equations, key=hardness)

    def _plan(self, letter: str, banned: set[int]) -> Plan | Shortage:
        """The cheapest plan by the laws chosen; second-choice equations only where the first ones do not do."""
        stepwise = self.stepwise.plan(letter, self.known, self.defined.get(letter), banned)
        if stepwise is not None:
            return stepwise
        foreign = self.stepwise.foreign(letter)
        allowed = [
            index
            for index, equation in enumerate(self.planner.pool)
            if index not in banned
            and index not in foreign
            and index not in self.retired
            and (not equation.family or equation.family in self.families)
        ]
        if self._of_one_moment(letter) and NEWTON in self.families and not self.spare:
            moment = [index for index in allowed if self.planner.pool[index].family in ("", NEWTON)]
            moment = [index for index in moment if self.planner.pool[index].cost < SECOND_CHOICE]
            plan = self.planner.plan(letter, self.known, moment)
            if isinstance(plan, Plan):
                return plan
        first = allowed if self.spare else [index for index in allowed if self.planner.pool[index].cost < SECOND_CHOICE]
        plans = [self.planner.plan(letter, self.known, pool) for pool in self._starts(first)]
        settled = [plan for plan in plans if isinstance(plan, Plan)]
        sound = (
            [plan for plan in settled if not self._crowded(plan)] or self._with_few_times(letter, first)
            if settled
            else []
        )
        if sound or settled:
            return min(sound or settled, key=lambda plan: plan.cost)
        return plans[0] if self.spare else self.planner.plan(letter, self.known, allowed)

    def _of_one_moment(self, letter: str) -> bool:
        """Whether a quantity belongs to one moment, so that Newton's laws are the straight way to it."""
        quantity = self.history.registry.quantities.get(letter)
        return quantity is not None and quantity.kind in OF_ONE_MOMENT

    def _in_time(self, indices: Iterable[int]) -> dict[str, dict[str, list[int]]]:
        """The equations of constant acceleration among some, by phase and by coordinate."""
        phases: dict[str, dict[str, list[int]]] = {}
        for index in indices:
            equation = self.planner.pool[index]
            if equation.family == KINEMATICS and equation.label.startswith("constant"):
                phases.setdefault(equation.section, {}).setdefault(equation.label, []).append(index)
        return phases

    def _crowded(self, plan: Plan, *, strict: bool = False) -> list[int]:
        """Three or more equations of constant acceleration of one phase: of the four only two are independent, and the rules tie
        the coordinates of a phase together; if `strict` also any of two coordinates."""
        for coordinates in self._in_time(plan.equations).values():
            together = [index for own in coordinates.values() for index in own]
            if len(together) > 2 or (strict and len(coordinates) > 1):
                return together
        return []

    def _with_few_times(self, letter: str, allowed: list[int]) -> list[Plan]:
        """Plans with at most two equations of constant acceleration, of one coordinate; of one in each phase where there are several."""
        phases = self._in_time(allowed)
        coordinates = [own for phase in phases.values() for own in phase.values()]
        rest = [index for index in allowed if not any(index in own for own in coordinates)]
        chosen = [pair for own in coordinates for pair in (*combinations(own, 1), *combinations(own, 2))]
        plans = [self.planner.plan(letter, self.known, [*rest, *pair]) for pair in ((), *chosen)]
        found = [plan for plan in plans if isinstance(plan, Plan)]
        return found + self._thinned(letter, allowed) if len(phases) > 1 else found

    def _thinned(self, letter: str, allowed: list[int]) -> list[Plan]:
        """Plans for several phases: of too many equations of constant acceleration in one each is left out in its turn."""
        found: list[Plan] = []
        pending, seen = [frozenset[int]()], set[frozenset[int]]()
        while pending and len(seen) < MOST_PLANS:
            dropped = pending.pop(0)
            if dropped in seen:
                continue
            seen.add(dropped)
            plan = self.planner.plan(letter, self.known, [index for index in allowed if index not in dropped])
            crowded = self._crowded(plan, strict=True) if isinstance(plan, Plan) else []
            found += [plan] if isinstance(plan, Plan) and not crowded else []
            pending += [dropped | {index} for index in crowded]
        return found

    def _starts(self, allowed: list[int]) -> list[list[int]]:
        """All laws together, then each alone: a search that starts from one law finds plans that leaving out step by step does not."""
        laws = [law for law in self.families if law in LAWS]
        alone = [
            [index for index in allowed if self.planner.pool[index].family in ("", KINEMATICS, law)] for law in laws
        ]
        summed = [index for index in allowed if self.planner.pool[index].family in ("", ANGULAR_MOMENTUM)]
        return [allowed, *alone, summed] if len(laws) > 1 else [allowed]  # impulses sum over a phase without kinematics

    def remember(self) -> None:
        """Results found on the way may serve the next question."""
        for equation, ref in self.solver.derived:
            self.refs[self.planner.extend(equation)] = ref
        self.solver.derived.clear()

    def number(self, value: Formula) -> float | None:
        """A rough value; None where it is not real or a given has no number."""
        return self.signs.number(value)

    def aside(self, letter: str) -> Formula | None:
        """A letter by Newton's laws alone, without a trace in this inquiry."""
        try:
            return Inquiry(self.history, (NEWTON,)).value_of(letter)
        except NoAnswer:
            return None

    def apart(self) -> Inquiry:
        """An inquiry by all laws that knows the answers of this one and leaves no trace in it."""
        other = Inquiry(self.history, families_for(None))
        other.solver.solved.update(self.solver.solved)
        other.known |= {name for name, found in self.solver.solved.items() if found.formula is not None}
        return other

    def definition(self, letter: str) -> Formula | None:
        """What an asked letter was defined to stand for."""
        return self.planner.pool[self.defined[letter]].right if letter in self.defined else None

    def settled(self, value: Formula) -> Formula | None:
        """A formula with every letter of the laws worked out, without a derivation; None where one is not settled."""
        for name in sorted(value.symbols()):
            if SEPARATOR in name:
                try:
                    found = self.value_of(name)
                except NoAnswer:
                    return None
                if found is None:
                    return None
                value = value.substitute({name: found})
        return value

    def value_of(self, letter: str) -> Formula | None:
        """The closed form of a letter, without a derivation."""
        find = Find(letter, Symbol(letter), ())
        return self.answer(Asked(find, Symbol(letter), letter, None)).found.formula


def remark_of(asked: Asked) -> Words:
    return asked.said or ((asked.remark,) if asked.remark else ())


def has_calls(value: Formula) -> bool:
    """Whether a letter of the laws stands inside a function."""
    return any(isinstance(node, Call) and any(SEPARATOR in name for name in node.symbols()) for node in value.walk())


def families_for(law: str | None) -> tuple[str, ...]:
    """The equation families that a law may use; all for none."""
    return (*LAWS, KINEMATICS) if law is None else (law, KINEMATICS)
