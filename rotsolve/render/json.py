"""JSON: the derivation for programs, with every number as text in its certified digits and every formula in two notations.

A formula is {"text": as a textbook prints it, "ascii": as a computer algebra system reads it}.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from rotsolve.algebra.formula import Formula
from rotsolve.algebra.notation.text import to_text
from rotsolve.core.derivation import Answer, Derivation, Equality, LawLine, Move, Section, Words
from rotsolve.render.layout import release
from rotsolve.render.options import Options
from rotsolve.render.voice import TEXT, certified, figures, machine_number, shown

if TYPE_CHECKING:
    from rotsolve.language.problem import Given


def body(derivation: Derivation, options: Options) -> str:
    """The derivation as one JSON object."""
    return text(data(derivation, options))


def document(bodies: Sequence[str]) -> str:
    """One object alone, several as an array."""
    if len(bodies) == 1:
        return bodies[0]
    return "[\n" + ",\n".join(item.rstrip("\n") for item in bodies) + "\n]\n"


def text(value: dict[str, Any]) -> str:
    return json.dumps(value, ensure_ascii=False, indent=2) + "\n"


def failure(file: str, kind: str, message: str) -> str:
    """The object that stands for a file that could not be solved, among others that were."""
    return text({"file": file, "solved": False, "kind": kind, "error": message})


def data(derivation: Derivation, options: Options) -> dict[str, Any]:
    """The derivation as plain values: dicts, lists and strings."""
    return {
        "file": options.file,
        "solved": True,
        "title": derivation.title,
        "source": derivation.source,
        "digits": options.digits,
        "given": [given_data(given) for given in shown(derivation.givens)],
        "conventions": [words(item) for item in derivation.conventions],
        "find": [words(item) for item in derivation.finds],
        "states": [words(item) for item in derivation.states],
        "sections": [section_data(section) for section in derivation.sections],
        "answers": [answer_data(answer, options.digits) for answer in derivation.answers],
        "checks": [{"text": words(check.words), "holds": check.holds} for check in derivation.checks],
        "equations_written": derivation.equations_written,
        "equations_used": derivation.equations_used,
    }


def words(said: Words) -> str:
    return release(TEXT.words(said))


def ascii_text(formula: Formula) -> str:
    """The formula as Python and SymPy read it."""
    return to_text(formula, unicode=False).replace("^", "**")


def formula_data(formula: Formula | None) -> dict[str, str] | None:
    """A formula in textbook notation and in that of a computer algebra system."""
    return None if formula is None else {"text": to_text(formula), "ascii": ascii_text(formula)}


def equality_data(equality: Equality) -> dict[str, Any]:
    return {
        "text": release(TEXT.equality(equality)),
        "left": ascii_text(equality.left),
        "relation": equality.relation,
        "right": ascii_text(equality.right),
    }


def given_data(given: Given) -> dict[str, Any]:
    return {
        "name": given.name,
        "text": release(TEXT.given(given)),
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
                "forces": [words(item) for item in line.forces],
                "positive": line.positive,
                "remarks": [words(item) for item in line.remarks],
            }
            for line in section.forces
        ],
        "remarks": [words(item) for item in section.remarks],
        "laws": [law_data(law) for law in section.laws],
        "steps": [move_data(move) for move in section.moves],
    }


def law_data(law: LawLine) -> dict[str, Any]:
    return {"number": law.number, "law": law.law, "equation": equality_data(law.equation), "remark": words(law.remark)}


def move_data(move: Move) -> dict[str, Any]:
    return {
        "sources": move.sources,
        "equations": [equality_data(equality) for equality in move.chain],
        "number": move.number,
        "reason": words(move.reason),
    }


def answer_data(answer: Answer, digits: int) -> dict[str, Any]:
    """An answer; `value` keeps its sign in the declared sense even where words tell the direction.

    Of a vector `value` is the size, `angle` the degrees to the horizontal where it is slanted, `components` hold x and y.
    """
    value, note = certified(answer, digits)
    return {
        "name": answer.name,
        "symbol": to_text(answer.symbol),
        "exact": formula_data(answer.formula),
        "value": machine_number(value) or None,
        "note": note,
        "unit": answer.unit.text if answer.unit is not None else "",
        "direction": answer.direction,
        "angle": machine_number(figures(answer.angle, digits)[0]) or None,
        "word": answer.word,
        "remark": words(answer.remark),
        "components": [answer_data(component, digits) for component in answer.components],
        **({"rows": [[entry.name for entry in row] for row in answer.rows]} if answer.rows else {}),
    }
