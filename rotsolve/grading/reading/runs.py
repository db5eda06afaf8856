"""Runs: what a run of letters means, `mg` or `ω₀t`: letters of the scene, the longest first, functions, and e where it is raised."""

from __future__ import annotations

import re
from functools import lru_cache

from rotsolve.algebra.formula import FUNCTIONS
from rotsolve.algebra.notation.letters import SUBSCRIPTS
from rotsolve.algebra.notation.tokens import (
    FUNCTION_NAMES,
    FormulaError,
    Token,
    UnknownName,
    one_name,
    resolve,
    side_by_side,
)

_FUNCTION = "|".join(
    sorted((name for name in FUNCTION_NAMES if FUNCTION_NAMES[name] in FUNCTIONS), key=len, reverse=True)
)
INDICES = frozenset(SUBSCRIPTS.values())  # of which no name begins
REMEMBERED = 4096  # runs: students write the same few over and over
MOST_STRANGE = (
    2  # letters at the end of a run that are told to be strange by themselves: x in mgx, but not orce in force
)
LONGEST_RUN = 24  # of a run in which the strange part is looked for


@lru_cache(REMEMBERED)
def run_meaning(run: str, names: frozenset[str]) -> tuple[Token, ...] | None:
    """The letters and functions side by side in a run, with their columns in it; None where it holds anything else."""
    if run in RECIPROCAL and run not in names:
        return (Token("function", run, 0, len(run)),)
    token = Token("name", run, 0, len(run))
    try:
        whole = one_name(token, names, ())
        found = [whole] if whole is not None else side_by_side(token, names, ())
    except FormulaError:
        return None  # a part of it could be two of them
    return tuple(found) if found else _with_function_inside(run, names)


def _with_function_inside(run: str, names: frozenset[str]) -> tuple[Token, ...] | None:
    """`mgsintheta`: a function with the run of its argument behind it, which the program's own notation does not allow."""
    for match in re.finditer(_FUNCTION, run) if len(run) <= LONGEST_RUN else ():
        head = run_meaning(run[: match.start()], names) if match.start() else ()
        tail = run_meaning(run[match.end() :], names) if match.end() < len(run) else None
        if head is not None and tail is not None:
            cut = match.end()
            behind = [Token(token.kind, token.text, token.start + cut, token.end + cut) for token in tail]
            return (*head, Token("function", FUNCTION_NAMES[match[0]], match.start(), cut), *behind)
    return None


def run_fault(token: Token, names: frozenset[str]) -> FormulaError:
    """Why a run has no meaning; of `mgx` the x is told to be strange, and `v2` is perhaps meant as v²."""
    run = token.text
    ends = (
        [end for end in range(1, len(run)) if run[end].isalpha() and run[end] not in INDICES]
        if len(run) <= LONGEST_RUN
        else []
    )
    known = max((end for end in ends if run_meaning(run[:end], names) is not None), default=0)
    strange = Token("name", run[known:], token.start + known, token.end)
    if known and len(strange.text) > MOST_STRANGE and run.isalpha():  # a word
        return UnknownName(f"unknown name `{run}`", token.start, token.end)
    if run_meaning(strange.text, names) is not None:  # a function in the midst of a run
        strange = token
    try:
        resolve(strange, names, (), split=True)
    except UnknownName as error:
        powered = strange.text[-1].isdecimal() and strange.text[:-1] in names
        suggestion = f"{strange.text[:-1]}^{strange.text[-1]}" if powered else error.suggestion
        return UnknownName(error.message, strange.start, strange.end, suggestion)
    except FormulaError as error:
        return error
    return UnknownName(f"unknown name `{run}`", token.start, token.end)


RECIPROCAL = {"cot": "tan", "sec": "cos", "csc": "sin", "cosec": "sin"}  # cot x is 1/tan x
INVERSE = {"sin": "asin", "cos": "acos", "tan": "atan"}  # sin⁻¹ x may be arcsin x
TAKES_POWER = frozenset(("sqrt", "log", "exp", "asin", "acos", "atan"))  # √x² is √(x²), but sin θ² is likelier (sin θ)²
EULER = "e"  # the base of the exponential, where no letter of the scene is called so
