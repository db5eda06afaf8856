"""Data: a derivation as plain values for programs: every number as text in its certified digits, every formula in two notations.

A formula is {"text": as a textbook prints it, "ascii": as a computer algebra system reads it}.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rotsolve.algebra.formula import Formula
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.derivation import Answer, Derivation, Equality, Refusal, Section, Words, in_lines
from rotsolve.page.blocks import equation, unindented
from rotsolve.page.text import plain_text
from rotsolve.page.values import certified_digits, given_equation, machine_number, shown_givens

if TYPE_CHECKING:
    from rotsolve.language.problem import Given


def letters_in(phrase: Words) -> Words:
    """The letters alone of what a phrase says of them."""
    return tuple(part for part in phrase if not isinstance(part, str)) or phrase


def derivation_data(derivation: Derivation, digits: int) -> dict[str, Any]:
    """The derivation as dicts, lists and strings."""
    return {
        "solved": not derivation.refused,
        "title": derivation.title,
        "source": derivation.source,
        "digits": digits,
        "given": [given_data(given) for given in shown_givens(derivation.givens)],
        "conventions": [plain_text(item) for item in derivation.conventions],
        "find": [plain_text(letters_in(item)) for item in derivation.finds],
        "states": [plain_text(item) for item in derivation.states],
        "places": [plain_text(item) for item in derivation.places],
        "events": [plain_text(item) for item in derivation.events],
        "sections": [section_data(section) for section in derivation.sections],
        "answers": [answer_data(answer, digits) for answer in derivation.answers],
        "refused": [refusal_data(refusal) for refusal in derivation.refused],
        "second_solution": [section_data(section) for section in derivation.second],
        "remarks": [plain_text(words) for words in derivation.insights],
        "checks": [{"text": plain_text(check.words), "holds": check.holds} for check in derivation.checks],
        "confirmed": [
            {"name": item.name, "confirmed": item.holds, "reason": item.why} for item in derivation.confirmed
        ],
        "equations_written": derivation.equations_written,
        "equations_used": derivation.equations_used,
    }


def refusal_data(refusal: Refusal) -> dict[str, Any]:
    """A question without an answer: its name under `find`, why, where in the file, and what may help."""
    fault = refusal.fault
    place = {} if fault.span is None else {"line": fault.span.line, "column": fault.span.column}
    return {"name": refusal.name, "error": fault.message, "help": fault.help, **place}


def ascii_text(formula: Formula) -> str:
    """The formula as Python and SymPy read it."""
    return to_text(formula, unicode=False).replace("^", "**")


def formula_data(formula: Formula | None) -> dict[str, str] | None:
    """A formula in textbook notation and in that of a computer algebra system."""
    return None if formula is None else {"text": to_text(formula), "ascii": ascii_text(formula)}


def equality_data(equality: Equality) -> dict[str, Any]:
    return {
        "text": plain_text((equation(equality),)),
        "left": ascii_text(equality.left),
        "relation": equality.relation,
        "right": ascii_text(equality.right),
    }


def given_data(given: Given) -> dict[str, Any]:
    return {
        "name": given.name,
        "text": plain_text((given_equation(given),)),
        "si": formula_data(given.value),
        "unit": given.unit.text if given.unit is not None else "",
    }


def section_data(section: Section) -> dict[str, Any]:
    """One instant, phase or event."""
    return {
        "title": section.title,
        "forces": [
            {
                "body": line.body,
                "forces": [plain_text(item) for item in line.forces],
                "positive": line.positive,
                "remarks": [plain_text(item) for item in line.remarks],
            }
            for line in section.forces
        ],
        "remarks": [" ".join(plain_text(unindented(line)) for line in in_lines(item)) for item in section.remarks],
        "laws": [
            {
                "number": law.number,
                "law": law.law,
                "equation": equality_data(law.equation),
                "remark": plain_text(law.remark),
            }
            for law in section.laws
        ],
        "steps": [
            {
                "sources": move.sources,
                "equations": [equality_data(equality) for equality in move.chain],
                "number": move.number,
                "reason": plain_text(move.reason),
            }
            for move in section.moves
        ],
    }


def answer_data(answer: Answer, digits: int) -> dict[str, Any]:
    """An answer; `value` keeps its sign in the declared sense even where words tell the direction.

    Of a vector `value` is the size, `angle` the degrees to the horizontal where it is slanted, `components` hold x and y. What hangs on
    letters holds under its `conditions`; `otherwise` has the answers under others.
    """
    value, note = certified_digits(answer.value, digits)
    return {
        "name": answer.name,
        "symbol": to_text(answer.symbol),
        "exact": formula_data(answer.formula),
        "value": machine_number(value) or None,
        "note": note,
        "unit": answer.unit.text if answer.unit is not None else "",
        "direction": answer.direction,
        "angle": machine_number(certified_digits(answer.angle, digits)[0]) or None,
        "word": answer.word,
        "remark": plain_text(answer.remark),
        "components": [answer_data(component, digits) for component in answer.components],
        **({"rows": [[entry.name for entry in row] for row in answer.rows]} if answer.rows else {}),
        **({"leading": plain_text(answer.leading)} if answer.leading else {}),
        **({"pointing": plain_text(answer.pointing)} if answer.pointing else {}),
        **({"conditions": [equality_data(one) for one in answer.conditions]} if answer.conditions else {}),
        **({"otherwise": [answer_data(other, digits) for other in answer.otherwise]} if answer.otherwise else {}),
    }
