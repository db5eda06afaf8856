"""Search: one run over the questions of a scene: each is planned and solved by the laws allowed, and remembered for the next."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from contextlib import suppress
from typing import TYPE_CHECKING

from msgspec import Struct, field
from msgspec.structs import replace

from rotsolve.algebra.certified.ball import Certified, evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.certified.sign import SignOracle, real_where
from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.exact.order import length
from rotsolve.algebra.formula import PI, ZERO, Formula, Symbol
from rotsolve.algebra.units.dimension import Dimension
from rotsolve.core.equation import NEWTON, VANISHING, Equation
from rotsolve.core.letters import letter_order
from rotsolve.core.remembered import remembered
from rotsolve.core.symbols import COMPONENT, POSITION, RATE, RATES, has_quantities, is_key, key_of, of_kinds
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.language.problem import EXTREMES, Find
from rotsolve.matching import Plan
from rotsolve.motion.positive import is_angle
from rotsolve.plan import Planner, Shortage
from rotsolve.profile import staged
from rotsolve.questions.find import Asked
from rotsolve.search.answers import Answered, Chosen, NoAnswer, unsolvable
from rotsolve.search.definitions import Definitions, Stepwise
from rotsolve.search.later import later_on
from rotsolve.search.numbers import Numbers
from rotsolve.search.planning import FORCES, OF_ONE_MOMENT, LawChoice, families_for, has_calls, sums
from rotsolve.solver import ENTANGLED, Solver
from rotsolve.solver.steps import (
    Contradiction,
    Found,
    NoClosedForm,
    NoRealValue,
    NumbersWanted,
    PickedRoot,
    Redundant,
    Ref,
)

if TYPE_CHECKING:
    from rotsolve.core.passage import Passage
    from rotsolve.equations.normal_modes import Spectrum
    from rotsolve.questions.functions_of_time import Beside

# letters of a scene that may have to be settled before an answer; of those that numbers alone tell
STONES_TRIED, NUMBERED_STONES_TRIED = 3, 2
# lines that a refusal may propose, tried for all questions together; where what rubs makes that slow
HELPS_TRIED, FEW_HELPS = 8, 2
INDEPENDENT = 2  # of the equations of steady acceleration about one motion
SHORT = 12  # nodes of what has been found for a letter on the way, which is then taken as it stands
TURN = 2 * PI
TRIES, FEW_TRIES = 30, 5  # plans for an answer, and for the confirmation of one


class Ground:
    """What all searches of a scene share: its equations as the planner sees them, its givens and their signs, the letters that run."""

    def __init__(self, scene: SceneEquations, families: Collection[str]) -> None:
        configuration, problem = scene.configuration, scene.configuration.problem
        self.scene = scene
        self.chose = False  # whether some equation had several roots
        self.tried, self.working_out = set[int](), set[str]()  # equations looked into, letters being told aside
        self.passed_over: dict[str, list[Formula]] = {}  # roots for letters with which the scene does not come about
        self.picked: dict[str, Formula] = {}  # those that are meant, where others are known
        self.givens = {given.name: given for given in problem.givens}
        self.signs = SignOracle(
            problem.values, configuration.positive, configuration.signs.limits, trials=problem.trials
        )
        self.equations = scene.with_asked(families)
        if len(problem.sought) > 1:
            from rotsolve.search.components import by_components

            self.equations = by_components(self.equations, scene, self.signs.positive)
        self.planner = Planner(self.equations, [given.name for given in problem.givens if given.asked])
        running = {"time"} | places_and_speeds(scene.passages.values())
        self.known = {given.name for given in problem.givens if not given.asked} | running
        self.running = frozenset(running | {swing.coordinate.name for swing in scene.swings.values()})
        self.forces_asked = any(term.path.quantity in FORCES for find in problem.finds for term in find.terms)
        self.stones_left, self.numbered_stones_left = STONES_TRIED, NUMBERED_STONES_TRIED
        self.helps_left = FEW_HELPS if scene.modes else HELPS_TRIED
        self._order: tuple[str, ...] = ()
        self._ordered = -1

    @property
    def order(self) -> tuple[str, ...]:
        """All letters, givens before the quantities of the laws where they rank alike; questions may bring more of them."""
        quantities = self.scene.registry.quantities
        if len(quantities) != self._ordered:
            named = [(given.name, given.dimension) for given in self.givens.values()]
            asked_for = ((quantity.key, quantity.dimension) for quantity in quantities.values())
            self._order, self._ordered = letter_order([*named, *asked_for]), len(quantities)
        return self._order


class Search(Struct, dict=True):
    """One run over the questions of a scene, with one choice of laws; `another` begins anew on the same ground."""

    scene: SceneEquations
    families: tuple[str, ...]
    spare: bool = False  # whether second-choice equations may be used from the start
    confirming: bool = False  # whether answers are only to be confirmed: in closed form, by one of a few plans
    careful: bool = False  # whether each root is held against all that the laws write before it is chosen
    ground: Ground | None = None
    thorough: bool = False  # whether it is worth the time to look for what may help a question without an answer
    answered: list[Answered] = field(default_factory=list)
    chosen: list[Chosen] = field(default_factory=list)  # answers that are labels
    helped: list[str] = field(default_factory=list)  # questions for which the law asked for did not do alone
    swung: set[str] = field(default_factory=set)  # sections of the harmonic motions that have been written
    rivals: dict[str, tuple[Formula, ...]] = field(
        default_factory=dict
    )  # other roots for letters of the scene that answers settle
    seeking: Find | None = None  # the question with an equation of its own that is at hand
    separate: set[str] = field(default_factory=set)  # the questions that seek an unknown letter, each its own value
    displaced: dict[str, Formula] = field(default_factory=dict)  # accelerations as functions of a displacement
    spectra: dict[str, Spectrum] = field(default_factory=dict)  # of the normal modes of bodies, by their section
    retired: set[int] = field(default_factory=set)  # pool indices that no longer hold
    failed: dict[object, NoAnswer] = field(default_factory=dict)  # what has had no answer, by all on which that hangs
    settling: set[str] = field(default_factory=set)  # the letters for which others are being settled first
    # the places of extrema, by (quantity, letter, word)
    extrema: dict[tuple[Formula, str, str], Answered] = field(default_factory=dict)

    def __post_init__(self) -> None:
        ground = self.ground = self.ground or Ground(self.scene, self.families)
        self.givens, self.signs, self.values = ground.givens, ground.signs, ground.signs.values
        self.planner, self.equations = ground.planner.afresh(), ground.equations
        self.stepwise = Stepwise(self.planner)
        self.definitions = Definitions(self.planner, self.givens)
        self.refs: dict[int, Ref] = {}
        self.found_for: dict[str, int] = {}  # what was found for letters on the way, by its place in the pool
        self.numbers = Numbers(
            self.signs, lambda value: self.solver.with_found(value), self.aside, lambda value: is_unreal(value, self)
        )
        self.forces_asked, self.running, self.known = ground.forces_asked, ground.running, set(ground.known)
        self.solver = Solver(
            pool=self.planner.pool,
            order=ground.order,
            signs=self.signs,
            choose=self.choose_root,
            refs=self.refs,
            tried=ground.tried,
            running=self.running,
            lone=len(self.scene.configuration.problem.finds) == 1,
        )

    def another(self, families: tuple[str, ...], *, spare: bool = False, confirming: bool = False) -> Search:
        """A search by other laws on the same ground, which knows nothing of what this one has found."""
        return Search(self.scene, families, spare, confirming, self.careful, self.ground)

    @remembered
    def beside_by(self, families: tuple[str, ...]) -> Search:
        """The search by some laws that goes on beside this one: what it has worked out once serves whoever asks next."""
        return self.another(families)

    def choose_root(
        self, name: str, roots: Sequence[Formula], period: Formula | None = None, *, asked: Find | None = None
    ) -> PickedRoot | None:
        """Which of several roots of an equation is meant, and why; the others of a letter of the scene are remembered.

        A question that seeks the letter, `asked`, the one at hand or the only one, may say that its `largest` or `smallest` value is meant.
        """
        turns = [0] * len(roots)
        round_ = period is None or is_zero(period - TURN)
        passed = self.ground is not None and name in self.ground.passed_over
        if name in self.givens and round_ and (name == self.solver.once_round or (passed and self.may_be_angle(name))):
            turns = [whole_turns(root, self) for root in roots]
            roots = [root + count * TURN for root, count in zip(roots, turns, strict=True)]
        picked = self.picked_root(name, roots, period)
        if picked is not None and name in self.givens:
            finds = (self.seeking, *self.scene.configuration.problem.finds)
            asked = asked or next((find for find in finds if find is not None and find.seeks == name), None)
            asked = asked or self.extreme_asked(name, picked)
            if asked is not None and asked.modifier in EXTREMES:
                from rotsolve.search.roots import extreme_root

                picked = extreme_root(name, roots, picked, asked, self)
            if (
                picked.guessed or self.scene.configuration.problem.space
            ):  # there a rate of the other sense may have another size
                others = picked.alike or range(len(roots))
                self.rivals[name] = tuple(roots[index] for index in others if index != picked.root)
                if (
                    self.ground is not None and self.givens[name].asked
                ):  # where nothing comes about with it, others may do
                    self.ground.picked[name] = roots[picked.root]
        if picked is not None and turns[picked.root]:
            return replace(picked, turns=picked.turns + turns[picked.root])
        return picked

    def extreme_asked(self, name: str, picked: PickedRoot) -> Find | None:
        """The question for the largest or smallest value of a letter, where no motion tells which it comes to first."""
        asked = next((find for find in self.scene.configuration.problem.finds if find.extreme_letter == name), None)
        if asked is not None and picked.reached:
            message = f"`{name}` is where its state is reached first: `{asked.modifier}` chooses none of several there"
            raise unsolvable(self.scene.configuration.problem, message, asked.span, f"write `{asked.name}: {name}`")
        if asked is None or not self.scene.configuration.problem.space:
            return asked
        from rotsolve.space.roots import way_on_hinge
        from rotsolve.space.steady import steady_letter

        return None if steady_letter(name, self.scene) or way_on_hinge(name, self.scene, self.numbers) else asked

    def picked_root(self, name: str, roots: Sequence[Formula], period: Formula | None) -> PickedRoot | None:
        """Which of several roots of an equation is meant, and why."""
        from rotsolve.search.roots import RootChoice, among, by_motion, check_alone, nearest_turn

        if self.ground is not None:
            self.ground.chose = True
        choice = RootChoice(self.scene, self.givens, self.numbers, self.definitions.formula)
        from rotsolve.search.consistency import roots_with_values

        check_alone(name, [root for root in roots if self.numbers.of(root) is not None])
        plain = not self.careful or period is not None
        fitting = roots_with_values(name, roots, self, plain=plain)
        if not plain and len(fitting) == 1 < len(roots):
            return PickedRoot(fitting[0], ("the only root that all laws allow",))
        passed = () if self.ground is None else self.ground.passed_over.get(name, ())
        fitting = [number for number in fitting if roots[number] not in passed]
        if passed and len(fitting) == 1:
            return PickedRoot(fitting[0], ("with the others it does not come about",), guessed=True)
        left = [roots[number] for number in fitting]
        picked = by_motion(name, left, self) or choice.choose(name, left, period)
        return picked and nearest_turn(name, among(fitting, picked), roots, period, self)

    def letters(self) -> dict[str, tuple[Formula, Dimension | None]]:
        """The answers so far by name: what later questions may use."""
        return {item.asked.find.name: (Symbol(item.asked.letter), item.asked.dimension) for item in self.wholes()}

    def beside(self) -> Beside | None:
        """What can be worked out without a trace in this search, for what takes functions of time; None where nothing does."""
        if not self.scene.configuration.mentions.runs:
            return None
        from rotsolve.questions.functions_of_time import Beside

        return Beside(self.beside_by(families_for(None)).settled, self.signs)

    def in_order(self) -> list[Answered | Chosen]:
        """The answers in the order in which the scene asks for them."""
        finds = self.scene.configuration.problem.finds
        place = {find.name: number for number, find in enumerate(finds)}
        return sorted([*self.wholes(), *self.chosen], key=lambda item: place.get(item.find.group, len(place)))

    def may_be_angle(self, letter: str) -> bool:
        """Whether a letter of the scene is an angle, as far as its dimension is known."""
        given = self.givens.get(letter)
        return given is not None and (given.dimension is None or is_angle(given))

    def wholes(self) -> list[Answered]:
        """The answers that are not parts of others (components, what a choice compares, steps on the way)."""
        return [item for item in self.answered if not item.asked.whole and not item.aside]

    def answer(self, asked: Asked, *limits: Equation, aside: bool = False) -> Answered:
        """Settle one question, and remember it for the next; `limits` hold for this question alone ("on the point of slipping")."""
        passing = [self.planner.extend(limit) for limit in limits]
        try:
            if asked.swings or self.scene.observed:
                from rotsolve.search.swings import settle_swings

                passing += settle_swings(asked, self)
            return self._answer(asked, aside)
        finally:
            self.retired.update(passing)
            for swing, _ in asked.swings:  # what depends on the displacement serves no other question
                self.known -= {swing.coordinate.name, swing.acceleration.name}
                self.solver.solved.pop(swing.acceleration.name, None)

    def _answer(self, asked: Asked, aside: bool = False) -> Answered:
        """Settle one question, a vector after its components; what is not a letter of the laws is first given one by a definition."""
        self.stepwise.take(asked)
        parts = tuple(self._part(part) for part in asked.parts)
        self._enter(asked)
        first = len(self.solver.steps)
        if asked.find.whole and asked.formula == ZERO and asked.law != VANISHING:  # by symmetry: it takes no step
            self.solver.solved[asked.letter] = Found(asked.letter, ZERO)
        if asked.letter in self.solver.solved:
            answered = Answered(asked, self.solver.solved[asked.letter], (), parts=parts, aside=aside)
        else:
            found, used, own = self._settle(asked)
            answered = Answered(asked, found, used, (own, len(self.solver.steps)), parts, aside)
        self.known.add(asked.letter)
        self.answered.append(answered)
        self.retired |= self.definitions.spent(asked, self.solver.steps[first:])
        return answered

    def _enter(self, asked: Asked) -> None:
        """Let the planner know what a question alone speaks of, and what its letter stands for."""
        self.enter_laws(asked)
        self.definitions.enter(asked, self.answered)

    def enter_laws(self, asked: Asked) -> None:
        """Let the planner know what a question alone speaks of."""
        for law in asked.laws:
            if law not in self.planner.pool:
                self.planner.extend(law)

    def planned(self, asked: Asked, banned: set[int]) -> Plan | Shortage:
        """The plan for a question whose components are known, without some equations; nothing is solved."""
        self.stepwise.take(asked)
        self._enter(asked)
        return self._plan(asked.letter, banned)

    def allowed(self, letter: str, banned: Collection[int] = ()) -> list[int]:
        """The equations with which a letter may be planned, definitions and rules among them, without some."""
        barred, laws = self.retired | self.stepwise.foreign(letter) | set(banned), ("", *self.families)
        meaning = self.definitions.formula(letter) or Symbol(letter)
        barred |= later_on(meaning, self.scene.configuration, self.planner.pool)
        return [index for index, law in enumerate(self.planner.pool) if index not in barred and law.family in laws]

    def accept(self, answered: Answered, plan: Plan) -> None:
        """Take over an answer that the equations of a plan confirm."""
        letter = answered.asked.letter
        self.solver.solved[letter] = answered.found
        self.known.add(letter)
        self.answered.append(replace(answered, used=plan.equations, steps=(0, 0)))
        self.retired |= self.definitions.spent(answered.asked, ())

    def take_back(self, answered: Answered) -> None:
        """Forget an answer that is none to its question."""
        self.answered.remove(answered)
        self.solver.solved.pop(answered.asked.letter, None)
        self.known.discard(answered.asked.letter)

    def step(self, letter: str) -> Found:
        """Settle a letter on the way to an answer, with a derivation of its own."""
        asked = asked_letter(letter)
        found, used, own = self._settle(asked)
        self.answered.append(Answered(asked, found, used, (own, len(self.solver.steps)), aside=True))
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

    def _settle(self, asked: Asked) -> tuple[Found, tuple[int, ...], int]:
        """In closed form by some plan, also behind a letter that is settled first, else numerically; with the place of its first step."""
        self._settle_first(asked)
        own = len(self.solver.steps)
        try:
            return *self._attempt(asked), own
        except NoAnswer as error:
            if self.confirming or error.equation is not None:
                raise
            failed = error
        from rotsolve.search.stones import Stones

        stones = Stones(self, asked)
        stone = stones.in_closed_form(failed.met)
        if stone is None and stones.clashes and not failed.open_form:
            raise NoAnswer("the data contradict each other", None, stones.clashes[0]) from None
        if not stones.asked_for:  # what follows from a rate might be told by another root than that of the rate
            stone = stone or stones.by_number()
        if stone is None and failed.open_form:
            try:
                return *self._attempt_by_number(asked), own
            except NoAnswer as error:
                failed = error
        stone = stone or stones.by_number()
        if stone is None:
            raise failed
        self.step(stone)
        own = len(self.solver.steps)
        return *self._attempt(asked), own

    def _attempt_by_number(self, asked: Asked) -> tuple[Found, tuple[int, ...]]:
        """Plan and solve, where numbers may tell the root of the last equation."""
        self.solver.numeric = True
        try:
            return self._attempt(asked)
        finally:
            self.solver.numeric = False

    def _settle_first(self, asked: Asked) -> None:
        """Settle the letters that are worked out by themselves (`Law.apart`, and rates with roots of their own), of those with which a
        question is planned."""
        told = (law.left.name for law in self.planner.pool if law.law.apart and isinstance(law.left, Symbol))
        components = of_kinds(self.scene.registry.quantities, (COMPONENT,))
        apart = {*told, *self.scene.settled_first(), *components} - self.known - self.settling - {asked.letter}
        plan = self._plan(asked.letter, set()) if apart and not self.confirming else None
        if isinstance(plan, Plan):
            self.settling.add(asked.letter)
            for letter in plan.unknowns:
                if letter in apart and letter not in self.known:
                    with suppress(NoAnswer):
                        self.step(letter)
            self.settling.discard(asked.letter)

    def _attempt(self, asked: Asked) -> tuple[Found, tuple[int, ...]]:
        """Plan and solve; what has failed with the same equations and the same answers before fails again."""
        state = (asked.letter, self.families, len(self.planner.pool), frozenset(self.known), frozenset(self.retired))
        key = (*state, len(self.solver.solved), self.solver.numeric)
        if key in self.failed:
            raise self.failed[key].with_traceback(None)
        try:
            return self._attempted(asked)
        except NoAnswer as error:
            self.failed[key] = error
            raise

    def _attempted(self, asked: Asked) -> tuple[Found, tuple[int, ...]]:
        """Plan and solve; an equation that says nothing new is left out and the plan made again."""
        banned: set[int] = set()
        met: dict[str, None] = {}  # the unknowns of plans that did not do
        problem: ValueError | None = None
        rooted = False  # whether some plan ended in one equation, of which numbers may tell the root
        open_: Shortage | None = None
        for _ in range(FEW_TRIES if self.confirming else TRIES):
            plan = self._plan(asked.letter, banned)
            if isinstance(plan, Shortage) or open_ is None:
                open_ = Shortage(plan.asked, plan.equations, plan.unknowns)
            if isinstance(plan, Shortage):
                if problem is not None:
                    break
                raise NoAnswer("too little is known", plan)
            met.update(dict.fromkeys(plan.unknowns))
            if isinstance(problem, NoRealValue) and sums(
                plan, self.planner
            ):  # what no moment allows, no sum over a phase does
                break
            try:
                found = self.solver.solve(plan)
            except NumbersWanted as error:
                raise NoAnswer(str(error), open_form=True) from None
            except (Redundant, Contradiction) as error:
                banned.add(error.index)
                problem = error if problem is None or isinstance(error, Contradiction) else problem
                continue
            except (NoClosedForm, Undefined) as error:
                banned.add(self._hardest(plan))
                problem, rooted = problem or error, rooted or str(error) != ENTANGLED
                continue
            self.remember()
            return found, plan.equations
        if isinstance(problem, Contradiction):
            raise NoAnswer("the data contradict each other", None, problem.index)
        open_form = isinstance(problem, (NoClosedForm, Undefined))
        words = str(problem) if open_form else "too little is known"
        from rotsolve.search.stones import ranked

        raise NoAnswer(words, open_, open_form=open_form and rooted, met=ranked(met, asked.letter))

    def _hardest(self, plan: Plan) -> int:
        """The equation of a plan to do without: one of several that say the same, one with roots or bars round unknowns, the dearest."""
        pool = self.planner.pool
        steady: dict[tuple[object, ...], list[int]] = {}
        for index in plan.equations:
            if pool[index].law.steady:
                steady.setdefault((pool[index].law.steady, pool[index].section, pool[index].bodies), []).append(index)
        repeated = [index for same in steady.values() if len(same) > INDEPENDENT for index in same]
        return max(repeated or plan.equations, key=lambda index: (has_calls(pool[index]), pool[index].cost))

    @staged("plan")
    def _plan(self, letter: str, banned: set[int]) -> Plan | Shortage:
        """The plan that the question's own steps make, else the cheapest one by the laws chosen."""
        stepwise = self.stepwise.plan(letter, self.known, self.definitions.places.get(letter), banned)
        if stepwise is not None:
            return stepwise
        momentary, allowed = self._of_one_moment(letter), self.allowed(letter, banned)
        found = self._found_before(letter)
        if found is not None and found in allowed:
            return Plan(letter, (found,), (letter,), self.planner.pool[found].cost)
        return LawChoice(
            self.planner, letter, momentary, self.known, self.families, self.spare, allowed, self.forces_asked
        ).best()

    def _found_before(self, letter: str) -> int | None:
        """What was found for a letter on the way to another answer, where that is short and in what is known."""
        index = self.found_for.get(letter)
        right = ZERO if index is None else self.planner.pool[index].right
        return index if right.symbols() <= self.known and length(right) <= SHORT else None

    def _of_one_moment(self, letter: str) -> bool:
        """Whether a letter is an acceleration or a force, or made of such, so that Newton's laws of that moment tell it."""
        quantities = self.scene.registry.quantities
        meaning = self.definitions.formula(letter)
        names = {letter} if meaning is None else meaning.symbols() & quantities.keys()
        return bool(names) and all(name in quantities and quantities[name].kind in OF_ONE_MOMENT for name in names)

    def remember(self) -> None:
        """Results found on the way may serve the next question."""
        for equation, ref in self.solver.derived:
            index = self.planner.extend(equation)
            self.refs[index] = ref
            if isinstance(equation.left, Symbol):
                self.found_for[equation.left.name] = index
        self.solver.derived.clear()
        self.known |= {name for name, found in self.solver.solved.items() if found.number is not None}

    def number(self, value: Formula) -> float | None:
        """A rough value; None where it is not real or a given has no number."""
        return self.numbers.of(value)

    def aside(self, letter: str) -> Formula | None:
        """A letter by Newton's laws alone, without a trace in this search; None of one that is being told, which hangs on itself."""
        assert self.ground is not None
        if letter in self.ground.working_out:
            return None
        self.ground.working_out.add(letter)
        try:
            return self.beside_by((NEWTON,)).value_of(letter)
        except NoAnswer:
            return None
        finally:
            self.ground.working_out.discard(letter)

    def apart(self, *, careful: bool = False) -> Search:
        """A search by all laws that knows the answers of this one, and the rates on the way to them, and leaves no trace in it."""
        other = Search(self.scene, families_for(None), careful=careful or self.careful, ground=self.ground)
        other.solver.solved.update(self.solver.solved)
        for name in of_kinds(
            self.solver.told.keys() - self.solver.solved.keys(), RATES
        ):  # no other root of theirs is meant
            value = self.solver.with_found(Symbol(name))
            if not has_quantities(value):
                other.solver.solved[name] = Found(name, value)
        other.known |= other.solver.solved.keys()
        return other

    def certified(self, value: Formula) -> Certified | None:
        """The number of a formula with every letter of the laws worked out, without a derivation; None where one is not settled."""
        try:
            found = {name: self.answer(asked_letter(name)).found for name in sorted(value.symbols()) if is_key(name)}
            closed = {name: one.formula for name, one in found.items() if one.formula is not None}
            numbers = {name: one.number for name, one in self.solver.solved.items() if one.number is not None}
            return evaluate(value.substitute(closed), self.values, roots=numbers)
        except (NoAnswer, Undefined):
            return None

    def settled(self, value: Formula) -> Formula | None:
        """A formula with every letter of the laws worked out, without a derivation; None where one is not settled."""
        for name in filter(is_key, sorted(value.symbols())):
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
        return self.answer(asked_letter(letter)).found.formula


