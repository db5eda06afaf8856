"""Vocabulary: what letters and runs of letters mean in a student's line, and the forks at which it can be read in two ways.

A run such as `mg` or `ω₀t` is letters of the scene, the longest first, functions, and e where it is raised. A line is read again for each
way through its forks, the likeliest first.
"""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Callable
from functools import lru_cache
from typing import TypeVar

from rotsolve.algebra.formula import Formula
from rotsolve.algebra.notation.cursor import Cursor, Forks, Vocabulary
from rotsolve.algebra.notation.letters import SUBSCRIPTS
from rotsolve.algebra.notation.limits import MAX_TREE_DEPTH, check_depth
from rotsolve.algebra.notation.parse import Parser
from rotsolve.algebra.notation.tokens import (
    FUNCTION_NAMES,
    SHORTEST,
    FormulaError,
    Token,
    UnknownName,
    one_name,
    resolve,
    side_by_side,
)

INVERSE = {name: f"a{name}" for name in ("sin", "cos", "tan", "sinh", "cosh", "tanh")}  # sin⁻¹ x may be arcsin x
TAKES_POWER = frozenset(("sqrt", "log", "exp", "asin", "acos", "atan"))  # √x² is √(x²), but sin θ² is likelier (sin θ)²
EULER = "e"  # the base of the exponential, where no letter of the scene is called so
_FUNCTION = "|".join(
    sorted(
        (name for name, kind in FUNCTION_NAMES.items() if kind != "integral" and len(name) >= SHORTEST),
        key=len,
        reverse=True,
    )
)
INDICES = frozenset(SUBSCRIPTS.values())  # of which no name begins
REMEMBERED = 4096  # runs: students write the same few over and over
MOST_STRANGE = 2  # letters at a run's end that are told to be strange by themselves: x in mgx, but not orce in force
LONGEST_RUN = 24  # of a run in which the strange part is looked for
MOST_READINGS = 16  # two terms as 1/2 m r² w have four each
MOST_TRIES, MOST_TOKENS = 24, 1500  # of a line, and of all its tries together

Found = TypeVar("Found")


class Ways(list[Found]):
    """What a text can mean; `cut` where some ways of reading it were left untried."""

    cut = False


# letters


class StudentVocabulary(Vocabulary, frozen=True):
    """The letters of a scene, and all functions that students write."""

    @classmethod
    def of(cls, names: frozenset[str]) -> StudentVocabulary:
        euler = "" if EULER in names else EULER
        return cls(names, euler=euler, inverses=INVERSE, powered=TAKES_POWER)

    def meanings(self, cursor: Cursor) -> list[Token]:
        """What a run of letters means, from memory where it is known; with e where a power of it follows."""
        if cursor.bound:
            return super().meanings(cursor)
        token, following = cursor.token, cursor.tokens[cursor.index + 1]
        assert isinstance(self.names, frozenset)
        function = self.elliptic(cursor)
        if function:
            return [Token("function", function, token.start, token.end)]
        names = self.names | {EULER} if token.text.endswith(EULER) and following.kind in ("^", "raised") else self.names
        found = run_meaning(token.text, names)
        if found is None:
            raise run_fault(token, names)
        start, end = token.start, token.end
        pieces = [Token(piece.kind, piece.text, start + piece.start, start + piece.end) for piece in found[:-1]]
        last = found[-1]
        return [*pieces, Token(last.kind, last.text, start + last.start, end)]


def read_formula(text: str, tokens: list[Token], names: frozenset[str], forks: Forks) -> Formula:
    """The formula that some tokens write, the last of which is an `end`."""
    result = Parser(text, list(tokens), StudentVocabulary.of(names), forks).formula()
    if len(tokens) > MAX_TREE_DEPTH // 2:  # fewer can not make so deep a tree
        check_depth(result, len(text))
    return result


@lru_cache(REMEMBERED)
def run_meaning(run: str, names: frozenset[str]) -> tuple[Token, ...] | None:
    """The letters and functions side by side in a run, with their columns in it; None where it holds anything else."""
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
    ends = range(1, len(run)) if len(run) <= LONGEST_RUN else ()
    apart = (end for end in ends if run[end].isalpha() and run[end] not in INDICES)
    known = max((end for end in apart if run_meaning(run[:end], names) is not None), default=0)
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


# forks


def all_ways(read: Callable[[Forks], Found], tokens: int) -> Ways[Found]:
    """What a line says, read in all ways that make sense, with fewest unlikely branches first; the first fault where none does.

    A line of many tokens is tried less often.
    """
    most = min(MOST_TRIES, 1 + MOST_TOKENS // max(tokens, 1))
    waiting: deque[tuple[bool, ...]] = deque([()])
    found: Ways[Found] = Ways()
    fault: FormulaError | None = None
    tries = 0
    while waiting and tries < most and len(found) < MOST_READINGS:
        way = waiting.popleft()
        forks = Forks(way)
        tries += 1
        try:
            reading = read(forks)
        except FormulaError as error:
            fault = fault or error
        else:
            if reading not in found:
                found.append(reading)
        for index in range(len(way), len(forks.taken)):
            waiting.append((*forks.taken[:index], True))
    if fault is not None and not found:
        raise fault
    found.cut = bool(waiting)
    return found
