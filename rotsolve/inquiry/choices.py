"""Choices: which option is the largest, exceeds a bound or holds; every comparison is exact or certified."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from msgspec.structs import replace

from rotsolve.algebra.certified.ball import Certified, evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import Call, Formula
from rotsolve.algebra.units.dimension import NONE
from rotsolve.inquiry.answers import Answered, Chosen, Compared, Verdict
from rotsolve.inquiry.finds import asked
from rotsolve.inquiry.inquiry import Inquiry
from rotsolve.inquiry.questions import NotYet
from rotsolve.language.problem import Choice, Find
from rotsolve.solver import Found

DIGITS = 50  # to which two numbers without a closed form are told apart
HOLDING = {"<": (-1,), ">": (1,), "≤": (-1, 0), "≥": (0, 1), "=": (0,)}
OPPOSITE = {"<": "≥", ">": "≤", "≤": ">", "≥": "<", "=": "≠"}
RELATION = {-1: "<", 0: "=", 1: ">"}
BOUND = {"above": ">", "below": "<"}


def choose(find: Find, choice: Choice, inquiry: Inquiry, answer: Callable[[Find], Answered]) -> Chosen:
    """Decide a choice; `answer` settles one of the quantities that it compares."""
    bound = [] if choice.bound is None else [settled(choice.bound, find.name, inquiry, answer)]
    options = [
        (option.label, [settled(side, find.name, inquiry, answer) for side in option.sides])
        for option in choice.options
    ]
    if choice.test in ("largest", "smallest"):
        return Chosen(find, extremes(choice.test, [(label, sides[0]) for label, sides in options], inquiry))
    signs = [option.signs or (BOUND[choice.test],) for option in choice.options]
    return Chosen(
        find,
        tuple(
            verdict(label, [*sides, *bound], own, inquiry) for (label, sides), own in zip(options, signs, strict=True)
        ),
    )


def settled(side: Find, whole: str, inquiry: Inquiry, answer: Callable[[Find], Answered]) -> Answered:
    """One quantity of a choice; what is made of givens alone needs no law."""
    question = replace(asked(side, inquiry.history, inquiry.letters()), whole=whole)
    unknown = any(name in inquiry.givens and inquiry.givens[name].asked for name in question.formula.symbols())
    if question.of_givens and not unknown:
        return Answered(question, Found(question.letter, question.formula), ())
    known = next((item for item in inquiry.answered if item.asked.same_as(question)), None)
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


def verdict(label: str, sides: Sequence[Answered], signs: Sequence[str], inquiry: Inquiry) -> Verdict:
    """Whether all comparisons of an option hold; of one that does not, those that fail."""
    holding, failing = [], []
    sides = alike(sides)
    for left, sign, right in zip(sides[:-1], signs, sides[1:], strict=True):
        if compared(left, right, inquiry) in HOLDING[sign]:
            holding.append(Compared(left, sign, right))
        else:
            failing.append(Compared(left, OPPOSITE[sign], right))
    return Verdict(label, not failing, None, tuple(failing or holding))


def extremes(test: str, options: Sequence[tuple[str, Answered]], inquiry: Inquiry) -> tuple[Verdict, ...]:
    """Which quantities none of the others exceeds, or undercuts."""
    beaten = -1 if test == "largest" else 1
    verdicts = []
    for label, own in options:
        others = [(other, compared(own, other, inquiry)) for _, other in options if other is not own]
        best = all(sign != beaten for _, sign in others)
        told = tuple(Compared(own, RELATION[sign], other) for other, sign in others) if best else ()
        verdicts.append(Verdict(label, best, own, told))
    return tuple(verdicts)


def compared(left: Answered, right: Answered, inquiry: Inquiry) -> int:
    """The sign of left − right, exactly or by balls; refused where it can not be told."""
    sign = difference(left.found, right.found, inquiry)
    if sign is None:
        lacking = sorted(
            name
            for found in (left.found, right.found)
            for name in (found.formula.symbols() if found.formula is not None else ())
            if name not in inquiry.values
        )
        names = ", ".join(f"`{name}`" for name in dict.fromkeys(lacking))
        help = f"give a number to {names}" if lacking else ""
        raise NotYet(f"whether `{left.find.text}` exceeds `{right.find.text}` can not be decided", help=help)
    return sign


def difference(left: Found, right: Found, inquiry: Inquiry) -> int | None:
    """−1, 0 or 1 as left is smaller, equal or larger; None where nothing tells."""
    if left.formula is None or right.formula is None:
        balls = [number.refine(DIGITS) for found in (left, right) if (number := value(found, inquiry)) is not None]
        gap = balls[0] - balls[1] if len(balls) == 2 else None
        return None if gap is None or gap.contains(0) else 1 if gap > 0 else -1
    return sign_of(left.formula - right.formula, inquiry)


def sign_of(gap: Formula, inquiry: Inquiry) -> int | None:
    """The sign of a closed form: exactly where it vanishes or its letters are positive, else by a ball."""
    positive = inquiry.solver.positive
    if is_zero(gap, positive):
        return 0
    if gap.symbols() <= set(inquiry.values):
        try:
            return evaluate(gap, inquiry.values).sign
        except Undefined:
            return None
    size = Call("abs", (inquiry.solver.simplify(gap),))
    return 1 if is_zero(size - gap, positive) else -1 if is_zero(size + gap, positive) else None


def value(found: Found, inquiry: Inquiry) -> Certified | None:
    """A quantity as a certified number."""
    if found.formula is None:
        return found.number
    try:
        return evaluate(found.formula, inquiry.values)
    except Undefined:
        return None
