"""Literals: a number with its unit, checked, as an exact number or as an automatic letter of its own; what an expression is made of.

`radius: 20 cm` in disc becomes R_disc, so that derivations print letters; zero, plain numbers without a letter, and angles
that are multiples of 15° stay exact numbers.
"""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Iterator, Mapping
from contextlib import suppress
from fractions import Fraction

from msgspec import Struct, field

from rotsolve.algebra.formula import ONE, PI, ZERO, Constant, Formula, Negative, Number, Product, Quotient, Sum, Symbol
from rotsolve.algebra.units.dimension import (
    ANGLE,
    BY_NAME,
    DIMENSIONS,
    KINDS,
    MASS,
    NONE,
    Dimension,
    DimensionError,
    describe,
    dimension_of,
    kind_of,
)
from rotsolve.algebra.units.quantities import UnitError, UnitValue, parse_quantity, parse_unit
from rotsolve.core.faults import Span
from rotsolve.core.quantity import NUMBER
from rotsolve.language.problem import Given
from rotsolve.language.words import an, did_you_mean, quoted
from rotsolve.scene.rough import rough
from rotsolve.scene.scope import Nothing, Scope
from rotsolve.scene.tree import Node, Text


def dimension_in_words(dimension: Dimension) -> str:
    """The dimension in words, with article and unit: `a force (N)`."""
    return describe(dimension, article=True)


def infer(
    formula: Formula, missing: list[str], known: Mapping[str, Dimension | None], wanted: Dimension | None
) -> Dimension | None:
    """The dimension of the one unknown letter of a formula whose dimension is wanted; None where it can't be told.

    The letter is tried as a pure number and as a mass: in a product of powers, the difference is its exponent.
    """
    if len(missing) != 1 or wanted is None:
        return None
    if formula == Symbol(missing[0]):
        return wanted
    if isinstance(formula, Negative):
        return infer(formula.operand, missing, known, wanted)
    if isinstance(formula, Sum):  # every term has the dimension of the whole
        holders = [term for term in formula.terms if missing[0] in term.symbols()]
        if len(holders) == 1:
            return infer(holders[0], missing, known, wanted)
    others = {name: found for name in formula.symbols() if (found := known.get(name)) is not None}
    try:
        plain = dimension_of(formula, {**others, missing[0]: NONE})
        probe = dimension_of(formula, {**others, missing[0]: MASS})
    except DimensionError:
        return only_fitting(formula, missing[0], others, wanted)
    exponent = probe.mass - plain.mass
    return None if exponent == 0 else (wanted / plain) ** (1 / Fraction(exponent))


def only_fitting(formula: Formula, letter: str, others: Mapping[str, Dimension], wanted: Dimension) -> Dimension | None:
    """The only dimension of a quantity with which the terms of a formula go together: x in (x² − x c)/c is a length."""
    fitting = set[Dimension]()
    for dimension in {kind.dimension for kind in KINDS}:
        with suppress(DimensionError):
            if dimension_of(formula, {**others, letter: dimension}).matches(wanted):
                fitting.add(dimension)
    return fitting.pop() if len(fitting) == 1 else None


DIGITS = r"(?:\d+\.?\d*|\.\d+)(?:[eE][-+−]?\d+)?"
NAME = r"[^\W\d]\w*"
PATH = rf"{NAME}(?:\.{NAME})*(?:\.\d+(?:\.[xyz]\b)?)?"  # a component may be a number: `box.principal_axis.1.x`
SCAN = re.compile(rf"(?P<number>{DIGITS})|(?P<name>{PATH})|(?P<space>\s+)|(?P<mark>.)", re.DOTALL)
POWER = r"(?:\s*\^\s*(?:[-−]?\d+|\([-−]?\d+/\d\))|[²³⁻¹⁴]+)?"
UNIT = re.compile(rf"\s*(?P<word>[^\W\d_]+|°|%){POWER}")
# What is rare is compiled when a text first needs it.
MORE = rf"(?:\s*[*·]\s*|\s*/\s*|\s+)(?P<word>[^\W\d_]+){POWER}"
BELOW = r"\s*/\s*(?P<word>[^\W\d_]+)(?![\w.(])"
CALL = rf"\.{NAME}"


class Lexeme(Struct, frozen=True):
    """A part of an expression: kind is number, quantity, name, path, mark or space."""

    kind: str
    text: str
    start: int
    end: int