def is_unreal(value: Formula, search: Search) -> bool:
    """Whether the root of a number that is certainly negative stands in a formula, of which all letters have numbers."""
    if not value.holds("sqrt", "log", "asin", "acos"):
        return False
    roots = {name: found.number for name, found in search.solver.solved.items() if found.number is not None}
    if set(search.signs.lacking(value)) - roots.keys():
        return False
    return any(search.signs.negative(gap, roots) for gap in real_where(value))


def whole_turns(root: Formula, search: Search) -> int:
    """By how many turns an angle that an inverse function tells lies off −180° to 180°, as far as numbers tell it."""
    if not root.holds("asin", "acos", "atan", "atan2") or search.numbers.of(root) is None:
        return 0
    return 1 if search.numbers.side(root + PI) == -1 else -1 if search.numbers.side(root - PI) == 1 else 0


def asked_letter(letter: str) -> Asked:
    """A letter of the laws as a question."""
    return Asked(Find(letter, Symbol(letter), ()), Symbol(letter), letter, None)


def places_and_speeds(passages: Iterable[Passage]) -> set[str]:
    """The letters of places and speeds that run through a phase, where forces vary with them."""
    travels = [travel for passage in passages for travel in passage.travels]
    letters = [travel.coordinate for travel in travels if travel.pace == POSITION]
    letters += [travel.moving for travel in travels if travel.leads and travel.pace == RATE]
    return {letter.name for letter in letters if isinstance(letter, Symbol) and key_of(letter.name).running}
