"""Values: a scalar as an exact formula in SI units, with its dimension and limits checked.

A quantity written in place becomes an automatic letter (`radius: 20 cm` in disc -> R_disc), except zero, plain numbers
without a letter, and angles that are multiples of 15°, which stay exact numbers.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from fractions import Fraction

from rotsolve.algebra.dimension import Dimension, DimensionError, dimension_of
from rotsolve.algebra.formula import PI, ZERO, Constant, Formula, Negative, Number, Product, Quotient, Symbol
from rotsolve.algebra.parse import FormulaError, parse
from rotsolve.algebra.units import Quantity, UnitError, parse_quantity
from rotsolve.core.faults import Span
from rotsolve.core.quantity import BY_WORD, DIMENSIONS, NUMBER, SYSTEM
from rotsolve.scene.model import Given
from rotsolve.scene.reader import pieces
from rotsolve.scene.reader.dims import an, fits, infer, named
from rotsolve.scene.reader.nodes import List, Node, Text
from rotsolve.scene.reader.rough import rough
from rotsolve.scene.reader.scope import Scope
from rotsolve.scene.words import hint, quoted

LITERAL = re.compile(rf"\s*[-+−]?\s*{pieces.NUMBER}(?:\s*/\s*\d+)?\s*(?P<unit>(?:[^\W\d_]|[°%½]).*)?", re.DOTALL)
EXAMPLES = {"length": "20 cm", "mass": "3 kg", "time": "2 s", "angle": "30 deg", "force": "12 N", "velocity": "4 m/s"}
STEP = Fraction(1, 12)  # 15° in units of π
EXPRESSION = Symbol("an expression after all")
PathReader = Callable[[Text, pieces.Piece], Formula | None]


@dataclass(frozen=True, slots=True)
class Want:
    """What a value is for: the words for messages, its dimension, and how to name a number written in place."""

    label: str
    dimension: str | None = None
    letter: str = ""
    owner: str = ""
    limits: str = ""
    varies: bool = False
    extra: Mapping[str, Dimension] = field(default_factory=dict)
    hint: str = ""


def value(scope: Scope, node: Node, want: Want, paths: PathReader | None = None) -> Formula | None:
    """The formula that a scalar writes; None after a fault."""
    if not isinstance(node, Text):
        found = "a list" if isinstance(node, List) else "a map"
        scope.fault(node, f"`{want.label}` wants one value, but this is {found}", kind="form")
        return None
    if not node.value.strip():
        scope.fault(node, f"`{want.label}` is empty", kind="form")
        return None
    if node.value.strip() == "unknown":
        return unknown(scope, node, want)
    literal = LITERAL.fullmatch(node.value)
    if literal and (result := whole_literal(scope, node, want, (literal["unit"] or "").strip())) is not EXPRESSION:
        return result
    formula = expression(scope, node, want, paths)
    if formula is None or not check_dimension(scope, node, formula, want):
        return None
    return formula if check_limits(scope, node, formula, want) else None


def unknown(scope: Scope, node: Text, want: Want) -> Formula | None:
    """`force: unknown`: a letter that is asked for."""
    if not want.letter:
        scope.fault(node, f"`{want.label}` can't be unknown here", "name it in `given`: `x: unknown`", "form")
        return None
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
        unit_fault(scope, node, error)
        return None
    if unit in scope.givens:
        ambiguous(scope, node, node.value.strip(), unit)
        return None
    return settled(scope, node, want, quantity)


def unit_fault(scope: Scope, node: Text, error: UnitError, shift: int = 0) -> None:
    """The complaint of the unit parser at its place."""
    shift += len(node.value) - len(node.value.lstrip())
    help = f"did you mean `{error.suggestion}`?" if error.suggestion else "write a number and a unit, such as `3 kg m^2`"
    scope.fault(node.part(shift + error.start, shift + max(error.end, error.start + 1)), error.message, help, "unit")


def ambiguous(scope: Scope, place: Node | Span, text: str, unit: str) -> None:
    number = text[: -len(unit)].strip()
    message = f"{quoted(text)} can be read in two ways: `{unit}` is a given and a unit"
    scope.fault(place, message, f"write `{number}*{unit}` for the product, or put the quantity in `given` under a name", "ambiguous")


def settled(scope: Scope, node: Text, want: Want, quantity: Quantity) -> Formula | None:
    """A literal quantity, checked, as a number or an automatic letter."""
    number = rough(quantity.value, {})
    wanted = DIMENSIONS[want.dimension] if want.dimension else None
    zero = quantity.value == ZERO
    if wanted is not None and not fits(quantity.dimension, wanted) and not (zero and quantity.dimension == NUMBER):
        found = "has no unit" if quantity.dimension == NUMBER else f"is {an(named(quantity.dimension))}"
        text = node.value.strip()
        example = EXAMPLES.get(want.dimension or "") if quantity.dimension == NUMBER else None
        help = f"write a unit: `{example}`" if example else ""
        scope.fault(node, f"`{want.label}` wants {an(want.dimension or '')}, but {quoted(text)} {found}", help, "dimension")
        return None
    if not limits_hold(scope, node, number, want, node.value.strip()):
        return None
    return as_letter(scope, node.span, want, quantity)


def as_letter(scope: Scope, span: Span, want: Want, quantity: Quantity) -> Formula:
    """The exact number where textbooks print it, else a letter of its own."""
    if quantity.value == ZERO:
        return ZERO
    share = share_of_pi(quantity.value)
    if quantity.dimension == DIMENSIONS["angle"] and share is not None and share % STEP == 0:
        return times_pi(share)
    if not want.letter or (quantity.dimension == NUMBER and want.dimension != "number"):
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
        case Product((Number(factor), *rest)) if len(rest) == 1:
            share = share_of_pi(rest[0])
            return None if share is None else factor * share
        case Product((first, Number(factor))):
            share = share_of_pi(first)
            return None if share is None else factor * share
        case Quotient(numerator, Number(divisor)) if divisor:
            share = share_of_pi(numerator)
            return None if share is None else share / divisor
    return None


def times_pi(share: Fraction) -> Formula:
    """q·π as textbooks write it: π/6, −π/2, 3 π/4."""
    result = Number(Fraction(abs(share.numerator))) * PI / Number(Fraction(share.denominator))
    return -result if share < 0 else result


def expression(scope: Scope, node: Text, want: Want, paths: PathReader | None) -> Formula | None:
    """Ordinary arithmetic over givens; quantities in it become letters, paths are read by `paths`."""
    names = {*scope.givens, *want.extra, *({"time"} if want.varies else ())}
    stand_ins: dict[str, Formula] = {}
    text = []
    for piece in pieces.pieces(node.value, scope.givens):
        place = node.part(piece.start, piece.end)
        replaced = replacement(scope, node, piece, place, want, paths)
        if replaced is None:
            return None
        if isinstance(replaced, Formula):
            name = pieces.stand_in(len(stand_ins), len(piece.text))
            stand_ins[name] = replaced
            text.append(name)
        else:
            text.append(replaced)
    try:
        return parse("".join(text), names | set(stand_ins)).substitute(stand_ins)
    except FormulaError as error:
        formula_fault(scope, node, error, names, "".join(text), stand_ins)
    except (ValueError, ZeroDivisionError, RecursionError) as error:
        scope.fault(node, f"{quoted(node.value)} is no formula: {error}", kind="formula")
    return None


def replacement(
    scope: Scope, node: Text, piece: pieces.Piece, place: Span, want: Want, paths: PathReader | None
) -> Formula | str | None:
    """What stands for a piece in the text that is parsed: itself, or a formula for a path or quantity; None after a fault."""
    if piece.kind == "quantity":
        unit = piece.text.lstrip("0123456789.").strip()
        if unit in scope.givens:
            ambiguous(scope, place, piece.text, unit)
            return None
        try:
            quantity = parse_quantity(piece.text)
        except UnitError as error:
            unit_fault(scope, node, error, piece.start)
            return None
        share = share_of_pi(quantity.value)
        if share is not None:
            return times_pi(share)
        return as_letter(scope, place, Want(want.label, None, want.letter or "q", want.owner), quantity)
    if piece.kind == "path":
        if paths is not None:
            return paths(node, piece)
        scope.fault(place, f"a path such as {quoted(piece.text)} can't stand here", "use givens and numbers", "formula")
        return None
    if piece.kind == "name" and paths is not None and is_path_word(piece.text) and piece.text not in scope.givens:
        return paths(node, piece)
    return piece.text


def is_path_word(word: str) -> bool:
    """Whether the word alone is a quantity of the whole scene: `kinetic_energy`."""
    return word in BY_WORD and SYSTEM in BY_WORD[word].owners


def formula_fault(
    scope: Scope, node: Text, error: FormulaError, names: set[str], text: str, stand_ins: Mapping[str, Formula]
) -> None:
    """The parser's complaint at its place, with the letters that exist."""
    span = node.part(error.start, max(error.end, error.start + 1))
    wrong = text[error.start : error.end]
    if re.fullmatch(pieces.NAME, wrong) and wrong not in names and wrong not in stand_ins:
        kind = scope.kinds.get(wrong)
        if wrong == "time":
            scope.fault(span, "`time` can't stand here: this value is constant", "only actions and driven hinges vary", "formula")
        elif kind and kind != "given":
            scope.fault(span, f"`{wrong}` is a {kind}, not a value", hint("", sorted(names), "givens"), "formula")
        else:
            scope.fault(span, f"unknown letter {quoted(wrong)}", hint(wrong, sorted(names), "givens"), "unknown")
        return
    help = f"did you mean `{error.suggestion}`?" if error.suggestion else ""
    scope.fault(span, f"{quoted(node.value)} is no formula: {error.message}", help, "formula")


