"""`rotsolve solve`: what is written where, and the exit code; the engine is a stand-in."""

from __future__ import annotations

import io
import json
import os
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from rotsolve import cli, run
from rotsolve.run.attempt import FileOutcome

Run = Callable[..., Any]

ONE = """\
Scene one.yaml

Find    a

Laws
  (1) Newton's second law, block    m g = m a
Answers
  a = g    = 0.3333
"""
TWO = ONE.replace("one", "two")
BAD = """\
error: unknown body `puley` in a string
  --> bad.yaml
help: did you mean `pulley`?
"""
OPEN = """\
error: 2 equations for 3 unknowns (T, a, α)
  --> open.yaml
"""
BROKEN = (
    "internal error in broken.yaml: ZeroDivisionError: division by zero"
    " (please report it with the scene; ROTSOLVE_DEBUG=1 shows more)\n"
)


def test_a_scene_is_solved(rotsolve: Run) -> None:
    ran = rotsolve("solve", "one.yaml")
    assert (ran.code, ran.out, ran.err) == (0, ONE, "")


def test_several_scenes_are_printed_one_after_the_other(rotsolve: Run) -> None:
    ran = rotsolve("solve", "one.yaml", "two.yaml")
    assert (ran.code, ran.out, ran.err) == (0, f"{ONE}\n{'─' * 72}\n\n{TWO}", "")


def test_one_failing_file_neither_stops_nor_hides_the_rest(rotsolve: Run) -> None:
    ran = rotsolve("solve", "bad.yaml", "one.yaml", "open.yaml", "broken.yaml")
    summary = "3 of 4 files not solved: bad.yaml, open.yaml, broken.yaml\n"
    assert (ran.code, ran.out, ran.err) == (2, ONE, f"{BAD}\n{OPEN}\n{BROKEN}\n{summary}")


def test_a_folder_stands_for_the_scenes_in_it(rotsolve: Run, engine: Any, tmp_path: Path) -> None:
    for path in ("page/b.yaml", "page/inner/c.yml", "page/a.yaml", "page/notes.txt"):
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text("find: [a]\n", encoding="utf-8")
    assert rotsolve("solve", str(tmp_path / "page")).code == 0
    assert [name for name, _ in engine.asked] == ["a.yaml", "b.yaml", "c.yml"]


