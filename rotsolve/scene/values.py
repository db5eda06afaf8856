"""Values: a scalar as an exact formula in SI units, a literal or arithmetic over givens, with its dimension and limits checked."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Container, Iterator, Mapping

from rotsolve.algebra.certified.ball import evaluate, note
from rotsolve.algebra.formula import ZERO, Call, Formula, Negative, Number, Product, Quotient, Sum, Symbol
from rotsolve.algebra.notation.parse import parse
from rotsolve.algebra.notation.text import to_text
from rotsolve.algebra.notation.tokens import FormulaError
from rotsolve.algebra.units.dimension import (
    ANGLE,
    DIMENSIONS,
    NONE,
    TIME,
    Dimension,
    DimensionError,
    dimension_of,
    fits_everything,
)
from rotsolve.algebra.units.quantities import UnitError, UnitValue, parse_quantity
from rotsolve.core.faults import Span
from rotsolve.core.quantity import QUANTITIES
from rotsolve.language.keys import HIGHEST
from rotsolve.language.problem import TimeValue
from rotsolve.language.words import Hint, an, did_you_mean, hint, quoted
from rotsolve.scene.literals import (
    COMMA,
    EXPRESSION,
    LITERAL,
    NAME,
    Lexeme,
    Want,
    ambiguous,
    as_letter,
    asked_letter,
    blame_of_dimension,
    dimension_holds,
    infer,
    lexemes,
    limits_hold,
    multiple_of_pi,
    names_unit,
    parsed_quantity,
    share_of_pi,
    stand_in,
    unit_below,
    unit_fault,
    whole_literal,
)
from rotsolve.scene.rough import size
from rotsolve.scene.scope import UNKNOWN, Scope
from rotsolve.scene.tree import Node, Text

NUMBER_IN_FRONT = re.compile(r"(.*?[\d.½⅓¼⅔¾⅛]|pi)\s*([^\W\d].*|[°%].*)")  # of a quantity, and its unit
PathReader = Callable[[Text, Lexeme], Formula | None]


def two_ways(sign: str, quantity: str, scope: Scope) -> str:
    """What to write for `/ 2 m` or `^ 2 m`: each proposal can be read in one way only."""
    number, unit = NUMBER_IN_FRONT.fullmatch(quantity).groups()  # type: ignore[union-attr]
    named = set(re.findall(r"[^\W\d]\w*", unit)) <= scope.givens.keys()
    if sign == "/":
        return (
            f"write `/({number}*{unit})` or `/{number}*{unit}`"
            if named
            else f"write `/({quantity})`, or `/{number}*(1 {unit})`"
        )
    return f"write `{sign}{number}*{unit}`" if named else f"write `{sign}{number}*(1 {unit})`"


def expression(scope: Scope, node: Text, want: Want, paths: PathReader | None) -> Formula | None:
    """Ordinary arithmetic over givens; quantities in it become letters, paths are read by `paths`.

    What stands there for a formula of letters without a number is written out, as if the scene said that: d in `d: a - b` hides no sign.
    """
    names = dict.fromkeys((*scope.givens, *want.extra, *(("time",) if want.varies else ())))
    stand_ins: dict[str, Formula] = {}
    text: list[str] = []
    before = ""
    for piece in lexemes(node.value, scope.givens):
        place = node.part(piece.start, piece.end)
        if piece.kind == "quantity" and before in ("/", "^", "**"):
            message = f"`{before} {piece.text}` can be read in two ways"
            return scope.fault(place, message, two_ways(before, piece.text, scope), "ambiguous")
        before = before if piece.kind == "space" else piece.text
        replaced = replacement(scope, node, piece, place, want, names, paths)
        if replaced is None:
            return None
        if isinstance(replaced, Formula):
            name = stand_in(len(stand_ins), len(piece.text))
            stand_ins[name] = replaced
            text.append(name)
        else:
            text.append(replaced)
    try:
        formula = parse("".join(text), {*names, *stand_ins}).substitute({**stand_ins, **scope.made})
        for part in formula.walk():
            if isinstance(part, Quotient):
                note(part.denominator)
                if size(part.denominator, scope.numbers) == 0:
                    return scope.fault(node, f"{quoted(node.value)} divides by zero", kind="formula")
        return formula
    except FormulaError as error:
        formula_fault(scope, node, error, want, names, "".join(text), stand_ins)
    except (ValueError, ZeroDivisionError, RecursionError) as error:
        scope.fault(node, f"{quoted(node.value)} is no formula: {error}", kind="formula")
    return None


def letter_of_number(want: Want, quantity: UnitValue) -> str:
    """The letter of a number within an expression: that of what is wanted where it is one itself, else that of its own kind."""
    wanted = DIMENSIONS.get(want.dimension or "", quantity.dimension)
    if quantity.dimension == NONE or quantity.dimension.matches(wanted):
        return want.letter or "q"
    kinds = (kind.letter for kind in QUANTITIES.values() if kind.dimension == quantity.dimension)
    return next(kinds, want.letter or "q")


def replacement(
    scope: Scope, node: Text, piece: Lexeme, place: Span, want: Want, names: Collection[str], paths: PathReader | None
) -> Formula | str | None:
    """What stands for a piece in the text that is parsed: itself, or a formula for a path or quantity; None after a fault."""
    if piece.kind == "quantity":
        unit = piece.text.lstrip("0123456789.").strip()
        if unit in scope.givens:
            return ambiguous(scope, place, piece.text, unit, None)
        below = unit_below(node.value, piece.end, scope.givens)
        if below:
            return ambiguous(scope, place, f"{piece.text}/{below}", below, None)
        try:
            quantity = parse_quantity(piece.text)
        except UnitError as error:
            return unit_fault(scope, node, error, piece.start)
        share = share_of_pi(quantity.value)
        if share is not None:
            return multiple_of_pi(share)
        return as_letter(scope, place, Want(want.label, None, letter_of_number(want, quantity), want.owner), quantity)
    if piece.kind == "path":
        if paths is not None:
            return paths(node, piece)
        scope.fault(place, f"a path such as {quoted(piece.text)} can't stand here", "use givens and numbers", "formula")
        return None
    if piece.kind == "name" and paths is not None and piece.text not in names:
        owns = scope.kinds.get(piece.text) in ("body", "connection", "action", "event")
        if owns or piece.text in QUANTITIES:  # a path without its quantity; `kinetic_energy` of the whole scene
            return paths(node, piece)
    return piece.text


def formula_fault(
    scope: Scope,
    node: Text,
    error: FormulaError,
    want: Want,
    names: Collection[str],
    text: str,
    stand_ins: Mapping[str, Formula],
) -> None:
    """The parser's complaint at its place, with the letters that exist."""
    span = node.part(error.start, max(error.end, error.start + 1))
    wrong = text[error.start : error.end]
    if not re.fullmatch(NAME, wrong) or wrong in names or wrong in stand_ins:
        message = f"{quoted(node.value)} is no formula: {error.message}"
        scope.fault(span, message, did_you_mean(error.suggestion), "formula")
        return
    kind = scope.kinds.get(wrong)
    letters = [name for name in names if not name.startswith("Zq")]
    if wrong == "time":
        help: str = "only actions and driven hinges vary"
        scope.fault(span, "`time` can't stand here: this value is constant", help, "formula")
    elif kind and kind != "given":
        help = hint("", letters, "givens")
        if kind == "find":
            help = (
                f"a line may name numbers that lines above it answer; else write what `{wrong}` asks for in its place"
            )
        scope.fault(span, f"`{wrong}` is {an(kind)}, not a value", help, "formula")
    elif names_unit(wrong):
        other = next((name for name in letters if name.lower() == wrong.lower()), "")
        choice = f"write `2 {wrong}`, or choose a letter for it"
        help = Hint(f"did you mean `{other}`? else {choice}", other) if other else choice
        scope.fault(span, f"`{wrong}` is a unit without a number", help, "unit", cause=f"{UNKNOWN}{wrong}")
    else:
        scope.unknown(span, wrong, "letter", [*letters, *want.words], "givens")


