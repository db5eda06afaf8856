"""Working: a problem solved once in symbols, and what it answers for other values of its givens.

Its formulas hold for every variant in which all numbers that were asked for on the way have the signs that they had then. Other signs
are another branch, which is solved once more; so is a first variant of each branch, as a probe. Where numbers decided more than signs
tell (which of two roots is nearer, whole turns), each variant is solved anew.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from msgspec import Struct
from msgspec.structs import replace

from rotsolve.algebra.certified.ball import Certified, evaluate, witnessed
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.certified.sign import SignOracle
from rotsolve.algebra.formula import PI, Call, Formula
from rotsolve.algebra.units.quantities import parse_quantity
from rotsolve.confirm.verdicts import against, confirmations
from rotsolve.core.derivation import Answer, Derivation
from rotsolve.core.faults import SceneError, Unsolvable
from rotsolve.core.symbols import TIME
from rotsolve.derivation.requirements import ROOT, SLIPS
from rotsolve.language.problem import Given, Problem
from rotsolve.page.values import certified_digits
from rotsolve.pipeline import made_ready, solve_problem
from rotsolve.scene.read import read_tree
from rotsolve.scene.tree import Map, Node, compose
from rotsolve.solution import Solution

Values = Mapping[str, Formula]
ASIDE = ("answers", "marking", "vary")  # sections that only graders read
MOST = 20  # branches that are kept
PROBE = 10  # significant digits in which a formula and a new solution have to agree


class Unsuited(ValueError):
    """Values for which a scene has no answer, or one that its own checks object to; says why."""


class Worked(Struct, frozen=True):
    """A problem with the values of one variant, and its answers; `like` has their formulas, `solution` where it was solved anew."""

    problem: Problem
    answers: tuple[Answer, ...]
    told: frozenset[str]  # the givens that its derivation speaks of
    like: Solution
    solution: Solution | None = None

    def shown(self) -> tuple[Given, ...]:
        """The givens that its derivation speaks of, with these values."""
        return tuple(given for given in self.problem.givens if given.name in self.told)

    def derivation(self) -> Derivation:
        """The derivation with these values."""
        return (self.solution or solve_problem(self.problem, confirm=False).complete()).derivation


class Branch:
    """One solution in symbols, and the signs of the numbers with which it was found."""

    def __init__(self, problem: Problem) -> None:
        with witnessed() as witness:
            self.solution = solve_problem(problem, confirm=False).complete()
        valid = self.solution.trace.validity() if self.solution.trace.validity is not None else None
        self.bounds = valid.bounds if valid is not None else ()
        asked = [item for item in witness.asked if item.symbols() and item not in self.bounds]
        self.signs = signs_of(asked, problem)
        self.probed = False
        derivation = self.solution.derivation
        self.trusted = (
            valid is not None
            and set(valid.decided) <= {SLIPS, ROOT}  # by signs, unless the witness knows better
            and not witness.by_size
            and not any(TIME in item.symbols() for item in asked)
            and all(check.holds for check in derivation.checks)
            and None not in [revalued(answer, problem.values) for answer in derivation.answers]
        )

    def evaluated(self, problem: Problem) -> tuple[Answer, ...] | None:
        """The answers by their formulas; None where the numbers may decide otherwise than they did. Unsuited where a bound is broken."""
        values = problem.values
        if not self.trusted or any(sign_at(item, values) != sign for item, sign in self.signs.items()):
            return None
        if any(sign_at(bound, values) < 0 for bound in self.bounds):
            raise Unsuited("a string would go slack, or a contact open or slip")
        found = [revalued(answer, values) for answer in self.solution.derivation.answers]
        answers = tuple(answer for answer in found if answer is not None)
        return answers if len(answers) == len(found) else None

    def probe(self, answers: tuple[Answer, ...], worked: Worked) -> None:
        """Trust the formulas no more where a new solution with the same signs says something else."""
        self.probed = True
        self.trusted = all(answers_agree(*pair) for pair in zip(answers, worked.answers, strict=True))


class VariantReader:
    """One file read for many settings: only the givens change, as long as the limits of its values hold as they did."""

    def __init__(self, problem: Problem) -> None:
        self.problem = problem
        self.tree = scene_of(problem)
        with witnessed() as witness:
            read_tree(self.tree, problem.lines, problem.file)
        self.signs = signs_of(witness.asked, problem)
        self.by_size = witness.by_size

    def read(self, settings: Mapping[str, str]) -> Problem:
        """The problem with these settings; Unsuited where the reader refuses them."""
        if not self.by_size:
            givens = tuple(with_value(given, settings.get(given.name)) for given in self.problem.givens)
            problem = replace(self.problem, givens=givens)
            values = problem.values
            if all(sign_at(item, values) == sign for item, sign in self.signs.items()):
                return problem
        try:
            return read_tree(self.tree, self.problem.lines, self.problem.file, settings)
        except SceneError as error:
            raise Unsuited(error.faults[0].message) from None


def with_value(given: Given, text: str | None) -> Given:
    """A given with another value, as a scene writes it."""
    if text is None:
        return given
    quantity = parse_quantity(text)
    return replace(given, value=quantity.value, unit=quantity.unit, text=text)


def scene_of(problem: Problem) -> Node:
    """The tree of a problem's file without what its answers do not depend on."""
    root, _ = compose("\n".join(problem.lines), problem.file)
    if not isinstance(root, Map):
        return root
    return Map(tuple(entry for entry in root.entries if entry[0].value not in ASIDE), root.span)