def lexemes(text: str, names: Collection[str]) -> Iterator[Lexeme]:
    """The expression in pieces; a number before a unit is one piece, a path with its `at(…)` is one piece."""
    position = 0
    while position < len(text):
        match = SCAN.match(text, position)
        assert match is not None
        kind, end = str(match.lastgroup), match.end()
        if kind == "number" and (stop := unit_end(text, end, names)) > end:
            kind, end = "quantity", stop
        elif kind == "name" and (text[position:end].endswith(".at") and text[end : end + 1] == "("):
            kind, end = "path", path_end(text, end)
        elif match[0] == "pi" and match[0] not in names and (stop := unit_end(text, end, names)) > end:
            kind, end = "quantity", stop  # pi rad
        elif kind == "name" and "." in match[0]:
            kind = "path"
        yield Lexeme(kind, text[position:end], position, end)
        position = end


def path_end(text: str, position: int) -> int:
    """Where a path ends, from the `(` of its `at(…)` on."""
    position = min(closing(text, position) + 1, len(text))
    while match := re.compile(CALL).match(text, position):
        position = match.end()
    return position


def closing(text: str, position: int) -> int:
    """The place of the bracket that closes the one at `position`."""
    depth = 0
    while position < len(text):
        depth += {"(": 1, ")": -1}.get(text[position], 0)
        if depth == 0:
            return position
        position += 1
    return position


def unit_end(text: str, position: int, names: Collection[str]) -> int:
    """Where the unit after a number ends; `position` itself when none stands there."""
    match = UNIT.match(text, position)
    if not match or not names_unit(match["word"]) or text[match.end() : match.end() + 1] in ("_", "(", "."):
        return position
    position = match.end()
    while position < len(text) and (match := re.compile(MORE).match(text, position)):
        following = text[match.end() : match.end() + 1]
        if match["word"] == "in" and match[0][0].isspace():  # `= 500 N m in rev/min` asks for a unit
            break
        more = following in ("_", "(", ".") or following.isdigit()
        if match["word"] in names or more or not names_unit(match["word"]):
            break
        position = match.end()
    return position


def unit_below(text: str, position: int, names: Collection[str]) -> str:
    """The name right behind a quantity and a slash that could be one more unit, the `s` of `9.8 m/s` where `s` is a given; else ''."""
    match = re.compile(BELOW).match(text, position)
    return match["word"] if match and match["word"] in names and names_unit(match["word"]) else ""


def names_unit(word: str) -> bool:
    try:
        parse_unit(word)
    except UnitError:
        return False
    return True


def stand_in(number: int, length: int) -> str:
    """A letter that no scene has, of a given length: `Zq1_____`."""
    return f"Zq{number}".ljust(length, "z")


FACTOR = rf"(?:{DIGITS}(?:\s*/\s*\d+)?(?:\s*[×x*·]\s*10(?:\^[-−]?\d+|[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?|[¼½¾⅓⅔⅕⅙⅛⅜⅝⅞])"
PI_WORD = r"(?:pi(?!\w)|π)"
LITERAL = re.compile(
    rf"\s*[-+−]?\s*(?:{FACTOR}(?:\s*[*·]?\s*{PI_WORD})?|{PI_WORD})(?:\s*/\s*\d+)?\s*(?P<unit>(?:(?<=\s)1\s*/\s*\(?)?(?:[^\W\d_]|[°%]).*)?",
    re.DOTALL,
)
COMMA = r"\s*[-+−]?\d+,\d"  # compiled where there is a comma
FEW = 3  # places of letters that are shown beside a fault
STEP = Fraction(1, 12)  # 15° in units of π
EXPRESSION = Symbol("an expression after all")


class Want(Struct, frozen=True):
    """What a value is for: the words for messages, its dimension, and how to name a number written in place."""

    label: str
    dimension: str | None = None
    letter: str = ""
    owner: str = ""
    limits: str = ""
    varies: bool = False
    extra: Mapping[str, Dimension] = field(default_factory=dict)
    hint: str = ""
    words: tuple[str, ...] = ()  # other words that may have been meant


def asked_letter(scope: Scope, node: Text, want: Want) -> Formula | None:
    """`force: unknown`: a letter that is asked for."""
    if not want.letter:
        return scope.fault(node, f"`{want.label}` can't be unknown here", "name it in `given`: `x: unknown`", "form")
    name = scope.free(want.letter, want.owner, want.hint)
    dimension = DIMENSIONS[want.dimension] if want.dimension else None
    scope.givens[name] = Given(name, None, dimension, None, "unknown", asked=True, automatic=True, span=node.span)
    scope.dimensions[name] = dimension
    return Symbol(name)


def whole_literal(scope: Scope, node: Text, want: Want, unit: str) -> Formula | None:
    """A value that is one number with its unit; EXPRESSION when the text is an expression after all."""
    try:
        quantity = parse_quantity(node.value.strip())
    except UnitError as error:
        if re.search(r"[-+*/^()]", unit) or any(word in scope.givens for word in re.findall(r"\w+", unit)):
            return EXPRESSION
        return unit_fault(scope, node, error)
    wanted, own = DIMENSIONS[want.dimension] if want.dimension else None, scope.dimensions.get(unit)
    alone = wanted is not None and own is not None and quantity.dimension.matches(wanted) and not own.matches(wanted)
    if scope.kinds.get(unit) == "given" and quantity.value != ZERO and not alone:  # a length of 2 m is none of a mass m
        return ambiguous(scope, node, node.value.strip(), unit, wanted)
    return literal_value(scope, node, want, quantity)