def read_scalar(scope: Scope, node: Node, want: Want, paths: PathReader | None = None) -> Formula | None:
    """The formula that a scalar writes; None after a fault."""
    if not isinstance(node, Text):
        return scope.fault(node, f"`{want.label}` wants one value, but this is {node.shown}", kind="form")
    if not node.value.strip():
        return scope.fault(node, f"`{want.label}` is empty", kind="form")
    if node.value.strip() == "unknown":
        return asked_letter(scope, node, want)
    literal = LITERAL.fullmatch(node.value)
    if literal and parsed_quantity(node.value.strip()) is None and told_foreign(scope, node):
        return None
    if literal and (result := whole_literal(scope, node, want, (literal["unit"] or "").strip())) is not EXPRESSION:
        return result
    if told_foreign(scope, node):
        return None
    formula = expression(scope, node, want, paths)
    if formula is not None and written_nothing(scope, formula, want):
        formula = ZERO
    if formula is None or not check_dimension(scope, node, formula, want):
        return None
    return formula if check_limits(scope, node, formula, want) else None


def written_nothing(scope: Scope, formula: Formula, want: Want) -> bool:
    """Whether a formula is 0 as it is written, `0*m`, whatever `m` is."""
    known = {name: own for name, own in {**scope.dimensions, **want.extra}.items() if own is not None}
    try:
        return formula.symbols() <= known.keys() and fits_everything(formula, known)
    except DimensionError:
        return False


