"""PDF and PNG from the command line: bytes into files and pipes, never to a terminal, and a word where the package is missing."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from rotsolve import cli
from rotsolve.page import press

ROOT = Path(__file__).resolve().parents[2]
SCENE = str(ROOT / "problems" / "pulleys" / "block-on-disc.yaml")
PDF, PNG = b"%PDF-", b"\x89PNG\r\n"
COMMANDS = {  # each asks for what is no text
    "solve": ("solve", SCENE, "-f", "pdf"),
    "key": ("key", SCENE, "-f", "pdf", "-o", "sheets"),
    "check": ("check", SCENE, "-a", "a = g", "-f", "pdf"),
    "draw as PDF": ("draw", SCENE, "-f", "pdf"),
    "draw as PNG": ("draw", SCENE, "-f", "png"),
}


def run(*arguments: str, cwd: Path) -> subprocess.CompletedProcess[bytes]:
    pytest.importorskip("typst")
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    command = [sys.executable, "-m", "rotsolve", *arguments]
    return subprocess.run(command, cwd=cwd, env=environment, capture_output=True, timeout=120, check=False)


@pytest.mark.sampled(2)
@pytest.mark.parametrize("options", [(), ("--jobs", "2")])
def test_several_scenes_are_one_pdf_in_a_file_or_a_pipe(tmp_path: Path, options: tuple[str, ...]) -> None:
    scenes = (SCENE, str(ROOT / "problems" / "pulleys" / "atwood.yaml"))
    ran = run("solve", *scenes, "-o", "page.PDF", *options, cwd=tmp_path)
    assert (ran.returncode, ran.stdout, ran.stderr) == (0, b"", b"")
    content = (tmp_path / "page.PDF").read_bytes()
    assert content.startswith(PDF)
    assert run("solve", *scenes, "-f", "pdf", *options, cwd=tmp_path).stdout == content


def test_sheets_keys_and_solutions(tmp_path: Path) -> None:
    ran = run("key", SCENE, "-o", "sheets", "--solutions", "-f", "pdf", "-f", "csv", cwd=tmp_path)
    assert (ran.returncode, ran.stderr) == (0, b"")
    names = sorted(path.name for path in (tmp_path / "sheets").iterdir())
    assert names == ["key.csv", "key.pdf", "sheet.csv", "sheet.pdf", "solutions.pdf"]
    assert all((tmp_path / "sheets" / name).read_bytes().startswith(PDF) for name in names if name.endswith(".pdf"))


def test_what_a_student_and_a_class_have_handed_in(tmp_path: Path) -> None:
    ran = run("check", SCENE, "-a", "a = g", "-o", "ada.pdf", cwd=tmp_path)
    assert (ran.returncode, ran.stderr) == (1, b"") and (tmp_path / "ada.pdf").read_bytes().startswith(PDF)
    (tmp_path / "class.csv").write_text(
        "student,a,alpha,T\nAda,2 m g/(2 m + M),21.78 rad/s²,10.89 N\n", encoding="utf-8"
    )
    assert run("check", SCENE, "class.csv", "-o", "report", "-f", "pdf", cwd=tmp_path).returncode == 0
    for name in ("summary.pdf", "students/0001-ada.pdf"):
        assert (tmp_path / "report" / name).read_bytes().startswith(PDF)


@pytest.mark.parametrize(("kind", "head"), [("pdf", PDF), ("png", PNG)])
def test_pictures(tmp_path: Path, kind: str, head: bytes) -> None:
    ran = run("draw", SCENE, "-o", f"picture.{kind}", cwd=tmp_path)
    assert (ran.returncode, ran.stdout, ran.stderr) == (0, b"", b"")
    content = (tmp_path / f"picture.{kind}").read_bytes()
    assert content.startswith(head)
    assert run("draw", SCENE, "-f", kind, cwd=tmp_path).stdout == content
    assert run("draw", SCENE, "--free-bodies", "-f", kind, "-o", "folder", cwd=tmp_path).returncode == 0
    assert (tmp_path / "folder" / f"block-on-disc.{kind}").read_bytes().startswith(head)


def refused(capsys: pytest.CaptureFixture[str], command: str) -> tuple[int, str, str]:
    with pytest.raises(SystemExit) as left:
        cli.main(list(COMMANDS[command]))
    said = capsys.readouterr()
    return int(left.value.code or 0), said.out, said.err


@pytest.mark.parametrize("command", COMMANDS)
def test_a_missing_package_is_named(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, command: str
) -> None:
    monkeypatch.setattr(press, "lacks_press", lambda: True)
    code, out, err = refused(capsys, command)
    kind = "PNG" if command.endswith("PNG") else "PDF"
    assert (code, out) == (2, "")
    assert err.endswith(
        f"Error: Invalid value for '--format': a {kind} is made by the package typst, which is not installed: "
        "pip install 'rotsolve[pdf]'\n"
    )


@pytest.mark.parametrize("command", [name for name in COMMANDS if name != "key"])
def test_a_terminal_gets_no_bytes(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch, command: str
) -> None:
    monkeypatch.setattr(press, "lacks_press", lambda: False)
    monkeypatch.setattr(sys.stdout, "isatty", lambda: True)
    code, out, err = refused(capsys, command)
    assert (code, out) == (2, "")
    assert err.endswith("is no text for a terminal; name a file with -o, or lead it into a pipe\n")
