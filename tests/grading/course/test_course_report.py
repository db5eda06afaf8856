"""The folder of a report: whole or not there, run again after an interruption, and harmless in a spreadsheet."""

from __future__ import annotations

import csv
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rotsolve.grading.course.report import folder as writing
from rotsolve.run import delivery
from rotsolve.run.delivery import FORMULA, NUMBER, harmless

Command = Callable[..., Any]
ROWS = "name,a,alpha,T\n" + "".join(f"Student {number},{number} bad,{number},own\n" for number in range(40))


def files(folder: Path) -> dict[str, bytes]:
    """All files of a folder with what is in them."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in folder.rglob("*") if path.is_file()}


STAYS = ("papers.csv", "overrides.csv")  # what runs have in common


def pages(folder: Path) -> dict[str, bytes]:
    """The files that a run writes anew."""
    return {name: content for name, content in files(folder).items() if name not in STAYS}


def test_a_second_run_gives_the_same(made_up: Command) -> None:
    Path("class.csv").write_text(ROWS, encoding="utf-8")
    first = made_up("class.csv", "-o", "report")
    before = files(Path("report"))
    assert len(before) == 40 + 6
    assert made_up("class.csv", "-o", "report") == first
    assert files(Path("report")) == before


@pytest.mark.parametrize("after", [0, 1, 17, 40, 41, 43])
def test_an_interrupted_run_can_be_run_again(made_up: Command, after: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """It leaves whole files only, and no table of marks beside pages of another run."""
    Path("class.csv").write_text(ROWS, encoding="utf-8")
    made_up("class.csv", "-o", "whole")
    made_up("class.csv", "-o", "report", "-f", "markdown")
    count = iter(range(100))

    def interrupted(name: str, text: str) -> int:
        if next(count) == after:
            raise KeyboardInterrupt
        return delivery.write_file(name, text)

    with monkeypatch.context() as patched:
        patched.setattr(writing, "write_file", interrupted)
        ran = made_up("class.csv", "-o", "report")
    assert (ran.code, ran.err) == (130, "interrupted\n")
    left, whole = pages(Path("report")), pages(Path("whole"))
    assert len(left) == after and "marks.csv" not in left
    assert left.items() <= whole.items()
    made_up("class.csv", "-o", "report")
    assert files(Path("report")) == files(Path("whole"))


def test_what_was_killed_while_it_wrote_leaves_nothing(made_up: Command) -> None:
    """Files that were not finished have names of their own, and go with the next run; files of others stay."""
    Path("class.csv").write_text(ROWS, encoding="utf-8")
    made_up("class.csv", "-o", "whole")
    students = Path("report", "students")
    students.mkdir(parents=True)
    for path in (
        students / ".0007-student-6.html.4711.new",
        Path("report", ".marks.csv.4711.new"),
        students / "0099-gone.md",
    ):
        path.write_text("half")
    for path in (students / "notes.txt", Path("report", "letter.md")):
        path.write_text("the teacher's")
    made_up("class.csv", "-o", "report")
    assert files(Path("report")).items() - files(Path("whole")).items() == {
        ("students/notes.txt", b"the teacher's"),
        ("letter.md", b"the teacher's"),
    }


def test_a_process_that_is_interrupted(tmp_path: Path) -> None:
    """Whenever it comes, an interrupt leaves whole files, and the next run gives what one that was not interrupted gives."""
    (tmp_path / "class.csv").write_text("name,a,alpha,T\n" + "Ada,g,g/R,0\n" * 300, encoding="utf-8")
    problem = Path(__file__).resolve().parents[3] / "problems" / "pulleys" / "block-on-disc.yaml"
    words = [sys.executable, "-m", "rotsolve", "check", str(problem), "class.csv", "-o"]
    options: dict[str, Any] = {"cwd": tmp_path, "stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    root = str(Path(__file__).resolve().parents[3])
    options["env"] = {**os.environ, "PYTHONPATH": root}
    assert subprocess.run([*words, "whole"], check=False, timeout=120, **options).returncode == 1
    process = subprocess.Popen([*words, "report"], **options)
    students = tmp_path / "report" / "students"
    for _ in range(6000):
        if process.poll() is not None or (students.is_dir() and any(students.iterdir())):
            break
        time.sleep(0.005)
    process.send_signal(signal.SIGINT)
    process.communicate(timeout=60)
    assert process.returncode in (1, 130)
    left, whole = files(tmp_path / "report"), files(tmp_path / "whole")
    assert left.items() <= whole.items() and len(whole) == 306
    subprocess.run([*words, "report"], check=False, timeout=120, **options)
    assert files(tmp_path / "report") == whole


def test_a_folder_that_may_not_be_made(made_up: Command, monkeypatch: pytest.MonkeyPatch) -> None:
    Path("class.csv").write_text(ROWS, encoding="utf-8")

    def forbidden(self: Path, *arguments: Any, **options: Any) -> None:
        raise PermissionError(13, "Permission denied")

    monkeypatch.setattr(Path, "mkdir", forbidden)
    ran = made_up("class.csv", "-o", "locked/report")
    assert (ran.code, ran.err) == (2, "error: cannot write locked/report: Permission denied\n")


def test_a_folder_below_a_file(made_up: Command) -> None:
    Path("class.csv").write_text(ROWS, encoding="utf-8")
    ran = made_up("class.csv", "-o", "scene.yaml/report")
    assert (ran.code, ran.err) == (2, "error: cannot write scene.yaml/report: Not a directory\n")


def test_a_disk_that_is_full(made_up: Command, monkeypatch: pytest.MonkeyPatch) -> None:
    Path("class.csv").write_text(ROWS, encoding="utf-8")

    def full(self: Path, *arguments: Any, **options: Any) -> int:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "write_bytes", full)
    ran = made_up("class.csv", "-o", "report")
    assert (ran.code, ran.out) == (2, "")
    assert ran.err == "error: cannot write report/papers.csv: No space left on device\n"
    assert not files(Path("report"))


HOSTILE = [
    "=1+1",
    "+1",
    "-1",
    "@SUM(A1)",
    "\t=1",
    "\r=1",
    " =1",
    "＝1",
    "−2",
    "=cmd|' /C calc'!A0",
    "'=1",
    '"=1"',
    "a=1",
    "x;=1",
]


@pytest.mark.parametrize("separator", [",", ";", "\t"])
def test_no_cell_of_the_marks_is_a_formula(made_up: Command, separator: str) -> None:
    with Path("class.csv").open("w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream, delimiter=separator)
        writer.writerow(["name", "variant", "a", "alpha", "T"])
        writer.writerows([text, text, text, text, text] for text in HOSTILE)
        writer.writerows([text, "", f"{text} odd", text, text] for text in HOSTILE)
    made_up("class.csv", "-o", "report")
    rows = list(csv.reader(Path("report/marks.csv").read_text(encoding="utf-8").splitlines(), delimiter=separator))
    assert len(rows) == 2 * len(HOSTILE) + 1 and {len(row) for row in rows} == {13}
    active = [cell for row in rows for cell in row if cell.lstrip().startswith(FORMULA)]
    assert {cell for cell in active if not re.fullmatch(NUMBER, cell)} == set()


def test_harmless_texts_stay_as_they_are() -> None:
    for text in ("Ada Lovelace", "O'Neill", "3,5", "", "a = 3"):
        assert harmless(text) == text
    assert harmless("-3 m/s²") == "'-3 m/s²"


def test_variants_that_do_not_exist_are_said_row_by_row(command: Command) -> None:
    """Without `vary`, beyond the number that was handed out, and where no set of values can be used."""
    rows = "name,variant,a\nAda,,49/9 m/s²\nBob,2,1 m/s²\nEve,two,1 m/s²\nGus,31,1 m/s²\n"
    Path("class.csv").write_text(rows, encoding="utf-8")
    scene = Path("scene.yaml").read_text(encoding="utf-8")
    for vary, bob, gus in (
        ("", "the problem has no `vary`", "the problem has no `vary`"),
        ("vary: {m: 1 kg to 3 kg by 1 kg}\n", None, "there are 30 variants, so none has the number 31"),
        ("vary: {m: 1 kg to 3 kg by 1 kg, where: m > 3 kg}\n", "none of 3 sets of values can be used", "there are 30"),
    ):
        Path("scene.yaml").write_text(scene + vary, encoding="utf-8")
        assert command("class.csv", "--variants", "30", "-o", "report").code == 1
        with Path("report/marks.csv").open(encoding="utf-8", newline="") as stream:
            found = {row["student"]: row for row in csv.DictReader(stream)}
        assert found["Ada"]["marks"] != "" and found["Eve"]["remarks"] == "not marked: `two` is no number of a variant"
        assert bob in found["Bob"]["remarks"] if bob else found["Bob"]["marks"] != ""
        assert gus in found["Gus"]["remarks"] and found["Gus"]["marks"] == ""


def test_a_late_file_with_other_separators_leaves_the_tables_as_they_are(made_up: Command) -> None:
    Path("class.csv").write_text("number;name;a\n1;Ada;?\n", encoding="utf-8")
    Path("late.csv").write_text("number,name,a\n2,Bob,g\n", encoding="utf-8")
    for file in ("class.csv", "late.csv"):
        made_up(file, "-o", "report")
        for table in ("marks.csv", "papers.csv", "overrides.csv"):
            assert ";" in Path("report", table).read_text(encoding="utf-8").splitlines()[0]
    assert ";0,33;" in Path("report/marks.csv").read_text(encoding="utf-8")


def test_nobody_is_missed_whose_row_may_be_of_several(made_up: Command) -> None:
    """A name without a number in a late file is of one of two, and is in that file."""
    Path("class.csv").write_text("number,name,a\n1,Lena,g\n2,Lena,g\n", encoding="utf-8")
    Path("late.csv").write_text("number,name,a\n,Lena,g\n3,Bob,g\n", encoding="utf-8")
    made_up("class.csv", "-o", "report")
    for _ in range(2):
        assert "Not in" not in made_up("late.csv", "-o", "report").out