OPERATORS = str.maketrans("+-*/^()", "\n" * 7)


def plainly_made(text: str, letters: Container[str]) -> bool:
    """Whether a text is made of names and numbers with an operator between any two of them, `2*M`, `L*cos(theta)`, or is a known letter."""
    pieces = [piece for part in text.translate(OPERATORS).split("\n") if (piece := part.strip())]
    names = [piece for piece in pieces if piece.replace(".", "").isidentifier()]
    known = all(name in letters for name in names)  # beside a unit a name may be one too: `3 m/s2`
    made = known or (len(pieces) > 1 and not any(" " in piece for piece in pieces))
    return made and bool(names) and all(piece in names or is_figures(piece) for piece in pieces)


def is_figures(piece: str) -> bool:
    """Whether a piece is a number in figures, `12` or `0.5`, perhaps with one unit, `90 deg`."""
    number, _, unit = piece.partition(" ")
    return number.isascii() and number.replace(".", "", 1).isdigit() and (not unit or names_unit(unit))


def told_foreign(scope: Scope, node: Text) -> bool:
    """Whether a value is one elsewhere, which is said: `12,5 kg`, `1_000`, `.inf`."""
    text = node.value.strip()
    if plainly_made(text, scope.givens):
        return False
    from rotsolve.scene.foreign import foreign_value  # its patterns take 3 ms to be compiled

    if (told := foreign_value(text, scope.givens)) is not None:
        scope.fault(node, *told, "number")
        return True
    if "," not in text or not re.match(COMMA, text):
        return False
    try:
        parse_quantity(node.value)
    except UnitError as error:
        scope.fault(node, error.message, did_you_mean(error.suggestion), "unit")
        return True
    return False


def check_dimension(scope: Scope, node: Text, formula: Formula, want: Want) -> bool:
    """Whether the formula has the dimension that is wanted; a letter of unknown dimension gets it from here."""
    wanted = DIMENSIONS[want.dimension] if want.dimension else None
    known = {**scope.dimensions, **want.extra, "time": TIME}
    missing = [name for name in sorted(formula.symbols()) if known.get(name) is None]
    if missing:  # what sines are taken of is an angle, beside the one that is inferred
        turned = {name for name in missing if name in turned_letters(formula)}
        scope.dimensions.update(dict.fromkeys(turned, ANGLE))
        known.update(dict.fromkeys(turned, ANGLE))
        missing = [name for name in missing if name not in turned]
    if missing:
        found = infer(formula, missing, known, wanted)
        if found is not None:
            scope.dimensions[missing[0]] = found
        return True
    dimension = agreed_dimension(scope, node, formula, known)
    if dimension is None:
        return False
    shown, given = node.value.strip(), scope.givens.get(node.value.strip())
    unit = given.unit.text if given and given.unit else ""
    if given is not None and given.value is not None:
        shown = f"{shown} = {given.text}"
    return dimension_holds(scope, node, want, dimension, shown, unit, formula)


