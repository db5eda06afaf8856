"""Missing numbers: why an answer has none: a mass or a size that the scene leaves out."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from msgspec.structs import replace

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.certified.balls import Undefined
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.derivation import Answer, Derivation
from rotsolve.core.quantity import DIMENSIONS
from rotsolve.core.writing import spoken
from rotsolve.language.problem import Body, Given, Problem


def with_missing_told(derivation: Derivation, problem: Problem) -> Derivation:
    """The derivation with a remark at each answer that has no number since the scene leaves a mass or a size out."""
    missing = {given.name: given for given in problem.givens if given.automatic and given.value is None}
    return replace(derivation, answers=tuple(told_missing(answer, missing, problem) for answer in derivation.answers))


def told_missing(answer: Answer, missing: Mapping[str, Given], problem: Problem) -> Answer:
    numbered = {given.name for given in problem.givens if given.value is not None}
    if (
        answer.formula is not None
        and answer.value is None
        and answer.formula.symbols() <= numbered
        and not answer.remark
    ):
        return replace(answer, remark=(f"no number: {undefined(answer.formula, problem)}",))
    names = [name for name in missing if answer.formula is not None and name in answer.formula.symbols()]
    if not names or answer.remark:
        return answer
    words: list[str | Formula] = ["no number: "]
    for name in names:
        words += [", " if name != names[0] else "", Symbol(name), f", the {meaning(missing[name], problem)},"]
    return replace(answer, remark=(*words, " is not given" if len(names) == 1 else " are not given"))


def undefined(formula: Formula, problem: Problem) -> str:
    """Why a formula has no number with these givens."""
    try:
        evaluate(formula, {given.name: given.value for given in problem.givens if given.value is not None}, digits=4)
    except (Undefined, ZeroDivisionError) as reason:
        return str(reason)
    return "with these givens it is not defined"


def meaning(given: Given, problem: Problem) -> str:
    """What an automatic letter stands for, and where it could be given: "mass of block in line 4"."""
    kind = next((word for word, dimension in DIMENSIONS.items() if dimension == given.dimension), "value")
    owner = given.name.partition("_")[2]
    body = next(
        (body for body in every_body(problem.bodies) if body.name == owner.rstrip("_") or body.name == owner), None
    )
    if body is None:
        return f"{kind} of {spoken(owner.rstrip('_'))}"
    line = f" in line {body.span.line}" if body.span is not None else ""
    size = "radius" if kind == "length" and given.name.startswith("R") else kind
    return f"{size} of {spoken(body.name)}{line}"


def every_body(bodies: Iterable[Body]) -> Iterator[Body]:
    """Bodies with the parts that they are made of."""
    for body in bodies:
        yield body
        yield from every_body(part.body for part in body.parts)
