"""Held: whether what a derivation prints is true: every equation at its answers, and every number against its closed form."""

from __future__ import annotations

from collections.abc import Iterator

from mpmath import mpf

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.derivation import Answer, Equality
from rotsolve.solution import Solution
from trials.evaluate import NEARLY, Unknown, value
from trials.figures import wrong
from trials.outcome import Printed

SUPPOSED = "Does "  # the title of a section that supposes what turns out not to be so


def faults(solution: Solution, printed: dict[str, Printed], digits: int) -> Iterator[str]:
    """Everything that a derivation says and that is not so."""
    letters = givens(solution)
    for answer in solution.derivation.answers:
        yield from misprinted(answer, answer.name, printed, letters, digits)
    sections = [section for section in solution.derivation.sections if not section.title.startswith(SUPPOSED)]
    for section in sections:
        for move in section.moves:
            learn(move.chain[-1], letters)
    for section in sections:
        for law in section.laws:
            yield from broken(law.equation, letters, f"({law.number}) {law.law}")
        for move in section.moves:
            for equality in move.chain:
                yield from broken(equality, letters, move.sources)


def givens(solution: Solution) -> dict[str, mpf]:
    """The numbers of the givens."""
    formulas = {given.name: given.value for given in solution.derivation.givens if given.value is not None}
    letters: dict[str, mpf] = {}
    for _ in formulas:
        for name in formulas.keys() - letters.keys():
            try:
                letters[name] = value(formulas[name], letters)
            except Unknown:
                continue
    return letters


def learn(equality: Equality, letters: dict[str, mpf]) -> None:
    """The value of the letter that a step isolates."""
    if isinstance(equality.left, Symbol) and equality.relation == "=" and equality.left.name not in letters:
        try:
            letters[equality.left.name] = value(equality.right, letters)
        except Unknown:
            return


def misprinted(
    answer: Answer, name: str, printed: dict[str, Printed], letters: dict[str, mpf], digits: int
) -> Iterator[str]:
    """An answer whose figures are not those of its closed form in its unit."""
    for part in answer.components:
        yield from misprinted(part, f"{name}.{part.name}", printed, letters, digits)
    if answer.formula is None or answer.value is None:
        return
    try:
        true = value(answer.formula, letters)
        unit = mpf(1) if answer.unit is None else value(answer.unit.factor, {})
    except Unknown:
        return
    fault = wrong(printed[name], true / unit, digits)
    if fault:
        yield f"{name} = {to_text(answer.formula)}: {fault}"


def broken(equality: Equality, letters: dict[str, mpf], where: str) -> Iterator[str]:
    """An equation whose sides differ."""
    if equality.relation != "=":
        return
    try:
        left, right = value(equality.left, letters), value(equality.right, letters)
    except Unknown:
        return
    scale = max(abs(left), abs(right), *(size(term, letters) for term in terms(equality)), mpf(100))
    if abs(left - right) > NEARLY * scale:
        yield f"{where}: {to_text(equality.left)} = {to_text(equality.right)} does not hold at the answers"


def terms(equality: Equality) -> list[Formula]:
    return [term for side in (equality.left, equality.right) for term in side.children()]


def size(term: Formula, letters: dict[str, mpf]) -> mpf:
    try:
        return abs(value(term, letters))
    except Unknown:
        return mpf(0)
