"""Writing an equation as a textbook does: what is positive first, nothing that is zero, minus signs moved across."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Sequence

from rotsolve.algebra.exact.normal import simplify
from rotsolve.algebra.formula import (
    ONE,
    ZERO,
    Call,
    Formula,
    Negative,
    Number,
    Product,
    Quotient,
    Sum,
    Symbol,
    negate,
    total,
)


def is_negative(term: Formula) -> bool:
    """Whether a term is written with a minus sign in front."""
    if isinstance(term, Negative):
        return True
    if isinstance(term, Number):
        return term.value < 0
    if isinstance(term, (Product, Quotient)):
        return is_negative(term.children()[0])
    return False


def flat(terms: Iterable[Formula]) -> list[Formula]:
    """The single terms of a sum, zeros left out and equal ones counted: T + T is 2 T."""
    counted: dict[Formula, int] = {}
    for term in _single(terms):
        counted[term] = counted.get(term, 0) + 1
    return [term if number == 1 else number * term for term, number in counted.items()]


def _single(terms: Iterable[Formula]) -> Iterator[Formula]:
    for term in terms:
        if isinstance(term, Sum):
            yield from _single(term.terms)
        elif term != ZERO:
            yield with_powers(term)


def with_powers(term: Formula) -> Formula:
    """A product with its repeated letters as powers: m L ω L is m L² ω."""
    if isinstance(term, Negative):
        return negate(with_powers(term.operand))
    if not isinstance(term, Product) or len(set(term.factors)) == len(term.factors):
        return term
    counted: dict[Formula, int] = {}
    for factor in term.factors:
        counted[factor] = counted.get(factor, 0) + 1
    result: Formula = ONE
    for factor, number in counted.items():
        result = result * (factor if number == 1 else factor**number)
    return result


def multiplied_out(term: Formula, positive: Collection[str] = ()) -> Formula:
    """A term with its fractions of sums cancelled, and a minus sign left in front: −F R ((R − h)/R) is −F (R − h)."""
    if not any(isinstance(node, Quotient) and isinstance(node.numerator, (Sum, Call)) for node in term.walk(Quotient)):
        return term
    return negate(simplify(negate(term), positive=positive)) if is_negative(term) else simplify(term, positive=positive)


def positive_first(terms: Iterable[Formula]) -> Formula:
    """Σ terms with the positive ones first."""
    forward, back = by_sign(terms)
    return total([*forward, *back])


def by_sign(terms: Iterable[Formula]) -> tuple[list[Formula], list[Formula]]:
    """The single terms of a sum: those without a minus sign in front, and those with one."""
    single = flat(terms)
    return [term for term in single if not is_negative(term)], [term for term in single if is_negative(term)]


def law(pushes: Sequence[Formula], response: Formula) -> tuple[Formula, Formula]:
    """Σ pushes = response; in equilibrium the positive ones on the left equal the others on the right."""
    forward, back = by_sign(pushes)
    turned = [negate(term) for term in back]
    if response != ZERO:
        if back and not forward and is_negative(response):
            return total(turned), negate(response)
        return total([*forward, *back]), response
    return (total(forward), total(turned)) if forward else (total(turned), ZERO)


def moved(left: Sequence[Formula], right: Sequence[Formula]) -> tuple[Formula, Formula]:
    """Σ left = Σ right with every negative term moved to the other side."""
    (here, from_here), (there, from_there) = by_sign(left), by_sign(right)
    return total([*here, *map(negate, from_there)]), total([*there, *map(negate, from_here)])


def spoken(name: str) -> str:
    """A name of the scene as words."""
    return name.replace("_", " ").strip()


def point_in_words(point: str) -> str:
    """A point of a body as words, behind the name of that; `at` is the place of a joint on it, `rod.at(x)`."""
    return {"cm": "its centre of mass", "at": "the point that is held"}.get(point, f"its {spoken(point)}")


def in_direction(words: str, component: str, in_space: bool) -> str:
    """A component in words: "horizontal velocity of ball", in space "velocity of ball along x"."""
    if in_space:
        return f"{words} along {component}" if component in ("x", "y", "z") else words
    return {"x": "horizontal ", "y": "vertical "}.get(component, "") + words


def and_joined(words: Sequence[str]) -> str:
    """a, b and c; with a comma before the last where one of them has an "and" of its own."""
    if len(words) == 1:
        return words[0]
    comma = "," if any(" and " in word for word in words) else ""
    return f"{', '.join(words[:-1])}{comma} and {words[-1]}"


def balance(terms: list[tuple[Formula, int]]) -> tuple[Formula, Formula]:
    """Σ sign · term = 0 as an equation of positive terms: those of the first body on the left, the others moved across."""
    left, right = moved([value if sign > 0 else negate(value) for value, sign in terms], ())
    if left == ZERO or (right != ZERO and not isinstance(left, Symbol) and isinstance(right, Symbol)):
        left, right = right, left
    return left, right
