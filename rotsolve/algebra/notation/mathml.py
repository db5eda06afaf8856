"""MathML: a formula as MathML Core, which browsers set without a script: `½ M R²` with its fraction bar and raised two."""

from __future__ import annotations

import re
from functools import lru_cache
from html import escape

from rotsolve.algebra.formula import Formula
from rotsolve.algebra.notation.letters import from_superscript, greek, parts
from rotsolve.algebra.notation.text import Signs
from rotsolve.algebra.notation.typeset import Marks, typeset

TIMES = "<mo>\N{INVISIBLE TIMES}</mo>"
THIN = '<mspace width="0.17em"></mspace>'
HAIR = '<mspace width="0.1em"></mspace>'
SLASH = '<mo lspace="0" rspace="0">/</mo>'
UPRIGHT = '<mi mathvariant="normal">{}</mi>'.format
UNIT = re.compile(r"(?P<word>[A-Za-zµμ_]+|[°%])(?:(?P<raised>[⁻⁺⁰¹²³⁴⁵⁶⁷⁸⁹]+)|\^\((?P<share>[^)]*)\))?|(?P<mark>.)")


@lru_cache(1000)  # an answer is printed for thousands of variants
def mathml(formula: Formula) -> str:
    """The formula as one MathML element, which belongs within `<math>`."""
    return typeset(formula, MARKS)


def letter_to_mathml(name: str) -> str:
    """An ASCII name as a letter with what stands below it: θ₀, a_end; a name that is no letter, such as a path, as text."""
    found = parts(name)
    if found is None:
        return f"<mtext>{escape(name)}</mtext>"
    below = ",".join(filter(None, (found.index, found.word.replace("_", ","))))
    result = identifier(found.head)
    if found.dots:
        result = f"<mover>{result}<mo>{'˙¨'[found.dots - 1]}</mo></mover>"
    if below:
        result = f"<msub>{result}{subscript(below)}</msub>"
    if found.prime:
        result = f"<msup>{result}<mo>′</mo></msup>"
    if found.change:
        result = row(UPRIGHT("Δ") + result)
    return row(result + brackets(letter_to_mathml(found.of))) if found.of else result


def identifier(head: str) -> str:
    """One letter is set in italics, a word upright and apart from other factors."""
    set_letter = f"<mi>{escape(greek(head))}</mi>"
    return set_letter if len(greek(head)) == 1 else row(f"{HAIR}{set_letter}{HAIR}")


def subscript(text: str) -> str:
    """What stands below a letter: digits, a letter, or a word upright."""
    if text.isdigit():
        return f"<mn>{text}</mn>"
    return identifier(text) if len(greek(text)) == 1 else f"<mtext>{escape(text)}</mtext>"


@lru_cache(1000)
def unit_to_mathml(text: str) -> str:
    """A unit as it is printed, `kg m²/s`, upright and with raised powers."""
    return row("".join(map(unit_part, UNIT.finditer(text))))


def unit_part(found: re.Match[str]) -> str:
    if found["mark"]:
        mark = found["mark"]
        return {" ": THIN, "/": SLASH}.get(mark) or (f"<mn>{mark}</mn>" if mark.isdigit() else f"<mo>{mark}</mo>")
    word = UPRIGHT(escape(found["word"]))
    power = found["share"] or from_superscript(found["raised"] or "")
    return f"<msup>{word}<mn>{power.replace('-', '−')}</mn></msup>" if power else word


def row(inner: str) -> str:
    return f"<mrow>{inner}</mrow>"


def brackets(inner: str) -> str:
    return f"<mrow><mo>(</mo>{inner}<mo>)</mo></mrow>"


def integral(lower: str, upper: str, body: str, variable: str) -> str:
    """∫ body d(variable) from lower to upper."""
    return row(f"<msubsup><mo>∫</mo>{lower}{upper}</msubsup>{body}{THIN}{UPRIGHT('d')}{variable}")


MARKS = Marks(
    number="<mn>{}</mn>".format,
    letter=letter_to_mathml,
    function="<mi>{}</mi>".format,
    row=row,
    signs=Signs("<mo>+</mo>", "<mo>−</mo>", "<mo>−</mo>", brackets),
    beside=TIMES,
    before=THIN,
    dot="<mo>·</mo>",
    applied=THIN,
    comma="<mo>,</mo>",
    bars="<mrow><mo>|</mo>{}<mo>|</mo></mrow>".format,
    root="<msqrt>{}</msqrt>".format,
    fraction="<mfrac>{}{}</mfrac>".format,
    power="<msup>{}{}</msup>".format,
    integral=integral,
)
