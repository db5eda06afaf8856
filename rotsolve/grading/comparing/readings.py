"""Readings: one held against what is asked: a number, a formula, or a vector by components, by size and direction, or by size alone.

What is wrong with the components of a vector, or the entries of a matrix, is said by their names.
"""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import combinations, permutations

from msgspec.structs import replace

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.formula import ZERO, Formula
from rotsolve.core.writing import and_joined
from rotsolve.grading.comparing.formulas import formula_judged
from rotsolve.grading.comparing.numbers import Typed, measured_unit
from rotsolve.grading.comparing.scalars import Scalar, number_judged
from rotsolve.grading.reading.records import FORMULA, NUMBER, VECTOR, LineReading
from rotsolve.grading.verdict import RIGHT, WRONG, Finding, Remark, all_findings, found
from rotsolve.language.marks import LENIENT, Tolerance

COMPONENT = "component"  # the kind of a remark on which of the components are wrong
MOST_ORDERED = 3  # components that are tried in other orders
ENTRIES_OF_MATRIX = tuple(one + other for one in "xyz" for other in "xyz")


def scalar_judged(reading: LineReading, asked: Scalar) -> Finding:
    """The finding for one reading."""
    if reading.kind == NUMBER and reading.formula is not None:
        return number_judged(typed_in(reading), reading.direction, asked)
    if reading.kind == FORMULA and reading.formula is not None:
        meant = None if reading.unit is None else measured_unit(reading.unit, asked.unit, asked.dimension, asked.turns)
        if isinstance(meant, Remark):
            return Finding(WRONG, (meant,))
        return formula_judged(reading.formula, reading.direction, asked, measured=meant is not None)
    if reading.polar and reading.polar[0].direction and asked.direction:  # what has a direction in words alone
        return scalar_judged(reading.polar[0], asked)
    wanted = "a formula" if asked.value is None else "a number or a formula"
    return found(WRONG, "form", f"{wanted} is asked for{', not components' if reading.kind == VECTOR else ''}")


def typed_in(reading: LineReading) -> Typed:
    """The number that a reading holds."""
    assert reading.formula is not None
    return Typed(reading.formula, reading.figures, reading.unit, reading.zeros)


def vector_judged(
    reading: LineReading, parts: Sequence[Scalar], whole: Scalar | None, labels: Sequence[str]
) -> Finding:
    """The finding for a vector; `labels` name its components or entries, and numbers those that have no order."""
    if reading.kind != VECTOR:
        return size_judged(reading, whole)
    typed = component_readings(reading)
    wanted = [*parts, *([zero_component(parts[0])] if len(parts) == 2 and len(typed) == 3 else [])]
    if len(typed) != len(wanted):
        return found(WRONG, "form", f"{len(wanted)} components are asked for, not {len(typed)}")
    if reading.polar and whole is not None:
        wanted = [of_size(one, whole) for one in wanted]
    findings = component_findings(typed, wanted)
    finding = all_findings(findings)
    if finding.outcome != WRONG or finding.flaws:
        return finding
    if any(part.directed for part in parts) and components_right([negated(part) for part in typed], wanted):
        return found(RIGHT if parts[0].marking.sign == LENIENT else WRONG, "sign", "it points the other way")
    if all(label.isdigit() for label in labels):
        orders = permutations(typed) if len(typed) <= MOST_ORDERED else ()
        return Finding(RIGHT) if any(components_right(order, wanted) for order in orders) else finding
    names = labels if len(labels) == len(wanted) else [*labels, "z"]
    return exchanged(typed, wanted, names) or with_component_names(findings, names)


def component_findings(typed: Sequence[LineReading], wanted: Sequence[Scalar]) -> list[Finding]:
    """Every component by itself, strictly: the sign of one alone is no convention."""
    size = max((abs(part.value.float) for part in wanted if part.value is not None), default=0.0)
    strict = [replace(nothing_beside(one, size), directed=False) for one in wanted]
    return [scalar_judged(part, one) for part, one in zip(typed, strict, strict=True)]


def components_right(typed: Sequence[LineReading], wanted: Sequence[Scalar]) -> bool:
    return all_findings(component_findings(typed, wanted)).right