class VariantSolver:
    """Answers one problem for many settings of its givens."""

    def __init__(self, problem: Problem) -> None:
        self.problem = problem
        self.reading = VariantReader(problem)
        self.branches = [Branch(problem)]

    def work(self, settings: Mapping[str, str]) -> Worked:
        """The problem with these settings; Unsuited where it can not be used so, or an assembly of all bodies' equations contradicts it."""
        worked = self.answered(settings)
        hold_against_assembly(worked)
        return worked

    def answered(self, settings: Mapping[str, str]) -> Worked:
        """The problem with these settings by the formulas of its branch, or solved anew."""
        if not settings:
            return worked_anew(self.problem, self.branches[0].solution)
        problem = self.reading.read(settings)
        for branch in self.branches:
            answers = branch.evaluated(problem)
            if answers is not None and branch.probed:
                return Worked(problem, answers, told_givens(branch.solution), branch.solution)
            if answers is not None:
                worked = worked_anew(problem, self.found(problem).solution)
                branch.probe(answers, worked)
                return worked
        branch = self.found(problem)
        if branch.trusted and len(self.branches) < MOST:
            self.branches.append(branch)
        return worked_anew(problem, branch.solution)

    def found(self, problem: Problem) -> Branch:
        """A new solution; Unsuited where there is none."""
        try:
            return Branch(problem)
        except Unsolvable as error:
            raise Unsuited(error.fault.message) from None
        except SceneError as error:
            raise Unsuited(error.faults[0].message) from None


def worked_anew(problem: Problem, solution: Solution) -> Worked:
    """What a new solution says, unless a check objects."""
    if any(check.holds is False for check in solution.derivation.checks):
        raise Unsuited("a check objects to its answers")
    return Worked(problem, solution.derivation.answers, told_givens(solution), solution, solution)


def hold_against_assembly(worked: Worked) -> None:
    """Unsuited where an assembly of all bodies' equations contradicts an answer: formulas are right only for what they were made."""
    whole = made_ready(worked.problem)[0].problem
    for verdict in confirmations(worked.answers, whole, worked.like.trace.letter, lambda _: True):
        if verdict.holds is False:
            raise Unsuited(against(verdict))


def told_givens(solution: Solution) -> frozenset[str]:
    """The givens that the derivation speaks of."""
    return frozenset(given.name for given in solution.derivation.givens)


def sign_at(value: Formula, values: Values) -> int:
    """The sign of a formula, 0 where nothing tells it from 0 or it has no number."""
    return SignOracle(values).by_numbers(value) or 0


def signs_of(asked: Iterable[Formula], problem: Problem) -> dict[Formula, int]:
    """The signs of what has a number for the values of a problem."""
    return {item: sign_at(item, problem.values) for item in asked if item.symbols() <= problem.values.keys()}


def revalued(answer: Answer, values: Values) -> Answer | None:
    """An answer with the number that its closed form has for other values; None where that does not tell all that it says."""
    components = [revalued(part, values) for part in answer.components]
    parts = tuple(part for part in components if part is not None)
    if answer.word or len(parts) < len(components):
        return None
    if answer.rows:
        return replace(answer, components=parts)
    if answer.closed is None or answer.value is None:
        return None
    factor = answer.unit.factor if answer.unit is not None else None
    value = number_at(answer.closed / factor if factor is not None else answer.closed, values)
    if value is None or value.sign is None or value.sign != answer.value.sign:
        return None
    angle = angle_to_horizontal(parts, values) if answer.angle is not None else None
    if (angle is None) != (answer.angle is None):
        return None
    return replace(answer, value=value, components=parts, angle=angle)


def number_at(value: Formula, values: Values) -> Certified | None:
    try:
        return evaluate(value, values)
    except (Undefined, ValueError, ZeroDivisionError):
        return None


def angle_to_horizontal(parts: Sequence[Answer], values: Values) -> Certified | None:
    """The angle of a slanted vector to the horizontal, in degrees: tan φ = |y|/|x|."""
    x, y = (part.closed for part in parts) if len(parts) == 2 else (None, None)
    return None if x is None or y is None else number_at(Call("atan", (Call("abs", (y / x,)),)) * 180 / PI, values)


def answers_agree(one: Answer, other: Answer) -> bool:
    """Whether two answers say the same."""
    words = [(item.name, item.direction, item.word, len(item.components)) for item in (one, other)]
    numbers = [(certified_digits(item.value, PROBE), certified_digits(item.angle, PROBE)) for item in (one, other)]
    if words[0] != words[1] or numbers[0] != numbers[1]:
        return False
    return all(answers_agree(*pair) for pair in zip(one.components, other.components, strict=True))
