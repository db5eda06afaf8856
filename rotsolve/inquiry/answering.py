"""Answering: plan and solve one asked quantity after the other, by the laws allowed, and choose between roots with a stated reason."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import combinations

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.formula import Call, Formula, Symbol
from rotsolve.algebra.units.dimension import Dimension
from rotsolve.core.derivation import Words
from rotsolve.core.equation import KINEMATICS, LAWS, NEWTON, Equation
from rotsolve.core.letters import letter_order
from rotsolve.core.quantity import DIMENSIONS
from rotsolve.core.registry import GENERIC, SEPARATOR
from rotsolve.inquiry.finds import Asked
from rotsolve.inquiry.history import History
from rotsolve.plan import Plan, Planner, Shortage
from rotsolve.scene.model import Find, Given
from rotsolve.solver import Choice, Contradiction, Found, NoClosedForm, Redundant, Ref, Solver

SECOND_CHOICE = 5  # equations of this cost serve only a law that is asked for, or a confirmation
TRIES = 30
TINY = 1e-14
OF_ONE_MOMENT = ("acceleration", "angular_acceleration", "tension", "force", "normal_force", "friction_force")
POSITIVE = ("mass", "length", "moment of inertia", "stiffness", "torsional stiffness", "time", "acceleration")


class NoAnswer(ValueError):
    """Nothing settles an asked quantity; `shortage` tells what is open where that is why."""

    def __init__(
        self, words: str, shortage: Shortage | None = None, equation: int | None = None, *, open_form: bool = False
    ) -> None:
        super().__init__(words)
        self.open_form = open_form  # whether only a closed form is missing
        self.shortage = shortage
        self.equation = equation


@dataclass(frozen=True)
class Answered:
    """An asked quantity with its solution and the pool indices of the equations that settled it."""

    asked: Asked
    found: Found
    used: tuple[int, ...]
    steps: tuple[int, int] = (0, 0)  # the steps of the solver that belong to it, from and up to


@dataclass
class Session:
    """One run over the questions of a scene, with one choice of laws."""

    history: History
    families: tuple[str, ...]
    spare: bool = False  # whether second-choice equations may be used from the start
    extra: tuple[Equation, ...] = ()
    answered: list[Answered] = field(default_factory=list)
    helped: list[str] = field(default_factory=list)  # questions for which the law asked for did not do alone
    defined: dict[str, int] = field(default_factory=dict)  # pool index of the definition of each question
    order: list[int] = field(default_factory=list)  # places of the answers in the order in which the scene asks
    retired: set[int] = field(default_factory=set)  # pool indices that no longer hold

    def __post_init__(self) -> None:
        problem = self.history.arrangement.problem
        self.givens = {given.name: given for given in problem.givens}
        self.values: dict[str, Formula] = {
            given.name: given.value for given in problem.givens if given.value is not None
        }
        self.pool = [*self.history.equations, *self.extra]
        self.planner = Planner(self.pool)
        self.refs: dict[int, Ref] = {}
        self.running = {"time"} | {
            travel.coordinate.name
            for passage in self.history.passages.values()
            for travel in passage.travels
            if isinstance(travel.coordinate, Symbol)
            and SEPARATOR in travel.coordinate.name
            and GENERIC in travel.coordinate.name
        }
        self.known = {given.name for given in problem.givens if not given.asked} | self.running
        self.solver = Solver(
            self.planner.pool,
            self._order(),
            positive_letters(problem.givens),
            self.values,
            self.choose,
            self.refs,
            frozenset(self.running),
        )

    def letters(self) -> dict[str, tuple[Formula, Dimension | None]]:
        """The answers so far by name: what later questions may use."""
        return {item.asked.find.name: (Symbol(item.asked.letter), item.asked.dimension) for item in self.answered}

    def in_order(self) -> list[Answered]:
        """The answers in the order in which the scene asks for them."""
        return [self.answered[place] for place in self.order] if self.order else list(self.answered)

    def _order(self) -> tuple[str, ...]:
        """All letters, givens before the quantities of the laws where they rank alike."""
        quantities = self.history.registry.quantities.values()
        named = [(given.name, given.dimension) for given in self.givens.values()]
        return letter_order([*named, *((quantity.key, quantity.dimension) for quantity in quantities)])

    def answer(self, asked: Asked, limit: Equation | None = None) -> Answered:
        """Settle one question, and remember it for the next; `limit` holds for this question alone ("on the point of slipping")."""
        extra = self.planner.extend(limit) if limit is not None else None
        try:
            return self._answer(asked)
        finally:
            if extra is not None:
                self.retired.add(extra)

    def _answer(self, asked: Asked) -> Answered:
        if not asked.direct and asked.letter not in self.defined:
            definition = Equation(
                Symbol(asked.letter), asked.formula, asked.label or "definition", asked.section, "", 1, remark_of(asked)
            )
            self.defined[asked.letter] = self.planner.extend(definition)
        first = len(self.solver.steps)
        if asked.letter in self.solver.solved:
            answered = Answered(asked, self.solver.solved[asked.letter], ())
        else:
            found, used = self._settle(asked)
            answered = Answered(asked, found, used, (first, len(self.solver.steps)))
        self.known.add(asked.letter)
        self.answered.append(answered)
        if asked.letter in self.defined and has_calls(asked.formula):
            self.retired.add(self.defined[asked.letter])  # a size does not lead back to what it is the size of
        return answered

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
            self._remember()
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
        allowed = [
            index
            for index, equation in enumerate(self.planner.pool)
            if index not in banned
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
        sound = [plan for plan in settled if self._sound(plan)] or self._with_few_times(letter, first) if settled else []
        if sound or settled:
            return min(sound or settled, key=lambda plan: plan.cost)
        return plans[0] if self.spare else self.planner.plan(letter, self.known, allowed)

    def _of_one_moment(self, letter: str) -> bool:
        """Whether a quantity belongs to one moment, so that Newton's laws are the straight way to it."""
        quantity = self.history.registry.quantities.get(letter)
        return quantity is not None and quantity.kind in OF_ONE_MOMENT

    def _sound(self, plan: Plan) -> bool:
        """Whether a plan does without a third equation of constant acceleration in a phase: of the four only two are independent,
        and the rules tie the coordinates of a phase together."""
        sections = [self.planner.pool[index].section for index in plan.equations if self._in_time(index)]
        return all(sections.count(section) <= 2 for section in set(sections))

    def _in_time(self, index: int) -> bool:
        equation = self.planner.pool[index]
        return equation.family == KINEMATICS and equation.label.startswith("constant")

    def _with_few_times(self, letter: str, allowed: list[int]) -> list[Plan]:
        """Plans with at most two equations of constant acceleration, of one coordinate."""
        rest = [index for index in allowed if not self._in_time(index)]
        coordinates: dict[tuple[str, str], list[int]] = {}
        for index in allowed:
            if self._in_time(index):
                equation = self.planner.pool[index]
                coordinates.setdefault((equation.section, equation.label), []).append(index)
        chosen = [pair for own in coordinates.values() for pair in (*combinations(own, 1), *combinations(own, 2))]
        plans = [self.planner.plan(letter, self.known, [*rest, *pair]) for pair in ((), *chosen)]
        return [plan for plan in plans if isinstance(plan, Plan)]

    def _starts(self, allowed: list[int]) -> list[list[int]]:
        """All laws together, then each alone: a search that starts from one law finds plans that leaving out step by step does not."""
        laws = [law for law in self.families if law in LAWS]
        alone = [
            [index for index in allowed if self.planner.pool[index].family in ("", KINEMATICS, law)] for law in laws
        ]
        return [allowed, *alone] if len(laws) > 1 else [allowed]

    def _remember(self) -> None:
        """Results found on the way may serve the next question."""
        for equation, ref in self.solver.derived:
            self.refs[self.planner.extend(equation)] = ref
        self.solver.derived.clear()

    # roots

    def choose(self, name: str, roots: Sequence[Formula]) -> Choice | None:
        """The root that is meant, with the reason."""
        real = [(index, number) for index, root in enumerate(roots) if (number := self.number(root)) is not None]
        if not real:
            return self._unnumbered(name, roots) if self._lacks_numbers(roots) else None
        moved = [entry for entry in real if abs(entry[1]) > TINY]
        if len(moved) < len(real) and moved and self._is_change(name):
            real = moved  # the root 0 is the start itself
        if len(real) == 1:
            return real[0][0], ()
        sign, words = self.expected(name)
        if sign:
            fitting = [entry for entry in real if entry[1] * sign > 0]
            if fitting:
                return min(fitting, key=lambda entry: abs(entry[1]))[0], words
        if self._is_angle(name):
            return min(real, key=lambda entry: abs(entry[1]))[0], ("the smallest angle",)
        return min(real, key=lambda entry: (entry[1] < 0, abs(entry[1])))[0], ("the positive root",)

    def _is_change(self, name: str) -> bool:
        """Whether a quantity is a change since the state before, or the time that it took."""
        quantity = self.history.registry.quantities.get(name)
        return quantity is not None and quantity.kind in ("displacement", "rotation", "time", "elongation")

    def _is_angle(self, name: str) -> bool:
        given, quantity = self.givens.get(name), self.history.registry.quantities.get(name)
        if quantity is not None:
            return quantity.kind == "angle"
        return given is not None and (given.dimension is None or is_angle(given))

    def _unnumbered(self, name: str, roots: Sequence[Formula]) -> Choice:
        """Without numbers a root is chosen by the sign that the scene suggests: not negative unless said."""
        sign, words = self.expected(name)
        if sign < 0 and len(roots) > 1:
            return 1, words
        return 0, words or ("the root along the positive sense",)

    def _lacks_numbers(self, roots: Sequence[Formula]) -> bool:
        return any(root.symbols() - set(self.values) for root in roots)

    def number(self, value: Formula) -> float | None:
        """A rough value; None where it is not real or a given has no number."""
        try:
            return evaluate(value, self.values, digits=8).float
        except (Undefined, ValueError, ZeroDivisionError):
            return None

    def expected(self, name: str) -> tuple[int, Words]:
        """The sign that a quantity must have, and why: (+1, −1 or 0 where nothing tells)."""
        quantity = self.history.registry.quantities.get(name)
        if quantity is None:
            return (1, (Symbol(name), " > 0")) if self._is_size(name) else (0, ())
        if quantity.kind in ("velocity", "angular_velocity") and not quantity.component:
            return self._direction(quantity.kind, quantity.owner, quantity.when, name)
        if quantity.kind in ("displacement", "rotation"):
            return self._onward(quantity.kind, quantity.owner, quantity.when)
        if quantity.kind in ("time", "tension", "mass", "normal_force"):
            return 1, (Symbol(name), " > 0")
        return 0, ()

    def _is_size(self, name: str) -> bool:
        given = self.givens.get(name)
        return given is not None and given.dimension is not None and not given.dimension.matches(DIMENSIONS["angle"])

    def _direction(self, kind: str, owner: str, state: str, name: str) -> tuple[int, Words]:
        """Which way a body moves at a state: the way it has gone since the state before, else as it started or is pushed."""
        timeline = self.history.arrangement.timeline
        if state not in timeline.order:
            return 0, ()
        before = timeline.before(state)
        quantity = self.history.registry.quantities[name]
        if before is None or before.event is not None:
            return 0, ()
        passage = self.history.passages[before.name]
        travel = next(
            (
                item
                for item in passage.travels
                if item.body == owner and (item.kind == "turn") == (kind == "angular_velocity")
            ),
            None,
        )
        if travel is None:
            return 0, ()
        change = travel.end - travel.start if travel.start is not None and travel.end is not None else travel.change
        for value in (change, travel.before, self._push(travel.initial)):
            size = self.number(self.solver._with_answers(value)) if value is not None else None
            if size:
                sign = 1 if size > 0 else -1
                verb = "turns" if kind == "angular_velocity" else "moves"
                words = quantity.positive if sign > 0 else quantity.negative
                relation = " > 0" if sign > 0 else " < 0"
                return sign, (f"{owner.replace('_', ' ')} {verb} {words}: ", Symbol(name), relation)
        return 0, ()

    def _onward(self, kind: str, owner: str, interval: str) -> tuple[int, Words]:
        """Which way a body goes in a phase: as it moves at the start, else as it is pushed."""
        passage = self.history.passages.get(interval)
        wanted = "line" if kind == "displacement" else "turn"
        travel = (
            next((item for item in passage.travels if item.body == owner and item.kind == wanted), None)
            if passage
            else None
        )
        if travel is None:
            return 0, ()
        for value in (travel.before, self._push(travel.initial), travel.after):
            size = self.number(self.solver._with_answers(value)) if value is not None else None
            if size:
                return (1 if size > 0 else -1), ("the way in which it starts to move",)
        return 0, ()

    def _push(self, acceleration: Formula | None) -> Formula | None:
        """The acceleration that starts the motion, found aside."""
        if acceleration is None or not isinstance(acceleration, Symbol) or SEPARATOR not in acceleration.name:
            return acceleration
        aside = Session(self.history, (NEWTON,))
        try:
            return aside.value_of(acceleration.name)
        except NoAnswer:
            return None

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
    return (asked.remark,) if asked.remark else ()


def has_calls(value: Formula) -> bool:
    """Whether a letter of the laws stands inside a function."""
    return any(isinstance(node, Call) and any(SEPARATOR in name for name in node.symbols()) for node in value.walk())


def positive_letters(givens: Sequence[Given]) -> frozenset[str]:
    """Givens that are positive: masses, lengths, times and the like, and every number that is."""
    result = set()
    for given in givens:
        sized = given.dimension is not None and any(DIMENSIONS[word] == given.dimension for word in POSITIVE)
        if sized and not given.asked:
            result.add(given.name)
        elif given.value is not None and not given.asked and not is_angle(given):
            try:
                if (
                    evaluate(given.value, {g.name: g.value for g in givens if g.value is not None}, digits=3).sign or 0
                ) > 0:
                    result.add(given.name)
            except (Undefined, ValueError):
                continue
    return frozenset(result)


def is_angle(given: Given) -> bool:
    return given.dimension is not None and given.dimension == DIMENSIONS["angle"]


def families_for(law: str | None) -> tuple[str, ...]:
    """The equation families that a law may use; all for none."""
    return (*LAWS, KINEMATICS) if law is None else (law, KINEMATICS)
