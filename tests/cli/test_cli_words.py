"""The words of the command line: help, version and usage errors, whole and 80 columns wide."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import rotsolve as package
from rotsolve.cli.solve import LAWS
from rotsolve.page.formats import FORMATS

Run = Callable[..., Any]
EXPECTED = Path(__file__).parent / "expected"


@pytest.mark.parametrize(
    "command", ["", "new", "solve", "draw", "simulate", "key", "check", "elements", "schema", "lsp"]
)
def test_help(rotsolve: Run, command: str, expected: Callable[[Path, str], None]) -> None:
    ran = rotsolve(*filter(None, [command]), "--help")
    assert (ran.code, ran.err) == (0, "")
    expected(EXPECTED / f"help{'-' if command else ''}{command}.txt", ran.out)


def test_version_is_printed(rotsolve: Run) -> None:
    ran = rotsolve("--version")
    assert (ran.code, ran.out, ran.err) == (0, f"rotsolve {package.__version__}\n", "")


def test_without_arguments_the_help_is_shown(rotsolve: Run) -> None:
    ran = rotsolve()
    assert (ran.out + ran.err).startswith("Usage: rotsolve [OPTIONS] COMMAND [ARGS]...\n")


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--law", "hooke"], f"Invalid value for '--law': 'hooke' is not one of {', '.join(LAWS)}"),
        (["-f", "docx"], f"Invalid value for '--format' / '-f': 'docx' is not one of {', '.join(FORMATS)}"),
        (["--show", "all"], "Invalid value for '--show': 'all' is not one of facts, equations, plan, confirm"),
        (["--digits", "0"], "Invalid value for '--digits': 0 is not in the range 1<=x<=50."),
        (["--digits", "few"], "Invalid value for '--digits': 'few' is not a valid int range."),
        (["--width", "3"], "Invalid value for '--width': 3 is not in the range 50<=x<=400."),
        (["--set", "m"], "Invalid value for '--set': 'm' is not of the form NAME=VALUE, as in m=3kg"),
        (["--set", "=3"], "Invalid value for '--set': '=3' is not of the form NAME=VALUE, as in m=3kg"),
        (["--set", "m=1", "--set", "m=2"], "Invalid value for '--set': 'm' is set twice"),
        (
            ["--show", "plan", "-f", "json"],
            "Invalid value for '--show': a stage is printed as text; leave --format out",
        ),
        (["--colour"], "No such option: --colour"),
    ],
)
def test_wrong_usage(rotsolve: Run, arguments: list[str], message: str) -> None:
    ran = rotsolve("solve", "one.yaml", *arguments)
    assert (ran.code, ran.out) == (2, "")
    assert ran.err == (
        f"Usage: rotsolve solve [OPTIONS] {{FILES...}}\nTry 'rotsolve solve -h' for help.\n\nError: {message}\n"
    )


def test_an_unknown_command(rotsolve: Run) -> None:
    ran = rotsolve("resolve")
    assert (ran.code, ran.out) == (2, "")
    assert "No such command 'resolve'" in ran.err


def test_elements(rotsolve: Run) -> None:
    from rotsolve.scene.reference import describe_all, describe_word

    assert rotsolve("elements").out == describe_all() + "\n"
    assert rotsolve("elements", "string").out == describe_word("string") + "\n"
    assert {"lbf", "slug", "knot"} <= set(re.findall(r"`(\w+)`", rotsolve("elements", "units").out))
    assert rotsolve("elements", "spherical", "shell").out == describe_word("spherical shell") + "\n"


def test_an_unknown_element(rotsolve: Run) -> None:
    ran = rotsolve("elements", "strnig")
    assert (ran.code, ran.out) == (2, "")
    assert ran.err.startswith("error: unknown word `strnig`; ")
    assert "string" in ran.err


def test_schema(rotsolve: Run) -> None:
    from rotsolve.scene.schema import json_schema

    ran = rotsolve("schema")
    assert (ran.code, ran.err) == (0, "")
    assert json.loads(ran.out) == json_schema()


def python(code: str, *, cwd: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-c", code], cwd=cwd, capture_output=True, text=True, check=False)


HEAVY = {"sympy", "numpy", "scipy", "rich", "jsonschema", "pygls", "lsprotocol", "asyncio"}
LOADED = f"import sys; print(sorted({HEAVY} & sys.modules.keys()))"


@pytest.mark.parametrize(
    "arguments", [["--help"], ["--version"], ["elements", "disc"], ["schema"], ["new"], ["lsp", "--help"]]
)
def test_commands_import_nothing_heavy(arguments: list[str], tmp_path: Path) -> None:
    code = (
        f"import atexit\natexit.register(lambda: exec({LOADED!r}))\nfrom rotsolve.cli import main\nmain({arguments!r})"
    )
    done = python(code, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stdout.endswith("\n[]\n")


def test_solving_imports_neither_sympy_nor_numpy(tmp_path: Path) -> None:
    scene = Path(__file__).resolve().parents[2] / "problems" / "pulleys" / "block-on-disc.yaml"
    code = f"import atexit\natexit.register(lambda: exec({LOADED!r}))\nfrom rotsolve.cli import main\nmain(['solve', {str(scene)!r}])"
    done = python(code, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert done.stdout.endswith("\n[]\n")


def test_the_package_alone_imports_almost_nothing(tmp_path: Path) -> None:
    done = python("import sys, rotsolve; print([m for m in sys.modules if m.startswith('rotsolve.')])", cwd=tmp_path)
    assert done.stdout == "[]\n"


def test_a_reader_that_goes_away_ends_it_quietly() -> None:
    reader, writer = os.pipe()
    os.close(reader)
    command = [sys.executable, "-m", "rotsolve", "schema"]
    done = subprocess.run(command, stdout=writer, stderr=subprocess.PIPE, check=False)
    os.close(writer)
    assert (done.returncode, done.stderr) == (141, b"")


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="no full device here")
def test_an_output_without_room_is_said() -> None:
    with Path("/dev/full").open("w") as full:
        command = [sys.executable, "-m", "rotsolve", "schema"]
        done = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, text=True, check=False)
    assert (done.returncode, done.stderr) == (2, "error: cannot write the output: No space left on device\n")


def test_python_m_rotsolve(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "rotsolve", "--version"], cwd=tmp_path, capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stdout) == (0, f"rotsolve {package.__version__}\n")


def test_letters_that_an_old_encoding_lacks_do_not_stop_a_page(tmp_path: Path) -> None:
    environment = {**os.environ, "PYTHONIOENCODING": "ascii", "PYTHONUTF8": "0"}
    done = subprocess.run(
        [sys.executable, "-m", "rotsolve", "elements"], cwd=tmp_path, env=environment, capture_output=True, check=False
    )
    assert (done.returncode, done.stderr) == (0, b"")
    assert done.stdout.decode("utf-8")


def test_the_public_names_are_there() -> None:
    assert {"solve", "Solution", "SceneError"} <= set(dir(package))
    assert package.Solution.__name__ == "Solution"
    with pytest.raises(AttributeError, match="module 'rotsolve' has no attribute 'slove'"):
        _ = package.slove
