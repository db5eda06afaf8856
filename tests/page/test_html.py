"""HTML: a page that holds all that it needs, whose formulas an XML parser reads."""

from __future__ import annotations

import re
from functools import cache
from html.parser import HTMLParser
from pathlib import Path
from xml.etree.ElementTree import fromstring

import pytest
from msgspec.structs import replace

from rotsolve.core.derivation import Check, Derivation
from rotsolve.page.derivation import DerivationPage
from rotsolve.page.html import PRINTER
from solutions import solved

PROBLEMS = sorted((Path(__file__).resolve().parents[2] / "problems").rglob("*.yaml"))
VOID = {"meta"}


class Reader(HTMLParser):
    """Notes what is left open, closed twice, or fetched from elsewhere."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.tags: set[str] = set()
        self.fetched: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.add(tag)
        self.fetched += [f"{name}={value}" for name, value in attrs if name in ("src", "href", "xlink:href")]
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


def read(text: str) -> Reader:
    reader = Reader()
    reader.feed(text)
    reader.close()
    assert reader.open == []
    return reader


@cache
def printed(file: Path) -> str:
    return solved(file).to("html")


@pytest.mark.parametrize("file", PROBLEMS, ids=lambda file: file.stem)
def test_the_page_of_every_problem_is_well_formed_and_whole(file: Path) -> None:
    text = printed(file)
    reader = read(text)
    assert {"math", "style", "title", "article"} <= reader.tags
    assert not reader.tags & {"script", "link", "img", "iframe"}
    assert reader.fetched == []
    assert "url(" not in text and "@import" not in text
    formulas = re.findall(r"<math>.*?</math>", text, re.DOTALL)
    assert formulas
    for formula in formulas:
        fromstring(formula)


def test_a_page_of_several_has_the_title_of_the_first(block_on_disc: Derivation, rod_released: Derivation) -> None:
    bodies = [PRINTER.body(DerivationPage(item), 0) for item in (block_on_disc, rod_released)]
    assert f"<title>{block_on_disc.title}</title>" in PRINTER.document(bodies)
    assert PRINTER.document(bodies).count("<article>") == 2
    assert read(PRINTER.document([])).tags == {"html", "head", "meta", "title", "style", "body"}


def test_prose_has_no_markup(block_on_disc: Derivation) -> None:
    derivation = replace(block_on_disc, title="<script>alert('x')</script> & \"so on\"", source="a < b")
    text = PRINTER.document([PRINTER.body(DerivationPage(derivation), 0)])
    assert "script" not in read(text).tags
    assert "&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt; &amp; &quot;so on&quot;</title>" in text
    assert "a &lt; b" in text


def test_a_check_that_fails_stands_out(block_on_disc: Derivation) -> None:
    text = PRINTER.body(DerivationPage(replace(block_on_disc, checks=(Check(("T < 0",), False),))), 0)
    assert '<span class="fault">does not hold:</span> T &lt; 0' in text


def test_a_matrix_has_its_numbers_below_the_exact_entries() -> None:
    text = printed(next(file for file in PROBLEMS if file.stem == "tensor-box"))
    answers = text[text.index("<h2>Answers</h2>") :]
    assert answers.count("<mtable>") == 2
    assert "<mn>0.13</mn>" in answers
    assert "by symmetry the products of inertia vanish" in answers