def nothing_beside(part: Scalar, size: float) -> Scalar:
    """A component that is nothing: what is left of it by rounding is small beside the largest of the others."""
    share = part.marking.tolerance.share
    if share is None or not size or part.value is None or not part.value.equals(Fraction(0)):
        return part
    return with_margin(part, share * Fraction(size) * part.unit.factor)


def exchanged(typed: Sequence[LineReading], wanted: Sequence[Scalar], names: Sequence[str]) -> Finding | None:
    """What is said where two components are each other's; None where they are not."""
    for one, other in combinations(range(len(typed)), 2) if len(typed) <= MOST_ORDERED else ():
        order = list(typed)
        order[one], order[other] = order[other], order[one]
        if components_right(order, wanted):
            return found(WRONG, COMPONENT, f"the {names[one]} and {names[other]} components are exchanged")
    return None


def with_component_names(findings: Sequence[Finding], names: Sequence[str]) -> Finding:
    """What is said of the components that are wrong, with their names: "the y component has the wrong sign"."""
    said: dict[tuple[Remark, ...], list[str]] = {}
    for name, finding in zip(names, findings, strict=True):
        if finding.outcome == WRONG and not finding.flaws:
            said.setdefault(finding.remarks, []).append(name)
    remarks: list[Remark] = []
    for own, which in said.items():
        if len(which) < len(findings) or any(one.kind == "sign" for one in own):
            remarks += named_remarks(own, which)
        else:
            remarks += own
    others = [one for finding in findings if finding.outcome != WRONG or finding.flaws for one in finding.remarks]
    return Finding(WRONG, tuple(dict.fromkeys((*remarks, *others))))


def named_remarks(own: Sequence[Remark], names: Sequence[str]) -> list[Remark]:
    """The remarks on some components, with their names; of a matrix xy stands for yx too where both are wrong."""
    names = [name for place, name in enumerate(names) if name == name[::-1] or name[::-1] not in names[:place]]
    one_noun, many = ("entry", "entries") if names[0] in ENTRIES_OF_MATRIX else ("component", "components")
    several = len(names) > 1
    whose = f"the {and_joined(names)} {many if several else one_noun}"
    if not own:
        return [Remark(COMPONENT, (f"{whose} {'are' if several else 'is'} wrong",))]
    sign = f"{whose} {'have' if several else 'has'} the wrong sign"
    return [replace(one, words=(sign,) if one.kind == "sign" else (f"{whose}: ", *one.words)) for one in own]


def size_judged(reading: LineReading, whole: Scalar | None) -> Finding:
    """The finding for a vector of which the size is told, and perhaps its direction in words."""
    if whole is None:
        return found(WRONG, "form", "its components are asked for")
    finding = scalar_judged(reading, whole)
    if finding.right and whole.direction and not reading.direction and reading.kind == NUMBER:
        remark = Remark("direction", (f"its direction: {whole.direction}",))
        return replace(finding, remarks=(*finding.remarks, remark))
    return finding


def component_readings(reading: LineReading) -> list[LineReading]:
    """The components of a vector, of a matrix row by row; a unit behind the bracket is that of each that has none."""
    if not reading.parts:
        return [reading]
    found = []
    for part in reading.parts:
        lacks = part.unit is None and (part.parts or part.kind == NUMBER)
        found += component_readings(replace(part, unit=reading.unit) if lacks else part)
    return found


def opposite_vector(reading: LineReading) -> LineReading:
    """A vector that points the other way."""
    return replace(reading, parts=tuple(negated(part) for part in component_readings(reading)))


def negated(reading: LineReading) -> LineReading:
    assert reading.formula is not None and reading.kind in (NUMBER, FORMULA)
    return replace(reading, formula=-reading.formula)


def of_size(part: Scalar, whole: Scalar) -> Scalar:
    """A component of a vector that is told by size and angle: its tolerance is a share of the size, not of itself."""
    share = part.marking.tolerance.share
    if share is None or whole.value is None:
        return part
    return with_margin(part, share * abs(Fraction(whole.value.float)) * whole.unit.factor)


def with_margin(part: Scalar, amount: Formula) -> Scalar:
    """A component that may be off by so much, in SI units."""
    return replace(part, marking=replace(part.marking, tolerance=Tolerance("", amount=amount)))


def zero_component(part: Scalar) -> Scalar:
    """The third component of a vector in the plane: zero."""
    return replace(part, closed=ZERO, value=None if part.value is None else evaluate(ZERO, {}))