def parsed_quantity(text: str) -> UnitValue | None:
    """The quantity that a text writes; None where it writes none."""
    try:
        return parse_quantity(text)
    except UnitError:
        return None


def unit_fault(scope: Scope, node: Text, error: UnitError, shift: int = 0) -> Nothing:
    """The complaint of the unit parser at its place."""
    shift += len(node.value) - len(node.value.lstrip())
    help = did_you_mean(
        error.suggestion,
        "write a number and a unit, such as `3 kg m^2`" if re.search("(unit [^:]*|begins .*)$", error.message) else "",
    )
    place = node.part(shift + error.start, shift + max(error.end, error.start + 1))
    return scope.fault(place, error.message, help, "unit")


def ambiguous(scope: Scope, place: Node | Span, text: str, unit: str, wanted: Dimension | None) -> Nothing:
    """Refuse `2 m` where `m` is a given; the product is proposed where it may be what is `wanted`."""
    number, own = text[: -len(unit)].strip(), scope.dimensions.get(unit)
    message = f"{quoted(text)} can be read in two ways: `{unit}` is a given and a unit"
    if own is None and unit in scope.givens and scope.givens[unit].asked:  # once, wherever it stands
        said, scope.of_no_kind = unit in scope.of_no_kind, scope.of_no_kind | {unit}
        help = f"choose another letter for what is sought, as `{unit}_1`; `{number}*{unit}` is the product"
        return None if said else scope.fault(place, message, help, "ambiguous")
    fits = (own is None or wanted is None or own.matches(wanted)) and "/" not in text
    product = f"write `{number}*{unit}` for the product, or " if fits else ""
    help = f"{product}put the quantity in `given` under a name"
    return scope.fault(place, message, help, "ambiguous")


def literal_value(scope: Scope, node: Text, want: Want, quantity: UnitValue) -> Formula | None:
    """A literal quantity, checked, as a number or an automatic letter."""
    text = node.value.strip()
    unit = quantity.unit.text if quantity.unit else ""
    if not dimension_holds(scope, node, want, quantity.dimension, text, unit, quantity.value):
        return None
    if not limits_hold(scope, node, rough(quantity.value, {}), want, text):
        return None
    return as_letter(scope, node.span, want, quantity)


def dimension_holds(
    scope: Scope, node: Text, want: Want, found: Dimension, text: str, unit: str, formula: Formula | None = None
) -> bool:
    """Whether a value has the dimension that is wanted; a bare number is no angle, and Hz is no angular velocity."""
    if want.dimension is None or (formula == ZERO and found == NUMBER):
        return True
    label, shown_text = f"`{want.label}` wants {an(want.dimension)}", quoted(text)
    wanted, letters = DIMENSIONS[want.dimension], givens_in(scope, node)
    number = text.rpartition("= ")[2]
    bare = found == NUMBER and want.dimension == "angle" and LITERAL.fullmatch(number) is not None
    bare = bare and re.search("pi|π|deg|rad|rev|°", number) is None
    if found.matches(wanted) and not bare:
        if want.dimension != "angular velocity" or "Hz" not in unit:
            return True
        help, message = "write `2 rev/s` or `12.6 rad/s`", f"{label}, but {shown_text} counts turns"
    else:
        shown = "has no unit" if found == NUMBER else f"is {dimension_in_words(found)}"
        help, message = with_its_unit(want, node, number, letters, found), f"{label}, but {shown_text} {shown}"
    blame_of_dimension(scope, node, message, help, formula, wanted)
    return False


def givens_in(scope: Scope, node: Text) -> list[str]:
    """The givens that a text names; none in a number with its unit."""
    named = () if parsed_quantity(node.value) is not None else dict.fromkeys(re.findall(NAME, node.value))
    return [name for name in named if name in scope.givens and scope.kinds.get(name) == "given"]


def with_its_unit(want: Want, node: Text, number: str, letters: list[str], found: Dimension) -> str:
    """What to write for a number that lacks its unit: itself with one, where it stands or is given; for one of another kind an example."""
    kind = BY_NAME[want.dimension or ""]
    if LITERAL.fullmatch(number) is None or kind.dimension == NUMBER:
        return ""
    unit = kind.example.partition(" ")[2] or kind.unit
    if found == NUMBER:
        return f"write a unit: `{letters[0] if letters else want.label}: {number} {unit}`"
    return f"{an(want.dimension or '')} is written as `{kind.example or f'1 {unit}'}`"


