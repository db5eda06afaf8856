"""Written before: laws that an earlier one says already, which a page writes once.

Two questions for the smallest and the largest root of one equation are answered by one law with another letter; entries of a vector, and
moments that are a double root, by the same right side.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.equation import Equation
from rotsolve.solver.steps import Step


def written_before(
    laws: Iterable[int], pool: Sequence[Equation], letters: Mapping[str, str], steps: Sequence[Step]
) -> tuple[dict[int, int], dict[int, int]]:
    """The laws of a page that an earlier one says already, of those that one step uses, which tells one of the asked letters: those of
    which another root is meant, and those with an equal letter, by their places in the pool, with that of the earlier one.

    These have beside them the name of the vector or tensor of which they are entries: letters are told together within one alone.
    """
    before: dict[int, str] = {}  # with the letters that they tell
    roots, alike = dict[int, int](), dict[int, int]()
    for index in laws:
        own = [step for step in steps if ("law", index) in (step.target, *step.sources)]
        told = own[0].result if len(own) == 1 and own[0].target == ("law", index) else tells_at_once(pool[index], own)
        if told not in letters:
            continue
        first = next(
            (other for other, name in before.items() if sides(pool[other], name, told) == sides(pool[index])), None
        )
        if first is None:
            before[index] = told
        elif pool[index].left != Symbol(told) and solved(index, steps) != solved(first, steps):
            roots[index] = first
        elif pool[index].left == Symbol(told) and "" != letters[told] == letters[before[first]]:
            alike[index] = first
    return roots, alike


def solved(index: int, steps: Sequence[Step]) -> Formula | None:
    """What a law comes to that one step solves."""
    return next((step.chain[-1].right for step in steps if step.target == ("law", index)), None)


def tells_at_once(equation: Equation, steps: Sequence[Step]) -> str:
    """The letter that a law tells which takes no step."""
    return equation.left.name if not steps and isinstance(equation.left, Symbol) else ""


def sides(equation: Equation, letter: str = "", other: str = "") -> tuple[object, ...]:
    """What an equation says, and of what; with another letter in place of one."""
    swap = {letter: Symbol(other)} if letter != other else {}
    left, right = (side.substitute(swap) for side in (equation.left, equation.right))
    return left, right, equation.relation, equation.label, equation.section
