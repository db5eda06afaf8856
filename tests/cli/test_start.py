"""The command as a process: files alone need no parser, and give what the parser would have given."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

PULLEYS = Path(__file__).resolve().parents[2] / "problems" / "pulleys"
SCENE = str(PULLEYS / "block-on-disc.yaml")
LOADED = "import atexit, sys\natexit.register(lambda: print('typer' in sys.modules))\n"


def process(entry: str, *arguments: str) -> subprocess.CompletedProcess[str]:
    """A process that starts at the function `main` of a module."""
    code = f"{LOADED}sys.argv[1:] = {list(arguments)!r}\nfrom {entry} import main\nmain()"
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)


@pytest.mark.parametrize("files", [[SCENE], [SCENE, str(PULLEYS / "atwood.yaml")], ["nowhere.yaml"]])
def test_files_alone_need_no_parser(files: list[str]) -> None:
    plain, parsed = process("rotsolve.start", "solve", *files), process("rotsolve.cli", "solve", *files)
    assert plain.stdout.endswith("False\n") and parsed.stdout.endswith("True\n")
    assert (plain.returncode, plain.stderr) == (parsed.returncode, parsed.stderr)
    assert plain.stdout.removesuffix("False\n") == parsed.stdout.removesuffix("True\n")


@pytest.mark.parametrize(
    ("arguments", "code"), [((), 2), (("--version",), 0), (("solve",), 2), (("solve", SCENE, "--law", "energy"), 0)]
)
def test_all_else_is_parsed(arguments: tuple[str, ...], code: int) -> None:
    plain, parsed = process("rotsolve.start", *arguments), process("rotsolve.cli", *arguments)
    assert (plain.returncode, plain.stdout, plain.stderr) == (parsed.returncode, parsed.stdout, parsed.stderr)
    assert plain.returncode == code and plain.stdout.endswith("True\n")
