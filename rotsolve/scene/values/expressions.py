"""Expressions: ordinary arithmetic over givens, with the paths and quantities that stand in it."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Mapping

from rotsolve.algebra.certified.witness import note
from rotsolve.algebra.formula import Formula, Quotient
from rotsolve.algebra.notation.parse import parse
from rotsolve.algebra.notation.tokens import FormulaError
from rotsolve.algebra.units.quantities import UnitError, parse_quantity
from rotsolve.core.faults import Span
from rotsolve.core.quantity import BY_WORD
from rotsolve.language.words import hint, quoted
from rotsolve.scene.tree.nodes import Text
from rotsolve.scene.values import pieces
from rotsolve.scene.values.dims import an
from rotsolve.scene.values.literals import Want, ambiguous, as_letter, share_of_pi, times_pi, unit_fault
from rotsolve.scene.values.rough import size
from rotsolve.scene.values.scope import Scope

PathReader = Callable[[Text, pieces.Piece], Formula | None]


def expression(scope: Scope, node: Text, want: Want, paths: PathReader | None) -> Formula | None:
    """Ordinary arithmetic over givens; quantities in it become letters, paths are read by `paths`."""
    names = dict.fromkeys((*scope.givens, *want.extra, *(("time",) if want.varies else ())))
    stand_ins: dict[str, Formula] = {}
    text: list[str] = []
    before = ""
    for piece in pieces.pieces(node.value, scope.givens):
        place = node.part(piece.start, piece.end)
        if piece.kind == "quantity" and before in ("/", "^", "**"):
            message = f"`{before} {piece.text}` can be read in two ways"
            scope.fault(place, message, "put the quantity, or the number, in brackets", "ambiguous")
            return None
        before = before if piece.kind == "space" else piece.text
        replaced = replacement(scope, node, piece, place, want, names, paths)
        if replaced is None:
            return None
        if isinstance(replaced, Formula):
            name = pieces.stand_in(len(stand_ins), len(piece.text))
            stand_ins[name] = replaced
            text.append(name)
        else:
            text.append(replaced)
    try:
        formula = parse("".join(text), {*names, *stand_ins}).substitute(stand_ins)
        return None if divides_by_zero(scope, node, formula) else formula
    except FormulaError as error:
        formula_fault(scope, node, error, want, names, "".join(text), stand_ins)
    except (ValueError, ZeroDivisionError, RecursionError) as error:
        scope.fault(node, f"{quoted(node.value)} is no formula: {error}", kind="formula")
    return None


def divides_by_zero(scope: Scope, node: Text, formula: Formula) -> bool:
    for part in formula.walk():
        if not isinstance(part, Quotient):
            continue
        note(part.denominator)
        if size(part.denominator, scope.numbers) == 0:
            scope.fault(node, f"{quoted(node.value)} divides by zero", kind="formula")
            return True
    return False


def replacement(
    scope: Scope,
    node: Text,
    piece: pieces.Piece,
    place: Span,
    want: Want,
    names: Collection[str],
    paths: PathReader | None,
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
    if piece.kind == "name" and paths is not None and piece.text not in names and is_path_word(scope, piece.text):
        return paths(node, piece)
    return piece.text


def is_path_word(scope: Scope, word: str) -> bool:
    """Whether the word alone is a quantity of the whole scene (`kinetic_energy`), or was meant as a path."""
    return word in BY_WORD or scope.kinds.get(word) in ("body", "connection", "action", "event")


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
    if not re.fullmatch(pieces.NAME, wrong) or wrong in names or wrong in stand_ins:
        help = f"did you mean `{error.suggestion}`?" if error.suggestion else ""
        scope.fault(span, f"{quoted(node.value)} is no formula: {error.message}", help, "formula")
        return
    kind = scope.kinds.get(wrong)
    letters = [name for name in names if not name.startswith("Zq")]
    if wrong == "time":
        help = "only actions and driven hinges vary"
        scope.fault(span, "`time` can't stand here: this value is constant", help, "formula")
    elif kind and kind != "given":
        scope.fault(span, f"`{wrong}` is {an(kind)}, not a value", hint("", letters, "givens"), "formula")
    elif pieces.is_unit(wrong):
        scope.fault(
            span, f"`{wrong}` is a unit without a number", f"write `2 {wrong}`, or choose a letter for it", "unit"
        )
    else:
        scope.fault(span, f"unknown letter {quoted(wrong)}", hint(wrong, [*letters, *want.words], "givens"), "unknown")
