"""Typst and PDF: no words are read as markup, bundled problems compile, each letter has its shape, and the same gives the same bytes."""

from __future__ import annotations

import re
from collections.abc import Iterator
from io import BytesIO
from pathlib import Path
from typing import Any

import pytest
from msgspec.structs import replace

from rotsolve.core.derivation import Check, Derivation
from rotsolve.page import press
from rotsolve.page.blocks import (
    GOOD,
    AssessedText,
    AssessedTexts,
    Bullet,
    Bullets,
    FixedPage,
    Note,
    Paragraph,
    Styled,
    Table,
    Title,
)
from rotsolve.page.derivation import DerivationPage
from rotsolve.page.formats import format_named
from rotsolve.page.typst import PRINTER
from solutions import solved

PROBLEMS = sorted((Path(__file__).resolve().parents[2] / "problems").rglob("*.yaml"))
MARKED = (
    '#panic() $x$ *b* _i_ [c](d) @ref <label> // gone /* gone too */ \\ \\n \\u{41} `raw` ~ -- --- -? ... "q" https://a.b {x}',
    "= no heading",
    "- no item",
    "+ no item",
    "/ no: term",
    "1. no number",
    "#strong[x];",
    "]",
    "[",
    "\\",
    "$",
    '"',
    "//",
    "line\nline",
    "bell\x07",
)


def pages_of(pdf: bytes) -> Any:
    return pytest.importorskip("pypdf").PdfReader(BytesIO(pdf)).pages


def text_of(pdf: bytes) -> str:
    """The words of all pages, with plain quotes and without blanks."""
    text = "".join(page.extract_text() for page in pages_of(pdf))
    return re.sub(r"\s", "", text.translate(str.maketrans("‘’“”", "''\"\"")))


def compiled(*content: Any) -> bytes:
    pytest.importorskip("typst")
    made = format_named("pdf").file([PRINTER.body(FixedPage(content), 0)])
    assert isinstance(made, bytes) and made.startswith(b"%PDF-")
    return made


@pytest.mark.parametrize("words", MARKED)
def test_words_are_printed_as_they_are_written(words: str) -> None:
    """As a title, as a sentence, in bold, as code, in lists, in tables, and behind each other."""
    phrase = (words, Styled("strong", words), words, Styled("name", words), words, Styled("code", words), words)
    row = AssessedText((words,), words, GOOD, words, words, (Note((words,), 0, 1),), words)
    listed = Bullets((Bullet((words,), (Bullet(phrase),), (words, words)),))
    table = Table((words, words), (((words,), (words,)),), (words,))
    pdf = compiled(Title(1, phrase), Paragraph(phrase), Paragraph((words,)), listed, table, AssessedTexts((row,)))
    said = re.sub(r"\s|\x07", "", words)
    assert text_of(pdf).count(said) >= 7 + 7 + 1 + 1 + 7 + 2 + 4 + 3


def test_a_mark_behind_a_formula_belongs_to_no_formula(block_on_disc: Derivation) -> None:
    formula = block_on_disc.answers[0].symbol
    assert text_of(compiled(Paragraph((formula, "_1^2 (b) [c] ;", formula, "(1)"))))


def test_a_check_that_fails_stands_out(block_on_disc: Derivation) -> None:
    text = PRINTER.body(DerivationPage(replace(block_on_disc, checks=(Check(("T < 0",), False),))), 0)
    assert "- #fault[does not hold:]; T \\< 0" in text


@pytest.mark.sampled(12)
@pytest.mark.parametrize("file", PROBLEMS, ids=lambda file: file.stem)
def test_pages_of_problems_compile_with_all_their_letters_and_numbers(file: Path) -> None:
    pytest.importorskip("typst")
    solution = solved(file)
    pdf = solution.pdf()
    text = text_of(pdf)
    assert not [code for page in pages_of(pdf) for code in codes(page, page.get_contents()) if code == b"\0\0"]
    values = [answer.value for answer in solution.answers.values() if answer.value and "e" not in answer.value]
    assert not [value for value in values if value.replace("-", "−") not in text]


def codes(holder: Any, stream: Any) -> Iterator[bytes]:
    """The codes of all letters in a page and in the pictures on it; zero is that of a letter which its font lacks."""
    from pypdf.generic import ContentStream

    for operands, operator in ContentStream(stream, None).operations:
        texts = {b"Tj": operands, b"TJ": operands[:1] and operands[0]}.get(operator, ())
        raw = b"".join(text.original_bytes for text in texts if hasattr(text, "original_bytes"))
        yield from (raw[place : place + 2] for place in range(0, len(raw), 2))
    for inner in (holder.get("/Resources", {}).get("/XObject") or {}).values():
        if inner.get_object().get("/Subtype") == "/Form":
            yield from codes(inner.get_object(), inner.get_object())


def test_the_same_pages_are_the_same_bytes(crowded: Derivation) -> None:
    pages = DerivationPage(crowded), DerivationPage(crowded)
    first, second = (compiled(*page.blocks()) for page in pages)
    assert first == second and b"CreationDate" not in first


def test_no_formula_is_cut_at_the_margin(crowded: Derivation) -> None:
    """Neither one of many terms nor one of a single fraction wider than the page."""
    terms = " + ".join(f"m{number} g sin(theta{number})" for number in range(30))
    from rotsolve.algebra.notation.parse import parse
    from rotsolve.page.blocks import AnswerRow, Answers

    rows = tuple(AnswerRow(parse("a"), (parse(text),)) for text in (terms, f"({terms})/({terms})", f"sqrt({terms})"))
    pypdf = pytest.importorskip("pypdf")
    pdf = compiled(Answers(rows))
    ends: list[float] = []
    for page in pypdf.PdfReader(BytesIO(pdf)).pages:
        page.extract_text(visitor_text=lambda text, _, place, *rest: ends.append(place[4]))
    assert max(ends) < 595 - 65


def test_what_is_missing_is_named(block_on_disc: Derivation, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "typst", None)
    with pytest.raises(ModuleNotFoundError, match=re.escape("pip install 'rotsolve[pdf]'")):
        press.printed_document("")
