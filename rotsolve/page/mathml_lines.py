"""Lines of MathML: a long formula in split_at_signs between which a browser may end a line, before its signs at the unnested level."""

from __future__ import annotations

from collections.abc import Iterator
from xml.etree import ElementTree

LONG = 600  # characters of a formula that may be too wide for a page
BEFORE = frozenset("+−=≤≥<>≈≠")  # signs before which a line may end


def math_pieces(inner: str) -> str:
    """Mathematics that stands on a line of its own: one piece, or several where it is long."""
    if not inner:
        return ""
    if len(inner) <= LONG:
        return f"<math>{inner}</math>"
    return " ".join(
        f"<math>{piece}</math>" for piece in split_at_signs(ElementTree.fromstring(f"<math>{inner}</math>"))
    )


def split_at_signs(formula: ElementTree.Element) -> Iterator[str]:
    """The children of a formula, in groups that begin with a sign."""
    group: list[str] = []
    for child in unnested(formula):
        sign = child.tag == "mo" and child.text in BEFORE
        if sign and group:
            yield "".join(group)
            group = []
        if sign:
            child.set("form", "infix")  # at the beginning of a piece it would else stand close to what follows
        group.append(ElementTree.tostring(child, "unicode").rstrip())
    if group:
        yield "".join(group)


def unnested(formula: ElementTree.Element) -> Iterator[ElementTree.Element]:
    """The children of a formula, those of a sum or an equality among them instead of it."""
    for child in formula:
        if child.tag == "mrow" and any(one.tag == "mo" and one.text in BEFORE for one in child[1:]):
            yield from child
        else:
            yield child
