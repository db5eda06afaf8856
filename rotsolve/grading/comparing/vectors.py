"""Vectors: one held against another by its components, by size and direction, or, where all is told so, by its size alone."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction

from msgspec.structs import replace

from rotsolve.algebra.certified.ball import evaluate
from rotsolve.algebra.formula import ZERO
from rotsolve.grading.comparing.finding import Finding, found, together
from rotsolve.grading.comparing.readings import judged
from rotsolve.grading.comparing.scalars import Scalar
from rotsolve.grading.reading.records import FORMULA, NUMBER, VECTOR, Reading
from rotsolve.grading.verdict import RIGHT, WRONG
from rotsolve.language.marks import Tolerance

AXES = ("x", "y", "z")


def vector_judged(reading: Reading, parts: Sequence[Scalar], whole: Scalar | None) -> Finding:
    """The finding for a vector."""
    if reading.kind != VECTOR:
        return size_judged(reading, whole)
    typed = entries(reading)
    wanted = [*parts, *([flat(parts[0])] if len(parts) == 2 and len(typed) == 3 else [])]
    if len(typed) != len(wanted):
        return found(WRONG, "form", f"{len(wanted)} components are asked for, not {len(typed)}")
    if reading.polar and whole is not None:
        wanted = [of_size(one, whole) for one in wanted]
    finding = components_judged(typed, wanted)
    points = finding.outcome == WRONG and not finding.flaws and any(part.directed for part in parts)
    if points and components_judged([negated(part) for part in typed], wanted).right:
        return found(WRONG, "sign", "it points the other way")
    return finding


def components_judged(typed: Sequence[Reading], wanted: Sequence[Scalar]) -> Finding:
    """Every component by itself, strictly: the sign of one alone is no convention."""
    strict = [replace(one, directed=False) for one in wanted]
    findings = [judged(part, one) for part, one in zip(typed, strict, strict=True)]
    if len(wanted) <= len(AXES):
        findings = [named(finding, axis) for finding, axis in zip(findings, AXES, strict=False)]
    return together(findings)


def named(finding: Finding, axis: str) -> Finding:
    """What is said of a component that is wrong, with its name in front."""
    if finding.outcome != WRONG or finding.flaws:
        return finding
    remarks = [replace(one, words=(f"{axis} component: ", *one.words)) for one in finding.remarks]
    return replace(finding, remarks=tuple(remarks))


def size_judged(reading: Reading, whole: Scalar | None) -> Finding:
    """The finding for a vector of which the size is told, and perhaps its direction in words."""
    if whole is None:
        return found(WRONG, "form", "its components are asked for")
    finding = judged(reading, whole)
    if finding.right and whole.direction and not reading.direction and reading.kind == NUMBER:
        return Finding(
            RIGHT,
            (*finding.remarks, *found(RIGHT, "direction", f"its direction: {whole.direction}").remarks),
            finding.flaws,
        )
    return finding


def entries(reading: Reading) -> list[Reading]:
    """The components of a vector, of a matrix row by row; a unit behind the bracket is that of each that has none."""
    if not reading.parts:
        return [reading]
    parts = [
        part if part.unit is not None or part.kind != NUMBER else replace(part, unit=reading.unit)
        for part in reading.parts
    ]
    return [
        entry
        for part in parts
        for entry in (entries(replace(part, unit=part.unit or reading.unit)) if part.parts else [part])
    ]


def negated(reading: Reading) -> Reading:
    assert reading.formula is not None and reading.kind in (NUMBER, FORMULA)
    return replace(reading, formula=-reading.formula)


def of_size(part: Scalar, whole: Scalar) -> Scalar:
    """A component of a vector that is told by size and angle: its tolerance is a share of the size, not of itself."""
    share = part.marking.tolerance.share
    if share is None or whole.value is None:
        return part
    amount = share * abs(Fraction(whole.value.float)) * whole.unit.factor
    return replace(part, marking=replace(part.marking, tolerance=Tolerance("", amount=amount)))


def flat(part: Scalar) -> Scalar:
    """The third component of a vector in the plane: zero."""
    return replace(part, closed=ZERO, value=None if part.value is None else evaluate(ZERO, {}))