def check_dimension(scope: Scope, node: Text, formula: Formula, want: Want) -> bool:
    """Whether the formula has the dimension that is wanted; a letter of unknown dimension gets it from here."""
    wanted = DIMENSIONS[want.dimension] if want.dimension else None
    known = {**scope.dimensions, **want.extra, "time": DIMENSIONS["time"]}
    missing = [name for name in sorted(formula.symbols()) if known.get(name) is None]
    if missing:
        found = infer(formula, missing, known, wanted)
        if found is not None:
            scope.dimensions[missing[0]] = found
        return True
    try:
        dimension = dimension_of(formula, {name: known[name] for name in formula.symbols()})  # type: ignore[misc]
    except DimensionError as error:
        scope.fault(node, f"the dimensions in {quoted(node.value)} don't agree: {error}", kind="dimension")
        return False
    if wanted is None or fits(dimension, wanted) or formula == ZERO:
        return True
    found_word = "has no unit" if dimension == NUMBER else f"is {an(named(dimension))}"
    help = EXAMPLES.get(want.dimension or "") if dimension == NUMBER else None
    text = f"`{want.label}` wants {an(want.dimension or '')}, but {quoted(node.value)} {found_word}"
    scope.fault(node, text, f"write a unit: `{help}`" if help else "", "dimension")
    return False


def check_limits(scope: Scope, node: Text, formula: Formula, want: Want) -> bool:
    number = rough(formula, scope.numbers) if want.limits else None
    shown = node.value.strip()
    given = scope.givens.get(shown)
    if given is not None and given.text:
        shown = f"{shown} = {given.text}"
    return limits_hold(scope, node, number, want, shown)


def limits_hold(scope: Scope, node: Node, number: float | None, want: Want, text: str) -> bool:
    """Whether a value that has a number is physical."""
    if number is None or not want.limits:
        return True
    wrong = {
        "positive": number <= 0 and "must be positive",
        "nonnegative": number < 0 and "can't be negative",
        "fraction": not 0 <= number <= 1 and "must lie from 0 to 1",
    }[want.limits]
    if wrong:
        scope.fault(node, f"`{want.label}` {wrong}, but this is {quoted(text)}", kind="limits")
    return not wrong
