"""`rotsolve key`: its files in every format, whole; what it says of bad problems; and that a run can be made again.

After a wanted change `pytest tests/keys --regenerate` writes `expected/` anew: read the difference.
"""

from __future__ import annotations

import csv
import io
import json
import re
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path
from xml.etree.ElementTree import fromstring

import pytest

from pages import FALL, ROOT
from rotsolve.keys import command
from rotsolve.page import formats
from rotsolve.run.delivery import harmless

EXPECTED = Path(__file__).parent / "expected"
FORMATS = (*(item.name for item in formats.FORMATS.values() if not item.binary), "csv")
SUFFIX = {"csv": "csv"} | {name: item.suffixes[0].removeprefix(".") for name, item in formats.FORMATS.items()}
Key = Callable[..., tuple[int, str]]


def files(folder: Path) -> list[str]:
    return sorted(path.name for path in folder.iterdir())


def rows_of(file: Path) -> list[dict[str, str]]:
    return list(csv.DictReader(io.StringIO(file.read_text("utf-8"), newline="")))


def compare(folder: Path, expected: Path, regenerate: bool) -> None:
    """All files of a folder are those that were written once."""
    if regenerate:
        shutil.rmtree(expected, ignore_errors=True)
        shutil.copytree(folder, expected)
    assert files(folder) == files(expected)
    for name in files(folder):
        assert (folder / name).read_bytes() == (expected / name).read_bytes(), name


@pytest.mark.parametrize("format", FORMATS)
def test_variants_are_written_as_expected(key: Key, page: Path, format: str, regenerate: bool) -> None:
    code, said = key("fall.yaml", "plain.yaml", "-o", "out", "--variants", "2", "--seed", "3", "-f", format)
    assert (code, said) == (0, "")
    compare(page / "out", EXPECTED / f"variants-{format}", regenerate)


@pytest.mark.parametrize("format", FORMATS)
def test_problems_are_written_as_expected(key: Key, page: Path, format: str, regenerate: bool) -> None:
    derived = () if format == "csv" else ("--solutions",)
    code, said = key("fall.yaml", "-o", "out", "-f", format, *derived, "--digits", "6")
    assert (code, said) == (0, "")
    compare(page / "out", EXPECTED / f"plain-{format}", regenerate)


def test_the_names_of_the_files(key: Key, page: Path) -> None:
    assert key("fall.yaml", "-o", "deep/out", "--variants", "11", "--solutions", "-f", "markdown")[0] == 0
    numbers = [f"{number:02}" for number in range(1, 12)]
    own = [f"{word}-{number}.md" for word in ("sheet", "solutions") for number in numbers]
    assert files(page / "deep" / "out") == sorted([*own, "key.md", "sheets.md"])


def test_a_sheet_tells_no_answer_and_no_source(key: Key, page: Path) -> None:
    key("fall.yaml", "-o", "out", "-f", "markdown", "-f", "html", "-f", "csv", "-f", "json", "-f", "latex")
    for name in ("sheet.md", "sheet.html", "sheet.csv", "sheet.json", "sheet.tex"):
        text = (page / "out" / name).read_text("utf-8")
        assert "4.356" not in text and "the answer is" not in text


def test_every_sheet_and_key_has_the_number_of_its_variant(key: Key, page: Path) -> None:
    key("fall.yaml", "-o", "out", "--variants", "3", "--solutions", "-f", "html", "-f", "json", "-f", "csv")
    out = page / "out"
    for number in (1, 2, 3):
        assert f"<h1>Problems, variant {number} (seed 1)</h1>" in (out / f"sheet-{number}.html").read_text("utf-8")
        assert f"rope [3 points], variant {number} (seed 1)</h1>" in (out / f"solutions-{number}.html").read_text(
            "utf-8"
        )
    assert re.findall(r"<h2>Variant (\d)</h2>", (out / "key.html").read_text("utf-8")) == ["1", "2", "3"]
    assert [sheet["variant"] for sheet in json.loads((out / "key.json").read_text("utf-8"))["sheets"]] == [1, 2, 3]
    rows = rows_of(out / "key.csv")
    assert [row["variant"] for row in rows] == ["1", "1", "1", "2", "2", "2", "3", "3", "3"]


def test_all_formats_tell_the_same_numbers(key: Key, page: Path) -> None:
    key("fall.yaml", "plain.yaml", "-o", "out", "--variants", "4", *(f"-f{name}" for name in FORMATS))
    rows = rows_of(page / "out" / "key.csv")
    texts = {name: (page / "out" / f"key.{SUFFIX[name]}").read_text("utf-8") for name in FORMATS}
    values = [row["value"].lstrip("-") for row in rows if row["value"]]
    assert len(values) == 4 * 5
    for text in texts.values():
        found = re.findall(r"\d+(?:\.\d+)?", text)
        assert set(values) <= set(found)


def test_a_run_is_the_same_again(key: Key, page: Path) -> None:
    arguments = ("fall.yaml", "-o", "out", "--variants", "3", "-f", "html", "-f", "csv")
    key(*arguments)
    before = {name: (page / "out" / name).read_bytes() for name in files(page / "out")}
    (page / "out" / "sheet-2.html").write_text("half of a")
    (page / "out" / "key.csv").unlink()
    key(*arguments)
    assert {name: (page / "out" / name).read_bytes() for name in files(page / "out")} == before