def turned_letters(formula: Formula) -> set[str]:
    """The letters of which sines, cosines or tangents are taken: alone, a number of times, or in a sum, sin(2 q + 30°)."""
    calls = (node for node in formula.walk(Call) if isinstance(node, Call) and node.function in ("sin", "cos", "tan"))
    return {name for call in calls for name in letters_summed(call.arguments[0])}


def letters_summed(value: Formula) -> Iterator[str]:
    """The letters that are terms of a sum, or numbers of times terms, so that they measure what it does."""
    if isinstance(value, Symbol):
        yield value.name
    elif isinstance(value, Quotient) and isinstance(value.denominator, Number):
        yield from letters_summed(value.numerator)
    elif isinstance(value, (Sum, Negative, Product)):
        parts = [part for part in value.children() if not isinstance(part, Number)]
        for part in parts if len(parts) == 1 or isinstance(value, Sum) else ():
            yield from letters_summed(part)


def agreed_dimension(
    scope: Scope, node: Text, formula: Formula, known: Mapping[str, Dimension | None], help: str = ""
) -> Dimension | None:
    """The dimension of a formula; None, with a fault, where its parts don't agree or that of a letter is not known."""
    try:
        found = {name: own for name in formula.symbols() if (own := known.get(name)) is not None}
        return dimension_of(formula, found)
    except DimensionError as error:
        message = as_written(scope, formula, error.message)
        whole = f"the dimensions in {quoted(node.value)} don't agree: {message}"
        return blame_of_dimension(scope, node, whole, help)


def as_written(scope: Scope, formula: Formula, message: str) -> str:
    """The message with letters that the reader made replaced by what the scene says."""
    for name in formula.symbols():
        given = scope.givens.get(name)
        if given is not None and given.automatic:
            message = message.replace(to_text(Symbol(name)), given.text)
    return message


def gaps(formula: Formula, limits: str) -> tuple[Formula, ...]:
    """What is not negative where a value lies within its limits."""
    if not limits or not formula.symbols():
        return ()
    return (formula, HIGHEST[limits] - formula) if limits in HIGHEST else (formula,)


def check_limits(scope: Scope, node: Text, formula: Formula, want: Want) -> bool:
    number = size(formula, scope.numbers) if want.limits else None
    for gap in gaps(formula, want.limits):
        note(gap)
    shown = node.value.strip()
    given = scope.givens.get(shown)
    if given is not None and given.text:
        shown = f"{shown} = {given.text}"
    return limits_hold(scope, node, number, want, shown)


def read_time(text: str) -> TimeValue:
    """`t=2s`, or `2 s` alone. Raises ValueError for what is no time."""
    name, sign, written = (part.strip() for part in text.rpartition("="))
    if (sign and name not in ("t", "time")) or not written:
        raise ValueError(f"{quoted(text)} is no moment; write t=2s")
    found = parsed_time(written, text, "t=2s")
    number = written.removesuffix(found.unit.text).strip() if found.unit is not None else written
    return TimeValue(f"{number} {found.unit.text}" if found.unit is not None else written, found.value)


def read_seconds(text: str) -> float:
    """`10s`, `0.5 min` in seconds. Raises ValueError for what is no time, or not positive."""
    seconds = evaluate(parsed_time(text, text, "10s").value, {}, digits=17).float
    if not seconds > 0:
        raise ValueError(f"{quoted(text)} is not positive; write 10s")
    return seconds


def read_time_of(text: str) -> float:
    """A moment in seconds, of which 0 is the first. Raises ValueError for what is no time."""
    return evaluate(read_time(text).value, {}, digits=17).float


def parsed_time(written: str, text: str, example: str) -> UnitValue:
    """The time that is written in a text; a ValueError shows an example."""
    try:
        found = parse_quantity(written)
    except UnitError as error:
        raise ValueError(f"{quoted(text)}: {error.message}") from None
    if not found.dimension.matches(TIME):
        raise ValueError(f"{quoted(text)} is no time; write {example}")
    return found
