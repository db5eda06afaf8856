"""a − a sin² is a cos², also below a root and beside other terms, so that a square shows there."""

from __future__ import annotations

import pytest

from rotsolve.algebra.exact.normal import equal, simplify
from rotsolve.algebra.notation.parse import parse
from rotsolve.algebra.notation.text import to_text

LETTERS = frozenset("MglCsab")


@pytest.mark.parametrize(
    ("written", "told"),
    [
        ("M^2*g^2 - M^2*g^2*sin(q)^2", "M² g² cos² q"),
        ("sqrt(M^2*g^2 - M^2*g^2*sin(q)^2)", "M g |cos q|"),
        ("sqrt(C^2*s^4 + 2*M*C*g*s^2*cos(q) + M^2*g^2 - M^2*g^2*sin(q)^2)", "|M g cos q + C s²|"),
        ("sqrt(a^2 + b^2 - b^2*sin(q)^2)", "√(a² + b² cos² q)"),
        ("sqrt(a^2*sin(q)^2 + b^2 - b^2*sin(q)^2)", "√(a² sin² q + b² cos² q)"),
        ("sqrt(a^2 + b^2 - a^2*sin(q)^2 - b^2*sin(p)^2)", "√(a² cos² q + b² cos² p)"),
        ("sqrt(a + b - a*sin(q)^2*cos(p)^2)", "√(a + b − a cos² p sin² q)"),
        ("sqrt(a - a*sin(q)^2 + b*sin(q)^2 - b*sin(q)^4)", "|cos q| √(a + b sin² q)"),
        ("sqrt(b + a - a*sin(q)^2 + a*sin(q)^4)", "√(a + b − a sin² q cos² q)"),
    ],
)
def test_a_square_of_a_cosine_shows(written: str, told: str) -> None:
    given = parse(written)
    found = simplify(given, order=tuple("MCgsab"), positive=LETTERS)
    assert equal(found, given, LETTERS)
    assert to_text(found) == told
