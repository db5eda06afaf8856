"""Every kind of bad input: all that the command prints about it, and its exit code. The scenes stand in bad_input.txt."""

from __future__ import annotations

import builtins
import re
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from rotsolve import cli

TABLE = Path(__file__).parent / "bad_input.txt"
CASE = re.compile(
    r"^===== (?P<name>.+?) \[(?P<code>\d)\](?P<options>.*)\n(?P<scene>(?s:.*?))^-----\n(?P<message>(?s:.*?))(?=^=====|\Z)",
    re.M,
)
CASES = [case.groupdict() for case in CASE.finditer(TABLE.read_text(encoding="utf-8"))]
Command = Callable[..., tuple[int, str, str]]


@pytest.fixture
def command(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Command:
    """Run a command in a folder of its own: exit code, standard output, standard error."""
    monkeypatch.chdir(tmp_path)

    def run(*arguments: str) -> tuple[int, str, str]:
        with pytest.raises(SystemExit) as left:
            cli.main(list(arguments))
        captured = capsys.readouterr()
        return int(left.value.code or 0), captured.out, captured.err

    return run


def test_the_table_is_read() -> None:
    assert len(CASES) > 60
    assert len({case["name"] for case in CASES}) == len(CASES) == TABLE.read_text(encoding="utf-8").count("\n=====")


@pytest.mark.parametrize("case", CASES, ids=[case["name"] for case in CASES])
def test_message(case: dict[str, str], command: Command, expected: Any) -> None:
    Path("scene.yaml").write_text(case["scene"], encoding="utf-8")
    code, out, message = command("solve", "scene.yaml", *case["options"].split())
    assert out == "" or "\nNot answered\n" in out  # what has an answer beside that is printed
    name, tail = case["name"], f"{case['options']}\n{case['scene']}-----\n"
    heads = (f"===== {name} [{case['code']}]{tail}", f"===== {name} [{code}]{tail}")
    expected.case(TABLE, heads, (case["message"], message))


FILES: list[tuple[str, Any, str]] = [
    ("empty", b"", "error: the file is empty\n  --> x.yaml\nhelp: a scene needs at least `bodies` and `find`\n"),
    (
        "binary",
        bytes(range(256)) * 4,
        "error: this is no text file: it holds a NUL byte\n  --> x.yaml\nhelp: save the file as UTF-8\n",
    ),
    (
        "Latin-1",
        "title: café\nsource: Über Räder\n".encode("latin-1"),
        "error: the byte E9 is not UTF-8: in Latin-1 it is `é`\n  --> x.yaml:1:11\n 1 | title: café\n   |           ^\n"
        "help: save the file as UTF-8\n",
    ),
    (
        "Windows-1252",
        "title: a disc\nsource: “Räder”\n".encode("cp1252"),
        "error: the byte 93 is not UTF-8: in Windows-1252 it is `“`\n  --> x.yaml:2:9\n 2 | source: “Räder”\n   |         ^\n"
        "help: save the file as UTF-8\n",
    ),
    (
        "UTF-16",
        "title: x\n".encode("utf-16"),
        "error: the file is UTF-16, not UTF-8\n  --> x.yaml\nhelp: save the file as UTF-8\n",
    ),
    (
        "UTF-16 without its mark",
        "title: x\n".encode("utf-16-be"),
        "error: the file is UTF-16, not UTF-8\n  --> x.yaml\nhelp: save the file as UTF-8\n",
    ),
    (
        "UTF-32",
        "title: x\n".encode("utf-32"),
        "error: the file is UTF-32, not UTF-8\n  --> x.yaml\nhelp: save the file as UTF-8\n",
    ),
    (
        "10 MB",
        b"# nothing\n" * 1_000_000,
        "error: the file has 10000000 bytes, more than 1000000\n  --> x.yaml\nhelp: a scene is a page of text\n",
    ),
    (
        "deeply nested",
        b"bodies: " + b"[" * 500 + b"]" * 500 + b"\n",
        "error: more than 40 levels inside one another\n  --> x.yaml:1:49\n"
        f" 1 | …{'[' * 100}…\n   | {' ' * 34}^\nhelp: a scene needs no more than ten\n",
    ),
    (
        "brackets",
        b"given: {m: " + b"(" * 300 + b"2*n" + b")" * 300 + b"}\nbodies: {b: {mass: m}}\nfind: {x: b.mass}\n",
        f"error: `{'(' * 59}…` is no formula: nested too deep: at most 60 levels\n  --> x.yaml:1:73\n"
        f" 1 | …{'(' * 100}…\n   | {' ' * 34}^\n",
    ),
]


@pytest.mark.parametrize(("name", "content", "message"), FILES, ids=[name for name, _, _ in FILES])
def test_files(name: str, content: bytes, message: str, command: Command) -> None:
    Path("x.yaml").write_bytes(content)
    start = time.monotonic()
    code, out, err = command("solve", "x.yaml")
    assert (code, out, err) == (2, "", message)
    assert time.monotonic() - start < 2


def test_an_alias_bomb_is_refused_at_once(command: Command) -> None:
    lines = ["a0: &a0 [x, x, x, x, x, x, x, x, x]"]
    lines += [f"a{k}: &a{k} [{', '.join([f'*a{k - 1}'] * 9)}]" for k in range(1, 12)]
    Path("x.yaml").write_text("\n".join(lines) + "\nbodies: {b: *a11}\nfind: {x: b.mass}\n")
    start = time.monotonic()
    code, out, err = command("solve", "x.yaml")
    assert (code, out) == (2, "")
    assert err.startswith("error: `&a0` is a YAML anchor, which scenes don't use\n  --> x.yaml:1:5\n")
    assert time.monotonic() - start < 2


def test_a_file_that_is_not_there(command: Command) -> None:
    assert command("solve", "none.yaml") == (2, "", "error: can't read `none.yaml`: No such file or directory\n")


def test_a_folder(command: Command) -> None:
    Path("folder").mkdir()
    assert command("solve", "folder") == (2, "", "error: there is no scene (*.yaml) in folder\n")


def test_a_file_that_may_not_be_read(command: Command, monkeypatch: pytest.MonkeyPatch) -> None:
    Path("x.yaml").write_text("title: secret\n")
    plain_open = builtins.open

    def refuse(file: Any, *arguments: Any, **options: Any) -> Any:
        if file == "x.yaml":
            raise PermissionError(13, "Permission denied")
        return plain_open(file, *arguments, **options)

    monkeypatch.setattr(builtins, "open", refuse)
    assert command("solve", "x.yaml") == (2, "", "error: can't read `x.yaml`: Permission denied\n")


GOOD = """\
title: Block on a disc
given: {m: 2 kg, M: 5 kg, R: 20 cm}
bodies:
  block: {mass: m, moves: down}
  disc: {shape: disc, mass: M, radius: R, turns: clockwise}
connections: {axle: {axle: disc}, cord: {string: [disc, block]}}
find: {a: block.acceleration, alpha: disc.angular_acceleration}
"""


@pytest.mark.parametrize(
    ("old", "new", "answers"),
    [
        (
            "mass: m, ",
            "",
            [
                "a = 2 m_block g/(M + 2 m_block), down (no number: m_block, the mass of block in line 4, is not given)",
                "α = 2 m_block g/(R (M + 2 m_block)), clockwise (no number: m_block, the mass of block in line 4, is not given)",
            ],
        ),
        (
            ", radius: R",
            "",
            [
                "a = 2 m g/(2 m + M) = 4.356 m/s², down",
                "α = 2 m g/(R_disc (2 m + M)), clockwise (no number: R_disc, the radius of disc in line 5, is not given)",
            ],
        ),
        (
            "m: 2 kg",
            "m: kg",  # a letter by intent: nothing is missing
            ["a = 2 m g/(2 m + M), down", "α = 2 m g/(R (2 m + M)), clockwise"],
        ),
    ],
    ids=["mass", "radius", "letter"],
)
def test_what_is_left_out_is_a_letter_and_the_answer_says_so(
    old: str, new: str, answers: list[str], command: Command
) -> None:
    Path("x.yaml").write_text(GOOD.replace(old, new), encoding="utf-8")
    code, out, err = command("solve", "x.yaml")
    part = out[out.index("Answers\n") + 8 : out.index("Remarks\n")]
    assert (code, err) == (0, "")
    assert [" ".join(line.split()) for line in part.splitlines()] == answers


LIFTED = """\
title: Crate lifted
given: {m: 2 kg, F: 50 N}
surfaces: {floor: level}
bodies: {crate: {mass: m, moves: right}}
connections: {base: {contact: [crate, floor]}}
actions: {pull: {force: F, on: crate, direction: 60 deg}}
find: {N: base.normal_force}
"""
PUSHED = """\
title: Crate pushed towards its string
given: {m: 2 kg, n: 1 kg, F: 90 N, I: 0.1 kg m^2, R: 20 cm}
surfaces: {table: level}
bodies:
  crate: {mass: n, moves: right}
  pulley: {inertia: I, radius: R}
  block: {mass: m, moves: down}
connections:
  base: {contact: [crate, table]}
  axle: {axle: pulley}
  cord: {string: [crate, pulley, block]}
actions: {push: {force: F, on: crate, direction: right}}
find: {T: cord.crate.tension}
"""


@pytest.mark.parametrize(
    ("scene", "objection"),
    [
        (LIFTED, "  does not hold: N > 0 for base: crate leaves the surface\n"),
        (PUSHED, "  does not hold: T > 0 for cord: the string goes slack\n"),
    ],
    ids=["contact", "string"],
)
def test_an_answer_that_can_not_be_is_printed_with_the_objection(scene: str, objection: str, command: Command) -> None:
    Path("x.yaml").write_text(scene)
    code, out, err = command("solve", "x.yaml")
    assert (code, err) == (1, "")
    assert "Answers\n" in out
    assert objection in out


@pytest.mark.parametrize(
    ("old", "new", "code"), [("mass: m,", "mas: m,", 2), ("block.acceleration", "block.velocity", 1)]
)
def test_the_command_itself(old: str, new: str, code: int, tmp_path: Path) -> None:
    (tmp_path / "x.yaml").write_text(GOOD.replace(old, new))
    ran = subprocess.run(
        [sys.executable, "-m", "rotsolve", "solve", "x.yaml"], cwd=tmp_path, capture_output=True, text=True
    )
    assert ran.returncode == code and (code == 1) == ("Not answered" in ran.stdout)
    assert ran.stderr.startswith("error: ") and "--> x.yaml:" in ran.stderr and "Traceback" not in ran.stderr


def test_deeper_than_the_parser_reads(command: Command) -> None:
    """The same words, whether our own limit or the parser's comes first: which one does differs between versions of PyYAML."""
    Path("x.yaml").write_bytes(b"bodies: " + b"[" * 5000 + b"]" * 5000 + b"\n")
    code, out, err = command("solve", "x.yaml")
    first, place, *rest = err.splitlines()
    assert (code, out, first) == (2, "", "error: more than 40 levels inside one another")
    assert re.fullmatch(r"  --> x\.yaml:1:\d+", place) and rest[-1] == "help: a scene needs no more than ten"
