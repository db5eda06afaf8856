"""Readings: one held against what is asked: a number, a formula, or a vector by components, by size and direction, or by size alone."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from msgspec.structs import replace

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.formula import ZERO
from rotsolve.grading.comparing.formulas import formula_judged
from rotsolve.grading.comparing.numbers import Typed, measured_unit
from rotsolve.grading.comparing.scalars import Scalar, number_judged
from rotsolve.grading.reading.records import FORMULA, NUMBER, VECTOR, LineReading
from rotsolve.grading.verdict import WRONG, Finding, Remark, all_findings, found
from rotsolve.language.marks import Tolerance

AXES = ("x", "y", "z")


def scalar_judged(reading: LineReading, asked: Scalar) -> Finding:
    """The finding for one reading."""
    if reading.kind == NUMBER and reading.formula is not None:
        return number_judged(Typed(reading.formula, reading.figures, reading.unit), reading.direction, asked)
    if reading.kind == FORMULA and reading.formula is not None:
        meant = None if reading.unit is None else measured_unit(reading.unit, asked.unit, asked.dimension, asked.turns)
        if isinstance(meant, Remark):
            return Finding(WRONG, (meant,))
        return formula_judged(reading.formula, reading.direction, asked, measured=meant is not None)
    return found(WRONG, "form", f"{'a formula' if asked.value is None else 'a number or a formula'} is asked for")


def vector_judged(reading: LineReading, parts: Sequence[Scalar], whole: Scalar | None) -> Finding:
    """The finding for a vector."""
    if reading.kind != VECTOR:
        return size_judged(reading, whole)
    typed = component_readings(reading)
    wanted = [*parts, *([zero_component(parts[0])] if len(parts) == 2 and len(typed) == 3 else [])]
    if len(typed) != len(wanted):
        return found(WRONG, "form", f"{len(wanted)} components are asked for, not {len(typed)}")
    if reading.polar and whole is not None:
        wanted = [of_size(one, whole) for one in wanted]
    finding = components_judged(typed, wanted)
    points = finding.outcome == WRONG and not finding.flaws and any(part.directed for part in parts)
    if points and components_judged([negated(part) for part in typed], wanted).right:
        return found(WRONG, "sign", "it points the other way")
    return finding


def components_judged(typed: Sequence[LineReading], wanted: Sequence[Scalar]) -> Finding:
    """Every component by itself, strictly: the sign of one alone is no convention."""
    strict = [replace(one, directed=False) for one in wanted]
    findings = [scalar_judged(part, one) for part, one in zip(typed, strict, strict=True)]
    if len(wanted) <= len(AXES):
        findings = [with_axis_name(finding, axis) for finding, axis in zip(findings, AXES, strict=False)]
    return all_findings(findings)


def with_axis_name(finding: Finding, axis: str) -> Finding:
    """What is said of a component that is wrong, with its name in front."""
    if finding.outcome != WRONG or finding.flaws:
        return finding
    remarks = [replace(one, words=(f"{axis} component: ", *one.words)) for one in finding.remarks]
    return replace(finding, remarks=tuple(remarks))


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


def negated(reading: LineReading) -> LineReading:
    assert reading.formula is not None and reading.kind in (NUMBER, FORMULA)
    return replace(reading, formula=-reading.formula)


def of_size(part: Scalar, whole: Scalar) -> Scalar:
    """A component of a vector that is told by size and angle: its tolerance is a share of the size, not of itself."""
    share = part.marking.tolerance.share
    if share is None or whole.value is None:
        return part
    amount = share * abs(Fraction(whole.value.float)) * whole.unit.factor
    return replace(part, marking=replace(part.marking, tolerance=Tolerance("", amount=amount)))


def zero_component(part: Scalar) -> Scalar:
    """The third component of a vector in the plane: zero."""
    return replace(part, closed=ZERO, value=None if part.value is None else evaluate(ZERO, {}))
