"""Scene: a problem in which mistakes are made: its part that is asked for, its facts, and its answers, right and with a mistake.

A mistake is never named on a right answer: only what of an answer differs from the right one counts.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from fractions import Fraction
from functools import cached_property
from types import MappingProxyType

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.certified.ball import Certified, evaluate, pass_on
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.effort import Exhausted, at_most
from rotsolve.algebra.exact.normal import equal
from rotsolve.algebra.formula import ONE, Call, Formula, Integral, Number
from rotsolve.core.derivation import Answer
from rotsolve.core.equation import ABOUT_CONTACT, Equation
from rotsolve.core.facts import BodyFacts, Facts
from rotsolve.core.passage import Alteration
from rotsolve.core.remembered import remembered
from rotsolve.equations.scene_equations import SceneEquations
from rotsolve.grading.comparing.numbers import certified_number
from rotsolve.grading.mistakes.attempt import NO_ANSWER, Attempt, Route, answers_of
from rotsolve.grading.mistakes.mistake import Change, Mistake
from rotsolve.language.problem import Problem
from rotsolve.motion.configuration import Configuration
from rotsolve.motion.positive import positive_letters
from rotsolve.pipeline import asked_part
from rotsolve.search.acting import acting_forward
from rotsolve.search.friction import decide
from rotsolve.search.letterspace import Point, at_point, numbers_of
from rotsolve.search.planning import families_for
from rotsolve.search.search import Search
from rotsolve.solving import scene_equations_of

ROUTE_STEPS = 1000  # of work for the right answers by some laws
NEARLY = 1e-9  # relative: numbers closer than this are not told apart
DIGITS = 10  # to which a difference of two forms is worked out


class Scene(Struct, frozen=True, dict=True):
    """A problem that has been read, with all that its mistakes have in common worked out once.

    Where letters decide what slips, or which way, mistakes are made in the case that the numbers of a `point` are of.
    """

    whole: Problem
    point: Point = MappingProxyType({})

    @cached_property
    def configuration(self) -> Configuration:
        own = asked_part(self.whole)
        return Configuration(at_point(own.problem, numbers_of(self.point))) if self.point else own

    @property
    def problem(self) -> Problem:
        """The part that is asked for, with letters for what the scene leaves out."""
        return self.configuration.problem

    @cached_property
    def modes(self) -> Mapping[str, str]:
        """What slips, and which way."""
        return modes_of(self.configuration)

    @cached_property
    def _as_counted(self) -> Route:
        """How the right answers are found with each friction drawn against the way in which its body is counted."""
        return Route.by(equations_by(self.configuration, self.modes), families_for(None))

    @cached_property
    def forward(self) -> frozenset[str]:
        """The frictions that are drawn the other way, since they are known to act so: as they are where the scene is solved."""
        return frozenset() if self.problem.space else acting_forward(self._as_counted.search)

    @cached_property
    def equations(self) -> SceneEquations:
        if not self.forward:
            return self._as_counted.search.scene
        return equations_by(replace(self.configuration, forward=self.forward), self.modes)

    @cached_property
    def moments(self) -> tuple[Facts, ...]:
        """The facts at all states."""
        return tuple(self.equations.facts(state.name) for state in self.configuration.timeline.states)

    @cached_property
    def settled(self) -> bool:
        """Whether it is known what slips, and which way: else nothing can be said of mistakes."""
        try:
            return bool(self.moments) or self.problem.space
        except NO_ANSWER:
            return False

    @cached_property
    def bodies(self) -> Mapping[str, BodyFacts]:
        """The facts of each body by its name, at the first state at which it is there."""
        found: dict[str, BodyFacts] = {}
        for body in (body for facts in self.moments for body in facts.bodies):
            found.setdefault(body.name, body)
        return found

    @cached_property
    def answers(self) -> Mapping[str, Answer]:
        """The right answers by name."""
        return answers_of(self._right.search)

    def with_mistake(self, mistake: Mistake) -> Mapping[str, Answer] | None:
        """The answers that the mistake changes; None where it changes none, or the scene has no answer then."""
        return self.changed_by(self.attempt(mistake.change))

    def changed_by(self, attempt: Attempt | Rereading) -> Mapping[str, Answer] | None:
        """The answers of the scene with something changed in it, as far as they are not right; None where all are, or there are none."""
        try:
            given = attempt.answers()
        except NO_ANSWER:
            return None
        return self._wrong(given, self.answers, self.problem.values)

    def told(self, attempt: Attempt | Rereading, name: str) -> Answer | None:
        """An answer of the scene with something changed in it, right or not, before all its laws are held together."""
        try:
            return attempt.answer(name) if name in self.answers else None
        except NO_ANSWER:
            return None

    def with_values(
        self, mistake: Mistake, answers: Mapping[str, Answer], values: Mapping[str, Formula]
    ) -> Mapping[str, Answer] | None:
        """The answers that a mistake changes, from those for the numbers of the scene, for other numbers; nothing is solved again."""
        if mistake.change.reread:
            given = self._reread(mistake.change, values).answers()
        else:
            given = {name: reread(one, {}, values) for name, one in answers.items()}
        return self._wrong(given, self._reread(Change(), values).answers(), values)

    def _wrong(
        self, given: Mapping[str, Answer], right: Mapping[str, Answer], values: Mapping[str, Formula]
    ) -> Mapping[str, Answer] | None:
        """Those of some answers that are not right, as far as they are not; None where all are."""
        differing = Differing(frozenset(positive_letters(self.problem.givens)), values)
        pairs = ((name, differing.left_of(one, right[name])) for name, one in given.items() if name in right)
        return {name: wrong for name, wrong in pairs if wrong is not None} or None

    @cached_property
    def _right(self) -> Route:
        """How the right answers are found."""
        return Route.by(self.equations, families_for(None)) if self.forward else self._as_counted

    @remembered
    def route(self, families: tuple[str, ...]) -> Route | None:
        """How they are found by some laws; None where that takes too long. No mistake pays for it, since several go by it."""
        if families == families_for(None):
            return self._right
        try:
            with at_most(ROUTE_STEPS):
                return Route.by(self.equations, families, confirming=True)
        except Exhausted:
            return None

    def _reread(self, change: Change, values: Mapping[str, Formula]) -> Rereading:
        """The right answers with other letters and numbers in them."""
        wrong = {name: values[name] * factor for name, factor in change.factors.items() if name in values}
        return Rereading(self.answers, change.letters, {**values, **wrong})

    def attempt(self, change: Change) -> Attempt | Rereading:
        """What answers the scene with a change in it; right answers are among its own."""
        try:
            return self._reread(change, self.problem.values) if change.reread else self._solving(change)
        except NO_ANSWER:
            return Rereading({})

    def _solving(self, change: Change) -> Attempt | Rereading:
        """What solves the scene with a change in it; nothing where that changes no answer."""
        problem = self.problem if change.problem is None else change.problem(self.problem)
        altered = change.altered if change.altered is None or change.about_contact else about_centres(change.altered)
        configuration = Configuration(problem, altered, self.forward)
        families = tuple(family for family in families_for(None) if family not in change.aside)
        if change.problem is None and altered is not None and not problem.space:
            equations = self.equations.rewritten_by(configuration)
        else:
            equations = equations_by(configuration, self.modes if change.problem is None else modes_of(configuration))
        route = self.route(families) if change.problem is None else None
        if route is not None and route.passes_by(equations):
            pass_on(route.witness)
            return Rereading({})
        return Attempt(Search(equations, families, confirming=True), throughout=change.throughout)


def about_centres(altered: Alteration) -> Alteration:
    """Other facts and equations, without the laws about points of contact."""

    def changed(equation: Equation) -> Equation | None:
        if equation.law == ABOUT_CONTACT:
            return None
        return equation if altered.equation is None else altered.equation(equation)

    return replace(altered, equation=changed)


def modes_of(configuration: Configuration) -> Mapping[str, str]:
    """What slips, and which way; in space nothing does."""
    return {} if configuration.problem.space else decide(configuration).modes


def equations_by(configuration: Configuration, modes: Mapping[str, str]) -> SceneEquations:
    """What the laws say of a scene, with what slips."""
    return scene_equations_of(configuration) if configuration.problem.space else SceneEquations(configuration, modes)


# answers


class Rereading(Struct, frozen=True):
    """Answers with something else written for letters, and with other numbers."""

    right: Mapping[str, Answer]
    letters: Mapping[str, Formula] = MappingProxyType({})
    values: Mapping[str, Formula] = MappingProxyType({})

    def answer(self, name: str) -> Answer | None:
        return reread(self.right[name], self.letters, self.values) if name in self.right else None

    def answers(self) -> Mapping[str, Answer]:
        return {name: reread(one, self.letters, self.values) for name, one in self.right.items()}


def reread(answer: Answer, letters: Mapping[str, Formula], values: Mapping[str, Formula]) -> Answer:
    """An answer with something else written for letters, and with other numbers; without one where it has no closed form."""
    closed = None if answer.closed is None else answer.closed.substitute(letters)
    value = None
    if closed is not None:
        size = Call("abs", (closed,)) if answer.components else closed  # of a vector, whatever its letters come to
        value = certified_number(size if answer.unit is None else size / answer.unit.factor, values)
    parts = tuple(reread(part, letters, values) for part in answer.components)
    return replace(answer, formula=closed, closed=closed, value=value, components=parts, remark=(), angle=None)


class Differing(Struct, frozen=True):
    """Compares answers of a scene, by the letters that are positive and the numbers of its givens."""

    positive: frozenset[str]
    values: Mapping[str, Formula]

    def left_of(self, wrong: Answer, right: Answer) -> Answer | None:
        """The wrong answer without its form where that is the right one, without its number where that is; None where nothing is left."""
        parts = {part.name: part for part in right.components}
        pairs = ((part, parts.get(part.name)) for part in wrong.components)
        apart = any(twin is not None and self.left_of(part, twin) is not None for part, twin in pairs)
        form = wrong.closed if wrong.closed is not None and self.differ(wrong.closed, right.closed) else None
        value = wrong.value if wrong.value is not None and not same_number(wrong.value, right.value) else None
        word = wrong.word if wrong.word != right.word else ""
        if form is None and value is None and not word and not apart:
            return None
        formula, components = (None if form is None else wrong.formula), wrong.components if apart else ()
        return replace(wrong, formula=formula, closed=form, value=value, word=word, components=components)

    def differ(self, wrong: Formula, right: Formula | None) -> bool:
        """Whether two closed forms are certainly not the same: a ball round their difference holds no 0.

        Integrals are told apart by their numbers alone.
        """
        if wrong.holds(Integral):
            return False
        if right is None:
            return True
        if wrong == right:
            return False
        try:
            if equal(wrong, right, self.positive):
                return False
        except ArithmeticError:
            return False
        return any(certainly_apart(wrong - right, values) for values in self.points(wrong.symbols() | right.symbols()))

    def points(self, letters: frozenset[str]) -> Iterator[dict[str, Formula]]:
        """Numbers for letters: near those of the scene, where nothing agrees by chance, then those of the scene."""
        own = {name: self.values.get(name, ONE) for name in sorted(letters | self.values.keys())}
        yield {name: value * Number(Fraction(97 + 2 * place, 100)) for place, (name, value) in enumerate(own.items())}
        yield own


def certainly_apart(difference: Formula, values: Mapping[str, Formula]) -> bool:
    """Whether a difference is certainly not 0 at some numbers."""
    try:
        return bool(evaluate(difference, values, digits=DIGITS, max_precision=1000).sign)
    except (Undefined, ArithmeticError):
        return False


def same_number(wrong: Certified, right: Certified | None) -> bool:
    """Whether two numbers are equal, or so close that no student tells them apart."""
    if right is None:
        return False
    return bool(abs(wrong.ball - right.ball) <= NEARLY * abs(right.ball)) or wrong.ball.overlaps(right.ball)


def same_answers(some: Mapping[str, Answer], others: Mapping[str, Answer]) -> bool:
    """Whether two mistakes give the same answers: the same forms as they are written, and the same numbers."""
    return some.keys() == others.keys() and all(same_answer(one, others[name]) for name, one in some.items())


def same_answer(one: Answer, other: Answer) -> bool:
    """Whether two answers have the same form and number, part by part."""
    if one.closed != other.closed or one.word != other.word or len(one.components) != len(other.components):
        return False
    if (one.value is None) != (other.value is None):
        return False
    number = one.value is None or same_number(one.value, other.value)
    return number and all(same_answer(part, twin) for part, twin in zip(one.components, other.components, strict=True))