def test_an_interrupted_run_leaves_whole_files_only(key: Key, page: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    written: list[str] = []
    write = command.write_file

    def interrupted(name: str, text: str) -> int:
        if len(written) == 2:
            raise KeyboardInterrupt
        written.append(name)
        return write(name, text)

    monkeypatch.setattr(command, "write_file", interrupted)
    code, said = key("fall.yaml", "-o", "out", "--variants", "5", "-f", "html")
    assert (code, said) == (130, "interrupted\n")
    assert files(page / "out") == ["sheet-1.html", "sheet-2.html"]
    assert all((page / "out" / name).read_text("utf-8").endswith("</html>\n") for name in files(page / "out"))


def test_a_bad_problem_loses_no_other(key: Key, page: Path) -> None:
    code, said = key("open.yaml", "broken.yaml", "fall.yaml", "-o", "out", "-f", "csv")
    assert code == 2
    assert "broken.yaml:1:8" in said and "open.yaml" in said
    assert said.endswith("2 of 3 files not solved: broken.yaml, open.yaml\n")
    rows = rows_of(page / "out" / "key.csv")
    assert {row["problem"] for row in rows} == {"fall"}


def test_nothing_is_written_where_nothing_is_solved(key: Key, page: Path) -> None:
    assert key("open.yaml", "-o", "out")[0] == 1
    assert not (page / "out").exists()


@pytest.mark.parametrize(
    ("arguments", "code", "said"),
    [
        (
            ("plain.yaml", "-o", "out", "--variants", "2"),
            2,
            "error: none of these problems says under `vary` what may vary",
        ),
        (("fall.yaml", "-o", "fall.yaml"), 2, "error: cannot make the folder fall.yaml: File exists"),
        (("fall.yaml", "-o", "out", "--solutions", "-f", "csv"), 2, "error: derivations have no place in CSV"),
        (("-", "-o", "out"), 2, "error: keys are made of files"),
        (("none.yaml", "-o", "out"), 2, "error: can't read `none.yaml`: No such file or directory"),
        (("fall.yaml", "-o", "out", "-f", "docx"), 2, "Usage:"),
        (("fall.yaml", "-o", "out", "--variants", "0"), 2, "Usage:"),
        (("fall.yaml",), 2, "Usage:"),
    ],
)
def test_wrong_usage_is_said(key: Key, arguments: tuple[str, ...], code: int, said: str) -> None:
    found, message = key(*arguments)
    assert found == code
    assert message.startswith(said), message


def test_repeated_variants_are_noted(key: Key) -> None:
    code, said = key("fall.yaml", "-o", "out", "--variants", "12", "-f", "csv")
    assert (code, said) == (0, "note: fall.yaml has 9 different variants: from 10 on they come again\n")


def test_problems_of_one_name_are_told_apart(key: Key, page: Path) -> None:
    (page / "more").mkdir()
    (page / "more" / "fall.yaml").write_text(FALL, encoding="utf-8")
    key("fall.yaml", "more", "-o", "out", "-f", "csv")
    rows = rows_of(page / "out" / "key.csv")
    assert [row["problem"] for row in rows] == ["fall"] * 3 + ["more/fall"] * 3


@pytest.mark.parametrize(
    ("text", "safe"),
    [
        ("=1+1", "'=1+1"),
        ("@SUM(A1)", "'@SUM(A1)"),
        ("-A1", "'-A1"),
        ("+1e", "'+1e"),
        ("\t=1", "'\t=1"),
        ("-4.5e-05", "-4.5e-05"),
        ("-12.73", "-12.73"),
        ("block", "block"),
        ("−½ M", "−½ M"),
    ],
)
def test_no_cell_is_a_formula(text: str, safe: str) -> None:
    assert harmless(text) == safe


def test_no_cell_of_a_hostile_title_is_a_formula(key: Key, page: Path) -> None:
    (page / "fall.yaml").write_text(FALL.replace("Bucket & rope", "=HYPERLINK(1)"), encoding="utf-8")
    key("fall.yaml", "-o", "out", "-f", "csv")
    (row,) = rows_of(page / "out" / "sheet.csv")
    assert row["title"] == "'=HYPERLINK(1)"


def test_the_formulas_of_all_pages_are_well_formed(key: Key, page: Path) -> None:
    folders = [str(ROOT / "problems" / name) for name in ("hinged", "inertia", "rolling")]
    assert key(*folders, "-o", "out", "-f", "html")[0] == 0
    for name in ("sheet.html", "key.html"):
        formulas = re.findall(r"<math>.*?</math>", (page / "out" / name).read_text("utf-8"), re.DOTALL)
        assert len(formulas) > 500
        for formula in formulas:
            fromstring(formula)


@pytest.mark.skipif(shutil.which("pdflatex") is None, reason="no LaTeX here")
def test_latex_compiles(key: Key, page: Path) -> None:
    key(str(ROOT / "problems" / "inertia"), str(ROOT / "problems" / "pulleys"), "-o", "out", "-f", "latex")
    key("fall.yaml", "plain.yaml", "-o", "out", "-f", "latex", "--variants", "2", "--solutions")
    for name in files(page / "out"):
        done = subprocess.run(
            ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", name],
            cwd=page / "out",
            capture_output=True,
            check=False,
        )
        assert done.returncode == 0, done.stdout.decode(errors="replace")[-2000:]
