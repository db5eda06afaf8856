"""What a page adds to a derivation holds over all problems: numbers put in, letters for sums that come back, the plan."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.exact.normal import equal
from rotsolve.algebra.formula import ONE, Decimal, Formula, Number
from rotsolve.core.derivation import Derivation, Equality
from rotsolve.page.abbreviations import abbreviated
from rotsolve.page.blocks import Amount, Formulas
from rotsolve.page.derivation import DerivationPage
from rotsolve.page.plan import plan_of
from rotsolve.page.text import plain_text
from rotsolve.page.values import machine_number
from solutions import solved

ROUNDED = 6e-4  # of numbers that are put in so that they come to four digits


def size(amount: Amount) -> float:
    """An amount in SI units."""
    unit = ONE if amount.unit is None else amount.unit.factor
    if isinstance(amount.number, str):
        return float(machine_number(amount.number)) * evaluate(unit, {}).float
    return evaluate(amount.number.transform(plain) * unit, {}).float


def plain(node: Formula) -> Formula:
    return Number(Fraction(machine_number(node.name))) if isinstance(node, Decimal) else node


def test_the_numbers_put_in_come_to_the_value(problem_file: Path) -> None:
    for block in DerivationPage(solved(problem_file).derivation).blocks():
        for row in block.rows if isinstance(block, Formulas) else ():
            if len(row.values) > 1:
                put_in, value = map(size, row.values)
                assert abs(put_in - value) <= ROUNDED * abs(value), plain_text(row.line(row.valued % len(row.chain)))


def steps(derivation: Derivation) -> list[Equality]:
    return [one for section in derivation.sections for move in section.moves for one in move.chain]


def test_letters_for_sums_stand_for_what_was_there(problem_file: Path) -> None:
    derivation = solved(problem_file).derivation
    shorter, letters = abbreviated(derivation)
    if not letters:
        assert shorter == derivation
        return
    meanings = {one.letter.name: one.meaning for one in letters}
    told = [one.equality for one in letters]
    after = [one for one in steps(shorter) if one not in told]
    assert len(steps(shorter)) == len(after) + len(letters)
    for before, now in zip(steps(derivation), after, strict=True):
        for one, other in ((before.left, now.left), (before.right, now.right)):
            assert one == other or equal(one, other.substitute(meanings)), (one, other)


def test_the_plan_is_told_in_sentences(problem_file: Path) -> None:
    derivation = solved(problem_file).derivation
    plan = [plain_text(sentence) for sentence in plan_of(derivation)]
    assert all(sentence.endswith(".") and "{" not in sentence and "  " not in sentence for sentence in plan)
    assert plan or sum(len(section.laws) for section in derivation.sections) < 2 or len(derivation.sections) < 2
