"""Choices: which option is the largest, exceeds a bound or holds; every comparison is exact or certified."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from msgspec.structs import replace

from rotsolve.algebra.units.dimension import NONE
from rotsolve.language.problem import Find, WhichOf
from rotsolve.paths.meaning import NotYet
from rotsolve.questions.find import question_for
from rotsolve.search.answers import Answered, Chosen, Compared, OptionResult
from rotsolve.search.search import Search
from rotsolve.solver.steps import Found

DIGITS = 50  # to which two numbers without a closed form are told apart
HOLDING = {"<": (-1,), ">": (1,), "≤": (-1, 0), "≥": (0, 1), "=": (0,)}
OPPOSITE = {"<": "≥", ">": "≤", "≤": ">", "≥": "<", "=": "≠"}
RELATION = {-1: "<", 0: "=", 1: ">"}
BOUND = {"above": ">", "below": "<"}


def choose(find: Find, choice: WhichOf, search: Search, answer: Callable[[Find], Answered]) -> Chosen:
    """Decide a choice; `answer` settles one of the quantities that it compares."""
    bound = [] if choice.bound is None else [side_answer(choice.bound, find.name, search, answer)]
    options = [
        (option.label, [side_answer(side, find.name, search, answer) for side in option.sides])
        for option in choice.options
    ]
    if choice.test in ("largest", "smallest"):
        return Chosen(find, extremes(choice.test, [(label, sides[0]) for label, sides in options], search))
    signs = [option.signs or (BOUND[choice.test],) for option in choice.options]
    pairs = zip(options, signs, strict=True)
    return Chosen(find, tuple(verdict(label, [*sides, *bound], own, search) for (label, sides), own in pairs))


def side_answer(side: Find, whole: str, search: Search, answer: Callable[[Find], Answered]) -> Answered:
    """One quantity of a choice; what is made of givens alone needs no law."""
    question = replace(question_for(side, search.scene, search.letters()), whole=whole)
    unknown = any(name in search.givens and search.givens[name].asked for name in question.formula.symbols())
    if question.of_givens and not unknown:
        return Answered(question, Found(question.letter, question.formula), ())
    known = next((item for item in search.answered if item.asked.same_as(question)), None)
    if known is not None:
        return replace(known, asked=replace(question, letter=known.asked.letter))
    return answer(side)


def alike(sides: Sequence[Answered]) -> list[Answered]:
    """The quantities of a comparison with one dimension, so that π beside an angle is told in radians."""
    known = (side.asked.dimension for side in sides if side.asked.dimension not in (None, NONE))
    dimension = next(known, None)
    return [
        replace(side, asked=replace(side.asked, dimension=dimension)) if side.asked.dimension in (None, NONE) else side
        for side in sides
    ]


def verdict(label: str, sides: Sequence[Answered], signs: Sequence[str], search: Search) -> OptionResult:
    """Whether all comparisons of an option hold; of one that does not, those that fail."""
    holding, failing = [], []
    sides = alike(sides)
    for left, sign, right in zip(sides[:-1], signs, sides[1:], strict=True):
        if comparison_sign(left, right, search) in HOLDING[sign]:
            holding.append(Compared(left, sign, right))
        else:
            failing.append(Compared(left, OPPOSITE[sign], right))
    return OptionResult(label, not failing, None, tuple(failing or holding))


def extremes(test: str, options: Sequence[tuple[str, Answered]], search: Search) -> tuple[OptionResult, ...]:
    """Which quantities none of the others exceeds, or undercuts."""
    beaten = -1 if test == "largest" else 1
    verdicts = []
    for label, own in options:
        others = [(other, comparison_sign(own, other, search)) for _, other in options if other is not own]
        best = all(sign != beaten for _, sign in others)
        told = tuple(Compared(own, RELATION[sign], other) for other, sign in others) if best else ()
        verdicts.append(OptionResult(label, best, own, told))
    return tuple(verdicts)


def comparison_sign(left: Answered, right: Answered, search: Search) -> int:
    """The sign of left − right, exactly or by balls; refused where it can not be told."""
    sign = difference_sign(left.found, right.found, search)
    if sign is None:
        formulas = [side.found.formula for side in (left, right) if side.found.formula is not None]
        lacking = {name for formula in formulas for name in formula.symbols() if name not in search.values}
        names = ", ".join(f"`{name}`" for name in sorted(lacking))
        help = f"give a number to {names}" if lacking else ""
        raise NotYet(f"whether `{left.find.text}` exceeds `{right.find.text}` can not be decided", help=help)
    return sign


def difference_sign(left: Found, right: Found, search: Search) -> int | None:
    """−1, 0 or 1 as left is smaller, equal or larger; None where nothing tells."""
    if left.formula is None or right.formula is None:
        numbers = [
            found.number if found.formula is None else search.signs.number(found.formula) for found in (left, right)
        ]
        balls = [number.refine(DIGITS) for number in numbers if number is not None]
        gap = balls[0] - balls[1] if len(balls) == 2 else None
        return None if gap is None or gap.contains(0) else 1 if gap > 0 else -1
    return search.signs.taken(left.formula - right.formula)
