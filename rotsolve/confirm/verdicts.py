"""Verdicts: what answers say in numbers, what an assembly says of them, and what becomes of those that it contradicts.

An assembly of the plane and one of space hold answers against all bodies' equations (confirm/course/verdict, confirm/space/verdict).
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction

from msgspec.structs import replace

from rotsolve.algebra.formula import Formula, Number
from rotsolve.algebra.notation.letters import name_to_text
from rotsolve.algebra.units.dimension import ANGLE
from rotsolve.confirm import NotConfirmed
from rotsolve.confirm.course.samples import Numbers
from rotsolve.confirm.course.sizes import letters_open
from rotsolve.confirm.numbers import value_of
from rotsolve.core.derivation import Answer, AnswerConfirmation, Check, Derivation, Refusal, in_a_row
from rotsolve.core.faults import Fault, Unsolvable
from rotsolve.core.limits import Limit
from rotsolve.language.problem import Problem

ASSEMBLED = "all bodies' equations, solved with numbers, give the same "
SUMMED = "another sum over the masses gives the same "
TOLD_BY_MASSES = (
    "inertia_tensor",
    "inertia",
    "principal_moments",
    "principal_axis",
    "mass",
    "cm",
)  # what needs no laws
SAME = 2e-6  # of the size of what is compared: the assembly's rounding, and that of its steps
NEARLY = "approximation:"
AGAINST = "against its positive sense:"
CLOSELY = 2000  # bits to which a formula is reckoned where floats may have lost its digits
OTHERWISE = "an assembly of all bodies' equations gives another value"
NO_CASE = "no numbers were found for its case"
NO_NUMBER = "it has no real value there, and has one by an assembly of all bodies' equations"
WAYS = "`--show confirm` prints both values; `--no-confirm` leaves the confirmation out"
Solved = Callable[[str], "Formula | float | None"] | None


def confirmations(
    answers: Sequence[Answer],
    problem: Problem,
    solved: Solved,
    admitted: Callable[[Numbers], bool],
    points: Sequence[Mapping[str, Fraction]] = (),
    limits: Callable[[], Iterable[Limit]] = tuple,
    others: Callable[[str], tuple[Formula, ...]] = lambda _: (),
) -> tuple[AnswerConfirmation, ...]:
    """What the assembly says of each answer; `admitted` says whether a scene may have such numbers, and is asked before they object; the
    plane's `limits` tell most of that at once, and `others` are other roots for a letter that is settled on the way.

    Cases of letters to which no set belongs that was drawn are tried at the `points` at which they were found, and near their edges.
    """
    if problem.space:
        from rotsolve.confirm.space.verdict import confirmations_in_space

        return confirmations_in_space(answers, problem, solved, admitted, points, others)
    from rotsolve.confirm.course.verdict import confirmations_in_plane

    return confirmations_in_plane(answers, problem, solved, admitted, points, limits, others)


def confirmed_at(answers: Sequence[Answer], problem: Problem, solved: Solved, numbers: Numbers) -> tuple[str, ...]:
    """The answers that an assembly gives too at one set of numbers for the letters that have none."""
    if problem.space:
        from rotsolve.confirm.space.verdict import confirmed_in_space_at

        return confirmed_in_space_at(answers, problem, solved, numbers)
    from rotsolve.confirm.course.verdict import confirmed_in_plane_at

    return confirmed_in_plane_at(answers, problem, solved, numbers)


def judged_numbers(
    answers: Sequence[Answer],
    problem: Problem,
    solved: Solved,
    numbers: Numbers,
    sizes: Mapping[str, Mapping[str, float]],
) -> Iterator[AnswerConfirmation]:
    """What the assembly says of answers that come to these numbers, in SI units, at one set of numbers for the letters.

    A number stands under '', those of a vector under the names of its components.
    """
    known = {**numbers, **asked_letters(problem, numbers, solved)}
    told = [answer for answer in answers if answer.name in sizes]
    if problem.space:
        from rotsolve.confirm.space.verdict import judged_in_space

        yield from judged_in_space(told, problem, known, sizes, numbers)
        return
    from rotsolve.confirm.course.verdict import judged_in_plane

    yield from judged_in_plane(told, problem, known, sizes, numbers)


def names_of_mass(problem: Problem) -> set[str]:
    """The questions that the masses alone tell, however anything moves."""
    finds = () if problem.sought else problem.finds
    finds = tuple(find for find in finds if find.terms and find.where is None and find.choice is None)
    return {find.name for find in finds if all(term.path.quantity in TOLD_BY_MASSES for term in find.terms)}


def confirmed(derivation: Derivation, problem: Problem) -> Derivation:
    """The derivation with what was confirmed among its checks, and what was not; what is contradicted is refused.

    Unsolvable where nothing stands.
    """
    verdicts = derivation.confirmed
    letters = {answer.name: answer.symbol for answer in derivation.answers}
    of_mass = names_of_mass(problem)
    checks = []
    whole = all(item.holds for item in verdicts) and len(verdicts) == len(letters)
    for words, static in ((SUMMED, True), (ASSEMBLED, False)):
        good = [letters[item.name] for item in verdicts if item.holds and (item.name in of_mass) is static]
        checks += [Check((words, *in_a_row(good)), bare=whole)] if good else []
    checks += [Check((letters[one.name], one.also), None, AGAINST) for one in verdicts if one.holds and one.also]
    checks += [
        Check((letters[one.name], f" is {one.also}"), None, NEARLY)
        for one in verdicts
        if one.holds is None and one.also
    ]
    reasons: dict[str, list[Formula]] = {}
    for item in verdicts:
        if item.holds is None and not item.also:
            reasons.setdefault(item.why, []).append(letters[item.name])
    doubts = [Check((*in_a_row(names), f" ({why})"), None, "not confirmed:") for why, names in reasons.items()]
    if any(item.holds is False for item in verdicts):
        wrong = any(item.holds is False and not item.rivalled for item in verdicts)
        return withheld(replace(derivation, checks=(*checks, *(() if wrong else doubts))), problem)
    checks += doubts
    return replace(derivation, checks=(*derivation.checks, *checks))


def withheld(derivation: Derivation, problem: Problem) -> Derivation:
    """Only the answers that the assembly confirms, without the way to them, since that may lead through what is contradicted."""
    finds = {find.group: find for find in reversed(problem.finds)}
    refused = {}
    wrong = any(item.holds is False and not item.rivalled for item in derivation.confirmed)
    for item in derivation.confirmed:
        if item.holds is False or (wrong and not item.holds):
            refused[item.name] = Fault(against(item), finds[item.name].span, WAYS, "unsolvable")
    if len(refused) == len(derivation.confirmed):
        fault = next(refused[item.name] for item in derivation.confirmed if item.holds is False)
        names = ", ".join(f"`{item.name}`" for item in derivation.confirmed if item.holds is False)
        whys = [item.why for item in derivation.confirmed if item.holds is False and item.why not in ("", OTHERWISE)]
        message = f"not confirmed: an assembly of all bodies' equations contradicts {names}" + "".join(
            f": {why}" for why in whys[:1]
        )
        beside = [refused[item.name] for item in derivation.confirmed if item.holds is None]
        others = [*beside, *(item.fault for item in derivation.refused)]
        raise Unsolvable(message, span=fault.span, help=WAYS, lines=problem.lines, file=problem.file, others=others)
    answers = tuple(answer for answer in derivation.answers if answer.name not in refused)
    told = tuple(Refusal(name, fault) for name, fault in refused.items())
    return replace(
        derivation,
        answers=answers,
        sections=(),
        trials=(),
        insights=(),
        second=(),
        refused=(*derivation.refused, *told),
    )


def against(item: AnswerConfirmation) -> str:
    """Why an answer is withheld, where one of the scene is contradicted."""
    if item.holds is False:
        why = f": {item.why}" if item.why != OTHERWISE else ""
        return f"not confirmed: an assembly of all bodies' equations contradicts `{item.name}`{why}"
    return f"not confirmed: `{item.name}`, beside answers that an assembly of all bodies' equations contradicts ({item.why})"


def asked_letters(problem: Problem, numbers: Numbers, solved: Solved) -> dict[str, float]:
    """The letters that are asked for, by the answers; what hangs on others of them by these."""
    found: dict[str, float] = {}
    told = {given.name: solved(given.name) for given in problem.givens if given.asked and solved is not None}
    while told:
        before = len(found)
        for name, value in told.items():
            try:
                if value is not None:
                    known = {**numbers, **found}
                    found[name] = float(value_of(value, known) if isinstance(value, Formula) else value)
            except (NotConfirmed, ArithmeticError):
                continue
        told = {name: value for name, value in told.items() if name not in found}
        if len(found) == before:
            break
    return found


def said_of(
    answer: Answer, numbers: Numbers, reckon: Callable[[Formula, Numbers], float] = value_of
) -> dict[str, float | str]:
    """The numbers of an answer in SI units: '' for itself, else by the names of its parts; of a choice the word."""
    if answer.word:
        return {"": answer.word}
    said: dict[str, float | str] = {}
    number = number_of(answer, numbers, reckon)
    if number is not None:
        said[""] = number
    for part in answer.components:
        number = number_of(part, numbers, reckon)
        if number is not None:
            said[part.name.removeprefix(f"{answer.name}_")] = number
    return said


def closely_valued(formula: Formula, numbers: Numbers) -> float:
    """The value of a formula, closely wherever floats lose digits; ValueError where it has none."""
    from rotsolve.algebra.certified.ball import evaluate

    known = {name: Number(Fraction(str(numbers[name]))) for name in formula.symbols() & numbers.keys()}
    if formula.symbols() - known.keys():
        raise NotConfirmed("a letter has no number")
    return evaluate(formula, known, max_precision=CLOSELY).float


def number_of(answer: Answer, numbers: Numbers, reckon: Callable[[Formula, Numbers], float] = value_of) -> float | None:
    """The number of an answer, by its closed form where the scene has letters without numbers."""
    if answer.value is not None:
        factor = answer.unit.factor if answer.unit is not None else None
        return answer.value.float * (1.0 if factor is None else float(value_of(factor, {})))
    formula = answer.closed if answer.closed is not None else answer.formula
    if formula is None:
        return None
    try:
        return float(reckon(formula, numbers))
    except (NotConfirmed, ArithmeticError, ValueError):
        return None


def both_sets(before: AnswerConfirmation | None, now: AnswerConfirmation) -> AnswerConfirmation:
    """Of two sets of numbers: contradicted by one, else gone astray with one, the first, else confirmed by one; of an approximation how
    near it comes with the one of them for which it is meant sooner."""
    if before is None or speaks_for(now) > speaks_for(before):
        return now
    if before.also and before.holds is None and now.holds is None:
        return now if now.also and how_far(now) < how_far(before) else before
    return before if before.astray or speaks_for(now) < speaks_for(before) else now


def how_far(verdict: AnswerConfirmation) -> float:
    """The distance of an answer from what the assembly has, as a share of its size."""
    size = math.hypot(*verdict.answered)
    return math.dist(verdict.answered, verdict.found) / size if size else 0.0


def speaks_for(verdict: AnswerConfirmation) -> int:
    """How much a verdict about one set of numbers says of all."""
    return 3 if verdict.holds is False else 2 if verdict.astray else int(verdict.holds is True)


def not_so(name: str, why: str, problem: Problem, numbers: Numbers) -> AnswerConfirmation:
    """An answer that is wrong with these numbers; letters may have others, with which it holds."""
    letters = numbers_told(numbers, problem)
    if not letters:
        return AnswerConfirmation(name, False, why)
    return AnswerConfirmation(name, None, f"not so with {letters}: {why}", astray=True)


def numbers_told(numbers: Numbers, problem: Problem) -> str:
    """m = 0.806, R = 1.01 in SI units, θ = 57.9°: the letters that have no number in the scene; those that nobody wrote only where there
    are no others."""
    known = [given for given in letters_open(problem) if given.name in numbers]
    told = [given for given in known if not given.automatic] or known
    sizes = [f"{name_to_text(one.name)} = {numbers[one.name]:g}" for one in told if one.dimension != ANGLE]
    angles = [
        f"{name_to_text(one.name)} = {math.degrees(numbers[one.name]):.4g}°" for one in told if one.dimension == ANGLE
    ]
    return ", ".join([*([", ".join(sizes) + " in SI units"] if sizes else []), *angles])


def pairs(verdict: AnswerConfirmation) -> Iterator[tuple[float, float]]:
    """The numbers of an answer, each beside that of the assembly."""
    return zip(verdict.answered, verdict.found, strict=True)


def confirmation_lines(verdicts: Sequence[AnswerConfirmation]) -> str:
    """Each answer with the number that is answered and that of the assembly, in SI units: a stage that can be printed."""
    lines = []
    for item in verdicts:
        word = {True: "confirmed", False: "contradicted", None: "not confirmed"}[item.holds]
        lines.append(f"{item.name}: {word}" + (f": {item.why}" if item.why else ""))
        for answered, own in pairs(item):
            lines.append(f"  answered {answered:.10g}, assembly {own:.10g} (SI units)")
    return "\n".join(lines)
