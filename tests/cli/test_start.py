"""The command as a process: files alone need no parser, and give what the parser would have given."""

from __future__ import annotations

import os
import py_compile
import subprocess
import sys
from importlib.machinery import PathFinder, SourceFileLoader
from importlib.util import module_from_spec
from pathlib import Path

import pytest

import rotsolve
from rotsolve.lean import Near

PULLEYS = Path(__file__).resolve().parents[2] / "problems" / "pulleys"
SCENE = str(PULLEYS / "block-on-disc.yaml")
LOADED = "import atexit, sys\natexit.register(lambda: print('typer' in sys.modules))\n"


KEPT = "kept = open(1, 'w', closefd=False)\nkept.write('taken apart')\n"  # what is in its buffer comes out when it goes


def process(entry: str, *arguments: str, main: str = "main", before: str = LOADED) -> subprocess.CompletedProcess[str]:
    """A process that starts at a function of a module."""
    code = f"import sys\n{before}sys.argv[1:] = {list(arguments)!r}\nfrom {entry} import {main}\n{main}()"
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)


@pytest.mark.parametrize(
    "files", [[SCENE], [SCENE, str(PULLEYS / "atwood.yaml")], ["nowhere.yaml"], ["--no-confirm", SCENE]]
)
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


@pytest.mark.parametrize("files", [[SCENE], ["nowhere.yaml"], [SCENE, "nowhere.yaml"], []])
def test_a_process_ends_as_its_command_says(files: list[str]) -> None:
    plain, whole = (
        process("rotsolve.start", "solve", *files),
        process("rotsolve.start", "solve", *files, main="process"),
    )
    assert (plain.returncode, plain.stdout, plain.stderr) == (whole.returncode, whole.stdout, whole.stderr)
    assert whole.stdout.endswith(("False\n", "True\n")), "what was to be done at the end is done"


@pytest.mark.parametrize(
    ("main", "watching", "apart"),
    [
        ("main", "", True),
        ("process", "", False),
        ("process", "sys.settrace(lambda *event: None)\n", True),
        ("process", "sys.setprofile(lambda *event: None)\n", True),
        ("process", "import threading\n", False),
        ("process", "import threading\nthreading.Thread(target=threading.main_thread().join).start()\n", True),
    ],
)
def test_a_process_is_taken_apart_only_where_somebody_counts_on_it(main: str, watching: str, apart: bool) -> None:
    ran = process("rotsolve.start", "solve", SCENE, main=main, before=KEPT + watching)
    assert ran.returncode == 0 and ran.stdout.startswith("Block hanging")
    assert ran.stdout.endswith("taken apart") == apart


def test_an_end_that_fails_is_left_to_python() -> None:
    failing = "import atexit\natexit.register(lambda: sys.stdout.close())\n"
    ran = process("rotsolve.start", "solve", SCENE, main="process", before=failing)
    assert ran.returncode == 0 and ran.stdout.startswith("Block hanging")


LOOKED = """\
import atexit, gc
begun = sum(one["collections"] for one in gc.get_stats())
atexit.register(lambda: print(sum(one["collections"] for one in gc.get_stats()) - begun))
"""


def test_python_does_not_look_for_cycles_while_modules_load() -> None:
    ran = process("rotsolve.start", "solve", SCENE, main="process", before=LOOKED)
    assert ran.returncode == 0
    assert int(ran.stdout.splitlines()[-1]) <= 1, "but for once before the command begins"


BAD = (
    "a: [1",
    "a: *x",
    "a: b: c",
    "\ta: 1",
    "a: 'x",
    "a: {b",
    "- a\nb: 1",
    "&a b: 1",
    "a: !!int 1",
    "? [a]\n: b",
    "%A\n---\n",
    "@a: 1",
)


@pytest.mark.sampled(3)
@pytest.mark.parametrize("text", BAD)
def test_a_process_of_its_own_says_the_same_of_what_is_no_yaml(text: str, tmp_path: Path) -> None:
    scene = tmp_path / "scene.yaml"
    scene.write_text(text + "\n", encoding="utf-8")
    plain, lean = (process("rotsolve.start", "solve", str(scene), main=main, before="") for main in ("main", "process"))
    assert (plain.returncode, plain.stdout, plain.stderr) == (lean.returncode, lean.stdout, lean.stderr)
    assert lean.returncode == 2 and "internal" not in lean.stderr


