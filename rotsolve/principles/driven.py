"""Given motion: what is not given of it follows by differentiation: v = dx/dt, ω = dθ/dt, α = dω/dt."""

from __future__ import annotations

from collections.abc import Iterator

from rotsolve.algebra.exact.normal import is_zero
from rotsolve.algebra.formula import Formula, Symbol
from rotsolve.core.derivation import Words
from rotsolve.core.drive import TURNING
from rotsolve.core.equation import KINEMATICS, Equation
from rotsolve.core.facts import Facts, GivenMotion
from rotsolve.core.quantity import BY_WORD
from rotsolve.core.registry import TIME
from rotsolve.core.writing import spoken


def rates(facts: Facts, section: str) -> Iterator[Equation]:
    """Rate and acceleration of every given motion, as derivatives in time."""
    told = {(given.drive.body, given.drive.component, given.drive.word) for given in facts.given}
    for given in facts.given:
        functions = given.drive.rates()
        for word, function in functions.items():
            if (given.drive.body, given.drive.component, word) in told:
                continue
            left, right = given.letters[word], function.substitute({TIME: given.time})
            if left != right and not is_zero(left - right):
                label = f"{spoken(word)} {in_letters(given, word)}, {spoken(given.drive.body)}"
                remark = chain(given, word, functions)
                yield Equation(left, right, label, section, KINEMATICS, 1, remark, bodies=(given.drive.body,))


def in_letters(given: GivenMotion, word: str) -> str:
    """ω = dθ/dt, or v_x = dx/dt."""
    words, axis = given.drive.words, given.drive.component
    names = ("θ", "ω", "α") if words == TURNING else (axis, f"v_{axis}", f"a_{axis}") if axis else ("x", "v", "a")
    k = words.index(word)
    return f"{names[k]} = d{names[k - 1]}/dt"


def chain(given: GivenMotion, word: str, functions: dict[str, Formula]) -> Words:
    """θ = c t³, ω = 3 c t², α = 6 c t at t = t₁: the functions from the given one on, and when they are taken."""
    drive, now = given.drive, given.time
    upto = list(functions)[: list(functions).index(word) + 1]
    said = upto if now != Symbol(TIME) else upto[:-1]
    parts: list[str | Formula] = []
    for name in said:
        letter = "x" if name == "position" else BY_WORD[name].letter
        indexed = Symbol(
            "_".join(filter(None, (letter, drive.component))) if name != "position" else drive.component or letter
        )
        parts += [", " if parts else "", indexed, " = ", functions[name]]
    if now != Symbol(TIME) and TIME in functions[word].symbols():
        parts += [" at ", Symbol(TIME), " = ", now]
    return tuple(part for part in parts if part != "")