def blame_of_dimension(
    scope: Scope, node: Text, message: str, help: str, formula: Formula | None = None, wanted: Dimension | None = None
) -> Nothing:
    """A dimension that is not the one `wanted`: with the places where its letters are given, once for a letter that alone is to blame.

    A letter that was given without its unit, and is all that stands here, is taken for what is wanted from here on.
    """
    letters = givens_in(scope, node)
    blamed = next((name for name in letters if hangs_on_blamed(scope, name)), "")
    name = blamed or to_blame(scope, letters, formula, wanted)
    plain = scope.dimensions.get(name) == NUMBER and scope.givens[name].unit is None if name else False
    if name:
        scope.blamed.add(name)
    if plain and wanted is not None and name == node.value.strip():
        scope.dimensions[name] = wanted
    cause, shown = (f"dimension of {name}", [name]) if name and (blamed or wanted is not None) else ("", letters[:FEW])
    return scope.fault(node, message, help, "dimension", related=scope.given_at(*shown), cause=cause)


def hangs_on_blamed(scope: Scope, name: str) -> bool:
    """Whether a given has been found wrong, or is made of one that has."""
    value = scope.givens[name].value
    return name in scope.blamed or bool(value is not None and value.symbols() & scope.blamed)


def to_blame(scope: Scope, letters: list[str], formula: Formula | None, wanted: Dimension | None) -> str:
    """The one letter with which a formula would be what is wanted if it were of another kind; '' where several might be wrong."""
    if len(letters) == 1:
        return letters[0]
    plain = [name for name in letters if scope.dimensions.get(name) == NUMBER and scope.givens[name].unit is None]
    if len(plain) == 1:
        return plain[0]
    known = scope.dimensions
    needed = (
        {name: infer(formula, [name], {**known, name: None}, wanted) for name in letters} if formula is not None else {}
    )
    fitting = [
        name for name, kind in needed.items() if kind is not None and kind != NUMBER and kind_of(kind) is not None
    ]
    return fitting[0] if len(fitting) == 1 else ""


def as_letter(scope: Scope, span: Span, want: Want, quantity: UnitValue) -> Formula:
    """The exact number where textbooks print it, else a letter of its own."""
    if quantity.value == ZERO:
        return ZERO
    share = share_of_pi(quantity.value)
    if quantity.dimension == ANGLE and share is not None and share % STEP == 0:
        return multiple_of_pi(share)
    plain = quantity.dimension == NUMBER and (want.dimension != "number" or quantity.value == ONE)
    if not want.letter or plain:
        return quantity.value
    return scope.automatic(want.letter, want.owner, quantity, span, want.hint)


def share_of_pi(formula: Formula) -> Fraction | None:
    """q where the formula is q·π, written in any of the usual ways."""
    match formula:
        case Constant():
            return Fraction(1)
        case Negative(operand):
            share = share_of_pi(operand)
            return None if share is None else -share
        case Product((Number(factor), other) | (other, Number(factor))):
            share = share_of_pi(other)
            return None if share is None else factor * share
        case Quotient(numerator, Number(divisor)) if divisor:
            share = share_of_pi(numerator)
            return None if share is None else share / divisor
    return None


def multiple_of_pi(share: Fraction) -> Formula:
    """q·π as textbooks write it: π/6, −π/2, 3 π/4."""
    result = Number(Fraction(abs(share.numerator))) * PI / Number(Fraction(share.denominator))
    return -result if share < 0 else result


def limits_hold(scope: Scope, node: Node, number: float | None, want: Want, text: str) -> bool:
    """Whether a value that has a number is physical."""
    if number is None or not want.limits:
        return True
    wrong = {
        "positive": number <= 0 and "must be positive",
        "nonnegative": number < 0 and "can't be negative",
        "fraction": not 0 <= number <= 1 and "must lie from 0 to 1",
        "acute": not 0 <= number <= math.pi / 2 + 1e-12 and "must lie from 0 to 90 deg",
    }[want.limits]
    if wrong:
        letters = givens_in(scope, node) if isinstance(node, Text) else []
        cause = f"sign of {letters[0]}" if len(letters) == 1 else ""
        message = f"`{want.label}` {wrong}, but this is {quoted(text)}"
        bare = text.rpartition("= ")[2].lstrip("-−")
        signed = number < 0 and want.limits in ("positive", "nonnegative") and LITERAL.fullmatch(bare) is not None
        help = f"leave out the sign: `{letters[0] if letters else want.label}: {bare}`" if signed else ""
        scope.fault(node, message, help, "limits", related=scope.given_at(*letters[:FEW]), cause=cause)
    return not wrong