@pytest.mark.parametrize(
    ("names", "asked"),
    [
        (["page/*.yaml"], ["a.yaml", "b.yaml"]),
        (["p*/**/*.y*ml"], ["a.yaml", "b.yaml", "c.yml"]),
        (["pag[ef]"], ["a.yaml", "b.yaml", "c.yml"]),
        (["page/b.yaml", "page"], ["b.yaml", "a.yaml", "c.yml"]),
        (["page/[1].yaml"], ["[1].yaml"]),
    ],
)
def test_a_pattern_stands_for_the_files_that_fit_and_each_is_solved_once(
    rotsolve: Run, engine: Any, tmp_path: Path, names: list[str], asked: list[str]
) -> None:
    for path in ("page/b.yaml", "page/inner/c.yml", "page/a.yaml", "page/[1].yaml"):
        if "[" not in path or "[1].yaml" in asked:
            (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
            (tmp_path / path).write_text("find: [a]\n", encoding="utf-8")
    assert rotsolve("solve", *names).code == 0
    assert [name for name, _ in engine.asked] == asked


def test_a_pattern_that_nothing_fits_is_said(rotsolve: Run) -> None:
    ran = rotsolve("solve", "none/*.yaml")
    assert (ran.code, ran.out) == (2, "")
    assert ran.err == "error: cannot read none/*.yaml: No such file or directory\n"


def test_a_page_is_written_as_soon_as_it_is_there(
    rotsolve: Run, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    pipeline = sys.modules["rotsolve.pipeline"]
    solved, seen = pipeline.solve, []

    def solve(source: Path, **options: Any) -> Any:
        seen.append(capsys.readouterr().out)
        return solved(source, **options)

    monkeypatch.setattr(pipeline, "solve", solve)
    last = rotsolve("solve", "one.yaml", "two.yaml").out
    assert seen == ["", ONE]
    assert last == f"\n{'─' * 72}\n\n{TWO}"


@pytest.mark.parametrize(
    ("file", "code", "message"),
    [
        ("bad.yaml", 2, BAD),
        ("open.yaml", 1, OPEN),
        ("broken.yaml", 1, BROKEN),
        ("none.yaml", 2, "error: cannot read none.yaml: No such file or directory\n"),
    ],
)
def test_exit_codes(rotsolve: Run, file: str, code: int, message: str) -> None:
    ran = rotsolve("solve", file)
    assert (ran.code, ran.out, ran.err) == (code, "", message)


def test_a_scene_that_uses_a_word_without_physics_is_not_solvable(
    rotsolve: Run, engine: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    from rotsolve.core.faults import Fault, SceneError

    def solve(source: Path, **options: Any) -> None:
        raise SceneError([Fault("`belt` is not solved yet", kind="not yet")], (), "one.yaml")

    monkeypatch.setattr(sys.modules["rotsolve.pipeline"], "solve", solve)
    ran = rotsolve("solve", "one.yaml")
    assert (ran.code, ran.out, ran.err) == (1, "", "error: `belt` is not solved yet\n  --> one.yaml\n")


def test_options_reach_the_engine(rotsolve: Run, engine: Any) -> None:
    options = ("--law", "energy", "--digits", "9", "--at", "t=2s", "--no-confirm")
    rotsolve("solve", "one.yaml", *options, "--set", "m=3kg", "--set", "v = 2 m/s")
    settings = {"m": "3kg", "v": "2 m/s"}
    asked = {"law": "energy", "settings": settings, "digits": 9, "at": "2 s", "confirm": False}
    assert engine.asked == [("one.yaml", asked)]


@pytest.mark.parametrize("stage", ["facts", "equations", "plan"])
def test_an_earlier_stage_is_shown(rotsolve: Run, stage: str) -> None:
    ran = rotsolve("solve", "one.yaml", "--show", stage)
    assert (ran.code, ran.out, ran.err) == (0, f"the {stage}\n", "")


def test_digits(rotsolve: Run) -> None:
    assert rotsolve("solve", "one.yaml", "--digits", "7").out.endswith("= 0.3333333\n")


@pytest.mark.parametrize(
    ("file", "start"),
    [
        ("a.md", "# Scene one.yaml\n"),
        ("a.tex", "\\documentclass{article}\n"),
        ("a.json", '{\n  "file": "one.yaml",\n'),
        ("a.txt", ONE),
        ("a", ONE),
    ],
)
def test_the_name_of_the_output_decides_its_format(rotsolve: Run, file: str, start: str) -> None:
    ran = rotsolve("solve", "one.yaml", "-o", file)
    assert (ran.code, ran.out, ran.err) == (0, "", "")
    assert Path(file).read_text(encoding="utf-8").startswith(start)
    assert sorted(os.listdir()) == sorted([file, "one.yaml", "two.yaml"])


def test_a_format_that_is_asked_for_beats_the_name(rotsolve: Run) -> None:
    assert rotsolve("solve", "one.yaml", "-o", "a.txt", "--format", "markdown").code == 0
    assert Path("a.txt").read_text(encoding="utf-8").startswith("# Scene one.yaml\n")


def test_json_of_several_files_has_one_entry_for_each(rotsolve: Run) -> None:
    ran = rotsolve("solve", "one.yaml", "bad.yaml", "--format", "json")
    first, second = json.loads(ran.out)
    assert (ran.code, ran.err) == (2, f"{BAD}\n1 of 2 files not solved: bad.yaml\n")
    assert (first["file"], first["solved"], first["answers"][0]["value"]) == ("one.yaml", True, "0.3333")
    assert second == {"file": "bad.yaml", "solved": False, "kind": "scene", "error": BAD.rstrip("\n")}


def test_the_output_stays_as_it_was_when_nothing_is_solved(rotsolve: Run) -> None:
    Path("a.txt").write_text("before")
    assert rotsolve("solve", "bad.yaml", "-o", "a.txt").code == 2
    assert Path("a.txt").read_text() == "before"


def test_the_output_stays_as_it_was_when_writing_fails(rotsolve: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    Path("a.txt").write_text("before")

    def replace(self: Path, target: Path) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "replace", replace)
    ran = rotsolve("solve", "one.yaml", "-o", "a.txt")
    assert (ran.code, ran.out, ran.err) == (2, "", "error: cannot write a.txt: No space left on device\n")
    assert Path("a.txt").read_text() == "before"
    assert sorted(os.listdir()) == ["a.txt", "one.yaml", "two.yaml"]


def test_output_into_a_folder_that_is_not_there(rotsolve: Run) -> None:
    ran = rotsolve("solve", "one.yaml", "-o", "none/a.txt")
    assert (ran.code, ran.out, ran.err) == (2, "", "error: cannot write none/a.txt: No such file or directory\n")


def test_output_never_overwrites_a_scene(rotsolve: Run) -> None:
    ran = rotsolve("solve", "one.yaml", "two.yaml", "-o", "./two.yaml")
    assert (ran.code, ran.out) == (2, "")
    assert ran.err == "error: ./two.yaml is a scene to solve; it would be overwritten\n"


def test_output_keeps_a_link_and_the_mode_of_its_file(rotsolve: Run) -> None:
    Path("real.txt").write_text("before")
    Path("real.txt").chmod(0o640)
    Path("link.txt").symlink_to("real.txt")
    assert rotsolve("solve", "one.yaml", "-o", "link.txt").code == 0
    assert Path("link.txt").is_symlink()
    assert Path("real.txt").read_text(encoding="utf-8") == ONE
    assert Path("real.txt").stat().st_mode & 0o777 == 0o640


def test_standard_input(rotsolve: Run, engine: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(b"title: piped")))
    assert rotsolve("solve", "-").out == ONE.replace("one.yaml", "-")


def test_standard_input_that_is_not_text(rotsolve: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(b"\xff\xfe\x00")))
    ran = rotsolve("solve", "-")
    assert (ran.code, ran.out, ran.err) == (
        2,
        "",
        "error: the file is UTF-16, not UTF-8\n  --> standard input\nhelp: save the file as UTF-8\n",
    )


def test_an_internal_error_shows_its_traceback_on_demand(rotsolve: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROTSOLVE_DEBUG", "1")
    ran = rotsolve("solve", "broken.yaml")
    assert ran.code == 1
    assert ran.err.startswith("Traceback (most recent call last):\n")
    assert ran.err.endswith(BROKEN)


def test_an_interrupt_is_said_in_a_word(rotsolve: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    def solve(source: Path, **options: Any) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(sys.modules["rotsolve.pipeline"], "solve", solve)
    ran = rotsolve("solve", "one.yaml")
    assert (ran.code, ran.out, ran.err) == (130, "", "interrupted\n")


class Terminal(io.StringIO):
    """A standard output that says it is a terminal."""

    def isatty(self) -> bool:
        return True

    def fileno(self) -> int:
        raise OSError("no file")


def on_terminal(monkeypatch: pytest.MonkeyPatch, **environment: str) -> str:
    screen = Terminal()
    monkeypatch.setattr("sys.stdout", screen)
    monkeypatch.setenv("TERM", "xterm-256color")
    monkeypatch.delenv("NO_COLOR", raising=False)
    for name, value in environment.items():
        monkeypatch.setenv(name, value)
    with pytest.raises(SystemExit):
        cli.main(["solve", "one.yaml", "two.yaml"])
    return screen.getvalue()


def plain(text: str) -> str:
    import re

    return re.sub(r"\x1b\[[0-9;]*m", "", text)


def test_a_terminal_gets_the_same_text_in_colour(rotsolve: Run, monkeypatch: pytest.MonkeyPatch) -> None:
    text = on_terminal(monkeypatch)
    assert "\x1b[1;32m" in text
    assert plain(text) == f"{ONE}\n{'─' * 72}\n\n{TWO}"


@pytest.mark.parametrize("environment", [{"NO_COLOR": "1"}, {"TERM": "dumb"}])
def test_a_terminal_without_colours_gets_plain_text(
    rotsolve: Run, monkeypatch: pytest.MonkeyPatch, environment: dict[str, str]
) -> None:
    assert on_terminal(monkeypatch, **environment) == f"{ONE}\n{'─' * 72}\n\n{TWO}"


def outcomes(*files: str) -> Iterator[FileOutcome]:
    return (FileOutcome(file, 0, file) for file in files)


def test_a_progress_bar_comes_only_where_it_takes_long(monkeypatch: pytest.MonkeyPatch) -> None:
    files = ("a", "b", "c", "d")
    screen = Terminal()
    monkeypatch.setattr("sys.stderr", screen)
    assert [outcome.file for outcome in run.with_progress(outcomes(*files), 4)] == list(files)
    assert screen.getvalue() == ""
    monkeypatch.setattr(run, "PATIENCE", -1.0)
    assert [outcome.file for outcome in run.with_progress(outcomes("a"), 1)] == ["a"]
    assert screen.getvalue() == ""
    assert [outcome.file for outcome in run.with_progress(outcomes(*files), 4)] == list(files)
    assert "solving" in screen.getvalue()


def test_a_progress_bar_is_gone_while_a_page_is_written(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(run, "PATIENCE", -1.0)
    screen = Terminal()
    monkeypatch.setattr("sys.stderr", screen)
    monkeypatch.setenv("TERM", "xterm-256color")
    for _ in run.with_progress(outcomes("a", "b", "c"), 3):
        shown, hidden = "\x1b[?25l", "\x1b[?25h"  # a live display takes the cursor away, and gives it back
        assert screen.getvalue().count(shown) == screen.getvalue().count(hidden)


def test_no_progress_bar_where_errors_go_to_a_file(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(run, "PATIENCE", -1.0)
    assert len(list(run.with_progress(outcomes("a", "b"), 2))) == 2
    assert capsys.readouterr().err == ""
