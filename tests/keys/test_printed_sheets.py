"""Printed sheets: paper, numbers of pages, fields, room, pictures that tell no answer, solutions below their statements, German."""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest
from msgspec.structs import replace

from pages import ROOT
from rotsolve.draw.pictures import picture_of
from rotsolve.keys.problem_set import problem_as_set, set_of_files
from rotsolve.keys.sheets import SheetProblem
from rotsolve.keys.variants import worked_variants
from rotsolve.page.printer import in_powers_of_ten
from rotsolve.page.values import certified_digits
from rotsolve.scene.read import read_file

Key = Callable[..., tuple[int, str]]
PICTURED = sorted((ROOT / "problems").rglob("*.yaml"))[::19]


def words_of(file: Path) -> list[str]:
    """The words of each page of a PDF."""
    pypdf = pytest.importorskip("pypdf")
    return [page.extract_text() for page in pypdf.PdfReader(file).pages]


@pytest.mark.parametrize(("paper", "size"), [("a4", (595, 842)), ("letter", (612, 792))])
def test_paper_and_numbers_of_pages(key: Key, page: Path, paper: str, size: tuple[int, int]) -> None:
    pytest.importorskip("typst")
    pypdf = pytest.importorskip("pypdf")
    arguments = ("fall.yaml", "plain.yaml", "-o", "out", "--variants", "2", "--paper", paper, "--room", "6cm")
    assert key(*arguments, "-f", "pdf", "-f", "latex", "-f", "html") == (0, "")
    out = page / "out"
    box = pypdf.PdfReader(out / "sheet-1.pdf").pages[0].mediabox
    assert (round(box.width), round(box.height)) == size
    one, both = (words_of(out / name) for name in ("sheet-1.pdf", "sheets.pdf"))
    assert len(one) > 1 and len(both) == 2 * len(one)
    numbers = [re.findall(r"(\d) / (\d)\s*$", text) for text in (*one, *both)]
    assert numbers == [[(str(place + 1), str(len(one)))] for place in range(len(one))] * 3
    assert f"\\documentclass[{paper}paper]" in (out / "sheet-1.tex").read_text("utf-8")
    css = {"a4": "A4", "letter": "letter"}[paper]
    html = (out / "sheet-1.html").read_text("utf-8")
    assert f"@page {{ size: {css};" in html and 'counter(page) " / " counter(pages)' in html
    assert "content: counter(page);" in (out / "sheets.html").read_text("utf-8")  # a browser numbers all pages on


@pytest.mark.skipif(shutil.which("chromium") is None, reason="no browser here")
def test_a_browser_numbers_the_pages(key: Key, page: Path) -> None:
    key("fall.yaml", "plain.yaml", "-o", "out", "--room", "6cm")
    made = page / "printed.pdf"
    arguments = ["--headless", "--no-sandbox", "--disable-gpu", "--no-pdf-header-footer", f"--print-to-pdf={made}"]
    subprocess.run(
        ["chromium", *arguments, str(page / "out" / "sheet.html")], capture_output=True, check=False, timeout=100
    )
    if not made.exists():
        pytest.skip("the browser does not print here")
    pages = words_of(made)
    assert len(pages) > 1 and all(f"{place} / {len(pages)}" in text for place, text in enumerate(pages, 1))


def test_fields_points_and_room(key: Key, page: Path) -> None:
    sheet = "sheet: H\ncourse: C & D\ndate: May 1\nruled: yes\nroom: 20 mm\nproblems: [fall.yaml, {problem: plain.yaml, room: none}]\n"
    (page / "s.yaml").write_text(sheet, encoding="utf-8")
    assert key("s.yaml", "-o", "out", "-f", "html", "-f", "latex", "-f", "text", "-f", "typst", "--language", "de") == (
        0,
        "",
    )
    html, latex, text, typst = (
        (page / "out" / f"sheet.{end}").read_text("utf-8") for end in ("html", "tex", "txt", "typ")
    )
    assert '<p class="course">C &amp; D</p>' in html and "Datum <i>May 1</i>" in html and "Nummer <i></i>" in html
    assert html.count('<div class="room"><i></i><i></i></div>') == 3 and html.count("<i></i></div>") == 3
    assert latex.count(r"\hrule") == 6 and r"C \& D\par" in latex and "Name~" in latex
    assert typst.count("lines: 2)") == 3 and typst.count("room: 0mm, lines: 0)\n") == 2
    assert "1. Bucket & rope [3 Punkte]" in text and "[1 Punkt]" in text and "Gesucht" in text
    assert "(a) a, Beschleunigung von bucket [1 Punkt]" in text and "a: nach unten" in text


def test_solutions_repeat_the_statement(key: Key, page: Path) -> None:
    assert key(
        "fall.yaml", "-o", "out", "-f", "html", "-f", "text", "-f", "json", "--solutions", "--variants", "2"
    ) == (0, "")
    text = (page / "out" / "solutions-2.txt").read_text("utf-8")
    sheet = (page / "out" / "sheet-2.txt").read_text("utf-8")
    told = [line.strip() for line in sheet.splitlines() if line.startswith("  ")]
    assert told and all(line in text for line in told)
    assert text.index("(c) T, the tension of the rope") < text.index("Solution") < text.index("Laws")
    html = (page / "out" / "solutions-2.html").read_text("utf-8")
    assert html.count("<svg") == 1 and html.index("<svg") < html.index("<h2>Solution</h2>")
    assert '"statement"' in (page / "out" / "solutions.json").read_text("utf-8")


@pytest.mark.parametrize("file", PICTURED, ids=lambda file: file.stem)
def test_pictures_tell_no_answer(file: Path) -> None:
    """No label of a picture is a number that only the answers have."""
    problem = read_file(file)
    figure = picture_of(problem)
    if figure is None:
        return
    ((_, worked),) = worked_variants(problem, 1, 1)
    answers = {certified_digits(answer.value, digits)[0] for answer in worked.answers for digits in (2, 3, 4, 6)}
    told = set(re.findall(r"\d+\.?\d*", " ".join(given.text for given in problem.givens)))
    numbers = {in_powers_of_ten(answer)[0].lstrip("−") for answer in answers if "." in answer} - told
    said = [word for label in figure.labels for word in re.findall(r"\d+\.\d+", label.text)]
    assert numbers.isdisjoint(said)


@pytest.mark.parametrize("file", PICTURED, ids=lambda file: file.stem)
def test_every_answer_belongs_to_one_part(file: Path) -> None:
    (listed,) = set_of_files([str(file)]).problems
    marked = problem_as_set(listed)
    ((_, worked),) = worked_variants(replace(marked, vary=None), 1, 1)
    one = SheetProblem(listed, marked, worked)
    assert [answer for _, answer in one.answers()] == [*worked.answers]
    assert {part.name for part, _ in one.answers()} == {part.name for part in one.parts}