ASKED = """\
import sys
from rotsolve.lean import CODE_FLAGS, PutOff, leave_out
leave_out()
put_off = {name for name, module in sys.modules.items() if isinstance(module, PutOff)}
assert put_off >= {"datetime", "inspect", "msgspec.json", "platform", "yaml"}
assert not {"yaml.reader", "yaml.loader", "msgspec._json_schema"} & sys.modules.keys()
import datetime, inspect, msgspec, platform, yaml
assert msgspec.convert("2026-12-01", datetime.date) == datetime.date(2026, 12, 1)
assert isinstance(sys.modules["datetime"], PutOff) and datetime.sys is sys
assert sys.modules["datetime"].date is datetime.date
events = list(yaml.parse("a: 1", Loader=yaml.CSafeLoader))
assert [event.value for event in events if isinstance(event, yaml.ScalarEvent)] == ["a", "1"]
assert str(inspect.signature(lambda a, b=1: a)) == "(a, b=1)"
assert CODE_FLAGS == {name: getattr(sys.modules["inspect"], name) for name in CODE_FLAGS}
assert msgspec.json.encode([1]) == b"[1]" and msgspec.json.decode("[1]") == [1]
assert platform.python_version() == ".".join(map(str, sys.version_info[:3]))
assert yaml.safe_load("a: [1, 2]") == {"a": [1, 2]}
asked = {"datetime", "inspect", "msgspec.json", "platform", "yaml"}
assert not [name for name in asked if isinstance(sys.modules[name], PutOff)]
"""


def test_what_is_put_off_comes_when_it_is_asked_for() -> None:
    ran = subprocess.run([sys.executable, "-c", ASKED], capture_output=True, text=True, check=False)
    assert ran.returncode == 0, ran.stderr


def near(folder: Path, name: str = "twin") -> object:
    """The value that a module of ours in a folder has, loaded as a process of our own does it."""
    spec = Near.find_spec(f"rotsolve.{name}", [str(folder)])
    assert spec is not None and isinstance(spec.loader, Near)
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    assert module.__file__ == str(folder / f"{name}.py") and module.__spec__.origin == module.__file__
    return module.value


def test_a_module_of_ours_is_loaded_by_its_bytecode_as_long_as_that_is_as_new_as_its_source(tmp_path: Path) -> None:
    source = tmp_path / "twin.py"
    source.write_text("value = 1\n")
    assert near(tmp_path) == 1, "there may be no bytecode"
    kept = py_compile.compile(str(source))
    assert near(tmp_path) == 1
    time = source.stat()
    source.write_text("value = 2\n")
    os.utime(source, ns=(time.st_atime_ns, time.st_mtime_ns))
    assert near(tmp_path) == 1, "of the same time and size: it is the bytecode that counts"
    source.write_text("value = 12\n")
    assert near(tmp_path) == 12, "of another size"
    py_compile.compile(str(source))
    source.write_text("value = 13\n")
    os.utime(source, ns=(time.st_atime_ns, time.st_mtime_ns + 5 * 10**9))
    assert near(tmp_path) == 13, "of another time"
    Path(kept).write_bytes(b"")
    assert near(tmp_path) == 13, "bytecode that is none"
    unchecked = py_compile.PycInvalidationMode.UNCHECKED_HASH
    py_compile.compile(str(source), invalidation_mode=unchecked)
    assert near(tmp_path) == 13, "bytecode that goes by something else"


def test_only_modules_of_ours_are_looked_for_near_by() -> None:
    folder = [str(Path(rotsolve.__file__).parent)]
    for name in ("rotsolve", "rotsolve.nothing", "yaml.loader"):
        assert Near.find_spec(name, None if name == "rotsolve" else folder) is None
    for name in ("rotsolve.plan", "rotsolve.algebra"):
        mine, plain = Near.find_spec(name, folder), PathFinder.find_spec(name, folder)
        assert mine is not None and plain is not None
        assert (mine.origin, mine.cached, mine.has_location) == (plain.origin, plain.cached, plain.has_location)
        assert mine.submodule_search_locations == plain.submodule_search_locations
        assert isinstance(plain.loader, SourceFileLoader) and isinstance(mine.loader, Near)
        assert mine.loader.get_code(name) == plain.loader.get_code(name)
